//! Weights of the verdict's features. The example `fit_verdict` writes this file.
//!
//! They are fitted to 159 cases, with a ridge of 0.3.

/// Weights by feature. Features without a line weigh nothing.
pub(crate) const WEIGHTS: &[(&str, f64)] = &[
    ("named", -1.1637),
    ("gain", 0.9682),
    ("ln_gap", -1.6735),
    ("ln_gap_of_look_alike", 1.1281),
    ("at_bound", -1.2400),
    ("auxiliary", 0.6839),
    ("coincidence", -1.7009),
    ("predicted", 1.0647),
    ("none_first", 2.8803),
    ("unknown_structure_unexplained", 1.6472),
    ("unknown_structure_without_cause", 1.9424),
    ("unknown_motion", 1.3732),
];

/// Constant and weight of ln(1 + gain) in the log odds that the second effect of a pair is present if the first is.
pub(crate) const PAIR_WEIGHTS: [f64; 2] = [-4.5965, 1.1201];
