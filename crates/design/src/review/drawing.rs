//! Key plan of the bearings and elevation of the structure, as SVG.

use super::Review;
use crate::isolate::Study;
use hysteron_identify::report::html::{escaped, number};
use std::fmt::Write as _;

/// Width and height of a drawing in pixels.
const SIZE: [f64; 2] = [430.0, 330.0];
/// Room around it.
const MARGIN: f64 = 42.0;
/// Distances of bearings along x and y in pixels that leave room for their words.
const GAPS: [f64; 2] = [56.0, 44.0];
/// Colours of types of bearings.
const COLOURS: [&str; 6] = ["#0072b2", "#d55e00", "#009e73", "#56b4e9", "#e69f00", "#3c3c3c"];
/// Floors that are drawn, at most: the letters of more would lie upon each other.
const MAX_LABELS: usize = 14;

fn begin(title: &str) -> String {
    let [width, height] = SIZE;
    format!(
        "<svg viewBox=\"0 0 {width} {height}\" width=\"{width}\" height=\"{height}\" xmlns=\"http://www.w3.org/2000/svg\" \
         font-family=\"system-ui,sans-serif\" font-size=\"11\" fill=\"#222\">\n<text x=\"8\" y=\"18\" font-size=\"14\" \
         font-weight=\"600\">{}</text>\n",
        escaped(title)
    )
}

fn text(out: &mut String, x: f64, y: f64, anchor: &str, words: &str) {
    let _ = writeln!(out, "<text x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"{anchor}\">{}</text>", escaped(words));
}

/// Least distance of two coordinates that differ; none of equal ones.
fn least_gap(points: &[[f64; 2]], k: usize) -> Option<f64> {
    let mut all: Vec<f64> = points.iter().map(|p| p[k]).collect();
    all.sort_by(f64::total_cmp);
    let range = all.last()? - all.first()?;
    all.windows(2).map(|w| w[1] - w[0]).filter(|gap| *gap > 1.0e-6 * range).reduce(f64::min)
}

/// Plan with the number of each bearing and its design displacement; none without coordinates in two directions.
pub(super) fn key_plan(study: &Study, review: &Review) -> Option<String> {
    let points: Vec<[f64; 2]> =
        review.bearings.iter().map(|b| <[f64; 2]>::try_from(b.place.clone()).ok()).collect::<Option<_>>()?;
    let range = |k: usize| {
        let all = points.iter().map(|p| p[k]);
        (all.clone().fold(f64::INFINITY, f64::min), all.fold(f64::NEG_INFINITY, f64::max))
    };
    let (x, y) = (range(0), range(1));
    let room = [SIZE[0] - 2.0 * MARGIN, SIZE[1] - 2.0 * MARGIN - 16.0];
    let whole = [room[0] / (x.1 - x.0), room[1] / (y.1 - y.0)];
    let scale = whole[0].min(whole[1]);
    let scale = if scale.is_finite() { scale } else { 1.0 };
    // A narrow plan is drawn wider than it is, so that words do not lie upon each other.
    let scales = [0, 1].map(|k| scale.max(least_gap(&points, k).map_or(0.0, |gap| (GAPS[k] / gap).min(whole[k]))));
    let at = |p: &[f64; 2]| {
        let middle = [0.5 * (x.0 + x.1), 0.5 * (y.0 + y.1)];
        [0.5 * SIZE[0] + scales[0] * (p[0] - middle[0]), 0.5 * (SIZE[1] + 4.0) - scales[1] * (p[1] - middle[1])]
    };
    let mut out = begin(match scales[0] == scales[1] {
        true => "Key plan: number, design displacement",
        false => "Key plan, not to scale: number, design displacement",
    });
    let many = points.len() > 60;
    for (b, p) in review.bearings.iter().zip(&points) {
        let [px, py] = at(p);
        let colour = COLOURS[b.kind % COLOURS.len()];
        let radius = if many { 3.0 } else { 6.0 };
        let _ = writeln!(out, "<circle cx=\"{px:.1}\" cy=\"{py:.1}\" r=\"{radius}\" fill=\"{colour}\"/>");
        text(&mut out, px, py - 9.0, "middle", &b.tag.to_string());
        if !many {
            text(&mut out, px, py + 18.0, "middle", &number(b.design));
        }
    }
    let _ = writeln!(
        out,
        "<path d=\"M14 {0}h36m-6 -4l6 4l-6 4M14 {0}v-36m-4 6l4 -6l4 6\" fill=\"none\" stroke=\"#222\"/>",
        SIZE[1] - 14.0
    );
    text(&mut out, 56.0, SIZE[1] - 10.0, "start", "x");
    text(&mut out, 20.0, SIZE[1] - 46.0, "start", "y");
    let mut left = 90.0;
    for (k, b) in study.bearings.iter().enumerate() {
        let _ = writeln!(
            out,
            "<circle cx=\"{left:.1}\" cy=\"{:.1}\" r=\"5\" fill=\"{}\"/>",
            SIZE[1] - 14.0,
            COLOURS[k % COLOURS.len()]
        );
        text(&mut out, left + 9.0, SIZE[1] - 10.0, "start", &b.name);
        left += 30.0 + 7.0 * b.name.chars().count() as f64;
    }
    out.push_str("</svg>\n");
    Some(out)
}

/// Elevation with the floors, their weights, and the bearings below; none without floors.
pub(super) fn elevation(study: &Study) -> Option<String> {
    let n = study.floors.len();
    let height: f64 = study.floors.iter().skip(1).map(|f| f.height).sum();
    if n == 0 {
        return None;
    }
    let [bottom, top] = [SIZE[1] - 60.0, MARGIN + 6.0];
    let scale = if height > 0.0 { (bottom - top) / height } else { 0.0 };
    let [left, right] = [110.0, SIZE[0] - 130.0];
    let mut out = begin("Elevation: node, weight, height");
    let (mut level, every) = (0.0, n.div_ceil(MAX_LABELS));
    let [force, length] = &study.units;
    for (k, f) in study.floors.iter().enumerate() {
        level += if k == 0 { 0.0 } else { f.height };
        let y = bottom - scale * level;
        let _ = writeln!(
            out,
            "<path d=\"M{left} {y:.1}H{right}\" stroke=\"#222\" stroke-width=\"{}\"/>",
            if k == 0 { 5 } else { 2 }
        );
        if k % every == 0 || k + 1 == n {
            text(&mut out, left - 8.0, y + 4.0, "end", &format!("node {}", f.node));
            let words = format!("{} {force}, {} {length}", number(f.weight), number(level));
            text(&mut out, right + 8.0, y + 4.0, "start", &words);
        }
    }
    let roof = bottom - scale * height;
    for x in [left, right] {
        let _ = writeln!(out, "<path d=\"M{x} {bottom}V{roof:.1}\" stroke=\"#222\"/>");
    }
    for k in 0..5 {
        let x = left + (right - left) * f64::from(k) / 4.0;
        let (left, top) = (x - 6.0, bottom + 3.0);
        let _ =
            writeln!(out, "<rect x=\"{left:.1}\" y=\"{top:.1}\" width=\"12\" height=\"14\" fill=\"{}\"/>", COLOURS[0]);
    }
    let ground = bottom + 18.0;
    let _ =
        writeln!(out, "<path d=\"M{} {ground}H{}\" stroke=\"#777\" stroke-width=\"3\"/>", left - 30.0, right + 30.0);
    let count: usize = study.bearings.iter().map(|b| b.tags.len()).sum();
    let words = format!("{count} bearings carry {} {force}", number(study.weight));
    text(&mut out, 0.5 * (left + right), ground + 18.0, "middle", &words);
    out.push_str("</svg>\n");
    Some(out)
}
