//! Parametric bootstrap: the ranking on simulated recordings whose cause is known.
//!
//! Chance may produce a gain, or another cause may give this one an equal gain. Both depend on the motion, the channels, the
//! noise and the library of the study. Each hypothesis therefore simulates recordings, with noise of the spectrum that the best
//! one leaves (Williams 1970, J. R. Stat. Soc. B 32, 350, for hypotheses none of which contains the other). All hypotheses are
//! fitted to each of them and ranked.
//!
//! Fits are linear in their parameters near the optimum, so that only their derivatives need analyses. The ranking uses
//! residuals of the fit, on the real recording too, instead of held-out residuals. Without a block of samples, parameters
//! move further than derivatives are valid.

use super::likelihood::NoiseModel;
use crate::fit::fitted::penalised_score;
use crate::fit::job::ChannelResiduals;
use crate::fit::linearized::{LinearizedFit, damped_step};
use crate::prior::{BOOTSTRAP_RECORDINGS, MAX_LINEAR_STEP, MAX_REFUTED_SHARE};
use crate::residual::surrogates::Surrogates;
use nalgebra::{DMatrix, DVector};
use serde::Serialize;

/// A hypothesis that takes part.
pub(crate) struct Competitor {
    /// Its cause.
    pub(crate) cause: &'static str,
    /// Log odds before the fit, nats.
    pub(crate) prior_log_odds: f64,
    /// Its optimum in the unit cube.
    pub(crate) point: Vec<f64>,
    /// Number of parameters that the model depends on.
    pub(crate) parameters: usize,
    /// The linearized fit there.
    pub(crate) fit: LinearizedFit,
}

/// Result for the cause with the most evidence.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct BootstrapResult {
    /// The cause.
    pub cause: &'static str,
    /// Number of recordings that each hypothesis simulated.
    pub recordings: usize,
    /// Share of the complete model's recordings in which some cause gains as much; none if `cause` is `none`.
    pub chance: Option<f64>,
    /// Share of its own recordings in which the cause has the most evidence.
    pub found: f64,
    /// Causes in whose recordings this one often gains as much.
    pub not_told_apart: Vec<EqualGain>,
}

/// Share of a cause's recordings in which the first cause gains as much over it as in the real recording.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct EqualGain {
    /// The other cause.
    pub cause: &'static str,
    /// The share, between 0 and 1.
    pub share: f64,
}

impl BootstrapResult {
    /// Share of a cause's own recordings in which the first cause gains as much over it; none if it was not drawn often
    /// enough to count.
    pub(crate) fn equal_gain(&self, other: &str) -> Option<f64> {
        let listed = || self.not_told_apart.iter().find(|s| s.cause == other).map(|s| s.share);
        self.chance.filter(|_| other == "none").or_else(listed)
    }

    /// The result in words; empty if the cause is `none`.
    pub(crate) fn description(&self) -> String {
        let Some(chance) = self.chance else { return String::new() };
        let mut text = if chance * (self.recordings + 1) as f64 <= 1.5 {
            format!(" In none of {} recordings", self.recordings)
        } else {
            format!(" In {} of the recordings", percent(chance))
        };
        text += " that the model as it is would make with this noise any cause gains as much.";
        for s in &self.not_told_apart {
            text += &format!(
                " Were it {}, {} would gain as much in {} of the recordings: this one does not tell them apart.",
                s.cause,
                self.cause,
                percent(s.share)
            );
        }
        text
    }
}

/// A share in per cent, with one digit.
pub(crate) fn percent(share: f64) -> String {
    format!("{:.1} %", 100.0 * share)
}

/// A competitor with its normal matrix.
struct LinearCompetitor<'a> {
    competitor: &'a Competitor,
    normal: DMatrix<f64>,
}

impl<'a> LinearCompetitor<'a> {
    fn new(competitor: &'a Competitor) -> Self {
        let j = &competitor.fit.derivatives;
        Self { competitor, normal: j.tr_mul(j) }
    }

    fn dimension(&self) -> usize {
        self.competitor.parameters
    }

    /// Residual of a recording after a linear fit, from its residual at the optimum of the real recording.
    fn refitted(&self, residual: &DVector<f64>) -> Option<DVector<f64>> {
        let j = &self.competitor.fit.derivatives;
        let square = residual.norm_squared();
        let step = damped_step(self.normal.clone(), &j.tr_mul(residual), square)?;
        let within_cube = DVector::from_fn(step.len(), |i, _| {
            let p = self.competitor.point[i];
            (p + step[i].clamp(-MAX_LINEAR_STEP, MAX_LINEAR_STEP)).clamp(0.0, 1.0) - p
        });
        let after = residual + j * within_cube;
        Some(if after.norm_squared() < square { after } else { residual.clone() })
    }
}

/// Log evidence of all competitors on a recording, from their residuals at the optima of the real one.
fn log_evidences(all: &[LinearCompetitor<'_>], residuals: &[DVector<f64>]) -> Option<Vec<f64>> {
    let refitted: Vec<DVector<f64>> = all.iter().zip(residuals).map(|(p, r)| p.refitted(r)).collect::<Option<_>>()?;
    let score = |(p, r): &(&LinearCompetitor<'_>, &DVector<f64>)| {
        penalised_score(r.norm_squared().max(f64::MIN_POSITIVE), p.dimension(), 0.0)
    };
    let (best, of_best) = all.iter().zip(&refitted).min_by(|a, b| score(a).total_cmp(&score(b)))?;
    let channels = &best.competitor.fit;
    let noise = NoiseModel::of(&channels.by_channel(of_best));
    let log_evidence = |(p, r): (&LinearCompetitor<'_>, &DVector<f64>)| {
        p.competitor.prior_log_odds + noise.log_evidence(&channels.by_channel(r), p.dimension())
    };
    Some(all.iter().zip(&refitted).map(log_evidence).collect())
}

/// Competitors with their results on the real recording.
struct Bootstrap<'a> {
    all: Vec<LinearCompetitor<'a>>,
    /// Residual of each on the real recording.
    residuals: Vec<DVector<f64>>,
    log_evidence: Vec<f64>,
    /// Residual of the best one, which is the noise.
    noise: ChannelResiduals,
    /// Cause of the best one.
    cause: &'static str,
}

impl Bootstrap<'_> {
    /// Largest log evidence among selected causes.
    fn largest(&self, log_evidence: &[f64], of: impl Fn(&str) -> bool) -> f64 {
        let selected = self.all.iter().zip(log_evidence).filter(|(p, _)| of(p.competitor.cause)).map(|(_, e)| *e);
        selected.fold(f64::NEG_INFINITY, f64::max)
    }

    /// Log evidence of the best of selected causes over another cause.
    fn gain(&self, log_evidence: &[f64], of: impl Fn(&str) -> bool, over: &str) -> f64 {
        self.largest(log_evidence, of) - self.largest(log_evidence, |c| c == over)
    }

    /// Returns true if a recording simulated by `truth` counts.
    ///
    /// A recording of the first cause counts if that cause has the most evidence. A recording of another cause counts if the
    /// first gains as much over it as in the real recording. A recording of `none` counts if any cause does.
    fn counts(&self, truth: &str, log_evidence: &[f64]) -> bool {
        let equal_gain =
            |of: &dyn Fn(&str) -> bool| self.gain(log_evidence, of, truth) >= self.gain(&self.log_evidence, of, truth);
        match truth {
            _ if truth == self.cause => {
                self.largest(log_evidence, |c| c == truth) >= self.largest(log_evidence, |_| true)
            }
            "none" => equal_gain(&|c| c != "none"),
            _ => equal_gain(&|c| c == self.cause),
        }
    }

    /// Index of a cause's competitor with the most evidence.
    fn best_of(&self, cause: &str) -> Option<usize> {
        let forms = (0..self.all.len()).filter(|i| self.all[*i].competitor.cause == cause);
        forms.max_by(|a, b| self.log_evidence[*a].total_cmp(&self.log_evidence[*b]))
    }

    /// Number of recordings by the best competitor of a cause that count.
    fn count(&self, truth: &str) -> Option<usize> {
        let of_truth = &self.residuals[self.best_of(truth)?];
        let mut noise: Vec<Surrogates> =
            self.noise.iter().zip(1..).map(|(x, seed)| Surrogates::with_seed(x, seed)).collect();
        let mut count = 0;
        for _ in 0..BOOTSTRAP_RECORDINGS {
            let noise = DVector::from_vec(noise.iter_mut().flat_map(Surrogates::draw).collect());
            // The recording is the model of `truth` plus noise, so that each residual shifts by the same series.
            let residuals: Vec<DVector<f64>> = self.residuals.iter().map(|r| r - of_truth + &noise).collect();
            count += usize::from(self.counts(truth, &log_evidences(&self.all, &residuals)?));
        }
        Some(count)
    }
}

/// Simulates and ranks recordings of every cause.
///
/// The first competitor has the most evidence, and leaves the noise. Competitors with other samples than its are left out.
/// `None` without competitors, or for a singular fit.
pub(crate) fn parametric_bootstrap(competitors: &[Competitor]) -> Option<BootstrapResult> {
    let first = competitors.first()?;
    let comparable = |c: &&Competitor| c.fit.channels == first.fit.channels;
    let all: Vec<LinearCompetitor<'_>> = competitors.iter().filter(comparable).map(LinearCompetitor::new).collect();
    let residuals: Vec<DVector<f64>> = all.iter().map(|p| p.competitor.fit.residual.clone()).collect();
    let log_evidence = log_evidences(&all, &residuals)?;
    let noise = first.fit.by_channel(&first.fit.residual);
    let mut causes: Vec<&'static str> = vec![];
    for p in &all {
        if !causes.contains(&p.competitor.cause) {
            causes.push(p.competitor.cause);
        }
    }
    let cause = first.cause;
    let bootstrap = Bootstrap { all, residuals, log_evidence, noise, cause };
    let recordings = BOOTSTRAP_RECORDINGS;
    let mut out = BootstrapResult { cause, recordings, chance: None, found: 0.0, not_told_apart: vec![] };
    for truth in causes {
        let count = bootstrap.count(truth)?;
        // The real recording is one of them.
        let share = (1 + count) as f64 / (1 + BOOTSTRAP_RECORDINGS) as f64;
        match truth {
            _ if truth == cause => out.found = count as f64 / BOOTSTRAP_RECORDINGS as f64,
            "none" => out.chance = Some(share),
            _ if cause != "none" && share > MAX_REFUTED_SHARE => {
                out.not_told_apart.push(EqualGain { cause: truth, share });
            }
            _ => {}
        }
    }
    Some(out)
}

#[cfg(test)]
mod tests {
    use super::{BootstrapResult, Competitor, parametric_bootstrap};
    use crate::fit::linearized::LinearizedFit;
    use crate::test_support::white_noise;
    use nalgebra::DMatrix;

    /// A hypothesis that adds multiples of shapes to a recording, fitted to it.
    fn competitor(cause: &'static str, recorded: &[f64], shapes: &[&[f64]]) -> Competitor {
        let n = recorded.len();
        let j = DMatrix::from_fn(n, shapes.len(), |t, k| shapes[k][t]);
        let b = nalgebra::DVector::from_column_slice(recorded);
        let left = match (j.tr_mul(&j)).cholesky() {
            Some(normal) if !shapes.is_empty() => &b - &j * normal.solve(&j.tr_mul(&b)),
            _ => b,
        };
        let prior_log_odds = if cause == "none" { 3.0 } else { 0.0 };
        Competitor {
            cause,
            prior_log_odds,
            point: vec![0.5; shapes.len()],
            parameters: shapes.len(),
            fit: LinearizedFit::new(left.as_slice(), &j, &[n]),
        }
    }

    /// Result for a recording with an effect of a shape and a size. Another cause has a shape that overlaps with it.
    fn simulated(size: f64, overlap: f64) -> Option<BootstrapResult> {
        let n = 300;
        let at = |k: f64| (0..n).map(|t| (k * f64::from(t)).sin()).collect::<Vec<f64>>();
        let (own, apart) = (at(0.11), at(0.173));
        let other: Vec<f64> = own.iter().zip(&apart).map(|(a, b)| overlap * a + (1.0 - overlap) * b).collect();
        let recorded: Vec<f64> = white_noise(7, n as usize).iter().zip(&own).map(|(x, s)| x + size * s).collect();
        let competitors = [("friction", vec![&own[..]]), ("damping", vec![&other]), ("none", vec![])];
        let competitors: Vec<Competitor> =
            competitors.iter().map(|(cause, shapes)| competitor(cause, &recorded, shapes)).collect();
        parametric_bootstrap(&competitors)
    }

    #[test]
    fn a_gain_far_above_the_noise_is_no_chance() {
        let b = simulated(2.0, 0.2).expect("an answer");
        assert_eq!(b.chance, Some(1.0 / 200.0));
        assert!(b.found > 0.99 && b.not_told_apart.is_empty(), "{b:?}");
        assert!(b.equal_gain("damping").is_none() && b.equal_gain("none") == b.chance);
        assert!(b.description().contains("none of 199"));
    }

    #[test]
    fn a_gain_within_the_noise_may_be_chance() {
        let b = simulated(0.02, 0.2).expect("an answer");
        assert!(b.chance.is_some_and(|p| p > 0.05), "{b:?}");
    }

    #[test]
    fn causes_with_nearly_equal_shapes_are_not_distinguished() {
        let b = simulated(2.0, 0.995).expect("an answer");
        assert_eq!(b.not_told_apart.iter().map(|s| s.cause).collect::<Vec<_>>(), ["damping"]);
        assert!(b.equal_gain("damping").is_some_and(|share| share > 0.05), "{b:?}");
        // The result repeats.
        assert_eq!(simulated(2.0, 0.995), Some(b));
    }
}
