//! The model and its nodes.

use crate::args::Args;
use crate::checks;
use crate::effect::Effect;
use crate::text::{Arg, Domain};
use crate::things;
use crate::{Command, Outcome, Tcl, finish, ignore_unknown, warn};
use hysteron_engine::model::NodeId;
use hysteron_tcl::diagnostic::{Absent, Diagnostic, Span};
use hysteron_tcl::{Call, Exception, Value};

const NODE_DISP: Arg = Arg::of("-disp", "u", "displacement of degree of freedom").within(Domain::Number);
const NODE_VEL: Arg = Arg::of("-vel", "v", "velocity of degree of freedom").within(Domain::Number);
const NODE_MASS: Arg = Arg::of("-mass", "m", "mass of degree of freedom").within(Domain::NotNegative);

const BASIC_BUILDER_NDM: Arg = Arg::of("-ndm", "ndm", "number of dimensions").within(Domain::Whole);
const BASIC_BUILDER_NDF: Arg = Arg::of("-ndf", "ndf", "number of degrees of freedom of a node").within(Domain::Whole);
const NAME: Arg = Arg::new("name", "name of the parameter");
const PSET_VALUE: Arg = Arg::new("value", "value of the parameter");
const NODE_TAG: Arg = Arg::whole("tag", "tag of the node");
const NODE_NDF: Arg = Arg::of("-ndf", "ndf", "number of degrees of freedom").within(Domain::Whole);
/// Tag of a node that is there.
pub(crate) const NODE: Arg = Arg::whole("node", "tag of the node");
/// Degree of freedom of a node, from 1.
pub(crate) const DOF: Arg = Arg::whole("dof", "degree of freedom");
const DIRECTION: Arg = Arg::whole("direction", "direction");
const SET_NODE_COORD_VALUE: Arg = Arg::number("value", "coordinate");
const SET_START_NODE_TAG_TAG: Arg = Arg::whole("tag", "first tag of nodes that are made by themselves");

pub(crate) const COMMANDS: &[Command] = &[
    Command::new("wipe", "wipe", wipe)
        .about("Removes the model, the analysis and the recorders.")
        .leaving(Effect::Empties),
    Command::new("model", MODEL, model)
        .arguments(&[BASIC_BUILDER_NDM, BASIC_BUILDER_NDF])
        .about(
            "Sets the dimensions of the model and the degrees of freedom of its nodes. It comes before all that it \
             counts for. `basic` is another name of the kind.",
        )
        .defining(&[things::MODEL], 0),
    Command::new("node", NODE_USAGE, node)
        .arguments(&[
            NODE_TAG,
            Arg::number("x", "x coordinate"),
            Arg::number("y", "y coordinate"),
            Arg::number("z", "z coordinate"),
            NODE_NDF,
            NODE_MASS,
            NODE_DISP,
            NODE_VEL,
        ])
        .about("Makes a node.")
        .defining(&[things::NODE], 1),
    Command::new("mass", MASS, mass)
        .arguments(&[NODE, NODE_MASS.after("").called("m1")])
        .about("Sets the mass of a node in each of its directions."),
    Command::new("pset", PSET, pset)
        .arguments(&[NAME, PSET_VALUE])
        .about("Sets a variable, unless a study gives it another value.")
        .own(),
    Command::new("setNodeCoord", SET_COORD, set_node_coord)
        .arguments(&[NODE, DIRECTION, SET_NODE_COORD_VALUE])
        .about("Moves a node that has no displacement."),
    Command::new("setStartNodeTag", START_TAG, set_start_node_tag)
        .arguments(&[SET_START_NODE_TAG_TAG])
        .about("Has no effect: the nodes that it counts are those of OpenSees' meshes."),
];

const MODEL: &str = "model BasicBuilder -ndm $ndm <-ndf $ndf>";
const NODE_USAGE: &str = "node $tag $x <$y <$z>> <-ndf $ndf> <-mass $m ...> <-disp $u ...> <-vel $v ...>";
const MASS: &str = "mass $node $m1 <$m2 ...>";
const PSET: &str = "pset $name $value";
const START_TAG: &str = "setStartNodeTag $tag";
const SET_COORD: &str = "setNodeCoord $node $direction $value";

/// The node with the tag that comes next.
pub(crate) fn node_of(interp: &Tcl, args: &mut Args<'_>, what: &str) -> Result<NodeId, Exception> {
    let tag = args.tag(things::NODE, what)?;
    interp.host.engine.model().node(tag).ok_or_else(|| {
        let model = interp.host.engine.model();
        let near = model.node_tags().min_by_key(|t| t.abs_diff(tag));
        let label = near.map_or_else(|| "no node has been made".into(), |t| format!("the nearest tag is {t}"));
        args.absent(things::NODE, tag, label)
    })
}

/// The first tag of nodes that OpenSees makes by itself. Only its meshes do, which are not known here.
fn set_start_node_tag(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, START_TAG);
    a.int(SET_START_NODE_TAG_TAG.meaning)?;
    finish(interp, &a)?;
    Ok(Value::EMPTY)
}

fn wipe(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let finished = interp.host.wipe();
    finished.map_err(|e| call.error_at(0, e.to_string(), "a recorder could not be finished"))?;
    Ok(Value::EMPTY)
}

fn model(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, MODEL);
    if a.at_option() {
        let d = Diagnostic::warning(&checks::words::MISSING_WORD, "model: the kind of model is missing: it is basic");
        warn(interp, d.at(a.next_span(), "expected basic before this"))?;
    } else {
        let builder = a.word("kind of model")?;
        if !["basic", "basicbuilder", "modelbuilder"].contains(&builder.to_lowercase().as_str()) {
            return Err(a.unknown_name("kind of model", ["basic", "BasicBuilder"]));
        }
    }
    let (mut ndm, mut ndf) = (None, None);
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-ndm" | "-NDM" => ndm = Some(a.dof(BASIC_BUILDER_NDM.meaning, 3)? + 1),
            "-ndf" | "-NDF" => ndf = Some(a.dof(BASIC_BUILDER_NDF.meaning, 6)? + 1),
            _ => ignore_unknown(interp, &mut a)?,
        }
    }
    let Some(ndm) = ndm else {
        return Err(a.refuse_at(call.span(0), "model: the number of dimensions is missing", "expected -ndm 1, 2 or 3"));
    };
    interp.host.builder.ndm = ndm;
    interp.host.builder.ndf = ndf.unwrap_or(ndm * (ndm + 1) / 2);
    interp.host.builder.definitions.reuse_tags();
    Ok(Value::EMPTY)
}

/// The command can only be used after `model`. After `wipe` the dimensions of before hold, as in openseespy.
pub(crate) fn need_model(interp: &mut Tcl, call: &Call<'_>) -> Result<(), Exception> {
    if interp.host.builder.ndm > 0 {
        return Ok(());
    }
    if let Some((ndm, ndf)) = interp.host.builder.former {
        (interp.host.builder.ndm, interp.host.builder.ndf) = (ndm, ndf);
        let message = format!("the model was wiped: {ndm} dimensions and {ndf} degrees of freedom still hold");
        return warn(
            interp,
            Diagnostic::warning(&checks::model::MODEL_WIPED, message)
                .at(call.span(0), "expected a command \"model\" before this"),
        );
    }
    let d = Diagnostic::error(format!("{}: there is no model yet", call.name()))
        .by(&checks::words::NO_MODEL)
        .absent(Absent::new(things::MODEL, ""))
        .at(call.span(0), "expected a command \"model\" before this")
        .help(format!("usage: {MODEL}"));
    Err(Exception::diagnosed(d))
}

fn node(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    need_model(interp, call)?;
    let mut a = Args::new(call, NODE_USAGE);
    let tag = a.int(NODE.meaning)?;
    if interp.host.engine.model().node(tag).is_some() {
        return Err(a.exists(things::NODE, tag));
    }
    let ndm = interp.host.builder.ndm;
    let coords = (0..ndm).map(|i| a.float(["x coordinate", "y coordinate", "z coordinate"][i]));
    let coords = coords.collect::<Result<Vec<f64>, _>>()?;
    let mut ndf = interp.host.builder.ndf;
    let (mut mass, mut disp, mut vel) = (None, None, None);
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-ndf" | "-NDF" => ndf = a.dof(NODE_NDF.meaning, 6)? + 1,
            "-mass" => mass = Some(values(&mut a, ndf, &NODE_MASS)?),
            "-disp" | "-dispLoc" => disp = Some(values(&mut a, ndf, &NODE_DISP)?),
            "-vel" => vel = Some(values(&mut a, ndf, &NODE_VEL)?),
            _ => ignore_unknown(interp, &mut a)?,
        }
    }
    let engine = &mut interp.host.engine;
    let id = engine.add_node(tag, &coords, ndf);
    if let Some(m) = mass {
        engine.change_model(|model| model.nodes[id.0].mass = m);
    }
    if disp.is_some() || vel.is_some() {
        engine.change_state(|state, model| {
            let dofs = model.nodes[id.0].dofs();
            for (to, from) in [(&mut state.disp, &disp), (&mut state.vel, &vel)] {
                if let Some(from) = from {
                    to[dofs.clone()].copy_from_slice(from);
                }
            }
        });
    }
    Ok(Value::EMPTY)
}

fn values(a: &mut Args<'_>, n: usize, arg: &Arg) -> Result<Vec<f64>, Exception> {
    (1..=n).map(|i| a.nth_number(arg, i)).collect()
}

fn mass(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, MASS);
    let id = node_of(interp, &mut a, NODE.meaning)?;
    let ndf = interp.host.engine.model().nodes[id.0].ndf;
    // OpenSees in Python takes fewer values than degrees of freedom: the others are zero.
    let given = if interp.host.called_by_host { a.left().clamp(1, ndf) } else { ndf };
    let mut m = values(&mut a, given, &NODE_MASS)?;
    m.resize(ndf, 0.0);
    finish(interp, &a)?;
    interp.host.engine.change_model(|model| model.nodes[id.0].mass = m);
    Ok(Value::EMPTY)
}

/// A parameter of a study: sets the variable of that name, to the study's value where it has one.
fn pset(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, PSET);
    let name = a.word(NAME.meaning)?.into_owned();
    let value = a.value(PSET_VALUE.meaning)?;
    let earlier = a.last_span().and_then(|span| interp.host.declared_at.insert(name.clone(), span));
    finish(interp, &a)?;
    warn_of_two_values(interp, &name, &value, earlier)?;
    let value = match interp.host.parameters.get(&name) {
        Some(x) => Value::from(*x),
        None => value,
    };
    if let Ok(x) = value.to_f64() {
        interp.host.declared.insert(name.clone(), x);
    }
    let Some(mut watches) = interp.host.watches.take() else {
        interp.set_var(&name, value.clone())?;
        return Ok(value);
    };
    // A second declaration is no mistake; a plain `set` is.
    watches.get(&name).iter().for_each(|watch| watch.release());
    interp.set_var(&name, value.clone())?;
    watches.extend(interp.watch_var(&name).map(|watch| (name, watch)));
    interp.host.watches = Some(watches);
    Ok(value)
}

/// Warn of a parameter that is declared again with another value, where declarations are watched. A study gives both one
/// value.
fn warn_of_two_values(interp: &mut Tcl, name: &str, value: &Value, earlier: Option<Span>) -> Result<(), Exception> {
    let (Some(earlier), true) = (earlier, interp.host.watches.is_some()) else { return Ok(()) };
    let (Some(first), Ok(second)) = (interp.host.declared.get(name).copied(), value.to_f64()) else { return Ok(()) };
    // With the values of a study the second one cannot be compared with the first.
    if first != second && interp.host.parameters.is_empty() {
        let place = interp.sources.location(earlier);
        let span = interp.host.declared_at.get(name).copied();
        let message = format!("the parameter {name} is declared as {second}, and as {first} before");
        let warning =
            Diagnostic::warning(&checks::words::DECLARED_TWICE, message).at(span, "a study gives both the same value");
        warn(interp, warning.help(format!("{place} declares it first")))?;
    }
    Ok(())
}

fn set_node_coord(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, SET_COORD);
    let id = node_of(interp, &mut a, NODE.meaning)?;
    let limit = interp.host.engine.model().nodes[id.0].ndm();
    let direction = a.dof(DIRECTION.meaning, limit)?;
    let x = a.number(&SET_NODE_COORD_VALUE)?;
    finish(interp, &a)?;
    interp.host.engine.change_model(|model| model.nodes[id.0].coords[direction] = x);
    Ok(Value::EMPTY)
}
