//! Force-based beams with curvature-based deflections: `forceBeamColumnCBDI` and `forceBeamColumnCSBDI`.

mod opensees;

use super::basic::Basic;
use super::curvature_interpolation::{CurvatureInterpolation, polynomials};
use super::force_based::{ACCURATE, ForceBased, INTERNAL, MAX_EXTRA_ITERATIONS, REACTIONS, of_load, row};
use super::member::{Formulation, Lacking, Member, Trace};
use super::point::SUPPORT;
use super::shortfall::{Miss, Shortfall};
use crate::element::{Class, ElementInput, ElementResult, Histories};
use crate::material::MaterialError;
use crate::numeric::{axpy, dot, eliminate, invert};
use crate::rules::{Consistent, OpenSees};
use crate::section::{MAX_ORDER, Resultant};
use std::fmt;
use std::marker::PhantomData;

/// Largest total number of section deformations of a beam.
pub const MAX_DEFORMATIONS: usize = 64;
/// Columns of the internal equations: section deformations, residuals, and one for each basic force.
const COLUMNS: usize = MAX_DEFORMATIONS + 7;

/// A force-based beam with equilibrium in the deflected configuration, so that one element has the P-δ effect of its
/// chord. Deflections are the double integral of the polynomial through the section curvatures (curvature-based
/// displacement interpolation, Neuenhofer and Filippou, 1998). With shear, they include the integral of the shear
/// strains (De Souza, 2000).
///
/// The deflection w from the chord to the beam has the sign of the curvature κ = w''. Section forces are N = q₀, M = q₀
/// w + (x - 1) q₁ + x q₂ and V = -q₀ w' - (q₁ + q₂)/L. Basic deformations are v₀ = ∫ ε + ½ w κ - ½ w' γ, v₁ = ∫ (x - 1)
/// κ - γ/L and v₂ = ∫ x κ - γ/L. In space the same holds for bending in the other plane.
#[derive(Clone, Debug)]
pub struct CurvatureBased<R = Consistent> {
    iteration: ForceBased,
    /// Deflections (over L²) per curvature, n x n by rows.
    deflection: Vec<f64>,
    /// With shear, n x n each: deflections (over L) per shear strain, slopes (over L) per curvature, slopes per shear
    /// strain.
    shear: Option<[Vec<f64>; 3]>,
    /// Element loads act on the sections; in OpenSees' plane element they do not.
    loads_inside: bool,
    rules: PhantomData<R>,
}

/// Rules of [`CurvatureBased`] that differ in OpenSees.
pub trait Rules: Clone + fmt::Debug + Send + Sync + 'static {
    /// The tangent of the P-Delta moments includes the derivative of the axial force.
    const WHOLE_TANGENT: bool = true;
    /// The state determination starts from the last trial state, so that its result depends on the number of calls.
    const CALL_DEPENDENT: bool = false;

    /// Reference of the slopes from shear strains: the polynomials at the first end, or their means over the length.
    fn datum<'a>(_start: &'a [f64], mean: &'a [f64]) -> &'a [f64] {
        mean
    }

    /// Returns true if element loads act on the sections.
    fn loads_inside(_plane: bool) -> bool {
        true
    }

    /// Basic forces of an attempt from the last trial state, before the iterations from the committed state.
    ///
    /// # Errors
    /// A section without a force at its deformation.
    fn first<const N: usize, const B: usize>(
        _beam: &CurvatureBased<Self>,
        _member: &Member<N, B>,
        _trace: &Trace<N, B>,
        _motion: &ElementInput<'_>,
        _h: &mut Histories<'_>,
    ) -> Result<Option<Basic<B>>, MaterialError> {
        Ok(None)
    }
}

impl Rules for Consistent {}

impl CurvatureBased {
    /// Makes the formulation for sections at distinct `places` (fractions of the length); `shear` adds the deflections
    /// from shear strains. `None` if two places coincide.
    pub fn new(iteration: ForceBased, places: &[f64], shear: bool) -> Option<Self> {
        Self::of(iteration, places, shear, false)
    }
}

impl CurvatureBased<OpenSees> {
    /// As `new`, by the rules of OpenSees, in the plane or in space.
    pub fn as_opensees(iteration: ForceBased, places: &[f64], shear: bool, plane: bool) -> Option<Self> {
        Self::of(iteration, places, shear, plane)
    }
}

impl<R: Rules> CurvatureBased<R> {
    fn of(iteration: ForceBased, places: &[f64], shear: bool, plane: bool) -> Option<Self> {
        let n = places.len();
        let at: Vec<_> = places.iter().map(|x| polynomials(*x, n)).collect();
        let interpolation = CurvatureInterpolation::new(places)?;
        let [start, end] = &interpolation.ends;
        let influence = |of: &dyn Fn(usize, usize) -> f64| -> Vec<f64> {
            (0..n).flat_map(|i| interpolation.influence(|k| of(i, k))).collect()
        };
        let deflection = places.iter().flat_map(|x| interpolation.deflection(*x)).collect();
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

    /// Derivative of the factor of q₀ in a resultant of section `i` of `n` by a deformation of section `j`.
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

/// A resultant at `x` of the straight beam from the basic forces. Shear is conjugate to the slope of the deflection.
fn straight_row<const B: usize>(resultant: Resultant, x: f64, length: f64) -> [f64; B] {
    let row = row(resultant, x, length);
    row.map(|r| sense(resultant) * r)
}

/// Sign of a resultant; that of shear is opposite to the force-based beam without deflections.
fn sense(resultant: Resultant) -> f64 {
    if matches!(resultant, Resultant::Vy | Resultant::Vz) { -1.0 } else { 1.0 }
}

type Deformations = [f64; MAX_DEFORMATIONS];

/// Deformations of all sections of a beam, in one vector.
struct Sections<const B: usize> {
    /// Number of deformations.
    size: usize,
    /// Resultant, section and weight of each deformation.
    of: [(Resultant, usize, f64); MAX_DEFORMATIONS],
    /// Deformations, and factors of q₀ in the resultants.
    e: Deformations,
    d: Deformations,
    rows: [[f64; B]; MAX_DEFORMATIONS],
}

impl<const B: usize> Sections<B> {
    /// Reads the deformations from a state, or takes `others`.
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

    /// Basic deformations from the section deformations.
    fn basic_deformations(&self) -> [f64; B] {
        let mut v = [0.0; B];
        for a in 0..self.size {
            let weight = self.of[a].2;
            axpy(weight * self.e[a], &self.rows[a], &mut v);
            v[0] += 0.5 * weight * self.e[a] * self.d[a];
        }
        v
    }
}

/// Linearised equilibrium of all sections at given basic forces.
struct Linear<const B: usize> {
    /// Change of the deformations.
    change: Deformations,
    /// Derivative of the change by each basic force.
    per_force: [[f64; B]; MAX_DEFORMATIONS],
    /// Residual resultants, and those of the sections.
    residual: Deformations,
    carried: Deformations,
    /// Flexibility of the basic system, and change of the basic deformations.
    f: [[f64; B]; B],
    v: [f64; B],
}

impl<const B: usize> Linear<B> {
    /// The section with the largest work of its imbalance, if that is more than `energy`.
    fn unbalanced(&self, s: &Sections<B>, energy: f64) -> Option<Shortfall> {
        let work = |a: usize| (s.of[a].2 * self.change[a] * self.residual[a]).abs();
        let worst = (0..s.size).max_by(|a, b| work(*a).total_cmp(&work(*b)))?;
        let (section, carried) = (s.of[worst].1, self.carried[worst]);
        let resultant = (0..worst).filter(|a| s.of[*a].1 == section).count();
        (work(worst) > energy).then(|| Shortfall::of(section, resultant, carried, carried + self.residual[worst]))
    }
}

/// Resultants of all sections in a state, in one vector.
fn resultants<const N: usize, const B: usize>(member: &Member<N, B>, state: &[f64]) -> Deformations {
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
    /// Resultants in equilibrium with the basic forces.
    fn equilibrium_resultants<const B: usize>(&self, s: &Sections<B>, q: &[f64; B], load: &[f64]) -> Deformations {
        let mut equilibrium_resultants = [0.0; MAX_DEFORMATIONS];
        for (row, out) in equilibrium_resultants[..s.size].iter_mut().enumerate() {
            let (r, i, _) = s.of[row];
            let internal = &load[REACTIONS + i * INTERNAL..REACTIONS + (i + 1) * INTERNAL];
            let inside = if self.loads_inside { sense(r) * of_load(r, internal) } else { 0.0 };
            *out = dot(&s.rows[row], q) + q[0] * s.d[row] + inside;
        }
        equilibrium_resultants
    }

    /// Linearises equilibrium of sections with the resultants `resultants` and the stiffnesses of a state, and `support` times
    /// those of the virgin sections. `None` if the matrix is singular.
    fn linear<const N: usize, const B: usize>(
        &self,
        member: &Member<N, B>,
        s: &Sections<B>,
        (q, load): (&[f64; B], &[f64]),
        resultants: &Deformations,
        (trial, support): (&[f64], f64),
    ) -> Option<Linear<B>> {
        let m = s.size;
        let mut a = [[0.0; COLUMNS]; MAX_DEFORMATIONS];
        let mut residual = self.equilibrium_resultants(s, q, load);
        residual.iter_mut().zip(resultants).for_each(|(x, s)| *x -= s);
        // Derivative of v₀ by the deformations, deflections included.
        let mut work = [0.0; MAX_DEFORMATIONS];
        let mut at = 0;
        for (section, ..) in member.along() {
            let n = section.resultants().len();
            let mut virgin = [0.0; MAX_ORDER * MAX_ORDER];
            if support != 0.0 {
                section.section.initial_stiffness(&mut virgin[..n * n]);
            }
            for k in 0..n {
                let row = at + k;
                for b in 0..m {
                    let influence = s.influence(self, member, row, b);
                    a[row][b] = -q[0] * influence;
                    work[b] += 0.5 * s.of[row].2 * influence * s.e[row];
                }
                work[row] += 0.5 * s.of[row].2 * s.d[row];
                a[row][at..at + n].iter_mut().zip(&section.stiffness(trial)[k * n..]).for_each(|(a, k)| *a += k);
                a[row][at..at + n].iter_mut().zip(&virgin[k * n..]).for_each(|(a, k)| *a += support * k);
                a[row][m] = residual[row];
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
            residual,
            carried: *resultants,
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

    /// Updates the sections with deformations.
    fn update<const N: usize, const B: usize>(
        member: &Member<N, B>,
        e: &Deformations,
        dt: f64,
        h: &mut Histories<'_>,
    ) -> Result<(), MaterialError> {
        let mut at = 0;
        for (section, ..) in member.along() {
            section.update(h.committed, &e[at..], dt, h.trial)?;
            at += section.resultants().len();
        }
        Ok(())
    }

    /// Basic forces for deformations `v` in `parts` equal increments from the committed state. Newton's method solves
    /// for all section deformations and basic forces at once, with `support` times the virgin stiffnesses added.
    ///
    /// # Errors
    /// Why there are none.
    fn attempt<const N: usize, const B: usize>(
        &self,
        member: &Member<N, B>,
        v: &[f64; B],
        motion: &ElementInput<'_>,
        h: &mut Histories<'_>,
        (parts, support): (usize, f64),
    ) -> Result<Basic<B>, Miss> {
        let body = member.body();
        h.trial[body..].copy_from_slice(&h.committed[body..]);
        let mut basic = Basic::read(&h.committed[member.head()..]);
        let start = Sections::new(self, member, h.committed, None).basic_deformations();
        for part in 1..=parts {
            let share = part as f64 / parts as f64;
            let (mut iteration, mut extra_iterations) = (0, 0);
            loop {
                let s = Sections::new(self, member, h.trial, None);
                let loading = (&basic.q, motion.load);
                let Some(mut l) = self.linear(member, &s, loading, &resultants(member, h.trial), (h.trial, support))
                else {
                    return Err(Miss::Incompatible);
                };
                if !invert(l.f.as_flattened_mut(), B) {
                    return Err(Miss::Incompatible);
                }
                let basic_deformations = s.basic_deformations();
                let gap: [f64; B] =
                    std::array::from_fn(|i| start[i] + share * (v[i] - start[i]) - basic_deformations[i]);
                let remaining: [f64; B] = std::array::from_fn(|i| gap[i] - l.v[i]);
                let step = l.f.map(|row| dot(&row, &remaining));
                axpy(1.0, &step, &mut basic.q);
                basic.k = l.f;
                let (mut e, mut energy) = (s.e, dot(&step, &gap).abs());
                for (b, e) in e[..s.size].iter_mut().enumerate() {
                    let change = l.change[b] + dot(&step, &l.per_force[b]);
                    *e += change;
                    energy += (s.of[b].2 * change * l.residual[b]).abs();
                }
                let within_tolerance = energy <= self.iteration.tolerance;
                extra_iterations += usize::from(within_tolerance);
                let last = iteration == self.iteration.max_iterations;
                if within_tolerance
                    && (energy <= ACCURATE * dot(&basic.q, v).abs() || extra_iterations > MAX_EXTRA_ITERATIONS || last)
                {
                    break;
                }
                if last || !energy.is_finite() {
                    let worst = l.unbalanced(&s, dot(&step, &gap).abs());
                    return Err(worst.map_or(Miss::Incompatible, Miss::Unbalanced));
                }
                iteration += 1;
                Self::update(member, &e, motion.dt, h)?;
            }
        }
        Ok(basic)
    }
}

impl<const N: usize, const B: usize, R: Rules> Formulation<N, B> for CurvatureBased<R> {
    type Loads = ForceBased;
    const CLASS: [Class; 2] = [Class::new("ForceBeamColumnCBDI2d", 77), Class::new("ForceBeamColumnCBDI3d", 78)];
    const SYMMETRIC: bool = false;
    const DEFLECTS: bool = true;
    const LACKING: Lacking = Lacking::Refused;
    const SHOWS_DEFLECTION: bool = true;
    const STATE_LEN: usize = if R::CALL_DEPENDENT { Trace::<N, B>::LEN } else { 0 };

    fn continues_from_last_trial(&self) -> bool {
        R::CALL_DEPENDENT
    }

    fn whole_tangent(&self) -> bool {
        R::WHOLE_TANGENT
    }

    fn respond(
        &self,
        member: &Member<N, B>,
        v: &[f64; B],
        motion: &ElementInput<'_>,
        h: &mut Histories<'_>,
    ) -> ElementResult<Basic<B>> {
        let mut miss: Option<Miss> = None;
        let trace = R::CALL_DEPENDENT.then(|| Trace::next(member, v, motion, h.trial));
        for (parts, support) in [(0, 0.0), (1, 0.0), (10, 0.0), (100, 0.0), (1, SUPPORT), (10, SUPPORT), (100, SUPPORT)]
        {
            let found = match (parts, &trace) {
                (0, None) => continue,
                (0, Some(trace)) => match R::first(self, member, trace, motion, h) {
                    Ok(found) => found.ok_or(Miss::Incompatible),
                    Err(error) => Err(Miss::Section(error)),
                },
                (parts, _) => self.attempt(member, v, motion, h, (parts, support)),
            };
            match found {
                Ok(basic) if basic.q.iter().all(|q| q.is_finite()) => {
                    if let Some(trace) = &trace {
                        trace.write(&mut h.trial[member.own_words()..]);
                    }
                    return Ok(basic);
                }
                Ok(_) => {}
                Err(new) => miss = Some(new.or(miss)),
            }
        }
        Err(miss.unwrap_or(Miss::Incompatible).error(member))
    }

    fn initial_stiffness(member: &Member<N, B>) -> [[f64; B]; B] {
        <ForceBased as Formulation<N, B>>::initial_stiffness(member)
    }

    fn elastic_deformation(member: &Member<N, B>, q: &[f64; B], load: &[f64]) -> [f64; B] {
        <ForceBased as Formulation<N, B>>::elastic_deformation(member, q, load)
    }
}
