//! Self-contained HTML pages with their charts.

use hysteron_opensees::chart::{Bars, Curve, Figure, Mark};
use serde_json::json;
use std::fmt::Write as _;

const STYLE: &str = "body{font:15px/1.5 system-ui,sans-serif;max-width:1000px;margin:2em auto;padding:0 1em;color:#222}\
    table{border-collapse:collapse;margin:1em 0;max-width:100%}td,th{padding:.25em .8em;border-bottom:1px solid #ddd;text-align:left;overflow-wrap:break-word}\
    .n{text-align:right}svg{max-width:100%;height:auto}h2{margin-top:2em}figure{margin:1em 0}\
    @media (max-width:800px){td,th{padding:.2em .35em;font-size:.85em}}\
    @media screen and (max-width:600px){table{display:block;overflow-x:auto}}\
    .note{background:#fff6e0;padding:.5em 1em;border-left:4px solid #e69f00}\
    .verdict{background:#eef4fb;padding:.4em 1em .7em;border-left:4px solid #0072b2}.verdict p{font-size:1.15em;font-weight:600;margin:.4em 0}\
    dl{display:grid;grid-template-columns:5.5em 1fr;gap:.25em 1em;margin:.5em 0}dt{font-weight:600}dd{margin:0}\
    summary{cursor:pointer;font-weight:600}\
    .bar{display:inline-block;height:.8em;background:#0072b2}pre{background:#f6f6f6;padding:.7em;overflow-x:auto}\
    ins{background:#dff3df;text-decoration:none}del{background:#fbe3e3}\
    @media print{@page{margin:13mm}body{margin:0;max-width:none;padding:0;font-size:12px}pre{white-space:pre-wrap;overflow-wrap:anywhere}\
    td,th{padding:.15em .3em;font-size:.82em}h1,h2,h3,summary{break-after:avoid}figure,tr,dl,.verdict{break-inside:avoid}\
    details::details-content{content-visibility:visible;block-size:auto}}";

/// Closed parts are printed too.
const SCRIPT: &str =
    "addEventListener('beforeprint',()=>document.querySelectorAll('details').forEach(d=>{d.open=true}))";

/// A text with the special characters of HTML replaced.
pub fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// A number with five significant digits.
pub fn number(x: f64) -> String {
    let mut out = String::new();
    hysteron_engine::number_format::Style { precision: 5, scientific: false }.push(x, &mut out);
    out
}

/// Append a table with a head row.
pub fn table(out: &mut String, head: &[&str], rows: impl IntoIterator<Item = Vec<String>>) {
    out.push_str("<table>\n");
    let rows: Vec<Vec<String>> = rows.into_iter().collect();
    let is_number = |c: &String| c.trim_end_matches([' ', '%']).parse::<f64>().is_ok();
    // Columns of numbers are aligned to the right, with their heads.
    let of_numbers: Vec<bool> = (0..head.len()).map(|k| rows.iter().any(|r| r.get(k).is_some_and(is_number))).collect();
    let mut line = |tag: &str, cells: &mut dyn Iterator<Item = &str>| {
        out.push_str("<tr>");
        for (k, cell) in cells.enumerate() {
            let class = if of_numbers.get(k).is_some_and(|n| *n) { " class=\"n\"" } else { "" };
            let _ = write!(out, "<{tag}{class}>{}</{tag}>", escaped(cell));
        }
        out.push_str("</tr>\n");
    };
    line("th", &mut head.iter().copied());
    for row in &rows {
        line("td", &mut row.iter().map(String::as_str));
    }
    out.push_str("</table>\n");
}

/// Append a chart with its numbers, for [`without_numbers`] or a page that draws them. One without points is left out.
pub fn picture(out: &mut String, figure: &Figure) {
    if let Ok(svg) = figure.svg() {
        let _ = writeln!(out, "<figure>{svg}{NUMBERS}{}</script></figure>", numbers(figure));
    }
}

/// Begin of the numbers of a chart.
const NUMBERS: &str = "<script type=\"application/json\" class=\"chart\">";

/// Points of a curve whose numbers are kept, at most.
const MAX_POINTS: usize = 4000;

/// Numbers of a chart in JSON, which begins and ends no element of a page.
fn numbers(figure: &Figure) -> String {
    let mark = |m: Mark| match m {
        Mark::Line => "line",
        Mark::Wide => "wide",
        Mark::Dots => "dots",
    };
    let curves = figure.curves.iter().map(|c| {
        let points = extremes(&c.points);
        // A number that is not finite becomes null, which is a gap.
        let of = |k: fn(&(f64, f64)) -> f64| points.iter().map(|p| k(p) as f32).collect::<Vec<f32>>();
        json!({ "name": c.name, "mark": mark(c.mark), "x": of(|p| p.0), "y": of(|p| p.1) })
    });
    let chart = json!({
        "title": figure.title, "x": figure.x_label, "y": figure.y_label, "equal": figure.equal, "log": figure.log_y,
        "shaded": figure.shaded, "colour": figure.first_colour, "curves": curves.collect::<Vec<_>>(),
    });
    // A letter that begins an element of HTML is written by its number: `<!--<script>` would go on behind the end of the block.
    chart.to_string().replace('<', "\\u003c")
}

/// Points of a long curve with the lowest and the highest of each stretch, in their order.
fn extremes(points: &[(f64, f64)]) -> Vec<(f64, f64)> {
    if points.len() <= MAX_POINTS {
        return points.to_vec();
    }
    let ends = |part: &[(f64, f64)]| {
        let order = |a: &&(f64, f64), b: &&(f64, f64)| a.1.total_cmp(&b.1);
        let mut both: Vec<(f64, f64)> =
            part.iter().min_by(order).into_iter().chain(part.iter().max_by(order)).copied().collect();
        if both.len() == 2 && part.iter().position(|p| *p == both[0]) > part.iter().position(|p| *p == both[1]) {
            both.swap(0, 1);
        }
        both
    };
    points.chunks(points.len().div_ceil(MAX_POINTS / 2)).flat_map(ends).collect()
}

/// A page without the numbers of its charts, which stay as pictures.
pub fn without_numbers(page: &str) -> String {
    let mut parts = page.split(NUMBERS);
    let first = parts.next().unwrap_or_default().to_owned();
    parts.fold(first, |out, part| out + part.split_once("</script>").map_or("", |(_, rest)| rest))
}

/// A curve drawn as a line.
pub fn line(name: &str, points: Vec<(f64, f64)>) -> Curve {
    Curve { name: name.to_owned(), points, mark: Mark::Line }
}

/// A recording: a wide line beneath the simulations.
pub fn recorded(points: Vec<(f64, f64)>) -> Curve {
    Curve { name: "recorded".into(), points, mark: Mark::Wide }
}

/// Append a chart of bars. One without values is left out.
pub fn bars(out: &mut String, bars: &Bars) {
    if let Ok(svg) = bars.svg() {
        let _ = writeln!(out, "<figure>{svg}</figure>");
    }
}

/// Points of a scatter, at most.
const MAX_SCATTER: usize = 700;

/// Simulated over recorded samples, each model with a name. On the diagonal both are equal.
pub fn scatter(title: &str, label: &str, recorded: &[f64], simulated: &[(&str, &[f64])]) -> Figure {
    let every = recorded.len().div_ceil(MAX_SCATTER).max(1);
    let known = |y: &[f64]| -> Vec<(f64, f64)> {
        let pairs = recorded.iter().copied().zip(y.iter().copied()).step_by(every);
        pairs.filter(|p| p.0.is_finite() && p.1.is_finite()).collect()
    };
    let finite = recorded.iter().filter(|x| x.is_finite());
    let (low, high) = finite.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(*x), b.max(*x)));
    let equal = Curve { name: "equal".into(), points: vec![(low, low), (high, high)], mark: Mark::Wide };
    let dots = simulated.iter().map(|(name, y)| Curve { name: (*name).into(), points: known(y), mark: Mark::Dots });
    Figure {
        title: title.into(),
        x_label: format!("recorded {label}"),
        y_label: format!("simulated {label}"),
        equal: true,
        curves: std::iter::once(equal).chain(dots).collect(),
        ..Figure::default()
    }
}

/// Append a first sentence, and parts with their headings.
pub fn summary(out: &mut String, first: &str, parts: &[(&str, String)]) {
    let _ = writeln!(out, "<div class=\"verdict\"><p>{}</p>\n<dl>", escaped(first));
    for (heading, text) in parts {
        let _ = writeln!(out, "<dt>{heading}</dt><dd>{}</dd>", escaped(text).replace(" %", "&nbsp;%"));
    }
    out.push_str("</dl></div>\n");
}

/// Begin a part that is closed on the screen; [`close_details`] ends it.
pub fn open_details(out: &mut String, heading: &str) {
    let _ = writeln!(out, "<details><summary>{}</summary>", escaped(heading));
}

/// End a part that is closed on the screen.
pub fn close_details(out: &mut String) {
    out.push_str("</details>\n");
}

/// A name with its unit in brackets.
pub fn labelled(name: &str, unit: &str) -> String {
    if unit.is_empty() { name.to_owned() } else { format!("{name} [{unit}]") }
}

/// The beginning of a page, with its title as heading.
pub fn head(title: &str) -> String {
    let title = escaped(title);
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" content=\"width=device-width\">\n\
         <title>{title}</title><style>{STYLE}</style><script>{SCRIPT}</script></head>\n\
         <body>\n<h1>{title}</h1>\n"
    )
}

/// A page with its end.
pub fn end(mut page: String) -> String {
    page.push_str("</body></html>\n");
    page
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_of_charts_can_be_taken_out_again() {
        let points: Vec<(f64, f64)> = (0..20_000).map(|i| (f64::from(i), (f64::from(i) * 0.01).sin())).collect();
        let title = "</script><!--<script>";
        let figure = Figure { title: title.into(), curves: vec![line("a", points)], ..Figure::default() };
        let mut out = String::from("<body>");
        picture(&mut out, &figure);
        out.push_str("<p>end</p></body>");
        let text = out.split(NUMBERS).nth(1).and_then(|t| t.split("</script>").next()).unwrap_or_default();
        let chart: serde_json::Value = serde_json::from_str(text).unwrap_or_default();
        assert_eq!(chart["title"], title);
        assert!(!text.contains('<'), "{text:.200}");
        let y: Vec<f64> =
            chart["curves"][0]["y"].as_array().into_iter().flatten().filter_map(serde_json::Value::as_f64).collect();
        assert!(y.len() <= MAX_POINTS && y.len() > MAX_POINTS / 2, "{}", y.len());
        assert!(y.iter().any(|y| *y > 0.9999) && y.iter().any(|y| *y < -0.9999));
        let plain = without_numbers(&out);
        assert!(!plain.contains("application/json") && plain.ends_with("</figure>\n<p>end</p></body>"), "{plain:.200}");
    }
}
