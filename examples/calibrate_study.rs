//! Calibrates a study, and takes out parameters, errors and intervals.
//!
//! ```sh
//! cargo run --release --example calibrate_study [study.toml]
//! ```

#![allow(clippy::print_stdout, clippy::print_stderr)]

use hysteron::analysis::Options;
use hysteron::calibrate::{
    CalibrationResult, Checkpoint, NoObserver, SearchSettings, StudyProblem, search, uncertainty,
};
use hysteron::diagnostic::SourceMap;
use hysteron::study::{Role, ScriptSimulator, Study};
use std::path::{Path, PathBuf};
use std::sync::Arc;

fn main() -> Result<(), String> {
    let example = || PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tcl-like-inputs/pad_study/study.toml");
    let file = std::env::args().nth(1).map_or_else(example, PathBuf::from);
    let result = calibrated(&file)?;
    println!("NMSE of the fitted runs {:.3e}", result.objective);
    println!("NMSE of the runs held out {:.3e}", result.nmse(Role::Holdout).unwrap_or(f64::NAN));
    for interval in result.uncertainty.iter().flat_map(|u| &u.intervals) {
        println!("{}: {:.4} to {:.4}", interval.name, interval.lower, interval.upper);
    }
    // Response of the calibrated model in the first run, at the times of its recording.
    let first = result.scored_runs[0].as_ref().map_err(ToString::to_string)?;
    println!("{} samples of {}", first.channels[0].len(), result.study.runs[0].observe[0].channel);
    Ok(())
}

/// The result of a study.
pub(crate) fn calibrated(file: &Path) -> Result<CalibrationResult, String> {
    let mut sources = SourceMap::default();
    let study = Arc::new(Study::load(file, &mut sources).map_err(|d| d.message)?);
    let settings = SearchSettings::of(&study).map_err(|d| d.message)?;

    // The script runs with its own values first: a mistake in it is found before the search.
    let mut simulator = ScriptSimulator::new(study.clone(), Options::default(), Arc::default());
    let initial_run = simulator.run_initially(&mut sources).map_err(|d| d.message)?;

    let problem = StudyProblem::of_script(&simulator, 2).map_err(|e| e.to_string())?;
    let start = Checkpoint::new(settings.clone(), study.space.unit_point(&initial_run.values));
    let found = search(&problem, start, &mut NoObserver);
    let mut result = CalibrationResult::new(&problem, &settings, found, 0.0)?;
    result.uncertainty = Some(uncertainty(&problem, &result.unit_point)?);
    Ok(result)
}
