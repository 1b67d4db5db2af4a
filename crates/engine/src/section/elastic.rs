//! Elastic cross-sections.

use super::plain_methods::plain_methods;
use super::{Resultant, Section, SectionStep, SharedSection};
use crate::material::MaterialResult;
use crate::parameter::{Changed, NewValue, exchange, existing, first};
use std::sync::Arc;

/// Properties of an elastic cross-section; those unused in a plane model are zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ElasticSection {
    /// Elastic modulus.
    pub e: f64,
    /// Area.
    pub area: f64,
    /// Second moment of area about z.
    pub iz: f64,
    /// Second moment of area about y.
    pub iy: f64,
    /// Shear modulus.
    pub g: f64,
    /// Torsion constant.
    pub j: f64,
    /// Shear areas along y and z; `None` for a section rigid in shear.
    pub shear: (Option<f64>, Option<f64>),
}

impl ElasticSection {
    /// Property by its name in scripts. A section rigid in shear gets a shear area of zero when one is requested.
    pub fn parameter(&mut self, name: &str) -> Option<&mut f64> {
        Some(match name {
            "E" => &mut self.e,
            "A" => &mut self.area,
            "I" | "Iz" => &mut self.iz,
            "Iy" => &mut self.iy,
            "G" => &mut self.g,
            "J" => &mut self.j,
            "Av" | "Avy" => self.shear.0.get_or_insert(0.0),
            "Avz" => self.shear.1.get_or_insert(0.0),
            _ => return None,
        })
    }

    /// Shear rigidities along y and z; `None` where the section is rigid in shear.
    pub fn shear_rigidity(&self) -> (Option<f64>, Option<f64>) {
        let rigidity = |area: Option<f64>| area.map(|a| self.g * a).filter(|ga| *ga > 0.0);
        (rigidity(self.shear.0), rigidity(self.shear.1))
    }
}

/// An elastic section with the resultants of its properties.
#[derive(Clone, Debug)]
pub struct Elastic {
    section: ElasticSection,
    resultants: Vec<Resultant>,
}

impl Elastic {
    /// For a plane or a spatial model; shear areas add shear forces.
    pub fn new(section: ElasticSection, plane: bool) -> Self {
        let shear = section.shear != (None, None);
        let resultants = match (plane, shear) {
            (true, false) => vec![Resultant::P, Resultant::Mz],
            (true, true) => vec![Resultant::P, Resultant::Mz, Resultant::Vy],
            (false, false) => vec![Resultant::P, Resultant::Mz, Resultant::My, Resultant::T],
            (false, true) => Resultant::ALL.to_vec(),
        };
        Self { section, resultants }
    }

    fn stiffness(&self, resultant: Resultant) -> f64 {
        let s = &self.section;
        match resultant {
            Resultant::P => s.e * s.area,
            Resultant::Mz => s.e * s.iz,
            Resultant::Vy => s.shear_rigidity().0.unwrap_or(0.0),
            Resultant::My => s.e * s.iy,
            Resultant::Vz => s.shear_rigidity().1.unwrap_or(0.0),
            Resultant::T => s.g * s.j,
        }
    }
}

crate::watches_columns!(Elastic => nothing);

impl Section for Elastic {
    plain_methods! { init depends_on_time joined probe }
    fn class(&self) -> &'static str {
        match self.resultants.len() {
            2 => "ElasticSection2d",
            3 => "ElasticShearSection2d",
            4 => "ElasticSection3d",
            _ => "ElasticShearSection3d",
        }
    }
    fn resultants(&self) -> &[Resultant] {
        &self.resultants
    }
    fn state_len(&self) -> usize {
        0
    }
    fn is_linear(&self) -> bool {
        true
    }

    fn update(&self, SectionStep { e, s, k, .. }: SectionStep<'_>) -> MaterialResult {
        self.initial_stiffness(k);
        for ((s, e), r) in s.iter_mut().zip(e).zip(&self.resultants) {
            *s = self.stiffness(*r) * e;
        }
        Ok(())
    }

    fn initial_stiffness(&self, k: &mut [f64]) {
        let n = self.resultants.len();
        for (i, r) in self.resultants.iter().enumerate() {
            k[i * n + i] = self.stiffness(*r);
        }
    }

    fn elastic(&self) -> Option<ElasticSection> {
        Some(self.section)
    }

    fn with_parameter(&self, words: &[&str], value: NewValue) -> Changed<SharedSection> {
        let mut new = self.clone();
        let old = exchange(existing(new.section.parameter(first(words)?))?, value);
        Ok((Arc::new(new), old))
    }
}
