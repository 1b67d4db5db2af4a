//! Laws of materials and elements: consistent tangents, energy, equilibrium, objectivity, symmetry, and dependence on
//! the committed state alone.

#![allow(clippy::unwrap_used, unreachable_pub)]

#[path = "laws/amendments.rs"]
mod amendments;
#[path = "laws/beams.rs"]
mod beams;
#[path = "laws/bearing_materials.rs"]
mod bearing_materials;
#[path = "laws/bearings.rs"]
mod bearings;
#[path = "laws/class_tags.rs"]
mod class_tags;
#[path = "laws/component.rs"]
mod component;
#[path = "laws/corotational.rs"]
mod corotational;
#[path = "laws/declared_calls.rs"]
mod declared_calls;
#[path = "laws/declared_numbers.rs"]
mod declared_numbers;
#[path = "laws/deterioration.rs"]
mod deterioration;
#[path = "laws/driver.rs"]
mod driver;
#[path = "laws/every_bearing.rs"]
mod every_bearing;
#[path = "laws/every_kind.rs"]
mod every_kind;
#[path = "laws/frame_materials.rs"]
mod frame_materials;
#[path = "laws/gallardo.rs"]
mod gallardo;
#[path = "laws/heated.rs"]
mod heated;
#[path = "laws/hinges.rs"]
mod hinges;
#[path = "laws/kikuchi.rs"]
mod kikuchi;
#[path = "laws/learned.rs"]
mod learned;
#[path = "laws/links.rs"]
mod links;
#[path = "laws/materials.rs"]
mod materials;
#[path = "laws/multiple_shear_spring.rs"]
mod multiple_shear_spring;
#[path = "laws/normal_springs.rs"]
mod normal_springs;
#[path = "laws/parameters.rs"]
mod parameters;
#[path = "laws/parts.rs"]
mod parts;
#[path = "laws/plates.rs"]
mod plates;
#[path = "laws/python_cases.rs"]
mod python_cases;
#[path = "laws/quad.rs"]
mod quad;
#[path = "laws/reference_stresses.rs"]
mod reference_stresses;
#[path = "laws/roles.rs"]
mod roles;
#[path = "laws/rubber.rs"]
mod rubber;
#[path = "laws/rubber_bearings.rs"]
mod rubber_bearings;
#[path = "laws/rubber_plane.rs"]
mod rubber_plane;
#[path = "support/script.rs"]
mod script;
#[path = "laws/sections.rs"]
mod sections;
#[path = "laws/shapes.rs"]
mod shapes;
#[path = "laws/sliders.rs"]
mod sliders;
#[path = "laws/smooth_hysteresis.rs"]
mod smooth_hysteresis;
#[path = "laws/soil_springs.rs"]
mod soil_springs;
#[path = "laws/springs.rs"]
mod springs;
#[path = "laws/timoshenko.rs"]
mod timoshenko;
#[path = "laws/triple.rs"]
mod triple;
#[path = "laws/uniaxial_roles.rs"]
mod uniaxial_roles;
#[path = "laws/wrappers.rs"]
mod wrappers;
#[path = "laws/yamamoto.rs"]
mod yamamoto;
