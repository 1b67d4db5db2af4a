//! A check goes on with a command that is wrong, so that its other mistakes and those behind it are told.

use super::{MODEL, Place};

/// Messages of a check as `severity line:column code`.
fn told(script: &str) -> Vec<String> {
    let place = Place::new();
    place.write("m.tcl", script);
    let (_, out, _) = place.run(&["check", "--json", "m.tcl"]);
    let table: serde_json::Value = serde_json::from_str(&out).unwrap();
    let line = |m: &serde_json::Value| {
        let text = |key: &str| m[key].as_str().unwrap_or("-").to_owned();
        format!("{} {}:{} {} {}", text("severity"), m["line"], m["column"], text("code"), text("message"))
    };
    table["messages"].as_array().unwrap().iter().filter(|m| m["severity"] != "note").map(line).collect()
}

/// Line behind the model.
fn line() -> usize {
    MODEL.lines().count() + 1
}

#[test]
fn a_flag_that_is_no_flag_counts_as_in_opensees() {
    let n = line();
    let flag = |column: usize, flag: usize| {
        format!("warning {n}:{column} no-flag flag of degree of freedom {flag} is 2 and counts as 1")
    };
    assert_eq!(told(&format!("{MODEL}fix 3 1 2 0\n")), [flag(9, 2)]);
    assert_eq!(told(&format!("{MODEL}fixY 0 2 1 1\n")), [flag(8, 1)]);
    assert_eq!(told(&format!("{MODEL}fix 3 1 0 1\n")), [] as [&str; 0]);
    let other = |word: &str, as_one: u8| format!("warning {n}:{} no-flag flag is 3 and counts as {as_one}", word.len());
    let truss = "element truss 2 1 3 1 1 -cMass 3";
    assert_eq!(told(&format!("{MODEL}{truss}\n")), [other(truss, 1)]);
    let spring = "node 4 0 0; element zeroLength 2 1 4 -mat 1 -dir 1 -doRayleigh 3";
    assert_eq!(told(&format!("{MODEL}{spring}\n")), [other(spring, 0)]);
    // It holds, with or without the numbers of OpenSees.
    let script = format!("{MODEL}fix 3 0 2 0\nputs [llength [getFixedDOFs 3]]\n");
    let place = Place::new();
    place.write("m.tcl", script);
    for compat in [&["run", "m.tcl"][..], &["run", "--compat", "opensees", "m.tcl"]] {
        let (status, out, err) = place.run(compat);
        assert!(status == Some(0) && out == "1\n" && err.contains("counts as 1"), "{out}{err}");
    }
}

/// The second mistake of a command, and a recorder of what the command makes.
#[test]
fn a_missing_material_hides_no_other_mistake() {
    let n = line();
    let script = format!(
        "{MODEL}element truss 2 1 3 1.0 55 -doRaleigh 1\nrecorder Element -file f.out -ele 2 forse\n\
         element truss 3 1 3 1.0 55\npattern Plain 2 9 {{ load 77 1 0 0 }}\n"
    );
    assert_eq!(
        told(&script),
        [
            format!("error {n}:25 not-defined there is no uniaxial material 55"),
            format!(
                "warning {n}:28 unknown-option element: \"-doRaleigh\" is not an option and is ignored, and so is what follows it"
            ),
            format!("warning {}:37 not-in-model Truss has no response \"forse\"", n + 1),
            format!("error {}:25 not-defined there is no uniaxial material 55", n + 2),
            format!("error {}:17 not-defined there is no time series 9", n + 3),
            format!("error {}:26 not-defined there is no node 77", n + 3),
        ]
    );
}

/// A number without meaning that OpenSees computes with: a run is refused, a check goes on.
#[test]
fn a_check_goes_on_where_opensees_would() {
    let n = line();
    let script = format!(
        "{MODEL}element elasticBeamColumn 2 1 3 -0.1 0 1e-3 1\nrecorder Element -file f.out -ele 2 forse\n\
         recorder Element -file g.out -ele 2 force\n"
    );
    let told = told(&script);
    assert_eq!(told.len(), 3, "{told:?}");
    assert!(told[0].starts_with(&format!("error {n}:33 out-of-range cross-sectional area A is -0.1")), "{told:?}");
    assert!(told[1].starts_with(&format!("error {n}:38 out-of-range elastic modulus E is 0")), "{told:?}");
    assert!(told[2].contains("has no response \"forse\""), "{told:?}");
}

/// A command that warns and then misses something warns once.
#[test]
fn a_command_that_runs_again_warns_once() {
    let script = format!("{MODEL}uniaxialMaterial MinMax 7 88 -mn 1\nelement truss 2 1 3 1 89 -nothing\n");
    let told = told(&script);
    assert_eq!(told.len(), 4, "{told:?}");
    assert!(told.iter().all(|t| !t.contains("times")), "{told:?}");
}
