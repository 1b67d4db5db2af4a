//! Multilinear elastic laws.

use crate::material::{MaterialResult, Strain, Stress, UniaxialLaw};

/// Bilinear elasticity on each side.
#[derive(Clone, Debug, PartialEq)]
pub struct ElasticBilin {
    /// First slope in tension and in compression.
    pub first: [f64; 2],
    /// Second slope in tension and in compression.
    pub second: [f64; 2],
    /// Absolute strain at the change of slope.
    pub bend: [f64; 2],
}

impl UniaxialLaw for ElasticBilin {
    type State = ();
    const NAME: &'static str = "ElasticBilin";

    fn update(&self, _: &(), strain: Strain) -> MaterialResult<(Stress, ())> {
        let (side, s) = if strain.value >= 0.0 { (0, 1.0) } else { (1, -1.0) };
        let (x, bend) = (strain.value.abs(), self.bend[side]);
        let (stress, tangent) = if x < bend {
            (self.first[side] * x, self.first[side])
        } else {
            (self.first[side] * bend + (x - bend) * self.second[side], self.second[side])
        };
        Ok((Stress { value: s * stress, tangent, damping: 0.0 }, ()))
    }

    fn initial_tangent(&self) -> f64 {
        self.first[0]
    }
}

/// Elasticity through any number of points, with a dashpot in parallel. The first and the last slope extend beyond
/// the points.
#[derive(Clone, Debug, PartialEq)]
pub struct ElasticMultiLinear {
    strains: Vec<f64>,
    stresses: Vec<f64>,
    eta: f64,
}

impl ElasticMultiLinear {
    /// From at least two points with increasing strains, and a damping modulus (stress x time). `None` if the points
    /// are invalid.
    pub fn new(strains: Vec<f64>, stresses: Vec<f64>, eta: f64) -> Option<Self> {
        let rising = strains.windows(2).all(|w| w[1] > w[0]);
        (rising && strains.len() >= 2 && strains.len() == stresses.len()).then_some(Self { strains, stresses, eta })
    }

    /// Stress and slope at a strain.
    fn at(&self, x: f64) -> (f64, f64) {
        let after = self.strains.partition_point(|&p| p <= x);
        let i = after.clamp(1, self.strains.len() - 1) - 1;
        let slope = (self.stresses[i + 1] - self.stresses[i]) / (self.strains[i + 1] - self.strains[i]);
        (self.stresses[i] + slope * (x - self.strains[i]), slope)
    }
}

impl UniaxialLaw for ElasticMultiLinear {
    type State = ();
    const NAME: &'static str = "ElasticMultiLinear";

    fn update(&self, _: &(), strain: Strain) -> MaterialResult<(Stress, ())> {
        let (stress, tangent) = self.at(strain.value);
        Ok((Stress { value: stress + self.eta * strain.rate, tangent, damping: self.eta }, ()))
    }

    fn initial_tangent(&self) -> f64 {
        self.at(0.0).1
    }

    fn is_viscous(&self) -> bool {
        self.eta != 0.0
    }
}
