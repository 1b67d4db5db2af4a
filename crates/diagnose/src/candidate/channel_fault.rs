//! Faults of a sensor: the map from a simulated channel to the recorded one.

use serde::Serialize;

/// A fault of a channel, applied in the order delay, gain and offset, drift, clipping.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ChannelFault {
    /// Column of the recording.
    pub channel: String,
    /// Name of the affected run; none if all runs are.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub run: Option<String>,
    /// Factor on the true value.
    pub gain: f64,
    /// Constant added to it, in the unit of the channel.
    pub offset: f64,
    /// Delay, s.
    pub lag_s: f64,
    /// Points (s, unit of the channel) of an added polyline, constant beyond its ends.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub drift: Vec<[f64; 2]>,
    /// Least and greatest recorded value.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub clip: Option<[f64; 2]>,
}

impl ChannelFault {
    /// The identity.
    pub(crate) fn none(channel: &str, run: Option<&str>) -> Self {
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

    /// Returns true if the fault affects a channel of a run.
    pub(crate) fn affects(&self, run: &str, channel: &str) -> bool {
        self.channel == channel && self.run.as_deref().is_none_or(|r| r == run)
    }

    /// Drift at a time, in the unit of the channel.
    pub(crate) fn drift_at(&self, t: f64) -> f64 {
        polyline(&self.drift, t)
    }

    /// Replaces a signal by the recorded channel.
    pub(crate) fn apply(&self, times: &[f64], signal: &mut [f64]) {
        if self.lag_s != 0.0 {
            let late: Vec<f64> = times.iter().map(|t| cubic(times, signal, t - self.lag_s)).collect();
            signal.copy_from_slice(&late);
        }
        for (t, y) in times.iter().zip(signal) {
            *y = self.gain * *y + self.offset + polyline(&self.drift, *t);
            if let Some([low, high]) = self.clip {
                *y = y.clamp(low.min(high), high.max(low));
            }
        }
    }
}

/// Value of a polyline at a time; constant beyond its ends, 0 without points.
fn polyline(points: &[[f64; 2]], t: f64) -> f64 {
    let after = points.partition_point(|p| p[0] < t);
    match (after.checked_sub(1).and_then(|i| points.get(i)), points.get(after)) {
        (Some(a), Some(b)) => a[1] + (b[1] - a[1]) * (t - a[0]) / (b[0] - a[0]),
        (Some(a), None) => a[1],
        (None, Some(b)) => b[1],
        (None, None) => 0.0,
    }
}

/// Cubic interpolation of a sampled signal through the four samples around a time; constant beyond its ends.
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
    use super::ChannelFault;

    #[test]
    fn delay_gain_drift_and_clipping_are_applied_in_this_order() {
        let times: Vec<f64> = (0..200).map(|i| 0.01 * f64::from(i)).collect();
        let truth = |t: f64| (3.0 * t).sin();
        let mut y: Vec<f64> = times.iter().map(|t| truth(*t)).collect();
        let c = ChannelFault {
            gain: 2.0,
            offset: 0.1,
            lag_s: 0.025,
            drift: vec![[0.5, 0.0], [1.5, 1.0]],
            clip: Some([-1.0, 2.0]),
            ..ChannelFault::none("force", None)
        };
        c.apply(&times, &mut y);
        let expected = |t: f64| (2.0 * truth(t - 0.025) + 0.1 + (t - 0.5).clamp(0.0, 1.0)).clamp(-1.0, 2.0);
        for (t, y) in times.iter().zip(&y).skip(10) {
            assert!((y - expected(*t)).abs() < 1e-5, "{t}");
        }
    }
}
