//! Faults of a channel: gain, delay, drift and clipping.

use super::declaration::{Dimension, Measurement, Quantity};
use super::{AddedParameter, Hypothesis, Proposal, ProposalContext};
use crate::candidate::channel_fault::ChannelFault;
use crate::candidate::proposal::FaultModel;
use crate::inspect::saturation::saturated_runs;
use crate::prior::SATURATED_EXTREME;
use hysteron_identify::study::{ObservedChannel, Role, Run};
use std::sync::Arc;

pub(super) const GAIN: Hypothesis = Hypothesis {
    cause: "sensor_gain",
    statement: "a channel is scaled wrongly",
    refuted_by: "another instrument at the same place shows the same values",
    look_alikes: &["friction", "torsion"],
    shows: "a channel that is the simulated one times a factor, at all amplitudes and in all its runs",
    parted_by: "other channels of the same run agree with the model",
    place: "each channel",
    forms: "one factor in all runs, or in one of several",
    needs_clock: false,
    memory: &[],
    materials: &[],
    measurement: Measurement::new(
        "check the factor of this channel in the settings of the recorder, or put a second instrument beside it",
        "check the factor of this channel in the settings of the recorder, or calibrate it with a known load",
    ),
    quantities: &[Quantity::new("gain", "factor on the true value", Dimension::Ratio)],
    propose: gain,
};
pub(super) const LAG: Hypothesis = Hypothesis {
    cause: "sensor_lag",
    statement: "a channel is late",
    refuted_by: "the channel follows a tap on its sensor at once",
    look_alikes: &["damping", "rate_dependence"],
    shows: "a channel that follows later by the same time everywhere; loops that turn around their centre",
    parted_by: "`rate_dependence` and `damping` change with the frequency of the motion",
    place: "each channel",
    forms: "a constant delay in all runs, or in one of several",
    needs_clock: false,
    memory: &[],
    materials: &[],
    measurement: Measurement::new(
        "check clocks and filters of the recorder, or tap on two instruments at once and compare the times",
        "check clocks and filters of the recorder, or tap on two instruments at once and compare the times",
    ),
    quantities: &[Quantity::new("lag", "delay", Dimension::Time)],
    propose: lag,
};
pub(super) const DRIFT: Hypothesis = Hypothesis {
    cause: "sensor_drift",
    statement: "the zero of a channel wanders or jumps",
    refuted_by: "the channel shows the same zero before and after the run",
    look_alikes: &["mullins_softening", "friction"],
    shows: "a mean that wanders or jumps while the motion is steady",
    parted_by: "the drift does not end when the motion ends",
    place: "each channel",
    forms: "a slope in all runs or in one; a jump in a run; both; a zero that wanders by a line through six points a run",
    needs_clock: false,
    memory: &[],
    materials: &[],
    measurement: Measurement::new(
        "compare the zero of this channel before and after the earthquake",
        "record the zero of this channel before and after a run without motion",
    ),
    quantities: &[],
    propose: drift,
};
pub(super) const CLIPPING: Hypothesis = Hypothesis {
    cause: "sensor_clipping",
    statement: "a channel saturates",
    refuted_by: "the channel shows values beyond the level",
    look_alikes: &["strain_stiffening"],
    shows: "equal samples at the largest value, several in a row, while other channels go on",
    parted_by: "the level is the same in all runs",
    place: "each channel",
    forms: "a level on both sides, or the level at which a recording stays, in all runs or in one of several",
    needs_clock: false,
    memory: &[],
    materials: &[],
    measurement: Measurement::new(
        "look for flat peaks in the recording, and choose a larger range of the recorder",
        "look for flat peaks in the recording, and repeat the run with a larger range",
    ),
    quantities: &[],
    propose: clipping,
};

/// Channels of the fitted runs that an instrument reads, each with one of its records. A measure of loops is computed from
/// two of them: what one of them does wrong is not the fault of the measure.
fn channels<'a>(s: &'a ProposalContext<'_>) -> Vec<&'a ObservedChannel> {
    let mut all: Vec<&ObservedChannel> = vec![];
    for o in s.study.runs.iter().filter(|r| r.role == Role::Fit).flat_map(|r| &r.observe) {
        if o.measure.is_none() && all.iter().all(|known| known.channel != o.channel) {
            all.push(o);
        }
    }
    all
}

fn proposal(
    cause: &'static str,
    form: &str,
    channel: &str,
    added: Vec<AddedParameter>,
    fault_model: FaultModel,
) -> Proposal {
    let added = added.into_iter().map(|a| AddedParameter { of_channel_fault: true, ..a }).collect();
    Proposal {
        fault_model: Some(fault_model),
        ..Proposal::script_edit(cause, form, format!("channel {channel}"), vec![], added)
    }
}

/// Least and greatest sample of a channel in the fitted runs, or in one of them.
fn extremes(s: &ProposalContext<'_>, channel: &str, run: Option<&str>) -> [f64; 2] {
    let of_run = |r: &&Run| r.role == Role::Fit && run.is_none_or(|name| r.name == name);
    let runs = s.study.runs.iter().filter(of_run);
    let values = runs.flat_map(|r| &r.observe).filter(|o| o.channel == channel).flat_map(|o| &o.values);
    values.filter(|x| x.is_finite()).fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], x| [a.min(*x), b.max(*x)])
}

/// Largest factor of a gain that is set wrongly, and the reciprocal of the least. Other units make larger ones.
const MAX_GAIN: f64 = 5.0;
/// Least absolute correlation with which a recorded and a simulated channel show another sign or unit.
const MIN_UNIT_CORRELATION: f64 = 0.5;

/// Sign and size of the gain that is sought: 1, unless the baseline shows another sign or unit.
fn gain_scale(s: &ProposalContext<'_>, channel: &str, run: Option<&str>) -> f64 {
    let (mut vy, mut yy, mut vv) = (0.0, 0.0, 0.0);
    for (r, fit) in s.study.runs.iter().filter(|r| r.role == Role::Fit).zip(s.fits) {
        let Some(c) = r.observe.iter().position(|x| x.channel == channel) else { continue };
        if run.is_some_and(|name| r.name != name) {
            continue;
        }
        let pairs = r.observe[c].values.iter().zip(&fit.channels[c]);
        for (v, y) in pairs.filter(|(v, y)| v.is_finite() && y.is_finite()) {
            vy += v * y;
            yy += y * y;
            vv += v * v;
        }
    }
    let factor = vy / yy;
    let is_shown = vy.abs() > MIN_UNIT_CORRELATION * (yy * vv).sqrt() && factor.is_finite();
    let is_usual = (1.0 / MAX_GAIN..=MAX_GAIN).contains(&factor);
    if is_shown && !is_usual { factor } else { 1.0 }
}

fn gain(s: &ProposalContext<'_>) -> Vec<Proposal> {
    let mut out = vec![];
    let mut one = |channel: &str, run: Option<&str>| {
        let (name, of) = (channel.to_owned(), run.map(str::to_owned));
        let scale = gain_scale(s, channel, run);
        let faults: FaultModel =
            Arc::new(move |v| vec![ChannelFault { gain: scale * v[0], ..ChannelFault::none(&name, of.as_deref()) }]);
        let form = run.map_or("one factor".into(), |r| format!("one factor in {r}"));
        let form = if scale < 0.0 { format!("{form}, with the other sign") } else { form };
        let added = vec![AddedParameter::log("gain", 1.0 / MAX_GAIN, MAX_GAIN, 0.98)];
        out.push(proposal("sensor_gain", &form, channel, added, faults));
    };
    for o in channels(s) {
        // With a single channel a gain equals a stiffness of the model.
        one(&o.channel, None);
        // An amplifier with another setting in one run.
        fitted_with(s, &o.channel).for_each(|r| one(&o.channel, Some(r)));
    }
    out
}

/// Names of the fitted runs with a channel; none if a single run is fitted.
fn fitted_with<'a>(s: &'a ProposalContext<'_>, channel: &'a str) -> impl Iterator<Item = &'a str> {
    let fitted = || s.study.runs.iter().filter(|r| r.role == Role::Fit);
    let several = fitted().count() > 1;
    fitted().filter(move |r| several && r.observe.iter().any(|x| x.channel == channel)).map(|r| r.name.as_str())
}

fn lag(s: &ProposalContext<'_>) -> Vec<Proposal> {
    let step = s.sampling_interval();
    let in_all_and_each = |o: &&ObservedChannel| {
        let one = |run: Option<&str>| {
            let (name, of) = (o.channel.clone(), run.map(str::to_owned));
            let faults: FaultModel =
                Arc::new(move |v| vec![ChannelFault { lag_s: v[0], ..ChannelFault::none(&name, of.as_deref()) }]);
            let form = run.map_or("a constant delay".into(), |r| format!("a constant delay in {r}"));
            let added = vec![AddedParameter::linear("lag", -2.0 * step, 30.0 * step, 0.5 * step)];
            proposal("sensor_lag", &form, &o.channel, added, faults)
        };
        let of_runs = fitted_with(s, &o.channel).map(|r| one(Some(r)));
        std::iter::once(one(None)).chain(of_runs).collect::<Vec<_>>()
    };
    channels(s).iter().flat_map(in_all_and_each).collect()
}

/// Points of the polyline that a wandering zero follows in each run.
pub(crate) const DRIFT_KNOTS: usize = 6;

/// Divisor of the record that gives the ends in which no jump is sought.
const JUMP_MARGIN_DIVISOR: usize = 50;

/// Jump of a residual's mean, in parts of its length: the split with the least sum of squares about both means.
fn jump_position(residual: &[f64]) -> f64 {
    let r: Vec<f64> = residual.iter().map(|x| if x.is_finite() { *x } else { 0.0 }).collect();
    let n = r.len();
    let total: f64 = r.iter().sum();
    let (mut sum, mut best) = (0.0, (0.0, 0.5));
    for (i, x) in r.iter().enumerate().take(n - n / JUMP_MARGIN_DIVISOR).skip(1) {
        sum += x;
        let (left, right) = ((i + 1) as f64, (n - i - 1) as f64);
        let gain = sum * sum / left + (total - sum) * (total - sum) / right;
        if i > n / JUMP_MARGIN_DIVISOR && gain > best.0 {
            best = (gain, left / n as f64);
        }
    }
    best.1
}

fn drift(s: &ProposalContext<'_>) -> Vec<Proposal> {
    let mut out = vec![];
    for o in channels(s) {
        let [low, high] = extremes(s, &o.channel, None);
        let size = high - low;
        let longest = s.longest_run();
        let slope = || {
            [
                AddedParameter::linear("slope", -size / longest, size / longest, 0.0),
                AddedParameter::linear("zero", -0.3 * size, 0.3 * size, 0.0),
            ]
        };
        // A slope, as of an instrument that warms up, in all runs or in one.
        let name = o.channel.clone();
        let warming = move |v: &[f64], run: Option<&str>| ChannelFault {
            drift: vec![[0.0, v[1]], [1e4, v[1] + 1e4 * v[0]]],
            ..ChannelFault::none(&name, run)
        };
        let slow = warming.clone();
        let faults: FaultModel = Arc::new(move |v| vec![slow(v, None)]);
        out.push(proposal("sensor_drift", "a steady slope", &o.channel, slope().into(), faults));
        for r in fitted_with(s, &o.channel) {
            let (slow, run) = (warming.clone(), r.to_owned());
            let faults: FaultModel = Arc::new(move |v| vec![slow(v, Some(&run))]);
            out.push(proposal("sensor_drift", &format!("a steady slope in {r}"), &o.channel, slope().into(), faults));
        }
        let fitted = s.study.runs.iter().filter(|r| r.role == Role::Fit);
        let mut all: Vec<(String, f64, f64)> = vec![];
        for (r, fit) in fitted.zip(s.fits) {
            let Some(c) = r.observe.iter().position(|x| x.channel == o.channel) else { continue };
            let (begin, end) = (r.recording.times[0], r.recording.times[r.recording.times.len() - 1]);
            all.push((r.name.clone(), begin, end));
            let residual: Vec<f64> = r.observe[c].values.iter().zip(&fit.channels[c]).map(|(v, y)| v - y).collect();
            let when = || AddedParameter::linear("when", 0.0, 1.0, jump_position(&residual));
            let jump = || AddedParameter::linear("jump", -0.5 * size, 0.5 * size, 0.01 * size);
            let (name, run) = (o.channel.clone(), r.name.clone());
            let at = move |v: &[f64]| {
                let t = begin + v[0] * (end - begin);
                let drift = vec![[t, 0.0], [t + 1e-3 * (end - begin), v[1]]];
                ChannelFault { drift, ..ChannelFault::none(&name, Some(&run)) }
            };
            let (alone, beside, slow) = (at.clone(), at, warming.clone());
            let faults: FaultModel = Arc::new(move |v| vec![alone(v)]);
            let form = format!("a jump in {}", r.name);
            out.push(proposal("sensor_drift", &form, &o.channel, vec![when(), jump()], faults));
            let faults: FaultModel = Arc::new(move |v| vec![slow(&v[..2], None), beside(&v[2..])]);
            let mut added: Vec<AddedParameter> = slope().into();
            added.extend([when(), jump()]);
            let form = format!("a steady slope, and a jump in {}", r.name);
            out.push(proposal("sensor_drift", &form, &o.channel, added, faults));
        }
        let name = o.channel.clone();
        let runs = all.clone();
        let wander: FaultModel = Arc::new(move |v| {
            let of = |((run, begin, end), zeros): (&(String, f64, f64), &[f64])| {
                let at = |i: usize| begin + (end - begin) * i as f64 / (DRIFT_KNOTS - 1) as f64;
                let drift = zeros.iter().enumerate().map(|(i, y)| [at(i), *y]).collect();
                ChannelFault { drift, ..ChannelFault::none(&name, Some(run)) }
            };
            runs.iter().zip(v.chunks(DRIFT_KNOTS)).map(of).collect()
        });
        let added = (0..DRIFT_KNOTS * all.len())
            .map(|i| AddedParameter::linear(&format!("zero{i}"), -0.5 * size, 0.5 * size, 0.0))
            .collect();
        out.push(proposal("sensor_drift", "a wandering zero", &o.channel, added, wander));
    }
    out
}

/// A level that no sample reaches, over the largest sample.
const UNREACHED_LEVEL: f64 = 10.0;

fn clipping(s: &ProposalContext<'_>) -> Vec<Proposal> {
    let mut out = vec![];
    for o in channels(s) {
        let saturated = saturated_runs(s.study, s.fits, &o.channel);
        let runs = std::iter::once(None).chain(fitted_with(s, &o.channel).map(Some));
        for run in runs {
            let [low, high] = extremes(s, &o.channel, run);
            let size = high.max(-low);
            if size <= 0.0 {
                continue;
            }
            // A level counts if it is the extreme of all considered runs.
            let of_run = || saturated.iter().filter(|(r, _)| run.is_none_or(|name| r.name == name));
            let is_end = |side: usize, end: f64| {
                of_run().filter_map(|(_, ends)| ends[side]).any(|level| (level - end).abs() < SATURATED_EXTREME * size)
            };
            let ends = [is_end(0, low).then_some(low), is_end(1, high).then_some(high)];
            let visible_in_recording = ends.iter().any(Option::is_some);
            let (name, of) = (o.channel.clone(), run.map(str::to_owned));
            let clip = move |v: f64| match ends {
                [None, None] => [-v * size, v * size],
                [low, high] => {
                    [low.map_or(-UNREACHED_LEVEL * size, |x| v * x), high.map_or(UNREACHED_LEVEL * size, |x| v * x)]
                }
            };
            let faults: FaultModel = Arc::new(move |v| {
                vec![ChannelFault { clip: Some(clip(v[0])), ..ChannelFault::none(&name, of.as_deref()) }]
            });
            let form =
                if visible_in_recording { "a level at which the recording stays" } else { "a level on both sides" };
            let form = run.map_or(form.into(), |r| format!("{form} in {r}"));
            let added = if visible_in_recording {
                AddedParameter::linear("level", 0.9, 1.1, 1.0)
            } else {
                AddedParameter::linear("level", 0.3, 1.1, 1.0)
            };
            out.push(Proposal {
                visible_in_recording,
                ..proposal("sensor_clipping", &form, &o.channel, vec![added], faults)
            });
        }
    }
    out
}
