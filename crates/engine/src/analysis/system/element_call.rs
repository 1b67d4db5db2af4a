//! One evaluation of one element.

use super::evaluation::ROUND_OFF;
use crate::analysis::workspace::ElementWorkspace;
use crate::element::{ElementInput, ElementOutput, ElementResult, Histories, MAX_DOFS, MatrixMask, OpenSeesCall};
use crate::model::ElementEntry;

/// Velocities where nothing moves.
static AT_REST: [f64; MAX_DOFS] = [0.0; MAX_DOFS];

/// Trial motion of all nodes, by degrees of freedom.
#[derive(Clone, Copy)]
pub(super) struct Nodes<'a> {
    pub(super) disp: &'a [f64],
    pub(super) vel: &'a [f64],
    pub(super) accel: &'a [f64],
    /// Nothing has a velocity.
    pub(super) still: bool,
}

impl Nodes<'_> {
    /// Returns true if an element has not moved since its last evaluation, whose displacements and velocities are given. In a
    /// `settled` step round-off is no motion.
    #[inline]
    pub(super) fn have_not_moved(&self, e: &ElementEntry, m: &ElementWorkspace, last: &[f64], settled: bool) -> bool {
        let (disp, vel) = last.split_at(e.dofs.len());
        let slack = if settled { ROUND_OFF } else { 0.0 };
        let same = |new: &[f64], old: &[f64]| {
            let near = |(d, old): (&u32, &f64)| (new[*d as usize] - old).abs() <= slack * old.abs();
            e.dofs.iter().zip(old).all(near)
        };
        m.inertance.is_none() && same(self.disp, disp) && (self.still || same(self.vel, vel))
    }

    /// Write the motion of an element, its displacements and then its velocities.
    #[inline(always)]
    fn write_motion(&self, e: &ElementEntry, motion: &mut [f64]) {
        let (disp, vel) = motion.split_at_mut(e.dofs.len());
        e.dofs.iter().zip(disp).for_each(|(&d, u)| *u = self.disp[d as usize]);
        if !self.still {
            e.dofs.iter().zip(vel).for_each(|(&d, v)| *v = self.vel[d as usize]);
        }
    }

    /// Take the tangent of an element from its history, which belongs to the motion of the nodes.
    pub(super) fn take_kept_tangent(&self, e: &ElementEntry, history: &[f64], motion: &mut [f64], tangent: &mut [f64]) {
        self.write_motion(e, motion);
        tangent.fill(0.0);
        if let Some(kept) = e.element.roles().kept_tangent {
            kept.add_kept_tangent(&motion[..e.dofs.len()], history, tangent);
        }
    }
}

/// Arguments of a call of an element.
pub(super) struct Call<'a> {
    pub(super) nodes: Nodes<'a>,
    /// Its load variables.
    pub(super) load: &'a [f64],
    pub(super) dt: f64,
    pub(super) time: f64,
    pub(super) dynamic: bool,
    /// Part of its matrices that is read.
    pub(super) part: MatrixMask,
}

/// Places of its answer.
pub(super) struct Places<'a> {
    /// Displacements and velocities that it was called with.
    pub(super) motion: &'a mut [f64],
    pub(super) force: &'a mut [f64],
    pub(super) tangent: Option<&'a mut [f64]>,
    pub(super) damping: Option<&'a mut [f64]>,
    pub(super) histories: Histories<'a>,
}

impl Call<'_> {
    /// Call an element.
    ///
    /// # Errors
    /// The element has no answer.
    #[inline(always)]
    pub(super) fn make(
        &self,
        e: &ElementEntry,
        m: &ElementWorkspace,
        opensees: Option<OpenSeesCall<'_>>,
        places: Places<'_>,
    ) -> ElementResult {
        let (n, nodes, part) = (e.dofs.len(), self.nodes, self.part);
        let Places { motion, force, mut tangent, mut damping, mut histories } = places;
        nodes.write_motion(e, motion);
        let (disp, vel) = motion.split_at(n);
        let mut accelerations;
        let accel: &[f64] = if m.inertance.is_some() {
            accelerations = [0.0; MAX_DOFS];
            e.dofs.iter().zip(&mut accelerations).for_each(|(&d, a)| *a = nodes.accel[d as usize]);
            &accelerations[..n]
        } else {
            &[]
        };
        force.fill(0.0);
        if let Some(k) = &mut tangent {
            part.clear(k, n);
        }
        if let Some(c) = &mut damping {
            c.fill(0.0);
        }
        let input = ElementInput {
            disp,
            vel: if nodes.still { &AT_REST[..n] } else { vel },
            accel,
            load: self.load,
            still: nodes.still,
            opensees,
            dt: self.dt,
            time: self.time,
            dynamic: self.dynamic,
        };
        e.element.respond(&input, &mut histories, ElementOutput { force, tangent, damping, part })
    }
}
