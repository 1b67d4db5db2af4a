//! Sizes of an effect in words: names and units of added parameters, with digits that follow the interval.

use crate::hypothesis;
use crate::hypothesis::changed_condition::FACTOR_ON;
use crate::hypothesis::declaration::Dimension;
use hysteron_identify::calibrate::Interval;
use hysteron_identify::study::Study;
use serde::Serialize;

/// Size of an added parameter.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct EffectSize {
    /// Name of the parameter in the script.
    pub name: String,
    /// The quantity in words.
    pub quantity: String,
    /// Fitted value in the units of the script.
    pub value: f64,
    /// Ends of the 95 % interval; none if it could not be estimated.
    pub interval: Option<[f64; 2]>,
    /// Unit of the value; empty if it is not known, or for a number without one.
    pub unit: String,
    /// Quantity, value, interval and unit in words.
    pub text: String,
    /// True if the recordings determine it well enough to be named first.
    pub determined: bool,
}

/// Units of the script; an empty one is not known.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Units {
    /// Unit of length.
    pub(super) length: String,
    /// Unit of force.
    pub(super) force: String,
}

/// Units of length.
const LENGTHS: [&str; 5] = ["m", "mm", "cm", "in", "ft"];
/// Units of force.
const FORCES: [&str; 6] = ["N", "kN", "MN", "lbf", "kip", "kips"];

impl Units {
    /// Units of the observed channels. A comment of the script such as `# units: N, m, s` gives those that no channel has,
    /// unless it contradicts one.
    pub(super) fn of(study: &Study, script: &str) -> Self {
        let first_of = |known: &[&str], units: &[&str]| {
            units.iter().find(|u| known.contains(u)).map_or_else(String::new, |u| (*u).to_owned())
        };
        let observed: Vec<&str> = study.runs.iter().flat_map(|r| &r.observe).map(|o| o.unit.as_str()).collect();
        // An acceleration in m/s2 shows the length as well.
        let lengths: Vec<&str> = observed.iter().map(|u| u.split_once("/s").map_or(*u, |(length, _)| length)).collect();
        let mut units = Self { length: first_of(&LENGTHS, &lengths), force: first_of(&FORCES, &observed) };
        let mut comments = script.lines().filter(|l| l.trim_start().starts_with('#'));
        let comment = comments.find(|l| l.to_lowercase().contains("units")).unwrap_or("");
        let words: Vec<&str> = comment.split([' ', ',', ';', ':', '\t']).collect();
        let (length, force) = (first_of(&LENGTHS, &words), first_of(&FORCES, &words));
        let agrees =
            (units.length.is_empty() || units.length == length) && (units.force.is_empty() || units.force == force);
        if agrees && !length.is_empty() && !force.is_empty() {
            units = Self { length, force };
        }
        units
    }

    /// Units in which a quantity is shown, each with the factor on the value, ascending; none if the unit is not known.
    fn scales(&self, of: Dimension) -> Vec<(f64, String)> {
        let forces: &[(f64, &str)] = match self.force.as_str() {
            "N" => &[(1.0, "N"), (1e-3, "kN"), (1e-6, "MN")],
            "kN" => &[(1e3, "N"), (1.0, "kN"), (1e-3, "MN")],
            "MN" => &[(1e3, "kN"), (1.0, "MN")],
            "" => &[],
            other => &[(1.0, other)],
        };
        let length = self.length.as_str();
        let per_length = |after: &str| -> Vec<(f64, String)> {
            let known = forces.iter().filter(|_| !length.is_empty());
            known.map(|(factor, force)| (*factor, format!("{force}{}", after.replace('L', length)))).collect()
        };
        let one = |unit: &str| vec![(1.0, unit.replace('L', length))];
        match of {
            Dimension::Length if length == "m" => vec![(1e3, "mm".into()), (1.0, "m".into())],
            Dimension::Length | Dimension::Speed if length.is_empty() => vec![],
            Dimension::Length => one("L"),
            Dimension::Speed => one("L/s"),
            Dimension::Force => per_length(""),
            Dimension::Stiffness => per_length("/L"),
            Dimension::Dashpot => per_length(" s/L"),
            Dimension::Moment | Dimension::Energy => per_length(" L"),
            Dimension::RotationalStiffness => per_length(" L/rad"),
            Dimension::RotationalDashpot => per_length(" L s/rad"),
            Dimension::Time => vec![(1e3, "ms".into()), (1.0, "s".into())],
            Dimension::Rate => one("1/s"),
            Dimension::PerDegree => vec![(100.0, "%/degree".into())],
            Dimension::Ratio | Dimension::Unnamed => vec![],
        }
    }
}

/// A standard error above this, in sides of the unit cube, leaves a parameter undetermined. As in the notes of a calibration.
const MAX_STANDARD_ERROR: f64 = 0.25;
/// Ratio of the two sides of an interval up to which it is written with one number after ±.
const MAX_ASYMMETRY: f64 = 1.5;
/// Smallest half width of an interval that is written, in parts of the value.
const MIN_HALF_WIDTH: f64 = 1e-3;

/// Size of the added parameter `name` of a cause, which each of some parts side by side has. None for parameters of channels
/// that a sentence about the channel contains.
pub(super) fn effect_size(
    cause: &str,
    name: &str,
    value: f64,
    interval: Option<&Interval>,
    units: &Units,
    parts: usize,
) -> Option<EffectSize> {
    let (_, plain) = name.split_once('_')?;
    let row = hypothesis::quantity(cause, plain);
    if row.is_none() && cause.starts_with("sensor_") {
        return None;
    }
    let (quantity, dimension) = match (row, plain.strip_prefix(FACTOR_ON)) {
        (Some(q), _) => (q.words.to_owned(), q.dimension),
        (None, Some(parameter)) => (format!("factor on {parameter}"), Dimension::Ratio),
        (None, None) => (plain.to_owned(), Dimension::Unnamed),
    };
    let scales = units.scales(dimension);
    let fits = |(factor, _): &&(f64, String)| (value * factor).abs() >= 1.0;
    let (factor, unit) = scales.iter().rfind(fits).or(scales.first()).cloned().unwrap_or((1.0, String::new()));
    let determined = interval.filter(|i| i.standard_error <= MAX_STANDARD_ERROR);
    let mut number = match (interval, determined) {
        (_, Some(i)) => with_interval(factor * value, [factor * i.lower, factor * i.upper], &unit),
        (Some(_), None) => {
            format!("about {} (the recordings hardly determine it)", with_unit(&digits(factor * value, 2), &unit))
        }
        (None, None) => with_unit(&digits(factor * value, 3), &unit),
    };
    if unit.is_empty() && dimension != Dimension::Ratio {
        number += " in the script's units";
    }
    if parts > 1 && dimension.adds_up() {
        let sum = with_unit(&digits(factor * value * parts as f64, 3), &unit);
        number += &format!(" at each of {parts}, {sum} together");
    }
    let own = scales.iter().find(|(factor, _)| *factor == 1.0).map_or_else(String::new, |(_, unit)| unit.clone());
    Some(EffectSize {
        name: name.into(),
        text: format!("{quantity} {number}"),
        quantity,
        value,
        interval: interval.map(|i| [i.lower, i.upper]),
        unit: own,
        determined: interval.is_none_or(|i| i.standard_error <= MAX_STANDARD_ERROR && is_narrow(i)),
    })
}

/// Width of an interval over its value up to which it is narrow.
const MAX_RELATIVE_WIDTH: f64 = 2.0;

fn is_narrow(i: &Interval) -> bool {
    i.upper - i.lower <= MAX_RELATIVE_WIDTH * i.value.abs()
}

fn with_unit(number: &str, unit: &str) -> String {
    if unit.is_empty() { number.to_owned() } else { format!("{number} {unit}") }
}

/// A value with its interval: `130 mm ± 2`, or both ends where the interval is lopsided.
fn with_interval(value: f64, [lower, upper]: [f64; 2], unit: &str) -> String {
    let (below, above) = (value - lower, upper - value);
    let half = (0.5 * (upper - lower)).max(MIN_HALF_WIDTH * value.abs());
    let lopsided = below.max(above) > MAX_ASYMMETRY * below.min(above).max(0.3 * MIN_HALF_WIDTH * value.abs());
    // Large and small numbers without a unit have a power of ten.
    let power = if (1e-3..1e5).contains(&value.abs()) || value == 0.0 { 0 } else { value.abs().log10().floor() as i32 };
    let (scale, suffix) = (10f64.powi(-power), if power == 0 { String::new() } else { format!("e{power}") });
    let decimals = decimals_of(scale * half);
    let shown = |x: f64| rounded(scale * x, decimals) + &suffix;
    if lopsided {
        format!("{} ({} to {})", with_unit(&shown(value), unit), shown(lower), shown(upper))
    } else {
        format!("{} ± {}", with_unit(&shown(value), unit), shown(half))
    }
}

/// Decimals that show an uncertainty with one digit, or with two if the first is a one; negative for whole tens.
fn decimals_of(uncertainty: f64) -> i32 {
    if uncertainty <= 0.0 || !uncertainty.is_finite() {
        return 3;
    }
    let exponent = uncertainty.log10().floor() as i32;
    let first = uncertainty / 10f64.powi(exponent);
    if first < 1.95 { 1 - exponent } else { -exponent }
}

/// A number with some decimals; whole tens and more for negative ones.
pub(super) fn rounded(x: f64, decimals: i32) -> String {
    let scale = 10f64.powi(decimals);
    let text = if decimals > 8 || x.abs() >= 1e7 {
        format!("{x:.1e}")
    } else {
        format!("{:.*}", decimals.max(0) as usize, (x * scale).round() / scale)
    };
    if text.trim_start_matches('-').chars().all(|c| c == '0' || c == '.') {
        text.trim_start_matches('-').to_owned()
    } else {
        text
    }
}

/// A number with some significant digits.
pub(super) fn digits(x: f64, count: i32) -> String {
    if x == 0.0 || !x.is_finite() {
        return format!("{x}");
    }
    let text = rounded(x, count - 1 - x.abs().log10().floor() as i32);
    let trimmed = if text.contains('.') && !text.contains('e') {
        text.trim_end_matches('0').trim_end_matches('.')
    } else {
        &text
    };
    trimmed.to_owned()
}

/// A time in ms below one second, else in s.
pub(super) fn duration(seconds: f64) -> String {
    if seconds.abs() < 1.0 { format!("{} ms", digits(1e3 * seconds, 3)) } else { format!("{} s", digits(seconds, 3)) }
}

#[cfg(test)]
mod tests {
    use super::{Units, digits, duration, effect_size};
    use hysteron_identify::calibrate::Interval;

    fn size(cause: &str, name: &str, value: f64, [lower, upper]: [f64; 2], units: &Units) -> String {
        let interval = Interval { name: name.into(), value, lower, upper, standard_error: 0.01, from_noise: None };
        effect_size(cause, name, value, Some(&interval), units, 1).expect("a size").text
    }

    #[test]
    fn sizes_have_units_and_digits_of_their_intervals() {
        let units = Units { length: "m".into(), force: "N".into() };
        assert_eq!(size("gap_impact", "hy_gap", 0.1304, [0.1284, 0.1324], &units), "gap 130 mm ± 2");
        assert_eq!(size("gap_impact", "hy_gap", 0.1304, [0.1304, 0.1304], &units), "gap 130.40 mm ± 0.13");
        let wall = size("gap_impact", "hy2_wall", 5.43e7, [4.72e7, 6.2e7], &units);
        assert_eq!(wall, "stiffness of the wall 54 MN/m ± 7");
        let wall = size("gap_impact", "hy_wall", 5.43e7, [4.9e7, 8.2e7], &units);
        assert_eq!(wall, "stiffness of the wall 54 MN/m (49 to 82)");
        let unknown = Units::default();
        let wall = size("gap_impact", "hy_wall", 5.43e7, [5.3e7, 5.56e7], &unknown);
        assert_eq!(wall, "stiffness of the wall 5.43e7 ± 0.13e7 in the script's units");
        assert_eq!(size("sensor_lag", "hy_lag", -0.0107, [-0.0112, -0.0102], &unknown), "delay -10.7 ms ± 0.5");
        assert_eq!(
            size("sensor_gain", "hy_gain", 0.65, [0.648, 0.652], &unknown),
            "factor on the true value 0.650 ± 0.002"
        );
    }

    /// Forces of devices side by side have their sum; other quantities have none.
    #[test]
    fn parts_side_by_side_have_their_sum() {
        let units = Units { length: "m".into(), force: "N".into() };
        let of = |name: &str, value: f64, parts: usize| {
            effect_size("friction", name, value, None, &units, parts).expect("a size").text
        };
        assert_eq!(of("hy_force", 9900.0, 4), "friction force 9.9 kN at each of 4, 39.6 kN together");
        assert_eq!(of("hy_force", 9900.0, 1), "friction force 9.9 kN");
        assert_eq!(of("hy_way", 0.002, 4), "elastic slip 2 mm");
    }

    #[test]
    fn an_undetermined_size_is_called_so() {
        let units = Units { length: "m".into(), force: "kN".into() };
        let interval =
            Interval { name: String::new(), value: 4.7, lower: 1.0, upper: 9.0, standard_error: 0.4, from_noise: None };
        let text = effect_size("friction", "hy_force", 4.7, Some(&interval), &units, 1).expect("a size").text;
        assert_eq!(text, "friction force about 4.7 kN (the recordings hardly determine it)");
    }

    #[test]
    fn numbers_keep_their_digits() {
        assert_eq!([digits(0.00178, 2), digits(1234.0, 2), digits(-0.5, 3)], ["0.0018", "1200", "-0.5"]);
        assert_eq!([duration(0.00125), duration(2.5)], ["1.25 ms", "2.5 s"]);
    }
}
