//! The model: nodes, elements, constraints, loads, damping. It holds no state of the motion.

mod constraint;
mod damping;
mod definitions;
mod ground_motion;
mod modal_damping;
mod node;
mod pattern;

pub use constraint::{Fix, MultiPoint};
pub use damping::Rayleigh;
pub use definitions::{Definitions, Integration, Registry, kinds};
pub use ground_motion::{GroundMotion, acceleration_of};
pub use modal_damping::ModalDamping;
pub use node::Node;
pub use pattern::{Drive, Excitation, Ground, NodalLoad, Pattern, PatternKind, SupportMotion};

use crate::element::{CallDependent, Element};
use crate::material::LimitCurve;
use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::Arc;

/// Tag of an object in the script.
pub type Tag = i32;

/// Place of a node in [`Model::nodes`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct NodeId(pub usize);

/// Place of an element in [`Model::elements`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct ElementId(pub usize);

/// An element with its place in the model.
#[derive(Clone, Debug)]
pub struct ElementEntry {
    /// Tag in the script.
    pub tag: Tag,
    /// Its nodes.
    pub nodes: Vec<NodeId>,
    /// The element.
    pub element: Arc<dyn Element>,
    /// Its share in the Rayleigh damping.
    pub rayleigh: Rayleigh,
    /// Global degrees of freedom, node after node.
    pub dofs: Vec<u32>,
    /// Its state variables in the history of the model.
    pub state: Range<usize>,
    /// Its resisting force among all.
    pub force: Range<usize>,
    /// Its load variables among those of all elements.
    pub load: Range<usize>,
    /// State variables that it shares with the elements of its class.
    pub shared: Range<usize>,
    /// Limit curves of the laws in it that watch a column, each once.
    pub limit_curves: Vec<LimitCurve>,
}

/// Nodes, elements, constraints and loads.
#[derive(Clone, Debug, Default)]
pub struct Model {
    /// Nodes in the order of their making.
    pub nodes: Vec<Node>,
    /// Elements in the order of their making.
    pub elements: Vec<ElementEntry>,
    /// Single-point constraints of the domain.
    pub fixes: Vec<Fix>,
    /// Multi-point constraints.
    pub multi_points: Vec<MultiPoint>,
    /// Load patterns by tag.
    pub patterns: BTreeMap<Tag, Pattern>,
    /// Damping by modes.
    pub modal_damping: ModalDamping,
    node_of: BTreeMap<Tag, NodeId>,
    element_of: BTreeMap<Tag, ElementId>,
    /// Grows with every change that an analysis must take notice of.
    revision: u64,
    dofs: usize,
    state_len: usize,
    force_len: usize,
    load_len: usize,
    /// Shared state variables by class and number.
    shared: BTreeMap<(&'static str, usize), Range<usize>>,
}

/// Limit curves in an element, each once.
fn distinct_curves(element: &dyn Element) -> Vec<LimitCurve> {
    let mut distinct: Vec<LimitCurve> = vec![];
    for curve in element.limit_curves() {
        if !distinct.contains(curve) {
            distinct.push(curve.clone());
        }
    }
    distinct
}

impl Model {
    /// An empty model.
    pub fn new() -> Self {
        Self::default()
    }

    /// Number of degrees of freedom of all nodes, constrained ones included.
    pub fn dofs(&self) -> usize {
        self.dofs
    }
    /// Number of state variables of all elements.
    pub fn state_len(&self) -> usize {
        self.state_len
    }
    /// Length of the resisting forces of all elements.
    pub fn force_len(&self) -> usize {
        self.force_len
    }
    /// Number of load variables of all elements.
    pub fn load_len(&self) -> usize {
        self.load_len
    }
    /// Number of state variables that elements share, all classes together.
    pub fn shared_len(&self) -> usize {
        self.shared.values().map(|range| range.end).max().unwrap_or(0)
    }

    /// Number of the last change.
    pub fn revision(&self) -> u64 {
        self.revision
    }
    /// Note a change that an analysis must take notice of.
    pub fn touch(&mut self) {
        self.revision += 1;
    }

    /// Add a node; its degrees of freedom follow those of the nodes before it.
    pub fn add_node(&mut self, tag: Tag, coords: &[f64], ndf: usize) -> NodeId {
        let id = NodeId(self.nodes.len());
        self.nodes.push(Node::new(tag, coords, ndf, self.dofs));
        self.node_of.insert(tag, id);
        self.dofs += ndf;
        self.touch();
        id
    }

    /// Add an element between nodes.
    pub fn add_element(&mut self, tag: Tag, nodes: Vec<NodeId>, element: Arc<dyn Element>) -> ElementId {
        let id = ElementId(self.elements.len());
        let dofs = nodes.iter().flat_map(|&n| self.nodes[n.0].dofs()).map(|d| d as u32).collect::<Vec<_>>();
        debug_assert_eq!(dofs.len(), element.dofs());
        let mut entry = ElementEntry {
            tag,
            nodes,
            rayleigh: Rayleigh::default(),
            dofs,
            state: 0..0,
            force: 0..0,
            load: 0..0,
            shared: 0..0,
            limit_curves: distinct_curves(&*element),
            element,
        };
        self.place(&mut entry);
        self.elements.push(entry);
        self.element_of.insert(tag, id);
        self.touch();
        id
    }

    /// Give an element its variables behind those of the elements before it.
    fn place(&mut self, e: &mut ElementEntry) {
        let take = |end: &mut usize, n: usize| {
            *end += n;
            *end - n..*end
        };
        e.state = take(&mut self.state_len, e.element.state_len());
        e.force = take(&mut self.force_len, e.element.dofs());
        e.load = take(&mut self.load_len, e.element.load_len());
        let shared = e.element.opensees().calls.map_or(0, CallDependent::shared_len);
        if shared > 0 {
            let end = self.shared_len();
            e.shared = self.shared.entry((e.element.class().name, shared)).or_insert(end..end + shared).clone();
        }
    }

    /// The node with a tag.
    pub fn node(&self, tag: Tag) -> Option<NodeId> {
        self.node_of.get(&tag).copied()
    }
    /// The element with a tag.
    pub fn element(&self, tag: Tag) -> Option<ElementId> {
        self.element_of.get(&tag).copied()
    }
    /// Tags of the nodes, rising.
    pub fn node_tags(&self) -> impl Iterator<Item = Tag> + '_ {
        self.node_of.keys().copied()
    }
    /// Nodes by rising tag.
    pub fn nodes_by_tag(&self) -> impl Iterator<Item = NodeId> + '_ {
        self.node_of.values().copied()
    }
    /// Tags of the elements, rising.
    pub fn element_tags(&self) -> impl Iterator<Item = Tag> + '_ {
        self.element_of.keys().copied()
    }
    /// Elements by rising tag.
    pub fn elements_by_tag(&self) -> impl Iterator<Item = ElementId> + '_ {
        self.element_of.values().copied()
    }

    /// Put other elements in the places of some, each between the same nodes. The variables of the others move, once for all.
    pub fn replace_elements(&mut self, elements: impl IntoIterator<Item = (ElementId, Arc<dyn Element>)>) {
        for (id, element) in elements {
            debug_assert_eq!(self.elements[id.0].dofs.len(), element.dofs());
            self.elements[id.0].limit_curves = distinct_curves(&*element);
            self.elements[id.0].element = element;
        }
        self.place_elements();
        self.touch();
    }

    /// Put the ends of an element that are at one node to another one with as many degrees of freedom.
    pub fn move_element_ends(&mut self, id: ElementId, from: NodeId, to: NodeId) {
        let e = &mut self.elements[id.0];
        e.nodes.iter_mut().filter(|n| **n == from).for_each(|n| *n = to);
        let dofs = e.nodes.iter().flat_map(|n| self.nodes[n.0].dofs()).map(|d| d as u32).collect::<Vec<_>>();
        debug_assert_eq!(dofs.len(), e.dofs.len());
        e.dofs = dofs;
        self.touch();
    }

    /// Give all elements their variables anew.
    fn place_elements(&mut self) {
        (self.state_len, self.force_len, self.load_len) = (0, 0, 0);
        self.shared.clear();
        let mut elements = std::mem::take(&mut self.elements);
        elements.iter_mut().for_each(|e| self.place(e));
        self.elements = elements;
    }

    /// Remove an element. The variables of the others move to the places in [`Model::elements`].
    pub fn remove_element(&mut self, id: ElementId) {
        self.elements.remove(id.0);
        self.place_elements();
        self.element_of = self.elements.iter().enumerate().map(|(i, e)| (e.tag, ElementId(i))).collect();
        for p in self.patterns.values_mut() {
            p.element_loads.retain(|(e, _)| *e != id);
            p.element_loads.iter_mut().filter(|(e, _)| e.0 > id.0).for_each(|(e, _)| e.0 -= 1);
        }
        self.touch();
    }

    /// Remove a node with the constraints and loads on it.
    ///
    /// # Errors
    /// The tag of an element that the node belongs to.
    pub fn remove_node(&mut self, id: NodeId) -> Result<(), Tag> {
        if let Some(e) = self.elements.iter().find(|e| e.nodes.contains(&id)) {
            return Err(e.tag);
        }
        self.nodes.remove(id.0);
        let down = |n: &mut NodeId| {
            if n.0 > id.0 {
                n.0 -= 1;
            }
        };
        self.fixes.retain(|f| f.node != id);
        self.fixes.iter_mut().for_each(|f| down(&mut f.node));
        self.multi_points.retain(|m| m.constrained != id && m.retained != id);
        for m in &mut self.multi_points {
            down(&mut m.constrained);
            down(&mut m.retained);
        }
        for p in self.patterns.values_mut() {
            p.remove_node(id);
            p.nodes_mut().for_each(down);
        }
        self.dofs = 0;
        for n in &mut self.nodes {
            n.offset = self.dofs;
            self.dofs += n.ndf;
        }
        for e in &mut self.elements {
            e.nodes.iter_mut().for_each(down);
            e.dofs = e.nodes.iter().flat_map(|n| self.nodes[n.0].dofs()).map(|d| d as u32).collect();
        }
        self.node_of = self.nodes.iter().enumerate().map(|(i, n)| (n.tag, NodeId(i))).collect();
        self.touch();
        Ok(())
    }

    /// Node and local number (from 0) of a global degree of freedom.
    pub fn owner(&self, dof: usize) -> (NodeId, usize) {
        let i = self.nodes.partition_point(|n| n.offset <= dof) - 1;
        (NodeId(i), dof - self.nodes[i].offset)
    }

    /// A degree of freedom in words: `node 12, dof 3`.
    pub fn dof_name(&self, dof: usize) -> String {
        let (node, local) = self.owner(dof);
        format!("node {}, dof {}", self.nodes[node.0].tag, local + 1)
    }
}
