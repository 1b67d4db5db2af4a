//! Elements around others have the roles of the element inside, with its answers.

use super::every_bearing;
use super::every_kind::{ELEMENTS, element};
use super::script::run;
use hysteron::element::amendment::{Amended, Damping, Hinged};
use hysteron::element::damping::{Damped, DampingLaw, ElementDamping};
use hysteron::element::{Element, ElementInput, ElementLoad, ElementOutput, Histories, MatrixMask, Roles};
use hysteron::material::{Elastic, Material};
use nalgebra::Vector3;
use std::collections::BTreeSet;
use std::sync::Arc;

/// Names of the roles of an element. A role that is not here does not compile.
fn names(e: &dyn Element) -> BTreeSet<&'static str> {
    let Roles {
        bearing,
        mass,
        inertance,
        loads,
        parameters,
        basic_rows,
        basic_forces,
        own_damping,
        overload,
        softening,
        stretch,
        exhausted,
        outside_range,
        euler_load,
        small_beam,
        kept_tangent,
        lockstep,
        renews_tangent,
        force_labels: _,
        opensees,
    } = e.roles();
    let all = [
        ("bearing", bearing.is_some()),
        ("mass", mass.is_some()),
        ("inertance", inertance.is_some()),
        ("loads", loads.is_some()),
        ("parameters", parameters.is_some()),
        ("basic_rows", basic_rows.is_some()),
        ("basic_forces", basic_forces.is_some()),
        ("own_damping", own_damping.is_some()),
        ("overload", overload.is_some()),
        ("softening", softening.is_some()),
        ("stretch", stretch.is_some()),
        ("exhausted", exhausted.is_some()),
        ("outside_range", outside_range.is_some()),
        ("euler_load", euler_load.is_some()),
        ("small_beam", small_beam.is_some()),
        ("kept_tangent", kept_tangent.is_some()),
        ("lockstep", lockstep.is_some()),
        ("renews_tangent", renews_tangent),
        ("calls", opensees.calls.is_some()),
    ];
    all.into_iter().filter_map(|(name, has)| has.then_some(name)).collect()
}

/// Roles that would go past the wrapper.
const OF_THE_INNER_ELEMENT_ALONE: [&str; 5] = ["basic_forces", "small_beam", "kept_tangent", "lockstep", "calls"];

/// The element in each wrapper that takes it, with the wrapper's name.
fn wrapped(inner: &Arc<dyn Element>) -> Vec<(&'static str, Arc<dyn Element>)> {
    let mut all: Vec<(_, Arc<dyn Element>)> = vec![];
    if let Ok(e) = Amended::new(inner.clone(), Arc::new(Damping { coefficient: 3.0, power: 0.7 }), &[]) {
        all.push(("amended", Arc::new(e)));
    }
    let law = DampingLaw::SecantStiffness { beta: 0.02 };
    let damping = Arc::new(ElementDamping { law, window: [0.0, 1e9], factor: None });
    if let Ok(e) = Damped::new(inner.clone(), damping) {
        all.push(("damped", Arc::new(e)));
    }
    if let Ok(e) = Hinged::new(inner.clone(), Vector3::new(3.0, 0.0, 4.0), &[0], Material::new(Elastic::new(900.0))) {
        all.push(("hinged", Arc::new(e)));
    }
    all
}

fn virgin(e: &dyn Element) -> Vec<f64> {
    let mut state = vec![0.0; e.state_len()];
    e.init(&mut state);
    state
}

/// Sums of a uniform load, where the element takes it.
fn load_sums(e: &dyn Element) -> Option<Vec<f64>> {
    let mut sums = vec![0.0; e.load_len()];
    let load = ElementLoad::Distributed { span: (0.0, 1.0), y: (-2.0, -2.0), z: (1.0, 1.0), x: (0.5, 0.5) };
    e.add_load(&load, 1.5, &mut sums).ok().map(|()| sums)
}

/// Compares roles and answers. Every state variable of the inner element is changed, so that a wrong part of the state gives
/// another answer.
fn compare(name: &str, inner: &dyn Element, outer: &dyn Element) -> Result<(), String> {
    let own = names(inner);
    let missing: Vec<_> =
        own.difference(&names(outer)).filter(|n| !OF_THE_INNER_ELEMENT_ALONE.contains(n)).copied().collect();
    if !missing.is_empty() {
        return Err(format!("{} {name} loses {missing:?}", inner.class().name));
    }
    let mut state = virgin(inner);
    state.iter_mut().enumerate().for_each(|(i, x)| *x += 0.01 * (i as f64 + 1.0));
    let mut whole = virgin(outer);
    whole[..state.len()].copy_from_slice(&state);
    let disp: Vec<f64> = (0..inner.dofs()).map(|i| 0.01 * (i as f64).sin()).collect();
    let same = [
        ("bearing", inner.bearing() == outer.bearing()),
        ("mass", inner.mass() == outer.mass()),
        ("inertance", inner.inertance() == outer.inertance()),
        ("loads", inner.load_len() == outer.load_len() && load_sums(inner) == load_sums(outer)),
        ("basic rows", inner.basic_rows() == outer.basic_rows()),
        ("overload", inner.overload(&state) == outer.overload(&whole)),
        ("softening", inner.softening(&state) == outer.softening(&whole)),
        ("stretch", inner.stretch(&disp) == outer.stretch(&disp)),
        ("exhausted", inner.exhausted(&state) == outer.exhausted(&whole)),
        ("Euler load", inner.euler_load() == outer.euler_load()),
        ("labels", inner.force_labels() == outer.force_labels()),
        ("names", inner.probe_names().iter().all(|n| outer.probe_names().contains(n))),
        ("ground inertia", inner.opensees().ground_inertia == outer.opensees().ground_inertia),
        ("initial stiffness", inner.opensees().initial_is_current == outer.opensees().initial_is_current),
    ];
    match same.iter().find(|(_, same)| !same) {
        Some((what, _)) => Err(format!("{} {name} has another answer: {what}", inner.class().name)),
        None => Ok(()),
    }
}

/// Elements of the tables, and bearings.
fn every_element() -> Vec<Arc<dyn Element>> {
    let bearings =
        every_bearing::scripts().map(|s| run(&s).done().interp.host.engine.model().elements[0].element.clone());
    ELEMENTS.iter().map(|row| element(row).0.element).chain(bearings).collect()
}

#[test]
fn wrappers_keep_every_role() {
    let (mut wrong, mut seen) = (vec![], BTreeSet::new());
    for inner in every_element() {
        for (name, outer) in wrapped(&inner) {
            seen.extend(names(inner.as_ref()).into_iter().map(|role| (name, role)));
            wrong.extend(compare(name, inner.as_ref(), outer.as_ref()).err());
            for (second, both) in wrapped(&outer).into_iter().filter(|(second, _)| *second != name) {
                wrong.extend(compare(second, outer.as_ref(), both.as_ref()).err());
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    // The tables have elements with these roles, so that the comparison has something to compare.
    for pair in [
        ("amended", "mass"),
        ("amended", "parameters"),
        ("amended", "overload"),
        ("amended", "softening"),
        ("amended", "stretch"),
        ("damped", "loads"),
        ("damped", "exhausted"),
        ("damped", "euler_load"),
        ("hinged", "loads"),
        ("hinged", "exhausted"),
        ("hinged", "euler_load"),
    ] {
        assert!(seen.contains(&pair), "no element with {pair:?}");
    }
}

/// The tangent from the history is that of the evaluation which wrote it, to the bit.
#[test]
fn tangents_in_a_history_are_those_of_the_evaluation() {
    let mut seen = BTreeSet::new();
    for e in every_element().into_iter().filter(|e| e.roles().kept_tangent.is_some()) {
        let (n, committed) = (e.dofs(), virgin(e.as_ref()));
        let disp: Vec<f64> = (0..n).map(|i| 1e-4 * (1.0 + i as f64).sin()).collect();
        let (mut next, load) = (committed.clone(), vec![0.0; e.load_len()]);
        let (mut force, mut tangent, mut kept) = (vec![0.0; n], vec![0.0; n * n], vec![0.0; n * n]);
        let motion = ElementInput {
            disp: &disp,
            vel: &vec![0.0; n],
            accel: &[],
            load: &load,
            still: true,
            opensees: None,
            dt: 0.0,
            time: 0.0,
            dynamic: false,
        };
        let output =
            ElementOutput { force: &mut force, tangent: Some(&mut tangent), damping: None, part: MatrixMask::ALL };
        e.respond(&motion, &mut Histories { committed: &committed, trial: &mut next }, output).expect("a response");
        e.roles().kept_tangent.expect("asked above").add_kept_tangent(&disp, &next, &mut kept);
        assert_eq!(kept, tangent, "{}", e.class().name);
        assert!(kept.iter().any(|k| *k != 0.0));
        seen.insert(e.class().name);
    }
    for class in ["ForceBeamColumn2d", "DispBeamColumn2d"] {
        assert!(seen.contains(class), "{class} is not among {seen:?}");
    }
}
