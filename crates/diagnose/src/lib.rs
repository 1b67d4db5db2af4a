//! Diagnosis: why a model and a recording differ.
//!
//! [`diagnose`] fits the user's model, proposes what it may have left out ([`hypothesis`]), fits every proposal as an
//! edit of the script or as a fault of a channel ([`candidate`]), weighs them by what they
//! predict on blocks of time that they were not fitted to ([`evidence`]), and says which it is, or that nothing is
//! missing, or that it does not know ([`verdict`]). Runs that are held out are looked at once, at the end.

#![forbid(unsafe_code)]

pub mod candidate;
pub mod evidence;
mod fit;
pub mod hypothesis;
pub mod inspect;
pub mod residual;
pub mod verdict;

pub use fit::checkpoint::{Kept, identity};
pub use verdict::diagnosis::{Diagnosis, Settings, Watch, diagnose};
pub use verdict::report::page;
