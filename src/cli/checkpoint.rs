//! `hysteron run --checkpoint SECONDS` and `--resume`.

use super::review::Observed;
use super::run::RunArgs;
use hysteron::opensees::checkpoint::{Journal, Keeping, Paths, keep};
use hysteron::run::Run;
use sha2::{Digest as _, Sha256};
use std::path::Path;

/// First bytes of a SHA-256 as a number.
fn digest(text: &str) -> u64 {
    Sha256::digest(text.as_bytes()).iter().take(8).fold(0, |n, byte| n << 8 | u64::from(*byte))
}

/// Keep checkpoints of a run where the arguments ask for them; their files.
pub(super) fn begin(
    args: &RunArgs<'_>,
    model: &str,
    words: &[String],
    observed: &Observed,
    run: &mut Run,
) -> Result<Option<Paths>, String> {
    let Some(interval) = args.checkpoints.checkpoint else { return Ok(None) };
    let in_folder = |extension: &str| {
        let name = Path::new(model).with_extension(extension);
        args.folders.out.as_deref().unwrap_or(Path::new("")).join(name.file_name().unwrap_or_default())
    };
    let paths = Paths { journal: in_folder("journal"), checkpoint: in_folder("checkpoint") };
    let settings = (env!("CARGO_PKG_VERSION"), model, words, args.script.strict, args.folders.sandbox);
    let run_digest = digest(&format!("{settings:?}"));
    let keeping = || {
        let inputs = observed.inputs();
        let inputs = Box::new(move || digest(&format!("{:?}", inputs.rows())));
        Keeping { paths: paths.clone(), run: run_digest, interval, inputs }
    };
    let earlier = if args.checkpoints.resume { Journal::resume(keeping())? } else { None };
    let journal = match earlier {
        Some(journal) => journal,
        None => {
            if args.checkpoints.resume {
                eprintln!("note: there is no {}: the run begins at its beginning", paths.checkpoint.display());
            }
            Journal::create(keeping())?
        }
    };
    keep(&mut run.interp, journal);
    Ok(Some(paths))
}
