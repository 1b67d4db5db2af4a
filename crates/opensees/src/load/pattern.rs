//! Load patterns and their loads.

use super::ground_motion;
use super::late_support::move_late_supports;
use crate::args::Args;
use crate::checks;
use crate::host::Mode;
use crate::load::series::{names_kind, series_of};
use crate::model::nodes::{DOF, NODE, need_model, node_of};
use crate::slips;
use crate::text::{Arg, Domain, Text};
use crate::things;
use crate::{Command, Outcome, Tcl, finish, ignore_unknown, kind, warn};
use hysteron_engine::element::ElementLoad;
use hysteron_engine::model::{
    ElementId, Excitation, NodalLoad, Pattern, PatternKind, SupportMotion, Tag, acceleration_of,
};
use hysteron_engine::series::Constant;
use hysteron_tcl::diagnostic::{Absent, Diagnostic};
use hysteron_tcl::{Call, Exception, Value};
use std::sync::Arc;

const FACTOR: Arg = Arg::of("-fact", "factor", "factor on all loads").within(Domain::Number);

const FORCE: Arg = Arg::number("f1", "force on degree of freedom");
const TAG: Arg = Arg::whole("tag", "tag of the pattern");
const DIRECTION: Arg = Arg::whole("direction", "direction");
const VEL0_V: Arg = Arg::of("-vel0", "v", "initial velocity").within(Domain::Number);
const PATTERN_TAG: Arg = Arg::of("-pattern", "tag", "tag of the pattern").within(Domain::Whole);
const VALUE: Arg = Arg::number("value", "value");
const BEAM_UNIFORM_MOMENT_MZ: Arg = Arg::of("-beamUniformMoment", "mz", "moment per length mx").within(Domain::Number);
const TIME: Arg = Arg::of("-time", "time", "time").within(Domain::Number);
const SET_TIME_TIME: Arg = Arg::number("time", "time");

pub(crate) const COMMANDS: &[Command] = &[
    Command::new("pattern", PLAIN, pattern)
        .about("Makes a pattern of loads that follow a time series, or an excitation.")
        .arguments(&[TAG, FACTOR])
        .defining(&[things::PATTERN], 2)
        .with_kinds(|| kind::usages(KINDS)),
    Command::new("load", LOAD, load).arguments(&[NODE, FORCE, PATTERN_TAG]).about("Adds a nodal load to a pattern."),
    Command::new("sp", SP, sp)
        .arguments(&[NODE, DOF, VALUE, PATTERN_TAG])
        .about("Imposes the displacement of a degree of freedom, in a pattern."),
    Command::new("eleLoad", ELE_LOAD, ele_load).about("Adds loads on beams to a pattern.").arguments(&[
        BEAM_UNIFORM_MOMENT_MZ,
        Arg::flag("-type", "before the kind of load, may be left out"),
        Arg::flag(
            "-beamUniform",
            "in the plane $w_y$ <$w_x$>, in space $w_y$ $w_z$ <$w_x$>: forces per length in \
             local axes",
        ),
        Arg::flag(
            "-beamPoint",
            "in the plane $P_y$ $x/L$ <$P_x$>, in space $P_y$ $P_z$ $x/L$ <$P_x$>: force in local \
             axes and its place over the length",
        ),
        Arg::of("-range", "first", "first and last tag of elements").within(Domain::Whole),
        PATTERN_TAG,
        Arg::of("-ele", "tag", "tags of elements").within(Domain::Whole),
    ]),
    Command::new("loadConst", LOAD_CONST, load_const)
        .arguments(&[TIME])
        .about("Keeps the loads of all patterns at their present level."),
    Command::new("setTime", SET_TIME, set_time).arguments(&[SET_TIME_TIME]).about("Sets the clock of the domain."),
];

const PLAIN: &str = "pattern Plain $tag $series <-fact $factor> { load ... sp ... eleLoad ... }";
const LOAD: &str = "load $node $f1 <$f2 ...> <-const> <-pattern $tag>";
const SP: &str = "sp $node $dof $value <-const> <-subtractInit> <-pattern $tag>";
const ELE_LOAD: &str = "eleLoad -ele $tag ... | -range $first $last -type -beamUniform ... | -beamUniformMoment $mz | \
                        -beamPoint ... <-pattern $tag>";
const LOAD_CONST: &str = "loadConst <-time $time>";
const SET_TIME: &str = "setTime $time";

/// A kind of load pattern, added to the model by the words after its tag.
type Kind = kind::Kind<fn(&mut Tcl, Tag, Args<'_>) -> Outcome>;

const KINDS: &[Kind] = &[
    Kind {
        names: &["Plain", "LoadPattern"],
        usage: PLAIN,
        text: Text::new("Nodal loads, imposed displacements and loads on elements.")
            .arguments(&[Arg::new("series", "time series")]),
        make: plain,
    },
    Kind {
        names: &["UniformExcitation", "UniformSupport", "EarthquakePattern"],
        usage: "pattern UniformExcitation $tag $direction <-accel $series> <-vel $series> <-disp $series> <-vel0 $v> <-fact $factor>",
        text: Text::new("One ground acceleration for all supports.").arguments(&[
            DIRECTION,
            Arg::of("-accel", "series", "time series"),
            Arg::of("-vel", "series", "time series"),
            Arg::of("-disp", "series", "time series"),
            VEL0_V,
        ]),
        make: uniform,
    },
    Kind {
        names: &["MultipleSupport", "MultiSupport"],
        usage: "pattern MultipleSupport $tag { groundMotion ... imposedMotion ... }",
        text: Text::new("Ground motions of single supports."),
        make: ground_motion::multiple_support,
    },
];

fn pattern(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    need_model(interp, call)?;
    let mut a = Args::new(call, PLAIN);
    let kind = kind::take(&mut a, "kind of pattern", "load pattern", KINDS.iter())?;
    interp.host.note_kind("pattern", kind.names[0]);
    let tag = new_tag(interp, &mut a)?;
    (kind.make)(interp, tag, a)
}

fn new_tag(interp: &Tcl, a: &mut Args<'_>) -> Result<Tag, Exception> {
    let tag = a.int(PATTERN_TAG.meaning)?;
    if interp.host.engine.model().patterns.contains_key(&tag) {
        return Err(a.exists(things::PATTERN, tag));
    }
    Ok(tag)
}

fn plain(interp: &mut Tcl, tag: Tag, mut a: Args<'_>) -> Outcome {
    need_series(&a)?;
    let series = series_of(interp, &mut a)?;
    let mut factor = 1.0;
    while a.at_option() {
        a.option();
        match a.last_word().as_ref() {
            "-fact" | "-factor" => factor = a.number(&FACTOR)?,
            _ => ignore_unknown(interp, &mut a)?,
        }
    }
    let pattern = Pattern::new(PatternKind::Plain { series, factor });
    interp.host.engine.change_model(|m| m.patterns.insert(tag, pattern));
    interp.host.builder.pattern = Some(tag);
    if a.left() > 0 {
        let mut body = a.value("loads")?;
        // As in OpenSees the last word holds the loads. A comment after them is none.
        if a.left() > 0 && !a.peek().is_some_and(|w| w.starts_with('#')) {
            let message = "pattern: the last word holds the loads, and what is before it is ignored";
            warn(interp, Diagnostic::warning(&checks::load::LAST_WORD_COUNTS, message).at(a.last_span(), "not read"))?;
            while a.left() > 0 {
                body = a.value("loads")?;
            }
        }
        finish(interp, &a)?;
        a.refuse_body(interp, "load")?;
        let before = interp.host.builder.pattern.replace(tag);
        let done = interp.eval_value(&body);
        interp.host.builder.pattern = before;
        done?;
    }
    Ok(Value::EMPTY)
}

/// Refuse a pattern whose only word is its loads: no tag, no kind of series, and more than one word or none.
fn need_series(a: &Args<'_>) -> Result<(), Exception> {
    let mut ahead = a.ahead();
    let (Some(word), None) = (ahead.next(), ahead.next()) else { return Ok(()) };
    let is_body = word.to_list().map_or(true, |list| list.len() != 1);
    if a.at_number() || names_kind(word) || !is_body {
        return Ok(());
    }
    let label = "expected the tag of a time series before the loads";
    Err(a.refuse_at(a.next_span(), "pattern: the time series is missing", label))
}

fn uniform(interp: &mut Tcl, tag: Tag, mut a: Args<'_>) -> Outcome {
    let limit = [1, 3, 6][interp.host.builder.ndm - 1];
    let direction = a.dof(DIRECTION.meaning, limit)?;
    let mut excitation =
        Excitation { direction, accel: Arc::new(Constant { factor: 0.0 }), influence: 1.0, initial_velocity: 0.0 };
    let mut motion = [None, None, None];
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-accel" | "-acceleration" => motion[0] = Some(series_of(interp, &mut a)?),
            "-vel" | "-velocity" => motion[1] = Some(series_of(interp, &mut a)?),
            "-disp" | "-displacement" => motion[2] = Some(series_of(interp, &mut a)?),
            "-vel0" | "-initialVel" => excitation.initial_velocity = a.number(&VEL0_V)?,
            "-fact" | "-factor" => excitation.influence = a.number(&FACTOR)?,
            _ => ignore_unknown(interp, &mut a)?,
        }
    }
    let [accel, vel, disp] = motion;
    let follows = accel.is_none() && interp.host.follows(&[slips::UNIFORM_RATES]);
    let given = accel.or_else(|| acceleration_of(vel.as_ref(), disp.as_ref()));
    let Some(accel) = given else {
        return Err(
            a.refuse("the uniform excitation has no motion", "expected -accel, -vel or -disp and a time series")
        );
    };
    if !follows {
        excitation.accel = accel;
    }
    let start = excitation.initial_velocity;
    let pattern = Pattern::new(PatternKind::Uniform(excitation));
    interp.host.engine.change_model(|m| m.patterns.insert(tag, pattern));
    move_late_supports(interp, &a, tag)?;
    if start != 0.0 {
        interp.host.engine.change_state(|state, model| {
            // Supports stay at rest.
            let fixed = |i: usize| model.fixes.iter().any(|f| f.node.0 == i && f.dof == direction);
            for (_, node) in model.nodes.iter().enumerate().filter(|(i, n)| direction < n.ndf && !fixed(*i)) {
                state.vel[node.offset + direction] = start;
            }
        });
    }
    Ok(Value::EMPTY)
}

/// The pattern that a load goes into: the one whose body is being read, or the one named by `-pattern`.
fn current(interp: &Tcl, a: &Args<'_>, named: Option<Tag>) -> Result<Tag, Exception> {
    match named.or(interp.host.builder.pattern) {
        Some(tag) if interp.host.engine.model().patterns.contains_key(&tag) => Ok(tag),
        Some(tag) => Err(a.absent(things::PATTERN, tag, "expected the tag of a pattern")),
        None => {
            let e = a.refuse_at(None, "there is no load pattern to put this in", "expected inside a pattern");
            Err(e.absent(Absent::new(things::PATTERN, "")))
        }
    }
}

fn change_pattern(interp: &mut Tcl, tag: Tag, change: impl FnOnce(&mut Pattern)) {
    interp.host.engine.change_model(|m| {
        if let Some(p) = m.patterns.get_mut(&tag) {
            change(p);
        }
    });
}

fn load(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, LOAD);
    let node = node_of(interp, &mut a, NODE.meaning)?;
    let ndf = interp.host.engine.model().nodes[node.0].ndf;
    let values = (1..=ndf).map(|i| a.nth_number(&FORCE, i));
    let values = values.collect::<Result<Vec<f64>, _>>()?;
    let (mut constant, mut named) = (false, None);
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-const" => constant = true,
            "-pattern" => named = Some(a.tag(things::PATTERN, PATTERN_TAG.meaning)?),
            _ => ignore_unknown(interp, &mut a)?,
        }
    }
    let tag = current(interp, &a, named)?;
    change_pattern(interp, tag, |p| p.nodal_loads.push(NodalLoad { node, values, constant }));
    Ok(Value::EMPTY)
}

fn sp(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, SP);
    let node = node_of(interp, &mut a, NODE.meaning)?;
    let (ndf, offset) = {
        let n = &interp.host.engine.model().nodes[node.0];
        (n.ndf, n.offset)
    };
    let dof = a.dof(DOF.meaning, ndf)?;
    let span = a.last_span();
    let value = a.number(&VALUE)?;
    let (mut constant, mut named, mut initial) = (false, None, 0.0);
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-const" => constant = true,
            "-subtractInit" => initial = interp.host.engine.state().disp[offset + dof],
            "-pattern" => named = Some(a.tag(things::PATTERN, PATTERN_TAG.meaning)?),
            _ => ignore_unknown(interp, &mut a)?,
        }
    }
    let pattern = current(interp, &a, named)?;
    let model = interp.host.engine.model();
    let fixed = model.fixes.iter().any(|f| f.node == node && f.dof == dof);
    let taken = model.patterns.values().any(|p| p.motions.iter().any(|m| m.node == node && m.dof == dof));
    if fixed || taken {
        let by = if fixed { "by a \"fix\"" } else { "by another \"sp\"" };
        let message = format!("degree of freedom {} of the node is held already {by}", dof + 1);
        let d = Diagnostic::warning(&checks::model::HELD_TWICE, message)
            .at(span, "which of the two holds is not defined in OpenSees");
        warn(interp, d.help("here the imposed motion of the pattern with the highest tag holds"))?;
    }
    let tag = interp.host.sp_tag();
    change_pattern(interp, pattern, |p| {
        p.motions.push(SupportMotion { node, dof, value, constant, initial, tag, ground: None });
    });
    Ok(Value::EMPTY)
}

fn ele_load(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, ELE_LOAD);
    let mut elements: Vec<(ElementId, Option<hysteron_tcl::diagnostic::Span>)> = vec![];
    let (mut given, mut named) = (None, None);
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-ele" => {
                while elements.is_empty() || a.at_number() {
                    let tag = a.tag(things::ELEMENT, "tag of an element")?;
                    let id = interp.host.engine.model().element(tag);
                    let missing = || a.absent(things::ELEMENT, tag, "expected the tag of an element");
                    elements.push((id.ok_or_else(missing)?, a.last_span()));
                }
            }
            "-range" => {
                let (first, last) = (a.int("first tag")?, a.int("last tag")?);
                let model = interp.host.engine.model();
                let within = model.element_tags().filter(|t| (first..=last).contains(t));
                elements.extend(within.filter_map(|t| model.element(t)).map(|id| (id, a.last_span())));
            }
            "-type" => {}
            "-beamUniform" | "beamUniform" => given = Some(beam_uniform(&mut a, interp.host.builder.ndm)?),
            "-beamUniformMoment" | "beamUniformMoment" => given = Some(beam_moment(&mut a, interp.host.builder.ndm)?),
            "-beamPoint" | "beamPoint" => given = Some(beam_point(&mut a, interp.host.builder.ndm)?),
            "-pattern" => named = Some(a.tag(things::PATTERN, PATTERN_TAG.meaning)?),
            _ if given.is_none() => {
                return Err(a.unknown_name(
                    "element load",
                    ["-ele", "-range", "-type", "-beamUniform", "-beamUniformMoment", "-beamPoint"],
                ));
            }
            _ => ignore_unknown(interp, &mut a)?,
        }
    }
    let Some(load) = given else {
        return Err(a.refuse_at(
            call.span(0),
            "eleLoad: there is no load",
            "expected -type -beamUniform or -beamPoint",
        ));
    };
    if elements.is_empty() {
        return Err(a.refuse_at(call.span(0), "eleLoad: there are no elements", "expected -ele or -range"));
    }
    let pattern = current(interp, &a, named)?;
    for (id, span) in elements {
        let e = &interp.host.engine.model().elements[id.0].element;
        // What the element says to the load is found out now, where the script can be pointed at.
        e.add_load(&load, 0.0, &mut vec![0.0; e.load_len()]).map_err(|err| a.refuse_at(span, err.0, ""))?;
        change_pattern(interp, pattern, |p| p.element_loads.push((id, load)));
    }
    Ok(Value::EMPTY)
}

fn beam_uniform(a: &mut Args<'_>, ndm: usize) -> Result<ElementLoad, Exception> {
    let y = a.float("load Wy")?;
    let z = if ndm == 3 { a.float("load Wz")? } else { 0.0 };
    let x = a.optional_float("load Wx")?.unwrap_or(0.0);
    let Some(from) = a.optional_float("start of the load as a fraction of the length")? else {
        return Ok(ElementLoad::Distributed { span: (0.0, 1.0), y: (y, y), z: (z, z), x: (x, x) });
    };
    let to = a.optional_float("end of the load as a fraction of the length")?.unwrap_or(1.0);
    if !(0.0..=1.0).contains(&from) || !(from..=1.0).contains(&to) {
        return Err(a.refuse(format!("the load goes from {from} to {to}"), "expected fractions, 0 to 1, that rise"));
    }
    let y2 = a.optional_float("load Wy at the end")?.unwrap_or(y);
    let z2 = if ndm == 3 { a.optional_float("load Wz at the end")?.unwrap_or(z) } else { 0.0 };
    let x2 = a.optional_float("load Wx at the end")?.unwrap_or(x);
    Ok(ElementLoad::Distributed { span: (from, to), y: (y, y2), z: (z, z2), x: (x, x2) })
}

/// A moment about z all along a beam; in space one about each axis, which no element takes.
fn beam_moment(a: &mut Args<'_>, ndm: usize) -> Result<ElementLoad, Exception> {
    if ndm == 3 {
        a.number(&BEAM_UNIFORM_MOMENT_MZ)?;
        a.float("moment per length my")?;
    }
    Ok(ElementLoad::Moment { z: a.float("moment per length mz")? })
}

fn beam_point(a: &mut Args<'_>, ndm: usize) -> Result<ElementLoad, Exception> {
    let y = a.float("force Py")?;
    let z = if ndm == 3 { a.float("force Pz")? } else { 0.0 };
    let at = a.float("place as a fraction of the length")?;
    if !(0.0..=1.0).contains(&at) {
        return Err(a.refuse(format!("the place of the force is {at}"), "expected a fraction of the length, 0 to 1"));
    }
    let x = a.optional_float("force Px")?.unwrap_or(0.0);
    Ok(ElementLoad::Point { at, y, z, x })
}

fn load_const(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, LOAD_CONST);
    let mut time = None;
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-time" => time = Some(a.number(&SET_TIME_TIME)?),
            _ => ignore_unknown(interp, &mut a)?,
        }
    }
    // Loads stay as an analysis has applied them, whatever the time has been set to since.
    let applied = interp.host.builder.loads_time.take();
    let session = &mut interp.host;
    let (engine, overview, mode) = (&mut session.engine, &mut session.overview, &mut session.mode);
    if *mode == Mode::Check {
        overview.keep_statics(engine);
    }
    let now = applied.unwrap_or(engine.state().time);
    engine.change_model(|m| m.patterns.values_mut().for_each(|p| p.hold(now)));
    if let Some(t) = time {
        engine.set_time(t);
    }
    Ok(Value::EMPTY)
}

fn set_time(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, SET_TIME);
    let time = a.number(&SET_TIME_TIME)?;
    finish(interp, &a)?;
    let session = &mut interp.host;
    session.builder.loads_time.get_or_insert(session.engine.state().time);
    session.engine.set_time(time);
    Ok(Value::EMPTY)
}
