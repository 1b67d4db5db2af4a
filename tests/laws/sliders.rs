//! Friction models and sliding bearings.

use super::driver::{SingleElement, difference, path};
use hysteron::element::axes::Orientation;
use hysteron::element::bearing::Link;
use hysteron::element::bearing::sliding::{
    Dish, Kind, PlaneSlider, Setting, SlidingBearing, SpaceSlider, Substitution, Surface,
};
use hysteron::element::friction::{
    Coulomb, Friction, VelDepMultiLinear, VelDependent, VelNormalFrcDep, VelPressureDep,
};
use hysteron::element::{ElementInput, ElementOutput, Histories};
use hysteron::material::{Elastic, Material, NoTension};
use hysteron::rules::Consistent;
use nalgebra::{Rotation3, Vector3};
use std::sync::Arc;

const K_INIT: f64 = 20_000.0;
const RADIUS: f64 = 2.0;
const AXIAL: f64 = 1e6;

fn frictions() -> [Friction; 5] {
    [
        Arc::new(Coulomb { mu: 0.06 }),
        Arc::new(VelDependent { slow: 0.03, fast: 0.09, rate: 25.0 }),
        Arc::new(VelPressureDep { slow: 0.03, fast: 0.1, area: 0.05, delta: 0.04, alpha: 4e-5, rate: 20.0 }),
        Arc::new(VelDepMultiLinear::new(vec![[0.0, 0.03], [0.1, 0.06], [0.4, 0.08], [1.0, 0.09]]).unwrap()),
        Arc::new(VelNormalFrcDep {
            a_slow: 0.08,
            n_slow: 0.9,
            a_fast: 0.16,
            n_fast: 0.92,
            alpha: [10.0, 5e-3, 1e-6],
            max_factor: 3.0,
        }),
    ]
}

#[test]
fn friction_derivatives_match_finite_differences() {
    for law in frictions() {
        for (n, v) in [(300.0, 0.02), (900.0, 0.15), (4000.0, 0.7), (50.0, 3.0)] {
            let (c, h) = (law.coefficient(n, v), 1e-5);
            let mu = |n, v| law.coefficient(n, v).mu;
            let by_n = (mu(n * (1.0 + h), v) - mu(n * (1.0 - h), v)) / (2.0 * h * n);
            let by_v = (mu(n, v * (1.0 + h)) - mu(n, v * (1.0 - h))) / (2.0 * h * v);
            assert!((c.by_normal - by_n).abs() < 1e-7 * c.mu / n + 1e-6 * by_n.abs(), "{law:?}: {c:?}, {by_n}");
            assert!((c.by_speed - by_v).abs() < 1e-7 * c.mu / v + 1e-6 * by_v.abs(), "{law:?}: {c:?}, {by_v}");
            assert!(c.mu > 0.0 && c.mu < 0.2);
        }
    }
}

/// A coefficient by points is extrapolated linearly, but not below 0.
#[test]
fn friction_by_points_stays_positive() {
    let law = VelDepMultiLinear::new(vec![[0.1, 0.05], [0.2, 0.04]]).unwrap();
    let mu = |v: f64| hysteron::element::friction::FrictionLaw::coefficient(&law, 1.0, v).mu;
    assert!((mu(0.0) - 0.06).abs() < 1e-15 && (mu(0.3) - 0.03).abs() < 1e-15 && mu(2.0) == 0.0);
    assert!(VelDepMultiLinear::new(vec![[0.0, 0.1]]).is_none());
    assert!(VelDepMultiLinear::new(vec![[0.1, 0.1], [0.1, 0.2]]).is_none());
}

fn elastic(e: f64) -> (Material, i32) {
    (Material::new(Elastic::new(e)), 1)
}

fn no_tension() -> (Material, i32) {
    (Material::new(NoTension { e: AXIAL, a: 0.0, b: 1.0 }), 1)
}

fn setting(kind: Kind) -> Setting {
    Setting { kind, mass: 0.0, rayleigh: false, uplift: 1e-6, rules: Consistent }
}

fn surface(kind: Kind, friction: &Friction, rises: bool) -> Surface {
    let dish = (kind == Kind::Pendulum).then_some(Dish { radius: RADIUS, rises });
    Surface { friction: friction.clone(), k_init: K_INIT, dish }
}

fn space_along(
    kind: Kind,
    friction: &Friction,
    shear_dist: f64,
    orientation: Orientation,
    line: Vector3<f64>,
    compat: Option<Substitution>,
) -> SingleElement {
    let (axes, length) = orientation.of_link(Vector3::zeros(), line, false).unwrap();
    let mut materials = vec![no_tension()];
    if kind == Kind::Springs {
        materials.extend([elastic(300.0), elastic(200.0)]);
    }
    materials.extend([elastic(900.0), elastic(600.0), elastic(500.0)]);
    let link: (Link<12, 6>, f64, f64) = (Link::new(&axes, length, shear_dist), length, shear_dist);
    let surface = surface(kind, friction, true);
    match compat {
        None => SingleElement::new(SpaceSlider::new(surface, link, materials, setting(kind))),
        Some(way) => SingleElement::new(SpaceSlider::new(surface, link, materials, setting(kind).with(way))),
    }
}

const UP: Orientation = Orientation { x: Some(Vector3::new(0.0, 0.0, 1.0)), y: Some(Vector3::new(1.0, 0.0, 0.0)) };

/// A bearing of zero length along the global axes: x and y shear, z axial.
fn upright(kind: Kind, friction: &Friction) -> SingleElement {
    space_along(kind, friction, 0.0, UP, Vector3::zeros(), None)
}

fn space(kind: Kind, friction: &Friction) -> SingleElement {
    space_along(kind, friction, 0.3, Orientation::default(), Vector3::new(0.02, -0.05, 0.3), None)
}

fn plane(kind: Kind, friction: &Friction) -> SingleElement {
    let (axes, length) = Orientation::default().of_link(Vector3::zeros(), Vector3::new(0.05, 0.3, 0.0), true).unwrap();
    let mut materials = vec![no_tension()];
    if kind == Kind::Springs {
        materials.push(elastic(300.0));
    }
    materials.push(elastic(600.0));
    let link: (Link<6, 3>, f64, f64) = (Link::new(&axes, length, 0.3), length, 0.3);
    let made: PlaneSlider = SlidingBearing::new(surface(kind, friction, true), link, materials, setting(kind));
    SingleElement::new(made)
}

/// A pseudo-random motion under varying pressure with uplift.
fn motion(n: usize, seed: u64, steps: usize) -> Vec<Vec<f64>> {
    let per_node = n / 2;
    let up = if n == 6 { 1 } else { 2 };
    let size = |i: usize| match i % per_node {
        k if k == up => 5e-4,
        k if k < up => 0.1,
        _ => 0.01,
    };
    let walks: Vec<Vec<f64>> = (0..n).map(|i| path(seed + i as u64, steps, size(i))).collect();
    (0..steps)
        .map(|k| {
            let mut u: Vec<f64> = walks.iter().map(|w| w[k]).collect();
            u[per_node + up] -= 9e-4;
            u
        })
        .collect()
}

/// Force, tangent and damping matrix at a displacement and velocity.
fn response(e: &SingleElement, disp: &[f64], vel: &[f64]) -> (Vec<f64>, Vec<f64>, Vec<f64>) {
    let n = disp.len();
    let (mut f, mut k, mut c, mut next) = (vec![0.0; n], vec![0.0; n * n], vec![0.0; n * n], e.state.clone());
    let response = ElementOutput {
        force: &mut f,
        tangent: Some(&mut k),
        damping: Some(&mut c),
        part: hysteron::element::MatrixMask::ALL,
    };
    e.element
        .respond(
            &ElementInput {
                disp,
                vel,
                accel: &[],
                load: &[],
                still: false,
                opensees: None,
                dt: 0.01,
                time: 0.01,
                dynamic: true,
            },
            &mut Histories { committed: &e.state, trial: &mut next },
            response,
        )
        .unwrap();
    (f, k, c)
}

/// Central differences of the force with respect to displacements or velocities.
fn slopes(e: &SingleElement, disp: &[f64], vel: &[f64], by_vel: bool, h: f64) -> Vec<f64> {
    let n = disp.len();
    let mut out = vec![0.0; n * n];
    for j in 0..n {
        let at = |step: f64| {
            let (mut u, mut v) = (disp.to_vec(), vel.to_vec());
            if by_vel {
                v[j] += step
            } else {
                u[j] += step
            }
            response(e, &u, &v).0
        };
        for (i, (up, down)) in at(h).iter().zip(at(-h)).enumerate() {
            out[i * n + j] = (up - down) / (2.0 * h);
        }
    }
    out
}

const KINDS: [Kind; 3] = [Kind::Flat, Kind::Pendulum, Kind::Springs];

#[test]
fn tangents_match_finite_differences() {
    for kind in KINDS {
        for friction in frictions() {
            for mut e in [plane(kind, &friction), space(kind, &friction)] {
                let n = e.element.dofs();
                let steps = motion(n, 31, 120);
                let (mut tested, mut lifted, mut last) = (0, 0, steps[0].clone());
                for (k, u) in steps.iter().enumerate() {
                    let vel: Vec<f64> = u.iter().zip(&last).map(|(u, l)| (u - l) / 0.01).collect();
                    let (f, tangent, damping) = response(&e, u, &vel);
                    let (near, far) = (slopes(&e, u, &vel, false, 1e-8), slopes(&e, u, &vel, false, 4e-8));
                    let lifts = f.iter().all(|f| f.abs() < 100.0);
                    lifted += usize::from(lifts);
                    if difference(&near, &far) < 1e-5 && !lifts {
                        tested += 1;
                        let error = difference(&tangent, &near);
                        assert!(error < 1e-5, "{kind:?} {friction:?}, {n} degrees of freedom, step {k}: {error:.1e}");
                        let rates = slopes(&e, u, &vel, true, 1e-6);
                        let scale = damping.iter().fold(1.0f64, |m, x| m.max(x.abs()));
                        let error = damping.iter().zip(&rates).fold(0.0f64, |m, (a, b)| m.max((a - b).abs())) / scale;
                        assert!(error < 1e-4, "{kind:?} {friction:?}, {n}, step {k}: damping {error:.1e}");
                    }
                    e.trial(u, &vel);
                    e.commit();
                    last.clone_from(u);
                }
                assert!(tested > 60 && lifted > 2, "{kind:?} {friction:?}: {tested} states, {lifted} lifted");
            }
        }
    }
}

#[test]
fn friction_force_stays_below_its_limit() {
    for friction in frictions() {
        let mut e = upright(Kind::Flat, &friction);
        let mut reached = 0.0f64;
        let (xs, ys, zs) = (path(3, 500, 0.1), path(4, 500, 0.1), path(5, 500, 5e-4));
        for ((x, y), z) in xs.into_iter().zip(ys).zip(zs) {
            let mut u = [0.0; 12];
            (u[6], u[7], u[8]) = (x, y, z - 4e-4);
            let mut v = [0.0; 12];
            v[6] = 0.3;
            let (f, _) = e.trial(&u, &v);
            let n = -f[8];
            let limit = if n > 0.0 { friction.coefficient(n, 0.3).mu * n } else { 0.0 };
            let shear = f[6].hypot(f[7]);
            assert!(shear <= limit * (1.0 + 1e-12) && n >= 0.0, "{friction:?}: {shear} over {limit}");
            reached = reached.max(shear / limit.max(1e-9));
            e.commit();
        }
        assert!(reached > 0.999_999, "{friction:?} slides");
    }
}

/// A pendulum with very small friction has the stiffness N/R.
#[test]
fn pendulum_stiffness_is_the_weight_over_the_radius() {
    let friction: Friction = Arc::new(Coulomb { mu: 1e-9 });
    let mut e = space_along(Kind::Pendulum, &friction, 0.0, UP, Vector3::zeros(), None);
    for x in path(21, 60, 0.004) {
        let mut u = [0.0; 12];
        // The slider rises with its displacement at constant pressure.
        u[6] = x;
        u[8] = RADIUS - (RADIUS * RADIUS - x * x).sqrt() - 9e-4;
        let f = e.force(&u);
        assert!((f[8] + 900.0).abs() < 1e-6);
        assert!((f[6] - 900.0 / RADIUS * x).abs() < 2e-5 * 900.0 / RADIUS * x.abs() + 1e-5, "{} at {x}", f[6]);
        e.commit();
    }
}

/// A flat surface returns no energy, and a pendulum at most the work done on it.
#[test]
fn closed_cycles_create_no_energy() {
    for kind in KINDS {
        for friction in frictions() {
            let mut e = upright(kind, &friction);
            let (xs, ys) = (path(41, 3000, 0.15), path(42, 3000, 0.15));
            let (mut last, mut at, mut work, mut lowest) = ([0.0; 2], [0.0; 2], 0.0, 0.0f64);
            for (x, y) in xs.into_iter().zip(ys) {
                let rise = if kind == Kind::Pendulum { RADIUS - (RADIUS * RADIUS - x * x - y * y).sqrt() } else { 0.0 };
                let mut u = [0.0; 12];
                (u[6], u[7], u[8]) = (x, y, rise - 9e-4);
                let f = e.force(&u);
                e.commit();
                work += 0.5 * ((f[6] + last[0]) * (x - at[0]) + (f[7] + last[1]) * (y - at[1]));
                (last, at) = ([f[6], f[7]], [x, y]);
                lowest = lowest.min(work);
            }
            assert!(lowest > -1e-2 && work > 10.0, "{kind:?} {friction:?}: {lowest} {work}");
        }
    }
}

#[test]
fn lifted_bearing_has_no_force_and_restarts_sliding() {
    for kind in [Kind::Flat, Kind::Pendulum] {
        let mut e = upright(kind, &frictions()[0]);
        let advance = |e: &mut SingleElement, x: f64, z: f64| {
            let mut u = [0.0; 12];
            (u[6], u[8], u[10]) = (x, z, 0.01);
            let f = e.force(&u);
            e.commit();
            f
        };
        assert!(advance(&mut e, 0.1, -9e-4)[6] > 50.0);
        assert_eq!(advance(&mut e, 0.1, 0.01), vec![0.0; 12]);
        assert_eq!(advance(&mut e, -0.1, 0.02), vec![0.0; 12]);
        // The bearing lands at its present position, and sliding begins anew.
        let landed = advance(&mut e, 0.001, 0.01);
        assert_eq!(landed, vec![0.0; 12]);
        let f = advance(&mut e, 0.001, -9e-4);
        assert!(f[6].abs() < 1.0 && f[8] < -800.0, "{kind:?}: {f:?}");
    }
}

/// On a circular orbit the friction force rotates with the velocity at constant magnitude.
#[test]
fn circular_orbits_show_bidirectional_coupling() {
    let mut e = upright(Kind::Flat, &frictions()[0]);
    let (r, n) = (0.1, 900.0);
    for k in 0..600 {
        let angle = f64::from(k) * 0.02;
        let mut u = [0.0; 12];
        (u[6], u[7], u[8]) = (r * angle.cos() - r, r * angle.sin(), -n / AXIAL);
        let f = e.force(&u);
        e.commit();
        if k > 100 {
            let size = f[6].hypot(f[7]);
            assert!((size - 0.06 * n).abs() < 1e-6 * n, "{size}");
            let along = (-f[6] * angle.sin() + f[7] * angle.cos()) / size;
            assert!(along > 0.98, "against the motion: {along}");
        }
    }
}

#[test]
fn rotating_the_bearing_rotates_the_force() {
    let q = Rotation3::from_euler_angles(0.4, 0.9, -1.3).into_inner();
    let line = Vector3::new(0.0, 0.0, 0.3);
    let given = |x: Vector3<f64>, y: Vector3<f64>| Orientation { x: Some(x), y: Some(y) };
    let turn = |v: &[f64]| -> Vec<f64> {
        v.chunks(3).flat_map(|c| (q * Vector3::from_column_slice(c)).as_slice().to_vec()).collect()
    };
    for kind in KINDS {
        let f = &frictions()[1];
        let mut straight = space_along(kind, f, 0.4, given(Vector3::z(), Vector3::x()), line, None);
        let mut turned = space_along(kind, f, 0.4, given(q * Vector3::z(), q * Vector3::x()), q * line, None);
        for (k, u) in motion(12, 77, 150).iter().enumerate() {
            let vel: Vec<f64> = u.iter().map(|u| 3.0 * u).collect();
            let (a, b) = (turn(&straight.trial(u, &vel).0), turned.trial(&turn(u), &turn(&vel)).0);
            assert!(difference(&a, &b) < 1e-8, "{kind:?}, step {k}");
            straight.commit();
            turned.commit();
        }
    }
}

#[test]
fn mirrored_motion_gives_mirrored_force() {
    for kind in KINDS {
        for friction in frictions() {
            let (mut e, mut m) = (upright(kind, &friction), upright(kind, &friction));
            for u in motion(12, 5, 120) {
                // A rotation by π about the bearing axis: x, y and the rotations about them change sign.
                let back: Vec<f64> = u.iter().enumerate().map(|(i, x)| if i % 3 == 2 { *x } else { -x }).collect();
                let (f, g) = (e.force(&u), m.force(&back));
                let back: Vec<f64> = g.iter().enumerate().map(|(i, x)| if i % 3 == 2 { *x } else { -x }).collect();
                assert!(difference(&f, &back) < 1e-12, "{kind:?} {friction:?}");
                e.commit();
                m.commit();
            }
        }
    }
}

#[test]
fn force_depends_on_the_committed_state_alone() {
    for kind in KINDS {
        let (mut e, mut w) = (space(kind, &frictions()[1]), space(kind, &frictions()[1]));
        let steps = motion(12, 9, 120);
        for (k, u) in steps.iter().enumerate() {
            w.force(&steps[(k + 40) % 120]);
            w.force(&[0.0; 12]);
            assert_eq!(e.force(u), w.force(u), "{kind:?}, step {k}");
            e.commit();
            w.commit();
        }
    }
}

/// OpenSees' fixed-point iteration gives the same force in every step from the same state.
#[test]
fn substitution_and_newton_agree() {
    let way = Substitution { rounds: 60, tolerance: 1e-12 };
    for kind in KINDS {
        let friction = &frictions()[1];
        let mut e = space_along(kind, friction, 0.3, UP, Vector3::new(0.0, 0.0, 0.3), None);
        let mut o = space_along(kind, friction, 0.3, UP, Vector3::new(0.0, 0.0, 0.3), Some(way));
        for (k, u) in motion(12, 15, 150).iter().enumerate() {
            let vel: Vec<f64> = u.iter().map(|u| 2.0 * u).collect();
            let (f, g) = (e.trial(u, &vel).0, o.trial(u, &vel).0);
            assert!(difference(&f, &g) < 1e-9, "{kind:?}, step {k}: {f:?} {g:?}");
            e.commit();
            o.commit();
        }
    }
}

/// The spatial bearing equals the plane bearing in uniaxial motion.
#[test]
fn space_and_plane_agree_in_one_direction() {
    for kind in KINDS {
        let friction = &frictions()[1];
        let (axes, length) =
            Orientation::default().of_link(Vector3::zeros(), Vector3::new(0.0, 0.3, 0.0), true).unwrap();
        let mut materials = vec![no_tension()];
        if kind == Kind::Springs {
            materials.push(elastic(300.0));
        }
        materials.push(elastic(500.0));
        let link: (Link<6, 3>, f64, f64) = (Link::new(&axes, length, 0.3), length, 0.3);
        let set = setting(kind);
        let mut flat: SingleElement =
            SingleElement::new(PlaneSlider::new(surface(kind, friction, true), link, materials, set));
        let o = Orientation { x: None, y: Some(Vector3::new(-1.0, 0.0, 0.0)) };
        let mut deep = space_along(kind, friction, 0.3, o, Vector3::new(0.0, 0.3, 0.0), None);
        for x in path(13, 300, 0.1) {
            let v = 2.0 * x;
            let f = flat.trial(&[0.0, 0.0, 0.002, x, -9e-4, 0.001], &[0.0, 0.0, 0.0, v, 0.0, 0.0]).0;
            let (mut u, mut w) = ([0.0; 12], [0.0; 12]);
            (u[5], u[6], u[7], u[11], w[6]) = (0.002, x, -9e-4, 0.001, v);
            let g = deep.trial(&u, &w).0;
            for (a, b) in [(3, 6), (4, 7), (2, 5), (5, 11)] {
                assert!((f[a] - g[b]).abs() < 1e-7, "{kind:?}: {f:?} and {g:?}");
            }
            flat.commit();
            deep.commit();
        }
    }
}
