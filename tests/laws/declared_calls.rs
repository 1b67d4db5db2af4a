//! A call of each command and kind that declares numbers, and the model that it is made in.

use super::every_bearing;
use super::every_kind::{ELEMENTS, MATERIALS};
use super::parts;
use super::shapes::{element_words, nodes};
use hysteron::opensees::{AMENDMENTS, AmendmentOption};

/// A call, in a model of some dimensions and degrees of freedom per node.
pub struct Call {
    pub ndm: usize,
    pub ndf: usize,
    pub words: String,
}

/// Places of the nodes.
const PLACES: [[f64; 3]; 11] = [
    [0.0, 0.0, 0.0],
    [1.1, 0.1, 0.2],
    [1.3, 0.9, 0.1],
    [-0.1, 0.8, 0.0],
    [0.0, 0.0, 1.0],
    [1.1, 0.1, 1.2],
    [1.3, 0.9, 1.1],
    [-0.1, 0.8, 1.0],
    [2.0, 2.0, 2.0],
    [3.0, 3.0, 3.0],
    [0.0, 1.2, 0.0],
];

/// Nodes, and what the calls name.
pub fn context(ndm: usize, ndf: usize) -> String {
    let mut out = format!("model basic -ndm {ndm} -ndf {ndf}\n");
    for (i, place) in PLACES.iter().enumerate() {
        let words: Vec<String> = place[..ndm].iter().map(ToString::to_string).collect();
        out += &format!("node {} {}\n", i + 1, words.join(" "));
    }
    out += parts::PARTS;
    out += every_bearing::PARTS;
    let (vector, more, stiffness) = if ndm == 3 { (" 0.3 0.5 1", " 0.1 80. 0.1", "-GJ 50. ") } else { ("", "", "") };
    if ndm > 1 {
        (1..=6).for_each(|i| out += &format!("geomTransf Linear {i}{vector}\n"));
    }
    let fibres = format!("{stiffness}{{ patch rect 11 6 4 -0.15 -0.1 0.15 0.1 }}");
    out += &format!(
        "nDMaterial ElasticIsotropic 31 200. 0.3\nnDMaterial ElasticIsotropic 1 200. 0.3\nsection Elastic 1 200. 0.1 0.1{more}
section Uniaxial 21 13 P\ntimeSeries Linear 1\ntimeSeries Linear 2
uniaxialMaterial ConcreteCM 14 -6. -0.06 200. 7. 1.035 0.8 0.008 1.2 1e4
nDMaterial J2Plasticity 36 166.7 76.9 2. 3. 12. 3.\nnDMaterial FSAM 35 0. 11 11 14 0.05 0.04 0.5 0.01
section Aggregator 23 13 Vy -section 1\nsection Fiber 22 {fibres}\nsection Fiber 24 {fibres}\n"
    );
    if ndm == 3 {
        out += "section PlateFiber 42 36 0.2\nsection ElasticMembranePlateSection 43 200. 0.3 0.1 1.\n";
    }
    out + "pset p 1.\nelement zeroLength 1 5 6 -mat 13 -dir 1\npattern Plain 1 1 {}\n"
}

/// The calls: of every material, element and bearing, and those below.
pub fn calls() -> Vec<Call> {
    let of_materials =
        MATERIALS.iter().map(|(words, _)| (2, 3, format!("uniaxialMaterial {}", words.replacen('@', "77", 1))));
    let of_elements = ELEMENTS.iter().map(|&(ndm, ndf, shape, words)| {
        let made = element_words(words, nodes(ndm, shape).len());
        (ndm, ndf, made.trim_end().to_owned())
    });
    let of_bearings = every_bearing::commands().flat_map(|words| {
        let in_space = (3, 6, format!("element {}", words.replace('@', "0 0 1 1 0 0")));
        [in_space, (2, 3, format!("element {words}"))]
    });
    let of_amendments = AMENDMENTS.iter().filter(|kind| !kind.options.is_empty()).map(|kind| {
        let option =
            |o: &AmendmentOption| format!(" {} {}", o.arg.option, o.default.filter(|x| x.is_finite()).unwrap_or(0.5));
        (2, 3, format!("amend element 1 {}{}", kind.name, kind.options.iter().map(option).collect::<String>()))
    });
    let others = CALLS.iter().map(|(ndm, ndf, words)| (*ndm, *ndf, (*words).to_owned()));
    let all = of_materials.chain(of_elements).chain(of_bearings).chain(of_amendments).chain(others);
    all.map(|(ndm, ndf, words)| Call { ndm, ndf, words }).collect()
}

/// Further calls, with dimensions and degrees of freedom per node of their model.
const CALLS: &[(usize, usize, &str)] = &[
    (2, 3, "algorithm BFGS -initial -count 0.3"),
    (2, 3, "algorithm Broyden -count 1001"),
    (2, 3, "algorithm ExpressNewton 0.3 0.3 -initialTangent"),
    (2, 3, "algorithm KrylovNewton -maxDim 2000000000"),
    (2, 3, "algorithm NewtonLineSearch -type InitialInterpolated -tol 0.3 -maxIter 0.3 -minEta 0.3 -maxEta 0.3"),
    (2, 3, "amend element 1 bristles -force 5. -stiffness 1000."),
    (2, 3, "amend element 1 pressure -reference 1. -axialSeries 9"),
    (2, 3, "amend element 1 creep -compliance 0.001 -time 1."),
    (2, 3, "amend element 1 relaxation -strength 0.5 -time 1."),
    (2, 3, "amend element 1 sliding -force 5. -speed 0.0075"),
    (2, 3, "amend element 1 stiffening -factor 400. -from 0.01 -power 1."),
    (2, 3, "amend element 1 temperature -softening 0.01 -at 0 -reference 0 -share 500 0"),
    (2, 3, "amend element 1 yielding -hardening 0.1"),
    (2, 3, "block2D 4 3 1 1 quad {0.5 PlaneStress 1} {1 0 0 2 4 0 3 4 2 4 0 2 9 2.2 1.1}"),
    (3, 6, "block3D 2 3 2 1 1 stdBrick {1 0 0 0} {1 0 0 0 2 2 0 0 3 2 3 0 4 0 3 0 5 0 0 1 6 2 0 1 7 2 3 1 8 0 3 1}"),
    (2, 3, "constraints Penalty 1e8 0"),
    (2, 3, "damping SecStif 1 0.01"),
    (2, 3, "damping URD 3 3 0.5 0.03 5 0.05 50 0.04 -iter 100"),
    (2, 3, "damping URDbeta 4 3 0.5 0.03 5 0.05 50 0.04"),
    (2, 3, "damping Uniform 1 0.05 10. 1."),
    (2, 3, "element ElasticTimoshenkoBeam 1 1 2 2e4 8e3 0.1 0.01 0.05 1 -mass 0.3 -cMass -geomNonlinear"),
    (
        3,
        6,
        "element HDRRheologyBearing 1 1 2 1.2 2000. 0. 300. 2.3 5. 6 -compound HDR2 -ambient -20 -heatCapacity 3.0 -coolingTime 2000 -beyond hold -mullins 0.3 0.5 -heal 0.5 86400 -orient 0 0 1 1 0 0",
    ),
    (3, 6, "element MSS 1 1 2 8 -mat 1 -mass 0"),
    (3, 6, "element ModElasticBeam3d 1 1 2 0.02 2e5 8e4 2e-3 1e-3 3e-3 5.5 4.5 2.5 6 5 3 1 -mass 0.4 -cMass"),
    (
        3,
        6,
        "element RJWatsonEqsBearing 1 1 2 1 20000.0 -P 1 -Vy 5 -Vz 6 -T 2 -My 3 -Mz 4 -orient 0.1 0.2 1 1 0.3 0 -iter 60 1e-11 -shearDist 0.3",
    ),
    (3, 6, "element YamamotoBiaxialHDR 1 1 2 1 0.7 0.02 0.16 -coRS 1 0"),
    (3, 6, "element beamWithHinges 1 1 2 1 0.4 1 0.4 2e8 0.08 1.0667e-3 1"),
    (2, 3, "element componentElement2d 1 1 3 0.1 2e6 0.001 1 5 6 -rho 0.3"),
    (2, 3, "element corotTrussSection 77 1 2 3 21"),
    (2, 3, "element elasticBeamColumn 2 2 3 0.1 3e7 0.0005 1 -mass 0.3"),
    (3, 6, "element elasticBeamColumn 77 1 2 3 4 0.02 200. 80. 0.3 0.4 0.5 2"),
    (3, 6, "element flatSliderBearing 1 1 2 1 20000.0 -P 1 -T 2 -My 3 -Mz 4 -mass 3.0 -iter 60 1e-11 -shearDist 0.5"),
    (2, 3, "element forceBeamColumn 1 1 2 4 1 1 -iter 30 1e-12"),
    (
        3,
        6,
        "element inerter 3 1 2 -dir 1 2 3 5 -inertance 4 0.02 0 0 0.02 6 0.5 0 0 0.5 4 0 0 0 0 0.3 -orient 0 0 1 1 0.2 0 -pDelta 0.3 0.2 0.1 0.4 -doRayleigh -damp 4 0.1 0 0 0.1 8 1 0 0 1 6 0 0 0 0 0.2 -mass 1.5",
    ),
    (3, 6, "element multipleNormalSpring 1 1 2 20 -mat 1 -shape round -size 0.7 -lambda 20.0 -orient 0 0 1 0 1 0"),
    (2, 2, "element quad 1 1 2 5 4 0.4 PlaneStrain 1 3.0 0.002 0.5 -1.0"),
    (2, 2, "element quad8n 1 1 2 3 4 5 6 7 8 0.5 PlaneStress 1 0.2 0.0 0.1 -0.3"),
    (
        2,
        3,
        "element singleFPBearing 1 1 2 1 1.5 20000.0 -P 1 -Mz 3 -orient 0 1 0 -1 0 0 -mass 3.0 -iter 60 1e-11 -shearDist 0.5",
    ),
    (2, 2, "element tri31 3 4 5 7 0.4 PlaneStrain 1 3.0 0.002 0.5 -1.0"),
    (2, 3, "element trussSection 77 1 2 3 21"),
    (
        3,
        6,
        "element twoNodeLink 1 1 2 -mat 1 2 3 4 5 5 -dir 1 2 3 4 5 6 -orient 0 0 1 1 0 0 -pDelta 0.3 0.2 0.3 0.2 -shearDist 0.4 0.6 -mass 1.0",
    ),
    (2, 3, "equalDOF_Mixed 2 3 1 2 1"),
    (2, 3, "fiber 1 0 5 2"),
    (2, 3, "frictionModel Coulomb 1 0.05"),
    (2, 3, "frictionModel VelDependent 77 0.3 0.3 0.3"),
    (2, 3, "frictionModel VelNormalFrcDep 77 0.3 0.3 0.3 0.3 0.3 0.3 0.3 0.3"),
    (2, 3, "frictionModel VelPressureDep 1 0.03 0.09 0 0.02 1 1"),
    (2, 3, "hystereticBackbone Arctangent 32 2. 0.02 0.8"),
    (2, 3, "hystereticBackbone Arctangent 77 0.3 0.3"),
    (2, 3, "hystereticBackbone CementedSoil 40 2. 3. 40. 2. 4."),
    (2, 3, "hystereticBackbone Raynor 31 200. 2. 3. 0.02 0.2 3. 1."),
    (2, 3, "hystereticBackbone ReeseSand 34 400. 0.03 2. 0.2 3."),
    (2, 3, "hystereticBackbone ReeseSoftClay 36 3. 0.02 3."),
    (2, 3, "hystereticBackbone ReeseStiffClayAboveWS 38 4. 0.01"),
    (2, 3, "hystereticBackbone ReeseStiffClayBelowWS 77 0.3 0.3 0.3 0.3"),
    (2, 3, "hystereticBackbone VuggyLimestone 39 50. 2."),
    (2, 3, "hystereticBackbone WeakRock 77 0.3 0.3 0.3"),
    (2, 3, "integrator AlphaOS 0.3 0.3 0.3 -updateElemDisp"),
    (2, 3, "integrator AlphaOSGeneralized 0.3 0.3 0.3 0.3"),
    (2, 3, "integrator AlphaOSGeneralized 0.5"),
    (2, 3, "integrator AlphaOSGeneralized_TP 0.3"),
    (2, 3, "integrator AlphaOS_TP 0.3 0.3 0.3 -updateElemDisp"),
    (2, 3, "integrator ArcLength 0.3"),
    (2, 3, "integrator ArcLength1 0.3"),
    (2, 3, "integrator Collocation 0.3 0.3 0.3"),
    (2, 3, "integrator CollocationHSFixedNumIter 0.3 0.3 0.3 -polyOrder 1"),
    (2, 3, "integrator CollocationHSIncrLimit 0.3 0.3"),
    (2, 3, "integrator CollocationHSIncrReduct 0.3 0.3 0.3 0.3"),
    (2, 3, "integrator EQPath 1 9"),
    (2, 3, "integrator ExplicitBathe 0.3"),
    (2, 3, "integrator GeneralizedAlpha 0.3 0.3 0.3 0.3"),
    (2, 3, "integrator HHT 0.3 0.3 0.3"),
    (2, 3, "integrator HHTExplicit 0.3 0.3 -updateElemDisp"),
    (2, 3, "integrator HHTExplicit_TP 0.3 0.3"),
    (2, 3, "integrator HHTGeneralized 0.3"),
    (2, 3, "integrator HHTGeneralized 0.3 0.3 0.3 0.3 0.3"),
    (2, 3, "integrator HHTGeneralizedExplicit 0.3 0.3"),
    (2, 3, "integrator HHTGeneralizedExplicit 0.3 0.3 0.3 0.3 0.3"),
    (2, 3, "integrator HHTGeneralizedExplicit_TP 0.3 0.3"),
    (2, 3, "integrator HHTGeneralized_TP 0.3"),
    (2, 3, "integrator HHTHSFixedNumIter 0.3 0.3 0.3 0.3 -polyOrder 1"),
    (2, 3, "integrator HHTHSFixedNumIter_TP 0.3 0.3 0.3 0.3 -polyOrder 1"),
    (2, 3, "integrator HHTHSIncrLimit 0.3 0.3 0.3 0.3 0.3"),
    (2, 3, "integrator HHTHSIncrLimit_TP 0.3 0.3 0.3 0.3 0.3"),
    (2, 3, "integrator HHTHSIncrReduct 0.3 0.3 0.3 0.3 0.3"),
    (2, 3, "integrator HHTHSIncrReduct_TP 0.3 0.3 0.3 0.3 0.3"),
    (2, 3, "integrator HHT_TP 0.3 0.3 0.3"),
    (2, 3, "integrator HSConstraint 0.5 1.0 0.02 2.0"),
    (2, 3, "integrator KRAlphaExplicit 1.0"),
    (2, 3, "integrator KRAlphaExplicit_TP 0.3"),
    (2, 3, "integrator LoadControl 0.1 4 0.05 1.0"),
    (2, 3, "integrator MinUnbalDispNorm 0.3 0.3 0.3 0.3 -determinant"),
    (2, 3, "integrator Newmark 0.5 0.25"),
    (2, 3, "integrator Newmark1 0.3 0.3"),
    (2, 3, "integrator NewmarkExplicit 0.3"),
    (2, 3, "integrator NewmarkHSFixedNumIter 0.3 0.3 -polyOrder 1"),
    (2, 3, "integrator NewmarkHSIncrLimit 0.3 0.3 0.3"),
    (2, 3, "integrator NewmarkHSIncrReduct 0.3 0.3 0.3"),
    (2, 3, "integrator WilsonTheta 0.3"),
    (2, 3, "layer circ 2 5 0.3 0.2 0.1 0.0"),
    (2, 3, "mass 2 4.0"),
    (
        2,
        3,
        "nDMaterial ASDConcrete3D 77 0.3 0.3 -Te 0.3 -Ts 0.3 -Td 0.3 -Ce 0.3 -Cs 0.3 -Cd 0.3 -rho 0.3 -Kc 0.3 -eta 0.3 -cdf 0.3 -implex -implexControl 0.3 0.3 -implexAlpha 0.3 -tangent -autoRegularization 0.3",
    ),
    (2, 3, "nDMaterial ElasticIsotropic 1 200. 0.3 2.0"),
    (2, 3, "nDMaterial ElasticOrthotropic 77 0.3 0.3 0.3 0.3 0.3 0.3 0.3 0.3 0.3 0.3"),
    (2, 3, "nDMaterial FSAM 1 0. 1 1 2 0.01 0.02 1.0 0.01"),
    (2, 3, "nDMaterial J2BeamFiber 56 200. 0.3 2. 3. 5."),
    (2, 3, "nDMaterial J2Plasticity 36 166.7 76.9 2. 3. 12. 3."),
    (2, 3, "nDMaterial PlaneStressSimplifiedJ2 1 80. 160. 2. 1. 1."),
    (2, 3, "nDMaterial PlateFromPlaneStress 77 1 0.3"),
    (2, 3, "nDMaterial Series3D 77 1 1 -weights 0.3 0.3 -maxIter 0.3 -relTol 0.3 -absTol 0.3 -verbose"),
    (2, 3, "nDMaterial Simplified3DJ2 37 76.9 166.7 2. 4. 3."),
    (1, 1, "node 2 0 -mass 1.0"),
    (2, 3, "nodeEigenvector 2 1"),
    (2, 3, "patch circ 1 5 2 0.5 0.25 1. 2."),
    (2, 3, "section Bidirectional 77 0.3 0.3 0.3 0.3"),
    (3, 6, "section Elastic 77 0.3 0.3 0.3 0.3 0.3 0.3 0.3 0.3"),
    (2, 3, "section ElasticMembranePlateSection 77 0.3 0.3 0.3 0.3 0.3"),
    (2, 3, "section Elliptical 77 0.3 0.3 0.3 0.3 0.3 0.3 0.3"),
    (2, 3, "section Fiber 77 -GJ 0.3"),
    (2, 3, "section FrameElastic 1 2e8 0.1 1e-3 2e-3 8e7 3e-3 -Ay 0.05 -Az 0.05"),
    (2, 3, "section Isolator2spring 2 1e-10 16. 3.5 2. 930. 11. 1200. 10."),
    (2, 3, "section LayeredShell 45 3 36 0.05 37 0.1 36 0.05"),
    (2, 3, "section NDFiber 77 -noCentroid -alpha 0.3 {fibers}"),
    (2, 3, "section PlateFiber 77 1 0.3"),
    (2, 3, "section RCCircularSection 1 1 2 3 10. 1. 0.2 2 1 5 4"),
    (2, 3, "section RCSection2d 1 1 2 3 10. 6. 1. 0.3 0.4 0.1 3 2 4"),
    (2, 3, "section WFSection2d 9 1 1. 0.1 1. 0.1 10 100 2000000000 2"),
    (2, 3, "sectionDisplacement 1 1"),
    (2, 3, "setPrecision 0.3"),
    (2, 3, "test EnergyIncr 1e-16 50"),
    (2, 3, "test FixedNumIter 6"),
    (2, 3, "test NormDispAndUnbalance 0.3 0.3 0.3"),
    (2, 3, "test NormDispIncr 1e-9 80"),
    (2, 3, "test NormDispOrUnbalance 0.3 0.3 0.3"),
    (2, 3, "test NormUnbalance 1e-10 20"),
    (2, 3, "test RelativeEnergyIncr 0.3 0.3"),
    (2, 3, "test RelativeNormDispIncr 0.3 0.3"),
    (2, 3, "test RelativeNormUnbalance 0.3 0.3"),
    (2, 3, "test RelativeTotalNormDispIncr 0.3 0.3"),
    (2, 3, "timeSeries Path 2 -dt 0.1"),
    (2, 3, "timeSeries Pulse 77 0.3 0.3 0.3"),
    (2, 3, "timeSeries Trig 1 0 100 1.3"),
    (
        2,
        3,
        "uniaxialMaterial ASDConcrete1D 77 0.3 -fc 0.3 -ft 0.3 -Te 0.3 -Ts 0.3 -Td 0.3 -Ce 0.3 -Cs 0.3 -Cd 0.3 -implex -implexControl 0.3 0.3 -implexAlpha 0.3 -eta 0.3 -tangent -autoRegularization 0.3",
    ),
    (2, 3, "uniaxialMaterial BoucWenOriginal 77 200. 2. 0.05 0.02 3. 2. 0.6 0.4"),
    (
        2,
        3,
        "uniaxialMaterial ConfinedConcrete01 44 C 30. 26000. -scott -nu 0.2 300. 10. 100. 300. 206000. 0. 1000. 16. -gravel",
    ),
    (2, 3, "uniaxialMaterial Dodd_Restrepo 77 0.3 0.3 0.3 0.3 0.3 0.3 0.3 0.3 0.3"),
    (
        2,
        3,
        "uniaxialMaterial HDRRheology 5 -compound HDR3 -ambient 0 -area 100 -height 0.1 -heatCapacity 3 -mullins 0.3 0.5",
    ),
    (2, 3, "uniaxialMaterial KikuchiAikenHDR 2 1 0.5 1 -coMSS 1"),
    (2, 3, "uniaxialMaterial KikuchiAikenLRB 2 1 0.385 0.14 0.392e6 0.0177 8.33e6 0.588e6 13.0 -coKQ 1.1 0.9"),
    (
        2,
        3,
        "uniaxialMaterial KikuchiAikenLRB 4 1 0.385 0.14 0.392e6 0.0177 8.33e6 0.588e6 13.0 -T 0.0 -coMSS 0.25 0.25",
    ),
    (2, 3, "uniaxialMaterial Mullins 77 1 0.3 0.3 -power 0.3 -heal 0.3 0.3 -preload 0.3"),
    (2, 3, "uniaxialMaterial PySimple1 2 2 50. 0.02 0.1 20."),
    (2, 3, "uniaxialMaterial Series 77 1 1 -iter 0.3 0.3"),
    (2, 3, "uniaxialMaterial TzSimple1 3 1 25. 0.006 20."),
    (2, 3, "amend parameter p -factor 2."),
    (2, 3, "fixX 0. 1 1 1 -tol 0.1"),
    (
        2,
        3,
        "uniaxialMaterial ConfinedConcrete01 77 S1 -30. 26000. -gamma 0.5 -varub 300. 10. 100. 300. 206000. 0. 1000. 16. -tol 0.1 -maxNumIter 10 -epscuLimit 0.02",
    ),
    (
        2,
        3,
        "uniaxialMaterial ConfinedConcrete01 77 S4a -30. 26000. -scott -varub 300. 200. 100. 10. 100. 300. 206000. 0. 1000. 16.",
    ),
    (2, 3, "uniaxialMaterial SteelDRC 77 2e5 400. 0.12 600. 0.01 -Psh 3."),
    (2, 3, "uniaxialMaterial BarSlip 77 30. 450. 200000. 600. 4000. 20. 400. 4 400. 400. 0.5 strong beamTop"),
    (2, 3, "uniaxialMaterial BoucWenOriginal 77 200. 2. 0.05 0.02 3. 2. 0.6 0.4 1e-8 20"),
    (2, 3, "uniaxialMaterial QzSimple1 77 2 2. 0.01 0.05 0.1"),
    (2, 3, "uniaxialMaterial ViscousDamper 77 200. 5. 0.7 0. 1 1e-6 1e-10 15"),
    (2, 3, "uniaxialMaterial KikuchiAikenHDR 77 X0.6 4e-4 0.15 -coMSS 1. 0.5"),
    (
        2,
        3,
        "uniaxialMaterial HDRRheology 77 0.4 0.05 0.01 0.2 3. 0.9 0.1 0.4 0.3 0.2 -linear 1. -heatCapacity 3. -coolingTime 100. -mullins 0.6 0.2 -heal 0.5 86400. -preload 0.1",
    ),
    (
        2,
        3,
        "uniaxialMaterial HDRRheology 77 0.4 0.05 0.01 0.2 3. 0.9 0.1 0.4 0.3 0.2 -conduction 20 0.01 0.003 0.02 0.2 2. 50. 4. 10.",
    ),
    (2, 3, "uniaxialMaterial Series 77 11 13 -iter 10 1e-6"),
    (2, 3, "limitCurve Shear 77 1 0.01 4000. 10. 10. 9. 20. -100. 5. 2 1 1 2 1 2 0."),
    (2, 3, "limitCurve Axial 77 1 20. -100. 5. 2 1 1 2 1 2"),
    (2, 3, "limitCurve RotationShearCurve 77 1 1 2 3 20. 5. -100. 0.02"),
    (2, 3, "frictionModel VelPressureDep 77 0.03 0.1 0.2 0.03 4e-4 20."),
    (2, 3, "section WFSection2d 77 11 10. 0.5 6. 0.8 20 4 2 2 -GJ 1."),
    (2, 3, "section RCCircularSection 77 11 11 11 20. 2. 0.5 4 2 8 8 -GJ 1."),
    (3, 6, "section LayeredShell 77 3 36 0.3"),
    (2, 3, "element ModElasticBeam2d 77 1 2 0.1 200. 0.1 4. 4. 2. 1 -rho 0.1"),
    (2, 3, "element componentElement2d 77 1 2 0.02 200. 0.5 1 -stiffness 1. 1."),
    (
        2,
        3,
        "element elastomericBearingBoucWen 77 1 2 2000. 40. 0.1 0.01 3. 2. 0.6 0.4 -P 1 -Mz 4 -mass 1. -iter 10 1e-6",
    ),
    (2, 3, "element elastomericBearingPlasticity 77 1 2 2000. 40. 0.1 0.01 2.5 -P 1 -Mz 4 -mass 1."),
    (
        3,
        6,
        "element HDR 77 1 2 700. 2e6 0. 0.6 0.003 0.008 20 1300. -1200. 4000. 25. 300. 30. 0.5 0.5 0.4 3. 0 0 1 1 0 0 10. 0.7 1. 0.4 1. 0.1",
    ),
    (
        3,
        6,
        "element HDRRheologyBearing 77 1 2 800. 2e6 0. 0.6 0.003 0.008 20 700. 100. 20. 200. 3. 900. 100. 400. 300. 0.2 -kc 10. -PhiM 0.7 -shearDist 0.4 -ac 1. -cover 0.1 -linear 1. -mass 1. -mullins 0.6 0.2 -preload 0.1",
    ),
    (
        3,
        6,
        "element HDRRheologyBearing 77 1 2 800. 2e6 0. 0.6 0.003 0.008 20 700. 100. 20. 200. 3. 900. 100. 400. 300. 0.2 -conduction 20 0.01 0.003 0.02 0.2 2. 50. 4. 10.",
    ),
    (2, 3, "element singleFPBearing 77 1 2 2 2. 8000. -P 5 -Mz 4 -kFactUplift 0.1"),
    (2, 3, "element RJWatsonEqsBearing 77 1 2 2 8000. -P 5 -Vy 2 -Mz 4 -kFactUplift 0.1 -mass 1."),
    (
        2,
        3,
        "element elastomericBearingUFRP 77 1 2 0.01 1. 1. 1. 1. 1. 1. 0. 1. 0.5 0.5 -P 1 -Mz 4 -mass 1. -iter 10 1e-6",
    ),
    (
        3,
        6,
        "element KikuchiBearing 77 1 2 -shape round -size 0.7 0.15 -nMSS 6 -matMSS 7 -nMNS 6 -matMNS 9 -mass 1. -doBalance 1. 1. 10",
    ),
    (3, 6, "element multipleNormalSpring 77 1 2 7 -mat 9 -shape round -size 0.7 -mass 1."),
    (2, 3, "element truss 77 1 2 0.02 11 -rho 0.1"),
    (2, 3, "element corotTruss 77 1 2 0.02 11 -rho 0.1"),
    (2, 3, "element trussSection 77 1 2 21 -rho 0.1"),
    (2, 3, "element corotTrussSection 77 1 2 21 -rho 0.1"),
    (3, 6, "element YamamotoBiaxialHDR 77 1 2 1 0.05 0. 0.15 -mass 1."),
    (2, 3, "element dispBeamColumn 77 1 2 3 22 1 -mass 0.1"),
    (2, 3, "element forceBeamColumn 77 1 2 3 22 1 -mass 0.1"),
    (2, 3, "element forceBeamColumnCBDI 77 1 2 3 22 1 -mass 0.1 -iter 10 1e-8"),
    (2, 3, "element mixedBeamColumn 77 1 2 3 22 1 -mass 0.1"),
    (3, 6, "element beamWithHinges 77 1 2 24 0.1 24 0.1 200. 0.1 0.1 0.1 80. 0.1 2 -mass 0.1 -iter 10 1e-8"),
    (2, 2, "element quad9n 77 1 2 3 4 5 6 7 8 9 0.2 PlaneStrain 31 0. 0.1"),
    (2, 2, "element tri6n 77 1 2 3 4 5 6 0.2 PlaneStrain 31 0. 0.1"),
    (2, 3, "element MVLEM 77 1. 1 11 1 0.4 -thick 0.2 -width 0.3 -rho 0.02 -matConcrete 11 -matSteel 11 -matShear 11"),
    (2, 3, "element SFI_MVLEM 77 1 11 1 0.4 -thick 0.2 -width 0.3 -mat 35"),
    (2, 3, "element E_SFI 77 1 11 1 0.4 -thick 0.2 -width 0.3 -mat 35"),
    (
        3,
        6,
        "element MVLEM_3D 77 1 2 3 4 1 -thick 0.2 -width 0.3 -rho 0.02 -matConcrete 11 -matSteel 11 -matShear 11 -Density 1.",
    ),
    (3, 6, "element SFI_MVLEM_3D 77 1 2 3 4 1 -thick 0.2 -width 0.3 -mat 35 -ThickMod 1. -Density 1. -Eave 100."),
    (3, 6, "element E_SFI_MVLEM_3D 77 1 2 3 4 1 -thick 0.2 -width 0.3 -mat 35 -ThickMod 1. -Density 1."),
    (3, 6, "nDMaterial Series3D 77 36 36 -relTol 1e-3 -absTol 1e-3"),
    (
        3,
        6,
        "nDMaterial ASDConcrete3D 77 30000. 0.2 -fc 30. -rho 1. -eta 0.1 -cdf 0.1 -implex -implexControl 0.1 0.1 -implexAlpha 1. -autoRegularization 100.",
    ),
    (3, 6, "nDMaterial FSAM 77 0. 11 11 14 0.05 0.04 0.5 0.01"),
    (2, 3, "damping URD 77 2 1. 0.02 10. 0.02 -tol 0.1"),
    (2, 3, "motionFile 77 motion.txt -dt 0.01"),
    (2, 3, "pattern MultipleSupport 77 { groundMotion 1 Plain -accel 1 -dtInt 0.1 }"),
    (2, 3, "algorithm SecantNewton -numTerms 2 -cutOut 0.1 0.2 -maxDim 3"),
    (2, 3, "algorithm PeriodicNewton -maxDim 3"),
    (2, 3, "algorithm ExpressNewton 2 0.5"),
    (2, 3, "integrator DisplacementControl 2 1 0.1 5"),
    (2, 3, "integrator HHTHSIncrReduct 0.5 0.5"),
    (2, 3, "integrator HHTHSIncrLimit 0.5 0.5"),
    (2, 3, "integrator HHTHSFixedNumIter 0.5"),
    (2, 3, "integrator HHTHSIncrReduct_TP 0.5 0.5"),
    (2, 3, "integrator HHTHSIncrLimit_TP 0.5 0.5"),
    (2, 3, "integrator HHTHSFixedNumIter_TP 0.5"),
    (2, 3, "integrator CollocationHSIncrLimit 1.5 0.25 0.5 0.1"),
    (2, 3, "integrator HHTGeneralized_TP 1. 1. 0.25 0.5"),
    (2, 3, "integrator HHTGeneralizedExplicit_TP 1. 1. 0.25 0.5"),
    (2, 3, "integrator AlphaOSGeneralized_TP 1. 1. 0.25 0.5"),
    (2, 3, "eigen 2"),
    (2, 3, "responseSpectrumAnalysis 1 1 -mode 1"),
    (2, 3, "sdfResponse 1. 0.02 10. 1. 0.1 1 0.01"),
    (2, 3, "recorder Node -file a.txt -precision 3 -dT 0.1 -rTolDt 0.1 -node 1 -dof 1 disp"),
    (2, 3, "recorder NodeRMS -file a.txt -dT 0.1 -node 1 -dof 1 disp"),
    (2, 3, "recorder Element -file a.txt -precision 3 -dT 0.1 -rTolDt 0.1 -ele 1 force"),
    (2, 3, "recorder Collapse -dT 0.1"),
    (2, 3, "recorder PVD a -dT 0.1 -rTolDt 0.1 -precision 3 eigen 2"),
    (2, 3, "setNodeMass 1 1 1."),
    (2, 3, "sectionForce 1 1"),
    (2, 3, "sensSectionForce 1 1 1 1"),
];
