//! Runs a script, and takes out what its recorders write.
//!
//! ```sh
//! cargo run --release --example run_script
//! ```

#![allow(clippy::print_stdout, clippy::print_stderr)]

use hysteron::analysis::Options;
use hysteron::opensees::{FileFormat, Mode, Outputs};
use hysteron::record::{Memory, Output, RecordError};
use hysteron::run::{End, Run, Settings};
use hysteron::tcl::{OsFiles, Recorded};
use std::path::Path;
use std::sync::{Arc, Mutex};

/// Recorder files in memory, by the name in the script.
#[derive(Clone, Default)]
struct Recorders(Arc<Mutex<Vec<(String, Memory)>>>);

impl Outputs for Recorders {
    fn create(&mut self, name: &str, _: &Path, _: FileFormat) -> Result<Box<dyn Output>, RecordError> {
        let rows = Memory::default();
        if let Ok(mut files) = self.0.lock() {
            files.push((name.to_owned(), rows.clone()));
        }
        Ok(Box::new(rows))
    }
}

fn main() -> Result<(), String> {
    // Its motion has a name relative to the folder.
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tcl-like-inputs/pad_study");
    std::env::set_current_dir(folder).map_err(|e| e.to_string())?;
    let settings = Settings { mode: Mode::Run, strict: false, options: Options::default() };
    let (console, recorders) = (Recorded::default(), Recorders::default());
    let mut run = Run::new(settings, Box::new(console.clone()), Box::new(OsFiles), Box::new(recorders.clone()));
    // A value in place of that of the script's `pset` command.
    run.interp.host.parameters.insert("k0".into(), 2.6);
    let end = run.script("pad.tcl", &[]);
    if !matches!(end, End::Done) {
        return Err(format!("the script ended with status {}: {}", end.status(), console.err()));
    }
    let files = recorders.0.lock().map_err(|e| e.to_string())?;
    for (name, memory) in files.iter() {
        let rows = memory.take();
        let largest = rows.iter().filter_map(|row| row.last()).fold(0.0, |a: f64, b| a.max(b.abs()));
        println!("{name}: {} rows, largest value of the last column {largest:.3}", rows.len());
    }
    Ok(())
}
