//! Units of recorded channels and of the model's outputs, and the conversion between them.
//!
//! Factors: NIST Special Publication 811 (2008), Appendix B. `tonf` is the metric ton-force, 1000 kgf.

use hysteron_tcl::diagnostic::nearest;
use std::fmt;

/// Physical quantity of a unit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// Ratio, such as a strain or a drift.
    Ratio,
    /// Length.
    Length,
    /// Velocity.
    Velocity,
    /// Acceleration.
    Acceleration,
    /// Force.
    Force,
    /// Stress or pressure.
    Stress,
    /// Moment.
    Moment,
    /// Angle.
    Angle,
    /// Velocity of rotation.
    AngularVelocity,
    /// Acceleration of rotation.
    AngularAcceleration,
    /// Temperature.
    Temperature,
    /// Time.
    Time,
}

impl fmt::Display for Quantity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Ratio => "a ratio",
            Self::Length => "a length",
            Self::Velocity => "a velocity",
            Self::Acceleration => "an acceleration",
            Self::Force => "a force",
            Self::Stress => "a stress",
            Self::Moment => "a moment",
            Self::Angle => "an angle",
            Self::AngularVelocity => "an angular velocity",
            Self::AngularAcceleration => "an angular acceleration",
            Self::Temperature => "a temperature",
            Self::Time => "a time",
        })
    }
}

/// Words for the quantities that a user names, and that heads of columns begin with.
const WORDS: &[(&str, Quantity)] = &[
    ("acceleration", Quantity::Acceleration),
    ("acc", Quantity::Acceleration),
    ("accel", Quantity::Acceleration),
    ("beschleunigung", Quantity::Acceleration),
    ("velocity", Quantity::Velocity),
    ("vel", Quantity::Velocity),
    ("veloc", Quantity::Velocity),
    ("displacement", Quantity::Length),
    ("disp", Quantity::Length),
    ("displ", Quantity::Length),
    ("length", Quantity::Length),
    ("stroke", Quantity::Length),
    ("weg", Quantity::Length),
    ("force", Quantity::Force),
    ("load", Quantity::Force),
    ("kraft", Quantity::Force),
    ("stress", Quantity::Stress),
    ("moment", Quantity::Moment),
    ("angle", Quantity::Angle),
    ("temperature", Quantity::Temperature),
    ("temp", Quantity::Temperature),
    ("strain", Quantity::Ratio),
    ("time", Quantity::Time),
    ("zeit", Quantity::Time),
];

impl Quantity {
    /// The quantity of a word such as `velocity` or `disp`, in any case.
    pub fn named(word: &str) -> Option<Self> {
        let word = word.trim().to_lowercase();
        WORDS.iter().find(|(w, _)| *w == word).map(|(_, q)| *q)
    }

    /// The quantity that the name of a column begins with: `Acc X`, `vel_2`, `Weg Lager 1`.
    pub fn of_head(name: &str) -> Option<Self> {
        let first = name.trim().split(|c: char| !c.is_alphabetic()).next().unwrap_or_default();
        Self::named(first)
    }

    /// The word that names it.
    pub fn word(self) -> &'static str {
        match self {
            Self::Ratio => "ratio",
            Self::AngularVelocity => "angular velocity",
            Self::AngularAcceleration => "angular acceleration",
            _ if self == Self::Length => "displacement",
            _ => WORDS.iter().find(|(_, q)| *q == self).map_or("ratio", |(w, _)| w),
        }
    }

    /// The word for several of them.
    pub fn words(self) -> String {
        let word = self.word();
        word.strip_suffix('y').map_or_else(|| format!("{word}s"), |stem| format!("{stem}ies"))
    }
}

/// A unit: a value x in it is `factor` x + `offset` in the SI unit of its quantity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unit {
    /// Name.
    pub name: &'static str,
    /// Physical quantity.
    pub quantity: Quantity,
    /// Value of one unit in the SI unit.
    pub factor: f64,
    /// Zero of the unit in the SI unit; 0 but for temperatures.
    pub offset: f64,
}

impl Unit {
    /// Factor and offset that convert values in this unit into `other`. `None` if the quantities differ.
    pub fn conversion(&self, other: &Self) -> Option<(f64, f64)> {
        let same = self.quantity == other.quantity;
        same.then(|| (self.factor / other.factor, (self.offset - other.offset) / other.factor))
    }
}

const fn new(name: &'static str, quantity: Quantity, factor: f64) -> Unit {
    Unit { name, quantity, factor, offset: 0.0 }
}

/// Standard acceleration of gravity in m/s².
const G: f64 = 9.80665;
/// Foot, inch in m.
const FT: f64 = 0.3048;
const IN: f64 = 0.0254;
/// Pound-force in N, and a stress of one pound-force per square inch in Pa.
const LBF: f64 = 4.448_221_615_260_5;
const PSI: f64 = LBF / (IN * IN);
const DEGREE: f64 = std::f64::consts::PI / 180.0;

/// All units. A second name of a unit follows its first.
const UNITS: &[Unit] = &[
    new("1", Quantity::Ratio, 1.0),
    new("-", Quantity::Ratio, 1.0),
    new("%", Quantity::Ratio, 0.01),
    new("m", Quantity::Length, 1.0),
    new("cm", Quantity::Length, 0.01),
    new("mm", Quantity::Length, 0.001),
    new("in", Quantity::Length, IN),
    new("inch", Quantity::Length, IN),
    new("ft", Quantity::Length, FT),
    new("m/s", Quantity::Velocity, 1.0),
    new("cm/s", Quantity::Velocity, 0.01),
    new("mm/s", Quantity::Velocity, 0.001),
    new("kine", Quantity::Velocity, 0.01),
    new("in/s", Quantity::Velocity, IN),
    new("ft/s", Quantity::Velocity, FT),
    new("m/s2", Quantity::Acceleration, 1.0),
    new("cm/s2", Quantity::Acceleration, 0.01),
    new("mm/s2", Quantity::Acceleration, 0.001),
    new("gal", Quantity::Acceleration, 0.01),
    new("g", Quantity::Acceleration, G),
    new("mg", Quantity::Acceleration, 0.001 * G),
    new("%g", Quantity::Acceleration, 0.01 * G),
    new("in/s2", Quantity::Acceleration, IN),
    new("ft/s2", Quantity::Acceleration, FT),
    new("N", Quantity::Force, 1.0),
    new("kN", Quantity::Force, 1e3),
    new("MN", Quantity::Force, 1e6),
    new("lbf", Quantity::Force, LBF),
    new("lb", Quantity::Force, LBF),
    new("kip", Quantity::Force, 1e3 * LBF),
    new("kips", Quantity::Force, 1e3 * LBF),
    new("kgf", Quantity::Force, G),
    new("tonf", Quantity::Force, 1e3 * G),
    new("tf", Quantity::Force, 1e3 * G),
    new("Pa", Quantity::Stress, 1.0),
    new("kPa", Quantity::Stress, 1e3),
    new("MPa", Quantity::Stress, 1e6),
    new("GPa", Quantity::Stress, 1e9),
    new("N/m2", Quantity::Stress, 1.0),
    new("kN/m2", Quantity::Stress, 1e3),
    new("N/mm2", Quantity::Stress, 1e6),
    new("bar", Quantity::Stress, 1e5),
    new("psi", Quantity::Stress, PSI),
    new("ksi", Quantity::Stress, 1e3 * PSI),
    new("kgf/cm2", Quantity::Stress, 1e4 * G),
    new("Nm", Quantity::Moment, 1.0),
    new("Nmm", Quantity::Moment, 1e-3),
    new("kNm", Quantity::Moment, 1e3),
    new("kNmm", Quantity::Moment, 1.0),
    new("MNm", Quantity::Moment, 1e6),
    new("lbfin", Quantity::Moment, LBF * IN),
    new("lbfft", Quantity::Moment, LBF * FT),
    new("kipin", Quantity::Moment, 1e3 * LBF * IN),
    new("kipft", Quantity::Moment, 1e3 * LBF * FT),
    new("kgfm", Quantity::Moment, G),
    new("tonfm", Quantity::Moment, 1e3 * G),
    new("rad", Quantity::Angle, 1.0),
    new("mrad", Quantity::Angle, 1e-3),
    new("deg", Quantity::Angle, DEGREE),
    new("°", Quantity::Angle, DEGREE),
    new("rad/s", Quantity::AngularVelocity, 1.0),
    new("deg/s", Quantity::AngularVelocity, DEGREE),
    new("rad/s2", Quantity::AngularAcceleration, 1.0),
    new("deg/s2", Quantity::AngularAcceleration, DEGREE),
    new("K", Quantity::Temperature, 1.0),
    Unit { name: "degC", quantity: Quantity::Temperature, factor: 1.0, offset: 273.15 },
    Unit { name: "°C", quantity: Quantity::Temperature, factor: 1.0, offset: 273.15 },
    Unit { name: "C", quantity: Quantity::Temperature, factor: 1.0, offset: 273.15 },
    Unit { name: "degF", quantity: Quantity::Temperature, factor: 5.0 / 9.0, offset: 459.67 * 5.0 / 9.0 },
    Unit { name: "°F", quantity: Quantity::Temperature, factor: 5.0 / 9.0, offset: 459.67 * 5.0 / 9.0 },
    Unit { name: "F", quantity: Quantity::Temperature, factor: 5.0 / 9.0, offset: 459.67 * 5.0 / 9.0 },
    new("s", Quantity::Time, 1.0),
    new("ms", Quantity::Time, 1e-3),
    new("us", Quantity::Time, 1e-6),
    new("min", Quantity::Time, 60.0),
    new("h", Quantity::Time, 3600.0),
];

/// All units that are known.
pub fn all() -> &'static [Unit] {
    UNITS
}

/// The unit of a name. `m/s²`, `m/s^2`, `m/sec2` and `kN-m`, `kN*m`, `kN m` are understood. Upper and lower case count
/// only where the letter is a prefix: `KN` is `kN`, and `mN` is not `MN`.
pub fn unit(name: &str) -> Option<Unit> {
    let plain = normalized(name);
    let find = |same: &dyn Fn(&str) -> bool| UNITS.iter().copied().find(|u| same(u.name));
    let is_mega = |n: &str| n.starts_with('M');
    let same_letters = |n: &str| n.eq_ignore_ascii_case(&plain) && is_mega(n) == is_mega(&plain);
    find(&|n| n == plain).or_else(|| if plain.len() > 1 { find(&same_letters) } else { None })
}

/// The unit of a header in capitals, in the words of agencies: `CM/SEC/SEC`, `G`, `GALS`, `cm/s**2`.
pub fn header_unit(name: &str) -> Option<Unit> {
    let name = name.trim().trim_matches(|c: char| matches!(c, '(' | ')' | '[' | ']' | ',' | ';' | ':'));
    let lower = name.to_lowercase();
    let plain = match lower.as_str() {
        "gals" => "gal",
        "g's" | "gs" => "g",
        "seconds" | "second" => "s",
        "msec" | "millisec" | "milliseconds" => "ms",
        "minutes" => "min",
        "inches" => "in",
        other => other,
    };
    unit(name).or_else(|| unit(plain))
}

/// The name without superscripts, spaces and signs of multiplication.
fn normalized(name: &str) -> String {
    let name = name.trim();
    if name == "-" {
        return name.to_owned();
    }
    let mut plain: String = name.chars().filter(|c| !matches!(c, ' ' | '^' | '*' | '.' | '-' | '·' | '⋅')).collect();
    for (from, to) in [("²", "2"), ("µ", "u"), ("μ", "u"), ("seconds", "s"), ("sec", "s"), ("s/s", "s2"), ("º", "°")]
    {
        plain = plain.replace(from, to);
    }
    plain
}

/// The known name that is nearest to an unknown one.
pub fn nearest_name(name: &str) -> Option<&'static str> {
    nearest(&normalized(name), UNITS.iter().map(|u| u.name))
}

#[cfg(test)]
mod tests {
    use super::{Quantity, all, header_unit, nearest_name, unit};

    fn convert(x: f64, from: &str, to: &str) -> f64 {
        let (factor, offset) = unit(from).expect(from).conversion(&unit(to).expect(to)).expect("one quantity");
        factor * x + offset
    }

    #[test]
    fn values_are_converted_with_the_factors_of_nist() {
        for (x, from, to, expected) in [
            (25.4, "mm", "in", 1.0),
            (1.0, "kip", "kN", 4.448_221_615_260_5),
            (1.0, "ksi", "MPa", 6.894_757_293_168_36),
            (1.0, "tonf", "kN", 9.80665),
            (1.0, "g", "gal", 980.665),
            (212.0, "F", "degC", 100.0),
            (20.0, "degC", "K", 293.15),
            (-40.0, "°C", "°F", -40.0),
            (180.0, "deg", "rad", std::f64::consts::PI),
            (1.0, "kip-ft", "kN-m", 1.355_817_948_331_4),
            (3.0, "min", "s", 180.0),
            (1.0, "m/s²", "cm/sec^2", 100.0),
        ] {
            let got = convert(x, from, to);
            assert!((got - expected).abs() < 1e-12 * expected.abs().max(1.0), "{x} {from} in {to}: {got}");
        }
        assert!(unit("kN").expect("kN").conversion(&unit("mm").expect("mm")).is_none());
    }

    #[test]
    fn headers_name_units_in_capitals() {
        for (word, name) in [
            ("G", "g"),
            ("CM/SEC/SEC", "cm/s2"),
            ("cm/s**2", "cm/s2"),
            ("GALS", "gal"),
            ("MSEC", "ms"),
            ("(CM/S)", "cm/s"),
        ] {
            assert_eq!(header_unit(word).map(|u| u.name), Some(name), "{word}");
        }
        assert_eq!(header_unit("COUNTS"), None);
        assert_eq!(Quantity::of_head("Vel_X"), Some(Quantity::Velocity));
        assert_eq!(Quantity::of_head("velvet"), None);
    }

    #[test]
    fn letters_in_another_case_are_understood_where_they_are_no_prefix() {
        let name = |n: &str| unit(n).map(|u| u.name);
        assert_eq!((name("KN"), name("Gal"), name("kpa")), (Some("kN"), Some("gal"), Some("kPa")));
        assert_eq!((name("mN"), name("Mm"), name("mpa"), name("kg")), (None, None, None, None));
        assert_eq!(nearest_name("kNn"), Some("kN"));
    }

    #[test]
    fn names_are_unique_and_each_finds_its_own_unit() {
        for u in all() {
            assert_eq!(unit(u.name), Some(*u), "{}", u.name);
            assert!(u.offset == 0.0 || u.quantity == Quantity::Temperature);
        }
    }
}
