//! Columns of recordings matched with columns of recorders, by their names, their units and the correlation.

use super::ScriptOutline;
use crate::study::trace::Trace;
use hysteron_recordings::unit::{self, Quantity};
use hysteron_recordings::{Column, Recording};

/// Correlation above which a column is taken to be the imposed motion itself.
const IMPOSED_CORRELATION: f64 = 0.999_999;
/// Correlation below which a column is no match, unless its name says so.
const MIN_CORRELATION: f64 = 0.5;
/// Worth of a fitting name, in units of correlation.
const NAME_WORTH: f64 = 0.4;
/// Worth of a positive correlation.
const SIGN_WORTH: f64 = 0.01;

/// A column of a recorder that a channel may be compared with.
pub(super) struct Candidate<'a> {
    file: &'a str,
    column: usize,
    place: &'a str,
    /// Words of the recorder.
    words: &'a str,
    trace: &'a Trace,
}

/// A recorded column with its column of a recorder.
pub(super) struct Match {
    pub(super) file: String,
    pub(super) column: usize,
    /// Response that the recorder records, in its words.
    pub(super) place: String,
    /// Correlation of the script's own run with the recording; NaN if there is none.
    pub(super) correlation: f64,
    /// Recorded over simulated amplitude by least squares.
    pub(super) factor: f64,
    /// Names agree.
    pub(super) by_name: bool,
    /// Quantities are known and agree.
    pub(super) by_quantity: bool,
}

impl Match {
    /// Returns true if the channel is a response to compare, and not the imposed motion or a chance resemblance.
    pub(super) fn is_response(&self) -> bool {
        let is_imposed = self.correlation.abs() > IMPOSED_CORRELATION;
        !is_imposed && (self.by_name || self.by_quantity || self.correlation.abs() >= MIN_CORRELATION)
    }

    /// Returns true if the output is the recorded motion itself.
    pub(super) fn is_imposed(&self) -> bool {
        self.correlation.abs() > IMPOSED_CORRELATION
    }
}

impl<'a> Candidate<'a> {
    /// All columns of traces that are not their times.
    pub(super) fn of_traces(traces: &'a [(String, Trace)], outline: &'a ScriptOutline) -> Vec<Self> {
        let columns = |(file, trace): &'a (String, Trace)| {
            let has_time =
                trace.width > 1 && trace.values.iter().step_by(trace.width).zip(&trace.times).all(|(v, t)| v == t);
            let (place, words) = (outline.place(file).unwrap_or_default(), outline.words(file).unwrap_or_default());
            let usable = !trace.times.is_empty() && !trace.no_clock;
            let first = usize::from(has_time);
            (first..if usable { trace.width } else { first }).map(move |column| Candidate {
                file,
                column,
                place,
                words,
                trace,
            })
        };
        traces.iter().flat_map(columns).collect()
    }

    /// The quantity that the words of the recorder or the name of its file stand for.
    pub(super) fn quantity(&self) -> Option<Quantity> {
        quantity_of(&format!("{} {}", self.words, self.file).to_lowercase())
    }
}

/// The quantity that words such as `disp` or `force` stand for.
fn quantity_of(words: &str) -> Option<Quantity> {
    const WORDS: [(&str, Quantity); 11] = [
        ("accel", Quantity::Acceleration),
        ("acc", Quantity::Acceleration),
        ("vel", Quantity::Velocity),
        ("disp", Quantity::Length),
        ("deform", Quantity::Length),
        ("drift", Quantity::Length),
        ("force", Quantity::Force),
        ("react", Quantity::Force),
        ("shear", Quantity::Force),
        ("stress", Quantity::Stress),
        ("strain", Quantity::Ratio),
    ];
    WORDS.iter().find(|(w, _)| words.contains(w)).map(|(_, q)| *q)
}

/// The best candidate for each column of a recording; none for one that is constant or has none.
pub(super) fn match_columns(recording: &Recording, candidates: &[Candidate<'_>]) -> Vec<Option<Match>> {
    recording.columns.iter().map(|c| best(c, &recording.times, candidates)).collect()
}

/// The quantity of a recorded column, by its unit or its name.
pub(super) fn recorded_quantity(column: &Column) -> Option<Quantity> {
    let of_unit = unit::unit(&column.unit).map(|u| u.quantity);
    of_unit.or_else(|| quantity_of(&column.name.to_lowercase()))
}

fn best(column: &Column, times: &[f64], candidates: &[Candidate<'_>]) -> Option<Match> {
    let name = column.name.to_lowercase();
    let quantity = recorded_quantity(column);
    let mut best: Option<(f64, Match)> = None;
    for c in candidates {
        let other = c.quantity();
        // A force is never compared with a displacement, however alike they are.
        if let (Some(a), Some(b)) = (quantity, other)
            && a != b
        {
            continue;
        }
        let (correlation, factor) = correlation(&column.values, &c.trace.sample(c.column, times));
        let stem = c.file.rsplit('/').next().unwrap_or(c.file).split('.').next().unwrap_or_default().to_lowercase();
        let by_name = !stem.is_empty() && (name.contains(&stem) || stem.contains(&name));
        let by_quantity = quantity.is_some() && quantity == other;
        let strength = if correlation.is_nan() { 0.0 } else { correlation.abs() };
        // The two ends of an element have forces of opposite signs: the one with the sign of the recording.
        let sign = if correlation > 0.0 { SIGN_WORTH } else { 0.0 };
        let score = strength + sign + if by_name || by_quantity { NAME_WORTH } else { 0.0 };
        // The first of equal ones: columns of one file follow each other.
        if score > 0.0 && best.as_ref().is_none_or(|(s, _)| score > s + 1e-9) {
            let (file, place) = (c.file.to_owned(), c.place.to_owned());
            best = Some((score, Match { file, column: c.column, place, correlation, factor, by_name, by_quantity }));
        }
    }
    best.map(|(_, m)| m)
}

/// Correlation of two channels, and the factor by which the second comes closest to the first. NaN where one is constant.
fn correlation(recorded: &[f64], simulated: &[f64]) -> (f64, f64) {
    let pairs = || recorded.iter().zip(simulated).filter(|(a, b)| a.is_finite() && b.is_finite());
    let n = pairs().count() as f64;
    let (sum_a, sum_b) = pairs().fold((0.0, 0.0), |(a, b), (x, y)| (a + x, b + y));
    let (mean_a, mean_b) = (sum_a / n, sum_b / n);
    let (mut aa, mut bb, mut ab) = (0.0, 0.0, 0.0);
    for (x, y) in pairs() {
        let (x, y) = (x - mean_a, y - mean_b);
        (aa, bb, ab) = (aa + x * x, bb + y * y, ab + x * y);
    }
    (ab / (aa * bb).sqrt(), ab / bb)
}

#[cfg(test)]
mod tests {
    use super::{Candidate, match_columns};
    use crate::study::draft::ScriptOutline;
    use crate::study::trace::Trace;
    use hysteron_recordings::Recording;
    use hysteron_tcl::diagnostic::SourceMap;

    #[test]
    fn columns_are_matched_by_quantity_and_correlation() {
        let times: Vec<f64> = (0..50).map(|i| 0.1 * f64::from(i)).collect();
        let trace = |columns: &[fn(f64) -> f64]| Trace {
            values: times.iter().flat_map(|t| std::iter::once(*t).chain(columns.iter().map(|f| f(*t)))).collect(),
            times: times.clone(),
            width: columns.len() + 1,
            ..Trace::default()
        };
        let traces = [
            ("roof.out".to_owned(), trace(&[f64::sin, |t| (3.0 * t).cos()])),
            ("force.out".to_owned(), trace(&[|t| -5.0 * t.sin() + 0.1 * t])),
        ];
        let outline = ScriptOutline::of("recorder Node -file roof.out -time -node 2 -dof 1 2 disp\n");
        let rows: String = times
            .iter()
            .map(|t| format!("{t},{},{},{}\n", 10.0 * t.sin(), 2.0 * (3.0 * t).cos() + 0.1 * t, 20.0))
            .collect();
        let text = format!("time[s],load[kN],top[mm],temperature[degC]\n{rows}");
        let recording = Recording::parse("r.csv", &text, &mut SourceMap::default()).expect("a recording");
        let matches = match_columns(&recording, &Candidate::of_traces(&traces, &outline));
        let found: Vec<_> = matches.iter().map(|m| m.as_ref().map(|m| (m.file.as_str(), m.column))).collect();
        assert_eq!(found, [Some(("force.out", 1)), Some(("roof.out", 2)), None]);
        let load = matches[0].as_ref().expect("a match");
        assert!(load.correlation < -0.99 && load.is_response() && (load.factor + 2.0).abs() < 0.1);
    }
}
