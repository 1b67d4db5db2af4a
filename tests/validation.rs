//! Cases with the results of the real OpenSees, and every annotated input.

#![allow(clippy::unwrap_used, unreachable_pub)]

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

/// A folder of its own for a run.
fn workplace(name: &str) -> PathBuf {
    let dir = std::env::temp_dir().join(format!("hysteron-validation-{}-{name}", std::process::id()));
    let _ = fs::remove_dir_all(&dir);
    fs::create_dir_all(&dir).unwrap();
    dir
}

fn copy(from: &Path, to: &Path) {
    for entry in fs::read_dir(from).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap();
        if name == "expected.tar.gz" {
            continue;
        }
        if path.is_dir() {
            fs::create_dir_all(to.join(name)).unwrap();
            copy(&path, &to.join(name));
        } else {
            fs::copy(&path, to.join(name)).unwrap();
        }
    }
}

fn table(text: &str) -> Result<Vec<Vec<f64>>, String> {
    let row = |l: &str| l.split_whitespace().map(|w| w.parse().map_err(|_| format!("{w} is not a number"))).collect();
    text.lines().filter(|l| !l.trim().is_empty()).map(row).collect()
}

/// Compare column by column; see `validation/opensees/README.md`.
fn compare(expected: &str, got: &str, spec: &serde_json::Value) -> Result<(), String> {
    let (exp, got) = (table(expected)?, table(got)?);
    if exp.len() != got.len() {
        return Err(format!("{} rows, expected {}", got.len(), exp.len()));
    }
    let number = |key: &str, default: f64| spec[key].as_f64().unwrap_or(default);
    let (rtol, atol) = (number("rtol", 1e-6), number("atol_fraction_of_peak", 1e-6));
    let noise = number("noise_fraction_of_file", 1e-10);
    let growing = exp.len() > 2 && exp[0].len() > 1 && exp.windows(2).all(|w| w[1][0] > w[0][0]);
    let skip = usize::from(growing);
    let peak_of =
        |values: &mut dyn Iterator<Item = f64>| values.filter(|x| x.is_finite()).fold(0.0f64, |m, x| m.max(x.abs()));
    let file_peak = peak_of(&mut exp.iter().flat_map(|r| r.iter().skip(skip).copied()));
    for (i, (e, g)) in exp.iter().zip(&got).enumerate() {
        if e.len() != g.len() {
            return Err(format!("row {} has {} columns, expected {}", i + 1, g.len(), e.len()));
        }
        for (c, (a, b)) in e.iter().zip(g).enumerate() {
            let peak = peak_of(&mut exp.iter().filter_map(|r| r.get(c).copied()));
            let floor = if growing && c == 0 { 0.0 } else { noise * file_peak };
            let same = a == b || (a.is_nan() && b.is_nan());
            let near = (a - b).abs() <= atol * peak + floor + rtol * a.abs();
            if !same && !near {
                return Err(format!("row {} column {}: got {b}, expected {a} (peak {peak})", i + 1, c + 1));
            }
        }
    }
    Ok(())
}

fn lines_agree(expected: &str, got: &str) -> Result<(), String> {
    let (e, g): (Vec<&str>, Vec<&str>) = (expected.lines().collect(), got.lines().collect());
    if let Some(i) = (0..e.len().min(g.len())).find(|&i| e[i].trim_end() != g[i].trim_end()) {
        return Err(format!("line {}: got {:?}, expected {:?}", i + 1, g[i], e[i]));
    }
    if e.len() == g.len() { Ok(()) } else { Err(format!("{} lines, expected {}", g.len(), e.len())) }
}

/// Unpack the outputs of OpenSees that stand beside a case; returns their folder.
fn expected_files(case: &Path, work: &Path) -> PathBuf {
    let archive = case.join("expected.tar.gz");
    let done = Command::new("tar").arg("-xzf").arg(&archive).arg("-C").arg(work).status().unwrap();
    assert!(done.success(), "tar cannot unpack {}", archive.display());
    work.join("expected")
}

fn run_case(folder: &Path, case: &serde_json::Value) -> Result<(), String> {
    let name = folder.file_name().unwrap().to_str().unwrap();
    let work = workplace(name);
    let reference = workplace(&format!("{name}-reference"));
    let expected_folder = expected_files(folder, &reference);
    copy(folder, &work);
    let output = Command::new(env!("CARGO_BIN_EXE_hysteron"))
        .args(["run", "--compat", "opensees", "model.tcl"])
        .current_dir(&work)
        .output()
        .unwrap();
    if !output.status.success() {
        return Err(format!("{}\n{}", output.status, String::from_utf8_lossy(&output.stderr)));
    }
    let files = case["files"].as_array().unwrap();
    assert!(!files.is_empty(), "{name} names no files");
    for spec in files {
        let file = spec["name"].as_str().unwrap();
        let expected = fs::read_to_string(expected_folder.join(file)).unwrap();
        let got = fs::read_to_string(work.join(file)).map_err(|e| format!("{file}: {e}"))?;
        let agreed = match spec["mode"].as_str() {
            Some("text") => lines_agree(&expected, &got),
            _ => compare(&expected, &got, spec),
        };
        agreed.map_err(|e| format!("{file}: {e}"))?;
    }
    fs::remove_dir_all(&work).unwrap();
    fs::remove_dir_all(&reference).unwrap();
    Ok(())
}

#[test]
fn opensees_cases() {
    let mut folders: Vec<PathBuf> = fs::read_dir(root().join("validation/opensees"))
        .unwrap()
        .map(|e| e.unwrap().path())
        .filter(|p| p.is_dir())
        .collect();
    folders.sort();
    let text = fs::read_to_string(root().join("validation/opensees/cases.json")).unwrap();
    let cases: BTreeMap<String, serde_json::Value> = serde_json::from_str(&text).unwrap();
    let names = || folders.iter().map(|f| f.file_name().unwrap().to_str().unwrap());
    assert!(names().eq(cases.keys()), "cases.json and the folders of cases differ");
    let wrong: Vec<String> = folders
        .iter()
        .zip(&cases)
        .filter_map(|(f, (name, case))| run_case(f, case).err().map(|e| format!("{name}: {e}")))
        .collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// The comparison itself can fail.
#[test]
fn comparison_sees_differences() {
    let spec = serde_json::json!({ "rtol": 1e-6, "atol_fraction_of_peak": 1e-6 });
    let exp = "0 1.0 5\n1 2.0 6\n2 -3.0 7\n";
    assert!(compare(exp, exp, &spec).is_ok());
    for got in [
        "0 1.0 5\n1 2.0 6\n",
        "0 1.0 5\n1 2.0 6\n2 -3.0\n",
        "0 1.0 5\n1 2.00001 6\n2 -3.0 7\n",
        "0 1.0 5\n1 nan 6\n2 -3.0 7\n",
        "0 1.0 5\n1 x 6\n2 -3.0 7\n",
    ] {
        assert!(compare(exp, got, &spec).is_err(), "{got}");
    }
    assert!(
        lines_agree("a\nb", "a\nc").is_err() && lines_agree("a\nb", "a").is_err() && lines_agree("a ", "a").is_ok()
    );
}

fn scripts(dir: &str) -> Vec<PathBuf> {
    let mut all: Vec<PathBuf> = fs::read_dir(root().join(dir))
        .map(|d| d.map(|e| e.unwrap().path()).filter(|p| p.extension().is_some_and(|e| e == "tcl")).collect())
        .unwrap_or_default();
    all.sort();
    all
}

/// Every annotated input runs to its end without a warning, and a check finds nothing wrong with it.
#[test]
fn annotated_inputs() {
    let inputs = scripts("tcl-like-inputs");
    assert!(!inputs.is_empty());
    for input in inputs {
        let name = input.file_stem().unwrap().to_str().unwrap().to_owned();
        let work = workplace(&format!("input-{name}"));
        for sub in ["check", "run"] {
            let output = Command::new(env!("CARGO_BIN_EXE_hysteron"))
                .args([sub, "--strict"])
                .arg(&input)
                .current_dir(&work)
                .output()
                .unwrap();
            let err = String::from_utf8_lossy(&output.stderr);
            // A check ends with a note where the script reads results.
            let quiet = err.lines().all(|l| sub == "check" && l.starts_with("note: the check ends"));
            assert!(output.status.success() && quiet, "{sub} {name}: {}\n{err}", output.status);
            if sub == "run" {
                assert!(!output.stdout.is_empty(), "{name} says nothing");
            }
        }
        fs::remove_dir_all(&work).unwrap();
    }
}

/// The scripts of the thesis on high damping rubber: each ends with an error if one of its checks fails.
#[test]
fn thesis() {
    for script in scripts("validation/identification/thesis") {
        let name = script.file_stem().unwrap().to_str().unwrap().to_owned();
        let work = workplace(&format!("thesis-{name}"));
        let output = Command::new(env!("CARGO_BIN_EXE_hysteron"))
            .args(["run", "--strict"])
            .arg(&script)
            .current_dir(&work)
            .output()
            .unwrap();
        let err = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success() && !output.stdout.is_empty(), "{name}: {err}");
        fs::remove_dir_all(&work).unwrap();
    }
}

/// Files and tests that the table of the two papers names exist.
#[test]
fn tables_of_the_papers() {
    let folder = root().join("validation/identification");
    let table = fs::read_to_string(folder.join("README.md")).unwrap();
    let own = include_str!("validation.rs").to_owned();
    let tests: String = ["laws", "analysis", "cli", "calibrate", "diagnose"]
        .iter()
        .flat_map(|dir| fs::read_dir(root().join("tests").join(dir)).unwrap())
        .map(|file| fs::read_to_string(file.unwrap().path()).unwrap())
        .chain([own])
        .collect();
    let mut named = 0;
    for word in table.split('`').skip(1).step_by(2) {
        let is_test =
            word.matches('_').count() > 1 && word.chars().all(|c| c.is_ascii_lowercase() || "_0123456789".contains(c));
        if word.contains('/') && !word.contains('*') {
            assert!(root().join(word).exists() || folder.join(word).exists(), "no file {word}");
        } else if is_test {
            assert!(tests.contains(&format!("fn {word}(")), "no test {word}");
            named += 1;
        }
    }
    assert!(named > 4, "the table names {named} tests");
}

/// The identification of Flora, Calabrese and Cardone (2023) in small on the target of another bearing: Bouc-Wen is nearest, Kikuchi last.
#[test]
fn rr_frb_in_small() {
    const AMPLITUDES: [f64; 6] = [0.15, 0.20, 0.30, 0.40, 0.50, 0.60];
    const STEPS: usize = 300; // of three cycles at 0.5 Hz
    let work = workplace("rr-frb");
    copy(&root().join("validation/identification/rr_frb"), &work);
    fs::create_dir(work.join("models")).unwrap();
    copy(&root().join("models"), &work.join("models"));
    let hysteron = |words: &[&str], folder: &Path| {
        let done = Command::new(env!("CARGO_BIN_EXE_hysteron")).args(words).current_dir(folder).output().unwrap();
        assert!(done.status.success(), "{words:?}: {}", String::from_utf8_lossy(&done.stderr));
    };
    let path: Vec<f64> = std::iter::once(0.0)
        .chain(
            AMPLITUDES
                .iter()
                .flat_map(|a| (1..=STEPS).map(move |i| 0.2 * a * (std::f64::consts::PI * i as f64 * 0.02).sin())),
        )
        .collect();
    let motion: String = path.iter().map(|u| format!("{u:e}\n")).collect();
    fs::write(work.join("motion.dat"), &motion).unwrap();
    fs::write(work.join("drive.tcl"), "set motion motion.dat; set dt 0.02; set npts 1801; source twin.tcl").unwrap();
    hysteron(&["run", "drive.tcl"], &work);
    let forces = table(&fs::read_to_string(work.join("force.out")).unwrap()).unwrap();
    let rows = forces.iter().zip(&path[1..]).enumerate();
    let recording: String =
        rows.map(|(i, (row, u))| format!("{},{:e},{u:e}\n", (i + 1) as f64 * 0.02, row[7])).collect();
    let objective = |model: &str| {
        let folder = work.join(model);
        fs::write(folder.join("motion.dat"), &motion).unwrap();
        fs::write(folder.join("target.csv"), format!("time[s],force[N],disp[m]\n{recording}")).unwrap();
        let study = fs::read_to_string(folder.join("study.toml")).unwrap();
        let small = study.replace("population  = 50", "population = 8").replace("generations = 150", "generations = 5");
        assert!(small.contains("population = 8") && small.contains("generations = 5"), "{study}");
        fs::write(folder.join("study.toml"), small).unwrap();
        hysteron(&["calibrate", "study.toml", "--repeats", "1", "--out", "fit"], &folder);
        let found = fs::read_to_string(folder.join("fit/calibration.json")).unwrap();
        let found: serde_json::Value = serde_json::from_str(&found).unwrap();
        found["objective"].as_f64().unwrap()
    };
    let [bouc_wen, hdr, kikuchi] = ["bouc_wen", "hdr", "kikuchi"].map(objective);
    assert!(bouc_wen < hdr && hdr < kikuchi, "{bouc_wen} {hdr} {kikuchi}");
    fs::remove_dir_all(&work).unwrap();
}

/// The first command of the README writes the files that the README names.
#[test]
fn isolated_building_prints_its_peaks_and_draws_them() {
    let work = workplace("building");
    let output = Command::new(env!("CARGO_BIN_EXE_hysteron"))
        .arg("run")
        .arg(root().join("tcl-like-inputs/isolated_building.tcl"))
        .current_dir(&work)
        .output()
        .unwrap();
    let out = String::from_utf8_lossy(&output.stdout);
    for words in ["peak displacement of the corner bearing", "peak storey drifts in x", "peak base shear in y"] {
        assert!(out.contains(words), "{out}");
    }
    for picture in ["bearing_loops", "plan_orbit", "drift_profile"] {
        let svg = fs::read_to_string(work.join(format!("results/isolated_building/{picture}.svg"))).unwrap();
        assert!(svg.starts_with("<svg") && svg.contains("polyline"), "{picture}");
    }
    assert!(
        fs::read_dir(work.join("results/isolated_building"))
            .unwrap()
            .all(|e| { !e.unwrap().file_name().to_string_lossy().ends_with(".part") })
    );
    fs::remove_dir_all(&work).unwrap();
}
