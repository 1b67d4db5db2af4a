//! Numbers alone: a list in the order of reading, in lines of any length.

use super::{Format, Input};
use crate::content::Content;
use crate::fault::Fault;
use crate::number::{NumberLines, number, resembles_number, shown, whole};
use crate::series::{Clock, Series};
use crate::sheet::HEADER_LINES;
use crate::stated::Stated;

pub(super) const COUNTED: Format = Format {
    name: "counted list",
    recognised_by: "a first line of a whole number and a step below 1, and as many values after it",
    states: "step, number of values",
    description: "lists that begin with NPTS and DT, as programs of response analysis read them",
    is: |input| counted_head(input).is_some(),
    read: counted,
};

/// Count and step of the first line, if as many numbers follow. (Lines of two numbers are a table.)
fn counted_head(input: &Input<'_>) -> Option<(usize, f64)> {
    let mut words = input.head.first()?.split(|c: char| c.is_whitespace() || c == ',').filter(|w| !w.is_empty());
    let (count, step) = (whole(words.next()?)?, number(words.next()?)?);
    let second = input.head.get(1)?.split_whitespace().count();
    if words.next().is_some() || count < 3 || !(step > 0.0 && step < 1.0) || second == 2 {
        return None;
    }
    let there =
        input.text.lines().skip(1).flat_map(str::split_whitespace).take(count + 1).filter(|w| number(w).is_some());
    (there.count() == count).then_some((count, step))
}

fn counted(input: &Input<'_>) -> Result<Content, Fault> {
    let (_, dt) = counted_head(input).ok_or_else(|| Fault::new("there is no count"))?;
    let mut numbers = NumberLines::default();
    let mut last = 1;
    for (n, line) in input.lines().skip(1) {
        numbers.push(n, line)?;
        last = n;
    }
    let mut series = Series::new(numbers.values).with_step(dt);
    series.origin.lines = 2..last + 1;
    Ok(Content::series(vec![series], vec![input.head[0].to_owned()], vec![]))
}

/// A list of numbers below lines of text.
pub(super) fn read(input: &Input<'_>) -> Result<Content, Fault> {
    let mut numbers = NumberLines::default();
    let (mut header, mut notes): (Vec<String>, Vec<String>) = (vec![], vec![]);
    let (mut first, mut last) = (0, 0);
    let mut counts = vec![];
    let mut comments = vec![];
    for (n, line) in input.lines() {
        let text = line.trim();
        if text.is_empty() || text.starts_with(['#', '%']) {
            if first == 0 && !text.is_empty() && comments.len() < HEADER_LINES {
                comments.push(text.to_owned());
            }
            continue;
        }
        let before = numbers.values.len();
        let Err(fault) = numbers.push(n, line) else {
            counts.push(numbers.values.len() - before);
            first = if first == 0 { n } else { first };
            last = n;
            continue;
        };
        // A misspelt number, or one beside a word, is no header.
        let misspelt =
            text.split_whitespace().all(resembles_number) || text.starts_with(|c: char| c.is_ascii_digit() || c == '.');
        if first > 0 || misspelt {
            return Err(fault);
        }
        header.push(text.to_owned());
    }
    if numbers.values.is_empty() {
        return Err(Fault::new("there are no numbers"));
    }
    // A first line of another length than all others is a header rather than a part of the list.
    if let [one, others @ .., end] = &counts[..]
        && let Some(width) = others.first().filter(|w| **w > 1 && *w != one)
        && others.len() > 2
        && others.iter().all(|w| w == width)
        && end <= width
    {
        let message = format!("there are {one} numbers in the line, and {width} in those after it");
        return Err(Fault::in_line(first, message).expected("expected numbers alone: remove a header of numbers"));
    }
    if let Some(line) = header.last() {
        notes.push(format!("{} before the numbers is taken for a header: \"{}\"", lines(header.len()), shown(line)));
    }
    let mut series = Series::new(numbers.values);
    series.origin.lines = first..last + 1;
    comments.extend(header);
    let stated = Stated::of(&comments);
    if let Some(dt) = stated.dt {
        series.clock = Clock::Steps { start: 0.0, dt };
    }
    stated.unit.into_iter().for_each(|u| series.set_unit(u));
    Ok(Content::series(vec![series], comments, notes))
}

fn lines(n: usize) -> String {
    if n == 1 { "one line".into() } else { format!("the last of {n} lines") }
}
