//! The choice of a law's rules.

/// A law by the rules of OpenSees where the run follows one of the slips, else by consistent ones.
macro_rules! by_rules {
    ($interp:ident, $slip:expr, $rules:ident => $law:expr) => {
        if $interp.host.follows(&[$slip]) {
            let $rules = hysteron_engine::rules::OpenSees;
            $law.shared()
        } else {
            let $rules = hysteron_engine::rules::Consistent;
            $law.shared()
        }
    };
}
pub(super) use by_rules;
