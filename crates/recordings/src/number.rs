//! Numbers as instruments and programs write them: Fortran's exponents, decimal commas, fixed widths without blanks.

use crate::fault::Fault;
use std::borrow::Cow;

/// The number of a word. `1.5D-02` and `1.5d2` are those of Fortran. `None` for anything else, and for infinities.
pub(crate) fn number(word: &str) -> Option<f64> {
    let parsed = word.parse::<f64>();
    if let Ok(x) = parsed {
        return Some(x).filter(|x| x.is_finite());
    }
    // A mantissa with digits before the letter: a word such as `d2` is none.
    let at = word.find(['D', 'd']).filter(|at| word[..*at].ends_with(|c: char| c.is_ascii_digit() || c == '.'))?;
    format!("{}e{}", &word[..at], &word[at + 1..]).parse().ok().filter(|x: &f64| x.is_finite())
}

/// A whole number that is written as one.
pub(crate) fn whole(word: &str) -> Option<usize> {
    word.trim().parse().ok()
}

/// Half or more of the characters are digits: a number that is misspelt rather than a word.
pub(crate) fn resembles_number(word: &str) -> bool {
    let digits = word.chars().filter(char::is_ascii_digit).count();
    digits > 0 && 2 * digits >= word.chars().count()
}

/// Reads numbers whose decimal sign the first of them decides.
pub(crate) struct Decimals {
    /// A comma may be the decimal sign, since it does not separate the cells.
    comma_allowed: bool,
    sign: Option<char>,
}

impl Decimals {
    /// Numbers between separators.
    pub(crate) fn new(separator: char) -> Self {
        Self { comma_allowed: separator != ',', sign: None }
    }

    /// Numbers between separators, with a decimal sign that the file states.
    pub(crate) fn stated(separator: char, sign: char) -> Self {
        Self { sign: Some(sign), ..Self::new(separator) }
    }

    /// The number in a cell.
    ///
    /// # Errors
    /// Advice on what to save instead; empty where there is none.
    pub(crate) fn number(&mut self, cell: &str) -> Result<f64, &'static str> {
        if self.sign == Some('.')
            && let Some(value) = number(cell)
        {
            return Ok(value);
        }
        if !cell.contains(',') {
            let value = number(cell).ok_or(if cell.starts_with('#') { "leave missing samples empty" } else { "" })?;
            if !cell.contains('.') {
                return Ok(value);
            }
            let sign = *self.sign.get_or_insert('.');
            return if sign == '.' { Ok(value) } else { Err("save all numbers with one decimal sign") };
        }
        let value = number(&cell.replacen(',', ".", 1));
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

/// Narrowest and widest number of a fixed width.
const WIDTHS: std::ops::RangeInclusive<usize> = 5..=25;

/// The cells of a line of numbers of one width, right-aligned. `None` if the line is no such line.
pub(crate) fn fixed_cells(line: &str, width: usize) -> Option<Vec<&str>> {
    let line = line.trim_end();
    if !line.is_ascii() || line.is_empty() || width == 0 || !line.len().is_multiple_of(width) {
        return None;
    }
    let cells = (0..line.len() / width).map(|i| &line[i * width..(i + 1) * width]);
    cells.map(|c| Some(c.trim_start()).filter(|c| !c.is_empty() && !c.ends_with(' '))).collect()
}

/// The numbers of a line that only their signs separate, as in `-70.445491-100.472561`. They have as many decimals.
fn signed_pieces(line: &str) -> Option<Vec<f64>> {
    let (mut out, mut decimals) = (vec![], None);
    for word in line.split_whitespace() {
        let mut start = 0;
        let signs = word
            .match_indices(['-', '+'])
            .map(|(i, _)| i)
            .filter(|i| word[..*i].ends_with(|c: char| c.is_ascii_digit()));
        for end in signs.chain([word.len()]).collect::<Vec<_>>() {
            let piece = &word[start..end];
            let digits = piece.split_once('.')?.1;
            if !digits.bytes().all(|b| b.is_ascii_digit()) || *decimals.get_or_insert(digits.len()) != digits.len() {
                return None;
            }
            out.push(number(piece)?);
            start = end;
        }
    }
    Some(out)
}

/// Numbers of lines in the order of reading, between blanks or commas, or of a fixed width without blanks.
#[derive(Default)]
pub(crate) struct NumberLines {
    /// The numbers.
    pub(crate) values: Vec<f64>,
    /// Width of the numbers, once a line without blanks has shown it.
    width: Option<usize>,
}

impl NumberLines {
    /// Take the numbers of a line. A `\`, `&` or `...` at its end continues the list, and is no number.
    ///
    /// # Errors
    /// Something that is no number, with the line.
    pub(crate) fn push(&mut self, number_of_line: usize, line: &str) -> Result<(), Fault> {
        let line = line.trim_end();
        let continued = ["\\", "&", "..."].iter().find_map(|mark| line.strip_suffix(mark));
        let line = continued.unwrap_or(line);
        if commas_may_be_decimal(line) {
            let message = format!("\"{}\" has commas between whole numbers", shown(line));
            return Err(Fault::in_line(number_of_line, message).expected(
                "expected decimals with a point, or cells with semicolons, if the commas are decimal signs",
            ));
        }
        let before = self.values.len();
        let words = line.split(|c: char| c.is_whitespace() || c == ',' || c == ';').filter(|w| !w.is_empty());
        for word in words {
            let Some(x) = number(word) else {
                self.values.truncate(before);
                return self.push_fixed(number_of_line, line, word);
            };
            self.values.push(x);
        }
        Ok(())
    }

    fn push_fixed(&mut self, number_of_line: usize, line: &str, wrong: &str) -> Result<(), Fault> {
        let values = |width: usize| fixed_cells(line, width)?.into_iter().map(number).collect::<Option<Vec<f64>>>();
        let read = match self.width {
            Some(width) => values(width),
            None => {
                // Numbers of one Fortran format have as many decimals; of several widths that fit none is sure.
                let decimals =
                    |c: &&str| c.split_once('.').map(|(_, d)| d.bytes().take_while(u8::is_ascii_digit).count());
                let same = |w: usize| {
                    let cells = fixed_cells(line, w).unwrap_or_default();
                    cells.iter().map(decimals).all(|d| d.is_some() && d == cells.first().and_then(decimals))
                };
                let mut fitting = WIDTHS.filter_map(|w| Some((w, values(w).filter(|v| v.len() > 1 && same(w))?)));
                fitting.next().filter(|_| fitting.next().is_none()).map(|(width, values)| {
                    self.width = Some(width);
                    values
                })
            }
        };
        let values = read.or_else(|| signed_pieces(line)).ok_or_else(|| {
            let comma = number(&wrong.replacen(',', ".", 1)).is_some();
            let help = if comma { "save decimals with a point" } else { "" };
            Fault::in_line(number_of_line, format!("\"{wrong}\" is not a number")).help(help)
        })?;
        self.values.extend(values);
        Ok(())
    }
}

/// Commas between digits, and no point: `0,25 0,5` may be two numbers or four.
pub(crate) fn commas_may_be_decimal(line: &str) -> bool {
    let digit = |b: u8| b.is_ascii_digit();
    line.contains(',')
        && !line.contains('.')
        && line.as_bytes().windows(3).any(|w| w[1] == b',' && digit(w[0]) && digit(w[2]))
}

/// The first numbers of a header text, whatever stands between them.
pub(crate) fn header_numbers(line: &str) -> Vec<f64> {
    line.split(|c: char| !(c.is_ascii_digit() || c == '.')).filter_map(|w| w.parse().ok()).collect()
}

/// A line shortened for a message.
pub(crate) fn shown(line: &str) -> Cow<'_, str> {
    const LONGEST: usize = 60;
    let line = line.trim();
    match line.char_indices().nth(LONGEST) {
        Some((end, _)) => Cow::Owned(format!("{} ...", &line[..end])),
        None => Cow::Borrowed(line),
    }
}

#[cfg(test)]
mod tests {
    use super::{Decimals, NumberLines, number};

    #[test]
    fn exponents_of_fortran() {
        for (word, value) in [("1.5D-02", 0.015), ("-2d3", -2e3), (".5E1", 5.0), ("7.", 7.0)] {
            assert_eq!(number(word), Some(value), "{word}");
        }
        assert!(["d2", "1.2.3", "inf", "nan", "", "1D", "0x1d2"].iter().all(|w| number(w).is_none()));
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
    fn lines_of_a_fixed_width_need_no_blanks() {
        let mut lines = NumberLines::default();
        lines.push(1, "  0.750222-10.261010").expect("numbers");
        lines.push(2, "-10.750222-10.261010 12.500000 \\").expect("numbers");
        assert_eq!(lines.values, [0.750222, -10.26101, -10.750222, -10.26101, 12.5]);
        // A character is missing: neither the columns nor the decimals are whole.
        assert!(lines.push(3, "-10.75022-10.261010").is_err());
        lines.push(4, "-70.445491-100.472561 1.000000").expect("numbers");
        assert_eq!(lines.values[5..], [-70.445491, -100.472561, 1.0]);
        assert!(lines.push(5, "0.1234567-100").is_err());
        assert!(lines.push(4, "1.2.3 4.5").is_err());
    }
}
