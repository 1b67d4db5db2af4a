//! Sections as a model holds them.

use super::plate::{ElasticPlate, LayeredPlate, PlateFromPlaneStress, PlateRebar, PlateSection};
use super::{
    Aggregator, Axial, Bidirectional, Elastic, Elliptical, FiberSection, NdFiberSection, ParallelSections, Section,
    TwoSpringIsolator,
};
use crate::material::{LAYER, Multiaxial, Uniaxial};
use crate::shared::{Role, shared};

impl Role for dyn Section {
    type Held = std::sync::Arc<Self>;
}

impl Role for dyn PlateSection {
    type Held = std::sync::Arc<Self>;
}

shared!(dyn Section:
    Aggregator, Bidirectional, Elastic, Elliptical, FiberSection, NdFiberSection<2>, NdFiberSection<3>,
    ParallelSections, TwoSpringIsolator,
);
shared!(dyn PlateSection: ElasticPlate, LayeredPlate);
shared!(dyn Multiaxial<LAYER>: PlateFromPlaneStress, PlateRebar);
shared!(dyn Uniaxial: Axial);
