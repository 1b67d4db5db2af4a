//! The model at rest: what is drawn before anything moves.

use hysteron_engine::analysis::Engine;
use hysteron_engine::element::{Element, Mass, Snapshot};
use hysteron_engine::model::{ElementEntry, Model, PatternKind, Tag};

/// Family of an element, by which it is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Family {
    /// Beams and columns.
    Beam,
    /// Bars.
    Truss,
    /// Bearings.
    Bearing,
    /// Springs and links.
    Link,
    /// Shells.
    Shell,
    /// Solids in the plane and in space.
    Solid,
}

impl Family {
    /// All families in the order of their numbers.
    pub const ALL: [Self; 6] = [Self::Beam, Self::Truss, Self::Bearing, Self::Link, Self::Shell, Self::Solid];

    /// Name in a legend.
    pub fn name(self) -> &'static str {
        match self {
            Self::Beam => "beams",
            Self::Truss => "trusses",
            Self::Bearing => "bearings",
            Self::Link => "links",
            Self::Shell => "shells",
            Self::Solid => "solids",
        }
    }

    /// Family of an element by its class and its number of nodes.
    pub fn of(class: &str, nodes: usize) -> Self {
        match class {
            "Truss" | "CorotTruss" | "TrussSection" | "CorotTrussSection" => Self::Truss,
            "ZeroLength" | "ZeroLengthSection" | "CoupledZeroLength" | "TwoNodeLink" => Self::Link,
            c if c.starts_with("Shell") => Self::Shell,
            _ if nodes > 2 => Self::Solid,
            c if ["Beam", "beam", "Component"].iter().any(|w| c.contains(w)) => Self::Beam,
            _ => Self::Bearing,
        }
    }

    /// Returns true for the elements that are shown with loops.
    pub fn is_device(self) -> bool {
        matches!(self, Self::Bearing | Self::Link)
    }
}

/// An element at rest.
#[derive(Clone, Debug)]
pub struct SceneElement {
    /// Tag.
    pub tag: Tag,
    /// Class, by OpenSees' name.
    pub class: &'static str,
    /// Family.
    pub family: Family,
    /// Places of its nodes in [`Scene::nodes`].
    pub nodes: Vec<usize>,
    /// Local axes by rows, where it has any.
    pub axes: Option<[[f64; 3]; 3]>,
}

/// A node at rest.
#[derive(Clone, Debug)]
pub struct SceneNode {
    /// Tag.
    pub tag: Tag,
    /// Coordinates; missing ones are zero.
    pub place: [f64; 3],
    /// Number of degrees of freedom.
    pub ndf: usize,
    /// Place of its first degree of freedom among all.
    pub offset: usize,
    /// Degrees of freedom that are held: bit i for the i-th.
    pub fixed: u8,
    /// Largest mass of a translation.
    pub mass: f64,
    /// Sum of the reference forces of all patterns.
    pub load: [f64; 3],
}

/// The model at rest.
#[derive(Clone, Debug, Default)]
pub struct Scene {
    /// Number of dimensions: 1 to 3.
    pub ndm: usize,
    /// Nodes in the order of the model.
    pub nodes: Vec<SceneNode>,
    /// Elements in the order of the model.
    pub elements: Vec<SceneElement>,
    /// Pairs of nodes that constraints join: retained and constrained.
    pub ties: Vec<(usize, usize)>,
    /// Directions in which the ground moves (0 to 2).
    pub shaken: Vec<usize>,
}

impl Scene {
    /// The model of an engine.
    pub fn new(engine: &Engine) -> Self {
        let model = engine.model();
        let mut nodes: Vec<SceneNode> = model.nodes.iter().map(node).collect();
        for f in model.fixes.iter().filter(|f| f.dof < 8) {
            nodes[f.node.0].fixed |= 1 << f.dof;
        }
        let mut shaken = vec![];
        for pattern in model.patterns.values() {
            for m in pattern.motions.iter().filter(|m| m.dof < 8) {
                nodes[m.node.0].fixed |= 1 << m.dof;
            }
            for load in &pattern.nodal_loads {
                let node = &mut nodes[load.node.0];
                let translations = translations(node.ndf, model.nodes[load.node.0].ndm());
                node.load.iter_mut().zip(&load.values).take(translations).for_each(|(sum, x)| *sum += x);
            }
            if let PatternKind::Uniform(e) = &pattern.kind
                && e.direction < 3
            {
                shaken.push(e.direction);
            }
        }
        shaken.sort_unstable();
        shaken.dedup();
        add_element_masses(model, &mut nodes);
        Self {
            ndm: model.nodes.iter().map(|n| n.ndm()).max().unwrap_or(3),
            elements: model.elements.iter().map(element).collect(),
            ties: model.multi_points.iter().map(|m| (m.retained.0, m.constrained.0)).collect(),
            nodes,
            shaken,
        }
    }

    /// Returns true if nodes and elements are the same as those of a model.
    pub fn has_parts_of(&self, model: &Model) -> bool {
        self.nodes.len() == model.nodes.len()
            && self.elements.len() == model.elements.len()
            && self.nodes.iter().zip(&model.nodes).all(|(own, n)| own.tag == n.tag && own.offset == n.offset)
            && self.elements.iter().zip(&model.elements).all(|(own, e)| own.tag == e.tag)
    }

    /// Largest distance between two corners of the box around the model; one for a single point.
    pub fn size(&self) -> f64 {
        let range = |axis: usize| {
            let all = self.nodes.iter().map(|n| n.place[axis]);
            let (low, high) = all.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), x| (l.min(x), h.max(x)));
            if low <= high { high - low } else { 0.0 }
        };
        let diagonal = (0..3).map(|axis| range(axis).powi(2)).sum::<f64>().sqrt();
        if diagonal > 0.0 { diagonal } else { 1.0 }
    }
}

/// Number of translations of a node.
pub(crate) fn translations(ndf: usize, ndm: usize) -> usize {
    ndf.min(ndm).min(3)
}

fn node(n: &hysteron_engine::model::Node) -> SceneNode {
    let place = n.place();
    let masses = n.mass.iter().take(translations(n.ndf, n.ndm()));
    SceneNode {
        tag: n.tag,
        place: [place.x, place.y, place.z],
        ndf: n.ndf,
        offset: n.offset,
        fixed: 0,
        mass: masses.fold(0.0, |m, x| m.max(*x)),
        load: [0.0; 3],
    }
}

/// Add the masses of the elements to their nodes; of a consistent matrix the sums of its rows.
fn add_element_masses(model: &Model, nodes: &mut [SceneNode]) {
    for e in &model.elements {
        let (Mass::Lumped(mass) | Mass::Consistent(mass)) = e.element.mass() else { continue };
        let dofs = e.dofs.len();
        let mut at = 0;
        for id in &e.nodes {
            let node = &mut nodes[id.0];
            // One translation in a direction moves all of them: its row summed over those of the same direction.
            let moved = (0..translations(node.ndf, model.nodes[id.0].ndm())).map(|k| {
                let row = at + k;
                if mass.len() == dofs { mass[row] } else { same_direction(e, model, &mass, row, k) }
            });
            node.mass += moved.fold(0.0, f64::max);
            at += node.ndf;
        }
    }
}

/// Sum of a row of a mass matrix over the translations in a direction.
fn same_direction(e: &ElementEntry, model: &Model, mass: &[f64], row: usize, direction: usize) -> f64 {
    let dofs = e.dofs.len();
    let starts = e.nodes.iter().scan(0, |at, id| {
        *at += model.nodes[id.0].ndf;
        Some(*at - model.nodes[id.0].ndf)
    });
    starts.map(|at| mass[row * dofs + at + direction]).sum()
}

fn element(e: &ElementEntry) -> SceneElement {
    let class = e.element.class().name;
    SceneElement {
        tag: e.tag,
        class,
        family: Family::of(class, e.nodes.len()),
        nodes: e.nodes.iter().map(|n| n.0).collect(),
        axes: if e.nodes.len() == 2 { axes(&*e.element) } else { None },
    }
}

/// Local axes of an element of two nodes by rows.
fn axes(element: &dyn Element) -> Option<[[f64; 3]; 3]> {
    let mut virgin = vec![0.0; element.state_len()];
    element.init(&mut virgin);
    let (zeros, load) = (vec![0.0; element.dofs()], vec![0.0; element.load_len()]);
    let at_rest = Snapshot { disp: &zeros, state: &virgin, force: &zeros, load: &load };
    let mut axes = [[0.0; 3]; 3];
    if let Some(probes) =
        ["xaxis", "yaxis", "zaxis"].map(|w| element.probe(&[w])).into_iter().collect::<Option<Vec<_>>>()
    {
        probes.iter().zip(&mut axes).for_each(|(p, axis)| element.read(&p.path, &at_rest, axis));
        return Some(axes);
    }
    // Of a bearing, local forces are its global ones turned: the response to a unit force is a column of the rotation.
    let probe = element.probe(&["localForce"]).filter(|p| p.len() == element.dofs())?;
    let per_node = element.dofs() / 2;
    let ndm = if per_node == 6 { 3 } else { 2 };
    for global in 0..ndm {
        let (mut unit, mut local) = (zeros.clone(), zeros.clone());
        unit[global] = 1.0;
        element.read(&probe.path, &Snapshot { force: &unit, ..at_rest }, &mut local);
        (0..ndm).for_each(|axis| axes[axis][global] = local[axis]);
    }
    if ndm == 2 {
        axes[2] = [0.0, 0.0, axes[0][0] * axes[1][1] - axes[0][1] * axes[1][0]];
    }
    let is_axis = |a: &[f64; 3]| (a.iter().map(|x| x * x).sum::<f64>() - 1.0).abs() < 1e-6;
    axes.iter().all(is_axis).then_some(axes)
}
