//! Recovery from steps that fail. It is off by default, since a script's own fallback must see the failure first.

use super::algorithm::TangentChoice;
use super::algorithm::{
    Algorithm, LineSearch, ModifiedNewton, Newton, NewtonLineSearch, SearchKind, Tangents, krylov_newton,
};
use super::engine::{Engine, Kind, Observer};
use super::failure::Failure;
use super::workspace::TangentMix;

/// One method to solve a step that has failed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RecoveryStep {
    /// Newton's method.
    Newton,
    /// Newton's method with a line search.
    LineSearch,
    /// Accelerated modified Newton.
    Krylov,
    /// Modified Newton from the initial tangent.
    Initial,
    /// The step in 2, 4, ... parts, up to 2 to this power; transient analyses only.
    Halve(u32),
}

impl RecoveryStep {
    fn algorithm(self) -> Option<Box<dyn Algorithm>> {
        let current = TangentChoice::Always(TangentMix::CURRENT);
        Some(match self {
            Self::Newton => Box::new(Newton::new(current)),
            Self::LineSearch => Box::new(NewtonLineSearch::new(LineSearch::new(SearchKind::RegulaFalsi), current)),
            Self::Krylov => krylov_newton(Tangents {
                increment: TangentMix::CURRENT,
                iterate: Some(TangentMix::CURRENT),
                period: 10,
                once: false,
            }),
            Self::Initial => Box::new(ModifiedNewton::new(TangentMix::INITIAL, false)),
            Self::Halve(_) => return None,
        })
    }
}

/// Methods in the order in which they are tried. The first that solves the step ends the recovery, and the next step starts
/// with the script's own algorithm again.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RecoveryStrategy {
    /// The methods.
    pub methods: Vec<RecoveryStep>,
    /// Number of steps that each has recovered.
    pub helped: Vec<usize>,
}

impl RecoveryStrategy {
    /// From the methods.
    pub fn new(methods: Vec<RecoveryStep>) -> Self {
        Self { helped: vec![0; methods.len()], methods }
    }
}

impl Default for RecoveryStrategy {
    fn default() -> Self {
        Self::new(vec![
            RecoveryStep::Newton,
            RecoveryStep::LineSearch,
            RecoveryStep::Krylov,
            RecoveryStep::Initial,
            RecoveryStep::Halve(4),
        ])
    }
}

impl Engine {
    /// Try the methods on a step that has failed.
    pub(super) fn recover(&mut self, length: f64, first: Failure, observer: &mut dyn Observer) -> Result<(), Failure> {
        let methods = self.options.ladder.as_ref().map(|l| l.methods.clone()).unwrap_or_default();
        for (i, method) in methods.into_iter().enumerate() {
            if observer.interrupted() {
                break;
            }
            let done = match method {
                RecoveryStep::Halve(times) => self.halve(length, times),
                other => self.with_algorithm(other, length),
            };
            if done {
                if let Some(l) = &mut self.options.ladder {
                    l.helped[i] += 1;
                }
                return Ok(());
            }
        }
        Err(first)
    }

    fn with_algorithm(&mut self, method: RecoveryStep, length: f64) -> bool {
        let Some(mut algorithm) = method.algorithm() else { return false };
        let swap = |engine: &mut Self, other: &mut Box<dyn Algorithm>| {
            engine.change_setup(|s| std::mem::swap(&mut s.algorithm, other));
        };
        swap(self, &mut algorithm);
        let done = self.step_in_parts(length).is_ok();
        swap(self, &mut algorithm);
        done
    }

    /// The step in 2, 4, ... parts. Where the parts cannot all be made nothing is committed.
    fn halve(&mut self, dt: f64, times: u32) -> bool {
        if self.setup().is_none_or(|s| s.kind == Kind::Static) {
            return false;
        }
        (1..=times).any(|power| self.in_parts(dt, 1 << power).is_ok())
    }
}
