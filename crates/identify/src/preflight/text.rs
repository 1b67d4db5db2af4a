//! Findings in words.

use super::{ChannelCheck, Finding, FindingKind, Preflight};
use crate::report::significant;
use crate::study::{Role, Study};
use std::collections::BTreeMap;
use std::fmt::Write as _;

/// Factors of one fault agree between runs to this part.
const SAME_FACTOR: f64 = 0.5;

/// Findings of one kind and channel, joined over the runs, the hard ones first. Each message begins with channel and runs.
pub(super) fn merged(findings: Vec<Finding>, study: &Study) -> Vec<Finding> {
    let mut out: Vec<Finding> = vec![];
    for f in findings {
        let agree = |a: Option<f64>, b: Option<f64>| match (a, b) {
            (Some(a), Some(b)) => (a - b).abs() <= SAME_FACTOR * a.abs().max(b.abs()),
            _ => a.is_none() && b.is_none(),
        };
        let same = out.iter_mut().find(|o| {
            o.kind == f.kind && o.channel == f.channel && agree(o.factor, f.factor) && agree(o.lag_s, f.lag_s)
        });
        match same {
            Some(o) if !o.runs.contains(&f.runs[0]) => {
                o.is_hard |= f.is_hard;
                o.runs.extend(f.runs);
            }
            Some(_) => {}
            None => out.push(f),
        }
    }
    // One fault explains a channel in all runs. Where runs disagree, the most of them are right.
    let of_channel = |f: &Finding| f.kind <= FindingKind::Acceleration;
    let most: BTreeMap<String, usize> = out.iter().filter(|f| of_channel(f)).fold(BTreeMap::new(), |mut most, f| {
        let n: &mut usize = most.entry(f.channel.clone()).or_default();
        *n = (*n).max(f.runs.len());
        most
    });
    let mut is_taken: Vec<String> = vec![];
    out.retain(|f| {
        let is_first = f.runs.len() == most.get(&f.channel).copied().unwrap_or(0) && !is_taken.contains(&f.channel);
        if of_channel(f) && is_first {
            is_taken.push(f.channel.clone());
        }
        !of_channel(f) || is_first
    });
    for f in &mut out {
        let with_channel = study.runs.iter().filter(|r| r.recording.column(&f.channel).is_some()).count();
        let is_everywhere = f.runs.len() == with_channel && with_channel > 1;
        let place = if is_everywhere { "all runs".to_owned() } else { f.runs.join(", ") };
        f.message = format!("{} in {place}: {}", f.channel, f.message);
    }
    out.sort_by_key(|f| !f.is_hard);
    out
}

/// Comparisons of all channels as a table.
pub fn section(preflight: &Preflight, study: &Study) -> String {
    let mut out = String::new();
    let columns = ["role", "run", "channel", "samples", "NMSE", "r", "factor", "offset", "lag [s]"];
    let row = |c: &ChannelCheck| {
        let role = study.runs.iter().find(|r| r.name == c.run).map_or("", |r| match r.role {
            Role::Fit => "fit",
            Role::Holdout => "holdout",
        });
        let after = if c.dropped > 0 { format!("{} (+{} after)", c.samples, c.dropped) } else { c.samples.to_string() };
        [
            role.into(),
            c.run.clone(),
            c.channel.clone(),
            after,
            format!("{:.4}", c.nmse),
            format!("{:.3}", c.correlation),
            significant(c.factor, 3),
            significant(c.offset, 3),
            significant(c.lag_s, 3),
        ]
    };
    let mut rows = vec![columns.map(str::to_owned)];
    rows.extend(preflight.channels.iter().map(row));
    let width = |k: usize| rows.iter().map(|r| r[k].chars().count()).max().unwrap_or(0);
    let widths: Vec<usize> = (0..columns.len()).map(width).collect();
    for r in &rows {
        let cells = r.iter().zip(&widths).enumerate();
        let cells = cells.map(|(k, (c, w))| if k < 3 { format!("{c:w$}") } else { format!("{c:>w$}") });
        let _ = writeln!(out, "  {}", cells.collect::<Vec<_>>().join("  ").trim_end());
    }
    for f in &preflight.failures {
        let _ = writeln!(out, "  {}: {}", f.run, f.message);
    }
    out
}
