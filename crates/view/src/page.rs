//! The page: one file with its data, its scripts and its styles.

use crate::collector::{Motion, Units};
use crate::devices::{Device, Role};
use crate::history::History;
use crate::pack::{Pack, encoded, packed};
use crate::scene::{Family, Scene};
use hysteron_engine::analysis::Kind;
use serde_json::{Value, json};

/// plotly.js, compressed (zlib).
pub(crate) const LIBRARY: &[u8] = include_bytes!("../plotly/plotly.min.js.zlib");

const STYLE: &str = include_str!("page.css");
const SCRIPTS: [&str; 4] =
    [include_str!("data.js"), include_str!("model.js"), include_str!("panels.js"), include_str!("page.js")];

/// Differences that an eye does not see, as a share of the range of a picture.
const INVISIBLE: f32 = 1e-3;
/// Points of a history, at least and at most.
const POINTS: (usize, usize) = (200, 1500);
/// Numbers of all histories of nodes, and of all devices.
const HISTORIES: usize = 1_500_000;
/// Frames with more numbers than this are written as sums of shapes.
const DIRECT: usize = 1_200_000;
/// Numbers of all shapes of a sum.
const SHAPES: usize = 2_000_000;
/// Modes that are shown.
const MODES: usize = 12;

/// A page that shows a motion. It needs no other file and fetches nothing.
///
/// `models` is the number of models that the script has analysed, of which this is the last.
pub fn page(motion: &Motion, title: &str, units: &Units, models: usize) -> String {
    let mut pack = Pack::default();
    let described = description(motion, title, units, models, &mut pack);
    let title = escaped(title);
    let block =
        |id: &str, text: &str| format!("<script type=\"application/octet-stream\" id=\"{id}\">{text}</script>\n");
    let mut out = format!(
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>{title}</title>\n\
         <style>{STYLE}</style></head>\n<body>\n<h1>{title}</h1>\n\
         <noscript><p>This page draws with a script. Allow scripts for this file, or open its VTK files in ParaView.</p></noscript>\n\
         <main id=\"view\"></main>\n"
    );
    out.push_str(&block("description", &packed(described.to_string().as_bytes())));
    out.push_str(&block("arrays", &pack.finish()));
    out.push_str(&block("library", &encoded(LIBRARY)));
    out.push_str("<script>\n\"use strict\";\n");
    SCRIPTS.iter().for_each(|s| out.push_str(s));
    out.push_str("</script>\n</body></html>\n");
    out
}

/// A report whose charts can be zoomed and asked on a screen: those that carry their numbers are drawn anew. The pictures
/// stay for paper, and where scripts are not allowed.
pub fn interactive(report: &str) -> String {
    const HIDE: &str =
        "<style>@media screen{figure.live>svg{display:none}}@media print{figure.live>.plot{display:none}}</style>\n";
    let library = encoded(LIBRARY);
    let script = include_str!("report.js");
    let end = format!(
        "{HIDE}<script type=\"application/octet-stream\" id=\"library\">{library}</script>\n<script>\n\"use strict\";\n{script}</script>\n</body>"
    );
    report.replacen("</body>", &end, 1)
}

/// A text with the special characters of HTML replaced.
fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// Content of the page, with the places of its arrays in `pack`.
pub(crate) fn description(motion: &Motion, title: &str, units: &Units, models: usize, pack: &mut Pack) -> Value {
    let scene = &motion.scene;
    let kind = |k: Kind| if k == Kind::Static { "static" } else { "transient" };
    let modes = motion.modes.iter().take(MODES);
    let points = |numbers: usize| HISTORIES.checked_div(numbers).unwrap_or(POINTS.1).clamp(POINTS.0, POINTS.1);
    let device_points = points(motion.devices.iter().map(|d| d.history.columns).sum());
    let node_points = points(motion.nodes.iter().map(|n| n.history.columns).sum());
    json!({
        "title": title,
        "units": { "force": units.force, "length": units.length },
        "models": models,
        "ndm": scene.ndm,
        "size": scene.size(),
        "shaken": scene.shaken,
        "families": Family::ALL.map(Family::name),
        "nodes": nodes(scene, pack),
        "elements": elements(scene, pack),
        "ties": pack.integers(scene.ties.iter().flat_map(|t| [t.0 as i32, t.1 as i32]).collect::<Vec<_>>().into_iter()),
        "times": pack.floats(motion.times.iter().map(|t| *t as f32)),
        "stages": motion.stages.iter().map(|s| json!([kind(s.kind), s.steps.0, s.steps.1])).collect::<Vec<_>>(),
        "frames": frames(motion, pack),
        "modes": modes.map(|(lambda, shape)| json!({ "lambda": lambda, "shape": pack.shorts(shape) })).collect::<Vec<_>>(),
        "peaks": peaks(motion, pack),
        "members": members(motion, pack),
        "devices": motion.devices.iter().map(|d| device(d, device_points, pack)).collect::<Vec<_>>(),
        "devicesLeftOut": motion.devices_left_out,
        "histories": motion.nodes.iter().map(|n| {
            let mut described = history(&n.history, node_points, pack);
            described["node"] = json!(n.node);
            described
        }).collect::<Vec<_>>(),
        "fibers": fibers(motion, pack),
    })
}

fn nodes(scene: &Scene, pack: &mut Pack) -> Value {
    let flat = |of: &dyn Fn(&crate::scene::SceneNode) -> [f64; 3]| -> Vec<f32> {
        scene.nodes.iter().flat_map(of).map(|x| x as f32).collect()
    };
    let (places, loads) = (flat(&|n| n.place), flat(&|n| n.load));
    json!({
        "tags": pack.integers(scene.nodes.iter().map(|n| n.tag)),
        "places": pack.floats(places.into_iter()),
        "ndf": pack.integers(scene.nodes.iter().map(|n| n.ndf as i32)),
        "fixed": pack.integers(scene.nodes.iter().map(|n| i32::from(n.fixed))),
        "mass": pack.floats(scene.nodes.iter().map(|n| n.mass as f32)),
        "load": pack.floats(loads.into_iter()),
    })
}

fn elements(scene: &Scene, pack: &mut Pack) -> Value {
    let mut classes: Vec<&str> = scene.elements.iter().map(|e| e.class).collect();
    classes.sort_unstable();
    classes.dedup();
    let class = |c: &str| classes.binary_search(&c).unwrap_or(0) as i32;
    let family = |f: Family| Family::ALL.iter().position(|x| *x == f).unwrap_or(0) as i32;
    let starts = scene.elements.iter().scan(0, |at, e| {
        *at += e.nodes.len() as i32;
        Some(*at)
    });
    let starts: Vec<i32> = std::iter::once(0).chain(starts).collect();
    let nodes: Vec<i32> = scene.elements.iter().flat_map(|e| e.nodes.iter().map(|n| *n as i32)).collect();
    let axes: Vec<f32> = scene
        .elements
        .iter()
        .flat_map(|e| e.axes.unwrap_or_default().into_iter().flatten())
        .map(|x| x as f32)
        .collect();
    json!({
        "tags": pack.integers(scene.elements.iter().map(|e| e.tag)),
        "class": pack.integers(scene.elements.iter().map(|e| class(e.class))),
        "family": pack.integers(scene.elements.iter().map(|e| family(e.family))),
        "starts": pack.integers(starts.into_iter()),
        "nodes": pack.integers(nodes.into_iter()),
        "axes": pack.floats(axes.into_iter()),
        "classes": classes,
    })
}

fn steps(steps: &[u32], pack: &mut Pack) -> Value {
    pack.integers(steps.iter().map(|s| *s as i32))
}

/// Displacements of all nodes, as they are or as sums of shapes.
fn frames(motion: &Motion, pack: &mut Pack) -> Value {
    let frames = &motion.frames;
    if frames.values.len() <= DIRECT {
        return json!({ "steps": steps(&frames.steps, pack), "values": pack.shorts(&frames.values), "error": 0.0 });
    }
    let reduced = frames.reduced(INVISIBLE, SHAPES);
    let shapes: Vec<Value> = reduced.shapes.chunks_exact(frames.width).map(|s| pack.shorts(s)).collect();
    json!({
        "steps": steps(&frames.steps, pack),
        "rank": reduced.rank,
        "shapes": shapes,
        "coefficients": pack.floats(reduced.coefficients.iter().copied()),
        "error": reduced.error,
    })
}

/// A history, thinned.
fn history(full: &History, points: usize, pack: &mut Pack) -> Value {
    let thinned = full.thinned(INVISIBLE, points);
    let columns: Vec<Value> = (0..thinned.columns).map(|c| pack.shorts(&thinned.column(c))).collect();
    json!({ "steps": steps(&thinned.steps, pack), "columns": columns })
}

fn device(device: &Device, points: usize, pack: &mut Pack) -> Value {
    let role = |r: Role| match r {
        Role::Axial => "axial",
        Role::Shear => "shear",
        Role::Rotation => "rotation",
    };
    let mut described = history(&device.history, points, pack);
    described["element"] = json!(device.element);
    described["directions"] = device.directions.iter().map(|(name, r)| json!([name, role(*r)])).collect();
    let columns = 0..device.history.columns;
    described["peaks"] = columns.map(|c| device.history.peak(c)).map(|(x, step)| json!([x, step])).collect();
    described
}

fn peaks(motion: &Motion, pack: &mut Pack) -> Value {
    let all = &motion.peaks;
    json!({
        "disp": pack.floats(all.iter().map(|p| p.disp.0)),
        "dispStep": pack.integers(all.iter().map(|p| p.disp.1 as i32)),
        "accel": pack.floats(all.iter().map(|p| p.accel.0)),
        "accelStep": pack.integers(all.iter().map(|p| p.accel.1 as i32)),
    })
}

fn members(motion: &Motion, pack: &mut Pack) -> Value {
    let forces = &motion.forces;
    let columns: Vec<usize> = forces.members.iter().flat_map(|m| 0..m.columns()).collect();
    json!({
        "elements": pack.integers(forces.members.iter().map(|m| m.element as i32)),
        "columns": pack.integers(forces.members.iter().map(|m| m.columns() as i32)),
        "steps": steps(&forces.frames.steps, pack),
        "values": pack.grouped_shorts(&forces.frames.values, &columns),
        "low": pack.floats(forces.low.iter().map(|x| x.0)),
        "lowStep": pack.integers(forces.low.iter().map(|x| x.1 as i32)),
        "high": pack.floats(forces.high.iter().map(|x| x.0)),
        "highStep": pack.integers(forces.high.iter().map(|x| x.1 as i32)),
    })
}

fn fibers(motion: &Motion, pack: &mut Pack) -> Value {
    let fibers = &motion.fibers;
    let part = |at: usize| -> Vec<f32> { fibers.frames.values.iter().skip(at).step_by(2).copied().collect() };
    let section = |s: &crate::fibers::FiberedSection, pack: &mut Pack| {
        let places: Vec<f32> = s.fibers.iter().flatten().map(|x| *x as f32).collect();
        json!({ "element": s.element, "number": s.number, "places": pack.floats(places.into_iter()) })
    };
    json!({
        "sections": fibers.sections.iter().map(|s| section(s, pack)).collect::<Vec<_>>(),
        "leftOut": fibers.left_out,
        "steps": steps(&fibers.frames.steps, pack),
        "stress": pack.shorts(&part(0)),
        "strain": pack.shorts(&part(1)),
    })
}
