//! Diagnoses a study, and takes out verdict and repaired script.
//!
//! ```sh
//! cargo run --release --example diagnose_study study.toml
//! ```

#![allow(clippy::print_stdout, clippy::print_stderr)]

use hysteron::analysis::Options;
use hysteron::diagnose::{CheckpointEntry, ProgressMonitor, Settings, diagnose};
use hysteron::diagnostic::SourceMap;
use hysteron::study::{ScriptSimulator, Study, standalone_script};
use std::path::PathBuf;
use std::sync::Arc;

/// Prints the stages of the diagnosis.
struct Stages;

impl ProgressMonitor for Stages {
    fn stage(&mut self, name: &str, done: usize, total: usize) {
        if done == total {
            eprintln!("{name}: {total} done");
        }
    }

    fn is_cancelled(&self) -> bool {
        false
    }

    fn checkpoint(&mut self, _: &[CheckpointEntry]) {}
}

fn main() -> Result<(), String> {
    let file = std::env::args().nth(1).map(PathBuf::from).ok_or("usage: diagnose_study study.toml")?;
    let mut sources = SourceMap::default();
    let study = Arc::new(Study::load(&file, &mut sources).map_err(|d| d.message)?);
    let text = std::fs::read_to_string(study.folder.join(&study.model)).map_err(|e| e.to_string())?;
    let mut simulator = ScriptSimulator::new(study.clone(), Options::default(), Arc::default());
    let initial_run = simulator.run_initially(&mut sources).map_err(|d| d.message)?;

    let settings = Settings { threads: 2, ..Settings::default() };
    let diagnosis = diagnose(&simulator, &initial_run, &text, &settings, &mut Stages)?;
    let (verdict, repair) = (&diagnosis.outcome.verdict, &diagnosis.outcome.corrected);
    println!("{} ({:.0} %): {}", verdict.cause, 100.0 * verdict.confidence, verdict.explanation);
    println!("NMSE {:.3e} before, {:.3e} after", diagnosis.outcome.baseline.fit_nmse, repair.fit_nmse);
    for (name, value) in &repair.parameters {
        println!("{name} = {value}");
    }
    // The repaired script runs from any folder, once it knows the one that it lies in.
    let folder = std::env::temp_dir();
    let script = standalone_script(&simulator, &folder, &diagnosis.repaired_script);
    std::fs::write(folder.join("corrected.tcl"), script).map_err(|e| e.to_string())
}
