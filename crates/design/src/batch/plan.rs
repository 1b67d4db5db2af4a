//! The file of a plan, and its cases.

use super::rows::{GridValues, LatinHypercube, Rows, grid, latin_hypercube, list, table};
use super::{Plan, hexadecimal};
use crate::motion::{MotionEntry, read};
use serde::Deserialize;
use sha2::{Digest as _, Sha256};
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct PlanFile {
    scripts: Vec<String>,
    /// Global variables of the script that are results.
    results: Vec<String>,
    /// Further files that the scripts read.
    #[serde(default)]
    files: Vec<String>,
    /// A CSV file with values of parameters.
    table: Option<String>,
    #[serde(default)]
    grid: BTreeMap<String, GridValues>,
    #[serde(default)]
    case: Vec<BTreeMap<String, f64>>,
    latin_hypercube: Option<LatinHypercube>,
    #[serde(default)]
    motion: Vec<MotionEntry>,
}

/// A motion of a plan.
#[derive(Clone, Debug, PartialEq)]
pub struct PlanMotion {
    /// Name.
    pub name: String,
    /// Step of time in s.
    pub dt: f64,
    /// Accelerations of each component in m/s², times the factor of the plan.
    pub components: Vec<Vec<f64>>,
}

/// One analysis of a plan.
#[derive(Clone, Debug, PartialEq)]
pub struct Case {
    /// The script.
    pub script: PathBuf,
    /// Values of the parameters of the plan.
    pub values: Vec<f64>,
    /// Index of the motion, if the plan has motions.
    pub motion: Option<usize>,
    /// Hash of the inputs in hexadecimal digits: the name of the folder of the outputs.
    pub hash: String,
}

/// Bytes of a hash that become a name.
const HASH_BYTES: usize = 10;

fn bytes_of(path: &Path) -> Result<Vec<u8>, String> {
    hysteron_files::read_input(path).map_err(|e| format!("cannot read \"{}\": {e}", path.display()))
}

fn text_of(path: &Path) -> Result<String, String> {
    Ok(String::from_utf8_lossy(&bytes_of(path)?).into_owned())
}

/// Files that a script sources under a name without a substitution, and those that they source.
fn sourced(script: &Path, found: &mut BTreeMap<PathBuf, Vec<u8>>) -> Result<(), String> {
    if found.contains_key(script) {
        return Ok(());
    }
    let bytes = bytes_of(script)?;
    let text = String::from_utf8_lossy(&bytes).into_owned();
    found.insert(script.to_owned(), bytes);
    let folder = script.parent().unwrap_or(Path::new(""));
    for command in text.split(['\n', ';', '{']) {
        let mut words = command.split_whitespace();
        let (Some("source"), Some(name)) = (words.next(), words.next()) else { continue };
        // As OpenSees writes it: [file join [file dirname [info script]] name].
        let name = match words.last() {
            Some(last) if name.starts_with("[file") => last.trim_end_matches(']'),
            _ => name.trim_matches(['"', '{', '}']),
        };
        for path in [PathBuf::from(name), folder.join(name)] {
            if path.is_file() {
                sourced(&path, found)?;
            }
        }
    }
    Ok(())
}

fn motion(entry: &MotionEntry, folder: &Path, notes: &mut Vec<String>) -> Result<PlanMotion, String> {
    let options = entry.options()?;
    let mut motions = vec![];
    for name in &entry.files {
        let path = folder.join(name);
        let bytes = bytes_of(&path)?;
        let short = name.rsplit('/').next().unwrap_or(name);
        let beside = hysteron_files::read_beside(&path);
        let mut found = read(short, &bytes, &options, &beside).map_err(|e| format!("\"{name}\": {e}"))?;
        motions.append(&mut found.motions);
        notes.append(&mut found.notes);
    }
    let Some(first) = motions.first() else { return Err("a [[motion]] has no files".into()) };
    let name = entry.name.clone().unwrap_or_else(|| first.name.clone());
    if !entry.factor.is_finite() {
        return Err(format!("the motion {name} has the factor {}: expected a finite number", entry.factor));
    }
    let dt = first.dt;
    if let Some(m) = motions.iter().find(|m| m.dt != dt) {
        return Err(format!("the motion {name} has components with the steps {dt} and {}: expected one step", m.dt));
    }
    let components = motions.iter().map(|m| m.acceleration.iter().map(|a| a * entry.factor).collect()).collect();
    Ok(PlanMotion { name, dt, components })
}

/// A hash of parts that keeps them apart.
#[derive(Clone)]
struct InputHash(Sha256);

impl InputHash {
    fn add(&mut self, part: &[u8]) {
        self.0.update((part.len() as u64).to_le_bytes());
        self.0.update(part);
    }

    fn add_motion(&mut self, motion: &PlanMotion) {
        self.add(motion.name.as_bytes());
        self.add(&motion.dt.to_le_bytes());
        for component in &motion.components {
            self.add(&component.iter().flat_map(|a| a.to_le_bytes()).collect::<Vec<u8>>());
        }
    }

    fn name(self) -> String {
        hexadecimal(&self.0.finalize()[..HASH_BYTES])
    }
}

/// The mistake in the form of a plan's text, if it has one: its place in bytes, and what is wrong.
pub fn mistake_of_form(text: &str) -> Option<(Option<std::ops::Range<usize>>, String)> {
    toml::from_str::<PlanFile>(text).err().map(|e| (e.span(), e.message().to_owned()))
}

/// Returns true if a file is a plan: it names scripts.
pub fn is_plan(path: &Path) -> bool {
    let table = text_of(path).ok().and_then(|text| text.parse::<toml::Table>().ok());
    table.is_some_and(|t| t.contains_key("scripts"))
}

/// Read a plan and its inputs; paths are relative to its folder. The hash of a case covers its script, the files that it sources
/// by a plain name, the `files` of the plan, the results, parameters and motion.
///
/// # Errors
/// A file cannot be read or understood, or a value is out of its range. The message names it.
pub fn load(path: &Path) -> Result<Plan, String> {
    let file: PlanFile = toml::from_str(&text_of(path)?).map_err(|e| format!("\"{}\": {e}", path.display()))?;
    let folder = path.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
    if file.scripts.is_empty() {
        return Err("scripts = []: expected at least one script".into());
    }
    let mut rows = grid(&file.grid)?.times(&list(&file.case)?)?;
    if let Some(name) = &file.table {
        rows = rows.times(&table(name, &text_of(&folder.join(name))?)?)?;
    }
    if let Some(sample) = &file.latin_hypercube {
        rows = rows.times(&latin_hypercube(sample)?)?;
    }
    check_columns(&file.results, &rows)?;
    let mut notes = vec![];
    let read = |m| motion(m, folder, &mut notes);
    let motions: Vec<PlanMotion> = file.motion.iter().map(read).collect::<Result<_, _>>()?;
    let choices: Vec<Option<usize>> =
        if motions.is_empty() { vec![None] } else { (0..motions.len()).map(Some).collect() };
    let (mut cases, mut hashes, mut repeated) = (vec![], BTreeSet::new(), 0);
    for name in &file.scripts {
        let script = folder.join(name);
        let mut inputs = BTreeMap::new();
        sourced(&script, &mut inputs)?;
        for name in &file.files {
            let path = folder.join(name);
            let bytes = bytes_of(&path)?;
            inputs.insert(path, bytes);
        }
        let mut base = InputHash(Sha256::new());
        base.add(name.as_bytes());
        // In the order of their contents, so that a name does not depend on where the plan lies.
        let contents: BTreeSet<Vec<u8>> = inputs.into_values().collect();
        contents.iter().for_each(|c| base.add(c));
        rows.names.iter().chain(&file.results).for_each(|n| base.add(n.as_bytes()));
        for values in &rows.rows {
            for &motion in &choices {
                let mut hash = base.clone();
                values.iter().for_each(|v| hash.add(&v.to_le_bytes()));
                motion.into_iter().for_each(|m| hash.add_motion(&motions[m]));
                let case = Case { script: script.clone(), values: values.clone(), motion, hash: hash.name() };
                if hashes.insert(case.hash.clone()) {
                    cases.push(case);
                } else {
                    repeated += 1;
                }
            }
        }
    }
    Ok(Plan { parameters: rows.names, results: file.results, motions, cases, repeated, notes })
}

/// Columns of the table of results that are not the plan's.
const OWN_COLUMNS: [&str; 5] = ["case", "script", "motion", "status", "message"];

fn check_columns(results: &[String], rows: &Rows) -> Result<(), String> {
    let mut known: BTreeSet<&str> = OWN_COLUMNS.into();
    for name in rows.names.iter().chain(results) {
        if !known.insert(name) {
            return Err(format!("the table of results would have two columns {name}"));
        }
    }
    match rows.rows.iter().position(|r| r.iter().any(|v| !v.is_finite())) {
        Some(i) => Err(format!("row {} of the parameters has a value that is not finite", i + 1)),
        None => Ok(()),
    }
}
