//! Baselines, derivatives, integrals and turns of series.

/// Baseline that is removed from a series before other conversions.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Baseline {
    /// Nothing.
    #[default]
    Kept,
    /// Its mean.
    Mean,
    /// Its line of least squares.
    Line,
}

impl Baseline {
    /// The correction of a word: `mean` or `line`.
    pub fn named(word: &str) -> Option<Self> {
        match word {
            "mean" => Some(Self::Mean),
            "line" => Some(Self::Line),
            _ => None,
        }
    }

    /// The series without its baseline, and what was removed, with the unit of the values.
    pub fn removed(self, values: &[f64], unit: &str) -> (Vec<f64>, String) {
        let number = |x: f64| format!("{x:.4e} {unit}").trim_end().to_owned();
        match self {
            Self::Kept => (values.to_vec(), "baseline not corrected".to_owned()),
            Self::Mean => {
                let out = without_mean(values);
                let mean = values.first().zip(out.first()).map_or(0.0, |(a, b)| a - b);
                (out, format!("mean removed: {}", number(mean)))
            }
            Self::Line => {
                let out = without_line(values);
                let ends = [values.first().zip(out.first()), values.last().zip(out.last())];
                let [from, to] = ends.map(|end| end.map_or(0.0, |(a, b)| a - b));
                (out, format!("line of least squares removed: from {} to {}", number(from), number(to)))
            }
        }
    }
}

/// The derivative by central differences of second order, at the ends by one-sided ones of second order.
pub fn derivative(values: &[f64], dt: f64) -> Vec<f64> {
    let n = values.len();
    match n {
        0 | 1 => vec![0.0; n],
        2 => vec![(values[1] - values[0]) / dt; 2],
        _ => {
            let mut out = Vec::with_capacity(n);
            out.push((-3.0 * values[0] + 4.0 * values[1] - values[2]) / (2.0 * dt));
            out.extend(values.windows(3).map(|w| (w[2] - w[0]) / (2.0 * dt)));
            out.push((3.0 * values[n - 1] - 4.0 * values[n - 2] + values[n - 3]) / (2.0 * dt));
            out
        }
    }
}

/// The integral from 0 by the trapezoidal rule.
pub fn integral(values: &[f64], dt: f64) -> Vec<f64> {
    let mut sum = 0.0;
    let steps = values.windows(2).map(|w| {
        sum += 0.5 * dt * (w[0] + w[1]);
        sum
    });
    values.first().map(|_| 0.0).into_iter().chain(steps).collect()
}

/// The series without its mean.
fn without_mean(values: &[f64]) -> Vec<f64> {
    let mean = values.iter().sum::<f64>() / values.len().max(1) as f64;
    values.iter().map(|x| x - mean).collect()
}

/// The series without its line of least squares.
fn without_line(values: &[f64]) -> Vec<f64> {
    let n = values.len() as f64;
    let middle = (n - 1.0) / 2.0;
    let mean = values.iter().sum::<f64>() / n.max(1.0);
    let (mut above, mut below) = (0.0, 0.0);
    for (i, x) in values.iter().enumerate() {
        let t = i as f64 - middle;
        above += t * (x - mean);
        below += t * t;
    }
    let slope = if below > 0.0 { above / below } else { 0.0 };
    values.iter().enumerate().map(|(i, x)| x - mean - slope * (i as f64 - middle)).collect()
}

/// Two perpendicular components along a direction at an angle in degrees from the first towards the second, and along
/// the direction 90 degrees further.
pub fn turned(first: &[f64], second: &[f64], angle: f64) -> [Vec<f64>; 2] {
    let (s, c) = angle.to_radians().sin_cos();
    let along = |a: f64, b: f64| first.iter().zip(second).map(|(x, y)| a * x + b * y).collect();
    [along(c, s), along(-s, c)]
}

#[cfg(test)]
mod tests {
    use super::{Baseline, derivative, integral, turned, without_line, without_mean};

    #[test]
    fn parabolas_are_differentiated_exactly() {
        let t: Vec<f64> = (0..20).map(|i| 0.1 * f64::from(i)).collect();
        let parabola: Vec<f64> = t.iter().map(|t| 3.0 * t * t - t).collect();
        for (d, t) in derivative(&parabola, 0.1).iter().zip(&t) {
            assert!((d - (6.0 * t - 1.0)).abs() < 1e-12);
        }
    }

    #[test]
    fn integral_of_a_line_is_exact() {
        let line: Vec<f64> = (0..11).map(|i| 0.1 * f64::from(i)).collect();
        assert!((integral(&line, 0.1)[10] - 0.5).abs() < 1e-14);
        assert!(integral(&[], 0.1).is_empty());
    }

    #[test]
    fn baselines_and_turns() {
        let line: Vec<f64> = (0..9).map(|i| 2.0 + 0.5 * f64::from(i)).collect();
        assert!(without_line(&line).iter().all(|x| x.abs() < 1e-12));
        assert!((without_mean(&line).iter().sum::<f64>()).abs() < 1e-12);
        let said = |baseline: Baseline| baseline.removed(&line, "g").1;
        assert_eq!(said(Baseline::Kept), "baseline not corrected");
        assert_eq!(said(Baseline::Mean), "mean removed: 4.0000e0 g");
        assert_eq!(said(Baseline::Line), "line of least squares removed: from 2.0000e0 g to 6.0000e0 g");
        let [a, b] = turned(&[1.0], &[0.0], 90.0);
        assert!(a[0].abs() < 1e-15 && (b[0] + 1.0).abs() < 1e-15);
    }
}
