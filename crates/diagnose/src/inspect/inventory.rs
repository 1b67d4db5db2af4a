//! Parts of a model that may lack physics.

use super::adjacent_structures::{AdjacentNodes, adjacent_nodes};
use super::frame_members::{FrameMember, columns, girders};
use super::heights::HeightRule;
use hysteron_engine::analysis::Engine;
use hysteron_engine::element::{BasicRow, Bearing, Element, ElementInput, ElementOutput, Histories, MatrixMask};
use hysteron_engine::model::{Model, NodeId, PatternKind};
use std::collections::BTreeMap;

/// A spring or bearing whose law an amendment can change.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Device {
    /// Tag of the element.
    pub(crate) tag: i32,
    /// Class of the element.
    pub(crate) class: &'static str,
    /// Tags of its nodes.
    pub(crate) nodes: [i32; 2],
    /// Directions with a stiffness.
    pub(crate) directions: Vec<Direction>,
    /// True if the law is linear elastic, with or without a dashpot.
    pub(crate) linear: bool,
    /// True if the force depends on the rate of deformation.
    pub(crate) viscous: bool,
    /// True for a bearing with a sliding face.
    pub(crate) slides: bool,
}

/// A direction of a device.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Direction {
    /// Number, 1 to 6.
    pub(crate) number: usize,
    /// Columns of the response `basicForce` whose sum is the force. The first is that of the response `deformation`.
    pub(crate) columns: Vec<usize>,
    /// Initial stiffness.
    pub(crate) stiffness: f64,
    /// True if the direction is along the last axis of the model, which is vertical except in plan.
    pub(crate) along_last_axis: bool,
    /// Components along the global axes of a unit deformation; 0 for rotations.
    pub(crate) axis: [f64; 3],
}

/// A fixed node.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Support {
    /// Tag of the node.
    pub(crate) node: i32,
    /// Fixed degrees of freedom, from 1.
    pub(crate) fixed: Vec<usize>,
    /// Number of degrees of freedom of the node.
    pub(crate) ndf: usize,
    /// Tags of the connected elements.
    pub(crate) elements: Vec<i32>,
    /// Initial stiffness of these elements in each degree of freedom.
    pub(crate) stiffness: Vec<f64>,
}

/// A node with mass.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Mass {
    /// Tag of the node.
    pub(crate) node: i32,
    /// Mass in each degree of freedom.
    pub(crate) mass: Vec<f64>,
    /// True if the node has mass-proportional damping before further commands run.
    pub(crate) damped: bool,
}

/// Parts of a model.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct ModelInventory {
    /// Dimensions of the model.
    pub(crate) ndm: usize,
    /// Springs and bearings.
    pub(crate) devices: Vec<Device>,
    /// Dashpots, which have no stiffness in any direction.
    pub(crate) dashpots: Vec<Device>,
    /// Tags of elastic beams.
    pub(crate) beams: Vec<i32>,
    /// Columns among these beams, the lowest first.
    pub(crate) columns: Vec<FrameMember>,
    /// Girders among these beams.
    pub(crate) girders: Vec<FrameMember>,
    /// Fixed nodes.
    pub(crate) supports: Vec<Support>,
    /// Nodes with mass.
    pub(crate) masses: Vec<Mass>,
    /// Nodes of structures that could collide.
    pub(crate) adjacent: Vec<AdjacentNodes>,
    /// True if the ground is excited; false if motions of nodes are imposed.
    pub(crate) base_excited: bool,
    /// True if one motion excites all supports.
    pub(crate) uniformly_excited: bool,
    /// Diagonal of the box around all nodes, length.
    pub(crate) extent: f64,
    /// Heights, and which of them count as one.
    pub(crate) heights: HeightRule,
    /// Coordinates of all nodes by tag, length.
    pub(crate) coordinates: BTreeMap<i32, Vec<f64>>,
    /// Tags of the nodes of all elements by tag.
    pub(crate) element_nodes: BTreeMap<i32, Vec<i32>>,
    /// First tag above those of all nodes and elements.
    first_free_tag: i32,
}

/// Purpose of added nodes, elements and materials.
///
/// Each purpose has tags of its own, so that two proposals can share a script.
#[derive(Clone, Copy, Debug)]
pub(crate) enum TagPurpose {
    /// Springs and dashpots below supports.
    Foundation,
    /// Bearings of an isolation layer below supports.
    IsolationLayer,
    /// Bearings of an isolation layer between storeys.
    MiddleLayer,
    /// Materials of plastic hinges.
    Hinges,
    /// Nodes of eccentric masses.
    Masses,
    /// Damping regions.
    Regions,
    /// Dashpots beside columns.
    Dashpots,
    /// Dashpots between a mass and the ground.
    GroundDashpots,
    /// Contact elements between adjacent structures.
    Joints,
    /// Walls beside a mass.
    MassContacts,
    /// Materials and elements of a repair in OpenSees' standard commands.
    StandardForms,
    /// Materials of whole laws.
    WholeLaws,
}

/// Prefixes of the classes of elastic beams.
const ELASTIC_BEAM_CLASSES: [&str; 3] = ["ElasticBeam", "ModElasticBeam", "ElasticTimoshenkoBeam"];

/// Number of tags that each purpose has at least.
pub(crate) const TAGS_PER_PURPOSE: usize = 100;

impl ModelInventory {
    /// The first free tag of a purpose.
    pub(crate) fn first_tag(&self, purpose: TagPurpose) -> i32 {
        self.first_free_tag
            + match purpose {
                TagPurpose::Foundation => 0,
                TagPurpose::IsolationLayer => 200,
                TagPurpose::MiddleLayer => 400,
                TagPurpose::Hinges => 500,
                TagPurpose::Masses => 600,
                TagPurpose::Regions => 700,
                TagPurpose::Dashpots => 800,
                TagPurpose::Joints => 900,
                TagPurpose::StandardForms => 1000,
                TagPurpose::MassContacts => 4800,
                TagPurpose::GroundDashpots => 4900,
                TagPurpose::WholeLaws => 5000,
            }
    }

    /// Inventory of the model that an engine holds.
    pub(crate) fn from_engine(engine: &Engine) -> Self {
        let model = engine.model();
        let tag = |id: NodeId| model.nodes[id.0].tag;
        let mut out = Self { ndm: model.nodes.first().map_or(0, |n| n.ndm()), ..Self::default() };
        for e in &model.elements {
            let [i, j] = e.nodes[..] else { continue };
            let nodes = [tag(i), tag(j)];
            let rows = e.element.basic_rows();
            let traits = e.element.traits();
            if rows.is_empty() {
                // Large displacements and P-Delta change the geometry, not the law.
                let elastic_law = ELASTIC_BEAM_CLASSES.iter().any(|class| e.element.class().name.starts_with(class));
                if (traits.linear || elastic_law) && e.dofs.len() >= 6 {
                    out.beams.push(e.tag);
                }
                continue;
            }
            let n = e.element.dofs();
            let mut tangent = vec![0.0; n * n];
            e.element.initial_tangent(&mut tangent);
            let all: Vec<Direction> = rows.iter().map(|r| direction(r, &tangent, model.nodes[i.0].ndm())).collect();
            let directions: Vec<Direction> = all.iter().filter(|d| d.stiffness > 0.0).cloned().collect();
            let linear = traits.linear || is_elastic(e.element.as_ref(), &rows);
            let (tag, class) = (e.tag, e.element.class().name);
            let slides = e.element.bearing() == Some(Bearing::Sliding);
            let device = Device { tag, class, nodes, directions, linear, viscous: traits.viscous, slides };
            if device.viscous && device.directions.is_empty() {
                out.dashpots.push(Device { directions: all, ..device.clone() });
            }
            out.devices.push(device);
        }
        for (k, node) in model.nodes.iter().enumerate() {
            let fixed: Vec<usize> = model.fixes.iter().filter(|f| f.node.0 == k).map(|f| f.dof + 1).collect();
            if !fixed.is_empty() {
                let connected = model.elements.iter().filter(|e| e.nodes.iter().any(|n| n.0 == k)).map(|e| e.tag);
                let (elements, stiffness) = (connected.collect(), stiffness_at(model, k, node.ndf));
                out.supports.push(Support { node: node.tag, fixed, ndf: node.ndf, elements, stiffness });
            }
            if node.mass.iter().any(|m| *m > 0.0) {
                out.masses.push(Mass { node: node.tag, mass: node.mass.clone(), damped: node.alpha_m != 0.0 });
            }
        }
        out.columns = columns(model, &out.beams);
        out.girders = girders(model, &out.beams);
        out.adjacent = adjacent_nodes(model, &out.devices);
        out.note_excitation(model);
        out.extent = extent(model);
        out.heights = HeightRule::of_model(model);
        out.coordinates =
            model.nodes.iter().map(|n| (n.tag, n.place().iter().copied().take(n.ndm()).collect())).collect();
        let tags_of = |nodes: &[NodeId]| nodes.iter().map(|n| tag(*n)).collect();
        out.element_nodes = model.elements.iter().map(|e| (e.tag, tags_of(&e.nodes))).collect();
        let largest = model.node_tags().chain(model.element_tags()).max().unwrap_or(0);
        out.first_free_tag = (largest + 1).max(MIN_ADDED_TAG);
        out
    }

    /// Notes the excitations of a model, beside those known already.
    pub(crate) fn note_excitation(&mut self, model: &Model) {
        let has = |is: fn(&PatternKind) -> bool| model.patterns.values().any(|p| is(&p.kind));
        self.base_excited |= has(|k| !matches!(k, PatternKind::Plain { .. }));
        self.uniformly_excited |= has(|k| matches!(k, PatternKind::Uniform(_)));
    }

    /// The same with dashpots in the place of devices, where no device has a stiffness.
    pub(crate) fn with_lone_dashpots(self) -> Self {
        if self.devices.iter().any(|d| !d.directions.is_empty()) {
            return self;
        }
        Self { devices: self.dashpots.clone(), ..self }
    }

    /// Members by the storey or floor that they stand on, the lowest first.
    pub(crate) fn storeys<'a>(&self, members: &'a [FrameMember]) -> Vec<Vec<&'a FrameMember>> {
        grouped(members, |a, b| self.heights.are_equal(a.level, b.level))
    }

    /// Mass of all nodes in their first degree of freedom.
    pub(crate) fn total_mass(&self) -> f64 {
        self.masses.iter().map(|m| m.mass[0]).sum()
    }

    /// Returns true if a column alone stands on a support.
    pub(crate) fn carries_one_column(&self, support: &Support) -> bool {
        self.columns.iter().any(|c| c.foot == support.node && support.elements == [c.tag])
    }

    /// Returns true if a node is fixed in a degree of freedom.
    pub(crate) fn is_held(&self, node: i32, dof: usize) -> bool {
        self.supports.iter().any(|s| s.node == node && s.fixed.contains(&dof))
    }

    /// Index of the vertical axis: the last one. None for a plan, in which supports reach as far as the free nodes.
    pub(crate) fn vertical_axis(&self) -> Option<usize> {
        let axis = self.ndm.checked_sub(1).filter(|n| *n > 0)?;
        if axis == 2 {
            return Some(axis);
        }
        let heights = |fixed: bool| {
            let of = move |tag: &i32| self.supports.iter().any(|s| s.node == *tag && s.fixed.len() >= 2) == fixed;
            self.coordinates.iter().filter(move |(tag, _)| of(tag)).map(move |(_, x)| x[axis])
        };
        let (supports, free) =
            (heights(true).fold(f64::NEG_INFINITY, f64::max), heights(false).fold(f64::NEG_INFINITY, f64::max));
        (supports < free).then_some(axis)
    }

    /// Devices on supports, grouped by kind.
    pub(crate) fn ground_supported_groups(&self) -> Vec<Vec<&Device>> {
        let on_support = |d: &&Device| {
            !d.directions.is_empty()
                && self.supports.iter().any(|s| d.nodes.contains(&s.node) && s.fixed.len() >= self.ndm)
        };
        grouped(self.devices.iter().filter(on_support), of_one_kind)
    }

    /// All devices, grouped by kind.
    pub(crate) fn groups_of_one_kind(&self) -> Vec<Vec<&Device>> {
        grouped(self.devices.iter().filter(|d| !d.directions.is_empty()), of_one_kind)
    }

    /// Devices with a linear law, or those without, grouped by kind.
    pub(crate) fn device_groups(&self, linear: bool) -> Vec<Vec<&Device>> {
        let devices = self.devices.iter().filter(|d| d.linear == linear && !d.directions.is_empty());
        grouped(devices, of_one_kind)
    }
}

/// Returns true for devices of one class with the same directions, of which the same are along the last axis.
fn of_one_kind(a: &Device, b: &Device) -> bool {
    let alike = |(a, b): (&Direction, &Direction)| a.number == b.number && a.along_last_axis == b.along_last_axis;
    a.class == b.class && a.directions.len() == b.directions.len() && a.directions.iter().zip(&b.directions).all(alike)
}

/// Groups whose members are alike to their first member, in the order of the input.
pub(crate) fn grouped<'a, T>(all: impl IntoIterator<Item = &'a T>, alike: impl Fn(&T, &T) -> bool) -> Vec<Vec<&'a T>> {
    let mut groups: Vec<Vec<&T>> = vec![];
    for one in all {
        match groups.iter_mut().find(|g| alike(g[0], one)) {
            Some(g) => g.push(one),
            None => groups.push(vec![one]),
        }
    }
    groups
}

/// Diagonal of the box around all nodes.
fn extent(model: &Model) -> f64 {
    let places = || model.nodes.iter().map(|n| n.place());
    let corner = |choose: fn(f64, f64) -> f64| places().reduce(|a, b| a.zip_map(&b, choose));
    corner(f64::max).zip(corner(f64::min)).map_or(0.0, |(high, low)| (high - low).norm())
}

/// Diagonal of the initial stiffness of all elements at a node.
fn stiffness_at(model: &Model, node: usize, ndf: usize) -> Vec<f64> {
    let mut sum = vec![0.0; ndf];
    for e in &model.elements {
        let Some(end) = e.nodes.iter().position(|n| n.0 == node) else { continue };
        let (n, dofs_per_node) = (e.element.dofs(), e.element.dofs() / e.nodes.len());
        let mut tangent = vec![0.0; n * n];
        e.element.initial_tangent(&mut tangent);
        for (dof, sum) in sum.iter_mut().enumerate().take(dofs_per_node) {
            let i = end * dofs_per_node + dof;
            *sum += tangent[i * n + i];
        }
    }
    sum
}

/// A direction with its stiffness uᵀ K u, where u is the unit deformation at the second node.
fn direction(row: &BasicRow, tangent: &[f64], ndm: usize) -> Direction {
    let unit = row.at_j();
    let n = unit.len();
    let product = |k: &[f64]| k.iter().zip(unit).map(|(a, b)| a * b).sum::<f64>();
    let stiffness = tangent.chunks_exact(n).zip(unit).map(|(k, u)| u * product(k)).sum();
    // A chain along one axis has no height.
    let along_last_axis = ndm > 1 && unit.get(n / 2 + ndm - 1).is_some_and(|u| u.abs() > MIN_VERTICAL_COMPONENT);
    let component =
        |i: usize| if i < ndm && row.direction <= 3 { unit.get(n / 2 + i).copied().unwrap_or(0.0) } else { 0.0 };
    let axis = [0, 1, 2].map(component);
    let columns = [&[row.column], &row.further_columns[..]].concat();
    Direction { number: row.direction, columns, stiffness, along_last_axis, axis }
}

/// Component along the last axis from which a direction is vertical.
const MIN_VERTICAL_COMPONENT: f64 = 0.7;
/// Least tag of an added node, element or material; it leaves the tags of later commands free.
const MIN_ADDED_TAG: i32 = 900_000;

/// Deformations at which proportionality is tested, length or angle, against [`SMALLEST_DEFORMATION`].
const TESTED_DEFORMATIONS: [f64; 4] = [1e-3, 1.0, -1.0, 1e3];
/// Deformation that gives the initial stiffness.
const SMALLEST_DEFORMATION: f64 = 1e-6;
/// Relative difference of stiffnesses that counts as none.
const EQUAL_STIFFNESS: f64 = 1e-6;

/// Returns true if the force of an element is proportional to its deformation at every tested size.
///
/// The element is deformed at rest, because laws do not state their linearity.
fn is_elastic(element: &dyn Element, rows: &[BasicRow]) -> bool {
    let n = element.dofs();
    let mut state = vec![0.0; element.state_len()];
    element.init(&mut state);
    let (rest, load) = (vec![0.0; n], vec![0.0; element.load_len()]);
    let mut next = state.clone();
    rows.iter().all(|row| {
        let mut stiffness = |size: f64| {
            let disp: Vec<f64> = row.at_j().iter().map(|u| size * u).collect();
            let motion = ElementInput {
                disp: &disp,
                vel: &rest,
                accel: &[],
                load: &load,
                still: true,
                opensees: None,
                dt: 0.0,
                time: 0.0,
                dynamic: false,
            };
            let mut force = vec![0.0; n];
            let output = ElementOutput { force: &mut force, tangent: None, damping: None, part: MatrixMask::ALL };
            element.respond(&motion, &mut Histories { committed: &state, trial: &mut next }, output).ok()?;
            Some(row.force(&force) / size)
        };
        let initial = stiffness(SMALLEST_DEFORMATION);
        TESTED_DEFORMATIONS.iter().all(|size| match (initial, stiffness(*size)) {
            (Some(a), Some(b)) => (a - b).abs() <= EQUAL_STIFFNESS * a.abs(),
            _ => false,
        })
    })
}
