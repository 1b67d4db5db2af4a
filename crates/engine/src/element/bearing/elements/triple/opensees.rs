//! Triple friction pendulums by OpenSees' rules.
//!
//! Increments from the committed force give the force of the chain to a relative tolerance; they are halved without
//! convergence. The friction has the speeds of the last trial. Both nodes have the same sign of the rotational moments.
//! The tangent omits the moments.

use super::bearing::{HEAT, Load, TriplePendulum, coefficient};
use super::chain::{Chain, ChainForce, ChainState, in_series, rows, square, two};
use super::heated::{Heated, Step};
use super::rules::{Rules, Vertical};
use super::segment::Segment;
use crate::element::friction::{Coefficient, Friction};
use crate::element::{ElementResult, Histories};
use crate::material::{Strain, Stress};
use crate::state_struct::StateStruct;
use nalgebra::{Matrix2, Vector2};

/// Iterations for a segment, and for the chain.
const ROUNDS: usize = 20;
/// Largest number of halvings of a step.
const HALVINGS: i32 = 7;

/// OpenSees' rules, with the tolerance of the command relative to the step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Increments(pub f64);

impl Rules for Increments {
    const MOMENT_AT_I: f64 = 1.0;
    const MOMENTS_IN_TANGENT: bool = false;
    const SHOWS_DISPLACEMENTS: bool = false;
    const CALL_DEPENDENT: bool = true;
    const DAMPS_IN_FORCES_ONLY: bool = true;

    /// OpenSees restores the last strain of the material, and reports the least normal force.
    fn lifted(
        self,
        bearing: &TriplePendulum<Self>,
        at: Vertical,
        mut s: Stress,
        h: &mut Histories<'_>,
    ) -> ElementResult<Stress> {
        let slot = &bearing.materials[0];
        let initial = slot.material.initial_tangent();
        let pulls = s.value > initial * f64::EPSILON;
        if pulls {
            slot.update(h.committed, Strain { value: at.last, rate: 0.0, dt: at.dt }, h.trial)?;
        }
        s.tangent = if pulls { bearing.setting.k_tension } else { initial };
        Ok(Stress { value: -bearing.setting.least_normal, ..s })
    }

    fn shear(
        self,
        bearing: &TriplePendulum<Self>,
        (u, dt): (Vector2<f64>, f64),
        (c, last): (&ChainState, &ChainState),
        load: &mut Load,
        frictions: &[Friction; 3],
    ) -> ElementResult<ChainForce> {
        let chain = &bearing.chain;
        load.speed = [0, 1, 2].map(|i| chain.segments[i].speed * last.speed[i]);
        load.mu = [0, 1, 2].map(|i| coefficient(frictions, i, load.mean, load.speed[i]).mu);
        Ok(as_found(chain.stretch_by_increments(c, u, load.mu, (self.0, 0.01), (last.speed, dt))))
    }

    fn heated_shear(
        self,
        (bearing, heated): (&TriplePendulum<Self>, &Heated),
        (u, step): (Vector2<f64>, Step),
        (before, load): (&Load, &mut Load),
        h: &mut Histories<'_>,
    ) -> ElementResult<ChainForce> {
        let c = ChainState::read(h.committed);
        load.mu = heated.warm_first(before.normal, step, &mut h.part(HEAT..));
        let chain = &bearing.chain;
        let t = as_found(chain.stretch_by_increments(&c, u, load.mu, (self.0, 1e-4), ([0.0; 3], 0.0)));
        heated.slide_late((&t.state, &c), step, &mut h.part(HEAT..));
        Ok(t)
    }

    fn by_vertical(_: &Stress, _: &Vector2<f64>, _: f64, _: &Vector2<f64>) -> Vector2<f64> {
        Vector2::zeros()
    }
}

/// The force of a chain with the tangent of its last iteration.
fn as_found(state: ChainState) -> ChainForce {
    let k = square(&state.whole, 0);
    ChainForce { state, k, by_normal: Vector2::zeros(), friction: [(0.0, 0.0); 3] }
}

/// An iterate of the displacements of the surfaces.
#[derive(Clone)]
struct Iterate {
    d: [Vector2<f64>; 3],
    k: [Matrix2<f64>; 3],
    whole: Matrix2<f64>,
    f: Vector2<f64>,
    /// Plastic displacement and back force at the begin of the increment.
    memory: [(Vector2<f64>, Vector2<f64>); 3],
    /// The same at its end.
    found: [(Vector2<f64>, Vector2<f64>); 3],
}

impl Iterate {
    fn from(c: &ChainState) -> Self {
        let memory = std::array::from_fn(|i| (two(&c.plastic, i), two(&c.back, i)));
        Self {
            d: std::array::from_fn(|i| two(&c.d, i)),
            k: std::array::from_fn(|i| square(&c.k, i)),
            whole: square(&c.whole, 0),
            f: Vector2::from(c.f),
            memory,
            found: memory,
        }
    }
}

impl Chain {
    /// Force at displacement `u` under the coefficients `mu`; the tolerance is a part of the step. The last state stays
    /// where nothing converges, and `last` speeds where nothing moves; segments iterate to the tolerance times `fine`.
    pub(super) fn stretch_by_increments(
        &self,
        c: &ChainState,
        u: Vector2<f64>,
        mu: [f64; 3],
        (tolerance, fine): (f64, f64),
        (last, dt): ([f64; 3], f64),
    ) -> ChainState {
        let begin = Iterate::from(c);
        let mut iterate = begin.clone();
        let (from, du) = (Vector2::from(c.u), u - Vector2::from(c.u));
        let tolerance = du.norm() * tolerance;
        let change: [f64; 3] = std::array::from_fn(|i| mu[i] - c.mu[i]);
        let (mut part, mut gone, mut now, mut speed) = (1.0, Vector2::zeros(), c.mu, last);
        let (mut halvings, mut steps) = (0, 0);
        while halvings < 10 && (du - gone).norm() > tolerance {
            for (now, change) in now.iter_mut().zip(&change) {
                *now += part * change;
            }
            let converged = self.increment(&mut iterate, from + gone + part * du, part * du, now, (tolerance, fine));
            if !converged && halvings < HALVINGS {
                iterate = begin.clone();
                (gone, now, steps) = (Vector2::zeros(), c.mu, 0);
                part *= 0.5;
                halvings += 1;
            } else {
                if f64::from(steps) >= 2f64.powi(halvings) {
                    break;
                }
                iterate.memory = iterate.found;
                gone += part * du;
                steps += 1;
            }
            if dt > 0.0 {
                speed = std::array::from_fn(|i| (iterate.d[i] - two(&c.d, i)).norm() / dt);
            }
        }
        let mut s = ChainState {
            whole: rows(&iterate.whole),
            f: iterate.f.into(),
            mu: now,
            speed,
            u: u.into(),
            ..ChainState::default()
        };
        for i in 0..3 {
            s.set_memory(i, iterate.d[i], iterate.found[i], &iterate.k[i]);
        }
        s
    }

    /// One increment `du` to displacement `u`; whether it converged.
    fn increment(
        &self,
        iterate: &mut Iterate,
        u: Vector2<f64>,
        du: Vector2<f64>,
        mu: [f64; 3],
        (tolerance, fine): (f64, f64),
    ) -> bool {
        let mut left = du;
        let mut rounds = 1;
        iterate.found = iterate.memory;
        while rounds == 1 || (left.norm() > tolerance && rounds <= ROUNDS) {
            rounds += 1;
            let df = iterate.whole * left;
            for (i, segment) in self.segments.iter().enumerate() {
                if !pull_by(segment, iterate, i, df, mu[i], fine * tolerance) {
                    return false;
                }
            }
            iterate.f += df;
            left = u - (iterate.d[0] + iterate.d[1] + iterate.d[2]);
            let Some(whole) = in_series(iterate.k) else { return false };
            iterate.whole = whole;
        }
        rounds <= ROUNDS
    }
}

/// Move segment `i` until its force has grown by `df`; whether it converged.
fn pull_by(segment: &Segment, iterate: &mut Iterate, i: usize, df: Vector2<f64>, mu: f64, tolerance: f64) -> bool {
    iterate.found[i] = iterate.memory[i];
    let Some(inverse) = iterate.k[i].try_inverse() else { return false };
    let friction = Coefficient { mu, ..Coefficient::default() };
    let mut step = inverse * df;
    let mut rounds = 1;
    while rounds == 1 || (step.norm() > tolerance && rounds <= ROUNDS) {
        rounds += 1;
        iterate.d[i] += step;
        let p = segment.pull(iterate.memory[i], iterate.d[i], 0.0, |_| friction);
        (iterate.k[i], iterate.found[i]) = (p.k, (p.plastic, p.back));
        let Some(inverse) = p.k.try_inverse() else { return false };
        step = inverse * (iterate.f + df - p.f);
    }
    rounds <= ROUNDS
}
