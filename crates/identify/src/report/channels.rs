//! Channels as CSV files: recorded, simulated, and the residual.

use crate::study::{ScoredRun, Study};
use std::fmt::Write as _;

/// Responses of a model, by run of the study: its name in the headers, and the runs; none for a run without a result.
pub type NamedResponses<'a> = (&'a str, Vec<Option<&'a ScoredRun>>);

/// A CSV file for each run of a study: its name and text.
///
/// The columns are `time[s]`, then for each channel `NAME_recorded[UNIT]`, one column for each model, and
/// `NAME_residual[UNIT]`, which is the last model less the recording. A missing value is an empty cell.
pub fn channel_files(study: &Study, models: &[NamedResponses<'_>]) -> Vec<(String, String)> {
    let mut out: Vec<(String, String)> = vec![];
    for (i, run) in study.runs.iter().enumerate() {
        let mut columns: Vec<(String, Vec<f64>)> = vec![("time[s]".into(), run.recording.times.clone())];
        for (k, o) in run.observe.iter().enumerate() {
            let unit = if o.unit.is_empty() { String::new() } else { format!("[{}]", o.unit) };
            let mut add = |what: &str, values: Vec<f64>| columns.push((format!("{}_{what}{unit}", o.channel), values));
            add("recorded", o.values.clone());
            let missing = || vec![f64::NAN; o.values.len()];
            let mut last = missing();
            for (name, runs) in models {
                last = runs.get(i).copied().flatten().map_or_else(missing, |r| r.channels[k].clone());
                add(name, last.clone());
            }
            add("residual", last.iter().zip(&o.values).map(|(simulated, recorded)| simulated - recorded).collect());
        }
        let stem: String =
            run.name.chars().map(|c| if c.is_alphanumeric() || "-_.".contains(c) { c } else { '_' }).collect();
        let taken = out.iter().any(|(name, _)| *name == format!("{stem}.csv"));
        let name = if taken { format!("{stem}-{}.csv", i + 1) } else { format!("{stem}.csv") };
        out.push((name, csv(&columns)));
    }
    out
}

/// Columns of one length as CSV.
fn csv(columns: &[(String, Vec<f64>)]) -> String {
    let quoted = |header: &String| match header.contains([',', '"']) {
        true => format!("\"{}\"", header.replace('"', "\"\"")),
        false => header.clone(),
    };
    let mut out = columns.iter().map(|(header, _)| quoted(header)).collect::<Vec<_>>().join(",") + "\n";
    for row in 0..columns.first().map_or(0, |c| c.1.len()) {
        for (i, (_, values)) in columns.iter().enumerate() {
            let separator = if i == 0 { "" } else { "," };
            out += separator;
            if values[row].is_finite() {
                let _ = write!(out, "{:?}", values[row]);
            }
        }
        out.push('\n');
    }
    out
}
