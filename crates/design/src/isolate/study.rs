//! A study that has been read with its motions and settled with its script.

use super::Properties;
use super::agreement::{Agreement, StatedValues, settle};
use super::study_file::{BearingEntry, Causes, LiveLoad, Stiffness, StudyFile, Transition};
use crate::codes::{Code, Structure};
use crate::mistake::{About as _, Mistake, Step, form_error, key};
use crate::motion::{Motion, MotionEntry, Pair, read};
use crate::performance::Performance;
use crate::scaling::scale;
use crate::spectrum::{Combination, PairSpectrum, logarithmic};
use crate::suite::extreme_factor;
use crate::target::Target;
use hysteron_tcl::diagnostic::{Diagnostic, SourceId, SourceMap, Span, nearest};
use rand::SeedableRng as _;
use rand_pcg::Pcg32;
use std::cell::RefCell;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// Bearings of one type.
#[derive(Clone, Debug, PartialEq)]
pub struct BearingType {
    /// Name, which the script finds in `isolate(Q,NAME)`.
    pub name: String,
    /// Tags of the elements.
    pub tags: Vec<i64>,
    /// Nominal characteristic strength of one bearing: the mean of the type.
    pub q_d: f64,
    /// Nominal post-elastic stiffness of one bearing, likewise.
    pub k_d: f64,
    /// Displacement at which it yields.
    pub yield_displacement: f64,
    /// Shape of the loop at the yield displacement.
    pub transition: Transition,
    /// Lateral stiffness of the substructure below one bearing along x and y; rigid without it.
    pub substructure: Option<[f64; 2]>,
    /// Factors of the lower bound.
    pub lower: Causes,
    /// Factors of the upper bound.
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

impl BearingType {
    /// As the file names it; what the script has to say is not a number.
    fn new(entry: BearingEntry) -> Self {
        let number = |v: Option<f64>| v.unwrap_or(f64::NAN);
        Self {
            q_d: number(entry.q_d),
            k_d: number(entry.k_d),
            yield_displacement: number(entry.yield_displacement),
            transition: entry.transition.unwrap_or(Transition::Smooth),
            substructure: entry.substructure.map(Stiffness::by_direction),
            name: entry.name,
            tags: entry.tags,
            lower: entry.lower,
            upper: entry.upper,
            displacement: entry.displacement,
            critical_load: entry.critical_load,
            diameter: entry.diameter,
            tension: entry.tension,
        }
    }
}

/// A floor, from the base level upwards.
#[derive(Clone, Debug, PartialEq)]
pub struct Floor {
    /// Node whose motion stands for the floor.
    pub node: i64,
    /// Weight.
    pub weight: f64,
    /// Height above the floor below; 0 at the base level.
    pub height: f64,
}

/// A study that has been read with its motions.
#[derive(Clone, Debug)]
pub struct Study {
    /// Title.
    pub title: String,
    /// Path of the script.
    pub script: PathBuf,
    /// Path of the study, and its text.
    file: (PathBuf, Arc<str>),
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
    /// Words that the study gives the target in.
    pub target_words: String,
    /// R of the structure above.
    pub response_modification: f64,
    /// Kind of structure.
    pub structure: Structure,
    /// Weight of substructures that moves with the superstructure.
    pub substructure_weight: f64,
    /// The structure above is regular.
    pub regular: bool,
    /// Factors of the bounds come from full-scale tests of the project.
    pub project_tests: bool,
    /// Live load of the load combinations.
    pub live: LiveLoad,
    /// S_MS in g for the vertical part of the load combinations.
    pub sms: Option<f64>,
    /// Periods between which the pairs are scaled.
    pub scale: Option<[f64; 2]>,
    /// Floors from the base level upwards.
    pub floors: Vec<Floor>,
    /// Beams and columns whose local end forces are listed.
    pub members: Vec<i64>,
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
    /// Weight that the bearings carry: that of the floors, or the axial forces of the bearings under gravity.
    pub weight: f64,
    /// Mass above the bearings times gravity over that weight.
    pub mass_over_weight: f64,
    /// Draws of the factors on Q_d and K_d, by draw and type of bearing.
    pub draws: Vec<Vec<[f64; 2]>>,
    /// Values of the study beside those of the script.
    pub agreement: Agreement,
    /// Remarks on the files of the motions.
    pub notes: Vec<String>,
}

/// Seed of the draws of properties.
const DRAW_SEED: u64 = 1;

/// Version of the results of an analysis: those of another one are made again.
const FORMAT: &str = "7";

/// Hash of texts.
fn fingerprint(texts: &[&str]) -> u64 {
    super::inputs::hash(texts.iter().flat_map(|t| t.bytes().chain(std::iter::once(0xff))))
}

/// All sign combinations of eccentricities, each once, so that a symmetric structure has symmetric results.
fn mirrored(eccentricities: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let mut all: Vec<[f64; 2]> = vec![];
    for [x, y] in eccentricities {
        for e in [[*x, *y], [-x, -y], [-x, *y], [*x, -y]].map(|e| e.map(|v| v + 0.0)) {
            if !all.contains(&e) {
                all.push(e);
            }
        }
    }
    all
}

fn text_of(path: &Path) -> Result<String, String> {
    hysteron_files::read_lossy(path).map_err(|e| format!("cannot read \"{}\": {e}", path.display()))
}

/// The pair of an entry, with the texts of its files added to `texts` and what is to be said about them to `notes`.
fn pair(entry: &MotionEntry, folder: &Path, texts: &mut Vec<String>, notes: &mut Vec<String>) -> Result<Pair, String> {
    let options = entry.options()?;
    let mut components: Vec<Motion> = vec![];
    for name in &entry.files {
        let path = folder.join(name);
        let bytes = hysteron_files::read_input(&path).map_err(|e| format!("cannot read \"{name}\": {e}"))?;
        let short = name.rsplit('/').next().unwrap_or(name);
        let others = RefCell::new(vec![]);
        let beside = hysteron_files::read_beside(&path);
        let noted = |name: &str| {
            let bytes = beside(name)?;
            others.borrow_mut().push(String::from_utf8_lossy(&bytes).into_owned());
            Some(bytes)
        };
        let mut found = read(short, &bytes, &options, &noted).map_err(|e| format!("\"{name}\": {e}"))?;
        texts.append(&mut others.into_inner());
        components.append(&mut found.motions);
        notes.append(&mut found.notes);
        texts.push(String::from_utf8_lossy(&bytes).into_owned());
    }
    if components.len() == 1 {
        // One component alone: the other direction has no motion.
        let name = entry.name.as_ref().unwrap_or(&components[0].name);
        notes.push(format!("{name}: one horizontal component is no pair; the other direction has no motion"));
        let rest = vec![0.0; components[0].acceleration.len()];
        components.push(Motion { name: "none".into(), azimuth: None, acceleration: rest, ..components[0].clone() });
    }
    let vertical = if components.len() == 3 { components.pop() } else { None };
    let [mut x, y] = <[Motion; 2]>::try_from(components)
        .map_err(|c| format!("the motion {:?} has {} components: expected 1, 2 or 3", entry.files, c.len()))?;
    if let Some(name) = &entry.name {
        x.name.clone_from(name);
    }
    let pair = Pair::new(x.scaled(entry.factor), y.scaled(entry.factor))?;
    match vertical {
        Some(z) => pair.with_vertical(z.scaled(entry.factor)),
        None => Ok(pair),
    }
}

/// Read a study and its motions, and settle it with its script, which runs up to its first transient analysis at each bound
/// and eccentricity. Paths are relative to the study's folder. `stop` interrupts. The text of the study becomes one of `sources`.
///
/// # Errors
/// A file cannot be read or understood, a value is out of its range, the script fails, or study and script contradict each
/// other. The message points at the value.
pub fn load(path: &Path, stop: &Arc<AtomicBool>, sources: &mut SourceMap) -> Result<Study, Box<Diagnostic>> {
    let text = text_of(path).map_err(|e| Box::new(Diagnostic::error(e)))?;
    let file = parsed(path, &text, sources)?;
    settled(file, path, &text, stop).map_err(|m| placed(&m, path, &text, sources))
}

/// The keys of a study, whose numbers and tags have a meaning by themselves.
fn parsed(path: &Path, text: &str, sources: &mut SourceMap) -> Result<StudyFile, Box<Diagnostic>> {
    let file: StudyFile = toml::from_str(text).map_err(|e| {
        let source = source_of(path, text, sources);
        let at = e.span().map(|r| Span { source, start: r.start as u32, end: r.end as u32 });
        let table = text.parse::<toml::Table>().unwrap_or_default();
        let is_other = table.contains_key("model") && !table.contains_key("script");
        let mut d = form_error(&e, text, at);
        let other =
            "a study with \"model\" is for calibrate, diagnose and learn; init --isolation writes an isolation study";
        if is_other {
            // No key of this study is meant.
            (d.help, d.suggestion) = (vec![other.into()], None);
        }
        Box::new(d)
    })?;
    match file.check() {
        Ok(()) => Ok(file),
        Err(m) => Err(placed(&m, path, text, sources)),
    }
}

/// The mistake of a study's text that shows without its files and its script, if it has one.
pub fn mistake_of_text(path: &Path, text: &str, sources: &mut SourceMap) -> Option<Box<Diagnostic>> {
    parsed(path, text, sources).err()
}

fn source_of(path: &Path, text: &str, sources: &mut SourceMap) -> SourceId {
    let name = path.display().to_string();
    sources.find(&name, text).unwrap_or_else(|| sources.add(&name, text))
}

/// A mistake at its place. One of the whole stands at the script, which the study does not fit.
fn placed(m: &Mistake, path: &Path, text: &str, sources: &mut SourceMap) -> Box<Diagnostic> {
    let source = source_of(path, text, sources);
    Box::new(m.diagnostic(text, source, &[Step::from("script")]))
}

/// A study that has been settled with its script.
fn settled(file: StudyFile, path: &Path, text: &str, stop: &Arc<AtomicBool>) -> Result<Study, Mistake> {
    let stated = StatedValues {
        bearings: file.bearing.iter().map(|b| [b.q_d, b.k_d, b.yield_displacement]).collect(),
        transitions: file.bearing.iter().map(|b| b.transition.is_some()).collect(),
        floors: file.floor.iter().map(|f| f.weight).collect(),
        heights: file.floor.iter().map(|f| f.height).collect(),
    };
    let mut texts = vec![FORMAT.to_owned()];
    let mut study = unsettled(file, path, text, &mut texts)?;
    settle(&mut study, &stated, stop)?;
    let share = study.code.value("system_adjustment", "share");
    let contacts: Vec<i64> = study.contacts().collect();
    let Study { gravity, floors, bearings, factors, eccentricities, members, .. } = &study;
    texts.push(format!(
        "{members:?} {gravity:?} {floors:?} {bearings:?} {share:?} {contacts:?} {factors:?} {eccentricities:?}"
    ));
    let texts: Vec<&str> = texts.iter().map(String::as_str).collect();
    study.fingerprint = fingerprint(&texts);
    Ok(study)
}

/// Returns true if a file is an isolation study: it names bearings.
pub fn is_isolation_study(path: &Path) -> bool {
    let table = text_of(path).ok().and_then(|text| text.parse::<toml::Table>().ok());
    table.is_some_and(|t| t.contains_key("bearing"))
}

/// A study before its script has run.
fn unsettled(file: StudyFile, path: &Path, text: &str, texts: &mut Vec<String>) -> Result<Study, Mistake> {
    let folder = path.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let script = folder.join(&file.script);
    let script_text = text_of(&script).about(|| key!["script"])?;
    let target = Target::parse(&file.target, |name| {
        hysteron_files::read_input(folder.join(name)).map_err(|e| format!("cannot read \"{name}\": {e}"))
    });
    let target = target.about(|| key!["target"])?;
    let mut notes = vec![];
    let read = |(i, m): (usize, &MotionEntry)| pair(m, folder, texts, &mut notes).about(|| key!["motion", i]);
    let mut motions = file.motion.iter().enumerate().map(read).collect::<Result<Vec<_>, _>>()?;
    if motions.iter().any(|p| p.vertical.is_some()) && !script_text.contains("isolate(az)") {
        notes.push(format!(
            "the motions have vertical components, but \"{}\" does not name isolate(az): are they applied?",
            script.display()
        ));
    }
    different(&motions)?;
    texts.push(script_text);
    texts.extend(file.motion.iter().map(MotionEntry::identity));
    let factors = match file.scale {
        Some([from, to]) => factors(&motions, &target, [from, to]).about(|| key!["scale"])?,
        None => vec![1.0; motions.len()],
    };
    let names = || motions.iter().map(|m| m.components[0].name.as_str());
    notes.extend(names().zip(&factors).filter_map(|(name, f)| extreme_factor(name, *f)));
    if file.scale.is_some() {
        let own = names().zip(&file.motion).filter(|(_, m)| m.factor.abs() != 1.0);
        notes.extend(own.map(|(name, m)| {
            format!("{name}: its factor of {} changes nothing, since scale finds the size of each motion", m.factor)
        }));
    }
    for (pair, f) in motions.iter_mut().zip(&factors) {
        pair.components.iter_mut().chain(&mut pair.vertical).for_each(|m| *m = m.scaled(*f));
    }
    let performance = Performance {
        intensity: file.intensity,
        hunt: file.ida,
        stripes: file.stripes,
        collapse: file.collapse,
        limit_states: file.limit_state,
        bounds: file.fragility_bounds,
    };
    let types: Vec<&str> = file.bearing.iter().map(|b| b.name.as_str()).collect();
    performance.check(&types, &super::BOUNDS)?;
    let floor = |f: &super::study_file::FloorEntry| Floor {
        node: f.node,
        weight: f.weight.unwrap_or(f64::NAN),
        height: f.height.unwrap_or(f64::NAN),
    };
    let code = Code::named(&file.code).about(|| key!["code"])?;
    let short = match target {
        Target::TwoPeriod { short, .. } => Some(short),
        _ => None,
    };
    Ok(Study {
        structure: file.structure.unwrap_or(code.structure),
        substructure_weight: file.substructure_weight,
        regular: file.regular,
        project_tests: file.project_tests,
        live: file.live,
        sms: file.sms.or(short),
        scale: file.scale,
        title: if file.title.is_empty() { file.script.clone() } else { file.title },
        script,
        file: (path.to_owned(), text.into()),
        fingerprint: 0,
        code,
        gravity: file.gravity,
        units: file.units,
        plan: file.plan,
        eccentricities: mirrored(&file.eccentricities),
        target,
        target_words: file.target.join(" "),
        response_modification: file.response_modification,
        members: file.members,
        floors: file.floor.iter().map(floor).collect(),
        bearings: file.bearing.into_iter().map(BearingType::new).collect(),
        motions,
        factors,
        performance,
        structure_damping: file.structure_damping,
        weight: f64::NAN,
        mass_over_weight: 1.0,
        draws: vec![],
        agreement: Agreement::default(),
        notes,
    })
}

/// Motions of a suite are different ones.
fn different(motions: &[Pair]) -> Result<(), Mistake> {
    let accelerations = |p: &Pair| p.components.iter().map(|c| c.acceleration.clone()).collect::<Vec<_>>();
    for (k, a) in motions.iter().enumerate() {
        if let Some(other) = motions[..k].iter().position(|b| accelerations(a) == accelerations(b)) {
            let [first, second] = [other, k].map(|i| format!("{} \"{}\"", i + 1, motions[i].name()));
            let message =
                format!("the motions {first} and {second} are one record: expected different ones in a suite");
            return Err(Mistake::new(key!["motion", k], message));
        }
    }
    Ok(())
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

impl Study {
    /// A mistake of the study at its place in the text.
    pub fn placed(&self, m: &Mistake, sources: &mut SourceMap) -> Box<Diagnostic> {
        placed(m, &self.file.0, &self.file.1, sources)
    }

    /// Draw factors on Q_d and K_d of types of bearings from posteriors of their tests, times the mean of the bounds' factors
    /// of aging and environment. Bearings of one type share a draw. The seed is that of the study.
    ///
    /// # Errors
    /// There is no type of a name, or its properties are those of another bearing.
    pub fn draw(&mut self, properties: &[(String, Properties)], count: usize) -> Result<(), String> {
        for (name, p) in properties {
            let Some(b) = self.bearings.iter().find(|b| b.name == *name) else {
                let names = self.bearings.iter().map(|b| b.name.as_str());
                let near = nearest(name, names).map_or(String::new(), |n| format!("; did you mean {n}?"));
                return Err(format!("there is no type of bearing \"{name}\"{near}"));
            };
            p.check([b.q_d, b.k_d]).map_err(|e| format!("posterior of {name}: {e}"))?;
        }
        let mut random = Pcg32::seed_from_u64(DRAW_SEED);
        let share = self.code.value("system_adjustment", "share").unwrap_or(1.0);
        let one = |b: &BearingType, random: &mut Pcg32| match properties.iter().find(|(name, _)| *name == b.name) {
            Some((_, p)) => {
                let drawn = p.draw([b.q_d, b.k_d], random);
                [0, 1].map(|of| drawn[of] * 0.5 * (b.lower.environment(of, share) + b.upper.environment(of, share)))
            }
            None => [1.0, 1.0],
        };
        let bearings = &self.bearings;
        self.draws = (0..count).map(|_| bearings.iter().map(|b| one(b, &mut random)).collect()).collect();
        // Results of other draws are not these.
        self.fingerprint = fingerprint(&[&self.fingerprint.to_string(), &format!("{:?}", self.draws)]);
        Ok(())
    }

    /// Factor on Q_d (0) or K_d (1) of a type of bearing at a bound.
    pub fn factor(&self, bearing: &BearingType, bound: &str, of: usize) -> f64 {
        let share = self.code.value("system_adjustment", "share").unwrap_or(1.0);
        match bound {
            "lower" => bearing.lower.factor(of, share),
            "upper" => bearing.upper.factor(of, share),
            _ => 1.0,
        }
    }

    /// Weight above the base level.
    pub fn weight_above(&self) -> f64 {
        self.weight - self.floors.first().map_or(0.0, |f| f.weight)
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

#[cfg(test)]
mod tests {
    use super::mirrored;

    #[test]
    fn eccentricities_are_mirrored_once() {
        assert_eq!(mirrored(&[[0.0, 0.0]]), [[0.0, 0.0]]);
        assert_eq!(mirrored(&[[0.0, 0.05], [0.0, -0.05]]), [[0.0, 0.05], [0.0, -0.05]]);
        assert_eq!(mirrored(&[[0.0, 0.0], [0.05, 0.05]]).len(), 5);
    }
}
