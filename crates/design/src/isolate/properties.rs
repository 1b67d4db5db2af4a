//! Properties of bearings as they scatter: from prototype tests, or from the posterior of a calibration.

use crate::prototype::Posterior;
use exmex::Express as _;
use rand::RngExt as _;
use rand_pcg::Pcg32;
use serde::Deserialize;
use std::collections::BTreeMap;

/// Q_d and K_d of a type of bearing, of which draws are made.
#[derive(Clone, Debug, PartialEq)]
pub enum Properties {
    /// Lognormal factors on the nominal values.
    Factors(Posterior),
    /// Values of equal probability, in the units of the study.
    Values(Vec<[f64; 2]>),
}

/// Median of drawn values over nominal ones that is no scatter: the units or the bearing are others.
const LARGEST_RATIO: f64 = 3.0;

/// The parts of `calibration.json` that are needed.
#[derive(Deserialize)]
struct Calibration {
    parameters: BTreeMap<String, f64>,
    posterior: Option<Sample>,
}

#[derive(Deserialize)]
struct Sample {
    quantiles: Vec<Named>,
    #[serde(default)]
    draws: Vec<Vec<f64>>,
}

#[derive(Deserialize)]
struct Named {
    name: String,
}

impl Properties {
    /// Read `posterior.json` of prototype tests or `calibration.json` of a calibration. The latter needs `formulas` of Q_d
    /// and K_d in its parameters, or has parameters of these names.
    ///
    /// # Errors
    /// The text is neither, has no draws, or a formula has no meaning. The message says what to do.
    pub fn parse(text: &str, formulas: &BTreeMap<String, String>) -> Result<Self, String> {
        let json: serde_json::Value = serde_json::from_str(text).map_err(|e| e.to_string())?;
        if json.get("parameters").is_none() {
            if !formulas.is_empty() {
                return Err("formulas belong to a calibration.json, and this is a posterior.json".into());
            }
            let posterior: Posterior = serde_json::from_value(json).map_err(|e| {
                format!("{e}: expected posterior.json of hysteron prototype, or calibration.json of hysteron calibrate")
            })?;
            posterior.check()?;
            return Ok(Self::Factors(posterior));
        }
        let calibration: Calibration = serde_json::from_value(json).map_err(|e| e.to_string())?;
        calibration.values(formulas).map(Self::Values)
    }

    /// Check them beside nominal Q_d and K_d.
    ///
    /// # Errors
    /// The medians are other values than scatter explains. The message has both and their ratio.
    pub fn check(&self, nominal: [f64; 2]) -> Result<(), String> {
        for (of, name) in ["Q_d", "K_d"].into_iter().enumerate() {
            let (median, share) = match self {
                Self::Factors(p) => (p.median[of] * nominal[of], p.median[of]),
                Self::Values(all) => {
                    let mut sorted: Vec<f64> = all.iter().map(|v| v[of]).collect();
                    sorted.sort_by(f64::total_cmp);
                    let median = sorted[sorted.len() / 2];
                    (median, if nominal[of] == 0.0 { 1.0 } else { median / nominal[of] })
                }
            };
            if !(1.0 / LARGEST_RATIO..=LARGEST_RATIO).contains(&share) {
                let nominal = nominal[of];
                return Err(format!(
                    "the median of {name} is {median:.4}, that of the study {nominal:.4}, a ratio of {share:.3}: \
                     expected the same bearing in the same units"
                ));
            }
        }
        Ok(())
    }

    /// Factors on nominal Q_d and K_d of one draw.
    pub fn draw(&self, nominal: [f64; 2], random: &mut Pcg32) -> [f64; 2] {
        match self {
            Self::Factors(p) => p.draw(random),
            Self::Values(all) => {
                let values = all[random.random_range(0..all.len())];
                [0, 1].map(|of| if nominal[of] == 0.0 { 1.0 } else { values[of] / nominal[of] })
            }
        }
    }
}

impl Calibration {
    /// Q_d and K_d of each draw.
    fn values(&self, formulas: &BTreeMap<String, String>) -> Result<Vec<[f64; 2]>, String> {
        let sample = self.posterior.as_ref().filter(|s| !s.draws.is_empty());
        let sample = sample.ok_or("the calibration has no posterior: run hysteron calibrate with --posterior")?;
        if let Some(unknown) = formulas.keys().find(|k| !matches!(k.as_str(), "q_d" | "k_d")) {
            return Err(format!("\"{unknown}\" is no property: expected q_d and k_d"));
        }
        let names: Vec<&str> = sample.quantiles.iter().map(|q| q.name.as_str()).collect();
        let mut columns = vec![];
        for property in ["q_d", "k_d"] {
            let text = formulas.get(property).map_or(property, String::as_str);
            columns.push(self.column(property, text, &names, &sample.draws)?);
        }
        let [q_d, k_d] = &columns[..] else { return Err("there are no properties".into()) };
        Ok(q_d.iter().zip(k_d).map(|(q, k)| [*q, *k]).collect())
    }

    /// A formula of the parameters at each draw.
    fn column(&self, property: &str, text: &str, names: &[&str], draws: &[Vec<f64>]) -> Result<Vec<f64>, String> {
        let formula = exmex::parse::<f64>(text).map_err(|e| format!("{property} = {text} is no formula: {e}"))?;
        let places: Result<Vec<Result<usize, f64>>, String> = formula
            .var_names()
            .iter()
            .map(|name| match (names.iter().position(|n| n == name), self.parameters.get(name)) {
                (Some(at), _) => Ok(Ok(at)),
                // A parameter that was not sought has one value, and a tied one another at each draw.
                (None, Some(value)) => Ok(Err(*value)),
                (None, None) => Err(format!(
                    "{property} = {text}: the calibration has no parameter {name}; it has {}. Say {property} by a \
                     formula of these",
                    names.join(", ")
                )),
            })
            .collect();
        let places = places?;
        let one = |draw: &Vec<f64>| -> Result<f64, String> {
            let value =
                |place: &Result<usize, f64>| place.as_ref().map_or_else(|v| Some(*v), |at| draw.get(*at).copied());
            let words: Option<Vec<f64>> = places.iter().map(value).collect();
            let words = words.ok_or("a draw has another number of parameters")?;
            let x = formula.eval(&words).map_err(|e| format!("{property} = {text}: {e}"))?;
            let is_good = x.is_finite() && (x > 0.0 || property == "k_d" && x == 0.0);
            if is_good { Ok(x) } else { Err(format!("{property} = {text} is {x} at a draw: expected more than 0")) }
        };
        draws.iter().map(one).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::Properties;
    use rand::SeedableRng as _;
    use rand_pcg::Pcg32;
    use std::collections::BTreeMap;

    const CALIBRATION: &str = r#"{"parameters": {"Fy": 120.0, "k": 5000.0, "b": 0.1}, "posterior": {"walkers": 8,
        "quantiles": [{"name": "Fy", "lower": 90}, {"name": "k", "lower": 1}], "draws": [[100.0, 5000.0], [140.0, 7000.0]]}}"#;

    fn formulas(of: &[(&str, &str)]) -> BTreeMap<String, String> {
        of.iter().map(|(a, b)| ((*a).to_owned(), (*b).to_owned())).collect()
    }

    #[test]
    fn draws_of_a_calibration_become_properties() {
        let both = formulas(&[("q_d", "Fy*(1-b)"), ("k_d", "b*k")]);
        let p = Properties::parse(CALIBRATION, &both).expect("properties");
        assert_eq!(p, Properties::Values(vec![[90.0, 500.0], [126.0, 700.0]]));
        assert!(p.check([100.0, 600.0]).is_ok());
        assert!(p.check([0.1, 600.0]).is_err_and(|e| e.contains("a ratio of 1260")), "{:?}", p.check([0.1, 600.0]));
        let mut random = Pcg32::seed_from_u64(1);
        let draws: Vec<[f64; 2]> = (0..400).map(|_| p.draw([100.0, 500.0], &mut random)).collect();
        // Q_d and K_d of one draw stay together.
        assert!(draws.iter().all(|d| *d == [0.9, 1.0] || *d == [1.26, 1.4]));
        let share = draws.iter().filter(|d| d[0] == 0.9).count();
        assert!((150..250).contains(&share), "{share}");
    }

    #[test]
    fn what_is_missing_is_said() {
        let of = |text: &str, words: &[(&str, &str)]| Properties::parse(text, &formulas(words)).expect_err("a fault");
        assert!(of(CALIBRATION, &[]).contains("no parameter q_d; it has Fy, k"));
        assert!(of(CALIBRATION, &[("q_d", "Fy*(")]).contains("no formula"));
        assert!(of(CALIBRATION, &[("q_d", "Fy-200"), ("k_d", "k")]).contains("is -100 at a draw"));
        assert!(of(CALIBRATION, &[("q", "Fy")]).contains("no property"));
        assert!(of(r#"{"parameters": {}}"#, &[]).contains("--posterior"));
        assert!(of("{}", &[]).contains("expected posterior.json"));
    }
}
