//! Weights of the verdict's features. The example `fit_verdict` writes this file.
//!
//! They are fitted to 99 cases, with a ridge of 0.3.

/// Weights by feature. Features without a line weigh nothing.
pub(crate) const WEIGHTS: &[(&str, f64)] = &[
    ("named", -0.9536),
    ("gain", 1.7052),
    ("ln_gap", -1.3320),
    ("ln_gap_of_look_alike", 0.9598),
    ("pair", -2.0847),
    ("at_bound", -1.2937),
    ("visible", 0.0000),
    ("auxiliary", 0.0592),
    ("equal_gain", 0.5900),
    ("channel_fault", -0.6299),
    ("coincidence", -0.9138),
    ("predicted", 0.9934),
    ("none", 0.9601),
    ("none_first", 2.5559),
    ("ln_chance", 0.7216),
    ("none_structure", -0.9283),
    ("unknown", -0.0064),
    ("unknown_gain", 0.0512),
    ("unknown_remaining", 0.3473),
    ("unknown_structure", 0.8457),
    ("unknown_structure_unexplained", 0.6346),
    ("unknown_structure_without_cause", 1.2406),
    ("unknown_motion", 1.6675),
    ("unknown_recurrence", 0.4798),
    ("unknown_line", 0.1521),
    ("unknown_common", 0.3316),
    ("unknown_visible", 0.0000),
];

/// Constant and weight of ln(1 + gain) in the log odds that the second effect of a pair is present if the first is.
pub(crate) const PAIR_WEIGHTS: [f64; 2] = [-4.0269, 1.0989];
