//! `forceBeamColumnCBDI` and `forceBeamColumnCSBDI` by OpenSees' rules.

use super::{Basic, CurvatureBased, Member, Rules, Sections, Trace, resultants};
use crate::element::{ElementInput, Histories};
use crate::material::MaterialError;
use crate::numeric::{axpy, dot, invert};
use crate::rules::OpenSees;

impl Rules for OpenSees {
    const WHOLE_TANGENT: bool = false;
    const CALL_DEPENDENT: bool = true;

    fn datum<'a>(start: &'a [f64], _: &'a [f64]) -> &'a [f64] {
        start
    }

    fn loads_inside(plane: bool) -> bool {
        !plane
    }

    /// With inelastic sections OpenSees converges to the same result within its tolerance.
    fn first<const N: usize, const B: usize>(
        beam: &CurvatureBased<Self>,
        member: &Member<N, B>,
        trace: &Trace<N, B>,
        motion: &ElementInput<'_>,
        h: &mut Histories<'_>,
    ) -> Result<Option<Basic<B>>, MaterialError> {
        if trace.is_at_rest(motion) {
            return Ok(Some(Basic::read(&h.trial[member.head()..])));
        }
        if member.sections.iter().all(|s| s.section.is_linear()) {
            return beam.iterate_from_trial(member, trace, motion, h);
        }
        Ok(None)
    }
}

impl CurvatureBased<OpenSees> {
    /// Basic forces by OpenSees' scheme. It starts from the last trial state and its stiffness, and iterates until the
    /// residual energy is small. Without convergence the last iterate is returned.
    fn iterate_from_trial<const N: usize, const B: usize>(
        &self,
        member: &Member<N, B>,
        Trace { v, dv, .. }: &Trace<N, B>,
        motion: &ElementInput<'_>,
        h: &mut Histories<'_>,
    ) -> Result<Option<Basic<B>>, MaterialError> {
        let mut basic = Basic::read(&h.trial[member.head()..]);
        let k = basic.k;
        let mut s = Sections::new(self, member, h.trial, None);
        let mut current = resultants(member, h.trial);
        // OpenSees does not correct the residual of the last trial state.
        let mut remaining = *dv;
        for _ in 0..self.iteration.max_iterations {
            let step = k.map(|row| dot(&row, &remaining));
            axpy(1.0, &step, &mut basic.q);
            let loading = (&basic.q, motion.load);
            // Section deformations in equilibrium, first with the old stiffnesses, then with the current ones.
            let Some(l) = self.linear(member, &s, loading, &current, (h.trial, 0.0)) else { return Ok(None) };
            let e = std::array::from_fn(|b| s.e[b] + l.change[b]);
            Self::update(member, &e, motion.dt, h)?;
            s = Sections::new(self, member, h.trial, None);
            let Some(l) = self.linear(member, &s, loading, &resultants(member, h.trial), (h.trial, 0.0)) else {
                return Ok(None);
            };
            let e = std::array::from_fn(|b| s.e[b] + l.change[b]);
            s = Sections::new(self, member, h.trial, Some(&e));
            current = self.equilibrium_resultants(&s, &basic.q, motion.load);
            let Some(mut l) = self.linear(member, &s, loading, &current, (h.trial, 0.0)) else { return Ok(None) };
            if !invert(l.f.as_flattened_mut(), B) {
                return Ok(None);
            }
            basic.k = l.f;
            let basic_deformations = s.basic_deformations();
            remaining = std::array::from_fn(|i| v[i] - basic_deformations[i]);
            if dot(&remaining, &k.map(|row| dot(&row, &remaining))).abs() < self.iteration.tolerance {
                break;
            }
        }
        Ok(Some(basic))
    }
}
