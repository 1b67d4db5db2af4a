//! Step and unit in the lines above a table or a list: `Sampling rate: 100 Hz`, `UNIT = gal(cm/s/s)`.

use crate::number::number;
use crate::unit::{Quantity, Unit, header_unit};

/// Keys of a number of samples in a second, letters and digits alone.
const RATES: &[&str] =
    &["samplingrate", "samplerate", "samplingfrequency", "samplefrequency", "samplingfreq", "samplefreq", "abtastrate"];
/// Keys of a step of time.
const STEPS: &[&str] =
    &["samplinginterval", "sampleinterval", "samplingperiod", "timestep", "timeinterval", "deltat", "dt"];
/// Keys of the unit of the samples.
const UNITS: &[&str] = &[
    "unit",
    "units",
    "amplitudeunit",
    "amplitudeunits",
    "accelerationunit",
    "accelerationunits",
    "dataunit",
    "dataunits",
];

/// Statement of the lines of a header about all samples below them.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Stated {
    /// Step in s.
    pub(crate) dt: Option<f64>,
    /// Unit.
    pub(crate) unit: Option<Unit>,
}

impl Stated {
    /// The statements of header lines. Of lines that contradict each other none counts.
    pub(crate) fn of(header: &[String]) -> Self {
        let entries = || header.iter().filter_map(|line| entry(line));
        Self { dt: agreed(entries().filter_map(|e| e.step())), unit: agreed(entries().filter_map(|e| e.unit())) }
    }
}

/// The value of statements that are all the same.
fn agreed<T: PartialEq>(mut all: impl Iterator<Item = T>) -> Option<T> {
    let first = all.next()?;
    all.all(|other| other == first).then_some(first)
}

/// A line of a key and a value.
struct Entry<'a> {
    /// Key without its unit, letters and digits alone, in lower case.
    key: String,
    /// Unit of the key, in brackets: `SampleRate(Hz)`.
    key_unit: String,
    value: &'a str,
}

fn entry(line: &str) -> Option<Entry<'_>> {
    let line = line.trim().trim_start_matches(['#', '%', '*', '!', '/']);
    let (key, value) = line.split_once([':', '='])?;
    let (name, rest) = key.split_once(['(', '[']).unwrap_or((key, ""));
    let plain = |text: &str| text.chars().filter(|c| c.is_alphanumeric()).collect::<String>().to_lowercase();
    Some(Entry { key: plain(name), key_unit: plain(rest), value: value.trim() })
}

impl Entry<'_> {
    /// The number that the value begins with, and the word after it, or the unit of the key.
    fn number_and_unit(&self) -> Option<(f64, String)> {
        let end = self.value.find(|c: char| !(c.is_ascii_digit() || matches!(c, '.' | '-' | '+' | 'e' | 'E')));
        let (digits, rest) = self.value.split_at(end.unwrap_or(self.value.len()));
        let word = rest.split_whitespace().next().unwrap_or_default().trim_end_matches(['.', ',', ';']);
        let unit = if word.is_empty() { self.key_unit.clone() } else { word.to_lowercase() };
        Some((number(digits).filter(|x| *x > 0.0)?, unit))
    }

    fn step(&self) -> Option<f64> {
        let is = |keys: &[&str]| keys.contains(&self.key.as_str());
        let (x, unit) = self.number_and_unit()?;
        if is(RATES) {
            return matches!(unit.as_str(), "hz" | "sps" | "samples/sec" | "samples/s").then(|| 1.0 / x);
        }
        let of_time = header_unit(&unit).filter(|u| u.quantity == Quantity::Time && is(STEPS))?;
        Some(crate::sheet::head::seconds(x, &of_time))
    }

    fn unit(&self) -> Option<Unit> {
        let word = self.value.split(|c: char| c.is_whitespace() || matches!(c, '(' | ',' | ';')).next()?;
        UNITS.contains(&self.key.as_str()).then(|| header_unit(word.trim_end_matches('.')))?
    }
}

#[cfg(test)]
mod tests {
    use super::Stated;

    #[test]
    fn headers_of_agencies() {
        for (lines, dt, unit) in [
            (&["SAMPLING RATE= 100Hz", "UNIT  = gal(cm/s/s)"][..], Some(0.01), Some("gal")),
            (&["#SampleRate(Hz): 200", "#AmplitudeUnit: gal. DCoffset(corr)"], Some(0.005), Some("gal")),
            (&["Sample Rate: 100 sps", "Units: m/s2"], Some(0.01), Some("m/s2")),
            (&["Sampling interval (ms) = 5", "time step: 0.005 sec"], Some(0.005), None),
            // Without a unit, or of several ones, nothing is stated.
            (&["Sample rate: 100", "dt = 0.01", "Units: counts"], None, None),
            (&["Sample rate: 100 Hz", "Sample rate: 200 Hz", "Unit: g", "Unit: gal"], None, None),
            (&["The unit: g is used", "Sample rate: fast"], None, None),
        ] {
            let header: Vec<String> = lines.iter().map(|l| (*l).to_owned()).collect();
            let stated = Stated::of(&header);
            assert_eq!((stated.dt, stated.unit.map(|u| u.name)), (dt, unit), "{lines:?}");
        }
    }
}
