//! Words that are meant as numbers or lists of numbers.

use hysteron_tcl::{Value, lookalike};

/// An integer, also one that is written as a number with a point.
pub(super) fn as_int(value: &Value) -> Option<i32> {
    if let Some(i) = value.as_i64() {
        return i32::try_from(i).ok();
    }
    let x = value.as_f64()?;
    (x.fract() == 0.0 && x.abs() < f64::from(i32::MAX)).then_some(x as i32)
}

/// Help about a word that was meant as a list of numbers: the first thing in it that is none.
pub(super) fn no_list_of_numbers(value: &Value) -> Option<String> {
    let text = value.as_str();
    let is_number = |w: &str| w.parse::<f64>().is_ok();
    let mut parts = text.split([',', ';']).map(str::trim).filter(|w| !w.is_empty());
    if text.contains([',', ';']) && parts.all(|part| part.split_whitespace().all(is_number)) {
        return Some("blanks stand between the numbers of a list, no commas and no semicolons".into());
    }
    let list = value.to_list().ok().filter(|l| !l.is_empty())?;
    if list.iter().all(|v| numbers(v).is_some()) {
        return Some("it is a list of lists: \"[concat {*}$list]\" makes one list of them".into());
    }
    let (i, wrong) = list.iter().enumerate().find(|(_, v)| v.as_f64().is_none_or(|x| !x.is_finite()))?;
    if i == 0 {
        return None;
    }
    let help = format!("element {} of the list is no number: \"{wrong}\"", i + 1);
    Some(lookalike(&wrong.as_str()).map_or(help.clone(), |why| format!("{help}; {why}")))
}

/// The elements of a list of numbers.
pub(super) fn numbers(value: &Value) -> Option<Vec<f64>> {
    let list = value.to_list().ok()?;
    list.iter().map(|v| v.as_f64().filter(|x| x.is_finite())).collect()
}
