//! `diagnosis.json`. Field names are those of the file.

use super::learned::LearnedModel;
use super::residual_force::ResidualForce;
use super::summary::Summary;
use crate::candidate::channel_fault::ChannelFault;
use crate::evidence::parametric_bootstrap::BootstrapResult;
use crate::evidence::verdict_evidence::VerdictEvidence;
use crate::prior::PriorNumber;
use hysteron_identify::preflight::Preflight;
use serde::Serialize;
use std::collections::BTreeMap;

/// Content of the file.
#[derive(Clone, Debug, Serialize)]
pub struct Outcome {
    /// Title of the study, or its script if it has none.
    pub study: String,
    /// The user's model, fitted by least squares.
    pub baseline: Baseline,
    /// Channels in which it differs from the recordings, the largest error first.
    pub mismatch: Vec<Mismatch>,
    /// Forces that it lacks, by place and run, where the cause is unknown; the largest against the recorded force first.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub residual_forces: Vec<ResidualForce>,
    /// The verdict.
    pub verdict: Verdict,
    /// The repaired model.
    pub corrected: RepairedModel,
    /// Share of the baseline's squared error that the repaired model leaves.
    pub unexplained_share: f64,
    /// Ranking on simulated recordings whose cause is known.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bootstrap: Option<BootstrapResult>,
    /// Numbers that the verdict weighs.
    pub evidence: VerdictEvidence,
    /// Numbers that the verdict depends on, besides the fitted weights.
    pub prior: BTreeMap<&'static str, PriorNumber>,
    /// Fitted weights of the evidence, by feature.
    pub weights: BTreeMap<&'static str, f64>,
    /// Recommended next test, in words.
    pub next_test: String,
    /// Channels that no edit of the script changes, so that nothing can be learned from them.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub unmoved_channels: Vec<UnmovedChannel>,
    /// The learned law that the repaired model has.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub learned: Option<LearnedModel>,
    /// Checks of the channels before the fit.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub preflight: Option<Preflight>,
}

/// A channel with an error that no edit of the script changes.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct UnmovedChannel {
    /// Column of the recording.
    pub channel: String,
    /// Recommended recorder, in words.
    pub record_instead: String,
}

/// The fitted user's model.
#[derive(Clone, Debug, Serialize)]
pub struct Baseline {
    /// Mean NMSE over fitted channels and runs.
    pub fit_nmse: f64,
    /// Mean NMSE over runs held out; none without such runs.
    pub holdout_nmse: Option<f64>,
    /// Fitted values by parameter.
    pub parameters: BTreeMap<String, f64>,
}

/// Error of the baseline in one channel of a run.
#[derive(Clone, Debug, Serialize)]
pub struct Mismatch {
    /// Name of the run.
    pub run: String,
    /// Column of the recording.
    pub channel: String,
    /// Place of the sensor.
    pub at: String,
    /// Windows of the recording with most of the error, s.
    pub windows: Vec<[f64; 2]>,
    /// Share of the squared error within them.
    pub share: f64,
    /// The motion within them, in words.
    pub regime: String,
}

/// A cause with its probability.
#[derive(Clone, Debug, Serialize)]
pub struct Candidate {
    /// The cause.
    pub cause: String,
    /// Its probability.
    pub confidence: f64,
}

/// The most probable cause.
#[derive(Clone, Debug, Serialize)]
pub struct Verdict {
    /// The cause; `none` for a complete model, `unknown` for a cause outside the library.
    pub cause: String,
    /// Its probability.
    pub confidence: f64,
    /// Cause of a second effect.
    pub also: Vec<String>,
    /// Other possible causes, the most probable first.
    pub also_possible: Vec<Candidate>,
    /// Probability that each effect is present, alone or beside another, the most probable first.
    pub effects: Vec<Candidate>,
    /// The most probable cause by Bayes' rule from the log evidences alone. That rule takes one of the hypotheses for true.
    pub bayes: Candidate,
    /// The verdict in words, for readers who know the statistics.
    pub explanation: String,
    /// The verdict in words, part by part.
    pub summary: Summary,
}

/// The repaired model.
#[derive(Clone, Debug, Serialize)]
pub struct RepairedModel {
    /// File of its script.
    pub script: String,
    /// File of the same script in OpenSees' standard commands; none if they cannot say the same.
    pub opensees: Option<String>,
    /// Reason why there is no such file.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub opensees_reason: Option<String>,
    /// Values of the user's and the added parameters.
    pub parameters: BTreeMap<String, f64>,
    /// Names of the user's parameters that the repaired model no longer uses.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub unused: Vec<String>,
    /// Mean NMSE over fitted channels and runs.
    pub fit_nmse: f64,
    /// Mean NMSE over runs held out; none without such runs.
    pub holdout_nmse: Option<f64>,
    /// Faults of channels.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub channels: Vec<ChannelFault>,
}
