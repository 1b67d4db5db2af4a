//! From the explanations that were weighed to the verdict, the repaired model and the words.

use crate::candidate::repaired_script;
use crate::candidate::sensor_fault::Correction;
use crate::candidate::variant::Variant;
use crate::evidence::holdout::{Judgement, holdout, judge};
use crate::evidence::parametric_bootstrap::Bootstrap;
use crate::evidence::probabilities::Odds;
use crate::fit::evaluator::Fitted;
use crate::fit::scheduler::{Explained, LAST, Work};
use crate::fit::screening::{as_much, tried};
use crate::fit::step_error::StepError;
use crate::hypothesis;
use crate::inspect::insertion::Place;
use crate::inspect::response::Scales;
use crate::verdict::diagnosis::{Diagnosis, Weighed};
use crate::verdict::discriminating_test::next_test;
use crate::verdict::mismatch::{regime, windows};
use crate::verdict::result_file::{Baseline, Candidate, Corrected, Mismatch, Outcome, Verdict};
use hysteron_identify::study::{Fit, Opening, Role, ScriptSimulator, Study, fit};
use std::collections::BTreeMap;
use std::sync::Arc;

/// Log evidence over the model as it is from which a repair is written although structure is left that it does not
/// explain.
const WORTH: f64 = 5.0;
/// Further starts of the last search, and the sides of the cube in which they lie, against that of the whole.
const AROUND: usize = 3;
const NEAR: f64 = 0.1;

pub(crate) struct Context<'a> {
    pub(crate) study: &'a Arc<Study>,
    pub(crate) simulator: &'a ScriptSimulator,
    pub(crate) opening: &'a Opening,
    pub(crate) text: &'a str,
    pub(crate) place: &'a Place,
    pub(crate) scales: &'a Scales,
    /// The motion is that of the device, not of the ground.
    pub(crate) imposed: bool,
    /// How long the steps of the script are.
    pub(crate) steps: StepError,
    /// Causes that were left out because the recordings have no clock.
    pub(crate) untimed: Vec<&'static str>,
    /// Little is to be believed of the fitted model, and the runs are too long to search for physics far from it.
    pub(crate) too_long: bool,
    /// What recordings with a known truth say of the explanation with the most evidence.
    pub(crate) bootstrap: Option<Bootstrap>,
}

/// Put the verdict together. `baseline` is the fitted model with the steps of the script, `weighed` what was weighed with
/// steps as short as they have to be.
pub(crate) fn conclude(
    work: &mut Work<'_>,
    c: &Context<'_>,
    baseline: &Explained,
    weighed: Vec<Explained>,
) -> Result<Diagnosis, String> {
    let study = c.study;
    let best = &weighed[0];
    let Odds { mut odds, left, signature, none: evidence_of_none } =
        Odds::of(study, c.scales, baseline, &weighed, c.bootstrap.as_ref());
    let before = all_runs(c, &baseline.variant, &baseline.fitted.values);
    // It is the script as it is written that is repaired.
    work.bench.refine(1);
    let mut repairs: Vec<(&'static str, Repair)> = vec![];
    let verdict = loop {
        let verdict = odds[0].0;
        // Where structure is left the nearest repair is written all the same.
        if repairs.iter().any(|(cause, _)| *cause == verdict) || verdict == "unknown" && !repairs.is_empty() {
            break verdict;
        }
        let chosen = match verdict {
            "none" => baseline,
            "unknown" if best.evidence < evidence_of_none + WORTH => baseline,
            "unknown" => best,
            _ => weighed.iter().find(|e| e.cause() == verdict).unwrap_or(best),
        };
        let mut repair = repaired(work, c, chosen.clone(), (&before, left))?;
        // Another form of the cause may predict what the first does not.
        let another = weighed.iter().filter(|e| e.cause() == verdict && e.evidence > evidence_of_none).nth(1);
        if let Some(form) = another.filter(|_| repair.judgement.refutes()) {
            let other = repaired(work, c, form.clone(), (&before, left))?;
            if !other.judgement.refutes() {
                repair = other;
            }
        }
        let keeps = repair.judgement.keeps();
        if let Some(n) = odds.iter().position(|(cause, _)| keeps < 1.0 && *cause == "unknown") {
            let doubted = (1.0 - keeps) * odds[0].1;
            odds[0].1 -= doubted;
            odds[n].1 += doubted;
            odds.sort_by(|a, b| b.1.total_cmp(&a.1));
        }
        repairs.push((verdict, repair));
    };
    let named_by_it = repairs.iter().position(|(cause, _)| *cause == verdict).unwrap_or(0);
    let (nearest, mut repair) = repairs.swap_remove(named_by_it);
    // Nobody is given a model as repaired that has no name and is known to do harm.
    let refused = verdict == "unknown" && repair.judgement.refutes();
    if refused {
        repair = repaired(work, c, baseline.clone(), (&before, left))?;
    }
    let Repair { chosen, fitted, after, judgement } = repair;
    let named = |space: &hysteron_identify::study::Space, values: &[f64]| -> BTreeMap<String, f64> {
        space.parameters.iter().map(|p| p.name.clone()).zip(values.iter().copied()).collect()
    };
    let corrections = chosen.variant.corrections(&fitted.values);
    let share = if baseline.fitted.objective > 0.0 { fitted.objective / baseline.fitted.objective } else { 1.0 };
    let also: Vec<&str> = chosen.second().into_iter().filter(|_| verdict != "unknown").collect();
    let mut explanation = explanation(verdict, &chosen, &also, &signature, share) + &c.steps.says();
    if let Some(b) = c.bootstrap.as_ref().filter(|b| b.cause == verdict) {
        explanation += &b.says();
    }
    let other = |e: &&Explained| as_much(e, &chosen) && !Arc::ptr_eq(&e.variant, &chosen.variant);
    if let Some(p) = weighed.iter().find(other).and_then(|e| e.variant.proposal.as_ref()) {
        explanation += &format!(" Another form explains as much: {}, {}.", p.at, p.form);
    }
    if !c.untimed.is_empty() {
        explanation += &format!(
            " The times of the recordings count samples: {} need a clock and were left out (--clock takes them for seconds).",
            c.untimed.join(" and ")
        );
    }
    if c.too_long {
        explanation += " The fitted model leaves much, and the fitted runs are too long to search for every effect far from its values: fewer of them, or \
                        fewer samples, may tell more.";
    }
    explanation += &judgement.says();
    if refused {
        let nearest = if nearest == "unknown" { best.cause() } else { nearest };
        explanation += &format!(" No repair is written: the nearest, {nearest}, makes the runs held out no better.");
    }
    // The verdict and its strongest rival, each as it was fitted.
    let rival = weighed.iter().find(|e| e.cause() != chosen.cause() && e.cause() != "none");
    let observe = observation(verdict, rival.map(Explained::cause));
    let next_test = rival
        .filter(|_| chosen.cause() != "none")
        .and_then(|r| next_test(&c.simulator.blueprint(), study, c.imposed, [&chosen, r]));
    let outcome = Outcome {
        baseline: Baseline {
            fit_nmse: baseline.fitted.objective,
            holdout_nmse: holdout(study, &before),
            parameters: named(&study.space, &baseline.fitted.values),
        },
        mismatch: mismatches(c, &before, Some(&after).filter(|_| !matches!(verdict, "none" | "unknown"))),
        verdict: Verdict {
            cause: verdict.into(),
            confidence: odds[0].1,
            also: also.iter().map(|a| (*a).to_owned()).collect(),
            also_possible: odds
                .iter()
                .skip(1)
                .filter(|(_, p)| *p > 0.005)
                .map(|(cause, p)| Candidate { cause: (*cause).into(), confidence: *p })
                .collect(),
            explanation,
        },
        corrected: Corrected {
            script: "corrected.tcl".into(),
            parameters: named(&chosen.variant.study.space, &fitted.values),
            fit_nmse: fitted.objective,
            holdout_nmse: holdout(study, &after),
            channels: corrections,
        },
        unexplained_share: share.min(1.0),
        bootstrap: c.bootstrap.clone(),
        next_test: match &next_test {
            Some(t) => format!("{}; {observe}", t.says),
            None => observe,
        },
    };
    let script = repaired_script::script(c.text, &c.opening.places, c.place, &chosen.variant, &fitted.values);
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
    // Where the displacement is not recorded, what the model's device deforms by under an imposed motion.
    let deformed = |r: usize| -> Option<(String, Vec<f64>)> {
        let of_run = c.scales.watched.iter().filter(|((run, ..), _)| *run == r && c.imposed);
        let ((_, tag, _), w) = of_run.max_by(|a, b| a.1.extent().e.total_cmp(&b.1.extent().e))?;
        (w.e.len() == study.runs[r].recording.times.len())
            .then(|| (format!("deformation of element {tag}, simulated"), w.e.clone()))
    };
    let over = |r: usize| c.simulator.displacement(r, &baseline.fitted.values).or_else(|| deformed(r));
    let displacements = (0..study.runs.len()).map(over).collect();
    Ok(Diagnosis {
        outcome,
        script,
        weighed,
        before,
        after,
        displacements,
        next_test,
        looks: work.bench.looks(),
        left: (left, signature),
    })
}

/// A model that was repaired.
struct Repair {
    /// The explanation that it is repaired by.
    chosen: Explained,
    /// As it was fitted with the steps of the script.
    fitted: Fitted,
    /// What it says of all runs.
    after: Vec<Option<Fit>>,
    /// What the runs that were held out say of it.
    judgement: Judgement,
}

/// The last search, from where the chosen one stands and from around it: contact and yielding make ridges. Runs that were
/// held out are looked at here for the first time: they can only take confidence away.
fn repaired(
    work: &mut Work<'_>,
    c: &Context<'_>,
    chosen: Explained,
    (before, left): (&[Option<Fit>], f64),
) -> Result<Repair, String> {
    let study = c.study;
    let starts = around(&chosen.fitted.point);
    let jobs = starts.into_iter().map(|start| Work::search(&chosen.variant, start, LAST)).collect();
    let refined = work.fit("the repaired model", jobs)?.into_iter().flatten();
    let known = Some(chosen.fitted.clone()).filter(|_| c.steps.parts == 1);
    let fitted = known.into_iter().chain(refined).min_by(|a, b| a.objective.total_cmp(&b.objective));
    let fitted = fitted.ok_or("the repaired model has no answer with the steps of the script")?;
    let after = all_runs(c, &chosen.variant, &fitted.values);
    work.go_on()?;
    let concerned =
        |f: &Correction| f.run.as_ref().is_none_or(|name| study.runs_of(Role::Holdout).any(|(_, r)| r.name == *name));
    let acts_there = chosen.variant.edits() || chosen.variant.corrections(&fitted.values).iter().any(concerned);
    // Of the model as it is nothing is claimed.
    let judgement = match chosen.cause() {
        "none" => Judgement::Keeps,
        _ => judge(study, before, (&after, left), acts_there, chosen.variant.seen() > 0.0),
    };
    Ok(Repair { chosen, fitted, after, judgement })
}

/// What a variant says of all runs with the steps of the script; `None` where it has no answer.
fn all_runs(c: &Context<'_>, variant: &Arc<Variant>, values: &[f64]) -> Vec<Option<Fit>> {
    let mut simulator = variant.simulator(&c.simulator.blueprint());
    (0..c.study.runs.len()).map(|r| fit(&mut simulator, c.study, r, values).ok()).collect()
}

/// A point, and others around it.
fn around(point: &[f64]) -> Vec<Vec<f64>> {
    let middle: Vec<f64> = point.iter().map(|_| 0.5).collect();
    let of_a_parameter = AROUND.div_ceil(point.len() + 1);
    let spread = tried(&middle, 0, of_a_parameter).into_iter().skip(1).take(AROUND);
    let near = |other: Vec<f64>| point.iter().zip(other).map(|(p, o)| (p + NEAR * (o - 0.5)).clamp(0.0, 1.0)).collect();
    std::iter::once(point.to_vec()).chain(spread.map(near)).collect()
}

/// Where the baseline differs, the channel with the largest error first. A repair that has a name tells what of the error is no noise.
fn mismatches(c: &Context<'_>, fits: &[Option<Fit>], repaired: Option<&Vec<Option<Fit>>>) -> Vec<Mismatch> {
    let mut all: Vec<(f64, Mismatch)> = vec![];
    for (number, run) in c.study.runs_of(Role::Fit) {
        let Some(f) = &fits[number] else { continue };
        let motion = c.scales.watched.iter().find(|((r, _, _), _)| *r == number).map(|(_, w)| w.e.clone());
        let repaired = repaired.and_then(|r| r[number].as_ref());
        for (channel, ((o, y), s)) in run.observe.iter().zip(&f.channels).zip(&f.scores).enumerate() {
            let times = &run.recording.times;
            let differs = |from: &[f64]| -> Vec<f64> { y.iter().zip(from).map(|(y, v)| y - v).collect() };
            let error = differs(&o.values);
            let effect = repaired.map(|r| differs(&r.channels[channel]));
            let found = windows(times, &error, effect.as_deref());
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
                   that it was not fitted to."
                .into()
        }
        "unknown" => {
            let mut text = if signature.is_empty() {
                "nothing speaks clearly for an effect of the library, nor for noise".to_owned()
            } else {
                format!("there is structure that no effect of the library explains: {signature}")
            };
            if let Some(h) = hypothesis::of(chosen.cause()) {
                text += &format!(
                    "; the repaired model has the nearest, {}, and leaves {:.1} % of the squared error",
                    h.cause,
                    100.0 * share
                );
            }
            text + "."
        }
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

/// What to look at next, in words, where no test of the rig can be proposed.
fn observation(verdict: &str, rival: Option<&str>) -> String {
    match (hypothesis::of(verdict), rival.and_then(hypothesis::of)) {
        (Some(h), Some(r)) => {
            format!("to tell {} from {}: see whether {}, and whether {}", h.cause, r.cause, h.refuted_by, r.refuted_by)
        }
        (Some(h), None) => format!("see whether {}", h.refuted_by),
        _ => "repeat a run unchanged: what repeats is the model, what does not is noise".into(),
    }
}
