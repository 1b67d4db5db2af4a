//! What engineers read from hysteresis loops: stiffness, dissipated energy, equivalent damping, cycle by cycle.
//!
//! Displacements and forces may be of any consistent set of units, or strains and stresses. Samples need not be at equal
//! steps of time: nothing here depends on it.
//!
//! ```
//! use hysteron_identify::measure::{Loop, Split};
//! use std::f64::consts::TAU;
//!
//! // Two cycles of a spring of 3 beside a damper: an ellipse, of which everything is known.
//! let phase: Vec<f64> = (0..=2000).map(|i| 2.0 * TAU * f64::from(i) / 2000.0).collect();
//! let u: Vec<f64> = phase.iter().map(|p| 0.1 * p.sin()).collect();
//! let f: Vec<f64> = phase.iter().map(|p| 0.3 * p.sin() + 0.06 * p.cos()).collect();
//! let cycles = Split::default().cycles(&u);
//! assert_eq!(cycles.len(), 2);
//! let measured = Loop::of(&u[cycles[1].samples.clone()], &f[cycles[1].samples.clone()]);
//! assert!((measured.energy - 0.1 * 0.06 * TAU / 2.0).abs() < 1e-6);
//! assert!((measured.damping() - 0.06 / (2.0 * 0.3f64.hypot(0.06))).abs() < 1e-5);
//! ```

mod cycles;
mod hysteresis;
mod orbit;

pub use cycles::{Cycle, Sides, Split};
pub use hysteresis::{Loop, ShearLoop, Specimen, work};
pub use orbit::{Orbit, orbits};
