//! Acceptance of prototype tests by the rules of a code.

use super::trends::is_same;
use super::{Factors, Nominal, PrototypeTest, TestCycle};
use crate::check::{Check, Citation, Status};
use crate::codes::Code;

/// What the design says about the tests.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TestDesign {
    /// Largest permitted deviation of the mean of all isolators from nominal, as a share; 0 if there is none.
    pub specification: f64,
    /// Least and largest λ_test of the design; none if they are not stated.
    pub factors: Option<[Factors; 2]>,
    /// Elastic stiffness over K_d.
    pub ratio: f64,
}

/// Checks of each test, and of the set.
pub fn acceptance(tests: &[PrototypeTest], nominal: &Nominal, design: &TestDesign, code: &Code) -> Vec<Check> {
    let mut out = vec![];
    for test in tests {
        by_stiffness(test, nominal, code, &mut out);
        if code.reading("test_nominal").is_some() && is_same(test.amplitude(), nominal.amplitude) {
            by_loops(test, nominal, design, code, &mut out);
        }
    }
    durability(tests, nominal, code, &mut out);
    let subject = "force over displacement: least slope between amplitudes";
    out.push(Check::least_of(code, "test_increment", subject, increment(tests)));
    if let Some(rule) = code.rule.get("test_sequence") {
        for [share, cycles] in &rule.table {
            let amplitude = share * nominal.amplitude;
            let count = |t: &PrototypeTest| t.cycles.iter().filter(|c| is_same(c.amplitude, amplitude)).count();
            let found = tests.iter().map(count).max().unwrap_or(0) as f64;
            let subject = format!("cycles of one test at {share} of the design displacement");
            out.push(Check::at_least(subject, Citation::of(code, "test_sequence"), found, *cycles));
        }
    }
    out.retain(|c| !c.citation.clause.is_empty());
    out
}

/// A comparison with nominal values. Of those that are the means of one test alone it proves nothing.
fn against(mut check: Check, nominal: &Nominal) -> Check {
    if nominal.tests == 1 {
        check.subject += ", which is the mean of this test";
        check.status = Status::NotChecked;
    }
    check
}

/// Cycles of the largest amplitude of a test.
fn of_amplitude(test: &PrototypeTest) -> Vec<&TestCycle> {
    let amplitude = test.amplitude();
    test.cycles.iter().filter(|c| is_same(c.amplitude, amplitude)).collect()
}

/// Rules on the effective stiffness and the energy of each test. A code without one of them has no check of it.
fn by_stiffness(test: &PrototypeTest, nominal: &Nominal, code: &Code, out: &mut Vec<Check>) {
    // Ratios within a test are those of cycles of one amplitude.
    let same = of_amplitude(test);
    let mean = same.iter().map(|c| c.k_eff).sum::<f64>() / same.len() as f64;
    let largest = |of: &dyn Fn(&TestCycle) -> f64| same.iter().map(|c| of(c)).fold(f64::MIN, f64::max);
    let least = |of: &dyn Fn(&TestCycle) -> f64| same.iter().map(|c| of(c)).fold(f64::MAX, f64::min);
    let name = &test.name;
    if is_same(test.amplitude(), nominal.amplitude) {
        let subject = format!("{name}: mean K_eff against nominal");
        let check = Check::most_of(code, "test_stiffness_nominal", subject, (mean / nominal.k_eff - 1.0).abs());
        out.push(against(check, nominal));
    }
    let rule = |rule: &str, what: &str, value: f64| Check::most_of(code, rule, format!("{name}: {what}"), value);
    let deviation = largest(&|c| (c.k_eff / mean - 1.0).abs());
    out.push(rule("test_stiffness_cycle", "K_eff of a cycle against the mean of the test", deviation));
    let loss = |of: &dyn Fn(&TestCycle) -> f64| 1.0 - least(of) / largest(of);
    out.push(rule("test_stiffness_loss", "loss of K_eff over the cycles", loss(&|c| c.k_eff)));
    out.push(rule("test_energy_loss", "loss of EDC over the cycles", loss(&|c| c.edc)));
}

/// Rules on k_d and E_loop of a test at the design displacement.
fn by_loops(test: &PrototypeTest, nominal: &Nominal, design: &TestDesign, code: &Code, out: &mut Vec<Check>) {
    let cycles = of_amplitude(test);
    let yields = nominal.q_d / ((design.ratio - 1.0) * nominal.k_d);
    let energy = 4.0 * nominal.q_d * (nominal.amplitude - yields);
    let three: Vec<&TestCycle> = cycles.iter().take(3).copied().collect();
    let mean = |of: fn(&TestCycle) -> f64| three.iter().map(|c| of(c)).sum::<f64>() / three.len() as f64;
    let value = |name: &str| code.value("test_nominal", name).unwrap_or(f64::NAN);
    let range = if design.specification > 0.0 { design.specification + value("more") } else { value("range") };
    let cite = || Citation::of(code, "test_nominal");
    for (what, found) in [("k_d", mean(|c| c.k_d) / nominal.k_d), ("E_loop", mean(|c| c.edc) / energy)] {
        let subject = format!("{}: mean {what} of three cycles against nominal", test.name);
        out.push(against(Check::at_most(subject, cite(), (found - 1.0).abs(), range), nominal));
    }
    let of = |k: usize, part: fn(&Factors) -> f64| design.factors.as_ref().map_or(f64::NAN, |f| part(&f[k]));
    let ranges: [(&str, &str, [f64; 2], Vec<f64>); 2] = [
        (
            "test_stiffness_range",
            "k_d",
            [of(0, |f| f.k_d), of(1, |f| f.k_d)],
            cycles.iter().map(|c| c.k_d / nominal.k_d).collect(),
        ),
        (
            "test_energy_range",
            "E_loop",
            [of(0, |f| f.q_d), of(1, |f| f.q_d)],
            cycles.iter().map(|c| c.edc / energy).collect(),
        ),
    ];
    for (rule, what, [low, high], found) in ranges {
        let subject = |which: &str| {
            format!("{}: {which} {what} of a cycle over nominal, compared with λ_test of the design", test.name)
        };
        let least = found.iter().copied().fold(f64::MAX, f64::min);
        let most = found.iter().copied().fold(f64::MIN, f64::max);
        out.push(Check::at_least(subject("least"), Citation::of(code, rule), least, low));
        out.push(Check::at_most(subject("largest"), Citation::of(code, rule), most, high));
    }
}

/// Changes over the cycles of the durability test: that with the most cycles at its share of the design displacement.
fn durability(tests: &[PrototypeTest], nominal: &Nominal, code: &Code, out: &mut Vec<Check>) {
    if code.reading("test_stiffness_change").is_none() {
        return;
    }
    let share = code.value("test_sequence", "durability").unwrap_or(1.0);
    let at = |t: &&PrototypeTest| t.cycles.iter().filter(|c| is_same(c.amplitude, share * nominal.amplitude)).count();
    let asked = code.rule.get("test_sequence").and_then(|r| r.table.iter().find(|row| row[0] == share));
    let asked = asked.map_or(1.0, |row| row[1]);
    let test = tests.iter().max_by_key(at).filter(|t| at(t) as f64 >= asked);
    let cycles: Vec<&TestCycle> = test.iter().flat_map(|t| of_amplitude(t)).collect();
    let first = cycles.first();
    let change = |of: &dyn Fn(&TestCycle) -> f64| cycles.iter().map(|c| of(c)).fold(f64::NAN, f64::max);
    let k = first.map_or(f64::NAN, |f| change(&|c| (c.k_eff / f.k_eff - 1.0).abs()));
    let b = first.map_or(f64::NAN, |f| change(&|c| 1.0 - c.beta / f.beta));
    let name = test.map_or("durability test, which is missing", |t| &t.name);
    out.push(Check::most_of(code, "test_stiffness_change", format!("{name}: change of the first K_eff"), k));
    out.push(Check::most_of(code, "test_damping_loss", format!("{name}: loss of the first effective damping"), b));
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
    use super::super::{Factors, Nominal, PrototypeTest, TestCycle};
    use super::{TestDesign, acceptance};
    use crate::check::{Check, Status};
    use crate::codes::Code;

    const NOMINAL: Nominal = Nominal { amplitude: 0.3, k_eff: 1.0, q_d: 0.09, k_d: 0.7, tests: 0 };
    const DESIGN: TestDesign = TestDesign { specification: 0.1, factors: None, ratio: 10.0 };

    fn test(cycles: Vec<TestCycle>) -> PrototypeTest {
        PrototypeTest { name: "t".into(), cycles }
    }

    fn failed(checks: &[Check]) -> Vec<&str> {
        checks.iter().filter(|c| c.status == Status::NotMet).map(|c| c.subject.as_str()).collect()
    }

    #[test]
    fn losses_and_deviations_at_the_limits_of_aashto() {
        let code = Code::named("aashto").expect("a code");
        let cycle = |k_eff: f64, edc: f64, amplitude: f64| TestCycle { k_eff, edc, amplitude, ..TestCycle::default() };
        let good = test(vec![cycle(1.05, 1.0, 0.3), cycle(1.0, 0.9, 0.3), cycle(0.95, 0.85, 0.3)]);
        let small = test(vec![cycle(1.5, 0.3, 0.1)]);
        let checks = acceptance(&[good, small], &NOMINAL, &DESIGN, &code);
        assert!(failed(&checks).iter().all(|s| s.starts_with("cycles of one test")), "{checks:?}");
        // (0.3 - 0.15)/0.2.
        let slope = checks.iter().find(|c| c.subject.starts_with("force over")).expect("a check").demand;
        assert!((slope - (0.3 - 0.15) / 0.2).abs() < 1e-12);
        let bad = test(vec![cycle(1.4, 1.0, 0.3), cycle(1.0, 0.65, 0.3)]);
        let checks = acceptance(&[bad], &NOMINAL, &DESIGN, &code);
        assert_eq!(failed(&checks).iter().filter(|s| s.starts_with("t:")).count(), 4, "{checks:?}");
    }

    #[test]
    fn stiffness_energy_and_damping_at_the_limits_of_asce_7() {
        let code = Code::named("asce7-16").expect("a code");
        // E_loop = 4 Q_d (D - D_y) with D_y = Q_d/(9 K_d).
        let energy = 4.0 * 0.09 * (0.3 - 0.09 / 6.3);
        let cycle = |k: f64, e: f64, amplitude: f64, beta: f64| TestCycle {
            k_d: 0.7 * k,
            edc: e * energy,
            k_eff: k,
            beta,
            amplitude,
            ..TestCycle::default()
        };
        let design = |low: f64, high: f64| {
            let of = |x: f64| Factors { q_d: x, k_d: x };
            TestDesign { factors: Some([of(low), of(high)]), ..DESIGN }
        };
        let at = |amplitude: f64, n: usize| test(vec![cycle(1.0, 1.0, amplitude, 0.2); n]);
        let sequence =
            |last: PrototypeTest, durable: PrototypeTest| [at(0.075, 3), at(0.15, 3), at(0.201, 3), durable, last];
        let three = test(vec![cycle(1.1, 1.2, 0.3, 0.2), cycle(1.0, 1.1, 0.3, 0.2), cycle(0.96, 1.0, 0.3, 0.2)]);
        let checks = acceptance(&sequence(three.clone(), at(0.225, 10)), &NOMINAL, &design(0.95, 1.25), &code);
        assert!(checks.iter().all(|c| c.status == Status::Met), "{checks:?}");
        // Limits of λ_test that are narrower than the cycles; without them these rules are open.
        let checks = acceptance(&sequence(three.clone(), at(0.225, 10)), &NOMINAL, &design(0.97, 1.15), &code);
        assert_eq!(failed(&checks).len(), 2, "{checks:?}");
        let checks = acceptance(&sequence(three, at(0.225, 9)), &NOMINAL, &DESIGN, &code);
        let open = checks.iter().filter(|c| c.status == Status::NotChecked).count();
        assert_eq!((failed(&checks).len(), open), (1, 6), "{checks:?}");
        // The mean of three cycles is 16 % and 17 % off: 10 % of the specification and 5 % more are permitted.
        let far = test(vec![cycle(1.16, 0.83, 0.3, 0.2); 3]);
        let mut durable = at(0.225, 10);
        durable.cycles[9] = cycle(0.78, 1.0, 0.225, 0.15);
        let checks = acceptance(&sequence(far, durable), &NOMINAL, &DESIGN, &code);
        assert_eq!(failed(&checks).len(), 4, "{checks:?}");
    }

    /// The mean of one test is no reference for that test; a value of the design, or the mean of two tests, is.
    #[test]
    fn nominal_values_of_one_test_do_not_check_it() {
        let cycle = TestCycle { amplitude: 0.3, k_eff: 1.0, q_d: 0.09, k_d: 0.7, edc: 0.1, ..TestCycle::default() };
        let code = Code::named("asce7-16").expect("a code");
        let statuses = |tests: usize| -> Vec<Status> {
            let checks = acceptance(&[test(vec![cycle; 3])], &Nominal { tests, ..NOMINAL }, &DESIGN, &code);
            checks.iter().filter(|c| c.subject.contains("against nominal")).map(|c| c.status).collect()
        };
        assert!(statuses(1).iter().all(|s| *s == Status::NotChecked) && !statuses(1).is_empty());
        assert!([0, 2].iter().all(|n| statuses(*n).iter().all(|s| *s != Status::NotChecked)));
    }
}
