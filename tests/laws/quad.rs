//! The four-node quadrilateral.

use super::driver::{SingleElement, difference};
use hysteron::element::{Continuum, Mass, QuadOptions};
use hysteron::material::{Isotropic, Plane};

const STEEL: Isotropic = Isotropic { e: 1000.0, nu: 0.3, rho: 2.0 };
/// An irregular quadrilateral.
const CORNERS: [[f64; 2]; 4] = [[0.1, 0.0], [2.0, 0.3], [1.6, 1.9], [-0.2, 1.2]];
const OPTIONS: QuadOptions = QuadOptions { thickness: 0.5, pressure: 0.0, rho: 0.0, body: [0.0, 0.0] };

fn quad(plane: Plane) -> Continuum<3, 8> {
    Continuum::quad(&CORNERS, STEEL.family().plane(plane).unwrap(), &OPTIONS).unwrap()
}

/// Displacements with uniform strains exx, eyy and shear angle g, and a rigid motion.
fn field(exx: f64, eyy: f64, g: f64, turn: f64) -> Vec<f64> {
    CORNERS
        .iter()
        .flat_map(|[x, y]| [0.3 + exx * x + (0.5 * g - turn) * y, -0.2 + eyy * y + (0.5 * g + turn) * x])
        .collect()
}

#[test]
fn no_force_in_a_rigid_motion() {
    for plane in [Plane::Strain, Plane::Stress] {
        let f = SingleElement::new(quad(plane)).force(&field(0.0, 0.0, 0.0, 0.02));
        assert!(f.iter().all(|f| f.abs() < 1e-12), "{f:?}");
    }
}

/// Uniform strains are exact for every shape: the work of the forces is stress times strain times volume.
#[test]
fn patch_of_uniform_strain() {
    let area =
        0.5 * (0..4).map(|i| (CORNERS[i], CORNERS[(i + 1) % 4])).map(|([x, y], [z, w])| x * w - z * y).sum::<f64>();
    for plane in [Plane::Strain, Plane::Stress] {
        let strain = [0.01, -0.004, 0.006];
        let u = field(strain[0], strain[1], strain[2], 0.0);
        let mut a = SingleElement::new(quad(plane));
        let f = a.force(&u);
        let work: f64 = f.iter().zip(&u).map(|(f, u)| f * u).sum();
        let stress = STEEL.plane(plane).map(|row| row.iter().zip(&strain).map(|(d, e)| d * e).sum::<f64>());
        let wanted = 0.5 * area * stress.iter().zip(&strain).map(|(s, e)| s * e).sum::<f64>();
        assert!((work - wanted).abs() < 1e-12, "{work} {wanted}");
        let (_, k) = a.trial(&u, &[0.0; 8]);
        assert!(difference(&k, &a.difference(&u, 1e-5)) < 1e-8);
        for (point, out) in [("stresses", stress), ("strains", strain)] {
            let probe = a.element.probe(&[point]).unwrap();
            let mut found = [0.0; 12];
            let snapshot = hysteron::element::Snapshot { disp: &u, state: &[], force: &f, load: &[] };
            a.element.read(&probe.path, &snapshot, &mut found);
            found.chunks(3).for_each(|p| assert!(difference(p, &out) < 1e-12, "{point} {p:?}"));
        }
    }
}

/// Body forces, pressure and mass equal their resultants.
#[test]
fn loads_and_mass_add_up() {
    let options = QuadOptions { pressure: 3.0, body: [1.0, -2.0], ..OPTIONS };
    let loaded = Continuum::quad(&CORNERS, STEEL.family().plane(Plane::Stress).unwrap(), &options).unwrap();
    let mut a = SingleElement::new(loaded);
    let f = a.force(&[0.0; 8]);
    let Mass::Lumped(mass) = a.element.mass() else { panic!("lumped") };
    let volume = mass.iter().sum::<f64>() / (2.0 * STEEL.rho);
    // A pressure on all sides has no resultant.
    for (d, b) in [1.0, -2.0].into_iter().enumerate() {
        let sum: f64 = f.iter().skip(d).step_by(2).sum();
        assert!((sum + volume * b).abs() < 1e-12, "{sum}");
    }
}

#[test]
fn clockwise_corners_are_an_error() {
    let mut corners = CORNERS;
    corners.reverse();
    assert!(Continuum::quad(&corners, STEEL.family().plane(Plane::Stress).unwrap(), &OPTIONS).is_err());
}
