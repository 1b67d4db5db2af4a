//! Laws of elastomeric bearings.

mod axial_spring;
pub mod hdr;
mod kikuchi_aiken;
mod kikuchi_aiken_hdr;
mod kikuchi_aiken_lrb;

pub use axial_spring::{AxialParameters, AxialSp, AxialSpHD, AxialSpring};
pub use hdr::HdrRheology;
pub use kikuchi_aiken::{Device, ElasticRange, KikuchiAiken, Shape};
pub use kikuchi_aiken_hdr::{COMPOUNDS, Compound, HighDampingRubber};
pub use kikuchi_aiken_lrb::{LeadRubber, LeadRubberParameters};
