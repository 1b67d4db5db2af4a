//! What a recording shows by itself: that it stays at its ends.
//!
//! A channel that saturates shows the same value for as long as what it measures is beyond. What moves turns back at its ends: of
//! its samples there few are equal, and not in a row.

use hysteron_identify::study::{Fit, Role, Run, Study};

/// Samples that are as equal as a file writes them, over the range of the channel.
const EQUAL: f64 = 1e-6;
/// So near the end, and not at it, a channel is seldom that stays there.
const NEAR: f64 = 5e-3;
/// Samples at the end, at least: of all, in a row, and over those that are near it.
const SAMPLES: usize = 6;
const IN_A_ROW: usize = 4;
const OVER_NEAR: usize = 2;
/// What the model shows meanwhile moves by this part of the range at least: a plateau of the motion is no matter of the channel.
const MOVES: f64 = 2e-3;

/// The least and the greatest value of a series, each where the series stays at it while the model moves.
pub(crate) fn ends(values: &[f64], model: &[f64]) -> [Option<f64>; 2] {
    let range = |x: &mut dyn Iterator<Item = f64>| {
        x.filter(|x| x.is_finite()).fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], x| [a.min(x), b.max(x)])
    };
    let [low, high] = range(&mut values.iter().copied());
    let size = high - low;
    if size.is_nan() || size <= 0.0 {
        return [None; 2];
    }
    [low, high].map(|end| {
        let off = |v: f64| (v - end).abs();
        let at: Vec<usize> = (0..values.len()).filter(|i| off(values[*i]) <= EQUAL * size).collect();
        let near = values.iter().filter(|v| off(**v) > EQUAL * size && off(**v) <= NEAR * size).count();
        let row = at.chunk_by(|i, j| j - i == 1).map(<[usize]>::len).max();
        let [least, most] = range(&mut at.iter().map(|i| model[*i]));
        let stays = at.len() >= SAMPLES.max(OVER_NEAR * near) && row >= Some(IN_A_ROW);
        (stays && most - least > MOVES * size).then_some(end)
    })
}

/// The same of a channel of the fitted runs, with their names; `fits` are the fitted runs as the model has them.
pub(crate) fn saturated<'a>(study: &'a Study, fits: &[Fit], channel: &str) -> Vec<(&'a Run, [Option<f64>; 2])> {
    let runs = study.runs_of(Role::Fit).map(|(_, r)| r).zip(fits);
    let of = |(r, fit): (&'a Run, &Fit)| {
        let c = r.observe.iter().position(|o| o.channel == channel)?;
        Some((r, ends(&r.observe[c].values, &fit.channels[c])))
    };
    runs.filter_map(of).filter(|(_, ends)| ends.iter().any(Option::is_some)).collect()
}

#[cfg(test)]
mod tests {
    use super::ends;
    use crate::residual::noise::tests::noise;

    fn wave(seed: u64, loud: f64) -> Vec<f64> {
        let noise = noise(seed, 1000);
        (0..1000)
            .map(|i| (0.03 * f64::from(i)).sin() * (1.0 + 1e-3 * f64::from(i)) + loud * noise[i as usize])
            .collect()
    }

    #[test]
    fn a_channel_that_saturates_is_seen() {
        for loud in [0.0, 0.02] {
            let (whole, model) = (wave(0, loud), wave(1, 0.0));
            assert_eq!(ends(&whole, &model), [None; 2]);
            let clipped = |low: f64, high: f64| whole.iter().map(|x| x.clamp(low, high)).collect::<Vec<f64>>();
            assert_eq!(ends(&clipped(-1.2, 1.1), &model), [Some(-1.2), Some(1.1)]);
            assert_eq!(ends(&clipped(-9.0, 1.1), &model), [None, Some(1.1)]);
            // With noise that comes after it, nothing is seen.
            let after: Vec<f64> = clipped(-1.2, 1.1).iter().zip(noise(7, 1000)).map(|(x, n)| x + 0.01 * n).collect();
            assert_eq!(ends(&after, &model), [None; 2]);
        }
    }

    #[test]
    fn neither_coarse_samples_nor_plateaus_of_the_motion_are_saturation() {
        let (whole, model) = (wave(0, 0.0), wave(1, 0.0));
        let coarse: Vec<f64> = whole.iter().map(|x| (x * 50.0).round() / 50.0).collect();
        assert_eq!(ends(&coarse, &model), [None; 2]);
        let held: Vec<f64> = whole.iter().map(|x| x.clamp(-1.2, 1.1)).collect();
        assert_eq!(ends(&held, &held), [None; 2]);
        assert_eq!(ends(&[1.0; 50], &[2.0; 50]), [None; 2]);
    }
}
