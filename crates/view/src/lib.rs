//! Models, motions and loops as a page for a browser, and as files for ParaView.
//!
//! A [`Collector`] observes the run of a script. [`page`] writes what it has seen as one page that fetches nothing,
//! [`vtk`] as files of the Visualization Toolkit.

#![forbid(unsafe_code)]

mod collector;
mod devices;
mod fibers;
mod field;
mod forces;
mod glance;
mod history;
mod numbers;
mod pack;
mod page;
mod scene;
#[cfg(test)]
mod tests;
mod thin;
pub mod vtk;

pub use collector::{Collector, Motion, Observer, Units};
pub use glance::Glance;
pub use page::{interactive, page};
pub use scene::{Family, Scene};
pub use thin::thinned;
