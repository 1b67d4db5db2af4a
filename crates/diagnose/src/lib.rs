//! Diagnosis: why a model and a recording differ.
//!
//! [`diagnose`] fits the user's model, proposes what it may have left out ([`hypothesis`]), fits every proposal as an
//! edit of the script ([`variant`], [`insertion`]) or as a fault of a channel ([`correction`]), weighs them by what they
//! predict on blocks of time that they were not fitted to ([`evidence`]), and says which it is, or that nothing is
//! missing, or that it does not know ([`outcome`]). Runs that are held out are looked at once, at the end.

#![forbid(unsafe_code)]

pub mod anatomy;
mod bootstrap;
pub mod columns;
mod conclude;
mod conditions;
pub mod correction;
mod elsewhere;
pub mod evidence;
mod fitting;
pub mod hypothesis;
pub mod insertion;
mod instruments;
pub mod locate;
pub mod neighbours;
pub mod next_test;
pub mod noise;
mod odds;
pub mod outcome;
mod page;
mod pairs;
mod pipeline;
mod prediction;
mod projection;
mod recurrence;
mod regression;
mod repair;
mod resume;
mod rounds;
mod saturation;
pub mod scale;
mod slow_noise;
mod step_error;
mod structure;
mod surrogate;
pub mod variant;
mod watching;
mod work;

pub use page::page;
pub use pipeline::{Diagnosis, Settings, Watch, diagnose};
pub use resume::{Kept, identity};
