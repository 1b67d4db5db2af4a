//! JSON: an object of arrays, an array of objects, or channels with their units.

use super::{Format, Input};
use crate::content::Content;
use crate::fault::Fault;
use crate::series::{Clock, Series};
use crate::sheet::{Column, Sheet, head};
use crate::unit::{self, Quantity};
use serde_json::{Map, Value};

pub(super) const JSON: Format = Format {
    name: "JSON",
    recognised_by: "a text that begins with { or [{",
    states: "names as those of columns; dt, unit and quantity where they are members beside the values",
    description: "RFC 8259; forms: {\"time\": [...], \"acc[g]\": [...]}, [{\"time\": 0, \"acc[g]\": 1}, ...], {\"dt\": 0.01, \"unit\": \"g\", \"values\": [...]}, {\"channels\": [...]}",
    is: |input| {
        let text = input.text.trim_start();
        text.starts_with('{') || text.strip_prefix('[').is_some_and(|rest| rest.trim_start().starts_with('{'))
    },
    read,
};

/// Largest text that is read: its values take many times its size.
const MAX_SIZE: usize = 64 << 20;

fn read(input: &Input<'_>) -> Result<Content, Fault> {
    if input.text.len() > MAX_SIZE {
        return Err(Fault::new(format!("is JSON of more than {} MB", MAX_SIZE >> 20)).help("save it as CSV"));
    }
    let value: Value =
        serde_json::from_str(input.text).map_err(|e| Fault::in_line(e.line(), format!("no JSON: {e}")))?;
    match value {
        Value::Array(rows) => objects(&rows),
        Value::Object(members) => object(&members),
        _ => Err(Fault::new("the JSON is neither an object nor an array of objects")),
    }
}

/// The number of a value; missing for null.
fn sample(value: &Value, place: &str) -> Result<f64, Fault> {
    match value {
        Value::Null => Ok(f64::NAN),
        Value::Number(n) => n.as_f64().filter(|x| x.is_finite()).ok_or_else(|| Fault::new(format!("{place} is {n}"))),
        other => Err(Fault::new(format!("{place} is not a number: {other}"))),
    }
}

fn samples(name: &str, values: &[Value]) -> Result<Vec<f64>, Fault> {
    values.iter().enumerate().map(|(i, v)| sample(v, &format!("value {} of {name}", i + 1))).collect()
}

/// A table of columns, the time first: members of an object have no order.
fn table(mut columns: Vec<Column>, header: Vec<String>) -> Content {
    columns.sort_by_key(|c| head::time_column(&c.cell, &c.unit).is_none());
    Content::Table(Sheet { named: true, columns, header, ..Sheet::default() })
}

/// Rows as objects with the same members.
fn objects(rows: &[Value]) -> Result<Content, Fault> {
    let members = |i: usize| rows[i].as_object().ok_or_else(|| Fault::new(format!("element {} is no object", i + 1)));
    let first = members(0)?;
    let mut columns: Vec<Column> = first.keys().map(|k| Column { cell: k.clone(), ..Column::default() }).collect();
    for i in 0..rows.len() {
        let row = members(i)?;
        if let Some(other) = row.keys().find(|k| !first.contains_key(*k)) {
            return Err(Fault::new(format!("element {} has a member \"{other}\" that the first has not", i + 1)));
        }
        for column in &mut columns {
            let place = format!("{} of element {}", column.cell, i + 1);
            column.values.push(sample(row.get(&column.cell).unwrap_or(&Value::Null), &place)?);
        }
    }
    Ok(table(columns, vec![]))
}

fn object(members: &Map<String, Value>) -> Result<Content, Fault> {
    if let Some(channels) = members.get("channels").and_then(Value::as_array) {
        let of = |i: usize, v: &Value| {
            let o = v.as_object().ok_or_else(|| Fault::new(format!("channel {} is no object", i + 1)))?;
            channel(o, members)
        };
        let all = channels.iter().enumerate().map(|(i, v)| of(i, v)).collect::<Result<Vec<_>, _>>()?;
        return Ok(Content::series(all, header(members), vec![]));
    }
    if members.contains_key("values") || members.contains_key("data") {
        return Ok(Content::series(vec![channel(members, members)?], header(members), vec![]));
    }
    let mut columns = vec![];
    for (key, value) in members {
        if let Some(values) = value.as_array() {
            columns.push(Column { cell: key.clone(), values: samples(key, values)?, ..Column::default() });
        }
    }
    if columns.is_empty() {
        return Err(Fault::new("the JSON has no array of numbers"));
    }
    if let Some(c) = columns.iter().find(|c| c.values.len() != columns[0].values.len()) {
        let (a, b) = (&columns[0], c);
        let message = format!("{} has {} values, {} has {}", a.cell, a.values.len(), b.cell, b.values.len());
        return Err(Fault::new(message).expected("expected as many"));
    }
    let step = step(members)?;
    if step.is_none() {
        return Ok(table(columns, header(members)));
    }
    // A unit beside the arrays is that of a single one.
    let beside = ["unit", "units"].iter().find_map(|k| members.get(*k)?.as_str()).filter(|_| columns.len() == 1);
    let mut series = vec![];
    for c in columns {
        let (name, unit) = crate::sheet::head::known_unit(&c.cell);
        let unit = unit.or_else(|| beside.and_then(unit::header_unit));
        let said = Quantity::of_head(&name);
        if let (Some(u), Some(q)) = (unit, said.filter(|q| unit.is_some_and(|u| u.quantity != *q))) {
            return Err(Fault::new(format!("the unit {} is {}, the name says {}", u.name, u.quantity, q.word())));
        }
        let unit_name = unit.map_or_else(|| beside.unwrap_or_default().to_owned(), |u| u.name.to_owned());
        let quantity = unit.map(|u| u.quantity).or(said);
        series.push(Series { name, unit, unit_name, quantity, clock: clock(step, 0.0), ..Series::new(c.values) });
    }
    Ok(Content::series(series, header(members), vec![]))
}

fn clock(step: Option<f64>, start: f64) -> Clock {
    step.map_or(Clock::Unknown, |dt| Clock::Steps { start, dt })
}

/// The members that are no arrays, for messages.
fn header(members: &Map<String, Value>) -> Vec<String> {
    members.iter().filter(|(_, v)| !v.is_array()).map(|(k, v)| format!("{k}: {v}")).collect()
}

fn step(members: &Map<String, Value>) -> Result<Option<f64>, Fault> {
    match members.iter().find(|(k, _)| k.eq_ignore_ascii_case("dt")) {
        None => Ok(None),
        Some((_, value)) => {
            let dt = value.as_f64().filter(|dt| *dt > 0.0 && dt.is_finite());
            dt.map(Some).ok_or_else(|| Fault::new(format!("dt is {value}")).expected("expected a step in s"))
        }
    }
}

/// A channel: its values, and its name, unit, quantity and step where it has them.
fn channel(of: &Map<String, Value>, file: &Map<String, Value>) -> Result<Series, Fault> {
    let text = |key: &str| of.get(key).or_else(|| file.get(key)).and_then(Value::as_str).unwrap_or_default().to_owned();
    let name = of.get("name").and_then(Value::as_str).unwrap_or_default().to_owned();
    let values = of.get("values").or_else(|| of.get("data")).and_then(Value::as_array);
    let values = values.ok_or_else(|| Fault::new(format!("the channel \"{name}\" has no array \"values\"")))?;
    let unit_name = [text("unit"), text("units")].into_iter().find(|w| !w.is_empty()).unwrap_or_default();
    let unit = unit::header_unit(&unit_name);
    let said = Quantity::named(&text("quantity"));
    if let (Some(u), Some(q)) = (unit, said)
        && u.quantity != q
    {
        return Err(Fault::new(format!("the unit {} is {}, the quantity is {}", u.name, u.quantity, q.word())));
    }
    let quantity = unit.map(|u| u.quantity).or(said).or_else(|| Quantity::of_head(&name));
    let dt = match step(of)? {
        None => step(file)?,
        some => some,
    };
    let start = of.get("start").and_then(Value::as_f64).unwrap_or(0.0);
    let values = samples(if name.is_empty() { "values" } else { &name }, values)?;
    Ok(Series {
        name,
        unit,
        unit_name,
        quantity,
        station: text("station"),
        clock: clock(dt, start),
        ..Series::new(values)
    })
}
