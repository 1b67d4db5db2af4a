//! Faults of channels as sentences with their corrections.

use super::quantity::{digits, duration};
use crate::candidate::channel_fault::ChannelFault;
use hysteron_identify::study::Study;

/// Cause that a fault of a channel stands for; `None` for no fault.
pub(super) fn cause_of(f: &ChannelFault) -> Option<&'static str> {
    let of = [
        (f.gain != 1.0, "sensor_gain"),
        (f.lag_s != 0.0, "sensor_lag"),
        (!f.drift.is_empty(), "sensor_drift"),
        (f.clip.is_some(), "sensor_clipping"),
    ];
    of.into_iter().find(|(is, _)| *is).map(|(_, cause)| cause)
}

/// Unit of an observed channel; empty if it is not known.
pub(super) fn unit_of<'a>(study: &'a Study, channel: &str) -> &'a str {
    let observed = study.runs.iter().flat_map(|r| &r.observe).find(|o| o.channel == channel);
    observed.map_or("", |o| o.unit.as_str())
}

/// A level is open if it is this many times as far from zero as the other.
const OPEN_LEVEL: f64 = 5.0;
/// Time between two points of a drift from which it is a slope, s.
const SLOPE_LENGTH: f64 = 9e3;

/// A fault of a channel as a sentence with its correction.
pub(super) fn fault_in_words(f: &ChannelFault, unit: &str) -> String {
    let in_run = f.run.as_ref().map_or_else(String::new, |r| format!(" in run {r}"));
    let channel = format!("the channel {}{in_run}", f.channel);
    let value = |x: f64| if unit.is_empty() { digits(x, 3) } else { format!("{} {unit}", digits(x, 3)) };
    if f.gain != 1.0 {
        let size = f.gain.abs();
        let sign = if f.gain < 0.0 { "with the sign turned" } else { "" };
        let factor = match size {
            g if (g - 1.0).abs() < 5e-4 => String::new(),
            g if g > 1.0 => format!("{} times too large", digits(g, 4)),
            g => format!("{} times too small", digits(1.0 / g, 3)),
        };
        let and = if sign.is_empty() || factor.is_empty() { "" } else { " and " };
        return format!("{channel} is recorded {sign}{and}{factor}: divide it by {}", digits(f.gain, 4));
    }
    if f.lag_s != 0.0 {
        let size = duration(f.lag_s.abs());
        let (is, shift) = if f.lag_s > 0.0 { ("late", "earlier") } else { ("early", "later") };
        return format!("{channel} is {is} by {size}: shift it {size} {shift}");
    }
    if let Some([low, high]) = f.clip {
        let levels = match (low.abs(), high.abs()) {
            (l, h) if l > OPEN_LEVEL * h => format!("above {}", value(high)),
            (l, h) if h > OPEN_LEVEL * l => format!("below {}", value(low)),
            _ => format!("beyond {} and {}", value(low), value(high)),
        };
        return format!("{channel} shows nothing {levels}: leave the samples at that level out");
    }
    match f.drift[..] {
        [a, b] if b[0] - a[0] > SLOPE_LENGTH => {
            let slope = (b[1] - a[1]) / (b[0] - a[0]);
            format!("{channel} drifts by {} per second, from {} at time 0: take it off", value(slope), value(a[1]))
        }
        [a, b] => format!("{channel} jumps by {} at {}: take it off", value(b[1] - a[1]), duration(a[0])),
        _ => {
            let (low, high) = f.drift.iter().fold((0.0f64, 0.0f64), |(a, b), p| (a.min(p[1]), b.max(p[1])));
            format!("the zero of {channel} wanders between {} and {}", value(low), value(high))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::fault_in_words;
    use crate::candidate::channel_fault::ChannelFault;

    fn fault(change: impl FnOnce(&mut ChannelFault)) -> String {
        let mut f = ChannelFault::none("force", None);
        change(&mut f);
        fault_in_words(&f, "kN")
    }

    #[test]
    fn faults_of_sensors_state_their_correction() {
        assert_eq!(fault(|f| f.gain = 1.05), "the channel force is recorded 1.05 times too large: divide it by 1.05");
        assert_eq!(fault(|f| f.gain = 0.65), "the channel force is recorded 1.54 times too small: divide it by 0.65");
        assert_eq!(fault(|f| f.gain = -1.0), "the channel force is recorded with the sign turned: divide it by -1");
        let both = "the channel force is recorded with the sign turned and 1.2 times too large: divide it by -1.2";
        assert_eq!(fault(|f| f.gain = -1.2), both);
        assert_eq!(fault(|f| f.lag_s = 0.02), "the channel force is late by 20 ms: shift it 20 ms earlier");
        assert_eq!(fault(|f| f.lag_s = -0.0107), "the channel force is early by 10.7 ms: shift it 10.7 ms later");
        let clipped = "the channel force shows nothing above 20 kN: leave the samples at that level out";
        assert_eq!(fault(|f| f.clip = Some([-200.0, 20.0])), clipped);
        let jump = "the channel force in run a jumps by 0.6 kN at 13.2 s: take it off";
        let in_run = |f: &mut ChannelFault| (f.run, f.drift) = (Some("a".into()), vec![[13.2, 0.0], [13.21, 0.6]]);
        assert_eq!(fault(in_run), jump);
        let slope = "the channel force drifts by 0.02 kN per second, from -1 kN at time 0: take it off";
        assert_eq!(fault(|f| f.drift = vec![[0.0, -1.0], [1e4, 199.0]]), slope);
    }
}
