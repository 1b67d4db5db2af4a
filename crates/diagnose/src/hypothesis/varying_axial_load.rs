//! Variation of the axial force during a run, and of the lateral force with it.

use super::axial_shear_interaction::axial_force;
use super::declaration::{Dimension, Measurement, Quantity, Recordable};
use super::{AddedParameter, Hypothesis, MovingGroup, Proposal, ProposalContext};
use crate::inspect::auxiliary_channels::axial_force_varies;
use crate::inspect::conditions::{axial_loads_differ, recorded_column};
use crate::memory::family::Family;
use crate::series::averaged;
use hysteron_identify::study::{Run, Study};

pub(super) const HYPOTHESIS: Hypothesis = Hypothesis {
    cause: "varying_axial_load",
    statement: "the axial force changes during the run and changes the lateral response",
    refuted_by: "the lateral strength does not follow the axial force",
    look_alikes: &["axial_shear_interaction", "friction"],
    shows: "loops that are wider on one side, or whose width follows the overturning or the vertical motion",
    parted_by: "the width follows the axial force, not the deformation",
    place: "nonlinear groups",
    forms: "`pressure` by the axial force of the model where it varies by 5 %, by overturning where it does not, or by a recorded axial force",
    needs_clock: false,
    memory: &[Family::Side, Family::AxialForce],
    materials: &[],
    measurement: Measurement::new(
        "record the vertical force of {place}, or vertical accelerations on both sides of the structure",
        "record the axial force of {place} during the run",
    )
    .unless(Recordable::AxialForce, None),
    quantities: &[
        Quantity::new("reference", "reference load", Dimension::Force),
        Quantity::new("lever", "axial force per lateral deformation", Dimension::Stiffness),
        Quantity::new("exponent", "exponent of the friction force", Dimension::Ratio),
    ],
    propose,
};

/// Variation of the model's axial force over its largest value from which the strength follows it.
const MIN_AXIAL_VARIATION: f64 = 0.05;

fn propose(s: &ProposalContext<'_>) -> Vec<Proposal> {
    let mut out = vec![];
    for m in s.moving_groups(false) {
        let k = m.stiffness();
        let elastic = AddedParameter::linear("k", 0.0, 1.2 * k, 0.5 * k);
        let x = m.axial_range(s).filter(|x| x.force > 0.0);
        if let Some(x) = x.filter(|x| x.force_bounds[1] - x.force_bounds[0] > MIN_AXIAL_VARIATION * x.force) {
            let line = format!(
                "{} -reference $hy_reference -power $hy_power -share $hy_k 0 {}{}",
                m.amend("pressure"),
                m.dir_option,
                m.axial_option()
            );
            let added = vec![
                AddedParameter::log("reference", 0.05 * x.force, 2.0 * x.force, 0.6 * x.force),
                AddedParameter::linear("power", 0.1, 2.0, 1.0),
                elastic,
            ];
            let form = "strength follows the axial force";
            out.push(Proposal::script_edit("varying_axial_load", form, m.location(), vec![line], added));
        } else if let (Some((p, option)), [_]) = (axial_force(s, &m), &m.directions[..])
            && (x.is_some() || !axial_loads_differ(s.study))
        {
            // The model's axial force is constant in all runs, or absent, so that it varies by the lateral motion itself.
            let line = format!(
                "{} -reference {p:.6e} -lever $hy_lever{option} -share $hy_k 0 {}",
                m.amend("pressure"),
                m.dir_option
            );
            let most = 1.5 * p / m.deformation;
            let recorded = m.recorded_axial_slope(s).map(|slope| (slope * p).clamp(-most, most));
            let added = vec![AddedParameter::linear("lever", -most, most, recorded.unwrap_or(0.2 * most)), elastic];
            let form = "strength follows an axial force that overturning changes";
            let form = Proposal::script_edit("varying_axial_load", form, m.location(), vec![line], added);
            out.push(Proposal { geometric: true, ..form });
        }
        out.extend(recorded_axial_forms(s, &m));
    }
    out
}

/// Points of a recorded history in the script, at most.
const MAX_HISTORY_POINTS: usize = 500;

/// Forms whose strength follows the recorded axial force, whatever that of the model.
fn recorded_axial_forms(s: &ProposalContext<'_>, m: &MovingGroup<'_>) -> Vec<Proposal> {
    let Some(history) = axial_history(s.study, axial_force(s, m).is_some()) else { return vec![] };
    let k = m.stiffness();
    let forms = [
        ("", "", vec![]),
        (" of the hysteretic part", " -share $hy_k 0", vec![AddedParameter::linear("k", 0.0, 1.2 * k, 0.5 * k)]),
    ];
    let form = |(which, share, more): (&str, &str, Vec<AddedParameter>)| {
        let line = format!(
            "{} -reference 1.0 -power $hy_power -axialSeries $hy_axial{share} {}",
            m.amend("pressure"),
            m.dir_option
        );
        let added = [vec![AddedParameter::linear("power", 0.1, 2.0, 1.0)], more].concat();
        let block = [history.clone(), vec![line]].concat();
        Proposal::script_edit(
            "varying_axial_load",
            &format!("strength{which} follows the recorded axial force"),
            m.location(),
            block,
            added,
        )
    };
    forms.into_iter().map(form).collect()
}

/// Commands that set `hy_axial` to the recorded axial force over its mean, by a variable that distinguishes the runs; one for
/// other runs. The mean is that of the run if the model has its axial force (`known`), else that of all runs.
fn axial_history(study: &Study, known: bool) -> Option<Vec<String>> {
    let runs: Vec<(&Run, &[f64])> =
        study.runs.iter().map(|r| Some((r, recorded_column(r, "axial")?))).collect::<Option<_>>()?;
    if !runs.iter().any(|(r, _)| axial_force_varies(r)) {
        return None;
    }
    let texts = |name: &str| runs.iter().map(|(r, _)| r.text(name)).collect::<Option<Vec<String>>>();
    let distinct = |texts: &[String]| (1..texts.len()).all(|i| !texts[..i].contains(&texts[i]));
    let (name, texts) =
        runs[0].0.set.iter().find_map(|(name, _)| Some((name, texts(name).filter(|t| distinct(t))?)))?;
    let means: Vec<f64> = runs.iter().map(|(_, axial)| mean(axial)).collect();
    if !means.iter().all(|m| m.is_finite() && *m != 0.0) {
        return None;
    }
    let of_all = means.iter().sum::<f64>() / means.len() as f64;
    let mut out = vec![format!("switch -- ${name} {{")];
    for (((run, axial), text), own) in runs.iter().zip(&texts).zip(&means) {
        let (times, ratios) = thinned(&run.recording.times, axial, if known { *own } else { of_all });
        out.push(format!("    {{{text}}} {{set hy_axial {{Path -time {{{times}}} -values {{{ratios}}} -useLast}}}}"));
    }
    out.push("    default {set hy_axial {Constant}}".into());
    out.push("}".into());
    Some(out)
}

fn mean(x: &[f64]) -> f64 {
    let (sum, n) = x.iter().filter(|x| x.is_finite()).fold((0.0, 0.0), |(sum, n), x| (sum + x, n + 1.0));
    sum / n
}

/// Times, and values over a mean, as Tcl lists of at most [`MAX_HISTORY_POINTS`] averages, from time 0 on.
fn thinned(times: &[f64], values: &[f64], over: f64) -> (String, String) {
    let there = times.iter().zip(values).filter(|(_, x)| x.is_finite());
    let (times, ratios): (Vec<f64>, Vec<f64>) = there.map(|(t, x)| (*t, x / over)).unzip();
    let (mut t, mut x) = (averaged(&times, MAX_HISTORY_POINTS), averaged(&ratios, MAX_HISTORY_POINTS));
    if t.first().is_some_and(|t| *t > 0.0) {
        t.insert(0, 0.0);
        x.insert(0, x[0]);
    }
    let list = |x: &[f64], digits: usize| x.iter().map(|x| format!("{x:.digits$}")).collect::<Vec<_>>().join(" ");
    (list(&t, 6), list(&x, 4))
}

#[cfg(test)]
mod tests {
    use super::{MAX_HISTORY_POINTS, thinned};

    #[test]
    fn a_thinned_history_begins_at_zero_and_is_short() {
        let (times, ratios) = thinned(&[0.5, 1.0, 1.5], &[2.0, f64::NAN, 4.0], 2.0);
        assert_eq!((times.as_str(), ratios.as_str()), ("0.000000 0.500000 1.500000", "1.0000 1.0000 2.0000"));
        let many: Vec<f64> = (0..5 * MAX_HISTORY_POINTS).map(|i| i as f64).collect();
        let (times, ratios) = thinned(&many, &many, 1.0);
        let first = |list: &str| list.split(' ').take(3).map(str::to_owned).collect::<Vec<_>>();
        assert_eq!(first(&times), ["0.000000", "2.000000", "7.000000"]);
        assert_eq!(ratios.split(' ').count(), MAX_HISTORY_POINTS + 1);
    }
}
