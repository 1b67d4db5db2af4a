//! The discriminating test: the motion within the limits of the rig that best separates two hypotheses.
//!
//! Motions are variations of those of the study: smaller and larger, slower and faster, twice with a pause. Both hypotheses
//! simulate each, and their channels differ by D² times the mean square of the noise. The likelihood ratio test of two simple
//! hypotheses then identifies the right one with probability Φ(√(N D²) / 2). N is the number of independent samples in the
//! evidence.

use crate::fit::fitted::FittedHypothesis;
use crate::prior::EFFECTIVE_SAMPLES;
use crate::series::power;
use hysteron_identify::study::{Rig, Role, Run, Setting, Simulator, SimulatorFactory, Study};
use std::fmt::Write as _;
use std::sync::Arc;

/// A recommended test.
#[derive(Clone, Debug)]
pub struct DiscriminatingTest {
    /// The test in words.
    pub description: String,
    /// Probability that it identifies the right hypothesis.
    pub power: f64,
    /// Names and contents of its motion files; empty for a recording at hand.
    pub motions: Vec<(String, String)>,
    /// Script that simulates it with the repaired model; empty for a recording at hand.
    pub script: String,
}

/// A variation of a motion.
#[derive(Clone, Copy)]
struct Variation {
    /// Factor on its values.
    size: f64,
    /// Factor on its time.
    time: f64,
    /// True if it is repeated after a pause of its own length.
    twice: bool,
}

/// Motions of a run that are files of numbers: variable of the file's name, and the numbers.
type Motions = Vec<(String, Vec<f64>)>;

/// Variable of the time step of a motion.
const STEP_VARIABLE: &str = "dt";
/// Variable of its number of samples.
const COUNT_VARIABLE: &str = "npts";
/// Samples that a motion file has at least.
const MIN_MOTION_SAMPLES: usize = 11;
/// Samples of a test, at most.
const MAX_TEST_SAMPLES: usize = 40_000;
/// Samples at which a test is simulated, at most.
const MAX_SIMULATED_SAMPLES: usize = 2000;
/// Speed of a rig whose study gives none, over the largest speed of its own runs.
const SPEED_MARGIN: f64 = 1.3;
/// Tolerance of the rig's limits for round-off.
const LIMIT_TOLERANCE: f64 = 1.0001;
/// Separation over that of a previous variation from which a variation is preferred to it.
const MIN_IMPROVEMENT: f64 = 1.02;

impl Variation {
    const ALL: [Self; 10] = {
        const fn of(size: f64, time: f64, twice: bool) -> Variation {
            Variation { size, time, twice }
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

    /// True if a shaking table allows it: a ground motion can only be scaled.
    fn only_scales(self) -> bool {
        self.time == 1.0 && !self.twice
    }

    /// True if it is the motion as it is: nobody repeats an earthquake at another size.
    fn changes_nothing(self) -> bool {
        self.size == 1.0 && self.only_scales()
    }

    fn of_motion(self, values: &[f64]) -> Vec<f64> {
        let scaled = values.iter().map(|v| self.size * v);
        if !self.twice {
            return scaled.collect();
        }
        let rest = values.last().copied().unwrap_or(0.0) * self.size;
        let pause = std::iter::repeat_n(rest, values.len());
        scaled.clone().chain(pause).chain(scaled).collect()
    }

    fn description(self) -> String {
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

/// Limits of the test rig; those of the study's own runs where the study gives none.
struct Limits {
    stroke: f64,
    speed: f64,
    force: f64,
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0f64, |m, x| m.max(x.abs()))
}

/// Largest speed of a motion of a run; 0 without a time step.
fn largest_speed(run: &Run, values: &[f64]) -> f64 {
    let dt = run.number(STEP_VARIABLE).filter(|dt| *dt > 0.0).unwrap_or(f64::INFINITY);
    values.windows(2).map(|w| (w[1] - w[0]).abs() / dt).fold(0.0, f64::max)
}

impl Limits {
    fn of(rig: Option<&Rig>, runs: &[(&Run, Motions)]) -> Self {
        let extreme = |f: &dyn Fn(&Run, &[f64]) -> f64| {
            let all = runs.iter().flat_map(|(r, m)| m.iter().map(|(_, v)| f(r, v)));
            all.fold(0.0, f64::max)
        };
        Self {
            stroke: rig.and_then(|r| r.stroke).unwrap_or_else(|| extreme(&|_, v| largest(v))),
            speed: rig.and_then(|r| r.speed).unwrap_or_else(|| SPEED_MARGIN * extreme(&largest_speed)),
            force: rig.and_then(|r| r.force).unwrap_or(f64::INFINITY),
        }
    }

    /// Returns true if varied motions of a run stay within stroke and speed.
    fn allow(&self, run: &Run, motions: &Motions, variation: Variation) -> bool {
        motions.iter().all(|(_, v)| {
            v.len() <= MAX_TEST_SAMPLES
                && largest(v) <= LIMIT_TOLERANCE * self.stroke
                && largest_speed(run, v) / variation.time <= LIMIT_TOLERANCE * self.speed
        })
    }
}

/// A run with other motions.
struct VariedRun<'a> {
    run: &'a Run,
    variation: Variation,
    motions: Motions,
    /// Time step, s.
    dt: f64,
}

/// The test that best separates two hypotheses, the first of which is the repaired model.
///
/// `imposed` is true if the motion is that of the device, so that the limits of the rig apply; false for ground motions. Those
/// of a study without a rig are earthquakes: the best of the recordings at hand is named.
/// `None` if no motion of the study is a file of numbers, or none can be simulated.
pub(super) fn discriminating_test(
    factory: &SimulatorFactory,
    study: &Study,
    imposed: bool,
    pair: [&FittedHypothesis; 2],
) -> Option<DiscriminatingTest> {
    let noise = noise_of(study, pair[0])?;
    let runs: Vec<(&Run, Motions)> = study.runs.iter().map(|r| (r, motions(study, r))).collect();
    let limits = Limits::of(study.rig.as_ref(), &runs);
    let recorded_earthquakes = !imposed && study.rig.is_none();
    let mut best: Option<(f64, VariedRun<'_>)> = None;
    for (run, own) in runs.iter().filter(|(_, m)| !m.is_empty()) {
        let Some(dt) = run.number(STEP_VARIABLE) else { continue };
        for variation in Variation::ALL {
            let motions: Motions = own.iter().map(|(n, v)| (n.clone(), variation.of_motion(v))).collect();
            let test = VariedRun { run, variation, motions, dt: dt * variation.time };
            let allowed = match (imposed, recorded_earthquakes) {
                (true, _) => limits.allow(run, &test.motions, variation),
                (false, true) => variation.changes_nothing(),
                (false, false) => variation.only_scales(),
            };
            if !allowed {
                continue;
            }
            let Some(separation) = separation(factory, &test, pair, &noise, limits.force) else { continue };
            if best.as_ref().is_none_or(|b| separation > MIN_IMPROVEMENT * b.0) {
                best = Some((separation, test));
            }
        }
    }
    let (separation, test) = best?;
    // Φ(x) = erfc(-x/√2) / 2.
    let power = 0.5 * libm::erfc(-(EFFECTIVE_SAMPLES * separation / 8.0).sqrt());
    let [first, second] = [pair[0].cause(), pair[1].cause()];
    let separated = format!("tells {first} from {second} with an expected power of {:.0} %", 100.0 * power);
    if recorded_earthquakes {
        let description = format!("of the recordings at hand, look at run {} first: it {separated}", test.run.name);
        return Some(DiscriminatingTest { description, power, motions: vec![], script: String::new() });
    }
    let description = format!("run {} {}: {separated}", test.run.name, test.variation.description());
    let motions = test.motions.iter().map(|(n, v)| (motion_file(n), file_content(v))).collect();
    let script = test.script(&description);
    Some(DiscriminatingTest { description, power, motions, script })
}

impl VariedRun<'_> {
    /// Variables of the run, with those of its motions replaced.
    fn settings(&self) -> Vec<(String, Setting)> {
        let replaced = |(name, value): &(String, Setting)| {
            let value = match self.motions.iter().find(|(n, _)| n == name) {
                Some((n, _)) => Setting::Text(motion_file(n)),
                None if name == STEP_VARIABLE => Setting::Number(self.dt),
                None if name == COUNT_VARIABLE => Setting::Whole(self.motions[0].1.len() as i64),
                None => value.clone(),
            };
            (name.clone(), value)
        };
        self.run.set.iter().map(replaced).collect()
    }

    /// Script that sets the variables and runs the repaired model.
    fn script(&self, description: &str) -> String {
        let mut script = format!("# The next test, advised by hysteron diagnose.\n# {description}\n");
        for (name, value) in self.settings() {
            let text = Run { set: vec![(name.clone(), value)], ..self.run.clone() }.text(&name).unwrap_or_default();
            let _ = writeln!(script, "set {name} {{{text}}}");
        }
        script + "source corrected.tcl\n"
    }
}

fn motion_file(variable: &str) -> String {
    format!("next_test-{variable}.dat")
}

/// Numbers as a file, one a line.
fn file_content(values: &[f64]) -> String {
    values.iter().fold(String::new(), |mut out, v| {
        let _ = writeln!(out, "{v:?}");
        out
    })
}

/// Motions of a run: variables whose values name files of numbers.
fn motions(study: &Study, run: &Run) -> Motions {
    let read = |(name, value): &(String, Setting)| {
        let Setting::Text(file) = value else { return None };
        let text = hysteron_files::read_text(study.absolute(file)).ok()?;
        let values: Option<Vec<f64>> = text.split_whitespace().map(|w| w.parse().ok()).collect();
        Some((name.clone(), values.filter(|v| v.len() >= MIN_MOTION_SAMPLES)?))
    };
    run.set.iter().filter_map(read).collect()
}

/// Mean square residual of each channel over all fitted runs.
fn noise_of(study: &Study, e: &FittedHypothesis) -> Option<Vec<(String, f64)>> {
    let mut residuals: Vec<(String, Vec<f64>)> = vec![];
    for (run, fit) in study.runs.iter().filter(|r| r.role == Role::Fit).zip(&e.fitted.fits) {
        for (o, y) in run.observe.iter().zip(&fit.channels) {
            let r = y.iter().zip(&o.values).map(|(y, v)| y - v).filter(|d| d.is_finite());
            match residuals.iter_mut().find(|(c, _)| *c == o.channel) {
                Some((_, all)) => all.extend(r),
                None => residuals.push((o.channel.clone(), r.collect())),
            }
        }
    }
    let noise = |(c, r): (String, Vec<f64>)| (c, power(&r).max(f64::MIN_POSITIVE));
    (!residuals.is_empty()).then(|| residuals.into_iter().map(noise).collect())
}

/// Mean over the channels of D², the mean square difference of two hypotheses over that of the noise.
///
/// `None` if a simulation fails, or if a force exceeds the rig's.
fn separation(
    factory: &SimulatorFactory,
    test: &VariedRun<'_>,
    pair: [&FittedHypothesis; 2],
    noise: &[(String, f64)],
    max_force: f64,
) -> Option<f64> {
    let run = test.run;
    let count = test.motions[0].1.len();
    let samples = count.min(MAX_SIMULATED_SAMPLES);
    let end = test.dt * (count.saturating_sub(2)) as f64;
    let times: Vec<f64> = (1..=samples).map(|i| end * i as f64 / samples as f64).collect();
    let simulate = |e: &FittedHypothesis| {
        let mut factory = factory.clone();
        for (name, values) in &test.motions {
            factory = factory.with_file(&motion_file(name), &file_content(values));
        }
        let mut study = (*e.variant.study).clone();
        let mut varied = Run { set: test.settings(), ..run.clone() };
        varied.recording.times.clone_from(&times);
        study.runs = vec![varied];
        let variant = Arc::new(e.variant.with_study(study));
        variant.simulator(&factory).simulate(0, &e.fitted.values).ok()
    };
    let (a, b) = (simulate(pair[0])?, simulate(pair[1])?);
    let forces = run.observe.iter().zip(a.iter().zip(&b)).filter(|(o, _)| o.is_force());
    if forces.flat_map(|(_, (a, b))| a.iter().chain(b)).any(|f| f.abs() > max_force) {
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
