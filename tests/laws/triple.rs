//! Triple friction pendulum, and fibre-reinforced bearing with rollover.

use super::driver::{SingleElement, difference, path};
use hysteron::element::axes::Orientation;
use hysteron::element::bearing::triple::{Chain, Increments, Segment, TriplePendulum, TripleSetting};
use hysteron::element::bearing::{Link, PlaneBearing, UfrpShear};
use hysteron::element::friction::{Coulomb, Friction, VelDependent};
use hysteron::element::{ElementInput, ElementOutput, Histories};
use hysteron::material::{Elastic, Material};
use hysteron::rules::Consistent;
use nalgebra::Vector3;
use std::sync::Arc;

const WEIGHT: f64 = 900.0;
const K: f64 = 1e6;
const DT: f64 = 0.01;

fn elastic(e: f64) -> (Material, i32) {
    (Material::new(Elastic::new(e)), 1)
}

fn coulomb() -> [Friction; 3] {
    [0.02, 0.06, 0.1].map(|mu| Arc::new(Coulomb { mu }) as Friction)
}

fn fast() -> [Friction; 3] {
    [0.01, 0.03, 0.05].map(|slow| Arc::new(VelDependent { slow, fast: 2.0 * slow, rate: 20.0 }) as Friction)
}

fn bearing(frictions: [Friction; 3], height: f64, compat: Option<f64>) -> SingleElement {
    let (l1, l2, d1, d2) = (0.36, 1.25, 0.1, 0.2);
    let e = 3.0 * frictions[0].coefficient(WEIGHT, 0.0).mu / 0.001;
    let segment = |stiffness: f64, gap: f64, speed: f64| Segment { e, h: e * stiffness / (e - stiffness), gap, speed };
    let outer = segment(1.0 / (l2 - l1), d2 * (1.0 - l1 / l2), l2 / (l2 - l1));
    let chain = Chain { segments: [segment(0.5 / l1, 2.0 * (l1 / l2 * d2 + d1), 0.5), outer, outer] };
    let materials = [elastic(K), elastic(10.0), elastic(20.0), elastic(30.0)];
    let setting = TripleSetting { weight: WEIGHT, k_tension: 10.0, least_normal: 0.1, height, rules: Consistent };
    match compat {
        None => SingleElement::new(TriplePendulum::new(chain, frictions, materials, setting)),
        Some(tolerance) => {
            SingleElement::new(TriplePendulum::new(chain, frictions, materials, setting.with(Increments(tolerance))))
        }
    }
}

/// Horizontal motion up to the displacement limit and beyond, under varying pressure with uplift.
fn motion(seed: u64, steps: usize) -> Vec<Vec<f64>> {
    let size = |i: usize| [0.6, 0.6, 5e-4, 0.01, 0.01, 0.01][i % 6];
    let walks: Vec<Vec<f64>> = (0..12).map(|i| path(seed + i as u64, steps, 0.5 * size(i))).collect();
    (0..steps)
        .map(|k| {
            let mut u: Vec<f64> = walks.iter().map(|w| w[k]).collect();
            u[8] -= 4e-4;
            u
        })
        .collect()
}

fn shear(e: &mut SingleElement, x: f64, y: f64) -> [f64; 2] {
    let mut u = [0.0; 12];
    (u[6], u[7], u[8]) = (x, y, -WEIGHT / K);
    let f = e.force(&u);
    e.commit();
    [f[6], f[7]]
}

#[test]
fn tangent_matches_finite_difference() {
    for frictions in [coulomb(), fast()] {
        let mut e = bearing(frictions, 0.3, None);
        let (mut tested, mut lifted) = (0, 0);
        for (k, u) in motion(31, 200).iter().enumerate() {
            let (f, tangent) = e.trial(u, &[0.0; 12]);
            let (near, far) = (e.difference(u, 1e-8), e.difference(u, 4e-8));
            lifted += usize::from(f[8] >= 0.0);
            if difference(&near, &far) < 1e-5 {
                tested += 1;
                let error = difference(&tangent, &near);
                assert!(error < 1e-5, "step {k}: {error:.1e}");
                // The shear stiffness is small relative to the vertical stiffness.
                let horizontal = |k: &[f64]| [k[78], k[79], k[80], k[90], k[91], k[92], k[126], k[127]];
                let error = difference(&horizontal(&tangent), &horizontal(&near));
                assert!(error < 1e-3, "step {k}: {error:.1e}, shear");
            }
            e.trial(u, &[0.0; 12]);
            e.commit();
        }
        assert!(tested > 150 && lifted > 2, "{tested} states, {lifted} lifted");
    }
}

/// Sliding regimes: the force at which each surface begins to slide, and the stiffness between (Fenz and
/// Constantinou, 2008).
#[test]
fn backbone_matches_theoretical_sliding_regimes() {
    let mut e = bearing(coulomb(), 0.0, None);
    let at = |e: &mut SingleElement, x: f64| shear(e, x, 0.0)[0] / WEIGHT;
    // Inner surfaces slide at 0.02, the lower and upper outer at 0.06 and 0.10: displacements at the transitions.
    let (inner, outer) = (2.0 * 0.36, 1.25 + 0.36);
    let (x1, x2) = ((0.06 - 0.02) * inner, (0.06 - 0.02) * inner + (0.10 - 0.06) * outer);
    let mut last = (0.0, 0.0);
    for k in 1..=400 {
        let x = 0.001 * f64::from(k);
        let f = at(&mut e, x);
        let slope = (f - last.1) / (x - last.0);
        // Checked away from the transitions, which the stiffness before sliding rounds.
        let near = |stiffness: f64| (slope * stiffness - 1.0).abs() < 0.05;
        if x > 0.006 && x < x1 - 0.005 {
            assert!(near(inner), "inner: {slope} at {x}");
        } else if x > x1 + 0.008 && x < x2 - 0.008 {
            assert!(near(outer), "one outer: {slope} at {x}");
        } else if x > x2 + 0.01 && x < 0.25 {
            assert!(near(2.0 * 1.25), "both outer: {slope} at {x}");
        }
        last = (x, f);
    }
    assert!(last.1 > 0.2, "the edge holds: {}", last.1);
}

#[test]
fn closed_cycles_create_no_energy() {
    for frictions in [coulomb(), fast()] {
        let mut e = bearing(frictions, 0.0, None);
        let (xs, ys) = (path(41, 3000, 0.3), path(42, 3000, 0.3));
        let (mut last, mut at, mut work, mut lowest) = ([0.0; 2], [0.0; 2], 0.0, 0.0f64);
        for (x, y) in xs.into_iter().zip(ys) {
            let f = shear(&mut e, x, y);
            work += 0.5 * ((f[0] + last[0]) * (x - at[0]) + (f[1] + last[1]) * (y - at[1]));
            (last, at) = (f, [x, y]);
            lowest = lowest.min(work);
        }
        assert!(lowest > -1e-3 && work > 100.0, "{lowest} {work}");
    }
}

/// The shear law is isotropic: a rotated motion gives a rotated shear.
#[test]
fn rotating_the_motion_rotates_the_shear() {
    let (mut straight, mut turned) = (bearing(fast(), 0.0, None), bearing(fast(), 0.0, None));
    let (s, c) = 0.7f64.sin_cos();
    for (x, y) in path(3, 200, 0.3).into_iter().zip(path(4, 200, 0.3)) {
        let [a, b] = shear(&mut straight, x, y);
        let [p, q] = shear(&mut turned, c * x - s * y, s * x + c * y);
        assert!((c * a - s * b - p).abs() < 1e-8 && (s * a + c * b - q).abs() < 1e-8);
    }
}

#[test]
fn force_depends_on_the_committed_state_alone() {
    let (mut e, mut w) = (bearing(fast(), 0.3, None), bearing(fast(), 0.3, None));
    let steps = motion(9, 120);
    for (k, u) in steps.iter().enumerate() {
        w.force(&steps[(k + 40) % 120]);
        assert_eq!(e.force(u), w.force(u), "step {k}");
        e.commit();
        w.commit();
    }
}

/// OpenSees' increments give the shear of Newton's steps, and the nodes are in equilibrium.
#[test]
fn increments_and_newton_agree() {
    let (mut e, mut o) = (bearing(coulomb(), 0.3, None), bearing(coulomb(), 0.3, Some(1e-6)));
    // OpenSees' friction reaches its value within the first step. In one direction the number of increments has no
    // effect.
    for (k, x) in [1e-8].into_iter().chain(path(5, 300, 0.3)).enumerate() {
        let ([a, _], [p, _]) = (shear(&mut e, x, 0.0), shear(&mut o, x, 0.0));
        assert!((a - p).abs() < 1e-2, "step {k}: {a}, {p}");
    }
    let u = motion(9, 3).pop().unwrap();
    let f = e.force(&u);
    let d: Vec<f64> = (0..3).map(|i| u[6 + i] - u[i]).collect();
    assert!((f[3] + f[9] + d[1] * f[8] - 0.3 * f[7]).abs() < 1e-9, "moments about x");
    assert!((f[4] + f[10] + 0.3 * f[6] - d[0] * f[8]).abs() < 1e-9, "moments about y");
    assert!((f[5] + f[11] + d[0] * f[7] - d[1] * f[6]).abs() < 1e-9, "moments about z");
}

fn rolling(c: f64) -> SingleElement {
    let law =
        UfrpShear { uy: 0.005, a: [400.0, -600.0, 900.0, 50.0, 20.0], b: 8.0, c, eta: 1.5, beta: 0.3, gamma: 0.2 };
    let (axes, length) = Orientation::default().of_link(Vector3::zeros(), Vector3::new(0.05, 0.3, 0.0), true).unwrap();
    SingleElement::new(PlaneBearing::new(
        law,
        Link::new(&axes, length, 0.4),
        [elastic(1e5), elastic(600.0)],
        0.0,
        false,
    ))
}

#[test]
fn rolling_bearing_has_consistent_tangents() {
    let mut e = rolling(3.0);
    let walks: Vec<Vec<f64>> = (0..6).map(|i| path(60 + i, 150, 0.05)).collect();
    let mut tested = 0;
    for k in 0..150 {
        let u: Vec<f64> = walks.iter().map(|w| w[k]).collect();
        let (_, tangent) = e.trial(&u, &[0.0; 6]);
        let (near, far) = (e.difference(&u, 1e-8), e.difference(&u, 4e-8));
        if difference(&near, &far) < 1e-5 {
            tested += 1;
            assert!(difference(&tangent, &near) < 1e-5, "step {k}");
        }
        e.trial(&u, &[0.0; 6]);
        e.commit();
    }
    assert!(tested > 100);
    // The dashpot: force and damping matrix.
    let (mut f, mut c, mut next) = ([0.0; 6], [0.0; 36], e.state.clone());
    let vel = [0.0, 0.0, 0.0, 0.7, 0.2, 0.1];
    let at_rest = e.force(&[0.01; 6]);
    let response =
        ElementOutput { force: &mut f, tangent: None, damping: Some(&mut c), part: hysteron::element::MatrixMask::ALL };
    e.element
        .respond(
            &ElementInput {
                disp: &[0.01; 6],
                vel: &vel,
                accel: &[],
                load: &[],
                still: false,
                opensees: None,
                dt: DT,
                time: 1.0,
                dynamic: true,
            },
            &mut Histories { committed: &e.state, trial: &mut next },
            response,
        )
        .unwrap();
    for i in 0..6 {
        let damped: f64 = (0..6).map(|j| c[6 * i + j] * vel[j]).sum();
        assert!((f[i] - at_rest[i] - damped).abs() < 1e-9);
    }
}

/// The hysteretic parameter stays below its bound, and cycles lose energy.
#[test]
fn rolling_bearing_dissipates() {
    let mut e = rolling(0.0);
    let (mut last, mut at, mut work) = (0.0, 0.0, 0.0);
    for k in 0..=800 {
        let x = 0.06 * (f64::from(k) * std::f64::consts::TAU / 200.0).sin();
        let f = e.force(&[0.0, 0.0, 0.0, -x, 0.0, 0.0])[3];
        e.commit();
        work += 0.5 * (f + last) * (-x - at);
        (last, at) = (f, -x);
        assert!(e.state[1].abs() <= 0.5f64.powf(-1.0 / 1.5) + 1e-12);
    }
    assert!(work > 0.5, "{work}");
}
