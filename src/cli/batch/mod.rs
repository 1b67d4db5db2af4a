//! `hysteron batch`: many runs of scripts.

use super::args::FolderArgs;
use super::calibrate::{FAILURE, INPUT_ERROR};
use super::console::NoOutput;
use super::files::write_atomically;
use super::run::guarded;
use super::signals::{INTERRUPTED, on_interrupt};
use clap::Args;
use hysteron::analysis::Options;
use hysteron::design::batch::{Case, Plan, load};
use hysteron::opensees::Mode;
use hysteron::run::{End, Run, Settings};
use hysteron::study::WorkerPool;
use hysteron::tcl::Value;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

#[derive(Args, Debug)]
pub(super) struct BatchArgs {
    /// The plan
    plan: PathBuf,
    /// Where the results go
    #[arg(long, value_name = "DIR", default_value = "batch")]
    out: PathBuf,
    /// Number of threads; all cores if it is not given. The result does not depend on it
    #[arg(long, value_name = "N")]
    threads: Option<usize>,
    /// Keep the cases that an earlier run has completed
    #[arg(long)]
    resume: bool,
    /// Run a part of the cases, for instance 2/8
    #[arg(long, value_name = "I/N", value_parser = shard)]
    shard: Option<(usize, usize)>,
    /// Run nothing: make the table of the cases that the shards have completed
    #[arg(long)]
    merge: bool,
}

fn shard(text: &str) -> Result<(usize, usize), String> {
    let numbers = text.split_once('/').and_then(|(i, n)| Some((i.parse().ok()?, n.parse().ok()?)));
    numbers.filter(|(i, n)| (1..=*n).contains(i)).ok_or_else(|| "expected I/N with I from 1 to N, as 2/8".into())
}

/// Run the command; the exit status.
pub(super) fn batch(a: &BatchArgs) -> i32 {
    let stop = Arc::new(AtomicBool::new(false));
    on_interrupt(&stop);
    match run(a, &stop) {
        Ok(failed) => {
            if failed > 0 {
                FAILURE
            } else {
                0
            }
        }
        Err(message) => {
            eprintln!("error: {message}");
            if stop.load(Ordering::Relaxed) { INTERRUPTED } else { INPUT_ERROR }
        }
    }
}

fn run(a: &BatchArgs, stop: &Arc<AtomicBool>) -> Result<usize, String> {
    let plan = load(&a.plan)?;
    let folder = a.out.join("cases");
    fs::create_dir_all(&folder).map_err(|e| format!("cannot make {}: {e}", folder.display()))?;
    let (i, n) = a.shard.unwrap_or((1, 1));
    let own: Vec<&Case> = plan.cases.iter().skip(i - 1).step_by(n).collect();
    if !a.merge {
        let cores = std::thread::available_parallelism().map_or(1, usize::from);
        let pool = WorkerPool::new(a.threads.unwrap_or(cores)).map_err(|e| e.to_string())?;
        let done = pool.run(own.iter(), |case| one(&plan, case, &folder, a.resume, stop));
        for (case, result) in own.iter().zip(done) {
            result.unwrap_or_else(|| Err(format!("case {}: a defect of this program", case.hash)))?;
        }
        if stop.load(Ordering::Relaxed) {
            return Err("interrupted: go on with --resume".into());
        }
        if n > 1 {
            eprintln!("{} of {} cases are complete; --merge makes the table of all", own.len(), plan.cases.len());
            return Ok(0);
        }
    }
    table(a, &plan, &folder)
}

fn table(a: &BatchArgs, plan: &Plan, folder: &Path) -> Result<usize, String> {
    let header = ["case", "script"].into_iter().map(str::to_owned).chain(plan.parameters.clone());
    let header = header.chain(["motion".into(), "status".into()]).chain(plan.results.clone());
    let mut text = format!("{}\n", header.map(|w| quoted(&w)).collect::<Vec<_>>().join(","));
    let (mut missing, mut failed) = (0, 0);
    for case in &plan.cases {
        match fs::read_to_string(folder.join(&case.hash).join("row.csv")) {
            Ok(row) => {
                failed += usize::from(!row.contains(",done"));
                text += &row;
            }
            Err(_) => missing += 1,
        }
    }
    if missing > 0 {
        return Err(format!("{missing} of {} cases are not complete in {}", plan.cases.len(), folder.display()));
    }
    write_atomically(&a.out.join("results.csv"), &text)?;
    eprintln!("{} cases, {failed} of them failed", plan.cases.len());
    Ok(failed)
}

fn quoted(word: &str) -> String {
    let special = word.contains([',', '"', '\n']);
    if special { format!("\"{}\"", word.replace('"', "\"\"")) } else { word.to_owned() }
}

fn one(plan: &Plan, case: &Case, folder: &Path, resume: bool, stop: &Arc<AtomicBool>) -> Result<(), String> {
    let (place, part) = (folder.join(&case.hash), folder.join(format!("{}.part", case.hash)));
    if stop.load(Ordering::Relaxed) || (resume && place.join("row.csv").is_file()) {
        return Ok(());
    }
    let _ = fs::remove_dir_all(&part);
    let folders = FolderArgs { out: Some(part.clone()), ..FolderArgs::default() };
    let script = case.script.to_string_lossy();
    let (files, outputs) = guarded(&folders, &script)?;
    let settings = Settings { mode: Mode::Run, strict: false, options: Options::default() };
    let mut run = Run::new(settings, Box::new(NoOutput), files, outputs);
    run.interp.interrupt = stop.clone();
    run.interp.host.stop_on(stop.clone());
    run.interp.host.parameters = plan.parameters.iter().cloned().zip(case.values.iter().copied()).collect();
    if let Some(m) = case.motion.map(|m| &plan.motions[m]) {
        let mut set = vec![Value::from("name"), Value::from(m.name.as_str()), Value::from("dt"), Value::from(m.dt)];
        for (k, c) in m.components.iter().enumerate() {
            set.push(Value::from(format!("a{}", k + 1)));
            set.push(Value::list(c.iter().map(|a| Value::from(*a))));
        }
        let failed = |_| "the motion cannot be set".to_owned();
        run.interp.set_global("hysteron_motion", Value::list(set)).map_err(failed)?;
        run.interp.eval_str("batch", "array set motion $hysteron_motion; unset hysteron_motion").map_err(failed)?;
    }
    let end = run.script(&script, &[]);
    if stop.load(Ordering::Relaxed) {
        let _ = fs::remove_dir_all(&part);
        return Ok(());
    }
    let row = row(plan, case, &mut run, &end);
    drop(run);
    write_atomically(&part.join("row.csv"), &row)?;
    let _ = fs::remove_dir_all(&place);
    fs::rename(&part, &place).map_err(|e| format!("cannot write {}: {e}", place.display()))
}

fn row(plan: &Plan, case: &Case, run: &mut Run, end: &End) -> String {
    let undeclared = plan.parameters.iter().find(|p| !run.interp.host.declared.contains_key(*p));
    let mut status = match (end, undeclared, &run.interp.host.last_failure) {
        (End::Rejected(d) | End::Raised(d), _, _) => d.message.clone(),
        (End::Done | End::Exit(0), Some(p), _) => format!("the script has no \"pset {p}\""),
        (End::Done | End::Exit(0), None, None) => "done".into(),
        _ => "the analysis failed".into(),
    };
    let mut values = vec![];
    for name in &plan.results {
        let value = run.interp.eval_str("batch", &format!("set {{::{name}}}")).map(|v| v.to_string());
        let value = value.ok().filter(|v| v.parse::<f64>().map_or(true, f64::is_finite));
        if value.is_none() && status == "done" {
            status = format!("the script has no finite result {name}");
        }
        values.push(value.unwrap_or_default());
    }
    let script = case.script.file_name().map_or(String::new(), |n| n.to_string_lossy().into_owned());
    let mut words = vec![case.hash.clone(), script];
    words.extend(case.values.iter().map(|v| format!("{v:?}")));
    words.push(case.motion.map_or(String::new(), |m| plan.motions[m].name.clone()));
    words.push(status);
    words.extend(values);
    format!("{}\n", words.iter().map(|w| quoted(w)).collect::<Vec<_>>().join(","))
}
