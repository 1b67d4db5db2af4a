//! Structures at their plastic limit: the path goes on there, and no load goes beyond it.

use crate::script::{Script, run};

fn close(a: f64, b: f64, tolerance: f64) -> bool {
    (a - b).abs() <= tolerance * b.abs().max(1.0)
}

const NUMERICS: &str =
    "constraints Plain; numberer Plain; system BandGeneral; test NormUnbalance 1e-6 50; algorithm Newton
    analysis Static; ";

/// Failed steps, displacement and load factor of a spring under an integrator and back under another.
fn push(material: &str, there: (&str, usize), back: (&str, usize)) -> Vec<f64> {
    let ((there, n), (back, m)) = (there, back);
    run(&format!(
        "model basic -ndm 1 -ndf 1; node 1 0; node 2 0; fix 1 1
        uniaxialMaterial {material}
        element zeroLength 1 1 2 -mat 1 -dir 1
        timeSeries Linear 1
        pattern Plain 1 1 {{load 2 2.0}}
        {NUMERICS}
        foreach {{integrator n}} {{{{{there}}} {n} {{{back}}} {m}}} {{
            integrator {{*}}$integrator
            set bad 0
            for {{set i 0}} {{$i < $n}} {{incr i}} {{if {{[analyze 1] != 0}} {{incr bad}}}}
            puts \"$bad [nodeDisp 2 1] [getTime]\"
        }}"
    ))
    .numbers()
}

/// A spring on its plateau, and back over zero to the other: the load factor stands still, the displacement does not.
#[test]
fn displacement_control_follows_a_plateau() {
    for material in ["ElasticPP 1 1e5 0.001", "Steel01 1 100 1e5 0.0"] {
        let v = push(material, ("DisplacementControl 2 1 1e-4", 30), ("DisplacementControl 2 1 -1e-4", 60));
        assert_eq!([v[0], v[3]], [0.0, 0.0], "{material}: {v:?}");
        assert!(close(v[1], 0.003, 1e-9) && close(v[2], 50.0, 1e-8), "{material}: {v:?}");
        assert!(close(v[4], -0.003, 1e-9) && close(v[5], -50.0, 1e-8), "{material}: {v:?}");
    }
}

/// The length of a step is a displacement on the plateau, whose sense is that of the last step.
#[test]
fn arc_length_follows_a_plateau() {
    for integrator in ["ArcLength 1e-4 0.0", "ArcLength1 1e-4 0.0", "EQPath 1e-4 2", "EQPath 1e-4 6"] {
        let v = push("ElasticPP 1 1e5 0.001", (integrator, 30), ("DisplacementControl 2 1 -1e-4", 1));
        assert_eq!(v[0], 0.0, "{integrator}: {v:?}");
        assert!(close(v[1], 0.003, 1e-6) && close(v[2], 50.0, 1e-6), "{integrator}: {v:?}");
    }
    let v = push("ElasticPP 1 1e5 0.001", ("MinUnbalDispNorm 5.0", 30), ("DisplacementControl 2 1 -1e-4", 1));
    assert_eq!(v[0], 0.0, "{v:?}");
    assert!(v[1] > 0.002 && close(v[2], 50.0, 1e-6), "{v:?}");
}

/// Beyond the peak of concrete lies a residual strength without stiffness.
#[test]
fn displacement_control_follows_a_residual_strength() {
    let v = push(
        "Concrete01 1 -30e3 -0.002 -6e3 -0.006",
        ("DisplacementControl 2 1 -2e-4", 50),
        ("DisplacementControl 2 1 1e-4", 1),
    );
    assert_eq!(v[0], 0.0, "{v:?}");
    assert!(close(v[1], -0.01, 1e-9) && close(v[2], -3e3, 1e-9), "{v:?}");
}

/// A section bent under a constant axial force to its plastic moment.
#[test]
fn moment_and_curvature_of_a_plastic_section() {
    for axial in [0.0, -1000.0] {
        let v = run(&format!(
            "model basic -ndm 2 -ndf 3; node 1 0 0; node 2 0 0; fix 1 1 1 1; fix 2 0 1 0
            uniaxialMaterial ElasticPP 1 2e8 0.0015
            section Fiber 1 {{patch rect 1 20 1 -0.1 -0.05 0.1 0.05}}
            element zeroLengthSection 1 1 2 1
            timeSeries Constant 1; timeSeries Linear 2
            pattern Plain 1 1 {{load 2 {axial} 0 0}}
            {NUMERICS}; integrator LoadControl 0
            analyze 1; loadConst -time 0.0
            pattern Plain 2 2 {{load 2 0 0 1}}
            integrator DisplacementControl 2 3 0.005
            set bad 0
            for {{set i 0}} {{$i < 100}} {{incr i}} {{if {{[analyze 1] != 0}} {{incr bad}}}}
            puts \"$bad [nodeDisp 2 3] [getTime] [eleResponse 1 section force]\""
        ))
        .numbers();
        // N/Np = 1/6 takes (N/Np)² of the plastic moment; twenty fibers come near to it.
        let exact = 300.0 * (1.0 - (axial / 6000.0f64).powi(2));
        assert_eq!(v[0], 0.0, "{axial}: {v:?}");
        assert!(close(v[1], 0.5, 1e-9) && close(v[2], exact, 5e-3), "{axial}: {v:?}");
        assert!(close(v[3], axial, 1e-6) && close(v[4], v[2], 1e-6), "{axial}: {v:?}");
    }
}

/// Without another step than those of the load factor there is no equilibrium beyond the limit, and a mechanism of the virgin
/// structure is one under every integrator.
#[test]
fn no_path_beyond_a_mechanism() {
    let v = push("ElasticPP 1 1e5 0.001", ("LoadControl 5.0", 30), ("DisplacementControl 2 1 1e-4", 1));
    assert!(v[0] >= 20.0 && v[2] <= 50.0 + 1e-6, "{v:?}");
    let script = format!(
        "model basic -ndm 1 -ndf 1; node 1 0; node 2 0; node 3 0; fix 1 1
        uniaxialMaterial ElasticPP 1 1e5 0.001
        element zeroLength 1 1 2 -mat 1 -dir 1
        timeSeries Linear 1; pattern Plain 1 1 {{load 2 2.0}}
        {NUMERICS} integrator DisplacementControl 2 1 1e-4; analyze 1"
    );
    let message = &Script::default().run(&script).warnings()[0].message.clone();
    assert!(message.contains("mechanism") && message.contains("node 3"), "{message}");
}

/// A beam clamped at both ends whose fibers do not harden: the collapse load is 8 Mp / L = 600.
fn clamped(beam: &str, integrator: &str, steps: usize) -> (Vec<f64>, Vec<String>) {
    let ran = Script::default().run(&format!(
        "model basic -ndm 2 -ndf 3
        node 1 0 0; node 2 2 0; node 3 4 0; fix 1 1 1 1; fix 3 1 1 1
        uniaxialMaterial ElasticPP 1 2e8 0.0015
        section Fiber 1 {{patch rect 1 10 1 -0.1 -0.05 0.1 0.05}}
        geomTransf Linear 1
        element {beam} 1 1 2 {{*}}[expr {{\"{beam}\" eq \"beamWithHinges\" ? \"1 0.3 1 0.3 2e8 0.02 6.667e-5 1\" : \"5 1 1\"}}]
        element {beam} 2 2 3 {{*}}[expr {{\"{beam}\" eq \"beamWithHinges\" ? \"1 0.3 1 0.3 2e8 0.02 6.667e-5 1\" : \"5 1 1\"}}]
        timeSeries Linear 1; pattern Plain 1 1 {{load 2 0 -1 0}}
        {NUMERICS} integrator {integrator}
        set n 0
        for {{set i 0}} {{$i < {steps}}} {{incr i}} {{if {{[analyze 1] != 0}} break; incr n}}
        puts \"$n [getTime] [nodeDisp 2 2] [lindex [eleResponse 1 force] 2] [lindex [eleResponse 1 section 1 force] 1]\""
    ));
    let messages = ran.warnings().iter().map(|d| format!("{} {}", d.message, d.help.join(" "))).collect();
    (ran.numbers(), messages)
}

/// No force-based beam carries more than its sections, and the message names the one that gives way.
#[test]
fn force_based_beams_carry_what_their_sections_carry() {
    for beam in ["forceBeamColumn", "nonlinearBeamColumn", "beamWithHinges", "mixedBeamColumn", "forceBeamColumnCBDI"] {
        for step in [20.0, 50.0] {
            let (v, messages) = clamped(beam, &format!("LoadControl {step}"), 50);
            assert!(v[1] <= 600.0 + 1e-6 && v[1] >= 600.0 - step - 1e-6, "{beam} {step}: {v:?}");
            assert!(close(v[3].abs(), v[4].abs(), 1e-4), "{beam} {step}: {v:?}");
            let named = |m: &String| m.contains("section") && m.contains("tag 1") && m.contains("Mz = ");
            assert!(messages.iter().any(named), "{beam} {step}: {messages:?}");
        }
    }
}

/// Under displacement control the same beams go on at their collapse load.
#[test]
fn force_based_beams_follow_their_plateau() {
    for beam in ["forceBeamColumn", "nonlinearBeamColumn", "beamWithHinges", "mixedBeamColumn", "forceBeamColumnCBDI"] {
        let (v, messages) = clamped(beam, "DisplacementControl 2 2 -0.002", 60);
        assert_eq!(v[0], 60.0, "{beam}: {v:?} {messages:?}");
        assert!(v[1] <= 600.0 + 1e-3 && v[1] > 597.0, "{beam}: {v:?}");
        assert!(close(v[3].abs(), v[4].abs(), 1e-4), "{beam}: {v:?}");
    }
}

/// The beam of a portal under loads on its columns carries nothing but round-off.
#[test]
fn a_beam_without_load_is_balanced() {
    let v = run(&format!(
        "model basic -ndm 2 -ndf 3
        node 1 0 0; node 2 0 3; node 3 5 3; node 4 5 0; fix 1 1 1 1; fix 4 1 1 1
        uniaxialMaterial Steel02 1 2.5e5 2e8 0.005 18 0.925 0.15
        section WFSection2d 1 1 0.30 0.011 0.30 0.019 8 2
        geomTransf PDelta 1; geomTransf Linear 2
        element forceBeamColumn 1 1 2 5 1 1; element forceBeamColumn 2 4 3 5 1 1; element forceBeamColumn 3 2 3 5 1 2
        timeSeries Linear 1; pattern Plain 1 1 {{load 2 0 -400 0; load 3 0 -400 0}}
        {NUMERICS} integrator LoadControl 0.1; puts [analyze 10]"
    ))
    .numbers();
    assert_eq!(v, [0.0]);
}

/// A beam in space, about both axes.
#[test]
fn a_cantilever_in_space_follows_its_plateau() {
    for dof in [1, 2] {
        let v = run(&format!(
            "model basic -ndm 3 -ndf 6; node 1 0 0 0; node 2 0 0 2; fix 1 1 1 1 1 1 1
            uniaxialMaterial ElasticPP 1 2e8 0.0015
            section Fiber 1 -GJ 1e4 {{patch rect 1 10 10 -0.1 -0.1 0.1 0.1}}
            geomTransf Linear 1 0 1 0; element forceBeamColumn 1 1 2 5 1 1
            timeSeries Linear 1; pattern Plain 1 1 {{load 2 {} 0 0 0 0}}
            {NUMERICS} integrator DisplacementControl 2 {dof} 0.005
            set n 0; for {{set i 0}} {{$i < 60}} {{incr i}} {{if {{[analyze 1] != 0}} break; incr n}}
            puts \"$n [getTime]\"",
            if dof == 1 { "1 0" } else { "0 1" }
        ))
        .numbers();
        // Mp = b h² / 4 fy = 600 in ten fibers, over 2 m.
        assert!(v[0] == 60.0 && v[1] <= 300.0 + 1e-3 && v[1] > 298.0, "{dof}: {v:?}");
    }
}

/// Two patterns that grow together are named where a path of theirs is lost; one alone is not.
#[test]
fn a_forgotten_load_const_names_the_patterns() {
    let help = |hold: &str| {
        let ran = Script::default().run(&format!(
            "model basic -ndm 2 -ndf 3; node 1 0 0; node 2 0 3; fix 1 1 1 1
            geomTransf PDelta 1; element elasticBeamColumn 1 1 2 0.1 3e7 8e-4 1
            timeSeries Linear 1; pattern Plain 1 1 {{load 2 0 -500 0}}
            {NUMERICS} integrator LoadControl 0.1; analyze 10
            {hold}; wipeAnalysis
            timeSeries Linear 2; pattern Plain 2 2 {{load 2 1 0 0}}
            constraints Plain; numberer Plain; system BandGeneral; test NormUnbalance 1e-30 3; algorithm Newton
            integrator DisplacementControl 2 1 0.01; analysis Static; set ok [analyze 3]"
        ));
        ran.warnings().iter().flat_map(|d| d.help.clone()).collect::<Vec<_>>().join(" ")
    };
    let named = help("set kept 1");
    assert!(named.contains("patterns 1 and 2") && named.contains("loadConst"), "{named}");
    assert!(!help("loadConst -time 0.0").contains("loadConst"));
}

/// Newton's method that goes to and fro between two states ends before its last iteration.
#[test]
fn a_circle_of_iterations_ends_the_step() {
    let ran = Script::default().run(
        "model basic -ndm 1 -ndf 1; node 1 0; node 2 0; fix 1 1
        uniaxialMaterial ElasticMultiLinear 1 -strain -20 -1 1 20 -stress -29 -10 10 29
        element zeroLength 1 1 2 -mat 1 -dir 1
        timeSeries Path 1 -time {0 1 2} -values {0 15 0}; pattern Plain 1 1 {load 2 1}
        constraints Plain; numberer Plain; system BandGeneral; test NormUnbalance 1e-9 400
        algorithm Newton; integrator LoadControl 1.0; analysis Static
        puts [analyze 1]; puts [nodeDisp 2 1]; puts [analyze 1]",
    );
    let message = ran.warnings().iter().map(|d| d.message.clone()).collect::<Vec<_>>().join(" ");
    assert!(message.contains("alternate between 2 states"), "{message}");
    assert!(!message.contains("400 iterations"), "{message}");
}
