//! High damping rubber in two shear directions.

use super::driver::{MaterialPoint, path};
use super::rubber::{bearing, compound};
use hysteron::material::Material;
use hysteron::material::hdr::{PlaneHistory, PlaneStep, Thermal};
use hysteron::material::{HdrRheology, Softening};

fn laws() -> Vec<(&'static str, HdrRheology)> {
    let cold = HdrRheology::new(compound("HDR3"), -30.0);
    let softening = Softening { excess: 0.4, strain: 0.5, power: None, healed: 0.0, time: 1.0, preload: 0.0 };
    let soft = HdrRheology { softening: Some(softening), ..HdrRheology::new(compound("HDR2"), 10.0) };
    let heated = HdrRheology { thermal: Some(Thermal::lumped(2.0, 600.0)), ..cold.clone() };
    let layers = HdrRheology { thermal: Some(Thermal::stack(&bearing())), ..cold.clone() };
    vec![("cold", cold), ("heated", heated), ("heated in layers", layers), ("softened", soft)]
}

/// A pseudo-random strain orbit.
fn orbit(seed: u64, n: usize) -> Vec<[f64; 2]> {
    path(seed, n, 1.6).into_iter().zip(path(seed + 100, n, 1.6)).map(|(x, y)| [x, y]).collect()
}

fn advance(law: &HdrRheology, strains: &[[f64; 2]], dt: f64) -> Vec<PlaneStep> {
    let mut h = law.plane_virgin();
    let mut heat = vec![0.0; law.heat_len()];
    strains
        .iter()
        .map(|&g| {
            let s = law.plane_step(&h, &heat, g, dt);
            law.plane_flow(&h, &s.next, dt, &mut heat);
            h = s.next;
            s
        })
        .collect()
}

#[test]
fn straight_path_equals_the_uniaxial_law() {
    for (name, law) in laws().into_iter().filter(|l| l.1.thermal.is_none()) {
        let mut p = MaterialPoint::new(Material::new(law.clone()));
        let line = path(4, 300, 1.75);
        let (c, s) = (0.6, -0.8);
        let strains: Vec<_> = line.iter().map(|g| [c * g, s * g]).collect();
        for (k, (g, got)) in line.iter().zip(advance(&law, &strains, 0.02)).enumerate() {
            let one = p.trial(*g, 0.0, 0.02).value;
            p.commit();
            let (along, across) = (c * got.stress[0] + s * got.stress[1], c * got.stress[1] - s * got.stress[0]);
            assert!((along - one).abs() < 5e-4 && across.abs() < 1e-9, "{name}, step {k}: {along} for {one}");
        }
    }
}

#[test]
fn law_is_isotropic() {
    for (name, law) in laws() {
        let strains = orbit(9, 200);
        let (c, s) = (0.28, 0.96);
        let turned: Vec<_> = strains.iter().map(|g| [c * g[0] - s * g[1], s * g[0] + c * g[1]]).collect();
        for (a, b) in advance(&law, &strains, 0.02).iter().zip(advance(&law, &turned, 0.02)) {
            let [x, y] = a.stress;
            let error = (c * x - s * y - b.stress[0]).abs() + (s * x + c * y - b.stress[1]).abs();
            assert!(error < 1e-9, "{name}: {error}");
        }
    }
}

#[test]
fn plane_tangent_matches_finite_difference() {
    for (name, law) in laws() {
        let strains = orbit(5, 250);
        let mut h = law.plane_virgin();
        let mut heat = vec![0.0; law.heat_len()];
        let mut errors = vec![];
        for g in strains {
            let s = law.plane_step(&h, &heat, g, 0.02);
            for j in 0..2 {
                let at = |d: f64| {
                    let mut g = g;
                    g[j] += d;
                    law.plane_step(&h, &heat, g, 0.02).stress
                };
                let e = 1e-6;
                let (up, down, more, less) = (at(e), at(-e), at(2.0 * e), at(-2.0 * e));
                for i in 0..2 {
                    let (near, far) = ((up[i] - down[i]) / (2.0 * e), (more[i] - less[i]) / (4.0 * e));
                    if (near - far).abs() < 1e-4 * near.abs().max(1.0) {
                        errors.push((s.tangent[i][j] - near).abs() / near.abs().max(1.0));
                    }
                }
            }
            law.plane_flow(&h, &s.next, 0.02, &mut heat);
            h = s.next;
        }
        errors.sort_by(f64::total_cmp);
        // If a slider begins to move in the step, the substeps depend on the strain, and the tangent omits this. The
        // tangent of self-heating rubber is that at constant temperature.
        let allowed = if law.thermal.is_some() { 0.03 } else { 1e-3 };
        let (n, most) = (errors.len(), errors[errors.len() - 1]);
        assert!(n > 700 && errors[n * 9 / 10] < allowed && most < 0.1, "{name}: {} and {most}", errors[n * 9 / 10]);
    }
}

#[test]
fn orbits_dissipate_energy() {
    for (name, law) in laws() {
        let strains: Vec<_> =
            (1..=3000).map(|k| 0.004 * f64::from(k)).map(|t: f64| [1.4 * t.sin(), 1.1 * (1.3 * t).sin()]).collect();
        let steps = advance(&law, &strains, 0.002);
        let (mut work, mut last) =
            (0.0, PlaneStep { next: PlaneHistory::default(), stress: [0.0; 2], tangent: [[0.0; 2]; 2] });
        for s in &steps {
            for i in 0..2 {
                work += 0.5 * (s.stress[i] + last.stress[i]) * (s.next.strain[i] - last.next.strain[i]);
            }
            if law.thermal.is_none() {
                assert!(s.next.heat >= last.next.heat - 1e-12, "{name}");
            }
            last = *s;
        }
        if name != "softened" {
            let (heat, stored) = (last.next.heat, last.next.stored);
            assert!((work - heat - stored).abs() < 1e-3 * work, "{name}: {work}, {heat}, {stored}");
        }
        if name == "heated" {
            assert!(last.next.rise > 0.9 * last.next.heat / 2.0, "{name}");
        }
    }
}

#[test]
fn hold_relaxes_the_overstress() {
    let law = HdrRheology::new(compound("HDR3"), -30.0);
    let strains: Vec<_> = (1..=100).map(|k| 0.0175 * f64::from(k)).map(|g| [0.6 * g, 0.8 * g]).collect();
    let ramp = advance(&law, &strains, 1.75 / 5.5 / 100.0);
    let end = law.plane_step(&ramp[99].next, &[], strains[99], 1800.0);
    let left = end.next.overstress[0].hypot(end.next.overstress[1]);
    assert!((left - 0.3168).abs() < 5e-4, "{left}");
}
