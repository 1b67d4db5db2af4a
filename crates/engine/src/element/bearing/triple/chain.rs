//! Three segments in series.

use super::segment::{Pull, Segment};
use crate::element::ElementError;
use crate::element::friction::Coefficient;
use crate::state_struct;
use nalgebra::{Matrix2, Vector2};

state_struct! {
    /// History of a chain; the segments one after the other, x and y of each.
    pub struct ChainState {
        /// Displacement of the chain.
        u: [f64; 2],
        /// Displacement of the segments.
        d: [f64; 6],
        /// Plastic displacement.
        plastic: [f64; 6],
        /// Back force of the hardening.
        back: [f64; 6],
        /// Stiffness of the segments, by rows.
        k: [f64; 12],
        /// Stiffness of the chain, by rows.
        whole: [f64; 4],
        /// Force as a part of the weight.
        f: [f64; 2],
        /// Coefficients of friction that the force was found with.
        mu: [f64; 3],
        /// Speed of the segments.
        speed: [f64; 3],
    }
}

pub(super) fn two(words: &[f64], i: usize) -> Vector2<f64> {
    Vector2::new(words[2 * i], words[2 * i + 1])
}

pub(super) fn square(words: &[f64], i: usize) -> Matrix2<f64> {
    Matrix2::from_row_slice(&words[4 * i..4 * i + 4])
}

pub(super) fn rows(m: &Matrix2<f64>) -> [f64; 4] {
    [m[(0, 0)], m[(0, 1)], m[(1, 0)], m[(1, 1)]]
}

impl ChainState {
    /// Take over what segment `i` answers at displacement `d`.
    fn set(&mut self, i: usize, d: Vector2<f64>, p: &Pull) {
        self.set_memory(i, d, (p.plastic, p.back), &p.k);
    }

    /// Displacement of segment `i`, plastic displacement and back force, stiffness.
    pub(super) fn set_memory(
        &mut self,
        i: usize,
        d: Vector2<f64>,
        (plastic, back): (Vector2<f64>, Vector2<f64>),
        k: &Matrix2<f64>,
    ) {
        for (words, v) in [(&mut self.d, d), (&mut self.plastic, plastic), (&mut self.back, back)] {
            words[2 * i..2 * i + 2].copy_from_slice(v.as_slice());
        }
        self.k[4 * i..4 * i + 4].copy_from_slice(&rows(k));
    }
}

fn inverses(k: [Matrix2<f64>; 3]) -> Option<[Matrix2<f64>; 3]> {
    let [a, b, c] = k.map(|k| k.try_inverse());
    Some([a?, b?, c?])
}

/// Stiffness of segments in series.
pub(super) fn in_series(k: [Matrix2<f64>; 3]) -> Option<Matrix2<f64>> {
    inverses(k)?.iter().sum::<Matrix2<f64>>().try_inverse()
}

/// Three segments in series: the inner pair, the lower and the upper outer surface.
#[derive(Clone, Debug, PartialEq)]
pub struct Chain {
    /// The segments.
    pub segments: [Segment; 3],
}

/// The force of a chain.
pub struct Tension {
    pub(super) state: ChainState,
    /// Stiffness.
    pub(super) k: Matrix2<f64>,
    /// By the normal force, through the friction.
    pub(super) by_normal: Vector2<f64>,
    /// Speeds of the surfaces, with the coefficients of friction.
    pub(super) friction: [(f64, f64); 3],
}

const ROUNDS: usize = 100;

impl Chain {
    /// History at rest.
    pub fn virgin(&self) -> ChainState {
        let mut s = ChainState::default();
        let k = self.segments.map(|segment| Matrix2::from_diagonal_element(segment.e));
        for (words, k) in s.k.chunks_exact_mut(4).zip(&k) {
            words.copy_from_slice(&rows(k));
        }
        s.whole = rows(&in_series(k).unwrap_or_default());
        s
    }

    /// The force that holds the chain at displacement `u`, from the committed history: Newton's method for displacements
    /// that add up under a force that all segments share. `friction` gives the coefficient of a segment at the speed of
    /// its surface.
    ///
    /// # Errors
    /// Where no force is found.
    pub(super) fn stretch(
        &self,
        c: &ChainState,
        u: Vector2<f64>,
        dt: f64,
        friction: impl Fn(usize, f64) -> Coefficient,
    ) -> Result<Tension, ElementError> {
        let pulls = |d: &[Vector2<f64>; 3]| -> [Pull; 3] {
            std::array::from_fn(|i| {
                let memory = (two(&c.plastic, i), two(&c.back, i));
                self.segments[i].pull(memory, d[i], dt, |speed| friction(i, speed))
            })
        };
        let first = inverses([0, 1, 2].map(|i| square(&c.k, i))).ok_or_else(no_force)?;
        let ahead = square(&c.whole, 0) * (u - Vector2::from(c.u));
        let mut d: [Vector2<f64>; 3] = std::array::from_fn(|i| two(&c.d, i) + first[i] * ahead);
        // What round-off has left of the sum.
        d[0] += u - (d[0] + d[1] + d[2]);
        let mut at = pulls(&d);
        let mut least = f64::INFINITY;
        for _ in 0..ROUNDS {
            let inverses = inverses(at.map(|p| p.k)).ok_or_else(no_force)?;
            let whole = inverses.iter().sum::<Matrix2<f64>>().try_inverse().ok_or_else(no_force)?;
            let f = whole * (0..3).map(|i| inverses[i] * at[i].f).sum::<Vector2<f64>>();
            let misfit = at.iter().map(|p| (p.f - f).norm()).fold(0.0, f64::max);
            let scale = f.norm() + at[0].mu.mu;
            if misfit <= 1e-13 * scale || (misfit >= least && misfit <= 1e-10 * scale) {
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
                return Ok(Tension { state, k: whole, by_normal: whole * by_normal, friction });
            }
            least = misfit;
            let step: [Vector2<f64>; 3] = std::array::from_fn(|i| inverses[i] * (f - at[i].f));
            (d, at) = go_down(&pulls, (&d, &at), f, &step);
        }
        Err(no_force())
    }
}

/// Along a step from where the common force is `f`, which keeps the sum of the displacements, to where the energy of the chain
/// does not fall much more: it is convex, with kinks where a surface begins to slide or reaches its edge.
fn go_down(
    pulls: &impl Fn(&[Vector2<f64>; 3]) -> [Pull; 3],
    (d, at): (&[Vector2<f64>; 3], &[Pull; 3]),
    f: Vector2<f64>,
    step: &[Vector2<f64>; 3],
) -> ([Vector2<f64>; 3], [Pull; 3]) {
    let slope = |p: &[Pull; 3]| (0..3).map(|i| (p[i].f - f).dot(&step[i])).sum::<f64>();
    let begin = slope(at);
    let (mut lo, mut hi, mut share) = ((0.0, begin), None, 1.0);
    loop {
        let there: [Vector2<f64>; 3] = std::array::from_fn(|i| d[i] + share * step[i]);
        let p = pulls(&there);
        let g = slope(&p);
        let first = hi.is_none();
        if g > 0.0 {
            hi = Some((share, g))
        } else {
            lo = (share, g)
        }
        let (right, above) = hi.unwrap_or((1.0, -begin));
        let width = right - lo.0;
        if (first && g <= -0.8 * begin) || g.abs() <= -0.5 * begin || width < 1e-9 {
            return (there, p);
        }
        // False position, kept off the ends.
        let zero = lo.0 - lo.1 * width / (above - lo.1);
        share = zero.clamp(lo.0 + 0.1 * width, right - 0.1 * width);
    }
}

pub(super) fn no_force() -> ElementError {
    ElementError("no force of the triple friction pendulum belongs to this motion".into())
}
