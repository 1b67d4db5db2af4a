//! Files of recorders in OpenSees' forms.

use super::{MODEL, Place};
use std::fs;

const HEAD: &str = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n <OpenSees\n  xmlns:xsi = \
    \"http://www.w3.org/2001/XMLSchema-instance\"\n  xsi:noNamespaceSchemaLocation = \
    \"http://OpenSees.berkeley.edu/xml-schema/xmlns/OpenSees.xsd\">\n";

/// Run the cantilever with recorders for two steps; content of a file.
fn recorded(recorders: &str, file: &str) -> Vec<u8> {
    let place = Place::new();
    let analysis = "integrator LoadControl 1\nalgorithm Linear\nanalysis Static\nanalyze 2\n";
    // Node 3 is free.
    let model = MODEL.replace("node 3 4 0\n", "");
    place.write("m.tcl", format!("{model}{recorders}\n{analysis}"));
    let (code, _, err) = place.run(&["run", "m.tcl"]);
    assert_eq!(code, Some(0), "{err}");
    fs::read(place.0.join(file)).unwrap()
}

#[test]
fn xml() {
    for (command, groups, rows) in [
        (
            "recorder Node -xml a -time -node 2 -dof 1 2 disp",
            "    <TimeOutput>\n        <ResponseType>time</ResponseType>\n    </TimeOutput>\n    \
             <NodeOutput nodeTag=\"2\" coord1=\"4\" coord2=\"0\" coord3=\"0\">\n        \
             <ResponseType>D1</ResponseType>\n        <ResponseType>D2</ResponseType>\n    </NodeOutput>\n",
            &["1 2e-07 0 ", "2 4e-07 0 "][..],
        ),
        (
            "recorder EnvelopeNode -xml a -time -node 2 -dof 1 disp",
            "    <NodeOutput nodeTag=\"2\">\n        <TimeOutput>\n            \
             <ResponseType>time</ResponseType>\n        </TimeOutput>\n        \
             <ResponseType>D1</ResponseType>\n    </NodeOutput>\n",
            &["1 2e-07 ", "2 4e-07 ", "2 4e-07 "],
        ),
        (
            "recorder Element -xml a -ele 1 basicForce",
            "    <ElementOutput eleType=\"ElasticBeam2d\" eleTag=\"1\" node1=\"1\" node2=\"2\">\n        \
             <ResponseType>N</ResponseType>\n        <ResponseType>M_1</ResponseType>\n        \
             <ResponseType>M_2</ResponseType>\n    </ElementOutput>\n",
            &["1 0 0 ", "2 0 0 "],
        ),
    ] {
        let rows: String = rows.iter().map(|r| format!("        {r}\n")).collect();
        let expected = format!("{HEAD}{groups}    <Data>\n{rows}        </Data>\n</OpenSees>\n");
        assert_eq!(String::from_utf8(recorded(command, "a")).unwrap(), expected, "{command}");
    }
}

#[test]
fn binary() {
    let bytes = recorded("recorder Node -binary a -time -node 2 -dof 1 2 disp", "a");
    assert_eq!(bytes.len(), 2 * (3 * 8 + 1));
    for (step, row) in bytes.chunks(25).enumerate() {
        let numbers: Vec<f64> = row[..24].chunks(8).map(|b| f64::from_le_bytes(b.try_into().unwrap())).collect();
        let time = (step + 1) as f64;
        assert!((numbers[0] - time).abs() < 1e-15 && (numbers[1] - 2e-7 * time).abs() < 1e-20, "{numbers:?}");
        assert_eq!(row[24], b'\n');
    }
}

/// A folder that is not there is made with a warning, in a run. Under `--strict` it is refused by its name, not by what the
/// file is called until it is whole.
#[test]
fn missing_folder() {
    let place = Place::new();
    place.write("m.tcl", format!("{MODEL}recorder Node -file out/deep/d.txt -node 2 -dof 1 disp\n"));
    for how in ["check", "run"] {
        assert!(!place.0.join("out").exists());
        let (status, _, err) = place.run(&[how, "m.tcl"]);
        assert_eq!(status, Some(0), "{err}");
        assert!(err.contains("there is no folder out/deep") && err.contains("file mkdir out/deep"), "{err}");
    }
    assert!(place.0.join("out/deep/d.txt").exists());
    fs::remove_dir_all(place.0.join("out")).unwrap();
    let (status, _, err) = place.run(&["run", "--strict", "m.tcl"]);
    assert!(status == Some(2) && err.contains("there is no folder out/deep") && !err.contains(".part"), "{err}");
}

#[test]
fn files_for_paraview() {
    let place = Place::new();
    let model = MODEL.replace("node 3 4 0\n", "");
    let analysis = "integrator LoadControl 1\nalgorithm Linear\nanalysis Static\nanalyze 4\n";
    place.write("m.tcl", format!("{model}recorder PVD a/b -dT 2 disp reaction eleResponse localForce\n{analysis}"));
    let (code, _, err) = place.run(&["run", "--out", "out", "m.tcl"]);
    assert_eq!(code, Some(0), "{err}");
    let list = fs::read_to_string(place.0.join("out/a/b.pvd")).unwrap();
    let listed: Vec<&str> = list.split('"').filter(|w| w.ends_with(".vtu")).collect();
    assert_eq!(listed, ["b/000000.vtu", "b/000001.vtu"], "steps 1 and 3");
    for file in &listed {
        let grid = fs::read_to_string(place.0.join("out/a").join(file)).unwrap();
        for name in ["\"Displacement\"", "\"Reaction\"", "\"localForce\" NumberOfComponents=\"6\""] {
            assert!(grid.contains(name), "{name} in {grid}");
        }
    }
    assert_eq!(fs::read_dir(place.0.join("out/a/b")).unwrap().count(), 2);
    assert!(!place.0.join("a").exists(), "nothing beside --out");
}

/// Displacements 2e-7 and 4e-7 of two steps; the second is not due where rows are 2 apart.
#[test]
fn root_mean_squares() {
    for (options, mean) in [("", (10.0f64).sqrt() * 1e-7), ("-dT 2", 2e-7)] {
        let text = recorded(&format!("recorder NodeRMS -file a {options} -node 1 2 -dof 1 disp"), "a");
        let row = String::from_utf8(text).unwrap();
        let numbers: Vec<f64> = row.split_whitespace().map(|w| w.parse().unwrap()).collect();
        assert!(numbers.len() == 2 && numbers[0] == 0.0 && (numbers[1] / mean - 1.0).abs() < 1e-5, "{row}");
    }
}

/// As in OpenSees a recorder without a response takes the displacements, where OpenSees is followed.
#[test]
fn missing_response() {
    let place = Place::new();
    let model = MODEL.replace("node 3 4 0\n", "");
    let recorder = |file: &str, response: &str| format!("recorder Node -file {file} -node 2 -dof 1 2 {response}\n");
    let recorders = recorder("a", "") + &recorder("b", "disp");
    place.write(
        "m.tcl",
        format!("{model}{recorders}integrator LoadControl 1\nalgorithm Linear\nanalysis Static\nanalyze 2\n"),
    );
    let (code, _, err) = place.run(&["run", "--compat", "opensees", "m.tcl"]);
    assert!(code == Some(0) && err.contains("OpenSees takes disp"), "{err}");
    let text = |file: &str| fs::read_to_string(place.0.join(file)).unwrap();
    assert_eq!(text("a"), text("b"));
    assert_eq!(place.run(&["run", "m.tcl"]).0, Some(2));
}

/// Shapes of all modes, a row of each; the numbers are those of openseespy 3.7.1.
#[test]
fn all_modes() {
    let place = Place::new();
    let model = "model basic -ndm 2 -ndf 3\nnode 1 0 0\nnode 2 0 3\nnode 3 0 6\nfix 1 1 1 1\nmass 2 2. 2. 0.1\n\
        mass 3 1. 1. 0.1\ngeomTransf Linear 1\nelement elasticBeamColumn 1 1 2 0.1 2e8 1e-4 1\n\
        element elasticBeamColumn 2 2 3 0.1 2e8 1e-4 1\nrecorder Node -file a -node 2 3 -dof 1 3 eigen\n\
        recorder Node -file b -time -node 2 3 -dof 1 3 \"eigen 0\"\neigen 3\nrecord\n";
    place.write("m.tcl", model);
    let (code, _, err) = place.run(&["run", "m.tcl"]);
    assert_eq!(code, Some(0), "{err}");
    let expected = [
        [0.295636, -0.171428, 0.904143, -0.218727],
        [-0.635335, 0.0371782, 0.402884, -0.549942],
        [-0.0934481, -1.25042, 0.106459, 2.85455],
    ];
    for (file, skip) in [("a", 0), ("b", 1)] {
        let text = fs::read_to_string(place.0.join(file)).unwrap();
        let rows: Vec<Vec<f64>> =
            text.lines().map(|l| l.split_whitespace().skip(skip).map(|w| w.parse().unwrap()).collect()).collect();
        assert_eq!(rows.len(), 3, "{text}");
        for (row, want) in rows.iter().zip(expected) {
            let sign = (row[0] * want[0]).signum();
            assert!(row.iter().zip(want).all(|(x, w)| (x * sign - w).abs() < 2e-6), "{row:?}");
        }
    }
}

/// Words that are meant as a comment are no options, however many; options among them count, as in OpenSees.
#[test]
fn comment_without_semicolon() {
    let place = Place::new();
    let words = "word ".repeat(30);
    place.write("m.tcl", format!("{MODEL}node 9 1 1 0 # {words} -mass 3 3 3\nputs [nodeMass 9 1]\n"));
    let (code, out, err) = place.run(&["run", "m.tcl"]);
    assert_eq!((code, out.trim()), (Some(0), "3.0"), "{err}");
    assert!(err.contains("a comment after a command begins with") && !err.contains("\"word\" is not"), "{err}");
}

#[test]
fn words_of_other_builds() {
    let place = Place::new();
    let model = MODEL.replace("node 3 4 0\n", "").replace("model BasicBuilder", "model");
    let script = format!(
        "{model}pattern Plain 7 1 {{ignored}} {{ load 2 1 0 0 }}\nintegrator LoadControl 1\nalgorithm Linear\n\
         analysis Static\nanalyze 1\nverify about Tip\nverify value [nodeDisp 2 1] 4e-7 1e-12 tip\n\
         verify error [nodeDisp 2 1] 4e-7 1e-9\nverify value 1.0 1.1 text\nverify value 1.0 1.1 0.01 wrong\n"
    );
    place.write("m.tcl", script);
    let (code, out, err) = place.run(&["run", "m.tcl"]);
    assert_eq!(code, Some(2), "{err}");
    assert!(out.contains("  Tip\n    PASS  ") && out.lines().count() == 4, "{out}");
    assert!(err.contains("verify: 1 is not 1.1 wrong") && err.contains("the last word holds the loads"), "{err}");
}

/// Frames and sections by the names of another build are those of OpenSees.
#[test]
fn frames_of_other_builds() {
    let place = Place::new();
    let tip = |model: &str, section: &str, element: &str| {
        let script =
            format!("model basic {model}\nnode 1 0 0 0\nnode 2 4 0 0\n{section}\n{element}\nputs [nodeDisp 2]\n");
        place.write("m.tcl", script);
        let (code, out, err) = place.run(&["run", "m.tcl"]);
        assert_eq!(code, Some(0), "{err}");
        out
    };
    let space = |section: &str, element: &str| {
        let rest = "timeSeries Linear 1\npattern Plain 1 1 {load 2 1 2 3 4 5 6}\nalgorithm Linear\n\
            integrator LoadControl 1\nanalysis Static\nanalyze 1";
        tip("-ndm 3 -ndf 6", section, &format!("fix 1 1 1 1 1 1 1\ngeomTransf Linear 1 0 0 1\n{element}\n{rest}"))
    };
    let plain = space("section Elastic 1 2e8 0.1 1e-3 2e-3 8e7 3e-3", "element elasticBeamColumn 1 1 2 1 1");
    for section in [
        "section ElasticFrame 1 2e8 0.1 1e-3 2e-3 8e7 3e-3",
        "section FrameElastic 1 2e8 -J 3e-3 -G 8e7 -Iy 2e-3 -Iz 1e-3 -A 0.1",
        "section ElasticFrame 1 -E 2e8 -A 0.1 -Iz 1e-3 -Iy 2e-3 -G 8e7 -J 3e-3 -Ay 0.05 -Az 0.05",
    ] {
        assert_eq!(space(section, "element PrismFrame 1 1 2 -section 1 -transform 1 -shear 0"), plain, "{section}");
    }
    let sheared = space(
        "section FrameElastic 1 2e8 0.1 1e-3 2e-3 8e7 3e-3 -Ay 0.05 -Az 0.05",
        "element PrismFrame 1 1 2 -transform 1 -section 1",
    );
    let shear_areas = "element elasticBeamColumn 1 1 2 0.1 2e8 8e7 3e-3 2e-3 1e-3 0.05 0.05 1";
    assert_eq!(sheared, space("", shear_areas));
    assert_ne!(sheared, plain);
}

/// A recorder for the viewer of another program is no reason to stop, except under `--strict`.
#[test]
fn recorders_of_other_programs_are_left_out() {
    let place = Place::new();
    place.write(
        "m.tcl",
        "model basic -ndm 1 -ndf 1\nnode 1 0\nputs [recorder mpco m.mpco -N displacement -E force -T dt 0.1]\n\
         recorder gmsh m disp\nputs went\n",
    );
    let (code, out, err) = place.run(&["run", "m.tcl"]);
    assert!(code == Some(0) && out == "-1\nwent\n", "{out}{err}");
    assert!(err.contains("recorder mpco: a file of this kind is not written") && err.contains("gmsh"), "{err}");
    let (code, _, err) = place.run(&["run", "--strict", "m.tcl"]);
    assert!(code == Some(2) && err.contains("recorder mpco"), "{err}");
}
