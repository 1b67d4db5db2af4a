//! Shells with transverse shear whose membrane has internal modes or drilling rotations: `ASDShellQ4`, `ASDShellT3`.
//!
//! Strains are small. The axes stay, or follow the nodes. Internal modes of the membrane are condensed by Newton's method.

mod frame;
mod options;
mod point;
mod quadrilateral;
mod triangle;

use super::{
    Element, ElementError, ElementInput, ElementOutput, ElementResult, ElementTraits, Histories, Mass, OpenSeesTraits,
    Snapshot, dot,
};
use super::{MAX, NODE, PROBE_NAMES, Row, probe, read_points, work};
use crate::element::Class;
use crate::element::roles::{ForceLabels, Inertia, Roles};
use crate::numeric::axpy;
use crate::probe::Probe;
use crate::section::plate::{PLATE_ORDER, PlateState, PlateTangent, SharedPlateSection};
use crate::state_struct::StateStruct;
use frame::{Following, Frame, NodalTurns};
use nalgebra::{Matrix4, Vector3, Vector4};
pub use options::{Drilling, EnhancedShellOptions};
use point::LocalPoint;
use std::ops::Range;

/// Internal degrees of freedom.
const INTERNAL: usize = 4;
/// Shear modulus of the drilling penalty, as a share of that of the section.
const DRILLING_SHARE: f64 = 0.233;
/// Iterations for the internal modes. What is left then is condensed.
const ITERATIONS: usize = 25;
/// Residual of the internal modes that counts as zero, as a share of the work of the stresses on them.
const RESIDUAL: f64 = 1e-13;
/// Share of the size of the shell by which a node moves for a difference.
const DIFFERENCE: f64 = 1e-6;
/// Increment of the deformations of a section from which it is searched for damage.
const LEAST_INCREMENT: f64 = 1e-10;
/// Largest damage of the drilling stiffness.
const LARGEST_DAMAGE: f64 = 0.999;

/// A shell of four or three nodes with transverse shear.
#[derive(Clone, Debug)]
pub struct EnhancedShell {
    section: SharedPlateSection,
    options: EnhancedShellOptions,
    nodes: Vec<Vector3<f64>>,
    frame: Frame,
    /// Points with derivatives by global displacements.
    fixed: Vec<LocalPoint>,
    /// Points with derivatives by displacements in the axes; empty where they do not follow the nodes.
    moving: Vec<LocalPoint>,
    drilling: f64,
    dofs: usize,
    /// State variables of a point: resultants, deformations, damage of the drilling stiffness, and those of the section.
    words: usize,
    mass: Vec<f64>,
    /// Displacements in which it is free of strain; empty for zero.
    initial: Vec<f64>,
    /// Change of a displacement for a difference.
    change: f64,
}

/// First state variable of the section in those of a point.
const SECTION: usize = 2 * PLATE_ORDER + 1;

/// Forces and stiffnesses of all points for given displacements and internal degrees of freedom.
struct Sum {
    force: Row,
    internal_force: Vector4<f64>,
    /// Work of the stresses on the internal degrees of freedom without signs.
    gross: f64,
    internal: Matrix4<f64>,
    /// Derivatives of the internal forces by the displacements, and of the forces by the internal degrees of freedom.
    by_displacements: [Row; INTERNAL],
    of_force: [Row; INTERNAL],
    tangents: [PlateTangent; 4],
}

impl EnhancedShell {
    /// Sections of the points with the ranges of their states.
    fn sections(&self) -> impl Iterator<Item = (Range<usize>, &SharedPlateSection)> {
        (0..self.fixed.len()).map(|i| (i * self.words + SECTION..(i + 1) * self.words, &self.section))
    }

    /// Makes a shell between three or four nodes; `initial` are the displacements in which it has no strain.
    ///
    /// # Errors
    /// The nodes are in a line, their quadrilateral is not convex, or the axis of the section is square to the shell.
    pub fn new(
        nodes: &[Vector3<f64>],
        section: SharedPlateSection,
        options: EnhancedShellOptions,
        initial: &[f64],
    ) -> ElementResult<Self> {
        let frame = Frame::new(nodes)?;
        let geometry = frame.geometry(nodes);
        let k = section.initial_stiffness();
        let mut points = if nodes.len() == 3 {
            let thickness = if k[0][0] == 0.0 { 0.0 } else { (-12.0 * k[3][3] / k[0][0]).max(0.0).sqrt() };
            triangle::points(&geometry, options.reduced, thickness)
        } else {
            let share = if let Drilling::Elastic(share) = options.drilling { share } else { 1.0 };
            quadrilateral::points(&geometry, options.internal, share)
        };
        if !points.iter().all(|p| p.area > 0.0) {
            return Err(ElementError("its nodes do not make a convex quadrilateral".into()));
        }
        let axis = match options.axis {
            Some(axis) => Vector3::from(axis).normalize(),
            None if options.opensees_axes => frame.axes.row(1).transpose(),
            None if nodes.len() == 4 => nodes[1] + nodes[2] - nodes[0] - nodes[3],
            None => nodes[1] - nodes[0],
        };
        let in_plane = frame.axes * axis;
        let across = in_plane.x.hypot(in_plane.y);
        if across.is_nan() || across <= 1e-12 * in_plane.norm() {
            return Err(ElementError("the local axis is square to the shell".into()));
        }
        let angle = in_plane.y.atan2(in_plane.x);
        if angle != 0.0 {
            let shear = if options.opensees_axes { -angle } else { angle };
            points.iter_mut().for_each(|p| p.turn(angle, shear));
        }
        let dofs = NODE * nodes.len();
        let mut fixed = points.clone();
        for p in &mut fixed {
            p.rows.iter_mut().chain(&mut p.drilling).for_each(|row| *row = frame.to_global(nodes, row));
        }
        let mut mass = vec![0.0; dofs];
        let whole: f64 = points.iter().map(|p| p.area).sum();
        let shares = Self::mass_shares(&geometry.corners, whole);
        for (node, share) in shares.iter().enumerate().take(nodes.len()) {
            mass[NODE * node..NODE * node + 3].fill(section.mass() * share);
        }
        if section.mass() == 0.0 {
            mass.clear();
        }
        let moving = if options.corotational { points } else { vec![] };
        let initial = if initial.iter().all(|u| *u == 0.0) { vec![] } else { initial.to_vec() };
        let (drilling, words) = (DRILLING_SHARE * k[2][2], section.state_len() + SECTION);
        let change = DIFFERENCE * whole.sqrt();
        let nodes = nodes.to_vec();
        Ok(Self { section, options, nodes, frame, fixed, moving, drilling, dofs, words, mass, initial, change })
    }

    /// Area of each node.
    fn mass_shares(corners: &[[f64; 2]], whole: f64) -> [f64; 4] {
        if corners.len() == 3 {
            return [whole / 3.0; 4];
        }
        let mut shares = [0.0; 4];
        for at in super::mitc4::SIGNS.map(|s| s.map(|s| s / 3.0f64.sqrt())) {
            let b = super::mitc4::bilinear(corners, at);
            axpy(b.area, &b.shape, &mut shares);
        }
        shares
    }

    /// Displacements since it was made.
    fn moved(&self, disp: &[f64]) -> Row {
        let mut u = [0.0; MAX];
        u[..disp.len()].copy_from_slice(disp);
        u.iter_mut().zip(&self.initial).for_each(|(u, start)| *u -= start);
        u
    }

    /// Index of the internal degrees of freedom in the state, after the points.
    fn internal_at(&self) -> usize {
        self.fixed.len() * self.words
    }

    /// Sums all points; writes their states.
    fn sum(
        &self,
        points: &[LocalPoint],
        (u, q): (&Row, &Vector4<f64>),
        dt: f64,
        h: &mut Histories<'_>,
    ) -> ElementResult<Sum> {
        let mut sum = Sum {
            force: [0.0; MAX],
            internal_force: Vector4::zeros(),
            gross: 0.0,
            internal: Matrix4::zeros(),
            by_displacements: [[0.0; MAX]; INTERNAL],
            of_force: [[0.0; MAX]; INTERNAL],
            tangents: [[[0.0; PLATE_ORDER]; PLATE_ORDER]; 4],
        };
        let histories = h.committed.chunks_exact(self.words).zip(h.trial.chunks_exact_mut(self.words));
        for ((p, (old, new)), k) in points.iter().zip(histories).zip(&mut sum.tangents) {
            let e: [f64; PLATE_ORDER] = std::array::from_fn(|i| dot(&p.rows[i], u) + dot(&p.internal[i], q.as_slice()));
            let s;
            (s, *k) = self.section.update(&old[SECTION..], &e, dt, &mut new[SECTION..])?;
            new[..PLATE_ORDER].copy_from_slice(&s);
            new[PLATE_ORDER..2 * PLATE_ORDER].copy_from_slice(&e);
            for (i, s) in s.iter().enumerate() {
                axpy(work(i) * p.area * s, &p.rows[i], &mut sum.force);
                for (force, b) in sum.internal_force.iter_mut().zip(&p.internal[i]) {
                    *force += p.area * s * b;
                    sum.gross += (p.area * s * b).abs();
                }
            }
            if self.options.drilling == Drilling::Damaged {
                new[2 * PLATE_ORDER] = self.damage(old, new);
            }
            let stiffness = p.area * self.drilling * (1.0 - old[2 * PLATE_ORDER]);
            p.drilling.iter().for_each(|row| axpy(stiffness * dot(row, u), row, &mut sum.force));
            if self.has_internal() {
                Self::add_internal(p, k, &mut sum.internal, &mut sum.by_displacements, &mut sum.of_force);
            }
        }
        Ok(sum)
    }

    fn has_internal(&self) -> bool {
        self.options.internal && self.nodes.len() == 4
    }

    fn add_internal(
        p: &LocalPoint,
        k: &PlateTangent,
        internal: &mut Matrix4<f64>,
        by_displacements: &mut [Row; INTERNAL],
        of_force: &mut [Row; INTERNAL],
    ) {
        for a in 0..INTERNAL {
            // Internal modes have membrane strains alone.
            let left: [f64; PLATE_ORDER] = std::array::from_fn(|j| (0..3).map(|i| p.internal[i][a] * k[i][j]).sum());
            let right: [f64; PLATE_ORDER] = std::array::from_fn(|i| (0..3).map(|j| k[i][j] * p.internal[j][a]).sum());
            for i in 0..PLATE_ORDER {
                axpy(p.area * left[i], &p.rows[i], &mut by_displacements[a]);
                axpy(work(i) * p.area * right[i], &p.rows[i], &mut of_force[a]);
                (0..INTERNAL).for_each(|b| internal[(a, b)] += p.area * left[i] * p.internal[i][b]);
            }
        }
    }

    /// Damage of the drilling stiffness after a step: the largest loss of stiffness in a direction that grows.
    fn damage(&self, old: &[f64], new: &[f64]) -> f64 {
        let change: [f64; PLATE_ORDER] = std::array::from_fn(|i| new[PLATE_ORDER + i] - old[PLATE_ORDER + i]);
        let before = old[2 * PLATE_ORDER];
        if dot(&change, &change).sqrt() <= LEAST_INCREMENT {
            return before;
        }
        let stiffness = self.section.initial_stiffness();
        let mut damage = before;
        for i in (0..PLATE_ORDER).filter(|i| change[*i] > 0.0) {
            let loss = 1.0 - (new[i] - old[i]) / dot(&stiffness[i], &change);
            if loss > damage {
                damage = loss;
            }
        }
        damage.clamp(0.0, LARGEST_DAMAGE)
    }

    /// Force and tangent by the displacements of the points' rows, with the internal modes condensed.
    fn condensed(
        &self,
        points: &[LocalPoint],
        u: &Row,
        dt: f64,
        h: &mut Histories<'_>,
        tangent: Option<&mut [f64]>,
    ) -> ElementResult<Row> {
        let at = self.internal_at();
        let mut q = Vector4::from_column_slice(&h.committed[at..at + INTERNAL]);
        let mut sum = self.sum(points, (u, &q), dt, &mut h.part(..at))?;
        let mut inverse = None;
        if self.has_internal() {
            for _ in 0..ITERATIONS {
                inverse = Some(
                    sum.internal
                        .try_inverse()
                        .ok_or_else(|| ElementError("the internal modes of the membrane have no stiffness".into()))?,
                );
                if sum.internal_force.amax() <= RESIDUAL * sum.gross {
                    break;
                }
                q -= inverse.unwrap_or_default() * sum.internal_force;
                sum = self.sum(points, (u, &q), dt, &mut h.part(..at))?;
            }
            // What the last iteration has left.
            let rest = inverse.unwrap_or_default() * sum.internal_force;
            (0..INTERNAL).for_each(|a| axpy(-rest[a], &sum.of_force[a], &mut sum.force));
        }
        h.trial[at..at + INTERNAL].copy_from_slice(q.as_slice());
        if let Some(tangent) = tangent {
            let damage = |point: usize| h.committed[point * self.words + 2 * PLATE_ORDER];
            for (i, (p, k)) in points.iter().zip(&sum.tangents).enumerate() {
                self.add_stiffness(p, k, damage(i), tangent);
            }
            if let Some(inverse) = inverse.and_then(|_| sum.internal.try_inverse()) {
                self.condense(&inverse, &sum.of_force, &sum.by_displacements, tangent);
            }
        }
        Ok(sum.force)
    }

    /// Takes the stiffness that the internal modes release from a tangent.
    fn condense(&self, inverse: &Matrix4<f64>, of: &[Row; INTERNAL], by: &[Row; INTERNAL], tangent: &mut [f64]) {
        let n = self.dofs;
        for a in 0..INTERNAL {
            let mut row = [0.0; MAX];
            (0..INTERNAL).for_each(|b| axpy(inverse[(a, b)], &by[b], &mut row));
            for i in 0..n {
                axpy(-of[a][i], &row[..n], &mut tangent[i * n..(i + 1) * n]);
            }
        }
    }

    fn add_stiffness(&self, p: &LocalPoint, k: &PlateTangent, damage: f64, tangent: &mut [f64]) {
        let n = self.dofs;
        let mut add = |factor: f64, column: &Row, row: &Row| {
            for (i, x) in column[..n].iter().enumerate().filter(|(_, x)| **x != 0.0) {
                axpy(factor * x, &row[..n], &mut tangent[i * n..(i + 1) * n]);
            }
        };
        for (i, k) in k.iter().enumerate() {
            let mut row = [0.0; MAX];
            k.iter().zip(&p.rows).for_each(|(k, b)| axpy(*k, b, &mut row));
            add(work(i) * p.area, &p.rows[i], &row);
        }
        p.drilling.iter().for_each(|row| add(p.area * self.drilling * (1.0 - damage), row, row));
    }

    /// Response in axes that follow the nodes.
    fn respond_following(
        &self,
        u: &Row,
        dt: f64,
        h: &mut Histories<'_>,
        tangent: Option<&mut [f64]>,
    ) -> ElementResult<Row> {
        let n = self.dofs;
        let at = self.internal_at() + INTERNAL;
        let from = if self.options.by_trials { &h.trial[at..] } else { &h.committed[at..] };
        let mut turns = NodalTurns::read(from);
        let next = turns.advanced(self.nodes.len(), u);
        next.write(&mut h.trial[at..]);
        if self.options.by_trials {
            turns = next;
        }
        let following = Following { nodes: &self.nodes, frame: &self.frame, turns: &turns };
        let (frame, local) = following.local(u)?;
        let Some(tangent) = tangent else {
            let force = self.condensed(&self.moving, &local, dt, h, None)?;
            return Ok(following.global_force(&frame, &force));
        };
        let mut material = [0.0; MAX * MAX];
        let material = &mut material[..n * n];
        let force = self.condensed(&self.moving, &local, dt, h, Some(material))?;
        for j in 0..n {
            let mut column = [0.0; MAX];
            let mut product = |by_local: &Row| {
                (0..n).for_each(|i| column[i] = dot(&material[i * n..(i + 1) * n], &by_local[..n]));
                following.global_force(&frame, &column)
            };
            if self.options.by_trials {
                let column = product(&following.fixed_axes_column(&frame, &local, j));
                (0..n).for_each(|i| tangent[i * n + j] += column[i]);
                continue;
            }
            let change = if j % NODE < 3 { self.change } else { DIFFERENCE };
            let beside = |by: f64| {
                let mut moved = *u;
                moved[j] += by;
                following.local(&moved)
            };
            let ((frame_down, down), (frame_up, up)) = (beside(-change)?, beside(change)?);
            let slope = 0.5 / change;
            let column = product(&std::array::from_fn(|i| slope * (up[i] - down[i])));
            let (before, after) =
                (following.global_force(&frame_down, &force), following.global_force(&frame_up, &force));
            (0..n).for_each(|i| tangent[i * n + j] += column[i] + slope * (after[i] - before[i]));
        }
        Ok(following.global_force(&frame, &force))
    }
}

crate::watches_columns!(EnhancedShell => |s| at s.sections());

impl Element for EnhancedShell {
    fn class(&self) -> Class {
        if self.nodes.len() == 3 { Class::new("ASDShellT3", 204) } else { Class::new("ASDShellQ4", 203) }
    }
    fn dofs(&self) -> usize {
        self.dofs
    }
    fn state_len(&self) -> usize {
        self.internal_at() + INTERNAL + if self.options.corotational { NodalTurns::LEN } else { 0 }
    }
    fn init(&self, state: &mut [f64]) {
        state.fill(0.0);
        let (points, rest) = state.split_at_mut(self.internal_at());
        points.chunks_exact_mut(self.words).for_each(|s| self.section.init(&mut s[SECTION..]));
        if self.options.corotational {
            NodalTurns::none().write(&mut rest[INTERNAL..]);
        }
    }
    fn traits(&self) -> ElementTraits {
        let follows = self.options.corotational;
        let linear = self.section.is_linear() && !follows;
        ElementTraits {
            linear,
            symmetric: !follows && self.section.is_symmetric(),
            viscous: false,
            elapses: self.section.depends_on_time(),
            rayleigh: true,
        }
    }

    fn respond(&self, m: &ElementInput<'_>, h: &mut Histories<'_>, output: ElementOutput<'_>) -> ElementResult {
        let u = self.moved(m.disp);
        let force = if self.options.corotational {
            self.respond_following(&u, m.dt, h, output.tangent)?
        } else {
            self.condensed(&self.fixed, &u, m.dt, h, output.tangent)?
        };
        output.force.copy_from_slice(&force[..self.dofs]);
        Ok(())
    }

    fn initial_tangent(&self, tangent: &mut [f64]) {
        let k = self.section.initial_stiffness();
        let (mut internal, mut by, mut of) = (Matrix4::zeros(), [[0.0; MAX]; INTERNAL], [[0.0; MAX]; INTERNAL]);
        for p in &self.fixed {
            self.add_stiffness(p, &k, 0.0, tangent);
            Self::add_internal(p, &k, &mut internal, &mut by, &mut of);
        }
        if let Some(inverse) = internal.try_inverse().filter(|_| self.has_internal()) {
            self.condense(&inverse, &of, &by, tangent);
        }
    }

    fn roles(&self) -> Roles<'_> {
        Roles {
            mass: Some(self),
            opensees: OpenSeesTraits::of_mass(!self.mass.is_empty()),
            force_labels: ForceLabels::Numbered,
            ..Roles::default()
        }
    }

    fn probe(&self, words: &[&str]) -> Option<Probe> {
        // A triangle of one point has three times the same, as in OpenSees.
        probe(&*self.section, words, self.fixed.len(), self.nodes.len())
    }

    fn probe_names(&self) -> Vec<&'static str> {
        PROBE_NAMES.to_vec()
    }

    fn read(&self, path: &[u32], s: &Snapshot<'_>, out: &mut [f64]) {
        let read = |point: usize, path: &[u32], out: &mut [f64]| {
            let (head, own) = s.state[point * self.words..(point + 1) * self.words].split_at(SECTION);
            let resultants = &head[..PLATE_ORDER];
            let mut deformations = [0.0; PLATE_ORDER];
            deformations.copy_from_slice(&head[PLATE_ORDER..2 * PLATE_ORDER]);
            PlateState { section: &*self.section, resultants, deformations, own }.read(path, out);
        };
        read_points(path, self.fixed.len(), out, read);
    }
}

impl Inertia for EnhancedShell {
    fn mass(&self) -> Mass {
        if self.mass.is_empty() { Mass::None } else { Mass::Lumped(self.mass.clone()) }
    }
}
