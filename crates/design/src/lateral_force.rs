//! Equivalent lateral force procedure for isolated structures: one degree of freedom on a bilinear isolation system.

use crate::codes::Code;
use std::f64::consts::{PI, TAU};

/// A bilinear isolation system and what stands on it, in consistent units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct System {
    /// Sum of the characteristic strengths.
    pub q_d: f64,
    /// Sum of the post-elastic stiffnesses.
    pub k_d: f64,
    /// Displacement D_y at which the system yields.
    pub yield_displacement: f64,
    /// Weight on the isolation system.
    pub weight: f64,
    /// Weight of the structure above without the base level.
    pub weight_above: f64,
    /// Acceleration of gravity.
    pub gravity: f64,
    /// True if the loop turns abruptly at the yield displacement.
    pub abrupt: bool,
}

/// Result of the procedure.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LateralForce {
    /// Displacement D_M.
    pub displacement: f64,
    /// Effective stiffness k_M.
    pub stiffness: f64,
    /// Effective period T_M in s.
    pub period: f64,
    /// Effective damping β_M.
    pub damping: f64,
    /// Damping coefficient B_M.
    pub coefficient: f64,
    /// Shear below the isolation system V_b = k_M D_M.
    pub shear_below: f64,
    /// Unreduced shear above V_st = V_b (W_s/W)^(1 - c β_M) with the code's c for smooth or abrupt loops; NaN without it.
    pub shear_above: f64,
    /// Number of iterations.
    pub iterations: usize,
}

/// Relative change of the displacement at which the iteration ends.
const TOLERANCE: f64 = 1e-10;
/// Iterations at most.
const MAX_ITERATIONS: usize = 500;

impl System {
    /// Iterate on the displacement: k = K_d + Q_d/D, β = 4 Q_d (D - D_y)/(2π k D²), T = 2π sqrt(W/(k g)),
    /// D = S_a(T) (T/2π)²/B(β). `acceleration` is the spectrum of 5 % damping in the unit of `gravity`. With S_a = g S_1/T
    /// this is D_M = g S_M1 T_M/(4π² B_M).
    ///
    /// # Errors
    /// The code has no damping coefficient, the spectrum no value at a period, or the iteration does not end.
    pub fn procedure(&self, acceleration: impl Fn(f64) -> f64, code: &Code) -> Result<LateralForce, String> {
        let mut d = acceleration(2.0) * (2.0 / TAU).powi(2);
        for iteration in 1..=MAX_ITERATIONS {
            let stiffness = self.k_d + self.q_d / d;
            let energy = 4.0 * self.q_d * (d - self.yield_displacement).max(0.0);
            let damping = energy / (TAU * stiffness * d * d);
            let period = TAU * (self.weight / (stiffness * self.gravity)).sqrt();
            let coefficient = code.damping_coefficient(damping).ok_or("the code has no damping coefficient")?;
            let next = acceleration(period) * (period / TAU).powi(2) / coefficient;
            if !(next.is_finite() && next > 0.0) {
                return Err(format!("the target spectrum has no value at the period {period:.3} s"));
            }
            if (next / d - 1.0).abs() < TOLERANCE {
                let shear_below = stiffness * d;
                let shape = if self.abrupt { "abrupt" } else { "smooth" };
                let share = code.value("force_above", shape).unwrap_or(f64::NAN);
                let shear_above = shear_below * (self.weight_above / self.weight).powf(1.0 - share * damping);
                let iterations = iteration;
                return Ok(LateralForce {
                    displacement: d,
                    stiffness,
                    period,
                    damping,
                    coefficient,
                    shear_below,
                    shear_above,
                    iterations,
                });
            }
            // Half of the change: the full one goes to and fro where the damping changes fast.
            d = 0.5 * (d + next);
        }
        Err(format!(
            "the displacement of the equivalent lateral force procedure did not settle in {MAX_ITERATIONS} iterations"
        ))
    }

    /// Force at D less the force at half of it, as a share of the weight.
    pub fn restoring_share(&self, displacement: f64) -> f64 {
        0.5 * self.k_d * displacement / self.weight
    }
}

/// Ratio D_TM/D_M at a distance from the center of rigidity (ASCE 7-16, equation 17.5-3): 1 + y/P_T² · 12 e/(b² + d²).
///
/// `torsion` is P_T, the ratio of the translational to the torsional period, at least 1; `plan` are b and d.
pub fn torsional_ratio(distance: f64, eccentricity: f64, plan: [f64; 2], torsion: f64) -> f64 {
    let [b, d] = plan;
    1.0 + distance / torsion.max(1.0).powi(2) * 12.0 * eccentricity / (b * b + d * d)
}

/// P_T of equal bearings at points relative to the center of mass: sqrt(Σ(x² + y²)/N)/r with r² = (b² + d²)/12.
pub fn torsional_period_ratio(points: &[[f64; 2]], plan: [f64; 2]) -> f64 {
    let radius = ((plan[0].powi(2) + plan[1].powi(2)) / 12.0).sqrt();
    let mean = points.iter().map(|p| p[0].powi(2) + p[1].powi(2)).sum::<f64>() / points.len().max(1) as f64;
    mean.sqrt() / radius
}

/// Ratio of the overlapping to the whole area of a round bearing of a diameter at a displacement:
/// (δ - sin δ)/π with δ = 2 acos(D/B) (MCEER-06-SP07; Buckle and Liu 1994).
pub fn overlap(displacement: f64, diameter: f64) -> f64 {
    let delta = 2.0 * (displacement / diameter).clamp(0.0, 1.0).acos();
    (delta - delta.sin()) / PI
}

#[cfg(test)]
mod tests {
    use super::{System, overlap, torsional_period_ratio, torsional_ratio};
    use crate::codes::Code;
    use std::f64::consts::{PI, TAU};

    /// By hand: Q_d = 0.05 W, D_y = 0.01 m, S_M1 = 0.9. For T_M = 3 s and D from it the K_d that belongs to it follows, so
    /// that the procedure must find both again.
    #[test]
    fn hand_calculation_of_a_single_degree_of_freedom() {
        let (w, g, sm1, dy) = (10_000.0, 9.81, 0.9, 0.01);
        let code = Code::named("asce7-16").expect("a code");
        let (q, t): (f64, f64) = (0.05 * w, 3.0);
        let k = w / g * (TAU / t).powi(2);
        // D = g S T/(4π² B), β = 2 Q (D - D_y)/(π k D²): by substitution, starting from B = 1.
        let mut d = g * sm1 * t / (4.0 * PI * PI);
        for _ in 0..200 {
            let beta = 2.0 * q * (d - dy) / (PI * k * d * d);
            let table = [(0.02, 0.8), (0.05, 1.0), (0.1, 1.2), (0.2, 1.5), (0.3, 1.7)];
            let i = table.iter().position(|r| r.0 >= beta).expect("within the table");
            let (x, y) = (table[i - 1], table[i]);
            let b = x.1 + (y.1 - x.1) * (beta - x.0) / (y.0 - x.0);
            d = g * sm1 * t / (4.0 * PI * PI * b);
        }
        let system = System {
            q_d: q,
            k_d: k - q / d,
            yield_displacement: dy,
            weight: w,
            weight_above: 0.8 * w,
            gravity: g,
            abrupt: false,
        };
        let found = system.procedure(|t| g * sm1 / t, &code).expect("a result");
        assert!((found.displacement / d - 1.0).abs() < 1e-8, "{found:?} {d}");
        assert!((found.period - t).abs() < 1e-7 && (found.shear_below / (k * d) - 1.0).abs() < 1e-8);
        let exponent = 1.0 - 2.5 * found.damping;
        assert!((found.shear_above / (k * d * 0.8f64.powf(exponent)) - 1.0).abs() < 1e-8);
        let turned = System { abrupt: true, ..system }.procedure(|t| g * sm1 / t, &code).expect("a result");
        let exponent = 1.0 - 3.5 * found.damping;
        assert!((turned.shear_above / (k * d * 0.8f64.powf(exponent)) - 1.0).abs() < 1e-8);
        assert!(turned.shear_above > found.shear_above);
        let share = (system.q_d + system.k_d * d) - (system.q_d + system.k_d * d / 2.0);
        assert!((system.restoring_share(d) - share / w).abs() < 1e-12);
    }

    #[test]
    fn plan_of_a_square_with_bearings_all_over_it() {
        // Bearings spread evenly have the radius of the plan: P_T = 1. At a corner D_TM/D_M = 1 + (b/2) 12 (0.05 b)/(2 b²).
        let n = 200;
        let at = |i: i32| (f64::from(i) + 0.5) / f64::from(n) * 20.0 - 10.0;
        let points: Vec<[f64; 2]> = (0..n).flat_map(|i| (0..n).map(move |j| [at(i), at(j)])).collect();
        let pt = torsional_period_ratio(&points, [20.0, 20.0]);
        assert!((pt - 1.0).abs() < 1e-4);
        assert!((torsional_ratio(10.0, 1.0, [20.0, 20.0], pt) - 1.15).abs() < 1e-4);
    }

    #[test]
    fn overlap_of_two_circles() {
        assert!((overlap(0.0, 1.0) - 1.0).abs() < 1e-12 && overlap(1.0, 1.0).abs() < 1e-12);
        // By counting: circles of diameter 1 whose centers are 0.4 apart.
        let n = 2000;
        let mut both = 0;
        for i in 0..n {
            for j in 0..n {
                let (x, y) = (f64::from(i) / f64::from(n) - 0.5, f64::from(j) / f64::from(n) - 0.5);
                both += i32::from(x.hypot(y) < 0.5 && (x - 0.4).hypot(y) < 0.5);
            }
        }
        let counted = f64::from(both) / f64::from(n).powi(2) / (PI / 4.0);
        assert!((overlap(0.4, 1.0) - counted).abs() < 1e-3);
    }
}
