//! Runs of scripts that nobody has written: what must hold for any text, and commands made from their usage.
//!
//! The property tests and the fuzz targets share this file.
#![allow(dead_code)]

use hysteron::analysis::Options;
use hysteron::opensees::{FileFormat, Mode, Outputs, Progress, commands, kinds};
use hysteron::record::{Memory, Output, RecordError};
use hysteron::run::{Run, Settings};
use hysteron::tcl::{MemoryFiles, Recorded};
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// Commands that a script may execute.
const MAX_COMMANDS: u64 = 20_000;
/// Steps that its analyses may commit.
const MAX_STEPS: u32 = 300;

/// Recorders go nowhere.
struct Nowhere;

impl Outputs for Nowhere {
    fn create(&mut self, _: &str, _: &Path, _: FileFormat) -> Result<Box<dyn Output>, RecordError> {
        Ok(Box::new(Memory::default()))
    }
}

/// Stops a run that has made enough steps.
struct StepLimit {
    left: u32,
    stop: Arc<AtomicBool>,
}

impl Progress for StepLimit {
    fn step(&mut self, _: f64, _: Option<f64>) {
        self.left = self.left.saturating_sub(1);
        if self.left == 0 {
            self.stop.store(true, Ordering::Relaxed);
        }
    }
}

/// Run a script beside some files. Whatever it is: no panic, an end, and no motion that is not a number.
pub fn run(text: &str, files: &[(&str, &[u8])], mode: Mode, options: Options, strict: bool) {
    // A run that is killed from outside leaves its script here.
    if let Some(log) = std::env::var_os("HYSTERON_FUZZ_LOG") {
        let _ = std::fs::write(log, format!("# {mode:?} {options:?} strict {strict}\n{text}"));
    }
    let memory = MemoryFiles::default();
    memory.insert("/model.tcl", text);
    for (name, content) in files {
        memory.insert(name, *content);
    }
    let settings = Settings { mode, strict, options };
    let mut run = Run::new(settings, Box::new(Recorded::default()), Box::new(memory), Box::new(Nowhere));
    run.interp.budget = Some(MAX_COMMANDS);
    let stop = run.interp.interrupt.clone();
    run.interp.host.set_progress(Box::new(StepLimit { left: MAX_STEPS, stop }));
    let _ = run.script("/model.tcl", &[]);
    let state = run.interp.host.engine.state();
    for (name, values) in [("displacement", &state.disp), ("velocity", &state.vel), ("acceleration", &state.accel)] {
        assert!(values.iter().all(|x| !x.is_nan()), "a {name} is not a number after\n{text}");
    }
}

/// Choices, from bytes or from random numbers: a number below `n`.
pub trait Choices {
    fn below(&mut self, n: usize) -> usize;
}

impl<F: FnMut(usize) -> usize> Choices for F {
    fn below(&mut self, n: usize) -> usize {
        self(n)
    }
}

/// Choices from bytes; zeros behind their end.
pub struct Bytes<'a>(pub &'a [u8]);

impl Choices for Bytes<'_> {
    fn below(&mut self, n: usize) -> usize {
        let mut x = 0;
        for _ in 0..if n > 256 { 2 } else { 1 } {
            let (byte, rest) = self.0.split_first().map_or((0, self.0), |(b, rest)| (*b, rest));
            self.0 = rest;
            x = x << 8 | usize::from(byte);
        }
        x % n.max(1)
    }
}

/// Values of arguments: small tags first, because they often exist; sizes of all kinds; words that are none.
const VALUES: &[&str] = &[
    "1", "2", "3", "1", "2", "0", "4", "5", "1.0", "0.5", "0.1", "10.0", "100.0", "2e8", "1e-3", "-1.0", "-0.002",
    "30.0", "0.3", "-1", "7", "12", "1e-12", "1e12", "1e300", "-1e300", "1e-300", "nan", "inf", "99999", "x", "{}",
    "{1 2 3}", "1 2 3", "-2",
];

/// The usage of each command with each of its kinds.
pub fn usages() -> Vec<&'static str> {
    // Commands that only end a script, wait, or read a line of the terminal.
    let left_out = ["exit", "quit", "after", "vwait", "gets"];
    let all = commands().filter(|c| !left_out.contains(&c.name));
    all.flat_map(|c| kinds(c.name).into_iter().map(|k| k.usage).chain([c.usage])).filter(|u| !u.is_empty()).collect()
}

/// A command after its usage: literal words as they are, arguments by chance, optional parts now and then, `a|b` one of both.
pub fn command(usage: &str, choices: &mut impl Choices) -> String {
    let mut out: Vec<String> = vec![];
    let mut rest = usage;
    // Depth of optional parts that are passed over.
    let (mut depth, mut skipped) = (0_u32, None);
    while !rest.is_empty() {
        let end = rest.find([' ', '<', '>']).unwrap_or(rest.len());
        let (word, after) = rest.split_at(end);
        if !word.is_empty() && skipped.is_none() {
            argument(word, &mut out, choices);
        }
        match after.chars().next() {
            Some('<') => {
                depth += 1;
                if skipped.is_none() && choices.below(3) == 0 {
                    skipped = Some(depth);
                }
            }
            Some('>') => {
                if skipped == Some(depth) {
                    skipped = None;
                }
                depth = depth.saturating_sub(1);
            }
            _ => {}
        }
        rest = after.get(1..).unwrap_or("");
    }
    out.join(" ")
}

fn argument(word: &str, out: &mut Vec<String>, choices: &mut impl Choices) {
    match choices.below(40) {
        // A word is missing, or there is one too many.
        0 => return,
        1 => out.push(VALUES[choices.below(VALUES.len())].into()),
        _ => {}
    }
    if word == "..." {
        for _ in 0..choices.below(6) {
            out.push(VALUES[choices.below(VALUES.len())].into());
        }
        return;
    }
    let one: Vec<&str> = word.split('|').collect();
    let word = one[choices.below(one.len())];
    if !word.starts_with('$') {
        return out.push(word.into());
    }
    // Tags and nodes are mostly small numbers.
    let is_tag = ["ag", "$i", "$j", "node", "Node"].iter().any(|t| word.contains(t));
    let pool = if is_tag && choices.below(8) > 0 { 6 } else { VALUES.len() };
    out.push(VALUES[choices.below(pool)].into());
}

/// Models that the commands change, in a line, a plane and space.
const MODELS: [&str; 3] = [
    "model basic -ndm 1 -ndf 1\nnode 1 0\nnode 2 0 -mass 1\nnode 3 0 -mass 1\nfix 1 1\nuniaxialMaterial Steel01 1 1.0 100.0 0.1\nuniaxialMaterial Elastic 2 50.0\n\
     element zeroLength 1 1 2 -mat 1 -dir 1\nelement zeroLength 2 2 3 -mat 2 -dir 1\n",
    "model basic -ndm 2 -ndf 3\nnode 1 0 0\nnode 2 0 3 -mass 1 1 0.1\nnode 3 4 3 -mass 1 1 0.1\nfix 1 1 1 1\nuniaxialMaterial Steel02 1 3e5 2e8 0.01 18 0.925 0.15\nuniaxialMaterial Elastic 2 1e5\n\
     section Fiber 1 {patch rect 1 6 1 -0.1 -0.1 0.1 0.1}\ngeomTransf Linear 1\ngeomTransf PDelta 2\nelement forceBeamColumn 1 1 2 3 1 1\nelement elasticBeamColumn 2 2 3 0.04 2e8 1.3e-4 2\n",
    "model basic -ndm 3 -ndf 6\nnode 1 0 0 0\nnode 2 0 0 1 -mass 1 1 1 0.1 0.1 0.1\nnode 3 2 0 1 -mass 1 1 1 0.1 0.1 0.1\nfix 1 1 1 1 1 1 1\nuniaxialMaterial Elastic 1 1e6\nuniaxialMaterial Elastic 2 1e5\n\
     frictionModel Coulomb 1 0.05\nsection Elastic 1 2e8 0.04 1e-4 1e-4 8e7 1e-4\ngeomTransf Linear 1 0 1 0\nelement elastomericBearingBoucWen 1 1 2 1e4 50 0.1 0 2 1 0.5 0.5 -P 1 -T 2 -My 2 -Mz 2\n\
     element elasticBeamColumn 2 2 3 0.04 2e8 8e7 1e-4 1e-4 1e-4 1\n",
];

/// Ends of the scripts: a static or a transient analysis, with one of the handlers.
fn analysis(choices: &mut impl Choices) -> String {
    let handler = ["Plain", "Transformation", "Penalty 1e10 1e10", "Lagrange", "Auto"][choices.below(5)];
    let algorithm =
        ["Newton", "Linear", "KrylovNewton", "BFGS", "NewtonLineSearch", "ModifiedNewton"][choices.below(6)];
    let system = ["BandGeneral", "ProfileSPD", "UmfPack", "FullGeneral"][choices.below(4)];
    let (kind, integrator, step) = [
        ("Static", "LoadControl 0.1", ""),
        ("Static", "DisplacementControl 2 1 0.01", ""),
        ("Transient", "Newmark 0.5 0.25", "0.01"),
        ("Transient", "HHT 0.9", "0.01"),
        ("Transient", "TRBDF2", "0.01"),
        ("Transient", "CentralDifference", "1e-4"),
    ][choices.below(6)];
    format!(
        "catch {{constraints {handler}}}; numberer RCM; catch {{system {system}}}; test NormDispIncr 1e-8 10; algorithm {algorithm}\n\
         catch {{integrator {integrator}}}; analysis {kind}; catch {{analyze 5 {step}}}; catch {{eigen 1}}; catch {{reactions}}\n"
    )
}

/// A model, some commands after their usage, and an analysis; with any of the program's options.
pub fn run_commands(usages: &[&str], choices: &mut impl Choices) {
    let mut text = MODELS[choices.below(MODELS.len())].to_owned();
    text += "timeSeries Linear 1\npattern Plain 1 1 {catch {load 2 1 0 0; load 2 1 0 0 0 0 0; load 2 1}}\n";
    text += "catch {timeSeries Trig 2 0 10 0.5; pattern UniformExcitation 2 1 -accel 2}\n";
    for _ in 0..1 + choices.below(10) {
        let usage = usages[choices.below(usages.len())];
        text += &format!("catch {{{}}}\n", command(usage, choices));
    }
    text += &analysis(choices);
    let options = Options {
        compat: choices.below(3) == 0,
        ladder: (choices.below(3) == 0).then(Default::default),
        refine: [1, 1, 2, 3][choices.below(4)],
        ..Options::default()
    };
    let mode = if choices.below(4) == 0 { Mode::Check } else { Mode::Run };
    run(&text, &[], mode, options, choices.below(5) == 0);
}
