//! Beams and their geometric transformations.

use super::driver::{SingleElement, difference};
use hysteron::element::beam::{ElasticBeam, ElasticOptions, Release};
use hysteron::element::load::ElementLoad;
use hysteron::element::roles::Inertia;
use hysteron::element::transform::{Ends, TransformKind, TransformSpec};
use hysteron::element::{Element, Mass};
use hysteron::section::ElasticSection;
use nalgebra::{Matrix3, Vector3};

const LINE: (Vector3<f64>, Vector3<f64>) = (Vector3::new(1.0, 2.0, 0.5), Vector3::new(4.0, 3.5, 2.5));

fn spec(kind: TransformKind, offsets: bool) -> TransformSpec {
    let o = if offsets { (Vector3::new(0.2, 0.1, 0.3), Vector3::new(-0.1, 0.2, -0.2)) } else { Default::default() };
    TransformSpec { kind, xz: Vector3::new(0.0, 0.3, 1.0), offsets: o, by_trials: false }
}

/// A section with E A, E I and G A.
fn flat_section(ea: f64, ei: f64, gav: Option<f64>) -> ElasticSection {
    ElasticSection { e: 1.0, area: ea, iz: ei, iy: 0.0, g: 1.0, j: 0.0, shear: (gav, None) }
}

fn space(kind: TransformKind, offsets: bool, shear: bool, release: Release) -> ElasticBeam<12, 6> {
    let ends = Ends { place: LINE, disp: &[0.0; 12] };
    let transform = spec(kind, offsets).space(&ends).unwrap();
    let shear = if shear { (Some(15.0), Some(12.0)) } else { (None, None) };
    let section = ElasticSection { e: 1000.0, area: 5.0, iz: 0.9, iy: 0.4, g: 100.0, j: 3.0, shear };
    let options = ElasticOptions { release: (release, Release::None), rho: 2.0, consistent: false };
    ElasticBeam::new(transform, section, options)
}

fn plane(kind: TransformKind, offsets: bool) -> ElasticBeam<6, 3> {
    let flat = |v: Vector3<f64>| Vector3::new(v.x, v.y, 0.0);
    let ends = Ends { place: (flat(LINE.0), flat(LINE.1)), disp: &[0.0; 6] };
    let mut s = spec(kind, offsets);
    s.offsets = (flat(s.offsets.0), flat(s.offsets.1));
    let options = ElasticOptions { rho: 2.0, ..ElasticOptions::default() };
    ElasticBeam::new(s.plane(&ends).unwrap(), flat_section(5000.0, 900.0, None), options)
}

fn some_motion(n: usize, size: f64) -> Vec<f64> {
    (0..n).map(|i| size * ((i * i + 3 * i + 1) as f64 * 0.7).sin()).collect()
}

#[test]
fn tangent_of_linear_and_corotational_beams() {
    for offsets in [false, true] {
        for (name, mut e, n) in [
            ("linear, space", SingleElement::new(space(TransformKind::Linear, offsets, true, Release::None)), 12),
            ("linear, hinge at i", SingleElement::new(space(TransformKind::Linear, offsets, true, Release::I)), 12),
            ("linear, plane", SingleElement::new(plane(TransformKind::Linear, offsets)), 6),
        ] {
            let u = some_motion(n, 0.1);
            let (_, k) = e.trial(&u, &vec![0.0; n]);
            assert!(difference(&k, &e.difference(&u, 1e-5)) < 1e-7, "{name}");
            let mut initial = vec![0.0; n * n];
            e.element.initial_tangent(&mut initial);
            assert!(difference(&k, &initial) < 1e-12, "{name}");
        }
    }
    let mut e = SingleElement::new(plane(TransformKind::Corotational, false));
    for size in [0.01, 0.3, 1.0] {
        let u = some_motion(6, size);
        let (_, k) = e.trial(&u, &[0.0; 6]);
        assert!(difference(&k, &e.difference(&u, 1e-6)) < 1e-6, "corotational, displacements of {size}");
    }
}

/// The P-Delta tangent omits the change of the axial force; it is exact for a given axial force.
#[test]
fn tangent_of_p_delta_under_a_given_axial_force() {
    let ends = Ends { place: LINE, disp: &[0.0; 12] };
    let t = spec(TransformKind::PDelta, true).space(&ends).unwrap();
    let (q, kb, u) = ([-700.0, 0.0, 0.0, 0.0, 0.0, 0.0], [[0.0; 6]; 6], some_motion(12, 0.2));
    let force = |u: &[f64]| {
        let mut f = vec![0.0; 12];
        t.add_force(u, &[], &q, &[0.0; 5], &mut f);
        f
    };
    let mut k = vec![0.0; 144];
    t.add_tangent(&u, &[], &kb, &q, &mut k);
    for j in 0..12 {
        let (mut up, mut down) = (u.clone(), u.clone());
        (up[j], down[j]) = (u[j] + 1e-4, u[j] - 1e-4);
        for (i, (a, b)) in force(&up).iter().zip(force(&down)).enumerate() {
            let slope = (a - b) / 2e-4;
            assert!((slope - k[12 * i + j]).abs() < 1e-6, "{i} {j}: {slope} and {}", k[12 * i + j]);
        }
    }
}

/// Rigid motions cause no force: small ones for linear beams, large ones for corotational beams.
#[test]
fn rigid_motions_cause_no_force() {
    for offsets in [false, true] {
        let mut e = SingleElement::new(space(TransformKind::Linear, offsets, false, Release::None));
        let turn = Vector3::new(0.01, -0.02, 0.03);
        let mut u = vec![];
        for p in [LINE.0, LINE.1] {
            let shift = Vector3::new(0.3, 0.1, -0.2) + turn.cross(&p);
            u.extend_from_slice(shift.as_slice());
            u.extend_from_slice(turn.as_slice());
        }
        let scale = 5000.0;
        assert!(e.force(&u).iter().all(|f| f.abs() < 1e-10 * scale), "linear, offsets {offsets}");
    }
    let mut e = SingleElement::new(plane(TransformKind::Corotational, false));
    for angle in [0.1f64, 1.0, 2.5] {
        let r = Matrix3::new(angle.cos(), -angle.sin(), 0.0, angle.sin(), angle.cos(), 0.0, 0.0, 0.0, 1.0);
        let mut u = vec![];
        for p in [LINE.0, LINE.1] {
            let flat = Vector3::new(p.x, p.y, 0.0);
            let moved = r * flat - flat;
            u.extend_from_slice(&[moved.x + 0.4, moved.y - 0.2, angle]);
        }
        assert!(e.force(&u).iter().all(|f| f.abs() < 1e-9), "corotational, turned by {angle}");
    }
}

/// End forces and moments are in equilibrium: undeformed for linear beams, deformed for corotational beams.
#[test]
fn ends_are_in_equilibrium() {
    let mut e = SingleElement::new(space(TransformKind::Linear, false, true, Release::None));
    let f = e.force(&some_motion(12, 0.1));
    let part = |k: usize| Vector3::from_column_slice(&f[k..k + 3]);
    let arm = LINE.1 - LINE.0;
    assert!((part(0) + part(6)).norm() < 1e-9);
    assert!((part(3) + part(9) + arm.cross(&part(6))).norm() < 1e-8);

    let mut e = SingleElement::new(plane(TransformKind::Corotational, false));
    let u = some_motion(6, 0.5);
    let f = e.force(&u);
    let (dx, dy) = (LINE.1.x - LINE.0.x + u[3] - u[0], LINE.1.y - LINE.0.y + u[4] - u[1]);
    assert!((f[0] + f[3]).abs() < 1e-9 && (f[1] + f[4]).abs() < 1e-9);
    assert!((f[2] + f[5] + dx * f[4] - dy * f[3]).abs() < 1e-8);
}

/// A beam divided by a free node deflects like the undivided one (Euler-Bernoulli and Timoshenko).
#[test]
fn two_halves_equal_the_whole_beam() {
    let ends = Ends { place: (Vector3::zeros(), Vector3::new(4.0, 0.0, 0.0)), disp: &[0.0; 6] };
    for gav in [None, Some(50.0)] {
        let straight = TransformSpec {
            kind: TransformKind::Linear,
            xz: Vector3::zeros(),
            offsets: Default::default(),
            by_trials: false,
        };
        let whole = ElasticBeam::new(
            straight.plane(&ends).unwrap(),
            flat_section(1000.0, 100.0, gav),
            ElasticOptions::default(),
        );
        let mut k = vec![0.0; 36];
        whole.initial_tangent(&mut k);
        // Tip deflection of the cantilever under a unit load: L³/3EI + L/GA.
        let (kvv, kvr, krr) = (k[4 * 6 + 4], k[4 * 6 + 5], k[5 * 6 + 5]);
        let tip = krr / (kvv * krr - kvr * kvr);
        let exact = 64.0 / 300.0 + gav.map_or(0.0, |g| 4.0 / g);
        assert!((tip - exact).abs() < 1e-12, "{tip} and {exact}");
    }
}

#[test]
fn end_forces_balance_member_loads() {
    let loads = [
        ElementLoad::Distributed { span: (0.0, 1.0), y: (3.0, 3.0), z: (-2.0, -2.0), x: (1.0, 1.0) },
        ElementLoad::Distributed { span: (0.2, 0.7), y: (1.0, 4.0), z: (2.0, 0.0), x: (0.0, 2.0) },
        ElementLoad::Point { at: 0.3, y: 5.0, z: -4.0, x: 2.0 },
    ];
    for release in [Release::None, Release::I, Release::J, Release::Both] {
        for load in &loads {
            let e = space(TransformKind::Linear, false, true, release);
            let length = (LINE.1 - LINE.0).norm();
            let total = match *load {
                ElementLoad::Point { y, z, x, .. } => Vector3::new(x, y, z),
                ElementLoad::Moment { .. } => Vector3::zeros(),
                ElementLoad::Distributed { span, y, z, x } => {
                    let mean = |w: (f64, f64)| 0.5 * (w.0 + w.1) * (span.1 - span.0) * length;
                    Vector3::new(mean(x), mean(y), mean(z))
                }
            };
            let mut alone = SingleElement::new(e);
            let mut words = vec![0.0; alone.load.len()];
            alone.element.add_load(load, 1.5, &mut words).unwrap();
            alone.load = words;
            let f = alone.force(&[0.0; 12]);
            let sum = Vector3::from_column_slice(&f[0..3]) + Vector3::from_column_slice(&f[6..9]);
            assert!((sum.norm() - 1.5 * total.norm()).abs() < 1e-10, "{release:?} {load:?}");
        }
    }
}

/// Fixed-end moments of a uniform load, and of a point load at a third (Roark, table 8.1).
#[test]
fn fixed_end_moments_match_the_handbook() {
    let ends = Ends { place: (Vector3::zeros(), Vector3::new(6.0, 0.0, 0.0)), disp: &[0.0; 6] };
    let straight = TransformSpec {
        kind: TransformKind::Linear,
        xz: Vector3::zeros(),
        offsets: Default::default(),
        by_trials: false,
    };
    let section = flat_section(1000.0, 100.0, None);
    let beam =
        || SingleElement::new(ElasticBeam::new(straight.plane(&ends).unwrap(), section, ElasticOptions::default()));
    for (load, mi, mj) in [
        (ElementLoad::Distributed { span: (0.0, 1.0), y: (-10.0, -10.0), z: (0.0, 0.0), x: (0.0, 0.0) }, 30.0, -30.0),
        (
            ElementLoad::Point { at: 1.0 / 3.0, y: -10.0, z: 0.0, x: 0.0 },
            10.0 * 2.0 * 16.0 / 36.0,
            -10.0 * 4.0 * 4.0 / 36.0,
        ),
    ] {
        let mut e = beam();
        let mut words = vec![0.0; e.load.len()];
        e.element.add_load(&load, 1.0, &mut words).unwrap();
        e.load = words;
        let f = e.force(&[0.0; 6]);
        assert!((f[2] - mi).abs() < 1e-10 && (f[5] - mj).abs() < 1e-10, "{f:?}");
    }
}

#[test]
fn masses_add_up() {
    for consistent in [false, true] {
        let ends = Ends { place: LINE, disp: &[0.0; 12] };
        let transform = spec(TransformKind::Linear, false).space(&ends).unwrap();
        let section = ElasticSection { e: 1.0, area: 1.0, iz: 1.0, iy: 1.0, g: 1.0, j: 0.3, shear: (None, None) };
        let options = ElasticOptions { rho: 2.0, consistent, ..ElasticOptions::default() };
        let e = ElasticBeam::new(transform, section, options);
        let total = 2.0 * (LINE.1 - LINE.0).norm();
        for direction in 0..3 {
            let mut r = [0.0; 12];
            (r[direction], r[direction + 6]) = (1.0, 1.0);
            let moved: f64 = match e.mass() {
                Mass::Lumped(m) => m.iter().zip(&r).map(|(m, r)| m * r).sum(),
                Mass::Consistent(m) => {
                    m.chunks(12).zip(&r).map(|(row, ri)| ri * row.iter().zip(&r).map(|(m, r)| m * r).sum::<f64>()).sum()
                }
                Mass::None => 0.0,
            };
            assert!((moved - total).abs() < 1e-12 * total, "{consistent:?} {direction}: {moved} and {total}");
        }
    }
}
