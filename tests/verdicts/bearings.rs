//! Bearings whose sliding faces, rubber or lead do what the model leaves out, by formulas of their own.

use super::imposed::{DT, K, Plastic, Test, along, pad, relaxing, test};
use super::studies::Concealed;

/// Two cycles of some amplitudes, each of them after a rest, s.
fn with_rests(cycles: [(f64, f64); 5]) -> Vec<f64> {
    let moved = |amplitude: f64| {
        (0..80).map(move |i| amplitude * (std::f64::consts::TAU * f64::from(i) / 40.0).sin()).chain([0.0])
    };
    let rest = |seconds: f64| std::iter::repeat_n(0.0, (seconds / DT) as usize);
    cycles.into_iter().flat_map(|(seconds, amplitude)| rest(seconds).chain(moved(amplitude))).collect()
}

/// Fitted to cycles after rests of 0.2 to 4 s, held out others.
fn rests() -> Vec<Test> {
    let fitted = with_rests([(0.0, 0.02), (0.2, 0.035), (4.0, 0.03), (0.6, 0.045), (1.8, 0.03)]);
    let held = with_rests([(0.0, 0.03), (1.0, 0.02), (0.4, 0.04), (3.0, 0.035), (0.1, 0.025)]);
    vec![test("rests", fitted, false), test("others", held, true)]
}

/// A slider beside the pad whose friction at the end of a rest has grown with the logarithm of its length (Dieterich 1972), and
/// falls to that of motion along a straight line over some slip (Ida 1972). It has rested for long before a test.
pub fn sticking(growth: f64) -> Concealed {
    let (friction, slip) = (0.5, 0.015);
    pad(rests(), |t| {
        let (mut slider, mut before) = (Plastic::default(), 0.0f64);
        let (mut rested, mut slipped) = (100.0f64, 0.0f64);
        along(&t.path, |u, q| {
            if u == before {
                rested = if slipped > 0.0 { 0.0 } else { rested } + DT;
                slipped = 0.0;
            }
            slipped += (u - before).abs();
            before = u;
            let more = growth * (1.0 + rested / 0.1).log10() * (1.0 - slipped / slip).max(0.0);
            K * u + q + slider.force(u, 2e4, friction + more)
        })
    })
}

/// Look-alike of a slider that sticks: the force relaxes at rest.
pub fn relaxing_at_rest() -> Concealed {
    relaxing(rests(), 150.0, 0.6)
}

/// Nothing is missing in cycles between rests.
pub fn rested() -> Concealed {
    pad(rests(), |t| along(&t.path, |u, q| K * u + q))
}
