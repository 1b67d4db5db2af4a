//! Elements of elastic continua beside openseespy 3.7.1.

use crate::script::{Script, run};

#[test]
fn plane_elements_with_nodes_on_their_sides() {
    let points = "node 1 0 0; node 2 2 0.1; node 3 2.2 1.5; node 4 0 1.2; node 5 1 0.05; node 6 2.1 0.8; node 7 1.1 1.4
        node 8 0 0.6; node 9 1.05 0.7";
    for (elements, expected) in [
        (
            "element quad8n 1 1 2 3 4 5 6 7 8 0.5 PlaneStress 1 0.2 0.0 0.1 -0.3; fix 8 1 1; fix 9 1 1",
            [0.009641837490232369, -0.09591935054280186, 0.03583557532885182, -0.02924525248357781],
        ),
        (
            "element quad9n 1 1 2 3 4 5 6 7 8 9 0.5 PlaneStrain 1; fix 8 1 1",
            [0.014856349426514308, -0.053784303142411075, 0.016465502115243072, 0.0058962950681954755],
        ),
        (
            "element tri6n 1 1 2 3 5 6 9 0.5 PlaneStress 1; element tri6n 2 1 3 4 9 7 8 0.5 PlaneStress 1; fix 8 1 1",
            [0.014326508850873639, -0.04288341678465408, 0.02617766611138719, 0.002494187945591973],
        ),
        (
            "element enhancedQuad 1 1 2 3 4 0.5 PlaneStrain 1; foreach n {5 6 7 8 9} { fix $n 1 1 }",
            [0.0008378593548593668, -0.039157605429402866, 0.023909258729421994, -0.021489835212771927],
        ),
    ] {
        let model = format!(
            "model basic -ndm 2 -ndf 2; nDMaterial ElasticIsotropic 1 200. 0.3 2.0
            {points}
            {elements}; fix 1 1 1; fix 4 1 1
            timeSeries Linear 1; pattern Plain 1 1 {{ load 2 1. -2.; load 3 0.5 1.5 }}
            constraints Plain; numberer Plain; system FullGeneral; algorithm Linear; integrator LoadControl 1.0
            analysis Static; analyze 1
            puts \"[nodeDisp 2 1] [nodeDisp 2 2] [nodeDisp 3 1] [nodeDisp 3 2]\""
        );
        for (got, e) in run(&model).numbers().iter().zip(expected) {
            assert!((got - e).abs() < 1e-12, "{elements}: {got} {e}");
        }
    }
}

#[test]
fn stabilised_bricks_of_any_shape() {
    let numbers = run("model basic -ndm 3 -ndf 3; nDMaterial ElasticIsotropic 1 200. 0.3
        node 1 0 0 0; node 2 2 0.1 0.05; node 3 2.2 1.5 -0.1; node 4 0 1.2 0.1; node 5 0.1 0 1; node 6 2 0 1.3
        node 7 2.1 1.4 1.2; node 8 -0.1 1.3 1.1; node 9 4 0 0.2; node 10 4.1 1.3 0; node 11 4 0.1 1.4; node 12 3.9 1.6 1.3
        element SSPbrick 1 1 2 3 4 5 6 7 8 1; element SSPbrick 2 2 9 10 3 6 11 12 7 1; foreach n {1 4 5 8} { fix $n 1 1 1 }
        timeSeries Linear 1; pattern Plain 1 1 { load 9 1. -2. 0.5; load 12 0.5 1.5 -3.; load 11 0 1 0 }
        constraints Plain; numberer Plain; system FullGeneral; algorithm Linear; integrator LoadControl 1.0; analysis Static
        analyze 1; puts \"[nodeDisp 9 1] [nodeDisp 9 3] [nodeDisp 12 2] [nodeDisp 6 3] [eleResponse 1 stress]\"")
    .numbers();
    let expected = [
        -0.13567093646393438,
        -1.1506223231967985,
        0.7247477017831967,
        -0.2993122847218696,
        0.8957679872281733,
        -0.356455838324113,
        1.900192375794249,
        0.21609317613070242,
        -0.5356591144109404,
        -1.8585045688770576,
    ];
    assert_eq!(numbers.len(), expected.len());
    for (got, e) in numbers.iter().zip(expected) {
        assert!((got - e).abs() < 1e-11, "{numbers:?}");
    }
}

/// A panel of concrete is pulled until it cracks: the stress falls from the strength of the concrete to that of the bars.
#[test]
fn a_panel_that_cracks_leaves_the_stress_to_the_bars() {
    let numbers = run("model basic -ndm 2 -ndf 3; node 1 0 0; node 2 0 1000; fix 1 1 1 1; fix 2 1 0 1
        uniaxialMaterial Elastic 1 200000.; uniaxialMaterial ConcreteCM 2 -40 -0.0024 30000 7 1.035 2. 0.00008 1.2 10000
        nDMaterial FSAM 1 0. 1 1 2 0.01 0.02 1.0 0.01; element SFI_MVLEM 1 1 2 1 0.4 -thick 100 -width 1000 -mat 1
        timeSeries Linear 1; pattern Plain 1 1 { load 2 0 1 0 }
        constraints Plain; system FullGeneral; test NormUnbalance 1e-6 50; integrator DisplacementControl 2 2 0.02
        analysis Static; analyze 3; puts [getTime]; analyze 40; puts [getTime]
        puts [eleResponse 1 RCPanel 1 panel_stress_steel]; puts [eleResponse 1 RCPanel 1 cracking_angles]")
    .numbers();
    let bars = |v: f64| 200_000.0 * 0.02 * v / 1000.0;
    // Below the strain at the strength the concrete carries more than half.
    assert!(numbers[0] > 1e5 * bars(0.06) * 2.0, "{numbers:?}");
    assert!((numbers[1] - 1e5 * bars(0.86)).abs() < 0.4 * numbers[1], "{numbers:?}");
    assert!((numbers[3] - bars(0.86)).abs() < 1e-9, "{numbers:?}");
    assert!((numbers[5].abs() - std::f64::consts::FRAC_PI_2).abs() < 1e-6, "{numbers:?}");
}

/// Forms that a material does not have are refused at the word of the material.
#[test]
fn a_material_without_the_form_is_refused() {
    for (script, message) in [
        (
            "model basic -ndm 2 -ndf 2; node 1 0 0; node 2 1 0; node 3 1 1; node 4 0 1
nDMaterial PlaneStressSimplifiedJ2 1 80. 160. 2. 1. 1.\nelement quad 1 1 2 3 4 1. PlaneStrain 1",
            "no law in plane strain",
        ),
        (
            "model basic -ndm 2 -ndf 3; uniaxialMaterial Elastic 1 1.\nnDMaterial FSAM 1 0. 1 1 1 0.01 0.01 1. 0.01",
            "is Elastic",
        ),
        (
            "model basic -ndm 3 -ndf 3\nnDMaterial ElasticOrthotropic 1 1. 1. 1. 0.9 0.9 0.9 1. 1. 1.",
            "positive definite",
        ),
        (
            "model basic -ndm 3 -ndf 3\nnDMaterial ASDConcrete3D 1 30000. 0.2 -Te 0 1e-4 -Ts 0 3. 2. -Ce 0 1e-3 -Cs 0 30.",
            "stresses",
        ),
    ] {
        let ran = Script::default().run(script);
        let error = ran.error();
        assert!(error.message.contains(message) && error.span.is_some(), "{}", error.message);
    }
}

/// Concrete in plane stress is unloaded in one step: nothing but round-off is left of the stress. Strains of openseespy 3.7.1.
#[test]
fn damaged_concrete_unloads_in_plane_stress() {
    let n = run("model basic -ndm 2 -ndf 2
        nDMaterial ASDConcrete3D 1 30000. 0.2 -Te 0. 9e-5 1.5e-4 5e-3 -Ts 0. 2.7 3. 0.6 -Td 0. 0. 0. 0.96 \\
            -Ce 0. 5e-4 1e-3 2e-3 1.8e-1 -Cs 0. 15. 25. 30. 3. -Cd 0. 0. 0. 0. 0.99
        nDMaterial PlaneStress 2 1
        node 1 0. 0.; node 2 250. 0.; node 3 0. 250.
        element tri31 1 1 2 3 1. PlaneStress 2
        fix 1 1 1; fix 2 0 1; fix 3 1 0
        timeSeries Linear 1; pattern Plain 1 1 { sp 2 1 -0.3 }
        constraints Transformation; numberer Plain; system FullGeneral; test NormDispIncr 1e-8 10; algorithm Newton
        integrator LoadControl 0.1; analysis Static
        puts [analyze 10]; puts [eleResponse 1 material 1 strain]
        remove loadPattern 1; integrator LoadControl 1.; puts [analyze 1]; puts [eleResponse 1 material 1 strain]")
    .numbers();
    let expected = [0.0, -0.0012, 0.00024, 0.0, 0.0, -0.0003333333611111107, 6.666667222222218e-5, 0.0];
    assert!(n.len() == 8 && n.iter().zip(expected).all(|(got, e)| (got - e).abs() < 1e-9), "{n:?}");
}
