//! Windows of time in which a model differs from a recording, and the motion within them.

use super::result_file::Mismatch;
use crate::inspect::response::ResponseRanges;
use hysteron_identify::study::{Role, ScoredRun, Study};

/// Windows that contain most of a squared error.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct ErrorWindows {
    /// Beginnings and ends, s.
    pub(super) windows: Vec<[f64; 2]>,
    /// Share of the squared error within them.
    pub(super) share: f64,
}

/// Share of the square that the windows contain at least.
const MIN_WINDOW_SHARE: f64 = 0.8;
/// Least square of an effect over that of the error for which the effect locates the error.
const MIN_EFFECT_SHARE: f64 = 0.1;
/// Samples below which no windows are sought.
const MIN_SAMPLES: usize = 10;
/// Divisor of the number of samples that gives half the smoothing window.
const SMOOTHING_DIVISOR: usize = 100;
/// Half smoothing windows up to which two windows are joined.
const JOINED_HALF_WINDOWS: usize = 4;

/// The shortest windows that contain [`MIN_WINDOW_SHARE`] of a squared error.
///
/// The `effect`, which is the error without its noise, locates the windows where it is a fair part of the error. The square is
/// smoothed over a fiftieth of the record. All series are in the unit of the channel; samples that are not finite count as 0.
pub(super) fn find_windows(times: &[f64], error: &[f64], effect: Option<&[f64]>) -> ErrorWindows {
    let n = times.len();
    let squares = |x: &[f64]| x.iter().map(|r| if r.is_finite() { r * r } else { 0.0 }).collect::<Vec<f64>>();
    let sum = |x: &[f64]| x.iter().sum::<f64>();
    let of_error = squares(error);
    let of_effect = effect.map(squares).filter(|s| sum(s) > MIN_EFFECT_SHARE * sum(&of_error));
    let square = of_effect.unwrap_or_else(|| of_error.clone());
    let total = sum(&square);
    if n < MIN_SAMPLES || total <= 0.0 {
        return ErrorWindows { windows: vec![], share: 0.0 };
    }
    let half = (n / SMOOTHING_DIVISOR).max(2);
    let mut cumulative = vec![0.0; n + 1];
    for i in 0..n {
        cumulative[i + 1] = cumulative[i] + square[i];
    }
    let smooth: Vec<f64> = (0..n)
        .map(|i| {
            let (a, b) = (i.saturating_sub(half), (i + half + 1).min(n));
            (cumulative[b] - cumulative[a]) / (b - a) as f64
        })
        .collect();
    let mut order: Vec<usize> = (0..n).collect();
    order.sort_by(|a, b| smooth[*b].total_cmp(&smooth[*a]));
    let (mut inside, mut contained) = (vec![false; n], 0.0);
    for i in order {
        if contained >= MIN_WINDOW_SHARE * total {
            break;
        }
        inside[i] = true;
        contained += square[i];
    }
    let mut out: Vec<(usize, usize)> = vec![];
    for i in (0..n).filter(|i| inside[*i]) {
        match out.last_mut() {
            Some((_, end)) if i - *end <= JOINED_HALF_WINDOWS * half => *end = i,
            _ => out.push((i, i)),
        }
    }
    let within: f64 = out.iter().map(|(a, b)| sum(&of_error[*a..=*b])).sum();
    let share = within / sum(&of_error).max(f64::MIN_POSITIVE);
    ErrorWindows { windows: out.into_iter().map(|(a, b)| [times[a], times[b]]).collect(), share }
}

/// Length of the windows over that of the run from which the error is everywhere.
const THROUGHOUT: f64 = 0.75;
/// Time after a new largest deformation that still belongs to it, in parts of the run.
const FIRST_REACH: f64 = 0.03;
/// Deformation over the largest one that counts as large.
const LARGE_DEFORMATION: f64 = 0.7;
/// Shares of the samples within the windows from which these two regimes are named.
const MIN_FIRST_SHARE: f64 = 0.6;
const MIN_LARGE_SHARE: f64 = 0.5;
/// Mean time of the windows up to which they are early and from which they are late, in parts of the run.
const EARLY: f64 = 0.35;
const LATE: f64 = 0.65;

/// The motion within windows, in words. `deformation` is sampled at `times`.
pub(super) fn regime(times: &[f64], windows: &ErrorWindows, deformation: &[f64]) -> String {
    let within = |t: f64| windows.windows.iter().any(|w| (w[0]..=w[1]).contains(&t));
    let length: f64 = windows.windows.iter().map(|w| w[1] - w[0]).sum();
    let (begin, end) = (times.first().copied().unwrap_or(0.0), times.last().copied().unwrap_or(0.0));
    if length > THROUGHOUT * (end - begin) {
        return "throughout the run".into();
    }
    let (mut largest, mut reached_at) = (0.0f64, 0.0f64);
    let (mut first, mut large, mut count) = (0usize, 0usize, 0usize);
    let peak = deformation.iter().filter(|x| x.is_finite()).fold(0.0f64, |m, x| m.max(x.abs()));
    for (t, x) in times.iter().zip(deformation).filter(|(_, x)| x.is_finite()) {
        if x.abs() > largest {
            largest = x.abs();
            reached_at = *t;
        }
        if within(*t) {
            count += 1;
            first += usize::from(t - reached_at < FIRST_REACH * (end - begin));
            large += usize::from(x.abs() > LARGE_DEFORMATION * peak);
        }
    }
    if count == 0 {
        return "nowhere in particular".into();
    }
    let share = |n: usize| n as f64 / count as f64;
    let moment = windows.windows.iter().map(|w| 0.5 * (w[0] + w[1]) * (w[1] - w[0])).sum::<f64>();
    let middle = moment / length.max(1e-300);
    if share(first) > MIN_FIRST_SHARE {
        "while a deformation is reached for the first time".into()
    } else if share(large) > MIN_LARGE_SHARE {
        "at large deformation".into()
    } else if middle > begin + LATE * (end - begin) {
        "late in the run".into()
    } else if middle < begin + EARLY * (end - begin) {
        "early in the run".into()
    } else {
        "in parts of the run".into()
    }
}

/// Errors of the baseline in the fitted runs, the largest NMSE first. A named repair separates the effect from the noise.
pub(super) fn mismatches(
    study: &Study,
    responses: &ResponseRanges,
    baseline_fits: &[Option<ScoredRun>],
    repaired_fits: Option<&Vec<Option<ScoredRun>>>,
) -> Vec<Mismatch> {
    let mut all: Vec<(f64, Mismatch)> = vec![];
    for (number, run) in study.runs_of(Role::Fit) {
        let Some(f) = &baseline_fits[number] else { continue };
        let first_history = responses.histories.iter().find(|((r, _, _), _)| *r == number);
        let motion = first_history.map(|(_, h)| h.deformation.clone());
        let repaired = repaired_fits.and_then(|r| r[number].as_ref());
        for (channel, ((o, y), s)) in run.observe.iter().zip(&f.channels).zip(&f.scores).enumerate() {
            let times = &run.recording.times;
            let difference = |from: &[f64]| -> Vec<f64> { y.iter().zip(from).map(|(y, v)| y - v).collect() };
            let effect = repaired.map(|r| difference(&r.channels[channel]));
            let found = find_windows(times, &difference(&o.values), effect.as_deref());
            let regime = regime(times, &found, motion.as_ref().unwrap_or(&o.values));
            let mismatch = Mismatch {
                run: run.name.clone(),
                channel: o.channel.clone(),
                at: o.at.clone(),
                windows: found.windows,
                share: found.share,
                regime,
            };
            all.push((s.nmse, mismatch));
        }
    }
    all.sort_by(|a, b| b.0.total_cmp(&a.0));
    all.into_iter().map(|(_, m)| m).collect()
}

#[cfg(test)]
mod tests {
    use super::find_windows;
    use crate::test_support::white_noise;

    #[test]
    fn a_burst_is_found() {
        let times: Vec<f64> = (0..2000).map(|i| 0.01 * f64::from(i)).collect();
        let r: Vec<f64> = times.iter().map(|t| if (12.0..15.0).contains(t) { 1.0 } else { 0.02 }).collect();
        let w = find_windows(&times, &r, None);
        assert_eq!(w.windows.len(), 1);
        assert!((w.windows[0][0] - 12.0).abs() < 0.5 && (w.windows[0][1] - 15.0).abs() < 0.6, "{w:?}");
        assert!(w.share > 0.75);
    }

    #[test]
    fn a_strong_effect_locates_the_error_and_a_weak_one_does_not() {
        let times: Vec<f64> = (0..2000).map(|i| 0.01 * f64::from(i)).collect();
        let effect: Vec<f64> = times.iter().map(|t| if (12.0..15.0).contains(t) { 1.0 } else { 0.0 }).collect();
        let error: Vec<f64> = effect.iter().zip(white_noise(3, 2000)).map(|(e, n)| e + n).collect();
        let length = |effect| find_windows(&times, &error, effect).windows.iter().map(|w| w[1] - w[0]).sum::<f64>();
        assert!(length(None) > 6.0 && (2.0..4.0).contains(&length(Some(&effect))));
        let weak: Vec<f64> = effect.iter().map(|e| 0.1 * e).collect();
        assert_eq!(find_windows(&times, &error, Some(&weak)), find_windows(&times, &error, None));
    }
}
