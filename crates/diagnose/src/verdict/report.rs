//! `report.html`: the verdict, then its evidence.

use crate::evidence::parametric_bootstrap::{EqualGain, percent};
use crate::verdict::diagnosis::Diagnosis;
use hysteron_identify::calibrate::{AmplitudeGroup, amplitude_groups};
use hysteron_identify::preflight::Preflight;
use hysteron_identify::report::html::{self, escaped, labelled, line, number, picture, table};
use hysteron_identify::study::{Role, ScoredRun, Study};
use hysteron_opensees::chart::Figure;
use std::fmt::Write as _;

/// Text of the report. `text` is the user's script.
pub fn report(d: &Diagnosis, study: &Study, text: &str) -> String {
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
    out.extend(d.outcome.preflight.iter().map(Preflight::html));
    errors(&mut out, d, study);
    evidence(&mut out, d);
    mismatch_table(&mut out, d);
    cycle_errors(&mut out, d, study);
    for i in 0..study.runs.len() {
        figures(&mut out, d, study, i);
    }
    script_changes(&mut out, text, &d.repaired_script);
    let _ = writeln!(out, "<h2>Next test</h2>\n<p>{}</p>", escaped(&d.outcome.next_test));
    html::end(out)
}

/// Errors of all runs and values of all parameters, before and after the repair.
fn errors(out: &mut String, d: &Diagnosis, study: &Study) {
    out.push_str("<h2>Gain</h2>\n");
    let error = |all: &[Option<ScoredRun>], i: usize| {
        all[i].as_ref().map_or("no answer".into(), |f| number(f.nmse(&study.runs[i].observe)))
    };
    let rows = study.runs.iter().enumerate().map(|(i, r)| {
        let role = if r.role == Role::Fit { "fitted" } else { "held out" };
        vec![r.name.clone(), role.into(), error(&d.baseline_fits, i), error(&d.repaired_fits, i)]
    });
    table(out, &["run", "role", "NMSE before", "NMSE after"], rows);
    let rows = d.outcome.corrected.parameters.iter().map(|(name, v)| {
        let was = d.outcome.baseline.parameters.get(name).map_or("added".into(), |x| number(*x));
        vec![name.clone(), was, number(*v)]
    });
    table(out, &["parameter", "before", "after"], rows);
}

/// Probabilities of all causes, the bootstrap, and the ranking.
fn evidence(out: &mut String, d: &Diagnosis) {
    out.push_str("<h2>Evidence</h2>\n<table>\n");
    let v = &d.outcome.verdict;
    let first = (v.cause.as_str(), v.confidence);
    for (cause, p) in std::iter::once(first).chain(v.also_possible.iter().map(|c| (c.cause.as_str(), c.confidence))) {
        let _ = writeln!(
            out,
            "<tr><td>{}</td><td class=\"n\">{:.1} %</td><td><span class=\"bar\" style=\"width:{:.0}px\"></span></td></tr>",
            escaped(cause),
            100.0 * p,
            300.0 * p
        );
    }
    out.push_str("</table>\n");
    if let Some(b) = &d.outcome.bootstrap {
        let mut rows = vec![];
        if let Some(chance) = b.chance {
            rows.push(vec!["none".into(), "some cause gains as much".into(), percent(chance)]);
        }
        rows.push(vec![b.cause.into(), "it has the most evidence".into(), percent(b.found)]);
        let equal_gain =
            |s: &EqualGain| vec![s.cause.into(), format!("{} gains as much over it", b.cause), percent(s.share)];
        rows.extend(b.not_told_apart.iter().map(equal_gain));
        table(out, &[&format!("{} recordings made by", b.recordings), "in which", "part"], rows);
    }
    let rows = d.ranking.iter().map(|w| {
        vec![w.cause.to_owned(), w.form.clone(), w.location.clone(), number(w.objective), number(w.log_evidence)]
    });
    table(out, &["cause", "form", "place", "NMSE fitted", "log evidence"], rows);
}

/// Windows of time in which the baseline differed.
fn mismatch_table(out: &mut String, d: &Diagnosis) {
    out.push_str("<h2>Where the model differed</h2>\n");
    let rows = d.outcome.mismatch.iter().map(|m| {
        let windows: Vec<String> = m.windows.iter().map(|w| format!("{:.2}-{:.2}", w[0], w[1])).collect();
        let share = format!("{:.0} %", 100.0 * m.share);
        vec![m.run.clone(), m.channel.clone(), m.at.clone(), windows.join(", "), share, m.regime.clone()]
    });
    table(out, &["run", "channel", "place", "windows [s]", "share", "regime"], rows);
}

/// Figures of a run: resistances over displacement, channels over time, and errors over time.
fn figures(out: &mut String, d: &Diagnosis, study: &Study, run: usize) {
    let r = &study.runs[run];
    let role = if r.role == Role::Fit { "fitted" } else { "held out" };
    let _ = writeln!(out, "<h2>{} ({role})</h2>", escaped(&r.name));
    let t = &r.recording.times;
    for (k, o) in r.observe.iter().enumerate() {
        let over = |x: &[f64], y: &[f64]| -> Vec<(f64, f64)> {
            x.iter().copied().zip(y.iter().copied()).filter(|p| p.0.is_finite() && p.1.is_finite()).collect()
        };
        let models = [("model as it was", &d.baseline_fits), ("repaired", &d.repaired_fits)];
        let models = models.map(|(name, all)| (name, all[run].as_ref().map(|f| &f.channels[k])));
        let place = if o.at.is_empty() { String::new() } else { format!(", {}", o.at) };
        let all = |x: &[f64]| {
            let simulated = models.iter().filter_map(|(name, y)| Some(line(name, over(x, y.as_ref()?))));
            std::iter::once(line("recorded", over(x, &o.values))).chain(simulated).collect::<Vec<_>>()
        };
        let y_label = labelled(&o.channel, &o.unit);
        if let Some((name, u)) = d.displacements[run].as_ref().filter(|_| o.is_resistance()) {
            let (title, x_label) = (format!("Loops{place}"), name.clone());
            picture(out, &Figure { title, x_label, y_label: y_label.clone(), curves: all(u), ..Figure::default() });
        }
        let mut figure = Figure {
            title: format!("{}{place}", o.channel),
            x_label: "time [s]".into(),
            y_label,
            curves: all(t),
            ..Figure::default()
        };
        picture(out, &figure);
        let located = d.outcome.mismatch.iter().find(|m| m.run == r.name && m.channel == o.channel);
        figure.shaded = located.iter().flat_map(|m| &m.windows).map(|w| (w[0], w[1])).collect();
        let grey = if figure.shaded.is_empty() { "" } else { "; most of the squared error lies in the grey" };
        figure.title = format!("Simulated less recorded{place}{grey}");
        figure.first_colour = 1;
        let less = |y: &[f64]| y.iter().zip(&o.values).map(|(y, v)| y - v).collect::<Vec<f64>>();
        figure.curves = models.iter().filter_map(|(name, y)| Some(line(name, over(t, &less(y.as_ref()?))))).collect();
        picture(out, &figure);
    }
}

/// Errors of stiffness, energy and damping of cycles, where resistances are recorded over displacements.
fn cycle_errors(out: &mut String, d: &Diagnosis, study: &Study) {
    let mut rows = vec![];
    for (i, run) in study.runs.iter().enumerate() {
        let Some((_, u)) = &d.displacements[i] else { continue };
        for (k, o) in run.observe.iter().enumerate().filter(|(_, o)| o.is_resistance()) {
            let (Some(before), Some(after)) = (&d.baseline_fits[i], &d.repaired_fits[i]) else { continue };
            let of = |f: &ScoredRun| amplitude_groups(u, &o.values, &f.channels[k]);
            for (b, a) in of(before).iter().zip(of(after)) {
                let percent = |pair: [f64; 2]| format!("{:+.1} %", 100.0 * AmplitudeGroup::error(pair));
                let pairs = [(b.stiffness, a.stiffness), (b.energy, a.energy), (b.damping, a.damping)];
                let errors = pairs.into_iter().flat_map(|(b, a)| [percent(b), percent(a)]);
                let what = [run.name.clone(), o.channel.clone(), number(b.amplitude), b.cycles.to_string()];
                rows.push(what.into_iter().chain(errors).collect());
            }
        }
    }
    if !rows.is_empty() {
        let _ = writeln!(
            out,
            "<h2>Cycles</h2>\n<p>Errors of secant stiffness K, dissipated energy E and equivalent damping ξ.</p>"
        );
        let head =
            ["run", "channel", "amplitude", "cycles", "K before", "after", "E before", "after", "ξ before", "after"];
        table(out, &head, rows);
    }
}

/// The script with deleted and inserted lines marked.
fn script_changes(out: &mut String, before: &str, after: &str) {
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
