//! Modified Newton accelerated by secants.

use super::Algorithm;
use super::accelerated::{Accelerated, Accelerator, Tangents};
use crate::analysis::workspace::TangentMix;
use crate::numeric::dot;

/// `algorithm SecantNewton` (Crisfield, 1979 and 1991): each correction of modified Newton is scaled, and parts of the
/// last correction and residual are added, such that a secant through the last two points holds. With no terms it is
/// `PeriodicNewton`: modified Newton with a new tangent now and then.
///
/// `terms` of the acceleration, 0 to 3; corrections are left as they are where the factors would be beyond `cut_out`.
pub fn secant_newton(tangents: Tangents, terms: usize, cut_out: Option<(f64, f64)>) -> Box<dyn Algorithm> {
    let renews = tangents.iterate == Some(TangentMix::CURRENT);
    let secant = Secant { terms, renews, cut_out, last: [vec![], vec![]], residual: vec![] };
    Box::new(Accelerated::new(secant, tangents))
}

#[derive(Clone, Debug)]
struct Secant {
    terms: usize,
    /// The current tangent is formed anew within a step.
    renews: bool,
    cut_out: Option<(f64, f64)>,
    /// Last correction, accelerated and not.
    last: [Vec<f64>; 2],
    /// Last residual.
    residual: Vec<f64>,
}

impl Accelerator for Secant {
    fn name(&self) -> &'static str {
        if self.terms == 0 { "PeriodicNewton" } else { "SecantNewton" }
    }

    /// As in OpenSees, where the first tangent of `PeriodicNewton` serves one correction.
    fn is_due(&self, corrections: usize, since: usize, period: usize) -> bool {
        match self.terms {
            0 => since >= period || (self.renews && corrections == 1),
            1 => since > period,
            _ => since >= period,
        }
    }

    fn restarts_without_tangent(&self) -> bool {
        self.terms == 1
    }

    fn prepare(&mut self, n: usize, wanted: usize) -> usize {
        self.last.iter_mut().chain([&mut self.residual]).for_each(|v| v.resize(n, 0.0));
        wanted
    }

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
