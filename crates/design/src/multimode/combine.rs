//! Combination of modes.

use super::{ModalModel, Mode};
use crate::isolate::Study;

/// Combined responses to a motion in one direction.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Combined {
    /// Displacements of each bearing by horizontal direction.
    pub bearings: Vec<Vec<f64>>,
    /// Shear of all bearings in the direction of the motion.
    pub base_shear: f64,
    /// Storey drift ratios in the direction of the motion, from the base level upwards.
    pub drifts: Vec<f64>,
    /// Pseudo-accelerations of the floors in the direction of the motion, as a share of gravity.
    pub accelerations: Vec<f64>,
}

impl Combined {
    /// Largest displacement of each type of bearing: vector sum.
    pub fn largest(&self, study: &Study) -> Vec<f64> {
        let mut place = 0;
        let mut of = |count: usize| {
            let mine = &self.bearings[place..place + count];
            place += count;
            mine.iter().map(|u| u.iter().map(|x| x * x).sum::<f64>().sqrt()).fold(0.0, f64::max)
        };
        study.bearings.iter().map(|b| of(b.tags.len())).collect()
    }
}

/// Correlation of two modes with frequencies and dampings: Der Kiureghian (1981), A response spectrum method for random
/// vibration analysis of MDF systems, Earthquake Engineering and Structural Dynamics 9, 419-435.
pub fn cqc((w1, z1): (f64, f64), (w2, z2): (f64, f64)) -> f64 {
    let r = w2 / w1;
    let top = 8.0 * (z1 * z2).sqrt() * (z1 + r * z2) * r.powf(1.5);
    let bottom = (1.0 - r * r).powi(2) + 4.0 * z1 * z2 * r * (1.0 + r * r) + 4.0 * (z1 * z1 + z2 * z2) * r * r;
    if bottom == 0.0 { 1.0 } else { top / bottom }
}

/// Combined responses for modes and their spectral values.
pub(super) fn combine(
    study: &Study,
    model: &ModalModel,
    modes: &[Mode],
    direction: usize,
    stiffnesses: &[f64],
    by_cqc: bool,
) -> Combined {
    let n = modes.len();
    let amplitudes: Vec<f64> =
        modes.iter().enumerate().map(|(i, m)| model.amplitude(i, direction, m.acceleration * study.gravity)).collect();
    let correlation: Vec<Vec<f64>> = (0..n)
        .map(|i| {
            let of = |j: usize| match (i == j, by_cqc) {
                (true, _) => 1.0,
                (_, false) => 0.0,
                _ => {
                    let pair = |k: usize| (model.eigenvalue(k).sqrt(), modes[k].damping);
                    cqc(pair(i), pair(j))
                }
            };
            (0..n).map(of).collect()
        })
        .collect();
    let sum = |of: &dyn Fn(usize) -> f64| -> f64 {
        let r: Vec<f64> = (0..n).map(|i| amplitudes[i] * of(i)).collect();
        let row = |i: usize| -> f64 { (0..n).map(|j| correlation[i][j] * r[i] * r[j]).sum() };
        (0..n).map(row).sum::<f64>().max(0.0).sqrt()
    };
    let horizontal = model.horizontal();
    let bearings =
        (0..model.count()).map(|b| (0..horizontal).map(|h| sum(&|i| model.bearing(i, b, h))).collect()).collect();
    let shear = |i: usize| -> f64 {
        (0..model.count()).map(|b| stiffnesses[model.kind(b)] * model.bearing(i, b, direction)).sum()
    };
    let drift = |k: usize| {
        let of = |i: usize| model.floor(i, k, direction) - model.floor(i, k - 1, direction);
        sum(&of) / study.floors[k].height
    };
    let acceleration = |k: usize| sum(&|i| model.eigenvalue(i) * model.floor(i, k, direction)) / study.gravity;
    Combined {
        bearings,
        base_shear: sum(&shear),
        drifts: (1..study.floors.len()).map(drift).collect(),
        accelerations: (0..study.floors.len()).map(acceleration).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::cqc;

    #[test]
    fn correlations_of_modes() {
        assert!((cqc((3.0, 0.05), (3.0, 0.05)) - 1.0).abs() < 1e-14);
        assert_eq!(cqc((3.0, 0.05), (4.0, 0.1)), cqc((3.0, 0.05), (4.0, 0.1)));
        assert!((cqc((3.0, 0.05), (4.0, 0.1)) - cqc((4.0, 0.1), (3.0, 0.05))).abs() < 1e-14);
        // Equal damping: 8 ζ² (1 + r) r^1.5/((1 - r²)² + 4 ζ² r (1 + r)²), Chopra, Dynamics of Structures, equation 13.7.10.
        let (r, z) = (1.2f64, 0.05f64);
        let chopra =
            8.0 * z * z * (1.0 + r) * r.powf(1.5) / ((1.0 - r * r).powi(2) + 4.0 * z * z * r * (1.0 + r).powi(2));
        assert!((cqc((1.0, z), (r, z)) - chopra).abs() < 1e-14);
    }
}
