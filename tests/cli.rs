//! Output for an engineer who makes a mistake: message, place, exit status, and what is left on the disk.

#![cfg(unix)]
#![allow(clippy::unwrap_used, clippy::new_without_default, unreachable_pub)]

#[path = "cli/amend.rs"]
mod amend;
#[path = "cli/batch.rs"]
mod batch;
#[path = "cli/bearing.rs"]
mod bearing;
#[path = "cli/check_recovery.rs"]
mod check_recovery;
#[path = "cli/checks.rs"]
mod checks;
#[path = "cli/editor.rs"]
mod editor;
#[path = "cli/endings.rs"]
mod endings;
#[path = "cli/evidence.rs"]
mod evidence;
#[path = "cli/findings.rs"]
mod findings;
#[path = "cli/formats.rs"]
mod formats;
#[path = "cli/guard.rs"]
mod guard;
#[path = "cli/isolation.rs"]
mod isolation;
#[path = "cli/isolation_contradictions.rs"]
mod isolation_contradictions;
#[path = "cli/isolation_review.rs"]
mod isolation_review;
#[path = "cli/kikuchi.rs"]
mod kikuchi;
#[path = "cli/learn.rs"]
mod learn;
#[path = "cli/limits.rs"]
mod limits;
#[path = "cli/live.rs"]
mod live;
#[path = "cli/loops.rs"]
mod loops;
#[path = "cli/mistakes.rs"]
mod mistakes;
#[path = "cli/modal.rs"]
mod modal;
#[path = "cli/models.rs"]
mod models;
#[path = "cli/parameters.rs"]
mod parameters;
#[path = "cli/phenomena.rs"]
mod phenomena;
#[path = "cli/plausibility.rs"]
mod plausibility;
#[path = "cli/recorders.rs"]
mod recorders;
#[path = "cli/recordings.rs"]
mod recordings;
#[path = "cli/restart.rs"]
mod restart;
#[path = "cli/rubber.rs"]
mod rubber;
#[path = "cli/rubber_bearings.rs"]
mod rubber_bearings;
#[path = "cli/studies.rs"]
mod studies;
#[path = "cli/texts.rs"]
mod texts;
#[path = "cli/triple.rs"]
mod triple;
#[path = "cli/view.rs"]
mod view;

use std::fs;
use std::path::PathBuf;
use std::process::Command;
use std::sync::atomic::{AtomicUsize, Ordering};

/// A cantilever with a load.
pub const MODEL: &str = "model BasicBuilder -ndm 2 -ndf 3\nnode 1 0 0\nnode 2 4 0\nnode 3 4 0\nfix 1 1 1 1\n\
    uniaxialMaterial Elastic 1 100.\ngeomTransf Linear 1\nelement elasticBeamColumn 1 1 2 0.1 2e8 1e-3 1\n\
    timeSeries Linear 1\npattern Plain 1 1 { load 2 1 0 0 }\n";

/// A folder of its own, removed at the end.
pub struct Place(pub PathBuf);

impl Place {
    /// A new one, empty.
    #[expect(clippy::new_without_default, reason = "each is another folder")]
    pub fn new() -> Self {
        static COUNT: AtomicUsize = AtomicUsize::new(0);
        let n = COUNT.fetch_add(1, Ordering::Relaxed);
        let dir = std::env::temp_dir().join(format!("hysteron-cli-{}-{n}", std::process::id()));
        fs::create_dir_all(&dir).unwrap();
        Self(dir)
    }

    /// Put a file there.
    pub fn write(&self, name: &str, content: impl AsRef<[u8]>) {
        fs::write(self.0.join(name), content).unwrap();
    }

    /// Run with arguments: exit status, standard output, standard error.
    pub fn run(&self, args: &[&str]) -> (Option<i32>, String, String) {
        self.run_with(&[], args)
    }

    /// Start with arguments, and go on.
    pub fn spawn(&self, args: &[&str]) -> std::process::Child {
        let mut command = Command::new(env!("CARGO_BIN_EXE_hysteron"));
        let quiet = command.stdout(std::process::Stdio::null()).stderr(std::process::Stdio::null());
        quiet.args(args).current_dir(&self.0).spawn().unwrap()
    }

    /// The same with variables of the environment.
    pub fn run_with(&self, variables: &[(&str, &str)], args: &[&str]) -> (Option<i32>, String, String) {
        let mut command = Command::new(env!("CARGO_BIN_EXE_hysteron"));
        let output = command.args(args).envs(variables.iter().copied()).current_dir(&self.0).output().unwrap();
        let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
        let (out, err) = (text(&output.stdout), text(&output.stderr));
        assert!(!err.contains("panicked"), "{err}");
        (output.status.code(), out, err)
    }

    /// Names of what is there.
    pub fn names(&self) -> Vec<String> {
        let mut all: Vec<String> =
            fs::read_dir(&self.0).unwrap().map(|e| e.unwrap().file_name().to_string_lossy().into_owned()).collect();
        all.sort();
        all
    }
}

impl Drop for Place {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

/// Run a script: exit status, standard output, standard error.
pub fn run(script: &str) -> (Option<i32>, String, String) {
    let place = Place::new();
    place.write("m.tcl", script);
    place.run(&["run", "m.tcl"])
}
