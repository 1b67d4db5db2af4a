//! Displacements of force-based beams between their ends, their points of inflection, and the solution of the equations.

use super::close;
use super::script::{Script, run};

/// A beam of four sections of fibers in space between rigid offsets, far beyond its yield.
const INCLINED: &str = "model basic -ndm 3 -ndf 6
    node 1 0 0 0; node 2 2 1 0.5; fix 1 1 1 1 1 1 1
    uniaxialMaterial Steel01 1 300. 2e4 0.02
    section Fiber 1 -GJ 50. { patch rect 1 4 3 -0.2 -0.1 0.2 0.1 }
    beamIntegration Lobatto 1 1 4
    timeSeries Linear 1; pattern Plain 1 1 { load 2 1. 3. -1. 0.1 0.2 0.3 }
    constraints Plain; numberer Plain; system FullGeneral; test NormDispIncr 1e-12 50; algorithm Newton
    integrator LoadControl 0.05; analysis Static\n";

/// A cantilever of 4 in the plane, of EI = 60, with a force of 3 and a moment of -9 at its end.
const CANTILEVER: &str = "model basic -ndm 2 -ndf 3
    node 1 0 0; node 2 4 0; fix 1 1 1 1
    section Elastic 1 200. 0.5 0.3; geomTransf Linear 1; beamIntegration Lobatto 1 1 5
    element forceBeamColumn 1 1 2 1 1
    timeSeries Linear 1; pattern Plain 1 1 { load 2 0 3 -9 }
    constraints Plain; numberer Plain; system FullGeneral; algorithm Linear; integrator LoadControl 1; analysis Static\n";

fn agree(got: &[f64], expected: &[f64], tolerance: f64) {
    assert_eq!(got.len(), expected.len(), "{got:?}");
    let peak = expected.iter().fold(0.0, |peak: f64, x| peak.max(x.abs()));
    for (g, e) in got.iter().zip(expected) {
        assert!((g - e).abs() <= tolerance * peak, "{got:?}\n{expected:?}");
    }
}

/// The numbers of openseespy 3.7.1.
#[test]
fn deflections_beyond_the_yield_are_those_of_opensees() {
    let ran = run(&format!(
        "{INCLINED}geomTransf Linear 1 0 0 1 -jntOffset 0.1 0. 0.05 -0.1 0.02 0.
        element forceBeamColumn 1 1 2 1 1
        puts [analyze 10]
        puts [eleResponse 1 inflectionPoint]
        puts [eleResponse 1 tangentDrift]
        puts [eleResponse 1 sectionDisplacements]
        puts [eleResponse 1 sectionDisplacements local]
        puts \"[sectionDisplacement 1 3] [sectionDisplacement 1 3 -local] [cbdiDisplacement 1 0.3]\""
    ));
    let n = ran.numbers();
    assert!(n[0] == 0.0 && n.len() == 1 + 2 + 4 + 24 + 9, "{n:?}");
    agree(&n[1..3], &[2.3781252207456665, 2.253999149670079], 1e-8);
    agree(&n[3..7], &[-4.246233703462711, 0.0, -9.083507912521593, 0.0], 1e-8);
    let global = [
        [0.0, 0.0, 0.0],
        [-0.03421674425961488, 0.5490755135746581, -1.1019203153943804],
        [-0.16601354195196927, 2.6488514754438737, -5.324866803913677],
        [-0.25517096430372854, 4.079975117141742, -8.20633349735209],
    ];
    let local = [
        [0.0, 0.0, 0.0],
        [0.0012292823232457673, 0.4945771636084182, -1.1279516854794247],
        [0.003218302904026854, 2.3864063139553964, -5.4500674914843685],
        [0.004447585227272621, 3.6754713630298284, -8.399173121552844],
    ];
    agree(&n[7..19], global.as_flattened(), 1e-8);
    agree(&n[19..31], local.as_flattened(), 1e-8);
    let between = [-0.039657007028471, 0.6354193074881537, -1.2753778622396486];
    agree(&n[31..], [global[2], local[2], between].as_flattened(), 1e-8);
}

/// v(x) = (3 x² (12 - x)/6 - 9 x²/2)/60, and the moment 3 (4 - x) - 9 is zero at 1. Lobatto's points integrate it exactly.
#[test]
fn a_cantilever_deflects_by_its_formula() {
    let ran = run(&format!(
        "{CANTILEVER}puts [analyze 1]
        puts [eleResponse 1 inflectionPoint]
        foreach x {{0 0.3 0.5 1}} {{ puts [cbdiDisplacement 1 $x] }}
        puts [sectionDisplacement 1 5]
        recorder Element -file drift.out -ele 1 tangentDrift; record; remove recorders"
    ));
    let n = ran.numbers();
    let deflection = |x: f64| (3.0 * x * x * (12.0 - x) / 6.0 - 9.0 * x * x / 2.0) / 60.0;
    agree(&n[..2], &[0.0, 1.0], 1e-12);
    for (i, x) in [0.0, 0.3, 0.5, 1.0, 1.0].iter().enumerate() {
        let expected = [0.0, deflection(4.0 * x), 0.0];
        assert!(n[2 + 3 * i..][..3].iter().zip(expected).all(|(n, e)| (n - e).abs() < 1e-14), "{n:?}");
    }
    // Curvatures (3 - 3 x)/60 times x - 1 by Lobatto's rule: the numbers of openseespy 3.7.1.
    agree(&ran.tables["drift.out"][0], &[-0.015208756156929428, -0.45145791050973677], 1e-12);
}

/// No formula holds for large displacements, beams by displacements, or a place beyond the end.
#[test]
fn deflections_that_are_not_known_are_refused() {
    for (beam, query) in [
        ("geomTransf Corotational 1 0 0 1\nelement forceBeamColumn 1 1 2 1 1", "sectionDisplacement 1 1"),
        ("geomTransf Linear 1 0 0 1\nelement dispBeamColumn 1 1 2 1 1", "cbdiDisplacement 1 0.5"),
        ("geomTransf Linear 1 0 0 1\nelement dispBeamColumn 1 1 2 1 1", "eleResponse 1 inflectionPoint"),
        ("geomTransf Linear 1 0 0 1\nelement forceBeamColumn 1 1 2 1 1", "cbdiDisplacement 1 1.2"),
        ("geomTransf Linear 1 0 0 1\nelement forceBeamColumn 1 1 2 1 1", "sectionDisplacement 1 5"),
    ] {
        Script::default().run(&format!("{INCLINED}{beam}\n{query}")).error();
    }
}

/// The solution of a linear step is its displacements; there is none before.
#[test]
fn the_solution_of_a_linear_step() {
    let ran = run(&format!(
        "{CANTILEVER}puts [llength [printX -ret]]\nputs [analyze 1]\nputs \"[printX -ret] [nodeDisp 2]\""
    ));
    let n = ran.numbers();
    assert!(n[..2] == [0.0, 0.0] && n.len() == 8, "{n:?}");
    assert!(n[2..5].iter().zip(&n[5..]).all(|(x, u)| close(*x, *u, 1e-12)), "{n:?}");
}
