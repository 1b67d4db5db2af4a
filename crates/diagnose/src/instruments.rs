//! What columns that no channel observes say of causes: a thermometer, a load cell.

use super::conditions::column;
use super::noise::averaged;
use hysteron_identify::study::{Role, Run, Study};

/// Log odds by which an instrument speaks for a cause, or against it: much, and not all, since it need not be what moves the channels.
/// A choice.
const SPEAKS: f64 = 4.0;
/// Degrees by which a device becomes warmer in a run where work warms it: no matter of the room.
const WARMER: f64 = 3.0;
/// Standard deviation of a recorded axial force over its mean from which it varies, and up to which it does not: in trials of
/// validation/diagnosis 0.09 to 0.29 where it does, 0.002 where it does not.
const VARIES: f64 = 0.05;
const CONSTANT: f64 = 0.02;
/// Points that a temperature is averaged to, and samples of an axial force that are averaged: it follows the motion.
const POINTS: usize = 20;
const SAMPLES: usize = 5;

/// Log odds for a cause.
pub(super) fn speak_for(study: &Study, cause: &str) -> f64 {
    let fitted = || study.runs_of(Role::Fit).map(|(_, r)| r);
    match cause {
        "self_heating" if fitted().filter_map(rise).any(|x| x >= WARMER) => SPEAKS,
        "varying_axial_load" => {
            let varies: Vec<Option<f64>> = fitted().map(variation).collect();
            if varies.iter().flatten().any(|x| *x >= VARIES) {
                SPEAKS
            } else if !varies.is_empty() && varies.iter().all(|x| x.is_some_and(|x| x <= CONSTANT)) {
                -SPEAKS
            } else {
                0.0
            }
        }
        _ => 0.0,
    }
}

/// By how much a recorded temperature rises from its beginning.
fn rise(run: &Run) -> Option<f64> {
    let values: Vec<f64> = column(run, "temp")?.iter().copied().filter(|x| x.is_finite()).collect();
    let mean = averaged(&values, POINTS);
    let most = mean.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    Some(most - mean.first()?)
}

/// Whether the recorded axial force of a run varies.
pub(super) fn axial_varies(run: &Run) -> bool {
    variation(run).is_some_and(|x| x >= VARIES)
}

/// Standard deviation of a recorded axial force over its mean.
fn variation(run: &Run) -> Option<f64> {
    let values: Vec<f64> = column(run, "axial")?.iter().copied().filter(|x| x.is_finite()).collect();
    let smooth: Vec<f64> = values.windows(SAMPLES).map(|w| w.iter().sum::<f64>() / SAMPLES as f64).collect();
    let mean = smooth.iter().sum::<f64>() / smooth.len() as f64;
    let square = smooth.iter().map(|x| (x - mean) * (x - mean)).sum::<f64>() / smooth.len() as f64;
    Some(square.sqrt() / mean.abs()).filter(|x| x.is_finite())
}

/// Part of its mean by which a recorded axial force grows with a deformation of the same samples, by least squares.
pub(super) fn axial_over(run: &Run, deformation: &[f64]) -> Option<f64> {
    let axial = column(run, "axial")?;
    let both: Vec<(f64, f64)> =
        axial.iter().zip(deformation).filter(|(n, e)| n.is_finite() && e.is_finite()).map(|(n, e)| (*n, *e)).collect();
    let count = both.len() as f64;
    let mean = |of: fn(&(f64, f64)) -> f64| both.iter().map(of).sum::<f64>() / count;
    let (n, e) = (mean(|x| x.0), mean(|x| x.1));
    let (mut product, mut square) = (0.0, 0.0);
    for (x, y) in &both {
        product += (x - n) * (y - e);
        square += (y - e) * (y - e);
    }
    Some(product / square / n).filter(|x| x.is_finite())
}

#[cfg(test)]
mod tests {
    use super::{axial_over, speak_for};
    use hysteron_identify::study::{Column, Study};
    use hysteron_tcl::diagnostic::SourceMap;
    use std::path::Path;

    /// A study whose recordings have one column more.
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
    fn a_thermometer_speaks_for_heat() {
        let warms = with("temperature", |i| 20.0 + 0.2 * i as f64);
        assert!(speak_for(&warms, "self_heating") > 0.0);
        assert_eq!(speak_for(&warms, "cyclic_degradation"), 0.0);
        let room = with("temperature", |i| 20.0 + 0.5 * (i as f64).sin());
        assert_eq!(speak_for(&room, "self_heating"), 0.0);
    }

    #[test]
    fn a_load_cell_speaks_for_axial_forces_that_vary_and_against_those_that_do_not() {
        let wave = |i: usize| (0.05 * i as f64).sin();
        let varies = with("axial", |i| 100.0 * (1.0 + 0.2 * wave(i)));
        assert!(speak_for(&varies, "varying_axial_load") > 0.0);
        let constant = with("axial", |i| 100.0 + (i as f64).sin());
        assert!(speak_for(&constant, "varying_axial_load") < 0.0);
        assert_eq!(speak_for(&with("other", wave), "varying_axial_load"), 0.0);
        let run = &varies.runs[0];
        let deformation: Vec<f64> = (0..run.recording.times.len()).map(|i| 0.01 * wave(i)).collect();
        let slope = axial_over(run, &deformation).expect("a slope");
        assert!((slope - 20.0).abs() < 0.5, "{slope}");
    }
}
