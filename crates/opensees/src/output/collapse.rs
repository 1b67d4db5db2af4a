//! `recorder Collapse`: infill walls that fail are removed while an analysis runs, and nodes that are left alone.

use super::recorder_file::make_room;
use super::recorder_options::{range, region};
use crate::args::Args;
use crate::checks;
use crate::host::Mode;
use crate::model::nodes::node_of;
use crate::things;
use crate::{Outcome, Tcl, ignore_unknown, warn};
use hysteron_engine::analysis::Engine;
use hysteron_engine::model::{ElementId, NodalLoad, NodeId, Tag};
use hysteron_engine::number_format::Style;
use hysteron_tcl::diagnostic::Diagnostic;
use hysteron_tcl::{Call, Exception, OpenMode, Value};
use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::io::Write as _;

pub(super) const USAGE: &str = "recorder Collapse -ele $tag ... | -eleRange $first $last | -region $tag -crit INFILLWALL \
                                -file_infill $curve -checknodes $bottom $middle $top -global_gravaxis $axis \
                                <-secondary -ele $tag ...> <-mass $m ...> <-g $acceleration $direction $pattern> \
                                <-file $file> <-time> <-dT $dt> or recorder Collapse -ele $tag ... -node $node";

/// Criteria whose value is always zero in OpenSees.
const WITHOUT_VALUE: [&str; 6] = ["minStrain", "maxStrain", "axialDI", "flexureDI", "axialLS", "shearLS"];

/// A wall that fails where its drift in the plane reaches a limit that depends on the drift out of the plane (Kadysiewski and
/// Mosalam, PEER report 2008/102).
#[derive(Debug)]
struct Wall {
    /// Tags of the nodes below, in the middle and above.
    nodes: [Tag; 3],
    /// Horizontal degrees of freedom.
    horizontal: [usize; 2],
    /// Direction of the plane along them.
    along: [f64; 2],
    /// Drifts out of the plane, rising, and in it.
    curve: Vec<[f64; 2]>,
}

impl Wall {
    fn fails(&self, engine: &Engine) -> bool {
        let moved = |tag: Tag| -> Option<[f64; 2]> {
            let node = &engine.model().nodes[engine.model().node(tag)?.0];
            Some(self.horizontal.map(|d| engine.state().disp[node.offset + d]))
        };
        let [Some(bottom), Some(middle), Some(top)] = self.nodes.map(moved) else { return false };
        let [c, s] = self.along;
        let along = |u: [f64; 2]| u[0] * c + u[1] * s;
        let across = |u: [f64; 2]| u[1] * c - u[0] * s;
        let in_plane = (along(top) - along(bottom)).abs();
        let out_of_plane = (across(middle) - 0.5 * (across(top) + across(bottom))).abs();
        in_plane >= self.limit(out_of_plane)
    }

    /// The largest drift in the plane; none beyond the curve.
    fn limit(&self, out_of_plane: f64) -> f64 {
        let part = self.curve.windows(2).find(|w| (w[0][0]..=w[1][0]).contains(&out_of_plane));
        part.map_or(0.0, |w| w[0][1] + (out_of_plane - w[0][0]) / (w[1][0] - w[0][0]) * (w[1][1] - w[0][1]))
    }
}

/// Elements and nodes that are removed, and the time of it.
#[derive(Debug)]
enum Rule {
    /// A wall of elements, with the mass of each; the secondary elements follow the last of them.
    Wall { elements: Vec<(Tag, f64)>, secondary: Vec<Tag>, wall: Option<Wall>, weight: Option<(f64, usize, Tag)> },
    /// A node, once all of the elements are removed.
    Node { node: Tag, elements: Vec<Tag> },
}

/// A `recorder Collapse`.
#[derive(Debug)]
struct Collapse {
    rule: Rule,
    dt: f64,
    next: f64,
}

/// Something that has been removed.
enum Removed {
    Element(ElementId),
    Node(NodeId),
}

/// All of them, with what they have removed.
#[derive(Default)]
pub(crate) struct Collapses {
    all: Vec<Collapse>,
    gone: BTreeSet<Tag>,
    /// Removed since the regions were brought up to date.
    removed: Vec<Removed>,
    /// Path of the file of the removals; the first one that is named takes all.
    log: Option<String>,
    /// Lines that are not in the file yet.
    lines: String,
}

/// Share of a step of time by which a record may be early.
const EARLY: f64 = 1e-5;

impl Collapses {
    /// Remove what fails in the committed state.
    pub(crate) fn step(&mut self, engine: &mut Engine) {
        let time = engine.state().time;
        let mut all = std::mem::take(&mut self.all);
        for collapse in &mut all {
            if collapse.dt != 0.0 && time - collapse.next < -collapse.dt * EARLY {
                continue;
            }
            collapse.next = time + collapse.dt;
            self.follow(engine, &collapse.rule, time);
        }
        self.all = all;
    }

    fn follow(&mut self, engine: &mut Engine, rule: &Rule, time: f64) {
        match rule {
            Rule::Node { node, elements } => {
                if elements.iter().all(|e| self.gone.contains(e)) {
                    self.remove_node(engine, *node, time);
                }
            }
            Rule::Wall { elements, secondary, wall, weight } => {
                for (tag, mass) in elements.iter().filter(|(tag, _)| !self.gone.contains(tag)).collect::<Vec<_>>() {
                    if wall.as_ref().is_some_and(|w| w.fails(engine)) && engine.model().element(*tag).is_some() {
                        lighten(engine, *tag, *mass, *weight);
                        self.remove_element(engine, *tag, time);
                    }
                }
                if elements.iter().all(|(tag, _)| self.gone.contains(tag)) {
                    for tag in secondary {
                        let nodes = self.remove_element(engine, *tag, time);
                        nodes.into_iter().for_each(|node| self.remove_node(engine, node, time));
                    }
                }
            }
        }
    }

    /// Removes an element that is there. Returns the tags of its nodes.
    fn remove_element(&mut self, engine: &mut Engine, tag: Tag, time: f64) -> Vec<Tag> {
        let Some(id) = engine.model().element(tag) else { return vec![] };
        let model = engine.model();
        let nodes = model.elements[id.0].nodes.iter().map(|n| model.nodes[n.0].tag).collect();
        engine.remove_element(id);
        self.removed.push(Removed::Element(id));
        self.gone.insert(tag);
        self.note(time, "Elem", tag);
        nodes
    }

    fn note(&mut self, time: f64, what: &str, tag: Tag) {
        Style::default().push(time, &mut self.lines);
        let _ = writeln!(self.lines, " {what} {tag}");
    }

    /// Removes a node that is there and belongs to no element.
    fn remove_node(&mut self, engine: &mut Engine, tag: Tag, time: f64) {
        let Some(id) = engine.model().node(tag) else { return };
        if engine.remove_node(id).is_ok() {
            self.removed.push(Removed::Node(id));
            self.note(time, "Node", tag);
        }
    }
}

/// Takes the mass of an element off its nodes, half of it each, and its weight off their loads.
fn lighten(engine: &mut Engine, tag: Tag, mass: f64, weight: Option<(f64, usize, Tag)>) {
    let Some(id) = engine.model().element(tag).filter(|_| mass != 0.0) else { return };
    let nodes = engine.model().elements[id.0].nodes.clone();
    engine.change_model(|m| {
        for node in nodes {
            let ndf = m.nodes[node.0].ndf;
            m.nodes[node.0].mass.iter_mut().filter(|m| **m != 0.0).for_each(|m| *m -= 0.5 * mass);
            if let Some((acceleration, direction, pattern)) = weight
                && let Some(pattern) = m.patterns.get_mut(&pattern).filter(|_| direction < ndf)
            {
                let mut values = vec![0.0; ndf];
                values[direction] = 0.5 * mass * acceleration;
                pattern.nodal_loads.push(NodalLoad { node, values, constant: true });
            }
        }
    });
}

/// Bring regions and the file up to date with what an analysis has removed.
///
/// # Errors
/// The file cannot be written.
pub(crate) fn note_removed(interp: &mut Tcl, call: &Call<'_>) -> Result<(), Exception> {
    let session = &mut interp.host;
    for removed in std::mem::take(&mut session.output.recorders.collapses.removed) {
        match removed {
            Removed::Element(id) => session.forget_element(id),
            Removed::Node(id) => session.forget_node(id),
        }
    }
    let collapses = &mut interp.host.output.recorders.collapses;
    let lines = std::mem::take(&mut collapses.lines);
    match collapses.log.clone().filter(|_| !lines.is_empty()) {
        Some(path) => write(interp, &path, &lines, true).map_err(|e| call.error_at(0, e, "")),
        None => Ok(()),
    }
}

/// Write the file of removals, or append to it.
fn write(interp: &mut Tcl, path: &str, text: &str, append: bool) -> Result<(), String> {
    let mode = OpenMode { write: true, create: true, append, truncate: !append, ..OpenMode::default() };
    let written = interp.files.open(path, mode).and_then(|mut file| file.write_all(text.as_bytes()));
    written.map_err(|e| format!("cannot write {path}: {e}"))
}

/// Words of the command.
#[derive(Default)]
struct Words {
    elements: Vec<Tag>,
    secondary: Vec<Tag>,
    node: Option<Tag>,
    masses: Vec<f64>,
    weight: Option<(f64, usize, Tag)>,
    infill: bool,
    curve: Option<Vec<[f64; 2]>>,
    nodes: Option<[Tag; 3]>,
    axis: Option<usize>,
    file: Option<String>,
    dt: f64,
}

pub(super) fn collapse(interp: &mut Tcl, call: &Call<'_>, mut a: Args<'_>) -> Outcome {
    let mut w = Words::default();
    let mut is_secondary = false;
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-secondary" | "-slave" => {
                is_secondary = true;
                continue;
            }
            "-ele" | "-eles" | "-element" | "-eleRange" | "-region" => {
                let tags = elements(interp, &mut a, &option)?;
                if is_secondary { &mut w.secondary } else { &mut w.elements }.extend(tags);
            }
            _ => other(interp, call, &mut a, &option, &mut w)?,
        }
        is_secondary = false;
    }
    if w.elements.is_empty() {
        w.elements = interp.host.engine.model().element_tags().collect();
    }
    let rule = match w.node {
        Some(node) => Rule::Node { node, elements: w.elements },
        None => {
            let wall = if w.infill { Some(wall(interp, &a, &mut w)?) } else { None };
            let masses = w.masses.iter().copied().chain(std::iter::repeat(0.0));
            let elements = w.elements.iter().copied().zip(masses).collect();
            Rule::Wall { elements, secondary: w.secondary, wall, weight: w.weight }
        }
    };
    if let Some(name) = w.file.filter(|_| interp.host.output.recorders.collapses.log.is_none()) {
        let path = interp.absolute(&name);
        if interp.host.mode == Mode::Run {
            write(interp, &path, "", false).map_err(|e| a.refuse(e, "cannot write here"))?;
        }
        interp.host.output.recorders.collapses.log = Some(path);
    }
    let recorders = &mut interp.host.output.recorders;
    recorders.collapses.all.push(Collapse { rule, dt: w.dt, next: 0.0 });
    Ok(Value::from(i64::from(recorders.next_tag())))
}

fn elements(interp: &mut Tcl, a: &mut Args<'_>, option: &str) -> Result<Vec<Tag>, Exception> {
    match option {
        "-eleRange" => {
            let there = interp.host.engine.model().element_tags().collect();
            range(interp, a, "element", there)
        }
        "-region" => region(interp, a, false),
        _ if a.flag("all") => Ok(interp.host.engine.model().element_tags().collect()),
        _ => {
            let mut tags = vec![];
            for (tag, span) in a.tags(things::ELEMENT) {
                if interp.host.engine.model().element(tag).is_none() {
                    return Err(a.absent_at(span, things::ELEMENT, tag, "expected the tag of an element"));
                }
                tags.push(tag);
            }
            Ok(tags)
        }
    }
}

/// An option that names no elements.
fn other(interp: &mut Tcl, call: &Call<'_>, a: &mut Args<'_>, option: &str, w: &mut Words) -> Result<(), Exception> {
    match option {
        "-node" => {
            let node = node_of(interp, a, "tag of the node")?;
            w.node = Some(interp.host.engine.model().nodes[node.0].tag);
        }
        "-checknodes" => {
            let mut tags = [0; 3];
            for (tag, what) in tags.iter_mut().zip(["node below", "node in the middle", "node above"]) {
                let node = node_of(interp, a, what)?;
                *tag = interp.host.engine.model().nodes[node.0].tag;
            }
            w.nodes = Some(tags);
        }
        "-global_gravaxis" => w.axis = Some(a.dof("axis of gravity", 3)?),
        "-file_infill" => {
            let name = a.word("file of the curve of drifts")?.into_owned();
            w.curve = Some(curve(interp, a, &name)?);
        }
        "-crit" | "-criteria" => criterion(interp, a, w)?,
        "-mass" => w.masses = a.floats("mass of an element")?,
        "-g" => {
            let acceleration = a.float("acceleration of gravity")?;
            let direction = a.dof("direction of gravity", 6)?;
            w.weight = Some((acceleration, direction, a.tag(things::PATTERN, "tag of a load pattern")?));
        }
        "-sec" | "-section" | "-comp" => drop(a.ints()),
        "-time" | "-load" => {}
        "-dT" => w.dt = a.number(&super::recorder_options::TIME_STEP)?,
        "-file" => {
            let name = a.word("name of the file")?.into_owned();
            let path = interp.absolute(&name);
            make_room(interp, call, (&name, &path), a.last_span())?;
            w.file = Some(name);
        }
        _ => ignore_unknown(interp, a)?,
    }
    Ok(())
}

fn criterion(interp: &mut Tcl, a: &mut Args<'_>, w: &mut Words) -> Result<(), Exception> {
    let name = a.word("criterion")?;
    if name == "INFILLWALL" {
        w.infill = true;
        return Ok(());
    }
    if !WITHOUT_VALUE.contains(&name.as_ref()) {
        return Err(a.unknown_name("criterion", WITHOUT_VALUE.into_iter().chain(["INFILLWALL"])));
    }
    let span = a.last_span();
    a.float("value of the criterion")?;
    let d = Diagnostic::warning(
        &checks::output::NOTHING_REMOVED,
        format!("recorder Collapse: the criterion {name} has no value, as in OpenSees 3"),
    );
    warn(interp, d.at(span, "nothing is removed by it"))
}

/// Pairs of drifts out of the plane and in it, from a file.
fn curve(interp: &mut Tcl, a: &Args<'_>, name: &str) -> Result<Vec<[f64; 2]>, Exception> {
    let expected = "expected a file with pairs of numbers: drift out of the plane, rising, and drift in the plane";
    let path = interp.absolute(name);
    let content = interp.files.read(&path).map_err(|e| a.refuse(format!("cannot read {name}: {e}"), expected))?;
    let text = String::from_utf8_lossy(&content);
    let numbers: Option<Vec<f64>> =
        text.split_whitespace().map(|w| w.parse::<f64>().ok().filter(|x| x.is_finite())).collect();
    let pairs: Option<Vec<[f64; 2]>> = numbers.filter(|n| n.len() % 2 == 0).map(|n| n.as_chunks().0.to_vec());
    let rising = |pairs: &Vec<[f64; 2]>| pairs.len() > 1 && pairs.windows(2).all(|w| w[0][0] < w[1][0]);
    pairs.filter(rising).ok_or_else(|| a.refuse(format!("{name} has no curve of drifts"), expected))
}

fn wall(interp: &Tcl, a: &Args<'_>, w: &mut Words) -> Result<Wall, Exception> {
    let missing = |what: &str| a.refuse(format!("recorder Collapse: INFILLWALL needs {what}"), "not given by the end");
    let curve = w.curve.take().ok_or_else(|| missing("-file_infill with a curve of drifts"))?;
    let nodes = w.nodes.ok_or_else(|| missing("-checknodes with the nodes below, in the middle and above"))?;
    let axis = w.axis.ok_or_else(|| missing("-global_gravaxis with the number of the vertical axis"))?;
    let horizontal = match axis {
        0 => [1, 2],
        1 => [0, 2],
        _ => [0, 1],
    };
    let model = interp.host.engine.model();
    let place = |tag: Tag| model.node(tag).map(|n| model.nodes[n.0].place()).unwrap_or_default();
    if nodes.iter().any(|tag| model.node(*tag).is_none_or(|n| model.nodes[n.0].ndm() != 3)) {
        return Err(a.refuse("recorder Collapse: an infill wall is in space", "expected nodes in 3 dimensions"));
    }
    let line = place(nodes[2]) - place(nodes[0]);
    let along = horizontal.map(|d| line[d]);
    let length = along[0].hypot(along[1]);
    if length == 0.0 {
        let expected = "expected nodes at the ends of a diagonal";
        return Err(a.refuse("recorder Collapse: the nodes above and below are over each other", expected));
    }
    Ok(Wall { nodes, horizontal, along: along.map(|x| x / length), curve })
}
