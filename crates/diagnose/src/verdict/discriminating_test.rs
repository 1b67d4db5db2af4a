//! The next test: the motion within the limits of the rig that would best tell the explanations apart that are left.
//!
//! Motions are made from those of the study: smaller and larger, slower and faster, twice with a pause between. Each is
//! simulated with both explanations, and what their channels differ by is held against the noise that the better one
//! leaves: with a mean square difference of D² times that of the noise, N independent samples name the right one with
//! the probability Φ(√(N D²) / 2) (two hypotheses with known noise; N as in the evidence).

use crate::evidence::likelihood::INDEPENDENT;
use crate::fit::scheduler::Explained;
use crate::residual::noise::power;
use hysteron_identify::study::{Blueprint, Role, Run, Setting, Simulator, Study};
use std::fmt::Write as _;
use std::path::Path;
use std::sync::Arc;

/// A test that is advised.
#[derive(Clone, Debug)]
pub struct NextTest {
    /// What it is, in words.
    pub says: String,
    /// Probability that it names the right one of the two.
    pub power: f64,
    /// Files of motions, by their names.
    pub motions: Vec<(String, String)>,
    /// The script that runs it with the repaired model.
    pub script: String,
}

/// A change of a motion.
#[derive(Clone, Copy)]
struct Change {
    /// Factor on its values.
    size: f64,
    /// Factor on its time.
    time: f64,
    /// Twice, with a pause of its own length between.
    twice: bool,
}

/// Motions of a run that are files of numbers: the variable that names each, and its numbers.
type Motions = Vec<(String, Vec<f64>)>;

/// What makes a run's motion: variables of that name are set in every public script that reads one.
const STEP: &str = "dt";
const COUNT: &str = "npts";

/// Most samples of a test.
const LONGEST: usize = 40_000;

impl Change {
    const ALL: [Self; 10] = {
        const fn of(size: f64, time: f64, twice: bool) -> Change {
            Change { size, time, twice }
        }
        [
            of(1.0, 1.0, false),
            of(0.3, 1.0, false),
            of(0.6, 1.0, false),
            of(1.3, 1.0, false),
            of(1.0, 0.3, false),
            of(1.0, 3.0, false),
            of(1.0, 10.0, false),
            of(0.3, 0.3, false),
            of(1.0, 1.0, true),
            of(0.6, 1.0, true),
        ]
    };

    fn of_motion(self, values: &[f64]) -> Vec<f64> {
        let scaled = values.iter().map(|v| self.size * v);
        if !self.twice {
            return scaled.collect();
        }
        let rest = values.last().copied().unwrap_or(0.0) * self.size;
        let pause = std::iter::repeat_n(rest, values.len());
        scaled.clone().chain(pause).chain(scaled).collect()
    }

    fn says(self) -> String {
        let mut out = vec![];
        if self.size != 1.0 {
            out.push(format!("{} times as large", self.size));
        }
        if self.time != 1.0 {
            out.push(format!("{:.3} times as fast", 1.0 / self.time));
        }
        if self.twice {
            out.push("twice, with a pause as long as itself between".into());
        }
        if out.is_empty() { "once more".into() } else { out.join(", ") }
    }
}

/// Advise a test that tells two explanations apart. `imposed` where the motion is that of the device, not of the ground:
/// then stroke and speed are those of the rig, and where the study does not say them, those of its own runs.
pub(crate) fn next_test(
    blueprint: &Blueprint,
    study: &Study,
    imposed: bool,
    pair: [&Explained; 2],
) -> Option<NextTest> {
    let noise = noise_of(study, pair[0])?;
    let runs: Vec<(&Run, Motions)> = study.runs.iter().map(|r| (r, motions(study, r))).collect();
    let extreme = |f: &dyn Fn(&Run, &[f64]) -> f64| {
        let all = runs.iter().flat_map(|(r, m)| m.iter().map(|(_, v)| f(r, v)));
        all.fold(0.0, f64::max)
    };
    let top = |_: &Run, v: &[f64]| v.iter().fold(0.0f64, |m, x| m.max(x.abs()));
    let speed = |r: &Run, v: &[f64]| {
        let dt = r.number(STEP).filter(|dt| *dt > 0.0).unwrap_or(f64::INFINITY);
        v.windows(2).map(|w| (w[1] - w[0]).abs() / dt).fold(0.0, f64::max)
    };
    let rig = study.rig.as_ref();
    let stroke = rig.and_then(|r| r.stroke).unwrap_or_else(|| extreme(&top));
    let fastest = rig.and_then(|r| r.speed).unwrap_or_else(|| 1.3 * extreme(&speed));
    let mut best: Option<(f64, &Run, Change, Motions, f64)> = None;
    for (run, own) in runs.iter().filter(|(_, m)| !m.is_empty()) {
        let Some(dt) = run.number(STEP) else { continue };
        for change in Change::ALL {
            let made: Motions = own.iter().map(|(n, v)| (n.clone(), change.of_motion(v))).collect();
            let dt = dt * change.time;
            let within = made.iter().all(|(_, v)| {
                v.len() <= LONGEST && top(run, v) <= 1.0001 * stroke && speed(run, v) / change.time <= 1.0001 * fastest
            });
            // Ground motion is as it is: it can only be scaled.
            if (imposed && !within) || (!imposed && (change.time != 1.0 || change.twice)) {
                continue;
            }
            let Some(apart) = apart(blueprint, run, &made, dt, pair, &noise, rig.and_then(|r| r.force)) else {
                continue;
            };
            if best.as_ref().is_none_or(|b| apart > 1.02 * b.0) {
                best = Some((apart, run, change, made, dt));
            }
        }
    }
    let (apart, run, change, made, dt) = best?;
    let power = 0.5 * libm::erfc(-(INDEPENDENT * apart / 8.0).sqrt());
    let files: Vec<(String, String)> = made.iter().map(|(n, v)| (file_of(n), lines(v))).collect();
    let says = format!(
        "run {} {}: tells {} from {} with an expected power of {:.0} %",
        run.name,
        change.says(),
        pair[0].cause(),
        pair[1].cause(),
        100.0 * power
    );
    let mut script = format!("# The next test, advised by hysteron diagnose.\n# {says}\n");
    for (name, value) in settings(run, &made, dt) {
        let text = Run { set: vec![(name.clone(), value)], ..run.clone() }.text(&name).unwrap_or_default();
        let _ = writeln!(script, "set {name} {{{text}}}");
    }
    script += "source corrected.tcl\n";
    Some(NextTest { says, power, motions: files, script })
}

fn file_of(variable: &str) -> String {
    format!("next_test-{variable}.dat")
}

fn lines(values: &[f64]) -> String {
    values.iter().fold(String::new(), |mut out, v| {
        let _ = writeln!(out, "{v:?}");
        out
    })
}

/// The variables of a run whose values name files of numbers, one column.
fn motions(study: &Study, run: &Run) -> Motions {
    let read = |(name, value): &(String, Setting)| {
        let Setting::Text(file) = value else { return None };
        let text = std::fs::read_to_string(Path::new(&study.absolute(file))).ok()?;
        let values: Option<Vec<f64>> = text.split_whitespace().map(|w| w.parse().ok()).collect();
        Some((name.clone(), values.filter(|v| v.len() > 10)?))
    };
    run.set.iter().filter_map(read).collect()
}

/// The variables of a run with other motions.
fn settings(run: &Run, made: &Motions, dt: f64) -> Vec<(String, Setting)> {
    let new = |(name, value): &(String, Setting)| {
        let value = match made.iter().find(|(n, _)| n == name) {
            Some((n, _)) => Setting::Text(file_of(n)),
            None if name == STEP => Setting::Number(dt),
            None if name == COUNT => Setting::Whole(made[0].1.len() as i64),
            None => value.clone(),
        };
        (name.clone(), value)
    };
    run.set.iter().map(new).collect()
}

/// Mean square of what an explanation leaves of each channel, over all fitted runs: its noise.
fn noise_of(study: &Study, e: &Explained) -> Option<Vec<(String, f64)>> {
    let mut out: Vec<(String, Vec<f64>)> = vec![];
    for (run, fit) in study.runs.iter().filter(|r| r.role == Role::Fit).zip(&e.fitted.fits) {
        for (o, y) in run.observe.iter().zip(&fit.channels) {
            let r = y.iter().zip(&o.values).map(|(y, v)| y - v).filter(|d| d.is_finite());
            match out.iter_mut().find(|(c, _)| *c == o.channel) {
                Some((_, all)) => all.extend(r),
                None => out.push((o.channel.clone(), r.collect())),
            }
        }
    }
    (!out.is_empty()).then(|| out.into_iter().map(|(c, r)| (c, power(&r).max(f64::MIN_POSITIVE))).collect())
}

/// How far two explanations are apart in a test, in mean squares of the noise, over its channels.
fn apart(
    blueprint: &Blueprint,
    run: &Run,
    made: &Motions,
    dt: f64,
    pair: [&Explained; 2],
    noise: &[(String, f64)],
    rig_force: Option<f64>,
) -> Option<f64> {
    let samples = made[0].1.len().min(2000);
    let end = dt * (made[0].1.len().saturating_sub(2)) as f64;
    let times: Vec<f64> = (1..=samples).map(|i| end * i as f64 / samples as f64).collect();
    let simulate = |e: &Explained| {
        let mut blueprint = blueprint.clone();
        for (name, values) in made {
            blueprint = blueprint.with_file(&file_of(name), &lines(values));
        }
        let mut study = (*e.variant.study).clone();
        let mut test = Run { set: settings(run, made, dt), ..run.clone() };
        test.recording.times.clone_from(&times);
        study.runs = vec![test];
        let variant = Arc::new(e.variant.of_study(study));
        variant.simulator(&blueprint).simulate(0, &e.fitted.values).ok()
    };
    let (a, b) = (simulate(pair[0])?, simulate(pair[1])?);
    // What the actuator cannot push is no test.
    let most = rig_force.unwrap_or(f64::INFINITY);
    let forces = run.observe.iter().zip(a.iter().zip(&b)).filter(|(o, _)| o.is_force());
    if forces.flat_map(|(_, (a, b))| a.iter().chain(b)).any(|f| f.abs() > most) {
        return None;
    }
    let mut sum = 0.0;
    for ((a, b), o) in a.iter().zip(&b).zip(&run.observe) {
        let difference: Vec<f64> = a.iter().zip(b).map(|(a, b)| a - b).filter(|d| d.is_finite()).collect();
        let (_, level) = noise.iter().find(|(c, _)| *c == o.channel)?;
        sum += power(&difference) / level;
    }
    Some(sum / run.observe.len().max(1) as f64)
}
