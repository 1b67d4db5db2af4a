//! The period in which most of what a model leaves swings.

use hysteron_identify::study::{Role, ScoredRun, Study};
use std::f64::consts::TAU;

/// Periods that are tried, evenly on a logarithmic scale.
const PERIODS: usize = 60;
/// Samples a period at least, and periods a run at least, of those that are tried.
const MIN_SAMPLES_PER_PERIOD: f64 = 10.0;
const MIN_PERIODS_PER_RUN: f64 = 4.0;

/// Period with the largest power of the residuals of all fitted runs, s; none without residuals or a span of time.
///
/// Each channel counts by its share of its variance. Samples are those of the recording; times need not be even.
pub(crate) fn dominant_period(study: &Study, fits: &[ScoredRun]) -> Option<f64> {
    let runs = || study.runs_of(Role::Fit).map(|(_, run)| run).zip(fits);
    let spans = runs().filter_map(|(run, _)| {
        let t = &run.recording.times;
        let span = t.last()? - t.first()?;
        Some([MIN_SAMPLES_PER_PERIOD * span / (t.len() - 1).max(1) as f64, span / MIN_PERIODS_PER_RUN])
    });
    let [shortest, longest] = spans.reduce(|[a, b], [c, d]| [a.max(c), b.min(d)]).filter(|[a, b]| *a > 0.0 && b > a)?;
    let power = |period: f64| -> f64 {
        let of_run = |(run, fit): (&hysteron_identify::study::Run, &ScoredRun)| -> f64 {
            let channels = run.observe.iter().zip(&fit.channels);
            channels.map(|(o, y)| o.weight * power_at(&run.recording.times, &o.values, y, period) / o.variance).sum()
        };
        runs().map(of_run).sum()
    };
    let step = (longest / shortest).ln() / (PERIODS - 1) as f64;
    let tried = (0..PERIODS).map(|i| shortest * (step * i as f64).exp()).map(|period| (period, power(period)));
    tried.filter(|(_, p)| p.is_finite() && *p > 0.0).max_by(|a, b| a.1.total_cmp(&b.1)).map(|(period, _)| period)
}

/// Squared amplitude of a residual at a period.
fn power_at(times: &[f64], recorded: &[f64], simulated: &[f64], period: f64) -> f64 {
    let (mut cosine, mut sine, mut count) = (0.0, 0.0, 0.0);
    for ((t, v), y) in times.iter().zip(recorded).zip(simulated) {
        if (v - y).is_finite() {
            let (s, c) = (TAU * t / period).sin_cos();
            (cosine, sine, count) = (cosine + (v - y) * c, sine + (v - y) * s, count + 1.0);
        }
    }
    (cosine * cosine + sine * sine) / f64::max(count * count, 1.0)
}

#[cfg(test)]
mod tests {
    use super::dominant_period;
    use crate::test_support::pad_study;
    use hysteron_identify::study::{Role, ScoredRun};
    use std::f64::consts::TAU;

    #[test]
    fn the_period_of_what_is_left_is_found() {
        let study = pad_study();
        let span = study.runs_of(Role::Fit).map(|(_, r)| r.recording.times[r.recording.times.len() - 1]);
        let period = span.fold(f64::INFINITY, f64::min) / 12.0;
        let fits: Vec<ScoredRun> = study
            .runs_of(Role::Fit)
            .map(|(_, r)| {
                let left = |(t, v): (&f64, &f64)| v - (TAU * t / period).sin();
                let channels = r.observe.iter().map(|o| r.recording.times.iter().zip(&o.values).map(left).collect());
                ScoredRun { channels: channels.collect(), scores: vec![] }
            })
            .collect();
        let found = dominant_period(&study, &fits).expect("a period");
        assert!((found / period).ln().abs() < 0.1, "{found} for {period}");
        assert_eq!(dominant_period(&study, &[]), None);
    }
}
