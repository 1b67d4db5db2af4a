//! Place of an effect: elements or nodes with their coordinates, directions, and the level in the structure.

use super::condition_in_words::TimeSpan;
use super::quantity::{Units, digits};
use crate::candidate::variant::Variant;
use crate::inspect::heights::HeightRule;
use crate::inspect::inventory::ModelInventory;
use hysteron_identify::study::Study;
use serde::Serialize;

/// Place of an effect.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Place {
    /// Tags of the elements that it changes.
    pub elements: Vec<i32>,
    /// Nodes of these elements, or the changed nodes themselves.
    pub nodes: Vec<NodePlace>,
    /// Directions along the global axes, in words.
    pub directions: Vec<String>,
    /// Motion that meets a contact of one side, along the global axes, in words; empty for other effects.
    #[serde(skip_serializing_if = "String::is_empty")]
    pub side: String,
    /// Number of the elements or nodes that stand side by side; 1 where they do not.
    #[serde(skip)]
    pub(super) parallel_parts: usize,
    /// Level in the structure, in words; empty if the heights of the nodes do not tell it.
    pub level: String,
    /// Name of the channel at fault; empty if the model is.
    pub channel: String,
    /// Time for which the user's parameters have other values; none for other effects, and for a whole run.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub span: Option<TimeSpan>,
}

/// A node with its coordinates.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct NodePlace {
    /// Tag.
    pub tag: i32,
    /// Coordinates, in the script's unit of length.
    pub coordinates: Vec<f64>,
}

/// Nodes that a sentence lists, at most.
const MAX_LISTED: usize = 4;
/// Component of a unit vector from which a direction counts as that of an axis.
const MIN_AXIS_COMPONENT: f64 = 0.99;

/// Places of a variant's effects, with the location of each in the words of its proposal: the first effect, and the second.
pub(super) fn places(variant: &Variant, inventory: &ModelInventory) -> Vec<(String, Place)> {
    let Some(p) = &variant.proposal else { return vec![] };
    // Commands of the second effect have parameters with another prefix.
    let of_second = |c: &&String| c.contains("hy2_");
    let of = |location: &str, second: bool| {
        let commands: Vec<&str> =
            p.commands.iter().filter(|c| of_second(c) == second || !c.contains("hy")).map(String::as_str).collect();
        (location.to_owned(), place(location, &commands, inventory))
    };
    let mut out = vec![of(&p.location, false)];
    if p.second_cause.is_some() {
        out.push(of(&p.second_location, true));
    }
    out
}

/// Numbers that follow one of some words in a text.
fn tags_after(text: &str, names: [&str; 2]) -> Vec<i32> {
    let after = text.split_whitespace().skip_while(|w| !names.contains(w)).skip(1);
    after.map_while(|w| w.trim_end_matches([',', ';']).parse().ok()).collect()
}

fn place(location: &str, commands: &[&str], inventory: &ModelInventory) -> Place {
    if let Some(channel) = location.strip_prefix("channel ") {
        return Place { channel: channel.into(), ..Place::default() };
    }
    let elements = tags_after(location, ["element", "elements"]);
    let mut tags = tags_after(location, ["node", "nodes"]);
    for e in &elements {
        for n in inventory.element_nodes.get(e).into_iter().flatten() {
            if !tags.contains(n) {
                tags.push(*n);
            }
        }
    }
    let node = |tag: &i32| Some(NodePlace { tag: *tag, coordinates: inventory.coordinates.get(tag)?.clone() });
    let nodes: Vec<NodePlace> = tags.iter().filter_map(node).collect();
    Place {
        directions: directions(&elements, commands, inventory),
        side: side(&elements, &nodes, commands, inventory),
        parallel_parts: parallel_parts(&elements, &nodes, inventory),
        level: level(&elements, &nodes, inventory),
        elements,
        nodes,
        channel: String::new(),
        span: None,
    }
}

/// Global directions of the option `-dir` of the commands that amend elements.
fn directions(elements: &[i32], commands: &[&str], inventory: &ModelInventory) -> Vec<String> {
    let mut out: Vec<String> = vec![];
    let Some(device) = inventory.devices.iter().find(|d| elements.contains(&d.tag)) else { return out };
    for command in commands.iter().filter(|c| c.starts_with("amend element")) {
        for number in tags_after(command, ["-dir", "-dir"]) {
            let Some(d) = device.directions.iter().find(|d| d.number == number as usize) else { continue };
            let name = if d.number > 3 { "rotation".to_owned() } else { direction_name(d.axis, inventory) };
            if !out.contains(&name) {
                out.push(name);
            }
        }
    }
    out
}

/// Motion that meets the contact of a command with the option `-side`: of the node that no support holds, along a global axis.
/// An added element between a node and another at its place deforms along the global axes.
fn side(elements: &[i32], nodes: &[NodePlace], commands: &[&str], inventory: &ModelInventory) -> String {
    let found = || {
        let command = commands.iter().find(|c| c.starts_with("amend element") && c.contains(" -side "))?;
        let sense = tags_after(command, ["-side", "-side"]).first().map(|s| f64::from(s.signum()))?;
        let number = *tags_after(command, ["-dir", "-dir"]).first()? as usize;
        let named = |sense: f64, node: i32, along: usize| {
            let sign = if sense > 0.0 { "+" } else { "-" };
            (sense != 0.0).then(|| format!("met when node {node} moves towards {sign}{}", AXES[along]))
        };
        if let ([], [node]) = (elements, nodes) {
            return named(sense, node.tag, number.checked_sub(1).filter(|along| *along < inventory.ndm.max(1))?);
        }
        let device = inventory.devices.iter().find(|d| elements.contains(&d.tag))?;
        let axis = device.directions.iter().find(|d| d.number == number)?.axis;
        let along = (0..3).find(|i| axis[*i].abs() > MIN_AXIS_COMPONENT)?;
        let is_held = |tag: i32| inventory.is_held(tag, along + 1);
        // The deformation is the motion of the second node against the first.
        let (moving, sense) = match device.nodes {
            [first, second] if is_held(second) && !is_held(first) => (first, -sense),
            [_, second] => (second, sense),
        };
        named(sense * axis[along], moving, along)
    };
    found().unwrap_or_default()
}

/// Number of elements, or of nodes without elements, that stand side by side: their ends are at the same heights, or all are
/// on supports where the model has no height.
fn parallel_parts(elements: &[i32], nodes: &[NodePlace], inventory: &ModelInventory) -> usize {
    let all: Vec<&[i32]> = if elements.is_empty() {
        nodes.iter().map(|n| std::slice::from_ref(&n.tag)).collect()
    } else {
        elements.iter().filter_map(|e| inventory.element_nodes.get(e)).map(Vec::as_slice).collect()
    };
    let is_support = |tag: &i32| inventory.supports.iter().any(|s| s.node == *tag && s.fixed.len() >= inventory.ndm);
    let side_by_side = match inventory.vertical_axis() {
        None => all.iter().all(|nodes| nodes.iter().any(is_support)),
        Some(axis) => {
            let height = |n: &i32| inventory.coordinates.get(n).and_then(|x| x.get(axis)).copied();
            let heights = |nodes: &[i32]| {
                let mut all: Vec<f64> = nodes.iter().filter_map(height).collect();
                all.sort_by(f64::total_cmp);
                all
            };
            let near = |(a, b): (&f64, &f64)| inventory.heights.are_equal(*a, *b);
            let alike = |a: &[f64], b: &[f64]| a.len() == b.len() && a.iter().zip(b).all(near);
            all.windows(2).all(|w| alike(&heights(w[0]), &heights(w[1])))
        }
    };
    if side_by_side { all.len().max(1) } else { 1 }
}

/// Names of the global axes.
pub(super) const AXES: [&str; 3] = ["X", "Y", "Z"];

/// A direction along the global axes.
pub(super) fn direction_name(axis: [f64; 3], inventory: &ModelInventory) -> String {
    let names = AXES;
    let along = (0..3).find(|i| axis[*i].abs() > MIN_AXIS_COMPONENT);
    let vertical = inventory.vertical_axis();
    match (along, vertical) {
        (Some(i), _) if inventory.ndm == 1 => format!("direction {}", names[i]),
        (Some(i), Some(v)) => format!("{} {}", if i == v { "vertical" } else { "horizontal" }, names[i]),
        (Some(i), None) => format!("horizontal {}", names[i]),
        (None, _) => {
            let angle = axis[1].atan2(axis[0]).to_degrees();
            let horizontal = vertical.is_none_or(|v| axis[v].abs() < 1.0 - MIN_AXIS_COMPONENT);
            if horizontal { format!("horizontal, {} degrees from X", digits(angle, 2)) } else { "inclined".into() }
        }
    }
}

/// Level of elements: a storey between two floors, a floor, or the base; empty if the heights of their nodes do not tell it.
pub(super) fn level_of_elements(elements: &[i32], inventory: &ModelInventory) -> String {
    let tags = elements.iter().filter_map(|e| inventory.element_nodes.get(e)).flatten();
    let node = |tag: &i32| Some(NodePlace { tag: *tag, coordinates: inventory.coordinates.get(tag)?.clone() });
    level(elements, &tags.filter_map(node).collect::<Vec<_>>(), inventory)
}

/// Level of elements or nodes: a storey between two floors, a floor, or the base.
fn level(elements: &[i32], nodes: &[NodePlace], inventory: &ModelInventory) -> String {
    let is_support = |tag: i32| inventory.supports.iter().any(|s| s.node == tag && s.fixed.len() >= inventory.ndm);
    let at_base = || {
        let touches = |e: &i32| inventory.element_nodes.get(e).is_some_and(|n| n.iter().any(|n| is_support(*n)));
        if elements.is_empty() { nodes.iter().all(|n| is_support(n.tag)) } else { elements.iter().all(touches) }
    };
    if nodes.is_empty() {
        return String::new();
    }
    let Some(axis) = inventory.vertical_axis() else {
        return if at_base() { "at the base".into() } else { String::new() };
    };
    let height_of = |tag: i32| inventory.coordinates.get(&tag).map(|x| x[axis]);
    let equal = |a: f64, b: f64| inventory.heights.are_equal(a, b);
    // Floors are the heights of masses above the lowest node.
    let mut floors = vec![inventory.heights.range.0];
    let mut heights: Vec<f64> = inventory.masses.iter().filter_map(|m| height_of(m.node)).collect();
    heights.sort_by(f64::total_cmp);
    for h in heights {
        if floors.last().is_some_and(|f| !equal(*f, h)) {
            floors.push(h);
        }
    }
    let (bottom, top) = HeightRule::of(nodes.iter().map(|n| n.coordinates[axis])).range;
    let of = floors.len() - 1;
    let reached = floors.iter().position(|f| *f > top || equal(*f, top)).unwrap_or(of);
    if equal(bottom, top) {
        return match reached {
            _ if at_base() => "at the base".into(),
            0 => "at the base".into(),
            n if of > 1 => format!("floor {n} of {of}"),
            _ => String::new(),
        };
    }
    let begun = floors.iter().rposition(|f| *f < bottom || equal(*f, bottom)).unwrap_or(0);
    match reached {
        _ if of < 2 => String::new(),
        n if n == begun + 1 => format!("storey {n} of {of}"),
        n => format!("storeys {} to {n} of {of}", begun + 1),
    }
}

impl Place {
    /// The place in words. `location` is that of the proposal.
    pub(super) fn description(&self, location: &str, study: &Study, units: &Units) -> String {
        if !self.channel.is_empty() {
            let observed = study.runs.iter().flat_map(|r| &r.observe).find(|o| o.channel == self.channel);
            let at = observed.map_or("", |o| o.at.as_str());
            return if at.is_empty() { location.to_owned() } else { format!("{location} ({at})") };
        }
        let mut parts = vec![location.to_owned()];
        if !self.level.is_empty() {
            parts.push(self.level.clone());
        }
        let mut coordinates: Vec<String> = vec![];
        for n in &self.nodes {
            let text: Vec<String> = n.coordinates.iter().map(|x| digits(*x, 4)).collect();
            coordinates.push(format!("({})", text.join(", ")));
        }
        let tags: Vec<String> = self.nodes.iter().map(|n| n.tag.to_string()).collect();
        let unit = if units.length.is_empty() { String::new() } else { format!(" {}", units.length) };
        let same = coordinates.windows(2).all(|w| w[0] == w[1]);
        // Nodes of a chain often stand at one place.
        let chain = same && self.nodes.iter().all(|n| n.coordinates.len() == 1);
        let named = self.elements.is_empty();
        match (coordinates.len(), same) {
            (0, _) => {}
            _ if chain && !named => parts.push(format!("nodes {}", tags.join(" and "))),
            _ if chain => {}
            (1, _) if named => parts.push(format!("at {}{unit}", coordinates[0])),
            (n, true) if n <= MAX_LISTED => {
                let nodes = if named { String::new() } else { format!("nodes {} ", tags.join(" and ")) };
                parts.push(format!("{nodes}at {}{unit}", coordinates[0]));
            }
            (n, _) if n <= MAX_LISTED => {
                let each: Vec<String> = tags.iter().zip(&coordinates).map(|(t, x)| format!("{t} at {x}")).collect();
                parts.push(format!("{} {}{unit}", if n == 1 { "node" } else { "nodes" }, each.join(" and ")));
            }
            (n, _) => parts.push(format!("{n} nodes from {} to {}{unit}", coordinates[0], coordinates[n - 1])),
        }
        if !self.directions.is_empty() {
            parts.push(self.directions.join(" and "));
        }
        if !self.side.is_empty() {
            parts.push(self.side.clone());
        }
        parts.join("; ")
    }
}

#[cfg(test)]
mod tests {
    use super::{level, place};
    use crate::inspect::probe::tests::inventory_of;

    /// Two storeys in elevation on a bearing.
    const BUILDING: &str = "model basic -ndm 2 -ndf 3\nforeach {n y} {1 0. 2 0. 3 3.5 4 7.} {node $n 2. $y}\nfix 1 1 1 1\n\
        foreach n {2 3 4} {mass $n 1. 1. 0.}\nuniaxialMaterial Elastic 1 1e3\n\
        element zeroLength 1 1 2 -mat 1 1 1 -dir 1 2 6\ngeomTransf Linear 1\n\
        foreach {e i j} {2 2 3 3 3 4} {element elasticBeamColumn $e $i $j 1. 1e3 1. 1}\n\
        timeSeries Constant 2\npattern UniformExcitation 2 1 -accel 2\nconstraints Plain\nsystem FullGeneral\n\
        algorithm Linear\nintegrator Newmark 0.5 0.25\nanalysis Transient\nanalyze 2 0.01\n";

    #[test]
    fn elements_have_nodes_directions_and_storeys() {
        let inventory = inventory_of(BUILDING);
        let wall = place("element 1", &["amend element 1 gap -at $hy_gap -dir 1"], &inventory);
        assert_eq!((wall.directions, wall.level.as_str()), (vec!["horizontal X".to_owned()], "at the base"));
        let tags: Vec<i32> = wall.nodes.iter().map(|n| n.tag).collect();
        assert_eq!((tags, &wall.nodes[1].coordinates), (vec![1, 2], &vec![2.0, 0.0]));
        let lift = place("element 1", &["amend element 1 cavitation -dir 2"], &inventory);
        assert_eq!(lift.directions, ["vertical Y"]);
        let column = place("foot of element 3", &[], &inventory);
        assert_eq!((column.elements, column.level.as_str()), (vec![3], "storey 2 of 2"));
        let mass = place("node 4", &[], &inventory);
        assert_eq!(mass.level, "floor 2 of 2");
        assert_eq!(level(&[2, 3], &place("elements 2 3", &[], &inventory).nodes, &inventory), "storeys 1 to 2 of 2");
    }

    /// A side is told along the global axes, whatever the local ones are and whichever node is held.
    #[test]
    fn the_side_of_a_wall_is_that_of_the_global_axes() {
        let side = |script: &str, side: &str| {
            let command = format!("amend element 1 gap -at $hy_gap -side {side} -dir 1");
            place("element 1", &[&command], &inventory_of(script)).side
        };
        assert_eq!(side(BUILDING, "1"), "met when node 2 moves towards +X");
        assert_eq!(side(BUILDING, "-1"), "met when node 2 moves towards -X");
        assert_eq!(side(BUILDING, "0"), "");
        let turned = BUILDING.replace("-dir 1 2 6", "-dir 1 2 6 -orient -1 0 0 0 -1 0");
        assert_eq!(side(&turned, "1"), "met when node 2 moves towards -X");
        let from_above = BUILDING.replace("zeroLength 1 1 2", "zeroLength 1 2 1");
        assert_eq!(side(&from_above, "1"), "met when node 2 moves towards -X");
        let beside_mass = "amend element 9 gap -at $hy_gap -side -1 -dir 2";
        assert_eq!(place("node 4", &[beside_mass], &inventory_of(BUILDING)).side, "met when node 4 moves towards -Y");
    }

    /// Storeys stand on each other, and their forces do not add up.
    #[test]
    fn bearings_stand_side_by_side_and_storeys_do_not() {
        let inventory = inventory_of(BUILDING);
        assert_eq!(place("elements 2 3", &[], &inventory).parallel_parts, 1);
        assert_eq!(place("element 2", &[], &inventory).parallel_parts, 1);
        let twins = BUILDING.replace("geomTransf", "element zeroLength 5 1 2 -mat 1 -dir 1\ngeomTransf");
        assert_eq!(place("elements 1 5", &[], &inventory_of(&twins)).parallel_parts, 2);
    }

    #[test]
    fn a_channel_is_a_place() {
        let inventory = inventory_of(BUILDING);
        assert_eq!(place("channel roof acc", &[], &inventory).channel, "roof acc");
    }
}
