//! The page of a review.

use super::inputs::Inputs;
use super::peaks::Peak;
use crate::cli::balance;
use crate::cli::messages::Messages;
use hysteron::analysis::Energies;
use hysteron::opensees::{AnalysedModel, Tcl};
use hysteron::report::html;
use hysteron::run::End;
use hysteron::tcl::{Files as _, OsFiles};
use std::collections::BTreeMap;

/// Kinds with the pages of their verification; the page of the manual is part of the program.
const VERIFIED: &str = include_str!("../../../docs/verification/index.md");

/// Peaks that change by less than this are not listed one by one.
const SMALL_CHANGE: f64 = 1e-3;
/// Columns that a review lists.
const MAX_LISTED: usize = 60;

/// Contents of a review.
pub(super) struct Page<'a> {
    /// The script as the user named it.
    pub(super) model: &'a str,
    /// Options of the run, in words of the command line.
    pub(super) options: String,
    pub(super) end: &'a End,
    pub(super) interp: &'a Tcl,
    pub(super) inputs: &'a Inputs,
    pub(super) peaks: &'a BTreeMap<String, Vec<Peak>>,
    /// Peaks with half the steps; `None` if that run was not made or not completed.
    pub(super) refined: Option<&'a BTreeMap<String, Vec<Peak>>>,
}

/// A peak in both runs.
struct Change<'a> {
    file: &'a str,
    column: &'a str,
    value: f64,
    refined: f64,
    /// Change as a part of the largest peak of its file with the same kind of response.
    share: f64,
}

impl Page<'_> {
    /// The page as HTML.
    pub(super) fn html(&self) -> String {
        let mut out = html::head(&format!("Review of {}", self.model));
        let changes = self.changes();
        self.summary(&mut out, &changes);
        out += "<h2>Inputs</h2>\n";
        let here = OsFiles.current_dir() + "/";
        let inputs = self.inputs.rows().into_iter();
        let inputs = inputs.map(|(path, hash)| vec![path.strip_prefix(&here).unwrap_or(&path).to_owned(), hash]);
        html::table(&mut out, &["file", "SHA-256"], inputs);
        self.model_table(&mut out);
        out += "<h2>Kinds and what verifies them</h2>\n\
                <p>Problems with a solution on paper and comparisons with OpenSees, of the verification manual of this version. A dash: neither.</p>\n";
        html::table(&mut out, &["command", "kind", "made", "problems on", "cases against OpenSees"], self.kinds());
        self.peak_table(&mut out, &changes);
        self.energy_table(&mut out);
        self.warnings(&mut out);
        html::end(out)
    }

    fn summary(&self, out: &mut String, changes: &[Change<'_>]) {
        let messages = Messages::new();
        let first = match self.end {
            End::Done | End::Exit(0) => "The script was completed.".to_owned(),
            End::Exit(n) => format!("The script ended itself with status {n}."),
            End::Failed(f) => format!("The last analysis failed: {f}."),
            End::Ignored(f) => format!("An analysis failed, and the script went on: {f}."),
            End::Rejected(d) | End::Raised(d) => {
                format!("The script was stopped: {}", messages.line(d, &self.interp.sources))
            }
            End::Interrupted => "The run was interrupted.".to_owned(),
            End::Enough(_) => "The script was not run to its end.".to_owned(),
        };
        let engine = &self.interp.host.engine;
        let worst = changes.iter().max_by(|a, b| a.share.total_cmp(&b.share));
        let steps = match (worst, self.refined) {
            (Some(c), _) => {
                format!("with half the steps peaks change by up to {:.2} % ({}, {})", 100.0 * c.share, c.file, c.column)
            }
            (None, Some(_)) => "no recorder has rows to compare".to_owned(),
            (None, None) => "not known: no second run".to_owned(),
        };
        let balance = match &engine.imbalance {
            Some(i) if i.steps > 0 => {
                format!("{} steps end out of balance, by {:.1} % at most, at {}", i.steps, 100.0 * i.ratio, i.place)
            }
            _ => "every step ends in balance".to_owned(),
        };
        let helped = engine.options.ladder.as_ref().map(|l| l.helped.iter().sum::<usize>());
        let remedies = match helped {
            Some(n) => format!("{n} steps needed another algorithm or shorter steps (--ladder)"),
            None => "none but those of the script".to_owned(),
        };
        html::summary(
            out,
            &first,
            &[
                ("version", format!("hysteron {}", env!("CARGO_PKG_VERSION"))),
                ("options", if self.options.is_empty() { "none".into() } else { self.options.clone() }),
                ("analysis", format!("{} steps, {} iterations", engine.steps, engine.iterations)),
                ("steps", steps),
                ("balance", balance),
                ("energy", self.energy_error()),
                ("remedies", remedies),
                ("warnings", self.interp.warnings.len().to_string()),
            ],
        );
    }

    fn energy_error(&self) -> String {
        let worst = self.models().iter().map(|m| m.error).fold(f64::NAN, f64::max);
        if worst.is_nan() { "no analysis".into() } else { format!("error of the balance {:.2e} %", 100.0 * worst) }
    }

    /// Sizes of the models of the script.
    fn model_table(&self, out: &mut String) {
        out.push_str("<h2>Models</h2>\n");
        let row = |(i, m): (usize, &AnalysedModel)| {
            let classes: Vec<String> = m.size.elements.iter().map(|(class, n)| format!("{n} {class}")).collect();
            vec![(i + 1).to_string(), m.size.nodes.to_string(), classes.join(", ")]
        };
        html::table(out, &["model", "nodes", "elements"], self.models().iter().enumerate().map(row));
    }

    fn models(&self) -> Vec<AnalysedModel> {
        self.interp.host.balances().map(|b| b.models()).unwrap_or_default()
    }

    /// Rows of the kinds that the script has made.
    fn kinds(&self) -> Vec<Vec<String>> {
        let made = self.interp.host.kinds_made.iter();
        made.map(|((command, kind), n)| {
            let (pages, cases) = verified(command, kind).unwrap_or_else(|| ("-".into(), "-".into()));
            vec![(*command).to_owned(), (*kind).to_owned(), n.to_string(), pages, cases]
        })
        .collect()
    }

    /// Peaks in both runs. A change counts against the largest peak of the same file.
    fn changes(&self) -> Vec<Change<'_>> {
        let Some(refined) = self.refined else { return vec![] };
        let mut out = vec![];
        for (file, peaks) in self.peaks {
            let Some(others) = refined.get(file).filter(|o| o.len() == peaks.len()) else { continue };
            let columns = || peaks.iter().zip(others).filter(|(p, _)| p.column != "time");
            let largest = columns().map(|(p, _)| p.value).fold(0.0, f64::max);
            out.extend(columns().filter(|_| largest > 0.0).map(|(p, o)| Change {
                file,
                column: &p.column,
                value: p.value,
                refined: o.value,
                share: (o.value - p.value).abs() / largest,
            }));
        }
        out
    }

    fn peak_table(&self, out: &mut String, changes: &[Change<'_>]) {
        out.push_str("<h2>Peaks of the recorders, and the error of the steps</h2>\n");
        if changes.is_empty() {
            out.push_str("<p>There is nothing to compare.</p>\n");
            return;
        }
        let mut sorted: Vec<&Change<'_>> = changes.iter().collect();
        sorted.sort_by(|a, b| b.share.total_cmp(&a.share));
        let listed = sorted.iter().take(MAX_LISTED);
        let row = |c: &&Change<'_>| {
            let numbers = [c.value, c.refined].map(html::number);
            let [value, refined] = numbers;
            vec![c.file.to_owned(), c.column.to_owned(), value, refined, format!("{:.3} %", 100.0 * c.share)]
        };
        html::table(
            out,
            &["recorder", "column", "peak", "with half the steps", "change, of the largest peak of the file"],
            listed.map(row),
        );
        let small = changes.iter().filter(|c| c.share < SMALL_CHANGE).count();
        *out +=
            &format!("<p>{small} of {} columns change by less than {} %.</p>\n", changes.len(), 100.0 * SMALL_CHANGE);
    }

    fn energy_table(&self, out: &mut String) {
        out.push_str("<h2>Energy</h2>\n<p>In units of force times length, relative to the ground, at the end of each model of the script.</p>\n");
        let models = self.models();
        let rows = models.iter().enumerate().flat_map(|(i, m)| energy_rows(i + 1, &m.energies, m.error));
        html::table(out, &["model", "energy", "value", "share of the input"], rows);
    }

    fn warnings(&self, out: &mut String) {
        out.push_str("<h2>Warnings</h2>\n");
        let messages = Messages::new();
        if self.interp.warnings.is_empty() {
            out.push_str("<p>None.</p>\n");
            return;
        }
        out.push_str("<ul>\n");
        for w in &self.interp.warnings {
            *out += &format!("<li>{}</li>\n", html::escaped(&messages.line(w, &self.interp.sources)));
        }
        out.push_str("</ul>\n");
    }
}

fn energy_rows(model: usize, e: &Energies, error: f64) -> Vec<Vec<String>> {
    let mut rows = balance::rows(e);
    if let Some((name, _)) = rows.last_mut() {
        *name += &format!(" (largest on the way {:.2e} %)", 100.0 * error);
    }
    let row = |(name, x): (String, f64)| vec![model.to_string(), name, html::number(x), balance::share_of_input(x, e)];
    rows.into_iter().map(row).collect()
}

/// Pages of problems and number of cases of a kind, as the index of the manual has them.
fn verified(command: &str, kind: &str) -> Option<(String, String)> {
    let section = VERIFIED.split_once(&format!("### `{command}`\n"))?.1;
    let section = section.split("\n### ").next()?;
    let row = section.lines().find(|l| l.starts_with(&format!("| `{kind}` |")))?;
    let mut cells = row.split('|').map(str::trim).skip(2);
    let (pages, cases) = (cells.next()?, cells.next()?);
    // `[beams](beams.md)`: the name is enough.
    let names: Vec<&str> = pages.split(", ").map(|p| p.split(['[', ']']).nth(1).unwrap_or(p)).collect();
    Some((names.join(", "), cases.to_owned()))
}

#[cfg(test)]
mod tests {
    #[test]
    fn kinds_of_the_manual_are_found() {
        let (pages, cases) = super::verified("element", "elastomericBearingBoucWen").expect("a row");
        assert_eq!(pages, "bearings");
        assert!(cases.parse::<usize>().is_ok_and(|n| n > 0), "{cases}");
        assert_eq!(super::verified("element", "noSuchElement"), None);
    }
}
