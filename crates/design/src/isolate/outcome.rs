//! Result of one analysis of a study.

use serde::{Deserialize, Serialize};

/// Extremes of a bearing.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct BearingOutcome {
    /// Tag of the element.
    pub tag: i64,
    /// Horizontal coordinates of its upper node.
    pub place: Vec<f64>,
    /// Difference of elevation of its nodes.
    #[serde(default)]
    pub height: Option<f64>,
    /// Largest horizontal displacement: vector sum.
    pub displacement: f64,
    /// Displacement at the end: vector sum of the means of the last tenth of the record.
    pub residual: f64,
    /// Axial force before the motion, compression positive.
    pub gravity: f64,
    /// Largest axial force, compression positive.
    pub compression: f64,
    /// Smallest axial force; tension is negative.
    pub least: f64,
    /// Uplift: largest rise of the upper node above its place without load while the bearing has no compression.
    pub uplift: f64,
    /// Largest shear: vector sum.
    pub shear: f64,
    /// Work of the shear over the record.
    pub energy: f64,
    /// Largest P/P_cr with the overlapping area at each time; none without a critical load.
    pub stability: Option<f64>,
    /// Displacements and forces in the first direction, thinned, of the bearing of a type that moves farthest.
    pub hysteresis: Vec<[f64; 2]>,
    /// Orbit, thinned, of such a bearing; empty in a plane.
    pub orbit: Vec<[f64; 2]>,
}

/// Local end forces of a beam or column, as the recorder `localForce` has them.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct MemberOutcome {
    /// Tag of the element.
    pub tag: i64,
    /// Forces before the motion.
    pub gravity: Vec<f64>,
    /// Largest forces.
    pub largest: Vec<f64>,
    /// Least forces.
    pub least: Vec<f64>,
}

/// Extremes of an analysis.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct JobOutcome {
    /// Hash of the study, the script and the records.
    pub fingerprint: u64,
    /// Bound.
    pub bound: String,
    /// Name of the motion.
    pub motion: String,
    /// Accidental eccentricities.
    pub eccentricity: [f64; 2],
    /// Description of a failure; empty if the analysis is complete.
    pub failure: String,
    /// Last time of the analysis.
    pub time: f64,
    /// Length of the analysis in s.
    #[serde(default)]
    pub duration: f64,
    /// Warnings of the script by place and check.
    #[serde(default)]
    pub warnings: Vec<(String, String)>,
    /// True if the script's own steps failed, and shorter ones with other algorithms were tried.
    pub retried: bool,
    /// Files that the script has read, with their hashes.
    pub inputs: Vec<(String, u64)>,
    /// Bearings, in the order of the study.
    pub bearings: Vec<BearingOutcome>,
    /// Largest shear of all bearings together: vector sum.
    pub base_shear: f64,
    /// Largest inertia force of the floors above the base level: vector sum. Zero without floors.
    pub shear_above: f64,
    /// Largest storey drift ratios in either direction, from the base level upwards.
    pub drifts: Vec<f64>,
    /// Largest absolute accelerations of the floors in either direction, as a share of gravity.
    pub accelerations: Vec<f64>,
    /// Largest displacements of the lowest floor in each horizontal direction, from the ground.
    pub base_displacement: Vec<f64>,
    /// Largest forces of the elements of contact, by their tags.
    pub contact: Vec<(i64, f64)>,
    /// Beams and columns, in the order of the study.
    pub members: Vec<MemberOutcome>,
    /// Share of the energy that goes into the isolators and is taken by Rayleigh damping.
    pub damping_share: f64,
    /// Periods of the floor spectra in s.
    pub periods: Vec<f64>,
    /// Floor spectra: the larger of both directions, as a share of gravity, for 5 % damping.
    pub floor_spectra: Vec<Vec<f64>>,
}
