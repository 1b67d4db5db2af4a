//! State variables that exist under `--compat opensees` only.

use crate::close;
use crate::script::{Script, run};
use hysteron::analysis::Quiet;

/// Two Kikuchi bearings side by side under an axial load; the second one is stiffer, so that the order of them matters.
const BEARINGS: &str = "model BasicBuilder -ndm 3 -ndf 6
    node 1 0 0 0; node 2 0 0 0.4; node 3 2 0 0; node 4 2 0 0.4
    fix 1 1 1 1 1 1 1; fix 3 1 1 1 1 1 1; fix 2 0 0 0 1 1 1; fix 4 0 0 0 1 1 1
    uniaxialMaterial KikuchiAikenLRB 1 1 0.5027 0.16 0.40e6 0.0201 8.33e6 0.588e6 13.0
    uniaxialMaterial AxialSp 2 1.3e9 2.0e6 -100.0e6 1.0 0.1 0.5 0.0
    uniaxialMaterial Elastic 3 4e6
    element KikuchiBearing 1 1 2 -shape round -size 0.8 0.16 -totalHeight 0.4 -nMSS 8 -matMSS 1 -limDisp 0.05 -nMNS 10 -matMNS 2 -orient 0 0 1 0 1 0
    element KikuchiBearing 2 3 4 -shape round -size 0.8 0.16 -totalHeight 0.4 -nMSS 8 -matMSS 3 -limDisp 0.05 -nMNS 10 -matMNS 2 -orient 0 0 1 0 1 0
    timeSeries Linear 1
    pattern Plain 1 1 { load 2 0 0 -4e6 0 0 0; load 4 0 0 -2e6 0 0 0 }
    constraints Transformation; numberer RCM; system FullGeneral; test FixedNumIter 6; algorithm Newton
    integrator LoadControl 0.1; analysis Static
    analyze 10
    loadConst -time 0.0
    pattern Plain 2 1 { load 2 2e4 1e4 0 0 0 0; load 4 5e4 0 0 0 0 0 }
    integrator LoadControl 0.2";

/// A checkpoint holds what Kikuchi bearings share: the same steps from it have the same bits.
#[test]
fn checkpoint_holds_what_bearings_share() {
    let mut ran = Script::compat().run(BEARINGS).done();
    let engine = &mut ran.interp.host.engine;
    engine.analyze(3, 0.0, &mut Quiet).unwrap();
    let kept = engine.checkpoint();
    assert!(kept.shared.iter().any(|x| *x != 0.0));
    engine.analyze(4, 0.0, &mut Quiet).unwrap();
    let end = engine.state().clone();
    engine.restore(&kept);
    assert_eq!(*engine.state(), kept);
    engine.analyze(4, 0.0, &mut Quiet).unwrap();
    assert_eq!(*engine.state(), end);

    // The second bearing leaves what the first one takes its geometry from.
    engine.restore(&kept);
    engine.change_state(|s, _| s.shared.fill(0.0));
    engine.analyze(4, 0.0, &mut Quiet).unwrap();
    assert_ne!(engine.state().disp, end.disp);
}

/// A bar beside a mass point that nothing holds: the point stands still if nothing pushes it.
#[test]
fn an_unloaded_mechanism_stands_still() {
    let bars = |push: &str, script: Script| {
        script.run(&format!(
            "model basic -ndm 2 -ndf 2
            node 1 0 0; node 2 1 0; node 3 2 0.5; fix 1 1 1
            uniaxialMaterial Elastic 1 50.
            element truss 1 1 2 2. 1
            fix 2 0 1
            timeSeries Linear 1
            pattern Plain 1 1 {{ load 2 3. 0.; load 3 {push} 0. }}
            constraints Plain; numberer Plain; system BandGeneral; test NormUnbalance 1e-8 5; algorithm Newton
            integrator LoadControl 1.; analysis Static
            puts [analyze 1]; puts [nodeDisp 2 1]; puts [nodeDisp 3]"
        ))
    };
    let ran = bars("0.", Script::compat()).done();
    assert_eq!(ran.numbers(), [0.0, 0.03, 0.0, 0.0]);
    assert!(ran.warnings().iter().any(|w| w.message.contains("node 3")), "{:?}", ran.warnings());
    assert_eq!(bars("1.", Script::compat()).numbers()[0], -3.0);
    assert_eq!(bars("0.", Script::default()).numbers()[0], -3.0);
}

/// A square whose corners go round the other way, beside an area of 100: the axial stiffness of openseespy 3.7.1.
#[test]
fn fibers_of_negative_area() {
    let stretch = |script: Script| {
        script.run(
            "model basic -ndm 2 -ndf 3
            node 1 0 0; node 2 0 0; fix 1 1 1 1; fix 2 0 1 1
            uniaxialMaterial Elastic 1 1.
            section Fiber 1 { fiber 0. 0. 100. 1; patch quad 1 2 2 0. 0. 0. 2. 3. 2. 3. 0. }
            element zeroLengthSection 1 1 2 1
            timeSeries Linear 1; pattern Plain 1 1 { load 2 1. 0. 0. }
            integrator LoadControl 1.; analysis Static; analyze 1; puts [nodeDisp 2 1]",
        )
    };
    let [stretched] = stretch(Script::compat()).done().numbers()[..] else { panic!("one number") };
    assert!((1.0 / stretched - 94.0).abs() < 1e-9, "{stretched}");
    assert!(stretch(Script::default()).error().message.contains("area"));
}

/// Masses of elements count in damping by modes, and shapes by LAPACK are scaled by row sums of a consistent mass: displacements of
/// openseespy 3.7.1.
#[test]
fn modal_damping_of_the_masses_of_elements() {
    let shaken = |script: Script, option: &str| {
        let ran = script.run(&format!(
            "model basic -ndm 2 -ndf 3
            node 1 0 0; node 2 0 3; node 3 0 6; fix 1 1 1 1; geomTransf Linear 1
            foreach i {{1 2}} {{
                element elasticBeamColumn $i $i [expr {{$i + 1}}] 0.08 2e8 1e-3 1 -mass 3. {option}
                mass [expr {{$i + 1}}] 10. 10. 0.1
            }}
            timeSeries Trig 1 0. 10. 0.5; pattern Plain 1 1 {{ load 3 50. 0. 0. }}
            constraints Plain; numberer Plain; system FullGeneral; test NormDispIncr 1e-10 30; algorithm Newton
            integrator Newmark 0.5 0.25; analysis Transient
            eigen -fullGenLapack 2; modalDamping 0.05 0.1
            analyze 60 0.02; puts [nodeDisp 3 1]"
        ));
        ran.done().numbers()[0]
    };
    let (lumped, consistent) = (0.0893236918829225, 0.09790465118113276);
    assert!(close(shaken(Script::compat(), ""), lumped, 1e-9));
    assert!(close(shaken(Script::default(), ""), lumped, 1e-9));
    assert!(close(shaken(Script::compat(), "-cMass"), consistent, 1e-9));
    assert!(!close(shaken(Script::default(), "-cMass"), consistent, 1e-3));
}

/// y, z and area of a fiber, as openseespy 3.7.1 gives them.
#[test]
fn fibers_in_the_plane_lie_at_z_0() {
    let asked = |script: Script| {
        let ran = script.run(
            "model basic -ndm 2 -ndf 3
            node 1 0 0; node 2 0 0; fix 1 1 1 1
            uniaxialMaterial Elastic 1 1.
            section Fiber 1 { fiber 0.1 0.3 2. 1; fiber -0.1 -0.3 2. 1 }
            element zeroLengthSection 1 1 2 1
            puts [eleResponse 1 section fiberData]",
        );
        ran.done().numbers()[..3].to_vec()
    };
    assert_eq!(asked(Script::compat()), [0.1, 0.0, 2.0]);
    assert_eq!(asked(Script::default()), [0.1, 0.3, 2.0]);
}

#[test]
fn deformations_of_an_elastic_beam_in_the_plane() {
    let asked = |script: Script| {
        script.run(
            "model basic -ndm 2 -ndf 3
            node 1 0 0; node 2 1 0; fix 1 1 1 1; geomTransf Linear 1
            element elasticBeamColumn 1 1 2 1. 1. 1. 1
            puts [llength [eleResponse 1 basicDeformation]]; catch {eleResponse 1 deformations} all; puts [llength $all]",
        )
    };
    assert_ne!(asked(Script::compat()).done().numbers(), [3.0, 3.0]);
    assert_eq!(asked(Script::default()).done().numbers(), [3.0, 3.0]);
}

/// `nodeReaction` before and after `reactions`, and one step further; the first two numbers are those of openseespy 3.7.1.
#[test]
fn reactions_are_those_of_the_command() {
    let push = |script: Script| {
        let ran = script.run(
            "model basic -ndm 1 -ndf 1
            node 1 0; node 2 0; fix 1 1
            uniaxialMaterial Elastic 1 2.
            element zeroLength 1 1 2 -mat 1 -dir 1
            timeSeries Linear 1; pattern Plain 1 1 { load 2 1. }
            integrator LoadControl 1.; analysis Static
            analyze 1; puts [nodeReaction 1 1]
            reactions; analyze 1; puts [nodeReaction 1 1]",
        );
        ran.done().numbers()
    };
    assert_eq!(push(Script::compat()), [0.0, -1.0]);
    assert_eq!(push(Script::default()), [-1.0, -2.0]);
}

/// A load that is there at once when the reference load is formed; numbers of openseespy 3.7.1.
#[test]
fn reference_load_of_a_state_out_of_balance() {
    let push = |script: Script| {
        script.run(
            "model basic -ndm 1 -ndf 1
            node 1 0; node 2 0; node 3 0; fix 1 1
            uniaxialMaterial Steel02 1 2. 200. 0.02 15 0.925 0.15
            element zeroLength 1 1 2 -mat 1 -dir 1; element zeroLength 2 2 3 -mat 1 -dir 1
            timeSeries Linear 1; pattern Plain 1 1 { load 3 1. }
            constraints Plain; numberer Plain; system FullGeneral; test EnergyIncr 1e-4 20; algorithm Newton
            integrator LoadControl 1.; analysis Static; analyze 1
            pattern Plain 2 1 { load 2 0.7 }
            integrator DisplacementControl 3 1 0.005
            for {set i 0} {$i < 3} {incr i} { analyze 1; puts [getTime] }",
        )
    };
    let expected = [1.1420111645984563, 1.241413800462174, 1.2133817625165306];
    let times = push(Script::compat()).numbers();
    assert!(times.iter().zip(expected).all(|(t, e)| (t - e).abs() < 1e-12), "{times:?}");
    assert!((push(Script::default()).numbers()[0] - expected[0]).abs() > 0.01);
}

/// Under Transformation OpenSees controls the retained node of a rigid link, as openseespy 3.7.1 does.
#[test]
fn control_of_a_constrained_node() {
    let push = |script: Script| {
        script
            .run(
                "model basic -ndm 2 -ndf 3
                node 1 0 0; node 2 0 3; node 3 2 4; fix 1 1 1 1
                geomTransf Linear 1
                element elasticBeamColumn 1 1 2 1. 1000. 0.2 1
                rigidLink beam 2 3
                timeSeries Linear 1
                pattern Plain 1 1 { load 3 1. -2. 0. }
                constraints Transformation; numberer RCM; system BandGeneral; test NormDispIncr 1e-10 5; algorithm Newton
                integrator DisplacementControl 3 1 0.01; analysis Static
                analyze 1
                puts [nodeDisp 2 1]; puts [nodeDisp 3 1]",
            )
            .done()
            .numbers()
    };
    let (compat, own) = (push(Script::compat()), push(Script::default()));
    assert!((compat[0] - 0.01).abs() < 1e-12 && (own[1] - 0.01).abs() < 1e-12, "{compat:?} {own:?}");
}

/// A step that fails leaves the reference load of `DisplacementControl` as it was: another test goes on from it. The
/// numbers are those of OpenSees (openseespy 3.7.1).
#[test]
fn the_reference_load_outlives_a_failed_step() {
    let script = "model basic -ndm 2 -ndf 3; node 1 0 0; node 2 0 0; fix 1 1 1 1; fix 2 0 1 0
        uniaxialMaterial Concrete01 1 -30. -0.002 -6. -0.006; uniaxialMaterial Steel01 2 400. 2e5 0.01
        section Fiber 1 {
            patch rect 1 10 1 -200 -150 200 150
            layer straight 2 2 1000 -170 -120 -170 120; layer straight 2 2 1000 170 -120 170 120
        }
        element zeroLengthSection 1 1 2 1
        pattern Plain 1 Linear { load 2 -5e5 0 0 }
        constraints Plain; test EnergyIncr 1e-10 200; algorithm Newton; integrator LoadControl 1; analysis Static
        puts [analyze 1]
        loadConst -time 0
        pattern Plain 2 Linear { load 2 0 0 1 }
        integrator DisplacementControl 2 3 4e-6; analysis Static
        test EnergyIncr 1e-30 1; puts [analyze 1]
        test EnergyIncr 1e-10 50; algorithm ModifiedNewton -initial; puts [analyze 1]
        algorithm Newton; puts [analyze 3]
        puts [getTime]; puts [nodeDisp 2 1]";
    let printed = Script::compat().run(script).done().numbers();
    assert_eq!(printed[..4], [0.0, -3.0, 0.0, 0.0]);
    assert!((printed[4] / 347863511.26416975 - 1.0).abs() < 1e-9, "{}", printed[4]);
    assert!((printed[5] / 0.0012491407075384583 - 1.0).abs() < 1e-9, "{}", printed[5]);
}

/// Spellings and slips of scripts that OpenSees takes: each gives the deflection of the usual words.
#[test]
fn old_spellings_and_words_left_over() {
    let deflection = |section: &str, element: &str| {
        let script = format!(
            "model basic -ndm 3 -ndf 6; node 1 0 0 0; node 2 3 0 0; fix 1 1 1 1 1 1 1
            uniaxialMaterial Elastic 1 2e8
            {section}
            geomTransf Linear 1 0 1 0
            {element}
            pattern Plain 1 Linear {{ load 2 0 0 -5 0 0 0 }}
            constraints Plain; integrator LoadControl 1; algorithm Linear; analysis Static
            remove recorder 9
            analyze 1
            puts [nodeDisp 2 3]"
        );
        Script::default().run(&script).done().numbers()[0]
    };
    let fibers = |name: &str| format!("section {name} 1 -GJ 1e4 {{ patch rect 1 4 4 -0.1 -0.1 0.1 0.1 }}");
    let beam = |name: &str| format!("element {name} 1 1 2 5 1 1");
    let usual = deflection(&fibers("Fiber"), &beam("forceBeamColumn"));
    assert!(usual < 0.0);
    assert_eq!(deflection(&fibers("FiberSec"), &beam("ForceFrame")), usual);
    let elastic = |more: &str| format!("element elasticBeamColumn 1 1 2 0.04 2e8 8e7 1e-4 1e-4 1e-4 1 {more}");
    let usual = deflection("", &elastic(""));
    assert!((usual + 5.0 * 27.0 / (3.0 * 2e8 * 1e-4)).abs() < 1e-12);
    assert_eq!(deflection("", &elastic("0")), usual);
}

/// Node 3 is held and follows node 2: in OpenSees the force of its spring goes to node 2.
#[test]
fn a_tie_of_a_held_node_hands_its_forces_on() {
    let model = "model basic -ndm 1 -ndf 1
        node 1 0; node 2 0; node 3 0; node 4 0; fix 1 1; fix 3 1
        uniaxialMaterial Elastic 1 10; uniaxialMaterial Elastic 2 20
        element zeroLength 1 1 2 -mat 1 -dir 1; element zeroLength 2 3 4 -mat 2 -dir 1
        equalDOF 2 3 1
        timeSeries Linear 1; pattern Plain 1 1 { load 4 1 }
        constraints Transformation; numberer Plain; system FullGeneral; test NormDispIncr 1e-12 100; algorithm Newton
        integrator LoadControl 1; analysis Static
        analyze 1; foreach n {2 3 4} { puts [nodeDisp $n 1] }";
    let own = Script::default().run(model).numbers();
    assert!(own[0].abs() < 1e-12 && own[1] == 0.0 && (own[2] - 0.05).abs() < 1e-12, "{own:?}");
    let compat = Script::compat().run(model).numbers();
    assert!((compat[0] - 0.1).abs() < 1e-10 && compat[1] == 0.0 && (compat[2] - 0.05).abs() < 1e-10, "{compat:?}");
}

/// Rigid links one after the other between two springs; numbers of openseespy 3.7.1.
#[test]
fn chains_of_rigid_links_are_not_multiplied() {
    let links = |links: &str, script: Script| {
        let model = format!(
            "model basic -ndm 2 -ndf 3
            node 1 0 0; node 2 1 0; node 3 2 0; node 4 3 0; node 5 3 0; node 6 0 0; fix 1 1 1 1; fix 5 1 1 1
            uniaxialMaterial Elastic 1 10
            {links}
            timeSeries Linear 1
            constraints Transformation; numberer Plain; system FullGeneral; test NormDispIncr 1e-10 50; algorithm Newton
            integrator LoadControl 1; analysis Static
            analyze 1; puts \"[nodeDisp 2 2] [nodeDisp 3 2] [nodeDisp 4 2]\""
        );
        script.run(&model).numbers()
    };
    let rising = "node 0 0 0; element zeroLength 1 1 0 -mat 1 1 1 -dir 1 2 3; element zeroLength 2 5 4 -mat 1 1 1 -dir 1 2 3
        fix 6 1 1 1; rigidLink beam 0 2; rigidLink beam 2 3; rigidLink beam 3 4; pattern Plain 1 Linear { load 4 1 1 0 }";
    let near = |got: &[f64], want: [f64; 3]| got.iter().zip(want).all(|(g, w)| (g - w).abs() < 1e-9);
    let compat = links(rising, Script::compat());
    assert!(near(&compat, [0.06, 0.06, 0.06]), "{compat:?}");
    let own = links(rising, Script::default());
    assert!((own[1] - own[0] - (own[2] - own[1])).abs() < 1e-9 && own[2] > own[1], "{own:?}");
    // The leading node of the second link has the greater tag: OpenSees lets the third stand still.
    let falling =
        "element zeroLength 1 1 6 -mat 1 1 1 -dir 1 2 3; element zeroLength 2 5 4 -mat 1 1 1 -dir 1 2 3; fix 2 1 1 1
        rigidLink beam 6 4; rigidLink beam 4 3; pattern Plain 1 Linear { load 4 1 1 0 }";
    let compat = links(falling, Script::compat());
    assert!(compat[1] == 0.0 && compat[2] > 0.0, "{compat:?}");
}

/// Numbers of openseespy 3.7.1: the end of a beam with joint offsets.
#[test]
fn corotational_offsets_are_ignored_in_space() {
    let beam = |script: Script| {
        script.run(
            "model basic -ndm 3 -ndf 6
            node 1 0 0 0; node 2 3 0 0; fix 1 1 1 1 1 1 1
            geomTransf Corotational 1 0 0 1 -jntOffset 0.1 0 0.2 -0.1 0 0.2
            element elasticBeamColumn 1 1 2 0.01 2e8 8e7 1e-5 2e-5 3e-5 1
            timeSeries Linear 1; pattern Plain 1 1 { load 2 10 5 20 0 0 0 }
            numberer Plain; system FullGeneral; constraints Plain; algorithm Newton; test NormUnbalance 1e-6 20
            integrator LoadControl 1; analysis Static
            analyze 1; puts [nodeDisp 2]",
        )
    };
    let expected = [-0.00032624157243262903, 0.007463073688847467, 0.0446590079643746, -6.952584309524826e-5];
    let compat = beam(Script::compat());
    for (got, want) in compat.numbers().iter().zip(expected) {
        assert!((got - want).abs() < 1e-8, "{got} {want}");
    }
    assert!(compat.warnings().iter().any(|w| w.message.contains("joint offsets")), "{:?}", compat.warnings());
    assert!((beam(Script::default()).numbers()[2] - expected[2]).abs() > 1e-3);
}

/// openseespy 3.7.1 goes on with Newmark's method.
#[test]
fn an_unknown_integrator_changes_nothing() {
    let model = "model basic -ndm 1 -ndf 1
        node 1 0; node 2 0 -mass 1; fix 1 1
        uniaxialMaterial Elastic 1 10; element zeroLength 1 1 2 -mat 1 -dir 1
        timeSeries Constant 1; pattern Plain 1 1 { load 2 1 }
        system FullGeneral; constraints Plain; numberer Plain; algorithm Linear
        integrator Transient Trapezoidal; analysis Transient
        puts \"[analyze 20 0.05] [nodeDisp 2 1]\"";
    let compat = Script::compat().run(model);
    let got = compat.numbers();
    assert!(got[0] == 0.0 && (got[1] - 0.1994799165522176).abs() < 1e-9, "{got:?}");
    assert!(Script::default().run(model).error().message.contains("unknown integrator \"Transient\""));
}

/// openseespy 3.7.1 on a path whose times go back.
#[test]
fn a_path_that_goes_back_counts_to_the_next_later_time() {
    let model = "model basic -ndm 1 -ndf 1
        node 1 0; node 2 0; fix 1 1
        uniaxialMaterial Elastic 1 1; element zeroLength 1 1 2 -mat 1 -dir 1
        timeSeries Path 1 -time {0 1 3 2 2.5 4 3.5 5} -values {0 1 2 5 7 -1 3 4}; pattern Plain 1 1 { load 2 1 }
        integrator LoadControl 0.25; system FullGeneral; constraints Plain; numberer Plain; algorithm Linear
        analysis Static
        for {set i 0} {$i < 21} {incr i} { analyze 1; puts [nodeDisp 2 1] }";
    let ran = Script::default().run(model);
    let expected = [
        0.25,
        0.5,
        0.75,
        1.0,
        1.125,
        1.25,
        1.375,
        1.5,
        1.625,
        1.75,
        1.875,
        2.0,
        3.0,
        5.0 / 3.0,
        1.0 / 3.0,
        -1.0,
        3.5,
        11.0 / 3.0,
        23.0 / 6.0,
        4.0,
        0.0,
    ];
    for (got, want) in ran.numbers().iter().zip(expected) {
        assert!((got - want).abs() < 1e-12, "{:?}", ran.numbers());
    }
    assert!(ran.warnings().iter().any(|w| w.message.contains("the times go back")));
    let mut strict = Script::default();
    strict.strict = true;
    assert!(strict.run(model).error().message.contains("the times go back"));
}

/// Elements that depend on the number of calls are called once in each step of a response spectrum.
#[test]
fn a_response_spectrum_moves_force_based_beams() {
    let force = |beam: &str| {
        let model = format!(
            "model basic -ndm 2 -ndf 3
            node 1 0 0; node 2 0 3 -mass 2 2 0; fix 1 1 1 1
            geomTransf Linear 1; section Elastic 1 2e8 0.01 1e-4
            {beam}
            eigen 2; timeSeries Path 1 -time {{0 1 10}} -values {{2 3 1}}
            responseSpectrumAnalysis 1 1 -mode 1
            puts [eleForce 1]"
        );
        Script::compat().run(&model).numbers()
    };
    let expected = force("element elasticBeamColumn 1 1 2 0.01 2e8 1e-4 1");
    let got = force("element forceBeamColumn 1 1 2 5 1 1");
    assert!(expected[0].abs() > 1.0, "{expected:?}");
    for (g, e) in got.iter().zip(&expected) {
        assert!((g.abs() - e.abs()).abs() < 1e-9 * expected[2].abs(), "{got:?} {expected:?}");
    }
}

/// All constraints of `EQPath` walk along the path that control of the displacement finds.
#[test]
fn constraints_of_equilibrium_paths() {
    let walk = |integrator: &str| {
        let model = format!(
            "model basic -ndm 2 -ndf 2
            node 1 0 0; node 2 10 1; node 3 20 0; fix 1 1 1; fix 3 1 1
            uniaxialMaterial Elastic 1 1000; element corotTruss 1 1 2 1 1; element corotTruss 2 2 3 1.1 1
            timeSeries Linear 1; pattern Plain 1 1 {{ load 2 0 -1 }}
            numberer Plain; system FullGeneral; constraints Plain; algorithm Newton; test NormUnbalance 1e-10 50
            integrator {integrator}; analysis Static
            analyze 14; puts \"[getTime] [nodeDisp 2 1] [nodeDisp 2 2]\""
        );
        Script::default().run(&model).numbers()
    };
    for constraint in 1..=7 {
        let point = walk(&format!("EQPath 0.1 {constraint}"));
        let on_path = walk(&format!("DisplacementControl 2 2 {}", point[2] / 14.0));
        assert!((point[2] + 1.4).abs() < 1e-3, "{constraint}: {point:?}");
        for (x, y) in point.iter().zip(&on_path) {
            assert!((x - y).abs() < 1e-9, "{constraint}: {point:?} {on_path:?}");
        }
    }
    assert!(Script::default().run("integrator EQPath 1 9").error().message.contains("there is no constraint 9"));
}

/// Commands that OpenSees accepts and its manual does not: a test without iterations, concrete with a negative tensile strength.
#[test]
fn tolerances_are_warnings() {
    let model = "model basic -ndm 1 -ndf 1
        node 1 0; node 2 0; fix 1 1
        uniaxialMaterial Concrete02 1 -30 -0.002 -6 -0.01 0.1 -3 1500; element zeroLength 1 1 2 -mat 1 -dir 1
        timeSeries Linear 1; pattern Plain 1 1 { sp 2 1 1 }
        integrator LoadControl 0.001; system FullGeneral; constraints Transformation; numberer Plain
        test NormUnbalance 1e-6; algorithm Newton; analysis Static
        analyze 1; puts [lindex [eleResponse 1 force] 0]";
    let ran = Script::default().run(model);
    assert_eq!(ran.numbers(), [0.0]);
    for message in ["tensile strength ft is -3", "is taken for 25"] {
        assert!(ran.warnings().iter().any(|w| w.message.contains(message)), "{:?}", ran.warnings());
    }
}

/// A deflection of a beam that a spring along its axis takes part in; numbers of openseespy 3.7.1.
#[test]
fn degrees_of_freedom_of_other_directions_are_tied() {
    let numbers = run("model basic -ndm 2 -ndf 3; node 1 0 0; node 2 1 0; node 3 1 0; node 4 2 0
        fix 1 1 1 1; fix 3 0 1 1; fix 4 1 1 1; geomTransf Linear 1; element elasticBeamColumn 1 1 2 1. 100. 1. 1
        uniaxialMaterial Elastic 1 50.; element zeroLength 2 3 4 -mat 1 -dir 1; equalDOF_Mixed 2 3 1 2 1
        timeSeries Linear 1; pattern Plain 1 1 { load 2 0. 3. 0. }
        constraints Transformation; numberer Plain; system FullGeneral; algorithm Linear; integrator LoadControl 1.0
        analysis Static; analyze 1; puts \"[nodeDisp 2 2] [nodeDisp 2 3] [nodeDisp 3 1]\"")
    .numbers();
    for (got, expected) in numbers.iter().zip([0.008571428571428572, 0.012857142857142859, 0.008571428571428572]) {
        assert!((got - expected).abs() < 1e-15, "{numbers:?}");
    }
}

/// Lengths and stresses in kips and inches.
#[test]
fn units_are_variables() {
    let numbers =
        run("defaultUnits -force kip -length in -time sec; puts \"$ft [expr {$ksi*$in*$in/$kip}] [expr {4*$m/$in}]\"")
            .numbers();
    for (got, expected) in numbers.iter().zip([12.0, 1.0, 4.0 / 0.0254]) {
        assert!((got - expected).abs() < 1e-12 * expected, "{numbers:?}");
    }
}
