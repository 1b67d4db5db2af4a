//! Finite elements.
//!
//! An element is a struct of constants that implements [`Element`]. Its history lies in a slice of the model's state
//! (see [`state_struct`](crate::state_struct!)). It returns forces and tangents for the motion of its nodes. Forces are those
//! that the nodes exert on the element, in global axes, node after node: OpenSees' "resisting force".
//!
//! A model with many elements of a kind calls [`Element::respond`] millions of times: it must not allocate.

pub mod amendment;
pub mod axes;
mod bar;
mod basic_row;
pub mod beam;
mod beam_column_joint;
pub mod bearing;
mod catenary_cable;
mod class;
mod contact;
mod continuum;
mod corot_truss;
mod coupled_zero_length;
pub mod damping;
pub mod friction;
mod impact;
mod inerter;
mod inner;
mod joint;
pub mod load;
mod lockstep;
mod opensees;
pub mod roles;
mod shared;
pub mod shell;
mod small_beam;
mod springs;
pub mod transform;
mod truss;
mod tubular_joint;
mod two_node_link;
mod wall;
mod zero_length;
mod zero_length_section;

use crate::material::{MaterialError, Slot, UniaxialTraits, WatchesColumns};
pub(crate) use crate::numeric::dot;
use crate::probe::Probe;
use std::any::Any;
use std::fmt;
use std::slice::SliceIndex;

pub use amendment::OutsideRange;
pub use bar::BarOptions;
pub use basic_row::{BasicRow, RowMaterial};
pub use beam_column_joint::{BeamColumnJoint, JOINT_SPRINGS, JointGeometry};
pub use catenary_cable::CatenaryCable;
pub use class::Class;
pub use contact::{Contact, ContactDirection, ContactFriction, ContactSurface};
pub use continuum::{BrickOptions, Continuum, QuadOptions, QuadraticShape};
pub use corot_truss::CorotTruss;
pub use coupled_zero_length::CoupledZeroLength;
pub use impact::{Impact, ImpactOptions};
pub use inerter::{Inerter, InerterOptions};
pub use joint::Joint;
pub use load::ElementLoad;
pub use lockstep::LockstepMaker;
pub use lockstep::{LockstepElement, LockstepMotion, LockstepOutput};
pub(crate) use lockstep::{alike, one_by_one};
pub use opensees::{CallDependent, OpenSeesCall, OpenSeesTraits, SharedState};
pub use roles::{Bearing, Roles};
pub use shell::Shell;
pub use small_beam::{PDeltaParts, SmallBeam};
pub use truss::Truss;
pub use tubular_joint::{TubularJoint, TubularJointOptions};
pub use two_node_link::{LinkOptions, TwoNodeLink};
pub use wall::{PLANE_WALL, PanelLaw, SPACE_WALL, WallFibre, WallLines, WallPanel, WallPanels, WallPlate, WallShape};
pub use zero_length::{RayleighDamping, ZeroLength};
pub use zero_length_section::ZeroLengthSection;

/// Largest number of degrees of freedom of an element that the buffers of the analysis are made for.
pub const MAX_DOFS: usize = 30;

/// Input of an element at a trial state.
#[derive(Clone, Copy, Debug)]
pub struct ElementInput<'a> {
    /// Trial displacements of its degrees of freedom, node after node.
    pub disp: &'a [f64],
    /// Trial velocities, likewise.
    pub vel: &'a [f64],
    /// Trial accelerations, likewise; empty for an element without [`roles::Inertance`].
    pub accel: &'a [f64],
    /// Its load variables, as [`roles::ElementLoads::add_load`] has summed them.
    pub load: &'a [f64],
    /// Nothing has a velocity.
    pub still: bool,
    /// Under `--compat opensees`, the call of an element that depends on the number of calls.
    pub opensees: Option<OpenSeesCall<'a>>,
    /// Domain time since the committed state.
    pub dt: f64,
    /// Domain time (the load factor of static analyses).
    pub time: f64,
    /// The analysis is not static: inertia and damping count.
    pub dynamic: bool,
}

/// Output of an element: force, and matrices of which the rows and columns of `part` have been set to zero.
#[derive(Debug)]
pub struct ElementOutput<'a> {
    /// Resisting force, length n.
    pub force: &'a mut [f64],
    /// Tangent stiffness n x n by rows; `None` where it is not needed.
    pub tangent: Option<&'a mut [f64]>,
    /// Damping matrix of viscous materials n x n by rows; `None` where it is not needed.
    pub damping: Option<&'a mut [f64]>,
    /// Rows and columns of the matrices that are read; the other entries are free.
    pub part: MatrixMask,
}

/// Rows and columns of a matrix.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MatrixMask {
    /// The rows.
    pub rows: Rows,
    /// The columns.
    pub columns: Rows,
}

impl MatrixMask {
    /// The whole matrix.
    pub const ALL: Self = Self { rows: Rows::ALL, columns: Rows::ALL };

    /// Some rows, and of these the columns of the same numbers, or all.
    #[inline]
    pub(crate) fn read_of(rows: Rows, all_columns: bool) -> Self {
        Self { rows, columns: if all_columns { Rows::ALL } else { rows } }
    }

    /// Set the rows of an n x n matrix to zero.
    #[inline]
    pub fn clear(self, matrix: &mut [f64], n: usize) {
        if self.rows.has_all(n) {
            return matrix.fill(0.0);
        }
        self.rows.among(n).for_each(|i| matrix[i * n..(i + 1) * n].fill(0.0));
    }
}

/// A choice of the degrees of freedom of an element: with bit i, the i-th.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rows(u32);

impl Rows {
    /// All of them.
    pub const ALL: Self = Self(u32::MAX);
    /// None of them.
    pub const NONE: Self = Self(0);

    /// The degrees of freedom that are free.
    pub fn of(free: impl IntoIterator<Item = bool>) -> Self {
        Self(free.into_iter().take(MAX_DOFS).enumerate().fold(0, |bits, (i, free)| bits | u32::from(free) << i))
    }

    /// Returns true if row `i` is among them.
    #[inline]
    pub fn has(self, i: usize) -> bool {
        self.0 >> i & 1 != 0
    }

    /// These, and row `i` if there are any.
    #[inline]
    pub fn and(self, i: usize) -> Self {
        if self.0 == 0 { self } else { Self(self.0 | 1 << i) }
    }

    /// These and others.
    #[inline]
    pub fn or(self, others: Self) -> Self {
        Self(self.0 | others.0)
    }

    /// Returns true if the first `n` are all among them.
    #[inline]
    pub fn has_all(self, n: usize) -> bool {
        !self.0 & ((1 << n) - 1) == 0
    }

    /// The rows among the first `n`, in order.
    #[inline]
    pub fn among(self, n: usize) -> impl Iterator<Item = usize> {
        let mut left = self.0 & ((1 << n) - 1);
        std::iter::from_fn(move || {
            let i = left.trailing_zeros();
            left &= left.wrapping_sub(1);
            (i < u32::BITS).then_some(i as usize)
        })
    }
}

/// Committed state of an element, from which a recorder reads its responses.
#[derive(Clone, Copy, Debug)]
pub struct Snapshot<'a> {
    /// Displacements of its degrees of freedom.
    pub disp: &'a [f64],
    /// Its history.
    pub state: &'a [f64],
    /// Its resisting force.
    pub force: &'a [f64],
    /// Its load variables.
    pub load: &'a [f64],
}

/// Mass of an element.
#[derive(Clone, Debug, PartialEq)]
pub enum Mass {
    /// No mass.
    None,
    /// Diagonal of a lumped mass matrix, length n.
    Lumped(Vec<f64>),
    /// Consistent mass matrix n x n by rows.
    Consistent(Vec<f64>),
}

impl Mass {
    /// A half of a mass at each of two nodes with `per_node` degrees of freedom, of which the first `ndm` translate.
    pub(crate) fn halved(mass: f64, per_node: usize, ndm: usize) -> Self {
        if mass == 0.0 {
            return Self::None;
        }
        let mut m = vec![0.0; 2 * per_node];
        for node in [0, per_node] {
            m[node..node + ndm].fill(0.5 * mass);
        }
        Self::Lumped(m)
    }
}

/// History of an element, or of a part of it: that of the committed state and that of a trial state, of equal lengths.
#[derive(Debug)]
pub struct Histories<'a> {
    /// Committed.
    pub committed: &'a [f64],
    /// Trial, to be overwritten.
    pub trial: &'a mut [f64],
}

impl Histories<'_> {
    /// A range of both.
    #[inline]
    pub fn part(&mut self, range: impl SliceIndex<[f64], Output = [f64]> + Clone) -> Histories<'_> {
        Histories { committed: &self.committed[range.clone()], trial: &mut self.trial[range] }
    }

    /// The parts before and from an index.
    #[inline]
    pub fn split_at(&mut self, index: usize) -> (Histories<'_>, Histories<'_>) {
        let ((a, b), (c, d)) = (self.committed.split_at(index), self.trial.split_at_mut(index));
        (Histories { committed: a, trial: c }, Histories { committed: b, trial: d })
    }
}

/// Constant properties of an element, by which the analysis saves work.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ElementTraits {
    /// The tangent never changes and the force is linear in the displacements (and the loads).
    pub linear: bool,
    /// The tangent is symmetric.
    pub symmetric: bool,
    /// Materials depend on the rate of the nodal velocities.
    pub viscous: bool,
    /// Materials depend on the time that passes.
    pub elapses: bool,
    /// Rayleigh damping applies to it.
    pub rayleigh: bool,
}

impl ElementTraits {
    /// Of an element that is as its materials are: symmetric, and without Rayleigh damping.
    pub(crate) fn of<'a>(materials: impl Iterator<Item = &'a Slot>) -> Self {
        let UniaxialTraits { linear, viscous, elapses } = UniaxialTraits::of(materials);
        Self { linear, symmetric: true, viscous, elapses, rayleigh: false }
    }
}

/// Answer of an element that may find no force.
pub type ElementResult<T = ()> = Result<T, ElementError>;

/// Reason why an element found no force.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ElementError(pub Box<str>);

impl fmt::Display for ElementError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for ElementError {}

impl From<MaterialError> for ElementError {
    fn from(e: MaterialError) -> Self {
        Self(e.0.into())
    }
}

/// A shear law whose backbone softens: its force falls from one deformation on, and changes its sign at another.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Softening {
    /// Largest committed deformation of a direction, without sign.
    pub deformation: f64,
    /// Deformation from which the stiffness of the backbone is negative.
    pub stiffness_end: f64,
    /// Deformation from which the backbone pushes away from rest.
    pub force_end: f64,
}

/// A deformation of a law, and the size that the law was made for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stretch {
    /// Deformation, without sign.
    pub deformation: f64,
    /// The size.
    pub size: f64,
    /// The size in words.
    pub what: &'static str,
    /// Deformations over the size that are pointed out.
    pub suspect: f64,
    /// Deformations over the size at which an analysis ends.
    pub refused: f64,
}

/// An axial load that a bearing does not carry.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Overload {
    /// Compression in it.
    pub load: f64,
    /// Its critical load.
    pub critical: f64,
}

/// A finite element.
///
/// *Always*: `class`, `dofs`, `state_len`, `init`, `traits`, `respond`, `initial_tangent`; `probe`, `probe_names` and `read` for
/// responses of its own.
///
/// *For special elements*: `roles` names what else it does, each a trait of [`roles`]: mass, loads, parameters, a damping of
/// its own, limits of its law. An element without any has `Roles::default()`.
///
/// *The default always works*: `commit`.
pub trait Element: WatchesColumns + fmt::Debug + Send + Sync + Any {
    /// Its class, by which recorders and `print` name it.
    fn class(&self) -> Class;
    /// Number of degrees of freedom n, all nodes together.
    fn dofs(&self) -> usize;
    /// Number of state variables.
    fn state_len(&self) -> usize;
    /// Write the virgin state.
    fn init(&self, state: &mut [f64]);
    /// Its constant properties.
    fn traits(&self) -> ElementTraits;

    /// Force and tangent for a trial motion from the committed history; writes every variable of `trial`.
    fn respond(&self, motion: &ElementInput<'_>, h: &mut Histories<'_>, answer: ElementOutput<'_>) -> ElementResult;

    /// Take over the history of a trial state. An element with many state variables may leave out unused ones.
    fn commit(&self, trial: &[f64], committed: &mut [f64]) {
        committed.copy_from_slice(trial);
    }

    /// Tangent of the virgin element, n x n by rows, added to a zero matrix.
    fn initial_tangent(&self, tangent: &mut [f64]);

    /// Its special tasks. An element around another one has the roles of `Inner::roles`.
    fn roles(&self) -> Roles<'_>;

    /// A response by the words of a recorder command; `None` where the element has none of that name.
    /// The global force is common to all elements and is not among them.
    fn probe(&self, words: &[&str]) -> Option<Probe>;

    /// Names of the responses, to suggest the nearest to a misspelled one.
    fn probe_names(&self) -> Vec<&'static str>;

    /// Value of a probe.
    fn read(&self, path: &[u32], snapshot: &Snapshot<'_>, out: &mut [f64]);
}

/// `k += factor aᵀ a` for a row vector `a`; `k` is n x n by rows.
#[inline]
pub(crate) fn add_outer(k: &mut [f64], a: &[f64], factor: f64) {
    let n = a.len();
    for (i, &ai) in a.iter().enumerate() {
        if ai != 0.0 {
            let f = factor * ai;
            for (kij, &aj) in k[i * n..(i + 1) * n].iter_mut().zip(a) {
                *kij += f * aj;
            }
        }
    }
}
