//! Any bytes as a checkpoint, as a journal and as a saved state. Blocks get their checksums, so that what is inside is read too.
#![no_main]

use hysteron::analysis::SavedState;
use hysteron::bytes::Writer;
use hysteron::opensees::checkpoint;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|data: &[u8]| {
    let _ = SavedState::from_bytes(data);
    let _ = checkpoint::events(data, 0);
    for magic in checkpoint::MAGICS {
        let mut file = Writer([magic, &[0; 8]].concat());
        file.block(data);
        let _ = checkpoint::events(&file.0, 0);
    }
});
