//! Scripts as word processors, web pages, other systems and other languages leave them: what is wrong is named at its place.

use super::{MODEL, Place};

const RUN: &str = "fix 3 1 1 1\nconstraints Plain\nintegrator LoadControl 1\nalgorithm Linear\nanalysis Static\nanalyze 1\n\
    puts [nodeDisp 2 1]\n";

fn said(script: impl AsRef<[u8]>) -> (Option<i32>, String) {
    let place = Place::new();
    place.write("m.tcl", script);
    let (status, out, err) = place.run(&["run", "m.tcl"]);
    (status, out + &err)
}

/// Refused, with all of these words.
fn refused(script: impl AsRef<[u8]>, words: &[&str]) {
    let (status, said) = said(&script);
    assert_eq!(status, Some(2), "{said}");
    words.iter().for_each(|w| assert!(said.contains(w), "{w}: {said}"));
}

/// Runs as [`MODEL`] does: F L/(E A) = 4/(2e8 · 0.1).
fn runs(script: impl AsRef<[u8]>) {
    let (status, said) = said(script);
    let disp: f64 = said.trim().parse().unwrap_or_else(|e| panic!("{e}: {said}"));
    assert!(status == Some(0) && (disp - 2e-7).abs() < 1e-20, "{said}");
}

#[test]
fn byte_order_marks_and_line_ends() {
    runs(format!("\u{feff}{MODEL}{RUN}"));
    let windows = format!("\u{feff}{MODEL}{RUN}").replace("zeroLength", "x").replace("0.1 2e8", "\\\n 0.1 2e8");
    runs(windows.replace('\n', "\r\n"));
    let wide = |order: fn(u16) -> [u8; 2], mark: &[u8]| {
        let text: Vec<u8> = MODEL.encode_utf16().flat_map(order).collect();
        [mark, &text].concat()
    };
    for script in [
        wide(u16::to_le_bytes, &[0xff, 0xfe]),
        wide(u16::to_be_bytes, &[0xfe, 0xff]),
        wide(u16::to_le_bytes, &[]),
        wide(u16::to_be_bytes, &[]),
    ] {
        refused(script, &["couldn't read file \"m.tcl\": its text is encoded in UTF-16", "save it as UTF-8"]);
    }
    let place = Place::new();
    place.write("gm.txt", wide(u16::to_le_bytes, &[0xff, 0xfe]));
    place.write("m.tcl", format!("{MODEL}timeSeries Path 2 -dt 0.1 -filePath gm.txt\n"));
    let (status, _, err) = place.run(&["run", "m.tcl"]);
    assert!(status == Some(2) && err.contains("encoded in UTF-16") && err.contains("m.tcl:11:"), "{err}");
}

/// Characters that look like others, in words, in values and in expressions.
#[test]
fn lookalikes() {
    for (line, named) in [
        ("node 4 0 \u{2212}1", "U+2212 is a minus sign"),
        ("node 4 0 \u{2013}1", "U+2013 is an en dash"),
        ("set x \u{2212}1\nnode 4 0 $x", "U+2212 is a minus sign"),
        ("node 4 0\u{a0}1", "U+00A0 is a no-break space"),
        ("\u{a0}node 4 0 1", "U+00A0 is a no-break space"),
        ("node\u{200b} 4 0 1", "U+200B is a zero-width space"),
        ("node 4 0 1\u{200b}", "U+200B is a zero-width space"),
        ("puts \u{201c}two words\u{201d}", "U+201C is a curly quote"),
        ("set x [expr {2 \u{2212} 1}]", "U+2212 is a minus sign"),
        ("set x \u{201c}2\u{201d}\nset y [expr {$x * 2}]", "U+201C is a curly quote"),
        ("node 08 0 1", "octal in Tcl, without the digits 8 and 9: write 8"),
        ("set n 09\nnode $n 0 1", "octal in Tcl, without the digits 8 and 9: write 9"),
        ("set x [expr {08 + 1}]", "octal in Tcl"),
        ("puts &#91;nodeDisp 2 1&#93;", "\"&#91;\" is how a web page writes \"[\""),
        ("if {$tcl_version &lt; 9} {puts a}", "\"&lt;\" is how a web page writes \"<\""),
        ("OpenSees > fix 3 1 1 1", "\"OpenSees >\" is the prompt of an interactive session"),
        ("% fix 3 1 1 1", "\"%\" is the prompt of an interactive session"),
        ("set k 40 # stiffness", "a comment after a command begins with \";#\""),
        ("source part\\p.tcl", "a backslash is no part of a path"),
        ("source part\\\\p.tcl", "a backslash is no part of a path"),
    ] {
        let (status, said) = said(format!("{MODEL}{line}\n"));
        assert!(status == Some(2) && said.contains(named), "{line}: {said}");
        assert!(said.matches(named).count() == 1, "{line}: {said}");
    }
    // Texts may hold them.
    let (status, said) = said(format!("{MODEL}puts \"5\u{a0}m \u{2212} \u{201c}a\u{201d}\" ;# \u{2013}\n"));
    assert_eq!((status, said.as_str()), (Some(0), "5\u{a0}m \u{2212} \u{201c}a\u{201d}\n"));
    // A mistake of another kind gets no such help.
    let (_, other) = self::said(format!("{MODEL}node 4 x 0\n"));
    assert!(!other.contains("U+") && !other.contains("octal") && !other.contains("backslash"), "{other}");
}

#[test]
fn blank_behind_a_backslash() {
    let broken = "element truss 2 1 2 \\ \n  1. 1\n";
    refused(format!("{MODEL}{broken}"), &["a blank follows the backslash at the end of line 11", "remove the blank"]);
    let fine = format!("{MODEL}# a comment \\ \nelement truss 2 1 2 \\\n  1. x\n");
    let (status, said) = said(fine);
    assert!(status == Some(2) && !said.contains("blank follows"), "{said}");
}

#[test]
fn scripts_in_python() {
    let python = "# frame\nimport openseespy.opensees as ops\nops.wipe()\nops.model('basic', '-ndm', 2)\n";
    let place = Place::new();
    for (name, text) in [("m.tcl", python), ("m.py", "ops.wipe()\n")] {
        place.write(name, text);
        for command in ["run", "check"] {
            let (status, _, err) = place.run(&[command, name]);
            assert!(status == Some(2) && err.contains(&format!("\"{name}\" is a script in Python")), "{err}");
            assert!(err.contains("import hysteron.opensees as ops") && err.matches("error").count() == 1, "{err}");
        }
    }
    place.write("m.tcl", python);
    assert!(place.run(&["run", "m.tcl"]).2.contains("m.tcl:2:1"));
}

#[test]
fn pattern_without_its_series() {
    for body in ["{load 2 1 0 0}", "{\n  load 2 1 0 0\n}", "{}", "{eleLoad -ele 1 -type -beamUniform 1}"] {
        refused(format!("{MODEL}pattern Plain 2 {body}\n"), &["m.tcl:11:17", "the time series is missing"]);
    }
    refused(format!("{MODEL}pattern Plain 2 Liner {{load 2 1 0 0}}\n"), &["m.tcl:11:17", "did you mean \"Linear\"?"]);
    let (status, said) = said(format!("{MODEL}pattern Plain 2 Linear\npattern Plain 3 1\n"));
    assert_eq!((status, said.as_str()), (Some(0), ""));
}

/// Lists of numbers that are none: nested, with commas, with a word in them; all forms that OpenSees takes stay.
#[test]
fn values_of_a_path() {
    let path = |values: &str| format!("{MODEL}set v {{0 1 2}}\ntimeSeries Path 2 -dt 0.1 -values {values}\n");
    for (values, named) in [
        ("[list $v]", "it is a list of lists"),
        ("\"0.0, 0.3, -0.5\"", "no commas"),
        ("{0 1 x}", "element 3 of the list is no number: \"x\""),
        ("{0 1 \u{2212}2}", "U+2212 is a minus sign"),
    ] {
        refused(path(values), &["m.tcl:12:35", named, "not a list of numbers"]);
    }
    for values in ["$v", "{0 1 2}", "\"0 1 2\"", "0 1 2", "{*}$v", "$v -factor 2"] {
        let (status, said) = said(path(values));
        assert_eq!((status, said.as_str()), (Some(0), ""), "{values}");
    }
}

/// A file of a ground motion where a list of numbers belongs.
#[test]
fn record_with_a_header() {
    let place = Place::new();
    place.write(
        "gm.at2",
        "PEER NGA\nA, 1/1/2000, B, 90\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS= 3, DT= .0100 SEC\n0.1 0.2 0.3\n",
    );
    place.write("m.tcl", format!("{MODEL}timeSeries Path 2 -dt 0.01 -filePath gm.at2\n"));
    let (status, _, err) = place.run(&["run", "m.tcl"]);
    assert!(status == Some(2) && err.contains("gm.at2:1:1") && err.contains("\"motionFile $series gm.at2\""), "{err}");
    place.write("gm.at2", "no record\n");
    let (_, _, err) = place.run(&["run", "m.tcl"]);
    assert!(err.contains("remove the header lines") && !err.contains("motionFile"), "{err}");
}

/// The part of a response that is wrong, and what it should be.
#[test]
fn misspelt_parts_of_responses() {
    let beam = "model basic -ndm 2 -ndf 3\nnode 1 0 0\nnode 2 4 0\nfix 1 1 1 1\nuniaxialMaterial Elastic 1 100.\n\
        section Fiber 1 {patch rect 1 2 1 -1 -1 1 1}\ngeomTransf Linear 1\nelement forceBeamColumn 1 1 2 3 1 1\n";
    for (words, column, near) in [
        ("section 1 fibre 0 0 stress", 11, "did you mean \"fiber\"?"),
        ("section 1 fiber 0 0 stres", 21, "did you mean \"stress\"?"),
        ("sectoin 1 force", 1, "did you mean \"section\"?"),
        ("section 1 forse", 11, "did you mean \"force\"?"),
        ("section 9 force", 9, "known after \"section\": force"),
        ("locelForce", 1, "did you mean \"localForce\"?"),
    ] {
        for (command, before) in [("eleResponse 1 ", 14), ("recorder Element -file a.out -ele 1 ", 36)] {
            let place = Place::new();
            place.write("m.tcl", format!("{beam}{command}{words}\n"));
            let (_, _, err) = place.run(&["run", "m.tcl"]);
            let at = format!("m.tcl:9:{}", before + column);
            assert!(err.contains(&at) && err.contains(near), "{command}{words}: {at} {near}: {err}");
        }
    }
    let place = Place::new();
    place.write("m.tcl", format!("{beam}puts [llength [eleResponse 1 section 1 fiber 0 0 stressStrain]]\n"));
    assert_eq!(place.run(&["run", "--strict", "m.tcl"]), (Some(0), "2\n".into(), String::new()));
}

/// One message for a recorder of many elements, and one for a place, however often it comes up.
#[test]
fn one_warning_for_a_kind_and_a_place() {
    let place = Place::new();
    let chain = "model basic -ndm 1 -ndf 1\nnode 0 0\nfix 0 1\nuniaxialMaterial Elastic 1 100.\n\
        for {set i 1} {$i <= 900} {incr i} {\n  node $i 0\n  element zeroLength $i 0 $i -mat 1 -dir 1\n}\n";
    let run =
        "integrator LoadControl 1\nalgorithm Linear\nanalysis Static\nfor {set i 0} {$i < 300} {incr i} {analyze 1}\n";
    let early = format!("{chain}recorder Element -file a.out -eleRange 1 900 forse\n{run}");
    let late = format!("recorder Element -file a.out -ele all forse\n{chain}{run}");
    for script in [early, late.replacen("recorder", "model basic -ndm 1 -ndf 1\nrecorder", 1)] {
        place.write("m.tcl", script);
        let (status, _, err) = place.run(&["run", "m.tcl"]);
        assert!(status == Some(0) && err.len() < 1500 && err.contains("1 warning:"), "{} {err}", err.len());
        assert!(err.contains("no response \"forse\""), "{err}");
    }
    place.write(
        "m.tcl",
        format!("{chain}for {{set i 0}} {{$i < 500}} {{incr i}} {{\n  node [expr {{2000 + $i}}] 0 -wrong $i\n}}\n"),
    );
    let (status, _, err) = place.run(&["run", "m.tcl"]);
    assert!(status == Some(0) && err.len() < 1500 && err.contains("500 warnings:"), "{err}");
    assert!(err.contains("(500 times)") && err.matches("-wrong").count() == 3, "{err}");
}
