//! The files of `hysteron init --new`: a shipped example of each job.

use clap::ValueEnum;
use std::path::{Path, PathBuf};

/// A job to begin with.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum Job {
    /// An analysis: the script of an isolated building and its ground motion
    Building,
    /// A test of one bearing as in a testing machine
    Bearing,
    /// A calibration and a diagnosis: a script, two recorded tests and the study
    Study,
    /// A design: the script of an isolated building, its motions and the isolation study
    Isolation,
}

/// A shipped file: its path below the folder, and its text.
type File = (&'static str, &'static str);

macro_rules! shipped {
    ($folder:literal: $($path:literal),+) => {
        &[$(($path, include_str!(concat!("../../", $folder, "/", $path)))),+]
    };
}

impl Job {
    fn files(self) -> &'static [File] {
        match self {
            Self::Building => shipped!("tcl-like-inputs": "isolated_building.tcl", "ground_motions/README.md",
                "ground_motions/meloland_1979_270_g.txt", "ground_motions/meloland_1979_360_g.txt"),
            Self::Bearing => shipped!("models": "lrb.tcl", "rubber.tcl"),
            Self::Study => shipped!("tcl-like-inputs/pad_study": "pad.tcl", "study.toml", "growing.csv", "growing.dat",
                "random.csv", "random.dat"),
            Self::Isolation => {
                shipped!("tcl-like-inputs": "isolation_study/building.tcl", "isolation_study/study.toml",
                "ground_motions/README.md", "ground_motions/meloland_1979_270_g.txt",
                "ground_motions/meloland_1979_360_g.txt", "ground_motions/riodell_1992_360_g.txt")
            }
        }
    }

    /// Commands to go on with, in the folder.
    pub(super) fn next(self) -> &'static [&'static str] {
        match self {
            Self::Building => &[
                "hysteron check isolated_building.tcl",
                "hysteron run isolated_building.tcl",
                "hysteron view isolated_building.tcl",
            ],
            Self::Bearing => &["hysteron bearing lrb.tcl --amplitudes 0.07,0.14,0.28 --axial 3e6 --units N m"],
            Self::Study => {
                &["hysteron check study.toml", "hysteron calibrate study.toml", "hysteron diagnose study.toml"]
            }
            Self::Isolation => &[
                "hysteron check isolation_study/study.toml",
                "hysteron isolate isolation_study/study.toml --out results",
            ],
        }
    }

    /// Write the files into a folder. Nothing is written if one of them is there with another content.
    ///
    /// # Errors
    /// Another file is in the place of one, or it cannot be written.
    pub(super) fn write(self, folder: &Path) -> Result<Vec<PathBuf>, String> {
        let place = |path: &str| match folder == Path::new(".") {
            true => PathBuf::from(path),
            false => folder.join(path),
        };
        let is_other = |(path, text): &&File| {
            let path = place(path);
            path.exists() && hysteron_files::read_text(&path).ok().as_deref() != Some(*text)
        };
        if let Some((path, _)) = self.files().iter().find(is_other) {
            return Err(format!("{} exists already; give another folder with --out", place(path).display()));
        }
        let write = |(path, text): &File| {
            let path = place(path);
            let cannot = |e: std::io::Error| format!("cannot write {}: {e}", path.display());
            hysteron_files::make_folders(path.parent().unwrap_or(folder)).map_err(cannot)?;
            hysteron_files::write(&path, text).map_err(cannot)?;
            Ok(path)
        };
        self.files().iter().map(write).collect()
    }
}

/// The jobs, each with what it is and how it is begun.
pub(super) fn list() -> String {
    let line = |job: &Job| {
        let value = job.to_possible_value()?;
        let about = value.get_help().map(ToString::to_string).unwrap_or_default();
        Some(format!("  hysteron init --new {:<10}{about}\n", value.get_name()))
    };
    Job::value_variants().iter().filter_map(line).collect()
}
