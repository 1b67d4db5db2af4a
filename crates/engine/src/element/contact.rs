//! Contact of two nodes with Coulomb friction by penalties: `zeroLengthContact2D` and `zeroLengthContact3D`; the friction
//! of `zeroLengthImpact3D` (Simo and Laursen, 1992, Computers and Structures 42, 97-116).

use super::{
    Class, Element, ElementInput, ElementOutput, ElementResult, ElementTraits, Histories, Snapshot, add_outer, dot,
};
use crate::element::roles::Roles;
use crate::numeric::axpy;
use crate::probe::Probe;
use crate::state_struct::StateStruct;
use nalgebra::Vector3;

/// Largest number of degrees of freedom.
pub(super) const CONTACT_DOFS: usize = 6;

/// Derivatives of the normal displacement and of two tangential ones.
pub(super) type ContactRows = [[f64; CONTACT_DOFS]; 3];

/// Direction of a contact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ContactDirection {
    /// Around the axis z through the origin, the secondary node inside of the primary one.
    Circular,
    /// Along an axis, 0 to 2: the normal of the primary surface points along it.
    Axis(usize),
}

/// Law of the tangential force.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactFriction {
    /// Tangential stiffness, force/length.
    pub tangential: f64,
    /// Coefficient of friction.
    pub friction: f64,
    /// Cohesion, force.
    pub cohesion: f64,
}

impl ContactFriction {
    /// Adds forces and, on demand, tangent of a contact with a pressure and its derivative by the penetration. `u` has the
    /// displacements, and `stick` those tangential ones from which the force counts. Returns the next of these.
    pub(super) fn add(
        &self,
        rows: &ContactRows,
        u: &[f64],
        (pressure, stiffness): (f64, f64),
        stick: [f64; 2],
        force: &mut [f64],
        tangent: Option<&mut [f64]>,
    ) -> [f64; 2] {
        let [n, t1, t2] = rows.each_ref().map(|row| &row[..u.len()]);
        let slid = [dot(t1, u), dot(t2, u)];
        let trial = [0, 1].map(|i| self.tangential * (slid[i] - stick[i]));
        let (size, limit) = (trial[0].hypot(trial[1]), self.friction * pressure + self.cohesion);
        let slides = size > limit;
        let share = if slides { limit / size } else { 1.0 };
        axpy(-pressure, n, force);
        axpy(share * trial[0], t1, force);
        axpy(share * trial[1], t2, force);
        if let Some(k) = tangent {
            add_outer(k, n, stiffness);
            let along = share * self.tangential;
            add_outer(k, t1, along);
            add_outer(k, t2, along);
            if slides {
                let mut direction = [0.0; CONTACT_DOFS];
                let direction = &mut direction[..u.len()];
                axpy(trial[0] / size, t1, direction);
                axpy(trial[1] / size, t2, direction);
                add_outer(k, direction, -along);
                for (row, d) in k.chunks_exact_mut(u.len()).zip(&*direction) {
                    axpy(-self.friction * stiffness * d, n, row);
                }
            }
        }
        if slides { slid } else { stick }
    }
}

/// Surface of the primary node.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ContactSurface {
    /// A line in the plane with an outward normal; `per_node` degrees of freedom, 2 or 3.
    Line {
        /// Unit normal.
        normal: [f64; 2],
        /// Degrees of freedom of a node.
        per_node: usize,
    },
    /// A plane in space, or a cylinder around an axis parallel to z through an origin.
    Space {
        /// Direction.
        direction: ContactDirection,
        /// Coordinates x and y of the axis of a cylinder.
        origin: [f64; 2],
    },
}

/// A contact of a secondary and a primary node at one place, with a normal stiffness in compression.
#[derive(Clone, Debug)]
pub struct Contact {
    surface: ContactSurface,
    /// Normal stiffness, force/length.
    normal: f64,
    friction: ContactFriction,
    places: [Vector3<f64>; 2],
}

crate::state_struct! {
    /// State variables: penetration and pressure, and the tangential displacements from which the friction counts.
    struct State {
        penetration: f64,
        pressure: f64,
        stick: [f64; 2],
    }
}

/// Penetration of a contact of two nodes in space at displaced places, and its rows.
pub(super) fn in_space(direction: ContactDirection, moved: [Vector3<f64>; 2]) -> (f64, ContactRows) {
    let pair = |v: Vector3<f64>| [v.x, v.y, v.z, -v.x, -v.y, -v.z];
    let (gap, directions) = match direction {
        ContactDirection::Axis(axis) => {
            let unit = |i: usize| Vector3::from_fn(|row, _| f64::from(u8::from(row == i % 3)));
            (moved[1][axis] - moved[0][axis], [axis, axis + 1, axis + 2].map(unit))
        }
        ContactDirection::Circular => {
            let radius = |v: &Vector3<f64>| v.x.hypot(v.y);
            let r = radius(&moved[1]);
            let radial = Vector3::new(moved[1].x / r, moved[1].y / r, 0.0);
            let round = Vector3::new(-radial.y, radial.x, 0.0);
            (radius(&moved[0]) - r, [-radial, Vector3::z(), round])
        }
    };
    (gap, directions.map(pair))
}

impl Contact {
    /// Makes a contact of the secondary and the primary node at their places; `normal` is its stiffness.
    pub fn new(surface: ContactSurface, normal: f64, friction: ContactFriction, places: [Vector3<f64>; 2]) -> Self {
        Self { surface, normal, friction, places }
    }

    fn kinematics(&self, u: &[f64]) -> (f64, ContactRows) {
        match self.surface {
            ContactSurface::Line { normal: [x, y], per_node } => {
                let part = |node: usize, axis: usize| self.places[node][axis] + u[node * per_node + axis];
                let gap = (part(1, 0) - part(0, 0)) * x + (part(1, 1) - part(0, 1)) * y;
                let mut rows = [[0.0; CONTACT_DOFS]; 3];
                for (row, [x, y]) in rows.iter_mut().zip([[x, y], [y, -x]]) {
                    (row[0], row[1]) = (x, y);
                    (row[per_node], row[per_node + 1]) = (-x, -y);
                }
                (gap, rows)
            }
            ContactSurface::Space { direction, origin } => {
                let axis = Vector3::new(origin[0], origin[1], 0.0);
                let moved = [0, 1].map(|i| self.places[i] + Vector3::from_column_slice(&u[3 * i..3 * i + 3]) - axis);
                in_space(direction, moved)
            }
        }
    }

    /// Force, tangent on demand, and the next state.
    fn contact(&self, u: &[f64], old: &State, force: &mut [f64], tangent: Option<&mut [f64]>) -> State {
        let (penetration, rows) = self.kinematics(u);
        if penetration.is_nan() || penetration < 0.0 {
            return State { penetration, pressure: 0.0, stick: old.stick };
        }
        let pressure = self.normal * penetration;
        let stick = self.friction.add(&rows, u, (pressure, self.normal), old.stick, force, tangent);
        State { penetration, pressure, stick }
    }
}

const PRESSURE: u32 = 1;
const GAP: u32 = 2;

crate::watches_columns!(Contact => nothing);

impl Element for Contact {
    fn class(&self) -> Class {
        match self.surface {
            ContactSurface::Line { .. } => Class::new("ZeroLengthContact2D", 22),
            ContactSurface::Space { .. } => Class::new("ZeroLengthContact3D", 23),
        }
    }
    fn dofs(&self) -> usize {
        match self.surface {
            ContactSurface::Line { per_node, .. } => 2 * per_node,
            ContactSurface::Space { .. } => CONTACT_DOFS,
        }
    }
    fn state_len(&self) -> usize {
        State::LEN
    }
    fn init(&self, state: &mut [f64]) {
        state.fill(0.0);
    }
    fn traits(&self) -> ElementTraits {
        ElementTraits { linear: false, symmetric: false, viscous: false, elapses: false, rayleigh: false }
    }

    fn respond(&self, m: &ElementInput<'_>, h: &mut Histories<'_>, output: ElementOutput<'_>) -> ElementResult {
        self.contact(m.disp, &State::read(h.committed), output.force, output.tangent).write(h.trial);
        Ok(())
    }

    fn initial_tangent(&self, tangent: &mut [f64]) {
        let rest = [0.0; CONTACT_DOFS];
        let n = self.dofs();
        self.contact(&rest[..n], &State::default(), &mut [0.0; CONTACT_DOFS][..n], Some(tangent));
    }

    fn roles(&self) -> Roles<'_> {
        Roles {
            renews_tangent: true,
            opensees: super::OpenSeesTraits { initial_is_current: true, ..super::OpenSeesTraits::default() },
            ..Roles::default()
        }
    }

    fn probe(&self, words: &[&str]) -> Option<Probe> {
        match words {
            ["pressure"] => Some(Probe::new(PRESSURE, ["pressure"])),
            ["gap"] => Some(Probe::new(GAP, ["gap"])),
            _ => None,
        }
    }
    fn probe_names(&self) -> Vec<&'static str> {
        vec!["pressure", "gap"]
    }
    fn read(&self, path: &[u32], s: &Snapshot<'_>, out: &mut [f64]) {
        let state = State::read(s.state);
        out[0] = if path == [GAP] { state.penetration } else { state.pressure };
    }
}
