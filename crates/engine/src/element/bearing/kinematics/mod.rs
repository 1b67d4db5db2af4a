//! Kinematics of bearing elements, and the responses that follow from them.

pub(in crate::element::bearing) mod link;
pub(in crate::element::bearing) mod overlap;
pub(in crate::element::bearing) mod responses;
