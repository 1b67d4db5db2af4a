//! `temperature`, and `axial` at a constant load: factors on the force that are constant in a run.

use super::amendment::Amendment;
use super::{FormInput, StandardForm, Translation};

pub(super) const TEMPERATURE: Translation = Translation {
    kind: "temperature",
    form: "`Parallel` with a factor around the element's own law",
    per_element: false,
    make: temperature,
};
pub(super) const AXIAL: Translation = Translation {
    kind: "axial",
    form: "the same, at a load of the run's own and without a width of the plates",
    per_element: false,
    make: axial,
};

fn temperature(input: &FormInput<'_>) -> Result<Vec<StandardForm>, String> {
    let a = input.amendment;
    let (softening, at, reference) = (a.text("-softening", ""), a.text("-at", ""), a.text("-reference", ""));
    factor(input, &format!("exp(-1.0*{softening}*({at}-({reference})))"))
}

fn axial(input: &FormInput<'_>) -> Result<Vec<StandardForm>, String> {
    let a = input.amendment;
    if a.has("-width") || !a.has("-load") {
        return Err("a stiffness that follows the axial load has no standard command in OpenSees".into());
    }
    let (critical, power) = (a.text("-critical", ""), a.text("-power", "2.0"));
    let (load, reference) = (a.text("-load", ""), a.text("-reference", "0.0"));
    let part = |load: &str| format!("(1.0-pow(max(0.0,{load})/{critical},{power}))");
    factor(input, &format!("{}/{}", part(&load), part(&reference)))
}

/// A factor on the force, in the measures that option `-share` gives.
fn factor(input: &FormInput<'_>, factor: &str) -> Result<Vec<StandardForm>, String> {
    let a: &Amendment = input.amendment;
    if a.has("-strengthBeside") {
        return Err("a factor on the strength alone has no standard command in OpenSees".into());
    }
    let mut form = StandardForm::default();
    let first = input.next_material(&form);
    form.commands.push(format!("set hysteron_factor_{first} [expr {{{factor}}}]"));
    let share = a.words("-share");
    let on_rest = match share.get(2) {
        Some(rest) => format!("[expr {{1.0-{rest}*(1.0-$hysteron_factor_{first})}}]"),
        None => format!("$hysteron_factor_{first}"),
    };
    if let [k, elastic, ..] = share {
        form.commands.push(format!(
            "uniaxialMaterial Elastic {first} [expr {{{k}*(1.0-{elastic}*(1.0-$hysteron_factor_{first})-{on_rest})}}]"
        ));
        a.directions().into_iter().for_each(|d| form.add(d, first));
    }
    form.factor = Some(on_rest);
    Ok(vec![form])
}
