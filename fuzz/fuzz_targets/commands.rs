//! Commands made from their usage, in a model that is analysed.
#![no_main]

#[path = "../../tests/support/fuzzed.rs"]
mod fuzzed;

use fuzzed::Bytes;
use libfuzzer_sys::fuzz_target;
use std::sync::OnceLock;

static USAGES: OnceLock<Vec<&str>> = OnceLock::new();

fuzz_target!(|data: &[u8]| fuzzed::run_commands(USAGES.get_or_init(fuzzed::usages), &mut Bytes(data)));
