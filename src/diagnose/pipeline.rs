//! The way from a study to a verdict.

use super::conclude::{Context, conclude};
use super::evidence::{INDEPENDENT, Noise, Residuals};
use super::fitting::{Bench, FOLDS, Fitted, Job, Samples};
use super::hypothesis::{self, Proposal, Sight};
use super::insertion::Place;
use super::outcome::Outcome;
use super::variant::Variant;
use super::watching;
use crate::study::{Fit, Opening, Role, ScriptSimulator, Study};
use std::collections::BTreeSet;
use std::sync::Arc;

/// What is asked for.
#[derive(Clone, Debug, Default)]
pub struct Settings {
    /// Causes that are left out of the library.
    pub without: Vec<String>,
    /// Number of threads.
    pub threads: usize,
}

/// Who wants to know how far it has come.
pub trait Watch {
    /// A stage has come so far.
    fn stage(&mut self, what: &str, done: usize, of: usize);
    /// Whether to stop.
    fn stopped(&self) -> bool;
}

/// What was found.
pub struct Diagnosis {
    /// As it is written.
    pub outcome: Outcome,
    /// The repaired script.
    pub script: String,
    /// All explanations that were weighed, best first: cause, form, place, objective, log evidence.
    pub weighed: Vec<Weighed>,
    /// Observed channels as the baseline and the repaired model have them, by run: NaN where there is no answer.
    pub before: Vec<Option<Fit>>,
    /// The same of the repaired model.
    pub after: Vec<Option<Fit>>,
}

/// An explanation that was weighed.
#[derive(Clone, Debug)]
pub struct Weighed {
    /// Cause; `none` for the user's model.
    pub cause: &'static str,
    /// Form of it.
    pub form: String,
    /// What it changes.
    pub at: String,
    /// Objective over all samples.
    pub objective: f64,
    /// Log evidence, on samples held back.
    pub evidence: f64,
}

/// An explanation that has been fitted.
#[derive(Clone)]
pub(super) struct Explained {
    pub(super) variant: Arc<Variant>,
    pub(super) fitted: Fitted,
    pub(super) evidence: f64,
}

impl Explained {
    pub(super) fn cause(&self) -> &'static str {
        self.variant.proposal.as_ref().map_or("none", |p| p.cause)
    }
}

/// Causes that go into the last round.
const FINALISTS: usize = 8;
/// Evaluations of a search, by its parameters: of the first round, of the second, of a fold, of the last.
const FIRST: usize = 8;
const SECOND_ROUND: usize = 16;
const FOLD: usize = 3;
pub(super) const LAST: usize = 30;
/// A second effect must gain so much log evidence.
const SECOND: f64 = 6.0;
/// Log odds, before anything is seen, of nothing missing against any one cause.
const NOTHING: f64 = 3.0;

pub(super) struct Work<'a> {
    pub(super) study: Arc<Study>,
    bench: Bench,
    watch: &'a mut dyn Watch,
}

impl Work<'_> {
    pub(super) fn fit(&mut self, stage: &str, jobs: Vec<Job>) -> Result<Vec<Option<Fitted>>, String> {
        let of = jobs.len();
        let mut out = Vec::with_capacity(of);
        // In portions, so that progress is seen and an interruption heard.
        let mut jobs = jobs.into_iter().peekable();
        while jobs.peek().is_some() {
            if self.watch.stopped() {
                return Err("interrupted".into());
            }
            self.watch.stage(stage, out.len(), of);
            let portion: Vec<Job> = jobs.by_ref().take(8).collect();
            out.extend(self.bench.fit(portion));
        }
        self.watch.stage(stage, of, of);
        Ok(out)
    }

    pub(super) fn job(variant: &Arc<Variant>, start: Vec<f64>, effort: usize, samples: Samples) -> Job {
        let budget = effort * (variant.dimension() + 5);
        Job { variant: variant.clone(), start, budget, samples }
    }

    /// Fit each on folds of time, and put together what it says on those that it did not see.
    fn held_back(&mut self, stage: &str, all: &[Explained]) -> Result<Vec<Option<Residuals>>, String> {
        let jobs = all
            .iter()
            .flat_map(|e| (0..FOLDS).map(|f| Self::job(&e.variant, e.fitted.point.clone(), FOLD, Samples::Without(f))));
        let fitted = self.fit(stage, jobs.collect())?;
        let study = self.study.clone();
        let put = |folds: &[Option<Fitted>]| -> Option<Residuals> {
            let runs: Vec<_> = study.runs.iter().filter(|r| r.role == Role::Fit).collect();
            let mut out = vec![];
            for (i, r) in runs.iter().enumerate() {
                for (c, o) in r.observe.iter().enumerate() {
                    let n = o.values.len();
                    let at = |t: usize| {
                        let fold = (0..FOLDS).find(|f| Samples::Without(*f).holds_back(t, n))?;
                        let simulated = folds[fold].as_ref()?.fits.get(i)?.channels[c][t];
                        Some(simulated - o.values[t])
                    };
                    let r: Option<Vec<f64>> = (0..n).map(at).collect();
                    out.push(r?.into_iter().filter(|d| d.is_finite()).collect());
                }
            }
            Some(out)
        };
        Ok(fitted.chunks(FOLDS).map(put).collect())
    }
}

/// Diagnose a study whose script has been opened.
///
/// # Errors
/// The model has no answer at all, or the user interrupted.
pub fn diagnose(
    simulator: &ScriptSimulator,
    opening: &Opening,
    text: &str,
    settings: &Settings,
    watch: &mut dyn Watch,
) -> Result<Diagnosis, String> {
    let study = simulator.study().clone();
    let blueprint = simulator.blueprint();
    let bench = Bench::new(blueprint.clone(), settings.threads).map_err(|e| e.to_string())?;
    let mut work = Work { study: study.clone(), bench, watch };

    let baseline = fit_baseline(&mut work, opening, text)?;
    let values = baseline.fitted.values.clone();
    let Some((place, anatomy)) = watching::look(&blueprint, &study, text, &values) else {
        return Err("the script makes no analysis".into());
    };
    let scales = watching::watch(&blueprint, &study, text, &values, &place, &anatomy);
    let sight = Sight { anatomy: &anatomy, study: &study, scales: &scales, fits: &baseline.fitted.fits };
    let library = hypothesis::ALL.iter().filter(|h| !settings.without.iter().any(|w| w == h.cause));
    let proposals: Vec<Proposal> = library.flat_map(|h| h.proposals(&sight)).collect();

    let first = first_round(&mut work, &baseline, &place, &proposals)?;
    let mut finalists = best_of_causes(&first);
    finalists.truncate(FINALISTS);
    let finalists = refine(&mut work, finalists)?;
    let (mut weighed, noise) = last_round(&mut work, baseline.clone(), finalists)?;
    weighed.sort_by(|a, b| b.evidence.total_cmp(&a.evidence));

    let mut best = weighed[0].clone();
    let mut also = vec![];
    if best.cause() != "none"
        && let Some(pair) = second_effect(&mut work, &baseline, &best, &first, &place, &noise)?
    {
        also.push(pair.1);
        best = pair.0;
    }
    let context = Context { study: &study, simulator, opening, text, place: &place, scales: &scales };
    conclude(&mut work, &context, &baseline, best, also, weighed)
}

/// The user's model by least squares, from its own values and from others.
fn fit_baseline(work: &mut Work<'_>, opening: &Opening, text: &str) -> Result<Explained, String> {
    let variant = Arc::new(Variant::baseline(&work.study, text));
    let n = variant.dimension();
    let mut starts = vec![work.study.space.point(&opening.values)];
    // Opposite corners of a smaller cube, and its middle.
    starts.push(vec![0.5; n]);
    for k in 0..4usize {
        starts.push((0..n).map(|i| if (i + k) % 2 == k / 2 { 0.2 } else { 0.8 }).collect());
    }
    let jobs = starts.into_iter().map(|s| Work::job(&variant, s, 12, Samples::All)).collect();
    let fitted = work.fit("the model as it is", jobs)?.into_iter().flatten().filter(|f| !f.fits.is_empty());
    let best = fitted.min_by(|a, b| a.objective.total_cmp(&b.objective));
    let fitted = best.ok_or("the model has no answer for any values of its parameters")?;
    Ok(Explained { variant, fitted, evidence: f64::NEG_INFINITY })
}

/// Every proposal fitted once, best objective first.
fn first_round(
    work: &mut Work<'_>,
    baseline: &Explained,
    place: &Place,
    proposals: &[Proposal],
) -> Result<Vec<Explained>, String> {
    let variants: Vec<Arc<Variant>> =
        proposals.iter().filter_map(|p| baseline.variant.with(place, p)).map(Arc::new).collect();
    let jobs = variants.iter().map(|v| Work::job(v, v.start(&baseline.fitted.values), FIRST, Samples::All)).collect();
    let fitted = work.fit("what may have been left out", jobs)?;
    let mut all: Vec<Explained> = variants
        .into_iter()
        .zip(fitted)
        .filter_map(|(variant, fitted)| {
            let fitted = fitted.filter(|f| !f.fits.is_empty())?;
            Some(Explained { variant, fitted, evidence: f64::NEG_INFINITY })
        })
        .collect();
    all.sort_by(|a, b| score(a).total_cmp(&score(b)));
    Ok(all)
}

/// Objective with a price for parameters, for the first sorting.
fn score(e: &Explained) -> f64 {
    e.fitted.objective.ln() + e.variant.dimension() as f64 * INDEPENDENT.ln() / INDEPENDENT
}

/// The best form of each cause, in the order of the causes.
fn best_of_causes(sorted: &[Explained]) -> Vec<Explained> {
    let mut seen = BTreeSet::new();
    sorted.iter().filter(|e| seen.insert(e.cause())).cloned().collect()
}

/// The finalists fitted more closely.
fn refine(work: &mut Work<'_>, finalists: Vec<Explained>) -> Result<Vec<Explained>, String> {
    let jobs = finalists.iter().map(|e| Work::job(&e.variant, e.fitted.point.clone(), SECOND_ROUND, Samples::All));
    let fitted = work.fit("the likeliest of them", jobs.collect())?;
    let better = |(e, f): (Explained, Option<Fitted>)| match f {
        Some(f) if !f.fits.is_empty() && f.objective < e.fitted.objective => Explained { fitted: f, ..e },
        _ => e,
    };
    Ok(finalists.into_iter().zip(fitted).map(better).collect())
}

/// Evidence of the user's model and of the finalists, on samples that they did not see; and the noise that it was
/// judged by.
fn last_round(
    work: &mut Work<'_>,
    baseline: Explained,
    finalists: Vec<Explained>,
) -> Result<(Vec<Explained>, Noise), String> {
    let mut all = vec![baseline];
    all.extend(finalists);
    let held = work.held_back("what it predicts", &all)?;
    let best = all
        .iter()
        .zip(&held)
        .filter(|(_, h)| h.is_some())
        .min_by(|(a, _), (b, _)| score(a).total_cmp(&score(b)))
        .and_then(|(_, h)| h.clone())
        .ok_or("no explanation could be tested on samples that it was not fitted to")?;
    let noise = Noise::of(&best);
    for (e, h) in all.iter_mut().zip(held) {
        e.evidence = h.map_or(f64::NEG_INFINITY, |r| noise.evidence(&r, e.variant.dimension()));
        // That nothing is missing is what is to be believed first.
        if e.cause() == "none" {
            e.evidence += NOTHING;
        }
    }
    Ok((all, noise))
}

/// The best second effect beside the best one, where it gains enough.
fn second_effect(
    work: &mut Work<'_>,
    baseline: &Explained,
    best: &Explained,
    first: &[Explained],
    place: &Place,
    noise: &Noise,
) -> Result<Option<(Explained, &'static str)>, String> {
    let Some(one) = &best.variant.proposal else { return Ok(None) };
    let mut pairs = vec![];
    for other in best_of_causes(first).iter().filter(|e| e.cause() != best.cause()) {
        let Some(two) = &other.variant.proposal else { continue };
        if let Some(v) = baseline.variant.with(place, &one.with(two)) {
            let v = Arc::new(v);
            let mut start = best.fitted.point.clone();
            // The second begins where it was proposed to.
            let proposed = v.start(&baseline.fitted.values);
            start.extend_from_slice(&proposed[start.len()..]);
            pairs.push((v, start, other.cause()));
        }
    }
    let jobs = pairs.iter().map(|(v, s, _)| Work::job(v, s.clone(), FIRST, Samples::All)).collect();
    let fitted = work.fit("a second effect", jobs)?;
    let mut tried: Vec<(Explained, &'static str)> = pairs
        .into_iter()
        .zip(fitted)
        .filter_map(|((variant, _, cause), fitted)| {
            let fitted = fitted.filter(|f| !f.fits.is_empty())?;
            Some((Explained { variant, fitted, evidence: f64::NEG_INFINITY }, cause))
        })
        .collect();
    tried.sort_by(|a, b| score(&a.0).total_cmp(&score(&b.0)));
    tried.truncate(3);
    let candidates: Vec<Explained> = tried.iter().map(|t| t.0.clone()).collect();
    let held = work.held_back("a second effect", &candidates)?;
    let mut found: Option<(Explained, &'static str)> = None;
    for ((mut e, cause), h) in tried.into_iter().zip(held) {
        let Some(h) = h else { continue };
        e.evidence = noise.evidence(&h, e.variant.dimension());
        if e.evidence > best.evidence + SECOND && found.as_ref().is_none_or(|f| e.evidence > f.0.evidence) {
            found = Some((e, cause));
        }
    }
    Ok(found)
}
