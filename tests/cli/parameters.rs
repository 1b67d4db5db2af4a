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
fn mistakes_are_told() {
    for (command, message) in [
        ("updateParameter 3 1", "there is no parameter 3"),
        ("parameter 1 node 9 mass x", "node 9"),
        ("parameter 1 node 2 mass y", "only 1 degrees of freedom"),
        ("parameter 1 loadPattern 1 loadAtNode 1 1", "has no load on node 1"),
        ("parameter 1 node 2 mass x\nupdateParameter 1 -2", "the mass is -2"),
        ("parameter 1\nparameter 1", "there is a parameter 1 already"),
        ("parameter 1 element 1 E", "not supported yet"),
        ("remove parameter 4", "there is no parameter 4"),
    ] {
        let (code, _, err) = run(&format!("{SPRING}{command}\n"));
        assert!(code != Some(0) && err.contains(message), "{command}: {err}");
    }
}
