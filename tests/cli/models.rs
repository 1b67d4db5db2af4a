//! Devices of `models/`: every file runs.

use super::Place;
use std::fs;
use std::path::Path;

/// A file with a procedure of its own name is a device, and is driven by itself; others are run.
#[test]
fn every_file_runs() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("models");
    let mut files: Vec<_> = fs::read_dir(&folder).unwrap().map(|f| f.unwrap().path()).collect();
    files.retain(|f| f.extension().is_some_and(|e| e == "tcl"));
    assert!(files.len() > 2, "{files:?}");
    for file in files {
        let (name, stem) = (file.to_str().unwrap(), file.file_stem().unwrap().to_str().unwrap());
        let device = fs::read_to_string(&file).unwrap().contains(&format!("\nproc {stem} "));
        let place = Place::new();
        let (status, out, err) = if device {
            place.run(&[
                "bearing",
                "--strict",
                name,
                "-a",
                "0.02,0.04",
                "-n",
                "1",
                "-P",
                "5e4",
                "--steps",
                "40",
                "--table",
                "csv",
            ])
        } else {
            place.run(&["run", "--strict", name])
        };
        assert_eq!(status, Some(0), "{name}: {err}");
        if !device {
            continue;
        }
        // Two cycles that take energy, the larger one more.
        let energies: Vec<f64> = out.lines().skip(1).map(|l| l.split(',').nth(7).unwrap().parse().unwrap()).collect();
        assert!(energies.len() == 2 && energies[0] > 0.0 && energies[1] > energies[0], "{name}: {out}");
    }
}

/// The modulus in compression of the RR-FRB (Eqs 2 and 3), and the parameters of Grant's law (Eqs 4 to 6), by hand.
#[test]
fn formulas() {
    let place = Place::new();
    let rubber = concat!(env!("CARGO_MANIFEST_DIR"), "/models/rubber.tcl");
    place.write(
        "m.tcl",
        format!(
            "source {rubber}\nputs [format %.6f [rubber::lambda 210 5 1.1 2000]]\n\
             puts [format %.4f [rubber::modulus 210 5 1.1 2000]]\n\
             puts [rubber::grant {{1 2 3}} {{4 5 6}} {{7 8 9 10}} 8 2]\n"
        ),
    );
    let (status, out, err) = place.run(&["run", "m.tcl"]);
    assert_eq!(status, Some(0), "{err}");
    let lines: Vec<&str> = out.lines().collect();
    assert_eq!(lines[0], "1.706048");
    // E = K (1 - 2 I_1/(lambda I_0)), the Bessel functions by their series.
    let series = |order: u32| {
        let x: f64 = 1.7060480649735519;
        (0..40).fold((0.0, (0.5 * x).powi(order as i32)), |(sum, term), k| {
            (sum + term, term * 0.25 * x * x / (f64::from(k + 1) * f64::from(k + 1 + order)))
        })
    };
    let expected = 2000.0 * (1.0 - 2.0 * series(1).0 / (1.7060480649735519 * series(0).0));
    assert!((lines[1].parse::<f64>().unwrap() - expected).abs() < 1e-3, "{} {expected}", lines[1]);
    assert_eq!(lines[2], "4.0 2.0 0.75 32 10.0 3.0 0.875 1.0 9 1.25");
}
