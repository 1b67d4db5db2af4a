//! The force-based beam: `forceBeamColumn`.

use super::basic::Basic;
use super::member::{Formulation, Lacking, LoadSums, Member, Trace, bending_at, set};
use super::opensees::settle;
use super::per_section::PerSection;
use super::point::{Point, Stiffness, read_all};
use super::shortfall::{Miss, Shortfall};
use crate::element::load::ElementLoad;
use crate::element::transform::Reactions;
use crate::element::{Class, ElementInput, ElementResult, Histories};
use crate::numeric::{axpy, dot, invert, product};
use crate::section::{MAX_ORDER, Resultant};

/// Internal forces are in equilibrium with the basic forces and the loads on the beam. Basic deformations are the
/// weighted integral of the section deformations (Spacone, Filippou and Taucer, 1996; Neuenhofer and Filippou, 1997).
#[derive(Clone, Copy, Debug)]
pub struct ForceBased {
    /// Largest number of internal iterations.
    pub max_iterations: usize,
    /// Tolerance of the residual energy.
    pub tolerance: f64,
    /// Largest number of subdivisions of a step by OpenSees.
    pub parts: u32,
    /// Factor of each subdivision.
    pub factor: f64,
    /// OpenSees' scheme: iterations continue from the last trial state.
    pub compat: bool,
}

impl Default for ForceBased {
    fn default() -> Self {
        Self { max_iterations: 10, tolerance: 1e-12, parts: 4, factor: 10.0, compat: false }
    }
}

/// Residual energy that ends the iterations, as a part of the energy of the basic system. Forces of the sections are off by
/// 1e-9 then; those of the beam, which are corrected once more, by the square of it.
pub(super) const ACCURATE: f64 = 1e-18;
/// Largest number of iterations beyond the tolerance, towards that energy.
pub(super) const MAX_EXTRA_ITERATIONS: usize = 3;

/// Numbers of load sums: reactions, and internal forces of the simple beam at each section.
pub(super) const REACTIONS: usize = 5;
pub(super) const INTERNAL: usize = 5;

/// Section flexibility in the correction of the deformations.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Correction {
    /// Current flexibility.
    Current,
    /// Initial flexibility in the first iteration, then the current one.
    InitialFirst,
    /// Initial flexibility: slow but stable.
    Initial,
    /// Current flexibility, limited where a section is fully plastic.
    Limited,
}

impl Correction {
    /// Stiffness of a section after its update.
    fn stiffness(self) -> Stiffness {
        if self == Self::Limited { Stiffness::Supported } else { Stiffness::Current }
    }
}

/// Section state from which an attempt starts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Start {
    /// The last trial of the step. It is near the solution as soon as the step has been iterated once. The solution
    /// is the same to round-off, because each update begins with the committed history.
    LastTrial,
    /// The committed state.
    Committed,
}

/// Attempts in order: start, number of increments, and section flexibility. The first `Limited` one is made where a section
/// has stopped the attempts before it.
const ATTEMPTS: [(Start, usize, Correction); 13] = [
    (Start::LastTrial, 1, Correction::Current),
    (Start::Committed, 1, Correction::Current),
    (Start::Committed, 1, Correction::Limited),
    (Start::Committed, 1, Correction::Initial),
    (Start::Committed, 1, Correction::InitialFirst),
    (Start::Committed, 10, Correction::Current),
    (Start::Committed, 10, Correction::Initial),
    (Start::Committed, 10, Correction::InitialFirst),
    (Start::Committed, 100, Correction::Current),
    (Start::Committed, 100, Correction::Initial),
    (Start::Committed, 100, Correction::InitialFirst),
    (Start::Committed, 10, Correction::Limited),
    (Start::Committed, 100, Correction::Limited),
];

/// Bounds of the tolerance for the work of unbalanced section forces, as parts of the work of all section forces. They let
/// forces differ by about 1e-4 whatever the tolerance, and by 1e-2 at most.
const BALANCE: [f64; 2] = [1e-8, 1e-4];

/// Work that is none: a beam without load has forces of round-off.
const NEGLIGIBLE: f64 = 1e-12;

/// Iterations of the initial flexibility after which the fall of the residual energy is looked at.
const LOOK_BACK: usize = 20;
/// An attempt ends where this fall would leave that many times the tolerance at its last iteration.
const MISSED: f64 = 1e6;

/// A chord rotation, or an elongation as a part of the length, that is beyond beam theory: it comes of iterations that
/// diverge, and a hundred increments are not worth it.
const BEYOND_BEAMS: f64 = 1.0;
/// Increments of an attempt that are left out then.
const MANY: usize = 100;

/// Derivatives of a resultant at `x` (fraction of the length) by the basic forces.
pub(super) fn row<const B: usize>(resultant: Resultant, x: f64, length: f64) -> [f64; B] {
    let mut row = [0.0; B];
    match (resultant, bending_at(resultant)) {
        (Resultant::P, _) => row[0] = 1.0,
        (Resultant::Mz | Resultant::My, Some(at)) => {
            set(&mut row, at, x - 1.0);
            set(&mut row, at + 1, x);
        }
        (_, Some(at)) => {
            set(&mut row, at, 1.0 / length);
            set(&mut row, at + 1, 1.0 / length);
        }
        _ => set(&mut row, 5, 1.0),
    }
    row
}

/// Torsional flexibility L/GJ of a beam in space of sections without torsion, as in OpenSees.
const NEARLY_RIGID: f64 = 1e-10;

/// Adds the torsion of a beam in space whose sections have none to the flexibility and to the basic deformations.
pub(super) fn add_torsion<const N: usize, const B: usize>(
    member: &Member<N, B>,
    q: &[f64; B],
    f: &mut [[f64; B]; B],
    v: &mut [f64; B],
) {
    if let (Some(row), Some(q)) = (f.get_mut(5), q.get(5))
        && !member.along().any(|(section, ..)| section.resultants().contains(&Resultant::T))
    {
        set(row, 5, NEARLY_RIGID);
        set(v, 5, NEARLY_RIGID * q);
    }
}

/// Stiffness of the basic system, unless it is `kept`, and basic deformations for basic forces `q`, from the sections.
///
/// # Errors
/// The flexibility is singular.
fn stiffness_and_deformations<const N: usize, const B: usize, const M: usize>(
    member: &Member<N, B>,
    points: &PerSection<Point<B, M>>,
    q: &[f64; B],
    kept: Option<&[[f64; B]; B]>,
) -> Result<([[f64; B]; B], [f64; B]), Miss> {
    let (mut f, mut v) = ([[0.0; B]; B], [0.0; B]);
    for ((.., weight), p) in member.along().zip(points) {
        match kept {
            Some(_) => p.add_deformations(weight, &p.deformations(q), &mut v),
            None => p.add(weight, &p.deformations(q), &mut f, &mut v),
        }
    }
    add_torsion(member, q, &mut f, &mut v);
    match kept {
        Some(kept) => Ok((*kept, v)),
        None if invert(f.as_flattened_mut(), B) => Ok((f, v)),
        None => Err(Miss::Incompatible),
    }
}

/// Internal forces of the simple beam at a section, from the load sums of the beam.
pub(super) fn internal_forces(load: &[f64], section: usize) -> &[f64] {
    &load[REACTIONS + section * INTERNAL..REACTIONS + (section + 1) * INTERNAL]
}

/// Internal force of the simple beam for a resultant.
pub(super) fn of_load(resultant: Resultant, internal: &[f64]) -> f64 {
    match resultant {
        Resultant::P => internal[0],
        Resultant::Mz => internal[1],
        Resultant::Vy => internal[2],
        Resultant::My => internal[3],
        Resultant::Vz => internal[4],
        Resultant::T => 0.0,
    }
}

impl ForceBased {
    /// Returns true if the sections carry the forces along the beam. In the last iteration the wider bound decides alone: what
    /// is left then is a slow end of the iterations, and no strength that is exceeded.
    fn is_balanced<const N: usize, const B: usize, const M: usize>(
        &self,
        member: &Member<N, B>,
        points: &PerSection<Point<B, M>>,
        q: &[f64; B],
        is_last: bool,
    ) -> bool {
        let (mut unbalanced, mut whole) = (0.0, 0.0);
        for ((.., weight), point) in member.along().zip(points) {
            let (of_point, of_section) = point.work(q);
            unbalanced += weight.abs() * of_point;
            whole += weight.abs() * of_section;
        }
        let widest = (BALANCE[1] * whole).max(NEGLIGIBLE);
        let capped = if is_last { widest } else { self.tolerance.min(widest) };
        unbalanced <= capped.max(BALANCE[0] * whole)
    }

    /// Basic forces for deformations `v`: from the last trial, or in equal increments from the committed state.
    ///
    /// # Errors
    /// Why there are none.
    fn attempt<const N: usize, const B: usize, const M: usize>(
        &self,
        member: &Member<N, B>,
        v: &[f64; B],
        motion: &ElementInput<'_>,
        h: &mut Histories<'_>,
        (from, parts, correction): (Start, usize, Correction),
    ) -> Result<Basic<B>, Miss> {
        let body = member.body();
        // The last trial has written every state variable already.
        let mut updated = from == Start::LastTrial;
        let mut basic = Basic::read(if updated { &h.trial[member.head()..] } else { &h.committed[member.head()..] });
        if !updated {
            // State variables are written by the first update; without one they are those of the committed state.
            member
                .along()
                .for_each(|(section, ..)| section.response_mut(h.trial).copy_from_slice(section.response(h.committed)));
        }
        let length = member.length();
        let mut start = [0.0; B];
        for (section, x, weight) in member.along() {
            for (e, r) in section.deformation(h.committed).iter().zip(section.resultants()) {
                axpy(weight * e, &row::<B>(*r, x, length), &mut start);
            }
        }
        let mut progress = f64::INFINITY;
        let limit = self.max_iterations * if correction == Correction::Initial { 10 } else { 1 };
        let mut points = PerSection::new();
        for (i, (section, x, _)) in member.along().enumerate() {
            let internal = internal_forces(motion.load, i);
            points.push(Point::<B, M>::new(section, ((x, length), internal), h.trial, correction.stiffness())?);
        }
        for part in 1..=parts {
            let share = part as f64 / parts as f64;
            let (mut iteration, mut extra_iterations) = (0, 0);
            loop {
                // The last trial has left the stiffness of its sections behind.
                let kept = (from == Start::LastTrial && part + iteration == 1).then_some(&basic.k);
                let (k, basic_deformations) = stiffness_and_deformations(member, &points, &basic.q, kept)?;
                let mut residual = [0.0; B];
                for (i, residual) in residual.iter_mut().enumerate() {
                    *residual = start[i] + share * (v[i] - start[i]) - basic_deformations[i];
                }
                let step = product(&k, &residual);
                axpy(1.0, &step, &mut basic.q);
                basic.k = k;
                let energy = dot(&step, &residual).abs();
                // Iterate on beyond the tolerance: the residual enters the forces of the sections.
                let within_tolerance = energy <= self.tolerance;
                extra_iterations += usize::from(within_tolerance);
                if within_tolerance
                    && (energy <= ACCURATE * dot(&basic.q, v).abs()
                        || extra_iterations > MAX_EXTRA_ITERATIONS
                        || iteration == limit)
                    && self.is_balanced(member, &points, &basic.q, iteration == limit)
                {
                    break;
                }
                // Corrections by the initial flexibility converge geometrically.
                let mut hopeless = false;
                if correction == Correction::Initial && iteration % LOOK_BACK == 0 {
                    let rounds = ((limit - iteration) / LOOK_BACK) as i32;
                    hopeless = iteration > 0 && energy * (energy / progress).powi(rounds) > MISSED * self.tolerance;
                    progress = energy;
                }
                if iteration == limit || hopeless || !energy.is_finite() {
                    let unbalanced = within_tolerance.then(|| Shortfall::new(member, &points, &basic.q)).flatten();
                    return Err(unbalanced.map_or(Miss::Incompatible, Miss::Unbalanced));
                }
                iteration += 1;
                let initial = match correction {
                    Correction::Current | Correction::Limited => false,
                    Correction::InitialFirst => iteration == 1,
                    Correction::Initial => true,
                };
                if initial {
                    read_all(member, &mut points, h.trial, Stiffness::Virgin)?;
                }
                let e = (&points).into_iter().map(|point| point.deformations(&basic.q)).collect();
                member.update_sections(h, &e, motion.dt)?;
                read_all(member, &mut points, h.trial, correction.stiffness())?;
                updated = true;
            }
        }
        if !updated {
            h.trial[body..].copy_from_slice(&h.committed[body..]);
        }
        Ok(basic)
    }

    /// [`Formulation::respond`] for sections of at most `M` resultants.
    fn respond_of_order<const N: usize, const B: usize, const M: usize>(
        &self,
        member: &Member<N, B>,
        v: &[f64; B],
        motion: &ElementInput<'_>,
        h: &mut Histories<'_>,
    ) -> ElementResult<Basic<B>> {
        if self.compat {
            let found = self.iterate_from_trial::<N, B, M>(member, v, motion, h)?;
            return found.ok_or_else(|| Miss::Incompatible.error(member));
        }
        let mut miss: Option<Miss> = None;
        let beyond = v[0].abs() > BEYOND_BEAMS * member.length() || v[1..].iter().any(|v| v.abs() > BEYOND_BEAMS);
        for (n, attempt) in ATTEMPTS.into_iter().enumerate() {
            let limited = (n, attempt.2) == (2, Correction::Limited);
            if limited && !miss.as_ref().is_some_and(Miss::is_of_a_section) || beyond && attempt.1 == MANY {
                continue;
            }
            match self.attempt::<N, B, M>(member, v, motion, h, attempt) {
                Ok(basic) => return Ok(basic),
                Err(new) => miss = Some(new.or(miss)),
            }
        }
        Err(miss.unwrap_or(Miss::Incompatible).error(member))
    }

    /// Flexibility of the virgin beam, and its basic deformations from loads at zero basic forces.
    fn initial_flexibility<const N: usize, const B: usize>(
        member: &Member<N, B>,
        load: &[f64],
    ) -> ([[f64; B]; B], [f64; B]) {
        let (mut f, mut v) = ([[0.0; B]; B], [0.0; B]);
        for (i, (section, x, weight)) in member.along().enumerate() {
            let internal = if load.is_empty() { load } else { internal_forces(load, i) };
            let mut p = Point::<B, MAX_ORDER>::at(section, (x, member.length()), internal);
            if p.make_virgin(section).is_err() {
                continue;
            }
            p.load_alone();
            p.add(weight, &p.e(), &mut f, &mut v);
        }
        add_torsion(member, &[0.0; B], &mut f, &mut v);
        (f, v)
    }
}

impl<const N: usize, const B: usize> LoadSums<N, B> for ForceBased {
    fn load_len(points: usize) -> usize {
        REACTIONS + INTERNAL * points
    }

    fn add_load(member: &Member<N, B>, load: &ElementLoad, factor: f64, sums: &mut [f64]) {
        let length = member.length();
        let (reactions, internal) = sums.split_at_mut(REACTIONS);
        let (y, z, (axial, _)) = load.end_actions(length);
        axpy(-factor, &[axial, y.shear.0, y.shear.1, z.shear.0, z.shear.1], reactions);
        for (x, sums) in member.points.0.iter().zip(internal.chunks_exact_mut(INTERNAL)) {
            axpy(factor, &load.internal_forces(*x, length), sums);
        }
    }

    fn reactions(load: &[f64]) -> Reactions {
        std::array::from_fn(|i| load[i])
    }
}

impl<const N: usize, const B: usize> Formulation<N, B> for ForceBased {
    type Loads = Self;
    const CLASS: [Class; 2] = [Class::new("ForceBeamColumn2d", 73), Class::new("ForceBeamColumn3d", 74)];
    const LACKING: Lacking = Lacking::Rigid;
    const SHOWS_DEFLECTION: bool = true;
    const LOCALISES: bool = true;
    const DAMPABLE: bool = true;
    const STATE_LEN: usize = Trace::<N, B>::LEN;

    fn continues_from_last_trial(&self) -> bool {
        self.compat
    }

    fn respond(
        &self,
        member: &Member<N, B>,
        v: &[f64; B],
        motion: &ElementInput<'_>,
        h: &mut Histories<'_>,
    ) -> ElementResult<Basic<B>> {
        match member.order() {
            ..=2 => self.respond_of_order::<N, B, 2>(member, v, motion, h),
            3 => self.respond_of_order::<N, B, 3>(member, v, motion, h),
            4 => self.respond_of_order::<N, B, 4>(member, v, motion, h),
            _ => self.respond_of_order::<N, B, MAX_ORDER>(member, v, motion, h),
        }
    }

    fn settle(&self, member: &Member<N, B>, state: &mut [f64]) {
        settle(self, member, state);
    }

    fn initial_stiffness(member: &Member<N, B>) -> [[f64; B]; B] {
        let (mut f, _) = Self::initial_flexibility(member, &[]);
        // A singular flexibility was refused when the element was created.
        if invert(f.as_flattened_mut(), B) { f } else { [[0.0; B]; B] }
    }

    fn elastic_deformation(member: &Member<N, B>, q: &[f64; B], load: &[f64]) -> [f64; B] {
        let (f, v) = Self::initial_flexibility(member, load);
        std::array::from_fn(|i| dot(&f[i], q) + v[i])
    }
}
