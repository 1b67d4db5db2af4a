//! Methods of laws that evaluate one point after the other.

/// Writes the named methods of [`Uniaxial`](super::Uniaxial) for a law without layout, trace, parameter or response of its
/// own. A law names each method, so that a new method of the trait is decided upon in every law.
macro_rules! plain_methods {
    ($($method:ident)*) => { $($crate::material::plain_methods::plain_methods!(@$method);)* };
    (@init_all) => {
        fn init_all(&self, _: usize, state: &mut [f64]) {
            state.chunks_exact_mut(self.state_len().max(1)).for_each(|point| self.init(point));
        }
    };
    (@block_len) => {
        fn block_len(&self) -> usize {
            1
        }
    };
    (@update_all) => {
        fn update_all(
            &self,
            committed: &[f64],
            strains: &$crate::material::Strains<'_>,
            next: &mut [f64],
            stresses: &mut $crate::material::Stresses<'_>,
        ) -> Result<(), $crate::material::MaterialError> {
            $crate::material::update_each(self, committed, strains, next, stresses)
        }
    };
    (@update_all_on) => {
        fn update_all_on(
            &self,
            committed: &[f64],
            _: &[f64],
            strains: &$crate::material::Strains<'_>,
            next: &mut [f64],
            stresses: &mut $crate::material::Stresses<'_>,
        ) -> Result<(), $crate::material::MaterialError> {
            self.update_all(committed, strains, next, stresses)
        }
    };
    (@shifted) => {
        fn shifted(&self) -> Option<(&$crate::material::Slot, f64)> {
            None
        }
    };
    (@commit_all) => {
        fn commit_all(&self, trial: &[f64], committed: &mut [f64]) {
            committed.copy_from_slice(trial);
        }
    };
    (@copy_history) => {
        fn copy_history(&self, (from, i, _): (&[f64], usize, usize), (to, j, _): (&mut [f64], usize, usize)) {
            let n = self.state_len();
            to[j * n..(j + 1) * n].copy_from_slice(&from[i * n..(i + 1) * n]);
        }
    };
    (@virgin_tangent) => {
        fn virgin_tangent(&self, _: [f64; 2]) -> Option<f64> {
            None
        }
    };
    (@are_virgin) => {
        fn are_virgin(&self, _: &[f64]) -> bool {
            false
        }
    };
    (@leave_trace) => {
        fn leave_trace(&self, _: &[f64], _: &mut [f64]) {}
    };
    (@shown_strain) => {
        fn shown_strain(&self, strain: f64, _: &[f64]) -> f64 {
            strain
        }
    };
    (@with_parameter) => {
        fn with_parameter(&self, _: &[&str], _: Option<f64>) -> $crate::parameter::Changed<$crate::material::SharedUniaxial> {
            Err($crate::parameter::ParameterError::Unknown)
        }
    };
    (@as_any) => {
        fn as_any(&self) -> Option<&dyn std::any::Any> {
            None
        }
    };
}

pub(crate) use plain_methods;
