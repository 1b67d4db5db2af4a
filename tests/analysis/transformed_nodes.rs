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

/// The same in a transient analysis, with a damped spring at the node that follows.
#[test]
fn a_node_that_follows_a_held_one_in_time() {
    let model = |algorithm: &str, integrator: &str| {
        format!(
            "model basic -ndm 2 -ndf 3
            node 1 0 0; node 2 0 3 -mass 1 1 0.1; node 9 1 3 -mass 2 2 0.3; node 10 1 3
            fix 1 1 1 1; fix 2 0 1 0; fix 10 1 1 1
            geomTransf Linear 1; element elasticBeamColumn 1 1 2 0.1 2e8 1e-4 1
            uniaxialMaterial Elastic 1 3000. 20; element zeroLength 3 9 10 -mat 1 -dir 1 -doRayleigh 1
            rigidLink beam 2 9
            timeSeries Linear 1; pattern Plain 1 1 {{ load 2 10 5 0 }}
            rayleigh 0.3 0.002 0 0
            constraints Transformation; numberer RCM; system BandGeneral; test NormDispIncr 1e-12 10
            algorithm {algorithm}; integrator {integrator}; analysis Transient
            analyze 5 0.01; puts \"[nodeDisp 2 1] [nodeDisp 9 1] [nodeDisp 9 2] [nodeVel 9 2] [nodeAccel 9 1]\""
        )
    };
    let cases: [(&str, &str, [f64; 5]); 6] = [
        (
            "Linear",
            "Newmark 0.5 0.25",
            [
                5.079206864106593e-05,
                2.2857759909266624e-05,
                -1.0900313036557668e-05,
                -0.0013496900917402052,
                0.08687529532229665,
            ],
        ),
        (
            "Newton",
            "Newmark 0.5 0.25",
            [
                4.595605573551043e-05,
                2.01833332823643e-05,
                -9.86929686677795e-06,
                -0.0012091727515220418,
                0.06991133711237099,
            ],
        ),
        (
            "Newton",
            "HHT 0.8",
            [
                4.656793100982323e-05,
                2.0395862151808093e-05,
                -9.847731535628977e-06,
                -0.001205563981942203,
                0.0704965631486661,
            ],
        ),
        (
            "Linear",
            "Newmark 0.5 0.25 -form A",
            [
                4.9622890892234774e-05,
                1.9345570077032115e-07,
                -5.7333579890984015e-08,
                -0.0013145554137651656,
                0.08214086862696461,
            ],
        ),
        (
            "Newton",
            "GeneralizedAlpha 0.9 0.8",
            [
                4.505392968141974e-05,
                2.0028479718908042e-05,
                -9.634718431449246e-06,
                -0.0011935491363225278,
                0.07133005785139626,
            ],
        ),
        (
            "Newton",
            "TRBDF2",
            [
                4.599096814838523e-05,
                2.006164124210984e-05,
                -9.57363365204258e-06,
                -0.001178499701208216,
                0.06967942452079975,
            ],
        ),
    ];
    for (algorithm, integrator, expected) in cases {
        let got = Script::compat().run(&model(algorithm, integrator)).numbers();
        for (g, e) in got.iter().zip(expected) {
            assert!(close(*g, e, 1e-8), "{algorithm} {integrator}: {got:?} {expected:?}");
        }
    }
}

/// The second step fails at its first try: the constrained node stays behind for good.
#[test]
fn a_step_that_failed_moves_constrained_nodes() {
    let model = "model basic -ndm 1 -ndf 1; node 1 0; node 2 0 -mass 1; node 3 0 -mass 1; fix 1 1
        uniaxialMaterial Steel01 1 10 1000. 0.0001; element zeroLength 1 1 2 -mat 1 -dir 1
        equalDOF 2 3 1
        timeSeries Trig 1 0 10 0.3; pattern Plain 1 1 { load 2 400 }
        constraints Transformation; numberer Plain; system FullGeneral; algorithm Newton; integrator Newmark 0.5 0.25
        test NormUnbalance 1e-8 1; analysis Transient
        for {set i 0} {$i < 4} {incr i} {
            if {[analyze 1 0.02] != 0} { test NormUnbalance 1e-8 50; analyze 1 0.02; test NormUnbalance 1e-8 1 }
            puts \"[nodeDisp 2 1] [nodeDisp 3 1]\"
        }";
    let compat = Script::compat().run(model).numbers();
    let expected = [
        [0.007747364630015242, 0.007747364630015242],
        [0.04535217826871751, 0.009430633346724324],
        [0.13795028660921815, 0.10202874168722496],
        [0.3013410770492956, 0.2654195321273024],
    ];
    check(&compat, expected.as_flattened());
    let own = Script::default().run(model).numbers();
    assert!(own.chunks(2).all(|row| row[0] == row[1]), "{own:?}");
}
