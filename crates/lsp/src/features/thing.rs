//! Things of a model in words: nodes, elements, materials and what else has a tag.

use super::words;
use crate::script::Script;
use hysteron_engine::material::{Slot, Strain};
use hysteron_engine::model::{Model, NodeId, Tag};
use hysteron_opensees::index::{CalledCommand, IndexedModel, Mention};
use hysteron_opensees::things;
use std::fmt::Write as _;

/// Rows and columns of the picture of a backbone.
const PICTURE: (usize, usize) = (9, 41);
/// Strains of a picture over the one at which the law leaves its first stiffness.
const PICTURE_DUCTILITY: f64 = 5.0;
/// Characters of a command that are shown.
const MAX_COMMAND: usize = 400;

/// A number with six significant digits.
pub(crate) fn short(x: f64) -> String {
    if x != 0.0 && !(1e-4..1e7).contains(&x.abs()) {
        return format!("{x:.4e}");
    }
    let text = format!("{x:.6}");
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}

fn list(numbers: &[f64]) -> String {
    numbers.iter().map(|x| short(*x)).collect::<Vec<_>>().join(", ")
}

/// The model that a thing belongs to.
fn model_of<'a>(script: &'a Script, thing: &Mention) -> Option<&'a IndexedModel> {
    script.index.models.get(thing.model)
}

/// A thing in Markdown: what it is, and the command that defines it.
pub(crate) fn described(script: &Script, thing: &Mention) -> String {
    let mut out = format!("**{} {}**", thing.kind, thing.tag);
    if let Some(found) = model_of(script, thing).and_then(|m| of_model(m, thing)) {
        let _ = write!(out, " {found}");
    }
    if let Some(command) = script.definition(thing) {
        let _ = write!(out, "\n\n```tcl\n{}\n```\n{}", shown(script, command), about(command));
    }
    if thing.kind == things::MATERIAL
        && let Some(picture) = model_of(script, thing).and_then(|m| backbone(m, thing.tag.parse().ok()?))
    {
        let _ = write!(out, "\n\n```text\n{picture}```");
    }
    out
}

/// The text of a command, cut where it is long.
pub(crate) fn shown(script: &Script, command: &CalledCommand) -> String {
    let place = script.place(command.span);
    let text = place.as_ref().and_then(|p| script.text(&p.path)?.get(p.start..p.end)).unwrap_or_default();
    let cut: String = text.chars().take(MAX_COMMAND).collect();
    if cut.len() < text.len() { cut + " ..." } else { cut }
}

/// First sentences about the kind that a command makes.
fn about(command: &CalledCommand) -> &'static str {
    let kind = command.words.get(1).and_then(|w| words::kind(command.command, &w.value));
    kind.map_or("", |k| k.text.about)
}

fn of_model(indexed: &IndexedModel, thing: &Mention) -> Option<String> {
    let tag: Tag = thing.tag.parse().ok()?;
    let model = &indexed.model;
    match thing.kind {
        things::NODE => node(model, model.node(tag)?),
        things::ELEMENT => element(model, tag),
        things::PATTERN => {
            let p = model.patterns.get(&tag)?;
            Some(format!("with {} nodal loads and {} imposed motions", p.nodal_loads.len(), p.motions.len()))
        }
        _ => None,
    }
}

/// Coordinates, mass and supports of a node.
fn node(model: &Model, id: NodeId) -> Option<String> {
    let n = model.nodes.get(id.0)?;
    let mut out = format!("at ({})", list(&n.coords));
    if n.mass.iter().any(|m| *m != 0.0) {
        let _ = write!(out, ", mass {}", list(&n.mass));
    }
    let mut fixed: Vec<usize> = model.fixes.iter().filter(|f| f.node == id).map(|f| f.dof + 1).collect();
    fixed.sort_unstable();
    if !fixed.is_empty() {
        let dofs: Vec<String> = fixed.iter().map(ToString::to_string).collect();
        let _ = write!(out, ", fixed in {}", dofs.join(" "));
    }
    for m in model.multi_points.iter().filter(|m| m.constrained == id) {
        let dofs: Vec<String> = m.constrained_dofs.iter().map(|d| (d + 1).to_string()).collect();
        let _ = write!(out, ", follows node {} in {}", model.nodes[m.retained.0].tag, dofs.join(" "));
    }
    Some(out)
}

/// Class, ends, length and responses of an element.
fn element(model: &Model, tag: Tag) -> Option<String> {
    let e = model.elements.get(model.element(tag)?.0)?;
    let ends: Vec<String> = e.nodes.iter().map(|n| node_in_short(model, *n)).collect();
    let mut out = format!("`{}` from {}", e.element.class().name, ends.join(" to "));
    if let [i, j] = e.nodes[..] {
        let (a, b) = (&model.nodes[i.0].coords, &model.nodes[j.0].coords);
        let length = a.iter().zip(b).map(|(a, b)| (b - a).powi(2)).sum::<f64>().sqrt();
        let _ = write!(out, ", length {}", short(length));
    }
    let names = responses(model, tag);
    if !names.is_empty() {
        let names: Vec<String> = names.iter().map(|n| format!("`{n}`")).collect();
        let _ = write!(out, "\n\nRecorders take: {}.", names.join(", "));
    }
    Some(out)
}

fn node_in_short(model: &Model, id: NodeId) -> String {
    let n = &model.nodes[id.0];
    format!("node {} ({})", n.tag, list(&n.coords))
}

/// Names of the responses of an element.
pub(crate) fn responses(model: &Model, tag: Tag) -> Vec<&'static str> {
    let Some(e) = model.element(tag).and_then(|id| model.elements.get(id.0)) else { return vec![] };
    let mut names = vec!["force"];
    names.extend(e.element.probe_names());
    names.sort_unstable();
    names.dedup();
    names
}

/// The first loading of a uniaxial law in both directions, as a picture.
fn backbone(indexed: &IndexedModel, tag: Tag) -> Option<String> {
    let law = indexed.definitions.materials.get(tag)?;
    let slot = Slot::new(law.clone(), tag, 0);
    let mut virgin = vec![0.0; slot.len()];
    slot.init(&mut virgin);
    let stress = |strain: f64| {
        let mut next = virgin.clone();
        let answer = slot.update(&virgin, Strain { value: strain, rate: 0.0, dt: 0.0 }, &mut next).ok()?;
        Some(answer.value).filter(|s| s.is_finite())
    };
    let first = slot.tangent(&virgin);
    // The strain, by doubling, at which the law has left its first stiffness.
    let leaves = |e: &f64| stress(*e).is_none_or(|s| (s - first * e).abs() > 0.1 * (first * e).abs());
    let yields = std::iter::successors(Some(1e-7), |e| Some(e * 2.0)).take(40).find(leaves).unwrap_or(1e-3);
    let limit = PICTURE_DUCTILITY * yields;
    let (rows, columns) = PICTURE;
    let half = columns / 2;
    let strain = |column: usize| limit * (column as f64 - half as f64) / half as f64;
    let values: Vec<f64> = (0..columns).map(|c| stress(strain(c)).unwrap_or(0.0)).collect();
    let largest = values.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
    if largest == 0.0 {
        return None;
    }
    let row_of = |v: f64| (((1.0 - v / largest) * (rows - 1) as f64 / 2.0).round() as usize).min(rows - 1);
    let mut out = String::new();
    for row in 0..rows {
        let line: String = (0..columns)
            .map(|c| match (row_of(values[c]) == row, c == half, row == rows / 2) {
                (true, _, _) => '*',
                (_, true, true) => '+',
                (_, true, false) => '|',
                (_, false, true) => '-',
                _ => ' ',
            })
            .collect();
        out += line.trim_end();
        match row {
            0 => out += &format!("  {}", short(largest)),
            r if r == rows / 2 => out += &format!("  {}", short(limit)),
            _ => {}
        }
        out.push('\n');
    }
    Some(out)
}
