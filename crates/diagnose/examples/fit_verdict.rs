//! Fits the weights of the verdict to cases with a known truth, and tests them on authors that the fit has not seen.
//!
//!     cargo run --release -p hysteron-diagnose --example fit_verdict -- CASES.jsonl PREDICTIONS.csv FEATURES.csv [WEIGHTS.rs]
//!
//! Each line of the first file is a case: `case`, `group` (author, or family of models), `right` (causes that are right),
//! `weight` (1 by default) and `evidence` of its `diagnosis.json`. A group is predicted by weights that were fitted to all others.
//!
//! - `PREDICTIONS.csv` gets the probabilities of that prediction.
//! - `FEATURES.csv` gets the weights, and what becomes of the prediction without each feature in turn.
//! - `WEIGHTS.rs` gets the weights fitted to all groups.

#![expect(clippy::print_stdout, reason = "a program on the terminal")]

use hysteron_diagnose::verdict_model::{
    CandidateFeatures, FEATURE_COUNT, FEATURES, candidates, pair_gain, probabilities,
};
use hysteron_diagnose::{HypothesisEvidence, VerdictEvidence};
use nalgebra::{SMatrix, SVector};
use serde::Deserialize;
use std::collections::BTreeSet;
use std::fmt::Write as _;

type Weights = SVector<f64, FEATURE_COUNT>;
type Hessian = SMatrix<f64, FEATURE_COUNT, FEATURE_COUNT>;

/// Ridges that cross-validation chooses from.
const RIDGES: [f64; 6] = [0.1, 0.3, 1.0, 3.0, 10.0, 30.0];
/// Features whose weight cannot be negative: more of them speaks for the candidate.
const POSITIVE: [&str; 8] = [
    "gain",
    "ln_gap_of_look_alike",
    "auxiliary",
    "predicted",
    "none_first",
    "unknown_structure_unexplained",
    "unknown_structure_without_cause",
    "unknown_motion",
];
/// Features whose weight cannot be positive.
const NEGATIVE: [&str; 3] = ["ln_gap", "at_bound", "coincidence"];

/// Largest number of Newton steps.
const STEPS: usize = 60;
/// Gain in the objective below which the fit ends.
const TOLERANCE: f64 = 1e-9;

/// A line of the file.
#[derive(Deserialize)]
struct Line {
    case: String,
    group: String,
    right: Vec<String>,
    /// Weight of the case.
    #[serde(default = "one")]
    weight: f64,
    evidence: VerdictEvidence,
}

fn one() -> f64 {
    1.0
}

/// A case with the features of its candidates.
struct Case {
    name: String,
    group: String,
    weight: f64,
    candidates: Vec<CandidateFeatures>,
    /// Candidates that are right; `unknown` if the right cause is no candidate.
    right: Vec<bool>,
    /// True if the right cause is a candidate.
    answerable: bool,
    /// Pairs whose first effect is right: ln(1 + gain), and whether the second effect is right as well.
    pairs: Vec<(f64, bool)>,
}

impl Case {
    fn of(line: Line) -> Self {
        let all = candidates(&line.evidence);
        let right: Vec<bool> = all.iter().map(|c| line.right.contains(&c.cause)).collect();
        let answerable = right.contains(&true);
        let right = if answerable { right } else { all.iter().map(|c| c.cause == "unknown").collect() };
        let e = &line.evidence;
        let pair = |h: &HypothesisEvidence| {
            let also = h.also.as_ref().filter(|_| line.right.contains(&h.cause))?;
            Some((pair_gain(e, h).ln_1p(), line.right.contains(also)))
        };
        let pairs = e.hypotheses.iter().filter_map(pair).collect();
        Self { name: line.case, group: line.group, weight: line.weight, candidates: all, right, answerable, pairs }
    }

    fn probabilities(&self, w: &Weights) -> Vec<f64> {
        probabilities(&self.candidates, &w.data.0[0])
    }

    /// Logarithm of the probability of what is right.
    fn log_score(&self, w: &Weights) -> f64 {
        let p = self.probabilities(w);
        p.iter().zip(&self.right).filter(|(_, r)| **r).map(|(p, _)| p).sum::<f64>().max(f64::MIN_POSITIVE).ln()
    }

    /// Adds the gradient of the log score and the negative Hessian of the softmax.
    fn derivatives(&self, w: &Weights, gradient: &mut Weights, hessian: &mut Hessian) {
        let p = self.probabilities(w);
        let of_right: f64 = p.iter().zip(&self.right).filter(|(_, r)| **r).map(|(p, _)| p).sum();
        let mut mean = Weights::zeros();
        for (i, c) in self.candidates.iter().enumerate() {
            let x = Weights::from_row_slice(&c.x);
            let target = if self.right[i] { p[i] / of_right.max(f64::MIN_POSITIVE) } else { 0.0 };
            *gradient += x * (target - p[i]) * self.weight;
            *hessian += x * x.transpose() * p[i] * self.weight;
            mean += x * p[i];
        }
        *hessian -= mean * mean.transpose() * self.weight;
    }
}

/// Returns true if a weight has a sign that its feature cannot have.
fn has_wrong_sign(k: usize, weight: f64) -> bool {
    POSITIVE.contains(&FEATURES[k]) && weight < 0.0 || NEGATIVE.contains(&FEATURES[k]) && weight > 0.0
}

/// Weights with the largest sum of log scores less the ridge's half square. One feature may be left out.
///
/// Weights of the wrong sign are held at zero, the worst first, until none is left.
fn fit(cases: &[&Case], ridge: f64, without: Option<usize>) -> Weights {
    let mut held = [false; FEATURE_COUNT];
    without.into_iter().for_each(|k| held[k] = true);
    loop {
        let w = fit_free(cases, ridge, &held);
        let wrong = (0..FEATURE_COUNT).filter(|k| has_wrong_sign(*k, w[*k]));
        match wrong.max_by(|a, b| w[*a].abs().total_cmp(&w[*b].abs())) {
            Some(k) => held[k] = true,
            None => return w,
        }
    }
}

/// The same with some weights held at zero, by damped Newton steps.
fn fit_free(cases: &[&Case], ridge: f64, held: &[bool; FEATURE_COUNT]) -> Weights {
    let objective =
        |w: &Weights| cases.iter().map(|c| c.weight * c.log_score(w)).sum::<f64>() - 0.5 * ridge * w.norm_squared();
    let mut w = Weights::zeros();
    let mut value = objective(&w);
    for _ in 0..STEPS {
        let (mut gradient, mut hessian) = (-w * ridge, Hessian::identity() * ridge);
        cases.iter().for_each(|c| c.derivatives(&w, &mut gradient, &mut hessian));
        for k in (0..FEATURE_COUNT).filter(|k| held[*k]) {
            gradient[k] = 0.0;
            hessian.fill_row(k, 0.0);
            hessian.fill_column(k, 0.0);
            hessian[(k, k)] = 1.0;
        }
        let Some(step) = hessian.cholesky().map(|h| h.solve(&gradient)) else { break };
        let tried = (0..12).map(|k| w + step * 0.5f64.powi(k)).map(|w| (objective(&w), w));
        let Some((better, at)) = tried.into_iter().find(|(v, _)| *v > value) else { break };
        let gain = better - value;
        (value, w) = (better, at);
        if gain < TOLERANCE {
            break;
        }
    }
    w
}

/// Weights for each group, fitted to all others.
fn cross_validated(cases: &[Case], ridge: f64, without: Option<usize>) -> Vec<(String, Weights)> {
    let groups: BTreeSet<&String> = cases.iter().map(|c| &c.group).collect();
    let of_others = |g: &String| fit(&cases.iter().filter(|c| c.group != *g).collect::<Vec<_>>(), ridge, without);
    groups.into_iter().map(|g| (g.clone(), of_others(g))).collect()
}

/// Cases predicted by weights that their group has not seen.
struct Predictions<'a> {
    cases: &'a [Case],
    by_group: Vec<(String, Weights)>,
}

impl<'a> Predictions<'a> {
    fn of(cases: &'a [Case], ridge: f64, without: Option<usize>) -> Self {
        Self { cases, by_group: cross_validated(cases, ridge, without) }
    }

    fn weights(&self, case: &Case) -> Weights {
        self.by_group.iter().find(|(g, _)| *g == case.group).map_or_else(Weights::zeros, |(_, w)| *w)
    }

    /// Mean log score.
    fn score(&self) -> f64 {
        let weight: f64 = self.cases.iter().map(|c| c.weight).sum();
        self.cases.iter().map(|c| c.weight * c.log_score(&self.weights(c))).sum::<f64>() / weight
    }

    /// Index of the most probable candidate of each case, with its probability.
    fn answers(&self) -> Vec<(usize, f64)> {
        let first = |c: &Case| {
            let p = c.probabilities(&self.weights(c));
            let first = (0..p.len()).max_by(|a, b| p[*a].total_cmp(&p[*b])).unwrap_or(0);
            (first, p[first])
        };
        self.cases.iter().map(first).collect()
    }

    fn table(&self) -> Result<String, std::fmt::Error> {
        let mut table = "case,group,answer,probability,right,probability_of_right,answerable\n".to_owned();
        for (c, (first, p)) in self.cases.iter().zip(self.answers()) {
            let right = u8::from(c.right[first] && c.answerable);
            let (answer, of_right) = (&c.candidates[first].cause, c.log_score(&self.weights(c)).exp());
            let answerable = u8::from(c.answerable);
            writeln!(table, "{},{},{answer},{p:.4},{right},{of_right:.4},{answerable}", c.name, c.group)?;
        }
        Ok(table)
    }
}

/// The weights, with the score and the changed answers without each feature.
fn feature_table(cases: &[Case], ridge: f64, weights: &Weights) -> Result<String, std::fmt::Error> {
    let all = Predictions::of(cases, ridge, None);
    let (score, answers) = (all.score(), all.answers());
    let mut table = "feature,weight,score_lost_without,answers_changed_without\n".to_owned();
    for (k, name) in FEATURES.iter().enumerate() {
        let without = Predictions::of(cases, ridge, Some(k));
        let changed = without.answers().iter().zip(&answers).filter(|(a, b)| a.0 != b.0).count();
        writeln!(table, "{name},{:.4},{:.5},{changed}", weights[k], score - without.score())?;
    }
    Ok(table)
}

/// Constant and slope of the log odds of a second effect, by damped Newton steps with a small ridge.
fn fit_pairs(cases: &[Case]) -> [f64; 2] {
    let mut w = nalgebra::Vector2::zeros();
    for _ in 0..STEPS {
        let mut gradient = -0.1 * w;
        let mut hessian = nalgebra::Matrix2::identity() * 0.1;
        for (x, present) in cases.iter().flat_map(|c| &c.pairs) {
            let x = nalgebra::Vector2::new(1.0, *x);
            let p = 1.0 / (1.0 + (-w.dot(&x)).exp());
            gradient += x * (f64::from(u8::from(*present)) - p);
            hessian += x * x.transpose() * p * (1.0 - p);
        }
        let Some(step) = hessian.cholesky().map(|h| h.solve(&gradient)) else { break };
        w += step * (1.0 / step.norm().max(1.0));
    }
    [w[0], w[1]]
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [input, predictions, features, rest @ ..] = &arguments[..] else {
        return Err("expected CASES.jsonl PREDICTIONS.csv FEATURES.csv [WEIGHTS.rs]".into());
    };
    let text = std::fs::read_to_string(input)?;
    let lines = text.lines().map(serde_json::from_str).collect::<Result<Vec<Line>, _>>()?;
    let cases: Vec<Case> = lines.into_iter().map(Case::of).collect();
    let mut best: Option<(f64, Predictions<'_>)> = None;
    for ridge in RIDGES {
        let p = Predictions::of(&cases, ridge, None);
        println!("ridge {ridge}: mean log score {:.4} on unseen groups", p.score());
        if best.as_ref().is_none_or(|(_, b)| p.score() > b.score()) {
            best = Some((ridge, p));
        }
    }
    let (ridge, best) = best.ok_or("no cases")?;
    std::fs::write(predictions, best.table()?)?;
    let weights = fit(&cases.iter().collect::<Vec<_>>(), ridge, None);
    std::fs::write(features, feature_table(&cases, ridge, &weights)?)?;
    if let [file] = rest {
        std::fs::write(file, source(&weights, fit_pairs(&cases), cases.len(), ridge)?)?;
    }
    Ok(())
}

/// Source text of the weights.
fn source(w: &Weights, pairs: [f64; 2], cases: usize, ridge: f64) -> Result<String, std::fmt::Error> {
    let mut text = format!(
        "//! Weights of the verdict's features. The example `fit_verdict` writes this file.\n//!\n\
         //! They are fitted to {cases} cases, with a ridge of {ridge}.\n\n\
         /// Weights by feature. Features without a line weigh nothing.\n\
         pub(crate) const WEIGHTS: &[(&str, f64)] = &[\n"
    );
    for (name, w) in FEATURES.iter().zip(w.iter()) {
        writeln!(text, "    (\"{name}\", {w:.4}),")?;
    }
    text += "];\n\n\
             /// Constant and weight of ln(1 + gain) in the log odds that the second effect of a pair is present if the first is.\n";
    writeln!(text, "pub(crate) const PAIR_WEIGHTS: [f64; 2] = [{:.4}, {:.4}];", pairs[0], pairs[1])?;
    Ok(text)
}
