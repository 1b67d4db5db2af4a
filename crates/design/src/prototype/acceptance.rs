//! Acceptance of prototype tests by the rules of a code.

use super::trends::is_same;
use super::{Nominal, PrototypeTest};
use crate::check::Check;
use crate::codes::Code;

/// Checks of each test, and of the set.
pub fn acceptance(tests: &[PrototypeTest], nominal: &Nominal, code: &Code) -> Vec<Check> {
    let mut out = vec![];
    for t in tests {
        // Ratios within a test are those of cycles of one amplitude.
        let amplitude = t.amplitude();
        let same: Vec<_> = t.cycles.iter().filter(|c| is_same(c.amplitude, amplitude)).collect();
        let n = same.len() as f64;
        let mean = same.iter().map(|c| c.k_eff).sum::<f64>() / n;
        let largest = |of: &dyn Fn(&super::TestCycle) -> f64| same.iter().map(|c| of(c)).fold(f64::MIN, f64::max);
        let least = |of: &dyn Fn(&super::TestCycle) -> f64| same.iter().map(|c| of(c)).fold(f64::MAX, f64::min);
        let deviation = largest(&|c| (c.k_eff / mean - 1.0).abs());
        let name = &t.name;
        if is_same(amplitude, nominal.amplitude) {
            let subject = format!("{name}: mean K_eff against nominal");
            out.push(Check::most_of(code, "test_stiffness_nominal", subject, (mean / nominal.k_eff - 1.0).abs()));
        }
        let rule = |rule: &str, what: &str, value: f64| Check::most_of(code, rule, format!("{name}: {what}"), value);
        out.push(rule("test_stiffness_cycle", "K_eff of a cycle against the mean of the test", deviation));
        let loss = |of: &dyn Fn(&super::TestCycle) -> f64| 1.0 - least(of) / largest(of);
        out.push(rule("test_stiffness_loss", "loss of K_eff over the cycles", loss(&|c| c.k_eff)));
        out.push(rule("test_energy_loss", "loss of EDC over the cycles", loss(&|c| c.edc)));
    }
    out.push(Check::least_of(code, "test_increment", "force over displacement: least slope between amplitudes", {
        increment(tests)
    }));
    out
}

/// Least slope of the largest force between cycles of different amplitudes; NaN with one amplitude alone.
fn increment(tests: &[PrototypeTest]) -> f64 {
    let mut points: Vec<(f64, f64)> =
        tests.iter().flat_map(|t| &t.cycles).map(|c| (c.amplitude, c.k_eff * c.amplitude)).collect();
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    // One point for cycles of the same amplitude: their mean.
    let mut groups: Vec<(f64, f64, f64)> = vec![];
    for (d, f) in points {
        match groups.last_mut().filter(|g| is_same(g.0 / g.2, d)) {
            Some(g) => *g = (g.0 + d, g.1 + f, g.2 + 1.0),
            None => groups.push((d, f, 1.0)),
        }
    }
    let means: Vec<(f64, f64)> = groups.iter().map(|g| (g.0 / g.2, g.1 / g.2)).collect();
    means.windows(2).map(|w| (w[1].1 - w[0].1) / (w[1].0 - w[0].0)).reduce(f64::min).unwrap_or(f64::NAN)
}

#[cfg(test)]
mod tests {
    use super::super::{Nominal, PrototypeTest, TestCycle};
    use super::acceptance;
    use crate::check::Status;
    use crate::codes::Code;

    #[test]
    fn losses_and_deviations_at_the_limits_of_asce_7() {
        let code = Code::named("asce7-16").expect("a code");
        let cycle = |k_eff: f64, edc: f64, amplitude: f64| TestCycle { k_eff, edc, amplitude, ..TestCycle::default() };
        let nominal = Nominal { amplitude: 0.3, k_eff: 1.0, q_d: 0.1, k_d: 0.7 };
        let test = |cycles| PrototypeTest { name: "t".into(), cycles };
        let good = test(vec![cycle(1.1, 1.0, 0.3), cycle(1.0, 0.9, 0.3), cycle(0.95, 0.85, 0.3)]);
        let small = test(vec![cycle(1.5, 0.3, 0.1)]);
        let checks = acceptance(&[good.clone(), small], &nominal, &code);
        assert!(checks.iter().all(|c| c.status == Status::Met), "{checks:?}");
        // (0.3 · 1.0167 - 0.15)/0.2.
        let slope = checks.last().expect("a check").demand;
        assert!((slope - (0.3 * 3.05 / 3.0 - 0.15) / 0.2).abs() < 1e-12);
        let bad = test(vec![cycle(1.4, 1.0, 0.3), cycle(1.0, 0.7, 0.3)]);
        let checks = acceptance(&[bad], &nominal, &code);
        let failed: Vec<&str> =
            checks.iter().filter(|c| c.status == Status::NotMet).map(|c| c.subject.as_str()).collect();
        assert_eq!(failed.len(), 4, "{failed:?}");
        assert_eq!(checks.last().map(|c| c.status), Some(Status::NotChecked));
    }
}
