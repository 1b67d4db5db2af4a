//! The script at its bounds and eccentricities beside that of nominal properties.

use super::agreement::{NEGLIGIBLE, place};
use super::script_model::ScriptModel;
use super::study::Study;
use crate::mistake::{Mistake, key};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// Difference of the factors of a bound that the script's bearings show, at most: a law need not be linear in them.
const FACTOR: f64 = 0.05;
/// Change of masses and loads by a bound, as a share, at most.
const UNCHANGED: f64 = 0.01;
/// Change of a bearing's axial force under gravity by an accidental eccentricity, as a share of the mean, at most.
const MOVED_GRAVITY: f64 = 0.01;
/// Movement of the center of mass over eccentricity times plan, at least and at most.
const MOVED_MASS: [f64; 2] = [0.5, 2.0];

/// The factors of the bounds arrive in the script's bearings.
///
/// # Errors
/// They do not, or another part of the model changes with the bound.
pub(super) fn compare_bounds(
    study: &Study,
    nominal: &ScriptModel,
    [amplitude, period]: [f64; 2],
    stop: &Arc<AtomicBool>,
) -> Result<(), Mistake> {
    for bound in ["lower", "upper"] {
        let model = ScriptModel::new(study, bound, 0, stop)?;
        let parts = [
            ("mass above the bearings", nominal.mass_above(), model.mass_above()),
            ("load of gravity on the bearings", nominal.gravity(), model.gravity()),
        ];
        for (what, before, after) in parts {
            if (after / before - 1.0).abs() > UNCHANGED {
                let message = format!(
                    "the {bound} bound of \"{}\" changes the {what} from {before:.6} to {after:.6}: expected the same. A bound changes \
                     properties of bearings alone",
                    study.script.display()
                );
                return Err(Mistake::new(key!["script"], message));
            }
        }
        for (kind, b) in study.bearings.iter().enumerate() {
            let tests = [nominal, &model].map(|m| m.typical(kind).map(|t| m.test(t, amplitude, period)));
            let [Some(Ok(before)), Some(Ok(after))] = tests else { continue };
            let stiffness = before.k_d + before.q_d / amplitude;
            let parts = [
                ("Q", before.q_d, after.q_d, NEGLIGIBLE * stiffness * amplitude),
                ("K", before.k_d, after.k_d, NEGLIGIBLE * stiffness),
            ];
            for (of, (letter, before, after, least)) in parts.into_iter().enumerate() {
                let (asked, found) = (study.factor(b, bound, of), after / before);
                if before > least && (found / asked - 1.0).abs() > FACTOR {
                    let message = format!(
                        "the {bound} bound asks for {asked:.4} times the nominal {letter}_d of {}, but the bearings of the \
                         script have {found:.4} times ({}): does it use isolate({letter},{})?",
                        b.name,
                        model.typical(kind).map_or(String::new(), |t| place(study, t)),
                        b.name
                    );
                    return Err(Mistake::new(key!["bearing", kind, bound], message));
                }
            }
        }
    }
    Ok(())
}

/// An accidental eccentricity moves mass, never gravity.
///
/// # Errors
/// It moves gravity, or mass by another distance.
pub(super) fn compare_eccentricities(
    study: &Study,
    first: &ScriptModel,
    stop: &Arc<AtomicBool>,
) -> Result<(), Mistake> {
    let mean = first.gravity() / first.bearings.len() as f64;
    for (k, [x, y]) in study.eccentricities.iter().enumerate().skip(1) {
        let model = ScriptModel::new(study, "nominal", k, stop)?;
        moved_mass(study, first, &model, [*x, *y])?;
        for (before, after) in first.bearings.iter().zip(&model.bearings) {
            if (after.gravity - before.gravity).abs() > MOVED_GRAVITY * mean {
                let message = format!(
                    "the eccentricity {x} {y} changes the load of gravity on a bearing from {:.6} to {:.6} ({}): expected the \
                     same. An accidental eccentricity moves mass, never gravity: keep the loads where they are without it",
                    before.gravity,
                    after.gravity,
                    place(study, after)
                );
                return Err(Mistake::new(key!["eccentricities"], message));
            }
        }
    }
    Ok(())
}

/// The center of mass moves by the change of the eccentricity times the plan. Without a plan the grid of the bearings stands for it.
fn moved_mass(study: &Study, first: &ScriptModel, model: &ScriptModel, to: [f64; 2]) -> Result<(), Mistake> {
    let (Some(before), Some(after)) = (first.center_of_mass(), model.center_of_mass()) else { return Ok(()) };
    let Some(plan) = study.plan.or_else(|| first.grid()) else { return Ok(()) };
    for (axis, name) in ["x", "y"].into_iter().enumerate() {
        let asked = (to[axis] - study.eccentricities[0][axis]) * plan[axis];
        let found = after[axis] - before[axis];
        if asked != 0.0 && !(MOVED_MASS[0]..=MOVED_MASS[1]).contains(&(found / asked)) {
            let message = format!(
                "the eccentricity {} {} asks for the center of mass to move by {asked:.6} in {name}, but in \"{}\" it moves by \
                 {found:.6}: does it use isolate(e{name})?",
                to[0],
                to[1],
                study.script.display()
            );
            return Err(Mistake::new(key!["eccentricities"], message));
        }
    }
    Ok(())
}
