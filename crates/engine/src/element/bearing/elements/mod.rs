//! Bearing elements between two nodes.

pub(in crate::element::bearing) mod kikuchi;
pub(in crate::element::bearing) mod multiple_normal_spring;
pub(in crate::element::bearing) mod multiple_shear_spring;
pub(in crate::element::bearing) mod rubber_bearing;
mod rubber_bearings;
pub(in crate::element::bearing) mod shear_bearing;
mod shear_bearings;
pub mod sliding;
pub mod triple;
