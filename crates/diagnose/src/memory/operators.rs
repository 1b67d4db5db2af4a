//! Series of the engine's operators along a motion. All series have the length of the motion.

use hysteron_engine::element::amendment::learned::operators;

/// Series of a step that starts from zero, over a scale; the first value is that at rest.
fn along(count: usize, scale: f64, mut step: impl FnMut(f64, usize) -> f64) -> Vec<f64> {
    let (mut value, mut out) = (0.0, Vec::with_capacity(count));
    for j in 0..count {
        if j > 0 {
            value = step(value, j);
        }
        out.push(value / scale);
    }
    out
}

/// Stop of level r g(t), over r.
pub(super) fn stop(u: &[f64], level: f64, factor: &[f64]) -> Vec<f64> {
    along(u.len(), level, |s, j| operators::stop(s, u[j] - u[j - 1], level * factor[j]))
}

/// Bouc and Wen's hysteresis of exponent one and strength r g(t), over r.
pub(super) fn bouc_wen(u: &[f64], level: f64, factor: &[f64]) -> Vec<f64> {
    along(u.len(), level, |z, j| operators::bouc_wen(z, u[j] - u[j - 1], level * factor[j]).0)
}

/// Hysteresis of learned slopes and strength r g(t), over r.
pub(super) fn curve(u: &[f64], level: f64, factor: &[f64], knots: &[f64]) -> Vec<f64> {
    along(u.len(), level, |z, j| operators::curve(z, u[j] - u[j - 1], level * factor[j], knots).0)
}

/// First-order filter of a time constant.
pub(super) fn low_pass(x: &[f64], times: &[f64], constant: f64, start: f64) -> Vec<f64> {
    let mut y = start;
    let at = |j: usize| {
        if j > 0 {
            y = operators::low_pass(y, x[j], times[j] - times[j - 1], constant);
        }
        y
    };
    (0..x.len()).map(at).collect()
}

/// Force of a Maxwell element of stiffness one.
pub(super) fn maxwell(u: &[f64], times: &[f64], constant: f64) -> Vec<f64> {
    along(u.len(), 1.0, |h, j| operators::maxwell(h, u[j] - u[j - 1], times[j] - times[j - 1], constant).0)
}

/// Backward differences over time; the first is zero.
pub(super) fn speed(u: &[f64], times: &[f64]) -> Vec<f64> {
    let at = |j: usize| {
        let dt = if j > 0 { times[j] - times[j - 1] } else { 0.0 };
        if dt > 0.0 { (u[j] - u[j - 1]) / dt } else { 0.0 }
    };
    (0..u.len()).map(at).collect()
}

#[cfg(test)]
mod tests {
    use super::{bouc_wen, curve, maxwell, stop};

    #[test]
    fn a_stop_slips_at_its_level() {
        let u = [0.0, 0.5, 2.0, 1.5, -2.0];
        assert_eq!(stop(&u, 1.0, &[1.0; 5]), [0.0, 0.5, 1.0, 0.5, -1.0]);
        // Half the level halves the force.
        assert_eq!(stop(&u, 1.0, &[0.5; 5]), [0.0, 0.5, 0.5, 0.0, -0.5]);
    }

    #[test]
    fn bouc_wen_tends_to_its_strength_from_either_side() {
        let u: Vec<f64> =
            (0..200).map(|i| 0.1 * f64::from(i)).chain((0..400).map(|i| 20.0 - 0.1 * f64::from(i))).collect();
        let z = bouc_wen(&u, 2.0, &vec![1.0; u.len()]);
        assert!((z[199] - 1.0).abs() < 1e-3 && (z[599] + 1.0).abs() < 1e-3);
        // One step of any length has the same result as many.
        let one = bouc_wen(&[0.0, u[30]], 2.0, &[1.0; 2]);
        assert!((one[1] - z[30]).abs() < 1e-12);
        let same = curve(&u, 2.0, &vec![1.0; u.len()], &[1.0, 1.0, 1.0, 0.5, 0.0]);
        assert!(same.iter().zip(&z).all(|(a, b)| (a - b).abs() < 1e-12));
    }

    #[test]
    fn a_held_maxwell_element_relaxes() {
        let times: Vec<f64> = (0..100).map(f64::from).collect();
        let u: Vec<f64> = times.iter().map(|t| t.min(1.0)).collect();
        let h = maxwell(&u, &times, 10.0);
        assert!((h[11] / h[1] - (-1f64).exp()).abs() < 1e-12);
    }
}
