//! Uniaxial laws.

use super::driver::{MaterialPoint, path};
use hysteron::material::{BoucWen, Elastic, ElasticPP, Material, Steel01, Viscous};

fn bouc_wen(n: f64, gamma: f64, beta: f64, delta: f64) -> Material {
    Material::new(BoucWen {
        alpha: 0.1,
        ko: 1000.0,
        n,
        gamma,
        beta,
        ao: 1.0,
        delta_a: delta,
        delta_nu: 2.0 * delta,
        delta_eta: 1.5 * delta,
    })
}

/// Every law with a strain amplitude in its nonlinear range.
fn all() -> Vec<(&'static str, Material, f64)> {
    vec![
        ("elastic", Material::new(Elastic::new(200.0)), 0.1),
        ("elastic, softer in compression", Material::new(Elastic { e_pos: 200.0, eta: 0.0, e_neg: 50.0 }), 0.1),
        ("elastic-plastic", Material::new(ElasticPP::new(200.0, 0.01, -0.02, 0.003)), 0.1),
        ("steel, kinematic", Material::new(Steel01 { fy: 2.0, e0: 200.0, b: 0.02, a: Steel01::NO_ISOTROPIC }), 0.1),
        ("steel, isotropic", Material::new(Steel01 { fy: 2.0, e0: 200.0, b: 0.02, a: [0.05, 5.0, 0.05, 5.0] }), 0.1),
        ("bouc-wen, n 1", bouc_wen(1.0, 20.0, 20.0, 0.0), 0.2),
        ("bouc-wen, n 2, softening", bouc_wen(2.0, -20.0, 60.0, 0.0), 0.4),
        ("bouc-wen, n 1.7, degrading", bouc_wen(1.7, 15.0, 25.0, 0.01), 0.2),
    ]
}

/// Checks that the tangent is the derivative of the stress along a pseudo-random path.
pub fn check_tangent(name: &str, law: Material, amplitude: f64) {
    let mut p = MaterialPoint::new(law);
    let mut tested = 0;
    for (k, strain) in path(7, 1200, amplitude).into_iter().enumerate() {
        let h = 1e-7 * amplitude;
        let (up, down) = (p.trial(strain + h, 0.0, 0.0).value, p.trial(strain - h, 0.0, 0.0).value);
        let (more, less) = (p.trial(strain + 2.0 * h, 0.0, 0.0).value, p.trial(strain - 2.0 * h, 0.0, 0.0).value);
        let s = p.advance(strain);
        let (near, far) = ((up - down) / (2.0 * h), (more - less) / (4.0 * h));
        // There is no derivative at kinks; differences that depend on their step size identify them.
        if (near - far).abs() < 1e-4 * near.abs().max(1.0) && (up - 2.0 * s.value + down).abs() <= 1e-4 * h * near.abs()
        {
            tested += 1;
            let error = (s.tangent - near).abs();
            assert!(error < 1e-3 * near.abs().max(1.0), "{name}, step {k}: tangent {} but {near}", s.tangent);
        }
    }
    assert!(tested > 200, "{name}: only {tested} points away from kinks");
}

/// Checks that uncommitted trials do not affect the response.
pub fn check_purity(name: &str, law: Material, amplitude: f64) {
    let (mut straight, mut wandering) = (MaterialPoint::new(law.clone()), MaterialPoint::new(law));
    for (k, strain) in path(3, 400, amplitude).into_iter().enumerate() {
        for other in [0.3 * amplitude, -amplitude, strain + 0.01 * amplitude] {
            wandering.trial(other, 0.0, 0.0);
        }
        assert_eq!(straight.advance(strain), wandering.advance(strain), "{name}, step {k}");
    }
}

#[test]
fn tangent_matches_finite_difference() {
    all().into_iter().for_each(|(name, law, amplitude)| check_tangent(name, law, amplitude));
}

#[test]
fn stress_depends_on_the_committed_state_alone() {
    all().into_iter().for_each(|(name, law, amplitude)| check_purity(name, law, amplitude));
}

#[test]
fn closed_cycles_create_no_energy() {
    for (name, law, amplitude) in all() {
        let mut p = MaterialPoint::new(law);
        let (mut last, mut at, mut work) = (0.0, 0.0, 0.0);
        let mut returns = vec![];
        for strain in path(11, 4000, amplitude) {
            let s = p.advance(strain).value;
            work += 0.5 * (s + last) * (strain - at);
            (last, at) = (s, strain);
            if s.abs() < 1e-3 * amplitude {
                returns.push(work);
            }
        }
        let scale = returns.iter().fold(1e-12f64, |m, w| m.max(w.abs()));
        assert!(work > -1e-6 * scale, "{name}: {work}");
        // The work between two unloaded states is nonnegative.
        for w in returns.windows(2) {
            assert!(w[1] - w[0] > -2e-2 * scale, "{name}: {} after {}", w[1], w[0]);
        }
    }
}

#[test]
fn mirrored_strain_gives_mirrored_stress() {
    let symmetric = ["elastic", "steel, kinematic", "bouc-wen, n 1", "bouc-wen, n 2, softening"];
    for (name, law, amplitude) in all().into_iter().filter(|m| symmetric.contains(&m.0)) {
        let (mut p, mut q) = (MaterialPoint::new(law.clone()), MaterialPoint::new(law));
        for strain in path(5, 500, amplitude) {
            let (a, b) = (p.advance(strain).value, q.advance(-strain).value);
            assert!((a + b).abs() <= 1e-12 * a.abs().max(1e-9), "{name}: {a} and {b}");
        }
    }
}

#[test]
fn initial_tangent_matches_small_strain() {
    for (name, law, amplitude) in all().into_iter().filter(|m| m.0 != "elastic-plastic") {
        let k = law.initial_tangent();
        let mut p = MaterialPoint::new(law);
        let strain = 1e-7 * amplitude;
        let secant = p.advance(strain).value / strain;
        assert!((secant - k).abs() < 1e-4 * k, "{name}: {secant} for {k}");
    }
}

/// Baber and Noori's equations integrated with 200 times as many steps.
#[test]
fn bouc_wen_converges_with_the_step() {
    let law = bouc_wen(2.0, 30.0, 30.0, 0.005);
    let end = |substeps: usize| {
        let mut p = MaterialPoint::new(law.clone());
        let mut last = 0.0;
        for target in [0.1, -0.15, 0.2, 0.0] {
            let from: f64 = last;
            for k in 1..=40 * substeps {
                last = from + (target - from) * k as f64 / (40 * substeps) as f64;
                p.advance(last);
            }
        }
        p.trial(last, 0.0, 0.0).value
    };
    let (coarse, fine, exact) = (end(1), end(2), end(200));
    let order = ((coarse - exact) / (fine - exact)).abs().log2();
    assert!((0.8..1.3).contains(&order), "backward Euler is of first order, found {order}");
}

#[test]
fn dashpot_force_opposes_the_rate() {
    let mut p = MaterialPoint::new(Material::new(Viscous { c: 50.0, alpha: 0.5, min_rate: 1e-11 }));
    let s = p.trial(0.0, 4.0, 0.01);
    assert!((s.value - 100.0).abs() < 1e-12);
    assert!((s.damping - 12.5).abs() < 1e-12, "derivative of 50 sqrt(v) at 4");
    assert!((p.trial(0.0, -4.0, 0.01).value + 100.0).abs() < 1e-12);
    assert_eq!(p.trial(0.3, 0.0, 0.01).value, 0.0, "no force in a static analysis");
    assert!(p.trial(0.0, 0.0, 0.01).damping.is_finite());
}
