//! The pages of `docs/reference/commands` are what the commands say of themselves. After a change of a command,
//! `HYSTERON_WRITE=1 cargo test --release --test reference` writes them anew.

#![allow(clippy::unwrap_used, clippy::print_stdout, unreachable_pub)]

#[path = "reference/causes.rs"]
mod causes;
#[path = "reference/keys.rs"]
mod keys;
#[path = "reference/page.rs"]
mod page;
#[path = "reference/pages.rs"]
mod pages;
#[path = "reference/response.rs"]
mod response;
#[path = "support/script.rs"]
mod script;
#[path = "reference/usage.rs"]
mod usage;

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::thread;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/reference/commands")
}

#[test]
fn the_pages_are_those_of_the_commands() {
    let write = std::env::var_os("HYSTERON_WRITE").is_some();
    let (mut stale, mut blank) = (vec![], vec![]);
    let texts: Vec<(String, page::Blanks)> = thread::scope(|scope| {
        let all: Vec<_> = page::PAGES.iter().map(|page| scope.spawn(|| page::text(page))).collect();
        all.into_iter().map(|t| t.join().unwrap()).collect()
    });
    for (page, (text, blanks)) in page::PAGES.iter().zip(texts) {
        let path = folder().join(format!("{}.md", page.name));
        blank.extend(blanks);
        if write {
            fs::create_dir_all(folder()).unwrap();
            fs::write(&path, &text).unwrap();
        } else if fs::read_to_string(&path).unwrap_or_default() != text {
            stale.push(page.name);
        }
    }
    assert!(blank.is_empty(), "rows of commands and kinds lack\n{}", blank.join("\n"));
    assert!(stale.is_empty(), "HYSTERON_WRITE=1 cargo test --release --test reference writes {stale:?} anew");
}

#[test]
fn the_page_of_study_keys_is_that_of_the_declarations() {
    let (text, blank) = keys::text();
    assert!(blank.is_empty(), "keys without a meaning: {blank:?}");
    if std::env::var_os("HYSTERON_WRITE").is_some() {
        fs::write(keys::path(), &text).unwrap();
    }
    let page = fs::read_to_string(keys::path()).unwrap_or_default();
    assert!(page == text, "HYSTERON_WRITE=1 cargo test --test reference writes isolation-keys.md anew");
}

#[test]
fn the_tables_of_causes_are_those_of_the_hypotheses() {
    let page = fs::read_to_string(causes::path()).unwrap();
    let text = causes::renewed(&page);
    if std::env::var_os("HYSTERON_WRITE").is_some() {
        fs::write(causes::path(), &text).unwrap();
    } else {
        assert!(
            page == text,
            "HYSTERON_WRITE=1 cargo test --release --test reference writes the tables of causes.md anew"
        );
    }
}

#[test]
fn the_page_of_codes_is_that_of_the_register() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/reference/codes.md");
    let text = hysteron::checks::page();
    if std::env::var_os("HYSTERON_WRITE").is_some() {
        fs::write(&path, &text).unwrap();
    }
    let page = fs::read_to_string(path).unwrap_or_default();
    assert!(page == text, "HYSTERON_WRITE=1 cargo test --release --test reference writes codes.md anew");
}

#[test]
fn codes_are_unique_and_their_texts_are_sentences() {
    let mut codes = BTreeSet::new();
    for c in hysteron::checks::all() {
        assert!(codes.insert(c.code), "{} stands twice", c.code);
        assert!(c.code.bytes().all(|b| b.is_ascii_lowercase() || b == b'-'), "{}", c.code);
        for text in [c.finds, c.advice] {
            assert!(text.ends_with('.') && text.starts_with(|x: char| x.is_uppercase()), "{}: {text}", c.code);
            let longest = text.split(['.', ';']).map(|s| s.split_whitespace().count()).max().unwrap();
            assert!(longest <= 25, "{}: a sentence of {longest} words", c.code);
        }
    }
}

#[test]
fn every_command_has_one_page() {
    let names = |all: &mut dyn Iterator<Item = &'static hysteron::opensees::Command>| {
        let mut names: Vec<&str> = all.map(|c| c.name).collect();
        names.sort_unstable();
        names
    };
    let on_pages = names(&mut page::PAGES.iter().flat_map(|p| hysteron::opensees::commands_on(p.name)));
    assert_eq!(on_pages, names(&mut hysteron::opensees::commands()));
}

#[test]
fn arguments_that_are_told_stand_in_the_usage() {
    let gone = page::undeclared();
    assert!(gone.is_empty(), "no usage has\n{}", gone.join("\n"));
}

/// Output of the program, of both streams.
fn printed(args: &[&str], dir: &Path) -> String {
    let done = Command::new(env!("CARGO_BIN_EXE_hysteron")).args(args).current_dir(dir).output().unwrap();
    String::from_utf8_lossy(&[done.stdout, done.stderr].concat()).into_owned()
}

fn page_of(name: &str) -> String {
    fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/reference").join(name)).unwrap()
}

/// Options `--name` of a text.
fn options(text: &str) -> BTreeSet<String> {
    let word = |c: char| c.is_ascii_lowercase() || c == '-';
    let after = text.split("--").skip(1).map(|rest| rest.chars().take_while(|c| word(*c)).collect::<String>());
    after.filter(|o| o.len() > 1).collect()
}

#[test]
fn every_option_of_the_command_line_is_told() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let list = printed(&["--help"], root);
    let list = list.split("Commands:").nth(1).unwrap().split("Options:").next().unwrap();
    let names: Vec<&str> = list.lines().filter_map(|l| l.split_whitespace().next()).filter(|n| *n != "help").collect();
    assert!(names.len() >= 7, "{names:?}");
    // Those of several commands have a section of their own.
    let index = page_of("command-line/index.md");
    let limits = index.split("\n## Limits\n").nth(1).unwrap();
    for name in names {
        let page = page_of(&format!("command-line/{name}.md"));
        let told = options(page.split("\n## Options\n").nth(1).and_then(|rest| rest.split("\n## ").next()).unwrap());
        let mut known = options(&printed(&[name, "--help"], root));
        known.remove("help");
        let mut told_here = told.clone();
        if limits.contains(&format!("`{name}`")) {
            told_here.extend(options(limits));
        }
        let missing: Vec<_> = known.difference(&told_here).collect();
        assert!(missing.is_empty(), "{name}: {missing:?} are not told");
        let gone: Vec<_> = told.difference(&known).filter(|o| *o != "help").collect();
        assert!(gone.is_empty(), "{name}: {gone:?} are told and not known");
    }
}

#[test]
fn every_key_of_a_study_is_told() {
    let page = page_of("study.md");
    let dir = std::env::temp_dir().join(format!("hysteron-keys-{}", std::process::id()));
    fs::create_dir_all(&dir).unwrap();
    let tables = ["", "[[parameter]]", "[[run]]", "[[run]]\n[[run.observe]]", "[calibration]", "[rig]"];
    let mut keys = BTreeSet::new();
    for table in tables {
        fs::write(dir.join("study.toml"), format!("{table}\nwrong = 1\n")).unwrap();
        let said = printed(&["check", "study.toml"], &dir);
        let known = said.split("expected one of ").nth(1).unwrap_or_else(|| panic!("{table}: {said}"));
        keys.extend(known.lines().next().unwrap_or_default().split(", ").map(|k| k.trim().to_owned()));
    }
    fs::remove_dir_all(dir).unwrap();
    assert!(keys.len() >= 30, "{keys:?}");
    let told = |k: &&String| {
        let shown = [format!("`{k}`"), format!("`[[{k}]]`"), format!("`[{k}]`"), format!("`[[run.{k}]]`")];
        shown.iter().any(|s| page.contains(s))
    };
    let missing: Vec<&String> = keys.iter().filter(|k| !told(k)).collect();
    assert!(missing.is_empty(), "{missing:?} are not told");
}
