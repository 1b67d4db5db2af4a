//! Discrete Fourier transforms of series of numbers.
//!
//! The transforms are generic code of many instruction sets. This module compiles them once, apart from the crates that
//! change more often.

use rustfft::FftPlanner;
use std::sync::Arc;

pub use rustfft::Fft;
pub use rustfft::num_complex::Complex;

/// The transform of `n` numbers: `X_k = Σ x_t exp(-2πi k t / n)`, in place and without a factor.
pub fn forward(n: usize) -> Arc<dyn Fft<f64>> {
    FftPlanner::new().plan_fft_forward(n)
}

/// The inverse transform of `n` numbers: `x_t = Σ X_k exp(2πi k t / n)`, in place and without the factor `1/n`.
pub fn inverse(n: usize) -> Arc<dyn Fft<f64>> {
    FftPlanner::new().plan_fft_inverse(n)
}
