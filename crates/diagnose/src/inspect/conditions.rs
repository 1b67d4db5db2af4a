//! The conditions that runs were made under, beside their motions.

use hysteron_identify::study::{Role, Run, Study};
use std::collections::BTreeMap;

/// Differences below this many degrees are not an effect of the surroundings.
pub(crate) const DEGREES: f64 = 2.0;
/// Axial loads differ from this part of the largest on.
const LOADS: f64 = 0.05;
/// Amplitudes differ from this ratio on: a choice, at which softening with amplitude is no matter of the noise.
const AMPLITUDES: f64 = 3.0;

/// Samples of a column of a recording, by the beginning of its name.
pub(crate) fn column<'a>(run: &'a Run, name: &str) -> Option<&'a [f64]> {
    let column = run.recording.columns.iter().find(|c| c.name.to_lowercase().starts_with(name))?;
    Some(&column.values)
}

/// Temperature of each run at its beginning, from a column of its recording; the surroundings, not what work adds.
pub(crate) fn temperatures(study: &Study) -> Option<Vec<f64>> {
    let of = |r: &Run| {
        let first: Vec<f64> = column(r, "temp")?.iter().copied().filter(|x| x.is_finite()).take(10).collect();
        (!first.is_empty()).then(|| first.iter().sum::<f64>() / first.len() as f64)
    };
    study.runs.iter().map(of).collect()
}

/// Axial load of each run, from the variable `axial` that all of them set.
pub(crate) fn axial_loads(study: &Study) -> Option<Vec<f64>> {
    study.runs.iter().map(|r| r.number("axial").map(f64::abs)).collect()
}

/// Whether the times of all recordings are the number of the sample, as they often are in quasi-static tests: they have no clock.
pub(crate) fn untimed(study: &Study) -> bool {
    let by_one = |t: &[f64]| (t[1] - t[0] - 1.0).abs() < 1e-9;
    let counts = |r: &Run| r.recording.times.len() > 1 && r.recording.times.windows(2).all(by_one);
    study.runs.iter().all(counts)
}

/// Whether runs were made at different temperatures or axial loads.
pub(crate) fn differ(study: &Study) -> bool {
    spread(temperatures(study), |_| DEGREES) || axial_loads_differ(study)
}

/// Whether runs were made at different axial loads.
pub(crate) fn axial_loads_differ(study: &Study) -> bool {
    spread(axial_loads(study), |most| LOADS * most)
}

/// Whether a channel of the fitted runs is several times as strong in one as in another.
pub(crate) fn amplitudes_differ(study: &Study) -> bool {
    let mut range: BTreeMap<&str, [f64; 2]> = BTreeMap::new();
    for o in study.runs_of(Role::Fit).flat_map(|(_, r)| &r.observe) {
        let [low, high] = range.entry(&o.channel).or_insert([f64::INFINITY, 0.0]);
        let size = o.variance.sqrt();
        (*low, *high) = (low.min(size), high.max(size));
    }
    range.values().any(|[low, high]| *high > AMPLITUDES * low)
}

/// Whether values lie further apart than a limit, which is told by the largest.
fn spread(values: Option<Vec<f64>>, limit: impl Fn(f64) -> f64) -> bool {
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
