//! Timoshenko beam. Its agreement with OpenSees is in `validation/opensees/timoshenko_*`.

use super::driver::{SingleElement, difference};
use hysteron::element::Mass;
use hysteron::element::beam::{ElasticBeam, ElasticOptions, TimoshenkoBeam, TimoshenkoOptions};
use hysteron::element::load::ElementLoad;
use hysteron::element::roles::Inertia;
use hysteron::element::transform::{Ends, Transform, TransformKind, TransformSpec};
use hysteron::section::ElasticSection;
use nalgebra::Vector3;
use std::sync::Arc;

const LINE: (Vector3<f64>, Vector3<f64>) = (Vector3::new(1.0, 2.0, 0.5), Vector3::new(4.0, 3.5, 2.5));
const SECTION: ElasticSection =
    ElasticSection { e: 1000.0, area: 5.0, iz: 0.9, iy: 0.4, g: 300.0, j: 1.2, shear: (Some(4.0), Some(3.0)) };

fn transform() -> Arc<dyn Transform<12, 6>> {
    let offsets = (Vector3::zeros(), Vector3::zeros());
    let spec =
        TransformSpec { kind: TransformKind::Linear, xz: Vector3::new(0.0, 0.3, 1.0), offsets, by_trials: false };
    spec.space(&Ends { place: LINE, disp: &[0.0; 12] }).unwrap()
}

fn beam(options: TimoshenkoOptions) -> TimoshenkoBeam<12, 6> {
    TimoshenkoBeam::new(transform().frame().clone(), SECTION, options)
}

/// Without axial effects it equals the elastic beam-column with shear areas, under any load.
#[test]
fn linear_beam_equals_elastic_beam_with_shear() {
    let mut a = SingleElement::new(beam(TimoshenkoOptions::default()));
    let mut b = SingleElement::new(ElasticBeam::new(transform(), SECTION, ElasticOptions::default()));
    let load = ElementLoad::Distributed { span: (0.2, 0.7), y: (3.0, 5.0), z: (-2.0, 1.0), x: (1.0, 4.0) };
    a.load = vec![0.0; a.element.load_len()];
    a.element.add_load(&load, 2.0, &mut a.load).unwrap();
    b.load = vec![0.0; b.element.load_len()];
    b.element.add_load(&load, 2.0, &mut b.load).unwrap();
    let u: Vec<f64> = (0..12).map(|i| 0.1 * f64::from(i * i + 1).sin()).collect();
    let (f, k) = a.trial(&u, &[0.0; 12]);
    let (g, m) = b.trial(&u, &[0.0; 12]);
    assert!(difference(&f, &g) < 1e-12 && difference(&k, &m) < 1e-12);
    assert!(difference(&k, &a.difference(&u, 1e-5)) < 1e-7);
}

/// A translation accelerates the total mass.
#[test]
fn masses_add_up_and_consistent_ones_are_symmetric() {
    for consistent in [false, true] {
        let m = match beam(TimoshenkoOptions { rho: 2.0, consistent, geometric: false }).mass() {
            Mass::Consistent(m) => m,
            Mass::Lumped(d) => (0..144).map(|k| if k % 13 == 0 { d[k / 13] } else { 0.0 }).collect(),
            Mass::None => vec![],
        };
        for i in 0..12 {
            for j in 0..12 {
                assert!((m[12 * i + j] - m[12 * j + i]).abs() < 1e-12);
            }
        }
        let total = 2.0 * (LINE.1 - LINE.0).norm();
        for d in 0..3 {
            let moved: f64 = [d, d + 6].iter().flat_map(|i| [d, d + 6].map(|j| m[12 * i + j])).sum();
            assert!((moved - total).abs() < 1e-12 * total, "{consistent} {d}");
        }
    }
}

/// Under tension T a rigid rotation θ needs the transverse force T θ alone.
#[test]
fn tension_adds_geometric_stiffness() {
    let mut with = SingleElement::new(beam(TimoshenkoOptions { geometric: true, ..Default::default() }));
    let mut without = SingleElement::new(beam(TimoshenkoOptions::default()));
    let axis = (LINE.1 - LINE.0).normalize();
    let across = axis.cross(&Vector3::x()).normalize();
    let turn = axis.cross(&across);
    let length = (LINE.1 - LINE.0).norm();
    let theta = 0.01;
    let mut u = vec![0.0; 12];
    for d in 0..3 {
        u[3 + d] = theta * turn[d];
        u[9 + d] = theta * turn[d];
        u[6 + d] = 0.02 * axis[d] + theta * length * across[d];
    }
    let tension = 5000.0 * 0.02 / length;
    let (f, g) = (with.force(&u), without.force(&u));
    for d in 0..3 {
        assert!((f[6 + d] - g[6 + d] - tension * theta * across[d]).abs() < 1e-9, "{f:?} {g:?}");
        assert!((f[3 + d] - g[3 + d]).abs() < 1e-9, "no moments in a rigid rotation");
    }
}
