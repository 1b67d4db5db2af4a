//! Batches: parts of a plan, in any order and on any number of threads, make the table of the whole plan.

use super::Place;
use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::Duration;

const PLAN: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tcl-like-inputs/batch_study/plan.toml");

fn table(place: &Place, out: &str) -> String {
    fs::read_to_string(place.0.join(out).join("results.csv")).unwrap()
}

/// Content of all files of the cases.
fn files(place: &Place, out: &str) -> Vec<(String, Vec<u8>)> {
    let mut all = vec![];
    for case in fs::read_dir(place.0.join(out).join("cases")).unwrap() {
        let case = case.unwrap().path();
        for file in fs::read_dir(&case).unwrap() {
            let path = file.unwrap().path();
            let name = path.strip_prefix(place.0.join(out)).unwrap().display().to_string();
            all.push((name, fs::read(&path).unwrap()));
        }
    }
    all.sort();
    all
}

#[test]
fn parts_make_the_whole() {
    let place = Place::new();
    let run = |words: &[&str]| place.run(&[&["batch", PLAN], words].concat());
    assert_eq!(run(&["--out", "one", "--threads", "1"]).0, Some(0));
    assert_eq!(run(&["--out", "two", "--threads", "2"]).0, Some(0));
    assert_eq!(table(&place, "one").lines().count(), 1 + 12);
    assert_eq!(files(&place, "one"), files(&place, "two"));
    for part in ["2/3", "3/3"] {
        assert_eq!(run(&["--out", "parts", "--shard", part]).0, Some(0));
    }
    let (status, _, said) = run(&["--out", "parts", "--merge"]);
    assert!(status != Some(0) && said.contains("4 of 12 cases are not complete"), "{said}");
    assert!(!place.0.join("parts/results.csv").exists());
    assert_eq!(run(&["--out", "parts", "--shard", "1/3"]).0, Some(0));
    assert_eq!(run(&["--out", "parts", "--merge"]).0, Some(0));
    assert_eq!(table(&place, "one"), table(&place, "parts"));
    assert_eq!(files(&place, "one"), files(&place, "parts"));
}

/// A job of a Slurm array takes its part from the environment.
#[test]
fn an_array_job_knows_its_part() {
    let place = Place::new();
    for task in ["1", "2"] {
        let mut command = Command::new(env!("CARGO_BIN_EXE_hysteron"));
        command.args(["batch", PLAN, "--out", "out"]).current_dir(&place.0).stderr(Stdio::null());
        let array = [("SLURM_ARRAY_TASK_ID", task), ("SLURM_ARRAY_TASK_MIN", "1"), ("SLURM_ARRAY_TASK_COUNT", "2")];
        assert!(command.envs(array).status().unwrap().success());
        assert_eq!(fs::read_dir(place.0.join("out/cases")).unwrap().count(), 6 * task.parse::<usize>().unwrap());
    }
    assert_eq!(place.run(&["batch", PLAN, "--out", "out", "--merge"]).0, Some(0));
}

/// Model whose cases take some hundredths of a second, and that reads a file under a name that it works out.
const SLOW: &str = "pset k 1.0\nset name [join {extra txt} .]\nset f [open [file join [file dirname [info script]] $name]]\n\
    set shift [gets $f]\nclose $f\nset sum $shift\nfor {set i 0} {$i < 20000} {incr i} {set sum [expr {$sum + sin($k*$i)}]}\n";

fn slow(place: &Place) {
    place.write("model.tcl", SLOW);
    place.write("extra.txt", "1.0\n");
    place.write(
        "plan.toml",
        "scripts = [\"model.tcl\"]\nresults = [\"sum\"]\n[grid]\nk = { from = 1.0, to = 2.0, points = 40 }\n",
    );
}

#[test]
fn a_killed_batch_goes_on() {
    let place = Place::new();
    slow(&place);
    assert_eq!(place.run(&["batch", "plan.toml", "--out", "whole"]).0, Some(0));
    let mut command = Command::new(env!("CARGO_BIN_EXE_hysteron"));
    command
        .args(["batch", "plan.toml", "--out", "killed", "--threads", "1"])
        .current_dir(&place.0)
        .stderr(Stdio::null());
    let mut child = command.spawn().unwrap();
    let cases = place.0.join("killed/cases");
    let complete = |path: &Path| path.extension().is_none();
    let count = || fs::read_dir(&cases).map_or(0, |d| d.filter(|e| complete(&e.as_ref().unwrap().path())).count());
    while count() < 3 {
        std::thread::sleep(Duration::from_millis(1));
    }
    child.kill().unwrap();
    child.wait().unwrap();
    let before = count();
    assert!(before < 40, "the batch was over before it was killed");
    let made = |path: &Path| fs::metadata(path.join("row.csv")).unwrap().modified().unwrap();
    let kept: Vec<_> = fs::read_dir(&cases).unwrap().map(|e| e.unwrap().path()).filter(|p| complete(p)).collect();
    let times: Vec<_> = kept.iter().map(|p| made(p)).collect();
    assert_eq!(place.run(&["batch", "plan.toml", "--out", "killed", "--resume"]).0, Some(0));
    assert_eq!(kept.iter().map(|p| made(p)).collect::<Vec<_>>(), times, "complete cases are kept");
    assert_eq!(table(&place, "whole"), table(&place, "killed"));
}

/// Cases are run again when a file changes that they read under a name that no plan knows.
#[test]
fn a_changed_input_is_noticed() {
    let place = Place::new();
    slow(&place);
    assert_eq!(place.run(&["batch", "plan.toml", "--out", "a"]).0, Some(0));
    place.write("extra.txt", "2.0\n");
    assert_eq!(place.run(&["batch", "plan.toml", "--out", "a", "--resume"]).0, Some(0));
    assert_eq!(place.run(&["batch", "plan.toml", "--out", "b"]).0, Some(0));
    assert_eq!(table(&place, "a"), table(&place, "b"));
}

#[test]
fn values_come_from_lists_tables_and_samples() {
    let place = Place::new();
    place.write("model.tcl", "pset a 1.0\npset b 1.0\nset sum [expr {$a + 10.0*$b}]\n");
    place.write("b.csv", "b\n1\n2\n");
    let head = "scripts = [\"model.tcl\"]\nresults = [\"sum\"]\n";
    place.write(
        "lists.toml",
        format!("{head}table = \"b.csv\"\n[[case]]\na = 1.0\n[[case]]\na = 2.0\n[[case]]\na = 1.0\n"),
    );
    let (status, _, said) = place.run(&["batch", "lists.toml", "--out", "lists"]);
    assert!(status == Some(0) && said.contains("2 cases have the inputs of another one"), "{said}");
    assert!(said.contains(" cases in ") && said.contains(" a second on "), "{said}");
    let rows = table(&place, "lists");
    let sums: Vec<&str> = rows.lines().skip(1).map(|r| r.split(',').nth(6).unwrap()).collect();
    assert_eq!(sums, ["11.0", "21.0", "12.0", "22.0"]);
    let sample = "[latin_hypercube]\npoints = 5\nseed = 3\nparameters = { a = [0.0, 1.0], b = [2.0, 3.0] }\n";
    place.write("sample.toml", format!("{head}{sample}"));
    assert_eq!(place.run(&["batch", "sample.toml", "--out", "sample"]).0, Some(0));
    assert_eq!(table(&place, "sample").lines().count(), 6);
}

#[test]
fn mistakes_are_said() {
    let place = Place::new();
    place.write("model.tcl", "pset k 1.0\nset sum [expr {1.0/$k}]\n");
    let head = "scripts = [\"model.tcl\"]\nresults = [\"sum\"]\n";
    for (plan, said) in [
        (format!("{head}grids = 1\n"), "grids"),
        (format!("{head}[grid]\nk = []\n"), "the parameter k has no values"),
        (format!("{head}[grid]\nsum = [1.0]\n"), "two columns sum"),
        ("scripts = [\"other.tcl\"]\nresults = []\n".to_owned(), "other.tcl"),
        (format!("{head}table = \"k.csv\"\n"), "line 3, column k: expected a number, not \"x\""),
    ] {
        place.write("k.csv", "k\n1\nx\n");
        place.write("plan.toml", &plan);
        let (status, _, error) = place.run(&["batch", "plan.toml", "--out", "out"]);
        assert!(status == Some(2) && error.contains(said), "{status:?} {error}");
        assert!(!place.0.join("out/results.csv").exists());
    }
    // Cases that fail are rows with a message, and no numbers.
    for (grid, status, message) in [
        ("k = [0.0]", "incomplete", "the script has no finite result sum"),
        ("q = [1.0]", "rejected", "the script has no \"\"pset q\"\""),
    ] {
        place.write("plan.toml", format!("{head}[grid]\n{grid}\n"));
        assert_eq!(place.run(&["batch", "plan.toml", "--out", "out"]).0, Some(1));
        let rows = table(&place, "out");
        assert!(rows.contains(&format!(",{status},")) && rows.contains(message), "{rows}");
    }
}

#[test]
fn job_files_name_every_part() {
    let place = Place::new();
    for (scheduler, file, part) in [
        ("slurm", "batch.slurm", "--shard $SLURM_ARRAY_TASK_ID/4"),
        ("sge", "batch.sge", "--shard $SGE_TASK_ID/4"),
        ("pbs", "batch.pbs", "--shard $PBS_ARRAY_INDEX/4"),
        ("pylauncher", "commandlines", "--shard 4/4"),
    ] {
        assert_eq!(place.run(&["batch", PLAN, "--out", "my jobs", "--emit", scheduler, "--jobs", "4"]).0, Some(0));
        let text = fs::read_to_string(place.0.join("my jobs").join(file)).unwrap();
        assert!(text.contains(part) && text.contains("--out 'my jobs'"), "{text}");
    }
}

/// A check reads the inputs of a plan and goes through its scripts, without a run.
#[test]
fn a_plan_is_checked() {
    let place = Place::new();
    let (status, out, err) = place.run(&["check", PLAN]);
    assert!(
        status == Some(0) && out.contains("12 cases of 1 script, the first of each without a mistake"),
        "{out}{err}"
    );
    assert_eq!(fs::read_dir(&place.0).unwrap().count(), 0);
    place.write("plan.toml", "scripts = [\"m.tcl\"]\nresults = [\"x\"]\n[grid]\nk = [1.0, 2.0]\n");
    let check = |script: &str, options: &[&str]| {
        place.write("m.tcl", script);
        place.run(&[&["check", "plan.toml"], options].concat())
    };
    let (status, out, err) = check("set x 1\n", &[]);
    assert!(
        status == Some(2) && err.contains("\"./m.tcl\": the script has no \"pset k\"") && out.is_empty(),
        "{out}{err}"
    );
    let (status, out, _) = check("pset k 3\nmodel basic -ndm 2 -ndf 3\nnod 1 0 $k\nset x 1\n", &["--json"]);
    let found: serde_json::Value = serde_json::from_str(&out).unwrap();
    assert!(status == Some(2) && found["cases"] == 2 && found["messages"][0]["line"] == 3, "{out}");
    let (status, _, err) = check("pset k 3\nset x $k\n", &[]);
    assert!(status == Some(0) && err.is_empty(), "{err}");
    place.write("plan.toml", "scripts = [\"none.tcl\"]\nresults = [\"x\"]\n");
    let (status, _, err) = place.run(&["check", "plan.toml"]);
    assert!(status == Some(2) && err.contains("cannot read"), "{err}");
}
