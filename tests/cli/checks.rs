//! `hysteron check`.

use super::{MODEL, Place};

/// All mistakes are told, those of Tcl at top level too.
#[test]
fn goes_on() {
    let place = Place::new();
    place.write("m.tcl", format!("{MODEL}node x 0 0\nputs $nothing\nfrobnicate\nnode 1 0 0\n"));
    let (status, _, err) = place.run(&["check", "m.tcl"]);
    assert_eq!(status, Some(2));
    for line in 11..15 {
        assert!(err.contains(&format!("  error: m.tcl:{line}:")), "{line}: {err}");
    }
    assert!(err.contains("4 errors:"), "{err}");
}

/// The script sees what it has written; the disk does not.
#[test]
fn writes_nothing() {
    let place = Place::new();
    place.write("old.txt", "old");
    let script = "file mkdir out/deep\nset f [open out/a.txt w]; puts -nonewline $f {1 2}; close $f\n\
        timeSeries Path 2 -dt 1 -filePath out/a.txt\nfile delete old.txt\nfile rename out/a.txt out/b.txt\n\
        puts \"[file exists old.txt] [glob -tails -directory out *.txt]\"\n\
        set f [open m.tcl a]; puts $f more; close $f\n\
        recorder Node -file out/deep/d.txt -node 1 -dof 1 disp\n\
        figure out/f.svg -title t -x x -y y -line l {0 1} {0 1}\n";
    place.write("m.tcl", format!("{MODEL}{script}"));
    let (status, out, err) = place.run(&["check", "m.tcl"]);
    assert_eq!((status, out.trim(), err.as_str()), (Some(0), "0 b.txt", ""));
    assert_eq!(place.names(), ["m.tcl", "old.txt"]);
    assert_eq!(std::fs::read_to_string(place.0.join("m.tcl")).unwrap(), format!("{MODEL}{script}"));
}

/// A script that waits for what only a run has.
#[test]
fn ends() {
    let place = Place::new();
    place.write("m.tcl", "while {1} {}\n");
    let (status, _, err) = place.run(&["check", "m.tcl"]);
    assert!(status == Some(0) && err.contains("the check was ended"), "{err}");
}
