//! The tables of `study.toml` as they are written, and the locations of their values. [`super::load`] checks them.

use super::load::StudyError;
use hysteron_tcl::diagnostic::{Diagnostic, SourceId, Span, nearest};
use serde::Deserialize;
use std::collections::BTreeMap;
use toml::Spanned;

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct StudyFile {
    pub(super) title: Option<String>,
    pub(super) model: Spanned<String>,
    #[serde(default)]
    pub(super) parameter: Vec<Spanned<ParameterTable>>,
    #[serde(default)]
    pub(super) run: Vec<Spanned<RunTable>>,
    #[serde(default)]
    pub(super) calibration: CalibrationTable,
    pub(super) rig: Option<RigTable>,
    pub(super) material: Option<Spanned<String>>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct ParameterTable {
    pub(super) name: Spanned<String>,
    pub(super) lower: Option<Spanned<f64>>,
    pub(super) upper: Option<Spanned<f64>>,
    pub(super) scale: Option<Spanned<String>>,
    pub(super) value: Option<Spanned<f64>>,
    pub(super) expr: Option<Spanned<String>>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct RunTable {
    pub(super) name: Spanned<String>,
    pub(super) role: Option<Spanned<String>>,
    pub(super) recording: Spanned<String>,
    pub(super) unit: Option<String>,
    pub(super) dt: Option<Spanned<f64>>,
    pub(super) quantity: Option<String>,
    pub(super) layout: Option<Spanned<String>>,
    #[serde(default)]
    pub(super) set: BTreeMap<Spanned<String>, Spanned<toml::Value>>,
    #[serde(default)]
    pub(super) observe: Vec<Spanned<ObserveTable>>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct ObserveTable {
    pub(super) channel: Spanned<String>,
    pub(super) output: Spanned<String>,
    pub(super) column: Spanned<i64>,
    pub(super) at: Option<String>,
    pub(super) weight: Option<Spanned<f64>>,
    pub(super) factor: Option<Spanned<f64>>,
    pub(super) offset: Option<Spanned<f64>>,
    pub(super) shift: Option<Spanned<f64>>,
    pub(super) unit: Option<Spanned<String>>,
    pub(super) measure: Option<Spanned<String>>,
    pub(super) deformation: Option<Spanned<String>>,
    pub(super) deformation_column: Option<Spanned<i64>>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct CalibrationTable {
    pub(super) method: Option<Spanned<String>>,
    pub(super) population: Option<Spanned<i64>>,
    pub(super) generations: Option<Spanned<i64>>,
    #[serde(rename = "F")]
    pub(super) f: Option<Spanned<f64>>,
    #[serde(rename = "CR")]
    pub(super) cr: Option<Spanned<f64>>,
    pub(super) seed: Option<Spanned<i64>>,
    pub(super) repeats: Option<Spanned<i64>>,
    pub(super) evaluations: Option<Spanned<i64>>,
    pub(super) polish: Option<bool>,
    pub(super) time_limit: Option<Spanned<f64>>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct RigTable {
    pub(super) stroke: Option<Spanned<f64>>,
    pub(super) speed: Option<Spanned<f64>>,
    pub(super) force: Option<Spanned<f64>>,
    pub(super) temperature: Option<Spanned<[f64; 2]>>,
}

/// Locations in the file of the study, for messages.
pub(super) struct SourceSpans {
    source: SourceId,
}

impl SourceSpans {
    /// Locations in a text.
    pub(super) fn new(source: SourceId) -> Self {
        Self { source }
    }

    /// The location of a value.
    pub(super) fn span<T>(&self, s: &Spanned<T>) -> Span {
        let range = s.span();
        Span { source: self.source, start: range.start as u32, end: range.end as u32 }
    }

    /// An error at a value.
    pub(super) fn error<T>(&self, s: &Spanned<T>, message: impl Into<String>, label: impl Into<String>) -> StudyError {
        Box::new(Diagnostic::error(message).at(Some(self.span(s)), label))
    }

    /// A finite number that passes the check `good`. The message says what was `expected`.
    pub(super) fn number(
        &self,
        what: &str,
        s: &Spanned<f64>,
        good: impl Fn(f64) -> bool,
        expected: &str,
    ) -> Result<f64, StudyError> {
        let x = *s.get_ref();
        if x.is_finite() && good(x) { Ok(x) } else { Err(self.error(s, format!("{what} is {x}"), expected)) }
    }

    /// A whole number that is at least `least`.
    pub(super) fn count(&self, what: &str, s: &Option<Spanned<i64>>, least: i64) -> Result<Option<usize>, StudyError> {
        let Some(s) = s else { return Ok(None) };
        match usize::try_from(*s.get_ref()) {
            Ok(n) if n as i64 >= least => Ok(Some(n)),
            _ => {
                let message = format!("{what} is {}", s.get_ref());
                Err(self.error(s, message, format!("expected a whole number not less than {least}")))
            }
        }
    }

    /// One of several known words.
    pub(super) fn choice<'a>(&self, what: &str, s: &Spanned<String>, known: &[&'a str]) -> Result<&'a str, StudyError> {
        let word = s.get_ref();
        if let Some(k) = known.iter().find(|k| *k == word) {
            return Ok(k);
        }
        let mut d = self.error(s, format!("unknown {what} \"{word}\""), format!("expected {}", known.join(" or ")));
        d.add_suggestion(word, nearest(word, known.iter().copied()));
        Err(d)
    }
}

/// Locations of the words of a study that messages about its runs point at.
#[derive(Clone, Debug, Default)]
pub(super) struct StudySpans {
    /// Names of the parameters.
    pub(super) names: Vec<Span>,
    /// Names in `set`, by run.
    set: Vec<Vec<Span>>,
    /// Observed channels, by run.
    channels: Vec<Vec<ChannelSpans>>,
    /// Recordings, by run.
    recordings: Vec<Span>,
}

/// Locations of the words of a `[[run.observe]]`.
#[derive(Clone, Copy, Debug)]
pub(super) struct ChannelSpans {
    pub(super) channel: Span,
    pub(super) output: Span,
    pub(super) column: Span,
}

impl StudySpans {
    /// The locations of a file.
    pub(super) fn new(spans: &SourceSpans, file: &StudyFile) -> Self {
        let runs = || file.run.iter().map(Spanned::get_ref);
        let channel = |o: &Spanned<ObserveTable>| {
            let o = o.get_ref();
            ChannelSpans {
                channel: spans.span(&o.channel),
                output: spans.span(&o.output),
                column: spans.span(&o.column),
            }
        };
        Self {
            names: file.parameter.iter().map(|p| spans.span(&p.get_ref().name)).collect(),
            set: runs().map(|r| r.set.keys().map(|k| spans.span(k)).collect()).collect(),
            channels: runs().map(|r| r.observe.iter().map(channel).collect()).collect(),
            recordings: runs().map(|r| spans.span(&r.recording)).collect(),
        }
    }

    /// The name of a variable in the `set` of a run.
    pub(super) fn set(&self, run: usize, number: usize) -> Option<Span> {
        self.set.get(run)?.get(number).copied()
    }

    /// The recording of a run.
    pub(super) fn recording(&self, run: usize) -> Option<Span> {
        self.recordings.get(run).copied()
    }

    /// An observed channel of a run. Studies that are made of others may observe other channels.
    pub(super) fn channel(&self, run: usize, number: usize) -> Option<ChannelSpans> {
        self.channels.get(run)?.get(number).copied()
    }
}
