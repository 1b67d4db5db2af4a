//! Iterations of the algorithms beside those of OpenSees (openseespy 3.7.1).

use super::close;
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

/// Steps along the path of two yielding springs. OpenSees' numbers are those of openseespy 3.7.1.
#[test]
fn hyper_spherical_steps() {
    let script = "model basic -ndm 1 -ndf 1
        node 1 0; node 2 0; node 3 0; fix 1 1
        uniaxialMaterial Steel02 1 10. 100. 0.05 18 0.925 0.15
        uniaxialMaterial Steel02 2 9. 80. 0.03 18 0.925 0.15
        element zeroLength 1 1 2 -mat 1 -dir 1; element zeroLength 2 2 3 -mat 2 -dir 1
        timeSeries Linear 1
        pattern Plain 1 1 { load 3 8.5; load 2 1.5 }
        constraints Plain; numberer Plain; system FullGeneral; test NormDispIncr 1e-10 100; algorithm Newton
        integrator HSConstraint 0.5 1.0 0.02 2.0; analysis Static
        for {set i 0} {$i < 4} {incr i} { analyze 1; puts \"[getTime] [nodeDisp 2 1] [nodeDisp 3 1]\" }";
    let v = Script::compat().run(script).done().numbers();
    let times = [1.0231612994606902, 1.1000873967284168, 1.1543873292802536, 1.2086872500783472];
    let tips = [0.2596223747199221, 0.5588177198969905, 0.8597297830986095, 1.1606418441841946];
    for (i, row) in v.chunks(3).enumerate() {
        assert!(close(row[0], times[i], 1e-8) && close(row[2], tips[i], 1e-8), "{row:?}");
    }
    // In ours the steps are as long as they should be: (1/2)² Δu·Δu + 0.02² Δλ² f·f = 0.5².
    let v = Script::default().run(script).done().numbers();
    let mut last = [0.0; 3];
    for row in v.chunks(3) {
        let [t, u, w] = [row[0] - last[0], row[1] - last[1], row[2] - last[2]];
        let length = 0.25 * (u * u + w * w) + 0.02f64.powi(2) * t * t * (8.5f64.powi(2) + 1.5f64.powi(2));
        assert!(close(length, 0.25, 1e-8), "{row:?}");
        last.copy_from_slice(row);
    }
}

#[test]
fn a_path_of_an_empty_file_is_zero() {
    let script = "model basic -ndm 1 -ndf 1
        node 1 0; node 2 0; fix 1 1
        uniaxialMaterial Elastic 1 100.
        element zeroLength 1 1 2 -mat 1 -dir 1
        timeSeries Path 1 -dt 0.01 -filePath empty.txt -factor 2
        pattern Plain 1 1 { load 2 5.0 }
        integrator LoadControl 0.005; algorithm Linear; analysis Static
        puts [analyze 3]; puts [nodeDisp 2 1]";
    let ran = Script::compat().with_file("empty.txt", "").run(script).done();
    assert_eq!(ran.numbers(), [0.0, 0.0]);
    let ran = Script::default().with_file("empty.txt", "").run(script);
    assert!(ran.error().message.contains("the path has no values"));
}

/// A node without mass that nothing holds has no mode: that of the other node is there.
#[test]
fn a_mechanism_without_mass_stops_no_mode() {
    let script = "model basic -ndm 1 -ndf 1
        node 1 0; node 2 0; node 3 0; fix 1 1; mass 2 4.0
        uniaxialMaterial Elastic 1 100.; uniaxialMaterial Elastic 2 0.0
        element zeroLength 1 1 2 -mat 1 -dir 1; element zeroLength 2 2 3 -mat 2 -dir 1
        puts [eigen 1]";
    let lambda = Script::compat().run(script).done().numbers();
    assert!(close(lambda[0], 25.0, 1e-9), "{lambda:?}");
    assert!(Script::default().run(script).error().message.contains("mechanism"));
}
