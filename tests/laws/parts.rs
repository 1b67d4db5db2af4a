//! Materials, sections and transformations of the scripts of single elements.

/// Parts of every script.
pub const PARTS: &str = "uniaxialMaterial Steel01 11 2. 200. 0.02\nuniaxialMaterial ElasticPPGap 12 200. -2. -0.01 0.05
uniaxialMaterial Elastic 13 150.
hystereticBackbone Raynor 31 200. 2. 3. 0.02 0.2 3. 1.
hystereticBackbone Arctangent 32 2. 0.02 0.8
hystereticBackbone Mander 33 3. 0.05 100.
hystereticBackbone ReeseSand 34 400. 0.03 2. 0.2 3.
hystereticBackbone ReeseStiffClayBelowWS 35 400. 0.01 0.6 4.
hystereticBackbone ReeseSoftClay 36 3. 0.02 3.
hystereticBackbone LinearCapped 37 31 0.06 -20. 0.5
hystereticBackbone ReeseStiffClayAboveWS 38 4. 0.01
hystereticBackbone VuggyLimestone 39 50. 2.
hystereticBackbone CementedSoil 40 2. 3. 40. 2. 4.
hystereticBackbone WeakRock 41 400. 3. 0.01\n";

/// The same with what elements need in a number of dimensions.
pub fn parts(ndm: usize) -> String {
    let more = if ndm == 2 {
        "geomTransf Linear 1\ngeomTransf Corotational 3\ngeomTransf PDelta 5\nnDMaterial ElasticIsotropic 31 200. 0.3
        section Fiber 22 { patch rect 11 10 1 -0.15 -0.1 0.15 0.1 }
        section Aggregator 23 13 Vy -section 22"
    } else {
        "geomTransf Linear 2 0 0 1\ngeomTransf Corotational 4 0 0 1\ngeomTransf PDelta 6 0 0 1
        nDMaterial ElasticIsotropic 31 200. 0.3\nnDMaterial PlateFiber 32 31\nnDMaterial PlateRebar 33 11 30.
        nDMaterial PlateFromPlaneStress 34 31 50.
        section PlateFiber 42 32 0.2\nsection LayeredShell 43 4 32 0.1 33 0.01 34 0.1 33 0.02
        section Fiber 24 -GJ 50. { patch rect 11 6 4 -0.15 -0.1 0.15 0.1 }"
    };
    let continua = "uniaxialMaterial ConcreteCM 14 -6. -0.06 200. 7. 1.035 0.8 0.008 1.2 1e4
        nDMaterial FSAM 35 0. 11 11 14 0.05 0.04 0.5 0.01
        nDMaterial J2Plasticity 36 166.7 76.9 2. 3. 12. 3.
        nDMaterial Simplified3DJ2 37 76.9 166.7 2. 4. 3.
        nDMaterial PlaneStressSimplifiedJ2 38 76.9 166.7 2. 4. 3.
        nDMaterial ElasticOrthotropic 40 200. 150. 120. 0.3 0.2 0.15 60. 50. 45.
        nDMaterial Parallel3D 39 36 40 -weights 0.7 0.4
        nDMaterial Series3D 51 36 40 -weights 0.7 0.4
        nDMaterial InitStress 52 36 -0.5
        nDMaterial BeamFiber 53 36
        nDMaterial BeamFiber2d 54 37
        nDMaterial BeamFiber2dPS 55 38
        nDMaterial J2BeamFiber 56 200. 0.3 2. 3. 5.";
    let fibres = if ndm == 2 {
        "section NDFiber 61 { patch rect 56 6 1 -0.15 -0.1 0.15 0.1\nfiber 0.1 0. 0.01 54 }
        section NDFiber 63 -alpha 0.8 { patch rect 54 4 1 -0.15 -0.1 0.15 0.1\nfiber 0.1 0. 0.01 55 }"
    } else {
        "section NDFiber 62 -alpha 0.8 { patch rect 56 4 3 -0.15 -0.1 0.15 0.1\nfiber 0.1 0.05 0.01 53 }"
    };
    let plates = if ndm == 3 { "section LayeredShell 45 3 36 0.05 37 0.1 36 0.05" } else { "" };
    format!("{PARTS}section Uniaxial 21 13 P\n{more}\n{continua}\n{fibres}\n{plates}\n")
}
