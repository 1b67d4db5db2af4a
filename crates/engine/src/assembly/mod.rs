//! From the model to equations: which degrees of freedom are unknowns, the pattern of the matrix, and where the
//! entries of each element go.

mod dofs;
mod opensees;
mod pattern;
mod plan;

pub use dofs::{DofError, DofMap, Handler, Imposed, Link, MpScope};
pub use opensees::{TransformedNode, TransformedRow};
pub use pattern::{Pattern, Storage};
pub use plan::Plan;
