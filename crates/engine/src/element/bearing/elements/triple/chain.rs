//! Three segments in series.

use super::segment::{Segment, SegmentForce};
use crate::element::friction::Coefficient;
use crate::element::{ElementError, ElementResult};
use crate::state_struct;
use nalgebra::{Matrix2, Vector2};

state_struct! {
    /// State variables of a chain, segment after segment, x and y of each.
    pub struct ChainState {
        /// Displacement of the chain.
        u: [f64; 2],
        /// Displacements of the segments.
        d: [f64; 6],
        /// Plastic displacements.
        plastic: [f64; 6],
        /// Back forces of the hardening.
        back: [f64; 6],
        /// Stiffnesses of the segments, 2 x 2 by rows.
        k: [f64; 12],
        /// Stiffness of the chain, 2 x 2 by rows.
        whole: [f64; 4],
        /// Force per weight.
        f: [f64; 2],
        /// Coefficients of friction at that force.
        mu: [f64; 3],
        /// Speeds of the segments.
        speed: [f64; 3],
    }
}

pub(super) fn two(entries: &[f64], i: usize) -> Vector2<f64> {
    Vector2::new(entries[2 * i], entries[2 * i + 1])
}

pub(super) fn square(entries: &[f64], i: usize) -> Matrix2<f64> {
    Matrix2::from_row_slice(&entries[4 * i..4 * i + 4])
}

pub(super) fn rows(m: &Matrix2<f64>) -> [f64; 4] {
    [m[(0, 0)], m[(0, 1)], m[(1, 0)], m[(1, 1)]]
}

impl ChainState {
    /// Stores the response of segment `i` at the displacement `d`.
    fn set(&mut self, i: usize, d: Vector2<f64>, p: &SegmentForce) {
        self.set_memory(i, d, (p.plastic, p.back), &p.k);
    }

    /// Sets displacement, plastic displacement, back force and stiffness of segment `i`.
    pub(super) fn set_memory(
        &mut self,
        i: usize,
        d: Vector2<f64>,
        (plastic, back): (Vector2<f64>, Vector2<f64>),
        k: &Matrix2<f64>,
    ) {
        for (entries, v) in [(&mut self.d, d), (&mut self.plastic, plastic), (&mut self.back, back)] {
            entries[2 * i..2 * i + 2].copy_from_slice(v.as_slice());
        }
        self.k[4 * i..4 * i + 4].copy_from_slice(&rows(k));
    }
}

fn inverses(k: [Matrix2<f64>; 3]) -> Option<[Matrix2<f64>; 3]> {
    let [a, b, c] = k.map(|k| k.try_inverse());
    Some([a?, b?, c?])
}

/// Stiffness of segments in series; `None` if singular.
pub(super) fn in_series(k: [Matrix2<f64>; 3]) -> Option<Matrix2<f64>> {
    inverses(k)?.iter().sum::<Matrix2<f64>>().try_inverse()
}

/// Three segments in series: the inner pair, the lower and the upper outer surface.
#[derive(Clone, Debug, PartialEq)]
pub struct Chain {
    /// The segments.
    pub segments: [Segment; 3],
}

/// Force of a chain with derivatives.
pub struct ChainForce {
    pub(super) state: ChainState,
    /// Stiffness.
    pub(super) k: Matrix2<f64>,
    /// Derivative of the force by the normal force, through the friction.
    pub(super) by_normal: Vector2<f64>,
    /// Speeds of the surfaces, with the coefficients of friction.
    pub(super) friction: [(f64, f64); 3],
}

/// Largest number of Newton steps.
const MAX_ITERATIONS: usize = 100;
/// Relative tolerance of the equality of the segment forces.
const TOLERANCE: f64 = 1e-13;
/// Relative tolerance once round-off stops the convergence.
const STALLED_TOLERANCE: f64 = 1e-10;

impl Chain {
    /// State variables of the virgin chain.
    pub fn virgin(&self) -> ChainState {
        let mut s = ChainState::default();
        let k = self.segments.map(|segment| Matrix2::from_diagonal_element(segment.e));
        for (entries, k) in s.k.chunks_exact_mut(4).zip(&k) {
            entries.copy_from_slice(&rows(k));
        }
        s.whole = rows(&in_series(k).unwrap_or_default());
        s
    }

    /// Force of the chain at a displacement `u`, from the committed state. Newton's method solves for segment
    /// displacements with the sum `u` and equal forces. `friction` gives the coefficient of a segment at the speed of
    /// its surface.
    ///
    /// # Errors
    /// No convergence.
    pub(super) fn stretch(
        &self,
        c: &ChainState,
        u: Vector2<f64>,
        dt: f64,
        friction: impl Fn(usize, f64) -> Coefficient,
    ) -> ElementResult<ChainForce> {
        let segment_forces = |d: &[Vector2<f64>; 3]| -> [SegmentForce; 3] {
            std::array::from_fn(|i| {
                let memory = (two(&c.plastic, i), two(&c.back, i));
                self.segments[i].pull(memory, d[i], dt, |speed| friction(i, speed))
            })
        };
        let first = inverses([0, 1, 2].map(|i| square(&c.k, i))).ok_or_else(no_force)?;
        let predicted_increment = square(&c.whole, 0) * (u - Vector2::from(c.u));
        let mut d: [Vector2<f64>; 3] = std::array::from_fn(|i| two(&c.d, i) + first[i] * predicted_increment);
        // Removes the round-off of the sum.
        d[0] += u - (d[0] + d[1] + d[2]);
        let mut at = segment_forces(&d);
        let mut smallest_residual = f64::INFINITY;
        for _ in 0..MAX_ITERATIONS {
            let inverses = inverses(at.map(|p| p.k)).ok_or_else(no_force)?;
            let whole = inverses.iter().sum::<Matrix2<f64>>().try_inverse().ok_or_else(no_force)?;
            let f = whole * (0..3).map(|i| inverses[i] * at[i].f).sum::<Vector2<f64>>();
            let residual = at.iter().map(|p| (p.f - f).norm()).fold(0.0, f64::max);
            let scale = f.norm() + at[0].mu.mu;
            if residual <= TOLERANCE * scale || (residual >= smallest_residual && residual <= STALLED_TOLERANCE * scale)
            {
                let by_normal: Vector2<f64> = (0..3).map(|i| inverses[i] * at[i].by_mu * at[i].mu.by_normal).sum();
                let mut state = ChainState {
                    u: u.into(),
                    whole: rows(&whole),
                    f: f.into(),
                    mu: at.map(|p| p.mu.mu),
                    speed: at.map(|p| p.speed),
                    ..ChainState::default()
                };
                (0..3).for_each(|i| state.set(i, d[i], &at[i]));
                let friction = at.map(|p| (p.speed, p.mu.mu));
                return Ok(ChainForce { state, k: whole, by_normal: whole * by_normal, friction });
            }
            smallest_residual = residual;
            let step: [Vector2<f64>; 3] = std::array::from_fn(|i| inverses[i] * (f - at[i].f));
            (d, at) = line_search(&segment_forces, (&d, &at), f, &step);
        }
        Err(no_force())
    }
}

/// Line search from the common force `f`. The step keeps the sum of the displacements. It ends close to the minimum of
/// the energy of the chain. The energy is convex, with kinks at the onset of sliding and at contact with the edge.
fn line_search(
    segment_forces: &impl Fn(&[Vector2<f64>; 3]) -> [SegmentForce; 3],
    (d, at): (&[Vector2<f64>; 3], &[SegmentForce; 3]),
    f: Vector2<f64>,
    step: &[Vector2<f64>; 3],
) -> ([Vector2<f64>; 3], [SegmentForce; 3]) {
    let slope = |p: &[SegmentForce; 3]| (0..3).map(|i| (p[i].f - f).dot(&step[i])).sum::<f64>();
    let initial_slope = slope(at);
    let (mut lo, mut hi, mut share) = ((0.0, initial_slope), None, 1.0);
    loop {
        let trial: [Vector2<f64>; 3] = std::array::from_fn(|i| d[i] + share * step[i]);
        let p = segment_forces(&trial);
        let g = slope(&p);
        let first = hi.is_none();
        if g > 0.0 {
            hi = Some((share, g))
        } else {
            lo = (share, g)
        }
        let (right, above) = hi.unwrap_or((1.0, -initial_slope));
        let width = right - lo.0;
        if (first && g <= -0.8 * initial_slope) || g.abs() <= -0.5 * initial_slope || width < 1e-9 {
            return (trial, p);
        }
        // Regula falsi, kept away from the ends of the bracket.
        let zero = lo.0 - lo.1 * width / (above - lo.1);
        share = zero.clamp(lo.0 + 0.1 * width, right - 0.1 * width);
    }
}

pub(super) fn no_force() -> ElementError {
    ElementError("no force of the triple friction pendulum belongs to this motion".into())
}
