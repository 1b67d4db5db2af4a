//! Methods of sections that have no more than resultants.

/// Writes the named methods of [`Section`](super::Section) for a section of which the state begins with zeros, and which has
/// neither parameters nor responses of its own.
macro_rules! plain_methods {
    ($($method:ident)*) => { $($crate::section::plain_methods::plain_methods!(@$method);)* };
    (@init) => {
        fn init(&self, state: &mut [f64]) {
            state.fill(0.0);
        }
    };
    (@is_linear) => {
        fn is_linear(&self) -> bool {
            false
        }
    };
    (@depends_on_time) => {
        fn depends_on_time(&self) -> bool {
            false
        }
    };
    (@elastic) => {
        fn elastic(&self) -> Option<$crate::section::ElasticSection> {
            None
        }
    };
    (@joined) => {
        fn joined(&self) -> Option<&$crate::section::FiberSection> {
            None
        }
    };
    (@with_parameter) => {
        fn with_parameter(&self, _: &[&str], _: $crate::parameter::NewValue) -> $crate::parameter::Changed<$crate::section::SharedSection> {
            Err($crate::parameter::ParameterError::Unknown)
        }
    };
    (@probe) => {
        fn probe(&self, _: &[&str]) -> Option<$crate::probe::Probe> {
            None
        }
        fn read(&self, _: &[u32], _: &[f64], _: &mut [f64]) {}
    };
}

pub(super) use plain_methods;
