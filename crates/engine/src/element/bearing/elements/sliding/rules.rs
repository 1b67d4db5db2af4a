//! Rules of a sliding bearing that differ in OpenSees.

use super::bearing::{Basic, History, Kind, SlidingBearing};
use super::heat::Heat;
use super::surface::{Pose, Slide, Surface};
use crate::element::ElementResult;
use crate::element::friction::Contact;
use crate::numeric::{axpy, dot, norm};
use crate::rules::Consistent;
use std::fmt;

/// Rules of [`SlidingBearing`] that differ in OpenSees.
pub trait Rules: Copy + fmt::Debug + PartialEq + Send + Sync + 'static {
    /// The tangent of the P-Delta moments includes the change of the forces.
    const MOMENTS_FOLLOW_FORCES: bool = true;

    /// Heat of a surface whose friction is evaluated before the other forces.
    fn heat_first(_heat: Option<&Heat>) -> Option<&Heat> {
        None
    }

    /// Rise of a dish, its rate and its slope by the shear displacement.
    fn rise<const S: usize>(rise: f64, slope: [f64; S], rate: &[f64]) -> (f64, f64, [f64; S]) {
        (rise, dot(&slope, rate), slope)
    }

    /// Returns true if the material of this direction is not evaluated at the axial force `axial`.
    fn leaves_out<const S: usize>(_direction: usize, _axial: f64) -> bool {
        false
    }

    /// Returns true if the material of this direction returns to its last strain after a trial with the given force.
    fn puts_back<const S: usize>(_kind: Kind, _direction: usize, _force: f64) -> bool {
        false
    }

    /// Friction of the surface; `shear` is the force of the last trial state.
    ///
    /// # Errors
    /// A surface without a force at this displacement.
    fn slide<const S: usize>(self, on: &Surface, pose: &Pose<S>, _shear: [f64; S]) -> ElementResult<Slide<S>> {
        on.slide(pose)
    }

    /// Plastic displacement of a step that sticks: that of the committed state or of the last trial state.
    fn stuck<const S: usize>(committed: [f64; S], _last: [f64; S]) -> [f64; S] {
        committed
    }

    /// Adds the derivatives of the shear force in direction `i`.
    fn add_derivatives<const N: usize, const B: usize, const S: usize>(
        bearing: &SlidingBearing<N, B, S, Self>,
        slide: &Slide<S>,
        i: usize,
        out: &mut Basic<N, B>,
    ) {
        let (axial, axial_damping) = (out.by_disp[0], out.by_vel[0]);
        let (k, c) = (&mut out.by_disp[1 + i], &mut out.by_vel[1 + i]);
        for j in 0..S {
            axpy(slide.by_u[i][j], &bearing.link.basic[1 + j], k);
            axpy(slide.by_tilt[i][j], &bearing.tilt[j], k);
            axpy(slide.by_rate[i][j], &bearing.link.basic[1 + j], c);
        }
        axpy(-slide.by_pressure[i], &axial, k);
        axpy(-slide.by_pressure[i], &axial_damping, c);
    }

    /// Removes the forces that need contact: all but the shear springs. The share `left` of the initial stiffness
    /// remains.
    fn lift<const N: usize, const B: usize, const S: usize>(
        bearing: &SlidingBearing<N, B, S, Self>,
        (u, rate, left): (&[f64; B], &[f64; B], f64),
        _last: &History<B, S>,
        out: &mut Basic<N, B>,
    ) -> History<B, S> {
        for (d, slot) in bearing.springs.iter().filter(|(d, _)| !(1..=S).contains(d)) {
            out.q[*d] = 0.0;
            out.by_vel[*d] = [0.0; N];
            out.by_disp[*d] = bearing.link.basic[*d].map(|r| left * slot.material.initial_tangent() * r);
        }
        bearing.add_initial_shear(left, out);
        let speed = norm(&rate[1..=S]);
        let contact = Contact { normal: 0.0, speed, mu: bearing.surface.coefficient(0.0, speed).mu };
        History { plastic: std::array::from_fn(|i| u[1 + i]), shear: [0.0; S], contact, q: [0.0; B] }
    }
}

impl Rules for Consistent {}
