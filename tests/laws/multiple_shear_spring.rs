//! `multipleShearSpring`.

use super::driver::{MaterialPoint, SingleElement, difference, path};
use hysteron::element::axes::Orientation;
use hysteron::element::bearing::{Link, MultipleShearSpring, ShearSprings};
use hysteron::material::{
    COMPOUNDS, ElasticPP, HighDampingRubber, Impact, KikuchiAiken, LeadRubber, LeadRubberParameters, Material, Steel01,
};
use nalgebra::{Rotation3, Vector3};
use std::f64::consts::PI;

const HEIGHT: f64 = 0.14;

fn steel() -> Material {
    Material::new(Steel01 { fy: 25.0, e0: 1000.0, b: 0.05, a: Steel01::NO_ISOTROPIC })
}

fn lead() -> Material {
    let device = LeadRubber::new(&LeadRubberParameters {
        rubber_area: 0.385,
        height: HEIGHT,
        rubber_modulus: 392.0,
        lead_area: 0.0177,
        lead_strength: 8330.0,
        lead_modulus: 588.0,
        stiffness_ratio: 13.0,
        temperature: 15.0,
        factors: [1.0; 2],
    });
    Material::new(KikuchiAiken::new(device, [1.0; 2]))
}

fn high_damping() -> Material {
    let device = HighDampingRubber { compound: COMPOUNDS[0].clone(), area: 0.4e-3, height: HEIGHT, factors: [1.0; 3] };
    Material::new(KikuchiAiken::new(device, [1.0; 2]))
}

fn laws() -> [(&'static str, Material); 3] {
    [("steel", steel()), ("lead rubber", lead()), ("high damping rubber", high_damping())]
}

fn along(materials: Vec<(Material, usize)>, limit: Option<f64>, x: Vector3<f64>, y: Vector3<f64>) -> SingleElement {
    let (axes, length) = Orientation { x: Some(x), y: Some(y) }.of_link(Vector3::zeros(), x * 0.3, false).unwrap();
    let springs = ShearSprings::of(materials, limit, MultipleShearSpring::HEADER);
    SingleElement::new(MultipleShearSpring::new(springs, Link::new(&axes, length, 0.5), 2.0).unwrap())
}

fn upright(law: &Material, n: usize, limit: Option<f64>) -> SingleElement {
    along(vec![(law.clone(), n)], limit, Vector3::z(), Vector3::x())
}

/// Forces of node j for a displacement of it.
fn push(e: &mut SingleElement, u: Vector3<f64>) -> Vector3<f64> {
    let mut all = [0.0; 12];
    all[6..9].copy_from_slice(u.as_slice());
    let f = e.force(&all);
    Vector3::new(f[6], f[7], f[8])
}

fn orbit(seed: u64, n: usize) -> Vec<Vector3<f64>> {
    let amplitude = 2.2 * HEIGHT;
    let walks = path(seed, n, amplitude).into_iter().zip(path(seed + 1, n, amplitude));
    walks.map(|(x, y)| Vector3::new(x, y, 0.0)).collect()
}

#[test]
fn tangent_matches_finite_difference() {
    for (name, law) in laws() {
        for limit in [None, Some(0.3 * HEIGHT)] {
            let mut e = upright(&law, 8, limit);
            let walks: Vec<Vec<f64>> =
                (0..12).map(|i| path(60 + i, 150, if i % 6 < 3 { 0.25 } else { 0.05 })).collect();
            let mut tested = 0;
            for k in 0..150 {
                let u: Vec<f64> = walks.iter().map(|w| w[k]).collect();
                let (_, tangent) = e.trial(&u, &[0.0; 12]);
                let (near, far) = (e.difference(&u, 1e-8), e.difference(&u, 4e-8));
                if difference(&near, &far) < 1e-6 {
                    tested += 1;
                    let error = difference(&tangent, &near);
                    assert!(error < 1e-5, "{name}, {limit:?}, step {k}: {error:.1e}");
                }
                e.force(&u);
                e.commit();
            }
            assert!(tested > 80, "{name}: only {tested} states away from kinks");
        }
    }
}

#[test]
fn initial_tangent_matches_small_motion() {
    for (_, law) in laws() {
        for limit in [None, Some(0.02 * HEIGHT)] {
            let mut e = upright(&law, 6, limit);
            let mut k = vec![0.0; 144];
            e.element.initial_tangent(&mut k);
            assert!(difference(&k, &e.difference(&[0.0; 12], 1e-7)) < 1e-6);
        }
    }
}

/// With a limit, the springs in uniaxial motion equal one spring, for every number of springs.
#[test]
fn limited_springs_equal_one_spring_in_uniaxial_motion() {
    for (name, law) in laws() {
        for n in [1, 2, 3, 8, 40] {
            let (mut e, mut one) = (upright(&law, n, Some(0.01 * HEIGHT)), MaterialPoint::new(law.clone()));
            for k in 1..=60 {
                let u = 0.05 * f64::from(k) * HEIGHT;
                let (f, s) = (push(&mut e, Vector3::x() * u).x, one.advance(u).value);
                assert!((f - s).abs() < 1e-9 * s, "{name}, {n} springs at {u}: {f} for {s}");
                e.commit();
            }
        }
    }
}

#[test]
fn force_depends_on_the_committed_state_alone() {
    for (name, law) in laws() {
        let (mut e, mut w) = (upright(&law, 8, Some(0.05)), upright(&law, 8, Some(0.05)));
        let steps = orbit(9, 200);
        for (k, &u) in steps.iter().enumerate() {
            push(&mut w, steps[(k + 70) % 200]);
            push(&mut w, Vector3::zeros());
            assert_eq!(push(&mut e, u), push(&mut w, u), "{name}, step {k}");
            e.commit();
            w.commit();
        }
    }
}

/// Rotated axes rotate the response. A motion rotated by the angle between two springs does the same, and a mirrored
/// motion gives mirrored forces.
#[test]
fn law_rotates_with_its_axes() {
    let turn = Rotation3::from_euler_angles(0.4, -0.9, 1.3);
    for (name, law) in laws() {
        let n = 8;
        let spring = Rotation3::from_axis_angle(&Vector3::z_axis(), PI / n as f64);
        let mut e = upright(&law, n, Some(0.05));
        let mut turned = along(vec![(law.clone(), n)], Some(0.05), turn * Vector3::z(), turn * Vector3::x());
        let (mut next, mut mirror) = (upright(&law, n, Some(0.05)), upright(&law, n, Some(0.05)));
        for u in orbit(21, 200) {
            let f = push(&mut e, u);
            let scale = f.norm().max(1.0);
            assert!((turn * f - push(&mut turned, turn * u)).norm() < 1e-8 * scale, "{name}, turned");
            assert!((spring * f - push(&mut next, spring * u)).norm() < 1e-8 * scale, "{name}, by one spring");
            let flip = |v: Vector3<f64>| Vector3::new(v.x, -v.y, v.z);
            assert!((flip(f) - push(&mut mirror, flip(u))).norm() < 1e-8 * scale, "{name}, mirrored");
            [&mut e, &mut turned, &mut next, &mut mirror].into_iter().for_each(SingleElement::commit);
        }
    }
}

/// Springs of different materials each contribute their own force.
#[test]
fn springs_of_different_materials_add_up() {
    let hard: Material = Material::new(ElasticPP::new(300.0, 0.02, -0.02, 0.0));
    let mut e = along(vec![(hard.clone(), 1), (steel(), 1)], None, Vector3::z(), Vector3::x());
    let (mut a, mut b) = (MaterialPoint::new(hard), MaterialPoint::new(steel()));
    for u in orbit(2, 200) {
        let f = push(&mut e, u);
        assert!((f.x - a.advance(u.x).value).abs() < 1e-9, "along the first spring");
        assert!((f.y - b.advance(u.y).value).abs() < 1e-9, "along the second");
        e.commit();
    }
}

#[test]
fn orbits_dissipate_energy() {
    for (name, law) in laws() {
        let mut e = upright(&law, 8, Some(0.05));
        for (k, radius) in [0.3, 0.8, 1.6, 0.7].into_iter().enumerate() {
            let (mut work, mut last, mut at) = (0.0, Vector3::zeros(), Vector3::zeros());
            for i in 0..=600 {
                let angle = 0.01 * PI * f64::from(i);
                let wave = (angle * (1.0 + k as f64)).sin();
                let u = Vector3::new(angle.cos(), 0.6 * wave, 0.0) * radius * HEIGHT;
                let f = push(&mut e, u);
                e.commit();
                if i > 400 {
                    work += 0.5 * (f + last).dot(&(u - at));
                }
                (last, at) = (f, u);
            }
            assert!(work > 0.0, "{name}, radius {radius}: {work}");
        }
    }
}

/// Springs without force at the limit are an error, since the factors are ratios of forces.
#[test]
fn springs_without_force_are_an_error() {
    let slack: Material = Material::new(Impact { k1: 300.0, k2: 100.0, delta_y: -0.01, gap: -0.1, compat: false });
    let (axes, length) = Orientation { x: Some(Vector3::z()), y: Some(Vector3::x()) }
        .of_link(Vector3::zeros(), Vector3::z(), false)
        .unwrap();
    let springs = ShearSprings::new(slack, 4, Some(0.05), MultipleShearSpring::HEADER);
    assert!(MultipleShearSpring::new(springs, Link::new(&axes, length, 0.5), 0.0).is_err());
}
