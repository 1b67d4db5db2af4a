//! Tables of the page of causes, which follow from the declarations of the hypotheses.

use hysteron::diagnose::hypothesis::ALL;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

const BEGIN: &str = "<!-- written by HYSTERON_WRITE=1 cargo test --test reference: ";
const END: &str = "<!-- end -->";

/// Answers that are no cause of the library: what was left out, and what would refute them.
const OTHER_ANSWERS: [[&str; 3]; 2] = [
    [
        "none",
        "nothing: what the model leaves is noise",
        "an effect of the library gains on samples that it was not fitted to",
    ],
    ["unknown", "something that no cause of the library explains", "a repeated run does not show the same residual"],
];

pub fn path() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/reference/causes.md")
}

/// The page with the tables of the library in the place of its own.
pub fn renewed(page: &str) -> String {
    let left_out = ALL.iter().map(|h| vec![code(h.cause), h.statement.into(), h.refuted_by.into()]);
    let others = OTHER_ANSWERS.map(|[name, left_out, refuted_by]| vec![code(name), left_out.into(), refuted_by.into()]);
    let like = |h: &hysteron::diagnose::hypothesis::Hypothesis| match h.look_alikes {
        [] => "none".to_owned(),
        causes => causes.iter().map(|c| code(c)).collect::<Vec<_>>().join(", "),
    };
    let tables = [
        ("left out", table(&["cause", "what was left out", "refuted if"], others.into_iter().chain(left_out))),
        (
            "shown",
            table(
                &["cause", "the recordings show", "what parts it from others"],
                ALL.iter().map(|h| vec![code(h.cause), h.shows.into(), h.parted_by.into()]),
            ),
        ),
        ("look-alikes", table(&["cause", "look-alikes"], ALL.iter().map(|h| vec![code(h.cause), like(h)]))),
        (
            "proposed",
            table(
                &["cause", "where", "forms"],
                ALL.iter().map(|h| vec![code(h.cause), h.place.into(), h.forms.into()]),
            ),
        ),
    ];
    tables.into_iter().fold(page.to_owned(), |page, (name, table)| {
        let mark = format!("{BEGIN}{name} -->");
        let (before, after) = page.split_once(&mark).unwrap_or_else(|| panic!("causes.md has no table {name}"));
        let (_, after) = after.split_once(END).unwrap();
        format!("{before}{mark}\n\n{table}\n{END}{after}")
    })
}

fn code(name: &str) -> String {
    format!("`{name}`")
}

fn table(head: &[&str], rows: impl Iterator<Item = Vec<String>>) -> String {
    let mut out = format!("| {} |\n|{}\n", head.join(" | "), " --- |".repeat(head.len()));
    rows.for_each(|cells| writeln!(out, "| {} |", cells.join(" | ")).unwrap());
    out
}
