//! `print`: the model in words or as JSON, to the error stream or a file.

use super::args::Args;
use super::{Command, Outcome, Tcl, ignore_option, print_error};
use crate::io::number::Style;
use crate::model::{ElementId, Model, NodeId};
use crate::script::{Call, Exception, OpenMode, Value};
use std::fmt::Write as _;
use std::io::Write as _;

pub(super) const COMMANDS: &[Command] = &[Command { name: "print", usage: USAGE, run: print }];

const USAGE: &str = "print <$file | -file $file> <-JSON> <-node <$tag ...>> <-ele <$tag ...>>";

/// What of the model is printed.
enum Part {
    All,
    Nodes(Vec<NodeId>),
    Elements(Vec<ElementId>),
}

fn print(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, USAGE);
    let (mut file, mut json, mut part) = (None, false, Part::All);
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-file" => file = Some(a.word("name of the file")?.into_owned()),
            "-json" | "-JSON" => json = true,
            // Asks OpenSees to add the definitions of materials and sections.
            "-registry" => {}
            "-node" | "node" => part = Part::Nodes(nodes(interp, &mut a)?),
            "-ele" | "ele" | "-element" | "element" => part = Part::Elements(elements(interp, &mut a)?),
            name if !name.starts_with('-') && file.is_none() => file = Some(name.to_owned()),
            _ => ignore_option(interp, &mut a, &["-file", "-JSON", "-node", "-ele"])?,
        }
    }
    let model = interp.host.engine.model();
    let text = if json { as_json(model) } else { in_words(interp, &part) };
    let Some(name) = file else {
        print_error(interp, &text);
        return Ok(Value::EMPTY);
    };
    let path = interp.absolute(&name);
    // JSON is one document; what is in words is added to what is there, as in OpenSees.
    let mode = OpenMode { write: true, create: true, truncate: json, append: !json, ..Default::default() };
    let written = interp.files.open(&path, mode).and_then(|mut f| f.write_all(text.as_bytes()));
    written.map_err(|e| a.refuse(format!("cannot write \"{name}\": {e}"), "expected a file"))?;
    Ok(Value::EMPTY)
}

/// Nodes by the tags that follow; all of them where none do.
fn nodes(interp: &Tcl, a: &mut Args<'_>) -> Result<Vec<NodeId>, Exception> {
    let model = interp.host.engine.model();
    if a.flag("-flag") {
        a.int("flag")?;
    }
    if !a.at_number() {
        return Ok(model.nodes_by_tag().collect());
    }
    let mut found = vec![];
    while a.at_number() {
        found.push(super::model::node_of(interp, a, "tag of the node")?);
    }
    Ok(found)
}

fn elements(interp: &Tcl, a: &mut Args<'_>) -> Result<Vec<ElementId>, Exception> {
    let model = interp.host.engine.model();
    if a.flag("-flag") {
        a.int("flag")?;
    }
    if !a.at_number() {
        return Ok(model.elements_by_tag().collect());
    }
    let mut found = vec![];
    while a.at_number() {
        let tag = a.int("tag of the element")?;
        let missing = || a.refuse(format!("there is no element {tag}"), "expected the tag of an element");
        found.push(model.element(tag).ok_or_else(missing)?);
    }
    Ok(found)
}

/// Numbers as OpenSees' streams write them.
fn row(values: &[f64]) -> String {
    let mut out = String::new();
    for x in values {
        Style::default().push(*x, &mut out);
        out.push(' ');
    }
    out
}

fn in_words(interp: &Tcl, part: &Part) -> String {
    let engine = &interp.host.engine;
    let (model, state) = (engine.model(), engine.state());
    let (nodes, elements) = match part {
        Part::All => (model.nodes_by_tag().collect(), model.elements_by_tag().collect()),
        Part::Nodes(n) => (n.clone(), vec![]),
        Part::Elements(e) => (vec![], e.clone()),
    };
    let mut out = String::new();
    if matches!(part, Part::All) {
        let _ = writeln!(out, "Current Domain Information");
        let _ = writeln!(out, "\tCurrent Time: {}", state.time);
        let _ = writeln!(out, "\tNumber of nodes: {}, of elements: {}", nodes.len(), elements.len());
    }
    for id in nodes {
        let n = &model.nodes[id.0];
        let _ = writeln!(out, "\n Node: {}\n\tCoordinates  : {}", n.tag, row(&n.coords));
        let _ = writeln!(out, "\tDisps: {}", row(&state.disp[n.dofs()]));
        let _ = writeln!(out, "\tVelocities   : {}", row(&state.vel[n.dofs()]));
        let _ = writeln!(out, "\tcommitAccels: {}", row(&state.accel[n.dofs()]));
        if n.mass.iter().any(|m| *m != 0.0) {
            let _ = writeln!(out, "\tMass : {}", row(&n.mass));
        }
    }
    let mut disp = vec![];
    for id in elements {
        let e = &model.elements[id.0];
        let tags: String = e.nodes.iter().map(|n| format!("{} ", model.nodes[n.0].tag)).collect();
        let _ = writeln!(out, "\nElement: {} type: {} nodes: {tags}", e.tag, e.element.class());
        let _ = writeln!(out, "\tresisting force: {}", row(engine.snapshot(id, &mut disp).force));
    }
    out
}

fn list(values: impl Iterator<Item = String>) -> String {
    values.collect::<Vec<_>>().join(", ")
}

/// Nodes and elements in the layout of OpenSees' `StructuralAnalysisModel`.
fn as_json(model: &Model) -> String {
    let nodes = model.nodes_by_tag().map(|id| {
        let n = &model.nodes[id.0];
        let crd = list(n.coords.iter().map(f64::to_string));
        let mut text = format!("\t\t\t{{\"name\": {}, \"ndf\": {}, \"crd\": [{crd}]", n.tag, n.ndf);
        if n.mass.iter().any(|m| *m != 0.0) {
            let _ = write!(text, ", \"mass\": [{}]", list(n.mass.iter().map(f64::to_string)));
        }
        text + "}"
    });
    let elements = model.elements_by_tag().map(|id| {
        let e = &model.elements[id.0];
        let tags = list(e.nodes.iter().map(|n| model.nodes[n.0].tag.to_string()));
        format!("\t\t\t{{\"name\": {}, \"type\": \"{}\", \"nodes\": [{tags}]}}", e.tag, e.element.class())
    });
    let join = |items: Vec<String>| items.join(",\n");
    format!(
        "{{\n\"StructuralAnalysisModel\": {{\n\t\"geometry\": {{\n\t\t\"nodes\": [\n{}\n\t\t],\n\t\t\"elements\": [\n{}\n\
         \t\t]\n\t}}\n}}\n}}\n",
        join(nodes.collect()),
        join(elements.collect())
    )
}
