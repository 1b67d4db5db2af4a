//! `report.html`: the verdict first, then what it rests on.

use super::pipeline::Diagnosis;
use crate::report::Figure;
use crate::report::html::{self, escaped, labelled, line, number, picture, table};
use crate::study::{Fit, Role, Study};
use std::fmt::Write as _;

/// The report. `text` is the user's script.
pub fn page(d: &Diagnosis, study: &Study, text: &str) -> String {
    let title = if study.title.is_empty() { &study.model } else { &study.title };
    let mut out = html::head(&format!("Diagnosis: {title}"));
    let v = &d.outcome.verdict;
    let also = if v.also.is_empty() { String::new() } else { format!(" and {}", v.also.join(", ")) };
    let _ = writeln!(
        out,
        "<p class=\"verdict\"><b>{}{}</b> ({:.0} %): {}</p>",
        escaped(&v.cause),
        escaped(&also),
        100.0 * v.confidence,
        escaped(&v.explanation)
    );
    gain(&mut out, d, study);
    evidence(&mut out, d);
    located(&mut out, d);
    for (i, run) in study.runs.iter().enumerate() {
        let role = if run.role == Role::Fit { "fitted" } else { "held out" };
        let _ = writeln!(out, "<h2>{} ({role})</h2>", escaped(&run.name));
        for (k, o) in run.observe.iter().enumerate() {
            let t = &run.recording.times;
            let over = |y: &[f64]| -> Vec<(f64, f64)> {
                t.iter().copied().zip(y.iter().copied()).filter(|p| p.1.is_finite()).collect()
            };
            let channel = |all: &[Option<Fit>]| all[i].as_ref().map(|f| f.channels[k].clone());
            let less = |y: Vec<f64>| y.iter().zip(&o.values).map(|(y, v)| y - v).collect::<Vec<f64>>();
            let (before, after) = (channel(&d.before), channel(&d.after));
            let place = if o.at.is_empty() { String::new() } else { format!(", {}", o.at) };
            let mut figure = Figure {
                title: format!("{}{place}", o.channel),
                x_label: "time [s]".into(),
                y_label: labelled(&o.channel, &o.unit),
                curves: vec![line("recorded", over(&o.values))],
                ..Figure::default()
            };
            let named = [("model as it was", &before), ("repaired", &after)];
            figure.curves.extend(named.iter().filter_map(|(n, y)| Some(line(n, over(y.as_ref()?)))));
            picture(&mut out, &figure);
            figure.title = format!("Simulated less recorded{place}");
            let residuals = [("model as it was", before), ("repaired", after)];
            figure.curves = residuals.into_iter().filter_map(|(n, y)| Some(line(n, over(&less(y?))))).collect();
            picture(&mut out, &figure);
        }
    }
    changed(&mut out, text, &d.script);
    let _ = writeln!(out, "<h2>Next test</h2>\n<p>{}</p>", escaped(&d.outcome.next_test));
    html::end(out)
}

/// Errors before and after, by run.
fn gain(out: &mut String, d: &Diagnosis, study: &Study) {
    out.push_str("<h2>Gain</h2>\n");
    let error = |all: &[Option<Fit>], i: usize| {
        all[i].as_ref().map_or("no answer".into(), |f| number(f.nmse(&study.runs[i].observe)))
    };
    let rows = study.runs.iter().enumerate().map(|(i, r)| {
        let role = if r.role == Role::Fit { "fitted" } else { "held out" };
        vec![r.name.clone(), role.into(), error(&d.before, i), error(&d.after, i)]
    });
    table(out, &["run", "role", "NMSE before", "NMSE after"], rows);
    let rows = d.outcome.corrected.parameters.iter().map(|(name, v)| {
        let was = d.outcome.baseline.parameters.get(name).map_or("added".into(), |x| number(*x));
        vec![name.clone(), was, number(*v)]
    });
    table(out, &["parameter", "before", "after"], rows);
}

/// Probabilities of all causes, and what each form came to.
fn evidence(out: &mut String, d: &Diagnosis) {
    out.push_str("<h2>Evidence</h2>\n<table>\n");
    let v = &d.outcome.verdict;
    let first = (v.cause.as_str(), v.confidence);
    for (cause, p) in std::iter::once(first).chain(v.also_possible.iter().map(|c| (c.cause.as_str(), c.confidence))) {
        let _ = writeln!(
            out,
            "<tr><td>{}</td><td>{:.1} %</td><td style=\"text-align:left\"><span class=\"bar\" style=\"width:{:.0}px\"></span></td></tr>",
            escaped(cause),
            100.0 * p,
            300.0 * p
        );
    }
    out.push_str("</table>\n");
    let rows = d
        .weighed
        .iter()
        .map(|w| vec![w.cause.to_owned(), w.form.clone(), w.at.clone(), number(w.objective), number(w.evidence)]);
    table(out, &["cause", "form", "place", "NMSE fitted", "log evidence"], rows);
}

fn located(out: &mut String, d: &Diagnosis) {
    out.push_str("<h2>Where the model differed</h2>\n");
    let rows = d.outcome.mismatch.iter().map(|m| {
        let windows: Vec<String> = m.windows.iter().map(|w| format!("{:.2}-{:.2}", w[0], w[1])).collect();
        let share = format!("{:.0} %", 100.0 * m.share);
        vec![m.run.clone(), m.channel.clone(), m.at.clone(), windows.join(", "), share, m.regime.clone()]
    });
    table(out, &["run", "channel", "place", "windows [s]", "share", "regime"], rows);
}

/// The script with what was changed in it: lines that are in one text only.
fn changed(out: &mut String, before: &str, after: &str) {
    out.push_str("<h2>The script</h2>\n<pre>");
    for change in similar::TextDiff::from_lines(before, after).iter_all_changes() {
        let text = escaped(change.value());
        let _ = match change.tag() {
            similar::ChangeTag::Equal => write!(out, "{text}"),
            similar::ChangeTag::Delete => write!(out, "<del>{text}</del>"),
            similar::ChangeTag::Insert => write!(out, "<ins>{text}</ins>"),
        };
    }
    out.push_str("</pre>\n");
}
