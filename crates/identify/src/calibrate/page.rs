//! Report of a calibration: one HTML file with all pictures in it.

use super::amplitude_groups::AmplitudeGroup;
use super::result::{CalibrationResult, Displacements, role_name};
use super::uncertainty::{Interval, Uncertainty};
use crate::preflight::Preflight;
use crate::report::html::{self, escaped, labelled, line, number, picture, table};
use crate::study::{ObservedChannel, ParameterKind, Role, Run, Score, ScoredRun};
use hysteron_opensees::chart::{Bars, Curve, Figure, Mark, spans_decades};
use std::fmt::Write as _;

/// The text of the report.
pub fn page(result: &CalibrationResult, displacements: &Displacements) -> String {
    let study = &result.study;
    let title = if study.title.is_empty() { &study.model } else { &study.title };
    let mut out = html::head(&format!("Calibration: {title}"));
    html::summary(&mut out, &first_sentence(result), &summary_parts(result));
    out.extend(result.preflight.iter().map(Preflight::html));
    error_bars(&mut out, result);
    worst_channel(&mut out, result);
    parameters(&mut out, result);
    runs(&mut out, result);
    for (i, ((run, scored), u)) in study.runs.iter().zip(&result.scored_runs).zip(displacements).enumerate() {
        if let Ok(scored) = scored {
            run_charts(&mut out, run, scored, u.as_ref(), result.amplitudes.get(i).map_or(&[], Vec::as_slice));
        }
    }
    convergence(&mut out, result);
    uncertainty(&mut out, result);
    html::end(out)
}

/// The errors in one sentence.
fn first_sentence(result: &CalibrationResult) -> String {
    let share = |nmse: f64| format!("{} %", number((1e4 * nmse).round() / 100.0));
    let held_out =
        result.nmse(Role::Holdout).map_or_else(String::new, |h| format!(", and {} of those held out", share(h)));
    format!("The model misses {} of the variance of the fitted recordings{held_out}.", share(result.objective))
}

/// Parameters with their intervals, and the search.
fn summary_parts(result: &CalibrationResult) -> Vec<(&'static str, String)> {
    let values = result.study.space.parameters.iter().zip(&result.values).map(|(p, v)| {
        let interval = result.uncertainty.iter().flat_map(|u| &u.intervals).find(|i| i.name == p.name);
        let interval = interval.map_or_else(String::new, |i| format!(" ({} to {})", number(i.lower), number(i.upper)));
        format!("{} = {}{interval}", p.name, number(*v))
    });
    let settings = &result.settings;
    let search = format!(
        "Objective (mean NMSE of the fitted channels) {}, {} evaluations in {:.1} s with {}{}, seed {}; {}.",
        number(result.objective),
        result.search.evaluations(),
        result.wall_time,
        settings.method.name(),
        if settings.polish { " and a least-squares polish" } else { "" },
        settings.seed,
        result.search.stopped_because().words()
    );
    vec![("Values", values.collect::<Vec<_>>().join(", ")), ("Search", search)]
}

/// Errors of all channels, as bars: fitted runs and runs held out.
fn error_bars(out: &mut String, result: &CalibrationResult) {
    let (mut names, mut fitted, mut held_out) = (vec![], vec![], vec![]);
    for (run, scored) in result.study.runs.iter().zip(&result.scored_runs) {
        for (k, o) in run.observe.iter().enumerate() {
            let nmse = scored.as_ref().map_or(f64::NAN, |s| s.scores[k].nmse);
            names.push(format!("{}, {}", o.channel, run.name));
            let is_fitted = run.role == Role::Fit;
            fitted.push(if is_fitted { nmse } else { f64::NAN });
            held_out.push(if is_fitted { f64::NAN } else { nmse });
        }
    }
    let mut series = vec![("fitted".to_owned(), fitted)];
    if held_out.iter().any(|x| x.is_finite()) {
        series.push(("held out".into(), held_out));
    }
    let label = "NMSE: squared error over the variance of the recording".into();
    html::bars(out, &Bars { title: "Error of each channel".into(), label, names, series });
}

/// The channel with the largest error over time.
fn worst_channel(out: &mut String, result: &CalibrationResult) {
    let runs = result.study.runs.iter().zip(&result.scored_runs).filter_map(|(r, s)| Some((r, s.as_ref().ok()?)));
    let channels = runs.flat_map(|(run, scored)| (0..run.observe.len()).map(move |k| (run, scored, k)));
    let error = |c: &(&Run, &ScoredRun, usize)| c.1.scores[c.2].nmse;
    if let Some((run, scored, k)) = channels.max_by(|a, b| error(a).total_cmp(&error(b))) {
        let mut figure = history(run, scored, k);
        figure.title = format!("Largest error: {}, run {}", figure.title, run.name);
        picture(out, &figure);
    }
}

fn location(o: &ObservedChannel) -> String {
    if o.at.is_empty() { String::new() } else { format!(", {}", o.at) }
}

fn over(x: &[f64], y: &[f64]) -> Vec<(f64, f64)> {
    x.iter().copied().zip(y.iter().copied()).filter(|p| p.0.is_finite() && p.1.is_finite()).collect()
}

/// A channel over time, recorded and simulated.
fn history(run: &Run, scored: &ScoredRun, channel: usize) -> Figure {
    let (o, t) = (&run.observe[channel], &run.recording.times);
    let simulated = line("simulated", over(t, &scored.channels[channel]));
    Figure {
        title: format!("{}{}", o.channel, location(o)),
        x_label: "time [s]".into(),
        y_label: labelled(&o.channel, &o.unit),
        curves: vec![html::recorded(over(t, &o.values)), simulated],
        ..Figure::default()
    }
}

fn parameters(out: &mut String, result: &CalibrationResult) {
    let space = &result.study.space;
    out.push_str("<h2>Parameters</h2>\n");
    let intervals = result.uncertainty.iter().flat_map(|u| &u.intervals);
    let rows = space.parameters.iter().zip(&result.values).map(|(p, v)| {
        let interval = intervals.clone().find(|i| i.name == p.name);
        let shown = interval.map(Interval::shown);
        let value = shown.as_ref().map_or_else(|| number(*v), |s| s[0].clone());
        let interval = shown.map_or(String::new(), |[_, lower, upper]| format!("{lower} to {upper}"));
        let range = match &p.kind {
            ParameterKind::Free(r) => format!("{} to {}", number(r.lower), number(r.upper)),
            ParameterKind::Fixed(_) => "fixed".into(),
            ParameterKind::Tied { text, .. } => format!("= {text}"),
        };
        vec![p.name.clone(), value, interval, range]
    });
    table(out, &["parameter", "value", "95 % interval", "range"], rows);
    let notes = result.uncertainty.iter().flat_map(Uncertainty::notes);
    let bounds = result
        .at_bounds()
        .into_iter()
        .filter(|_| result.uncertainty.is_none())
        .map(|n| format!("{n} is at a bound of its range"));
    let judgement = result.uncertainty.iter().flat_map(|u| u.judgement.sentences.clone());
    for note in notes.chain(bounds).chain(judgement) {
        let _ = writeln!(out, "<p class=\"note\">{}</p>", escaped(&note));
    }
}

fn runs(out: &mut String, result: &CalibrationResult) {
    out.push_str("<h2>Runs</h2>\n");
    let rows = result.study.runs.iter().zip(&result.scored_runs).flat_map(|(run, scored)| {
        let role = role_name(run.role).to_owned();
        match scored {
            Err(error) => vec![vec![run.name.clone(), role, error.to_string()]],
            Ok(scored) => {
                let row = |(o, s): (&ObservedChannel, &Score)| {
                    let missing = o.values.iter().filter(|v| v.is_nan()).count();
                    let counts = [s.samples, s.dropped, missing].map(|n| n.to_string());
                    [vec![run.name.clone(), role.clone(), o.channel.clone(), number(s.nmse)], counts.to_vec()].concat()
                };
                run.observe.iter().zip(&scored.scores).map(row).collect()
            }
        }
    });
    table(out, &["run", "role", "channel", "NMSE", "samples", "after the end", "missing"], rows);
    if let Some(h) = result.nmse(Role::Holdout) {
        let _ = writeln!(out, "<p>Mean NMSE of the holdout runs, never used to fit: <b>{}</b>.</p>", number(h));
    }
}

fn run_charts(
    out: &mut String,
    run: &Run,
    scored: &ScoredRun,
    displacement: Option<&(String, Vec<f64>)>,
    amplitudes: &[Vec<AmplitudeGroup>],
) {
    let _ = writeln!(out, "<h2>{} ({})</h2>", escaped(&run.name), role_name(run.role));
    let t = &run.recording.times;
    for (k, (o, simulated)) in run.observe.iter().zip(&scored.channels).enumerate() {
        let y_label = labelled(&o.channel, &o.unit);
        let loops = displacement.filter(|_| o.is_resistance());
        if let Some((name, u)) = loops {
            let figure = Figure {
                title: format!("Loops{}", location(o)),
                x_label: name.clone(),
                y_label: y_label.clone(),
                curves: vec![html::recorded(over(u, &o.values)), line("simulated", over(u, simulated))],
                ..Figure::default()
            };
            picture(out, &figure);
        }
        picture(out, &history(run, scored, k));
        let residual: Vec<f64> = simulated.iter().zip(&o.values).map(|(a, b)| a - b).collect();
        let figure = Figure {
            title: format!("Simulated less recorded{}", location(o)),
            x_label: "time [s]".into(),
            y_label: y_label.clone(),
            curves: vec![line("", over(t, &residual))],
            ..Figure::default()
        };
        picture(out, &figure);
        html::open_details(out, &format!("{}: simulated over recorded", o.channel));
        let title = format!("{}{}", o.channel, location(o));
        picture(out, &html::scatter(&title, &y_label, &o.values, &[("simulated", simulated)]));
        html::close_details(out);
        if let Some((name, _)) = loops {
            amplitude_errors(out, name, amplitudes.get(k).map_or(&[], Vec::as_slice));
        }
    }
}

fn amplitude_errors(out: &mut String, name: &str, groups: &[AmplitudeGroup]) {
    if groups.is_empty() {
        return;
    }
    let percent = |pair: [f64; 2]| format!("{:+.1} %", 100.0 * AmplitudeGroup::error(pair));
    let rows = groups.iter().map(|a| {
        let measures = [a.stiffness, a.energy, a.damping].into_iter();
        let cells = measures.flat_map(|m| [number(m[0]), percent(m)]);
        [number(a.amplitude), a.cycles.to_string()].into_iter().chain(cells).collect()
    });
    table(out, &["amplitude", "cycles", "K recorded", "error", "E recorded", "error", "ξ recorded", "error"], rows);
    let curve = |label: &str, of: fn(&AmplitudeGroup) -> [f64; 2]| {
        line(label, groups.iter().map(|a| (a.amplitude, 100.0 * AmplitudeGroup::error(of(a)))).collect())
    };
    if groups.len() > 1 {
        picture(
            out,
            &Figure {
                title: "Error by amplitude".into(),
                x_label: format!("amplitude of {name}"),
                y_label: "error [%]".into(),
                curves: vec![
                    curve("secant stiffness", |a| a.stiffness),
                    curve("dissipated energy", |a| a.energy),
                    curve("equivalent damping", |a| a.damping),
                ],
                ..Figure::default()
            },
        );
    }
}

fn convergence(out: &mut String, result: &CalibrationResult) {
    out.push_str("<h2>Search</h2>\n");
    let repeats = &result.search.repeats;
    let curves = repeats.iter().map(|r| {
        // A step function: the least objective is constant between improvements.
        let mut points = vec![];
        for (n, s) in &r.history {
            if let Some((_, last)) = points.last().copied() {
                points.push((*n as f64, last));
            }
            points.push((*n as f64, *s));
        }
        points.extend(points.last().copied().map(|(_, s)| (r.evaluations as f64, s)));
        line(&if repeats.len() < 7 { format!("seed {}", r.seed) } else { String::new() }, points)
    });
    let curves: Vec<Curve> = curves.collect();
    let figure = Figure {
        title: "Convergence".into(),
        x_label: "evaluations".into(),
        y_label: "best objective".into(),
        log_y: spans_decades(curves.iter().flat_map(|c| &c.points).map(|p| p.1)),
        curves,
        ..Figure::default()
    };
    picture(out, &figure);
    let s = result.repeat_statistics();
    if s.repeats > 1 {
        let row = vec![s.repeats.to_string(), number(s.best), number(s.worst), number(s.mean), number(s.deviation)];
        table(out, &["repeats", "best", "worst", "mean", "deviation"], [row]);
    }
    let failures = result.search.failures();
    if !failures.is_empty() {
        let rows = failures.iter().map(|(kind, n)| {
            let message = repeats.iter().find_map(|r| r.failure_messages.get(*kind)).map_or("", String::as_str);
            vec![(*kind).to_owned(), n.to_string(), message.to_owned()]
        });
        table(out, &["points without an answer", "count", "for instance"], rows);
    }
}

fn uncertainty(out: &mut String, result: &CalibrationResult) {
    let Some(u) = &result.uncertainty else { return };
    out.push_str("<h2>How sure the parameters are</h2>\n");
    let _ = writeln!(
        out,
        "<p>From the curvature at the best point, {:.0} samples being worth {:.0} independent ones for their \
         autocorrelation. Profiles and the posterior take the residual for noise.</p>",
        u.samples, u.effective_samples
    );
    let names: Vec<&str> = u.intervals.iter().map(|i| i.name.as_str()).collect();
    let head: Vec<&str> = ["correlation"].into_iter().chain(names.iter().copied()).collect();
    let rows = names
        .iter()
        .zip(&u.correlation)
        .map(|(n, row)| std::iter::once((*n).to_owned()).chain(row.iter().map(|c| format!("{c:+.2}"))).collect());
    table(out, &head, rows);
    if let Some(profiles) = &result.profiles {
        for p in profiles {
            picture(
                out,
                &Figure {
                    title: format!("Profile of {}", p.name),
                    x_label: p.name.clone(),
                    y_label: "n ln(S/S_min); 95 % at 3.84".into(),
                    curves: vec![line("", p.points.clone())],
                    ..Figure::default()
                },
            );
        }
    }
    let Some(posterior) = &result.posterior else { return };
    let rows =
        posterior.quantiles.iter().map(|q| vec![q.name.clone(), number(q.lower), number(q.median), number(q.upper)]);
    table(out, &["posterior", "2.5 %", "50 %", "97.5 %"], rows);
    for i in 1..names.len() {
        picture(
            out,
            &Figure {
                title: format!("Posterior of {} and {}", names[0], names[i]),
                x_label: names[0].to_owned(),
                y_label: names[i].to_owned(),
                curves: vec![Curve {
                    name: String::new(),
                    points: posterior.draws.iter().map(|d| (d[0], d[i])).collect(),
                    mark: Mark::Dots,
                }],
                ..Figure::default()
            },
        );
    }
}
