//! The OpenSees commands of a script.
//!
//! A command is a function of the interpreter and the call. It takes its words with `args::Args`, whose messages
//! point at the word that is wrong, and changes the [`Session`].
//!
//! To add a command: a function in the file of its family, and a line in the family's `COMMANDS`. To add a kind of
//! thing that a command makes: a function or a file, and a row in the family's `KINDS`. The row has a sentence about it.

#![forbid(unsafe_code)]

pub mod alone;
mod analysis;
mod args;
mod call_numbers;
pub mod calls;
pub mod chart;
mod check;
pub mod checkpoint;
pub mod checks;
mod course;
pub mod effect;
mod element;
pub mod files;
mod foreign;
mod host;
pub mod index;
mod kind;
mod load;
pub mod lockstep;
mod material;
mod mistakes;
mod model;
pub mod opensees_names;
mod output;
mod parameter;
pub mod python_usage;
mod recipes;
pub mod run;
mod section;
mod session;
pub mod slips;
mod text;
pub mod things;
mod watch;

use args::Args;
use effect::Effect;
use hysteron_tcl::diagnostic::Diagnostic;
use hysteron_tcl::{Call, Exception, Interp, Value, decode};
use std::collections::HashMap;
use std::io::{Error, ErrorKind};
use std::sync::OnceLock;

pub use analysis::speeds::warn_of_speedless;
pub use element::learned::{law_of_json, law_to_json, law_to_words};
pub use element::{AMENDMENTS, AmendmentKind, AmendmentOption, numbers_of_element};
pub use files::number_files::NumberFiles;
pub use files::outputs::{FileFormat, NoFiles, Outputs};
pub use files::series::{DiskSeries, FileSeries};
pub use host::{BeforeTransient, Mode, MotionObserver, OnWarning, Progress};
pub use kind::KindUsage;
pub use mistakes::CheckState;
pub use output::{AnalysedModel, Balances, ModelSize};
pub use run::continued::Continued;
pub use session::{ModelBuilder, Session};
pub use text::{Arg, Domain, Text, WITHOUT_EFFECT};
pub use watch::isolator_damping::may_isolate;
pub use watch::overview::{Fact, Overview};

/// The interpreter that the commands run in.
pub type Tcl = Interp<Session>;

/// Result of a command.
type Outcome = Result<Value, Exception>;

/// A command and how it is used.
pub struct Command {
    /// Name.
    pub name: &'static str,
    /// Usage in one line.
    pub usage: &'static str,
    /// Its text in the reference.
    pub text: Text,
    run: fn(&mut Tcl, &Call<'_>) -> Outcome,
    kinds: fn() -> Vec<KindUsage>,
    /// Kinds of things that it defines, and the position of the tag among its words.
    defines: (&'static [&'static str], usize),
    /// Effect of a call of it on the model.
    effect: Effect,
}

impl Command {
    const fn new(name: &'static str, usage: &'static str, run: fn(&mut Tcl, &Call<'_>) -> Outcome) -> Self {
        Self { name, usage, text: Text::NONE, run, kinds: Vec::new, defines: (&[], 0), effect: Effect::Changes }
    }

    /// A command that only asks for results.
    const fn asking(name: &'static str, usage: &'static str, run: fn(&mut Tcl, &Call<'_>) -> Outcome) -> Self {
        Self::new(name, usage, run).leaving(Effect::Asks)
    }

    /// The same command with one sentence or two about it.
    const fn about(mut self, sentence: &'static str) -> Self {
        self.text.about = sentence;
        self
    }

    /// The same command with meanings of arguments, of all its kinds.
    const fn arguments(mut self, arguments: &'static [Arg]) -> Self {
        self.text.arguments = arguments;
        self
    }

    /// The same command with arguments that it shares with others.
    const fn groups(mut self, groups: &'static [&'static [Arg]]) -> Self {
        self.text.groups = groups;
        self
    }

    /// The same command as one that OpenSees does not have.
    const fn own(mut self) -> Self {
        self.text.is_own = true;
        self
    }

    /// The same command as one whose calls leave this behind.
    const fn leaving(mut self, effect: Effect) -> Self {
        self.effect = effect;
        self
    }

    /// The same command as one whose first word chooses a kind: the usages of the kinds.
    const fn with_kinds(mut self, kinds: fn() -> Vec<KindUsage>) -> Self {
        self.kinds = kinds;
        self
    }

    /// The same command as one that defines things of these kinds; `at` is the position of the tag, 0 where it has none.
    const fn defining(mut self, kinds: &'static [&'static str], at: usize) -> Self {
        self.defines = (kinds, at);
        self
    }

    /// Names and usage of each kind of thing that the command makes; empty for a command without kinds.
    pub fn kinds(&self) -> Vec<KindUsage> {
        (self.kinds)()
    }

    /// Kinds of things that it defines, and the position of the tag among its words; 0 where it has none.
    pub fn definition(&self) -> (&'static [&'static str], usize) {
        self.defines
    }

    /// An argument of the command or of its kind, where a row declares it.
    pub fn argument(&self, kind: Option<KindUsage>, option: &str, name: &str) -> Option<&'static Arg> {
        let of_kind = kind.and_then(|k| k.text.argument(option, name));
        of_kind.or_else(|| self.text.argument(option, name)).or_else(|| text::argument_of_any(option, name))
    }

    /// Usage under the command's own name. Commands of a family may share one usage.
    pub fn usage_line(&self) -> String {
        usage_as(self.name, self.usage)
    }
}

/// A usage under the name of a command that shares it with the one it begins with.
fn usage_as(name: &str, usage: &str) -> String {
    let name = name.rsplit("::").next().unwrap_or_default();
    let head = usage.split(' ').next().unwrap_or_default();
    let shared = head != name && [head, name].iter().all(|n| commands().any(|c| c.name == *n));
    if shared { format!("{name}{}", &usage[head.len()..]) } else { usage.to_owned() }
}

/// Page of the reference with the commands that OpenSees does not have.
const OWN_PAGE: &str = "hysteron";

/// The commands of all families, with the page of the reference that each family stands on.
const FAMILIES: &[(&str, &[Command])] = &[
    ("model", model::nodes::COMMANDS),
    ("model", model::constraint::COMMANDS),
    ("material", material::COMMANDS),
    ("material", material::backbone::COMMANDS),
    ("material", material::limit_state::COMMANDS),
    ("material", material::stage::COMMANDS),
    ("material", material::friction::COMMANDS),
    ("section", section::COMMANDS),
    ("section", section::fiber::COMMANDS),
    ("element", section::beam_integration::COMMANDS),
    ("element", model::transform::COMMANDS),
    ("element", element::COMMANDS),
    ("material", material::nd_material::COMMANDS),
    ("model", model::block::COMMANDS),
    ("model", element::amend::COMMANDS),
    ("model", element::damping::COMMANDS),
    ("load", load::series::COMMANDS),
    ("load", load::motion_file::COMMANDS),
    ("load", load::pattern::COMMANDS),
    ("load", load::ground_motion::COMMANDS),
    ("model", analysis::damping::COMMANDS),
    ("model", analysis::modal_damping::COMMANDS),
    ("analysis", analysis::solution::COMMANDS),
    ("analysis", analysis::algorithm::COMMANDS),
    ("analysis", analysis::integrator::COMMANDS),
    ("analysis", analysis::analyze::COMMANDS),
    ("analysis", analysis::modal_properties::COMMANDS),
    ("analysis", analysis::response_spectrum::COMMANDS),
    ("analysis", analysis::single_degree::COMMANDS),
    ("output", output::recorder::COMMANDS),
    ("output", output::query::COMMANDS),
    ("output", output::section_query::COMMANDS),
    ("output", output::inventory::COMMANDS),
    ("output", output::loads::COMMANDS),
    ("output", output::print::COMMANDS),
    ("output", output::verify::COMMANDS),
    ("analysis", analysis::matrix::COMMANDS),
    ("model", model::remove::COMMANDS),
    ("model", model::database::COMMANDS),
    ("model", parameter::COMMANDS),
    ("analysis", parameter::sensitivity::COMMANDS),
    ("model", model::units::COMMANDS),
    ("output", output::display::COMMANDS),
    ("output", output::figure::COMMANDS),
];

/// The commands of all families.
pub fn commands() -> impl Iterator<Item = &'static Command> {
    FAMILIES.iter().flat_map(|(_, commands)| *commands)
}

/// The command of a name.
pub fn command(name: &str) -> Option<&'static Command> {
    static KNOWN: OnceLock<HashMap<&'static str, &'static Command>> = OnceLock::new();
    let all = || {
        let mut known = HashMap::new();
        for command in commands() {
            known.entry(command.name).or_insert(command);
        }
        known
    };
    KNOWN.get_or_init(all).get(name).copied()
}

/// The commands on a page of the reference.
pub fn commands_on(page: &str) -> impl Iterator<Item = &'static Command> {
    let all = FAMILIES.iter().flat_map(|(of, commands)| commands.iter().map(move |c| (*of, c)));
    all.filter(move |(of, c)| page == if c.text.is_own { OWN_PAGE } else { of }).map(|(_, c)| c)
}

/// Names and usage of each kind of thing that the command makes; empty for a command without kinds.
pub fn kinds(command: &str) -> Vec<KindUsage> {
    commands().filter(|c| c.name == command).flat_map(Command::kinds).collect()
}

/// Names of commands that OpenSees does not have.
pub fn own_commands() -> impl Iterator<Item = &'static str> {
    commands().filter(|c| c.text.is_own).map(|c| c.name)
}

/// Names of kinds that OpenSees does not have, of all commands.
pub fn own_kinds() -> impl Iterator<Item = &'static str> {
    let own = commands().flat_map(Command::kinds).filter(|k| k.text.is_own);
    own.flat_map(|k| k.names.iter().copied())
}

/// Register the commands with an interpreter.
pub fn install(interp: &mut Tcl) {
    let checks = interp.host.mode == Mode::Check;
    for c in commands() {
        interp.register(c.name, if checks { check::run_command } else { c.run });
    }
    if checks {
        interp.on_error = Some(check::handle_error);
    }
}

/// Warn, or under `--strict` refuse.
fn warn(interp: &mut Tcl, mut warning: Diagnostic) -> Result<(), Exception> {
    if interp.host.strict {
        warning.severity = hysteron_tcl::diagnostic::Severity::Error;
        return Err(Exception::diagnosed(warning));
    }
    report(interp, warning);
    Ok(())
}

/// Warn that the word just taken is none of the command's options, and ignore it.
fn ignore_option(interp: &mut Tcl, args: &mut Args<'_>, known: &[&str]) -> Result<(), Exception> {
    args.unknown_option(known)?.map_or(Ok(()), |d| warn(interp, d))
}

/// Warn that the word just taken is none of the options in the usage, and ignore it.
fn ignore_unknown(interp: &mut Tcl, args: &mut Args<'_>) -> Result<(), Exception> {
    let known = args.options();
    ignore_option(interp, args, &known)
}

/// Report a message, whether or not warnings are errors.
fn report(interp: &mut Tcl, warning: Diagnostic) {
    // What came from the same place before is counted there.
    let is_new = interp.warn(warning).is_some();
    if let (Some(handler), Some(warning)) =
        (&mut interp.host.warnings.handler, interp.core.warnings.last().filter(|_| is_new))
    {
        handler(warning, &interp.core.sources);
    }
}

/// Warn about words that are left over.
fn finish(interp: &mut Tcl, args: &Args<'_>) -> Result<(), Exception> {
    args.rest().map_or(Ok(()), |w| warn(interp, w))
}

/// Content of a text file, by the name the script gives it.
fn read_text(interp: &mut Tcl, name: &str) -> std::io::Result<String> {
    let path = interp.absolute(name);
    let bytes = interp.files.read(&path)?;
    let unfit =
        |encoding| Error::new(ErrorKind::InvalidData, format!("its text is encoded in {encoding}: save it as UTF-8"));
    decode(bytes).map_err(unfit)
}

/// Write to the script's error stream.
fn print_error(interp: &mut Tcl, text: &str) {
    interp.console.err(text);
}
