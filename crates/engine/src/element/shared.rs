//! Elements as a model holds them.

use super::amendment::{Amended, Hinged};
use super::beam::{
    AxialEquilibrium, ComponentBeam, CurvatureBased, DisplacementBased, ElasticBeam, FiberBeam, ForceBased, Mixed,
    TimoshenkoBeam,
};
use super::bearing::sliding::{PlaneSlider, SpaceSlider, Substitution};
use super::bearing::triple::{Increments, TriplePendulum};
use super::bearing::{
    BoucWenShear, GrantShear, KikuchiBearing, MultipleNormalSpring, MultipleShearSpring, PlaneBearing, PlasticShear,
    RheologyShear, RubberBearing, RubberBoucWen, ShearBearing, SpaceBearing, UfrpShear, YamamotoShear,
};
use super::continuum::Continuum;
use super::damping::Damped;
use super::shell::{EnhancedShell, Shell, UpdatedShell};
use super::wall::{PLANE_WALL, SPACE_WALL, WallLines, WallPanels};
use super::{
    BeamColumnJoint, CatenaryCable, Contact, CorotTruss, CoupledZeroLength, Element, Impact, Inerter, Joint, Truss,
    TubularJoint, TwoNodeLink, ZeroLength, ZeroLengthSection,
};
use crate::rules::OpenSees;
use crate::shared::{Role, shared};

/// A beam of a formulation in the plane.
type PlaneBeam<F> = FiberBeam<F, 6, 3>;
/// A beam of a formulation in space.
type SpaceBeam<F> = FiberBeam<F, 12, 6>;

impl Role for dyn Element {
    type Held = std::sync::Arc<Self>;
}

shared!(dyn Element:
    Amended, BeamColumnJoint, CatenaryCable, ComponentBeam, Contact, CorotTruss, CoupledZeroLength, Damped,
    EnhancedShell, Hinged, Impact, Inerter, Joint, Shell, Truss, TubularJoint, TwoNodeLink, UpdatedShell, ZeroLength,
    ZeroLengthSection,
    ElasticBeam<6, 3>, ElasticBeam<12, 6>, TimoshenkoBeam<6, 3>, TimoshenkoBeam<12, 6>,
    PlaneBeam<AxialEquilibrium>, PlaneBeam<CurvatureBased>, PlaneBeam<CurvatureBased<OpenSees>>,
    PlaneBeam<DisplacementBased>, PlaneBeam<ForceBased>, PlaneBeam<Mixed>,
    SpaceBeam<AxialEquilibrium>, SpaceBeam<CurvatureBased>, SpaceBeam<CurvatureBased<OpenSees>>,
    SpaceBeam<DisplacementBased>, SpaceBeam<ForceBased>, SpaceBeam<Mixed>,
    KikuchiBearing, MultipleNormalSpring, MultipleShearSpring, MultipleShearSpring<OpenSees>,
    PlaneBearing<BoucWenShear>, PlaneBearing<PlasticShear>, PlaneBearing<UfrpShear>,
    SpaceBearing<BoucWenShear>, SpaceBearing<PlasticShear>,
    ShearBearing<YamamotoShear, 12, 6, 0, 2>, ShearBearing<YamamotoShear<OpenSees>, 12, 6, 0, 2>,
    RubberBearing<GrantShear>, RubberBearing<GrantShear<OpenSees>>, RubberBearing<RheologyShear>,
    RubberBearing<RubberBoucWen>, RubberBearing<RubberBoucWen<OpenSees>>,
    PlaneSlider, PlaneSlider<Substitution>, SpaceSlider, SpaceSlider<Substitution>,
    TriplePendulum, TriplePendulum<Increments>,
    Continuum<3, 6>, Continuum<3, 8>, Continuum<3, 12>, Continuum<3, 16>, Continuum<3, 18>,
    Continuum<4, 8>, Continuum<6, 12>, Continuum<6, 24>, Continuum<6, 30>,
    WallPanels<PLANE_WALL>, WallPanels<SPACE_WALL>, WallLines<PLANE_WALL>, WallLines<SPACE_WALL>,
);
