//! Observed measures of loops: stiffness, damping and energy of the model's cycles, compared with a published table.

use crate::measure::{CycleDetection, Loop};

/// A measure of one loop of force over deformation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LoopQuantity {
    /// Secant stiffness, see [`Loop::stiffness`].
    SecantStiffness,
    /// Equivalent viscous damping, see [`Loop::damping`].
    Damping,
    /// Dissipated energy, see [`Loop::energy`].
    Energy,
}

impl LoopQuantity {
    /// Words of a study, with what they name.
    const WORDS: [(&str, Self); 3] =
        [("secant_stiffness", Self::SecantStiffness), ("damping", Self::Damping), ("energy", Self::Energy)];

    /// Words of a study.
    pub(super) fn words() -> [&'static str; 3] {
        Self::WORDS.map(|(word, _)| word)
    }

    /// The measure that a word of a study names.
    pub(super) fn from_word(word: &str) -> Option<Self> {
        Self::WORDS.iter().find(|(w, _)| *w == word).map(|(_, quantity)| *quantity)
    }

    /// The measure of a loop.
    pub fn of(self, l: &Loop) -> f64 {
        match self {
            Self::SecantStiffness => l.stiffness(),
            Self::Damping => l.damping(),
            Self::Energy => l.energy,
        }
    }
}

/// The measure of an observed channel: of the loops of its output, a force, over a deformation.
#[derive(Clone, Debug, PartialEq)]
pub struct LoopMeasure {
    /// The measure.
    pub quantity: LoopQuantity,
    /// File of the recorder of the deformation.
    pub output: String,
    /// Column of that file, from 0.
    pub column: usize,
}

impl LoopMeasure {
    /// The measure of the cycles within which `wanted` times fall; NaN after the last row. `times` are those of the rows of
    /// the deformation and the force. A cycle holds the times after its first row up to its last one.
    ///
    /// # Errors
    /// A time that falls into no complete cycle.
    pub(super) fn sample(
        &self,
        times: &[f64],
        deformation: &[f64],
        force: &[f64],
        wanted: &[f64],
    ) -> Result<Vec<f64>, f64> {
        let cycles = CycleDetection::default().cycles(deformation);
        let measured = cycles.iter().filter(|c| c.complete).filter_map(|c| {
            let within = times.get(c.samples.clone())?;
            let l = Loop::of(deformation.get(c.samples.clone())?, force.get(c.samples.clone())?);
            Some((*within.first()?, *within.last()?, self.quantity.of(&l)))
        });
        let measured: Vec<(f64, f64, f64)> = measured.collect();
        let end = times.last().copied().unwrap_or(f64::NEG_INFINITY);
        let of = |t: &f64| match measured.iter().find(|(begin, end, _)| begin < t && t <= end) {
            Some((_, _, value)) => Ok(*value),
            None if *t > end => Ok(f64::NAN),
            None => Err(*t),
        };
        wanted.iter().map(of).collect()
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::{LoopMeasure, LoopQuantity};
    use std::f64::consts::{PI, TAU};

    /// Two cycles of spring 2 and dashpot 0.4 (times the frequency) with the amplitudes 1 and 3, a second each.
    fn ellipses() -> [Vec<f64>; 3] {
        let times: Vec<f64> = (0..=2000).map(|i| f64::from(i) / 1000.0).collect();
        let size = |t: f64| if t < 1.0 { 1.0 } else { 3.0 };
        let u = times.iter().map(|t| size(*t) * (TAU * t).sin()).collect();
        let f = times.iter().map(|t| size(*t) * (2.0 * (TAU * t).sin() + 0.4 * (TAU * t).cos())).collect();
        [times, u, f]
    }

    #[test]
    fn measures_are_those_of_the_cycle_that_holds_a_time() {
        let [times, u, f] = ellipses();
        let of = |quantity, wanted: &[f64]| {
            LoopMeasure { quantity, output: String::new(), column: 1 }.sample(&times, &u, &f, wanted)
        };
        let energy = of(LoopQuantity::Energy, &[0.5, 1.0, 1.5, 2.0, 2.1]).unwrap();
        for (e, amplitude) in energy.iter().zip([1.0f64, 1.0, 3.0, 3.0]) {
            let exact = PI * 0.4 * amplitude.powi(2);
            assert!((e / exact - 1.0).abs() < 0.02, "{e} {exact}");
        }
        assert!(energy[4].is_nan());
        let stiffness = of(LoopQuantity::SecantStiffness, &[0.5, 1.5]).unwrap();
        assert!(stiffness.iter().all(|k| (k / 2.0f64.hypot(0.4) - 1.0).abs() < 0.01), "{stiffness:?}");
        let damping = of(LoopQuantity::Damping, &[0.5, 1.5]).unwrap();
        let exact = 0.4 / (2.0 * 2.0f64.hypot(0.4));
        assert!(damping.iter().all(|h| (h / exact - 1.0).abs() < 0.03), "{damping:?} {exact}");
        assert_eq!(of(LoopQuantity::Damping, &[0.0]), Err(0.0));
    }

    #[test]
    fn a_record_without_cycles_has_no_measure() {
        let measure = LoopMeasure { quantity: LoopQuantity::Energy, output: String::new(), column: 1 };
        assert_eq!(measure.sample(&[0.0, 1.0], &[0.0, 0.0], &[0.0, 1.0], &[0.5]), Err(0.5));
        assert!(measure.sample(&[], &[], &[], &[0.5]).unwrap()[0].is_nan());
    }
}
