//! Runs at other temperatures than that of the model's parameters.

use super::context::distinguishing_variable;
use super::declaration::{Dimension, Measurement, Quantity, Recordable};
use super::{AddedParameter, Hypothesis, Proposal, ProposalContext};
use crate::inspect::conditions::ambient_temperatures;
use crate::memory::family::Family;
use crate::prior::MIN_TEMPERATURE_DIFFERENCE;

/// Steepest published softening of rubber, 1/degree (Constantinou et al. 2007, MCEER-07-0012).
pub(crate) const STEEPEST_SOFTENING: f64 = 0.03;

pub(super) const HYPOTHESIS: Hypothesis = Hypothesis {
    cause: "ambient_temperature",
    statement: "the runs were made at other temperatures than that of the model's parameters",
    refuted_by: "the same run at the temperature of the model differs from it as much",
    look_alikes: &["rate_dependence", "mullins_softening"],
    shows: "a whole run that is stiffer or softer than another, by one factor from its first cycle on",
    parted_by: "the factor follows the recorded temperature, not the speed of the run",
    place: "nonlinear groups, where temperatures of runs differ by 2 degrees and a variable of the study tells the runs apart",
    forms: "`temperature`: one factor, or one each for strength and stiffness",
    needs_clock: false,
    memory: &[Family::Temperature],
    materials: &[],
    measurement: Measurement::new(
        "record the temperature at {place} with every earthquake",
        "record the temperature of {place}, and repeat one run at the temperature of the model",
    )
    .unless(Recordable::Temperature, Some("repeat one run at the temperature of the model")),
    quantities: &[
        Quantity::new("temperature", "temperature of the rubber", Dimension::Unnamed),
        Quantity::new("b", "softening", Dimension::PerDegree).within(
            "the softening per degree",
            [0.0, STEEPEST_SOFTENING],
            "bearings lose 0.2 to 3 % a degree (Constantinou et al. 2007, MCEER-07-0012)",
        ),
    ],
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
