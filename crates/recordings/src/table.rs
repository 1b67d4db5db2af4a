//! Columns of any measured file, as they are written.

use crate::content::Content;
use crate::fault::Fault;
use crate::format::Beside;
use crate::interpret::meaning;
use crate::measured::Measured;
use crate::sheet::head::seconds;
use crate::sheet::{Form, Sheet};
use crate::unit::{Quantity, Unit};

/// A table by columns, all of the same length.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Table {
    /// Heads of the columns; empty where the file gives none.
    pub names: Vec<String>,
    /// Values in the units of the file; NaN where a sample is missing.
    pub columns: Vec<Vec<f64>>,
    sheet: Sheet,
}

/// Name of the format of tables as text.
const TEXT: &str = "table";

impl Table {
    /// Read a table from text. Spaces, tabs, commas or semicolons separate the numbers.
    ///
    /// Empty lines, and lines that begin with `#` or `%`, are skipped. Names may stand above the numbers.
    ///
    /// # Errors
    /// The line with something else than a number, or with another number of columns than those before it.
    pub fn parse(text: &str) -> Result<Self, String> {
        let sheet = Sheet::parse(text, &Form { name: "the file", ..Form::default() }).map_err(Fault::from)?;
        Ok(Self::of(sheet))
    }

    /// The columns of a file of any format. Channels without a table stand beside their times.
    ///
    /// # Errors
    /// What is wrong with the file, and where.
    pub fn read(name: &str, bytes: &[u8]) -> Result<Self, String> {
        Self::read_beside(name, bytes, &|_| None)
    }

    /// As [`Table::read`], with the files beside it as for [`Measured::read_beside`].
    ///
    /// # Errors
    /// As there.
    pub fn read_beside(name: &str, bytes: &[u8], beside: Beside<'_>) -> Result<Self, String> {
        let measured = Measured::read_beside(name, bytes, beside)?;
        let series = match measured.content {
            Content::Table(sheet) => return Ok(Self::of(sheet)),
            // A list is a table of one column; rows of other lengths are none.
            Content::Series { .. } if measured.format.name == TEXT => return Self::parse(&measured.text),
            Content::Series { series, .. } => series,
        };
        let rows = series.first().map_or(0, |s| s.values.len());
        if series.iter().any(|s| s.values.len() != rows) {
            return Err("the channels have different numbers of values".into());
        }
        let mut sheet = Sheet::default();
        let mut add = |cell: String, unit: String, values: Vec<f64>| {
            sheet.columns.push(crate::sheet::Column { cell, unit, values, ..crate::sheet::Column::default() });
        };
        let times: Option<Vec<f64>> = series.first().and_then(|s| (0..rows).map(|i| s.clock.time(i)).collect());
        let named = times.is_some() || series.iter().any(|s| !s.name.is_empty());
        if let Some(times) = times {
            add("time".into(), "s".into(), times);
        }
        for s in series {
            let name = match (s.name.is_empty(), s.quantity) {
                (false, _) => s.name,
                (true, Some(q)) => q.word().to_owned(),
                (true, None) if named => "value".to_owned(),
                (true, None) => String::new(),
            };
            add(name, s.unit.map_or(s.unit_name, |u| u.name.to_owned()), s.values);
        }
        sheet.named = named;
        Ok(Self::of(sheet))
    }

    fn of(mut sheet: Sheet) -> Self {
        let names = if sheet.named { sheet.columns.iter().map(|c| c.cell.clone()).collect() } else { vec![] };
        let columns = sheet.columns.iter_mut().map(|c| std::mem::take(&mut c.values)).collect();
        Self { names, columns, sheet }
    }

    /// A column by its head, its name without unit, or its number counted from 1.
    ///
    /// # Errors
    /// There is none, with those that there are.
    pub fn column(&self, which: &str) -> Result<&[f64], String> {
        self.sheet.find(which).map(|i| self.columns[i].as_slice())
    }

    /// A column whose samples are all there.
    ///
    /// # Errors
    /// There is none of that name, or a sample is missing or not finite; the row is named.
    pub fn complete_column(&self, which: &str) -> Result<&[f64], String> {
        let values = self.column(which)?;
        match values.iter().position(|x| !x.is_finite()) {
            Some(at) => Err(format!("{} of column \"{which}\" is not finite", self.sheet.row_name(at))),
            None => Ok(values),
        }
    }

    /// As [`Table::complete_column`], in another unit where that of the column and this one are known.
    ///
    /// # Errors
    /// As there; and the units are of other quantities.
    pub fn column_in(&self, which: &str, to: Option<Unit>) -> Result<Vec<f64>, String> {
        let values = self.complete_column(which)?;
        let own = self.sheet.find(which).ok().and_then(|i| meaning(&self.sheet.columns[i]).1);
        let Some((from, to)) = own.zip(to) else { return Ok(values.to_vec()) };
        let (factor, offset) = from.conversion(&to).ok_or_else(|| {
            format!("the column \"{which}\" is {} in {}, and is wanted in {}", from.quantity, from.name, to.name)
        })?;
        Ok(values.iter().map(|x| factor * x + offset).collect())
    }

    /// The times of a column in s: in the unit of its head, in s if that has none.
    ///
    /// # Errors
    /// There is no such column, it is no time, or a time is missing.
    pub fn seconds(&self, which: &str) -> Result<Vec<f64>, String> {
        let values = self.complete_column(which)?;
        let own = self.sheet.find(which).ok().and_then(|i| meaning(&self.sheet.columns[i]).1);
        match own {
            Some(u) if u.quantity != Quantity::Time => {
                Err(format!("the column \"{which}\" is {} in {}", u.quantity, u.name))
            }
            Some(u) => Ok(values.iter().map(|x| seconds(*x, &u)).collect()),
            None => Ok(values.to_vec()),
        }
    }

    /// The table without the rows in which a sample is missing, and the number of these.
    #[must_use]
    pub fn without_missing(mut self) -> (Self, usize) {
        let rows = self.columns.first().map_or(0, Vec::len);
        let is_complete = |i: &usize| !self.columns.iter().any(|c| c[*i].is_nan());
        let kept: Vec<usize> = (0..rows).filter(is_complete).collect();
        let of = |values: &Vec<f64>| kept.iter().map(|i| values[*i]).collect();
        let columns = self.columns.iter().map(of).collect();
        let lines = kept.iter().filter_map(|i| self.sheet.lines.get(*i)).copied().collect();
        self.columns = columns;
        self.sheet.lines = lines;
        (self, rows - kept.len())
    }
}

#[cfg(test)]
mod tests {
    use super::Table;

    #[test]
    fn forms() {
        let plain = Table::parse("0 1 -2e-3\n1 2 inf\n\n").unwrap_or_default();
        assert_eq!(plain.columns, [vec![0.0, 1.0], vec![1.0, 2.0], vec![-2e-3, f64::INFINITY]]);
        assert_eq!(plain.column("2"), Ok(&[1.0, 2.0][..]));
        let named = Table::parse("# a test\n\"time, s\", u ,F\n0,1,2,\n1,2,3\n").unwrap_or_default();
        assert_eq!(named.names, ["time, s", "u", "F"]);
        assert_eq!(named.column("F"), Ok(&[2.0, 3.0][..]));
        assert_eq!(named.column("v"), Err("there is no column \"v\": they are time, s, u, F".into()));
        assert_eq!(plain.column("0"), Err("there is no column \"0\": they are 1 to 3".into()));
        assert_eq!(Table::parse(""), Ok(Table::default()));
        for (text, message) in [
            ("1 2\n3\n", "there are 2 columns, but 1 in line 2"),
            ("1 2\n3 x\n", "line 2: \"x\" is not a number: expected a number"),
        ] {
            assert_eq!(Table::parse(text), Err(message.into()));
        }
    }

    #[test]
    fn columns_are_found_without_their_units() {
        let t = Table::read("f.csv", b"Zeit,Weg Lager 1 [mm],Kraft (kN),,\n0,1,2,,\n1,2,,,\n").expect("a table");
        assert_eq!(t.column("Weg Lager 1"), Ok(&[1.0, 2.0][..]));
        assert_eq!(t.complete_column("Kraft"), Err("row 2 (line 3) of column \"Kraft\" is not finite".into()));
        let (t, left_out) = t.without_missing();
        assert_eq!((t.complete_column("Kraft"), left_out), (Ok(&[2.0][..]), 1));
    }
}
