//! Roles of elements: what some of them do besides giving force and tangent.
//!
//! An element says by [`Element::roles`] which roles it has. A role is a trait of its own, which the analysis, a recorder
//! or the user asks; elements without the role need not know it. The methods of `dyn Element` here put one question
//! each, and have the answer of an element without the role.

use super::damping::BasicForces;
use super::lockstep::LockstepMaker;
use super::{
    BasicRow, Element, ElementError, ElementLoad, ElementResult, LockstepElement, Mass, OpenSeesTraits, OutsideRange,
    Overload, SmallBeam, Snapshot, Softening, Stretch,
};
use crate::numeric::wide::WIDTH;
use crate::parameter::{Changed, NewValue, ParameterError};
use std::fmt;
use std::sync::Arc;

/// The roles of an element; the default is an element without any.
///
/// `Inner::roles` takes this apart field by field, so that every wrapper decides on a new role.
#[derive(Clone, Copy, Debug, Default)]
pub struct Roles<'a> {
    /// It is a bearing.
    pub bearing: Option<Bearing>,
    /// It has mass.
    pub mass: Option<&'a dyn Inertia>,
    /// Its resisting force depends on accelerations.
    pub inertance: Option<&'a dyn Inertance>,
    /// It takes element loads.
    pub loads: Option<&'a dyn ElementLoads>,
    /// It has parameters.
    pub parameters: Option<&'a dyn ElementParameters>,
    /// Its basic deformations can be amended.
    pub basic_rows: Option<&'a dyn BasicDeformations>,
    /// A damping of its own can act on its basic forces.
    pub basic_forces: Option<&'a dyn BasicForces>,
    /// It has a damping of its own.
    pub own_damping: Option<&'a dyn OwnDamping>,
    /// It has a critical axial load.
    pub overload: Option<&'a dyn CriticalLoad>,
    /// Its law may soften.
    pub softening: Option<&'a dyn Backbone>,
    /// Its law was made for some size.
    pub stretch: Option<&'a dyn LawSize>,
    /// Its sections may lose all stiffness.
    pub exhausted: Option<&'a dyn SectionCapacity>,
    /// Its law was made for some range.
    pub outside_range: Option<&'a dyn LawRange>,
    /// It is a beam with an Euler load.
    pub euler_load: Option<&'a dyn EulerLoad>,
    /// It is an elastic beam, which may be evaluated beside others.
    pub small_beam: Option<&'a dyn LinearBeam>,
    /// Its history holds the tangent.
    pub kept_tangent: Option<&'a dyn KeptTangent>,
    /// Joins it with its counterparts in other models.
    pub lockstep: Option<LockstepMaker>,
    /// The tangent of a committed state differs from that of the trial state before, as of a contact that sticks again after
    /// it has slid. The tangent is then evaluated anew at the end of a step.
    pub renews_tangent: bool,
    /// Names of the columns of its global force.
    pub force_labels: ForceLabels,
    /// Differences from its counterpart in OpenSees, for an analysis under `--compat opensees`.
    pub opensees: OpenSeesTraits<'a>,
}

/// A bearing, by the carrier of its shear.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bearing {
    /// Rubber, or shear springs.
    Rubber,
    /// The friction of surfaces, which needs a normal force.
    Sliding,
}

/// Mass of an element.
pub trait Inertia: fmt::Debug {
    /// Mass.
    fn mass(&self) -> Mass;
}

/// Resisting forces in proportion to accelerations.
pub trait Inertance: fmt::Debug {
    /// Forces per acceleration that [`Element::respond`] counts in the resisting force, n x n by rows. Rayleigh damping of
    /// such an element is that of its mass alone.
    fn inertance(&self) -> Vec<f64>;
}

/// Loads on an element.
pub trait ElementLoads: fmt::Debug {
    /// Number of load variables, in which [`ElementLoads::add_load`] sums loads.
    fn load_len(&self) -> usize;

    /// Add a load, multiplied by a factor, to the load variables.
    ///
    /// # Errors
    /// The element does not take a load of this kind.
    fn add_load(&self, load: &ElementLoad, factor: f64, sums: &mut [f64]) -> ElementResult;
}

/// Numbers of an element that a script may change.
pub trait ElementParameters: fmt::Debug {
    /// The element with another value of a parameter, by the words of a `parameter` command, and the value it had. No
    /// value asks for the present one. The state variables stay the same.
    ///
    /// # Errors
    /// The element has no parameter of that name, or refuses the value.
    fn with_parameter(&self, words: &[&str], value: NewValue) -> Changed<Arc<dyn Element>>;
}

/// Basic deformations of an element of two nodes with linear kinematics.
pub trait BasicDeformations: fmt::Debug {
    /// One row for each direction.
    fn basic_rows(&self) -> Vec<BasicRow>;
}

/// A damping besides Rayleigh's, whose force OpenSees may leave out of the resisting force.
pub trait OwnDamping: fmt::Debug {
    /// The element without its own damping; `None` where it cannot be taken off.
    fn undamped(&self) -> Option<Arc<dyn Element>>;

    /// Adds the force of its own damping times a factor, where OpenSees does not count it in the resisting force.
    fn add_own_damping(&self, snapshot: &Snapshot<'_>, factor: f64, force: &mut [f64]);
}

/// A critical axial load.
pub trait CriticalLoad: fmt::Debug {
    /// The load that it carries no longer in a committed state.
    fn overload(&self, history: &[f64]) -> Option<Overload>;
}

/// A backbone that may soften.
pub trait Backbone: fmt::Debug {
    /// The ends of the backbone, and the committed deformation; `None` where it does not soften.
    fn softening(&self, history: &[f64]) -> Option<Softening>;
}

/// A law that was made for some size.
pub trait LawSize: fmt::Debug {
    /// The deformation of the law at displacements of the element's degrees of freedom.
    fn stretch(&self, disp: &[f64]) -> Stretch;
}

/// Sections that may lose all stiffness.
pub trait SectionCapacity: fmt::Debug {
    /// A section without stiffness in a state, in words; `None` where all have some.
    fn exhausted(&self, history: &[f64]) -> Option<String>;
}

/// A law that was made for some range.
pub trait LawRange: fmt::Debug {
    /// Steps outside the range up to a committed state; `None` where there are none.
    fn outside_range(&self, history: &[f64]) -> Option<OutsideRange>;
}

/// A beam that does not buckle by itself.
pub trait EulerLoad: fmt::Debug {
    /// The Euler load π² E I / L² of a beam with small displacements; `None` with large ones.
    fn euler_load(&self) -> Option<f64>;
}

/// An elastic beam.
pub trait LinearBeam: fmt::Debug {
    /// The matrices of a beam with small displacements, which are evaluated side by side; `None` with large ones. Its load
    /// variables are basic forces, then reactions.
    fn small_beam(&self) -> Option<SmallBeam<'_>>;
}

/// A tangent that follows from the history, for less than an evaluation.
pub trait KeptTangent: fmt::Debug {
    /// Adds the tangent of the last evaluation, at displacements of the element's degrees of freedom, from the history that it
    /// has written.
    fn add_kept_tangent(&self, disp: &[f64], history: &[f64], tangent: &mut [f64]);
}

/// Names of the columns of the global force of an element.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ForceLabels {
    /// `P1_1`: node and direction, of this number of nodes.
    NodeAndDirection(usize),
    /// `P1_1`: direction and node, of this number of degrees of freedom of a node.
    DirectionAndNode(usize),
    /// `Px_1`: of an element between two nodes with rotations.
    Frame,
    /// `P1`, `P2`, and so on.
    Numbered,
    /// `Fx_i` of a wall between two nodes in the plane, `globalFx_i` of one between four nodes in space.
    Wall,
}

impl Default for ForceLabels {
    fn default() -> Self {
        Self::NodeAndDirection(2)
    }
}

impl ForceLabels {
    /// Names of the columns of an element with `dofs` degrees of freedom.
    pub(crate) fn names(self, dofs: usize) -> Vec<String> {
        let axes: &[&str] = if dofs == PLANE_DOFS { &["x", "y"] } else { &["x", "y", "z"] };
        let about = if dofs == PLANE_DOFS { &["z"] } else { axes };
        let of_node = |force: &str| -> Vec<String> {
            let moments = about.iter().map(|axis| format!("M{axis}"));
            axes.iter().map(|axis| format!("{force}{axis}")).chain(moments).collect()
        };
        match self {
            Self::NodeAndDirection(nodes) => {
                (1..=nodes).flat_map(|node| (1..=dofs / nodes).map(move |i| format!("P{node}_{i}"))).collect()
            }
            Self::DirectionAndNode(n) => {
                (1..=dofs / n).flat_map(|node| (1..=n).map(move |i| format!("P{i}_{node}"))).collect()
            }
            Self::Frame => {
                (1..=2).flat_map(|end| of_node("P").into_iter().map(move |n| format!("{n}_{end}"))).collect()
            }
            Self::Numbered => (1..=dofs).map(|i| format!("P{i}")).collect(),
            Self::Wall => {
                let (whole, nodes): (_, &[_]) =
                    if dofs == PLANE_DOFS { ("", &["i", "j"]) } else { ("global", &["i", "j", "k", "l"]) };
                nodes
                    .iter()
                    .flat_map(|node| of_node("F").into_iter().map(move |n| format!("{whole}{n}_{node}")))
                    .collect()
            }
        }
    }
}

/// Degrees of freedom of two nodes with rotations in the plane.
const PLANE_DOFS: usize = 6;

/// Questions to any element about its roles.
impl dyn Element {
    /// Differences from its counterpart in OpenSees.
    pub fn opensees(&self) -> OpenSeesTraits<'_> {
        self.roles().opensees
    }

    /// The element together with its counterparts in other models, itself the first; `None` where it is not made for it.
    pub fn lockstep(&self, all: &[&Arc<dyn Element>; WIDTH]) -> Option<Box<dyn LockstepElement>> {
        self.roles().lockstep?(all)
    }

    /// The kind of bearing that it is; `None` for other elements.
    pub fn bearing(&self) -> Option<Bearing> {
        self.roles().bearing
    }

    /// Mass.
    pub fn mass(&self) -> Mass {
        self.roles().mass.map_or(Mass::None, Inertia::mass)
    }

    /// Forces per acceleration in the resisting force, n x n by rows; `None` where there are none.
    pub fn inertance(&self) -> Option<Vec<f64>> {
        self.roles().inertance.map(Inertance::inertance)
    }

    /// The element with another value of a parameter, and the value it had.
    ///
    /// # Errors
    /// The element has no parameter of that name, or refuses the value.
    pub fn with_parameter(&self, words: &[&str], value: NewValue) -> Changed<Arc<dyn Element>> {
        self.roles().parameters.map_or(Err(ParameterError::Unknown), |p| p.with_parameter(words, value))
    }

    /// Number of load variables.
    pub fn load_len(&self) -> usize {
        self.roles().loads.map_or(0, ElementLoads::load_len)
    }

    /// Add a load, multiplied by a factor, to the load variables.
    ///
    /// # Errors
    /// The element does not take the load.
    pub fn add_load(&self, load: &ElementLoad, factor: f64, sums: &mut [f64]) -> ElementResult {
        match self.roles().loads {
            Some(loads) => loads.add_load(load, factor, sums),
            None => Err(ElementError(format!("{} takes no element loads", self.class().name).into())),
        }
    }

    /// Its basic deformations; empty where it cannot be amended.
    pub fn basic_rows(&self) -> Vec<BasicRow> {
        self.roles().basic_rows.map_or_else(Vec::new, BasicDeformations::basic_rows)
    }

    /// The element without its own damping; `None` where it has none that can be taken off.
    pub fn undamped(&self) -> Option<Arc<dyn Element>> {
        self.roles().own_damping.and_then(OwnDamping::undamped)
    }

    /// The load that it carries no longer in a committed state.
    pub fn overload(&self, history: &[f64]) -> Option<Overload> {
        self.roles().overload.and_then(|e| e.overload(history))
    }

    /// The ends of a backbone that softens, and the committed deformation.
    pub fn softening(&self, history: &[f64]) -> Option<Softening> {
        self.roles().softening.and_then(|e| e.softening(history))
    }

    /// The deformation of its law at displacements of its degrees of freedom, where the law was made for some size.
    pub fn stretch(&self, disp: &[f64]) -> Option<Stretch> {
        self.roles().stretch.map(|e| e.stretch(disp))
    }

    /// A section without stiffness in a state, in words.
    pub fn exhausted(&self, history: &[f64]) -> Option<String> {
        self.roles().exhausted.and_then(|e| e.exhausted(history))
    }

    /// Steps outside the range for which its law was made, up to a committed state.
    pub fn outside_range(&self, history: &[f64]) -> Option<OutsideRange> {
        self.roles().outside_range.and_then(|e| e.outside_range(history))
    }

    /// The Euler load of a beam with small displacements, which does not buckle by itself.
    pub fn euler_load(&self) -> Option<f64> {
        self.roles().euler_load.and_then(EulerLoad::euler_load)
    }

    /// The matrices of an elastic beam with small displacements.
    pub fn small_beam(&self) -> Option<SmallBeam<'_>> {
        self.roles().small_beam.and_then(LinearBeam::small_beam)
    }

    /// Names of the columns of the global force.
    pub fn force_labels(&self) -> Vec<String> {
        self.roles().force_labels.names(self.dofs())
    }
}
