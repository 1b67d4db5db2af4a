//! Measures of motions in two directions.

use super::hysteresis::ratio;
use super::{Cycle, CycleDetection, Loop};
use std::f64::consts::TAU;

/// One round of an orbit.
#[derive(Clone, Debug, PartialEq)]
pub struct Orbit {
    /// Samples of the round in the record.
    pub cycle: Cycle,
    /// Loops of each direction. A figure of eight passes one of them twice; its energy is that of both passes.
    pub directions: [Loop; 2],
    /// Largest distance from the centre.
    pub radius: f64,
    /// Largest force.
    pub force: f64,
}

impl Orbit {
    /// Dissipated energy of both directions, E = ∮ F·du.
    pub fn energy(&self) -> f64 {
        self.directions.iter().map(|d| d.energy).sum()
    }

    /// Equivalent viscous damping of both directions, ξ = ΣE/(2π ΣK u²).
    pub fn damping(&self) -> f64 {
        let stored: f64 = self.directions.iter().map(|d| d.stiffness() * d.amplitude().powi(2)).sum();
        ratio(self.energy(), TAU * stored)
    }
}

/// The rounds of an orbit, from displacements `u` and forces `f` in two directions. Rounds are the cycles of the direction
/// with fewer of them, so that a figure of eight is one round.
pub fn orbits(u: [&[f64]; 2], f: [&[f64]; 2], detection: [&CycleDetection; 2]) -> Vec<Orbit> {
    let [x, y] = [0, 1].map(|i| detection[i].cycles(u[i]));
    let cycles = if y.is_empty() || !x.is_empty() && x.len() <= y.len() { x } else { y };
    let length = |a: &[f64], b: &[f64], of: [f64; 2]| {
        a.iter().zip(b).map(|(a, b)| (a - of[0]).hypot(b - of[1])).fold(0.0, f64::max)
    };
    cycles
        .into_iter()
        .filter(|c| u.iter().chain(&f).all(|v| v.len() >= c.samples.end))
        .map(|cycle| {
            let [ux, uy, fx, fy] = [u[0], u[1], f[0], f[1]].map(|v| &v[cycle.samples.clone()]);
            Orbit {
                directions: [Loop::of(ux, fx), Loop::of(uy, fy)],
                radius: length(ux, uy, detection.map(|d| d.centre)),
                force: length(fx, fy, [0.0; 2]),
                cycle,
            }
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::{CycleDetection, orbits};
    use std::f64::consts::TAU;

    #[test]
    fn rounds_of_circle_and_figure_of_eight() {
        let phase: Vec<f64> = (0..=3000).map(|i| 3.0 * TAU * f64::from(i) / 3000.0).collect();
        let of = |g: &dyn Fn(f64) -> f64| phase.iter().map(|p| g(*p)).collect::<Vec<f64>>();
        let detection = CycleDetection::default();
        // Friction of 2 along a circle of radius 0.5: the force has the direction of the velocity.
        let (ux, uy) = (of(&|p| 0.5 * p.cos()), of(&|p| 0.5 * p.sin()));
        let (fx, fy) = (of(&|p| -2.0 * p.sin()), of(&|p| 2.0 * p.cos()));
        let rounds = orbits([&ux, &uy], [&fx, &fy], [&detection; 2]);
        assert_eq!(rounds.iter().filter(|r| r.cycle.complete).count(), 3);
        let r = &rounds[1];
        assert!((r.energy() - 2.0 * TAU * 0.5).abs() < 1e-3 && (r.radius - 0.5).abs() < 1e-12);
        assert!((r.force - 2.0).abs() < 1e-12);
        let (ux, uy) = (of(&|p| p.sin()), of(&|p| (2.0 * p).sin()));
        assert_eq!(orbits([&ux, &uy], [&ux, &uy], [&detection; 2]).len(), 3);
        assert!(orbits([&ux, &uy], [&ux, &uy], [&detection; 2])[1].energy().abs() < 1e-12);
    }
}
