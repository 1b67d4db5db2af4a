//! State variables that exist under `--compat opensees` only.

use crate::script::Script;
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
