//! Numbers that OpenSees computes with though they mean nothing: refused, and warnings under `--compat opensees`. Expected values are
//! those of openseespy 3.7.1.

use crate::close;
use crate::script::Script;

/// A section of a lump of fibers under a moment and a force.
fn fibers(part: &str) -> String {
    format!(
        "model basic -ndm 2 -ndf 3; node 1 0 0; node 2 0 0; fix 1 1 1 1; fix 2 0 1 0
        uniaxialMaterial Elastic 1 1000.; uniaxialMaterial Steel01 2 10. 2000. 0.02
        section Fiber 1 {{ patch rect 1 4 1 -1 -1 1 1; {part} }}
        element zeroLengthSection 1 1 2 1
        timeSeries Linear 1; pattern Plain 1 1 {{ load 2 10 0 20 }}
        constraints Plain; numberer Plain; system FullGeneral; test NormUnbalance 1e-8 30; algorithm Newton
        integrator LoadControl 0.5; analysis Static
        puts [analyze 2]; puts \"[nodeDisp 2 1] [nodeDisp 2 3]\""
    )
}

/// A cantilever in space of an elastic section.
fn beam(section: &str, element: &str) -> String {
    format!(
        "model basic -ndm 3 -ndf 6; node 1 0 0 0; node 2 3 0 0; fix 1 1 1 1 1 1 1
        {section}
        geomTransf Linear 1 0 0 1; element {element}
        timeSeries Linear 1; pattern Plain 1 1 {{ load 2 1 2 3 0.1 0.2 0.3 }}
        constraints Plain; numberer Plain; system FullGeneral; test NormUnbalance 1e-8 30; algorithm Newton
        integrator LoadControl 0.5; analysis Static
        puts [analyze 2]; puts \"[nodeDisp 2 2] [nodeDisp 2 4]\""
    )
}

/// Two bars, and a part between them.
fn bars(part: &str) -> String {
    format!(
        "model basic -ndm 2 -ndf 2; node 1 0 0; node 2 3 0; node 3 3 1; node 4 0 1; node 5 3 0; fix 1 1 1; fix 4 1 1; fix 3 1 1
        uniaxialMaterial Elastic 1 1000.; element truss 1 1 2 0.1 1; element truss 2 2 3 0.1 1
        {part}
        timeSeries Linear 1; pattern Plain 1 1 {{ load 2 10 5 }}
        constraints Transformation; numberer Plain; system FullGeneral; test NormUnbalance 1e-8 30; algorithm Newton
        integrator LoadControl 0.5; analysis Static
        puts [analyze 2]; puts [nodeDisp 2]"
    )
}

fn law(words: &str) -> String {
    format!(
        "uniaxialMaterial {words}; testUniaxialMaterial 1
        foreach e {{0.001 0.004 0.01 0.02 -0.01 -0.03 0.0 0.05}} {{ setStrain $e; puts [getStress] }}"
    )
}

fn test(words: &str) -> String {
    format!(
        "model basic -ndm 1 -ndf 1; node 1 0; node 2 0; fix 1 1
        uniaxialMaterial Steel01 1 10 1000. 0.1; element zeroLength 1 1 2 -mat 1 -dir 1
        timeSeries Linear 1; pattern Plain 1 1 {{ load 2 8 }}
        constraints Plain; numberer Plain; system FullGeneral; test {words}; algorithm Newton
        integrator LoadControl 1.0; analysis Static
        puts \"[analyze 1] [nodeDisp 2 1] [analyze 1] [nodeDisp 2 1]\""
    )
}

#[test]
fn numbers_that_opensees_takes_are_warnings() {
    let elastic = |numbers: &str| format!("section Elastic 1 {numbers}");
    let (force, disp) = ("forceBeamColumn 1 1 2 3 1 1", "dispBeamColumn 1 1 2 3 1 1");
    let negative_torsion: &[f64] = &[0.0, 0.09675, -0.00375];
    let cases: Vec<(String, &str, &[f64])> = vec![
        (fibers("layer circ 2 5 0.3 0.2 0.1 0.0"), "radius is 0", &[0.0, 0.001908705890780154, 0.015404313995863287]),
        (
            fibers("layer circ 2 5 0.3 0.2 0.1 -0.5"),
            "radius is -0.5",
            &[0.0, 0.0019099741341240299, 0.012156800398030361],
        ),
        (fibers("layer straight 2 4 0.0 -0.5 0 0.5 0"), "area of a bar is 0", &[0.0, 0.0025, 0.016]),
        (
            fibers("layer straight 2 4 -0.01 -0.5 0 0.5 0"),
            "area of a bar is -0.01",
            &[0.0, 0.0025247370686930872, 0.01609474012773883],
        ),
        (
            fibers("patch circ 1 6 2 0 0 0.8 0.4 0 180"),
            "not greater",
            &[0.0, 0.0030806978672634814, 0.018118668753544735],
        ),
        (
            fibers("patch circ 1 6 2 0 0 -0.1 0.8 0 180"),
            "inner radius",
            &[0.0, 0.00200416799366917, 0.014276281487014823],
        ),
        (beam(&elastic("2e5 0.1 1e-3 2e-3 8e4 -1e-3"), force), "torsion constant J", negative_torsion),
        (beam(&elastic("2e5 0.1 1e-3 2e-3 8e4 -1e-3"), disp), "torsion constant J", negative_torsion),
        (beam(&elastic("2e5 0.1 -1e-3 2e-3 8e4 1e-3"), force), "second moment of area Iz", &[0.0, -0.09675, 0.00375]),
        (beam(&elastic("-2e5 0.1 1e-3 2e-3 8e4 1e-3"), force), "elastic modulus E", &[0.0, -0.09675, 0.00375]),
        // Without torsion the beam is a mechanism in OpenSees too.
        (beam(&elastic("2e5 0.1 1e-3 2e-3 8e4 0.0"), disp), "torsion constant J", &[-3.0, 0.0, 0.0]),
        (
            beam("", "elasticBeamColumn 1 1 2 0.1 2e5 8e4 -1e-3 1e-3 2e-3 1"),
            "torsion constant J",
            &[0.0, 0.048375, -0.00375],
        ),
        (bars("fix 5 1 1; element truss 7 4 2 0.0 1"), "area A is 0", &[0.0, 0.3, 0.05]),
        (
            bars("fix 5 1 1; element truss 7 4 2 -0.01 1"),
            "area A is -0.01",
            &[0.0, 0.3265415095350428, 0.04705094338499524],
        ),
        (bars("equalDOF 2 5 1 2; element truss 7 2 5 0.1 1"), "no length", &[0.0, 0.3, 0.05]),
        (law("Steel01 1 -10. 2000. 0.02"), "Fy is -10", &[9.84, 9.96, 10.2, 10.6, 9.4, -30.6, -9.8, 90.2]),
        (law("Steel01 1 0. 2000. 0.02"), "Fy is 0", &[0.04, 0.16, 0.4, 0.8, -0.4, -40.4, 0.0, 100.0]),
        (law("Steel01 1 10. -2000. 0.02"), "E0 is -2000", &[-2.0, -8.0, -10.2, -10.6, 10.2, 11.0, -49.0, -149.0]),
        (law("ElasticPP 1 2000. 0.0"), "both yield strains", &[0.0; 8]),
        (law("ElasticPP 1 -2000. 0.01"), "modulus E is -2000", &[20.0, -20.0, 20.0, 20.0, -20.0, -20.0, 20.0, 20.0]),
        (law("ViscousDamper 1 0. 10. 0.5"), "stiffness K is 0", &[0.0; 8]),
        (test("NormUnbalance 1e-8 0"), "iterations is 0", &[0.0, 0.008, -3.0, 0.008]),
        (test("NormDispIncr 1e-8 0"), "iterations is 0", &[-3.0, 0.0, -3.0, 0.0]),
    ];
    for (script, message, expected) in cases {
        let refused = Script::default().run(&script).error().message.clone();
        assert!(refused.contains(message), "{refused} instead of {message}\n{script}");
        let ran = Script::compat().run(&script).done();
        assert!(ran.warnings().iter().any(|w| w.message.contains(message)), "{:?}\n{script}", ran.warnings());
        let got = ran.numbers();
        let good = got.len() == expected.len()
            && got.iter().zip(expected).all(|(g, e)| close(*g, *e, 1e-9) || (g - e).abs() < 1e-12);
        assert!(good, "{got:?} instead of {expected:?}\n{script}");
    }
}

/// Nodes 3 and 5 do not lie in the plane of node 2: OpenSees leaves them out.
#[test]
fn nodes_out_of_a_diaphragm_are_left_out() {
    let script = "model basic -ndm 3 -ndf 6; node 1 0 0 0; node 2 0 0 3; node 3 2 1 3.5; node 4 2 1 0
        fix 1 1 1 1 1 1 1; fix 4 1 1 1 1 1 1
        geomTransf Linear 1 1 0 0
        element elasticBeamColumn 1 1 2 0.1 2e5 8e4 1e-3 1e-3 2e-3 1
        element elasticBeamColumn 2 4 3 0.1 2e5 8e4 1e-3 1e-3 2e-3 1
        rigidDiaphragm 3 2 3
        timeSeries Linear 1; pattern Plain 1 1 { load 2 10 5 0 0 0 3 }
        constraints Transformation; numberer Plain; system FullGeneral; test NormUnbalance 1e-8 30; algorithm Newton
        integrator LoadControl 1; analysis Static
        analyze 1; puts \"[nodeDisp 2 2] [nodeDisp 3 1]\"";
    assert!(Script::default().run(script).error().message.contains("does not lie in the diaphragm"));
    let ran = Script::compat().run(script).done();
    assert!(ran.warnings().iter().any(|w| w.message.contains("does not lie in the diaphragm")));
    let got = ran.numbers();
    // 5 L^3 / 3 E I of the column by itself.
    assert!(close(got[0], 5.0 * 27.0 / (3.0 * 2e5 * 2e-3), 1e-9) && got[1] == 0.0, "{got:?}");
}

/// A beam of one Lobatto point carries nothing; the beam beside it carries all.
#[test]
fn one_lobatto_point_has_no_weight() {
    let script = "model basic -ndm 2 -ndf 3; node 1 0 0; node 2 3 0; fix 1 1 1 1
        section Elastic 1 2e5 0.1 1e-3; beamIntegration Lobatto 1 1 1; geomTransf Linear 1
        element dispBeamColumn 1 1 2 1 1; element elasticBeamColumn 2 1 2 0.1 2e5 1e-3 1
        timeSeries Linear 1; pattern Plain 1 1 { load 2 0 2 0 }
        constraints Plain; numberer Plain; system FullGeneral; test NormUnbalance 1e-8 30; algorithm Newton
        integrator LoadControl 1; analysis Static
        analyze 1; puts [nodeDisp 2 2]";
    assert!(Script::default().run(script).error().message.contains("no rule with 1 points"));
    let ran = Script::compat().run(script).done();
    assert!(ran.warnings().iter().any(|w| w.message.contains("no rule with 1 points")));
    assert!(close(ran.numbers()[0], 2.0 * 27.0 / (3.0 * 2e5 * 1e-3), 1e-9), "{:?}", ran.numbers());
}

/// Without supports in the equations a penalty of zero leaves the springs to hold the node.
#[test]
fn a_penalty_of_zero_holds_nothing() {
    let script = "model basic -ndm 1 -ndf 1; node 1 0; node 2 0; node 3 0; fix 1 1
        uniaxialMaterial Elastic 1 1000.; element zeroLength 1 1 2 -mat 1 -dir 1; element zeroLength 2 1 3 -mat 1 -dir 1
        equalDOF 2 3 1
        timeSeries Linear 1; pattern Plain 1 1 { load 2 10 }
        constraints Penalty 1e8 0; numberer Plain; system FullGeneral; test NormUnbalance 1e-6 30; algorithm Newton
        integrator LoadControl 1; analysis Static
        analyze 1; puts \"[nodeDisp 2 1] [nodeDisp 3 1]\"";
    for ran in [Script::default().run(script).done(), Script::compat().run(script).done()] {
        assert!(
            ran.warnings().iter().any(|w| w.message.contains("penalty alphaM") && w.message.contains("without them"))
        );
        let got = ran.numbers();
        assert!(close(got[0], 0.01, 1e-4) && got[1].abs() < 1e-6, "{got:?}");
    }
    let below = script.replace("1e8 0", "1e8 -1");
    assert!(Script::default().run(&below).error().message.contains("penalty alphaM"));
}

/// End displacements and rotations of a beam with hinges that have moments alone.
const LACKING: [f64; 6] = [0.00012, 0.09675, 0.07185, 0.003, -0.0344, 0.0495];

/// Hinge sections without axial force and torsion are rigid there: the numbers of openseespy 3.7.1.
#[test]
fn a_section_that_lacks_a_resultant_is_rigid() {
    let script = |hinge: &str| {
        format!(
            "model basic -ndm 3 -ndf 6; node 1 0 0 0; node 2 3 0 0; fix 1 1 1 1 1 1 1
            uniaxialMaterial Elastic 1 200.; uniaxialMaterial Elastic 2 300.; uniaxialMaterial Elastic 3 2e4
            uniaxialMaterial Elastic 4 80.
            section Aggregator 1 {hinge}; section Elastic 2 2e5 0.1 1e-3 2e-3 8e4 1e-3
            geomTransf Linear 1 0 0 1
            element forceBeamColumn 1 1 2 1 \"HingeRadau 1 0.3 1 0.3 2\"
            timeSeries Linear 1; pattern Plain 1 1 {{ load 2 1 2 3 0.1 0.2 0.3 }}
            constraints Plain; numberer Plain; system FullGeneral; test NormUnbalance 1e-8 30; algorithm Newton
            integrator LoadControl 1; analysis Static
            analyze 1; puts [nodeDisp 2]"
        )
    };
    let ran = Script::default().run(&script("1 Mz 2 My")).done();
    let without = |r: &str| {
        ran.warnings().iter().filter(|w| w.message.contains(&format!("has no {r}: the beam is rigid there"))).count()
    };
    assert!(without("P") == 1 && without("T") == 1, "{:?}", ran.warnings());
    let got = ran.numbers();
    for (g, e) in got.iter().zip(LACKING) {
        assert!(close(*g, e, 1e-9), "{got:?}");
    }
    let whole = Script::default().run(&script("1 Mz 2 My 3 P 4 T")).done();
    assert!(whole.warnings().is_empty(), "{:?}", whole.warnings());
    let none = script("1 Mz 3 P 4 T")
        .replace("section Elastic 2 2e5 0.1 1e-3 2e-3 8e4 1e-3", "section Aggregator 2 1 Mz 3 P 4 T");
    assert!(Script::default().run(&none).error().message.contains("has no My, which the beam needs"));
}
