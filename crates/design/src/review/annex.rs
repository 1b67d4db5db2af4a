//! Results of a review as files: tables, and JSON without histories.

use super::{Review, members, tables};
use crate::check::check_table;
use crate::isolate::{Job, JobOutcome, Study, jobs};
use hysteron_identify::report::Table;
use serde_json::{Value, json};

fn rows(table: &Table) -> Value {
    serde_json::from_str(&table.json()).unwrap_or_default()
}

/// What went into the results, so that two of them can be compared.
fn inputs(study: &Study, outcomes: &[JobOutcome]) -> Value {
    let bearing = |b: &crate::isolate::BearingType| {
        let factors = |bound: &str| [0, 1].map(|of| study.factor(b, bound, of));
        json!({
            "type": b.name, "count": b.tags.len(), "q_d": b.q_d, "k_d": b.k_d, "yield_displacement": b.yield_displacement,
            "lower_q_d": factors("lower")[0], "lower_k_d": factors("lower")[1],
            "upper_q_d": factors("upper")[0], "upper_k_d": factors("upper")[1],
            "displacement": b.displacement, "critical_load": b.critical_load, "diameter": b.diameter, "tension": b.tension,
            "transition": b.transition.name(), "substructure": b.substructure, "tags": b.tags,
        })
    };
    let motion = |(p, f): (&crate::motion::Pair, &f64)| json!({"motion": p.components[0].name, "factor": f});
    let script = std::path::absolute(&study.script).unwrap_or_else(|_| study.script.clone());
    let script = script.to_string_lossy();
    let script = outcomes.iter().flat_map(|o| &o.inputs).find(|(path, _)| *path == script);
    json!({
        "code": study.code.label,
        "script": script.map(|(_, hash)| format!("{hash:016x}")),
        "structure": study.structure.name(),
        "plan": study.plan,
        "scale": study.scale,
        "regular": study.regular,
        "project_tests": study.project_tests,
        "live_over_dead": study.live.over_dead,
        "live_in_script": study.live.in_script,
        "sms": study.sms,
        "substructure_weight": study.substructure_weight,
        "floors": study.floors.len(),
        "target": study.target_words,
        "weight": study.weight,
        "gravity": study.gravity,
        "eccentricities": study.eccentricities,
        "response_modification": study.response_modification,
        "motions": study.motions.iter().zip(&study.factors).map(motion).collect::<Vec<_>>(),
        "bearings": study.bearings.iter().map(bearing).collect::<Vec<_>>(),
    })
}

/// An analysis without its histories, which stand in the file that is named.
fn analysis(job: &Job, o: &JobOutcome) -> Value {
    let bearing = |b: &crate::isolate::BearingOutcome| {
        json!({
            "tag": b.tag, "displacement": b.displacement, "residual": b.residual, "compression": b.compression,
            "least": b.least, "uplift": b.uplift, "shear": b.shear, "energy": b.energy, "stability": b.stability,
        })
    };
    json!({
        "bound": o.bound, "motion": o.motion, "eccentricity": o.eccentricity, "failure": o.failure, "time": o.time,
        "retried": o.retried, "base_shear": o.base_shear, "shear_above": o.shear_above, "drifts": o.drifts,
        "accelerations": o.accelerations, "base_displacement": o.base_displacement, "contact": o.contact,
        "damping_share": o.damping_share, "bearings": o.bearings.iter().map(bearing).collect::<Vec<_>>(),
        "histories": format!("analyses/{}.json", job.name()),
    })
}

/// All results but histories and spectra, which are files beside it.
pub fn json(study: &Study, outcomes: &[JobOutcome], review: &Review) -> String {
    let code = &study.code;
    let suite = &review.suite;
    let all = json!({
        "title": study.title,
        "code": {"name": code.name, "edition": code.edition, "text_read": code.text_read, "source": code.source},
        "study": inputs(study, outcomes),
        "agreement": rows(&study.agreement.table()),
        "modes": rows(&tables::modes(review)),
        "suite": {
            "combination": suite.combination, "range_s": suite.range, "least_asked": finite(suite.least),
            "least_ratio": suite.lowest.map(|l| l.0), "at_period_s": suite.lowest.map(|l| l.1),
        },
        "lateral_force": rows(&tables::procedure(study, review)),
        "design_values": rows(&tables::design_values(review)),
        "schedule": rows(&tables::schedule(study, review)),
        "loads": rows(&tables::loads(study, review)),
        "structure": rows(&tables::structure(study, outcomes)),
        "storeys": rows(&tables::storeys(study, outcomes)),
        "checks": rows(&check_table(&review.checks)),
        "not_checked": review.not_checked,
    });
    // One analysis a line: the rest is for people.
    let text = format!("{all:#}");
    let list: Vec<String> = jobs(study).iter().zip(outcomes).map(|(j, o)| analysis(j, o).to_string()).collect();
    let body = text.trim_end().trim_end_matches('}').trim_end();
    format!("{body},\n  \"analyses\": [\n    {}\n  ]\n}}\n", list.join(",\n    "))
}

fn finite(x: f64) -> Option<f64> {
    Some(x).filter(|x| x.is_finite())
}

/// Spectra of the suite beside the target.
fn suite_table(study: &Study, review: &Review) -> Table {
    let s = &review.suite;
    let mut columns = vec![("T".to_owned(), "s".to_owned())];
    columns.extend(["target", "mean"].map(|n| (n.to_owned(), "g".to_owned())));
    columns.extend(study.motions.iter().map(|p| (p.components[0].name.clone(), "g".to_owned())));
    let mut table = tables::table_of(columns);
    for (i, t) in s.periods.iter().enumerate() {
        let values = [*t, s.target[i], s.mean[i]].into_iter().chain(s.pairs.iter().map(|p| p[i]));
        table.rows.push(values.map(tables::cell).collect());
    }
    table
}

/// Files of the results with their texts.
pub fn files(study: &Study, outcomes: &[JobOutcome], review: &Review) -> Vec<(&'static str, String)> {
    vec![
        ("schedule.csv", tables::schedule(study, review).csv()),
        ("loads.csv", tables::loads(study, review).csv()),
        ("structure.csv", tables::structure(study, outcomes).csv()),
        ("members.csv", members::members(study, outcomes, review).csv()),
        ("diaphragms.csv", members::diaphragms(study, outcomes, review).csv()),
        ("below.csv", members::below(study, review).csv()),
        ("storeys.csv", tables::storeys(study, outcomes).csv()),
        ("floor_spectra.csv", tables::floor_spectra(study, outcomes).csv()),
        ("design_values.csv", tables::design_values(review).csv()),
        ("lateral_force.csv", tables::procedure(study, review).csv()),
        ("modes.csv", tables::modes(review).csv()),
        ("suite.csv", suite_table(study, review).csv()),
        ("checks.csv", check_table(&review.checks).csv()),
        ("analyses.csv", tables::analyses(study, outcomes).csv()),
        ("isolation.json", json(study, outcomes, review)),
        ("report.html", super::html(study, outcomes, review)),
    ]
}
