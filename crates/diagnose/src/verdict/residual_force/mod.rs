//! Force that the user's model lacks, by place and time: the recorded one less the simulated one.
//!
//! A channel shows the force of an element or of a support. Accelerations of masses show the force of a storey: it resists the
//! inertia of all masses at its level and above. The difference of two accelerations is the same against the ground and in space.

mod motion;
mod words;

use super::levels::Levels;
use super::mismatch::find_windows;
use super::place::AXES;
use super::quantity::{Units, digits};
use crate::inspect::inventory::{Device, Direction, Mass, ModelInventory};
use crate::inspect::response::{ResponseHistory, ResponseRanges};
use crate::series::power;
use hysteron_identify::study::unit::{self, Quantity};
use hysteron_identify::study::{ObservedChannel, Role, Run, ScoredRun, Study};
use motion::Motion;
use serde::Serialize;

/// Force that the model lacks at one place in one run.
#[derive(Clone, Debug, Serialize)]
pub struct ResidualForce {
    /// Name of the run.
    pub run: String,
    /// Element, support or storey, in words.
    pub place: String,
    /// Tags of its elements.
    #[serde(skip)]
    pub(super) elements: Vec<i32>,
    /// Channels that show it.
    pub channels: Vec<String>,
    /// Unit; empty if it is not known.
    pub unit: String,
    /// Root mean square.
    pub rms: f64,
    /// The same over the standard deviation of the recorded force.
    pub ratio: f64,
    /// Stretches of time with most of its square, s.
    pub windows: Vec<[f64; 2]>,
    /// Share of its square within them.
    pub share: f64,
    /// Parts that follow the motion there, the largest first.
    pub parts: Vec<ResidualPart>,
    /// Shares of its square, and of the time, by the signs of deformation and speed: ++, +-, --, -+. Absent where no device shows
    /// the deformation.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub quadrants: Option<[[f64; 2]; 4]>,
    /// Two sentences: where and when; at what motion.
    pub text: [String; 2],
    /// Its course.
    #[serde(skip)]
    pub(super) course: ForceCourse,
}

/// Name of the part that comes again wherever the deformation does, in the same sense of the motion.
const STROKE: &str = "stroke";

/// Part of a residual force that follows the motion.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ResidualPart {
    /// The motion that it follows: the sign of the `speed` or of the `deformation`, one `side` for a force of one sign, or the `stroke`.
    pub follows: &'static str,
    /// Share of its square that this predicts on stretches of time that were left out.
    pub share: f64,
    /// 1 if the recorded force resists more than the simulated one, -1 if less; 1 along the stroke.
    pub sense: f64,
}

/// Course of a residual force.
#[derive(Clone, Debug, Default)]
pub(super) struct ForceCourse {
    /// Times, s.
    pub(super) times: Vec<f64>,
    /// Recorded less simulated force, positive where it resists a positive deformation.
    pub(super) force: Vec<f64>,
    /// Simulated deformation there, with its direction in words.
    pub(super) deformation: Option<(Vec<f64>, String)>,
}

/// The fitted model of the user in the fitted runs.
pub(super) struct FittedModelRuns<'a> {
    pub(super) study: &'a Study,
    pub(super) inventory: &'a ModelInventory,
    /// Responses of the devices.
    pub(super) responses: &'a ResponseRanges,
    /// Channels by run; none for a run without a result.
    pub(super) fits: &'a [Option<ScoredRun>],
    /// Names of the observed columns by run: "node 3 dof 1", "element 2 force".
    pub(super) columns: &'a [Vec<String>],
    pub(super) units: &'a Units,
}

/// Squared correlation of a channel with the force of a device from which it shows that force.
const SAME_FORCE: f64 = 0.8;
/// Component of a direction along a global axis from which it is along it.
const MIN_COMPONENT: f64 = 0.99;
/// Elements that are named, at most.
const MAX_NAMED: usize = 4;

/// Residual forces of the fitted runs, the largest against the recorded force first.
pub(super) fn residual_forces(of: &FittedModelRuns<'_>) -> Vec<ResidualForce> {
    let levels = Levels::of(of.inventory);
    let mut out: Vec<ResidualForce> = vec![];
    for (number, run) in of.study.runs_of(Role::Fit) {
        let Some(fit) = &of.fits[number] else { continue };
        let run = FittedRun { of, levels: &levels, number, run, fit };
        out.extend(run.forces_of_channels());
        out.extend(run.forces_of_storeys());
    }
    out.sort_by(|a, b| b.ratio.total_cmp(&a.ratio));
    out
}

/// Tag and degree of freedom, or tag alone, that follow a word at the beginning of the name of a column.
fn tag_of(column: &str, word: &str) -> Option<i32> {
    column.strip_prefix(word)?.split_whitespace().next()?.parse().ok()
}

/// Node and degree of freedom of a column.
pub(super) fn node_of(column: &str) -> Option<(i32, usize)> {
    let dof = column.split_once(" dof ")?.1.trim().parse().ok()?;
    Some((tag_of(column, "node ")?, dof))
}

/// Element of a column.
pub(super) fn element_of(column: &str) -> Option<i32> {
    tag_of(column, "element ")
}

/// True if a channel is an acceleration, by its unit, or by its name where it has none.
pub(super) fn is_acceleration(o: &ObservedChannel) -> bool {
    match unit::unit(&o.unit) {
        Some(u) => u.quantity == Quantity::Acceleration,
        None => o.unit.is_empty() && o.channel.contains("acc"),
    }
}

/// A fitted run of the user's model.
struct FittedRun<'a> {
    of: &'a FittedModelRuns<'a>,
    levels: &'a Levels,
    number: usize,
    run: &'a Run,
    fit: &'a ScoredRun,
}

/// Recorded and simulated force of one place.
struct BothForces {
    place: String,
    elements: Vec<i32>,
    channels: Vec<String>,
    unit: String,
    recorded: Vec<f64>,
    residual: Vec<f64>,
    deformation: Option<(Vec<f64>, String)>,
}

impl FittedRun<'_> {
    fn column(&self, channel: usize) -> &str {
        self.of.columns.get(self.number).and_then(|c| c.get(channel)).map_or("", String::as_str)
    }

    /// Recorded less simulated samples of a channel.
    fn residual(&self, channel: usize) -> Vec<f64> {
        self.run.observe[channel].values.iter().zip(&self.fit.channels[channel]).map(|(v, y)| v - y).collect()
    }

    /// Forces that channels show.
    fn forces_of_channels(&self) -> Vec<ResidualForce> {
        let channels = self.run.observe.iter().enumerate().filter(|(_, o)| o.is_resistance());
        channels.filter_map(|(channel, o)| self.force_of_channel(channel, o)).collect()
    }

    fn force_of_channel(&self, channel: usize, o: &ObservedChannel) -> Option<ResidualForce> {
        let (element, node) = (element_of(self.column(channel)), node_of(self.column(channel)));
        let place = match (element, node) {
            (Some(tag), _) => self.levels.with_level(&format!("element {tag}"), &[tag], self.of.inventory),
            (_, Some((tag, _))) => format!("node {tag}"),
            _ => return None,
        };
        let simulated = &self.fit.channels[channel];
        let touches = |d: &Device| element == Some(d.tag) || node.is_some_and(|(n, _)| d.nodes.contains(&n));
        let shown = self.histories(touches).filter_map(|(device, direction, h)| {
            let r = correlation(&h.force, simulated);
            (r * r > SAME_FORCE).then_some((device, direction, h, r.signum()))
        });
        let found = shown.max_by(|a, b| a.2.range().deformation.total_cmp(&b.2.range().deformation));
        let (sense, deformation) = match found {
            Some((device, direction, h, sign)) => {
                let (turned, name) = towards(device, direction, self.of.inventory);
                // A force along the deformation of the device resists it.
                (sign * turned, Some((h.deformation.iter().map(|u| turned * u).collect(), name)))
            }
            None => (1.0, None),
        };
        self.told(BothForces {
            place,
            elements: element.into_iter().collect(),
            channels: vec![o.channel.clone()],
            unit: o.unit.clone(),
            recorded: o.values.clone(),
            residual: self.residual(channel).iter().map(|f| sense * f).collect(),
            deformation,
        })
    }

    /// Forces of the storeys below masses whose horizontal acceleration is recorded.
    fn forces_of_storeys(&self) -> Vec<ResidualForce> {
        let inventory = self.of.inventory;
        let mut out = vec![];
        let horizontal = (1..=inventory.ndm).filter(|dof| inventory.vertical_axis() != Some(dof - 1));
        for dof in horizontal {
            // Level, mass and channel of each node.
            let mut masses: Vec<(f64, f64, usize)> = vec![];
            let mut nodes = vec![];
            for (channel, _) in self.run.observe.iter().enumerate().filter(|(_, o)| is_acceleration(o)) {
                let Some((node, _)) = node_of(self.column(channel)).filter(|(n, d)| *d == dof && !nodes.contains(n))
                else {
                    continue;
                };
                let mass = inventory.masses.iter().find(|m| m.node == node).and_then(|m| m.mass.get(dof - 1));
                if let Some((level, mass)) = self.levels.node(node).zip(mass.filter(|m| **m > 0.0)) {
                    nodes.push(node);
                    masses.push((level, *mass, channel));
                }
            }
            masses.sort_by(|a, b| a.0.total_cmp(&b.0));
            let mut begun: Option<f64> = None;
            for k in 0..masses.len() {
                let level = masses[k].0;
                if begun.is_some_and(|b| self.levels.are_equal(b, level)) {
                    continue;
                }
                begun = Some(level);
                out.extend(self.force_of_storey(dof, level, &masses[k..], &nodes));
            }
        }
        out
    }

    /// Force below a level, which resists the inertia of some masses: level, mass and channel of each.
    fn force_of_storey(
        &self,
        dof: usize,
        level: f64,
        masses: &[(f64, f64, usize)],
        nodes: &[i32],
    ) -> Option<ResidualForce> {
        let inventory = self.of.inventory;
        let crossing = self.levels.crossing(level, inventory);
        let is_crossing = |d: &Device| crossing.contains(&d.tag);
        let along = self.histories(is_crossing).filter(|(_, d, _)| d.axis[dof - 1].abs() > MIN_COMPONENT);
        let largest = along.max_by(|a, b| a.2.range().deformation.total_cmp(&b.2.range().deformation));
        let deformation = largest.map(|(device, direction, h)| {
            let upwards = if self.levels.rises(device.nodes) { 1.0 } else { -1.0 };
            let sign = upwards * direction.axis[dof - 1].signum();
            (h.deformation.iter().map(|u| sign * u).collect(), format!("+{}", AXES[dof - 1]))
        });
        let sum = |of: &dyn Fn(usize, usize) -> f64| -> Vec<f64> {
            let at = |t: usize| -masses.iter().map(|(_, mass, channel)| mass * of(*channel, t)).sum::<f64>();
            (0..self.run.recording.times.len()).map(at).collect()
        };
        let place = match &crossing[..] {
            [] => format!("what carries the masses above level {}", digits(level, 3)),
            [tag] => self.levels.with_level(&format!("element {tag}"), &[*tag], inventory),
            tags if tags.len() <= MAX_NAMED => {
                let list: Vec<String> = tags.iter().map(i32::to_string).collect();
                self.levels.with_level(&format!("elements {}", list.join(" ")), tags, inventory)
            }
            tags => self.levels.with_level(&format!("{} elements", tags.len()), tags, inventory),
        };
        let is_left_out = |m: &&Mass| {
            let carried = self.levels.node(m.node).is_some_and(|l| l > level || self.levels.are_equal(l, level));
            carried && m.mass.get(dof - 1).is_some_and(|m| *m > 0.0) && !nodes.contains(&m.node)
        };
        let place = match inventory.masses.iter().filter(is_left_out).count() {
            0 => place,
            1 => format!("{place}, less the inertia of a mass that no channel shows"),
            n => format!("{place}, less the inertia of {n} masses that no channel shows"),
        };
        self.told(BothForces {
            place,
            elements: crossing,
            channels: masses.iter().map(|(_, _, c)| self.run.observe[*c].channel.clone()).collect(),
            unit: self.of.units.force.clone(),
            recorded: sum(&|c, t| self.run.observe[c].values[t]),
            residual: sum(&|c, t| self.run.observe[c].values[t] - self.fit.channels[c][t]),
            deformation,
        })
    }

    /// Translations of devices in this run that have a history.
    fn histories<'b>(
        &'b self,
        of: impl Fn(&Device) -> bool + 'b,
    ) -> impl Iterator<Item = (&'b Device, &'b Direction, &'b ResponseHistory)> + 'b {
        let devices = self.of.inventory.devices.iter().filter(move |d| of(d));
        devices.flat_map(move |device| {
            device.directions.iter().filter(|d| d.number <= 3).filter_map(move |direction| {
                let h = self.of.responses.histories.get(&(self.number, device.tag, direction.number))?;
                (h.deformation.len() == self.run.recording.times.len()).then_some((device, direction, h))
            })
        })
    }

    /// A residual force in words; none where nothing is recorded.
    fn told(&self, both: BothForces) -> Option<ResidualForce> {
        let known: Vec<f64> = both.residual.iter().copied().filter(|f| f.is_finite()).collect();
        let recorded: Vec<f64> = both.recorded.iter().copied().filter(|f| f.is_finite()).collect();
        let mean = recorded.iter().sum::<f64>() / recorded.len().max(1) as f64;
        let deviation = power(&recorded.iter().map(|f| f - mean).collect::<Vec<f64>>()).sqrt();
        if known.is_empty() || deviation <= 0.0 {
            return None;
        }
        let times = &self.run.recording.times;
        let found = find_windows(times, &both.residual, None);
        let rms = power(&known).sqrt();
        let motion = both.deformation.as_ref().map(|(u, _)| Motion::of(times, u));
        let parts = motion.as_ref().map_or_else(Vec::new, |m| m.parts(&both.residual));
        let quadrants = motion.as_ref().map(|m| m.quadrants(&both.residual));
        let mut out = ResidualForce {
            run: self.run.name.clone(),
            place: both.place,
            elements: both.elements,
            channels: both.channels,
            unit: both.unit,
            rms,
            ratio: rms / deviation,
            windows: found.windows,
            share: found.share,
            parts,
            quadrants,
            text: [String::new(), String::new()],
            course: ForceCourse { times: times.clone(), force: both.residual, deformation: both.deformation },
        };
        out.text = [out.where_and_when(), out.at_what_motion()];
        Some(out)
    }
}

/// Sign that turns the deformation of a device so that its free node moves towards a positive global axis, and that axis.
fn towards(device: &Device, direction: &Direction, inventory: &ModelInventory) -> (f64, String) {
    let Some(along) = (0..3).find(|i| direction.axis[*i].abs() > MIN_COMPONENT) else {
        return (1.0, "the positive sense of the device".into());
    };
    let [first, second] = device.nodes.map(|n| inventory.is_held(n, along + 1));
    // The deformation is the motion of the second node against the first.
    let moving = if second && !first { -1.0 } else { 1.0 };
    (moving * direction.axis[along].signum(), format!("+{}", AXES[along]))
}

/// Correlation of two series about zero, over finite pairs; 0 where one is nothing.
fn correlation(a: &[f64], b: &[f64]) -> f64 {
    let both = || a.iter().zip(b).filter(|(a, b)| a.is_finite() && b.is_finite());
    let dot = |of: fn((&f64, &f64)) -> f64| both().map(of).sum::<f64>();
    let size = (dot(|(a, _)| a * a) * dot(|(_, b)| b * b)).sqrt();
    if size > 0.0 { dot(|(a, b)| a * b) / size } else { 0.0 }
}
