use super::{
    UnmodelledStructure, common_share, sample_step, silent_share, unmodelled_structure, unsteady_share,
    variance_normalised,
};
use crate::inspect::response::{ResponseHistory, ResponseRanges};
use crate::prior::MIN_SHARED_STRUCTURE;
use crate::test_support::{pad_study, white_noise};
use hysteron_identify::study::{Role, Score, ScoredRun};

#[test]
fn independent_sensor_noise_has_no_common_share() {
    let own: Vec<Vec<f64>> = (1..4).map(|seed| white_noise(seed, 900)).collect();
    assert!((0..3).all(|c| common_share(&own, c, &[]) < 0.05));
    // A force that moves all channels, each a sample later.
    let force = white_noise(9, 910);
    let moved: Vec<Vec<f64>> = (0..3).map(|c| own[c].iter().zip(&force[c..]).map(|(o, f)| o + f).collect()).collect();
    assert!((0..3).all(|c| common_share(&moved, c, &[]) > 0.5));
    assert!(common_share(&moved[..1], 0, &[]) == 0.0);
}

/// Noise that grows with the reading is neither silent nor unsteady; an event of its own is.
#[test]
fn noise_may_grow_with_the_reading() {
    let n = 1200;
    let channel: Vec<f64> = (0..n).map(|t| (t as f64 / n as f64) * (0.05 * t as f64).sin()).collect();
    let mut flagged = 0;
    for seed in 1..20 {
        let grows: Vec<f64> =
            white_noise(seed, n).iter().zip(&channel).map(|(x, y)| x * (0.1f64 + y * y).sqrt()).collect();
        let steady = variance_normalised(&grows, &channel);
        assert!(silent_share(&grows) > 0.3, "{seed} {}", silent_share(&grows));
        flagged += usize::from(silent_share(&steady).max(unsteady_share(&steady)) > 0.05);
        let rung = |t: usize| if t % 500 > 400 { 8.0 * (0.4 * t as f64).sin() } else { 0.0 };
        let struck: Vec<f64> = white_noise(seed, n).iter().enumerate().map(|(t, x)| x + rung(t)).collect();
        assert!(silent_share(&variance_normalised(&struck, &channel)) > 0.3);
    }
    assert!(flagged < 3, "{flagged}");
}

const SAMPLES: usize = 1500;

fn times() -> Vec<f64> {
    (0..SAMPLES).map(|i| 0.01 * i as f64).collect()
}

/// A motion of several tones.
fn motion() -> Vec<f64> {
    times().iter().map(|t| (2.0 * t).sin() + 0.6 * (4.7 * t + 1.0).sin() + 0.4 * (7.3 * t + 2.0).sin()).collect()
}

/// Force of a pad under that motion: a spring, and a part that follows the sense of the motion.
fn force() -> Vec<f64> {
    let u = motion();
    (0..SAMPLES).map(|i| 10.0 * u[i] + 3.0 * ((u[i] - u[i.saturating_sub(1)]) / 0.005).tanh()).collect()
}

/// Structure that a model leaves which lacks the `error` of one channel.
fn left(error: &[f64]) -> UnmodelledStructure {
    let recorded: Vec<f64> = force().iter().zip(error).map(|(f, e)| f + e).collect();
    left_of(recorded)
}

fn left_of(recorded: Vec<f64>) -> UnmodelledStructure {
    let mut study = pad_study();
    study.runs.retain(|r| r.role == Role::Fit);
    study.runs.truncate(1);
    let run = &mut study.runs[0];
    run.recording.times = times();
    run.observe.truncate(1);
    let mean = recorded.iter().sum::<f64>() / SAMPLES as f64;
    run.observe[0].variance = recorded.iter().map(|v| (v - mean).powi(2)).sum::<f64>() / SAMPLES as f64;
    run.observe[0].values = recorded;
    let history = ResponseHistory { times: times(), deformation: motion(), force: force() };
    let responses = ResponseRanges { histories: [((0, 1, 1), history)].into(), ..ResponseRanges::default() };
    let scores = vec![Score { nmse: 0.0, samples: SAMPLES, dropped: 0 }];
    unmodelled_structure(&study, &responses, &[ScoredRun { channels: vec![force()], scores }], true)
}

/// Number of seeds of which an error is structure, and of those with a remark on the sensor.
fn counted(error: impl Fn(u64) -> Vec<f64>) -> [usize; 2] {
    let all: Vec<UnmodelledStructure> = (1..13).map(|seed| left(&error(seed))).collect();
    let is_physics = |s: &&UnmodelledStructure| s.share > MIN_SHARED_STRUCTURE;
    [all.iter().filter(is_physics).count(), all.iter().filter(|s| !s.unsteady_channels.is_empty()).count()]
}

fn is_burst(t: usize) -> bool {
    (300..360).contains(&t) || (820..850).contains(&t) || (1200..1290).contains(&t)
}

/// Steady noise has neither structure nor a remark.
#[test]
fn steady_noise_is_nothing() {
    let [physics, remarks] = counted(|seed| white_noise(seed, SAMPLES));
    assert!(physics == 0 && remarks == 0, "{physics} {remarks}");
}

/// Bursts that do not follow the motion are noise of the sensor, whatever their colour.
#[test]
fn bursts_alone_are_noise_with_a_remark() {
    let bursts = |seed, colour: f64| {
        let mut x = white_noise(seed, SAMPLES);
        (1..SAMPLES).for_each(|t| x[t] += colour * x[t - 1]);
        (0..SAMPLES).map(|t| 0.2 * x[t] * if is_burst(t) { 8.0 } else { 1.0 }).collect::<Vec<f64>>()
    };
    for colour in [0.0, 0.6] {
        let [physics, remarks] = counted(|seed| bursts(seed, colour));
        assert!(physics <= 1 && remarks >= 11, "{colour}: {physics} {remarks}");
    }
}

/// A force that the device has in some stretches alone follows the motion, and its loudness is physics.
#[test]
fn bursts_of_the_motion_are_physics() {
    let u = motion();
    let sticks = |t: usize| 2.0 * ((u[t] - u[t.saturating_sub(1)]) / 0.005).tanh();
    let [physics, remarks] = counted(|seed| {
        let noise = white_noise(seed, SAMPLES);
        (0..SAMPLES).map(|t| 0.2 * noise[t] + if t % 500 < 250 { sticks(t) } else { 0.0 }).collect()
    });
    assert!(physics == 12 && remarks == 0, "{physics} {remarks}");
}

/// Noise that grows with the reading is neither.
#[test]
fn proportional_noise_is_nothing() {
    let f = force();
    let [physics, remarks] = counted(|seed| {
        let noise = white_noise(seed, SAMPLES);
        (0..SAMPLES).map(|t| noise[t] * (0.05 + 0.05 * f[t].abs())).collect()
    });
    assert!(physics <= 1 && remarks <= 1, "{physics} {remarks}");
}

/// A hum comes again all the time: it is no noise.
#[test]
fn a_hum_is_a_line() {
    for seed in 1..6 {
        let noise = white_noise(seed, SAMPLES);
        let hum: Vec<f64> = (0..SAMPLES).map(|t| 0.2 * noise[t] + 0.6 * (1.3 * t as f64).sin()).collect();
        let found = left(&hum);
        assert!(found.by_kind.get("line").is_some_and(|s| *s > 0.3), "{:?}", found.by_kind);
    }
}

/// Rounding recurs along the stroke with the force, and is no physics; a force of the same size beside it is.
#[test]
fn rounded_samples_are_no_structure() {
    for step in [0.2, 0.5, 1.0] {
        let round = |x: &f64| step * (x / step).round();
        let rounded: Vec<f64> = force().iter().map(round).collect();
        let found = left_of(rounded);
        assert!(found.share < MIN_SHARED_STRUCTURE && found.unsteady_channels.is_empty(), "{step}: {found:?}");
        let ripples: Vec<f64> =
            force().iter().zip(motion()).map(|(f, u)| round(&(f + 1.5 * step * (9.0 * u).sin()))).collect();
        assert!(left_of(ripples).share > 0.5, "{step}");
    }
}

#[test]
fn the_step_of_samples_is_that_of_all() {
    let numbers: Vec<f64> = white_noise(1, 200).iter().map(|x| 0.7 + 0.25 * (x / 0.25).round()).collect();
    assert!((sample_step(&numbers) - 0.25).abs() < 1e-12);
    assert_eq!(sample_step(&white_noise(1, 200)), 0.0);
    assert_eq!((sample_step(&[]), sample_step(&[1.0, 1.0])), (0.0, 0.0));
}
