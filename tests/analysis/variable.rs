//! Steps whose length follows the iterations, and steps that are too short.

use super::close;
use super::script::{Script, run};

/// A test that allows fewer iterations than a step should take fails before the ratio of the two makes the next step shorter.
#[test]
fn a_step_that_fails_at_once_is_shortened() {
    let ran = run("model basic -ndm 1 -ndf 1; node 1 0; node 2 0 -mass 2.0; fix 1 1
        uniaxialMaterial BoucWen 1 0.1 300. 1.5 40. 40. 1. 0. 0. 0.; element zeroLength 1 1 2 -mat 1 -dir 1
        timeSeries Trig 1 0. 100. 0.9 -factor 8.; pattern UniformExcitation 1 1 -accel 1
        recorder Node -file u.out -time -node 2 -dof 1 disp
        constraints Plain; numberer Plain; system FullGeneral; test NormUnbalance 1e-3 3; algorithm Newton
        integrator Newmark 0.5 0.25; analysis VariableTransient
        puts [analyze 10 0.2 1e-4 0.2 4]");
    assert_eq!(ran.numbers(), [0.0], "{}", ran.err);
    let times: Vec<f64> = ran.tables["u.out"].iter().map(|r| r[0]).collect();
    let steps: Vec<f64> = times.windows(2).map(|t| t[1] - t[0]).collect();
    assert!(times.last().is_some_and(|t| (1.9999..2.2).contains(t)), "{times:?}");
    assert!(steps.iter().all(|s| *s > 0.99e-4 && *s < 0.2001) && steps.iter().any(|s| *s < 0.1), "{steps:?}");
}

/// A mechanism fails before its first iteration, whatever the step: the smallest one ends the analysis.
#[test]
fn step_that_always_fails_ends_at_the_smallest_length() {
    for before in ["", "analyze 3 0.01 0.001 0.02 3;"] {
        let ran = Script::default().run(&format!(
            "model basic -ndm 1 -ndf 1; node 1 0; node 2 0 -mass 2.0; node 3 0; node 4 0; fix 1 1
            uniaxialMaterial Elastic 1 100.; element zeroLength 1 1 2 -mat 1 -dir 1; element zeroLength 2 2 3 -mat 1 -dir 1
            element zeroLength 3 3 4 -mat 1 -dir 1
            timeSeries Constant 1; pattern Plain 1 1 {{ load 2 1. }}
            constraints Plain; numberer Plain; system FullGeneral; test NormUnbalance 1e-10 10; algorithm Newton
            integrator Newmark 0.5 0.25; analysis VariableTransient
            {before} remove element 3; set start [getTime]
            puts \"[analyze 10 0.1 0.001 0.1 5] [expr {{[getTime] - $start}}]\""
        ));
        let n = ran.numbers();
        assert!(n[0] < 0.0 && n[1] == 0.0, "{n:?}");
        assert!(ran.warnings().iter().any(|d| d.message.contains("mechanism")), "{:?}", ran.warnings());
    }
}

/// The inverse of the square of a step overflows: the step fails, and a longer one goes on from where the model was.
#[test]
fn steps_that_are_too_short_fail() {
    let integrators = [
        ("Newmark 0.5 0.25", "Newton"),
        ("Newmark 0.5 0.25 -form A", "Newton"),
        ("HHT 0.9", "ModifiedNewton"),
        ("GeneralizedAlpha 1.0 0.9", "KrylovNewton"),
        ("WilsonTheta 1.4", "BFGS"),
        ("Collocation 1.4", "NewtonLineSearch"),
        ("TRBDF2", "Newton -initial"),
        ("AlphaOS 0.9", "Linear"),
        ("KRAlphaExplicit 0.5", "Linear"),
        ("CentralDifference", "Linear"),
        ("NewmarkExplicit 0.5", "Linear"),
        ("HHTHSFixedNumIter 0.9", "Newton"),
    ];
    for law in ["Elastic 1 100.", "Steel01 1 35. 1500. 0.05"] {
        for (integrator, algorithm) in integrators {
            for (damping, refine) in [("0.1 0. 0. 0.", 1), ("0.1 0.001 0.001 0.001", 4)] {
                let mut script = Script::default();
                script.options.refine = refine;
                let ran = script.run(&format!(
                    "model basic -ndm 1 -ndf 1; node 1 0; node 2 0 -mass 12.; fix 1 1
                    uniaxialMaterial {law}; element zeroLength 1 1 2 -mat 1 -dir 1 -doRayleigh 1; rayleigh {damping}
                    timeSeries Constant 1; pattern Plain 1 1 {{ load 2 1. }}
                    constraints Plain; numberer Plain; system FullGeneral; test NormUnbalance 1e-9 10; algorithm {algorithm}
                    integrator {integrator}; analysis Transient
                    set short [analyze 1 1e-308]; set time [getTime]; set next [analyze 1 0.001]
                    puts \"$short $time $next [nodeDisp 2 1]\""
                ));
                let n = ran.done().numbers();
                assert!(n[0] == 0.0 || n[1] == 0.0, "{integrator}, {law}: {n:?}");
                assert!(n[2] == 0.0 && n[3].is_finite(), "{integrator}, {law}: {n:?}");
            }
        }
    }
    let ran = run("model basic -ndm 1 -ndf 1; node 1 0; node 2 0 -mass 12.; fix 1 1
        uniaxialMaterial Steel01 1 35. 1500. 0.05; element zeroLength 1 1 2 -mat 1 -dir 1
        timeSeries Constant 1; pattern Plain 1 1 { load 2 1. }
        constraints Plain; numberer Plain; system FullGeneral; test NormUnbalance 1e-9 10; algorithm Newton
        integrator Newmark 0.5 0.25; analysis Transient
        puts \"[analyze 1 1e-308] [getTime] [analyze 1 0.001] [getTime]\"");
    let n = ran.numbers();
    assert!(n[0] < 0.0 && n[1] == 0.0 && n[2] == 0.0 && close(n[3], 0.001, 1e-12), "{n:?}");
    assert!(ran.warnings().iter().any(|d| d.message.contains("not finite")), "{:?}", ran.warnings());
}
