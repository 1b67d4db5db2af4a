//! Inside a crate the layers hold: a module uses only those before it. Between crates the compiler holds them.
//! Libraries neither print nor exit nor panic; files stay small; what holds a law forwards all that a law is asked.

#![allow(clippy::unwrap_used, unreachable_pub)]

#[path = "architecture/layers.rs"]
mod layers;
#[path = "architecture/locks.rs"]
mod locks;

use layers::{LAYERS, Layers};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

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

/// First names of the paths that follow `crate::` or the like: of `name::...`, or of each path of `{name::..., ...}`.
fn first_names(path: &str) -> Vec<String> {
    let word = |s: &str| s.trim().chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect::<String>();
    let Some(list) = path.strip_prefix('{') else { return vec![word(path)] };
    let (mut names, mut depth, mut item) = (vec![], 0, String::new());
    for c in list.chars() {
        match c {
            '{' => depth += 1,
            '}' if depth == 0 => break,
            '}' => depth -= 1,
            ',' if depth == 0 => names.push(word(&std::mem::take(&mut item))),
            c if depth == 0 => item.push(c),
            _ => {}
        }
    }
    names.push(word(&item));
    names
}

/// Modules that the text of a file uses, its unit tests left out: by `crate::` and by as many `super::` as lead from the file
/// to the root. What the root re-exports is not counted.
fn used(text: &str, place: &Path) -> Vec<String> {
    let text = text.split("#[cfg(test)]\nmod tests").next().unwrap_or("");
    let code: String = text.lines().filter(|l| !l.trim_start().starts_with("//")).collect::<Vec<_>>().join("\n");
    let is_folder = place.file_name().is_some_and(|name| name == "mod.rs");
    let to_root = "super::".repeat(place.iter().count() - usize::from(is_folder));
    let absolute = code.split("crate::").skip(1);
    let relative = code.match_indices(&to_root).filter(|(at, _)| {
        let before = code[..*at].chars().next_back();
        !before.is_some_and(|c| c == ':' || c == '_' || c.is_alphanumeric())
    });
    let relative = relative.map(|(at, up)| &code[at + up.len()..]).filter(|rest| !rest.starts_with("super::"));
    absolute.chain(relative).flat_map(first_names).collect()
}

#[test]
fn modules_use_only_those_before_them() {
    let mut wrong = vec![];
    for Layers { krate, modules, upward } in LAYERS {
        let order: BTreeMap<&str, usize> = modules.iter().enumerate().map(|(i, l)| (*l, i)).collect();
        let dir = format!("crates/{krate}/src");
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join(&dir);
        let mut needed = BTreeSet::new();
        for (path, text) in sources(&dir) {
            let Some(own) = module(&path, &root) else { continue };
            let Some(&place) = order.get(own.as_str()) else {
                wrong.push(format!("{}: module {own} is in no layer", path.display()));
                continue;
            };
            let file = path.strip_prefix(&root).unwrap();
            for other in used(&text, file).iter().filter(|o| order.get(o.as_str()).is_some_and(|there| *there > place))
            {
                let arrow = (file.to_str().unwrap(), other.as_str());
                match upward.iter().find(|known| **known == arrow) {
                    Some(known) => _ = needed.insert(known),
                    None => wrong.push(format!("{}: {own} uses {other}", path.display())),
                }
            }
        }
        let idle = upward.iter().filter(|known| !needed.contains(known));
        wrong
            .extend(idle.map(|(file, other)| format!("{krate}/{file} no longer uses {other}: strike it off the list")));
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn arrows_are_found_in_every_way_of_writing() {
    let text = "use crate::{a::{b, c}, d};\nuse super::super::e::{f};\nuse super::g;\nuse super::super::super::h;\n// crate::i\n";
    assert_eq!(used(text, Path::new("x/y.rs")), ["a", "d", "e"]);
    assert_eq!(used("use super::{a, b::c};", Path::new("x.rs")), ["a", "b"]);
    assert_eq!(used("use super::{a, b::c};", Path::new("x/mod.rs")), ["a", "b"]);
}

#[test]
fn libraries_neither_print_nor_exit_nor_panic() {
    let banned = ["println!", "eprintln!", "print!(", "process::exit", "panic!(", "todo!(", "unimplemented!(", "dbg!("];
    let mut wrong = vec![];
    for name in ["files", "tcl", "recordings", "engine", "opensees", "identify", "diagnose", "design", "view", "lsp"] {
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
    for (path, text) in sources("crates").into_iter().filter(|(_, text)| text.contains("inner: Inner,\n")) {
        for (at, _) in text.match_indices("\nimpl Element for ") {
            wrappers += 1;
            if text[..at].lines().last() != Some(HELD) {
                wrong.push(path.display().to_string());
            }
        }
    }
    assert!(wrappers >= 3, "only {wrappers} found");
    assert!(wrong.is_empty(), "{HELD} is missing in\n{}", wrong.join("\n"));
}

/// Traits of which a wrapper must decide on every method.
const WRAPPED_TRAITS: [&str; 5] = ["WatchesColumns", "Uniaxial", "Multiaxial", "Section", "PlateSection"];

/// Names of types by which a struct holds a law or a section.
const HOLDERS: [&str; 6] =
    ["Slot", "SectionSlot", "Material", "SharedMultiaxial", "SharedSection", "SharedPlateSection"];

fn words(text: &str) -> impl Iterator<Item = &str> {
    text.split(|c: char| !(c.is_alphanumeric() || c == '_')).filter(|w| !w.is_empty())
}

/// A struct or an enum: its file, its name, the words of its body, and whether other files see it.
struct Shape<'a> {
    file: usize,
    name: &'a str,
    body: BTreeSet<&'a str>,
    public: bool,
}

fn shapes(files: &[(PathBuf, String)]) -> Vec<Shape<'_>> {
    let mut all = vec![];
    for (file, (_, text)) in files.iter().enumerate() {
        for (at, _) in ["struct ", "enum "].iter().flat_map(|kind| text.match_indices(kind)) {
            let line = text[..at].rfind('\n').map_or(0, |i| i + 1);
            let before = text[line..at].trim();
            if !(before.is_empty() || before == "pub" || before.starts_with("pub(")) {
                continue;
            }
            let rest = &text[at..];
            let end = rest.find("\n}").into_iter().chain(rest.find(";\n")).min().unwrap_or(rest.len());
            let body = rest[..end].lines().filter(|l| !l.trim_start().starts_with("//"));
            let mut body: Vec<&str> = body.flat_map(words).skip(1).collect();
            if !body.is_empty() {
                let name = body.remove(0);
                all.push(Shape { file, name, body: body.into_iter().collect(), public: !before.is_empty() });
            }
        }
    }
    all
}

/// The structs that hold a law or a section, directly or in another struct.
fn holding<'a>(shapes: &'a [Shape<'a>]) -> BTreeSet<(usize, &'a str)> {
    let mut holding: BTreeSet<(usize, &str)> = BTreeSet::new();
    loop {
        let before = holding.len();
        for shape in shapes {
            let in_file = |word: &str| shapes.iter().any(|s| s.file == shape.file && s.name == word);
            let holds = |word: &str| {
                if in_file(word) {
                    return holding.contains(&(shape.file, word));
                }
                let seen = |s: &&Shape<'_>| s.public && s.name == word;
                HOLDERS.contains(&word) || shapes.iter().filter(seen).any(|s| holding.contains(&(s.file, s.name)))
            };
            if shape.body.iter().any(|word| *word != shape.name && holds(word)) {
                holding.insert((shape.file, shape.name));
            }
        }
        if holding.len() == before {
            return holding;
        }
    }
}

/// What holds a law or a section forwards every method that a law or a section has, and the columns that it watches.
#[test]
fn what_holds_a_law_forwards_every_method() {
    const HELD: &str = "#[deny(clippy::missing_trait_methods)]";
    let mut files = sources("crates/engine/src");
    files.extend(sources("tests/support"));
    let shapes = shapes(&files);
    let holding = holding(&shapes);
    let (mut found, mut wrong) = (0, vec![]);
    for (file, (path, text)) in files.iter().enumerate() {
        for (at, _) in text.match_indices("\nimpl") {
            let line = text[at + 1..].lines().next().unwrap_or_default();
            let Some((of, on)) = line.split_once(" for ") else { continue };
            let of: Vec<&str> = words(of).collect();
            let Some(name) = words(on).next() else { continue };
            let is_law = of.iter().any(|w| WRAPPED_TRAITS[1..].contains(w));
            if is_law && holding.contains(&(file, name)) {
                found += 1;
                if text[..at].lines().last() != Some(HELD) {
                    wrong.push(format!("{}: {HELD} is missing at {line}", path.display()));
                }
            }
        }
        for (at, _) in text.match_indices("watches_columns!(") {
            let call = text[at..].split(");").next().unwrap_or_default();
            let Some((of, "nothing")) = call.rsplit_once(" => ") else { continue };
            let of = of.rsplit_once("] ").map_or(of, |(_, name)| name).trim_start_matches("watches_columns!(");
            let name = words(of).next().unwrap_or_default();
            if holding.contains(&(file, name)) {
                wrong.push(format!("{}: {name} holds a law that may watch a column", path.display()));
            }
        }
    }
    assert!(found >= 15, "only {found} found");
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn traits_of_laws_have_no_defaults() {
    let files = sources("crates/engine/src");
    for name in WRAPPED_TRAITS {
        let head = format!("pub trait {name}");
        let traits = files.iter().flat_map(|(_, text)| text.split(&head).skip(1));
        let bodies: Vec<&str> = traits.filter(|t| t.starts_with([':', '<', ' '])).collect();
        assert_eq!(bodies.len(), 1, "{name}");
        let body = bodies[0].split("\n}").next().unwrap();
        assert!(!body.contains("    }\n"), "{name} has a method that a wrapper may forget");
    }
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
