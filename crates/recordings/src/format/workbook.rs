//! Workbooks: the first sheet of `.xlsx` and `.ods`.

use super::xml::{Piece, Pieces, attribute, unescaped};
use super::{Format, Input};
use crate::archive::Zip;
use crate::content::Content;
use crate::fault::Fault;
use crate::sheet::{Form, Separator, Sheet};

pub(super) const XLSX: Format = Format {
    name: "xlsx",
    recognised_by: "an archive with xl/workbook.xml",
    states: "as a table; the first sheet with cells",
    description: "ECMA-376, Office Open XML, part 1: SpreadsheetML",
    is: |input| Zip::is_zip(input.bytes) && !is_ods(input),
    read: read_xlsx,
};

pub(super) const ODS: Format = Format {
    name: "ods",
    recognised_by: "an archive with the media type of a spreadsheet",
    states: "as a table; the first sheet with cells",
    description: "OASIS, OpenDocument format for office applications, version 1.2, part 1",
    is: is_ods,
    read: read_ods,
};

fn is_ods(input: &Input<'_>) -> bool {
    const TYPE: &[u8] = b"mimetypeapplication/vnd.oasis.opendocument.spreadsheet";
    Zip::is_zip(input.bytes) && input.bytes.get(30..30 + TYPE.len()) == Some(TYPE)
}

/// Most columns and rows of a sheet that is read.
const MAX_COLUMNS: usize = 1024;
const MAX_ROWS: usize = 1 << 20;

fn too_large() -> Fault {
    Fault::new(format!("the sheet has more than {MAX_ROWS} rows or {MAX_COLUMNS} columns"))
}

/// Rows of cells as text.
type Rows = Vec<Vec<String>>;

/// The table of the rows, with the numbers of the sheet's rows as lines.
fn table(rows: &Rows, name: &str) -> Result<Content, Fault> {
    const SEPARATOR: char = '\u{1f}';
    let width = rows.iter().map(Vec::len).max().unwrap_or(0);
    let mut text = String::new();
    for row in rows {
        for i in 0..width {
            if i > 0 {
                text.push(SEPARATOR);
            }
            // A line of the text is a row of the sheet.
            text.extend(row.get(i).map_or("", String::as_str).chars().map(|c| if c.is_control() { ' ' } else { c }));
        }
        text.push('\n');
    }
    let separator = Some(Separator::Char(SEPARATOR));
    let sheet = Sheet::parse(&text, &Form { name, separator, decimal: Some('.'), ..Form::default() })?;
    Ok(Content::Table(sheet))
}

/// The text of a part of the archive.
fn part(zip: &Zip<'_>, name: &str, kind: &str) -> Result<String, Fault> {
    let bytes = zip.read(name).map_err(|e| Fault::new(format!("the {kind} workbook is damaged: {e}")))?;
    String::from_utf8(bytes).map_err(|_| Fault::new(format!("the {kind} workbook is damaged: {name} is no UTF-8")))
}

fn read_xlsx(input: &Input<'_>) -> Result<Content, Fault> {
    let zip = Zip::new(input.bytes).map_err(|e| Fault::new(format!("the xlsx workbook is damaged: {e}")))?;
    if !zip.names().any(|n| n == "xl/workbook.xml") {
        return Err(Fault::new("is an archive (zip) and no workbook").help("take the file out of the archive"));
    }
    let strings = if zip.names().any(|n| n == "xl/sharedStrings.xml") {
        shared_strings(&part(&zip, "xl/sharedStrings.xml", "xlsx")?)
    } else {
        vec![]
    };
    let dates = if zip.names().any(|n| n == "xl/styles.xml") {
        date_styles(&part(&zip, "xl/styles.xml", "xlsx")?)
    } else {
        vec![]
    };
    let mut sheets: Vec<&str> =
        zip.names().filter(|n| n.starts_with("xl/worksheets/") && n.ends_with(".xml")).collect();
    // sheet2 before sheet10.
    sheets.sort_by_key(|n| (n.len(), *n));
    for sheet in &sheets {
        let rows = xlsx_rows(&part(&zip, sheet, "xlsx")?, &strings, &dates)?;
        if rows.iter().any(|r| !r.is_empty()) {
            let mut content = table(&rows, input.name)?;
            if sheets.len() > 1
                && let Content::Table(t) = &mut content
            {
                t.notes.push(format!("the workbook has {} sheets: the first with cells is read", sheets.len()));
            }
            return Ok(content);
        }
    }
    Err(Fault::new("the workbook has no cells"))
}

/// Texts that cells refer to by number. Runs of one text are joined; phonetic hints are none of it.
fn shared_strings(xml: &str) -> Vec<String> {
    let (mut out, mut inside, mut phonetic) = (vec![], false, false);
    for piece in Pieces(xml) {
        match piece {
            Piece::Open("si", _, _) => out.push(String::new()),
            Piece::Open("rPh", _, false) => phonetic = true,
            Piece::Close("rPh") => phonetic = false,
            Piece::Open("t", _, false) => inside = true,
            Piece::Close("t") => inside = false,
            Piece::Text(text) if inside && !phonetic => {
                if let Some(last) = out.last_mut() {
                    last.push_str(&unescaped(text));
                }
            }
            _ => {}
        }
    }
    out
}

/// Which cell styles show dates or times of day.
fn date_styles(xml: &str) -> Vec<bool> {
    let (mut own, mut out, mut inside) = (vec![], vec![], false);
    for piece in Pieces(xml) {
        match piece {
            Piece::Open("numFmt", attributes, _) => {
                let code = attribute(attributes, "formatCode").map(unescaped).unwrap_or_default();
                // Texts in quotes and brackets (but for [h]) are no parts of a date.
                let parts = code.split('"').step_by(2).collect::<String>().to_lowercase();
                let is_date = !parts.contains("general") && parts.contains(['y', 'd', 'h', 's']);
                own.push((attribute(attributes, "numFmtId").map(str::to_owned), is_date));
            }
            Piece::Open("cellXfs", ..) => inside = true,
            Piece::Close("cellXfs") => inside = false,
            Piece::Open("xf", attributes, _) if inside => {
                let id = attribute(attributes, "numFmtId").unwrap_or("0");
                let built_in = id.parse::<u32>().is_ok_and(|n| (14..=22).contains(&n) || (45..=47).contains(&n));
                out.push(built_in || own.iter().any(|(of, date)| of.as_deref() == Some(id) && *date));
            }
            _ => {}
        }
    }
    out
}

/// A day number of a workbook as a date and a time, to ten microseconds, which is what its digits hold.
fn stamp(serial: f64) -> Option<String> {
    const TICKS: f64 = 8_640_000_000.0;
    if !(0.0..=109_000.0).contains(&serial) {
        return None;
    }
    let all = (serial * TICKS).round() as i64;
    let (days, ticks) = (all.div_euclid(TICKS as i64), all.rem_euclid(TICKS as i64));
    let seconds = ticks / 100_000;
    let (h, m, s, f) = (seconds / 3600, seconds / 60 % 60, seconds % 60, ticks % 100_000);
    let time = format!("{h:02}:{m:02}:{s:02}.{f:05}");
    if days == 0 {
        return Some(time);
    }
    let (year, month, day) = crate::sheet::clock::civil(days - EPOCH);
    Some(format!("{year:04}-{month:02}-{day:02}T{time}"))
}

/// Day number of 1970-01-01 in workbooks, which count from 1899-12-30.
const EPOCH: i64 = 25_569;

/// Row and column from 0 of a reference such as `B3`.
fn place(reference: &str) -> Option<(usize, usize)> {
    let letters = reference.bytes().take_while(u8::is_ascii_uppercase).count();
    if letters == 0 || letters > 3 {
        return None;
    }
    let column = reference[..letters].bytes().fold(0, |n, b| 26 * n + usize::from(b - b'A') + 1) - 1;
    let row: usize = reference[letters..].parse().ok()?;
    Some((row.checked_sub(1)?, column))
}

fn xlsx_rows(xml: &str, strings: &[String], dates: &[bool]) -> Result<Rows, Fault> {
    let mut rows: Rows = vec![];
    let (mut at, mut kind, mut value, mut inside) = ((0, 0), String::new(), String::new(), false);
    let mut is_date = false;
    for piece in Pieces(xml) {
        match piece {
            Piece::Open("row", attributes, _) => {
                let number = attribute(attributes, "r").and_then(|r| r.parse::<usize>().ok());
                at = (number.map_or(rows.len(), |n| n.saturating_sub(1)), 0);
            }
            Piece::Open("c", attributes, closed) => {
                at = attribute(attributes, "r").and_then(place).unwrap_or(at);
                kind = attribute(attributes, "t").unwrap_or("n").to_owned();
                let style = attribute(attributes, "s").and_then(|s| s.parse::<usize>().ok());
                is_date = style.and_then(|s| dates.get(s)).copied().unwrap_or(false);
                value.clear();
                if closed {
                    at.1 += 1;
                }
            }
            Piece::Open("v" | "t", _, closed) => inside = !closed,
            Piece::Close("v" | "t") => inside = false,
            Piece::Text(text) if inside => value.push_str(&unescaped(text)),
            Piece::Close("c") => {
                let shared = |v: &str| v.trim().parse::<usize>().ok().and_then(|i| strings.get(i)).cloned();
                let text = if kind == "s" {
                    shared(&value)
                        .ok_or_else(|| Fault::new(format!("a cell refers to the text {value}, which is not there")))?
                } else if is_date && kind == "n" {
                    value.parse().ok().and_then(stamp).unwrap_or_else(|| value.clone())
                } else {
                    value.clone()
                };
                set(&mut rows, at, text)?;
                at.1 += 1;
            }
            _ => {}
        }
    }
    Ok(rows)
}

fn set(rows: &mut Rows, (row, column): (usize, usize), text: String) -> Result<(), Fault> {
    if row >= MAX_ROWS || column >= MAX_COLUMNS {
        return Err(too_large());
    }
    if text.is_empty() {
        return Ok(());
    }
    if rows.len() <= row {
        rows.resize(row + 1, vec![]);
    }
    if rows[row].len() <= column {
        rows[row].resize(column + 1, String::new());
    }
    rows[row][column] = text;
    Ok(())
}

fn read_ods(input: &Input<'_>) -> Result<Content, Fault> {
    let zip = Zip::new(input.bytes).map_err(|e| Fault::new(format!("the ods workbook is damaged: {e}")))?;
    let xml = part(&zip, "content.xml", "ods")?;
    let mut rows: Rows = vec![];
    let (mut row, mut column, mut repeat, mut row_repeat) = (0, 0, 1, 1);
    let (mut value, mut text, mut inside): (Option<String>, String, bool) = (None, String::new(), false);
    let count = |attributes: &str, name: &str| {
        attribute(attributes, name).and_then(|n| n.parse().ok()).unwrap_or(1usize).max(1)
    };
    for piece in Pieces(&xml) {
        match piece {
            Piece::Open("table-row", attributes, closed) => {
                (column, row_repeat) = (0, count(attributes, "number-rows-repeated"));
                if closed {
                    row += row_repeat;
                }
            }
            Piece::Close("table-row") => {
                // A row that is repeated and has cells stands as often in the table.
                if let Some(cells) = rows.get(row).filter(|r| row_repeat > 1 && !r.is_empty()).cloned() {
                    if row.saturating_add(row_repeat) > MAX_ROWS {
                        return Err(too_large());
                    }
                    rows.resize(row + row_repeat, cells);
                }
                row = row.saturating_add(row_repeat);
            }
            Piece::Open("table-cell" | "covered-table-cell", attributes, closed) => {
                repeat = count(attributes, "number-columns-repeated");
                let number =
                    attribute(attributes, "value-type").filter(|t| matches!(*t, "float" | "percentage" | "currency"));
                let stamp = attribute(attributes, "date-value");
                value = number.and(attribute(attributes, "value")).or(stamp).map(unescaped);
                text.clear();
                if closed {
                    column += repeat;
                }
            }
            Piece::Open("p", _, closed) => inside = !closed,
            Piece::Close("p") => inside = false,
            Piece::Text(t) if inside => text.push_str(&unescaped(t)),
            Piece::Close("table-cell" | "covered-table-cell") => {
                let cell = value.take().unwrap_or_else(|| text.clone());
                if !cell.is_empty() {
                    for i in 0..repeat.min(MAX_COLUMNS) {
                        set(&mut rows, (row, column.saturating_add(i)), cell.clone())?;
                    }
                }
                column = column.saturating_add(repeat);
            }
            Piece::Close("table") if rows.iter().any(|r| !r.is_empty()) => break,
            _ => {}
        }
    }
    if rows.is_empty() {
        return Err(Fault::new("the workbook has no cells"));
    }
    table(&rows, input.name)
}
