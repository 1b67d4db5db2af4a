//! `hysteron run --review FILE`: a page about a run for the engineer who has to trust it.
//!
//! Beside the results stand the inputs by their hashes, what verifies each kind that the script uses, the error of the steps
//! (from a second run with half of them), the balance of energy, and all warnings.

mod inputs;
mod page;
mod peaks;

pub(super) use inputs::{Inputs, ReadFiles};
pub(super) use page::Page;
pub(super) use peaks::{Peak, Peaks, WithPeaks};
