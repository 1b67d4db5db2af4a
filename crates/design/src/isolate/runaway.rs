//! Analyses that are no result of their motion: bearings far beyond the equivalent lateral force procedure, or an end before
//! the motion's.

use super::BOUNDS;
use super::job::Job;
use super::outcome::JobOutcome;
use super::procedures::procedures;
use super::study::Study;

/// Displacement over D_M of the same bound, beyond which the model or the motion is wrong. Near-fault motions and torsion reach
/// twice D_M; a wrong unit, a lost restoring force or a bearing without strength reach any number.
const RUNAWAY: f64 = 3.0;

/// Place of the nominal properties among the bounds.
const NOMINAL: usize = 1;

/// Description of an analysis of a suite whose displacement cannot be believed, with what to look at.
pub fn runaway(study: &Study, outcome: &JobOutcome) -> Option<String> {
    // A draw of the properties is nearest to the nominal ones.
    let bound = BOUNDS.iter().position(|b| *b == outcome.bound).unwrap_or(NOMINAL);
    let expected = procedures(study).into_iter().nth(bound)?.ok()?;
    let bearing = outcome.bearings.iter().max_by(|a, b| a.displacement.total_cmp(&b.displacement))?;
    if bearing.displacement <= RUNAWAY * expected.displacement {
        return None;
    }
    let length = &study.units[1];
    Some(format!(
        "bearing {} moves {:.4} {length} under {} ({} bound), {:.1} times the {:.4} {length} of the equivalent lateral force \
         procedure: the suite was stopped. Look at the unit and the factor of the motion, at the target, and at the loop of \
         the bearing",
        bearing.tag,
        bearing.displacement,
        outcome.motion,
        outcome.bound,
        bearing.displacement / expected.displacement,
        expected.displacement,
    ))
}

/// Share of the energy of a motion that an analysis has to follow.
const FOLLOWED: f64 = 0.95;

/// Description of an analysis that ends long before its motion, which the script has cut short.
pub fn cut_short(study: &Study, job: &Job, outcome: &JobOutcome) -> Option<String> {
    let pair = &study.motions[job.motion];
    let dt = pair.components[0].dt;
    let energy = |k: usize| pair.components.iter().map(|c| c.acceleration[k].powi(2)).sum::<f64>();
    let count = pair.components[0].acceleration.len();
    let whole: f64 = (0..count).map(energy).sum();
    let mut sum = 0.0;
    let most = (0..count).find(|k| {
        sum += energy(*k);
        sum >= FOLLOWED * whole
    })? as f64
        * dt;
    // One step may be missing.
    if !outcome.failure.is_empty() || outcome.duration >= most - dt {
        return None;
    }
    Some(format!(
        "the analysis of {} ({} bound) lasts {:.4} s, but the motion has {} % of its energy after {most:.4} s and ends after {:.4} s: \
         the suite was stopped. Look at the number of steps in \"{}\": isolate(points) and isolate(dt) are those of the motion",
        outcome.motion,
        outcome.bound,
        outcome.duration,
        100.0 * FOLLOWED,
        count as f64 * dt,
        study.script.display()
    ))
}
