//! `docs/testing.md`: how the project is tested, with counts that are taken from the tests themselves.

use super::{Sheet, held, root};
use hysteron::opensees::kinds;
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};

/// Tests of one group of files.
#[derive(Default)]
struct Tests {
    examples: usize,
    properties: usize,
    ignored: usize,
}

/// All files below a folder with an extension, in order.
fn files(folder: &Path, extension: &str) -> Vec<PathBuf> {
    let mut out = vec![];
    for entry in fs::read_dir(folder).into_iter().flatten() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_str().unwrap();
        if path.is_dir() && !["target", "node_modules"].contains(&name) {
            out.extend(files(&path, extension));
        } else if path.extension().is_some_and(|e| e == extension) {
            out.push(path);
        }
    }
    out.sort();
    out
}

/// A property takes its arguments `in` a strategy; an ignored test is run by hand.
fn count(folder: &str) -> Tests {
    let mut out = Tests::default();
    for path in files(&root().join(folder), "rs") {
        let text = fs::read_to_string(path).unwrap();
        for after in text.split("\n    #[test]\n").flat_map(|t| t.split("\n#[test]\n")).skip(1) {
            let head = after.split_once('{').map_or(after, |(head, _)| head);
            if head.contains("#[ignore") {
                out.ignored += 1;
            } else if head.contains(" in ") {
                out.properties += 1;
            } else {
                out.examples += 1;
            }
        }
    }
    out
}

/// Rows of a table of counts after its header, and the sum of a column.
pub(crate) fn counted(file: &str, column: &str) -> (usize, u64) {
    let text = fs::read_to_string(root().join(file)).unwrap();
    let mut lines = text.lines();
    let place = lines.next().unwrap().split(',').position(|name| name == column).unwrap();
    let cells: Vec<u64> = lines.map(|line| line.split(',').nth(place).unwrap().parse().unwrap()).collect();
    (cells.len(), cells.iter().sum())
}

/// Folders in a folder.
pub(crate) fn folders(folder: &str) -> usize {
    fs::read_dir(root().join(folder)).unwrap().filter(|e| e.as_ref().unwrap().path().is_dir()).count()
}

pub(crate) fn rows(file: &str) -> usize {
    fs::read_to_string(root().join(file)).unwrap().lines().count() - 1
}

/// An integer with commas between thousands.
fn grouped(number: u64) -> String {
    let digits = number.to_string();
    let mut out = String::new();
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            out.push(',');
        }
        out.push(digit);
    }
    out
}

fn tests_table() -> String {
    let mut out = String::from("| tests | examples | properties | run by hand |\n| --- | --- | --- | --- |\n");
    let mut sum = Tests::default();
    for (folder, content) in [
        ("crates/tcl", "the Tcl language and its expressions"),
        ("crates/engine", "elements, laws, sections, solvers"),
        ("crates/opensees", "commands, recorders, messages"),
        ("crates/identify", "studies, calibration, posteriors"),
        ("crates/diagnose", "screening, amendments, verdicts"),
        ("crates/design", "codes, motions, prototype tests"),
        ("crates/view", "pages and exports"),
        ("src", "the command line"),
        ("tests", "whole scripts and studies through the program"),
    ] {
        let Tests { examples, properties, ignored } = count(folder);
        let _ = writeln!(out, "| `{folder}`: {content} | {examples} | {properties} | {ignored} |");
        sum.examples += examples;
        sum.properties += properties;
        sum.ignored += ignored;
    }
    let _ = writeln!(out, "| all | {} | {} | {} |", sum.examples, sum.properties, sum.ignored);
    out
}

fn references(sheets: &[&Sheet]) -> String {
    let cases: serde_json::Value =
        serde_json::from_str(&fs::read_to_string(root().join("validation/opensees/cases.json")).unwrap()).unwrap();
    let cases = cases.as_object().unwrap();
    let compared: usize = cases.values().map(|case| case["files"].as_array().map_or(0, Vec::len)).sum();
    let checks: usize = sheets.iter().map(|s| s.checks.len()).sum();
    let work = fs::read_to_string(root().join("tests/snapshots/work_counts.snap")).unwrap();
    let laws = ["uniaxialMaterial", "element"].map(|command| kinds(command).len());
    let mut out = String::from("| held against | count | run by |\n| --- | --- | --- |\n");
    let mut row = |what: &str, count: String, by: &str| {
        let _ = writeln!(out, "| {what} | {count} | {by} |");
    };
    row(
        "[the real OpenSees](../validation/opensees)",
        format!("{} scripts, {compared} files of results", cases.len()),
        "`cargo test --test validation`",
    );
    row(
        "[solutions on paper](verification/index.md)",
        format!("{} problems, {checks} results", sheets.len()),
        "`cargo test --test manual`",
    );
    row(
        "finite differences of forces: the tangent of each uniaxial law and each element",
        format!("{} laws, {} elements", laws[0], laws[1]),
        "`cargo test --test laws`",
    );
    row(
        "their own last result: steps, iterations, factors and calls of laws",
        format!("{} scripts", work.lines().filter(|l| l.contains(".tcl")).count()),
        "`cargo test --test work_counts`",
    );
    row(
        "their annotations: shipped scripts, each run to its end",
        format!("{} scripts", files(&root().join("tcl-like-inputs"), "tcl").len()),
        "`cargo test --test validation`",
    );
    row(
        "[public scripts](../validation/scripts.csv) in both programs, by repository",
        format!("{} repositories", rows("validation/scripts.csv")),
        "`validation/scripts.py`",
    );
    row(
        "[concealed causes](../validation/diagnosis/trials.md) with a known truth, made from seeds",
        format!("{} diagnoses", rows("validation/diagnosis/trials.csv")),
        "`validation/diagnosis/trials.py`",
    );
    row(
        "[sealed batches](../validation/diagnosis/outcomes.md), opened once",
        format!("{} cases", rows("validation/diagnosis/outcomes.csv")),
        "`validation/diagnosis/run.py`",
    );
    row(
        "[measured recordings](../validation/recordings), with every miss",
        format!("{} studies", files(&root().join("validation/recordings"), "toml").len()),
        "`validation/recordings/run.py`",
    );
    out
}

fn broken_on_purpose() -> String {
    let (runs, inputs) = counted("fuzz/counts.csv", "inputs");
    let (_, defects) = counted("fuzz/counts.csv", "defects");
    let (scripts, kills) = counted("validation/kills.csv", "kills");
    let (_, other) = counted("validation/kills.csv", "rounds_that_differ");
    let targets = files(&root().join("fuzz/fuzz_targets"), "rs").len();
    format!(
        "{targets} fuzz targets ([fuzz](../fuzz/README.md)) look for inputs that end in a panic, a hang, much memory, or a number that is not one. \
         {} inputs were run in {runs} runs ([counts](../fuzz/counts.csv)); defects that ended a run: {defects}. \
         The same generator makes some hundred inputs in every run of the tests (`tests/fuzz.rs`).\n\n\
         {} scripts were killed at {} random moments (`validation/kills.py`) and went on from their checkpoints ([counts](../validation/kills.csv)); \
         runs that wrote other bytes than one that was left alone: {other}.\n",
        grouped(inputs),
        scripts,
        grouped(kills)
    )
}

/// The page with the counts of today.
pub(crate) fn page(sheets: &[&Sheet]) -> String {
    format!(
        "# How hysteron is tested\n\n\
         {}\
         Numbers on this page are counted by a test, which fails when they change. `HYSTERON_WRITE=1 cargo test --release --test manual` writes it anew.\n\n\
         ## Tests of every change\n\n\
         `.ci/run` runs them all on a clean copy, with formatting, clippy without warnings, and the first analysis of the README.\n\
         An example is a test of one situation. A property is tried with random inputs, and fails with the smallest that breaks it.\n\n\
         {}\n\
         ## References\n\n\
         {}\n\
         ## Broken on purpose\n\n\
         {}\n\
         {}",
        "Each promise of the program has a test that fails when it is broken. A promised number has an outside reference.\n",
        tests_table(),
        references(sheets),
        broken_on_purpose(),
        BESIDE
    )
}

/// Checks of their own, and what no test sees.
const BESIDE: &str = "\
## Beside the tests

These need more than a Rust toolchain, or hours. They are run before a release.

| check | command |
| --- | --- |
| fuzzing with libFuzzer | `fuzz/run.sh 3600` |
| kills at random moments, and runs that go on | `validation/kills.py` |
| licences, sources and advisories of dependencies; the declared minimum version of Rust | `scripts/audit.sh` |
| pages in a real browser | `tests/browser/check.py`, `tests/browser/view.py` |
| Python | `pytest` in `bindings/python` |
| speed compared with OpenSees, with the difference of results | `benches/peer.py` |
| frames, walls and bearings drawn at random, in both programs | `benches/random_*.py` |
| the diagnosis: trials, sealed batches, benchmark, ablation of its constants | [validation/diagnosis](../validation/diagnosis/README.md) |

## Not tested

- Platforms other than Linux on x86-64: they are built, not run.
- Numbers of models that neither OpenSees nor paper nor another reference gives. The [index](verification/index.md) shows kinds with a dash.
- Texts of building codes: the rules in `crates/design/codes` say for each clause whether its text was read.
";

#[test]
fn the_page_on_testing_has_the_counts_of_the_tests() {
    let families = super::families();
    let sheets: Vec<&Sheet> = families.iter().flat_map(|(_, _, s)| s).collect();
    assert!(
        held(&root().join("docs/testing.md"), &page(&sheets)),
        "HYSTERON_WRITE=1 cargo test --release --test manual writes docs/testing.md anew"
    );
}
