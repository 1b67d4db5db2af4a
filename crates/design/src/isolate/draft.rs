//! A first isolation study of a script: what its model shows, with comments on what is to be filled in.

use super::before_transient::run_alone;
use super::script_model::masses;
use super::shear_test::shear_test;
use hysteron_engine::analysis::Engine;
use hysteron_engine::model::ElementId;
use hysteron_identify::report::html;
use hysteron_opensees::may_isolate;
use std::fmt::Write as _;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// Accelerations of gravity with their unit of length.
const GRAVITIES: [(f64, &str); 5] = [(9.81, "m"), (386.4, "in"), (32.2, "ft"), (9810.0, "mm"), (981.0, "cm")];
/// Deviation of weight over mass from one of them, at most.
const DEVIATION: f64 = 0.25;
/// Amplitude in m and period in s of the test that tells types of bearings apart.
const TEST: [f64; 2] = [0.2, 2.0];
/// Difference of two bearings of one type, at most.
const SAME: f64 = 0.02;
/// Share of the weight below which a level is no floor.
const FLOOR: f64 = 0.02;
/// Difference of elevations on one level, as a share of the height.
const LEVEL: f64 = 1.0e-6;

/// A bearing that the model shows.
struct Found {
    tag: i32,
    class: &'static str,
    place: Vec<f64>,
    elevation: f64,
    gravity: f64,
    stiffness: f64,
    strength: f64,
}

impl Found {
    /// The same class and initial stiffness, and the same strength or the same strength over the axial force.
    fn is_like(&self, other: &Self) -> bool {
        let near = |a: f64, b: f64| (a - b).abs() <= SAME * a.abs().max(b.abs());
        let friction = |f: &Self| f.strength / f.gravity;
        self.class == other.class
            && near(self.stiffness, other.stiffness)
            && (near(self.strength, other.strength) || near(friction(self), friction(other)))
    }
}

/// Elements that may be bearings and carry gravity.
fn bearings(engine: &Engine, meter: f64) -> Vec<Found> {
    let model = engine.model();
    let mut out = vec![];
    for (k, e) in model.elements.iter().enumerate().filter(|(_, e)| may_isolate(e) && e.nodes.len() == 2) {
        let node = &model.nodes[e.nodes[1].0];
        let ndm = node.ndm();
        if ndm < 2 {
            continue;
        }
        let mut force = vec![];
        engine.element_force(ElementId(k), &mut force);
        let gravity = -force[force.len() / 2 + ndm - 1];
        if gravity.is_nan() || gravity <= 0.0 {
            continue;
        }
        let n = e.element.dofs();
        let mut tangent = vec![0.0; n * n];
        e.element.initial_tangent(&mut tangent);
        let at = n / 2;
        let strength = shear_test(engine, ElementId(k), 0, TEST[0] * meter, TEST[1]).map_or(f64::NAN, |l| l.q_d);
        out.push(Found {
            tag: e.tag,
            class: e.element.class().name,
            place: node.coords[..ndm - 1].to_vec(),
            elevation: node.coords[ndm - 1],
            gravity,
            stiffness: tangent[at * n + at],
            strength,
        });
    }
    out
}

/// Mass in the first direction by node, with elevation and tag.
fn tagged_masses(engine: &Engine) -> Vec<(f64, f64, i32)> {
    let model = engine.model();
    masses(model).into_iter().zip(&model.nodes).map(|([mass, elevation], n)| (mass, elevation, n.tag)).collect()
}

/// Levels with mass from the base upwards: the node with the largest mass of each.
fn levels(masses: &[(f64, f64, i32)], lowest: f64) -> Vec<i32> {
    let mut all: Vec<&(f64, f64, i32)> =
        masses.iter().filter(|m| m.1 >= lowest - LEVEL * lowest.abs() && m.0 > 0.0).collect();
    all.sort_by(|a, b| a.1.total_cmp(&b.1).then(a.2.cmp(&b.2)));
    let height = all.last().map_or(0.0, |m| m.1 - lowest).abs();
    let total: f64 = all.iter().map(|m| m.0).sum();
    let mut out = vec![];
    let same = |a: &&(f64, f64, i32), b: &&(f64, f64, i32)| b.1 - a.1 <= LEVEL * height;
    for level in all.chunk_by(same) {
        let mass: f64 = level.iter().map(|m| m.0).sum();
        let heaviest = level.iter().copied().reduce(|a, b| if b.0 > a.0 { b } else { a });
        if let Some(m) = heaviest.filter(|_| mass >= FLOOR * total) {
            out.push(m.2);
        }
    }
    out
}

/// The text of a study of a script, which runs with its own values up to its first transient analysis. `name` is the path of the
/// script from the folder of the study.
///
/// # Errors
/// The script fails before, or no element is a bearing that carries gravity.
pub fn draft(script: &Path, name: &str, stop: &Arc<AtomicBool>) -> Result<String, String> {
    let run = run_alone(script, stop)?;
    let engine = &run.interp.host.engine;
    let masses = tagged_masses(engine);
    let first = bearings(engine, 1.0);
    let lowest = first.iter().map(|b| b.elevation).fold(f64::INFINITY, f64::min);
    let carried: f64 = first.iter().map(|b| b.gravity).sum();
    let mass: f64 = masses.iter().filter(|m| m.1 >= lowest).map(|m| m.0).sum();
    if first.is_empty() || mass.is_nan() || mass <= 0.0 {
        let what = if first.is_empty() { "no bearing that carries gravity" } else { "no mass above its bearings" };
        return Err(format!("\"{}\" has {what} before its first transient analysis", script.display()));
    }
    let ratio = carried / mass;
    let known = GRAVITIES.iter().find(|(g, _)| (ratio / g - 1.0).abs() <= DEVIATION);
    let (gravity, length) = known.map_or((ratio, ""), |(g, unit)| (*g, *unit));
    // The types are told apart at a displacement in the unit of the script.
    let found = bearings(engine, gravity / GRAVITIES[0].0);
    let text = hysteron_files::read_lossy(script).map_err(|e| format!("cannot read \"{}\": {e}", script.display()))?;
    Ok(write(
        name,
        gravity,
        length,
        known.is_some(),
        carried,
        &found,
        &levels(&masses, lowest),
        text.contains("isolate("),
    ))
}

#[allow(clippy::too_many_arguments, reason = "the parts of one text")]
fn write(
    name: &str,
    gravity: f64,
    length: &str,
    is_known: bool,
    carried: f64,
    bearings: &[Found],
    floors: &[i32],
    is_prepared: bool,
) -> String {
    let mut out =
        String::from("# A first isolation study. Lines with TODO are to be filled in; then: hysteron check FILE\n");
    if !is_prepared {
        out += "# TODO The script does not use the array isolate yet: its bearings take the factors isolate(Q,NAME) and isolate(K,NAME), its\n\
                # motions isolate(ax), isolate(ay) with isolate(dt), its masses the eccentricities isolate(ex), isolate(ey).\n";
    }
    let _ = writeln!(out, "title = \"TODO\"\nscript = \"{name}\"\ncode = \"asce7-16\" # or asce7-22, aashto, en1998");
    let remark = if is_known {
        "weight over mass of the model is near it"
    } else {
        "TODO weight over mass of the model, which is no known value"
    };
    let _ = writeln!(
        out,
        "gravity = {gravity:?} # {remark}\nunits = [\"\", \"{length}\"] # TODO name of the unit of force"
    );
    let plan = [0, 1].map(|k| {
        let all = bearings.iter().filter_map(|b| b.place.get(k).copied());
        all.clone().fold(f64::NEG_INFINITY, f64::max) - all.fold(f64::INFINITY, f64::min)
    });
    if plan.iter().all(|x| x.is_finite() && *x > 0.0) {
        let _ = writeln!(out, "plan = [{:?}, {:?}] # the grid of the bearings: TODO the whole plan", plan[0], plan[1]);
        out += "eccentricities = [[0.0, 0.0], [0.05, 0.05]] # mirrored\n";
    }
    out += "target = [\"asce7\", \"sms=1.0\", \"sm1=0.6\", \"tl=8\"] # TODO the site\n# scale = [1.5, 4.0]\n";
    out +=
        "response_modification = 1.0 # TODO R of the structure above\n# live = { over_dead = 0.2, in_script = 0.5 }\n";
    out += "# project_tests = true # the factors below come from tests of the project\n";
    out += "\n# Weights are the masses of the script at each elevation, heights those between the nodes.\n";
    for node in floors {
        let _ = write!(out, "\n[[floor]]\nnode = {node}\n");
    }
    let _ = writeln!(
        out,
        "\n# The bearings carry {} under gravity. q_d, k_d and yield_displacement are the script's.",
        html::number(carried)
    );
    let mut types: Vec<Vec<&Found>> = vec![];
    for b in bearings {
        match types.iter_mut().find(|t| t[0].is_like(b)) {
            Some(t) => t.push(b),
            None => types.push(vec![b]),
        }
    }
    for (k, t) in types.iter().enumerate() {
        let tags: Vec<String> = t.iter().map(|b| b.tag.to_string()).collect();
        let _ = write!(
            out,
            "\n[[bearing]] # {}\nname = \"B{}\" # TODO the NAME of isolate(Q,NAME) in the script\ntags = [{}]\n# displacement = TODO capacity\n\
             # critical_load = TODO\n# diameter = TODO\ntension = 0.0\nlower = {{ specification = [0.85, 0.85] }} # TODO test, aging, temperature\n\
             upper = {{ specification = [1.15, 1.15] }}\n",
            t[0].class,
            k + 1,
            tags.join(", ")
        );
    }
    out += "\n[[motion]] # TODO one table for each pair, seven or more\nname = \"TODO\"\nfiles = [\"TODO_x.at2\", \"TODO_y.at2\"]\n# unit = \"g\"\n# dt = 0.01\n";
    out
}
