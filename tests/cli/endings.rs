//! End of a run: exit status, and the files left on the disk.

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
        (
            "model basic -ndm 2 -ndf 2; node 1 5 6; node 2 7 3; exit [expr {int([lindex [nodeBounds] 4]) + [llength [nodeBounds]]}]",
            12,
        ),
        ("exit 7", 7),
        // As the system keeps it: the last byte.
        ("exit -1", 255),
        ("exit 258", 2),
        ("error \"my own\"", 1),
        ("set x {", 2),
        ("frobnicate", 2),
        ("catch frobnicate", 0),
    ] {
        assert_eq!(run(script).0, Some(expected), "{script}");
    }
}

#[test]
fn file_that_is_no_script_is_refused() {
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

/// Results are there after each analysis, and are complete also where the script fails afterwards.
#[test]
fn results_are_kept() {
    let place = Place::new();
    let held = format!("{MODEL}fix 3 1 1 1\nrecorder Node -file d.txt -node 2 -dof 1 disp\n{STATIC}analyze 3\n");
    place.write("m.tcl", format!("{held}puts [llength [glob -nocomplain *.part]][file exists d.txt]\nfrobnicate\n"));
    let (status, out, _) = place.run(&["run", "m.tcl"]);
    assert_eq!((status, out.trim()), (Some(2), "01"));
    assert_eq!(fs::read_to_string(place.0.join("d.txt")).unwrap().lines().count(), 3);
    assert_eq!(place.names(), ["d.txt", "m.tcl"]);
}

/// A spring that yields at 10 under a load of 4 at each step.
const YIELDING: &str = "model basic -ndm 1 -ndf 1\nnode 1 0\nnode 2 0\nfix 1 1\n\
    uniaxialMaterial Steel01 1 10. 100. 0.1\nelement zeroLength 1 1 2 -mat 1 -dir 1\ntimeSeries Linear 1\n\
    pattern Plain 1 1 { load 2 1. }\nalgorithm Newton\nintegrator LoadControl 4\nanalysis Static\n";

/// A step that does not converge is reported. The script's own remedy starts from the last step that did.
#[test]
fn remedy() {
    let script = "test NormDispIncr 1e-10 2\nset codes {}\nfor {set i 0} {$i < 4} {incr i} {\n  set ok [analyze 1]\n\
        \x20 if {$ok != 0} {\n    puts \"[getTime] [nodeDisp 2 1]\"\n    test NormDispIncr 1e-10 20\n\
        \x20   set ok [analyze 1]\n  }\n  lappend codes $ok\n}\nputs $codes\nputs [format %.6f [nodeDisp 2 1]]\n";
    let (status, out, err) = run(&format!("{YIELDING}{script}"));
    assert_eq!((status, out.as_str()), (Some(0), "8.0 0.08\n0 0 0 0\n0.700000\n"), "{err}");
    for words in ["no convergence at time 12", "after 2 iterations", "node 2", "wanted 1.0e-10", "m.tcl:15:"] {
        assert!(err.contains(words), "{words}: {err}");
    }
}

/// `--refine` shows the numerical error of the steps: a hundredth of it is left with ten parts of a second-order method.
#[test]
fn refined() {
    let place = Place::new();
    // ω = 10 under a load that is there at once: u = (1 - cos ωt) / k.
    let script = "model basic -ndm 1 -ndf 1\nnode 1 0\nnode 2 0 -mass 1.\nfix 1 1\nuniaxialMaterial Elastic 1 100.\n\
        element zeroLength 1 1 2 -mat 1 -dir 1\ntimeSeries Constant 1\npattern Plain 1 1 { load 2 1. }\n\
        setNodeAccel 2 1 1. -commit\nintegrator Newmark 0.5 0.25\nalgorithm Linear\nanalysis Transient\nanalyze 20 0.02\nputs [nodeDisp 2 1]\n";
    place.write("m.tcl", script);
    let error = |parts: &str| {
        let (status, out, err) = place.run(&["run", "--refine", parts, "m.tcl"]);
        assert_eq!(status, Some(0), "{err}");
        (out.trim().parse::<f64>().unwrap() - 0.01 * (1.0 - 4f64.cos())).abs()
    };
    let (whole, parts) = (error("1"), error("10"));
    assert!(whole > 1e-5 && (90.0..110.0).contains(&(whole / parts)), "{whole:e} {parts:e}");
    let (status, _, err) = place.run(&["run", "--refine", "0", "m.tcl"]);
    assert!(status == Some(2) && err.contains("--refine"), "{status:?} {err}");
}

/// An interrupt ends the analysis after a committed step, and the record is complete up to there.
#[test]
fn interrupted() {
    use std::io::{BufRead as _, BufReader, Read as _};
    use std::process::{Command, Stdio};
    let place = Place::new();
    let tail =
        "recorder Node -file d.txt -time -node 2 -dof 1 disp\nputs go\nflush stdout\nanalyze 1000000000\nputs no\n";
    place.write("m.tcl", format!("{}{tail}", YIELDING.replace("LoadControl 4", "LoadControl 1e-9")));
    let mut child = Command::new(env!("CARGO_BIN_EXE_hysteron"))
        .args(["run", "m.tcl"])
        .current_dir(&place.0)
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut out = BufReader::new(child.stdout.take().unwrap());
    let mut line = String::new();
    out.read_line(&mut line).unwrap();
    assert_eq!(line, "go\n");
    std::thread::sleep(std::time::Duration::from_millis(200));
    assert!(Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap().success());
    let (mut rest, mut err) = (String::new(), String::new());
    out.read_to_string(&mut rest).unwrap();
    child.stderr.take().unwrap().read_to_string(&mut err).unwrap();
    assert_eq!((child.wait().unwrap().code(), rest.as_str()), (Some(130), ""), "{err}");
    assert!(err.contains("interrupted at m.tcl:15:1: what was recorded so far has been kept"), "{err}");
    assert!(err.contains("partial, with whole rows up to there: d.txt"), "{err}");
    let record = fs::read_to_string(place.0.join("d.txt")).unwrap();
    assert!(record.ends_with('\n') && record.lines().all(|l| l.split(' ').count() == 2));
    assert!(record.lines().count() > 0 && place.names() == ["d.txt", "m.tcl"]);
}

/// An output that cannot be written is an error at its command, or at the latest at the end.
#[test]
fn unwritable() {
    for (script, status, words) in [
        ("recorder Node -file m.tcl/d.txt -node 2 -dof 1 disp", 2, "m.tcl:11:21"),
        ("file mkdir sub; recorder Node -file sub -node 2 -dof 1 disp", 2, "m.tcl:11:37"),
        ("set f [open m.tcl/x w]", 2, "couldn't open"),
        ("figure m.tcl/f.svg -title t -x x -y y -line l {0 1} {0 1}", 2, "cannot write"),
    ] {
        let (found, _, err) = run(&format!("{MODEL}{script}\n"));
        assert!(found == Some(status) && err.contains(words), "{script}: {found:?} {err}");
    }
}

/// Recorders of missing objects warn.
#[test]
fn recorders_of_nothing() {
    let script = format!("{MODEL}fix 3 1 1 1\nrecorder Node -file d.txt -node 2 77 -dof 1 disp\n{STATIC}analyze 1\n");
    let (status, _, err) = run(&script);
    assert!(status == Some(0) && err.contains("no node 77"), "{err}");
}

/// A closed output does not stop the analysis; the status tells of it.
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
    assert_eq!(child.wait().unwrap().code(), Some(1));
    assert!(place.0.join("done").exists());
}

/// Options stand on both sides of the script; a misspelled one is an error. Words behind `--` are the script's.
#[test]
fn options_after_the_script() {
    let place = Place::new();
    place.write("m.tcl", "puts $argv\n");
    for (words, printed) in [
        (&["a", "-0.5", "-1e3"][..], "a -0.5 -1e3\n"),
        (&["a", "--strict", "b"], "a b\n"),
        (&["--", "--strict", "-x"], "--strict -x\n"),
        (&["--ladder", "a", "--", "-y"], "a -y\n"),
    ] {
        let (status, out, err) = place.run(&[&["run", "m.tcl"], words].concat());
        assert_eq!((status, out.as_str()), (Some(0), printed), "{err}");
    }
    for command in ["run", "check"] {
        let (status, out, err) = place.run(&[command, "m.tcl", "--stric"]);
        assert!(status == Some(2) && out.is_empty() && err.contains("--stric") && err.contains("'--strict'"), "{err}");
    }
}

/// What a script writes goes into the folder of `--out`; what it reads is found where it was.
#[test]
fn outputs_in_a_folder() {
    let place = Place::new();
    place.write("motion.txt", "0 1 2\n");
    place.write("log.txt", "old\n");
    place.write("old.out", "kept");
    let script = "file mkdir res\nset f [open motion.txt]; puts [gets $f]; close $f\n\
        set f [open log.txt a]; puts $f new; close $f\nset f [open res/log.txt w]; puts $f deep; close $f\n\
        set f [open log.txt]; puts [read -nonewline $f]; close $f\nfile delete old.out\n\
        puts \"[file exists old.out] [lsort [glob *]]\"\nfile rename res/log.txt res/moved.txt\n\
        recorder Node -file res/d.out -node 2 -dof 1 disp\nrecorder Node -file e.out -node 2 -dof 1 disp\n";
    place
        .write("m.tcl", format!("{MODEL}fix 3 1 1 1\n{script}{STATIC}analyze 2\nwipe\nputs [file exists res/d.out]\n"));
    for _ in 0..2 {
        let (status, out, err) = place.run(&["run", "m.tcl", "--out", "out/deep"]);
        assert_eq!(status, Some(0), "{err}");
        assert_eq!(out, "0 1 2\nold\nnew\n0 log.txt m.tcl motion.txt out res\n1\n");
        assert_eq!(place.names(), ["log.txt", "m.tcl", "motion.txt", "old.out", "out"]);
        let there = |name: &str| fs::read_to_string(place.0.join("out/deep").join(name)).unwrap();
        assert_eq!((there("log.txt").as_str(), there("res/moved.txt").as_str()), ("old\nnew\n", "deep\n"));
        assert_eq!((there("res/d.out").lines().count(), there("e.out").lines().count()), (2, 2));
        assert_eq!(fs::read_to_string(place.0.join("log.txt")).unwrap(), "old\n");
    }
}

/// SIGTERM ends a run like Ctrl-C: with status 130 and the rows recorded so far.
#[test]
fn termination() {
    let place = Place::new();
    place.write("m.tcl", "puts ready\nflush stdout\nwhile {1} {}\n");
    let mut child = std::process::Command::new(env!("CARGO_BIN_EXE_hysteron"))
        .args(["run", "m.tcl"])
        .current_dir(&place.0)
        .stdout(std::process::Stdio::piped())
        .spawn()
        .unwrap();
    let mut ready = [0u8; 5];
    std::io::Read::read_exact(child.stdout.as_mut().unwrap(), &mut ready).unwrap();
    let killed = std::process::Command::new("kill").arg(child.id().to_string()).status().unwrap();
    assert!(killed.success());
    assert_eq!(child.wait().unwrap().code(), Some(130));
}
