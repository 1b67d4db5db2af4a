//! Corotational elements: spatial beams and bars.

use super::driver::{SingleElement, difference};
use hysteron::element::beam::{ElasticBeam, ElasticOptions};
use hysteron::element::transform::{Ends, TransformKind, TransformSpec};
use hysteron::element::{BarOptions, CorotTruss, Histories, Mass};
use hysteron::material::Elastic;
use hysteron::material::Material;
use hysteron::section::ElasticSection;
use nalgebra::{Rotation3, Unit, Vector3};

const LINE: (Vector3<f64>, Vector3<f64>) = (Vector3::new(1.0, 2.0, 0.5), Vector3::new(4.0, 3.5, 2.5));

fn beam(offsets: bool) -> SingleElement {
    let o = if offsets { (Vector3::new(0.2, 0.1, 0.3), Vector3::new(-0.1, 0.2, -0.2)) } else { Default::default() };
    let spec = TransformSpec {
        kind: TransformKind::Corotational,
        xz: Vector3::new(0.0, 0.3, 1.0),
        offsets: o,
        by_trials: false,
    };
    let transform = spec.space(&Ends { place: LINE, disp: &[0.0; 12] }).unwrap();
    let section = ElasticSection { e: 1000.0, area: 5.0, iz: 0.9, iy: 0.4, g: 100.0, j: 3.0, shear: (None, None) };
    SingleElement::new(ElasticBeam::new(transform, section, ElasticOptions::default()))
}

fn bar() -> SingleElement {
    let options = BarOptions { area: 2.0, rho: 0.3, consistent: true, rayleigh: false };
    let line = LINE.1 - LINE.0;
    SingleElement::new(CorotTruss::new(Material::new(Elastic::new(700.0)), 1, line.as_slice(), 3, options).unwrap())
}

/// Displacements of a rigid rotation about an axis through the origin, and a translation.
fn rigid(angle: f64, per_node: usize) -> Vec<f64> {
    let axis = Unit::new_normalize(Vector3::new(0.3, -0.5, 0.8));
    let turn = Rotation3::from_axis_angle(&axis, angle);
    let mut u = vec![];
    for x in [LINE.0, LINE.1] {
        u.extend((turn * x - x + Vector3::new(3.0, -1.0, 2.0) * angle).iter());
        if per_node == 6 {
            u.extend((axis.into_inner() * angle).iter());
        }
    }
    u
}

#[test]
fn large_rigid_motions_cause_no_force() {
    for (name, mut e, per_node) in
        [("beam", beam(false), 6), ("beam with joint offsets", beam(true), 6), ("bar", bar(), 3)]
    {
        for step in 1..=30 {
            let f = e.force(&rigid(0.1 * f64::from(step), per_node));
            e.commit();
            assert!(f.iter().all(|f| f.abs() < 1e-9), "{name}, step {step}: {f:?}");
        }
    }
}

/// Rotations are measured from the committed state, where an increment is a spin. The beam uses the mean of the
/// nodes' axes as midpoint, so its tangent is less exact for larger bending.
#[test]
fn tangent_matches_finite_difference() {
    for (name, mut e, n, tolerance) in
        [("beam", beam(false), 12, 0.01), ("beam with joint offsets", beam(true), 12, 0.01), ("bar", bar(), 6, 0.0)]
    {
        for size in [0.0, 0.02, 0.06] {
            let bent = (0..n).map(|i| size * ((i * i + 3 * i + 1) as f64 * 0.7).sin());
            let u: Vec<f64> = bent.zip(rigid(1.1, n / 2)).map(|(a, b)| a + b).collect();
            // Several steps, since rotations about different axes do not commute.
            for step in 1..=20 {
                let part: Vec<f64> = u.iter().map(|x| x * f64::from(step) / 20.0).collect();
                e.force(&part);
                e.commit();
            }
            let (_, k) = e.trial(&u, &vec![0.0; n]);
            let error = difference(&k, &e.difference(&u, 1e-5));
            assert!(error < 1e-7 + tolerance * size, "{name}, bent by {size}: {error:.1e}");
            // The solver relies on the symmetry flag, and the tangent of a bent spatial beam is not symmetric.
            let entry = |i: usize, j: usize| k[i * n + j];
            let skew = (0..n * n).map(|at| (entry(at / n, at % n) - entry(at % n, at / n)).abs()).fold(0.0, f64::max);
            let largest = k.iter().fold(0.0f64, |m, x| m.max(x.abs()));
            assert!(!e.element.traits().symmetric || skew < 1e-9 * largest, "{name}, bent by {size}: {skew:.1e}");
            e = match n {
                6 => bar(),
                _ => beam(name != "beam"),
            };
        }
    }
}

#[test]
fn forces_of_a_bent_and_turned_beam_are_in_equilibrium() {
    for offsets in [false, true] {
        let mut e = beam(offsets);
        let mut u = rigid(0.8, 6);
        u.iter_mut().enumerate().for_each(|(i, x)| *x += 0.05 * ((i * 5 + 1) as f64).cos());
        let f = e.force(&u);
        let at = |k: usize, v: &[f64]| Vector3::new(v[k], v[k + 1], v[k + 2]);
        let place = |x: Vector3<f64>, k: usize| x + at(k, &u);
        let force = at(0, &f) + at(6, &f);
        let moment = place(LINE.0, 0).cross(&at(0, &f)) + place(LINE.1, 6).cross(&at(6, &f)) + at(3, &f) + at(9, &f);
        let size = f.iter().fold(0.0f64, |m, x| m.max(x.abs()));
        assert!(force.norm() < 1e-9 * size && moment.norm() < 1e-6 * size, "{force:?} {moment:?} of {size}");
    }
}

#[test]
fn bar_has_engineering_strain_and_mass() {
    let mut e = bar();
    let line = LINE.1 - LINE.0;
    // One end moves to make the bar 10 percent longer and to rotate it.
    let to = Vector3::new(-1.0, 0.4, 0.2).normalize() * 1.1 * line.norm();
    let mut u = vec![0.0; 6];
    u[3..].copy_from_slice((to - line).as_slice());
    let f = e.force(&u);
    let n = 0.1 * 700.0 * 2.0;
    for (i, x) in (to.normalize() * n).iter().enumerate() {
        assert!((f[3 + i] - x).abs() < 1e-9 * n && (f[i] + x).abs() < 1e-9 * n);
    }
    let Mass::Consistent(m) = e.element.mass() else { panic!("consistent mass") };
    assert!((m.iter().sum::<f64>() - 3.0 * 0.3 * line.norm()).abs() < 1e-12);
}

#[test]
fn coincident_ends_are_an_error() {
    let line = LINE.1 - LINE.0;
    for (e, n) in [(beam(false), 12), (bar(), 6)] {
        let mut u = vec![0.0; n];
        u[..3].copy_from_slice(line.as_slice());
        let (mut force, mut next) = (vec![0.0; n], e.state.clone());
        let motion = hysteron::element::ElementInput {
            disp: &u,
            vel: &vec![0.0; n],
            accel: &[],
            load: &e.load,
            still: false,
            opensees: None,
            dt: 0.0,
            time: 0.0,
            dynamic: false,
        };
        let response = hysteron::element::ElementOutput {
            force: &mut force,
            tangent: None,
            damping: None,
            part: hysteron::element::MatrixMask::ALL,
        };
        assert!(
            e.element.respond(&motion, &mut Histories { committed: &e.state, trial: &mut next }, response).is_err()
        );
    }
}
