//! Tests of `hysteron calibrate` as a command.

use super::StudyFolder;
use std::fs;
use std::process::Command;

/// Exit status, and what is printed to both streams.
fn calibrate(folder: &StudyFolder, args: &[&str]) -> (Option<i32>, String) {
    let (status, out, err) = streams(folder, args);
    (status, out + &err)
}

/// Exit status, standard output, standard error.
fn streams(folder: &StudyFolder, args: &[&str]) -> (Option<i32>, String, String) {
    let output = Command::new(env!("CARGO_BIN_EXE_hysteron"))
        .arg("calibrate")
        .args(args)
        .current_dir(&folder.0)
        .output()
        .unwrap();
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    let (out, err) = (text(&output.stdout), text(&output.stderr));
    assert!(!err.contains("panicked"), "{err}");
    (output.status.code(), out, err)
}

fn json(folder: &StudyFolder, path: &str) -> serde_json::Value {
    serde_json::from_str(&fs::read_to_string(folder.0.join(path)).unwrap()).unwrap()
}

/// A script of the results runs from its own folder and from that of the study, with variables of its own and with
/// those of another script, and writes its recorders into the current folder.
fn runs_from_either_folder(folder: &StudyFolder, script: &str) {
    let around = format!("set motion random.dat\nset dt 0.02\nset npts 401\nsource {script}\n");
    fs::write(folder.0.join("around.tcl"), around).unwrap();
    let (results, name) = script.split_once('/').unwrap();
    let forces = [(results, name), (".", script), (".", "around.tcl")].map(|(from, script)| {
        let from = folder.0.join(from);
        let done =
            Command::new(env!("CARGO_BIN_EXE_hysteron")).args(["run", script]).current_dir(&from).output().unwrap();
        assert!(done.status.success(), "{script}: {}", String::from_utf8_lossy(&done.stderr));
        let force = fs::read_to_string(from.join("force.out")).unwrap();
        fs::remove_file(from.join("force.out")).unwrap();
        force
    });
    assert_eq!(forces[0], forces[1]);
    assert_eq!((forces[0].lines().count(), forces[2].lines().count()), (500, 400));
}

#[test]
fn calibration_finds_the_true_parameters() {
    let folder = StudyFolder::new();
    let (status, err) = calibrate(&folder, &["study.toml", "--out", "out"]);
    assert_eq!(status, Some(0), "{err}");
    let found = json(&folder, "out/calibration.json");
    // True values of the recordings, whose noise has a standard deviation of 0.28 kN in forces of 17 kN and more.
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
    // The fitted script has the calibrated value.
    let script = fs::read_to_string(folder.0.join("out/fitted.tcl")).unwrap();
    let k0 = found["parameters"]["k0"].as_f64().unwrap();
    assert!(script.contains(&format!("pset k0    {k0:?}\n")), "{script}");
    runs_from_either_folder(&folder, "out/fitted.tcl");
    let channels = fs::read_to_string(folder.0.join("out/channels/growing.csv")).unwrap();
    let mut rows = channels.lines();
    assert_eq!(rows.next(), Some("time[s],force_recorded[kN],force_simulated[kN],force_residual[kN]"));
    let numbers = |row: &str| row.split(',').map(|x| x.parse().unwrap_or(f64::NAN)).collect::<Vec<f64>>();
    let rows: Vec<Vec<f64>> = rows.map(numbers).collect();
    assert_eq!(rows.len(), 499);
    assert_eq!(rows.iter().filter(|r| r[1].is_nan() && r[3].is_nan()).count(), 3, "missing samples are empty");
    assert!(rows.iter().all(|r| r[1].is_nan() || (r[2] - r[1] - r[3]).abs() < 1e-9));
    assert!(folder.0.join("out/channels/random.csv").exists());
    // The result does not depend on the number of threads.
    let (status, _) = calibrate(&folder, &["study.toml", "--out", "again", "--threads", "1"]);
    assert_eq!(status, Some(0));
    let again = json(&folder, "again/calibration.json");
    assert_eq!((&again["parameters"], &again["objective"]), (&found["parameters"], &found["objective"]));
    assert!(!folder.0.join("out/checkpoint.json").exists());
    let report = fs::read_to_string(folder.0.join("out/report.html")).unwrap();
    for part in ["Loops, upper plate", "Error by amplitude", "Convergence", "correlation", "<svg"] {
        assert!(report.contains(part), "{part}");
    }
    assert!(!report.contains("src=") && !report.contains("href="), "it stands by itself");
}

/// The example is nearly linear, so that all three estimates must agree.
#[test]
fn curvature_profile_and_posterior_give_similar_intervals() {
    let folder = StudyFolder::new();
    let (status, err) = calibrate(&folder, &["study.toml", "--out", "out", "--profile", "--posterior", "120"]);
    assert_eq!(status, Some(0), "{err}");
    let found = json(&folder, "out/calibration.json");
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

#[test]
fn undetermined_parameters_are_reported() {
    let folder = StudyFolder::new();
    folder.edit("pad.tcl", "set uy", "pset idle 1.0\npset factor 1.0\nset k0 [expr {$k0*$factor}]\nset uy");
    let more = "[[parameter]]\nname = \"idle\"\nlower = 0.0\nupper = 2.0\n\n[[parameter]]\nname = \"factor\"\nlower = 0.5\n\
                upper = 2.0\n\n[[run]]";
    folder.edit("study.toml", "[[run]]", more);
    let (status, err) = calibrate(&folder, &["study.toml"]);
    assert_eq!(status, Some(0), "{err}");
    assert!(err.contains("idle has no influence on what was recorded"), "{err}");
    assert!(err.contains("only a combination of k0, factor has an influence"), "{err}");
}

#[test]
fn exit_status_tells_input_errors_from_failures() {
    let folder = StudyFolder::new();
    assert_eq!(calibrate(&folder, &["nothing.toml"]).0, Some(2));
    folder.edit("study.toml", "[[run]]", "[calibration]\nmethod = \"de/best/1\"\n[[run]]");
    let (status, err) = calibrate(&folder, &["study.toml"]);
    assert!(status == Some(2) && err.contains("unknown method") && err.contains("study.toml:22:10"), "{err}");
    folder.edit("study.toml", "de/best/1\"", "de/rand/1/bin\"\npopulation = 5\ngenerations = 2");
    let (status, err) = calibrate(&folder, &["study.toml"]);
    assert_eq!(status, Some(0), "{err}");
    let found = json(&folder, "results/calibration.json");
    assert_eq!((&found["evaluations"], &found["method"]), (&15.into(), &"de/rand/1/bin".into()));
    // A script that fails with all values.
    folder.edit("pad.tcl", "fix 1 1", "fix 1 1\nnode 3 0.0");
    let (status, err) = calibrate(&folder, &["study.toml"]);
    assert!(status == Some(1) && err.contains("no values have an answer"), "{err}");
}

#[test]
fn several_studies_are_compared_in_one_table() {
    let folder = StudyFolder::new();
    folder.edit("study.toml", "[[run]]", "[calibration]\nevaluations = 60\n[[run]]");
    fs::write(
        folder.0.join("linear.toml"),
        fs::read_to_string(folder.study()).unwrap().replace(
            "[[parameter]]\nname  = \"alpha\"\nlower = 0.05\nupper = 0.4",
            "[[parameter]]\nname = \"alpha\"\nvalue = 0.9",
        ),
    )
    .unwrap();
    let (status, err) = calibrate(&folder, &["study.toml", "linear.toml", "--out", "both"]);
    assert_eq!(status, Some(0), "{err}");
    assert!(err.contains("objective") && err.contains("BIC"), "{err}");
    assert_eq!(fs::read_dir(folder.0.join("both")).unwrap().count(), 3);
    let table = fs::read_to_string(folder.0.join("both/comparison.txt")).unwrap();
    assert!(table.contains("by amplitude") && table.matches("growing").count() >= 8, "{table}");
}

#[test]
fn single_runs_have_larger_standard_errors_than_all_runs() {
    let folder = StudyFolder::new();
    folder.edit("study.toml", "\"holdout\"", "\"fit\"");
    let (status, err) = calibrate(&folder, &["study.toml", "--out", "out"]);
    assert_eq!(status, Some(0), "{err}");
    let sure = &json(&folder, "out/calibration.json")["uncertainty"];
    let alone = sure["alone"].as_array().unwrap();
    assert_eq!(alone.len(), 2);
    for (i, all) in sure["intervals"].as_array().unwrap().iter().enumerate() {
        let all = all["relative"].as_f64().unwrap();
        assert!(alone.iter().all(|a| a["relative"][i].as_f64().unwrap() > 0.9 * all), "{sure}");
    }
}

/// `hysteron check` of a study does all checks of a calibration.
#[test]
fn check_of_a_study_reports_errors_and_writes_nothing() {
    let folder = StudyFolder::new();
    let check = || {
        let mut command = Command::new(env!("CARGO_BIN_EXE_hysteron"));
        let output = command.args(["check", "study.toml"]).current_dir(&folder.0).output().unwrap();
        let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
        (output.status.code(), text(&output.stdout) + &text(&output.stderr))
    };
    let files = || fs::read_dir(&folder.0).unwrap().count();
    let before = files();
    let (status, err) = check();
    assert_eq!(status, Some(0), "{err}");
    assert!(err.contains("3 of 3 parameters to be found") && err.contains("3 of 499 samples of force"), "{err}");
    assert!(err.contains("with the script's own values"), "{err}");
    assert_eq!(files(), before);
    folder.edit("study.toml", "force.out", "forse.out");
    let (status, err) = check();
    assert!(status == Some(2) && err.contains("forse.out has no rows"), "{err}");
}

/// The plan is told before the search, the result stands on standard output, and what is replaced is named.
#[test]
fn plan_result_and_replaced_results() {
    let folder = StudyFolder::new();
    folder.edit("study.toml", "[[run]]", "[calibration]\nevaluations = 40\n[[run]]");
    let (status, out, err) = streams(&folder, &["."]);
    assert_eq!(status, Some(0), "{err}");
    assert!(err.contains("1 run fitted, 1 held out; 3 free: k0, Qd, alpha; cma-es; results go to results"), "{err}");
    assert!(out.contains("rubber pad, cyclic shear: objective") && !err.contains("objective"), "{out}{err}");
    // The same study again: no word. Another one: a note.
    let (_, _, err) = streams(&folder, &["study.toml"]);
    assert!(!err.contains("replaced"), "{err}");
    folder.edit("study.toml", "rubber pad, cyclic shear", "another pad");
    let (_, _, err) = streams(&folder, &["study.toml"]);
    assert!(err.contains("results holds the result of another study \"rubber pad, cyclic shear\""), "{err}");
    // The result for other programs.
    let (_, out, _) = streams(&folder, &["study.toml", "--json"]);
    let found: serde_json::Value = serde_json::from_str(&out).unwrap();
    assert_eq!(found, json(&folder, "results/calibration.json"));
    let (_, out, _) = streams(&folder, &["study.toml", "study.toml", "--json"]);
    let found: serde_json::Value = serde_json::from_str(&out).unwrap();
    assert_eq!(found.as_array().unwrap().len(), 2);
    let folders: Vec<bool> = ["", "-2"]
        .iter()
        .map(|n| {
            folder
                .0
                .join(format!("results/{}{n}/calibration.json", folder.0.file_name().unwrap().to_str().unwrap()))
                .exists()
        })
        .collect();
    assert_eq!(folders, [true, true], "each has a folder of its own");
}

/// A complete model is judged sound, and its search says that it has converged.
#[test]
fn complete_model_is_judged_sound() {
    let folder = StudyFolder::new();
    let (status, out, err) = streams(&folder, &["study.toml", "--out", "out"]);
    assert_eq!(status, Some(0), "{err}");
    assert!(out.contains("the residual looks like noise") && out.contains("(converged)"), "{out}");
    let found = json(&folder, "out/calibration.json");
    assert_eq!((&found["judgement"]["explained"], &found["judgement"]["widening"]), (&true.into(), &1.0.into()));
    assert_eq!(found["stopped_because"], "converged");
    assert!(found["evaluations"].as_u64().unwrap() < 700, "{}", found["evaluations"]);
    assert!(found["uncertainty"]["intervals"][0].get("from_noise").is_none());
}

/// The number is printed within which a model explains its recordings.
#[test]
fn a_sound_model_is_sound_within_the_noise_of_its_recordings() {
    let folder = StudyFolder::new();
    let (status, out, err) = streams(&folder, &["study.toml", "--out", "out"]);
    assert_eq!(status, Some(0), "{err}");
    assert!(out.contains("nothing speaks against the model within an NMSE of 0.00012"), "{out}");
    let noise = json(&folder, "out/calibration.json")["judgement"]["noise"].clone();
    let ratio = noise["nmse"].as_f64().unwrap() / noise["noise"].as_f64().unwrap();
    assert!((0.5..2.0).contains(&ratio), "{noise}");
}

/// A parameter at a bound, and held-out runs that are worse: neither model is said to be sound.
#[test]
fn poor_fits_are_not_judged_sound() {
    let folder = StudyFolder::new();
    let study = fs::read_to_string(folder.0.join("study.toml")).unwrap();
    fs::write(folder.0.join("narrow.toml"), study.replacen("upper = 5.0", "upper = 2.3", 1)).unwrap();
    let (status, out, err) = streams(&folder, &["narrow.toml", "--out", "narrow"]);
    assert_eq!(status, Some(0), "{err}");
    assert!(out.contains("k0 is at a bound of its range: a better fit may lie beyond"), "{out}");
    assert!(!out.contains("nothing speaks against"), "{out}");
    let found = json(&folder, "narrow/calibration.json");
    assert_eq!(found["judgement"]["at_bounds"], serde_json::json!(["k0"]));
    assert_eq!(found["judgement"]["explained"], false);

    let text = fs::read_to_string(folder.0.join("random.csv")).unwrap();
    let larger = text.lines().map(|line| {
        let mut cells: Vec<String> = line.split(',').map(str::to_owned).collect();
        if let Ok(force) = cells[1].parse::<f64>() {
            cells[1] = (1.4 * force).to_string();
        }
        cells.join(",")
    });
    let larger: Vec<String> = larger.collect();
    fs::write(folder.0.join("random.csv"), larger.join("\n") + "\n").unwrap();
    let (status, out, err) = streams(&folder, &["study.toml", "--out", "worse"]);
    assert_eq!(status, Some(0), "{err}");
    assert!(out.contains("held-out runs are predicted worse") && !out.contains("nothing speaks against"), "{out}");
    assert_eq!(json(&folder, "worse/calibration.json")["judgement"]["explained"], false);
}

/// A force that the model lacks: it is said, and the intervals reach the truth.
#[test]
fn missing_physics_widens_the_intervals() {
    let folder = StudyFolder::new();
    for name in ["growing", "random"] {
        let text = fs::read_to_string(folder.0.join(format!("{name}.csv"))).unwrap();
        let mut before: Option<(f64, f64)> = None;
        // Columns: time, force, displacement, temperature. A missing force stays missing.
        let damped = text.lines().map(|line| {
            let cells: Vec<&str> = line.split(',').collect();
            let (Ok(t), Ok(u)) = (cells[0].parse::<f64>(), cells[2].parse::<f64>()) else { return line.to_owned() };
            let speed = before.map_or(0.0, |(t0, u0)| (u - u0) / (t - t0));
            before = Some((t, u));
            let force = cells[1].parse::<f64>().map_or(String::new(), |f| (f + 0.06 * speed).to_string());
            format!("{t},{force},{u},{}", cells[3])
        });
        let damped: Vec<String> = damped.collect();
        fs::write(folder.0.join(format!("{name}.csv")), damped.join("\n") + "\n").unwrap();
    }
    let (status, out, err) = streams(&folder, &["study.toml", "--out", "out"]);
    assert_eq!(status, Some(0), "{err}");
    assert!(out.contains("the residual is no noise") && out.contains("hysteron diagnose"), "{out}");
    let found = json(&folder, "out/calibration.json");
    assert_eq!(found["judgement"]["explained"], false);
    for (interval, truth) in found["uncertainty"]["intervals"].as_array().unwrap().iter().zip([2.6, 17.0, 0.21]) {
        let end = |v: &serde_json::Value| v.as_f64().unwrap();
        let (narrow, wide) = (&interval["from_noise"], [end(&interval["lower"]), end(&interval["upper"])]);
        assert!(wide[0] < end(&narrow[0]) && wide[1] > end(&narrow[1]), "{interval}");
        assert!((wide[0]..=wide[1]).contains(&truth), "{interval}");
    }
}

/// The example of the library does what `hysteron calibrate` does.
#[test]
fn the_example_calibrates_a_study() {
    let folder = StudyFolder::new();
    let result = super::calibrate_study::calibrated(&folder.0.join("study.toml")).unwrap();
    let intervals = &result.uncertainty.as_ref().unwrap().intervals;
    for ((name, truth), (value, interval)) in
        [("k0", 2.6), ("Qd", 17.0), ("alpha", 0.21)].iter().zip(result.values.iter().zip(intervals))
    {
        assert!(interval.name == *name && interval.lower < *value && *value < interval.upper, "{interval:?}");
        assert!((value - truth).abs() < 0.05 * truth, "{name} = {value}");
    }
}
