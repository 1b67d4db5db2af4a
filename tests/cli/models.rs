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

/// The house on recycled-rubber bearings: each model answers within the strains of the tests, and a strain beyond them is refused.
/// OpenSees has the same strains for the first two models, to the printed digits.
#[test]
fn a_house_on_recycled_rubber() {
    let house = concat!(env!("CARGO_MANIFEST_DIR"), "/tcl-like-inputs/rr_frb_house/house.tcl");
    for (device, strain) in [("boucwen", "0.398"), ("hdr", "0.371"), ("kikuchi", "0.100"), ("rheology", "0.025")] {
        let place = Place::new();
        let (status, out, err) = place.run(&["run", "--strict", house, device]);
        assert_eq!(status, Some(0), "{device}: {err}");
        assert!(out.contains(&format!("{device}: largest shear strain of the bearings {strain},")), "{device}: {out}");
        assert!(place.0.join("results/rr_frb_house/bearing1.out").is_file(), "{device}");
    }
    for device in ["boucwen", "hdr", "kikuchi"] {
        let (status, _, err) = Place::new().run(&["run", house, device, "1.0"]);
        let said = ["has a shear strain of 6", "the models are identified up to 60 %"];
        assert!(status == Some(1) && said.iter().all(|w| err.contains(w)), "{device}: {status:?} {err}");
    }
    let (status, _, err) = Place::new().run(&["run", house, "lead"]);
    assert!(status == Some(1) && err.contains("expected boucwen, hdr, kikuchi or rheology"), "{err}");
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

/// The file of a model has the names and links that openseespy's has: checked against its own for the same script.
#[test]
fn the_model_file_says_what_elements_are_made_of() {
    let script = "model basic -ndm 3 -ndf 6\nnode 1 0 0 0\nnode 2 0 0 3 -mass 2. 2. 2. 0 0 0\nfix 1 1 1 1 1 1 1\nnode 3 1 0 3\n\
        uniaxialMaterial Elastic 7 100.\nuniaxialMaterial Steel02 8 250. 2e5 0.02 18 0.925 0.15\n\
        section Fiber 4 -GJ 1e6 { fiber 0.1 0.1 0.01 8\nfiber -0.1 0.1 0.01 8\nfiber 0. -0.1 0.01 8 }\n\
        geomTransf PDelta 9 1 0 0\nelement dispBeamColumn 5 1 2 3 4 9\nelement zeroLength 6 1 2 -mat 7 8 -dir 1 2\n\
        equalDOF 2 3 1 2 6\ntimeSeries Linear 1\npattern Plain 1 1 { load 2 0 0 -3. 0 0 0 }\nprint -JSON -file m.json\n";
    let place = Place::new();
    place.write("m.tcl", script);
    let (status, _, err) = place.run(&["run", "m.tcl"]);
    assert_eq!(status, Some(0), "{err}");
    let text = std::fs::read_to_string(place.0.join("m.json")).unwrap();
    let file: serde_json::Value = serde_json::from_str(&text).unwrap();
    let model = &file["StructuralAnalysisModel"];
    let at = |path: &str| model.pointer(path).unwrap_or_else(|| panic!("{path}: {text}")).to_string();
    for (path, value) in [
        ("/properties/uniaxialMaterials/0/type", "\"ElasticMaterial\""),
        (
            "/properties/crdTransformations/0",
            r#"{"name":"9","type":"PDeltaCrdTransf3d","vecInLocXZPlane":[1.0,0.0,0.0]}"#,
        ),
        ("/properties/patterns/0/nodes/0", r#"{"node":2,"value":[0.0,0.0,-3.0,0.0,0.0,0.0]}"#),
        ("/geometry/nodes/1", r#"{"crd":[0.0,0.0,3.0],"mass":[2.0,2.0,2.0,0.0,0.0,0.0],"name":2,"ndf":6}"#),
        ("/geometry/elements/0/crdTransformation", "\"9\""),
        ("/geometry/elements/0/sections", "[\"4\"]"),
        ("/geometry/elements/1/materials", "[\"7\",\"8\"]"),
        ("/geometry/elements/1/nodes", "[1,2]"),
        ("/geometry/constraints/0/dofs", "[1,2,6]"),
        ("/geometry/constraints/0/matrix", "[[1.0,0.0,0.0],[0.0,1.0,0.0],[0.0,0.0,1.0]]"),
        ("/geometry/constraints/6", r#"{"dof":6,"name":5,"node":1,"ref_value":0}"#),
    ] {
        assert_eq!(at(path), value, "{path}");
    }
}
