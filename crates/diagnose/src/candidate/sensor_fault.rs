//! Faults of a sensor: how the simulated channel becomes the recorded one.

use serde::Serialize;

/// A fault of a channel: lag first, then gain and offset, then drift, then clip.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Correction {
    /// Column of the recording.
    pub channel: String,
    /// The run that it holds for; all where there is none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub run: Option<String>,
    /// Factor on the true value.
    pub gain: f64,
    /// Added to it, in the unit of the channel.
    pub offset: f64,
    /// Seconds by which the channel is late.
    pub lag_s: f64,
    /// Points (s, unit of the channel) of a line that is added, constant beyond its ends.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub drift: Vec<[f64; 2]>,
    /// Least and greatest value that the channel shows.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub clip: Option<[f64; 2]>,
}

impl Correction {
    /// No fault.
    pub fn none(channel: &str, run: Option<&str>) -> Self {
        Self {
            channel: channel.into(),
            run: run.map(Into::into),
            gain: 1.0,
            offset: 0.0,
            lag_s: 0.0,
            drift: vec![],
            clip: None,
        }
    }

    /// Whether it concerns a channel of a run.
    pub fn concerns(&self, run: &str, channel: &str) -> bool {
        self.channel == channel && self.run.as_deref().is_none_or(|r| r == run)
    }

    /// What its zero has drifted by at a time.
    pub fn drift_at(&self, t: f64) -> f64 {
        line(&self.drift, t)
    }

    /// What the faulty channel shows of a signal.
    pub fn apply(&self, times: &[f64], signal: &mut [f64]) {
        if self.lag_s != 0.0 {
            let late: Vec<f64> = times.iter().map(|t| cubic(times, signal, t - self.lag_s)).collect();
            signal.copy_from_slice(&late);
        }
        for (t, y) in times.iter().zip(signal) {
            *y = self.gain * *y + self.offset + line(&self.drift, *t);
            if let Some([low, high]) = self.clip {
                *y = y.clamp(low.min(high), high.max(low));
            }
        }
    }
}

/// A line through points at a time; constant beyond its ends, zero without points.
fn line(points: &[[f64; 2]], t: f64) -> f64 {
    let after = points.partition_point(|p| p[0] < t);
    match (after.checked_sub(1).and_then(|i| points.get(i)), points.get(after)) {
        (Some(a), Some(b)) => a[1] + (b[1] - a[1]) * (t - a[0]) / (b[0] - a[0]),
        (Some(a), None) => a[1],
        (None, Some(b)) => b[1],
        (None, None) => 0.0,
    }
}

/// A sampled signal at a time, by the cubic through the four samples around it; its first and last value beyond.
fn cubic(times: &[f64], y: &[f64], t: f64) -> f64 {
    let n = times.len();
    let i = times.partition_point(|x| *x <= t);
    if i == 0 {
        return y[0];
    }
    if i == n {
        return y[n - 1];
    }
    let from = i.saturating_sub(2).min(n.saturating_sub(4));
    let to = (from + 4).min(n);
    // Lagrange's form.
    (from..to)
        .map(|k| {
            let weight: f64 = (from..to).filter(|j| *j != k).map(|j| (t - times[j]) / (times[k] - times[j])).product();
            weight * y[k]
        })
        .sum()
}

#[cfg(test)]
mod tests {
    use super::Correction;

    #[test]
    fn faults_are_applied_in_their_order() {
        let times: Vec<f64> = (0..200).map(|i| 0.01 * f64::from(i)).collect();
        let truth = |t: f64| (3.0 * t).sin();
        let mut y: Vec<f64> = times.iter().map(|t| truth(*t)).collect();
        let c = Correction {
            gain: 2.0,
            offset: 0.1,
            lag_s: 0.025,
            drift: vec![[0.5, 0.0], [1.5, 1.0]],
            clip: Some([-1.0, 2.0]),
            ..Correction::none("force", None)
        };
        c.apply(&times, &mut y);
        let expected = |t: f64| (2.0 * truth(t - 0.025) + 0.1 + (t - 0.5).clamp(0.0, 1.0)).clamp(-1.0, 2.0);
        for (t, y) in times.iter().zip(&y).skip(10) {
            assert!((y - expected(*t)).abs() < 1e-5, "{t}");
        }
    }
}
