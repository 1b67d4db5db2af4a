//! Incremental dynamic analysis and stripes of an isolation study: demands of limit states over the intensity.
//!
//! An analysis that passes a limit of `[collapse]` has collapsed, and has reached all limit states. One that does not
//! converge although it has passed none, with shorter steps and other algorithms tried, is unresolved: limit states that it
//! has reached are counted, the others are left out and reported.

mod hunt;
pub mod report;
mod summary;

pub use summary::{StateFit, Summary, Trace, summary};

use crate::isolate::{BearingOutcome, Job, JobOutcome, Study};
use crate::performance::LimitState;

/// End of an analysis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ending {
    /// Complete, without collapse.
    Complete,
    /// It passed a limit of collapse.
    Collapsed,
    /// It did not converge, and no limit of collapse was passed before.
    Unresolved,
}

impl Ending {
    /// A word for tables.
    pub fn word(self) -> &'static str {
        match self {
            Self::Complete => "complete",
            Self::Collapsed => "collapse",
            Self::Unresolved => "no convergence",
        }
    }

    /// End of an analysis of a study.
    pub fn of(study: &Study, outcome: &JobOutcome) -> Self {
        let passes = |limit: Option<f64>, value: f64| limit.is_some_and(|l| value > l || value.is_infinite());
        let collapse = &study.performance.collapse;
        let displacement = outcome.bearings.iter().map(|b| b.displacement).fold(0.0, f64::max);
        let drift = outcome.drifts.iter().copied().fold(0.0, f64::max);
        if passes(collapse.drift, drift) || passes(collapse.displacement, displacement) {
            Self::Collapsed
        } else if outcome.failure.is_empty() {
            Self::Complete
        } else {
            Self::Unresolved
        }
    }
}

/// Demand of a limit state in an analysis; NaN for `collapse` and where nothing was recorded.
pub fn demand(study: &Study, state: &LimitState, outcome: &JobOutcome) -> f64 {
    let largest = |values: &mut dyn Iterator<Item = f64>| values.fold(f64::NAN, f64::max);
    let names = study.bearings.iter().flat_map(|b| b.tags.iter().map(|_| b.name.as_str()));
    let wanted = |name: &str| state.bearings.is_empty() || state.bearings.iter().any(|b| b == name);
    let of = |value: &dyn Fn(&BearingOutcome) -> f64| {
        let all = names.clone().zip(&outcome.bearings).filter(|(name, _)| wanted(name));
        largest(&mut all.map(|(_, b)| value(b)))
    };
    match state.quantity.as_str() {
        "displacement" => of(&|b| b.displacement),
        "residual" => of(&|b| b.residual),
        "uplift" => of(&|b| b.uplift),
        "tension" => of(&|b| (-b.least).max(0.0)),
        "stability" => of(&|b| b.stability.unwrap_or(f64::NAN)),
        "drift" => largest(&mut outcome.drifts.iter().copied()),
        "acceleration" => largest(&mut outcome.accelerations.iter().copied()),
        "base_displacement" => largest(&mut outcome.base_displacement.iter().copied()),
        "contact" => {
            let mine = outcome.contact.iter().filter(|(tag, _)| state.elements.contains(tag));
            largest(&mut mine.map(|(_, f)| *f))
        }
        _ => f64::NAN,
    }
}

/// Analysis at one level of intensity.
#[derive(Clone, Debug, PartialEq)]
pub struct Point {
    /// Intensity.
    pub level: f64,
    /// End of the analysis.
    pub ending: Ending,
    /// Description of a failure.
    pub failure: String,
    /// Demands by limit state.
    pub demands: Vec<f64>,
    /// True where a limit state was reached, none where that is not known.
    pub reached: Vec<Option<bool>>,
}

impl Point {
    /// From an analysis.
    pub fn new(study: &Study, level: f64, outcome: &JobOutcome) -> Self {
        let ending = Ending::of(study, outcome);
        let states = &study.performance.limit_states;
        let demands: Vec<f64> = states.iter().map(|s| demand(study, s, outcome)).collect();
        let reached = states.iter().zip(&demands).map(|(s, d)| match ending {
            Ending::Collapsed => Some(true),
            Ending::Complete if s.quantity == "collapse" => Some(false),
            Ending::Complete if !d.is_nan() => Some(*d > s.limit),
            _ if s.quantity != "collapse" && *d > s.limit => Some(true),
            _ => None,
        });
        let reached = reached.collect();
        Self { level, ending, failure: outcome.failure.clone(), demands, reached }
    }

    /// Returns true if no higher level is worth an analysis.
    fn is_end(&self) -> bool {
        self.ending != Ending::Complete || self.reached.iter().all(|r| *r == Some(true))
    }
}

/// An analysis of a motion at a level, given the intensity of the motion as the study scales it.
fn job(bound: &'static str, motion: usize, level: f64, intensity: f64) -> Job {
    Job { bound, motion, eccentricity: 0, level: level / intensity, draw: None }
}

/// Intensities of the motions as the study scales them.
///
/// # Errors
/// A motion has no intensity.
pub fn intensities(study: &Study) -> Result<Vec<f64>, String> {
    let of = |p: &crate::motion::Pair| {
        let x = study.performance.intensity.of(p);
        if x > 0.0 && x.is_finite() { Ok(x) } else { Err(format!("{}: its intensity is {x}", p.components[0].name)) }
    };
    study.motions.iter().map(of).collect()
}

/// Bounds that the study wants, in the order of [`crate::isolate::BOUNDS`].
pub fn bounds(study: &Study) -> Vec<&'static str> {
    let wanted = |b: &&&str| study.performance.bounds.iter().any(|w| w == **b);
    crate::isolate::BOUNDS.iter().filter(wanted).copied().collect()
}

/// Analyses of one motion by hunting and filling. `run` makes an analysis or finds it among earlier ones.
///
/// # Errors
/// Those of `run`, and a rejected script.
pub fn hunt(
    study: &Study,
    bound: &'static str,
    motion: usize,
    intensity: f64,
    run: &dyn Fn(&Job) -> Result<JobOutcome, String>,
) -> Result<Vec<Point>, String> {
    let plan = study.performance.hunt.as_ref().ok_or("the study has no [ida]")?;
    let mut points: Vec<Point> = vec![];
    while let Some(level) = hunt::next(plan, &points) {
        let outcome = run(&job(bound, motion, level, intensity))?;
        points.push(Point::new(study, level, &outcome));
    }
    points.sort_by(|a, b| a.level.total_cmp(&b.level));
    Ok(points)
}

/// One analysis of a stripe.
///
/// # Errors
/// Those of `run`.
pub fn stripe(
    study: &Study,
    bound: &'static str,
    motion: usize,
    (level, intensity): (f64, f64),
    run: &dyn Fn(&Job) -> Result<JobOutcome, String>,
) -> Result<Point, String> {
    Ok(Point::new(study, level, &run(&job(bound, motion, level, intensity))?))
}
