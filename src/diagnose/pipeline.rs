//! The way from a study to a verdict.

use super::evidence::{INDEPENDENT, Noise, Residuals, probabilities};
use super::fitting::{Bench, FOLDS, Fitted, Job, Samples};
use super::hypothesis::{self, Proposal, Sight};
use super::insertion::Place;
use super::locate::{regime, windows};
use super::noise::{explained, lines, power, whiten};
use super::outcome::{Baseline, Candidate, Corrected, Mismatch, Outcome, Verdict};
use super::scale::Scales;
use super::variant::Variant;
use super::{repair, watching};
use crate::study::{Fit, Opening, Role, ScriptSimulator, Study, fit};
use std::collections::BTreeMap;
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
struct Explained {
    variant: Arc<Variant>,
    fitted: Fitted,
    evidence: f64,
}

impl Explained {
    fn cause(&self) -> &'static str {
        self.variant.proposal.as_ref().map_or("none", |p| p.cause)
    }
}

/// Causes that go into the last round.
const FINALISTS: usize = 8;
/// Evaluations of a search, by its parameters: of the first round, of a fold, of the last.
const FIRST: usize = 8;
const FOLD: usize = 3;
const LAST: usize = 30;
/// A second effect must gain so much log evidence.
const SECOND: f64 = 6.0;
/// Log odds, before anything is seen, of nothing missing against any one cause.
const NOTHING: f64 = 3.0;
/// What `unknown` costs in log evidence: an explanation with a name is preferred to one without.
const NAMELESS: f64 = 9.0;

struct Work<'a> {
    study: Arc<Study>,
    bench: Bench,
    watch: &'a mut dyn Watch,
}

/// Residuals of the fitted runs.
fn residuals(study: &Study, fits: &[Fit]) -> Residuals {
    let runs = study.runs.iter().filter(|r| r.role == Role::Fit);
    let channels = runs.zip(fits).flat_map(|(r, f)| r.observe.iter().zip(&f.channels));
    channels.map(|(o, y)| y.iter().zip(&o.values).map(|(y, v)| y - v).filter(|d| d.is_finite()).collect()).collect()
}

impl Work<'_> {
    fn fit(&mut self, stage: &str, jobs: Vec<Job>) -> Result<Vec<Option<Fitted>>, String> {
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

    fn job(variant: &Arc<Variant>, start: Vec<f64>, effort: usize, samples: Samples) -> Job {
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
    let sight = Sight { anatomy: &anatomy, study: &study, scales: &scales };
    let library = hypothesis::ALL.iter().filter(|h| !settings.without.iter().any(|w| w == h.cause));
    let proposals: Vec<Proposal> = library.flat_map(|h| h.proposals(&sight)).collect();

    let first = first_round(&mut work, &baseline, &place, &proposals)?;
    let mut finalists = best_of_causes(&first);
    finalists.truncate(FINALISTS);
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
    conclude(&mut work, &context, &baseline, best, also, weighed, &noise)
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

/// The two best forms of each cause, in the order of the causes.
fn best_of_causes(sorted: &[Explained]) -> Vec<Explained> {
    let mut seen: BTreeMap<&str, usize> = BTreeMap::new();
    let mut out = vec![];
    for e in sorted {
        let n = seen.entry(e.cause()).or_default();
        *n += 1;
        if *n <= 1 {
            out.push(e.clone());
        }
    }
    out
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

struct Context<'a> {
    study: &'a Arc<Study>,
    simulator: &'a ScriptSimulator,
    opening: &'a Opening,
    text: &'a str,
    place: &'a Place,
    scales: &'a Scales,
}

/// Part of a residual that has structure which no noise has: told by the motion of the devices, or standing in lines.
fn structure(study: &Study, scales: &Scales, fits: &[Fit]) -> (f64, String) {
    let (mut most, mut says) = (0.0, String::new());
    let runs = study.runs.iter().enumerate().filter(|(_, r)| r.role == Role::Fit);
    for ((number, run), fit) in runs.zip(fits) {
        let columns = regressors(scales, number);
        for (o, y) in run.observe.iter().zip(&fit.channels) {
            let r: Vec<f64> =
                y.iter().zip(&o.values).map(|(y, v)| if (y - v).is_finite() { y - v } else { 0.0 }).collect();
            let told = explained(&r, &columns, 6);
            let (line, frequency) = lines(&r);
            let times = &run.recording.times;
            let rate = (times.len() - 1) as f64 / (times[times.len() - 1] - times[0]);
            // Only what matters for this channel against the others.
            let weight = (power(&r) / o.variance / 1e-4).min(1.0);
            if weight * told > most {
                most = weight * told;
                says = format!("part of the residual of {} follows the motion of the device", o.channel);
            }
            if weight * line > most {
                most = weight * line;
                says = format!("the residual of {} has a line at {:.3} Hz", o.channel, frequency * rate);
            }
        }
    }
    (most, says)
}

/// Smooth functions of the motion of the devices in a run, scaled to one.
fn regressors(scales: &Scales, run: usize) -> Vec<Vec<f64>> {
    let mut out: Vec<Vec<f64>> = vec![];
    for ((_, _, _), w) in scales.watched.iter().filter(|((r, _, _), _)| *r == run).take(3) {
        let n = w.times.len();
        let scaled = |v: Vec<f64>| {
            let top = v.iter().filter(|x| x.is_finite()).fold(0.0f64, |m, x| m.max(x.abs())).max(f64::MIN_POSITIVE);
            v.into_iter().map(|x| if x.is_finite() { x / top } else { 0.0 }).collect::<Vec<f64>>()
        };
        let e = scaled(w.e.clone());
        let q = scaled(w.q.clone());
        let v = scaled(
            (0..n).map(|i| if i == 0 { 0.0 } else { (w.e[i] - w.e[i - 1]) / (w.times[i] - w.times[i - 1]) }).collect(),
        );
        let t: Vec<f64> = (0..n).map(|i| i as f64 / n as f64).collect();
        let mut largest = 0.0f64;
        let m: Vec<f64> = e
            .iter()
            .map(|x| {
                largest = largest.max(x.abs());
                largest
            })
            .collect();
        let each = |f: &dyn Fn(usize) -> f64| (0..n).map(f).collect::<Vec<f64>>();
        out.extend([
            each(&|i| 1.0 + 0.0 * t[i]),
            e.clone(),
            q.clone(),
            v.clone(),
            each(&|i| e[i].powi(3)),
            each(&|i| q[i] * q[i].abs()),
            each(&|i| v[i].signum() * v[i].abs().sqrt()),
            each(&|i| e[i] * t[i]),
            each(&|i| q[i] * t[i]),
            each(&|i| e[i] * m[i]),
            each(&|i| q[i] * m[i]),
            each(&|i| e[i] * v[i].abs()),
            each(&|i| t[i]),
            each(&|i| e[i] * e[i]),
        ]);
    }
    out
}

/// Put the verdict together.
fn conclude(
    work: &mut Work<'_>,
    c: &Context<'_>,
    baseline: &Explained,
    best: Explained,
    mut also: Vec<&'static str>,
    weighed: Vec<Explained>,
    noise: &Noise,
) -> Result<Diagnosis, String> {
    let study = c.study;
    let evidence_of_none = weighed.iter().find(|e| e.cause() == "none").map_or(f64::NEG_INFINITY, |e| e.evidence);
    let mut causes: Vec<(&'static str, f64)> = weighed.iter().map(|e| (e.cause(), e.evidence)).collect();
    let cause = best.cause();
    if let Some(own) = causes.iter_mut().find(|(n, _)| *n == cause) {
        own.1 = own.1.max(best.evidence);
    }
    // What the best explanation has explained of what there was to explain, and what structure it leaves.
    let (left, signature) = structure(study, c.scales, &best.fitted.fits);
    let whitened = |fits: &[Fit]| -> f64 {
        let r = residuals(study, fits);
        r.iter().map(|r| power(&whiten(r, &[]))).zip(variances(study)).map(|(p, v)| p / v).sum()
    };
    let (before, after) = (whitened(&baseline.fitted.fits), whitened(&best.fitted.fits));
    let floor = after * (1.0 - left);
    let done = if before > floor { ((before - after) / (before - floor)).clamp(0.0, 1.0) } else { 1.0 };
    let _ = noise;
    let unknown = best.evidence.max(evidence_of_none)
        - 0.5 * INDEPENDENT * (1.0 - left).max(1e-6).ln()
        - NAMELESS
        - 60.0 * (done - 0.6).max(0.0) * f64::from(u8::from(cause != "none"));
    causes.push(("unknown", unknown));
    causes.sort_by(|a, b| b.1.total_cmp(&a.1));
    let p = probabilities(&causes.iter().map(|c| c.1).collect::<Vec<_>>());
    let (verdict, confidence) = (causes[0].0, p[0]);
    let chosen = if verdict == "none" || verdict == "unknown" {
        also.clear();
        baseline.clone()
    } else {
        best
    };
    // The last search, from where the chosen one stands.
    let job = Work::job(&chosen.variant, chosen.fitted.point.clone(), LAST, Samples::All);
    let refined = work.fit("the repaired model", vec![job])?.into_iter().flatten().find(|f| !f.fits.is_empty());
    let fitted = refined.filter(|f| f.objective <= chosen.fitted.objective).unwrap_or_else(|| chosen.fitted.clone());

    let all_runs = |e: &Explained, values: &[f64]| -> Vec<Option<Fit>> {
        let blueprint = c.simulator.blueprint();
        let mut simulator = e.variant.simulator(&blueprint);
        (0..study.runs.len()).map(|r| fit(&mut simulator, study, r, values).ok()).collect()
    };
    let before = all_runs(baseline, &baseline.fitted.values);
    let after = all_runs(&chosen, &fitted.values);
    let holdout = |fits: &[Option<Fit>]| -> Option<f64> {
        let held: Vec<f64> = study
            .runs_of(Role::Holdout)
            .map(|(i, r)| Some(fits[i].as_ref()?.nmse(&r.observe)))
            .collect::<Option<_>>()?;
        (!held.is_empty()).then(|| held.iter().sum::<f64>() / held.len() as f64)
    };
    let named = |space: &crate::study::Space, values: &[f64]| -> BTreeMap<String, f64> {
        space.parameters.iter().map(|p| p.name.clone()).zip(values.iter().copied()).collect()
    };
    let corrections = chosen.variant.corrections(&fitted.values);
    let share = if baseline.fitted.objective > 0.0 { fitted.objective / baseline.fitted.objective } else { 1.0 };
    let outcome = Outcome {
        baseline: Baseline {
            fit_nmse: baseline.fitted.objective,
            holdout_nmse: holdout(&before),
            parameters: named(&study.space, &baseline.fitted.values),
        },
        mismatch: mismatches(c, &before),
        verdict: Verdict {
            cause: verdict.into(),
            confidence,
            also: also.iter().map(|a| (*a).to_owned()).collect(),
            also_possible: causes
                .iter()
                .zip(&p)
                .skip(1)
                .filter(|(_, p)| **p > 0.005)
                .map(|((cause, _), p)| Candidate { cause: (*cause).into(), confidence: *p })
                .collect(),
            explanation: explanation(verdict, &chosen, &also, &signature, share),
        },
        corrected: Corrected {
            script: "corrected.tcl".into(),
            parameters: named(&chosen.variant.study.space, &fitted.values),
            fit_nmse: fitted.objective,
            holdout_nmse: holdout(&after),
            channels: corrections,
        },
        unexplained_share: share.min(1.0),
        next_test: next_test(verdict, &causes),
    };
    let script = repair::script(c.text, &c.opening.places, c.place, &chosen.variant, &fitted.values);
    let weighed = weighed
        .iter()
        .map(|e| Weighed {
            cause: e.cause(),
            form: e.variant.proposal.as_ref().map_or_else(String::new, |p| p.form.clone()),
            at: e.variant.proposal.as_ref().map_or_else(String::new, |p| p.at.clone()),
            objective: e.fitted.objective,
            evidence: e.evidence,
        })
        .collect();
    Ok(Diagnosis { outcome, script, weighed, before, after })
}

fn variances(study: &Study) -> Vec<f64> {
    study.runs.iter().filter(|r| r.role == Role::Fit).flat_map(|r| &r.observe).map(|o| o.variance).collect()
}

/// Where the baseline differs, the channel with the largest error first.
fn mismatches(c: &Context<'_>, fits: &[Option<Fit>]) -> Vec<Mismatch> {
    let mut all: Vec<(f64, Mismatch)> = vec![];
    for (number, run) in c.study.runs_of(Role::Fit) {
        let Some(f) = &fits[number] else { continue };
        let motion = c.scales.watched.iter().find(|((r, _, _), _)| *r == number).map(|(_, w)| w.e.clone());
        for ((o, y), s) in run.observe.iter().zip(&f.channels).zip(&f.scores) {
            let times = &run.recording.times;
            let r: Vec<f64> = y.iter().zip(&o.values).map(|(y, v)| y - v).collect();
            let found = windows(times, &r);
            let regime = regime(times, &found, motion.as_ref().unwrap_or(&o.values));
            all.push((
                s.nmse,
                Mismatch {
                    run: run.name.clone(),
                    channel: o.channel.clone(),
                    at: o.at.clone(),
                    windows: found.windows,
                    share: found.share,
                    regime,
                },
            ));
        }
    }
    all.sort_by(|a, b| b.0.total_cmp(&a.0));
    all.into_iter().map(|(_, m)| m).collect()
}

fn explanation(verdict: &str, chosen: &Explained, also: &[&str], signature: &str, share: f64) -> String {
    match verdict {
        "none" => {
            "what the model leaves of the recordings is noise: no effect of the library gains anything on samples \
                   that it was not fitted to"
                .into()
        }
        "unknown" => format!("there is structure that no effect of the library explains: {signature}"),
        cause => {
            let h = hypothesis::of(cause);
            let place =
                chosen.variant.proposal.as_ref().map_or_else(String::new, |p| format!(" ({}, {})", p.at, p.form));
            let mut text = format!("{}{place}", h.map_or(cause, |h| h.says));
            for second in also {
                text += &format!("; and {}", hypothesis::of(second).map_or(*second, |h| h.says));
            }
            text += &format!(
                "; the repaired model leaves {:.1} % of the squared error. It would be wrong if {}.",
                100.0 * share,
                h.map_or("", |h| h.refuted_by)
            );
            text
        }
    }
}

fn next_test(verdict: &str, causes: &[(&'static str, f64)]) -> String {
    let rival = causes.iter().map(|c| c.0).find(|c| *c != verdict && *c != "none" && *c != "unknown");
    match (hypothesis::of(verdict), rival.and_then(hypothesis::of)) {
        (Some(h), Some(r)) => {
            format!("to tell {} from {}: see whether {}, and whether {}", h.cause, r.cause, h.refuted_by, r.refuted_by)
        }
        (Some(h), None) => format!("see whether {}", h.refuted_by),
        _ => "repeat a run unchanged: what repeats is the model, what does not is noise".into(),
    }
}
