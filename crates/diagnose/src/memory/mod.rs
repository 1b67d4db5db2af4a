//! Memory of a device: the quantity of the past on which its force depends.
//!
//! The library names causes by laws. Here laws of one form compete instead, which differ only in what they remember: nothing,
//! elapsed time, work, heat, the largest deformation, the rate, time at rest, and so on. The best one says which *kind* of
//! phenomenon a device has, also where the library has no law for it:
//!
//! force = g_E(q) E(u) + g_H(q) H(u; g_S(q)) + X(u, u̇) + F(q),  g = 1 + Σ a_k φ_k(q)
//!
//! with the deformation u, an elastic part E, a hysteretic part H whose strength has the factor g_S, viscous parts X, and
//! slow variables φ of the past ([`family`]). Weights of E, H and X are found by non-negative least squares, the factors a by
//! Gauss and Newton's method. Terms enter one at a time while the errors on blocks and runs held back fall ([`competition`]).
//! Strength rather than force has the factor by default: friction that ages at rest is not found otherwise.
//!
//! - [`family`]: kinds of memory
//! - [`operators`]: stops, filters and other functions of a motion
//! - [`slow_variables`]: what each family remembers
//! - [`data`]: runs, scales, weights and folds
//! - [`least_squares`]: non-negative least squares
//! - `linear_folds`: errors on what is held back, by derivatives
//! - [`law`], [`columns`]: a law and its fit
//! - [`competition`]: choice of terms and of the family
//! - [`learning`], [`learned_law`]: the best law as one of the engine

mod columns;
pub(crate) mod competition;
pub(crate) mod data;
pub(crate) mod family;
mod law;
mod learned_law;
pub(crate) mod learning;
mod least_squares;
mod linear_folds;
mod operators;
mod slow_variables;
