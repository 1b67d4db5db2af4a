//! The file of an isolation study.

use crate::codes::Code;
use crate::motion::{Motion, Pair, ReadOptions, read};
use crate::performance::{Collapse, Hunt, Intensity, LimitState, Performance, Stripes};
use crate::scaling::scale;
use crate::spectrum::{Combination, PairSpectrum, logarithmic};
use crate::target::Target;
use serde::Deserialize;
use std::path::{Path, PathBuf};

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
        let environment = [&self.aging, &self.temperature, &self.travel, &self.contamination];
        let product: f64 = environment.iter().map(|c| c[of]).product();
        let tested = self.velocity[of] * self.scragging[of] * self.test[of] * self.specification[of];
        (1.0 + share * (product - 1.0)) * tested
    }

    fn all(&self) -> [[f64; 2]; 8] {
        let Self { aging, temperature, velocity, travel, contamination, scragging, test, specification } = self;
        [*aging, *temperature, *velocity, *travel, *contamination, *scragging, *test, *specification]
    }
}

/// Bearings of one type.
#[derive(Clone, Debug, Deserialize, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct BearingType {
    /// Name, which the script finds in `isolate(Q,NAME)`.
    pub name: String,
    /// Tags of the elements.
    pub tags: Vec<i64>,
    /// Nominal characteristic strength of one bearing.
    pub q_d: f64,
    /// Nominal post-elastic stiffness of one bearing.
    pub k_d: f64,
    /// Displacement at which it yields.
    #[serde(default)]
    pub yield_displacement: f64,
    /// Factors of the lower bound.
    #[serde(default)]
    pub lower: Causes,
    /// Factors of the upper bound.
    #[serde(default)]
    pub upper: Causes,
    /// Displacement capacity.
    pub displacement: Option<f64>,
    /// Critical load without displacement, compression positive.
    pub critical_load: Option<f64>,
    /// Diameter for the overlapping area under a displacement.
    pub diameter: Option<f64>,
    /// Tension that it can bear.
    pub tension: Option<f64>,
}

/// A floor, from the base level upwards.
#[derive(Clone, Debug, Deserialize, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct Floor {
    /// Node whose motion stands for the floor.
    pub node: i64,
    /// Weight.
    pub weight: f64,
    /// Height above the floor below; not needed at the base level.
    #[serde(default)]
    pub height: f64,
}

/// One pair of records.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct MotionEntry {
    name: Option<String>,
    files: Vec<String>,
    #[serde(default = "one")]
    factor: f64,
    unit: Option<String>,
    dt: Option<f64>,
}

fn one() -> f64 {
    1.0
}

fn no_eccentricity() -> Vec<[f64; 2]> {
    vec![[0.0, 0.0]]
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct StudyFile {
    #[serde(default)]
    title: String,
    script: String,
    #[serde(default = "default_code")]
    code: String,
    /// Acceleration of gravity in the units of the script.
    gravity: f64,
    /// Names of the units of force and length.
    #[serde(default)]
    units: [String; 2],
    /// Plan dimensions b and d.
    plan: Option<[f64; 2]>,
    #[serde(default = "no_eccentricity")]
    eccentricities: Vec<[f64; 2]>,
    /// Words of the target spectrum.
    target: Vec<String>,
    /// Periods between which pairs are scaled; not scaled without them.
    scale: Option<[f64; 2]>,
    /// Response modification coefficient of the structure above.
    #[serde(default = "one")]
    response_modification: f64,
    #[serde(default)]
    floor: Vec<Floor>,
    bearing: Vec<BearingType>,
    motion: Vec<MotionEntry>,
    #[serde(default)]
    intensity: Intensity,
    ida: Option<Hunt>,
    stripes: Option<Stripes>,
    #[serde(default)]
    collapse: Collapse,
    #[serde(default)]
    limit_state: Vec<LimitState>,
    /// Bounds of incremental analyses and stripes.
    #[serde(default = "nominal")]
    fragility_bounds: Vec<String>,
    /// Damping of the structure above in modal analyses.
    #[serde(default = "structure_damping")]
    structure_damping: f64,
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

/// A study that has been read with its motions.
#[derive(Clone, Debug)]
pub struct Study {
    /// Title.
    pub title: String,
    /// Path of the script.
    pub script: PathBuf,
    /// Hash of the script, the records and all that an analysis gets from the study.
    pub fingerprint: u64,
    /// Code of the checks.
    pub code: Code,
    /// Acceleration of gravity in the units of the script.
    pub gravity: f64,
    /// Names of the units of force and length.
    pub units: [String; 2],
    /// Plan dimensions.
    pub plan: Option<[f64; 2]>,
    /// Accidental eccentricities as shares of the plan.
    pub eccentricities: Vec<[f64; 2]>,
    /// Target spectrum of 5 % damping.
    pub target: Target,
    /// R of the structure above.
    pub response_modification: f64,
    /// Floors from the base level upwards.
    pub floors: Vec<Floor>,
    /// Types of bearings.
    pub bearings: Vec<BearingType>,
    /// Pairs, scaled, in m/s².
    pub motions: Vec<Pair>,
    /// Factors that the pairs are scaled by.
    pub factors: Vec<f64>,
    /// Levels of intensity and limit states.
    pub performance: Performance,
    /// Damping of the structure above in modal analyses, as a share of critical.
    pub structure_damping: f64,
}

/// Version of the results of an analysis: those of another one are made again.
const FORMAT: &str = "2";

/// Hash of texts.
fn fingerprint(texts: &[&str]) -> u64 {
    super::inputs::hash(texts.iter().flat_map(|t| t.bytes().chain(std::iter::once(0xff))))
}

fn positive(what: &str, x: f64) -> Result<(), String> {
    if x > 0.0 && x.is_finite() { Ok(()) } else { Err(format!("{what} is {x}: expected more than 0")) }
}

/// Read a study and its motions; paths are relative to its folder.
///
/// # Errors
/// A file cannot be read or understood, or a value is out of its range. The message names it.
pub fn load(path: &Path) -> Result<Study, String> {
    let text_of = |p: &Path| hysteron_files::read_lossy(p).map_err(|e| format!("cannot read \"{}\": {e}", p.display()));
    let text = text_of(path)?;
    let file: StudyFile = toml::from_str(&text).map_err(|e| format!("\"{}\": {e}", path.display()))?;
    let folder = path.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let script = folder.join(&file.script);
    let script_text = text_of(&script)?;
    check(&file)?;
    let target = Target::parse(&file.target, |name| text_of(&folder.join(name)))?;
    let mut motions = vec![];
    let mut texts = vec![FORMAT.to_owned(), script_text];
    for entry in &file.motion {
        let options = ReadOptions { unit: entry.unit.clone(), dt: entry.dt };
        let mut components: Vec<Motion> = vec![];
        for name in &entry.files {
            let text = text_of(&folder.join(name))?;
            let short = name.rsplit('/').next().unwrap_or(name);
            components.extend(read(short, &text, &options).map_err(|e| format!("\"{name}\": {e}"))?);
            texts.push(text);
        }
        if components.len() == 1 {
            // One component alone: the other direction rests.
            let rest = vec![0.0; components[0].acceleration.len()];
            components.push(Motion { name: "none".into(), azimuth: None, acceleration: rest, ..components[0].clone() });
        }
        let [mut x, y] = <[Motion; 2]>::try_from(components)
            .map_err(|c| format!("the motion {:?} has {} components: expected 1 or 2", entry.files, c.len()))?;
        if let Some(name) = &entry.name {
            x.name.clone_from(name);
        }
        motions.push(Pair::new(x.scaled(entry.factor), y.scaled(entry.factor))?);
    }
    let factors = match file.scale {
        Some([from, to]) => factors(&motions, &target, [from, to])?,
        None => vec![1.0; motions.len()],
    };
    for (pair, f) in motions.iter_mut().zip(&factors) {
        pair.components.iter_mut().for_each(|m| *m = m.scaled(*f));
    }
    let code = Code::named(&file.code)?;
    let (gravity, floors, bearings) = (file.gravity, &file.floor, &file.bearing);
    let share = code.value("system_adjustment", "share");
    let contacts: Vec<i64> = file.limit_state.iter().flat_map(|l| l.elements.iter().copied()).collect();
    texts.push(format!(
        "{gravity:?} {floors:?} {bearings:?} {share:?} {contacts:?} {factors:?} {:?}",
        file.eccentricities
    ));
    texts.extend(file.motion.iter().map(|m| format!("{m:?}")));
    let types: Vec<&str> = file.bearing.iter().map(|b| b.name.as_str()).collect();
    let performance = Performance {
        intensity: file.intensity,
        hunt: file.ida,
        stripes: file.stripes,
        collapse: file.collapse,
        limit_states: file.limit_state,
        bounds: file.fragility_bounds,
    };
    performance.check(&types, &super::BOUNDS)?;
    let texts: Vec<&str> = texts.iter().map(String::as_str).collect();
    Ok(Study {
        title: if file.title.is_empty() { file.script.clone() } else { file.title },
        script,
        fingerprint: fingerprint(&texts),
        code,
        gravity: file.gravity,
        units: file.units,
        plan: file.plan,
        eccentricities: file.eccentricities,
        target,
        response_modification: file.response_modification,
        floors: file.floor,
        bearings: file.bearing,
        motions,
        factors,
        performance,
        structure_damping: file.structure_damping,
    })
}

fn factors(motions: &[Pair], target: &Target, [from, to]: [f64; 2]) -> Result<Vec<f64>, String> {
    if !(from > 0.0 && to > from) {
        return Err(format!("scale = [{from}, {to}]: expected rising periods above 0"));
    }
    let periods = logarithmic(from, to, 40);
    let wanted: Vec<f64> = periods.iter().map(|t| target.at(*t)).collect();
    let spectra: Vec<Vec<f64>> =
        motions.iter().map(|p| PairSpectrum::new(p, &periods, 0.05).combined(Combination::RotD100)).collect();
    Ok(scale(&spectra, &wanted, None)?.factors)
}

fn check(file: &StudyFile) -> Result<(), String> {
    positive("gravity", file.gravity)?;
    positive("response_modification", file.response_modification)?;
    if !(0.0..1.0).contains(&file.structure_damping) {
        return Err(format!("structure_damping is {}: expected 0 to less than 1", file.structure_damping));
    }
    if file.bearing.is_empty() || file.motion.is_empty() || file.eccentricities.is_empty() {
        return Err("expected at least one [[bearing]], one [[motion]] and one eccentricity".into());
    }
    let mut tags: Vec<i64> = file.bearing.iter().flat_map(|b| b.tags.iter().copied()).collect();
    tags.sort_unstable();
    if let Some(w) = tags.windows(2).find(|w| w[0] == w[1]) {
        return Err(format!("the bearing {} is listed twice", w[0]));
    }
    for b in &file.bearing {
        positive(&format!("q_d of {}", b.name), b.q_d)?;
        positive(&format!("k_d of {}", b.name), b.k_d)?;
        if b.tags.is_empty() {
            return Err(format!("the bearings {} have no tags", b.name));
        }
        for f in b.lower.all().iter().chain(&b.upper.all()).flatten() {
            positive(&format!("a factor of {}", b.name), *f)?;
        }
    }
    for f in &file.floor {
        positive(&format!("the weight of the floor at node {}", f.node), f.weight)?;
    }
    for f in file.floor.iter().skip(1) {
        positive(&format!("the height of the floor at node {}", f.node), f.height)?;
    }
    Ok(())
}

impl Study {
    /// Factor on Q_d (0) or K_d (1) of a type of bearing at a bound.
    pub fn factor(&self, bearing: &BearingType, bound: &str, of: usize) -> f64 {
        let share = self.code.value("system_adjustment", "share").unwrap_or(1.0);
        match bound {
            "lower" => bearing.lower.factor(of, share),
            "upper" => bearing.upper.factor(of, share),
            _ => 1.0,
        }
    }

    /// Weight on the bearings; none without floors.
    pub fn weight(&self) -> Option<f64> {
        let sum: f64 = self.floors.iter().map(|f| f.weight).sum();
        (sum > 0.0).then_some(sum)
    }

    /// Elements of contact, each once.
    pub fn contacts(&self) -> impl Iterator<Item = i64> + '_ {
        let all: std::collections::BTreeSet<i64> =
            self.performance.limit_states.iter().flat_map(|l| l.elements.iter().copied()).collect();
        all.into_iter()
    }

    /// Length of a meter in the units of the script.
    pub fn meter(&self) -> f64 {
        self.gravity / crate::motion::G
    }
}
