//! Effects of commands on a model.

use crate::Command;
use hysteron_tcl::Value;

/// Effect of a call on the model that it was made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Effect {
    /// The model is as before, and the answer is all that the call gives.
    Asks,
    /// The model is as before. A file may be written, or an answer computed.
    Nothing,
    /// The model, its analysis or its settings differ.
    Changes,
    /// The model is empty.
    Empties,
    /// The state is that of a file.
    ReadsState,
}

/// Returns true if no recorder is left after a call of a command; `first` is its first argument.
pub(crate) fn ends_recorders(command: &Command, first: Option<&Value>) -> bool {
    let removes_all = || command.name == "remove" && first.is_some_and(|w| w.as_str() == "recorders");
    command.effect == Effect::Empties || removes_all()
}

/// Effect of a call of a command; `first` is its first argument. Recorders are not of the model.
pub fn effect(command: &Command, first: Option<&Value>) -> Effect {
    let is_recorder = || first.is_some_and(|w| w.as_str().starts_with("recorder"));
    if command.name == "remove" && is_recorder() { Effect::Nothing } else { command.effect }
}
