//! Options that all recorders share, and how a recorder enters the session.

use super::recorder_file::make_room;
use super::recorders::PlacedRecorder;
use crate::args::Args;
use crate::checks;
use crate::files::outputs::FileFormat;
use crate::text::{Arg, Domain};
use crate::things;
use crate::{Outcome, Tcl, warn};
use hysteron_engine::model::Tag;
use hysteron_engine::number_format::Style;
use hysteron_engine::record::{Cadence, Layout, Output, Recorder, Separator, Source};
use hysteron_tcl::diagnostic::{Absent, Diagnostic, Span};
use hysteron_tcl::{Call, Exception, Value};
use std::collections::BTreeMap;

pub(super) const PRECISION: Arg = Arg::of("-precision", "n", "number of digits").within(Domain::Count);
pub(super) const TIME_STEP: Arg = Arg::of("-dT", "dt", "step of time dT").within(Domain::NotNegative);
pub(super) const TIME_TOLERANCE: Arg = Arg::of("-rTolDt", "tolerance", "tolerance rTolDt").within(Domain::NotNegative);

/// Numbers are written with an exponent.
pub(super) const SCIENTIFIC: Arg = Arg::flag("-scientific", "numbers with an exponent");

/// A recorder that keeps rows in one way.
pub(super) type Keep = fn(Box<dyn Source>, Box<dyn Output>, Cadence) -> Recorder;

/// The options that all recorders share.
#[derive(Default)]
pub(super) struct Common {
    file: Option<(String, Option<Span>)>,
    style: Option<Style>,
    layout: Option<Layout>,
    close_on_write: bool,
    cadence: Cadence,
    /// Places of the tags of nodes and elements and of the degrees of freedom, for messages.
    tags: BTreeMap<Absent, Span>,
    /// None of the elements that are there has the response, which has been said.
    pub(super) knows_missing_response: bool,
}

impl Common {
    pub(super) fn new(interp: &Tcl) -> Self {
        Self {
            style: Some(interp.host.output.style),
            cadence: Cadence { tolerance: 1e-5, ..Cadence::default() },
            ..Self::default()
        }
    }

    /// Take an option that all recorders share; `false` if it is none.
    pub(super) fn take(&mut self, option: &str, a: &mut Args<'_>) -> Result<bool, Exception> {
        let style = self.style.get_or_insert_default();
        match option {
            "-file" | "-fileCSV" | "-csv" | "-xml" | "-binary" => {
                self.layout = Some(match option {
                    "-file" => Layout::Text(Separator::Space),
                    "-xml" => Layout::Xml,
                    "-binary" => Layout::Binary,
                    _ => Layout::Text(Separator::Comma),
                });
                self.file = Some((a.word("name of the file")?.into_owned(), a.last_span()));
            }
            "-time" | "-load" => self.cadence.time = true,
            "-dT" | "-dt" => self.cadence.dt = a.number(&TIME_STEP)?,
            "-rTolDt" => self.cadence.tolerance = a.number(&TIME_TOLERANCE)?,
            "-closeOnWrite" => self.close_on_write = true,
            "-precision" => style.precision = a.count(&PRECISION)?,
            "-scientific" => style.scientific = true,
            "-tcp" | "-database" | "-fileAdd" => {
                let message = format!("recorder: the output {option} is not supported yet");
                return Err(a.refuse(message, "expected -file, -csv, -xml or -binary"));
            }
            _ => return Ok(false),
        }
        Ok(true)
    }

    /// Take tags of nodes or elements.
    pub(super) fn take_tags(&mut self, what: &'static str, a: &mut Args<'_>) -> Vec<Tag> {
        let placed = a.tags(what);
        for (tag, span) in &placed {
            self.tags.extend(span.map(|s| (Absent::new(what, tag), s)));
        }
        placed.into_iter().map(|(tag, _)| tag).collect()
    }

    /// Degrees of freedom or columns, counted from 0.
    pub(super) fn take_dofs(&mut self, a: &mut Args<'_>) -> Result<Vec<usize>, Exception> {
        let mut out = vec![];
        for (d, span) in a.placed_ints() {
            match usize::try_from(d - 1) {
                Ok(from_zero) => out.push(from_zero),
                Err(_) => return Err(a.absent(things::DOF, d, "expected 1, 2, ...")),
            }
            self.tags.extend(span.map(|s| (Absent::new(things::DOF, d), s)));
        }
        Ok(out)
    }

    /// Open the output and add the recorder; its tag.
    pub(super) fn finish(self, interp: &mut Tcl, call: &Call<'_>, source: Box<dyn Source>, keep: Keep) -> Outcome {
        let path = self.file.as_ref().map(|(name, _)| interp.absolute(name));
        let output: Box<dyn Output> = match self.file.as_ref().zip(path.as_ref()) {
            Some(((name, span), path)) => {
                let format = FileFormat {
                    style: self.style.unwrap_or_default(),
                    layout: self.layout.unwrap_or(Layout::Text(Separator::Space)),
                    close_on_write: self.close_on_write,
                };
                make_room(interp, call, (name, path), *span)?;
                let made = interp.host.output.outputs.create(name, path.as_ref(), format);
                made.map_err(|e| Exception::diagnosed(Diagnostic::error(e.to_string()).at(*span, "cannot write here")))?
            }
            None => {
                let d = Diagnostic::warning(&checks::output::NO_FILE, "recorder: there is no file, so nothing is kept");
                warn(interp, d.at(call.span(0), "expected -file"))?;
                Box::new(Nowhere)
            }
        };
        let recorder = keep(source, output, self.cadence);
        let file = self.file.map(|(name, _)| name).zip(path);
        let placed = Placed { recorder, tags: self.tags, knows_missing_response: self.knows_missing_response };
        Ok(add(interp, call, placed, file))
    }
}

/// A recorder with the places of the tags in its command.
pub(super) struct Placed {
    pub(super) recorder: Recorder,
    pub(super) tags: BTreeMap<Absent, Span>,
    pub(super) knows_missing_response: bool,
}

impl Placed {
    /// A recorder whose command names no tags.
    pub(super) fn without_tags(recorder: Recorder) -> Self {
        Self { recorder, tags: BTreeMap::new(), knows_missing_response: false }
    }
}

/// Add a recorder to the session, with the name of its file and where that is; its tag.
pub(super) fn add(interp: &mut Tcl, call: &Call<'_>, placed: Placed, file: Option<(String, String)>) -> Value {
    let Placed { recorder, tags, knows_missing_response } = placed;
    let (file, path) = file.unzip();
    if let Some(path) = &path {
        interp.host.output.recorders.live.add(path, recorder.live().as_ref());
    }
    let (span, words) = (call.whole_span(), words(call));
    let placed = PlacedRecorder { recorder, span, tags, path, file, words, reported: false, knows_missing_response };
    Value::from(i64::from(interp.host.output.recorders.add(placed)))
}

/// The words of a command.
pub(super) fn words(call: &Call<'_>) -> Vec<String> {
    call.args().iter().map(|w| w.as_str().into_owned()).collect()
}

/// An output that keeps nothing.
#[derive(Debug)]
struct Nowhere;

impl Output for Nowhere {
    fn row(&mut self, _: &[f64]) -> Result<(), hysteron_engine::record::RecordError> {
        Ok(())
    }
    fn finish(&mut self) -> Result<(), hysteron_engine::record::RecordError> {
        Ok(())
    }
}

/// Tags of a region's nodes or elements.
pub(super) fn region(interp: &Tcl, a: &mut Args<'_>, nodes: bool) -> Result<Vec<Tag>, Exception> {
    let tag = a.tag(things::REGION, "tag of a region")?;
    let Some(r) = interp.host.builder.regions.get(&tag) else {
        return Err(a.absent(things::REGION, tag, "expected the tag of a region"));
    };
    let model = interp.host.engine.model();
    Ok(if nodes {
        r.nodes.iter().map(|n| model.nodes[n.0].tag).collect()
    } else {
        r.elements.iter().map(|e| model.elements[e.0].tag).collect()
    })
}

/// Tags within a range that are there when the recorder is made, with a warning where there is none.
pub(super) fn range(
    interp: &mut Tcl,
    a: &mut Args<'_>,
    what: &'static str,
    there: Vec<Tag>,
) -> Result<Vec<Tag>, Exception> {
    let first = a.int("first tag")?;
    let span = a.last_span();
    let last = a.int("last tag")?;
    let found: Vec<Tag> = there.into_iter().filter(|t| (first.min(last)..=first.max(last)).contains(t)).collect();
    if found.is_empty() && !interp.host.check.holds_back(&Absent::new(what, first)) {
        let message = format!("recorder: no {what} from {first} to {last} has been defined");
        warn(interp, Diagnostic::warning(&checks::output::NOTHING_RECORDED, message).at(span, "nothing is recorded"))?;
    }
    Ok(found)
}
