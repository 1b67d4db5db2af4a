//! Parameters of nodes and load patterns.

use super::run;

const SPRING: &str = "model BasicBuilder -ndm 1 -ndf 1\nnode 1 0\nnode 2 1\nfix 1 1\nmass 2 3.\n\
    uniaxialMaterial Elastic 1 100\nelement truss 1 1 2 1. 1\ntimeSeries Linear 1\n\
    pattern Plain 1 1 { load 2 1. }\nintegrator LoadControl 1\nalgorithm Linear\nanalysis Static\n";

#[test]
fn values_are_read_and_changed() {
    let (code, out, err) = run(&format!(
        "{SPRING}puts [parameter 1 node 2 mass x][parameter 2 loadPattern 1 loadAtNode 2 1][parameter 7 2.5]\n\
         parameter 8 node 2 disp 1\nputs [getParamTags]\n\
         puts \"[getParamValue 1] [getParamValue 2] [getParamValue 7] [getParamValue 8]\"\n\
         updateParameter 1 5\nputs [nodeMass 2 1]\nupdateParameter 2 7\nanalyze 1\n\
         puts \"[format %.10g [nodeDisp 2 1]] [format %.10g [getParamValue 8]]\"\n\
         remove parameter 2\nputs [getParamTags]\nsetParameter -val 9 -node 2 mass x\nputs [nodeMass 2 1]\n"
    ));
    assert_eq!(code, Some(0), "{err}");
    assert_eq!(out, "127\n1 2 7 8\n3.0 1.0 2.5 0.0\n5.0\n0.07 0.07\n1 7 8\n9.0\n");
}

#[test]
fn mistakes_are_reported() {
    for (command, message) in [
        ("updateParameter 3 1", "there is no parameter 3"),
        ("parameter 1 node 9 mass x", "node 9"),
        ("parameter 1 node 2 mass y", "only 1 degrees of freedom"),
        ("parameter 1 loadPattern 1 loadAtNode 1 1", "has no load on node 1"),
        ("parameter 1 node 2 mass x\nupdateParameter 1 -2", "the mass is -2"),
        ("parameter 1\nparameter 1", "there is a parameter 1 already"),
        ("parameter 1 element 7 E", "there is no element 7"),
        ("parameter 1 element 1 A\nupdateParameter 1 -2", "A is -2"),
        ("parameter 1 region 7 E", "there is no region 7"),
    ] {
        let (code, _, err) = run(&format!("{SPRING}{command}\n"));
        assert!(code != Some(0) && err.contains(message), "{command}: {err}");
    }
}

#[test]
fn numbers_of_elements_and_materials_are_changed() {
    let (code, out, err) = run(&format!(
        "{SPRING}parameter 1 element 1 E\nparameter 2 element 1 A\nregion 3 -ele 1\nparameter 3 region 3 E\n\
         puts \"[getParamValue 1] [getParamValue 2] [getParamValue 3]\"\n\
         analyze 1\nputs [format %.10g [nodeDisp 2 1]]\nupdateParameter 1 400\nanalyze 1\n\
         puts [format %.10g [nodeDisp 2 1]]\nupdateParameter 2 4\nanalyze 1\nputs [format %.10g [nodeDisp 2 1]]\n\
         setParameter -val 30 -ele 1 E\nputs [format %.10g [lindex [eleResponse 1 material tangent] 0]]\nanalyze 1\n\
         puts [format %.10g [nodeDisp 2 1]]\nparameter 9 element 1 nothing\n"
    ));
    assert_eq!(code, Some(0), "{err}");
    assert!(err.contains("has no parameter \"nothing\""), "{err}");
    // Loads 1 to 4 on stiffnesses 100, 400, 1600 and 120.
    assert_eq!(out, "100.0 1.0 100.0\n0.01\n0.005\n0.001875\n400\n0.03333333333\n");
}
