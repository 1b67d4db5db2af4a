//! `print`: what the model is, as text or as JSON.

use super::model_file::model_file;
use crate::args::Args;
use crate::effect::Effect;
use crate::text::{Arg, Domain};
use crate::things;
use crate::{Command, Outcome, Tcl, ignore_unknown, print_error};
use hysteron_engine::model::{ElementEntry, Model, Tag};
use hysteron_tcl::{Call, Exception, OpenMode, Value};
use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::io::Write as _;

const FILE: Arg = Arg::of("-file", "file", "name of the file");
const FLAG_N: Arg = Arg::of("-flag", "n", "flag").within(Domain::Whole);

pub(crate) const COMMANDS: &[Command] = &[telling("print"), telling("printModel")];

const fn telling(name: &'static str) -> Command {
    Command::new(name, PRINT, print).about("Prints nodes and elements.").arguments(TAGS).leaving(Effect::Nothing)
}

const TAGS: &[Arg] = &[
    FILE,
    FLAG_N,
    Arg::of("-node", "tag", "tags of nodes; all where there is none"),
    Arg::of("-ele", "tag", "tags of elements; all where there is none"),
];

const PRINT: &str = "print <-file $file> <-JSON> <-node <-flag $n> <$tag ...>> <-ele <-flag $n> <$tag ...>>";

/// Things to print, their form and the file they go to.
#[derive(Default)]
struct PrintRequest {
    file: Option<String>,
    json: bool,
    /// Tags of nodes, all of them if there are none; not printed for `None`.
    nodes: Option<Vec<Tag>>,
    elements: Option<Vec<Tag>>,
    analysis: bool,
}

fn print(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, PRINT);
    let mut w = PrintRequest::default();
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-file" | "file" => w.file = Some(a.word(FILE.meaning)?.into_owned()),
            "-JSON" | "-json" => w.json = true,
            "-node" | "node" => w.nodes.get_or_insert_default().extend(tags(&mut a, things::NODE)?),
            "-ele" | "ele" | "-element" => w.elements.get_or_insert_default().extend(tags(&mut a, things::ELEMENT)?),
            "-integrator" | "integrator" | "-algorithm" | "algorithm" => {
                a.optional_int(FLAG_N.meaning)?;
                w.analysis = true;
            }
            // A word that is no option is the name of a file.
            word if !word.starts_with('-') => w.file = Some(word.to_owned()),
            _ => ignore_unknown(interp, &mut a)?,
        }
    }
    if w.nodes.is_none() && w.elements.is_none() && !w.analysis {
        (w.nodes, w.elements) = (Some(vec![]), Some(vec![]));
    }
    let model = interp.host.engine.model();
    for (what, wanted, known) in [
        ("node", &w.nodes, model.node_tags().collect::<BTreeSet<_>>()),
        ("element", &w.elements, model.element_tags().collect()),
    ] {
        if let Some(tag) = wanted.iter().flatten().find(|t| !known.contains(t)) {
            return Err(a.absent_at(call.whole_span(), what, tag, format!("expected a tag of {what}s")));
        }
    }
    let text = if w.json {
        let builder = &interp.host.builder;
        model_file(interp.host.engine.model(), &builder.definitions, &builder.components)
    } else {
        text(interp, &w)
    };
    let Some(name) = &w.file else {
        print_error(interp, &text);
        return Ok(Value::EMPTY);
    };
    let path = interp.absolute(name);
    // JSON is a document of its own; text is appended, as in OpenSees.
    let mode = OpenMode { write: true, create: true, append: !w.json, truncate: w.json, ..OpenMode::default() };
    let written = interp.files.open(&path, mode).and_then(|mut file| file.write_all(text.as_bytes()));
    written.map_err(|e| call.error_at(0, format!("cannot write \"{name}\": {e}"), ""))?;
    Ok(Value::EMPTY)
}

/// Tags after `-node` or `-ele`, with a flag that may come before them.
fn tags(a: &mut Args<'_>, kind: &'static str) -> Result<Vec<Tag>, Exception> {
    if a.flag("-flag") || a.flag("flag") {
        a.int(FLAG_N.meaning)?;
    }
    Ok(a.tags(kind).into_iter().map(|(tag, _)| tag).collect())
}

/// Numbers with a space after each, as OpenSees puts out a vector.
fn row(values: &[f64]) -> String {
    values.iter().fold(String::new(), |mut s, x| {
        let _ = write!(s, "{x} ");
        s
    })
}

/// Rows of a matrix on lines of their own, with an empty line behind, as OpenSees puts out a matrix.
fn matrix(rows: &[Vec<f64>]) -> String {
    rows.iter().fold("\n".to_owned(), |s, r| s + &row(r) + "\n") + "\n"
}

/// A row of a diagonal matrix.
fn on_diagonal(n: usize, i: usize, value: f64) -> Vec<f64> {
    (0..n).map(|j| if i == j { value } else { 0.0 }).collect()
}

fn text(interp: &Tcl, w: &PrintRequest) -> String {
    let engine = &interp.host.engine;
    let (model, state) = (engine.model(), engine.state());
    let mut out = String::new();
    if w.nodes.is_some() && w.elements.is_some() {
        let _ = writeln!(
            out,
            "Current Domain Information\n\tCurrent Time: {}\n\tNumber of nodes: {}\n\tNumber of elements: {}\n\
             \tNumber of single-point constraints: {}\n\tNumber of multi-point constraints: {}\n\
             \tNumber of load patterns: {}",
            state.time,
            model.nodes.len(),
            model.elements.len(),
            model.fixes.len(),
            model.multi_points.len(),
            model.patterns.len()
        );
    }
    let chosen = |wanted: &Option<Vec<Tag>>, tag: Tag| {
        wanted.as_ref().is_some_and(|tags| tags.is_empty() || tags.contains(&tag))
    };
    for node in model.nodes_by_tag().map(|id| &model.nodes[id.0]).filter(|n| chosen(&w.nodes, n.tag)) {
        let _ = writeln!(out, "\n Node: {}\n\tCoordinates  : {}", node.tag, row(&node.coords));
        for (name, field) in [("Disps", &state.disp), ("Velocities   ", &state.vel), ("commitAccels", &state.accel)] {
            let _ = writeln!(out, "\t{name}: {}", row(&field[node.dofs()]));
        }
        if node.mass.iter().any(|m| *m != 0.0) {
            let masses: Vec<Vec<f64>> = (0..node.ndf).map(|i| on_diagonal(node.ndf, i, node.mass[i])).collect();
            let _ = writeln!(out, "\tMass : {}\t Rayleigh Factor: alphaM: {}", matrix(&masses), node.alpha_m);
        }
        if let Some(modes) = engine.modes() {
            let rows: Vec<Vec<f64>> = node.dofs().map(|d| modes.shapes.iter().map(|s| s[d]).collect()).collect();
            let _ = writeln!(out, "\t Eigenvectors: {}", matrix(&rows));
        }
    }
    for e in model.elements_by_tag().map(|id| &model.elements[id.0]).filter(|e| chosen(&w.elements, e.tag)) {
        let nodes: Vec<String> = node_tags(model, e).map(|t| t.to_string()).collect();
        let _ = writeln!(out, "\nElement: {} type: {}", e.tag, e.element.class().name);
        let _ = writeln!(out, "\tConnected Nodes: {}", nodes.join(" "));
        let _ = writeln!(out, "\tResisting Force: {}", row(&state.force[e.force.clone()]));
    }
    if let Some(setup) = engine.setup().filter(|_| w.analysis) {
        let _ = writeln!(out, "\t {}\n\t {}", setup.integrator.name(), setup.algorithm.name());
    }
    out
}

fn node_tags<'a>(model: &'a Model, e: &'a ElementEntry) -> impl Iterator<Item = Tag> + 'a {
    e.nodes.iter().map(|n| model.nodes[n.0].tag)
}
