//! Scripts without an end or a bound: counts, nesting, memory and time.

use super::{MODEL, Place, run};
use std::fmt::Write as _;
use std::time::{Duration, Instant};

#[test]
fn large_counts_are_refused() {
    for command in [
        "eigen 500000000",
        "section LayeredShell 9 2000000000 1 0.1",
        "algorithm KrylovNewton -maxDim 2000000000",
        "section WFSection2d 9 1 1. 0.1 1. 0.1 10 100 2000000000 2",
    ] {
        let (status, _, err) = run(&format!("{MODEL}{command}\n"));
        assert!(status == Some(2) && err.contains("m.tcl:11:"), "{command}: {status:?} {err}");
    }
    // After a mistake a check answers without a model.
    let place = Place::new();
    place.write("m.tcl", format!("{MODEL}node 1 0 x\neigen 500000000\n"));
    let (status, _, err) = place.run(&["check", "m.tcl"]);
    assert!(status == Some(2) && err.contains("m.tcl:11:"), "{err}");
}

/// A body within a body shares its text: 20,000 copies of 140 kB would take gigabytes.
#[test]
fn nested_bodies_share_their_text() {
    let nested = |open: &str, close: &str| format!("{}{}", open.repeat(10_000), close.repeat(10_000));
    for (open, close) in [("if 1 {", "}"), ("switch 1 {1 {", "}}"), ("foreach a 1 {", "}"), ("expr {[if 1 {", "}]}")] {
        let place = Place::new();
        place.write("m.tcl", nested(open, close));
        let (_, _, err) = place.run(&["run", "--max-memory", "150M", "m.tcl"]);
        assert!(err.is_empty() || err.contains("too many nested evaluations"), "{open}: {err}");
    }
}

#[test]
fn superfluous_words_are_refused_after_some() {
    let words = (0..20_000).fold(String::new(), |mut text, i| {
        let _ = write!(text, " -w{i}");
        text
    });
    let begun = Instant::now();
    let (status, _, err) = run(&format!("{MODEL}recorder Node -file d.out -node 2 -dof 1{words} disp\n"));
    assert!(status == Some(2) && err.contains("more than 20 words are no options"), "{}", &err[..2000.min(err.len())]);
    // Many commands with one superfluous word each, in one line.
    let line = "fix 3 0 0 0 0;".repeat(20_000);
    let (_, _, err) = run(&format!("{MODEL}{line}\n"));
    assert!(err.contains("further ones are counted only") && err.contains("more"), "{}", &err[..2000.min(err.len())]);
    assert!(begun.elapsed() < Duration::from_secs(60), "{:?}", begun.elapsed());
}

#[test]
fn figure_of_extreme_numbers_is_refused() {
    for numbers in ["{-1e308 1e308} {0 1}", "{0 1} {1e-300 1e308}"] {
        let (status, _, err) = run(&format!("figure f.svg -title t -x x -y y -line l {numbers}\n"));
        assert!(status == Some(2) && err.contains("1e308 cannot be drawn"), "{err}");
    }
    let (status, _, err) = run("figure f.svg -title t -x x -y y -xrange -1e308 1e308 -line l {0 1} {0 1}\n");
    assert!(status == Some(2) && err.contains("m.tcl:1:"), "{err}");
}

#[test]
fn script_of_one_letter_has_a_place() {
    let (status, _, err) = run("0");
    assert!(status == Some(2) && err.contains("m.tcl:1:1"), "{err}");
}

/// A loop without an end is stopped, with its place; so is a command at work, and a step that never converges.
#[test]
fn time_limit() {
    let place = Place::new();
    // With the initial stiffness of 100 the force of 2 is millions of iterations away.
    let step = "model basic -ndm 1 -ndf 1\nnode 1 0\nnode 2 0\nfix 1 1\n\
         uniaxialMaterial ElasticMultiLinear 1 -strain -1e9 -0.01 0 0.01 1e9 -stress -1001 -1 0 1 1001\n\
         element zeroLength 1 1 2 -mat 1 -dir 1\ntimeSeries Linear 1\npattern Plain 1 1 { load 2 2. }\n\
         test NormDispIncr 1e-12 2000000000\nalgorithm ModifiedNewton -initial\nintegrator LoadControl 1\n\
         analysis Static\nanalyze 1\n";
    for (command, script, at) in [
        ("run", "set a 1\nwhile 1 {}\n", "m.tcl:2:1"),
        ("run", "proc f {} {while 1 {incr ::n}}\nset n 0\nf\n", "m.tcl:1:"),
        ("check", "while 1 {set a [string repeat x 100000]}\n", "m.tcl:1:"),
        ("run", step, "m.tcl:13:1"),
    ] {
        place.write("m.tcl", script);
        let begun = Instant::now();
        let (status, _, err) = place.run(&[command, "--time-limit", "0.5", "m.tcl"]);
        assert!(status == Some(1) && err.contains("the time limit of 0.5 s is over") && err.contains(at), "{err}");
        assert!(begun.elapsed() < Duration::from_secs(9), "{script}: {:?}", begun.elapsed());
    }
    let (status, _, err) = place.run(&["run", "--time-limit=-1", "m.tcl"]);
    assert!(status == Some(2) && err.contains("number of seconds"), "{err}");
}

#[test]
fn memory_limit() {
    let place = Place::new();
    place.write("m.tcl", "set a {}\nwhile 1 {lappend a [string repeat x 1000]}\n");
    let (status, _, err) = place.run(&["run", "--max-memory", "200M", "m.tcl"]);
    assert!(status == Some(1) && err.contains("takes more memory than 200M"), "{err}");
    let (status, _, err) = place.run(&["run", "--max-memory", "many", "m.tcl"]);
    assert!(status == Some(2) && err.contains("500M or 4G"), "{err}");
}

/// Limits hold for commands that run many analyses too.
#[test]
fn limits_of_studies_and_batches() {
    let place = Place::new();
    place.write("model.tcl", "pset k 1.0\nset sum 0\nwhile 1 {}\n");
    place.write("plan.toml", "scripts = [\"model.tcl\"]\nresults = [\"sum\"]\n[grid]\nk = [1.0, 2.0]\n");
    let (status, _, err) = place.run(&["batch", "plan.toml", "--out", "b", "--time-limit", "0.5"]);
    assert!(status == Some(1) && err.contains("the time limit of 0.5 s is over"), "{err}");
    let study = concat!(env!("CARGO_MANIFEST_DIR"), "/tcl-like-inputs/isolation_study/study.toml");
    for command in ["isolate", "ida", "fragility"] {
        let (status, _, err) = place.run(&[command, study, "--out", command, "--time-limit", "0.05"]);
        assert!(status == Some(1) && err.contains("the time limit of 0.05 s is over"), "{command}: {err}");
        assert!(!place.0.join(command).join("report.html").exists(), "{command}");
    }
    let (status, _, err) = place.run(&["response-spectrum", study, "--max-memory", "many"]);
    assert!(status == Some(2) && err.contains("500M or 4G"), "{err}");
}

/// A device without an end is refused as a study, a plan, a table or a recording, without taking its bytes.
#[test]
fn inputs_without_an_end_are_refused() {
    let place = Place::new();
    let recording = "model = \"m.tcl\"\n[[parameter]]\nname = \"k\"\nlower = 1.0\nupper = 4.0\n[[run]]\nname = \"a\"\n\
        recording = \"/dev/zero\"\n[[run.observe]]\nchannel = \"u\"\noutput = \"d.out\"\ncolumn = 1\n";
    place.write("study.toml", recording);
    place.write("m.tcl", "pset k 2.0\n");
    for words in [
        &["calibrate", "/dev/zero", "--max-memory", "400M"][..],
        &["calibrate", "study.toml", "--max-memory", "400M"],
        &["batch", "/dev/zero", "--max-memory", "400M"],
        &["isolate", "/dev/zero", "--max-memory", "400M"],
        &["fragility", "/dev/zero", "--max-memory", "400M"],
        &["loops", "/dev/zero", "-u", "1", "-f", "2"],
        &["motions", "/dev/zero", "--dt", "0.01", "--unit", "g"],
        &["prototype", "/dev/zero", "-u", "1", "-f", "2"],
    ] {
        let (status, _, err) = place.run(words);
        assert!(status == Some(2) && err.contains("it has more than 64 MB"), "{words:?}: {status:?} {err}");
    }
}
