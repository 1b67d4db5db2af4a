//! The excitation of a script beside the motions of a study.

use super::before_transient::run_job_to_transient;
use super::job::Job;
use super::script_model::ScriptModel;
use super::study::Study;
use crate::mistake::{Mistake, key};
use hysteron_engine::model::{Model, Pattern, PatternKind};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// Difference of the ground's accelerations from those of the study, as a share of the peak, at most.
const MOTION: f64 = 1.0e-3;
/// Root of the mean square of a support's accelerations over that of the study, at least and at most. Scripts integrate
/// accelerations to displacements by different rules.
const STRENGTH: [f64; 2] = [0.9, 1.1];
/// Correlation of a support's accelerations with those of the study at the delay of their peaks, at least.
const CORRELATION: f64 = 0.95;
/// Factor on the motion with which the script runs once more where it has no ground motion.
const STRONGER: f64 = 2.0;
/// Times at which loads are compared, as a number of steps of the motion.
const TIMES: usize = 2000;

/// The ground of the script moves as the motion that the study gives it.
///
/// # Errors
/// It moves otherwise, or nothing in the script depends on the motion. The message has both, or what is missing.
pub(super) fn compare(study: &mut Study, model: &ScriptModel, stop: &Arc<AtomicBool>) -> Result<(), Mistake> {
    let patterns = || model.model().patterns.values().filter(|p| p.held.is_none());
    if patterns().any(|p| matches!(p.kind, PatternKind::Uniform(_))) {
        return uniform(study, model);
    }
    if patterns().any(|p| p.motions.iter().any(|m| m.ground.is_some())) {
        return supports(study, model);
    }
    if !follows_the_motion(study, model, stop)? {
        let message = format!(
            "the motions cannot be applied, since nothing in \"{}\" depends on isolate(ax) before its first transient analysis: \
             it has no pattern UniformExcitation, no MultipleSupport, and no load or displacement that changes with the motion. \
             Expected, for each direction: timeSeries Path 2 -dt $isolate(dt) -values $isolate(ax); \
             pattern UniformExcitation 2 1 -accel 2",
            study.script.display()
        );
        return Err(Mistake::new(key!["script"], message));
    }
    study.agreement.remarks.push(
        "the script applies the motions by loads or displacements of a pattern Plain: what it does with them was not compared"
            .into(),
    );
    Ok(())
}

/// Each component is applied once by the patterns UniformExcitation.
fn uniform(study: &Study, model: &ScriptModel) -> Result<(), Mistake> {
    let pair = &study.motions[0];
    let [x, y] = &pair.components;
    // A path may end before its last point.
    let points = x.acceleration.len() - 1;
    let patterns: Vec<_> = model
        .model()
        .patterns
        .values()
        .filter_map(|p| match &p.kind {
            PatternKind::Uniform(e) if p.held.is_none() => Some((p, e)),
            _ => None,
        })
        .collect();
    let horizontal = model.dimensions().saturating_sub(1);
    let meter = study.meter();
    let peak = |values: &[f64]| values.iter().fold(0.0f64, |m, v| m.max(v.abs()));
    let whole = meter * peak(&x.acceleration).max(peak(&y.acceleration));
    for direction in 0..model.dimensions() {
        let of_study: Option<&[f64]> = match direction {
            d if d < horizontal => Some(&pair.components[d.min(1)].acceleration),
            _ => pair.vertical.as_ref().map(|m| m.acceleration.as_slice()),
        };
        let expected: Vec<f64> = (0..points).map(|k| of_study.map_or(0.0, |a| meter * a[k])).collect();
        let applied = |k: usize| -> f64 {
            let along = patterns.iter().filter(|(_, e)| e.direction == direction);
            along.map(|(p, e)| e.influence * p.factor(k as f64 * x.dt)).sum()
        };
        let applied: Vec<f64> = (0..points).map(applied).collect();
        let differs = expected.iter().zip(&applied).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        if differs > MOTION * whole {
            let axis = ["x", "y", "z"][if direction < horizontal { direction } else { 2 }];
            let [stated_peak, applied_peak] = [peak(&expected), peak(&applied)];
            let message = format!(
                "the motion \"{}\" has a peak of {stated_peak:.6} in {axis} (isolate(a{axis}), isolate(dt)), but the ground of \
                 \"{}\" has {applied_peak:.6} there, and differs by up to {differs:.6}: ratio {:.4}. Each component is to be \
                 applied once, in its direction, with its step and without a factor",
                x.name,
                study.script.display(),
                applied_peak / stated_peak
            );
            return Err(Mistake::new(key!["motion", 0], message));
        }
    }
    Ok(())
}

/// Second differences over the square of the step: accelerations of displacements, smoothed as those of the other side.
fn accelerations(displacements: &[f64], dt: f64) -> Vec<f64> {
    displacements.windows(3).map(|w| (w[2] - 2.0 * w[1] + w[0]) / (dt * dt)).collect()
}

/// Displacements of accelerations that are linear between samples.
fn displacements(accelerations: impl Iterator<Item = f64>, dt: f64) -> Vec<f64> {
    let (mut u, mut v, mut last) = (0.0, 0.0, None);
    let step = |a: f64| {
        if let Some(before) = last.replace(a) {
            u += dt * v + dt * dt * (2.0 * before + a) / 6.0;
            v += 0.5 * dt * (before + a);
        }
        u
    };
    accelerations.map(step).collect()
}

fn strength(values: &[f64]) -> f64 {
    values.iter().map(|v| v * v).sum::<f64>().sqrt()
}

/// Place of the largest magnitude.
fn peak_at(values: &[f64]) -> usize {
    (0..values.len()).max_by(|i, j| values[*i].abs().total_cmp(&values[*j].abs())).unwrap_or(0)
}

/// Correlation of two histories at the delay of their peaks.
fn correlation(a: &[f64], b: &[f64]) -> f64 {
    let delay = peak_at(b) as i64 - peak_at(a) as i64;
    let at = |i: usize| usize::try_from(i as i64 + delay).ok().and_then(|j| b.get(j)).copied().unwrap_or(0.0);
    let product: f64 = a.iter().enumerate().map(|(i, x)| x * at(i)).sum();
    product / (strength(a) * strength(b))
}

/// A support in each direction follows the motion, which may arrive later there. Supports that move otherwise are said.
fn supports(study: &mut Study, model: &ScriptModel) -> Result<(), Mistake> {
    let pair = &study.motions[0];
    let dt = pair.components[0].dt;
    let horizontal = model.dimensions().saturating_sub(1);
    let meter = study.meter();
    let script = study.script.display();
    let grounds = |direction: usize| {
        let all = model.model().patterns.values().filter(|p| p.held.is_none()).flat_map(|p| &p.motions);
        all.filter(move |m| m.dof == direction).filter_map(|m| Some((m.node, m.ground.as_ref()?)))
    };
    let of_study = |direction: usize| match direction {
        d if d < horizontal => Some(&pair.components[d.min(1)].acceleration),
        _ => pair.vertical.as_ref().map(|m| &m.acceleration),
    };
    let expected = |direction: usize| {
        let a = of_study(direction).map(|a| displacements(a.iter().map(|x| meter * x), dt));
        accelerations(&a.unwrap_or_default(), dt)
    };
    let whole = (0..horizontal).map(|d| strength(&expected(d))).fold(0.0, f64::max);
    let mut remarks = vec![];
    for direction in 0..model.dimensions() {
        let expected = expected(direction);
        let asked = strength(&expected);
        let axis = ["x", "y", "z"][if direction < horizontal { direction } else { 2 }];
        if asked > MOTION * whole && grounds(direction).next().is_none() {
            let message = format!(
                "the motion \"{}\" has a component in {axis} (isolate(a{axis})), but no support of \"{script}\" moves there",
                pair.components[0].name
            );
            return Err(Mistake::new(key!["motion", 0], message));
        }
        let (mut follows, mut others) = (0, vec![]);
        for (node, ground) in grounds(direction) {
            // Motions that arrive late go on after the end of the record.
            let steps = 2 * pair.components[0].acceleration.len();
            let u: Vec<f64> = (0..steps).map(|k| ground.motion.at(k as f64 * dt)[0]).collect();
            let last = ground.motion.end().map_or(steps, |end| ((end / dt).round() as usize + 1).clamp(3, steps));
            let found = accelerations(&u[..last], dt);
            let ratio = if asked > MOTION * whole { strength(&found) / asked } else { 1.0 };
            let is_rest = asked <= MOTION * whole && strength(&found) <= MOTION * whole;
            let alike = if is_rest { 1.0 } else { correlation(&expected, &found) };
            if (STRENGTH[0]..=STRENGTH[1]).contains(&ratio) && alike >= CORRELATION {
                follows += 1;
                continue;
            }
            others.push(format!(
                "the support at node {} of \"{script}\" moves in {axis} with {:.4} times the strength of the motion \"{}\" \
                 (isolate(a{axis}), isolate(dt)) and a correlation of {alike:.3}: expected {} to {}, and {CORRELATION} or more",
                model.model().nodes[node.0].tag,
                strength(&found) / asked,
                pair.components[0].name,
                STRENGTH[0],
                STRENGTH[1],
            ));
        }
        let Some(first) = others.first() else { continue };
        if follows == 0 {
            let message = format!(
                "{first}. Each component is to be applied in its direction, with its step and without a factor"
            );
            return Err(Mistake::new(key!["motion", 0], message));
        }
        // Motions may differ from support to support, but one of them is that of the study.
        remarks.push(format!("{first}; {} of {} supports differ so", others.len(), follows + others.len()));
    }
    study.agreement.remarks.extend(remarks);
    Ok(())
}

/// Returns true if a load or a displacement of the script is another one under a stronger motion.
fn follows_the_motion(study: &Study, model: &ScriptModel, stop: &Arc<AtomicBool>) -> Result<bool, String> {
    let job = Job { bound: "nominal", motion: 0, eccentricity: 0, level: STRONGER, draw: None };
    let stronger = run_job_to_transient(study, &job, stop)?;
    let motion = &study.motions[0].components[0];
    let every = motion.acceleration.len().div_ceil(TIMES).max(1);
    let factors = |of: &Model| -> Vec<f64> {
        let times = (0..motion.acceleration.len()).step_by(every).map(|k| k as f64 * motion.dt);
        let all = of.patterns.values().filter(|p| p.held.is_none());
        let of_pattern = |p: &Pattern| -> Vec<f64> {
            let loads = p.nodal_loads.iter().flat_map(|l| l.values.iter().copied());
            times.clone().map(|t| p.factor(t)).chain(loads).collect()
        };
        all.flat_map(of_pattern).collect()
    };
    Ok(factors(model.model()) != factors(stronger.interp.host.engine.model()))
}

#[cfg(test)]
mod tests {
    use super::{accelerations, correlation, displacements, strength};

    #[test]
    fn displacements_give_their_accelerations_back() {
        let dt = 0.01;
        let a: Vec<f64> = (0..500).map(|k| (0.13 * f64::from(k)).sin() * (-0.01 * f64::from(k)).exp()).collect();
        let found = accelerations(&displacements(a.iter().copied(), dt), dt);
        // Exact for a linear course: (a_1 + 4 a_2 + a_3)/6 at each sample.
        let smooth: Vec<f64> = a.windows(3).map(|w| (w[0] + 4.0 * w[1] + w[2]) / 6.0).collect();
        assert!(found.iter().zip(&smooth).all(|(x, y)| (x - y).abs() < 1e-9));
        let mut late = vec![0.0; 37];
        late.extend(&found);
        assert!(
            (correlation(&found, &late) - 1.0).abs() < 1e-12
                && (strength(&late) / strength(&found) - 1.0).abs() < 1e-12
        );
        let other: Vec<f64> = (0..500).map(|k| (0.17 * f64::from(k)).cos() * (-0.003 * f64::from(k)).exp()).collect();
        assert!(correlation(&found, &other) < 0.9);
    }
}
