//! Common part of the accelerated methods: modified Newton with corrections that are improved by the last residuals, and
//! with a new tangent now and then.

use super::{Algorithm, Iteration};
use crate::analysis::failure::Failure;
use crate::analysis::system::System;
use crate::analysis::workspace::TangentMix;
use crate::solve::Use;
use std::fmt;

/// Rule that accelerates corrections.
pub(super) trait Accelerator: Clone + fmt::Debug + Send + 'static {
    /// Name in the `algorithm` command.
    fn name(&self) -> &'static str;
    /// Make room for `n` equations and as many corrections with one tangent as are wanted; how many there is room for.
    fn prepare(&mut self, n: usize, wanted: usize) -> usize;
    /// Better the k-th correction since the tangent, `x`, which the residual called for.
    fn accelerate(&mut self, k: usize, x: &mut [f64], residual: &[f64]);
    /// Returns true if a new tangent is due after `corrections` of the step, `since` of them with the present tangent.
    fn is_due(&self, _corrections: usize, since: usize, period: usize) -> bool {
        since > period
    }
    /// Returns true if the acceleration starts anew where a new tangent is due, although the present one is kept.
    fn restarts_without_tangent(&self) -> bool {
        true
    }
    /// Returns true if the test of a transient analysis sees the correction before its acceleration.
    fn hides_from_test(&self) -> bool {
        false
    }
}

/// An accelerated Newton method.
#[derive(Clone, Debug)]
pub(super) struct Accelerated<A> {
    accelerator: A,
    tangents: Tangents,
    /// Corrections with one tangent, besides the first, that there is room for.
    period: usize,
    /// A correction before it is accelerated.
    plain: Vec<f64>,
    factored: bool,
}

/// The tangents of an accelerated method.
#[derive(Clone, Copy, Debug)]
pub struct Tangents {
    /// Of the first iteration of a step.
    pub increment: TangentMix,
    /// After `period` more corrections; `None` keeps the one there is.
    pub iterate: Option<TangentMix>,
    /// Corrections with one tangent, besides the first.
    pub period: usize,
    /// The first tangent serves all steps.
    pub once: bool,
}

impl<A: Accelerator> Accelerated<A> {
    pub(super) fn new(accelerator: A, tangents: Tangents) -> Self {
        Self { accelerator, tangents, period: tangents.period, plain: vec![], factored: false }
    }
}

impl<A: Accelerator> Algorithm for Accelerated<A> {
    fn name(&self) -> &'static str {
        self.accelerator.name()
    }

    fn prepare(&mut self, s: &System<'_>) {
        let n = s.work.b.len();
        self.plain.resize(n, 0.0);
        self.period = self.accelerator.prepare(n, self.tangents.period);
        self.factored = false;
    }

    fn solve(&mut self, it: &mut Iteration<'_, '_>) -> Result<usize, Failure> {
        let Tangents { increment, iterate, once, .. } = self.tangents;
        it.system.form_unbalance(increment.current != 0.0 && !self.factored)?;
        if !self.factored {
            it.system.form_tangent(increment, Use::Often)?;
        }
        self.factored = false;
        it.start_test();
        let hides = self.accelerator.hides_from_test() && !it.integrator.is_static();
        let mut k = 0;
        for corrections in 1.. {
            it.system.solve()?;
            let work = &mut *it.system.work;
            self.plain.copy_from_slice(&work.x);
            self.accelerator.accelerate(k, &mut work.x, &work.b);
            it.update()?;
            if hides {
                it.system.work.x.copy_from_slice(&self.plain);
            }
            k += 1;
            let due = self.accelerator.is_due(corrections, k, self.period);
            it.system.form_unbalance(due && iterate.is_some_and(|m| m.current != 0.0))?;
            if let Some(n) = it.judge()? {
                self.factored = once;
                return Ok(n);
            }
            if due {
                if let Some(mix) = iterate {
                    it.system.form_tangent(mix, Use::Often)?;
                }
                if iterate.is_some() || self.accelerator.restarts_without_tangent() {
                    k = 0;
                }
            }
        }
        unreachable!("the test ends the iterations")
    }
}
