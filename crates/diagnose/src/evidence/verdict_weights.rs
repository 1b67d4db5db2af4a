//! Weights of the verdict's features. The example `fit_verdict` writes this file.
//!
//! They are fitted to 53 cases, with a ridge of 0.3.

use super::verdict_model::FEATURE_COUNT;

/// Weights in the order of [`super::verdict_model::FEATURES`].
pub(crate) const WEIGHTS: [f64; FEATURE_COUNT] = [
    -0.9419, // named
    2.0796,  // gain
    -0.4565, // loss
    0.1392,  // gap
    -1.0432, // ln_gap
    0.8829,  // ln_gap_of_look_alike
    -1.2403, // pair
    -1.3066, // at_bound
    0.0000,  // visible
    0.0071,  // auxiliary
    0.3345,  // equal_gain
    -0.9285, // channel_fault
    -0.0327, // coincidence
    2.2316,  // predicted
    -0.0929, // worsened
    0.7188,  // none
    2.0631,  // none_first
    0.4204,  // ln_chance
    -0.8265, // none_structure
    0.2231,  // unknown
    0.4944,  // unknown_gain
    -0.5506, // unknown_unexplained
    -0.0286, // unknown_remaining
    1.5412,  // unknown_structure
    0.3537,  // unknown_structure_unexplained
    1.0700,  // unknown_structure_without_cause
    0.7143,  // unknown_motion
    0.0429,  // unknown_recurrence
    0.0339,  // unknown_line
    0.3676,  // unknown_bursts
    -0.0502, // unknown_unsteady
    0.0996,  // unknown_common
    0.0000,  // unknown_visible
];

/// Constant and weight of ln(1 + gain) in the log odds that the second effect of a pair is present if the first is.
pub(crate) const PAIR_WEIGHTS: [f64; 2] = [-3.3878, 0.8134];
