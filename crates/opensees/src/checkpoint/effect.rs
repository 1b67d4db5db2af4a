//! What commands leave behind in a model.

use crate::{Command, calls};
use hysteron_tcl::Value;

/// What a call leaves behind in the model that it was made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Effect {
    /// The model is as before.
    Nothing,
    /// The model, its analysis or its settings differ.
    Changes,
    /// The model is empty.
    Empties,
    /// The state is that of a file.
    ReadsState,
}

/// Commands beside those that look which write or compute, and change nothing.
const TELLING: [&str; 5] = ["printA", "printB", "modalProperties", "sdfResponse", "save"];
/// Settings among the commands that look.
const SETTING: [&str; 2] = ["reactions", "setPrecision"];

/// What a call of a command leaves behind; `first` is its first argument. Recorders are not of the model.
pub fn effect(command: &Command, first: Option<&Value>) -> Effect {
    let name = command.name;
    match name {
        "wipe" => Effect::Empties,
        "restore" => Effect::ReadsState,
        "remove" if first.is_some_and(|w| w.as_str().starts_with("recorder")) => Effect::Nothing,
        _ if SETTING.contains(&name) || super::CHANGES.contains(&name) => Effect::Changes,
        _ if calls::only_looks(command) || super::is_question(name) => Effect::Nothing,
        // OpenSees' names for commands that ask.
        _ if TELLING.contains(&name) || name.starts_with("get") => Effect::Nothing,
        _ => Effect::Changes,
    }
}
