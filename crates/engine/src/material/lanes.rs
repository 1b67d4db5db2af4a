//! Evaluation of many points of one law by vector instructions.
//!
//! A law brings what it needs of a block of points into arrays. A loop over the block without branches and calls becomes
//! vector instructions. Each number has the same bits with all instructions, because none of them is fused.

use pulp::{Arch, NullaryFnOnce};

/// Numbers that the widest instructions take. The number of points of a loop is a multiple of it.
pub(crate) const LANES: usize = 4;
/// Points of a block.
pub(crate) const BLOCK: usize = 16;

/// Arrays over the points of a block, with a loop over them.
pub(crate) trait Lanes {
    /// The loop. The method must be inlined, or it is not compiled for the instructions of the processor.
    fn evaluate(&mut self);
}

/// Evaluates a loop with the widest vector instructions of the processor.
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
