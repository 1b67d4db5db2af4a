//! What may have been left out: one cause a file.
//!
//! A hypothesis looks at the model and proposes edits of the script: a block of ordinary commands, with parameters of
//! its own, that is put behind the model; or a fault of a channel. Several proposals of a cause are different forms of
//! it; the best of them speaks for the cause. To add one: a file with a function, and a line in [`ALL`].

mod ambient_temperature;
mod axial_shear_interaction;
mod bidirectional_coupling;
mod cavitation;
mod cyclic_degradation;
mod damping;
mod foundation_flexibility;
mod friction;
mod gap_impact;
mod mullins_softening;
mod pinching;
mod rate_dependence;
mod self_heating;
mod sensor;
mod strain_stiffening;
mod superstructure_yielding;
mod torsion;
mod varying_axial_load;

use crate::candidate::sensor_fault::Correction;
use crate::inspect::auxiliary_channels::axial_over;
use crate::inspect::inventory::{Anatomy, Device};
use crate::inspect::response::Scales;
use hysteron_identify::study::{Fit, Range, Role, Scale, Study};
pub(crate) use sensor::KNOTS;
use std::fmt;
use std::sync::Arc;

/// A cause and how it is proposed.
pub struct Hypothesis {
    /// Name of the cause.
    pub cause: &'static str,
    /// What was left out, in words.
    pub says: &'static str,
    /// What would prove the claim wrong.
    pub refuted_by: &'static str,
    /// Another cause looks the same unless the tests part them.
    pub like: &'static [&'static str],
    /// It is told by time passing: where samples are only counted, its laws would fit what comes with their number.
    pub needs_clock: bool,
    propose: fn(&Sight<'_>) -> Vec<Proposal>,
}

/// All hypotheses.
pub const ALL: &[Hypothesis] = &[
    rate_dependence::HYPOTHESIS,
    self_heating::HYPOTHESIS,
    ambient_temperature::HYPOTHESIS,
    mullins_softening::HYPOTHESIS,
    cyclic_degradation::HYPOTHESIS,
    strain_stiffening::HYPOTHESIS,
    axial_shear_interaction::HYPOTHESIS,
    varying_axial_load::HYPOTHESIS,
    cavitation::HYPOTHESIS,
    bidirectional_coupling::HYPOTHESIS,
    friction::HYPOTHESIS,
    gap_impact::HYPOTHESIS,
    foundation_flexibility::HYPOTHESIS,
    superstructure_yielding::HYPOTHESIS,
    damping::HYPOTHESIS,
    torsion::HYPOTHESIS,
    pinching::HYPOTHESIS,
    sensor::GAIN,
    sensor::LAG,
    sensor::DRIFT,
    sensor::CLIPPING,
];

impl Hypothesis {
    /// Its proposals for a study.
    pub fn proposals(&self, sight: &Sight<'_>) -> Vec<Proposal> {
        (self.propose)(sight)
    }
}

/// The hypothesis of a cause.
pub fn of(cause: &str) -> Option<&'static Hypothesis> {
    ALL.iter().find(|h| h.cause == cause)
}

/// Whether one of two causes is said to look like the other.
pub fn alike(a: &str, b: &str) -> bool {
    let says = |a: &str, b: &str| of(a).is_some_and(|h| h.like.contains(&b));
    says(a, b) || says(b, a)
}

/// What hypotheses are made from.
pub struct Sight<'a> {
    /// The model.
    pub anatomy: &'a Anatomy,
    /// The study.
    pub study: &'a Study,
    /// How far things move in the fitted runs.
    pub scales: &'a Scales,
    /// The fitted runs as the user's model has them, in their order.
    pub fits: &'a [Fit],
    /// The times of the recordings are those of a clock, and not the numbers of samples.
    pub clock: bool,
}

/// A parameter that a proposal adds.
#[derive(Clone, Debug)]
pub struct Added {
    /// Its name in the script.
    pub name: String,
    /// Where it is sought.
    pub range: Range,
    /// Where the search starts.
    pub start: f64,
    /// Where it is tried as well while the others are at their start: valleys that points spread evenly would miss.
    pub also: Vec<f64>,
    /// It belongs to the fault of a channel: the model does not know it.
    pub rig: bool,
}

impl Added {
    /// Sought evenly between two values.
    pub fn linear(name: &str, lower: f64, upper: f64, start: f64) -> Self {
        Self::sought(name, Range { lower, upper, scale: Scale::Linear }, start)
    }

    /// Sought evenly in its logarithm.
    pub fn log(name: &str, lower: f64, upper: f64, start: f64) -> Self {
        Self::sought(name, Range { lower, upper, scale: Scale::Log }, start)
    }

    fn sought(name: &str, range: Range, start: f64) -> Self {
        Self { name: format!("hy_{name}"), range, start, also: vec![], rig: false }
    }
}

/// Makes the faults of channels from the values of the added parameters.
pub type Faults = Arc<dyn Fn(&[f64]) -> Vec<Correction> + Send + Sync>;

/// An edit of the model, or a fault of a channel, with its parameters.
#[derive(Clone)]
pub struct Proposal {
    /// The cause that it belongs to.
    pub cause: &'static str,
    /// The cause of a second effect beside it.
    pub second: Option<&'static str>,
    /// The form of it.
    pub form: String,
    /// What it changes.
    pub at: String,
    /// The commands, without those that declare the parameters.
    pub block: Vec<String>,
    /// Its parameters.
    pub added: Vec<Added>,
    /// Faults of channels, if it is about a sensor.
    pub faults: Option<Faults>,
    /// It follows from geometry alone and not from the form of a law: what it leaves does not come again along the stroke.
    pub exact: bool,
    /// The recording shows it by itself, whatever the model.
    pub seen: bool,
}

impl fmt::Debug for Proposal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} ({}) at {}: {:?} {:?}", self.cause, self.form, self.at, self.block, self.added)
    }
}

impl Proposal {
    /// An edit of the script.
    pub fn edit(cause: &'static str, form: &str, at: String, block: Vec<String>, added: Vec<Added>) -> Self {
        Self { cause, second: None, form: form.into(), at, block, added, faults: None, exact: false, seen: false }
    }

    /// Two proposals together; parameters of the second get names of their own.
    pub fn with(&self, other: &Self) -> Self {
        let renamed = |text: &str| text.replace("hy_", "hy2_");
        let mut both = self.clone();
        both.exact &= other.exact;
        both.seen |= other.seen;
        both.second = Some(other.cause);
        both.form = format!("{}; {}", self.form, other.form);
        both.block.extend(other.block.iter().map(|l| renamed(l)));
        both.added.extend(other.added.iter().map(|a| Added { name: renamed(&a.name), ..a.clone() }));
        let n = self.added.len();
        both.faults = match (self.faults.clone(), other.faults.clone()) {
            (None, None) => None,
            (first, second) => Some(Arc::new(move |values: &[f64]| {
                let (a, b) = values.split_at(n);
                let of = |f: &Option<Faults>, v: &[f64]| f.as_ref().map_or_else(Vec::new, |f| f(v));
                let mut all = of(&first, a);
                all.extend(of(&second, b));
                all
            })),
        };
        both
    }
}

/// Tags of a group in a row.
fn tags(group: &[&Device]) -> String {
    group.iter().map(|d| d.tag.to_string()).collect::<Vec<_>>().join(" ")
}

/// A group in words.
fn named(group: &[&Device]) -> String {
    match group {
        [one] => format!("element {}", one.tag),
        many => format!("elements {}", tags(many)),
    }
}

/// A group that moves sideways, with how far: what a hypothesis about a device needs.
struct Moved<'a> {
    group: Vec<&'a Device>,
    /// `-dir` with the directions that move.
    dir: String,
    directions: Vec<usize>,
    /// The direction that carries the axial force, if any does.
    axial: Option<usize>,
    /// Largest deformation, force, speed; work over the longest run.
    e: f64,
    q: f64,
    v: f64,
    work: f64,
}

impl Moved<'_> {
    /// Secant stiffness at the largest deformation.
    fn stiffness(&self) -> f64 {
        self.q / self.e
    }

    /// Beginning of an amend command for the whole group.
    fn amend(&self, kind: &str) -> String {
        format!("amend element {} {kind}", tags(&self.group))
    }

    fn at(&self) -> String {
        named(&self.group)
    }

    /// A command with a dashpot of a power of speed, by its force at the speed of the fitted model, with what it adds: what unit its
    /// coefficient has depends on the power.
    fn dashpot(&self, amend: &str, power: &str) -> (String, Added) {
        let line = format!(
            "{amend} -coefficient [expr {{$hy_force/pow({:.6e},{power})}}] -power {power} {}",
            self.v, self.dir
        );
        (line, Added::log("force", 1e-4 * self.q, 3.0 * self.q, 0.05 * self.q))
    }

    /// Part of its mean by which a recorded axial force grows with the first deformation, in the first fitted run that has one.
    fn axial_over(&self, s: &Sight<'_>) -> Option<f64> {
        let (tag, direction) = (self.group[0].tag, *self.directions.first()?);
        s.study.runs_of(Role::Fit).find_map(|(n, run)| axial_over(run, &s.scales.watched.get(&(n, tag, direction))?.e))
    }

    /// Option that tells an amendment which direction carries the axial force, where it is not the first.
    fn axial_word(&self) -> String {
        self.axial.filter(|d| *d != 1).map_or_else(String::new, |d| format!(" -axial {d}"))
    }
}

/// What a factor acts on.
const HYSTERETIC: &str = "of the hysteretic part";
const STRENGTH: &str = "of the strength";

/// Part of the largest force that must be there at rest for it to be called the axial load.
const LOADED: f64 = 0.1;

impl Sight<'_> {
    /// Longest time between two samples of a recording.
    fn sampling(&self) -> f64 {
        let steps = self.study.runs.iter().filter(|r| r.recording.times.len() > 1).map(|r| {
            let t = &r.recording.times;
            (t[t.len() - 1] - t[0]) / (t.len() - 1) as f64
        });
        steps.fold(0.0, f64::max)
    }

    /// Length of the longest run, s.
    fn longest(&self) -> f64 {
        let lengths = self.study.runs.iter().filter_map(|r| Some(r.recording.times.last()? - r.recording.times[0]));
        lengths.fold(0.0, f64::max)
    }

    /// Groups of devices that deform; `linear` for those that were taken as elastic. Where all of the model is elastic,
    /// a bearing under test among it, those are the devices.
    fn moved(&self, linear: bool) -> Vec<Moved<'_>> {
        let groups = self.anatomy.groups(linear);
        let groups =
            if groups.is_empty() && !linear && !self.anatomy.shaken { self.anatomy.groups(true) } else { groups };
        groups.into_iter().filter_map(|g| self.motion_of(g)).collect()
    }

    /// The same for what acts beside a device whatever its law is: where all of a model that is shaken was taken as elastic, on
    /// what stands on the ground, such as isolators.
    fn moved_or_grounded(&self) -> Vec<Moved<'_>> {
        let moved = self.moved(false);
        if !moved.is_empty() || !self.anatomy.shaken {
            return moved;
        }
        self.anatomy.grounded().into_iter().filter_map(|g| self.motion_of(g)).collect()
    }

    fn motion_of<'a>(&self, group: Vec<&'a Device>) -> Option<Moved<'a>> {
        let first = group[0];
        // A bearing has its axial direction first, and it is another matter; of a spring or a damper that lies it is not.
        let lateral = |d: &crate::inspect::inventory::Direction| {
            d.number <= 3 && (d.number > 1 || !d.upright || first.class == "ZeroLength" || first.directions.len() == 1)
        };
        let all: Vec<(usize, crate::inspect::response::Extent)> = first
            .directions
            .iter()
            .filter(|d| lateral(d))
            .filter_map(|d| Some((d.number, self.scales.of(&group, d.number)?)))
            .collect();
        let most = all.iter().map(|(_, x)| x.e).fold(0.0, f64::max);
        let moving: Vec<_> = all.into_iter().filter(|(_, x)| x.e > 0.02 * most && x.q > 0.0).take(2).collect();
        let directions: Vec<usize> = moving.iter().map(|(n, _)| *n).collect();
        if directions.is_empty() {
            return None;
        }
        let largest =
            |f: fn(&crate::inspect::response::Extent) -> f64| moving.iter().map(|(_, x)| f(x)).fold(0.0, f64::max);
        let words: Vec<String> = directions.iter().map(usize::to_string).collect();
        // Of a bearing the first; of springs along global axes the vertical one, if it carries something at rest.
        let loaded = |d: usize| self.scales.of(&group, d).is_some_and(|x| x.rest > LOADED * x.q);
        let carries = |d: &&crate::inspect::inventory::Direction| {
            let free = d.number <= 3 && !directions.contains(&d.number);
            free && (d.number == 1 && !lateral(d) || d.upright && loaded(d.number))
        };
        let axial = first.directions.iter().find(carries).map(|d| d.number);
        Some(Moved {
            axial,
            dir: format!("-dir {}", words.join(" ")),
            directions,
            e: largest(|x| x.e),
            q: largest(|x| x.q),
            v: largest(|x| x.v),
            work: largest(|x| x.work),
            group,
        })
    }

    /// Forms of a factor on a force: on all of it, on its hysteretic or its elastic part alone, or on both in a measure of
    /// their own.
    fn shares(m: &Moved<'_>) -> [(&'static str, &'static str, Vec<Added>); 4] {
        let k = m.stiffness();
        let part = || Added::linear("k", 0.05 * k, 1.2 * k, 0.6 * k);
        [
            ("of the whole force", "", vec![]),
            (HYSTERETIC, " -share $hy_k 0", vec![part()]),
            ("of the elastic part", " -share $hy_k 1 0", vec![part()]),
            (
                "of both parts in their own measure",
                " -share $hy_k $hy_elastic",
                vec![part(), Added::linear("elastic", 0.0, 5.0, 0.5)],
            ),
        ]
    }
}

/// Form of a factor on the strength of the hysteretic part, which keeps its elastic stiffness: what yields does so earlier.
fn of_strength(m: &Moved<'_>) -> (&'static str, &'static str, Vec<Added>) {
    let k = m.stiffness();
    (STRENGTH, " -strengthBeside $hy_k", vec![Added::linear("k", 0.0, 1.2 * k, 0.6 * k)])
}

/// Tcl that gives the coordinates of a node.
fn coordinates(node: i32, ndm: usize) -> String {
    (1..=ndm).map(|i| format!("[nodeCoord {node} {i}]")).collect::<Vec<_>>().join(" ")
}
