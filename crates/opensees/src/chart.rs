//! Charts of one quantity over another, as SVG.

use plotters::coord::Shift;
use plotters::prelude::*;
use std::fmt;

/// Marks of the points of a curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mark {
    /// Joined by a line.
    Line,
    /// Each by a dot.
    Dots,
}

/// A curve with its name in the legend.
#[derive(Clone, Debug)]
pub struct Curve {
    /// Name; empty for none.
    pub name: String,
    /// Points.
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

/// Width and height in pixels.
const SIZE: (u32, u32) = (720, 480);
/// A chart with equal scales is square.
const SQUARE: (u32, u32) = (560, 560);

/// Size of a chart on a sheet: small enough that the letters are readable where a sheet of two is as wide as a page.
const ON_SHEET: (u32, u32) = (440, 350);

/// Colours that stay distinct in grey and for people who confuse red and green (Wong, 2011).
const COLOURS: [RGBColor; 6] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(86, 180, 233),
    RGBColor(230, 159, 0),
    RGBColor(60, 60, 60),
];

impl Figure {
    /// The chart as the text of an SVG file.
    ///
    /// # Errors
    /// There is nothing to draw.
    pub fn svg(&self) -> Result<String, FigureError> {
        svg(if self.equal { SQUARE } else { SIZE }, |area| self.draw(area))
    }

    /// Least and greatest of a coordinate, with some room around.
    fn range(&self, of: impl Fn(&(f64, f64)) -> f64) -> Option<(f64, f64)> {
        let all = || self.curves.iter().flat_map(|c| &c.points).map(&of).filter(|x| x.is_finite());
        let low = all().min_by(f64::total_cmp)?;
        let high = all().max_by(f64::total_cmp)?;
        let room = if high > low { 0.04 * (high - low) } else { high.abs().max(1.0) };
        Some((low - room, high + room))
    }

    /// The corner of the chart where a legend hides the fewest points.
    fn emptiest_corner(&self, x: (f64, f64), y: (f64, f64)) -> SeriesLabelPosition {
        let corners = [
            (SeriesLabelPosition::UpperLeft, 0.0, 1.0),
            (SeriesLabelPosition::UpperRight, 1.0, 1.0),
            (SeriesLabelPosition::LowerRight, 1.0, 0.0),
            (SeriesLabelPosition::LowerLeft, 0.0, 0.0),
        ];
        // Joined points are counted along the line too, so that a line between two of them is seen.
        let along = |c: &Curve| -> Vec<(f64, f64)> {
            let between = |w: &[(f64, f64)]| {
                let (a, b) = (w[0], w[1]);
                (0..10).map(move |i| (a.0 + 0.1 * f64::from(i) * (b.0 - a.0), a.1 + 0.1 * f64::from(i) * (b.1 - a.1)))
            };
            c.points.windows(2).flat_map(between).chain(c.points.last().copied()).collect()
        };
        let points: Vec<(f64, f64)> = self.curves.iter().flat_map(along).collect();
        let fraction = |v: f64, r: (f64, f64)| (v - r.0) / (r.1 - r.0);
        let hidden = |cx: f64, cy: f64| {
            let near = |p: &&(f64, f64)| (fraction(p.0, x) - cx).abs() < 0.3 && (fraction(p.1, y) - cy).abs() < 0.25;
            points.iter().filter(near).count()
        };
        let best = corners.into_iter().min_by_key(|&(_, cx, cy)| hidden(cx, cy));
        best.map_or(SeriesLabelPosition::UpperLeft, |b| b.0)
    }

    /// A number on an axis; only whole ones where all points have whole ones.
    fn tick(&self, value: f64, range: (f64, f64), of: impl Fn(&(f64, f64)) -> f64) -> String {
        let whole =
            range.1 - range.0 < 20.0 && self.curves.iter().flat_map(|c| &c.points).all(|p| of(p).fract() == 0.0);
        if whole && value.fract() != 0.0 { String::new() } else { tick(value, range) }
    }

    fn draw(&self, area: &DrawingArea<SVGBackend<'_>, Shift>) -> Result<(), FigureError> {
        let nothing = || FigureError("there are no points to draw".into());
        let (mut x, mut y) = (self.range(|p| p.0).ok_or_else(nothing)?, self.range(|p| p.1).ok_or_else(nothing)?);
        x = self.x_range.unwrap_or(x);
        y = self.y_range.unwrap_or(y);
        if self.equal {
            // Room for letters at the sides and above is not part of the chart.
            let (width, height) = area.dim_in_pixel();
            let scale = (f64::from(width) - 100.0).max(1.0) / (f64::from(height) - 100.0).max(1.0);
            let half = 0.5 * ((x.1 - x.0) / scale).max(y.1 - y.0);
            let about = |r: (f64, f64), half: f64| (0.5 * (r.0 + r.1) - half, 0.5 * (r.0 + r.1) + half);
            (x, y) = (about(x, half * scale), about(y, half));
        }
        let failed = |e: &dyn fmt::Display| FigureError(e.to_string());
        area.fill(&WHITE).map_err(|e| failed(&e))?;
        let mut chart = ChartBuilder::on(area)
            .margin(14)
            .caption(&self.title, ("sans-serif", 18))
            .x_label_area_size(46)
            .y_label_area_size(72)
            .build_cartesian_2d(x.0..x.1, y.0..y.1)
            .map_err(|e| failed(&e))?;
        chart
            .configure_mesh()
            .light_line_style(TRANSPARENT)
            .bold_line_style(BLACK.mix(0.12))
            .x_labels(8)
            .y_labels(8)
            .x_label_formatter(&|v| self.tick(*v, x, |p| p.0))
            .y_label_formatter(&|v| self.tick(*v, y, |p| p.1))
            .x_desc(&self.x_label)
            .y_desc(&self.y_label)
            .label_style(("sans-serif", 13))
            .axis_desc_style(("sans-serif", 14))
            .draw()
            .map_err(|e| failed(&e))?;
        let shade = self.shaded.iter().map(|s| Rectangle::new([(s.0, y.0), (s.1, y.1)], BLACK.mix(0.08).filled()));
        chart.draw_series(shade).map_err(|e| failed(&e))?;
        for (i, curve) in self.curves.iter().enumerate() {
            let colour = COLOURS[(self.first_colour + i) % COLOURS.len()];
            let points = curve.points.iter().copied().filter(|p| p.0.is_finite() && p.1.is_finite());
            let drawn = match curve.mark {
                Mark::Line => chart.draw_series(LineSeries::new(points, colour.stroke_width(1))),
                Mark::Dots => chart.draw_series(points.map(|p| Circle::new(p, 3, colour.filled()))),
            };
            let drawn = drawn.map_err(|e| failed(&e))?;
            if !curve.name.is_empty() {
                drawn
                    .label(&curve.name)
                    .legend(move |(x, y)| Rectangle::new([(x, y - 1), (x + 18, y + 1)], colour.filled()));
            }
        }
        if self.curves.iter().any(|c| !c.name.is_empty()) {
            chart
                .configure_series_labels()
                .background_style(WHITE.mix(0.85))
                .border_style(BLACK.mix(0.3))
                .label_font(("sans-serif", 13))
                .position(self.emptiest_corner(x, y))
                .draw()
                .map_err(|e| failed(&e))?;
        }
        Ok(())
    }
}

/// Charts side by side, row after row, as the text of an SVG file.
///
/// # Errors
/// There is nothing to draw in one of them.
pub fn sheet(charts: &[Figure], columns: usize) -> Result<String, FigureError> {
    let columns = columns.clamp(1, charts.len().max(1));
    let rows = charts.len().div_ceil(columns);
    svg((ON_SHEET.0 * columns as u32, ON_SHEET.1 * rows as u32), |area| {
        area.split_evenly((rows, columns)).iter().zip(charts).try_for_each(|(area, chart)| chart.draw(area))
    })
}

/// The drawing on an area of the given size, as the text of an SVG file.
fn svg(
    size: (u32, u32),
    draw: impl FnOnce(&DrawingArea<SVGBackend<'_>, Shift>) -> Result<(), FigureError>,
) -> Result<String, FigureError> {
    let mut text = String::new();
    {
        let area = SVGBackend::with_string(&mut text, size).into_drawing_area();
        draw(&area).and_then(|()| area.present().map_err(|e| FigureError(e.to_string())))?;
    }
    Ok(text)
}

/// A number on an axis with the digits that the range needs.
fn tick(value: f64, range: (f64, f64)) -> String {
    let step = (range.1 - range.0) / 8.0;
    let largest = range.0.abs().max(range.1.abs());
    if !(1e-3..1e6).contains(&largest) {
        return format!("{value:.1e}");
    }
    let digits = (-step.log10()).ceil().max(0.0) as usize + usize::from(step < 1.0);
    let text = format!("{value:.digits$}");
    let trimmed = if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { &text };
    if trimmed == "-0" { "0".into() } else { trimmed.to_owned() }
}
