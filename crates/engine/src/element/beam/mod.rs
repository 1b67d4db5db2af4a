//! Beam-columns.

mod axial_equilibrium;
mod basic;
mod basic_forces;
mod component;
mod curvature_based;
mod curvature_interpolation;
mod deflection;
mod displacement_based;
mod elastic;
mod force_based;
mod integration;
mod kept_tangent;
mod member;
mod mixed;
mod opensees;
mod per_section;
mod point;
mod section_responses;
mod section_update;
mod shortfall;
mod timoshenko;

pub use axial_equilibrium::AxialEquilibrium;
pub use basic::Basic;
pub use component::{ComponentBeam, ComponentOptions};
pub use curvature_based::{CurvatureBased, MAX_DEFORMATIONS};
pub use displacement_based::DisplacementBased;
pub use elastic::{Bending, ElasticBeam, ElasticOptions, Release};
pub use force_based::ForceBased;
pub use integration::{Hinge, Points, Rule};
pub use member::{FiberBeam, Formulation, Lacking, LoadSums, Member};
pub use mixed::Mixed;
pub use timoshenko::{TimoshenkoBeam, TimoshenkoOptions};
