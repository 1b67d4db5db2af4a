//! Values of parameters: grid, list, CSV and Latin hypercube.

use rand::{RngExt as _, SeedableRng as _};
use rand_pcg::Pcg32;
use serde::Deserialize;
use std::collections::BTreeMap;

/// Rows of values with the names of their columns.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Rows {
    pub(super) names: Vec<String>,
    pub(super) rows: Vec<Vec<f64>>,
}

/// Values of one parameter of a grid.
#[derive(Clone, Debug, Deserialize)]
#[serde(untagged)]
pub(super) enum GridValues {
    /// The values themselves.
    List(Vec<f64>),
    /// Values at equal distances.
    Range(Range),
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Range {
    from: f64,
    to: f64,
    points: usize,
}

/// A Latin hypercube.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct LatinHypercube {
    pub(super) points: usize,
    #[serde(default)]
    pub(super) seed: u64,
    /// Range of each parameter.
    pub(super) parameters: BTreeMap<String, [f64; 2]>,
}

/// Cases of a plan, at most: more are a mistake in a grid.
pub(super) const MAX_CASES: usize = 10_000_000;

impl Rows {
    /// One row without a parameter.
    pub(super) fn nothing() -> Self {
        Self { names: vec![], rows: vec![vec![]] }
    }

    /// All combinations with further rows, which vary faster.
    pub(super) fn times(self, other: &Self) -> Result<Self, String> {
        if let Some(name) = self.names.iter().find(|n| other.names.contains(n)) {
            return Err(format!("the parameter {name} has values in two places"));
        }
        if self.rows.len().saturating_mul(other.rows.len()) > MAX_CASES {
            return Err(format!("the plan has more than {MAX_CASES} cases"));
        }
        let join = |a: &Vec<f64>, b: &Vec<f64>| [a.as_slice(), b].concat();
        let rows = self.rows.iter().flat_map(|a| other.rows.iter().map(move |b| join(a, b))).collect();
        Ok(Self { names: [self.names, other.names.clone()].concat(), rows })
    }
}

/// All combinations of the values of a grid; the last name varies fastest.
pub(super) fn grid(values: &BTreeMap<String, GridValues>) -> Result<Rows, String> {
    values.iter().try_fold(Rows::nothing(), |rows, (name, values)| {
        let values = match values {
            GridValues::List(list) => list.clone(),
            GridValues::Range(r) if r.points >= 2 && r.points <= MAX_CASES => {
                let at = |i: usize| r.from + (r.to - r.from) * (i as f64 / (r.points - 1) as f64);
                (0..r.points).map(at).collect()
            }
            GridValues::Range(r) => return Err(format!("{name}: points = {}: expected at least 2", r.points)),
        };
        if values.is_empty() {
            return Err(format!("the parameter {name} has no values"));
        }
        rows.times(&Rows { names: vec![name.clone()], rows: values.into_iter().map(|v| vec![v]).collect() })
    })
}

/// Rows of a list, which all have the same names.
pub(super) fn list(cases: &[BTreeMap<String, f64>]) -> Result<Rows, String> {
    let Some(first) = cases.first() else { return Ok(Rows::nothing()) };
    let names: Vec<String> = first.keys().cloned().collect();
    for (i, case) in cases.iter().enumerate() {
        if !case.keys().eq(names.iter()) {
            let own: Vec<&str> = case.keys().map(String::as_str).collect();
            let (own, first) = (own.join(", "), names.join(", "));
            return Err(format!("[[case]] {} has the parameters {own}: expected {first} as the first one", i + 1));
        }
    }
    Ok(Rows { names, rows: cases.iter().map(|c| c.values().copied().collect()).collect() })
}

/// Rows of a CSV file with a header of names.
pub(super) fn table(name: &str, text: &str) -> Result<Rows, String> {
    let mut reader = csv::ReaderBuilder::new().trim(csv::Trim::All).from_reader(text.as_bytes());
    let wrong = |e: csv::Error| format!("\"{name}\": {e}");
    let names: Vec<String> = reader.headers().map_err(wrong)?.iter().map(str::to_owned).collect();
    let mut rows = vec![];
    for record in reader.records() {
        let record = record.map_err(wrong)?;
        let line = record.position().map_or(0, csv::Position::line);
        let number = |(word, column): (&str, &String)| {
            let value = word.parse::<f64>().ok().filter(|x| x.is_finite());
            value.ok_or_else(|| format!("\"{name}\", line {line}, column {column}: expected a number, not \"{word}\""))
        };
        rows.push(record.iter().zip(&names).map(number).collect::<Result<Vec<f64>, String>>()?);
    }
    if rows.is_empty() {
        return Err(format!("\"{name}\" has no row of values"));
    }
    Ok(Rows { names, rows })
}

/// A Latin hypercube (McKay, Beckman and Conover 1979, Technometrics 21, 239-245): each of the equal strata of a range has one
/// point, at random in it.
pub(super) fn latin_hypercube(sample: &LatinHypercube) -> Result<Rows, String> {
    let n = sample.points;
    if n == 0 || n > MAX_CASES {
        return Err(format!("latin_hypercube: points = {n}: expected 1 to {MAX_CASES}"));
    }
    let mut random = Pcg32::seed_from_u64(sample.seed);
    let mut rows = vec![vec![]; n];
    for (name, [from, to]) in &sample.parameters {
        if from > to || !(to - from).is_finite() {
            return Err(format!("latin_hypercube: {name} = [{from}, {to}]: expected two rising numbers"));
        }
        let mut strata: Vec<usize> = (0..n).collect();
        for i in (1..n).rev() {
            strata.swap(i, random.random_range(0..=i));
        }
        for (row, stratum) in rows.iter_mut().zip(strata) {
            let share = (stratum as f64 + random.random::<f64>()) / n as f64;
            row.push(from + (to - from) * share);
        }
    }
    Ok(Rows { names: sample.parameters.keys().cloned().collect(), rows })
}

#[cfg(test)]
mod tests {
    use super::{LatinHypercube, latin_hypercube};

    #[test]
    fn each_stratum_of_a_latin_hypercube_has_one_point() {
        let parameters = [("a".to_owned(), [0.0, 8.0]), ("b".to_owned(), [-1.0, 1.0])].into();
        let mut sample = LatinHypercube { points: 8, seed: 3, parameters };
        let rows = latin_hypercube(&sample).expect("rows");
        for (k, scale) in [(0, 1.0), (1, 4.0)] {
            let mut strata: Vec<i64> = rows.rows.iter().map(|r| ((r[k] + k as f64) * scale).floor() as i64).collect();
            strata.sort_unstable();
            assert_eq!(strata, (0..8).collect::<Vec<i64>>());
        }
        assert_eq!(latin_hypercube(&sample).expect("rows"), rows);
        sample.seed = 4;
        assert_ne!(latin_hypercube(&sample).expect("rows"), rows);
    }
}
