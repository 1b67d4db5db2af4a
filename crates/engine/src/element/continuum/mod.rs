//! Elements of continua: points with strains, a law of several stresses at each, and a constant stabilisation.

mod brick;
mod constant_strain;
mod quad;
mod quadratic;
mod stabilised_brick;
mod tetrahedron;

use super::damping::BasicForces;
use super::{
    Class, Element, ElementInput, ElementOutput, ElementResult, ElementTraits, Histories, Mass, OpenSeesTraits,
    Snapshot, dot,
};
use crate::element::roles::{ForceLabels, Inertia, Roles};
use crate::material::{SOLID, SharedMultiaxial, Tangent};
use crate::numeric::axpy;
use crate::probe::Probe;
use std::ops::Range;

pub use brick::BrickOptions;
pub use quad::QuadOptions;
pub use quadratic::QuadraticShape;

/// Derivatives of the S strains of a point by the D displacements; shears are angles.
pub(super) type Rows<const S: usize, const D: usize> = [[f64; D]; S];

/// Points and constant matrices of the shape of an element.
#[derive(Clone, Debug)]
pub(super) struct Body<const S: usize, const D: usize> {
    /// Name of the class in OpenSees.
    class: Class,
    /// Points of integration with their volumes.
    points: Vec<(Rows<S, D>, f64)>,
    /// Stiffness against modes without strain at the points; empty without them.
    stabilisation: Vec<f64>,
    /// Resisting force at zero displacement.
    load_force: [f64; D],
    mass: Mass,
    /// Least distance of two nodes.
    size: f64,
    /// Shares of the points in the stresses at each node; empty where they are not reported.
    extrapolation: Vec<Vec<f64>>,
}

/// The law at the points.
#[derive(Clone, Debug)]
enum PointLaw<const S: usize> {
    /// Stresses in proportion to strains, without a dynamic call.
    Linear(Tangent<S>),
    /// Any law. The state of a point is its stresses and then the history.
    General(SharedMultiaxial<S>),
}

/// An element of D displacements whose points have S strains. Its virgin stiffness is kept; a linear one is constant.
/// Pressure and body forces act from the start, independent of load patterns.
#[derive(Clone, Debug)]
pub struct Continuum<const S: usize, const D: usize> {
    body: Body<S, D>,
    law: PointLaw<S>,
    /// State variables of a point.
    point_len: usize,
    symmetric: bool,
    elapses: bool,
    stiffness: Vec<f64>,
    inverted: bool,
}

/// Adds the force of a stress at a point.
fn add_force<const S: usize, const D: usize>(rows: &Rows<S, D>, volume: f64, stress: &[f64; S], force: &mut [f64]) {
    for (row, stress) in rows.iter().zip(stress) {
        axpy(volume * stress, row, force);
    }
}

/// Adds the stiffness of a point to a D x D matrix by rows.
fn add_stiffness<const S: usize, const D: usize>(
    rows: &Rows<S, D>,
    volume: f64,
    tangent: &Tangent<S>,
    matrix: &mut [f64],
) {
    for (a, tangent) in rows.iter().zip(tangent) {
        let mut by_disp = [0.0; D];
        for (b, d) in rows.iter().zip(tangent).filter(|(_, d)| **d != 0.0) {
            axpy(volume * d, b, &mut by_disp);
        }
        for (a, out) in a.iter().zip(matrix.chunks_exact_mut(D)).filter(|(a, _)| **a != 0.0) {
            axpy(*a, &by_disp, out);
        }
    }
}

impl<const S: usize, const D: usize> Continuum<S, D> {
    fn of(body: Body<S, D>, law: &SharedMultiaxial<S>) -> Self {
        let law = &law.of_length(body.size).unwrap_or_else(|| SharedMultiaxial::clone(law));
        let tangent = law.initial_tangent();
        let mut stiffness = if body.stabilisation.is_empty() { vec![0.0; D * D] } else { body.stabilisation.clone() };
        for (rows, volume) in &body.points {
            for (a, d) in rows.iter().zip(&tangent) {
                for (b, d) in rows.iter().zip(d).filter(|(_, d)| **d != 0.0) {
                    for (i, a) in a.iter().enumerate() {
                        axpy(volume * d * a, b, &mut stiffness[D * i..D * (i + 1)]);
                    }
                }
            }
        }
        let (symmetric, elapses) = (law.is_symmetric(), law.depends_on_time());
        let (law, point_len) = if law.is_linear() && law.state_len() == 0 {
            (PointLaw::Linear(tangent), 0)
        } else {
            (PointLaw::General(SharedMultiaxial::clone(law)), S + law.state_len())
        };
        let inverted = body.points.iter().any(|(_, volume)| *volume < 0.0);
        Self { body, law, point_len, symmetric, elapses, stiffness, inverted }
    }

    /// Returns true if the volume at a point is negative: the nodes go round the other way or the element is not convex.
    /// Stiffness and mass are then negative there.
    pub fn is_inverted(&self) -> bool {
        self.inverted
    }

    /// Law of each point with the range of its state.
    fn laws(&self) -> impl Iterator<Item = (Range<usize>, &SharedMultiaxial<S>)> {
        let law = match &self.law {
            PointLaw::Linear(_) => None,
            PointLaw::General(law) => Some(law),
        };
        let points = 0..self.body.points.len();
        law.into_iter()
            .flat_map(move |law| points.clone().map(move |i| (i * self.point_len + S..(i + 1) * self.point_len, law)))
    }

    fn strain(&self, point: usize, disp: &[f64]) -> [f64; S] {
        self.body.points[point].0.each_ref().map(|row| dot(row, disp))
    }

    /// Stresses of a point in a state.
    fn stress(&self, point: usize, s: &Snapshot<'_>) -> [f64; S] {
        match &self.law {
            PointLaw::Linear(elasticity) => {
                let strain = self.strain(point, s.disp);
                elasticity.each_ref().map(|row| dot(row, &strain))
            }
            PointLaw::General(_) => {
                let at = point * self.point_len;
                std::array::from_fn(|i| s.state[at + i])
            }
        }
    }

    /// Tangent of a law without a history.
    fn tangent(&self) -> Option<[[f64; S]; S]> {
        match &self.law {
            PointLaw::Linear(elasticity) => Some(*elasticity),
            PointLaw::General(law) => law.is_linear().then(|| law.initial_tangent()),
        }
    }

    fn stress_names() -> [&'static str; S] {
        let all = ["sigma11", "sigma22", "sigma33", "sigma12", "sigma23", "sigma13"];
        std::array::from_fn(|i| if S < SOLID && i + 1 == S { all[3] } else { all[i] })
    }

    /// Names of the strains of all points; those of one point in a plane have other names in OpenSees.
    fn strain_names(one: bool) -> [&'static str; S] {
        let space = ["eps11", "eps22", "eps33", "eps12", "eps23", "eps13"];
        std::array::from_fn(|i| match (S, one, i) {
            (3, false, _) => ["eta11", "eta22", "eta12"][i],
            (3, true, 2) | (4, _, 3) => space[3],
            _ => space[i],
        })
    }

    /// Response of one point.
    fn probe_point(&self, point: u32, words: &[&str]) -> Option<Probe> {
        let named = match *words.first()? {
            "stress" | "stresses" => Probe::new(STRESSES, Self::stress_names()),
            "strain" | "strains" => Probe::new(STRAINS, Self::strain_names(true)),
            // That of a law with a history belongs to its last step, and is not kept.
            "tangent" if self.tangent().is_some() => {
                let entry = |i: usize| move |j: usize| format!("C{}{}", i + 1, j + 1);
                Probe::new(TANGENT, (0..S).flat_map(|i| (0..S).map(entry(i))))
            }
            _ => match &self.law {
                PointLaw::Linear(_) => return None,
                PointLaw::General(law) => law.probe(words)?.inside(&[OWN]),
            },
        };
        Some(named.inside(&[POINT, point]))
    }

    fn read_point(&self, point: usize, path: &[u32], s: &Snapshot<'_>, out: &mut [f64]) {
        match (path[0], &self.law) {
            (STRESSES, _) => out.copy_from_slice(&self.stress(point, s)),
            (TANGENT, _) => {
                if let Some(tangent) = self.tangent() {
                    out.copy_from_slice(tangent.as_flattened());
                }
            }
            (OWN, PointLaw::General(law)) => {
                let history = &s.state[point * self.point_len..(point + 1) * self.point_len];
                law.read(&path[1..], &history[S..], out);
            }
            _ => out.copy_from_slice(&self.strain(point, s.disp)),
        }
    }
}

const STRESSES: u32 = 3;
const STRAINS: u32 = 4;
const AT_NODES: u32 = 11;
/// First numbers of the paths of one point, and of a response of its law.
const POINT: u32 = 20;
const OWN: u32 = 5;
const TANGENT: u32 = 6;

crate::watches_columns!([const S: usize, const D: usize] Continuum<S, D> => |s| at s.laws());

impl<const S: usize, const D: usize> Element for Continuum<S, D> {
    fn class(&self) -> Class {
        self.body.class
    }
    fn dofs(&self) -> usize {
        D
    }
    fn state_len(&self) -> usize {
        self.body.points.len() * self.point_len
    }
    fn init(&self, state: &mut [f64]) {
        if let PointLaw::General(law) = &self.law {
            for point in state.chunks_exact_mut(self.point_len) {
                point[..S].fill(0.0);
                law.init(&mut point[S..]);
            }
        }
    }
    fn traits(&self) -> ElementTraits {
        let linear = matches!(self.law, PointLaw::Linear(_));
        ElementTraits { linear, symmetric: self.symmetric, viscous: false, elapses: self.elapses, rayleigh: true }
    }

    fn respond(&self, m: &ElementInput<'_>, h: &mut Histories<'_>, output: ElementOutput<'_>) -> ElementResult {
        let (force, mut tangent) = (output.force, output.tangent);
        force.copy_from_slice(&self.body.load_force);
        match &self.law {
            PointLaw::Linear(elasticity) => {
                // Forces come from stresses: the round-off of stiffness times displacements would not be in equilibrium.
                for (rows, volume) in &self.body.points {
                    let strain = rows.each_ref().map(|row| dot(row, m.disp));
                    add_force(rows, *volume, &elasticity.each_ref().map(|row| dot(row, &strain)), force);
                }
                if let Some(k) = tangent {
                    axpy(1.0, &self.stiffness, k);
                }
            }
            PointLaw::General(law) => {
                let histories = h.committed.chunks_exact(self.point_len).zip(h.trial.chunks_exact_mut(self.point_len));
                for ((rows, volume), (old, new)) in self.body.points.iter().zip(histories) {
                    let strain = rows.each_ref().map(|row| dot(row, m.disp));
                    let (own, next) = new.split_at_mut(S);
                    let (stress, slope) = law.update(&old[S..], &strain, m.dt, next)?;
                    own.copy_from_slice(&law.shown_stress(next, stress));
                    add_force(rows, *volume, &stress, force);
                    if let Some(k) = tangent.as_deref_mut() {
                        add_stiffness(rows, *volume, &slope, k);
                    }
                }
                if let Some(k) = tangent.filter(|_| !self.body.stabilisation.is_empty()) {
                    axpy(1.0, &self.body.stabilisation, k);
                }
            }
        }
        for (force, row) in force.iter_mut().zip(self.body.stabilisation.chunks_exact(D)) {
            *force += dot(row, m.disp);
        }
        Ok(())
    }

    fn initial_tangent(&self, tangent: &mut [f64]) {
        axpy(1.0, &self.stiffness, tangent);
    }

    fn roles(&self) -> Roles<'_> {
        Roles {
            mass: Some(self),
            opensees: OpenSeesTraits::of_mass(self.body.mass != Mass::None),
            basic_forces: Some(self),
            force_labels: ForceLabels::DirectionAndNode(if S < SOLID { 2 } else { 3 }),
            ..Roles::default()
        }
    }

    fn probe(&self, words: &[&str]) -> Option<Probe> {
        let count = self.body.points.len();
        let all = |count: usize, names: [&'static str; S]| (0..count).flat_map(move |_| names);
        Some(match words {
            ["stress" | "stresses", ..] => Probe::new(STRESSES, all(count, Self::stress_names())),
            ["strain" | "strains", ..] => Probe::new(STRAINS, all(count, Self::strain_names(false))),
            ["stressAtNodes" | "stressesAtNodes", ..] if !self.body.extrapolation.is_empty() => {
                Probe::new(AT_NODES, all(self.body.extrapolation.len(), Self::stress_names()))
            }
            ["material" | "integrPoint", point, rest @ ..] => {
                let point = point.parse::<u32>().ok().filter(|p| (1..=count as u32).contains(p))? - 1;
                return self.probe_point(point, rest);
            }
            // An element of one point asks its material.
            words if count == 1 => return self.probe_point(0, words),
            _ => return None,
        })
    }

    fn probe_names(&self) -> Vec<&'static str> {
        if self.body.extrapolation.is_empty() {
            vec!["stresses", "strains", "material"]
        } else {
            vec!["stresses", "strains", "stressesAtNodes", "material"]
        }
    }

    fn read(&self, path: &[u32], s: &Snapshot<'_>, out: &mut [f64]) {
        match path[0] {
            STRESSES => {
                let points = out.chunks_exact_mut(S).enumerate();
                points.for_each(|(point, out)| out.copy_from_slice(&self.stress(point, s)));
            }
            STRAINS => {
                let points = out.chunks_exact_mut(S).enumerate();
                points.for_each(|(point, out)| out.copy_from_slice(&self.strain(point, s.disp)));
            }
            AT_NODES => {
                for (shares, out) in self.body.extrapolation.iter().zip(out.chunks_exact_mut(S)) {
                    out.fill(0.0);
                    let points = shares.iter().enumerate();
                    points.for_each(|(point, share)| axpy(*share, &self.stress(point, s), out));
                }
            }
            _ => self.read_point(path[1] as usize, &path[2..], s, out),
        }
    }
}

impl<const S: usize, const D: usize> Inertia for Continuum<S, D> {
    fn mass(&self) -> Mass {
        self.body.mass.clone()
    }
}

impl<const S: usize, const D: usize> BasicForces for Continuum<S, D> {
    fn len(&self) -> usize {
        self.body.points.len() * S
    }
    fn in_resisting_force(&self) -> bool {
        true
    }
    fn basic_forces(&self, disp: &[f64], state: &[f64], _: &[f64], out: &mut [f64]) {
        let snapshot = Snapshot { disp, state, force: &[], load: &[] };
        let points = out.chunks_exact_mut(S).enumerate();
        points.for_each(|(point, q)| q.copy_from_slice(&self.stress(point, &snapshot)));
    }
    fn add_global(&self, _: &[f64], _: &[f64], q: &[f64], force: &mut [f64]) {
        for ((rows, volume), q) in self.body.points.iter().zip(q.chunks_exact(S)) {
            rows.iter().zip(q).for_each(|(row, q)| axpy(volume * q, row, force));
        }
    }
    fn scale_stiffness(&self, _: &[f64], _: &[f64], factor: f64, tangent: &mut [f64]) {
        tangent.iter_mut().for_each(|k| *k *= 1.0 + factor);
    }
}

/// Derivatives of the strains 11, 22, 12 by the displacements, from those of the shape functions.
fn plane_rows<const D: usize>(gradients: impl IntoIterator<Item = [f64; 2]>) -> Rows<3, D> {
    let mut rows = [[0.0; D]; 3];
    for (node, [dx, dy]) in gradients.into_iter().enumerate() {
        let [x, y] = [2 * node, 2 * node + 1];
        (rows[0][x], rows[1][y], rows[2][x], rows[2][y]) = (dx, dy, dy, dx);
    }
    rows
}

/// Lumped mass, or none.
fn lumped(mass: &[f64]) -> Mass {
    if mass.iter().all(|m| *m == 0.0) { Mass::None } else { Mass::Lumped(mass.to_vec()) }
}

/// Least distance of two points.
fn least_distance<P: AsRef<[f64]>>(points: &[P]) -> f64 {
    let distance = |a: &P, b: &P| a.as_ref().iter().zip(b.as_ref()).map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt();
    let pairs = points.iter().enumerate().flat_map(|(i, a)| points[i + 1..].iter().map(move |b| distance(a, b)));
    pairs.fold(f64::INFINITY, f64::min)
}
