//! Weights of the verdict's features. The example `fit_verdict` writes this file.

use super::verdict_model::FEATURE_COUNT;

/// Weights in the order of [`super::verdict_model::FEATURES`].
pub(crate) const WEIGHTS: [f64; FEATURE_COUNT] = [0.0; FEATURE_COUNT];

/// Constant and weight of ln(1 + gain) in the log odds that the second effect of a pair is present if the first is.
pub(crate) const PAIR_WEIGHTS: [f64; 2] = [0.0; 2];
