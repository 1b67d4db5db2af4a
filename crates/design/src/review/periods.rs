//! Periods of the structure on a fixed base and on its bearings, beside those of the equivalent lateral force procedure.

use crate::isolate::{BOUNDS, Study, isolator_displacements, procedure_along};
use crate::lateral_force::LateralForce;
use crate::mistake::{Mistake, key};
use crate::multimode::{ModalModel, PeriodMode};

/// Modes by direction of motion, for the fixed base and for each bound.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Periods {
    /// On a fixed base; a description where there are none.
    pub fixed: Option<Result<Vec<Vec<PeriodMode>>, String>>,
    /// On bearings with K_eff at the displacement of the procedure, by bound.
    pub isolated: Vec<Result<Vec<Vec<PeriodMode>>, String>>,
    /// Storey drift ratios on a fixed base under a unit force at each floor: `[direction][floor of the force][storey]`. Empty if
    /// the code has no limit of drifts of lateral forces; a description where they are not found.
    pub drifts: Option<Result<Vec<Vec<Vec<f64>>>, String>>,
}

/// Modes that are found.
const MODES: usize = 6;
/// Stiffness of bearings that stand for a fixed base, over the effective one.
const FIXED: f64 = 1.0e6;
/// Deviation of the period of the model from the range of the procedure, at most.
const DEVIATION: f64 = 0.05;

/// Find the periods. The script runs once for the fixed base and once for each bound.
pub fn periods(study: &Study) -> Periods {
    let of = |bound: &'static str, factor: f64| -> Result<ModalModel, String> {
        let displacements = isolator_displacements(study, bound)?;
        let stiffness = |(b, d): (&crate::isolate::BearingType, &f64)| {
            factor * (b.k_d * study.factor(b, bound, 1) + b.q_d * study.factor(b, bound, 0) / d)
        };
        let stiffnesses: Vec<f64> = study.bearings.iter().zip(&displacements).map(stiffness).collect();
        ModalModel::at(study, bound, &stiffnesses, MODES)
    };
    let mut fixed = of("nominal", FIXED);
    let has_drifts = study.floors.len() > 1 && study.code.value("elf_drift", "most").is_some();
    let drifts = fixed.as_mut().ok().filter(|_| has_drifts).map(|model| model.drifts(study));
    let isolated = BOUNDS.iter().map(|b| of(b, 1.0).map(|model| model.periods())).collect();
    Periods { fixed: Some(fixed.map(|model| model.periods())), isolated, drifts }
}

/// The mode with the largest mass.
fn main_mode(modes: &[PeriodMode]) -> Option<PeriodMode> {
    modes.iter().copied().reduce(|a, b| if b.mass > a.mass { b } else { a })
}

impl Periods {
    /// Period on a fixed base of the main mode, the longest over the directions; NaN if it is not known.
    pub fn fixed_base(&self) -> f64 {
        let Some(Ok(fixed)) = &self.fixed else { return f64::NAN };
        fixed.iter().filter_map(|m| main_mode(m)).map(|m| m.period).fold(f64::NAN, f64::max)
    }

    /// Largest storey drift ratio under forces of the floors; `None` if it is not known.
    pub fn largest_drift(&self, forces: &[f64]) -> Option<f64> {
        let Some(Ok(all)) = &self.drifts else { return None };
        let storey = |of_direction: &[Vec<f64>], s: usize| -> f64 {
            forces.iter().zip(of_direction).map(|(f, row)| f * row.get(s).copied().unwrap_or(0.0)).sum()
        };
        let of = |d: &Vec<Vec<f64>>| (0..d.first().map_or(0, Vec::len)).map(|s| storey(d, s).abs()).fold(0.0, f64::max);
        all.iter().map(of).reduce(f64::max).filter(|_| !forces.is_empty())
    }

    /// Main modes of a bound by direction.
    pub fn main(&self, bound: usize) -> Vec<PeriodMode> {
        let found = self.isolated.get(bound).and_then(|r| r.as_ref().ok());
        found.map_or(vec![], |all| all.iter().filter_map(|m| main_mode(m)).collect())
    }

    /// Reasons why periods are missing.
    pub(super) fn remarks(&self) -> Vec<String> {
        let fixed = self.fixed.iter().filter_map(|f| f.as_ref().err()).map(|e| format!("period on a fixed base: {e}"));
        let isolated = BOUNDS.iter().zip(&self.isolated).filter_map(|(b, r)| Some((b, r.as_ref().err()?)));
        let drifts = self.drifts.iter().filter_map(|d| d.as_ref().err()).cloned();
        fixed.chain(drifts).chain(isolated.map(|(b, e)| format!("periods of the {b} bound: {e}"))).collect()
    }

    /// Compare the periods of the model with those of the procedure: with the mass of the model, T lies between T_M and
    /// sqrt(T_M² + T_fb²) (Dunkerley).
    ///
    /// # Errors
    /// A period lies outside. The message has both.
    pub fn agree(&self, study: &Study) -> Result<(), Mistake> {
        let fixed = self.fixed_base();
        if fixed.is_nan() {
            return Ok(());
        }
        // The procedure moves the weight, the model its mass. Substructures that move with it are in neither.
        let whole = 1.0 + study.substructure_weight / study.weight;
        for (k, bound) in BOUNDS.iter().enumerate() {
            for (direction, mode) in self.main(k).iter().enumerate() {
                let Ok(LateralForce { period, .. }) = procedure_along(study, bound, direction) else { continue };
                let t = period * (study.mass_over_weight / whole).sqrt();
                let [from, to] = [(1.0 - DEVIATION) * t, (1.0 + DEVIATION) * t.hypot(fixed)];
                if !(from..=to).contains(&mode.period) {
                    let message = format!(
                        "\"{}\": the period of the model in {} with its bearings at K_eff ({bound} bound) is {:.4} s, but the \
                         equivalent lateral force procedure has {t:.4} s with the same mass: expected {from:.4} to {to:.4} s, \
                         since the structure on a fixed base has {fixed:.4} s. Members or springs bridge the isolation plane, \
                         bearings are missing in the study, or masses stand in the wrong place",
                        study.script.display(),
                        ["x", "y"][direction.min(1)],
                        mode.period,
                    );
                    return Err(Mistake::new(key!["script"], message));
                }
            }
        }
        Ok(())
    }
}
