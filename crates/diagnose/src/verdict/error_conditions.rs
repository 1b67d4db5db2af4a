//! Errors over the conditions of the motion: its amplitude, its rate and the temperature.

use hysteron_identify::study::Recording;

/// Intervals of a condition.
const INTERVALS: usize = 10;
/// Least number of samples in an interval whose error is shown.
const MIN_SAMPLES: usize = 8;

/// A condition at each sample.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Condition {
    /// Name with its unit.
    pub(super) label: String,
    /// Value at each sample; NaN for none.
    pub(super) values: Vec<f64>,
}

/// Amplitude and rate of a motion, which has a name with its unit, and the temperatures of a recording.
pub(super) fn conditions(recording: &Recording, name: &str, motion: &[f64]) -> Vec<Condition> {
    let times = &recording.times;
    let n = motion.len().min(times.len());
    let rate = |i: usize| {
        let (a, b) = (i.saturating_sub(1), (i + 1).min(n - 1));
        ((motion[b] - motion[a]) / (times[b] - times[a])).abs()
    };
    let mut out = vec![
        Condition { label: format!("size of {name}"), values: motion[..n].iter().map(|x| x.abs()).collect() },
        Condition { label: format!("rate of {name}, per s"), values: (0..n).map(rate).collect() },
    ];
    let temperatures = recording.columns.iter().filter(|c| c.name.to_lowercase().contains("temp"));
    out.extend(temperatures.map(|c| Condition { label: c.name.clone(), values: c.values.clone() }));
    out
}

/// Root mean square error in intervals of a condition: middle and error of each.
pub(super) fn error_over(condition: &[f64], error: &[f64]) -> Vec<(f64, f64)> {
    let known = || condition.iter().zip(error).filter(|(c, e)| c.is_finite() && e.is_finite());
    let (low, high) = known().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), (c, _)| (a.min(*c), b.max(*c)));
    let width = (high - low) / INTERVALS as f64;
    if width.is_nan() || width <= 0.0 {
        return vec![];
    }
    let mut sums = [(0usize, 0.0f64); INTERVALS];
    for (c, e) in known() {
        let (count, sum) = &mut sums[(((c - low) / width) as usize).min(INTERVALS - 1)];
        (*count, *sum) = (*count + 1, *sum + e * e);
    }
    let middle = |i: usize| low + (i as f64 + 0.5) * width;
    let shown = sums.iter().enumerate().filter(|(_, (count, _))| *count >= MIN_SAMPLES);
    shown.map(|(i, (count, sum))| (middle(i), (sum / *count as f64).sqrt())).collect()
}

#[cfg(test)]
mod tests {
    use super::error_over;

    #[test]
    fn errors_are_gathered_in_intervals_and_few_samples_are_left_out() {
        let condition: Vec<f64> = (0..200).map(|i| f64::from(i % 100) / 99.0).collect();
        let error: Vec<f64> = condition.iter().map(|c| if *c > 0.5 { -2.0 } else { 1.0 }).collect();
        let over = error_over(&condition, &error);
        assert_eq!(over.len(), 10);
        assert!(over.iter().all(|(c, e)| *e == if *c > 0.5 { 2.0 } else { 1.0 }), "{over:?}");
        let one_far = [vec![10.0], vec![0.0; 50]].concat();
        assert_eq!(error_over(&one_far, &vec![1.0; 51]).len(), 1);
        assert!(error_over(&[1.0; 20], &[1.0; 20]).is_empty());
    }
}
