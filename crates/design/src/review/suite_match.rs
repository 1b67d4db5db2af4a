//! A suite of motions beside its target.

use crate::isolate::Study;
use crate::lateral_force::LateralForce;
use crate::mistake::{Mistake, key};
use crate::motion::G;
use crate::spectrum::{Combination, PairSpectrum, logarithmic};

/// Spectra of the suite as it is run, in g, for 5 % damping.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SuiteMatch {
    /// Name of the combination of the components.
    pub combination: String,
    /// Range of periods of the code in s; none if it has none, or the procedure gives nothing.
    pub range: Option<[f64; 2]>,
    /// Least ratio of the mean to the target that the code asks for; NaN if it has none.
    pub least: f64,
    /// Periods in s.
    pub periods: Vec<f64>,
    /// Target.
    pub target: Vec<f64>,
    /// Spectrum of each pair.
    pub pairs: Vec<Vec<f64>>,
    /// Mean of the pairs.
    pub mean: Vec<f64>,
    /// Least ratio of the mean to the target in the range, with its period.
    pub lowest: Option<(f64, f64)>,
}

/// Mean of the suite over the target beyond which one of them is in another unit.
const OTHER_UNIT: f64 = 20.0;

impl SuiteMatch {
    /// The suite is of the order of its target.
    ///
    /// # Errors
    /// Its mean is another. The message has both and the ratio.
    pub fn agree(&self, study: &Study) -> Result<(), Mistake> {
        let mean_of_logs = |values: &[f64]| (values.iter().map(|x| x.ln()).sum::<f64>() / values.len() as f64).exp();
        let [mean, target] = [mean_of_logs(&self.mean), mean_of_logs(&self.target)];
        let ratio = mean / target;
        if ratio.is_finite() && !(1.0 / OTHER_UNIT..=OTHER_UNIT).contains(&ratio) {
            let message = format!(
                "the mean spectrum of the motions is {mean:.4e} g in the mean of its range, the target ({}) {target:.4e} g: ratio \
                 {ratio:.4e}. Look at unit and factor of the motions, and at the target",
                study.target_words
            );
            return Err(Mistake::new(key!["target"], message));
        }
        Ok(())
    }
}

/// Periods of the comparison.
const PERIODS: usize = 60;
/// Share of the range that is shown below and above it.
const BESIDE: [f64; 2] = [0.4, 1.6];

/// Compare the suite with its target over the range of the code.
pub fn suite_match(study: &Study, procedures: &[Result<LateralForce, String>]) -> SuiteMatch {
    let code = &study.code;
    let period = |k: usize| procedures.get(k).and_then(|p| p.as_ref().ok()).map(|l| l.period);
    let value = |name: &str| code.value("scaling_range", name);
    let range = match (value("from"), value("to"), period(2), period(0)) {
        (Some(from), Some(to), Some(upper), Some(lower)) => Some([from * upper, to * lower]),
        _ => None,
    };
    let name = code.word("scaling_range", "combination").unwrap_or("rotd100");
    let how = Combination::ALL.iter().find(|(n, _)| *n == name).map_or(Combination::RotD100, |(_, c)| *c);
    let [from, to] = range.or(study.scale).unwrap_or([1.0, 4.0]);
    // The ends of the range are among the periods.
    let mut periods = logarithmic(BESIDE[0] * from, BESIDE[1] * to, PERIODS);
    periods.extend([from, to]);
    periods.sort_by(f64::total_cmp);
    periods.retain(|t| study.target.at(*t).is_finite());
    let spectrum = |p: &crate::motion::Pair| -> Vec<f64> {
        // A pair with one component alone has no direction across it.
        let s = PairSpectrum::new(p, &periods, 0.05);
        let values = if p.components[1].peak() == 0.0 { s.components[0].clone() } else { s.combined(how) };
        values.iter().map(|a| a / G).collect()
    };
    let pairs: Vec<Vec<f64>> = study.motions.iter().map(spectrum).collect();
    let target: Vec<f64> = periods.iter().map(|t| study.target.at(*t) / G).collect();
    let n = pairs.len() as f64;
    let mean: Vec<f64> = (0..periods.len()).map(|i| pairs.iter().map(|p| p[i]).sum::<f64>() / n).collect();
    let inside = |t: f64| range.is_some_and(|[from, to]| (from..=to).contains(&t));
    let ratios = periods.iter().zip(mean.iter().zip(&target)).filter(|(t, _)| inside(**t));
    let lowest = ratios.map(|(t, (m, s))| (m / s, *t)).reduce(|a, b| if b.0 < a.0 { b } else { a });
    SuiteMatch {
        combination: name.into(),
        range,
        least: value("least").unwrap_or(f64::NAN),
        periods,
        target,
        pairs,
        mean,
        lowest,
    }
}
