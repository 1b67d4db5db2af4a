//! Forms that replace the law of a device by a whole law.

use super::studies::{self, Channel, CheckpointRecorder, Concealed, Noise, Record};
use hysteron::diagnose::{Diagnosis, Settings};
use hysteron::study::Simulator;
use std::f64::consts::TAU;
use std::fs;

const DT: f64 = 0.05;
const SAMPLES: usize = 300;

/// A law of the analyst: bilinear.
const BILINEAR: &str = "uniaxialMaterial Steel01 1 $Fy [expr {$Ke*1e3}] $b";

/// A bearing under an imposed shear, kN and m. `law` makes material 1.
fn bearing(law: &str) -> String {
    format!(
        "wipe\nmodel basic -ndm 1 -ndf 1\npset Fy 60.0\npset Ke 5.0\npset b 0.2\nnode 1 0.\nnode 2 0.\nfix 1 1\n{law}\n\
        element zeroLength 1 1 2 -mat 1 -dir 1\ntimeSeries Path 1 -dt $dt -filePath $motion\n\
        pattern Plain 1 1 {{ sp 2 1 1.0 }}\nrecorder Element -file force.out -time -ele 1 force\n\
        constraints Transformation\ntest NormDispIncr 1e-10 30\nalgorithm Newton\nintegrator LoadControl $dt\n\
        analysis Static\nfor {{set i 1}} {{$i < $npts}} {{incr i}} {{ if {{[analyze 1] != 0}} {{ error \"no convergence\" }} }}\n"
    )
}

/// Cycles at growing and falling amplitudes, fitted and held out; forces of both runs.
fn study(law: &str, forces: Option<&[Vec<f64>]>) -> Concealed {
    let cycles = |largest: f64, frequency: f64, second: f64| -> Vec<f64> {
        let t = |i: usize| DT * i as f64;
        let envelope = |t: f64| largest * (0.25 + 0.75 * (std::f64::consts::PI * t / (DT * SAMPLES as f64)).sin());
        let wave = |t: f64| (TAU * frequency * t).sin() + 0.3 * (TAU * second * t).sin();
        (0..SAMPLES).map(|i| envelope(t(i)) * wave(t(i)) / 1.3).collect()
    };
    let paths = [("fitted", false, cycles(0.16, 0.5, 1.3)), ("stronger", true, cycles(0.22, 0.4, 0.9))];
    let run = |(n, (name, holdout, path)): (usize, (&'static str, bool, Vec<f64>))| {
        let force = forces.map_or_else(|| path.clone(), |all| all[n].clone());
        let columns = vec![("force[kN]".to_owned(), force)];
        Record { name, holdout, set: String::new(), motions: vec![("motion", path)], columns }
    };
    Concealed {
        model: bearing(law),
        parameters: vec![("Fy", 10.0, 300.0), ("Ke", 0.5, 50.0), ("b", 0.01, 0.9)],
        channels: vec![Channel { name: "force", output: "force.out", column: 2 }],
        dt: DT,
        runs: paths.into_iter().enumerate().map(run).collect(),
    }
}

/// Standard deviation of the noise over the largest force.
const NOISE: f64 = 0.01;

/// Diagnosis of recordings that `law` has made, with the law of the analyst, and the NMSE of the noise held out.
fn diagnosed(name: &str, law: &str) -> (Diagnosis, f64) {
    let truth = study(law, None).write(&format!("{name}-truth"));
    let (mut simulator, initial) = studies::opened(&truth);
    let mut noise = Noise::default();
    let mut force = |run| {
        let force = simulator.simulate(run, &initial.values).unwrap().remove(0);
        let largest = force.iter().filter(|f| f.is_finite()).fold(0.0f64, |m, f| m.max(f.abs()));
        let noisy = |f: &f64| if f.is_finite() { f + NOISE * largest * noise.next() } else { 0.0 };
        force.iter().map(noisy).collect::<Vec<f64>>()
    };
    let forces: Vec<Vec<f64>> = vec![force(0), force(1)];
    let held_out = &forces[1];
    let mean = held_out.iter().sum::<f64>() / SAMPLES as f64;
    let variance = held_out.iter().map(|f| (f - mean).powi(2)).sum::<f64>() / SAMPLES as f64;
    let largest = held_out.iter().fold(0.0f64, |m, f| m.max(f.abs()));
    let floor = (NOISE * largest).powi(2) / variance;
    let dir = study(BILINEAR, Some(&forces)).write(name);
    let settings = Settings { threads: 2, ..Settings::default() };
    let d = studies::attempt(&dir, &settings, &mut CheckpointRecorder::unlimited()).unwrap();
    fs::write(dir.join("corrected.tcl"), &d.repaired_script).unwrap();
    let run = format!("set motion stronger-motion.dat\nset dt {DT}\nset npts {SAMPLES}\nsource corrected.tcl\n");
    fs::write(dir.join("around.tcl"), run).unwrap();
    let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_hysteron"));
    let done = command.args(["run", "around.tcl"]).current_dir(&dir).output().unwrap();
    assert!(done.status.success(), "{}\n{}", String::from_utf8_lossy(&done.stderr), d.repaired_script);
    let _ = fs::remove_dir_all(dir);
    let _ = fs::remove_dir_all(truth);
    (d, floor)
}

/// High damping rubber whose analyst has a bilinear law: the whole law is found, and predicts a stronger run to the noise.
#[test]
fn concealed_high_damping_rubber_is_a_whole_law() {
    let truth = "uniaxialMaterial KikuchiAikenHDR 1 X0.6 3.4e-4 0.06 -coGHU 1.0 0.7 0.8";
    let (d, floor) = diagnosed("rubber-law", truth);
    let o = &d.outcome;
    assert_eq!(o.verdict.cause, "strain_stiffening", "{:?}", o.verdict);
    assert!(o.verdict.also.is_empty(), "{:?}", o.verdict);
    // The loop of another law stands beside that of the analyst's, and is nearer to the recorded one.
    let l = d.device_loop.as_ref().unwrap();
    let away = |points: &[(f64, f64)]| {
        let squares = points.iter().zip(&l.recorded).map(|(a, b)| (a.1 - b.1).powi(2));
        squares.filter(|x| x.is_finite()).sum::<f64>()
    };
    assert!(!l.recorded.is_empty() && l.after.len() == l.recorded.len(), "{l:?}");
    assert!(away(&l.after) < 0.3 * away(&l.before), "{} {}", away(&l.after), away(&l.before));
    assert!(d.repaired_script.contains("KikuchiAikenHDR 1 X0.6 $::hy_area $::hy_height"), "{}", d.repaired_script);
    let height = o.corrected.parameters["hy_height"];
    assert!((height - 0.06).abs() < 0.003, "{height}");
    let (before, after) = (o.baseline.holdout_nmse.unwrap(), o.corrected.holdout_nmse.unwrap());
    assert!(after < 2.0 * floor && after < 0.05 * before, "{before} {after} {floor}");
    // The stiffening is one of the phenomena that did the work.
    assert!(o.verdict.explanation.contains("% without its stiffening at large strain"), "{}", o.verdict.explanation);
    // The yield force and the stiffnesses of the replaced law count no more.
    assert!(o.evidence.hypotheses[0].user_parameters_at_bound == 0, "{:?}", o.evidence.hypotheses[0]);
    assert!(o.corrected.opensees.is_some(), "{:?}", o.corrected.opensees_reason);
}

/// Rubber with an overstress: the law is found, and the overstress does the work.
#[test]
fn concealed_rheology_is_a_whole_law() {
    let truth = "uniaxialMaterial HDRRheology 1 6.0 0.55 0.02 0.30 4.6 9.0 0.7 0.75 1.9 0.25 -area 150.0 -height 0.11";
    let (d, floor) = diagnosed("rheology-law", truth);
    let o = &d.outcome;
    assert_eq!(o.verdict.cause, "rate_dependence", "{:?}", o.verdict);
    assert!(d.repaired_script.contains("HDRRheology 1 "), "{}", d.repaired_script);
    let (before, after) = (o.baseline.holdout_nmse.unwrap(), o.corrected.holdout_nmse.unwrap());
    assert!(after < 2.5 * floor && after < 0.4 * before, "{before} {after} {floor}");
    let gain = o.verdict.explanation.split("the fit loses").nth(1).unwrap();
    assert!(gain.contains("without its overstress"), "{gain}");
}

/// Rubber that softens by its largest strain and by cycles: the law is found without a sensor at fault.
#[test]
fn concealed_softening_by_strain_and_cycles_is_a_whole_law() {
    let truth =
        "uniaxialMaterial HDR_mat 1 60.0 0.0 300.0 1.0 0.5 0.0 1.0 3.0 0.4 0.08 0.6 150.0 2.5 0.9 0.4 0.1 0.02 0.13";
    let (d, floor) = diagnosed("softening-law", truth);
    let o = &d.outcome;
    assert_eq!(o.verdict.cause, "mullins_softening", "{:?}", o.verdict);
    assert!(d.repaired_script.contains("HDR_mat 1 "), "{}", d.repaired_script);
    let (before, after) = (o.baseline.holdout_nmse.unwrap(), o.corrected.holdout_nmse.unwrap());
    assert!(after < 3.0 * floor && after < 0.3 * before, "{before} {after} {floor}");
    let gain = o.verdict.explanation.split("the fit loses").nth(1).unwrap();
    assert!(gain.contains("without its softening by the largest strain"), "{gain}");
}

/// A bearing whose yield force differs between two fitted runs: the parameter, the run and the factor are told.
#[test]
fn a_condition_that_changed_between_runs_is_named() {
    let forces: Vec<Vec<f64>> = [60.0, 84.0]
        .iter()
        .enumerate()
        .map(|(run, strength)| {
            let truth = study(&BILINEAR.replace("$Fy", &strength.to_string()), None).write(&format!("condition-{run}"));
            let (mut simulator, initial) = studies::opened(&truth);
            let force = simulator.simulate(run, &initial.values).unwrap().remove(0);
            let _ = fs::remove_dir_all(truth);
            let mut noise = Noise::default();
            force.iter().map(|f| if f.is_finite() { f + NOISE * 100.0 * noise.next() } else { 0.0 }).collect()
        })
        .collect();
    let mut concealed = study(BILINEAR, Some(&forces));
    concealed.runs.iter_mut().for_each(|run| run.holdout = false);
    let dir = concealed.write("condition");
    let settings = Settings { threads: 2, ..Settings::default() };
    let d = studies::attempt(&dir, &settings, &mut CheckpointRecorder::unlimited()).unwrap();
    let _ = fs::remove_dir_all(dir);
    assert_eq!(d.outcome.verdict.cause, "changed_condition", "{:?}", d.outcome.verdict);
    let factor = d.outcome.corrected.parameters["hy_factor_on_Fy"];
    assert!((factor - 84.0 / 60.0).abs() < 0.02, "{factor}");
    let told = "if {$::motion eq {stronger-motion.dat}} {set Fy [expr {$Fy*$::hy_factor_on_Fy}]}";
    assert!(d.repaired_script.contains(told), "{}", d.repaired_script);
}
