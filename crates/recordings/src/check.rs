//! Doubts about a series: steps, lengths and peaks that records do not have.

use crate::motion::Channel;
use crate::unit::Quantity;

/// Standard acceleration of gravity in m/s².
const G: f64 = 9.80665;
/// Longest step, in s, and longest record, in s, that are usual.
const LONGEST_STEP: f64 = 0.1;
const LONGEST_RECORD: f64 = 3600.0;
/// Largest and least peak of a record, in g.
const LARGEST_PEAK: f64 = 3.0;
const LEAST_PEAK: f64 = 1e-4;

/// What is doubtful about a channel of accelerations in m/s².
pub fn doubts(channel: &Channel) -> Vec<String> {
    let mut out = vec![];
    let n = channel.values.len();
    if channel.dt > LONGEST_STEP {
        out.push(format!("the step is {} s: is the unit of the time right?", channel.dt));
    }
    let duration = (n.max(1) - 1) as f64 * channel.dt;
    if duration > LONGEST_RECORD {
        out.push(format!("the record takes {duration} s: is the unit of the time right?"));
    }
    let peak = channel.values.iter().fold(0.0f64, |m, x| m.max(x.abs())) / G;
    if peak > LARGEST_PEAK {
        // A series of velocities in cm/s that is taken for g has a peak of some ten g.
        let as_velocity = derivative_peak(&channel.series.values, channel.dt) * 0.01 / G;
        let sensible = (LEAST_PEAK..=LARGEST_PEAK).contains(&as_velocity);
        let hint = if channel.unit.quantity == Quantity::Acceleration && sensible {
            format!("; as velocities in cm/s its accelerations would have a peak of {as_velocity:.3} g")
        } else {
            String::new()
        };
        out.push(format!("the peak is {peak:.4} g: are unit and quantity right?{hint}"));
    } else if peak > 0.0 && peak < LEAST_PEAK {
        out.push(format!("the peak is {peak:.2e} g: is the unit right?"));
    }
    out
}

fn derivative_peak(values: &[f64], dt: f64) -> f64 {
    crate::convert::derivative(values, dt).iter().fold(0.0, |m, x| m.max(x.abs()))
}

#[cfg(test)]
mod tests {
    use super::doubts;
    use crate::motion::Channel;
    use crate::series::Series;
    use crate::unit::unit;

    fn channel(amplitude: f64, dt: f64, n: usize) -> Channel {
        let raw: Vec<f64> = (0..n).map(|i| amplitude * (0.5 * i as f64).sin()).collect();
        let g = unit("g").expect("g");
        Channel { values: raw.iter().map(|x| g.factor * x).collect(), series: Series::new(raw), unit: g, dt }
    }

    #[test]
    fn usual_records_raise_no_doubt() {
        for (amplitude, dt, n) in [(0.3, 0.01, 2000), (2.9, 0.005, 100), (2e-4, 0.02, 100), (0.5, 0.1, 30_000)] {
            assert_eq!(doubts(&channel(amplitude, dt, n)), Vec::<String>::new(), "{amplitude} {dt} {n}");
        }
    }

    #[test]
    fn unusual_records_do() {
        for (amplitude, dt, n, said) in [
            (0.3, 10.0, 100, "the step"),
            (0.3, 0.1, 40_000, "takes"),
            (15.0, 0.01, 100, "as velocities"),
            (1e-6, 0.01, 100, "e-"),
        ] {
            let found = doubts(&channel(amplitude, dt, n));
            assert!(found.iter().any(|d| d.contains(said)), "{found:?}");
        }
    }
}
