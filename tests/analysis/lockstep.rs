//! Analyses of several models side by side against each by itself: the same numbers to the last bit.

use super::script::{Script, run};
use hysteron::opensees::lockstep::{Course, Execution, analyze};
use hysteron::run::End;
use std::collections::BTreeMap;

type Rows = BTreeMap<String, Vec<Vec<f64>>>;

/// Runs scripts whose analysis of a number waits; what came of each, and its rows.
fn side_by_side(scripts: &[String], analysis: u64) -> Vec<(Execution, Rows)> {
    let mut runs: Vec<_> = scripts.iter().map(|s| Script::default().ready(s, Some(Course::until(analysis)))).collect();
    let results: Vec<_> = runs.iter_mut().map(|(run, ..)| run.begin("model.tcl", &[])).collect();
    let made = analyze(&mut runs.iter_mut().map(|(run, ..)| run).collect::<Vec<_>>());
    let ended = runs.into_iter().zip(results).zip(made);
    ended
        .map(|(((mut run, _, tables), result), made)| {
            run.close(result);
            (made, tables.take())
        })
        .collect()
}

fn assert_same(rows: &Rows, alone: &Rows, script: &str) {
    for (name, own) in alone {
        let apart = rows[name].iter().zip(own).position(|(a, b)| a != b);
        let pair = apart.map(|i| (i, &rows[name][i], &own[i]));
        assert!(rows[name].len() == own.len() && apart.is_none(), "{name}: {pair:?} of {script}");
    }
}

/// Checks that all scripts go side by side, or each by itself, with the rows that each has alone.
pub(super) fn check(scripts: &[String], analysis: u64, expected: Execution) {
    for (script, (made, rows)) in scripts.iter().zip(side_by_side(scripts, analysis)) {
        assert_eq!(made, expected, "{script}");
        let alone = run(script).tables;
        assert!(alone.values().all(|rows| rows.len() > 50), "{script}");
        assert_same(&rows, &alone, script);
    }
}

/// Checks that some scripts fail and the others go side by side, with the rows that each has alone.
pub(super) fn check_failures(scripts: &[String], fails: impl Fn(usize) -> bool) {
    for (i, ((made, rows), script)) in side_by_side(scripts, 1).into_iter().zip(scripts).enumerate() {
        let alone = Script::default().run(script);
        assert_eq!(alone.tables["disp.out"].len() < 120, fails(i), "{i}");
        assert_eq!(made, if fails(i) { Execution::No } else { Execution::SideBySide }, "{i}");
        if !fails(i) {
            assert_same(&rows, &alone.tables, script);
        }
    }
}

const PATH: &str = "timeSeries Path 2 -dt 0.1 -values {0. 1. 0.5 -1. 2. -2. 0.3 1.5} -useLast";

fn analysis(test: &str) -> String {
    format!(
        "constraints Transformation; numberer Plain; system BandGeneral; test {test}; algorithm Newton
        integrator LoadControl 0.01; analysis Static"
    )
}

/// A bearing in the plane on an imposed path under a vertical load.
fn plane(bearing: &str, test: &str) -> String {
    format!(
        "model basic -ndm 2 -ndf 3; node 1 0 0; node 2 0 0.2; fix 1 1 1 1; fix 2 0 0 0
        uniaxialMaterial Elastic 1 4e5; uniaxialMaterial Elastic 2 1e5; uniaxialMaterial ElasticPP 3 1e5 0.0003
        element {bearing}
        {PATH}; timeSeries Constant 3
        pattern Plain 2 2 {{ sp 2 1 0.02 }}; pattern Plain 3 3 {{ load 2 0. -50. 2. }}
        recorder Node -file disp.out -time -node 2 -dof 1 2 3 disp
        recorder Element -file force.out -time -dT 0.02 -ele 1 force
        {}; analyze 120",
        analysis(test)
    )
}

/// A bearing in space, pulled in one direction and pushed in the other after its axial load.
fn space(bearing: &str) -> String {
    format!(
        "model basic -ndm 3 -ndf 6; node 1 0 0 0; node 2 0 0 0.3; fix 1 1 1 1 1 1 1; fix 2 0 0 0 1 0 1
        uniaxialMaterial Elastic 1 1e6
        element {bearing}
        timeSeries Linear 1; pattern Plain 1 1 {{ load 2 0. 0. -90. 0. 0. 0. }}
        {a}; analyze 60; loadConst -time 0.; wipeAnalysis
        {PATH}; pattern Plain 2 2 {{ sp 2 1 0.03; load 2 0. 6. 0. 0. 0.1 0. }}
        recorder Node -file disp.out -time -node 2 -dof 1 2 3 5 disp
        recorder Element -file force.out -ele 1 globalForce
        {a}; analyze 100; wipe",
        a = analysis("NormDispIncr 1e-11 30")
    )
}

fn bouc_wen(i: usize, eta: f64, alpha2: f64) -> String {
    let (k, qd, alpha) = (900.0 + 210.0 * i as f64, 8.0 + 1.3 * i as f64, 0.1 + 0.03 * i as f64);
    format!("elastomericBearingBoucWen 1 1 2 {k} {qd} {alpha} {alpha2} 2.0 {eta} 0.6 0.4")
}

#[test]
fn bearings_in_the_plane_have_the_numbers_that_each_has_alone() {
    let of = |eta, alpha2, rotation, test: &str| -> Vec<String> {
        (0..7)
            .map(|i| plane(&format!("{} -P 1 -Mz {rotation} -orient 0 1 0 -1 0 0", bouc_wen(i, eta, alpha2)), test))
            .collect()
    };
    check(&of(1.0, 0.0, 2, "NormDispIncr 1e-10 20"), 1, Execution::SideBySide);
    check(&of(2.0, 0.04, 2, "NormUnbalance 1e-8 20"), 1, Execution::SideBySide);
    check(&of(2.0, 0.0, 3, "EnergyIncr 1e-14 20"), 1, Execution::SideBySide);
    check(&of(1.4, 0.0, 2, "NormDispIncr 1e-10 20"), 1, Execution::SideBySide);
    // This test looks back at the iterations before.
    check(&of(1.0, 0.0, 2, "RelativeNormUnbalance 1e-10 20"), 1, Execution::ByItself);
}

#[test]
fn bearings_in_space_have_the_numbers_that_each_has_alone() {
    let tail = "-P 1 -T 1 -My 1 -Mz 1 -orient 0 0 1 1 0 0";
    let of = |eta| -> Vec<String> { (0..8).map(|i| space(&format!("{} {tail}", bouc_wen(i, eta, 0.0)))).collect() };
    check(&of(1.0), 2, Execution::SideBySide);
    check(&of(2.0), 2, Execution::SideBySide);
    // The first analysis has others behind it that need its results.
    assert!(side_by_side(&of(1.0), 1).iter().all(|(made, _)| *made == Execution::No));
}

/// A high damping bearing with all of its numbers its own.
fn hdr(i: usize, diameter: f64, a2: f64) -> String {
    let x = i as f64;
    let [g, a1, b1, b2, b3] = [450. + 9. * x, 450. + 60. * x, 12. + x, 250. - 9. * x, 60. + 2. * x];
    let [c1, c2, c3, c4] = [4. + 9. * x, 1.5 + 7. * x, 0.75 - 0.03 * x, 3. + 90. * x];
    format!(
        "HDR 1 1 2 {g} 2.0e6 {inner} {diameter} 0.003 0.006 28 {a1} {a2} 9.0e4 {b1} {b2} {b3} {c1} {c2} {c3} {c4} \\
        0 0 1 1 0 0 10.0 0.5 1.0 0.5 0.0 0.0",
        inner = 0.25 * diameter
    )
}

/// A bearing in space under an axial load that goes up and down, driven by displacements or by forces.
fn under_changing_axial_load(bearing: &str, axial: f64, lateral: &str, test: &str) -> String {
    format!(
        "model basic -ndm 3 -ndf 6; node 1 0 0 0; node 2 0 0 0.3; fix 1 1 1 1 1 1 1; fix 2 0 0 0 1 1 1
        element {bearing}
        timeSeries Path 1 -dt 0.15 -values {{0. -1. -1. 0.6 -0.8 1. -0.3 1. -1. -1.1}}; pattern Plain 1 1 {{ load 2 0. 0. {axial} 0. 0. 0. }}
        {PATH}; pattern Plain 2 2 {{ {lateral} }}
        recorder Node -file disp.out -time -node 2 -dof 1 2 3 disp
        recorder Element -file force.out -ele 1 globalForce
        {}; analyze 130",
        analysis(test)
    )
}

#[test]
fn high_damping_bearings_have_the_numbers_that_each_has_alone() {
    let test = "NormDispIncr 1e-10 30";
    check(&(0..8).map(|i| space(&hdr(i, 0.6, -6e3))).collect::<Vec<_>>(), 2, Execution::SideBySide);
    let pushed = |i: usize| under_changing_axial_load(&hdr(i, 0.6, -6e3), 90., "load 2 18. 0. 0. 0. 0. 0.", test);
    check(&(0..5).map(pushed).collect::<Vec<_>>(), 1, Execution::SideBySide);
    // Numbers that all share are worked out once; with zeros in them the damage has no effect.
    let alike = |i: usize| {
        let bearing = hdr(0, 0.6, -6e3).replace(" 450 ", &format!(" {} ", 450. + 50. * i as f64));
        let bearing = if i > 4 { bearing.replace(" 4 1.5 0.75 3 ", " 0 0 1 0 ") } else { bearing };
        under_changing_axial_load(&bearing, 90., "sp 2 1 0.08; sp 2 2 -0.03", test)
    };
    check(&(0..8).map(alike).collect::<Vec<_>>(), 1, Execution::SideBySide);
}

#[test]
fn high_damping_bearings_buckle_and_cavitate_each_by_itself() {
    let test = "NormDispIncr 1e-9 60";
    // From small to large: the first ones buckle under their load, or are torn beyond cavitation.
    let torn = |i: usize| hdr(i, 0.56 + 0.015 * i as f64, -6e3);
    let cavitates = |i: usize| under_changing_axial_load(&torn(i), 380., "sp 2 1 0.05; load 2 0. 5. 0. 0. 0. 0.", test);
    check(&(0..8).map(cavitates).collect::<Vec<_>>(), 1, Execution::SideBySide);
    let always_pressed = |script: String| script.replace(" 0.6 -0.8 1. -0.3 1. ", " -0.6 -0.8 -1. -0.3 -1. ");
    let slender = |i: usize| hdr(i, 0.3 + 0.01 * i as f64, -6e3);
    let buckles =
        |i: usize| always_pressed(under_changing_axial_load(&slender(i), 600., "sp 2 1 0.05; sp 2 2 0.02", test));
    // Five fall over, the sixth buckles and stands up again, two stand.
    check_failures(&(0..8).map(buckles).collect::<Vec<_>>(), |i| i < 5);
}

#[test]
fn bars_and_springs_have_the_numbers_that_each_has_alone() {
    for element in [
        "zeroLength 1 1 2 -mat 3 4 -dir 1 2",
        "twoNodeLink 1 1 2 -mat 3 4 -dir 1 2",
        "truss 1 1 2 1. 3; element truss 2 3 2 0.5 4",
        "corotTruss 1 1 2 1. 3; element corotTruss 2 3 2 0.5 4",
    ] {
        let script = |i: usize| {
            let fy = 40. + 3. * i as f64;
            format!(
                "model basic -ndm 2 -ndf 2; node 1 0 0; node 2 {length} 0; node 3 0 {length}; fix 1 1 1; fix 3 1 1; fix 2 0 0
                uniaxialMaterial Steel02 3 {fy} 9000. 0.02 18 0.925 0.15; uniaxialMaterial Maxwell 5 2000. 30. 1. 1.
                uniaxialMaterial Elastic 6 700.; uniaxialMaterial Parallel 4 5 6
                element {element}
                {PATH}; pattern Plain 2 2 {{ load 2 [expr {{0.4*{fy}}}] 3. }}
                recorder Node -file disp.out -node 2 -dof 1 2 disp; recorder Element -file force.out -ele 1 force
                {}; analyze 90",
                analysis("NormDispIncr 1e-11 40"),
                length = if element.starts_with("zero") { "0" } else { "2" },
            )
        };
        check(&(0..8).map(script).collect::<Vec<_>>(), 1, Execution::SideBySide);
    }
}

#[test]
fn a_model_that_fails_is_left_to_itself_and_changes_no_other() {
    let tail = "-P 1 -Mz 2 -orient 0 1 0 -1 0 0";
    // The third takes steps for which the law has no solution.
    let stiff = |i: usize| if i == 2 { "1300" } else { "100" };
    let script = |i: usize| {
        plane(
            &format!("elastomericBearingBoucWen 1 1 2 {} 8. 0.1 0. 2. 1. -1.0 3.0 {tail}", stiff(i)),
            "NormDispIncr 1e-10 20",
        )
    };
    check_failures(&(0..5).map(script).collect::<Vec<_>>(), |i| i == 2);
}

#[test]
fn models_that_differ_in_more_than_numbers_are_analysed_one_by_one() {
    let tail = "-P 1 -Mz 2 -orient 0 1 0 -1 0 0";
    let test = "NormDispIncr 1e-10 20";
    let mut scripts: Vec<String> = (0..4).map(|i| plane(&format!("{} {tail}", bouc_wen(i, 1.0, 0.0)), test)).collect();
    scripts[3] = plane(&format!("elastomericBearingPlasticity 1 1 2 900. 8. 0.1 0. 2. {tail}"), test);
    check(&scripts, 1, Execution::ByItself);
    scripts[3] = scripts[2].replace("0.3 1.5", "0.3 1.6");
    check(&scripts, 1, Execution::ByItself);
    scripts[3] = scripts[2].replace("fix 2 0 0 0", "fix 2 0 0 1");
    check(&scripts, 1, Execution::ByItself);
}

#[test]
fn a_script_that_asks_for_results_does_not_wait() {
    let tail = "-P 1 -Mz 2 -orient 0 1 0 -1 0 0";
    let script = plane(&format!("{} {tail}", bouc_wen(1, 1.0, 0.0)), "NormDispIncr 1e-10 20") + "; puts [nodeDisp 2 1]";
    let (mut run, ..) = Script::default().ready(&script, Some(Course::default()));
    let result = run.begin("model.tcl", &[]);
    run.close(result);
    assert_eq!(run.interp.host.course.and_then(|c| c.last_analysis()), None);
    assert_eq!(side_by_side(&[script], 1)[0].0, Execution::No);
}

#[test]
fn a_command_by_another_name_asks_for_results_too() {
    let tail = "-P 1 -Mz 2 -orient 0 1 0 -1 0 0";
    let script = plane(&format!("{} {tail}", bouc_wen(1, 1.0, 0.0)), "NormDispIncr 1e-10 20");
    let script = format!(
        "rename nodeDisp wipe_of_mine; rename node knot; proc node args {{ knot {{*}}$args }}; {script}; wipe_of_mine 2 1"
    );
    let (mut run, ..) = Script::default().ready(&script, Some(Course::default()));
    let result = run.begin("model.tcl", &[]);
    assert!(matches!(run.close(result), End::Done));
    assert_eq!(run.interp.host.course.and_then(|c| c.last_analysis()), None);
    assert_eq!(side_by_side(&[script], 1)[0].0, Execution::No);
}

#[test]
fn a_script_that_stops_early_leaves_the_others_side_by_side() {
    let tail = "-P 1 -Mz 2 -orient 0 1 0 -1 0 0";
    let of = |i| plane(&format!("{} {tail}", bouc_wen(i, 1.0, 0.0)), "NormDispIncr 1e-10 20");
    let mut scripts: Vec<String> = (0..4).map(of).collect();
    scripts[0] = scripts[0].replace("uniaxialMaterial Elastic 1 4e5", "error {no such bearing}");
    let made: Vec<Execution> = side_by_side(&scripts, 1).into_iter().map(|(made, _)| made).collect();
    assert_eq!(made, [Execution::No, Execution::SideBySide, Execution::SideBySide, Execution::SideBySide]);
}
