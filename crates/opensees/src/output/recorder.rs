//! `recorder` and `record`.

use super::recorder_options::{Common, Keep, PRECISION, SCIENTIFIC, TIME_STEP, TIME_TOLERANCE, range, region};
use super::{collapse, display, pvd};
use crate::args::Args;
use crate::checks;
use crate::effect::Effect;
use crate::text::{Arg, Domain, Text};
use crate::{Command, Outcome, Tcl, ignore_unknown, kind, slips, warn};
use hysteron_engine::analysis::Engine;
use hysteron_engine::model::{ElementId, Tag};
use hysteron_engine::record::{Drift, ElementResponse, Misspelled, NodeQuantity, NodeResponse, Recorder};
use hysteron_engine::series::Series;
use hysteron_tcl::diagnostic::{Diagnostic, Severity, Span, nearest};
use hysteron_tcl::{Call, Exception, Value};

const PERP_DIRN_DIRECTION: Arg = Arg::of("-perpDirn", "direction", "perpendicular direction").within(Domain::Whole);
const DOF: Arg = Arg::of("-dof", "dof", "degree of freedom").within(Domain::Whole);
const DIGITS: Arg = Arg::count("digits", "number of digits");

pub(crate) const COMMANDS: &[Command] = &[
    Command::new("recorder", "recorder $kind -file $file ...", recorder)
        .about("Records responses in a file.")
        .arguments(&[
            TIME_STEP,
            TIME_TOLERANCE,
            SCIENTIFIC,
            Arg::of("-file", "file", "name of the file"),
            Arg::flag("-file", "text, columns separated by blanks"),
            Arg::flag("-csv", "text, columns separated by commas"),
            Arg::flag("-xml", "XML"),
            Arg::of("-binary", "file", "numbers of eight bytes"),
            Arg::of("-region", "tag", "tag of a region").within(Domain::Whole),
            Arg::of("-dof", "column", "columns of the response, from 1"),
            Arg::of("-timeSeries", "tag", "tags of series whose values are added"),
            Arg::of("-node", "tag", "tags of nodes"),
            Arg::of("-nodeRange", "first", "first and last tag of nodes").within(Domain::Whole),
            Arg::of("-ele", "tag", "tags of elements"),
            Arg::of("-eleRange", "first", "first and last tag of elements").within(Domain::Whole),
            Arg::of("-iNode", "tag", "tags of the lower nodes"),
            Arg::of("-jNode", "tag", "tags of the upper nodes"),
        ])
        .with_kinds(|| kind::usages(KINDS))
        .leaving(Effect::Nothing),
    Command::new("record", "record", record).about("Makes all recorders write a row now.").leaving(Effect::Nothing),
    Command::new("setPrecision", "setPrecision $digits", set_precision)
        .arguments(&[DIGITS])
        .about("Sets the digits of recorders that are made afterwards."),
];

/// A kind of recorder, added to the session by the words after its name.
type Kind = kind::Kind<fn(&mut Tcl, &Call<'_>, Args<'_>) -> Outcome>;

const KINDS: &[Kind] = &[
    Kind {
        names: &["Node"],
        usage: "recorder Node -file|-csv|-xml|-binary $file <-time> <-precision $n> <-scientific> <-dT $dt> \
                <-rTolDt $tolerance> <-closeOnWrite> \
                <-timeSeries $tag ...> -node $tag ... | -nodeRange $first $last | -region $tag -dof $dof ... $response",
        text: Text::new("Records responses of nodes.").arguments(&[PRECISION, Arg::of(
            "-dof",
            "dof",
            "degrees of freedom, then the response: disp, vel, accel, incrDisp, reaction, unbalance, \
             sensitivity P, velSensitivity P, accSensitivity P (derivatives with respect to parameter P), eigen N, eigen (a \
             row of each mode) ...",
        )]),
        make: |interp, call, a| node(interp, call, a, Recorder::history),
    },
    Kind {
        names: &["EnvelopeNode"],
        usage: "recorder EnvelopeNode -file $file <-time> -node $tag ... | -nodeRange $first $last | -region $tag \
                -dof $dof ... $response",
        text: Text::new("Records minimum, maximum and absolute maximum of responses of nodes.").arguments(&[Arg::of(
            "-dof",
            "dof",
            "degrees of freedom, then the response",
        )]),
        make: |interp, call, a| node(interp, call, a, Recorder::envelope),
    },
    Kind {
        names: &["NodeRMS"],
        usage: "recorder NodeRMS -file $file <-dT $dt> -node $tag ... | -nodeRange $first $last | -region $tag \
                -dof $dof ... $response",
        text: Text::new("Records the root mean squares of responses of nodes over the steps.").arguments(&[Arg::of(
            "-dof",
            "dof",
            "degrees of freedom, then the response",
        )]),
        make: |interp, call, a| node(interp, call, a, Recorder::root_mean_square),
    },
    Kind {
        names: &["Element"],
        usage: "recorder Element -file|-csv|-xml|-binary $file <-time> <-precision $n> <-scientific> <-dT $dt> \
                <-rTolDt $tolerance> <-closeOnWrite> \
                -ele $tag ... | -eleRange $first $last | -region $tag <-dof $column ...> $response ...",
        text: Text::new("Records responses of elements.").arguments(&[PRECISION]),
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
        text: Text::new("Records drifts between pairs of nodes.").arguments(&[
Arg::of(
            "-dof",
            "dof",
            "degree of freedom of the drift",
        ).within(Domain::Whole),
PERP_DIRN_DIRECTION,
]),
        make: |interp, call, a| drift(interp, call, a, Recorder::history),
    },
    Kind {
        names: &["EnvelopeDrift"],
        usage: "recorder EnvelopeDrift -file $file <-time> -iNode $tag ... -jNode $tag ... -dof $dof \
                -perpDirn $direction",
        text: Text::new("Writes minimum, maximum and largest absolute value of drifts between nodes.")
            .arguments(&[DOF, PERP_DIRN_DIRECTION]),
        make: |interp, call, a| drift(interp, call, a, Recorder::envelope),
    },
    Kind {
        names: &["Collapse", "Remove", "ElementRemoval", "NodeRemoval"],
        usage: collapse::USAGE,
        text: Text::new(
            "Removes the elements of an infill wall whose drifts in and out of its plane reach a curve, and nodes that \
             are left alone.",
        )
        .example("recorder Collapse -ele 1 -node 2")
        .arguments(&[
            Arg::flag(
                "-crit",
                "drift in the plane of a wall against a limit that depends on the drift out of it; \
                 other criteria have no value, as in OpenSees 3",
            ),
            Arg::of("-file_infill", "curve", "file with pairs of drifts: out of the plane, rising, and in it"),
            Arg::of("-checknodes", "bottom", "nodes at the lower end, in the middle and at the upper end of the wall"),
            Arg::of("-global_gravaxis", "axis", "number of the vertical axis"),
            Arg::flag("-secondary", "the elements that follow are removed with the last of the others"),
            Arg::of("-mass", "m", "mass of each element, half of which is taken off each of its nodes"),
            Arg::of(
                "-g",
                "acceleration",
                "weight per mass, direction and load pattern of the loads that take it off the nodes",
            ),
            Arg::of("-node", "node", "node that is removed once all of the elements are").within(Domain::Whole),
            Arg::of("-file", "file", "file with a line for each removal: time, Elem or Node, tag"),
            TIME_STEP,
        ]),
        make: collapse::collapse,
    },
    Kind {
        names: &["PVD", "pvd"],
        usage: pvd::USAGE,
        text: Text::new(
            "Writes the model with fields of nodes and elements for ParaView: a list `$file.pvd`, and a file of each \
             step in the folder `$file`.",
        )
        .arguments(&[
            pvd::FILE,
            pvd::TOLERANCE,
            pvd::MODES,
            super::pvd::DIGITS,
            Arg::new("response", "words of a response of elements; those that follow belong to it"),
        ]),
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

fn recorder(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, "recorder $kind -file $file ...");
    let kind = kind::take(&mut a, "kind of recorder", "recorder", KINDS.iter())?;
    (kind.make)(interp, call, a)
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
                ignore_unknown(interp, &mut a)?;
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
    let class = engine.model().elements[id.0].element.class().name;
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
            "-dof" => dof = Some(a.dof(DOF.meaning, 6)?),
            "-perpDirn" | "-perpDirection" => across = Some(a.dof(PERP_DIRN_DIRECTION.meaning, 3)?),
            _ => {
                ignore_unknown(interp, &mut a)?;
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
    interp.host.output.style.precision = a.count(&DIGITS)?;
    Ok(Value::EMPTY)
}
