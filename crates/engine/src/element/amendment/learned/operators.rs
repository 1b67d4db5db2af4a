//! One step of stops, hysteresis and filters. A step takes committed values and an increment.

/// Stop of a level: an ideally plastic slider of stiffness one.
///
/// The level cuts the force when it falls, so that a stop makes no energy.
pub fn stop(s: f64, du: f64, level: f64) -> f64 {
    (s + du).clamp(-level, level)
}

/// Derivative of [`stop`] with respect to the increment.
pub fn stop_slope(s: f64, du: f64, level: f64) -> f64 {
    if (s + du).abs() < level { 1.0 } else { 0.0 }
}

/// Bouc and Wen's hysteresis of exponent one and a strength; exact over a step. Returns the value and its derivative.
pub fn bouc_wen(z: f64, du: f64, strength: f64) -> (f64, f64) {
    let mut z = z.clamp(-strength, strength);
    let mut d = du;
    if z * d < 0.0 {
        // Unloading is elastic down to zero.
        let unloaded = d.abs().min(z.abs()).copysign(d);
        z += unloaded;
        d -= unloaded;
    }
    if d == 0.0 {
        return (z, 1.0);
    }
    let end = strength.copysign(d);
    let decay = (-d.abs() / strength).exp();
    let next = end - (end - z) * decay;
    (next, (end - z).abs() / strength * decay)
}

/// Hysteresis dz = φ(z sgn(du)/r) du with φ linear between `knots`, evenly from unloading (-1) to loading (1), and constant
/// beyond; exact over a step. Returns the value and its derivative.
pub fn curve(z: f64, du: f64, strength: f64, knots: &[f64]) -> (f64, f64) {
    let segments = knots.len() - 1;
    let (first, last, width) = (knots[0], knots[segments], 2.0 / segments as f64);
    let side = if du < 0.0 { -1.0 } else { 1.0 };
    let (mut y, mut left) = (side * z / strength, du.abs() / strength);
    let value = |y: f64| {
        let x = ((y + 1.0) / width).clamp(0.0, segments as f64);
        let i = (x as usize).min(segments - 1);
        knots[i] + (knots[i + 1] - knots[i]) * (x - i as f64)
    };
    if y < -1.0 {
        let steps = left.min((-1.0 - y) / first);
        y += first * steps;
        left -= steps;
    }
    for i in 0..segments {
        let top = -1.0 + width * (i + 1) as f64;
        if left <= 0.0 || y >= top {
            continue;
        }
        let (here, there, rise) = (value(y), knots[i + 1], (knots[i + 1] - knots[i]) / width);
        let to_top = if here <= 0.0 {
            f64::INFINITY
        } else if rise.abs() < 1e-12 * here {
            (top - y) / here
        } else {
            (there / here).ln() / rise
        };
        if left >= to_top {
            y = top;
            left -= to_top;
        } else {
            y += if rise.abs() < 1e-12 * here { here * left } else { here * (rise * left).exp_m1() / rise };
            left = 0.0;
        }
    }
    if left > 0.0 && y >= 1.0 {
        y += last * left;
    }
    (side * y * strength, value(y))
}

/// Part of a value that is left of it after a time, with a time constant.
pub fn decay(dt: f64, constant: f64) -> f64 {
    (-dt / constant).exp()
}

/// First-order filter of a time constant.
pub fn low_pass(y: f64, x: f64, dt: f64, constant: f64) -> f64 {
    let b = decay(dt, constant);
    b * y + (1.0 - b) * x
}

/// Force of a Maxwell element of stiffness one, and its derivative. It is a spring where no time passes.
pub fn maxwell(h: f64, du: f64, dt: f64, constant: f64) -> (f64, f64) {
    if dt <= 0.0 {
        return (h + du, 1.0);
    }
    let b = decay(dt, constant);
    let slope = (1.0 - b) * constant / dt;
    (b * h + slope * du, slope)
}

/// Speed over that of reference below which a dashpot is linear.
const LINEAR_SPEED: f64 = 1e-3;

/// Dashpot |v|^p sgn(v) of a speed over that of reference, linear about zero; and its derivative.
pub fn dashpot(v: f64, power: f64) -> (f64, f64) {
    let size = v * v + LINEAR_SPEED * LINEAR_SPEED;
    let factor = size.powf(0.5 * (power - 1.0));
    (v * factor, factor * (1.0 + (power - 1.0) * v * v / size))
}

/// Friction smoothed over a width of the speed, tanh(v / width); and its derivative.
pub fn smoothed_friction(v: f64, width: f64) -> (f64, f64) {
    let t = (v / width).tanh();
    (t, (1.0 - t * t) / width)
}

/// Piece of a spring of slope one beyond a deformation on a side (1, -1, or 0 for both); and its derivative.
pub fn piece(u: f64, side: f64, at: f64) -> (f64, f64) {
    let beyond = u.abs() > at && side * u >= 0.0;
    if beyond { (u - at.copysign(u), 1.0) } else { (0.0, 0.0) }
}

/// Logarithm ln(1 + t/t₀) of the time at rest, worn off by slip over a length.
///
/// The rest of the age after slip is that of a contact that has rested for a shorter time; it goes on from there.
pub fn rest(aged: f64, is_at_rest: bool, slip: f64, dt: f64, length: f64, t0: f64) -> f64 {
    if is_at_rest { (aged.exp() + dt / t0).ln() } else { aged * (-slip / length).exp() }
}

#[cfg(test)]
mod tests {
    use super::{bouc_wen, curve, dashpot, rest};

    /// Knots of Bouc and Wen's law of exponent one.
    const BOUC_WEN: [f64; 5] = [1.0, 1.0, 1.0, 0.5, 0.0];

    #[test]
    fn a_curve_through_bouc_wens_slopes_is_bouc_wens_law() {
        for (z, du) in [(0.0, 0.3), (0.9, -0.4), (-0.7, 2.5), (0.4, 1e-3), (-1.9, 5.0), (1.2, -7.0)] {
            let (a, b) = (curve(z, du, 2.0, &BOUC_WEN), bouc_wen(z, du, 2.0));
            assert!((a.0 - b.0).abs() < 1e-12 && (a.1 - b.1).abs() < 1e-12, "{z} {du}: {a:?} {b:?}");
        }
    }

    #[test]
    fn a_step_of_a_curve_is_many_small_ones() {
        let knots = [0.6, 1.4, 1.0, 0.7, 0.2];
        for (start, du) in [(-2.9, 6.0), (1.1, -0.8), (0.2, 0.1), (2.5, -9.0)] {
            let mut z = start;
            for _ in 0..20_000 {
                z = curve(z, du / 20_000.0, 2.0, &knots).0;
            }
            let (whole, slope) = curve(start, du, 2.0, &knots);
            assert!((whole - z).abs() < 1e-9, "{start} {du}: {whole} {z}");
            let there = curve(start, du * (1.0 + 1e-7), 2.0, &knots).0;
            assert!(((there - whole) / (1e-7 * du) - slope).abs() < 1e-5);
        }
    }

    #[test]
    fn a_worn_contact_ages_from_what_is_left() {
        let after = |aged: f64, time: f64| (0..100).fold(aged, |a, _| rest(a, true, 0.0, time / 100.0, 0.1, 0.5));
        let whole = after(0.0, 3.0);
        assert!((whole - 7f64.ln()).abs() < 1e-12);
        let worn = rest(whole, false, 0.1, 0.01, 0.1, 0.5);
        assert!((worn - whole / 1f64.exp()).abs() < 1e-12);
        // A moment at rest does not bring back what slip has taken.
        assert!(after(worn, 0.02) - worn < 0.02);
        assert!((after(worn, 3.0) - (worn.exp() + 6.0).ln()).abs() < 1e-12);
    }

    #[test]
    fn dashpots_are_linear_about_rest() {
        assert!((dashpot(1e-6, 0.5).0 / 1e-6 - dashpot(0.0, 0.5).1).abs() < 1e-3);
        assert!((dashpot(0.25, 0.5).0 - 0.5).abs() < 1e-4 && (dashpot(-2.0, 1.0).0 + 2.0).abs() < 1e-12);
    }
}
