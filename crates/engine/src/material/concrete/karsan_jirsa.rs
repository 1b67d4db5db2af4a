//! Lines of unloading of concrete after Karsan and Jirsa (1969).

use crate::numeric::lanes::select;

/// Permanent strain after the smallest strain `min`, from the strains at the strength and at crushing.
#[inline(always)]
pub(super) fn permanent_strain(min: f64, epsc0: f64, epscu: f64) -> f64 {
    let eta = select(min > epscu, min, epscu) / epsc0;
    let ratio = select(eta < 2.0, 0.145 * eta * eta + 0.13 * eta, 0.707 * (eta - 2.0) + 0.834);
    ratio * epsc0
}

/// Strain of zero stress and slope of the unloading line from a point of the envelope to the permanent strain. The line
/// is not steeper than the initial modulus.
#[inline(always)]
pub(super) fn unloading_line([min, stress]: [f64; 2], permanent: f64, modulus: f64) -> (f64, f64) {
    let (length, elastic) = (min - permanent, stress / modulus);
    let (none, long) = (length > -f64::EPSILON, length <= elastic);
    let end = select(none, permanent, min - select(long, length, elastic));
    (end, select(!none & long, stress / length, modulus))
}
