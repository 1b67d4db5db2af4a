//! Fits the weights of the verdict to cases with a known truth, and tests them on authors that the fit has not seen.
//!
//!     cargo run --release -p hysteron-diagnose --example fit_verdict -- CASES.jsonl PREDICTIONS.csv [WEIGHTS.rs]
//!
//! Each line of the first file is a case: `case`, `group` (author, or family of models), `right` (causes that are right) and
//! `evidence` of its `diagnosis.json`. A group is predicted by weights that were fitted to all others. `PREDICTIONS.csv`
//! gets the probabilities of that prediction. `WEIGHTS.rs` gets the weights fitted to all groups.

use hysteron_diagnose::VerdictEvidence;
use hysteron_diagnose::verdict_model::{CandidateFeatures, FEATURE_COUNT, FEATURES, candidates, probabilities};
use nalgebra::{SMatrix, SVector};
use serde::Deserialize;
use std::collections::BTreeSet;
use std::fmt::Write as _;

type Weights = SVector<f64, FEATURE_COUNT>;
type Hessian = SMatrix<f64, FEATURE_COUNT, FEATURE_COUNT>;

/// Ridges that cross-validation chooses from.
const RIDGES: [f64; 6] = [0.1, 0.3, 1.0, 3.0, 10.0, 30.0];
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
    evidence: VerdictEvidence,
}

/// A case with the features of its candidates.
struct Case {
    name: String,
    group: String,
    candidates: Vec<CandidateFeatures>,
    /// Candidates that are right; `unknown` if the right cause is no candidate.
    right: Vec<bool>,
    /// True if the right cause is a candidate.
    answerable: bool,
}

impl Case {
    fn of(line: Line) -> Self {
        let all = candidates(&line.evidence);
        let right: Vec<bool> = all.iter().map(|c| line.right.contains(&c.cause)).collect();
        let answerable = right.contains(&true);
        let right = if answerable { right } else { all.iter().map(|c| c.cause == "unknown").collect() };
        Self { name: line.case, group: line.group, candidates: all, right, answerable }
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
            *gradient += x * (target - p[i]);
            *hessian += x * x.transpose() * p[i];
            mean += x * p[i];
        }
        *hessian -= mean * mean.transpose();
    }
}

/// Weights with the largest sum of log scores less the ridge's half square, by damped Newton steps.
fn fit(cases: &[&Case], ridge: f64) -> Weights {
    let objective = |w: &Weights| cases.iter().map(|c| c.log_score(w)).sum::<f64>() - 0.5 * ridge * w.norm_squared();
    let mut w = Weights::zeros();
    let mut value = objective(&w);
    for _ in 0..STEPS {
        let (mut gradient, mut hessian) = (-w * ridge, Hessian::identity() * ridge);
        cases.iter().for_each(|c| c.derivatives(&w, &mut gradient, &mut hessian));
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
fn cross_validated(cases: &[Case], ridge: f64) -> Vec<(String, Weights)> {
    let groups: BTreeSet<&String> = cases.iter().map(|c| &c.group).collect();
    let without = |g: &String| fit(&cases.iter().filter(|c| c.group != *g).collect::<Vec<_>>(), ridge);
    groups.into_iter().map(|g| (g.clone(), without(g))).collect()
}

fn weights_of<'a>(all: &'a [(String, Weights)], case: &Case) -> Option<&'a Weights> {
    all.iter().find(|(g, _)| *g == case.group).map(|(_, w)| w)
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [input, predictions, rest @ ..] = &arguments[..] else {
        return Err("expected CASES.jsonl PREDICTIONS.csv [WEIGHTS.rs]".into());
    };
    let text = std::fs::read_to_string(input)?;
    let lines = text.lines().map(serde_json::from_str).collect::<Result<Vec<Line>, _>>()?;
    let cases: Vec<Case> = lines.into_iter().map(Case::of).collect();
    let mut best: Option<(f64, f64, Vec<(String, Weights)>)> = None;
    for ridge in RIDGES {
        let by_group = cross_validated(&cases, ridge);
        let score: f64 = cases.iter().filter_map(|c| Some(c.log_score(weights_of(&by_group, c)?))).sum();
        println!("ridge {ridge}: mean log score {:.4} on unseen groups", score / cases.len() as f64);
        if best.as_ref().is_none_or(|b| score > b.0) {
            best = Some((score, ridge, by_group));
        }
    }
    let (_, ridge, by_group) = best.ok_or("no cases")?;
    let mut table = "case,group,answer,probability,right,probability_of_right,answerable\n".to_owned();
    for c in &cases {
        let p = c.probabilities(weights_of(&by_group, c).ok_or("a case without a group")?);
        let first = (0..p.len()).max_by(|a, b| p[*a].total_cmp(&p[*b])).ok_or("a case without candidates")?;
        let of_right: f64 = p.iter().zip(&c.right).filter(|(_, r)| **r).map(|(p, _)| p).sum();
        let right = u8::from(c.right[first] && c.answerable);
        let answer = &c.candidates[first].cause;
        writeln!(
            table,
            "{},{},{answer},{:.4},{right},{of_right:.4},{}",
            c.name,
            c.group,
            p[first],
            u8::from(c.answerable)
        )?;
    }
    std::fs::write(predictions, table)?;
    if let [weights] = rest {
        std::fs::write(weights, source(&fit(&cases.iter().collect::<Vec<_>>(), ridge), cases.len(), ridge)?)?;
    }
    Ok(())
}

/// Source text of the weights.
fn source(w: &Weights, cases: usize, ridge: f64) -> Result<String, std::fmt::Error> {
    let mut text = format!(
        "//! Weights of the verdict's features. The example `fit_verdict` writes this file.\n//!\n\
         //! They are fitted to {cases} cases, with a ridge of {ridge}.\n\n\
         use super::verdict_model::FEATURE_COUNT;\n\n\
         /// Weights in the order of [`super::verdict_model::FEATURES`].\n\
         pub(crate) const WEIGHTS: [f64; FEATURE_COUNT] = [\n"
    );
    for (name, w) in FEATURES.iter().zip(w.iter()) {
        writeln!(text, "    {w:.4}, // {name}")?;
    }
    text += "];\n";
    Ok(text)
}
