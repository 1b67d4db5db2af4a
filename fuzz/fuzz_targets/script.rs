//! Any text as a script.
#![no_main]

#[path = "../../tests/support/fuzzed.rs"]
mod fuzzed;

use hysteron::analysis::Options;
use hysteron::opensees::Mode;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|data: &[u8]| {
    let Ok(text) = std::str::from_utf8(data) else { return };
    fuzzed::run(text, &[], Mode::Run, Options::default(), false);
});
