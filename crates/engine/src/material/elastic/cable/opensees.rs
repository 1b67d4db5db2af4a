//! OpenSees' rules of a cable.

use super::{Cable, Rules};
use crate::rules::OpenSees;

impl Rules for OpenSees {
    /// A whole division leaves the change of the sag out.
    const SAG: f64 = 0.0;

    /// It counts in the tangent, in which a term of the elastic strain has another sign.
    fn tangent(cable: &Cable<Self>, stress: f64) -> f64 {
        let square = stress * stress;
        let elastic = (1.0 - cable.sag() / square * (1.0 - 2.0 * cable.prestress / stress)) / cable.e;
        1.0 / (elastic + 2.0 * cable.sag() / (square * stress))
    }
}
