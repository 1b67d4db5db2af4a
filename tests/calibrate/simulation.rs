//! The script of a study run in memory.

use super::Place;
use hysteron::analysis::Options;
use hysteron::calibrate::{Problem, StudyProblem};
use hysteron::diagnostic::SourceMap;
use hysteron::study::{Mishap, ScriptSimulator, Simulator, Study};
use std::fs;
use std::sync::Arc;

fn simulator(place: &Place) -> ScriptSimulator {
    let study = Study::load(&place.study(), &mut SourceMap::default()).unwrap();
    ScriptSimulator::new(Arc::new(study), Options::default(), Arc::default())
}

/// The error that opening a study ends with.
fn refused(place: &Place) -> String {
    let mut sources = SourceMap::default();
    let study = Study::load(&place.study(), &mut sources).unwrap();
    let d = ScriptSimulator::new(Arc::new(study), Options::default(), Arc::default()).open(&mut sources).unwrap_err();
    let at = d.span.map_or(String::new(), |s| sources.location(s).to_string());
    format!("{at}: {}; {}", d.message, d.help.join("; "))
}

const TRUTH: [f64; 3] = [2.6, 17.0, 0.21];

#[test]
fn the_truth_leaves_the_noise() {
    let place = Place::new();
    let mut s = simulator(&place);
    let opening = s.open(&mut SourceMap::default()).unwrap();
    assert_eq!(opening.values, [2.0, 20.0, 0.15]);
    assert!(opening.failure.is_none() && opening.warnings.is_empty());
    let before = fs::read_dir(&place.0).unwrap().count();
    let channels = s.simulate(0, &TRUTH).unwrap();
    assert_eq!(channels[0].len(), 499);
    let recorded = &s.study().runs[0].observe[0].values;
    let worst =
        channels[0].iter().zip(recorded).map(|(a, b)| (a - b).abs()).filter(|d| !d.is_nan()).fold(0.0, f64::max);
    assert!(worst < 1.2, "{worst}");
    assert_eq!(fs::read_dir(&place.0).unwrap().count(), before, "nothing is written");
    // Again, after other values, to the bit.
    s.simulate(1, &[1.0, 40.0, 0.3]).unwrap();
    assert_eq!(s.simulate(0, &TRUTH).unwrap(), channels);
}

/// Before the first recorder row the channel comes from the state at the start of the analysis; after the last it ends.
#[test]
fn ends_of_a_recording() {
    let place = Place::new();
    place.edit("growing.csv", "0.0260,", "0.0050,1.0,0.1,21\n0.0260,");
    place.edit("study.toml", "npts = 501", "npts = 251");
    let mut s = simulator(&place);
    let channels = s.simulate(0, &TRUTH).unwrap();
    let first = channels[0][0];
    let row = s.trace(0, "force.out").unwrap();
    assert!(row.has_start && row.times[0] == 0.0 && row.times[1] == 0.02);
    // A quarter of the way from nothing to the first row.
    assert!((first - 0.25 * row.values[3 + 2]).abs() < 1e-12, "{first}");
    assert_eq!(channels[0].iter().filter(|v| v.is_nan()).count(), 250);
}

/// A gravity stage before the test: its rows are not those of the test, and the state after it is the start.
#[test]
fn earlier_stages_are_left_out() {
    let place = Place::new();
    let gravity = "timeSeries Linear 9\npattern Plain 9 9 {load 2 3.0}\nconstraints Transformation\nsystem ProfileSPD\n\
                   algorithm Newton\nintegrator LoadControl 0.5\nanalysis Static\nanalyze 2\nloadConst -time 0.0\n";
    place.edit(
        "pad.tcl",
        "timeSeries Path 1",
        &format!("recorder Element -file force.out -time -ele 1 force\n{gravity}timeSeries Path 1"),
    );
    place.edit("pad.tcl", "recorder Element -file force.out -time -ele 1 force\nrecorder Node", "recorder Node");
    let mut s = simulator(&place);
    s.simulate(0, &TRUTH).unwrap();
    let t = s.trace(0, "force.out").unwrap();
    assert!(t.has_start && t.times.len() == 501 && t.times[0] == 0.0, "{:?}", &t.times[..3]);
    assert!((t.values[2].abs() - 3.0).abs() < 1e-6, "{}", t.values[2]);
}

#[test]
fn what_the_script_lacks_is_an_error() {
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
        let message = refused(&Place::edited(file, old, new));
        assert!(message.contains(said), "{new}: {message}");
    }
}

/// A run that hangs, and one without an answer, cost a bad score and are counted by their cause.
#[test]
fn mishaps() {
    let place = Place::new();
    place.edit(
        "pad.tcl",
        "set uy",
        "if {$k0 > 4.9} {while 1 {incr forever}}\nif {$k0 > 4.5} {error \"too stiff\"}\nset uy",
    );
    place.edit(
        "pad.tcl",
        "element zeroLength",
        "if {$k0 < 1.1} {exit 3}\nif {$k0 < 1.2} {node 1 0.0}\nelement zeroLength",
    );
    let mut s = simulator(&place);
    s.open(&mut SourceMap::default()).unwrap();
    let mut kind = |k0: f64| s.simulate(0, &[k0, 17.0, 0.2]).map_err(|m| m.kind());
    assert_eq!(kind(4.95), Err("it took too long"));
    assert_eq!(kind(4.6), Err("the script raised an error"));
    assert_eq!(kind(1.05), Err("the script ended itself"));
    assert_eq!(kind(1.15), Err("a command was rejected"));
    assert!(kind(3.0).is_ok());
    let problem = StudyProblem::of_script(&s, 2).unwrap();
    let points: Vec<Vec<f64>> = (0..12).map(|i| vec![f64::from(i) / 11.0, 0.5, 0.5]).collect();
    let all = problem.evaluate(&points, true);
    assert_eq!(all.iter().filter(|e| e.mishap.is_some()).count(), 3);
    assert!(matches!(all[11].mishap, Some(Mishap::TooLong(_))));
    for e in all.iter().filter(|e| e.mishap.is_none()) {
        let sum: f64 = e.trial.residuals.iter().map(|r| r * r).sum();
        assert!((sum - e.trial.score).abs() < 1e-12 * sum, "the squares of the residuals add up to the objective");
    }
    // Any number of threads gives the same.
    let one = StudyProblem::of_script(&s, 1).unwrap();
    assert_eq!(one.evaluate(&points, true), all);
}
