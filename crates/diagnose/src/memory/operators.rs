//! Functions of a motion: stops, filters and time at rest. All series have the length of the motion.

/// Stop of level r g(t), over r: the force of an ideally plastic slider of stiffness one.
///
/// The level cuts the force when it falls, so that a stop makes no energy.
pub(super) fn stop(u: &[f64], level: f64, factor: &[f64]) -> Vec<f64> {
    let mut s = 0.0f64;
    let at = |j: usize| {
        if j > 0 {
            let r = level * factor[j];
            s = (s + u[j] - u[j - 1]).clamp(-r, r);
        }
        s / level
    };
    (0..u.len()).map(at).collect()
}

/// Bouc and Wen's hysteresis of exponent one and strength r g(t), over r; exact over a step.
pub(super) fn bouc_wen(u: &[f64], level: f64, factor: &[f64]) -> Vec<f64> {
    let mut z = 0.0f64;
    let at = |j: usize| {
        if j > 0 {
            let r = level * factor[j];
            z = z.clamp(-r, r);
            let mut d = u[j] - u[j - 1];
            if z * d < 0.0 {
                // Unloading is elastic down to zero.
                let unloaded = d.abs().min(z.abs()).copysign(d);
                z += unloaded;
                d -= unloaded;
            }
            let strength = r.copysign(d);
            if d != 0.0 {
                z = strength - (strength - z) * (-d.abs() / r).exp();
            }
        }
        z / level
    };
    (0..u.len()).map(at).collect()
}

/// Work that a stop of a level dissipates.
pub(super) fn stop_work(u: &[f64], level: f64) -> Vec<f64> {
    let (mut s, mut work) = (0.0f64, 0.0);
    let at = |j: usize| {
        if j > 0 {
            let trial = s + u[j] - u[j - 1];
            s = trial.clamp(-level, level);
            work += level * (trial - s).abs();
        }
        work
    };
    (0..u.len()).map(at).collect()
}

/// First-order filter of a time constant.
pub(super) fn low_pass(x: &[f64], times: &[f64], constant: f64, start: f64) -> Vec<f64> {
    let mut y = start;
    let at = |j: usize| {
        if j > 0 {
            let b = (-(times[j] - times[j - 1]) / constant).exp();
            y = b * y + (1.0 - b) * x[j];
        }
        y
    };
    (0..x.len()).map(at).collect()
}

/// Increments of a series, each of which decays with a time constant.
pub(super) fn leaky(x: &[f64], times: &[f64], constant: f64) -> Vec<f64> {
    let mut y = 0.0;
    let at = |j: usize| {
        if j > 0 {
            y = (-(times[j] - times[j - 1]) / constant).exp() * y + x[j] - x[j - 1];
        }
        y
    };
    (0..x.len()).map(at).collect()
}

/// Force of a Maxwell element of stiffness one.
pub(super) fn maxwell(u: &[f64], times: &[f64], constant: f64) -> Vec<f64> {
    let mut h = 0.0;
    let at = |j: usize| {
        if j > 0 {
            let dt = times[j] - times[j - 1];
            let b = (-dt / constant).exp();
            h = b * h + (1.0 - b) * constant / dt * (u[j] - u[j - 1]);
        }
        h
    };
    (0..u.len()).map(at).collect()
}

/// Slip over its length for each step below which a contact is at rest.
const REST_SLIP: f64 = 1e-4;
/// Logarithm of the time at rest below which it is worn off.
const WORN_OFF: f64 = 0.05;

/// Logarithm ln(1 + t/t₀) of the time at rest, worn off by slip over a length.
pub(super) fn rest(slip: &[f64], times: &[f64], length: f64, t0: f64) -> Vec<f64> {
    let (mut aged, mut resting) = (0.0f64, 0.0);
    let at = |j: usize| {
        if j > 0 {
            let d = slip[j] - slip[j - 1];
            if d < REST_SLIP * length {
                resting += times[j] - times[j - 1];
                aged = aged.max((resting / t0).ln_1p());
            } else {
                aged *= (-d / length).exp();
                if aged < WORN_OFF {
                    resting = 0.0;
                }
            }
        }
        aged
    };
    (0..slip.len()).map(at).collect()
}

/// Running maximum.
pub(super) fn running_maximum(x: impl Iterator<Item = f64>) -> Vec<f64> {
    x.scan(0.0f64, |m, x| {
        *m = m.max(x);
        Some(*m)
    })
    .collect()
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
    use super::{bouc_wen, maxwell, rest, stop, stop_work};

    #[test]
    fn a_stop_slips_at_its_level_and_dissipates_there() {
        let u = [0.0, 0.5, 2.0, 1.5, -2.0];
        assert_eq!(stop(&u, 1.0, &[1.0; 5]), [0.0, 0.5, 1.0, 0.5, -1.0]);
        assert_eq!(stop_work(&u, 1.0), [0.0, 0.0, 1.0, 1.0, 3.0]);
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
    }

    #[test]
    fn rest_ages_a_contact_and_slip_wears_it_off() {
        let times: Vec<f64> = (0..100).map(f64::from).collect();
        let slip: Vec<f64> = times.iter().map(|t| (t - 50.0).max(0.0)).collect();
        let aged = rest(&slip, &times, 5.0, 1.0);
        assert!((aged[50] - 51f64.ln()).abs() < 1e-12);
        assert!((aged[55] - 51f64.ln() * (-1f64).exp()).abs() < 1e-12);
        // A held Maxwell element relaxes.
        let u: Vec<f64> = times.iter().map(|t| t.min(1.0)).collect();
        let h = maxwell(&u, &times, 10.0);
        assert!((h[11] / h[1] - (-1f64).exp()).abs() < 1e-12);
    }
}
