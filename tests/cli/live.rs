//! Files of recorders while the script that writes them is at work: for the script itself, for others, and for another run.

use super::{MODEL, Place};
use std::fs;
use std::io::{BufRead as _, BufReader, Read as _};
use std::process::{Child, Command, Stdio};

const STATIC: &str = "fix 3 1 1 1\nintegrator LoadControl 1\nalgorithm Linear\nanalysis Static\n";
const RECORDER: &str = "recorder Node -file d.out -time -node 2 -dof 1 disp\n";

/// Opens the file of its recorder after each `analyze`, by all commands that look at files.
const LOOK: &str = "proc content {name} { set f [open $name]; set text [read $f]; close $f; set text }\n\
    proc rows {name} { llength [split [string trim [content $name]] \\n] }\n\
    puts \"[file exists d.out] [glob -nocomplain *.out]\"\n\
    for {set i 0} {$i < 3} {incr i} {\n  analyze 1\n  file copy -force d.out copy.txt\n\
    \x20 puts \"[rows d.out] [rows copy.txt] [expr {[file size d.out] == [string length [content d.out]]}] [lsort [glob *.out]] [rows max.out]\"\n}\n\
    set f [open d.out]; puts [llength [split [string trim [read $f]] \\n]]\nanalyze 2\n\
    puts [llength [split [string trim [read $f]] \\n]]; close $f\n";

fn script() -> String {
    format!("{MODEL}{STATIC}{RECORDER}recorder EnvelopeNode -file max.out -node 2 -dof 1 disp\n{LOOK}")
}

/// Each pass of a loop reads the rows so far, whatever an earlier run has left.
#[test]
fn a_script_reads_its_own_rows() {
    let expected = "0 \n1 1 1 d.out max.out 3\n2 2 1 d.out max.out 3\n3 3 1 d.out max.out 3\n3\n2\n";
    for options in [&[][..], &["--out", "res"], &["--checkpoint", "1s"]] {
        let place = Place::new();
        place.write("m.tcl", script());
        let folder = if options.first() == Some(&"--out") { place.0.join("res") } else { place.0.clone() };
        for _ in 0..2 {
            let (status, out, err) = place.run(&[&["run", "m.tcl"], options].concat());
            assert_eq!(status, Some(0), "{err}");
            assert_eq!(out, expected, "{options:?}");
            assert_eq!(fs::read_to_string(folder.join("d.out")).unwrap().lines().count(), 5);
            assert!(!place.names().iter().any(|n| n.starts_with('.')), "{:?}", place.names());
        }
    }
}

/// The final bytes do not depend on who has looked meanwhile.
#[test]
fn looking_changes_no_bytes() {
    let formats = ["-file", "-csv", "-xml", "-binary"];
    let recorders: String = formats
        .iter()
        .map(|f| {
            let name = f.trim_start_matches('-');
            format!(
                "recorder Node {f} d.{name} -time -node 2 -dof 1 2 disp\nrecorder EnvelopeNode {f} e.{name} -time -node 2 -dof 2 disp\n"
            )
        })
        .collect();
    let rms = "recorder NodeRMS -file rms.out -node 2 -dof 1 2 disp\n";
    let run = |look: &str| {
        let place = Place::new();
        let steps = format!("for {{set i 0}} {{$i < 20}} {{incr i}} {{ analyze 1; {look} }}\n");
        place.write("m.tcl", format!("{MODEL}{STATIC}{recorders}{rms}{steps}"));
        let (status, _, err) = place.run(&["run", "m.tcl"]);
        assert_eq!(status, Some(0), "{err}");
        let mut names = place.names();
        names.retain(|n| n != "m.tcl");
        assert_eq!(names.len(), 9, "{names:?}");
        names.iter().map(|n| fs::read(place.0.join(n)).unwrap()).collect::<Vec<_>>()
    };
    assert!(run("") == run("glob -nocomplain *.out"));
}

/// Starts a script, and waits until it has put out a line.
fn started(place: &Place) -> (Child, BufReader<std::process::ChildStdout>) {
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
    (child, out)
}

/// Others read the rows after an `analyze`; a run that is killed leaves whole rows, or no file where no analysis has ended.
#[test]
fn others_read_whole_rows() {
    let place = Place::new();
    place.write("d.out", "of an earlier run\n");
    place.write("m.tcl", format!("{MODEL}{STATIC}{RECORDER}analyze 4\nflush stdout\nputs go\nwhile 1 {{}}\n"));
    let (mut child, _out) = started(&place);
    let seen = fs::read_to_string(place.0.join("d.out")).unwrap();
    child.kill().unwrap();
    child.wait().unwrap();
    assert!(seen.lines().count() == 4 && seen.ends_with('\n'), "{seen}");
    assert_eq!(fs::read_to_string(place.0.join("d.out")).unwrap(), seen);

    let endless = format!("{MODEL}{STATIC}{RECORDER}puts go\nflush stdout\nanalyze 1000000000\n");
    place.write("m.tcl", endless);
    let (mut child, _out) = started(&place);
    std::thread::sleep(std::time::Duration::from_millis(100));
    child.kill().unwrap();
    child.wait().unwrap();
    assert!(!place.0.join("d.out").exists());
    // What the killed run has left is gone with the next one.
    place.write("m.tcl", format!("{MODEL}{STATIC}{RECORDER}analyze 2\n"));
    assert_eq!(place.run(&["run", "m.tcl"]).0, Some(0));
    assert_eq!(place.names(), ["d.out", "m.tcl"]);
}

/// A second run in the folder is refused while the first one writes, and the first one's file is its own.
#[test]
fn two_runs_do_not_share_a_file() {
    let place = Place::new();
    for before in ["", "analyze 1\n"] {
        place.write(
            "m.tcl",
            format!("{MODEL}{STATIC}{RECORDER}{before}puts go\nflush stdout\nwhile {{![file exists end]}} {{after 5}}\nanalyze 3\n"),
        );
        let (mut child, mut out) = started(&place);
        place.write("second.tcl", format!("{MODEL}{STATIC}{RECORDER}analyze 1\n"));
        let (status, _, err) = place.run(&["run", "second.tcl"]);
        assert!(status == Some(2) && err.contains("d.out: another run or recorder writes it"), "{err}");
        place.write("end", "");
        let mut rest = String::new();
        out.read_to_string(&mut rest).unwrap();
        assert_eq!(child.wait().unwrap().code(), Some(0));
        let rows = fs::read_to_string(place.0.join("d.out")).unwrap().lines().count();
        assert_eq!(rows, 3 + before.lines().count());
        assert_eq!(place.run(&["run", "second.tcl"]).0, Some(0));
        fs::remove_file(place.0.join("end")).unwrap();
    }
}

/// The list of PVD files and the files themselves are those of this run.
#[test]
fn pvd_files_are_those_of_the_run() {
    let place = Place::new();
    let run = |steps: usize| {
        let look = "set f [open p.pvd]; set n [regexp -all DataSet [read $f]]; close $f; puts \"$n [llength [glob p/*.vtu]]\"\n";
        place.write("m.tcl", format!("{MODEL}{STATIC}recorder PVD p disp\nanalyze {steps}\n{look}"));
        let (status, out, err) = place.run(&["run", "m.tcl"]);
        assert_eq!(status, Some(0), "{err}");
        out
    };
    assert_eq!((run(5).as_str(), run(2).as_str()), ("5 5\n", "2 2\n"));
}

/// In a study the rows stay in memory: a script that reads the file of its recorder is told so, and gets none of an earlier run.
#[test]
fn a_study_reads_no_file_of_an_earlier_run() {
    let place = Place::new();
    let look = "puts [file exists d.out]\nif {[file exists d.out]} {error stale}\n";
    let model = |tail: &str| {
        format!("pset k 100.\n{MODEL}{STATIC}recorder Node -file d.out -time -node 2 -dof 1 disp\nanalyze 3\n{tail}")
    };
    place.write("d.out", "1 1\n");
    place.write("rec.csv", "t,u\n1,1e-8\n2,2e-8\n3,3e-8\n");
    let study = "model = \"m.tcl\"\n[[parameter]]\nname = \"k\"\nlower = 50.0\nupper = 200.0\n[[run]]\nname = \"a\"\nrecording = \"rec.csv\"\n\
        [[run.observe]]\nchannel = \"u\"\noutput = \"d.out\"\ncolumn = 2\n";
    place.write("study.toml", study);
    place.write("m.tcl", model(look));
    let (_, out, err) = place.run(&["check", "study.toml"]);
    assert!(!err.contains("stale"), "{out}{err}");
    place.write("m.tcl", model("set f [open d.out]\n"));
    let (_, out, err) = place.run(&["check", "--json", "study.toml"]);
    assert!((out.clone() + &err).contains("couldn't open"), "{out}{err}");
}
