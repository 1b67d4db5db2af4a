//! Conditions of the runs besides their motions: temperature, axial load, amplitude and clock.

use crate::prior::{
    AMBIENT_SAMPLES, COUNTED_INTERVAL_TOLERANCE, MIN_AMPLITUDE_RATIO, MIN_AXIAL_LOAD_DIFFERENCE,
    MIN_TEMPERATURE_DIFFERENCE,
};
use hysteron_identify::study::{Role, Run, Study};
use std::collections::BTreeMap;

/// Samples of the first column of a recording whose lower-case name begins with `prefix`.
pub(crate) fn recorded_column<'a>(run: &'a Run, prefix: &str) -> Option<&'a [f64]> {
    let column = run.recording.columns.iter().find(|c| c.name.to_lowercase().starts_with(prefix))?;
    Some(&column.values)
}

/// Ambient temperature of each run in degrees, from the beginning of a recorded column; none unless all runs have one.
pub(crate) fn ambient_temperatures(study: &Study) -> Option<Vec<f64>> {
    let of = |r: &Run| {
        let finite = recorded_column(r, "temp")?.iter().copied().filter(|x| x.is_finite());
        let first: Vec<f64> = finite.take(AMBIENT_SAMPLES).collect();
        (!first.is_empty()).then(|| first.iter().sum::<f64>() / first.len() as f64)
    };
    study.runs.iter().map(of).collect()
}

/// Absolute axial load of each run, from the variable `axial`; none unless all runs set it.
pub(crate) fn axial_loads(study: &Study) -> Option<Vec<f64>> {
    study.runs.iter().map(|r| r.number("axial").map(f64::abs)).collect()
}

/// Returns true if the times of all recordings count samples, as in many quasi-static tests.
pub(crate) fn lacks_clock(study: &Study) -> bool {
    let by_one = |t: &[f64]| (t[1] - t[0] - 1.0).abs() < COUNTED_INTERVAL_TOLERANCE;
    let counts = |r: &Run| r.recording.times.len() > 1 && r.recording.times.windows(2).all(by_one);
    study.runs.iter().all(counts)
}

/// Returns true if runs differ in temperature or in axial load.
pub(crate) fn conditions_differ(study: &Study) -> bool {
    spread_exceeds(ambient_temperatures(study), |_| MIN_TEMPERATURE_DIFFERENCE) || axial_loads_differ(study)
}

/// Returns true if runs differ in axial load.
pub(crate) fn axial_loads_differ(study: &Study) -> bool {
    spread_exceeds(axial_loads(study), |most| MIN_AXIAL_LOAD_DIFFERENCE * most)
}

/// Returns true if a channel is several times as strong in one fitted run as in another.
pub(crate) fn amplitudes_differ(study: &Study) -> bool {
    let mut range: BTreeMap<&str, [f64; 2]> = BTreeMap::new();
    for o in study.runs_of(Role::Fit).flat_map(|(_, r)| &r.observe) {
        let [low, high] = range.entry(&o.channel).or_insert([f64::INFINITY, 0.0]);
        let size = o.variance.sqrt();
        (*low, *high) = (low.min(size), high.max(size));
    }
    range.values().any(|[low, high]| *high > MIN_AMPLITUDE_RATIO * low)
}

/// Returns true if the range of values exceeds a limit, which may depend on the largest value.
fn spread_exceeds(values: Option<Vec<f64>>, limit: impl Fn(f64) -> f64) -> bool {
    let values = values.unwrap_or_default();
    let [low, high] = values.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], x| [a.min(*x), b.max(*x)]);
    high - low > limit(high)
}

#[cfg(test)]
mod tests {
    use super::amplitudes_differ;
    use hysteron_identify::study::{Role, Study};
    use hysteron_tcl::diagnostic::SourceMap;
    use std::path::Path;

    #[test]
    fn amplitudes_of_fitted_runs_are_compared() {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tcl-like-inputs/pad_study/study.toml");
        let mut study = Study::load(&file, &mut SourceMap::default()).expect("a study");
        study.runs.retain(|r| r.role == Role::Fit);
        study.runs.truncate(1);
        assert!(!amplitudes_differ(&study));
        let mut second = study.runs[0].clone();
        second.observe.iter_mut().for_each(|o| o.variance *= 4.0);
        study.runs.push(second);
        assert!(!amplitudes_differ(&study));
        study.runs[1].observe.iter_mut().for_each(|o| o.variance *= 4.0);
        assert!(amplitudes_differ(&study));
        study.runs[1].role = Role::Holdout;
        assert!(!amplitudes_differ(&study));
    }
}
