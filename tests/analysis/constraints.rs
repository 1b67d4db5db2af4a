//! Constraints, by every handler.

use super::close;
use super::script::{Script, run};

const HANDLERS: [(&str, f64); 4] =
    [("Plain", 1e-9), ("Transformation", 1e-9), ("Penalty 1e12 1e12", 1e-5), ("Lagrange", 1e-9)];

/// A storey with a rigid floor, an eccentric push, and a support that settles.
fn storey(handler: &str, system: &str) -> Vec<f64> {
    run(&format!(
        "model basic -ndm 3 -ndf 6
        set n 0
        foreach {{x y}} {{0 0 6 0 6 4 0 4}} {{
            incr n
            node $n $x $y 0; node 1$n $x $y 3
            fix $n 1 1 [expr {{$n != 2}}] 1 1 1
        }}
        node 20 2.5 1.5 3
        fix 20 0 0 1 1 1 0
        rigidDiaphragm 3 20 11 12 13 14
        geomTransf Linear 1 1 0 0; geomTransf Linear 2 0 0 1
        foreach c {{1 2 3 4}} {{ element elasticBeamColumn $c $c 1$c 0.1 3e7 1.2e7 0.002 0.001 0.0015 1 }}
        foreach {{e i j}} {{5 11 12 6 12 13 7 13 14 8 14 11}} {{ element elasticBeamColumn $e $i $j 0.08 3e7 1.2e7 0.002 0.001 0.0015 2 }}
        timeSeries Linear 1
        pattern Plain 1 1 {{ load 20 30 10 0 0 0 5; load 13 0 0 -50 0 0 0; sp 2 3 -0.01 }}
        system {system}; numberer RCM; constraints {handler}; test NormDispIncr 1e-10 20; algorithm Newton
        integrator LoadControl 0.5; analysis Static
        analyze 2
        puts [nodeDisp 20]; puts [nodeDisp 13]; puts [nodeReaction 2]"
    ))
    .numbers()
}

#[test]
fn handlers_agree() {
    let reference = storey("Transformation", "BandGeneral");
    assert!(close(reference[14], reference[14], 0.0));
    for (handler, tolerance) in HANDLERS {
        for (a, b) in storey(handler, "UmfPack").iter().zip(&reference) {
            assert!((a - b).abs() <= tolerance * b.abs().max(1e-3), "{handler}: {a} and {b}");
        }
    }
}

/// OpenSees' Plain handler holds imposed motions at zero without a word; with `--compat opensees` so do we.
#[test]
fn plain_holds_imposed_motions_only_when_told_to() {
    let text = "model basic -ndm 1 -ndf 1
        node 1 0; node 2 0; node 3 0; fix 1 1
        uniaxialMaterial Elastic 1 100.0
        element zeroLength 1 1 2 -mat 1 -dir 1; element zeroLength 2 2 3 -mat 1 -dir 1
        timeSeries Linear 1
        pattern Plain 1 1 { sp 3 1 0.1 }
        constraints Plain; numberer Plain; system BandGeneral; test NormUnbalance 1e-9 20; algorithm Newton
        integrator LoadControl 1.0; analysis Static
        analyze 1
        puts [nodeDisp 2 1]";
    assert!(close(run(text).numbers()[0], 0.05, 1e-9));
    assert_eq!(Script::compat().run(text).done().numbers(), [0.0]);
}

/// Chains of constraints: a node follows one that follows another; in any order of making.
#[test]
fn chains_are_followed_to_their_end() {
    let with = |links: &str, handler: &str| {
        run(&format!(
            "model basic -ndm 2 -ndf 3
            node 1 0 0; node 2 2 0; node 3 2 1; node 4 3 1; node 5 5 1
            fix 1 1 1 1
            geomTransf Linear 1
            element elasticBeamColumn 1 1 2 0.02 2e8 1e-4 1
            element elasticBeamColumn 2 4 5 0.02 2e8 1e-4 1
            {links}
            timeSeries Linear 1
            pattern Plain 1 1 {{ load 5 2.0 -3.0 1.0 }}
            system SparseGeneral; numberer RCM; constraints {handler}; test NormDispIncr 1e-10 20; algorithm Newton
            integrator LoadControl 1.0; analysis Static
            analyze 1
            puts [nodeDisp 5]; puts [nodeDisp 4]"
        ))
        .numbers()
    };
    let direct = with("rigidLink beam 2 4; rigidLink beam 2 3", "Transformation");
    for links in ["rigidLink beam 2 3; rigidLink beam 3 4", "rigidLink beam 3 4; rigidLink beam 2 3"] {
        for (handler, tolerance) in HANDLERS {
            for (a, b) in with(links, handler).iter().zip(&direct) {
                assert!((a - b).abs() <= 10.0 * tolerance * b.abs().max(1e-4), "{links}, {handler}: {a} and {b}");
            }
        }
    }
}

#[test]
fn contradictions_are_reported() {
    let base = "model basic -ndm 1 -ndf 1
        node 1 0; node 2 0; node 3 0
        uniaxialMaterial Elastic 1 1.0
        element zeroLength 1 1 2 -mat 1 -dir 1
        constraints Transformation; numberer Plain; system BandGeneral; test NormUnbalance 1e-9 20; algorithm Newton
        integrator LoadControl 1.0; analysis Static\n";
    for (links, message) in [
        ("equalDOF 1 2 1; equalDOF 2 1 1", "lead in a circle"),
        ("equalDOF 1 3 1; equalDOF 2 3 1", "follows two nodes"),
    ] {
        let ran = Script::default().run(&format!("{base}{links}\nputs [analyze 1]"));
        assert!(ran.numbers()[0] < 0.0);
        assert!(ran.warnings().iter().any(|w| w.message.contains(message)), "{:?}", ran.warnings());
    }
}

/// A node that is held and constrained: the support wins.
#[test]
fn a_support_wins_over_a_constraint() {
    let ran = run("model basic -ndm 2 -ndf 3
        node 1 0 0; node 2 0 3; node 3 4 3
        fix 1 1 1 1
        geomTransf Linear 1
        element elasticBeamColumn 1 1 2 0.02 2e8 1e-4 1
        element elasticBeamColumn 2 2 3 0.02 2e8 1e-4 1
        fix 3 0 1 0
        equalDOF 2 3 1
        timeSeries Linear 1
        pattern Plain 1 1 { load 2 10 0 0 }
        system BandGeneral; numberer RCM; constraints Transformation; test NormUnbalance 1e-9 5; algorithm Newton
        integrator LoadControl 1.0; analysis Static
        analyze 1
        puts [nodeDisp 2 1]; puts [nodeDisp 3]");
    let u = ran.numbers();
    assert!(close(u[0], u[1], 1e-12) && u[2] == 0.0 && u[3] != 0.0);
}

/// `rigidDiaphragm` in the plane, with the displacements of openseespy 3.7.1: 1 and 2 make that displacement equal, 3 makes the
/// nodes a rigid body.
#[test]
fn a_diaphragm_in_the_plane() {
    for (direction, expected) in [
        (1, [1.7845e-3, 7.5000e-7, -8.1724e-4, 1.7845e-3, 1.5603e-3, -6.6896e-4]),
        (2, [4.0500e-3, 7.4959e-7, -1.9500e-3, 8.5583e-7, 7.4959e-7, -3.2107e-7]),
        (3, [1.5750e-4, 1.5134e-6, 9.6907e-5, 6.0593e-5, 4.9967e-5, 9.6907e-5]),
    ] {
        let script = format!(
            "model basic -ndm 2 -ndf 3; node 1 0 0; node 2 4 0; node 3 0 3; node 4 0.5 4; fix 1 1 1 1; fix 2 1 1 1
            geomTransf Linear 1; element elasticBeamColumn 1 1 3 0.1 2e8 1e-4 1
            element elasticBeamColumn 2 2 4 0.1 2e8 4e-4 1
            rigidDiaphragm {direction} 3 4
            timeSeries Linear 1; pattern Plain 1 1 {{ load 3 10 5 2 }}
            constraints Transformation; numberer RCM; system FullGeneral; algorithm Linear
            integrator LoadControl 1; analysis Static; analyze 1; puts \"[nodeDisp 3] [nodeDisp 4]\""
        );
        for numbers in [run(&script).numbers(), Script::compat().run(&script).done().numbers()] {
            let near = numbers.iter().zip(expected).all(|(a, b)| close(*a, b, 1e-4));
            assert!(near, "{direction}: {numbers:?}, expected {expected:?}");
        }
    }
}

/// A floor may be given with its retained node among the others: the diaphragm is the same.
#[test]
fn a_retained_node_among_those_that_follow_changes_nothing() {
    let floor = |nodes: &str| {
        let script = format!(
            "model basic -ndm 3 -ndf 6
            foreach {{i x y}} {{1 0 0 2 4 0 3 4 4 4 0 4}} {{
                node $i $x $y 0; fix $i 1 1 1 1 1 1; node [expr {{$i+10}}] $x $y 3
            }}
            geomTransf Linear 1 1 0 0
            foreach i {{1 2 3 4}} {{ element elasticBeamColumn $i $i [expr {{$i+10}}] 0.1 2e8 8e7 1e-4 1e-4 1e-4 1 }}
            rigidDiaphragm 3 11 {nodes}
            timeSeries Linear 1; pattern Plain 1 1 {{ load 11 10 5 0 0 0 0 }}
            constraints Transformation; numberer RCM; system FullGeneral; algorithm Linear
            integrator LoadControl 1; analysis Static; analyze 1; puts \"[nodeDisp 11] [nodeDisp 13]\""
        );
        run(&script).numbers()
    };
    let expected = floor("12 13 14");
    assert!(expected[6] != 0.0 && floor("11 12 13 14") == expected);
}
