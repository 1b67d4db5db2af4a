//! `hysteron learn`: a law from a study, and the script and file that carry it.

use super::Place;
use std::fmt::Write as _;

const SCRIPT: &str = "wipe; model basic -ndm 1 -ndf 1\nnode 1 0.0\nnode 2 0.0\nfix 1 1\npset Q 8.0\npset k 1.0\n\
    if {![info exists motion]} {set motion first.dat}\n\
    uniaxialMaterial ElasticPP 1 100.0 [expr {$Q/100.0}]\nuniaxialMaterial Elastic 2 $k\n\
    element zeroLength 1 1 2 -mat 1 2 -dir 1 1\ntimeSeries Path 1 -dt 0.03 -filePath $motion -useLast\n\
    pattern Plain 1 1 {sp 2 1 1.0}\nrecorder Element -file force.out -time -ele 1 force\n\
    constraints Transformation\nnumberer Plain\nsystem ProfileSPD\ntest NormDispIncr 1.0e-10 50\nalgorithm Newton\n\
    integrator LoadControl 0.03\nanalysis Static\nif {[analyze 1199] != 0} {error stopped}\n";

/// Motions: a growing sine, cycles with pauses, and a beat.
const MOTIONS: [fn(f64) -> f64; 3] = [
    |t| (1.0 - (-0.2 * t).exp()) * (2.1 * t).sin(),
    |t| if t % 12.0 < 6.0 { 0.8 * (0.3 * t).min(1.0) * (std::f64::consts::TAU * t / 3.0).sin() } else { 0.0 },
    |t| 0.7 * (1.7 * t).sin() * (0.31 * t).cos(),
];

/// Step of the motions, s.
const STEP: f64 = 0.03;

/// A study of a device of which a force along a motion is recorded. The third run is held out.
fn place_of(script: &str, parameters: [(&str, f64, f64); 2], force: fn(&[f64]) -> Vec<f64>) -> Place {
    let place = Place::new();
    let mut study = String::from("model = \"model.tcl\"\n");
    for (name, lower, upper) in parameters {
        let _ = write!(study, "[[parameter]]\nname = \"{name}\"\nlower = {lower}\nupper = {upper}\n");
    }
    for (k, (name, motion)) in ["first", "second", "third"].into_iter().zip(MOTIONS).enumerate() {
        let u: Vec<f64> = (0..1200).map(|i| motion(STEP * f64::from(i))).collect();
        let (mut history, mut rows) = (String::new(), String::from("time[s],force[kN],disp[mm]\n"));
        for ((i, u), force) in (0..).zip(&u).zip(force(&u)) {
            let force = force + 0.02 * (17.3 * f64::from(i) + f64::from(i * i % 101)).sin();
            let _ = writeln!(history, "{u:.8}");
            let _ = writeln!(rows, "{:.2},{force:.6},{u:.8}", STEP * f64::from(i));
        }
        place.write(&format!("{name}.dat"), &history);
        place.write(&format!("{name}.csv"), &rows);
        let role = if k == 2 { "holdout" } else { "fit" };
        let _ = write!(
            study,
            "[[run]]\nname = \"{name}\"\nrole = \"{role}\"\nrecording = \"{name}.csv\"\nset = {{ motion = \"{name}.dat\" }}\n\
             [[run.observe]]\nchannel = \"force\"\noutput = \"force.out\"\ncolumn = 2\n"
        );
    }
    place.write("model.tcl", script);
    place.write("study.toml", &study);
    place
}

/// A study of a slider whose strength falls with the work done.
fn place() -> Place {
    place_of(SCRIPT, [("Q", 2.0, 20.0), ("k", 0.1, 10.0)], |u| {
        let (mut s, mut work, mut last) = (0.0f64, 0.0, 0.0);
        let mut force = |u: f64| {
            let level = 0.1 * (1.0 - 0.5 * (1.0 - f64::exp(-work / 15.0)));
            let trial = s + u - last;
            (s, last) = (trial.clamp(-level, level), u);
            work += 100.0 * level * (trial - s).abs();
            u + 100.0 * s
        };
        u.iter().map(|u| force(*u)).collect()
    })
}

/// Errors of a row of the printed table: of the user's model and of the law.
fn errors(said: &str, row: &str) -> [f64; 2] {
    let line = said.lines().find(|l| l.starts_with(row)).unwrap_or_else(|| panic!("{said}"));
    let mut numbers = line[row.len()..].split_whitespace().map(|w| w.parse().unwrap_or(f64::NAN));
    [numbers.next().unwrap_or(f64::NAN), numbers.next().unwrap_or(f64::NAN)]
}

#[test]
fn a_law_is_learned_written_and_run() {
    let place = place();
    let (status, said, err) = place.run(&["learn", "study.toml", "--out", "out", "--threads", "1"]);
    assert_eq!(status, Some(0), "{err}");
    assert!(said.contains("of the family work"), "{said}");
    let [before, after] = errors(&said, "runs held out");
    assert!(after < 0.1 * before, "{said}");
    // The engine gives what the fit promised.
    let [_, simulated] = errors(&said, "the same, simulated");
    assert!((simulated / after - 1.0).abs() < 0.2, "{said}");
    let (status, _, err) = place.run(&["run", "out/learned.tcl"]);
    assert_eq!(status, Some(0), "{err}");
    // Any number of threads gives the same bits.
    let read = |name: &str| std::fs::read_to_string(place.0.join(name)).unwrap_or_default();
    let law = read("out/learned_law.json");
    let (status, ..) = place.run(&["learn", "study.toml", "--out", "again", "--threads", "2"]);
    assert_eq!((status, read("again/learned_law.json")), (Some(0), law));
}

#[test]
fn without_a_rig_there_is_nothing_to_learn() {
    let place = place();
    let shaken = SCRIPT
        .replace("fix 1 1", "fix 1 1; mass 2 1.0")
        .replace("pattern Plain 1 1 {sp 2 1 1.0}", "pattern UniformExcitation 1 1 -accel 1")
        .replace("integrator LoadControl 0.03\nanalysis Static", "integrator Newmark 0.5 0.25\nanalysis Transient")
        .replace("analyze 1199", "analyze 1199 0.03");
    place.write("model.tcl", shaken);
    let (status, _, err) = place.run(&["learn", "study.toml", "--out", "out"]);
    assert_eq!(status, Some(1), "{err}");
    assert!(err.contains("no channel shows the force of a device"), "{err}");
}

/// A dashpot has no stiffness, and a law all the same: here one whose oil is a spring of 0.3 s, which the model lacks.
#[test]
fn a_dashpot_alone_has_a_law() {
    let script = SCRIPT
        .replace("fix 1 1", "fix 1 1; mass 2 1.0e-6")
        .replace("ElasticPP 1 100.0 [expr {$Q/100.0}]", "Viscous 1 $Q $alpha")
        .replace("pset k 1.0", "pset alpha 0.8")
        .replace("uniaxialMaterial Elastic 2 $k\n", "")
        .replace("-mat 1 2 -dir 1 1", "-mat 1 -dir 1")
        .replace("constraints Transformation", "constraints Penalty 1.0e9 1.0e9")
        .replace("integrator LoadControl 0.03\nanalysis Static", "integrator Newmark 1.0 1.0\nanalysis Transient")
        .replace("analyze 1199", "analyze 1199 0.03");
    let place = place_of(&script, [("Q", 0.5, 50.0), ("alpha", 0.3, 1.5)], |u| {
        let (mut h, mut last) = (0.0, 0.0);
        let kept = f64::exp(-STEP / 0.3);
        let mut force = |u: f64| {
            h = kept * h + (1.0 - kept) * 0.3 / STEP * 20.0 * (u - last);
            last = u;
            h
        };
        u.iter().map(|u| force(*u)).collect()
    });
    let (status, said, err) = place.run(&["learn", "study.toml", "--out", "out", "--threads", "1"]);
    assert_eq!(status, Some(0), "{err}");
    let [before, after] = errors(&said, "the same, simulated");
    assert!(after < 0.1 * before, "{said}");
    let (status, _, err) = place.run(&["run", "out/learned.tcl"]);
    assert_eq!(status, Some(0), "{err}");
}

/// No law is written beside a model that explains the runs held out, and that of an earlier study goes.
#[test]
fn a_law_that_gains_too_little_is_not_written() {
    let place = place_of(SCRIPT, [("Q", 2.0, 20.0), ("k", 0.1, 10.0)], |u| {
        let (mut s, mut last) = (0.0f64, 0.0);
        let mut force = |u: f64| {
            (s, last) = ((s + u - last).clamp(-0.1, 0.1), u);
            u + 100.0 * s
        };
        u.iter().map(|u| force(*u)).collect()
    });
    std::fs::create_dir_all(place.0.join("out")).unwrap();
    place.write("out/learned_law.json", "{}");
    let (status, said, err) = place.run(&["learn", "study.toml", "--out", "out", "--threads", "1"]);
    assert_eq!(status, Some(0), "{err}");
    let [before, after] = errors(&said, "runs held out");
    assert!(after > 0.7 * before, "{said}");
    assert!(!place.0.join("out/learned_law.json").exists() && !place.0.join("out/learned.tcl").exists(), "{err}");
}
