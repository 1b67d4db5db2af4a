//! Models that change between analyses.

use super::close;
use super::script::{Script, run};

/// Removing an element passes its force to the others; what is left keeps its history.
#[test]
fn elements_come_and_go() {
    let ran = run("model basic -ndm 1 -ndf 1
        node 1 0; node 2 0; node 3 0; fix 1 1
        uniaxialMaterial Elastic 1 100.0
        uniaxialMaterial ElasticPP 2 100.0 0.01
        element zeroLength 5 1 2 -mat 1 -dir 1
        element zeroLength 3 1 2 -mat 2 -dir 1
        element zeroLength 7 2 3 -mat 1 -dir 1
        timeSeries Linear 1
        pattern Plain 1 1 { load 3 5.0 }
        constraints Plain; numberer Plain; system BandGeneral; test NormUnbalance 1e-9 20; algorithm Newton
        integrator LoadControl 0.1; analysis Static
        analyze 10
        puts [nodeDisp 2 1]
        loadConst -time 0.0
        remove element 5
        puts [getEleTags]
        puts [eleResponse 3 material 1 stress]
        uniaxialMaterial Elastic 4 400.0
        element zeroLength 9 1 2 -mat 4 -dir 1
        analyze 1
        puts [nodeDisp 2 1]; puts [eleForce 9 2]");
    let v = ran.numbers();
    assert!(close(v[0], 0.04, 1e-9), "4 on the elastic spring, 1 on the plastic one");
    assert_eq!(&v[1..3], [3.0, 7.0]);
    assert!(close(v[3], 1.0, 1e-12));
    // The new spring is without force where it is made: it takes the 4 that the removed one held.
    assert!(close(v[4], 0.05, 1e-9) && close(v[5], 4.0, 1e-9), "{v:?}");
}

#[test]
fn supports_and_patterns_come_and_go() {
    let ran = run("model basic -ndm 1 -ndf 1
        node 1 0; node 2 0; node 3 0; fix 1 1; fix 3 1
        uniaxialMaterial Elastic 1 100.0
        element zeroLength 1 1 2 -mat 1 -dir 1; element zeroLength 2 2 3 -mat 1 -dir 1
        timeSeries Linear 1
        pattern Plain 1 1 { load 2 1.0 }
        constraints Transformation; numberer Plain; system BandGeneral; test NormUnbalance 1e-9 20; algorithm Newton
        integrator LoadControl 1.0; analysis Static
        analyze 1
        puts [nodeDisp 2 1]
        remove sp 3 1
        analyze 1
        puts [nodeDisp 2 1]
        remove loadPattern 1
        analyze 1
        puts [nodeDisp 2 1]
        remove element 2
        remove node 3
        puts [getNodeTags]");
    let v = ran.numbers();
    assert!(close(v[0], 0.005, 1e-9) && close(v[1], 0.02, 1e-9) && v[2].abs() < 1e-12);
    assert_eq!(&v[3..], [1.0, 2.0]);
}

/// A node held after it has moved stays where it is.
#[test]
fn a_support_holds_where_it_is_made() {
    let ran = run("model basic -ndm 1 -ndf 1
        node 1 0; node 2 0; fix 1 1
        uniaxialMaterial Elastic 1 100.0
        element zeroLength 1 1 2 -mat 1 -dir 1
        timeSeries Linear 1
        pattern Plain 1 1 { load 2 1.0 }
        constraints Plain; numberer Plain; system BandGeneral; test NormUnbalance 1e-9 20; algorithm Newton
        integrator LoadControl 1.0; analysis Static
        analyze 1
        fix 2 1
        analyze 3
        puts [nodeDisp 2 1]; puts [nodeReaction 2 1]");
    let v = ran.numbers();
    assert!(close(v[0], 0.01, 1e-9) && close(v[1], -3.0, 1e-9), "{v:?}");
}

#[test]
fn reset_goes_back_to_the_virgin_model() {
    let ran = run("model basic -ndm 1 -ndf 1
        node 1 0; node 2 0; fix 1 1
        uniaxialMaterial ElasticPP 1 100.0 0.01
        element zeroLength 1 1 2 -mat 1 -dir 1
        timeSeries Linear 1
        pattern Plain 1 1 { sp 2 1 0.01 }
        constraints Transformation; numberer Plain; system BandGeneral; test NormUnbalance 1e-9 20; algorithm Newton
        integrator LoadControl 1.0; analysis Static
        analyze 1
        set first [eleResponse 1 material 1 stressStrain]
        analyze 5
        reset
        puts [getTime]
        analyze 1
        puts [expr {$first eq [eleResponse 1 material 1 stressStrain]}]");
    assert_eq!(ran.numbers(), [0.0, 1.0]);
}

/// Two models in one script, with a `wipe` between, know nothing of each other.
#[test]
fn wipe_leaves_nothing_behind() {
    let text = "model basic -ndm 1 -ndf 1
        node 1 0; node 2 0; fix 1 1
        uniaxialMaterial Elastic 1 100.0
        element zeroLength 1 1 2 -mat 1 -dir 1
        timeSeries Linear 1
        pattern Plain 1 1 { load 2 1.0 }
        constraints Plain; numberer Plain; system BandGeneral; test NormUnbalance 1e-9 20; algorithm Newton
        integrator LoadControl 1.0; analysis Static
        analyze 3
        puts [nodeDisp 2 1]
        wipe\n";
    let v = run(&format!("{text}{text}")).numbers();
    assert_eq!(v[0], v[1]);
}

/// A strip of quadrilaterals under uniform tension, with a side that is curved: σ L/E whatever the mesh.
#[test]
fn a_block_of_quadrilaterals_stretches_evenly() {
    let found = run("model basic -ndm 2 -ndf 2
        nDMaterial ElasticIsotropic 1 1000.0 0.25
        block2D 4 3 1 1 quad {0.5 PlaneStress 1} {1 0 0  2 4 0  3 4 2  4 0 2  9 2.2 1.1}
        foreach n {1 6 11 16} { fix $n 1 0 }
        fix 1 0 1
        timeSeries Linear 1
        pattern Plain 1 1 { load 5 1 0; load 10 2 0; load 15 2 0; load 20 1 0 }
        constraints Plain; numberer RCM; system ProfileSPD; algorithm Linear; integrator LoadControl 1; analysis Static
        analyze 1
        puts [nodeDisp 10 1]; puts [nodeDisp 20 2]; puts [llength [getEleTags]]")
    .numbers();
    // 6 over 2 x 0.5.
    assert!(close(found[0], 6.0 * 4.0 / 1000.0, 1e-9));
    assert!(close(found[1], -0.25 * 6.0 * 2.0 / 1000.0, 1e-9));
    assert_eq!(found[2], 12.0);
}

/// Statistics and linear algebra by tcllib's names; values of a 3 x 3 system and of the normal distribution.
#[test]
fn packages_of_tcllib() {
    let n = run("package require math::statistics; package require math::linearalgebra 1.0
        puts [math::statistics::mean {1 2 {} 6}]; puts [math::statistics::stdev {1 2 6}]
        puts [math::statistics::cdf-normal 1 2 4.92]; puts [math::statistics::Inverse-cdf-normal 0 1 0.975]
        puts [llength [math::statistics::random-normal 0 1 5]]
        set m [math::linearalgebra::mkMatrix 3 3 1.0]
        math::linearalgebra::setelem m 0 0 4.0; math::linearalgebra::setrow m 2 {2 0 5}; math::linearalgebra::setcol m 1 {1 3 0}
        puts [math::linearalgebra::getelem $m 1 2]; puts [math::linearalgebra::det $m]
        puts [math::linearalgebra::matmul $m [math::linearalgebra::solvePGauss $m {7 14 21}]]")
    .numbers();
    let expected = [3.0, 7f64.sqrt(), 0.975_002_104_851_780_1, 1.959_963_984_540_054, 5.0, 1.0, 51.0, 7.0, 14.0, 21.0];
    assert!(n.len() == expected.len() && n.iter().zip(expected).all(|(n, e)| close(*n, e, 1e-12)), "{n:?}");
}

/// A trace of executions changes no result and is passed over with a warning.
#[test]
fn traces_of_executions_are_passed_over() {
    let ran = run("proc tell {args} { puts 1 }
        trace add execution analyze enter tell
        puts 2");
    assert_eq!(ran.numbers(), [2.0]);
    assert!(ran.warnings()[0].message.contains("trace"), "{:?}", ran.warnings());
}

/// Who is joined to whom, and what is held.
#[test]
fn constraints_are_listed() {
    let ran = run("model basic -ndm 2 -ndf 3
        node 1 0 0; node 2 0 3; node 3 2 4; node 4 2 4
        fix 1 1 1 0; fix 4 0 0 1
        rigidLink beam 2 3; equalDOF 3 4 1 2
        puts [getFixedNodes]; puts [getFixedDOFs 1]; puts [getConstrainedNodes]; puts [getConstrainedNodes 3]
        puts [getRetainedNodes]; puts [getConstrainedDOFs 4]; puts [getRetainedDOFs 2]; puts [getNumElements]
        puts [getConstrainedDOFs 3 2 3]; puts [getConstrainedDOFs 4 3 3]; puts [getRetainedDOFs 3 4 2]");
    assert_eq!(ran.numbers(), [1., 4., 1., 2., 3., 4., 4., 2., 3., 1., 2., 1., 2., 3., 0., 3., 2.]);
}

/// Loads along members go with their pattern, also with the last one that has any.
#[test]
fn a_load_along_a_member_goes_with_its_pattern() {
    for element in
        ["elasticBeamColumn 1 1 2 0.01 2e8 1e-4 1", "forceBeamColumn 1 1 2 5 1 1", "dispBeamColumn 1 1 2 3 1 1"]
    {
        let found = run(&format!(
            "model basic -ndm 2 -ndf 3; node 1 0 0; node 2 0 3.; fix 1 1 1 1; geomTransf PDelta 1
            section Elastic 1 2e8 0.01 1e-4; element {element}
            timeSeries Constant 1; pattern Plain 1 1 {{ load 2 10. -50. 0. }}
            constraints Plain; numberer Plain; system BandGeneral; test NormDispIncr 1e-10 20; algorithm Newton
            integrator LoadControl 1.; analysis Static
            analyze 1; puts [nodeDisp 2 1]
            pattern Plain 2 1 {{ eleLoad -ele 1 -type -beamUniform 5. }}; analyze 1; puts [nodeDisp 2 1]
            remove loadPattern 2; analyze 1; puts [nodeDisp 2 1]"
        ))
        .done()
        .numbers();
        assert!((found[1] / found[0] - 1.0).abs() > 0.1, "{element}: {found:?}");
        assert!((found[2] / found[0] - 1.0).abs() < 1e-9, "{element}: {found:?}");
    }
}

/// After a further `model`, tags of time series and transformations are free again, as in OpenSees; those of materials are not.
#[test]
fn a_further_model_frees_tags() {
    let ran = run("model basic -ndm 2 -ndf 3
        timeSeries Linear 1; timeSeries Constant 2; geomTransf Linear 1; uniaxialMaterial Elastic 1 100.
        node 1 0 0; node 2 1 0; node 3 2 0; fix 1 1 1 1; fix 2 0 1 1
        pattern Plain 1 1 { load 2 1. 0. 0. }
        model basic -ndm 2 -ndf 3
        timeSeries Linear 1 -factor 3.; geomTransf PDelta 1
        puts [catch {timeSeries Linear 1}]; puts [catch {geomTransf Linear 1}]; puts [catch {uniaxialMaterial Elastic 1 1.}]
        element truss 1 1 2 1. 1; element truss 2 2 3 1. 1; fix 3 0 1 1
        pattern Plain 2 1 { load 3 1. 0. 0. }; pattern Plain 3 2 { load 3 1. 0. 0. }
        constraints Plain; numberer Plain; system BandGeneral; algorithm Linear; integrator LoadControl 1.; analysis Static
        analyze 1; puts \"[nodeDisp 2 1] [nodeDisp 3 1]\"");
    let n = ran.numbers();
    assert!(n[..3] == [1.0, 1.0, 1.0] && (n[3] - 0.05).abs() < 1e-12 && (n[4] - 0.09).abs() < 1e-12, "{n:?}");
}

/// A script for several processes runs in one, as in OpenSees.
#[test]
fn one_process_has_nobody_to_wait_for() {
    let ran = run("barrier; send -pid 1 3.; set x 5; recv -pid 1 x; partition; Bcast x; setStartNodeTag 100
        model basic -ndm 1 -ndf 1; node 7 0.
        puts \"[getPID] [getNP] $x [getNodeTags]\"");
    assert_eq!(ran.numbers(), [0.0, 1.0, 5.0, 7.0]);
    assert!(ran.warnings().is_empty(), "{:?}", ran.warnings());
}

/// The deflection of a cantilever, w L^4 / (8 E I), times the factor of the pattern that the load names.
#[test]
fn a_load_on_an_element_goes_into_the_pattern_that_it_names() {
    let deflection = |option: &str| {
        Script::default().run(&format!(
            "model basic -ndm 2 -ndf 3; node 1 0 0; node 2 3.0 0; fix 1 1 1 1
            geomTransf Linear 1; element elasticBeamColumn 1 1 2 1. 1. 1. 1
            timeSeries Linear 1; timeSeries Constant 2; pattern Plain 1 1 {{}}; pattern Plain 2 2 {{}}
            eleLoad -ele 1 -type -beamUniform 1.0 {option}
            integrator LoadControl 0.5; analysis Static; analyze 1; puts [nodeDisp 2 2]"
        ))
    };
    for (option, factor) in [("-pattern 1", 0.5), ("-pattern 2", 1.0), ("", 1.0)] {
        assert!(close(deflection(option).done().numbers()[0], factor * 81.0 / 8.0, 1e-9), "{option}");
    }
    assert!(deflection("-pattern 3").error().message.contains('3'));
}
