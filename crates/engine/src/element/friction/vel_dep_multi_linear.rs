//! `frictionModel VelDepMultiLinear`.

use super::{Coefficient, FrictionLaw};

/// A coefficient that is piecewise linear in the speed. It is extrapolated linearly on both sides, as in OpenSees, but
/// never below 0.
#[derive(Clone, Debug, PartialEq)]
pub struct VelDepMultiLinear {
    /// Speed and coefficient of at least two points, with increasing speeds.
    points: Vec<[f64; 2]>,
}

impl VelDepMultiLinear {
    /// Makes the model of points of speed and coefficient; `None` for fewer than two points or speeds that do not
    /// increase.
    pub fn new(points: Vec<[f64; 2]>) -> Option<Self> {
        let rising = points.len() >= 2 && points.windows(2).all(|w| w[0][0] < w[1][0]);
        rising.then_some(Self { points })
    }
}

impl FrictionLaw for VelDepMultiLinear {
    fn name(&self) -> &'static str {
        "VelDepMultiLinear"
    }
    fn coefficient(&self, _: f64, speed: f64) -> Coefficient {
        let i = self.points.partition_point(|p| p[0] <= speed).clamp(1, self.points.len() - 1);
        let ([v1, mu1], [v2, mu2]) = (self.points[i - 1], self.points[i]);
        let slope = (mu2 - mu1) / (v2 - v1);
        let mu = mu1 + slope * (speed - v1);
        if mu > 0.0 { Coefficient { mu, by_normal: 0.0, by_speed: slope } } else { Coefficient::default() }
    }
}
