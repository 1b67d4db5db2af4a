//! Beams with yielding end hinges.

use super::driver::{SingleElement, difference};
use hysteron::element::Snapshot;
use hysteron::element::amendment::Hinged;
use hysteron::element::beam::{ElasticBeam, ElasticOptions};
use hysteron::element::transform::{Ends, TransformKind, TransformSpec};
use hysteron::material::{Elastic, Material, Steel02};
use hysteron::section::ElasticSection;
use nalgebra::{DMatrix, Vector3};
use std::f64::consts::TAU;
use std::sync::Arc;

const LINE: (Vector3<f64>, Vector3<f64>) = (Vector3::new(1.0, 2.0, 0.5), Vector3::new(4.0, 3.5, 2.5));
/// A spatial beam, and the same beam with end hinges of one law.
fn beams(kind: TransformKind, law: Material) -> [SingleElement; 2] {
    let offsets = Default::default();
    let spec = TransformSpec { kind, xz: Vector3::new(0.0, 0.3, 1.0), offsets, by_trials: false };
    let transform = spec.space(&Ends { place: LINE, disp: &[0.0; 12] }).unwrap();
    let section = ElasticSection { e: 1000.0, area: 5.0, iz: 0.9, iy: 0.4, g: 100.0, j: 3.0, shear: (None, None) };
    let beam = Arc::new(ElasticBeam::new(transform, section, ElasticOptions::default()));
    let hinged = Hinged::new(beam.clone(), LINE.1 - LINE.0, &[0, 1], law).unwrap();
    [SingleElement::of(beam), SingleElement::new(hinged)]
}

/// Hinges that yield at 10, `stiffer` times as stiff as the beam about its stiffer axis.
fn yielding(stiffer: f64) -> Material {
    let stiffness = stiffer * 857.0;
    let (r0, c_r) = (Steel02::TRANSITION[0], [Steel02::TRANSITION[1], Steel02::TRANSITION[2]]);
    Material::new(Steel02 {
        fy: 10.0,
        e0: stiffness,
        b: 30.0 / stiffness,
        r0,
        c_r,
        a: Steel02::NO_ISOTROPIC,
        sig_init: 0.0,
    })
}

/// Alternating displacements about all axes; one period is 2π/0.31 steps.
fn motion(step: f64) -> Vec<f64> {
    (0..12).map(|i| 0.05 * (0.31 * step + 0.9 * f64::from(i)).sin() * (f64::from(i) + 1.0).sin()).collect()
}

/// Elastic hinges are springs in series: the flexibilities add.
#[test]
fn elastic_hinges_add_their_flexibility() {
    let [plain, hinged] = beams(TransformKind::Linear, Material::new(Elastic::new(500.0)));
    let flexibility = |e: &SingleElement| {
        let mut k = vec![0.0; 144];
        e.element.initial_tangent(&mut k);
        // With end i fixed: the rotation of end j under a moment about each axis.
        let k = DMatrix::from_row_slice(12, 12, &k);
        k.view((6, 6), (6, 6)).into_owned().try_inverse().expect("a beam")
    };
    let (a, b) = (flexibility(&plain), flexibility(&hinged));
    let chord = (LINE.1 - LINE.0).normalize();
    let lying = chord.cross(&Vector3::z()).normalize();
    for axis in [lying, chord.cross(&lying)] {
        let along = |f: &DMatrix<f64>| axis.dot(&(f.view((3, 3), (3, 3)) * axis));
        // The moment is the same at both ends.
        assert!((along(&b) - along(&a) - 2.0 / 500.0).abs() < 1e-12);
    }
    assert!((chord.dot(&((&b - &a).view((3, 3), (3, 3)) * chord))).abs() < 1e-12, "twist has no hinge");
}

/// Hinges of every elastic stiffness carry the moment of the beam end.
#[test]
fn hinges_are_in_equilibrium() {
    for kind in [TransformKind::Linear, TransformKind::PDelta, TransformKind::Corotational] {
        for stiffer in [1.0, 100.0, 1e5] {
            let [mut plain, mut e] = beams(kind, yielding(stiffer));
            let probe = e.element.probe(&["hingeRotation"]).unwrap();
            let chord = (LINE.1 - LINE.0).normalize();
            let lying = chord.cross(&Vector3::z()).normalize();
            let mut turned: f64 = 0.0;
            for step in 0..60 {
                let u = motion(f64::from(step));
                let f = e.force(&u);
                e.commit();
                let mut theta = [0.0; 4];
                let snapshot = Snapshot { disp: &u, state: &e.state, force: &f, load: &[] };
                e.element.read(&probe.path, &snapshot, &mut theta);
                let mut behind = u.clone();
                for (end, theta) in theta.chunks_exact(2).enumerate() {
                    let by = lying * theta[0] + chord.cross(&lying) * theta[1];
                    (0..3).for_each(|i| behind[6 * end + 3 + i] -= by[i]);
                }
                let own = plain.force(&behind);
                plain.commit();
                let scaled_difference = own.iter().zip(&f).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
                // The response of corotational beams depends on the path.
                assert!(
                    kind == TransformKind::Corotational || scaled_difference < 1e-8,
                    "step {step}: {scaled_difference:e}"
                );
                turned = theta.iter().fold(turned, |m, t| m.max(t.abs()));
            }
            assert!(turned > 0.02, "{turned}");
        }
    }
}

#[test]
fn tangent_matches_finite_difference() {
    // The P-Delta tangent omits the change of the axial force, as in beams without hinges.
    for stiffer in [1.0, 100.0] {
        let [_, mut e] = beams(TransformKind::Linear, yielding(stiffer));
        let mut tested = 0;
        for step in 0..60 {
            let u = motion(f64::from(step));
            let (near, far) = (e.difference(&u, 1e-7), e.difference(&u, 4e-7));
            // There is no derivative where a hinge begins or ceases to yield.
            if difference(&near, &far) < 1e-6 {
                let (_, k) = e.trial(&u, &[0.0; 12]);
                assert!(difference(&k, &near) < 1e-5, "step {step}: {:e}", difference(&k, &near));
                tested += 1;
            }
            e.force(&u);
            e.commit();
        }
        assert!(tested > 40, "{tested}");
    }
}

/// A closed path dissipates energy.
#[test]
fn hinges_dissipate_energy() {
    let [mut plain, mut hinged] = beams(TransformKind::Linear, yielding(30.0));
    let worked = [&mut plain, &mut hinged].map(|e| {
        let (mut at, mut was) = (motion(0.0), e.force(&motion(0.0)));
        e.commit();
        let mut work = 0.0;
        // Ten periods.
        for step in 1..=2000 {
            let u = motion(f64::from(step) / 200.0 * TAU / 0.31);
            let f = e.force(&u);
            e.commit();
            work += (0..12).map(|i| 0.5 * (f[i] + was[i]) * (u[i] - at[i])).sum::<f64>();
            (at, was) = (u, f);
        }
        work
    });
    assert!(worked[1] > 1.0 && worked[0].abs() < 1e-9 * worked[1], "{worked:?}");
}
