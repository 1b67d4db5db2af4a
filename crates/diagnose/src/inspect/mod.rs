//! What there is in a study and in its model.

pub(crate) mod auxiliary_channels;
pub mod columns;
pub(crate) mod conditions;
pub mod insertion;
pub mod inventory;
pub mod neighbours;
pub(crate) mod probe;
pub mod response;
pub(crate) mod saturation;
