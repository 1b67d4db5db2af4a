//! `hysteron init`.

use super::calibrate::{FAILURE, INPUT_ERROR, print_diagnostic};
use super::examples::Job;
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
    #[arg(required_unless_present = "new")]
    model: Option<PathBuf>,
    /// Recordings, each of one run
    #[arg(required_unless_present_any = ["isolation", "new"])]
    recordings: Vec<PathBuf>,
    /// Write a complete example of a job into the folder --out, else the current one
    #[arg(long, value_enum, value_name = "JOB", conflicts_with_all = ["model", "recordings", "isolation"])]
    new: Option<Job>,
    /// Write an isolation study of the script instead: its bearings by type, floors and gravity
    #[arg(long, conflicts_with = "recordings")]
    isolation: bool,
    /// File of the study; study.toml beside the script if it is not given. With --new a folder
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
}

/// Write a first study of a script and recordings; the exit status.
pub(super) fn init(args: &InitArgs) -> i32 {
    if let Some(job) = args.new {
        return example(job, args.out.as_deref().unwrap_or(Path::new(".")));
    }
    // The command line asks for the script.
    let Some(model) = &args.model else { return INPUT_ERROR };
    let beside = |p: &Path| p.parent().filter(|f| !f.as_os_str().is_empty()).map_or(PathBuf::from("."), Path::to_owned);
    let out = args.out.clone().unwrap_or_else(|| model.with_file_name(STUDY));
    if out.exists() {
        eprintln!("error: {} exists already; give another file with --out", out.display());
        return INPUT_ERROR;
    }
    let stop = Arc::new(AtomicBool::new(false));
    on_interrupt(&stop);
    args.limits.enforce(&stop);
    if args.isolation {
        return isolation(model, &out, &beside(&out), &stop);
    }
    let mut sources = SourceMap::default();
    let text = match draft_study(model, &args.recordings, &beside(&out), &stop, &mut sources) {
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

/// Write an example of a job; the exit status.
fn example(job: Job, folder: &Path) -> i32 {
    match job.write(folder) {
        Ok(files) => {
            files.iter().for_each(|path| eprintln!("written to {}", path.display()));
            if folder != Path::new(".") {
                eprintln!("go on in the folder {}:", folder.display());
            }
            job.next().iter().for_each(|command| eprintln!("  {command}"));
            0
        }
        Err(message) => {
            eprintln!("error: {message}");
            INPUT_ERROR
        }
    }
}

/// Write an isolation study of the script; the exit status.
fn isolation(model: &Path, out: &Path, folder: &Path, stop: &Arc<AtomicBool>) -> i32 {
    let name = hysteron_files::path_from(folder, model).unwrap_or_else(|_| model.to_string_lossy().into_owned());
    let text = match draft(model, &name, stop) {
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
