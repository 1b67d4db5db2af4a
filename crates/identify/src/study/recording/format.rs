//! The written form of a recording: its encoding, the separators of cells and decimals, names and units of columns.

use crate::study::unit::{self, Quantity, Unit};

/// Windows-1252 from 0x80 to 0x9F; the other bytes are their own code points. Source: Unicode's CP1252.TXT.
const CP1252: [char; 32] = [
    '€', '\u{81}', '‚', 'ƒ', '„', '…', '†', '‡', 'ˆ', '‰', 'Š', '‹', 'Œ', '\u{8d}', 'Ž', '\u{8f}', '\u{90}', '‘', '’',
    '“', '”', '•', '–', '—', '˜', '™', 'š', '›', 'œ', '\u{9d}', 'ž', 'Ÿ',
];

/// Bytes that the kind of file is told from.
const SAMPLE: usize = 256;

/// Text of UTF-8, UTF-16 or Windows-1252 without its byte order mark.
///
/// # Errors
/// Kind of the file instead, and the format to save.
pub(super) fn decode(bytes: &[u8]) -> Result<String, (String, &'static str)> {
    const CSV: &str = "save it as CSV UTF-8, with the numbers in the first sheet";
    if bytes.starts_with(b"PK\x03\x04") {
        return Err(("is an Excel workbook (xlsx) or another archive, not a text".into(), CSV));
    }
    if bytes.starts_with(&[0xd0, 0xcf, 0x11, 0xe0]) {
        return Err(("is an Excel workbook (xls), not a text".into(), CSV));
    }
    let utf16 = |body: &[u8], unit: fn([u8; 2]) -> u16| {
        let units: Vec<u16> = body.chunks_exact(2).map(|pair| unit([pair[0], pair[1]])).collect();
        String::from_utf16(&units).map_err(|_| ("is no valid UTF-16".into(), CSV))
    };
    match bytes {
        [0xff, 0xfe, body @ ..] => return utf16(body, u16::from_le_bytes),
        [0xfe, 0xff, body @ ..] => return utf16(body, u16::from_be_bytes),
        _ => {}
    }
    let body = bytes.strip_prefix(&[0xef, 0xbb, 0xbf]).unwrap_or(bytes);
    let sample = &body[..body.len().min(SAMPLE)];
    if sample.contains(&0) {
        // UTF-16 without a mark: of ASCII letters every second byte is zero.
        let zeros = |parity: usize| sample.iter().skip(parity).step_by(2).all(|b| *b == 0);
        return match (zeros(0), zeros(1)) {
            (false, true) => utf16(body, u16::from_le_bytes),
            (true, false) => utf16(body, u16::from_be_bytes),
            _ => Err(("is a binary file, not a text".into(), "save it as comma-separated values")),
        };
    }
    Ok(match std::str::from_utf8(body) {
        Ok(text) => text.to_owned(),
        Err(_) => {
            body.iter().map(|b| CP1252.get(usize::from(*b).wrapping_sub(0x80)).map_or(char::from(*b), |c| *c)).collect()
        }
    })
}

/// Separators of cells, in the order in which they are tried.
const SEPARATORS: [char; 3] = [',', ';', '\t'];

/// Text without the line `sep=;` that Excel writes, and the separator of its cells: the first that leaves a time in the
/// first cell of the header.
pub(super) fn separator(text: &str) -> (usize, char) {
    let first = text.lines().next().unwrap_or_default();
    let stated = first.trim_end().strip_prefix("sep=").map(|s| s.chars().next().unwrap_or('\t'));
    if let Some(stated) = stated.filter(|s| SEPARATORS.contains(s)) {
        return (text.find('\n').map_or(text.len(), |end| end + 1), stated);
    }
    let header = text.lines().find(|l| !l.starts_with('#') && !l.trim().is_empty()).unwrap_or_default();
    let cell = |s: char| header.split(s).next().unwrap_or_default().trim().trim_matches('"');
    let leaves_time = |s: &char| header.contains(*s) && time_head(cell(*s)).is_some();
    let frequent = || SEPARATORS.into_iter().rev().max_by_key(|s| header.matches(*s).count()).unwrap_or(',');
    (0, SEPARATORS.into_iter().find(leaves_time).unwrap_or_else(frequent))
}

/// Reads numbers whose decimal sign the first of them decides.
pub(super) struct Decimals {
    /// A comma may be the decimal sign, since it does not separate the cells.
    comma_allowed: bool,
    sign: Option<char>,
}

impl Decimals {
    /// Numbers between separators.
    pub(super) fn new(separator: char) -> Self {
        Self { comma_allowed: separator != ',', sign: None }
    }

    /// The number in a cell.
    ///
    /// # Errors
    /// Advice on what to save instead; empty where there is none.
    pub(super) fn number(&mut self, cell: &str) -> Result<f64, &'static str> {
        let finite = |text: &str| text.parse::<f64>().ok().filter(|x| x.is_finite());
        if !cell.contains(',') {
            let value = finite(cell).ok_or(if cell.starts_with('#') { "leave missing samples empty" } else { "" })?;
            if !cell.contains('.') {
                return Ok(value);
            }
            let sign = *self.sign.get_or_insert('.');
            return if sign == '.' { Ok(value) } else { Err("save all numbers with one decimal sign") };
        }
        let value = finite(&cell.replacen(',', ".", 1));
        match (value, self.comma_allowed) {
            (None, _) => Err("save numbers without separators of thousands, with one decimal sign"),
            (Some(_), false) => {
                Err("a comma separates the cells: save decimals with a point, or cells with semicolons")
            }
            (Some(value), true) => match *self.sign.get_or_insert(',') {
                ',' => Ok(value),
                _ => Err("save numbers without separators of thousands, with one decimal sign"),
            },
        }
    }
}

/// Name and unit of `name[unit]` or `name(unit)`. Round brackets count as those of a unit only if it is known: they may
/// be a part of the name.
pub(super) fn name_and_unit(cell: &str) -> (String, String) {
    let cell = cell.trim();
    let split = |open: char, close: char| cell.strip_suffix(close).and_then(|c| c.split_once(open));
    let is_unit = |text: &str| unit::unit(text).is_some() && !text.trim().starts_with(|c: char| c.is_ascii_digit());
    let parts = split('[', ']').or_else(|| split('(', ')').filter(|(_, u)| is_unit(u)));
    let (name, unit) = parts.unwrap_or((cell, ""));
    (name.trim().to_owned(), unit.trim().to_owned())
}

/// The unit of a time, by its name in any case; seconds without a name.
pub(super) fn time_unit(name: &str) -> Option<Unit> {
    let name = if name.is_empty() { "s".into() } else { name.to_lowercase() };
    unit::unit(&name).filter(|u| u.quantity == Quantity::Time)
}

/// The unit of the time column if a cell is the head of one: `time[s]`, `Time (ms)`, `t`.
pub(super) fn time_head(cell: &str) -> Option<Unit> {
    let (name, unit) = name_and_unit(cell);
    ["time", "t"].contains(&name.to_lowercase().as_str()).then(|| time_unit(&unit)).flatten()
}

/// A time in seconds. A multiple of 1 ms is divided by 1000, so that 20 ms is 0.02 s to the last bit.
pub(super) fn seconds(time: f64, unit: &Unit) -> f64 {
    if unit.factor == 1.0 {
        time
    } else if unit.factor < 1.0 {
        time / (1.0 / unit.factor).round()
    } else {
        time * unit.factor
    }
}

/// Units in the row below the header, as `s,kN,mm` or `[s],[kN],[mm]`. `None` if the row is no such row.
pub(super) fn units_row<'a>(cells: impl Iterator<Item = &'a str>) -> Option<Vec<String>> {
    let bare = |cell: &'a str| {
        let inside = |open, close| cell.strip_prefix(open).and_then(|c: &str| c.strip_suffix(close));
        inside('[', ']').or_else(|| inside('(', ')')).unwrap_or(cell).trim()
    };
    let units: Vec<&str> = cells.map(|c| bare(c.trim())).collect();
    let (first, others) = units.split_first()?;
    let is_text = |u: &&str| u.parse::<f64>().is_err();
    let is_time = if first.is_empty() {
        others.iter().any(|u| !u.is_empty()) && others.iter().all(|u| u.is_empty() || unit::unit(u).is_some())
    } else {
        time_unit(first).is_some()
    };
    (is_time && others.iter().all(is_text)).then(|| units.iter().map(|u| (*u).to_owned()).collect())
}

#[cfg(test)]
mod tests {
    use super::{Decimals, decode, name_and_unit, seconds, separator, time_head, units_row};

    #[test]
    fn heads_are_split_into_name_and_unit() {
        for (cell, name, unit) in [
            ("force[kN]", "force", "kN"),
            ("force (kN)", "force", "kN"),
            ("acc [m/s²]", "acc", "m/s²"),
            ("disp(2)", "disp(2)", ""),
            ("strain (left)", "strain (left)", ""),
            ("voltage[V]", "voltage", "V"),
            ("plain", "plain", ""),
        ] {
            assert_eq!(name_and_unit(cell), (name.to_owned(), unit.to_owned()), "{cell}");
        }
    }

    #[test]
    fn heads_of_the_time_have_a_unit_of_time() {
        for (cell, name) in [
            ("time[s]", "s"),
            ("Time (ms)", "ms"),
            ("t", "s"),
            ("T [Sec]", "s"),
            ("TIME[min]", "min"),
            ("time[seconds]", "s"),
        ] {
            assert_eq!(time_head(cell).map(|u| u.name), Some(name), "{cell}");
        }
        assert!(["force", "time[kN]", "", "Zeit[s]"].iter().all(|c| time_head(c).is_none()));
        let ms = time_head("t[ms]").expect("a time");
        assert_eq!((seconds(20.0, &ms), seconds(26.0, &ms)), (0.02, 0.026));
    }

    #[test]
    fn rows_of_units_are_told_from_rows_of_numbers() {
        assert_eq!(
            units_row(["[s]", "(kN)", "mm"].into_iter()).as_deref(),
            Some(&["s", "kN", "mm"].map(String::from)[..])
        );
        assert!(units_row(["", "kN"].into_iter()).is_some());
        for row in [&["0.0", "1"][..], &["s", "1"], &["", ""], &["", "x"], &["kN", "mm"]] {
            assert!(units_row(row.iter().copied()).is_none(), "{row:?}");
        }
    }

    #[test]
    fn separator_is_that_of_the_header() {
        for (text, skipped, sign) in [
            ("time[s],force\n0,1\n", 0, ','),
            ("# made; by, hand\n\ntime[s];force, total[kN]\n", 0, ';'),
            ("t\tforce\n", 0, '\t'),
            ("\"time[s]\";\"force\"\n", 0, ';'),
            ("sep=;\nx;y\n", 6, ';'),
            ("time[s]\n0\n", 0, ','),
            ("x;y;z\n", 0, ';'),
        ] {
            assert_eq!(separator(text), (skipped, sign), "{text}");
        }
    }

    #[test]
    fn decimal_sign_is_the_first_one() {
        let mut d = Decimals::new(';');
        assert_eq!([d.number("3"), d.number("1,5"), d.number("-2,5e-3")], [Ok(3.0), Ok(1.5), Ok(-2.5e-3)]);
        assert!(d.number("1.5").is_err() && d.number("1.234,5").is_err() && d.number("1,234,5").is_err());
        let mut d = Decimals::new('\t');
        assert_eq!(d.number("1.5"), Ok(1.5));
        assert!(d.number("1,234").is_err());
        assert!(Decimals::new(',').number("1,5").expect_err("no number").contains("semicolons"));
        assert!(Decimals::new(';').number("#N/A").expect_err("no number").contains("empty"));
    }

    #[test]
    fn encodings_give_the_same_text() {
        let text = "time[s],acc[m/s²],θ\n0,1,2\n";
        let utf16 = |to: fn(u16) -> [u8; 2]| text.encode_utf16().flat_map(to).collect::<Vec<u8>>();
        let with = |mark: &[u8], body: Vec<u8>| [mark.to_vec(), body].concat();
        for bytes in [
            text.as_bytes().to_vec(),
            with(&[0xef, 0xbb, 0xbf], text.as_bytes().to_vec()),
            with(&[0xff, 0xfe], utf16(u16::to_le_bytes)),
            with(&[0xfe, 0xff], utf16(u16::to_be_bytes)),
        ] {
            assert_eq!(decode(&bytes).as_deref(), Ok(text));
        }
        let ascii: Vec<u8> = "time,a\n0,1\n".encode_utf16().flat_map(u16::to_le_bytes).collect();
        assert_eq!(decode(&ascii).as_deref(), Ok("time,a\n0,1\n"));
        assert_eq!(decode(b"T[\xb0C],m/s\xb2,\x80").as_deref(), Ok("T[°C],m/s²,€"));
    }

    #[test]
    fn workbooks_and_binary_files_are_refused() {
        for (bytes, said) in
            [(&b"PK\x03\x04.."[..], "xlsx"), (b"\xd0\xcf\x11\xe0\xa1", "(xls)"), (b"\x00\x00\x01\x02\x07", "binary")]
        {
            assert!(decode(bytes).expect_err("no text").0.contains(said));
        }
    }
}
