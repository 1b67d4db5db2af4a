//! Commands made from their usage, and valid scripts cut short or changed: no panic, no hang, no motion that is not a number.
//!
//! The long run: `PROPTEST_CASES=20000 cargo test --release --test fuzz -- --ignored`. `fuzz/` goes on where chance ends.

#![allow(clippy::unwrap_used, unreachable_pub)]

#[path = "support/fuzzed.rs"]
mod fuzzed;

use fuzzed::Bytes;
use hysteron::analysis::Options;
use hysteron::opensees::Mode;
use proptest::prelude::*;

const MODEL: &str = "model BasicBuilder -ndm 2 -ndf 3\nnode 1 0 0\nnode 2 4 0\nfix 1 1 1 1\n\
    uniaxialMaterial Elastic 1 100.\ngeomTransf Linear 1\nelement elasticBeamColumn 1 1 2 0.1 2e8 1e-3 1 -mass 1\n\
    timeSeries Linear 1\npattern Plain 1 1 { load 2 1 0 0 }\nconstraints Transformation\nintegrator LoadControl 1\n\
    algorithm Newton\ntest NormDispIncr 1e-8 5\nanalysis Static\nanalyze 2\nputs [nodeDisp 2]\n";

/// A valid script with some bytes taken out and one changed.
fn try_changed(from: usize, length: usize, with: char) {
    let from = from % MODEL.len();
    let to = (from + length).min(MODEL.len());
    let run = |text: &str| fuzzed::run(text, &[], Mode::Run, Options::default(), false);
    run(&format!("{}{with}{}", &MODEL[..from], &MODEL[to..]));
    run(&MODEL[..from]);
}

fn try_commands(bytes: &[u8]) {
    fuzzed::run_commands(&fuzzed::usages(), &mut Bytes(bytes));
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn commands_after_their_usage(bytes in prop::collection::vec(any::<u8>(), 40..400)) {
        try_commands(&bytes);
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
    fn commands_after_their_usage_long(bytes in prop::collection::vec(any::<u8>(), 40..400)) {
        try_commands(&bytes);
    }

    #[test]
    #[ignore = "takes minutes"]
    fn changed_scripts_long(from in 0usize..1000, length in 0usize..6, with in "[ -~]") {
        try_changed(from, length, with.chars().next().unwrap());
    }
}
