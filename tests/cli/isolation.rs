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
            let of = format!("a second on {threads} thread");
            assert!(said.contains(" analyses in ") && said.contains(&of), "{command}: {said}");
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

/// The shipped study with a script and records that are found from any folder, and with some of its text replaced.
fn changed(changes: &[(&str, &str)]) -> String {
    let folder = format!("{INPUTS}/isolation_study");
    let mut text = fs::read_to_string(study()).unwrap();
    text = text.replace("\"building.tcl\"", &format!("\"{folder}/building.tcl\""));
    text = text.replace("\"../ground_motions", &format!("\"{INPUTS}/ground_motions"));
    for (from, to) in changes {
        assert!(text.contains(from), "{from}");
        text = text.replace(from, to);
    }
    text
}

/// A study that contradicts its script is refused before the suite, with the key and the ratio.
#[test]
fn contradictions_of_study_and_script_are_refused() {
    let place = Place::new();
    for (name, from, to, named) in [
        ("strength", "q_d = 26.0", "q_d = 52.0", ["q_d = 52", "ratio 2.0000"]),
        ("stiffness", "k_d = 440.0", "k_d = 0.44", ["k_d = 0.44", "ratio 0.0010"]),
        ("yield", "yield_displacement = 0.0066", "yield_displacement = 6.6", ["yield_displacement = 6.6", "0.0000"]),
        ("weight", "weight = 1177.2", "weight = 117.72", ["the floors weigh 470.88", "ratio 0.1000"]),
        ("gravity", "gravity = 9.81", "gravity = 9810.0", ["gravity = 9810", "ratio 1000"]),
        ("bound", "name = \"LRB\"", "name = \"LRX\"", ["the lower bound", "isolate(Q,LRX)"]),
        ("list", "7, 8, 9]", "7, 8]", ["the floors weigh", "the list of bearings"]),
        (
            "storey",
            "node = 102\nweight = 1177.2\nheight = 3.5",
            "node = 102\nweight = 1177.2\nheight = 3500.0",
            ["height = 3500 of the floor at node 102", "ratio 1000"],
        ),
        ("order", "node = 103", "node = 100", ["the floor at node 100 is", "from the base upwards"]),
        ("node", "node = 103", "node = 203", ["has no node 203", "floor"]),
        (
            "plan",
            "plan = [12.0, 12.0]",
            "plan = [12000.0, 1.2]",
            ["smaller than the grid of the bearings in y", "ratio 0.1000"],
        ),
        ("length", "units = [\"kN\", \"m\"]", "units = [\"kN\", \"mm\"]", ["gravity = 9.81", "ratio 0.0010"]),
        ("diameter", "diameter = 0.5", "diameter = 500.0", ["diameter = 500 of LRB", "ratio 83.3333"]),
        ("capacity", "displacement = 0.35", "displacement = 350.0", ["displacement = 350 of LRB", "ratio 58.3333"]),
        ("critical", "critical_load = 3000.0", "critical_load = 3.0e6", ["critical_load = 3000000", "ratio 5733"]),
        ("order", "[0.8, 0.95]", "[4.0, 0.95]", ["exchanged", "ratio"]),
        ("target", "sms=1.0", "sms=100", ["sms=100", "at most 10"]),
        ("tag", "7, 8, 9]", "7, 8, 99]", ["LRB 99", "is no element"]),
        ("key", "k_d = 440.0", "k_D = 440.0", ["k_D", "k_d"]),
    ] {
        let file = format!("{name}.toml");
        place.write(&file, changed(&[(from, to)]));
        for command in ["check", "isolate"] {
            let (status, _, said) = place.run(&[command, &file]);
            assert_eq!(status, Some(2), "{name}, {command}: {said}");
            assert!(named.iter().all(|n| said.contains(n)), "{name}, {command}: {said}");
        }
        assert!(!place.0.join("isolation/analyses").exists(), "{name}: the suite ran");
    }
}

/// A ground that moves otherwise than the study says, and a floor without its mass, are refused with both numbers.
#[test]
fn a_script_that_uses_other_motions_or_masses_is_refused() {
    let place = Place::new();
    let script = fs::read_to_string(format!("{INPUTS}/isolation_study/building.tcl")).unwrap();
    let folder = format!("{INPUTS}/isolation_study/building.tcl");
    place.write("study.toml", changed(&[]).replace(&folder, "building.tcl"));
    for (from, to, named) in [
        ("-values $isolate(ax)", "-values $isolate(ax) -factor $g", ["in x", "ratio 9.8100"]),
        ("-values $isolate(ay)", "-values $isolate(ax)", ["in y", "differs by"]),
        ("Path 2 -dt $isolate(dt)", "Path 2 -dt 0.02", ["isolate(dt)", "differs by"]),
        ("pattern UniformExcitation 3 2", "pattern UniformExcitation 3 1", ["in x", "in its direction"]),
        ("pattern UniformExcitation 3 2 -accel 3\n", "", ["in y", "ratio 0.0000"]),
        (
            "    mass [expr {100 + $l}] $mass",
            "    mass [expr {$l == 2 ? 100 : 100 + $l}] $mass",
            ["weight = 1177.2 of the floor at node 102", "ratio 0.0000"],
        ),
    ] {
        assert!(script.contains(from), "{from}");
        place.write("building.tcl", script.replacen(from, to, 1));
        let (status, _, said) = place.run(&["check", "study.toml"]);
        assert!(status == Some(2) && named.iter().all(|n| said.contains(n)), "{to}: {said}");
    }
    // In cm/s² in the place of g the suite is 1/981 of its target.
    place.write("building.tcl", &script);
    let study = changed(&[("unit = \"g\"", "unit = \"cm/s2\""), ("scale = [1.5, 3.5]\n", "")]);
    place.write("study.toml", study.replace(&folder, "building.tcl"));
    for command in ["check", "isolate"] {
        let (status, _, said) = place.run(&[command, "study.toml"]);
        assert!(
            status == Some(2) && said.contains("the mean spectrum of the motions") && said.contains("e-4"),
            "{command}: {said}"
        );
    }
}

/// An eccentricity that the script does not use is refused.
#[test]
fn an_eccentricity_moves_the_mass() {
    let place = Place::new();
    let script = fs::read_to_string(format!("{INPUTS}/isolation_study/building.tcl")).unwrap();
    place.write("building.tcl", script.replace("$isolate(ey)*$side", "0.0*$side"));
    let folder = format!("{INPUTS}/isolation_study/building.tcl");
    place.write("study.toml", changed(&[]).replace(&folder, "building.tcl"));
    let (status, _, said) = place.run(&["check", "study.toml"]);
    assert!(status == Some(2) && said.contains("does it use isolate(ey)?"), "{said}");
}

/// An eccentricity that moves the gravity loads with the mass is refused.
#[test]
fn an_eccentricity_moves_no_gravity() {
    let place = Place::new();
    let script = fs::read_to_string(format!("{INPUTS}/isolation_study/building.tcl")).unwrap();
    let moments = "[expr {$isolate(ey)*$side*$w}] [expr {-$isolate(ex)*$side*$w}]";
    assert!(script.contains(moments));
    place.write("building.tcl", script.replace(moments, "0.0 0.0"));
    let folder = format!("{INPUTS}/isolation_study/building.tcl");
    place.write("study.toml", changed(&[]).replace(&folder, "building.tcl"));
    let (status, _, said) = place.run(&["check", "study.toml"]);
    assert!(status == Some(2) && said.contains("moves mass, never gravity"), "{said}");
}

/// Without the values of the script the study has the same design as with them.
#[test]
fn values_of_the_script_need_not_be_repeated() {
    let place = Place::new();
    let bare = ["q_d = 26.0", "k_d = 440.0", "yield_displacement = 0.0066", "weight = 1177.2"].map(|key| (key, "#"));
    place.write("bare.toml", changed(&bare));
    place.write("whole.toml", changed(&[]));
    let [bare, whole] = ["bare.toml", "whole.toml"].map(|file| {
        let (status, printed, said) = place.run(&["response-spectrum", file, "--json", "--out", "out"]);
        assert_eq!(status, Some(0), "{said}");
        let json: serde_json::Value = serde_json::from_str(&printed).unwrap();
        let rows = json["bearings"].as_array().unwrap().clone();
        assert_eq!(rows.len(), 6, "{printed}");
        rows
    });
    // The loop's own yield displacement is a little larger than that of its straight lines.
    for (bare, whole) in bare.iter().zip(&whole) {
        for key in ["D", "K_eff", "beta_eff"] {
            let [a, b] = [bare, whole].map(|row| row[key].as_f64().unwrap());
            assert!((a - b).abs() <= 0.02 * b, "{key}: {a}, {b}");
        }
    }
    let (status, printed, said) = place.run(&["check", "bare.toml"]);
    assert_eq!(status, Some(0), "{said}");
    assert!(printed.contains("from the script") && printed.contains("4708.8"), "{printed}");
}

/// A suite whose bearings move beyond three times the displacement of the equivalent lateral force procedure stops.
#[test]
fn a_suite_that_runs_away_is_stopped() {
    let place = Place::new();
    place.write("far.toml", changed(&[("unit = \"g\"", "unit = \"g\"\nfactor = 8.0"), ("scale = [1.5, 3.5]\n", "")]));
    let (status, _, said) = place.run(&["isolate", "far.toml"]);
    assert!(status != Some(0) && said.contains("the suite was stopped"), "{said}");
    assert!(!place.0.join("isolation/report.html").exists());
    // Analyses behind the first that cannot be believed are not made.
    let (_, printed, _) = place.run(&["check", "far.toml"]);
    let (_, _, said) = place.run(&["isolate", "far.toml", "--threads", "1", "--out", "again"]);
    let made = fs::read_dir(place.0.join("again/analyses")).unwrap().count();
    assert!(made == 1 && !printed.contains(": 1 analyses"), "{made}: {said}{printed}");
}
