//! Studies with recordings whose truth is known, and their diagnosis.
#![allow(dead_code)]

use hysteron::analysis::Options;
use hysteron::diagnose::{CheckpointEntry, Diagnosis, ProgressMonitor, Settings, diagnose};
use hysteron::diagnostic::SourceMap;
use hysteron::study::{InitialRun, ScriptSimulator, Study};
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// A pad under imposed displacement: a spring that yields and one that does not.
pub const PAD: &str = "wipe\nmodel basic -ndm 1 -ndf 1\npset Fy 9.0\npset k 300.0\nnode 1 0.\nnode 2 0.\nfix 1 1\n\
    uniaxialMaterial Steel01 1 $Fy 2000.0 0.0\nuniaxialMaterial Elastic 2 $k\nuniaxialMaterial Parallel 3 1 2\n\
    element zeroLength 1 1 2 -mat 3 -dir 1\ntimeSeries Path 1 -dt $dt -filePath $motion\n\
    pattern Plain 1 1 { sp 2 1 1.0 }\nrecorder Element -file force.out -time -ele 1 force\n\
    constraints Transformation\ntest NormDispIncr 1e-10 30\nalgorithm Newton\nintegrator LoadControl $dt\n\
    analysis Static\nfor {set i 1} {$i < $npts} {incr i} { if {[analyze 1] != 0} { error \"no convergence\" } }\n";

/// A mass on a spring that yields, shaken; its steps are a thirtieth of its period.
pub const SHAKEN: &str = "wipe\nmodel basic -ndm 1 -ndf 1\npset k 400.0\npset uy 0.02\nnode 1 0.\nnode 2 0. -mass 1.0\nfix 1 1\n\
    uniaxialMaterial Elastic 1 [expr {0.6*$k}]\n\
    uniaxialMaterial BoucWen 2 0.0 [expr {0.4*$k}] 1.0 [expr {0.5/$uy}] [expr {0.5/$uy}] 1.0 0.0 0.0 0.0\n\
    uniaxialMaterial Parallel 3 1 2\nelement zeroLength 1 1 2 -mat 3 -dir 1\n\
    timeSeries Path 1 -dt $dt -filePath $motion\npattern UniformExcitation 1 1 -accel 1\n\
    recorder Node -file disp.out -time -node 2 -dof 1 disp\n\
    constraints Plain\nsystem FullGeneral\ntest NormDispIncr 1e-10 30\nalgorithm Newton\nintegrator Newmark 0.5 0.25\n\
    analysis Transient\nfor {set i 1} {$i < $npts} {incr i} { if {[analyze 1 $dt] != 0} { error \"no convergence\" } }\n";

/// Noise of a sensor: about a normal distribution of unit variance.
pub struct Noise(u64);

impl Default for Noise {
    fn default() -> Self {
        Self(88172645463325252)
    }
}

impl Noise {
    pub fn next(&mut self) -> f64 {
        let mut uniform = || {
            self.0 ^= self.0 << 13;
            self.0 ^= self.0 >> 7;
            self.0 ^= self.0 << 17;
            (self.0 >> 11) as f64 / (1u64 << 53) as f64
        };
        (0..12).map(|_| uniform()).sum::<f64>() - 6.0
    }
}

/// Place in the model of the quantity that a channel records.
pub struct Channel {
    /// Its name.
    pub name: &'static str,
    /// File of a recorder and the column in it.
    pub output: &'static str,
    pub column: usize,
}

/// A run and its recording.
pub struct Record {
    pub name: &'static str,
    pub holdout: bool,
    /// Variables beside those of the motion, as in `set = { ... }` of a study.
    pub set: String,
    /// Variables that name files of motions, with the motions.
    pub motions: Vec<(&'static str, Vec<f64>)>,
    /// Headers of columns with their samples; the channels are among them.
    pub columns: Vec<(String, Vec<f64>)>,
}

/// A study in memory.
pub struct Concealed {
    pub model: String,
    /// Name, lower and upper end.
    pub parameters: Vec<(&'static str, f64, f64)>,
    pub channels: Vec<Channel>,
    /// Time between two samples of motions and recordings, s.
    pub dt: f64,
    pub runs: Vec<Record>,
}

impl Concealed {
    /// Write model, motions, recordings and study into a new folder.
    pub fn write(&self, name: &str) -> PathBuf {
        let dir = std::env::temp_dir().join(format!("hysteron-diagnose-{name}-{}", std::process::id()));
        fs::create_dir_all(&dir).unwrap();
        fs::write(dir.join("model.tcl"), &self.model).unwrap();
        let mut study = "model = \"model.tcl\"\n".to_owned();
        for (name, lower, upper) in &self.parameters {
            writeln!(study, "[[parameter]]\nname = \"{name}\"\nlower = {lower:?}\nupper = {upper:?}").unwrap();
        }
        for run in &self.runs {
            self.write_run(&dir, run, &mut study);
        }
        fs::write(dir.join("study.toml"), study).unwrap();
        dir
    }

    fn write_run(&self, dir: &Path, run: &Record, study: &mut String) {
        let (name, n) = (run.name, run.motions[0].1.len());
        let mut table = "time[s]".to_owned();
        run.columns.iter().for_each(|(header, _)| write!(table, ",{header}").unwrap());
        for i in 0..n {
            write!(table, "\n{}", self.dt * i as f64).unwrap();
            run.columns.iter().for_each(|(_, values)| write!(table, ",{}", values[i]).unwrap());
        }
        fs::write(dir.join(format!("{name}.csv")), table + "\n").unwrap();
        let role = if run.holdout { "holdout" } else { "fit" };
        write!(study, "[[run]]\nname = \"{name}\"\nrole = \"{role}\"\nrecording = \"{name}.csv\"\nset = {{ ").unwrap();
        for (variable, motion) in &run.motions {
            let text: String = motion.iter().map(|u| format!("{u}\n")).collect();
            fs::write(dir.join(format!("{name}-{variable}.dat")), text).unwrap();
            write!(study, "{variable} = \"{name}-{variable}.dat\", ").unwrap();
        }
        writeln!(study, "dt = {}, npts = {n}{} }}", self.dt, run.set).unwrap();
        for Channel { name, output, column, .. } in &self.channels {
            writeln!(study, "[[run.observe]]\nchannel = \"{name}\"\noutput = \"{output}\"\ncolumn = {column}").unwrap();
            writeln!(study, "at = \"{name}\"").unwrap();
        }
    }
}

/// Keeps checkpoints, and cancels after `max_entries` results.
pub struct CheckpointRecorder {
    pub entries: Vec<CheckpointEntry>,
    pub max_entries: usize,
}

impl CheckpointRecorder {
    /// A recorder that never cancels.
    pub fn unlimited() -> Self {
        Self { entries: vec![], max_entries: usize::MAX }
    }
}

impl ProgressMonitor for CheckpointRecorder {
    fn stage(&mut self, _: &str, _: usize, _: usize) {}
    fn is_cancelled(&self) -> bool {
        self.entries.len() >= self.max_entries
    }
    fn checkpoint(&mut self, entries: &[CheckpointEntry]) {
        self.entries = entries.to_vec();
    }
}

/// The study in a folder, after its first run.
pub fn opened(dir: &Path) -> (ScriptSimulator, InitialRun) {
    let mut sources = SourceMap::default();
    let study = Arc::new(Study::load(&dir.join("study.toml"), &mut sources).unwrap());
    let mut simulator = ScriptSimulator::new(study, Options::default(), Arc::new(AtomicBool::new(false)));
    let initial_run = simulator.run_initially(&mut sources).unwrap();
    (simulator, initial_run)
}

/// Diagnose the study in a folder.
pub fn attempt(dir: &Path, settings: &Settings, recorder: &mut CheckpointRecorder) -> Result<Diagnosis, String> {
    let text = fs::read_to_string(dir.join("model.tcl")).unwrap();
    let (simulator, initial_run) = opened(dir);
    diagnose(&simulator, &initial_run, &text, settings, recorder)
}
