//! Bearings of several models side by side: a shear law with linear springs for the other directions.

use crate::element::bearing::kinematics::link::Link;
use crate::element::bearing::laws::shear::{Shear, ShearLockstep};
use crate::element::{LockstepElement, LockstepMotion, LockstepOutput};
use crate::material::write_linear;
use crate::numeric::lanes::{Lanes, in_lanes};
use crate::numeric::wide::Wide;
use crate::state_struct::StateStruct as _;
use std::cell::Cell;
use std::fmt;

/// A [`ShearBearing`](super::shear_bearing::ShearBearing) of each of several models, with the same kinematics. The materials
/// of the other directions are linear.
pub(super) struct ShearBearings<L, const N: usize, const B: usize, const M: usize, const S: usize> {
    pub(super) law: L,
    pub(super) link: Link<N, B>,
    /// Stiffness of each material.
    pub(super) springs: [Wide; M],
    /// Basic stiffness, kept between evaluations: most of it is zero and stays so.
    pub(super) stiffness: Kept<B>,
}

/// A basic stiffness that is kept between evaluations.
pub(super) type Kept<const B: usize> = Cell<Option<Box<[[Wide; B]; B]>>>;

impl<L: fmt::Debug, const N: usize, const B: usize, const M: usize, const S: usize> fmt::Debug
    for ShearBearings<L, N, B, M, S>
{
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("ShearBearings").field("law", &self.law).field("springs", &self.springs).finish_non_exhaustive()
    }
}

/// A response as a loop.
struct Response<'a, L, const N: usize, const B: usize, const M: usize, const S: usize> {
    bearings: &'a ShearBearings<L, N, B, M, S>,
    motion: LockstepMotion<'a>,
    output: LockstepOutput<'a>,
}

impl<L: ShearLockstep<S>, const N: usize, const B: usize, const M: usize, const S: usize> Lanes
    for Response<'_, L, N, B, M, S>
{
    #[inline(always)]
    fn evaluate(&mut self) {
        let ShearBearings { law, link, springs, stiffness: kept } = self.bearings;
        let (motion, output) = (self.motion, &mut self.output);
        let local = link.local_motion(motion.disp);
        let u = link.deformation_of(&local);
        let rate = match motion.vel {
            Some(vel) => link.deformation(vel),
            None => [Wide::all(0.0); B],
        };
        let mut q = [Wide::all(0.0); B];
        let mut at = Shear::<S>::LEN;
        for (m, k) in springs.iter().enumerate() {
            let i = if m == 0 { 0 } else { m + S };
            q[i] = *k * u[i];
            at += write_linear(*k, (u[i], rate[i]), &motion.committed[at..], &mut output.trial[at..]);
        }
        let mut shear_u = [Wide::all(0.0); S];
        shear_u.copy_from_slice(&u[1..=S]);
        let shear = law.step(&Shear::of_words(motion.committed), shear_u);
        shear.to_words(output.trial);
        q[1..=S].copy_from_slice(&shear.q);
        link.add_force(&q, &local, output.force);
        if let Some(tangent) = &mut output.tangent {
            let mut stiffness = kept.take().unwrap_or_else(|| Box::new([[Wide::all(0.0); B]; B]));
            for (m, k) in springs.iter().enumerate() {
                let i = if m == 0 { 0 } else { m + S };
                stiffness[i][i] = *k;
            }
            for (row, k) in stiffness[1..=S].iter_mut().zip(&shear.k) {
                row[1..=S].copy_from_slice(k);
            }
            link.add_tangent(&stiffness, &q, motion.disp, tangent, output.part);
            kept.set(Some(stiffness));
        }
    }
}

impl<L: ShearLockstep<S>, const N: usize, const B: usize, const M: usize, const S: usize> LockstepElement
    for ShearBearings<L, N, B, M, S>
{
    fn respond(&self, motion: LockstepMotion<'_>, output: LockstepOutput<'_>) {
        in_lanes(&mut Response { bearings: self, motion, output });
    }
}
