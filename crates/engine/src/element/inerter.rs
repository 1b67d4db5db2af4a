//! Forces in proportion to relative accelerations of two nodes: `inerter`.

use super::two_node_link::{global_matrix, local_axes, p_delta_forces, pull_back};
use super::{
    Class, Element, ElementError, ElementInput, ElementOutput, ElementResult, ElementTraits, Histories, Mass, Snapshot,
    add_outer,
};
use crate::element::roles::{ForceLabels, Inertance, Inertia, OwnDamping, Roles};
use crate::probe::Probe;
use nalgebra::Matrix3;
use std::sync::Arc;

/// An inerter between two nodes: basic forces q = B ë + C ė for relative motions e along or about local axes (Smith,
/// IEEE Transactions on Automatic Control 47 (2002) 1648). Inertance and damping matrix may couple the directions. The
/// axial force has optional P-Delta effects, as in [`TwoNodeLink`](super::TwoNodeLink).
///
/// Both forces act in transient analyses only. The resisting force has that of the inertance, not that of the damping.
#[derive(Clone, Debug)]
pub struct Inerter {
    ndm: usize,
    per_node: usize,
    /// Directions, from 1.
    directions: Vec<usize>,
    /// Row of each relative motion, for global displacements.
    rows: Vec<Vec<f64>>,
    axes: Matrix3<f64>,
    /// Transformation from global to local displacements, n x n by rows.
    local: Vec<f64>,
    /// Global forces per unit of axial force and displacement, n x n by rows; empty without P-Delta.
    p_delta: Vec<f64>,
    inertance: Vec<f64>,
    damping: Vec<f64>,
    mass: f64,
    rayleigh: bool,
}

/// Properties of an [`Inerter`].
#[derive(Clone, Debug, Default)]
pub struct InerterOptions {
    /// Directions from 1, the degrees of freedom of a node; m of them.
    pub directions: Vec<usize>,
    /// Inertance B, m x m by rows: force over acceleration.
    pub inertance: Vec<f64>,
    /// Damping matrix C, m x m by rows: force over velocity; empty without damping.
    pub damping: Vec<f64>,
    /// Shares of the P-Delta moments, as in [`LinkOptions`](super::LinkOptions).
    pub p_delta: Option<[f64; 4]>,
    /// Mass, half at each end.
    pub mass: f64,
    /// Rayleigh damping of the model applies to the mass.
    pub rayleigh: bool,
}

impl Inerter {
    /// Makes an inerter between two nodes at a distance `length` with `per_node` degrees of freedom in `ndm` dimensions;
    /// `axes` has the local axes as rows.
    ///
    /// # Errors
    /// A direction without a degree of freedom; matrices of another size; P-Delta shear forces at zero length.
    pub fn new(
        (ndm, per_node): (usize, usize),
        axes: Matrix3<f64>,
        length: f64,
        options: InerterOptions,
    ) -> ElementResult<Self> {
        let InerterOptions { directions, inertance, damping, p_delta, mass, rayleigh } = options;
        let m = directions.len();
        if directions.iter().any(|d| *d == 0 || *d > per_node) {
            return Err(ElementError(format!("inerter: the nodes have {per_node} degrees of freedom").into()));
        }
        if inertance.len() != m * m || !(damping.is_empty() || damping.len() == m * m) {
            return Err(ElementError(format!("inerter: a matrix for {m} directions has {} numbers", m * m).into()));
        }
        let local = local_axes(&axes, ndm, per_node);
        let rows = directions.iter().map(|d| {
            let mut row = vec![0.0; 2 * per_node];
            (row[d - 1], row[d - 1 + per_node]) = (-1.0, 1.0);
            pull_back(&row, &local)
        });
        let p_delta = match p_delta {
            None => vec![],
            Some(ratios) => global_matrix(&p_delta_forces(&directions, ratios, (ndm, per_node), length)?, &local),
        };
        Ok(Self {
            ndm,
            per_node,
            rows: rows.collect(),
            directions,
            axes,
            local,
            p_delta,
            inertance,
            damping,
            mass,
            rayleigh,
        })
    }

    /// Relative motions of displacements, velocities or accelerations; zeros for an empty slice.
    fn relative(&self, motion: &[f64], out: &mut [f64]) {
        for (o, row) in out.iter_mut().zip(&self.rows) {
            *o = row.iter().zip(motion).map(|(r, u)| r * u).sum();
        }
    }

    /// Basic forces of a matrix times relative motions.
    fn basic<'a>(matrix: &'a [f64], motion: &'a [f64]) -> impl Iterator<Item = f64> + 'a {
        matrix.chunks_exact(motion.len().max(1)).map(move |row| row.iter().zip(motion).map(|(b, x)| b * x).sum())
    }

    /// Adds the global forces of a matrix times relative motions. Returns the axial one.
    fn add_force(&self, matrix: &[f64], motion: &[f64], disp: &[f64], factor: f64, force: &mut [f64]) -> f64 {
        let mut axial = 0.0;
        for ((q, row), direction) in Self::basic(matrix, motion).zip(&self.rows).zip(&self.directions) {
            force.iter_mut().zip(row).for_each(|(f, r)| *f += factor * q * r);
            axial += if *direction == 1 { factor * q } else { 0.0 };
        }
        if axial != 0.0 && !self.p_delta.is_empty() {
            for (f, row) in force.iter_mut().zip(self.p_delta.chunks_exact(disp.len())) {
                *f += axial * row.iter().zip(disp).map(|(g, u)| g * u).sum::<f64>();
            }
        }
        axial
    }

    /// The matrix of some basic forces per relative motion for global motions, added to a matrix n x n by rows.
    fn add_matrix(&self, matrix: &[f64], out: &mut [f64]) {
        let (m, n) = (self.rows.len(), self.dofs());
        for (i, row_i) in self.rows.iter().enumerate() {
            for (j, row_j) in self.rows.iter().enumerate().filter(|(j, _)| matrix[i * m + j] != 0.0) {
                if i == j {
                    add_outer(out, row_i, matrix[i * m + i]);
                    continue;
                }
                for (out, ri) in out.chunks_exact_mut(n).zip(row_i) {
                    out.iter_mut().zip(row_j).for_each(|(o, rj)| *o += matrix[i * m + j] * ri * rj);
                }
            }
        }
    }
}

/// Relative displacements, velocities and accelerations of a state, m of each.
fn motions(state: &[f64]) -> [&[f64]; 3] {
    let m = state.len() / 3;
    [&state[..m], &state[m..2 * m], &state[2 * m..]]
}

const LOCAL_FORCE: u32 = 1;
const BASIC_FORCE: u32 = 2;
const LOCAL_DISP: u32 = 3;
const DEFORMATION: u32 = 4;
const VELOCITY: u32 = 5;
const ACCELERATION: u32 = 6;
const BOTH: u32 = 7;
const X_AXIS: u32 = 20;
const Z_AXIS: u32 = 22;

crate::watches_columns!(Inerter => nothing);

impl Element for Inerter {
    fn class(&self) -> Class {
        Class::new("Inerter", 191)
    }
    fn dofs(&self) -> usize {
        2 * self.per_node
    }
    fn state_len(&self) -> usize {
        3 * self.rows.len()
    }
    fn init(&self, state: &mut [f64]) {
        state.fill(0.0);
    }
    fn traits(&self) -> ElementTraits {
        let asymmetric = |matrix: &[f64]| {
            let m = self.rows.len();
            !matrix.is_empty() && (0..m).any(|i| (0..i).any(|j| matrix[i * m + j] != matrix[j * m + i]))
        };
        ElementTraits {
            linear: false,
            symmetric: self.p_delta.is_empty() && !asymmetric(&self.inertance) && !asymmetric(&self.damping),
            viscous: true,
            elapses: false,
            rayleigh: self.rayleigh,
        }
    }

    fn respond(&self, motion: &ElementInput<'_>, h: &mut Histories<'_>, output: ElementOutput<'_>) -> ElementResult {
        let (disp, rates) = h.trial.split_at_mut(self.rows.len());
        let (vel, accel) = rates.split_at_mut(self.rows.len());
        self.relative(motion.disp, disp);
        rates_of(motion.dynamic, motion.vel, vel, |v, out| self.relative(v, out));
        rates_of(motion.dynamic, motion.accel, accel, |a, out| self.relative(a, out));
        let axial = self.add_force(&self.inertance, accel, motion.disp, 1.0, output.force)
            + self.add_force(&self.damping, vel, motion.disp, 1.0, output.force);
        // The derivatives of the axial force by the rates are omitted.
        if let Some(k) = output.tangent.filter(|_| axial != 0.0 && !self.p_delta.is_empty()) {
            k.iter_mut().zip(&self.p_delta).for_each(|(k, g)| *k += axial * g);
        }
        if let Some(c) = output.damping.filter(|_| !self.damping.is_empty()) {
            self.add_matrix(&self.damping, c);
        }
        Ok(())
    }

    fn initial_tangent(&self, _: &mut [f64]) {}

    fn roles(&self) -> Roles<'_> {
        Roles {
            mass: Some(self),
            inertance: Some(self),
            own_damping: (!self.damping.is_empty()).then_some(self as &dyn OwnDamping),
            force_labels: ForceLabels::Numbered,
            ..Roles::default()
        }
    }

    fn probe(&self, words: &[&str]) -> Option<Probe> {
        let nodal = |stem: &str| (1..=self.dofs()).map(|i| format!("{stem}{i}")).collect::<Vec<_>>();
        let basic = |stem: &str| (1..=self.rows.len()).map(|i| format!("{stem}{i}")).collect::<Vec<_>>();
        Some(match *words.first()? {
            "localForce" | "localForces" => Probe::new(LOCAL_FORCE, nodal("p")),
            "basicForce" | "basicForces" => Probe::new(BASIC_FORCE, basic("q")),
            "localDisplacement" | "localDisplacements" => Probe::new(LOCAL_DISP, nodal("dl")),
            "deformation" | "deformations" | "basicDeformation" | "basicDeformations" | "basicDisplacement"
            | "basicDisplacements" => Probe::new(DEFORMATION, basic("db")),
            "velocity" | "velocities" | "basicVelocity" | "basicVelocities" => Probe::new(VELOCITY, basic("vb")),
            "acceleration" | "accelerations" | "basicAcceleration" | "basicAccelerations" => {
                Probe::new(ACCELERATION, basic("ab"))
            }
            "accelANDforce" | "accelerationANDforce" | "accelerationsANDforces" => {
                Probe::new(BOTH, basic("ab").into_iter().chain(basic("q")))
            }
            "xaxis" => Probe::new(X_AXIS, ["x", "y", "z"]),
            "yaxis" => Probe::new(X_AXIS + 1, ["x", "y", "z"]),
            "zaxis" => Probe::new(Z_AXIS, ["x", "y", "z"]),
            _ => return None,
        })
    }

    fn probe_names(&self) -> Vec<&'static str> {
        vec![
            "localForce",
            "basicForce",
            "localDisplacement",
            "deformation",
            "velocity",
            "acceleration",
            "accelerationANDforce",
        ]
    }

    fn read(&self, path: &[u32], s: &Snapshot<'_>, out: &mut [f64]) {
        let [disp, vel, accel] = motions(s.state);
        let to_local = |global: &[f64], out: &mut [f64]| {
            for (o, row) in out.iter_mut().zip(self.local.chunks_exact(global.len())) {
                *o = row.iter().zip(global).map(|(t, g)| t * g).sum();
            }
        };
        let forces =
            |out: &mut [f64]| out.iter_mut().zip(Self::basic(&self.inertance, accel)).for_each(|(o, q)| *o = q);
        match path[0] {
            LOCAL_FORCE => {
                let mut force = vec![0.0; self.dofs()];
                self.add_force(&self.inertance, accel, s.disp, 1.0, &mut force);
                to_local(&force, out);
            }
            BASIC_FORCE => forces(out),
            LOCAL_DISP => to_local(s.disp, out),
            DEFORMATION => out.copy_from_slice(disp),
            VELOCITY => out.copy_from_slice(vel),
            ACCELERATION => out.copy_from_slice(accel),
            BOTH => {
                let (first, second) = out.split_at_mut(accel.len());
                first.copy_from_slice(accel);
                forces(second);
            }
            id => {
                out.iter_mut().zip(self.axes.row((id - X_AXIS) as usize).iter()).for_each(|(o, a)| *o = *a);
            }
        }
    }
}

impl Inertia for Inerter {
    fn mass(&self) -> Mass {
        Mass::halved(self.mass, self.per_node, self.ndm)
    }
}

impl Inertance for Inerter {
    fn inertance(&self) -> Vec<f64> {
        let mut out = vec![0.0; self.dofs() * self.dofs()];
        self.add_matrix(&self.inertance, &mut out);
        out
    }
}

impl OwnDamping for Inerter {
    fn undamped(&self) -> Option<Arc<dyn Element>> {
        None
    }
    fn add_own_damping(&self, s: &Snapshot<'_>, factor: f64, force: &mut [f64]) {
        self.add_force(&self.damping, motions(s.state)[1], s.disp, factor, force);
    }
}

/// Relative rates of a dynamic motion; zeros in a static analysis, where no node has an acceleration.
fn rates_of(dynamic: bool, motion: &[f64], out: &mut [f64], relative: impl Fn(&[f64], &mut [f64])) {
    if dynamic { relative(motion, out) } else { out.fill(0.0) }
}
