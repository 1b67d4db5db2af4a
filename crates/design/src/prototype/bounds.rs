//! Lower and upper bounds of the properties of an isolator.

use super::trends::is_same;
use super::{PrototypeTest, TestCycle};
use crate::codes::Code;

/// Nominal properties at the design displacement.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Nominal {
    /// Displacement that they hold for.
    pub amplitude: f64,
    /// Effective stiffness.
    pub k_eff: f64,
    /// Characteristic strength.
    pub q_d: f64,
    /// Post-elastic stiffness.
    pub k_d: f64,
    /// Number of tests whose means these are; 0 if the design states them.
    pub tests: usize,
}

/// Factors on Q_d and on K_d.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Factors {
    /// On the characteristic strength.
    pub q_d: f64,
    /// On the post-elastic stiffness.
    pub k_d: f64,
}

impl Factors {
    /// The same factor on both.
    pub const ONE: Self = Self { q_d: 1.0, k_d: 1.0 };

    fn joined(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        Self { q_d: f(self.q_d, other.q_d), k_d: f(self.k_d, other.k_d) }
    }
}

/// Property-modification factors of a bound by their cause.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BoundFactors {
    /// Aging and environment (temperature, contamination, travel), multiplied.
    pub aging: Factors,
    /// Permitted deviation of production.
    pub specification: Factors,
}

/// Q_d and K_d of a bound.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Properties {
    /// Characteristic strength.
    pub q_d: f64,
    /// Post-elastic stiffness.
    pub k_d: f64,
}

impl Properties {
    /// Effective stiffness at a displacement.
    pub fn k_eff(&self, amplitude: f64) -> f64 {
        self.k_d + self.q_d / amplitude
    }
}

/// Bounds with the factors of the tests.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// Least factors of the tests.
    pub test_min: Factors,
    /// Largest factors of the tests.
    pub test_max: Factors,
    /// Factors of the lower bound.
    pub lambda_min: Factors,
    /// Factors of the upper bound.
    pub lambda_max: Factors,
    /// Properties of the lower bound.
    pub lower: Properties,
    /// Nominal properties.
    pub nominal: Properties,
    /// Properties of the upper bound.
    pub upper: Properties,
}

impl Nominal {
    /// Means of the first three cycles of each test at a design displacement, the largest one if none is given.
    ///
    /// # Errors
    /// There is no cycle at the displacement, its loops supply energy, or none of them is bilinear.
    pub fn of(tests: &[PrototypeTest], design: Option<f64>) -> Result<Self, String> {
        let amplitude = design.unwrap_or_else(|| tests.iter().map(PrototypeTest::amplitude).fold(0.0, f64::max));
        let cycles = at_design(tests, amplitude, 3);
        if cycles.is_empty() {
            return Err(no_cycle(tests, amplitude));
        }
        let count = tests.iter().filter(|t| !at_design(std::slice::from_ref(t), amplitude, 1).is_empty()).count();
        let mean = |of: fn(&TestCycle) -> f64| cycles.iter().map(of).sum::<f64>() / cycles.len() as f64;
        Ok(Self { amplitude, k_eff: mean(|c| c.k_eff), q_d: mean(|c| c.q_d), k_d: mean(|c| c.k_d), tests: count })
    }
}

/// The reason why no cycle has the properties at a displacement.
fn no_cycle(tests: &[PrototypeTest], amplitude: f64) -> String {
    let all = || tests.iter().flat_map(|t| &t.cycles);
    let near: Vec<&TestCycle> = all().filter(|c| is_same(c.amplitude, amplitude)).collect();
    if near.is_empty() {
        let mut found: Vec<String> = tests.iter().map(|t| format!("{:.4}", t.amplitude())).collect();
        found.dedup();
        return format!("no test has a cycle at the displacement {amplitude}: the amplitudes are {}", found.join(", "));
    }
    if near.iter().all(|c| c.edc < 0.0) {
        return format!(
            "the loops at the displacement {amplitude} supply energy: is the force turned? --force-factor -1 turns it"
        );
    }
    format!("no cycle at the displacement {amplitude} has a bilinear loop: its energy is beyond that of any")
}

/// The first cycles of each test at a displacement.
fn at_design(tests: &[PrototypeTest], amplitude: f64, count: usize) -> Vec<TestCycle> {
    let of = |t: &PrototypeTest| {
        let same = t.cycles.iter().filter(|c| is_same(c.amplitude, amplitude) && c.q_d.is_finite());
        same.take(count).copied().collect::<Vec<_>>()
    };
    tests.iter().flat_map(of).collect()
}

impl Bounds {
    /// Bounds of nominal properties: λ = [1 + share (λ_ae - 1)] λ_test λ_spec, with the system adjustment of a code
    /// (ASCE 7-16, equations 17.2-1 and 17.2-2). λ_test is the extreme over the cycles at the nominal displacement.
    pub fn new(
        tests: &[PrototypeTest],
        nominal: &Nominal,
        lower: BoundFactors,
        upper: BoundFactors,
        code: &Code,
    ) -> Self {
        let cycles = at_design(tests, nominal.amplitude, usize::MAX);
        let extreme = |f: fn(f64, f64) -> f64| {
            cycles.iter().fold(Factors::ONE, |m, c| {
                let here = Factors { q_d: c.q_d / nominal.q_d, k_d: c.k_d / nominal.k_d };
                m.joined(here, f)
            })
        };
        let (test_min, test_max) = (extreme(f64::min), extreme(f64::max));
        let share = code.value("system_adjustment", "share").unwrap_or(1.0);
        let total = |b: BoundFactors, test: Factors| {
            let adjusted = b.aging.joined(b.aging, |a, _| 1.0 + share * (a - 1.0));
            adjusted.joined(test, |a, t| a * t).joined(b.specification, |a, s| a * s)
        };
        let (lambda_min, lambda_max) = (total(lower, test_min), total(upper, test_max));
        let of = |l: Factors| Properties { q_d: l.q_d * nominal.q_d, k_d: l.k_d * nominal.k_d };
        Self {
            test_min,
            test_max,
            lambda_min,
            lambda_max,
            lower: of(lambda_min),
            nominal: of(Factors::ONE),
            upper: of(lambda_max),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::{PrototypeTest, TestCycle};
    use super::{BoundFactors, Bounds, Factors, Nominal};
    use crate::codes::Code;

    #[test]
    fn factors_are_multiplied_with_the_system_adjustment() {
        let cycle = |q_d: f64, k_d: f64| TestCycle { amplitude: 0.3, q_d, k_d, k_eff: k_d, ..TestCycle::default() };
        let cycles = vec![cycle(120.0, 510.0), cycle(100.0, 500.0), cycle(80.0, 490.0), cycle(70.0, 480.0)];
        let tests = [PrototypeTest { name: "t".into(), cycles }];
        let nominal = Nominal::of(&tests, None).expect("nominal");
        assert!((nominal.q_d - 100.0).abs() < 1e-12 && (nominal.k_d - 500.0).abs() < 1e-12);
        let code = Code::named("asce7-16").expect("a code");
        let factors = |a: f64, s: f64| BoundFactors {
            aging: Factors { q_d: a, k_d: 1.0 },
            specification: Factors { q_d: s, k_d: s },
        };
        let b = Bounds::new(&tests, &nominal, factors(0.9, 0.85), factors(1.4, 1.15), &code);
        assert!((b.upper.q_d - 100.0 * (1.0 + 0.75 * 0.4) * 1.2 * 1.15).abs() < 1e-9);
        assert!((b.lower.q_d - 100.0 * (1.0 - 0.75 * 0.1) * 0.7 * 0.85).abs() < 1e-9);
        assert!((b.upper.k_d - 500.0 * 1.02 * 1.15).abs() < 1e-9 && (b.lower.k_d - 500.0 * 0.96 * 0.85).abs() < 1e-9);
        assert!(Nominal::of(&tests, Some(1.0)).is_err_and(|e| e.contains("the amplitudes are 0.3000")));
    }

    /// Loops of a turned force supply energy; loops of too much energy are not bilinear, and nothing is turned.
    #[test]
    fn a_turned_force_is_told() {
        let refused = |edc: f64| {
            let cycle = TestCycle { amplitude: 0.3, edc, q_d: f64::NAN, ..TestCycle::default() };
            let tests = [PrototypeTest { name: "t".into(), cycles: vec![cycle] }];
            Nominal::of(&tests, None).expect_err("no bilinear loop").contains("--force-factor -1")
        };
        assert!(refused(-1.0) && !refused(1.0));
    }
}
