//! Trends over cycles, energy and velocity.

use super::{PrototypeTest, TestCycle};

/// Trends of a set of tests. A value is NaN where the tests do not show it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Trends {
    /// First over third cycle of K_eff in the first test: scragging of rubber that is new.
    pub scragging: f64,
    /// Change of Q_d as a share of the first cycle's, for each unit of dissipated energy: the slope of a line through the
    /// cycles of one amplitude of the longest test. Heating makes it negative.
    pub heating: f64,
    /// Exponent n of Q_d ∝ vⁿ over tests of one amplitude at different velocities.
    pub rate_strength: f64,
    /// Exponent n of K_eff ∝ vⁿ over such tests.
    pub rate_stiffness: f64,
}

/// Relative difference of amplitudes that count as one.
pub(super) const SAME_AMPLITUDE: f64 = 0.1;
/// Ratio of velocities that count as different.
const OTHER_VELOCITY: f64 = 1.5;

/// True if two amplitudes count as one.
pub(super) fn is_same(a: f64, b: f64) -> bool {
    (a - b).abs() <= SAME_AMPLITUDE * a.max(b)
}

/// Slope of a line through points by least squares; NaN if the abscissas do not differ.
fn slope(points: &[(f64, f64)]) -> f64 {
    let n = points.len() as f64;
    let (mx, my) = points.iter().fold((0.0, 0.0), |m, p| (m.0 + p.0 / n, m.1 + p.1 / n));
    let (top, bottom) =
        points.iter().fold((0.0, 0.0), |s, p| (s.0 + (p.0 - mx) * (p.1 - my), s.1 + (p.0 - mx).powi(2)));
    if points.len() < 2 || bottom == 0.0 { f64::NAN } else { top / bottom }
}

/// Trends of tests in the order in which they were made.
pub fn trends(tests: &[PrototypeTest]) -> Trends {
    let third = |t: &PrototypeTest| {
        let same: Vec<&TestCycle> = t.cycles.iter().filter(|c| is_same(c.amplitude, t.cycles[0].amplitude)).collect();
        same.get(2).map(|c| same[0].k_eff / c.k_eff)
    };
    let longest = tests.iter().max_by_key(|t| t.cycles.len());
    let heating = longest.map(|t| {
        let first = t.cycles.iter().find(|c| is_same(c.amplitude, t.amplitude()));
        let same = t.cycles.iter().filter(|c| is_same(c.amplitude, t.amplitude()) && c.q_d.is_finite());
        let points: Vec<(f64, f64)> =
            same.map(|c| (c.energy - 0.5 * c.edc, c.q_d / first.map_or(f64::NAN, |f| f.q_d))).collect();
        if points.len() > 2 { slope(&points) } else { f64::NAN }
    });
    Trends {
        scragging: tests.first().and_then(third).unwrap_or(f64::NAN),
        heating: heating.unwrap_or(f64::NAN),
        rate_strength: exponent(tests, |c| c.q_d),
        rate_stiffness: exponent(tests, |c| c.k_eff),
    }
}

/// Exponent of the velocity in a measure of the first cycles, over all groups of tests of one amplitude. The mean over the
/// groups is taken out first.
fn exponent(tests: &[PrototypeTest], of: impl Fn(&TestCycle) -> f64) -> f64 {
    let mut points: Vec<(f64, f64)> = vec![];
    let mut is_used = vec![false; tests.len()];
    for i in 0..tests.len() {
        if is_used[i] {
            continue;
        }
        let mut group = vec![];
        for (j, t) in tests.iter().enumerate().skip(i) {
            let c = &t.cycles[0];
            if !is_used[j] && is_same(c.amplitude, tests[i].cycles[0].amplitude) {
                is_used[j] = true;
                if c.velocity > 0.0 && of(c) > 0.0 {
                    group.push((c.velocity.ln(), of(c).ln()));
                }
            }
        }
        let ends = group.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |m, p| (m.0.min(p.0), m.1.max(p.0)));
        if group.len() > 1 && ends.1 - ends.0 > OTHER_VELOCITY.ln() {
            let n = group.len() as f64;
            let mean = group.iter().fold((0.0, 0.0), |m, p| (m.0 + p.0 / n, m.1 + p.1 / n));
            points.extend(group.iter().map(|p| (p.0 - mean.0, p.1 - mean.1)));
        }
    }
    slope(&points)
}

#[cfg(test)]
mod tests {
    use super::super::{PrototypeTest, TestCycle};
    use super::trends;

    #[test]
    fn trends_of_cycles_made_by_formulas() {
        let cycle = |number: usize, velocity: f64, k_eff: f64, q_d: f64, energy: f64| TestCycle {
            number,
            amplitude: 0.2,
            k_eff,
            q_d,
            velocity,
            edc: 10.0,
            energy,
            ..TestCycle::default()
        };
        // Q falls by 1 % per unit of energy at the middle of each cycle; both follow v to the power of 0.05 and 0.1.
        let test = |v: f64| {
            let of = |i: usize| {
                let energy = 10.0 * (i + 1) as f64;
                let q = 100.0 * v.powf(0.1) * (1.0 - 0.01 * (energy - 10.0));
                cycle(i + 1, v, [1.2, 1.1, 1.0, 1.0][i] * v.powf(0.05), q, energy)
            };
            PrototypeTest { name: "t".into(), cycles: (0..4).map(of).collect() }
        };
        let t = trends(&[test(0.1), test(0.4), test(0.8)]);
        assert!((t.scragging - 1.2).abs() < 1e-12 && (t.heating + 0.01).abs() < 1e-12);
        assert!((t.rate_strength - 0.1).abs() < 1e-9 && (t.rate_stiffness - 0.05).abs() < 1e-9);
        let one = trends(&[test(0.1)]);
        assert!(one.rate_strength.is_nan() && one.rate_stiffness.is_nan());
    }
}
