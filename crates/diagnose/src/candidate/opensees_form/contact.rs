//! `gap`: contact after a gap closes.

use super::{FormInput, StandardForm, Translation};

pub(super) const GAP: Translation =
    Translation { kind: "gap", form: "`ElasticPPGap`, or `Hertzdamp` between the nodes", per_element: false, make };

/// Yield force of an elastic contact over the force at the largest deformation: it never yields.
const ELASTIC_FORCE: f64 = 1e3;

/// Laws of one wall: with damping by the speed of approach, without damping, and elastic with a linear law.
fn make(input: &FormInput<'_>) -> Result<Vec<StandardForm>, String> {
    let a = input.amendment;
    let side = a.number("-side").ok_or("the side of the wall is no number")?;
    let power = a.text("-power", "1");
    let signs: Vec<f64> = [1.0, -1.0].into_iter().filter(|sign| side == 0.0 || side.signum() == *sign).collect();
    let linear = power.parse() == Ok(1.0);
    let mut out = vec![];
    if a.has("-damping") {
        out.push(hertz(input, &signs, &power, true));
    }
    out.push(if linear { elastic(input, &signs) } else { hertz(input, &signs, &power, false) });
    Ok(out)
}

/// Linear contact without damping.
fn elastic(input: &FormInput<'_>, signs: &[f64]) -> StandardForm {
    let a = input.amendment;
    let (stiffness, at) = (a.text("-stiffness", ""), a.text("-at", "0.0"));
    let mut form = StandardForm::default();
    for direction in a.directions() {
        let reach = ELASTIC_FORCE * input.deformation(direction);
        for sign in signs {
            let tag = input.next_material(&form);
            form.commands.push(format!(
                "uniaxialMaterial ElasticPPGap {tag} {stiffness} [expr {{{:.6e}*{stiffness}}}] [expr {{{sign:.1}*{at}}}]",
                sign * reach
            ));
            form.add(direction, tag);
        }
    }
    form
}

/// Hertz' contact. The law acts in compression alone, so that the wall on the positive side joins the nodes in the
/// other order.
fn hertz(input: &FormInput<'_>, signs: &[f64], power: &str, damped: bool) -> StandardForm {
    let a = input.amendment;
    let (stiffness, at, damping) = (a.text("-stiffness", ""), a.text("-at", "0.0"), a.text("-damping", "0.0"));
    let mut form = StandardForm::default();
    for direction in a.directions() {
        for sign in signs {
            let tag = input.next_material(&form);
            // The coefficient of the standard law is that of the amendment times the speed of the approach.
            let speed = a.number("-at").map_or(0.0, |at| input.approach_speed(direction, *sign, at));
            let xi = if damped { format!("[expr {{{speed:.6e}*{damping}}}]") } else { "0.0".into() };
            form.commands
                .push(format!("uniaxialMaterial Hertzdamp {tag} {stiffness} {xi} [expr {{-1.0*{at}}}] {power}"));
            if *sign > 0.0 { form.add_mirrored(direction, tag) } else { form.add_between_nodes(direction, tag) }
        }
    }
    form
}
