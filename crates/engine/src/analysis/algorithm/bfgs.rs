//! The method of Broyden, Fletcher, Goldfarb and Shanno.

use super::Algorithm;
use super::quasi_newton::{Past, QuasiNewton, Update};
use crate::analysis::failure::Failure;
use crate::analysis::system::System;
use crate::analysis::workspace::TangentMix;
use crate::numeric::{axpy, dot, norm};

/// `algorithm BFGS` (Matthies and Strang, 1979): the inverse of the tangent stays symmetric. The updates are carried out
/// from the corrections and residuals, without a matrix (Nocedal, 1980).
#[derive(Clone, Debug, Default)]
struct Bfgs {
    shares: Vec<f64>,
}

/// The algorithm; a new tangent after `count` corrections.
pub fn bfgs(mix: TangentMix, count: usize) -> Box<dyn Algorithm> {
    Box::new(QuasiNewton::new(Bfgs::default(), mix, count))
}

/// One over s·y; zero where the two are at a right angle, or nothing has moved.
fn inverse(s: &[f64], y: &[f64]) -> f64 {
    let product = dot(s, y);
    if product.abs() <= 1e-14 * norm(s) * norm(y) { 0.0 } else { 1.0 / product }
}

impl Update for Bfgs {
    fn name(&self) -> &'static str {
        "BFGS"
    }

    fn reserve(&mut self, pairs: usize, _: usize) {
        self.shares.resize(pairs, 0.0);
    }

    fn correct(&mut self, k: usize, system: &mut System<'_>, past: &Past, out: &mut [f64]) -> Result<(), Failure> {
        out.copy_from_slice(&system.work.b);
        for (share, (s, y)) in self.shares[..=k].iter_mut().zip(past.s.iter().zip(&past.y)).rev() {
            *share = dot(s, out) * inverse(s, y);
            axpy(-*share, y, out);
        }
        system.solve_for(out)?;
        for (share, (s, y)) in self.shares[..=k].iter().zip(past.s.iter().zip(&past.y)) {
            let other = dot(y, out) * inverse(s, y);
            axpy(share - other, s, out);
        }
        Ok(())
    }
}
