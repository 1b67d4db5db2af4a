//! Loops by the widest vector instructions of the processor.
//!
//! A loop over arrays without branches and calls becomes vector instructions. Each number has the same bits with all
//! instructions, because none of them is fused.

use pulp::{Arch, NullaryFnOnce};

/// Numbers of a vector. Sums of many numbers are made of as many sums side by side.
pub(crate) const LANES: usize = 4;

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

/// `a` if the condition holds, else `b`, without a branch.
#[inline(always)]
pub(crate) fn select(condition: bool, a: f64, b: f64) -> f64 {
    if condition { a } else { b }
}
