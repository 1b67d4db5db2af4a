//! What is left in a residual that no noise has.

use crate::inspect::response::{Scales, Watched};
use crate::residual::noise::{averaged, burg, bursts, lines, power, whiten};
use crate::residual::recurrence::Stroke;
use crate::residual::regression::explained;
use crate::residual::surrogates::{comes_again, follows, silent, unsteady};
use hysteron_identify::study::{Fit, Observe, Role, Run, Study};

/// Points that a residual is averaged to: mechanisms live in the motion, not between two samples.
const POINTS: usize = 1500;
/// Order of the noise, for what follows the motion and for what comes in bursts.
const ORDER: usize = 2;
const LONG_ORDER: usize = 8;
/// Blocks of time of which each in turn is told by the others.
const BLOCKS: usize = 6;

/// Part of a residual that has structure which no noise has: told by the motion of the devices, by the channel itself or by
/// what is left in other channels, standing in lines, coming in bursts, or louder at some times than at others.
///
/// A law of another form than the true one leaves what comes again along the stroke, and nothing where nothing moves: both are
/// asked of a model only that is taken `as_it_is`, with which nothing but noise should be left.
pub(crate) fn structure(study: &Study, scales: &Scales, fits: &[Fit], as_it_is: bool) -> (f64, String) {
    let (mut most, mut says) = (0.0, String::new());
    for ((number, run), fit) in study.runs_of(Role::Fit).zip(fits) {
        let motion = regressors(scales, number);
        let strokes = strokes(scales, number);
        let residuals = residuals(run, fit);
        let fewer: Vec<Vec<f64>> = residuals.iter().map(|r| averaged(r, POINTS)).collect();
        for (c, ((o, y), r)) in run.observe.iter().zip(&fit.channels).zip(&residuals).enumerate() {
            let channel: Vec<f64> = y.iter().map(|y| finite(*y)).collect();
            // Slow noise follows whatever is slow: what it remembers of itself is taken out of both sides first.
            let few = &fewer[c];
            let noise = burg(few, ORDER);
            // As many as the samples can bear, the simplest first.
            let columns: Vec<Vec<f64>> = SHIFTS
                .iter()
                .map(|s| shifted(&channel, *s))
                .chain(motion.iter().cloned())
                .take(few.len() / 8)
                .map(|c| averaged(&c, POINTS))
                .collect();
            let whitened: Vec<Vec<f64>> = columns.iter().map(|c| whiten(c, &noise)).collect();
            // White noise hides what is smooth where it is whitened by it: against steady noise of the same spectrum as well.
            let told = explained(&whiten(few, &noise), &whitened, BLOCKS).max(follows(few, columns, BLOCKS));
            let (line, frequency) = lines(r, &channel);
            let burst = bursts(&innovations(r), &innovations(&channel));
            let common = in_common(&fewer, c, &noise);
            let times = &run.recording.times;
            let rate = (times.len() - 1) as f64 / (times[times.len() - 1] - times[0]);
            let weight = weight(r, o);
            let mut consider = |part: f64, what: String| {
                if weight * part > most {
                    most = weight * part;
                    says = what;
                }
            };
            consider(told, format!("part of the residual of {} follows the motion", o.channel));
            let measure = if as_it_is { Stroke::comes_again } else { Stroke::comes_again_within };
            consider(comes_again(few, &strokes, measure), comes_again_in(o));
            // The noise of a sensor may grow with what it reads: silence and loudness are what is more than that.
            let level = if as_it_is { levelled(few, &averaged(&channel, POINTS)) } else { few.clone() };
            if as_it_is {
                consider(
                    silent(&level),
                    format!("the residual of {} is silent at some times, as no steady noise", o.channel),
                );
            }
            consider(line, format!("the residual of {} has a line at {:.3} Hz", o.channel, frequency * rate));
            consider(burst, format!("the residual of {} comes in bursts", o.channel));
            consider(
                unsteady(&level),
                format!("the residual of {} is louder at some times than steady noise", o.channel),
            );
            consider(common, format!("the residual of {} moves with those of other channels", o.channel));
        }
    }
    (most, says)
}

/// A residual over the level of a noise whose variance is a + b y² where the channel reads y, of the likeliest a and b that are not
/// negative.
fn levelled(residual: &[f64], channel: &[f64]) -> Vec<f64> {
    /// Reweighted steps of least squares, and the least part of the power that does not grow.
    const STEPS: usize = 20;
    const LEAST: f64 = 1e-3;
    let (mean, size) = (power(residual), power(channel));
    if mean <= 0.0 || size <= 0.0 {
        return residual.to_vec();
    }
    let grows: Vec<f64> = channel.iter().map(|y| y * y / size).collect();
    let (mut a, mut b) = (mean, 0.0);
    for _ in 0..STEPS {
        let (mut normal, mut gradient) = ([[0.0; 2]; 2], [0.0; 2]);
        for (r, g) in residual.iter().zip(&grows) {
            let w = (a + b * g).powi(-2);
            normal = [[normal[0][0] + w, normal[0][1] + w * g], [normal[1][0] + w * g, normal[1][1] + w * g * g]];
            gradient = [gradient[0] + w * r * r, gradient[1] + w * g * r * r];
        }
        let [[aa, ab], [_, bb]] = normal;
        let determinant = aa * bb - ab * ab;
        if determinant <= 1e-12 * aa * bb {
            break;
        }
        a = (bb * gradient[0] - ab * gradient[1]) / determinant;
        b = (aa * gradient[1] - ab * gradient[0]) / determinant;
        if b < 0.0 {
            (a, b) = (gradient[0] / aa, 0.0);
        } else if a < LEAST * mean {
            a = LEAST * mean;
            b = ((gradient[1] - ab * a) / bb).max(0.0);
        }
    }
    residual.iter().zip(&grows).map(|(r, g)| r / (a + b * g).sqrt()).collect()
}

/// Part of what an explanation leaves that comes again along the stroke, however slowly it changes there, and in which channel.
pub(crate) fn recurs(study: &Study, scales: &Scales, fits: &[Fit]) -> (f64, String) {
    let (mut most, mut says) = (0.0, String::new());
    for ((number, run), fit) in study.runs_of(Role::Fit).zip(fits) {
        let strokes = strokes(scales, number);
        for (r, o) in residuals(run, fit).iter().zip(&run.observe) {
            let part = weight(r, o) * comes_again(&averaged(r, POINTS), &strokes, Stroke::comes_again);
            if part > most {
                (most, says) = (part, comes_again_in(o));
            }
        }
    }
    (most, says)
}

fn comes_again_in(channel: &Observe) -> String {
    format!("the residual of {} comes again wherever the deformation does", channel.channel)
}

/// What is left in the channels of a run.
fn residuals(run: &Run, fit: &Fit) -> Vec<Vec<f64>> {
    let of = |(o, y): (&Observe, &Vec<f64>)| y.iter().zip(&o.values).map(|(y, v)| finite(y - v)).collect();
    run.observe.iter().zip(&fit.channels).map(of).collect()
}

/// Strokes of the devices in a run.
fn strokes(scales: &Scales, run: usize) -> Vec<Stroke> {
    let moving = scales.watched.iter().filter(|((r, _, _), _)| *r == run).take(DEVICES);
    moving.map(|(_, w)| Stroke::new(&averaged(&w.e, POINTS), BLOCKS)).collect()
}

/// Only what matters for a channel against the others.
fn weight(residual: &[f64], channel: &Observe) -> f64 {
    (power(residual) / channel.variance / 1e-4).min(1.0)
}

fn finite(x: f64) -> f64 {
    if x.is_finite() { x } else { 0.0 }
}

/// What the past of a series does not tell.
fn innovations(x: &[f64]) -> Vec<f64> {
    whiten(x, &burg(x, LONG_ORDER))
}

/// Part of the residual of a channel that those of the other channels of its run tell: sensors have noise each of its
/// own, a force that the model lacks moves all of them. As an amplitude: the sensors' own noise hides some of it, and of
/// what has nothing in common no block tells another anything at all.
fn in_common(residuals: &[Vec<f64>], channel: usize, noise: &[f64]) -> f64 {
    let target = &residuals[channel];
    let others = || residuals.iter().enumerate().filter(|(c, x)| *c != channel && x.len() == target.len());
    // The nearest in time first, as many as the samples can bear.
    let columns: Vec<Vec<f64>> = NEIGHBOURS
        .iter()
        .flat_map(|by| others().map(|(_, x)| whiten(&shifted(x, *by), noise)))
        .take(target.len() / 8)
        .collect();
    explained(&whiten(target, noise), &columns, BLOCKS).sqrt()
}

/// Samples by which what is left in other channels is shifted.
const NEIGHBOURS: [isize; 13] = [0, -1, 1, -2, 2, -3, 3, -4, 4, -5, 5, -6, 6];

/// Samples by which the channel itself is shifted: a fault of its transfer is told by its neighbours.
const SHIFTS: [isize; 9] = [-16, -8, -4, -2, 0, 2, 4, 8, 16];

fn shifted(x: &[f64], by: isize) -> Vec<f64> {
    let top = x.iter().fold(0.0f64, |m, x| m.max(x.abs())).max(f64::MIN_POSITIVE);
    let n = x.len() as isize;
    (0..n).map(|t| x[(t + by).clamp(0, n - 1) as usize] / top).collect()
}

/// Devices whose motion is looked at, each in one direction.
const DEVICES: usize = 2;
/// Bumps along the deformation of a device.
const BUMPS: usize = 24;

/// Scaled to one.
fn scaled(v: Vec<f64>) -> Vec<f64> {
    let top = v.iter().filter(|x| x.is_finite()).fold(0.0f64, |m, x| m.max(x.abs())).max(f64::MIN_POSITIVE);
    v.into_iter().map(|x| if x.is_finite() { x / top } else { 0.0 }).collect()
}

fn speeds(w: &Watched) -> Vec<f64> {
    let at = |i: usize| if i == 0 { 0.0 } else { (w.e[i] - w.e[i - 1]) / (w.times[i] - w.times[i - 1]) };
    (0..w.times.len()).map(at).collect()
}

/// Functions of the motion of a device in two directions at once: the direction of the velocity, in which friction and yielding pull,
/// and the force in each direction where the device is far off in the other.
fn in_two_directions(one: &Watched, two: &Watched) -> [Vec<f64>; 4] {
    let (a, b) = (speeds(one), speeds(two));
    let along = |v: &[f64]| {
        let cosine = |((a, b), v): ((&f64, &f64), &f64)| if a.hypot(*b) > 0.0 { v / a.hypot(*b) } else { 0.0 };
        scaled(a.iter().zip(&b).zip(v).map(cosine).collect())
    };
    let far = |q: &Watched, e: &Watched| scaled(q.q.iter().zip(&e.e).map(|(q, e)| q * e.abs()).collect());
    [along(&a), along(&b), far(one, two), far(two, one)]
}

/// Smooth functions of the motion of the devices in a run, scaled to one.
fn regressors(scales: &Scales, run: usize) -> Vec<Vec<f64>> {
    let (mut out, mut bumps): (Vec<Vec<f64>>, Vec<Vec<f64>>) = (vec![], vec![]);
    let moving: Vec<_> = scales.watched.iter().filter(|((r, _, _), _)| *r == run).take(DEVICES).collect();
    for (_, w) in &moving {
        let n = w.times.len();
        let e = scaled(w.e.clone());
        let q = scaled(w.q.clone());
        let v = scaled(speeds(w));
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
        // Work, which is the same on both sides, and a force that grows with the deformation whatever its sense.
        let work = each(&|i| q[i] * e[i]);
        let growing = each(&|i| q[i] * e[i].abs());
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
            work,
            growing,
        ]);
        // Whatever function of the deformation: bumps along it.
        let [low, high] = e.iter().fold([0.0f64; 2], |[a, b], x| [a.min(*x), b.max(*x)]);
        let width = (high - low) / BUMPS as f64;
        bumps.extend((0..BUMPS).map(|b| {
            let at = low + (b as f64 + 0.5) * width;
            each(&|i| (-((e[i] - at) / width).powi(2)).exp())
        }));
    }
    if let [((_, tag, _), one), ((_, other, _), two)] = moving[..]
        && tag == other
    {
        out.extend(in_two_directions(one, two));
    }
    out.extend(bumps);
    out
}

#[cfg(test)]
mod tests {
    use super::{BLOCKS, explained, in_common, levelled, regressors, silent, speeds, unsteady};
    use crate::inspect::response::{Scales, Watched};
    use crate::residual::noise::tests::noise;

    #[test]
    fn sensors_have_noise_of_their_own() {
        let own: Vec<Vec<f64>> = (1..4).map(|seed| noise(seed, 900)).collect();
        assert!((0..3).all(|c| in_common(&own, c, &[]) < 0.05));
        // A force that moves all channels, each a sample later.
        let force = noise(9, 910);
        let moved: Vec<Vec<f64>> =
            (0..3).map(|c| own[c].iter().zip(&force[c..]).map(|(o, f)| o + f).collect()).collect();
        assert!((0..3).all(|c| in_common(&moved, c, &[]) > 0.5));
        assert!(in_common(&moved[..1], 0, &[]) == 0.0);
    }

    /// Noise that grows with what a sensor reads is neither silent nor loud; what comes and goes by itself is.
    #[test]
    fn noise_may_grow_with_what_is_read() {
        let n = 1200;
        let channel: Vec<f64> = (0..n).map(|t| (t as f64 / n as f64) * (0.05 * t as f64).sin()).collect();
        let mut flagged = 0;
        for seed in 1..20 {
            let grows: Vec<f64> =
                noise(seed, n).iter().zip(&channel).map(|(x, y)| x * (0.1f64 + y * y).sqrt()).collect();
            let level = levelled(&grows, &channel);
            assert!(silent(&grows) > 0.3, "{seed} {}", silent(&grows));
            flagged += usize::from(silent(&level).max(unsteady(&level)) > 0.05);
            let rung = |t: usize| if t % 500 > 400 { 8.0 * (0.4 * t as f64).sin() } else { 0.0 };
            let struck: Vec<f64> = noise(seed, n).iter().enumerate().map(|(t, x)| x + rung(t)).collect();
            assert!(silent(&levelled(&struck, &channel)) > 0.3);
        }
        assert!(flagged < 3, "{flagged}");
    }

    /// Friction in the plane pulls against the velocity: its part along one axis depends on the other.
    #[test]
    fn a_device_in_the_plane_moves_in_two_directions_at_once() {
        let times: Vec<f64> = (0..1200).map(|i| 0.01 * f64::from(i)).collect();
        let moving = |f: &dyn Fn(f64) -> f64| {
            let e: Vec<f64> = times.iter().map(|t| f(*t)).collect();
            Watched { times: times.clone(), q: e.clone(), e }
        };
        let (x, y) = (moving(&|t| (1.0 + 0.1 * t) * (3.0 * t).sin()), moving(&|t| 2.0 * (1.7 * t).sin()));
        let of = |other| {
            let watched = [((0, 1, 1), x.clone()), ((0, other, 2), y.clone())].into_iter().collect();
            regressors(&Scales { watched, ..Scales::default() }, 0)
        };
        let (a, b) = (speeds(&x), speeds(&y));
        let pulls: Vec<f64> = a.iter().zip(&b).map(|(a, b)| a / a.hypot(*b).max(f64::MIN_POSITIVE)).collect();
        assert_eq!(of(1).len(), of(2).len() + 4);
        let simple = |columns: Vec<Vec<f64>>| columns.into_iter().take(32).collect::<Vec<_>>();
        assert!(explained(&pulls, &simple(of(1)), BLOCKS) > 0.99);
    }
}
