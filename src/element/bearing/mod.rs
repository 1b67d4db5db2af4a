//! Bearings of seismic isolation: two-node elements that join a shear law to axial and rotational materials.

mod bouc_wen;
mod bouc_wen_2d;
mod bouc_wen_3d;
mod link;
mod plasticity;

pub use bouc_wen::ShearParameters;
pub use bouc_wen_2d::BoucWen2d;
pub use bouc_wen_3d::BoucWen3d;
pub use link::Link;
pub use plasticity::{PlasticBearing, PlasticShear, Plasticity2d, Plasticity3d};
