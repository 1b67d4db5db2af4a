//! `twoNodeLink` and `elastomericBearingPlasticity`.

use super::driver::{SingleElement, difference, path};
use hysteron::element::axes::Orientation;
use hysteron::element::bearing::{Link, PlaneBearing, PlasticShear, SpaceBearing};
use hysteron::element::roles::Inertance;
use hysteron::element::{
    Element, ElementInput, ElementOutput, Histories, Inerter, InerterOptions, LinkOptions, Mass, MatrixMask,
    TwoNodeLink,
};
use hysteron::material::{Elastic, ElasticPP, Material};
use nalgebra::{Matrix3, Rotation3, Vector3};

fn elastic(e: f64) -> Material {
    Material::new(Elastic::new(e))
}

fn options(p_delta: Option<[f64; 4]>) -> LinkOptions {
    LinkOptions { p_delta, shear_dist: [0.3, 0.8], mass: 4.0, rayleigh: false }
}

fn axes(ndm: usize) -> Matrix3<f64> {
    if ndm == 1 {
        Matrix3::identity()
    } else if ndm == 2 {
        Rotation3::from_axis_angle(&Vector3::z_axis(), 0.7).into_inner()
    } else {
        Rotation3::from_euler_angles(0.4, 0.9, -1.3).into_inner()
    }
}

/// A link with a spring in every direction.
fn link(ndm: usize, per_node: usize, p_delta: Option<[f64; 4]>) -> SingleElement {
    let springs = (1..=per_node).map(|d| (elastic(100.0 * d as f64), d as i32, d)).collect();
    SingleElement::new(TwoNodeLink::new(springs, (ndm, per_node), axes(ndm), 1.4, &options(p_delta)).unwrap())
}

const SHAPES: [(usize, usize); 5] = [(1, 1), (2, 2), (2, 3), (3, 3), (3, 6)];

fn some_motion(n: usize, size: f64) -> Vec<f64> {
    (0..n).map(|i| size * ((i * i + 3 * i + 1) as f64 * 0.7).sin()).collect()
}

#[test]
fn link_tangent() {
    for (ndm, per_node) in SHAPES {
        let n = 2 * per_node;
        let u = some_motion(n, 0.1);
        let mut e = link(ndm, per_node, None);
        let (_, k) = e.trial(&u, &vec![0.0; n]);
        assert!(difference(&k, &e.difference(&u, 1e-5)) < 1e-8, "{ndm} {per_node}");
        let mut initial = vec![0.0; n * n];
        e.element.initial_tangent(&mut initial);
        assert!(difference(&k, &initial) < 1e-14);

        // The P-Delta tangent omits the change of the axial force, so the axial force is nearly constant here.
        let springs =
            vec![(Material::new(ElasticPP::new(1e4, 0.005, -0.005, 0.0)), 1, 1), (elastic(30.0), 2, 2.min(per_node))];
        let springs = springs.into_iter().chain((3..=per_node).map(|d| (elastic(40.0), 3, d))).collect();
        let mut e = SingleElement::new(
            TwoNodeLink::new(springs, (ndm, per_node), axes(ndm), 1.4, &options(Some([0.1, 0.3, 0.2, 0.4]))).unwrap(),
        );
        if per_node > 1 {
            let mut u = u.clone();
            (0..ndm).for_each(|i| u[per_node + i] += 0.5 * axes(ndm)[(0, i)]);
            let (_, k) = e.trial(&u, &vec![0.0; n]);
            assert!(difference(&k, &e.difference(&u, 1e-6)) < 1e-6, "{ndm} {per_node}, P-Delta");
        }
    }
}

#[test]
fn link_has_no_force_in_rigid_motion() {
    for (ndm, per_node) in [(2, 3), (3, 6)] {
        let mut e = link(ndm, per_node, None);
        let line = axes(ndm).row(0).transpose() * 1.4;
        let turn = if ndm == 2 { Vector3::z() * 0.02 } else { Vector3::new(0.01, -0.02, 0.03) };
        let (shift, arm) = (Vector3::new(0.3, -0.2, 0.1), turn.cross(&line));
        let mut u = vec![0.0; 2 * per_node];
        for i in 0..ndm {
            u[i] = shift[i];
            u[per_node + i] = shift[i] + arm[i];
        }
        for node in [0, per_node] {
            match ndm {
                2 => u[node + 2] = turn.z,
                _ => u[node + 3..node + 6].copy_from_slice(turn.as_slice()),
            }
        }
        assert!(e.force(&u).iter().all(|f| f.abs() < 1e-12));
    }
}

/// The P-Delta forces restore equilibrium in the displaced position.
#[test]
fn link_p_delta_is_equilibrium_of_the_displaced_link() {
    for ratios in [[0.0; 4], [0.5; 4], [0.1, 0.3, 0.2, 0.4]] {
        let mut e = link(3, 6, Some(ratios));
        let line = axes(3).row(0).transpose() * 1.4;
        // A small axial displacement gives the axial force; transverse displacements are arbitrary.
        let mut u = vec![0.0; 12];
        let local = Vector3::new(-0.2, 0.05, -0.08);
        u[6..9].copy_from_slice((axes(3).transpose() * local).as_slice());
        let f = e.force(&u);
        let at = |k: usize, v: &[f64]| Vector3::new(v[k], v[k + 1], v[k + 2]);
        let across = axes(3).transpose() * Vector3::new(0.0, local.y, local.z);
        let axial = axes(3).row(0).dot(&at(6, &f).transpose());
        let along = axes(3).row(0).transpose() * axial;
        // Moments about i: forces at j on the undeformed lever arm, the axial force on the deformed one.
        let moment = line.cross(&at(6, &f)) + across.cross(&along) + at(3, &f) + at(9, &f);
        assert!(moment.norm() < 1e-10, "{ratios:?}: {moment:?}");
        assert!((at(0, &f) + at(6, &f)).norm() < 1e-12);
    }
}

#[test]
fn link_mass_and_errors() {
    let Mass::Lumped(m) = link(3, 6, None).element.mass() else { panic!("lumped mass") };
    assert_eq!(m, [2.0, 2.0, 2.0, 0.0, 0.0, 0.0, 2.0, 2.0, 2.0, 0.0, 0.0, 0.0]);
    let make = |direction, length, p_delta| {
        TwoNodeLink::new(vec![(elastic(1.0), 1, direction)], (2, 3), axes(2), length, &options(p_delta))
    };
    assert!(make(4, 1.0, None).is_err(), "no such direction");
    assert!(make(2, 0.0, Some([0.0; 4])).is_err(), "no lever for the shears");
    assert!(make(2, 0.0, Some([0.0, 0.0, 0.5, 0.5])).is_ok(), "moments alone need none");
}

fn plastic(k3: f64) -> PlasticShear {
    PlasticShear { k0: 7200.0, qd: 40.0, k2: 800.0, k3, mu: 2.5, compat: false }
}

fn in_space(k3: f64) -> SingleElement {
    let (axes, length) =
        Orientation::default().of_link(Vector3::zeros(), Vector3::new(0.02, -0.05, 0.3), false).unwrap();
    let materials = [1e5, 900.0, 6000.0, 5000.0].map(|e| (elastic(e), 1));
    SingleElement::new(SpaceBearing::new(plastic(k3), Link::new(&axes, length, 0.3), materials, 0.0, false))
}

fn in_plane(k3: f64) -> SingleElement {
    let (axes, length) = Orientation::default().of_link(Vector3::zeros(), Vector3::new(0.0, 0.3, 0.0), true).unwrap();
    let materials = [1e5, 900.0].map(|e| (elastic(e), 1));
    SingleElement::new(PlaneBearing::new(plastic(k3), Link::new(&axes, length, 0.3), materials, 0.0, false))
}

#[test]
fn plastic_bearing_tangent() {
    for mut e in [in_plane(0.0), in_plane(300.0), in_space(0.0), in_space(300.0)] {
        let n = e.element.dofs();
        let mut initial = vec![0.0; n * n];
        e.element.initial_tangent(&mut initial);
        assert!(difference(&initial, &e.difference(&vec![0.0; n], 1e-9)) < 1e-6);
        let walks: Vec<Vec<f64>> =
            (0..n).map(|i| path(7 + i as u64, 120, if i % (n / 2) < 2 { 0.05 } else { 0.004 })).collect();
        let mut tested = 0;
        for k in 0..120 {
            let u: Vec<f64> = walks.iter().map(|w| w[k]).collect();
            let (_, tangent) = e.trial(&u, &vec![0.0; n]);
            let (near, far) = (e.difference(&u, 1e-8), e.difference(&u, 4e-8));
            if difference(&near, &far) < 1e-6 {
                tested += 1;
                assert!(difference(&tangent, &near) < 1e-5, "{n} degrees of freedom, step {k}");
            }
            e.force(&u);
            e.commit();
        }
        assert!(tested > 80, "only {tested} states away from kinks");
    }
}

/// The plastic force stays on or inside the yield circle, independently of the step size along the circle.
#[test]
fn plastic_bearing_stays_on_its_yield_surface() {
    let mut e = in_space(0.0);
    let (axes, _) = Orientation::default().of_link(Vector3::zeros(), Vector3::new(0.02, -0.05, 0.3), false).unwrap();
    for k in 0..400 {
        let angle = 0.05 * f64::from(k);
        let local = Vector3::new(0.0, 0.08 * angle.cos(), 0.08 * angle.sin()) * (f64::from(k) / 100.0).min(1.0);
        let mut u = [0.0; 12];
        u[6..9].copy_from_slice((axes.transpose() * local).as_slice());
        let f = e.force(&u);
        e.commit();
        let q = axes * Vector3::new(f[6], f[7], f[8]) - local * 800.0;
        let size = q.y.hypot(q.z);
        assert!(size < 40.0 * (1.0 + 1e-10), "step {k}: {size}");
        assert!(k < 100 || size > 40.0 * (1.0 - 1e-10));
    }
}

/// Force and stiffness of an inerter in a dynamic motion.
fn inerter_force(e: &Inerter, [disp, vel, accel]: [&[f64]; 3]) -> (Vec<f64>, Vec<f64>) {
    let n = e.dofs();
    let (mut force, mut tangent, mut damping) = (vec![0.0; n], vec![0.0; n * n], vec![0.0; n * n]);
    let input =
        ElementInput { disp, vel, accel, load: &[], still: false, opensees: None, dt: 0.01, time: 1.0, dynamic: true };
    let output = ElementOutput {
        force: &mut force,
        tangent: Some(&mut tangent),
        damping: Some(&mut damping),
        part: MatrixMask::ALL,
    };
    let mut state = vec![0.0; e.state_len()];
    e.respond(&input, &mut Histories { committed: &state.clone(), trial: &mut state }, output).unwrap();
    tangent.extend(damping);
    (force, tangent)
}

/// The inertance matrix, the damping matrix and the stiffness of the P-Delta forces are the derivatives of the force.
#[test]
fn inerter_matrices_are_derivatives_of_its_force() {
    for (ndm, per_node, p_delta) in
        [(1, 1, None), (2, 3, None), (3, 6, None), (2, 2, Some([0.0; 4])), (3, 6, Some([0.1, 0.3, 0.2, 0.4]))]
    {
        let m = per_node.min(4);
        let matrix = |scale: f64| (0..m * m).map(|i| scale * (1.0 + ((i * i) % 5) as f64)).collect::<Vec<_>>();
        let options = InerterOptions {
            directions: (1..=m).collect(),
            inertance: matrix(2.0),
            damping: matrix(-0.7),
            p_delta,
            mass: 4.0,
            rayleigh: false,
        };
        let e = Inerter::new((ndm, per_node), axes(ndm), 1.4, options).unwrap();
        let n = e.dofs();
        let motion = |seed: u64| path(seed, n, 0.3);
        let [disp, vel, accel] = [motion(1), motion(2), motion(3)];
        let rest = vec![0.0; n];
        let (_, matrices) = inerter_force(&e, [&disp, &vel, &accel]);
        let mut differences = vec![vec![0.0; n * n]; 3];
        for which in 0..3 {
            for j in 0..n {
                // Forces are linear in the rates at rest, and in the displacements at given rates.
                let mut at = if which == 0 {
                    [disp.clone(), vel.clone(), accel.clone()]
                } else {
                    [rest.clone(), rest.clone(), rest.clone()]
                };
                at[which][j] += 1e-3;
                let up = inerter_force(&e, [&at[0], &at[1], &at[2]]).0;
                at[which][j] -= 2e-3;
                let down = inerter_force(&e, [&at[0], &at[1], &at[2]]).0;
                (0..n).for_each(|i| differences[which][i * n + j] = (up[i] - down[i]) / 2e-3);
            }
        }
        let (stiffness, damping) = matrices.split_at(n * n);
        if p_delta.is_some() {
            assert!(difference(stiffness, &differences[0]) < 1e-9, "{ndm} {per_node}");
        } else {
            assert!(stiffness.iter().chain(&differences[0]).all(|k| k.abs() < 1e-9));
        }
        assert!(difference(damping, &differences[1]) < 1e-9, "{ndm} {per_node}");
        assert!(difference(&e.inertance(), &differences[2]) < 1e-9, "{ndm} {per_node}");
    }
}
