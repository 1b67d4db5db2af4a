//! Inside a crate the layers hold: a module uses only those before it. Between crates the compiler holds them.
//! Libraries neither print nor exit nor panic; files stay small.

#![allow(clippy::unwrap_used, unreachable_pub)]

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

/// Modules of a crate, each of which may use those before it.
const LAYERS: &[(&str, &[&str])] = &[
    (
        "engine",
        &[
            "numeric",
            "state_struct",
            "bytes",
            "number_format",
            "probe",
            "rules",
            "series",
            "material",
            "section",
            "element",
            "model",
            "assembly",
            "solve",
            "analysis",
            "record",
        ],
    ),
    ("files", &["system", "read", "scratch", "write", "folder", "lock", "result_file"]),
    ("identify", &["fourier", "halton", "measure", "protocol", "study", "report", "preflight", "calibrate"]),
    (
        "design",
        &[
            "codes",
            "check",
            "motion",
            "spectrum",
            "target",
            "scaling",
            "suite",
            "prototype",
            "lateral_force",
            "fragility",
            "performance",
            "isolate",
            "incremental",
            "multimode",
            "batch",
        ],
    ),
    (
        "diagnose",
        &[
            "prior",
            "series",
            "inspect",
            "candidate",
            "hypothesis",
            "residual",
            "fit",
            "evidence",
            "verdict",
            // Unit tests alone use it.
            "test_support",
        ],
    ),
];

fn files(dir: &Path, out: &mut Vec<PathBuf>) {
    let mut entries: Vec<PathBuf> = fs::read_dir(dir).unwrap().map(|e| e.unwrap().path()).collect();
    entries.sort();
    for path in entries {
        if path.is_dir() {
            files(&path, out);
        } else if path.extension().is_some_and(|e| e == "rs") {
            out.push(path);
        }
    }
}

fn sources(dir: &str) -> Vec<(PathBuf, String)> {
    let mut all = vec![];
    files(&Path::new(env!("CARGO_MANIFEST_DIR")).join(dir), &mut all);
    all.into_iter().map(|p| (p.clone(), fs::read_to_string(p).unwrap())).collect()
}

/// The module of a crate that a file belongs to; none for the root of the crate.
fn module(path: &Path, root: &Path) -> Option<String> {
    let first = path.strip_prefix(root).ok()?.iter().next()?.to_str()?.trim_end_matches(".rs").to_owned();
    (first != "lib").then_some(first)
}

/// Modules that a text uses, its unit tests left out: `crate::name` and `crate::{name, ...}`.
fn used(text: &str) -> Vec<String> {
    let text = text.split("#[cfg(test)]\nmod tests").next().unwrap_or("");
    let code: String = text.lines().filter(|l| !l.trim_start().starts_with("//")).collect::<Vec<_>>().join("\n");
    let mut out = vec![];
    for part in code.split("crate::").skip(1) {
        let word = |s: &str| s.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect::<String>();
        match part.strip_prefix('{') {
            Some(list) => out.extend(list.split('}').next().unwrap_or("").split(',').map(|w| word(w.trim()))),
            None => out.push(word(part)),
        }
    }
    out
}

#[test]
fn modules_use_only_those_before_them() {
    let mut wrong = vec![];
    for (name, layers) in LAYERS {
        let order: BTreeMap<&str, usize> = layers.iter().enumerate().map(|(i, l)| (*l, i)).collect();
        let dir = format!("crates/{name}/src");
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join(&dir);
        for (path, text) in sources(&dir) {
            let Some(own) = module(&path, &root) else { continue };
            let Some(&place) = order.get(own.as_str()) else {
                wrong.push(format!("{}: module {own} is in no layer", path.display()));
                continue;
            };
            for other in used(&text).iter().filter(|o| order.get(o.as_str()).is_some_and(|there| *there > place)) {
                wrong.push(format!("{}: {own} uses {other}", path.display()));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn libraries_neither_print_nor_exit_nor_panic() {
    let banned = ["println!", "eprintln!", "print!(", "process::exit", "panic!(", "todo!(", "unimplemented!(", "dbg!("];
    let mut wrong = vec![];
    for name in ["files", "tcl", "engine", "opensees", "identify", "diagnose", "design", "view"] {
        for (path, text) in sources(&format!("crates/{name}/src")) {
            let code = text.split("#[cfg(test)]").next().unwrap_or("");
            for (i, line) in code.lines().enumerate().filter(|(_, l)| !l.trim_start().starts_with("//")) {
                for b in banned.iter().filter(|b| line.contains(**b)) {
                    wrong.push(format!("{}:{}: {b}", path.display(), i + 1));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// The crates and the command line touch files through `crates/files` alone, which bounds what is read and follows no link where
/// it writes. Tests, examples and build scripts may use the standard library.
#[test]
fn files_are_touched_through_one_crate() {
    let mut wrong = vec![];
    for (path, text) in ["src", "crates", "bindings"].into_iter().flat_map(sources) {
        let parts: Vec<&str> = path.iter().filter_map(|p| p.to_str()).collect();
        let is_test = |p: &&str| ["tests", "tests.rs", "examples", "benches", "build.rs", "target"].contains(p);
        if parts.iter().any(is_test) || path.starts_with(Path::new(env!("CARGO_MANIFEST_DIR")).join("crates/files")) {
            continue;
        }
        let code = text.split("#[cfg(test)]").next().unwrap_or("");
        for (i, line) in code.lines().enumerate().filter(|(_, l)| !l.trim_start().starts_with("//")) {
            // `RowFile::create` is a name of ours.
            let opens = |what: &&str| {
                let before = |at: usize| line[..at].chars().last().is_some_and(|c| c.is_alphanumeric() || c == '_');
                line.match_indices(*what).any(|(at, _)| !before(at))
            };
            if ["std::fs", "std::{fs", "File::open(", "File::create("].iter().any(opens) {
                wrong.push(format!("{}:{}: {}", path.display(), i + 1, line.trim()));
            }
        }
    }
    assert!(wrong.is_empty(), "use hysteron_files:\n{}", wrong.join("\n"));
}

/// An element around another one forwards every method of the trait, defaulted ones too: the lint names those that are missing.
#[test]
fn wrappers_of_elements_forward_every_method() {
    const HELD: &str = "#[deny(clippy::missing_trait_methods)]";
    let (mut wrappers, mut wrong) = (0, vec![]);
    for (path, text) in sources("crates").into_iter().filter(|(_, text)| text.contains(": Arc<dyn Element>,\n")) {
        for (at, _) in text.match_indices("\nimpl Element for ") {
            wrappers += 1;
            if text[..at].lines().last() != Some(HELD) {
                wrong.push(path.display().to_string());
            }
        }
    }
    assert!(wrappers >= 2, "only {wrappers} found");
    assert!(wrong.is_empty(), "{HELD} is missing in\n{}", wrong.join("\n"));
}

/// Lines outside `opensees*.rs` and the commands that may decide by the flag `compat`.
const MAX_DECISIONS: usize = 45;

/// OpenSees' rules are in `opensees.rs` of the folder of a law, and the commands choose them. A line counts as a decision if it has the
/// word `compat` and a condition.
#[test]
fn decisions_about_slips_are_few() {
    const CONDITIONS: [&str; 10] =
        ["if ", "match ", "&&", "||", "!", "is_some()", "is_none()", "then", "filter", "let Some"];
    let word = |line: &str| line.split(|c: char| !(c.is_alphanumeric() || c == '_')).any(|w| w == "compat");
    let mut found = vec![];
    for name in ["tcl", "engine", "identify", "diagnose"] {
        for (path, text) in sources(&format!("crates/{name}/src")) {
            if path.file_name().unwrap().to_str().unwrap().starts_with("opensees") {
                continue;
            }
            for (i, line) in text.lines().enumerate().filter(|(_, l)| !l.trim_start().starts_with("//")) {
                if word(line) && CONDITIONS.iter().any(|c| line.contains(c)) {
                    found.push(format!("{}:{}: {}", path.display(), i + 1, line.trim()));
                }
            }
        }
    }
    assert!(found.len() <= MAX_DECISIONS, "{} of {MAX_DECISIONS}\n{}", found.len(), found.join("\n"));
}

#[test]
fn files_are_small() {
    let mut long = vec![];
    for (path, text) in ["src", "crates", "tests"].into_iter().flat_map(sources) {
        let lines = text.lines().count();
        if lines > 560 {
            long.push(format!("{}: {lines} lines", path.display()));
        }
    }
    assert!(long.is_empty(), "split along their sense:\n{}", long.join("\n"));
}
