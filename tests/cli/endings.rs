//! How a run ends: exit status, and what is left on the disk.

use super::{MODEL, Place, run};
use std::fs;

const STATIC: &str = "constraints Transformation\nintegrator LoadControl 1\nalgorithm Newton\n\
    test NormDispIncr 1e-8 5\nanalysis Static\n";

#[test]
fn statuses() {
    for (script, expected) in [
        ("", 0),
        ("puts done", 0),
        ("exit", 0),
        ("exit 7", 7),
        ("error \"my own\"", 1),
        ("set x {", 2),
        ("frobnicate", 2),
        ("catch frobnicate", 0),
    ] {
        assert_eq!(run(script).0, Some(expected), "{script}");
    }
}

#[test]
fn files_that_are_no_scripts() {
    let place = Place::new();
    place.write("bytes.tcl", b"puts \"caf\xe9 \xff\xfe\"\n");
    place.write("binary.tcl", [0u8, 159, 146, 150, 10, 0, 255]);
    place.write("empty.tcl", "");
    assert_eq!(place.run(&["run", "bytes.tcl"]).0, Some(0));
    assert_eq!(place.run(&["run", "empty.tcl"]).0, Some(0));
    for bad in ["binary.tcl", "missing.tcl", "."] {
        let (status, _, err) = place.run(&["run", bad]);
        assert!(status == Some(2) && !err.is_empty(), "{bad}: {err}");
    }
}

/// A mechanism names the degree of freedom; the script sees the code, and the last failure makes the status.
#[test]
fn mechanism() {
    let (status, out, err) = run(&format!("{MODEL}{STATIC}set ok [analyze 1]\nputs $ok\n"));
    assert!(status == Some(1) && out.trim().parse::<i32>().unwrap() < 0, "{out}{err}");
    assert!(err.contains("node 3") && err.contains("m.tcl:16:"), "{err}");
}

/// Results appear only when they are complete, and are complete also where the script fails afterwards.
#[test]
fn results_are_kept() {
    let place = Place::new();
    let held = format!("{MODEL}fix 3 1 1 1\nrecorder Node -file d.txt -node 2 -dof 1 disp\n{STATIC}analyze 3\n");
    place.write("m.tcl", format!("{held}puts [llength [glob *.part]][file exists d.txt]\nfrobnicate\n"));
    let (status, out, _) = place.run(&["run", "m.tcl"]);
    assert_eq!((status, out.trim()), (Some(2), "10"));
    assert_eq!(fs::read_to_string(place.0.join("d.txt")).unwrap().lines().count(), 3);
    assert_eq!(place.names(), ["d.txt", "m.tcl"]);
}

/// Recorders of what is not there say so.
#[test]
fn recorders_of_nothing() {
    let script = format!("{MODEL}fix 3 1 1 1\nrecorder Node -file d.txt -node 2 77 -dof 1 disp\n{STATIC}analyze 1\n");
    let (status, _, err) = run(&script);
    assert!(status == Some(0) && err.contains("no node 77"), "{err}");
}

/// Nobody reads the output: the analysis goes on all the same.
#[test]
fn closed_output() {
    use std::process::{Command, Stdio};
    let place = Place::new();
    place.write("m.tcl", "for {set i 0} {$i < 20000} {incr i} {puts line}\nset f [open done w]; close $f\n");
    let mut child = Command::new(env!("CARGO_BIN_EXE_hysteron"))
        .args(["run", "m.tcl"])
        .current_dir(&place.0)
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stdout.take());
    assert_eq!(child.wait().unwrap().code(), Some(0));
    assert!(place.0.join("done").exists());
}
