//! Limit states and levels of intensity, as a study names them.

use crate::mistake::{About as _, Mistake, key};
use crate::motion::{G, Pair};
use crate::spectrum::{Combination, PairSpectrum};
use hysteron_tcl::diagnostic::nearest;
use serde::Deserialize;

/// Measure of the intensity of a pair.
#[derive(Clone, Debug, Deserialize, PartialEq)]
#[serde(deny_unknown_fields, default)]
pub struct Intensity {
    /// `sa`: spectral acceleration in g; `pga` in g; `pgv` in m/s; `factor`: the factor on the scaled pair.
    pub measure: String,
    /// Period of `sa` in s.
    pub period: f64,
    /// Damping of `sa` as a share of critical.
    pub damping: f64,
    /// Combination of the components: `geomean`, `rotd50`, `rotd100`, `srss` or `larger`. Peaks know `geomean`, `srss` and
    /// `larger`.
    pub combination: String,
}

impl Default for Intensity {
    fn default() -> Self {
        Self { measure: "sa".into(), period: f64::NAN, damping: 0.05, combination: "geomean".into() }
    }
}

const MEASURES: [&str; 4] = ["sa", "pga", "pgv", "factor"];

/// Error about a word that is none of some.
fn unknown(what: &str, word: &str, known: &[&str]) -> String {
    let near = nearest(word, known.iter().copied()).map_or(String::new(), |n| format!("; did you mean {n}?"));
    format!("\"{word}\" is no {what}: expected {}{near}", known.join(", "))
}

impl Intensity {
    /// Check the words and numbers.
    ///
    /// # Errors
    /// One of them has no meaning. The message names it.
    pub fn check(&self) -> Result<(), String> {
        if !MEASURES.contains(&self.measure.as_str()) {
            return Err(unknown("measure of intensity", &self.measure, &MEASURES));
        }
        if self.measure == "sa" && !(self.period > 0.0 && self.period.is_finite()) {
            return Err("[intensity]: measure = \"sa\" needs a period above 0".into());
        }
        if !(0.0..1.0).contains(&self.damping) {
            return Err(format!("[intensity]: damping = {}: expected 0 to less than 1", self.damping));
        }
        let names = Combination::ALL.map(|(n, _)| n);
        if !names.contains(&self.combination.as_str()) {
            return Err(unknown("combination", &self.combination, &names));
        }
        if self.measure != "sa" && self.combination.starts_with("rotd") {
            return Err(format!("[intensity]: {} has no combination {}", self.measure, self.combination));
        }
        Ok(())
    }

    /// Name with its unit, for axes.
    pub fn label(&self) -> String {
        match self.measure.as_str() {
            "sa" => format!("Sa({} s, {} %) [g]", self.period, 100.0 * self.damping),
            "pga" => "PGA [g]".into(),
            "pgv" => "PGV [m/s]".into(),
            _ => "Factor".into(),
        }
    }

    /// Intensity of a pair. A second component at rest leaves the first one alone.
    pub fn of(&self, pair: &Pair) -> f64 {
        let peaks: [f64; 2] = match self.measure.as_str() {
            "factor" => return 1.0,
            "pgv" => [0, 1].map(|k| pair.components[k].integrated().0.iter().fold(0.0, |m, v| v.abs().max(m))),
            "pga" => [0, 1].map(|k| pair.components[k].peak() / G),
            _ => {
                let spectrum = PairSpectrum::new(pair, &[self.period], self.damping);
                let how = Combination::ALL.iter().find(|(n, _)| *n == self.combination).map(|(_, c)| *c);
                let rests = pair.components[1].peak() == 0.0;
                match how {
                    Some(how) if !rests => return spectrum.combined(how)[0] / G,
                    // The direction across the first component gives round-off where the second one rests.
                    _ => [spectrum.components[0][0] / G, 0.0],
                }
            }
        };
        match self.combination.as_str() {
            _ if peaks[1] == 0.0 => peaks[0],
            "srss" => peaks[0].hypot(peaks[1]),
            "larger" => peaks[0].max(peaks[1]),
            _ => (peaks[0] * peaks[1]).sqrt(),
        }
    }
}

/// Quantities of limit states with their meaning and the kind of their unit.
pub const QUANTITIES: [(&str, &str); 9] = [
    ("displacement", "length"),
    ("residual", "length"),
    ("uplift", "length"),
    ("tension", "force"),
    ("stability", ""),
    ("drift", ""),
    ("acceleration", "g"),
    ("base_displacement", "length"),
    ("contact", "force"),
];

/// A limit state: a quantity that reaches a limit, or `collapse`.
#[derive(Clone, Debug, Deserialize, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct LimitState {
    /// Name.
    pub name: String,
    /// `displacement` (vector sum), `residual`, `uplift`, `tension` and `stability` (P/P_cr) of bearings; `drift` and
    /// `acceleration` (g) of floors; `base_displacement` of the lowest floor in either direction, against the gap of a
    /// moat wall; `contact`, the largest force of the elements, pounding springs for instance; `collapse`.
    pub quantity: String,
    /// Limit that must not be passed; none for `collapse`.
    #[serde(default)]
    pub limit: f64,
    /// Types of bearings; all if empty.
    #[serde(default)]
    pub bearings: Vec<String>,
    /// Elements of `contact`.
    #[serde(default)]
    pub elements: Vec<i64>,
}

impl LimitState {
    /// Check the words and numbers.
    ///
    /// # Errors
    /// One of them has no meaning. The message names it.
    pub fn check(&self, types: &[&str]) -> Result<(), String> {
        let of = |e: String| format!("limit state \"{}\": {e}", self.name);
        let mut known = QUANTITIES.map(|(n, _)| n).to_vec();
        known.push("collapse");
        if !known.contains(&self.quantity.as_str()) {
            return Err(of(unknown("quantity", &self.quantity, &known)));
        }
        if !(self.limit >= 0.0 && self.limit.is_finite()) {
            return Err(of(format!("limit = {}: expected a number, not negative", self.limit)));
        }
        if self.limit == 0.0 && !["collapse", "contact", "tension", "uplift"].contains(&self.quantity.as_str()) {
            return Err(of("expected a limit above 0".into()));
        }
        if let Some(b) = self.bearings.iter().find(|b| !types.contains(&b.as_str())) {
            return Err(of(unknown("type of bearing", b, types)));
        }
        if (self.quantity == "contact") == self.elements.is_empty() {
            return Err(of("elements belong to the quantity contact, which needs them".into()));
        }
        Ok(())
    }
}

/// Collapse: limits beyond which an analysis counts as collapsed, with or without convergence.
#[derive(Clone, Debug, Default, Deserialize, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct Collapse {
    /// Storey drift ratio.
    pub drift: Option<f64>,
    /// Displacement of a bearing: vector sum.
    pub displacement: Option<f64>,
}

/// Analyses at levels of intensity for each record, by hunting for collapse and filling the gaps: Vamvatsikos and Cornell
/// (2002), Incremental dynamic analysis, Earthquake Engineering and Structural Dynamics 31, 491-514.
#[derive(Clone, Debug, Deserialize, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct Hunt {
    /// First level.
    pub first: f64,
    /// First step.
    pub step: f64,
    /// Growth of each further step.
    #[serde(default)]
    pub growth: f64,
    /// Highest level.
    pub highest: f64,
    /// Analyses of a record, at most.
    pub runs: usize,
    /// Gap around a capacity, as a share of its upper end, that is not divided any more.
    #[serde(default = "resolution")]
    pub resolution: f64,
}

fn resolution() -> f64 {
    0.1
}

impl Hunt {
    /// Check the numbers.
    ///
    /// # Errors
    /// One of them has no meaning.
    pub fn check(&self) -> Result<(), String> {
        let is_positive = |x: f64| x > 0.0 && x.is_finite();
        if !(is_positive(self.first) && is_positive(self.step) && is_positive(self.highest))
            || self.first > self.highest
        {
            return Err("[ida]: expected first, step and highest above 0, and first at most highest".into());
        }
        if !(self.growth >= 0.0 && self.growth.is_finite() && self.resolution > 0.0 && self.resolution < 1.0) {
            return Err("[ida]: expected growth not negative, and resolution between 0 and 1".into());
        }
        if !(2..=1000).contains(&self.runs) {
            return Err(format!("[ida]: runs = {}: expected 2 to 1000", self.runs));
        }
        Ok(())
    }
}

/// The same levels of intensity for all records.
#[derive(Clone, Debug, Deserialize, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct Stripes {
    /// Levels, rising.
    pub levels: Vec<f64>,
}

impl Stripes {
    /// Check the levels.
    ///
    /// # Errors
    /// There are none, or they do not rise from above 0.
    pub fn check(&self) -> Result<(), String> {
        let rising = self.levels.windows(2).all(|w| w[0] < w[1]);
        match self.levels.first() {
            Some(first) if *first > 0.0 && rising && self.levels.iter().all(|x| x.is_finite()) => Ok(()),
            _ => Err("[stripes]: expected rising levels above 0".into()),
        }
    }
}

/// What a study says about fragility.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Performance {
    /// Measure of intensity.
    pub intensity: Intensity,
    /// Levels by hunting.
    pub hunt: Option<Hunt>,
    /// Levels of stripes.
    pub stripes: Option<Stripes>,
    /// Collapse.
    pub collapse: Collapse,
    /// Limit states.
    pub limit_states: Vec<LimitState>,
    /// Bounds that are run.
    pub bounds: Vec<String>,
}

impl Performance {
    /// Check all of it; without limit states nothing is wanted.
    ///
    /// # Errors
    /// A part has no meaning.
    pub fn check(&self, types: &[&str], bounds: &[&str]) -> Result<(), Mistake> {
        if self.limit_states.is_empty() && self.hunt.is_none() && self.stripes.is_none() {
            return Ok(());
        }
        self.intensity.check().about(|| key!["intensity"])?;
        self.hunt.as_ref().map_or(Ok(()), Hunt::check).about(|| key!["ida"])?;
        self.stripes.as_ref().map_or(Ok(()), Stripes::check).about(|| key!["stripes", "levels"])?;
        for (name, limit) in [("drift", self.collapse.drift), ("displacement", self.collapse.displacement)] {
            if let Some(limit) = limit.filter(|l| !(*l > 0.0 && l.is_finite())) {
                let message = format!("[collapse]: a limit of {limit}: expected more than 0");
                return Err(Mistake::new(key!["collapse", name], message));
            }
        }
        for (i, l) in self.limit_states.iter().enumerate() {
            l.check(types).about(|| key!["limit_state", i])?;
            if self.limit_states[..i].iter().any(|other| other.name == l.name) {
                let message = format!("the limit state \"{}\" is listed twice", l.name);
                return Err(Mistake::new(key!["limit_state", i, "name"], message));
            }
            if l.quantity == "collapse" && self.collapse == Collapse::default() {
                let message = "the limit state collapse needs [collapse] with drift or displacement";
                return Err(Mistake::new(key!["limit_state", i, "quantity"], message));
            }
        }
        if let Some((i, b)) = self.bounds.iter().enumerate().find(|(_, b)| !bounds.contains(&b.as_str())) {
            return Err(Mistake::new(key!["fragility_bounds", i], unknown("bound", b, bounds)));
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::{Collapse, Hunt, Intensity, LimitState, Performance};
    use crate::motion::{G, Motion, Pair};

    fn pair(a: f64, b: f64) -> Pair {
        let motion = |peak: f64| {
            let acceleration = (0..1000).map(|i| peak * G * (0.01 * f64::from(i) * 3.0).sin()).collect();
            Motion { name: "m".into(), title: String::new(), azimuth: None, dt: 0.01, acceleration }
        };
        Pair::new(motion(a), motion(b)).expect("a pair")
    }

    #[test]
    fn intensities_are_proportional_and_combined() {
        let of = |measure: &str, combination: &str, p: &Pair| {
            Intensity { measure: measure.into(), period: 2.0, combination: combination.into(), ..Intensity::default() }
                .of(p)
        };
        for measure in ["sa", "pga", "pgv"] {
            let one = of(measure, "larger", &pair(0.4, 0.1));
            assert!((of(measure, "geomean", &pair(0.4, 0.1)) / one - 0.5).abs() < 1e-9, "{measure}");
            assert!((of(measure, "srss", &pair(0.4, 0.3)) / one - 1.25).abs() < 1e-9, "{measure}");
            assert!((of(measure, "geomean", &pair(0.4, 0.0)) / one - 1.0).abs() < 1e-9, "{measure}");
            assert!((of(measure, "larger", &pair(0.8, 0.1)) / one - 2.0).abs() < 1e-9, "{measure}");
        }
        assert!((of("pga", "larger", &pair(0.4, 0.1)) - 0.4).abs() < 1e-4);
    }

    #[test]
    fn wrong_words_are_named() {
        let intensity = |measure: &str| Intensity { measure: measure.into(), ..Intensity::default() }.check();
        assert!(intensity("sA").expect_err("none").contains("did you mean sa?"));
        assert!(intensity("sa").expect_err("none").contains("period"));
        let state = |quantity: &str, limit: f64| LimitState {
            name: "x".into(),
            quantity: quantity.into(),
            limit,
            bearings: vec![],
            elements: vec![],
        };
        assert!(state("displacment", 0.3).check(&[]).expect_err("none").contains("did you mean displacement?"));
        assert!(state("drift", 0.0).check(&[]).expect_err("none").contains("above 0"));
        assert!(state("contact", 0.0).check(&[]).expect_err("none").contains("elements"));
        let p = Performance {
            intensity: Intensity { period: 2.0, ..Intensity::default() },
            limit_states: vec![state("collapse", 0.0)],
            ..Performance::default()
        };
        assert!(p.check(&[], &[]).expect_err("none").message.contains("[collapse]"));
        let collapse = Collapse { drift: Some(0.1), displacement: None };
        assert!(Performance { collapse, ..p }.check(&[], &[]).is_ok());
        let hunt = Hunt { first: 1.0, step: 0.1, growth: 0.0, highest: 0.5, runs: 8, resolution: 0.1 };
        assert!(hunt.check().is_err());
    }
}
