//! Forces of members, diaphragms and bearings by load combination.

use super::Review;
use super::combinations::{combinations, dead_and_live};
use super::distribution::reduction;
use super::governing::{top, value};
use super::rules::{SHEAR_ABOVE, factor};
use super::tables::{cell, table_of};
use crate::isolate::{BOUNDS, JobOutcome, Study};
use hysteron_identify::report::{Cell, Table};

/// Local end forces of the members of the study: gravity, Q_E of the bound that governs, and the combinations with the largest and
/// the least factors on the dead load, each with both signs of Q_E. Q_E is scaled up like the shear above, and not divided
/// by R_I.
pub(super) fn members(study: &Study, outcomes: &[JobOutcome], review: &Review) -> Table {
    let names = ["element", "component", "gravity", "Q_E largest", "bound", "Q_E least", "bound of least"];
    let mut columns: Vec<(String, String)> = names.map(|n| (n.to_owned(), String::new())).into();
    for c in combinations(study) {
        columns.extend(["largest", "least"].map(|w| (format!("{}, {w}", c.name), String::new())));
    }
    let mut table = table_of(columns);
    for (k, tag) in study.members.iter().enumerate() {
        let known = outcomes.iter().find_map(|o| o.members.get(k).filter(|m| !m.gravity.is_empty()));
        let Some(first) = known else { continue };
        for (i, gravity) in first.gravity.iter().enumerate() {
            // Changes from gravity, upwards and downwards.
            let change = |sign: f64| {
                let of = |o: &JobOutcome| {
                    let m = o.members.get(k)?;
                    let extreme = if sign > 0.0 { m.largest.get(i)? } else { m.least.get(i)? };
                    Some(sign * (extreme - m.gravity.get(i)?))
                };
                let by_bound =
                    |b: &&'static str| (value(study, outcomes, b, &of) * factor(&review.values, b, SHEAR_ABOVE), *b);
                let found = BOUNDS.iter().map(by_bound).filter(|v| v.0.is_finite());
                found.reduce(|a, b| if b.0 > a.0 { b } else { a }).unwrap_or((f64::NAN, ""))
            };
            let ((up, up_bound), (down, down_bound)) = (change(1.0), change(-1.0));
            let [most, least] = combinations(study).map(|c| c.of(dead_and_live(study, *gravity)));
            let mut row: Vec<Cell> = vec![(*tag as f64).into(), ((i + 1) as f64).into(), cell(*gravity)];
            row.extend([cell(up), Cell::Word(up_bound), cell(-down), Cell::Word(down_bound)]);
            row.extend([most + up, most - down, least + up, least - down].map(cell));
            table.rows.push(row);
        }
    }
    table
}

/// Forces of the floors by load combination. The inertia force of each bound is the largest acceleration times mass, scaled up
/// like the shear above and not divided by R_I; F_x of the equivalent lateral force procedure stands beside it. The horizontal
/// force of the combinations is the governing inertia force over R_I or F_x, whichever is larger, of either sign and along
/// either direction, with the vertical load of D and L.
pub(super) fn diaphragms(study: &Study, outcomes: &[JobOutcome], review: &Review) -> Table {
    let force = study.units[0].clone();
    let mut columns = vec![("floor".to_owned(), String::new()), ("weight".to_owned(), force.clone())];
    for bound in BOUNDS {
        columns.extend(["inertia", "F_x"].map(|w| (format!("{bound} {w}"), force.clone())));
    }
    columns.push(("bound".into(), String::new()));
    columns.push(("horizontal".into(), force.clone()));
    columns.extend(combinations(study).map(|c| (format!("{}, vertical", c.name), force.clone())));
    let mut table = table_of(columns);
    for (k, floor) in study.floors.iter().enumerate() {
        let mut row: Vec<Cell> = vec![(floor.node as f64).into(), floor.weight.into()];
        let mut governing = (f64::NAN, "");
        for bound in BOUNDS {
            let a = value(study, outcomes, bound, &|o| top(o.accelerations.get(k..=k)?));
            let inertia = a * floor.weight * factor(&review.values, bound, SHEAR_ABOVE);
            let forces = review.forces.iter().find(|f| f.bound == bound);
            let lateral = forces.and_then(|f| f.forces.get(k)).copied().unwrap_or(f64::NAN);
            row.extend([inertia, lateral].map(cell));
            let design = (inertia / reduction(study)).max(lateral.abs());
            if governing.0.is_nan() || design > governing.0 {
                governing = (design, bound);
            }
        }
        row.extend([Cell::Word(governing.1), cell(governing.0)]);
        row.extend(combinations(study).map(|c| cell(c.of(dead_and_live(study, floor.weight)))));
        table.rows.push(row);
    }
    table
}

/// Forces of the bearings on the structure below and above by load combination: shear at the design displacement, vertical load,
/// and the moment (V h + P D)/2 at either end, h the height of the bearing and D its design displacement. A slider gives the
/// whole P D to the side that its plate is on, twice this part.
pub(super) fn below(study: &Study, review: &Review) -> Table {
    let [force, length] = [study.units[0].as_str(), study.units[1].as_str()];
    let moment = if force.is_empty() { String::new() } else { format!("{force} {length}") };
    let mut columns = vec![("type".to_owned(), String::new()), ("bearing".to_owned(), String::new())];
    columns.extend([("V".to_owned(), force.to_owned()), ("V h/2".to_owned(), moment.clone())]);
    for c in combinations(study) {
        columns.extend([
            (format!("{}, P", c.name), force.to_owned()),
            (format!("{}, P D/2", c.name), moment.clone()),
            (format!("{}, moment", c.name), moment.clone()),
        ]);
    }
    let mut table = table_of(columns);
    for b in &review.bearings {
        let mut row: Vec<Cell> = vec![study.bearings[b.kind].name.clone().into(), (b.tag as f64).into()];
        let of_shear = 0.5 * b.shear * b.height;
        row.extend([b.shear, of_shear].map(cell));
        for load in [b.loads[1], b.loads[2]] {
            let of_load = 0.5 * load * b.design;
            row.extend([load, of_load, of_shear + of_load.abs()].map(cell));
        }
        table.rows.push(row);
    }
    table
}
