//! Report of a study as tables, JSON and a page.

use super::{JobOutcome, Study, Summary};
use crate::check::check_table;
use crate::prototype::report::{page_table, page_table_in_parts};
use hysteron_identify::report::{Table, html as page};
use hysteron_opensees::chart::{Curve, Figure, Mark};
use serde_json::{Value, json};

/// All results.
pub fn json(study: &Study, outcomes: &[JobOutcome], summary: &Summary) -> String {
    let rows = |t: &Table| serde_json::from_str::<Value>(&t.json()).unwrap_or_default();
    let all = json!({
        "title": study.title,
        "code": {"name": study.code.name, "text_read": study.code.text_read, "source": study.code.source},
        "factors_of_motions": study.factors,
        "agreement": rows(&study.agreement.table()),
        "schedule": rows(&summary.schedule),
        "structure": rows(&summary.structure),
        "checks": rows(&check_table(&summary.checks)),
        "not_checked": summary.not_checked,
        "analyses": outcomes,
    });
    format!("{all:#}\n")
}

fn figure(title: &str, x: String, y: String, curves: Vec<Curve>, equal: bool) -> Figure {
    Figure { title: title.into(), x_label: x, y_label: y, curves, equal, ..Figure::default() }
}

/// A page: checks, schedule, structure, floor spectra, loops and orbits of the first bearing of each type.
pub fn html(study: &Study, outcomes: &[JobOutcome], summary: &Summary) -> String {
    let mut out = page::head(&study.title);
    let pairs = study.motions.len();
    let count = format!("{} analyses, {pairs} pairs of motions", outcomes.len());
    out += &format!("<p>{count}.</p><p class=\"note\">{}</p>\n", page::escaped(&study.code.remark()));
    out += "<h2>Checks</h2>\n";
    page_table(&mut out, &check_table(&summary.checks));
    out += "<p>Not checked:</p><ul>\n";
    for text in &summary.not_checked {
        out += &format!("<li>{}</li>\n", page::escaped(text));
    }
    out += "</ul><h2>Study and script</h2>\n";
    page_table(&mut out, &study.agreement.table());
    for text in &study.agreement.remarks {
        out += &format!("<p class=\"note\">{}</p>\n", page::escaped(text));
    }
    out += "<h2>Structure by bound</h2>\n";
    page_table(&mut out, &summary.structure);
    for (bound, l) in super::BOUNDS.iter().zip(&summary.lateral_force) {
        if let Err(e) = l {
            out +=
                &format!("<p class=\"note\">Equivalent lateral force procedure, {bound}: {}</p>\n", page::escaped(e));
        }
    }
    out += "<h2>Bearing schedule</h2>\n";
    page_table_in_parts(&mut out, &summary.schedule, 2, 8);
    out += "<h2>Floor spectra</h2>\n";
    for (k, floor) in study.floors.iter().enumerate() {
        let curve = |o: &JobOutcome| {
            let points = o.periods.iter().copied().zip(o.floor_spectra.get(k)?.iter().copied()).collect();
            Some(Curve { name: format!("{} {}", o.bound, o.motion), points, mark: Mark::Line })
        };
        let curves = outcomes.iter().filter_map(curve).take(12).collect();
        let title = format!("Floor at node {}, 5 % damping", floor.node);
        page::picture(&mut out, &figure(&title, "Period [s]".into(), "Acceleration [g]".into(), curves, false));
    }
    out += "<h2>Loops and orbits</h2>\n";
    let [force, length] = &study.units;
    for o in outcomes.iter().filter(|o| o.eccentricity == study.eccentricities[0]) {
        for b in o.bearings.iter().filter(|b| !b.hysteresis.is_empty()) {
            let curve = |points: &[[f64; 2]]| vec![page::line("", points.iter().map(|p| (p[0], p[1])).collect())];
            let title = format!("Bearing {}, {}, {}", b.tag, o.bound, o.motion);
            let (x, y) = (page::labelled("u_x", length), page::labelled("F_x", force));
            page::picture(&mut out, &figure(&title, x.clone(), y, curve(&b.hysteresis), false));
            page::picture(&mut out, &figure(&title, x, page::labelled("u_y", length), curve(&b.orbit), true));
        }
    }
    out += "<h2>Analyses</h2>\n";
    let row = |o: &JobOutcome| {
        let [ex, ey] = o.eccentricity;
        let state = if o.failure.is_empty() { "complete".to_owned() } else { o.failure.clone() };
        vec![o.bound.clone(), o.motion.clone(), format!("{ex} {ey}"), page::number(o.time), state]
    };
    page::table(&mut out, &["bound", "motion", "eccentricity", "to time", "end"], outcomes.iter().map(row));
    page::end(out)
}
