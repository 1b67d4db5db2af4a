//! A pad whose condition changes, by formulas of their own; some of them also lack a part of its loop.

use super::imposed::{DT, FY, K, K0, Plastic, Test, growing, mixed, pad, test, two_tests};
use super::studies::Concealed;

/// Eight cycles of one amplitude, the first of them growing and the last fading.
fn steady() -> Vec<f64> {
    let grown = |t: f64| (t / 1.5).min((12.0 - t) / 1.5).clamp(0.0, 1.0);
    (0..600).map(|i| DT * f64::from(i)).map(|t| 0.04 * grown(t) * (std::f64::consts::TAU * t / 1.5).sin()).collect()
}

/// Force of the pad, whose strength is a function of the run and the time. It is a third larger in one direction, which the
/// model lacks, and has ripples that every cycle repeats.
fn lopsided(t: &Test, strength: impl Fn(&Test, f64) -> f64) -> Vec<f64> {
    let mut spring = Plastic::default();
    let step = |(i, &u): (usize, &f64)| {
        let q = spring.force(u, K0, strength(t, DT * i as f64));
        K * u + if q > 0.0 { 1.35 * q } else { q } + 1.2 * (u / 0.004).sin()
    };
    t.path.iter().enumerate().map(step).collect()
}

/// The strength jumps in a test, and comes back to its own as time passes.
pub fn recovered() -> Concealed {
    pad(two_tests(), |t| {
        let mut spring = Plastic::default();
        let step = |(i, &u): (usize, &f64)| {
            let since = DT * i as f64 - 2.4;
            let more = if t.holdout || since < 0.0 { 0.0 } else { 0.9 * (-since / 1.3).exp() };
            K * u + spring.force(u, K0, FY * (1.0 + more))
        };
        t.path.iter().enumerate().map(step).collect()
    })
}

/// A device whose loop the model lacks in part, tested under a motion and under its reverse; between the tests it was loosened
/// to a part of its strength, which it has in one of two runs held out too.
pub fn loosened(part: f64) -> Concealed {
    let mut tests = two_tests();
    tests[0] = test("first", mixed(), false);
    tests.insert(1, test("again", mixed().into_iter().rev().collect(), false));
    tests.push(test("loose", growing(), true));
    pad(tests, |t| lopsided(t, |t, _| if ["again", "loose"].contains(&t.name) { part * FY } else { FY }))
}

/// The same device tested twice under one motion, the second time with another strength.
pub fn repeated(factor: f64) -> Concealed {
    let mut tests = two_tests();
    tests.insert(1, test("repeated", growing(), false));
    pad(tests, |t| lopsided(t, |t, _| if t.name == "repeated" { factor * FY } else { FY }))
}

/// The same device in a steady motion, tightened for a time.
pub fn tightened_in_steady_motion(factor: f64) -> Concealed {
    pad(vec![test("steady", steady(), false)], |t| {
        lopsided(t, |_, time| if (4.4..7.6).contains(&time) { factor * FY } else { FY })
    })
}
