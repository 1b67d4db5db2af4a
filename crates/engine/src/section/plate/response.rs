//! Responses of the section of a plate at one point of a shell.

use super::{PLATE_DEFORMATIONS, PLATE_ORDER, PLATE_RESULTANTS, PlateSection};
use crate::material::LAYER;
use crate::numeric::invert;
use crate::probe::Probe;

const FORCE: u32 = 0;
const DEFORMATION: u32 = 1;
const BOTH: u32 = 2;
const STIFFNESS: u32 = 3;
const FLEXIBILITY: u32 = 4;
const LAYER_STRAIN: u32 = 5;
const LAYER_STRESS: u32 = 6;

const STRAINS: [&str; LAYER] = ["eps11", "eps22", "gamma12", "gamma13", "gamma23"];
const STRESSES: [&str; LAYER] = ["sigma11", "sigma22", "sigma12", "sigma13", "sigma23"];

/// A response by its words: those of the section, or `fiber` with the number of a layer from 1 and `stresses` or `strains`.
pub(crate) fn probe(section: &dyn PlateSection, words: &[&str]) -> Option<Probe> {
    let square = |stem: &'static str| (1..=PLATE_ORDER * PLATE_ORDER).map(move |i| format!("{stem}{i}"));
    Some(match *words {
        ["force" | "forces", ..] => Probe::new(FORCE, PLATE_RESULTANTS),
        ["deformation" | "deformations", ..] => Probe::new(DEFORMATION, PLATE_DEFORMATIONS),
        ["forceAndDeformation", ..] => Probe::new(BOTH, PLATE_DEFORMATIONS.into_iter().chain(PLATE_RESULTANTS)),
        // The tangent of laws with a history is that of their last step, and is not kept.
        ["stiffness", ..] if section.is_linear() => Probe::new(STIFFNESS, square("k")),
        ["flexibility", ..] if section.is_linear() => Probe::new(FLEXIBILITY, square("f")),
        ["fiber", layer, what, ..] => {
            let layer = layer.parse::<u32>().ok().filter(|l| (1..=section.layers() as u32).contains(l))? - 1;
            let named = match what {
                "stress" | "stresses" => Probe::new(LAYER_STRESS, STRESSES),
                "strain" | "strains" => Probe::new(LAYER_STRAIN, STRAINS),
                _ => return None,
            };
            let kind = named.path[0];
            Probe { path: vec![kind, layer], ..named }
        }
        _ => return None,
    })
}

/// State of a section at a point of a shell.
pub(crate) struct PlateState<'a> {
    /// Its section.
    pub(crate) section: &'a dyn PlateSection,
    /// Resultants.
    pub(crate) resultants: &'a [f64],
    /// Deformations.
    pub(crate) deformations: [f64; PLATE_ORDER],
    /// State variables of the section.
    pub(crate) own: &'a [f64],
}

impl PlateState<'_> {
    /// Value of a response; zero where a layer has none.
    pub(crate) fn read(&self, path: &[u32], out: &mut [f64]) {
        match *path {
            [FORCE] => out.copy_from_slice(self.resultants),
            [DEFORMATION] => out.copy_from_slice(&self.deformations),
            [BOTH] => {
                out[..PLATE_ORDER].copy_from_slice(&self.deformations);
                out[PLATE_ORDER..].copy_from_slice(self.resultants);
            }
            [STIFFNESS] => out.copy_from_slice(self.section.initial_stiffness().as_flattened()),
            [FLEXIBILITY] => {
                let mut inverse = self.section.initial_stiffness().as_flattened().to_vec();
                if invert(&mut inverse, PLATE_ORDER) {
                    out.copy_from_slice(&inverse);
                }
            }
            [kind, layer] => {
                let found = self.section.layer(layer as usize, self.own, &self.deformations);
                let [strain, stress] = found.unwrap_or_default();
                let [s11, s22, s12, s23, s31] = if kind == LAYER_STRAIN { strain } else { stress };
                // OpenSees has the shear across the plate in the order of the section.
                out.copy_from_slice(&[s11, s22, s12, s31, s23]);
            }
            _ => {}
        }
    }
}
