//! Self-contained HTML pages with their charts.

use hysteron_opensees::chart::{Curve, Figure, Mark};
use std::fmt::Write as _;

const STYLE: &str = "body{font:15px/1.5 system-ui,sans-serif;max-width:1000px;margin:2em auto;padding:0 1em;color:#222}\
    table{border-collapse:collapse;margin:1em 0}td,th{padding:.25em .8em;border-bottom:1px solid #ddd;text-align:left}\
    .n{text-align:right}@media print,(max-width:800px){td,th{padding:.2em .35em;font-size:.85em}}svg{max-width:100%;height:auto}h2{margin-top:2em}\
    .note{background:#fff6e0;padding:.5em 1em;border-left:4px solid #e69f00}\
    .verdict{font-size:1.15em;background:#eef4fb;padding:.7em 1em;border-left:4px solid #0072b2}\
    .bar{display:inline-block;height:.8em;background:#0072b2}pre{background:#f6f6f6;padding:.7em;overflow-x:auto}\
    ins{background:#dff3df;text-decoration:none}del{background:#fbe3e3}";

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

/// Append a chart. One without points is left out.
pub fn picture(out: &mut String, figure: &Figure) {
    if let Ok(svg) = figure.svg() {
        let _ = writeln!(out, "<figure>{svg}</figure>");
    }
}

/// A curve drawn as a line.
pub fn line(name: &str, points: Vec<(f64, f64)>) -> Curve {
    Curve { name: name.to_owned(), points, mark: Mark::Line }
}

/// A name with its unit in brackets.
pub fn labelled(name: &str, unit: &str) -> String {
    if unit.is_empty() { name.to_owned() } else { format!("{name} [{unit}]") }
}

/// The beginning of a page, with its title as heading.
pub fn head(title: &str) -> String {
    let title = escaped(title);
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>{title}</title><style>{STYLE}</style></head>\n\
         <body>\n<h1>{title}</h1>\n"
    )
}

/// A page with its end.
pub fn end(mut page: String) -> String {
    page.push_str("</body></html>\n");
    page
}
