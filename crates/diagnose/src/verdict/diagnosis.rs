//! The way from a study to a verdict.

use crate::evidence::probabilities::leaves_structure;
use crate::fit::checkpoint::Kept;
use crate::fit::evaluator::Bench;
use crate::fit::scheduler::Work;
use crate::fit::screening::{
    best_of_causes, first_round, fit_baseline, made_again, of_so_many_causes, poor, refine, refit, twins, weigh,
    within_reach,
};
use crate::fit::step_error::step_error;
use crate::fit::two_effect_search::pairs;
use crate::hypothesis::{self, Proposal, Sight};
use crate::inspect::conditions::untimed;
use crate::inspect::probe;
use crate::residual::drift::may_be_noise;
use crate::verdict::conclusion::{Context, conclude};
use crate::verdict::discriminating_test::NextTest;
use crate::verdict::result_file::Outcome;
use hysteron_identify::calibrate::Displacements;
use hysteron_identify::study::{Fit, Opening, ScriptSimulator};

/// Causes that go into the last round.
const FINALISTS: usize = 8;

/// What is asked for.
#[derive(Clone, Debug, Default)]
pub struct Settings {
    /// Causes that are left out of the library.
    pub without: Vec<String>,
    /// Times that count by one are seconds, and not samples.
    pub clock: bool,
    /// Number of threads.
    pub threads: usize,
    /// What an interrupted diagnosis of the same study and library kept.
    pub earlier: Vec<Kept>,
}

/// Who wants to know how far it has come.
pub trait Watch {
    /// A stage has come so far.
    fn stage(&mut self, what: &str, done: usize, of: usize);
    /// Whether to stop.
    fn stopped(&self) -> bool;
    /// What has been worked out so far, for whoever goes on after an interruption.
    fn keep(&mut self, kept: &[Kept]);
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
    /// What forces are plotted over.
    pub displacements: Displacements,
    /// The test that would tell more, where one can be made from the motions of the study.
    pub next_test: Option<NextTest>,
    /// How many sets of values the fitted runs were looked at for.
    pub looks: usize,
    /// Part of the residual of the best explanation that has structure which no noise has, and which structure.
    pub left: (f64, String),
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
    let mut work = Work { study: study.clone(), bench, watch, earlier: settings.earlier.clone(), jobs: 0 };

    let baseline = fit_baseline(&mut work, opening, text)?;
    // A fit that tells little says little of how stiff things are: the user's own values do.
    let values = if poor(&baseline) { opening.values.clone() } else { baseline.fitted.values.clone() };
    let Some((place, anatomy)) = probe::look(&blueprint, &study, text, &values) else {
        return Err("the script makes no analysis".into());
    };
    let scales = probe::watch(&blueprint, &study, text, &values, &place, &anatomy);
    let clock = settings.clock || anatomy.shaken || !untimed(&study);
    let sight = Sight { anatomy: &anatomy, study: &study, scales: &scales, fits: &baseline.fitted.fits, clock };
    let library = hypothesis::ALL.iter().filter(|h| !settings.without.iter().any(|w| w == h.cause));
    let (untimed, library): (Vec<_>, Vec<_>) = library.partition(|h| !clock && h.needs_clock);
    let proposals: Vec<Proposal> = library.iter().flat_map(|h| h.proposals(&sight)).collect();
    let untimed = untimed.iter().map(|h| h.cause).collect();

    let physics = proposals.iter().filter(|p| !p.block.is_empty()).count();
    let wide = poor(&baseline) && within_reach(&study, physics);
    let too_long = poor(&baseline) && !wide;
    let mut first = first_round(&mut work, &baseline, opening, &place, &proposals, wide)?;
    twins(&mut work, &baseline, &mut first)?;
    let best = best_of_causes(&first);
    let finalists = of_so_many_causes(&best, FINALISTS);
    let likeliest = first.first().filter(|e| e.score() < baseline.score());
    let steps = step_error(&mut work, &baseline, likeliest)?;
    work.bench.refine(steps.parts);
    let as_written = baseline.clone();
    let baseline = if steps.parts > 1 { refit(&mut work, &baseline)? } else { baseline };
    let mut weighed = refine(&mut work, "the likeliest of them", finalists)?;
    weighed.push(baseline.clone());
    weighed.retain(|e| !may_be_noise(&study, e));
    work.hold_back("what it predicts", &mut weighed)?;
    weigh(&mut weighed)?;
    // Where nothing is missing, no two things are; where no effect alone tells more than nothing, two may.
    let missing = weighed[0].cause() != "none" || leaves_structure(&study, &scales, &weighed[0]);
    let mut two = if missing { pairs(&mut work, &baseline, &weighed, &first, &place)? } else { vec![] };
    two.retain(|e| !may_be_noise(&study, e));
    if !two.is_empty() {
        weighed.extend(two);
        weigh(&mut weighed)?;
    }
    let bootstrap = made_again(&mut work, &weighed, &best)?;
    let imposed = !anatomy.shaken;
    let scales = &scales;
    let context = Context {
        study: &study,
        simulator,
        opening,
        text,
        place: &place,
        scales,
        imposed,
        steps,
        untimed,
        too_long,
        bootstrap,
    };
    conclude(&mut work, &context, &as_written, weighed)
}
