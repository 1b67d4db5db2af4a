//! What there is in a model that could be other than it was taken for.

use super::columns::{Column, columns, girders};
use super::neighbours::{Neighbours, neighbours};
use hysteron_engine::analysis::Engine;
use hysteron_engine::element::{BasicRow, Element, ElementInput, ElementOutput};
use hysteron_engine::model::{Model, PatternKind};

/// A spring or bearing whose force can be amended.
#[derive(Clone, Debug, PartialEq)]
pub struct Device {
    /// Tag of the element.
    pub tag: i32,
    /// Its class.
    pub class: &'static str,
    /// Tags of its nodes.
    pub nodes: [i32; 2],
    /// Its directions with the column of each in its responses, and the stiffness of the virgin element.
    pub directions: Vec<Direction>,
    /// Its law is linear: it was taken as elastic.
    pub linear: bool,
    /// It has parts that depend on the rate.
    pub viscous: bool,
}

/// A direction of a device.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Direction {
    /// Number, 1 to 6.
    pub number: usize,
    /// Column in `deformation` and `basicForce`.
    pub column: usize,
    /// Initial stiffness.
    pub stiffness: f64,
    /// It is along the last axis of the model, which is the vertical one but in plan.
    pub upright: bool,
}

/// A fixed node.
#[derive(Clone, Debug, PartialEq)]
pub struct Support {
    /// Tag.
    pub node: i32,
    /// Degrees of freedom that are fixed, from 1.
    pub fixed: Vec<usize>,
    /// Degrees of freedom of the node.
    pub ndf: usize,
    /// Tags of the elements on it.
    pub elements: Vec<i32>,
    /// Stiffness of these elements in each degree of freedom, at rest.
    pub stiffness: Vec<f64>,
}

/// A node with mass.
#[derive(Clone, Debug, PartialEq)]
pub struct Mass {
    /// Tag.
    pub node: i32,
    /// Diagonal of the mass.
    pub mass: Vec<f64>,
    /// It has mass-proportional damping where the block stands.
    pub damped: bool,
}

/// What a model is made of.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Anatomy {
    /// Dimensions of the model.
    pub ndm: usize,
    /// Springs and bearings.
    pub devices: Vec<Device>,
    /// Tags of elastic beams.
    pub beams: Vec<i32>,
    /// Those of them that are columns, the lowest first.
    pub columns: Vec<Column>,
    /// And those that lie.
    pub girders: Vec<Column>,
    /// Fixed nodes.
    pub supports: Vec<Support>,
    /// Nodes with mass.
    pub masses: Vec<Mass>,
    /// Structures that stand side by side.
    pub neighbours: Vec<Neighbours>,
    /// The ground moves (an excitation, not an imposed motion of a node).
    pub shaken: bool,
    /// Diagonal of the box that holds all nodes; length.
    pub extent: f64,
    /// A number that neither a node nor an element nor a material has used; so are all above it.
    free_tag: i32,
}

/// For whose nodes, elements and materials. Two proposals can stand in one script: each kind has numbers of its
/// own.
#[derive(Clone, Copy, Debug)]
pub enum Numbers {
    /// Springs at supports.
    Foundation,
    /// The material of hinges at the ends of columns.
    Hinges,
    /// Masses beside their nodes.
    Masses,
    /// Regions with a damping of their own.
    Regions,
    /// Dashpots beside columns.
    Dashpots,
    /// Joints between neighbours.
    Joints,
}

/// How the classes of beams without a section or with an elastic one begin.
const ELASTIC: [&str; 3] = ["ElasticBeam", "ModElasticBeam", "ElasticTimoshenkoBeam"];

/// Numbers that each kind has at least.
pub const ROOM: usize = 100;

impl Anatomy {
    /// The first free number of a kind.
    pub fn free(&self, whose: Numbers) -> i32 {
        self.free_tag
            + match whose {
                Numbers::Foundation => 0,
                Numbers::Hinges => 500,
                Numbers::Masses => 600,
                Numbers::Regions => 700,
                Numbers::Dashpots => 800,
                Numbers::Joints => 900,
            }
    }

    /// Of the model that an engine holds.
    pub fn of(engine: &Engine) -> Self {
        let model = engine.model();
        let tag = |id: hysteron_engine::model::NodeId| model.nodes[id.0].tag;
        let mut out = Self { ndm: model.nodes.first().map_or(0, |n| n.ndm()), ..Self::default() };
        for e in &model.elements {
            let [i, j] = e.nodes[..] else { continue };
            let nodes = [tag(i), tag(j)];
            let rows = e.element.basic_rows();
            let nature = e.element.traits();
            if rows.is_empty() {
                // Elastic in their law: large displacements and P-Delta change where they stand, not what they are made of.
                let of_an_elastic_law = ELASTIC.iter().any(|class| e.element.class().starts_with(class));
                if (nature.linear || of_an_elastic_law) && e.dofs.len() >= 6 {
                    out.beams.push(e.tag);
                }
                continue;
            }
            let n = e.element.dofs();
            let mut tangent = vec![0.0; n * n];
            e.element.initial_tangent(&mut tangent);
            let directions = rows
                .iter()
                .map(|r| direction(r, &tangent, model.nodes[i.0].ndm()))
                .filter(|d| d.stiffness > 0.0)
                .collect();
            out.devices.push(Device {
                tag: e.tag,
                class: e.element.class(),
                nodes,
                directions,
                linear: nature.linear || elastic(e.element.as_ref(), &rows),
                viscous: nature.viscous,
            });
        }
        for (k, node) in model.nodes.iter().enumerate() {
            let fixed: Vec<usize> = model.fixes.iter().filter(|f| f.node.0 == k).map(|f| f.dof + 1).collect();
            if !fixed.is_empty() {
                let on = model.elements.iter().filter(|e| e.nodes.iter().any(|n| n.0 == k)).map(|e| e.tag);
                let (elements, stiffness) = (on.collect(), stiffness_at(model, k, node.ndf));
                out.supports.push(Support { node: node.tag, fixed, ndf: node.ndf, elements, stiffness });
            }
            if node.mass.iter().any(|m| *m > 0.0) {
                out.masses.push(Mass { node: node.tag, mass: node.mass.clone(), damped: node.alpha_m != 0.0 });
            }
        }
        out.columns = columns(model, &out.beams);
        out.girders = girders(model, &out.beams);
        out.neighbours = neighbours(model, &out.devices);
        out.shaken = shaken(model);
        out.extent = extent(model);
        let largest = model.node_tags().chain(model.element_tags()).max().unwrap_or(0);
        out.free_tag = (largest + 1).max(900_000);
        out
    }

    /// The devices that stand on the ground, as groups of the same class and directions.
    pub fn grounded(&self) -> Vec<Vec<&Device>> {
        let stands = |d: &&Device| {
            !d.directions.is_empty()
                && self.supports.iter().any(|s| d.nodes.contains(&s.node) && s.fixed.len() >= self.ndm)
        };
        grouped(self.devices.iter().filter(stands), of_a_kind)
    }

    /// The devices whose law is not linear, as groups of the same class and directions: what was built as one kind.
    pub fn groups(&self, linear: bool) -> Vec<Vec<&Device>> {
        let devices = self.devices.iter().filter(|d| d.linear == linear && !d.directions.is_empty());
        grouped(devices, of_a_kind)
    }
}

fn of_a_kind(a: &Device, b: &Device) -> bool {
    a.class == b.class && a.directions.len() == b.directions.len()
}

/// In groups whose members are like the first, in their order.
pub(super) fn grouped<'a, T>(all: impl IntoIterator<Item = &'a T>, like: impl Fn(&T, &T) -> bool) -> Vec<Vec<&'a T>> {
    let mut groups: Vec<Vec<&T>> = vec![];
    for one in all {
        match groups.iter_mut().find(|g| like(g[0], one)) {
            Some(g) => g.push(one),
            None => groups.push(vec![one]),
        }
    }
    groups
}

/// Whether the ground moves.
pub(super) fn shaken(model: &Model) -> bool {
    model.patterns.values().any(|p| !matches!(p.kind, PatternKind::Plain { .. }))
}

/// Diagonal of the box that holds all nodes.
fn extent(model: &Model) -> f64 {
    let places = || model.nodes.iter().map(|n| n.place());
    let corner = |choose: fn(f64, f64) -> f64| places().reduce(|a, b| a.zip_map(&b, choose));
    corner(f64::max).zip(corner(f64::min)).map_or(0.0, |(high, low)| (high - low).norm())
}

/// Diagonal of the initial stiffness that elements have at a node.
fn stiffness_at(model: &Model, node: usize, ndf: usize) -> Vec<f64> {
    let mut sum = vec![0.0; ndf];
    for e in &model.elements {
        let Some(end) = e.nodes.iter().position(|n| n.0 == node) else { continue };
        let (n, own) = (e.element.dofs(), e.element.dofs() / e.nodes.len());
        let mut tangent = vec![0.0; n * n];
        e.element.initial_tangent(&mut tangent);
        for (dof, sum) in sum.iter_mut().enumerate().take(own) {
            let i = end * own + dof;
            *sum += tangent[i * n + i];
        }
    }
    sum
}

fn direction(row: &BasicRow, tangent: &[f64], ndm: usize) -> Direction {
    let unit = row.at_j();
    let n = unit.len();
    let product = |k: &[f64]| k.iter().zip(unit).map(|(a, b)| a * b).sum::<f64>();
    let stiffness = tangent.chunks_exact(n).zip(unit).map(|(k, u)| u * product(k)).sum();
    // At node j; a chain along one axis has no height.
    let upright = ndm > 1 && unit.get(n / 2 + ndm - 1).is_some_and(|u| u.abs() > 0.7);
    Direction { number: row.direction, column: row.column, stiffness, upright }
}

/// Whether an element answers to a deformation in proportion, however large: springs that were taken as elastic, with or
/// without dashpots beside them. Asked by pulling, since laws do not say it.
fn elastic(element: &dyn Element, rows: &[BasicRow]) -> bool {
    let n = element.dofs();
    let mut state = vec![0.0; element.state_len()];
    element.init(&mut state);
    let (rest, load) = (vec![0.0; n], vec![0.0; element.load_len()]);
    let mut next = state.clone();
    rows.iter().all(|row| {
        let mut stiffness = |size: f64| {
            let disp: Vec<f64> = row.at_j().iter().map(|u| size * u).collect();
            let motion =
                ElementInput { disp: &disp, vel: &rest, load: &load, still: true, again: false, dt: 0.0, time: 0.0 };
            let mut force = vec![0.0; n];
            let answer = ElementOutput {
                force: &mut force,
                tangent: None,
                damping: None,
                part: hysteron_engine::element::MatrixMask::ALL,
            };
            element.respond(&motion, &state, &mut next, answer).ok()?;
            Some(row.force(&force) / size)
        };
        let small = stiffness(1e-6);
        [1e-3, 1.0, -1.0, 1e3].iter().all(|size| match (small, stiffness(*size)) {
            (Some(a), Some(b)) => (a - b).abs() <= 1e-6 * a.abs(),
            _ => false,
        })
    })
}
