//! A learned law from a study, without a diagnosis.

use super::learned::{parts, proposal, statement};
use crate::candidate::repaired_script::repaired_script;
use crate::candidate::variant::Variant;
use crate::evidence::holdout::holdout_nmse;
use crate::evidence::memory_evidence::ModelRuns;
use crate::fit::baseline::fit_baseline;
use crate::fit::evaluator_pool::EvaluatorPool;
use crate::fit::scheduler::{ProgressMonitor, Scheduler};
use crate::inspect::conditions::lacks_clock;
use crate::inspect::probe::{inspect_model, record_responses};
use crate::memory::learning::{Learned, learn};
use crate::prior::{MIN_LEARNED_GAIN, NOISE_RATIO};
use crate::verdict::diagnosis::Settings;
use hysteron_identify::study::{InitialRun, Role, ScoredRun, ScriptSimulator, simulate_and_score};
use hysteron_opensees::law_to_json;
use std::sync::Arc;

/// A learned law of a study.
#[derive(Clone, Debug)]
pub struct LearnedStudy {
    /// Channel of the force that was learned.
    pub channel: String,
    /// The law with its errors.
    pub learned: Learned,
    /// The law as JSON.
    pub json: String,
    /// Its parts and factors in words, one a line.
    pub parts: Vec<String>,
    /// Its kinds of memory in words.
    pub statement: String,
    /// The script with the law in it; none where the channel is not the force of one element.
    pub script: Option<String>,
    /// Mean NMSE of the runs held out of the script as it was and with the law, both by the engine.
    pub simulated: Option<[f64; 2]>,
    /// Noise of the runs held out, or else of the fitted ones, mean NMSE.
    pub noise: Option<f64>,
}

/// Learns a law from the runs of a study whose script has been opened.
///
/// # Errors
/// The model has no result, no channel shows the force of a device under an imposed motion, or the user cancelled.
pub fn learn_law(
    simulator: &ScriptSimulator,
    initial_run: &InitialRun,
    text: &str,
    settings: &Settings,
    monitor: &mut dyn ProgressMonitor,
) -> Result<LearnedStudy, String> {
    let study = simulator.study().clone();
    let factory = simulator.factory();
    let pool = EvaluatorPool::new(factory.clone(), settings.threads).map_err(|e| e.to_string())?;
    let mut scheduler = Scheduler::new(study.clone(), pool, monitor, vec![]);
    let baseline = fit_baseline(&mut scheduler, initial_run, text)?;
    let values = &baseline.fitted.values;
    let inspected = inspect_model(&factory, &study, text, values);
    let (point, inventory) = inspected.ok_or("the script makes no analysis")?;
    let inventory = inventory.with_lone_dashpots();
    let has_clock = settings.counted_times_are_seconds || inventory.base_excited || !lacks_clock(&study);
    let responses =
        [Role::Fit, Role::Holdout].map(|r| record_responses(&factory, &study, text, values, &point, &inventory, r));
    let mut script_simulator = factory.simulator_of_script(study.clone(), text);
    let fit = |run: usize| simulate_and_score(&mut script_simulator, &study, run, values).ok();
    let fits: Vec<Option<ScoredRun>> = (0..study.runs.len()).map(fit).collect();
    let runs = ModelRuns {
        study: &study,
        fits: &fits,
        responses: [&responses[0], &responses[1]],
        imposed_motion: !inventory.base_excited,
        has_clock,
        lone_device: false,
    };
    let device = runs.learnable_runs().ok_or(
        "no channel shows the force of a device along one direction under an imposed motion, so that there is nothing to learn from",
    )?;
    let noise = runs.noise(Role::Holdout).or_else(|| runs.noise(Role::Fit));
    let learned = learn(device.runs.clone(), has_clock).ok_or("the runs do not suffice for a law")?;
    let variant = proposal(&study, &device, &learned)
        .and_then(|p| Variant::baseline(&study, text).with_proposal(&point, &p))
        .map(Arc::new);
    let script = variant.as_ref().map(|v| repaired_script(text, &initial_run.value_spans, &point, v, values));
    let simulated = variant.and_then(|v| {
        let mut with_law = v.simulator(&factory);
        let after: Vec<Option<ScoredRun>> =
            (0..study.runs.len()).map(|r| simulate_and_score(&mut with_law, &study, r, values).ok()).collect();
        Some([holdout_nmse(&study, &fits)?, holdout_nmse(&study, &after)?])
    });
    Ok(LearnedStudy {
        channel: device.channel,
        json: law_to_json(&learned.law) + "\n",
        parts: parts(&learned.law),
        statement: statement(&learned),
        script,
        simulated,
        noise,
        learned,
    })
}

impl LearnedStudy {
    /// Returns true if the runs held out lose enough of the error for the law to be used, or if none is held out.
    pub fn is_worth_writing(&self) -> bool {
        let both = self.learned.user_held_out.zip(self.learned.held_out);
        both.is_none_or(|(before, after)| after <= (1.0 - MIN_LEARNED_GAIN) * before)
    }

    /// Worth of the law in words: one sentence each.
    pub fn remarks(&self) -> Vec<String> {
        let l = &self.learned;
        let mut out = vec![];
        match (l.user_held_out, l.held_out) {
            (Some(before), Some(after)) if !self.is_worth_writing() => out.push(format!(
                "Of the runs held out it leaves {after:.2e} in place of {before:.2e}: it gains too little to be used."
            )),
            (Some(_), Some(_)) => {}
            _ => out.push("No run is held out, so that nothing shows whether the law predicts.".into()),
        }
        if let (Some(noise), Some(after)) = (self.noise, l.held_out) {
            let is_reached = after <= NOISE_RATIO * noise;
            let reaches = if is_reached { format!("at most {NOISE_RATIO} times") } else { "not down to".into() };
            out.push(format!("Its error is {reaches} the noise of {noise:.2e}."));
        }
        if l.outside > 0.0 {
            out.push(format!("{:.1} % of the steps of the runs held out lie outside its range.", 100.0 * l.outside));
        }
        out.push("It predicts within the range of its runs and explains nothing by itself.".into());
        out
    }
}
