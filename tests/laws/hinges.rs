//! Beams whose ends yield.

use super::driver::{Alone, difference};
use hysteron::element::amendment::Hinged;
use hysteron::element::beam::{ElasticBeam, ElasticOptions};
use hysteron::element::transform::{Ends, TransformKind, TransformSpec};
use hysteron::section::ElasticSection;
use nalgebra::Vector3;
use std::f64::consts::TAU;
use std::sync::Arc;

const LINE: (Vector3<f64>, Vector3<f64>) = (Vector3::new(1.0, 2.0, 0.5), Vector3::new(4.0, 3.5, 2.5));
const MOMENT: f64 = 10.0;

/// A beam in space and the same with hinges of a hardening at its ends.
fn beams(kind: TransformKind, hardening: f64) -> [Alone; 2] {
    let offsets = Default::default();
    let spec = TransformSpec { kind, xz: Vector3::new(0.0, 0.3, 1.0), offsets, by_trials: false };
    let transform = spec.space(&Ends { place: LINE, disp: &[0.0; 12] }).unwrap();
    let section = ElasticSection { e: 1000.0, area: 5.0, iz: 0.9, iy: 0.4, g: 100.0, j: 3.0, shear: (None, None) };
    let beam = Arc::new(ElasticBeam::new(transform, section, ElasticOptions::default()));
    let hinged = Hinged::new(beam.clone(), LINE.1 - LINE.0, &[0, 1], MOMENT, hardening).unwrap();
    [Alone::of(beam), Alone::new(hinged)]
}

/// Displacements that go up and down, about all axes; one period is 2π/0.31 steps.
fn motion(step: f64) -> Vec<f64> {
    (0..12).map(|i| 0.05 * (0.31 * step + 0.9 * f64::from(i)).sin() * (f64::from(i) + 1.0).sin()).collect()
}

#[test]
fn below_the_yield_moment_they_are_not_there() {
    for kind in [TransformKind::Linear, TransformKind::PDelta, TransformKind::Corotational] {
        let [mut plain, mut hinged] = beams(kind, 0.1);
        let u: Vec<f64> = motion(3.0).iter().map(|u| 0.1 * u).collect();
        assert_eq!(plain.force(&u), hinged.force(&u));
    }
}

#[test]
fn moments_stay_at_the_yield_moment() {
    let [_, mut e] = beams(TransformKind::Linear, 0.0);
    let chord = (LINE.1 - LINE.0).normalize();
    let lying = chord.cross(&Vector3::z()).normalize();
    let mut reached = [false; 4];
    for step in 0..60 {
        let f = e.force(&motion(f64::from(step)));
        e.commit();
        for (i, reached) in reached.iter_mut().enumerate() {
            let axis = if i < 2 { lying } else { chord.cross(&lying) };
            let at = 3 + 6 * (i % 2);
            let moment = axis.dot(&Vector3::from_column_slice(&f[at..at + 3])).abs();
            assert!(moment < MOMENT * (1.0 + 1e-9), "step {step}: {moment}");
            *reached |= moment > MOMENT * (1.0 - 1e-9);
        }
    }
    assert_eq!(reached, [true; 4]);
}

#[test]
fn tangent_is_the_derivative_of_the_force() {
    // P-Delta leaves out how the axial force changes, here as in beams without hinges.
    for (kind, hardening) in [(TransformKind::Linear, 0.0), (TransformKind::Linear, 0.2)] {
        let [_, mut e] = beams(kind, hardening);
        let mut tested = 0;
        for step in 0..60 {
            let u = motion(f64::from(step));
            let (near, far) = (e.difference(&u, 1e-7), e.difference(&u, 4e-7));
            // Not where a hinge begins or ceases to turn.
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

/// Around a closed path it takes energy and never gives any.
#[test]
fn they_dissipate() {
    let [mut plain, mut hinged] = beams(TransformKind::Linear, 0.1);
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
