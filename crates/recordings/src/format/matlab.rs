//! MATLAB's `.mat` files, level 5: vectors and matrices of numbers.

use super::array::{Element, sheet};
use super::{Format, Input};
use crate::content::{Content, MAX_UNPACKED};
use crate::fault::Fault;
use crate::series::Series;
use crate::sheet::{Column, Sheet, head};
use crate::unit::Quantity;

pub(super) const MAT: Format = Format {
    name: "MATLAB",
    recognised_by: "\"MATLAB 5.0 MAT-file\" at the begin",
    states: "names of the variables as those of columns; the step of a number named dt, or the rate of one named Fs",
    description: "MathWorks, MAT-File Format, version 5",
    is: |input| input.bytes.starts_with(b"MATLAB "),
    read,
};

const HEADER: usize = 128;
const MATRIX: u32 = 14;
const COMPRESSED: u32 = 15;

/// A variable: its name and numbers by columns.
struct Variable {
    name: String,
    rows: usize,
    columns: usize,
    values: Vec<f64>,
}

/// An element: its type, its data, and the bytes after it.
fn element(bytes: &[u8], little: bool) -> Option<(u32, &[u8], &[u8])> {
    let word = |at: usize| {
        let four: [u8; 4] = bytes.get(at..at + 4)?.try_into().ok()?;
        Some(if little { u32::from_le_bytes(four) } else { u32::from_be_bytes(four) })
    };
    let tag = word(0)?;
    // Up to four bytes of data stand in the tag itself.
    if tag >> 16 != 0 {
        let n = (tag >> 16) as usize;
        return Some((tag & 0xffff, bytes.get(4..4 + n.min(4))?, bytes.get(8..)?));
    }
    let n = word(4)? as usize;
    let data = bytes.get(8..8usize.checked_add(n)?)?;
    let padded = if tag == COMPRESSED { n } else { n.div_ceil(8) * 8 };
    Some((tag, data, bytes.get((8 + padded).min(bytes.len())..)?))
}

fn kind(tag: u32) -> Option<Element> {
    Some(match tag {
        1 => Element::Signed(1),
        2 => Element::Unsigned(1),
        3 => Element::Signed(2),
        4 => Element::Unsigned(2),
        5 => Element::Signed(4),
        6 => Element::Unsigned(4),
        7 => Element::F4,
        9 => Element::F8,
        12 => Element::Signed(8),
        13 => Element::Unsigned(8),
        _ => return None,
    })
}

/// The variable of a matrix element; `None` if it is text, a cell, a structure or complex.
fn variable(data: &[u8], little: bool) -> Option<Variable> {
    let (_, flags, rest) = element(data, little)?;
    let class = *if little { flags.first()? } else { flags.get(3)? };
    let bits = *if little { flags.get(1)? } else { flags.get(2)? };
    if !(6..=15).contains(&class) || bits & 0x08 != 0 {
        return None;
    }
    let (tag, dims, rest) = element(rest, little)?;
    let of = |tag: u32, data: &[u8]| {
        let e = kind(tag)?;
        Some(data.chunks_exact(e.size()).map(|b| e.value(b, little)).collect::<Vec<f64>>())
    };
    let dims = of(tag, dims)?;
    let (_, name, rest) = element(rest, little)?;
    let (tag, numbers, _) = element(rest, little)?;
    let [rows, columns] = dims[..] else { return None };
    let values = of(tag, numbers)?;
    let (rows, columns) = (rows as usize, columns as usize);
    (rows.checked_mul(columns)? == values.len()).then(|| Variable {
        name: String::from_utf8_lossy(name).into_owned(),
        rows,
        columns,
        values,
    })
}

fn read(input: &Input<'_>) -> Result<Content, Fault> {
    if !input.bytes.starts_with(b"MATLAB 5.0") {
        return Err(Fault::new("is a MAT-file of another version").help("save it with save -v7"));
    }
    let damaged = || Fault::new("the MAT-file is damaged: an element ends beyond the file");
    let little = match input.bytes.get(126..128).ok_or_else(damaged)? {
        b"IM" => true,
        b"MI" => false,
        _ => return Err(Fault::new("the MAT-file does not state the order of its bytes")),
    };
    let mut rest = &input.bytes[HEADER..];
    let (mut variables, mut left_out) = (vec![], 0);
    while rest.len() >= 8 {
        let (tag, data, after) = element(rest, little).ok_or_else(damaged)?;
        rest = after;
        let found = match tag {
            MATRIX => variable(data, little),
            COMPRESSED => {
                let inflated = miniz_oxide::inflate::decompress_to_vec_zlib_with_limit(data, MAX_UNPACKED)
                    .map_err(|e| Fault::new(format!("the MAT-file is damaged: {e}")))?;
                let (tag, data, _) = element(&inflated, little).ok_or_else(damaged)?;
                (tag == MATRIX).then(|| variable(data, little)).flatten()
            }
            _ => None,
        };
        match found {
            Some(v) => variables.push(v),
            None => left_out += 1,
        }
    }
    let mut notes = vec![];
    if left_out > 0 {
        notes.push(format!("{left_out} variables are no vectors or matrices of real numbers"));
    }
    content(variables, notes)
}

fn content(variables: Vec<Variable>, notes: Vec<String>) -> Result<Content, Fault> {
    let scalar = |v: &&Variable| v.values.len() == 1;
    let number = |name: &str| variables.iter().find(|v| scalar(v) && v.name.eq_ignore_ascii_case(name));
    // A step in s, or a sampling rate in Hz.
    let dt = number("dt").map(|v| v.values[0]).or_else(|| number("fs").map(|v| 1.0 / v.values[0]));
    let header = variables.iter().filter(scalar).map(|v| format!("{} = {}", v.name, v.values[0])).collect();
    let mut columns: Vec<Column> = vec![];
    for v in variables.iter().filter(|v| v.values.len() > 1) {
        let parts = sheet(&v.values, v.rows, v.columns, true).columns;
        let several = parts.len() > 1;
        let name = |i: usize| if several { format!("{}({})", v.name, i + 1) } else { v.name.clone() };
        columns.extend(parts.into_iter().enumerate().map(|(i, c)| Column { cell: name(i), ..c }));
    }
    if columns.is_empty() {
        return Err(Fault::new("the MAT-file has no vector of numbers").help("save vectors, not structures"));
    }
    // The columns of a single matrix have no names of their own.
    let matrix = variables.iter().filter(|v| v.values.len() > 1).count() == 1 && columns.len() > 1;
    if matrix && dt.is_none() {
        columns.iter_mut().for_each(|c| c.cell.clear());
        return Ok(Content::Table(Sheet { header, columns, notes, ..Sheet::default() }));
    }
    let same = columns.iter().all(|c| c.values.len() == columns[0].values.len());
    if same && dt.is_none() {
        return Ok(Content::Table(Sheet { header, named: true, columns, notes, ..Sheet::default() }));
    }
    let series = columns.into_iter().map(|c| {
        let (name, unit) = head::known_unit(&c.cell);
        let quantity = unit.map(|u| u.quantity).or_else(|| Quantity::of_head(&name));
        let s = Series { name, unit, quantity, ..Series::new(c.values) };
        match dt {
            Some(dt) if dt > 0.0 && dt.is_finite() => s.with_step(dt),
            _ => s,
        }
    });
    Ok(Content::series(series.collect(), header, notes))
}
