//! Target spectra: from parameters of codes, or from a file.

use crate::codes::Code;
use crate::motion::G;
use crate::spectrum::interpolated;
use hysteron_recordings::Table;
use hysteron_tcl::diagnostic::nearest;
use std::collections::BTreeMap;

/// Pseudo-acceleration in m/s² over the period in s, for 5 % of critical damping.
#[derive(Clone, Debug, PartialEq)]
pub enum Target {
    /// Two-period spectrum of ASCE 7, 11.4.6: S_S-type and S_1-type ordinates in g (already times site coefficients, and of
    /// the level that is meant: S_DS and S_D1, or S_MS and S_M1), and T_L in s.
    TwoPeriod {
        /// Ordinate of short periods in g.
        short: f64,
        /// Ordinate at 1 s in g.
        one: f64,
        /// Period at which displacements become constant in s.
        long: f64,
    },
    /// Horizontal elastic spectrum of EN 1998-1, 3.2.2.2.
    Eurocode {
        /// Ground acceleration a_g in g.
        ground: f64,
        /// S, T_B, T_C and T_D.
        shape: [f64; 4],
    },
    /// Points: periods in s and accelerations in m/s².
    Points(Vec<f64>, Vec<f64>),
}

/// Ordinate of a target in g, at most: larger ones are in another unit.
const LARGEST_ORDINATE: f64 = 10.0;

impl Target {
    /// A target from the words of the command line: `asce7 sms=1.5 sm1=0.9 tl=8`, `ec8 ag=0.35 ground=B type=1`, or a
    /// file of periods and accelerations with a unit.
    ///
    /// # Errors
    /// A word is unknown or missing, or the file cannot be understood. `read` gives the bytes of a file.
    pub fn parse(words: &[String], read: impl Fn(&str) -> Result<Vec<u8>, String>) -> Result<Self, String> {
        let (first, rest) = words.split_first().ok_or("the target spectrum is missing")?;
        match first.as_str() {
            "asce7" => {
                let p = Parameters::new(rest, &["sms", "sm1", "tl"])?;
                let (short, one, long) = (p.positive("sms")?, p.positive("sm1")?, p.positive("tl")?);
                Ok(Self::TwoPeriod { short, one, long })
            }
            "ec8" => {
                let p = Parameters::new(rest, &["ag", "ground", "type"])?;
                let code = Code::named("en1998")?;
                let kind = format!("type{}", p.0.get("type").map_or("1", String::as_str));
                let shapes = code.spectrum.get(&kind).ok_or_else(|| format!("{kind}: expected type=1 or type=2"))?;
                let ground = p.0.get("ground").ok_or("ec8: expected ground=A, B, C, D or E")?;
                let shape = shapes.grounds.get(ground.as_str());
                let shape = shape.ok_or_else(|| format!("ground={ground}: expected A, B, C, D or E"))?;
                Ok(Self::Eurocode { ground: p.positive("ag")?, shape: *shape })
            }
            file if rest.is_empty() => Self::of_file(file, &read(file)?),
            other => {
                let near = nearest(other, ["asce7", "ec8"]).map_or(String::new(), |n| format!("; did you mean {n}?"));
                Err(format!("\"{other}\" is no kind of target spectrum: expected asce7, ec8 or a file{near}"))
            }
        }
    }

    /// Points of a file with columns of the period and of an acceleration, `Sa[g]` for instance.
    fn of_file(name: &str, bytes: &[u8]) -> Result<Self, String> {
        let fault = |e: String| format!("\"{name}\": {e}");
        let table = Table::read(name, bytes).map_err(fault)?;
        let (Some(periods), Some(values)) = (table.columns.first(), table.columns.get(1)) else {
            return Err(fault("expected columns of periods and accelerations".into()));
        };
        let head = table.names.get(1).map_or("", String::as_str);
        let unit_name = head.rsplit(['[', '(', '_']).next().unwrap_or("").trim_end_matches([']', ')']);
        let unit = hysteron_identify::study::unit::unit(unit_name);
        let unit = unit.filter(|u| u.quantity == hysteron_identify::study::unit::Quantity::Acceleration);
        let unit = unit.ok_or_else(|| fault(format!("the second column \"{head}\" has no unit: expected Sa[g]")))?;
        if let Some(i) = periods.windows(2).position(|w| w[0] >= w[1]) {
            return Err(fault(format!("the period of row {} does not increase", i + 2)));
        }
        if periods.len() < 2 || periods[0] < 0.0 || values.iter().any(|v| *v <= 0.0 || !v.is_finite()) {
            return Err(fault("expected two or more rows with positive accelerations".into()));
        }
        Ok(Self::Points(periods.clone(), values.iter().map(|v| unit.factor * v).collect()))
    }

    /// Pseudo-acceleration in m/s² at a period in s; NaN outside of the points of a file.
    pub fn at(&self, period: f64) -> f64 {
        match self {
            Self::TwoPeriod { short, one, long } => {
                let corner = one / short;
                let start = 0.2 * corner;
                G * if period < start {
                    short * (0.4 + 0.6 * period / start)
                } else if period <= corner {
                    *short
                } else if period <= *long {
                    one / period
                } else {
                    one * long / (period * period)
                }
            }
            Self::Eurocode { ground, shape: [s, b, c, d] } => {
                let t = period;
                G * ground
                    * s
                    * if t < *b {
                        1.0 + 1.5 * t / b
                    } else if t <= *c {
                        2.5
                    } else if t <= *d {
                        2.5 * c / t
                    } else {
                        2.5 * c * d / (t * t)
                    }
            }
            Self::Points(periods, values) => match (periods.first(), periods.last()) {
                (Some(first), Some(last)) if (*first..=*last).contains(&period) => {
                    interpolated(periods, values, period)
                }
                _ => f64::NAN,
            },
        }
    }
}

/// Words `name=value`.
struct Parameters(BTreeMap<String, String>);

impl Parameters {
    fn new(words: &[String], known: &[&str]) -> Result<Self, String> {
        let mut out = BTreeMap::new();
        for word in words {
            let (name, value) = word.split_once('=').ok_or_else(|| format!("\"{word}\": expected name=value"))?;
            if !known.contains(&name) {
                let near =
                    nearest(name, known.iter().copied()).map_or(String::new(), |n| format!("; did you mean {n}?"));
                return Err(format!("\"{name}\" is no parameter: expected {}{near}", known.join(", ")));
            }
            out.insert(name.to_owned(), value.to_owned());
        }
        Ok(Self(out))
    }

    fn positive(&self, name: &str) -> Result<f64, String> {
        let word = self.0.get(name).ok_or_else(|| format!("{name}= is missing"))?;
        let value = word.parse::<f64>().ok().filter(|x| *x > 0.0 && x.is_finite());
        let value = value.ok_or_else(|| format!("{name}={word}: expected a number above 0"))?;
        // Periods are below 100 s, and ordinates are in g.
        let most = if name == "tl" { 100.0 } else { LARGEST_ORDINATE };
        if value > most { Err(format!("{name}={word}: expected at most {most}, in g or s")) } else { Ok(value) }
    }
}

#[cfg(test)]
mod tests {
    use super::Target;
    use crate::motion::G;

    fn target(words: &str) -> Result<Target, String> {
        let words: Vec<String> = words.split(' ').map(str::to_owned).collect();
        Target::parse(&words, |_| Ok(b"T[s],Sa[g]\n0.1,1\n1,0.5\n10,0.05\n".to_vec()))
    }

    #[test]
    fn corners_of_code_spectra() {
        let t = target("asce7 sms=1.5 sm1=0.9 tl=8").expect("a target");
        for (period, expected) in
            [(0.0, 0.6), (0.06, 1.05), (0.12, 1.5), (0.6, 1.5), (2.0, 0.45), (8.0, 0.1125), (16.0, 0.028125)]
        {
            assert!((t.at(period) / G - expected).abs() < 1e-12, "{period}");
        }
        let t = target("ec8 ag=0.35 ground=B type=1").expect("a target");
        for (period, expected) in [(0.0, 0.42), (0.15, 1.05), (0.5, 1.05), (1.0, 0.525), (4.0, 0.065625)] {
            assert!((t.at(period) / G - expected).abs() < 1e-12, "{period}");
        }
    }

    #[test]
    fn points_of_a_file_and_wrong_words() {
        let t = target("spectrum.csv").expect("a target");
        assert!((t.at(10f64.sqrt()) / G - 0.05f64.sqrt() * 0.5f64.sqrt()).abs() < 1e-9);
        assert!(t.at(0.05).is_nan() && t.at(11.0).is_nan());
        for (words, said) in [
            ("asce7 sms=1.5 sm1=0.9", "tl"),
            ("asce7 smss=1.5", "sms"),
            ("asce7 sms=-1 sm1=0.9 tl=8", "above 0"),
            ("ec8 ag=0.3 ground=F", "A, B, C"),
            ("asce sms=1", "asce7"),
        ] {
            assert!(target(words).expect_err(words).contains(said), "{words}");
        }
    }
}
