//! Evaluation of many points of one law by vector instructions.
//!
//! The histories of the points stand one quantity after the other. A block of points is brought into arrays, over which
//! the law loops.

use super::{MaterialError, Strains, Stress, Stresses, UniaxialLaw};
use crate::numeric::lanes::{BLOCK, Lanes, any, copy_back, flag, in_lanes, load};
use crate::state_struct::StateStruct as _;

/// A block of `W` points of a law with `Q` state variables: one array for each quantity.
#[derive(Clone, Debug)]
pub(crate) struct Block<const Q: usize, const W: usize> {
    /// Trial strains.
    pub(crate) strain: [f64; W],
    /// State variables: those of the committed state before the response, those of the trial state after it.
    pub(crate) words: [[f64; W]; Q],
    /// Stresses.
    pub(crate) value: [f64; W],
    /// Tangents.
    pub(crate) tangent: [f64; W],
}

impl<const Q: usize, const W: usize> Block<Q, W> {
    /// State variables of a point.
    #[inline(always)]
    pub(crate) fn point(&self, i: usize) -> [f64; Q] {
        let mut words = [0.0; Q];
        words.iter_mut().zip(&self.words).for_each(|(word, column)| *word = column[i]);
        words
    }

    /// Sets the state variables of a point.
    #[inline(always)]
    pub(crate) fn set_point(&mut self, i: usize, words: [f64; Q]) {
        for (q, word) in words.into_iter().enumerate() {
            self.words[q][i] = word;
        }
    }

    /// First point whose stress or tangent is not finite.
    #[inline(always)]
    fn not_finite(&self) -> Option<usize> {
        let mut wrong = [0; W];
        for (i, wrong) in wrong.iter_mut().enumerate() {
            *wrong = flag(!(self.value[i].is_finite() & self.tangent[i].is_finite()));
        }
        if any(&wrong) { wrong.iter().position(|w| *w != 0) } else { None }
    }
}

/// A law that is evaluated in blocks. The number of its state variables is `Q`.
pub(crate) trait BlockLaw<const Q: usize>: UniaxialLaw {
    /// Writes trial state, stress and tangent of the points of a block. The method must be inlined.
    fn respond<const W: usize>(&self, block: &mut Block<Q, W>);
}

/// A law without branches at a single point, which is a law of blocks by this alone.
pub(crate) trait PointLaw<const Q: usize>: UniaxialLaw {
    /// Trial state, stress and tangent from the committed state and the trial strain. The method must be inlined.
    fn response(&self, committed: [f64; Q], strain: f64) -> ([f64; Q], f64, f64);

    /// [`UniaxialLaw::update`] of such a law.
    fn respond_to(&self, committed: &Self::State, strain: f64) -> (Stress, Self::State) {
        let mut words = [0.0; Q];
        committed.write(&mut words);
        let (next, value, tangent) = self.response(words, strain);
        (Stress { value, tangent, damping: 0.0 }, Self::State::read(&next))
    }
}

impl<L: PointLaw<Q>, const Q: usize> BlockLaw<Q> for L {
    #[inline(always)]
    fn respond<const W: usize>(&self, block: &mut Block<Q, W>) {
        // A copy, so that the optimiser knows that no point of the block changes the law.
        let law = self.clone();
        for i in 0..W {
            let (next, value, tangent) = law.response(block.point(i), block.strain[i]);
            block.set_point(i, next);
            (block.value[i], block.tangent[i]) = (value, tangent);
        }
    }
}

/// Points that are evaluated in blocks.
struct Points<'a, L, const Q: usize> {
    law: &'a L,
    committed: &'a [f64],
    strain: &'a [f64],
    next: &'a mut [f64],
    value: &'a mut [f64],
    tangent: &'a mut [f64],
    /// First point without a stress.
    failed: Option<usize>,
}

impl<L: BlockLaw<Q>, const Q: usize> Points<'_, L, Q> {
    /// Evaluates up to `W` points.
    #[inline(always)]
    fn block<const W: usize>(&mut self, start: usize) {
        let n = self.strain.len();
        let end = n.min(start + W);
        let zeros = [0.0; W];
        let mut block =
            Block { strain: load(&self.strain[start..end]), words: [zeros; Q], value: zeros, tangent: zeros };
        for (q, column) in block.words.iter_mut().enumerate() {
            *column = load(&self.committed[q * n + start..q * n + end]);
        }
        self.law.respond(&mut block);
        for (q, column) in block.words.iter().enumerate() {
            copy_back(column, &mut self.next[q * n + start..q * n + end]);
        }
        copy_back(&block.value, &mut self.value[start..end]);
        copy_back(&block.tangent, &mut self.tangent[start..end]);
        if let Some(i) = block.not_finite().filter(|i| start + i < end) {
            self.failed = self.failed.or(Some(start + i));
        }
    }
}

impl<L: BlockLaw<Q>, const Q: usize> Lanes for Points<'_, L, Q> {
    #[inline(always)]
    fn evaluate(&mut self) {
        const DOUBLE: usize = 2 * BLOCK;
        let n = self.strain.len();
        let mut start = 0;
        while n > start + BLOCK {
            self.block::<DOUBLE>(start);
            start += DOUBLE;
        }
        if start < n {
            self.block::<BLOCK>(start);
        }
    }
}

/// Evaluates points in blocks, as [`UniaxialLaw::update_points`] does.
///
/// # Errors
/// A stress or a tangent is not finite.
pub(crate) fn update_blocks<L: BlockLaw<Q>, const Q: usize>(
    law: &L,
    committed: &[f64],
    strains: &Strains<'_>,
    next: &mut [f64],
    stresses: &mut Stresses<'_>,
) -> Result<(), MaterialError> {
    let n = strains.value.len();
    let mut points = Points {
        law,
        committed,
        strain: strains.value,
        next,
        value: &mut stresses.value[..n],
        tangent: &mut stresses.tangent[..n],
        failed: None,
    };
    in_lanes(&mut points);
    let failed = points.failed;
    stresses.damping[..n].fill(0.0);
    failed.map_or(Ok(()), |i| Err(no_stress::<L>(strains.value[i])))
}

/// Error of a stress or a tangent that is not finite.
#[cold]
pub(crate) fn no_stress<L: UniaxialLaw>(strain: f64) -> MaterialError {
    MaterialError(format!("{} has no stress at a strain of {strain:.6e}", L::NAME))
}
