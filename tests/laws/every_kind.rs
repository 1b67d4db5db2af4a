//! Properties of every kind of uniaxial material and element in scripts, from one table each. A kind that is in
//! neither table, nor among the bearings, fails the test.

use super::driver::{SingleElement, difference, path};
use super::every_bearing;
use super::parts::{PARTS, parts};
use super::script::run;
use super::shapes::{Shape, element_words, node_words, nodes, rigid};
use hysteron::element::{ElementInput, ElementOutput, Histories, MatrixMask};
use hysteron::opensees::kinds;
use nalgebra::Vector3;

/// Words of a material after `uniaxialMaterial`, with @ for the tag, and a strain in its nonlinear range. Materials
/// 11 to 13 are components of others.
pub const MATERIALS: &[(&str, f64)] = &[
    ("Elastic @ 200. 3. 50.", 0.1),
    ("ElasticPP @ 200. 0.01 -0.02 0.003", 0.1),
    ("ElasticPPGap @ 200. 2. 0.01 0.05 damage", 0.1),
    ("HookGap @ 200. -0.03 0.02", 0.1),
    ("ENT @ 200.", 0.1),
    ("ElasticBilin @ 200. 50. 0.02 150. 300. -0.03", 0.1),
    ("ElasticMultiLinear @ 0.5 -strain -0.08 -0.03 0. 0.02 0.05 -stress -3. -2.5 0. 1. 4.", 0.1),
    ("Steel01 @ 2. 200. 0.02 0.05 5. 0.05 5.", 0.1),
    ("Steel02 @ 2. 200. 0.02 18. 0.925 0.15 0.05 5. 0.03 4. 0.8", 0.1),
    ("SteelBRB @ 200. 2. 3. 1.2 0.02 0.05 3.5 2.5 0.03 0.05", 0.1),
    ("SteelMPF @ 2. 1.8 200. 0.02 0.03 18. 0.925 0.15 0.01 5. 0.02 4.", 0.1),
    ("ReinforcingSteel @ 60. 90. 29000. 700. 0.008 0.1 -CMFatigue 0.26 0.506 0.389 -IsoHard 4.3 0.01", 0.04),
    ("ReinforcingSteel @ 60. 90. 29000. 700. 0.008 0.1 -GABuck 6. 1. 0.4 0.5", 0.04),
    ("ReinforcingSteel @ 60. 90. 29000. 700. 0.008 0.1 -DMBuck 6. 1.", 0.04),
    ("Dodd_Restrepo @ 400. 600. 0.01 0.12 2e5 0.04 520.", 0.05),
    ("Dodd_Restrepo @ 400. 600. 0.01 0.12 2e5 0.04 520. 0.8", 0.009),
    ("SteelDRC @ 2e5 400. 0.12 600. 0.01", 0.05),
    ("SteelDRC @ 2e5 400. 0.12 600. 0.01 -shPoint 0.04 520. -bausch 0 -omegaFactor 0.8 -Dfu 0.7", 0.05),
    ("SteelDRC @ 2e5 400. 0.12 600. 0.01 -bausch 2 -fractStrain 0.2 -viscousDamper 2. 0.8", 0.05),
    ("SteelDRC @ 2e5 400. 0.12 600. 0.01 -bausch 1", 0.009),
    ("Hardening @ 200. 2. 10. 20.", 0.1),
    ("MultiLinear @ 0.005 1. 0.02 2. 0.06 2.5", 0.1),
    ("Concrete01 @ -30. -0.002 -6. -0.005", 0.006),
    ("Concrete02 @ -30. -0.002 -6. -0.005 0.1 3. 2000.", 0.006),
    ("Concrete02 @ -30. -0.002 -6. -0.005 0.1 3. 0.", 0.006),
    ("Concrete02 @ -30. -0.002 -6. -0.005 0.1 0. 0.", 0.006),
    ("Concrete04 @ -30. -0.002 -0.006 25000. 3. 0.002 0.2", 0.006),
    ("Concrete04 @ -30. -0.002 -0.006 12000.", 0.006),
    ("ConcreteCM @ -30. -0.002 25000. 7. 1.035 3. 0.0002 1.2 1e4 -GapClose 1", 0.006),
    ("ConcreteCM @ -30. -0.002 25000. 7. 1.035 3. 0.0002 1.2 30.", 0.006),
    ("Concrete02IS @ 25000. -30. -0.002 -6. -0.005 0.1 3. 2000.", 0.006),
    ("Concrete06 @ -30. -0.002 2. 1.1 0.32 3. 0.0002 0.4 0.08", 0.006),
    ("Concrete07 @ -30. -0.002 25000. 3. 0.0002 2. 2.3 4.", 0.006),
    ("Concrete07 @ -30. -0.002 25000. 3. 0.0002 2. 1e4 1.5", 0.003),
    (
        "ConfinedConcrete01 @ S4b -30. 26000. -epscu 0.02 -varub 300. 200. 10. 100. 400. 206000. 0.005 100. 16. -internal 8. 100. 400. \
         206000. 0. 100. -wrap 30. 0.2 1. 3000. 2e5 -silica -stRatio 0.85",
        0.015,
    ),
    ("ASDConcrete1D @ 30000. -fc 30. -tangent", 0.004),
    ("ASDConcrete1D @ 30000. -fc 30. -ft 2. -tangent -eta 0.02", 0.004),
    (
        "ASDConcrete1D @ 30000. -Te 0. 0.0001 0.001 -Ts 0. 3. 0.1 -Td 0. 0. 0.9 -Ce 0. 0.0005 0.002 0.01 -Cs 0. 15. 30. 3. \
         -Cd 0. 0. 0.2 0.9 -tangent -autoRegularization 100.",
        0.004,
    ),
    ("ConcreteD @ -30. -0.002 3. 0.00015 25000. 1.5 2. 0.25 1.15", 0.006),
    (
        "ConcretewBeta @ -30. -0.002 -15. -0.006 -3. -0.012 3. 1.5 0.0005 0.3 0.001 -lambda 0.4 -alpha 0.8 -E 25000. -conf -36. \
         -0.003",
        0.006,
    ),
    ("ConcretewBeta @ -30. -0.002 -15. -0.006 -3. -0.012 3. 1.5 0.0005 0.3 0.001 -M 0.1", 0.006),
    ("FRPConfinedConcrete02 @ -30. 25000. -0.002 -JacketC 0.4 1e5 0.012 150. 3. 2000. 1", 0.01),
    ("FRPConfinedConcrete02 @ -30. 25000. -0.002 3. 2000. 1", 0.003),
    (
        "Steel4 @ 2. 200. -asym -kin 0.02 20. 0.9 0.15 0.01 25. 0.9 0.15 -iso 0.01 1. 0.001 20. 2. 0.02 1. 0.001 20. -ult 3. 5. 3.5 5.",
        0.1,
    ),
    ("Steel03 @ 2. 200. 0.02 20. 0.9 0.15 0.1 5. 0.2 6.", 0.1),
    ("Steel03 @ 2. 200. 0.02 20. 0. 0.", 0.1),
    ("SteelFractureDI @ 2. 2.2 200. 0.02 20. 0.925 0.15 0.05 1. 0.03 1. 1e3 0.6 0.2 1.", 0.1),
    ("Steel4 @ 2. 200. -kin 0.02 20. 0.9 0.15 -init 0.7 -mem 0", 0.1),
    ("Concrete01WithSITC @ -30. -0.002 -6. -0.005 0.001", 0.006),
    ("CastFuse @ 8 5. 1.5 50. 29000. 12. 0.05 20. 0.92 0.15 0.02 1. 0.03 1.", 2.0),
    ("BarSlip @ 30. 450. 200000. 600. 4000. 20. 400. 4 400. 400. strong beamTop Damage1 MPa", 4.),
    ("BarSlip @ 30. 450. 200000. 600. 4000. 20. 400. 4 400. 400. weak column Damage2 MPa", 4.),
    ("Masonry @ -5. 0.2 -0.002 -0.01 0.001 5000. 2. 0.3 0.2 -0.003 -0.008 0.3 0.4 1.5 0.7 1.5 0.6 1.1 1.5 1. 1", 0.02),
    ("Masonry @ -5. 0. -0.002 -0.01 0.001 5000. 2. 0.3 0.3 0. 0. 0.3 0.4 1.5 0.7 1.5 0.6 1.1 1.5 1. 2", 0.012),
    ("ECC01 @ 3. 0.0002 4. 0.01 0.03 -40. -0.003 -0.01 3. 4. 2. 1.5 0.4 0.3", 0.02),
    ("HystereticSM @ -posEnv 1.5 0.01 2. 0.03 1.8 0.06 0.5 0.1 -pinch 0.7 0.4 -damage 0.02 0.01 -beta 0.3", 0.1),
    (
        "HystereticSM @ -posEnv 1.5 0.01 2. 0.03 -negEnv -1. -0.01 -1.2 -0.04 -0.3 -0.1 -degEnv 0.1 -0.2 -damage 0.1 0.1",
        0.1,
    ),
    ("BilinearOilDamper @ 200. 2. 5. 0.1", 0.1),
    ("BilinearOilDamper @ 200. 2. 5. 0.1 0. 2 1e-4 1e-6 8", 0.1),
    ("Backbone @ 31 1.5", 0.1),
    ("Backbone @ 32", 0.1),
    ("Backbone @ 33", 0.1),
    ("Backbone @ 34", 0.1),
    ("Backbone @ 35", 0.1),
    ("Backbone @ 36", 0.1),
    ("Backbone @ 37", 0.1),
    ("Backbone @ 38", 0.1),
    ("Backbone @ 39", 0.1),
    ("Backbone @ 40", 0.1),
    ("Backbone @ 41", 0.1),
    ("GNG @ 200. 2. 0.01 0.05", 0.1),
    ("ElasticPowerFunc @ 0.5 -coeff 20. 300. -exp 1. 3.", 0.1),
    ("ASD_SMA_3K @ 200. 5. 60. 2. 0.6", 0.1),
    ("Multiplier @ 11 1.7", 0.1),
    ("UVCuniaxial @ 200. 2. 0.5 10. 0.3 100. 2 20. 40. 4. 5.", 0.1),
    ("Bond_SP01 @ 60. 0.02 90. 0.6 0.4 0.7", 0.1),
    ("BoucWenOriginal @ 200. 2. 0.05 0.02 3. 2. 0.6 0.4", 0.1),
    ("Cable @ 0.2 200. 1e-4 500.", 0.01),
    ("PathIndependent @ 11", 0.1),
    ("BoucWen @ 0.1 1000. 1.7 15. 25. 1. 0.01 0.02 0.015", 0.2),
    ("Hysteretic @ 2. 0.01 3. 0.03 2.5 0.08 -1.5 -0.008 -2.5 -0.05 -2.6 -0.09 0.6 0.3 0.01 0.005 0.4", 0.1),
    ("Bilin02 @ 200. 0.03 0.02 2. -1.8 3. 4. 3. 5. 1. 1. 1. 1. 0.04 0.05 0.15 0.2 0.3 0.4 0.5 0.5 1. 0.8 0.", 0.1),
    ("Bilin @ 200. 0.03 0.02 2. -1.8 3. 4. 3. 5. 1. 1. 1. 1. 0.04 0.05 0.15 0.2 0.3 0.4 0.5 0.5 1. 0.8 0.", 0.1),
    (
        "Pinching4 @ 1.5 0.01 2. 0.02 2.2 0.05 0.5 0.09 -1.2 -0.008 -1.8 -0.025 -2. -0.04 -0.4 -0.1 0.5 0.25 0.05 0.4 0.3 -0.1 \
         0.2 0.1 0.3 0.2 0.9 0.1 0.2 0.5 1. 0.5 0.1 0.1 1. 1. 0.3 10. energy",
        0.1,
    ),
    (
        "Pinching4 @ 1.5 0.01 2. 0.02 2. 0.05 0.5 0.09 0.5 0.25 0. 0. 0. 0. 0. 0. 0. 0. 0. 0. 0. 0. 0. 0. 0. 0. 10. cycle",
        0.1,
    ),
    ("IMKBilin @ 200. 0.04 0.15 0.3 2. 1.1 0.4 0.05 0.2 0.4 -1.8 1.05 0.3 3. 4. 5. 1. 1. 1. 1. 0.8", 0.1),
    ("IMKPeakOriented @ 200. 0.04 0.15 0.3 2. 1.1 0.4 0.05 0.2 0.4 1.8 1.05 0.3 3. 4. 5. 6. 1. 1. 1. 1. 1. 0.8", 0.1),
    (
        "IMKPinching @ 200. 0.04 0.15 0.3 2. 1.1 0.4 0.05 0.2 0.4 1.8 1.05 0.3 3. 4. 5. 6. 1. 1. 1. 1. 1. 0.8 0.4 0.6",
        0.1,
    ),
    (
        "ModIMKPeakOriented @ 200. 0.03 0.02 2. -1.8 3. 4. 3. 5. 1. 1. 1. 1. 0.04 0.05 0.15 0.2 0.3 0.4 0.5 0.5 1. 0.8 0.",
        0.1,
    ),
    (
        "ModIMKPinching @ 200. 0.03 0.02 2. -1.8 0.4 0.5 0.3 3. 4. 3. 5. 1. 1. 1. 1. 0.04 0.05 0.15 0.2 0.3 0.4 0.5 0.5 1. \
         0.8 5.",
        0.1,
    ),
    ("HystereticSmooth @ 200. 10. 2. 6.", 0.1),
    ("HystereticAsym @ 200. 10. 2. 9. 4. 1.5", 0.1),
    ("HystereticPoly @ 200. 10. 20. 50. 200. 1e-12", 0.1),
    ("BWBN @ 0.1 1000. 1.7 15. 25. 1. 0.4 0.9 0.5 0.4 0.05 0.3 1e-12 500", 0.2),
    ("HDR_mat @ 46. 59. 317. 1.04 0.38 30. 0.71 3.4 0.37 0.06 0.57 121. 1.8 0.9 0.32 0.14 0.018 0.15", 0.2),
    ("SMA @ 200. 0.04 2. 2.6 1.5 0.8", 0.1),
    ("Ratchet @ 200. 0.02 0.01 1", 0.1),
    ("Ratchet @ 200. 0.02 0.01 2", 0.1),
    ("SAWS @ 2. 0.3 0.07 200. 0.06 -0.08 1.1 0.02 0.8 1.1", 0.1),
    ("PySimple1 @ 1 2. 0.01 0.3", 0.1),
    ("TzSimple1 @ 2 2. 0.01", 0.1),
    ("QzSimple1 @ 2 2. 0.01 0.05", 0.1),
    ("HyperbolicGapMaterial @ 200. 180. 0.7 -3. -0.02", 0.1),
    ("SelfCentering @ 200. 10. 2. 0.7 0.06 0.09 0.4", 0.12),
    ("Viscous @ 5. 0.7", 0.1),
    ("ViscousDamper @ 200. 5. 0.7", 0.1),
    ("CoulombDamper @ 200. 3. -tol 4.", 0.1),
    ("ViscoelasticGap @ 200. 2. -0.02", 0.1),
    ("LimitState @ 2. 0.01 3. 0.03 2.5 0.08 -1.5 -0.008 -2.5 -0.05 -2.6 -0.09 0.6 0.3 0.01 0.005 0.4", 0.1),
    ("LimitState @ 2. 0.01 3. 0.03 -1.5 -0.008 -2.5 -0.05 0.6 0.3 0. 0.", 0.1),
    ("Maxwell @ 200. 5. 0.7 1.", 0.1),
    ("AxialSp @ 6e5 1e3 -1e5 0.1 0.01 0.5", 0.01),
    ("AxialSpHD @ 6e5 1e3 -1e5 0.1 0.01 0.05 0.5 0. 1.5", 0.01),
    ("KikuchiAikenHDR @ X0.6 4e-4 0.15 -coGHU 2. 0.8 1.12", 0.3),
    ("KikuchiAikenLRB @ 1 3e-4 0.15 0.392e6 1e-5 8.33e6 0.588e6 13.", 0.3),
    ("ImpactMaterial @ 200. 50. -0.01 -0.02", 0.1),
    ("HertzDamp @ 200. 0.3 -0.02", 0.1),
    ("JankowskiImpact @ 200. 0.3 1. -0.02", 0.1),
    ("HDRRheology @ 0.4 0.05 0.01 0.2 3. 0.9 0.1 0.4 0.3 0.2 -mullins 0.6 0.2", 1.0),
    ("Mullins @ 11 0.5 0.03", 0.1),
    ("Parallel @ 11 12 -factors 2. 0.5", 0.1),
    ("Series @ 11 13", 0.1),
    ("MinMax @ 11 -min -0.09 -max 0.095", 0.1),
    ("Fatigue @ 11 -E0 0.5", 0.1),
    ("InitStrainMaterial @ 11 0.013", 0.1),
    ("InitStressMaterial @ 11 -1.7", 0.1),
];

/// Duration of a step, s.
const DT: f64 = 0.01;

/// Nodes of a spring with one material, and its commands.
pub fn spring_words(words: &str) -> (String, String) {
    let words = words.replacen('@', "1", 1);
    let nodes = "model basic -ndm 1 -ndf 1\nnode 1 0\nnode 2 0\n".to_owned();
    (nodes, format!("uniaxialMaterial {words}\nelement zeroLength 1 1 2 -mat 1 -dir 1\n"))
}

/// A spring with one material.
fn spring(words: &str) -> SingleElement {
    let (nodes, commands) = spring_words(words);
    SingleElement::of(
        run(&format!("{nodes}{PARTS}{commands}")).done().interp.host.engine.model().elements[0].element.clone(),
    )
}

/// Force at the end of a step to `u`, and its derivative with respect to `u` at the rate of the step.
fn step(e: &mut SingleElement, next: &mut [f64], u: f64, from: f64) -> (f64, f64) {
    let (mut force, mut tangent, mut damping) = ([0.0; 2], [0.0; 4], [0.0; 4]);
    let (disp, vel) = ([0.0, u], [0.0, (u - from) / DT]);
    let motion = ElementInput {
        disp: &disp,
        vel: &vel,
        accel: &[],
        load: &[],
        still: false,
        opensees: None,
        dt: DT,
        time: 1.0,
        dynamic: true,
    };
    let response = ElementOutput {
        force: &mut force,
        tangent: Some(&mut tangent),
        damping: Some(&mut damping),
        part: MatrixMask::ALL,
    };
    e.element.respond(&motion, &mut Histories { committed: &e.state, trial: next }, response).unwrap();
    (force[1], tangent[3] + damping[3] / DT)
}

/// A pseudo-random path with the rates of its steps; an influence of trials would show in the difference.
#[test]
fn every_material_has_a_consistent_tangent() {
    let mut wrong = vec![];
    for (words, amplitude) in MATERIALS {
        let mut e = spring(words);
        let mut next = e.state.clone();
        let mut initial = [0.0; 4];
        e.element.initial_tangent(&mut initial);
        let stiff = initial[3].abs();
        let (mut from, mut tested) = (0.0, 0);
        for (k, u) in path(7, 1200, *amplitude).into_iter().enumerate() {
            let h = 1e-6 * amplitude;
            let mut at = |x: f64| step(&mut e, &mut next, x, from).0;
            let [far_down, down, up, far_up] = [-2.0, -1.0, 1.0, 2.0].map(|n| at(u + n * h));
            let (near, far) = ((up - down) / (2.0 * h), (far_up - far_down) / (4.0 * h));
            let (force, tangent) = step(&mut e, &mut next, u, from);
            // There is no derivative at kinks; differences that depend on their step size identify them.
            let scale = near.abs().max(1e-3 * force.abs() / amplitude).max(1e-5 * stiff).max(1e-9);
            if (near - far).abs() < 1e-4 * scale && (up - 2.0 * force + down).abs() < 1e-4 * h * scale {
                tested += 1;
                if (tangent - near).abs() > 2e-3 * scale {
                    wrong.push(format!("{words}, step {k}: tangent {tangent} but {near}"));
                    break;
                }
            }
            e.state.copy_from_slice(&next);
            from = u;
        }
        if tested < 200 {
            wrong.push(format!("{words}: only {tested} points away from kinks"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Dimensions, degrees of freedom per node, shape, and words of an element, with @ for tag and nodes.
pub const ELEMENTS: &[(usize, usize, Shape, &str)] = &[
    (2, 3, Shape::Line, "elasticBeamColumn @ 0.02 200. 0.5 1"),
    (3, 6, Shape::Line, "elasticBeamColumn @ 0.02 200. 80. 0.3 0.4 0.5 2"),
    (2, 3, Shape::Line, "elasticBeamColumn @ 0.02 200. 0.5 3"),
    (3, 6, Shape::Line, "elasticBeamColumn @ 0.02 200. 80. 0.3 0.4 0.5 4"),
    (2, 3, Shape::Line, "ModElasticBeam2d @ 0.02 200. 0.5 4. 4. 2. 1"),
    (3, 6, Shape::Line, "ModElasticBeam3d @ 0.02 200. 80. 0.3 0.4 0.5 4. 4. 2. 4. 4. 2. 2"),
    (2, 3, Shape::Link, "componentElement2d @ 0.02 200. 0.5 1 11 11"),
    (2, 3, Shape::Line, "ElasticTimoshenkoBeam @ 200. 80. 0.02 0.5 0.015 1"),
    (3, 6, Shape::Line, "ElasticTimoshenkoBeam @ 200. 80. 0.02 0.3 0.4 0.5 0.015 0.01 2"),
    (2, 2, Shape::Line, "truss @ 0.02 11"),
    (3, 3, Shape::Line, "truss @ 0.02 11"),
    (2, 3, Shape::Line, "corotTruss @ 0.02 11"),
    (3, 3, Shape::Line, "corotTruss @ 0.02 11"),
    (2, 2, Shape::Line, "trussSection @ 21"),
    (3, 3, Shape::Line, "corotTrussSection @ 21"),
    (2, 3, Shape::Link, "twoNodeLink @ -mat 11 13 11 -dir 1 2 3 -shearDist 0.3"),
    (3, 6, Shape::Link, "twoNodeLink @ -mat 11 13 11 13 11 13 -dir 1 2 3 4 5 6 -orient 0. 1. 0.5 -shearDist 0.3 0.6"),
    (2, 3, Shape::MaterialPoint, "zeroLength @ -mat 11 13 11 -dir 1 2 6 -orient 1. 2. 0. -2. 1. 0."),
    (3, 6, Shape::MaterialPoint, "zeroLength @ -mat 11 13 11 13 11 13 -dir 1 2 3 4 5 6 -orient 1. 2. 0.5 -2. 1. 0."),
    (3, 6, Shape::MaterialPoint, "CoupledZeroLength @ 1 3 11"),
    (3, 3, Shape::MaterialPoint, "zeroLengthImpact3D @ 2 0.0 0.3 80. 200. 40. 0.01 0.02"),
    (2, 2, Shape::MaterialPoint, "zeroLengthContact2D @ 200. 80. 0.37 -normal 0.6 0.8"),
    (2, 3, Shape::MaterialPoint, "zeroLengthContact2D @ 200. 80. 0.37 -normal 0. -1."),
    (3, 3, Shape::MaterialPoint, "zeroLengthContact3D @ 200. 80. 0.37 0.2 1"),
    (2, 3, Shape::MaterialPoint, "zeroLengthSection @ 22"),
    (3, 6, Shape::MaterialPoint, "zeroLengthSection @ 24"),
    (2, 3, Shape::Line, "dispBeamColumn @ 4 22 1"),
    (2, 3, Shape::Line, "AxEqDispBeamColumn2d @ 4 22 3 1e-12"),
    (2, 3, Shape::Line, "AxEqDispBeamColumn2d @ 3 22 1 1e-12 -integration Lobatto -iter 30"),
    (2, 3, Shape::Link, "ElasticTubularJoint @ 0.3 60. 2e8 0.6 0.02 20."),
    (3, 6, Shape::Line, "dispBeamColumn @ 4 24 2"),
    (2, 3, Shape::Line, "forceBeamColumn @ 5 22 3"),
    (3, 6, Shape::Line, "forceBeamColumn @ 5 24 4"),
    (2, 3, Shape::Line, "forceBeamColumnCBDI @ 5 22 3"),
    (3, 6, Shape::Line, "forceBeamColumnCBDI @ 4 24 2"),
    (2, 3, Shape::Line, "forceBeamColumnCSBDI @ 5 23 1"),
    (2, 3, Shape::Link, "forceBeamColumnCBDI @ 5 22 5"),
    (3, 6, Shape::Link, "forceBeamColumnCBDI @ 4 24 6"),
    (2, 3, Shape::Line, "mixedBeamColumn @ 5 22 3"),
    (2, 3, Shape::Line, "mixedBeamColumn @ 2 22 1"),
    (3, 6, Shape::Line, "mixedBeamColumn @ 4 24 4"),
    (2, 3, Shape::Line, "beamWithHinges @ 22 0.1 22 0.1 200. 0.06 0.00045 1"),
    (2, 2, Shape::Corners, "quad @ 0.3 PlaneStrain 31"),
    (2, 2, Shape::Corners, "bbarQuad @ 0.3 31"),
    (2, 2, Shape::Corners, "SSPquad @ 31 PlaneStrain 0.3"),
    (2, 2, Shape::Triangle, "tri31 @ 0.3 PlaneStress 31"),
    (3, 6, Shape::Corners, "ShellMITC4 @ 42"),
    (3, 6, Shape::Corners, "ShellMITC4 @ 43"),
    (3, 6, Shape::Corners, "ShellDKGQ @ 43"),
    (3, 6, Shape::Corners, "ShellNLDKGQ @ 43"),
    (3, 6, Shape::Triangle, "ShellDKGT @ 43"),
    (3, 6, Shape::Corners, "ASDShellQ4 @ 43"),
    (3, 6, Shape::Corners, "ASDShellQ4 @ 43 -noeas -drillingStab 0.3 -local 1. 1. 0."),
    (3, 6, Shape::Corners, "ASDShellQ4 @ 43 -corotational -drillingNL"),
    (3, 6, Shape::Triangle, "ASDShellT3 @ 43 -local 0. 1. 0.3"),
    (3, 6, Shape::Triangle, "ASDShellT3 @ 43 -corotational -reducedIntegration -drillingNL"),
    (2, 2, Shape::Quadratic(9), "quad9n @ 0.2 PlaneStrain 31"),
    (2, 2, Shape::Quadratic(8), "quad8n @ 0.2 PlaneStress 31"),
    (2, 2, Shape::Quadratic(6), "tri6n @ 0.2 PlaneStrain 31"),
    (2, 2, Shape::Corners, "enhancedQuad @ 0.2 PlaneStress 31"),
    (3, 3, Shape::Brick, "stdBrick @ 31"),
    (3, 3, Shape::Brick, "bbarBrick @ 31"),
    (3, 3, Shape::Brick, "SSPbrick @ 31"),
    (
        2,
        3,
        Shape::Wall,
        "MVLEM 1 2. 1 2 3 0.4 -thick 0.2 0.1 0.3 -width 0.3 0.4 0.2 -rho 0.02 0.1 0.03 -matConcrete 11 13 11 -matSteel 13 11 13 \
         -matShear 11",
    ),
    (2, 3, Shape::Wall, "SFI_MVLEM @ 3 0.4 -thick 0.2 0.1 0.3 -width 0.3 0.4 0.2 -mat 35 35 35"),
    (2, 3, Shape::Wall, "E_SFI @ 3 0.4 -thick 0.2 0.1 0.3 -width 0.3 0.4 0.2 -mat 35 35 35"),
    (3, 6, Shape::SpaceWall, "SFI_MVLEM_3D @ 3 -thick 0.2 0.1 0.3 -width 0.3 0.4 0.2 -mat 35 35 35"),
    (
        3,
        6,
        Shape::SpaceWall,
        "E_SFI_MVLEM_3D @ 3 -thick 0.2 0.1 0.3 -width 0.3 0.4 0.2 -mat 35 35 35 -Eave 150. -CoR 0.5",
    ),
    (
        3,
        6,
        Shape::SpaceWall,
        "MVLEM_3D @ 3 -thick 0.2 0.1 0.3 -width 0.3 0.4 0.2 -rho 0.02 0.1 0.03 -matConcrete 11 13 11 -matSteel 13 11 13 \
         -matShear 11 -ThickMod 0.8 -Poisson 0.1",
    ),
    (3, 3, Shape::Tetrahedron(4), "FourNodeTetrahedron @ 36"),
    (3, 3, Shape::Tetrahedron(10), "TenNodeTetrahedron @ 36"),
    // Plastic continua.
    (2, 2, Shape::Corners, "quad @ 0.5 PlaneStress 36"),
    (2, 2, Shape::Corners, "quad @ 0.5 PlaneStrain 37"),
    (2, 2, Shape::Corners, "bbarQuad @ 0.5 36"),
    (2, 2, Shape::Corners, "SSPquad @ 36 PlaneStrain 0.5"),
    (2, 2, Shape::Corners, "quad @ 0.5 PlaneStress 35"),
    (2, 2, Shape::Triangle, "tri31 @ 0.5 PlaneStress 37"),
    (2, 2, Shape::Quadratic(9), "quad9n @ 0.5 PlaneStrain 36"),
    (2, 2, Shape::Quadratic(6), "tri6n @ 0.5 PlaneStress 38"),
    (3, 3, Shape::Brick, "bbarBrick @ 36"),
    (3, 3, Shape::Brick, "SSPbrick @ 37"),
    (3, 3, Shape::Brick, "stdBrick @ 39"),
    (3, 3, Shape::Brick, "stdBrick @ 51"),
    (2, 2, Shape::Corners, "quad @ 0.5 PlaneStress 51"),
    (3, 3, Shape::Brick, "stdBrick @ 52"),
    (2, 3, Shape::Link, "dispBeamColumn @ 4 61 1"),
    (2, 3, Shape::MaterialPoint, "zeroLengthSection @ 61"),
    (3, 6, Shape::MaterialPoint, "zeroLengthSection @ 62"),
    (2, 3, Shape::MaterialPoint, "zeroLengthSection @ 63"),
    (3, 6, Shape::Corners, "ShellMITC4 @ 45"),
    (2, 3, Shape::Panel, "beamColumnJoint @ 11 13 11 13 11 13 11 13 11 13 11 13 11"),
    (2, 3, Shape::Panel, "beamColumnJoint @ 11 11 13 11 11 13 11 11 13 11 11 13 11 0.8 0.9"),
    (3, 6, Shape::Panel, "beamColumnJoint @ 11 13 11 13 11 13 11 13 11 13 11 13 11"),
    (2, 3, Shape::Joint, "Joint2D @ 9 11 13 11 13 11 0"),
    (3, 3, Shape::Cable, "CatenaryCable @ -0.1 200. 1. 2. 0.001 10. 0.1 1e-10 1 0"),
    (3, 3, Shape::Cable, "CatenaryCable @ -0.5 200. 1. 1.45 0. 0. 0. 1e-10 3 3"),
];

pub fn script(ndm: usize, ndf: usize, places: &[Vector3<f64>]) -> String {
    node_words(ndm, ndf, places) + &parts(ndm)
}

pub fn element(&(ndm, ndf, shape, words): &(usize, usize, Shape, &str)) -> (SingleElement, Vec<Vector3<f64>>) {
    let mut places = nodes(ndm, shape);
    let made = element_words(words, places.len());
    let ran = run(&format!("{}{made}", script(ndm, ndf, &places))).done();
    if shape == Shape::SpaceWall {
        // The element takes its upper nodes from the left.
        places.swap(2, 3);
    }
    (SingleElement::of(ran.interp.host.engine.model().elements[0].element.clone()), places)
}

/// Material with a stress at rest, the last word of an element.
const INITIAL_STRESS: &str = " 52";

#[test]
fn every_element_has_no_force_in_rigid_motion() {
    for row in ELEMENTS.iter().filter(|row| row.2 != Shape::Cable && !row.3.ends_with(INITIAL_STRESS)) {
        let (mut e, places) = element(row);
        // The rotation is so small that its nonlinear part is round-off.
        let (shift, spin) = (Vector3::new(0.3, -0.2, 0.1), Vector3::new(2e-9, -3e-9, 4e-9));
        let mut u = rigid(&places, (row.0, row.1), shift, spin);
        if row.2 == Shape::Joint {
            u.extend([shift.x, shift.y, spin.z, spin.z]);
        }
        let (force, k) = e.trial(&u, &vec![0.0; u.len()]);
        let stiff = k.iter().fold(0.0f64, |m, x| m.max(x.abs()));
        assert!(force.iter().all(|f| f.abs() < 1e-12 * stiff), "{}: {force:?}", row.3);
    }
}

/// Tangent at states beyond yield.
#[test]
fn every_element_has_a_consistent_tangent() {
    for row in ELEMENTS {
        let (mut e, places) = element(row);
        // The centre of a joint has four degrees of freedom.
        let n = row.1 * places.len() + if row.2 == Shape::Joint { 4 } else { 0 };
        let walks: Vec<Vec<f64>> = (0..n).map(|i| path(3 + i as u64, 40, 0.03)).collect();
        let mut smooth = 0;
        // At rest a contact closes.
        for k in 1..40 {
            let u: Vec<f64> = walks.iter().map(|w| w[k]).collect();
            let (_, tangent) = e.trial(&u, &vec![0.0; n]);
            let (near, far) = (e.difference(&u, 1e-7), e.difference(&u, 2e-7));
            // There is no derivative where fibers yield or reverse; differences that depend on their step size
            // identify these states.
            if difference(&near, &far) < 1e-5 {
                smooth += 1;
                // The corotational beam in space takes the mean of the nodes' axes: see `corotational`.
                let tolerance = if row.3.ends_with(" 4") { 5e-3 } else { 1e-5 };
                let error = difference(&tangent, &near);
                assert!(error < tolerance, "{}, step {k}: {error:.1e}", row.3);
            }
            e.trial(&u, &vec![0.0; n]);
            e.commit();
        }
        assert!(smooth > 10, "{}: only {smooth} steps away from kinks", row.3);
    }
}

/// Two elements of unequal length in series equal one under uniform extension and bending.
#[test]
fn every_line_element_passes_the_patch_test() {
    // The tolerance of force-based beams is too coarse here; `sections` compares them with the elastic beam.
    let direct =
        |words: &str| !["forceBeam", "mixedBeam", "beamWith", "AxEq"].iter().any(|kind| words.starts_with(kind));
    for &(ndm, ndf, shape, words) in ELEMENTS.iter().filter(|row| row.2 == Shape::Line && direct(row.3)) {
        let ends = nodes(ndm, shape);
        let along = (ends[1] - ends[0]).normalize();
        let tip = |places: &[Vector3<f64>]| -> Vec<f64> {
            let last = places.len();
            let elements: String = (1..last)
                .map(|i| format!("element {}\n", words.replacen('@', &format!("{i} {i} {}", i + 1), 1)))
                .collect();
            // Degrees of freedom without stiffness in bars.
            let across = match (ndm, ndf) {
                (_, n) if words.to_lowercase().contains("truss") => {
                    let held: Vec<&str> = (0..n).map(|d| if d == 0 { "0" } else { "1" }).collect();
                    (2..=last).map(|i| format!("fix {i} {}\n", held.join(" "))).collect()
                }
                _ => String::new(),
            };
            let mut load: Vec<f64> = along.iter().take(ndm).map(|x| 1e-6 * x).collect();
            let moment = 2e-8 * if ndm == 3 { along.cross(&Vector3::z()).normalize() } else { Vector3::z() };
            match (ndm, ndf) {
                (2, 3) => load.push(moment.z),
                (3, 6) => load.extend(moment.iter()),
                _ => {}
            }
            let load: Vec<String> = load.iter().map(ToString::to_string).collect();
            let held = vec!["1"; ndf].join(" ");
            let ran = run(&format!(
                "{}{elements}{across}fix 1 {held}\ntimeSeries Linear 1\npattern Plain 1 1 {{ load {last} {} }}
                test FixedNumIter 8\nalgorithm Newton\nintegrator LoadControl 1.\nanalysis Static\nanalyze 1\nputs [nodeDisp {last}]",
                script(ndm, ndf, places),
                load.join(" "),
            ));
            ran.done().numbers()
        };
        let middle = ends[0] + 0.37 * (ends[1] - ends[0]);
        let (one, two) = (tip(&ends), tip(&[ends[0], middle, ends[1]]));
        assert!(one.iter().any(|u| u.abs() > 1e-10), "{words}: {one:?}");
        assert!(difference(&one, &two) < 1e-6, "{words}: {one:?} and {two:?}");
    }
}

#[test]
fn every_kind_is_in_a_table() {
    let first = |words: &str| words.split_whitespace().next().unwrap_or_default().to_lowercase();
    let materials: Vec<String> = MATERIALS.iter().map(|(words, _)| first(words)).collect();
    for kind in kinds("uniaxialMaterial") {
        assert!(materials.contains(&kind.names[0].to_lowercase()), "no row for {}", kind.usage);
    }
    let elements = ELEMENTS.iter().map(|row| first(row.3));
    // `links` has the tests of an inerter, which has no stiffness.
    let all: Vec<String> = elements.chain(every_bearing::commands().map(first)).chain(["inerter".to_owned()]).collect();
    for kind in kinds("element") {
        assert!(all.contains(&kind.names[0].to_lowercase()), "no row for {}", kind.usage);
    }
}
