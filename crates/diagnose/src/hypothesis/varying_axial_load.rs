//! The axial force changes during the run, and the lateral force with it.

use super::axial_shear_interaction::load;
use super::{Added, Hypothesis, Moved, Proposal, Sight};
use crate::inspect::auxiliary_channels::axial_varies;
use crate::inspect::conditions::{axial_loads_differ, column};
use crate::residual::noise::averaged;
use hysteron_identify::study::{Run, Study};

pub(super) const HYPOTHESIS: Hypothesis = Hypothesis {
    cause: "varying_axial_load",
    says: "the axial force changes during the run and changes the lateral response",
    refuted_by: "the lateral strength does not follow the axial force",
    like: &["axial_shear_interaction", "friction"],
    needs_clock: false,
    propose,
};

/// Part of itself that the axial force of the model has to vary by to be followed.
const VARIES: f64 = 0.05;

fn propose(s: &Sight<'_>) -> Vec<Proposal> {
    let mut out = vec![];
    for m in s.moved(false) {
        let k = m.stiffness();
        let elastic = Added::linear("k", 0.0, 1.2 * k, 0.5 * k);
        let x = m.axial.and_then(|axial| s.scales.of(&m.group, axial)).filter(|x| x.q > 0.0);
        if let Some(x) = x.filter(|x| x.forces[1] - x.forces[0] > VARIES * x.q) {
            let line = format!(
                "{} -reference $hy_reference -power $hy_power -share $hy_k 0 {}{}",
                m.amend("pressure"),
                m.dir,
                m.axial_word()
            );
            let added = vec![
                Added::log("reference", 0.05 * x.q, 2.0 * x.q, 0.6 * x.q),
                Added::linear("power", 0.1, 2.0, 1.0),
                elastic,
            ];
            let form = "strength follows the axial force";
            out.push(Proposal::edit("varying_axial_load", form, m.at(), vec![line], added));
        } else if let (Some((p, option)), [_]) = (load(s, &m), &m.directions[..])
            && (x.is_some() || !axial_loads_differ(s.study))
        {
            // The model holds it constant in all runs, or does not have it: what comes of the lateral motion itself.
            let line =
                format!("{} -reference {p:.6e} -lever $hy_lever{option} -share $hy_k 0 {}", m.amend("pressure"), m.dir);
            let most = 1.5 * p / m.e;
            let recorded = m.axial_over(s).map(|slope| (slope * p).clamp(-most, most));
            let added = vec![Added::linear("lever", -most, most, recorded.unwrap_or(0.2 * most)), elastic];
            let form = "strength follows an axial force that overturning changes";
            let form = Proposal::edit("varying_axial_load", form, m.at(), vec![line], added);
            out.push(Proposal { exact: true, ..form });
        }
        out.extend(as_recorded(s, &m));
    }
    out
}

/// Points of a recorded history in the script, at most.
const POINTS: usize = 500;

/// The strength follows what a load cell has recorded, whatever the model carries.
fn as_recorded(s: &Sight<'_>, m: &Moved<'_>) -> Vec<Proposal> {
    let Some(history) = history(s.study, load(s, m).is_some()) else { return vec![] };
    let k = m.stiffness();
    let forms = [
        ("", "", vec![]),
        (" of the hysteretic part", " -share $hy_k 0", vec![Added::linear("k", 0.0, 1.2 * k, 0.5 * k)]),
    ];
    let form = |(which, share, more): (&str, &str, Vec<Added>)| {
        let line =
            format!("{} -reference 1.0 -power $hy_power -axialSeries $hy_axial{share} {}", m.amend("pressure"), m.dir);
        let added = [vec![Added::linear("power", 0.1, 2.0, 1.0)], more].concat();
        let block = [history.clone(), vec![line]].concat();
        Proposal::edit(
            "varying_axial_load",
            &format!("strength{which} follows the recorded axial force"),
            m.at(),
            block,
            added,
        )
    };
    forms.into_iter().map(form).collect()
}

/// Commands that set `hy_axial` to the recorded axial force over its mean, for each run by the variable that tells them apart; one for
/// other runs. The mean is that of the run where the model knows its load, and else of all runs.
fn history(study: &Study, known: bool) -> Option<Vec<String>> {
    let runs: Vec<(&Run, &[f64])> = study.runs.iter().map(|r| Some((r, column(r, "axial")?))).collect::<Option<_>>()?;
    if !runs.iter().any(|(r, _)| axial_varies(r)) {
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

/// Times and values over a mean as lists, averaged over as many samples as make them few; from the beginning on.
fn thinned(times: &[f64], values: &[f64], over: f64) -> (String, String) {
    let there = times.iter().zip(values).filter(|(_, x)| x.is_finite());
    let (times, ratios): (Vec<f64>, Vec<f64>) = there.map(|(t, x)| (*t, x / over)).unzip();
    let (mut t, mut x) = (averaged(&times, POINTS), averaged(&ratios, POINTS));
    if t.first().is_some_and(|t| *t > 0.0) {
        t.insert(0, 0.0);
        x.insert(0, x[0]);
    }
    let list = |x: &[f64], digits: usize| x.iter().map(|x| format!("{x:.digits$}")).collect::<Vec<_>>().join(" ");
    (list(&t, 6), list(&x, 4))
}

#[cfg(test)]
mod tests {
    use super::{POINTS, thinned};

    #[test]
    fn a_history_begins_at_once_and_is_short() {
        let (times, ratios) = thinned(&[0.5, 1.0, 1.5], &[2.0, f64::NAN, 4.0], 2.0);
        assert_eq!((times.as_str(), ratios.as_str()), ("0.000000 0.500000 1.500000", "1.0000 1.0000 2.0000"));
        let many: Vec<f64> = (0..5 * POINTS).map(|i| i as f64).collect();
        let (times, ratios) = thinned(&many, &many, 1.0);
        let first = |list: &str| list.split(' ').take(3).map(str::to_owned).collect::<Vec<_>>();
        assert_eq!(first(&times), ["0.000000", "2.000000", "7.000000"]);
        assert_eq!(ratios.split(' ').count(), POINTS + 1);
    }
}
