//! `zeroLength` and `truss`.

use super::driver::{SingleElement, difference, path};
use hysteron::element::{BarOptions, Mass, RayleighDamping, Truss, ZeroLength};
use hysteron::material::{BoucWen, Elastic, Material, Steel01};
use nalgebra::{Matrix3, Rotation3, Vector3};

fn elastic(e: f64) -> Material {
    Material::new(Elastic::new(e))
}

fn steel() -> Material {
    Material::new(Steel01 { fy: 2.0, e0: 200.0, b: 0.02, a: Steel01::NO_ISOTROPIC })
}

fn smooth() -> Material {
    let law = BoucWen {
        alpha: 0.1,
        ko: 500.0,
        n: 2.0,
        gamma: 40.0,
        beta: 40.0,
        ao: 1.0,
        delta_a: 0.0,
        delta_nu: 0.0,
        delta_eta: 0.0,
    };
    Material::new(law)
}

fn turned() -> Matrix3<f64> {
    Rotation3::from_euler_angles(0.3, -0.7, 1.1).into_inner()
}

fn spring_set(axes: Matrix3<f64>) -> SingleElement {
    let springs =
        vec![(smooth(), 1, 1), (elastic(80.0), 2, 2), (smooth(), 3, 3), (elastic(5.0), 4, 4), (smooth(), 5, 6)];
    SingleElement::new(ZeroLength::new(springs, 3, 6, axes, &[0.0; 6], RayleighDamping::None).unwrap())
}

#[test]
fn zero_length_tangent_and_equilibrium() {
    let mut e = spring_set(turned());
    let random_motion: Vec<Vec<f64>> = (0..12).map(|k| path(k + 1, 60, 0.3)).collect();
    for k in 0..60 {
        let u: Vec<f64> = random_motion.iter().map(|w| w[k]).collect();
        let (f, tangent) = e.trial(&u, &[0.0; 12]);
        for i in 0..6 {
            assert!((f[i] + f[i + 6]).abs() < 1e-9, "the two ends pull against each other");
        }
        assert!(difference(&tangent, &e.difference(&u, 1e-7)) < 1e-4, "step {k}");
        e.trial(&u, &[0.0; 12]);
        e.commit();
    }
}

#[test]
fn zero_length_has_no_force_in_rigid_motion() {
    let mut e = spring_set(turned());
    let together = [0.4, -0.2, 0.1, 0.05, 0.02, -0.03];
    let u: Vec<f64> = together.iter().chain(&together).copied().collect();
    assert!(e.force(&u).iter().all(|f| f.abs() < 1e-12));
}

/// Rotating the element's axes and the motion rotates the force.
#[test]
fn zero_length_is_objective() {
    let q = turned();
    let (mut straight, mut rotated) = (spring_set(Matrix3::identity()), spring_set(q.transpose()));
    let random_motion: Vec<Vec<f64>> = (0..12).map(|k| path(k + 20, 80, 0.3)).collect();
    let turn = |v: &[f64]| -> Vec<f64> {
        v.chunks(3).flat_map(|c| (q * Vector3::from_column_slice(c)).as_slice().to_vec()).collect()
    };
    for k in 0..80 {
        let u: Vec<f64> = random_motion.iter().map(|w| w[k]).collect();
        let (a, b) = (turn(&straight.force(&u)), rotated.force(&turn(&u)));
        assert!(difference(&a, &b) < 1e-9, "step {k}");
        straight.commit();
        rotated.commit();
    }
}

#[test]
fn zero_length_measures_from_initial_position() {
    let made_at = vec![0.1, 0.0];
    let mut e = SingleElement::new(
        ZeroLength::new(vec![(elastic(10.0), 1, 1)], 2, 2, Matrix3::identity(), &made_at, RayleighDamping::None)
            .unwrap(),
    );
    assert!(e.force(&[0.0, 0.0, 0.1, 0.0]).iter().all(|f| f.abs() < 1e-12));
    assert!((e.force(&[0.0, 0.0, 0.3, 0.0])[2] - 2.0).abs() < 1e-12);
}

#[test]
fn zero_length_needs_a_degree_of_freedom_in_each_direction() {
    for (ndm, ndf, direction, good) in [
        (1, 1, 1, true),
        (1, 1, 2, false),
        (2, 2, 6, false),
        (2, 3, 6, true),
        (2, 3, 3, false),
        (3, 3, 4, false),
        (3, 6, 5, true),
    ] {
        let made = ZeroLength::new(
            vec![(elastic(1.0), 1, direction)],
            ndm,
            ndf,
            Matrix3::identity(),
            &vec![0.0; ndf],
            RayleighDamping::None,
        );
        assert_eq!(made.is_ok(), good, "direction {direction} with {ndf} in {ndm} dimensions");
    }
}

fn bar(material: Material) -> SingleElement {
    let options = BarOptions { area: 0.5, rho: 2.0, consistent: false, rayleigh: false };
    SingleElement::new(Truss::new(material, 1, &[3.0, 4.0, 0.0], 6, &[0.0; 6], options).unwrap())
}

#[test]
fn truss_force_is_axial() {
    let mut e = bar(elastic(200.0));
    // An elongation of 0.01 along the line of length 5.
    let mut u = [0.0; 12];
    (u[6], u[7]) = (0.006, 0.008);
    let f = e.force(&u);
    let n = 200.0 * 0.5 * 0.01 / 5.0;
    for (i, expected) in [(0, -0.6 * n), (1, -0.8 * n), (6, 0.6 * n), (7, 0.8 * n)] {
        assert!((f[i] - expected).abs() < 1e-12);
    }
    // A displacement normal to the line causes no force.
    (u[6], u[7]) = (-0.008, 0.006);
    assert!(e.force(&u).iter().all(|f| f.abs() < 1e-12));
}

#[test]
fn truss_tangent_and_mass() {
    let mut e = bar(steel());
    for (k, x) in path(2, 200, 0.4).into_iter().enumerate() {
        let mut u = [0.0; 12];
        (u[6], u[7], u[1]) = (x, 0.5 * x, -0.2 * x);
        let (_, tangent) = e.trial(&u, &[0.0; 12]);
        let differences = e.difference(&u, 1e-8);
        // The bilinear law has no derivative at its kinks.
        let (up, down) = (e.difference(&u, 1e-6), &differences);
        if difference(&up, down) < 1e-6 {
            assert!(difference(&tangent, &differences) < 1e-5, "step {k}");
        }
        e.trial(&u, &[0.0; 12]);
        e.commit();
    }
    let Mass::Lumped(m) = e.element.mass() else { panic!("lumped") };
    assert_eq!(m[0], 0.5 * 2.0 * 5.0);
    assert!(
        Truss::new(
            elastic(1.0),
            1,
            &[0.0, 0.0],
            2,
            &[0.0; 2],
            BarOptions { area: 1.0, rho: 0.0, consistent: true, rayleigh: false }
        )
        .is_err()
    );
}
