//! A beam with plastic hinges at its ends.

use crate::element::{
    BasicRow, Element, ElementError, ElementInput, ElementLoad, ElementOutput, ElementTraits, Mass, MatrixMask,
    Overload, Snapshot, dot,
};
use crate::material::{Material, Strain};
use crate::probe::Probe;
use nalgebra::{Matrix4, SVector, Vector3};
use std::sync::Arc;

/// A beam whose ends turn against its nodes by the law of a uniaxial material, moment over rotation: the one-component model of
/// Giberson (Journal of the Structural Division ASCE 95 (1969) 137).
///
/// Each end has a hinge about each axis normal to the chord at rest. With its rotation θ, the beam is asked at the rotation of the node
/// less θ, and its moment is that of the material at θ. The hinges are settled within the element, and their rotations condensed from
/// its tangent: the equations of the model are not more than without them, and hinges much stiffer than the beam do no harm.
#[derive(Clone, Debug)]
pub struct Hinged {
    inner: Arc<dyn Element>,
    material: Material,
    hinges: Vec<Hinge>,
    /// State variables of the element's own history, and of a hinge: its rotation, then those of the material.
    inner_len: usize,
    hinge_len: usize,
    /// Moments within this are the same: it goes with the stiffness of the beam.
    close: f64,
}

#[derive(Clone, Debug)]
struct Hinge {
    /// Unit rotation of the node about its axis, over all degrees of freedom.
    row: Vec<f64>,
    /// Name of its rotation.
    label: String,
}

/// Degrees of freedom of a beam in space.
const SPACE: usize = 12;
/// Hinges at most: about two axes at both ends.
const MOST: usize = 4;
/// Rotation by which the larger stiffness of beam and hinge tells what moments are the same.
const CLOSE: f64 = 1e-15;
/// Rounds in which the moments of a beam are followed that is not linear.
const ROUNDS: usize = 30;
/// Steps of Newton's method for all hinges at once; then sweeps from hinge to hinge, with so many steps in each.
const TOGETHER: usize = 8;
const SWEEPS: usize = 200;
const STEPS: usize = 100;
/// Part of a moment that rounding may have.
const SAME: f64 = 1e-12;
/// Path of the rotations: the element's own begin with small numbers.
const ROTATIONS: u32 = u32::MAX;

/// A number for each hinge.
type Each = SVector<f64, MOST>;

/// What the hinges answer to their rotations.
#[derive(Clone, Copy)]
struct HingeMoments {
    moment: Each,
    tangent: Each,
}

/// Histories of the hinges of a step: committed, and where the next ones go.
struct Histories<'a> {
    old: &'a [f64],
    next: &'a mut [f64],
    dt: f64,
}

impl Hinged {
    /// With hinges at some of the ends (0 for node i, 1 for node j) of a beam along a chord, whose length does not matter. Its nodes have
    /// three degrees of freedom in the plane, six in space. The material gives the moment (force times length) for the rotation in
    /// radians.
    ///
    /// # Errors
    /// An element that is no beam, or has an end without moment. A material that depends on the rate, which a hinge does not know.
    pub fn new(
        inner: Arc<dyn Element>,
        chord: Vector3<f64>,
        ends: &[usize],
        material: Material,
    ) -> Result<Self, ElementError> {
        let n = inner.dofs();
        let class = inner.class();
        if !inner.basic_rows().is_empty() {
            return Err(ElementError(format!("{class} is amended by direction, and has no hinges").into()));
        }
        if inner.counts_calls() && !inner.traits().linear {
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
        let (inner_len, hinge_len) = (inner.state_len(), 1 + material.state_len());
        Self { inner, material, hinges, inner_len, hinge_len, close: 0.0 }.scaled()
    }

    /// The same with the tolerance of moments that belongs to the stiffness of the beam.
    fn scaled(mut self) -> Result<Self, ElementError> {
        let mut stiffness = vec![0.0; self.inner.dofs().pow(2)];
        self.inner.initial_tangent(&mut stiffness);
        let own = self.stiffness(&stiffness).diagonal();
        let own = own.rows(0, self.hinges.len());
        if own.min() <= 0.0 {
            let class = self.inner.class();
            return Err(ElementError(format!("{class} carries no moment at an end that shall have a hinge").into()));
        }
        self.close = CLOSE * own.max().max(self.material.initial_tangent().abs());
        Ok(self)
    }

    /// Displacements behind the hinges.
    fn behind(&self, disp: &[f64], rotations: &Each) -> [f64; SPACE] {
        let mut out = [0.0; SPACE];
        out[..disp.len()].copy_from_slice(disp);
        for (hinge, by) in self.hinges.iter().zip(rotations) {
            out.iter_mut().zip(&hinge.row).for_each(|(d, a)| *d -= by * a);
        }
        out
    }

    /// Rotations in the histories of the hinges.
    fn rotations(&self, words: &[f64]) -> Each {
        let mut out = Each::zeros();
        out.iter_mut().zip(words.chunks_exact(self.hinge_len)).for_each(|(out, words)| *out = words[0]);
        out
    }

    /// Stiffness of the beam against the rotations of its hinges; 1 on the diagonal of those that are not there.
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

    /// Moment and tangent of one hinge at a rotation, with its next history.
    fn ask(&self, i: usize, rotation: f64, h: &mut Histories<'_>) -> Result<(f64, f64), ElementError> {
        let words = i * self.hinge_len..(i + 1) * self.hinge_len;
        let (old, next) = (&h.old[words.clone()], &mut h.next[words]);
        next[0] = rotation;
        let s = self.material.update(&old[1..], Strain { value: rotation, rate: 0.0, dt: h.dt }, &mut next[1..])?;
        Ok((s.value, s.tangent))
    }

    fn ask_all(&self, rotations: &Each, h: &mut Histories<'_>) -> Result<HingeMoments, ElementError> {
        let mut out = HingeMoments { moment: Each::zeros(), tangent: Each::zeros() };
        for i in 0..self.hinges.len() {
            (out.moment[i], out.tangent[i]) = self.ask(i, rotations[i], h)?;
        }
        Ok(out)
    }

    /// Rotations at which the moments of the hinges are those of the beam: `moments` at the rotations `from`, from there by the
    /// stiffness `k`. Newton's method; where it does not get there, hinge after hinge until nothing moves (Gauss and Seidel).
    fn settle(
        &self,
        k: &Matrix4<f64>,
        moments: &Each,
        from: &Each,
        h: &mut Histories<'_>,
    ) -> Result<Each, ElementError> {
        let mut now = *from;
        let enough = self.close + SAME * moments.amax();
        for _ in 0..TOGETHER {
            let said = self.ask_all(&now, h)?;
            let over = moments - k * (now - from) - said.moment;
            if over.rows(0, self.hinges.len()).amax() <= enough {
                return Ok(now);
            }
            let mut with_hinges = *k;
            (0..self.hinges.len()).for_each(|i| with_hinges[(i, i)] += said.tangent[i]);
            let Some(flexibility) = with_hinges.try_inverse() else { break };
            now += flexibility * over;
        }
        now = *from;
        for _ in 0..SWEEPS {
            let before = now;
            for i in 0..self.hinges.len() {
                let others = (k.row(i) * (now - from))[0] - k[(i, i)] * (now[i] - from[i]);
                now[i] = self.settle_one(i, (moments[i] - others, from[i], k[(i, i)]), now[i], h)?;
            }
            let moved = k.diagonal().component_mul(&(now - before));
            if moved.amax() <= enough {
                return Ok(now);
            }
        }
        Err(ElementError("its hinges find no equilibrium in this step".into()))
    }

    /// The rotation of one hinge, where the others stay, under a moment (at a rotation) that falls with the stiffness of the beam: what
    /// is over falls with the rotation, so that Newton's steps can be kept between bounds.
    fn settle_one(
        &self,
        i: usize,
        (moment, at, k): (f64, f64, f64),
        start: f64,
        h: &mut Histories<'_>,
    ) -> Result<f64, ElementError> {
        let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
        let mut now = start;
        for _ in 0..STEPS {
            let (own, tangent) = self.ask(i, now, h)?;
            let over = moment - k * (now - at) - own;
            if over.abs() <= self.close + SAME * own.abs() {
                break;
            }
            if over > 0.0 {
                low = now
            } else {
                high = now
            }
            let next = now + over / (k + tangent);
            now = if next > low && next < high { next } else { 0.5 * (low + high) };
            if !now.is_finite() {
                return Err(ElementError("the material of a hinge softens faster than the beam unloads".into()));
            }
            if now == low || now == high {
                break;
            }
        }
        Ok(now)
    }

    /// Take from the tangent what the hinges give way.
    fn condense(&self, tangent: &mut [f64], of_hinges: &Each) {
        let n = self.inner.dofs();
        let mut among = self.stiffness(tangent);
        (0..self.hinges.len()).for_each(|i| among[(i, i)] += of_hinges[i]);
        let Some(flexibility) = among.try_inverse() else { return };
        let (mut by_hinge, mut by_disp) = ([[0.0; MOST]; SPACE], [[0.0; SPACE]; MOST]);
        for (h, hinge) in self.hinges.iter().enumerate() {
            for (i, k) in tangent.chunks_exact(n).enumerate() {
                by_hinge[i][h] = dot(k, &hinge.row);
                k.iter().zip(&mut by_disp[h]).for_each(|(k, out)| *out += hinge.row[i] * k);
            }
        }
        for (row, by_hinge) in tangent.chunks_exact_mut(n).zip(&by_hinge) {
            for (h, by_disp) in by_disp.iter().enumerate().take(self.hinges.len()) {
                let gives: f64 = (0..MOST).map(|g| by_hinge[g] * flexibility[(g, h)]).sum();
                row.iter_mut().zip(by_disp).for_each(|(k, d)| *k -= gives * d);
            }
        }
    }
}

/// Two axes normal to a chord: the one that lies, about which it bends in the vertical plane, and the other.
fn normal_to(chord: &Vector3<f64>) -> [Vector3<f64>; 2] {
    let lying = chord.cross(&Vector3::z());
    let first = if lying.norm() > 1e-6 { lying.normalize() } else { Vector3::x() };
    [first, chord.cross(&first)]
}

#[deny(clippy::missing_trait_methods)]
impl Element for Hinged {
    fn class(&self) -> &'static str {
        self.inner.class()
    }
    fn dofs(&self) -> usize {
        self.inner.dofs()
    }
    fn state_len(&self) -> usize {
        self.inner_len + self.hinges.len() * self.hinge_len
    }
    fn init(&self, state: &mut [f64]) {
        let (own, hinges) = state.split_at_mut(self.inner_len);
        self.inner.init(own);
        for words in hinges.chunks_exact_mut(self.hinge_len) {
            words[0] = 0.0;
            self.material.init(&mut words[1..]);
        }
    }
    fn traits(&self) -> ElementTraits {
        let inner = self.inner.traits();
        ElementTraits { linear: false, elapses: inner.elapses || self.material.depends_on_time(), ..inner }
    }

    fn respond(
        &self,
        motion: &ElementInput<'_>,
        committed: &[f64],
        trial: &mut [f64],
        mut answer: ElementOutput<'_>,
    ) -> Result<(), ElementError> {
        let n = self.dofs();
        let (old, kept) = committed.split_at(self.inner_len);
        let (new, next) = trial.split_at_mut(self.inner_len);
        let mut rotations = self.rotations(kept);
        let mut histories = Histories { old: kept, next, dt: motion.dt };
        let mut own = [0.0; SPACE * SPACE];
        for _ in 0..ROUNDS {
            answer.force.fill(0.0);
            if let Some(damping) = answer.damping.as_deref_mut() {
                damping.fill(0.0);
            }
            let tangent = &mut own[..n * n];
            tangent.fill(0.0);
            let disp = self.behind(motion.disp, &rotations);
            let asked = ElementOutput {
                force: &mut *answer.force,
                tangent: Some(&mut *tangent),
                damping: answer.damping.as_deref_mut(),
                part: MatrixMask::ALL,
            };
            self.inner.respond(&ElementInput { disp: &disp[..n], ..*motion }, old, new, asked)?;
            let mut moments = Each::zeros();
            moments.iter_mut().zip(&self.hinges).for_each(|(m, hinge)| *m = dot(&hinge.row, answer.force));
            let said = self.ask_all(&rotations, &mut histories)?;
            let size = moments.amax() + said.moment.amax();
            if (moments - said.moment).amax() <= 10.0 * self.close + SAME * size {
                if let Some(out) = answer.tangent {
                    self.condense(tangent, &said.tangent);
                    out.copy_from_slice(tangent);
                }
                return Ok(());
            }
            rotations = self.settle(&self.stiffness(tangent), &moments, &rotations, &mut histories)?;
        }
        Err(ElementError("its hinges find no equilibrium in this step".into()))
    }

    fn commit(&self, trial: &[f64], committed: &mut [f64]) {
        let (own, hinges) = committed.split_at_mut(self.inner_len);
        self.inner.commit(&trial[..self.inner_len], own);
        hinges.copy_from_slice(&trial[self.inner_len..]);
    }
    // An element that counts its calls is refused: there is no tangent of a last call.
    fn counts_calls(&self) -> bool {
        false
    }
    fn last_tangent(&self, _: &[f64], _: &mut [f64], _: MatrixMask) {}

    fn initial_tangent(&self, tangent: &mut [f64]) {
        self.inner.initial_tangent(tangent);
        self.condense(tangent, &Each::repeat(self.material.initial_tangent()));
    }
    fn initial_is_current(&self) -> bool {
        self.inner.initial_is_current()
    }
    fn mass(&self) -> Mass {
        self.inner.mass()
    }
    fn overload(&self, history: &[f64]) -> Option<Overload> {
        self.inner.overload(&history[..self.inner_len])
    }
    fn damps_in_forces_only(&self) -> bool {
        self.inner.damps_in_forces_only()
    }
    fn renews_damping(&self) -> bool {
        self.inner.renews_damping()
    }
    fn ground_inertia_slip(&self) -> Option<f64> {
        self.inner.ground_inertia_slip()
    }
    fn with_parameter(&self, words: &[&str], value: f64) -> Option<(Arc<dyn Element>, f64)> {
        let (inner, old) = self.inner.with_parameter(words, value)?;
        let new = Self { inner, ..self.clone() }.scaled().ok()?;
        Some((Arc::new(new), old))
    }
    fn basic_rows(&self) -> Vec<BasicRow> {
        self.inner.basic_rows()
    }
    fn load_len(&self) -> usize {
        self.inner.load_len()
    }
    fn add_load(&self, load: &ElementLoad, factor: f64, words: &mut [f64]) -> Result<(), ElementError> {
        self.inner.add_load(load, factor, words)
    }

    // The same paths as the element's own, so that recorders made before the hinges go on.
    fn probe(&self, words: &[&str]) -> Option<Probe> {
        match words {
            ["hingeRotation"] => Some(Probe::new(ROTATIONS, self.hinges.iter().map(|h| h.label.clone()))),
            words => self.inner.probe(words),
        }
    }
    // An element that counts its calls and is not linear is refused; a linear one is asked like any other.
    fn last_force(&self, _: &[f64], _: &[f64], _: &mut [f64]) {}
    fn probe_names(&self) -> &'static [&'static str] {
        self.inner.probe_names()
    }
    fn force_labels(&self) -> Vec<String> {
        self.inner.force_labels()
    }
    fn read(&self, path: &[u32], s: &Snapshot<'_>, out: &mut [f64]) {
        let (state, turned) = s.state.split_at(self.inner_len);
        let rotations = self.rotations(turned);
        if path == [ROTATIONS] {
            return out.copy_from_slice(&rotations.as_slice()[..out.len()]);
        }
        let disp = self.behind(s.disp, &rotations);
        self.inner.read(path, &Snapshot { state, disp: &disp[..s.disp.len()], ..*s }, out);
    }
}
