//! Popovics' curve of concrete in compression (1973).

/// Exponent where the secant at the strength is as stiff as the initial modulus.
const STEEPEST: f64 = 400.0;

/// Stress and slope at a strain, from the strength and its strain, and the initial modulus.
pub(super) fn compression([fc, epsc0]: [f64; 2], modulus: f64, e: f64) -> (f64, f64) {
    let secant = fc / epsc0;
    let r = if secant >= modulus { STEEPEST } else { modulus / (modulus - secant) };
    let eta = e / epsc0;
    let power = eta.powf(r);
    let d = r - 1.0 + power;
    (fc * eta * r / d, fc * r * (r - 1.0) * (1.0 - power) / (d * d * epsc0))
}
