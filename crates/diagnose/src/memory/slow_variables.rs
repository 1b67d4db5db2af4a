//! Slow variables of the past, and forces of it, by family. They are of the order of one.

use super::data::{Data, DeviceRun, Mode};
use super::family::Family;
use super::operators::low_pass;
use hysteron_engine::element::amendment::learned::{History, Moment, Scales, Variable};
use std::rc::Rc;

/// Counterpart of a series in a law of the engine.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Kind {
    /// A slow variable.
    Variable(Variable),
    /// Force of a spring about the middle of the extremes.
    Moving,
    /// Force that follows a condition.
    ChannelForce(usize),
    /// Nothing: it serves comparison alone.
    Compared,
}

/// A slow variable in all runs.
#[derive(Clone)]
pub(super) struct SlowVariable {
    /// What it remembers.
    pub(super) family: Family,
    /// Its formula in words.
    pub(super) name: String,
    /// Counterpart in a law of the engine.
    pub(super) kind: Kind,
    /// Its series by run.
    pub(super) runs: Vec<Vec<f64>>,
    /// The same at the samples.
    pub(super) at_samples: Vec<f64>,
    /// The same for a factor on the spring, which takes the deformation of the moment.
    pub(super) on_spring: Vec<f64>,
    /// Least and largest value in the fitted runs.
    pub(super) range: [f64; 2],
}

/// Histories of a run: that before it, and that after each sample.
struct Histories {
    start: History,
    after: Vec<History>,
}

impl Histories {
    fn of(run: &DeviceRun, scales: &Scales) -> Self {
        let u0 = run.deformation.first().copied().unwrap_or(0.0);
        let start = History { deformation: u0, largest: [u0.max(0.0), (-u0).max(0.0)], ..History::default() };
        let mut h = start;
        let after = (0..run.times.len())
            .map(|j| {
                let dt = if j > 0 { run.times[j] - run.times[j - 1] } else { 0.0 };
                h = h.next(scales, run.deformation[j], dt);
                h
            })
            .collect();
        Self { start, after }
    }

    fn before(&self, j: usize) -> &History {
        if j > 0 { &self.after[j - 1] } else { &self.start }
    }
}

/// Builder of variables at a slip level.
pub(super) struct Builder<'a> {
    data: &'a Data,
    scales: Scales,
    histories: Vec<Histories>,
    /// Channels of each run, scaled, by sample.
    channels: Vec<Vec<Vec<f64>>>,
}

impl<'a> Builder<'a> {
    pub(super) fn new(data: &'a Data, level: f64) -> Self {
        let s = &data.scales;
        let scales =
            Scales { deformation: s.deformation, speed: s.speed, duration: s.duration, work: f64::MIN_POSITIVE, level };
        let histories: Vec<Histories> = data.runs.iter().map(|r| Histories::of(r, &scales)).collect();
        let of_fitted = data.runs.iter().zip(&histories).filter(|(r, _)| !r.held_out);
        let work = of_fitted.filter_map(|(_, h)| h.after.last().map(|h| h.work)).fold(f64::MIN_POSITIVE, f64::max);
        let channels = data.runs.iter().map(|r| (0..r.times.len()).map(|j| data.scaled_conditions(r, j)).collect());
        Self { data, scales: Scales { work, ..scales }, histories, channels: channels.collect() }
    }

    pub(super) fn scales(&self) -> &Scales {
        &self.scales
    }

    /// Series of a variable in a run: for factors on strength and force, and for one on the spring.
    fn series(&self, run: usize, variable: Variable) -> [Vec<f64>; 2] {
        let (r, h) = (&self.data.runs[run], &self.histories[run]);
        let mut slot = 0.0;
        let (mut on_force, mut on_spring) = (vec![], vec![]);
        for (j, u) in r.deformation.iter().enumerate() {
            let (before, after) = (h.before(j), &h.after[j]);
            let channels = &self.channels[run][j];
            let next = variable.next(slot, &self.scales, before, after, channels);
            let value = |slot, history: &History, deformation: f64| {
                variable.value(slot, &self.scales, history, &Moment { deformation, channels }).0
            };
            match self.data.mode {
                Mode::Comparison => {
                    on_force.push(value(next, after, *u));
                    on_spring.push(value(next, after, *u));
                }
                Mode::Engine => {
                    on_force.push(value(slot, before, before.deformation));
                    on_spring.push(value(slot, before, *u));
                }
            }
            slot = next;
        }
        [on_force, on_spring]
    }

    /// A variable in all runs, within the range of the fitted ones; `None` if it is constant there.
    pub(super) fn variable(&self, family: Family, name: &str, variable: Variable) -> Option<SlowVariable> {
        let both = (0..self.data.runs.len()).map(|k| self.series(k, variable)).collect::<Vec<_>>();
        let (on_force, on_spring): (Vec<_>, Vec<_>) = both.into_iter().map(|[a, b]| (a, b)).unzip();
        self.within_range(family, name, Kind::Variable(variable), on_force, &on_spring)
    }

    fn force(
        &self,
        family: Family,
        name: &str,
        kind: Kind,
        of_run: impl Fn(usize) -> Vec<f64>,
    ) -> Option<SlowVariable> {
        let runs: Vec<Vec<f64>> = (0..self.data.runs.len()).map(of_run).collect();
        self.within_range(family, name, kind, runs.clone(), &runs)
    }

    fn within_range(
        &self,
        family: Family,
        name: &str,
        kind: Kind,
        mut runs: Vec<Vec<f64>>,
        on_spring: &[Vec<f64>],
    ) -> Option<SlowVariable> {
        let d = self.data;
        let mut on_spring = d.sampled(on_spring);
        // Values beyond those of the fitted runs say nothing.
        let all = d.sampled(&runs);
        let fitted = (0..all.len()).filter(|i| d.fitted[*i]).flat_map(|i| [all[i], on_spring[i]]);
        let (low, high) = fitted.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(x), b.max(x)));
        if !low.is_finite() || high <= low {
            return None;
        }
        // A force about a moving origin has no range.
        if kind != Kind::Moving {
            runs.iter_mut().flatten().chain(&mut on_spring).for_each(|x| *x = x.clamp(low, high));
        }
        let at_samples = d.sampled(&runs);
        Some(SlowVariable { family, name: name.into(), kind, runs, at_samples, on_spring, range: [low, high] })
    }
}

/// Lengths of slip over U that wear a rest off, and times over T after which it counts.
const REST_LENGTHS: [f64; 3] = [0.03, 0.15, 0.6];
const REST_TIMES: [f64; 2] = [0.01, 0.1];
/// Deformation of the lesser side over U below which the side last used is that of the clock.
const LEAST_SIDE: f64 = 0.2;
/// Places over U of a device that differs along its stroke, and their width.
const PLACES: [f64; 7] = [-0.75, -0.5, -0.25, 0.0, 0.25, 0.5, 0.75];
const PLACE_WIDTH: f64 = 0.25;

/// Variables of a family with their names. A comparison of kinds has fewer than a law of the engine.
fn variables_of(data: &Data, family: Family, condition: Option<usize>) -> Vec<(String, Variable)> {
    use Variable as V;
    let s = &data.scales;
    let t = s.duration;
    let late = |c: &f64| format!("{c:.3}");
    let is_engine = data.mode == Mode::Engine;
    match family {
        Family::Shape => {
            vec![("|u|".into(), V::Deformation { power: 1.0 }), ("u^2".into(), V::Deformation { power: 2.0 })]
        }
        Family::Clock => {
            let saturating = [0.1, 0.3].map(|e| (format!("1-exp(-t/{e}T)"), V::TimeSaturating { constant: e * t }));
            let steps = [0.25, 0.5, 0.75].map(|c| (format!("after {c}T"), V::TimeStep { at: c * t }));
            std::iter::once(("t".into(), V::Time)).chain(saturating).chain(steps).collect()
        }
        Family::Work => {
            let saturating = [0.1, 0.3].map(|e| (format!("1-exp(-D/{e})"), V::WorkSaturating { constant: e }));
            std::iter::once(("D".into(), V::Work)).chain(saturating).collect()
        }
        Family::Heat => {
            let of = |c: &f64| {
                let recent = (format!("recent work, {}", late(c)), V::RecentWork { constant: *c });
                let softening = (format!("1/(1+4 recent work), {}", late(c)), V::RecentWorkSoftening { constant: *c });
                [recent, softening]
            };
            s.constants[2..].iter().flat_map(of).collect()
        }
        Family::Largest => {
            let decays = [0.15, 0.4].into_iter().flat_map(|e| {
                let both = (format!("exp(-m/{e}U)"), V::LargestDecay { constant: e });
                [both, (format!("exp(-m/{e}U) of the side"), V::LargestDecayOfSide { constant: e })]
            });
            let virgin = [2.0, 4.0].map(|power| (format!("(u/m)^{power}"), V::Virgin { power }));
            let plain = [("m".into(), V::Largest), ("m of the side".into(), V::LargestOfSide)];
            plain.into_iter().chain(decays).chain(virgin).collect()
        }
        Family::Pinching => [0.15, 0.35].map(|e| (format!("exp(-(u/{e}m)^2)"), V::Pinching { width: e })).to_vec(),
        Family::Rate => {
            let now = [0.003, 0.03, 0.3].map(|e| (format!("ln(1+v/{e}V)"), V::Rate { reference: e }));
            let over = s.constants[2..5]
                .iter()
                .map(|c| (format!("ln(1+v/0.03V) over {}", late(c)), V::RateOver { reference: 0.03, constant: *c }));
            now.into_iter().chain(over).collect()
        }
        Family::Rest => {
            let of = |(length, time): (f64, f64)| {
                let [l, t0] = [length * s.deformation, time * t];
                let name = |what: &str| format!("ln(1+{what}/{time}T), slip {length}U");
                let stuck = (name("stuck"), V::Rest { length: l, time: t0 });
                let still = (name("still"), V::Still { length: l, time: t0 });
                if is_engine { vec![stuck, still] } else { vec![stuck] }
            };
            let times = if is_engine { &REST_TIMES[..] } else { &REST_TIMES[..1] };
            REST_LENGTHS
                .into_iter()
                .flat_map(|length| times.iter().map(move |time| (length, *time)))
                .flat_map(of)
                .collect()
        }
        Family::Side => {
            let late = |c: &f64| (format!("side over {}", late(c)), V::SideOver { constant: *c });
            let has_both = s.lesser_side > LEAST_SIDE * s.deformation;
            let of_late = s.constants[2..].iter().filter(|_| is_engine && has_both && data.has_clock).map(late);
            std::iter::once(("u".into(), V::Side)).chain(of_late).collect()
        }
        Family::Place => {
            PLACES.map(|place| (format!("about {place}U"), V::Place { place, width: PLACE_WIDTH })).to_vec()
        }
        Family::Set => vec![],
        Family::Temperature | Family::AxialForce | Family::Channel => {
            let Some(channel) = condition else { return vec![] };
            let of = |c: &f64| (format!("x late by {}", late(c)), V::ChannelLate { channel, constant: *c });
            let filtered = s.constants[..4].iter().filter(|_| data.has_clock).map(of);
            let plain = [("x".into(), V::Channel { channel }), ("x^2".into(), V::ChannelSquare { channel })];
            plain.into_iter().chain(filtered).collect()
        }
    }
}

/// Factors of a family. `level` is the slip level of the law.
pub(super) fn factors(data: &Data, family: Family, condition: Option<usize>, level: f64) -> Vec<SlowVariable> {
    let b = Builder::new(data, level);
    let all = variables_of(data, family, condition).into_iter();
    all.filter_map(|(name, variable)| b.variable(family, &name, variable)).collect()
}

/// Forces of a family beside those of springs and dashpots. A force of the clock alone is a matter of a sensor.
pub(super) fn forces(data: &Data, family: Family, condition: Option<usize>) -> Vec<SlowVariable> {
    let s = &data.scales;
    let b = Builder::new(data, s.deformation);
    let middle = |k: usize| -> Vec<f64> { b.histories[k].after.iter().map(|h| h.middle() / s.deformation).collect() };
    let scaled = |k: usize| -> Vec<f64> { data.runs[k].deformation.iter().map(|u| u / s.deformation).collect() };
    let late = |k: usize, x: Vec<f64>, c: f64| low_pass(&x, &data.runs[k].times, c, 0.0);
    let mut out = vec![];
    match family {
        Family::Set if data.mode == Mode::Engine => {
            let moving = |k: usize| -> Vec<f64> {
                let from = |j: usize| b.histories[k].before(j).middle() / s.deformation;
                scaled(k).iter().enumerate().map(|(j, u)| u - from(j)).collect()
            };
            out.push(b.force(family, "u about the middle of the extremes", Kind::Moving, moving));
        }
        Family::Set => {
            out.push(b.force(family, "middle of the extremes", Kind::Compared, middle));
            for c in s.constants[2..].iter().copied().filter(|_| data.has_clock) {
                let of_middle = |k: usize| late(k, middle(k), c);
                out.push(b.force(
                    family,
                    &format!("middle of the extremes, late by {c:.3}"),
                    Kind::Compared,
                    of_middle,
                ));
                out.push(b.force(family, &format!("u over {c:.3}"), Kind::Compared, |k| late(k, scaled(k), c)));
            }
        }
        Family::Temperature | Family::AxialForce | Family::Channel => {
            if let Some(i) = condition {
                let of_run = |k: usize| b.channels[k].iter().map(|x| x[i]).collect();
                out.push(b.force(family, "force by x", Kind::ChannelForce(i), of_run));
            }
        }
        _ => {}
    }
    out.into_iter().flatten().collect()
}

/// A variable at another slip level.
pub(super) fn with_level(data: &Data, v: &Rc<SlowVariable>, level: f64) -> Rc<SlowVariable> {
    match v.kind {
        Kind::Variable(variable) if variable.depends_on_level() => with_variable(data, v, variable, level),
        _ => v.clone(),
    }
}

/// A variable with other constants, at a slip level; the same one where that would be constant.
pub(super) fn with_variable(data: &Data, v: &Rc<SlowVariable>, variable: Variable, level: f64) -> Rc<SlowVariable> {
    Builder::new(data, level).variable(v.family, &v.name, variable).map_or_else(|| v.clone(), Rc::new)
}
