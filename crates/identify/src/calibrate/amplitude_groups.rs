//! Errors by amplitude: secant stiffness, dissipated energy and equivalent damping of simulated over recorded cycles
//! (Table 10 of the paper).

use crate::measure::{CycleDetection, Loop};
use serde::Serialize;

/// Mean measures of cycles of about the same amplitude.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct AmplitudeGroup {
    /// Mean amplitude, in the unit of the displacement.
    pub amplitude: f64,
    /// Number of cycles.
    pub cycles: usize,
    /// Secant stiffness K = (F_max - F_min)/(u_max - u_min), recorded and simulated.
    pub stiffness: [f64; 2],
    /// Dissipated energy E of a cycle, recorded and simulated.
    pub energy: [f64; 2],
    /// Equivalent damping ξ = E/(2π K u²), recorded and simulated.
    pub damping: [f64; 2],
}

impl AmplitudeGroup {
    /// Relative error of a measure: simulated/recorded - 1.
    pub fn error([recorded, simulated]: [f64; 2]) -> f64 {
        simulated / recorded - 1.0
    }
}

/// Amplitudes of a group differ by less than this share of the largest amplitude.
const GROUP_WIDTH: f64 = 0.06;

/// Groups of complete cycles of force over displacement `u`, by increasing amplitude. Samples that are NaN in any of the
/// three are left out.
pub fn amplitude_groups(u: &[f64], recorded: &[f64], simulated: &[f64]) -> Vec<AmplitudeGroup> {
    let there = |i: &usize| !(u[*i].is_nan() || recorded[*i].is_nan() || simulated[*i].is_nan());
    let kept: Vec<usize> = (0..u.len().min(recorded.len()).min(simulated.len())).filter(there).collect();
    let [u, recorded, simulated] = [u, recorded, simulated].map(|v| kept.iter().map(|i| v[*i]).collect::<Vec<f64>>());
    let cycles = CycleDetection::default().cycles(&u);
    let mut loops: Vec<[Loop; 2]> = cycles
        .into_iter()
        .filter(|c| c.complete)
        .map(|c| [&recorded, &simulated].map(|f| Loop::of(&u[c.samples.clone()], &f[c.samples.clone()])))
        .collect();
    loops.sort_by(|a, b| a[0].amplitude().total_cmp(&b[0].amplitude()));
    let largest = loops.last().map_or(0.0, |l| l[0].amplitude());
    let mut groups: Vec<Vec<[Loop; 2]>> = vec![];
    for l in loops {
        match groups.last_mut() {
            Some(g) if l[0].amplitude() - g[0][0].amplitude() < GROUP_WIDTH * largest => g.push(l),
            _ => groups.push(vec![l]),
        }
    }
    let mean = |g: &[[Loop; 2]], of: fn(&Loop) -> f64| {
        [0, 1].map(|k| g.iter().map(|l| of(&l[k])).sum::<f64>() / g.len() as f64)
    };
    let group = |g: &Vec<[Loop; 2]>| AmplitudeGroup {
        amplitude: mean(g, Loop::amplitude)[0],
        cycles: g.len(),
        stiffness: mean(g, Loop::stiffness),
        energy: mean(g, |l| l.energy),
        damping: mean(g, Loop::damping),
    };
    groups.iter().map(group).collect()
}

#[cfg(test)]
mod tests {
    use super::{AmplitudeGroup, amplitude_groups};
    use std::f64::consts::TAU;

    #[test]
    fn measures_of_ellipses_at_two_amplitudes() {
        // Spring 2 and damper against spring 3 and the same damper, at two amplitudes, two cycles each.
        let phase: Vec<f64> = (0..=4000).map(|i| 4.0 * TAU * f64::from(i) / 4000.0).collect();
        let size = |p: f64| if p < 2.0 * TAU { 1.0 } else { 2.0 };
        let u: Vec<f64> = phase.iter().map(|p| size(*p) * p.sin()).collect();
        let force = |k: f64| phase.iter().map(|p| size(*p) * (k * p.sin() + 0.4 * p.cos())).collect::<Vec<f64>>();
        let groups = amplitude_groups(&u, &force(2.0), &force(3.0));
        assert_eq!(groups.iter().map(|a| a.cycles).collect::<Vec<_>>(), [2, 2]);
        for a in groups {
            let stiffer = 3.0f64.hypot(0.4) / 2.0f64.hypot(0.4);
            assert!((AmplitudeGroup::error(a.stiffness) - (stiffer - 1.0)).abs() < 0.01, "{a:?}");
            assert!(AmplitudeGroup::error(a.energy).abs() < 1e-9 && AmplitudeGroup::error(a.damping) < -0.3);
        }
    }
}
