//! Differences of two results of isolation studies.

use super::tables::cell;
use hysteron_identify::report::{Cell, Table};
use serde_json::{Map, Value};

/// Tables of a result that are compared, with the columns that name a row.
const TABLES: [(&str, &[&str]); 8] = [
    ("motions", &["motion"]),
    ("bearings", &["type"]),
    (CHECKS, &["check"]),
    ("design_values", &["quantity", "bound"]),
    ("lateral_force", &["quantity"]),
    ("structure", &["quantity"]),
    ("schedule", &["type", "bearing"]),
    ("modes", &["structure", "mode"]),
];
/// The table of the checks, and its column of results.
const CHECKS: &str = "checks";
const RESULT: &str = "result";
/// Shares of the mass below which two modes are the same: their order is round-off.
const NO_MASS: f64 = 0.01;
/// Relative difference below which two numbers are the same: properties that are tested in the script depend a little on the
/// displacement of the test.
const SAME: f64 = 1.0e-4;

/// Differences of two results.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Comparison {
    /// Rows: table, item, quantity, both values and their ratio.
    pub table: Table,
    /// Numbers and words that are the same in both.
    pub same: usize,
}

type Row = Map<String, Value>;

/// Rows of a table of a result. Motions and bearings are among the inputs.
fn rows<'a>(result: &'a Value, name: &str) -> Vec<&'a Row> {
    let table = result["study"].get(name).or_else(|| result.get(name));
    table.and_then(Value::as_array).into_iter().flatten().filter_map(Value::as_object).collect()
}

/// Text of a value without the quotes.
fn plain(v: &Value) -> String {
    v.as_str().map_or_else(|| v.to_string(), str::to_owned)
}

/// Returns true for a number that follows from others of its row.
fn is_derived(table: &str, quantity: &str) -> bool {
    table == CHECKS && quantity == "ratio"
}

/// Name of a row. A check that is scaled has its factor behind a comma, which does not name it.
fn key(table: &str, row: &Row, columns: &[&str]) -> String {
    let word = |v: &Value| v.as_f64().map_or_else(|| plain(v), |x| x.to_string());
    let part = |c: &&str| row.get(*c).map(word);
    let name = columns.iter().filter_map(part).collect::<Vec<_>>().join(", ");
    match table == CHECKS {
        true => name.split([',', ';']).next().unwrap_or_default().to_owned(),
        false => name,
    }
}

/// Returns true if a row tells nothing about two modes that hardly have any mass.
fn is_round_off(table: &str, a: &Row, b: &Row) -> bool {
    let mass = |row: &Row| ["mass x", "mass y"].iter().filter_map(|c| row.get(*c)?.as_f64()).fold(0.0, f64::max);
    table == "modes" && mass(a).max(mass(b)) < NO_MASS
}

impl Comparison {
    fn add(&mut self, table: &'static str, item: &str, quantity: &str, a: Option<&Value>, b: Option<&Value>) {
        if a == b {
            self.same += 1;
            return;
        }
        let numbers = [a, b].map(|v| v.and_then(Value::as_f64));
        if let [Some(x), Some(y)] = numbers {
            if (x - y).abs() <= SAME * x.abs().max(y.abs()) {
                self.same += 1;
                return;
            }
            self.push(table, item, quantity, [x.into(), y.into()], y / x);
            return;
        }
        let text = |v: Option<&Value>| match v {
            None => Cell::Word("none"),
            Some(v) => v.as_f64().map_or_else(|| Cell::Text(plain(v)), Cell::Number),
        };
        self.push(table, item, quantity, [text(a), text(b)], f64::NAN);
    }

    fn push(&mut self, table: &'static str, item: &str, quantity: &str, [a, b]: [Cell; 2], ratio: f64) {
        let row = vec![Cell::Word(table), item.to_owned().into(), quantity.to_owned().into(), a, b, cell(ratio)];
        self.table.rows.push(row);
    }
}

/// Compare two results, as `isolation.json` has them.
///
/// # Errors
/// One of them is no result of an isolation study. The message says which.
pub fn compare(a: &Value, b: &Value) -> Result<Comparison, String> {
    for (name, result) in [("first", a), ("second", b)] {
        if !(result["study"].is_object() && result["design_values"].is_array()) {
            return Err(format!("the {name} file is no result of an isolation study: expected isolation.json"));
        }
    }
    let columns = [("table", ""), ("item", ""), ("quantity", ""), ("A", ""), ("B", ""), ("B/A", "")];
    let mut out = Comparison { table: Table::new(columns), same: 0 };
    let inputs = [a, b].map(|r| r["study"].as_object());
    let mut names: Vec<&String> = inputs.iter().flatten().flat_map(|study| study.keys()).collect();
    names.sort_unstable();
    names.dedup();
    for name in names.into_iter().filter(|n| TABLES.iter().all(|(table, _)| table != n)) {
        out.add("study", name, "", a["study"].get(name), b["study"].get(name));
    }
    for (name, columns) in TABLES {
        let [first, second] = [a, b].map(|r| rows(r, name));
        let mut keys: Vec<String> = first.iter().chain(&second).map(|r| key(name, r, columns)).collect();
        let mut seen = std::collections::BTreeSet::new();
        keys.retain(|k| seen.insert(k.clone()));
        let of_key = |k: &str| [&first, &second].map(|rows| rows.iter().copied().find(|r| key(name, r, columns) == k));
        // Checks that are decided otherwise come first.
        let is_same = |k: &String| matches!(of_key(k), [Some(a), Some(b)] if a.get(RESULT) == b.get(RESULT));
        keys.sort_by_key(is_same);
        for k in keys {
            let [x, y] = of_key(&k);
            match (x, y) {
                (Some(x), Some(y)) if is_round_off(name, x, y) => {}
                (Some(x), Some(y)) => {
                    for (quantity, value) in
                        x.iter().filter(|(q, _)| !columns.contains(&q.as_str()) && !is_derived(name, q))
                    {
                        out.add(name, &k, quantity, Some(value), y.get(quantity));
                    }
                }
                (Some(_), None) => out.push(name, &k, "", [Cell::Word("there"), Cell::Word("none")], f64::NAN),
                _ => out.push(name, &k, "", [Cell::Word("none"), Cell::Word("there")], f64::NAN),
            }
        }
    }
    Ok(out)
}

#[cfg(test)]
mod tests {
    use super::compare;
    use hysteron_identify::report::Cell;
    use serde_json::json;

    #[test]
    fn changes_rows_that_are_gone_and_equal_values() {
        let result = |d: f64, motions: serde_json::Value, word: &str| {
            json!({
                "study": {"code": "ASCE 7-16", "target": "asce7", "weight": 10.0, "motions": motions, "bearings": []},
                "design_values": [{"quantity": "D", "bound": "lower", "design": d}],
                "checks": [{"check": "b", "demand": d, "ratio": d, "result": "met"}, {"check": "a, scaled by 2", "result": word}],
            })
        };
        // Names of motions may differ behind a comma alone.
        let a = result(0.2, json!([{"motion": "M, 270", "factor": 1.0}, {"motion": "M, 360", "factor": 1.0}]), "met");
        let b = result(0.3, json!([{"motion": "M, 270", "factor": 1.0}]), "NOT MET");
        let found = compare(&a, &b).expect("a comparison");
        let items: Vec<String> = found.table.rows.iter().map(|r| format!("{:?} {:?}", r[0], r[1])).collect();
        assert_eq!(found.table.rows.len(), 4, "{items:?}");
        assert!(items[0].contains("M, 360") && items[1].contains("\"a\"") && items[2].contains("\"b\""), "{items:?}");
        assert!(items[3].contains("design_values"), "{items:?}");
        assert!(matches!(found.table.rows[3][5], Cell::Number(r) if (r - 1.5).abs() < 1e-12));
        assert_eq!(compare(&a, &a).expect("the same").table.rows.len(), 0);
        assert!(compare(&a, &json!({})).expect_err("none").contains("second"));
    }
}
