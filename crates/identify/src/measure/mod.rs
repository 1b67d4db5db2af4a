//! Measures of hysteresis loops, cycle by cycle: stiffness, dissipated energy, equivalent damping.
//!
//! Displacements and forces have any consistent set of units; strains and stresses will do as well. Time steps may differ.
//!
//! ```
//! use hysteron_identify::measure::{CycleDetection, Loop};
//! use std::f64::consts::TAU;
//!
//! // Two cycles of a spring of stiffness 3 in parallel with a damper: an ellipse.
//! let phase: Vec<f64> = (0..=2000).map(|i| 2.0 * TAU * f64::from(i) / 2000.0).collect();
//! let u: Vec<f64> = phase.iter().map(|p| 0.1 * p.sin()).collect();
//! let f: Vec<f64> = phase.iter().map(|p| 0.3 * p.sin() + 0.06 * p.cos()).collect();
//! let cycles = CycleDetection::default().cycles(&u);
//! assert_eq!(cycles.len(), 2);
//! let measured = Loop::of(&u[cycles[1].samples.clone()], &f[cycles[1].samples.clone()]);
//! assert!((measured.energy - 0.1 * 0.06 * TAU / 2.0).abs() < 1e-6);
//! assert!((measured.damping() - 0.06 / (2.0 * 0.3f64.hypot(0.06))).abs() < 1e-5);
//! ```

mod cycles;
mod hysteresis;
mod orbit;

pub use cycles::{Cycle, CycleDetection, Sides};
pub use hysteresis::{Loop, ShearLoop, Specimen, work};
pub use orbit::{Orbit, orbits};
