//! Force-based beams whose deflections follow their curvatures: `forceBeamColumnCBDI` and `forceBeamColumnCSBDI`.

mod opensees;

use super::force_based::{ForceBased, INTERNAL, POLISH, REACTIONS, ROUND_OFF, of_load, row};
use super::member::{Basic, Formulation, Member};
use crate::element::load::ElementLoad;
use crate::element::transform::Reactions;
use crate::element::{ElementError, ElementInput};
use crate::material::MaterialError;
use crate::numeric::{axpy, dot, eliminate, invert};
use crate::rules::{Consistent, OpenSees};
use crate::section::Resultant;
use std::fmt;
use std::marker::PhantomData;

/// Largest number of deformations of all sections of a beam together.
pub const MAX_DEFORMATIONS: usize = 64;
/// Columns of the equations inside the element: deformations, what is missing, and a column for each basic force.
const COLUMNS: usize = MAX_DEFORMATIONS + 7;

/// Internal forces are in equilibrium with the basic forces on the deflected beam, so that one element has the P-δ of its
/// chord. Deflections are the double integral of the polynomial through the curvatures of the sections (curvature-based displacement
/// interpolation, Neuenhofer and Filippou, 1998), with shear also the integral of the shear strains (De Souza, 2000).
///
/// With the deflection w between the chord and the beam, positive as the curvature κ = w'' makes it, a section carries
/// N = q₀, M = q₀ w + (x - 1) q₁ + x q₂ and V = -q₀ w' - (q₁ + q₂)/L; the basic deformations are
/// v₀ = ∫ ε + ½ w κ - ½ w' γ, v₁ = ∫ (x - 1) κ - γ/L, v₂ = ∫ x κ - γ/L (in space likewise for bending in the other plane).
#[derive(Clone, Debug)]
pub struct CurvatureBased<R = Consistent> {
    iteration: ForceBased,
    /// n x n, by rows: deflections (over L²) of curvatures.
    deflection: Vec<f64>,
    /// With shear: deflections (over L) of shear strains, slopes (over L) of curvatures, slopes of shear strains.
    shear: Option<[Vec<f64>; 3]>,
    /// Element loads bend the sections between the ends: not in OpenSees' element in the plane.
    loads_inside: bool,
    rules: PhantomData<R>,
}

/// Rules of [`CurvatureBased`] that differ in OpenSees.
pub trait Rules: Clone + fmt::Debug + Send + Sync + 'static {
    /// The derivative of the axial force is part of the tangent of the P-Delta moments.
    const WHOLE_TANGENT: bool = true;

    /// Integrals that slopes of shear strains are measured from: values at the first end, or integrals up to the other end.
    fn datum<'a>(_start: &'a [f64], mean: &'a [f64]) -> &'a [f64] {
        mean
    }

    /// Element loads bend the sections of a beam.
    fn loads_inside(_plane: bool) -> bool {
        true
    }

    /// Basic forces that are tried before those from the committed state.
    ///
    /// # Errors
    /// A section without a force.
    fn first<const N: usize, const B: usize>(
        _beam: &CurvatureBased<Self>,
        _member: &Member<N, B>,
        _v: &[f64; B],
        _motion: &ElementInput<'_>,
        _committed: &[f64],
        _trial: &mut [f64],
    ) -> Result<Option<Basic<B>>, MaterialError> {
        Ok(None)
    }
}

impl Rules for Consistent {}

/// Legendre's polynomials of 2x - 1 up to degree `n`, and their first and second integrals from 0.
fn polynomials(x: f64, n: usize) -> [Vec<f64>; 3] {
    let t = 2.0 * x - 1.0;
    let mut p = vec![1.0, t];
    for k in 1..n + 2 {
        let k1 = k as f64;
        p.push(((2.0 * k1 + 1.0) * t * p[k] - k1 * p[k - 1]) / (k1 + 1.0));
    }
    let integral = |of: &[f64], first: f64| -> Vec<f64> {
        let rest = (1..of.len() - 1).map(|k| 0.5 * (of[k + 1] - of[k - 1]) / (2 * k + 1) as f64);
        std::iter::once(first).chain(rest).collect()
    };
    let once = integral(&p, x);
    let twice = integral(&once, 0.5 * x * x);
    [p, once, twice]
}

impl CurvatureBased {
    /// For sections at these places (fractions of the length, each its own); with the deflections of shear strains, if they are
    /// wanted. `None` where two places are the same.
    pub fn new(iteration: ForceBased, places: &[f64], shear: bool) -> Option<Self> {
        Self::of(iteration, places, shear, false)
    }
}

impl CurvatureBased<OpenSees> {
    /// The same by the rules of OpenSees, in the plane or in space.
    pub fn as_opensees(iteration: ForceBased, places: &[f64], shear: bool, plane: bool) -> Option<Self> {
        Self::of(iteration, places, shear, plane)
    }
}

impl<R: Rules> CurvatureBased<R> {
    fn of(iteration: ForceBased, places: &[f64], shear: bool, plane: bool) -> Option<Self> {
        let n = places.len();
        let at: Vec<_> = places.iter().map(|x| polynomials(*x, n)).collect();
        let (start, end) = (polynomials(0.0, n), polynomials(1.0, n));
        // Values of the polynomials at the places, whose inverse gives coefficients.
        let mut values = vec![[0.0; COLUMNS]; n];
        for (row, p) in values.iter_mut().zip(&at) {
            row[..n].copy_from_slice(&p[0][..n]);
        }
        for (i, row) in values.iter_mut().enumerate() {
            row[n + i] = 1.0;
        }
        if n + n > COLUMNS || !eliminate(&mut values, n, 2 * n) {
            return None;
        }
        let influence = |of: &dyn Fn(usize, usize) -> f64| -> Vec<f64> {
            let entry = |i: usize, j: usize| (0..n).map(|k| of(i, k) * values[k][n + j]).sum::<f64>();
            (0..n * n).map(|ij| entry(ij / n, ij % n)).collect()
        };
        let deflection = influence(&|i, k| at[i][2][k] - places[i] * end[2][k]);
        let datum = R::datum(&start[0], &end[1]);
        let shear = shear.then(|| {
            [
                influence(&|i, k| at[i][1][k] - places[i] * end[1][k]),
                influence(&|i, k| at[i][1][k] - end[2][k]),
                influence(&|i, k| at[i][0][k] - datum[k]),
            ]
        });
        Some(Self { iteration, deflection, shear, loads_inside: R::loads_inside(plane), rules: PhantomData })
    }

    /// What a unit of a deformation of section `j` adds to the factor of q₀ in a resultant of section `i` of `n`.
    fn influence(&self, n: usize, (i, r): (usize, Resultant), (j, e): (usize, Resultant), length: f64) -> f64 {
        use Resultant::{My, Mz, Vy, Vz};
        let at = i * n + j;
        match (r, e, &self.shear) {
            (Mz, Mz, _) | (My, My, _) => length * length * self.deflection[at],
            (Mz, Vy, Some(s)) | (My, Vz, Some(s)) => length * s[0][at],
            (Vy, Mz, Some(s)) | (Vz, My, Some(s)) => -length * s[1][at],
            (Vy, Vy, Some(s)) | (Vz, Vz, Some(s)) => -s[2][at],
            _ => 0.0,
        }
    }
}

/// A resultant at `x` of the straight beam from the basic forces: shear works with the slope of the deflection.
fn straight_row<const B: usize>(resultant: Resultant, x: f64, length: f64) -> [f64; B] {
    let row = row(resultant, x, length);
    row.map(|r| sense(resultant) * r)
}

/// Shear has the other sign than in the force-based beam without deflections.
fn sense(resultant: Resultant) -> f64 {
    if matches!(resultant, Resultant::Vy | Resultant::Vz) { -1.0 } else { 1.0 }
}

type Deformations = [f64; MAX_DEFORMATIONS];

/// The sections of a beam with their deformations one after the other.
struct Sections<const B: usize> {
    /// Number of deformations.
    size: usize,
    /// Resultant, section, and what the section counts, of each.
    of: [(Resultant, usize, f64); MAX_DEFORMATIONS],
    /// Deformations, and the factors of q₀ in the resultants.
    e: Deformations,
    d: Deformations,
    rows: [[f64; B]; MAX_DEFORMATIONS],
}

impl<const B: usize> Sections<B> {
    /// With the deformations that are in a state, or with others.
    fn new<const N: usize, R: Rules>(
        beam: &CurvatureBased<R>,
        member: &Member<N, B>,
        state: &[f64],
        others: Option<&Deformations>,
    ) -> Self {
        let mut s = Self {
            size: 0,
            of: [(Resultant::P, 0, 0.0); MAX_DEFORMATIONS],
            e: [0.0; MAX_DEFORMATIONS],
            d: [0.0; MAX_DEFORMATIONS],
            rows: [[0.0; B]; MAX_DEFORMATIONS],
        };
        let length = member.length();
        for (i, (section, x, weight)) in member.along().enumerate() {
            for (r, e) in section.resultants().iter().zip(section.deformation(state)) {
                s.of[s.size] = (*r, i, weight);
                s.e[s.size] = others.map_or(*e, |others| others[s.size]);
                s.rows[s.size] = straight_row(*r, x, length);
                s.size += 1;
            }
        }
        for a in 0..s.size {
            s.d[a] = (0..s.size).map(|b| s.influence(beam, member, a, b) * s.e[b]).sum();
        }
        s
    }

    fn influence<const N: usize, R: Rules>(
        &self,
        beam: &CurvatureBased<R>,
        member: &Member<N, B>,
        a: usize,
        b: usize,
    ) -> f64 {
        let ((r, i, _), (e, j, _)) = (self.of[a], self.of[b]);
        beam.influence(member.sections.len(), (i, r), (j, e), member.length())
    }

    /// Basic deformations.
    fn gathered(&self) -> [f64; B] {
        let mut v = [0.0; B];
        for a in 0..self.size {
            let weight = self.of[a].2;
            axpy(weight * self.e[a], &self.rows[a], &mut v);
            v[0] += 0.5 * weight * self.e[a] * self.d[a];
        }
        v
    }
}

/// What equilibrium of all sections says about a change of their deformations, for basic forces that are given.
struct Linear<const B: usize> {
    /// Change of the deformations.
    change: Deformations,
    /// What a unit of each basic force would add to it.
    per_force: [[f64; B]; MAX_DEFORMATIONS],
    /// Forces that are missing.
    missing: Deformations,
    /// Flexibility of the basic system, and the change of the basic deformations.
    f: [[f64; B]; B],
    v: [f64; B],
}

/// Resultants of all sections in a state, one after the other.
fn carried<const N: usize, const B: usize>(member: &Member<N, B>, state: &[f64]) -> Deformations {
    let mut all = [0.0; MAX_DEFORMATIONS];
    let mut at = 0;
    for (section, ..) in member.along() {
        let s = section.resultant(state);
        all[at..at + s.len()].copy_from_slice(s);
        at += s.len();
    }
    all
}

impl<R: Rules> CurvatureBased<R> {
    /// Resultants that are in equilibrium with the basic forces.
    fn balanced<const B: usize>(&self, s: &Sections<B>, q: &[f64; B], load: &[f64]) -> Deformations {
        let mut balanced = [0.0; MAX_DEFORMATIONS];
        for (row, out) in balanced[..s.size].iter_mut().enumerate() {
            let (r, i, _) = s.of[row];
            let internal = &load[REACTIONS + i * INTERNAL..REACTIONS + (i + 1) * INTERNAL];
            let inside = if self.loads_inside { sense(r) * of_load(r, internal) } else { 0.0 };
            *out = dot(&s.rows[row], q) + q[0] * s.d[row] + inside;
        }
        balanced
    }

    /// Linearise equilibrium of sections that carry `carried` with the stiffnesses in a state. `None` where they have no
    /// stiffness left.
    fn linear<const N: usize, const B: usize>(
        &self,
        member: &Member<N, B>,
        s: &Sections<B>,
        (q, load): (&[f64; B], &[f64]),
        carried: &Deformations,
        trial: &[f64],
    ) -> Option<Linear<B>> {
        let m = s.size;
        let mut a = [[0.0; COLUMNS]; MAX_DEFORMATIONS];
        let mut missing = self.balanced(s, q, load);
        missing.iter_mut().zip(carried).for_each(|(x, s)| *x -= s);
        // Work of v₀ that changes with the deformations: what they do to the deflections counts too.
        let mut work = [0.0; MAX_DEFORMATIONS];
        let mut at = 0;
        for (section, ..) in member.along() {
            let n = section.resultants().len();
            for k in 0..n {
                let row = at + k;
                for b in 0..m {
                    let influence = s.influence(self, member, row, b);
                    a[row][b] = -q[0] * influence;
                    work[b] += 0.5 * s.of[row].2 * influence * s.e[row];
                }
                work[row] += 0.5 * s.of[row].2 * s.d[row];
                a[row][at..at + n].iter_mut().zip(&section.stiffness(trial)[k * n..]).for_each(|(a, k)| *a += k);
                a[row][m] = missing[row];
                a[row][m + 1..m + 1 + B].copy_from_slice(&s.rows[row]);
                a[row][m + 1] += s.d[row];
            }
            at += n;
        }
        if !eliminate(&mut a, m, m + 1 + B) {
            return None;
        }
        let mut l = Linear {
            change: [0.0; MAX_DEFORMATIONS],
            per_force: [[0.0; B]; MAX_DEFORMATIONS],
            missing,
            f: [[0.0; B]; B],
            v: [0.0; B],
        };
        for b in 0..m {
            l.change[b] = a[b][m];
            l.per_force[b].copy_from_slice(&a[b][m + 1..m + 1 + B]);
            let mut c = s.rows[b].map(|x| s.of[b].2 * x);
            c[0] += work[b];
            axpy(l.change[b], &c, &mut l.v);
            l.f.iter_mut().zip(&c).for_each(|(row, c)| axpy(*c, &l.per_force[b], row));
        }
        Some(l)
    }

    /// Give the sections deformations.
    fn update<const N: usize, const B: usize>(
        member: &Member<N, B>,
        e: &Deformations,
        dt: f64,
        committed: &[f64],
        trial: &mut [f64],
    ) -> Result<(), MaterialError> {
        let mut at = 0;
        for (section, ..) in member.along() {
            section.update(committed, &e[at..], dt, trial)?;
            at += section.resultants().len();
        }
        Ok(())
    }

    /// Find the basic forces for deformations that come in so many parts, from the committed state on, by Newton's method for
    /// all sections and the basic forces at once. `None` if they are not found.
    fn attempt<const N: usize, const B: usize>(
        &self,
        member: &Member<N, B>,
        v: &[f64; B],
        motion: &ElementInput<'_>,
        (committed, trial): (&[f64], &mut [f64]),
        parts: usize,
    ) -> Result<Option<Basic<B>>, MaterialError> {
        let body = member.body();
        trial[body..].copy_from_slice(&committed[body..]);
        let mut basic = Basic::read(&committed[member.head()..]);
        let start = Sections::new(self, member, committed, None).gathered();
        for part in 1..=parts {
            let share = part as f64 / parts as f64;
            let (mut iteration, mut polished) = (0, 0);
            loop {
                let s = Sections::new(self, member, trial, None);
                let loading = (&basic.q, motion.load);
                let Some(mut l) = self.linear(member, &s, loading, &carried(member, trial), trial) else {
                    return Ok(None);
                };
                if !invert(l.f.as_flattened_mut(), B) {
                    return Ok(None);
                }
                let gathered = s.gathered();
                let gap: [f64; B] = std::array::from_fn(|i| start[i] + share * (v[i] - start[i]) - gathered[i]);
                let left: [f64; B] = std::array::from_fn(|i| gap[i] - l.v[i]);
                let step = l.f.map(|row| dot(&row, &left));
                axpy(1.0, &step, &mut basic.q);
                basic.k = l.f;
                let (mut e, mut energy) = (s.e, dot(&step, &gap).abs());
                for (b, e) in e[..s.size].iter_mut().enumerate() {
                    let change = l.change[b] + dot(&step, &l.per_force[b]);
                    *e += change;
                    energy += (s.of[b].2 * change * l.missing[b]).abs();
                }
                let enough = energy <= self.iteration.tolerance;
                polished += usize::from(enough);
                let last = iteration == self.iteration.max_iterations;
                if enough && (energy <= ROUND_OFF * dot(&basic.q, v).abs() || polished > POLISH || last) {
                    break;
                }
                if last || !energy.is_finite() {
                    return Ok(None);
                }
                iteration += 1;
                Self::update(member, &e, motion.dt, committed, trial)?;
            }
        }
        Ok(Some(basic))
    }
}

impl<const N: usize, const B: usize, R: Rules> Formulation<N, B> for CurvatureBased<R> {
    const CLASS: [&'static str; 2] = ["ForceBeamColumnCBDI2d", "ForceBeamColumnCBDI3d"];
    const SYMMETRIC: bool = false;
    const DEFLECTS: bool = true;
    /// Basic deformations of the last trial state.
    const WORDS: usize = B;

    fn whole_tangent(&self) -> bool {
        R::WHOLE_TANGENT
    }

    fn load_len(points: usize) -> usize {
        <ForceBased as Formulation<N, B>>::load_len(points)
    }

    fn add_load(member: &Member<N, B>, load: &ElementLoad, factor: f64, words: &mut [f64]) {
        <ForceBased as Formulation<N, B>>::add_load(member, load, factor, words);
    }

    fn reactions(load: &[f64]) -> Reactions {
        <ForceBased as Formulation<N, B>>::reactions(load)
    }

    fn respond(
        &self,
        member: &Member<N, B>,
        v: &[f64; B],
        motion: &ElementInput<'_>,
        committed: &[f64],
        trial: &mut [f64],
    ) -> Result<Basic<B>, ElementError> {
        let mut failure = None;
        for parts in [0, 1, 10, 100] {
            let found = match parts {
                0 => R::first(self, member, v, motion, committed, trial),
                parts => self.attempt(member, v, motion, (committed, trial), parts),
            };
            match found {
                Ok(Some(basic)) if basic.q.iter().all(|q| q.is_finite()) => {
                    let last = member.own_words();
                    trial[last..last + B].copy_from_slice(v);
                    return Ok(basic);
                }
                Ok(_) => {}
                Err(e) => failure = Some(e),
            }
        }
        let message = "the deformations of the sections do not come to add up to those of the deflected beam";
        Err(failure.map_or(ElementError(message.into()), ElementError::from))
    }

    fn initial_stiffness(member: &Member<N, B>) -> [[f64; B]; B] {
        <ForceBased as Formulation<N, B>>::initial_stiffness(member)
    }

    fn elastic_deformation(member: &Member<N, B>, q: &[f64; B], load: &[f64]) -> [f64; B] {
        <ForceBased as Formulation<N, B>>::elastic_deformation(member, q, load)
    }
}
