//! Elements with amendments and hinges around them are asked and changed as those inside.

use super::close;
use super::script::{Script, run};

/// A spring of stiffness 100 that is amended, and its parameter, made `before` the amendment or behind it. The numbers are the
/// displacement under a load of 10, then the value of the parameter and the displacement for a stiffness of 200.
fn changed(amendment: &str, before: bool) -> Vec<f64> {
    let parameter = "parameter 1 element 1 material 1 E";
    let [first, second] = if before { [parameter, amendment] } else { [amendment, parameter] };
    let ran = run(&format!(
        "model basic -ndm 1 -ndf 1; node 1 0; node 2 0; fix 1 1
        uniaxialMaterial Elastic 1 100.; element zeroLength 1 1 2 -mat 1 -dir 1
        {first}; {second}
        timeSeries Constant 1; pattern Plain 1 1 {{ load 2 10. }}
        constraints Plain; numberer Plain; system FullGeneral; test NormUnbalance 1e-10 20; algorithm Newton
        integrator LoadControl 1.; analysis Static
        analyze 1; puts [nodeDisp 2 1]
        updateParameter 1 200.; puts [getParamValue 1]; analyze 1; puts [nodeDisp 2 1]"
    ));
    assert!(ran.warnings().is_empty(), "{:?}", ran.warnings());
    ran.numbers()
}

#[test]
fn parameters_reach_the_element_inside() {
    for (amendment, first, second) in [
        ("", 0.1, 0.05),
        ("amend element 1 stiffening -factor 0.", 0.1, 0.05),
        // Beside a spring of 400 (e - 0.01).
        ("amend element 1 stiffening -factor 400. -from 0.01 -power 1.", 0.028, 14.0 / 600.0),
    ] {
        for before in [true, false] {
            let n = changed(amendment, before);
            let as_expected = close(n[0], first, 1e-9) && n[1] == 200.0 && close(n[2], second, 1e-9);
            assert!(as_expected, "{amendment}, parameter before it: {before}: {n:?}");
        }
    }
}

/// A law that takes the stiffness of the element follows it: 15 are elastic, the other 5 a tenth as stiff.
#[test]
fn laws_follow_the_stiffness_of_the_element() {
    for amendment in [
        "amend element 1 yielding -force 15. -hardening 0.1",
        "amend element 1 peakOriented -force 15. -hardening 0.1",
        "amend element 1 peakOriented -force 15. -hardening 0.1; amend element 1 stiffening -factor 0.",
        "amend element 1 stiffening -factor 0.; amend element 1 peakOriented -force 15. -hardening 0.1",
    ] {
        let ran = run(&format!(
            "model basic -ndm 1 -ndf 1; node 1 0; node 2 0; fix 1 1
            uniaxialMaterial Elastic 1 100.; element zeroLength 1 1 2 -mat 1 -dir 1
            parameter 1 element 1 material 1 E; {amendment}; updateParameter 1 200.
            timeSeries Linear 1; pattern Plain 1 1 {{ load 2 10. }}
            constraints Plain; numberer Plain; system FullGeneral; test NormUnbalance 1e-10 20; algorithm Newton
            integrator LoadControl 1.; analysis Static
            analyze 1; puts [nodeDisp 2 1]; analyze 1; puts [nodeDisp 2 1]"
        ));
        let n = ran.numbers();
        assert!(close(n[0], 0.05, 1e-9) && close(n[1], 0.075 + 5.0 / 20.0, 1e-9), "{amendment}: {n:?}");
    }
}

/// A cantilever with elastic hinges bends as the beam does, and turns at its foot.
#[test]
fn parameters_reach_the_beam_between_hinges() {
    let ran = run("model basic -ndm 2 -ndf 3; node 1 0 0; node 2 2 0; fix 1 1 1 1
        geomTransf Linear 1; element elasticBeamColumn 1 1 2 1. 1e3 0.1 1
        uniaxialMaterial Elastic 3 50.; parameter 1 element 1 E; amend element 1 hinges -mat 3 -end i
        timeSeries Constant 1; pattern Plain 1 1 { load 2 0. 1. 0. }
        constraints Plain; numberer Plain; system FullGeneral; test NormUnbalance 1e-10 20; algorithm Newton
        integrator LoadControl 1.; analysis Static
        analyze 1; puts [nodeDisp 2 2]
        updateParameter 1 4e3; analyze 1; puts [nodeDisp 2 2]");
    assert!(ran.warnings().is_empty(), "{:?}", ran.warnings());
    // l³/3EI + l²/k.
    let tip = |e: f64| 8.0 / (3.0 * e * 0.1) + 4.0 / 50.0;
    let n = ran.numbers();
    assert!(close(n[0], tip(1e3), 1e-9) && close(n[1], tip(4e3), 1e-9), "{n:?}");
}

/// A spring between a cantilever and its upper half lies where one between two halves does that were made apart.
#[test]
fn ends_of_elements_move_to_a_node_in_the_same_place() {
    let tip = |upper: &str, amendment: &str| {
        let ran = run(&format!(
            "model basic -ndm 2 -ndf 3; node 1 0 0; node 2 2 0; node 3 4 0; node 4 2 0; fix 1 1 1 1
            geomTransf Linear 1; element elasticBeamColumn 1 1 2 1. 1e3 0.1 1
            element elasticBeamColumn 2 {upper} 1. 1e3 0.1 1
            uniaxialMaterial Elastic 3 50.; element zeroLength 3 2 4 -mat 3 -dir 2; equalDOF 2 4 1 3; {amendment}
            timeSeries Constant 1; pattern Plain 1 1 {{ load 3 0. 1. 0. }}
            constraints Transformation; numberer Plain; system FullGeneral; test NormUnbalance 1e-10 20
            algorithm Newton; integrator LoadControl 1.; analysis Static
            analyze 1; puts [nodeDisp 3 2]"
        ));
        assert!(ran.warnings().is_empty(), "{:?}", ran.warnings());
        ran.numbers()[0]
    };
    let [moved, apart] = [tip("2 3", "amend element 2 ends -from 2 -to 4"), tip("4 3", "")];
    // l³/3EI + 1/k.
    assert!(moved == apart && close(moved, 64.0 / 300.0 + 1.0 / 50.0, 1e-9), "{moved} {apart}");
}

#[test]
fn ends_move_only_where_they_are() {
    let refused = |amendment: &str| {
        let ran = Script::default().run(&format!(
            "model basic -ndm 1 -ndf 1; node 1 0; node 2 1; node 3 1; uniaxialMaterial Elastic 1 100.
            element truss 1 1 2 1. 1; amend element 1 ends {amendment}"
        ));
        ran.error().message.clone()
    };
    assert!(refused("-from 1 -to 3").contains("node 3 is not at the place of node 1"));
    assert!(refused("-from 3 -to 2").contains("element 1 has no end at node 3"));
    assert!(refused("-from 2").contains("two nodes are needed"));
}

/// A parameter that the element in place of another does not have is no silent success.
#[test]
fn lost_parameter_is_reported() {
    let ran = run("model basic -ndm 1 -ndf 1; node 1 0; node 2 0; fix 1 1
        uniaxialMaterial Elastic 1 100.; uniaxialMaterial BoucWen 2 0.1 300. 1.5 40. 40. 1. 0. 0. 0.
        element zeroLength 1 1 2 -mat 1 -dir 1; parameter 1 element 1 material 1 E
        updateParameter 1 50.; remove element 1; updateParameter 1 60.
        element zeroLength 1 1 2 -mat 2 -dir 1; updateParameter 1 70.");
    let told: Vec<&str> = ran.warnings().iter().map(|d| d.message.as_str()).collect();
    assert!(told.len() == 1 && told[0].contains("no parameter \"material 1 E\" any more"), "{told:?}");
}

/// Bearings that follow OpenSees call by call, each with its recorded forces over a shaking after gravity.
fn shaken(bearing: &str, damping: &str, algorithm: &str, amendment: &str) -> Vec<f64> {
    let ran = Script::compat().run(&format!(
        "model basic -ndm 3 -ndf 6; node 1 0 0 0; fix 1 1 1 1 1 1 1
        node 2 0 0 0.3 -mass 102. 102. 102. 1 1 1; fix 2 0 0 0 1 1 1
        uniaxialMaterial KikuchiAikenHDR 10 X0.6 0.17 0.15; uniaxialMaterial AxialSp 21 6e5 1e3 -1e5 0.1 0.01 0.5
        {bearing}; {amendment}
        timeSeries Linear 1; pattern Plain 1 1 {{ load 2 0 0 -1000. 0 0 0 }}
        constraints Transformation; numberer RCM; system FullGeneral; test NormDispIncr 1e-6 100; algorithm Newton
        integrator LoadControl 0.1; analysis Static; analyze 10; loadConst -time 0.; wipeAnalysis; rayleigh {damping}
        timeSeries Trig 2 0. 1.2 0.5 -factor 1.5
        pattern UniformExcitation 2 1 -accel 2; pattern UniformExcitation 3 2 -accel 2 -fact 0.6
        recorder Element -file f.out -ele 1 force
        constraints Transformation; numberer RCM; system FullGeneral; test NormDispIncr 1e-4 100; algorithm {algorithm}
        integrator Newmark 0.5 0.25; analysis Transient; analyze 60 0.01"
    ));
    let ran = ran.done();
    assert_eq!(ran.tables["f.out"].len(), 60, "{}", ran.err);
    ran.tables["f.out"].concat()
}

const KIKUCHI: &str = "element KikuchiBearing 1 1 2 -shape round -size 0.46 0.15 -totalHeight 0.3 -nMSS 8 -matMSS 10 \
                       -limDisp 0.01 -nMNS 8 -matMNS 21 -orient 0 0 1 1 0 0";

/// An amendment that changes nothing keeps OpenSees' scheme: as many updates, and the tangent of the last of them.
/// The current tangent takes the place of the initial one.
#[test]
fn amended_element_keeps_its_number_of_updates() {
    for (damping, algorithm) in [
        ("0.1 0. 0.002 0.", "Newton"),
        ("0.1 0. 0. 0.002", "NewtonLineSearch -type Bisection"),
        ("0.1 0. 0.002 0.", "ModifiedNewton -initial"),
    ] {
        let plain = shaken(KIKUCHI, damping, algorithm, "");
        let amended = shaken(KIKUCHI, damping, algorithm, "amend element 1 stiffening -factor 0.");
        let most = plain.iter().fold(0.0f64, |m, f| m.max(f.abs()));
        let apart = plain.iter().zip(&amended).fold(0.0f64, |m, (a, b)| m.max((a - b).abs()));
        assert!(apart <= 1e-9 * most, "{algorithm}, damping {damping}: {apart:e} of {most:e}");
    }
}

/// Forces and stresses below an amended element are those after the amendment, deformations and strains the total ones.
#[test]
fn responses_inside_an_element_are_amended() {
    let recorded = |element: &str, amendment: &str, words: &str| {
        let ran = run(&format!(
            "model basic -ndm 1 -ndf 1; node 1 0; node 2 4; node 3 0; fix 1 1
            uniaxialMaterial Elastic 1 100.; {element}
            amend element 1 {amendment}
            timeSeries Linear 1; pattern Plain 1 1 {{ sp [lindex [eleNodes 1] 1] 1 0.02 }}
            recorder Element -file asked.out -ele 1 {words}; recorder Element -file force.out -ele 1 force
            constraints Transformation; numberer Plain; system FullGeneral; test NormUnbalance 1e-10 50; algorithm Newton
            integrator LoadControl 0.5; analysis Static; analyze 2"
        ));
        assert!(ran.warnings().is_empty(), "{:?}", ran.warnings());
        let last = |file: &str| ran.tables[file].last().cloned().unwrap_or_default();
        (last("asked.out"), last("force.out")[1])
    };
    let spring = "fix 2 1; element zeroLength 1 1 3 -mat 1 -dir 1";
    let truss = "fix 3 1; element truss 1 1 2 5. 1";
    let stiffer = "stiffening -factor 400. -from 0.01 -power 1.";
    // 100 x 0.02 of the spring, and 400 x 0.01 beside it.
    for words in ["material 1 stress", "basicForce", "force"] {
        let (asked, force) = recorded(spring, stiffer, words);
        assert!(close(*asked.last().unwrap(), 6.0, 1e-9) && close(force, 6.0, 1e-9), "{words}: {asked:?}, {force}");
    }
    let (asked, _) = recorded(spring, stiffer, "material 1 stressStrain");
    assert!(close(asked[0], 6.0, 1e-9) && close(asked[1], 0.02, 1e-9), "{asked:?}");
    let (asked, _) = recorded(spring, stiffer, "defoANDforce");
    assert!(close(asked[0], 0.02, 1e-9) && close(asked[1], 6.0, 1e-9), "{asked:?}");
    // The force of the truss is its stress times 5; its strain is a quarter of the deformation.
    for words in ["material stress", "material 1 stress", "stress"] {
        let (asked, force) = recorded(truss, stiffer, words);
        assert!(close(force, 6.5, 1e-9) && close(asked[0], 6.5 / 5.0, 1e-9), "{words}: {asked:?}, {force}");
    }
    let (asked, force) = recorded(truss, stiffer, "localForce");
    assert!(close(asked[0], -force, 1e-12) && close(asked[1], force, 1e-12), "{asked:?}");
    // Slip in series is a part of the recorded strain, not of the spring's own.
    let (asked, force) = recorded(spring, "slip -size 0.01 -width 0.1", "material 1 stressStrain");
    assert!(close(asked[1], 0.02, 1e-9) && force < 1.9 && close(asked[0], force, 1e-9), "{asked:?}, {force}");
}
