//! Runs at other temperatures than that of the model's parameters.

use super::context::distinguishing_variable;
use super::{AddedParameter, Hypothesis, Proposal, ProposalContext};
use crate::inspect::conditions::ambient_temperatures;
use crate::memory::family::Family;
use crate::prior::MIN_TEMPERATURE_DIFFERENCE;

pub(super) const HYPOTHESIS: Hypothesis = Hypothesis {
    cause: "ambient_temperature",
    statement: "the runs were made at other temperatures than that of the model's parameters",
    refuted_by: "the same run at the temperature of the model differs from it as much",
    look_alikes: &["rate_dependence", "mullins_softening"],
    needs_clock: false,
    is_missing_part: false,
    memory: &[Family::Temperature],
    propose,
};

fn propose(s: &ProposalContext<'_>) -> Vec<Proposal> {
    let (Some(temperatures), Some(name)) = (ambient_temperatures(s.study), distinguishing_variable(s.study)) else {
        return vec![];
    };
    let most = temperatures.iter().fold(f64::NEG_INFINITY, |a, b| a.max(*b));
    let least = temperatures.iter().fold(f64::INFINITY, |a, b| a.min(*b));
    if most - least < MIN_TEMPERATURE_DIFFERENCE {
        return vec![];
    }
    let mut choice = vec![format!("switch -exact -- ${name} {{")];
    for (r, t) in s.study.runs.iter().zip(&temperatures) {
        choice.push(format!("    {{{}}} {{ set hy_temperature {t:.2} }}", r.text(&name).unwrap_or_default()));
    }
    choice.push(format!("    default {{ set hy_temperature {most:.2} }}"));
    choice.push("}".into());
    let mut out = vec![];
    for m in s.moving_groups(false) {
        let amendment = format!(
            "{} -softening $hy_b -at $hy_temperature -reference {most:.2} {}",
            m.amend("temperature"),
            m.dir_option
        );
        let softening = || AddedParameter::linear("b", -0.02, 0.06, 0.008);
        let mut block = choice.clone();
        block.push(amendment.clone());
        out.push(Proposal::script_edit(
            "ambient_temperature",
            "one factor for all",
            m.location(),
            block,
            vec![softening()],
        ));
        // Strength and stiffness with factors of their own.
        let k = m.stiffness();
        let mut block = choice.clone();
        block.push(format!("{amendment} -share $hy_k $hy_elastic"));
        let added = vec![
            softening(),
            AddedParameter::linear("k", 0.05 * k, 1.5 * k, 0.6 * k),
            AddedParameter::linear("elastic", 0.0, 1.5, 0.5),
        ];
        let form = "factors for strength and stiffness";
        out.push(Proposal::script_edit("ambient_temperature", form, m.location(), block, added));
    }
    out
}
