//! The verdict: most probable cause, repaired model, and the files that present them.
//!
//! - [`diagnosis`]: the way from a study to its diagnosis
//! - [`conclusion`]: from ranked hypotheses to the verdict and the repair
//! - [`explanation`]: the verdict in words
//! - [`mismatch`]: windows of time in which the model differs
//! - [`discriminating_test`]: the test that best separates the verdict from its strongest competitor
//! - [`result_file`]: the file `diagnosis.json`
//! - [`report`]: the file `report.html`

pub(crate) mod conclusion;
pub(crate) mod diagnosis;
pub(crate) mod discriminating_test;
pub(crate) mod explanation;
pub(crate) mod mismatch;
pub(crate) mod report;
pub(crate) mod result_file;
