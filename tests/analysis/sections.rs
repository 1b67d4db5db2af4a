//! Beams and hinges of fiber sections, from the script on.

use super::close;
use super::script::{Script, run};

/// A rectangular cantilever of b = 0.2 and h = 0.4 that does not harden, of 40 fibers.
const CANTILEVER: &str = "model basic -ndm 2 -ndf 3
    node 1 0 0; node 2 3 0; fix 1 1 1 1
    uniaxialMaterial ElasticPP 1 2e8 0.00125
    section Fiber 1 { patch rect 1 40 1 -0.2 -0.1 0.2 0.1 }
    geomTransf Linear 1
    timeSeries Linear 1
    pattern Plain 1 1 { load 2 0 1 0 }
    constraints Plain; numberer RCM; system BandGeneral; test NormDispIncr 1e-10 50; algorithm Newton\n";

/// The moment of a plastic hinge is f b h²/4 less what the last elastic fibers miss, whatever the formulation.
#[test]
fn cantilevers_come_to_their_plastic_moment() {
    for element in [
        "element forceBeamColumn 1 1 2 5 1 1",
        "beamIntegration Lobatto 1 1 5\nelement forceBeamColumn 1 1 2 1 1",
        "beamIntegration UserHinge 1 1 1 1 0 0.1 1 1 1 0.1\nelement forceBeamColumn 1 1 2 1 1",
        "element forceBeamColumn 1 1 2 1 {HingeRadau 1 0.4 1 0.4 1}",
        "element beamWithHinges 1 1 2 1 0.4 1 0.4 2e8 0.08 1.0667e-3 1",
        "element dispBeamColumn 1 1 2 5 1 1 -integration Lobatto",
    ] {
        let ran = run(&format!(
            "{CANTILEVER}{element}
            integrator DisplacementControl 2 2 0.002; analysis Static
            puts [analyze 60]
            puts [eleResponse 1 section 1 force]"
        ));
        let n = ran.numbers();
        let plastic = 2.5e5 * 0.2 * 0.16 / 4.0;
        assert!(n[0] == 0.0 && n[2].abs() < plastic && n[2].abs() > 0.97 * plastic, "{element}: {n:?}");
    }
}

/// Points of two hinges and the two between them have the places and weights of openseespy 3.7.1.
#[test]
fn points_of_given_hinges() {
    let ran = run("model basic -ndm 2 -ndf 3
        node 1 0 0; node 2 5 0; fix 1 1 1 1
        foreach tag {1 2 3 4} { section Elastic $tag [expr 2.0 * $tag] 3 4 }
        geomTransf Linear 1
        beamIntegration UserHinge 1 3  2 1 2 0.02 0.07 0.04 0.06  1 4 0.97 0.08
        element forceBeamColumn 1 1 2 1 1
        timeSeries Linear 1; pattern Plain 1 1 { load 2 1 2 0 }
        constraints Plain; numberer Plain; system BandGeneral; algorithm Linear; integrator LoadControl 1; analysis Static
        puts \"[analyze 1] [nodeDisp 2] [sectionLocation 1] [sectionWeight 1]\"");
    let expected = [
        [0.0, 0.3027777777777778, 4.541378472222222, 1.2602083333333332, 0.1, 0.35000000000000003, 4.85],
        [1.3664319481612668, 3.7335680518387333, 0.2, 0.3, 0.4, 2.0500000000000003, 2.0500000000000003],
    ];
    let n = ran.numbers();
    assert_eq!(n.len(), 14, "{n:?}");
    for (got, expected) in n.iter().zip(expected.as_flattened()) {
        assert!(close(*got, *expected, 1e-12), "{n:?}");
    }
}

/// A hinge between two nodes has the moment-curvature relation of its section, and a bar the axial one.
#[test]
fn hinges_and_bars_of_sections() {
    let ran = run("model basic -ndm 2 -ndf 3
        node 1 0 0; node 2 0 0; node 3 4 0; fix 1 1 1 1; fix 2 0 1 0; fix 3 0 1 1
        uniaxialMaterial Elastic 1 2e8; uniaxialMaterial Elastic 2 1e4
        section fiberSec 1 { patch quad 1 20 2 -0.2 -0.1 0.2 -0.1 0.2 0.1 -0.2 0.1; layer straight 1 2 1e-3 -0.1 0 0.1 0; fiber 0 0 1e-3 1 }
        section Aggregator 2 2 Vy -section 1
        element zeroLengthSection 1 1 2 2
        element trussSection 2 1 3 1
        timeSeries Linear 1; pattern Plain 1 1 { load 2 3e4 0 1e4; load 3 1e5 0 0 }
        constraints Plain; numberer RCM; system BandGeneral; test NormDispIncr 1e-12 50; algorithm Newton
        integrator LoadControl 1; analysis Static
        puts \"[analyze 1] [eleResponse 1 section deformation] [nodeDisp 3 1]\"");
    let n = ran.numbers();
    let (ea, ei) = (2e8 * (0.08 + 3e-3), 2e8 * (0.2 * 0.064 / 12.0 * (1.0 - 1.0 / 400.0) + 2e-5));
    for (got, expected) in n.iter().zip([0.0, 3e4 / ea, 1e4 / ei, 0.0, 4.0 * 1e5 / ea]) {
        assert!(close(*got, expected, 1e-10), "{n:?}");
    }
}

#[test]
fn sections_are_refused_with_a_reason() {
    let start = "model basic -ndm 3 -ndf 6\nnode 1 0 0 0\nnode 2 0 0 3\nuniaxialMaterial Elastic 1 2e8\n\
                 geomTransf Linear 1 1 0 0\nsection Elastic 9 2e8 0.1 1e-3 1e-3 8e7 1e-3\n";
    for (line, message) in [
        ("section Fiber 1 -GJ 1e3 { }", "no area"),
        ("section Fiber 1 -GJ 1e3 { patch quad 1 2 2 -1 -1 -1 1 1 1 1 -1 }", "has an area of"),
        ("section Fiber 1 -GJ 1e3 { patch circle 1 2 2 0 0 0 1 }", "unknown patch"),
        ("section Fiber 1 -GJ 1e3 { fiber 0 0 -1 1 }", "area of the fiber is -1"),
        ("patch rect 1 2 2 -1 -1 1 1", "no fiber section"),
        ("section Aggregator 1 1 Mx", "unknown resultant"),
        ("section Aggregator 1 1 Mz -section 7", "there is no section 7"),
        ("beamIntegration Lobato 1 9 5", "did you mean"),
        ("beamIntegration Lobatto 1 9 1", "no rule with 1 points"),
        ("beamIntegration Legendre 1 8 3", "there is no section 8"),
        ("beamIntegration HingeRadau 1 9 -0.1 9 0.1 9", "lengths of the hinges"),
        ("beamIntegration UserDefined 1 2 9 9 0.1 1.9 0.5 0.5", "no fraction of the length"),
        ("beamIntegration UserHinge 1 9 1 9 0.1 0.2 1 9 0.9", "the numbers make no hinges"),
        ("beamIntegration UserHinge 1 9 1 9 0.1 0.6 1 9 0.9 0.6", "the numbers make no hinges"),
        ("beamIntegration UserHinge 1 9 1 9 1.1 0.2 1 9 0.9 0.2", "no fraction of the length"),
        ("integrator ParallelDisplacementControl 1 1 0.1", "unknown integrator"),
        ("section Uniaxial 1 1 P\nelement forceBeamColumn 1 1 2 5 1 1", "has no Mz"),
        ("element forceBeamColumn 1 1 2 1 7", "there is no beam integration 7"),
        ("element dispBeamColumn 1 1 2 5 9 1 -integration Simson", "unknown rule of integration"),
        ("uniaxialMaterial Concrete01 2 -30 0 -5 -0.01", "strain at the strength epsc0 is 0"),
        ("uniaxialMaterial Concrete02 2 -30 -0.002 -5 -0.01 1 3 100", "lambda is 1"),
        ("element CoupledZeroLength 1 1 2 3 3 1", "both directions are the same"),
        ("integrator NewmarkHSIncrReduct 0.5 0.25", "parameters before the last"),
    ] {
        let ran = Script::default().run(&format!("{start}{line}\n"));
        let told = format!("{:?}", ran.error());
        assert!(told.contains(message), "{line}: {told}");
    }
}

/// `printA`: stiffness of a cantilever by rising tag of the node, whatever the order of making.
#[test]
fn the_equations_are_shown() {
    let ran = run("model basic -ndm 2 -ndf 3\nnode 7 4 0\nnode 2 2 0\nnode 1 0 0\nfix 1 1 1 1\nfix 7 1 1 1\n\
        geomTransf Linear 1\nelement elasticBeamColumn 1 1 2 0.02 2e8 1e-4 1\nmass 2 3 3 0.5\n\
        timeSeries Linear 1\npattern Plain 1 1 { load 2 5 0 0 }\n\
        integrator LoadControl 1; algorithm Linear; analysis Static; analyze 1\n\
        puts [printA -ret]\nputs [llength [printB -ret]]\nwipeAnalysis\n\
        integrator GimmeMCK 1 0 0; algorithm Linear; analysis Transient; analyze 1 0.0\nputs [printA -ret]");
    let n = ran.numbers();
    let ei = 2e4;
    let expected = [2e6, 0.0, 0.0, 0.0, 12.0 * ei / 8.0, -6.0 * ei / 4.0, 0.0, -6.0 * ei / 4.0, 4.0 * ei / 2.0];
    assert!(n[..9].iter().zip(&expected).all(|(a, b)| close(*a, *b, 1e-12)), "{n:?}");
    assert_eq!(n[9..], [3.0, 3.0, 0.0, 0.0, 0.0, 3.0, 0.0, 0.0, 0.0, 0.5]);
}

/// `printA` under `system Diagonal`: the diagonal alone, by rising tag of the node.
#[test]
fn the_diagonal_is_shown() {
    let model = "model basic -ndm 2 -ndf 3\nnode 7 4 0\nnode 2 2 0\nnode 1 0 0\nfix 1 1 1 1\n\
        geomTransf Linear 1\nelement elasticBeamColumn 1 1 2 0.02 2e8 1e-4 1\n\
        element elasticBeamColumn 2 2 7 0.02 2e8 1e-4 1\nmass 2 3 4 0.5\nmass 7 5 6 0.7\n\
        integrator GimmeMCK 1 0 0; algorithm Linear; system Diagonal; analysis Transient; analyze 1 0.0\n";
    let ran = Script::default().run(&format!(
        "{model}puts [printA -ret]\nintegrator GimmeMCK 0 0 1\nanalyze 1 0.0\nputs [printA -ret]\nprintA -file a.out\n\
         system FullGeneral\nanalyze 1 0.0\nputs [llength [printA -ret]]"
    ));
    let n = ran.numbers();
    assert_eq!(n[..6], [3.0, 4.0, 0.5, 5.0, 6.0, 0.7]);
    let (ea, ei) = (4e6, 2e4);
    let end = [ea / 2.0, 12.0 * ei / 8.0, 4.0 * ei / 2.0];
    let expected = end.iter().map(|k| 2.0 * k).chain(end);
    assert!(n[6..12].iter().zip(expected).all(|(a, b)| close(*a, b, 1e-12)), "{n:?}");
    assert_eq!(n[12..], [36.0]);
}

/// A fiber section in space without torsion: the force-based beam twists as stiffly as in OpenSees.
#[test]
fn force_based_beam_of_sections_without_torsion() {
    let ran = run("model basic -ndm 3 -ndf 6
        node 1 0 0 0; node 2 0 0 3; fix 1 1 1 1 1 1 1
        uniaxialMaterial Elastic 1 200.
        section Fiber 1 { patch rect 1 10 10 -0.5 -0.5 0.5 0.5 }
        section Fiber 2 0.1 0.2 -GJ 40. { patch rect 1 10 10 -0.5 -0.5 0.5 0.5 }
        geomTransf Linear 1 1 0 0
        element forceBeamColumn 1 1 2 5 1 1
        timeSeries Linear 1
        pattern Plain 1 1 { load 2 0 0 6. 0 0 0.01 }
        constraints Plain; numberer RCM; system BandGeneral; test NormUnbalance 1e-9 10; algorithm Newton
        integrator LoadControl 1.; analysis Static
        puts [analyze 1]; puts [nodeDisp 2]");
    let u = ran.numbers();
    assert!(close(u[3], 6.0 * 3.0 / 200.0, 1e-9) && close(u[6], 1e-12, 1e-9), "{u:?}");
    let first = "a fiber section in space without a torsional stiffness";
    assert!(ran.warnings().iter().any(|w| w.message.contains(first)), "{:?}", ran.warnings());
}

/// Sections by their dimensions have the area and the second moments of their shapes, strip by strip.
#[test]
fn sections_by_dimensions() {
    // Deformations under a unit force and a unit moment: 1/EA and 1/EI.
    let flexibility = |ndm: usize, section: &str| {
        let (ndf, place, free) = if ndm == 2 { (3, "0 0", "0 1 0") } else { (6, "0 0 0", "0 1 1 1 0 0") };
        let moment = if ndm == 2 { "1. 0 1." } else { "1. 0 0 0 1. 1." };
        run(&format!(
            "model basic -ndm {ndm} -ndf {ndf}
            node 1 {place}; node 2 {place}; fix 1 {held}; fix 2 {free}
            uniaxialMaterial Elastic 1 10.; uniaxialMaterial Elastic 2 7.; uniaxialMaterial Elastic 3 200.
            section {section}
            element zeroLengthSection 1 1 2 1
            timeSeries Linear 1
            pattern Plain 1 1 {{ load 2 {moment} }}
            constraints Plain; numberer Plain; system BandGeneral; test NormUnbalance 1e-9 5; algorithm Newton
            integrator LoadControl 1.; analysis Static
            analyze 1
            puts [nodeDisp 2]",
            held = vec!["1"; ndf].join(" ")
        ))
        .numbers()
    };
    let strip =
        |depth: f64, width: f64, y: f64, n: f64| width * (depth.powi(3) / 12.0 * (1.0 - 1.0 / (n * n)) + depth * y * y);
    let u = flexibility(2, "WFSection2d 1 1 10. 0.5 6. 0.8 20 4");
    let area = 2.0 * 6.0 * 0.8 + 8.4 * 0.5;
    let inertia = 2.0 * strip(0.8, 6.0, 4.6, 4.0) + strip(8.4, 0.5, 0.0, 20.0);
    assert!(close(u[0], 0.1 / area, 1e-9) && close(u[2], 0.1 / inertia, 1e-9), "{u:?}");
    let u = flexibility(2, "RCSection2d 1 1 2 3 20. 12. 2. 0.5 0.5 0.3 16 4 3");
    let area = 10.0 * 16.0 * 8.0 + 7.0 * (20.0 * 12.0 - 16.0 * 8.0) + 200.0 * (3.0 * 1.0 + 0.6);
    let inertia = 10.0 * strip(16.0, 8.0, 0.0, 16.0)
        + 7.0 * (strip(16.0, 4.0, 0.0, 16.0) + 2.0 * strip(2.0, 12.0, 9.0, 4.0))
        + 200.0 * 3.0 * 64.0;
    assert!(close(u[0], 1.0 / area, 1e-9) && close(u[2], 1.0 / inertia, 1e-9), "{u:?}");
    let u = flexibility(3, "RCCircularSection 1 1 2 3 20. 2. 0.5 40 10 60 8 -GJ 1e3");
    let circle = |r: f64| (std::f64::consts::PI * r * r, std::f64::consts::PI * r.powi(4) / 4.0);
    let ((core, core_2), (all, all_2)) = (circle(8.0), circle(10.0));
    let area = 10.0 * core + 7.0 * (all - core) + 200.0 * 4.0;
    let inertia = 10.0 * core_2 + 7.0 * (all_2 - core_2) + 200.0 * 4.0 * 64.0 / 2.0;
    assert!(close(u[0], 1.0 / area, 1e-9) && close(u[5], 1.0 / inertia, 2e-3) && close(u[4], u[5], 1e-9), "{u:?}");
}

/// Resultants, deformations and tangent of openseespy 3.7.1: moments of one section meet those of another.
#[test]
fn sections_side_by_side() {
    let ran = run("model basic -ndm 3 -ndf 6
        node 1 0 0 0; node 2 0 0 0; fix 1 1 1 1 1 1 1
        uniaxialMaterial Steel01 1 2. 200. 0.02; uniaxialMaterial Elastic 2 3.
        section Fiber 11 -GJ 50. { patch rect 1 6 4 -0.15 -0.1 0.15 0.1; fiber 0.1 0.05 0.01 1 }
        section Aggregator 12 2 Vy 2 Mz; section Uniaxial 13 1 P
        section Parallel 1 12 11 13
        element zeroLengthSection 1 1 2 1
        timeSeries Linear 1; pattern Plain 1 1 {
            sp 2 1 0.02; sp 2 2 0.01; sp 2 3 0.; sp 2 4 0.03; sp 2 5 -0.05; sp 2 6 0.08
        }
        constraints Penalty 1e12 1e12; numberer Plain; system FullGeneral; test NormDispIncr 1e-10 20; algorithm Newton
        integrator LoadControl 0.5; analysis Static
        puts [analyze 2]
        puts \"[eleResponse 1 section force] [eleResponse 1 section deformation] [sectionStiffness 1 1]\"
        puts \"[eleResponse 1 section section 3 force] [eleResponse 1 section section 1 force]\"");
    let expected: [&[f64]; 3] = [
        &[2.1816974999792125, 0.24029806249879107, 0.029999999999819997, -0.00013031250014323157, 1.4999999998499998],
        &[0.01999999999563661, 0.07999999999951941, 0.00999999999994, -0.04999999999999974, 0.029999999996999996],
        &[
            4.77,
            -0.05425,
            0.0,
            0.03325,
            0.0,
            -0.05425,
            3.0080991071428573,
            0.0,
            -0.003852678571428572,
            0.0,
            0.0,
            0.0,
            3.0,
            0.0,
            0.0,
            0.03325,
            -0.003852678571428572,
            0.0,
            0.003091964285714287,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            50.0,
        ],
    ];
    let n = ran.numbers();
    assert_eq!(n.len(), 1 + 35 + 3);
    for (got, expected) in n[1..].iter().zip(expected.concat()) {
        assert!((got - expected).abs() < 1e-9, "{n:?}");
    }
    // 2 + 0.02 200 (0.02 - 0.01) of the bar, and 3 times the shear strain and the curvature.
    for (got, expected) in n[36..].iter().zip([2.04, 0.03, 0.24]) {
        assert!(close(*got, expected, 1e-8), "{n:?}");
    }
}
