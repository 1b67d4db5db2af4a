//! Parameters of every uniaxial material: each number that it was made from can be changed by its name.

use super::driver::SingleElement;
use super::every_bearing;
use super::every_kind::MATERIALS;
use super::parts::PARTS;
use super::script::run;
use hysteron::material::{Material, Slot, Strain};
use hysteron::parameter::{NewValue, ParameterError};

/// The material of some words, @ being the tag, beside its components.
fn made(words: &str) -> Material {
    let words = words.replacen('@', "77", 1);
    let script = format!("model basic -ndm 1 -ndf 1\n{PARTS}uniaxialMaterial {words}\n");
    run(&script).done().interp.host.builder.definitions.materials.get(77).unwrap().clone()
}

/// Stresses of a path of strains.
fn stresses(material: &Material, amplitude: f64) -> Vec<f64> {
    let slot = Slot::new(material.clone(), 1, 0);
    let mut state = vec![0.0; slot.len()];
    slot.init(&mut state);
    let mut before = 0.0;
    let mut out = vec![];
    for i in 0..60 {
        let t = f64::from(i) * 0.3;
        let value = amplitude * 0.1 * f64::from(i % 20) * t.sin() / 2.0;
        let mut next = state.clone();
        let strain = Strain { value, rate: (value - before) / 0.01, dt: 0.01 };
        match slot.update(&state, strain, &mut next) {
            Ok(s) => out.push(s.value),
            Err(_) => out.push(f64::NAN),
        }
        (state, before) = (next, value);
    }
    out
}

fn same(a: &[f64], b: &[f64]) -> bool {
    a.iter().zip(b).all(|(x, y)| x.to_bits() == y.to_bits() || x.is_nan() && y.is_nan())
}

/// Every number has a name, a change of it gives the material that the changed words give, and its own value gives
/// the same material.
#[test]
fn each_number_of_each_material_is_a_parameter() {
    let (mut numbers, mut nameless) = (0, vec![]);
    for (words, amplitude) in MATERIALS {
        let material = made(words);
        let kind = words.split(' ').next().unwrap();
        let of = material.numbers();
        // Whole numbers are switches, counts and tags as well.
        let decimal = |w: &&str| w.contains(['.', 'e']) && w.parse::<f64>().is_ok();
        let given = words.split_whitespace().skip(2).filter(decimal).count();
        if of.len() < given {
            nameless.push(format!("{kind}: {} of {given}", of.len()));
        }
        let before = stresses(&material, *amplitude);
        for (name, value) in &of {
            let asked: Vec<&str> = name.split(' ').collect();
            // As in OpenSees, E of the law Elastic is that of both sides, and ElasticPP has parameters of its own.
            if (kind, name.as_str()) == ("Elastic", "E")
                || material.law().with_parameter(&asked, NewValue::Present).is_ok()
            {
                continue;
            }
            let (again, told) = material
                .with_parameter(&asked, NewValue::Is(*value))
                .unwrap_or_else(|e| panic!("{words}: {name}: {e:?}"));
            assert_eq!(told, *value, "{words}: {name}");
            assert!(same(&before, &stresses(&again, *amplitude)), "{words}: {name} = {value}");
            let other = if *value == 0.0 { 0.01 } else { value * 1.05 };
            match material.with_parameter(&asked, NewValue::Is(other)) {
                Ok((changed, told)) => {
                    assert_eq!(told, *value, "{words}: {name}");
                    let (_, now) = changed.with_parameter(&asked, NewValue::Present).unwrap();
                    assert_eq!(now, other, "{words}: {name}");
                    let (back, _) = changed.with_parameter(&asked, NewValue::Is(*value)).unwrap();
                    assert!(same(&before, &stresses(&back, *amplitude)), "{words}: {name} and back");
                }
                Err(ParameterError::Refused(_)) => {}
                Err(ParameterError::Unknown) => panic!("{words}: {name}"),
            }
            numbers += 1;
        }
    }
    assert_eq!(nameless, Vec::<String>::new());
    assert!(numbers > 900, "{numbers}");
}

/// A number that is left out is a parameter too: a change gives the material with all its words. OpenSees' names stand
/// for numbers of the usage line, one name for those of both sides.
#[test]
fn numbers_left_out_and_names_of_opensees_are_parameters() {
    for (words, name, value, changed) in [
        ("Steel01 @ 2. 200. 0.05", "a1", 0.3, "Steel01 @ 2. 200. 0.05 0.3 55. 0. 55."),
        ("Steel01 @ 2. 200. 0.05", "a3", 0.4, "Steel01 @ 2. 200. 0.05 0. 55. 0.4 55."),
        ("Steel01 @ 2. 200. 0.05", "sigmaY", 2.5, "Steel01 @ 2.5 200. 0.05"),
        ("Steel02 @ 2. 200. 0.05", "R0", 12.0, "Steel02 @ 2. 200. 0.05 12. 0.925 0.15"),
        ("Steel02 @ 2. 200. 0.05", "a3", 0.2, "Steel02 @ 2. 200. 0.05 15. 0.925 0.15 0. 1. 0.2 1."),
        ("Steel02 @ 2. 200. 0.05 15. 0.9 0.2", "sig0", 0.4, "Steel02 @ 2. 200. 0.05 15. 0.9 0.2 0. 1. 0. 1. 0.4"),
        ("Elastic @ 200.", "eta", 3.0, "Elastic @ 200. 3."),
        ("Elastic @ 200.", "E", 150.0, "Elastic @ 150."),
        ("Elastic @ 200.", "Epos", 150.0, "Elastic @ 150. 0. 200."),
        ("Elastic @ 200. 0. 100.", "E", 150.0, "Elastic @ 150."),
        ("ENT @ 200.", "a", 0.05, "ENT @ 200. 0.05"),
        ("ENT @ 200. 0.05", "b", 2.0, "ENT @ 200. 0.05 2."),
        ("Viscous @ 3. 0.5", "Alpha", 0.8, "Viscous @ 3. 0.8"),
        ("ElasticBilin @ 200. 50. 0.01 100. 30. -0.02", "eps2", 0.03, "ElasticBilin @ 200. 50. 0.03 100. 30. -0.03"),
        (
            "Hysteretic @ 1. 0.005 1.5 0.02 -1.2 -0.005 -1.6 -0.02 0.8 0.3 0. 0.",
            "mom2",
            1.7,
            "Hysteretic @ 1. 0.005 1.7 0.02 -1.2 -0.005 -1.7 -0.02 0.8 0.3 0. 0.",
        ),
        (
            "Hysteretic @ 1. 0.005 1.5 0.02 -1.2 -0.005 -1.6 -0.02 0.8 0.3 0. 0.",
            "beta",
            0.3,
            "Hysteretic @ 1. 0.005 1.5 0.02 -1.2 -0.005 -1.6 -0.02 0.8 0.3 0. 0. 0.3",
        ),
    ] {
        let material = made(words);
        let (by_name, _) = material.with_parameter(&[name], NewValue::Is(value)).unwrap();
        let now = stresses(&by_name, 0.05);
        assert!(same(&now, &stresses(&made(changed), 0.05)), "{words}: {name}");
        assert!(!same(&now, &stresses(&material, 0.05)), "{words}: {name} changes nothing");
    }
}

/// Force of a bearing at the end of a short path.
fn forces(script: &str) -> Vec<f64> {
    let ran = run(script).done();
    let element = ran.interp.host.engine.model().elements[0].element.clone();
    let mut e = SingleElement::of(element);
    let n = e.element.dofs();
    let mut out = vec![];
    for step in 1..=20 {
        let mut u = vec![0.0; n];
        u[n / 2] = 0.004 * f64::from(step);
        u[n / 2 + 1] = -0.001 * f64::from(step);
        out.extend(e.force(&u));
        e.commit();
    }
    out
}

/// Every decimal number of every bearing has a name; a change by it gives the bearing of the changed words.
#[test]
fn each_number_of_each_bearing_is_a_parameter() {
    let (mut changed, mut nameless) = (0, vec![]);
    for script in every_bearing::scripts() {
        let (parts, command) = script.trim_end().rsplit_once('\n').unwrap();
        let mut ran = run(&script).done();
        let names = hysteron::opensees::numbers_of_element(&mut ran.interp, 1);
        let words: Vec<&str> = command.split(' ').collect();
        for (i, word) in words.iter().enumerate().skip(5) {
            let Ok(value) = word.parse::<f64>() else { continue };
            let Some((_, name)) = names.iter().find(|(place, _)| *place == i) else {
                if word.contains(['.', 'e']) && !words[..i].contains(&"-orient") {
                    nameless.push(format!("{} {word}", words[1]));
                }
                continue;
            };
            let mut other = words.clone();
            let text = format!("{:e}", value * 1.02);
            other[i] = &text;
            let direct = format!("{parts}\n{}\n", other.join(" "));
            let updated = format!("{script}parameter 1 element 1 {name}\nupdateParameter 1 {text}\n");
            assert!(same(&forces(&direct), &forces(&updated)), "{command}: {name}");
            changed += 1;
        }
    }
    assert_eq!(nameless, Vec::<String>::new());
    assert!(changed > 200, "{changed}");
}
