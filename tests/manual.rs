//! The verification manual: problems with a solution on paper. `validation/closed_form` has the problems, this test runs
//! them and holds `docs/verification` to their results. After a change,
//! `HYSTERON_WRITE=1 cargo test --release --test manual` writes the pages anew.

#![allow(clippy::unwrap_used)]

use hysteron::analysis::Options;
use hysteron::opensees::{FileFormat, Mode, Outputs, commands, kinds};
use hysteron::record::{Memory, Output, RecordError};
use hysteron::run::{End, Run, Settings};
use hysteron::tcl::{OsFiles, Recorded};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};

#[path = "manual/command_pages.rs"]
mod command_pages;
#[path = "manual/pages.rs"]
mod pages;
#[path = "manual/prose.rs"]
mod prose;
#[path = "manual/readme.rs"]
mod readme;
#[path = "manual/testing.rs"]
mod testing;

/// Files of problems, and the titles of their pages.
const FAMILIES: &[(&str, &str)] = &[
    ("beams", "Beams and columns"),
    ("trusses", "Trusses, springs and constraints"),
    ("dynamics", "Integrators, modes, damping and excitations"),
    ("materials", "Uniaxial laws and sections"),
    ("bearings", "Bearings and sliders"),
];

/// Commands whose kinds the index lists.
const LISTED: [&str; 9] = [
    "uniaxialMaterial",
    "nDMaterial",
    "frictionModel",
    "section",
    "element",
    "geomTransf",
    "timeSeries",
    "integrator",
    "algorithm",
];

/// Relative errors below this are round-off, which differs between machines.
const ROUND_OFF: f64 = 1e-9;

/// A result beside its reference.
struct Check {
    what: String,
    value: f64,
    reference: f64,
    tolerance: f64,
    error: f64,
}

/// A problem with its results.
struct Sheet {
    title: String,
    covers: Vec<String>,
    source: String,
    problem: String,
    checks: Vec<Check>,
}

/// Recorders are not part of the sheets.
struct NoOutputs;

impl Outputs for NoOutputs {
    fn create(&mut self, _: &str, _: &Path, _: FileFormat) -> Result<Box<dyn Output>, RecordError> {
        Ok(Box::new(Memory::default()))
    }
}

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

/// Words of a Tcl list without nested braces.
fn words(list: &str) -> Vec<String> {
    let mut out = vec![];
    let mut rest = list.trim();
    while !rest.is_empty() {
        let (word, after) = match rest.strip_prefix('"') {
            Some(quoted) => quoted.split_once('"').unwrap(),
            None => rest.split_once(' ').unwrap_or((rest, "")),
        };
        out.push(word.to_owned());
        rest = after.trim_start();
    }
    out
}

fn sheets(family: &str) -> Vec<Sheet> {
    let console = Recorded::default();
    let settings = Settings { mode: Mode::Run, strict: false, options: Options::default() };
    let mut run = Run::new(settings, Box::new(console.clone()), Box::new(OsFiles), Box::new(NoOutputs));
    let path = root().join(format!("validation/closed_form/{family}.tcl"));
    let end = run.script(path.to_str().unwrap(), &[]);
    assert!(matches!(end, End::Done), "{family}: {end:?}");
    assert!(run.interp.warnings.is_empty(), "{family}: {:?}", run.interp.warnings);
    let mut out: Vec<Sheet> = vec![];
    for line in console.out().lines() {
        let fields: Vec<&str> = line.split('\t').collect();
        let number = |i: usize| fields[i].parse::<f64>().unwrap();
        match fields[0] {
            "sheet" => {
                let [_, title, covers, source, problem] = fields[..] else { panic!("{line}") };
                let (title, source, problem) = (title.to_owned(), source.to_owned(), problem.to_owned());
                out.push(Sheet { title, covers: words(covers), source, problem, checks: vec![] });
            }
            "check" => {
                let (value, reference, tolerance, scale) = (number(2), number(3), number(4), number(5));
                let error = (value - reference).abs() / reference.abs().max(scale);
                let what = fields[1].to_owned();
                out.last_mut().unwrap().checks.push(Check { what, value, reference, tolerance, error });
            }
            _ => panic!("{family} prints {line}"),
        }
    }
    out
}

/// A number to nine digits; what is zero but for round-off is zero.
fn digits(x: f64, scale: f64) -> String {
    if x.abs() <= ROUND_OFF * scale { "0".into() } else { format!("{x:.8e}") }
}

fn page(title: &str, sheets: &[Sheet]) -> String {
    let mut out = format!("# {title}\n");
    for s in sheets {
        let covers: Vec<String> = s.covers.iter().map(|c| format!("`{c}`")).collect();
        let _ = write!(out, "\n## {}\n\n{}\n\n", s.title, s.problem);
        let _ = write!(out, "Verifies {}. Source: {}.\n\n", covers.join(", "), s.source);
        out += "| result | computed | reference | error | tolerance |\n| --- | --- | --- | --- | --- |\n";
        for c in &s.checks {
            let scale = if c.reference == 0.0 { 1.0 } else { c.reference.abs() };
            let error = if c.error < ROUND_OFF { "round-off".into() } else { format!("{:.0e}", c.error) };
            let (value, reference) = (digits(c.value, scale), digits(c.reference, scale));
            let _ = writeln!(out, "| {} | {value} | {reference} | {error} | {:.0e} |", c.what, c.tolerance);
        }
    }
    out
}

/// Words of the scripts of the comparisons with OpenSees, by case.
fn words_of_cases() -> BTreeMap<String, BTreeSet<String>> {
    let mut out: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    for case in fs::read_dir(root().join("validation/opensees")).unwrap().filter_map(|e| Some(e.ok()?.path())) {
        let Ok(files) = fs::read_dir(&case) else { continue };
        let name = case.file_name().unwrap().to_string_lossy().into_owned();
        for file in files.filter_map(|e| Some(e.ok()?.path())).filter(|p| p.extension().is_some_and(|e| e == "tcl")) {
            let text = fs::read_to_string(file).unwrap();
            let lines = text.lines().filter(|l| !l.trim_start().starts_with('#'));
            let split = |c: char| c.is_whitespace() || "{}[]\";".contains(c);
            out.entry(name.clone()).or_default().extend(lines.flat_map(|l| l.split(split)).map(str::to_owned));
        }
    }
    out
}

fn index(families: &[(&str, &str, Vec<Sheet>)]) -> String {
    let count: usize = families.iter().map(|(_, _, s)| s.len()).sum();
    let checks: usize = families.iter().flat_map(|(_, _, s)| s).map(|s| s.checks.len()).sum();
    let mut out = format!(
        "# Verification manual\n\n\
         {count} problems with a solution on paper, {checks} results. A test runs them and holds these pages to the digits that they print, so that a change of any result is seen.\n\
         The scripts are in [validation/closed_form](../../validation/closed_form). Comparisons with the real OpenSees are in [validation/opensees](../../validation/opensees).\n\n\
         | page | problems | results |\n| --- | --- | --- |\n"
    );
    for (file, title, sheets) in families {
        let results: usize = sheets.iter().map(|s| s.checks.len()).sum();
        let _ = writeln!(out, "| [{title}]({file}.md) | {} | {results} |", sheets.len());
    }
    out += "\n## What is covered\n\n\
            Each kind with the pages of its problems and the number of comparisons with OpenSees whose script names it. A dash means that neither has it; other tests of the project may.\n";
    let cases = words_of_cases();
    for command in LISTED {
        let _ = write!(out, "\n### `{command}`\n\n| kind | problems | cases against OpenSees |\n| --- | --- | --- |\n");
        for kind in kinds(command) {
            let named = |w: &str| kind.names.contains(&w) || kind.names.iter().any(|n| w == format!("{command} {n}"));
            let pages = families.iter().filter(|(_, _, s)| s.iter().flat_map(|s| &s.covers).any(|c| named(c)));
            let pages: Vec<String> = pages.map(|(file, _, _)| format!("[{file}]({file}.md)")).collect();
            let compared = cases.values().filter(|w| kind.names.iter().any(|n| w.contains(*n))).count();
            let or_dash = |text: String| if text.is_empty() || text == "0" { "-".into() } else { text };
            let (pages, compared) = (or_dash(pages.join(", ")), or_dash(compared.to_string()));
            let _ = writeln!(out, "| `{}` | {pages} | {compared} |", kind.names[0]);
        }
    }
    out
}

fn families() -> Vec<(&'static str, &'static str, Vec<Sheet>)> {
    FAMILIES.iter().map(|(file, title)| (*file, *title, sheets(file))).collect()
}

/// A generated page is the one in the folder, or is written there where the environment asks for it.
fn held(path: &Path, text: &str) -> bool {
    if std::env::var_os("HYSTERON_WRITE").is_some() {
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
    }
    fs::read_to_string(path).unwrap_or_default() == text
}

#[test]
fn results_are_those_on_paper_and_the_pages_are_those_of_the_results() {
    let families = families();
    for s in families.iter().flat_map(|(_, _, s)| s) {
        assert!(!s.checks.is_empty(), "{} checks nothing", s.title);
        for c in &s.checks {
            let Check { what, value, reference, error, tolerance } = c;
            assert!(error <= tolerance, "{}, {what}: {value}, on paper {reference}, error {error:e}", s.title);
        }
    }
    let folder = root().join("docs/verification");
    let mut pages: Vec<_> = families.iter().map(|(file, title, sheets)| (*file, page(title, sheets))).collect();
    pages.push(("index", index(&families)));
    let stale: Vec<_> =
        pages.iter().filter(|(file, text)| !held(&folder.join(format!("{file}.md")), text)).map(|p| p.0).collect();
    assert!(stale.is_empty(), "HYSTERON_WRITE=1 cargo test --release --test manual writes {stale:?} anew");
}

/// A word that a sheet claims to verify is a command, a kind or an option, and its file uses it.
#[test]
fn what_the_sheets_cover_exists() {
    let known: BTreeSet<&str> = commands().map(|c| c.name).collect();
    for (file, _) in FAMILIES {
        let text = fs::read_to_string(root().join(format!("validation/closed_form/{file}.tcl"))).unwrap();
        let used: String = text.lines().filter(|l| !l.starts_with("sheet ")).collect();
        for c in sheets(file).iter().flat_map(|s| &s.covers) {
            let (command, kind) = c.split_once(' ').unwrap_or(("", c));
            let is_kind = |of: &str| kinds(of).iter().any(|k| k.names.contains(&kind));
            let found = c.starts_with('-')
                || known.contains(c.as_str())
                || is_kind(command)
                || known.iter().any(|n| is_kind(n));
            assert!(found && used.contains(kind), "{file}: {c}");
        }
    }
}
