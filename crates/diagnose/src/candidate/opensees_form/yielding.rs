//! `yielding`: an elastic element that yields.

use super::{FormInput, StandardForm, Translation};

pub(super) const YIELDING: Translation = Translation {
    kind: "yielding",
    form: "`Steel01` beside an `Elastic` of minus its stiffness, in one direction",
    per_element: true,
    make,
};

/// The elastic law of the element stays, so that the added one is what yielding takes away.
fn make(input: &FormInput<'_>) -> Result<Vec<StandardForm>, String> {
    let a = input.amendment;
    let direction = a.one_direction("yielding")?;
    let stiffness = input.stiffness(direction).ok_or("the elements that yield have different stiffnesses")?;
    let (force, hardening) = (a.text("-force", ""), a.text("-hardening", "0.0"));
    let mut form = StandardForm::default();
    let steel = input.next_material(&form);
    form.commands.push(format!("uniaxialMaterial Steel01 {steel} {force} {stiffness:?} {hardening}"));
    let elastic = input.next_material(&form);
    form.commands.push(format!("uniaxialMaterial Elastic {elastic} {:?}", -stiffness));
    form.add(direction, steel);
    form.add(direction, elastic);
    Ok(vec![form])
}
