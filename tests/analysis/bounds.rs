//! Responses beyond what a model can mean: refused, pointed out well before, and left alone where they mean something.

use super::script::{Ran, Script};

/// A block on a lead-rubber bearing with 0.16 m of rubber, under a ground acceleration or an imposed displacement.
fn block(load: &str, analysis: &str) -> String {
    format!(
        "model basic -ndm 3 -ndf 6; node 1 0 0 0; node 2 0 0 0.3; fix 1 1 1 1 1 1 1; fix 2 0 1 0 1 1 1
        mass 2 1e5 1e5 1e5 0 0 0
        element LeadRubberX 1 1 2 120e3 0.1 0.6e6 2e9 0.12 0.6 0.003 0.008 20 0 0 1 1 0 0 10 0.5 1.0 0.5 0 0 0 11200. 130. 50. 1.41e-5 0 0 0 0 1
        {load}
        constraints Transformation; numberer Plain; system FullGeneral; test NormDispIncr 1e-8 50; algorithm Newton
        {analysis}
        puts $ok"
    )
}

const SHAKEN: &str = "timeSeries Constant 1 -factor 100.; pattern UniformExcitation 1 1 -accel 1";
const STEPS: &str = "integrator Newmark 0.5 0.25; analysis Transient; set ok [analyze 200 0.01]";

fn pushed(to: f64) -> String {
    let push = format!("timeSeries Linear 1; pattern Plain 1 1 {{ sp 2 1 {to} }}");
    block(&push, "integrator LoadControl 0.01; analysis Static; set ok [analyze 100]")
}

fn has(ran: &Ran, words: &str) -> bool {
    ran.warnings().iter().any(|w| w.message.contains(words))
}

#[test]
fn a_law_far_beyond_its_size_is_refused() {
    let ran = Script::default().run(&block(SHAKEN, STEPS));
    assert_eq!(ran.out, "-3\n", "{}", ran.err);
    assert!(has(&ran, "LeadRubberX 1 failed at time 0."), "{}", ran.err);
    assert!(has(&ran, "times the thickness of rubber of 0.1600: the law holds up to 6 times"), "{}", ran.err);
    // OpenSees' numbers, with a word.
    let ran = Script::compat().run(&block(SHAKEN, STEPS)).done();
    assert!(ran.out == "0\n" && has(&ran, "times the thickness of rubber of 0.1600"), "{}", ran.err);
}

/// A shear strain of 7 is pointed out, one of 4 is not.
#[test]
fn a_law_beyond_its_size_is_pointed_out() {
    for (to, named) in [(1.12, true), (0.64, false)] {
        let ran = Script::default().run(&pushed(to)).done();
        assert_eq!(ran.out, "0\n", "{}", ran.err);
        assert_eq!(has(&ran, "LeadRubberX 1 at time 0.8"), named, "{}", ran.err);
        assert_eq!(has(&ran, "the thickness of rubber"), named, "{}", ran.err);
    }
}

/// An oscillator on a spring of length 1 swings to twice the displacement under its load.
#[test]
fn a_displacement_beyond_the_size_of_the_model() {
    let swung = |load: &str| {
        Script::default().run(&format!(
            "model basic -ndm 1 -ndf 1; node 1 0; node 2 1; fix 1 1; mass 2 1
            uniaxialMaterial Elastic 1 1.0; element truss 5 1 2 1 1
            timeSeries Linear 1; timeSeries Constant 2; {load}
            constraints Transformation; numberer Plain; system FullGeneral; test NormDispIncr 1e-8 50; algorithm Linear
            integrator Newmark 0.5 0.25; analysis Transient; puts [analyze 400 0.01]"
        ))
    };
    let loaded = |p: f64| swung(&format!("pattern Plain 1 2 {{ load 2 {p} }}"));
    let refused = loaded(1000.0);
    assert!(refused.out == "-3\n" && has(&refused, "Truss 5 failed at time"), "{}", refused.err);
    assert!(has(&refused, "node 2 has moved by 1"), "{}", refused.err);
    let warned = loaded(10.0);
    assert!(warned.out == "0\n" && has(&warned, "node 2 has moved by 10."), "{}", warned.err);
    let plain = loaded(4.0);
    assert!(plain.out == "0\n" && plain.warnings().is_empty(), "{}", plain.err);
    // A motion that is asked for is no response.
    let imposed = swung("pattern Plain 1 1 { sp 2 1 100.0 }");
    assert!(imposed.out == "0\n" && imposed.warnings().is_empty(), "{}", imposed.err);
}
