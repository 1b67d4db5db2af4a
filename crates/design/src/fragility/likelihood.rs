//! Log-likelihood of a lognormal capacity with its derivatives.

use std::f64::consts::{PI, SQRT_2};

/// Information about the capacity of a record, as an intensity above 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Observation {
    /// The capacity is known.
    Exact(f64),
    /// It lies between two intensities.
    Between(f64, f64),
    /// It is above an intensity: the limit state was not reached there.
    Above(f64),
    /// It is at or below an intensity: the limit state was reached there.
    Below(f64),
}

/// Value of the log-likelihood at (a, b) with its gradient and Hessian (aa, ab, bb).
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Value {
    pub(super) value: f64,
    pub(super) gradient: [f64; 2],
    pub(super) hessian: [f64; 3],
}

/// Argument beyond which a tail of the normal distribution is taken from its asymptote.
const FAR: f64 = 25.0;

/// ln of the standard normal density.
fn log_density(z: f64) -> f64 {
    -0.5 * z * z - 0.5 * (2.0 * PI).ln()
}

/// ln Φ(-z).
fn log_tail(z: f64) -> f64 {
    if z < FAR { (0.5 * libm::erfc(z / SQRT_2)).ln() } else { log_density(z) - z.ln() - 1.0 / (z * z) }
}

/// Standard normal distribution function.
pub fn normal(z: f64) -> f64 {
    0.5 * libm::erfc(-z / SQRT_2)
}

impl Observation {
    /// Add `weight` times the log-likelihood. The probability that the capacity is below x is Φ(a + b ln x), b > 0.
    pub(super) fn add(self, weight: f64, [a, b]: [f64; 2], sum: &mut Value) {
        let at = |x: f64| (x.ln(), a + b * x.ln());
        match self {
            Self::Exact(x) => {
                let (l, z) = at(x);
                // Density of ln x: b φ(a + b ln x).
                sum.value += weight * (b.ln() + log_density(z));
                let d = [-z, 1.0 / b - z * l];
                let h = [-1.0, -l, -1.0 / (b * b) - l * l];
                sum.accumulate(weight, d, h);
            }
            Self::Below(x) => sum.tail(weight, at(x), 1.0),
            Self::Above(x) => sum.tail(weight, at(x), -1.0),
            Self::Between(x0, x1) => {
                let ((l0, z0), (l1, z1)) = (at(x0), at(x1));
                // The difference of the smaller tails keeps its digits.
                let (near, far) = if z0 > 0.0 { (z0, z1) } else { (-z1, -z0) };
                let log = log_tail(near) + (-(log_tail(far) - log_tail(near)).exp()).ln_1p();
                sum.value += weight * log;
                let (r0, r1) = ((log_density(z0) - log).exp(), (log_density(z1) - log).exp());
                let (d0, d1) = (-r0, r1);
                let (h0, h1, cross) = (z0 * r0 - r0 * r0, -z1 * r1 - r1 * r1, r0 * r1);
                let d = [d0 + d1, d0 * l0 + d1 * l1];
                let h = [
                    h0 + h1 + 2.0 * cross,
                    h0 * l0 + h1 * l1 + cross * (l0 + l1),
                    h0 * l0 * l0 + h1 * l1 * l1 + 2.0 * cross * l0 * l1,
                ];
                sum.accumulate(weight, d, h);
            }
        }
    }
}

impl Value {
    /// ln Φ(s z) with s = ±1.
    fn tail(&mut self, weight: f64, (l, z): (f64, f64), s: f64) {
        let log = log_tail(-s * z);
        let ratio = (log_density(z) - log).exp();
        self.value += weight * log;
        let (d, h) = (s * ratio, -s * z * ratio - ratio * ratio);
        self.accumulate(weight, [d, d * l], [h, h * l, h * l * l]);
    }

    fn accumulate(&mut self, weight: f64, d: [f64; 2], h: [f64; 3]) {
        self.gradient.iter_mut().zip(d).for_each(|(s, x)| *s += weight * x);
        self.hessian.iter_mut().zip(h).for_each(|(s, x)| *s += weight * x);
    }
}

#[cfg(test)]
mod tests {
    use super::{Observation, Value, log_tail};

    #[test]
    fn derivatives_are_those_of_differences() {
        use Observation::{Above, Below, Between, Exact};
        let of = |o: Observation, p: [f64; 2]| {
            let mut v = Value::default();
            o.add(1.5, p, &mut v);
            v
        };
        let p = [0.3, 1.7];
        for o in [Exact(0.4), Between(0.5, 0.9), Between(1.4, 3.0), Above(0.7), Below(0.2), Above(3.0), Below(2.0)] {
            let (v, e) = (of(o, p), 1e-5);
            for k in 0..2 {
                let moved = |s: f64| {
                    let mut q = p;
                    q[k] += s * e;
                    of(o, q)
                };
                let slope = (moved(1.0).value - moved(-1.0).value) / (2.0 * e);
                assert!((slope - v.gradient[k]).abs() < 1e-8, "{o:?} {k}: {slope} {:?}", v.gradient);
                let second = |j: usize| (moved(1.0).gradient[j] - moved(-1.0).gradient[j]) / (2.0 * e);
                assert!((second(0) - v.hessian[k]).abs() < 1e-7, "{o:?} {k}");
                assert!((second(1) - v.hessian[k + 1]).abs() < 1e-7, "{o:?} {k}");
            }
        }
    }

    #[test]
    fn tails_are_joined() {
        let (near, far) = (log_tail(25.0 - 1e-9), log_tail(25.0 + 1e-9));
        assert!((near - far).abs() < 1e-5, "{near} {far}");
        assert!(log_tail(1e4).is_finite());
    }
}
