//! What a study means: its file checked, its recordings read.

use super::file::{ObserveTable, ParameterTable, RunTable, StudyFile};
use super::parameter::{Parameter, Range, Scale, Source, Space};
use super::recording::Recording;
use super::run::{Observe, Role, Run, Setting};
use exmex::Express as _;
use hysteron_tcl::diagnostic::{Diagnostic, SourceId, SourceMap, Span, nearest};
use std::fs;
use std::path::{Path, PathBuf};
use toml::Spanned;

/// A study: a script, its parameters, and the runs that were recorded.
#[derive(Clone, Debug)]
pub struct Study {
    /// What it is about; empty for none.
    pub title: String,
    /// The folder of its file, an absolute path: relative paths are relative to it.
    pub folder: PathBuf,
    /// The file of the study, as it was given.
    pub file: PathBuf,
    /// The script, relative to the folder.
    pub model: String,
    /// The parameters.
    pub space: Space,
    /// The runs, in the order of the file.
    pub runs: Vec<Run>,
    /// How the parameters are to be found.
    pub calibration: Calibration,
    /// Limits of the laboratory.
    pub rig: Option<Rig>,
    /// Where the name of each parameter stands, for messages.
    pub(super) names: Vec<Span>,
    /// What is odd, without being wrong.
    pub warnings: Vec<Diagnostic>,
}

/// How the parameters are to be found, as far as the study says.
#[derive(Clone, Debug, Default)]
pub struct Calibration {
    /// Name of the method and where it stands.
    pub method: Option<(String, Span)>,
    /// Members of the population.
    pub population: Option<usize>,
    /// Generations.
    pub generations: Option<usize>,
    /// Mutation constant F.
    pub f: Option<f64>,
    /// Crossover constant CR.
    pub cr: Option<f64>,
    /// Seed of the random numbers.
    pub seed: Option<u64>,
    /// How often it is done, each time with another seed.
    pub repeats: Option<usize>,
    /// Most evaluations.
    pub evaluations: Option<usize>,
    /// Whether the best is improved by least squares at the end.
    pub polish: Option<bool>,
    /// Most seconds that a run may take.
    pub time_limit: Option<f64>,
}

/// Limits of the laboratory, in the script's units.
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

/// Why a study is refused; the texts that the message points into are in the [`SourceMap`] given.
pub type Rejected = Box<Diagnostic>;

/// Where the words of the file are.
struct Places {
    source: SourceId,
}

impl Places {
    fn span<T>(&self, s: &Spanned<T>) -> Span {
        let range = s.span();
        Span { source: self.source, start: range.start as u32, end: range.end as u32 }
    }

    fn refuse<T>(&self, s: &Spanned<T>, message: impl Into<String>, label: impl Into<String>) -> Rejected {
        Box::new(Diagnostic::error(message).at(Some(self.span(s)), label))
    }

    /// A finite number within a range; the range is told as it is given.
    fn number(
        &self,
        what: &str,
        s: &Spanned<f64>,
        good: impl Fn(f64) -> bool,
        expected: &str,
    ) -> Result<f64, Rejected> {
        let x = *s.get_ref();
        if x.is_finite() && good(x) { Ok(x) } else { Err(self.refuse(s, format!("{what} is {x}"), expected)) }
    }

    fn count(&self, what: &str, s: &Option<Spanned<i64>>, least: i64) -> Result<Option<usize>, Rejected> {
        let Some(s) = s else { return Ok(None) };
        match usize::try_from(*s.get_ref()) {
            Ok(n) if n as i64 >= least => Ok(Some(n)),
            _ => {
                let message = format!("{what} is {}", s.get_ref());
                Err(self.refuse(s, message, format!("expected a whole number not less than {least}")))
            }
        }
    }

    /// A word that must be one of several.
    fn choice<'a>(&self, what: &str, s: &Spanned<String>, known: &[&'a str]) -> Result<&'a str, Rejected> {
        let word = s.get_ref();
        if let Some(k) = known.iter().find(|k| *k == word) {
            return Ok(k);
        }
        let mut d = self.refuse(s, format!("unknown {what} \"{word}\""), format!("expected {}", known.join(" or ")));
        if let Some(near) = nearest(word, known.iter().copied()) {
            d.help.push(format!("did you mean \"{near}\"?"));
        }
        Err(d)
    }
}

impl Study {
    /// Read a study and its recordings. Texts that messages point into are added to `sources`.
    ///
    /// # Errors
    /// What is wrong, with its place.
    pub fn load(file: &Path, sources: &mut SourceMap) -> Result<Self, Rejected> {
        let shown = file.display();
        let unreadable = |e: std::io::Error| Box::new(Diagnostic::error(format!("cannot read {shown}: {e}")));
        let text = fs::read_to_string(file).map_err(unreadable)?;
        let folder = file.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
        let folder = folder.canonicalize().map_err(unreadable)?;
        let source = sources.add(&shown.to_string(), &text);
        let parsed: StudyFile = toml::from_str(&text).map_err(|e| syntax(&e, source))?;
        let places = Places { source };
        let (parameters, names) = parameters(&places, &parsed.parameter)?;
        let space = Space::new(parameters).map_err(|cyclic| {
            let name = &parsed.parameter[cyclic].get_ref().name;
            places.refuse(name, format!("the formula of {} depends on itself", name.get_ref()), "tied in a circle")
        })?;
        if space.dimension() == 0 {
            let message = "no parameter is to be found: none has bounds";
            return Err(Box::new(Diagnostic::error(message).at(Some(places.span(&parsed.model)), "in this study")));
        }
        let mut warnings = vec![];
        let mut runs: Vec<Run> = vec![];
        for table in &parsed.run {
            let known: Vec<&str> = runs.iter().map(|r| r.name.as_str()).collect();
            let name = &table.get_ref().name;
            if known.contains(&name.get_ref().as_str()) {
                let message = format!("there are two runs named \"{}\"", name.get_ref());
                return Err(places.refuse(name, message, "expected another name"));
            }
            runs.push(run(&places, &folder, table, &space, sources, &mut warnings)?);
        }
        if !runs.iter().any(|r| r.role == Role::Fit) {
            let message = "no run has the role \"fit\"";
            return Err(Box::new(Diagnostic::error(message).at(Some(places.span(&parsed.model)), "in this study")));
        }
        let model = parsed.model.get_ref().clone();
        if !folder.join(&model).is_file() {
            return Err(places.refuse(&parsed.model, format!("there is no script {model}"), "expected a file"));
        }
        Ok(Self {
            title: parsed.title.clone().unwrap_or_default(),
            folder,
            file: file.to_owned(),
            model,
            space,
            runs,
            calibration: calibration(&places, &parsed)?,
            rig: rig(&places, &parsed)?,
            names,
            warnings,
        })
    }

    /// Absolute path of a file that the study or its script names relative to the study's folder.
    pub fn absolute(&self, file: &str) -> String {
        match file.starts_with('/') {
            true => file.to_owned(),
            false => format!("{}/{}", self.folder_text().trim_end_matches('/'), file.trim_start_matches("./")),
        }
    }

    /// The runs of a role, with their numbers.
    pub fn runs_of(&self, role: Role) -> impl Iterator<Item = (usize, &Run)> {
        self.runs.iter().enumerate().filter(move |(_, r)| r.role == role)
    }

    /// The folder as scripts write paths.
    pub(super) fn folder_text(&self) -> String {
        self.folder.to_string_lossy().replace('\\', "/")
    }
}

/// An error of the reader of TOML, with the nearest name where one is unknown.
fn syntax(e: &toml::de::Error, source: SourceId) -> Rejected {
    let message = e.message().trim();
    let span = e.span().map(|r| Span { source, start: r.start as u32, end: r.end as u32 });
    let mut quoted = message.split('`').skip(1).step_by(2);
    let unknown = message.starts_with("unknown field").then(|| quoted.next()).flatten();
    let known: Vec<&str> = quoted.collect();
    let mut d = Diagnostic::error(message.lines().next().unwrap_or_default()).at(span, "");
    if let Some(word) = unknown {
        d.message = format!("unknown key \"{word}\"");
        d.label = format!("expected one of {}", known.join(", "));
        if let Some(near) = nearest(word, known.iter().copied()) {
            d = d.help(format!("did you mean \"{near}\"?"));
        }
    }
    Box::new(d)
}

fn parameters(places: &Places, tables: &[Spanned<ParameterTable>]) -> Result<(Vec<Parameter>, Vec<Span>), Rejected> {
    let all: Vec<&str> = tables.iter().map(|t| t.get_ref().name.get_ref().as_str()).collect();
    let mut out: Vec<Parameter> = vec![];
    for table in tables {
        let t = table.get_ref();
        let name = t.name.get_ref().clone();
        if out.iter().any(|p| p.name == name) {
            return Err(places.refuse(
                &t.name,
                format!("there are two parameters \"{name}\""),
                "expected another name",
            ));
        }
        let given = [t.value.is_some(), t.expr.is_some()].iter().filter(|g| **g).count();
        let source = match (&t.value, &t.expr) {
            _ if given > 1 => {
                return Err(places.refuse(&t.name, format!("{name} has both a value and a formula"), "expected one"));
            }
            (Some(value), _) => Source::Fixed(places.number(&name, value, |_| true, "expected a number")?),
            (_, Some(formula)) => tied(places, t, formula, &all)?,
            (None, None) => Source::Free(range(places, t)?),
        };
        out.push(Parameter { name, source });
    }
    Ok((out, tables.iter().map(|t| places.span(&t.get_ref().name)).collect()))
}

fn range(places: &Places, t: &ParameterTable) -> Result<Range, Rejected> {
    let name = t.name.get_ref();
    let (Some(lower), Some(upper)) = (&t.lower, &t.upper) else {
        let missing = if t.lower.is_none() { "lower" } else { "upper" };
        let message = format!("parameter {name} has no {missing} bound");
        return Err(places.refuse(&t.name, message, "expected lower and upper, or value, or expr"));
    };
    let scale = match &t.scale {
        Some(s) if places.choice("scale", s, &["linear", "log"])? == "log" => Scale::Log,
        _ => Scale::Linear,
    };
    let low = places.number(&format!("the lower bound of {name}"), lower, |_| true, "expected a number")?;
    let above = format!("expected more than the lower bound, {low}");
    let high = places.number(&format!("the upper bound of {name}"), upper, |x| x > low, &above)?;
    if scale == Scale::Log && low <= 0.0 {
        let message = format!("the lower bound of {name} is {low}");
        return Err(places.refuse(lower, message, "expected more than 0, since the scale is logarithmic"));
    }
    Ok(Range { lower: low, upper: high, scale })
}

fn tied(places: &Places, t: &ParameterTable, formula: &Spanned<String>, all: &[&str]) -> Result<Source, Rejected> {
    let text = formula.get_ref();
    let wrong = |why: String| places.refuse(formula, why, "expected a formula such as 0.5*a/b");
    let parsed = exmex::parse::<f64>(text).map_err(|e| wrong(format!("\"{text}\" is no formula: {e}")))?;
    let mut of = vec![];
    for name in parsed.var_names() {
        match all.iter().position(|a| a == name) {
            Some(i) => of.push(i),
            None => {
                let mut d = places.refuse(formula, format!("there is no parameter {name}"), "expected a parameter");
                if let Some(near) = nearest(name, all.iter().copied()) {
                    d.help.push(format!("did you mean \"{near}\"?"));
                }
                return Err(d);
            }
        }
    }
    let lower = t.lower.as_ref().map_or(f64::NEG_INFINITY, |l| *l.get_ref());
    let upper = t.upper.as_ref().map_or(f64::INFINITY, |u| *u.get_ref());
    Ok(Source::Tied { text: text.clone(), formula: Box::new(parsed), of, within: (lower, upper) })
}

fn run(
    places: &Places,
    folder: &Path,
    table: &Spanned<RunTable>,
    space: &Space,
    sources: &mut SourceMap,
    warnings: &mut Vec<Diagnostic>,
) -> Result<Run, Rejected> {
    let t = table.get_ref();
    let name = t.name.get_ref().clone();
    let role = match &t.role {
        Some(r) if places.choice("role", r, &["fit", "holdout"])? == "holdout" => Role::Holdout,
        _ => Role::Fit,
    };
    let mut set = vec![];
    for (key, value) in &t.set {
        if space.parameters.iter().any(|p| p.name == *key.get_ref()) {
            let message = format!("{} is set in run \"{name}\" and is a parameter", key.get_ref());
            return Err(places.refuse(key, message, "expected in one place only"));
        }
        set.push((key.get_ref().clone(), setting(places, value)?));
    }
    let path = t.recording.get_ref();
    let text = fs::read_to_string(folder.join(path))
        .map_err(|e| places.refuse(&t.recording, format!("cannot read {path}: {e}"), "expected a file"))?;
    let recording = Recording::parse(path, &text, sources)?;
    if t.observe.is_empty() {
        return Err(places.refuse(&t.name, format!("run \"{name}\" observes nothing"), "expected a [[run.observe]]"));
    }
    let observe = t.observe.iter().map(|o| observe(places, o.get_ref(), &recording, path, warnings));
    Ok(Run { role, set, observe: observe.collect::<Result<_, _>>()?, recording, name })
}

fn setting(places: &Places, value: &Spanned<toml::Value>) -> Result<Setting, Rejected> {
    let wrong = || places.refuse(value, "a Tcl variable cannot be set to this", "expected a text, a number or a list");
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

fn observe(
    places: &Places,
    o: &ObserveTable,
    recording: &Recording,
    path: &str,
    warnings: &mut Vec<Diagnostic>,
) -> Result<Observe, Rejected> {
    let channel = o.channel.get_ref();
    let Some(column) = recording.column(channel) else {
        let known: Vec<&str> = recording.columns.iter().map(|c| c.name.as_str()).collect();
        let mut d = places.refuse(&o.channel, format!("{path} has no column {channel}"), "expected a column of it");
        match nearest(channel, known.iter().copied()) {
            Some(near) => d.help.push(format!("did you mean \"{near}\"?")),
            None => d.help.push(format!("it has {}", known.join(", "))),
        }
        return Err(d);
    };
    let weight = match &o.weight {
        Some(w) => places.number("the weight", w, |x| x >= 0.0, "expected a number not less than 0")?,
        None => 1.0,
    };
    let at = usize::try_from(*o.column.get_ref())
        .map_err(|_| places.refuse(&o.column, format!("the column is {}", o.column.get_ref()), "expected 0, 1, ..."))?;
    let there: Vec<f64> = column.values.iter().copied().filter(|v| !v.is_nan()).collect();
    let n = there.len() as f64;
    let mean = there.iter().sum::<f64>() / n;
    let variance = there.iter().map(|v| (v - mean) * (v - mean)).sum::<f64>() / n;
    if there.len() < 2 || variance == 0.0 {
        let message = format!("{channel} of {path} never changes ({} samples)", there.len());
        return Err(places.refuse(&o.channel, message, "expected a channel with a variance"));
    }
    let missing = column.values.len() - there.len();
    if missing > 0 {
        let message = format!("{missing} of {} samples of {channel} in {path} are missing", column.values.len());
        warnings.push(Diagnostic::warning(message).at(Some(places.span(&o.channel)), "left out"));
    }
    Ok(Observe {
        channel: channel.clone(),
        unit: column.unit.clone(),
        output: o.output.get_ref().clone(),
        column: at,
        at: o.at.clone().unwrap_or_default(),
        weight,
        values: column.values.clone(),
        variance,
    })
}

fn calibration(places: &Places, file: &StudyFile) -> Result<Calibration, Rejected> {
    let c = &file.calibration;
    let optional = |what: &str, s: &Option<Spanned<f64>>, good: fn(f64) -> bool, expected: &str| {
        s.as_ref().map(|s| places.number(what, s, good, expected)).transpose()
    };
    Ok(Calibration {
        method: c.method.as_ref().map(|m| (m.get_ref().clone(), places.span(m))),
        population: places.count("the population", &c.population, 4)?,
        generations: places.count("the number of generations", &c.generations, 1)?,
        f: optional("F", &c.f, |x| x > 0.0 && x <= 2.0, "expected a number greater than 0, not more than 2")?,
        cr: optional("CR", &c.cr, |x| (0.0..=1.0).contains(&x), "expected a number from 0 to 1")?,
        seed: places.count("the seed", &c.seed, 0)?.map(|n| n as u64),
        repeats: places.count("the number of repeats", &c.repeats, 1)?,
        evaluations: places.count("the number of evaluations", &c.evaluations, 1)?,
        polish: c.polish,
        time_limit: optional("the limit of time", &c.time_limit, |x| x > 0.0, "expected seconds, more than 0")?,
    })
}

fn rig(places: &Places, file: &StudyFile) -> Result<Option<Rig>, Rejected> {
    let Some(r) = &file.rig else { return Ok(None) };
    let positive = |what: &str, s: &Option<Spanned<f64>>| {
        s.as_ref().map(|s| places.number(what, s, |x| x > 0.0, "expected a number greater than 0")).transpose()
    };
    if let Some(t) = &r.temperature {
        let [low, high] = *t.get_ref();
        if !(low <= high && low > -273.15 && high.is_finite()) {
            let message = format!("the temperatures of the rig are {low} and {high}");
            return Err(places.refuse(t, message, "expected the lowest and the highest, in °C"));
        }
    }
    Ok(Some(Rig {
        stroke: positive("the stroke", &r.stroke)?,
        speed: positive("the speed", &r.speed)?,
        force: positive("the force", &r.force)?,
        temperature: r.temperature.as_ref().map(|t| *t.get_ref()),
    }))
}
