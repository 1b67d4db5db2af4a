//! `hysteron ida` and `hysteron fragility`: limit states over intensity, and their fragility functions.

use super::files::write_atomically;
use super::run::print;
use super::study_jobs::{Outcome, StudyJobs, StudyJobsArgs, finish, load};
use clap::Args;
use hysteron::design::fragility::{Fit, Observation};
use hysteron::design::incremental::{Ending, Summary, Trace, bounds, hunt, intensities, report, stripe, summary};
use hysteron::design::isolate::Study;
use hysteron::recordings::Table as Columns;
use std::path::{Path, PathBuf};

#[derive(Args, Debug)]
pub(super) struct IdaArgs {
    #[command(flatten)]
    jobs: StudyJobsArgs,
    /// Where the results go
    #[arg(long, value_name = "DIR", default_value = "ida")]
    out: PathBuf,
}

#[derive(Args, Debug)]
pub(super) struct FragilityArgs {
    /// Options, and the study: or a table (.csv) of intensities, numbers of records, and records that reached a limit state
    #[command(flatten)]
    jobs: StudyJobsArgs,
    /// Where the results go
    #[arg(long, value_name = "DIR", default_value = "fragility")]
    out: PathBuf,
}

/// Run `hysteron ida`; the exit status.
pub(super) fn ida(a: &IdaArgs) -> i32 {
    let stop = a.jobs.stop_flag();
    let result = load(&a.jobs.study, &stop).and_then(|study| {
        let runs =
            study.performance.hunt.as_ref().ok_or("the study has no [ida] with first, step, highest and runs")?.runs;
        wanted(&study)?;
        let jobs = StudyJobs::new(&a.jobs, &study, &a.out, &stop)?;
        let levels = intensities(&study)?;
        let tasks = tasks(&study);
        let traces = jobs.all(&tasks, runs * tasks.len(), |&(bound, motion)| {
            let points = hunt(&study, bound, motion, levels[motion], &|job| jobs.one(job))?;
            Ok(Trace { bound, motion, points })
        })?;
        written(&study, &summary(&study, traces, levels, false), &a.out, a.jobs.json)
    });
    finish(result, &stop)
}

/// Run `hysteron fragility`; the exit status.
pub(super) fn fragility(a: &FragilityArgs) -> i32 {
    if a.jobs.study.extension().is_some_and(|e| e == "csv") {
        return print(counts(&a.jobs.study, a.jobs.json));
    }
    let stop = a.jobs.stop_flag();
    let result = load(&a.jobs.study, &stop).and_then(|study| {
        let levels = study.performance.stripes.as_ref().ok_or("the study has no [stripes] with levels")?.levels.clone();
        wanted(&study)?;
        let jobs = StudyJobs::new(&a.jobs, &study, &a.out, &stop)?;
        let scales = intensities(&study)?;
        let of_level = |(bound, motion)| levels.iter().map(move |level| (bound, motion, *level));
        let flat: Vec<(&'static str, usize, f64)> = tasks(&study).into_iter().flat_map(of_level).collect();
        let points = jobs.all(&flat, flat.len(), |&(bound, motion, level)| {
            stripe(&study, bound, motion, (level, scales[motion]), &|job| jobs.one(job))
        })?;
        let mut traces: Vec<Trace> = vec![];
        for (&(bound, motion, _), point) in flat.iter().zip(points) {
            match traces.last_mut() {
                Some(t) if t.bound == bound && t.motion == motion => t.points.push(point),
                _ => traces.push(Trace { bound, motion, points: vec![point] }),
            }
        }
        written(&study, &summary(&study, traces, scales, true), &a.out, a.jobs.json)
    });
    finish(result, &stop)
}

fn wanted(study: &Study) -> Result<(), String> {
    if study.performance.limit_states.is_empty() {
        return Err("the study has no [[limit_state]] with name, quantity and limit".into());
    }
    Ok(())
}

fn tasks(study: &Study) -> Vec<(&'static str, usize)> {
    bounds(study).into_iter().flat_map(|b| (0..study.motions.len()).map(move |m| (b, m))).collect()
}

fn written(study: &Study, s: &Summary, out: &Path, as_json: bool) -> Outcome {
    let (fits, json) = (s.fit_table(study), report::json(study, s));
    let mut files = vec![
        ("fits.csv", fits.csv()),
        ("points.csv", s.point_table(study).csv()),
        ("fragility.json", json.clone()),
        ("report.html", report::html(study, s)),
    ];
    if !s.stripes {
        files.push(("capacities.csv", s.capacity_table(study).csv()));
    }
    for (name, text) in files {
        write_atomically(&out.join(name), &text)?;
    }
    if as_json {
        return Ok((json, 0));
    }
    let of = |e: Ending| s.traces.iter().flat_map(|t| &t.points).filter(|p| p.ending == e).count();
    let (all, collapsed, open) =
        (s.traces.iter().map(|t| t.points.len()).sum::<usize>(), of(Ending::Collapsed), of(Ending::Unresolved));
    let text = format!(
        "{}\nIntensity: {}\n{all} analyses, {collapsed} with collapse, {open} without convergence\n",
        fits.text(),
        study.performance.intensity.label(),
    );
    Ok((text, 0))
}

/// A fit of counts from a table.
fn counts(path: &Path, as_json: bool) -> Result<String, String> {
    let named = |e: String| format!("\"{}\": {e}", path.display());
    let text = hysteron_files::read_text(path).map_err(|e| format!("cannot read \"{}\": {e}", path.display()))?;
    let table = Columns::parse(&text).map_err(named)?;
    let [levels, numbers, reached] = &table.columns[..] else {
        let n = table.columns.len();
        return Err(named(format!(
            "{n} columns: expected three: intensity, records, and records that reached the limit state"
        )));
    };
    let mut data = vec![];
    for (i, ((x, n), k)) in levels.iter().zip(numbers).zip(reached).enumerate() {
        if !(*n >= *k && *k >= 0.0 && n.is_finite()) {
            return Err(named(format!("row {}: {k} of {n} records: expected 0 to all of them", i + 1)));
        }
        data.extend([(*k, Observation::Below(*x)), (n - k, Observation::Above(*x))]);
    }
    let f = Fit::new(&data).map_err(named)?;
    let ([m0, m1], [b0, b1]) = (f.median_interval, f.dispersion_interval);
    if as_json {
        let all = serde_json::json!({
            "median": f.median, "median_interval": [m0, m1], "beta": f.dispersion, "beta_interval": [b0, b1],
            "log_likelihood": f.log_likelihood,
        });
        return Ok(format!("{all:#}\n"));
    }
    Ok(format!(
        "median {:.5}, 95 % interval {m0:.5} to {m1:.5}\nbeta   {:.5}, 95 % interval {b0:.5} to {b1:.5}\n",
        f.median, f.dispersion
    ))
}
