//! A beam with plastic hinges at its ends.

use crate::element::{
    Answer, Element, ElementError, ElementLoad, MAX_DOFS, Mass, Motion, Nature, Overload, Part, Snapshot, dot,
};
use crate::probe::Probe;
use nalgebra::{Matrix4, SVector, Vector3};
use std::sync::Arc;

/// A beam whose ends turn against its nodes where their moments go beyond a yield moment: the one-component model of Giberson
/// (Journal of the Structural Division ASCE 95 (1969) 137), with kinematic hardening.
///
/// Each end has a hinge about each axis normal to the chord at rest. With its rotation θ, the beam is asked at the rotation of the node
/// less θ, and answers with the moment m, for which |m - b k θ| ≤ M_y; k is the stiffness of the beam at rest against that rotation.
/// The hinges are settled within the element, and their rotations condensed from its tangent: the equations of the model are not more
/// than without them, and the hinges are rigid until they yield.
#[derive(Clone, Debug)]
pub struct Hinged {
    inner: Arc<dyn Element>,
    /// Yield moment M_y.
    moment: f64,
    hinges: Vec<Hinge>,
    /// Words of the element's own history.
    inner_len: usize,
}

#[derive(Clone, Debug)]
struct Hinge {
    /// Unit rotation of the node about its axis, over all degrees of freedom.
    row: Vec<f64>,
    /// b k.
    hardening: f64,
    /// Name of its rotation.
    label: String,
}

/// Hinges at most: about two axes at both ends.
const MOST: usize = 4;
/// Part of the yield moment to which the hinges are settled.
const CLOSE: f64 = 1e-12;
/// Rounds in which the moments of a beam are followed that is not linear, and sweeps over its hinges in one.
const ROUNDS: usize = 30;
const SWEEPS: usize = 200;
/// Path of the rotations: the element's own begin with small numbers.
const ROTATIONS: u32 = u32::MAX;

/// A number for each hinge.
type Each = SVector<f64, MOST>;

impl Hinged {
    /// With hinges at some of the ends (0 for node i, 1 for node j) of a beam along a chord.
    ///
    /// # Errors
    /// An element that is no beam: without rotations at two nodes.
    pub fn new(
        inner: Arc<dyn Element>,
        chord: Vector3<f64>,
        ends: &[usize],
        moment: f64,
        hardening: f64,
    ) -> Result<Self, ElementError> {
        let n = inner.dofs();
        let axes = match n {
            6 => vec![Vector3::z()],
            12 if chord.norm() > 0.0 => normal_to(&chord.normalize()).to_vec(),
            _ => return Err(ElementError(format!("{} is no beam: it has no ends to turn", inner.class()).into())),
        };
        let mut stiffness = vec![0.0; n * n];
        inner.initial_tangent(&mut stiffness);
        let hinge = |end: usize, axis: (usize, &Vector3<f64>)| {
            let mut row = vec![0.0; n];
            let own = n / 2 * (end + 1);
            match n {
                6 => row[own - 1] = 1.0,
                _ => row[own - 3..own].copy_from_slice(axis.1.as_slice()),
            }
            let along: f64 = stiffness.chunks_exact(n).zip(&row).map(|(k, a)| a * dot(k, &row)).sum();
            Hinge { hardening: hardening * along, label: format!("theta{}_{}", axis.0 + 1, end + 1), row }
        };
        let hinges = ends.iter().flat_map(|end| axes.iter().enumerate().map(move |a| hinge(*end, a))).collect();
        Ok(Self { moment, hinges, inner_len: inner.state_len(), inner })
    }

    /// Displacements behind the hinges.
    fn behind(&self, disp: &[f64], rotations: &Each) -> [f64; MAX_DOFS] {
        let mut out = [0.0; MAX_DOFS];
        out[..disp.len()].copy_from_slice(disp);
        for (hinge, by) in self.hinges.iter().zip(rotations) {
            out.iter_mut().zip(&hinge.row).for_each(|(d, a)| *d -= by * a);
        }
        out
    }

    fn rotations(&self, words: &[f64]) -> Each {
        Each::from_iterator(words.iter().copied().chain(std::iter::repeat(0.0)).take(MOST))
    }

    /// Stiffness of the beam against the rotations of its hinges, with their hardening; 1 on the diagonal of those that are not there.
    fn stiffness(&self, tangent: &[f64]) -> Matrix4<f64> {
        let n = self.inner.dofs();
        let mut out = Matrix4::identity();
        for (i, a) in self.hinges.iter().enumerate() {
            for (j, b) in self.hinges.iter().enumerate() {
                out[(i, j)] = tangent.chunks_exact(n).zip(&a.row).map(|(k, a)| a * dot(k, &b.row)).sum();
            }
            out[(i, i)] += a.hardening;
        }
        out
    }

    /// Rotations under which no hinge carries more than it can, from committed ones; `over` are the moments less what hardening carries
    /// at the rotations `from`, by the stiffness `k`. Hinge after hinge until nothing moves (Gauss and Seidel: the stiffness is
    /// positive definite).
    fn settle(&self, k: &Matrix4<f64>, over: &Each, from: &Each, committed: &Each) -> Each {
        let mut now = *from;
        for _ in 0..SWEEPS {
            let mut moved: f64 = 0.0;
            for i in 0..self.hinges.len() {
                if k[(i, i)] <= 0.0 {
                    continue;
                }
                let others = (k.row(i) * (now - from))[0] - k[(i, i)] * (now[i] - from[i]);
                let stuck = over[i] - others - k[(i, i)] * (committed[i] - from[i]);
                let flow = stuck.signum() * (stuck.abs() - self.moment).max(0.0) / k[(i, i)];
                let next = committed[i] + flow;
                moved = moved.max(k[(i, i)] * (next - now[i]).abs());
                now[i] = next;
            }
            if moved <= CLOSE * self.moment {
                break;
            }
        }
        now
    }

    /// Take from the tangent what the hinges that turn give way.
    fn condense(&self, tangent: &mut [f64], turns: [bool; MOST]) {
        let n = self.inner.dofs();
        let mut among = self.stiffness(tangent);
        for i in (0..MOST).filter(|i| !turns[*i]) {
            among.row_mut(i).fill(0.0);
            among.column_mut(i).fill(0.0);
            among[(i, i)] = 1.0;
        }
        let Some(flexibility) = among.try_inverse() else { return };
        let (mut by_hinge, mut by_disp) = ([[0.0; MOST]; MAX_DOFS], [[0.0; MAX_DOFS]; MOST]);
        for (h, hinge) in self.hinges.iter().enumerate().filter(|(h, _)| turns[*h]) {
            for (i, k) in tangent.chunks_exact(n).enumerate() {
                by_hinge[i][h] = dot(k, &hinge.row);
                k.iter().zip(&mut by_disp[h]).for_each(|(k, out)| *out += hinge.row[i] * k);
            }
        }
        for (row, by_hinge) in tangent.chunks_exact_mut(n).zip(&by_hinge) {
            for h in 0..MOST {
                let gives: f64 = (0..MOST).map(|g| by_hinge[g] * flexibility[(g, h)]).sum();
                row.iter_mut().zip(&by_disp[h]).for_each(|(k, d)| *k -= gives * d);
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

impl Element for Hinged {
    fn class(&self) -> &'static str {
        self.inner.class()
    }
    fn dofs(&self) -> usize {
        self.inner.dofs()
    }
    fn state_len(&self) -> usize {
        self.inner_len + self.hinges.len()
    }
    fn init(&self, state: &mut [f64]) {
        self.inner.init(&mut state[..self.inner_len]);
        state[self.inner_len..].fill(0.0);
    }
    fn nature(&self) -> Nature {
        Nature { linear: false, ..self.inner.nature() }
    }

    fn respond(
        &self,
        motion: &Motion<'_>,
        committed: &[f64],
        trial: &mut [f64],
        mut answer: Answer<'_>,
    ) -> Result<(), ElementError> {
        let n = self.dofs();
        let (old, kept) = committed.split_at(self.inner_len);
        let (new, next) = trial.split_at_mut(self.inner_len);
        let committed = self.rotations(kept);
        let mut rotations = committed;
        let mut own = [0.0; MAX_DOFS * MAX_DOFS];
        for _ in 0..ROUNDS {
            answer.force.fill(0.0);
            if let Some(damping) = answer.damping.as_deref_mut() {
                damping.fill(0.0);
            }
            let tangent = &mut own[..n * n];
            tangent.fill(0.0);
            let disp = self.behind(motion.disp, &rotations);
            let asked = Answer {
                force: &mut *answer.force,
                tangent: Some(&mut *tangent),
                damping: answer.damping.as_deref_mut(),
                part: Part::ALL,
            };
            self.inner.respond(&Motion { disp: &disp[..n], ..*motion }, old, new, asked)?;
            let over = |(hinge, turned): (&Hinge, &f64)| dot(&hinge.row, answer.force) - hinge.hardening * turned;
            let over = Each::from_iterator(
                self.hinges.iter().zip(&rotations).map(over).chain(std::iter::repeat(0.0)).take(MOST),
            );
            let k = self.stiffness(tangent);
            let settled = self.settle(&k, &over, &rotations, &committed);
            // Ten times what the sweeps leave of it.
            if (0..MOST).all(|i| (settled[i] - rotations[i]).abs() * k[(i, i)].abs() <= 10.0 * CLOSE * self.moment) {
                next.copy_from_slice(&rotations.as_slice()[..self.hinges.len()]);
                if let Some(out) = answer.tangent {
                    let turns = std::array::from_fn(|i| rotations[i] != committed[i]);
                    self.condense(tangent, turns);
                    out.copy_from_slice(tangent);
                }
                return Ok(());
            }
            rotations = settled;
        }
        Err(ElementError("its hinges find no equilibrium".into()))
    }

    fn initial_tangent(&self, tangent: &mut [f64]) {
        self.inner.initial_tangent(tangent);
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
    fn load_len(&self) -> usize {
        self.inner.load_len()
    }
    fn add_load(&self, load: &ElementLoad, factor: f64, words: &mut [f64]) -> Result<(), ElementError> {
        self.inner.add_load(load, factor, words)
    }

    // The same paths as the element's own, so that recorders made before the hinges go on.
    fn probe(&self, words: &[&str]) -> Option<Probe> {
        match words {
            ["plasticRotation"] => Some(Probe::new(ROTATIONS, self.hinges.iter().map(|h| h.label.clone()))),
            words => self.inner.probe(words),
        }
    }
    fn probe_names(&self) -> &'static [&'static str] {
        self.inner.probe_names()
    }
    fn force_labels(&self) -> Vec<String> {
        self.inner.force_labels()
    }
    fn read(&self, path: &[u32], s: &Snapshot<'_>, out: &mut [f64]) {
        let (state, turned) = s.state.split_at(self.inner_len);
        if path == [ROTATIONS] {
            return out.copy_from_slice(turned);
        }
        let disp = self.behind(s.disp, &self.rotations(turned));
        self.inner.read(path, &Snapshot { state, disp: &disp[..s.disp.len()], ..*s }, out);
    }
}
