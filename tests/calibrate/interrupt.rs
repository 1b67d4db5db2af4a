//! Tests of Ctrl-C on a terminal and `--resume`.

use super::StudyFolder;
use std::fs;
use std::io::{Read as _, Write as _};
use std::process::{Command, Stdio};

fn json(folder: &StudyFolder, path: &str) -> serde_json::Value {
    serde_json::from_str(&fs::read_to_string(folder.0.join(path)).unwrap()).unwrap()
}

/// Returns true if `script` of util-linux is there, which gives the program a terminal.
fn has_terminals() -> bool {
    let version = Command::new("script").arg("--version").output();
    version.is_ok_and(|o| String::from_utf8_lossy(&o.stdout).contains("util-linux"))
}

#[test]
fn interrupted_calibration_resumes_to_the_same_bits() {
    if !has_terminals() {
        return;
    }
    let folder = StudyFolder::new();
    // Many evaluations leave time for the interrupt.
    folder.edit("study.toml", "[[run]]", "[calibration]\nmethod = \"l-shade\"\nevaluations = 3000\n[[run]]");
    let program = env!("CARGO_BIN_EXE_hysteron");
    // A waiting shell such as dash would get the same Ctrl-C and end, so `exec` replaces it.
    let line = format!("exec '{program}' calibrate study.toml --out out");
    let mut child = Command::new("script")
        .args(["-qefc", &line, "/dev/null"])
        .current_dir(&folder.0)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    let mut keys = child.stdin.take().unwrap();
    let mut screen = child.stdout.take().unwrap();
    let mut seen = String::new();
    let mut buffer = [0u8; 4096];
    let mut pressed = false;
    while let Ok(n @ 1..) = screen.read(&mut buffer) {
        seen.push_str(&String::from_utf8_lossy(&buffer[..n]));
        if !pressed && seen.contains("generation 3") {
            keys.write_all(b"\x03").unwrap();
            keys.flush().unwrap();
            pressed = true;
        }
    }
    let status = child.wait().unwrap();
    assert!(pressed && status.code() == Some(130), "{status}: {seen}");
    for part in ["evaluations/s", "best", "spread", "left", "the best so far is kept"] {
        assert!(seen.contains(part), "{part}: {seen}");
    }
    let stopped = json(&folder, "out/calibration.json");
    assert_eq!(stopped["interrupted"], true);
    assert!(stopped["runs"][1]["nmse"].is_number(), "the best is judged all the same: {stopped}");
    assert!(stopped["evaluations"].as_u64().unwrap() < 3000, "{stopped}");
    assert!(folder.0.join("out/checkpoint.json").exists() && folder.0.join("out/fitted.tcl").exists());

    let finish = |words: &[&str]| {
        let mut command = Command::new(program);
        let output = command.args(["calibrate", "study.toml"]).args(words).current_dir(&folder.0).output().unwrap();
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    };
    finish(&["--out", "out", "--resume", "--threads", "1"]);
    finish(&["--out", "whole"]);
    let (resumed, whole) = (json(&folder, "out/calibration.json"), json(&folder, "whole/calibration.json"));
    for key in ["parameters", "objective", "evaluations", "repeats", "uncertainty"] {
        assert_eq!(resumed[key], whole[key], "{key}");
    }
    assert_eq!(resumed["interrupted"], false);
}
