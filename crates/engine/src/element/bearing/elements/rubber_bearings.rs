//! Layered rubber bearings of several models side by side.

// Loops over vectors: the compiler makes vector instructions of them, which it does not of some iterators.
#![allow(clippy::needless_range_loop)]

use crate::element::bearing::elements::rubber_bearing::{MEMORY_AT, SHEAR_AT};
use crate::element::bearing::elements::shear_bearings::Kept;
use crate::element::bearing::kinematics::link::Link;
use crate::element::bearing::laws::axial::{Axial, AxialLockstep};
use crate::element::bearing::laws::rubber_shear::RubberShearLockstep;
use crate::element::bearing::laws::shear::Shear;
use crate::element::{LockstepElement, LockstepMotion, LockstepOutput};
use crate::numeric::lanes::{Lanes, in_lanes};
use crate::numeric::real::Real;
use crate::numeric::wide::Wide;
use std::fmt;

/// A [`RubberBearing`](super::rubber_bearing::RubberBearing) of each of several models, with the same kinematics.
pub(super) struct RubberBearings<L> {
    pub(super) axial: AxialLockstep,
    pub(super) shear: L,
    pub(super) link: Link<12, 6>,
    /// Stiffnesses of torsion and rotations.
    pub(super) rotations: [Wide; 3],
    /// Basic stiffness, kept between evaluations: most of it is zero and stays so.
    pub(super) stiffness: Kept<6>,
}

impl<L: fmt::Debug> fmt::Debug for RubberBearings<L> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("RubberBearings").field("axial", &self.axial).field("shear", &self.shear).finish_non_exhaustive()
    }
}

/// A response as a loop.
struct Response<'a, L> {
    bearings: &'a RubberBearings<L>,
    motion: LockstepMotion<'a>,
    output: LockstepOutput<'a>,
}

impl<L: RubberShearLockstep> Lanes for Response<'_, L> {
    #[inline(always)]
    fn evaluate(&mut self) {
        let RubberBearings { axial, shear, link, rotations, stiffness: kept } = self.bearings;
        let (motion, output) = (self.motion, &mut self.output);
        let zero = Wide::all(0.0);
        let local = link.local_motion(motion.disp);
        let u = link.deformation_of(&local);
        let lateral = [u[1], u[2]];
        let size = (u[1] * u[1] + u[2] * u[2]).sqrt();
        let axial = axial.step(&Axial::of_words(motion.committed), u[0], size, motion.lanes);
        axial.next.to_words(output.trial);
        let c = Shear::of_words(&motion.committed[SHEAR_AT..]);
        let shear = shear.step(&c, &motion.committed[MEMORY_AT..], &mut output.trial[MEMORY_AT..], lateral, size);
        shear.to_words(&mut output.trial[SHEAR_AT..]);

        let mut q = [axial.next.force, shear.q[0], shear.q[1], zero, zero, zero];
        for i in 0..3 {
            q[3 + i] = rotations[i] * u[3 + i];
        }
        link.add_force(&q, &local, output.force);
        if let Some(tangent) = &mut output.tangent {
            let mut k = kept.take().unwrap_or_else(|| Box::new([[zero; 6]; 6]));
            k[0][0] = axial.k;
            for i in 0..2 {
                k[0][1 + i] = size.where_greater(zero, axial.k_shear * lateral[i] / size, zero);
                k[1 + i][1..3].copy_from_slice(&shear.k[i]);
            }
            for i in 0..3 {
                k[3 + i][3 + i] = rotations[i];
            }
            link.add_tangent(&k, &q, motion.disp, tangent, output.part);
            kept.set(Some(k));
        }
    }
}

impl<L: RubberShearLockstep> LockstepElement for RubberBearings<L> {
    fn respond(&self, motion: LockstepMotion<'_>, output: LockstepOutput<'_>) {
        in_lanes(&mut Response { bearings: self, motion, output });
    }
}
