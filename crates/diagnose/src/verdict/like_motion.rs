//! Fitted runs of like motion: a difference between their recordings is none of amplitude or rate.

use super::all_runs::displacements;
use super::conclusion::ConclusionContext;
use crate::prior::{LIKE_MOTION, LIKE_MOTION_DEVICE};
use crate::series::{centred, power};
use std::collections::BTreeMap;

/// Sizes of the motions of each run by tag and direction: of the devices in translation, or of one displacement where no device
/// has a deformation.
#[derive(Debug, Default)]
pub(super) struct RunMotions(Vec<BTreeMap<(i32, usize), MotionSize>>);

/// Size of a motion, r.m.s. about its mean.
#[derive(Clone, Copy, Debug)]
struct MotionSize {
    /// Length.
    deformation: f64,
    /// Length/s.
    rate: f64,
}

/// Key of a displacement that is that of no device.
const WITHOUT_DEVICE: (i32, usize) = (0, 0);

impl RunMotions {
    /// Motions of all runs of the user's model at its values.
    pub(super) fn of(c: &ConclusionContext<'_>, values: &[f64]) -> Self {
        let mut runs = vec![BTreeMap::new(); c.study.runs.len()];
        for ((run, tag, direction), h) in c.responses.histories.iter().filter(|((.., d), _)| *d <= 3) {
            runs[*run].insert((*tag, *direction), MotionSize::of(&h.times, &h.deformation));
        }
        if runs.iter().all(BTreeMap::is_empty) {
            for (run, displacement) in displacements(c, values).into_iter().enumerate() {
                let size = displacement.map(|(_, u)| MotionSize::of(&c.study.runs[run].recording.times, &u));
                runs[run].extend(size.map(|size| (WITHOUT_DEVICE, size)));
            }
        }
        Self(runs)
    }

    /// Returns true if two runs have motions of one size. They need not begin at one time.
    pub(super) fn are_alike(&self, a: usize, b: usize) -> bool {
        let (Some(a), Some(b)) = (self.0.get(a), self.0.get(b)) else { return false };
        let largest = a.values().chain(b.values()).map(|m| m.deformation).fold(0.0, f64::max);
        let pairs = a.iter().filter_map(|(key, own)| Some((own, b.get(key)?)));
        let moves = |m: &MotionSize| m.deformation > LIKE_MOTION_DEVICE * largest;
        let mut moving = pairs.filter(|(own, other)| moves(own) || moves(other)).peekable();
        moving.peek().is_some() && moving.all(|(own, other)| own.is_like(*other))
    }
}

impl MotionSize {
    fn of(times: &[f64], u: &[f64]) -> Self {
        let rates = times.windows(2).zip(u.windows(2)).map(|(t, u)| (u[1] - u[0]) / (t[1] - t[0]));
        Self { deformation: deviation(u.iter().copied()), rate: deviation(rates) }
    }

    fn is_like(self, other: Self) -> bool {
        let close = |a: f64, b: f64| (a - b).abs() <= LIKE_MOTION * a.max(b);
        close(self.deformation, other.deformation) && close(self.rate, other.rate)
    }
}

/// Standard deviation of the finite values.
fn deviation(values: impl Iterator<Item = f64>) -> f64 {
    power(&centred(values.filter(|x| x.is_finite()).collect())).sqrt()
}

#[cfg(test)]
mod tests {
    use super::{MotionSize, RunMotions};

    /// Size of a sine of an amplitude, frequency in Hz and phase.
    fn sine(amplitude: f64, frequency: f64, phase: f64) -> MotionSize {
        let times: Vec<f64> = (0..400).map(|i| 0.01 * f64::from(i)).collect();
        let at = |t: &f64| amplitude * (2.0 * std::f64::consts::PI * frequency * t + phase).sin();
        MotionSize::of(&times, &times.iter().map(at).collect::<Vec<_>>())
    }

    #[test]
    fn amplitude_and_rate_make_a_motion_not_its_phase() {
        let with = |second: MotionSize| {
            let runs = [sine(10.0, 1.0, 0.0), second].map(|m| [((1, 1), m)].into());
            RunMotions(runs.to_vec()).are_alike(0, 1)
        };
        assert!(with(sine(10.3, 1.0, 2.0)));
        assert!(!with(sine(12.0, 1.0, 0.0)));
        assert!(!with(sine(10.0, 2.0, 0.0)));
        assert!(!RunMotions(vec![[].into(), [].into()]).are_alike(0, 1));
    }
}
