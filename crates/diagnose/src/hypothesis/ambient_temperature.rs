//! The run was made at another temperature than the model's.

use super::{Added, Hypothesis, Proposal, Sight};
use crate::inspect::conditions::{DEGREES, temperatures};

pub(super) const HYPOTHESIS: Hypothesis = Hypothesis {
    cause: "ambient_temperature",
    says: "the runs were made at other temperatures than that of the model's parameters",
    refuted_by: "the same run at the temperature of the model differs from it as much",
    like: &["rate_dependence", "mullins_softening"],
    needs_clock: false,
    propose,
};

/// A variable that every run sets to something else: the block tells the runs by it.
fn telling(s: &Sight<'_>) -> Option<String> {
    let names = s.study.runs[0].set.iter().map(|(n, _)| n);
    let differs = |name: &&String| {
        let values: Vec<Option<String>> = s.study.runs.iter().map(|r| r.text(name)).collect();
        values.iter().enumerate().all(|(i, v)| v.is_some() && !values[..i].contains(v))
    };
    names.into_iter().find(differs).cloned()
}

fn propose(s: &Sight<'_>) -> Vec<Proposal> {
    let (Some(temperatures), Some(name)) = (temperatures(s.study), telling(s)) else { return vec![] };
    let most = temperatures.iter().fold(f64::NEG_INFINITY, |a, b| a.max(*b));
    let least = temperatures.iter().fold(f64::INFINITY, |a, b| a.min(*b));
    if most - least < DEGREES {
        return vec![];
    }
    let mut choose = vec![format!("switch -exact -- ${name} {{")];
    for (r, t) in s.study.runs.iter().zip(&temperatures) {
        choose.push(format!("    {{{}}} {{ set hy_temperature {t:.2} }}", r.text(&name).unwrap_or_default()));
    }
    choose.push(format!("    default {{ set hy_temperature {most:.2} }}"));
    choose.push("}".into());
    let mut out = vec![];
    for m in s.moved(false) {
        let whole =
            format!("{} -softening $hy_b -at $hy_temperature -reference {most:.2} {}", m.amend("temperature"), m.dir);
        let b = || Added::linear("b", -0.02, 0.06, 0.008);
        let mut block = choose.clone();
        block.push(whole.clone());
        out.push(Proposal::edit("ambient_temperature", "one factor for all", m.at(), block, vec![b()]));
        // Strength and stiffness on their own: the elastic part in its own measure.
        let k = m.stiffness();
        let mut block = choose.clone();
        block.push(format!("{whole} -share $hy_k $hy_elastic"));
        let added = vec![b(), Added::linear("k", 0.05 * k, 1.5 * k, 0.6 * k), Added::linear("elastic", 0.0, 1.5, 0.5)];
        let form = "factors for strength and stiffness";
        out.push(Proposal::edit("ambient_temperature", form, m.at(), block, added));
    }
    out
}
