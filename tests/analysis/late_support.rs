//! Supports that the motion of the ground reaches later.

use super::close;
use super::script::{Script, run};

/// A deck on two piers, before its excitation.
const MODEL: &str = "model basic -ndm 2 -ndf 2
    node 1 0. 0.; node 2 10. 0.; node 3 0. 0. -mass 1. 1.; node 4 10. 0. -mass 1. 1.
    fix 1 1 1; fix 2 1 1; fix 3 0 1; fix 4 0 1
    uniaxialMaterial Elastic 1 100.; uniaxialMaterial Elastic 2 300.; uniaxialMaterial Viscous 3 1. 1.
    element zeroLength 1 1 3 -mat 1 3 -dir 1 1; element zeroLength 2 2 4 -mat 1 3 -dir 1 1
    element twoNodeLink 3 3 4 -mat 2 -dir 1
    set values {}
    for {set i 0} {$i <= 400} {incr i} {lappend values [expr {sin(0.07*$i)*sin(0.005*$i)}]}
    timeSeries Path 1 -dt 0.01 -values $values -factor 2.0\n";
const ANALYSIS: &str = "constraints Transformation; numberer Plain; system FullGeneral; test NormDispIncr 1e-12 20
    algorithm Newton; integrator Newmark 0.5 0.25; analysis Transient; analyze 350 0.01
    puts \"[eleResponse 1 force] [eleResponse 2 force] [eleResponse 3 force]\"";
const UNIFORM: &str = "pattern UniformExcitation 1 1 -accel 1 -fact 1.5";

/// Forces at the end with commands before and behind the excitation.
fn forces(before: &str, excitation: &str, behind: &str) -> Vec<f64> {
    run(&format!("{MODEL}{before}\n{excitation}\n{behind}\n{ANALYSIS}")).numbers()
}

/// A late support gives the forces of motions of their own at all supports, whether it is told before or after the excitation.
#[test]
fn a_late_support_moves_as_one_with_a_motion_of_its_own() {
    let own = forces(
        "timeSeries Path 2 -dt 0.01 -values $values -factor 2.0 -startTime 0.25",
        "pattern MultipleSupport 1 {
            groundMotion 1 Plain -accel 1 -fact 1.5; groundMotion 2 Plain -accel 2 -fact 1.5
            imposedMotion 1 1 1; imposedMotion 2 1 2
        }",
        "",
    );
    let late = "amend node 2 late -by 0.25";
    let at_one_time = forces("", UNIFORM, "");
    for found in [forces(late, UNIFORM, ""), forces("", UNIFORM, late)] {
        assert!(!own.is_empty() && own.iter().zip(&found).all(|(a, b)| close(*a, *b, 1e-6)), "{own:?} {found:?}");
        assert!(found.iter().zip(&at_one_time).any(|(a, b)| !close(*a, *b, 1e-2)));
    }
    assert_eq!(forces("amend node 2 late -by 0.0", UNIFORM, ""), at_one_time);
}

/// Without a uniform excitation a delay is told to have no effect; with one, and of a support that is gone, nothing is told.
#[test]
fn a_delay_without_a_motion_is_told() {
    let told = |lines: &str| {
        let ran = Script::default().run(&format!("{MODEL}amend node 2 late -by 0.1\n{lines}\n{ANALYSIS}")).done();
        ran.warnings().iter().any(|d| d.message.contains("node 2 is a late support"))
    };
    assert!(told("pattern Plain 1 1 {load 3 1. 0.}"));
    assert!(!told(UNIFORM));
    assert!(!told(&format!(
        "remove element 2; remove element 3; remove node 2; remove node 4\n{UNIFORM}\nproc eleResponse {{args}} {{}}"
    )));
}

/// A node that is free, a delay that is missing and an excitation without an end are refused.
#[test]
fn a_late_support_is_held_and_its_motion_ends() {
    for (script, message) in [
        (format!("{MODEL}{UNIFORM}\namend node 3 late -by 0.1"), "node 3 is no support in direction 1"),
        (format!("{MODEL}amend node 2 late"), "the delay of the support is missing"),
        (
            format!(
                "{MODEL}amend node 2 late -by 0.1\ntimeSeries Trig 2 0. 1000. 1.\ntimeSeries Linear 3\npattern UniformExcitation 1 1 -accel 3"
            ),
            "node 2 is a late support, and the excitation has no end",
        ),
    ] {
        let ran = Script::default().run(&script);
        let said = &ran.error().message;
        assert!(said.contains(message), "{said}");
    }
}
