//! The text of a drafted study.

use super::matching::{Match, recorded_quantity};
use super::{Draft, DraftRun};
use hysteron_engine::number_format::without_round_off;
use hysteron_recordings::Column;
use hysteron_recordings::unit::Quantity;
use std::fmt::Write as _;
use std::path::Path;

/// Bounds of a parameter over its value in the script.
const LOWER: f64 = 0.5;
const UPPER: f64 = 2.0;

/// A text as a string of TOML.
fn quoted(text: &str) -> String {
    format!("\"{}\"", text.replace('\\', "\\\\").replace('"', "\\\""))
}

/// A text for a comment: one line.
fn one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// The whole study.
pub(super) fn study_text(draft: &Draft, runs: &[DraftRun]) -> String {
    let mut out = String::from(
        "# Drafted by hysteron init: read the comments, correct what they doubt, then\n\
         #   hysteron check     this file     what is wrong with it\n\
         #   hysteron calibrate this file     values of the parameters\n\
         #   hysteron diagnose  this file     physics that the model leaves out\n\n",
    );
    let _ = writeln!(out, "title = {}", quoted(&draft.model));
    let _ = writeln!(
        out,
        "model = {}      # relative paths, the script's too, start from this folder",
        quoted(&draft.model)
    );
    write_parameters(&mut out, draft);
    for (number, run) in runs.iter().enumerate() {
        let is_last = runs.len() > 1 && number + 1 == runs.len();
        write_run(&mut out, draft, run, is_last);
    }
    out
}

/// Parameters with bounds around the values of the script, or numbers that could be parameters.
fn write_parameters(out: &mut String, draft: &Draft) {
    if draft.values.parameters.is_empty() {
        out.push_str(
            "\n# The script declares no parameter. Declare those to be found, in place of their `set`:\n\
             #   pset NAME VALUE\n# and list each here with its bounds:\n",
        );
        if draft.outline.candidates.is_empty() {
            out.push_str("#   [[parameter]]\n#   name  = \"Fy\"\n#   lower = 50.0\n#   upper = 200.0\n");
        }
        for c in &draft.outline.candidates {
            let [lower, upper] = bounds(c.value);
            let _ = writeln!(
                out,
                "#\n#   pset {} {:?}      in the script\n#   [[parameter]]\n#   name  = {}\n#   lower = {lower:?}\n#   upper = {upper:?}",
                c.name,
                c.value,
                quoted(&c.name)
            );
        }
        return;
    }
    for (name, value) in &draft.values.parameters {
        let [lower, upper] = bounds(*value);
        let _ = writeln!(
            out,
            "\n[[parameter]]\nname  = {}\nlower = {lower:?}      # {value:?} in the script",
            quoted(name)
        );
        let _ = writeln!(out, "upper = {upper:?}");
        if *value == 0.0 {
            out.push_str("# A value of 0 has no range of its own: give the bounds that make sense.\n");
        }
    }
}

/// Half and twice a value, the lower one first.
fn bounds(value: f64) -> [f64; 2] {
    // Round-off such as 0.30000000000000004 is no bound that anyone would write.
    let (a, b) = (without_round_off(LOWER * value), without_round_off(UPPER * value));
    if value == 0.0 { [-1.0, 1.0] } else { [a.min(b), a.max(b)] }
}

/// A run with its observed channels.
fn write_run(out: &mut String, draft: &Draft, run: &DraftRun, is_last: bool) {
    let _ = writeln!(out, "\n[[run]]\nname      = {}", quoted(&run.name));
    match is_last {
        true => out.push_str("role      = \"holdout\"      # judges the result; make it \"fit\" to use it\n"),
        false => out.push_str("role      = \"fit\"\n"),
    }
    let _ = writeln!(out, "recording = {}", quoted(&run.path));
    write_set(out, draft, run);
    if let Some(why) = &run.failure {
        let _ = writeln!(out, "# The script did not end with its own values: {}", one_line(why));
        if run.matches.iter().all(Option::is_none) {
            write_unrun(out, run);
            return;
        }
    }
    let columns = run.recording.columns.iter().zip(&run.matches);
    let observed =
        columns.clone().filter_map(|(c, m)| Some((c, m.as_ref()?))).filter(|(c, m)| varies(c) && m.is_response());
    let mut observed: Vec<(&Column, &Match)> = observed.collect();
    if observed.is_empty() {
        let best = columns.clone().filter_map(|(c, m)| Some((c, m.as_ref()?))).filter(|(c, _)| varies(c));
        let best = best.max_by(|a, b| a.1.correlation.abs().total_cmp(&b.1.correlation.abs()));
        observed.extend(best);
        if !observed.is_empty() {
            out.push_str("\n# A GUESS: no column of the recording follows an output of the script well.\n");
        }
    }
    for (c, m) in &observed {
        write_channel(out, c, m);
        let is_same = |o: &&(&Column, &Match)| o.0.name != c.name && o.1.file == m.file && o.1.column == m.column;
        if let Some((other, _)) = observed.iter().find(is_same) {
            let _ = writeln!(out, "# CHECK: {} has this column too, and one of them is wrong.", one_line(&other.name));
        }
    }
    if observed.is_empty() {
        write_missing(out, run);
    }
    for (c, m) in columns.filter(|(c, _)| !observed.iter().any(|(o, _)| o.name == c.name)) {
        let why = match m {
            _ if !varies(c) => "constant: context for the diagnosis".to_owned(),
            Some(m) if m.is_imposed() => {
                format!("is the motion that the script imposes ({} column {})", m.file, m.column)
            }
            Some(m) => format!("follows no output; the nearest is {} column {}, {}", m.file, m.column, certainty(m)),
            None => match recorded_quantity(c).filter(|q| !run.recorded.contains(q)) {
                Some(q) => format!("it is {q}, and the script records none: a recorder with -time and -file is needed"),
                None => "follows no output".to_owned(),
            },
        };
        let _ = writeln!(out, "\n# {} of the recording is not observed: {why}.", one_line(&c.name));
    }
}

/// The variables that a run sets, and those that it could.
fn write_set(out: &mut String, draft: &Draft, run: &DraftRun) {
    if !run.set.is_empty() {
        let shown = |v: &str| if v.parse::<f64>().is_ok() { v.to_owned() } else { quoted(v) };
        let pairs: Vec<String> = run.set.iter().map(|(n, v)| format!("{n} = {}", shown(v))).collect();
        let _ = writeln!(out, "set       = {{ {} }}", pairs.join(", "));
        if run.set.len() > run.guessed.len() {
            out.push_str("# The file has the name of the recording.\n");
        }
        if !run.guessed.is_empty() {
            let _ = writeln!(out, "# A GUESS, since the script has no value: {}.", run.guessed.join(", "));
        }
    }
    let others = draft.outline.optional.iter().filter(|o| !run.set.iter().any(|(n, _)| n == *o));
    for name in others {
        match draft.values.variables.get(name) {
            Some(value) => {
                let _ = writeln!(
                    out,
                    "# The script takes {name} too: {} in it. Set it here if this run has another.",
                    one_line(value)
                );
            }
            None => {
                let _ = writeln!(out, "# The script takes {name} too, and has no value of it.");
            }
        }
    }
}

fn varies(column: &Column) -> bool {
    let mut present = column.values.iter().filter(|v| v.is_finite());
    present.next().is_some_and(|first| present.any(|v| v != first))
}

/// Certainty of a match, in words.
fn certainty(m: &Match) -> String {
    let name = match (m.by_name, m.by_quantity) {
        (true, _) => "the names agree",
        (false, true) => "the quantities agree, the names do not tell",
        (false, false) => "the names do not tell",
    };
    match m.correlation.is_nan() {
        true => format!("{name}, no correlation"),
        false => format!("{name}, correlation {:.3}", m.correlation),
    }
}

fn write_channel(out: &mut String, column: &Column, m: &Match) {
    out.push_str("\n[[run.observe]]\n");
    let unit = if column.unit.is_empty() { String::new() } else { format!("      # in {}", column.unit) };
    let _ = writeln!(out, "channel = {}{unit}", quoted(&column.name));
    let _ = writeln!(out, "output  = {}", quoted(&m.file));
    let _ = writeln!(out, "column  = {}      # {}", m.column, certainty(m));
    if !m.place.is_empty() {
        let _ = writeln!(out, "at      = {}", quoted(&m.place));
    }
    if m.correlation.is_finite() && m.factor.is_finite() {
        let _ = writeln!(out, "# recorded = {:.4} x simulated, with the script's own values", m.factor);
    }
    if m.correlation < 0.0 {
        out.push_str("# The correlation is negative. If the sign of the channel is turned:\n# factor = -1.0\n");
    }
}

/// Advice where the script has no outputs, since it did not run.
fn write_unrun(out: &mut String, run: &DraftRun) {
    out.push_str(
        "# Its outputs are not known, and no channel could be matched. Mend this, and draft the study again.\n",
    );
    if let Some(name) = &run.unknown_variable {
        let _ = writeln!(out, "# A run gives the script its values: set = {{ {name} = ... }}");
    }
    let moves = |c: &&Column| {
        matches!(recorded_quantity(c), Some(Quantity::Length | Quantity::Velocity | Quantity::Acceleration))
    };
    if let Some(motion) = run.recording.columns.iter().find(moves) {
        let _ = writeln!(
            out,
            "# A channel as the motion of the script. Where the script has -filePath $motion, a draft takes this file for it:\n\
             #   hysteron recording {} --channel {} --out {}",
            quoted(&run.path),
            quoted(&motion.name),
            quoted(&Path::new(&run.path).with_extension("txt").to_string_lossy())
        );
    }
}

/// Advice where nothing could be matched.
fn write_missing(out: &mut String, run: &DraftRun) {
    out.push_str("\n# No output of the script could be matched. A recorder with -file and -time is needed; then:\n");
    let name = run.recording.columns.first().map_or("force", |c| &c.name);
    let _ = writeln!(
        out,
        "#   [[run.observe]]\n#   channel = {}\n#   output  = \"force.out\"\n#   column  = 1",
        quoted(name)
    );
}
