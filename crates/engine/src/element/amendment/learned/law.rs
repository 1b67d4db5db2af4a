//! A learned law of one direction.

use super::history::{History, Scales};
use super::operators;
use super::variable::{Moment, Variable};
use crate::state_struct::StateStruct;

/// Part of the force on which a factor acts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Target {
    /// Spring and its pieces.
    Elastic,
    /// Hysteretic part.
    Hysteretic,
    /// Viscous parts.
    Viscous,
    /// Elastic, hysteretic and viscous parts.
    Whole,
    /// Slip level of the hysteretic part.
    Strength,
}

/// Form of the hysteretic part.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// A stop.
    Bilinear,
    /// Bouc and Wen's, of exponent one.
    BoucWen,
    /// Slopes over the initial one, evenly from unloading at the level to loading at it; an odd number.
    Curve(Vec<f64>),
    /// The force of the element's own law.
    Own,
}

/// A factor of a part of the force: the coefficient times a slow variable, within the range of the fitted motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Factor {
    /// Part on which it acts.
    pub target: Target,
    /// Slow variable φ.
    pub variable: Variable,
    /// Coefficient a of 1 + Σ a φ.
    pub coefficient: f64,
    /// Least and largest value of φ seen.
    pub range: [f64; 2],
}

/// A force that follows a channel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChannelForce {
    /// Number of the channel, from 0.
    pub channel: usize,
    /// Force at x = 1.
    pub coefficient: f64,
    /// Least and largest value of x seen.
    pub range: [f64; 2],
}

/// A recorded or imposed quantity beside the motion.
#[derive(Clone, Debug, PartialEq)]
pub struct Channel {
    /// Its name.
    pub name: String,
    /// Mean of the fitted motions.
    pub mean: f64,
    /// Standard deviation there.
    pub deviation: f64,
}

/// A piece of the spring beyond a deformation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Piece {
    /// Side 1 or -1; 0 for both.
    pub side: f64,
    /// Deformation at which it begins.
    pub at: f64,
    /// Its stiffness, of either sign.
    pub stiffness: f64,
}

/// A law with memory, in one direction:
///
/// f = g_E(q) E(u) + g_H(q) H(u; g_S(q)) + g_X(q) X(u, u̇) + k_m (u - u_m) + F, each g = 1 + Σ a φ(q),
///
/// with the middle u_m of the extremes so far.
#[derive(Clone, Debug, PartialEq)]
pub struct LearnedLaw {
    /// Scales of the fitted motions.
    pub scales: Scales,
    /// Stiffness of the spring.
    pub spring: f64,
    /// Pieces of the spring.
    pub pieces: Vec<Piece>,
    /// Stiffness of a spring about the middle of the extremes so far.
    pub moving: f64,
    /// Form of the hysteretic part.
    pub shape: Shape,
    /// Its strength at a factor of one; of [`Shape::Own`] the factor of the element's force.
    pub strength: f64,
    /// Further strength of the positive side.
    pub unequal: f64,
    /// Level and strength of further stops.
    pub stops: Vec<[f64; 2]>,
    /// Time constant and stiffness of Maxwell elements.
    pub maxwell: Vec<[f64; 2]>,
    /// Power and coefficient of dashpots c (|v|/V)^p.
    pub dashpots: Vec<[f64; 2]>,
    /// Width over V and force of friction smoothed over the speed.
    pub viscous: Vec<[f64; 2]>,
    /// Factors.
    pub factors: Vec<Factor>,
    /// Channels that the factors follow.
    pub channels: Vec<Channel>,
    /// Forces that follow a channel.
    pub forces: Vec<ChannelForce>,
    /// Returns true if slow variables go on beyond the range seen.
    pub goes_on: bool,
}

/// Least and largest factor.
pub const FACTOR_RANGE: [f64; 2] = [0.05, 5.0];

/// A step of one direction.
#[derive(Clone, Copy, Debug)]
pub struct LawStep<'a> {
    /// Deformation at its end.
    pub deformation: f64,
    /// Its length in time.
    pub dt: f64,
    /// Force of the element's own law.
    pub own: f64,
    /// Channels at its end.
    pub channels: &'a [f64],
}

/// Force of a step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LawForce {
    /// Force.
    pub force: f64,
    /// Derivative with respect to the deformation.
    pub by_deformation: f64,
    /// Derivative with respect to the force of the element's own law.
    pub by_own: f64,
}

/// Sum of the parts of a force, with its derivative.
#[derive(Clone, Copy, Default)]
struct Sum([f64; 2]);

impl Sum {
    fn add(&mut self, weight: f64, (value, slope): (f64, f64)) {
        self.0[0] += weight * value;
        self.0[1] += weight * slope;
    }
}

/// Factors of the parts, and the derivative of that of the spring.
struct Factors {
    elastic: f64,
    elastic_slope: f64,
    hysteretic: f64,
    viscous: f64,
    strength: f64,
}

impl LearnedLaw {
    /// Number of state variables of one direction.
    pub fn state_len(&self) -> usize {
        self.stops_at() + self.stops.len() + self.maxwell.len()
    }

    /// Index of the hysteretic variable; one of each factor follows.
    const HYSTERETIC_AT: usize = History::LEN;

    fn stops_at(&self) -> usize {
        Self::HYSTERETIC_AT + 1 + self.factors.len()
    }

    /// Value of x for a channel: less its mean, over three standard deviations.
    pub fn scaled_channel(&self, channel: usize, value: f64) -> f64 {
        let c = &self.channels[channel];
        (value - c.mean) / (3.0 * c.deviation)
    }

    fn factors(&self, state: &[f64], h: &History, step: &LawStep<'_>) -> Factors {
        let committed = Moment { deformation: h.deformation, channels: step.channels };
        let trial = Moment { deformation: step.deformation, channels: step.channels };
        let (mut e, mut hy, mut x, mut s, mut slope) = (1.0, 1.0, 1.0, 1.0, 0.0);
        for (k, f) in self.factors.iter().enumerate() {
            // A spring with a factor of its deformation is another spring: it has a potential.
            let is_elastic = f.target == Target::Elastic;
            let moment = if is_elastic { &trial } else { &committed };
            let (value, by) = f.variable.value(state[Self::HYSTERETIC_AT + 1 + k], &self.scales, h, moment);
            let is_within = self.goes_on || (f.range[0]..=f.range[1]).contains(&value);
            let value = if self.goes_on { value } else { value.clamp(f.range[0], f.range[1]) };
            let part = f.coefficient * value;
            match f.target {
                Target::Elastic => {
                    e += part;
                    slope += if is_within { f.coefficient * by } else { 0.0 };
                }
                Target::Hysteretic => hy += part,
                Target::Viscous => x += part,
                Target::Whole => (e, hy, x) = (e + part, hy + part, x + part),
                Target::Strength => s += part,
            }
        }
        let [low, high] = FACTOR_RANGE;
        let elastic_slope = if (low..=high).contains(&e) { slope } else { 0.0 };
        Factors {
            elastic: e.clamp(low, high),
            elastic_slope,
            hysteretic: hy.clamp(low, high),
            viscous: x.clamp(low, high),
            strength: s.clamp(low, high),
        }
    }

    /// Force of the spring without its factor, and its derivative.
    fn elastic(&self, u: f64) -> Sum {
        let mut sum = Sum::default();
        sum.add(self.spring, (u, 1.0));
        for p in &self.pieces {
            sum.add(p.stiffness, operators::piece(u, p.side, p.at));
        }
        sum
    }

    /// Force of a step from a committed state; writes all entries of `next`.
    pub fn step(&self, committed: &[f64], step: &LawStep<'_>, next: &mut [f64]) -> LawForce {
        let h = History::read(committed);
        let (u, dt) = (step.deformation, step.dt);
        let du = u - h.deformation;
        let g = self.factors(committed, &h, step);
        let Sum([elastic, elastic_slope]) = self.elastic(u);
        let mut out = LawForce {
            force: g.elastic * elastic + self.moving * (u - h.middle()),
            by_deformation: g.elastic * elastic_slope + g.elastic_slope * elastic + self.moving,
            by_own: 0.0,
        };
        let mut hysteretic = Sum::default();
        let level = self.scales.level;
        let z = committed[Self::HYSTERETIC_AT];
        let reached = match &self.shape {
            Shape::Bilinear => {
                let r = level * g.strength;
                (operators::stop(z, du, r), operators::stop_slope(z, du, r))
            }
            Shape::BoucWen => operators::bouc_wen(z, du, level * g.strength),
            Shape::Curve(knots) => operators::curve(z, du, level * g.strength, knots),
            Shape::Own => (0.0, 0.0),
        };
        next[Self::HYSTERETIC_AT] = reached.0;
        let scaled = (reached.0 / level, reached.1 / level);
        if self.shape == Shape::Own {
            let strength = self.strength + if step.own > 0.0 { self.unequal } else { 0.0 };
            out.force += g.hysteretic * strength * step.own;
            out.by_own = g.hysteretic * strength;
        } else {
            hysteretic.add(self.strength, scaled);
            if scaled.0 > 0.0 {
                hysteretic.add(self.unequal, scaled);
            }
        }
        let stops_at = self.stops_at();
        for (k, [level, strength]) in self.stops.iter().enumerate() {
            let (s, r) = (committed[stops_at + k], level * g.strength);
            next[stops_at + k] = operators::stop(s, du, r);
            hysteretic.add(strength / level, (next[stops_at + k], operators::stop_slope(s, du, r)));
        }
        let viscous_at = stops_at + self.stops.len();
        let viscous = self.viscous_part(&committed[viscous_at..], du, dt, &mut next[viscous_at..]);
        for (factor, Sum([force, slope])) in [(g.hysteretic, hysteretic), (g.viscous, viscous)] {
            out.force += factor * force;
            out.by_deformation += factor * slope;
        }
        for f in &self.forces {
            let x = step.channels.get(f.channel).copied().unwrap_or(0.0);
            out.force += f.coefficient * if self.goes_on { x } else { x.clamp(f.range[0], f.range[1]) };
        }
        let after = h.next(&self.scales, u, dt);
        after.write(next);
        for (k, f) in self.factors.iter().enumerate() {
            let at = Self::HYSTERETIC_AT + 1 + k;
            next[at] = f.variable.next(committed[at], &self.scales, &h, &after, step.channels);
        }
        out
    }

    /// Maxwell elements, dashpots and smoothed friction; the state variables are those of the Maxwell elements.
    fn viscous_part(&self, committed: &[f64], du: f64, dt: f64, next: &mut [f64]) -> Sum {
        let mut sum = Sum::default();
        for (k, [constant, stiffness]) in self.maxwell.iter().enumerate() {
            let (h, slope) = operators::maxwell(committed[k], du, dt, *constant);
            next[k] = h;
            sum.add(*stiffness, (h, slope));
        }
        if dt > 0.0 {
            let v = du / dt / self.scales.speed;
            let by_u = 1.0 / (dt * self.scales.speed);
            let mut add = |weight: f64, (f, slope): (f64, f64)| sum.add(weight, (f, slope * by_u));
            self.dashpots.iter().for_each(|[power, c]| add(*c, operators::dashpot(v, *power)));
            self.viscous.iter().for_each(|[width, c]| add(*c, operators::smoothed_friction(v, *width)));
        }
        sum
    }

    /// The law with its forces times a factor. That of the element's own law keeps its own.
    #[must_use]
    pub fn with_forces_times(&self, factor: f64) -> Self {
        let mut out = self.clone();
        let is_own = out.shape == Shape::Own;
        let hysteretic = [&mut out.strength, &mut out.unequal].into_iter().filter(|_| !is_own);
        let lists = [&mut out.stops, &mut out.maxwell, &mut out.dashpots, &mut out.viscous];
        let of_lists = lists.into_iter().flatten().map(|[_, weight]| weight);
        let pieces = out.pieces.iter_mut().map(|p| &mut p.stiffness);
        let forces = out.forces.iter_mut().map(|f| &mut f.coefficient);
        let lone = [&mut out.spring, &mut out.moving].into_iter();
        lone.chain(hysteretic).chain(of_lists).chain(pieces).chain(forces).for_each(|x| *x *= factor);
        out
    }

    /// Force along a motion from rest, and the share of its steps outside the range of the law.
    ///
    /// `own` is the force of the element's own law, for a law of [`Shape::Own`]; `channels` are the recorded values, one
    /// series for each channel. All series have the length of the motion.
    pub fn along(&self, u: &[f64], t: &[f64], own: &[f64], channels: &[&[f64]]) -> (Vec<f64>, f64) {
        let mut state = vec![0.0; self.state_len()];
        let mut next = state.clone();
        let start = u.first().copied().unwrap_or(0.0);
        History { deformation: start, largest: [start.max(0.0), (-start).max(0.0)], ..History::default() }
            .write(&mut state);
        let mut scaled = vec![0.0; channels.len()];
        let force = (0..u.len())
            .map(|j| {
                for (k, (x, values)) in scaled.iter_mut().zip(channels).enumerate() {
                    *x = self.scaled_channel(k, values[j]);
                }
                let dt = if j > 0 { t[j] - t[j - 1] } else { 0.0 };
                let own = own.get(j).copied().unwrap_or(0.0);
                let step = LawStep { deformation: u[j], dt, own, channels: &scaled };
                let force = self.step(&state, &step, &mut next).force;
                std::mem::swap(&mut state, &mut next);
                force
            })
            .collect();
        let h = History::read(&state);
        (force, h.outside / h.steps.max(1.0))
    }
}
