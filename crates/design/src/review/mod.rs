//! Design review of an isolation study: results of the suite beside the rules of a code, and what governs.

mod annex;
mod bearings;
mod combinations;
mod compare;
mod distribution;
mod drawing;
mod draws;
mod governing;
mod members;
mod periods;
mod report;
mod rules;
mod suite_match;
mod summary;
mod tables;

pub use annex::{files, json};
pub use bearings::BearingDesign;
pub use compare::{Comparison, compare};
pub use distribution::{StoreyForces, fixed_base_shear};
pub use draws::draw_tables;
pub use governing::{Response, governing};
pub use periods::{Periods, periods};
pub use report::html;
pub use rules::DesignValue;
pub use suite_match::{SuiteMatch, suite_match};

use crate::check::{Check, Citation, Status};
use crate::isolate::{JobOutcome, Study, procedures};
use crate::lateral_force::LateralForce;
use hysteron_identify::report::Table;
use std::collections::BTreeMap;

/// Results of a study with its checks.
#[derive(Clone, Debug, Default)]
pub struct Review {
    /// Equivalent lateral force procedure by bound; a description where it gives nothing.
    pub lateral_force: Vec<Result<LateralForce, String>>,
    /// Periods on a fixed base and of the isolated structure.
    pub periods: Periods,
    /// The suite beside its target.
    pub suite: SuiteMatch,
    /// Design values by bound.
    pub values: Vec<DesignValue>,
    /// Bearings, in the order of the study.
    pub bearings: Vec<BearingDesign>,
    /// Storey forces by bound.
    pub forces: Vec<StoreyForces>,
    /// Checks.
    pub checks: Vec<Check>,
    /// Matters that were not checked.
    pub not_checked: Vec<String>,
}

/// Share of the energy of isolators that Rayleigh damping may take: a bearing has no such damping.
const MAX_DAMPING_SHARE: f64 = 0.05;

/// The suite of a study beside its target.
pub fn suite(study: &Study) -> SuiteMatch {
    suite_match(study, &procedures(study))
}

/// The review of analyses, which may be some of all.
pub fn review(study: &Study, outcomes: &[JobOutcome], periods: Periods) -> Review {
    let mut out = Review { lateral_force: procedures(study), periods, ..Review::default() };
    out.suite = suite_match(study, &out.lateral_force);
    rules::apply(study, outcomes, &mut out);
    let damped = outcomes.iter().map(|o| o.damping_share).fold(0.0, f64::max);
    let subject = "Rayleigh damping: share of the energy into the isolators";
    out.checks.push(Check::at_most(subject, Citation::default(), damped, MAX_DAMPING_SHARE));
    let failed = outcomes.iter().filter(|o| !o.failure.is_empty()).count();
    if failed > 0 {
        // Some of the motions alone prove nothing: what they meet is open, what they do not meet is not met.
        out.checks.iter_mut().filter(|c| c.status == Status::Met).for_each(|c| c.status = Status::NotChecked);
        let subject = format!("{failed} of {} analyses did not converge", outcomes.len());
        out.checks.push(Check::at_most(subject, Citation::default(), failed as f64, 0.0));
    }
    out.not_checked = not_checked(study, &out);
    out.not_checked.extend(warnings(outcomes));
    out
}

/// What the review leaves open.
fn not_checked(study: &Study, review: &Review) -> Vec<String> {
    let mut out: Vec<String> = [
        "strength of members, diaphragms, foundations and connections of the bearings: diaphragms.csv, members.csv and below.csv have forces",
        "wind and service loads, and the least shear above of wind",
        "fire, access for inspection and replacement, utilities across the isolation interface",
        "eccentricity of the masses in the plan formula of D_TM: the accidental one alone is in it",
    ]
    .map(str::to_owned)
    .into();
    let has_vertical = study.motions.iter().any(|p| p.vertical.is_some());
    if !has_vertical {
        let part = study.code.value("load_combinations", "vertical").filter(|v| *v > 0.0);
        out.push(match (part, study.sms) {
            (Some(v), Some(sms)) => {
                format!("vertical ground motion: {v} S_MS = {:.3} of the dead load stands for it", v * sms)
            }
            _ => "vertical ground motion, unless the script applies it".to_owned(),
        });
    }
    if study.floors.is_empty() {
        out.push("shear above, drifts and floor accelerations: the study has no [[floor]]".into());
    }
    if study.live.over_dead == 0.0 {
        out.push("live load in the load combinations: the study has no live.over_dead".into());
    }
    out.extend(review.periods.remarks());
    out.extend(study.agreement.remarks.iter().cloned());
    out
}

/// Warnings of the script, each place and check once, with the number of its analyses.
fn warnings(outcomes: &[JobOutcome]) -> impl Iterator<Item = String> {
    let mut all: BTreeMap<&str, (&str, usize)> = BTreeMap::new();
    for (key, text) in outcomes.iter().flat_map(|o| &o.warnings) {
        all.entry(key).or_insert((text, 0)).1 += 1;
    }
    let count = outcomes.len();
    all.into_values().map(move |(text, n)| format!("{text}, a warning in {n} of {count} analyses"))
}

impl Review {
    /// Numbers of checks by their results, as a sentence without its end.
    pub fn verdict(&self) -> String {
        let count = |s: Status| self.checks.iter().filter(|c| c.status == s).count();
        let verdict = match (count(Status::NotMet), count(Status::Met)) {
            (0, met) => format!("All {met} checks with a limit are met"),
            (1, met) => format!("1 check is not met, {met} are met"),
            (missed, met) => format!("{missed} checks are not met, {met} are met"),
        };
        let others = [Status::Scaled, Status::NeedsHistory, Status::NeedsSecondOrder, Status::NotChecked];
        let told = others.into_iter().filter(|s| count(*s) > 0).map(|s| format!(", {} {}", s.word(), count(s)));
        told.fold(verdict, |text, other| text + &other)
    }

    /// Headings and texts of the summary: the design displacement, checks that are not met, what governs.
    pub fn summary(&self, study: &Study, outcomes: &[JobOutcome]) -> Vec<(&'static str, String)> {
        summary::parts(study, outcomes, self)
    }

    /// Schedule of the bearings.
    pub fn schedule(&self, study: &Study) -> Table {
        tables::schedule(study, self)
    }

    /// Design values by bound.
    pub fn design_values(&self) -> Table {
        tables::design_values(self)
    }

    /// Mean and largest responses of the structure by bound.
    pub fn structure(&self, study: &Study, outcomes: &[JobOutcome]) -> Table {
        tables::structure(study, outcomes)
    }

    /// The equivalent lateral force procedure by bound.
    pub fn procedure(&self, study: &Study) -> Table {
        tables::procedure(study, self)
    }
}
