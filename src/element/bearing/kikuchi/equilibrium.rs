//! Inner equilibrium of a Kikuchi bearing, to round-off at every trial state.

use super::condensation::{Condensed, condense, correction, followed, join};
use super::kinematics::{INNER, Matrix, Motion, OUTER, Springs};
use super::{Factors, KikuchiBearing};
use crate::element::ElementError;
use crate::words;
use crate::words::Words;

words! {
    /// What a bearing keeps besides the histories of its springs.
    pub(super) struct Memory {
        /// Displacements of the ends in local axes.
        outer: [f64; 12],
        /// Displacements of the inner nodes.
        inner: [f64; 6],
        /// Axial deformation at mid-height.
        axial: f64,
        /// How the inner nodes follow the ends, by columns: where they are looked for first.
        follow: [[f64; 6]; 12],
    }
}

/// Residual at the inner nodes over the forces of the bearing that counts as none: the inner nodes yield to it once more
/// as the equations are condensed, so that the forces at the ends are those of a residual of its square.
const TOLERANCE: f64 = 1e-8;
/// The same over E A: a strain.
const STRAIN: f64 = 1e-12;
/// Residuals so many times larger are taken where round-off lets them sink no further.
const STAGNATION: f64 = 1e3;
/// Largest number of iterations on the way to a displacement.
const ITERATIONS: usize = 60;

/// A step of the ends, for which the inner nodes are looked for.
struct Step<'a> {
    committed: &'a [f64],
    from: Memory,
    factors: Factors,
    dt: f64,
}

/// The bearing at a trial position of its inner nodes.
struct Trial {
    inner: [f64; INNER],
    springs: Springs,
    /// Largest force left at the inner nodes, and the largest that counts as none.
    residual: f64,
    allowed: f64,
}

/// Forces and stiffness of all degrees of freedom at the position that was tried last. The inner nodes are taken out of
/// them once they are in balance: on the way there it is enough to know how they yield.
struct Equations {
    forces: Motion,
    stiffness: Matrix,
}

impl KikuchiBearing {
    /// The state at rest.
    pub(super) fn virgin_memory(&self) -> Memory {
        let follow = self.virgin_condensed(self.virgin_factors.force).map(|c| c.yielding.follow);
        let mut memory = Memory::default();
        if let Some(follow) = follow {
            memory.follow = follow;
        }
        memory
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

    /// Forces at the ends and their consistent tangent, in local axes, for displacements of the ends.
    ///
    /// # Errors
    /// No inner equilibrium was found, or a spring has no answer.
    pub(super) fn converge(
        &self,
        outer: [f64; OUTER],
        committed: &[f64],
        dt: f64,
        trial: &mut [f64],
    ) -> Result<([f64; OUTER], [[f64; OUTER]; OUTER]), ElementError> {
        let [v, w] = self.offset(&outer);
        let size = v.hypot(w);
        // The derivative of the forces, not OpenSees' factor of the stiffness.
        let factors = self.shear.factors(size, committed, trial)?;
        let step = Step {
            committed,
            from: Memory::read(committed),
            factors: Factors { stiffness: factors.force, ..factors },
            dt,
        };
        let mut equations = Equations { forces: Motion::zeros(), stiffness: Matrix::zeros() };
        let Trial { inner, springs, .. } = self.find(&step, &outer, trial, &mut equations)?;
        let c = condense(&equations.forces, &equations.stiffness, &self.hold)
            .ok_or_else(|| ElementError("the inner nodes of the bearing are held by nothing".into()))?;
        let memory = Memory { outer, inner, axial: springs.axial, follow: c.yielding.follow };
        memory.write(trial);
        let (mut force, mut stiffness) = (c.force, c.stiffness);
        if let Some(shares) = self.shares {
            take_off_p_delta(&outer, shares, &mut force, &mut stiffness);
        }
        Ok((force, stiffness))
    }

    /// Look for the inner nodes: from where they would follow the ends to, or else along the way of the ends.
    fn find(
        &self,
        step: &Step<'_>,
        outer: &[f64; OUTER],
        trial: &mut [f64],
        equations: &mut Equations,
    ) -> Result<Trial, ElementError> {
        let from = &step.from;
        let way: [f64; OUTER] = std::array::from_fn(|i| outer[i] - from.outer[i]);
        let first = self.newton(step, outer, followed(&from.follow, &from.inner, &way), trial, equations);
        if let Ok(Some(found)) = first {
            return Ok(found);
        }
        for parts in [4, 32] {
            let mut inner = from.inner;
            for part in 1..=parts {
                let at: [f64; OUTER] =
                    std::array::from_fn(|i| from.outer[i] + way[i] * f64::from(part) / f64::from(parts));
                match self.newton(step, &at, inner, trial, equations)? {
                    Some(found) if part == parts => return Ok(found),
                    Some(found) => inner = found.inner,
                    None => break,
                }
            }
        }
        first?;
        Err(ElementError("the bearing finds no inner equilibrium: the step is too large, or it has buckled".into()))
    }

    /// Newton's method for the inner nodes, with steps that do not let the residual grow.
    fn newton(
        &self,
        step: &Step<'_>,
        outer: &[f64; OUTER],
        start: [f64; INNER],
        trial: &mut [f64],
        equations: &mut Equations,
    ) -> Result<Option<Trial>, ElementError> {
        let mut best = self.at(step, outer, start, trial, equations)?;
        for _ in 0..ITERATIONS {
            if best.residual <= best.allowed {
                return Ok(Some(best));
            }
            let Some(correction) = correction(&equations.forces, &equations.stiffness, &self.hold) else {
                return Ok(None);
            };
            let mut share = 1.0;
            let next = loop {
                let inner = std::array::from_fn(|i| best.inner[i] + share * correction[i]);
                let next = self.at(step, outer, inner, trial, equations)?;
                if next.residual < best.residual {
                    break next;
                }
                if best.residual <= STAGNATION * best.allowed {
                    // The springs' histories in `trial`, and the equations, are to be those of the answer.
                    return Ok(Some(self.at(step, outer, best.inner, trial, equations)?));
                }
                share *= 0.5;
                if share < 1e-3 {
                    break next;
                }
            };
            best = next;
        }
        Ok(None)
    }

    /// The bearing at displacements of its ends and inner nodes.
    fn at(
        &self,
        step: &Step<'_>,
        outer: &[f64; OUTER],
        inner: [f64; INNER],
        trial: &mut [f64],
        equations: &mut Equations,
    ) -> Result<Trial, ElementError> {
        let k = &self.kinematics;
        let (from, q) = (join(&step.from.outer, &step.from.inner), join(outer, &inner));
        let row = k.axial_row(&q);
        let (axial, change) = k.axial(step.from.axial, &from, &q);
        let springs = self.springs(step.committed, &q, step.factors, axial, step.dt, trial)?;
        let Equations { forces: f, stiffness } = equations;
        *f = k.forces(&q, &springs, &row);
        k.stiffness_into(&springs, &row, &change, stiffness);
        k.add_geometric(k.stiff.axial * axial, stiffness);
        self.add_slope(&springs, step.factors, outer, stiffness);
        // Forces, and moments over an arm.
        let size =
            |i: usize| if matches!(i % 6, 3..=5) && i < OUTER || i > 12 && i != 15 { 1.0 / self.arm } else { 1.0 };
        let largest = |range: std::ops::Range<usize>| range.fold(0.0f64, |m, i| m.max((f[i] * size(i)).abs()));
        let residual = largest(OUTER..OUTER + INNER);
        let allowed = TOLERANCE * largest(0..OUTER) + STRAIN * self.axial_rigidity;
        if !residual.is_finite() {
            return Err(ElementError("a spring of the bearing answers with no number".into()));
        }
        Ok(Trial { inner, springs, residual, allowed })
    }

    /// What the factor of the shear forces adds to the stiffness as it changes with the displacement.
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
                    stiffness[(i, 7 + k)] += c;
                    stiffness[(i, 1 + k)] -= c;
                }
            }
        }
    }
}

/// Take the P-Delta moments off the end moments, by shares at i and at j, and off the tangent.
fn take_off_p_delta(
    outer: &[f64; OUTER],
    shares: [f64; 2],
    force: &mut [f64; OUTER],
    stiffness: &mut [[f64; OUTER]; OUTER],
) {
    let pressure = -force[6];
    let change = stiffness[6].map(|k| -k);
    for (end, share) in shares.into_iter().enumerate() {
        // The displacement along y has a moment about z, that along z one about y.
        for (along, about, sign) in [(1, 5, 1.0), (2, 4, -1.0)] {
            let row = 6 * end + about;
            let lever = outer[along + 6] - outer[along];
            force[row] += sign * share * pressure * lever;
            for (k, c) in stiffness[row].iter_mut().zip(change) {
                *k += sign * share * c * lever;
            }
            stiffness[row][along + 6] += sign * share * pressure;
            stiffness[row][along] -= sign * share * pressure;
        }
    }
}
