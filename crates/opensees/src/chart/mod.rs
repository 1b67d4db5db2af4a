//! Charts of one quantity over another, as SVG.

mod axis;
mod bars;
mod svg;

pub(crate) use axis::MAX_DRAWN;
pub use axis::spans_decades;
pub use bars::Bars;

use axis::Axis;
use std::fmt;
use svg::{BENEATH, COLOURS, LEGEND_ROW, LETTERS, Svg, text_width};

/// Marks of the points of a curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mark {
    /// Joined by a line.
    Line,
    /// Joined by a wide light line, drawn beneath all others: a recording behind its simulations.
    Wide,
    /// Each by a dot.
    Dots,
}

/// A curve with its name in the legend.
#[derive(Clone, Debug)]
pub struct Curve {
    /// Name; empty for none.
    pub name: String,
    /// Points. One that is not finite is a gap in a line.
    pub points: Vec<(f64, f64)>,
    /// Marks of the points.
    pub mark: Mark,
}

/// A chart.
#[derive(Clone, Debug, Default)]
pub struct Figure {
    /// Title; empty for none.
    pub title: String,
    /// Quantity on the horizontal axis, with its unit.
    pub x_label: String,
    /// Quantity on the vertical axis, with its unit.
    pub y_label: String,
    /// The same scale on both axes.
    pub equal: bool,
    /// A logarithmic vertical axis, if the ends are positive.
    pub log_y: bool,
    /// Ends of the horizontal axis, where they do not follow from the points.
    pub x_range: Option<(f64, f64)>,
    /// Ends of the vertical axis, likewise.
    pub y_range: Option<(f64, f64)>,
    /// Stretches of the horizontal axis that are shaded.
    pub shaded: Vec<(f64, f64)>,
    /// Colours are counted from this one on: the same thing has the same colour in two charts.
    pub first_colour: usize,
    /// Curves, drawn in this order.
    pub curves: Vec<Curve>,
}

/// Why a chart could not be drawn.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FigureError(pub String);

impl fmt::Display for FigureError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for FigureError {}

type Point = (f64, f64);

/// Width and height in pixels.
const SIZE: Point = (720.0, 420.0);
/// A chart with equal scales is square.
const SQUARE: Point = (560.0, 560.0);
/// Size of a chart on a sheet: small enough that the letters are readable where a sheet of two is as wide as a page.
const ON_SHEET: Point = (440.0, 350.0);
/// Room at the right of the axes.
const RIGHT: f64 = 24.0;
/// Room below the axes: ticks and the name of the quantity.
const BELOW: f64 = 50.0;
/// Room above the axes without a legend.
const ABOVE: f64 = 32.0;
/// Distance in pixels within which points of a curve are joined.
const COLUMN: f64 = 0.5;

/// Number of dots up to which they are large.
const FEW_DOTS: usize = 40;
/// Ticks of an axis, at most.
const MAX_TICKS: usize = 9;

/// The part of a chart within its axes.
struct Plot {
    x: Axis,
    y: Axis,
    /// Left, top, right and bottom pixels.
    left: f64,
    top: f64,
    right: f64,
    bottom: f64,
}

impl Figure {
    /// The chart as the text of an SVG file.
    ///
    /// # Errors
    /// There is nothing to draw.
    pub fn svg(&self) -> Result<String, FigureError> {
        let size = if self.equal { SQUARE } else { SIZE };
        let mut out = Svg::new(size.0, size.1);
        self.draw(&mut out, size)?;
        Ok(out.finish())
    }

    /// Curves with their colours. Wide ones take no colour of the others.
    fn coloured(&self) -> Vec<(&Curve, &'static str)> {
        let mut next = self.first_colour;
        let colour = |c: &Curve| {
            if c.mark == Mark::Wide {
                return BENEATH;
            }
            next += 1;
            COLOURS[(next - 1) % COLOURS.len()]
        };
        let colours: Vec<&'static str> = self.curves.iter().map(colour).collect();
        self.curves.iter().zip(colours).collect()
    }

    /// True if all values of a coordinate are whole numbers.
    fn is_whole(&self, of: impl Fn(&Point) -> f64) -> bool {
        self.curves.iter().flat_map(|c| &c.points).all(|p| of(p).fract() == 0.0)
    }

    /// Axes on an area of a size, below a legend of some rows.
    fn plot(&self, size: Point, legend: f64) -> Result<Plot, FigureError> {
        let nothing = || FigureError("there are no points to draw".into());
        let points = || self.curves.iter().flat_map(|c| &c.points).filter(|p| p.0.is_finite() && p.1.is_finite());
        let mut x = Axis::ends(points().map(|p| p.0), false).ok_or_else(nothing)?;
        let mut y = Axis::ends(points().map(|p| p.1), self.log_y).ok_or_else(nothing)?;
        (x, y) = (self.x_range.unwrap_or(x), self.y_range.unwrap_or(y));
        let (top, right, bottom) = (ABOVE + legend, size.0 - RIGHT, size.1 - BELOW);
        let ticks = Axis::new(y, (bottom, top), self.log_y).ticks(false);
        let left = 40.0 + ticks.iter().map(|(_, text)| text_width(text, LETTERS)).fold(0.0, f64::max);
        if self.equal {
            let scale = (right - left) / (bottom - top);
            let half = 0.5 * ((x.1 - x.0) / scale).max(y.1 - y.0);
            let about = |r: Point, half: f64| (0.5 * (r.0 + r.1) - half, 0.5 * (r.0 + r.1) + half);
            (x, y) = (about(x, half * scale), about(y, half));
        }
        let axes = (Axis::new(x, (left, right), false), Axis::new(y, (bottom, top), self.log_y));
        Ok(Plot { x: axes.0, y: axes.1, left, top, right, bottom })
    }

    fn draw(&self, out: &mut Svg, size: Point) -> Result<(), FigureError> {
        let coloured = self.coloured();
        let named = || coloured.iter().map(|(c, colour)| (c.name.as_str(), *colour));
        // The legend stands above the axes, so that it hides nothing; its height is known after a first one.
        let has_legend = coloured.iter().any(|(c, _)| !c.name.is_empty());
        let margin = 50.0;
        let rows = Svg::new(0.0, 0.0).legend(named(), margin, 0.0, size.0 - RIGHT);
        let plot = self.plot(size, if has_legend { rows + LEGEND_ROW + 4.0 } else { 0.0 })?;
        out.title(&self.title, margin, size.0 - RIGHT);
        if has_legend {
            out.legend(named(), margin, ABOVE + 8.0, size.0 - RIGHT);
        }
        self.draw_axes(out, &plot);
        let ordered = coloured.iter().filter(|(c, _)| c.mark == Mark::Wide);
        let ordered = ordered.chain(coloured.iter().filter(|(c, _)| c.mark != Mark::Wide));
        for (curve, colour) in ordered {
            let pixel = |p: &Point| (plot.x.pixel(p.0), plot.y.pixel(p.1));
            // A few dots are places, many are a cloud.
            let radius = if curve.points.len() <= FEW_DOTS { 4.5 } else { 2.5 };
            // A point that is not finite is a gap.
            for points in curve.points.split(|p| !(p.0.is_finite() && p.1.is_finite())) {
                let pixels = points.iter().map(pixel);
                match curve.mark {
                    Mark::Dots => pixels.filter(|p| plot.contains(*p)).for_each(|p| out.dot(p, radius, colour)),
                    Mark::Line | Mark::Wide => {
                        let width = if curve.mark == Mark::Wide { 3.5 } else { 1.2 };
                        for stretch in plot.clipped(&thinned(pixels)) {
                            out.curve(&stretch, colour, width);
                        }
                    }
                }
            }
        }
        Ok(())
    }

    fn draw_axes(&self, out: &mut Svg, p: &Plot) {
        for (from, to) in &self.shaded {
            let [a, b] = [from, to].map(|x| p.x.pixel(*x).clamp(p.left, p.right));
            out.rectangle((a, p.top), (b - a, p.bottom - p.top), "#ececec");
        }
        let every = |ticks: &[(f64, String)]| ticks.len().div_ceil(MAX_TICKS).max(1);
        let x_ticks = p.x.ticks(self.is_whole(|p| p.0));
        let y_ticks = p.y.ticks(self.is_whole(|p| p.1));
        let (every_x, every_y) = (every(&x_ticks), every(&y_ticks));
        for (value, text) in x_ticks.into_iter().step_by(every_x) {
            let x = p.x.pixel(value);
            out.line((x, p.top), (x, p.bottom), "#ddd");
            out.text(&text, (x, p.bottom + 17.0), "middle");
        }
        for (value, text) in y_ticks.into_iter().step_by(every_y) {
            let y = p.y.pixel(value);
            out.line((p.left, y), (p.right, y), "#ddd");
            out.text(&text, (p.left - 7.0, y + 4.5), "end");
        }
        out.frame((p.left, p.top), (p.right - p.left, p.bottom - p.top));
        out.text(&self.x_label, (0.5 * (p.left + p.right), p.bottom + 38.0), "middle");
        out.upward_text(&self.y_label, (18.0, 0.5 * (p.top + p.bottom)));
    }
}

impl Plot {
    fn contains(&self, (x, y): Point) -> bool {
        const SLACK: f64 = 1e-6;
        x >= self.left - SLACK && x <= self.right + SLACK && y >= self.top - SLACK && y <= self.bottom + SLACK
    }

    /// The stretches of a curve within the axes.
    fn clipped(&self, points: &[Point]) -> Vec<Vec<Point>> {
        if points.iter().all(|p| self.contains(*p)) {
            return vec![points.to_vec()];
        }
        let mut out: Vec<Vec<Point>> = vec![];
        for w in points.windows(2) {
            let Some((a, b)) = self.clipped_segment(w[0], w[1]) else { continue };
            match out.last_mut().filter(|s| s.last() == Some(&a)) {
                Some(stretch) => stretch.push(b),
                None => out.push(vec![a, b]),
            }
        }
        out
    }

    /// The part of a segment within the axes (Liang and Barsky 1984).
    fn clipped_segment(&self, a: Point, b: Point) -> Option<(Point, Point)> {
        let (dx, dy) = (b.0 - a.0, b.1 - a.1);
        let (mut begin, mut end) = (0.0f64, 1.0f64);
        let sides = [(-dx, a.0 - self.left), (dx, self.right - a.0), (-dy, a.1 - self.top), (dy, self.bottom - a.1)];
        for (p, q) in sides {
            if p == 0.0 && q < 0.0 {
                return None;
            }
            if p < 0.0 {
                begin = begin.max(q / p);
            } else if p > 0.0 {
                end = end.min(q / p);
            }
        }
        let at = |t: f64| match t {
            0.0 => a,
            1.0 => b,
            t => (a.0 + t * dx, a.1 + t * dy),
        };
        (begin <= end).then(|| (at(begin), at(end)))
    }
}

/// Pixels of a curve without those that cannot be seen: of neighbours in one narrow column, the extremes and the last.
fn thinned(pixels: impl Iterator<Item = Point>) -> Vec<Point> {
    let mut out: Vec<Point> = vec![];
    let mut column: Vec<Point> = vec![];
    let mut flush = |column: &mut Vec<Point>| {
        let (Some(first), Some(last)) = (column.first().copied(), column.last().copied()) else { return };
        out.push(first);
        if column.len() > 2 {
            let by_height = |a: &(usize, &Point), b: &(usize, &Point)| a.1.1.total_cmp(&b.1.1);
            let low = column.iter().enumerate().min_by(by_height).map(|(i, _)| i);
            let high = column.iter().enumerate().max_by(by_height).map(|(i, _)| i);
            let mut between: Vec<usize> = [low, high].into_iter().flatten().collect();
            between.sort_unstable();
            between.dedup();
            out.extend(between.into_iter().filter(|i| *i > 0 && *i + 1 < column.len()).map(|i| column[i]));
        }
        if column.len() > 1 {
            out.push(last);
        }
        column.clear();
    };
    for p in pixels {
        if column.first().is_some_and(|first| (p.0 - first.0).abs() >= COLUMN) {
            flush(&mut column);
        }
        column.push(p);
    }
    flush(&mut column);
    out
}

/// Charts side by side, row after row, as the text of an SVG file.
///
/// # Errors
/// There is nothing to draw in one of them.
pub fn sheet(charts: &[Figure], columns: usize) -> Result<String, FigureError> {
    let columns = columns.clamp(1, charts.len().max(1));
    let rows = charts.len().div_ceil(columns);
    let mut out = Svg::new(ON_SHEET.0 * columns as f64, ON_SHEET.1 * rows as f64);
    for (i, chart) in charts.iter().enumerate() {
        out.open_group((ON_SHEET.0 * (i % columns) as f64, ON_SHEET.1 * (i / columns) as f64));
        chart.draw(&mut out, ON_SHEET)?;
        out.close_group();
    }
    Ok(out.finish())
}

#[cfg(test)]
mod tests {
    use super::{Curve, Figure, Mark, thinned};

    fn curve(name: &str, mark: Mark, points: Vec<(f64, f64)>) -> Curve {
        Curve { name: name.into(), points, mark }
    }

    #[test]
    fn curves_lie_between_pixels_and_a_wide_one_beneath() {
        let points: Vec<(f64, f64)> = (0..50).map(|i| (f64::from(i), (0.3 * f64::from(i)).sin())).collect();
        let curves = vec![curve("simulated", Mark::Line, points.clone()), curve("recorded", Mark::Wide, points)];
        let svg = Figure { title: "t".into(), curves, ..Figure::default() }.svg().expect("a chart");
        let lines: Vec<&str> = svg.lines().filter(|l| l.starts_with("<polyline")).collect();
        assert!(lines.len() == 2 && lines[0].contains("#9a9a9a") && lines[1].contains("#0072b2"), "{svg}");
        let coordinates = lines[1].split("points=\"").nth(1).expect("points").split([' ', ',']);
        let whole = coordinates.filter(|x| x.ends_with(".00")).count();
        assert!(whole < 10, "{svg}");
    }

    #[test]
    fn a_range_cuts_curves_off() {
        let points = vec![(0.0, 0.0), (1.0, 10.0), (2.0, 0.0)];
        let curves = vec![curve("", Mark::Line, points)];
        let figure = Figure { y_range: Some((0.0, 5.0)), curves, ..Figure::default() };
        let svg = figure.svg().expect("a chart");
        assert_eq!(svg.matches("<polyline").count(), 2, "{svg}");
        assert!(Figure::default().svg().is_err());
    }

    #[test]
    fn thinning_keeps_extremes() {
        let dense = (0..1000).map(|i| (0.001 * f64::from(i), if i == 300 { 9.0 } else { 0.0 }));
        let kept = thinned(dense);
        assert!(kept.len() < 10 && kept.iter().any(|p| p.1 == 9.0), "{kept:?}");
    }
}
