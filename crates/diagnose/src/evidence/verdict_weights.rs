//! Weights of the verdict's features. The example `fit_verdict` writes this file.
//!
//! They are fitted to 124 cases, with a ridge of 0.3.

/// Weights by feature. Features without a line weigh nothing.
pub(crate) const WEIGHTS: &[(&str, f64)] = &[
    ("named", -0.8356),
    ("gain", 1.5347),
    ("ln_gap", -1.3338),
    ("ln_gap_of_look_alike", 0.9607),
    ("pair", -0.9549),
    ("at_bound", -1.3545),
    ("auxiliary", 0.4850),
    ("equal_gain", 0.5796),
    ("channel_fault", -0.3464),
    ("coincidence", -1.8640),
    ("predicted", 0.7567),
    ("none", 0.9142),
    ("none_first", 2.3774),
    ("ln_chance", 0.6791),
    ("none_structure", -0.8806),
    ("unknown", -0.0786),
    ("unknown_gain", 0.5873),
    ("unknown_remaining", 0.2678),
    ("unknown_held_out", 0.0250),
    ("unknown_structure", 0.3039),
    ("unknown_structure_unexplained", 0.5311),
    ("unknown_structure_without_cause", 1.2383),
    ("unknown_motion", 1.6929),
    ("unknown_recurrence", 0.8941),
    ("unknown_line", 0.7915),
    ("unknown_common", -0.0016),
];

/// Constant and weight of ln(1 + gain) in the log odds that the second effect of a pair is present if the first is.
pub(crate) const PAIR_WEIGHTS: [f64; 2] = [-4.0269, 1.0989];
