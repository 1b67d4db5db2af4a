//! Help about text that looks right and is not, and the encodings of files.

use super::{error, interp};
use hysteron_tcl::Exception;
use hysteron_tcl::diagnostic::{Check, Diagnostic};

fn help(script: &str) -> String {
    error(&mut interp().0, script).diagnostic.help.join("\n")
}

#[test]
fn foreign_characters_are_named() {
    for (script, named) in [
        ("set x [expr {2 \u{2212} 1}]", "U+2212 is a minus sign, which Tcl does not know: write - in its place"),
        (
            "set x \u{201c}2\u{201d}\nexpr {$x * 2}",
            "U+201C is a curly quote, which Tcl does not know: write \" in its place",
        ),
        ("puts \u{201c}two words\u{201d}", "U+201C is a curly quote"),
        ("\u{a0}set x 1", "U+00A0 is a no-break space, which Tcl does not know: write an ordinary blank in its place"),
        ("set\u{200b} x 1", "U+200B is a zero-width space, which Tcl does not know: it cannot be seen: remove it"),
        ("incr i 08", "octal in Tcl, without the digits 8 and 9: write 8"),
        ("expr {08 + 1}", "octal in Tcl, without the digits 8 and 9: write 8"),
        ("if {1 &lt; 9} {puts a}", "\"&lt;\" is how a web page writes \"<\""),
        ("OpenSees > set x 1", "\"OpenSees >\" is the prompt of an interactive session: remove it"),
        ("% set x 1", "\"%\" is the prompt of an interactive session: remove it"),
        ("set k 40 # stiffness", "a comment after a command begins with \";#\""),
        ("source part\\p.tcl", "a backslash is no part of a path"),
        ("source part\\\\p.tcl", "a backslash is no part of a path"),
    ] {
        let help = help(script);
        assert_eq!(help.matches(named).count(), 1, "{script}: {help}");
    }
}

#[test]
fn other_mistakes_get_no_such_help() {
    for script in [
        "nosuch 1",
        "puts \"5\u{a0}m\"; nosuch",
        "expr {1 + foo}",
        "incr i abc",
        "source nothing.tcl",
        "set k 1 2",
        "set l {a # b}\nlindex $l x",
        "proc f {} {\n  # \u{2013} a dash\n  nosuch\n}\nf",
    ] {
        let help = help(script);
        assert!(help.is_empty() || help.starts_with("did you mean"), "{script}: {help}");
    }
}

#[test]
fn blank_behind_a_backslash() {
    let of = |line: usize| {
        format!("a blank follows the backslash at the end of line {line}, so that the command ends there")
    };
    assert!(help("set l {}\nset x 1 \\ \n  2\n").contains(&of(2)));
    assert!(help("set x \\\t\n  nosuch\n").contains(&of(1)));
    assert!(!help("# a comment \\ \n  nosuch\n").contains("backslash"));
    assert!(!help("set x \\\n  1 2\n").contains("backslash"));
}

/// Errors that a script catches cost no search for help.
#[test]
fn results_of_catch_stay_those_of_tcl() {
    let (mut i, ..) = interp();
    let caught = i.eval_str("t", "catch {expr {2 \u{2212} 1}} text; set text").unwrap();
    assert!(!caught.as_str().contains("U+2212"), "{}", &*caught.as_str());
}

#[test]
fn marks_of_encodings() {
    let (mut i, _, files) = interp();
    let wide = |order: fn(u16) -> [u8; 2]| "set x 1\n".encode_utf16().flat_map(order).collect::<Vec<u8>>();
    files.insert("/mark.tcl", "\u{feff}set x 5");
    assert_eq!(i.eval_file("/mark.tcl").unwrap().as_str(), "5");
    files.insert("/latin.tcl", b"set x \xe9".to_vec());
    assert_eq!(i.eval_file("/latin.tcl").unwrap().as_str(), "\u{e9}");
    let le = wide(u16::to_le_bytes);
    let be = wide(u16::to_be_bytes);
    for content in [[&[0xff, 0xfe][..], &le].concat(), [&[0xfe, 0xff][..], &be].concat(), le, be] {
        files.insert("/wide.tcl", content);
        let Err(Exception::Error(e)) = i.eval_file("/wide.tcl") else { panic!("no error") };
        assert_eq!(e.diagnostic.message, "couldn't read file \"/wide.tcl\": its text is encoded in UTF-16");
        assert!(e.diagnostic.help[0].contains("save it as UTF-8"));
    }
}

static EXAMPLE: Check = Check::new("example", "An example.", "None.");
static ONCE: Check = Check::new("once", "An example with one message at a place.", "None.").once();

/// A warning of a kind and a place is kept once, with the number of times.
#[test]
fn warnings_are_counted_by_kind_and_place() {
    let (mut i, ..) = interp();
    for time in 0..5 {
        let first = i.warn(Diagnostic::warning(&EXAMPLE, format!("at {time}")).label("returns -3"));
        assert_eq!(first.is_some(), time == 0);
    }
    i.warn(Diagnostic::warning(&EXAMPLE, "of another kind at 0").label("returns -3"));
    i.warn(Diagnostic::warning(&ONCE, "at 9"));
    i.warn(Diagnostic::warning(&ONCE, "at 10"));
    let all: Vec<(&str, usize)> = i.warnings.iter().map(|w| (w.message.as_str(), w.count)).collect();
    assert_eq!(all, [("at 0", 5), ("of another kind at 0", 1), ("at 9", 2)]);
    i.clear_warnings();
    assert!(i.warn(Diagnostic::warning(&EXAMPLE, "at 0").label("returns -3")).is_some());
}
