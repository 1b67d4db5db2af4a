//! Elastic cross-sections.

/// An elastic cross-section; what the plane has no use for is zero.
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
    /// A number by the name that a script has for it. A section rigid in shear gets a shear area when it is asked for.
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
