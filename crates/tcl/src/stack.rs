//! Room on the stack for whatever nests.
//!
//! Evaluation, parsing and the writing of nested lists recurse. Each of them calls [`grow`] once a level, which goes on
//! with a fresh piece of stack from the heap when less than [`RED_ZONE`] is left. Levels are counted as well
//! ([`super::eval::MAX_LEVELS`] and [`super::lexer::MAX_NESTING`]), so that the pieces stay few. A thread with 2 MiB, or with
//! much less, is therefore enough for any script, in debug builds too.

/// Never less than this is left for the work between two calls of [`grow`].
const RED_ZONE: usize = 128 * 1024;
/// Size of a fresh piece.
const PIECE: usize = 2 * 1024 * 1024;

/// Do something that may nest.
#[inline]
pub(crate) fn grow<R>(work: impl FnOnce() -> R) -> R {
    stacker::maybe_grow(RED_ZONE, PIECE, work)
}
