//! Faults of a channel: scaled, late, drifting, clipped.

use super::{Added, Faults, Hypothesis, Proposal, Sight};
use crate::candidate::sensor_fault::Correction;
use crate::inspect::saturation::saturated;
use hysteron_identify::study::{Observe, Role, Run};
use std::sync::Arc;

const fn fault(
    cause: &'static str,
    says: &'static str,
    refuted_by: &'static str,
    like: &'static [&'static str],
    propose: fn(&Sight<'_>) -> Vec<Proposal>,
) -> Hypothesis {
    Hypothesis { cause, says, refuted_by, like, needs_clock: false, propose }
}

pub(super) const GAIN: Hypothesis = fault(
    "sensor_gain",
    "a channel is scaled wrongly",
    "another instrument at the same place shows the same values",
    &["friction", "torsion"],
    gain,
);
pub(super) const LAG: Hypothesis = fault(
    "sensor_lag",
    "a channel is late",
    "the channel follows a tap on its sensor at once",
    &["damping", "rate_dependence"],
    lag,
);
pub(super) const DRIFT: Hypothesis = fault(
    "sensor_drift",
    "the zero of a channel wanders or jumps",
    "the channel shows the same zero before and after the run",
    &["mullins_softening", "friction"],
    drift,
);
pub(super) const CLIPPING: Hypothesis = fault(
    "sensor_clipping",
    "a channel saturates",
    "the channel shows values beyond the level",
    &["strain_stiffening"],
    clipping,
);

/// The channels of the fitted runs, each once, with one of its records.
fn channels<'a>(s: &'a Sight<'_>) -> Vec<&'a Observe> {
    let mut all: Vec<&Observe> = vec![];
    for o in s.study.runs.iter().filter(|r| r.role == Role::Fit).flat_map(|r| &r.observe) {
        if all.iter().all(|known| known.channel != o.channel) {
            all.push(o);
        }
    }
    all
}

fn proposal(cause: &'static str, form: &str, channel: &str, added: Vec<Added>, faults: Faults) -> Proposal {
    let added = added.into_iter().map(|a| Added { rig: true, ..a }).collect();
    Proposal { faults: Some(faults), ..Proposal::edit(cause, form, format!("channel {channel}"), vec![], added) }
}

/// Least and greatest sample of a channel in the fitted runs, or in one of them.
fn extremes(s: &Sight<'_>, channel: &str, run: Option<&str>) -> [f64; 2] {
    let of_run = |r: &&Run| r.role == Role::Fit && run.is_none_or(|name| r.name == name);
    let runs = s.study.runs.iter().filter(of_run);
    let values = runs.flat_map(|r| &r.observe).filter(|o| o.channel == channel).flat_map(|o| &o.values);
    values.filter(|x| x.is_finite()).fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], x| [a.min(*x), b.max(*x)])
}

fn gain(s: &Sight<'_>) -> Vec<Proposal> {
    let mut out = vec![];
    let mut one = |channel: &str, run: Option<&str>| {
        let (name, of) = (channel.to_owned(), run.map(str::to_owned));
        let faults: Faults =
            Arc::new(move |v| vec![Correction { gain: v[0], ..Correction::none(&name, of.as_deref()) }]);
        let form = run.map_or("one factor".into(), |r| format!("one factor in {r}"));
        out.push(proposal("sensor_gain", &form, channel, vec![Added::log("gain", 0.2, 5.0, 0.98)], faults));
    };
    for o in channels(s) {
        // With one channel alone this is the stiffness of the model.
        one(&o.channel, None);
        // An amplifier that was set otherwise in one of the runs.
        fitted_with(s, &o.channel).for_each(|r| one(&o.channel, Some(r)));
    }
    out
}

/// Names of the fitted runs that have a channel, where there are several fitted runs.
fn fitted_with<'a>(s: &'a Sight<'_>, channel: &'a str) -> impl Iterator<Item = &'a str> {
    let fitted = || s.study.runs.iter().filter(|r| r.role == Role::Fit);
    let several = fitted().count() > 1;
    fitted().filter(move |r| several && r.observe.iter().any(|x| x.channel == channel)).map(|r| r.name.as_str())
}

fn lag(s: &Sight<'_>) -> Vec<Proposal> {
    let step = s.sampling();
    let in_all_and_each = |o: &&Observe| {
        let one = |run: Option<&str>| {
            let (name, of) = (o.channel.clone(), run.map(str::to_owned));
            let faults: Faults =
                Arc::new(move |v| vec![Correction { lag_s: v[0], ..Correction::none(&name, of.as_deref()) }]);
            let form = run.map_or("a constant delay".into(), |r| format!("a constant delay in {r}"));
            let added = vec![Added::linear("lag", -2.0 * step, 30.0 * step, 0.5 * step)];
            proposal("sensor_lag", &form, &o.channel, added, faults)
        };
        let of_runs = fitted_with(s, &o.channel).map(|r| one(Some(r)));
        std::iter::once(one(None)).chain(of_runs).collect::<Vec<_>>()
    };
    channels(s).iter().flat_map(in_all_and_each).collect()
}

/// Points of the line that a zero may follow in each run.
pub(crate) const KNOTS: usize = 6;

/// Where the mean of a residual jumps, as a part of its length: the split that leaves the least square on both sides.
fn jump_of(residual: &[f64]) -> f64 {
    let r: Vec<f64> = residual.iter().map(|x| if x.is_finite() { *x } else { 0.0 }).collect();
    let n = r.len();
    let total: f64 = r.iter().sum();
    let (mut sum, mut best) = (0.0, (0.0, 0.5));
    for (i, x) in r.iter().enumerate().take(n - n / 50).skip(1) {
        sum += x;
        let (left, right) = ((i + 1) as f64, (n - i - 1) as f64);
        let gain = sum * sum / left + (total - sum) * (total - sum) / right;
        if i > n / 50 && gain > best.0 {
            best = (gain, left / n as f64);
        }
    }
    best.1
}

fn drift(s: &Sight<'_>) -> Vec<Proposal> {
    let mut out = vec![];
    for o in channels(s) {
        let [low, high] = extremes(s, &o.channel, None);
        let size = high - low;
        let longest = s.longest();
        let slope = || {
            [
                Added::linear("slope", -size / longest, size / longest, 0.0),
                Added::linear("zero", -0.3 * size, 0.3 * size, 0.0),
            ]
        };
        // Warming up: the same slope in all runs.
        let name = o.channel.clone();
        let warming = move |v: &[f64], run: Option<&str>| Correction {
            drift: vec![[0.0, v[1]], [1e4, v[1] + 1e4 * v[0]]],
            ..Correction::none(&name, run)
        };
        let slow = warming.clone();
        let faults: Faults = Arc::new(move |v| vec![slow(v, None)]);
        out.push(proposal("sensor_drift", "a steady slope", &o.channel, slope().into(), faults));
        for r in fitted_with(s, &o.channel) {
            let (slow, run) = (warming.clone(), r.to_owned());
            let faults: Faults = Arc::new(move |v| vec![slow(v, Some(&run))]);
            out.push(proposal("sensor_drift", &format!("a steady slope in {r}"), &o.channel, slope().into(), faults));
        }
        let fitted = s.study.runs.iter().filter(|r| r.role == Role::Fit);
        let mut all: Vec<(String, f64, f64)> = vec![];
        for (r, fit) in fitted.zip(s.fits) {
            let Some(c) = r.observe.iter().position(|x| x.channel == o.channel) else { continue };
            let (begin, end) = (r.recording.times[0], r.recording.times[r.recording.times.len() - 1]);
            all.push((r.name.clone(), begin, end));
            let residual: Vec<f64> = r.observe[c].values.iter().zip(&fit.channels[c]).map(|(v, y)| v - y).collect();
            let when = || Added::linear("when", 0.0, 1.0, jump_of(&residual));
            let jump = || Added::linear("jump", -0.5 * size, 0.5 * size, 0.01 * size);
            let (name, run) = (o.channel.clone(), r.name.clone());
            let at = move |v: &[f64]| {
                let t = begin + v[0] * (end - begin);
                let drift = vec![[t, 0.0], [t + 1e-3 * (end - begin), v[1]]];
                Correction { drift, ..Correction::none(&name, Some(&run)) }
            };
            let (alone, beside, slow) = (at.clone(), at, warming.clone());
            let faults: Faults = Arc::new(move |v| vec![alone(v)]);
            let form = format!("a jump in {}", r.name);
            out.push(proposal("sensor_drift", &form, &o.channel, vec![when(), jump()], faults));
            let faults: Faults = Arc::new(move |v| vec![slow(&v[..2], None), beside(&v[2..])]);
            let mut added: Vec<Added> = slope().into();
            added.extend([when(), jump()]);
            let form = format!("a steady slope, and a jump in {}", r.name);
            out.push(proposal("sensor_drift", &form, &o.channel, added, faults));
        }
        let name = o.channel.clone();
        let runs = all.clone();
        let wander: Faults = Arc::new(move |v| {
            let of = |((run, begin, end), zeros): (&(String, f64, f64), &[f64])| {
                let at = |i: usize| begin + (end - begin) * i as f64 / (KNOTS - 1) as f64;
                let drift = zeros.iter().enumerate().map(|(i, y)| [at(i), *y]).collect();
                Correction { drift, ..Correction::none(&name, Some(run)) }
            };
            runs.iter().zip(v.chunks(KNOTS)).map(of).collect()
        });
        let added =
            (0..KNOTS * all.len()).map(|i| Added::linear(&format!("zero{i}"), -0.5 * size, 0.5 * size, 0.0)).collect();
        out.push(proposal("sensor_drift", "a wandering zero", &o.channel, added, wander));
    }
    out
}

/// A level that no sample reaches, over the largest one.
const NEVER: f64 = 10.0;

fn clipping(s: &Sight<'_>) -> Vec<Proposal> {
    let mut out = vec![];
    for o in channels(s) {
        let stays = saturated(s.study, s.fits, &o.channel);
        let runs = std::iter::once(None).chain(fitted_with(s, &o.channel).map(Some));
        for run in runs {
            let [low, high] = extremes(s, &o.channel, run);
            let size = high.max(-low);
            if size <= 0.0 {
                continue;
            }
            // An end at which it is seen to stay is one of all that is looked at.
            let of_run = || stays.iter().filter(|(r, _)| run.is_none_or(|name| r.name == name));
            let is_end = |side: usize, end: f64| {
                of_run().filter_map(|(_, ends)| ends[side]).any(|seen| (seen - end).abs() < 1e-3 * size)
            };
            let ends = [is_end(0, low).then_some(low), is_end(1, high).then_some(high)];
            let seen = ends.iter().any(Option::is_some);
            let (name, of) = (o.channel.clone(), run.map(str::to_owned));
            let clip = move |v: f64| match ends {
                [None, None] => [-v * size, v * size],
                [low, high] => [low.map_or(-NEVER * size, |x| v * x), high.map_or(NEVER * size, |x| v * x)],
            };
            let faults: Faults = Arc::new(move |v| {
                vec![Correction { clip: Some(clip(v[0])), ..Correction::none(&name, of.as_deref()) }]
            });
            let form = if seen { "a level at which the recording stays" } else { "a level on both sides" };
            let form = run.map_or(form.into(), |r| format!("{form} in {r}"));
            let added =
                if seen { Added::linear("level", 0.9, 1.1, 1.0) } else { Added::linear("level", 0.3, 1.1, 1.0) };
            out.push(Proposal { seen, ..proposal("sensor_clipping", &form, &o.channel, vec![added], faults) });
        }
    }
    out
}
