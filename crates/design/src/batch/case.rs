//! One case of a batch: its run, its folder and its row in the table.

use super::{Case, Plan};
use crate::isolate::{HashedFiles, InputHashes, is_current};
use hysteron_engine::analysis::Options;
use hysteron_files::FolderLock;
use hysteron_opensees::files::guard::{Guard, GuardedFiles, GuardedOutputs};
use hysteron_opensees::files::output_folder::OutputFolder;
use hysteron_opensees::run::{End, Run, Settings};
use hysteron_opensees::{Mode, Outputs};
use hysteron_tcl::{Files, Silent, Value};
use std::io;
use std::path::Path;
use std::rc::Rc;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// File of the row of the table in the folder of a case.
const ROW: &str = "row.csv";
/// File of the hashes of what the case has read.
const INPUTS: &str = "inputs.json";
/// Status of a case whose script was completed.
const DONE: &str = "done";

/// Head of the table, a line.
fn header(plan: &Plan) -> String {
    let own = ["case", "status", "script"].map(str::to_owned).into_iter();
    let columns = own.chain(plan.parameters.clone()).chain(["motion".into()]).chain(plan.results.clone());
    line(columns.chain(["message".into()]))
}

/// Returns true if a row is that of a case whose script was completed.
fn is_done(row: &str) -> bool {
    row.split(',').nth(1) == Some(DONE)
}

/// The message of a row, which is its last cell.
fn message(row: &str) -> String {
    let mut reader = csv::ReaderBuilder::new().has_headers(false).from_reader(row.as_bytes());
    let cells = reader.records().next().and_then(Result::ok);
    cells.and_then(|c| Some(c.iter().next_back()?.to_owned())).unwrap_or_default()
}

/// Results of the cases of a plan.
#[derive(Clone, Debug)]
pub struct Table {
    /// A line with the names of the columns, and a line for each case, as CSV.
    pub csv: String,
    /// Number of cases whose script was not completed with all results.
    pub failed: usize,
    /// The first of these cases, by its hash, and its message.
    pub first_failure: Option<(String, String)>,
}

/// The table of the cases that `run_case` has completed below `folder`.
///
/// # Errors
/// The number of cases that are not complete.
pub fn table(plan: &Plan, folder: &Path) -> Result<Table, usize> {
    let mut table = Table { csv: header(plan), failed: 0, first_failure: None };
    let mut missing = 0;
    for case in &plan.cases {
        match hysteron_files::read_text(folder.join(&case.hash).join(ROW)) {
            Ok(row) => {
                if !is_done(&row) {
                    table.failed += 1;
                    table.first_failure.get_or_insert_with(|| (case.hash.clone(), message(&row)));
                }
                table.csv += &row;
            }
            Err(_) => missing += 1,
        }
    }
    if missing == 0 { Ok(table) } else { Err(missing) }
}

fn line(words: impl Iterator<Item = String>) -> String {
    let quoted = |word: String| {
        let special = word.contains([',', '"', '\n', '\r']);
        if special { format!("\"{}\"", word.replace('"', "\"\"")) } else { word }
    };
    words.map(quoted).collect::<Vec<_>>().join(",") + "\n"
}

/// Returns true if an earlier run has completed the case below `folder`, and no file that it read has changed.
pub fn is_complete(case: &Case, folder: &Path) -> bool {
    let place = folder.join(&case.hash);
    let inputs = hysteron_files::read_text(place.join(INPUTS)).ok();
    let inputs: Option<Vec<(String, u64)>> = inputs.and_then(|text| serde_json::from_str(&text).ok());
    place.join(ROW).is_file() && inputs.is_some_and(|inputs| is_current(&inputs))
}

/// Files and recorder files of a script that may write below the current folder and into `out`, where its files go.
fn guarded(out: &Path) -> io::Result<(Box<dyn Files>, Box<dyn Outputs>)> {
    let folder = OutputFolder::new(out)?;
    let guard = Rc::new(Guard::new([out, Path::new(".")])?);
    let files = GuardedFiles { files: Box::new(folder.clone()), guard: guard.clone() };
    Ok((Box::new(files), Box::new(GuardedOutputs { outputs: Box::new(folder), guard })))
}

/// Run a case in a folder of its own below `folder`, which gets its name when the case is complete.
///
/// With `resume`, a case that is complete is kept, unless a file that it read has changed. A case that is stopped leaves nothing.
///
/// # Errors
/// A file cannot be written. A script that fails is no error: its row says so.
pub fn run_case(plan: &Plan, case: &Case, folder: &Path, resume: bool, stop: &Arc<AtomicBool>) -> Result<(), String> {
    let (place, part) = (folder.join(&case.hash), folder.join(format!("{}.part", case.hash)));
    if stop.load(Ordering::Relaxed) || (resume && is_complete(case, folder)) {
        return Ok(());
    }
    let locked = hysteron_files::make_inner_folder(&part).and_then(|()| FolderLock::take(&part));
    let lock = locked.map_err(|e| e.to_string())?;
    lock.clear().map_err(|e| format!("cannot clear {}: {e}", part.display()))?;
    let (files, outputs) = guarded(&part).map_err(|e| format!("cannot make {}: {e}", part.display()))?;
    let inputs = InputHashes::default();
    let files = Box::new(HashedFiles::new(files, inputs.clone()));
    let settings = Settings { mode: Mode::Run, strict: false, options: Options::default() };
    let mut run = Run::new(settings, Box::new(Silent), files, outputs);
    run.interp.interrupt = stop.clone();
    run.interp.host.stop_on(stop.clone());
    prepare(plan, case, &mut run)?;
    let end = run.script(&case.script.to_string_lossy(), &[]);
    if stop.load(Ordering::Relaxed) {
        drop(lock);
        let _ = hysteron_files::remove_folder(&part);
        return Ok(());
    }
    let row = row(plan, case, &mut run, &end);
    drop(run);
    // A file of its own that a script reads again is no input.
    let read: Vec<_> = inputs.hashes().into_iter().filter(|(path, _)| Path::new(path).exists()).collect();
    let read = serde_json::to_string(&read).map_err(|e| e.to_string())?;
    let write = |name: &str, text: &str| {
        let path = part.join(name);
        hysteron_files::write(&path, text).map_err(|e| format!("cannot write {}: {e}", path.display()))
    };
    write(INPUTS, &read)?;
    write(ROW, &row)?;
    drop(lock);
    let moved = hysteron_files::remove_folder(&place).and_then(|()| hysteron_files::rename(&part, &place));
    moved.map_err(|e| format!("cannot write {}: {e}", place.display()))
}

/// Give the script of a case its parameters and its motion, before it begins.
///
/// # Errors
/// The motion cannot be set.
pub fn prepare(plan: &Plan, case: &Case, run: &mut Run) -> Result<(), String> {
    run.interp.host.parameters = plan.parameters.iter().cloned().zip(case.values.iter().copied()).collect();
    give_motion(plan, case, run)
}

/// A parameter of the plan that a script which has run does not declare, in words.
pub fn undeclared(plan: &Plan, run: &Run) -> Option<String> {
    let missing = plan.parameters.iter().find(|p| !run.interp.host.declared.contains_key(*p));
    missing.map(|p| format!("the script has no \"pset {p}\""))
}

/// Put the motion of a case into the array `motion` of its script.
fn give_motion(plan: &Plan, case: &Case, run: &mut Run) -> Result<(), String> {
    let Some(m) = case.motion.map(|m| &plan.motions[m]) else { return Ok(()) };
    let mut set = vec![Value::from("name"), Value::from(m.name.as_str()), Value::from("dt"), Value::from(m.dt)];
    for (k, c) in m.components.iter().enumerate() {
        set.push(Value::from(format!("a{}", k + 1)));
        set.push(Value::list(c.iter().map(|a| Value::from(*a))));
    }
    let failed = |_| "the motion cannot be set".to_owned();
    run.interp.set_global("hysteron_motion", Value::list(set)).map_err(failed)?;
    let unpack = "array set motion $hysteron_motion; unset hysteron_motion";
    run.interp.eval_str("batch", unpack).map(|_| ()).map_err(failed)
}

/// Status and message of a run, and the values of the results; none for one that is missing.
fn outcome(plan: &Plan, run: &mut Run, end: &End) -> (&'static str, String, Vec<String>) {
    let (mut status, mut message) = match (end, undeclared(plan, run), &run.interp.host.last_failure) {
        (End::Rejected(d) | End::Raised(d), _, _) => ("rejected", d.message.clone()),
        (End::Done | End::Exit(0), Some(missing), _) => ("rejected", missing),
        (End::Done | End::Exit(0), None, None) => (DONE, String::new()),
        (_, _, Some(failure)) => ("failed", failure.to_string()),
        _ => ("failed", "the script was not completed".into()),
    };
    let mut values = vec![];
    for name in &plan.results {
        let value = run.interp.eval_str("batch", &format!("set {{::{name}}}")).map(|v| v.to_string());
        let value = value.ok().filter(|v| v.parse::<f64>().map_or(true, f64::is_finite));
        if value.is_none() && status == DONE {
            (status, message) = ("incomplete", format!("the script has no finite result {name}"));
        }
        values.push(value.unwrap_or_default());
    }
    (status, message, values)
}

fn row(plan: &Plan, case: &Case, run: &mut Run, end: &End) -> String {
    let (status, message, values) = outcome(plan, run, end);
    let script = case.script.file_name().map_or(String::new(), |n| n.to_string_lossy().into_owned());
    let motion = case.motion.map_or(String::new(), |m| plan.motions[m].name.clone());
    let own = [case.hash.clone(), status.to_owned(), script].into_iter();
    let parameters = case.values.iter().map(|v| format!("{v:?}"));
    line(own.chain(parameters).chain([motion]).chain(values).chain([message]))
}
