//! `forceBeamColumnCBDI` and `forceBeamColumnCSBDI` by OpenSees' rules.

use super::{Basic, CurvatureBased, Member, Rules, Sections, carried};
use crate::element::ElementInput;
use crate::material::MaterialError;
use crate::numeric::{axpy, dot, invert};
use crate::rules::OpenSees;

impl Rules for OpenSees {
    const WHOLE_TANGENT: bool = false;

    fn datum<'a>(start: &'a [f64], _: &'a [f64]) -> &'a [f64] {
        start
    }

    fn loads_inside(plane: bool) -> bool {
        !plane
    }

    /// With sections that yield OpenSees comes to the same within its tolerance.
    fn first<const N: usize, const B: usize>(
        beam: &CurvatureBased<Self>,
        member: &Member<N, B>,
        v: &[f64; B],
        motion: &ElementInput<'_>,
        committed: &[f64],
        trial: &mut [f64],
    ) -> Result<Option<Basic<B>>, MaterialError> {
        if member.sections.iter().all(|s| s.section.is_linear()) {
            return beam.from_trial(member, v, motion, committed, trial);
        }
        Ok(None)
    }
}

impl CurvatureBased<OpenSees> {
    /// The basic forces from the last trial state on, with the stiffness that it ended with, until the
    /// energy left over is small; then, or after the last iteration, they are taken as they are.
    fn from_trial<const N: usize, const B: usize>(
        &self,
        member: &Member<N, B>,
        v: &[f64; B],
        motion: &ElementInput<'_>,
        committed: &[f64],
        trial: &mut [f64],
    ) -> Result<Option<Basic<B>>, MaterialError> {
        let mut basic = Basic::read(&trial[member.head()..]);
        let k = basic.k;
        let mut s = Sections::new(self, member, trial, None);
        let mut carries = carried(member, trial);
        // What was left over at the last trial state is not made up for.
        let last = member.own_words();
        let mut left: [f64; B] = std::array::from_fn(|i| v[i] - trial[last + i]);
        for _ in 0..self.iteration.max_iterations {
            let step = k.map(|row| dot(&row, &left));
            axpy(1.0, &step, &mut basic.q);
            let loading = (&basic.q, motion.load);
            // Deformations that are in equilibrium by the old stiffnesses, then by those that they have.
            let Some(l) = self.linear(member, &s, loading, &carries, trial) else { return Ok(None) };
            let e = std::array::from_fn(|b| s.e[b] + l.change[b]);
            Self::update(member, &e, motion.dt, committed, trial)?;
            s = Sections::new(self, member, trial, None);
            let Some(l) = self.linear(member, &s, loading, &carried(member, trial), trial) else { return Ok(None) };
            let e = std::array::from_fn(|b| s.e[b] + l.change[b]);
            s = Sections::new(self, member, trial, Some(&e));
            carries = self.balanced(&s, &basic.q, motion.load);
            let Some(mut l) = self.linear(member, &s, loading, &carries, trial) else { return Ok(None) };
            if !invert(l.f.as_flattened_mut(), B) {
                return Ok(None);
            }
            basic.k = l.f;
            let gathered = s.gathered();
            left = std::array::from_fn(|i| v[i] - gathered[i]);
            if dot(&left, &k.map(|row| dot(&row, &left))).abs() < self.iteration.tolerance {
                break;
            }
        }
        Ok(Some(basic))
    }
}
