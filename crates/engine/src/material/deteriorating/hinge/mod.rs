//! Parts that the laws of deteriorating plastic hinges share (Ibarra, Medina and Krawinkler, 2005, <https://doi.org/10.1002/eqe.495>).

mod envelope;

use crate::material::MaterialError;
pub(super) use envelope::Envelope;

/// Slope of a horizontal branch; rules recognise a branch without force by it.
pub(super) const FLAT: f64 = 1e-7;
/// Force of a hinge without strength, as in OpenSees.
pub(super) const NOTHING: f64 = 1e-10;

/// Slope ratio of a hinge, which is (1 + n) times as stiff as the elastic member in series with it, for a slope ratio
/// of member and hinge together (Ribeiro, Barbosa, Scott and Neves, 2015).
#[inline]
pub(super) fn of_hinge(n: f64, ratio: f64) -> f64 {
    ratio / (1.0 + n * (1.0 - ratio))
}

/// Slope ratio of member and hinge together for a slope ratio of the hinge.
#[inline]
pub(super) fn of_member(n: f64, ratio: f64) -> f64 {
    ratio * (1.0 + n) / (1.0 + n * ratio)
}

/// Sign of a side by its index.
#[inline]
pub(super) fn sign(side: usize) -> f64 {
    if side == 0 { 1.0 } else { -1.0 }
}

/// Error of a hinge whose parameters are out of range.
pub(super) fn no_force(name: &str, deformation: f64) -> MaterialError {
    MaterialError(format!("{name} has no force at a deformation of {deformation:.6e}"))
}
