//! Materials through their commands: tests of one material, recorders, refusals.

use super::script::{Ran, Script, run};

#[test]
fn material_is_tested_by_itself() {
    let ran = run("uniaxialMaterial Hardening 1 200.0 2.0 0.0 20.0
        uniaxialMaterial Elastic 2 50.0 3.0
        testUniaxialMaterial 1
        setStrain 0.005; puts \"[getStrain] [getStress] [getTangent]\"
        setStrain 0.032
        testUniaxialMaterial 2
        setStrain 0.1 2.0; puts \"[getStress] [getTangent] [getDampTangent]\"
        testUniaxialMaterial 1
        puts [getStress]");
    let expected = [0.005, 1.0, 200.0, 11.0, 50.0, 3.0, 2.4];
    for (a, b) in ran.numbers().into_iter().zip(expected) {
        assert!((a - b).abs() < 1e-9, "{a} for {b}");
    }
}

#[test]
fn parts_of_a_material_answer_recorders() {
    let ran = run("model basic -ndm 1 -ndf 1; node 1 0; node 2 0; fix 1 1
        uniaxialMaterial Elastic 1 100.0
        uniaxialMaterial Elastic 2 300.0
        uniaxialMaterial Series 3 1 2
        uniaxialMaterial Parallel 4 3 1 -factors 2.0 0.5
        uniaxialMaterial InitStrain 5 1 0.02
        element zeroLength 1 1 2 -mat 4 5 -dir 1 1
        timeSeries Linear 1
        pattern Plain 1 1 { load 2 25.5 }
        constraints Plain; numberer Plain; system BandGeneral; test NormUnbalance 1e-9 20; algorithm Newton
        integrator LoadControl 1.0; analysis Static; analyze 1
        puts [nodeDisp 2 1]
        puts [eleResponse 1 material 1 stresses]
        puts [eleResponse 1 material 1 material 1 strains]
        puts [eleResponse 1 material 1 component 1 component 2 stressStrain]
        puts [eleResponse 1 material 2 stressStrain]");
    // Parallel: 2 x 75 + 0.5 x 100; with the other spring 300, which has a force of 2 already.
    let u = 23.5 / 300.0;
    let expected = [u, 75.0 * u, 100.0 * u, 0.75 * u, 0.25 * u, 75.0 * u, 0.25 * u, 100.0 * u + 2.0, u + 0.02];
    let got = ran.numbers();
    assert_eq!(got.len(), expected.len(), "{got:?}");
    for (a, b) in got.into_iter().zip(expected) {
        assert!((a - b).abs() < 1e-9, "{a} for {b}");
    }
}

/// A wrapper shows the strain with the initial one, and passes parameters on.
#[test]
fn materials_around_others_show_and_change_them() {
    for around in [
        "Fatigue 6 5 -E0 0.2",
        "MinMax 6 5 -max 1.",
        "Mullins 6 5 0. 0.1",
        "InitStrain 6 5 0.",
        "Fatigue 7 5 -E0 0.2; uniaxialMaterial MinMax 6 7 -max 1.",
    ] {
        let ran = run(&format!(
            "model basic -ndm 1 -ndf 1; node 1 0; node 2 0; fix 1 1
            uniaxialMaterial Elastic 1 100.; uniaxialMaterial InitStrain 5 1 0.02; uniaxialMaterial {around}
            element zeroLength 1 1 2 -mat 6 -dir 1; parameter 1 element 1 material 1 E
            timeSeries Constant 1; pattern Plain 1 1 {{ load 2 3. }}
            constraints Plain; numberer Plain; system FullGeneral; test NormUnbalance 1e-9 20; algorithm Newton
            integrator LoadControl 1.; analysis Static; analyze 1
            puts \"[nodeDisp 2 1] [eleResponse 1 material 1 strain]\"
            updateParameter 1 300.; analyze 1
            puts \"[nodeDisp 2 1] [eleResponse 1 material 1 strain]\""
        ));
        assert!(ran.warnings().is_empty(), "{around}: {:?}", ran.warnings());
        let n = ran.numbers();
        for (a, b) in n.iter().zip([0.01, 0.03, -0.01, 0.01]) {
            assert!((a - b).abs() < 1e-9, "{around}: {n:?}");
        }
    }
    // A bar with a section.
    let ran = run("model basic -ndm 1 -ndf 1; node 1 0; node 2 2; fix 1 1
        section Elastic 1 100. 2. 1.; element trussSection 1 1 2 1; parameter 1 element 1 E
        timeSeries Constant 1; pattern Plain 1 1 { load 2 3. }
        constraints Plain; numberer Plain; system FullGeneral; test NormUnbalance 1e-9 20; algorithm Newton
        integrator LoadControl 1.; analysis Static; updateParameter 1 300.; analyze 1; puts [nodeDisp 2 1]");
    assert!(ran.warnings().is_empty() && (ran.numbers()[0] - 0.01).abs() < 1e-12, "{} {:?}", ran.out, ran.warnings());
}

#[test]
fn materials_that_make_no_sense_are_refused() {
    for (command, words) in [
        ("Steel02 2 400. 2e5 0.01 20. 0.9 0.15 0.1 0.0 0.1 1.0", "isotropic hardening starts at 0"),
        ("Hysteretic 2 1. .1 2. .05 -1. -.1 -2. -.2 1 1 0 0", "strain 2 in tension is 0.05"),
        ("Hysteretic 2 1. .1 2. .2 1. -.1 -2. -.2 1 1 0 0", "stress 1 in compression is 1"),
        ("ElasticMultiLinear 2 -strain 0 1 0.5 -stress 0 1 2", "make no curve"),
        ("MultiLinear 2 0.1 1.0 0.1 2.0", "do not rise"),
        ("Parallel 2 1 1 -factors 1.0", "1 factors for 2 materials"),
        ("Series 2 1 7", "there is no uniaxial material 7"),
        ("MinMax 2 1 -min 0.1 -max 0.0", "no strain lies between"),
        ("InitStressMaterial 2 1 50.0", "no strain with a stress of 50"),
        ("SelfCentering 2 100. 10. 2. 1.5", "beta is 1.5"),
        ("ViscousDamper 2 100. 10. 0.5 0. 4 1e-6 1e-10 15", "there is no method 4"),
        ("Maxwell 2 100. 10. 0.5 0.0", "length L is 0"),
        ("ElasticPPGap 2 0. 0. 0.1", "E and Fy are both 0"),
        ("Hardening 2 100. 2. -100. 0.", "E + Hiso + Hkin is 0"),
    ] {
        let text = format!("uniaxialMaterial ElasticPP 1 100.0 0.1\nuniaxialMaterial {command}");
        let ran = Script::default().run(&text);
        assert!(ran.error().message.contains(words), "{command}: {}", ran.error().message);
    }
    assert!(Script::default().run("setStrain 0.1").error().message.contains("no material is being tested"));
}

/// A series given in place is the one that has a tag.
#[test]
fn series_in_place() {
    let model = |series: &str| {
        let text = format!(
            "model basic -ndm 1 -ndf 1; node 1 0; node 2 0; fix 1 1; mass 2 1.0
            uniaxialMaterial Elastic 1 100.0
            element zeroLength 1 1 2 -mat 1 -dir 1
            {series}
            constraints Plain; numberer Plain; system BandGeneral; test NormUnbalance 1e-9 20; algorithm Newton
            integrator Newmark 0.5 0.25; analysis Transient; analyze 30 0.02
            puts [nodeDisp 2 1]"
        );
        run(&text).numbers()
    };
    for (kind, tagged, inline) in [
        ("Linear", "Linear 1", "Linear"),
        ("Linear", "Linear 1 -factor 3.0", "{Linear -factor 3.0}"),
        ("Constant", "Constant 1 -factor 2.0", "\"Constant -factor 2.0\""),
        ("Sine", "Trig 1 0.1 0.5 0.3 -factor 2.0 -shift 0.2", "{Sine 0.1 0.5 0.3 -factor 2.0 -shift 0.2}"),
        ("Triangle", "Triangle 1 0.1 0.5 0.3 -zeroShift 0.2", "{Triangle 0.1 0.5 0.3 -zeroShift 0.2}"),
        ("Rectangular", "Rectangular 1 0.1 0.3", "{Rectangular 0.1 0.3}"),
        ("Pulse", "Pulse 1 0.1 0.5 0.2 -width 0.3", "{Pulse 0.1 0.5 0.2 -width 0.3}"),
        ("Path", "Path 1 -dt 0.1 -values {1 2 1}", "{Series -dt 0.1 -values {1 2 1}}"),
        ("Path, times", "Path 1 -time {0 .2 .7} -values {1 2 1}", "{Series -time {0 .2 .7} -values {1 2 1}}"),
    ] {
        let a = model(&format!("timeSeries {tagged}; pattern Plain 1 1 {{ load 2 1.0 }}"));
        let b = model(&format!("pattern Plain 1 {inline} {{ load 2 1.0 }}"));
        assert!(a == b && a[0] != 0.0, "{kind}: {a:?} and {b:?}");
        let a = model(&format!("timeSeries {tagged}; pattern UniformExcitation 1 1 -accel 1"));
        let b = model(&format!("pattern UniformExcitation 1 1 -accel {inline}"));
        assert!(a == b && a[0] != 0.0, "{kind}, excitation: {a:?} and {b:?}");
    }
}

/// A steel that hardens as much as it is stiff never yields, with an initial stress too.
#[test]
fn steel_of_hardening_ratio_1_is_elastic() {
    let ran = run("model basic -ndm 1 -ndf 1
        node 1 0; node 2 1; fix 1 1
        uniaxialMaterial Steel02 1 100. 2000. 1.0 20 .925 .15 0.1 1 0.1 1 30.
        element truss 1 1 2 1. 1
        timeSeries Path 1 -dt 1 -values {0 1 -1 0.5 0}
        pattern Plain 1 1 { sp 2 1 0.2 }
        constraints Transformation; numberer Plain; system BandGeneral; test NormUnbalance 1e-9 5; algorithm Newton
        integrator LoadControl 0.25; analysis Static
        for {set i 0} {$i < 16} {incr i} { analyze 1; puts [expr [eleResponse 1 axialForce] - 2000.*[nodeDisp 2 1]] }");
    assert!(ran.warnings().iter().any(|w| w.message.contains("the hardening ratio is 1")), "{:?}", ran.warnings());
    let n = ran.numbers();
    assert!(n.len() == 16 && n.iter().all(|n| (n - 30.0).abs() < 1e-9), "{n:?}");
}

/// A spring above a stiff column, pulled by steps of 1 mm.
fn limited(column: i32, steps: usize) -> String {
    format!(
        "model basic -ndm 2 -ndf 3
        node 1 0 0; node 2 0 1; node 3 0 1; fix 1 1 1 1; fix 2 0 1 1; fix 3 0 1 1
        geomTransf Linear 1; element elasticBeamColumn 1 1 2 1 1e9 1e3 1
        limitCurve ThreePoint 1 {column} 0. 9.5 1. 9.5 2. 9.5 -500. 4. 2 0 1 3 1 2
        uniaxialMaterial LimitState 1 5 0.005 10 0.01 20 0.02 -5 -0.005 -10 -0.01 -20 -0.02 1 1 0 0 0 1 2
        element zeroLength 2 2 3 -mat 1 -dir 1
        timeSeries Linear 1; pattern Plain 1 1 {{ sp 3 1 0.001 }}
        integrator LoadControl 1; system FullGeneral; constraints Transformation; numberer Plain
        test NormUnbalance 1e-9 20; algorithm Newton; analysis Static
        analyze {steps}; puts [lindex [eleResponse 2 force] 3]"
    )
}

/// The spring of [`limited`] inside another law, in a bar and as a fiber: forces of OpenSees (openseespy 3.7.1).
#[test]
fn limit_curve_is_watched_inside_other_laws() {
    let bare = [9.0, 10.0, 7.0, 4.0, 4.0];
    let spring = "element zeroLength 2 2 3 -mat 9 -dir 1";
    let cases = [
        (format!("uniaxialMaterial MinMax 9 1 -min -1 -max 1; {spring}"), bare),
        (format!("uniaxialMaterial MinMax 9 1 -min -1 -max 0.0125; {spring}"), [9.0, 10.0, 0.0, 0.0, 0.0]),
        (
            format!("uniaxialMaterial Elastic 7 1e-3; uniaxialMaterial Parallel 9 1 7; {spring}"),
            [9.000009, 10.00001, 7.000016, 4.000022, 4.00003],
        ),
        (format!("uniaxialMaterial InitStrainMaterial 9 1 0.001; {spring}"), [10.0, 9.5, 6.5, 4.0, 4.0]),
        (format!("uniaxialMaterial InitStressMaterial 9 1 0.5; {spring}"), [9.5, 10.5, 7.5, 4.5, 4.0]),
        (format!("uniaxialMaterial Fatigue 9 1 -E0 100; {spring}"), bare),
        (format!("uniaxialMaterial MinMax 8 1 -min -1 -max 1; uniaxialMaterial Parallel 9 8; {spring}"), bare),
        (
            format!("uniaxialMaterial Elastic 7 1e7; uniaxialMaterial Series 9 1 7; {spring}"),
            [8.9991001, 9.9990001, 6.9988501, 4.0, 4.0],
        ),
        ("section Fiber 9 { fiber 0 0 1 1 }; element zeroLengthSection 2 2 3 9".to_owned(), bare),
        ("section Uniaxial 9 1 P; element zeroLengthSection 2 2 3 9".to_owned(), bare),
        ("node 5 -1 1; fix 5 0 1 1; equalDOF 2 5 1; element truss 2 5 3 1 1".to_owned(), bare),
        ("node 5 -1 1; fix 5 0 1 1; equalDOF 2 5 1; element corotTruss 2 5 3 1 1".to_owned(), bare),
    ];
    for (element, forces) in cases {
        for (steps, force) in [9, 10, 16, 22, 30].into_iter().zip(forces) {
            let script = limited(1, steps).replace("element zeroLength 2 2 3 -mat 1 -dir 1", &element);
            let got = run(&script).numbers()[0].abs();
            assert!((got - force).abs() < 2e-4, "{element}, {steps} mm: {got}, not {force}");
        }
    }
}

/// A spring that has reached the limit of its column falls along the given slope to the residual force.
#[test]
fn limit_curve_ends_the_envelope() {
    for (steps, force) in [(9, 9.0), (10, 10.0), (16, 7.0), (22, 4.0), (30, 4.0)] {
        let got = run(&limited(1, steps)).numbers()[0];
        assert!((got - force).abs() < 1e-4, "{steps} mm: {got}, not {force}");
    }
    assert!(Script::default().run(&limited(7, 1)).error().message.contains("cannot watch element 7"));
}

/// A stage is told to have no effect, as in openseespy; a command without one is refused, and one without stages says nothing.
#[test]
fn stages_of_materials_have_no_effect() {
    let spring = |more: &str| {
        Script::default().run(&format!(
            "model basic -ndm 1 -ndf 1
            node 1 0; node 2 0; fix 1 1; uniaxialMaterial Elastic 3 200.; element zeroLength 1 1 2 -mat 3 -dir 1
            {more}
            timeSeries Linear 1; pattern Plain 1 1 {{ load 2 1. }}
            constraints Plain; numberer Plain; system FullGeneral; algorithm Linear; integrator LoadControl 1; analysis Static
            analyze 1; puts [nodeDisp 2 1]"
        ))
    };
    let codes = |ran: &Ran| ran.warnings().iter().filter_map(|d| d.check.map(|c| c.code)).collect::<Vec<_>>();
    let staged = spring("updateMaterialStage -material 3 -stage 1 -parameter 7").done();
    assert_eq!((staged.numbers(), codes(&staged)), (vec![0.005], vec!["no-stages"]));
    let plain = spring("").done();
    assert_eq!((plain.numbers(), codes(&plain)), (vec![0.005], vec![]));
    for words in ["-material 3", "-stage 1", "-material 3 -stage one"] {
        spring(&format!("updateMaterialStage {words}")).error();
    }
}
