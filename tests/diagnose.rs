//! Diagnosis: an effect that was concealed is found, none is found where there is none, and a library without the cause
//! does not name another with certainty.

#![cfg(unix)]
#![allow(clippy::unwrap_used, unreachable_pub)]

#[path = "diagnose/changed_in_time.rs"]
mod changed_in_time;
#[path = "diagnose/own_options.rs"]
mod own_options;
#[path = "diagnose/preflight.rs"]
mod preflight;
#[path = "support/studies.rs"]
mod studies;
#[path = "diagnose/whole_laws.rs"]
mod whole_laws;

use hysteron::diagnose::{CheckpointEntry, Diagnosis, Settings};
use hysteron::study::standalone_script;
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use studies::{CheckpointRecorder, Noise, PAD, SHAKEN};

const DT: f64 = 0.02;

/// Force of an elastic-plastic spring beside an elastic one along a path, by its own formula.
fn pad(path: &[f64]) -> Vec<f64> {
    let (fy, k0, k, mut plastic) = (11.0, 2000.0, 260.0, 0.0f64);
    let force = |u: &f64| {
        let trial = k0 * (u - plastic);
        let f = trial.clamp(-fy, fy);
        plastic = u - f / k0;
        f + k * u
    };
    path.iter().map(force).collect()
}

/// A study of two runs, with what the channel shows of the path and the pad's force.
fn concealed(name: &str, shows: impl Fn(&[f64], &[f64]) -> Vec<f64>) -> PathBuf {
    recorded(name, shows, [f64::NEG_INFINITY, f64::INFINITY])
}

/// The same, of a channel that shows nothing beyond two levels, its noise neither.
fn recorded(name: &str, shows: impl Fn(&[f64], &[f64]) -> Vec<f64>, [low, high]: [f64; 2]) -> PathBuf {
    let dir = std::env::temp_dir().join(format!("hysteron-diagnose-{name}-{}", std::process::id()));
    fs::create_dir_all(&dir).unwrap();
    fs::write(dir.join("model.tcl"), PAD).unwrap();
    let mut study = "model = \"model.tcl\"\n[[parameter]]\nname = \"Fy\"\nlower = 4.0\nupper = 25.0\n\
                     [[parameter]]\nname = \"k\"\nlower = 100.0\nupper = 600.0\n"
        .to_owned();
    let growing = |t: f64| 0.006 * t * (4.0 * t).sin();
    let mixed = |t: f64| 0.03 * (2.5 * t).sin() + 0.02 * (7.0 * t).sin();
    let mut noise = Noise::default();
    for (run, role, motion) in [("growing", "fit", &growing as &dyn Fn(f64) -> f64), ("mixed", "holdout", &mixed)] {
        let path: Vec<f64> = (0..400).map(|i| motion(DT * f64::from(i))).collect();
        let force = shows(&path, &pad(&path));
        let mut table = "time[s],force[kN]\n".to_owned();
        for (i, f) in force.iter().enumerate() {
            writeln!(table, "{},{}", DT * i as f64, (f + 0.3 * noise.next()).clamp(low, high)).unwrap();
        }
        fs::write(dir.join(format!("{run}.csv")), table).unwrap();
        let text: String = path.iter().map(|u| format!("{u}\n")).collect();
        fs::write(dir.join(format!("{run}.dat")), text).unwrap();
        write!(
            study,
            "[[run]]\nname = \"{run}\"\nrole = \"{role}\"\nrecording = \"{run}.csv\"\n\
             set = {{ motion = \"{run}.dat\", dt = {DT}, npts = 400 }}\n\
             [[run.observe]]\nchannel = \"force\"\noutput = \"force.out\"\ncolumn = 2\nat = \"pad\"\n"
        )
        .unwrap();
    }
    fs::write(dir.join("study.toml"), study).unwrap();
    dir
}

fn attempt(
    dir: &Path,
    without: &[&str],
    checkpoint: Vec<CheckpointEntry>,
    recorder: &mut CheckpointRecorder,
) -> Result<Diagnosis, String> {
    let excluded_causes = without.iter().map(|w| (*w).to_owned()).collect();
    studies::attempt(dir, &Settings { excluded_causes, threads: 2, checkpoint, ..Settings::default() }, recorder)
}

fn diagnosed(dir: &Path, without: &[&str]) -> Diagnosis {
    attempt(dir, without, vec![], &mut CheckpointRecorder::unlimited()).unwrap()
}

/// Run the repaired script by itself, as another script that sets the variables of a run and sources it.
fn runs_by_itself(dir: &Path, d: &Diagnosis) {
    fs::write(dir.join("corrected.tcl"), &d.repaired_script).unwrap();
    let around = format!("set motion growing.dat\nset dt {DT}\nset npts 400\nsource corrected.tcl\n");
    fs::write(dir.join("around.tcl"), around).unwrap();
    let done = std::process::Command::new(env!("CARGO_BIN_EXE_hysteron"))
        .args(["run", "around.tcl"])
        .current_dir(dir)
        .output()
        .unwrap();
    assert!(done.status.success(), "{}\n{}", String::from_utf8_lossy(&done.stderr), d.repaired_script);
    let force = fs::read_to_string(dir.join("force.out")).unwrap();
    assert_eq!(force.lines().count(), 399);

    // Its head finds the motion from the folder of the results, and sets the variables of the first fitted run.
    let results = dir.join("results");
    fs::create_dir_all(&results).unwrap();
    let simulator = studies::opened(dir).0;
    let mut scripts = vec![("corrected.tcl", Some(&d.repaired_script))];
    scripts.push(("corrected_opensees.tcl", d.opensees_script.as_ref()));
    for (name, text) in scripts.into_iter().filter_map(|(name, text)| Some((name, text?))) {
        fs::write(results.join(name), standalone_script(&simulator, &results, text)).unwrap();
        let done = std::process::Command::new(env!("CARGO_BIN_EXE_hysteron"))
            .args(["run", name])
            .current_dir(&results)
            .output()
            .unwrap();
        assert!(done.status.success(), "{name}: {}", String::from_utf8_lossy(&done.stderr));
        assert_eq!(fs::read_to_string(results.join("force.out")).unwrap().lines().count(), 399);
        fs::remove_file(results.join("force.out")).unwrap();
    }
}

/// The command prints its result, and says on standard error how far it is and what it replaces.
fn results_go_to_standard_output(dir: &Path) {
    fs::create_dir_all(dir.join("out")).unwrap();
    fs::write(dir.join("out/diagnosis.json"), "{\"study\": \"another pad\"}").unwrap();
    let diagnose = |option: &str| {
        let words = ["diagnose", "study.toml", "--out", "out", option];
        let done =
            std::process::Command::new(env!("CARGO_BIN_EXE_hysteron")).args(words).current_dir(dir).output().unwrap();
        let [out, err] = [done.stdout, done.stderr].map(|bytes| String::from_utf8(bytes).unwrap());
        assert!(done.status.success(), "{err}");
        (out, err)
    };
    let (out, err) = diagnose("--json");
    assert_eq!(out, fs::read_to_string(dir.join("out/diagnosis.json")).unwrap());
    for line in ["1 of 7: fitting your model", "note: replaces the result of another pad in out"] {
        assert!(err.lines().any(|l| l == line), "{err}");
    }
    // The same study again, in words for readers.
    let (out, err) = diagnose("--threads=2");
    assert!(out.starts_with("Your model explains the recordings (none).\n\nHow sure  "), "{out}");
    assert!(out.lines().all(|l| l.chars().count() <= 80) && !out.contains("log evidence"), "{out}");
    assert!(!err.contains("note: replaces"), "{err}");
}

#[test]
fn nothing_is_found_where_nothing_is_missing() {
    let dir = concealed("none", |_, f| f.to_vec());
    let d = diagnosed(&dir, &[]);
    assert_eq!(d.outcome.verdict.cause, "none", "{:?}", d.outcome.verdict);
    assert!(d.outcome.verdict.confidence > 0.5);
    let summary = &d.outcome.verdict.summary;
    assert_eq!(summary.what, "Your model explains the recordings (none).");
    assert!(summary.what_next.is_empty() && summary.location.is_empty(), "{}", summary.text(80));
    runs_by_itself(&dir, &d);
    results_go_to_standard_output(&dir);

    // Interrupted, saved and resumed: the same to the last digit with fewer evaluations.
    let mut recorder = CheckpointRecorder { entries: vec![], max_entries: 30 };
    assert_eq!(attempt(&dir, &[], vec![], &mut recorder).err().unwrap(), "interrupted");
    let entries: Vec<CheckpointEntry> =
        serde_json::from_str(&serde_json::to_string(&recorder.entries).unwrap()).unwrap();
    let again = attempt(&dir, &[], entries, &mut CheckpointRecorder::unlimited()).unwrap();
    assert_eq!(serde_json::to_string(&again.outcome).unwrap(), serde_json::to_string(&d.outcome).unwrap());
    assert!(again.evaluations < d.evaluations, "{} {}", again.evaluations, d.evaluations);

    // Results of other jobs are not used.
    let mut others = serde_json::to_value(&recorder.entries).unwrap();
    others.as_array_mut().unwrap().iter_mut().skip(3).for_each(|k| k["job"] = 1.into());
    let others: Vec<CheckpointEntry> = serde_json::from_value(others).unwrap();
    let again = attempt(&dir, &[], others, &mut CheckpointRecorder::unlimited()).unwrap();
    assert_eq!(serde_json::to_string(&again.outcome).unwrap(), serde_json::to_string(&d.outcome).unwrap());
    let _ = fs::remove_dir_all(dir);
}

#[test]
fn a_stop_is_found_and_what_it_explains_is_not_explained_without_it() {
    let stop = |u: &[f64], f: &[f64]| -> Vec<f64> {
        u.iter().zip(f).map(|(u, f)| f + 4000.0 * u.signum() * (u.abs() - 0.03).max(0.0)).collect()
    };
    let dir = concealed("gap", stop);
    let d = diagnosed(&dir, &[]);
    let o = &d.outcome;
    assert!(["gap_impact", "strain_stiffening"].contains(&o.verdict.cause.as_str()), "{:?}", o.verdict);
    let sum: f64 = o.verdict.also_possible.iter().map(|c| c.confidence).sum::<f64>() + o.verdict.confidence;
    assert!((0.95..=1.0 + 1e-9).contains(&sum));
    let (before, after) = (o.baseline.holdout_nmse.unwrap(), o.corrected.holdout_nmse.unwrap());
    assert!(after < 0.1 * before, "{before} {after}");
    let summary = &o.verdict.summary;
    assert!(summary.what.contains(&format!("({})", o.verdict.cause)), "{}", summary.what);
    assert_eq!((&summary.places[0].elements[..], summary.places[0].level.as_str()), (&[1][..], "at the base"));
    let text = summary.text(80);
    assert!(text.lines().count() <= 24 && text.lines().all(|l| l.chars().count() <= 80), "{text}");
    if let Some(gap) = summary.sizes.iter().find(|s| s.name == "hy_gap") {
        let [lower, upper] = gap.interval.unwrap();
        assert!(lower < 0.0301 && upper > 0.0299 && upper - lower < 0.002, "{gap:?}");
        // The channel has a unit of force, and nothing tells that of length.
        assert!(gap.text.starts_with("gap 0.0") && gap.text.ends_with(" in the script's units"), "{gap:?}");
    }
    assert!(o.mismatch[0].regime.contains("large deformation") || o.mismatch[0].regime.contains("first time"));
    assert!(d.repaired_script.contains("amend element 1 "), "{}", d.repaired_script);
    runs_by_itself(&dir, &d);

    // The test that tells it from its rival is there to be run, within the stroke of the tests before.
    let t = d.next_test.as_ref().expect("a next test");
    assert!((0.5..=1.0).contains(&t.power) && o.next_test.contains("expected power"), "{}", o.next_test);
    fs::write(dir.join("next_test.tcl"), &t.script).unwrap();
    for (name, motion) in &t.motions {
        fs::write(dir.join(name), motion).unwrap();
        assert!(motion.lines().all(|l| l.parse::<f64>().unwrap().abs() < 0.05 * 1.001));
    }
    fs::remove_file(dir.join("force.out")).unwrap();
    let done = std::process::Command::new(env!("CARGO_BIN_EXE_hysteron"))
        .args(["run", "next_test.tcl"])
        .current_dir(&dir)
        .output()
        .unwrap();
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    assert!(fs::read_to_string(dir.join("force.out")).unwrap().lines().count() + 1 >= t.motions[0].1.lines().count());
    let _ = fs::remove_dir_all(dir);
}

#[test]
fn a_late_channel_is_told_from_physics() {
    let late = |_: &[f64], f: &[f64]| (0..f.len()).map(|i| f[i.saturating_sub(3)]).collect();
    let dir = concealed("lag", late);
    let d = diagnosed(&dir, &[]);
    assert_eq!(d.outcome.verdict.cause, "sensor_lag", "{:?}", d.outcome.verdict);
    let lag = d.outcome.corrected.channels[0].lag_s;
    assert!((lag - 3.0 * DT).abs() < 0.2 * DT, "{lag}");
    let what = &d.outcome.verdict.summary.what;
    assert!(what.starts_with("The channel force is late by ") && what.ends_with(" ms earlier (sensor_lag)."), "{what}");
    // The script needs no repair, and so keeps its text but for the parameters.
    assert!(!d.repaired_script.contains("amend"));
    let _ = fs::remove_dir_all(dir);
}

/// Of the loops so little is cut off that the misfit hardly tells it; on both sides, and on one.
#[test]
fn a_channel_that_stays_at_its_ends_is_seen() {
    for low in [-19.5, f64::NEG_INFINITY] {
        let dir = recorded("saturates", |_, f| f.to_vec(), [low, 19.5]);
        let d = diagnosed(&dir, &[]);
        assert_eq!(d.outcome.verdict.cause, "sensor_clipping", "{:?}", d.outcome.verdict);
        let clip = d.outcome.corrected.channels[0].clip;
        assert!(clip.is_some_and(|[_, high]| (high - 19.5).abs() < 0.5), "{clip:?}");
        assert!(
            clip.is_some_and(|[l, _]| if low.is_finite() { (l - low).abs() < 0.5 } else { l < -100.0 }),
            "{clip:?}"
        );
        let _ = fs::remove_dir_all(dir);
    }
}

#[test]
fn overturning_makes_loops_larger_on_one_side() {
    // The plastic part is the larger the farther the pad is to one side.
    let larger = |u: &[f64], f: &[f64]| u.iter().zip(f).map(|(u, f)| f + (f - 260.0 * u) * 10.0 * u).collect();
    let dir = concealed("overturning", larger);
    let study = fs::read_to_string(dir.join("study.toml")).unwrap();
    fs::write(dir.join("study.toml"), study.replace("npts = 400", "npts = 400, axial = -150.0")).unwrap();
    let o = diagnosed(&dir, &[]).outcome;
    assert_eq!(o.verdict.cause, "varying_axial_load", "{:?}", o.verdict);
    let lever = o.corrected.parameters["hy_lever"];
    assert!((lever / 1500.0 - 1.0).abs() < 0.1, "{lever}");
    assert!(o.corrected.holdout_nmse.unwrap() < 0.2 * o.baseline.holdout_nmse.unwrap(), "{o:?}");
    let _ = fs::remove_dir_all(dir);
}

/// Step of the script under earthquakes.
const STEP: f64 = 0.01;

/// The motion of that mass in steps of a fiftieth of the script's, under an acceleration given at the script's.
fn shaken(ground: &[f64], dt: f64) -> Vec<f64> {
    let (k, uy, parts) = (380.0, 0.018, 50);
    let h = dt / f64::from(parts);
    let (mut x, mut out) = ([0.0; 3], vec![0.0]);
    for pair in ground.windows(2) {
        for i in 0..parts {
            // z' = v (1 - (1 + sign(v z)) |z| / 2): Bouc and Wen's with an exponent of one.
            let rate = |x: [f64; 3], t: f64| {
                let [u, v, z] = x;
                let a = pair[0] + (pair[1] - pair[0]) * t;
                [v, -a - 0.6 * k * u - 0.4 * k * uy * z, v / uy * (1.0 - 0.5 * z.abs() * (1.0 + (v * z).signum()))]
            };
            let go = |x: [f64; 3], d: [f64; 3], h: f64| -> [f64; 3] { std::array::from_fn(|i| x[i] + h * d[i]) };
            let at = |part: f64| (f64::from(i) + part) / f64::from(parts);
            // Runge's and Kutta's method.
            let a = rate(x, at(0.0));
            let b = rate(go(x, a, 0.5 * h), at(0.5));
            let c = rate(go(x, b, 0.5 * h), at(0.5));
            let d = rate(go(x, c, h), at(1.0));
            x = std::array::from_fn(|i| x[i] + h / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]));
        }
        out.push(x[0]);
    }
    out
}

/// A study of two earthquakes, with what the mass does under each as the channel, and noise of 3 %.
fn shaken_study(
    name: &str,
    model: &str,
    parameters: [(&str, f64, f64); 2],
    moves: impl Fn(&[f64]) -> Vec<f64>,
) -> PathBuf {
    let dir = std::env::temp_dir().join(format!("hysteron-diagnose-{name}-{}", std::process::id()));
    fs::create_dir_all(&dir).unwrap();
    fs::write(dir.join("model.tcl"), model).unwrap();
    let n = 700;
    let mut study = "model = \"model.tcl\"\n".to_owned();
    for (parameter, lower, upper) in parameters {
        write!(study, "[[parameter]]\nname = \"{parameter}\"\nlower = {lower:?}\nupper = {upper:?}\n").unwrap();
    }
    let mut noise = Noise::default();
    for (run, role, tones) in [("first", "fit", [6.0, 11.0, 17.0]), ("second", "holdout", [5.0, 13.0, 19.0])] {
        let at = |t: f64| tones.iter().map(|w| 2.0 * (w * t + w * w).sin()).sum::<f64>() * (-0.1 * t).exp();
        let ground: Vec<f64> = (0..n).map(|i| at(STEP * f64::from(i))).collect();
        let disp = moves(&ground);
        let size = (disp.iter().map(|u| u * u).sum::<f64>() / disp.len() as f64).sqrt();
        let mut table = "time[s],disp[m]\n".to_owned();
        for (i, u) in disp.iter().enumerate() {
            writeln!(table, "{},{}", STEP * i as f64, u + 0.03 * size * noise.next()).unwrap();
        }
        fs::write(dir.join(format!("{run}.csv")), table).unwrap();
        fs::write(dir.join(format!("{run}.dat")), ground.iter().map(|a| format!("{a}\n")).collect::<String>()).unwrap();
        write!(
            study,
            "[[run]]\nname = \"{run}\"\nrole = \"{role}\"\nrecording = \"{run}.csv\"\n\
             set = {{ motion = \"{run}.dat\", dt = {STEP}, npts = {n} }}\n\
             [[run.observe]]\nchannel = \"disp\"\noutput = \"disp.out\"\ncolumn = 1\nat = \"mass\"\n"
        )
        .unwrap();
    }
    fs::write(dir.join("study.toml"), study).unwrap();
    dir
}

#[test]
fn the_error_of_long_steps_is_no_physics() {
    let parameters = [("k", 200.0, 800.0), ("uy", 0.005, 0.08)];
    let dir = shaken_study("steps", SHAKEN, parameters, |ground| shaken(ground, STEP));
    let d = diagnosed(&dir, &[]);
    let o = &d.outcome;
    // The steps leave as much as the noise, which is 9e-4, and no cause.
    assert!(o.baseline.fit_nmse > 1.5e-3, "{}", o.baseline.fit_nmse);
    assert_eq!(o.verdict.cause, "none", "{:?}", o.verdict);
    assert!(o.verdict.explanation.contains("the causes were weighed with steps in"), "{}", o.verdict.explanation);
    let _ = fs::remove_dir_all(dir);
}

/// A mass on an elastic spring and a dashpot.
const ELASTIC: &str = "wipe\nmodel basic -ndm 1 -ndf 1\npset k 250.0\npset c 1.0\nnode 1 0.\nnode 2 0. -mass 1.0\nfix 1 1\n\
    uniaxialMaterial Elastic 1 $k\nuniaxialMaterial Viscous 2 $c 1.0\nelement zeroLength 1 1 2 -mat 1 2 -dir 1 1\n\
    timeSeries Path 1 -dt $dt -filePath $motion\npattern UniformExcitation 1 1 -accel 1\n\
    recorder Node -file disp.out -time -node 2 -dof 1 disp\n\
    constraints Plain\nsystem FullGeneral\ntest NormDispIncr 1e-10 30\nalgorithm Newton\nintegrator Newmark 0.5 0.25\n\
    analysis Transient\nfor {set i 1} {$i < $npts} {incr i} { if {[analyze 1 $dt] != 0} { error \"no convergence\" } }\n";

/// The motion of that mass on a spring that yields at a force, in steps of a two hundredth of the script's.
fn yielded(ground: &[f64], strength: f64) -> Vec<f64> {
    let (k, c, b, parts) = (300.0, 1.5, 0.05, 200);
    let h = STEP / f64::from(parts);
    let (mut u, mut v, mut plastic, mut out) = (0.0, 0.0, 0.0f64, vec![0.0]);
    for pair in ground.windows(2) {
        for i in 0..parts {
            let a = pair[0] + (pair[1] - pair[0]) * f64::from(i) / f64::from(parts);
            let q = ((1.0 - b) * k * (u - plastic)).clamp(-(1.0 - b) * strength, (1.0 - b) * strength);
            plastic = u - q / ((1.0 - b) * k);
            v -= h * (a + q + b * k * u + c * v);
            u += h * v;
        }
        out.push(u);
    }
    out
}

#[test]
fn what_yields_a_little_is_found_just_below_the_largest_force() {
    let largest = |ground: &[f64]| 300.0 * yielded(ground, 1e9).iter().fold(0.0f64, |m, u| m.max(u.abs()));
    let moves = |ground: &[f64]| yielded(ground, 0.85 * largest(ground));
    let dir = shaken_study("yielding", ELASTIC, [("k", 150.0, 600.0), ("c", 0.2, 6.0)], moves);
    let d = diagnosed(&dir, &[]);
    let o = &d.outcome;
    assert_eq!(o.verdict.cause, "superstructure_yielding", "{:?}", o.verdict);
    // Nobody orders a stronger earthquake.
    assert!(
        !o.next_test.contains("times as large") && d.next_test.iter().all(|t| t.script.is_empty()),
        "{}",
        o.next_test
    );
    let next = o.verdict.summary.what_next.join("; ");
    assert!(next.contains("inspect element 1 for cracks"), "{next}");
    assert!(o.corrected.fit_nmse < 2e-3 && o.baseline.fit_nmse > 5e-3, "{o:?}");
    let _ = fs::remove_dir_all(dir);
}

/// The motion of that mass on an elastic spring with a dashpot and another one of a power of speed: coefficients and power.
fn damped(ground: &[f64], [c, beside, power]: [f64; 3]) -> Vec<f64> {
    let (parts, mut u, mut v, mut out) = (200, 0.0, 0.0f64, vec![0.0]);
    let h = STEP / f64::from(parts);
    for pair in ground.windows(2) {
        for i in 0..parts {
            let a = pair[0] + (pair[1] - pair[0]) * f64::from(i) / f64::from(parts);
            v -= h * (a + 300.0 * u + c * v + beside * v.signum() * v.abs().powf(power));
            u += h * v;
        }
        out.push(u);
    }
    out
}

#[test]
fn what_an_elastic_structure_loses_is_damping_whatever_the_power_of_speed() {
    let moves = |ground: &[f64]| damped(ground, [0.5, 12.0, 2.0]);
    let dir = shaken_study("orifices", ELASTIC, [("k", 150.0, 600.0), ("c", 0.2, 30.0)], moves);
    let o = diagnosed(&dir, &[]).outcome;
    assert_eq!(o.verdict.cause, "damping", "{:?}", o.verdict);
    assert!(o.corrected.fit_nmse < 2e-3 && o.baseline.fit_nmse > 4e-3, "{o:?}");
    let _ = fs::remove_dir_all(dir);
}

/// The same mass on the girder of a portal frame under P-Delta, whose columns are as stiff together as that spring. The weight comes
/// first, and the earthquake is not there yet when it does.
const PORTAL: &str = "wipe\nmodel basic -ndm 2 -ndf 3\npset EI 280.0\npset aM 1.0\nnode 1 0. 0.\nnode 2 4. 0.\n\
    node 3 0. 3. -mass 0.5 0.5 0.0\nnode 4 4. 3. -mass 0.5 0.5 0.0\nfix 1 1 1 1\nfix 2 1 1 1\ngeomTransf PDelta 1\n\
    element elasticBeamColumn 1 1 3 1e3 1e3 [expr $EI/1e3] 1\nelement elasticBeamColumn 2 2 4 1e3 1e3 [expr $EI/1e3] 1\n\
    element elasticBeamColumn 3 3 4 1e3 1e3 1e4 1\nrayleigh $aM 0. 0. 0.\n\
    pattern Plain 9 Linear { load 3 0. -0.1 0.\nload 4 0. -0.1 0. }\nsystem FullGeneral\nconstraints Plain\n\
    test NormDispIncr 1e-9 30\nalgorithm Newton\nintegrator LoadControl 0.5\nanalysis Static\nanalyze 2\n\
    loadConst -time 0.0\nwipeAnalysis\n\
    timeSeries Path 1 -dt $dt -filePath $motion\npattern UniformExcitation 1 1 -accel 1\n\
    recorder Node -file disp.out -time -node 3 -dof 1 disp\n\
    constraints Plain\nsystem FullGeneral\ntest NormDispIncr 1e-9 30\nalgorithm Newton\nintegrator Newmark 0.5 0.25\n\
    analysis Transient\nfor {set i 1} {$i < $npts} {incr i} { if {[analyze 1 $dt] != 0} { error \"no convergence\" } }\n";

#[test]
fn the_ground_may_move_after_the_weight_and_dampers_stand_between_floors() {
    let parameters = [("EI", 170.0, 680.0), ("aM", 0.2, 6.0)];
    let dir = shaken_study("dampers", PORTAL, parameters, |ground| damped(ground, [0.4, 3.0, 0.4]));
    let d = diagnosed(&dir, &[]);
    let o = &d.outcome;
    assert_eq!(o.verdict.cause, "damping", "{:?}", o.verdict);
    assert!(o.corrected.fit_nmse < 0.2 * o.baseline.fit_nmse, "{o:?}");
    assert!(d.ranking.iter().any(|w| w.location == "beside element 1 2"), "{:?}", d.ranking);
    let _ = fs::remove_dir_all(dir);
}

#[test]
fn a_recording_without_a_clock_tells_no_rates() {
    let faster = |u: &[f64], f: &[f64]| -> Vec<f64> {
        let speed = |i: usize| (u[i] - u[i.saturating_sub(1)]) / DT;
        (0..f.len()).map(|i| f[i] + 3.0 * speed(i)).collect()
    };
    let dir = concealed("clock", faster);
    assert_eq!(diagnosed(&dir, &[]).outcome.verdict.cause, "rate_dependence");
    // The same with the numbers of the samples for times.
    for run in ["growing", "mixed"] {
        let text = fs::read_to_string(dir.join(format!("{run}.csv"))).unwrap();
        let mut counted = String::new();
        for (i, line) in text.lines().enumerate() {
            let rest = line.split_once(',').unwrap().1;
            let _ = if i == 0 { writeln!(counted, "{line}") } else { writeln!(counted, "{},{rest}", i - 1) };
        }
        fs::write(dir.join(format!("{run}.csv")), counted).unwrap();
    }
    let study = fs::read_to_string(dir.join("study.toml")).unwrap().replace(&format!("dt = {DT}"), "dt = 1.0");
    fs::write(dir.join("study.toml"), study).unwrap();
    let verdict = diagnosed(&dir, &[]).outcome.verdict;
    assert!(verdict.explanation.contains("count samples"), "{verdict:?}");
    let named = |cause: &str| verdict.cause == cause || verdict.also_possible.iter().any(|c| c.cause == cause);
    assert!(!named("rate_dependence") && !named("self_heating"), "{verdict:?}");
    let _ = fs::remove_dir_all(dir);
}
