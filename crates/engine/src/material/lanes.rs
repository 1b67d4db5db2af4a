//! Evaluation of many points of one law by vector instructions.
//!
//! The histories of the points stand one quantity after the other. A block of points is brought into arrays, over which
//! the law loops.

use super::{MaterialError, MaterialResult, Strain, Strains, Stress, Stresses, UniaxialLaw};
use crate::numeric::lanes::{BLOCK, Lanes, copy_back, in_lanes, load};
use crate::state_struct::StateStruct;

/// Committed history and strains of `W` points of a law with `Q` state variables: one array for each quantity.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LaneInput<'a, const Q: usize, const W: usize> {
    /// Trial strains.
    pub(crate) strain: &'a [f64; W],
    /// State variables of the committed state.
    pub(crate) words: [&'a [f64; W]; Q],
}

/// Response of the same points. The arrays are apart from those of the committed state: where a law wrote over what it
/// reads, the compiler would store single lanes by a mask, which some processors do slowly.
#[derive(Clone, Debug)]
pub(crate) struct Response<const Q: usize, const W: usize> {
    /// State variables of the trial state.
    pub(crate) words: [[f64; W]; Q],
    /// Stresses.
    pub(crate) value: [f64; W],
    /// Tangents.
    pub(crate) tangent: [f64; W],
}

impl<const Q: usize, const W: usize> LaneInput<'_, Q, W> {
    /// State variables of a point.
    #[inline(always)]
    pub(crate) fn point(&self, i: usize) -> [f64; Q] {
        let mut words = [0.0; Q];
        words.iter_mut().zip(&self.words).for_each(|(word, column)| *word = column[i]);
        words
    }
}

impl<const Q: usize, const W: usize> Response<Q, W> {
    #[inline(always)]
    fn zeros() -> Self {
        Self { words: [[0.0; W]; Q], value: [0.0; W], tangent: [0.0; W] }
    }

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

    /// Sets the response of a point.
    #[inline(always)]
    pub(crate) fn set(&mut self, i: usize, point: PointResponse<Q>) {
        self.set_point(i, point.words);
        (self.value[i], self.tangent[i]) = (point.value, point.tangent);
    }

    /// Bits that are all zero if stresses and tangents are finite: a number less itself is +0, infinities are no number then.
    #[inline(always)]
    #[allow(clippy::eq_op)]
    fn not_finite(&self) -> u64 {
        let mut wrong = 0;
        for (value, tangent) in self.value.iter().zip(&self.tangent) {
            wrong |= ((value - value) + (tangent - tangent)).to_bits();
        }
        wrong
    }
}

/// Response of one point with Q state variables.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PointResponse<const Q: usize> {
    /// State variables of the trial state.
    pub(crate) words: [f64; Q],
    /// Stress.
    pub(crate) value: f64,
    /// Tangent.
    pub(crate) tangent: f64,
}

impl<const Q: usize> PointResponse<Q> {
    /// The stress and the history.
    #[inline(always)]
    pub(crate) fn read<S: StateStruct>(&self) -> (Stress, S) {
        (Stress { value: self.value, tangent: self.tangent, damping: 0.0 }, S::read(&self.words))
    }
}

/// State variables of a history.
#[inline(always)]
pub(crate) fn words_of<S: StateStruct, const Q: usize>(history: &S) -> [f64; Q] {
    let mut words = [0.0; Q];
    history.write(&mut words);
    words
}

/// A law that is evaluated in blocks. The number of its state variables is `Q`.
pub(crate) trait BlockLaw<const Q: usize>: UniaxialLaw {
    /// Writes trial state, stress and tangent of the points of a block. The method must be inlined.
    fn respond<const W: usize>(&self, given: &LaneInput<'_, Q, W>, out: &mut Response<Q, W>);
}

/// A law without branches at a single point, which is a law of blocks by this alone.
pub(crate) trait PointLaw<const Q: usize>: UniaxialLaw {
    /// Response from the committed state and the trial strain. The method must be inlined.
    fn response(&self, committed: [f64; Q], strain: f64) -> PointResponse<Q>;

    /// [`UniaxialLaw::update`] of such a law.
    fn respond_to(&self, committed: &Self::State, strain: f64) -> (Stress, Self::State) {
        self.response(words_of(committed), strain).read()
    }
}

impl<L: PointLaw<Q>, const Q: usize> BlockLaw<Q> for L {
    #[inline(always)]
    fn respond<const W: usize>(&self, given: &LaneInput<'_, Q, W>, out: &mut Response<Q, W>) {
        // A copy, so that the optimiser knows that no point of the block changes the law.
        let law = self.clone();
        for i in 0..W {
            out.set(i, law.response(given.point(i), given.strain[i]));
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
    /// Bits that are all zero as long as all is finite.
    wrong: u64,
}

impl<L: BlockLaw<Q>, const Q: usize> Points<'_, L, Q> {
    /// Evaluates `W` points from `start`, or those that are left, by way of `out`.
    #[inline(always)]
    fn block<const W: usize>(&mut self, start: usize, out: &mut Response<Q, W>) {
        let n = self.strain.len();
        let end = n.min(start + W);
        let is_whole = end - start == W;
        // Whole blocks are read where they are, others from copies with zeros behind them.
        let (strain, mut words);
        let mut given = LaneInput { strain: &[0.0; W], words: [&[0.0; W]; Q] };
        if is_whole {
            if let Some(strain) = self.strain[start..].first_chunk() {
                given.strain = strain;
            }
            for (column, all) in given.words.iter_mut().zip(self.committed.chunks_exact(n)) {
                if let Some(own) = all[start..].first_chunk() {
                    *column = own;
                }
            }
        } else {
            strain = load(&self.strain[start..end]);
            words = [[0.0; W]; Q];
            for (column, all) in words.iter_mut().zip(self.committed.chunks_exact(n)) {
                *column = load(&all[start..end]);
            }
            given.strain = &strain;
            given.words.iter_mut().zip(&words).for_each(|(column, own)| *column = own);
        }
        self.law.respond(&given, out);
        self.wrong |= out.not_finite();
        for (column, all) in out.words.iter().zip(self.next.chunks_exact_mut(n)) {
            copy_back(column, &mut all[start..end]);
        }
        copy_back(&out.value, &mut self.value[start..end]);
        copy_back(&out.tangent, &mut self.tangent[start..end]);
    }
}

impl<L: BlockLaw<Q>, const Q: usize> Lanes for Points<'_, L, Q> {
    #[inline(always)]
    fn evaluate(&mut self) {
        const DOUBLE: usize = 2 * BLOCK;
        let n = self.strain.len();
        let mut start = 0;
        if n > BLOCK {
            let mut out = Response::<Q, DOUBLE>::zeros();
            while n > start + BLOCK {
                self.block(start, &mut out);
                start += DOUBLE;
            }
        }
        if start < n {
            self.block(start, &mut Response::<Q, BLOCK>::zeros());
        }
    }
}

/// Writes [`UniaxialLaw::update_points`] of a law that is evaluated in blocks.
macro_rules! updates_blocks {
    () => {
        fn update_points(
            &self,
            committed: &[f64],
            strains: &$crate::material::Strains<'_>,
            next: &mut [f64],
            stresses: &mut $crate::material::Stresses<'_>,
        ) -> $crate::material::MaterialResult {
            $crate::material::lanes::update_blocks(self, committed, strains, next, stresses)
        }
    };
}
pub(crate) use updates_blocks;

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
) -> MaterialResult {
    let n = strains.value.len();
    if let ([value], [rate]) = (strains.value, strains.rate) {
        // A single point, whose layout is that of one.
        let strain = Strain { value: *value, rate: *rate, dt: strains.dt };
        let (s, state) = UniaxialLaw::update(law, &L::State::read(committed), strain)?;
        if !(s.value.is_finite() && s.tangent.is_finite()) {
            return Err(no_stress::<L>(*value));
        }
        state.write(next);
        (stresses.value[0], stresses.tangent[0], stresses.damping[0]) = (s.value, s.tangent, s.damping);
        return Ok(());
    }
    let mut points = Points {
        law,
        committed,
        strain: strains.value,
        next,
        value: &mut stresses.value[..n],
        tangent: &mut stresses.tangent[..n],
        wrong: 0,
    };
    in_lanes(&mut points);
    let wrong = points.wrong;
    stresses.damping[..n].fill(0.0);
    if wrong == 0 {
        return Ok(());
    }
    let finite = stresses.value.iter().zip(&*stresses.tangent).map(|(s, k)| s.is_finite() && k.is_finite());
    let failed = finite.take(n).position(|finite| !finite);
    failed.map_or(Ok(()), |i| Err(no_stress::<L>(strains.value[i])))
}

/// Error of a stress or a tangent that is not finite.
#[cold]
pub(crate) fn no_stress<L: UniaxialLaw>(strain: f64) -> MaterialError {
    MaterialError(format!("{} has no stress at a strain of {strain:.6e}", L::NAME))
}
