//! Sliding bearings by OpenSees' rules.
//!
//! Substitution gives the shear force. The plastic displacement of a trial state that slides is kept. The tangent omits
//! the normal force, the speed, the rise of the slider and the arms of the moments. `FPBearingPTV` has its own scheme.

use super::bearing::{Basic, History, Kind, SlidingBearing};
use super::heat::Heat;
use super::rules::Rules;
use super::surface::{Pose, Slide, Surface};
use crate::element::friction::Contact;
use crate::element::{ElementError, ElementInput, ElementResult, Histories};
use crate::material::Strain;
use crate::numeric::{axpy, norm};
use crate::state_struct::StateStruct;

/// Share of the stiffness before sliding that is left in uplift, and of the tension that pushes then.
const UPLIFT: f64 = 1e-6;
const PUSH: f64 = 1e-4;

/// OpenSees' rules, with the iterations of the command's options.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Substitution {
    /// Largest number of iterations for the shear force.
    pub rounds: usize,
    /// Tolerance of the change of the shear force.
    pub tolerance: f64,
}

impl Rules for Substitution {
    const MOMENTS_FOLLOW_FORCES: bool = false;

    fn heat_first(heat: Option<&Heat>) -> Option<&Heat> {
        heat
    }

    /// OpenSees omits the rate, and omits the slope in the tangent.
    fn rise<const S: usize>(rise: f64, _: [f64; S], _: &[f64]) -> (f64, f64, [f64; S]) {
        (rise, 0.0, [0.0; S])
    }

    fn leaves_out<const S: usize>(direction: usize, axial: f64) -> bool {
        direction > S && axial >= 0.0
    }

    /// In the plane OpenSees restores the last strain of the axial material.
    fn puts_back<const S: usize>(kind: Kind, direction: usize, force: f64) -> bool {
        direction == 0 && S == 1 && kind != Kind::Springs && force > 0.0
    }

    fn slide<const S: usize>(self, on: &Surface, pose: &Pose<S>, shear: [f64; S]) -> ElementResult<Slide<S>> {
        on.slide_by_substitution(pose, shear, self.rounds, self.tolerance)
    }

    /// If a trial slid and the next one sticks, OpenSees keeps the plastic displacement of the first.
    fn stuck<const S: usize>(_: [f64; S], last: [f64; S]) -> [f64; S] {
        last
    }

    fn add_derivatives<const N: usize, const B: usize, const S: usize>(
        bearing: &SlidingBearing<N, B, S, Self>,
        slide: &Slide<S>,
        i: usize,
        out: &mut Basic<N, B>,
    ) {
        for j in 0..S {
            axpy(slide.stiffness[i][j], &bearing.link.basic[1 + j], &mut out.by_disp[1 + i]);
        }
    }

    /// OpenSees keeps the full initial stiffness in space, and in the plane if the axial material is not in tension. The
    /// friction model keeps its last contact state. In the plane the slider does not move without tension.
    fn lift<const N: usize, const B: usize, const S: usize>(
        bearing: &SlidingBearing<N, B, S, Self>,
        (u, _, _): (&[f64; B], &[f64; B], f64),
        last: &History<B, S>,
        out: &mut Basic<N, B>,
    ) -> History<B, S> {
        let springs = bearing.setting.kind == Kind::Springs;
        let whole = S == 2 || springs || out.q[0] == 0.0;
        let left = if whole { 1.0 } else { bearing.setting.uplift };
        for (d, slot) in &bearing.springs {
            if !(1..=S).contains(d) {
                out.q[*d] = 0.0;
            }
            out.by_disp[*d] = bearing.link.basic[*d].map(|r| left * slot.material.initial_tangent() * r);
        }
        bearing.add_initial_shear(left, out);
        let stays = whole && S == 1 && !springs;
        let plastic = if stays { last.plastic } else { std::array::from_fn(|i| u[1 + i]) };
        History { plastic, shear: [0.0; S], ..*last }
    }
}

impl<const N: usize, const B: usize, const S: usize, R: Rules> SlidingBearing<N, B, S, R> {
    /// Basic forces with the coefficient of friction of the first trial state of the step, under the axial force without the slope of the
    /// surface, and with a tangent of OpenSees' own. Under tension a ten-thousandth of it pushes. Where all displacements of the nodes are
    /// at rest, as in static analyses, the material of the rotation about z stays where it was made.
    pub(super) fn with_early_friction(
        &self,
        heat: &Heat,
        motion: &ElementInput<'_>,
        h: &mut Histories<'_>,
    ) -> ElementResult<Basic<N, B>> {
        let (u, rate) = (self.link.deformation(motion.disp), self.link.deformation(motion.vel));
        let (old, mut next) = (History::<B, S>::read(h.committed), History::<B, S>::read(h.trial));
        let mut out = Basic { q: next.q, by_disp: [[0.0; N]; B], by_vel: [[0.0; N]; B] };
        let Some((_, axial)) = self.springs.first() else { unreachable!("there is an axial material") };
        let s = axial.update(h.committed, Strain { value: u[0], rate: rate[0], dt: motion.dt }, h.trial)?;
        let lifted = s.value >= 0.0;
        out.q[0] = if lifted { -PUSH * s.value } else { s.value };
        axpy(s.tangent, &self.link.basic[0], &mut out.by_disp[0]);
        axpy(s.damping, &self.link.basic[0], &mut out.by_vel[0]);
        if out.q[0] >= 0.0 {
            // Everything else is left as it was.
            for row in 1..=S {
                axpy(self.surface.k_init, &self.link.basic[row], &mut out.by_disp[row]);
            }
            for (d, slot) in self.springs.iter().skip(1) {
                axpy(slot.material.initial_tangent(), &self.link.basic[*d], &mut out.by_disp[*d]);
            }
            next.q = out.q;
            next.write(h.trial);
            return Ok(out);
        }
        let normal = -out.q[0];
        let radius = self.surface.dish.map_or(f64::INFINITY, |d| d.radius);
        let shear: [f64; S] = std::array::from_fn(|i| u[1 + i]);
        let mut curvature = [0.0; S];
        for (c, x) in curvature.iter_mut().zip(&shear) {
            // The circle at the displacement in its own direction.
            let square = (radius - x) * (radius + x);
            if square <= 0.0 {
                return Err(ElementError(
                    format!("the displacement {x:.4} is not less than the radius of the sliding surface, {radius}")
                        .into(),
                ));
            }
            *c = 1.0 / square.sqrt();
        }
        let speed = self.speed(&shear, &rate, &curvature);
        let mu = heat.warm_first((normal, speed), &shear, motion.time, &mut h.trial[self.own..]);
        let limit = mu * normal;
        let left = if lifted { UPLIFT } else { 1.0 };
        let k_before: [f64; S] = std::array::from_fn(|i| left * (self.surface.k_init - normal * curvature[i]));
        let force: [f64; S] = std::array::from_fn(|i| k_before[i] * (shear[i] - old.plastic[i]));
        let size = norm(&force);
        let slides = size > limit;
        let k_slide = left * self.surface.k_init;
        for i in 0..S {
            let tilt = crate::numeric::dot(&self.tilt[i], motion.disp);
            let pendulum = normal * curvature[i];
            let friction = if slides { limit * force[i] / size } else { force[i] };
            out.q[1 + i] = friction + pendulum * shear[i] - normal * tilt;
            if slides {
                next.plastic[i] = old.plastic[i] + (size - limit) / k_before[i] * force[i] / size;
            }
            for j in 0..S {
                let k = match (slides, i == j) {
                    (false, same) => k_slide * f64::from(u8::from(same)),
                    (true, true) => {
                        let across = if S == 2 { force[1 - i] } else { 0.0 };
                        k_slide * (1.0 - limit * across * across / size.powi(3)) + pendulum
                    }
                    (true, false) => -limit * k_slide * force[i] * force[j] / size.powi(3),
                };
                axpy(k, &self.link.basic[1 + j], &mut out.by_disp[1 + i]);
            }
        }
        let moves = |v: &[f64]| v[..3].iter().any(|v| *v != 0.0);
        let at_rest = !moves(motion.vel) && !moves(&motion.vel[N / 2..]);
        for (d, slot) in self.springs.iter().skip(1) {
            let (value, rate) = if *d == B - 1 && at_rest { (0.0, 0.0) } else { (u[*d], rate[*d]) };
            let s = slot.update(h.committed, Strain { value, rate, dt: motion.dt }, h.trial)?;
            out.q[*d] = s.value;
            axpy(s.tangent, &self.link.basic[*d], &mut out.by_disp[*d]);
            axpy(s.damping, &self.link.basic[*d], &mut out.by_vel[*d]);
        }
        next.contact = Contact { normal, speed, mu };
        next.shear = std::array::from_fn(|i| out.q[1 + i]);
        next.q = out.q;
        next.write(h.trial);
        Ok(out)
    }

    /// Speed along the surface.
    fn speed(&self, u: &[f64; S], rate: &[f64; B], curvature: &[f64; S]) -> f64 {
        let rise: f64 = (0..S).map(|i| rate[1 + i] * curvature[i] * u[i]).sum();
        rate[1..=S].iter().fold(rise, |sum, w| sum.hypot(*w))
    }
}
