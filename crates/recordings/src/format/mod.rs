//! Formats of measured files, one in a file each.

mod afad;
mod array;
mod cosmos;
mod csmip;
mod diadem;
mod esm;
mod geonet;
mod json;
mod knet;
mod labview;
mod list;
mod matlab;
mod miniseed;
mod miniseed3;
mod peer;
mod sac;
mod smc;
mod steim;
mod table;
mod tcl;
pub(crate) mod unsupported;
mod volume1;
mod workbook;
mod xml;

use crate::content::Content;
use crate::fault::Fault;
use crate::number::number;

/// A file that is to be recognised and read.
pub(crate) struct Input<'a> {
    /// Name without folders.
    pub(crate) name: &'a str,
    /// Bytes, without compression.
    pub(crate) bytes: &'a [u8],
    /// Text; empty for a binary file.
    pub(crate) text: &'a str,
    /// First lines of the text.
    pub(crate) head: Vec<&'a str>,
    /// The bytes of a file of the same folder, for headers whose values are in another file.
    pub(crate) beside: Beside<'a>,
}

/// Reads a file of the same folder by its name. `None` if it is not there, or if no other file may be read.
pub type Beside<'a> = &'a dyn Fn(&str) -> Option<Vec<u8>>;

/// Lines that a format is recognised by.
const HEAD_LINES: usize = 80;

impl<'a> Input<'a> {
    pub(crate) fn new(name: &'a str, bytes: &'a [u8], text: &'a str, beside: Beside<'a>) -> Self {
        Self { name, bytes, text, head: text.lines().take(HEAD_LINES).collect(), beside }
    }

    /// One line of the head has all these words, in lower case.
    fn has(&self, words: &[&str]) -> bool {
        self.head.iter().any(|l| has(l, words))
    }

    /// The name ends with this extension.
    fn has_extension(&self, extension: &str) -> bool {
        let of = |name: &str| name.rsplit_once('.').map(|(_, e)| e.to_ascii_lowercase());
        of(self.name).is_some_and(|e| e == extension)
    }

    /// Lines with their numbers from 1.
    fn lines(&self) -> impl Iterator<Item = (usize, &'a str)> {
        self.text.lines().enumerate().map(|(i, l)| (i + 1, l))
    }
}

/// A line has all these words, in lower case.
fn has(line: &str, words: &[&str]) -> bool {
    let lower = line.to_ascii_lowercase();
    words.iter().all(|w| lower.contains(w))
}

/// A format of measured files.
#[derive(Clone, Copy, Debug)]
pub struct Format {
    /// Name.
    pub name: &'static str,
    /// How it is recognised.
    pub recognised_by: &'static str,
    /// What it says about the samples, so that the user need not.
    pub states: &'static str,
    /// The description that the reader follows.
    pub description: &'static str,
    is: fn(&Input<'_>) -> bool,
    read: fn(&Input<'_>) -> Result<Content, Fault>,
}

impl Format {
    pub(crate) fn recognises(&self, input: &Input<'_>) -> bool {
        (self.is)(input)
    }

    pub(crate) fn read(&self, input: &Input<'_>) -> Result<Content, Fault> {
        (self.read)(input)
    }
}

/// All formats, in the order in which they are tried. The last reads any text.
pub const FORMATS: &[Format] = &[
    workbook::XLSX,
    workbook::ODS,
    array::NPY,
    matlab::MAT,
    sac::SAC,
    miniseed::MINISEED,
    json::JSON,
    cosmos::COSMOS,
    smc::SMC,
    geonet::GEONET,
    knet::KNET,
    esm::ESM,
    afad::AFAD,
    peer::PEER,
    csmip::CSMIP,
    volume1::VOLUME1,
    labview::LABVIEW,
    diadem::DIADEM,
    table::MTS,
    table::SEISMOSIGNAL,
    tcl::TCL,
    list::COUNTED,
    table::TABLE,
];

/// A header line `KEY: value` or `Key   value`: the value after a key, in any case.
fn value_after<'a>(lines: &[&'a str], key: &str) -> Option<&'a str> {
    lines.iter().find_map(|line| {
        let head = line.get(..key.len())?;
        let rest = line.get(key.len()..)?;
        (head.eq_ignore_ascii_case(key) && !rest.starts_with(|c: char| c.is_alphanumeric() || c == '_'))
            .then(|| rest.trim_start_matches([' ', '\t', ':', '=']).trim())
    })
}

/// Degrees clockwise from north of `N10E`, `S72W`, `N`, `N-S`, `NS`, `WE`, `90`; `None` for others.
fn azimuth(word: &str) -> Option<f64> {
    let word = word.trim().to_ascii_uppercase();
    match word.as_str() {
        "N" | "N-S" | "NS" | "NORTH" => return Some(0.0),
        "E" | "E-W" | "EW" | "WE" | "EAST" => return Some(90.0),
        _ => {}
    }
    if let Ok(x) = word.parse::<f64>() {
        return Some(x).filter(|x| (0.0..=360.0).contains(x));
    }
    let (from, to) = (word.chars().next()?, word.chars().last()?);
    let angle = word.get(1..word.len().checked_sub(1)?)?.parse::<f64>().ok().filter(|x| (0.0..=90.0).contains(x))?;
    match (from, to) {
        ('N', 'E') => Some(angle),
        ('N', 'W') => Some((360.0 - angle).rem_euclid(360.0)),
        ('S', 'E') => Some(180.0 - angle),
        ('S', 'W') => Some(180.0 + angle),
        _ => None,
    }
}

/// Samples are as many as the header says. More of them are cut off with a note.
fn counted(values: &mut Vec<f64>, count: usize, notes: &mut Vec<String>) -> Result<(), Fault> {
    let there = values.len();
    if there < count {
        return Err(Fault::new(format!("the header says {count} values, but there are {there}")));
    }
    if there > count {
        notes.push(format!("the header says {count} values, but there are {there}: those after {count} are left out"));
        values.truncate(count);
    }
    Ok(())
}

/// Say so if a block of values goes on after as many as its header says: in its last line, or in the line after it.
fn note_surplus(lines: &[&str], next: usize, cells_left: usize, notes: &mut Vec<String>) {
    let is_row = |l: &&str| {
        let mut words = l.split_whitespace().peekable();
        words.peek().is_some() && words.all(|w| number(w).is_some() || w.contains('.') && w.starts_with(['-', '+']))
    };
    if cells_left > 0 || lines.get(next).is_some_and(is_row) {
        let line = if cells_left > 0 { next } else { next + 1 };
        notes.push(format!("line {line}: there are more values than the header says: they are left out"));
    }
}

#[cfg(test)]
mod tests {
    use super::{azimuth, value_after};

    #[test]
    fn azimuths_in_the_words_of_agencies() {
        for (word, degrees) in
            [("N10E", 10.0), ("N80W", 280.0), ("S40E", 140.0), ("S72W", 252.0), ("E-W", 90.0), ("360", 360.0)]
        {
            assert_eq!(azimuth(word), Some(degrees), "{word}");
        }
        assert!(["UP", "U-D", "X", "", "400", "N100E", "ö1E"].iter().all(|w| azimuth(w).is_none()));
    }

    #[test]
    fn values_of_keys() {
        let lines = ["UNITS_X: a", "Units: cm/s^2", "Scale Factor   3920(gal)/6182761"];
        assert_eq!(value_after(&lines, "UNITS"), Some("cm/s^2"));
        assert_eq!(value_after(&lines, "Scale Factor"), Some("3920(gal)/6182761"));
        assert_eq!(value_after(&lines, "Dir."), None);
    }
}
