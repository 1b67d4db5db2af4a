//! Why an analysis step failed, with what an engineer needs to find the reason.

use crate::number_format::without_round_off;
use std::fmt;
use std::ops::{Deref, DerefMut};

/// Why a step failed.
#[derive(Clone, Debug, PartialEq)]
pub enum Cause {
    /// The test was not passed within its iterations.
    NotConverged {
        /// Norm at the last iteration, as the test has it.
        norm: f64,
        /// Limit of the norm.
        tolerance: f64,
        /// Iterations made.
        iterations: usize,
        /// Name of the test.
        test: &'static str,
    },
    /// A number that is not finite turned up in the equations.
    NotFinite,
    /// The equations are singular: a mechanism.
    Singular,
    /// The factors of the equations do not fit into memory.
    OutOfMemory,
    /// An element found no force.
    Element {
        /// Class and tag.
        element: String,
        /// Its message.
        message: String,
    },
    /// The model makes no sense to the analysis.
    Model(String),
    /// The user interrupted.
    Interrupted,
}

/// A failed step. What there is to say of it is kept apart: all that may fail in a step that does not returns a word.
#[derive(Clone, Debug, PartialEq)]
pub struct Failure(Box<Details>);

/// Report of a failed step.
#[derive(Clone, Debug, PartialEq)]
pub struct Details {
    /// Why.
    pub cause: Cause,
    /// Domain time that the step was to reach.
    pub time: f64,
    /// The degree of freedom that is worst off, in words: `node 3, dof 1`.
    pub place: Option<String>,
    /// In a static analysis, the element with a section that has no stiffness left, in words.
    pub exhausted: Option<String>,
    /// Result of `analyze` in OpenSees: -1 for the model, -2 for the new step, -3 for the solution, -4 for the commit.
    pub code: i32,
}

impl Failure {
    /// From the cause, the domain time that the step was to reach, and what `analyze` returns.
    pub fn new(cause: Cause, time: f64, code: i32) -> Self {
        Self(Box::new(Details { cause, time, place: None, exhausted: None, code }))
    }

    /// With the degree of freedom that is worst off, where there is one.
    pub fn at(mut self, place: Option<String>) -> Self {
        self.place = place;
        self
    }

    /// With another code.
    pub fn with_code(mut self, code: i32) -> Self {
        self.code = code;
        self
    }
}

impl Deref for Failure {
    type Target = Details;
    fn deref(&self) -> &Details {
        &self.0
    }
}

impl DerefMut for Failure {
    fn deref_mut(&mut self) -> &mut Details {
        &mut self.0
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let time = without_round_off(self.time);
        match &self.cause {
            Cause::NotConverged { norm, tolerance, iterations, test } => write!(
                f,
                "no convergence at time {time}: {test} {norm:.4e} after {iterations} iterations, wanted {tolerance:.1e}"
            )?,
            Cause::NotFinite => write!(f, "a number that is not finite turned up at time {time}")?,
            Cause::Singular => write!(f, "the structure is a mechanism at time {time}")?,
            Cause::OutOfMemory => write!(f, "the equations do not fit into memory")?,
            Cause::Element { element, message } => write!(f, "{element} failed at time {time}: {message}")?,
            Cause::Model(message) => write!(f, "{message}")?,
            Cause::Interrupted => write!(f, "interrupted at time {time}")?,
        }
        match (&self.place, &self.cause) {
            (Some(p), Cause::Singular) => write!(f, " ({p} has no stiffness)"),
            (Some(p), _) => write!(f, " (worst: {p})"),
            (None, _) => Ok(()),
        }
    }
}

impl std::error::Error for Failure {}
