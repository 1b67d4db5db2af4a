//! Published numbers done again: `validation/design/README.md` has the table of differences.

#![allow(clippy::unwrap_used)]

use hysteron_design::fragility::{Fit, Observation};
use hysteron_design::lateral_force::{torsional_period_ratio, torsional_ratio};
use hysteron_design::prototype::{PrototypeTest, TestRecord};
use hysteron_identify::measure::CycleDetection;
use std::f64::consts::PI;

/// Stripes of eight wood frames, 45 records each: Dahal, Burton and Onyambu (2022), Structural Safety 96, 102185; data and
/// medians with dispersions by the authors in their pyFragility (datasets/msa_wood_frame.csv, tests/data/legacy_golden.json).
const LEVELS: [f64; 16] =
    [0.178, 0.274, 0.444, 0.56, 0.652, 0.79, 0.982, 1.246, 1.564, 2.014, 2.417, 3.021, 3.625, 4.028, 4.431, 5.035];
const FRAMES: [(&str, [i32; 16], f64, f64); 8] = [
    ("B1-Existing", [0, 0, 0, 0, 0, 4, 13, 23, 38, 41, 44, 45, 45, 45, 45, 45], 1.2194177469, 0.3100601604),
    ("B1-Retrofit", [0, 0, 0, 0, 0, 0, 0, 0, 0, 3, 9, 22, 30, 37, 39, 41], 3.1451578899, 0.3032742466),
    ("B2-Existing", [0, 0, 0, 0, 0, 1, 4, 6, 14, 14, 22, 31, 34, 36, 37, 43], 2.3811658770, 0.5717594549),
    ("B2-Retrofit", [0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 4, 9, 15, 16, 23, 27], 4.4462050343, 0.3992640033),
    ("B3-Existing", [0, 0, 2, 10, 11, 25, 28, 39, 43, 44, 45, 45, 45, 45, 45, 45], 0.8125459507, 0.3980921369),
    ("B3-Retrofit", [0, 0, 0, 0, 0, 0, 1, 4, 9, 11, 15, 25, 34, 36, 37, 39], 2.7304487650, 0.5174335519),
    ("B4-Existing", [0, 0, 0, 2, 4, 9, 10, 18, 25, 34, 37, 41, 43, 44, 45, 45], 1.4069641529, 0.5328392402),
    ("B4-Retrofit", [0, 0, 0, 0, 0, 0, 1, 3, 10, 10, 17, 26, 34, 35, 38, 42], 2.6711391730, 0.4905725712),
];

/// The authors' values come from a search of the simplex to 1e-4.
#[test]
fn fragility_of_eight_wood_frames() {
    for (name, reached, median, dispersion) in FRAMES {
        let counts = LEVELS
            .iter()
            .zip(reached)
            .flat_map(|(x, k)| [(f64::from(k), Observation::Below(*x)), (f64::from(45 - k), Observation::Above(*x))]);
        let f = Fit::new(&counts.collect::<Vec<_>>()).unwrap();
        let off = [f.median / median - 1.0, f.dispersion / dispersion - 1.0];
        assert!(off.iter().all(|d| d.abs() < 1e-4), "{name}: {f:?} {off:?}");
        assert!(f.median_interval[0] < median && median < f.median_interval[1]);
    }
}

/// D_TD/D_D of the design example in the worksheet "Isolated Building" (UBC 1997): plan dimensions
/// 5.03 and 6.23, eccentricity 0.31, distance 3.1, ratio 1.182. The eccentricity is 5 % of the longer side and the distance half of
/// it: 0.3115 and 3.115 before rounding. UBC has no period ratio.
#[test]
fn torsional_ratio_of_a_worksheet() {
    let plan = [5.03, 6.23];
    let ratio = torsional_ratio(0.5 * plan[1], 0.05 * plan[1], plan, 1.0);
    assert!((ratio - 1.182).abs() < 0.0005, "{ratio}");
    // Four bearings at the corners are stiffer in torsion, which ASCE 7-16 allows to count.
    let corners = [[2.515, 3.115], [-2.515, 3.115], [2.515, -3.115], [-2.515, -3.115]];
    let torsion = torsional_period_ratio(&corners, plan);
    assert!((torsion - 3f64.sqrt()).abs() < 1e-12, "{torsion}");
}

/// A high damping bearing at two amplitudes, a solved problem on isolation design (scribd 518237683, read as an excerpt): amplitude in
/// inches, largest force in kips, energy of a cycle in kip inches, and by the solution storage stiffness K_1, K_eff = p_0/u_0 and
/// loss stiffness K_2 in kips an inch and damping in per cent.
const BEARING: [[f64; 7]; 2] =
    [[2.43, 7.20, 15.27, 2.84, 2.96, 0.82, 13.87], [4.00, 11.60, 35.58, 2.81, 2.90, 0.71, 12.20]];

#[test]
fn loops_of_a_high_damping_bearing() {
    for [u0, p0, energy, storage, effective, loss, damping] in BEARING {
        // The ellipse with this amplitude, largest force and energy.
        let k2 = energy / (PI * u0 * u0);
        let k1 = ((p0 / u0).powi(2) - k2 * k2).sqrt();
        let t: Vec<f64> = (0..=4000).map(|i| 0.002 * f64::from(i)).collect();
        let u: Vec<f64> = t.iter().map(|t| u0 * (PI * t).sin()).collect();
        let f: Vec<f64> = t.iter().map(|t| u0 * (k1 * (PI * t).sin() + k2 * (PI * t).cos())).collect();
        let record = TestRecord { time: Some(&t), u: &u, f: &f };
        let test = PrototypeTest::measure("problem", &record, &CycleDetection::default(), 10.0).unwrap();
        let c = &test.cycles[1];
        // Rounding of the solution: amplitudes have three digits.
        assert!((c.amplitude / u0 - 1.0).abs() < 1e-3 && (c.edc / energy - 1.0).abs() < 2e-3, "{c:?}");
        assert!((c.k_eff - effective).abs() < 0.005 && (k1 - storage).abs() < 0.01, "{c:?}");
        assert!((c.edc / (PI * c.amplitude.powi(2)) - loss).abs() < 0.005);
        assert!((100.0 * c.beta - damping).abs() < 0.03, "{c:?}");
    }
}
