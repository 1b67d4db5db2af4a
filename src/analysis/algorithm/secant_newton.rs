//! Modified Newton accelerated by secants.

use super::{Algorithm, Iteration};
use crate::analysis::failure::Failure;
use crate::analysis::prepared::TangentMix;
use crate::analysis::system::System;
use crate::numeric::dot;
use crate::solve::Use;

/// `algorithm SecantNewton` (Crisfield, 1979 and 1991): each correction of modified Newton is scaled, and parts of the
/// last correction and residual are added, such that a secant through the last two points holds. With no terms it is
/// `PeriodicNewton`: modified Newton with a new tangent now and then.
#[derive(Debug)]
pub struct SecantNewton {
    /// Tangent of the first iteration of a step.
    increment: TangentMix,
    /// New tangent after `period` iterations; `None` keeps the one there is.
    iterate: Option<TangentMix>,
    period: usize,
    /// Terms of the acceleration, 0 to 3.
    terms: usize,
    /// Corrections are left as they are where the factors would be beyond these.
    cut_out: Option<(f64, f64)>,
    /// Last correction, accelerated and not.
    last: [Vec<f64>; 2],
    /// Last residual.
    residual: Vec<f64>,
    once: bool,
    factored: bool,
}

impl SecantNewton {
    /// With the tangents of a step's first iteration and of later ones, the iterations between those, the number of
    /// terms and the limits of the factors.
    pub fn new(
        increment: TangentMix,
        iterate: Option<TangentMix>,
        period: usize,
        terms: usize,
        cut_out: Option<(f64, f64)>,
    ) -> Self {
        Self {
            increment,
            iterate,
            period,
            terms,
            cut_out,
            last: [vec![], vec![]],
            residual: vec![],
            once: false,
            factored: false,
        }
    }

    /// Keep the first tangent for all steps.
    pub fn factor_once(mut self) -> Self {
        self.once = true;
        self
    }

    /// Accelerate the correction `x` for the residual `r`; `k` iterations since the tangent.
    fn accelerate(&mut self, k: usize, x: &mut [f64], r: &[f64]) {
        let [last, raw] = &mut self.last;
        if k == 0 || self.terms == 0 {
            raw.copy_from_slice(x);
        } else {
            // γ and α, the changes of the residual and of the plain correction, take the places of the last ones.
            self.residual.iter_mut().zip(r).for_each(|(g, r)| *g = r - *g);
            raw.iter_mut().zip(x.iter()).for_each(|(a, x)| *a = x - *a);
            let (gamma, alpha) = (&self.residual, &mut *raw);
            let along = dot(last, gamma);
            let per = if along == 0.0 { 0.0 } else { 1.0 / along };
            let c = dot(last, r) * per;
            let a = 1.0 - c;
            let d = -c - a * dot(x, gamma) * per;
            let good = self.cut_out.is_none_or(|(r1, r2)| {
                let ratio = if self.terms == 1 { 0.0 } else { d / a };
                (1.0 / r1..=r1).contains(&a) && (-0.5 * r2..=r2).contains(&ratio)
            });
            // Leaves the plain correction in the place of α.
            let b = -c - (dot(alpha, r) - c * dot(alpha, gamma)) * per;
            for ((x, p), last) in x.iter_mut().zip(alpha.iter_mut()).zip(last.iter()) {
                let plain = *x;
                if good {
                    *x = match self.terms {
                        1 => a * plain,
                        2 => a * plain + d * last,
                        _ => a * plain + b * last + c * *p,
                    };
                }
                *p = plain;
            }
        }
        self.residual.copy_from_slice(r);
        last.copy_from_slice(x);
    }
}

impl Algorithm for SecantNewton {
    fn name(&self) -> &'static str {
        if self.terms == 0 { "PeriodicNewton" } else { "SecantNewton" }
    }

    fn prepare(&mut self, s: &System<'_>) {
        let n = s.work.b.len();
        self.last.iter_mut().chain([&mut self.residual]).for_each(|v| v.resize(n, 0.0));
        self.factored = false;
    }

    fn solve(&mut self, it: &mut Iteration<'_, '_>) -> Result<usize, Failure> {
        it.system.form_unbalance(self.increment.current != 0.0 && !self.factored)?;
        if !self.factored {
            it.system.form_tangent(self.increment, Use::Often)?;
        }
        self.factored = false;
        it.start_test();
        let mut k = 0;
        loop {
            it.system.solve()?;
            let work = &mut *it.system.work;
            let mut x = std::mem::take(&mut work.x);
            self.accelerate(k, &mut x, &work.b);
            work.x = x;
            it.update()?;
            it.system.form_unbalance(false)?;
            if let Some(n) = it.judge()? {
                self.factored = self.once;
                return Ok(n);
            }
            k += 1;
            if k > self.period {
                k = 0;
                if let Some(mix) = self.iterate {
                    it.system.form_tangent(mix, Use::Often)?;
                }
            }
        }
    }
}
