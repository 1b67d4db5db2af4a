//! Where the names, the units and the rows of a table are.

use super::cells::{Cell, is_data, is_number};
use super::clock::parse as parse_stamp;
use super::rows::Line;
use super::{Form, Separator, head};
use crate::number::resembles_number;

/// Where the parts of a table are, as indices of the sample's lines.
pub(super) struct Layout {
    pub(super) names: Option<usize>,
    pub(super) units: Option<usize>,
    /// The first row that is no header.
    pub(super) rows: usize,
}

/// A name of a column and not a number that is misspelt.
pub(super) fn is_name(cell: &str) -> bool {
    let like_number =
        cell.starts_with(|c: char| c.is_ascii_digit() || matches!(c, '+' | '-' | '.')) || cell.contains('.');
    !(is_number(cell, true) || (like_number && resembles_number(cell)))
}

/// What a line may be.
struct Kind {
    /// Cells, and cells up to the last that is not empty.
    full: usize,
    filled: usize,
    /// All cells stand in rows of numbers, and one is a number.
    is_data: bool,
    /// One cell is a number.
    has_number: bool,
}

impl Kind {
    /// Both may be rows of one table, whose last cells may be empty.
    fn fits(&self, other: &Self) -> bool {
        self.filled <= other.full && other.filled <= self.full
    }
}

pub(super) fn filled(cells: &[Cell<'_>]) -> usize {
    cells.iter().rposition(|c| !c.text.is_empty()).map_or(0, |i| i + 1)
}

pub(super) fn layout(sample: &[Line<'_>], separator: Separator, form: &Form<'_>) -> Option<Layout> {
    let comma = separator != Separator::Char(',');
    let mut cells = vec![];
    let mut kinds = vec![];
    for line in sample {
        separator.cells(line.text, &mut cells);
        let has_number = cells.iter().any(|c| is_number(c.text, comma));
        let is_data = has_number && cells.iter().all(|c| is_data(c.text, comma));
        kinds.push(Kind { full: cells.len(), filled: filled(&cells), is_data, has_number });
    }
    let pair = kinds.windows(2).position(|w| w[0].is_data && w[1].is_data && w[0].fits(&w[1]));
    // Without two rows alike: the first row of numbers, or the first line with a number at all, whose fault is told.
    let first = || kinds.iter().position(|k| k.is_data);
    let some = || kinds.iter().skip(1).position(|k| k.has_number).map(|i| i + 1);
    let start = pair.or_else(first).or_else(some)?;
    let least =
        kinds[start..].iter().take(2).filter(|k| k.is_data).map(|k| k.filled).max().unwrap_or(kinds[start].filled);
    let mut block = start;
    let mut fits = |i: usize| {
        split_names(separator, sample[i].text, least, &mut cells);
        let most = if form.short_rows { usize::MAX } else { kinds[start].full };
        (least..=most).contains(&filled(&cells))
            || (cells.len() >= least && !cells.iter().all(|c| is_name(c.text))) && cells.len() == kinds[start].full
    };
    while block > 0 && fits(block - 1) {
        block -= 1;
    }
    let (mut names, mut units, mut rows) = (None, None, block);
    let is_head = |i: usize| {
        let mut own = vec![];
        split_names(separator, sample[i].text, least, &mut own);
        let heads =
            own.iter().all(|c| is_name(c.text)) || own.first().is_some_and(|c| head::time_head(c.text).is_some());
        heads && filled(&own) > 0 && !own.iter().any(|c| parse_stamp(c.text).is_some())
    };
    let is_units = |i: usize| {
        let mut own = vec![];
        split_names(separator, sample[i].text, least, &mut own);
        head::units_row(own.iter().map(|c| c.text)).is_some()
    };
    // The heads nearest to the rows: lines of the header above them may have as many cells.
    if let Some(at) = (block..start).rev().find(|i| is_head(*i)) {
        if at > block && is_units(at) && is_head(at - 1) {
            (names, units, rows) = (Some(at - 1), Some(at), at + 1);
        } else {
            (names, rows) = (Some(at), at + 1);
        }
    } else if let Some(at) = names_above_numbers(sample, separator, least) {
        // A row of another width stands between the names and the rows: it is the fault.
        (names, rows) = (Some(at), at + 1);
    } else if block == start && start == 1 && separator != Separator::Blanks && kinds[0].full > 1 {
        // One line before rows of another width: a header that does not fit.
        separator.cells(sample[0].text, &mut cells);
        if cells.iter().all(|c| is_name(c.text)) {
            (names, rows) = (Some(0), 1);
        }
    }
    Some(Layout { names, units, rows })
}

/// The line of names, of the width of the rows, right above the first line of numbers.
fn names_above_numbers(sample: &[Line<'_>], separator: Separator, width: usize) -> Option<usize> {
    let first = sample.iter().position(|l| has_numbers(l.text, separator))?.checked_sub(1)?;
    let mut cells = vec![];
    split_names(separator, sample[first].text, width, &mut cells);
    let is_head = width > 1 && filled(&cells) == width && cells.iter().all(|c| is_name(c.text));
    is_head.then_some(first)
}

/// A line of which half of the cells or more are numbers.
pub(super) fn has_numbers(line: &str, separator: Separator) -> bool {
    let mut cells = vec![];
    separator.cells(line, &mut cells);
    let numbers = cells.iter().filter(|c| is_number(c.text, separator != Separator::Char(','))).count();
    numbers > 0 && 2 * numbers >= cells.len()
}

/// The names in a header: between blanks a unit in brackets belongs to the word before it.
pub(super) fn split_names<'a>(separator: Separator, line: &'a str, width: usize, cells: &mut Vec<Cell<'a>>) {
    separator.cells(line, cells);
    if separator != Separator::Blanks || cells.len() == width {
        return;
    }
    let mut merged: Vec<Cell<'a>> = vec![];
    for cell in cells.iter() {
        match merged.last_mut() {
            Some(last) if cell.text.starts_with(['[', '(']) => {
                last.range.1 = cell.range.1;
                last.text = &line[last.range.0..last.range.1];
            }
            _ => merged.push(*cell),
        }
    }
    if merged.len() == width {
        *cells = merged;
        return;
    }
    // Names of several words have two blanks or more between them.
    let mut wide = vec![];
    let mut at = 0;
    for part in line.split("  ").filter(|p| !p.trim().is_empty()) {
        let word = part.trim();
        let start = at + line[at..].find(word).unwrap_or(0);
        at = start + word.len();
        wide.push(Cell { text: word, range: (start, at) });
    }
    if wide.len() == width {
        *cells = wide;
    }
}
