//! Constrained nodes under `constraints Transformation` as OpenSees moves them; numbers of openseespy 3.7.1.

use crate::close;
use crate::script::Script;

/// A cantilever with a chain of rigid links whose tags fall.
const CHAIN: &str = "model basic -ndm 2 -ndf 3
    node 1 0 0; node 2 0 3; node 9 1 3; node 8 2 3; node 7 3 3; fix 1 1 1 1
    geomTransf Linear 1; element elasticBeamColumn 1 1 2 0.1 2e8 1e-4 1
    rigidLink beam 2 9; rigidLink beam 9 8; rigidLink beam 8 7
    timeSeries Linear 1; pattern Plain 1 1 { load 2 10 5 0 }
    constraints Transformation; numberer RCM; system BandGeneral; algorithm Linear; integrator LoadControl 0.25
    analysis Static
    for {set i 0} {$i < 4} {incr i} { analyze 1; puts \"[nodeDisp 9 2] [nodeDisp 8 2] [nodeDisp 7 2]\" }";

fn check(got: &[f64], expected: &[f64]) {
    assert_eq!(got.len(), expected.len(), "{got:?}");
    for (i, (g, e)) in got.iter().zip(expected).enumerate() {
        assert!(close(*g, *e, 1e-9) || (g - e).abs() < 1e-15, "number {i}: {g} {e} of {got:?}");
    }
}

#[test]
fn a_chain_of_rigid_links_is_a_step_late() {
    let compat = Script::compat().run(CHAIN).numbers();
    let expected = [
        [-0.0005623124999999999, 0.0, 0.0],
        [-0.0011246249999999998, -0.0011248124999999997, -0.0016873124999999996],
        [-0.0016869374999999999, -0.0022496249999999995, -0.003374624999999999],
        [-0.0022492500000000004, -0.0033744375, -0.0050619375],
    ];
    check(&compat, expected.as_flattened());
    let own = Script::default().run(CHAIN).numbers();
    assert!(close(own[10], 2.0 * own[9], 1e-3) && close(own[11], 3.0 * own[9], 1e-3), "{own:?}");
}

/// Three equal masses on one spring, tied one to the other with falling tags, under a ground motion.
fn tied_masses(algorithm: &str, integrator: &str) -> String {
    format!(
        "model basic -ndm 1 -ndf 1; node 100 0; fix 100 1
        foreach n {{1 2 3}} {{ node $n 0; mass $n 2.0 }}
        uniaxialMaterial Elastic 1 600.; element zeroLength 1 100 3 -mat 1 -dir 1
        equalDOF 3 2 1; equalDOF 2 1 1
        timeSeries Trig 1 0 10 1.0; pattern UniformExcitation 1 1 -accel 1
        constraints Transformation; numberer Plain; system FullGeneral; test NormUnbalance 1e-8 10
        algorithm {algorithm}; integrator {integrator}; analysis Transient
        for {{set i 0}} {{$i < 5}} {{incr i}} {{
            analyze 1 0.01; puts \"[nodeDisp 3 1] [nodeDisp 2 1] [nodeDisp 1 1] [nodeVel 1 1] [nodeAccel 1 1]\"
        }}"
    )
}

#[test]
fn a_chain_of_masses_follows_the_iteration_before() {
    let expected = [
        [-1.5638983693477802e-06, -1.5638983693477802e-06, 0.0, 0.0, 0.0],
        [
            -9.353847388790763e-06,
            -9.353847388790763e-06,
            -3.1277967386955603e-06,
            0.00031277967386955603,
            0.18766780432173363,
        ],
        [
            -2.9478192244108515e-05,
            -2.9478192244108515e-05,
            -1.7143796408233745e-05,
            0.0012452101300190405,
            0.6220142084636018,
        ],
        [
            -6.781172351422434e-05,
            -6.781172351422434e-05,
            -4.960253709942627e-05,
            0.00277965884104451,
            1.2948231221669122,
        ],
        [
            -0.0001298835125472753,
            -0.0001298835125472753,
            -0.00010614525478434017,
            0.004887047412978656,
            2.193337093829183,
        ],
    ];
    for algorithm in ["Linear", "Newton"] {
        let compat = Script::compat().run(&tied_masses(algorithm, "Newmark 0.5 0.25")).numbers();
        check(&compat, expected.as_flattened());
    }
    let own = Script::default().run(&tied_masses("Newton", "Newmark 0.5 0.25")).numbers();
    assert!(own.chunks(5).all(|row| row[0] == row[2]), "{own:?}");
}

/// How central differences move late nodes is not followed: the refusal names the integrator and the degree of freedom.
#[test]
fn late_nodes_are_refused_for_other_integrators() {
    let ran = Script::compat().run(&tied_masses("Linear", "CentralDifference"));
    let failure = ran.interp.host.last_failure.as_ref().map(ToString::to_string).unwrap_or_default();
    assert!(failure.contains("CentralDifference") && failure.contains("node 1"), "{failure}");
    // Without a late node nothing is refused.
    let rising = tied_masses("Linear", "CentralDifference")
        .replace("equalDOF 3 2 1; equalDOF 2 1 1", "equalDOF 3 2 1; equalDOF 3 1 1");
    let ran = Script::compat().run(&rising);
    assert!(ran.interp.host.last_failure.is_none() && ran.numbers()[22] != 0.0, "{:?}", ran.numbers());
}

/// The mass of node 7 joins what no element joins: OpenSees drops that from its banded matrices, and one correction cannot make
/// up for it. With `FullGeneral`, and for a mass that joins nothing, the numbers are OpenSees'.
#[test]
fn lost_terms_of_a_mass_are_refused_under_one_correction() {
    let script = "model basic -ndm 2 -ndf 3
        node 1 0 0; node 2 0 3; node 3 1 3; node 4 2 4; fix 1 1 1 1
        geomTransf Linear 1; element elasticBeamColumn 1 1 2 0.1 2e8 1e-4 1
        mass 2 1 1 0.1; mass 3 2 2 0.1; mass 4 2 3 0.1
        equalDOF 2 3 1 3; rigidLink beam 3 4
        timeSeries Linear 1; pattern Plain 1 1 { load 2 10 5 0; load 4 3 1 0.5 }
        constraints Transformation; system BandGeneral; algorithm Linear; integrator Newmark 0.5 0.25
        analysis Transient; analyze 3 0.01; puts \"[nodeDisp 2 1] [nodeDisp 3 2] [nodeDisp 4 1]\"";
    let failure =
        |script: &str| Script::compat().run(script).interp.host.last_failure.as_ref().map(ToString::to_string);
    let refused = failure(script).unwrap_or_default();
    assert!(refused.contains("algorithm Linear") && refused.contains("node 4"), "{refused}");
    for same in [script.replace("BandGeneral", "FullGeneral"), script.replace("mass 4 2 3 0.1", "mass 4 0 3 0.1")] {
        assert_eq!(failure(&same), None);
    }
    assert_eq!(failure(&script.replace("algorithm Linear", "algorithm Newton")), None);
}

/// Node 9 follows node 2, which is held vertically.
#[test]
fn a_node_that_follows_a_held_one() {
    let model = "model basic -ndm 2 -ndf 3
        node 1 0 0; node 2 0 3; node 9 1 3; fix 1 1 1 1; fix 2 0 1 0
        geomTransf Linear 1; element elasticBeamColumn 1 1 2 0.1 2e8 1e-4 1
        rigidLink beam 2 9
        timeSeries Linear 1; pattern Plain 1 1 { load 2 10 5 0 }
        constraints Transformation; numberer RCM; system BandGeneral; algorithm Linear; integrator LoadControl 0.25
        analysis Static
        for {set i 0} {$i < 4} {incr i} { analyze 1; puts \"[nodeDisp 2 1] [nodeDisp 9 1] [nodeDisp 9 2]\" }";
    let compat = Script::compat().run(model).numbers();
    let expected: Vec<f64> = (1..=4).flat_map(|i| [0.001125 * f64::from(i), 0.001125, -0.0005625]).collect();
    check(&compat, &expected);
    let own = Script::default().run(model).numbers();
    assert!(own.chunks(3).all(|row| close(row[0], row[1], 1e-12)), "{own:?}");
}

/// A step that fails leaves its motion with the handler of openseespy 3.7.1: the tied node misses it for good.
#[test]
fn a_failed_step_is_missing_in_tied_nodes() {
    let script = "model basic -ndm 2 -ndf 3
        node 1 0 0; node 2 0 3; node 5 1 3; node 7 1 4; fix 1 1 1 1
        geomTransf Linear 1; element elasticBeamColumn 1 1 2 0.1 2e8 1e-4 1
        mass 2 2 2 0.1; mass 5 1 1 0.1; mass 7 1 1 0.1
        rigidLink beam 2 5; equalDOF 2 7 1
        timeSeries Sine 1 0 10 0.3; pattern Plain 1 1 { load 2 10 5 0 }
        constraints Transformation; numberer RCM; system FullGeneral; algorithm Newton; test NormDispIncr 1e-10 20
        integrator Newmark 0.5 0.25; analysis Transient
        analyze 1 0.01
        test NormDispIncr 1e-30 2; analyze 1 0.01; test NormDispIncr 1e-10 20
        analyze 2 0.01; puts \"[nodeDisp 2 1] [nodeDisp 5 1] [nodeDisp 5 2] [nodeDisp 7 1]\"";
    check(
        &Script::compat().run(script).numbers(),
        &[0.0002224532961981918, 0.00016203290452781728, -5.956728740831118e-5, 0.00016203290452781728],
    );
    let chain = Script::compat().run(&script.replace("equalDOF 2 7 1", "equalDOF 5 7 1"));
    let refused = chain.interp.host.last_failure.as_ref().map(ToString::to_string).unwrap_or_default();
    assert!(refused.contains("after a step that has failed") && refused.contains("node 7"), "{refused}");
    let own = Script::default().run(script).numbers();
    assert!(close(own[0], own[1], 1e-12) && close(own[0], own[3], 1e-12), "{own:?}");
}
