//! `run --balance` and `run --review`: what stands beside the results.

use super::Place;
use std::fs;

/// An isolated mass under a motion from a file, with a recorder that the script reads back.
const SHAKEN: &str = "model basic -ndm 1 -ndf 1
    node 1 0; node 2 0 -mass 1; fix 1 1
    uniaxialMaterial Steel01 1 1.0 100.0 0.1
    element zeroLength 1 1 2 -mat 1 -dir 1
    timeSeries Path 1 -dt 0.1 -filePath motion.txt
    pattern UniformExcitation 1 1 -accel 1
    recorder Node -file disp.out -time -node 2 -dof 1 disp
    constraints Plain; numberer Plain; system BandGeneral; test NormDispIncr 1e-10 20; algorithm Newton
    integrator Newmark 0.5 0.25; analysis Transient
    analyze 100 0.05
    remove recorders
    set f [open disp.out]; set last [lindex [split [string trim [read $f]] \\n] end]; close $f
    puts [llength $last]\n";

fn shaken() -> Place {
    let place = Place::new();
    let motion: Vec<String> = (0..60).map(|i| format!("{:.6}", 3.0 * (f64::from(i) * 0.4).sin())).collect();
    place.write("motion.txt", motion.join("\n"));
    place.write("m.tcl", SHAKEN);
    place
}

#[test]
fn a_review_says_what_the_run_rests_on() {
    let place = shaken();
    let (status, out, err) = place.run(&["run", "--review", "review.html", "m.tcl"]);
    assert_eq!((status, out.as_str()), (Some(0), "2\n"), "{err}");
    assert_eq!(place.names(), ["disp.out", "m.tcl", "motion.txt", "review.html"]);
    let page = fs::read_to_string(place.0.join("review.html")).unwrap();
    // Inputs are the script and its motion; the recorder's file is none, although the script reads it.
    assert_eq!(page.matches("<td>m.tcl</td>").count(), 1, "{page}");
    assert_eq!(page.matches("<td>motion.txt</td>").count(), 1);
    let hashed = page.split("<h2>Models").next().unwrap();
    assert!(!hashed.contains("<td>disp.out</td>"));
    for part in [
        "100 steps",
        "uniaxialMaterial</td><td>Steel01",
        "with half the steps peaks change by up to",
        "work on ZeroLength",
    ] {
        assert!(page.contains(part), "{part}: {page}");
    }
    // The results are those of the run as it was asked for, not of the refined one.
    let rows = fs::read_to_string(place.0.join("disp.out")).unwrap();
    assert_eq!(rows.lines().count(), 100);
    // A changed input has another hash.
    let hash = |page: &str| page.split("<td>motion.txt</td><td>").nth(1).unwrap()[..64].to_owned();
    place.write("motion.txt", "0.0 1.0 0.0 2.0 0.0 1.0 1.0 0.0 0.0");
    place.run(&["run", "--review", "review.html", "m.tcl"]);
    let other = fs::read_to_string(place.0.join("review.html")).unwrap();
    assert_ne!(hash(&page), hash(&other));
}

#[test]
fn a_review_of_a_failed_run_says_so() {
    let place = Place::new();
    place.write("m.tcl", "model basic -ndm 1 -ndf 1\nnode 1 0\nfix 9 1\n");
    let (status, _, _) = place.run(&["run", "--review", "review.html", "m.tcl"]);
    assert_eq!(status, Some(2));
    let page = fs::read_to_string(place.0.join("review.html")).unwrap();
    assert!(page.contains("The script was stopped") && page.contains("m.tcl:3:5"), "{page}");
    // A page that cannot be written is an error.
    let (status, _, err) = place.run(&["run", "--review", "no/such/folder.html", "m.tcl"]);
    assert!(status == Some(2) && err.contains("cannot write"), "{err}");
}

#[test]
fn a_balance_is_printed_and_its_history_written() {
    let place = shaken();
    let (status, out, err) = place.run(&["run", "--balance=energy.csv", "m.tcl"]);
    assert_eq!((status, out.as_str()), (Some(0), "2\n"), "{err}");
    assert!(err.contains("work on ZeroLength") && err.contains("error"), "{err}");
    let rows = fs::read_to_string(place.0.join("energy.csv")).unwrap();
    assert_eq!(rows.lines().count(), 101);
    let (status, _, err) = place.run(&["run", "--balance", "m.tcl"]);
    assert!(status == Some(0) && err.contains("input"), "{err}");
}
