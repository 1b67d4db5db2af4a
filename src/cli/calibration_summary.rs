//! Plan of a calibration before it begins, and its result in a few lines.

use hysteron::calibrate::{CalibrationResult, SearchSettings, Uncertainty, significant};
use hysteron::diagnostic::SourceMap;
use hysteron::study::{Role, Study};
use serde_json::Value;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

/// Plan of a calibration: the studies, their runs and free parameters, and where the results go.
pub(super) fn plan(studies: &[(PathBuf, PathBuf)]) -> String {
    let mut out = match studies {
        [_] => String::new(),
        several => format!("{} studies:\n", several.len()),
    };
    for (file, dir) in studies {
        let shown = file.display();
        // What is wrong with a study is said when its turn comes.
        let Ok(study) = Study::load(file, &mut SourceMap::default()) else {
            let _ = writeln!(out, "{shown}: cannot be read");
            continue;
        };
        let count = |role| study.runs_of(role).count();
        let (fitted, held_out) = (count(Role::Fit), count(Role::Holdout));
        let names: Vec<&str> = study.space.free_names().collect();
        let method = SearchSettings::of(&study).map_or("", |s| s.method.name());
        let _ = writeln!(
            out,
            "{shown}: {fitted} run{} fitted, {held_out} held out; {} free: {}; {method}; results go to {}",
            if fitted == 1 { "" } else { "s" },
            names.len(),
            names.join(", "),
            dir.display()
        );
    }
    out
}

/// Notes about results in a folder that another study, or a diagnosis, has left there and that are replaced.
pub(super) fn replaced(dir: &Path, study: &Study) -> Vec<String> {
    let read =
        |name: &str| -> Option<Value> { serde_json::from_str(&hysteron_files::read_text(dir.join(name)).ok()?).ok() };
    let mut notes = vec![];
    if let Some(old) = read("calibration.json") {
        let mut parameters: Vec<&str> = study.space.parameters.iter().map(|p| p.name.as_str()).collect();
        parameters.sort_unstable();
        let same_parameters = old["parameters"].as_object().is_some_and(|o| o.keys().eq(parameters.iter().copied()));
        let old_runs = old["runs"].as_array().map(Vec::as_slice).unwrap_or_default();
        let same_runs =
            old_runs.iter().map(|r| r["name"].as_str()).eq(study.runs.iter().map(|r| Some(r.name.as_str())));
        let name = old["study"].as_str();
        let own_name = if study.title.is_empty() { &study.model } else { &study.title };
        if !same_parameters || !same_runs || name.is_some_and(|n| n != own_name) {
            let name = name.map_or(String::new(), |n| format!(" \"{n}\""));
            notes.push(format!("{} holds the result of another study{name}: it is replaced", dir.display()));
        }
    }
    if read("diagnosis.json").is_some() && dir.join("report.html").exists() {
        let report = dir.join("report.html");
        notes.push(format!("{} is the report of a diagnosis: it is replaced", report.display()));
    }
    notes
}

/// The result in a few lines.
pub(super) fn summary(result: &CalibrationResult, dir: &Path) -> String {
    let study = &result.study;
    let title = if study.title.is_empty() { study.model.as_str() } else { study.title.as_str() };
    let mut out = String::new();
    let _ = writeln!(
        out,
        "{title}: objective {}, {} evaluations ({}), {:.1} s, {:.0} evaluations a second",
        significant(result.objective, 4),
        result.search.evaluations(),
        result.search.stopped_because().words(),
        result.wall_time,
        result.search.evaluations() as f64 / result.wall_time.max(1.0e-9)
    );
    runs(&mut out, result);
    parameters(&mut out, result);
    if let Some(p) = &result.posterior {
        for q in &p.quantiles {
            let [median, lower, upper] = [q.median, q.lower, q.upper].map(|x| significant(x, 4));
            let _ = writeln!(out, "  posterior of {}: {median} ({lower} to {upper})", q.name);
        }
        let _ = writeln!(out, "  acceptance {:.2}, {:.0} independent draws", p.acceptance, p.effective_draws);
    }
    let statistics = result.repeat_statistics();
    if statistics.repeats > 1 {
        let (best, worst, deviation) = (statistics.best, statistics.worst, statistics.deviation);
        let _ = writeln!(
            out,
            "  {} repeats: best {best:.6}, worst {worst:.6}, deviation {deviation:.2e}",
            statistics.repeats
        );
    }
    for (kind, n) in result.search.failures() {
        let message = result.search.repeats.iter().find_map(|r| r.failure_messages.get(kind));
        let _ = writeln!(out, "  {n} points without an answer: {}", message.map_or(kind, String::as_str));
    }
    let _ = writeln!(out, "  written to {}", dir.display());
    out
}

fn runs(out: &mut String, result: &CalibrationResult) {
    for (run, scored) in result.study.runs.iter().zip(&result.scored_runs) {
        let role = if run.role == Role::Fit { "fit" } else { "holdout" };
        let _ = match scored {
            Ok(scored) => {
                let dropped: usize = scored.scores.iter().map(|s| s.dropped).sum();
                let note = if dropped > 0 {
                    format!(", {dropped} samples after the end of the analysis left out")
                } else {
                    String::new()
                };
                writeln!(out, "  {role:8} {}: NMSE {}{note}", run.name, significant(scored.nmse(&run.observe), 4))
            }
            Err(error) => writeln!(out, "  {role:8} {}: {error}", run.name),
        };
    }
}

fn parameters(out: &mut String, result: &CalibrationResult) {
    let intervals = result.uncertainty.iter().flat_map(|u| &u.intervals);
    for (p, v) in result.study.space.parameters.iter().zip(&result.values) {
        let _ = match intervals.clone().find(|i| i.name == p.name).map(|i| i.shown()) {
            Some([value, lower, upper]) => writeln!(out, "  {} = {value}  ({lower} to {upper})", p.name),
            None => writeln!(out, "  {} = {}", p.name, significant(*v, 6)),
        };
    }
    // The judgement names them as well.
    for name in result.at_bounds().into_iter().filter(|_| result.uncertainty.is_none()) {
        let _ = writeln!(out, "  note: {name} is at a bound of its range");
    }
    for line in result.uncertainty.iter().flat_map(Uncertainty::notes) {
        let _ = writeln!(out, "  note: {line}");
    }
    for line in result.uncertainty.iter().flat_map(|u| &u.judgement.sentences) {
        let _ = writeln!(out, "  {line}");
    }
    for p in result.profiles.iter().flatten() {
        let end = |e: Option<f64>| e.map_or("open".into(), |x| significant(x, 5));
        let _ = writeln!(out, "  profile of {}: {} to {}", p.name, end(p.lower), end(p.upper));
    }
}
