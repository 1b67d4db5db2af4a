//! Study, model and responses from which hypotheses make proposals.

use super::AddedParameter;
use crate::inspect::auxiliary_channels::axial_force_slope;
use crate::inspect::device_axes::{AxialDirection, device_axes};
use crate::inspect::inventory::{Device, ModelInventory};
use crate::inspect::response::{ResponseRange, ResponseRanges};
use hysteron_identify::study::{Role, ScoredRun, Study};
use nalgebra::{DMatrix, DVector};

/// Basis of proposals.
pub(crate) struct ProposalContext<'a> {
    /// Parts of the model.
    pub(crate) inventory: &'a ModelInventory,
    /// The study.
    pub(crate) study: &'a Study,
    /// Responses of the fitted baseline in the fitted runs.
    pub(crate) responses: &'a ResponseRanges,
    /// Channels of the fitted baseline in the fitted runs, in their order.
    pub(crate) fits: &'a [ScoredRun],
    /// Residual of the fitted baseline with its derivatives; none if they have no result.
    pub(crate) sensitivities: Option<Sensitivities<'a>>,
    /// Fitted values of all parameters of the study.
    pub(crate) values: &'a [f64],
    /// True if the times of the recordings are those of a clock, false if they count samples.
    pub(crate) has_clock: bool,
    /// Text of the script.
    pub(crate) text: &'a str,
    /// Byte up to which its commands make the model.
    pub(crate) model_end: usize,
    /// Byte ranges of the values of the user's parameters in the text, in the order of the study.
    pub(crate) value_spans: &'a [Option<(usize, usize)>],
}

/// Residual of the fitted baseline with its derivatives by the free parameters, averaged over equal parts of each channel.
#[derive(Clone, Copy)]
pub(crate) struct Sensitivities<'a> {
    /// Residuals, channel after channel.
    pub(crate) residual: &'a DVector<f64>,
    /// Derivatives by the coordinates of the unit cube; points x parameters.
    pub(crate) derivatives: &'a DMatrix<f64>,
    /// Number of points of each channel.
    pub(crate) channels: &'a [usize],
}

/// A variable with another value in every run, by which added commands distinguish the runs.
pub(super) fn distinguishing_variable(study: &Study) -> Option<String> {
    let names = study.runs[0].set.iter().map(|(n, _)| n);
    let differs = |name: &&String| {
        let values: Vec<Option<String>> = study.runs.iter().map(|r| r.text(name)).collect();
        values.iter().enumerate().all(|(i, v)| v.is_some() && !values[..i].contains(v))
    };
    names.into_iter().find(differs).cloned()
}

/// Tags of devices, separated by spaces.
pub(super) fn element_tags(devices: &[&Device]) -> String {
    devices.iter().map(|d| d.tag.to_string()).collect::<Vec<_>>().join(" ")
}

/// Devices in words.
pub(super) fn element_names(devices: &[&Device]) -> String {
    match devices {
        [one] => format!("element {}", one.tag),
        many => format!("elements {}", element_tags(many)),
    }
}

/// Devices of one kind that deform laterally, with their largest response.
pub(super) struct MovingGroup<'a> {
    pub(super) devices: Vec<&'a Device>,
    /// Option `-dir` with the directions that deform.
    pub(super) dir_option: String,
    pub(super) directions: Vec<usize>,
    /// Direction that carries the axial force.
    pub(super) axial: Option<AxialDirection>,
    /// Largest absolute deformation.
    pub(super) deformation: f64,
    /// Largest absolute force.
    pub(super) force: f64,
    /// Largest absolute rate of deformation, 1/s.
    pub(super) speed: f64,
    /// Absolute work over the run with most of it.
    pub(super) work: f64,
}

impl MovingGroup<'_> {
    /// Secant stiffness at the largest deformation.
    pub(super) fn stiffness(&self) -> f64 {
        self.force / self.deformation
    }

    /// Beginning of an `amend` command for the whole group.
    pub(super) fn amend(&self, kind: &str) -> String {
        format!("amend element {} {kind}", element_tags(&self.devices))
    }

    /// The group in words.
    pub(super) fn location(&self) -> String {
        element_names(&self.devices)
    }

    /// Command for a dashpot with force ∝ speed^power, and its parameter: the force at the largest speed of the baseline.
    /// The force has a unit that does not depend on the power, unlike the coefficient.
    pub(super) fn dashpot(&self, amend: &str, power: &str) -> (String, AddedParameter) {
        let line = format!(
            "{amend} -coefficient [expr {{$hy_force/pow({:.6e},{power})}}] -power {power} {}",
            self.speed, self.dir_option
        );
        (line, AddedParameter::log("force", 1e-4 * self.force, 3.0 * self.force, 0.05 * self.force))
    }

    /// Slope of a recorded axial force over the first deformation, divided by the mean force, in the first fitted run that
    /// has one.
    pub(super) fn recorded_axial_slope(&self, s: &ProposalContext<'_>) -> Option<f64> {
        let (tag, direction) = (self.devices[0].tag, *self.directions.first()?);
        let deformation = |n: usize| Some(&s.responses.histories.get(&(n, tag, direction))?.deformation);
        s.study.runs_of(Role::Fit).find_map(|(n, run)| axial_force_slope(run, deformation(n)?))
    }

    /// Option that names the direction of the axial force, with the sign of tension, if it is not the first.
    pub(super) fn axial_option(&self) -> String {
        match self.axial {
            Some(a) if a.tension == Some(-1.0) => format!(" -axial -{}", a.number),
            Some(a) if a.number != 1 => format!(" -axial {}", a.number),
            _ => String::new(),
        }
    }

    /// Range of the response along the axis; none without one.
    pub(super) fn axial_range(&self, s: &ProposalContext<'_>) -> Option<ResponseRange> {
        s.responses.of(&self.devices, self.axial?.number)
    }
}

/// Part of a force on which a factor acts: name, options of the amendment, and added parameters.
pub(super) type ForcePart = (&'static str, &'static str, Vec<AddedParameter>);

/// Name of the force part without the elastic share.
pub(super) const HYSTERETIC_PART: &str = "of the hysteretic part";
/// Name of the strength of that part.
pub(super) const STRENGTH: &str = "of the strength";

/// Deformation of a direction over the largest one below which it counts as unmoved.
const MIN_DEFORMATION_SHARE: f64 = 0.02;
/// Directions of a group that are considered at most.
const MAX_DIRECTIONS: usize = 2;

impl ProposalContext<'_> {
    /// Longest mean sampling interval of a recording, s.
    pub(super) fn sampling_interval(&self) -> f64 {
        let steps = self.study.runs.iter().filter(|r| r.recording.times.len() > 1).map(|r| {
            let t = &r.recording.times;
            (t[t.len() - 1] - t[0]) / (t.len() - 1) as f64
        });
        steps.fold(0.0, f64::max)
    }

    /// Length of the longest run, s.
    pub(super) fn longest_run(&self) -> f64 {
        let lengths = self.study.runs.iter().filter_map(|r| Some(r.recording.times.last()? - r.recording.times[0]));
        lengths.fold(0.0, f64::max)
    }

    /// Groups of deforming devices with a linear law, or of those without.
    ///
    /// If all devices are linear and no ground moves, these are the devices under test and count as nonlinear.
    pub(super) fn moving_groups(&self, linear: bool) -> Vec<MovingGroup<'_>> {
        let groups = self.inventory.device_groups(linear);
        let groups = if groups.is_empty() && !linear && !self.inventory.base_excited {
            self.inventory.device_groups(true)
        } else {
            groups
        };
        groups.into_iter().filter_map(|g| self.moving_group(g)).collect()
    }

    /// Groups for effects that act beside any law: the nonlinear devices, or the devices on supports where all of an
    /// excited model is linear.
    pub(super) fn moving_or_supported_groups(&self) -> Vec<MovingGroup<'_>> {
        let moving = self.moving_groups(false);
        if !moving.is_empty() || !self.inventory.base_excited {
            return moving;
        }
        self.inventory.ground_supported_groups().into_iter().filter_map(|g| self.moving_group(g)).collect()
    }

    fn moving_group<'a>(&self, devices: Vec<&'a Device>) -> Option<MovingGroup<'a>> {
        let axes = device_axes(&devices, self.inventory, self.responses);
        let all: Vec<(usize, ResponseRange)> =
            axes.lateral.iter().filter_map(|d| Some((*d, self.responses.of(&devices, *d)?))).collect();
        let most = all.iter().map(|(_, x)| x.deformation).fold(0.0, f64::max);
        let moves = |x: &ResponseRange| x.deformation > MIN_DEFORMATION_SHARE * most && x.force > 0.0;
        let moving: Vec<_> = all.into_iter().filter(|(_, x)| moves(x)).take(MAX_DIRECTIONS).collect();
        let directions: Vec<usize> = moving.iter().map(|(n, _)| *n).collect();
        if directions.is_empty() {
            return None;
        }
        let largest = |f: fn(&ResponseRange) -> f64| moving.iter().map(|(_, x)| f(x)).fold(0.0, f64::max);
        let words: Vec<String> = directions.iter().map(usize::to_string).collect();
        Some(MovingGroup {
            axial: axes.axial.filter(|_| !axes.is_single),
            dir_option: format!("-dir {}", words.join(" ")),
            directions,
            deformation: largest(|x| x.deformation),
            force: largest(|x| x.force),
            speed: largest(|x| x.speed),
            work: largest(|x| x.work),
            devices,
        })
    }
}

/// Parts of a force that a factor can act on: the whole, the hysteretic or elastic part, or both with factors of their own.
pub(super) fn force_parts(m: &MovingGroup<'_>) -> [ForcePart; 4] {
    let k = m.stiffness();
    let elastic = || AddedParameter::linear("k", 0.05 * k, 1.2 * k, 0.6 * k);
    [
        ("of the whole force", "", vec![]),
        (HYSTERETIC_PART, " -share $hy_k 0", vec![elastic()]),
        ("of the elastic part", " -share $hy_k 1 0", vec![elastic()]),
        (
            "of both parts in their own measure",
            " -share $hy_k $hy_elastic",
            vec![elastic(), AddedParameter::linear("elastic", 0.0, 5.0, 0.5)],
        ),
    ]
}

/// Strength of the hysteretic part at constant elastic stiffness: a factor moves the yield point.
pub(super) fn strength_part(m: &MovingGroup<'_>) -> ForcePart {
    let k = m.stiffness();
    (STRENGTH, " -strengthBeside $hy_k", vec![AddedParameter::linear("k", 0.0, 1.2 * k, 0.6 * k)])
}

/// Tcl words for the coordinates of a node.
pub(super) fn node_coordinates(node: i32, ndm: usize) -> String {
    (1..=ndm).map(|i| format!("[nodeCoord {node} {i}]")).collect::<Vec<_>>().join(" ")
}
