//! The register of checks: what messages about scripts have in common, and what their codes mean.
//!
//! A warning names its check, so that a search for the name finds every place that gives it. The page of checks in the reference
//! and `hysteron explain` follow from the register.

pub mod analysis;
pub mod elements;
pub mod load;
pub mod materials;
pub mod model;
pub mod output;
pub mod words;

use hysteron_tcl::check::{self, Check};

/// A family of checks: a title and the checks.
pub type Family = (&'static str, &'static [&'static Check]);

/// The whole register, by families.
pub fn families() -> [Family; 8] {
    [
        ("Language", check::ALL),
        ("Words of commands", words::ALL),
        ("Nodes, constraints and parameters", model::ALL),
        ("Elements and sections", elements::ALL),
        ("Materials", materials::ALL),
        ("Loads, series and records", load::ALL),
        ("Recorders and queries", output::ALL),
        ("Analyses", analysis::ALL),
    ]
}
