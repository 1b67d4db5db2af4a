//! Axial springs in parallel.

use super::{AxialSpring, Branch, History, Rules};
use crate::material::roles::{LastTrial, PointLayout, UniaxialRoles, VirginPoints};
use crate::material::{MaterialResult, Strain, Strains, Stress, Stresses, Uniaxial, UniaxialTraits};
use crate::state_struct::{Field, StateStruct};

/// History of spring `i` of `n`. A bundle stores one quantity after the other, so that the test for all-elastic
/// springs is fast.
#[inline]
fn read(words: &[f64], i: usize, n: usize) -> History {
    let (u, slope, from) = (words[i], words[i + 2 * n], words[i + 3 * n]);
    History { u, branch: Branch::get(words, &mut (i + n)), slope, from }
}

#[inline]
fn write(t: &History, words: &mut [f64], i: usize, n: usize) {
    t.branch.put(words, &mut (i + n));
    (words[i], words[i + 2 * n], words[i + 3 * n]) = (t.u, t.slope, t.from);
}

impl<const HD: bool, R: Rules> Uniaxial for AxialSpring<HD, R> {
    fn name(&self) -> &'static str {
        if HD { "AxialSpHD" } else { "AxialSp" }
    }
    fn state_len(&self) -> usize {
        <History as StateStruct>::LEN
    }
    fn init(&self, state: &mut [f64]) {
        self.init_all(1, state);
    }
    fn update(&self, committed: &[f64], strain: Strain, next: &mut [f64]) -> MaterialResult<Stress> {
        let (stress, t) = self.step(&read(committed, 0, 1), strain.value);
        write(&t, next, 0, 1);
        Ok(stress)
    }

    fn update_all(
        &self,
        committed: &[f64],
        strains: &Strains<'_>,
        next: &mut [f64],
        stresses: &mut Stresses<'_>,
    ) -> MaterialResult {
        let n = strains.value.len();
        for (i, &u) in strains.value.iter().enumerate() {
            let (stress, t) = self.step(&read(committed, i, n), u);
            write(&t, next, i, n);
            (stresses.value[i], stresses.tangent[i], stresses.damping[i]) = (stress.value, stress.tangent, 0.0);
        }
        Ok(())
    }

    fn initial_tangent(&self) -> f64 {
        self.sce
    }
    fn traits(&self) -> UniaxialTraits {
        UniaxialTraits::default()
    }
    fn roles(&self) -> UniaxialRoles<'_> {
        let last_trial = R::FOLLOWS_TRIALS.then_some(self as &dyn LastTrial);
        UniaxialRoles { layout: Some(self), last_trial, virgin: Some(self), ..UniaxialRoles::default() }
    }
}

impl<const HD: bool, R: Rules> PointLayout for AxialSpring<HD, R> {
    fn init_all(&self, n: usize, state: &mut [f64]) {
        (0..n).for_each(|i| write(&History::default(), state, i, n));
    }
    fn block_len(&self) -> usize {
        1
    }
    fn copy_history(&self, (from, i, n): (&[f64], usize, usize), (to, j, m): (&mut [f64], usize, usize)) {
        write(&read(from, i, n), to, j, m);
    }
}

impl<const HD: bool, R: Rules> LastTrial for AxialSpring<HD, R> {
    fn update_all_on(
        &self,
        committed: &[f64],
        before: &[f64],
        strains: &Strains<'_>,
        next: &mut [f64],
        stresses: &mut Stresses<'_>,
    ) -> MaterialResult {
        let n = strains.value.len();
        for (i, (&u, &before)) in strains.value.iter().zip(before).enumerate() {
            let c = History { u: before, ..read(committed, i, n) };
            let (stress, t) = self.step_on(&c, &read(next, i, n), u);
            write(&t, next, i, n);
            (stresses.value[i], stresses.tangent[i], stresses.damping[i]) = (stress.value, stress.tangent, 0.0);
        }
        Ok(())
    }
}

impl<const HD: bool, R: Rules> VirginPoints for AxialSpring<HD, R> {
    fn virgin_tangent(&self, [low, high]: [f64; 2]) -> Option<f64> {
        let elastic = self.ucy <= low && high <= self.uty;
        match () {
            () if !elastic => None,
            () if high <= 0.0 => Some(self.sce),
            () if low > 0.0 || self.sce == self.ste => Some(self.ste),
            () => None,
        }
    }

    /// An elastic spring has no history.
    fn are_virgin(&self, state: &[f64]) -> bool {
        let n = state.len() / <History as StateStruct>::LEN;
        // The bitwise OR of all branches vectorizes, and the elastic branch is zero.
        state[n..2 * n].iter().fold(0, |any, b| any | b.to_bits()) == 0
    }
}
