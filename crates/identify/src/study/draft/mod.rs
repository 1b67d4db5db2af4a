//! A first study for a script and recordings: what can be told from both, with comments on how sure it is.

mod matching;
mod text;

use super::initial_run::RunLimits;
use super::load::{CalibrationOptions, Study, StudyError};
use super::parameter::ParameterSpace;
use super::run::{Role, Run, Setting};
use super::script_simulator::{RunMode, ScriptSimulator, UnobservedTraces};
use super::study_file::StudySpans;
use super::trace::Trace;
use hysteron_engine::analysis::Options;
use hysteron_opensees::run::End;
use hysteron_recordings::unit::Quantity;
use hysteron_recordings::{Recording, UserStatements, Way};
use hysteron_tcl::diagnostic::{Diagnostic, SourceMap, VARIABLE};
use hysteron_tcl::top_level;
use matching::{Candidate, Match};
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use std::time::Duration;

/// Longest time of a run of the script.
const MAX_TIME: Duration = Duration::from_secs(60);

/// Extensions of files that a motion may be in.
const MOTION_FILES: [&str; 4] = ["dat", "txt", "at2", "th"];

/// A recording of the draft with what its run of the script shows.
struct DraftRun {
    name: String,
    /// Path of the recording, relative to the folder of the study.
    path: String,
    recording: Recording,
    /// Variables that the run sets.
    set: Vec<(String, String)>,
    /// Variables of these that were guessed, since the script has no values of them.
    guessed: Vec<String>,
    /// The reason why the run of the script has no outputs.
    failure: Option<String>,
    /// The variable for want of which the script ended.
    unknown_variable: Option<String>,
    /// A match for each column of the recording.
    matches: Vec<Option<Match>>,
    /// Quantities of the outputs of the script that are known.
    recorded: Vec<Quantity>,
}

/// Values of variables and parameters after a run of the script.
#[derive(Default)]
struct ScriptValues {
    variables: BTreeMap<String, String>,
    /// Declared parameters in the order of their declarations.
    parameters: Vec<(String, f64)>,
}

/// The text of a study of a script with recordings, for a file in `folder`. The script runs once for each recording, at
/// most a minute, with its recorders in memory.
///
/// # Errors
/// A file cannot be read, or a recording has a mistake. Texts that the message points into are added to `sources`.
pub fn draft_study(
    model: &Path,
    recordings: &[PathBuf],
    folder: &Path,
    stop: &Arc<AtomicBool>,
    sources: &mut SourceMap,
) -> Result<String, StudyError> {
    let unreadable =
        |p: &Path, e: std::io::Error| Box::new(Diagnostic::error(format!("cannot read {}: {e}", p.display())));
    let folder = folder.canonicalize().map_err(|e| unreadable(folder, e))?;
    let relative = |path: &Path| hysteron_files::path_from(&folder, path).map_err(|e| unreadable(path, e));
    let bytes = hysteron_files::read_input(model).map_err(|e| unreadable(model, e))?;
    let text = String::from_utf8(bytes).map_err(|_| unreadable(model, std::io::ErrorKind::InvalidData.into()))?;
    let outline = ScriptOutline::of(&text);
    let model = relative(model)?;
    let mut runs: Vec<DraftRun> = vec![];
    for path in recordings {
        let shown = path.display().to_string();
        let bytes = hysteron_files::read_input(path).map_err(|e| unreadable(path, e))?;
        let told = UserStatements { way: Way::Study, ..UserStatements::default() };
        let beside = hysteron_files::read_beside(path);
        let recording = Recording::read_told(&shown, &bytes, &told, &beside, sources)?;
        let stem = path.file_stem().map_or("run".into(), |s| s.to_string_lossy().into_owned());
        let taken = |name: &str| runs.iter().any(|r| r.name == name);
        let name = (1..).map(|n| if n == 1 { stem.clone() } else { format!("{stem}-{n}") }).find(|n| !taken(n));
        let (name, path) = (name.unwrap_or(stem), relative(path)?);
        runs.push(DraftRun {
            name,
            path,
            recording,
            set: vec![],
            guessed: vec![],
            failure: None,
            unknown_variable: None,
            matches: vec![],
            recorded: vec![],
        });
    }
    let mut draft = Draft { folder, model, outline, stop: stop.clone(), values: ScriptValues::default() };
    // The first run shows the script's own values of the variables that a run may set.
    draft.run(&mut runs, 0);
    for number in 0..runs.len() {
        runs[number].set = draft.settings(&runs[number]);
        if number > 0 || !runs[number].set.is_empty() {
            draft.run(&mut runs, number);
        }
        while let Some((name, value)) = draft.missing_variable(&runs[number]) {
            runs[number].guessed.push(name.clone());
            runs[number].set.push((name, value));
            draft.run(&mut runs, number);
        }
    }
    Ok(text::study_text(&draft, &runs))
}

/// The script of a draft.
struct Draft {
    folder: PathBuf,
    model: String,
    outline: ScriptOutline,
    stop: Arc<AtomicBool>,
    values: ScriptValues,
}

impl Draft {
    /// Variables that a run sets: one whose value in the script is a file, if there is such a file with the name of the
    /// recording.
    fn settings(&self, run: &DraftRun) -> Vec<(String, String)> {
        let stem = Path::new(&run.path).file_stem().unwrap_or_default();
        let of_recording = |name: &String| {
            let own = Path::new(self.values.variables.get(name)?);
            let file = own.with_file_name(stem).with_extension(own.extension()?);
            let is_there = self.folder.join(&file).is_file() && self.folder.join(own).is_file();
            is_there.then(|| (name.clone(), file.to_string_lossy().replace('\\', "/")))
        };
        self.outline.optional.iter().filter_map(of_recording).collect()
    }

    /// The variable that the script needs and has not, with a guess of its value. `None` if there is none to be guessed.
    fn missing_variable(&self, run: &DraftRun) -> Option<(String, String)> {
        let name = run.unknown_variable.as_ref()?;
        if run.set.iter().any(|(n, _)| n == name) {
            return None;
        }
        let recording = Path::new(&run.path);
        let is_motion = |p: &PathBuf| {
            let extension = p.extension().unwrap_or_default().to_string_lossy().to_lowercase();
            MOTION_FILES.contains(&extension.as_str()) && self.folder.join(p).is_file()
        };
        let motion = MOTION_FILES.map(|e| recording.with_extension(e)).into_iter().find(is_motion);
        let lower = name.to_lowercase();
        let times = &run.recording.times;
        let value = if ["motion", "record", "file", "path", "gm", "accel"].iter().any(|w| lower.contains(w)) {
            motion?.to_string_lossy().replace('\\', "/")
        } else if lower == "dt" {
            let mut steps: Vec<f64> = times.windows(2).map(|t| t[1] - t[0]).collect();
            steps.sort_by(f64::total_cmp);
            // Times with jitter are of a round step.
            format!("{:?}", format!("{:.1e}", steps.get(steps.len() / 2)?).parse::<f64>().ok()?)
        } else if ["npts", "nsteps", "nstep", "steps", "n"].contains(&lower.as_str()) {
            let numbers = motion.and_then(|m| hysteron_files::read_text(self.folder.join(m)).ok());
            numbers.map_or(times.len(), |text| text.split_whitespace().count()).to_string()
        } else {
            return None;
        };
        Some((name.to_owned(), value))
    }

    /// Run the script for a recording, and match the columns of the recording with its outputs.
    fn run(&mut self, runs: &mut [DraftRun], number: usize) {
        let run = &mut runs[number];
        let set = run.set.iter().map(|(name, value)| (name.clone(), Setting::Text(value.clone())));
        let spec = Run {
            name: run.name.clone(),
            role: Role::Fit,
            set: set.collect(),
            recording: run.recording.clone(),
            observe: vec![],
        };
        let study = Study {
            title: String::new(),
            folder: self.folder.clone(),
            file: PathBuf::new(),
            model: self.model.clone(),
            space: ParameterSpace::default(),
            runs: vec![spec],
            calibration: CalibrationOptions::default(),
            rig: None,
            material: None,
            spans: StudySpans::default(),
            warnings: vec![],
        };
        let mut simulator = ScriptSimulator::new(Arc::new(study), Options::default(), self.stop.clone());
        simulator.limits = vec![RunLimits { time: MAX_TIME, ..RunLimits::UNKNOWN }];
        let outputs = UnobservedTraces::default();
        let ended = simulator.run(0, None, RunMode { others: Some(outputs.clone()), ..RunMode::default() });
        run.failure = simulator.error(&ended, 0).map(|e| e.to_string());
        run.unknown_variable = match &ended.end {
            End::Raised(d) | End::Rejected(d) => {
                d.absent.as_ref().filter(|a| a.kind == VARIABLE).map(|a| a.name.clone())
            }
            _ => None,
        };
        let interp = &ended.script.interp;
        let mut declared: Vec<(u32, String, f64)> = interp
            .host
            .declared
            .iter()
            .map(|(name, x)| (interp.host.declared_at.get(name).map_or(0, |s| s.start), name.clone(), *x))
            .collect();
        declared.sort_by_key(|(at, ..)| *at);
        if self.values.parameters.is_empty() {
            self.values.parameters = declared.into_iter().map(|(_, name, x)| (name, x)).collect();
        }
        for name in &self.outline.optional {
            if let Ok(value) = interp.get_var(name) {
                self.values.variables.entry(name.clone()).or_insert_with(|| value.as_str().into_owned());
            }
        }
        let traces: Vec<(String, Trace)> = match outputs.lock() {
            Ok(outputs) => outputs.iter().map(|(name, t)| (name.clone(), t.with(Trace::clone))).collect(),
            Err(_) => vec![],
        };
        let candidates = Candidate::of_traces(&traces, &self.outline);
        run.matches = matching::match_columns(&run.recording, &candidates);
        run.recorded = candidates.iter().filter_map(Candidate::quantity).collect();
    }
}

/// Commands whose numbers are properties of the structure.
const PROPERTIES: [&str; 7] =
    ["uniaxialMaterial", "nDMaterial", "section", "element", "mass", "rayleigh", "frictionModel"];

/// A number that the script gives to a variable.
struct NumberVariable {
    name: String,
    value: f64,
}

/// Content of a script that its text shows without a run.
struct ScriptOutline {
    /// Variables that a study may set: `info exists NAME`.
    optional: Vec<String>,
    /// Recorders: file, and the words besides it.
    recorders: Vec<(String, String)>,
    /// Variables of numbers that materials and elements use.
    candidates: Vec<NumberVariable>,
}

impl ScriptOutline {
    /// The outline of a text.
    fn of(text: &str) -> Self {
        let mut optional: Vec<String> = vec![];
        for rest in text.split("info exists").skip(1) {
            let name = word(rest.trim_start());
            if !name.is_empty() && !optional.iter().any(|o| o == name) {
                optional.push(name.to_owned());
            }
        }
        let commands: Vec<Vec<&str>> =
            top_level(text).iter().map(|c| text[c.start..c.end].split_whitespace().collect()).collect();
        let recorders = text.match_indices("recorder ").filter_map(|(at, _)| recorder(&text[at..])).collect();
        let candidates = candidates(&commands, text);
        Self { optional, recorders, candidates }
    }

    /// The place that a recorder of a file records, as its words say.
    fn place(&self, file: &str) -> Option<&str> {
        self.recorders.iter().find(|(f, _)| f == file).map(|(_, place)| place.as_str())
    }

    /// The words of the recorder of a file whose name in the script may begin with a variable: `$folder/disp.out`.
    fn words(&self, file: &str) -> Option<&str> {
        let ends = |name: &str| {
            let tail = name.rfind(['$', ']']).and_then(|at| name[at..].find('/').map(|slash| &name[at + slash..]));
            tail.is_some_and(|tail| file.ends_with(tail))
        };
        let mut by_end = self.recorders.iter().filter(|(name, _)| ends(name)).map(|(_, words)| words.as_str());
        let only = by_end.next().filter(|_| by_end.next().is_none());
        self.place(file).or(only)
    }
}

/// The name of a variable at the beginning of a text.
fn word(text: &str) -> &str {
    &text[..text.find(|c: char| !(c.is_alphanumeric() || c == '_')).unwrap_or(text.len())]
}

/// File and words of a recorder command, without the options of its file: `node 2 dof 1 disp`.
fn recorder(text: &str) -> Option<(String, String)> {
    let line = text.split(['\n', ';']).next()?;
    let mut words = line.split_whitespace().skip(2);
    let (mut file, mut place) = (None, vec![]);
    while let Some(word) = words.next() {
        match word {
            "-file" | "-fileAdd" | "-xml" | "-binary" => file = words.next(),
            "-time" | "-closeOnWrite" => {}
            "-precision" | "-dT" => {
                words.next();
            }
            _ => place.push(word.trim_start_matches('-').trim_matches(['{', '}', '"'])),
        }
    }
    let place = place.join(" ").replace("ele ", "element ");
    Some((file?.trim_matches(['{', '}', '"']).to_owned(), place))
}

/// Variables that loops count or go through: those of `for`, `foreach`, `lmap` and `incr`.
fn loop_variables(text: &str) -> BTreeSet<&str> {
    let calls = |command: &'static str| {
        let begins = |at: usize| !text[..at].ends_with(|c: char| c.is_alphanumeric() || c == '_' || c == '$');
        let ends = |rest: &str| rest.starts_with([' ', '\t', '{']);
        let found = text.match_indices(command).filter(move |(at, _)| begins(*at));
        found.map(move |(at, _)| &text[at + command.len()..]).filter(move |rest| ends(rest)).map(str::trim_start)
    };
    let listed = ["foreach", "lmap"].into_iter().flat_map(calls).flat_map(|rest| match rest.strip_prefix('{') {
        Some(list) => list.split('}').next().unwrap_or_default().split_whitespace().collect::<Vec<_>>(),
        None => vec![word(rest)],
    });
    let begun = calls("for").filter_map(|rest| rest.trim_start_matches(['{', ' ']).strip_prefix("set "));
    let begun = begun.map(|rest| word(rest.trim_start()));
    calls("incr").map(word).chain(begun).chain(listed).collect()
}

/// Variables with numbers, set at the outermost level, that a material or element uses directly or by other variables. Those of
/// loops are numbers of things and no properties.
fn candidates(commands: &[Vec<&str>], text: &str) -> Vec<NumberVariable> {
    let uses = |words: &[&str], name: &str| {
        let dollar = format!("${name}");
        words.iter().any(|w| w.match_indices(&dollar).any(|(at, _)| word(&w[at + 1..]) == name))
    };
    // Materials and elements stand in loops and procedures too.
    let lines: Vec<Vec<&str>> = text.lines().map(|l| l.split_whitespace().collect()).collect();
    let properties: Vec<&Vec<&str>> = lines.iter().filter(|l| l.iter().any(|w| PROPERTIES.contains(w))).collect();
    let mut used: Vec<&str> = vec![];
    let sets: Vec<&Vec<&str>> = commands.iter().filter(|c| c.len() >= 3 && c[0] == "set").collect();
    // Variables come before those that are made of them.
    for set in sets.iter().rev() {
        let name = set[1];
        let by_others = sets.iter().any(|s| used.contains(&s[1]) && uses(&s[2..], name));
        if by_others || properties.iter().any(|p| uses(p, name)) {
            used.push(name);
        }
    }
    let of_loops = loop_variables(text);
    let number = |set: &&Vec<&str>| {
        let value = (set.len() == 3).then(|| set[2].parse::<f64>().ok().filter(|x| x.is_finite()))??;
        let is_property = used.contains(&set[1]) && !of_loops.contains(set[1]);
        is_property.then(|| NumberVariable { name: set[1].to_owned(), value })
    };
    sets.iter().filter_map(number).collect()
}

#[cfg(test)]
mod tests {
    use super::ScriptOutline;

    #[test]
    fn outline_has_optional_variables_recorders_and_numbers() {
        let text = "if {![info exists motion]} {set motion a.dat}\nset E 200.0\nset A 2.0;# area\nset EA [expr {$E*$A}]\n\
                    set n 5\nset label abc\nuniaxialMaterial Elastic 1 $EA\n\
                    recorder Element -file force.out -time -ele 1 force\nrecorder Node -time -file d.out -node 2 -dof 1 disp;\n";
        let outline = ScriptOutline::of(text);
        assert_eq!(outline.optional, ["motion"]);
        let names: Vec<&str> = outline.candidates.iter().map(|c| c.name.as_str()).collect();
        assert_eq!(names, ["E", "A"]);
        assert_eq!(outline.candidates[0].value, 200.0);
        assert_eq!(
            (outline.place("force.out"), outline.place("d.out")),
            (Some("element 1 force"), Some("node 2 dof 1 disp"))
        );
        // Variables of loops are no parameters; one whose name begins with a command's is.
        let text = "set tag 0\nset i 1\nset j 2.0\nset k 3\nset incr 4.0\nset fork 5.0\n\
                    for {set i 0} {$i < 3} {incr i} {\n incr tag 2\n foreach {j x} {1 2} {\n  foreach k {1 2} {\n   \
                    element truss $tag $i $j $k $incr $fork\n  }\n }\n}\n";
        let names: Vec<String> = ScriptOutline::of(text).candidates.into_iter().map(|c| c.name).collect();
        assert_eq!(names, ["incr", "fork"]);
        let outline = ScriptOutline::of("recorder Node -file $out/base.out -time -node [master 1] -dof 1 disp\n");
        assert_eq!((outline.place("results/base.out"), outline.words("results/other.out")), (None, None));
        assert!(outline.words("results/base.out").is_some_and(|words| words.ends_with("disp")));
    }
}
