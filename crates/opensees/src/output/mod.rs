//! Recorders, queries and pictures.

mod balance;
pub(crate) mod collapse;
pub(crate) mod display;
pub(crate) mod figure;
pub(crate) mod inventory;
pub(crate) mod journal;
pub(crate) mod loads;
pub(crate) mod model_file;
pub(crate) mod print;
mod pvd;
pub(crate) mod query;
pub(crate) mod recorder;
mod recorder_file;
mod recorder_options;
pub(crate) mod recorders;
pub(crate) mod section_query;
pub(crate) mod verify;

pub use balance::{AnalysedModel, Balances, ModelSize};
