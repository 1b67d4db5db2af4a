//! Integrators that weight the forces of both ends of a step, and explicit ones beside them.

use super::close;
use super::dynamics::{exact, free_vibration, with_algorithm, with_test};
use super::script::{Script, run};

fn order(error: impl Fn(f64) -> f64) -> f64 {
    (error(0.005) / error(0.0025)).log2()
}

#[test]
fn trapezoidal_integrators_have_their_order() {
    for integrator in ["HHT_TP 0.9", "HHT_TP 0.8", "HHTGeneralized_TP 0.6", "HHTGeneralized_TP 1.1 0.8 0.4225 0.8"] {
        for zeta in [0.0, 0.05] {
            let found = order(|dt| (free_vibration(integrator, dt, 9.0, zeta) - exact(1.0, 9.0, zeta)).abs());
            assert!((found - 2.0).abs() < 0.15, "{integrator}, damping {zeta}: order {found}");
        }
    }
    for integrator in
        ["HHTHSFixedNumIter_TP 0.6", "HHTHSFixedNumIter_TP 0.6 -polyOrder 3", "HHTHSFixedNumIter_TP 0.9 -polyOrder 1"]
    {
        let error =
            |dt| (with_test(integrator, "Newton", "FixedNumIter 4", dt, 9.0, 0.05) - exact(1.0, 9.0, 0.05)).abs();
        assert!((order(error) - 2.0).abs() < 0.2, "{integrator}: order {}", order(error));
    }
    for integrator in ["HHTHSIncrReduct_TP 0.6 0.7", "HHTHSIncrLimit_TP 0.6 0.002 -normType 0"] {
        let error = |dt| {
            (with_test(integrator, "Newton", "NormUnbalance 1e-12 400", dt, 9.0, 0.05) - exact(1.0, 9.0, 0.05)).abs()
        };
        assert!((order(error) - 2.0).abs() < 0.15, "{integrator}: order {}", order(error));
    }
}

#[test]
fn explicit_trapezoidal_integrators_have_their_order() {
    for (integrator, wanted, zeta) in [
        ("HHTExplicit_TP 0.9 0.6", 2.0, 0.0),
        ("HHTGeneralizedExplicit_TP 0.8 0.6", 2.0, 0.0),
        ("AlphaOS_TP 0.8", 2.0, 0.0),
        ("AlphaOSGeneralized_TP 0.5", 2.0, 0.0),
        ("ExplicitDifference", 2.0, 0.0),
        ("ExplicitBathe 0.54", 2.0, 0.0),
        ("ExplicitBathe 0.54", 2.0, 0.05),
        // Damping forces at the velocity of half a step before.
        ("ExplicitDifference", 1.0, 0.2),
        // Starts late by half a step where it starts with an acceleration, as without the trapezoidal rule.
        ("KRAlphaExplicit_TP 1.0", 1.0, 0.0),
    ] {
        let found = order(|dt| (with_algorithm(integrator, "Linear", dt, 9.0, zeta) - exact(1.0, 9.0, zeta)).abs());
        assert!((found - wanted).abs() < 0.25, "{integrator}, damping {zeta}: order {found}");
    }
}

/// For forces proportional to the motion, weighted forces equal forces of the weighted motion.
#[test]
fn refinement_leaves_a_linear_model_unchanged() {
    for (trapezoidal, other, algorithm) in [
        ("HHT_TP 0.8", "HHT 0.8", "Newton"),
        ("HHTGeneralized_TP 0.5", "HHTGeneralized 0.5", "Newton"),
        ("HHTExplicit_TP 0.9 0.6", "HHTExplicit 0.9 0.6", "Linear"),
        ("HHTGeneralizedExplicit_TP 0.8 0.6", "HHTGeneralizedExplicit 0.8 0.6", "Linear"),
        ("AlphaOS_TP 0.8", "AlphaOS 0.8", "Linear"),
        ("KRAlphaExplicit_TP 0.6", "KRAlphaExplicit 0.6", "Linear"),
    ] {
        let at = |integrator| with_algorithm(integrator, algorithm, 0.01, 9.0, 0.0);
        assert!(close(at(trapezoidal), at(other), 1e-10), "{trapezoidal}: {} and {}", at(trapezoidal), at(other));
    }
}

const YIELDING: &str = "model basic -ndm 1 -ndf 1; node 1 0; node 2 0 -mass 2.0; fix 1 1
    uniaxialMaterial BoucWen 1 0.1 300. 1.5 40. 40. 1. 0. 0. 0.
    element zeroLength 1 1 2 -mat 1 -dir 1
    timeSeries Trig 1 0. 100. 0.9 -factor 8.
    pattern UniformExcitation 1 1 -accel 1
    proc load {t} { return [expr {-2.0*8.*sin(2*acos(-1)*$t/0.9)}] }
    constraints Plain; numberer Plain; system FullGeneral; test NormUnbalance 1e-11 30; algorithm Newton\n";

/// m (αi a + (1 - αi) a₀) + αf (f - p) + (1 - αf) (f₀ - p₀) = 0 with the forces of the element at the ends of the steps.
#[test]
fn forces_of_both_ends_of_a_step_are_weighted() {
    for (integrator, inertia, force) in [
        ("HHT_TP 0.75", 1.0, 0.75),
        ("HHTGeneralized_TP 0.5", 1.0, 2.0 / 3.0),
        ("HHTGeneralized_TP 1.2 1.0 0.4 0.7", 1.2, 1.0),
    ] {
        let ran = run(&format!(
            "{YIELDING}integrator {integrator}; analysis Transient
            set worst 0.; set most 0.
            foreach {{a0 f0 t0}} {{0. 0. 0.}} break
            for {{set i 0}} {{$i < 200}} {{incr i}} {{
                analyze 1 0.02
                set a [nodeAccel 2 1]; set f [lindex [eleResponse 1 force] 1]; set t [getTime]
                set end [expr {{$f - [load $t]}}]; set begin [expr {{$f0 - [load $t0]}}]
                set left [expr {{2.0*({inertia}*$a + (1-{inertia})*$a0) + {force}*$end + (1-{force})*$begin}}]
                set worst [expr {{max($worst, abs($left))}}]; set most [expr {{max($most, abs($f))}}]
                foreach {{a0 f0 t0}} [list $a $f $t] break
            }}
            puts \"$worst $most\""
        ));
        let [worst, most] = ran.done().numbers()[..] else { panic!("two numbers") };
        assert!(most > 10.0 && worst < 1e-9, "{integrator}: {worst} left of {most}");
    }
}

/// Values from the start of a step are computed again after a new setup, and survive a failure.
#[test]
fn forces_at_the_start_of_a_step_are_kept() {
    let motion = |between: &str| {
        let ran = run(&format!(
            "{YIELDING}integrator HHT_TP 0.7; analysis Transient; analyze 60 0.02
            {between}
            analyze 60 0.02; puts [nodeDisp 2 1]"
        ));
        ran.done().numbers().pop().unwrap()
    };
    let whole = motion("");
    let anew = motion(
        "wipeAnalysis; constraints Plain; numberer Plain; system FullGeneral; test NormUnbalance 1e-11 30
        algorithm Newton; integrator HHT_TP 0.7; analysis Transient",
    );
    let failed = motion("test NormUnbalance 1e-30 2; set failed [analyze 1 0.02]; test NormUnbalance 1e-11 30");
    assert!(close(whole, anew, 1e-9), "{whole} and {anew}");
    assert!(close(whole, failed, 1e-9), "{whole} and {failed}");
    assert!(whole.abs() > 1e-3, "{whole}");
}

#[test]
fn words_that_do_not_fit_are_refused() {
    for (words, message) in [
        ("HHT_TP", "parameters"),
        ("HHT_TP -0.5", "alpha of the forces at the end is -0.5"),
        ("HHTGeneralized_TP 0.5 0.5", "parameters"),
        ("KRAlphaExplicit_TP 1.5", "spectral radius"),
        ("HHTGeneralizedExplicit_TP 0.8 1.0", "alphaF"),
        ("ExplicitBathe 1.0", "p is 1"),
        ("HHTHSIncrLimit_TP 0.5", "parameters"),
    ] {
        let ran = Script::default().run(&format!("model basic -ndm 1 -ndf 1\nintegrator {words}"));
        assert!(ran.error().message.contains(message), "{words}: {}", ran.error().message);
    }
}
