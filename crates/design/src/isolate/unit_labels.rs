//! The names of units in a study beside what its script says and shows of them.
//!
//! A script that names its units is a statement: another name in the study is refused. Magnitudes are no statement: moduli of
//! steel, pressures of bearings and weights of floors give warnings.

use super::script_model::ScriptModel;
use super::study::Study;
use crate::mistake::{Mistake, key};
use hysteron_identify::study::unit::{Quantity, Unit, all, unit};
use std::f64::consts::PI;

/// Difference of a variable of the script that is named as a unit from the value of that unit, at most.
const VARIABLE: f64 = 0.01;
/// Names of units that scripts give to no other variable: `tf` is a thickness, `lb` a length.
const VARIABLES: [&str; 6] = ["kN", "kip", "kips", "lbf", "kgf", "tonf"];
/// Modulus of elasticity of steel in Pa, at least and at most.
const STEEL: [f64; 2] = [1.8e11, 2.2e11];
/// Pressure of gravity on the whole area of a bearing in Pa, at least and at most.
const PRESSURE: [f64; 2] = [0.3e6, 6.0e7];
/// Weight of a floor over the plan in Pa, at least and at most.
const FLOOR: [f64; 2] = [1.0e3, 4.0e4];

/// Compare the units of a study with its script.
///
/// # Errors
/// The script names other units. The message has both places.
pub(super) fn compare(study: &mut Study, model: &mut ScriptModel) -> Result<(), Mistake> {
    let [force, length] = [(0, Quantity::Force), (1, Quantity::Length)]
        .map(|(k, quantity)| unit(&study.units[k]).filter(|u| u.quantity == quantity));
    let script = hysteron_files::read_lossy(&study.script).unwrap_or_default();
    for label in [force, length].into_iter().flatten() {
        comments(study, &script, label)?;
    }
    if let Some(force) = force {
        variables(study, model, force)?;
    }
    if let (Some(force), Some(length)) = (force, length) {
        let found =
            [steel(study, model, force, length), pressures(study, model, force, length), floors(study, force, length)];
        study.agreement.remarks.extend(found.into_iter().flatten());
    }
    Ok(())
}

/// Units of a quantity in a comment `# Units: kN, m, s`.
fn stated(line: &str, quantity: Quantity) -> Vec<Unit> {
    let Some(comment) = line.split_once('#').map(|(_, c)| c) else { return vec![] };
    let key = |word: &str| matches!(word.trim().to_lowercase().as_str(), "unit" | "units");
    let Some((_, list)) = comment.split_once([':', '=']).filter(|(k, _)| k.split_whitespace().any(key)) else {
        return vec![];
    };
    let words = list.split([',', ';', ' ', '(', ')']).map(|w| w.trim_end_matches('.'));
    words.filter_map(unit).filter(|u| u.quantity == quantity).collect()
}

/// A comment of the script names its units.
fn comments(study: &Study, script: &str, label: Unit) -> Result<(), Mistake> {
    for (k, line) in script.lines().enumerate() {
        let found = stated(line, label.quantity);
        // A comment with several units of a quantity is about a conversion.
        let [first] = found[..] else { continue };
        if (first.factor / label.factor - 1.0).abs() > VARIABLE {
            let message = format!(
                "units = {:?}, but \"{}\":{} says \"{}\": a value is {:.6} times as large in the study. Expected {} \
                 in the place of {}, or another comment",
                study.units,
                study.script.display(),
                k + 1,
                line.trim(),
                label.factor / first.factor,
                first.name,
                label.name
            );
            return Err(Mistake::new(key!["units"], message));
        }
    }
    Ok(())
}

/// A variable of the script that is named as a unit has the value of that unit.
fn variables(study: &Study, model: &mut ScriptModel, label: Unit) -> Result<(), Mistake> {
    for other in all().iter().filter(|u| VARIABLES.contains(&u.name)) {
        let Some(found) = model.variable(other.name) else { continue };
        let expected = other.factor / label.factor;
        if (found / expected - 1.0).abs() > VARIABLE {
            let message = format!(
                "units = {:?}, in which 1 {} is {expected:.6}, but the variable {} of \"{}\" is {found:.6}: ratio {:.4}. \
                 The script computes in another unit of force",
                study.units,
                other.name,
                other.name,
                study.script.display(),
                found / expected
            );
            return Err(Mistake::new(key!["units"], message));
        }
    }
    Ok(())
}

/// A text of the unit of stress.
fn stress(force: Unit, length: Unit) -> String {
    format!("{}/{}²", force.name, length.name)
}

/// Steel of sections has its modulus in another unit of force alone.
fn steel(study: &Study, model: &ScriptModel, force: Unit, length: Unit) -> Option<String> {
    let moduli = model.steel_of_sections();
    let (tag, first) = *moduli.first()?;
    let is_steel = |e: f64, u: &Unit| (STEEL[0]..=STEEL[1]).contains(&(e * u.factor / length.factor.powi(2)));
    if moduli.iter().any(|(_, e)| is_steel(*e, &force)) {
        return None;
    }
    let other = all().iter().find(|u| u.quantity == Quantity::Force && moduli.iter().all(|(_, e)| is_steel(*e, u)))?;
    Some(format!(
        "the steel {tag} of the sections of \"{}\" has a modulus of {first:.4e} {}, which is {:.1} GPa; it is steel in {}. Is the \
         unit of force in units = {:?} another one?",
        study.script.display(),
        stress(force, length),
        1e-9 * first * force.factor / length.factor.powi(2),
        stress(*other, length),
        study.units
    ))
}

/// Gravity presses on the bearings as it does on rubber or on a slider.
fn pressures(study: &Study, model: &ScriptModel, force: Unit, length: Unit) -> Option<String> {
    let of = |(kind, b): (usize, &super::study::BearingType)| {
        let load = model.bearings.iter().filter(|m| m.kind == kind).map(|m| m.gravity).fold(0.0, f64::max);
        let area = 0.25 * PI * b.diameter?.powi(2);
        let pressure = load / area * force.factor / length.factor.powi(2);
        (load > 0.0 && !(PRESSURE[0]..=PRESSURE[1]).contains(&pressure)).then(|| {
            format!(
                "{}: gravity of {load:.4} {} on a diameter of {} {} is a pressure of {:.4e} MPa: expected {} to {}. Is a unit in \
                 units = {:?} another one?",
                b.name,
                force.name,
                b.diameter.unwrap_or_default(),
                length.name,
                1e-6 * pressure,
                1e-6 * PRESSURE[0],
                1e-6 * PRESSURE[1],
                study.units
            )
        })
    };
    study.bearings.iter().enumerate().find_map(of)
}

/// Floors weigh what floors of buildings weigh.
fn floors(study: &Study, force: Unit, length: Unit) -> Option<String> {
    let [b, d] = study.plan?;
    let heaviest = study.floors.iter().map(|f| f.weight).reduce(f64::max)?;
    let load = heaviest / (b * d) * force.factor / length.factor.powi(2);
    (!(FLOOR[0]..=FLOOR[1]).contains(&load)).then(|| {
        format!(
            "a floor of {heaviest:.4} {} on a plan of {b} x {d} {} weighs {:.4e} kN/m²: expected {} to {}. Is a unit in units = {:?} \
             another one, or the plan?",
            force.name,
            length.name,
            1e-3 * load,
            1e-3 * FLOOR[0],
            1e-3 * FLOOR[1],
            study.units
        )
    })
}

#[cfg(test)]
mod tests {
    use super::stated;
    use hysteron_identify::study::unit::Quantity;

    #[test]
    fn units_of_comments() {
        for (line, force, length) in [
            ("# Units: kN, m, s, t.", vec!["kN"], vec!["m"]),
            ("set g 9.81 ;# units = kip, in, s", vec!["kip"], vec!["in"]),
            ("# Three spans. Units: kip, in, s.", vec!["kip"], vec!["in"]),
            ("# Unit: kip (4.448 kN)", vec!["kip", "kN"], vec![]),
            ("# community: kN", vec![], vec![]),
            ("set units: kN", vec![], vec![]),
            ("# Units of the section", vec![], vec![]),
        ] {
            let names = |q| stated(line, q).iter().map(|u| u.name).collect::<Vec<_>>();
            assert_eq!(names(Quantity::Force), force, "{line}");
            assert_eq!(names(Quantity::Length), length, "{line}");
        }
    }
}
