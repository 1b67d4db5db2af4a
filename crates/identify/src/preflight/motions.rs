//! Motions that a model imposes, and those that were recorded.

use super::compare::Moments;
use super::lag::LagScan;
use super::unit_ratio::{may_be_acceleration, ratios};
use super::{Finding, FindingKind};
use crate::report::significant;
use crate::study::{Column, InitialRun, Run, ScriptSimulator};
use hysteron_engine::model::{Model, PatternKind};

/// Words in the names of columns that record the motion of the input.
const INPUT_WORDS: [&str; 5] = ["ground", "base", "table", "input", "free_field"];
/// Correlation of two records of one motion.
const SAME_MOTION: f64 = 0.98;
/// Correlation below which two records are of different motions.
const OTHER_MOTION: f64 = 0.9;
/// Number of elements that is assumed of a model that the script has removed at its end.
const REMOVED_ELEMENTS: usize = 50;

/// A motion that a pattern imposes, at the times of a recording.
struct ImposedMotion {
    is_acceleration: bool,
    values: Vec<f64>,
}

/// Motions that the model of a run imposes.
pub(super) struct ImposedMotions {
    /// Number of elements of the model.
    pub(super) elements: usize,
    motions: Vec<ImposedMotion>,
}

impl ImposedMotions {
    /// Ground accelerations of uniform excitations.
    pub(super) fn accelerations(&self) -> impl Iterator<Item = &Vec<f64>> {
        self.motions.iter().filter(|m| m.is_acceleration).map(|m| &m.values)
    }
}

/// Motions of the model at the end of a run with the script's own values. A script that ends with `wipe` has none.
pub(super) fn imposed(simulator: &ScriptSimulator, run: usize, initial_run: &InitialRun) -> ImposedMotions {
    let study = simulator.study();
    let times = &study.runs[run].recording.times;
    let space = &study.space;
    let values = space.values_at(&space.unit_point(&initial_run.values)).unwrap_or_else(|_| initial_run.values.clone());
    simulator.inspect_model(run, &values, |engine| {
        let model = engine.model();
        let elements = if model.elements.is_empty() { REMOVED_ELEMENTS } else { model.elements.len() };
        ImposedMotions { elements, motions: motions_of(model, times) }
    })
}

fn motions_of(model: &Model, times: &[f64]) -> Vec<ImposedMotion> {
    let mut out = vec![];
    for pattern in model.patterns.values().filter(|p| p.held.is_none()) {
        let sampled = |scale: f64| times.iter().map(|t| scale * pattern.factor(*t)).collect();
        match &pattern.kind {
            PatternKind::Uniform(_) => out.push(ImposedMotion { is_acceleration: true, values: sampled(1.0) }),
            PatternKind::Plain { .. } => {
                let moving = pattern.motions.iter().find(|m| !m.constant && m.value != 0.0);
                out.extend(moving.map(|m| ImposedMotion { is_acceleration: false, values: sampled(m.value) }));
            }
            PatternKind::MultipleSupport(_) => {}
        }
    }
    out
}

/// Findings about columns that record the motion of the input.
pub(super) fn findings(run: &Run, imposed: &ImposedMotions) -> Vec<Finding> {
    let is_observed = |c: &Column| run.observe.iter().any(|o| o.channel == c.name);
    let is_input = |c: &Column| {
        let name = c.name.to_lowercase();
        INPUT_WORDS.iter().any(|w| name.contains(w))
    };
    let columns = run.recording.columns.iter().filter(|c| is_input(c) && !is_observed(c));
    let mut differing = vec![];
    let mut out = vec![];
    let mut is_any_seen = false;
    for column in columns {
        let is_acceleration = may_be_acceleration(&column.unit, &column.name);
        let alike = imposed.motions.iter().filter(|m| m.is_acceleration == is_acceleration);
        let compared = alike.map(|m| (Moments::new(&column.values, &m.values), m));
        let Some((m, motion)) = compared.max_by(|a, b| a.0.correlation().abs().total_cmp(&b.0.correlation().abs()))
        else {
            continue;
        };
        let finding = |kind, message: String| Finding {
            kind,
            is_hard: false,
            channel: column.name.clone(),
            runs: vec![run.name.clone()],
            factor: None,
            lag_s: None,
            message,
            help: "check the motion, its time step and its factor in the script".into(),
        };
        let r = m.correlation();
        if r.abs() >= SAME_MOTION {
            is_any_seen = true;
            let [factor, _] = m.line();
            if r < 0.0 {
                let message =
                    format!("recorded = {factor:.3} x imposed motion, correlation {r:.2}: is the sign turned?");
                out.push(Finding { factor: Some(factor), ..finding(FindingKind::Input, message) });
            } else if let Some(u) =
                ratios(&column.unit, &column.name).iter().find(|u| (u.factor / factor).ln().abs() < 0.05)
            {
                let message =
                    format!("recorded = {} x imposed motion: {} for {}?", significant(factor, 3), u.recorded, u.model);
                out.push(Finding { factor: Some(factor), ..finding(FindingKind::Input, message) });
            }
            continue;
        }
        if r.abs() >= OTHER_MOTION {
            is_any_seen = true;
            continue;
        }
        let late = LagScan::new(&run.recording.times, &column.values, &motion.values)
            .map(|s| (s.most_correlated(), s.largest_correlation(), s))
            .filter(|(lag, _, scan)| scan.identifies(*lag));
        match late {
            Some((lag, r, _)) if r >= SAME_MOTION => {
                is_any_seen = true;
                let when = if lag > 0.0 { "late" } else { "early" };
                let message = format!("recorded is {} s {when} against the imposed motion", significant(lag.abs(), 3));
                out.push(Finding { lag_s: Some(lag), ..finding(FindingKind::Lag, message) });
            }
            _ => differing.push(finding(
                FindingKind::Input,
                format!("it differs from the motion that the model imposes, correlation {r:.2}"),
            )),
        }
    }
    if is_any_seen {
        for f in &mut differing {
            f.kind = FindingKind::UnseenInput;
            f.message = "the model imposes no such motion".into();
            f.help = "add it to the script, if it matters".into();
        }
    }
    out.extend(differing);
    out
}
