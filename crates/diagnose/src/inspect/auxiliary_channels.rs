//! Recorded temperatures and axial forces that no channel of the study observes.

use super::conditions::recorded_column;
use crate::prior::{
    AUXILIARY_CHANNEL_LOG_ODDS, AXIAL_FORCE_SAMPLES, MAX_CONSTANT_AXIAL_FORCE, MIN_TEMPERATURE_RISE,
    MIN_VARYING_AXIAL_FORCE, TEMPERATURE_POINTS,
};
use crate::series::averaged;
use hysteron_identify::study::{Role, Run, Study};

/// Log odds that auxiliary channels of the fitted runs give to a cause, nats.
pub(crate) fn auxiliary_log_odds(study: &Study, cause: &str) -> f64 {
    let fitted = || study.runs_of(Role::Fit).map(|(_, r)| r);
    match cause {
        "self_heating" if fitted().filter_map(temperature_rise).any(|x| x >= MIN_TEMPERATURE_RISE) => {
            AUXILIARY_CHANNEL_LOG_ODDS
        }
        "varying_axial_load" => {
            let variations: Vec<Option<f64>> = fitted().map(axial_variation).collect();
            if variations.iter().flatten().any(|x| *x >= MIN_VARYING_AXIAL_FORCE) {
                AUXILIARY_CHANNEL_LOG_ODDS
            } else if !variations.is_empty()
                && variations.iter().all(|x| x.is_some_and(|x| x <= MAX_CONSTANT_AXIAL_FORCE))
            {
                -AUXILIARY_CHANNEL_LOG_ODDS
            } else {
                0.0
            }
        }
        _ => 0.0,
    }
}

/// Rise of a recorded temperature above its first average, degrees.
fn temperature_rise(run: &Run) -> Option<f64> {
    let values: Vec<f64> = recorded_column(run, "temp")?.iter().copied().filter(|x| x.is_finite()).collect();
    let mean = averaged(&values, TEMPERATURE_POINTS);
    let most = mean.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    Some(most - mean.first()?)
}

/// Returns true if the recorded axial force of a run varies.
pub(crate) fn axial_force_varies(run: &Run) -> bool {
    axial_variation(run).is_some_and(|x| x >= MIN_VARYING_AXIAL_FORCE)
}

/// Standard deviation of a recorded axial force over its mean.
fn axial_variation(run: &Run) -> Option<f64> {
    let values: Vec<f64> = recorded_column(run, "axial")?.iter().copied().filter(|x| x.is_finite()).collect();
    let means = values.windows(AXIAL_FORCE_SAMPLES).map(|w| w.iter().sum::<f64>() / AXIAL_FORCE_SAMPLES as f64);
    let smooth: Vec<f64> = means.collect();
    let mean = smooth.iter().sum::<f64>() / smooth.len() as f64;
    let variance = smooth.iter().map(|x| (x - mean) * (x - mean)).sum::<f64>() / smooth.len() as f64;
    Some(variance.sqrt() / mean.abs()).filter(|x| x.is_finite())
}

/// Least-squares slope of a recorded axial force over the deformation at the same samples, divided by the mean force.
pub(crate) fn axial_force_slope(run: &Run, deformation: &[f64]) -> Option<f64> {
    let axial = recorded_column(run, "axial")?;
    let both: Vec<(f64, f64)> =
        axial.iter().zip(deformation).filter(|(n, e)| n.is_finite() && e.is_finite()).map(|(n, e)| (*n, *e)).collect();
    let count = both.len() as f64;
    let mean = |of: fn(&(f64, f64)) -> f64| both.iter().map(of).sum::<f64>() / count;
    let (mean_force, mean_deformation) = (mean(|x| x.0), mean(|x| x.1));
    let (mut product, mut square) = (0.0, 0.0);
    for (n, e) in &both {
        product += (n - mean_force) * (e - mean_deformation);
        square += (e - mean_deformation) * (e - mean_deformation);
    }
    Some(product / square / mean_force).filter(|x| x.is_finite())
}

#[cfg(test)]
mod tests {
    use super::{auxiliary_log_odds, axial_force_slope};
    use hysteron_identify::study::{Column, Study};
    use hysteron_tcl::diagnostic::SourceMap;
    use std::path::Path;

    /// A study whose recordings have a further column.
    fn with(name: &str, of: impl Fn(usize) -> f64) -> Study {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tcl-like-inputs/pad_study/study.toml");
        let mut study = Study::load(&file, &mut SourceMap::default()).expect("a study");
        for r in &mut study.runs {
            let values = (0..r.recording.times.len()).map(&of).collect();
            r.recording.columns.retain(|c| !c.name.starts_with("temp"));
            r.recording.columns.push(Column { name: name.into(), unit: String::new(), values });
        }
        study
    }

    #[test]
    fn a_rising_temperature_supports_self_heating() {
        let warms = with("temperature", |i| 20.0 + 0.2 * i as f64);
        assert!(auxiliary_log_odds(&warms, "self_heating") > 0.0);
        assert_eq!(auxiliary_log_odds(&warms, "cyclic_degradation"), 0.0);
        let room = with("temperature", |i| 20.0 + 0.5 * (i as f64).sin());
        assert_eq!(auxiliary_log_odds(&room, "self_heating"), 0.0);
    }

    #[test]
    fn a_recorded_axial_force_supports_or_opposes_a_varying_load() {
        let wave = |i: usize| (0.05 * i as f64).sin();
        let varies = with("axial", |i| 100.0 * (1.0 + 0.2 * wave(i)));
        assert!(auxiliary_log_odds(&varies, "varying_axial_load") > 0.0);
        let constant = with("axial", |i| 100.0 + (i as f64).sin());
        assert!(auxiliary_log_odds(&constant, "varying_axial_load") < 0.0);
        assert_eq!(auxiliary_log_odds(&with("other", wave), "varying_axial_load"), 0.0);
        let run = &varies.runs[0];
        let deformation: Vec<f64> = (0..run.recording.times.len()).map(|i| 0.01 * wave(i)).collect();
        let slope = axial_force_slope(run, &deformation).expect("a slope");
        assert!((slope - 20.0).abs() < 0.5, "{slope}");
    }
}
