//! The register of slips: its page, the tests that it names, and the commands that act on it.

#![allow(clippy::unwrap_used, unreachable_pub, missing_docs)]

use hysteron_opensees::slips::{Acts, FAMILIES, Kind, Shown, Slip, page};
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn followed() -> impl Iterator<Item = &'static Slip> {
    FAMILIES.iter().flat_map(|f| f.followed)
}

/// `UPDATE=1 cargo test -p hysteron-opensees --test slips` writes the page.
#[test]
fn page_is_that_of_the_register() {
    let path = root().join("docs/reference/compat.md");
    if std::env::var_os("HYSTERON_WRITE").is_some() {
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(&path, page()).unwrap();
    }
    assert!(fs::read_to_string(path).unwrap() == page(), "run this test with HYSTERON_WRITE=1");
}

#[test]
fn named_tests_exist() {
    for s in followed() {
        match s.shown {
            Shown::Case(case) => {
                assert!(
                    root().join("validation/opensees").join(case).join("model.tcl").is_file(),
                    "{}: {case}",
                    s.name
                );
            }
            Shown::Test(file, name) => {
                let text = fs::read_to_string(root().join(file)).unwrap();
                assert!(text.contains(&format!("#[test]\nfn {name}(")), "{}: no {name} in {file}", s.name);
            }
            Shown::Nowhere => {}
        }
    }
}

fn sources(dir: &Path, out: &mut String) {
    for entry in fs::read_dir(dir).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() && path.file_name().unwrap() != "slips" {
            sources(&path, out);
        } else if path.extension().is_some_and(|e| e == "rs") {
            *out += &fs::read_to_string(path).unwrap();
        }
    }
}

/// A command asks the register, by name, and never the option itself.
#[test]
fn commands_act_by_name() {
    let mut text = String::new();
    sources(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src"), &mut text);
    let used: BTreeSet<&str> = text
        .split("slips::")
        .skip(1)
        .map(|rest| &rest[..rest.find(|c: char| !(c.is_ascii_uppercase() || c == '_')).unwrap_or(rest.len())])
        .collect();
    for s in followed() {
        assert_eq!(used.contains(s.name), s.acts == Acts::Command, "{}", s.name);
    }
    assert_eq!(text.matches("options.compat").count(), 1, "only Session::follows reads the option");
}

#[test]
fn entries_are_complete_and_names_differ() {
    let mut names = BTreeSet::new();
    for family in &FAMILIES {
        for s in family.followed {
            assert!(s.kind == Kind::Followed && s.acts != Acts::Nowhere && names.insert(s.name), "{}", s.name);
        }
        for s in family.others {
            assert!(s.kind != Kind::Followed && s.name.is_empty(), "{}", s.place);
        }
        for s in family.followed.iter().chain(family.others) {
            for part in [s.place, s.opensees, s.hysteron] {
                assert!(!part.is_empty() && !part.contains('|'), "{}", s.place);
            }
        }
    }
}
