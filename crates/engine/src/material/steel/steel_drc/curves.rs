//! Bauschinger curves between two points with given slopes: a power, a cubic or a quadratic rational curve.

use crate::material::steel::dodd_restrepo::Bauschinger;

/// Stress and slope.
pub(super) type Curve = (f64, f64);

/// Kind of curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BauschingerKind {
    /// Power of the normalised strain (Dodd and Restrepo, 1995).
    Power,
    /// Cubic rational Bézier curve (Kim and Koutromanos, 2016).
    Bezier,
    /// Quadratic rational curves (Carreño and others, 2020).
    Rational,
}

/// End of a curve: strain, stress, slope.
#[derive(Clone, Copy)]
pub(super) struct End {
    e: f64,
    f: f64,
    k: f64,
}

impl End {
    pub(super) fn new([e, f]: [f64; 2], k: f64) -> Self {
        Self { e, f, k }
    }

    fn at(&self, e: f64) -> f64 {
        self.f + self.k * (e - self.e)
    }
}

/// Share of the way to the meeting of the end tangents where the inner points of a cubic curve lie.
const INNER: f64 = 0.9;
/// Weights of its first three points.
const WEIGHTS: [f64; 3] = [1.0, 1.3, 0.7];
/// Iterations for its parameter.
const MAX_ITERATIONS: usize = 100;

impl BauschingerKind {
    /// Stress and slope at a strain, for an area and, of major curves, the position of the inner points.
    pub(super) fn at(self, ends: [End; 2], omega: f64, turn: Option<f64>, e: f64) -> Curve {
        let [from, to] = ends;
        if (from.k - to.k).abs() < f64::EPSILON {
            return (from.at(e), from.k);
        }
        match self {
            Self::Power => {
                let power = 56.689 * (omega - 0.077).powi(2) - 4.921 * (omega - 0.077) + 0.1;
                let (slopes, from, to) = ([from.k, to.k], [from.e, from.f], [to.e, to.f]);
                Bauschinger { from, to, slopes, power }.between(e, slopes[1])
            }
            Self::Bezier => cubic(ends, 643.4 * (-100.0 * omega).exp(), e),
            Self::Rational => match turn {
                Some(b) if b != 0.0 => turned(ends, b, e),
                _ => quadratic(from, to, e),
            },
        }
    }
}

fn cubic([from, to]: [End; 2], last: f64, e: f64) -> Curve {
    let (x, y) = (to.e - from.e, to.f - from.f);
    let step = INNER * (y - to.k * x) / (from.k - to.k);
    let back = INNER * (y - from.k * x) / (from.k - to.k);
    let points =
        [[from.e, from.f], [from.e + step, from.at(from.e + step)], [to.e + back, to.at(to.e + back)], [to.e, to.f]];
    let weights = [WEIGHTS[0], WEIGHTS[1], WEIGHTS[2], last];
    // Sums of the weighted Bernstein polynomials and of their derivatives with 1, strain and stress.
    let sums = |t: f64| {
        let u = 1.0 - t;
        let value = [u * u * u, 3.0 * t * u * u, 3.0 * t * t * u, t * t * t];
        let rate = [-3.0 * u * u, 3.0 * u * u - 6.0 * t * u, 6.0 * t * u - 3.0 * t * t, 3.0 * t * t];
        let sum = |b: [f64; 4], f: &dyn Fn(usize) -> f64| (0..4).map(|i| b[i] * weights[i] * f(i)).sum::<f64>();
        let all = |b: [f64; 4]| [sum(b, &|_| 1.0), sum(b, &|i| points[i][0]), sum(b, &|i| points[i][1])];
        (all(value), all(rate))
    };
    let (mut low, mut high, mut t) = (0.0, 1.0, (e - from.e) / x);
    for _ in 0..MAX_ITERATIONS {
        let ([w, xs, _], [dw, dxs, _]) = sums(t);
        let miss = (xs - e * w) * x.signum();
        if miss < 0.0 {
            low = t
        } else {
            high = t
        }
        let mut next = t - (xs - e * w) / (dxs - e * dw);
        if !(next >= low && next <= high) {
            next = 0.5 * (low + high);
        }
        let done = (next - t).abs() <= f64::EPSILON || high - low <= f64::EPSILON;
        t = next;
        if done {
            break;
        }
    }
    let ([w, xs, ys], [dw, dxs, dys]) = sums(t);
    (ys / w, (dys * w - ys * dw) / (dxs * w - xs * dw))
}

/// A quadratic rational curve.
fn quadratic(from: End, to: End, e: f64) -> Curve {
    let (x, y) = (to.e - from.e, to.f - from.f);
    let along = (e - from.e) / x;
    let inner = (y - to.k * x) / ((from.k - to.k) * x);
    let root = (inner * inner + (1.0 - 2.0 * inner) * along).sqrt();
    let u = (root - inner) / (1.0 - 2.0 * inner);
    let height = inner * from.k * x / y;
    let value = 2.0 * u * (1.0 - u) * height + u * u;
    (value * y + from.f, y / x * ((1.0 - 2.0 * u) * height + u) / root)
}

/// Two quadratic curves that meet between the ends.
fn turned([from, to]: [End; 2], b: f64, e: f64) -> Curve {
    let x = to.e - from.e;
    let meeting = (to.f - from.f + from.k * from.e - to.k * to.e) / (from.k - to.k);
    let first = b * (2.0 - b) * (meeting - from.e) / x;
    let second = (1.0 - first).min(0.5);
    let [e1, e2] = [first, second].map(|share| share * x + from.e);
    let inner = [End { e: e1, f: from.at(e1), k: from.k }, End { e: e2, f: to.at(e2), k: to.k }];
    let (f, k) = quadratic(inner[0], inner[1], meeting);
    let joint = End { e: meeting, f, k };
    if (e - meeting) * x.signum() <= 0.0 { quadratic(from, joint, e) } else { quadratic(joint, to, e) }
}
