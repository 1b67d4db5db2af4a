//! Prototype tests of isolators: measures of each cycle, trends, acceptance, bounds of properties.
//!
//! Symbols are those of ASCE 7 and AASHTO: effective stiffness K_eff, energy dissipated per cycle EDC, effective damping
//! β_eff = EDC/(2π K_eff D²), characteristic strength Q_d, post-elastic stiffness K_d.

mod acceptance;
mod bounds;
mod posterior;
pub mod report;
mod script_lines;
mod trends;

pub use acceptance::{TestDesign, acceptance};
pub use bounds::{BoundFactors, Bounds, Factors, Nominal, Properties};
pub use posterior::Posterior;
pub use script_lines::{Rubber, script_lines};
pub use trends::{Trends, trends};

use hysteron_identify::measure::{CycleDetection, Loop};
use hysteron_identify::report::{Cell, Table};
use std::f64::consts::TAU;

/// Measures of one cycle.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct TestCycle {
    /// Number in its test, from 1.
    pub number: usize,
    /// Displacement amplitude D.
    pub amplitude: f64,
    /// Secant stiffness.
    pub k_eff: f64,
    /// Energy dissipated.
    pub edc: f64,
    /// Effective damping.
    pub beta: f64,
    /// Characteristic strength of the bilinear loop of the same energy.
    pub q_d: f64,
    /// Half of the distance between the forces at zero displacement.
    pub q_0: f64,
    /// Post-elastic stiffness of that loop.
    pub k_d: f64,
    /// Largest force.
    pub force: f64,
    /// Largest velocity; NaN without times.
    pub velocity: f64,
    /// Energy dissipated in the test up to the end of the cycle.
    pub energy: f64,
}

/// A test: cycles of one specimen.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PrototypeTest {
    /// Name.
    pub name: String,
    /// Complete two-sided cycles, in order.
    pub cycles: Vec<TestCycle>,
}

/// Record of a test.
#[derive(Clone, Copy, Debug)]
pub struct TestRecord<'a> {
    /// Times; none if they are not known.
    pub time: Option<&'a [f64]>,
    /// Displacements.
    pub u: &'a [f64],
    /// Forces.
    pub f: &'a [f64],
}

/// Q_d and K_d of the bilinear loop of an effective stiffness and energy at an amplitude, with an elastic stiffness of
/// `ratio` times K_d: EDC = 4 Q_d (D - D_y), K_eff = K_d + Q_d/D, D_y = Q_d/((ratio - 1) K_d).
///
/// Returns NaN if no such loop has so much energy.
pub fn bilinear(amplitude: f64, k_eff: f64, edc: f64, ratio: f64) -> (f64, f64) {
    let q_of = |y: f64| edc / (4.0 * (amplitude - y));
    // With x = Q_d/(K_eff D), D_y/D = x/((r-1)(1-x)) and EDC/(4 K_eff D²) = x (1 - D_y/D), which rises with x up to the
    // largest loop. Bisection is safe on the rising part.
    let wanted = edc / (4.0 * k_eff * amplitude * amplitude);
    let area = |x: f64| x * (1.0 - x / ((ratio - 1.0) * (1.0 - x)));
    let (mut low, mut high) = (0.0, 1.0 - 1.0 / ratio);
    // The largest area on the way to an elastic loop.
    for _ in 0..200 {
        let (a, b) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
        if area(a) < area(b) { low = a } else { high = b }
    }
    let top = 0.5 * (low + high);
    if !(wanted > 0.0 && wanted <= area(top)) {
        return if wanted == 0.0 { (0.0, k_eff) } else { (f64::NAN, f64::NAN) };
    }
    (low, high) = (0.0, top);
    for _ in 0..200 {
        let x = 0.5 * (low + high);
        if area(x) < wanted { low = x } else { high = x }
    }
    let x = 0.5 * (low + high);
    let q = q_of(amplitude * x / ((ratio - 1.0) * (1.0 - x)));
    (q, k_eff - q / amplitude)
}

/// Half of the distance between the forces where the displacement passes the centre.
fn intercept(u: &[f64], f: &[f64], centre: f64) -> f64 {
    let (mut up, mut down) = (vec![], vec![]);
    for i in 1..u.len() {
        let (a, b) = (u[i - 1] - centre, u[i] - centre);
        if (a < 0.0) != (b < 0.0) && a != b {
            let force = f[i - 1] + (f[i] - f[i - 1]) * a / (a - b);
            if b > a { up.push(force) } else { down.push(force) }
        }
    }
    let mean = |x: &[f64]| x.iter().sum::<f64>() / x.len() as f64;
    0.5 * (mean(&up) - mean(&down))
}

impl PrototypeTest {
    /// The complete cycles of a record on both sides. `ratio` is the elastic stiffness over K_d.
    ///
    /// # Errors
    /// There is no such cycle.
    pub fn measure(
        name: &str,
        record: &TestRecord<'_>,
        detection: &CycleDetection,
        ratio: f64,
    ) -> Result<Self, String> {
        let mut test = Self { name: name.to_owned(), cycles: vec![] };
        let mut energy = 0.0;
        let cycles = detection.cycles(record.u);
        for c in cycles.iter().filter(|c| c.complete && c.sides == hysteron_identify::measure::Sides::Both) {
            let (u, f) = (&record.u[c.samples.clone()], &record.f[c.samples.clone()]);
            let l = Loop::of(u, f);
            let amplitude = l.amplitude();
            energy += l.energy;
            let (q_d, k_d) = bilinear(amplitude, l.stiffness(), l.energy, ratio);
            // The samples before and after the cycle hold its passages of the centre.
            let wide = c.samples.start.saturating_sub(1)..(c.samples.end + 1).min(record.u.len());
            test.cycles.push(TestCycle {
                number: test.cycles.len() + 1,
                amplitude,
                k_eff: l.stiffness(),
                edc: l.energy,
                beta: l.energy / (TAU * l.stiffness() * amplitude * amplitude),
                q_d,
                q_0: intercept(&record.u[wide.clone()], &record.f[wide], detection.centre),
                k_d,
                force: l.f_max.max(-l.f_min),
                velocity: record.time.map_or(f64::NAN, |t| velocity(&t[c.samples.clone()], u)),
                energy,
            });
        }
        if test.cycles.is_empty() {
            return Err(format!("{name} has no complete cycle on both sides"));
        }
        Ok(test)
    }

    /// Mean over the cycles of a measure.
    pub fn mean(&self, of: impl Fn(&TestCycle) -> f64) -> f64 {
        self.cycles.iter().map(of).sum::<f64>() / self.cycles.len() as f64
    }

    /// Largest amplitude.
    pub fn amplitude(&self) -> f64 {
        self.cycles.iter().map(|c| c.amplitude).fold(0.0, f64::max)
    }
}

/// Largest velocity by central differences.
fn velocity(t: &[f64], u: &[f64]) -> f64 {
    let between = |i: usize| ((u[i + 2] - u[i]) / (t[i + 2] - t[i])).abs();
    (0..u.len().saturating_sub(2)).map(between).filter(|v| v.is_finite()).fold(0.0, f64::max)
}

/// The cycles of tests as a table, with ratios to the first cycle of the test and to nominal values. `units` are the names
/// of the units of force and length.
pub fn cycle_table(tests: &[PrototypeTest], nominal: &Nominal, units: [&str; 2]) -> Table {
    let [force, length] = units;
    let stiffness = format!("{force}/{length}");
    let energy = format!("{force} {length}");
    let speed = format!("{length}/s");
    let mut table = Table::new([
        ("test", ""),
        ("cycle", ""),
        ("D", length),
        ("K_eff", &stiffness),
        ("EDC", &energy),
        ("beta_eff", ""),
        ("Q_d", force),
        ("Q_0", force),
        ("K_d", &stiffness),
        ("F_max", force),
        ("v_max", &speed),
        ("K_eff/first", ""),
        ("EDC/first", ""),
        ("K_eff/nominal", ""),
        ("Q_d/nominal", ""),
        ("K_d/nominal", ""),
    ]);
    let number = |x: f64| if x.is_finite() { Cell::Number(x) } else { Cell::Word("-") };
    for test in tests {
        let first = test.cycles[0];
        for c in &test.cycles {
            let mut row: Vec<Cell> = vec![test.name.clone().into(), (c.number as f64).into()];
            row.extend([c.amplitude, c.k_eff, c.edc, c.beta, c.q_d, c.q_0, c.k_d, c.force, c.velocity].map(number));
            row.extend([c.k_eff / first.k_eff, c.edc / first.edc].map(number));
            row.extend([c.k_eff / nominal.k_eff, c.q_d / nominal.q_d, c.k_d / nominal.k_d].map(number));
            table.rows.push(row);
        }
    }
    table
}

#[cfg(test)]
mod tests {
    use super::bilinear;

    #[test]
    fn bilinear_loops_are_found_again() {
        for (q, kd, ratio, d) in [(100.0, 500.0, 10.0, 0.3), (20.0, 800.0, 5.0, 0.1), (40.0, 40.0, 1000.0, 0.25)] {
            let y = q / ((ratio - 1.0) * kd);
            let (found_q, found_k) = bilinear(d, kd + q / d, 4.0 * q * (d - y), ratio);
            assert!((found_q / q - 1.0).abs() < 1e-9 && (found_k / kd - 1.0).abs() < 1e-9, "{found_q} {found_k}");
        }
        // More energy than a rectangle has.
        assert!(bilinear(1.0, 1.0, 4.1, 10.0).0.is_nan());
        assert_eq!(bilinear(1.0, 2.0, 0.0, 10.0), (0.0, 2.0));
    }
}
