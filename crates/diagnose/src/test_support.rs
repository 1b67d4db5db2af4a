//! Studies, hypotheses and noise for unit tests.

use crate::candidate::proposal::{AddedParameter, Proposal};
use crate::candidate::variant::Variant;
use crate::fit::fitted::FittedHypothesis;
use crate::fit::job::FittedModel;
use crate::hypothesis::context::ProposalContext;
use crate::inspect::insertion::InsertionPoint;
use crate::inspect::inventory::ModelInventory;
use crate::inspect::probe::tests::inventory_of;
use crate::inspect::response::ResponseRanges;
use crate::memory::data::DeviceRun;
use hysteron_identify::study::Study;
use hysteron_tcl::diagnostic::SourceMap;
use std::path::Path;
use std::sync::Arc;

/// The study of a pad under imposed displacement that the repository ships.
pub(crate) fn pad_study() -> Study {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tcl-like-inputs/pad_study/study.toml");
    Study::load(&file, &mut SourceMap::default()).expect("a study")
}

/// The basis of proposals for a model without recordings of its own.
pub(crate) fn proposal_context<'a>(
    inventory: &'a ModelInventory,
    study: &'a Study,
    responses: &'a ResponseRanges,
) -> ProposalContext<'a> {
    ProposalContext {
        inventory,
        study,
        responses,
        fits: &[],
        sensitivities: None,
        values: &[],
        has_clock: true,
        text: "",
        model_end: 0,
        value_spans: &[],
    }
}

/// Inventory of a model that one motion shakes along the first axis for two steps.
pub(crate) fn shaken_inventory(model: &str) -> ModelInventory {
    inventory_under(model, "UniformExcitation 2 1 -accel 2")
}

/// The same under another pattern of series 2.
pub(crate) fn inventory_under(model: &str, pattern: &str) -> ModelInventory {
    inventory_of(&format!(
        "{model}
        timeSeries Path 2 -dt 0.01 -values {{0. 1. 0.}}
        pattern {pattern}
        constraints Plain; numberer Plain; system FullGeneral; algorithm Linear
        integrator Newmark 0.5 0.25
        analysis Transient
        analyze 2 0.01\n"
    ))
}

/// A variant at the middle of the user's parameters, with coordinates of the added ones.
pub(crate) fn fitted_at(variant: Variant, added: &[f64]) -> FittedHypothesis {
    let own = variant.dimension() - added.len();
    let point = [&vec![0.5; own][..], added].concat();
    let values = variant.study.space.values_at(&point).expect("values");
    FittedHypothesis::new(Arc::new(variant), FittedModel { point, values, objective: 1.0, fits: vec![] })
}

/// The baseline of that study at the middle of its parameters.
pub(crate) fn baseline() -> FittedHypothesis {
    fitted_at(Variant::baseline(&Arc::new(pad_study()), "analyze 1\n"), &[])
}

/// An edit of the script with parameters from 0 to 1.
pub(crate) fn script_edit(cause: &'static str, names: &[&str]) -> Proposal {
    let parameters = names.iter().map(|n| AddedParameter::linear(n, 0.0, 1.0, 0.5)).collect();
    let commands = names.iter().map(|n| format!("{n} $hy_{n}")).collect();
    Proposal::script_edit(cause, cause, "element 1".into(), commands, parameters)
}

/// Hypotheses by cause, log evidence and coordinate of all the user's parameters.
pub(crate) fn hypotheses(of: &[(&'static str, f64, f64)]) -> Vec<FittedHypothesis> {
    let baseline = baseline();
    let own = baseline.variant.dimension();
    let one = |(cause, log_evidence, coordinate): &(&'static str, f64, f64)| {
        let proposal = script_edit(cause, &["x"]);
        let variant = baseline.variant.with_proposal(&InsertionPoint::At(0), &proposal).expect("a variant");
        let mut e = fitted_at(variant, &[0.5]);
        e.fitted.point[..own].fill(*coordinate);
        e.log_evidence = *log_evidence;
        e
    };
    of.iter().map(one).collect()
}

/// White noise of variance one: sums of twelve uniform numbers.
pub(crate) fn white_noise(seed: u64, n: usize) -> Vec<f64> {
    let mut x = 88172645463325252u64 ^ (seed << 32);
    let mut uniform = || {
        x ^= x << 13;
        x ^= x >> 7;
        x ^= x << 17;
        (x >> 11) as f64 / (1u64 << 53) as f64
    };
    (0..n).map(|_| (0..12).map(|_| uniform()).sum::<f64>() - 6.0).collect()
}

/// Runs of a slider beside a spring: two fitted and one held out. `factor` is that of the slip force, by time, work and
/// logarithm of the time at rest; the work of a run at full strength is about 40.
pub(crate) fn slider_runs(factor: impl Fn(f64, f64, f64) -> f64) -> Vec<DeviceRun> {
    let motions: [fn(f64) -> f64; 3] = [
        |t| (1.0 - (-0.2 * t).exp()) * (2.1 * t).sin(),
        |t| {
            if t % 12.0 < 6.0 { 0.8 * (0.3 * t).min(1.0) * (2.0 * std::f64::consts::FRAC_PI_3 * t).sin() } else { 0.0 }
        },
        |t| 0.7 * (1.7 * t).sin() * (0.31 * t).cos(),
    ];
    let one = |k: usize| {
        let times: Vec<f64> = (0..1200).map(|i| 0.03 * f64::from(i)).collect();
        let deformation: Vec<f64> = times.iter().map(|t| motions[k](*t)).collect();
        let (mut s, mut work, mut aged, mut slips) = (0.0f64, 0.0, 0.0f64, true);
        let mut modelled = vec![];
        let noise = white_noise(k as u64 + 1, times.len());
        let mut recorded = vec![];
        let mut plain = 0.0f64;
        for j in 0..times.len() {
            let du = if j > 0 { deformation[j] - deformation[j - 1] } else { 0.0 };
            // The contact is at rest while it does not slip.
            if !slips {
                aged = (aged.exp() + 0.03 / 0.36).ln();
            }
            let level = 0.1 * factor(times[j], work, aged);
            let trial = s + du;
            s = trial.clamp(-level, level);
            work += 10.0 * (trial - s).abs() * level / 0.1;
            // Slip wears the contact off, and rest goes on from what it leaves.
            aged *= (-(trial - s).abs() / 0.15).exp();
            slips = trial != s;
            plain = (plain + du).clamp(-0.1, 0.1);
            modelled.push(deformation[j] + 10.0 * plain);
            recorded.push(deformation[j] + 10.0 * s + 0.01 * noise[j]);
        }
        DeviceRun { times, deformation, modelled, recorded, conditions: vec![], held_out: k == 2 }
    };
    (0..3).map(one).collect()
}
