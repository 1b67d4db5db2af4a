//! The two sets of rules that a law may follow.
//!
//! A law whose results differ from those of OpenSees in several places has a trait `Rules`. Its default methods are the rules of the
//! law's source, with a tangent that is the derivative of the force. The file `opensees.rs` in the folder of the law has those of
//! OpenSees. The type of the rules is a parameter of the law, so that the choice costs no time.

/// The rules of the law's source.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Consistent;

/// The rules of OpenSees.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct OpenSees;
