//! Percentiles of the response over draws of the properties of bearings.

use super::governing::top;
use super::tables::{cell, table_of};
use crate::isolate::{JobOutcome, Study};
use hysteron_identify::report::{Cell, Table};

/// Percentiles that are given, as shares.
const SHARES: [f64; 5] = [0.05, 0.16, 0.5, 0.84, 0.95];

/// Name, unit and value of a quantity.
type Quantity = (String, String, f64);

/// Quantities of a complete analysis.
fn quantities(study: &Study, o: &JobOutcome) -> Vec<Quantity> {
    let [force, length] = &study.units;
    let mut out = vec![];
    let mut at = 0;
    for kind in &study.bearings {
        let mine = &o.bearings[at..at + kind.tags.len()];
        at += kind.tags.len();
        let most = |of: fn(&crate::isolate::BearingOutcome) -> f64| mine.iter().map(of).fold(f64::NAN, f64::max);
        for (what, unit, value) in [
            ("displacement", length, most(|b| b.displacement)),
            ("shear", force, most(|b| b.shear)),
            ("axial force", force, most(|b| b.compression)),
            ("tension", force, most(|b| (-b.least).max(0.0))),
            ("uplift", length, most(|b| b.uplift)),
        ] {
            out.push((format!("{}: {what}", kind.name), unit.clone(), value));
        }
    }
    out.push(("shear of all bearings".into(), force.clone(), o.base_shear));
    for (what, unit, value) in
        [("storey drift ratio", "", top(&o.drifts)), ("floor acceleration", "g", top(&o.accelerations))]
    {
        out.extend(value.map(|v| (what.to_owned(), unit.to_owned(), v)));
    }
    out
}

/// A percentile of sorted numbers, linear between them.
fn percentile(sorted: &[f64], share: f64) -> f64 {
    let Some(last) = sorted.len().checked_sub(1) else { return f64::NAN };
    let x = share * last as f64;
    let (i, j) = (x.floor() as usize, x.ceil() as usize);
    sorted[i] + (sorted[j] - sorted[i]) * (x - i as f64)
}

/// Percentiles over the complete analyses of draws, and the draws with their factors.
pub fn draw_tables(study: &Study, outcomes: &[JobOutcome]) -> [Table; 2] {
    let complete: Vec<(usize, Vec<Quantity>)> = outcomes
        .iter()
        .enumerate()
        .filter(|(_, o)| o.failure.is_empty())
        .map(|(k, o)| (k, quantities(study, o)))
        .collect();
    let mut columns = vec![("quantity".to_owned(), String::new()), ("unit".to_owned(), String::new())];
    columns.extend(SHARES.map(|s| (format!("{} %", 100.0 * s), String::new())));
    columns.push(("largest".into(), String::new()));
    let mut percentiles = table_of(columns);
    let first = complete.first().map_or(&[][..], |c| &c.1);
    for (i, (name, unit, _)) in first.iter().enumerate() {
        let mut values: Vec<f64> = complete.iter().map(|c| c.1[i].2).collect();
        values.sort_by(f64::total_cmp);
        let mut row: Vec<Cell> = vec![name.clone().into(), unit.clone().into()];
        row.extend(SHARES.map(|s| cell(percentile(&values, s))));
        row.push(cell(percentile(&values, 1.0)));
        percentiles.rows.push(row);
    }
    let mut columns = vec![("draw".to_owned(), String::new()), ("motion".to_owned(), String::new())];
    for b in &study.bearings {
        columns.extend(["Q", "K"].map(|letter| (format!("{letter},{}", b.name), String::new())));
    }
    columns.extend(first.iter().map(|(name, unit, _)| (name.clone(), unit.clone())));
    let mut draws = table_of(columns);
    for (k, values) in &complete {
        let mut row: Vec<Cell> = vec![((k + 1) as f64).into(), outcomes[*k].motion.clone().into()];
        row.extend(study.draws[*k].iter().flatten().map(|f| cell(*f)));
        row.extend(values.iter().map(|v| cell(v.2)));
        draws.rows.push(row);
    }
    [percentiles, draws]
}

#[cfg(test)]
mod tests {
    use super::percentile;

    #[test]
    fn percentiles_are_linear_between_ranks() {
        let x = [1.0, 2.0, 4.0];
        assert_eq!([0.0, 0.25, 0.5, 0.75, 1.0].map(|s| percentile(&x, s)), [1.0, 1.5, 2.0, 3.0, 4.0]);
        assert!(percentile(&[], 0.5).is_nan());
    }
}
