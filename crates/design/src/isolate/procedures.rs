//! The equivalent lateral force procedure of a study at each bound.

use super::BOUNDS;
use super::study::{BearingType, Study};
use super::study_file::Transition;
use crate::lateral_force::{LateralForce, System};
use crate::supports::{BridgeResponse, Support, simplified_method};

/// Share of the strength of all bearings from which on those with abrupt loops make the loop of the system abrupt.
const ABRUPT_SHARE: f64 = 0.1;

/// The system of all bearings at a bound.
pub fn system(study: &Study, bound: &str) -> System {
    let (mut q_d, mut k_d, mut yields, mut abrupt) = (0.0, 0.0, 0.0, 0.0);
    for b in &study.bearings {
        let n = b.tags.len() as f64;
        let q = n * b.q_d * study.factor(b, bound, 0);
        q_d += q;
        k_d += n * b.k_d * study.factor(b, bound, 1);
        yields += q * b.yield_displacement;
        abrupt += if b.transition == Transition::Abrupt { q } else { 0.0 };
    }
    System {
        q_d,
        k_d,
        yield_displacement: if q_d > 0.0 { yields / q_d } else { 0.0 },
        weight: study.weight,
        weight_above: study.weight_above(),
        gravity: study.gravity,
        abrupt: abrupt > ABRUPT_SHARE * q_d,
    }
}

/// The equivalent lateral force procedure of each bound; the simplified method for bridges where substructures are given, in the
/// direction with the larger displacement.
pub fn procedures(study: &Study) -> Vec<Result<LateralForce, String>> {
    let of = |bound: &&str| match has_substructures(study) {
        true => bridge(study, bound).map(LateralForce::from),
        false => system(study, bound).procedure(|t| study.meter() * study.target.at(t), &study.code),
    };
    BOUNDS.iter().map(of).collect()
}

/// The procedure of a bound along x (0) or y (1).
///
/// # Errors
/// The errors of the procedure.
pub fn procedure_along(study: &Study, bound: &str, direction: usize) -> Result<LateralForce, String> {
    match has_substructures(study) {
        true => bridge_along(study, bound, direction).map(LateralForce::from),
        false => system(study, bound).procedure(|t| study.meter() * study.target.at(t), &study.code),
    }
}

fn has_substructures(study: &Study) -> bool {
    study.bearings.iter().any(|b| b.substructure.is_some())
}

/// The simplified method at a bound in the direction with the larger displacement.
fn bridge(study: &Study, bound: &str) -> Result<BridgeResponse, String> {
    let [x, y] = [0, 1].map(|direction| bridge_along(study, bound, direction));
    let (x, y) = (x?, y?);
    Ok(if y.displacement > x.displacement { y } else { x })
}

/// The simplified method at a bound, with one support for each type of bearing.
fn bridge_along(study: &Study, bound: &str, direction: usize) -> Result<BridgeResponse, String> {
    let supports: Vec<Support> = study.bearings.iter().map(|b| support(study, b, bound, direction)).collect();
    let spectrum = |t: f64| study.meter() * study.target.at(t);
    let weight = study.weight + study.substructure_weight;
    simplified_method(|_| supports.clone(), weight, study.gravity, spectrum, &study.code)
}

/// Displacements of the bearings of each type in the procedure of a bound.
///
/// # Errors
/// The errors of the procedure.
pub fn isolator_displacements(study: &Study, bound: &str) -> Result<Vec<f64>, String> {
    if has_substructures(study) {
        return Ok(bridge(study, bound)?.supports.iter().map(|s| s.isolators).collect());
    }
    let found = system(study, bound).procedure(|t| study.meter() * study.target.at(t), &study.code)?;
    Ok(vec![found.displacement; study.bearings.len()])
}

/// All bearings of a type on their substructures.
fn support(study: &Study, b: &BearingType, bound: &str, direction: usize) -> Support {
    let n = b.tags.len() as f64;
    Support {
        q_d: n * b.q_d * study.factor(b, bound, 0),
        k_d: n * b.k_d * study.factor(b, bound, 1),
        yield_displacement: b.yield_displacement,
        substructure: b.substructure.map_or(f64::INFINITY, |k| n * k[direction]),
    }
}
