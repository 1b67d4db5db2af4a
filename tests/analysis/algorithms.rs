//! Iterations of the algorithms beside those of OpenSees (openseespy 3.7.1).

use super::script::Script;

/// Two springs of smooth steel in one step: result of `analyze`, `numIter`, `testIter` of an algorithm.
fn counts(algorithm: &str, iterations: usize) -> Vec<f64> {
    let script = format!(
        "model basic -ndm 1 -ndf 1
        node 1 0; node 2 0; node 3 0; fix 1 1
        uniaxialMaterial Steel02 1 10. 100. 0.05 18 0.925 0.15
        uniaxialMaterial Steel02 2 9. 80. 0.03 18 0.925 0.15
        element zeroLength 1 1 2 -mat 1 -dir 1; element zeroLength 2 2 3 -mat 2 -dir 1
        timeSeries Linear 1
        pattern Plain 1 1 {{ load 3 8.5; load 2 1.5 }}
        constraints Plain; numberer Plain; system FullGeneral
        test NormDispIncr 1e-10 {iterations}; algorithm {algorithm}
        integrator LoadControl 1.0; analysis Static
        puts [analyze 1]; puts [numIter]; puts [testIter]"
    );
    Script::default().run(&script).numbers()
}

#[test]
fn iterations_are_those_of_opensees() {
    for (algorithm, iterations) in [
        ("KrylovNewton", 8.0),
        ("KrylovNewton -maxDim 2", 8.0),
        ("SecantNewton", 9.0),
        ("SecantNewton -maxDim 1", 7.0),
        ("SecantNewton -numTerms 1", 11.0),
        ("SecantNewton -cutOut 0.5 1.5", 11.0),
        ("PeriodicNewton", 10.0),
        ("PeriodicNewton -maxDim 5", 13.0),
        ("RaphsonNewton", 7.0),
        ("RaphsonNewton -increment initial", 7.0),
    ] {
        assert_eq!(counts(algorithm, 40), [0.0, iterations, iterations], "{algorithm}");
    }
    // The tests count where the algorithm does not.
    let searched = counts("NewtonLineSearch", 40);
    assert!(searched[0] == 0.0 && searched[1] == 0.0 && searched[2] > 0.0, "{searched:?}");
}

/// With the initial tangent the springs yield too much for 40 iterations.
#[test]
fn failures_are_those_of_opensees() {
    for algorithm in [
        "PeriodicNewton -iterate initial",
        "PeriodicNewton -iterate noTangent",
        "SecantNewton -iterate initial -increment initial",
        "RaphsonNewton -iterate initial",
    ] {
        assert_eq!(counts(algorithm, 40)[..2], [-3.0, 40.0], "{algorithm}");
    }
}
