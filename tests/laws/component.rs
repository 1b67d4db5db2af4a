//! Beams with two rotational end springs.

use super::driver::{SingleElement, difference};
use hysteron::element::ElementLoad;
use hysteron::element::beam::{ComponentBeam, ComponentOptions, ElasticBeam, ElasticOptions};
use hysteron::element::transform::{Ends, Transform, TransformKind, TransformSpec};
use hysteron::material::{Elastic, Material, Steel01, Steel02};
use hysteron::section::ElasticSection;
use nalgebra::Vector3;
use std::sync::Arc;

fn transform(kind: TransformKind) -> Arc<dyn Transform<6, 3>> {
    let spec =
        TransformSpec { kind, xz: Vector3::z(), offsets: (Vector3::zeros(), Vector3::zeros()), by_trials: false };
    let place = (Vector3::new(1.0, 2.0, 0.0), Vector3::new(4.0, 3.5, 0.0));
    spec.plane(&Ends { place, disp: &[0.0; 6] }).unwrap()
}

fn beam(kind: TransformKind, springs: [Option<Material>; 2]) -> SingleElement {
    let options = ComponentOptions { ea: 5000.0, ei: 900.0, rho: 0.0, consistent: false };
    SingleElement::new(ComponentBeam::new(transform(kind), options, springs.map(|s| s.map(|s| (s, 1)))))
}

fn steel() -> [Option<Material>; 2] {
    let curved = Steel02 {
        fy: 20.0,
        e0: 5000.0,
        b: 0.03,
        r0: 10.0,
        c_r: [0.925, 0.15],
        a: Steel02::NO_ISOTROPIC,
        sig_init: 0.0,
    };
    let bilinear = Steel01 { fy: 25.0, e0: 4000.0, b: 0.02, a: Steel01::NO_ISOTROPIC };
    [Some(Material::new(curved)), Some(Material::new(bilinear))]
}

/// Alternating end displacements.
fn motion(step: u32) -> Vec<f64> {
    let t = 0.1 * f64::from(step);
    (0..6).map(|i| 0.04 * (f64::from(i) + t * (1.0 + 0.3 * f64::from(i))).sin()).collect()
}

#[test]
fn tangent_matches_finite_difference() {
    for kind in [TransformKind::Linear, TransformKind::Corotational] {
        let mut a = beam(kind, steel());
        let load = ElementLoad::Distributed { span: (0.0, 1.0), y: (-3.0, -3.0), z: (0.0, 0.0), x: (0.5, 0.5) };
        a.load = vec![0.0; a.element.load_len()];
        a.element.add_load(&load, 1.0, &mut a.load).unwrap();
        let mut close = 0;
        for step in 0..60 {
            let u = motion(step);
            let (_, k) = a.trial(&u, &[0.0; 6]);
            close += usize::from(difference(&k, &a.difference(&u, 1e-7)) < 1e-4);
            a.commit();
        }
        // There is no derivative at the kink of the bilinear spring.
        assert!(close > 55, "{kind:?}: {close}");
    }
}

/// Rigid springs give the elastic beam, and a missing spring is a hinge.
#[test]
fn rigid_springs_give_the_elastic_beam_and_none_a_hinge() {
    let stiff = || Some(Material::new(Elastic::new(1e12)));
    let section = ElasticSection { e: 1000.0, area: 5.0, iz: 0.9, iy: 0.0, g: 0.0, j: 0.0, shear: (None, None) };
    let mut whole =
        SingleElement::new(ElasticBeam::new(transform(TransformKind::Linear), section, ElasticOptions::default()));
    let u = motion(3);
    assert!(difference(&beam(TransformKind::Linear, [stiff(), stiff()]).force(&u), &whole.force(&u)) < 1e-6);
    let hinged = beam(TransformKind::Linear, [None, stiff()]).force(&u);
    assert!(hinged[2].abs() < 1e-9 && hinged[5].abs() > 1.0, "{hinged:?}");
}

#[test]
fn no_force_in_a_rigid_motion() {
    let mut a = beam(TransformKind::Linear, steel());
    let turn = 0.02;
    // About the origin: (-θ y, θ x).
    let f = a.force(&[0.3 - turn * 2.0, 0.1 + turn, turn, 0.3 - turn * 3.5, 0.1 + turn * 4.0, turn]);
    assert!(f.iter().all(|f| f.abs() < 1e-9), "{f:?}");
}

/// A distributed moment m on a cantilever: m L at the support, m L²/(2 EI) and m L³/(3 EI) at the tip.
#[test]
fn distributed_moment_matches_beam_theory() {
    let section = ElasticSection { e: 1000.0, area: 5.0, iz: 0.9, iy: 0.0, g: 0.0, j: 0.0, shear: (None, None) };
    let mut a =
        SingleElement::new(ElasticBeam::new(transform(TransformKind::Linear), section, ElasticOptions::default()));
    a.load = vec![0.0; a.element.load_len()];
    a.element.add_load(&ElementLoad::Moment { z: 2.0 }, 1.0, &mut a.load).unwrap();
    let (length, ei) = (3.0f64.hypot(1.5), 900.0);
    let (rotation, across) = (2.0 * length * length / (2.0 * ei), 2.0 * length.powi(3) / (3.0 * ei));
    let (c, s) = (3.0 / length, 1.5 / length);
    let f = a.force(&[0.0, 0.0, 0.0, -s * across, c * across, rotation]);
    assert!((f[2] + 2.0 * length).abs() < 1e-9, "{f:?}");
    assert!(f[..2].iter().chain(&f[3..]).all(|f| f.abs() < 1e-9), "{f:?}");
}
