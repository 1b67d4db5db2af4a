//! `friction` and `bristles`: a friction force in parallel.

use super::{FormInput, StandardForm, Translation};

pub(super) const FRICTION: Translation =
    Translation { kind: "friction", form: "`ElasticPP`, in one direction", per_element: false, make: friction };
pub(super) const BRISTLES: Translation = Translation {
    kind: "bristles",
    form: "`BoucWen` with n = 1, gamma = 0 and beta = k/F, in one direction and without breakaway",
    per_element: false,
    make: bristles,
};

fn friction(input: &FormInput<'_>) -> Result<Vec<StandardForm>, String> {
    let a = input.amendment;
    let direction = a.one_direction("friction")?;
    let (force, stiffness) = (a.text("-force", ""), a.text("-stiffness", ""));
    let mut form = StandardForm::default();
    let tag = input.next_material(&form);
    form.commands.push(format!("uniaxialMaterial ElasticPP {tag} {stiffness} [expr {{{force}/{stiffness}}}]"));
    form.add(direction, tag);
    Ok(vec![form])
}

/// Dahl's law is that of Bouc and Wen without the loop of unloading.
fn bristles(input: &FormInput<'_>) -> Result<Vec<StandardForm>, String> {
    let a = input.amendment;
    if a.has("-breakaway") {
        return Err("friction that breaks away has no standard command in OpenSees".into());
    }
    let direction = a.one_direction("friction")?;
    let (force, stiffness) = (a.text("-force", ""), a.text("-stiffness", ""));
    let mut form = StandardForm::default();
    let tag = input.next_material(&form);
    form.commands.push(format!(
        "uniaxialMaterial BoucWen {tag} 0.0 {stiffness} 1.0 0.0 [expr {{{stiffness}/{force}}}] 1.0 0.0 0.0 0.0"
    ));
    form.add(direction, tag);
    Ok(vec![form])
}
