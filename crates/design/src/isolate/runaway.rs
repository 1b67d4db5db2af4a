//! An analysis whose bearings move far beyond the equivalent lateral force procedure.

use super::BOUNDS;
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
