//! Runs that the model cannot tell apart although their recordings are opposite.

use super::compare::Moments;
use super::{Finding, FindingKind};
use crate::study::{ObservedChannel, Run, Study};

/// Correlation of two simulated channels that are the same.
const SAME_RESPONSE: f64 = 0.999;
/// Factor between them, less 1.
const SAME_SIZE: f64 = 0.02;
/// Correlation of recorded channels that are opposite: no repetition of one motion has it.
const OPPOSITE: f64 = -0.5;

/// Findings about pairs of runs. Signs and delays in one of the two alone are those of its motion, and are taken out of `known`.
pub(super) fn findings(study: &Study, simulated: &[Option<&[Vec<f64>]>], known: &mut Vec<Finding>) -> Vec<Finding> {
    let mut out = vec![];
    for (b, second) in study.runs.iter().enumerate() {
        for (a, first) in study.runs[..b].iter().enumerate() {
            let (Some(x), Some(y)) = (simulated[a], simulated[b]) else { continue };
            let Some(r) = opposite((first, x), (second, y)) else { continue };
            let of = |run: &Run, f: &Finding| f.runs.contains(&run.name) && f.kind <= FindingKind::Lag;
            // A fault that only one of the two shows is that of its motion.
            let shown = |run: &Run| -> Vec<(FindingKind, String)> {
                known.iter().filter(|f| of(run, f)).map(|f| (f.kind, f.channel.clone())).collect()
            };
            let both = [shown(first), shown(second)];
            let is_shared = |f: &Finding| both.iter().all(|s| s.contains(&(f.kind, f.channel.clone())));
            known.retain(|f| !(of(first, f) || of(second, f)) || is_shared(f));
            out.push(Finding {
                kind: FindingKind::Input,
                is_hard: true,
                channel: second.observe[0].channel.clone(),
                runs: vec![first.name.clone(), second.name.clone()],
                factor: None,
                lag_s: None,
                message: format!(
                    "the model has one response in {} and {}, and the recordings are opposite, correlation {r:.2}: have \
                     both runs one motion by mistake?",
                    first.name, second.name
                ),
                help: "give each run its own motion, or factor = -1 in the [[run.observe]] of a turned sensor".into(),
            });
        }
    }
    out
}

/// The largest correlation of the recorded channels of two runs, if the model gives both the same response and all channels
/// were recorded opposite.
fn opposite((first, x): (&Run, &[Vec<f64>]), (second, y): (&Run, &[Vec<f64>])) -> Option<f64> {
    let mut most = f64::NEG_INFINITY;
    for (i, o) in first.observe.iter().enumerate() {
        let j = second.observe.iter().position(|p: &ObservedChannel| p.channel == o.channel)?;
        let at_times = |values: &[f64]| at(&first.recording.times, &second.recording.times, values);
        let model = Moments::new(&x[i], &at_times(&y[j]));
        let [factor, _] = model.line();
        if model.correlation() < SAME_RESPONSE || (factor - 1.0).abs() > SAME_SIZE {
            return None;
        }
        most = most.max(Moments::new(&o.values, &at_times(&second.observe[j].values)).correlation());
    }
    (most < OPPOSITE).then_some(most)
}

/// Values of a series at other times, by linear interpolation; NaN outside of it.
fn at(times: &[f64], of: &[f64], values: &[f64]) -> Vec<f64> {
    let value = |t: &f64| {
        let k = of.partition_point(|x| x < t);
        match (k.checked_sub(1), of.get(k)) {
            (_, Some(x)) if x == t => values[k],
            (Some(before), Some(_)) => {
                let part = (t - of[before]) / (of[k] - of[before]);
                values[before] + part * (values[k] - values[before])
            }
            _ => f64::NAN,
        }
    };
    times.iter().map(value).collect()
}
