//! Help texts with examples, completions of shells and manual pages.

use super::args::Arguments;
use super::examples;
use clap::{Command, CommandFactory};
use clap_complete::Shell;
use std::path::Path;

/// Examples of each command: what one does, and below it the command line.
const EXAMPLES: &[(&str, &str)] = &[
    (
        "run",
        "Examples:
  Run a script. Its recorders write to the current folder.
    hysteron run model.tcl
  The same with two words for the script, which finds them in $argv.
    hysteron run model.tcl 0.35 elcentro.dat
  Go on with other algorithms and shorter steps where a step fails.
    hysteron run --ladder model.tcl
  Make each step in four parts: what changes is the error of the steps.
    hysteron run --refine 4 model.tcl",
    ),
    (
        "check",
        "Examples:
  Report every mistake of a script. No step is made and no file is written.
    hysteron check model.tcl
  The same for a study, its script and its recordings.
    hysteron check study.toml
  Fail if there is a warning, for instance before a long batch.
    hysteron check --strict model.tcl",
    ),
    (
        "init",
        "Examples:
  A complete example to begin with, in a folder of its own: building, bearing, study or isolation.
    hysteron init --new building --out first
  A first study of your own script and two recordings.
    hysteron init model.tcl test1.csv test2.csv
  An isolation study of your own script.
    hysteron init --isolation building.tcl",
    ),
    (
        "bearing",
        "Examples:
  Three cycles each at 30 and 60 mm under 170 kN, for a device in N and m.
    hysteron bearing models/rr_frb_kikuchi.tcl -a 0.03,0.06 --axial 170e3
  A bearing of your own: nodes, materials and element 1, without supports.
    hysteron bearing bearing.tcl --amplitudes 0.05 --cycles 5 --units kN m
  Write the test as a script and do not run it.
    hysteron bearing bearing.tcl --amplitudes 0.05 --script
  One bearing of a whole building, taken out of its script.
    hysteron bearing building.tcl --element 12 --amplitudes 0.2",
    ),
    (
        "view",
        "Examples:
  Run a script and write model.html, a page for a browser.
    hysteron view model.tcl --units kN m
  With three modes, under another name.
    hysteron view model.tcl --modes 3 --out building.html
  Files for ParaView, of every tenth step.
    hysteron view model.tcl --vtk steps --every 10",
    ),
    (
        "recording",
        "Examples:
  Show what a file holds: quantities, units, times and a plot of each channel.
    hysteron recording test.csv
  Write one channel as the file of timeSeries Path, in m.
    hysteron recording test.csv --channel disp --to m --out disp.txt
  A record in g without a header, as m/s2 in a table.
    hysteron recording record.txt --unit g --dt 0.01 --to m/s2 --out record.csv",
    ),
    (
        "motions",
        "Examples:
  Peaks and intensities of a pair of records in g.
    hysteron motions x.txt y.txt --unit g --dt 0.01
  The same scaled to a spectrum of ASCE 7 between 1.5 and 3.5 s, with a report in the folder scaled.
    hysteron motions x.txt y.txt --unit g --dt 0.01 --target asce7 sms=1.0 sm1=0.6 tl=8 --scale 1.5 3.5 --out scaled",
    ),
    (
        "prototype",
        "Examples:
  Cycles, bounds and acceptance of two tests at a design displacement of 0.30 m.
    hysteron prototype test1.csv test2.csv -u disp -f force --units kN m --design 0.30 --out prototype",
    ),
    (
        "isolate",
        "Examples:
  See that study and script agree, then run all analyses and write design/report.html.
    hysteron check study.toml
    hysteron isolate study.toml --out design
  Go on after Ctrl-C.
    hysteron isolate study.toml --out design --resume
  The difference of two results.
    hysteron isolate first --compare second",
    ),
    (
        "response-spectrum",
        "Examples:
  The multimode method for the study of an isolated structure.
    hysteron response-spectrum study.toml --out modes",
    ),
    (
        "ida",
        "Examples:
  Scale each motion up until limits are passed; the study has [intensity] and [ida].
    hysteron ida study.toml --out ida",
    ),
    (
        "fragility",
        "Examples:
  Fragility functions from the levels of intensity in [stripes] of a study.
    hysteron fragility study.toml --out fragility
  Fragility functions of counts in a table.
    hysteron fragility counts.csv",
    ),
    (
        "batch",
        "Examples:
  Run all cases of a plan, and write the table of results into the folder runs.
    hysteron batch plan.toml --out runs
  The second of four parts, for instance on another machine.
    hysteron batch plan.toml --out runs --shard 2/4",
    ),
    (
        "lsp",
        "Examples:
  The command that the settings of an editor name for files .tcl and .toml.
    hysteron lsp",
    ),
    (
        "loops",
        "Examples:
  Displacement in column 2 and force in column 3 of a recorder file.
    hysteron loops loop.out -u 2 -f 3
  Columns by name, the loops as a picture, the table as CSV.
    hysteron loops test.csv -u disp -f force --svg loops.svg --table csv",
    ),
    (
        "calibrate",
        "Examples:
  See that a study is sound, then fit its parameters.
    hysteron check study.toml
    hysteron calibrate study.toml --out results
  Three searches with other random numbers, and intervals by profile likelihood.
    hysteron calibrate study.toml --repeats 3 --profile
  Go on after Ctrl-C.
    hysteron calibrate study.toml --resume",
    ),
    (
        "diagnose",
        "Examples:
  Find what the model of a study lacks, and write results/corrected.tcl.
    hysteron diagnose study.toml --out results
  The same without one of the causes.
    hysteron diagnose study.toml --without gap_impact
  All explanations with their evidence.
    hysteron diagnose study.toml --verbose",
    ),
    (
        "learn",
        "Examples:
  Learn the law of a device on a bench, and write results/learned.tcl and results/learned_law.json.
    hysteron learn study.toml --out results",
    ),
    (
        "commands",
        "Examples:
  All commands, and the kinds of elements.
    hysteron commands
    hysteron commands element
  Arguments and recorder responses of a kind, with its command if need be.
    hysteron commands Steel02
    hysteron commands section Elastic",
    ),
    (
        "explain",
        "Examples:
  What a warning means that ends with [plain-constraints], and what to do.
    hysteron explain plain-constraints
  All codes.
    hysteron explain",
    ),
];

/// The command line with its examples.
pub(super) fn command() -> Command {
    let begin = format!("To begin with a complete example:\n{}\n", examples::list());
    let more = "\"hysteron COMMAND --help\" shows options and examples of a command.";
    let command = Arguments::command().after_help(begin + more);
    let command = command.mut_subcommand("init", |c| c.arg_required_else_help(true));
    EXAMPLES.iter().fold(command, |command, (name, text)| command.mut_subcommand(name, |c| c.after_help(*text)))
}

/// The completion script of a shell.
pub(super) fn completions(shell: Shell) -> String {
    let mut text = vec![];
    clap_complete::generate(shell, &mut command(), "hysteron", &mut text);
    String::from_utf8_lossy(&text).into_owned()
}

/// Writes `hysteron.1` and a page for each command into a folder, which is made where there is none.
///
/// # Errors
///
/// A message if a file cannot be written.
pub(super) fn man(folder: &Path) -> Result<String, String> {
    let failed = |e: std::io::Error| format!("{}: {e}", folder.display());
    hysteron_files::make_folders(folder).map_err(failed)?;
    let command = command().disable_help_subcommand(true);
    clap_mangen::generate_to(command, folder).map_err(failed)?;
    Ok(String::new())
}
