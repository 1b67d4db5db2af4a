//! Stack space for recursion.
//!
//! Evaluation, parsing and the writing of nested lists recurse. Each of them calls [`grow`] once a level.
//! It allocates a new piece of stack on the heap when less than [`RED_ZONE`] is left. Levels are limited as well
//! ([`super::eval::MAX_LEVELS`] and [`super::lexer::MAX_NESTING`]), so that the pieces stay few. A thread with 2 MiB or
//! less is therefore enough for any script, in debug builds too.

/// Bytes of stack for the work between two calls of [`grow`].
const RED_ZONE: usize = 128 * 1024;
/// Bytes of a new piece.
const PIECE: usize = 2 * 1024 * 1024;

/// Do work that may recurse.
#[inline]
pub(crate) fn grow<R>(work: impl FnOnce() -> R) -> R {
    stacker::maybe_grow(RED_ZONE, PIECE, work)
}
