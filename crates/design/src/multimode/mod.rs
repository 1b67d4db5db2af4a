//! Multimode spectral analysis of an isolation study with effective stiffness and composite damping of the isolators.
//!
//! The script runs up to its first transient analysis. There each bearing gets the effective stiffness K_d + Q_d/D; modes
//! follow, and their damping is that of the isolators and of the structure above, weighted by their strain energies. The
//! spectrum of each mode is divided by the damping coefficient of the code. D is the largest displacement of a bearing of
//! the type, by CQC, and is iterated on: multimode spectral method of the AASHTO Guide Specifications as described by
//! Buckle, Constantinou, Dicleli and Ghasemi, MCEER-06-SP07 (2006).

mod combine;
mod flexibility;
mod linearized;
mod model;
pub mod report;

pub use combine::cqc;
pub use model::ModalModel;

use crate::isolate::{BOUNDS, Study};
use combine::{Combined, combine};

/// A mode of the isolated structure.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mode {
    /// Period in s.
    pub period: f64,
    /// Composite damping.
    pub damping: f64,
    /// Pseudo-acceleration of its damping as a share of gravity.
    pub acceleration: f64,
    /// Share of the effective mass in the direction of the motion.
    pub mass: f64,
    /// Share of the isolators in the strain energy.
    pub isolators: f64,
}

/// Period of a mode and its share of the effective mass in a direction.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PeriodMode {
    /// Period in s.
    pub period: f64,
    /// Share of the effective mass in the direction.
    pub mass: f64,
}

/// Response to a motion in one direction.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Direction {
    /// Modes at the end of the iteration.
    pub modes: Vec<Mode>,
    /// Displacement D of each type of bearing.
    pub displacements: Vec<f64>,
    /// Effective stiffness of a bearing of each type.
    pub stiffnesses: Vec<f64>,
    /// Equivalent damping of each type.
    pub dampings: Vec<f64>,
    /// Iterations.
    pub iterations: usize,
    /// Responses by CQC and by SRSS.
    pub combined: [Combined; 2],
}

/// Response at a bound, for a motion in each horizontal direction.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BoundResponse {
    /// Bound.
    pub bound: &'static str,
    /// By direction of the motion.
    pub directions: Vec<Direction>,
    /// Largest displacement of each type of bearing under 100 % of one direction and 30 % of the other, by CQC.
    pub displacements: Vec<f64>,
}

/// Relative change of the displacements at which the iteration ends.
const TOLERANCE: f64 = 1e-8;
/// Iterations at most.
const MAX_ITERATIONS: usize = 200;
/// Share of the second direction.
const SECOND: f64 = 0.3;

/// Stiffness K_d + Q_d/D and damping 4 Q_d (D - D_y)/(2π k D²) of bearings of each type.
fn effective(study: &Study, bound: &str, d: &[f64]) -> (Vec<f64>, Vec<f64>) {
    let of = |(b, d): (&crate::isolate::BearingType, &f64)| {
        let (q, k_d) = (b.q_d * study.factor(b, bound, 0), b.k_d * study.factor(b, bound, 1));
        let k = k_d + q / d;
        let energy = 4.0 * q * (d - b.yield_displacement).max(0.0);
        (k, energy / (std::f64::consts::TAU * k * d * d))
    };
    study.bearings.iter().zip(d).map(of).unzip()
}

/// Responses at a bound.
///
/// # Errors
/// The script fails before its transient analysis, the spectrum has no value at the period of a mode, or the displacement
/// does not settle.
pub fn respond(study: &Study, bound: &'static str, modes: usize) -> Result<BoundResponse, String> {
    let mut model = ModalModel::new(study, bound, modes)?;
    let mut out = BoundResponse { bound, ..BoundResponse::default() };
    for direction in 0..model.horizontal() {
        out.directions.push(iterate(study, &mut model, bound, direction)?);
    }
    // Both directions together: the displacements of each bearing are added by component.
    let all: Vec<&Vec<Vec<f64>>> = out.directions.iter().map(|d| &d.combined[0].bearings).collect();
    let mut place = 0;
    for kind in &study.bearings {
        let mut largest = 0.0f64;
        for _ in &kind.tags {
            for first in 0..all.len() {
                let component = |h: usize| -> f64 {
                    let share = |d: usize| if d == first { 1.0 } else { SECOND };
                    all.iter().enumerate().map(|(d, b)| share(d) * b[place][h]).sum()
                };
                let vector = (0..all.len()).map(|h| component(h).powi(2)).sum::<f64>().sqrt();
                largest = largest.max(vector);
            }
            place += 1;
        }
        out.displacements.push(largest);
    }
    Ok(out)
}

fn iterate(study: &Study, model: &mut ModalModel, bound: &str, direction: usize) -> Result<Direction, String> {
    let start = study.meter() * study.target.at(2.0) / std::f64::consts::PI.powi(2);
    let mut d = vec![start; study.bearings.len()];
    for iterations in 1..=MAX_ITERATIONS {
        let (stiffnesses, dampings) = effective(study, bound, &d);
        model.linearize(study, &stiffnesses)?;
        let modes = model.modes(study, &stiffnesses, &dampings, direction)?;
        let combined = [true, false].map(|by_cqc| combine(study, model, &modes, direction, &stiffnesses, by_cqc));
        let next = combined[0].largest(study);
        let change = d.iter().zip(&next).map(|(a, b)| (b / a - 1.0).abs()).fold(0.0, f64::max);
        if change < TOLERANCE {
            return Ok(Direction { modes, displacements: d, stiffnesses, dampings, iterations, combined });
        }
        if next.iter().any(|x| !(*x > 0.0 && x.is_finite())) {
            return Err(format!("bearings do not move under a motion in direction {}", direction + 1));
        }
        // Half of the change: the full one goes to and fro where the damping changes fast.
        d = d.iter().zip(&next).map(|(a, b)| 0.5 * (a + b)).collect();
    }
    Err(format!("the displacement of the multimode method did not settle in {MAX_ITERATIONS} iterations"))
}

/// Responses at all bounds.
///
/// # Errors
/// Those of [`respond`].
pub fn respond_at_bounds(study: &Study, modes: usize) -> Result<Vec<BoundResponse>, String> {
    BOUNDS.iter().map(|b| respond(study, b, modes)).collect()
}
