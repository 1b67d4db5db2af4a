//! Ratios of the units that a channel and a model may be in.

/// Units of one kind: name, and size in the first of them.
type Kind = &'static [(&'static str, f64)];

const LENGTHS: Kind = &[("m", 1.0), ("cm", 0.01), ("mm", 0.001), ("in", 0.0254), ("ft", 0.3048)];
const SPEEDS: Kind = &[("m/s", 1.0), ("cm/s", 0.01), ("mm/s", 0.001), ("in/s", 0.0254)];
const ACCELERATIONS: Kind =
    &[("m/s2", 1.0), ("g", 9.80665), ("cm/s2", 0.01), ("in/s2", 0.0254), ("mm/s2", 0.001), ("ft/s2", 0.3048)];
const FORCES: Kind = &[
    ("N", 1.0),
    ("kN", 1e3),
    ("MN", 1e6),
    ("lbf", 4.448_221_615),
    ("kip", 4448.221_615),
    ("kgf", 9.80665),
    ("tonf", 9806.65),
];
const STRESSES: Kind =
    &[("Pa", 1.0), ("kPa", 1e3), ("MPa", 1e6), ("GPa", 1e9), ("psi", 6894.757), ("ksi", 6_894_757.0)];
const KINDS: [Kind; 5] = [FORCES, LENGTHS, ACCELERATIONS, SPEEDS, STRESSES];

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

/// Returns the kind of quantity of a unit or a name of a channel, as an index.
fn kind(unit: &str, channel: &str) -> Option<usize> {
    let by_unit = KINDS.iter().position(|k| k.iter().any(|(name, _)| *name == unit));
    let name = channel.to_lowercase();
    by_unit.or_else(|| {
        let begins = [("force", 0), ("shear", 0), ("disp", 1), ("drift", 1), ("acc", 2), ("vel", 3), ("stress", 4)];
        begins.iter().find(|(word, _)| name.contains(word)).map(|(_, k)| *k)
    })
}

/// Returns true if a channel may be an acceleration.
pub(super) fn may_be_acceleration(unit: &str, channel: &str) -> bool {
    kind(unit, channel).is_none_or(|k| k == 2)
}

/// All ratios of the units of a channel, those within the metric system first. The header may be wrong, so its unit only
/// chooses among the names of a ratio.
pub(super) fn ratios(unit: &str, channel: &str) -> Vec<UnitRatio> {
    let kinds: Vec<Kind> = kind(unit, channel).map_or(KINDS.to_vec(), |k| vec![KINDS[k]]);
    let mut out: Vec<UnitRatio> = vec![];
    let names_header = |r: &UnitRatio| r.recorded == unit || r.model == unit;
    for k in kinds {
        for (recorded, size) in k {
            for (model, model_size) in k.iter().filter(|(name, _)| name != recorded) {
                let ratio = UnitRatio { factor: model_size / size, recorded, model };
                if ratio.factor.ln().abs() < MIN_RATIO.ln() {
                    continue;
                }
                match out.iter_mut().find(|r| (r.factor / ratio.factor).ln().abs() < 1e-3) {
                    Some(known) if names_header(&ratio) && !names_header(known) => *known = ratio,
                    Some(_) => {}
                    None => out.push(ratio),
                }
            }
        }
    }
    out.sort_by_key(|r| !is_power_of_ten(r.factor));
    out
}

/// Returns true for the ratios of metric units.
pub(super) fn is_power_of_ten(factor: f64) -> bool {
    let log = factor.abs().log10();
    (log - log.round()).abs() < 1e-9
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
