//! Studies that contradict their scripts: each is refused or warned of, and a study that agrees is neither.

use super::Place;
use std::fs;

const INPUTS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tcl-like-inputs");

/// A shipped study beside its script, both with some of their text replaced, and one run of a command on it.
struct Case<'a> {
    folder: &'a str,
    script: &'a str,
    in_study: &'a [(&'a str, &'a str)],
    in_script: &'a [(&'a str, &'a str)],
}

const BUILDING: Case<'_> = Case { folder: "isolation_study", script: "building.tcl", in_study: &[], in_script: &[] };
const FRAME: Case<'_> = Case { folder: "eight_storey_study", ..BUILDING };
const BRIDGE: Case<'_> = Case { folder: "bridge_study", script: "bridge.tcl", ..BUILDING };

fn replaced(file: &str, changes: &[(&str, &str)]) -> String {
    let mut text = fs::read_to_string(format!("{INPUTS}/{file}")).unwrap();
    for (from, to) in changes {
        assert!(text.contains(from), "{file} has no {from}");
        text = text.replacen(from, to, 1);
    }
    text.replace("\"../ground_motions", &format!("\"{INPUTS}/ground_motions"))
}

impl Case<'_> {
    /// Status, and what is said on the terminal.
    fn run(&self, command: &str) -> (Option<i32>, String) {
        let place = Place::new();
        place.write("study.toml", replaced(&format!("{}/study.toml", self.folder), self.in_study));
        place.write(self.script, replaced(&format!("{}/{}", self.folder, self.script), self.in_script));
        let (status, _, said) = place.run(&[command, "study.toml"]);
        (status, said)
    }

    fn refused(&self, command: &str, named: &[&str]) {
        let (status, said) = self.run(command);
        let (study, script) = (self.in_study, self.in_script);
        assert!(status == Some(2) && named.iter().all(|n| said.contains(n)), "{study:?} {script:?}: {status:?} {said}");
    }

    fn warned(&self, command: &str, named: &[&str]) {
        let (status, said) = self.run(command);
        let warnings: Vec<&str> = said.lines().filter(|l| l.starts_with("warning: ")).collect();
        let found = warnings.iter().filter(|w| named.iter().all(|n| w.contains(n))).count();
        let (study, script) = (self.in_study, self.in_script);
        assert!(status == Some(0) && found == 1, "{study:?} {script:?}: {status:?} {said}");
    }

    fn accepted(&self) {
        let (status, said) = self.run("check");
        let (study, script) = (self.in_study, self.in_script);
        // Shipped suites have motions of one component, some with a large factor. Both are told, and contradict nothing.
        let of_motion =
            |l: &str| l.contains("one horizontal component is no pair") || l.contains("is outside 0.25 to 4");
        let contradicts = said.lines().any(|l| l.contains("warning") && !of_motion(l));
        assert!(status == Some(0) && !contradicts, "{study:?} {script:?}: {status:?} {said}");
    }
}

#[test]
fn shipped_studies_agree_with_their_scripts() {
    for case in [BUILDING, FRAME, BRIDGE] {
        case.accepted();
    }
}

#[test]
fn values_of_a_study_that_its_script_cannot_have() {
    for (change, named) in [
        (("[0.05, 0.05]]", "[0.6, 0.6]]"), ["[0.6, 0.6]", "outside of the plan"]),
        (("displacement = 0.35", "displacement = 0.55"), ["displacement = 0.55 of LRB", "diameter = 0.5"]),
        (("plan = [12.0, 12.0]", "plan = [12.0, 1200.0]"), ["far larger than the grid", "ratio 100.0000"]),
        (("plan =", "substructure_weight = 500.0\nplan ="), ["substructure_weight = 500", "is 0.000000"]),
        (("plan =", "members = [100, 999]\nplan ="), ["members: 999", "is no element"]),
        (("plan =", "members = [100, 999]\nplan ="), ["--> study.toml:", ":17\n"]),
        (("gravity = 9.81", "gravity = 981.0"), ["--> study.toml:", ":11\n"]),
    ] {
        Case { in_study: &[change], ..BUILDING }.refused("check", &named);
    }
    let twice = [(
        "name = \"Rio Dell 1992\"\nfiles = [\"../ground_motions/riodell_1992_360_g.txt\"]\nunit = \"g\"\ndt = 0.02",
        "name = \"Another\"\nfiles = [\"../ground_motions/meloland_1979_270_g.txt\", \"../ground_motions/meloland_1979_360_g.txt\"]\n\
         unit = \"g\"\ndt = 0.01",
    )];
    Case { in_study: &twice, ..BUILDING }
        .refused("check", &["the motions 1 \"Meloland", "2 \"Another", "are one record"]);
}

#[test]
fn scripts_that_do_otherwise_than_their_study() {
    let ends = "element elastomericBearingBoucWen $tag $tag [expr {20 + $tag}]";
    let exchanged = "lassign [expr {$tag == 3 ? {23 3} : [list $tag [expr {20 + $tag}]]}] low high\n        \
        element elastomericBearingBoucWen $tag $low $high";
    Case { in_script: &[(ends, exchanged)], ..BUILDING }
        .refused("check", &["the bearing 3 of LRB", "lower node first"]);
    let heavier = "{*}[lrepeat 3 [expr {$isolate(bound) eq \"upper\" ? 1.1*$mass : $mass}]] 1440.0";
    let heavier = [("$mass $mass $mass 1440.0", heavier)];
    Case { in_script: &heavier, ..BUILDING }
        .refused("check", &["the upper bound", "changes the mass above the bearings"]);
    let short = [("set steps [expr {int($isolate(points)/2)}]", "set steps 200")];
    let in_study = &[
        ("eccentricities = [[0.0, 0.0], [0.05, 0.05]]\n", ""),
        (
            "[[motion]]\nname = \"Rio Dell 1992\"\nfiles = [\"../ground_motions/riodell_1992_360_g.txt\"]\n\
             unit = \"g\"\ndt = 0.02\n",
            "",
        ),
    ];
    Case { in_study, in_script: &short, ..BUILDING }
        .refused("isolate", &["lasts 4.0000 s", "the suite was stopped", "isolate(points)"]);
    let growing = [("loadConst -time 0.0\n", "")];
    Case { in_study, in_script: &growing, ..BUILDING }.warned("isolate", &["building.tcl:", "[growing-pattern]"]);
}

#[test]
fn bearings_of_another_shape_or_in_no_list() {
    let smooth = ("yield_displacement = 0.0066", "yield_displacement = 0.0066\ntransition = \"smooth\"");
    let plastic =
        [("elastomericBearingBoucWen", "elastomericBearingPlasticity"), ("0.1 0.0 1.0 1.0 0.5 0.5", "0.1 0.0 1.0")];
    Case { in_study: &[smooth], in_script: &plastic, ..BUILDING }
        .warned("check", &["transition = \"smooth\"", "turns abruptly"]);
    Case { in_study: &[smooth], ..BUILDING }.accepted();
    Case { in_script: &plastic, ..BUILDING }.accepted();
    let further = "# ---------------------------------------------------------------- storeys\n\
        uniaxialMaterial Elastic 3 1.0\nnode 50 3.0 3.0 0.0\nfix 50 1 1 1 1 1 1\nnode 51 3.0 3.0 0.3\nrigidLink beam 100 51\n\
        element elastomericBearingBoucWen 50 50 51 1.0 0.001 0.1 0.0 1.0 1.0 0.5 0.5 -P 3 -T 3 -My 3 -Mz 3 -orient 0 0 1 1 0 0\n";
    let further = [("# ---------------------------------------------------------------- storeys\n", further)];
    Case { in_script: &further, ..BUILDING }.warned("check", &["that no [[bearing]] lists: 50"]);
}

/// Names of units are compared with what a script says; without a word of it magnitudes give a warning.
#[test]
fn units_of_another_name() {
    let label = |words: &'static str| [("units = [\"kN\", \"m\"]", words)];
    let kip = label("units = [\"kip\", \"m\"]");
    let silent = ("# Units: kN, m, s, t.\n", "");
    Case { in_study: &kip, ..BUILDING }
        .refused("check", &["units = [\"kip\", \"m\"]", "building.tcl\":6", "Units: kN, m, s, t."]);
    for (variable, ratio) in [("set kN 1.0", "ratio 4.4482"), ("set kip 4.448", "ratio 4.4480")] {
        let stated = [silent, ("set g 9.81\n", &*format!("set g 9.81\n{variable}\n"))];
        Case { in_study: &kip, in_script: &stated, ..BUILDING }.refused("check", &["the variable k", ratio]);
        Case { in_script: &stated, ..BUILDING }.accepted();
    }
    // A pressure of 2.7 MPa in kN is one of 2.7 kPa in N.
    Case { in_study: &label("units = [\"N\", \"m\"]"), in_script: &[silent], ..BUILDING }
        .warned("check", &["LRB: gravity of", "MPa: expected 0.3 to 60"]);
    Case { in_script: &[silent], ..BUILDING }.accepted();
    // Steel of fibers is steel in one unit of force alone.
    let silent = ("# Units: kN, m, s, t. The masses", "# The masses");
    Case { in_study: &kip, in_script: &[silent], ..FRAME }.warned("check", &["889.6 GPa", "steel in kN/m²"]);
    Case { in_script: &[silent], ..FRAME }.accepted();
    // A study without names has nothing to compare.
    Case { in_study: &label(""), ..BUILDING }.accepted();
}

/// A factor beside `scale` has no effect on the size of a motion; a turned sign has.
#[test]
fn factors_of_motions_beside_their_scaling() {
    let factor = |words: &'static str| [("dt = 0.02", words)];
    let told = ["Rio Dell 1992: its factor of 1.2 changes nothing"];
    Case { in_study: &factor("dt = 0.02\nfactor = 1.2"), ..BUILDING }.warned("check", &told);
    let (_, said) = Case { in_study: &factor("dt = 0.02\nfactor = -1.0"), ..BUILDING }.run("check");
    assert!(!said.contains("changes nothing"), "{said}");
}

/// A single component is told, and a pair is not.
#[test]
fn single_components_of_a_suite() {
    let (_, said) = BUILDING.run("check");
    let told: Vec<&str> = said.lines().filter(|l| l.contains("is no pair")).collect();
    assert!(told.len() == 1 && told[0].contains("Rio Dell 1992"), "{said}");
    let (status, said) = BRIDGE.run("check");
    assert!(status == Some(0) && !said.contains("is no pair"), "{said}");
}

/// Motions that cannot be applied are refused; supports that move are compared.
#[test]
fn scripts_without_a_uniform_excitation() {
    let patterns = "pattern UniformExcitation 2 1 -accel 2\npattern UniformExcitation 3 2 -accel 3\n";
    Case { in_script: &[(patterns, "")], ..BUILDING }
        .refused("check", &["the motions cannot be applied", "isolate(ax)", "pattern UniformExcitation 2 1 -accel 2"]);
    let loads = "pattern Plain 2 2 {\n foreach n {100 101 102 103} {load $n -120.0 0 0 0 0 0}\n}\n\
        pattern Plain 3 3 {\n foreach n {100 101 102 103} {load $n 0 -120.0 0 0 0 0}\n}\n";
    Case { in_script: &[(patterns, loads)], ..BUILDING }
        .warned("check", &["by loads or displacements", "was not compared"]);
    for (from, to, named) in [
        ("displacements $motion($d) $dt", "displacements $motion(1) $dt", ["moves in y", "correlation"]),
        ("-values [displacements", "-factor 9.81 -values [displacements", ["moves in x with 9.8", "without a factor"]),
        ("foreach d {1 2} {\n            remove sp", "foreach d {1} {\n            remove sp", ["in y", "no support"]),
    ] {
        Case { in_script: &[(from, to)], ..BRIDGE }.refused("check", &named);
    }
    // The ground of one support differs: the others follow the motion.
    let one = ("-values [displacements", "-factor [expr {$s == 2 ? 1.5 : 1.0}] -values [displacements");
    let (status, said) = Case { in_script: &[one], ..BRIDGE }.run("check");
    let words = ["moves in x with 1.5", "moves in y with 1.5", "supports differ so"];
    assert!(status == Some(0) && words.iter().all(|w| said.contains(w)), "{status:?} {said}");
}

/// A building whose supports move has the accelerations and displacements of one that is shaken as a whole.
#[test]
fn moving_supports_have_the_response_of_a_uniform_excitation() {
    let place = Place::new();
    let uniform = "pattern UniformExcitation 2 1 -accel 2\npattern UniformExcitation 3 2 -accel 3\n";
    let supports = "pattern MultipleSupport 2 {\n groundMotion 1 Plain -accel 2\n groundMotion 2 Plain -accel 3\n \
        for {set n 1} {$n <= 9} {incr n} {\n  foreach d {1 2} {\n   remove sp $n $d\n   imposedMotion $n $d $d\n  }\n }\n}\n";
    let one = [
        ("eccentricities = [[0.0, 0.0], [0.05, 0.05]]\n", ""),
        (
            "[[motion]]\nname = \"Rio Dell 1992\"\nfiles = [\"../ground_motions/riodell_1992_360_g.txt\"]\n\
             unit = \"g\"\ndt = 0.02\n",
            "",
        ),
    ];
    place.write("study.toml", replaced("isolation_study/study.toml", &one));
    let [first, second] = [uniform, supports].map(|patterns| {
        place.write("building.tcl", replaced("isolation_study/building.tcl", &[(uniform, patterns)]));
        let (status, _, said) = place.run(&["isolate", "study.toml", "--out", "out"]);
        assert_eq!(status, Some(0), "{said}");
        let text = fs::read_to_string(place.0.join("out/isolation.json")).unwrap();
        serde_json::from_str::<serde_json::Value>(&text).unwrap()["structure"].clone()
    });
    let rows = first.as_array().unwrap();
    assert_eq!(rows.len(), 6, "{first}");
    for (a, b) in rows.iter().zip(second.as_array().unwrap()) {
        for column in ["lower largest", "upper largest"] {
            let ratio = b[column].as_f64().unwrap() / a[column].as_f64().unwrap();
            // Displacements of the supports are integrated by the trapezoidal rule.
            assert!((ratio - 1.0).abs() < 0.005, "{a} {b}");
        }
    }
}
