//! Laws as a model holds them.

use super::*;
use crate::rules::OpenSees;
use crate::shared::{Role, shared};

impl Role for dyn Uniaxial {
    type Held = Material;
}

impl<const N: usize> Role for dyn Multiaxial<N> {
    type Held = std::sync::Arc<Self>;
}

shared!(dyn Uniaxial:
    AsdConcrete1d, AxialSp, AxialSp<OpenSees>, AxialSpHD, AxialSpHD<OpenSees>, BackboneElastic, Bilin, Bilin<OpenSees>,
    BilinearOilDamper, BondSp01, BondSp01<OpenSees>, BoucWen, BoucWenOriginal, Bwbn, Cable, Cable<OpenSees>, Cast, Concrete01, Concrete01Sitc, Concrete02,
    Concrete02Is, Concrete04, Concrete06, Concrete07, ConcreteCm, ConcreteD, ConcreteWBeta, ConfinedConcrete01,
    CoulombDamper, DoddRestrepo, Ecc01, Elastic, ElasticBilin, ElasticMultiLinear, ElasticPower, ElasticPP,
    ElasticPPGap, Fatigue, FrpConfinedConcrete02, GallardoShear, Gng, Hardening, HdrRheology, HertzDamp, HookGap, HyperbolicGap,
    HyperbolicGap<OpenSees>, Hysteretic, HystereticAsym, HystereticPoly, HystereticSm, HystereticSmooth, ImkBilin,
    ImkBilin<OpenSees>, ImkPeakOriented, ImkPeakOriented<OpenSees>, ImkPinching, ImkPinching<OpenSees>, Impact,
    InitialState, JankowskiImpact,
    KikuchiAiken<HighDampingRubber>, KikuchiAiken<HighDampingRubber, ElasticRange>, KikuchiAiken<LeadRubber>,
    KikuchiAiken<LeadRubber, ElasticRange>, LimitState, Masonry, Maxwell, MinMax, ModImkPeakOriented,
    ModImkPeakOriented<OpenSees>, ModImkPinching, ModImkPinching<OpenSees>, Mullins, MultiLinear, NoTension, Parallel,
    PathIndependent,
    Pinching4, Pinching4<OpenSees>, Ratchet, ReinforcingSteel, Saws, Saws<OpenSees>, SelfCentering,
    SelfCentering<OpenSees>, Series, Sma, Sma3k, SoilSpring<PySimple1>, SoilSpring<QzSimple1>, SoilSpring<TzSimple1>,
    Steel01, Steel02, Steel03, Steel4, SteelBrb, SteelDrc, SteelFractureDi, SteelMpf, UvcUniaxial,
    UvcUniaxial<OpenSees>, ViscoelasticGap, Viscous, ViscousDamper,
);
shared!(dyn Multiaxial<SOLID>:
    AsdConcrete, ElasticContinuum<SOLID>, InitialStrain, J2Plasticity, ParallelSolids, SeriesSolids, SimplifiedJ2,
);
shared!(dyn Multiaxial<BEAM_FIBRE>: BeamJ2);
shared!(dyn Multiaxial<PLANE_BEAM_FIBRE>: BeamJ2);
