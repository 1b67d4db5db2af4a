//! Forms that switch an option of a law on, and parameters of amended elements.

use super::studies::{self, Channel, Concealed, Noise, Record};
use super::{concealed, diagnosed, runs_by_itself};
use hysteron::diagnose::Settings;
use hysteron::study::Simulator;
use std::f64::consts::TAU;
use std::fs;
use std::path::Path;
use studies::CheckpointRecorder;

const DT: f64 = 0.05;
/// Standard deviation of the noise, MPa.
const NOISE: f64 = 0.02;
/// Heat capacity of the rubber that was tested, MPa per degree.
const HEAT_CAPACITY: f64 = 3.11;

/// High damping rubber in the cold, with its stress recorded below the element.
fn rubber(options: &str) -> String {
    format!(
        "wipe\nmodel basic -ndm 1 -ndf 1\npset A 1.0\nnode 1 0.\nnode 2 0.\nfix 1 1\n\
        proc rubber {{tag}} {{\n    global A\n    \
        uniaxialMaterial HDRRheology $tag -compound HDR3 -temperature -30 -area $A{options}\n}}\nrubber 1\n\
        element zeroLength 1 1 2 -mat 1 -dir 1\ntimeSeries Path 1 -dt $dt -filePath $motion\n\
        pattern Plain 1 1 {{ sp 2 1 1.0 }}\nrecorder Element -file stress.out -time -ele 1 material 1 stress\n\
        constraints Transformation\ntest NormDispIncr 1e-10 30\nalgorithm Newton\nintegrator LoadControl $dt\n\
        analysis Static\nfor {{set i 1}} {{$i < $npts}} {{incr i}} {{ if {{[analyze 1] != 0}} {{ error \"no convergence\" }} }}\n"
    )
}

/// Cycles at a strain amplitude, fitted and held out.
fn tests_of_rubber(stresses: Option<&[Vec<f64>]>) -> Vec<Record> {
    let cycles = |amplitude: f64, frequency: f64| -> Vec<f64> {
        (0..240).map(|i| amplitude * (TAU * frequency * DT * f64::from(i)).sin()).collect()
    };
    let run = |(n, (name, holdout, path)): (usize, (&'static str, bool, Vec<f64>))| {
        let stress = stresses.map_or_else(|| path.clone(), |all| all[n].clone());
        let columns = vec![("stress[MPa]".to_owned(), stress)];
        Record { name, holdout, set: String::new(), motions: vec![("motion", path)], columns }
    };
    let paths = [("strong", false, cycles(1.5, 0.5)), ("weaker", true, cycles(1.2, 0.3))];
    paths.into_iter().enumerate().map(run).collect()
}

fn study(model: String, stresses: Option<&[Vec<f64>]>) -> Concealed {
    Concealed {
        model,
        parameters: vec![("A", 0.7, 1.4)],
        channels: vec![Channel { name: "stress", output: "stress.out", column: 1 }],
        dt: DT,
        runs: tests_of_rubber(stresses),
    }
}

/// Self-heating is found by the law's own heat capacity, to the noise, although the channel lies below the element.
#[test]
fn concealed_self_heating_is_an_option_of_the_law() {
    let truth = study(rubber(&format!(" -heatCapacity {HEAT_CAPACITY} -beyond hold")), None).write("rubber-truth");
    let (mut simulator, initial) = studies::opened(&truth);
    let mut noise = Noise::default();
    let mut stress = |run| {
        let channels = simulator.simulate(run, &initial.values).unwrap();
        channels[0].iter().map(|s| if s.is_finite() { s + NOISE * noise.next() } else { 0.0 }).collect()
    };
    let stresses: Vec<Vec<f64>> = vec![stress(0), stress(1)];
    let dir = study(rubber(""), Some(&stresses)).write("rubber");
    let settings = Settings { threads: 2, ..Settings::default() };
    let d = studies::attempt(&dir, &settings, &mut CheckpointRecorder::unlimited()).unwrap();
    let o = &d.outcome;
    assert_eq!(o.verdict.cause, "self_heating", "{:?}", o.verdict);
    assert!(o.verdict.also.is_empty(), "{:?}", o.verdict);
    assert!(o.unmoved_channels.is_empty(), "{:?}", o.unmoved_channels);
    // The loop of the device by the law as it was and with its option; the recorded stress is no force.
    let l = d.device_loop.as_ref().unwrap();
    let moves = l.before.iter().zip(&l.after).map(|(a, b)| (a.1 - b.1).abs()).filter(|x| x.is_finite()).sum::<f64>();
    assert!(l.element == 1 && l.recorded.is_empty() && l.before.len() == l.after.len() && moves > 0.1, "{l:?}");
    let capacity = o.corrected.parameters["hy_heatCapacity"];
    assert!((capacity - HEAT_CAPACITY).abs() < 0.1 * HEAT_CAPACITY, "{capacity}");
    // Noise over the variance of the held-out stress.
    let held_out = &stresses[1];
    let mean = held_out.iter().sum::<f64>() / held_out.len() as f64;
    let variance = held_out.iter().map(|s| (s - mean).powi(2)).sum::<f64>() / held_out.len() as f64;
    let (before, after) = (o.baseline.holdout_nmse.unwrap(), o.corrected.holdout_nmse.unwrap());
    assert!(after < 1.5 * NOISE * NOISE / variance && after < 0.1 * before, "{before} {after}");
    assert!(d.repaired_script.contains("-heatCapacity $::hy_heatCapacity"), "{}", d.repaired_script);
    assert!(o.corrected.opensees_reason.as_ref().unwrap().contains("HDRRheology"), "{:?}", o.corrected);
    fs::write(dir.join("corrected.tcl"), &d.repaired_script).unwrap();
    fs::write(
        dir.join("around.tcl"),
        format!("set motion weaker-motion.dat\nset dt {DT}\nset npts 240\nsource corrected.tcl\n"),
    )
    .unwrap();
    let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_hysteron"));
    let done = command.args(["run", "around.tcl"]).current_dir(&dir).output().unwrap();
    assert!(done.status.success(), "{}\n{}", String::from_utf8_lossy(&done.stderr), d.repaired_script);
    let _ = fs::remove_dir_all(dir);
    let _ = fs::remove_dir_all(truth);
}

/// The thesis' programme in small: three cycles of each test, at every second row. An independent integrator has concealed
/// self-heating and softening; both are found as options of the law, and every constant within 10 %.
#[test]
fn thesis_programme_in_small() {
    const ROWS: usize = 3 * 80;
    let study = Path::new(env!("CARGO_MANIFEST_DIR")).join("tcl-like-inputs/hdr_heating_study");
    let dir = std::env::temp_dir().join(format!("hysteron-diagnose-thesis-{}", std::process::id()));
    fs::create_dir_all(&dir).unwrap();
    fs::copy(study.join("rubber.tcl"), dir.join("model.tcl")).unwrap();
    let text = fs::read_to_string(study.join("study.toml")).unwrap();
    fs::write(dir.join("study.toml"), text.replace("rubber.tcl", "model.tcl")).unwrap();
    for run in ["sine_a", "sine_b", "slow_c", "fast_d"] {
        let text = fs::read_to_string(study.join(run).with_extension("csv")).unwrap();
        let rows = text.lines().enumerate().filter(|(i, _)| *i == 0 || i % 2 == 1 && *i <= ROWS + 1);
        let small: String = rows.map(|(_, row)| format!("{row}\n")).collect();
        fs::write(dir.join(run).with_extension("csv"), small).unwrap();
    }
    let settings = Settings { threads: 2, ..Settings::default() };
    let d = studies::attempt(&dir, &settings, &mut CheckpointRecorder::unlimited()).unwrap();
    let o = &d.outcome;
    assert_eq!(
        (o.verdict.cause.as_str(), o.verdict.also.as_slice()),
        ("self_heating", &["mullins_softening".into()][..])
    );
    for option in ["-heatCapacity $::hy_heatCapacity", "-mullins $::hy2_excess $::hy2_strain"] {
        assert!(d.repaired_script.contains(option), "{}", d.repaired_script);
    }
    let concealed = [
        ("hy_heatCapacity", 3.292),
        ("hy2_excess", 0.25),
        ("hy2_strain", 0.6),
        ("spring", 1.06),
        ("friction", 0.92),
        ("overstress", 1.08),
        ("viscosity", 0.95),
    ];
    for (name, truth) in concealed {
        let found = o.corrected.parameters[name];
        assert!((found / truth - 1.0).abs() < 0.1, "{name}: {found} instead of {truth}");
    }
    // Noise of 0.02 MPa over the variance of the stresses is 0.0001.
    let (before, after) = (o.baseline.holdout_nmse.unwrap(), o.corrected.holdout_nmse.unwrap());
    assert!(after < 1.5e-4 && before > 1e-3, "{before} {after}");
    let _ = fs::remove_dir_all(dir);
}

/// A parameter that the script changes while it runs reaches the element inside an amendment.
#[test]
fn friction_is_found_beside_an_updated_parameter() {
    let rubbing = |u: &[f64], f: &[f64]| -> Vec<f64> {
        let mut slider = 0.0f64;
        let mut before = 0.0;
        let force = |(u, f): (&f64, &f64)| {
            slider = (slider + 4e4 * (u - before)).clamp(-4.0, 4.0);
            before = *u;
            f + slider
        };
        u.iter().zip(f).map(force).collect()
    };
    let dir = concealed("parameter", rubbing);
    // The yield force is known, so that friction is not taken for it.
    let model = fs::read_to_string(dir.join("model.tcl")).unwrap();
    let updated = model
        .replace("uniaxialMaterial Elastic 2 $k\nuniaxialMaterial Parallel 3 1 2\n", "uniaxialMaterial Elastic 2 1.0\n")
        .replace("-mat 3 -dir 1\n", "-mat 1 2 -dir 1 1\nparameter 1 element 1 material 2 E\n")
        .replace("{ if {[analyze 1]", "{ if {$i == 1} { updateParameter 1 $k }; if {[analyze 1]")
        .replace("pset Fy 9.0", "pset Fy 11.0");
    assert!(updated.contains("updateParameter 1 $k") && updated.contains("material 2 E"), "{updated}");
    fs::write(dir.join("model.tcl"), updated).unwrap();
    let study = fs::read_to_string(dir.join("study.toml")).unwrap();
    fs::write(dir.join("study.toml"), study.replace("lower = 4.0\nupper = 25.0", "lower = 10.9\nupper = 11.1"))
        .unwrap();
    let d = diagnosed(&dir, &[]);
    let o = &d.outcome;
    assert_eq!(o.verdict.cause, "friction", "{:?}", o.verdict);
    assert!((o.corrected.parameters["k"] - 260.0).abs() < 10.0, "{:?}", o.corrected.parameters);
    let (before, after) = (o.baseline.holdout_nmse.unwrap(), o.corrected.holdout_nmse.unwrap());
    assert!(after < 0.2 * before, "{before} {after}");
    runs_by_itself(&dir, &d);
    let _ = fs::remove_dir_all(dir);
}
