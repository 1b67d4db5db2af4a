//! Bouc-Wen bearings.

use super::driver::{SingleElement, difference, path};
use hysteron::element::axes::Orientation;
use hysteron::element::bearing::{BoucWenShear, Link, PlaneBearing, SpaceBearing};
use hysteron::material::{Elastic, ElasticPP, Material};
use nalgebra::{Rotation3, Vector3};

fn shear(eta: f64, beta: f64, gamma: f64, alpha2: f64) -> BoucWenShear {
    let k = 8000.0;
    BoucWenShear { k0: 0.88 * k, qd: 40.0, k2: 0.12 * k, k3: alpha2 * k, mu: 3.0, eta, beta, gamma, compat: false }
}

fn elastic(e: f64) -> (Material, i32) {
    (Material::new(Elastic::new(e)), 1)
}

fn plane(p: BoucWenShear, shear_dist: f64) -> SingleElement {
    let (axes, length) = Orientation::default().of_link(Vector3::zeros(), Vector3::new(0.05, 0.3, 0.0), true).unwrap();
    let moment = (Material::new(ElasticPP::new(6000.0, 1.0, -1.0, 0.0)), 2);
    SingleElement::new(PlaneBearing::new(p, Link::new(&axes, length, shear_dist), [elastic(1e5), moment], 0.0, false))
}

fn space_along(p: BoucWenShear, shear_dist: f64, orientation: Orientation, line: Vector3<f64>) -> SingleElement {
    let (axes, length) = orientation.of_link(Vector3::zeros(), line, false).unwrap();
    let materials = [elastic(1e5), elastic(900.0), elastic(6000.0), elastic(5000.0)];
    SingleElement::new(SpaceBearing::new(p, Link::new(&axes, length, shear_dist), materials, 0.0, false))
}

fn space(p: BoucWenShear) -> SingleElement {
    space_along(p, 0.3, Orientation::default(), Vector3::new(0.02, -0.05, 0.3))
}

fn laws() -> [(&'static str, BoucWenShear); 5] {
    [
        ("eta 1", shear(1.0, 0.5, 0.5, 0.0)),
        ("eta 2", shear(2.0, 0.5, 0.5, 0.0)),
        ("eta 3, hardening", shear(3.0, 0.6, 0.4, 0.02)),
        ("eta 1.5, fat loops", shear(1.5, 0.2, 0.8, 0.0)),
        ("eta 2, thin unloading", shear(2.0, 0.9, 0.1, 0.0)),
    ]
}

/// A pseudo-random motion of all degrees of freedom; axial displacements and rotations are smaller.
fn motion(n: usize, seed: u64, steps: usize) -> Vec<Vec<f64>> {
    let per_node = n / 2;
    let size = |i: usize| match (n, i % per_node) {
        (6, 0) | (12, 0 | 1) => 0.06,
        (_, k) if k + 1 == per_node || (n == 12 && k >= 3) => 0.01,
        _ => 0.002,
    };
    let walks: Vec<Vec<f64>> = (0..n).map(|i| path(seed + i as u64, steps, size(i))).collect();
    (0..steps).map(|k| walks.iter().map(|w| w[k]).collect()).collect()
}

#[test]
fn tangent_matches_finite_difference() {
    for (name, p) in laws() {
        for mut e in [plane(p.clone(), 0.3), space(p.clone())] {
            let n = e.element.dofs();
            let (mut tested, steps) = (0, motion(n, 31, 150));
            for (k, u) in steps.iter().enumerate() {
                let (_, tangent) = e.trial(u, &vec![0.0; n]);
                let (near, far) = (e.difference(u, 1e-8), e.difference(u, 4e-8));
                if difference(&near, &far) < 1e-5 {
                    tested += 1;
                    let error = difference(&tangent, &near);
                    assert!(error < 1e-5, "{name}, {n} degrees of freedom, step {k}: {error:.1e}");
                }
                e.trial(u, &vec![0.0; n]);
                e.commit();
            }
            assert!(tested > 100, "{name}: only {tested} states away from kinks");
        }
    }
}

#[test]
fn initial_tangent_matches_small_motion() {
    for (_, p) in laws() {
        for mut e in [plane(p.clone(), 0.5), space(p.clone())] {
            let n = e.element.dofs();
            let mut k = vec![0.0; n * n];
            e.element.initial_tangent(&mut k);
            assert!(difference(&k, &e.difference(&vec![0.0; n], 1e-9)) < 1e-4);
        }
    }
}

/// An eccentric circular orbit shows that both directions share one strength.
#[test]
fn circular_orbits_show_bidirectional_coupling() {
    let p = shear(2.0, 0.5, 0.5, 0.0);
    let (k2, qd) = (p.k2, p.qd);
    let up = Orientation { x: Some(Vector3::z()), y: Some(Vector3::x()) };
    let mut e = space_along(p, 0.5, up, Vector3::zeros());
    let mut largest: f64 = 0.0;
    for k in 0..800 {
        let angle = f64::from(k) * 0.02;
        let r = 0.1 * (f64::from(k) / 100.0).min(1.0);
        let (x, y) = (r * angle.cos(), r * angle.sin());
        let mut u = [0.0; 12];
        (u[6], u[7]) = (x, y);
        let f = e.force(&u);
        e.commit();
        // Force without the hardening spring.
        largest = largest.max((f[6] - k2 * x).hypot(f[7] - k2 * y));
    }
    assert!(largest < 1.0001 * qd, "the hysteretic force stays within the circle of the strength: {largest}");
    assert!(largest > 0.99 * qd);
}

#[test]
fn closed_cycles_create_no_energy() {
    for (name, p) in laws() {
        let up = Orientation { x: Some(Vector3::z()), y: Some(Vector3::x()) };
        let mut e = space_along(p, 0.5, up, Vector3::zeros());
        let (xs, ys) = (path(41, 3000, 0.1), path(42, 3000, 0.1));
        let (mut last, mut at, mut work, mut lowest) = ([0.0; 2], [0.0; 2], 0.0, 0.0f64);
        for (x, y) in xs.into_iter().zip(ys) {
            let mut u = [0.0; 12];
            (u[6], u[7]) = (x, y);
            let f = e.force(&u);
            e.commit();
            work += 0.5 * ((f[6] + last[0]) * (x - at[0]) + (f[7] + last[1]) * (y - at[1]));
            (last, at) = ([f[6], f[7]], [x, y]);
            lowest = lowest.min(work);
        }
        assert!(lowest > -1e-9 && work > 0.0, "{name}: {lowest} {work}");
    }
}

#[test]
fn rotating_the_bearing_rotates_the_force() {
    let q = Rotation3::from_euler_angles(0.4, 0.9, -1.3).into_inner();
    let p = shear(2.0, 0.5, 0.5, 0.01);
    let line = Vector3::new(0.0, 0.0, 0.3);
    let given = |x: Vector3<f64>, y: Vector3<f64>| Orientation { x: Some(x), y: Some(y) };
    let mut straight = space_along(p.clone(), 0.4, given(Vector3::z(), Vector3::x()), line);
    let mut turned = space_along(p, 0.4, given(q * Vector3::z(), q * Vector3::x()), q * line);
    let turn = |v: &[f64]| -> Vec<f64> {
        v.chunks(3).flat_map(|c| (q * Vector3::from_column_slice(c)).as_slice().to_vec()).collect()
    };
    for (k, u) in motion(12, 77, 150).iter().enumerate() {
        let (a, b) = (turn(&straight.force(u)), turned.force(&turn(u)));
        assert!(difference(&a, &b) < 1e-8, "step {k}");
        straight.commit();
        turned.commit();
    }
}

#[test]
fn mirrored_motion_gives_mirrored_force() {
    for (name, p) in laws() {
        let (mut e, mut m) = (space(p.clone()), space(p));
        // Point symmetry about the origin changes the sign of the axial force, so P-Delta is excluded.
        for u in motion(12, 5, 120) {
            let no_axial: Vec<f64> = u.iter().enumerate().map(|(i, x)| if i % 6 == 2 { 0.0 } else { *x }).collect();
            let back: Vec<f64> = no_axial.iter().map(|x| -x).collect();
            let (f, _) = e.trial(&no_axial, &[0.0; 12]);
            let (g, _) = m.trial(&back, &[0.0; 12]);
            let shear = |f: &[f64]| [f[6], f[7]];
            let (a, b) = (shear(&f), shear(&g));
            assert!((a[0] + b[0]).abs() < 1e-6 * 40.0 && (a[1] + b[1]).abs() < 1e-6 * 40.0, "{name}: {a:?} {b:?}");
            e.commit();
            m.commit();
        }
    }
}

#[test]
fn force_depends_on_the_committed_state_alone() {
    for (name, p) in laws() {
        let (mut e, mut w) = (space(p.clone()), space(p));
        let steps = motion(12, 9, 120);
        for (k, u) in steps.iter().enumerate() {
            w.force(&steps[(k + 40) % 120]);
            w.force(&[0.0; 12]);
            assert_eq!(e.force(u), w.force(u), "{name}, step {k}");
            e.commit();
            w.commit();
        }
    }
}

/// The spatial bearing equals the plane bearing in uniaxial motion.
#[test]
fn space_and_plane_agree_in_one_direction() {
    for (name, p) in laws() {
        let (axes, length) =
            Orientation::default().of_link(Vector3::zeros(), Vector3::new(0.0, 0.3, 0.0), true).unwrap();
        let mut flat = SingleElement::new(PlaneBearing::new(
            p.clone(),
            Link::new(&axes, length, 0.5),
            [elastic(1e5), elastic(6000.0)],
            0.0,
            false,
        ));
        let o = Orientation { x: None, y: Some(Vector3::new(-1.0, 0.0, 0.0)) };
        let mut deep = space_along(p, 0.5, o, Vector3::new(0.0, 0.3, 0.0));
        for x in path(13, 600, 0.1) {
            let f = flat.force(&[0.0, 0.0, 0.0, x, 0.0, 0.0])[3];
            let mut u = [0.0; 12];
            u[6] = x;
            let g = deep.force(&u)[6];
            assert!((f - g).abs() < 1e-7 * 40.0, "{name}: {f} and {g}");
            flat.commit();
            deep.commit();
        }
    }
}
