//! Weights of the verdict's features. The example `fit_verdict` writes this file.
//!
//! They are fitted to 96 cases, with a ridge of 0.3.

/// Weights by feature. Features without a line weigh nothing.
pub(crate) const WEIGHTS: &[(&str, f64)] = &[
    ("named", -0.9189),
    ("gain", 1.6847),
    ("loss", -0.4775),
    ("ln_gap", -1.3183),
    ("ln_gap_of_look_alike", 0.9472),
    ("pair", -2.0761),
    ("at_bound", -1.2892),
    ("visible", 0.0000),
    ("auxiliary", 0.0573),
    ("equal_gain", 0.5876),
    ("channel_fault", -0.6257),
    ("coincidence", -0.9130),
    ("predicted", 1.0015),
    ("worsened", 0.0000),
    ("none", 0.9283),
    ("none_first", 2.4923),
    ("ln_chance", 0.7194),
    ("none_structure", -0.9162),
    ("unknown", -0.0094),
    ("unknown_gain", 0.0478),
    ("unknown_unexplained", 0.0000),
    ("unknown_remaining", 0.3436),
    ("unknown_structure", 0.8434),
    ("unknown_structure_unexplained", 0.6362),
    ("unknown_structure_without_cause", 1.2262),
    ("unknown_motion", 1.6669),
    ("unknown_recurrence", 0.4772),
    ("unknown_line", 0.1532),
    ("unknown_bursts", 0.0000),
    ("unknown_unsteady", 0.0000),
    ("unknown_common", 0.3290),
    ("unknown_visible", 0.0000),
];

/// Constant and weight of ln(1 + gain) in the log odds that the second effect of a pair is present if the first is.
pub(crate) const PAIR_WEIGHTS: [f64; 2] = [-4.0073, 1.0928];
