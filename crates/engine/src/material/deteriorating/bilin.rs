//! Deteriorating plastic hinges: the modified Ibarra-Medina-Krawinkler law with bilinear hysteresis.

mod backbone;
mod opensees;
mod rules;

use super::hinge::{Envelope, FLAT, NOTHING, no_force, of_hinge, of_member};
use crate::material::{MaterialResult, Strain, Stress, UniaxialLaw};
use crate::rules::Consistent;
pub use backbone::BilinSide;
use backbone::{Backbone, Line, meet};
use rules::Rules;
use std::cmp::Ordering;

/// Smallest unloading stiffness divided by the initial one.
const LEAST_UNLOADING: f64 = 0.1;
/// Post-capping slope divided by the initial stiffness below which a branch counts as horizontal.
const LEVEL: f64 = 1e-3;

/// Deterioration of one mode with the dissipated energy: β = (E / (E_ref - ΣE))ᶜ, with E the energy of the excursion.
/// The reference energy E_ref is Λ My⁺, and twice that for the unloading stiffness.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Deterioration {
    /// Cumulative rotation capacity Λ; zero for no deterioration.
    pub capacity: f64,
    /// Rate c.
    pub exponent: f64,
}

impl Deterioration {
    /// β for the energy of an excursion and the remaining reference energy.
    #[inline]
    pub(super) fn beta(&self, excursion: f64, left: f64) -> f64 {
        if self.capacity == 0.0 {
            return 0.0;
        }
        // The power is undefined if an excursion returned more energy than it took.
        let beta = (excursion / left).powf(self.exponent);
        if beta.is_nan() { 0.0 } else { beta }
    }
}

/// Bilinear hysteresis on a backbone with a cap, a residual strength and an ultimate deformation. Strength, cap and
/// unloading stiffness deteriorate with the dissipated energy (Ibarra, Medina and Krawinkler, 2005,
/// <https://doi.org/10.1002/eqe.495>; Lignos and Krawinkler, 2011,
/// <https://doi.org/10.1061/(ASCE)ST.1943-541X.0000376>).
///
/// A hinge in series with an elastic member is (1 + n) times as stiff as the member. Its slopes are those with which
/// member and hinge together follow the given ones (Ribeiro, Barbosa, Scott and Neves, 2015). For a hinge, forces are
/// moments and deformations are rotations.
#[derive(Clone, Debug, PartialEq)]
pub struct Bilin<R = Consistent> {
    /// Elastic stiffness of the member.
    pub ke: f64,
    /// Backbones for positive and negative deformations.
    pub sides: [BilinSide; 2],
    /// Deterioration of yield strength and hardening.
    pub strength: Deterioration,
    /// Deterioration of the strength beyond the cap.
    pub capping: Deterioration,
    /// Deterioration of the unloading stiffness.
    pub stiffness: Deterioration,
    /// Stiffness of the hinge divided by that of the member, minus one: n.
    pub n: f64,
    /// The slope beyond the cap does not deteriorate, as in `Bilin02`.
    pub steady_cap: bool,
    /// Rules of a few turns and of the tangent.
    pub rules: R,
}

crate::state_struct! {
    /// History of [`Bilin`].
    pub struct History {
        /// Deformation.
        strain: f64,
        /// Force.
        stress: f64,
        /// Slope of the branch, by which some rules identify the branch.
        slope: f64,
        /// Tangent.
        tangent: f64,
        /// 1 going up, -1 going down, 0 virgin.
        direction: f64,
        /// Unloading stiffness.
        unloading: f64,
        /// Unloading stiffness at the last deterioration of the backbone.
        excursion_unloading: f64,
        /// Dissipated and stored energy.
        energy: f64,
        /// Dissipated and stored energy of the present excursion.
        excursion_energy: f64,
        /// Product of (1 - β) over the deteriorations of the unloading stiffness.
        stiffness_left: f64,
        /// 1 if the backbone has deteriorated and has not been reached since.
        relieved: f64,
        /// 1 if deterioration has ended.
        settled: f64,
        /// 1 if all strength is lost.
        lost: f64,
        /// Backbones of the two sides, with positive deformations and forces.
        sides: [Backbone; 2],
    }
}

/// Start and end of a step, with the signs of the side it moves to.
#[derive(Clone, Copy)]
struct Step {
    /// 1 for increasing, -1 for decreasing deformation.
    sign: f64,
    /// Index of the side it moves to, and of the other side.
    ahead: usize,
    behind: usize,
    from: f64,
    force: f64,
    to: f64,
}

impl Step {
    /// Unloading line through the start of the step.
    fn line(&self, unloading: f64) -> Line {
        Line { x: self.from, y: self.force, slope: unloading }
    }
}

impl<R: Rules> Bilin<R> {
    /// Stiffness of the hinge.
    fn k(&self) -> f64 {
        self.ke * (1.0 + self.n)
    }

    /// The virgin state.
    fn virgin(&self) -> History {
        let k = self.k();
        let sides = self.sides.map(|side| self.virgin_side(&side));
        History {
            unloading: k,
            excursion_unloading: k,
            slope: k,
            tangent: k,
            stiffness_left: 1.0,
            sides,
            ..History::default()
        }
    }

    fn virgin_side(&self, side: &BilinSide) -> Backbone {
        let (Envelope { stiffness, strength, hardening, softening, cap }, cap_force, cap_intercept) =
            Envelope::virgin(side, self.ke, self.n);
        Backbone {
            strength,
            hardening,
            cap_slope: softening,
            first_cap_slope: softening,
            cap,
            cap_force,
            cap_intercept,
            reach: strength / stiffness,
            target_force: strength,
            ..Backbone::default()
        }
    }

    /// Updates the state for a reversal at the start of a step.
    fn turn(&self, c: &History, step: &Step, t: &mut History) {
        let (k, s) = (self.k(), step);
        let behind = &mut t.sides[s.behind];
        if -s.from >= behind.reach {
            (behind.limit, behind.limit_force) = (-s.from, -s.force);
        }
        let recoverable = self.recoverable(s, t);
        let reference = 2.0 * self.sides[0].strength * self.stiffness.capacity;
        let spent = t.energy - recoverable;
        if self.stiffness.capacity != 0.0 {
            if reference - spent <= 0.0 {
                t.lost = 1.0;
            }
            self.soften(s, spent, reference, recoverable, t);
        }
        let yielded = [0, 1].map(|i| self.sides[i].strength / k);
        if t.sides[0].reach > yielded[0] || t.sides[1].reach > yielded[1] {
            let before = -t.sides[s.behind].target;
            if s.from < before || (s.from > before && c.slope == t.unloading) {
                let side = &mut t.sides[s.ahead];
                side.aim(&self.sides[s.ahead], s.line(t.unloading), k);
                // An offset distinguishes a target at the first yield point from the virgin one.
                if (side.reach - yielded[s.ahead]).abs() >= 1e-10 && (side.target - yielded[s.ahead]).abs() <= 1e-10 {
                    side.target = yielded[s.ahead] - R::before_yield(s.sign);
                }
            }
        }
        let gone = t.sides[s.behind];
        let side = &mut t.sides[s.ahead];
        side.reach = side.reach.max(side.target);
        if gone.exhausted != 0.0 && s.from <= -gone.resume {
            (side.target, side.target_force) = (-gone.resume - 1e-6, 0.0);
        }
    }

    /// Recoverable energy at a reversal.
    fn recoverable(&self, s: &Step, t: &History) -> f64 {
        let ahead = &t.sides[s.ahead];
        if ahead.target_force > 0.0 {
            return 0.5 * s.force * s.force / t.unloading;
        }
        // A side without strength stores no energy, with or without hardening.
        let triangle = match ahead.target_force {
            0.0 => 0.0,
            force => 0.5 * force * force / (self.k() * ahead.hardening),
        };
        let forces = R::unloading_forces(s.sign, s.force, ahead.target_force, t.sides[s.behind].target_force);
        0.5 * forces * (ahead.target - s.from) + triangle
    }

    /// Deterioration of the unloading stiffness at a reversal.
    fn soften(&self, s: &Step, spent: f64, reference: f64, recoverable: f64, t: &mut History) {
        let k = self.k();
        let level = |i: usize| (t.sides[i].cap_slope * (1.0 + self.n)).abs() < LEVEL;
        let inside = s.to >= -t.sides[s.behind].target;
        if inside || R::keeps_stiffness(s.sign, t.settled != 0.0, level) {
            return;
        }
        let mut beta = self.stiffness.beta(t.excursion_energy - recoverable, reference - spent);
        if spent >= reference || beta >= 1.0 {
            beta = 1.0;
        }
        let left = t.stiffness_left * (1.0 - beta);
        t.unloading = if t.settled == 0.0 { k * of_hinge(self.n, left) } else { t.excursion_unloading };
        t.unloading = t.unloading.max(of_hinge(self.n, LEAST_UNLOADING) * k);
        t.stiffness_left = left;
    }

    /// Force at the end of a step and slope of its branch, with the signs of the side it moves to.
    fn advance(&self, s: &Step, c: &History, t: &mut History) -> (f64, f64) {
        let (k, x) = (self.k(), s.to);
        let rule = &self.sides[s.ahead];
        let (ahead, behind) = (t.sides[s.ahead], t.sides[s.behind]);
        let residual = rule.residual * rule.strength;
        let elastic = (s.force + t.unloading * (x - s.from), t.unloading);
        let (no_ahead, no_behind) = (ahead.exhausted != 0.0, behind.exhausted != 0.0);
        let at_residual = no_ahead && (no_behind || x > ahead.target);
        if x >= rule.ultimate || (t.lost != 0.0 && !(no_ahead && no_behind)) {
            t.settled = 1.0;
            if !(at_residual && R::SPARES_RESIDUAL) {
                t.lost = 1.0;
            }
            (NOTHING, FLAT)
        } else if at_residual {
            (residual, FLAT)
        } else if no_ahead {
            elastic
        } else if no_behind && x < -behind.resume {
            (0.0, FLAT)
        } else if x > ahead.reach {
            let (force, slope) = self.envelope(s.ahead, x, t);
            let side = &mut t.sides[s.ahead];
            side.reach = x;
            if x > side.bound(&behind, k) || slope == FLAT {
                side.exhausted = 1.0;
            }
            (force, slope)
        } else if ahead.target.abs() <= 1e-10 {
            if x > 0.0 {
                self.envelope(s.ahead, x, t)
            } else {
                let (force, slope) = self.envelope(s.behind, -x, t);
                (-force, slope)
            }
        } else if ahead.level != 0.0 {
            let on_backbone = ahead.target == ahead.target_backbone;
            let hardens = match x.partial_cmp(&ahead.level_end) {
                Some(Ordering::Less) => on_backbone || no_behind,
                Some(Ordering::Equal) => on_backbone && s.sign > 0.0,
                _ => false,
            };
            if x <= ahead.target {
                elastic
            } else if hardens {
                lower(elastic, ahead.harden(x, k))
            } else {
                lower(elastic, (ahead.limit_force, if s.sign > 0.0 { 0.0 } else { FLAT }))
            }
        } else if ahead.cap <= ahead.strength / k {
            self.to_cap_before_yield(s, t, elastic)
        } else {
            self.to_cap(s, c, t, elastic, residual)
        }
    }

    /// Force and slope on the backbone of a side; beyond its ultimate deformation all strength is lost.
    fn envelope(&self, side: usize, x: f64, t: &mut History) -> (f64, f64) {
        if x >= self.sides[side].ultimate {
            t.lost = 1.0;
            return (if side == 0 { NOTHING } else { -NOTHING }, FLAT);
        }
        t.sides[side].at(&self.sides[side], x, self.k())
    }

    /// Reloads towards a backbone whose cap precedes its yield point.
    fn to_cap_before_yield(&self, s: &Step, t: &mut History, elastic: (f64, f64)) -> (f64, f64) {
        let (k, x, side) = (self.k(), s.to, t.sides[s.ahead]);
        let cap = Line { x: side.cap, y: side.cap_force, slope: side.cap_slope * k };
        let from = |slope| meet(&Line { x: side.target, y: side.target_force, slope }, &cap);
        let (by_hardening, by_unloading) = (from(k * side.hardening), from(t.unloading));
        let (end, end_force) = if by_hardening.0 > by_unloading.0 { by_hardening } else { by_unloading };
        if x <= end {
            return if x <= side.target { elastic } else { R::lower(s.sign, elastic, side.harden(x, k)) };
        }
        let on_cap = R::lower(s.sign, elastic, (end_force + cap.slope * (x - end), cap.slope));
        self.stop_at_zero(s, on_cap, t)
    }

    /// Reloads towards the hardening branch, the post-capping branch and the residual strength.
    fn to_cap(&self, s: &Step, c: &History, t: &mut History, elastic: (f64, f64), residual: f64) -> (f64, f64) {
        let (k, x, side) = (self.k(), s.to, t.sides[s.ahead]);
        let cap = Line { x: side.cap, y: side.cap_force, slope: side.cap_slope * k };
        let target = Line { x: side.target, y: side.target_force, slope: k * side.hardening };
        let known = R::before_cap(x, || meet(&target, &cap).0);
        let answer = if known && x <= side.target {
            elastic
        } else if known && x <= side.cap {
            lower(elastic, side.harden(x, k))
        } else if x > side.cap {
            let on_cap = lower(elastic, (side.cap_force + cap.slope * (x - side.cap), cap.slope));
            self.stop_at_zero(s, on_cap, t)
        } else {
            (0.0, c.slope)
        };
        let answer = if x <= side.cap + (residual - side.cap_force) / cap.slope {
            answer
        } else {
            R::residual(elastic, residual)
        };
        if t.lost != 0.0 { (s.sign * NOTHING, answer.1) } else { answer }
    }

    /// A post-capping branch ends at zero force, where all strength is lost.
    fn stop_at_zero(&self, s: &Step, (force, slope): (f64, f64), t: &mut History) -> (f64, f64) {
        if slope == t.unloading || force * s.force >= 0.0 || !R::may_stop(s.force) {
            return (force, slope);
        }
        t.sides[if s.force > 0.0 { s.ahead } else { s.behind }].exhausted = 1.0;
        t.lost = 1.0;
        (0.0, FLAT)
    }

    /// Deterioration of the side ahead at a change of sign of the force. Returns force, slope and deformation at the
    /// end of the step.
    fn deteriorate(&self, s: &Step, force: f64, t: &mut History) -> (f64, f64, f64) {
        let (k, rule) = (self.k(), &self.sides[s.ahead]);
        let reference = |d: &Deterioration| self.sides[0].strength * d.capacity;
        let used_up = |d: &Deterioration| d.capacity != 0.0 && t.energy >= reference(d);
        let beta = |d: &Deterioration| {
            let beta = d.beta(t.excursion_energy, reference(d) - t.energy);
            if beta.abs() >= 1.0 { 1.0 } else { beta }
        };
        let [by_strength, by_cap] = if used_up(&self.strength) {
            [1.0, 0.0]
        } else if used_up(&self.capping) {
            [0.0, 1.0]
        } else {
            [beta(&self.strength), beta(&self.capping)]
        };
        (t.excursion_energy, t.excursion_unloading) = (0.0, t.unloading);
        let mut side = t.sides[s.ahead];
        side.strength *= 1.0 - by_strength * rule.rate;
        side.hardening = of_hinge(self.n, of_member(self.n, side.hardening) * (1.0 - by_strength * rule.rate));
        side.cap_intercept *= 1.0 - by_cap * rule.rate;
        let residual = rule.residual * rule.strength;
        if side.strength <= residual {
            (side.strength, side.hardening) = (residual, 1e-4);
            (side.cap_intercept, side.cap_slope) = (residual, -1e-6);
            t.settled = 1.0;
        } else if !self.steady_cap {
            let kept = ((residual - side.strength) / (residual - rule.strength)).abs();
            side.cap_slope = of_hinge(self.n, of_member(self.n, side.first_cap_slope) * kept);
            if side.cap_slope >= 0.0 {
                side.cap_slope = -1e-6;
            }
        }
        side.move_cap(k);
        t.sides[s.ahead] = side;
        let (limit_force, slope) = self.envelope(s.ahead, side.limit, t);
        let side = &mut t.sides[s.ahead];
        (side.limit, side.limit_force) = (side.limit.min(rule.ultimate), limit_force);
        side.aim(rule, s.line(t.unloading), k);
        if side.target_force < force {
            return (side.target_force, k * side.hardening, side.target);
        }
        (force, slope, s.to)
    }

    /// Derivative of the target force with respect to the end of the step: the target moves with the energy.
    fn slope_of_target(&self, s: &Step, (force, slope): (f64, f64), before: &History, target: f64) -> f64 {
        let by_strain = 0.5 * (slope * (s.to - s.from) + force + s.force);
        let de = 1e-6 * before.excursion_energy.abs();
        let mut more = *before;
        more.energy += de;
        more.excursion_energy += de;
        (self.deteriorate(s, force, &mut more).0 - target) / de * by_strain
    }
}

/// The lower of the unloading line and another line, with its slope.
fn lower(elastic: (f64, f64), other: (f64, f64)) -> (f64, f64) {
    let force = if elastic.0 < other.0 { elastic.0 } else { other.0 };
    (force, if (force - elastic.0).abs() < 1e-10 { elastic.1 } else { other.1 })
}

impl<R: Rules> UniaxialLaw for Bilin<R> {
    type State = History;
    const NAME: &'static str = "Bilin";

    fn update(&self, c: &History, strain: Strain) -> MaterialResult<(Stress, History)> {
        let (k, d) = (self.k(), strain.value - c.strain);
        let virgin = c.direction == 0.0;
        if d.abs() < f64::EPSILON && !virgin {
            let t = History { strain: strain.value, ..*c };
            return Ok((Stress { value: c.stress, tangent: c.tangent, damping: 0.0 }, t));
        }
        let mut t = if virgin { self.virgin() } else { *c };
        t.strain = strain.value;
        // A side regains its strength if its cap has not been passed.
        let (i, x) = if strain.value > 0.0 { (0, strain.value) } else { (1, -strain.value) };
        if x < t.sides[i].end_of_cap(&self.sides[i], k) {
            (t.sides[i].exhausted, t.sides[i].level) = (0.0, 0.0);
        }
        let (sign, ahead) = if d >= 0.0 { (1.0, 0) } else { (-1.0, 1) };
        let (from, force, to) = (sign * c.strain, sign * c.stress, sign * strain.value);
        let s = Step { sign, ahead, behind: 1 - ahead, from, force, to };
        if t.sides[ahead].exhausted != 0.0 {
            t.sides[ahead].resume = t.sides[s.behind].hardening_from(k);
        }
        if virgin {
            t.direction = sign;
        } else if t.direction == -sign {
            t.direction = sign;
            self.turn(c, &s, &mut t);
        }
        let (force, mut slope) = self.advance(&s, c, &mut t);
        let work = 0.5 * (force + s.force) * (to - from);
        t.energy += work;
        t.excursion_energy += work;
        let mut answer = (force, slope, to);
        if force * s.force < 0.0 && t.relieved == 0.0 {
            let i = if s.force > 0.0 { s.ahead } else { s.behind };
            if t.sides[i].reach > t.sides[i].strength / k {
                t.relieved = 1.0;
                if t.settled == 0.0 {
                    let before = t;
                    answer = self.deteriorate(&s, force, &mut t);
                    if answer.0 != force && R::MOVES_TARGET {
                        slope = self.slope_of_target(&s, (force, slope), &before, answer.0);
                    }
                }
            }
        }
        let value = sign * answer.0;
        let tangent = R::tangent(answer.1, slope);
        if !(value.is_finite() && tangent.is_finite() && t.energy.is_finite() && t.unloading.is_finite()) {
            return Err(no_force(Self::NAME, strain.value));
        }
        if answer.1.abs() <= FLAT && answer.2 != 0.0 {
            t.sides[if sign * answer.2 > 0.0 { 0 } else { 1 }].level = 1.0;
        }
        (t.stress, t.slope, t.tangent) = (value, answer.1, tangent);
        if t.sides.iter().any(|b| t.slope == k * b.hardening || t.slope == k * b.cap_slope) {
            t.relieved = 0.0;
        }
        Ok((Stress { value, tangent, damping: 0.0 }, t))
    }

    fn initial_tangent(&self) -> f64 {
        self.k()
    }
}
