//! Results of the multimode method as tables, JSON and a page.

use super::BoundResponse;
use crate::isolate::{JobOutcome, Study};
use crate::prototype::report::page_table;
use hysteron_identify::report::{Cell, Table, html as page};
use serde_json::{Value, json};

fn cell(x: f64) -> Cell {
    if x.is_finite() { Cell::Number(x) } else { Cell::Word("-") }
}

const DIRECTIONS: [&str; 2] = ["x", "y"];

/// Largest and mean of time histories at a bound; NaN without any.
fn history(outcomes: &[JobOutcome], bound: &str, of: &dyn Fn(&JobOutcome) -> f64) -> [f64; 2] {
    let all: Vec<f64> = outcomes
        .iter()
        .filter(|o| o.bound == bound && o.failure.is_empty())
        .map(of)
        .filter(|x| x.is_finite())
        .collect();
    let mean = all.iter().sum::<f64>() / all.len() as f64;
    [mean, all.iter().copied().fold(f64::NAN, f64::max)]
}

/// Responses by bound and direction beside the time histories.
pub fn response_table(study: &Study, responses: &[BoundResponse], outcomes: &[JobOutcome]) -> Table {
    let [force, length] = [study.units[0].as_str(), study.units[1].as_str()];
    let mut table = Table::new([
        ("bound", ""),
        ("method", ""),
        ("D", length),
        ("V base", force),
        ("drift", ""),
        ("floor acceleration", "g"),
        ("T", "s"),
        ("damping", ""),
        ("mass", ""),
    ]);
    let top = |v: &[f64]| v.iter().copied().fold(f64::NAN, f64::max);
    for r in responses {
        for (name, d) in DIRECTIONS.iter().zip(&r.directions) {
            let main = d.modes.iter().reduce(|a, b| if b.mass > a.mass { b } else { a }).cloned().unwrap_or_default();
            let mass = d.modes.iter().map(|m| m.mass).sum::<f64>();
            for (how, c) in ["CQC", "SRSS"].iter().zip(&d.combined) {
                let mut row = vec![Cell::Word(r.bound), format!("{name}, {how}").into()];
                row.extend([top(&c.largest(study)), c.base_shear, top(&c.drifts), top(&c.accelerations)].map(cell));
                row.extend([main.period, main.damping, mass].map(cell));
                table.rows.push(row);
            }
        }
        let blank = || Cell::Word("");
        let mut row = vec![Cell::Word(r.bound), "100 % + 30 %".to_owned().into(), cell(top(&r.displacements))];
        row.extend((0..6).map(|_| blank()));
        table.rows.push(row);
        if outcomes.is_empty() {
            continue;
        }
        let d = |o: &JobOutcome| o.bearings.iter().map(|b| b.displacement).fold(f64::NAN, f64::max);
        let values = [
            history(outcomes, r.bound, &d),
            history(outcomes, r.bound, &|o| o.base_shear),
            history(outcomes, r.bound, &|o| top(&o.drifts)),
            history(outcomes, r.bound, &|o| top(&o.accelerations)),
        ];
        for (k, how) in ["time history, mean", "time history, largest"].iter().enumerate() {
            let mut row = vec![Cell::Word(r.bound), (*how).to_owned().into()];
            row.extend(values.map(|v| cell(v[k])));
            row.extend((0..3).map(|_| blank()));
            table.rows.push(row);
        }
    }
    table
}

/// Modes by bound and direction.
pub fn mode_table(responses: &[BoundResponse]) -> Table {
    let mut table = Table::new([
        ("bound", ""),
        ("direction", ""),
        ("mode", ""),
        ("T", "s"),
        ("damping", ""),
        ("S_a/B", "g"),
        ("mass", ""),
        ("energy of the isolators", ""),
    ]);
    for r in responses {
        for (name, d) in DIRECTIONS.iter().zip(&r.directions) {
            for (i, m) in d.modes.iter().enumerate() {
                let mut row = vec![Cell::Word(r.bound), Cell::Word(name), Cell::Number((i + 1) as f64)];
                row.extend([m.period, m.damping, m.acceleration, m.mass, m.isolators].map(cell));
                table.rows.push(row);
            }
        }
    }
    table
}

/// Effective properties of the bearings by bound, direction and type.
pub fn bearing_table(study: &Study, responses: &[BoundResponse]) -> Table {
    let [force, length] = [study.units[0].as_str(), study.units[1].as_str()];
    let stiffness = format!("{force}/{length}");
    let mut table = Table::new([
        ("bound", ""),
        ("direction", ""),
        ("type", ""),
        ("D", length),
        ("K_eff", &stiffness),
        ("beta_eff", ""),
        ("iterations", ""),
    ]);
    for r in responses {
        for (name, d) in DIRECTIONS.iter().zip(&r.directions) {
            for (k, kind) in study.bearings.iter().enumerate() {
                let mut row = vec![Cell::Word(r.bound), Cell::Word(name), kind.name.clone().into()];
                row.extend([d.displacements[k], d.stiffnesses[k], d.dampings[k], d.iterations as f64].map(cell));
                table.rows.push(row);
            }
        }
    }
    table
}

/// Remarks on the results.
pub fn remarks(study: &Study, responses: &[BoundResponse]) -> Vec<String> {
    let mut out = vec![study.code.remark()];
    out.retain(|r| !r.is_empty());
    for r in responses {
        for (name, d) in DIRECTIONS.iter().zip(&r.directions) {
            let mass = d.modes.iter().map(|m| m.mass).sum::<f64>();
            if mass < 0.9 {
                let share = 100.0 * mass;
                out.push(format!(
                    "{} bound, {name}: the modes have {share:.0} % of the mass; more are wanted",
                    r.bound
                ));
            }
        }
    }
    out
}

/// All results.
pub fn json(study: &Study, responses: &[BoundResponse], outcomes: &[JobOutcome]) -> String {
    let rows = |t: Table| serde_json::from_str::<Value>(&t.json()).unwrap_or_default();
    let all = json!({
        "title": study.title,
        "responses": rows(response_table(study, responses, outcomes)),
        "bearings": rows(bearing_table(study, responses)),
        "modes": rows(mode_table(responses)),
        "remarks": remarks(study, responses),
    });
    format!("{all:#}\n")
}

/// A page.
pub fn html(study: &Study, responses: &[BoundResponse], outcomes: &[JobOutcome]) -> String {
    let mut out = page::head(&study.title);
    out += "<p>Multimode spectral analysis with effective stiffness and composite damping of the isolators, iterated on \
            their displacement.</p>\n";
    for r in remarks(study, responses) {
        out += &format!("<p class=\"note\">{}</p>\n", page::escaped(&r));
    }
    out += "<h2>Responses</h2>\n";
    page_table(&mut out, &response_table(study, responses, outcomes));
    out += "<h2>Bearings</h2>\n";
    page_table(&mut out, &bearing_table(study, responses));
    out += "<h2>Modes</h2>\n";
    page_table(&mut out, &mode_table(responses));
    page::end(out)
}
