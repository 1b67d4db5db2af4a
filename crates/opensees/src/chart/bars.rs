//! Bars of several quantities side by side.

use super::FigureError;
use super::axis::{Axis, spans_decades};
use super::svg::{COLOURS, LETTERS, Svg, text_width};

/// A chart of horizontal bars: a group for each name, in it a bar for each series.
#[derive(Clone, Debug, Default)]
pub struct Bars {
    /// Title.
    pub title: String,
    /// Quantity with its unit.
    pub label: String,
    /// Names of the groups.
    pub names: Vec<String>,
    /// Names of the series with one value for each group; NaN for none.
    pub series: Vec<(String, Vec<f64>)>,
}

/// Height of a bar in pixels.
const BAR: f64 = 11.0;
/// Height between two groups in pixels.
const GROUP_SPACE: f64 = 9.0;
/// Width of a chart in pixels.
const WIDTH: f64 = 720.0;

impl Bars {
    /// The chart as the text of an SVG. The axis is logarithmic if the values are positive and span more than two decades.
    ///
    /// # Errors
    /// There is nothing to draw.
    pub fn svg(&self) -> Result<String, FigureError> {
        let values = || self.series.iter().flat_map(|(_, v)| v.iter().copied()).filter(|x| x.is_finite());
        let log = spans_decades(values());
        let ends = Axis::ends(values(), log).ok_or_else(|| FigureError("there are no bars to draw".into()))?;
        let ends = if log { ends } else { (ends.0.min(0.0), ends.1.max(0.0)) };
        let left = 24.0 + self.names.iter().map(|n| text_width(n, LETTERS)).fold(0.0, f64::max).min(0.45 * WIDTH);
        let legend_top = 30.0;
        let top = legend_top + 26.0;
        let group = BAR * self.series.len() as f64 + GROUP_SPACE;
        let bottom = top + group * self.names.len() as f64;
        let axis = Axis::new(ends, (left, WIDTH - 70.0), log);
        let mut out = Svg::new(WIDTH, bottom + 50.0);
        out.title(&self.title, left, WIDTH);
        out.legend(
            self.series.iter().enumerate().map(|(k, (name, _))| (name.as_str(), COLOURS[k % COLOURS.len()])),
            left,
            legend_top + 8.0,
            WIDTH,
        );
        for (value, text) in axis.ticks(false) {
            let x = axis.pixel(value);
            out.line((x, top), (x, bottom), "#ddd");
            out.text(&text, (x, bottom + 17.0), "middle");
        }
        for (g, name) in self.names.iter().enumerate() {
            let y = top + group * g as f64 + 0.5 * GROUP_SPACE;
            out.text(name, (left - 8.0, y + 0.5 * (group - GROUP_SPACE) + 4.5), "end");
            for (k, (_, values)) in self.series.iter().enumerate() {
                let Some(value) = values.get(g).filter(|x| x.is_finite()) else { continue };
                let y = y + BAR * k as f64;
                let (from, to) = (axis.pixel(if log { ends.0 } else { 0.0 }), axis.pixel(*value));
                out.rectangle((from.min(to), y), ((to - from).abs(), BAR - 1.0), COLOURS[k % COLOURS.len()]);
                out.small_text(&short(*value), (from.max(to) + 4.0, y + BAR - 2.0));
            }
        }
        out.line((left, top), (left, bottom), "#222");
        out.text(&self.label, (0.5 * (left + WIDTH - 70.0), bottom + 38.0), "middle");
        Ok(out.finish())
    }
}

/// A value with two significant digits.
fn short(x: f64) -> String {
    if x == 0.0 {
        return "0".into();
    }
    let decimals = 1 - x.abs().log10().floor() as i32;
    if decimals > 6 || x.abs() >= 1e5 { format!("{x:.1e}") } else { format!("{x:.*}", decimals.max(0) as usize) }
}

#[cfg(test)]
mod tests {
    use super::Bars;

    #[test]
    fn bars_over_decades_have_a_logarithmic_axis() {
        let bars = Bars {
            title: "Error".into(),
            label: "NMSE".into(),
            names: vec!["a".into(), "b & c".into()],
            series: vec![("before".into(), vec![0.5, 0.02]), ("after".into(), vec![0.001, f64::NAN])],
        };
        let svg = bars.svg().expect("a chart");
        assert_eq!(svg.matches("<rect").count(), 1 + 3 + 2, "{svg}");
        assert!(svg.contains(">0.001<") && svg.contains("b &amp; c") && svg.contains(">before<"), "{svg}");
        assert!(Bars::default().svg().is_err());
    }
}
