//! Studies and their calibration: what is refused, what is simulated, what is found.

#![cfg(unix)]
#![allow(clippy::new_without_default, clippy::unwrap_used, missing_docs, unreachable_pub)]

#[path = "calibrate/command.rs"]
mod command;
#[path = "calibrate/interrupt.rs"]
mod interrupt;
#[path = "calibrate/methods.rs"]
mod methods;
#[path = "calibrate/simulation.rs"]
mod simulation;
#[path = "calibrate/studies.rs"]
mod studies;

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

/// The study that the project comes with.
pub fn pad() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tcl-like-inputs/pad_study")
}

/// A copy of it in a folder of its own, removed at the end.
pub struct Place(pub PathBuf);

impl Place {
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

    /// With a piece of a file replaced.
    pub fn edited(file: &str, old: &str, new: &str) -> Self {
        let place = Self::new();
        place.edit(file, old, new);
        place
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

impl Drop for Place {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}
