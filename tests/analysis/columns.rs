//! Columns of one element that feels its own deflection, against the beam-column equations.

use super::script::{Script, run};
use std::f64::consts::PI;

const E: f64 = 29500.0;
const A: f64 = 51.7;
const I: f64 = 2150.0;
const L: f64 = 196.0;

/// One cantilever of a section under a lateral load of 10 and an axial one: displacements of the tip across and along, base moment.
fn cantilever(element: &str, section: &str, axial: f64) -> Vec<f64> {
    run(&format!(
        "model basic -ndm 2 -ndf 3; node 1 0 0; node 2 0 {L}; fix 1 1 1 1
        {section}
        geomTransf PDelta 1; beamIntegration Legendre 1 1 5
        element {element} 1 1 2 1 1
        timeSeries Linear 1; pattern Plain 1 1 {{ load 2 10. -{axial} 0. }}
        constraints Plain; numberer Plain; system FullGeneral; test NormUnbalance 1e-9 20; algorithm Newton
        integrator LoadControl 1.; analysis Static; analyze 1
        puts \"[nodeDisp 2 1] [nodeDisp 2 2] [lindex [eleResponse 1 force] 2]\""
    ))
    .done()
    .numbers()
}

fn elastic() -> String {
    format!("section Elastic 1 {E} {A} {I}")
}

/// AISC Design Guide 25, benchmark in single curvature: u = (π/2)(α P/P_e)^½ with P up to two thirds of the critical load.
#[test]
fn one_element_bends_as_the_column_does() {
    let critical = PI * PI * E * I / (4.0 * L * L);
    for alpha in [0.1, 0.4, 0.67] {
        let kl = 0.5 * PI * f64::sqrt(alpha);
        let tip = 10.0 * L.powi(3) / (3.0 * E * I) * 3.0 * (kl.tan() - kl) / kl.powi(3);
        let moment = 10.0 * L * kl.tan() / kl;
        let found = cantilever("forceBeamColumnCBDI", &elastic(), alpha * critical);
        assert!((found[0] / tip - 1.0).abs() < 2e-4, "{alpha}: {} for {tip}", found[0]);
        assert!((found[2] / moment - 1.0).abs() < 2e-4, "{alpha}: {} for {moment}", found[2]);
        let straight = cantilever("forceBeamColumn", &elastic(), alpha * critical);
        assert!((straight[0] / tip - 1.0).abs() > 1e-3, "{alpha}: without deflections {} for {tip}", straight[0]);
    }
}

/// A column that also shears (Engesser, 1889): with β = 1 - P/GA and k² = P/(E I β) the tip moves by
/// H tan(k L)/(k P β) - H L/P.
#[test]
fn one_element_shears_as_the_column_does() {
    let (ga, axial) = (4.0 * 0.4 * PI * PI * E * I / (4.0 * L * L), 0.4 * PI * PI * E * I / (4.0 * L * L));
    let section = format!("section Elastic 1 {E} {A} {I} {} 0.5", ga / (0.5 * A));
    let beta = 1.0 - axial / ga;
    let k = (axial / (E * I * beta)).sqrt();
    let tip = 10.0 * (k * L).tan() / (k * axial * beta) - 10.0 * L / axial;
    let found = cantilever("forceBeamColumnCSBDI", &section, axial)[0];
    assert!((found / tip - 1.0).abs() < 2e-3, "{found} for {tip}");
    assert_eq!(found, cantilever("forceBeamColumnCBDI", &section, axial)[0].max(found), "shear deflects more");
}

/// Uniform load on a simply supported beam-column, in the plane and in space: its ends turn by
/// w L³/(24 E I) · 3 (tan u - u)/u³, u = (L/2) (P/(E I))^½.
#[test]
fn loads_between_the_ends_bend_a_column() {
    let axial = 0.5 * PI * PI * E * I / (L * L);
    let u = 0.5 * L * (axial / (E * I)).sqrt();
    let turn = 0.01 * L.powi(3) / (24.0 * E * I) * 3.0 * (u.tan() - u) / u.powi(3);
    let plane = format!(
        "model basic -ndm 2 -ndf 3; node 1 0 0; node 2 {L} 0; fix 1 1 1 0; fix 2 0 1 0
        {}; geomTransf Linear 1; set load {{load 2 -{axial} 0. 0.; eleLoad -ele 1 -type -beamUniform -0.01}}; set turn {{nodeDisp 1 3}}",
        elastic()
    );
    let space = format!(
        "model basic -ndm 3 -ndf 6; node 1 0 0 0; node 2 {L} 0 0; fix 1 1 1 1 1 0 0; fix 2 0 1 1 1 0 0
        section Elastic 1 {E} {A} {I} {I} 11000. 100.; geomTransf Linear 1 0 0 1
        set load {{load 2 -{axial} 0. 0. 0. 0. 0.; eleLoad -ele 1 -type -beamUniform 0. -0.01}}; set turn {{nodeDisp 1 5}}"
    );
    for model in [plane, space] {
        let found = run(&format!(
            "{model}
            beamIntegration Lobatto 1 1 7; element forceBeamColumnCBDI 1 1 2 1 1
            timeSeries Linear 1; pattern Plain 1 1 $load
            constraints Plain; numberer Plain; system FullGeneral; test NormUnbalance 1e-9 20; algorithm Newton
            integrator LoadControl 1.; analysis Static; analyze 1; puts [eval $turn]"
        ))
        .done()
        .numbers()[0]
            .abs();
        assert!((found / turn - 1.0).abs() < 1e-4, "{found} for {turn}");
    }
}

#[test]
fn too_many_deformations_and_equal_places_are_refused() {
    let model = format!("model basic -ndm 2 -ndf 3; node 1 0 0; node 2 0 {L}; {}; geomTransf Linear 1", elastic());
    let many = Script::default().run(&format!("{model}\nelement forceBeamColumnCBDI 1 1 2 40 1 1"));
    assert!(many.error().message.contains("deformations"), "{}", many.error().message);
    let equal = Script::default().run(&format!(
        "{model}\nbeamIntegration UserDefined 1 3 1 1 1 0.2 0.2 0.8 0.3 0.3 0.4\nelement forceBeamColumnCBDI 1 1 2 1 1"
    ));
    assert!(equal.error().message.contains("same place"), "{}", equal.error().message);
}

/// Two prestressed cables as force-based beams: initial stresses stiffen them laterally from the first iteration on. Displacements
/// and moments of openseespy 3.7.1.
#[test]
fn initial_stresses_stiffen_force_based_beams() {
    for script in [Script::default(), Script::compat()] {
        let ran = script.run(
            "model basic -ndm 2 -ndf 3
            node 1 0 0; node 2 100 0; node 3 200 0; node 4 100 0
            fix 1 1 1 1; fix 3 1 1 1; equalDOF 2 4 1 2
            uniaxialMaterial Steel02 1 100 36e6 0.1 20 .925 .15 0 1 0 1 30
            section Fiber 1 { patch circ 1 4 2 0 0 0 1.261 0 360 }
            geomTransf PDelta 1
            element forceBeamColumn 1 1 2 3 1 1
            element forceBeamColumn 2 4 3 3 -transform 1 -section 1
            timeSeries Linear 1
            pattern Plain 1 1 { load 2 0 0.1 0 }
            system BandGeneral; numberer RCM; constraints Transformation
            integrator LoadControl 1.0; test NormUnbalance 1e-9 50; algorithm Newton; analysis Static
            analyze 1
            puts \"[testIter] [nodeDisp 2 2] [eleForce 1 1] [eleForce 1 6]\"",
        );
        let n = ran.done().numbers();
        assert!(n[0] == 1.0, "{n:?}");
        for (got, e) in n[1..].iter().zip([0.0002960231150561328, -149.86537355730718, 0.0]) {
            assert!((got - e).abs() < 1e-7 * e.abs().max(1e-2), "{n:?}");
        }
    }
}

/// A cantilever that shears moves by H L³/(3 E I) + H L/(G A α). A beam by displacements has no use for a shear stiffness, not
/// even where it is zero.
#[test]
fn beams_of_elastic_sections_shear() {
    let g = 0.01 * E;
    let tip = 10.0 * L.powi(3) / (3.0 * E * I) + 10.0 * L / (g * A * 0.5);
    for element in ["forceBeamColumn", "mixedBeamColumn"] {
        let found = cantilever(element, &format!("section Elastic 1 {E} {A} {I} {g} 0.5"), 0.0)[0];
        assert!((found / tip - 1.0).abs() < 1e-9, "{element}: {found} for {tip}");
    }
    let without = cantilever("dispBeamColumn", &format!("section Elastic 1 {E} {A} {I} 0. 0."), 0.0);
    assert_eq!(without, cantilever("dispBeamColumn", &elastic(), 0.0));
}

/// An eccentric tendon bends a cantilever without loads. Displacements of openseespy 3.7.1.
#[test]
fn an_eccentric_tendon_bends_beams() {
    for element in ["dispBeamColumn", "forceBeamColumn", "mixedBeamColumn"] {
        for script in [Script::default(), Script::compat()] {
            let ran = script.run(&format!(
                "model basic -ndm 2 -ndf 3; node 1 0 0; node 2 100 0; node 3 200 0; fix 1 1 1 1
                uniaxialMaterial Steel02 1 100 36e6 0.1 20 .925 .15 0 1 0 1 30; uniaxialMaterial Elastic 2 1e6
                section Fiber 1 {{ fiber 1 0 0.1 1; fiber 1 0 5 2; fiber -1 0 5 2 }}
                geomTransf PDelta 1
                element {element} 1 1 2 3 1 1; element {element} 2 2 3 3 1 1
                system BandGeneral; numberer RCM; constraints Transformation
                integrator LoadControl 1.0; test EnergyIncr 1e-16 50; algorithm Newton; analysis Static
                analyze 1
                puts [nodeDisp 3]"
            ));
            let n = ran.done().numbers();
            for (got, e) in n.iter().zip([-3.522910430577942e-5, 0.0034883720930232558, 3.4883720930232556e-5]) {
                assert!((got - e).abs() < 1e-9 * e.abs(), "{element}: {n:?}");
            }
            assert_eq!(n.len(), 3, "{element}");
        }
    }
}

/// A beam in space with end stiffnesses of its own, between offset nodes. Displacements and eigenvalues of openseespy 3.7.1.
#[test]
fn factors_of_a_modified_beam_in_space() {
    let n = run("model basic -ndm 3 -ndf 6; node 1 0 0 0; node 2 0.3 0.4 3; fix 1 1 1 1 1 1 1
        geomTransf PDelta 1 1 0 0
        element ModElasticBeam3d 1 1 2 0.02 2e5 8e4 2e-3 1e-3 3e-3 5.5 4.5 2.5 6 5 3 1 -mass 0.4 -cMass
        timeSeries Linear 1
        pattern Plain 1 1 {
            load 2 1 2 -30 0.4 0.5 0.6
            eleLoad -ele 1 -type -beamUniform 0.5 0.3 -0.2; eleLoad -ele 1 -type -beamPoint 0.5 0.3 0.6 -0.2
        }
        constraints Plain; numberer Plain; system FullGeneral; test NormUnbalance 1e-9 9; algorithm Newton
        integrator LoadControl 1.0; analysis Static; analyze 1
        puts [nodeDisp 2]; puts [eigen -fullGenLapack 4]")
    .numbers();
    let expected = [
        0.23014100780018537,
        0.05604252885144312,
        -0.05334494397204585,
        -0.03173938248559135,
        0.1207363990621331,
        0.0005085189613499548,
        68.53041597203587,
        282.3766677039489,
        1297.297297297297,
        3243.2432432432433,
    ];
    assert_eq!(n.len(), expected.len(), "{n:?}");
    for (got, e) in n.iter().zip(expected) {
        assert!((got - e).abs() < 1e-9 * e.abs(), "{got} for {e}");
    }
}
