//! `recorder` and `record`.

use super::recorder_file::make_room;
use super::recorders::PlacedRecorder;
use super::{collapse, display, pvd};
use crate::args::Args;
use crate::checks;
use crate::effect::Effect;
use crate::files::outputs::FileFormat;
use crate::text::Text;
use crate::things;
use crate::{Command, Outcome, Tcl, ignore_option, kind, slips, warn};
use hysteron_engine::analysis::Engine;
use hysteron_engine::model::{ElementId, Tag};
use hysteron_engine::number_format::Style;
use hysteron_engine::record::{
    Cadence, Drift, ElementResponse, Layout, Misspelled, NodeQuantity, NodeResponse, Output, Recorder, Separator,
    Source,
};
use hysteron_engine::series::Series;
use hysteron_tcl::diagnostic::{Absent, Diagnostic, Severity, Span, nearest};
use hysteron_tcl::{Call, Exception, Value};
use std::collections::BTreeMap;

pub(crate) const COMMANDS: &[Command] = &[
    Command::new("recorder", "recorder $kind -file $file ...", recorder)
        .about("Records responses in a file.")
        .with_kinds(|| kind::usages(KINDS))
        .leaving(Effect::Nothing),
    Command::new("record", "record", record).about("Makes all recorders write a row now.").leaving(Effect::Nothing),
    Command::new("setPrecision", "setPrecision $digits", set_precision)
        .about("Sets the digits of recorders that are made afterwards."),
];

/// A kind of recorder, added to the session by the words after its name.
type Kind = kind::Kind<fn(&mut Tcl, &Call<'_>, Args<'_>) -> Outcome>;

/// A recorder that keeps rows in one way.
type Keep = fn(Box<dyn Source>, Box<dyn Output>, Cadence) -> Recorder;

const KINDS: &[Kind] = &[
    Kind {
        names: &["Node"],
        usage: "recorder Node -file|-csv|-xml|-binary $file <-time> <-precision $n> <-dT $dt> <-closeOnWrite> \
                <-timeSeries $tag ...> -node $tag ... | -nodeRange $first $last | -region $tag -dof $dof ... $response",
        text: Text::new("Records responses of nodes."),
        make: |interp, call, a| node(interp, call, a, Recorder::history),
    },
    Kind {
        names: &["EnvelopeNode"],
        usage: "recorder EnvelopeNode -file $file <-time> -node $tag ... | -nodeRange $first $last | -region $tag \
                -dof $dof ... $response",
        text: Text::new("Records minimum, maximum and absolute maximum of responses of nodes."),
        make: |interp, call, a| node(interp, call, a, Recorder::envelope),
    },
    Kind {
        names: &["NodeRMS"],
        usage: "recorder NodeRMS -file $file <-dT $dt> -node $tag ... | -nodeRange $first $last | -region $tag \
                -dof $dof ... $response",
        text: Text::new("Records the root mean squares of responses of nodes over the steps."),
        make: |interp, call, a| node(interp, call, a, Recorder::root_mean_square),
    },
    Kind {
        names: &["Element"],
        usage: "recorder Element -file|-csv|-xml|-binary $file <-time> <-precision $n> <-dT $dt> <-closeOnWrite> \
                -ele $tag ... | -eleRange $first $last | -region $tag <-dof $column ...> $response ...",
        text: Text::new("Records responses of elements."),
        make: |interp, call, a| element(interp, call, a, Recorder::history),
    },
    Kind {
        names: &["EnvelopeElement"],
        usage: "recorder EnvelopeElement -file $file <-time> -ele $tag ... | -eleRange $first $last | -region $tag \
                <-dof $column ...> $response ...",
        text: Text::new("Records minimum, maximum and absolute maximum of responses of elements."),
        make: |interp, call, a| element(interp, call, a, Recorder::envelope),
    },
    Kind {
        names: &["Drift", "DriftRecorder"],
        usage: "recorder Drift -file $file <-time> -iNode $tag ... -jNode $tag ... <-dof $dof> <-perpDirn $direction>",
        text: Text::new("Records drifts between pairs of nodes."),
        make: |interp, call, a| drift(interp, call, a, Recorder::history),
    },
    Kind {
        names: &["EnvelopeDrift"],
        usage: "recorder EnvelopeDrift -file $file <-time> -iNode $tag ... -jNode $tag ... -dof $dof \
                -perpDirn $direction",
        text: Text::new("Writes minimum, maximum and largest absolute value of drifts between nodes."),
        make: |interp, call, a| drift(interp, call, a, Recorder::envelope),
    },
    Kind {
        names: &["Collapse", "Remove", "ElementRemoval", "NodeRemoval"],
        usage: collapse::USAGE,
        text: Text::new(
            "Removes the elements of an infill wall whose drifts in and out of its plane reach a curve, and nodes that \
             are left alone.",
        )
        .example("recorder Collapse -ele 1 -node 2"),
        make: collapse::collapse,
    },
    Kind {
        names: &["PVD", "pvd"],
        usage: pvd::USAGE,
        text: Text::new(
            "Writes the model with fields of nodes and elements for ParaView: a list `$file.pvd`, and a file of each \
             step in the folder `$file`.",
        ),
        make: pvd::pvd,
    },
    Kind::named(
        &["mpco", "vtk", "VTK", "vtkhdf", "VTKHDF", "gmsh", "GMSH"],
        "recorder mpco ...: files for other programs, not written",
        display::of_other_program,
    ),
    // Windows of OpenSees.
    Kind::named(&["display", "plot", "plotDifferent", "increments"], "recorder display ...", |_, _, _| {
        Ok(Value::from(-1i64))
    }),
];

/// The options that all recorders share.
#[derive(Default)]
struct Common {
    file: Option<(String, Option<Span>)>,
    style: Option<Style>,
    layout: Option<Layout>,
    close_on_write: bool,
    cadence: Cadence,
    /// Places of the tags of nodes and elements and of the degrees of freedom, for messages.
    tags: BTreeMap<Absent, Span>,
    /// None of the elements that are there has the response, which has been said.
    knows_missing_response: bool,
}

const COMMON: &[&str] =
    &["-file", "-csv", "-xml", "-binary", "-time", "-dT", "-rTolDt", "-closeOnWrite", "-precision", "-scientific"];

impl Common {
    fn new(interp: &Tcl) -> Self {
        Self {
            style: Some(interp.host.output.style),
            cadence: Cadence { tolerance: 1e-5, ..Cadence::default() },
            ..Self::default()
        }
    }

    /// Take an option that all recorders share; `false` if it is none.
    fn take(&mut self, option: &str, a: &mut Args<'_>) -> Result<bool, Exception> {
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
            "-dT" | "-dt" => self.cadence.dt = a.not_negative("step of time dT")?,
            "-rTolDt" => self.cadence.tolerance = a.not_negative("tolerance rTolDt")?,
            "-closeOnWrite" => self.close_on_write = true,
            "-precision" => style.precision = a.count("number of digits")?,
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
    fn take_tags(&mut self, what: &'static str, a: &mut Args<'_>) -> Vec<Tag> {
        let placed = a.tags(what);
        for (tag, span) in &placed {
            self.tags.extend(span.map(|s| (Absent::new(what, tag), s)));
        }
        placed.into_iter().map(|(tag, _)| tag).collect()
    }

    /// Degrees of freedom or columns, counted from 0.
    fn take_dofs(&mut self, a: &mut Args<'_>) -> Result<Vec<usize>, Exception> {
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
    fn finish(self, interp: &mut Tcl, call: &Call<'_>, source: Box<dyn Source>, keep: Keep) -> Outcome {
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

fn recorder(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, "recorder $kind -file $file ...");
    let kind = kind::take(&mut a, "kind of recorder", "recorder", KINDS.iter())?;
    (kind.make)(interp, call, a)
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

fn node(interp: &mut Tcl, call: &Call<'_>, mut a: Args<'_>, keep: Keep) -> Outcome {
    let mut common = Common::new(interp);
    let (mut nodes, mut columns, mut series): (Option<Vec<Tag>>, _, Vec<Option<Series>>) = (None, vec![], vec![]);
    let mut response: Option<(String, Option<Span>)> = None;
    while let Some(option) = a.option() {
        if common.take(&option, &mut a)? {
            continue;
        }
        match option.as_ref() {
            "-node" | "-nodes" => {
                if a.flag("all") {
                    continue;
                }
                nodes.get_or_insert_default().extend(common.take_tags("node", &mut a));
            }
            "-nodeRange" => {
                let there: Vec<Tag> = interp.host.engine.model().node_tags().collect();
                nodes.get_or_insert_default().extend(range(interp, &mut a, "node", there)?);
            }
            "-region" => nodes.get_or_insert_default().extend(region(interp, &mut a, true)?),
            "-dof" | "-dofs" => columns = common.take_dofs(&mut a)?,
            "-timeSeries" => {
                while a.at_number() {
                    let zero = a.peek().is_some_and(|w| matches!(w.as_ref(), "0" | "-1"));
                    series.push(if zero {
                        a.option();
                        None
                    } else {
                        Some(a.of(&interp.host.builder.definitions.series)?.0)
                    });
                }
            }
            word if word.starts_with('-') => {
                let known = [COMMON, &["-node", "-nodeRange", "-region", "-dof", "-timeSeries"]].concat();
                ignore_option(interp, &mut a, &known)?;
            }
            word => {
                // `eigen 1` may come as one word or as two.
                let mut name = word.to_owned();
                if word == "eigen" && a.at_number() {
                    name = format!("eigen {}", a.int("number of the mode")?);
                }
                response = Some((name, a.last_span()));
            }
        }
    }
    let quantity = match &response {
        None if interp.host.follows(&[slips::MISSING_RESPONSE]) => {
            let d = Diagnostic::warning(
                &checks::words::MISSING_WORD,
                "recorder: the response is missing: OpenSees takes disp",
            );
            warn(interp, d.at(call.span(0), "expected for instance disp"))?;
            NodeQuantity::Disp
        }
        None => {
            return Err(a.refuse_at(call.span(0), "recorder: the response is missing", "expected for instance disp"));
        }
        Some((name, span)) => NodeQuantity::parse(name).ok_or_else(|| {
            let d = Diagnostic::error(format!("unknown response of a node \"{name}\""));
            let d =
                d.at(*span, "expected a response").suggest(name, nearest(name, NodeQuantity::NAMES.iter().copied()));
            let d = d.help(format!("known: {}", NodeQuantity::NAMES.join(", ")));
            Exception::diagnosed(d.by(&checks::words::UNKNOWN_KIND))
        })?,
    };
    let source = NodeResponse::new(quantity, nodes, columns, series);
    common.finish(interp, call, Box::new(source), keep)
}

fn element(interp: &mut Tcl, call: &Call<'_>, mut a: Args<'_>, keep: Keep) -> Outcome {
    let mut common = Common::new(interp);
    let (mut elements, mut columns, mut words): (Option<Vec<Tag>>, _, Vec<String>) = (None, vec![], vec![]);
    let mut places = vec![];
    while let Some(option) = a.option() {
        if common.take(&option, &mut a)? {
            continue;
        }
        match option.as_ref() {
            "-ele" | "-eles" | "-element" => {
                if a.flag("all") {
                    continue;
                }
                elements.get_or_insert_default().extend(common.take_tags("element", &mut a));
            }
            "-eleRange" => {
                let there: Vec<Tag> = interp.host.engine.model().element_tags().collect();
                elements.get_or_insert_default().extend(range(interp, &mut a, "element", there)?);
            }
            "-region" => elements.get_or_insert_default().extend(region(interp, &mut a, false)?),
            "-dof" | "-dofs" => columns = common.take_dofs(&mut a)?,
            word => {
                // The first word that is no option begins the response, which takes all that follows.
                words.push(word.to_owned());
                places.push(a.last_span());
                while let Some(w) = a.option() {
                    words.push(w.into_owned());
                    places.push(a.last_span());
                }
            }
        }
    }
    if words.is_empty() {
        return Err(a.refuse_at(call.span(0), "recorder: the response is missing", "expected for instance force"));
    }
    common.knows_missing_response = check_response(interp, elements.as_deref(), &words, &places)?;
    let source = ElementResponse::new(elements, words, columns);
    common.finish(interp, call, Box::new(source), keep)
}

/// Warn where none of the elements that are there has the response. Returns true if so.
fn check_response(
    interp: &mut Tcl,
    elements: Option<&[Tag]>,
    words: &[String],
    places: &[Option<Span>],
) -> Result<bool, Exception> {
    let engine = &interp.host.engine;
    let model = engine.model();
    let tags: Vec<Tag> = elements.map_or_else(|| model.element_tags().collect(), <[Tag]>::to_vec);
    let ids: Vec<_> = tags.iter().filter_map(|t| model.element(*t)).collect();
    let list: Vec<&str> = words.iter().map(String::as_str).collect();
    let Some(first) = ids.first() else { return Ok(false) };
    if ids.iter().any(|id| ElementResponse::is_known(engine, *id, &list)) {
        return Ok(false);
    }
    let (index, mut d) = unknown_response(engine, *first, &list);
    d.severity = Severity::Warning;
    d.check = Some(&checks::output::NOT_IN_MODEL);
    warn(interp, d.at(places.get(index).copied().flatten(), "nothing is recorded"))?;
    Ok(true)
}

/// The message about a response that an element does not have, and the index of the word that is wrong.
pub(super) fn unknown_response(engine: &Engine, id: ElementId, words: &[&str]) -> (usize, Diagnostic) {
    let class = engine.model().elements[id.0].element.class();
    let Misspelled { index, known, fitting } = ElementResponse::misspelled(engine, id, words);
    let word = words.get(index).copied().unwrap_or_default();
    let near = nearest(word, fitting.iter().copied().filter(|name| *name != word));
    let d = Diagnostic::error(format!("{class} has no response \"{}\"", words.join(" "))).suggest(word, near);
    let after = if index > 0 { format!(" after \"{}\"", words[..index].join(" ")) } else { String::new() };
    (index, d.help(format!("known{after}: {}", known.join(", "))))
}

fn drift(interp: &mut Tcl, call: &Call<'_>, mut a: Args<'_>, keep: Keep) -> Outcome {
    let mut common = Common::new(interp);
    let (mut i, mut j, mut dof, mut across) = (vec![], vec![], None, None);
    while let Some(option) = a.option() {
        if common.take(&option, &mut a)? {
            continue;
        }
        match option.as_ref() {
            "-iNode" | "-iNodes" => i = common.take_tags("node", &mut a),
            "-jNode" | "-jNodes" => j = common.take_tags("node", &mut a),
            "-dof" => dof = Some(a.dof("degree of freedom", 6)?),
            "-perpDirn" | "-perpDirection" => across = Some(a.dof("perpendicular direction", 3)?),
            _ => {
                let known = [COMMON, &["-iNode", "-jNode", "-dof", "-perpDirn"]].concat();
                ignore_option(interp, &mut a, &known)?;
            }
        }
    }
    if dof.is_none() || across.is_none() {
        let message = "recorder Drift: the direction is missing: OpenSees takes dof 1 and perpDirn 2";
        warn(
            interp,
            Diagnostic::warning(&checks::words::MISSING_WORD, message).at(call.span(0), "expected -dof and -perpDirn"),
        )?;
    }
    if i.is_empty() || i.len() != j.len() {
        let message = format!("recorder Drift: {} nodes i but {} nodes j", i.len(), j.len());
        return Err(a.refuse_at(call.span(0), message, "expected as many after -iNode as after -jNode"));
    }
    let source = Drift::new(i.into_iter().zip(j).collect(), dof.unwrap_or(0), across.unwrap_or(1));
    common.finish(interp, call, Box::new(source), keep)
}

fn record(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let session = &mut interp.host;
    session.output.recorders.live.mark();
    let done = session.output.recorders.record(&mut session.engine);
    done.map_err(|e| call.error_at(0, e.to_string(), ""))?;
    Ok(Value::EMPTY)
}

fn set_precision(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, "setPrecision $digits");
    interp.host.output.style.precision = a.count("number of digits")?;
    Ok(Value::EMPTY)
}
