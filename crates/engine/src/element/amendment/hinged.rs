//! A beam with plastic hinges at its ends.

use crate::element::inner::Inner;
use crate::element::roles::{ElementParameters, Roles};
use crate::element::{
    Class, Element, ElementError, ElementInput, ElementOutput, ElementResult, ElementTraits, Histories, MatrixMask,
    Snapshot, dot,
};
use crate::material::{Material, Strain, WatchesColumns};
use crate::parameter::{Changed, NewValue, ParameterError};
use crate::probe::Probe;
use nalgebra::{Matrix4, SVector, Vector3};
use std::ops::Range;
use std::sync::Arc;

/// A beam with plastic hinges at its ends. A uniaxial material gives the moment of a hinge for its rotation. The
/// one-component model is that of Giberson (Journal of the Structural Division ASCE 95 (1969) 137).
///
/// Each end has a hinge about each axis normal to the undeformed chord. With the hinge rotation θ the end of the beam
/// rotates by the node's rotation less θ. Equilibrium M_beam = M_hinge(θ) is solved inside the element, and θ is
/// condensed from the tangent. The model gets no further equations, and stiff hinges cause no ill-conditioning.
#[derive(Clone, Debug)]
pub struct Hinged {
    inner: Inner,
    material: Material,
    hinges: Vec<Hinge>,
    hinge_len: usize,
    /// Tolerance of a moment, from the stiffness of the beam; force x length.
    moment_tolerance: f64,
}

#[derive(Clone, Debug)]
struct Hinge {
    /// Unit rotation of the node about the hinge axis; one entry per degree of freedom.
    row: Vec<f64>,
    /// Column name of the hinge rotation.
    label: String,
}

/// Degrees of freedom of a beam in space.
const SPACE: usize = 12;
/// Largest number of hinges: two axes at both ends.
const MAX_HINGES: usize = 4;
/// Rotation (rad) that, times the larger stiffness of beam and hinge, is the tolerance of moments.
const ROTATION_TOLERANCE: f64 = 1e-15;
/// Largest number of linearisations of a nonlinear beam.
const MAX_LINEARIZATIONS: usize = 30;
/// Largest number of Newton steps for all hinges at once, then of Gauss-Seidel sweeps, then of steps for one hinge in a
/// sweep.
const MAX_NEWTON_STEPS: usize = 8;
const MAX_SWEEPS: usize = 200;
const MAX_HINGE_STEPS: usize = 100;
/// Relative round-off of a moment.
const ROUND_OFF: f64 = 1e-12;
/// Smallest horizontal component of a unit chord that is not vertical.
const MIN_HORIZONTAL: f64 = 1e-6;
/// Probe path of the hinge rotations. Paths of the element itself begin with small numbers.
const ROTATIONS: u32 = u32::MAX;

/// One value per hinge.
type PerHinge = SVector<f64, MAX_HINGES>;

/// Moments and tangents of the hinges at given rotations.
#[derive(Clone, Copy)]
struct HingeMoments {
    moment: PerHinge,
    tangent: PerHinge,
}

impl Hinged {
    /// Adds hinges at some of the `ends` of a beam: 0 for node i, 1 for node j. The chord is a vector along the beam of
    /// any length. Nodes have three degrees of freedom in the plane, six in space. The material gives the moment (force
    /// x length) for the rotation (rad).
    ///
    /// # Errors
    /// An element that is no beam or has no moment at an end. A material that depends on the strain rate.
    pub fn new(
        inner: Arc<dyn Element>,
        chord: Vector3<f64>,
        ends: &[usize],
        material: Material,
    ) -> ElementResult<Self> {
        let n = inner.dofs();
        let class = inner.class().name;
        if !inner.basic_rows().is_empty() {
            return Err(ElementError(format!("{class} is amended by direction, and has no hinges").into()));
        }
        if inner.opensees().calls.is_some() && !inner.traits().linear {
            let message = format!("{class} follows OpenSees call by call, which hinges would disturb");
            return Err(ElementError(message.into()));
        }
        let axes = match n {
            6 => vec![Vector3::z()],
            SPACE if chord.norm() > 0.0 => normal_to(&chord.normalize()).to_vec(),
            _ => return Err(ElementError(format!("{class} is no beam: it has no ends to turn").into())),
        };
        if material.is_viscous() {
            let message = format!("{} depends on the rate, which hinges do not know", material.name());
            return Err(ElementError(message.into()));
        }
        let hinge = |end: usize, axis: (usize, &Vector3<f64>)| {
            let mut row = vec![0.0; n];
            let own = n / 2 * (end + 1);
            match n {
                6 => row[own - 1] = 1.0,
                _ => row[own - 3..own].copy_from_slice(axis.1.as_slice()),
            }
            Hinge { label: format!("theta{}_{}", axis.0 + 1, end + 1), row }
        };
        let hinges = ends.iter().flat_map(|end| axes.iter().enumerate().map(move |a| hinge(*end, a))).collect();
        let hinge_len = 1 + material.state_len();
        Self { inner: Inner::new(inner), material, hinges, hinge_len, moment_tolerance: 0.0 }.scaled()
    }

    /// The beam and the materials of the hinges with the ranges of their states.
    fn parts(&self) -> impl Iterator<Item = (Range<usize>, &dyn WatchesColumns)> {
        let hinge = |i: usize| {
            let start = self.inner.len() + i * self.hinge_len;
            (start + 1..start + self.hinge_len, &self.material as &dyn WatchesColumns)
        };
        let beam = (0..self.inner.len(), &**self.inner as &dyn WatchesColumns);
        std::iter::once(beam).chain((0..self.hinges.len()).map(hinge))
    }

    /// Sets the tolerance of moments from the stiffness of the beam.
    fn scaled(mut self) -> ElementResult<Self> {
        let mut stiffness = vec![0.0; self.inner.dofs().pow(2)];
        self.inner.initial_tangent(&mut stiffness);
        let own = self.stiffness(&stiffness).diagonal();
        let own = own.rows(0, self.hinges.len());
        if own.min() <= 0.0 {
            let class = self.inner.class().name;
            return Err(ElementError(format!("{class} carries no moment at an end that shall have a hinge").into()));
        }
        self.moment_tolerance = ROTATION_TOLERANCE * own.max().max(self.material.initial_tangent().abs());
        Ok(self)
    }

    /// Displacements of the beam's ends: node displacements less hinge rotations.
    fn beam_displacements(&self, disp: &[f64], rotations: &PerHinge) -> [f64; SPACE] {
        let mut out = [0.0; SPACE];
        out[..disp.len()].copy_from_slice(disp);
        for (hinge, by) in self.hinges.iter().zip(rotations) {
            out.iter_mut().zip(&hinge.row).for_each(|(d, a)| *d -= by * a);
        }
        out
    }

    /// Hinge rotations from the state variables.
    fn rotations(&self, state: &[f64]) -> PerHinge {
        let mut out = PerHinge::zeros();
        out.iter_mut().zip(state.chunks_exact(self.hinge_len)).for_each(|(out, hinge)| *out = hinge[0]);
        out
    }

    /// Stiffness of the beam for the rotations of its hinges, with 1 on the diagonal of missing hinges.
    fn stiffness(&self, tangent: &[f64]) -> Matrix4<f64> {
        let n = self.inner.dofs();
        let mut out = Matrix4::identity();
        for (i, a) in self.hinges.iter().enumerate() {
            for (j, b) in self.hinges.iter().enumerate() {
                out[(i, j)] = tangent.chunks_exact(n).zip(&a.row).map(|(k, a)| a * dot(k, &b.row)).sum();
            }
        }
        out
    }

    /// Moment and tangent of hinge `i` at a rotation; writes its trial state variables.
    fn hinge_response(&self, i: usize, rotation: f64, h: &mut Histories<'_>, dt: f64) -> ElementResult<(f64, f64)> {
        let range = i * self.hinge_len..(i + 1) * self.hinge_len;
        let (old, next) = (&h.committed[range.clone()], &mut h.trial[range]);
        next[0] = rotation;
        let s = self.material.update(&old[1..], Strain { value: rotation, rate: 0.0, dt }, &mut next[1..])?;
        Ok((s.value, s.tangent))
    }

    fn hinge_responses(&self, rotations: &PerHinge, h: &mut Histories<'_>, dt: f64) -> ElementResult<HingeMoments> {
        let mut out = HingeMoments { moment: PerHinge::zeros(), tangent: PerHinge::zeros() };
        for i in 0..self.hinges.len() {
            (out.moment[i], out.tangent[i]) = self.hinge_response(i, rotations[i], h, dt)?;
        }
        Ok(out)
    }

    /// Hinge rotations with equal moments of hinges and beam. The beam is linearised: `moments` at the rotations
    /// `from`, with the stiffness `k`.
    ///
    /// Newton's method comes first. If it does not converge, the hinges are solved one after the other (Gauss-Seidel).
    fn solve(
        &self,
        k: &Matrix4<f64>,
        moments: &PerHinge,
        from: &PerHinge,
        h: &mut Histories<'_>,
        dt: f64,
    ) -> ElementResult<PerHinge> {
        let mut theta = *from;
        let tolerance = self.moment_tolerance + ROUND_OFF * moments.amax();
        for _ in 0..MAX_NEWTON_STEPS {
            let hinges_now = self.hinge_responses(&theta, h, dt)?;
            let residual = moments - k * (theta - from) - hinges_now.moment;
            if residual.rows(0, self.hinges.len()).amax() <= tolerance {
                return Ok(theta);
            }
            let mut with_hinges = *k;
            (0..self.hinges.len()).for_each(|i| with_hinges[(i, i)] += hinges_now.tangent[i]);
            let Some(flexibility) = with_hinges.try_inverse() else { break };
            theta += flexibility * residual;
        }
        theta = *from;
        for _ in 0..MAX_SWEEPS {
            let before = theta;
            for i in 0..self.hinges.len() {
                let others = (k.row(i) * (theta - from))[0] - k[(i, i)] * (theta[i] - from[i]);
                theta[i] = self.solve_hinge(i, (moments[i] - others, from[i], k[(i, i)]), theta[i], h, dt)?;
            }
            let moment_change = k.diagonal().component_mul(&(theta - before));
            if moment_change.amax() <= tolerance {
                return Ok(theta);
            }
        }
        Err(ElementError("its hinges find no equilibrium in this step".into()))
    }

    /// Rotation of one hinge at fixed rotations of the others. The residual falls monotonically with the rotation, so
    /// Newton steps are safeguarded by a bracket.
    fn solve_hinge(
        &self,
        i: usize,
        (moment, at, k): (f64, f64, f64),
        start: f64,
        h: &mut Histories<'_>,
        dt: f64,
    ) -> ElementResult<f64> {
        let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
        let mut theta = start;
        for _ in 0..MAX_HINGE_STEPS {
            let (own, tangent) = self.hinge_response(i, theta, h, dt)?;
            let residual = moment - k * (theta - at) - own;
            if residual.abs() <= self.moment_tolerance + ROUND_OFF * own.abs() {
                break;
            }
            if residual > 0.0 {
                low = theta
            } else {
                high = theta
            }
            let next = theta + residual / (k + tangent);
            theta = if next > low && next < high { next } else { 0.5 * (low + high) };
            if !theta.is_finite() {
                return Err(ElementError("the material of a hinge softens faster than the beam unloads".into()));
            }
            if theta == low || theta == high {
                break;
            }
        }
        Ok(theta)
    }

    /// Condenses the hinge rotations out of the tangent.
    fn condense(&self, tangent: &mut [f64], of_hinges: &PerHinge) {
        let n = self.inner.dofs();
        let mut hinge_stiffness = self.stiffness(tangent);
        (0..self.hinges.len()).for_each(|i| hinge_stiffness[(i, i)] += of_hinges[i]);
        let Some(flexibility) = hinge_stiffness.try_inverse() else { return };
        let (mut by_hinge, mut by_disp) = ([[0.0; MAX_HINGES]; SPACE], [[0.0; SPACE]; MAX_HINGES]);
        for (h, hinge) in self.hinges.iter().enumerate() {
            for (i, k) in tangent.chunks_exact(n).enumerate() {
                by_hinge[i][h] = dot(k, &hinge.row);
                k.iter().zip(&mut by_disp[h]).for_each(|(k, out)| *out += hinge.row[i] * k);
            }
        }
        for (row, by_hinge) in tangent.chunks_exact_mut(n).zip(&by_hinge) {
            for (h, by_disp) in by_disp.iter().enumerate().take(self.hinges.len()) {
                let condensed: f64 = (0..MAX_HINGES).map(|g| by_hinge[g] * flexibility[(g, h)]).sum();
                row.iter_mut().zip(by_disp).for_each(|(k, d)| *k -= condensed * d);
            }
        }
    }
}

/// The two axes normal to a chord: the horizontal one, for bending in the vertical plane, and the other.
fn normal_to(chord: &Vector3<f64>) -> [Vector3<f64>; 2] {
    let horizontal = chord.cross(&Vector3::z());
    let first = if horizontal.norm() > MIN_HORIZONTAL { horizontal.normalize() } else { Vector3::x() };
    [first, chord.cross(&first)]
}

crate::watches_columns!(Hinged => |s| at s.parts());

#[deny(clippy::missing_trait_methods)]
impl Element for Hinged {
    fn class(&self) -> Class {
        self.inner.class()
    }
    fn dofs(&self) -> usize {
        self.inner.dofs()
    }
    fn state_len(&self) -> usize {
        self.inner.len() + self.hinges.len() * self.hinge_len
    }
    fn init(&self, state: &mut [f64]) {
        let (own, hinges) = state.split_at_mut(self.inner.len());
        self.inner.init(own);
        for hinge in hinges.chunks_exact_mut(self.hinge_len) {
            hinge[0] = 0.0;
            self.material.init(&mut hinge[1..]);
        }
    }
    fn traits(&self) -> ElementTraits {
        let inner = self.inner.traits();
        ElementTraits { linear: false, elapses: inner.elapses || self.material.depends_on_time(), ..inner }
    }

    fn respond(&self, motion: &ElementInput<'_>, h: &mut Histories<'_>, mut out: ElementOutput<'_>) -> ElementResult {
        let n = self.dofs();
        let (mut inner, mut hinges) = h.split_at(self.inner.len());
        let (mut rotations, h, dt) = (self.rotations(hinges.committed), &mut hinges, motion.dt);
        let mut own = [0.0; SPACE * SPACE];
        for _ in 0..MAX_LINEARIZATIONS {
            out.force.fill(0.0);
            if let Some(damping) = out.damping.as_deref_mut() {
                damping.fill(0.0);
            }
            let tangent = &mut own[..n * n];
            tangent.fill(0.0);
            let disp = self.beam_displacements(motion.disp, &rotations);
            let asked = ElementOutput {
                force: &mut *out.force,
                tangent: Some(&mut *tangent),
                damping: out.damping.as_deref_mut(),
                part: MatrixMask::ALL,
            };
            self.inner.respond(&ElementInput { disp: &disp[..n], ..*motion }, &mut inner, asked)?;
            let mut moments = PerHinge::zeros();
            moments.iter_mut().zip(&self.hinges).for_each(|(m, hinge)| *m = dot(&hinge.row, out.force));
            let hinges_now = self.hinge_responses(&rotations, h, dt)?;
            let size = moments.amax() + hinges_now.moment.amax();
            if (moments - hinges_now.moment).amax() <= 10.0 * self.moment_tolerance + ROUND_OFF * size {
                if let Some(whole) = out.tangent {
                    self.condense(tangent, &hinges_now.tangent);
                    whole.copy_from_slice(tangent);
                }
                return Ok(());
            }
            rotations = self.solve(&self.stiffness(tangent), &moments, &rotations, h, dt)?;
        }
        Err(ElementError("its hinges find no equilibrium in this step".into()))
    }

    fn initial_tangent(&self, tangent: &mut [f64]) {
        self.inner.initial_tangent(tangent);
        self.condense(tangent, &PerHinge::repeat(self.material.initial_tangent()));
    }

    fn commit(&self, trial: &[f64], committed: &mut [f64]) {
        self.inner.commit(trial, committed);
    }
    fn roles(&self) -> Roles<'_> {
        // An inner element that depends on the number of calls is linear here, and is evaluated like any other.
        self.inner.roles(self)
    }

    fn probe_names(&self) -> Vec<&'static str> {
        let mut names = self.inner.probe_names();
        names.push("hingeRotation");
        names
    }
    // Paths equal those of the element, so recorders from before the hinges stay valid.
    fn probe(&self, words: &[&str]) -> Option<Probe> {
        match words {
            ["hingeRotation"] => Some(Probe::new(ROTATIONS, self.hinges.iter().map(|h| h.label.clone()))),
            words => self.inner.probe(words),
        }
    }
    fn read(&self, path: &[u32], s: &Snapshot<'_>, out: &mut [f64]) {
        let (state, hinge_states) = s.state.split_at(self.inner.len());
        let rotations = self.rotations(hinge_states);
        if path == [ROTATIONS] {
            return out.copy_from_slice(&rotations.as_slice()[..out.len()]);
        }
        let disp = self.beam_displacements(s.disp, &rotations);
        self.inner.read(path, &Snapshot { state, disp: &disp[..s.disp.len()], ..*s }, out);
    }
}

impl ElementParameters for Hinged {
    fn with_parameter(&self, words: &[&str], value: NewValue) -> Changed<Arc<dyn Element>> {
        let (inner, old) = self.inner.with_parameter(words, value)?;
        let new = Self { inner: Inner::new(inner), ..self.clone() }
            .scaled()
            .map_err(|e| ParameterError::Refused(e.to_string()))?;
        Ok((Arc::new(new), old))
    }
}
