//! Incremental analyses, stripes and the multimode method on studies small enough to be calculated by hand.

#![allow(clippy::unwrap_used)]

use hysteron_design::fragility::Observation;
use hysteron_design::incremental::{Ending, Trace, hunt, intensities, report, stripe, summary};
use hysteron_design::isolate::{Job, Study, is_current, jobs, load, run_job, script_text};
use hysteron_design::multimode::{respond, respond_at_bounds};
use hysteron_design::{isolate, lateral_force::System};
use std::f64::consts::{PI, TAU};
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// A mass of 100 t on one bearing, in a plane. Beyond `limit` no step converges.
const SCRIPT: &str = r#"
model BasicBuilder -ndm 2 -ndf 3
if {![info exists isolate(ax)]} { error "the study sets no motion" }
source [file join [file dirname [info script]] limit.tcl]
node 1 0.0 0.0
node 2 0.0 0.3
fix 1 1 1 1
fix 2 0 0 1
mass 2 100.0 100.0 0.0
uniaxialMaterial Elastic 1 1.0e6
uniaxialMaterial Elastic 2 1.0e3
element elastomericBearingBoucWen 1 1 2 [expr {4000.0*$isolate(K,B)}] [expr {50.0*$isolate(Q,B)}] 0.1 0.0 1.0 1.0 0.5 0.5 \
    -P 1 -Mz 2 -orient 0 1 0 -1 0 0
timeSeries Linear 1
pattern Plain 1 1 { load 2 0.0 -981.0 0.0 }
constraints Plain
numberer Plain
system ProfileSPD
test NormDispIncr 1e-10 30
algorithm Newton
integrator LoadControl 1.0
analysis Static
analyze 1
loadConst -time 0.0
wipeAnalysis
timeSeries Path 2 -dt $isolate(dt) -values $isolate(ax)
pattern UniformExcitation 2 1 -accel 2
constraints Plain
numberer Plain
system ProfileSPD
test NormDispIncr 1e-10 30
algorithm Newton
integrator Newmark 0.5 0.25
analysis Transient
for {set i 0} {$i < $isolate(points)} {incr i} {
    if {abs([nodeDisp 2 1]) > $limit} { test NormDispIncr 1e-300 2 }
    if {[analyze 1 $isolate(dt)] != 0} { error "stopped" }
}
"#;

const STUDY: &str = r#"
script = "model.tcl"
gravity = 9.81
units = ["kN", "m"]
target = ["asce7", "sms=1.0", "sm1=0.5", "tl=8"]
floor = [{ node = 2, weight = 981.0 }]
fragility_bounds = ["lower"]
[[bearing]]
name = "B"
tags = [1]
q_d = 50.0
k_d = 400.0
yield_displacement = 0.0138889
lower = { test = [0.8, 0.9] }
[[motion]]
name = "one"
files = ["one.csv"]
[[motion]]
name = "two"
files = ["two.csv"]
[intensity]
measure = "pga"
[ida]
first = 0.1
step = 0.1
highest = 1.5
runs = 12
resolution = 0.05
[stripes]
levels = [0.1, 0.3]
[collapse]
displacement = COLLAPSE
[[limit_state]]
name = "D"
quantity = "displacement"
limit = 0.2
[[limit_state]]
name = "collapse"
quantity = "collapse"
"#;

/// A folder with the study, which is removed in the end.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str, limit: &str, collapse: &str) -> Self {
        let path = std::env::temp_dir().join(format!("hysteron-performance-{name}-{}", std::process::id()));
        fs::create_dir_all(&path).unwrap();
        fs::write(path.join("model.tcl"), SCRIPT).unwrap();
        fs::write(path.join("limit.tcl"), format!("set limit {limit}\n")).unwrap();
        fs::write(path.join("study.toml"), STUDY.replace("COLLAPSE", collapse)).unwrap();
        for (file, period) in [("one.csv", 1.8f64), ("two.csv", 1.1)] {
            let mut text = "time[s],a[g]\n".to_owned();
            for i in 0..300 {
                let t = 0.02 * f64::from(i);
                text += &format!("{t:.2},{:.9}\n", 0.2 * (TAU * t / period).sin() * (PI * t / 6.0).sin());
            }
            fs::write(path.join(file), text).unwrap();
        }
        Self(path)
    }

    fn study(&self) -> Study {
        load(&self.0.join("study.toml"), &Arc::default(), &mut Default::default()).unwrap()
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

fn made(study: &Study, job: &Job) -> isolate::JobOutcome {
    run_job(study, job, &Arc::new(AtomicBool::new(false)))
}

fn hunted(study: &Study, motion: usize) -> Trace {
    let level = intensities(study).unwrap()[motion];
    let points = hunt(study, "lower", motion, level, &|job| Ok(made(study, job))).unwrap();
    Trace { bound: "lower", motion, points }
}

#[test]
fn capacities_are_those_of_an_analysis_at_their_level() {
    let folder = Folder::new("capacity", "1e9", "0.6");
    let study = folder.study();
    let traces: Vec<Trace> = (0..2).map(|m| hunted(&study, m)).collect();
    for t in &traces {
        assert_eq!(t.points.len(), 12);
        let Some(Observation::Exact(capacity)) = t.capacity(0, 0.2) else { panic!("{t:?}") };
        // The same motion at this level moves the bearing by the limit.
        let level = capacity / intensities(&study).unwrap()[t.motion];
        let o = made(&study, &Job { bound: "lower", motion: t.motion, eccentricity: 0, level, draw: None });
        assert!((o.bearings[0].displacement / 0.2 - 1.0).abs() < 0.02, "{capacity}: {}", o.bearings[0].displacement);
    }
    // The first motion is nearer to resonance.
    let s = summary(&study, traces, intensities(&study).unwrap(), false);
    let fit = s.fits[0].fit.clone().unwrap();
    let x: Vec<f64> = s.fits[0].observed.iter().map(|p| p.0).collect();
    assert!((fit.median / (x[0] * x[1]).sqrt() - 1.0).abs() < 1e-9, "{fit:?} {x:?}");
    let page = report::html(&study, &s);
    assert!(page.contains("Fragility functions") && page.contains("<svg") && page.contains("PGA [g]"));
    assert!(report::json(&study, &s).contains("\"limit state\": \"D\""));
}

#[test]
fn loss_of_convergence_is_told_from_collapse() {
    // No step converges beyond 0.15 m, below the limit state and far below collapse.
    let folder = Folder::new("open", "0.15", "0.6");
    let study = folder.study();
    let t = hunted(&study, 0);
    let open: Vec<_> = t.points.iter().filter(|p| p.ending == Ending::Unresolved).collect();
    assert!(
        !open.is_empty() && open.iter().all(|p| p.reached == [None, None] && p.failure.contains("analysis failed"))
    );
    assert!(matches!(t.capacity(0, 0.2), Some(Observation::Above(_))));
    // The same where the limit of collapse is passed before: collapse, and all limit states are reached.
    let folder = Folder::new("collapse", "0.15", "0.14");
    let study = folder.study();
    let t = hunted(&study, 0);
    let last = t.points.last().unwrap();
    assert!(last.ending == Ending::Collapsed && last.reached == [Some(true), Some(true)]);
    assert!(t.points.iter().all(|p| p.ending != Ending::Unresolved));
    assert!(matches!(t.capacity(1, 0.0), Some(Observation::Between(..))));
    // An analysis that failed was tried again with shorter steps.
    let o = made(&study, &Job { bound: "lower", motion: 0, eccentricity: 0, level: 5.0, draw: None });
    assert!(o.retried && o.failure.starts_with("the analysis failed") && o.time > 0.0);
}

#[test]
fn stripes_count_what_is_reached() {
    let folder = Folder::new("stripes", "1e9", "0.6");
    let study = folder.study();
    let scales = intensities(&study).unwrap();
    let trace = |motion: usize| {
        let of =
            |level: f64| stripe(&study, "lower", motion, (level, scales[motion]), &|j| Ok(made(&study, j))).unwrap();
        Trace { bound: "lower", motion, points: vec![of(0.1), of(0.3)] }
    };
    let s = summary(&study, vec![trace(0), trace(1)], scales.clone(), true);
    let reached = |m: usize, k: usize| s.traces[m].points[k].demands[0] > 0.2;
    let share = |k: usize| (f64::from(u8::from(reached(0, k))) + f64::from(u8::from(reached(1, k)))) / 2.0;
    assert_eq!(s.fits[0].observed, [(0.1, share(0)), (0.3, share(1))]);
    let collapsed = s.traces.iter().flat_map(|t| &t.points).filter(|p| p.demands[0] > 0.6).count();
    assert_eq!(s.fits[1].counts, [collapsed, 4 - collapsed, 0]);
}

#[test]
fn a_changed_file_makes_its_results_outdated() {
    let folder = Folder::new("files", "1e9", "0.6");
    let study = folder.study();
    let o = made(&study, &jobs(&study)[0]);
    assert!(o.inputs.iter().any(|(path, _)| path.ends_with("limit.tcl")) && is_current(&o.inputs), "{:?}", o.inputs);
    fs::write(folder.0.join("limit.tcl"), "set limit 2e9\n").unwrap();
    assert!(!is_current(&o.inputs));
    // Limits change no analysis; properties of bearings do.
    let changed = |from: &str, to: &str| {
        fs::write(folder.0.join("study.toml"), STUDY.replace("COLLAPSE", "0.6").replace(from, to)).unwrap();
        folder.study().fingerprint != study.fingerprint
    };
    assert!(!changed("limit = 0.2", "limit = 0.3") && changed("q_d = 50.0", "q_d = 51.0"));
}

/// One mass: the multimode method is the equivalent lateral force procedure.
#[test]
fn multimode_of_one_mass_is_the_equivalent_lateral_force_procedure() {
    let folder = Folder::new("modes", "1e9", "0.6");
    let study = folder.study();
    for (r, (fq, fk)) in respond_at_bounds(&study, 5).unwrap().iter().zip([(0.8, 0.9), (1.0, 1.0), (1.0, 1.0)]) {
        let system = System {
            q_d: fq * 50.0,
            k_d: fk * 400.0,
            yield_displacement: 0.0138889,
            weight: 981.0,
            weight_above: 0.0,
            gravity: 9.81,
            abrupt: false,
        };
        let elf = system.procedure(|t| study.meter() * study.target.at(t), &study.code).unwrap();
        let d = &r.directions[0];
        assert!((d.displacements[0] / elf.displacement - 1.0).abs() < 1e-6, "{} {elf:?}", d.displacements[0]);
        assert!(
            (d.modes[0].period / elf.period - 1.0).abs() < 1e-6
                && (d.modes[0].damping / elf.damping - 1.0).abs() < 1e-6
        );
        for c in &d.combined {
            assert!((c.base_shear / elf.shear_below - 1.0).abs() < 1e-6, "{c:?}");
        }
        // The pseudo-acceleration of the mass is the shear over the weight.
        assert!((d.combined[0].accelerations[0] / (elf.shear_below / 981.0) - 1.0).abs() < 1e-6);
    }
}

/// The shipped building: two modes of a rigid-jointed stick carry it, and the displacement is near that of one mass.
#[test]
fn multimode_of_the_shipped_building_keeps_its_mass() {
    let root = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."));
    let study =
        load(&root.join("tcl-like-inputs/isolation_study/study.toml"), &Arc::default(), &mut Default::default())
            .unwrap();
    let r = respond(&study, "nominal", 12).unwrap();
    for d in &r.directions {
        assert!((d.modes.iter().map(|m| m.mass).sum::<f64>() - 1.0).abs() < 1e-6);
        // Shear from K_eff of nine bearings in the isolated modes, less than their sum of largest forces.
        let all = 9.0 * d.stiffnesses[0] * d.displacements[0];
        assert!(d.combined[0].base_shear <= all && d.combined[0].base_shear > 0.98 * all);
    }
    let [x, y] = [0, 1].map(|k: usize| r.directions[k].displacements[0]);
    assert!((x / y - 1.0).abs() < 1e-6, "a square plan: {x} {y}");
    assert!((r.displacements[0] / (x * 1.0f64.hypot(0.3)) - 1.0).abs() < 1e-3);
}

#[test]
fn larger_examples_run_and_their_scripts_are_complete() {
    let root = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."));
    for name in ["eight_storey_study", "bridge_study"] {
        let mut study =
            load(&root.join(format!("tcl-like-inputs/{name}/study.toml")), &Arc::default(), &mut Default::default())
                .unwrap();
        study.motions.truncate(1);
        for m in &mut study.motions[0].components {
            m.acceleration.truncate(700);
        }
        let job = Job { bound: "upper", motion: 0, eccentricity: 0, level: 1.0, draw: None };
        let o = made(&study, &job);
        assert!(o.failure.is_empty() && !o.contact.is_empty(), "{name}: {}", o.failure);
        assert!(o.bearings.iter().all(|b| b.displacement > 0.01 && b.gravity > 100.0 && b.place.len() + 1 >= 2));
        let text = script_text(&study, &job);
        assert!(text.contains("set {isolate(K,") && text.trim_end().ends_with(".tcl}"));
    }
}
