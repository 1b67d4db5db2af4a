//! Arguments of the command line. Doc comments of the fields are the help texts.

use super::batch::BatchArgs;
use super::bearing::BearingArgs;
use super::fragility::{FragilityArgs, IdaArgs};
use super::init::InitArgs;
use super::isolate::IsolateArgs;
use super::limits::LimitArgs;
use super::loops::LoopsArgs;
use super::lsp::LspArgs;
use super::motions::MotionsArgs;
use super::prototype::PrototypeArgs;
use super::recording::RecordingArgs;
use super::response_spectrum::ResponseSpectrumArgs;
use super::view::ViewArgs;
use clap::{Args, Parser, Subcommand, ValueEnum};
use std::path::PathBuf;

/// Structural analysis of buildings and bridges on seismic isolation.
///
/// Runs OpenSees Tcl scripts. Exit status: 0 done; 1 the analysis failed, or the script raised an error of its own;
/// 2 the input is wrong; 130 interrupted by Ctrl-C or SIGTERM.
#[derive(Parser, Debug)]
#[command(name = "hysteron", version, max_term_width = 100)]
pub(super) struct Arguments {
    #[command(subcommand)]
    pub(super) command: Command,
}

#[derive(Subcommand, Debug)]
pub(super) enum Command {
    /// Run a script; recorders write to the current folder
    Run {
        #[command(flatten)]
        script: ScriptArgs,
        #[command(flatten)]
        steps: StepArgs,
        #[command(flatten)]
        limits: LimitArgs,
        #[command(flatten)]
        folders: FolderArgs,
        #[command(flatten)]
        evidence: EvidenceArgs,
        #[command(flatten)]
        checkpoints: CheckpointArgs,
        /// Show no progress, peaks and loop in the terminal
        #[arg(long)]
        quiet: bool,
        /// The script
        model: String,
        /// Words that the script finds in $argv; behind "--" if they begin with a dash and are no numbers
        #[arg(allow_negative_numbers = true)]
        args: Vec<String>,
    },
    /// Run a script and write a page for a browser: model, motion, loops, forces and peaks
    View(ViewArgs),
    /// Report what is wrong with a script without running its analyses, or with a study before its calibration
    Check(CheckArgs),
    /// Drive a single bearing as in a testing machine, and measure its loops
    Bearing(BearingArgs),
    /// Measure the cycles in a file: secant stiffness, dissipated energy, equivalent damping
    Loops(LoopsArgs),
    /// Show what a measured file holds, convert it, and write it as CSV, as the file of a Path series or as NumPy's npz
    Recording(RecordingArgs),
    /// Spectra, intensity, rotation and scaling of ground motions
    Motions(MotionsArgs),
    /// Run an isolation study: bounds, motions and eccentricities; bearing schedule and checks
    Isolate(IsolateArgs),
    /// Incremental dynamic analysis of an isolation study: capacities of the records, fragility functions
    Ida(IdaArgs),
    /// Fragility functions of an isolation study from stripes of intensity, or of counts in a table
    Fragility(FragilityArgs),
    /// Multimode spectral analysis of an isolation study: effective stiffness, composite damping, CQC and SRSS
    ResponseSpectrum(ResponseSpectrumArgs),
    /// Run scripts for many parameters and motions, in parts if wanted; one table of results
    Batch(BatchArgs),
    /// Measure prototype tests of isolators: cycles, acceptance, lower and upper bounds
    Prototype(PrototypeArgs),
    /// Write a first study for a script and recordings, with comments on how sure it is
    Init(InitArgs),
    /// Find the parameters of a study that follow its recordings best
    Calibrate(CalibrateArgs),
    /// Find why a model and recordings differ, and repair the model
    Diagnose(DiagnoseArgs),
    /// Learn a law with memory from the runs of a device, and put it into the script
    Learn(LearnArgs),
    /// Show the commands of OpenSees that scripts may use, with their arguments
    Commands {
        /// A command (element lists its kinds), or a kind (Steel02); with both, the kind of that command
        #[arg(num_args = 0..=2)]
        names: Vec<String>,
    },
    /// Explain the code at the end of a message; without one, list all codes
    Explain {
        /// The code, for instance plain-constraints
        code: Option<String>,
    },
    /// Serve an editor: mistakes while a script or a study is written, hover, completion, definitions. An editor starts it
    Lsp(LspArgs),
    /// Print the completion script of a shell
    #[command(hide = true)]
    Completions {
        /// The shell
        shell: clap_complete::Shell,
    },
    /// Write the manual pages
    #[command(hide = true)]
    Man {
        /// Their folder
        folder: PathBuf,
    },
}

/// Evidence that is wanted beside the results of a run.
#[derive(Args, Debug, Default)]
pub(super) struct EvidenceArgs {
    /// Print the balance of energy at the end: input, kinetic, damping by source, work by class of element, error. With a
    /// file, write its history there as CSV
    #[arg(long, value_name = "FILE", num_args = 0..=1, require_equals = true)]
    pub(super) balance: Option<Option<PathBuf>>,
    /// Write a page for a reviewer: hashes of the inputs, what verifies the kinds used, error of the steps, energy, warnings.
    /// The script is run once more with half the steps
    #[arg(long, value_name = "FILE.html")]
    pub(super) review: Option<PathBuf>,
    /// Write a page for a browser: model, motion, loops and peaks
    #[arg(long, value_name = "FILE.html")]
    pub(super) view: Option<PathBuf>,
}

/// Options of the steps of an analysis beyond those of the script.
#[derive(Args, Debug, Default)]
pub(super) struct StepArgs {
    /// Try other algorithms and shorter steps where a step fails
    #[arg(long)]
    pub(super) ladder: bool,
    /// Make each step in N parts, to a hundredth of its tolerance: what changes is the error of the steps
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..=1000))]
    pub(super) refine: u32,
    /// Threads that work on a large model; all of the machine if it is not given
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..=1024))]
    pub(super) threads: Option<u64>,
}

/// Checkpoints of a run.
#[derive(Args, Debug, Default)]
pub(super) struct CheckpointArgs {
    /// Keep the state of transient analyses this often, for instance 60s or 5min, so that --resume goes on after a kill
    #[arg(long, value_name = "TIME", value_parser = super::limits::seconds,
          conflicts_with_all = ["ladder", "refine", "balance", "review", "view", "compat"])]
    pub(super) checkpoint: Option<std::time::Duration>,
    /// Go on from the last checkpoint of a run that was killed
    #[arg(long, requires = "checkpoint")]
    pub(super) resume: bool,
}

/// Folders of a run.
#[derive(Args, Debug, Default)]
pub(super) struct FolderArgs {
    /// Write what the script writes with relative paths into this folder
    #[arg(long, value_name = "DIR")]
    pub(super) out: Option<PathBuf>,
    /// Let the script write into this folder too, and not only below the current one
    #[arg(long, value_name = "DIR")]
    pub(super) allow_write: Vec<PathBuf>,
    /// Let the script read below the current folder and its own only, and hide the environment from it
    #[arg(long)]
    pub(super) sandbox: bool,
}

#[derive(Args, Debug)]
pub(super) struct CheckArgs {
    #[command(flatten)]
    pub(super) script: ScriptArgs,
    #[command(flatten)]
    pub(super) limits: LimitArgs,
    /// Print what the script prints, to standard error. It is discarded otherwise, since a check has no results
    #[arg(long)]
    pub(super) show_output: bool,
    /// Print the result as JSON on standard output
    #[arg(long)]
    pub(super) json: bool,
    /// The script, or a study or plan (.toml), whose script is run once
    pub(super) model: String,
    /// Words that the script finds in $argv; behind "--" if they begin with a dash and are no numbers
    #[arg(allow_negative_numbers = true)]
    pub(super) args: Vec<String>,
}

#[derive(Args, Debug)]
pub(super) struct CalibrateArgs {
    #[command(flatten)]
    pub(super) limits: LimitArgs,
    /// Studies, or folders with files study.toml
    #[arg(required = true)]
    pub(super) studies: Vec<PathBuf>,
    /// Where the results go; several studies get a folder each in it
    #[arg(long, value_name = "DIR")]
    pub(super) out: Option<PathBuf>,
    /// Number of threads; all cores if it is not given. The result does not depend on it
    #[arg(long, value_name = "N")]
    pub(super) threads: Option<usize>,
    /// Method, in place of the study's
    #[arg(long, value_name = "NAME")]
    pub(super) method: Option<String>,
    /// Seed of the random numbers, in place of the study's
    #[arg(long, value_name = "N")]
    pub(super) seed: Option<u64>,
    /// How often the search is made, in place of the study's number
    #[arg(long, value_name = "N")]
    pub(super) repeats: Option<usize>,
    /// Profile likelihoods of the parameters
    #[arg(long)]
    pub(super) profile: bool,
    /// Sample the posterior of the parameters, with this many sweeps
    #[arg(long, value_name = "SWEEPS", num_args = 0..=1, default_missing_value = "400")]
    pub(super) posterior: Option<usize>,
    /// Write report_interactive.html too: the report with charts to be zoomed and asked in a browser
    #[arg(long)]
    pub(super) view: bool,
    /// Go on where an interrupted calibration was stopped
    #[arg(long)]
    pub(super) resume: bool,
    /// Print the results as JSON on standard output
    #[arg(long)]
    pub(super) json: bool,
    /// Reproduce known errors of another program
    #[arg(long, value_enum, value_name = "PROGRAM")]
    pub(super) compat: Option<Compat>,
}

#[derive(Args, Debug)]
pub(super) struct DiagnoseArgs {
    #[command(flatten)]
    pub(super) limits: LimitArgs,
    /// The study
    pub(super) study: PathBuf,
    /// Where the results go
    #[arg(long, value_name = "DIR")]
    pub(super) out: Option<PathBuf>,
    /// Leave causes out of the library
    #[arg(long, value_name = "CAUSE", num_args = 1..)]
    pub(super) without: Vec<String>,
    /// Number of threads; all cores if it is not given. The result does not depend on it
    #[arg(long, value_name = "N")]
    pub(super) threads: Option<usize>,
    /// Write report_interactive.html too: the report with charts to be zoomed and asked in a browser
    #[arg(long)]
    pub(super) view: bool,
    /// Go on where an interrupted diagnosis was stopped
    #[arg(long)]
    pub(super) resume: bool,
    /// Times that count by one are seconds, and not the numbers of samples
    #[arg(long)]
    pub(super) clock: bool,
    /// Begin although a channel seems to have the wrong sign, unit, clock or place
    #[arg(long)]
    pub(super) as_recorded: bool,
    /// Show the statistics: probabilities, bootstrap, and all explanations that were weighed
    #[arg(long)]
    pub(super) verbose: bool,
    /// Print diagnosis.json in place of the summary
    #[arg(long, conflicts_with = "verbose")]
    pub(super) json: bool,
    /// Reproduce known errors of another program
    #[arg(long, value_enum, value_name = "PROGRAM")]
    pub(super) compat: Option<Compat>,
}

#[derive(Args, Debug)]
pub(super) struct LearnArgs {
    #[command(flatten)]
    pub(super) limits: LimitArgs,
    /// The study
    pub(super) study: PathBuf,
    /// Where the results go
    #[arg(long, value_name = "DIR")]
    pub(super) out: Option<PathBuf>,
    /// Number of threads; all cores if it is not given. The result does not depend on it
    #[arg(long, value_name = "N")]
    pub(super) threads: Option<usize>,
    /// Times that count by one are seconds, and not the numbers of samples
    #[arg(long)]
    pub(super) clock: bool,
}

#[derive(Args, Debug)]
pub(super) struct ScriptArgs {
    /// Refuse what would otherwise be a warning
    #[arg(long)]
    pub(super) strict: bool,
    /// Reproduce known errors of another program
    #[arg(long, value_enum, value_name = "PROGRAM")]
    pub(super) compat: Option<Compat>,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
pub(super) enum Compat {
    /// OpenSees
    Opensees,
}
