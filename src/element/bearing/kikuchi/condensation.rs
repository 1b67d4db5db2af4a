//! Taking the inner nodes out of the equations of a Kikuchi bearing.

use super::kinematics::{DOFS, INNER, Matrix, Motion, OUTER};
use nalgebra::{SMatrix, SVector};

/// Displacements or forces of the inner nodes.
pub(super) type Inner = SVector<f64, INNER>;
/// What the inner nodes do for the outer ones.
pub(super) type Follow = SMatrix<f64, INNER, OUTER>;

/// Share of the virgin stiffness that holds inner nodes which no spring holds any more.
const HOLD: f64 = 1e-10;

/// The equations with the inner nodes taken out.
pub(super) struct Condensed {
    /// How the inner nodes follow the outer ones.
    pub follow: Follow,
    /// How they yield to the force that is left at them.
    pub correction: Inner,
    /// Forces at the outer nodes once they have yielded.
    pub force: [f64; OUTER],
    /// Their stiffness.
    pub stiffness: [[f64; OUTER]; OUTER],
}

/// Condense forces `f` and stiffness `k`; `hold` is the virgin stiffness at the inner nodes.
pub(super) fn condense(f: &Motion, k: &Matrix, hold: &Inner) -> Option<Condensed> {
    let mut k22: SMatrix<f64, INNER, INNER> = k.fixed_view::<INNER, INNER>(OUTER, OUTER).into();
    (0..INNER).for_each(|i| k22[(i, i)] += HOLD * hold[i]);
    let k21: Follow = k.fixed_view::<INNER, OUTER>(OUTER, 0).into();
    let k12: SMatrix<f64, OUTER, INNER> = k.fixed_view::<OUTER, INNER>(0, OUTER).into();
    let mut right = SMatrix::<f64, INNER, { OUTER + 1 }>::zeros();
    right.fixed_view_mut::<INNER, OUTER>(0, 0).copy_from(&k21);
    right.fixed_view_mut::<INNER, 1>(0, OUTER).copy_from(&f.fixed_rows::<INNER>(OUTER));
    let solved = -k22.lu().solve(&right)?;
    if solved.iter().any(|x| !x.is_finite()) {
        return None;
    }
    let follow: Follow = solved.fixed_view::<INNER, OUTER>(0, 0).into();
    let correction: Inner = solved.fixed_view::<INNER, 1>(0, OUTER).into();
    let (yielded, turned) = (k12 * correction, k12 * follow);
    Some(Condensed {
        force: std::array::from_fn(|i| f[i] + yielded[i]),
        stiffness: std::array::from_fn(|i| std::array::from_fn(|j| k[(i, j)] + turned[(i, j)])),
        follow,
        correction,
    })
}

/// All displacements from those of the ends and of the inner nodes.
pub(super) fn join(outer: &[f64; OUTER], inner: &[f64; INNER]) -> Motion {
    Motion::from_fn(|i, _| if i < OUTER { outer[i] } else { inner[i - OUTER] })
}

const _: () = assert!(DOFS == OUTER + INNER);
