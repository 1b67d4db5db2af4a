//! Isolation studies: a script, its bearings with bounds of their properties, and a suite of motions.
//!
//! The script gets its values in the global array `isolate` before it runs, and has values of its own where they are not
//! set: `isolate(bound)`, the factors `isolate(Q,NAME)` and `isolate(K,NAME)` of each type of bearing, the accelerations
//! `isolate(ax)`, `isolate(ay)` and `isolate(az)` as lists in its own unit, `isolate(dt)` and `isolate(points)`, and the accidental
//! eccentricities `isolate(ex)` and `isolate(ey)` as shares of the plan.

mod agreement;
mod before_transient;
mod capture;
mod draft;
mod excitation;
mod inputs;
mod job;
mod observed;
mod outcome;
mod plausibility;
mod procedures;
mod properties;
mod runaway;
mod script_model;
mod shear_test;
mod study;
mod study_file;
mod unit_labels;
mod variants;

pub use agreement::{Agreement, Comparison};
pub(crate) use before_transient::run_to_transient;
pub use draft::draft;
pub use inputs::{HashedFiles, InputHashes, is_current};
pub use job::{Job, draw_jobs, jobs, run_job, script_text};
pub use outcome::{BearingOutcome, JobOutcome, MemberOutcome};
pub use procedures::{isolator_displacements, procedure_along, procedures, system};
pub use properties::Properties;
pub use runaway::{cut_short, runaway};
pub use study::{BearingType, Floor, Study, is_isolation_study, load, mistake_of_text};
pub use study_file::{Causes, LiveLoad, Transition};

/// Names of the bounds, in the order in which they are run.
pub const BOUNDS: [&str; 3] = ["lower", "nominal", "upper"];
