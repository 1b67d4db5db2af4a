//! Competition of the kinds of memory for a device under an imposed motion, and the noise of the recordings.

use crate::inspect::conditions::axial_loads;
use crate::inspect::response::{ResponseHistory, ResponseRanges};
use crate::memory::competition::{FamilyResult, compete};
use crate::memory::data::{Condition, DeviceRun};
use crate::memory::family::Family;
use hysteron_identify::measure::work;
use hysteron_identify::noise::recorded_noise;
use hysteron_identify::study::{Role, ScoredRun, Study};
use serde::{Deserialize, Serialize};
use std::collections::BTreeSet;

/// What the recordings themselves say, whatever the library has.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub struct RecordedEvidence {
    /// Noise of the fitted runs, mean NMSE; none where the channels are too short.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub noise: Option<f64>,
    /// Noise of the runs held out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub noise_held_out: Option<f64>,
    /// True if each run has one channel.
    #[serde(default)]
    pub is_single: bool,
    /// Channel of the device's force; empty where no device could be examined.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub channel: String,
    /// Kinds of memory, the best first; empty where no device could be examined.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub families: Vec<FamilyResult>,
}

/// The user's fitted model in all runs.
#[derive(Clone, Copy)]
pub(crate) struct ModelRuns<'a> {
    pub(crate) study: &'a Study,
    /// Channels by run; none for a run without a result.
    pub(crate) fits: &'a [Option<ScoredRun>],
    /// Responses of the devices in the fitted runs and in those held out.
    pub(crate) responses: [&'a ResponseRanges; 2],
    /// True if motions of nodes are imposed, so that deformations are known.
    pub(crate) imposed_motion: bool,
    pub(crate) has_clock: bool,
    /// True if the channel is taken for the force of the only device.
    pub(crate) lone_device: bool,
}

/// Runs of a device with the channel of its force.
#[derive(Clone, Debug)]
pub(crate) struct DeviceRuns {
    /// The channel.
    pub(crate) channel: String,
    /// The runs.
    pub(crate) runs: Vec<DeviceRun>,
    /// The element; none where the channel is not the force of one element.
    pub(crate) device: Option<MeasuredDevice>,
}

/// An element whose force a channel shows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct MeasuredDevice {
    /// Its tag.
    pub(crate) tag: i32,
    /// Its direction.
    pub(crate) direction: usize,
    /// Size of the channel over the force of the element.
    pub(crate) factor: f64,
}

/// Squared correlation from which a channel is the force of one element, and largest difference of its factor between runs.
const ONE_FORCE: f64 = 0.999;
const SAME_FACTOR: f64 = 0.01;
/// Least squared correlation of a channel with the force of a device that it shows.
const SAME_FORCE: f64 = 0.8;
/// Squared correlation with the deformation from which a column is the deformation under another name.
const SAME_DEFORMATION: f64 = 0.98;
/// Deformation of a second direction, over the first, from which the motion is no longer along one.
const SECOND_DIRECTION: f64 = 0.02;
/// Ratio of error and noise from which something is left to be explained.
pub(crate) const MIN_SIGNAL_RATIO: f64 = 1.5;

impl ModelRuns<'_> {
    /// Evidence of the recordings.
    pub(crate) fn evidence(&self) -> RecordedEvidence {
        let (noise, noise_held_out) = (self.noise(Role::Fit), self.noise(Role::Holdout));
        let is_single = self.study.runs.iter().all(|r| r.observe.len() == 1);
        let (channel, families) = match self.device_runs() {
            Some(d) => (d.channel, compete(d.runs, self.has_clock)),
            None => (String::new(), vec![]),
        };
        RecordedEvidence { noise, noise_held_out, is_single, channel, families }
    }

    /// Mean noise of the channels of a role.
    pub(crate) fn noise(&self, role: Role) -> Option<f64> {
        let of_run = |(i, _): (usize, _)| {
            let fit = self.fits[i].as_ref()?;
            let known: Vec<f64> =
                recorded_noise(self.study, i, &fit.channels).into_iter().flatten().map(|n| n.nmse).collect();
            (!known.is_empty()).then(|| known.iter().sum::<f64>() / known.len() as f64)
        };
        let all: Vec<f64> = self.study.runs_of(role).filter_map(of_run).collect();
        (!all.is_empty()).then(|| all.iter().sum::<f64>() / all.len() as f64)
    }

    /// Channel with the largest error that shows the force of one device, and the runs with it. `None` if there is no such
    /// channel, or if a device moves in two directions.
    pub(crate) fn device_runs(&self) -> Option<DeviceRuns> {
        self.channels().iter().find_map(|name| {
            let runs = self.runs_of_channel(name)?;
            Some(DeviceRuns { channel: (*name).to_owned(), runs, device: self.device_of_channel(name) })
        })
    }

    /// The same, or else the only device of the model: the force of a dashpot alone is not among its responses. A law of it is
    /// judged by the script with the law.
    pub(crate) fn learnable_runs(&self) -> Option<DeviceRuns> {
        let lone = ModelRuns { lone_device: true, ..*self };
        self.device_runs().or_else(|| lone.device_runs())
    }

    /// Channels of runs under an imposed motion, that with the largest error first.
    fn channels(&self) -> Vec<&str> {
        if !self.imposed_motion {
            return vec![];
        }
        let mut channels: Vec<(&str, f64)> = vec![];
        for (i, run) in self.study.runs_of(Role::Fit) {
            let Some(fit) = &self.fits[i] else { return vec![] };
            for (o, s) in run.observe.iter().zip(&fit.scores) {
                match channels.iter_mut().find(|(name, _)| *name == o.channel) {
                    Some((_, error)) => *error += s.nmse,
                    None => channels.push((&o.channel, s.nmse)),
                }
            }
        }
        channels.sort_by(|a, b| b.1.total_cmp(&a.1));
        channels.into_iter().map(|(name, _)| name).collect()
    }

    /// The device whose force a channel shows in all fitted runs, where it is that force times one factor.
    fn device_of_channel(&self, channel: &str) -> Option<MeasuredDevice> {
        let mut found: Option<MeasuredDevice> = None;
        for (i, run) in self.study.runs_of(Role::Fit) {
            let Some(c) = run.observe.iter().position(|o| o.channel == channel) else { continue };
            let simulated = &self.fits[i].as_ref()?.channels[c];
            let ((_, tag, direction), h) = self.found_history(i, 0, simulated)?;
            if self.lone_device {
                found = Some(MeasuredDevice { tag: *tag, direction: *direction, factor: 1.0 });
                continue;
            }
            if correlation(&h.force, simulated).powi(2) < ONE_FORCE {
                return None;
            }
            let both = || h.force.iter().zip(simulated).filter(|(f, y)| f.is_finite() && y.is_finite());
            let factor = both().map(|(f, y)| f * y).sum::<f64>() / both().map(|(f, _)| f * f).sum::<f64>();
            let of_run = MeasuredDevice { tag: *tag, direction: *direction, factor: factor.abs() };
            let is_same = |d: &MeasuredDevice| {
                d.tag == of_run.tag
                    && d.direction == of_run.direction
                    && (d.factor / of_run.factor - 1.0).abs() < SAME_FACTOR
            };
            if found.as_ref().is_some_and(|d| !is_same(d)) {
                return None;
            }
            found.get_or_insert(of_run);
        }
        found
    }

    /// Fitted runs and runs held out that have a channel.
    fn runs_of_channel(&self, channel: &str) -> Option<Vec<DeviceRun>> {
        let names = self.condition_names(channel);
        let axial = axial_loads(self.study);
        let mut out = vec![];
        for (i, run) in self.study.runs.iter().enumerate() {
            let Some(c) = run.observe.iter().position(|o| o.channel == channel) else { continue };
            let Some(fit) = &self.fits[i] else { continue };
            let held_out = run.role == Role::Holdout;
            let history = self.history(i, usize::from(held_out), &fit.channels[c])?;
            // The force of a dashpot does not follow the deformation, but takes work.
            let sign = if self.lone_device {
                whole_work(&history.deformation, &fit.channels[c]).signum()
            } else {
                correlation(&history.force, &fit.channels[c]).signum()
            };
            let column = |name: &String| {
                let known = run.recording.columns.iter().find(|c| c.name == *name).map(|c| c.values.clone());
                let set = axial.as_ref().filter(|_| name == AXIAL_LOAD).map(|a| vec![a[i]; run.recording.times.len()]);
                Some(Condition { name: name.clone(), values: known.or(set)? })
            };
            out.push(DeviceRun {
                times: run.recording.times.clone(),
                deformation: history.deformation.clone(),
                modelled: fit.channels[c].iter().map(|y| if y.is_finite() { sign * y } else { 0.0 }).collect(),
                recorded: run.observe[c].values.iter().map(|v| sign * v).collect(),
                conditions: names.iter().map(column).collect::<Option<_>>()?,
                held_out,
            });
        }
        let is_whole =
            out.iter().all(|r| r.deformation.len() == r.times.len() && r.deformation.iter().all(|u| u.is_finite()));
        is_whole.then_some(out)
    }

    /// History of the device that deforms most among those whose force a channel shows.
    fn history(&self, run: usize, role: usize, simulated: &[f64]) -> Option<&ResponseHistory> {
        self.found_history(run, role, simulated).map(|(_, h)| h)
    }

    /// The same with its run, tag and direction.
    fn found_history(
        &self,
        run: usize,
        role: usize,
        simulated: &[f64],
    ) -> Option<(&(usize, i32, usize), &ResponseHistory)> {
        let of_run = || self.responses[role].histories.iter().filter(move |((r, ..), _)| *r == run);
        let size = |h: &ResponseHistory| h.range().deformation;
        let is_shown = |h: &ResponseHistory| correlation(&h.force, simulated).powi(2) > SAME_FORCE;
        let is_lone = self.lone_device && of_run().map(|((_, tag, _), _)| tag).collect::<BTreeSet<_>>().len() == 1;
        let shown = of_run().filter(|((_, _, d), h)| *d <= 3 && (is_lone || is_shown(h)));
        let (key, found) = shown.max_by(|a, b| size(a.1).total_cmp(&size(b.1)))?;
        let (_, tag, direction) = key;
        let most = size(found);
        let mut others = of_run().filter(|((_, t, d), _)| t == tag && d != direction && *d <= 3);
        let moves_in_two = others.any(|(_, h)| {
            size(h) > SECOND_DIRECTION * most
                && correlation(&h.deformation, &found.deformation).powi(2) < SAME_DEFORMATION
        });
        (!moves_in_two).then_some((key, found))
    }

    /// Names of columns of all runs that are neither observed nor the deformation, and of an axial load that differs.
    fn condition_names(&self, channel: &str) -> Vec<String> {
        let runs = &self.study.runs;
        let Some(first) = runs.first() else { return vec![] };
        let is_known = |name: &String| {
            runs.iter().enumerate().all(|(i, r)| {
                let Some(column) = r.recording.columns.iter().find(|c| c.name == *name) else { return false };
                let observed = r.observe.iter().any(|o| o.channel == *name);
                let role = usize::from(r.role == Role::Holdout);
                let moves = self.responses[role].histories.iter().filter(|((run, ..), _)| *run == i);
                let mut moves = moves.map(|(_, h)| correlation(&h.deformation, &column.values).powi(2));
                *name != channel && !observed && !moves.any(|r2| r2 > SAME_DEFORMATION)
            })
        };
        let columns = first.recording.columns.iter().map(|c| c.name.clone()).filter(is_known);
        let varies = axial_loads(self.study).is_some_and(|a| a.iter().any(|x| (x - a[0]).abs() > 1e-6 * a[0].abs()));
        let mut names: Vec<String> = columns.collect();
        if varies && !names.iter().any(|n| Family::of_column(n) == Family::AxialForce) {
            names.push(AXIAL_LOAD.into());
        }
        names
    }
}

/// Name of the variable that sets the axial load of a run.
const AXIAL_LOAD: &str = "axial";

/// Work of a force along a deformation, over finite pairs.
fn whole_work(deformation: &[f64], force: &[f64]) -> f64 {
    let both = deformation.iter().zip(force).filter(|(u, f)| u.is_finite() && f.is_finite());
    let (u, f): (Vec<f64>, Vec<f64>) = both.unzip();
    work(&u, &f).last().copied().unwrap_or(0.0)
}

/// Correlation of two series about their means, over finite pairs; 0 where one is constant.
fn correlation(a: &[f64], b: &[f64]) -> f64 {
    let both: Vec<(f64, f64)> =
        a.iter().zip(b).filter(|(a, b)| a.is_finite() && b.is_finite()).map(|(a, b)| (*a, *b)).collect();
    let n = both.len().max(1) as f64;
    let (x, y) = (both.iter().map(|p| p.0).sum::<f64>() / n, both.iter().map(|p| p.1).sum::<f64>() / n);
    let (mut product, mut first, mut second) = (0.0, 0.0, 0.0);
    for (a, b) in both {
        product += (a - x) * (b - y);
        first += (a - x) * (a - x);
        second += (b - y) * (b - y);
    }
    if first > 0.0 && second > 0.0 { product / (first * second).sqrt() } else { 0.0 }
}
