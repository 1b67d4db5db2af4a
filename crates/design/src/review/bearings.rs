//! Design values of each bearing: displacement, vertical loads of the combinations, stability.

use super::Review;
use super::combinations::{combinations, dead_and_live};
use super::distribution::reduction;
use super::governing::value;
use super::rules::factor;
use crate::isolate::{BOUNDS, BearingOutcome, JobOutcome, Study};
use crate::lateral_force::{overlap, torsional_period_ratio, torsional_ratio};

/// Design values of a bearing.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BearingDesign {
    /// Type: its place in the study.
    pub kind: usize,
    /// Tag of the element.
    pub tag: i64,
    /// Horizontal coordinates of its upper node.
    pub place: Vec<f64>,
    /// Difference of elevation of its nodes; NaN if it is not known.
    pub height: f64,
    /// Displacement of the suite that counts.
    pub displacement: f64,
    /// Bound of the design displacement.
    pub bound: &'static str,
    /// Displacement scaled up where a least value asks for it, and magnified by the code's factor.
    pub design: f64,
    /// D_TM of the plan formula.
    pub plan: f64,
    /// Displacement at the end.
    pub residual: f64,
    /// Axial force under gravity, compression positive.
    pub gravity: f64,
    /// Dead and live load in it: D, and the full L.
    pub dead_live: [f64; 2],
    /// Q_E, the largest changes of the axial force upwards and downwards, scaled up like the shear below.
    pub seismic: [f64; 2],
    /// Average, largest and least vertical load of the combinations.
    pub loads: [f64; 3],
    /// Rise without compression.
    pub uplift: f64,
    /// Largest shear, scaled up like the shear below.
    pub shear: f64,
    /// Work of the shear over the record.
    pub energy: f64,
    /// Largest P/P_cr of the histories; NaN without a critical load.
    pub stability: f64,
    /// P/P_cr of the largest vertical load at the displacement of the suite, and at the design displacement.
    pub stability_design: [f64; 2],
}

/// Total displacements D_TM of the bearings by the plan formula of the code, by bound: D_M times
/// 1 + y/P_T² · 12 e/(b² + d²) with the accidental eccentricity e, at least the share of the code. NaN without a procedure.
pub(super) fn plan_totals(study: &Study, outcomes: &[JobOutcome], review: &Review) -> Vec<Vec<f64>> {
    let code = &study.code;
    let least = code.value("total_displacement", "least").unwrap_or(f64::NAN);
    let count = study.bearings.iter().map(|b| b.tags.len()).sum::<usize>();
    let places = outcomes.iter().map(|o| o.bearings.iter().map(|b| &b.place).collect::<Vec<_>>());
    let places = places.into_iter().find(|p| p.len() == count && p.iter().all(|p| p.len() == 2));
    let ratios = match (study.plan, places, code.value("accidental_eccentricity", "share")) {
        (Some(plan), Some(places), Some(share)) if code.value("total_displacement", "plan").is_some() => {
            let n = count as f64;
            let center = [0, 1].map(|k| places.iter().map(|p| p[k]).sum::<f64>() / n);
            let points: Vec<[f64; 2]> = places.iter().map(|p| [p[0] - center[0], p[1] - center[1]]).collect();
            let torsion = torsional_period_ratio(&points, plan);
            // A force along one side turns the plan about the eccentricity along the other.
            let of = |p: &[f64; 2]| {
                let ratio = |k: usize| torsional_ratio(p[k].abs(), share * plan[k], plan, torsion);
                ratio(0).max(ratio(1)).max(least)
            };
            points.iter().map(of).collect()
        }
        _ => vec![least; count],
    };
    let of = |l: &Result<crate::lateral_force::LateralForce, String>| {
        let d = l.as_ref().map_or(f64::NAN, |l| l.displacement);
        ratios.iter().map(|r| r * d).collect()
    };
    review.lateral_force.iter().map(of).collect()
}

/// γ_x of the code for the kind of structure; 1 without it.
pub(super) fn magnification(study: &Study) -> f64 {
    study.code.value("magnified_displacement", study.structure.name()).unwrap_or(1.0)
}

/// Design values of all bearings. The design values of the structure are there by now.
pub(super) fn bearings(study: &Study, outcomes: &[JobOutcome], review: &Review) -> Vec<BearingDesign> {
    let totals = plan_totals(study, outcomes, review);
    let mut out = vec![];
    for (kind, b) in study.bearings.iter().enumerate() {
        for tag in &b.tags {
            let at = out.len();
            out.push(design(study, outcomes, review, kind, *tag, at, &totals));
        }
    }
    out
}

fn design(
    study: &Study,
    outcomes: &[JobOutcome],
    review: &Review,
    kind: usize,
    tag: i64,
    at: usize,
    totals: &[Vec<f64>],
) -> BearingDesign {
    let by_bound = |of: &dyn Fn(&BearingOutcome) -> f64| {
        BOUNDS.map(|bound| value(study, outcomes, bound, &|o| Some(of(o.bearings.get(at)?))))
    };
    let most = |values: [f64; 3]| values.iter().copied().fold(f64::NAN, f64::max);
    let scaled = |values: [f64; 3], quantity: &str| {
        let of = |k: usize| values[k] * factor(&review.values, BOUNDS[k], quantity);
        [of(0), of(1), of(2)]
    };
    let displacements = by_bound(&|b| b.displacement);
    let designs = scaled(displacements, super::rules::DISPLACEMENT).map(|d| d * magnification(study));
    let place = (0..3).filter(|k| designs[*k].is_finite()).max_by(|a, b| designs[*a].total_cmp(&designs[*b]));
    let gravity = most(by_bound(&|b| b.gravity));
    let dead_live = dead_and_live(study, gravity);
    let seismic = [
        most(scaled(by_bound(&|b| b.compression - b.gravity), super::rules::SHEAR_BELOW)),
        most(scaled(by_bound(&|b| b.gravity - b.least), super::rules::SHEAR_BELOW)),
    ];
    let [most_dead, least_dead] = combinations(study);
    let live_average = study.code.value("load_combinations", "live_average").unwrap_or(f64::NAN);
    let loads = [
        dead_live[0] + live_average * dead_live[1],
        most_dead.of(dead_live) + seismic[0],
        least_dead.of(dead_live) - seismic[1],
    ];
    let b = &study.bearings[kind];
    let design = most(designs);
    let at_displacement = |d: f64| match b.critical_load {
        Some(critical) => {
            let area = b.diameter.map_or(1.0, |diameter| overlap(d, diameter));
            // Without any overlap there is no load that it carries; a number keeps the file readable.
            if loads[1] <= 0.0 { 0.0 } else { (loads[1] / (critical * area)).min(1e9) }
        }
        None => f64::NAN,
    };
    let displacement = most(displacements);
    let further = study.code.value("stability", "displacement").unwrap_or(1.0);
    BearingDesign {
        kind,
        tag,
        height: outcomes.iter().find_map(|o| o.bearings.get(at)?.height).unwrap_or(f64::NAN),
        place: outcomes.iter().find_map(|o| Some(o.bearings.get(at)?.place.clone())).unwrap_or_default(),
        displacement,
        bound: place.map_or("", |k| BOUNDS[k]),
        design,
        plan: totals.iter().filter_map(|t| t.get(at)).copied().fold(f64::NAN, f64::max),
        residual: most(by_bound(&|b| b.residual)),
        gravity,
        dead_live,
        seismic,
        loads,
        uplift: most(by_bound(&|b| b.uplift)),
        shear: most(scaled(by_bound(&|b| b.shear), super::rules::SHEAR_BELOW)),
        energy: most(by_bound(&|b| b.energy)),
        stability: if b.critical_load.is_some() {
            most(by_bound(&|b| b.stability.unwrap_or(f64::NAN)))
        } else {
            f64::NAN
        },
        stability_design: [at_displacement(further * displacement), at_displacement(further * design)],
    }
}

/// Largest shear above over R_I of an outcome; none without floors.
pub(super) fn reduced_shear_above(study: &Study, o: &JobOutcome) -> Option<f64> {
    (study.floors.len() > 1).then(|| o.shear_above / reduction(study))
}
