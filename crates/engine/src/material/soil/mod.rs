//! Laws of soil at piles, and curves of monotonic loading.

mod backbone;
mod soil_spring;

pub use backbone::{Backbone, BackboneElastic, SoilCurve};
pub use soil_spring::{PyBackbone, PySimple1, QzBackbone, QzSimple1, Soil, SoilSpring, TzBackbone, TzSimple1};
