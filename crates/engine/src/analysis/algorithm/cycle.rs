//! Iterations that go in a circle.

use crate::analysis::system::System;

/// Iterations before the first that is watched: a step that converges soon costs nothing.
const FIRST: usize = 6;
/// Longest circle that is looked for.
const LONGEST: usize = 4;
/// Displacements that differ by less than this part of them are the same.
const SAME: f64 = 1e-13;
/// Displacements of a circle differ by more than this part of them: less may be round-off, out of which a test may be passed.
const APART: f64 = 1e-9;

/// The last trial states of a step, each as one number.
///
/// Newton's method is a function of the trial state. A state that returns after two circles of iterations returns for ever, and no
/// test is passed later that was not passed before.
#[derive(Clone, Debug, Default)]
pub(super) struct Cycle {
    /// Weighted sums of the displacements, the last one first.
    sums: [f64; 3 * LONGEST],
    /// Iterations of the step so far.
    seen: usize,
}

impl Cycle {
    /// Takes the trial state after an iteration; the length of the circle, if there is one.
    pub(super) fn watch(&mut self, system: &System<'_>) -> Option<usize> {
        self.seen += 1;
        if self.seen <= FIRST || system.work.counts_updates() {
            return None;
        }
        // Weights without a pattern, so that two displacements do not make up for each other.
        let (mut sum, mut size) = (system.new.time, system.new.time.abs());
        for (i, u) in system.new.disp.iter().enumerate() {
            let weight = 0.5 + (0.618_033_988_749_895 * i as f64).fract();
            sum += weight * u;
            size += weight * u.abs();
        }
        self.sums.rotate_right(1);
        self.sums[0] = sum;
        let same = |a: f64, b: f64| (a - b).abs() <= SAME * size;
        let apart = (self.sums[0] - self.sums[1]).abs() > APART * size;
        let watched = self.seen - FIRST;
        (2..=LONGEST).find(|&p| apart && watched >= 3 * p && (0..2 * p).all(|i| same(self.sums[i], self.sums[i + p])))
    }
}
