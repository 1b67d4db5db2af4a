//! A material of continua in the forms that elements and sections take.

use super::{BEAM_FIBRE, Condensed, LAYER, Multiaxial, PLANE, PLANE_BEAM_FIBRE, Plane, SOLID, SharedMultiaxial};
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
    /// The law of a fibre of a beam in space.
    pub beam: Option<SharedMultiaxial<BEAM_FIBRE>>,
    /// The law of a fibre of a beam in a plane.
    pub plane_beam: Option<SharedMultiaxial<PLANE_BEAM_FIBRE>>,
}

impl NdMaterial {
    /// A material without a law yet.
    pub fn named(class: &'static str) -> Self {
        Self { class, solid: None, plane_strain: None, plane_stress: None, layer: None, beam: None, plane_beam: None }
    }

    /// A law in space, and its forms in planes, layers and beams.
    pub fn of_solid(class: &'static str, law: SharedMultiaxial<SOLID>) -> Self {
        Self {
            class,
            plane_strain: Some(Condensed::plane_strain(&law)),
            plane_stress: Some(Condensed::plane_stress(&law)),
            layer: Some(Condensed::layer(&law)),
            beam: Some(Condensed::beam(&law)),
            plane_beam: Some(Condensed::plane_beam(&law)),
            solid: Some(law),
        }
    }

    /// A law in plane stress alone.
    pub fn of_plane_stress(class: &'static str, law: impl Multiaxial<PLANE> + 'static) -> Self {
        Self::of_shared_plane_stress(class, Arc::new(law))
    }

    /// A shared law in plane stress alone.
    pub fn of_shared_plane_stress(class: &'static str, law: SharedMultiaxial<PLANE>) -> Self {
        Self { plane_stress: Some(law), ..Self::named(class) }
    }

    /// A law in plane strain alone.
    pub fn of_plane_strain(class: &'static str, law: SharedMultiaxial<PLANE>) -> Self {
        Self { plane_strain: Some(law), ..Self::named(class) }
    }

    /// A law of layers alone.
    pub fn of_layers(class: &'static str, law: SharedMultiaxial<LAYER>) -> Self {
        Self { layer: Some(law), ..Self::named(class) }
    }

    /// Laws of fibres of beams alone.
    pub fn of_beams(
        class: &'static str,
        beam: Option<SharedMultiaxial<BEAM_FIBRE>>,
        plane_beam: Option<SharedMultiaxial<PLANE_BEAM_FIBRE>>,
    ) -> Self {
        Self { beam, plane_beam, ..Self::named(class) }
    }

    /// The law in plane strain or plane stress.
    pub fn plane(&self, plane: Plane) -> Option<&SharedMultiaxial<PLANE>> {
        match plane {
            Plane::Strain => self.plane_strain.as_ref(),
            Plane::Stress => self.plane_stress.as_ref(),
        }
    }
}
