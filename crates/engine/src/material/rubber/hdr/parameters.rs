//! Parameters of the rheology model and their dependence on temperature.

use crate::numeric::Dual;
use std::fmt;

/// Parameters of the rheology model at one temperature; stresses in any unit, strain rates in 1/time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters {
    /// Stiffness C₁⁽ᴱᑫ⁾ of the spring in series with the slider (Eq 3.5).
    pub c1_eq: f64,
    /// Stiffness C₂⁽ᴱᑫ⁾ of the nonlinear spring (Eq 3.7).
    pub c2_eq: f64,
    /// Coefficient C₃⁽ᴱᑫ⁾ of the spring's power term (Eq 3.7).
    pub c3_eq: f64,
    /// Sliding stress τcr⁽ᴱᑫ⁾ of the slider (Eq 3.6).
    pub tau_cr_eq: f64,
    /// Exponent m of the power term (Eq 3.7).
    pub m: f64,
    /// Stiffness C₁⁽ᴼᴱ⁾ of the overstress spring in series with its slider (Eq 3.10).
    pub c1_oe: f64,
    /// Stiffness C₂⁽ᴼᴱ⁾ of the overstress spring in parallel with them (Eq 3.12).
    pub c2_oe: f64,
    /// Sliding stress τcr⁽ᴼᴱ⁾ of the overstress slider (Eq 3.11).
    pub tau_cr_oe: f64,
    /// Stress a of the dashpot at a strain rate of one (Eq 3.13).
    pub a: f64,
    /// Exponent n of the dashpot's rate (Eq 3.13).
    pub n: f64,
}

/// Names of the parameters in the command, with the lower bound of each; true if the bound itself is valid.
pub const NAMES: [(&str, f64, bool); 10] = [
    ("C1eq", 0.0, true),
    ("C2eq", 0.0, true),
    ("C3eq", 0.0, true),
    ("tauCrEq", 0.0, true),
    ("m", 1.0, true),
    ("C1oe", 0.0, true),
    ("C2oe", 0.0, true),
    ("tauCrOe", 0.0, true),
    ("a", 0.0, false),
    ("n", 0.0, false),
];

impl Parameters {
    /// From numbers in the order of [`NAMES`].
    ///
    /// # Errors
    /// Index of the first number outside its range, and the expected range.
    pub fn new(p: [f64; 10]) -> Result<Self, (usize, String)> {
        for (i, (&x, (name, lower, inclusive))) in p.iter().zip(NAMES).enumerate() {
            if !(x > lower || inclusive && x == lower) || !x.is_finite() {
                let range = if inclusive { "not less than" } else { "greater than" };
                return Err((i, format!("expected {name}, a number {range} {lower}")));
            }
        }
        let [c1_eq, c2_eq, c3_eq, tau_cr_eq, m, c1_oe, c2_oe, tau_cr_oe, a, n] = p;
        if n > 1.0 {
            return Err((9, "expected n, greater than 0 and at most 1".into()));
        }
        Ok(Self { c1_eq, c2_eq, c3_eq, tau_cr_eq, m, c1_oe, c2_oe, tau_cr_oe, a, n })
    }

    /// The numbers in the order of [`NAMES`].
    pub fn numbers(&self) -> [f64; 10] {
        let Self { c1_eq, c2_eq, c3_eq, tau_cr_eq, m, c1_oe, c2_oe, tau_cr_oe, a, n } = *self;
        [c1_eq, c2_eq, c3_eq, tau_cr_eq, m, c1_oe, c2_oe, tau_cr_oe, a, n]
    }

    /// Tangent of the virgin material at infinite rate: the sum of all springs.
    pub fn initial_tangent(&self) -> f64 {
        let power = if self.m == 1.0 { self.c3_eq } else { 0.0 };
        let spring = |c: f64, slider: f64| if slider > 0.0 { c } else { 0.0 };
        spring(self.c1_eq, self.tau_cr_eq) + self.c2_eq + power + spring(self.c1_oe, self.tau_cr_oe) + self.c2_oe
    }
}

/// Parameters of a rubber compound as piecewise linear functions of the temperature.
#[derive(Clone, Debug, PartialEq)]
pub struct Compound {
    /// Increasing temperatures with their parameters; at least one row.
    rows: Vec<(f64, Parameters)>,
}

/// Error for a temperature outside the table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OutOfRange {
    /// The temperature.
    pub temperature: f64,
    /// Lowest and highest temperature of the table.
    pub range: (f64, f64),
}

impl fmt::Display for OutOfRange {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { temperature, range: (lo, hi) } = self;
        write!(f, "the temperature is {temperature}: the compound is known from {lo} to {hi} only")
    }
}

/// Built-in tables: name of the compound and text of its file in `models/compounds/`.
const BUILT_IN: [(&str, &str); 2] = [
    ("HDR2", include_str!("../../../../../../models/compounds/HDR2.txt")),
    ("HDR3", include_str!("../../../../../../models/compounds/HDR3.txt")),
];

impl Compound {
    /// Names of the built-in compounds.
    pub fn names() -> impl Iterator<Item = &'static str> {
        BUILT_IN.iter().map(|(name, _)| *name)
    }

    /// Text of the table of a built-in compound.
    pub fn built_in(name: &str) -> Option<&'static str> {
        BUILT_IN.iter().find(|(n, _)| *n == name).map(|(_, text)| *text)
    }

    /// Reads a table with one row per temperature: the temperature, then the parameters in the order of [`NAMES`]. A
    /// line that begins with `#` is a comment.
    ///
    /// # Errors
    /// A description of the first invalid line, with its number.
    pub fn parse(text: &str) -> Result<Self, String> {
        let mut rows: Vec<(f64, Parameters)> = vec![];
        for (i, line) in text.lines().enumerate().filter(|(_, l)| !l.trim().is_empty() && !l.starts_with('#')) {
            let wrong = |what: String| format!("line {}: {what}", i + 1);
            let numbers: Result<Vec<f64>, _> = line.split_whitespace().map(str::parse).collect();
            let numbers = numbers.map_err(|e| wrong(e.to_string()))?;
            let (Some(&temperature), Some(Ok(p))) = (numbers.first(), numbers.get(1..).map(<[f64; 10]>::try_from))
            else {
                return Err(wrong(format!("{} numbers, expected a temperature and 10 parameters", numbers.len())));
            };
            if !temperature.is_finite() || rows.last().is_some_and(|(last, _)| *last >= temperature) {
                return Err(wrong(format!("the temperature {temperature} is not above that of the row before")));
            }
            let p =
                Parameters::new(p).map_err(|(k, expected)| wrong(format!("{} is {}: {expected}", NAMES[k].0, p[k])))?;
            rows.push((temperature, p));
        }
        if rows.is_empty() { Err("there is no row of parameters".into()) } else { Ok(Self { rows }) }
    }

    /// A compound with the same parameters at every temperature.
    pub fn constant(p: Parameters) -> Self {
        Self { rows: vec![(0.0, p)] }
    }

    /// The compound with every row changed by a function.
    #[must_use]
    pub fn map(&self, change: impl Fn(&Parameters) -> Parameters) -> Self {
        Self { rows: self.rows.iter().map(|(t, p)| (*t, change(p))).collect() }
    }

    /// Lowest and highest temperature of the table.
    pub fn range(&self) -> (f64, f64) {
        match (self.rows.first(), self.rows.last()) {
            (Some(first), Some(last)) if self.rows.len() > 1 => (first.0, last.0),
            _ => (f64::NEG_INFINITY, f64::INFINITY),
        }
    }

    /// Parameters at a temperature inside the table.
    ///
    /// # Errors
    /// The temperature is outside the table; nothing is extrapolated.
    pub fn at(&self, temperature: f64) -> Result<Parameters, OutOfRange> {
        let range = self.range();
        if !(range.0..=range.1).contains(&temperature) {
            return Err(OutOfRange { temperature, range });
        }
        let p = self.held(Dual::constant(temperature)).map(|x| x.value);
        let [c1_eq, c2_eq, c3_eq, tau_cr_eq, m, c1_oe, c2_oe, tau_cr_oe, a, n] = p;
        Ok(Parameters { c1_eq, c2_eq, c3_eq, tau_cr_eq, m, c1_oe, c2_oe, tau_cr_oe, a, n })
    }

    /// Parameters at a temperature, in the order of [`NAMES`]; constant beyond the ends of the table.
    pub(super) fn held(&self, temperature: Dual) -> [Dual; 10] {
        let above = self.rows.partition_point(|(t, _)| *t <= temperature.value);
        let end = |i: usize| self.rows[i].1.numbers().map(Dual::constant);
        if above == 0 {
            return end(0);
        }
        let Some((t1, right)) = self.rows.get(above) else { return end(above - 1) };
        let (t0, left) = &self.rows[above - 1];
        let share = (1.0 / (t1 - t0)) * (temperature - Dual::constant(*t0));
        let (left, right) = (left.numbers(), right.numbers());
        std::array::from_fn(|i| Dual::constant(left[i]) + (right[i] - left[i]) * share)
    }
}
