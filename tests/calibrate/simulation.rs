//! Tests of simulations of a study's script in memory.

use super::StudyFolder;
use hysteron::analysis::Options;
use hysteron::calibrate::{Problem, StudyProblem};
use hysteron::diagnostic::SourceMap;
use hysteron::study::{ScriptSimulator, SimulationError, Simulator, Study};
use std::fs;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

fn simulator(folder: &StudyFolder) -> ScriptSimulator {
    let study = Study::load(&folder.study(), &mut SourceMap::default()).unwrap();
    ScriptSimulator::new(Arc::new(study), Options::default(), Arc::default())
}

/// The error of the initial run, with its location and help.
fn initial_error(folder: &StudyFolder) -> String {
    let mut sources = SourceMap::default();
    let study = Study::load(&folder.study(), &mut sources).unwrap();
    let d = ScriptSimulator::new(Arc::new(study), Options::default(), Arc::default())
        .run_initially(&mut sources)
        .unwrap_err();
    let at = d.span.map_or(String::new(), |s| sources.location(s).to_string());
    format!("{at}: {}; {}", d.message, d.help.join("; "))
}

const TRUTH: [f64; 3] = [2.6, 17.0, 0.21];

#[test]
fn true_parameters_leave_only_the_noise() {
    let folder = StudyFolder::new();
    let mut s = simulator(&folder);
    let initial_run = s.run_initially(&mut SourceMap::default()).unwrap();
    assert_eq!(initial_run.values, [2.0, 20.0, 0.15]);
    assert!(initial_run.failure.is_none() && initial_run.warnings.is_empty());
    let before = fs::read_dir(&folder.0).unwrap().count();
    let channels = s.simulate(0, &TRUTH).unwrap();
    assert_eq!(channels[0].len(), 499);
    let recorded = &s.study().runs[0].observe[0].values;
    let worst =
        channels[0].iter().zip(recorded).map(|(a, b)| (a - b).abs()).filter(|d| !d.is_nan()).fold(0.0, f64::max);
    assert!(worst < 1.2, "{worst}");
    assert_eq!(fs::read_dir(&folder.0).unwrap().count(), before, "nothing is written");
    // The same bits again after a run with other values.
    s.simulate(1, &[1.0, 40.0, 0.3]).unwrap();
    assert_eq!(s.simulate(0, &TRUTH).unwrap(), channels);
}

/// Before the first recorder row, the channel starts from the state at the start of the analysis.
#[test]
fn channels_before_the_first_and_after_the_last_recorder_row() {
    let folder = StudyFolder::new();
    folder.edit("growing.csv", "0.0260,", "0.0050,1.0,0.1,21\n0.0260,");
    folder.edit("study.toml", "npts = 501", "npts = 251");
    let mut s = simulator(&folder);
    let channels = s.simulate(0, &TRUTH).unwrap();
    let first = channels[0][0];
    let row = s.trace(0, "force.out").unwrap();
    assert!(row.has_start && row.times[0] == 0.0 && row.times[1] == 0.02);
    // A quarter of the value of the first row.
    assert!((first - 0.25 * row.values[3 + 2]).abs() < 1e-12, "{first}");
    assert_eq!(channels[0].iter().filter(|v| v.is_nan()).count(), 250);
}

/// A channel with a shift is the model's response that much later.
#[test]
fn shifted_channel_is_compared_with_the_response_at_the_shifted_time() {
    let folders = [StudyFolder::new(), StudyFolder::edited("study.toml", "column  = 2", "column  = 2\nshift = 0.04")];
    let [mut plain, mut shifted] = folders.each_ref().map(simulator);
    let (a, b) = (plain.simulate(0, &TRUTH).unwrap(), shifted.simulate(0, &TRUTH).unwrap());
    // Two samples of 0.02 s.
    assert!(a[0][2..].iter().zip(&b[0]).all(|(x, y)| (x - y).abs() < 1e-9), "{:?} {:?}", &a[0][..5], &b[0][..5]);
    assert!(b[0][b[0].len() - 1].is_nan() && a[0].iter().all(|y| y.is_finite()));
}

/// The state after a gravity stage is the start of the test.
#[test]
fn rows_of_earlier_stages_are_left_out() {
    let folder = StudyFolder::new();
    let gravity = "timeSeries Linear 9\npattern Plain 9 9 {load 2 3.0}\nconstraints Transformation\nsystem ProfileSPD\n\
                   algorithm Newton\nintegrator LoadControl 0.5\nanalysis Static\nanalyze 2\nloadConst -time 0.0\n";
    folder.edit(
        "pad.tcl",
        "timeSeries Path 1",
        &format!("recorder Element -file force.out -time -ele 1 force\n{gravity}timeSeries Path 1"),
    );
    folder.edit("pad.tcl", "recorder Element -file force.out -time -ele 1 force\nrecorder Node", "recorder Node");
    let mut s = simulator(&folder);
    s.simulate(0, &TRUTH).unwrap();
    let t = s.trace(0, "force.out").unwrap();
    assert!(t.has_start && t.times.len() == 501 && t.times[0] == 0.0, "{:?}", &t.times[..3]);
    assert!((t.values[2].abs() - 3.0).abs() < 1e-6, "{}", t.values[2]);
}

#[test]
fn study_and_script_that_disagree_are_an_error() {
    for (file, old, new, said) in [
        ("pad.tcl", "pset alpha", "pset alfa", "pad.tcl:23"),
        (
            "study.toml",
            "name  = \"alpha\"",
            "name  = \"alfa\"",
            "never declares the parameter alfa; did you mean \"alpha\"?",
        ),
        ("study.toml", "output  = \"force.out\"", "output = \"forces.out\"", "forces.out has no rows"),
        ("study.toml", "column  = 2", "column = 7", "has 3 columns, and none of number 7"),
        ("study.toml", "growing.dat", "growin.dat", "cannot read \"growin.dat\""),
        ("pad.tcl", "element zeroLength", "element zeroLenght", "did you mean"),
        ("pad.tcl", "integrator LoadControl $dt", "integrator LoadControl [expr {-$dt}]", "no clock"),
    ] {
        let message = initial_error(&StudyFolder::edited(file, old, new));
        assert!(message.contains(said), "{new}: {message}");
    }
}

#[test]
fn failed_runs_have_an_error_by_their_cause() {
    let folder = StudyFolder::new();
    folder.edit(
        "pad.tcl",
        "set uy",
        "if {$k0 > 4.9} {while 1 {incr forever}}\nif {$k0 > 4.5} {error \"too stiff\"}\nset uy",
    );
    folder.edit(
        "pad.tcl",
        "element zeroLength",
        "if {$k0 < 1.1} {exit 3}\nif {$k0 < 1.2} {node 1 0.0}\nelement zeroLength",
    );
    let mut s = simulator(&folder);
    s.run_initially(&mut SourceMap::default()).unwrap();
    let mut kind = |k0: f64| s.simulate(0, &[k0, 17.0, 0.2]).map_err(|e| e.kind());
    assert_eq!(kind(4.95), Err("it took too long"));
    assert_eq!(kind(4.6), Err("the script raised an error"));
    assert_eq!(kind(1.05), Err("the script ended itself"));
    assert_eq!(kind(1.15), Err("a command was rejected"));
    assert!(kind(3.0).is_ok());
    let problem = StudyProblem::of_script(&s, 2).unwrap();
    let unit_points: Vec<Vec<f64>> = (0..12).map(|i| vec![f64::from(i) / 11.0, 0.5, 0.5]).collect();
    let all = problem.evaluate(&unit_points, true);
    assert_eq!(all.iter().filter(|e| e.error.is_some()).count(), 3);
    assert!(matches!(all[11].error, Some(SimulationError::TooLong(_))));
    for e in all.iter().filter(|e| e.error.is_none()) {
        let sum: f64 = e.trial.residuals.iter().map(|r| r * r).sum();
        assert!((sum - e.trial.objective).abs() < 1e-12 * sum, "the squares of the residuals add up to the objective");
    }
    // The result does not depend on the number of threads.
    let one = StudyProblem::of_script(&s, 1).unwrap();
    assert_eq!(one.evaluate(&unit_points, true), all);
}

#[test]
fn simulators_end_with_their_problem_and_are_replaced_after_a_panic() {
    static LIVE: AtomicUsize = AtomicUsize::new(0);

    struct Counted(usize);

    impl Counted {
        fn new(samples: usize) -> Self {
            LIVE.fetch_add(1, Ordering::SeqCst);
            Self(samples)
        }
    }

    impl Drop for Counted {
        fn drop(&mut self) {
            LIVE.fetch_sub(1, Ordering::SeqCst);
        }
    }

    impl Simulator for Counted {
        fn simulate(&mut self, _: usize, values: &[f64]) -> Result<Vec<Vec<f64>>, SimulationError> {
            if values[0] > 4.9 {
                std::panic::resume_unwind(Box::new("a defect"));
            }
            Ok(vec![vec![0.0; self.0]])
        }
    }

    let folder = StudyFolder::new();
    let study = Arc::new(Study::load(&folder.study(), &mut SourceMap::default()).unwrap());
    let samples = study.runs[0].recording.times.len();
    let problem = StudyProblem::new(study, 2, move || Counted::new(samples)).unwrap();
    let mut unit_points = vec![vec![0.5; 3]; 9];
    unit_points[4][0] = 1.0;
    for _ in 0..2 {
        let evaluations = problem.evaluate(&unit_points, false);
        for (i, e) in evaluations.iter().enumerate() {
            assert_eq!(e.error, (i == 4).then_some(SimulationError::Defect), "{i}");
        }
    }
    assert!(LIVE.load(Ordering::SeqCst) <= 2, "one simulator for each thread");
    drop(problem);
    assert_eq!(LIVE.load(Ordering::SeqCst), 0);
}
