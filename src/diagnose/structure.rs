//! What is left in a residual that no noise has.

use super::noise::{averaged, burg, bursts, explained, lines, power, whiten};
use super::scale::Scales;
use crate::study::{Fit, Role, Study};

/// Points that a residual is averaged to: mechanisms live in the motion, not between two samples.
const POINTS: usize = 1500;
/// Order of the noise, for what follows the motion and for what comes in bursts.
const ORDER: usize = 2;
const LONG_ORDER: usize = 8;

/// Part of a residual that has structure which no noise has: told by the motion of the devices or by the channel itself,
/// standing in lines, or coming in bursts.
pub(super) fn structure(study: &Study, scales: &Scales, fits: &[Fit]) -> (f64, String) {
    let (mut most, mut says) = (0.0, String::new());
    let runs = study.runs.iter().enumerate().filter(|(_, r)| r.role == Role::Fit);
    for ((number, run), fit) in runs.zip(fits) {
        let motion = regressors(scales, number);
        for (o, y) in run.observe.iter().zip(&fit.channels) {
            let finite = |x: f64| if x.is_finite() { x } else { 0.0 };
            let r: Vec<f64> = y.iter().zip(&o.values).map(|(y, v)| finite(y - v)).collect();
            let channel: Vec<f64> = y.iter().map(|y| finite(*y)).collect();
            // Slow noise follows whatever is slow: what it remembers of itself is taken out of both sides first.
            let few = averaged(&r, POINTS);
            let noise = burg(&few, ORDER);
            // As many as the samples can bear, the simplest first.
            let columns: Vec<Vec<f64>> = SHIFTS
                .iter()
                .map(|s| shifted(&channel, *s))
                .chain(motion.iter().cloned())
                .take(few.len() / 8)
                .map(|c| whiten(&averaged(&c, POINTS), &noise))
                .collect();
            let told = explained(&whiten(&few, &noise), &columns, 6);
            let (line, frequency) = lines(&r, &channel);
            let burst = bursts(&whiten(&r, &burg(&r, LONG_ORDER)), &whiten(&channel, &burg(&channel, LONG_ORDER)));
            let times = &run.recording.times;
            let rate = (times.len() - 1) as f64 / (times[times.len() - 1] - times[0]);
            // Only what matters for this channel against the others.
            let weight = (power(&r) / o.variance / 1e-4).min(1.0);
            let mut consider = |part: f64, what: String| {
                if weight * part > most {
                    most = weight * part;
                    says = what;
                }
            };
            consider(told, format!("part of the residual of {} follows the motion", o.channel));
            consider(line, format!("the residual of {} has a line at {:.3} Hz", o.channel, frequency * rate));
            consider(burst, format!("the residual of {} comes in bursts", o.channel));
        }
    }
    (most, says)
}

/// Samples by which the channel itself is shifted: a fault of its transfer is told by its neighbours.
const SHIFTS: [isize; 9] = [-16, -8, -4, -2, 0, 2, 4, 8, 16];

fn shifted(x: &[f64], by: isize) -> Vec<f64> {
    let top = x.iter().fold(0.0f64, |m, x| m.max(x.abs())).max(f64::MIN_POSITIVE);
    let n = x.len() as isize;
    (0..n).map(|t| x[(t + by).clamp(0, n - 1) as usize] / top).collect()
}

/// Bumps along the deformation of a device.
const BUMPS: usize = 24;

/// Smooth functions of the motion of the devices in a run, scaled to one.
fn regressors(scales: &Scales, run: usize) -> Vec<Vec<f64>> {
    let (mut out, mut bumps): (Vec<Vec<f64>>, Vec<Vec<f64>>) = (vec![], vec![]);
    for ((_, _, _), w) in scales.watched.iter().filter(|((r, _, _), _)| *r == run).take(2) {
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
            each(&|i| e[i] * e[i]),
        ]);
        // Whatever function of the deformation: bumps along it.
        let [low, high] = e.iter().fold([0.0f64; 2], |[a, b], x| [a.min(*x), b.max(*x)]);
        let width = (high - low) / BUMPS as f64;
        bumps.extend((0..BUMPS).map(|b| {
            let at = low + (b as f64 + 0.5) * width;
            each(&|i| (-((e[i] - at) / width).powi(2)).exp())
        }));
    }
    out.extend(bumps);
    out
}
