//! The file of an isolation study: its keys, and what can be said of them without the script.

use crate::codes::Structure;
use crate::mistake::{Mistake, Step, key};
use crate::motion::MotionEntry;
use crate::performance::{Collapse, Hunt, Intensity, LimitState, Stripes};
use serde::Deserialize;
use std::collections::BTreeSet;

/// Factors of one bound on Q_d and K_d, by their causes. They are multiplied.
#[derive(Clone, Debug, Deserialize, PartialEq)]
#[serde(deny_unknown_fields, default)]
pub struct Causes {
    /// Aging.
    pub aging: [f64; 2],
    /// Temperature.
    pub temperature: [f64; 2],
    /// Velocity.
    pub velocity: [f64; 2],
    /// Cumulative travel.
    pub travel: [f64; 2],
    /// Contamination.
    pub contamination: [f64; 2],
    /// Scragging.
    pub scragging: [f64; 2],
    /// Tests.
    pub test: [f64; 2],
    /// Specification.
    pub specification: [f64; 2],
}

impl Default for Causes {
    fn default() -> Self {
        let one = [1.0, 1.0];
        Self {
            aging: one,
            temperature: one,
            velocity: one,
            travel: one,
            contamination: one,
            scragging: one,
            test: one,
            specification: one,
        }
    }
}

impl Causes {
    /// Factor on Q_d (0) or K_d (1): [1 + share (product of aging and environment - 1)] times those of test and
    /// specification.
    pub fn factor(&self, of: usize, share: f64) -> f64 {
        let tested = self.velocity[of] * self.scragging[of] * self.test[of] * self.specification[of];
        self.environment(of, share) * tested
    }

    /// The part of aging and environment in it.
    pub fn environment(&self, of: usize, share: f64) -> f64 {
        let environment = [&self.aging, &self.temperature, &self.travel, &self.contamination];
        let product: f64 = environment.iter().map(|c| c[of]).product();
        1.0 + share * (product - 1.0)
    }

    /// The factors with the names of their causes.
    pub(super) fn all(&self) -> [(&'static str, [f64; 2]); 8] {
        let Self { aging, temperature, velocity, travel, contamination, scragging, test, specification } = *self;
        [
            ("aging", aging),
            ("temperature", temperature),
            ("velocity", velocity),
            ("travel", travel),
            ("contamination", contamination),
            ("scragging", scragging),
            ("test", test),
            ("specification", specification),
        ]
    }
}

/// Shape of the loops of a type of bearing at the yield displacement.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "lowercase")]
pub enum Transition {
    /// The loop turns at once, as that of a slider.
    Abrupt,
    /// The corner is rounded.
    Smooth,
}

impl Transition {
    /// Its word in a study.
    pub fn name(self) -> &'static str {
        match self {
            Self::Abrupt => "abrupt",
            Self::Smooth => "smooth",
        }
    }
}

/// Lateral stiffness of a substructure: the same along and across a bridge, or of both.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(untagged)]
pub(super) enum Stiffness {
    /// In any direction.
    Same(f64),
    /// Along x and y.
    ByDirection([f64; 2]),
}

impl Stiffness {
    pub(super) fn by_direction(self) -> [f64; 2] {
        match self {
            Self::Same(k) => [k; 2],
            Self::ByDirection(k) => k,
        }
    }
}

/// Bearings of one type, as the file names them.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct BearingEntry {
    /// Name, which the script finds in `isolate(Q,NAME)` and `isolate(K,NAME)`.
    pub(super) name: String,
    /// Tags of the elements.
    pub(super) tags: Vec<i64>,
    /// Nominal characteristic strength of one bearing; the script's without it.
    pub(super) q_d: Option<f64>,
    /// Nominal post-elastic stiffness of one bearing; the script's without it.
    pub(super) k_d: Option<f64>,
    /// Yield displacement; the script's without it.
    pub(super) yield_displacement: Option<f64>,
    /// Shape of the loops, `abrupt` or `smooth`; as tested without it.
    pub(super) transition: Option<Transition>,
    /// Lateral stiffness of the substructure below one bearing, for the simplified method of bridges: one number, or those along x
    /// and y; rigid without it.
    pub(super) substructure: Option<Stiffness>,
    /// Factors of the lower bound on Q_d and K_d, by cause.
    #[serde(default)]
    pub(super) lower: Causes,
    /// Factors of the upper bound on Q_d and K_d, by cause.
    #[serde(default)]
    pub(super) upper: Causes,
    /// Displacement capacity.
    pub(super) displacement: Option<f64>,
    /// Critical load without displacement, compression positive.
    pub(super) critical_load: Option<f64>,
    /// Diameter, for the overlapping area under a displacement.
    pub(super) diameter: Option<f64>,
    /// Tension that it can bear.
    pub(super) tension: Option<f64>,
}

/// Live load beside the dead load that a script applies under gravity.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct LiveLoad {
    /// Full live load over dead load.
    pub over_dead: f64,
    /// Share of the live load that the script applies.
    pub in_script: f64,
}

impl Default for LiveLoad {
    fn default() -> Self {
        Self { over_dead: 0.0, in_script: 0.0 }
    }
}

/// A floor, as the file names it.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct FloorEntry {
    /// Node whose motion stands for the floor.
    pub(super) node: i64,
    /// Weight; without it the mass of the script at its elevation times `gravity`.
    pub(super) weight: Option<f64>,
    /// Height above the floor below, which the base level has not; without it that of the script's nodes.
    pub(super) height: Option<f64>,
}

fn one() -> f64 {
    1.0
}

fn yes() -> bool {
    true
}

fn no_eccentricity() -> Vec<[f64; 2]> {
    vec![[0.0, 0.0]]
}

/// All keys.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct StudyFile {
    /// Title of the report; the name of the script without it.
    #[serde(default)]
    pub(super) title: String,
    /// Path of the script.
    pub(super) script: String,
    /// Code of the checks: `asce7-16`, `asce7-22`, `aashto` or `en1998`.
    #[serde(default = "default_code")]
    pub(super) code: String,
    /// Kind of structure, `building` or `bridge`; that of the code without it.
    pub(super) structure: Option<Structure>,
    /// Acceleration of gravity in the units of the script.
    pub(super) gravity: f64,
    /// Names of the units of force and length.
    #[serde(default)]
    pub(super) units: [String; 2],
    /// Plan dimensions b and d.
    pub(super) plan: Option<[f64; 2]>,
    /// Accidental eccentricities as shares of the plan, mirrored.
    #[serde(default = "no_eccentricity")]
    pub(super) eccentricities: Vec<[f64; 2]>,
    /// Words of the target spectrum.
    pub(super) target: Vec<String>,
    /// Periods between which pairs are scaled; not scaled without them.
    pub(super) scale: Option<[f64; 2]>,
    /// Response modification coefficient R of the structure above.
    #[serde(default = "one")]
    pub(super) response_modification: f64,
    /// Weight of substructures that moves with the superstructure, for the simplified method of bridges.
    #[serde(default)]
    pub(super) substructure_weight: f64,
    /// True if the structure above is regular.
    #[serde(default = "yes")]
    pub(super) regular: bool,
    /// True if the factors of the bounds come from full-scale tests of the project.
    #[serde(default)]
    pub(super) project_tests: bool,
    /// Live load of the load combinations.
    #[serde(default)]
    pub(super) live: LiveLoad,
    /// S_MS in g for the vertical part of the load combinations; that of the target without it.
    pub(super) sms: Option<f64>,
    /// Floors from the base level upwards.
    #[serde(default)]
    pub(super) floor: Vec<FloorEntry>,
    /// Types of bearings.
    pub(super) bearing: Vec<BearingEntry>,
    /// Pairs of ground motions.
    pub(super) motion: Vec<MotionEntry>,
    /// Beams and columns whose local end forces are listed by load combination.
    #[serde(default)]
    pub(super) members: Vec<i64>,
    /// Measure of the intensity of a pair.
    #[serde(default)]
    pub(super) intensity: Intensity,
    /// Levels of intensity by hunting for collapse.
    pub(super) ida: Option<Hunt>,
    /// The same levels of intensity for all records.
    pub(super) stripes: Option<Stripes>,
    /// Limits beyond which an analysis counts as collapsed.
    #[serde(default)]
    pub(super) collapse: Collapse,
    /// Limit states of fragility.
    #[serde(default)]
    pub(super) limit_state: Vec<LimitState>,
    /// Bounds of incremental analyses and stripes.
    #[serde(default = "nominal")]
    pub(super) fragility_bounds: Vec<String>,
    /// Damping of the structure above in modal analyses, as a share of critical.
    #[serde(default = "structure_damping")]
    pub(super) structure_damping: f64,
}

fn nominal() -> Vec<String> {
    vec!["nominal".into()]
}

fn structure_damping() -> f64 {
    0.05
}

fn default_code() -> String {
    "asce7-16".into()
}

fn positive(key: Vec<Step>, what: &str, x: f64) -> Result<(), Mistake> {
    let wrong = || Mistake::new(key, format!("{what} is {x}: expected more than 0"));
    if x > 0.0 && x.is_finite() { Ok(()) } else { Err(wrong()) }
}

fn not_negative(key: Vec<Step>, what: &str, x: f64) -> Result<(), Mistake> {
    let wrong = || Mistake::new(key, format!("{what} is {x}: expected 0 or more"));
    if x >= 0.0 && x.is_finite() { Ok(()) } else { Err(wrong()) }
}

impl StudyFile {
    /// Check numbers and tags by themselves.
    ///
    /// # Errors
    /// One of them has no meaning. The message names it.
    pub(super) fn check(&self) -> Result<(), Mistake> {
        positive(key!["gravity"], "gravity", self.gravity)?;
        positive(key!["response_modification"], "response_modification", self.response_modification)?;
        not_negative(key!["live", "over_dead"], "live.over_dead", self.live.over_dead)?;
        not_negative(key!["substructure_weight"], "substructure_weight", self.substructure_weight)?;
        not_negative(key!["live", "in_script"], "live.in_script", self.live.in_script)?;
        self.sms.map_or(Ok(()), |s| not_negative(key!["sms"], "sms", s))?;
        if !(0.0..1.0).contains(&self.structure_damping) {
            let message = format!("structure_damping is {}: expected 0 to less than 1", self.structure_damping);
            return Err(Mistake::new(key!["structure_damping"], message));
        }
        if self.bearing.is_empty() || self.motion.is_empty() || self.eccentricities.is_empty() {
            return Err("expected at least one [[bearing]], one [[motion]] and one eccentricity".into());
        }
        let outside = |e: &[f64; 2]| e.iter().any(|x| x.is_nan() || x.abs() > 0.5);
        if let Some((i, e)) = self.eccentricities.iter().enumerate().find(|(_, e)| outside(e)) {
            let message =
                format!("the eccentricity {e:?} is outside of the plan: expected shares of the plan, at most 0.5");
            return Err(Mistake::new(key!["eccentricities", i], message));
        }
        let mut tags = BTreeSet::new();
        for (kind, b) in self.bearing.iter().enumerate() {
            for (i, tag) in b.tags.iter().enumerate() {
                if !tags.insert(*tag) {
                    let message = format!("the bearing {tag} is listed twice");
                    return Err(Mistake::new(key!["bearing", kind, "tags", i], message));
                }
            }
        }
        self.bearing.iter().enumerate().try_for_each(|(kind, b)| b.check(kind))?;
        for (i, f) in self.floor.iter().enumerate() {
            if let Some(weight) = f.weight {
                positive(key!["floor", i, "weight"], &format!("the weight of the floor at node {}", f.node), weight)?;
            }
        }
        for (i, f) in self.floor.iter().enumerate().skip(1) {
            let what = format!("the height of the floor at node {}", f.node);
            f.height.map_or(Ok(()), |h| positive(key!["floor", i, "height"], &what, h))?;
        }
        Ok(())
    }
}

impl BearingEntry {
    /// Check the numbers of a type, the one with this number from 0.
    fn check(&self, kind: usize) -> Result<(), Mistake> {
        let stated = [("q_d", self.q_d), ("k_d", self.k_d), ("yield_displacement", self.yield_displacement)];
        for (name, value) in stated {
            // A flat slider has no post-elastic stiffness, a rubber bearing without lead no strength.
            let what = format!("{name} of {}", self.name);
            value.map_or(Ok(()), |v| not_negative(key!["bearing", kind, name], &what, v))?;
        }
        for k in self.substructure.iter().flat_map(|k| k.by_direction()) {
            positive(key!["bearing", kind, "substructure"], &format!("substructure of {}", self.name), k)?;
        }
        if self.tags.is_empty() {
            let message = format!("the bearings {} have no tags", self.name);
            return Err(Mistake::new(key!["bearing", kind, "tags"], message));
        }
        for (bound, causes) in [("lower", &self.lower), ("upper", &self.upper)] {
            for (cause, f) in causes.all().iter().flat_map(|(cause, f)| f.map(|f| (cause, f))) {
                positive(key!["bearing", kind, bound, *cause], &format!("a factor of {}", self.name), f)?;
            }
        }
        Ok(())
    }
}
