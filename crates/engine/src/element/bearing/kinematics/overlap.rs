//! Overlap area of the two end plates of a sheared round bearing.

use crate::numeric::real::Real;
use std::f64::consts::PI;

/// Ratio of the overlap area of two equal circles to their area, and its derivative by `x`, the distance of the centres
/// in diameters. The ratio is (Δ - sin Δ) / π with Δ = 2 acos x.
#[inline(always)]
pub fn overlap<T: Real>(x: T) -> (T, T) {
    // sin Δ = 2 sin(Δ/2) cos(Δ/2)
    let chord = (T::ONE - x * x).sqrt();
    let half = x.one_by_one(T::ALL, f64::acos);
    let share = (half - x * chord) * 2.0 / PI;
    (T::ONE.where_greater(x, share, T::ZERO), T::ONE.where_greater(x, chord * -4.0 / PI, T::ZERO))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::overlap;

    #[test]
    fn overlap_shrinks_from_all_to_nothing() {
        assert_eq!(overlap(0.0).0, 1.0);
        assert_eq!(overlap(1.0).0, 0.0);
        assert_eq!(overlap(1.5), (0.0, 0.0));
        // At half a diameter: 2/3 - √3/(2π).
        assert!((overlap(0.5).0 - (2.0 / 3.0 - 3.0f64.sqrt() / (2.0 * std::f64::consts::PI))).abs() < 1e-15);
        let (h, x) = (1e-6, 0.37);
        let slope = (overlap(x + h).0 - overlap(x - h).0) / (2.0 * h);
        assert!((overlap(x).1 - slope).abs() < 1e-8);
    }
}
