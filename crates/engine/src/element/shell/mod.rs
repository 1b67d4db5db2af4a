//! Shells: `ShellMITC4`, `ShellDKGQ`, `ShellDKGT`, `ShellNLDKGQ`, `ASDShellQ4`, `ASDShellT3`.
//!
//! A formulation gives the derivatives of the plate's deformations by the displacements at each Gauss point; [`Shell`] is
//! the element around them. Displacements are small, and the plate stays where its nodes were. [`UpdatedShell`] follows its
//! nodes, and [`EnhancedShell`] can.

mod basic_forces;
mod discrete_kirchhoff;
mod enhanced;
mod mitc4;
mod updated;

use super::{
    Class, Element, ElementError, ElementInput, ElementOutput, ElementResult, ElementTraits, Histories, Mass,
    OpenSeesTraits, Snapshot, dot,
};
use crate::element::roles::{ForceLabels, Inertia, Roles};
use crate::numeric::axpy;
use crate::probe::Probe;
use crate::section::plate::{
    self, PLATE_DEFORMATIONS, PLATE_ORDER, PLATE_RESULTANTS, PlateSection, PlateState, SharedPlateSection,
};
use nalgebra::Vector3;
use std::ops::Range;

pub use enhanced::{Drilling, EnhancedShell, EnhancedShellOptions};
pub use updated::UpdatedShell;

/// Degrees of freedom of the largest shell.
const MAX: usize = 24;
/// Degrees of freedom of a node.
const NODE: usize = 6;

/// A row of derivatives by the displacements of all nodes, in global axes.
type Row = [f64; MAX];

/// Formulation of a shell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Formulation {
    /// Four nodes, tied transverse shear strains and a drilling penalty (Bathe and Dvorkin, 1985).
    Mitc4,
    /// Four nodes, discrete Kirchhoff bending (Batoz and Ben Tahar, 1982) and a membrane with drilling (Allman, 1988).
    KirchhoffQuadrilateral,
    /// Three nodes, discrete Kirchhoff bending (Batoz, Bathe and Ho, 1980) and a membrane with drilling (Allman, 1984).
    KirchhoffTriangle,
}

impl Formulation {
    /// Number of nodes.
    pub fn nodes(self) -> usize {
        if self == Self::KirchhoffTriangle { 3 } else { 4 }
    }
}

/// A Gauss point.
#[derive(Clone, Debug)]
struct Point {
    /// Derivatives of the deformations of the plate.
    rows: [Row; PLATE_ORDER],
    /// Derivatives of the drilling strain.
    drilling: Row,
    /// Area.
    area: f64,
    /// Values of the shape functions of the nodes.
    shape: [f64; 4],
}

/// Axes of the plane of a shell and the places of its nodes in them.
#[derive(Clone, Debug)]
struct Geometry {
    axes: [Vector3<f64>; 3],
    corners: Vec<[f64; 2]>,
}

impl Geometry {
    /// Axis 1 runs along the first direction of the mesh, axis 2 square to it towards the second.
    fn new(nodes: &[Vector3<f64>]) -> ElementResult<Self> {
        let (first, second) = match nodes {
            [a, b, c] => (b - a, c - a),
            [a, b, c, d] => (0.5 * (c + b - d - a), 0.5 * (d + c - b - a)),
            _ => return Err(ElementError("a shell has three or four nodes".into())),
        };
        let x = first.normalize();
        let y = (second - x * second.dot(&x)).normalize();
        let axes = [x, y, x.cross(&y)];
        if !axes.iter().all(|a| a.iter().all(|c| c.is_finite())) {
            return Err(ElementError("its nodes lie in a line".into()));
        }
        Ok(Self { axes, corners: nodes.iter().map(|n| [n.dot(&x), n.dot(&y)]).collect() })
    }

    /// Adds to a row the derivative by the displacement of a node along an axis, or by the rotation about it.
    fn add(&self, row: &mut Row, node: usize, (axis, turns): (usize, bool), value: f64) {
        let at = NODE * node + if turns { 3 } else { 0 };
        axpy(value, self.axes[axis].as_slice(), &mut row[at..at + 3]);
    }
}

/// A flat shell.
#[derive(Clone, Debug)]
pub struct Shell {
    formulation: Formulation,
    section: SharedPlateSection,
    points: Vec<Point>,
    /// Stiffness against the drilling strain.
    drilling: f64,
    dofs: usize,
    /// State variables of a point: those of the section, and the resultants.
    words: usize,
    mass: Vec<f64>,
    /// Displacements in which it is free of strain; empty for zero.
    initial: Vec<f64>,
}

impl Shell {
    /// Sections of the points with the ranges of their states.
    fn sections(&self) -> impl Iterator<Item = (Range<usize>, &SharedPlateSection)> {
        (0..self.points.len()).map(|i| (i * self.words + PLATE_ORDER..(i + 1) * self.words, &self.section))
    }

    /// Makes a shell between nodes; `initial` are the displacements in which it has no strain.
    ///
    /// # Errors
    /// The nodes are in a line, or their quadrilateral is not convex.
    pub fn new(
        formulation: Formulation,
        nodes: &[Vector3<f64>],
        section: SharedPlateSection,
        initial: &[f64],
    ) -> ElementResult<Self> {
        let geometry = Geometry::new(nodes)?;
        let points = match formulation {
            Formulation::Mitc4 => mitc4::points(&geometry),
            _ => discrete_kirchhoff::points(&geometry),
        };
        let dofs = NODE * nodes.len();
        let sound = match formulation {
            Formulation::KirchhoffTriangle => points.iter().map(|p| p.area).sum::<f64>() > 0.0,
            _ => points.iter().all(|p| p.area > 0.0),
        };
        if !sound {
            return Err(ElementError("its nodes do not make a convex quadrilateral".into()));
        }
        let mut mass = vec![];
        if section.mass() != 0.0 {
            mass = vec![0.0; dofs * dofs];
            for p in &points {
                for (i, a) in p.shape[..nodes.len()].iter().enumerate() {
                    for (j, b) in p.shape[..nodes.len()].iter().enumerate() {
                        for d in 0..3 {
                            mass[(NODE * i + d) * dofs + NODE * j + d] += section.mass() * p.area * a * b;
                        }
                    }
                }
            }
        }
        let drilling = if formulation == Formulation::Mitc4 { mitc4::drilling_stiffness(&*section) } else { 0.0 };
        let words = section.state_len() + PLATE_ORDER;
        let initial = if initial.iter().all(|u| *u == 0.0) { vec![] } else { initial.to_vec() };
        Ok(Self { formulation, section, points, drilling, dofs, words, mass, initial })
    }

    /// Displacements since it was made.
    fn moved(&self, disp: &[f64]) -> Row {
        let mut u = [0.0; MAX];
        u[..disp.len()].copy_from_slice(disp);
        u.iter_mut().zip(&self.initial).for_each(|(u, start)| *u -= start);
        u
    }

    /// Deformations of the plate at a point.
    fn deformations(point: &Point, u: &Row) -> [f64; PLATE_ORDER] {
        std::array::from_fn(|i| dot(&point.rows[i], u))
    }

    /// Adds a point's stiffness to a matrix.
    fn add_stiffness(&self, point: &Point, section: &[[f64; PLATE_ORDER]; PLATE_ORDER], k: &mut [f64]) {
        let n = self.dofs;
        for (a, (row, stiffness)) in point.rows.iter().zip(section).enumerate() {
            let mut of_row = [0.0; MAX];
            stiffness.iter().zip(&point.rows).for_each(|(s, b)| axpy(*s, b, &mut of_row));
            let factor = work(a) * point.area;
            for (i, x) in row[..n].iter().enumerate().filter(|(_, x)| **x != 0.0) {
                axpy(factor * x, &of_row[..n], &mut k[i * n..(i + 1) * n]);
            }
        }
        if self.drilling != 0.0 {
            self.add_drilling(point, 1.0, k);
        }
    }

    /// Adds a point's stiffness against drilling, times a factor, to a matrix.
    fn add_drilling(&self, point: &Point, factor: f64, k: &mut [f64]) {
        let (n, factor) = (self.dofs, factor * self.drilling * point.area);
        for (i, x) in point.drilling[..n].iter().enumerate().filter(|(_, x)| **x != 0.0) {
            axpy(factor * x, &point.drilling[..n], &mut k[i * n..(i + 1) * n]);
        }
    }
}

/// Sign of the work of a resultant: a moment works against its curvature.
fn work(resultant: usize) -> f64 {
    if (3..6).contains(&resultant) { -1.0 } else { 1.0 }
}

const STRESSES: u32 = 2;
const STRAINS: u32 = 3;
/// A response of a single Gauss point; its number, and the path of the section follow.
const SINGLE_POINT: u32 = 10;

crate::watches_columns!(Shell => |s| at s.sections());

impl Element for Shell {
    fn class(&self) -> Class {
        match self.formulation {
            Formulation::Mitc4 => Class::new("ShellMITC4", 53),
            Formulation::KirchhoffQuadrilateral => Class::new("ShellDKGQ", 156),
            Formulation::KirchhoffTriangle => Class::new("ShellDKGT", 167),
        }
    }
    fn dofs(&self) -> usize {
        self.dofs
    }
    fn state_len(&self) -> usize {
        self.words * self.points.len()
    }
    fn init(&self, state: &mut [f64]) {
        state.fill(0.0);
        state.chunks_exact_mut(self.words).for_each(|s| self.section.init(&mut s[PLATE_ORDER..]));
    }
    fn traits(&self) -> ElementTraits {
        let linear = self.section.is_linear();
        ElementTraits {
            linear,
            symmetric: self.section.is_symmetric(),
            viscous: false,
            elapses: self.section.depends_on_time(),
            rayleigh: true,
        }
    }

    fn respond(&self, m: &ElementInput<'_>, h: &mut Histories<'_>, output: ElementOutput<'_>) -> ElementResult {
        let (u, n) = (self.moved(m.disp), self.dofs);
        let ElementOutput { force, mut tangent, .. } = output;
        force.fill(0.0);
        let histories = h.committed.chunks_exact(self.words).zip(h.trial.chunks_exact_mut(self.words));
        for (point, (old, new)) in self.points.iter().zip(histories) {
            let e = Self::deformations(point, &u);
            let (resultants, next) = new.split_at_mut(PLATE_ORDER);
            let (s, k) = self.section.update(&old[PLATE_ORDER..], &e, m.dt, next)?;
            resultants.copy_from_slice(&s);
            for (i, (row, s)) in point.rows.iter().zip(&s).enumerate() {
                axpy(work(i) * point.area * s, &row[..n], force);
            }
            let drilling = self.drilling * dot(&point.drilling, &u);
            axpy(point.area * drilling, &point.drilling[..n], force);
            if let Some(tangent) = &mut tangent {
                self.add_stiffness(point, &k, tangent);
            }
        }
        Ok(())
    }

    fn initial_tangent(&self, tangent: &mut [f64]) {
        let section = self.section.initial_stiffness();
        self.points.iter().for_each(|point| self.add_stiffness(point, &section, tangent));
    }

    fn roles(&self) -> Roles<'_> {
        Roles {
            mass: Some(self),
            opensees: OpenSeesTraits::of_mass(!self.mass.is_empty()),
            basic_forces: Some(self),
            force_labels: ForceLabels::Numbered,
            ..Roles::default()
        }
    }

    fn probe(&self, words: &[&str]) -> Option<Probe> {
        probe(&*self.section, words, self.points.len(), self.points.len())
    }

    fn probe_names(&self) -> Vec<&'static str> {
        PROBE_NAMES.to_vec()
    }

    fn read(&self, path: &[u32], s: &Snapshot<'_>, out: &mut [f64]) {
        let read = |point: usize, path: &[u32], out: &mut [f64]| {
            let (resultants, own) = s.state[point * self.words..(point + 1) * self.words].split_at(PLATE_ORDER);
            let deformations = Self::deformations(&self.points[point], &self.moved(s.disp));
            PlateState { section: &*self.section, resultants, deformations, own }.read(path, out);
        };
        read_points(path, self.points.len(), out, read);
    }
}

/// Reads a response of all points, or of one, by a function of a point, the path inside of it and the numbers. A shell with fewer
/// points shows its last one again.
fn read_points(path: &[u32], points: usize, out: &mut [f64], read: impl Fn(usize, &[u32], &mut [f64])) {
    match path[0] {
        kind @ (STRESSES | STRAINS) => {
            let shown = out.chunks_exact_mut(PLATE_ORDER).enumerate();
            shown.for_each(|(point, out)| read(point.min(points - 1), &[u32::from(kind == STRAINS)], out));
        }
        _ => read(path[1] as usize, &path[2..], out),
    }
}

/// Words of the responses.
const PROBE_NAMES: [&str; 3] = ["stresses", "strains", "material"];

/// A response of all points or of the section of one. A shell may show more points than it has.
fn probe(section: &dyn PlateSection, words: &[&str], points: usize, shown: usize) -> Option<Probe> {
    let all = |names: [&'static str; PLATE_ORDER]| (0..shown).flat_map(move |_| names);
    Some(match words {
        ["stresses", ..] => Probe::new(STRESSES, all(PLATE_RESULTANTS)),
        ["strains", ..] => Probe::new(STRAINS, all(PLATE_DEFORMATIONS)),
        ["material" | "Material" | "section", point, words @ ..] => {
            let point = point.parse::<u32>().ok().filter(|p| (1..=points as u32).contains(p))? - 1;
            return Some(plate::probe(section, words)?.inside(&[SINGLE_POINT, point]));
        }
        _ => return None,
    })
}

impl Inertia for Shell {
    fn mass(&self) -> Mass {
        if self.mass.is_empty() { Mass::None } else { Mass::Consistent(self.mass.clone()) }
    }
}
