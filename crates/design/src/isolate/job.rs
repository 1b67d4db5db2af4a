//! One analysis of a study: the script with the values of a bound, a motion and an eccentricity.

use super::BOUNDS;
use super::capture::{Captured, Rows, StudyOutputs};
use super::inputs::{HashedFiles, InputHashes};
use super::observed::Observed;
use super::outcome::{BearingOutcome, JobOutcome, MemberOutcome};
use super::study::{BearingType, Study};
use crate::lateral_force::overlap;
use crate::spectrum::{Oscillator, logarithmic};
use hysteron_engine::analysis::{Options, RecoveryStrategy};
use hysteron_engine::model::{Pattern, PatternKind};
use hysteron_identify::measure::work;
use hysteron_opensees::run::{End, Run, Settings};
use hysteron_opensees::{Mode, Progress, Tcl};
use hysteron_tcl::diagnostic::Diagnostic;
use hysteron_tcl::{OsFiles, OverlayFiles, Silent, Value};
use std::collections::BTreeMap;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex};

/// An analysis to be made.
#[derive(Clone, Debug, PartialEq)]
pub struct Job {
    /// Name of the bound.
    pub bound: &'static str,
    /// Index of the motion.
    pub motion: usize,
    /// Index of the eccentricity.
    pub eccentricity: usize,
    /// Factor on the motion, for stripes.
    pub level: f64,
    /// Draw of the properties in place of the bound, counted from 0.
    pub draw: Option<usize>,
}

impl Job {
    /// Name for files.
    pub fn name(&self) -> String {
        let level = if self.level == 1.0 { String::new() } else { format!("_x{}", self.level) };
        format!("{}_motion{}_ecc{}{level}", self.label(), self.motion + 1, self.eccentricity + 1)
    }

    /// Name of the bound, or of the draw.
    pub fn label(&self) -> String {
        self.draw.map_or(self.bound.to_owned(), |d| format!("draw{}", d + 1))
    }
}

/// All analyses of a study.
pub fn jobs(study: &Study) -> Vec<Job> {
    let mut all = vec![];
    for bound in BOUNDS {
        for motion in 0..study.motions.len() {
            for eccentricity in 0..study.eccentricities.len() {
                all.push(Job { bound, motion, eccentricity, level: 1.0, draw: None });
            }
        }
    }
    all
}

/// Analyses of draws of the properties: each draw with one motion, in turn, and without eccentricity.
pub fn draw_jobs(study: &Study) -> Vec<Job> {
    let of = |draw: usize| Job {
        bound: "nominal",
        motion: draw % study.motions.len(),
        eccentricity: 0,
        level: 1.0,
        draw: Some(draw),
    };
    (0..study.draws.len()).map(of).collect()
}

/// Periods of floor spectra.
const FLOOR_PERIODS: usize = 30;

/// Points of a thinned history, at most.
const MAX_POINTS: usize = 1200;

/// Ends an analysis whose result is not wanted any more.
pub(super) struct StopWatch {
    pub(super) interrupt: Arc<AtomicBool>,
    pub(super) stop: Arc<AtomicBool>,
    pub(super) time: Arc<Mutex<f64>>,
}

impl Progress for StopWatch {
    fn step(&mut self, time: f64, _: Option<f64>) {
        if let Ok(mut t) = self.time.lock() {
            *t = time;
        }
        if self.stop.load(Ordering::Relaxed) {
            self.interrupt.store(true, Ordering::Relaxed);
        }
    }
}

/// Values of the array `isolate`.
fn values(study: &Study, job: &Job) -> Vec<(String, Value)> {
    let pair = &study.motions[job.motion];
    let factor = job.level * study.meter();
    let list = |k: usize| Value::list(pair.components[k].acceleration.iter().map(|a| Value::from(factor * a)));
    let [ex, ey] = study.eccentricities[job.eccentricity];
    let points = pair.components[0].acceleration.len();
    // Without a vertical component the ground rests.
    let rest = vec![0.0; points];
    let vertical = pair.vertical.as_ref().map_or(&rest, |m| &m.acceleration).iter().map(|a| Value::from(factor * a));
    let mut out = vec![
        ("bound".to_owned(), Value::from(job.bound)),
        ("ax".to_owned(), list(0)),
        ("ay".to_owned(), list(1)),
        ("az".to_owned(), Value::list(vertical)),
        ("dt".to_owned(), Value::from(pair.components[0].dt)),
        ("points".to_owned(), Value::from(points as i64)),
        ("ex".to_owned(), Value::from(ex)),
        ("ey".to_owned(), Value::from(ey)),
    ];
    for (k, b) in study.bearings.iter().enumerate() {
        for (of, letter) in ["Q", "K"].into_iter().enumerate() {
            let drawn = job.draw.map(|d| study.draws[d][k][of]);
            let factor = drawn.unwrap_or_else(|| study.factor(b, job.bound, of));
            out.push((format!("{letter},{}", b.name), Value::from(factor)));
        }
    }
    out
}

/// A script that sets the values of an analysis and goes on with the script of the study, for OpenSees itself.
pub fn script_text(study: &Study, job: &Job) -> String {
    let mut out = format!("# {}: {}, {}\n", study.title, job.name(), study.motions[job.motion].name());
    for (name, value) in values(study, job) {
        out += &format!("set {{isolate({name})}} {{{}}}\n", value.as_str());
    }
    let path = std::path::absolute(&study.script).unwrap_or_else(|_| study.script.clone());
    out + &format!("source {{{}}}\n", path.display().to_string().replace('\\', "/"))
}

/// Set the values of an analysis in the array `isolate`.
pub(super) fn set_values(interp: &mut Tcl, study: &Study, job: &Job) -> Result<(), String> {
    let set = values(study, job).into_iter().flat_map(|(name, value)| [Value::from(name), value]);
    let failed = |_| "the values of the study cannot be set".to_owned();
    interp.set_global("hysteron_values", Value::list(set)).map_err(failed)?;
    let text = "array set isolate $hysteron_values\nunset hysteron_values\n";
    interp.eval_str("isolation study", text).map(|_| ()).map_err(failed)
}

/// Reason for an analysis without a result.
pub(super) struct Failure {
    /// In words; empty where it has one.
    pub(super) text: String,
    /// The analysis did not converge.
    of_analysis: bool,
}

impl Failure {
    pub(super) fn of(end: &End, run: &Run) -> Self {
        let place = |d: &Diagnostic| match d.span {
            Some(span) => format!("{}: {}", run.interp.sources.location(span), d.message),
            None => d.message.clone(),
        };
        let other = |text: String| Self { text, of_analysis: false };
        let analysis = match end {
            End::Failed(f) | End::Ignored(f) => Some(f),
            End::Done | End::Exit(0) | End::Raised(_) => run.interp.host.last_failure.as_ref(),
            _ => None,
        };
        if let Some(failure) = analysis {
            return Self { text: format!("the analysis failed: {failure}"), of_analysis: true };
        }
        match end {
            End::Done | End::Exit(0) | End::Failed(_) | End::Ignored(_) => other(String::new()),
            End::Raised(d) => other(format!("the script raised an error: {}", place(d))),
            End::Rejected(d) => other(format!("the script was rejected: {}", place(d))),
            End::Exit(status) => other(format!("the script ended itself with status {status}")),
            End::Interrupted | End::Enough(_) => other("interrupted".into()),
        }
    }
}

/// Make an analysis. A failure is part of the outcome; `stop` interrupts it. An analysis that does not converge is made
/// once more with the strategy of recovery and half the steps.
pub fn run_job(study: &Study, job: &Job, stop: &Arc<AtomicBool>) -> JobOutcome {
    let (first, converged) = attempt(study, job, stop, Options::default());
    if converged {
        return first;
    }
    let options = Options { ladder: Some(RecoveryStrategy::default()), refine: 2, ..Options::default() };
    JobOutcome { retried: true, ..attempt(study, job, stop, options).0 }
}

/// The outcome of an attempt, and whether its analysis converged.
fn attempt(study: &Study, job: &Job, stop: &Arc<AtomicBool>, options: Options) -> (JobOutcome, bool) {
    let captured = Captured::default();
    let settings = Settings { mode: Mode::Run, strict: false, options };
    let inputs = InputHashes::default();
    let files = OverlayFiles::new(Box::new(HashedFiles::new(Box::new(OsFiles), inputs.clone())));
    let mut run = Run::new(settings, Box::new(Silent), Box::new(files), Box::new(StudyOutputs(captured.clone())));
    let time = Arc::<Mutex<f64>>::default();
    let interrupt = run.interp.interrupt.clone();
    run.interp.host.set_progress(Box::new(StopWatch { interrupt, stop: stop.clone(), time: time.clone() }));
    let mut out = JobOutcome {
        fingerprint: study.fingerprint,
        bound: job.label(),
        motion: study.motions[job.motion].components[0].name.clone(),
        eccentricity: study.eccentricities[job.eccentricity],
        ..JobOutcome::default()
    };
    if let Err(e) = set_values(&mut run.interp, study, job) {
        out.failure = e;
        return (out, true);
    }
    let observed = Observed::of(study);
    let recorders = observed.clone();
    run.interp.host.before_transient(Box::new(move |interp| recorders.add(interp)));
    let end = run.script(&study.script.to_string_lossy(), &[]);
    let failure = Failure::of(&end, &run);
    out.failure = failure.text;
    out.time = time.lock().map_or(0.0, |t| *t);
    out.inputs = inputs.hashes();
    out.damping_share = run.interp.host.isolator_damping_share();
    out.warnings = warnings(&run);
    let rows = |name: &str| -> Option<Rows> {
        let all = captured.lock().ok()?;
        let rows = all.get(name)?.lock().ok()?.clone();
        (rows.rows.len() > 1).then_some(rows)
    };
    measure_bearings(study, &rows, &mut out);
    let times = study.bearings.iter().flat_map(|b| &b.tags).find_map(|tag| Some(rows(&format!("{tag}/upper"))?.times));
    out.duration = times.and_then(|t| Some(t.last()? - t.first()?)).unwrap_or(0.0);
    for (b, place) in out.bearings.iter_mut().zip(observed.places()) {
        (b.place, b.height) = (place.horizontal, Some(place.height));
    }
    measure_floors(study, job, &shaken(&run), &rows, &mut out);
    out.members = study.members.iter().filter_map(|tag| Some(member(*tag, &rows(&format!("member{tag}"))?))).collect();
    let half = |r: &Rows| {
        r.rows.iter().map(|row| row[..row.len() / 2].iter().map(|f| f * f).sum::<f64>().sqrt()).fold(0.0, f64::max)
    };
    out.contact =
        study.contacts().map(|tag| (tag, rows(&format!("contact{tag}")).map_or(f64::NAN, |r| half(&r)))).collect();
    (out, !failure.of_analysis)
}

/// Extremes of the forces of a member.
fn member(tag: i64, rows: &Rows) -> MemberOutcome {
    let columns = (0..rows.width()).map(|i| rows.column(i));
    let extremes = |c: Vec<f64>| c.iter().fold((f64::MIN, f64::MAX), |(a, b), x| (a.max(*x), b.min(*x)));
    let (largest, least) = columns.map(extremes).unzip();
    MemberOutcome { tag, gravity: rows.rows[0].clone(), largest, least }
}

/// Element of the largest length among vectors.
fn largest_length(parts: &[Vec<f64>]) -> f64 {
    let n = parts.first().map_or(0, Vec::len);
    (0..n).map(|i| parts.iter().map(|p| p[i] * p[i]).sum::<f64>().sqrt()).fold(0.0, f64::max)
}

fn thinned(a: &[f64], b: &[f64]) -> Vec<[f64; 2]> {
    let every = a.len().div_ceil(MAX_POINTS).max(1);
    a.iter().zip(b).step_by(every).map(|(a, b)| [*a, *b]).collect()
}

fn measure_bearings(study: &Study, rows: &dyn Fn(&str) -> Option<Rows>, out: &mut JobOutcome) {
    let mut total: Vec<Vec<f64>> = vec![];
    for kind in &study.bearings {
        let first = out.bearings.len();
        for &tag in &kind.tags {
            let all = ["lower", "upper", "force"].map(|what| rows(&format!("{tag}/{what}")));
            let [Some(lower), Some(upper), Some(force)] = all else {
                if out.failure.is_empty() {
                    out.failure = format!("the bearing {tag} has no record: is there a transient analysis?");
                }
                out.bearings.push(BearingOutcome { tag, ..BearingOutcome::default() });
                continue;
            };
            let ndm = upper.width();
            let ndf = force.width() / 2;
            let relative =
                |d: usize| -> Vec<f64> { upper.column(d).iter().zip(lower.column(d)).map(|(u, l)| u - l).collect() };
            let u: Vec<Vec<f64>> = (0..ndm).map(relative).collect();
            // Forces on the upper end, as those that the nodes exert.
            let f: Vec<Vec<f64>> = (0..ndm).map(|d| force.column(ndf + d)).collect();
            let (horizontal, vertical) = (0..ndm - 1, ndm - 1);
            if total.is_empty() {
                total = vec![vec![0.0; u[0].len()]; ndm - 1];
            }
            for (sum, f) in total.iter_mut().zip(&f) {
                sum.iter_mut().zip(f).for_each(|(s, f)| *s += f);
            }
            let b = bearing(kind, tag, &u[horizontal.clone()], &f[horizontal], &u[vertical], &f[vertical]);
            out.bearings.push(b);
        }
        // Histories of the bearing of the type that moves farthest.
        let mine = &mut out.bearings[first..];
        let farthest = mine.iter().map(|b| b.displacement).fold(0.0, f64::max);
        let kept = mine.iter().position(|b| b.displacement == farthest);
        for (_, b) in mine.iter_mut().enumerate().filter(|(k, _)| Some(*k) != kept) {
            (b.hysteresis, b.orbit) = (vec![], vec![]);
        }
    }
    out.base_shear = largest_length(&total);
}

fn bearing(
    kind: &BearingType,
    tag: i64,
    u: &[Vec<f64>],
    f: &[Vec<f64>],
    rise: &[f64],
    axial: &[f64],
) -> BearingOutcome {
    let n = axial.len();
    let compression: Vec<f64> = axial.iter().map(|f| -f).collect();
    let tail = n - (n / 10).max(1);
    let rest = |u: &Vec<f64>| u[tail..].iter().sum::<f64>() / (n - tail) as f64;
    let length = |i: usize| u.iter().map(|u| u[i] * u[i]).sum::<f64>().sqrt();
    let stability = kind.critical_load.map(|critical| {
        let ratio = |i: usize| {
            let area = kind.diameter.map_or(1.0, |b| overlap(length(i), b));
            if compression[i] <= 0.0 { 0.0 } else { compression[i] / (critical * area) }
        };
        // Without any overlap there is no load that it carries; a number keeps the file readable.
        (0..n).map(ratio).fold(0.0, f64::max).min(1e9)
    });
    BearingOutcome {
        tag,
        height: None,
        place: vec![],
        displacement: (0..n).map(length).fold(0.0, f64::max),
        residual: u.iter().map(|u| rest(u).powi(2)).sum::<f64>().sqrt(),
        gravity: compression[0],
        compression: compression.iter().copied().fold(f64::MIN, f64::max),
        least: compression.iter().copied().fold(f64::MAX, f64::min),
        // A bearing in compression has not lifted, however its upper node has risen.
        uplift: rise.iter().zip(&compression).filter(|(_, p)| **p <= 0.0).map(|(r, _)| *r).fold(0.0, f64::max),
        shear: largest_length(f),
        energy: u.iter().zip(f).map(|(u, f)| work(u, f).last().copied().unwrap_or(0.0)).sum(),
        stability,
        hysteresis: thinned(&u[0], &f[0]),
        orbit: u.get(1).map_or(vec![], |second| thinned(&u[0], second)),
    }
}

/// Directions in which the model moves with its ground, so that accelerations of nodes are relative to it.
fn shaken(run: &Run) -> Vec<usize> {
    let patterns = run.interp.host.engine.model().patterns.values();
    let direction = |p: &Pattern| match &p.kind {
        PatternKind::Uniform(e) => Some(e.direction),
        _ => None,
    };
    patterns.filter_map(direction).collect()
}

/// Mean displacement of the lower ends of the bearings in a direction; none without their records.
fn below_bearings(study: &Study, rows: &dyn Fn(&str) -> Option<Rows>, direction: usize) -> Option<Vec<f64>> {
    let tags: Vec<i64> = study.bearings.iter().flat_map(|b| b.tags.iter().copied()).collect();
    let all: Option<Vec<Vec<f64>>> =
        tags.iter().map(|t| Some(rows(&format!("{t}/lower"))?.column(direction))).collect();
    let all = all?;
    Some((0..all.first()?.len()).map(|i| all.iter().map(|u| u[i]).sum::<f64>() / all.len() as f64).collect())
}

/// Warnings of the script, by place and check.
fn warnings(run: &Run) -> Vec<(String, String)> {
    let of = |d: &Diagnostic| {
        let place = d.span.map_or_else(String::new, |s| format!("{}: ", run.interp.sources.location(s)));
        (format!("{place}{}", d.code()), format!("{place}{} [{}]", d.message, d.code()))
    };
    run.interp.warnings.iter().map(of).collect::<BTreeMap<_, _>>().into_iter().collect()
}

fn measure_floors(
    study: &Study,
    job: &Job,
    shaken: &[usize],
    rows: &dyn Fn(&str) -> Option<Rows>,
    out: &mut JobOutcome,
) {
    let all: Option<Vec<(Rows, Rows)>> = study
        .floors
        .iter()
        .map(|f| Some((rows(&format!("floor{}/disp", f.node))?, rows(&format!("floor{}/accel", f.node))?)))
        .collect();
    let Some(all) = all.filter(|a| !a.is_empty()) else { return };
    let pair = &study.motions[job.motion];
    let factor = job.level * study.meter();
    let width = all[0].0.width();
    let times = &all[0].1.times;
    let start = times[0];
    // Ground accelerations at the times of the rows, which begin with the motion. Nodes on supports that move themselves have
    // absolute accelerations.
    let ground: Vec<Vec<f64>> = (0..width)
        .map(|d| {
            if !shaken.contains(&d) {
                return vec![0.0; times.len()];
            }
            let (a, dt) = (&pair.components[d].acceleration, pair.components[d].dt);
            let at = |t: &f64| {
                let x = (t - start) / dt;
                let i = x.floor().max(0.0) as usize;
                let value = |i: usize| a.get(i).copied().unwrap_or(0.0);
                factor * (value(i) + (value(i + 1) - value(i)) * (x - i as f64))
            };
            times.iter().map(at).collect()
        })
        .collect();
    let mut inertia = vec![vec![0.0; times.len()]; width];
    let step = if times.len() > 1 { (times[times.len() - 1] - start) / (times.len() - 1) as f64 } else { 0.0 };
    out.periods = logarithmic(0.05, 3.0, FLOOR_PERIODS);
    for (k, (disp, accel)) in all.iter().enumerate() {
        let absolute: Vec<Vec<f64>> =
            (0..width).map(|d| accel.column(d).iter().zip(&ground[d]).map(|(a, g)| a + g).collect()).collect();
        let top = absolute.iter().flatten().fold(0.0f64, |m, a| m.max(a.abs()));
        out.accelerations.push(top / study.gravity);
        if k == 0 {
            let largest = |d: usize| {
                let below = if shaken.contains(&d) { None } else { below_bearings(study, rows, d) };
                let below = below.unwrap_or_else(|| vec![0.0; times.len()]);
                let u: Vec<f64> = disp.column(d).iter().zip(below).map(|(u, b)| u - b).collect();
                u.iter().fold(0.0f64, |m, x| m.max((x - u[0]).abs()))
            };
            out.base_displacement = (0..width).map(largest).collect();
        } else {
            let below = &all[k - 1].0;
            let drift = |d: usize| {
                let pairs = disp.column(d).into_iter().zip(below.column(d));
                let start = disp.column(d)[0] - below.column(d)[0];
                pairs.map(|(a, b)| (a - b - start).abs()).fold(0.0, f64::max)
            };
            out.drifts.push((0..width).map(drift).fold(0.0, f64::max) / study.floors[k].height);
            for (sum, a) in inertia.iter_mut().zip(&absolute) {
                let mass = study.floors[k].weight / study.gravity;
                sum.iter_mut().zip(a).for_each(|(s, a)| *s += mass * a);
            }
        }
        let spectrum = |period: &f64| {
            let o = Oscillator { period: *period, damping: 0.05 };
            let of = |a: &Vec<f64>| o.peaks(step, a).acceleration;
            absolute.iter().map(of).fold(0.0, f64::max) / study.gravity
        };
        out.floor_spectra.push(if step > 0.0 { out.periods.iter().map(spectrum).collect() } else { vec![] });
    }
    out.shear_above = largest_length(&inertia);
}
