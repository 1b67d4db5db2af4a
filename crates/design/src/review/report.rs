//! The page of a review: what governs first, at most ten pages on paper.

use super::drawing::{elevation, key_plan};
use super::governing::governing;
use super::summary::{parts, worst};
use super::{Review, tables};
use crate::check::{Status, check_table};
use crate::isolate::{BOUNDS, BearingOutcome, JobOutcome, Study};
use crate::prototype::report::{page_table, page_table_in_parts};
use hysteron_identify::report::html::{self as page, number};
use hysteron_identify::report::{Cell, Table};
use hysteron_opensees::chart::{Curve, Figure, Mark, sheet};

/// Drawings stand side by side where there is room; wide tables scroll on a small screen.
const STYLE: &str = "<style>.two{display:grid;grid-template-columns:repeat(auto-fit,minmax(310px,1fr));gap:.5em}.two svg{width:100%;max-width:560px;height:auto}\
    .wide{overflow-x:auto}.wide td,.wide th{padding:.15em .5em;font-size:.85em}h2{margin-top:1.2em}\
    .sign{display:grid;grid-template-columns:1fr 1fr 1fr;gap:2em;margin-top:3em}.sign div{border-top:1px solid #222}\
    @media screen and (max-width:600px){.wide table{width:max-content;min-width:100%;max-width:none}.wide td,.wide th{overflow-wrap:normal;max-width:9.5em;padding:.15em .3em}\
    .checks td,.checks th{font-size:.78em}.checks td:first-child{max-width:7em}.checks td:nth-child(6){max-width:4.8em}.checks td:nth-child(2),.checks th:nth-child(2),.checks td:last-child,.checks th:last-child{display:none}}\
    @media print{.two{grid-template-columns:1fr 1fr}.wide{overflow:visible}.wide td,.wide th{font-size:.72em;padding:.1em .25em}.new{break-before:page}h2{margin-top:.8em}}</style>\n";
/// Bearings in the schedule of the page; the file has all.
const MAX_BEARINGS: usize = 40;
/// Kinds of checks on the first page, unless more are not met.
const MAX_CHECKS: usize = 14;
/// Floors with a picture of their spectra.
const MAX_FLOORS: usize = 4;
/// Rows of the table of modes.
const MAX_MODES: usize = 3;

/// The page.
pub fn html(study: &Study, outcomes: &[JobOutcome], review: &Review) -> String {
    let mut out = page::head(&study.title);
    out += STYLE;
    decision(&mut out, study, outcomes, review);
    basis(&mut out, study, review);
    suite(&mut out, study, review);
    schedule(&mut out, study, review);
    structure(&mut out, study, outcomes, review);
    spectra(&mut out, study, outcomes);
    loops(&mut out, study, outcomes, review);
    symbols(&mut out);
    open_matters(&mut out, outcomes, review);
    page::end(out)
}

fn wide(out: &mut String, table: &Table) {
    *out += "<div class=\"wide\">";
    page_table(out, table);
    *out += "</div>\n";
}

/// Charts and drawings side by side.
fn side_by_side(out: &mut String, figures: &[Figure]) {
    *out += "<div class=\"two\">";
    for svg in figures.iter().filter_map(|f| sheet(std::slice::from_ref(f), 1).ok()) {
        *out += &format!("<figure>{svg}</figure>");
    }
    *out += "</div>\n";
}

/// First page: what governs, design values, checks.
fn decision(out: &mut String, study: &Study, outcomes: &[JobOutcome], review: &Review) {
    let worst = worst(&review.checks);
    page::summary(out, &format!("{}.", review.verdict()), &parts(study, outcomes, review));
    if !study.code.text_read {
        *out += &format!("<p class=\"note\">{}</p>\n", page::escaped(&study.code.remark()));
    }
    *out += "<h2>Design values</h2>\n";
    wide(out, &design_table(review));
    *out += "<h2>Checks</h2>\n";
    // What is not met is never cut.
    let shown = worst.iter().filter(|c| c.status != Status::Met).count().max(MAX_CHECKS).min(worst.len());
    *out += "<div class=\"checks\">\n";
    wide(out, &check_table(&worst[..shown]));
    *out += "</div>\n";
    *out += &format!(
        "<p>The bound with the worst result of each kind, {shown} of {} kinds; <code>checks.csv</code> has all {} checks. Wording: whether the \
         text of the clause, a secondary source or neither was read.</p>\n",
        worst.len(),
        review.checks.len()
    );
}

/// Design values: quantities by rows, the design value of each bound and the largest factor by columns.
fn design_table(review: &Review) -> Table {
    let mut table = Table::new([
        ("design value", ""),
        ("unit", ""),
        ("lower", ""),
        ("nominal", ""),
        ("upper", ""),
        ("largest factor", ""),
        ("least value by", ""),
    ]);
    let mut done: Vec<&str> = vec![];
    for v in &review.values {
        if done.contains(&v.quantity) {
            continue;
        }
        done.push(v.quantity);
        let mine = || review.values.iter().filter(|o| o.quantity == v.quantity);
        let mut row = vec![Cell::Word(v.quantity), v.unit.clone().into()];
        row.extend(BOUNDS.map(|b| tables::cell(mine().find(|o| o.bound == b).map_or(f64::NAN, |o| o.design))));
        row.push(tables::cell(mine().map(|o| o.factor).fold(f64::NAN, f64::max)));
        row.push(v.citation.clause.clone().into());
        table.rows.push(row);
    }
    table
}

/// Drawings, study beside script, periods.
fn basis(out: &mut String, study: &Study, review: &Review) {
    *out += "<h2 class=\"new\">Structure and isolation system</h2>\n<div class=\"two\">";
    for svg in [key_plan(study, review), elevation(study)].into_iter().flatten() {
        *out += &format!("<figure>{svg}</figure>");
    }
    *out += "</div>\n<h2>Periods</h2>\n";
    let mut modes = tables::modes(review);
    modes.rows.retain(|r| matches!(r[1], Cell::Number(n) if n <= MAX_MODES as f64));
    wide(out, &modes);
    *out += "<h2>Study and script</h2>\n";
    wide(out, &study.agreement.table());
}

/// The suite beside its target.
fn suite(out: &mut String, study: &Study, review: &Review) {
    let s = &review.suite;
    *out += "<h2>Ground motions</h2>\n";
    let points = |ys: &[f64]| s.periods.iter().copied().zip(ys.iter().copied()).collect::<Vec<_>>();
    let curve = |name: &str, ys: &[f64], mark: Mark| Curve { name: name.into(), points: points(ys), mark };
    let names = study.motions.iter().map(|p| p.components[0].name.as_str());
    let mut curves = vec![curve("target", &s.target, Mark::Wide), curve("mean", &s.mean, Mark::Line)];
    // Names of more than a few would fill the picture.
    let few = study.motions.len() <= 4;
    curves.extend(s.pairs.iter().zip(names).map(|(p, name)| curve(if few { name } else { "" }, p, Mark::Line)));
    let spectra = Figure {
        title: format!("{} of the pairs, 5 % damping", s.combination),
        x_label: "Period [s]".into(),
        y_label: "Pseudo-acceleration [g]".into(),
        shaded: s.range.map(|r| (r[0], r[1])).into_iter().collect(),
        curves,
        ..Figure::default()
    };
    let ratio: Vec<f64> = s.mean.iter().zip(&s.target).map(|(m, t)| m / t).collect();
    let ratios = Figure {
        title: "Mean over target".into(),
        x_label: "Period [s]".into(),
        y_label: "Ratio".into(),
        shaded: s.range.map(|r| (r[0], r[1])).into_iter().collect(),
        curves: vec![curve("mean", &ratio, Mark::Line), curve("least asked", &vec![s.least; ratio.len()], Mark::Wide)],
        ..Figure::default()
    };
    side_by_side(out, &[spectra, ratios]);
    let factors: Vec<String> = study
        .motions
        .iter()
        .zip(&study.factors)
        .map(|(p, f)| format!("{} by {}", page::escaped(&p.components[0].name), number(*f)))
        .collect();
    if let (Some([from, to]), Some((lowest, at))) = (s.range, s.lowest) {
        *out += &format!(
            "<p>Range {} to {} s ({}); least ratio {} at {} s.</p>\n",
            number(from),
            number(to),
            page::escaped(&study.code.clause("scaling_range")),
            number(lowest),
            number(at)
        );
    }
    *out += &format!("<p>Target {}. Factors: {}.</p>\n", page::escaped(&study.target_words), factors.join(", "));
}

/// Schedule of the bearings: those with the highest ratios if there are many.
fn schedule(out: &mut String, study: &Study, review: &Review) {
    *out += "<h2 class=\"new\">Bearing schedule</h2>\n";
    let mut table = tables::schedule(study, review);
    if table.rows.len() > MAX_BEARINGS {
        let mut order: Vec<usize> = (0..table.rows.len()).collect();
        order.sort_by(|a, b| review.bearings[*b].design.total_cmp(&review.bearings[*a].design));
        table.rows = order[..MAX_BEARINGS].iter().map(|i| table.rows[*i].clone()).collect();
        *out += &format!(
            "<p>The {MAX_BEARINGS} bearings with the largest displacements; <code>schedule.csv</code> has all {}.</p>\n",
            review.bearings.len()
        );
    }
    *out += "<div class=\"wide\">";
    page_table_in_parts(out, &table, 2, 9);
    *out += "</div>\n";
    let clause = page::escaped(&study.code.clause("load_combinations"));
    *out +=
        &format!("<p>Vertical loads by {clause}, compression positive; <code>loads.csv</code> has their parts.</p>\n");
}

/// Responses of the structure, the equivalent lateral force procedure, and profiles over the height.
fn structure(out: &mut String, study: &Study, outcomes: &[JobOutcome], review: &Review) {
    *out += "<h2>Structure: mean and envelope of each bound</h2>\n";
    wide(out, &tables::structure(study, outcomes));
    *out += "<h2>Equivalent lateral force procedure</h2>\n";
    wide(out, &tables::procedure(study, review));
    for (bound, l) in BOUNDS.iter().zip(&review.lateral_force) {
        if let Err(e) = l {
            *out += &format!("<p class=\"note\">{bound} bound: {}</p>\n", page::escaped(e));
        }
    }
    if study.floors.len() < 2 {
        return;
    }
    let mut heights = vec![];
    for (k, f) in study.floors.iter().enumerate() {
        heights.push(heights.last().copied().unwrap_or(0.0) + if k == 0 { 0.0 } else { f.height });
    }
    let profile = |title: &str, unit: &str, of: &dyn Fn(&JobOutcome, usize) -> Option<f64>, is_step: bool| {
        let mut curves = vec![];
        for bound in BOUNDS {
            for (what, mark) in [("mean", Mark::Line), ("largest", Mark::Dots)] {
                let value = |k: usize| {
                    let r = governing(study, outcomes, bound, &|o| of(o, k))?;
                    Some(if what == "mean" { r.mean } else { r.largest })
                };
                let mut points: Vec<(f64, f64)> = vec![];
                for (k, h) in heights.iter().enumerate() {
                    let Some(x) = value(k) else { continue };
                    // A drift holds over the whole storey.
                    if is_step && mark == Mark::Line {
                        points.push((x, heights[k - 1]));
                    }
                    points.push((x, *h));
                }
                curves.push(Curve { name: format!("{bound} {what}"), points, mark });
            }
        }
        let y_label = page::labelled("Height", &study.units[1]);
        Figure { title: title.into(), x_label: page::labelled(title, unit), y_label, curves, ..Figure::default() }
    };
    let drift = |o: &JobOutcome, k: usize| o.drifts.get(k.checked_sub(1)?).copied();
    let acceleration = |o: &JobOutcome, k: usize| o.accelerations.get(k).copied();
    *out += "<h2>Over the height</h2>\n";
    let figures =
        [profile("Storey drift ratio", "", &drift, true), profile("Floor acceleration", "g", &acceleration, false)];
    side_by_side(out, &figures);
}

/// Spectra of some floors: mean and largest of each bound.
fn spectra(out: &mut String, study: &Study, outcomes: &[JobOutcome]) {
    let n = study.floors.len();
    let Some(periods) = outcomes.iter().map(|o| &o.periods).find(|p| !p.is_empty()) else { return };
    *out += "<h2>Floor spectra</h2>\n";
    // The base level, the roof, and some between at equal distances.
    let count = n.min(MAX_FLOORS);
    let chosen = (0..count).map(|i| if count > 1 { i * (n - 1) / (count - 1) } else { 0 });
    let figure = |k: usize| {
        let mut curves = vec![];
        for bound in BOUNDS {
            for (what, mark) in [("mean", Mark::Line), ("largest", Mark::Dots)] {
                let value = |i: usize| {
                    let r = governing(study, outcomes, bound, &|o| o.floor_spectra.get(k)?.get(i).copied())?;
                    Some(if what == "mean" { r.mean } else { r.largest })
                };
                let points = periods.iter().enumerate().filter_map(|(i, t)| Some((*t, value(i)?))).collect();
                curves.push(Curve { name: format!("{bound} {what}"), points, mark });
            }
        }
        Figure {
            title: format!("Floor at node {}, 5 % damping", study.floors[k].node),
            x_label: "Period [s]".into(),
            y_label: "Acceleration [g]".into(),
            curves,
            ..Figure::default()
        }
    };
    side_by_side(out, &chosen.map(figure).collect::<Vec<_>>());
    *out += "<p><code>floor_spectra.csv</code> has all floors.</p>\n";
}

/// Loops and orbits of the governing bearing: the largest displacement, and the largest of the upper bound.
fn loops(out: &mut String, study: &Study, outcomes: &[JobOutcome], review: &Review) {
    // The bearing whose design displacement takes most of its capacity.
    let use_of = |b: &super::BearingDesign| b.design / study.bearings[b.kind].displacement.unwrap_or(1.0);
    let Some(governs) = review.bearings.iter().max_by(|a, b| use_of(a).total_cmp(&use_of(b))) else { return };
    let tags = &study.bearings[governs.kind].tags;
    let mut bounds = vec![governs.bound, "upper"];
    bounds.dedup();
    let [force, length] = &study.units;
    let mut figures = vec![];
    for bound in bounds {
        let kept = |b: &&BearingOutcome| tags.contains(&b.tag) && !b.hysteresis.is_empty();
        let all = outcomes.iter().filter(|o| o.bound == bound && o.failure.is_empty());
        let all = all.flat_map(|o| o.bearings.iter().filter(kept).map(move |b| (o, b)));
        let Some((o, b)) = all.max_by(|a, b| a.1.displacement.total_cmp(&b.1.displacement)) else { continue };
        let curve = |points: &[[f64; 2]]| vec![page::line("", points.iter().map(|p| (p[0], p[1])).collect())];
        let title = format!("Bearing {}, {bound}, {}", b.tag, o.motion);
        let (x, y) = (page::labelled("u_x", length), page::labelled("F_x", force));
        let figure = |y_label: String, points: &[[f64; 2]], equal: bool| Figure {
            title: title.clone(),
            x_label: x.clone(),
            y_label,
            curves: curve(points),
            equal,
            ..Figure::default()
        };
        figures.push(figure(y, &b.hysteresis, false));
        if !b.orbit.is_empty() {
            figures.push(figure(page::labelled("u_y", length), &b.orbit, true));
        }
    }
    *out += "<h2>Loops and orbits of the governing type of bearing</h2>\n";
    side_by_side(out, &figures);
}

/// Meaning of the symbols of the page.
const SYMBOLS: [(&str, &str); 15] = [
    (
        "D_M, T_M, k_M, β_M, B_M",
        "displacement, effective period, stiffness, damping and damping coefficient of the procedure",
    ),
    ("T_fb", "longest period of the structure on a fixed base"),
    ("V_b, V_st, V_s", "shear below the bearings, unreduced shear above them, design shear above them"),
    ("R_I", "reduction of the forces above the bearings"),
    ("k of the heights", "exponent of the heights in the distribution of V_s to the floors"),
    ("D, D design", "displacement of a bearing in the suite, and scaled to the least value of the code"),
    ("D_TM plan", "D_M times the torsional ratio of the bearing's place in the plan"),
    ("D, L, Q_E", "in loads: dead load, live load, change of the axial force under the motion"),
    ("P, P_cr", "axial force, compression positive; critical load with the overlapping area at the displacement"),
    (
        "P/P_cr history, P/P_cr, P/P_cr scaled",
        "largest ratio in a history; of the largest vertical load at the displacement of the suite; at D design",
    ),
    ("residual, energy", "displacement at the end of the analysis; work that the bearing dissipates in it"),
    ("V_s by activation", "shear above from the force that sets the isolation in motion"),
    ("Q_d, K_d, K_eff", "strength at zero displacement, stiffness after yielding, secant stiffness"),
    ("λ", "factor of a bound on Q_d or K_d"),
    ("S_MS, S_M1", "spectral accelerations of the target at short periods and at 1 s, in g"),
];

fn symbols(out: &mut String) {
    *out += "<h2>Symbols</h2>\n<div class=\"wide\">";
    page::table(out, &["symbol", "meaning"], SYMBOLS.iter().map(|(a, b)| vec![(*a).to_owned(), (*b).to_owned()]));
    *out += "</div>\n";
}

/// What was not checked, analyses that failed, places for signatures.
fn open_matters(out: &mut String, outcomes: &[JobOutcome], review: &Review) {
    *out += "<h2>Not checked</h2>\n<ul>\n";
    for text in &review.not_checked {
        *out += &format!("<li>{}</li>\n", page::escaped(text));
    }
    for c in review.checks.iter().filter(|c| c.status == Status::NotChecked) {
        let value =
            if c.demand.is_finite() { format!(": {}, without a limit", number(c.demand)) } else { String::new() };
        *out += &format!("<li>{}{value}</li>\n", page::escaped(&c.subject));
    }
    *out += "</ul>\n";
    let failed: Vec<&JobOutcome> = outcomes.iter().filter(|o| !o.failure.is_empty()).collect();
    if !failed.is_empty() {
        *out += "<h2>Analyses that failed</h2>\n";
        let row = |o: &&JobOutcome| vec![o.bound.clone(), o.motion.clone(), number(o.time), o.failure.clone()];
        page::table(out, &["bound", "motion", "to time", "end"], failed.iter().map(row));
    }
    *out += "<p>Files beside this page: tables as CSV, <code>isolation.json</code>, and <code>analyses/</code> with the histories of each \
             analysis.</p>\n<div class=\"sign\"><div>made by, date</div><div>checked by, date</div><div>engineer of record, date</div></div>\n";
}
