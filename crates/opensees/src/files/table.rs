//! Tables of numbers: files of recorders, and CSV with or without a line of names.

/// A table by columns, all of the same length.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Table {
    /// Names of the columns; empty where the file gives none.
    pub names: Vec<String>,
    /// Values.
    pub columns: Vec<Vec<f64>>,
}

impl Table {
    /// Read a table. Spaces, tabs, commas or semicolons separate the numbers.
    ///
    /// Empty lines, and lines that begin with `#` or `%`, are skipped. The first line may give names.
    ///
    /// # Errors
    /// The line with something else than a number, or with another number of columns than those before it.
    pub fn parse(text: &str) -> Result<Self, String> {
        let mut table = Self::default();
        let lines = text.lines().enumerate().map(|(i, l)| (i + 1, l.trim()));
        for (number, line) in lines.filter(|(_, l)| !l.is_empty() && !l.starts_with(['#', '%'])) {
            let cells = cells(line);
            let values: Result<Vec<f64>, &String> = cells.iter().map(|c| c.parse().map_err(|_| c)).collect();
            match values {
                // Names are no numbers, not one of them.
                Err(_) if table.columns.is_empty() && cells.iter().all(|c| c.parse::<f64>().is_err()) => {
                    table.columns.resize(cells.len(), vec![]);
                    table.names = cells;
                }
                Err(cell) => return Err(format!("line {number}: \"{cell}\" is not a number")),
                Ok(values) => {
                    if table.columns.is_empty() {
                        table.columns.resize(values.len(), vec![]);
                    }
                    if values.len() != table.columns.len() {
                        let (there, here) = (table.columns.len(), values.len());
                        return Err(format!("there are {there} columns, but {here} in line {number}"));
                    }
                    table.columns.iter_mut().zip(values).for_each(|(column, x)| column.push(x));
                }
            }
        }
        Ok(table)
    }

    /// A column by its name or its number, counted from 1.
    ///
    /// # Errors
    /// There is none, with those that there are.
    pub fn column(&self, which: &str) -> Result<&[f64], String> {
        let named = self.names.iter().position(|n| n == which);
        let numbered = || which.parse::<usize>().ok().and_then(|n| n.checked_sub(1));
        named.or_else(numbered).and_then(|i| self.columns.get(i)).map(Vec::as_slice).ok_or_else(|| {
            let there = match (self.names.is_empty(), self.columns.len()) {
                (_, 0) => "the file has none".to_owned(),
                (true, n) => format!("they are 1 to {n}"),
                (false, _) => format!("they are {}", self.names.join(", ")),
            };
            format!("there is no column \"{which}\": {there}")
        })
    }
}

/// The cells of a line.
fn cells(line: &str) -> Vec<String> {
    match [',', ';'].into_iter().find(|d| line.contains(*d)) {
        // A trailing separator begins no column.
        Some(delimiter) => {
            let line = line.strip_suffix(delimiter).unwrap_or(line);
            let mut reader = csv::ReaderBuilder::new()
                .delimiter(delimiter as u8)
                .has_headers(false)
                .trim(csv::Trim::All)
                .from_reader(line.as_bytes());
            reader.records().flatten().flat_map(|r| r.iter().map(str::to_owned).collect::<Vec<_>>()).collect()
        }
        None => line.split_whitespace().map(|c| c.trim_matches('"').to_owned()).collect(),
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
        assert_eq!(named.column("f"), Err("there is no column \"f\": they are time, s, u, F".into()));
        assert_eq!(plain.column("0"), Err("there is no column \"0\": they are 1 to 3".into()));
        assert_eq!(Table::parse(""), Ok(Table::default()));
        for (text, message) in
            [("1 2\n3\n", "there are 2 columns, but 1 in line 2"), ("1 2\n3 x\n", "line 2: \"x\" is not a number")]
        {
            assert_eq!(Table::parse(text), Err(message.into()));
        }
    }
}
