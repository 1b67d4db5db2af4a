//! Measured files through the program: what is shown, converted, asked for and refused.

use super::Place;
use hysteron::recordings::FORMATS;

/// A PEER file of a sine of 2 Hz: quantity, unit and step as they are written.
fn peer(statement: &str, counts: &str, amplitude: f64) -> String {
    let values: String = (0..200)
        .map(|i| format!("{:.7E}\n", amplitude * (std::f64::consts::TAU * 0.02 * f64::from(i)).sin()))
        .collect();
    format!("PEER NGA STRONG MOTION DATABASE RECORD\nA, 1/1/2000, B, 090\n{statement}\n{counts}\n{values}")
}

const ACCELERATION: &str = "ACCELERATION TIME SERIES IN UNITS OF G";

#[test]
fn a_velocity_is_no_motion_unless_it_is_differentiated() {
    let place = Place::new();
    place.write("a.AT2", peer(ACCELERATION, "NPTS= 200, DT= .0100 SEC", 0.3));
    // The velocity of an acceleration of 0.3 g at 2 Hz has the amplitude 0.3 g / (4 pi).
    let v = 0.3 * 980.665 / (2.0 * std::f64::consts::TAU);
    place.write("a.VT2", peer("VELOCITY TIME SERIES IN UNITS OF CM/S", "NPTS= 200, DT= .0100 SEC", v));
    let (status, _, err) = place.run(&["motions", "a.VT2"]);
    assert!(status == Some(2) && err.contains("velocities in cm/s"), "{err}");
    let pga = |args: &[&str]| {
        let (status, out, err) = place.run(&[args, &["--json"]].concat());
        assert_eq!(status, Some(0), "{err}");
        let json: serde_json::Value = serde_json::from_str(&out).unwrap();
        json["motions"][0]["PGA"].as_f64().unwrap_or_else(|| panic!("{out}"))
    };
    let direct = pga(&["motions", "a.AT2"]);
    let derived = pga(&["motions", "a.VT2", "--differentiate"]);
    assert!((direct - 0.3).abs() < 0.003 && (derived / direct - 1.0).abs() < 0.01, "{direct} {derived}");
}

#[test]
fn steps_are_those_of_their_units() {
    let place = Place::new();
    for (counts, step) in [
        ("NPTS= 200, DT= 10.0 MSEC", Some("steps of 0.01 s")),
        ("DT= 1.0E-02 SEC, NPTS=200", Some("steps of 0.01 s")),
        ("NPTS= 200, DT= .005-.020 SEC", None),
        ("NPTS= 200, DT= .01 MIN", Some("steps of 0.6 s")),
        ("NPTS= 200, DT= .01 TICKS", None),
    ] {
        place.write("a.AT2", peer(ACCELERATION, counts, 0.3));
        let (status, out, err) = place.run(&["recording", "a.AT2"]);
        match step {
            Some(step) => assert!(status == Some(0) && out.contains(step), "{counts}: {out}{err}"),
            None => assert!(status == Some(2) && err.contains("step"), "{counts}: {err}"),
        }
    }
    let table = |head: &str, factor: f64| {
        (0..50).fold(head.to_owned(), |s, i| s + &format!("{},{}\n", factor * f64::from(i), (0.3 * f64::from(i)).sin()))
    };
    for (head, factor) in [("time_ms,acc_g\n", 10.0), ("time[s],acc_g\n", 0.01), ("Zeit (min),acc_g\n", 0.01 / 60.0)] {
        place.write("t.csv", table(head, factor));
        let (_, out, err) = place.run(&["recording", "t.csv"]);
        let step = out.split("in steps of ").nth(1).and_then(|w| w.split(' ').next()?.parse::<f64>().ok());
        assert!(
            step.is_some_and(|dt| (dt / 0.01 - 1.0).abs() < 1e-9) && out.contains("acceleration"),
            "{head}: {out}{err}"
        );
    }
}

#[test]
fn what_is_not_said_is_asked_for() {
    let place = Place::new();
    place.write("list.txt", "first\n0.1 0.2 0.3\n0.4 0.5\n");
    place.write("side.txt", (0..40).map(|i| format!("{} {} 5\n", i % 2, 100 + i % 2)).collect::<String>());
    place.write("vel.csv", "time[s],vel_m/s\n0,0\n0.1,1\n0.2,0\n");
    place.write("gap.csv", "time[s],acc_g\n0,0\n0.01,1\n0.02,0\n0.5,1\n");
    place.write("cell.csv", "time[s],acc_g\n0,0\n0.01,\n0.02,0\n");
    place.write("word.txt", "0.1\n0.2\npage 2\n0.3\n");
    for (args, said) in [
        (&["list.txt"][..], "add --dt; the header is \"first\""),
        (&["list.txt", "--dt", "0.01"], "add --unit"),
        (&["side.txt", "--dt", "0.01", "--unit", "g"], "--layout"),
        (&["vel.csv", "--unit", "m/s2"], "the file says velocity"),
        (&["gap.csv"], "row 4 (line 5) follows after 0.48 s, the step is 0.01 s"),
        (&["cell.csv"], "row 2 (line 3) of acc is missing"),
        (&["word.txt", "--dt", "0.01", "--unit", "g"], "line 3: \"page\" is not a number"),
    ] {
        let (status, out, err) = place.run(&[&["motions"], args].concat());
        assert!(status == Some(2) && out.is_empty() && err.contains(said), "{args:?}: {err}");
    }
    let (status, _, err) = place.run(&["motions", "list.txt", "--dt", "0.01", "--unit", "g"]);
    assert_eq!(status, Some(0), "{err}");
}

#[test]
fn usual_motions_raise_no_doubt() {
    let place = Place::new();
    place.write("a.AT2", peer(ACCELERATION, "NPTS= 200, DT= .0100 SEC", 0.3));
    assert_eq!(
        (place.run(&["motions", "a.AT2"]).2, place.run(&["recording", "a.AT2"]).2),
        (String::new(), String::new())
    );
    place.write("a.AT2", peer(ACCELERATION, "NPTS= 150, DT= .0100 SEC", 15.0));
    let err = place.run(&["motions", "a.AT2"]).2;
    assert!(err.contains("says 150 values, but there are 200") && err.contains("as velocities in cm/s"), "{err}");
    let err = place.run(&["recording", "a.AT2"]).2;
    assert!(err.contains("as velocities in cm/s"), "{err}");
    // A step over 0.1 s, a record over an hour, and a peak under 0.0001 g.
    for (counts, amplitude, said) in [
        ("NPTS= 200, DT= .2000 SEC", 0.3, "the step is 0.2 s"),
        ("NPTS= 200, DT= 20.0 SEC", 0.3, "the record takes"),
        ("NPTS= 200, DT= .0100 SEC", 1e-5, "is the unit right?"),
    ] {
        place.write("a.AT2", peer(ACCELERATION, counts, amplitude));
        let err = place.run(&["motions", "a.AT2"]).2;
        assert!(err.contains(said), "{counts}: {err}");
    }
}

#[test]
fn forms_are_written_and_read_back() {
    let place = Place::new();
    place.write("a.AT2", peer(ACCELERATION, "NPTS= 200, DT= .0100 SEC", 0.3));
    for out in ["a.csv", "a.txt", "a.npz"] {
        let (status, said, err) = place.run(&["recording", "a.AT2", "--to", "m/s2", "--out", out]);
        assert!(status == Some(0) && said.contains("written"), "{err}");
    }
    let (_, shown, _) = place.run(&["recording", "a.csv"]);
    assert!(shown.contains("m/s2") && shown.contains("in steps of 0.01"), "{shown}");
    let (_, list, _) = place.run(&["recording", "a.txt", "--dt", "0.01", "--unit", "m/s2"]);
    let peak = |text: &str| text.lines().find(|l| l.trim_start().starts_with("peak")).map(str::to_owned);
    assert_eq!(peak(&shown), peak(&list));
    let (_, formats, _) = place.run(&["recording", "--formats"]);
    let page = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/docs/reference/recordings.md")).unwrap();
    for f in FORMATS {
        assert!(formats.contains(f.name) && formats.contains(f.description), "{}", f.name);
        assert!(page.contains(&format!("| {} | {} |", f.name, f.recognised_by.replace('|', "\\|"))), "{}", f.name);
    }
}

/// A conversion says what it did: baseline, rule, last value.
#[test]
fn conversions_state_the_baseline() {
    let place = Place::new();
    let rows = (0..=100).fold("time[s],acc[m/s2]\n".to_owned(), |s, i| {
        s + &format!("{:.2},{}\n", 0.01 * f64::from(i), 2.0 + 0.01 * f64::from(i))
    });
    place.write("a.csv", rows);
    for (args, said) in [
        (
            &["--integrate"][..],
            "baseline not corrected; integrated from 0 by the trapezoidal rule; the last value is 2.5000e0 m/s",
        ),
        (&["--integrate", "--baseline", "mean"], "mean removed: 2.5000e0 m/s2; integrated"),
        (
            &["--baseline", "line", "--integrate"],
            "line of least squares removed: from 2.0000e0 m/s2 to 3.0000e0 m/s2; integrated",
        ),
        (&["--baseline", "mean"], "mean removed: 2.5000e0 m/s2"),
        (&["--factor", "-2"], "multiplied by -2"),
    ] {
        let (status, out, err) = place.run(&[&["recording", "a.csv"], args].concat());
        assert!(status == Some(0) && out.contains(said), "{args:?}: {out}{err}");
    }
    assert!(!place.run(&["recording", "a.csv"]).1.contains("converted"));
}

#[test]
fn tables_of_test_machines_are_measured() {
    let place = Place::new();
    let rows = |gap: &str, end: &str| {
        (0..=200).fold(String::new(), |s, i| {
            let (y, x) = (std::f64::consts::TAU * f64::from(i) / 100.0).sin_cos();
            s + &format!("{:.3}{gap}{y:.6}{gap}{:.6}{end}\n", f64::from(i) / 100.0, 10.0 * y + 2.0 * x)
        })
    };
    let comma = |text: String| text.replace('.', ",");
    place.write(
        "mts.txt",
        format!(
            "MTS793|MPT|ENU|1|2|.|/|:|1|0|0|A\n\nData: Timed\t\tTime: 8.0 Sec\n\nTime\tDisp\tForce\nSec\tmm\tkN\n{}",
            rows("\t", "")
        ),
    );
    place.write("excel.csv", format!("time,Disp,Force,,\n{}", rows(",", ",,")));
    place.write("german.csv", format!("Zeit [s];Disp [mm];Force (kN)\n{}", comma(rows(";", ""))));
    place.write(
        "a.lvm",
        format!(
            "LabVIEW Measurement\t\nSeparator\tTab\nDecimal_Separator\t,\n***End_of_Header***\t\n\nChannels\t2\n\
             ***End_of_Header***\nX_Value\tDisp\tForce\tComment\n{}",
            comma(rows("\t", ""))
        ),
    );
    let of = |file: &str| place.run(&["loops", file, "-u", "Disp", "-f", "Force"]);
    let (status, expected, err) = of("mts.txt");
    assert!(status == Some(0) && expected.lines().count() >= 3, "{expected}{err}");
    for file in ["excel.csv", "german.csv", "a.lvm"] {
        assert_eq!(of(file).1, expected, "{file}: {}", of(file).2);
    }
    place.write("a.json", "{\"Disp\":[1,2],\"Force\":[1,2]}");
    place.write("a.xlsx", b"PK\x03\x04not really");
    assert!(of("a.xlsx").2.contains("xlsx"));
    let (status, _, err) = place.run(&["loops", "a.json", "-u", "x", "-f", "Force"]);
    assert!(status == Some(2) && err.contains("they are Disp, Force"), "{err}");
}

#[test]
fn what_is_told_is_compared_with_the_file() {
    let place = Place::new();
    place.write("a.AT2", peer(ACCELERATION, "NPTS= 200, DT= .0100 SEC", 0.3));
    let table = (0..50).fold("time[s],acc_g\n".to_owned(), |s, i| {
        s + &format!("{:.2},{}\n", 0.01 * f64::from(i), (0.3 * f64::from(i)).sin())
    });
    place.write("t.csv", table);
    for file in ["a.AT2", "t.csv"] {
        let (status, _, err) = place.run(&["motions", file, "--dt", "0.02"]);
        assert!(status == Some(2) && err.contains("0.02 s"), "{file}: {err}");
        let (status, _, err) = place.run(&["motions", file, "--dt", "0.01", "--unit", "g"]);
        assert!(status == Some(0) && !err.contains("told"), "{file}: {err}");
        let (status, _, err) = place.run(&["motions", file, "--unit", "m/s2"]);
        assert!(status == Some(2) && err.contains("the file says g for"), "{file}: {err}");
        let (status, _, err) = place.run(&["recording", file, "--unit", "m/s2"]);
        assert!(status == Some(2) && err.contains("the file says g for"), "{file}: {err}");
        assert_eq!(place.run(&["recording", file, "--unit", "g"]).0, Some(0), "{file}");
    }
}

#[test]
fn an_isolation_study_takes_no_velocity_for_an_acceleration() {
    let inputs = concat!(env!("CARGO_MANIFEST_DIR"), "/tcl-like-inputs/isolation_study");
    let text = |file: &str| std::fs::read_to_string(format!("{inputs}/{file}")).unwrap();
    let place = Place::new();
    place.write("building.tcl", text("building.tcl"));
    place.write("a.VT2", peer("VELOCITY TIME SERIES IN UNITS OF CM/S", "NPTS= 200, DT= .0100 SEC", 23.4));
    let study = text("study.toml");
    let (before, rest) = study.split_once("[[motion]]").unwrap();
    let after = rest.split_once("[intensity]").map_or("", |(_, rest)| rest);
    let with = |keys: &str| format!("{before}[[motion]]\nfiles = [\"a.VT2\"]\n{keys}\n[intensity]{after}");
    for (keys, status, said) in [
        ("", 2, "velocities in cm/s"),
        ("unit = \"g\"", 2, "velocity"),
        ("differentiate = true\ndt = 0.02", 2, "0.02 s"),
        ("differentiate = true\ndt = 0.01", 0, ""),
    ] {
        place.write("study.toml", with(keys));
        let (ended, out, err) = place.run(&["check", "study.toml"]);
        assert!(ended == Some(status) && err.contains(said), "{keys}: {out}{err}");
    }
}

#[test]
fn headers_of_diadem_are_read_with_the_file_beside_them() {
    let place = Place::new();
    let channel = |name: &str, unit: &str, first: usize| {
        format!(
            "#BEGINCHANNELHEADER\n200,{name}\n202,{unit}\n210,EXPLICIT\n211,a.R64\n213,CHANNEL\n214,REAL64\n220,3\n\
             221,{first}\n240,0\n241,1\n#ENDCHANNELHEADER\n"
        )
    };
    place.write("a.DAT", channel("Time", "s", 1) + &channel("Force", "kN", 4));
    let values = [0.0f64, 0.5, 1.0, 3.0, -7.0, 2.0];
    let (status, _, err) = place.run(&["recording", "a.DAT"]);
    assert!(status == Some(2) && err.contains("\"a.R64\", which is not beside it"), "{err}");
    place.write("a.R64", values.iter().flat_map(|x| x.to_le_bytes()).collect::<Vec<u8>>());
    let (status, out, err) = place.run(&["recording", "a.DAT", "--out", "a.csv"]);
    assert!(status == Some(0) && out.contains("-7 kN at 0.5 s") && out.contains("steps of 0.5 s"), "{out}{err}");
    let (_, _, err) = place.run(&["loops", "a.DAT", "-u", "Force", "-f", "Force"]);
    assert!(!err.contains("beside"), "{err}");
    place.write(
        "s.tcl",
        "puts [columns a.DAT]\nlassign [motionFile 1 a.DAT -channel Force -to N] dt n\nputs \"$dt $n\"\n",
    );
    let (status, out, err) = place.run(&["run", "s.tcl"]);
    assert!(status == Some(0) && out.contains("{3.0 -7.0 2.0}") && out.contains("0.5 3"), "{out}{err}");
}
