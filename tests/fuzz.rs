//! Commands with random words, and valid scripts cut short or changed: no panic, no hang, no result that is not a number.
//!
//! The long run: `PROPTEST_CASES=20000 cargo test --test fuzz -- --ignored`.

#![allow(clippy::unwrap_used, unreachable_pub)]

#[path = "support/script.rs"]
mod script;

use proptest::prelude::*;
use script::{Ran, Script};

const MODEL: &str = "model BasicBuilder -ndm 2 -ndf 3\nnode 1 0 0\nnode 2 4 0\nfix 1 1 1 1\n\
    uniaxialMaterial Elastic 1 100.\ngeomTransf Linear 1\nelement elasticBeamColumn 1 1 2 0.1 2e8 1e-3 1 -mass 1\n\
    timeSeries Linear 1\npattern Plain 1 1 { load 2 1 0 0 }\nconstraints Transformation\nintegrator LoadControl 1\n\
    algorithm Newton\ntest NormDispIncr 1e-8 5\nanalysis Static\nanalyze 2\nputs [nodeDisp 2]\n";

const WORDS: &[&str] = &[
    "0",
    "1",
    "2",
    "3",
    "-1",
    "7",
    "99",
    "0.5",
    "1e-3",
    "-2.5",
    "1e300",
    "nan",
    "inf",
    "{}",
    "{1 2 3}",
    "x",
    "-node",
    "-dof",
    "-file",
    "f.txt",
    "disp",
    "-ele",
    "-mat",
    "-dir",
    "-orient",
    "-time",
    "-dt",
    "-values",
    "-factor",
    "Plain",
    "Linear",
    "Elastic",
    "Steel01",
    "BoucWen",
    "truss",
    "zeroLength",
    "elasticBeamColumn",
    "Newton",
    "Newmark",
    "HHT",
    "LoadControl",
    "Static",
    "Transient",
    "NormDispIncr",
    "Path",
    "Node",
    "Element",
    "-rayleigh",
    "-mass",
    "-type",
];

/// Numbers that come after an analysis that succeeded must be numbers.
fn sound(ran: &Ran) {
    for line in ran.out.lines() {
        for word in line.split_whitespace() {
            assert!(!word.parse::<f64>().is_ok_and(|x| !x.is_finite()), "{}", ran.out);
        }
    }
}

fn commands() -> Vec<String> {
    hysteron::opensees::commands().map(|c| c.name.to_owned()).collect()
}

fn random_commands() -> impl Strategy<Value = Vec<(String, Vec<&'static str>)>> {
    let command = (prop::sample::select(commands()), prop::collection::vec(prop::sample::select(WORDS), 0..9));
    prop::collection::vec(command, 1..12)
}

fn try_commands(list: &[(String, Vec<&'static str>)]) {
    let body: String = list.iter().map(|(name, words)| format!("catch {{{name} {}}}\n", words.join(" "))).collect();
    let end = "if {![catch {analyze 2 0.1} code] && $code == 0} {catch {puts [nodeDisp 2]}}\n";
    sound(&Script::default().run(&format!("{MODEL}{body}{end}")));
}

/// A valid script with some bytes taken out and one changed.
fn try_changed(from: usize, length: usize, with: char) {
    let from = from % MODEL.len();
    let to = (from + length).min(MODEL.len());
    sound(&Script::default().run(&format!("{}{with}{}", &MODEL[..from], &MODEL[to..])));
    let _ = Script::default().run(&MODEL[..from]);
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn random_words(list in random_commands()) {
        try_commands(&list);
    }

    #[test]
    fn changed_scripts(from in 0usize..1000, length in 0usize..6, with in "[ -~]") {
        try_changed(from, length, with.chars().next().unwrap());
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    #[ignore = "takes minutes"]
    fn random_words_long(list in random_commands()) {
        try_commands(&list);
    }

    #[test]
    #[ignore = "takes minutes"]
    fn changed_scripts_long(from in 0usize..1000, length in 0usize..6, with in "[ -~]") {
        try_changed(from, length, with.chars().next().unwrap());
    }
}
