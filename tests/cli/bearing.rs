//! Bearings driven by themselves.

use super::Place;
use std::f64::consts::TAU;
use std::fs;

/// A procedure that makes a Bouc-Wen bearing, in a file of its name.
const DEVICE: &str = "proc rubber {tag i j {k 1000.0}} {\n    uniaxialMaterial Elastic 91 1.0e6\n    \
    element elastomericBearingBoucWen $tag $i $j $k 10.0 0.1 0.0 2.0 2.0 0.5 0.5 -P 91 -T 91 -My 91 -Mz 91 \\\n        \
    -orient 0 0 1 1 0 0\n}\n";

fn place() -> Place {
    let place = Place::new();
    place.write("rubber.tcl", DEVICE);
    place
}

/// Run a test; the table, as rows of numbers by name.
fn tested(place: &Place, args: &[&str]) -> Vec<serde_json::Value> {
    let (status, out, err) = place.run(&[&["bearing", "rubber.tcl", "--table", "json"], args].concat());
    assert_eq!(status, Some(0), "{args:?}: {err}");
    serde_json::from_str(&out).unwrap_or_else(|e| panic!("{args:?}: {e}: {out}"))
}

#[test]
fn cycles_of_growing_amplitude() {
    let place = place();
    let table =
        tested(&place, &["--strains", "0.1,0.2", "--thickness", "1", "-n", "2", "-P", "50", "--frequency", "0.5"]);
    assert_eq!(table.len(), 4);
    for (row, amplitude) in table.iter().zip([0.1, 0.1, 0.2, 0.2]) {
        let number = |name: &str| row[name].as_f64().unwrap();
        assert!((number("amplitude") - amplitude).abs() < 1e-4 && number("E") > 0.0 && row["part"] == "", "{row}");
        // Yielded: hysteretic force 10 and a tenth of the stiffness.
        assert!((number("F_max") - (10.0 + 100.0 * amplitude)).abs() < 0.1, "{row}");
    }
    let mut names = fs::read_dir(place.0.join("rubber_test"))
        .unwrap()
        .map(|f| f.unwrap().file_name().to_string_lossy().into_owned())
        .collect::<Vec<_>>();
    names.sort();
    assert_eq!(names, ["cycles.csv", "displacement.out", "force.out", "loops.csv", "loops.svg", "test.tcl"]);
    let loops = fs::read_to_string(place.0.join("rubber_test/loops.csv")).unwrap();
    assert!(loops.starts_with("time,u_x,u_y,u_z,F_x,F_y,F_z\n0,0,") && loops.lines().count() == 2 + 800, "{loops}");
    assert!(loops.lines().last().is_some_and(|l| l.contains(",-50")), "compression is negative");
    // The script runs by itself, with the same results, and means what it says.
    let before = fs::read(place.0.join("rubber_test/force.out")).unwrap();
    let (status, _, err) = place.run(&["run", "--strict", "rubber_test/test.tcl"]);
    assert!(status == Some(0) && err.is_empty(), "{err}");
    assert_eq!(before, fs::read(place.0.join("rubber_test/force.out")).unwrap());
    // From its own folder too, and after both have been moved.
    fs::remove_file(place.0.join("rubber_test/force.out")).unwrap();
    fs::create_dir(place.0.join("moved")).unwrap();
    for name in ["rubber_test", "rubber.tcl"] {
        fs::rename(place.0.join(name), place.0.join("moved").join(name)).unwrap();
    }
    let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_hysteron"));
    let own =
        command.args(["run", "--strict", "test.tcl"]).current_dir(place.0.join("moved/rubber_test")).output().unwrap();
    assert!(own.status.success(), "{}", String::from_utf8_lossy(&own.stderr));
    assert_eq!(before, fs::read(place.0.join("moved/rubber_test/force.out")).unwrap());
}

#[test]
fn other_motions() {
    let place = place();
    let circle = tested(&place, &["-m", "circles", "-a", "0.1", "-n", "2", "--steps", "100"]);
    let round = &circle[1];
    // The force of a circle goes round with it: hysteretic force 10 over a path of 2 pi r, at some angle to it.
    let energy = round["E"].as_f64().unwrap();
    assert!((0.5..1.0).contains(&(energy / (10.0 * TAU * 0.1))), "{circle:?}");
    let eights = tested(&place, &["-m", "eights", "-a", "0.1", "-n", "3", "--steps", "100"]);
    assert_eq!(eights.len(), 3);
    let axial = tested(&place, &["-m", "axial", "-a", "0.001", "-n", "1", "--offset", "0.05"]);
    assert!((axial[0]["K"].as_f64().unwrap() / 1e6 - 1.0).abs() < 1e-6, "{axial:?}");
    let ramps = tested(&place, &["-m", "ramps", "-a", "0.1,-0.1,0", "--speed", "0.5", "--hold", "1"]);
    assert!(ramps.is_empty() || ramps[0]["amplitude"] == 0.1, "{ramps:?}");
    let turned = tested(&place, &["-a", "0.1", "-n", "1", "--angle", "30", "--device", "rubber 2000.0"]);
    let straight = tested(&place, &["-a", "0.1", "-n", "1", "--rates", "--device", "rubber 2000.0"]);
    let energy = |t: &[serde_json::Value]| t[0]["E"].as_f64().unwrap();
    assert!((energy(&turned) / energy(&straight) - 1.0).abs() < 1e-4, "{turned:?} {straight:?}");
    let varying = tested(&place, &["-a", "0.1", "-P", "50", "--axial-amplitude", "20", "--axial-ratio", "2"]);
    assert_eq!(varying.len(), 3);
    let loops = fs::read_to_string(place.0.join("rubber_test/loops.csv")).unwrap();
    let axial = loops.lines().skip(1).map(|l| l.rsplit(',').next().unwrap().parse::<f64>().unwrap());
    let (low, high) = axial.fold((0.0f64, -1e9f64), |(low, high), f| (low.min(f), high.max(f)));
    assert!((low + 70.0).abs() < 1e-2 && (high + 30.0).abs() < 1e-2, "{low} {high}");
}

/// A script with a bearing of its own, in the plane.
#[test]
fn own_element() {
    let place = Place::new();
    place.write(
        "own.tcl",
        "model basic -ndm 2 -ndf 3\nnode 5 0 0\nnode 6 0 0.2\nuniaxialMaterial Elastic 1 1e6\n\
         element elastomericBearingPlasticity 1 5 6 1000 10 0.1 0 2 -P 1 -Mz 1\n",
    );
    let (status, out, err) = place.run(&["bearing", "own.tcl", "-a", "0.05", "-n", "1", "-P", "10", "-o", "out/here"]);
    assert!(status == Some(0) && out.contains("xi"), "{err}");
    assert!(place.0.join("out/here/loops.svg").exists());
}

#[test]
fn refused() {
    let place = place();
    place.write("empty.tcl", "proc a {} {}\n");
    for (args, message) in [
        (&["rubber.tcl", "-a", "-0.1"][..], "the amplitude is -0.1: expected more than 0"),
        (&["rubber.tcl", "-a", "0.1", "--frequency", "0"], "the frequency is 0"),
        (&["rubber.tcl", "-a", "0.1", "--steps", "2"], "expected at least 8"),
        (&["rubber.tcl", "-a", "0.1", "-m", "axial", "-P", "5"], "the axial load is 5: expected none"),
        (&["empty.tcl", "-a", "0.1"], "has no procedure \"empty\": its procedures are a"),
        (&["none.tcl", "-a", "0.1"], "none.tcl"),
    ] {
        let (status, out, err) = place.run(&[&["bearing"], args].concat());
        assert!(status == Some(2) && out.is_empty() && err.contains(message), "{args:?}: {err}");
    }
    let (status, out, _) = place.run(&["bearing", "rubber.tcl", "-a", "0.1", "--script"]);
    assert!(status == Some(0) && out == "rubber_test/test.tcl\n");
}

/// Of a whole model one bearing is tested alone, with the materials that its words name.
#[test]
fn a_bearing_of_a_whole_model() {
    let place = place();
    place.write(
        "building.tcl",
        "model basic -ndm 3 -ndf 6\nset k 1000.0\nforeach {i x} {11 0 12 6} {\n    node $i $x 0 0\n    node [expr {$i+10}] $x 0 0\n    \
         fix $i 1 1 1 1 1 1\n    uniaxialMaterial Elastic [expr {$i+50}] 1.0e6\n    uniaxialMaterial Elastic [expr {$i+80}] [expr {$i*1e6}]\n    \
         element elastomericBearingBoucWen $i $i [expr {$i+10}] $k 10.0 0.1 0.0 2.0 2.0 0.5 0.5 -P [expr {$i+50}] -T [expr {$i+50}] \
         -My [expr {$i+50}] -Mz [expr {$i+50}] -orient 0 0 1 1 0 0\n}\ngeomTransf Linear 1 0 1 0\n\
         element elasticBeamColumn 1 21 22 0.1 2e8 8e7 1e-3 1e-3 1e-3 1\ntimeSeries Linear 1\npattern Plain 1 1 { load 21 0 0 -9 0 0 0 }\nwipe\n",
    );
    let test = |words: &[&str]| {
        place.run(&[&["bearing", "building.tcl", "-a", "0.2", "-n", "1", "--table", "json"], words].concat())
    };
    let (status, out, err) = test(&["--element", "12"]);
    assert_eq!(status, Some(0), "{err}");
    let rows: Vec<serde_json::Value> = serde_json::from_str(&out).unwrap();
    assert!((rows[0]["F_max"].as_f64().unwrap() - 30.0).abs() < 0.1, "{rows:?}");
    let alone = fs::read_to_string(place.0.join("building_12_test/bearing.tcl")).unwrap();
    let commands: Vec<&str> = alone.lines().map(|l| l.split_whitespace().next().unwrap()).collect();
    assert_eq!(commands, ["model", "node", "node", "uniaxialMaterial", "element"], "{alone}");
    assert!(
        alone.contains("uniaxialMaterial Elastic 62 1.0e6\nelement elastomericBearingBoucWen 1 1 2 1000.0 10.0"),
        "{alone}"
    );
    let script = fs::read_to_string(place.0.join("building.tcl")).unwrap();
    place.write(
        "building.tcl",
        script.replace("wipe", "foreach i {1 12} { amend element $i gap -at 0.1 -stiffness 100 -dir 1 }\nwipe"),
    );
    let (status, _, err) = test(&["--element", "12"]);
    assert!(status == Some(2) && err.contains("element 12 is amended"), "{err}");
    assert_eq!(test(&["--element", "11"]).0, Some(0));
    let (status, _, err) = test(&["--element", "13"]);
    assert!(status == Some(2) && err.contains("the script makes no element 13: its elements are 11, 12, 1"), "{err}");
}

/// A spring of the shear alone is held along the vertical, and said to be; an axial load is refused as before.
#[test]
fn a_bearing_without_vertical_stiffness() {
    let place = place();
    place.write(
        "shear.tcl",
        "model basic -ndm 2 -ndf 3\nnode 1 0 0\nnode 2 0 0\nuniaxialMaterial Steel01 7 50 5000 0.1\nelement zeroLength 1 1 2 -mat 7 -dir 1\n",
    );
    let (status, out, err) = place.run(&["bearing", "shear.tcl", "-a", "0.11", "-n", "1", "--table", "json"]);
    assert!(status == Some(0) && err.contains("is held there"), "{err}");
    let rows: Vec<serde_json::Value> = serde_json::from_str(&out).unwrap();
    // Yield at 0.01, then a tenth of the stiffness.
    assert!((rows[0]["F_max"].as_f64().unwrap() - 100.0).abs() < 0.1, "{rows:?}");
    let (status, _, err) = place.run(&["bearing", "shear.tcl", "-a", "0.11", "-P", "5"]);
    assert!(status == Some(1) && err.contains("does not carry the axial load"), "{err}");
    let (status, _, err) = place.run(&["bearing", "rubber.tcl", "-a", "0.1"]);
    assert!(status == Some(0) && !err.contains("is held there"), "{err}");
}
