//! Tests of studies and their calibration: errors, simulations, methods, results.

#![cfg(unix)]
#![allow(clippy::new_without_default, clippy::unwrap_used, missing_docs, unreachable_pub)]

#[allow(dead_code)]
#[path = "../examples/calibrate_study.rs"]
mod calibrate_study;
#[path = "calibrate/command.rs"]
mod command;
#[path = "calibrate/interrupt.rs"]
mod interrupt;
#[path = "calibrate/loop_measures.rs"]
mod loop_measures;
#[path = "calibrate/methods.rs"]
mod methods;
#[path = "calibrate/simulation.rs"]
mod simulation;
#[path = "calibrate/studies.rs"]
mod studies;

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

/// Folder of the example study.
pub fn pad() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tcl-like-inputs/pad_study")
}

/// A temporary copy of the example study, removed on drop.
pub struct StudyFolder(pub PathBuf);

impl StudyFolder {
    pub fn new() -> Self {
        static COUNT: AtomicUsize = AtomicUsize::new(0);
        let n = COUNT.fetch_add(1, Ordering::Relaxed);
        let dir = std::env::temp_dir().join(format!("hysteron-calibrate-{}-{n}", std::process::id()));
        fs::create_dir_all(&dir).unwrap();
        for file in fs::read_dir(pad()).unwrap().flatten().filter(|f| f.path().is_file()) {
            fs::copy(file.path(), dir.join(file.file_name())).unwrap();
        }
        Self(dir)
    }

    /// A copy with a piece of a file replaced.
    pub fn edited(file: &str, old: &str, new: &str) -> Self {
        let folder = Self::new();
        folder.edit(file, old, new);
        folder
    }

    pub fn edit(&self, file: &str, old: &str, new: &str) {
        let text = fs::read_to_string(self.0.join(file)).unwrap();
        assert!(text.contains(old), "{old}");
        fs::write(self.0.join(file), text.replacen(old, new, 1)).unwrap();
    }

    pub fn study(&self) -> PathBuf {
        self.0.join("study.toml")
    }
}

impl Drop for StudyFolder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}
