//! `report.html`: the verdict, then its evidence.

use super::error_conditions::{conditions, error_over};
use crate::evidence::parametric_bootstrap::{EqualGain, percent};
use crate::verdict::diagnosis::Diagnosis;
use crate::verdict::residual_force::ResidualForce;
use hysteron_identify::calibrate::{AmplitudeGroup, amplitude_groups};
use hysteron_identify::preflight::Preflight;
use hysteron_identify::report::html::{self, escaped, labelled, line, number, picture, table};
use hysteron_identify::study::{ObservedChannel, Role, ScoredRun, Study};
use hysteron_opensees::chart::{Bars, Figure};
use std::fmt::Write as _;

/// Text of the report. `text` is the user's script.
pub fn report(d: &Diagnosis, study: &Study, text: &str) -> String {
    let title = if study.title.is_empty() { &study.model } else { &study.title };
    let mut out = html::head(&format!("Diagnosis: {title}"));
    let summary = &d.outcome.verdict.summary;
    html::summary(&mut out, &summary.what, &summary.parts());
    out.extend(d.outcome.preflight.iter().map(Preflight::html));
    let page = Page { d, study };
    page.error_bars(&mut out);
    page.errors_on_structure(&mut out);
    d.device_loop.iter().for_each(|l| picture(&mut out, &l.figure()));
    missing_forces(&mut out, &d.outcome.residual_forces);
    page.worst_channel(&mut out);
    page.errors(&mut out);
    mismatch_table(&mut out, d);
    page.cycle_errors(&mut out);
    for i in 0..study.runs.len() {
        page.figures(&mut out, i);
    }
    script_changes(&mut out, text, &d.repaired_script);
    let _ = writeln!(out, "<h2>What would decide it</h2>\n<p>{}.</p>", escaped(&d.outcome.next_test));
    statistics(&mut out, d);
    html::end(out)
}

/// Name and channels of the models that are compared with a recording: the model before, and after.
type Models<'a> = Vec<(&'static str, &'a [f64])>;

/// Diagnosis and study of the page.
struct Page<'a> {
    d: &'a Diagnosis,
    study: &'a Study,
}

impl Page<'_> {
    /// True if the repaired model is another one than the fitted model of the user.
    fn is_repaired(&self) -> bool {
        self.d.outcome.verdict.cause != "none"
    }

    fn models(&self, run: usize, channel: usize) -> Models<'_> {
        let all = [("model as it was", &self.d.baseline_fits), ("repaired", &self.d.repaired_fits)];
        let shown = all.into_iter().take(if self.is_repaired() { 2 } else { 1 });
        shown.filter_map(|(name, fits)| Some((name, fits[run].as_ref()?.channels[channel].as_slice()))).collect()
    }

    /// NMSE of a channel of a run, before or after; NaN without a result.
    fn nmse(all: &[Option<ScoredRun>], run: usize, channel: usize) -> f64 {
        all[run].as_ref().map_or(f64::NAN, |f| f.scores[channel].nmse)
    }

    fn channels(&self) -> impl Iterator<Item = (usize, usize)> {
        self.study.runs.iter().enumerate().flat_map(|(i, r)| (0..r.observe.len()).map(move |k| (i, k)))
    }

    /// Errors of all channels before and after, as bars.
    fn error_bars(&self, out: &mut String) {
        let name = |(i, k): (usize, usize)| {
            let run = &self.study.runs[i];
            let held_out = if run.role == Role::Fit { "" } else { " (held out)" };
            format!("{}, {}{held_out}", run.observe[k].channel, run.name)
        };
        let of = |all: &[Option<ScoredRun>]| self.channels().map(|(i, k)| Self::nmse(all, i, k)).collect::<Vec<_>>();
        let mut series = vec![("model as it was".to_owned(), of(&self.d.baseline_fits))];
        if self.is_repaired() {
            series.push(("repaired".into(), of(&self.d.repaired_fits)));
        }
        let bars = Bars {
            title: "Error of each channel".into(),
            label: "NMSE: squared error over the variance of the recording".into(),
            names: self.channels().map(name).collect(),
            series,
        };
        html::bars(out, &bars);
    }

    /// Errors at the places of the sensors, before and after the repair.
    fn errors_on_structure(&self, out: &mut String) {
        let (places, drawing) = (&self.d.outcome.verdict.summary.places, &self.d.drawing);
        let models = [
            ("Errors on the structure: model as it was", &self.d.baseline_fits),
            ("Errors on the structure: repaired", &self.d.repaired_fits),
        ];
        for (title, fits) in models.into_iter().take(if self.is_repaired() { 2 } else { 1 }) {
            let figure = drawing.figure(title, places, |run, channel| Self::nmse(fits, run, channel));
            figure.iter().for_each(|f| picture(out, f));
        }
    }

    /// The channel with the largest error before the repair, over time and over the conditions of the motion.
    fn worst_channel(&self, out: &mut String) {
        let error = |c: &(usize, usize)| Self::nmse(&self.d.baseline_fits, c.0, c.1);
        let known = self.channels().filter(|c| error(c).is_finite());
        if let Some((run, channel)) = known.max_by(|a, b| error(a).total_cmp(&error(b))) {
            let mut figure = self.history(run, channel);
            figure.title = format!("Largest error: {}, run {}", figure.title, self.study.runs[run].name);
            picture(out, &figure);
            self.over_conditions(out, run, channel);
        }
    }

    /// Error of a channel over amplitude and rate of the motion, and over recorded temperatures.
    fn over_conditions(&self, out: &mut String, run: usize, channel: usize) {
        let (r, o) = (&self.study.runs[run], &self.study.runs[run].observe[channel]);
        let own = || (labelled(&o.channel, &o.unit), o.values.clone());
        let (name, motion) = self.d.displacements[run].clone().unwrap_or_else(own);
        for condition in conditions(&r.recording, &name, &motion) {
            let less = |y: &[f64]| y.iter().zip(&o.values).map(|(y, v)| y - v).collect::<Vec<f64>>();
            let curve = |(name, y): (&'static str, &[f64])| line(name, error_over(&condition.values, &less(y)));
            let figure = Figure {
                title: format!("{}, run {}: where its error is", o.channel, r.name),
                x_label: condition.label.clone(),
                y_label: labelled("root mean square error", &o.unit),
                curves: self.models(run, channel).into_iter().map(curve).collect(),
                ..Figure::default()
            };
            picture(out, &figure);
        }
    }

    /// A channel over time, with the windows of most of its error shaded.
    fn history(&self, run: usize, channel: usize) -> Figure {
        let (r, o) = (&self.study.runs[run], &self.study.runs[run].observe[channel]);
        let t = &r.recording.times;
        let simulated = self.models(run, channel).into_iter().map(|(name, y)| line(name, over(t, y)));
        Figure {
            title: format!("{}{}", o.channel, place(o)),
            x_label: "time [s]".into(),
            y_label: labelled(&o.channel, &o.unit),
            shaded: self.windows(run, channel),
            curves: std::iter::once(html::recorded(over(t, &o.values))).chain(simulated).collect(),
            ..Figure::default()
        }
    }

    fn windows(&self, run: usize, channel: usize) -> Vec<(f64, f64)> {
        let r = &self.study.runs[run];
        let channel = &r.observe[channel].channel;
        let located = self.d.outcome.mismatch.iter().find(|m| m.run == r.name && m.channel == *channel);
        located.iter().flat_map(|m| &m.windows).map(|w| (w[0], w[1])).collect()
    }
}

fn place(o: &ObservedChannel) -> String {
    if o.at.is_empty() { String::new() } else { format!(", {}", o.at) }
}

fn over(x: &[f64], y: &[f64]) -> Vec<(f64, f64)> {
    x.iter().copied().zip(y.iter().copied()).filter(|p| p.0.is_finite() && p.1.is_finite()).collect()
}

impl Page<'_> {
    /// Errors of all runs and values of all parameters, before and after the repair.
    fn errors(&self, out: &mut String) {
        let (d, study) = (self.d, self.study);
        out.push_str("<h2>Errors and parameters</h2>\n");
        let error = |all: &[Option<ScoredRun>], i: usize| {
            all[i].as_ref().map_or("no answer".into(), |f| number(f.nmse(&study.runs[i].observe)))
        };
        let rows = study.runs.iter().enumerate().map(|(i, r)| {
            let role = if r.role == Role::Fit { "fitted" } else { "held out" };
            vec![r.name.clone(), role.into(), error(&d.baseline_fits, i), error(&d.repaired_fits, i)]
        });
        let columns = if self.is_repaired() { 4 } else { 3 };
        let rows = rows.map(|r| r.into_iter().take(columns).collect());
        table(out, &["run", "role", "NMSE before", "NMSE after"][..columns], rows);
        let rows = d.outcome.corrected.parameters.iter().map(|(name, v)| {
            let was = d.outcome.baseline.parameters.get(name).map_or("added".into(), |x| number(*x));
            let is_unused = d.outcome.corrected.unused.contains(name);
            vec![name.clone(), was, if is_unused { "no longer used".into() } else { number(*v) }]
        });
        table(out, &["parameter", "before", "after"], rows);
    }

    /// Figures of a run: resistances over displacement, channels over time, errors over time, and simulated over recorded.
    fn figures(&self, out: &mut String, run: usize) {
        let r = &self.study.runs[run];
        let role = if r.role == Role::Fit { "fitted" } else { "held out" };
        let _ = writeln!(out, "<h2>{} ({role})</h2>", escaped(&r.name));
        for (k, o) in r.observe.iter().enumerate() {
            let (models, y_label) = (self.models(run, k), labelled(&o.channel, &o.unit));
            if let Some((name, u)) = self.d.displacements[run].as_ref().filter(|_| o.is_resistance()) {
                let simulated = models.iter().map(|(name, y)| line(name, over(u, y)));
                let curves = std::iter::once(html::recorded(over(u, &o.values))).chain(simulated).collect();
                let (title, x_label) = (format!("Loops{}", place(o)), name.clone());
                picture(out, &Figure { title, x_label, y_label: y_label.clone(), curves, ..Figure::default() });
            }
            let mut figure = self.history(run, k);
            picture(out, &figure);
            let grey = if figure.shaded.is_empty() { "" } else { " (grey: most of the error)" };
            figure.title = format!("{}: simulated less recorded{}{grey}", o.channel, place(o));
            let less = |y: &[f64]| y.iter().zip(&o.values).map(|(y, v)| y - v).collect::<Vec<f64>>();
            figure.curves = models.iter().map(|(name, y)| line(name, over(&r.recording.times, &less(y)))).collect();
            picture(out, &figure);
            html::open_details(out, &format!("{}: simulated over recorded", o.channel));
            picture(out, &html::scatter(&format!("{}{}", o.channel, place(o)), &y_label, &o.values, &models));
            html::close_details(out);
        }
    }

    /// Errors of stiffness, energy and damping of cycles, where resistances are recorded over displacements.
    fn cycle_errors(&self, out: &mut String) {
        let (d, study) = (self.d, self.study);
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
            let head = [
                "run",
                "channel",
                "amplitude",
                "cycles",
                "K before",
                "after",
                "E before",
                "after",
                "ξ before",
                "after",
            ];
            table(out, &head, rows);
        }
    }
}

/// The statistics behind the verdict, each with its meaning.
fn statistics(out: &mut String, d: &Diagnosis) {
    out.push_str("<h2>Statistics</h2>\n");
    html::open_details(out, "Probabilities, bootstrap and ranking");
    let v = &d.outcome.verdict;
    let explained = |out: &mut String, text: &str| {
        let _ = writeln!(out, "<p>{}</p>", escaped(text));
    };
    explained(out, &format!("{} ({:.1} %): {}", v.cause, 100.0 * v.confidence, v.explanation));
    explained(
        out,
        "Probabilities. They compare the causes of the library with each other, with a complete model (none) and with something \
         outside the library (unknown), and add up to one.",
    );
    out.push_str("<table>\n");
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
        explained(
            out,
            "Bootstrap. Recordings were simulated with a known cause and with noise like that of the rest, and diagnosed again. A \
             gain that noise or another cause produces often is no evidence.",
        );
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
    if d.structured_share > 0.0 {
        let share = format!("Structured share. {:.0} % of what the best form leaves ", 100.0 * d.structured_share);
        explained(
            out,
            &(share + &format!("is no noise: {}. It makes an effect outside the library likelier.", d.structure)),
        );
    }
    explained(
        out,
        "Ranking. The log evidence says how well a form predicts blocks of samples that it was not fitted to; a form that is \
         larger by 3 predicts them 20 times as well. The NMSE is that of the fitted samples.",
    );
    let rows = d.ranking.iter().map(|w| {
        vec![w.cause.to_owned(), w.form.clone(), w.location.clone(), number(w.objective), number(w.log_evidence)]
    });
    table(out, &["cause", "form", "place", "NMSE fitted", "log evidence"], rows);
    html::close_details(out);
}

/// Places whose missing force is drawn in one chart, at most.
const MAX_PLACES: usize = 4;

/// Forces that the model lacks: the first in words, all of its run over time, and the first over the deformation.
fn missing_forces(out: &mut String, forces: &[ResidualForce]) {
    let Some(first) = forces.first() else { return };
    let _ = writeln!(out, "<h2>What the model lacks</h2>\n<p>{}</p>", escaped(&first.text.join(" ")));
    let of_run = forces.iter().filter(|f| f.run == first.run && f.unit == first.unit).take(MAX_PLACES);
    let y_label = labelled("recorded less simulated force", &first.unit);
    let over_time = Figure {
        title: format!("Missing force, run {}", first.run),
        x_label: "time [s]".into(),
        y_label: y_label.clone(),
        shaded: first.windows.iter().map(|w| (w[0], w[1])).collect(),
        curves: of_run.map(|f| line(&f.place, over(&f.course.times, &f.course.force))).collect(),
        ..Figure::default()
    };
    picture(out, &over_time);
    if let Some((deformation, direction)) = &first.course.deformation {
        let over_deformation = Figure {
            title: format!("Missing force of {}, run {}", first.place, first.run),
            x_label: format!("deformation towards {direction}, simulated"),
            y_label,
            curves: vec![line("", over(deformation, &first.course.force))],
            ..Figure::default()
        };
        picture(out, &over_deformation);
    }
    let rows = forces.iter().map(|f| {
        let windows: Vec<String> = f.windows.iter().map(|w| format!("{:.2}-{:.2}", w[0], w[1])).collect();
        let parts: Vec<String> = f.parts.iter().map(|p| format!("{} {:.0} %", p.follows, 100.0 * p.share)).collect();
        let ratio = format!("{:.0} %", 100.0 * f.ratio);
        vec![f.run.clone(), f.place.clone(), number(f.rms), f.unit.clone(), ratio, windows.join(", "), parts.join(", ")]
    });
    table(out, &["run", "place", "r.m.s.", "unit", "of recorded", "windows [s]", "follows"], rows);
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

/// The script with deleted and inserted lines marked.
fn script_changes(out: &mut String, before: &str, after: &str) {
    out.push_str("<h2>What changes in the script</h2>\n<pre>");
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
