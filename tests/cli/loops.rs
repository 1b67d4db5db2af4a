//! Measures of loops in files.

use super::Place;
use std::f64::consts::{PI, TAU};

/// Cycles of an ellipse with growing amplitude, as a recorder with names writes it.
fn ellipse() -> String {
    let mut text = "time,u,F\n".to_owned();
    for i in 0..=400 {
        let (t, a) = (f64::from(i) / 100.0, [1.0, 2.0, 3.0, 4.0, 4.0][i as usize / 100]);
        let (s, c) = (TAU * t).sin_cos();
        text += &format!("{t},{},{}\n", a * s, a * (10.0 * s + 2.0 * c));
    }
    text
}

#[test]
fn tables_and_picture() {
    let place = Place::new();
    place.write("a.csv", ellipse());
    let columns = ["loops", "a.csv", "-u", "u", "-f", "3", "--time", "time", "--units", "kN", "mm"];
    let (status, out, err) = place.run(&columns);
    assert_eq!(status, Some(0), "{err}");
    assert_eq!(out.lines().count(), 2 + 4, "{out}");
    assert!(out.lines().nth(1).is_some_and(|l| l.contains("kN/mm")), "{out}");
    let (_, out, _) = place.run(&[&columns[..], &["--table", "json", "--svg", "a.svg"]].concat());
    let cycles: serde_json::Value = serde_json::from_str(&out).unwrap();
    for (i, a) in [1.0, 2.0, 3.0, 4.0].into_iter().enumerate() {
        let number = |name: &str| cycles[i][name].as_f64().unwrap();
        assert!((number("amplitude") - a).abs() < 1e-9 && (number("end") - (i + 1) as f64).abs() < 1e-9, "{out}");
        // The polygon of a hundred corners.
        assert!((number("E") / (PI * 2.0 * a * a) - 1.0).abs() < 2e-2, "{out}");
        assert!((number("xi") - 2.0 / (2.0 * 10f64.hypot(2.0))).abs() < 3e-3, "{out}");
    }
    let svg = std::fs::read_to_string(place.0.join("a.svg")).unwrap();
    assert!(["Force F [kN]", "Equivalent damping", "Amplitude of u [mm]"].iter().all(|w| svg.contains(w)));
    let (_, out, _) = place.run(&[&columns[..], &["--table", "csv", "--area", "2", "--thickness", "10"]].concat());
    assert!(out.starts_with("cycle,begin,end,amplitude [mm],F_max [kN]") && out.contains(",h_eq\n"), "{out}");
    let (_, out, _) = place.run(&["loops", "a.csv", "-u", "u", "F", "-f", "F", "u"]);
    assert!(out.starts_with("round") && out.lines().count() == 6, "{out}");
}

#[test]
fn several_files() {
    let place = Place::new();
    place.write("a.csv", ellipse());
    place.write("b.csv", ellipse().replace("time,u,F", "clock,u,F"));
    let columns = ["loops", "a.csv", "b.csv", "-u", "u", "-f", "F", "--units", "kN", "mm"];
    let (status, out, err) = place.run(&columns);
    assert!(
        status == Some(0) && out.trim_start().starts_with("file ") && out.lines().count() == 2 + 4 + 4,
        "{out}{err}"
    );
    assert!(out.lines().nth(5).is_some_and(|l| l.contains("a.csv")), "{out}");
    let (_, out, _) = place.run(&[&columns[..], &["--table", "json"]].concat());
    let cycles: serde_json::Value = serde_json::from_str(&out).unwrap();
    let files: Vec<&str> = cycles.as_array().unwrap().iter().filter_map(|c| c["file"].as_str()).collect();
    assert_eq!(files, ["a.csv", "a.csv", "a.csv", "a.csv", "b.csv", "b.csv", "b.csv", "b.csv"]);
    // One file has no such column.
    let (_, out, _) = place.run(&["loops", "a.csv", "-u", "u", "-f", "F", "--table", "csv"]);
    assert!(out.starts_with("cycle,"), "{out}");
}

#[test]
fn refused() {
    let place = Place::new();
    place.write("a.csv", ellipse());
    place.write("b.out", "0 1\n1 nan\n");
    for (args, message) in [
        (&["a.csv", "-u", "v", "-f", "F"][..], "there is no column \"v\": they are time, u, F"),
        (&["b.out", "-u", "1", "-f", "2"], "row 2 (line 2) of column \"2\" is not finite"),
        (&["c.out", "-u", "1", "-f", "2"], "cannot read \"c.out\""),
        (&["a.csv", "-u", "1", "2", "-f", "2"], "2 columns of displacements, but 1 of forces"),
        (&["a.csv", "-u", "u", "-f", "F", "--area", "1", "--thickness", "0"], "the thickness is 0"),
        (&["a.csv", "c.out", "-u", "1", "-f", "2"], "cannot read \"c.out\""),
        (
            &["a.csv", "a.csv", "-u", "u", "-f", "F", "--svg", "a.svg"],
            "--svg draws the loops of one file, and there are 2",
        ),
    ] {
        let (status, out, err) = place.run(&[&["loops"], args].concat());
        assert!(status == Some(2) && out.is_empty() && err.contains(message), "{args:?}: {err}");
    }
}
