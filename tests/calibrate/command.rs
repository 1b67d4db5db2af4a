//! `hysteron calibrate` as its user sees it.

use super::Place;
use std::fs;
use std::process::Command;

fn calibrate(place: &Place, args: &[&str]) -> (Option<i32>, String) {
    let output = Command::new(env!("CARGO_BIN_EXE_hysteron"))
        .arg("calibrate")
        .args(args)
        .current_dir(&place.0)
        .output()
        .unwrap();
    let err = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(!err.contains("panicked"), "{err}");
    assert!(output.stdout.is_empty(), "messages go to standard error");
    (output.status.code(), err)
}

fn json(place: &Place, path: &str) -> serde_json::Value {
    serde_json::from_str(&fs::read_to_string(place.0.join(path)).unwrap()).unwrap()
}

#[test]
fn finds_the_parameters() {
    let place = Place::new();
    let (status, err) = calibrate(&place, &["study.toml", "--out", "out"]);
    assert_eq!(status, Some(0), "{err}");
    let found = json(&place, "out/calibration.json");
    // What the recordings were made with; noise of a standard deviation of 0.28 kN in forces of 17 and more.
    for (name, truth) in [("k0", 2.6), ("Qd", 17.0), ("alpha", 0.21)] {
        let x = found["parameters"][name].as_f64().unwrap();
        assert!((x - truth).abs() < 0.05 * truth, "{name} = {x}");
        let all = found["uncertainty"]["intervals"].as_array().unwrap();
        let interval = all.iter().find(|i| i["name"] == name).unwrap();
        assert!(interval["lower"].as_f64().unwrap() < x && interval["upper"].as_f64().unwrap() > x);
    }
    assert!(found["objective"].as_f64().unwrap() < 2e-3, "{found}");
    assert_eq!(found["runs"][1]["role"], "holdout");
    assert!(found["runs"][1]["nmse"].as_f64().unwrap() < 2e-3, "{found}");
    assert_eq!(found["runs"][0]["channels"][0]["missing"], 3);
    assert!(found["evaluations"].as_u64().unwrap() > 100 && found["wall_s"].as_f64().unwrap() > 0.0);
    assert_eq!(found["seed"], 1);
    // The script with the values in place has that error by itself.
    let script = fs::read_to_string(place.0.join("out/fitted.tcl")).unwrap();
    let k0 = found["parameters"]["k0"].as_f64().unwrap();
    assert!(script.contains(&format!("pset k0    {k0:?}\n")), "{script}");
    // Another number of threads, the same result.
    let (status, _) = calibrate(&place, &["study.toml", "--out", "again", "--threads", "1"]);
    assert_eq!(status, Some(0));
    let again = json(&place, "again/calibration.json");
    assert_eq!((&again["parameters"], &again["objective"]), (&found["parameters"], &found["objective"]));
    assert!(!place.0.join("out/checkpoint.json").exists());
    let report = fs::read_to_string(place.0.join("out/report.html")).unwrap();
    for part in ["Loops, upper plate", "Error by amplitude", "Convergence", "correlation", "<svg"] {
        assert!(report.contains(part), "{part}");
    }
    assert!(!report.contains("src=") && !report.contains("href="), "it stands by itself");
}

/// Intervals by curvature, profile and posterior agree where the problem is nearly linear, and hold the truth.
#[test]
fn three_ways_to_be_sure() {
    let place = Place::new();
    let (status, err) = calibrate(&place, &["study.toml", "--out", "out", "--profile", "--posterior", "120"]);
    assert_eq!(status, Some(0), "{err}");
    let found = json(&place, "out/calibration.json");
    for (i, interval) in found["uncertainty"]["intervals"].as_array().unwrap().iter().enumerate() {
        let width = |v: &serde_json::Value| v["upper"].as_f64().unwrap() - v["lower"].as_f64().unwrap();
        for other in [&found["profiles"][i], &found["posterior"]["quantiles"][i]] {
            let ratio = width(other) / width(interval);
            assert!((0.5..2.0).contains(&ratio), "{interval} {other}");
        }
    }
    let acceptance = found["posterior"]["acceptance"].as_f64().unwrap();
    assert!((0.3..0.9).contains(&acceptance), "{acceptance}");
}

/// Parameters that the data do not determine are told in plain words.
#[test]
fn what_the_data_do_not_determine() {
    let place = Place::new();
    place.edit("pad.tcl", "set uy", "pset idle 1.0\npset factor 1.0\nset k0 [expr {$k0*$factor}]\nset uy");
    let more = "[[parameter]]\nname = \"idle\"\nlower = 0.0\nupper = 2.0\n\n[[parameter]]\nname = \"factor\"\nlower = 0.5\n\
                upper = 2.0\n\n[[run]]";
    place.edit("study.toml", "[[run]]", more);
    let (status, err) = calibrate(&place, &["study.toml"]);
    assert_eq!(status, Some(0), "{err}");
    assert!(err.contains("idle has no influence on what was recorded"), "{err}");
    assert!(err.contains("only a combination of k0, factor has an influence"), "{err}");
}

#[test]
fn exit_status() {
    let place = Place::new();
    assert_eq!(calibrate(&place, &["nothing.toml"]).0, Some(2));
    place.edit("study.toml", "[[run]]", "[calibration]\nmethod = \"de/best/1\"\n[[run]]");
    let (status, err) = calibrate(&place, &["study.toml"]);
    assert!(status == Some(2) && err.contains("unknown method") && err.contains("study.toml:22:10"), "{err}");
    place.edit("study.toml", "de/best/1\"", "de/rand/1/bin\"\npopulation = 5\ngenerations = 2");
    let (status, err) = calibrate(&place, &["study.toml"]);
    assert_eq!(status, Some(0), "{err}");
    let found = json(&place, "results/calibration.json");
    assert_eq!((&found["evaluations"], &found["method"]), (&15.into(), &"de/rand/1/bin".into()));
    // A script that fails whatever the values.
    place.edit("pad.tcl", "fix 1 1", "fix 1 1\nnode 3 0.0");
    let (status, err) = calibrate(&place, &["study.toml"]);
    assert!(status == Some(1) && err.contains("no values have an answer"), "{err}");
}

#[test]
fn several_studies_in_one_table() {
    let place = Place::new();
    place.edit("study.toml", "[[run]]", "[calibration]\nevaluations = 60\n[[run]]");
    fs::write(
        place.0.join("linear.toml"),
        fs::read_to_string(place.study()).unwrap().replace(
            "[[parameter]]\nname  = \"alpha\"\nlower = 0.05\nupper = 0.4",
            "[[parameter]]\nname = \"alpha\"\nvalue = 0.9",
        ),
    )
    .unwrap();
    let (status, err) = calibrate(&place, &["study.toml", "linear.toml", "--out", "both"]);
    assert_eq!(status, Some(0), "{err}");
    assert!(err.contains("objective") && err.contains("BIC"), "{err}");
    assert_eq!(fs::read_dir(place.0.join("both")).unwrap().count(), 3);
    let table = fs::read_to_string(place.0.join("both/comparison.txt")).unwrap();
    assert!(table.contains("by amplitude") && table.matches("growing").count() >= 8, "{table}");
}

/// Each run to be fitted says by itself what it determines.
#[test]
fn what_a_run_tells_by_itself() {
    let place = Place::new();
    place.edit("study.toml", "\"holdout\"", "\"fit\"");
    let (status, err) = calibrate(&place, &["study.toml", "--out", "out"]);
    assert_eq!(status, Some(0), "{err}");
    let sure = &json(&place, "out/calibration.json")["uncertainty"];
    let alone = sure["alone"].as_array().unwrap();
    assert_eq!(alone.len(), 2);
    for (i, all) in sure["intervals"].as_array().unwrap().iter().enumerate() {
        let all = all["relative"].as_f64().unwrap();
        assert!(alone.iter().all(|a| a["relative"][i].as_f64().unwrap() > 0.9 * all), "{sure}");
    }
}

/// `hysteron check` of a study looks at all that a calibration would, and writes nothing.
#[test]
fn a_study_is_checked() {
    let place = Place::new();
    let check = || {
        let mut command = Command::new(env!("CARGO_BIN_EXE_hysteron"));
        let output = command.args(["check", "study.toml"]).current_dir(&place.0).output().unwrap();
        (output.status.code(), String::from_utf8_lossy(&output.stderr).into_owned())
    };
    let files = || fs::read_dir(&place.0).unwrap().count();
    let before = files();
    let (status, err) = check();
    assert_eq!(status, Some(0), "{err}");
    assert!(err.contains("3 of 3 parameters to be found") && err.contains("3 missing"), "{err}");
    assert!(err.contains("with the script's own values"), "{err}");
    assert_eq!(files(), before);
    place.edit("study.toml", "force.out", "forse.out");
    let (status, err) = check();
    assert!(status == Some(2) && err.contains("forse.out has no rows"), "{err}");
}
