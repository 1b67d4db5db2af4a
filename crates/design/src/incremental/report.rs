//! Report of incremental analyses and stripes as JSON and a page.

use super::{Ending, StateFit, Summary};
use crate::isolate::Study;
use crate::prototype::report::{page_table, page_table_in_parts};
use crate::spectrum::logarithmic;
use hysteron_identify::report::{Table, html as page};
use hysteron_opensees::chart::{Curve, Figure, Mark};
use serde_json::{Value, json};

/// Points of a curve.
const CURVE_POINTS: usize = 80;

/// All results.
pub fn json(study: &Study, summary: &Summary) -> String {
    let rows = |t: &Table| serde_json::from_str::<Value>(&t.json()).unwrap_or_default();
    let names = study.motions.iter().map(|p| p.components[0].name.as_str());
    let intensities: Vec<Value> =
        names.zip(&summary.intensities).map(|(name, x)| json!({"motion": name, "intensity": x})).collect();
    let observed = |f: &StateFit| json!({"bound": f.bound, "limit_state": study.performance.limit_states[f.state].name, "points": f.observed});
    let all = json!({
        "title": study.title,
        "method": if summary.stripes { "stripes" } else { "incremental dynamic analysis" },
        "intensity": study.performance.intensity.label(),
        "motions": intensities,
        "fits": rows(&summary.fit_table(study)),
        "observed": summary.fits.iter().map(observed).collect::<Vec<_>>(),
        "capacities": rows(&summary.capacity_table(study)),
        "analyses": rows(&summary.point_table(study)),
    });
    format!("{all:#}\n")
}

/// Levels for curves: from below the lowest analysis to above the highest.
fn levels(summary: &Summary) -> Vec<f64> {
    let all = || summary.traces.iter().flat_map(|t| t.points.iter().map(|p| p.level));
    let (low, high) = (all().fold(f64::INFINITY, f64::min), all().fold(0.0, f64::max));
    if low < high { logarithmic(0.5 * low, 1.2 * high, CURVE_POINTS) } else { vec![] }
}

/// Fragility function of a limit state with its band and its observations.
fn fragility(study: &Study, summary: &Summary, f: &StateFit) -> Figure {
    let name = &study.performance.limit_states[f.state].name;
    let levels = levels(summary);
    let mut curves = vec![];
    if let Ok(fit) = &f.fit {
        let curve = |name: &str, of: &dyn Fn(f64) -> f64, mark: Mark| Curve {
            name: name.into(),
            points: levels.iter().map(|x| (*x, of(*x))).collect(),
            mark,
        };
        curves.push(curve("95 % band", &|x| fit.band(x)[0], Mark::Wide));
        curves.push(curve("", &|x| fit.band(x)[1], Mark::Wide));
        curves.push(curve("fit", &|x| fit.probability(x), Mark::Line));
    }
    let what = if summary.stripes { "share of the records" } else { "records" };
    curves.push(Curve { name: what.into(), points: f.observed.clone(), mark: Mark::Dots });
    Figure {
        title: format!("{name}, {} bound", f.bound),
        x_label: study.performance.intensity.label(),
        y_label: "Probability".into(),
        y_range: Some((0.0, 1.0)),
        curves,
        ..Figure::default()
    }
}

/// Demands of the records over the intensity, with the limit.
fn demands(study: &Study, summary: &Summary, bound: &str, state: usize) -> Figure {
    let s = &study.performance.limit_states[state];
    let mut top: f64 = 0.0;
    let mut curves: Vec<Curve> = vec![];
    let mut collapsed = vec![];
    for t in summary.traces.iter().filter(|t| t.bound == bound) {
        // A demand far beyond the limit would leave nothing of the others to be seen.
        let is_drawn = |d: f64| d.is_finite() && (s.limit == 0.0 || d < 3.0 * s.limit);
        let drawn = t.points.iter().filter(|p| is_drawn(p.demands[state]));
        let points: Vec<(f64, f64)> = drawn.clone().map(|p| (p.demands[state], p.level)).collect();
        collapsed.extend(drawn.filter(|p| p.ending != Ending::Complete).map(|p| (p.demands[state], p.level)));
        top = points.iter().fold(top, |m, p| m.max(p.1));
        curves.push(Curve { name: study.motions[t.motion].components[0].name.clone(), points, mark: Mark::Line });
    }
    if curves.len() > 12 {
        curves.iter_mut().for_each(|c| c.name.clear());
    }
    curves.insert(0, Curve { name: "limit".into(), points: vec![(s.limit, 0.0), (s.limit, top)], mark: Mark::Wide });
    if !collapsed.is_empty() {
        curves.push(Curve { name: "not complete".into(), points: collapsed, mark: Mark::Dots });
    }
    Figure {
        title: format!("{}: {}, {bound} bound", s.name, s.quantity.replace('_', " ")),
        x_label: s.quantity.replace('_', " "),
        y_label: study.performance.intensity.label(),
        curves,
        ..Figure::default()
    }
}

/// A page: fits, fragility functions with the records at each point, demands over intensity, capacities, analyses.
pub fn html(study: &Study, summary: &Summary) -> String {
    let mut out = page::head(&study.title);
    let method = if summary.stripes {
        "Stripes: binomial likelihood (Baker 2015)"
    } else {
        "Incremental dynamic analysis: likelihood of the records' capacities; gaps and records that do not reach a limit \
         state are censored"
    };
    let analyses = summary.traces.iter().map(|t| t.points.len()).sum::<usize>();
    let n = study.motions.len();
    out += &format!("<p>{method}. {analyses} analyses, {n} pairs of motions.</p>\n");
    out += "<p>Intervals are of 95 %, by likelihood ratio, and stand for the number of records alone: model and bounds of the \
            bearings are not in them.</p>\n";
    let open: Vec<_> = summary.traces.iter().flat_map(|t| t.points.iter().map(move |p| (t, p))).collect();
    let open: Vec<_> = open.into_iter().filter(|(_, p)| p.ending == Ending::Unresolved).collect();
    if !open.is_empty() {
        out += &format!(
            "<p class=\"note\">{} of {analyses} analyses did not converge below the limits of collapse, with shorter steps and \
             other algorithms tried. They count where a limit had been reached before, and are left out elsewhere.</p>\n",
            open.len()
        );
    }
    out += &format!(
        "<h2>Fragility functions</h2>\n<p>Intensity: {}.</p>\n",
        page::escaped(&study.performance.intensity.label())
    );
    page_table_in_parts(&mut out, &summary.fit_table(study), 2, 8);
    for f in &summary.fits {
        page::picture(&mut out, &fragility(study, summary, f));
    }
    out += "<h2>Demands over intensity</h2>\n";
    for f in summary.fits.iter().filter(|f| study.performance.limit_states[f.state].quantity != "collapse") {
        page::picture(&mut out, &demands(study, summary, f.bound, f.state));
    }
    if !summary.stripes {
        out += "<h2>Capacities of the records</h2>\n";
        page_table(&mut out, &summary.capacity_table(study));
    }
    out += "<h2>Analyses</h2>\n";
    page_table(&mut out, &summary.point_table(study));
    if !open.is_empty() {
        out += "<h2>Analyses without convergence</h2>\n";
        let row = |(t, p): &(&super::Trace, &super::Point)| {
            let name = study.motions[t.motion].components[0].name.clone();
            vec![t.bound.to_owned(), name, page::number(p.level), p.failure.clone()]
        };
        page::table(&mut out, &["bound", "motion", "intensity", "failure"], open.iter().map(row));
    }
    page::end(out)
}
