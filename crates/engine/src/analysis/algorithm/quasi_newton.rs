//! Common part of the quasi-Newton methods: the residuals update the matrix of the corrections, which starts anew from a
//! tangent now and then.

use super::{Algorithm, Iteration};
use crate::analysis::convergence::TestOutcome;
use crate::analysis::failure::Failure;
use crate::analysis::system::System;
use crate::analysis::workspace::TangentMix;
use crate::solve::Use;
use std::fmt;

/// Update of a quasi-Newton method.
pub(super) trait Update: Clone + fmt::Debug + Send + 'static {
    /// Name in the `algorithm` command.
    fn name(&self) -> &'static str;
    /// Make room for `pairs` corrections of `n` equations.
    fn reserve(&mut self, pairs: usize, n: usize);
    /// The k-th correction since the tangent: from the corrections `s` before it (the last at k), what the residual lost
    /// by each (`y`), and the residual, into `out`.
    fn correct(&mut self, k: usize, s: &mut System<'_>, past: &Past, out: &mut [f64]) -> Result<(), Failure>;
}

/// Corrections since the last tangent, and what the residual lost by each.
#[derive(Clone, Debug, Default)]
pub(super) struct Past {
    pub(super) s: Vec<Vec<f64>>,
    pub(super) y: Vec<Vec<f64>>,
}

/// A quasi-Newton method.
///
/// As in OpenSees the test's iterations are tangents; the corrections between two tangents have the same test with an
/// own count.
#[derive(Clone, Debug)]
pub(super) struct QuasiNewton<U> {
    update: U,
    mix: TangentMix,
    /// Corrections with one tangent, besides the first.
    count: usize,
    past: Past,
}

impl<U: Update> QuasiNewton<U> {
    pub(super) fn new(update: U, mix: TangentMix, count: usize) -> Self {
        Self { update, mix, count, past: Past::default() }
    }

    /// Correct with the tangent, then learn until the test is passed or the count is used up.
    fn round(&mut self, it: &mut Iteration<'_, '_>) -> Result<(), Failure> {
        let s = &mut *it.system;
        s.form_tangent(self.mix, Use::Often)?;
        self.past.y[0].copy_from_slice(&s.work.b);
        s.solve()?;
        self.past.s[0].copy_from_slice(&s.work.x);
        it.update()?;
        it.system.form_unbalance(false)?;
        let mut probe = it.test.probe();
        probe.max_iterations = self.count;
        for k in 0..self.count {
            let b = &it.system.work.b;
            self.past.y[k].iter_mut().zip(b).for_each(|(y, b)| *y -= b);
            self.past.y[k + 1].copy_from_slice(b);
            let mut x = std::mem::take(&mut it.system.work.x);
            let result = self.update.correct(k, it.system, &self.past, &mut x);
            self.past.s[k + 1].copy_from_slice(&x);
            it.system.work.x = x;
            result?;
            it.update()?;
            it.system.form_unbalance(false)?;
            let n = it.system.work.plan.map.equations;
            if probe.judge(&it.system.work.x[..n], &it.system.work.b[..n]) != TestOutcome::Continue {
                break;
            }
        }
        Ok(())
    }
}

impl<U: Update> Algorithm for QuasiNewton<U> {
    fn name(&self) -> &'static str {
        self.update.name()
    }

    fn prepare(&mut self, s: &System<'_>) {
        let n = s.work.b.len();
        let room = vec![vec![0.0; n]; self.count + 1];
        self.past = Past { s: room.clone(), y: room };
        self.update.reserve(self.count, n);
    }

    fn solve(&mut self, it: &mut Iteration<'_, '_>) -> Result<usize, Failure> {
        it.system.form_unbalance(self.mix.current != 0.0)?;
        it.start_test();
        loop {
            self.round(it)?;
            if let Some(n) = it.judge()? {
                return Ok(n);
            }
        }
    }
}
