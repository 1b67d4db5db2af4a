//! Files of Python as editors see them: calls of OpenSees are commands.

use crate::line::LineBefore;
use hysteron_calls::{FoundCall, open_call, read};
use hysteron_tcl::{Syntax, WrittenCommand};

pub(crate) use hysteron_calls::bare;

/// The calls of a text, with the words of their arguments.
pub(crate) fn syntax(text: &str) -> Syntax {
    let calls = read(text).map(|r| r.calls).unwrap_or_default();
    Syntax { commands: calls.iter().map(written).collect(), variables: vec![] }
}

fn written(call: &FoundCall) -> WrittenCommand {
    let mut words = vec![call.name_at.clone()];
    for argument in &call.arguments {
        // The items of a list are words of their own, those of a variable are not.
        let own = argument.words.iter().flatten().map(|(_, at)| at.clone());
        words.extend(if argument.words.is_some() { own.collect() } else { vec![argument.at.clone()] });
    }
    words.dedup();
    let words = words.into_iter().map(|at| (at.start, at.end)).collect();
    WrittenCommand { start: call.at.start, end: call.at.end, words, parent: None }
}

/// The call that is being written before a byte; `None` where no command is called.
pub(crate) fn before(text: &str, at: usize) -> Option<LineBefore<'_>> {
    let call = open_call(text, at)?;
    Some(LineBefore {
        start: at - call.partial.len(),
        words: call.words,
        partial: call.partial,
        is_quoted: call.is_quoted,
    })
}
