//! The rules of a code applied to the results of a suite.

use super::Review;
use super::bearings::{bearings, magnification, plan_totals, reduced_shear_above};
use super::distribution::{reduction, storey_forces};
use super::governing::{top, value};
use crate::check::{Check, Citation, Status};
use crate::isolate::{BOUNDS, JobOutcome, Study, system};
use hysteron_identify::report::html::number;
use std::f64::consts::TAU;

/// Largest displacement of the bearings.
pub(super) const DISPLACEMENT: &str = "displacement of bearings";
/// Shear of all bearings.
pub(super) const SHEAR_BELOW: &str = "shear below";
/// Inertia force of the floors above the base level over R_I.
pub(super) const SHEAR_ABOVE: &str = "shear above over R_I";

/// A result of the suite with its least value and the design value.
#[derive(Clone, Debug, PartialEq)]
pub struct DesignValue {
    /// Bound.
    pub bound: &'static str,
    /// Quantity.
    pub quantity: &'static str,
    /// Unit.
    pub unit: String,
    /// Value of the suite that counts.
    pub analysis: f64,
    /// Least value by the code; NaN without one.
    pub least: f64,
    /// Factor on the analysis, 1 or more.
    pub factor: f64,
    /// Design value.
    pub design: f64,
    /// Clause of the least value.
    pub citation: Citation,
}

impl DesignValue {
    fn new(
        bound: &'static str,
        quantity: &'static str,
        unit: &str,
        analysis: f64,
        least: f64,
        citation: Citation,
    ) -> Self {
        let factor = (least / analysis).max(1.0);
        // Without a least value the analysis itself counts.
        let factor = if factor.is_finite() { factor } else { 1.0 };
        Self { bound, quantity, unit: unit.into(), analysis, least, factor, design: factor * analysis, citation }
    }

    /// The least value as a check, which asks for scaling where it is not reached.
    fn check(&self) -> Check {
        let mut check = Check::at_least(
            format!("{}: {}", self.bound, self.quantity),
            self.citation.clone(),
            self.analysis,
            self.least,
        );
        if check.status == Status::NotMet {
            check.subject += &format!(", scaled by {} to {}", number(self.factor), number(self.design));
        }
        check.or_else(Status::Scaled)
    }
}

/// Factor on a quantity at a bound; 1 without a design value.
pub(super) fn factor(values: &[DesignValue], bound: &str, quantity: &str) -> f64 {
    values.iter().find(|v| v.bound == bound && v.quantity == quantity).map_or(1.0, |v| v.factor)
}

/// Fill design values, bearings, forces and checks.
pub(super) fn apply(study: &Study, outcomes: &[JobOutcome], out: &mut Review) {
    let fixed = out.periods.fixed_base();
    for k in 0..BOUNDS.len() {
        out.forces.extend(storey_forces(study, &out.lateral_force, k, fixed));
    }
    design_values(study, outcomes, out);
    out.bearings = bearings(study, outcomes, out);
    suite(study, out);
    bearing_checks(study, out);
    for (k, bound) in BOUNDS.iter().enumerate() {
        procedure_checks(study, out, k, bound);
        let least: Vec<Check> =
            out.values.iter().filter(|v| v.bound == *bound && v.least.is_finite()).map(DesignValue::check).collect();
        out.checks.extend(least);
        drift(study, outcomes, out, bound);
    }
    factors_of_bounds(study, out);
}

/// Results of the suite beside the least values of dynamic procedures.
fn design_values(study: &Study, outcomes: &[JobOutcome], out: &mut Review) {
    let code = &study.code;
    let [force, length] = [study.units[0].clone(), study.units[1].clone()];
    let totals = plan_totals(study, outcomes, out);
    let fixed = out.periods.fixed_base();
    for (k, bound) in BOUNDS.iter().enumerate() {
        let of = |f: &dyn Fn(&JobOutcome) -> Option<f64>| value(study, outcomes, bound, f);
        let l = out.lateral_force[k].clone().ok();
        let share = |rule: &str| code.value(rule, "least").unwrap_or(f64::NAN);
        let total = totals[k].iter().copied().fold(f64::NAN, f64::max);
        // D'_M in place of D_M where the code has it and the period on a fixed base is known.
        let reduced = match (&l, code.reading("reduced_displacement").is_some() && fixed.is_finite()) {
            (Some(l), true) => 1.0 / (1.0 + (fixed / l.period).powi(2)).sqrt(),
            _ => 1.0,
        };
        let least = share("dynamic_displacement") * reduced * total;
        let d = of(&|o| o.bearings.iter().map(|b| b.displacement).reduce(f64::max));
        let cite = |rule: &str| Citation::of(code, rule);
        out.values.push(DesignValue::new(bound, DISPLACEMENT, &length, d, least, cite("dynamic_displacement")));
        let below = l.as_ref().map_or(f64::NAN, |l| l.shear_below);
        let v = of(&|o| Some(o.base_shear));
        let least = share("dynamic_shear_below") * below;
        out.values.push(DesignValue::new(bound, SHEAR_BELOW, &force, v, least, cite("dynamic_shear_below")));
        if study.floors.len() > 1 {
            let above = of(&|o| reduced_shear_above(study, o));
            let regular = if study.regular { "regular" } else { "irregular" };
            // Raised like a base shear below its share of V_b, and to the least shears of the structure above.
            let by_base = code.value("dynamic_shear_above", regular).map_or(f64::NAN, |s| above * s * below / v);
            let forces = out.forces.iter().find(|f| f.bound == *bound);
            let least = forces.map_or(f64::NAN, |f| f.activation.max(f.fixed_base)).max(by_base);
            out.values.push(DesignValue::new(bound, SHEAR_ABOVE, &force, above, least, cite("dynamic_shear_above")));
        }
    }
}

fn suite(study: &Study, out: &mut Review) {
    let code = &study.code;
    let pairs = study.motions.len() as f64;
    out.checks.push(Check::least_of(code, "suite_size", "pairs of ground motions", pairs).of_suite());
    if let (Some([from, to]), Some((lowest, at))) = (out.suite.range, out.suite.lowest) {
        let mut subject = format!(
            "mean of the {} spectra over the target, least from {from:.2} to {to:.2} s (at {at:.2} s)",
            out.suite.combination
        );
        if lowest < out.suite.least {
            subject += &format!("; factor on the motions {}", number(out.suite.least / lowest));
        }
        out.checks.push(Check::least_of(code, "scaling_range", subject, lowest).of_suite());
    }
}

fn bearing_checks(study: &Study, out: &mut Review) {
    let code = &study.code;
    let magnified = magnification(study);
    for (kind, b) in study.bearings.iter().enumerate() {
        let mine = || out.bearings.iter().filter(move |d| d.kind == kind);
        let most = |of: &dyn Fn(&super::BearingDesign) -> f64| mine().map(of).fold(f64::NAN, f64::max);
        let name = &b.name;
        let mut checks = vec![];
        let subject = match magnified > 1.0 {
            true => format!("{name}: design displacement with γ_x = {magnified} against capacity"),
            false => format!("{name}: design displacement against capacity"),
        };
        let cite = if magnified > 1.0 { "magnified_displacement" } else { "capacity" };
        let limit = b.displacement.unwrap_or(f64::NAN);
        checks.push(Check::at_most(subject, Citation::of(code, cite), most(&|d| d.design), limit));
        let tension = -mine().map(|d| d.loads[2]).fold(f64::NAN, f64::min);
        let subject = format!("{name}: tension of the least vertical load against capacity");
        let limit = b.tension.unwrap_or(f64::NAN);
        checks.push(Check::at_most(subject, Citation::of(code, "axial_tension"), tension.max(0.0), limit));
        let subject = format!("{name}: P/P_cr of the largest vertical load at the design displacement");
        checks.push(Check::most_of(code, "stability", subject, most(&|d| d.stability_design[1])));
        if code.value("stability_at_rest", "least").is_some() {
            let load = most(&|d| d.dead_live[0] + d.dead_live[1]);
            let subject = format!("{name}: critical load without displacement over DL + LL");
            let value = b.critical_load.map_or(f64::NAN, |c| c / load);
            checks.push(Check::least_of(code, "stability_at_rest", subject, value));
        }
        out.checks.extend(checks);
    }
}

/// Rules on the isolation system, and limits within which the procedure may stand alone.
fn procedure_checks(study: &Study, out: &mut Review, k: usize, bound: &'static str) {
    let Ok(l) = out.lateral_force[k].clone() else { return };
    let code = &study.code;
    let s = system(study, bound);
    let subject = |what: &str| format!("{bound}: {what}");
    let share = s.restoring_share(l.displacement);
    let forces = out.forces.iter().find(|f| f.bound == bound);
    let drift = forces.and_then(|f| Some(f.reduction * out.periods.largest_drift(&f.forces)?)).unwrap_or(f64::NAN);
    let fixed_base = out.periods.fixed_base();
    let checks = &mut out.checks;
    checks.push(Check::least_of(code, "restoring_force", subject("restoring force over weight"), share));
    if code.value("restoring_period", "most").is_some() {
        let period = TAU * (study.weight / (study.gravity * s.k_d)).sqrt();
        checks.push(Check::most_of(code, "restoring_period", subject("period of the tangent stiffness in s"), period));
    }
    let fifth = s.k_d + 5.0 * s.q_d / l.displacement;
    let alone = [
        Check::most_of(
            code,
            "elf_drift",
            subject("storey drift ratio of F_x times R_I, equivalent lateral force as the only procedure"),
            drift,
        ),
        Check::most_of(
            code,
            "elf_period",
            subject("T_M in s, equivalent lateral force as the only procedure"),
            l.period,
        ),
        Check::most_of(
            code,
            "elf_damping",
            subject("damping, equivalent lateral force as the only procedure"),
            l.damping,
        ),
        Check::least_of(
            code,
            "elf_period_ratio",
            subject("T_M over T_fb, equivalent lateral force as the only procedure"),
            l.period / fixed_base,
        ),
        Check::least_of(
            code,
            "elf_stiffness",
            subject("K_eff over that at a fifth of D_M, equivalent lateral force as the only procedure"),
            l.stiffness / fifth,
        ),
    ];
    checks.extend(alone.into_iter().filter(|c| c.limit.is_finite()).map(|c| c.or_else(Status::NeedsHistory)));
}

fn drift(study: &Study, outcomes: &[JobOutcome], out: &mut Review, bound: &'static str) {
    let code = &study.code;
    if study.floors.len() < 2 || code.value("drift", "most").is_none() {
        return;
    }
    let found = value(study, outcomes, bound, &|o| top(&o.drifts)) * factor(&out.values, bound, SHEAR_ABOVE);
    out.checks.push(Check::most_of(code, "drift", format!("{bound}: largest storey drift ratio"), found));
    if let Some(limit) = code.value("second_order", "most") {
        let subject = format!("{bound}: drift ratio from which on second-order effects are to be in the model");
        let check = Check::at_most(subject, Citation::of(code, "second_order"), found, limit / reduction(study));
        out.checks.push(check.or_else(Status::NeedsSecondOrder));
    }
}

/// λ of the bounds against the limits that hold without tests of the project.
fn factors_of_bounds(study: &Study, out: &mut Review) {
    let code = &study.code;
    let (Some(upper), Some(lower)) =
        (code.value("limits_of_factors", "upper"), code.value("limits_of_factors", "lower"))
    else {
        return;
    };
    if study.project_tests {
        return;
    }
    let cite = || Citation::of(code, "limits_of_factors");
    for b in &study.bearings {
        // A flat slider has no K_d, a rubber bearing without lead no Q_d.
        let named = [("Q_d", b.q_d), ("K_d", b.k_d)].into_iter().enumerate();
        for (of, (letter, _)) in named.filter(|(_, (_, x))| *x > 0.0) {
            let subject = |what: &str| format!("{}: {what} of {letter} without tests of the project", b.name);
            out.checks.push(Check::at_least(subject("λ_max"), cite(), study.factor(b, "upper", of), upper));
            out.checks.push(Check::at_most(subject("λ_min"), cite(), study.factor(b, "lower", of), lower));
        }
    }
}
