//! `hysteron run --checkpoint SECONDS` and `--resume`.

use super::review::Observed;
use super::run::RunArgs;
use hysteron::opensees::checkpoint::Journal;
use hysteron::run::Run;
use sha2::{Digest as _, Sha256};
use std::path::{Path, PathBuf};

/// First bytes of a SHA-256 as a number.
fn digest(text: &str) -> u64 {
    Sha256::digest(text.as_bytes()).iter().take(8).fold(0, |n, byte| n << 8 | u64::from(*byte))
}

/// Keep checkpoints of a run where the arguments ask for them; the path of their file.
pub(super) fn begin(
    args: &RunArgs<'_>,
    model: &str,
    words: &[String],
    observed: &Observed,
    run: &mut Run,
) -> Result<Option<PathBuf>, String> {
    let Some(interval) = args.checkpoints.checkpoint else { return Ok(None) };
    let name = Path::new(model).with_extension("checkpoint");
    let name = name.file_name().unwrap_or_default();
    let path = args.folders.out.as_deref().unwrap_or(Path::new("")).join(name);
    let inputs = observed.inputs();
    let read = Box::new(move || digest(&format!("{:?}", inputs.rows())));
    let settings = (env!("CARGO_PKG_VERSION"), model, words, args.script.strict, args.folders.sandbox);
    let id = digest(&format!("{settings:?}"));
    let journal = if args.checkpoints.resume {
        Journal::resume(&path, id, interval, read)?
    } else {
        Journal::create(&path, id, interval, read)?
    };
    run.interp.host.keep_checkpoints(journal);
    Ok(Some(path))
}
