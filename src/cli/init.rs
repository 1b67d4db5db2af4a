//! `hysteron init`.

use super::calibrate::{FAILURE, INPUT_ERROR, print_diagnostic};
use super::files::write_atomically;
use super::limits::LimitArgs;
use super::signals::{on_interrupt, stopped_status};
use clap::Args;
use hysteron::design::isolate::draft;
use hysteron::diagnostic::SourceMap;
use hysteron::study::draft_study;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// Name of the study beside the script.
const STUDY: &str = "study.toml";

#[derive(Args, Debug)]
pub(super) struct InitArgs {
    #[command(flatten)]
    limits: LimitArgs,
    /// The script
    model: PathBuf,
    /// Recordings, each of one run
    #[arg(required_unless_present = "isolation")]
    recordings: Vec<PathBuf>,
    /// Write an isolation study of the script instead: its bearings by type, floors and gravity
    #[arg(long, conflicts_with = "recordings")]
    isolation: bool,
    /// File of the study; study.toml beside the script if it is not given
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
}

/// Write a first study of a script and recordings; the exit status.
pub(super) fn init(args: &InitArgs) -> i32 {
    let beside = |p: &Path| p.parent().filter(|f| !f.as_os_str().is_empty()).map_or(PathBuf::from("."), Path::to_owned);
    let out = args.out.clone().unwrap_or_else(|| args.model.with_file_name(STUDY));
    if out.exists() {
        eprintln!("error: {} exists already; give another file with --out", out.display());
        return INPUT_ERROR;
    }
    let stop = Arc::new(AtomicBool::new(false));
    on_interrupt(&stop);
    args.limits.enforce(&stop);
    if args.isolation {
        return isolation(args, &out, &beside(&out), &stop);
    }
    let mut sources = SourceMap::default();
    let text = match draft_study(&args.model, &args.recordings, &beside(&out), &stop, &mut sources) {
        Ok(text) => text,
        Err(d) => {
            print_diagnostic(&d, &sources);
            return stopped_status(&stop).unwrap_or(INPUT_ERROR);
        }
    };
    if let Err(message) = write_atomically(&out, &text) {
        eprintln!("error: {message}");
        return FAILURE;
    }
    eprintln!("written to {0}\nread its comments, then: hysteron check {0}", out.display());
    0
}

/// Write an isolation study of the script; the exit status.
fn isolation(args: &InitArgs, out: &Path, folder: &Path, stop: &Arc<AtomicBool>) -> i32 {
    let relative = || {
        let (model, folder) = (args.model.canonicalize().ok()?, folder.canonicalize().ok()?);
        let shown = model.strip_prefix(&folder).map(Path::to_owned).unwrap_or(model);
        Some(shown.to_string_lossy().replace('\\', "/"))
    };
    let name = relative().unwrap_or_else(|| args.model.to_string_lossy().into_owned());
    let text = match draft(&args.model, &name, stop) {
        Ok(text) => text,
        Err(message) => {
            eprintln!("error: {message}");
            return stopped_status(stop).unwrap_or(INPUT_ERROR);
        }
    };
    if let Err(message) = write_atomically(out, &text) {
        eprintln!("error: {message}");
        return FAILURE;
    }
    eprintln!("written to {0}\nfill in its lines with TODO, then: hysteron check {0}", out.display());
    0
}
