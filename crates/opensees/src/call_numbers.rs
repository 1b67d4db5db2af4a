//! Numbers of calls by a host, which stand for places in a script.

use crate::Tcl;
use hysteron_tcl::diagnostic::{SourceId, Span};

/// Number of calls made by a host, and the source that stands for them in the places of messages.
#[derive(Clone, Copy, Debug, Default)]
pub struct CallNumbers {
    source: Option<SourceId>,
    last: u32,
}

impl CallNumbers {
    /// The word of the last call that a span names; `Some(None)` for the whole call, `None` for another call or a file.
    pub fn word(&self, span: Span) -> Option<Option<usize>> {
        let is_last = Some(span.source) == self.source && span.start == self.last;
        is_last.then(|| (span.end != u32::MAX).then_some(span.end as usize))
    }

    /// Returns true if the span is one of a call by the host.
    pub fn is_call(&self, span: Span) -> bool {
        Some(span.source) == self.source
    }
}

/// Source that stands for the calls, and the number of the next one.
pub(crate) fn next_number(interp: &mut Tcl) -> (SourceId, u32) {
    let numbers = &mut interp.host.call_numbers;
    numbers.last = numbers.last.wrapping_add(1);
    let number = numbers.last;
    let source = *numbers.source.get_or_insert_with(|| interp.core.sources.add("call", ""));
    (source, number)
}
