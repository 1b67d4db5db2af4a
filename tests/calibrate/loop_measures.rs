//! Published measures of loops are observed: stiffness, damping and energy of cycles in place of time histories.

use hysteron::diagnostic::SourceMap;
use hysteron::study::Study;
use std::f64::consts::TAU;
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Spring 2 beside a slider of 3 that yields at 0.2, in two triangular cycles of a second each at 1, 2 and 4.
const SCRIPT: &str = "\
wipe
model basic -ndm 1 -ndf 1
node 1 0.0
node 2 0.0
fix 1 1
pset k 1.0
pset Fy 2.0
uniaxialMaterial Elastic 1 $k
uniaxialMaterial ElasticPP 2 [expr {$Fy/0.2}] 0.2
uniaxialMaterial Parallel 3 1 2
element zeroLength 1 1 2 -mat 3 -dir 1
set path 0.0
foreach a {1.0 1.0 2.0 2.0 4.0 4.0} {
    for {set i 1} {$i <= 200} {incr i} {
        set x [expr {$i/50.0}]
        lappend path [expr {$a*($x <= 1.0 ? $x : $x <= 3.0 ? 2.0 - $x : $x - 4.0)}]
    }
}
timeSeries Path 1 -dt 0.005 -values $path -useLast
pattern Plain 1 1 { sp 2 1 1.0 }
recorder Element -file force.out -time -ele 1 force
recorder Node -file disp.out -time -node 2 -dof 1 disp
constraints Transformation
numberer Plain
system ProfileSPD
test NormDispIncr 1.0e-10 20
algorithm Newton
integrator LoadControl 0.005
analysis Static
if {[analyze 1200] != 0} {error stopped}
";

const STUDY: &str = r#"model = "model.tcl"
[[parameter]]
name = "k"
lower = 0.5
upper = 5.0
[[parameter]]
name = "Fy"
lower = 0.5
upper = 6.0
[calibration]
method = "least-squares"
population = 4
[[run]]
name = "table"
recording = "table.csv"
observe = [
    { channel = "K", output = "force.out", column = 2, measure = "secant_stiffness", deformation = "disp.out", deformation_column = 1 },
    { channel = "h", output = "force.out", column = 2, measure = "damping", deformation = "disp.out", deformation_column = 1 },
    { channel = "E", output = "force.out", column = 2, measure = "energy", deformation = "disp.out", deformation_column = 1 },
]
"#;

/// The study in a folder of its own. The table has the exact measures of the second cycles.
fn folder(name: &str, study: &str) -> PathBuf {
    let folder = std::env::temp_dir().join(format!("hysteron-loop-measures-{}-{name}", std::process::id()));
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    let mut table = String::from("time[s],K[kN/m],h[-],E[kNm]\n");
    for (t, a) in [(1.5, 1.0), (3.5, 2.0), (5.5, 4.0f64)] {
        let (stiffness, energy) = (2.0 + 3.0 / a, 4.0 * 3.0 * (a - 0.2));
        writeln!(table, "{t},{stiffness:e},{:e},{energy:e}", energy / (TAU * stiffness * a * a)).unwrap();
    }
    fs::write(folder.join("table.csv"), table).unwrap();
    fs::write(folder.join("model.tcl"), SCRIPT).unwrap();
    fs::write(folder.join("study.toml"), study).unwrap();
    folder
}

fn calibrate(folder: &Path) -> (bool, String) {
    let done = Command::new(env!("CARGO_BIN_EXE_hysteron"))
        .args(["calibrate", "study.toml", "--out", "fit"])
        .current_dir(folder)
        .output()
        .unwrap();
    (done.status.success(), String::from_utf8_lossy(&done.stderr).into_owned())
}

#[test]
fn a_law_is_fitted_to_a_table_of_loops() {
    let folder = folder("fit", STUDY);
    let (success, err) = calibrate(&folder);
    assert!(success, "{err}");
    let found: serde_json::Value =
        serde_json::from_str(&fs::read_to_string(folder.join("fit/calibration.json")).unwrap()).unwrap();
    for (name, exact) in [("k", 2.0), ("Fy", 3.0)] {
        let value = found["parameters"][name].as_f64().unwrap();
        assert!((value / exact - 1.0).abs() < 2e-3, "{name}: {value}");
    }
    assert!(found["objective"].as_f64().unwrap() < 1e-4, "{found}");
    fs::remove_dir_all(&folder).unwrap();
}

/// A published test with one measured cycle is a run of its own: the error of a measure is relative.
#[test]
fn one_cycle_a_run_is_enough() {
    let one = STUDY.split("[[run]]").nth(1).unwrap();
    let run = |name: &str| format!("[[run]]{one}").replace("\"table", &format!("\"{name}"));
    let study = STUDY.replace(&format!("[[run]]{one}"), &(run("small") + &run("large")));
    let folder = folder("single", &study);
    let table = fs::read_to_string(folder.join("table.csv")).unwrap();
    let lines: Vec<&str> = table.lines().collect();
    fs::write(folder.join("small.csv"), format!("{}\n{}\n", lines[0], lines[1])).unwrap();
    fs::write(folder.join("large.csv"), format!("{}\n{}\n", lines[0], lines[3])).unwrap();
    let (success, err) = calibrate(&folder);
    assert!(success && !err.contains("channel-doubt"), "{err}");
    let found: serde_json::Value =
        serde_json::from_str(&fs::read_to_string(folder.join("fit/calibration.json")).unwrap()).unwrap();
    for (name, exact) in [("k", 2.0), ("Fy", 3.0)] {
        let value = found["parameters"][name].as_f64().unwrap();
        assert!((value / exact - 1.0).abs() < 2e-3, "{name}: {value}");
    }
    fs::remove_dir_all(&folder).unwrap();
}

/// Loops that soften with the amplitude in stiffness and energy alike: physics is weighed, and no instrument. Two cycles
/// of an amplitude have equal measures, which is no saturation.
#[test]
fn a_table_of_loops_is_diagnosed_without_faults_of_instruments() {
    let folder = folder("diagnosed", STUDY);
    let mut table = String::from("time[s],K[kN/m],h[-],E[kNm]\n");
    for (t, a) in [(0.5, 1.0), (1.5, 1.0), (2.5, 2.0), (3.5, 2.0), (4.5, 4.0), (5.5, 4.0f64)] {
        let softer = 1.0 / (1.0 + 0.15 * a);
        let (stiffness, energy) = ((2.0 + 3.0 / a) * softer, 12.0 * (a - 0.2) * softer);
        writeln!(table, "{t},{stiffness:e},{:e},{energy:e}", energy / (TAU * stiffness * a * a)).unwrap();
    }
    fs::write(folder.join("table.csv"), table).unwrap();
    let done = Command::new(env!("CARGO_BIN_EXE_hysteron"))
        .args(["diagnose", "study.toml", "--out", "found", "--json"])
        .current_dir(&folder)
        .output()
        .unwrap();
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    let found: serde_json::Value = serde_json::from_slice(&done.stdout).unwrap();
    let verdict = &found["verdict"];
    let named = |v: &serde_json::Value| v["cause"].as_str().unwrap().starts_with("sensor");
    assert!(!named(verdict) && !verdict["also_possible"].as_array().unwrap().iter().any(named), "{verdict}");
    // Rows of a table are no samples: no cause is sure.
    let is_cause = !["none", "unknown"].contains(&verdict["cause"].as_str().unwrap());
    assert!(!is_cause || verdict["confidence"].as_f64().unwrap() <= 0.5, "{verdict}");
    fs::remove_dir_all(&folder).unwrap();
}

#[test]
fn a_time_without_a_cycle_is_an_error() {
    let folder = folder("outside", STUDY);
    fs::write(folder.join("table.csv"), "time[s],K,h,E\n0.0,5,0.5,9\n1.5,4,0.4,9.6\n").unwrap();
    let (success, err) = calibrate(&folder);
    assert!(!success && err.contains("no complete cycle of disp.out at 0 s"), "{err}");
    fs::remove_dir_all(&folder).unwrap();
}

#[test]
fn a_measure_has_its_deformation_and_a_deformation_its_measure() {
    for (old, new, said) in [
        ("measure = \"damping\"", "measure = \"dampning\"", "unknown measure \"dampning\""),
        ("measure = \"damping\", ", "", "a deformation without a measure"),
        (", deformation_column = 1 },\n]", " },\n]", "energy is a measure of loops over a deformation"),
        ("deformation_column = 1", "deformation_column = -1", "the column is -1"),
    ] {
        assert!(STUDY.contains(old), "{old}");
        let folder = folder("wrong", &STUDY.replacen(old, new, 1));
        let mut sources = SourceMap::default();
        let d = Study::load(&folder.join("study.toml"), &mut sources).unwrap_err();
        assert!(d.message.contains(said) && d.span.is_some(), "{}", d.message);
        fs::remove_dir_all(&folder).unwrap();
    }
}
