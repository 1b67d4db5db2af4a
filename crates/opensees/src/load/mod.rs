//! Load patterns, time series and ground motions.

pub(crate) mod amended_node;
pub(crate) mod ground_motion;
pub(crate) mod late_support;
pub(crate) mod motion_file;
pub(crate) mod pattern;
pub(crate) mod series;
