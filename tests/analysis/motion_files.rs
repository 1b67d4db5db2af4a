//! Time series from measured files.

use super::close;
use super::script::Script;

/// The forms of motion files give the same series, and say step and count.
#[test]
fn motion_files_are_read() {
    let peer = "PEER STRONG MOTION DATABASE RECORD\nSOMEWHERE 01/01/00\nACCELERATION TIME HISTORY IN UNITS OF G\n\
                NPTS=   4, DT= .0200 SEC\n 0.1E+00 0.2\n -0.3 0.4\n";
    let old = "a\nb\nc\n    4    0.0200    NPTS, DT\n0.1 0.2 -0.3 0.4\n";
    let v2 = "header\n    4 points of accel data equally spaced at  .020 sec, in cm/sec2\n\
              \x20     .100      .200     -.300      .400\n    4 points of veloc data\n      .1\n";
    for text in [peer, old, v2, "0.00 0.1\n0.02 0.2\n0.04 -0.3\n0.06 0.4\n", "0.1\n0.2\n-0.3\n0.4\n"] {
        let ran = Script::default().with_file("m.txt", text).run(
            "lassign [motionFile 1 m.txt -factor 2.0 -dt 0.02] dt n
            puts \"$dt $n\"
            model basic -ndm 1 -ndf 1
            pattern Plain 1 1 {}
            setTime 0.05
            puts [getLoadFactor 1]",
        );
        let ran = ran.done();
        let numbers = ran.numbers();
        assert_eq!(numbers[..2], [0.02, 4.0], "{text}");
        assert!(close(numbers[2], 0.1, 1e-9), "{text}: {numbers:?}");
    }
    let short = Script::default().with_file("m.txt", &peer.replace("4,", "9,")).run("motionFile 1 m.txt");
    assert!(short.error().message.contains("9 values"), "{:?}", short.error());
}

/// A measured file in a Path: its step or its times, in the unit that is asked for.
#[test]
fn paths_take_measured_files() {
    let peer = "PEER STRONG MOTION DATABASE RECORD\nSOMEWHERE 01/01/00\nACCELERATION TIME HISTORY IN UNITS OF G\n\
                NPTS=   4, DT= .0200 SEC\n 0.1E+00 0.2\n -0.3 0.4\n";
    let table = "time[s],acc[g]\n0,0.1\n0.02,0.2\n0.04,-0.3\n0.07,0.4\n";
    let factor = |text: &str, options: &str, time: f64| {
        let ran = Script::default().with_file("m.txt", text).run(&format!(
            "timeSeries Path 1 -fileMotion m.txt {options}
            model basic -ndm 1 -ndf 1
            pattern Plain 1 1 {{}}
            setTime {time}
            puts [getLoadFactor 1]"
        ));
        ran.done().numbers()[0]
    };
    for (text, options, time, expected) in [
        (peer, "", 0.05, 0.05),
        (peer, "-factor 2.0 -dt 0.02", 0.05, 0.1),
        (peer, "-to m/s2", 0.02, 0.2 * 9.80665),
        (peer, "-startTime 1.0 -prependZero", 1.04, 0.2),
        (table, "-to cm/s2", 0.055, 0.05 * 980.665),
    ] {
        let got = factor(text, options, time);
        assert!(close(got, expected, 1e-9), "{options}: {got}");
    }
    for (options, said) in [
        ("-dt 0.01", "the file gives the step 0.02 s"),
        ("-to kN", "g is an acceleration"),
        ("-unit m/s2", "told to be in m/s2"),
        ("-values {1 2}", "its own values"),
        ("-quantity velocity", "acceleration"),
    ] {
        let ran =
            Script::default().with_file("m.txt", peer).run(&format!("timeSeries Path 1 -fileMotion m.txt {options}"));
        assert!(ran.error().message.contains(said), "{options}: {}", ran.error().message);
    }
}

/// A statement that a file lacks is asked for in the words of the command, and one of several channels is never taken silently.
#[test]
fn files_ask_in_the_words_of_the_script() {
    let list = "0.1\n0.2\n-0.3\n";
    let two = "time[s],acc N[g],acc E[g]\n0,1,2\n0.1,2,3\n0.2,1,0\n";
    let side: String = (0..40).map(|i| format!("{} {} 5\n", i % 2, 100 + i % 2)).collect();
    for (text, options, said) in [
        (list, "", "the file gives no step of time: add -dt"),
        (list, "-dt 0.1 -to m/s2", "the file gives no unit of its values: a conversion needs it: add -unit"),
        (list, "-dt 0.1 -unit gg", "did you mean"),
        (two, "", "there are 2 channels: say -channel with one of acc N, acc E"),
        (two, "-channel acc", "there is no channel \"acc\": they are acc N, acc E"),
        (&side, "-dt 0.1", "add -layout"),
        (&side, "-dt 0.1 -layout rows", "is no layout"),
    ] {
        let ran = Script::default().with_file("m.txt", text).run(&format!("motionFile 1 m.txt {options}"));
        assert!(ran.error().message.contains(said), "{options}: {}", ran.error().message);
    }
    for (text, options) in [(two, "-channel 2"), (two, "-channel {acc E}"), (&side, "-dt 0.1 -layout wrapped")] {
        let ran = Script::default().with_file("m.txt", text).run(&format!("puts [motionFile 1 m.txt {options}]"));
        assert_eq!(ran.done().numbers().len(), 2, "{options}");
    }
}
