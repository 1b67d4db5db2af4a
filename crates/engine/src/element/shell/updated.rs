//! Thin shell with large displacements: `ShellNLDKGQ`.

use super::{
    Element, ElementError, ElementInput, ElementOutput, ElementResult, ElementTraits, Histories, Snapshot, dot,
};
use super::{Formulation, Geometry, MAX, NODE, Point, Row, Shell, discrete_kirchhoff, read_points, work};
use crate::element::Class;
use crate::element::roles::Roles;
use crate::numeric::axpy;
use crate::probe::Probe;
use crate::section::plate::{PLATE_ORDER, PlateState, PlateTangent, SharedPlateSection};
use nalgebra::Vector3;

/// Number of nodes, and of Gauss points.
const NODES: usize = 4;

/// A thin shell of four nodes whose axes follow its nodes (updated Lagrangian; Wang, Lu et al., 2014). Strains are the
/// sum of the strains of the steps. Those of a step are linear in its displacements, in the axes at its end and the
/// places of the nodes at its start.
#[derive(Clone, Debug)]
pub struct UpdatedShell {
    flat: Shell,
    nodes: [Vector3<f64>; NODES],
    /// Change of a displacement in the differences that give the geometric stiffness, a share of the size.
    change: f64,
}

/// Share of the size of the shell by which a node moves for a difference.
const DIFFERENCE: f64 = 1e-6;

/// Trial stresses at a point: resultants and tangent.
struct Response {
    s: [f64; PLATE_ORDER],
    k: PlateTangent,
}

impl UpdatedShell {
    /// Makes a shell between nodes.
    ///
    /// # Errors
    /// The nodes are in a line, or their quadrilateral is not convex.
    pub fn new(nodes: [Vector3<f64>; NODES], section: SharedPlateSection) -> ElementResult<Self> {
        let flat = Shell::new(Formulation::KirchhoffQuadrilateral, &nodes, section, &[])?;
        let change = DIFFERENCE * (nodes[2] - nodes[0]).norm();
        Ok(Self { flat, nodes, change })
    }

    /// Index of the strains in the state, after the state variables of the points.
    fn strains(&self) -> usize {
        NODES * self.flat.words
    }

    /// Index of the committed displacements, after the strains.
    fn start(&self) -> usize {
        self.strains() + NODES * PLATE_ORDER
    }

    /// Gauss points for displacements at the start and at the end of a step.
    fn points(&self, start: &[f64], end: &[f64]) -> ElementResult<Vec<Point>> {
        let place = |u: &[f64], i: usize| self.nodes[i] + Vector3::from_column_slice(&u[NODE * i..NODE * i + 3]);
        let moved: [Vector3<f64>; NODES] = std::array::from_fn(|i| place(end, i));
        let mut geometry = Geometry::new(&moved)?;
        let [x, y, _] = geometry.axes;
        geometry.corners = (0..NODES).map(|i| place(start, i)).map(|n| [n.dot(&x), n.dot(&y)]).collect();
        let points = discrete_kirchhoff::points(&geometry);
        if points.iter().all(|p| p.area > 0.0) {
            return Ok(points);
        }
        Err(ElementError("its nodes do not make a convex quadrilateral any more".into()))
    }

    /// Forces of given resultants.
    fn forces(points: &[Point], responses: &[Response]) -> Row {
        let mut force = [0.0; MAX];
        for (point, response) in points.iter().zip(responses) {
            for (i, (row, s)) in point.rows.iter().zip(&response.s).enumerate() {
                axpy(work(i) * point.area * s, row, &mut force);
            }
        }
        force
    }

    /// Adds what the motion of the axes and the increment of the strains with it contribute to the tangent.
    fn add_geometric_stiffness(
        &self,
        (start, end): (&[f64], &[f64]),
        points: &[Point],
        responses: &[Response],
        tangent: &mut [f64],
    ) -> ElementResult {
        let n = self.flat.dofs;
        let step: Row = std::array::from_fn(|i| if i < n { end[i] - start[i] } else { 0.0 });
        for j in (0..n).filter(|j| j % NODE < 3) {
            let beside = |change: f64| {
                let mut moved = end.to_vec();
                moved[j] += change;
                self.points(start, &moved)
            };
            let (down, up) = (beside(-self.change)?, beside(self.change)?);
            let slope = 0.5 / self.change;
            let (before, after) = (Self::forces(&down, responses), Self::forces(&up, responses));
            let mut column: Row = std::array::from_fn(|i| slope * (after[i] - before[i]));
            for (p, point) in points.iter().enumerate() {
                let strain: [f64; PLATE_ORDER] =
                    std::array::from_fn(|i| slope * (dot(&up[p].rows[i], &step) - dot(&down[p].rows[i], &step)));
                for (i, (row, k)) in point.rows.iter().zip(&responses[p].k).enumerate() {
                    axpy(work(i) * point.area * dot(k, &strain), row, &mut column);
                }
            }
            (0..n).for_each(|i| tangent[i * n + j] += column[i]);
        }
        Ok(())
    }
}

crate::watches_columns!(UpdatedShell => |s| in [&s.flat]);

impl Element for UpdatedShell {
    fn class(&self) -> Class {
        Class::new("ShellNLDKGQ", 157)
    }
    fn dofs(&self) -> usize {
        self.flat.dofs
    }
    fn state_len(&self) -> usize {
        self.start() + self.flat.dofs
    }
    fn init(&self, state: &mut [f64]) {
        state.fill(0.0);
        self.flat.init(&mut state[..self.strains()]);
    }
    fn traits(&self) -> ElementTraits {
        ElementTraits {
            linear: false,
            symmetric: false,
            viscous: false,
            elapses: self.flat.section.depends_on_time(),
            rayleigh: true,
        }
    }

    fn respond(&self, m: &ElementInput<'_>, h: &mut Histories<'_>, output: ElementOutput<'_>) -> ElementResult {
        let (words, n) = (self.flat.words, self.flat.dofs);
        let start = &h.committed[self.start()..];
        let points = self.points(start, m.disp)?;
        let step: Row = std::array::from_fn(|i| if i < n { m.disp[i] - start[i] } else { 0.0 });
        let mut responses = Vec::with_capacity(NODES);
        for (p, point) in points.iter().enumerate() {
            let strains = self.strains() + p * PLATE_ORDER;
            let e: [f64; PLATE_ORDER] = std::array::from_fn(|i| h.committed[strains + i] + dot(&point.rows[i], &step));
            h.trial[strains..strains + PLATE_ORDER].copy_from_slice(&e);
            let own = p * words + PLATE_ORDER..(p + 1) * words;
            let (s, k) = self.flat.section.update(&h.committed[own.clone()], &e, m.dt, &mut h.trial[own])?;
            h.trial[p * words..p * words + PLATE_ORDER].copy_from_slice(&s);
            responses.push(Response { s, k });
        }
        h.trial[self.start()..].copy_from_slice(m.disp);
        output.force.copy_from_slice(&Self::forces(&points, &responses)[..n]);
        if let Some(tangent) = output.tangent {
            points.iter().zip(&responses).for_each(|(p, r)| self.flat.add_stiffness(p, &r.k, tangent));
            self.add_geometric_stiffness((start, m.disp), &points, &responses, tangent)?;
        }
        Ok(())
    }

    fn initial_tangent(&self, tangent: &mut [f64]) {
        self.flat.initial_tangent(tangent);
    }
    fn roles(&self) -> Roles<'_> {
        let Roles { mass, force_labels, opensees, .. } = self.flat.roles();
        Roles { mass, force_labels, opensees, ..Roles::default() }
    }

    fn probe(&self, words: &[&str]) -> Option<Probe> {
        self.flat.probe(words)
    }
    fn probe_names(&self) -> Vec<&'static str> {
        self.flat.probe_names()
    }

    fn read(&self, path: &[u32], s: &Snapshot<'_>, out: &mut [f64]) {
        let read = |point: usize, path: &[u32], out: &mut [f64]| {
            let (words, strains) = (self.flat.words, self.strains() + point * PLATE_ORDER);
            let (resultants, own) = s.state[point * words..(point + 1) * words].split_at(PLATE_ORDER);
            let mut deformations = [0.0; PLATE_ORDER];
            deformations.copy_from_slice(&s.state[strains..strains + PLATE_ORDER]);
            PlateState { section: &*self.flat.section, resultants, deformations, own }.read(path, out);
        };
        read_points(path, self.flat.points.len(), out, read);
    }
}
