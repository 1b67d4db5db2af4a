//! The model looked at: where a block goes, what there is, how far it moves.

use crate::inspect::insertion::{Place, insert, place};
use crate::inspect::inventory::{Anatomy, shaken};
use crate::inspect::response::{Scales, Watched};
use hysteron_identify::study::{Blueprint, Observe, Role, Simulator, Study};
use hysteron_tcl::top_level;
use std::sync::Arc;

/// Devices that are watched at most: of a thousand alike a few tell as much.
const MOST: usize = 60;

/// Find where a block goes, and what the model has there. `None` for a script that analyses nothing.
pub(crate) fn look(blueprint: &Blueprint, study: &Arc<Study>, text: &str, values: &[f64]) -> Option<(Place, Anatomy)> {
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
pub(crate) fn watch(
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

#[cfg(test)]
pub(crate) mod tests {
    use super::look;
    use crate::inspect::inventory::Anatomy;
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

    /// What is seen of the model of a script, which makes an analysis.
    pub(crate) fn anatomy_of(text: &str) -> Anatomy {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tcl-like-inputs/pad_study/study.toml");
        let mut sources = SourceMap::default();
        let study = Arc::new(Study::load(&file, &mut sources).expect("a study"));
        let mut simulator = ScriptSimulator::new(study.clone(), Options::default(), Arc::default());
        let opening = simulator.open(&mut sources).expect("a script");
        look(&simulator.blueprint(), &study, text, &opening.values).expect("an analysis").1
    }

    #[test]
    fn a_frame_is_seen_whatever_its_transformation_and_order() {
        let anatomy = anatomy_of(PORTAL);
        let ends = |all: &[crate::inspect::columns::Column]| -> Vec<(i32, i32, i32)> {
            all.iter().map(|c| (c.tag, c.node, c.head)).collect()
        };
        // The second column was drawn from its head.
        assert_eq!(ends(&anatomy.columns), [(1, 1, 3), (2, 2, 4)]);
        assert_eq!(ends(&anatomy.girders), [(3, 3, 4)]);
        assert!(anatomy.shaken);
    }
    #[test]
    fn isolators_stand_on_the_ground_and_storeys_do_not() {
        let text = "model basic -ndm 1 -ndf 1\nforeach n {1 2 3} {node $n 0.}\nfix 1 1\nmass 2 1.\nmass 3 1.\n\
            uniaxialMaterial Elastic 1 1e3\nelement zeroLength 7 1 2 -mat 1 -dir 1\nelement zeroLength 8 2 3 -mat 1 -dir 1\n\
            timeSeries Constant 2\npattern UniformExcitation 2 1 -accel 2\nconstraints Plain\nsystem FullGeneral\n\
            integrator Newmark 0.5 0.25\nanalysis Transient\nanalyze 2 0.01\n";
        let anatomy = anatomy_of(text);
        let tags: Vec<Vec<i32>> = anatomy.grounded().iter().map(|g| g.iter().map(|d| d.tag).collect()).collect();
        assert_eq!(tags, [[7]]);
        assert!(anatomy.groups(false).is_empty() && anatomy.groups(true)[0].len() == 2);
    }
}
