//! Standard forms put into a script: materials of an element, or elements between its nodes.

use super::amendment::Amendment;
use super::{Beside, Between, StandardForm};
use crate::inspect::insertion::InsertedBlock;
use crate::inspect::inventory::{ModelInventory, TagPurpose};
use hysteron_engine::analysis::Engine;
use hysteron_tcl::{TopLevel, top_level};
use std::collections::BTreeMap;

/// Comments around added commands.
const OPEN: &str = "# ---- added by hysteron diagnose: physics that the model left out, in OpenSees' commands ----";
const CLOSE: &str = "# ---- end of what was added ----";

/// Elements whose command lists materials with their directions.
const LISTED: [&str; 2] = ["zeroLength", "twoNodeLink"];

/// Number of tags below that of the first wrapped material.
const MAX_FORM_TAGS: i32 = 500;

/// Parts of the user's model that forms depend on.
#[derive(Debug, Default)]
pub(super) struct ModelParts {
    pub(super) inventory: ModelInventory,
    /// Mass-proportional damping by tag of the node, 1/s.
    pub(super) mass_damping: BTreeMap<i32, f64>,
    /// Global axis of an element's direction, from 1, and its sign; by tag and direction. Only those along an axis that
    /// are differences of one displacement.
    axes: BTreeMap<(i32, usize), (usize, f64)>,
}

impl ModelParts {
    /// The parts of the model that an engine holds.
    pub(super) fn from_engine(engine: &Engine) -> Self {
        let model = engine.model();
        let mut out = Self { inventory: ModelInventory::from_engine(engine), ..Self::default() };
        out.mass_damping = model.nodes.iter().map(|n| (n.tag, n.alpha_m)).collect();
        for e in &model.elements {
            let Some(ndm) = e.nodes.first().map(|n| model.nodes[n.0].ndm()) else { continue };
            for row in e.element.basic_rows() {
                let entries: Vec<(usize, f64)> =
                    row.row.iter().copied().enumerate().filter(|(_, x)| *x != 0.0).collect();
                let half = row.row.len() / 2;
                if let [(i, a), (j, b)] = entries[..]
                    && j == i + half
                    && a == -b
                    && b.abs() == 1.0
                {
                    let axis = if ndm == 2 && i == 2 { 6 } else { i + 1 };
                    out.axes.insert((e.tag, row.direction), (axis, b));
                }
            }
        }
        out
    }
}

/// Forms of a repaired script, with the commands that stay.
pub(super) struct Placement {
    /// The block in the repaired script.
    pub(super) block: InsertedBlock,
    /// Values of the added parameters.
    pub(super) declarations: Vec<String>,
    /// Amendments with their forms.
    pub(super) forms: Vec<(Amendment, StandardForm)>,
    /// The other commands of the block.
    pub(super) rest: Vec<String>,
}

/// Additions to the command of one element.
#[derive(Default)]
struct ElementEdit {
    /// Materials and their directions.
    beside: Vec<(i32, usize)>,
    /// Factors on own materials, by direction.
    factors: Vec<(usize, String)>,
}

/// The script with its amendments replaced by forms.
///
/// # Errors
/// An element is neither defined by a command of its own, nor do its directions lie along global axes.
pub(super) fn place(text: &str, p: &Placement, model: &ModelParts) -> Result<String, String> {
    let commands = top_level(text);
    let listed = |tag: i32| -> Option<&TopLevel> {
        let word = |c: &TopLevel, i: usize| c.words.get(i).map_or("", |(a, b)| &text[*a..*b]).to_owned();
        let of_tag = |c: &&TopLevel| {
            c.name == "element" && LISTED.contains(&word(c, 1).as_str()) && word(c, 2).parse() == Ok(tag)
        };
        commands.iter().filter(|c| p.block.at_top_level && c.start < p.block.whole.0).find(of_tag)
    };
    let mut edits: BTreeMap<usize, (&TopLevel, ElementEdit)> = BTreeMap::new();
    let mut between_nodes: Vec<(i32, Beside)> = vec![];
    for (amendment, form) in &p.forms {
        for tag in &amendment.tags {
            let command = listed(*tag);
            if let Some(factor) = &form.factor {
                let command = command.ok_or_else(|| format!("element {tag} has no zeroLength command of its own"))?;
                let edit = &mut edits.entry(command.start).or_insert_with(|| (command, ElementEdit::default())).1;
                edit.factors.extend(amendment.directions().into_iter().map(|d| (d, factor.clone())));
            }
            for beside in &form.beside {
                match command.filter(|_| beside.between == Between::Any) {
                    Some(command) => {
                        let edit = edits.entry(command.start).or_insert_with(|| (command, ElementEdit::default()));
                        edit.1.beside.push((beside.material, beside.direction));
                    }
                    None => between_nodes.push((*tag, *beside)),
                }
            }
        }
    }
    let materials = p.forms.iter().flat_map(|(_, form)| &form.commands);
    let mut definitions: Vec<String> = p.declarations.iter().chain(materials).cloned().collect();
    let links = links(&between_nodes, model)?;
    let mut body: Vec<String> = p.rest.iter().chain(&links).cloned().collect();
    let mut replacements: Vec<(usize, usize, String)> = vec![];
    if edits.is_empty() {
        definitions.append(&mut body);
        body = std::mem::take(&mut definitions);
    }
    let mut next_tag = model.inventory.first_tag(TagPurpose::StandardForms) + MAX_FORM_TAGS;
    for (command, edit) in edits.into_values() {
        let (wraps, words) = edited_element(text, command, &edit, &mut next_tag)?;
        definitions.extend(wraps);
        let lines = std::mem::take(&mut definitions);
        let before = if lines.is_empty() { String::new() } else { format!("{OPEN}\n{}\n{CLOSE}\n", lines.join("\n")) };
        replacements.push((command.start, command.end, before + &words));
    }
    let block = match (p.block.at_top_level, body.is_empty()) {
        (true, true) => (p.block.whole.0, p.block.whole.1, String::new()),
        (true, false) => (p.block.whole.0, p.block.whole.1, format!("{OPEN}\n{}\n{CLOSE}\n", body.join("\n"))),
        (false, _) => (p.block.body.0, p.block.body.1, body.join("\n")),
    };
    replacements.push(block);
    let mut out = text.to_owned();
    // From the end on, so that earlier places stay valid.
    replacements.sort_by_key(|r| std::cmp::Reverse(r.0));
    for (from, to, with) in replacements {
        out.replace_range(from..to.min(out.len()), &with);
    }
    Ok(out)
}

/// An element's command with further materials and directions, and commands that wrap its own materials in factors.
fn edited_element(
    text: &str,
    command: &TopLevel,
    edit: &ElementEdit,
    next_tag: &mut i32,
) -> Result<(Vec<String>, String), String> {
    let mut words: Vec<String> = command.words.iter().map(|(a, b)| text[*a..*b].to_owned()).collect();
    let is_option = |w: &String| w.starts_with('-') && w[1..].starts_with(char::is_alphabetic);
    let list = |words: &[String], option: &str| -> Option<std::ops::Range<usize>> {
        let from = words.iter().position(|w| w == option)? + 1;
        let to = words[from..].iter().position(is_option).map_or(words.len(), |n| from + n);
        Some(from..to)
    };
    let unlike = || format!("the command of element {} does not list its materials and directions", words[2]);
    let (materials, directions) = (list(&words, "-mat").ok_or_else(unlike)?, list(&words, "-dir").ok_or_else(unlike)?);
    if materials.len() != directions.len() {
        return Err(unlike());
    }
    let mut wraps = vec![];
    for (direction, factor) in &edit.factors {
        for (m, d) in materials.clone().zip(directions.clone()) {
            if words[d].parse() == Ok(*direction) {
                wraps.push(format!("uniaxialMaterial Parallel {next_tag} {} -factors {factor}", words[m]));
                words[m] = next_tag.to_string();
                *next_tag += 1;
            }
        }
    }
    let added = |of: &dyn Fn(&(i32, usize)) -> String| edit.beside.iter().map(of).collect::<Vec<_>>();
    let lists = [(materials.end, added(&|x| x.0.to_string())), (directions.end, added(&|x| x.1.to_string()))];
    let mut lists = lists.to_vec();
    lists.sort_by_key(|l| std::cmp::Reverse(l.0));
    for (at, new) in lists {
        words.splice(at..at, new);
    }
    Ok((wraps, words.join(" ")))
}

/// Elements between the nodes of others.
fn links(besides: &[(i32, Beside)], model: &ModelParts) -> Result<Vec<String>, String> {
    let mut out = vec![];
    for ((tag, beside), number) in besides.iter().zip(model.inventory.first_tag(TagPurpose::StandardForms)..) {
        let device = model.inventory.devices.iter().find(|d| d.tag == *tag);
        let axis = model.axes.get(&(*tag, beside.direction));
        let (Some(device), Some((axis, sign))) = (device, axis) else {
            return Err(format!("element {tag} does not lie along a global axis between two nodes at one place"));
        };
        let [i, j] = device.nodes;
        let mirrored = (beside.between == Between::MirroredNodes) != (*sign < 0.0);
        let (i, j) = if mirrored { (j, i) } else { (i, j) };
        out.push(format!("element zeroLength {number} {i} {j} -mat {} -dir {axis}", beside.material));
    }
    Ok(out)
}

/// First bytes of a command's name in a line of a script, where a command may begin.
pub(super) fn command_places<'a>(line: &'a str, name: &'a str) -> impl Iterator<Item = usize> + 'a {
    let begins = |before: &str| before.is_empty() || before.ends_with(['[', '{', ';', '"']);
    let places = line.match_indices(name).map(|(at, _)| at);
    places.filter(move |at| begins(line[..*at].trim_end()) && line[at + name.len()..].starts_with([' ', '\t']))
}

/// A script whose `pset` commands are plain `set` commands.
pub(super) fn with_plain_parameters(text: &str) -> String {
    let mut out = String::new();
    for line in text.split_inclusive('\n') {
        let mut plain = line.to_owned();
        if !line.trim_start().starts_with('#') {
            let places: Vec<usize> = command_places(line, "pset").collect();
            places.into_iter().rev().for_each(|at| plain.replace_range(at..at + "pset".len(), "set"));
        }
        out += &plain;
    }
    out
}
