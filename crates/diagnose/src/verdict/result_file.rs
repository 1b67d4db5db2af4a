//! `diagnosis.json`.

use crate::candidate::sensor_fault::Correction;
use crate::evidence::parametric_bootstrap::Bootstrap;
use serde::Serialize;
use std::collections::BTreeMap;

/// All that was found.
#[derive(Clone, Debug, Serialize)]
pub struct Outcome {
    /// The user's model, fitted by least squares.
    pub baseline: Baseline,
    /// Where it differs from the recordings.
    pub mismatch: Vec<Mismatch>,
    /// What was left out.
    pub verdict: Verdict,
    /// The repaired model.
    pub corrected: Corrected,
    /// Part of the baseline's squared error that the repaired model leaves.
    pub unexplained_share: f64,
    /// What the weighing says of recordings of which the truth is known.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bootstrap: Option<Bootstrap>,
    /// The test that would tell more.
    pub next_test: String,
}

/// The fitted user's model.
#[derive(Clone, Debug, Serialize)]
pub struct Baseline {
    /// Mean NMSE over channels and runs that were fitted.
    pub fit_nmse: f64,
    /// The same of those that were held out; none where there are none.
    pub holdout_nmse: Option<f64>,
    /// Fitted parameters.
    pub parameters: BTreeMap<String, f64>,
}

/// A channel in a run.
#[derive(Clone, Debug, Serialize)]
pub struct Mismatch {
    /// Run.
    pub run: String,
    /// Column of the recording.
    pub channel: String,
    /// What it hangs on.
    pub at: String,
    /// Seconds of the recording.
    pub windows: Vec<[f64; 2]>,
    /// Part of the squared error in them.
    pub share: f64,
    /// What the motion is like there.
    pub regime: String,
}

/// A cause with its probability.
#[derive(Clone, Debug, Serialize)]
pub struct Candidate {
    /// Cause.
    pub cause: String,
    /// Probability.
    pub confidence: f64,
}

/// What was left out.
#[derive(Clone, Debug, Serialize)]
pub struct Verdict {
    /// Cause.
    pub cause: String,
    /// Probability.
    pub confidence: f64,
    /// A second effect beside it.
    pub also: Vec<String>,
    /// What else it may be.
    pub also_possible: Vec<Candidate>,
    /// In words.
    pub explanation: String,
}

/// The repaired model.
#[derive(Clone, Debug, Serialize)]
pub struct Corrected {
    /// Its file.
    pub script: String,
    /// Parameters of the user and those added.
    pub parameters: BTreeMap<String, f64>,
    /// Mean NMSE of what was fitted.
    pub fit_nmse: f64,
    /// The same of what was held out.
    pub holdout_nmse: Option<f64>,
    /// Faults of channels.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub channels: Vec<Correction>,
}
