//! The summary of a review: the design displacement, checks that are not met, what governs.

use super::governing::mean_from;
use super::rules::DISPLACEMENT;
use super::{DesignValue, Review};
use crate::check::{Check, Status};
use crate::isolate::{BOUNDS, JobOutcome, Study};
use hysteron_identify::report::html::number;

/// The subject of a check without its bound and what follows a comma.
fn kind_of(c: &Check) -> (&str, &str) {
    let (bound, rest) = c.subject.split_once(": ").filter(|(b, _)| BOUNDS.contains(b)).unwrap_or(("", &c.subject));
    (bound, rest.split([',', ';']).next().unwrap_or(rest))
}

/// For each kind of check the bound with the worst result, the worst kinds first.
pub(super) fn worst(checks: &[Check]) -> Vec<Check> {
    let rank = |c: &Check| match c.status {
        Status::NotMet => 0,
        Status::Scaled => 1,
        Status::NeedsHistory | Status::NeedsSecondOrder => 2,
        Status::Met => 3,
        Status::NotChecked => 4,
    };
    let is_worse = |a: &Check, b: &Check| rank(a) < rank(b) || (rank(a) == rank(b) && a.ratio > b.ratio);
    let mut out: Vec<Check> = vec![];
    for c in checks.iter().filter(|c| c.status != Status::NotChecked) {
        let same = |o: &&mut Check| kind_of(o).1 == kind_of(c).1 && kind_of(o).0.is_empty() == kind_of(c).0.is_empty();
        match out.iter_mut().find(same) {
            Some(other) if is_worse(c, other) => *other = c.clone(),
            Some(_) => {}
            None => out.push(c.clone()),
        }
    }
    out.sort_by(|a, b| rank(a).cmp(&rank(b)).then(b.ratio.total_cmp(&a.ratio)));
    out
}

/// Subject, demand and limit of a check, with its clause.
fn in_words(c: &Check) -> String {
    let clause = if c.citation.clause.is_empty() { String::new() } else { format!(" ({})", c.citation.clause) };
    format!("{}: {}, {} {}{clause}", c.subject, number(c.demand), c.sense.words(), number(c.limit))
}

/// The largest design displacement of the bearings over the bounds; `None` without one.
fn displacement(review: &Review) -> Option<&DesignValue> {
    let all = review.values.iter().filter(|v| v.quantity == DISPLACEMENT && v.design.is_finite());
    all.max_by(|a, b| a.design.total_cmp(&b.design))
}

/// Parts of the summary: a heading and a text each. They stand on the first page of the report and at the end of the terminal's
/// tables.
pub(super) fn parts(study: &Study, outcomes: &[JobOutcome], review: &Review) -> Vec<(&'static str, String)> {
    let worst = worst(&review.checks);
    // Motions that are missing say nothing about the structure.
    let governs = worst.iter().find(|c| [Status::NotMet, Status::Met].contains(&c.status) && !c.is_of_suite);
    let governs = governs.map_or("no check has a limit".to_owned(), |c| {
        let ratio = if c.ratio.is_finite() { format!(", ratio {}", number(c.ratio)) } else { String::new() };
        in_words(c) + &ratio
    });
    let scaled: Vec<String> = review
        .values
        .iter()
        .filter(|v| v.factor > 1.0)
        .map(|v| format!("{} of the {} bound by {}", v.quantity, v.bound, number(v.factor)))
        .collect();
    let counts = if study.motions.len() >= mean_from(study) { "mean" } else { "largest" };
    let count: usize = study.bearings.iter().map(|b| b.tags.len()).sum();
    let mut parts = vec![];
    if let Some(v) = displacement(review) {
        parts.push(("design displacement", format!("{} {}, {} bound", number(v.design), v.unit, v.bound)));
    }
    parts.extend(worst.iter().filter(|c| c.status == Status::NotMet).map(|c| ("not met", in_words(c))));
    parts.extend([
        ("governs", governs),
        ("scaled up", if scaled.is_empty() { "nothing".into() } else { scaled.join("; ") }),
        ("system", format!("{count} bearings under {} {}", number(study.weight), study.units[0])),
        ("suite", format!("{} pairs, {} analyses; the {counts} response governs", study.motions.len(), outcomes.len())),
        ("code", study.code.name.clone()),
    ]);
    parts
}
