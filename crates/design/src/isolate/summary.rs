//! Results of a study over its motions, beside the equivalent lateral force procedure, with checks.

use super::BOUNDS;
use super::outcome::{BearingOutcome, JobOutcome};
use super::study::{BearingType, Study};
use super::study_file::Transition;
use crate::check::{Check, Status};
use crate::lateral_force::{LateralForce, System, torsional_period_ratio, torsional_ratio};
use crate::supports::{Support, simplified_method};
use hysteron_identify::report::{Cell, Table, html};

/// Results of a study.
#[derive(Clone, Debug, Default)]
pub struct Summary {
    /// Equivalent lateral force procedure by bound; a description where it gives nothing.
    pub lateral_force: Vec<Result<LateralForce, String>>,
    /// Bearing schedule: governing values over the bounds.
    pub schedule: Table,
    /// Values of the structure by bound.
    pub structure: Table,
    /// Checks.
    pub checks: Vec<Check>,
    /// Matters that were not checked.
    pub not_checked: Vec<String>,
}

/// Share of the energy of isolators that Rayleigh damping may take: a bearing has no such damping.
const MAX_DAMPING_SHARE: f64 = 0.05;

/// Pairs from which on the mean counts in place of the largest value.
fn mean_from(study: &Study) -> usize {
    study.code.value("suite_size", "least").map_or(usize::MAX, |n| n as usize)
}

/// Value of a bound: for each eccentricity the mean over the motions if there are enough of them, else the largest; of
/// these the largest. `None` without a complete analysis.
fn governing(
    study: &Study,
    outcomes: &[JobOutcome],
    bound: &str,
    of: &dyn Fn(&JobOutcome) -> Option<f64>,
) -> Option<f64> {
    let by_eccentricity = |e: &[f64; 2]| {
        let all: Vec<f64> = outcomes
            .iter()
            .filter(|o| o.bound == bound && o.eccentricity == *e && o.failure.is_empty())
            .filter_map(of)
            .collect();
        let largest = all.iter().copied().reduce(f64::max)?;
        let mean = all.iter().sum::<f64>() / all.len() as f64;
        Some(if all.len() >= mean_from(study) { mean } else { largest })
    };
    study.eccentricities.iter().filter_map(by_eccentricity).reduce(f64::max)
}

/// Share of the strength of all bearings from which on those with abrupt loops make the loop of the system abrupt.
const ABRUPT_SHARE: f64 = 0.1;

/// The system of all bearings at a bound.
fn system(study: &Study, bound: &str) -> System {
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

/// The equivalent lateral force procedure of each bound; the simplified method for bridges where substructures are given.
pub(super) fn procedures(study: &Study) -> Vec<Result<LateralForce, String>> {
    let meter = study.meter();
    let spectrum = |t: f64| meter * study.target.at(t);
    let of = |bound: &&str| {
        if study.bearings.iter().any(|b| b.substructure.is_some()) {
            let supports: Vec<Support> = study.bearings.iter().map(|b| support(study, b, bound)).collect();
            let found = simplified_method(|_| supports.clone(), study.weight, study.gravity, spectrum, &study.code);
            return found.map(LateralForce::from);
        }
        system(study, bound).procedure(spectrum, &study.code)
    };
    BOUNDS.iter().map(of).collect()
}

/// All bearings of a type on their substructures.
fn support(study: &Study, b: &BearingType, bound: &str) -> Support {
    let n = b.tags.len() as f64;
    Support {
        q_d: n * b.q_d * study.factor(b, bound, 0),
        k_d: n * b.k_d * study.factor(b, bound, 1),
        yield_displacement: b.yield_displacement,
        substructure: b.substructure.map_or(f64::INFINITY, |k| n * k),
    }
}

/// Results of analyses, which may be some of all.
pub fn summary(study: &Study, outcomes: &[JobOutcome]) -> Summary {
    let mut out = Summary { lateral_force: procedures(study), ..Summary::default() };
    out.schedule = schedule(study, outcomes, &out.lateral_force, &mut out.checks);
    out.structure = structure(study, outcomes, &out.lateral_force);
    overall(study, outcomes, &mut out);
    let damped = outcomes.iter().map(|o| o.damping_share).fold(0.0, f64::max);
    let subject = "Rayleigh damping: share of the energy into the isolators";
    out.checks.push(Check::at_most(subject, "", damped, MAX_DAMPING_SHARE));
    let failed = outcomes.iter().filter(|o| !o.failure.is_empty()).count();
    if failed > 0 {
        // Some of the motions alone prove nothing: what they meet is open, what they do not meet is not met.
        out.checks.iter_mut().filter(|c| c.status == Status::Met).for_each(|c| c.status = Status::NotChecked);
        let subject = format!("{failed} of {} analyses did not converge", outcomes.len());
        out.checks.push(Check::at_most(subject, "", failed as f64, 0.0));
    }
    out.not_checked = [
        "strength of members, diaphragms, foundations and connections of the bearings",
        "wind and service loads; vertical ground motion, unless the script applies it",
        "fire, access for inspection and replacement, utilities across the isolation interface",
        "least shear above of wind and of a fixed base at T_M; eccentricity of the masses in the plan formula of D_TM",
    ]
    .map(str::to_owned)
    .into();
    out
}

/// Total displacements D_TM of the bearings by the plan formula of the code, by bound: D_M times
/// 1 + y/P_T² · 12 e/(b² + d²) with the accidental eccentricity e, at least the share of the code. NaN without a procedure.
fn plan_totals(study: &Study, outcomes: &[JobOutcome], procedure: &[Result<LateralForce, String>]) -> Vec<Vec<f64>> {
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
    let of = |l: &Result<LateralForce, String>| {
        let d = l.as_ref().map_or(f64::NAN, |l| l.displacement);
        ratios.iter().map(|r| r * d).collect()
    };
    procedure.iter().map(of).collect()
}

/// R_I of the structure above: a share of R between limits of the code; 1 where the code has none.
fn reduction(study: &Study) -> f64 {
    let value = |name: &str| study.code.value("force_above", name);
    match (value("response_share"), value("response_least"), value("response_most")) {
        (Some(share), Some(least), Some(most)) => (share * study.response_modification).clamp(least, most),
        _ => 1.0,
    }
}

/// Schedule of the bearings, and the checks of each type.
fn schedule(
    study: &Study,
    outcomes: &[JobOutcome],
    procedure: &[Result<LateralForce, String>],
    checks: &mut Vec<Check>,
) -> Table {
    let [force, length] = [study.units[0].as_str(), study.units[1].as_str()];
    let totals = plan_totals(study, outcomes, procedure);
    let energy = format!("{force} {length}");
    let mut table = Table::new([
        ("type", ""),
        ("bearing", ""),
        ("D", length),
        ("bound of D", ""),
        ("D_TM plan", length),
        ("residual", length),
        ("P gravity", force),
        ("P max", force),
        ("P min", force),
        ("uplift", length),
        ("V max", force),
        ("energy", &energy),
        ("P/P_cr", ""),
    ]);
    let mut place = 0;
    for kind in &study.bearings {
        let mut worst = [0.0f64, f64::INFINITY, 0.0];
        for tag in &kind.tags {
            let over = |of: &dyn Fn(&BearingOutcome) -> f64| -> (f64, &'static str) {
                let by_bound = BOUNDS.iter().filter_map(|b| {
                    let value = governing(study, outcomes, b, &|o| Some(of(o.bearings.get(place)?)));
                    value.map(|v| (v, *b))
                });
                by_bound.reduce(|m, x| if x.0 > m.0 { x } else { m }).unwrap_or((f64::NAN, ""))
            };
            let (d, bound) = over(&|b| b.displacement);
            let least = -over(&|b| -b.least).0;
            let stability = kind.critical_load.map_or(f64::NAN, |_| over(&|b| b.stability.unwrap_or(f64::NAN)).0);
            let number = |x: f64| if x.is_finite() { Cell::Number(x) } else { Cell::Word("-") };
            let mut row: Vec<Cell> = vec![kind.name.clone().into(), (*tag as f64).into(), number(d), Cell::Word(bound)];
            row.push(number(totals.iter().map(|t| t[place]).fold(f64::NAN, f64::max)));
            row.extend(
                [over(&|b| b.residual).0, over(&|b| b.gravity).0, over(&|b| b.compression).0, least].map(number),
            );
            row.extend([over(&|b| b.uplift).0, over(&|b| b.shear).0, over(&|b| b.energy).0, stability].map(number));
            table.rows.push(row);
            worst = [worst[0].max(d), worst[1].min(least), worst[2].max(stability)];
            place += 1;
        }
        let name = &kind.name;
        let clause = study.code.clause("total_displacement");
        let limit = kind.displacement.unwrap_or(f64::NAN);
        checks.push(Check::at_most(format!("{name}: largest displacement against capacity"), clause, worst[0], limit));
        let clause = study.code.clause("axial_tension");
        let tension = kind.tension.unwrap_or(f64::NAN);
        checks.push(Check::at_most(format!("{name}: tension against capacity"), clause, (-worst[1]).max(0.0), tension));
        let load = if kind.critical_load.is_some() { worst[2] } else { f64::NAN };
        checks.push(Check::at_most(format!("{name}: P/P_cr with the overlapping area"), "", load, 1.0));
    }
    table
}

/// Values of the structure by bound: from the analyses, and from the equivalent lateral force procedure.
fn structure(study: &Study, outcomes: &[JobOutcome], procedure: &[Result<LateralForce, String>]) -> Table {
    let [force, length] = [study.units[0].as_str(), study.units[1].as_str()];
    let mut table = Table::new([
        ("bound", ""),
        ("D", length),
        ("V base", force),
        ("V above", force),
        ("drift", ""),
        ("floor acceleration", "g"),
        ("ELF D_M", length),
        ("ELF T_M", "s"),
        ("ELF beta_M", ""),
        ("ELF V_b", force),
        ("ELF V_st", force),
    ]);
    for (bound, lateral) in BOUNDS.iter().zip(procedure) {
        let value = |of: &dyn Fn(&JobOutcome) -> Option<f64>| governing(study, outcomes, bound, of).unwrap_or(f64::NAN);
        let top = |v: &[f64]| v.iter().copied().reduce(f64::max);
        let found = lateral.clone().ok();
        let elf = |of: fn(&LateralForce) -> f64| found.as_ref().map_or(f64::NAN, of);
        let numbers = [
            value(&|o| o.bearings.iter().map(|b| b.displacement).reduce(f64::max)),
            value(&|o| Some(o.base_shear)),
            value(&|o| Some(o.shear_above)),
            value(&|o| top(&o.drifts)),
            value(&|o| top(&o.accelerations)),
            elf(|l| l.displacement),
            elf(|l| l.period),
            elf(|l| l.damping),
            elf(|l| l.shear_below),
            elf(|l| l.shear_above),
        ];
        let mut row = vec![Cell::Word(bound)];
        row.extend(numbers.map(|x| if x.is_finite() { Cell::Number(x) } else { Cell::Word("-") }));
        table.rows.push(row);
    }
    table
}

/// Checks of the structure as a whole.
fn overall(study: &Study, outcomes: &[JobOutcome], out: &mut Summary) {
    let code = &study.code;
    let checks = &mut out.checks;
    checks.push(Check::least_of(code, "suite_size", "pairs of ground motions", study.motions.len() as f64));
    let totals = plan_totals(study, outcomes, &out.lateral_force);
    for (k, (bound, lateral)) in BOUNDS.iter().zip(&out.lateral_force).enumerate() {
        let value = |of: &dyn Fn(&JobOutcome) -> Option<f64>| governing(study, outcomes, bound, of).unwrap_or(f64::NAN);
        if let Ok(l) = lateral {
            let s = system(study, bound);
            let share = s.restoring_share(l.displacement);
            checks.push(Check::least_of(
                code,
                "restoring_force",
                format!("{bound}: restoring force over weight"),
                share,
            ));
            let d = value(&|o| o.bearings.iter().map(|b| b.displacement).reduce(f64::max));
            let subject = format!("{bound}: displacement over the largest D_TM of the plan formula");
            let total = totals[k].iter().copied().fold(f64::NAN, f64::max);
            checks.push(Check::least_of(code, "dynamic_displacement", subject, d / total));
            let subject = format!("{bound}: base shear over V_b");
            checks.push(Check::least_of(
                code,
                "dynamic_shear_below",
                subject,
                value(&|o| Some(o.base_shear)) / l.shear_below,
            ));
            let activation = code.value("force_minimum", "activation").map(|f| f * s.q_d);
            if let Some(least) = activation.filter(|_| l.shear_above.is_finite()) {
                let subject = format!("{bound}: V_st beside the least unreduced force above");
                checks.push(Check::at_least(subject, code.clause("force_minimum"), l.shear_above, least));
                let r = reduction(study);
                let design = (l.shear_above / r).max(least);
                let subject = format!("{bound}: shear above over R_I = {r} beside V_s = {}", html::number(design));
                let above = value(&|o| Some(o.shear_above)) / r;
                checks.push(Check::least_of(code, "dynamic_shear_above", subject, above / design));
            }
        }
        let drift = value(&|o| o.drifts.iter().copied().reduce(f64::max));
        checks.push(Check::most_of(code, "drift", format!("{bound}: largest storey drift ratio"), drift));
    }
}
