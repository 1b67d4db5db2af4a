//! Findings of the checks before a fit.

use super::messages::Messages;
use hysteron::checks::CHANNEL_DOUBT;
use hysteron::diagnostic::{Diagnostic, SourceMap};
use hysteron::preflight::{Preflight, preflight};
use hysteron::study::{InitialRun, ScriptSimulator};

/// Number of threads: that of the arguments, or that of the processors.
pub(super) fn threads(given: Option<usize>) -> usize {
    given.unwrap_or_else(|| std::thread::available_parallelism().map_or(1, usize::from))
}

/// Check the channels of a study and print the findings on standard error. Hard ones are errors if `hard_is_error`.
/// `sources` has the text of the study.
pub(super) fn check_channels(
    simulator: &ScriptSimulator,
    initial_run: &InitialRun,
    threads: usize,
    hard_is_error: bool,
    sources: &SourceMap,
) -> std::io::Result<Preflight> {
    let result = preflight(simulator, initial_run, threads)?;
    for f in &result.findings {
        let place = f.runs.first().and_then(|run| simulator.study().channel_location(run, &f.channel));
        let d = match f.is_hard && hard_is_error {
            true => Diagnostic::error(f.message.clone()).by(&CHANNEL_DOUBT),
            false => Diagnostic::warning(&CHANNEL_DOUBT, f.message.clone()),
        };
        let d = d.at(place, "").help(f.help.clone());
        eprintln!("{}\n", Messages::new().render(&d, sources));
    }
    Ok(result)
}
