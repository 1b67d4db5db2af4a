//! Lognormal fragility functions by maximum likelihood.
//!
//! The probability that a limit state is reached at an intensity x is Φ(ln(x/θ)/β). Stripes give the binomial likelihood of
//! Baker (2015), Efficient analytical fragility function fitting using dynamic structural analysis, Earthquake Spectra
//! 31(1), equation 11; capacities of records give that of a sample, with censored records as in equation 8. With
//! a = -ln θ/β and b = 1/β all of these are concave in (a, b), so that Newton's method finds the only maximum.

mod likelihood;

pub use likelihood::{Observation, normal};

use likelihood::Value;

/// A fitted fragility function.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Fit {
    /// Median θ.
    pub median: f64,
    /// Dispersion β: standard deviation of the logarithm.
    pub dispersion: f64,
    /// Ends of the 95 % interval of the median by likelihood ratio.
    pub median_interval: [f64; 2],
    /// Ends of the 95 % interval of the dispersion, likewise.
    pub dispersion_interval: [f64; 2],
    /// Covariances (aa, ab, bb) of a and b from the observed information.
    pub covariance: [f64; 3],
    /// Logarithm of the likelihood.
    pub log_likelihood: f64,
}

/// 95 % quantile of χ² with one degree of freedom.
const CHI_SQUARE: f64 = 3.841_458_820_694_124;
/// 97.5 % quantile of the normal distribution.
const QUANTILE: f64 = 1.959_963_984_540_054;
const SEPARATED: &str = "no dispersion: below an intensity the limit state is never reached and above it always; more levels near \
                         it, or records, would tell";
/// Newton steps at most.
const MAX_STEPS: usize = 200;
/// Length of a Newton step in (a, b), relative, at which it ends.
const TOLERANCE: f64 = 1e-11;
/// 1/β beyond which the data are taken as separated.
const MAX_SLOPE: f64 = 1e4;

fn total(data: &[(f64, Observation)], p: [f64; 2]) -> Value {
    let mut sum = Value::default();
    data.iter().for_each(|(w, o)| o.add(*w, p, &mut sum));
    sum
}

/// Largest value along a direction of p from a start, by Newton's method with halved steps.
fn along(data: &[(f64, Observation)], start: [f64; 2], direction: [f64; 2]) -> f64 {
    let at = |t: f64| [start[0] + t * direction[0], start[1] + t * direction[1]];
    let (mut t, mut v) = (0.0, total(data, start));
    for _ in 0..MAX_STEPS {
        let [x, y] = direction;
        let slope = v.gradient[0] * x + v.gradient[1] * y;
        let curvature = v.hessian[0] * x * x + 2.0 * v.hessian[1] * x * y + v.hessian[2] * y * y;
        let mut step = if curvature < 0.0 { -slope / curvature } else { slope.signum() };
        let next = loop {
            let p = at(t + step);
            let next = if p[1] > 0.0 { total(data, p) } else { Value { value: f64::NAN, ..v } };
            if next.value >= v.value || step.abs() < 1e-14 * (1.0 + t.abs()) {
                break next;
            }
            step *= 0.5;
        };
        // NaN ends the search too.
        let Some(std::cmp::Ordering::Greater | std::cmp::Ordering::Equal) = next.value.partial_cmp(&v.value) else {
            break;
        };
        (t, v) = (t + step, next);
        if step.abs() < TOLERANCE * (1.0 + t.abs()) {
            break;
        }
    }
    v.value
}

/// Point on one side of `from` at which the profile falls to the level of the interval, as a factor on the estimate.
fn end(profile: impl Fn(f64) -> f64, level: f64, up: bool) -> f64 {
    let sign: f64 = if up { 1.0 } else { -1.0 };
    // In logarithms of the factor: double until the level is passed, then halve.
    let (mut inside, mut outside) = (0.0f64, 0.01f64);
    while profile((sign * outside).exp()) > level {
        inside = outside;
        outside *= 2.0;
        if outside > 20.0 {
            return if up { f64::INFINITY } else { 0.0 };
        }
    }
    for _ in 0..60 {
        let middle = 0.5 * (inside + outside);
        if profile((sign * middle).exp()) > level { inside = middle } else { outside = middle }
    }
    (sign * 0.5 * (inside + outside)).exp()
}

impl Fit {
    /// Fit of observations with their weights.
    ///
    /// # Errors
    /// An intensity is not above 0, the limit state was always or never reached, or the data are separated: below an
    /// intensity never and above it always reached, which any dispersion near zero fits.
    pub fn new(data: &[(f64, Observation)]) -> Result<Self, String> {
        let mut logs: Vec<f64> = vec![];
        let (mut reached, mut unreached) = (false, false);
        for (weight, o) in data.iter().filter(|(w, _)| *w > 0.0) {
            let (xs, low, high) = match *o {
                Observation::Exact(x) => ([x, x], true, true),
                Observation::Between(x, y) => ([x, y], true, true),
                Observation::Above(x) => ([x, x], true, false),
                Observation::Below(x) => ([x, x], false, true),
            };
            if !(xs[0] > 0.0 && xs[1] >= xs[0] && xs[1].is_finite() && weight.is_finite()) {
                return Err(format!("an intensity of {} or {}: expected rising numbers above 0", xs[0], xs[1]));
            }
            (unreached, reached) = (unreached || low, reached || high);
            logs.extend(xs.map(f64::ln));
        }
        if !reached || !unreached {
            let how = if reached { "always" } else { "never" };
            return Err(format!("the limit state was {how} reached: no curve can be fitted"));
        }
        let data: Vec<(f64, Observation)> = data.iter().filter(|(w, _)| *w > 0.0).copied().collect();
        let mean = logs.iter().sum::<f64>() / logs.len() as f64;
        let spread = (logs.iter().map(|l| (l - mean).powi(2)).sum::<f64>() / logs.len() as f64).sqrt();
        let b = 1.0 / spread.clamp(0.1, 2.0);
        let (p, v) = newton(&data, [-mean * b, b])?;
        let [aa, ab, bb] = v.hessian;
        let determinant = aa * bb - ab * ab;
        let covariance = [-bb / determinant, ab / determinant, -aa / determinant];
        let (median, dispersion) = ((-p[0] / p[1]).exp(), 1.0 / p[1]);
        let level = v.value - 0.5 * CHI_SQUARE;
        // A median θ is the line a = -b ln θ; a dispersion the line b = 1/β.
        let of_median = |factor: f64| {
            let l = (median * factor).ln();
            along(&data, [-p[1] * l, p[1]], [-l, 1.0])
        };
        let of_dispersion = |factor: f64| {
            let b = p[1] / factor;
            along(&data, [-median.ln() * b, b], [1.0, 0.0])
        };
        Ok(Self {
            median,
            dispersion,
            median_interval: [false, true].map(|up| median * end(of_median, level, up)),
            dispersion_interval: [false, true].map(|up| dispersion * end(of_dispersion, level, up)),
            covariance,
            log_likelihood: v.value,
        })
    }

    /// Probability that the limit state is reached at an intensity.
    pub fn probability(&self, intensity: f64) -> f64 {
        normal((intensity / self.median).ln() / self.dispersion)
    }

    /// Ends of the pointwise 95 % interval of the probability, from the covariance of a and b.
    pub fn band(&self, intensity: f64) -> [f64; 2] {
        let l = intensity.ln();
        let z = (l - self.median.ln()) / self.dispersion;
        let [aa, ab, bb] = self.covariance;
        let error = (aa + 2.0 * ab * l + bb * l * l).max(0.0).sqrt();
        [normal(z - QUANTILE * error), normal(z + QUANTILE * error)]
    }
}

/// Maximum over (a, b) by Newton's method with halved steps.
fn newton(data: &[(f64, Observation)], start: [f64; 2]) -> Result<([f64; 2], Value), String> {
    let (mut p, mut v) = (start, total(data, start));
    for _ in 0..MAX_STEPS {
        let ([aa, ab, bb], [ga, gb]) = (v.hessian, v.gradient);
        let determinant = aa * bb - ab * ab;
        // A flat Hessian, where the start is far from the data: a step along the gradient.
        let newton = determinant > 1e-300;
        let mut step = if newton {
            [-(bb * ga - ab * gb) / determinant, -(aa * gb - ab * ga) / determinant]
        } else {
            let length = ga.hypot(gb).max(1e-300);
            [ga / length, gb / length]
        };
        let next = loop {
            let q = [p[0] + step[0], p[1] + step[1]];
            if q[1] > 0.0 {
                let next = total(data, q);
                if next.value >= v.value {
                    break Some((q, next));
                }
            }
            if step[0].abs() < 1e-15 * (1.0 + p[0].abs()) && step[1].abs() < 1e-15 * (1.0 + p[1].abs()) {
                break None;
            }
            step = step.map(|s| 0.5 * s);
        };
        let Some((q, w)) = next else { break };
        (p, v) = (q, w);
        if p[1] > MAX_SLOPE || v.value > -1e-9 && !data.iter().any(|(_, o)| matches!(o, Observation::Exact(_))) {
            return Err(SEPARATED.into());
        }
        if newton && step[0].abs() < TOLERANCE * (1.0 + p[0].abs()) && step[1].abs() < TOLERANCE * (1.0 + p[1].abs()) {
            break;
        }
    }
    let [aa, ab, bb] = v.hessian;
    if aa * bb - ab * ab > 0.0 && v.value.is_finite() {
        return Ok((p, v));
    }
    Err(SEPARATED.into())
}

#[cfg(test)]
mod tests {
    use super::Observation::{Above, Below, Between, Exact};
    use super::{Fit, normal};

    /// Maximum of the likelihood of Exact observations: mean and root mean square of the logarithms.
    #[test]
    fn capacities_have_their_own_mean_and_deviation() {
        let x = [0.4, 0.55, 0.7, 0.72, 1.1, 1.6];
        let data: Vec<_> = x.iter().map(|x| (1.0, Exact(*x))).collect();
        let f = Fit::new(&data).expect("a fit");
        let n = x.len() as f64;
        let mean = x.iter().map(|x| x.ln()).sum::<f64>() / n;
        let beta = (x.iter().map(|x| (x.ln() - mean).powi(2)).sum::<f64>() / n).sqrt();
        assert!((f.median / mean.exp() - 1.0).abs() < 1e-10 && (f.dispersion / beta - 1.0).abs() < 1e-10, "{f:?}");
        // Likelihood ratio for the mean of a normal sample: n ln(1 + d²/β²) = χ².
        let d = beta * ((super::CHI_SQUARE / n).exp() - 1.0).sqrt();
        assert!((f.median_interval[1] / (mean + d).exp() - 1.0).abs() < 1e-8, "{f:?} {}", (mean + d).exp());
        assert!((f.median_interval[0] / (mean - d).exp() - 1.0).abs() < 1e-8);
        // Likelihood ratio for the deviation: n (2 ln r + 1/r² - 1) = χ², r = β/β_hat.
        for r in f.dispersion_interval.map(|b| b / f.dispersion) {
            let ratio = n * (2.0 * r.ln() + 1.0 / (r * r) - 1.0);
            assert!((ratio - super::CHI_SQUARE).abs() < 1e-6, "{r} {ratio}");
        }
    }

    #[test]
    fn exact_proportions_are_found_again() {
        let (theta, beta) = (0.8f64, 0.35);
        let mut data = vec![];
        for x in [0.3, 0.5, 0.7, 0.9, 1.2, 1.6] {
            let p = normal((x / theta).ln() / beta);
            data.extend([(40.0 * p, Below(x)), (40.0 * (1.0 - p), Above(x))]);
        }
        let f = Fit::new(&data).expect("a fit");
        assert!((f.median - theta).abs() < 1e-9 && (f.dispersion - beta).abs() < 1e-9, "{f:?}");
        let band = f.band(theta);
        assert!(band[0] < 0.5 && band[1] > 0.5 && (f.probability(theta) - 0.5).abs() < 1e-12);
        // Narrow intervals are exact capacities.
        let x = [0.4, 0.55, 0.7, 0.72, 1.1, 1.6];
        let exact: Vec<_> = x.iter().map(|x| (1.0, Exact(*x))).collect();
        let narrow: Vec<_> = x.iter().map(|x| (1.0, Between(x * 0.9999, x * 1.0001))).collect();
        let (e, n) = (Fit::new(&exact).expect("a fit"), Fit::new(&narrow).expect("a fit"));
        assert!((e.median / n.median - 1.0).abs() < 1e-6 && (e.dispersion / n.dispersion - 1.0).abs() < 1e-6);
    }

    #[test]
    fn data_without_a_maximum_are_refused() {
        let fit = |d: &[(f64, super::Observation)]| Fit::new(d).expect_err("no fit");
        assert!(fit(&[(10.0, Above(1.0)), (10.0, Above(2.0))]).contains("never"));
        assert!(fit(&[(10.0, Below(1.0))]).contains("always"));
        assert!(fit(&[(10.0, Above(1.0)), (10.0, Below(2.0))]).contains("dispersion"));
        assert!(fit(&[(1.0, Exact(1.0)), (1.0, Exact(1.0))]).contains("dispersion"));
        assert!(fit(&[(1.0, Exact(-1.0))]).contains("above 0"));
        assert!(fit(&[]).contains("never"));
    }
}
