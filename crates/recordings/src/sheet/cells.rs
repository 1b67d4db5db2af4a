//! Cells of a line: separators, quotes.

use crate::number::number;

/// What separates the cells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Separator {
    /// A character.
    Char(char),
    /// Any number of blanks.
    Blanks,
}

/// Separators in the order in which they are tried.
const CHARS: [char; 3] = [',', ';', '\t'];

/// A cell: its text without quotes and blanks, and its byte range in the line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Cell<'a> {
    pub(crate) text: &'a str,
    pub(crate) range: (usize, usize),
}

impl Separator {
    /// The character; a blank for blanks.
    pub(crate) fn char(self) -> char {
        match self {
            Self::Char(c) => c,
            Self::Blanks => ' ',
        }
    }

    /// The cells of a line, into a vector that is emptied first.
    pub(crate) fn cells<'a>(self, line: &'a str, out: &mut Vec<Cell<'a>>) {
        out.clear();
        match self {
            Self::Blanks => {
                let mut rest = 0;
                for word in line.split_whitespace() {
                    // Words follow each other, so that each is found after the one before.
                    let start = rest + line[rest..].find(word).unwrap_or(0);
                    rest = start + word.len();
                    out.push(Cell { text: word.trim_matches('"'), range: (start, rest) });
                }
            }
            Self::Char(separator) => {
                let mut start = 0;
                loop {
                    let end = cell_end(&line[start..], separator).map_or(line.len(), |at| start + at);
                    out.push(trimmed(line, start, end));
                    if end == line.len() {
                        break;
                    }
                    start = end + separator.len_utf8();
                }
            }
        }
    }
}

/// Bytes before the separator that ends the first cell. Separators within quotes do not end it.
fn cell_end(text: &str, separator: char) -> Option<usize> {
    let quoted = text.trim_start_matches([' ', '\t']).starts_with('"');
    if !quoted {
        return text.find(separator);
    }
    let mut inside = false;
    text.char_indices().find_map(|(i, c)| {
        inside ^= c == '"';
        (c == separator && !inside).then_some(i)
    })
}

fn trimmed(line: &str, start: usize, end: usize) -> Cell<'_> {
    let cell = &line[start..end];
    let inner = cell.trim();
    let start = start + (cell.len() - cell.trim_start().len());
    let unquoted = inner.strip_prefix('"').and_then(|c| c.strip_suffix('"')).map_or(inner, str::trim);
    Cell { text: unquoted, range: (start, start + inner.len()) }
}

/// The separator that a line `sep=;` states, as Excel writes it.
pub(crate) fn stated(line: &str) -> Option<Separator> {
    let c = line.trim_end_matches(['\r', '\n']).strip_prefix("sep=")?.chars().next().unwrap_or('\t');
    CHARS.contains(&c).then_some(Separator::Char(c))
}

/// A cell that stands in a row of numbers: a number with either decimal sign, a missing sample, a time of day, a date.
pub(crate) fn is_data(text: &str, comma_allowed: bool) -> bool {
    is_number(text, comma_allowed) || is_missing(text) || super::clock::parse(text).is_some()
}

/// A number with a point, or with a comma where it is allowed.
pub(crate) fn is_number(text: &str, comma_allowed: bool) -> bool {
    number(text).is_some()
        || (comma_allowed && text.contains(',') && number(&text.replacen(',', ".", 1)).is_some())
        || is_infinite(text)
}

/// A cell that stands for a missing sample.
pub(crate) fn is_missing(text: &str) -> bool {
    text.is_empty() || (text.ends_with(['n', 'N']) && text.parse::<f64>().is_ok_and(f64::is_nan))
}

/// An infinity in the words of programs.
pub(crate) fn is_infinite(text: &str) -> bool {
    text.parse::<f64>().is_ok_and(f64::is_infinite) && !text.starts_with(|c: char| c.is_ascii_digit())
}

/// The separator of lines: that which makes the most of them rows of numbers of one width; else that of the first line.
pub(crate) fn detect(lines: &[&str]) -> Separator {
    let all = CHARS.into_iter().map(Separator::Char).chain([Separator::Blanks]);
    let mut cells = vec![];
    let mut rows = |s: Separator| {
        let (mut count, mut width) = (0, 0);
        for line in lines {
            s.cells(line, &mut cells);
            let comma = s != Separator::Char(',');
            let data = cells.iter().all(|c| is_data(c.text, comma)) && cells.iter().any(|c| is_number(c.text, comma));
            if data && cells.len() > 1 {
                if cells.len() != width {
                    (width, count) = (cells.len(), 0);
                }
                count += 1;
            }
        }
        (count, width)
    };
    let found = all.map(|s| (s, rows(s)));
    // The first of several with as many rows: Char(',') before Char(';') and so on.
    let best = found.fold((Separator::Blanks, (0, 0)), |best, x| if x.1.0 > best.1.0 { x } else { best });
    if best.1.0 > 0 {
        return best.0;
    }
    let header = lines.first().copied().unwrap_or_default();
    let counts = CHARS.into_iter().rev().map(|c| (header.matches(c).count(), c));
    match counts.max() {
        Some((n, c)) if n > 0 => Separator::Char(c),
        _ => Separator::Blanks,
    }
}

#[cfg(test)]
mod tests {
    use super::{Separator, detect};

    #[test]
    fn separator_is_that_of_the_rows() {
        for (text, sign) in [
            ("time[s],force\n0,1\n", Separator::Char(',')),
            ("time[s];force, total[kN]\n0,5;1,5\n", Separator::Char(';')),
            ("t\tforce\n0\t1,5\n", Separator::Char('\t')),
            ("\"time[s]\";\"force\"\n0;1", Separator::Char(';')),
            ("time acc\n0.0 1.5\n", Separator::Blanks),
            ("0.0,\t1.5\n", Separator::Char(',')),
            ("x;y;z\n", Separator::Char(';')),
            ("1\n2\n", Separator::Blanks),
        ] {
            assert_eq!(detect(&text.lines().collect::<Vec<_>>()), sign, "{text}");
        }
    }

    #[test]
    fn cells_have_their_ranges() {
        let mut cells = vec![];
        let line = " 1.5 ,\"a, b\",,x";
        Separator::Char(',').cells(line, &mut cells);
        assert_eq!(cells.iter().map(|c| c.text).collect::<Vec<_>>(), ["1.5", "a, b", "", "x"]);
        assert_eq!(&line[cells[0].range.0..cells[0].range.1], "1.5");
        assert_eq!(&line[cells[3].range.0..cells[3].range.1], "x");
        Separator::Blanks.cells("  1  1 12", &mut cells);
        assert_eq!(cells.iter().map(|c| c.range).collect::<Vec<_>>(), [(2, 3), (5, 6), (7, 9)]);
    }
}
