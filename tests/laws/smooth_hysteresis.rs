//! Smooth hysteresis of exponential and algebraic type.

use super::driver::MaterialPoint;
use super::materials::{check_purity, check_tangent};
use hysteron::material::{HystereticAsym, HystereticPoly, HystereticSmooth, Material};

fn asym(b: [f64; 2], gamma: f64) -> Material {
    Material::new(HystereticAsym { ka: 200.0, kb: 10.0, fo: 2.0, b, gamma })
}

fn poly(a: f64, b: [f64; 2]) -> Material {
    Material::new(HystereticPoly { ka: 200.0, kb: 10.0, a, b, tolerance: 1e-12, compat: false })
}

fn smooth(beta: f64) -> Material {
    Material::new(HystereticSmooth::new(200.0, 10.0, 2.0, beta))
}

fn all() -> Vec<(&'static str, Material, f64)> {
    vec![
        ("smooth", smooth(0.0), 0.1),
        ("smooth, hardening", smooth(8.0), 0.2),
        ("asymmetric", asym([9.0, 4.0], 1.5), 0.2),
        ("algebraic", poly(20.0, [50.0, 200.0]), 0.2),
        ("algebraic, slow", poly(3.0, [0.0, 0.0]), 0.2),
    ]
}

/// Forces from one strain to another in steps.
fn walk(p: &mut MaterialPoint, from: f64, to: f64, n: u32) -> Vec<f64> {
    (1..=n).map(|i| p.advance(from + (to - from) * f64::from(i) / f64::from(n)).value).collect()
}

#[test]
fn tangent_is_consistent_and_trials_have_no_effect() {
    for (name, law, amplitude) in all() {
        check_tangent(name, law.clone(), amplitude);
        check_purity(name, law, amplitude);
    }
}

/// A branch depends on its first point alone, so the number of steps has no effect.
#[test]
fn force_is_independent_of_step_size() {
    for (name, law, amplitude) in all() {
        let [coarse, fine] = [1, 60].map(|n| {
            let mut p = MaterialPoint::new(law.clone());
            let turns = [0.0, amplitude, -0.6 * amplitude, 0.2 * amplitude, -amplitude, 0.0];
            turns.windows(2).map(|w| *walk(&mut p, w[0], w[1], n).last().unwrap()).collect::<Vec<f64>>()
        });
        for (a, b) in coarse.iter().zip(&fine) {
            assert!((a - b).abs() < 1e-9 * (1.0 + b.abs()), "{name}: {coarse:?} and {fine:?}");
        }
    }
}

/// At large strain a branch is on the limit curve: f_e + k_b u plus half the height of the loop.
#[test]
fn branch_reaches_the_limit_curve() {
    for s in [1.0, -1.0] {
        let u = s * 0.5;
        let e = |b: f64, x: f64| (b * x).exp();
        let exponential = e(9.0, u) - e(-4.0, u) - 13.0 * u + e(1.5, u) * (10.0 * u + s * 2.0);
        let force = *walk(&mut MaterialPoint::new(asym([9.0, 4.0], 1.5)), 0.0, u, 7).last().unwrap();
        assert!((force - exponential).abs() < 1e-9, "{force}, expected {exponential}");
        // Half the height follows from the tolerance: (ka - kb) (1 - (tol / (ka - kb))^((a - 1) / a)) / (2 (a - 1)).
        let height = 190.0 * (1.0 - (1e-12f64 / 190.0).powf(19.0 / 20.0)) / (2.0 * 19.0);
        let algebraic = 50.0 * u.powi(3) + 200.0 * u.powi(5) + 10.0 * u + s * height;
        let far = *walk(&mut MaterialPoint::new(poly(20.0, [50.0, 200.0])), 0.0, 40.0 * u, 7).last().unwrap();
        let rest = 50.0 * (40.0 * u).powi(3) + 200.0 * (40.0 * u).powi(5) + 400.0 * u;
        assert!((far - rest - (algebraic - 50.0 * u.powi(3) - 200.0 * u.powi(5) - 10.0 * u)).abs() < 1e-6);
    }
}

/// Cycles of one amplitude converge to one loop that dissipates energy.
#[test]
fn cycles_close_and_dissipate_energy() {
    for (name, law, amplitude) in all() {
        let mut p = MaterialPoint::new(law);
        let mut cycle = |from: f64| {
            let mut forces = walk(&mut p, from, amplitude, 100);
            forces.extend(walk(&mut p, amplitude, -amplitude, 200));
            forces
        };
        cycle(0.0);
        (0..20).for_each(|_| drop(cycle(-amplitude)));
        let (one, two) = (cycle(-amplitude), cycle(-amplitude));
        assert!(one.iter().zip(&two).all(|(a, b)| (a - b).abs() < 1e-6 * (1.0 + b.abs())), "{name}");
        let du = amplitude / 50.0;
        let up: f64 = one[..100].iter().sum();
        let down: f64 = one[100..].chunks(2).map(|w| w[1]).sum();
        assert!((up - down) * du > 0.01 * amplitude, "{name}: {}", (up - down) * du);
    }
}
