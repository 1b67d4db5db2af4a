//! Deformation that a factor of strength withholds from the element.

use super::{Amended, STRENGTH_AT, WITHHELD_AT};
use crate::element::ElementInput;
use crate::element::amendment::{DeformationState, Pair, Weakening};

/// Index of the hysteretic force among the state variables.
const FORCE_AT: usize = STRENGTH_AT + 1;

impl Amended {
    /// Withheld deformation of a trial state.
    ///
    /// A force s z stays while the strength s changes and the device rests: what is elastic does not follow the strength.
    /// Beside (1 - 1/s) of the motion, the element therefore gets as much less deformation as takes z to z s₀/s, where s₀
    /// was the strength before. A force that the strength falls below yields.
    pub(super) fn withheld_by_strength(&self, w: &Weakening, committed: &[f64], motion: &ElementInput<'_>) -> Pair {
        let mut withheld = [0.0; 2];
        let before = committed[STRENGTH_AT];
        // The virgin state has no strength before.
        let part = if before > 0.0 { 1.0 - before / w.strength } else { 0.0 };
        for (i, (row, by)) in self.rows.iter().zip(&mut withheld).enumerate() {
            let moved = row.deformation(motion.disp) - committed[i];
            *by = committed[WITHHELD_AT + i] + w.withheld_part() * moved;
            let hysteretic = self.stiffness[i] - w.stiffness;
            if hysteretic > 0.0 {
                *by += part * committed[FORCE_AT + i] / hysteretic;
            }
        }
        withheld
    }
}

/// Notes the strength and the hysteretic force of a trial state.
pub(super) fn note(w: Option<&Weakening>, d: &DeformationState, withheld: Pair, next: &mut [f64]) {
    next[STRENGTH_AT] = w.map_or(0.0, |w| w.strength);
    let force = |i: usize| w.map_or(0.0, |w| d.q[i] - w.stiffness * (d.e[i] - withheld[i]));
    (0..2).for_each(|i| next[FORCE_AT + i] = force(i));
}
