//! `damping` and `overstress`: forces that depend on the rate of deformation.

use super::{FormInput, StandardForm, Translation};

pub(super) const DAMPING: Translation =
    Translation { kind: "damping", form: "`Viscous`, in transient analyses", per_element: false, make: damping };
pub(super) const OVERSTRESS: Translation = Translation {
    kind: "overstress",
    form: "`ViscousDamper` or `Maxwell`, in transient analyses; in two directions if it is linear",
    per_element: false,
    make: overstress,
};

fn damping(input: &FormInput<'_>) -> Result<Vec<StandardForm>, String> {
    let a = input.amendment;
    let mut form = StandardForm::default();
    let tag = input.next_material(&form);
    let (coefficient, power) = (a.text("-coefficient", ""), a.text("-power", "1.0"));
    form.commands.push(format!("uniaxialMaterial Viscous {tag} {coefficient} {power}"));
    a.directions().into_iter().for_each(|d| form.add(d, tag));
    Ok(vec![form])
}

fn overstress(input: &FormInput<'_>) -> Result<Vec<StandardForm>, String> {
    let a = input.amendment;
    let power = a.text("-power", "1.0");
    if power.parse() != Ok(1.0) {
        a.one_direction("a nonlinear overstress")?;
    }
    let (force, speed, stiffness) = (a.text("-force", ""), a.text("-speed", "1.0"), a.text("-stiffness", ""));
    let law = |name: &str, more: &str| {
        let mut form = StandardForm::default();
        let tag = input.next_material(&form);
        let coefficient = format!("[expr {{{force}/pow({speed},{power})}}]");
        form.commands.push(format!("uniaxialMaterial {name} {tag} {stiffness} {coefficient} {power}{more}"));
        a.directions().into_iter().for_each(|d| form.add(d, tag));
        form
    };
    Ok(vec![law("ViscousDamper", ""), law("Maxwell", " 1.0")])
}
