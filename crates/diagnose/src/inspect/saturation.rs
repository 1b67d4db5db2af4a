//! Saturation that a recording shows by itself.
//!
//! A saturated channel repeats its end value while the measured quantity is beyond it. A quantity that turns back at its
//! end has few equal samples there, and none in a row.

use crate::prior::{
    EQUAL_SAMPLES, MIN_MOTION_WHILE_SATURATED, MIN_SATURATED_IN_A_ROW, MIN_SATURATED_OVER_NEAR, MIN_SATURATED_SAMPLES,
    NEAR_END,
};
use hysteron_identify::study::{Role, Run, ScoredRun, Study};

/// Least and greatest value of a series, each only if the series saturates there while the `model` moves.
pub(crate) fn saturated_levels(values: &[f64], model: &[f64]) -> [Option<f64>; 2] {
    let range = |x: &mut dyn Iterator<Item = f64>| {
        x.filter(|x| x.is_finite()).fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], x| [a.min(x), b.max(x)])
    };
    let [low, high] = range(&mut values.iter().copied());
    let size = high - low;
    if size.is_nan() || size <= 0.0 {
        return [None; 2];
    }
    // Samples of a coarse recording are equal while the quantity moves by a step of it.
    let moved = (MIN_MOTION_WHILE_SATURATED * size).max(COARSE_STEPS * step_of_recording(values, EQUAL_SAMPLES * size));
    [low, high].map(|end| {
        let distance = |v: f64| (v - end).abs();
        let at: Vec<usize> = (0..values.len()).filter(|i| distance(values[*i]) <= EQUAL_SAMPLES * size).collect();
        let near =
            values.iter().filter(|v| distance(**v) > EQUAL_SAMPLES * size && distance(**v) <= NEAR_END * size).count();
        let longest_row = at.chunk_by(|i, j| j - i == 1).map(<[usize]>::len).max();
        let [least, most] = range(&mut at.iter().map(|i| model[*i]));
        let stays = at.len() >= MIN_SATURATED_SAMPLES.max(MIN_SATURATED_OVER_NEAR * near)
            && longest_row >= Some(MIN_SATURATED_IN_A_ROW);
        (stays && most - least > moved).then_some(end)
    })
}

/// Steps of a coarse recording within which the model may move while samples are equal: one of rounding at each end.
const COARSE_STEPS: f64 = 2.0;

/// Least difference between samples that differ by more than `equal`: the step of a coarse recording, hardly more than zero
/// otherwise.
fn step_of_recording(values: &[f64], equal: f64) -> f64 {
    let mut sorted: Vec<f64> = values.iter().copied().filter(|x| x.is_finite()).collect();
    sorted.sort_by(f64::total_cmp);
    let differences = sorted.windows(2).map(|w| w[1] - w[0]).filter(|d| *d > equal);
    let step = differences.fold(f64::INFINITY, f64::min);
    if step.is_finite() { step } else { 0.0 }
}

/// Fitted runs in which a channel saturates, with its levels. `fits` are the fitted runs of the model, in their order.
pub(crate) fn saturated_runs<'a>(
    study: &'a Study,
    fits: &[ScoredRun],
    channel: &str,
) -> Vec<(&'a Run, [Option<f64>; 2])> {
    let runs = study.runs_of(Role::Fit).map(|(_, r)| r).zip(fits);
    let of = |(r, fit): (&'a Run, &ScoredRun)| {
        let c = r.observe.iter().position(|o| o.channel == channel)?;
        Some((r, saturated_levels(&r.observe[c].values, &fit.channels[c])))
    };
    runs.filter_map(of).filter(|(_, levels)| levels.iter().any(Option::is_some)).collect()
}

#[cfg(test)]
mod tests {
    use super::saturated_levels;
    use crate::test_support::white_noise;

    fn wave(seed: u64, noise_level: f64) -> Vec<f64> {
        let noise = white_noise(seed, 1000);
        (0..1000)
            .map(|i| (0.03 * f64::from(i)).sin() * (1.0 + 1e-3 * f64::from(i)) + noise_level * noise[i as usize])
            .collect()
    }

    #[test]
    fn a_saturated_channel_is_found() {
        for noise_level in [0.0, 0.02] {
            let (unclipped, model) = (wave(0, noise_level), wave(1, 0.0));
            assert_eq!(saturated_levels(&unclipped, &model), [None; 2]);
            let clipped = |low: f64, high: f64| unclipped.iter().map(|x| x.clamp(low, high)).collect::<Vec<f64>>();
            assert_eq!(saturated_levels(&clipped(-1.2, 1.1), &model), [Some(-1.2), Some(1.1)]);
            assert_eq!(saturated_levels(&clipped(-9.0, 1.1), &model), [None, Some(1.1)]);
            // Noise added after saturation hides it.
            let after: Vec<f64> =
                clipped(-1.2, 1.1).iter().zip(white_noise(7, 1000)).map(|(x, n)| x + 0.01 * n).collect();
            assert_eq!(saturated_levels(&after, &model), [None; 2]);
        }
    }

    #[test]
    fn coarse_samples_and_plateaus_of_the_motion_are_no_saturation() {
        let (unclipped, model) = (wave(0, 0.0), wave(1, 0.0));
        let coarse: Vec<f64> = unclipped.iter().map(|x| (x * 50.0).round() / 50.0).collect();
        assert_eq!(saturated_levels(&coarse, &model), [None; 2]);
        // Steady cycles of a coarse recording stay at its last step for a while.
        let steady: Vec<f64> = (0..1000).map(|i| (0.13 * f64::from(i)).sin()).collect();
        let coarse: Vec<f64> = steady.iter().map(|x| (x * 21.0).round() / 21.0).collect();
        assert_eq!(saturated_levels(&coarse, &steady), [None; 2]);
        let clipped: Vec<f64> = coarse.iter().map(|x| x.clamp(-9.0, 0.7)).collect();
        assert!(saturated_levels(&clipped, &steady)[1].is_some());
        let held: Vec<f64> = unclipped.iter().map(|x| x.clamp(-1.2, 1.1)).collect();
        assert_eq!(saturated_levels(&held, &held), [None; 2]);
        assert_eq!(saturated_levels(&[1.0; 50], &[2.0; 50]), [None; 2]);
    }
}
