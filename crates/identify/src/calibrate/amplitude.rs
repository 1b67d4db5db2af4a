//! Errors by amplitude: secant stiffness, dissipated energy and equivalent damping of the cycles, simulated over recorded,
//! as Table 10 of the paper has them.

use crate::measure::{Loop, Split};
use serde::Serialize;

/// Cycles of about the same amplitude, their measures averaged.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Amplitude {
    /// Mean amplitude, in the unit of the displacement.
    pub amplitude: f64,
    /// How many cycles.
    pub cycles: usize,
    /// Secant stiffness K = (F_max - F_min)/(u_max - u_min), recorded and simulated.
    pub stiffness: [f64; 2],
    /// Dissipated energy E of a cycle, likewise.
    pub energy: [f64; 2],
    /// Equivalent damping ξ = E/(2π K u²), likewise.
    pub damping: [f64; 2],
}

impl Amplitude {
    /// Error of a pair: simulated over recorded, less one.
    pub fn error([recorded, simulated]: [f64; 2]) -> f64 {
        simulated / recorded - 1.0
    }
}

/// Cycles whose amplitudes differ by less than this part of the largest belong together.
const SAME: f64 = 0.06;

/// Measures of a force over a displacement by amplitude, from the smallest; samples that are missing anywhere are passed
/// over. Empty where there are no complete cycles.
pub fn amplitudes(u: &[f64], recorded: &[f64], simulated: &[f64]) -> Vec<Amplitude> {
    let there = |i: &usize| !(u[*i].is_nan() || recorded[*i].is_nan() || simulated[*i].is_nan());
    let kept: Vec<usize> = (0..u.len().min(recorded.len()).min(simulated.len())).filter(there).collect();
    let [u, recorded, simulated] = [u, recorded, simulated].map(|v| kept.iter().map(|i| v[*i]).collect::<Vec<f64>>());
    let cycles = Split::default().cycles(&u);
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
            Some(g) if l[0].amplitude() - g[0][0].amplitude() < SAME * largest => g.push(l),
            _ => groups.push(vec![l]),
        }
    }
    let mean = |g: &[[Loop; 2]], of: fn(&Loop) -> f64| {
        [0, 1].map(|k| g.iter().map(|l| of(&l[k])).sum::<f64>() / g.len() as f64)
    };
    let group = |g: &Vec<[Loop; 2]>| Amplitude {
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
    use super::{Amplitude, amplitudes};
    use std::f64::consts::TAU;

    #[test]
    fn two_ellipses() {
        // Spring 2 and damper against spring 3 and the same damper, at two amplitudes, two cycles each.
        let phase: Vec<f64> = (0..=4000).map(|i| 4.0 * TAU * f64::from(i) / 4000.0).collect();
        let size = |p: f64| if p < 2.0 * TAU { 1.0 } else { 2.0 };
        let u: Vec<f64> = phase.iter().map(|p| size(*p) * p.sin()).collect();
        let force = |k: f64| phase.iter().map(|p| size(*p) * (k * p.sin() + 0.4 * p.cos())).collect::<Vec<f64>>();
        let all = amplitudes(&u, &force(2.0), &force(3.0));
        assert_eq!(all.iter().map(|a| a.cycles).collect::<Vec<_>>(), [2, 2]);
        for a in all {
            let stiffer = 3.0f64.hypot(0.4) / 2.0f64.hypot(0.4);
            assert!((Amplitude::error(a.stiffness) - (stiffer - 1.0)).abs() < 0.01, "{a:?}");
            assert!(Amplitude::error(a.energy).abs() < 1e-9 && Amplitude::error(a.damping) < -0.3);
        }
    }
}
