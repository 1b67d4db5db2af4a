//! Values that only one side states: sizes, units, the order of the bounds, elements that the study names or leaves out.

use super::agreement::{StatedValues, place};
use super::script_model::ScriptModel;
use super::study::{BearingType, Study};
use crate::mistake::{Mistake, key};
use hysteron_identify::study::unit::{Quantity, unit};

/// Mass times gravity over the weight of one floor, at least and at most: part of a floor's mass may be lumped elsewhere.
const FLOOR_MASS: [f64; 2] = [0.2, 5.0];
/// Acceleration of gravity in m/s², at least and at most.
const GRAVITY: [f64; 2] = [9.6, 10.0];
/// Critical load over the largest gravity load of a type, at most.
const CRITICAL: f64 = 500.0;
/// Tension of a bearing under gravity over the mean load of all, at most.
const LIFTED: f64 = 0.01;
/// Weight of substructures over that of all mass below the bearings, at most.
const SUBSTRUCTURE: f64 = 1.05;
/// Elements that a message lists.
const LISTED: usize = 5;

/// Compare what the agreement of values does not see.
///
/// # Errors
/// Study and script contradict each other. The message has both places and the ratio.
pub(super) fn compare(study: &mut Study, stated: &StatedValues, model: &ScriptModel) -> Result<(), Mistake> {
    length_unit(study)?;
    order_of_bounds(study)?;
    floor_masses(study, stated, model)?;
    sizes(study, model)?;
    substructures(study, model)?;
    elements(study, model)?;
    unlisted(study, model);
    Ok(())
}

/// The acceleration of gravity says what the unit of length is.
fn length_unit(study: &Study) -> Result<(), Mistake> {
    let Some(length) = unit(&study.units[1]).filter(|u| u.quantity == Quantity::Length) else { return Ok(()) };
    let found = study.gravity * length.factor;
    if (GRAVITY[0]..=GRAVITY[1]).contains(&found) {
        return Ok(());
    }
    let expected = 9.81 / length.factor;
    let message = format!(
        "gravity = {}, but the unit of length is {} (units = {:?}), in which gravity is {expected:.5}: ratio {:.4}",
        study.gravity,
        length.name,
        study.units,
        study.gravity / expected
    );
    Err(Mistake::new(key!["gravity"], message))
}

/// The lower bound is not above the upper one.
fn order_of_bounds(study: &Study) -> Result<(), Mistake> {
    for (kind, b) in study.bearings.iter().enumerate() {
        for (of, letter) in ["Q_d", "K_d"].into_iter().enumerate() {
            let [low, high] = ["lower", "upper"].map(|bound| study.factor(b, bound, of));
            if low > high {
                let message = format!(
                    "the factors of the lower bound of {} give {low:.4} times the nominal {letter}, those of the upper bound \
                     {high:.4} times: ratio {:.4}. Are lower and upper exchanged?",
                    b.name,
                    low / high
                );
                return Err(Mistake::new(key!["bearing", kind, "lower"], message));
            }
        }
    }
    Ok(())
}

/// A floor has mass where it has weight.
fn floor_masses(study: &Study, stated: &StatedValues, model: &ScriptModel) -> Result<(), Mistake> {
    for (k, (floor, weight)) in study.floors.iter().zip(&stated.floors).enumerate() {
        let (Some(s), Some(mass)) = (weight, model.mass_at(floor.node)) else { continue };
        let by_mass = mass * study.gravity;
        let ratio = by_mass / s;
        if *s > 0.0 && !(FLOOR_MASS[0]..=FLOOR_MASS[1]).contains(&ratio) {
            let message = format!(
                "weight = {s} of the floor at node {}, but the mass of \"{}\" at its elevation times gravity is {by_mass:.6}: \
                 ratio {ratio:.4}. Is a mass missing?",
                floor.node,
                study.script.display()
            );
            return Err(Mistake::new(key!["floor", k, "weight"], message));
        }
    }
    Ok(())
}

/// Bearings are smaller than the distances between them, and their critical loads are of the order of their loads.
fn sizes(study: &Study, model: &ScriptModel) -> Result<(), Mistake> {
    let spacing = model.spacing();
    let script = study.script.display();
    for (kind, b) in study.bearings.iter().enumerate() {
        for (key, value) in [("diameter", b.diameter), ("displacement", b.displacement)] {
            if let (Some(value), Some(spacing)) = (value, spacing)
                && value > spacing
            {
                let message = format!(
                    "{key} = {value} of {}, but the next two bearings of \"{script}\" are {spacing:.6} apart: ratio {:.4}. Is it in \
                     another unit of length?",
                    b.name,
                    value / spacing
                );
                return Err(Mistake::new(key!["bearing", kind, key], message));
            }
        }
        if let (Some(capacity), Some(diameter)) = (b.displacement, b.diameter)
            && capacity >= diameter
        {
            let message = format!(
                "displacement = {capacity} of {} is not less than diameter = {diameter}: a bearing that far away has no \
                 overlapping area, and carries nothing",
                b.name
            );
            return Err(Mistake::new(key!["bearing", kind, "displacement"], message));
        }
        let load = model.bearings.iter().filter(|m| m.kind == kind).map(|m| m.gravity).fold(0.0, f64::max);
        if let Some(critical) = b.critical_load.filter(|c| load > 0.0 && *c > CRITICAL * load) {
            let bearing = model.typical(kind).map_or(String::new(), |t| place(study, t));
            let message = format!(
                "critical_load = {critical} of {}, but its bearings carry {load:.6} under gravity at most ({bearing}): ratio \
                 {:.4}. Is it in another unit of force?",
                b.name,
                critical / load
            );
            return Err(Mistake::new(key!["bearing", kind, "critical_load"], message));
        }
    }
    Ok(())
}

/// Gravity presses on every bearing. The second node of a bearing is the upper one.
///
/// # Errors
/// One stands upside down, or is in tension.
pub(super) fn upside_down(study: &Study, model: &ScriptModel) -> Result<(), Mistake> {
    let mean = model.gravity() / model.bearings.len() as f64;
    for b in &model.bearings {
        let BearingType { name, tags, .. } = &study.bearings[b.kind];
        let key = || key!["bearing", b.kind, "tags", tags.iter().position(|t| *t == b.tag).unwrap_or(0)];
        if b.rise < 0.0 {
            let message = format!(
                "the second node of the bearing {} of {name} is {:.6} below its first one ({}): expected the lower node first",
                b.tag,
                -b.rise,
                place(study, b)
            );
            return Err(Mistake::new(key(), message));
        }
        if mean > 0.0 && b.gravity < -LIFTED * mean {
            let message = format!(
                "the bearing {} of {name} has a tension of {:.6} under gravity, and the mean load of all bearings is {mean:.6} \
                 ({}): expected compression. Its nodes are exchanged, or the loads lift it",
                b.tag,
                -b.gravity,
                place(study, b)
            );
            return Err(Mistake::new(key(), message));
        }
    }
    Ok(())
}

/// Substructures that move with the bridge weigh no more than all that stands below the bearings.
fn substructures(study: &Study, model: &ScriptModel) -> Result<(), Mistake> {
    let below = model.mass_below() * study.gravity;
    if study.substructure_weight <= SUBSTRUCTURE * below {
        return Ok(());
    }
    let message = format!(
        "substructure_weight = {}, but all mass of \"{}\" below the bearings times gravity is {below:.6}: expected no more",
        study.substructure_weight,
        study.script.display()
    );
    Err(Mistake::new(key!["substructure_weight"], message))
}

/// Members and elements of contact are elements of the script.
fn elements(study: &Study, model: &ScriptModel) -> Result<(), Mistake> {
    let known = |tag: i64| i32::try_from(tag).ok().and_then(|t| model.model().element(t)).is_some();
    let members = study.members.iter().enumerate().map(|(i, t)| (key!["members", i], "members", *t));
    let states = study.performance.limit_states.iter().enumerate();
    let contacts = states.flat_map(|(k, l)| l.elements.iter().enumerate().map(move |(i, t)| (k, i, *t)));
    let contacts =
        contacts.map(|(k, i, t)| (key!["limit_state", k, "elements", i], "elements of a [[limit_state]]", t));
    match members.chain(contacts).find(|(_, _, tag)| !known(*tag)) {
        None => Ok(()),
        Some((key, what, tag)) => {
            let message = format!("{what}: {tag} is no element of \"{}\"", study.script.display());
            Err(Mistake::new(key, message))
        }
    }
}

/// Elements of the classes of the bearings that the study does not list are said.
fn unlisted(study: &mut Study, model: &ScriptModel) {
    let classes: std::collections::BTreeSet<&str> = model.bearings.iter().map(|b| b.class).collect();
    let is_listed = |tag: i32| model.bearings.iter().any(|b| b.tag == i64::from(tag));
    let found: Vec<String> = model
        .model()
        .elements
        .iter()
        .filter(|e| classes.contains(e.element.class().name) && !is_listed(e.tag))
        .map(|e| e.tag.to_string())
        .collect();
    if found.is_empty() {
        return;
    }
    let more = if found.len() > LISTED { format!(" and {} more", found.len() - LISTED) } else { String::new() };
    study.agreement.remarks.push(format!(
        "\"{}\" has elements of the class of the bearings that no [[bearing]] lists: {}{more}",
        study.script.display(),
        found[..found.len().min(LISTED)].join(", ")
    ));
}
