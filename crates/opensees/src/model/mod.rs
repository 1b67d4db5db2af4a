//! Nodes, constraints and transformations of a model, and changes of its parameters in time.

pub(crate) mod block;
pub(crate) mod constraint;
pub(crate) mod database;
pub(crate) mod nodes;
pub(crate) mod parameter_change;
pub(crate) mod remove;
pub(crate) mod transform;
pub(crate) mod units;
