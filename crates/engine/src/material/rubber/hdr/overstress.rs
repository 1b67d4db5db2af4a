//! The overstress branch: an elasto-plastic part in series with a nonlinear dashpot (Eqs 3.9 to 3.13).
//!
//! At a constant strain rate r the stress x of the branch follows one scalar equation, x' = K (r - f(x)). The dashpot
//! rate is f(x) = sign(x) |x/a|^(1/n). K is C₁ + C₂ while the slider sticks, and C₂ while it slides.
//!
//! The equation is autonomous and its right side decreases with x, so x approaches a |r|ⁿ monotonically. At most one
//! event occurs in a step: the slider begins to slide at a strain of the elasto-plastic part that is known in
//! advance. Between events an L-stable diagonally implicit Runge-Kutta method of order 4 integrates the equation. The
//! substeps follow its embedded error estimate (Hairer and Wanner, Solving Ordinary Differential Equations II, Table
//! IV.6.5).

use crate::material::{MaterialError, MaterialResult};
use crate::numeric::{Dual, sign};

/// Parameters of the branch, with their derivatives from the temperature.
#[derive(Clone, Copy, Debug)]
pub(super) struct Branch {
    pub(super) c1: Dual,
    pub(super) c2: Dual,
    pub(super) tau_cr: Dual,
    pub(super) a: Dual,
    pub(super) n: Dual,
}

/// Result of a step of the branch.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Flow {
    /// Strain γ_b of the elasto-plastic part.
    pub(super) b: Dual,
    /// Strain γ_s2 of the slider.
    pub(super) slip: Dual,
    /// Work dissipated in slider and dashpot, per volume.
    pub(super) heat: Dual,
    /// Time integral of dissipated power times time since the start of the step.
    pub(super) moment: f64,
}

/// Butcher matrix of the method; its last row gives the solution.
const A: [[f64; 5]; 5] = [
    [GAMMA, 0.0, 0.0, 0.0, 0.0],
    [0.5, GAMMA, 0.0, 0.0, 0.0],
    [17.0 / 50.0, -1.0 / 25.0, GAMMA, 0.0, 0.0],
    [371.0 / 1360.0, -137.0 / 2720.0, 15.0 / 544.0, GAMMA, 0.0],
    [25.0 / 24.0, -49.0 / 48.0, 125.0 / 16.0, -85.0 / 12.0, GAMMA],
];
const GAMMA: f64 = 0.25;
/// Abscissae of the stages.
const ABSCISSAE: [f64; 5] = [0.25, 0.75, 11.0 / 20.0, 0.5, 1.0];
/// Weights of the solution minus those of the embedded solution of order 3.
const ERROR: [f64; 5] = [-3.0 / 16.0, -27.0 / 32.0, 25.0 / 32.0, 0.0, 0.25];
/// Accepted error of a substep, relative to the stress.
const TOLERANCE: f64 = 1e-8;
/// Smallest reference stress of the error, divided by a.
const STRESS_FLOOR_RATIO: f64 = 1e-2;
/// Maximum number of Newton iterations of a stage.
const MAX_NEWTON_ITERATIONS: usize = 100;
/// Maximum number of iterations for the sliding event; the first half may use Newton's method.
const MAX_EVENT_ITERATIONS: usize = 60;
/// Maximum number of substeps; exceeded only by invalid numbers.
const MAX_SUBSTEPS: usize = 20_000;

/// A substep: strain of the elasto-plastic part, its rate at the end, error of the stress, dissipated work and its
/// moment in time.
struct Substep {
    b: Dual,
    speed: f64,
    error: f64,
    heat: Dual,
    moment: f64,
}

impl Branch {
    /// Stress for the strains of elasto-plastic part and slider.
    pub(super) fn stress(&self, b: Dual, slip: Dual) -> Dual {
        self.c1 * (b - slip) + self.c2 * b
    }

    /// Elastic energy per volume.
    pub(super) fn stored(&self, b: Dual, slip: Dual) -> Dual {
        0.5 * (self.c1 * (b - slip) * (b - slip) + self.c2 * b * b)
    }

    /// Strain rate of the dashpot for a nonnegative stress.
    fn rate(&self, stress: Dual, p: Dual) -> Dual {
        (stress / self.a).powf(p)
    }

    /// Root z of z + β f(z) = x for nonnegative numbers, by Newton's method from above, where it converges
    /// monotonically.
    fn solve(&self, x: Dual, beta: Dual, p: Dual) -> Dual {
        if x.value <= 0.0 {
            return x;
        }
        if beta.value <= 0.0 {
            return x - beta * self.rate(x, p);
        }
        let (x0, beta0, a, exponent) = (x.value, beta.value, self.a.value, p.value);
        let mut z = x0.min(a * (x0 / beta0).powf(self.n.value));
        let mut slope = 1.0;
        for _ in 0..MAX_NEWTON_ITERATIONS {
            let f = (z / a).powf(exponent);
            slope = 1.0 + beta0 * exponent * f / z;
            let correction = (z + beta0 * f - x0) / slope;
            z -= correction;
            if correction.abs() <= 1e-14 * z || z <= 0.0 {
                break;
            }
        }
        // One more correction with derivatives gives the derivative of the root.
        let z = Dual::constant(z.max(0.0));
        z - (1.0 / slope) * (z + beta * self.rate(z, p) - x)
    }

    /// A substep of length `h` from strain `b` and stress `x`, with stiffness `k` and total strain rate `r`.
    fn substep(&self, (b, x): (Dual, Dual), k: Dual, r: Dual, h: Dual, p: Dual) -> Substep {
        let mut rates = [Dual::default(); 5];
        let (mut heat, mut moment, mut error) = (Dual::default(), 0.0, 0.0);
        let mut end = b;
        for i in 0..5 {
            let sum = (0..i).fold(Dual::default(), |sum, j| sum + A[i][j] * rates[j]);
            let known = x + k * h * (sum + GAMMA * r);
            let size = self.solve(known.abs(), GAMMA * (k * h), p);
            let flow = self.rate(size, p);
            rates[i] = r - if known.value < 0.0 { -flow } else { flow };
            let power = size * flow;
            heat = heat + A[4][i] * (h * power);
            moment += A[4][i] * ABSCISSAE[i] * power.value;
            error += ERROR[i] * rates[i].value;
            end = b + h * (sum + GAMMA * rates[i]);
        }
        let error = (k.value * h.value * error).abs();
        Substep { b: end, speed: rates[4].value, error, heat, moment: moment * h.value * h.value }
    }

    /// Response to a strain increment at constant rate over `time`, from the strains of elasto-plastic part and
    /// slider.
    ///
    /// # Errors
    /// The substeps do not reach the end of the step.
    pub(super) fn flow(&self, (b, slip): (Dual, Dual), increment: Dual, time: f64) -> MaterialResult<Flow> {
        let mut out = Flow { b, slip, ..Flow::default() };
        self.return_to_yield(&mut out);
        if time <= 0.0 {
            // The dashpot does not move in a step without time.
            out.b = out.b + increment;
            self.return_to_yield(&mut out);
            return Ok(out);
        }
        let p = Dual::constant(1.0) / self.n;
        let r = (1.0 / time) * increment;
        let x = self.stress(out.b, out.slip);
        let f = self.rate(x.abs(), p).value;
        let way = sign(r.value - if x.value < 0.0 { -f } else { f });
        let yields = self.c1.value > 0.0;
        let limit = if yields { out.slip + way * (self.tau_cr / self.c1) } else { out.b };
        let room = way * (limit.value - out.b.value);
        let strength = if yields { self.tau_cr.value / self.c1.value } else { 0.0 };
        let mut sliding = !yields || way != 0.0 && room <= 1e-13 * (strength + limit.value.abs());
        let mut remaining = Dual::constant(time);
        let mut elapsed = 0.0;
        let mut h = self.first_guess(x.value, r.value, p.value, sliding).min(time);
        for _ in 0..MAX_SUBSTEPS {
            let k = if sliding { self.c2 } else { self.c1 + self.c2 };
            let from = (out.b, self.stress(out.b, out.slip));
            let last = h >= remaining.value * (1.0 - 1e-12);
            let mut length = if last { remaining } else { Dual::constant(h) };
            let mut s = self.substep(from, k, r, length, p);
            let allowed = TOLERANCE * (from.1.value.abs() + STRESS_FLOOR_RATIO * self.a.value);
            let ratio = s.error / allowed;
            if ratio > 1.0 {
                h = length.value * (0.9 * ratio.powf(-0.25)).clamp(0.1, 0.9);
                continue;
            }
            let event = !sliding && way != 0.0 && way * (s.b.value - limit.value) > 0.0;
            if event {
                length = self.arrival(from, k, r, p, (limit, length.value));
                s = self.substep(from, k, r, length, p);
            }
            out.heat = out.heat + s.heat;
            out.moment += s.moment + elapsed * s.heat.value;
            if sliding && yields {
                let slid = s.b - out.b;
                out.heat = out.heat + self.tau_cr * slid.abs();
                out.moment += (elapsed + 0.5 * length.value) * self.tau_cr.value * slid.value.abs();
                out.slip = out.slip + slid;
            }
            out.b = if event { limit } else { s.b };
            if !out.b.value.is_finite() || !out.heat.value.is_finite() {
                break;
            }
            sliding |= event;
            remaining = remaining - length;
            elapsed += length.value;
            if last && !event || remaining.value <= 1e-14 * time {
                return Ok(out);
            }
            let growth = if ratio > 0.0 { (0.9 * ratio.powf(-0.25)).clamp(0.3, 5.0) } else { 5.0 };
            h = (length.value.max(h) * growth).min(remaining.value);
        }
        Err(MaterialError(format!("HDRRheology found no overstress at a strain rate of {:.6e}", r.value)))
    }

    /// Length of a substep, at most `longest`, at the end of which the strain of the elasto-plastic part is `limit`.
    fn arrival(&self, from: (Dual, Dual), k: Dual, r: Dual, p: Dual, (limit, longest): (Dual, f64)) -> Dual {
        let (mut lo, mut hi) = (0.0, longest);
        let mut h = Dual::constant(0.5 * longest);
        for i in 0..MAX_EVENT_ITERATIONS {
            let s = self.substep(from, k, r, h, p);
            let missing = limit - s.b;
            let ahead = missing.value * (limit.value - from.0.value) > 0.0;
            if ahead {
                lo = h.value
            } else {
                hi = h.value
            }
            // The strain is monotone in the substep, so bisection safeguards Newton's method.
            let next = h.value + missing.value / s.speed;
            if (next - h.value).abs() <= 1e-13 * longest {
                return Dual { value: next.clamp(0.0, longest), slope: missing.slope / s.speed };
            }
            h.value = if next > lo && next < hi && i < MAX_EVENT_ITERATIONS / 2 { next } else { 0.5 * (lo + hi) };
        }
        h
    }

    /// First substep: a fraction of the relaxation time of the branch.
    fn first_guess(&self, x: f64, r: f64, p: f64, sliding: bool) -> f64 {
        let k = if sliding { self.c2.value } else { self.c1.value + self.c2.value };
        let a = self.a.value;
        let steady = r.abs().powf(1.0 / p);
        let slope = |y: f64| if y > 0.0 { p / a * y.powf(p - 1.0) } else { 0.0 };
        0.2 / (k * slope(steady.max(x.abs() / a))).max(f64::MIN_POSITIVE)
    }

    /// Moves the slider if its stress exceeds the sliding stress.
    fn return_to_yield(&self, out: &mut Flow) {
        if self.c1.value <= 0.0 {
            return;
        }
        let elastic = out.b - out.slip;
        let limit = self.tau_cr / self.c1;
        if elastic.value.abs() > limit.value {
            let slip = out.b - sign(elastic.value) * limit;
            out.heat = out.heat + self.tau_cr * (slip - out.slip).abs();
            out.slip = slip;
        }
    }
}
