//! Detection of cycles in a record.

use std::ops::Range;

/// Sides of the centre that a cycle reaches.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sides {
    /// Both sides, one after the other.
    Both,
    /// Above the centre only.
    Above,
    /// Below the centre only.
    Below,
}

/// A cycle: from the centre to one side, to the other side and back. A one-sided cycle returns without the other side.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Cycle {
    /// Samples of the cycle, both ends included. The last one is the first one of the next cycle.
    pub samples: Range<usize>,
    /// Sides that it reaches.
    pub sides: Sides,
    /// True if it begins and ends at the centre. A record may begin or end within a cycle.
    pub complete: bool,
}

/// Parameters of the detection of cycles.
///
/// A cycle ends where the displacement passes the centre. An excursion counts if it exceeds the threshold, so that noise
/// and holds about the centre make no cycles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CycleDetection {
    /// Centre of the cycles, in the unit of the displacement.
    pub centre: f64,
    /// Least amplitude of a cycle, as a share of the largest displacement from the centre. Smaller ones are noise.
    pub threshold: f64,
}

impl Default for CycleDetection {
    fn default() -> Self {
        Self { centre: 0.0, threshold: 0.02 }
    }
}

/// Samples on one side of the centre, at least one of them beyond the threshold.
struct Excursion {
    above: bool,
    /// Last sample before it on the other side or at the centre; `None` if the record begins within the excursion.
    start: Option<usize>,
    /// Last sample beyond the threshold.
    last: usize,
}

impl CycleDetection {
    /// The cycles of a record of displacements, in order.
    pub fn cycles(&self, u: &[f64]) -> Vec<Cycle> {
        let excursions = self.excursions(u);
        let mut cycles = vec![];
        let mut at = 0;
        while let Some(first) = excursions.get(at) {
            // An excursion that the record begins within is the end of a cycle.
            let second = excursions.get(at + 1).filter(|e| e.above != first.above && first.start.is_some());
            let last = second.unwrap_or(first);
            at += 1 + usize::from(second.is_some());
            let end = match excursions.get(at).and_then(|e| e.start) {
                Some(next) => Some(next),
                None => self.return_to_centre(u, last),
            };
            cycles.push(Cycle {
                samples: first.start.unwrap_or(0)..end.map_or(u.len(), |e| e + 1),
                sides: match second {
                    Some(_) => Sides::Both,
                    None if first.above => Sides::Above,
                    None => Sides::Below,
                },
                complete: first.start.is_some() && end.is_some(),
            });
        }
        cycles
    }

    /// Least distance from the centre of an excursion.
    fn min_distance(&self, u: &[f64]) -> f64 {
        self.threshold * u.iter().map(|u| (u - self.centre).abs()).fold(0.0, f64::max)
    }

    fn excursions(&self, u: &[f64]) -> Vec<Excursion> {
        let min_distance = self.min_distance(u);
        // Round-off about the centre is on neither side.
        let round_off = 1e-6 * min_distance;
        let mut all: Vec<Excursion> = vec![];
        // Last samples that are not above the centre, not below it, and close to it.
        let (mut not_above, mut not_below, mut close) = (None, None, None);
        for (i, x) in u.iter().map(|u| u - self.centre).enumerate() {
            if x <= round_off {
                not_above = Some(i);
            }
            if x >= -round_off {
                not_below = Some(i);
            }
            // Half of the threshold, so that noise about the threshold makes no excursions.
            let is_close_start = || i == 0 && (x.abs() <= min_distance || one_step_away(x, u.get(1), self.centre));
            if x.abs() <= 0.5 * min_distance || is_close_start() {
                close = Some(i);
            }
            if x.abs() <= min_distance || x.is_nan() {
                continue;
            }
            let above = x > 0.0;
            let before = all.last_mut();
            let since = |at: &usize| before.as_ref().is_none_or(|b| *at > b.last || b.above != above);
            let start = if above { not_above } else { not_below }.filter(since).or(close.filter(since));
            match before {
                Some(e) if e.above == above && start.is_none() => e.last = i,
                _ => all.push(Excursion { above, start, last: i }),
            }
        }
        all
    }

    /// The first sample at the centre after the last excursion, or the last sample if it is close to the centre.
    fn return_to_centre(&self, u: &[f64], last: &Excursion) -> Option<usize> {
        let back = |x: f64| if last.above { x <= 0.0 } else { x >= 0.0 };
        let crossed = (last.last..u.len()).find(|&i| back(u[i] - self.centre));
        let end = u.len().checked_sub(1)?;
        let x = u[end] - self.centre;
        let near = x.abs() <= self.min_distance(u) || end > 0 && one_step_away(x, u.get(end - 1), self.centre);
        crossed.or_else(|| near.then_some(end))
    }
}

/// Returns true if a record that begins or ends at the distance `x` from the centre lacks only the sample at the centre.
/// Recorders leave out the row at rest. `next` is the sample beside.
fn one_step_away(x: f64, next: Option<&f64>, centre: f64) -> bool {
    next.is_some_and(|n| {
        let step = n - centre - x;
        step * x > 0.0 && x.abs() <= 1.5 * step.abs()
    })
}

#[cfg(test)]
mod tests {
    use super::{CycleDetection, Sides};
    use std::f64::consts::TAU;

    /// Sine cycles of given amplitudes, with `steps` samples each.
    fn growing(amplitudes: &[f64], steps: usize) -> Vec<f64> {
        let wave = |i: usize| (TAU * i as f64 / steps as f64).sin();
        let mut u: Vec<f64> = amplitudes.iter().flat_map(|a| (0..steps).map(move |i| a * wave(i))).collect();
        u.push(0.0);
        u
    }

    /// Deterministic noise between -1 and 1.
    fn noise(i: usize) -> f64 {
        ((i as f64 * 12.9898).sin() * 43758.5453).fract()
    }

    #[test]
    fn cycles_of_growing_amplitudes_with_noise() {
        let amplitudes = [0.15, 0.15, 0.2, 0.3, 0.4, 0.5, 0.6];
        for level in [0.0, 0.005] {
            let u: Vec<f64> = growing(&amplitudes, 314).iter().enumerate().map(|(i, u)| u + level * noise(i)).collect();
            let cycles = CycleDetection::default().cycles(&u);
            assert_eq!(cycles.len(), amplitudes.len(), "noise {level}");
            for (k, (c, a)) in cycles.iter().zip(amplitudes).enumerate() {
                assert!(c.complete && c.sides == Sides::Both);
                assert!(c.samples.start.abs_diff(314 * k) <= 4, "{k}: {:?}", c.samples);
                let peak = u[c.samples.clone()].iter().fold(0.0f64, |m, u| m.max(*u));
                assert!((peak - a).abs() < 2.0 * level + 1e-3);
            }
            assert!(cycles.windows(2).all(|w| w[0].samples.end == w[1].samples.start + 1));
        }
    }

    #[test]
    fn incomplete_cycles_at_the_ends_of_a_record() {
        // A cosine begins at its peak and ends there.
        let u: Vec<f64> = (0..=300).map(|i| (TAU * i as f64 / 100.0).cos()).collect();
        let cycles = CycleDetection::default().cycles(&u);
        let seen: Vec<_> = cycles.iter().map(|c| (c.sides, c.complete)).collect();
        let both = |complete| (Sides::Both, complete);
        assert_eq!(seen, [(Sides::Above, false), both(true), both(true), both(false)]);
        // A recorder leaves out the row at rest.
        let u: Vec<f64> = (1..100).map(|i| (TAU * f64::from(i) / 50.0).sin()).collect();
        assert!(CycleDetection::default().cycles(&u).iter().all(|c| c.complete && c.sides == Sides::Both));
    }

    #[test]
    fn one_sided_cycles_with_holds() {
        let mut u = vec![];
        for a in [1.0, 2.0] {
            u.extend((0..10).map(|i| a * f64::from(i) / 10.0));
            u.extend(std::iter::repeat_n(a, 5));
            u.extend((0..10).rev().map(|i| a * f64::from(i) / 10.0));
            // The sensor does not return quite to zero.
            u.extend(std::iter::repeat_n(0.005, 7));
        }
        let cycles = CycleDetection::default().cycles(&u);
        assert!(cycles.iter().all(|c| c.sides == Sides::Above && c.complete));
        assert_eq!(cycles.len(), 2);
        // The hold at the centre belongs to the cycle before it.
        assert_eq!(cycles[0].samples.end, cycles[1].samples.start + 1);
    }

    #[test]
    fn shifted_centre_and_records_without_cycles() {
        let u: Vec<f64> = growing(&[0.1, 0.2], 100).iter().map(|u| u - 3.0).collect();
        assert_eq!(CycleDetection { centre: -3.0, ..CycleDetection::default() }.cycles(&u).len(), 2);
        for none in [&[][..], &[0.0; 5][..], &[f64::NAN; 3][..]] {
            assert!(CycleDetection::default().cycles(none).is_empty());
        }
    }
}
