//! Elements of an SVG. Coordinates have two decimals, so that curves are not pulled to whole pixels.

use std::fmt::Write as _;

/// Colours that stay distinct in grey and for people who confuse red and green (Wong, 2011).
pub(super) const COLOURS: [&str; 6] = ["#0072b2", "#d55e00", "#009e73", "#56b4e9", "#e69f00", "#3c3c3c"];
/// Colour of a wide curve that lies beneath others.
pub(super) const BENEATH: &str = "#9a9a9a";
/// Height of letters in pixels.
pub(super) const LETTERS: f64 = 13.0;
/// Height of the letters of numbers beside bars.
const SMALL_LETTERS: f64 = 11.0;
/// Height of the letters of a title.
const TITLE_LETTERS: f64 = 15.0;

/// Width of a text in pixels, about: letters are somewhat more than half as wide as high.
pub(super) fn text_width(text: &str, height: f64) -> f64 {
    0.58 * height * text.chars().count() as f64
}

/// An SVG that is being written.
pub(super) struct Svg {
    out: String,
}

type Point = (f64, f64);

impl Svg {
    /// An SVG on white, in pixels.
    pub(super) fn new(width: f64, height: f64) -> Self {
        let mut out = format!(
            "<svg width=\"{width:.0}\" height=\"{height:.0}\" viewBox=\"0 0 {width:.0} {height:.0}\" \
             xmlns=\"http://www.w3.org/2000/svg\" font-family=\"system-ui,sans-serif\" font-size=\"{LETTERS}\" fill=\"#222\">\n"
        );
        let _ = writeln!(out, "<rect width=\"{width:.0}\" height=\"{height:.0}\" fill=\"#fff\"/>");
        Self { out }
    }

    pub(super) fn finish(mut self) -> String {
        self.out.push_str("</svg>\n");
        self.out
    }

    /// Begins a group whose origin is at a point.
    pub(super) fn open_group(&mut self, (x, y): Point) {
        let _ = writeln!(self.out, "<g transform=\"translate({x:.2} {y:.2})\">");
    }

    pub(super) fn close_group(&mut self) {
        self.out.push_str("</g>\n");
    }

    /// A title between two pixels, with smaller letters if it is too long for them.
    pub(super) fn title(&mut self, text: &str, left: f64, right: f64) {
        if !text.is_empty() {
            let fitting = TITLE_LETTERS * (right - left) / text_width(text, TITLE_LETTERS);
            let (height, text) = (fitting.clamp(SMALL_LETTERS, TITLE_LETTERS), escaped(text));
            let _ = writeln!(
                self.out,
                "<text x=\"{left:.2}\" y=\"20\" font-size=\"{height:.1}\" font-weight=\"600\">{text}</text>"
            );
        }
    }

    pub(super) fn text(&mut self, text: &str, (x, y): Point, anchor: &str) {
        let _ = writeln!(self.out, "<text x=\"{x:.2}\" y=\"{y:.2}\" text-anchor=\"{anchor}\">{}</text>", escaped(text));
    }

    pub(super) fn small_text(&mut self, text: &str, (x, y): Point) {
        let text = escaped(text);
        let _ = writeln!(self.out, "<text x=\"{x:.2}\" y=\"{y:.2}\" font-size=\"{SMALL_LETTERS}\">{text}</text>");
    }

    /// A text that reads upwards, centred at a point.
    pub(super) fn upward_text(&mut self, text: &str, (x, y): Point) {
        let text = escaped(text);
        let _ = writeln!(
            self.out,
            "<text x=\"{x:.2}\" y=\"{y:.2}\" text-anchor=\"middle\" transform=\"rotate(-90 {x:.2} {y:.2})\">{text}</text>"
        );
    }

    pub(super) fn line(&mut self, a: Point, b: Point, colour: &str) {
        let _ = writeln!(
            self.out,
            "<line x1=\"{:.2}\" y1=\"{:.2}\" x2=\"{:.2}\" y2=\"{:.2}\" stroke=\"{colour}\"/>",
            a.0, a.1, b.0, b.1
        );
    }

    pub(super) fn rectangle(&mut self, (x, y): Point, (width, height): Point, colour: &str) {
        let _ = writeln!(
            self.out,
            "<rect x=\"{x:.2}\" y=\"{y:.2}\" width=\"{width:.2}\" height=\"{height:.2}\" fill=\"{colour}\"/>"
        );
    }

    pub(super) fn frame(&mut self, (x, y): Point, (width, height): Point) {
        let _ = writeln!(
            self.out,
            "<path d=\"M{x:.2} {y:.2}h{width:.2}v{height:.2}h-{width:.2}z\" fill=\"none\" stroke=\"#777\"/>"
        );
    }

    pub(super) fn dot(&mut self, (x, y): Point, radius: f64, colour: &str) {
        let _ = writeln!(self.out, "<circle cx=\"{x:.2}\" cy=\"{y:.2}\" r=\"{radius}\" fill=\"{colour}\"/>");
    }

    pub(super) fn curve(&mut self, points: &[Point], colour: &str, width: f64) {
        if points.is_empty() {
            return;
        }
        let _ = write!(
            self.out,
            "<polyline fill=\"none\" stroke=\"{colour}\" stroke-width=\"{width}\" stroke-linejoin=\"round\" points=\""
        );
        for (x, y) in points {
            let _ = write!(self.out, "{x:.2},{y:.2} ");
        }
        self.out.push_str("\"/>\n");
    }

    /// A legend in rows from a point on; the number of pixels that further rows take.
    pub(super) fn legend<'a>(
        &mut self,
        entries: impl Iterator<Item = (&'a str, &'a str)>,
        left: f64,
        top: f64,
        right: f64,
    ) -> f64 {
        let (mut x, mut y) = (left, top);
        for (name, colour) in entries.filter(|(name, _)| !name.is_empty()) {
            let width = 26.0 + text_width(name, LETTERS) + 14.0;
            if x > left && x + width > right {
                (x, y) = (left, y + LEGEND_ROW);
            }
            self.rectangle((x, y - 6.0), (20.0, 4.0), colour);
            self.text(name, (x + 26.0, y), "start");
            x += width;
        }
        y - top
    }
}

/// Height of a row of a legend in pixels.
pub(super) const LEGEND_ROW: f64 = 18.0;

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
