//! What `check` finds out about a model: the block of facts, and what cannot be meant. Each rule is silent on sound models.

use super::Place;
use serde_json::Value;

/// A portal of two columns with a weight of 981 kN on 100 t, in kN, m and s, under gravity and then a record.
const FRAME: &str = "model basic -ndm 2 -ndf 3\nnode 1 0 0\nnode 2 0 3\nnode 3 5 0\nnode 4 5 3\nfix 1 1 1 1\nfix 3 1 1 1\n\
    mass 2 50 50 0\nmass 4 50 50 0\ngeomTransf Linear 1\nelement elasticBeamColumn 1 1 2 0.16 3e7 2e-3 1\n\
    element elasticBeamColumn 2 3 4 0.16 3e7 2e-3 1\nelement elasticBeamColumn 3 2 4 0.16 3e7 2e-3 1\n\
    timeSeries Linear 1\npattern Plain 1 1 {\n  load 2 0 -490.5 0\n  load 4 0 -490.5 0\n}\nconstraints Plain\nalgorithm Linear\n\
    integrator LoadControl 0.1\nanalysis Static\nanalyze 10\n";
const SHAKEN: &str = "wipeAnalysis\ntimeSeries Path 2 -dt 0.01 -filePath gm.txt -factor 9.81\n\
    pattern UniformExcitation 2 1 -accel 2\nconstraints Plain\nalgorithm Linear\nintegrator Newmark 0.5 0.25\n\
    analysis Transient\nanalyze 100 0.01\n";

/// A record of 200 points that peaks at 0.3 g, at 0.57 s.
fn record() -> String {
    let value = |i: u32| if i == 57 { 0.3 } else { 0.25 * (0.3 * f64::from(i)).sin() };
    (0..200).map(|i| format!("{:.6}\n", value(i))).collect()
}

fn check(script: &str, option: &str) -> (Option<i32>, String, String) {
    let place = Place::new();
    place.write("gm.txt", record());
    let pairs: Vec<String> = record().lines().enumerate().map(|(i, v)| format!("{:.2} {v}", 0.01 * i as f64)).collect();
    place.write("pairs.txt", pairs.join("\n"));
    let head = "PEER\nA\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS= 200, DT= .0100 SEC\n";
    place.write("gm.at2", format!("{head}{}", record()));
    place.write("m.tcl", script);
    place.run(&["check", option, "m.tcl"])
}

/// Codes and messages of the findings.
fn findings(script: &str) -> Vec<(String, String)> {
    let (_, out, err) = check(script, "--json");
    let found: Value = serde_json::from_str(&out).unwrap_or_else(|e| panic!("{e}: {out}{err}"));
    let text = |m: &Value, key: &str| m[key].as_str().unwrap_or_default().to_owned();
    let messages = found["messages"].as_array().unwrap();
    messages.iter().map(|m| (text(m, "code"), text(m, "message"))).collect()
}

fn finds(script: &str, code: &str, words: &str) {
    let found = findings(script);
    assert!(found.len() == 1 && found[0].0 == code && found[0].1.contains(words), "{code}: {found:?}\n{script}");
}

fn finds_nothing(script: &str) {
    let found = findings(script);
    assert!(found.is_empty(), "{found:?}\n{script}");
}

/// Columns of 3 m with E A = 4.8e6: 490.5 · 3/4.8e6 = 3.066e-4 down.
#[test]
fn block_of_facts() {
    let (status, out, err) = check(&format!("{FRAME}loadConst -time 0\n{SHAKEN}"), "--show-output");
    assert!(status == Some(0) && err.is_empty(), "{err}");
    for line in [
        "  moving mass          100 along 1, 100 along 2\n",
        "  vertical reaction    981 along 2, and m g = 981 with g = 9.81\n",
        "  static displacement  -3.066e-4 at node ",
        "  excitation           pattern 2 along 1: peak 2.943 (0.3 g) at 0.57, lasts 2\n",
        "m.tcl: no mistakes\n",
    ] {
        assert!(out.contains(line), "{line}: {out}");
    }
    // The period of one mass on one spring is 2 π √(m/k).
    let (_, out, _) = check(
        "model basic -ndm 1 -ndf 1\nnode 1 0\nnode 2 0\nfix 1 1\nmass 2 4\nuniaxialMaterial Elastic 1 100\n\
         element zeroLength 1 1 2 -mat 1 -dir 1\neigen 1\n",
        "--show-output",
    );
    assert!(out.contains("  first period  1.257, with the first stiffness\n"), "{out}");
    // Without an analysis there is no block.
    let (_, out, _) = check("model basic -ndm 1 -ndf 1\nnode 1 0\n", "--show-output");
    assert_eq!(out, "m.tcl: no mistakes\n");
}

#[test]
fn gravity_that_still_grows() {
    finds(&format!("{FRAME}{SHAKEN}"), "growing-pattern", "pattern 1 still grows");
    finds(&format!("{FRAME}setTime 0\n{SHAKEN}"), "growing-pattern", "pattern 1 still grows");
    for held in ["loadConst", "loadConst -time 0", "remove loadPattern 1"] {
        let script = format!("{FRAME}{held}\n{SHAKEN}").replace("-filePath gm.txt", "-filePath gm.txt -startTime 1");
        assert!(findings(&script).iter().all(|(code, _)| code != "growing-pattern"), "{held}");
    }
    let constant = FRAME.replace("timeSeries Linear 1", "timeSeries Constant 1");
    assert!(findings(&format!("{constant}{SHAKEN}")).iter().all(|(code, _)| code != "growing-pattern"));
    // A pushover by displacement after gravity that is not held; a run tells of it where it fails.
    let pushed = "wipeAnalysis\ntimeSeries Linear 2\npattern Plain 2 2 {load 2 1 0 0}\nconstraints Plain\nalgorithm Newton\n\
        integrator DisplacementControl 2 1 0.001\nanalysis Static\nanalyze 3\n";
    finds(&format!("{FRAME}{pushed}"), "growing-pattern", "pattern 1 still grows");
    finds_nothing(&format!("{FRAME}loadConst -time 0\n{pushed}"));
    // One pattern alone is meant to grow.
    finds_nothing(&format!("{FRAME}integrator DisplacementControl 2 2 -0.001\nanalysis Static\nanalyze 3\n"));
}

#[test]
fn loads_and_masses() {
    let sound = format!("{FRAME}loadConst -time 0\n{SHAKEN}");
    finds_nothing(&sound);
    finds(&sound.replace("-490.5", "490.5"), "gravity-upwards", "push upwards: 981 along 2");
    // Loads that are no weight of the masses may push upwards.
    finds_nothing(&sound.replace("-490.5", "40"));
    finds(&sound.replace("50 50 0", "490.5 490.5 0"), "mass-is-weight", "the same numbers as the static loads, 981");
    finds_nothing(&sound.replace("50 50 0", "1 1 0").replace("-490.5", "-1"));
    // Kilograms beside kilonewtons.
    finds(&sound.replace("50 50 0", "50000 50000 0"), "mass-units", "0.00981 for each unit of mass, and g is 9.81");
    // Where the mass is the weight of a part of the loads nothing is said.
    finds_nothing(&sound.replace("-490.5", "-700"));
    // kip, in: a weight of 900 kip taken for the mass.
    let pier = "model basic -ndm 2 -ndf 3\nnode 1 0 0\nnode 2 0 240\nfix 1 1 1 1\nmass 2 MASS MASS 0\ngeomTransf Linear 1\n\
        element elasticBeamColumn 1 1 2 2000. 3600. 400000. 1\neigen 1\n";
    finds(&pier.replace("MASS", "900."), "long-period", "the first period is 10.66");
    finds_nothing(&pier.replace("MASS", "2.331"));
    // The same on a bearing, whose ground is node 3.
    let bearing = pier.replace(
        "fix 1 1 1 1\n",
        "node 3 0 -10\nfix 3 1 1 1\nuniaxialMaterial Elastic 1 8e3\nuniaxialMaterial Elastic 2 1e8\n\
        element elastomericBearingPlasticity 2 3 1 20. 50. 0. 0. 1. -P 1 -Mz 2 -orient 0 1 0 -1 0 0\n",
    );
    finds(&bearing.replace("MASS", "900."), "long-period", "longer than the 10 s");
    finds_nothing(&bearing.replace("MASS", "2.331"));
}

#[test]
fn records_in_other_units() {
    let sound = format!("{FRAME}loadConst -time 0\n{SHAKEN}");
    finds(&sound.replace(" -factor 9.81", ""), "record-in-g", "which is 0.03");
    finds(&sound.replace("-factor 9.81", "-factor 981"), "record-too-strong", "which is 30 g");
    let two = sound.replace("gm.txt -factor 9.81", "pairs.txt -factor 9.81");
    assert!(
        findings(&two).iter().any(|(code, m)| code == "two-columns" && m.contains("400 values")),
        "{:?}",
        findings(&two)
    );
    let peer = |factor: &str| {
        sound.replace(
            "timeSeries Path 2 -dt 0.01 -filePath gm.txt -factor 9.81",
            &format!("motionFile 2 gm.at2 {factor}"),
        )
    };
    finds(&peer(""), "record-in-g", "is in g, as gm.at2 says");
    finds_nothing(&peer("-factor 9.81"));
    finds_nothing(&peer("").replace("-accel 2", "-accel 2 -fact 9.81"));
    // A path of a few points is no record.
    finds_nothing(&sound.replace("-filePath gm.txt -factor 9.81", "-values {0 0.1 0}"));
}

#[test]
fn masses_that_do_not_move() {
    let held =
        format!("{FRAME}loadConst -time 0\n{SHAKEN}").replace("fix 1 1 1 1", "fix 1 1 1 1\nfix 2 0 1 0\nfix 4 0 1 0");
    finds(&held.replace("Excitation 2 1", "Excitation 2 2"), "no-mass", "along 2, where the model has no mass");
    finds_nothing(&held);
}

#[test]
fn bearing_on_its_side() {
    let bearing = "model basic -ndm 2 -ndf 3\nnode 1 0 0\nnode 2 0 0 -mass 100 100 1\nfix 1 1 1 1\nfix 2 0 0 1\n\
        uniaxialMaterial Elastic 1 1e6\nelement elastomericBearingPlasticity 1 1 2 1000. 20. 0.02 0. 1. -P 1 -Mz 1 ORIENT\n\
        timeSeries Linear 1\npattern Plain 1 1 {load 2 0 -981 0}\nconstraints Plain\nalgorithm Newton\n\
        integrator LoadControl 1\nanalysis Static\nanalyze 1\nloadConst -time 0\n";
    finds(
        &bearing.replace("ORIENT", "-orient 1 0 0 0 1 0"),
        "bearing-on-its-side",
        "the local x of ElastomericBearingPlasticity2d 1 lies across its load",
    );
    finds_nothing(&bearing.replace("ORIENT", "-orient 0 1 0 -1 0 0"));
}

/// A slab of 100 t on a slider in the plane, under gravity and then a record.
const SLIDER: &str = "model basic -ndm 2 -ndf 3\nnode 1 0 0\nnode 2 0 0 -mass 100 100 1\nfix 1 1 1 1\nfix 2 0 0 1\n\
    uniaxialMaterial Elastic 1 1e6\nfrictionModel Coulomb 1 0.06\n\
    element flatSliderBearing 1 1 2 1 5e4 -P 1 -Mz 1 -orient 0 1 0 -1 0 0\n\
    timeSeries Linear 1\npattern Plain 1 1 {load 2 0 -981 0}\nconstraints Plain\nalgorithm Newton\n\
    integrator LoadControl 1\nanalysis Static\nanalyze 1\nloadConst -time 0\n";

#[test]
fn motion_without_gravity() {
    let sound = format!("{SLIDER}{SHAKEN}");
    finds_nothing(&sound);
    let forgotten = sound.replace("{load 2 0 -981 0}", "{}");
    finds(&forgotten, "no-gravity", "of pattern 2 begins while bearing 1 carries no load along 2");
    // A vertical record is no gravity, and a constant acceleration is.
    let third = "timeSeries Path 3 -dt 0.01 -filePath gm.txt -factor 9.81\npattern UniformExcitation 3 2 -accel 3\n";
    let with = |more: &str| forgotten.replace("integrator Newmark", &format!("{more}integrator Newmark"));
    finds(&with(third), "no-gravity", "bearing 1 carries no load along 2");
    finds_nothing(&with("timeSeries Constant 3 -factor 9.81\npattern UniformExcitation 3 2 -accel 3\n"));
    // Held nodes carry their load by themselves, and a test without a ground motion asks for none.
    finds_nothing(&forgotten.replace("fix 2 0 0 1", "fix 2 0 1 1"));
    let moved = SLIDER.replace("{load 2 0 -981 0}", "{sp 2 1 0.1}");
    finds_nothing(&moved.replace("constraints Plain", "constraints Transformation"));
    // A mass on rubber alone is a study of its law; a structure on rubber has a weight.
    let slider = "flatSliderBearing 1 1 2 1 5e4 -P 1";
    let springs = forgotten.replace(slider, "RJWatsonEqsBearing 1 1 2 1 5e4 -P 1 -Vy 2");
    let springs = springs.replace("frictionModel", "uniaxialMaterial Elastic 2 500.\nfrictionModel");
    finds(&springs, "no-gravity", "bearing 1 carries no load along 2");
    let rubber = forgotten.replace(slider, "elastomericBearingPlasticity 1 1 2 1000. 20. 0.02 0. 1. -P 1");
    finds_nothing(&rubber);
    let column = "node 3 0 3 -mass 50 50 1\ngeomTransf Linear 1\nelement elasticBeamColumn 2 2 3 0.16 3e7 2e-3 1\ntimeSeries Linear 1";
    finds(&rubber.replace("timeSeries Linear 1", column), "no-gravity", "bearing 1 carries no load along 2");
    // A run says the same.
    let place = Place::new();
    place.write("gm.txt", record());
    place.write("m.tcl", forgotten);
    let (_, _, err) = place.run(&["run", "m.tcl"]);
    assert!(err.contains("[no-gravity]"), "{err}");
}

#[test]
fn floor_without_mass() {
    // The portal with two storeys on top of it, each as heavy.
    let storey = |level: u32| {
        let (a, b, c, d) = (2 * level, 2 * level + 2, 10 * level, 3 * level);
        format!(
            "node {b} 0 {d}\nnode 1{b} 5 {d}\nmass {b} 50 50 0\nmass 1{b} 50 50 0\n\
             element elasticBeamColumn {c} {a} {b} 0.16 3e7 2e-3 1\nelement elasticBeamColumn 1{c} {from} 1{b} 0.16 3e7 2e-3 1\n\
             element elasticBeamColumn 2{c} {b} 1{b} 0.16 3e7 2e-3 1\n",
            from = if level == 2 { "4".to_owned() } else { format!("1{a}") },
        )
    };
    let sound = format!(
        "{}loadConst -time 0\n{SHAKEN}",
        FRAME
            .replace("-490.5", "-1471.5")
            .replace("timeSeries Linear 1\n", &format!("{}{}timeSeries Linear 1\n", storey(2), storey(3)))
    );
    finds_nothing(&sound.replace("mass 6", "# mass 6"));
    let forgotten = sound.replace("mass 6", "# mass 6").replace("mass 16", "# mass 16");
    finds(
        &forgotten,
        "floor-without-mass",
        "the floor at height 6, with node 6, has no mass along 1; 2 floors have one",
    );
    // A density gives it one.
    finds_nothing(&forgotten.replace(
        "element elasticBeamColumn 220 6 16 0.16 3e7 2e-3 1",
        "element elasticBeamColumn 220 6 16 0.16 3e7 2e-3 1 -mass 20",
    ));
}

#[test]
fn static_analysis_of_a_record() {
    let sound = format!("{FRAME}loadConst -time 0\n{SHAKEN}");
    let still = sound.replace(
        "integrator Newmark 0.5 0.25\nanalysis Transient\nanalyze 100 0.01",
        "integrator LoadControl 0.01\nanalysis Static\nanalyze 100",
    );
    finds(&still, "static-ground-motion", "under the ground motion of pattern 2");
    // Gravity as a constant acceleration.
    finds_nothing(&still.replace("timeSeries Path 2 -dt 0.01 -filePath gm.txt -factor 9.81", "timeSeries Constant 2"));
}

/// A degree of freedom that none of the nodes of a recorder has, and a column that no response has.
#[test]
fn columns_that_are_not_there() {
    let record = |words: &str| format!("{FRAME}recorder {words}\n");
    let found = findings(&record("Node -file a.out -node 2 4 -dof 1 4 disp"));
    assert!(found.len() == 1 && found[0].1.contains("no degree of freedom 4 at node 2: it has 3"), "{found:?}");
    let found = findings(&record("Element -file a.out -ele 1 2 -dof 1 9 localForce"));
    assert!(found.len() == 1 && found[0].1.contains("no column 9 of response \"localForce\": it has 6"), "{found:?}");
    finds_nothing(&record("Node -file a.out -node 2 4 -dof 1 2 3 disp"));
    // One of the nodes has it.
    let larger = record("Node -file a.out -node 2 9 -dof 4 disp");
    finds_nothing(&larger.replacen("node 1 ", "node 9 0 0 -ndf 6\nfix 9 1 1 1 1 1 1\nnode 1 ", 1));
}

/// Lead, steel and rubber in one system of units: N and m, N and mm, kN and m; and the SI numbers of the manual in the others.
#[test]
fn thermal_constants_in_other_units() {
    let bearing = |length: f64, force: f64, thermal: &str| {
        let (p, d) = (length * length / force, |x: f64| x / length);
        format!(
            "model basic -ndm 3 -ndf 6\nnode 1 0 0 0\nnode 2 0 0 {}\nelement LeadRubberX 1 1 2 {} 0.1 {} {} {} {} {} {} 20 \
             0 0 1 1 0 0 10 0.5 1.0 0.5 0 0 0 {thermal} 0 0 0 0 1\n",
            d(0.3),
            120e3 / force,
            0.6e6 * p,
            2e9 * p,
            d(0.12),
            d(0.6),
            d(0.003),
            d(0.008)
        )
    };
    let (si, mm, kn) = ("11200. 130. 50. 1.41e-5", "1.12e-8 1.3e8 50. 14.1", "11.2 130. 0.05 1.41e-5");
    for (length, force, thermal) in [(1.0, 1.0, si), (1e-3, 1.0, mm), (1.0, 1e3, kn)] {
        finds_nothing(&bearing(length, force, thermal));
    }
    for (length, force) in [(1e-3, 1.0), (1.0, 1e3), (1e-3, 1e3), (0.0254, 4448.2)] {
        finds(&bearing(length, force, si), "thermal-units", "not in the units of the bearing");
    }
    finds(&bearing(1.0, 1.0, "11200. 130. 50. 14.1"), "thermal-units", "of steel");
    // Without heating the constants are not used.
    finds_nothing(&bearing(1e-3, 1.0, si).replace("0 0 0 0 1\n", "0 0 0 0 0\n"));
}

/// Forces that are left over once the loads have gone are round-off, and so is a gap of a penalty.
#[test]
fn no_false_alarm_at_rest() {
    let place = Place::new();
    let unloaded = FRAME.replace("timeSeries Linear 1", "timeSeries Path 1 -time {0 1 2 3} -values {0 1 0 0}")
        + "integrator LoadControl 0.5\nalgorithm Newton\ntest NormUnbalance 1e-6 20\nanalysis Static\nanalyze 4\n";
    for handler in ["Plain", "Penalty 1e12 1e12"] {
        place.write("m.tcl", unloaded.replace("constraints Plain", &format!("constraints {handler}")));
        let (status, _, err) = place.run(&["run", "--strict", "m.tcl"]);
        assert!(status == Some(0) && err.is_empty(), "{handler}: {err}");
    }
}
