//! Forces of the equivalent lateral force procedure over the height.

use crate::isolate::{BOUNDS, Study, system};
use crate::lateral_force::LateralForce;

/// Forces of a bound over the height.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct StoreyForces {
    /// Bound.
    pub bound: &'static str,
    /// R_I.
    pub reduction: f64,
    /// Least V_s by activation of the isolation system.
    pub activation: f64,
    /// Least V_s by a structure on a fixed base with T_M.
    pub fixed_base: f64,
    /// Design shear above V_s.
    pub shear_above: f64,
    /// Exponent k of the heights; NaN without the period on a fixed base.
    pub exponent: f64,
    /// Forces of the floors, F_1 of the base level first; empty without the exponent.
    pub forces: Vec<f64>,
}

/// R_I of the structure above: a share of R between limits of the code; 1 where the code has none.
pub(super) fn reduction(study: &Study) -> f64 {
    let value = |name: &str| study.code.value("force_above", name);
    match (value("response_share"), value("response_least"), value("response_most")) {
        (Some(share), Some(least), Some(most)) => (share * study.response_modification).clamp(least, most),
        _ => 1.0,
    }
}

/// Exponent of W_s/W in V_st at a bound.
fn weight_exponent(study: &Study, l: &LateralForce, is_abrupt: bool) -> f64 {
    let shape = if is_abrupt { "abrupt" } else { "smooth" };
    1.0 - study.code.value("force_above", shape).unwrap_or(f64::NAN) * l.damping
}

/// Shear of a structure on a fixed base with the weight W_s at a period: the design share of the target over R.
pub fn fixed_base_shear(study: &Study, period: f64) -> Option<f64> {
    let share = study.code.value("force_minimum_fixed", "design_share")?;
    let acceleration = share * study.target.at(period) / crate::motion::G;
    Some(acceleration * study.weight_above() / study.response_modification)
}

/// Shears and forces of a code that has them; `None` else. `fixed_period` is T_fb, NaN if it is not known.
pub(super) fn storey_forces(
    study: &Study,
    procedures: &[Result<LateralForce, String>],
    bound: usize,
    fixed_period: f64,
) -> Option<StoreyForces> {
    let code = &study.code;
    let l = procedures[bound].as_ref().ok().filter(|l| l.shear_above.is_finite())?;
    if study.floors.len() < 2 {
        return None;
    }
    let reduction = reduction(study);
    // F_y = Q_d + K_d D_y: that of the upper bound, or more than that of the nominal one.
    let yields = |bound: &str| {
        let s = system(study, bound);
        s.q_d + s.k_d * s.yield_displacement
    };
    let factor = code.value("force_minimum", "activation")?;
    let activation = yields("upper").max(factor * yields("nominal"));
    let share = study.weight_above() / study.weight;
    let activation = activation * share.powf(weight_exponent(study, l, system(study, BOUNDS[bound]).abrupt));
    let stiffest = procedures.last().and_then(|p| p.as_ref().ok()).map_or(f64::NAN, |l| l.period);
    let fixed_base = fixed_base_shear(study, stiffest).unwrap_or(f64::NAN);
    let shear_above = (l.shear_above / reduction).max(activation).max(fixed_base);
    let exponent = code.value("vertical_distribution", "exponent").map_or(f64::NAN, |e| e * l.damping * fixed_period);
    let forces = match exponent.is_finite() {
        true => forces(study, l, reduction, shear_above, exponent),
        false => vec![],
    };
    Some(StoreyForces { bound: BOUNDS[bound], reduction, activation, fixed_base, shear_above, exponent, forces })
}

/// F_1 = (V_b - V_st)/R_I of the base level and F_x = V_s w h^k/Σ w h^k of the floors above.
fn forces(study: &Study, l: &LateralForce, reduction: f64, shear_above: f64, exponent: f64) -> Vec<f64> {
    let mut height = 0.0;
    let moments: Vec<f64> = study.floors[1..]
        .iter()
        .map(|f| {
            height += f.height;
            f.weight * f64::powf(height, exponent)
        })
        .collect();
    let sum: f64 = moments.iter().sum();
    let first = (l.shear_below - l.shear_above) / reduction;
    std::iter::once(first).chain(moments.iter().map(|m| shear_above * m / sum)).collect()
}
