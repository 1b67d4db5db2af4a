//! A material of continua in the forms that elements and sections take.

use super::{Condensed, LAYER, Multiaxial, PLANE, Plane, SOLID, SharedMultiaxial};
use std::sync::Arc;

/// A material of continua. `None` marks a form that it does not have.
#[derive(Clone, Debug)]
pub struct NdMaterial {
    /// Name of the class in OpenSees.
    pub class: &'static str,
    /// The law in space.
    pub solid: Option<SharedMultiaxial<SOLID>>,
    /// The law in plane strain.
    pub plane_strain: Option<SharedMultiaxial<PLANE>>,
    /// The law in plane stress.
    pub plane_stress: Option<SharedMultiaxial<PLANE>>,
    /// The law of a layer of a plate.
    pub layer: Option<SharedMultiaxial<LAYER>>,
}

impl NdMaterial {
    /// A law in space, and its forms in planes and layers.
    pub fn of_solid(class: &'static str, law: SharedMultiaxial<SOLID>) -> Self {
        Self {
            class,
            plane_strain: Some(Condensed::plane_strain(&law)),
            plane_stress: Some(Condensed::plane_stress(&law)),
            layer: Some(Condensed::layer(&law)),
            solid: Some(law),
        }
    }

    /// A law in plane stress alone.
    pub fn of_plane_stress(class: &'static str, law: impl Multiaxial<PLANE> + 'static) -> Self {
        Self::of_shared_plane_stress(class, Arc::new(law))
    }

    /// A shared law in plane stress alone.
    pub fn of_shared_plane_stress(class: &'static str, law: SharedMultiaxial<PLANE>) -> Self {
        Self { class, solid: None, plane_strain: None, plane_stress: Some(law), layer: None }
    }

    /// A law in plane strain alone.
    pub fn of_plane_strain(class: &'static str, law: SharedMultiaxial<PLANE>) -> Self {
        Self { class, solid: None, plane_strain: Some(law), plane_stress: None, layer: None }
    }

    /// A law of layers alone.
    pub fn of_layers(class: &'static str, law: SharedMultiaxial<LAYER>) -> Self {
        Self { class, solid: None, plane_strain: None, plane_stress: None, layer: Some(law) }
    }

    /// The law in plane strain or plane stress.
    pub fn plane(&self, plane: Plane) -> Option<&SharedMultiaxial<PLANE>> {
        match plane {
            Plane::Strain => self.plane_strain.as_ref(),
            Plane::Stress => self.plane_stress.as_ref(),
        }
    }
}
