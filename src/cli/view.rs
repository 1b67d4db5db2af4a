//! The command `view`, and the option `--view` of `run`: a page for a browser, and files for ParaView.

use super::args::{CheckpointArgs, EvidenceArgs, FolderArgs, ScriptArgs, StepArgs};
use super::calibrate::INPUT_ERROR;
use super::files::write_atomically;
use super::limits::LimitArgs;
use super::run::{RunArgs, run_prepared};
use clap::Args;
use hysteron::run::Run;
use hysteron::view::vtk::{Both, Writer};
use hysteron::view::{Observer, Units, page};
use hysteron_files::Scratch;
use std::path::{Path, PathBuf};

#[derive(Args, Debug)]
pub(super) struct ViewArgs {
    #[command(flatten)]
    script: ScriptArgs,
    #[command(flatten)]
    steps: StepArgs,
    #[command(flatten)]
    limits: LimitArgs,
    /// The page; by default the name of the script with .html, in the current folder
    #[arg(long, value_name = "FILE.html")]
    out: Option<PathBuf>,
    /// Show this many modes, where the script does not find as many
    #[arg(long, value_name = "N", default_value_t = 0, value_parser = clap::value_parser!(u16).range(0..=50))]
    modes: u16,
    /// Units of force and length for the labels, for instance kN m
    #[arg(long, num_args = 2, value_names = ["FORCE", "LENGTH"])]
    units: Vec<String>,
    /// Write files for ParaView into this folder, in place of the page unless --out is given
    #[arg(long, value_name = "DIR")]
    vtk: Option<PathBuf>,
    /// Write every N-th step for ParaView
    #[arg(long, value_name = "N", default_value_t = 1, requires = "vtk", value_parser = clap::value_parser!(u32).range(1..))]
    every: u32,
    /// The script
    model: String,
    /// Words that the script finds in $argv; behind "--" if they begin with a dash and are no numbers
    #[arg(allow_negative_numbers = true)]
    args: Vec<String>,
}

/// Run a script and write the page. What the script itself writes goes to a folder that is removed, since it may read it
/// again; the exit status is that of a run.
pub(super) fn view(args: &ViewArgs) -> i32 {
    let scratch = match Scratch::new("view") {
        Ok(scratch) => scratch,
        Err(e) => {
            eprintln!("error: cannot make a temporary folder: {e}");
            return INPUT_ERROR;
        }
    };
    let folders = FolderArgs { out: Some(scratch.path().to_owned()), ..FolderArgs::default() };
    let (script, steps, limits, evidence) = (&args.script, &args.steps, &args.limits, &EvidenceArgs::default());
    let run_args = RunArgs {
        script,
        steps,
        limits,
        folders: &folders,
        evidence,
        checkpoints: &CheckpointArgs::default(),
        quiet: false,
    };
    let units = match args.units.as_slice() {
        [force, length] => Units { force: force.clone(), length: length.clone() },
        _ => Units::default(),
    };
    let by_name = || Path::new(&args.model).with_extension("html").file_name().map(PathBuf::from);
    let page = args.out.clone().or_else(|| if args.vtk.is_none() { by_name() } else { None });
    let (vtk, every) = (args.vtk.as_deref(), args.every as usize);
    let wanted = ViewRequest { page: page.as_deref(), vtk, every, modes: args.modes.into(), units };
    wanted.run(&run_args, &args.model, &args.args)
}

/// Run a script for its results, and write the page as well; the exit status.
pub(super) fn run(args: &RunArgs<'_>, page: &Path, model: &str, words: &[String]) -> i32 {
    ViewRequest { page: Some(page), ..ViewRequest::default() }.run(args, model, words)
}

/// Files to be made of a run.
#[derive(Default)]
struct ViewRequest<'a> {
    page: Option<&'a Path>,
    vtk: Option<&'a Path>,
    every: usize,
    modes: usize,
    units: Units,
}

impl ViewRequest<'_> {
    fn run(&self, args: &RunArgs<'_>, model: &str, words: &[String]) -> i32 {
        let vtk = match self.vtk.map(|folder| Writer::new(folder, self.every)).transpose() {
            Ok(vtk) => vtk,
            Err(e) => {
                eprintln!("error: cannot make {}: {e}", self.vtk.unwrap_or(Path::new("")).display());
                return INPUT_ERROR;
            }
        };
        let observer = Observer::new(self.modes);
        let both = Both(self.page.map(|_| observer.clone()), vtk.clone());
        let observe = |run: &mut Run| run.interp.host.observe_motion(Box::new(both));
        let (status, mut run) = match run_prepared(args, model, words, observe) {
            Ok(done) => done,
            Err(status) => return status,
        };
        // Of a script that was rejected there is nothing to see.
        if status == INPUT_ERROR {
            return status;
        }
        let done = self.write_page(&observer, &mut run, model).and_then(|()| self.write_vtk(vtk.as_ref(), &run));
        match done {
            Ok(()) => status,
            Err(e) => {
                eprintln!("error: {e}");
                INPUT_ERROR
            }
        }
    }

    fn write_page(&self, observer: &Observer, run: &mut Run, model: &str) -> Result<(), String> {
        let Some(path) = self.page else { return Ok(()) };
        let collector = observer.take();
        let models = collector.models.max(1);
        let motion = collector.finish(&mut run.interp.host.engine);
        let motion = motion.ok_or_else(|| format!("{model} has no model when it ends: there is nothing to show"))?;
        let title = Path::new(model).file_name().map_or_else(|| model.into(), |n| n.to_string_lossy());
        write_atomically(path, &page(&motion, &title, &self.units, models))?;
        eprintln!("page: {}", path.display());
        Ok(())
    }

    fn write_vtk(&self, vtk: Option<&Writer>, run: &Run) -> Result<(), String> {
        let (Some(writer), Some(folder)) = (vtk, self.vtk) else { return Ok(()) };
        let files = writer.finish(&run.interp.host.engine);
        let files = files.map_err(|e| format!("cannot write into {}: {e}", folder.display()))?;
        eprintln!("for ParaView: {} of {files} steps", folder.join("motion.pvd").display());
        Ok(())
    }
}
