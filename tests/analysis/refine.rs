//! Steps made in parts.

use super::close;
use super::script::{Ran, Script, run};
use hysteron::analysis::RecoveryStrategy;

fn refined(text: &str, refine: u32) -> Ran {
    let mut script = Script::default();
    script.options.refine = refine;
    script.run(text)
}

/// A mass on a spring that yields.
const MOVED: &str = "model basic -ndm 1 -ndf 1; node 1 0; node 2 0 -mass 2.0; fix 1 1
    uniaxialMaterial BoucWen 1 0.1 300. 1.5 40. 40. 1. 0. 0. 0.; element zeroLength 1 1 2 -mat 1 -dir 1
    timeSeries Trig 1 0. 100. 0.9 -factor 8.
    constraints Plain; numberer Plain; system FullGeneral; test NormUnbalance 1e-11 30; algorithm Newton
    recorder Node -file u.out -time -node 2 -dof 1 disp\n";

/// Four parts are four steps of a quarter, of which recorders see the last.
#[test]
fn parts_are_shorter_steps() {
    let shaken = "pattern UniformExcitation 1 1 -accel 1";
    let pushed = "pattern Plain 1 1 { load 2 1.0 }";
    for (load, integrator, analysis, quarter) in [
        (shaken, "Newmark 0.5 0.25", "Transient; analyze 40 0.04", "Transient; analyze 160 0.01"),
        (shaken, "HHT 0.8", "Transient; analyze 40 0.04", "Transient; analyze 160 0.01"),
        (shaken, "TRBDF2", "Transient; analyze 40 0.04", "Transient; analyze 160 0.01"),
        (shaken, "CentralDifference; algorithm Linear", "Transient; analyze 40 0.04", "Transient; analyze 160 0.01"),
        (pushed, "LoadControl 0.04", "Static; analyze 40", "Static; integrator LoadControl 0.01; analyze 160"),
        (
            "pattern Plain 1 {Linear} { load 2 1.0 }",
            "DisplacementControl 2 1 0.004",
            "Static; analyze 40",
            "Static; integrator DisplacementControl 2 1 0.001; analyze 160",
        ),
    ] {
        let script =
            |analysis: &str| format!("{MOVED}{load}\nintegrator {integrator}; analysis {analysis}; puts [getTime]");
        let (parts, steps) = (refined(&script(analysis), 4).done(), refined(&script(quarter), 1).done());
        let (parts, steps) = (&parts.tables["u.out"], &steps.tables["u.out"]);
        assert_eq!((parts.len(), steps.len()), (40, 160), "{integrator}");
        let most = steps.iter().fold(0.0f64, |m, row| m.max(row[1].abs()));
        for (a, b) in parts.iter().zip(steps.iter().skip(3).step_by(4)) {
            assert!(close(a[0], b[0], 1e-12) && (a[1] - b[1]).abs() < 1e-9 * most, "{integrator}: {a:?} {b:?}");
        }
        // Not what the long steps say.
        let long = &run(&script(analysis)).done().tables["u.out"];
        let apart = parts.iter().zip(long).fold(0.0f64, |m, (a, b)| m.max((a[1] - b[1]).abs()));
        assert!(apart > 1e-5 * most || load != shaken, "{integrator}: {apart}");
    }
}

/// A step that cannot be divided is taken whole.
#[test]
fn arc_length_steps_are_not_divided() {
    let script = format!(
        "{MOVED}pattern Plain 1 {{Linear}} {{ load 2 1.0 }}\nintegrator ArcLength 0.01 1.0; analysis Static; analyze 20
        puts \"[nodeDisp 2 1] [getTime]\""
    );
    let (parts, steps) = (refined(&script, 4).done().numbers(), refined(&script, 1).done().numbers());
    assert!(close(parts[0], steps[0], 1e-9) && close(parts[1], steps[1], 1e-9), "{parts:?} {steps:?}");
}

/// Nothing is committed if a later part of a step fails.
#[test]
fn a_step_fails_as_a_whole() {
    // It carries 1.5: half of the second step is possible.
    let script = "model basic -ndm 1 -ndf 1; node 1 0; node 2 0; fix 1 1
        uniaxialMaterial ElasticPP 1 100. 0.015; element zeroLength 1 1 2 -mat 1 -dir 1
        pattern Plain 1 Linear { load 2 1.0 }
        constraints Plain; numberer Plain; system FullGeneral; test NormUnbalance 1e-9 10; algorithm Newton
        integrator LoadControl 0.8; analysis Static
        puts \"[analyze 1] [analyze 1] [getTime] [nodeDisp 2 1]\"";
    let ran = refined(script, 4);
    let numbers = ran.numbers();
    assert!(numbers[0] == 0.0 && numbers[1] < 0.0, "{numbers:?}");
    assert!(close(numbers[2], 0.8, 1e-12) && close(numbers[3], 0.008, 1e-9), "{numbers:?}");
}

/// A failed step leaves the multipliers of `constraints Lagrange` as they were: none before the first step.
#[test]
fn a_step_with_multipliers_is_tried_again() {
    // It carries 1.5: the first step is too much, the second is not.
    let script = |kind: &str| {
        format!(
            "model basic -ndm 1 -ndf 1; node 1 0; node 2 0; node 3 0; fix 1 1; equalDOF 2 3 1
            mass 2 1.; mass 3 1.
            uniaxialMaterial ElasticPP 1 100. 0.015; element zeroLength 1 1 2 -mat 1 -dir 1
            pattern Plain 1 Linear {{ load 3 1.0 }}
            constraints Lagrange; numberer Plain; system FullGeneral; test NormUnbalance 1e-9 10; algorithm Newton
            {kind}"
        )
    };
    let pushed = script(
        "integrator LoadControl 2.0; analysis Static; set first [analyze 1]
        integrator LoadControl 0.8
        puts \"$first [analyze 1] [getTime] [nodeDisp 3 1] [lindex [eleResponse 1 force] 1]\"",
    );
    // The first correction is never so small.
    let shaken = script(
        "test NormDispIncr 1e-300 1; integrator Newmark 0.5 0.25; analysis Transient; set first [analyze 1 0.1]
        test NormUnbalance 1e-9 10; algorithm Newton
        puts \"$first [analyze 1 0.8] [getTime] [nodeDisp 3 1] [nodeDisp 2 1]\"",
    );
    for ladder in [None, Some(RecoveryStrategy::default())] {
        for refine in [1, 4] {
            let made = |text: &str| {
                let mut script = Script::default();
                (script.options.refine, script.options.ladder) = (refine, ladder.clone());
                script.run(text).numbers()
            };
            let n = made(&pushed);
            assert!(n[0] < 0.0 && n[1] == 0.0 && close(n[2], 0.8, 1e-12), "{n:?}");
            assert!(close(n[3], 0.008, 1e-9) && close(n[4], 0.8, 1e-9), "{n:?}");
            let n = made(&shaken);
            assert!(n[0] < 0.0 && n[1] == 0.0 && close(n[2], 0.8, 1e-12) && close(n[3], n[4], 1e-9), "{n:?}");
        }
    }
}

/// Refinement tightens the test: the error that a loose one leaves shows.
#[test]
fn refinement_tightens_the_convergence_test() {
    let left = |refine: u32| {
        let loose = MOVED.replace("test NormUnbalance 1e-11 30", "test NormUnbalance 1e-1 30");
        let script = format!(
            "{loose}pattern Plain 1 1 {{ load 2 1.0 }}\nintegrator LoadControl 0.01; analysis Static; analyze 20
            puts \"[lindex [eleResponse 1 force] 1] [getLoadFactor 1]\""
        );
        let n = refined(&script, refine).done().numbers();
        (n[0] - n[1]).abs()
    };
    assert!(left(1) > 1e-4 && left(2) < 1e-3, "{} {}", left(1), left(2));
    // A hundredth of a tolerance near round-off is had as well as it can be.
    let tight = MOVED.replace("1e-11 30", "1e-13 30");
    let newmark = "integrator Newmark 0.5 0.25; analysis Transient; analyze 40 0.01";
    let script = format!("{tight}pattern UniformExcitation 1 1 -accel 1\n{newmark}");
    let rows = |refine: u32| refined(&script, refine).done().tables["u.out"].len();
    assert_eq!((rows(1), rows(2)), (40, 40));
}
