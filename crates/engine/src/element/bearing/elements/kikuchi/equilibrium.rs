//! Inner equilibrium of a Kikuchi bearing, to round-off at every trial state.

use super::condensation::{
    Condensed, Inner, condense, condense_into, correction, extrapolated, join, no_inner_stiffness,
};
use super::kinematics::{DOFS, INNER, Matrix, Motion, OUTER, Springs};
use super::{Factors, KikuchiBearing};
use crate::element::{ElementError, ElementResult, Histories, Rows, dot};
use crate::numeric::largest;
use crate::state_struct;
use crate::state_struct::StateStruct;

/// Number of state variables of the memory and of the derivatives of the inner displacements by the outer ones.
pub(super) const HEADER: usize = FOLLOW_AT + OUTER * INNER;
/// Place of the derivatives, which are read in place.
const FOLLOW_AT: usize = <Memory as StateStruct>::LEN;

/// Derivatives of the inner displacements by the outer ones in the state of the bearing, by columns.
fn follow(state: &[f64]) -> &[f64] {
    &state[FOLLOW_AT..HEADER]
}

state_struct! {
    /// State variables besides the histories of the springs.
    pub(super) struct Memory {
        /// Displacements of the ends in local axes.
        outer: [f64; 12],
        /// Displacements of the inner nodes.
        inner: [f64; 6],
        /// Newton correction for the residual at the inner nodes.
        correction: [f64; 6],
        /// Axial deformation at mid-height.
        axial: f64,
        /// The last step of the ends.
        way: [f64; 12],
        /// Error of the linear extrapolation of the inner nodes in that step. It is in proportion to the square of the length of a
        /// step where the motion is smooth.
        bend: [f64; 6],
        /// Size of the shear displacement that the shear springs have been scaled for.
        size: f64,
        /// Factor of their forces, and its derivative by that size; no factor where none has been worked out.
        factor: [f64; 2],
    }
}

/// Tolerance of the residual at the inner nodes, over the forces of the bearing. The condensation corrects the inner nodes
/// once more, so that the residual in the forces at the ends is of the order of its square.
const TOLERANCE: f64 = 1e-8;
/// Tolerance for evaluations with tangent, which another correction of the ends mostly follows. Its square is still below
/// the tolerance of the others.
const TANGENT_TOLERANCE: f64 = 1e-6;
/// Absolute tolerance over E A: a strain.
const STRAIN: f64 = 1e-12;
/// Residuals so many times larger than [`TOLERANCE`] says are taken where round-off lets them sink no further.
const STAGNATION: f64 = 1e3;
/// Largest ratio of a step to the last one in the extrapolation of the inner nodes.
const MAX_STEP_RATIO: f64 = 2.0;
/// Share of the tolerance below which the inner nodes need no further correction.
const CORRECTED: f64 = 1e-3;
/// Largest squared distance to the ends of the last call, over the squared step, for a start from that call.
const MAX_SQUARED_DISTANCE: f64 = 0.1;
/// The axial force at j, in local axes.
const AXIAL: usize = 6;
/// Largest number of inner iterations.
const ITERATIONS: usize = 60;

/// A step of the ends, for which the equilibrium of the inner nodes is found.
struct Step<'a> {
    from: &'a Memory,
    /// Displacements that it begins with, and the row of the axial force there.
    origin: Motion,
    row: Motion,
    factors: Factors,
    dt: f64,
    /// Tolerance of the residual over the forces of the bearing.
    tolerance: f64,
}

/// The bearing at a trial position of its inner nodes.
#[derive(Default)]
struct Trial {
    inner: [f64; INNER],
    springs: Springs,
    forces: Motion,
    /// Row of the axial force, and derivatives of the axial deformation.
    row: Motion,
    change: Motion,
    /// Residual at the inner nodes, its tolerance, and the tolerance where it sinks no further.
    residual: f64,
    allowed: f64,
    taken: f64,
}

impl KikuchiBearing {
    /// Write the state at rest.
    pub(super) fn write_virgin_memory(&self, state: &mut [f64]) {
        let follow = self.virgin_condensed(self.virgin_factors.force).map(|c| c.solution.follow);
        Memory::default().write(state);
        state[FOLLOW_AT..HEADER].copy_from_slice(follow.unwrap_or_default().as_flattened());
    }

    /// The virgin bearing at rest, with a factor of the shear springs.
    pub(super) fn virgin_condensed(&self, factor: f64) -> Option<Condensed> {
        let rest = join(&[0.0; OUTER], &[0.0; INNER]);
        let row = self.kinematics.axial_row(&rest);
        let stiffness = self.kinematics.stiffness(&self.virgin_springs(factor), &row, &row);
        condense(&rest, &stiffness, &self.hold)
    }

    /// Stiffness of the virgin bearing in local axes.
    pub(super) fn virgin_tangent(&self) -> [[f64; OUTER]; OUTER] {
        self.virgin_condensed(self.virgin_factors.force).map_or([[0.0; OUTER]; OUTER], |c| c.stiffness)
    }

    /// Forces at the ends and wanted rows of their consistent tangent, in local axes, for displacements of the ends; `into` has
    /// none yet.
    ///
    /// # Errors
    /// No inner equilibrium was found, or a spring finds no force.
    pub(super) fn converge(
        &self,
        outer: [f64; OUTER],
        h: &mut Histories<'_>,
        dt: f64,
        rows: Rows,
        into: &mut Condensed,
    ) -> ElementResult {
        let (from, last) = (Memory::read(h.committed), Memory::read(h.trial));
        let factors = self.factors_at(&outer, &last, h)?;
        let origin = join(&from.outer, &from.inner);
        let row = self.kinematics.axial_row(&origin);
        let tolerance = if rows == Rows::NONE { TOLERANCE } else { TANGENT_TOLERANCE };
        let step = Step { from: &from, origin, row, factors, dt, tolerance };
        let way = std::array::from_fn(|i| outer[i] - from.outer[i]);
        let rest = nearer(&outer, &way, &last);
        let guess = match &rest {
            Some(rest) => {
                let inner = std::array::from_fn(|i| last.inner[i] + last.correction[i]);
                extrapolated(follow(h.trial), &inner, rest)
            }
            None => guess(&from, follow(h.committed), &way),
        };
        let mut trials = [Trial::default(), Trial::default()];
        let found = self.find(&step, &outer, guess, h, &mut trials)?;
        if rows == Rows::NONE && rest.is_some() && found.residual <= CORRECTED * found.allowed {
            // No tangent is needed, and the derivatives of the last call are still good enough.
            into.force.copy_from_slice(&found.forces.as_slice()[..OUTER]);
        } else {
            self.condense_found(found, factors, &outer, rows, into)?;
            h.trial[FOLLOW_AT..HEADER].copy_from_slice(into.solution.follow.as_flattened());
        }
        let extrapolated = extrapolated(follow(h.committed), &from.inner, &way);
        Memory {
            outer,
            inner: found.inner,
            correction: into.solution.correction,
            axial: found.springs.axial,
            way,
            bend: std::array::from_fn(|i| found.inner[i] - extrapolated[i]),
            size: self.size(&outer),
            factor: [factors.force, factors.slope],
        }
        .write(h.trial);
        if let Some(shares) = self.shares {
            take_off_p_delta(&outer, shares, into, rows);
        }
        Ok(())
    }

    /// Condense the inner nodes at their equilibrium.
    fn condense_found(
        &self,
        found: &Trial,
        factors: Factors,
        outer: &[f64; OUTER],
        rows: Rows,
        into: &mut Condensed,
    ) -> ElementResult {
        let mut stiffness = [[0.0; DOFS]; DOFS];
        self.kinematics.stiffness_into(&found.springs, &found.row, &found.change, &mut stiffness);
        self.kinematics.add_geometric(self.kinematics.stiff.axial * found.springs.axial, &mut stiffness);
        self.add_slope(&found.springs, factors, outer, &mut stiffness);
        // The moments of P-Delta change with the axial force.
        let wanted = if self.shares.is_some() { rows.and(AXIAL) } else { rows };
        condense_into(&found.forces, &stiffness, &self.hold, wanted, into).ok_or_else(no_inner_stiffness)
    }

    /// Size of the shear displacement.
    fn size(&self, outer: &[f64; OUTER]) -> f64 {
        let [v, w] = self.offset(outer);
        v.hypot(w)
    }

    /// Factors of the shear springs: those of the last call if it had the same shear displacement.
    fn factors_at(&self, outer: &[f64; OUTER], last: &Memory, h: &mut Histories<'_>) -> ElementResult<Factors> {
        let size = self.size(outer);
        let [force, slope] = last.factor;
        if force != 0.0 && last.size == size {
            return Ok(Factors { force, stiffness: force, slope });
        }
        let factors = self.shear.factors(size, h)?;
        // The derivative of the forces, not OpenSees' factor of the stiffness.
        Ok(Factors { stiffness: factors.force, ..factors })
    }

    /// Find the equilibrium of the inner nodes: from a guess, or else in parts of the step of the ends.
    fn find<'t>(
        &self,
        step: &Step<'_>,
        outer: &[f64; OUTER],
        guess: [f64; INNER],
        h: &mut Histories<'_>,
        trials: &'t mut [Trial; 2],
    ) -> ElementResult<&'t Trial> {
        let from = step.from;
        let first = self.newton(step, outer, guess, h, trials);
        if let Ok(Some(found)) = first {
            return Ok(&trials[found]);
        }
        let way: [f64; OUTER] = std::array::from_fn(|i| outer[i] - from.outer[i]);
        let next = extrapolated(follow(h.committed), &from.inner, &way);
        if let Ok(Some(found)) = self.newton(step, outer, next, h, trials) {
            return Ok(&trials[found]);
        }
        for parts in [4, 32] {
            let mut inner = from.inner;
            for part in 1..=parts {
                let at: [f64; OUTER] =
                    std::array::from_fn(|i| from.outer[i] + way[i] * f64::from(part) / f64::from(parts));
                match self.newton(step, &at, inner, h, trials)? {
                    Some(found) if part == parts => return Ok(&trials[found]),
                    Some(found) => inner = trials[found].inner,
                    None => break,
                }
            }
        }
        first?;
        Err(ElementError("the bearing finds no inner equilibrium: the step is too large, or it has buckled".into()))
    }

    /// Newton's method for the inner nodes, with steps that do not let the residual grow. Returns the number of the trial that
    /// is in equilibrium.
    fn newton(
        &self,
        step: &Step<'_>,
        outer: &[f64; OUTER],
        start: [f64; INNER],
        h: &mut Histories<'_>,
        trials: &mut [Trial; 2],
    ) -> ElementResult<Option<usize>> {
        let mut found = 0;
        self.at(step, outer, start, h, &mut trials[found])?;
        for _ in 0..ITERATIONS {
            let [a, b] = &mut *trials;
            let (best, next) = if found == 0 { (a, b) } else { (b, a) };
            if best.residual <= best.allowed {
                return Ok(Some(found));
            }
            let stiffness = self.kinematics.inner_stiffness(&best.springs, &best.row, &best.change);
            let Some(correction) = correction(&best.forces, stiffness, &self.hold) else {
                return Ok(None);
            };
            found = 1 - found;
            let mut share = 1.0;
            loop {
                let inner = std::array::from_fn(|i| best.inner[i] + share * correction[i]);
                self.at(step, outer, inner, h, next)?;
                if next.residual < best.residual {
                    break;
                }
                if best.residual <= best.taken {
                    // The springs' histories in `trial` must be those of the result.
                    self.at(step, outer, best.inner, h, next)?;
                    return Ok(Some(found));
                }
                share *= 0.5;
                if share < 1e-3 {
                    break;
                }
            }
        }
        Ok(None)
    }

    /// The bearing at displacements of its ends and inner nodes.
    fn at(
        &self,
        step: &Step<'_>,
        outer: &[f64; OUTER],
        inner: [f64; INNER],
        h: &mut Histories<'_>,
        into: &mut Trial,
    ) -> ElementResult {
        let k = &self.kinematics;
        let q = join(outer, &inner);
        into.inner = inner;
        into.row = k.axial_row(&q);
        (into.springs.axial, into.change) = k.axial(step.from.axial, &(q - step.origin), [&step.row, &into.row]);
        self.evaluate_springs(h, &q, step.factors, step.dt, &mut into.springs)?;
        into.forces = k.forces(&q, &into.springs, &into.row);
        // Forces, and moments over an arm.
        let (f, by) = (&into.forces, 1.0 / self.arm);
        let residual = largest(&[f[12], f[15]]).max(by * largest(&[f[13], f[14], f[16], f[17]]));
        let whole = [&f.as_slice()[..3], &f.as_slice()[6..9]].map(largest);
        let moments = [&f.as_slice()[3..6], &f.as_slice()[9..12]].map(largest);
        let whole = largest(&whole).max(by * largest(&moments));
        if !f.sum().is_finite() {
            return Err(ElementError("a spring of the bearing answers with no number".into()));
        }
        let strain = STRAIN * self.axial_rigidity;
        (into.residual, into.allowed) = (residual, step.tolerance * whole + strain);
        into.taken = STAGNATION * (TOLERANCE * whole + strain);
        Ok(())
    }

    /// Add the stiffness from the change of the factor of the shear forces with the displacement.
    fn add_slope(&self, springs: &Springs, factors: Factors, outer: &[f64; OUTER], stiffness: &mut Matrix) {
        if factors.slope == 0.0 {
            return;
        }
        let [v, w] = self.offset(outer);
        let direction = [v / v.hypot(w), w / v.hypot(w)];
        for (rows, force) in self.kinematics.shear_rows().into_iter().zip(springs.shear) {
            for (i, x) in rows {
                for (k, d) in direction.into_iter().enumerate() {
                    let c = x * force / factors.force * factors.slope * d;
                    stiffness[i][7 + k] += c;
                    stiffness[i][1 + k] -= c;
                }
            }
        }
    }
}

/// Displacements from the ends of the last call, if these are much nearer than the committed ones. The corrections of a step
/// are small beside the step.
fn nearer(outer: &[f64; OUTER], way: &[f64; OUTER], last: &Memory) -> Option<[f64; OUTER]> {
    let rest: [f64; OUTER] = std::array::from_fn(|i| outer[i] - last.outer[i]);
    (dot(&rest, &rest) < MAX_SQUARED_DISTANCE * dot(way, way)).then_some(rest)
}

/// Start of the inner iteration: a linear extrapolation of the committed state, plus the error of the last extrapolation
/// times the squared ratio of the steps.
fn guess(from: &Memory, follow: &[f64], way: &[f64; OUTER]) -> Inner {
    let inner = extrapolated(follow, &from.inner, way);
    let ratio = dot(way, &from.way) / dot(&from.way, &from.way);
    let square = if ratio > 0.0 { ratio.min(MAX_STEP_RATIO).powi(2) } else { 0.0 };
    std::array::from_fn(|i| inner[i] + square * from.bend[i])
}

/// Take the P-Delta moments off the end moments, by shares at i and at j, and off these rows of the tangent.
fn take_off_p_delta(
    outer: &[f64; OUTER],
    shares: [f64; 2],
    Condensed { force, stiffness, .. }: &mut Condensed,
    rows: Rows,
) {
    let pressure = -force[6];
    let change = stiffness[6].map(|k| -k);
    for (end, share) in shares.into_iter().enumerate() {
        // The displacement along y has a moment about z, that along z one about y.
        for (along, about, sign) in [(1, 5, 1.0), (2, 4, -1.0)] {
            let row = 6 * end + about;
            let lever = outer[along + 6] - outer[along];
            force[row] += sign * share * pressure * lever;
            if !rows.has(row) {
                continue;
            }
            for (k, c) in stiffness[row].iter_mut().zip(change) {
                *k += sign * share * c * lever;
            }
            stiffness[row][along + 6] += sign * share * pressure;
            stiffness[row][along] -= sign * share * pressure;
        }
    }
}
