//! Reading a study: its file is checked, and its recordings are read.

use super::channel::read_channel;
use super::checks;
use super::material::DeviceMaterial;
use super::parameter::{Parameter, ParameterKind, ParameterRange, ParameterSpace, Scale};
use super::run::{Role, Run, Setting};
use super::study_file::{ParameterTable, RunTable, SourceSpans, StudyFile, StudySpans};
use super::unknown_key::UnknownKey;
use exmex::Express as _;
use hysteron_recordings::{Layout, Recording, UserStatements, Way};
use hysteron_tcl::diagnostic::{Diagnostic, SourceId, SourceMap, Span, nearest};
use std::path::{Path, PathBuf};
use toml::Spanned;

/// A study: a script, its parameters, and the recorded runs.
#[derive(Clone, Debug)]
pub struct Study {
    /// Title; empty for none.
    pub title: String,
    /// Absolute path of the folder of its file. Relative paths start from it.
    pub folder: PathBuf,
    /// Path of the file of the study, as given by the user.
    pub file: PathBuf,
    /// Path of the script, relative to the folder.
    pub model: String,
    /// The parameters.
    pub space: ParameterSpace,
    /// The runs, in the order of the file.
    pub runs: Vec<Run>,
    /// Options of the calibration.
    pub calibration: CalibrationOptions,
    /// Limits of the laboratory.
    pub rig: Option<Rig>,
    /// Material of the devices; none if the study does not say.
    pub material: Option<DeviceMaterial>,
    /// Locations of its words, for messages.
    pub(super) spans: StudySpans,
    /// Warnings about the study and its recordings.
    pub warnings: Vec<Diagnostic>,
}

/// Options of the calibration; `None` where the study leaves the default.
#[derive(Clone, Debug, Default)]
pub struct CalibrationOptions {
    /// Name of the method, and its location in the file.
    pub method: Option<(String, Span)>,
    /// Size of the population.
    pub population: Option<usize>,
    /// Number of generations.
    pub generations: Option<usize>,
    /// Mutation constant F.
    pub f: Option<f64>,
    /// Crossover constant CR.
    pub cr: Option<f64>,
    /// Seed of the random numbers.
    pub seed: Option<u64>,
    /// Number of searches, each with another seed.
    pub repeats: Option<usize>,
    /// Greatest number of evaluations.
    pub evaluations: Option<usize>,
    /// Least squares start from the best point at the end.
    pub polish: Option<bool>,
    /// Greatest time of a run, in s.
    pub time_limit: Option<f64>,
}

/// Limits of the test rig, in the units of the script.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Rig {
    /// Greatest displacement.
    pub stroke: Option<f64>,
    /// Greatest speed.
    pub speed: Option<f64>,
    /// Greatest force.
    pub force: Option<f64>,
    /// Lowest and highest temperature in °C.
    pub temperature: Option<[f64; 2]>,
}

/// The error of a study. The texts that its message points into are in the [`SourceMap`] of the call.
pub type StudyError = Box<Diagnostic>;

/// The error of a file that cannot be read.
fn unreadable(file: &Path, e: &std::io::Error) -> StudyError {
    Box::new(Diagnostic::error(format!("cannot read {}: {e}", file.display())))
}

impl Study {
    /// Read a study and its recordings. Texts that messages point into are added to `sources`.
    ///
    /// # Errors
    /// The study or a recording cannot be read, or has a mistake. The message has its location.
    pub fn load(file: &Path, sources: &mut SourceMap) -> Result<Self, StudyError> {
        let text = hysteron_files::read_text(file).map_err(|e| unreadable(file, &e))?;
        Self::parse(file, &text, sources)
    }

    /// Read a study whose file has, or is to have, this text. Its recordings are read from their files.
    ///
    /// # Errors
    /// As [`Study::load`].
    pub fn parse(file: &Path, text: &str, sources: &mut SourceMap) -> Result<Self, StudyError> {
        let folder = file.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
        let folder = folder.canonicalize().map_err(|e| unreadable(file, &e))?;
        let source = sources.add(&file.display().to_string(), text);
        let parsed: StudyFile = toml::from_str(text).map_err(|e| syntax_error(&e, text, source))?;
        let spans = SourceSpans::new(source);
        let parameters = read_parameters(&spans, &parsed.parameter)?;
        let space = ParameterSpace::new(parameters).map_err(|cyclic| {
            let name = &parsed.parameter[cyclic].get_ref().name;
            spans.error(name, format!("the formula of {} depends on itself", name.get_ref()), "tied in a circle")
        })?;
        if space.dimension() == 0 {
            let message = "no parameter is to be found: none has bounds";
            return Err(Box::new(Diagnostic::error(message).at(Some(spans.span(&parsed.model)), "in this study")));
        }
        let mut warnings = vec![];
        let mut runs: Vec<Run> = vec![];
        for table in &parsed.run {
            let known: Vec<&str> = runs.iter().map(|r| r.name.as_str()).collect();
            let name = &table.get_ref().name;
            if known.contains(&name.get_ref().as_str()) {
                let message = format!("there are two runs named \"{}\"", name.get_ref());
                return Err(spans.error(name, message, "expected another name"));
            }
            runs.push(read_run(&spans, &folder, table, &space, sources, &mut warnings)?);
        }
        if !runs.iter().any(|r| r.role == Role::Fit) {
            let message = "no run has the role \"fit\"";
            return Err(Box::new(Diagnostic::error(message).at(Some(spans.span(&parsed.model)), "in this study")));
        }
        warnings.extend(checks::check_runs(&runs, space.dimension(), spans.span(&parsed.model))?);
        let model = parsed.model.get_ref().clone();
        if !folder.join(&model).is_file() {
            return Err(spans.error(&parsed.model, format!("there is no script {model}"), "expected a file"));
        }
        Ok(Self {
            title: parsed.title.clone().unwrap_or_default(),
            folder,
            file: file.to_owned(),
            model,
            space,
            runs,
            calibration: read_calibration_options(&spans, &parsed)?,
            rig: read_rig(&spans, &parsed)?,
            material: read_material(&spans, &parsed)?,
            spans: StudySpans::new(&spans, &parsed),
            warnings,
        })
    }

    /// Absolute path of a file that the study or its script names relative to the folder of the study.
    pub fn absolute(&self, file: &str) -> String {
        match file.starts_with('/') {
            true => file.to_owned(),
            false => format!("{}/{}", self.folder_text().trim_end_matches('/'), file.trim_start_matches("./")),
        }
    }

    /// Index and run for all runs of a role.
    pub fn runs_of(&self, role: Role) -> impl Iterator<Item = (usize, &Run)> {
        self.runs.iter().enumerate().filter(move |(_, r)| r.role == role)
    }

    /// Location of a channel in the file of the study: that of the observed channel of a run, or of its recording.
    pub fn channel_location(&self, run: &str, channel: &str) -> Option<Span> {
        let number = self.runs.iter().position(|r| r.name == run)?;
        let observed = self.runs[number].observe.iter().position(|o| o.channel == channel);
        let observed = observed.and_then(|at| self.spans.channel(number, at)).map(|s| s.channel);
        observed.or_else(|| self.spans.recording(number))
    }

    /// The folder with the separators of Tcl.
    pub(super) fn folder_text(&self) -> String {
        self.folder.to_string_lossy().replace('\\', "/")
    }
}

/// The message for an error of the TOML parser. Unknown keys come with the nearest known one.
fn syntax_error(e: &toml::de::Error, text: &str, source: SourceId) -> StudyError {
    let message = e.message().trim();
    let span = e.span().map(|r| Span { source, start: r.start as u32, end: r.end as u32 });
    let mut d = Diagnostic::error(message.lines().next().unwrap_or_default()).at(span, "");
    if let Some(unknown) = UnknownKey::of(e) {
        d = unknown.diagnostic(span).label(format!("expected one of {}", unknown.known.join(", ")));
        let table = text.parse::<toml::Table>().unwrap_or_default();
        if table.contains_key("script") && !table.contains_key("model") {
            d = d.help(
                "a study with \"script\" is an isolation study: isolate, ida, fragility and response-spectrum run it",
            );
        }
    }
    Box::new(d)
}

/// Parameters of the study.
fn read_parameters(spans: &SourceSpans, tables: &[Spanned<ParameterTable>]) -> Result<Vec<Parameter>, StudyError> {
    let names: Vec<&str> = tables.iter().map(|t| t.get_ref().name.get_ref().as_str()).collect();
    let mut parameters: Vec<Parameter> = vec![];
    for table in tables {
        let t = table.get_ref();
        let name = t.name.get_ref().clone();
        if parameters.iter().any(|p| p.name == name) {
            return Err(spans.error(&t.name, format!("there are two parameters \"{name}\""), "expected another name"));
        }
        let kind = match (&t.value, &t.expr) {
            (Some(_), Some(_)) => {
                return Err(spans.error(&t.name, format!("{name} has both a value and a formula"), "expected one"));
            }
            (Some(value), None) => ParameterKind::Fixed(spans.number(&name, value, |_| true, "expected a number")?),
            (None, Some(formula)) => read_tied(spans, t, formula, &names)?,
            (None, None) => ParameterKind::Free(read_range(spans, t)?),
        };
        parameters.push(Parameter { name, kind });
    }
    Ok(parameters)
}

/// Range of a free parameter.
fn read_range(spans: &SourceSpans, t: &ParameterTable) -> Result<ParameterRange, StudyError> {
    let name = t.name.get_ref();
    let (Some(lower), Some(upper)) = (&t.lower, &t.upper) else {
        let missing = if t.lower.is_none() { "lower" } else { "upper" };
        let message = format!("parameter {name} has no {missing} bound");
        return Err(spans.error(&t.name, message, "expected lower and upper, or value, or expr"));
    };
    let scale = match &t.scale {
        Some(s) if spans.choice("scale", s, &["linear", "log"])? == "log" => Scale::Log,
        _ => Scale::Linear,
    };
    let low = spans.number(&format!("the lower bound of {name}"), lower, |_| true, "expected a number")?;
    let above = format!("expected more than the lower bound, {low}");
    let high = spans.number(&format!("the upper bound of {name}"), upper, |x| x > low, &above)?;
    if scale == Scale::Log && low <= 0.0 {
        let message = format!("the lower bound of {name} is {low}");
        return Err(spans.error(lower, message, "expected more than 0, since the scale is logarithmic"));
    }
    Ok(ParameterRange { lower: low, upper: high, scale })
}

/// Formula of a tied parameter.
fn read_tied(
    spans: &SourceSpans,
    t: &ParameterTable,
    formula: &Spanned<String>,
    names: &[&str],
) -> Result<ParameterKind, StudyError> {
    let text = formula.get_ref();
    let wrong = |why: String| spans.error(formula, why, "expected a formula such as 0.5*a/b");
    let parsed = exmex::parse::<f64>(text).map_err(|e| wrong(format!("\"{text}\" is no formula: {e}")))?;
    let mut arguments = vec![];
    for name in parsed.var_names() {
        match names.iter().position(|n| n == name) {
            Some(i) => arguments.push(i),
            None => {
                let mut d = spans.error(formula, format!("there is no parameter {name}"), "expected a parameter");
                d.add_suggestion(name, nearest(name, names.iter().copied()));
                return Err(d);
            }
        }
    }
    let lower = t.lower.as_ref().map_or(f64::NEG_INFINITY, |l| *l.get_ref());
    let upper = t.upper.as_ref().map_or(f64::INFINITY, |u| *u.get_ref());
    Ok(ParameterKind::Tied { text: text.clone(), formula: Box::new(parsed), arguments, bounds: (lower, upper) })
}

/// A run with its recording.
fn read_run(
    spans: &SourceSpans,
    folder: &Path,
    table: &Spanned<RunTable>,
    space: &ParameterSpace,
    sources: &mut SourceMap,
    warnings: &mut Vec<Diagnostic>,
) -> Result<Run, StudyError> {
    let t = table.get_ref();
    let name = t.name.get_ref().clone();
    let role = match &t.role {
        Some(r) if spans.choice("role", r, &["fit", "holdout"])? == "holdout" => Role::Holdout,
        _ => Role::Fit,
    };
    let mut set = vec![];
    for (key, value) in &t.set {
        if space.parameters.iter().any(|p| p.name == *key.get_ref()) {
            let message = format!("{} is set in run \"{name}\" and is a parameter", key.get_ref());
            return Err(spans.error(key, message, "expected in one place only"));
        }
        set.push((key.get_ref().clone(), read_setting(spans, value)?));
    }
    let path = t.recording.get_ref();
    let bytes = hysteron_files::read_input(folder.join(path))
        .map_err(|e| spans.error(&t.recording, format!("cannot read {path}: {e}"), "expected a file"))?;
    let told = read_told(spans, t)?;
    let beside = hysteron_files::read_beside(folder.join(path));
    let recording = Recording::read_told(path, &bytes, &told, &beside, sources).map_err(|mut d| {
        if d.span.is_none() {
            (d.span, d.label) = (Some(spans.span(&t.recording)), "expected comma-separated values".into());
        }
        d
    })?;
    if t.observe.is_empty() {
        return Err(spans.error(&t.name, format!("run \"{name}\" observes nothing"), "expected a [[run.observe]]"));
    }
    let observe = t.observe.iter().map(|o| read_channel(spans, o.get_ref(), &recording, path, warnings));
    Ok(Run { role, set, observe: observe.collect::<Result<_, _>>()?, recording, name })
}

/// What a run says about a recording that does not say it.
fn read_told(spans: &SourceSpans, t: &RunTable) -> Result<UserStatements, StudyError> {
    let dt = t.dt.as_ref();
    let dt = dt.map(|dt| spans.number("the step", dt, |x| x > 0.0, "expected a step in s, more than 0")).transpose()?;
    let layout = match &t.layout {
        Some(word) => Some(Layout::named(word.get_ref()).map_err(|e| spans.error(word, e.message, &e.expected))?),
        None => None,
    };
    Ok(UserStatements { unit: t.unit.clone(), dt, quantity: t.quantity.clone(), layout, way: Way::Study })
}

/// Value of a variable that a run sets.
fn read_setting(spans: &SourceSpans, value: &Spanned<toml::Value>) -> Result<Setting, StudyError> {
    let wrong = || spans.error(value, "a Tcl variable cannot be set to this", "expected a text, a number or a list");
    let text = |v: &toml::Value| match v {
        toml::Value::String(s) => Some(s.clone()),
        toml::Value::Integer(i) => Some(i.to_string()),
        toml::Value::Float(x) => Some(format!("{x:?}")),
        toml::Value::Boolean(b) => Some(i32::from(*b).to_string()),
        _ => None,
    };
    Ok(match value.get_ref() {
        toml::Value::String(s) => Setting::Text(s.clone()),
        toml::Value::Integer(i) => Setting::Whole(*i),
        toml::Value::Float(x) if x.is_finite() => Setting::Number(*x),
        toml::Value::Boolean(b) => Setting::Whole(i64::from(*b)),
        toml::Value::Array(list) => Setting::List(list.iter().map(text).collect::<Option<_>>().ok_or_else(wrong)?),
        _ => return Err(wrong()),
    })
}

/// The table `[calibration]`.
fn read_calibration_options(spans: &SourceSpans, file: &StudyFile) -> Result<CalibrationOptions, StudyError> {
    let c = &file.calibration;
    let optional = |what: &str, s: &Option<Spanned<f64>>, good: fn(f64) -> bool, expected: &str| {
        s.as_ref().map(|s| spans.number(what, s, good, expected)).transpose()
    };
    Ok(CalibrationOptions {
        method: c.method.as_ref().map(|m| (m.get_ref().clone(), spans.span(m))),
        population: spans.count("the population", &c.population, 4)?,
        generations: spans.count("the number of generations", &c.generations, 1)?,
        f: optional("F", &c.f, |x| x > 0.0 && x <= 2.0, "expected a number greater than 0, not more than 2")?,
        cr: optional("CR", &c.cr, |x| (0.0..=1.0).contains(&x), "expected a number from 0 to 1")?,
        seed: spans.count("the seed", &c.seed, 0)?.map(|n| n as u64),
        repeats: spans.count("the number of repeats", &c.repeats, 1)?,
        evaluations: spans.count("the number of evaluations", &c.evaluations, 1)?,
        polish: c.polish,
        time_limit: optional("the limit of time", &c.time_limit, |x| x > 0.0, "expected seconds, more than 0")?,
    })
}

/// The key `material`.
fn read_material(spans: &SourceSpans, file: &StudyFile) -> Result<Option<DeviceMaterial>, StudyError> {
    let Some(word) = &file.material else { return Ok(None) };
    let name = spans.choice("material", word, &DeviceMaterial::ALL.map(DeviceMaterial::name))?;
    Ok(DeviceMaterial::ALL.into_iter().find(|m| m.name() == name))
}

/// The table `[rig]`.
fn read_rig(spans: &SourceSpans, file: &StudyFile) -> Result<Option<Rig>, StudyError> {
    let Some(r) = &file.rig else { return Ok(None) };
    let positive = |what: &str, s: &Option<Spanned<f64>>| {
        s.as_ref().map(|s| spans.number(what, s, |x| x > 0.0, "expected a number greater than 0")).transpose()
    };
    if let Some(t) = &r.temperature {
        let [low, high] = *t.get_ref();
        if !(low <= high && low > -273.15 && high.is_finite()) {
            let message = format!("the temperatures of the rig are {low} and {high}");
            return Err(spans.error(t, message, "expected the lowest and the highest, in °C"));
        }
    }
    Ok(Some(Rig {
        stroke: positive("the stroke", &r.stroke)?,
        speed: positive("the speed", &r.speed)?,
        force: positive("the force", &r.force)?,
        temperature: r.temperature.as_ref().map(|t| *t.get_ref()),
    }))
}
