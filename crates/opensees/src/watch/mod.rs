//! State that watches analyses: figures of their models, and patterns and steps that have been examined.

pub(crate) mod isolator_damping;
pub(crate) mod overview;
pub(crate) mod softening;

use hysteron_engine::analysis::Kind;
use hysteron_engine::model::{ElementId, Tag};
use std::collections::BTreeSet;

/// Kind and steps of an analysis whose checks have found nothing to stop at.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Checked {
    pub(crate) kind: Kind,
    pub(crate) dt: f64,
}

/// Patterns and steps that have been examined.
#[derive(Debug, Default)]
pub(crate) struct AnalysisChecks {
    /// Analysis that a host may go on with, without the checks before it.
    pub(crate) passed: Option<Checked>,
    /// Patterns that a transient analysis has begun with.
    pub(crate) patterns: BTreeSet<Tag>,
    /// Revision of the model and step of time that were examined before an analysis. Scripts may call it for each step.
    pub(crate) before: Option<(u64, f64)>,
    /// Revision of the model and step for which the stability of an explicit integrator was examined.
    pub(crate) stability: Option<(u64, f64)>,
    /// Largest displacement at the ends of the analyses so far.
    pub(crate) largest_displacement: f64,
    /// Patterns that a static analysis under load control has applied.
    pub(crate) static_patterns: BTreeSet<Tag>,
    /// Euler loads of the beams of a revision of the model.
    pub(crate) euler_loads: Option<(u64, Vec<(ElementId, f64)>)>,
}
