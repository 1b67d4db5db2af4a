//! Deteriorating plastic hinges and walls.

use super::driver::MaterialPoint;
use super::materials::{check_purity, check_tangent};
use hysteron::material::{Bilin, BilinSide, Deterioration, Saws, SawsParameters};
use hysteron::rules::{Consistent, OpenSees};
use std::sync::Arc;

const KE: f64 = 200.0;

/// My, αs, θp, θpc, κ, θu, D.
const SIDE: BilinSide = BilinSide {
    strength: 2.0,
    hardening: 0.03,
    plastic: 0.05,
    post_capping: 0.2,
    residual: 0.4,
    ultimate: 0.4,
    rate: 1.0,
};

fn hinge<R>(capacity: f64, n: f64, rules: R) -> Bilin<R> {
    let mode = Deterioration { capacity, exponent: 1.0 };
    Bilin { ke: KE, sides: [SIDE; 2], strength: mode, capping: mode, stiffness: mode, n, rules }
}

fn close(a: f64, b: f64) {
    assert!((a - b).abs() < 1e-6 * (1.0 + b.abs()), "{a}, expected {b}");
}

/// Peaks of full cycles of one amplitude.
fn peaks(law: Bilin, amplitude: f64, cycles: usize) -> Vec<f64> {
    let mut p = MaterialPoint::new(Arc::new(law));
    let mut at = |from: f64, to: f64| -> f64 {
        (1..=40).map(|i| p.advance(from + (to - from) * f64::from(i) / 40.0).value).last().unwrap()
    };
    let mut from = 0.0;
    (0..2 * cycles)
        .map(|i| {
            let to = if i % 2 == 0 { amplitude } else { -amplitude };
            let force = at(from, to).abs();
            from = to;
            force
        })
        .collect()
}

#[test]
fn tangent_is_consistent_and_trials_have_no_effect() {
    for (name, capacity, n) in [("no deterioration", 0.0, 0.0), ("little", 10.0, 0.0), ("much", 1.0, 3.0)] {
        check_tangent(name, Arc::new(hinge(capacity, n, Consistent)), 0.1);
        check_purity(name, Arc::new(hinge(capacity, n, Consistent)), 0.1);
        check_purity(name, Arc::new(hinge(capacity, n, OpenSees)), 0.3);
    }
}

/// Yield, cap, residual strength and fracture, on both sides.
#[test]
fn monotonic_loading_follows_the_backbone() {
    let (yielded, peak) = (0.01, 2.0 + 0.03 * KE * 0.05);
    for s in [1.0, -1.0] {
        let mut p = MaterialPoint::new(Arc::new(hinge(1.0, 0.0, Consistent)));
        for (x, force) in [
            (0.005, 1.0),
            (yielded, 2.0),
            (yielded + 0.05, peak),
            (yielded + 0.05 + 0.1, 0.5 * peak),
            (0.3, 0.8),
            (0.39, 0.8),
            (0.41, 0.0),
        ] {
            close(s * p.advance(s * x).value, force);
        }
        close(p.advance(0.0).value, 0.0);
    }
}

/// Hinge and elastic member in series follow the given backbone up to the cap.
#[test]
fn hinge_and_member_follow_the_given_backbone() {
    let n = 10.0;
    let member = KE * (1.0 + n) / n;
    let mut p = MaterialPoint::new(Arc::new(hinge(0.0, n, Consistent)));
    let mut last = (0.0, 0.0);
    for i in 1..=50 {
        let x = 0.001 * f64::from(i);
        let force = p.advance(x).value;
        let now = (x + force / member, force);
        let slope = (now.1 - last.1) / (now.0 - last.0);
        if now.1 < 2.0 {
            close(slope, KE);
        } else if last.1 > 2.0 {
            close(slope, 0.03 * KE);
        }
        last = now;
    }
}

/// Cycles reduce the strength more for a smaller capacity, and not at all without a reference energy.
#[test]
fn cycles_reduce_the_hinge_strength() {
    let intact = peaks(hinge(0.0, 0.0, Consistent), 0.04, 8);
    intact[2..].iter().for_each(|&f| close(f, intact[2]));
    let [some, more] = [2.0, 1.0].map(|capacity| peaks(hinge(capacity, 0.0, Consistent), 0.04, 8));
    for (i, (a, b)) in some.iter().zip(&more).enumerate().skip(2) {
        assert!(b < a && *a < intact[i], "peak {i}: {a} and {b} of {}", intact[i]);
        assert!(*a < some[i - 1] && *b < more[i - 1], "peak {i}: {a} after {}", some[i - 1]);
    }
}

/// A step from one side beyond the cap of the other loses no additional strength.
#[test]
fn long_step_keeps_strength() {
    let drive = |compat: bool| {
        let side = BilinSide { plastic: 0.02, residual: 0.0, ..SIDE };
        let mut p = match compat {
            true => MaterialPoint::new(Arc::new(Bilin { sides: [side; 2], ..hinge(1.0, 0.0, OpenSees) })),
            false => MaterialPoint::new(Arc::new(Bilin { sides: [side; 2], ..hinge(1.0, 0.0, Consistent) })),
        };
        [0.03, -0.07, 0.03, -0.065].map(|x| p.advance(x).value)[3]
    };
    assert!(drive(false) < -0.5, "{}", drive(false));
    assert!(drive(true).abs() < 1e-6, "{}", drive(true));
}

const WALL: SawsParameters =
    SawsParameters { fo: 2.0, fi: 0.3, du: 0.07, so: 200.0, r: [0.06, -0.08, 1.1, 0.02], alpha: 0.8, beta: 1.1 };

/// Monotonic loading follows (F0 + R1 S0 u)(1 - exp(-S0 u / F0)) up to DU, then a line of slope R2 S0.
#[test]
fn monotonic_loading_of_a_wall_follows_its_envelope() {
    let envelope = |u: f64| (2.0 + 12.0 * u) * (1.0 - (-100.0 * u).exp());
    for s in [1.0, -1.0] {
        let mut p = MaterialPoint::new(Arc::new(Saws::new(WALL).expect("a wall that pinches")));
        for u in [0.005, 0.02, 0.05, 0.07] {
            close(s * p.advance(s * u).value, envelope(u));
        }
        close(s * p.advance(s * 0.1).value, envelope(0.07) - 16.0 * 0.03);
    }
    assert!(Saws::new(SawsParameters { fi: 5.0, ..WALL }).is_none());
}

/// Cycles of one amplitude dissipate energy, later ones less.
#[test]
fn wall_cycles_dissipate_less_when_repeated() {
    let mut p = MaterialPoint::new(Arc::new(Saws::new(WALL).expect("a wall that pinches")));
    let mut cycle = || {
        let mut work = 0.0;
        let (mut from, mut before) = (0.0, p.advance(0.0).value);
        for to in (1..=200).map(|i| 0.05 * (std::f64::consts::TAU * f64::from(i) / 200.0).sin()) {
            let force = p.advance(to).value;
            work += 0.5 * (force + before) * (to - from);
            (from, before) = (to, force);
        }
        work
    };
    let [first, second, third] = [cycle(), cycle(), cycle()];
    assert!(first > second && second >= third && third > 0.0, "{first} {second} {third}");
}
