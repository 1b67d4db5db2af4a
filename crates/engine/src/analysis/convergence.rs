//! Convergence tests.

use crate::numeric::{dot, norm};

/// Quantity that a test measures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Measure {
    /// Norm of the correction of the displacements.
    DispIncr,
    /// Norm of the unbalanced force.
    Unbalance,
    /// Half the work of the unbalanced force on the correction.
    Energy,
    /// Correction over the first correction of the step.
    RelativeDispIncr,
    /// Unbalance over the unbalance before the first iteration of the step.
    RelativeUnbalance,
    /// Work over the first work of the step.
    RelativeEnergy,
    /// Correction over the sum of the norms of all corrections of the step.
    RelativeTotalDispIncr,
    /// None: a given number of iterations.
    FixedIterations,
    /// Correction and unbalance, both.
    DispAndUnbalance,
    /// Correction or unbalance, either.
    DispOrUnbalance,
}

impl Measure {
    /// Name in the `test` command.
    pub fn name(self) -> &'static str {
        match self {
            Self::DispIncr => "NormDispIncr",
            Self::Unbalance => "NormUnbalance",
            Self::Energy => "EnergyIncr",
            Self::RelativeDispIncr => "RelativeNormDispIncr",
            Self::RelativeUnbalance => "RelativeNormUnbalance",
            Self::RelativeEnergy => "RelativeEnergyIncr",
            Self::RelativeTotalDispIncr => "RelativeTotalNormDispIncr",
            Self::FixedIterations => "FixedNumIter",
            Self::DispAndUnbalance => "NormDispAndUnbalance",
            Self::DispOrUnbalance => "NormDispOrUnbalance",
        }
    }
}

/// Norm of a vector.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Norm {
    /// Largest entry.
    Max,
    /// p-norm; 2 is the Euclidean norm.
    P(u32),
}

impl Norm {
    #[inline]
    fn of(self, v: &[f64]) -> f64 {
        match self {
            Self::Max => v.iter().fold(0.0, |m: f64, x| if x.abs() <= m || m.is_nan() { m } else { x.abs() }),
            Self::P(1) => v.iter().map(|x| x.abs()).sum(),
            Self::P(2) => norm(v),
            Self::P(p) => v.iter().map(|x| x.abs().powi(p as i32)).sum::<f64>().powf(1.0 / f64::from(p)),
        }
    }
}

/// A convergence test and its count.
#[derive(Clone, Debug, PartialEq)]
pub struct Test {
    /// Quantity that it measures.
    pub measure: Measure,
    /// Tolerance.
    pub tolerance: f64,
    /// Tolerance of the unbalance for the tests that have two.
    pub second_tolerance: f64,
    /// Iterations allowed.
    pub max_iterations: usize,
    /// Norm.
    pub norm: Norm,
    /// Go on as if converged when the iterations are used up (print flag 5 of OpenSees).
    pub accept_unconverged: bool,
    /// Number of times that the norm may grow before the step fails; only tests of the unbalance have it.
    pub max_increases: Option<usize>,
    /// A norm beyond this fails the step.
    pub max_norm: f64,
    /// To be passed with a hundredth of the tolerance, where that can be had.
    pub tightened: bool,
    /// Iterations made in this step.
    pub iteration: usize,
    /// Norms of this step, one an iteration.
    pub norms: Vec<f64>,
    keep: bool,
    first: f64,
    total: f64,
    increases: usize,
}

/// Result of a test.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TestOutcome {
    /// Passed.
    Converged,
    /// Not passed yet.
    Continue,
    /// Not passed within the iterations.
    Failed,
}

impl Test {
    /// Norms kept of a step; the last place takes those that come after.
    pub const KEPT: usize = 1000;

    /// A test with the Euclidean norm.
    pub fn new(measure: Measure, tolerance: f64, max_iterations: usize) -> Self {
        Self {
            measure,
            tolerance,
            second_tolerance: tolerance,
            max_iterations,
            norm: Norm::P(2),
            accept_unconverged: false,
            max_increases: None,
            max_norm: f64::MAX,
            tightened: false,
            iteration: 0,
            norms: vec![],
            keep: true,
            first: 0.0,
            total: 0.0,
            increases: 0,
        }
    }

    /// A test of the same kind for a single iteration, which leaves this one as it is. Allocates nothing.
    pub fn probe(&self) -> Self {
        Self { norms: vec![], keep: false, iteration: 0, first: 0.0, total: 0.0, increases: 0, ..*self }
    }

    /// Begin a step, from the unbalance before its first iteration.
    #[inline]
    pub fn start(&mut self, unbalance: &[f64]) {
        self.iteration = 0;
        self.norms.clear();
        self.norms.reserve(self.max_iterations.min(Self::KEPT));
        (self.first, self.total, self.increases) = (0.0, 0.0, 0);
        if self.measure == Measure::RelativeUnbalance {
            self.first = self.norm.of(unbalance);
        }
    }

    /// Norm at the last iteration.
    pub fn last_norm(&self) -> f64 {
        self.norms.last().copied().unwrap_or(f64::NAN)
    }

    /// Returns true if a correction passes whatever the unbalance after it.
    #[inline]
    pub fn accepts(&self, correction: &[f64]) -> bool {
        let alone = matches!(self.measure, Measure::DispIncr | Measure::DispOrUnbalance);
        alone && self.norm.of(correction) <= self.share() * self.tolerance
    }

    /// Returns true if an iteration like one before it is judged like that: no sum over the step counts, nor the number of
    /// iterations.
    pub fn depends_on_last_iteration(&self) -> bool {
        !self.accept_unconverged && !matches!(self.measure, Measure::RelativeTotalDispIncr | Measure::FixedIterations)
    }

    /// Part of the tolerances that is required.
    #[inline]
    fn share(&self) -> f64 {
        if self.tightened { 0.01 } else { 1.0 }
    }

    /// Judge an iteration by its correction and the unbalance after it.
    #[inline]
    pub fn judge(&mut self, correction: &[f64], unbalance: &[f64]) -> TestOutcome {
        let mut norm = match self.measure {
            Measure::DispIncr | Measure::RelativeDispIncr | Measure::RelativeTotalDispIncr => self.norm.of(correction),
            Measure::Unbalance | Measure::RelativeUnbalance => self.norm.of(unbalance),
            Measure::Energy | Measure::RelativeEnergy | Measure::FixedIterations => {
                0.5 * dot(correction, unbalance).abs()
            }
            Measure::DispAndUnbalance | Measure::DispOrUnbalance => self.norm.of(correction),
        };
        self.iteration += 1;
        if self.iteration == 1 && self.measure != Measure::RelativeUnbalance {
            self.first = norm;
        }
        match self.measure {
            Measure::RelativeDispIncr | Measure::RelativeUnbalance | Measure::RelativeEnergy if self.first != 0.0 => {
                norm /= self.first;
            }
            Measure::RelativeTotalDispIncr => {
                self.total += norm;
                if self.total != 0.0 {
                    norm /= self.total;
                }
            }
            _ => {}
        }
        let grown = self.norms.last().is_some_and(|last| *last < norm);
        if self.keep && self.norms.len() < Self::KEPT {
            self.norms.push(norm);
        } else if let Some(last) = self.norms.last_mut() {
            *last = norm;
        }
        self.increases += usize::from(grown);
        let passes = |share: f64| match self.measure {
            Measure::FixedIterations => self.iteration == self.max_iterations,
            Measure::DispAndUnbalance => {
                norm <= share * self.tolerance && self.norm.of(unbalance) <= share * self.second_tolerance
            }
            Measure::DispOrUnbalance => {
                norm <= share * self.tolerance || self.norm.of(unbalance) <= share * self.second_tolerance
            }
            _ => norm <= share * self.tolerance,
        };
        // As close as required, or as close as round-off allows.
        let ends = grown || self.iteration >= self.max_iterations;
        if passes(self.share()) || self.tightened && ends && passes(1.0) {
            return TestOutcome::Converged;
        }
        let too_often = self.max_increases.is_some_and(|m| self.increases >= m);
        if self.iteration >= self.max_iterations || too_often || norm > self.max_norm || norm.is_nan() {
            return if self.accept_unconverged && !norm.is_nan() {
                TestOutcome::Converged
            } else {
                TestOutcome::Failed
            };
        }
        TestOutcome::Continue
    }
}

#[cfg(test)]
mod tests {
    use super::Norm;

    /// A norm passes no test where one of its numbers is none, at whatever place.
    #[test]
    fn a_norm_with_a_nan_is_none() {
        for norm in [Norm::Max, Norm::P(1), Norm::P(2)] {
            for at in 0..3 {
                let mut v = [1.0, -2.0, 0.5];
                v[at] = f64::NAN;
                assert!(norm.of(&v).is_nan(), "{norm:?} {at}");
            }
        }
        assert_eq!(Norm::Max.of(&[1.0, -2.0, 0.5]), 2.0);
    }
}
