//! Faults of a channel: scaled, late, drifting, clipped.

use super::{Added, Faults, Hypothesis, Proposal, Sight};
use crate::diagnose::correction::Correction;
use crate::study::{Observe, Role};
use std::sync::Arc;

const fn fault(
    cause: &'static str,
    says: &'static str,
    refuted_by: &'static str,
    like: &'static [&'static str],
    propose: fn(&Sight<'_>) -> Vec<Proposal>,
) -> Hypothesis {
    Hypothesis { cause, says, refuted_by, like, propose }
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
    Proposal { faults: Some(faults), ..Proposal::edit(cause, form, format!("channel {channel}"), vec![], added) }
}

/// Least and greatest sample of a channel in the fitted runs.
fn extremes(s: &Sight<'_>, channel: &str) -> [f64; 2] {
    let runs = s.study.runs.iter().filter(|r| r.role == Role::Fit);
    let values = runs.flat_map(|r| &r.observe).filter(|o| o.channel == channel).flat_map(|o| &o.values);
    values.filter(|x| x.is_finite()).fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], x| [a.min(*x), b.max(*x)])
}

fn gain(s: &Sight<'_>) -> Vec<Proposal> {
    // With one channel alone a gain is the stiffness of the model.
    let each = channels(s).into_iter().map(|o| {
        let name = o.channel.clone();
        let faults: Faults = Arc::new(move |v| vec![Correction { gain: v[0], ..Correction::none(&name, None) }]);
        proposal("sensor_gain", "one factor", &o.channel, vec![Added::log("gain", 0.2, 5.0, 0.98)], faults)
    });
    each.collect()
}

fn lag(s: &Sight<'_>) -> Vec<Proposal> {
    let step = s.sampling();
    let each = channels(s).into_iter().map(|o| {
        let name = o.channel.clone();
        let faults: Faults = Arc::new(move |v| vec![Correction { lag_s: v[0], ..Correction::none(&name, None) }]);
        let added = vec![Added::linear("lag", -2.0 * step, 30.0 * step, 0.5 * step)];
        proposal("sensor_lag", "a constant delay", &o.channel, added, faults)
    });
    each.collect()
}

/// Points of the line that a zero may follow in each run.
const KNOTS: usize = 5;

fn drift(s: &Sight<'_>) -> Vec<Proposal> {
    let mut out = vec![];
    for o in channels(s) {
        let [low, high] = extremes(s, &o.channel);
        let size = high - low;
        let name = o.channel.clone();
        // Warming up: the same slope in all runs.
        let slow: Faults = Arc::new(move |v| {
            let drift = vec![[0.0, v[1]], [1e4, v[1] + 1e4 * v[0]]];
            vec![Correction { drift, ..Correction::none(&name, None) }]
        });
        let longest = s.longest();
        let added = vec![
            Added::linear("slope", -size / longest, size / longest, 0.0),
            Added::linear("zero", -0.3 * size, 0.3 * size, 0.0),
        ];
        out.push(proposal("sensor_drift", "a steady slope", &o.channel, added, slow));
        for r in s.study.runs.iter().filter(|r| r.role == Role::Fit) {
            if r.observe.iter().all(|x| x.channel != o.channel) {
                continue;
            }
            let (name, run) = (o.channel.clone(), r.name.clone());
            let (begin, end) = (r.recording.times[0], r.recording.times[r.recording.times.len() - 1]);
            let jump: Faults = Arc::new(move |v| {
                let at = begin + v[0] * (end - begin);
                let drift = vec![[at, 0.0], [at + 1e-3 * (end - begin), v[1]]];
                vec![Correction { drift, ..Correction::none(&name, Some(&run)) }]
            });
            for start in [0.25, 0.5, 0.75] {
                let added = vec![
                    Added::linear("when", 0.0, 1.0, start),
                    Added::linear("jump", -0.5 * size, 0.5 * size, 0.01 * size),
                ];
                let form = format!("a jump in {}, sought from {start} of its length", r.name);
                out.push(proposal("sensor_drift", &form, &o.channel, added, jump.clone()));
            }
            let (name, run) = (o.channel.clone(), r.name.clone());
            let wander: Faults = Arc::new(move |v| {
                let at = |i: usize| begin + (end - begin) * i as f64 / (KNOTS - 1) as f64;
                let drift = v.iter().enumerate().map(|(i, y)| [at(i), *y]).collect();
                vec![Correction { drift, ..Correction::none(&name, Some(&run)) }]
            });
            let added = (0..KNOTS).map(|i| Added::linear(&format!("zero{i}"), -0.5 * size, 0.5 * size, 0.0)).collect();
            out.push(proposal("sensor_drift", &format!("a wandering zero in {}", r.name), &o.channel, added, wander));
        }
    }
    out
}

fn clipping(s: &Sight<'_>) -> Vec<Proposal> {
    let each = channels(s).into_iter().filter_map(|o| {
        let [low, high] = extremes(s, &o.channel);
        let size = high.max(-low);
        (size > 0.0).then(|| {
            let name = o.channel.clone();
            let faults: Faults =
                Arc::new(move |v| vec![Correction { clip: Some([-v[0], v[0]]), ..Correction::none(&name, None) }]);
            let added = vec![Added::linear("level", 0.3 * size, 1.1 * size, 1.0 * size)];
            proposal("sensor_clipping", "a level on both sides", &o.channel, added, faults)
        })
    });
    each.collect()
}
