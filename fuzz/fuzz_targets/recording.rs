//! Any bytes as a recording.
#![no_main]

use hysteron::diagnostic::SourceMap;
use hysteron::study::Recording;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|data: &[u8]| {
    let _ = Recording::read("recording.csv", data, &mut SourceMap::default());
});
