//! Each command of the program has a page, and all pages have one form.

use super::root;
use std::collections::BTreeSet;
use std::fs;
use std::process::Command;

/// Headings of the page of a command, in their order.
const FORM: [&str; 6] = ["When", "Example", "Options", "Files", "Errors", "Sources"];
/// The page of two small commands, and the list of all.
const OTHER_PAGES: [&str; 2] = ["completions", "index"];

/// Commands that `hysteron --help` lists.
fn listed() -> BTreeSet<String> {
    let done = Command::new(env!("CARGO_BIN_EXE_hysteron")).arg("--help").output().unwrap();
    let text = String::from_utf8(done.stdout).unwrap();
    let list = text.split("Commands:").nth(1).unwrap().split("Options:").next().unwrap();
    let names = list.lines().filter_map(|l| l.split_whitespace().next()).filter(|n| *n != "help");
    names.map(str::to_owned).collect()
}

#[test]
fn every_command_shows_examples_in_its_help() {
    let help =
        |name: &String| Command::new(env!("CARGO_BIN_EXE_hysteron")).args([name, "--help"]).output().unwrap().stdout;
    let lacks = |name: &String| !String::from_utf8_lossy(&help(name)).contains(&format!("    hysteron {name}"));
    let lacking: Vec<String> = listed().into_iter().filter(lacks).collect();
    assert!(lacking.is_empty(), "without an example: {lacking:?}");
}

#[test]
fn every_command_has_a_page_of_the_same_form() {
    let folder = root().join("docs/reference/command-line");
    let mut pages: BTreeSet<String> = fs::read_dir(&folder)
        .unwrap()
        .map(|e| e.unwrap().path().file_stem().unwrap().to_string_lossy().into_owned())
        .collect();
    assert!(OTHER_PAGES.iter().all(|p| pages.remove(*p)));
    assert_eq!(pages, listed(), "pages, and commands of the program");
    let mut wrong = vec![];
    for name in &pages {
        let text = fs::read_to_string(folder.join(format!("{name}.md"))).unwrap();
        let headings: Vec<&str> = text.lines().filter_map(|l| l.strip_prefix("## ")).collect();
        let is_empty = text.split("\n## ").skip(1).any(|section| section.lines().skip(1).all(|l| l.trim().is_empty()));
        if !text.starts_with(&format!("# hysteron {name}\n")) || headings != FORM || is_empty {
            wrong.push(format!("{name}: {headings:?}"));
        }
    }
    assert!(wrong.is_empty(), "expected {FORM:?}:\n{}", wrong.join("\n"));
}
