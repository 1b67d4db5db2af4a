//! Mistakes that a check of a script has found. Consequences of a mistake are not reported.

use crate::host::Mode;
use crate::{Tcl, commands, report, things};
use hysteron_tcl::Exception;
use hysteron_tcl::diagnostic::Absent;
use std::collections::BTreeSet;

/// Mistakes that a check has found, and their consequences.
#[derive(Debug, Default)]
pub struct CheckState {
    /// A definition was rejected: the model is not the one that was meant.
    pub(crate) rejected: bool,
    /// Things that rejected commands would have defined: a message that misses one only follows from that mistake.
    pub(crate) consequences: BTreeSet<Absent>,
    /// A procedure or a file was left at a mistake: what the rest of it would have defined is not there.
    pub(crate) left_early: bool,
    /// Number of errors that were held back because they only follow from one already reported.
    pub held_back: usize,
    /// Analyses were passed over because a definition was rejected.
    pub skipped_analyses: bool,
    /// A check has passed over an analysis: results that the script reads are not there.
    pub waits_for_results: bool,
}

impl CheckState {
    /// Returns true if something is only missing for a mistake already reported, and counts it.
    pub(crate) fn holds_back(&mut self, absent: &Absent) -> bool {
        let is_of_rest = self.left_early && commands().any(|c| c.defines.1 > 0 && c.defines.0.contains(&absent.kind));
        let held_back = is_of_rest || self.consequences.contains(absent);
        self.held_back += usize::from(held_back);
        held_back
    }

    /// An analysis is passed over; what its results would be asked for is not there.
    pub(crate) fn pass_over(&mut self, modes: usize) {
        self.skipped_analyses = true;
        self.consequences.extend((1..=modes).map(|i| Absent::new(things::MODE, i)));
        if modes > 0 {
            self.consequences.insert(Absent::new(things::MODE, ""));
        }
    }
}

/// A mistake that a command can go on with: a check reports it, a run is refused.
pub(crate) fn go_on(interp: &mut Tcl, result: Result<(), Exception>) -> Result<(), Exception> {
    match result {
        Err(Exception::Error(e)) if interp.host.mode == Mode::Check => {
            interp.host.check.rejected = true;
            report(interp, e.diagnostic);
            Ok(())
        }
        result => result,
    }
}
