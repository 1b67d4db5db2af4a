//! Runs of the script that show where commands can be inserted, what the model consists of and how far it moves.

use super::insertion::{InsertionPoint, insert, insertion_point};
use super::inventory::{Mass, ModelInventory};
use super::response::{NodeMotion, ResponseHistory, ResponseRanges};
use hysteron_identify::study::{ObservedChannel, Role, Simulator, SimulatorFactory, Study};
use hysteron_tcl::top_level;
use std::sync::Arc;

/// Largest number of devices, columns and girders that are recorded. Of many alike a few show the range.
const MAX_RECORDED: usize = 60;
/// Responses of nodes with mass: velocity, acceleration and displacement against the ground.
const NODE_RESPONSES: [&str; 3] = ["vel", "accel", "disp"];

/// Insertion point of a script, and the inventory of its model there. `None` if the script makes no analysis.
pub(crate) fn inspect_model(
    factory: &SimulatorFactory,
    study: &Arc<Study>,
    text: &str,
    values: &[f64],
) -> Option<(InsertionPoint, ModelInventory)> {
    let commands = top_level(text);
    let steps = |n: usize| {
        let end = commands.get(n).map_or(text.len(), |c| c.start);
        factory.simulator_of_script(study.clone(), &text[..end]).inspect_model(0, values, |e| e.steps)
    };
    // Bisection for the first command that makes a step: the commands before `low` make none, those before `high` some.
    let (mut low, mut high) = (0, commands.len());
    if steps(high) == 0 {
        return None;
    }
    while high - low > 1 {
        let middle = (low + high) / 2;
        if steps(middle) == 0 { low = middle } else { high = middle }
    }
    let before = factory.simulator_of_script(study.clone(), &text[..commands[low].start]);
    let mut inventory = before.inspect_model(0, values, ModelInventory::from_engine);
    let model_exists = !inventory.devices.is_empty() || !inventory.beams.is_empty();
    if model_exists {
        // The first steps may be those of the weight, with the excitation defined after them. A final `wipe` removes it.
        let wiped = commands[low..].iter().find(|c| c.name == "wipe").map_or(text.len(), |c| c.start);
        let whole = factory.simulator_of_script(study.clone(), &text[..wiped]);
        let inventory = whole.inspect_model(0, values, |e| {
            inventory.note_excitation(e.model());
            inventory
        });
        return Some((insertion_point(&commands, low, true), inventory));
    }
    // One command makes the model and analyses it, so that only the final model can be inspected.
    let inventory =
        factory.simulator_of_script(study.clone(), text).inspect_model(0, values, ModelInventory::from_engine);
    Some((InsertionPoint::FirstAnalyze, inventory))
}

/// Commands that record elements, with the columns of their outputs.
struct Recorders {
    commands: Vec<String>,
    observed: Vec<ObservedChannel>,
}

impl Recorders {
    fn add(&mut self, tag: i32, response: &str, columns: impl Iterator<Item = usize>) {
        let file = format!("hysteron-watch-{tag}-{response}.out");
        self.commands.push(format!("recorder Element -file {file} -time -ele {tag} {response}"));
        self.observe(&file, columns);
    }

    /// Records the translations of a node.
    fn add_node(&mut self, node: i32, response: &str, dofs: usize) {
        let file = format!("hysteron-watch-node-{node}-{response}.out");
        let all: Vec<String> = (1..=dofs).map(|d| d.to_string()).collect();
        self.commands.push(format!("recorder Node -file {file} -time -node {node} -dof {} {response}", all.join(" ")));
        self.observe(&file, 1..=dofs);
    }

    fn observe(&mut self, file: &str, columns: impl Iterator<Item = usize>) {
        self.observed.extend(columns.map(|column| ObservedChannel {
            channel: String::new(),
            unit: String::new(),
            output: file.to_owned(),
            column,
            measure: None,
            at: String::new(),
            weight: 1.0,
            shift: 0.0,
            values: vec![],
            variance: 1.0,
        }));
    }
}

/// Responses of devices and beams in all runs of a role; runs without a result are left out.
pub(crate) fn record_responses(
    factory: &SimulatorFactory,
    study: &Arc<Study>,
    text: &str,
    values: &[f64],
    at: &InsertionPoint,
    inventory: &ModelInventory,
    role: Role,
) -> ResponseRanges {
    record_responses_of(factory, study, values, inventory, role, &|recorders| insert(text, at, recorders))
}

/// The same of the script that `with_commands` makes of the commands of the recorders.
pub(crate) fn record_responses_of(
    factory: &SimulatorFactory,
    study: &Arc<Study>,
    values: &[f64],
    inventory: &ModelInventory,
    role: Role,
    with_commands: &dyn Fn(&[String]) -> String,
) -> ResponseRanges {
    let devices = &inventory.devices[..inventory.devices.len().min(MAX_RECORDED)];
    let (columns, girders) = (&inventory.columns, &inventory.girders);
    let beams: Vec<_> = columns.iter().take(MAX_RECORDED).chain(girders.iter().take(MAX_RECORDED)).collect();
    let moments = if inventory.ndm == 2 { &[3, 6][..] } else { &[5, 6, 11, 12] };
    let mut recorders = Recorders { commands: vec![], observed: vec![] };
    for d in devices {
        recorders.add(d.tag, "deformation", d.directions.iter().map(|direction| direction.columns[0] + 1));
        recorders.add(d.tag, "basicForce", d.directions.iter().flat_map(|d| &d.columns).map(|column| column + 1));
    }
    for beam in &beams {
        recorders.add(beam.tag, "localForce", moments.iter().copied());
    }
    // Velocities are those of transient analyses.
    let masses = if inventory.base_excited { &inventory.masses[..] } else { &[] };
    let masses = &masses[..masses.len().min(MAX_RECORDED)];
    let translations = |m: &Mass| inventory.ndm.min(m.mass.len());
    for m in masses {
        NODE_RESPONSES.iter().for_each(|response| recorders.add_node(m.node, response, translations(m)));
    }
    let text = with_commands(&recorders.commands);
    let mut recorded = (**study).clone();
    recorded.runs.iter_mut().for_each(|r| r.observe.clone_from(&recorders.observed));
    let recorded = Arc::new(recorded);
    let mut simulator = factory.simulator_of_script(recorded.clone(), &text);
    let mut ranges = ResponseRanges::default();
    for (number, run) in recorded.runs_of(role) {
        let Ok(channels) = simulator.simulate(number, values) else { continue };
        let mut channels = channels.into_iter();
        for d in devices {
            let deformations: Vec<Vec<f64>> = channels.by_ref().take(d.directions.len()).collect();
            for (direction, deformation) in d.directions.iter().zip(deformations) {
                let force = summed(channels.by_ref().take(direction.columns.len()));
                let history = ResponseHistory { times: run.recording.times.clone(), deformation, force };
                ranges.histories.insert((number, d.tag, direction.number), history);
            }
        }
        for beam in &beams {
            let of_ends = channels.by_ref().take(moments.len()).flatten().filter(|m| m.is_finite());
            let largest = ranges.end_moments.entry(beam.tag).or_default();
            *largest = of_ends.fold(*largest, |most, m| most.max(m.abs()));
        }
        for m in masses {
            let [velocities, accelerations, displacements] =
                NODE_RESPONSES.map(|_| channels.by_ref().take(translations(m)).map(|x| bounds(&x)).collect::<Vec<_>>());
            let largest = |[low, high]: [f64; 2]| high.max(-low);
            for (i, displacement_bounds) in displacements.into_iter().enumerate() {
                let [velocity, acceleration] = [&velocities, &accelerations].map(|of| largest(of[i]));
                let motion = ranges.node_motions.entry((m.node, i + 1)).or_default();
                *motion = motion.envelope(NodeMotion { velocity, acceleration, displacement_bounds });
            }
        }
    }
    ranges
}

/// Least sample that is finite, at most 0, and largest, at least 0.
fn bounds(x: &[f64]) -> [f64; 2] {
    x.iter().filter(|x| x.is_finite()).fold([0.0; 2], |[low, high], x| [x.min(low), x.max(high)])
}

/// Sum of series of one length.
fn summed(series: impl Iterator<Item = Vec<f64>>) -> Vec<f64> {
    let add = |a: Vec<f64>, b: Vec<f64>| a.iter().zip(b).map(|(a, b)| a + b).collect();
    series.reduce(add).unwrap_or_default()
}

#[cfg(test)]
pub(crate) mod tests {
    use super::inspect_model;
    use crate::inspect::frame_members::FrameMember;
    use crate::inspect::inventory::ModelInventory;
    use hysteron_engine::analysis::Options;
    use hysteron_identify::study::{ScriptSimulator, Study};
    use hysteron_tcl::diagnostic::SourceMap;
    use std::path::Path;
    use std::sync::Arc;

    /// A portal frame under P-Delta whose weight comes before the motion of the ground.
    const PORTAL: &str = "wipe\nmodel basic -ndm 2 -ndf 3\nnode 1 0. 0.\nnode 2 4. 0.\nnode 3 0. 3. -mass 1. 1. 0.\n\
        node 4 4. 3. -mass 1. 1. 0.\nfix 1 1 1 1\nfix 2 1 1 1\ngeomTransf PDelta 1\n\
        element elasticBeamColumn 1 1 3 1e3 1e3 0.3 1\nelement elasticBeamColumn 2 4 2 1e3 1e3 0.3 1\n\
        element elasticBeamColumn 3 3 4 1e3 1e3 1e3 1\npattern Plain 1 Linear { load 3 0. -1. 0. }\n\
        constraints Plain\nsystem FullGeneral\nalgorithm Newton\nintegrator LoadControl 1.0\nanalysis Static\nanalyze 1\n\
        loadConst -time 0.0\nwipeAnalysis\ntimeSeries Constant 2\npattern UniformExcitation 2 1 -accel 2\n\
        constraints Plain\nsystem FullGeneral\nintegrator Newmark 0.5 0.25\nanalysis Transient\nanalyze 5 0.01\nwipe\n";

    /// Inventory of the model of a script that makes an analysis.
    pub(crate) fn inventory_of(text: &str) -> ModelInventory {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tcl-like-inputs/pad_study/study.toml");
        let mut sources = SourceMap::default();
        let study = Arc::new(Study::load(&file, &mut sources).expect("a study"));
        let mut simulator = ScriptSimulator::new(study.clone(), Options::default(), Arc::default());
        let initial_run = simulator.run_initially(&mut sources).expect("a script");
        inspect_model(&simulator.factory(), &study, text, &initial_run.values).expect("an analysis").1
    }

    #[test]
    fn columns_and_girders_are_found_for_any_transformation_and_node_order() {
        let inventory = inventory_of(PORTAL);
        let ends =
            |all: &[FrameMember]| -> Vec<(i32, i32, i32)> { all.iter().map(|c| (c.tag, c.foot, c.head)).collect() };
        // The second column was drawn from its head.
        assert_eq!(ends(&inventory.columns), [(1, 1, 3), (2, 2, 4)]);
        assert_eq!(ends(&inventory.girders), [(3, 3, 4)]);
        assert!(inventory.base_excited);
    }
    #[test]
    fn isolators_are_ground_supported_and_storeys_are_not() {
        let text = "model basic -ndm 1 -ndf 1\nforeach n {1 2 3} {node $n 0.}\nfix 1 1\nmass 2 1.\nmass 3 1.\n\
            uniaxialMaterial Elastic 1 1e3\nelement zeroLength 7 1 2 -mat 1 -dir 1\nelement zeroLength 8 2 3 -mat 1 -dir 1\n\
            timeSeries Constant 2\npattern UniformExcitation 2 1 -accel 2\nconstraints Plain\nsystem FullGeneral\n\
            integrator Newmark 0.5 0.25\nanalysis Transient\nanalyze 2 0.01\n";
        let inventory = inventory_of(text);
        let tags: Vec<Vec<i32>> =
            inventory.ground_supported_groups().iter().map(|g| g.iter().map(|d| d.tag).collect()).collect();
        assert_eq!(tags, [[7]]);
        assert!(inventory.device_groups(false).is_empty() && inventory.device_groups(true)[0].len() == 2);
    }
}
