//! Isolation studies through the program: the shipped examples, any number of threads, and what is kept.

use super::Place;
use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::Duration;

const INPUTS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tcl-like-inputs");

fn study() -> String {
    format!("{INPUTS}/isolation_study/study.toml")
}

/// Content of the results, without the analyses.
fn results(folder: &Path) -> Vec<(String, String)> {
    let mut all: Vec<_> = fs::read_dir(folder)
        .unwrap()
        .map(|e| e.unwrap().path())
        .filter(|p| p.is_file())
        .map(|p| (p.file_name().unwrap().to_str().unwrap().to_owned(), fs::read_to_string(&p).unwrap()))
        .collect();
    all.sort();
    all
}

#[test]
fn results_do_not_depend_on_threads() {
    let place = Place::new();
    let study = study();
    for (command, files) in [("fragility", 4), ("isolate", 5), ("ida", 5)] {
        for threads in ["1", "2"] {
            let out = format!("{command}{threads}");
            let (status, _, said) = place.run(&[command, &study, "--out", &out, "--threads", threads]);
            // Checks of the shipped study that are not met are results.
            assert_eq!(status, Some(0), "{command}: {said}");
        }
        let [one, two] = ["1", "2"].map(|threads| results(&place.0.join(format!("{command}{threads}"))));
        assert!(one.len() >= files, "{command}: {} files", one.len());
        assert_eq!(one, two, "{command}");
    }
}

/// A study that is killed keeps its complete analyses and ends with the results of a whole one.
#[test]
fn a_killed_study_goes_on() {
    let place = Place::new();
    let study = study();
    assert_eq!(place.run(&["ida", &study, "--out", "whole"]).0, Some(0));
    let mut command = Command::new(env!("CARGO_BIN_EXE_hysteron"));
    command.args(["ida", &study, "--out", "killed", "--threads", "1"]).current_dir(&place.0);
    let mut child = command.stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap();
    let analyses = place.0.join("killed/analyses");
    let count = || fs::read_dir(&analyses).map_or(0, Iterator::count);
    while count() < 3 {
        std::thread::sleep(Duration::from_millis(1));
    }
    child.kill().unwrap();
    child.wait().unwrap();
    assert!(!place.0.join("killed/report.html").exists(), "it was over before it was killed");
    assert_eq!(place.run(&["ida", &study, "--out", "killed", "--resume"]).0, Some(0));
    assert_eq!(results(&place.0.join("whole")), results(&place.0.join("killed")));
}

#[test]
fn a_response_spectrum_analysis_writes_its_tables() {
    let place = Place::new();
    let (status, printed, said) = place.run(&["response-spectrum", &study(), "--out", "out"]);
    assert_eq!(status, Some(0), "{said}");
    assert!(printed.contains("CQC") && printed.contains("100 % + 30 %"), "{printed}");
    for file in ["bearings.csv", "modes.csv", "responses.csv", "report.html", "response_spectrum.json"] {
        assert!(place.0.join("out").join(file).is_file(), "{file}");
    }
}

/// Studies that are wrong: the key or the file is named, and nothing is left.
#[test]
fn mistakes_in_a_study_are_said() {
    let place = Place::new();
    let text = fs::read_to_string(study()).unwrap();
    place.write("key.toml", text.replacen("[intensity]", "[intensities]", 1));
    place.write("counts.csv", "intensity,records,reached\n0.1,10,1\n0.2,ten,5\n");
    for (command, file, named) in [
        ("ida", "key.toml", "intensities"),
        ("fragility", "counts.csv", "ten"),
        ("response-spectrum", "none.toml", "none.toml"),
    ] {
        let (status, _, said) = place.run(&[command, file, "--out", "out"]);
        assert!(status != Some(0) && said.contains(named), "{command}: {said}");
        assert!(!place.0.join("out/report.html").exists());
    }
}

/// The fixed-base twin, and the tests of a prototype that their commands measure.
#[test]
fn shipped_scripts_beside_the_studies_run() {
    let place = Place::new();
    for script in ["eight_storey_study/fixed_base.tcl", "prototype_study/tests.tcl", "batch_study/isolator.tcl"] {
        let (status, _, said) = place.run(&["run", "--strict", &format!("{INPUTS}/{script}")]);
        assert_eq!(status, Some(0), "{script}: {said}");
    }
    let tests: Vec<String> = (1..=4).map(|i| format!("results/prototype/test{i}.csv")).collect();
    let mut words = vec!["prototype"];
    words.extend(tests.iter().map(String::as_str));
    words.extend(
        "-t time -u disp -f force --units kN m --code asce7-16 --design 0.30 --out results/prototype".split(' '),
    );
    let (status, printed, said) = place.run(&words);
    assert_eq!(status, Some(0), "{said}");
    assert!(printed.contains("K_eff"), "{printed}");
}
