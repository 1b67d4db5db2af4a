//! Batches: scripts times values of parameters times motions, each case named by a hash of its inputs.
//!
//! A case depends on its own inputs alone. Any part of a plan, in any order, therefore gives the same results.

mod case;
mod plan;
mod rows;

pub use case::{Table, is_complete, prepare, run_case, table, undeclared};
pub use plan::{Case, PlanMotion, is_plan, load, mistake_of_form};

use std::fmt::Write as _;

/// A plan that has been read with all its inputs.
#[derive(Clone, Debug)]
pub struct Plan {
    /// Names of the parameters, in the order of the table of results.
    pub parameters: Vec<String>,
    /// Global variables of the script that become columns of the table of results.
    pub results: Vec<String>,
    /// Motions; empty where the scripts have their own.
    pub motions: Vec<PlanMotion>,
    /// The cases: scripts outermost, then parameters, then motions.
    pub cases: Vec<Case>,
    /// Number of cases that were left out because another has the same inputs.
    pub repeated: usize,
    /// Remarks on the files of the motions.
    pub notes: Vec<String>,
}

/// Bytes as hexadecimal digits.
pub fn hexadecimal(bytes: &[u8]) -> String {
    bytes.iter().fold(String::new(), |mut out, byte| {
        let _ = write!(out, "{byte:02x}");
        out
    })
}
