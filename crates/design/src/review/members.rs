//! Forces of members and diaphragms by load combination.

use super::Review;
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
    for combination in ["most dead", "least dead"] {
        columns.extend(["largest", "least"].map(|w| (format!("{combination}, {w}"), String::new())));
    }
    let mut table = table_of(columns);
    let rule = |name: &str| study.code.value("load_combinations", name).unwrap_or(f64::NAN);
    let has_vertical = study.motions.iter().any(|p| p.vertical.is_some());
    let vertical = if has_vertical { 0.0 } else { rule("vertical") * study.sms.unwrap_or(0.0) };
    let ratio = study.live.over_dead;
    let dead_share = 1.0 / (1.0 + study.live.in_script * ratio);
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
            let (dead, live) = (dead_share * gravity, ratio * dead_share * gravity);
            let most = (rule("dead_max") + vertical) * dead + rule("live_max") * live;
            let least = (rule("dead_min") - vertical) * dead;
            let mut row: Vec<Cell> = vec![(*tag as f64).into(), ((i + 1) as f64).into(), cell(*gravity)];
            row.extend([cell(up), Cell::Word(up_bound), cell(-down), Cell::Word(down_bound)]);
            row.extend([most + up, most - down, least + up, least - down].map(cell));
            table.rows.push(row);
        }
    }
    table
}

/// Inertia forces of the floors, above and at the base level: largest acceleration times mass by bound, scaled up like the shear
/// above and not divided by R_I; F_x of the equivalent lateral force procedure beside it.
pub(super) fn diaphragms(study: &Study, outcomes: &[JobOutcome], review: &Review) -> Table {
    let force = study.units[0].clone();
    let mut columns = vec![("floor".to_owned(), String::new()), ("weight".to_owned(), force.clone())];
    for bound in BOUNDS {
        columns.extend(["inertia", "F_x"].map(|w| (format!("{bound} {w}"), force.clone())));
    }
    let mut table = table_of(columns);
    for (k, floor) in study.floors.iter().enumerate() {
        let mut row: Vec<Cell> = vec![(floor.node as f64).into(), floor.weight.into()];
        for bound in BOUNDS {
            let a = value(study, outcomes, bound, &|o| top(o.accelerations.get(k..=k)?));
            row.push(cell(a * floor.weight * factor(&review.values, bound, SHEAR_ABOVE)));
            let forces = review.forces.iter().find(|f| f.bound == bound);
            row.push(cell(forces.and_then(|f| f.forces.get(k)).copied().unwrap_or(f64::NAN)));
        }
        table.rows.push(row);
    }
    table
}
