//! Tables of a review.

use super::Review;
use super::governing::{Response, governing, top};
use crate::isolate::{BOUNDS, JobOutcome, Study};
use crate::lateral_force::LateralForce;
use hysteron_identify::report::{Cell, Column, Table};

pub(super) fn cell(x: f64) -> Cell {
    if x.is_finite() { Cell::Number(x) } else { Cell::Word("-") }
}

/// A table from names and units that are not known before.
pub(super) fn table_of(columns: impl IntoIterator<Item = (String, String)>) -> Table {
    let column = |(name, unit): (String, String)| Column { name: name.into(), unit };
    Table { columns: columns.into_iter().map(column).collect(), rows: vec![] }
}

/// Design values by bound.
pub(super) fn design_values(review: &Review) -> Table {
    let mut table = Table::new([
        ("quantity", ""),
        ("unit", ""),
        ("bound", ""),
        ("suite", ""),
        ("least", ""),
        ("factor", ""),
        ("design", ""),
        ("clause", ""),
    ]);
    let mut quantities: Vec<&str> = vec![];
    review.values.iter().for_each(|v| {
        if !quantities.contains(&v.quantity) {
            quantities.push(v.quantity);
        }
    });
    for quantity in quantities {
        for v in review.values.iter().filter(|v| v.quantity == quantity) {
            let mut row = vec![Cell::Word(v.quantity), v.unit.clone().into(), Cell::Word(v.bound)];
            row.extend([v.analysis, v.least, v.factor, v.design].map(cell));
            row.push(v.citation.clause.clone().into());
            table.rows.push(row);
        }
    }
    table
}

/// Schedule of the bearings.
pub(super) fn schedule(study: &Study, review: &Review) -> Table {
    let [force, length] = [study.units[0].as_str(), study.units[1].as_str()];
    let energy = if force.is_empty() { String::new() } else { format!("{force} {length}") };
    let mut table = Table::new([
        ("type", ""),
        ("bearing", ""),
        ("D", length),
        ("D design", length),
        ("bound", ""),
        ("D_TM plan", length),
        ("residual", length),
        ("V design", force),
        ("P gravity", force),
        ("P average", force),
        ("P max", force),
        ("P min", force),
        ("uplift", length),
        ("P/P_cr history", ""),
        ("P/P_cr", ""),
        ("P/P_cr scaled", ""),
        ("energy", &energy),
    ]);
    for b in &review.bearings {
        let mut row: Vec<Cell> = vec![study.bearings[b.kind].name.clone().into(), (b.tag as f64).into()];
        row.extend([b.displacement, b.design].map(cell));
        row.push(Cell::Word(b.bound));
        row.extend([b.plan, b.residual, b.shear, b.gravity].map(cell));
        row.extend(b.loads.map(cell));
        row.extend([b.uplift, b.stability, b.stability_design[0], b.stability_design[1], b.energy].map(cell));
        table.rows.push(row);
    }
    table
}

/// Vertical loads of the bearings by their parts.
pub(super) fn loads(study: &Study, review: &Review) -> Table {
    let force = study.units[0].as_str();
    let mut table = Table::new([
        ("type", ""),
        ("bearing", ""),
        ("D", force),
        ("L", force),
        ("Q_E up", force),
        ("Q_E down", force),
        ("average", force),
        ("largest", force),
        ("least", force),
    ]);
    for b in &review.bearings {
        let mut row: Vec<Cell> = vec![study.bearings[b.kind].name.clone().into(), (b.tag as f64).into()];
        row.extend([b.dead_live[0], b.dead_live[1], b.seismic[0], b.seismic[1]].map(cell));
        row.extend(b.loads.map(cell));
        table.rows.push(row);
    }
    table
}

/// The equivalent lateral force procedure: quantities with their clauses by rows, bounds by columns.
pub(super) fn procedure(study: &Study, review: &Review) -> Table {
    let [force, length] = [study.units[0].as_str(), study.units[1].as_str()];
    let stiffness = if force.is_empty() { String::new() } else { format!("{force}/{length}") };
    let mut table =
        Table::new([("quantity", ""), ("unit", ""), ("lower", ""), ("nominal", ""), ("upper", ""), ("clause", "")]);
    let mut add = |name: String, unit: &str, values: [f64; 3], clause: String| {
        if values.iter().any(|v| v.is_finite()) {
            let mut row: Vec<Cell> = vec![name.into(), unit.to_owned().into()];
            row.extend(values.map(cell));
            row.push(clause.into());
            table.rows.push(row);
        }
    };
    let clause = |rule: &str| study.code.clause(rule);
    let of = |f: fn(&LateralForce) -> f64| [0, 1, 2].map(|k| review.lateral_force[k].as_ref().map_or(f64::NAN, f));
    add("D_M".into(), length, of(|l| l.displacement), clause("displacement"));
    add("T_M".into(), "s", of(|l| l.period), String::new());
    add("k_M".into(), &stiffness, of(|l| l.stiffness), String::new());
    add("beta_M".into(), "", of(|l| l.damping), String::new());
    add("B_M".into(), "", of(|l| l.coefficient), clause("damping_coefficient"));
    add("V_b".into(), force, of(|l| l.shear_below), clause("force_below"));
    add("V_st".into(), force, of(|l| l.shear_above), clause("force_above"));
    let forces = |f: &dyn Fn(&super::StoreyForces) -> f64| {
        BOUNDS.map(|b| review.forces.iter().find(|s| s.bound == b).map_or(f64::NAN, f))
    };
    add("R_I".into(), "", forces(&|s| s.reduction), clause("force_above"));
    add("V_s by activation".into(), force, forces(&|s| s.activation), clause("force_minimum"));
    add("V_s on a fixed base".into(), force, forces(&|s| s.fixed_base), clause("force_minimum_fixed"));
    add("V_s".into(), force, forces(&|s| s.shear_above), clause("force_above"));
    add("k of the heights".into(), "", forces(&|s| s.exponent), clause("vertical_distribution"));
    for (k, floor) in study.floors.iter().enumerate() {
        let values = forces(&|s| s.forces.get(k).copied().unwrap_or(f64::NAN));
        add(format!("F at node {}", floor.node), force, values, clause("vertical_distribution"));
    }
    table
}

/// Mean and largest responses of the structure by bound.
pub(super) fn structure(study: &Study, outcomes: &[JobOutcome]) -> Table {
    let [force, length] = [study.units[0].as_str(), study.units[1].as_str()];
    let mut columns = vec![("quantity".to_owned(), String::new()), ("unit".to_owned(), String::new())];
    for bound in BOUNDS {
        columns.extend(["mean", "largest"].map(|w| (format!("{bound} {w}"), String::new())));
    }
    let mut table = table_of(columns);
    let rows: [(&str, &str, Plain); 6] = [
        ("displacement of bearings", length, |o| o.bearings.iter().map(|b| b.displacement).reduce(f64::max)),
        ("shear of all bearings", force, |o| Some(o.base_shear)),
        ("shear above, unreduced", force, |o| Some(o.shear_above).filter(|v| *v > 0.0)),
        ("storey drift ratio", "", |o| top(&o.drifts)),
        ("floor acceleration", "g", |o| top(&o.accelerations)),
        ("displacement of the lowest floor", length, |o| top(&o.base_displacement)),
    ];
    for (name, unit, of) in rows {
        let found: Vec<Option<Response>> = BOUNDS.iter().map(|b| governing(study, outcomes, b, &of)).collect();
        if found.iter().any(Option::is_some) {
            let mut row = vec![Cell::Word(name), unit.to_owned().into()];
            let values = found.iter().flat_map(|r| r.map_or([f64::NAN; 2], |r| [r.mean, r.largest]));
            row.extend(values.map(cell));
            table.rows.push(row);
        }
    }
    table
}

/// A response of an analysis, by a plain function.
type Plain = fn(&JobOutcome) -> Option<f64>;
/// A response of an analysis.
type Of<'a> = &'a dyn Fn(&JobOutcome) -> Option<f64>;

/// Drifts and accelerations over the height: mean and largest of each bound.
pub(super) fn storeys(study: &Study, outcomes: &[JobOutcome]) -> Table {
    let length = study.units[1].clone();
    let mut columns = vec![("floor".to_owned(), String::new()), ("height".to_owned(), length)];
    for what in ["drift", "acceleration"] {
        let unit = if what == "drift" { "" } else { "g" };
        for bound in BOUNDS {
            columns.extend(["mean", "largest"].map(|w| (format!("{what} {bound} {w}"), unit.to_owned())));
        }
    }
    let mut table = table_of(columns);
    let mut height = 0.0;
    for (k, floor) in study.floors.iter().enumerate() {
        height += if k == 0 { 0.0 } else { floor.height };
        let mut row: Vec<Cell> = vec![(floor.node as f64).into(), height.into()];
        let drift = |o: &JobOutcome| o.drifts.get(k.checked_sub(1)?).copied();
        let acceleration = |o: &JobOutcome| o.accelerations.get(k).copied();
        for f in [&drift as Of<'_>, &acceleration] {
            for bound in BOUNDS {
                let found = governing(study, outcomes, bound, f);
                row.extend(found.map_or([f64::NAN; 2], |r| [r.mean, r.largest]).map(cell));
            }
        }
        table.rows.push(row);
    }
    table
}

/// Floor spectra: mean and largest of each bound by floor and period.
pub(super) fn floor_spectra(study: &Study, outcomes: &[JobOutcome]) -> Table {
    let mut columns = vec![("floor".to_owned(), String::new()), ("T".to_owned(), "s".to_owned())];
    for bound in BOUNDS {
        columns.extend(["mean", "largest"].map(|w| (format!("{bound} {w}"), "g".to_owned())));
    }
    let mut table = table_of(columns);
    let periods = outcomes.iter().map(|o| &o.periods).find(|p| !p.is_empty());
    for (k, floor) in study.floors.iter().enumerate() {
        for (i, period) in periods.into_iter().flatten().enumerate() {
            let mut row: Vec<Cell> = vec![(floor.node as f64).into(), (*period).into()];
            for bound in BOUNDS {
                let found = governing(study, outcomes, bound, &|o| o.floor_spectra.get(k)?.get(i).copied());
                row.extend(found.map_or([f64::NAN; 2], |r| [r.mean, r.largest]).map(cell));
            }
            table.rows.push(row);
        }
    }
    table
}

/// Periods and masses of the main modes, on a fixed base and by bound.
pub(super) fn modes(review: &Review) -> Table {
    let mut table = Table::new([("structure", ""), ("mode", ""), ("T", "s"), ("mass x", ""), ("mass y", "")]);
    let fixed = review.periods.fixed.iter().map(|f| ("fixed base", f));
    let isolated = BOUNDS.iter().copied().zip(&review.periods.isolated);
    for (name, found) in fixed.chain(isolated) {
        let Ok(directions) = found else { continue };
        for i in 0..directions.first().map_or(0, Vec::len) {
            let mut row = vec![Cell::Word(name), ((i + 1) as f64).into(), cell(directions[0][i].period)];
            row.extend([0, 1].map(|d| directions.get(d).map_or(Cell::Word("-"), |m| cell(m[i].mass))));
            table.rows.push(row);
        }
    }
    table
}

/// The analyses.
pub(super) fn analyses(study: &Study, outcomes: &[JobOutcome]) -> Table {
    let [force, length] = [study.units[0].as_str(), study.units[1].as_str()];
    let mut table = Table::new([
        ("bound", ""),
        ("motion", ""),
        ("e_x", ""),
        ("e_y", ""),
        ("to time", "s"),
        ("D", length),
        ("V base", force),
        ("end", ""),
    ]);
    for o in outcomes {
        let end = match (o.failure.is_empty(), o.retried) {
            (true, false) => "complete".to_owned(),
            (true, true) => "complete with shorter steps".to_owned(),
            _ => o.failure.clone(),
        };
        let mut row: Vec<Cell> = vec![o.bound.clone().into(), o.motion.clone().into()];
        row.extend(o.eccentricity.map(Cell::from));
        row.push(cell(o.time));
        row.push(cell(o.bearings.iter().map(|b| b.displacement).fold(f64::NAN, f64::max)));
        row.extend([cell(o.base_shear), end.into()]);
        table.rows.push(row);
    }
    table
}
