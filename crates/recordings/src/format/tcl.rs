//! Lists of numbers in a Tcl script: `set acc {...}`, `set dt 0.01`, `timeSeries Path 1 -dt 0.01 -values {...}`.

use super::{Format, Input};
use crate::content::Content;
use crate::fault::Fault;
use crate::number::{NumberLines, number, shown};
use crate::series::Series;

pub(super) const TCL: Format = Format {
    name: "Tcl list",
    recognised_by: "a first line that is no comment and begins with \"set\" or \"timeSeries\"",
    states: "the step of \"set dt\" or \"-dt\"; comments are no statement",
    description: "Tcl 8.6, tutorial of lists; OpenSees, command timeSeries Path",
    is: |input| {
        let first = input.head.iter().map(|l| l.trim()).find(|l| !l.is_empty() && !l.starts_with('#'));
        first.is_some_and(|l| l.starts_with("set ") || l.starts_with("timeSeries "))
    },
    read,
};

/// A list that is open, with its name and the line it began in.
struct Open {
    name: String,
    end: char,
    line: usize,
    numbers: NumberLines,
}

fn read(input: &Input<'_>) -> Result<Content, Fault> {
    let (mut series, mut header): (Vec<Series>, Vec<String>) = (vec![], vec![]);
    let mut dt = None;
    let mut open: Option<Open> = None;
    for (n, line) in input.lines() {
        let mut rest = line.trim();
        if open.is_none() {
            if rest.is_empty() || rest.starts_with('#') {
                header.extend((!rest.is_empty()).then(|| rest.to_owned()));
                continue;
            }
            let (head, values) = statement(n, rest, &mut dt)?;
            header.push(shown(rest).into_owned());
            let Some((end, values)) = values else { continue };
            open = Some(Open { name: head, end, line: n, numbers: NumberLines::default() });
            rest = values;
        }
        let Some(list) = open.as_mut() else { continue };
        let (inside, closed) = match rest.split_once(list.end) {
            Some((inside, after)) => (inside, Some(after)),
            None => (rest, None),
        };
        list.numbers.push(n, inside)?;
        if let (Some(after), Some(list)) = (closed, open.take_if(|_| closed.is_some())) {
            let after = after.trim().trim_end_matches([';', ']', '}', '\\']).trim();
            if let Some(step) = after.strip_prefix("-dt").and_then(|w| number(w.split_whitespace().next()?)) {
                dt = Some(step);
            } else if !after.is_empty() && !after.starts_with(['-', '#']) {
                return Err(Fault::in_line(n, format!("\"{}\" after the list", shown(after))));
            }
            let mut s = Series { name: list.name, ..Series::new(list.numbers.values) };
            s.origin.lines = list.line..n + 1;
            series.push(s);
        }
    }
    if let Some(list) = open {
        return Err(Fault::in_line(list.line, "the list is not closed").expected(format!("expected {}", list.end)));
    }
    series.retain(|s| !s.values.is_empty());
    if series.is_empty() {
        return Err(Fault::new("there is no list of numbers"));
    }
    if let Some(dt) = dt.filter(|dt| *dt > 0.0) {
        series = series.into_iter().map(|s| s.with_step(dt)).collect();
    }
    if let [one] = &mut series[..] {
        one.name.clear();
    }
    Ok(Content::series(series, header, vec![]))
}

/// The name in front of a list, and the list as far as it is in this line, with the character that ends it.
#[allow(clippy::type_complexity)]
fn statement<'a>(n: usize, line: &'a str, dt: &mut Option<f64>) -> Result<(String, Option<(char, &'a str)>), Fault> {
    let unknown =
        || Fault::in_line(n, format!("\"{}\" is no list of numbers", shown(line))).expected("expected set NAME {...}");
    let mut words = line.split_whitespace();
    let (command, name) = (words.next().unwrap_or_default(), words.next().unwrap_or_default());
    let at = line.find(['{', '"']).or_else(|| line.find("[list ").map(|i| i + 5));
    match (command, at) {
        ("set", None) => {
            let value = words.next().map(|w| w.trim_end_matches(';')).and_then(number);
            let value = value.ok_or_else(unknown)?;
            if name.eq_ignore_ascii_case("dt") {
                *dt = Some(value);
            }
            Ok((name.to_owned(), None))
        }
        ("set" | "timeSeries", Some(at)) => {
            let end = match line.as_bytes()[at] {
                b'{' => '}',
                b'"' => '"',
                _ => ']',
            };
            if command == "timeSeries" {
                let before: Vec<&str> = line[..at].split_whitespace().collect();
                let of_step = before.iter().position(|w| *w == "-dt").and_then(|i| number(before.get(i + 1)?));
                *dt = of_step.or(*dt);
                if before.last() != Some(&"-values") {
                    return Err(unknown());
                }
            }
            Ok((name.to_owned(), Some((end, &line[at + 1..]))))
        }
        _ => Err(unknown()),
    }
}
