//! The model looked at: where a block goes, what there is, how far it moves.

use super::anatomy::{Anatomy, shaken};
use super::insertion::{Place, insert, place};
use super::scale::{Scales, Watched};
use crate::script::top_level;
use crate::study::{Blueprint, Observe, Role, Simulator, Study};
use std::sync::Arc;

/// Devices that are watched at most: of a thousand alike a few tell as much.
const MOST: usize = 60;

/// Find where a block goes, and what the model has there. `None` for a script that analyses nothing.
pub(super) fn look(blueprint: &Blueprint, study: &Arc<Study>, text: &str, values: &[f64]) -> Option<(Place, Anatomy)> {
    let commands = top_level(text);
    let steps = |n: usize| {
        let end = commands.get(n).map_or(text.len(), |c| c.start);
        blueprint.simulator_of(study.clone(), &text[..end]).look(0, values, |e| e.steps)
    };
    // The first command that makes a step: those before number `low` make none, those before `high` some.
    let (mut low, mut high) = (0, commands.len());
    if steps(high) == 0 {
        return None;
    }
    while high - low > 1 {
        let middle = (low + high) / 2;
        if steps(middle) == 0 { low = middle } else { high = middle }
    }
    let before = blueprint.simulator_of(study.clone(), &text[..commands[low].start]);
    let mut anatomy = before.look(0, values, Anatomy::of);
    let made = !anatomy.devices.is_empty() || !anatomy.beams.is_empty();
    if made {
        // The first steps may be those of the weight, and the ground moves after them; what is wiped in the end tells nothing.
        let wiped = commands[low..].iter().find(|c| c.name == "wipe").map_or(text.len(), |c| c.start);
        let whole = blueprint.simulator_of(study.clone(), &text[..wiped]);
        anatomy.shaken |= whole.look(0, values, |e| shaken(e.model()));
        return Some((place(&commands, low, true), anatomy));
    }
    // The model is made and analysed by one command: it is looked at as it stands in the end.
    let anatomy = blueprint.simulator_of(study.clone(), text).look(0, values, Anatomy::of);
    Some((Place::FirstAnalyze, anatomy))
}

/// Watch the devices in all fitted runs.
pub(super) fn watch(
    blueprint: &Blueprint,
    study: &Arc<Study>,
    text: &str,
    values: &[f64],
    at: &Place,
    anatomy: &Anatomy,
) -> Scales {
    let devices = &anatomy.devices[..anatomy.devices.len().min(MOST)];
    let beams: Vec<_> = anatomy.columns.iter().take(MOST).chain(anatomy.girders.iter().take(MOST)).collect();
    let moments = if anatomy.ndm == 2 { &[3, 6][..] } else { &[5, 6, 11, 12] };
    let mut block = vec![];
    let mut observe = vec![];
    let mut record = |tag: i32, what: &str, columns: &mut dyn Iterator<Item = usize>| {
        let file = format!("hysteron-watch-{tag}-{what}.out");
        block.push(format!("recorder Element -file {file} -time -ele {tag} {what}"));
        observe.extend(columns.map(|column| Observe {
            channel: String::new(),
            unit: String::new(),
            output: file.clone(),
            column,
            at: String::new(),
            weight: 1.0,
            values: vec![],
            variance: 1.0,
        }));
    };
    for d in devices {
        for what in ["deformation", "basicForce"] {
            record(d.tag, what, &mut d.directions.iter().map(|direction| direction.column + 1));
        }
    }
    for column in &beams {
        record(column.tag, "localForce", &mut moments.iter().copied());
    }
    let text = insert(text, at, &block);
    let mut watching = (**study).clone();
    watching.runs.iter_mut().for_each(|r| r.observe.clone_from(&observe));
    let watching = Arc::new(watching);
    let mut simulator = blueprint.simulator_of(watching.clone(), &text);
    let mut scales = Scales::default();
    for (run, spec) in watching.runs_of(Role::Fit) {
        let Ok(channels) = simulator.simulate(run, values) else { continue };
        let mut channels = channels.into_iter();
        for d in devices {
            let e: Vec<Vec<f64>> = channels.by_ref().take(d.directions.len()).collect();
            let q: Vec<Vec<f64>> = channels.by_ref().take(d.directions.len()).collect();
            for ((direction, e), q) in d.directions.iter().zip(e).zip(q) {
                let times = spec.recording.times.clone();
                scales.watched.insert((run, d.tag, direction.number), Watched { times, e, q });
            }
        }
        for column in &beams {
            let of_ends = channels.by_ref().take(moments.len()).flatten().filter(|m| m.is_finite());
            let largest = scales.moments.entry(column.tag).or_default();
            *largest = of_ends.fold(*largest, |most, m| most.max(m.abs()));
        }
    }
    scales
}
