//! Ctrl-C on a terminal keeps the best so far, and `--resume` goes on to the same bits.

use super::Place;
use std::fs;
use std::io::{Read as _, Write as _};
use std::process::{Command, Stdio};

fn json(place: &Place, path: &str) -> serde_json::Value {
    serde_json::from_str(&fs::read_to_string(place.0.join(path)).unwrap()).unwrap()
}

/// `script` of util-linux gives the program a terminal; where there is none, nothing is tested.
fn has_terminals() -> bool {
    let version = Command::new("script").arg("--version").output();
    version.is_ok_and(|o| String::from_utf8_lossy(&o.stdout).contains("util-linux"))
}

#[test]
fn an_interrupted_calibration_goes_on() {
    if !has_terminals() {
        return;
    }
    let place = Place::new();
    // Enough of it that there is time to interrupt.
    place.edit("study.toml", "[[run]]", "[calibration]\nmethod = \"l-shade\"\nevaluations = 3000\n[[run]]");
    let program = env!("CARGO_BIN_EXE_hysteron");
    // Replaces the shell: one that waits, as dash does, would die of the same Ctrl-C.
    let line = format!("exec '{program}' calibrate study.toml --out out");
    let mut child = Command::new("script")
        .args(["-qefc", &line, "/dev/null"])
        .current_dir(&place.0)
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
    assert!(pressed && status.success(), "{status}: {seen}");
    for part in ["evaluations/s", "best", "spread", "left", "the best so far is kept"] {
        assert!(seen.contains(part), "{part}: {seen}");
    }
    let stopped = json(&place, "out/calibration.json");
    assert_eq!(stopped["interrupted"], true);
    assert!(stopped["runs"][1]["nmse"].is_number(), "the best is judged all the same: {stopped}");
    assert!(stopped["evaluations"].as_u64().unwrap() < 3000, "{stopped}");
    assert!(place.0.join("out/checkpoint.json").exists() && place.0.join("out/fitted.tcl").exists());

    let finish = |words: &[&str]| {
        let mut command = Command::new(program);
        let output = command.args(["calibrate", "study.toml"]).args(words).current_dir(&place.0).output().unwrap();
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    };
    finish(&["--out", "out", "--resume", "--threads", "1"]);
    finish(&["--out", "whole"]);
    let (resumed, whole) = (json(&place, "out/calibration.json"), json(&place, "whole/calibration.json"));
    for key in ["parameters", "objective", "evaluations", "repeats", "uncertainty"] {
        assert_eq!(resumed[key], whole[key], "{key}");
    }
    assert_eq!(resumed["interrupted"], false);
}
