//! `hysteron check`.

use super::{MODEL, Place};

/// All mistakes are reported, those of Tcl at top level too.
#[test]
fn check_goes_on_after_a_mistake() {
    let place = Place::new();
    place.write("m.tcl", format!("{MODEL}node x 0 0\nputs $nothing\nfrobnicate\nnode 1 0 0\n"));
    let (status, _, err) = place.run(&["check", "m.tcl"]);
    assert_eq!(status, Some(2));
    for line in 11..15 {
        assert!(err.contains(&format!("  error: m.tcl:{line}:")), "{line}: {err}");
    }
    assert!(err.contains("4 errors:"), "{err}");
}

/// A mistake that follows from another one is not reported.
#[test]
fn consequences() {
    let tail = "element truss 2 1 3 1. 2\nrecorder Element -file f.txt -ele 2 force\nnode 4 1 1 1\n\
        set w [eigen 1]\nnodeEigenvector 2 1 1\nmodalDamping 0.02\nanalysis Static\nanalyze 1\neleForce 2\n";
    let place = Place::new();
    for (mistake, errors) in [
        ("uniaxialMaterial Elastik 2 1", 1),
        ("uniaxialMaterial Elastic 2 x", 1),
        ("uniaxialMaterial Elastic 2 $nil", 1),
        ("set e $nil\nputs $e\nuniaxialMaterial Elastic 2 $e", 1),
    ] {
        place.write("m.tcl", format!("{MODEL}{mistake}\n{tail}"));
        let (status, _, err) = place.run(&["check", "m.tcl"]);
        assert_eq!(status, Some(2));
        assert_eq!(err.matches("\n  error: ").count(), errors, "{mistake}: {err}");
        assert!(err.contains("note: the analyses were not rehearsed"), "{err}");
    }
    // A wrong recorder leaves the model what it is: the mechanism is found.
    place.write("m.tcl", format!("{MODEL}recorder Nod\nanalysis Static\nanalyze 1\n"));
    let (_, _, err) = place.run(&["check", "m.tcl"]);
    assert!(err.contains("node 3") && err.contains("2 errors"), "{err}");
}

/// Results of a check that passes an analysis over are missed by no later command.
#[test]
fn consequences_of_missing_modes_and_models() {
    let place = Place::new();
    let modes = "timeSeries Path 9 -time {0 1} -values {1 1}\nset w [eigen 1]\nmodalDamping 0.02\n\
        modalProperties\nresponseSpectrumAnalysis 9 1\n";
    place.write("m.tcl", format!("{MODEL}uniaxialMaterial Elastik 2 1\n{modes}"));
    let (_, _, err) = place.run(&["check", "m.tcl"]);
    assert_eq!(err.matches("\n  error: ").count(), 1, "{err}");
    place.write("m.tcl", format!("{MODEL}analysis Statik\nanalyze 1\n"));
    let (_, _, err) = place.run(&["check", "--strict", "m.tcl"]);
    assert_eq!(err.matches("\n  error: ").count(), 1, "{err}");
    place.write("m.tcl", "model basic -ndm x\nnode 1 0 0\nfix 1 1\n");
    let (_, _, err) = place.run(&["check", "m.tcl"]);
    assert_eq!(err.matches("\n  error: ").count(), 1, "{err}");
}

/// The code at the end of a message is explained.
#[test]
fn codes() {
    let place = Place::new();
    place.write("m.tcl", format!("{MODEL}node 9 0 0 -mess 1\nnode 1 0 0\nfix 77 1\n"));
    let (_, _, err) = place.run(&["check", "m.tcl"]);
    assert!(
        err.contains(
            "warning: node: \"-mess\" is not an option and is ignored, and so is what follows it [unknown-option]"
        ),
        "{err}"
    );
    assert!(err.contains("there is no node 77 [not-defined]"), "{err}");
    let (status, out, _) = place.run(&["explain", "unknown-option"]);
    assert!(status == Some(0) && out.starts_with("unknown-option\n  A word is no option"), "{out}");
    let (_, out, _) = place.run(&["explain"]);
    assert!(out.contains("  plain-constraints\n") && out.contains("  no-holdout\n"), "{out}");
    let (status, _, err) = place.run(&["explain", "unknown-optoin"]);
    assert!(status == Some(2) && err.contains("did you mean \"unknown-option\"?"), "{err}");
}

/// Every command has a line of its own.
#[test]
fn usages() {
    let (_, out, _) = Place::new().run(&["commands"]);
    let mut lines: Vec<&str> = out.lines().collect();
    lines.sort_unstable();
    assert!(lines.windows(2).all(|w| w[0] != w[1]), "{out}");
    for line in ["nodeVel $node <$dof>", "fixY $coordinate"] {
        assert!(out.contains(line), "{line}: {out}");
    }
}

/// Object that a command makes, and the query that shows it.
#[test]
fn kinds() {
    let place = Place::new();
    let (status, out, _) = place.run(&["commands", "element"]);
    assert!(status == Some(0) && out.lines().all(|l| l.starts_with("element ")) && out.contains("zeroLength"), "{out}");
    let (_, out, _) = place.run(&["commands", "nodeVel"]);
    assert!(out.starts_with("nodeVel $node <$dof>\n\n  Returns the velocity of a node.\n\n"), "{out}");
    assert!(out.contains("$node   "), "{out}");
    assert_eq!(
        place.run(&["commands", "Static"]).1,
        "analysis Static\n\n  Steps of the load factor or of a displacement.\n"
    );
    assert_eq!(place.run(&["commands", "prp"]).1, "prp $x $y $z\n\n  Accepted without effect.\n");
    let (status, _, err) = place.run(&["commands", "nodeVell"]);
    assert!(status == Some(2) && err.contains("did you mean \"nodeVel\"?"), "{err}");
    let (_, out, _) = place.run(&["commands", "Steel02"]);
    assert!(out.starts_with("uniaxialMaterial Steel02 $tag $Fy"), "{out}");
    assert!(out.contains("$Fy ") && out.contains("Recorders take: stress, strain, tangent"), "{out}");
    assert!(out.lines().all(|l| l.chars().count() <= 80), "{out}");
    let (_, other, _) = place.run(&["commands", "uniaxialMaterial", "Steel02"]);
    assert_eq!(out, other);
    // A second name of a kind; a name of two commands; a kind of an amendment.
    assert!(place.run(&["commands", "nonlinearBeamColumn"]).1.starts_with("element forceBeamColumn "));
    let (_, both, _) = place.run(&["commands", "Elastic"]);
    assert!(
        ["uniaxialMaterial Elastic", "section Elastic"].iter().all(|u| both.lines().any(|l| l.starts_with(u))),
        "{both}"
    );
    assert!(place.run(&["commands", "mullins"]).1.contains("-onset"));
    let (status, _, err) = place.run(&["commands", "steel02"]);
    assert!(status == Some(2) && err.contains("did you mean \"Steel02\"?"), "{err}");
    place.write("m.tcl", "model basic -ndm 2 -ndf 3\nelement zeroLenght 1 1 2\n");
    let (_, _, err) = place.run(&["run", "m.tcl"]);
    assert!(err.contains("did you mean \"zeroLength\"?") && err.contains("\"hysteron commands element\""), "{err}");
}

/// Completions and manual pages are those of the commands, and each command has examples.
#[test]
fn shells_and_manual() {
    let place = Place::new();
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        let (status, out, _) = place.run(&["completions", shell]);
        assert!(status == Some(0) && ["calibrate", "refine", "without"].iter().all(|w| out.contains(w)), "{shell}");
    }
    let (status, _, err) = place.run(&["man", "pages"]);
    assert_eq!(status, Some(0), "{err}");
    for name in ["run", "check", "bearing", "loops", "calibrate", "diagnose", "commands"] {
        let page = std::fs::read_to_string(place.0.join(format!("pages/hysteron-{name}.1"))).unwrap();
        let (_, help, _) = place.run(&[name, "--help"]);
        let examples: Vec<&str> = help.lines().skip_while(|l| *l != "Examples:").skip(1).collect();
        assert!(examples.iter().any(|l| l.starts_with(&format!("    hysteron {name}"))), "{help}");
        assert!(examples.iter().all(|l| l.chars().count() <= 80), "{help}");
        assert!(page.contains(".TH hysteron-") && page.contains("Examples:"), "{page}");
    }
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
    let (status, out, err) = place.run(&["check", "--show-output", "m.tcl"]);
    assert_eq!((status, out.as_str(), err.as_str()), (Some(0), "m.tcl: no mistakes\n", "m.tcl prints: 0 b.txt\n"));
    assert_eq!(place.names(), ["m.tcl", "old.txt"]);
    assert_eq!(std::fs::read_to_string(place.0.join("m.tcl")).unwrap(), format!("{MODEL}{script}"));
}

/// What a script prints is no result of a check.
#[test]
fn output_of_the_script_is_discarded() {
    let place = Place::new();
    place.write("m.tcl", format!("{MODEL}puts [nodeDisp 2 1]\nputs stderr words\n"));
    let (status, out, err) = place.run(&["check", "m.tcl"]);
    assert_eq!((status, out.as_str(), err.as_str()), (Some(0), "m.tcl: no mistakes\n", ""));
    place.write("m.tcl", format!("{MODEL}node x 0 0\n"));
    let (status, out, _) = place.run(&["check", "--json", "m.tcl"]);
    let found: serde_json::Value = serde_json::from_str(&out).unwrap();
    assert_eq!((status, &found["errors"], &found["messages"][0]["line"]), (Some(2), &1.into(), &11.into()), "{found}");
}

/// Nodes and elements that a recorder names and the model does not have, with the place of the tag. They may be defined
/// after the recorder.
#[test]
fn recorders_of_what_is_not_there() {
    let place = Place::new();
    let recorders = "recorder Element -file a.out -ele 1 77 force\nrecorder Node -file b.out -node 2 99 -dof 1 disp\n\
        recorder Drift -file c.out -iNode 1 -jNode 98 -dof 1 -perpDirn 2\nrecorder Node -file d.out -nodeRange 50 60 -dof 1 disp\n\
        region 5 -node 1 97\nrecorder Node -file e.out -node 8 -dof 1 disp\nnode 8 5 5\n";
    for analysis in ["", "fix 3 1 1 1\nfix 8 1 1 1\nanalysis Static\nanalyze 1\n", "wipe\n"] {
        place.write("m.tcl", format!("{MODEL}{recorders}{analysis}"));
        let (status, _, err) = place.run(&["check", "m.tcl"]);
        assert_eq!(status, Some(0), "{err}");
        for line in [
            "m.tcl:11:37: recorder: the model has no element 77",
            "m.tcl:12:35: recorder: the model has no node 99",
            "m.tcl:13:44: recorder: the model has no node 98",
            "m.tcl:14:38: recorder: no node from 50 to 60 has been defined",
            "m.tcl:15:1: region 5: the model has no node 97",
            "5 warnings:",
        ] {
            assert!(err.contains(line), "{line} after {analysis}: {err}");
        }
        assert_eq!(place.run(&["check", "--strict", "m.tcl"]).0, Some(2));
    }
}

/// Errors that follow from others are counted.
#[test]
fn errors_that_follow_are_counted() {
    let place = Place::new();
    let uses = "element truss 2 1 2 1. 5\nelement truss 3 1 2 1. 5\nrecorder Element -file a.out -ele 2 force\n";
    for (mistake, count) in [
        ("uniaxialMaterial Steel02 5 x 1 1", 2),
        ("uniaxialMateral Steel02 5 1 1 1", 2),
        ("proc build {} {\n  puts $nothing\n  uniaxialMaterial Elastic 5 1\n}\nbuild", 2),
        ("source nothing.tcl", 2),
    ] {
        place.write("m.tcl", format!("{MODEL}{mistake}\n{uses}"));
        let (status, _, err) = place.run(&["check", "m.tcl"]);
        assert_eq!(status, Some(2));
        assert!(
            err.contains("1 error:") && err.contains(&format!("{count} further errors follow")),
            "{mistake}: {err}"
        );
    }
}

/// A script that waits for what only a run has.
#[test]
fn ends() {
    let place = Place::new();
    place.write("m.tcl", "while {1} {}\n");
    let (status, _, err) = place.run(&["check", "m.tcl"]);
    assert!(
        status == Some(0) && err.contains("m.tcl:1:1: the check was stopped here, after 20 million commands"),
        "{err}"
    );
}
