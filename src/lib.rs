//! Structural analysis of buildings and bridges on seismic isolation: runs OpenSees Tcl scripts.
//!
//! # Units and signs
//! Numbers have the units that the script gives them; any consistent set will do, and nothing is converted. Angles are
//! in radians, times in the unit of the time series.
//!
//! Coordinates, displacements, loads and reactions are global and positive along the axes; rotations and moments follow
//! the right hand. Axial strain and force are positive in tension. End forces of an element are those that the nodes
//! exert on it; accelerations under a uniform excitation are relative to the ground.
//!
//! # Examples
//! `examples/run_script.rs` runs a script and takes out what its recorders write, `examples/calibrate_study.rs` calibrates
//! a study, `examples/diagnose_study.rs` diagnoses one.
//!
//! # A script in memory
//! ```
//! use hysteron::analysis::Options;
//! use hysteron::opensees::{FileFormat, Mode, Outputs};
//! use hysteron::record::{Memory, Output, RecordError};
//! use hysteron::run::{End, Run, Settings};
//! use hysteron::tcl::{MemoryFiles, Recorded};
//! use std::path::Path;
//!
//! /// Keeps what recorders write.
//! struct Keep;
//!
//! impl Outputs for Keep {
//!     fn create(&mut self, _: &str, _: &Path, _: FileFormat) -> Result<Box<dyn Output>, RecordError> {
//!         Ok(Box::new(Memory::default()))
//!     }
//! }
//!
//! // A cantilever of 3 m with EI = 200 kN m2 under 1 kN at its end: P L^3 / (3 E I) = 0.045 m.
//! let files = MemoryFiles::default();
//! files.insert(
//!     "/model.tcl",
//!     "model BasicBuilder -ndm 2 -ndf 3
//!      node 1 0 0; node 2 3 0; fix 1 1 1 1
//!      geomTransf Linear 1
//!      element elasticBeamColumn 1 1 2 0.01 2e6 1e-4 1
//!      timeSeries Linear 1
//!      pattern Plain 1 1 { load 2 0 -1 0 }
//!      integrator LoadControl 1; algorithm Linear; analysis Static; analyze 1
//!      puts [format %.4f [nodeDisp 2 2]]",
//! );
//! let console = Recorded::default();
//! let settings = Settings { mode: Mode::Run, strict: false, options: Options::default() };
//! let mut run = Run::new(settings, Box::new(console.clone()), Box::new(files), Box::new(Keep));
//! assert!(matches!(run.script("model.tcl", &[]), End::Done));
//! assert_eq!(console.out(), "-0.0450\n");
//! ```

#![forbid(unsafe_code)]

pub mod checks;

pub use hysteron_design as design;
pub use hysteron_diagnose as diagnose;
pub use hysteron_engine::{
    analysis, element, material, model, probe, record, rules, section, series, state_struct, watches_columns,
};
// Parts of the engine that no program needs.
pub use hysteron_calls as calls;
#[doc(hidden)]
pub use hysteron_engine::{assembly, bytes, number_format, numeric, parameter, solve};
pub use hysteron_identify::{calibrate, measure, preflight, protocol, report, study};
pub use hysteron_lsp as lsp;
pub use hysteron_opensees::{self as opensees, run};
pub use hysteron_recordings as recordings;
pub use hysteron_tcl::{self as tcl, diagnostic};
pub use hysteron_view as view;
