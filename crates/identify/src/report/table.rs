//! Tables of results as aligned text, CSV and JSON.

use hysteron_engine::number_format::Style;
use serde_json::{Map, Value, json};
use std::borrow::Cow;
use std::fmt::Write as _;

/// A column of a table.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Column {
    /// Name.
    pub name: Cow<'static, str>,
    /// Unit; empty for none.
    pub unit: String,
}

/// A cell of a table.
#[derive(Clone, Debug, PartialEq)]
pub enum Cell {
    /// A number.
    Number(f64),
    /// A word.
    Word(&'static str),
    /// A text that is not known before, for instance the name of a file.
    Text(String),
}

impl From<String> for Cell {
    fn from(text: String) -> Self {
        Self::Text(text)
    }
}

impl From<f64> for Cell {
    fn from(x: f64) -> Self {
        Self::Number(x)
    }
}

/// Rows under named columns.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Table {
    /// Columns.
    pub columns: Vec<Column>,
    /// Rows, each as long as there are columns.
    pub rows: Vec<Vec<Cell>>,
}

impl Table {
    /// A table without rows, from names and units of its columns.
    pub fn new<const N: usize>(columns: [(&'static str, &str); N]) -> Self {
        let columns = columns.map(|(name, unit)| Column { name: name.into(), unit: unit.to_owned() });
        Self { columns: columns.into(), rows: vec![] }
    }

    /// The table as aligned text, with units below the names and five significant digits.
    pub fn text(&self) -> String {
        let heads = [
            self.columns.iter().map(|c| c.name.to_string()).collect::<Vec<_>>(),
            self.columns.iter().map(|c| c.unit.clone()).collect(),
        ];
        let rows = self.rows.iter().map(|r| r.iter().map(rounded).collect());
        let lines: Vec<Vec<String>> =
            heads.into_iter().filter(|h| h.iter().any(|w| !w.is_empty())).chain(rows).collect();
        let widths: Vec<usize> = (0..self.columns.len())
            .map(|i| lines.iter().filter_map(|l| l.get(i)).map(|w| w.chars().count()).max().unwrap_or(0))
            .collect();
        let mut out = String::new();
        for line in &lines {
            let begin = out.len();
            for (word, &width) in line.iter().zip(&widths) {
                let _ = write!(out, "{word:>width$}  ");
            }
            out.truncate(begin + out[begin..].trim_end().len());
            out.push('\n');
        }
        out
    }

    /// The table as CSV, with one head line of names and units in brackets. Numbers keep all digits.
    pub fn csv(&self) -> String {
        let head = self.columns.iter().map(|c| match c.unit.as_str() {
            "" => quoted(&c.name),
            unit => quoted(&format!("{} [{unit}]", c.name)),
        });
        let rows = self.rows.iter().map(|r| r.iter().map(exact).collect::<Vec<_>>());
        std::iter::once(head.collect::<Vec<_>>()).chain(rows).map(|r| r.join(",") + "\n").collect()
    }

    /// The table as a JSON array with one object for each row.
    pub fn json(&self) -> String {
        let value = |c: &Cell| match c {
            Cell::Number(x) => json!(x),
            Cell::Word(w) => json!(w),
            Cell::Text(t) => json!(t),
        };
        let object = |r: &Vec<Cell>| {
            let members = self.columns.iter().zip(r).map(|(c, x)| (c.name.to_string(), value(x)));
            Value::Object(members.collect::<Map<_, _>>())
        };
        let rows: Vec<Value> = self.rows.iter().map(object).collect();
        format!("{:#}\n", Value::Array(rows))
    }
}

/// A cell with five significant digits.
fn rounded(c: &Cell) -> String {
    match c {
        Cell::Number(x) => {
            let mut text = String::new();
            Style { precision: 5, scientific: false }.push(*x, &mut text);
            text
        }
        Cell::Word(w) => (*w).to_owned(),
        Cell::Text(t) => t.clone(),
    }
}

/// A cell with all digits: reading it gives the same number.
fn exact(c: &Cell) -> String {
    match c {
        Cell::Number(x) if *x == 0.0 || (1e-5..1e15).contains(&x.abs()) => x.to_string(),
        Cell::Number(x) => format!("{x:e}"),
        Cell::Word(w) => (*w).to_owned(),
        Cell::Text(t) => quoted(t),
    }
}

/// A text as a cell of CSV.
fn quoted(text: &str) -> String {
    let special = text.contains([',', '"', '\n']);
    if special { format!("\"{}\"", text.replace('"', "\"\"")) } else { text.to_owned() }
}

#[cfg(test)]
mod tests {
    use super::{Cell, Table};

    #[test]
    fn text_csv_and_json_of_a_table() {
        let mut t = Table::new([("cycle", ""), ("K", "kN/m"), ("part", "")]);
        t.rows = vec![
            vec![1.0.into(), (1.0 / 3.0).into(), Cell::Word("")],
            vec![10.0.into(), 2e16.into(), Cell::Word("above")],
        ];
        assert_eq!(t.text(), "cycle        K   part\n          kN/m\n    1  0.33333\n   10    2e+16  above\n");
        assert_eq!(t.csv(), "cycle,K [kN/m],part\n1,0.3333333333333333,\n10,2e16,above\n");
        let back: serde_json::Value = serde_json::from_str(&t.json()).unwrap_or_default();
        assert_eq!(back[1]["part"], "above");
        assert_eq!(back[0]["K"], 1.0 / 3.0);
    }
}
