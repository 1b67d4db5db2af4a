//! Ratios of the units that a channel and a model may be in.

use crate::study::unit::{Quantity, Unit, unit};

/// Units that are taken for one another.
struct Confusion {
    quantity: Quantity,
    /// Words in the names of channels of the quantity.
    words: &'static [&'static str],
    /// Pairs of units, the commonest first.
    pairs: &'static [(&'static str, &'static str)],
}

const CONFUSIONS: [Confusion; 5] = [
    Confusion {
        quantity: Quantity::Force,
        words: &["force", "shear"],
        pairs: &[
            ("N", "kN"),
            ("N", "MN"),
            ("kN", "MN"),
            ("kip", "kN"),
            ("lbf", "N"),
            ("kip", "N"),
            ("lbf", "kip"),
            ("kgf", "N"),
            ("tonf", "kN"),
            ("tonf", "N"),
            ("kgf", "kN"),
        ],
    },
    Confusion {
        quantity: Quantity::Length,
        words: &["disp", "drift"],
        pairs: &[
            ("mm", "m"),
            ("cm", "m"),
            ("mm", "cm"),
            ("in", "m"),
            ("mm", "in"),
            ("cm", "in"),
            ("ft", "m"),
            ("in", "ft"),
        ],
    },
    Confusion {
        quantity: Quantity::Acceleration,
        words: &["acc"],
        pairs: &[
            ("g", "m/s2"),
            ("cm/s2", "g"),
            ("in/s2", "g"),
            ("cm/s2", "m/s2"),
            ("mm/s2", "m/s2"),
            ("in/s2", "m/s2"),
            ("ft/s2", "m/s2"),
        ],
    },
    Confusion {
        quantity: Quantity::Velocity,
        words: &["vel"],
        pairs: &[("mm/s", "m/s"), ("cm/s", "m/s"), ("in/s", "m/s")],
    },
    Confusion {
        quantity: Quantity::Stress,
        words: &["stress"],
        pairs: &[
            ("Pa", "kPa"),
            ("kPa", "MPa"),
            ("Pa", "MPa"),
            ("MPa", "GPa"),
            ("ksi", "MPa"),
            ("psi", "ksi"),
            ("psi", "kPa"),
        ],
    },
];

/// Ratios nearer to 1 than this are left to the parameters and to the gain of a sensor.
const MIN_RATIO: f64 = 2.2;

/// A ratio of the recorded to the simulated numbers, and the units that give it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct UnitRatio {
    /// Factor of the recorded numbers on the simulated ones.
    pub(super) factor: f64,
    /// Unit of the recording.
    pub(super) recorded: &'static str,
    /// Unit of the model.
    pub(super) model: &'static str,
}

/// Quantity of a channel, by its unit or its name.
fn quantity(unit_name: &str, channel: &str) -> Option<Quantity> {
    let name = channel.to_lowercase();
    let by_name = || CONFUSIONS.iter().find(|c| c.words.iter().any(|w| name.contains(w))).map(|c| c.quantity);
    unit(unit_name).map(|u| u.quantity).or_else(by_name)
}

/// Returns true if a channel may be an acceleration.
pub(super) fn may_be_acceleration(unit_name: &str, channel: &str) -> bool {
    quantity(unit_name, channel).is_none_or(|q| q == Quantity::Acceleration)
}

/// Ratios of units that a channel may be taken for, those with the unit of its header first, then the commonest.
pub(super) fn ratios(unit_name: &str, channel: &str) -> Vec<UnitRatio> {
    let header = unit(unit_name);
    let of_channel = quantity(unit_name, channel);
    let confusions = CONFUSIONS.iter().filter(|c| of_channel.is_none_or(|q| q == c.quantity));
    let pairs = confusions.flat_map(|c| c.pairs).filter_map(|(a, b)| Some((unit(a)?, unit(b)?)));
    let ratio = |recorded: &Unit, model: &Unit| UnitRatio {
        factor: model.factor / recorded.factor,
        recorded: recorded.name,
        model: model.name,
    };
    let both = pairs.flat_map(|(a, b)| [ratio(&a, &b), ratio(&b, &a)]);
    let mut out: Vec<UnitRatio> = both.filter(|r| r.factor.ln().abs() > MIN_RATIO.ln()).collect();
    out.sort_by_key(|r| !header.is_some_and(|h| r.recorded == h.name || r.model == h.name));
    out
}

#[cfg(test)]
mod tests {
    use super::ratios;

    #[test]
    fn names_are_those_with_the_unit_of_the_header() {
        let named = |unit: &str, factor: f64| {
            let all = ratios(unit, "force");
            let found = all.iter().find(|r| (r.factor / factor - 1.0).abs() < 1e-3).expect("a ratio");
            (found.recorded, found.model)
        };
        assert_eq!(named("N", 1000.0), ("N", "kN"));
        assert_eq!(named("kN", 0.001), ("kN", "N"));
        assert_eq!(named("kN", 0.22481), ("kip", "kN"));
        assert_eq!(named("kN", 4.4482), ("kN", "kip"));
    }

    #[test]
    fn kind_is_taken_from_the_name_without_a_unit() {
        assert!(ratios("", "roof_acc").iter().any(|r| (r.factor - 9.80665).abs() < 1e-9 && r.model == "g"));
        assert!(ratios("", "x").len() > ratios("", "disp").len());
    }
}
