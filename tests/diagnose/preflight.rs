//! Mistakes in channels that are found before a fit, and none where there is none.

use super::studies::{Channel, Concealed, Noise, Record, SHAKEN};
use hysteron::analysis::Options;
use hysteron::diagnostic::SourceMap;
use hysteron::preflight::{Finding, FindingKind, preflight};
use hysteron::study::{Column, ObservedChannel, Run, ScriptSimulator, Simulator, Study};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

const DT: f64 = 0.01;

fn motion(seed: f64, n: usize) -> Vec<f64> {
    let wave = |t: f64, f: f64| (f * t + seed * f).sin();
    let at = |i: usize| {
        let t = DT * i as f64;
        2.0 * (0.4 * t).sin().powi(2) * (wave(t, 9.0) + 0.7 * wave(t, 17.0) + 0.5 * wave(t, 31.0))
    };
    (0..n).map(at).collect()
}

fn with_variance(o: &mut ObservedChannel, values: Vec<f64>) {
    let n = values.len() as f64;
    let mean = values.iter().sum::<f64>() / n;
    o.variance = values.iter().map(|v| (v - mean).powi(2)).sum::<f64>() / n;
    o.values = values;
}

/// Two shaken runs whose recordings are the model's with other parameters and some noise.
fn study(name: &str) -> Study {
    let accelerations = "recorder Node -file acc.out -time -node 2 -dof 1 accel\nconstraints Plain";
    let channel = |name, output| Channel { name, output, column: 1 };
    let run = |name, holdout, seed| {
        let ground = motion(seed, 1500);
        let columns = ["disp[m]", "acc[m/s2]"].map(|c| (c.to_owned(), ground.clone())).to_vec();
        Record { name, holdout, set: String::new(), motions: vec![("motion", ground)], columns }
    };
    let concealed = Concealed {
        model: SHAKEN.replace("constraints Plain", accelerations),
        parameters: vec![("k", 200.0, 800.0), ("uy", 0.01, 0.05)],
        channels: vec![channel("disp", "disp.out"), channel("acc", "acc.out")],
        dt: DT,
        runs: vec![run("first", false, 0.3), run("second", true, 1.1)],
    };
    let dir = concealed.write(&format!("preflight-{name}"));
    let mut study = Study::load(&dir.join("study.toml"), &mut SourceMap::default()).unwrap();
    let mut simulator = opened(&study).0;
    let mut noise = Noise::default();
    for i in 0..study.runs.len() {
        let truth = simulator.simulate(i, &[410.0, 0.021]).unwrap();
        for (o, y) in study.runs[i].observe.iter_mut().zip(truth) {
            let size = 0.02 * y.iter().fold(0.0f64, |m, y| m.max(y.abs()));
            with_variance(o, y.iter().map(|y| y + size * noise.next()).collect());
        }
    }
    study
}

fn opened(study: &Study) -> (ScriptSimulator, hysteron::study::InitialRun) {
    let mut simulator =
        ScriptSimulator::new(Arc::new(study.clone()), Options::default(), Arc::new(AtomicBool::new(false)));
    let initial_run = simulator.run_initially(&mut SourceMap::default()).unwrap();
    (simulator, initial_run)
}

fn findings(study: &Study) -> Vec<Finding> {
    let (simulator, initial_run) = opened(study);
    let one = preflight(&simulator, &initial_run, 1).unwrap();
    let two = preflight(&simulator, &initial_run, 2).unwrap();
    let text = |p: &hysteron::preflight::Preflight| serde_json::to_string(p).unwrap();
    assert_eq!(text(&one), text(&two), "the number of threads changes the result");
    assert_eq!(one.channels.len(), 4);
    one.findings
}

/// The study with a change of its runs.
fn changed(study: &Study, change: impl Fn(&mut Run)) -> Vec<Finding> {
    let mut study = study.clone();
    study.runs.iter_mut().for_each(change);
    findings(&study)
}

/// The samples of a channel, each from the samples and its index.
fn rewrite(run: &mut Run, channel: usize, of: impl Fn(&[f64], usize) -> f64) {
    let old = run.observe[channel].values.clone();
    with_variance(&mut run.observe[channel], (0..old.len()).map(|i| of(&old, i)).collect());
}

fn only(found: &[Finding]) -> &Finding {
    assert_eq!(found.len(), 1, "{found:?}");
    assert_eq!(found[0].runs.len(), 2, "{found:?}");
    &found[0]
}

#[test]
fn channels_as_recorded_have_no_finding() {
    assert!(findings(&study("none")).is_empty());
}

#[test]
fn sign_and_units_are_found_with_their_factor() {
    let study = study("factor");
    for (channel, factor, kind, said) in [
        (0, -1.0, FindingKind::Sign, "is the sign turned?"),
        (1, -1.0, FindingKind::Sign, "is the sign turned?"),
        (0, 1000.0, FindingKind::Unit, "mm for m?"),
        (0, 0.01, FindingKind::Unit, "m for cm?"),
        (1, 1.0 / 9.80665, FindingKind::Unit, "g for m/s2?"),
        (1, -100.0, FindingKind::Unit, "cm/s2 for m/s2, and the sign turned?"),
    ] {
        let found = changed(&study, |r| rewrite(r, channel, |v, i| factor * v[i]));
        let f = only(&found);
        assert_eq!((f.kind, f.is_hard), (kind, true), "{f:?}");
        assert!(f.message.contains(said), "{}", f.message);
        assert!((f.factor.unwrap() / factor - 1.0).abs() < 0.25, "{factor} {f:?}");
    }
}

#[test]
fn delays_are_found_and_short_ones_stop_no_diagnosis() {
    let study = study("lag");
    for (steps, is_hard) in [(50, true), (20, false)] {
        let found = changed(&study, |r| rewrite(r, 1, |v, i| v[i.saturating_sub(steps)]));
        let f = only(&found);
        assert_eq!((f.kind, f.is_hard), (FindingKind::Lag, is_hard), "{f:?}");
        assert!((f.lag_s.unwrap() - DT * steps as f64).abs() < 0.02, "{f:?}");
    }
}

#[test]
fn exchanged_channels_and_absolute_accelerations_are_found() {
    let study = study("exchange");
    let found = changed(&study, |r| {
        let (a, b) = (r.observe[0].values.clone(), r.observe[1].values.clone());
        with_variance(&mut r.observe[0], b);
        with_variance(&mut r.observe[1], a);
    });
    assert!(found.len() == 2 && found.iter().all(|f| f.kind == FindingKind::Swapped && f.is_hard), "{found:?}");
    let grounds = [0.3, 1.1].map(|seed| motion(seed, 1500));
    let found = changed(&study, |r| {
        let ground = &grounds[usize::from(r.name == "second")];
        rewrite(r, 1, |v, i| v[i] + ground[i]);
    });
    let f = only(&found);
    assert_eq!((f.kind, f.is_hard), (FindingKind::Acceleration, true), "{f:?}");
    assert!(f.message.contains("the recorded acceleration is absolute"), "{}", f.message);
}

#[test]
fn recorded_inputs_are_compared_with_the_imposed_motion() {
    let study = study("input");
    let with_ground = |of: &dyn Fn(usize) -> Vec<f64>| {
        let mut study = study.clone();
        for (i, r) in study.runs.iter_mut().enumerate() {
            r.recording.columns.push(Column { name: "ground_acc".into(), unit: "m/s2".into(), values: of(i) });
        }
        findings(&study)
    };
    let imposed = |i: usize| motion([0.3, 1.1][i], 1500);
    assert!(with_ground(&imposed).is_empty());
    let other = with_ground(&|i| motion([2.7, 4.9][i], 1500));
    assert!(only(&other).kind == FindingKind::Input && !other[0].is_hard, "{other:?}");
    let in_g = with_ground(&|i| imposed(i).iter().map(|a| a / 9.80665).collect());
    assert!(only(&in_g).message.contains("g for m/s2?"), "{in_g:?}");
}

#[test]
fn samples_after_the_analysis_and_equal_channels_are_told() {
    let study = study("after");
    let found = changed(&study, |r| r.recording.times.iter_mut().for_each(|t| *t *= 1.2));
    assert!(found.iter().any(|f| f.kind == FindingKind::AfterAnalysis && !f.is_hard), "{found:?}");
    let found = changed(&study, |r| {
        let first = r.observe[0].values.clone();
        with_variance(&mut r.observe[1], first);
    });
    assert!(found.iter().any(|f| f.kind == FindingKind::Duplicate && f.message.contains("same samples as disp")));
}

#[test]
fn a_turned_sign_is_a_gain_of_the_sensor_and_no_physics() {
    let dir = super::concealed("sign", |_, f| f.iter().map(|f| -f).collect());
    let command = |more: &[&str]| {
        let study = dir.join("study.toml");
        let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_hysteron"));
        command.arg("diagnose").arg(study).arg("--out").arg(dir.join("results")).args(more).output().unwrap()
    };
    let refused = command(&[]);
    let said = String::from_utf8_lossy(&refused.stderr).into_owned();
    assert_eq!(refused.status.code(), Some(2), "{said}");
    assert!(said.contains("is the sign turned?") && said.contains("factor = -1"), "{said}");
    assert!(!dir.join("results").exists());

    let done = command(&["--as-recorded"]);
    assert_eq!(done.status.code(), Some(0), "{}", String::from_utf8_lossy(&done.stderr));
    let text = std::fs::read_to_string(dir.join("results/diagnosis.json")).unwrap();
    let result: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!(result["verdict"]["cause"], "sensor_gain", "{text}");
    let gain = result["corrected"]["channels"][0]["gain"].as_f64().unwrap();
    assert!((gain + 1.0).abs() < 0.05, "{gain}");
    assert_eq!(result["preflight"]["findings"][0]["kind"], "sign");
    let _ = std::fs::remove_dir_all(dir);
}
