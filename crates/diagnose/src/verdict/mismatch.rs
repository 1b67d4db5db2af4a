//! Where a mismatch lies: windows of time, and the regime in words.

/// Windows of a residual that hold most of its square.
#[derive(Clone, Debug, PartialEq)]
pub struct Windows {
    /// Beginnings and ends, in seconds of the recording.
    pub windows: Vec<[f64; 2]>,
    /// Part of the squared error within them.
    pub share: f64,
}

/// Part of the square that the windows shall hold.
const MOST: f64 = 0.8;

/// An effect with at least this part of the square of the error tells where it is (a choice).
const TELLS: f64 = 0.1;

/// The fewest stretches of time that hold most of the square of the `error` of a model, or of what is known of it without its noise,
/// its `effect`, where that is a fair part of it. The square is smoothed over a window of a fiftieth of the record; what stands
/// above a level belongs to a window, the level chosen so that [`MOST`] of the square does. All in the unit of the channel; samples
/// that are not finite count nothing.
pub fn windows(times: &[f64], error: &[f64], effect: Option<&[f64]>) -> Windows {
    let n = times.len();
    let squares = |x: &[f64]| x.iter().map(|r| if r.is_finite() { r * r } else { 0.0 }).collect::<Vec<f64>>();
    let sum = |x: &[f64]| x.iter().sum::<f64>();
    let of_error = squares(error);
    let square = effect.map(squares).filter(|s| sum(s) > TELLS * sum(&of_error)).unwrap_or_else(|| of_error.clone());
    let total = sum(&square);
    if n < 10 || total <= 0.0 {
        return Windows { windows: vec![], share: 0.0 };
    }
    let half = (n / 100).max(2);
    let mut sums = vec![0.0; n + 1];
    for i in 0..n {
        sums[i + 1] = sums[i] + square[i];
    }
    let smooth: Vec<f64> = (0..n)
        .map(|i| {
            let (a, b) = (i.saturating_sub(half), (i + half + 1).min(n));
            (sums[b] - sums[a]) / (b - a) as f64
        })
        .collect();
    let mut order: Vec<usize> = (0..n).collect();
    order.sort_by(|a, b| smooth[*b].total_cmp(&smooth[*a]));
    let (mut inside, mut held) = (vec![false; n], 0.0);
    for i in order {
        if held >= MOST * total {
            break;
        }
        inside[i] = true;
        held += square[i];
    }
    // Stretches closer than two smoothing windows are one.
    let mut out: Vec<(usize, usize)> = vec![];
    for i in (0..n).filter(|i| inside[*i]) {
        match out.last_mut() {
            Some((_, end)) if i - *end <= 4 * half => *end = i,
            _ => out.push((i, i)),
        }
    }
    let within: f64 = out.iter().map(|(a, b)| sum(&of_error[*a..=*b])).sum();
    let share = within / sum(&of_error).max(f64::MIN_POSITIVE);
    Windows { windows: out.into_iter().map(|(a, b)| [times[a], times[b]]).collect(), share }
}

/// What the motion is like where the error is, in words.
pub fn regime(times: &[f64], windows: &Windows, e: &[f64]) -> String {
    let within = |t: f64| windows.windows.iter().any(|w| (w[0]..=w[1]).contains(&t));
    let length: f64 = windows.windows.iter().map(|w| w[1] - w[0]).sum();
    let (begin, end) = (times.first().copied().unwrap_or(0.0), times.last().copied().unwrap_or(0.0));
    if length > 0.75 * (end - begin) {
        return "throughout the run".into();
    }
    let (mut largest, mut reached, mut first, mut large, mut count) = (0.0f64, 0.0f64, 0usize, 0usize, 0usize);
    let peak = e.iter().filter(|x| x.is_finite()).fold(0.0f64, |m, x| m.max(x.abs()));
    for (t, x) in times.iter().zip(e).filter(|(_, x)| x.is_finite()) {
        // Within the cycle that makes a new largest deformation.
        if x.abs() > largest {
            largest = x.abs();
            reached = *t;
        }
        if within(*t) {
            count += 1;
            first += usize::from(t - reached < 0.03 * (end - begin));
            large += usize::from(x.abs() > 0.7 * peak);
        }
    }
    if count == 0 {
        return "nowhere in particular".into();
    }
    let part = |n: usize| n as f64 / count as f64;
    let middle = windows.windows.iter().map(|w| 0.5 * (w[0] + w[1]) * (w[1] - w[0])).sum::<f64>() / length.max(1e-300);
    if part(first) > 0.6 {
        "while a deformation is reached for the first time".into()
    } else if part(large) > 0.5 {
        "at large deformation".into()
    } else if middle > begin + 0.65 * (end - begin) {
        "late in the run".into()
    } else if middle < begin + 0.35 * (end - begin) {
        "early in the run".into()
    } else {
        "in parts of the run".into()
    }
}

#[cfg(test)]
mod tests {
    use super::windows;
    use crate::residual::noise::tests::noise;

    #[test]
    fn a_burst_is_found() {
        let times: Vec<f64> = (0..2000).map(|i| 0.01 * f64::from(i)).collect();
        let r: Vec<f64> = times.iter().map(|t| if (12.0..15.0).contains(t) { 1.0 } else { 0.02 }).collect();
        let w = windows(&times, &r, None);
        assert_eq!(w.windows.len(), 1);
        assert!((w.windows[0][0] - 12.0).abs() < 0.5 && (w.windows[0][1] - 15.0).abs() < 0.6, "{w:?}");
        assert!(w.share > 0.75);
    }

    #[test]
    fn an_effect_is_found_in_noise_and_one_that_is_none_says_nothing() {
        let times: Vec<f64> = (0..2000).map(|i| 0.01 * f64::from(i)).collect();
        let effect: Vec<f64> = times.iter().map(|t| if (12.0..15.0).contains(t) { 1.0 } else { 0.0 }).collect();
        let error: Vec<f64> = effect.iter().zip(noise(3, 2000)).map(|(e, n)| e + n).collect();
        let length = |effect| windows(&times, &error, effect).windows.iter().map(|w| w[1] - w[0]).sum::<f64>();
        assert!(length(None) > 6.0 && (2.0..4.0).contains(&length(Some(&effect))));
        let little: Vec<f64> = effect.iter().map(|e| 0.1 * e).collect();
        assert_eq!(windows(&times, &error, Some(&little)), windows(&times, &error, None));
    }
}
