//! Broyden's method.

use super::Algorithm;
use super::quasi_newton::{Past, QuasiNewton, Update};
use crate::analysis::failure::Failure;
use crate::analysis::system::System;
use crate::analysis::workspace::TangentMix;
use crate::numeric::{axpy, dot};

/// `algorithm Broyden` (Broyden, 1965, the first method): the smallest change of the inverse of the tangent that agrees with
/// the last correction. The inverse need not be symmetric.
#[derive(Clone, Debug, Default)]
struct Broyden {
    /// H₊ v = H v + u (s · H v), one u for each correction.
    u: Vec<Vec<f64>>,
}

/// The algorithm; a new tangent after `count` corrections.
pub fn broyden(mix: TangentMix, count: usize) -> Box<dyn Algorithm> {
    Box::new(QuasiNewton::new(Broyden::default(), mix, count))
}

impl Broyden {
    /// H v with the first `k` updates, in place.
    fn apply(&self, k: usize, system: &mut System<'_>, past: &Past, v: &mut [f64]) -> Result<(), Failure> {
        system.solve_for(v)?;
        for (u, s) in self.u[..k].iter().zip(&past.s) {
            axpy(dot(s, v), u, v);
        }
        Ok(())
    }
}

impl Update for Broyden {
    fn name(&self) -> &'static str {
        "Broyden"
    }

    fn reserve(&mut self, pairs: usize, n: usize) {
        self.u = vec![vec![0.0; n]; pairs];
    }

    fn correct(&mut self, k: usize, system: &mut System<'_>, past: &Past, out: &mut [f64]) -> Result<(), Failure> {
        let (s, y) = (&past.s[k], &past.y[k]);
        out.copy_from_slice(y);
        self.apply(k, system, past, out)?;
        let along = dot(s, out);
        let factor = if along == 0.0 { 0.0 } else { 1.0 / along };
        for (u, (s, hy)) in self.u[k].iter_mut().zip(s.iter().zip(out.iter())) {
            *u = factor * (s - hy);
        }
        out.copy_from_slice(&system.work.b);
        self.apply(k + 1, system, past, out)
    }
}
