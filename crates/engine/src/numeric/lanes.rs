//! Loops by the widest vector instructions of the processor.
//!
//! A loop over arrays without branches and calls becomes vector instructions. Each number has the same bits with all
//! instructions, because products and sums are fused where the source says so, and nowhere else.

use pulp::{Arch, NullaryFnOnce};

/// Numbers of a vector. Sums of many numbers are made of as many sums side by side.
pub(crate) const LANES: usize = 4;
/// Numbers of a block: those of the widest vector instructions. Arrays that are padded to whole blocks need no copies.
pub(crate) const BLOCK: usize = 2 * LANES;

/// Arrays with a loop over them.
pub(crate) trait Lanes {
    /// The loop. The method must be inlined, or it is not compiled for the instructions of the processor.
    fn evaluate(&mut self);
}

/// Evaluates a loop with the widest vector instructions of the processor.
#[inline]
pub(crate) fn in_lanes<L: Lanes>(lanes: &mut L) {
    struct Loop<'a, L>(&'a mut L);
    impl<L: Lanes> NullaryFnOnce for Loop<'_, L> {
        type Output = ();
        #[inline(always)]
        fn call(self) {
            self.0.evaluate();
        }
    }
    Arch::new().dispatch(Loop(lanes));
}

/// A result of a turn of a loop, made before the next turn begins.
///
/// Else the compiler may make vectors of short outer loops, whose numbers do not lie side by side: it gathers them one by one,
/// which takes ten times as long.
#[inline(always)]
pub(crate) fn in_turn<T>(result: T) -> T {
    std::hint::black_box(result)
}

/// `a` if the condition holds, else `b`, without a branch.
#[inline(always)]
pub(crate) fn select(condition: bool, a: f64, b: f64) -> f64 {
    if condition { a } else { b }
}

/// 1 if the condition holds, else 0: a flag for [`any`].
#[inline(always)]
pub(crate) fn flag(condition: bool) -> u64 {
    u64::from(condition)
}

/// Returns true if a flag is set.
#[inline(always)]
pub(crate) fn any<const W: usize>(flags: &[u64; W]) -> bool {
    flags.iter().fold(0, |all, flag| all | flag) != 0
}

/// Up to `W` numbers of a slice as an array, with zeros behind them.
#[inline(always)]
pub(crate) fn load<const W: usize>(from: &[f64]) -> [f64; W] {
    if let Some(from) = from.first_chunk::<W>() {
        return *from;
    }
    let mut out = [0.0; W];
    let (chunks, rest) = from.as_chunks::<LANES>();
    let (to, _) = out.as_chunks_mut::<LANES>();
    to.iter_mut().zip(chunks).for_each(|(to, from)| *to = *from);
    if let Some(to) = to.get_mut(chunks.len()) {
        copy_rest(rest, to);
    }
    out
}

/// Copies as many numbers of an array as there is room for, in pieces of a known length.
#[inline(always)]
pub(crate) fn copy_back<const W: usize>(from: &[f64; W], to: &mut [f64]) {
    if let Some(to) = to.first_chunk_mut::<W>() {
        *to = *from;
        return;
    }
    let (from, _) = from.as_chunks::<LANES>();
    let (to, rest) = to.as_chunks_mut::<LANES>();
    to.iter_mut().zip(from).for_each(|(to, from)| *to = *from);
    if let Some(from) = from.get(to.len()) {
        copy_rest(&from[..rest.len()], rest);
    }
}

/// Copies fewer numbers than a vector has.
#[inline(always)]
fn copy_rest(from: &[f64], to: &mut [f64]) {
    match (from, to) {
        ([a], [x, ..]) => *x = *a,
        ([a, b], [x, y, ..]) => (*x, *y) = (*a, *b),
        ([a, b, c], [x, y, z, ..]) => (*x, *y, *z) = (*a, *b, *c),
        _ => {}
    }
}
