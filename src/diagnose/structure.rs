//! What is left in a residual that no noise has.

use super::noise::{explained, lines, power};
use super::scale::Scales;
use crate::study::{Fit, Role, Study};

/// Part of a residual that has structure which no noise has: told by the motion of the devices, or standing in lines.
pub(super) fn structure(study: &Study, scales: &Scales, fits: &[Fit]) -> (f64, String) {
    let (mut most, mut says) = (0.0, String::new());
    let runs = study.runs.iter().enumerate().filter(|(_, r)| r.role == Role::Fit);
    for ((number, run), fit) in runs.zip(fits) {
        let columns = regressors(scales, number);
        for (o, y) in run.observe.iter().zip(&fit.channels) {
            let r: Vec<f64> =
                y.iter().zip(&o.values).map(|(y, v)| if (y - v).is_finite() { y - v } else { 0.0 }).collect();
            let told = explained(&r, &columns, 6);
            let (line, frequency) = lines(&r);
            let times = &run.recording.times;
            let rate = (times.len() - 1) as f64 / (times[times.len() - 1] - times[0]);
            // Only what matters for this channel against the others.
            let weight = (power(&r) / o.variance / 1e-4).min(1.0);
            if weight * told > most {
                most = weight * told;
                says = format!("part of the residual of {} follows the motion of the device", o.channel);
            }
            if weight * line > most {
                most = weight * line;
                says = format!("the residual of {} has a line at {:.3} Hz", o.channel, frequency * rate);
            }
        }
    }
    (most, says)
}

/// Smooth functions of the motion of the devices in a run, scaled to one.
fn regressors(scales: &Scales, run: usize) -> Vec<Vec<f64>> {
    let mut out: Vec<Vec<f64>> = vec![];
    for ((_, _, _), w) in scales.watched.iter().filter(|((r, _, _), _)| *r == run).take(3) {
        let n = w.times.len();
        let scaled = |v: Vec<f64>| {
            let top = v.iter().filter(|x| x.is_finite()).fold(0.0f64, |m, x| m.max(x.abs())).max(f64::MIN_POSITIVE);
            v.into_iter().map(|x| if x.is_finite() { x / top } else { 0.0 }).collect::<Vec<f64>>()
        };
        let e = scaled(w.e.clone());
        let q = scaled(w.q.clone());
        let v = scaled(
            (0..n).map(|i| if i == 0 { 0.0 } else { (w.e[i] - w.e[i - 1]) / (w.times[i] - w.times[i - 1]) }).collect(),
        );
        let t: Vec<f64> = (0..n).map(|i| i as f64 / n as f64).collect();
        let mut largest = 0.0f64;
        let m: Vec<f64> = e
            .iter()
            .map(|x| {
                largest = largest.max(x.abs());
                largest
            })
            .collect();
        let each = |f: &dyn Fn(usize) -> f64| (0..n).map(f).collect::<Vec<f64>>();
        out.extend([
            vec![1.0; n],
            e.clone(),
            q.clone(),
            v.clone(),
            each(&|i| e[i].powi(3)),
            each(&|i| q[i] * q[i].abs()),
            each(&|i| v[i].signum() * v[i].abs().sqrt()),
            each(&|i| e[i] * t[i]),
            each(&|i| q[i] * t[i]),
            each(&|i| e[i] * m[i]),
            each(&|i| q[i] * m[i]),
            each(&|i| e[i] * v[i].abs()),
            each(&|i| t[i]),
            each(&|i| e[i] * e[i]),
        ]);
    }
    out
}
