//! Sections, quadrature along beams, and beams with these sections.

use super::driver::{SingleElement, difference, path};
use hysteron::element::ZeroLengthSection;
use hysteron::element::beam::{
    DisplacementBased, ElasticBeam, ElasticOptions, FiberBeam, ForceBased, Formulation, Hinge, Rule,
};
use hysteron::element::load::ElementLoad;
use hysteron::element::transform::{Ends, TransformKind, TransformSpec};
use hysteron::material::{Concrete02, Elastic as ElasticMaterial, Material, Steel02};
use hysteron::section::{
    Aggregator, Elastic, ElasticSection, Elliptical, Fiber, FiberBending, FiberSection, Resultant, Section as _,
    SectionStep, SharedSection,
};
use nalgebra::{Matrix3, Vector3};
use std::sync::Arc;

const LINE: (Vector3<f64>, Vector3<f64>) = (Vector3::new(1.0, 2.0, 0.5), Vector3::new(4.0, 3.5, 2.5));

fn moments(rule: &Rule, n: usize, degree: i32) -> f64 {
    let (x, w) = rule.points(n, 2.0).unwrap();
    x.iter().zip(&w).map(|(x, w)| w * x.powi(degree)).sum()
}

/// A rule integrates polynomials up to its degree.
#[test]
fn quadrature_is_exact_to_its_degree() {
    for n in 2..=12 {
        for (rule, degree) in [
            (Rule::Legendre, 2 * n - 1),
            (Rule::Radau, 2 * n - 2),
            (Rule::Lobatto, 2 * n - 3),
            (Rule::NewtonCotes, n - 1),
            (Rule::Trapezoidal, 1),
        ] {
            for d in 0..=degree as i32 {
                let error = (moments(&rule, n, d) - 1.0 / f64::from(d + 1)).abs();
                assert!(error < 1e-10, "{rule:?} with {n} points, degree {d}: {error:e}");
            }
        }
    }
    let (x, w) = Rule::Lobatto.points(5, 1.0).unwrap();
    assert!((x[1] - 0.5 * (1.0 - (3.0f64 / 7.0).sqrt())).abs() < 1e-14 && (w[0] - 0.05).abs() < 1e-14);
    for (hinge, degree) in [(Hinge::Radau, 2), (Hinge::RadauTwo, 2), (Hinge::Midpoint, 1), (Hinge::Endpoint, 0)] {
        for d in 0..=degree {
            let error =
                (moments(&Rule::Hinges(hinge, 0.2, 0.15), hinge.sections().len(), d) - 1.0 / f64::from(d + 1)).abs();
            assert!(error < 1e-13, "{hinge:?}, degree {d}: {error:e}");
        }
    }
    assert_eq!(Rule::Lobatto.points(1, 1.0), None);
    assert_eq!(Rule::Simpson.points(4, 1.0), None);
}

fn steel() -> Material {
    Material::new(Steel02 {
        fy: 4.0,
        e0: 2000.0,
        b: 0.02,
        r0: Steel02::TRANSITION[0],
        c_r: [Steel02::TRANSITION[1], Steel02::TRANSITION[2]],
        a: Steel02::NO_ISOTROPIC,
        sig_init: 0.0,
    })
}

/// An eccentric rectangle of 0.4 (y) by 0.2 (z), of steel or elastic.
fn rectangle(material: &Material, space: bool) -> SharedSection {
    let cell = |i: usize, j: usize| Fiber {
        y: 1.0 + 0.4 * ((i as f64 + 0.5) / 8.0 - 0.5),
        z: 0.2 * ((j as f64 + 0.5) / 4.0 - 0.5),
        area: 0.08 / 32.0,
        material: (material.clone(), 1),
    };
    let fibers = (0..32).map(|k| cell(k / 4, k % 4)).collect();
    let bending = if space {
        FiberBending::Space(Some((Material::new(ElasticMaterial::new(5.0)), 2)))
    } else {
        FiberBending::Plane
    };
    Arc::new(FiberSection::new(fibers, bending, false))
}

/// In the plane the fibers of a row have one strain: they share a state, and the section is that of their sum.
#[test]
fn fibers_of_one_height_share_a_state() {
    let steel = steel();
    let rows = (0..8).map(|i| Fiber {
        y: 1.0 + 0.4 * ((f64::from(i) + 0.5) / 8.0 - 0.5),
        z: 0.0,
        area: 0.01,
        material: (steel.clone(), 1),
    });
    let merged: SharedSection = Arc::new(FiberSection::new(rows.collect(), FiberBending::Plane, false));
    let sections = [rectangle(&steel, false), merged];
    assert_eq!(sections[0].state_len(), sections[1].state_len());
    assert!(rectangle(&steel, true).state_len() > 3 * sections[0].state_len());
    let [found, expected] = sections.map(|section| {
        let mut committed = vec![0.0; section.state_len()];
        section.init(&mut committed);
        let (mut s, mut k) = ([0.0; 2], [0.0; 4]);
        for e in [[1e-3, 0.05], [-2e-3, -0.08], [5e-4, 0.02]] {
            let mut next = committed.clone();
            let step = SectionStep { committed: &committed, e: &e, dt: 0.0, next: &mut next, s: &mut s, k: &mut k };
            section.update(step).expect("a response");
            committed = next;
        }
        [s[0], s[1], k[0], k[1], k[2], k[3]]
    });
    for (a, b) in found.iter().zip(expected) {
        assert!((a - b).abs() <= 1e-12 * b.abs(), "{found:?} {expected:?}");
    }
}

fn stiffness(section: &SharedSection) -> Vec<f64> {
    let n = section.resultants().len();
    let mut k = vec![0.0; n * n];
    section.initial_stiffness(&mut k);
    k
}

#[test]
fn fiber_section_has_the_rigidities_of_its_areas() {
    let k = stiffness(&rectangle(&Material::new(ElasticMaterial::new(100.0)), true));
    // Cells count at their centres: h² - (h/n)² instead of h².
    let (iz, iy) = (0.08 / 12.0 * 0.16 * (1.0 - 1.0 / 64.0), 0.08 / 12.0 * 0.04 * (1.0 - 1.0 / 16.0));
    let expected = [8.0, 0.0, 0.0, 0.0, 0.0, 100.0 * iz, 0.0, 0.0, 0.0, 0.0, 100.0 * iy, 0.0, 0.0, 0.0, 0.0, 5.0];
    assert!(difference(&k, &expected) < 1e-12, "{k:?}");
}

#[test]
fn section_tangent_matches_finite_difference() {
    let concrete = Concrete02 { fc: -3.0, epsc0: -0.002, fcu: -0.6, epscu: -0.006, ratio: 0.1, ft: 0.3, ets: 200.0 };
    for material in [steel(), Material::new(concrete)] {
        let shear = (Material::new(ElasticMaterial::new(30.0)), 9, Resultant::Vy);
        let section: SharedSection = Arc::new(Aggregator::new(Some(rectangle(&material, true)), vec![shear]).unwrap());
        let mut e = SingleElement::new(ZeroLengthSection::new((section, 1), (3, 6), Matrix3::identity(), true));
        let mut tested = 0;
        for x in path(5, 200, 0.02) {
            let mut u = [0.0; 12];
            (u[6], u[7], u[10], u[11]) = (0.1 * x - 5e-4, 0.3 * x, 0.7 * x, x);
            let (_, k) = e.trial(&u, &[0.0; 12]);
            let (near, far) = (e.difference(&u, 1e-8), e.difference(&u, 4e-8));
            // There is no derivative at the kinks of the fibers.
            if difference(&near, &far) < 1e-6 {
                tested += 1;
                assert!(difference(&k, &near) < 1e-5);
            }
            e.trial(&u, &[0.0; 12]);
            e.commit();
        }
        assert!(tested > 20, "{tested}");
    }
}

fn spec(kind: TransformKind) -> TransformSpec {
    TransformSpec { kind, xz: Vector3::new(0.0, 0.3, 1.0), offsets: Default::default(), by_trials: false }
}

fn beam<F: Formulation<12, 6>>(formulation: F, section: &SharedSection, rule: &Rule, n: usize) -> SingleElement {
    let transform = spec(TransformKind::Linear).space(&Ends { place: LINE, disp: &[0.0; 12] }).unwrap();
    let points = rule.points(n, transform.length()).unwrap();
    let sections = vec![(section.clone(), 1); n];
    SingleElement::new(FiberBeam::<F, 12, 6>::new(formulation, transform, sections, points, (0.0, false)))
}

/// With elastic sections both formulations equal the elastic beam. Under member loads the force-based one still does,
/// and the other has its end forces.
#[test]
fn elastic_sections_give_the_elastic_beam() {
    let section = ElasticSection { e: 1000.0, area: 5.0, iz: 0.9, iy: 0.4, g: 100.0, j: 3.0, shear: (None, None) };
    let shared: SharedSection = Arc::new(Elastic::new(section, false));
    let transform = spec(TransformKind::Linear).space(&Ends { place: LINE, disp: &[0.0; 12] }).unwrap();
    let mut whole = SingleElement::new(ElasticBeam::new(transform, section, ElasticOptions::default()));
    let u: Vec<f64> = (0..12).map(|i| 0.01 * f64::from(i * i + 1).sin()).collect();
    for load in [
        None,
        Some(ElementLoad::Distributed { span: (0.0, 1.0), y: (3.0, 3.0), z: (-2.0, -2.0), x: (1.0, 1.0) }),
        Some(ElementLoad::Distributed { span: (0.2, 0.7), y: (3.0, 5.0), z: (-2.0, 1.0), x: (1.0, 4.0) }),
        Some(ElementLoad::Point { at: 0.3, y: 5.0, z: -4.0, x: 2.0 }),
    ] {
        // The moment of a partial load is no polynomial; many points integrate it closely.
        let smooth = !matches!(load, Some(ElementLoad::Point { .. } | ElementLoad::Distributed { span: (0.2, _), .. }));
        let n = if smooth { 5 } else { 100 };
        let rule = if smooth { Rule::Lobatto } else { Rule::Trapezoidal };
        for mut e in
            [beam(ForceBased::default(), &shared, &rule, n), beam(DisplacementBased, &shared, &Rule::Legendre, 3)]
        {
            for alone in [&mut e, &mut whole] {
                alone.load.fill(0.0);
                if let Some(load) = &load {
                    alone.element.add_load(load, 2.0, &mut alone.load).unwrap();
                }
            }
            let (f, k) = e.trial(&u, &[0.0; 12]);
            let (g, m) = whole.trial(&u, &[0.0; 12]);
            let tolerance = if smooth { 1e-10 } else { 1e-3 };
            assert!(
                difference(&f, &g) < tolerance && difference(&k, &m) < tolerance,
                "{} {load:?}",
                e.element.class().name
            );
        }
    }
}

/// The tangent is consistent in the plastic range, and rigid motions cause no force.
#[test]
fn beams_yield_with_a_consistent_tangent() {
    let section = rectangle(&steel(), true);
    for mut e in [
        beam(ForceBased::default(), &section, &Rule::Lobatto, 5),
        beam(DisplacementBased, &section, &Rule::Legendre, 4),
        beam(ForceBased::default(), &section, &Rule::Hinges(Hinge::RadauTwo, 0.3, 0.2), 6),
    ] {
        let (mut tested, mut plastic) = (0, 0.0f64);
        let elastic = e.difference(&[0.0; 12], 1e-9);
        for x in path(11, 60, 0.08) {
            let mut u = [0.0; 12];
            (u[6], u[7], u[9], u[11], u[4]) = (0.1 * x, 0.5 * x, 0.3 * x, 0.4 * x, -0.2 * x);
            let (_, k) = e.trial(&u, &[0.0; 12]);
            let (near, far) = (e.difference(&u, 1e-7), e.difference(&u, 4e-7));
            if difference(&near, &far) < 1e-5 {
                tested += 1;
                assert!(difference(&k, &near) < 1e-4, "{}: {}", e.element.class().name, difference(&k, &near));
            }
            plastic = plastic.max(difference(&k, &elastic));
            e.trial(&u, &[0.0; 12]);
            e.commit();
        }
        assert!(tested > 20 && plastic > 0.05, "{tested} {plastic}");
        e.element.init(&mut e.state);
        let shift: Vec<f64> = (0..12).map(|i| if i % 6 < 3 { 0.1 * f64::from(i as u8 % 6) } else { 0.0 }).collect();
        assert!(e.force(&shift).iter().all(|f| f.abs() < 1e-12));
    }
}

/// The force-based cantilever beyond yield has the moment of the end force at every section.
#[test]
fn internal_forces_of_the_force_based_beam_are_in_equilibrium() {
    let section = rectangle(&steel(), true);
    let mut e = beam(ForceBased::default(), &section, &Rule::Lobatto, 5);
    let mut u = [0.0; 12];
    (u[7], u[8]) = (0.3, 0.2);
    e.trial(&u, &[0.0; 12]);
    e.commit();
    let read = |words: &[&str]| {
        let probe = e.element.probe(words).unwrap();
        let mut out = vec![0.0; probe.len()];
        let force = [0.0; 12];
        let s = hysteron::element::Snapshot { disp: &u, state: &e.state, force: &force, load: &e.load };
        e.element.read(&probe.path, &s, &mut out);
        out
    };
    let (q, x) = (read(&["basicForce"]), read(&["integrationPoints"]));
    let length = (LINE.1 - LINE.0).norm();
    for (i, x) in x.iter().enumerate() {
        let s = read(&["section", &(i + 1).to_string(), "force"]);
        let along = x / length;
        let expected = [q[0], (along - 1.0) * q[1] + along * q[2], (along - 1.0) * q[3] + along * q[4], q[5]];
        assert!(difference(&s, &expected) < 1e-7, "{s:?} {expected:?}");
    }
    assert_eq!(read(&["section", "force"]).len(), 20);
    let (v, vp) = (read(&["basicDeformation"]), read(&["plasticDeformation"]));
    assert!(vp[1].abs() > 0.1 * v[1].abs() && vp[1].abs() < v[1].abs());
}

/// The tangent of two resultants that yield on an ellipse is the derivative of their forces, and the forces stay on the surface.
#[test]
fn tangent_of_an_elliptical_yield_surface() {
    let law = Elliptical {
        e: [143.0, 90.0],
        yield_force: [3.2, 2.5],
        isotropic: 0.3,
        kinematic: [16.0, 9.0],
        resultants: [Resultant::Vy, Resultant::Vz],
    };
    let respond = |committed: &[f64], e: [f64; 2]| {
        let (mut next, mut s, mut k) = (vec![0.0; law.state_len()], [0.0; 2], [0.0; 4]);
        law.update(SectionStep { committed, e: &e, dt: 0.0, next: &mut next, s: &mut s, k: &mut k }).unwrap();
        (next, s, k)
    };
    let mut committed = vec![0.0; law.state_len()];
    let mut yielded = 0;
    for step in 0..60 {
        let t = 0.2 * f64::from(step);
        let e = [0.08 * t.sin(), 0.09 * (1.3 * t).cos() - 0.09];
        let (next, s, k) = respond(&committed, e);
        yielded += usize::from(next != committed);
        for j in 0..2 {
            let h = 1e-7;
            let moved =
                |sign: f64| respond(&committed, std::array::from_fn(|i| e[i] + if i == j { sign * h } else { 0.0 })).1;
            let (more, less) = (moved(1.0), moved(-1.0));
            for i in 0..2 {
                let slope = (more[i] - less[i]) / (2.0 * h);
                assert!((k[2 * i + j] - slope).abs() < 1e-4, "step {step}: {} for {slope}", k[2 * i + j]);
            }
        }
        let back = |i: usize| s[i] - law.kinematic[i] * next[i];
        let size = (0..2).map(|i| (back(i) / law.yield_force[i]).powi(2)).sum::<f64>().sqrt();
        assert!(size <= (1.0 + law.isotropic * next[2]) * (1.0 + 1e-12), "step {step}: {size}");
        committed = next;
    }
    assert!(yielded > 30, "{yielded} steps yield");
}

/// A section of concrete at ten heights, with two bars of one steel and one of another, in the plane or in space.
fn with_bars(space: bool) -> SharedSection {
    let concrete = Concrete02 { fc: -3.0, epsc0: -0.002, fcu: -0.6, epscu: -0.006, ratio: 0.1, ft: 0.3, ets: 200.0 };
    let (concrete, bars) = (Material::new(concrete), steel());
    let mut fibers: Vec<Fiber> = (0..10)
        .map(|i| Fiber {
            y: -0.18 + 0.04 * f64::from(i),
            z: 0.05 * f64::from(i % 3 - 1),
            area: 0.02,
            material: (concrete.clone(), 1),
        })
        .collect();
    let places = [(-0.15, 0.04, (bars.clone(), 2)), (0.01, -0.04, (bars, 2)), (0.16, 0.04, (steel(), 4))];
    fibers.extend(places.map(|(y, z, material)| Fiber { y, z, area: 0.001, material }));
    let torsion = (Material::new(ElasticMaterial::new(5.0)), 3);
    Arc::new(FiberSection::new(
        fibers,
        if space { FiberBending::Space(Some(torsion)) } else { FiberBending::Plane },
        false,
    ))
}

/// Forces and tangents of a beam on a path, with one section object at all places or one for each.
fn forces_on_a_path<F: Formulation<12, 6>>(formulation: F, n: usize, shared: bool) -> Vec<f64> {
    let transform = spec(TransformKind::Linear).space(&Ends { place: LINE, disp: &[0.0; 12] }).unwrap();
    let points = Rule::Lobatto.points(n, transform.length()).unwrap();
    let section = with_bars(true);
    let sections = (0..n).map(|_| (if shared { section.clone() } else { with_bars(true) }, 1)).collect();
    let beam = FiberBeam::<F, 12, 6>::new(formulation, transform, sections, points, (0.0, false));
    let (mut e, mut all) = (SingleElement::new(beam), vec![]);
    for x in path(5, 60, 0.006) {
        let mut u = [0.0; 12];
        (u[6], u[7], u[8]) = (-3e-3, x - 1.5e-3, -0.75 * x - 2e-3);
        let (force, tangent) = e.trial(&u, &[0.0; 12]);
        all.extend(force);
        all.extend(tangent);
        e.commit();
    }
    all
}

/// Bars of all places are evaluated together where the places have one section.
#[test]
fn places_with_one_section_have_the_bits_of_places_with_their_own() {
    for n in [2, 3, 7] {
        let of_forces = |shared| forces_on_a_path(ForceBased::default(), n, shared);
        assert_eq!(of_forces(true), of_forces(false));
        let of_displacements = |shared| forces_on_a_path(DisplacementBased, n, shared);
        assert_eq!(of_displacements(true), of_displacements(false));
    }
    assert!(with_bars(true).joined().is_some() && with_bars(false).joined().is_some());
    assert!(rectangle(&steel(), true).joined().is_none());
}
