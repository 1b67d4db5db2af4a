//! Bearings that slide: a flat or spherical surface with friction between two nodes.
//!
//! [`Surface`] is the law of the surface, [`SlidingBearing`] the element around it, [`Heat`] the friction of a surface that warms.

mod bearing;
mod heat;
mod opensees;
mod rules;
mod surface;

pub use bearing::{Kind, PlaneSlider, Setting, SlidingBearing, SpaceSlider};
pub use heat::{Heat, HeatSetting};
pub use opensees::Substitution;
pub use surface::{Dish, Pose, Slide, Surface};
