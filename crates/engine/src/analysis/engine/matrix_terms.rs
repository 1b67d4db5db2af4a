//! The terms of a matrix that systems of equations of OpenSees hold.

/// Terms of the matrix that a system of equations of OpenSees holds. The solution here always has all of them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum MatrixTerms {
    /// Every term (`FullGeneral`).
    All,
    /// Terms between degrees of freedom that an element joins.
    #[default]
    OfElements,
    /// The diagonal (`Diagonal`).
    Diagonal,
}
