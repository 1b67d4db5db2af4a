//! Parameters: numbers of the model that a script may change by a tag (`parameter updateParameter ...`).

pub(crate) mod sensitivity;

use crate::args::Args;
use crate::checks;
use crate::effect::Effect;
use crate::element::{domain_of, set_parameter as set_parameter_of, with_parameter};
use crate::model::nodes::{DOF, NODE, node_of};
use crate::text::{Arg, Domain};
use crate::things;
use crate::{Command, Outcome, Tcl, finish, warn};
use hysteron_engine::model::{NodeId, Tag};
use hysteron_engine::parameter::{NewValue, ParameterError};
use hysteron_tcl::diagnostic::{Diagnostic, Span};
use hysteron_tcl::{Call, Exception, Value};

const TAG: Arg = Arg::whole("tag", "tag of the parameter");
const PARAMETER_VALUE: Arg = Arg::number("value", "value");
const PARAMETER_PATTERN: Arg = Arg::whole("pattern", "tag of the pattern");
const NAME: Arg = Arg::new("name", "name of the parameter");

pub(crate) const COMMANDS: &[Command] = &[
    Command::new("parameter", PARAMETER, parameter)
        .arguments(&[TAG, PARAMETER_VALUE, NODE, DOF, PARAMETER_PATTERN, NAME])
        .about(
            "Declares a quantity that `updateParameter` can change. Of an element it is a number of its command, or of \
             the command of a law in it, also one that was left out. OpenSees has few of them: its names are known too.",
        )
        .defining(&[things::PARAMETER], 1),
    Command::new("addToParameter", ADD, add_to_parameter)
        .arguments(&[TAG, NODE, PARAMETER_PATTERN, DOF, NAME])
        .about("Adds a quantity to a parameter that exists."),
    Command::new("updateParameter", UPDATE, update_parameter)
        .arguments(&[TAG, PARAMETER_VALUE])
        .about("Gives a parameter a new value."),
    Command::new("getParamValue", "getParamValue $tag", value_of)
        .arguments(&[TAG])
        .about("Returns the value of a parameter.")
        .leaving(Effect::Nothing),
    Command::new("getParamTags", "getParamTags", tags)
        .about("Returns the tags of all parameters.")
        .leaving(Effect::Nothing),
    Command::new("setParameter", SET, set_parameter).about("Changes a quantity of elements or nodes once.").arguments(
        &[
            Arg::of("-val", "value", "new value").within(Domain::Number),
            Arg::of("-node", "node", "tags of nodes").within(Domain::Whole),
            Arg::of("-ele", "element", "tags of elements"),
            Arg::of("-eleRange", "first", "first and last tag of elements"),
        ],
    ),
];

const PARAMETER: &str = "parameter $tag <$value> | <node $node mass x|y|z|xy|xyz> | <node $node disp $dof> \
                         | <loadPattern $pattern loadAtNode $node $dof> | <loadPattern $pattern lambda> \
                         | <element|region $tag $name ...>";
const ADD: &str = "addToParameter $tag node $node mass x|y|z|xy|xyz | loadPattern $pattern loadAtNode $node $dof \
                   | element|region $tag $name ...";
const UPDATE: &str = "updateParameter $tag $value";
const SET: &str = "setParameter -val $value <-ele $element ... | -eleRange $first $last> $name ... | \
                   -node $node ... mass x|y|z|xy|xyz";

/// A number of the model.
#[derive(Clone, Debug, PartialEq)]
enum Place {
    /// Mass of the first degrees of freedom of a node.
    Mass { node: Tag, dofs: Vec<usize> },
    /// Reference load of a pattern on a node.
    Load { pattern: Tag, node: Tag, dof: usize },
    /// Displacement of a node: it can be read only.
    Disp { node: Tag, dof: usize },
    /// Load factor of a pattern: it can be read only.
    Factor { pattern: Tag },
    /// A number of an element, by the words that name it.
    Element { element: Tag, words: Vec<String> },
}

/// A number of the model with its places. Places are kept by tag: a removed object is no longer changed.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Parameter {
    value: f64,
    places: Vec<Place>,
}

/// A node by its tag; the tag.
fn node_tag(interp: &Tcl, a: &mut Args<'_>) -> Result<(NodeId, Tag), Exception> {
    let node = node_of(interp, a, NODE.meaning)?;
    Ok((node, interp.host.engine.model().nodes[node.0].tag))
}

/// `mass` and the directions, for a node with so many degrees of freedom.
fn mass_dofs(a: &mut Args<'_>, ndf: usize) -> Result<Vec<usize>, Exception> {
    let dofs = match a.word("direction of the mass")?.as_ref() {
        "x" | "X" | "1" => vec![0],
        "y" | "Y" | "2" => vec![1],
        "z" | "Z" | "3" => vec![2],
        "xy" | "XY" => vec![0, 1],
        "xyz" | "XYZ" => vec![0, 1, 2],
        _ => return Err(a.unknown_name("direction", ["x", "y", "z", "xy", "xyz"])),
    };
    if dofs.iter().any(|d| *d >= ndf) {
        let message = format!("the node has only {ndf} degrees of freedom");
        return Err(a.refuse(message, "expected a direction that it has"));
    }
    Ok(dofs)
}

/// The name of a parameter of elements, and a warning where none of them has it: OpenSees says nothing.
fn of_elements(interp: &mut Tcl, a: &mut Args<'_>, elements: &[Tag]) -> Result<Vec<Place>, Exception> {
    let mut words = vec![a.word(NAME.meaning)?.into_owned()];
    let span = a.last_span();
    while a.left() > 0 {
        words.push(a.word(NAME.meaning)?.into_owned());
    }
    let place = |element: Tag| Place::Element { element, words: words.clone() };
    let mut places: Vec<Place> = elements.iter().map(|e| place(*e)).collect();
    places.retain(|p| read(interp, p).is_some());
    if places.is_empty() {
        let of = match elements {
            [one] => format!("element {one} has"),
            _ => format!("none of {} elements has", elements.len()),
        };
        let message = format!("{of} no parameter \"{}\": it changes nothing", words.join(" "));
        warn(
            interp,
            Diagnostic::warning(&checks::model::NO_SUCH_PARAMETER, message)
                .at(span, "expected the name of a parameter"),
        )?;
    }
    Ok(places)
}

/// Place of a parameter in the model, from the words that name it.
fn places(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Vec<Place>, Exception> {
    match a.peek().as_deref() {
        Some("element") => {
            a.word("element")?;
            let tag = a.tag(things::ELEMENT, "tag of the element")?;
            if interp.host.engine.model().element(tag).is_none() {
                return Err(a.absent(things::ELEMENT, tag, "expected the tag of an element"));
            }
            of_elements(interp, a, &[tag])
        }
        Some("region") => {
            a.word("region")?;
            let tag = a.tag(things::REGION, "tag of the region")?;
            let Some(region) = interp.host.builder.regions.get(&tag) else {
                return Err(a.absent(things::REGION, tag, "expected the tag of a region"));
            };
            let model = interp.host.engine.model();
            let elements: Vec<Tag> = region.elements.iter().map(|e| model.elements[e.0].tag).collect();
            of_elements(interp, a, &elements)
        }
        _ => place(interp, a).map(|p| vec![p]),
    }
}

fn place(interp: &Tcl, a: &mut Args<'_>) -> Result<Place, Exception> {
    let model = interp.host.engine.model();
    match a.word("kind of thing")?.as_ref() {
        "node" => {
            let (id, node) = node_tag(interp, a)?;
            let ndf = model.nodes[id.0].ndf;
            match a.word("property of the node")?.as_ref() {
                "mass" | "-mass" => Ok(Place::Mass { node, dofs: mass_dofs(a, ndf)? }),
                "disp" => Ok(Place::Disp { node, dof: a.dof(DOF.meaning, ndf)? }),
                _ => Err(a.unknown_name("property of a node", ["mass", "disp"])),
            }
        }
        "loadPattern" | "pattern" => {
            let pattern = a.tag(things::PATTERN, PARAMETER_PATTERN.meaning)?;
            if !model.patterns.contains_key(&pattern) {
                return Err(a.absent(things::PATTERN, pattern, "expected the tag of a pattern"));
            }
            match a.word("property of the pattern")?.as_ref() {
                "lambda" => Ok(Place::Factor { pattern }),
                "loadAtNode" => {
                    let (id, node) = node_tag(interp, a)?;
                    let span = a.last_span();
                    let dof = a.dof(DOF.meaning, model.nodes[id.0].ndf)?;
                    let loaded = model.patterns[&pattern].nodal_loads.iter().any(|l| l.node == id);
                    if !loaded {
                        let message = format!("load pattern {pattern} has no load on node {node}");
                        return Err(a.refuse_at(span, message, "expected a node that the pattern loads"));
                    }
                    Ok(Place::Load { pattern, node, dof })
                }
                _ => Err(a.unknown_name("property of a load pattern", ["loadAtNode", "lambda"])),
            }
        }
        _ => Err(a.unknown_name("thing with parameters", ["node", "loadPattern", "element", "region"])),
    }
}

/// Present value at a place.
fn read(interp: &mut Tcl, place: &Place) -> Option<f64> {
    if let Place::Element { element, words } = place {
        let words: Vec<&str> = words.iter().map(String::as_str).collect();
        return with_parameter(interp, *element, &words, NewValue::Present).ok().map(|(_, value)| value);
    }
    let engine = &interp.host.engine;
    let model = engine.model();
    match place {
        Place::Mass { node, dofs } => model.nodes[model.node(*node)?.0].mass.get(*dofs.first()?).copied(),
        Place::Disp { node, dof } => {
            let node = &model.nodes[model.node(*node)?.0];
            engine.state().disp.get(node.offset + dof).copied()
        }
        Place::Factor { pattern } => Some(model.patterns.get(pattern)?.factor(engine.state().time)),
        Place::Element { .. } => None,
        Place::Load { pattern, node, dof } => {
            let id = model.node(*node)?;
            // OpenSees takes the last load on the node.
            let load = model.patterns.get(pattern)?.nodal_loads.iter().rev().find(|l| l.node == id)?;
            load.values.get(*dof).copied()
        }
    }
}

/// Put a value in its place.
fn write(interp: &mut Tcl, place: &Place, value: NewValue) {
    if let Place::Element { element, words } = place {
        let words: Vec<&str> = words.iter().map(String::as_str).collect();
        set_parameter_of(interp, *element, &words, value);
        return;
    }
    let put = |x: &mut f64| *x = value.instead_of(*x).unwrap_or(*x);
    interp.host.engine.change_model(|model| match place {
        Place::Mass { node, dofs } => {
            if let Some(id) = model.node(*node) {
                let mass = &mut model.nodes[id.0].mass;
                mass.iter_mut().enumerate().filter(|(d, _)| dofs.contains(d)).for_each(|(_, m)| put(m));
            }
        }
        Place::Load { pattern, node, dof } => {
            let id = model.node(*node);
            let loads = model.patterns.get_mut(pattern).map(|p| &mut p.nodal_loads);
            let load = loads.and_then(|loads| loads.iter_mut().rev().find(|l| Some(l.node) == id));
            if let Some(x) = load.and_then(|l| l.values.get_mut(*dof)) {
                put(x);
            }
        }
        Place::Element { .. } | Place::Disp { .. } | Place::Factor { .. } => {}
    });
}

/// Why an element refuses a value, in words; `None` where it takes it.
fn refusal(interp: &mut Tcl, place: &Place, value: NewValue) -> Option<String> {
    let Place::Element { element, words } = place else { return None };
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    match with_parameter(interp, *element, &words, value) {
        Err(ParameterError::Refused(why)) => Some(format!("element {element}: {why}")),
        _ => None,
    }
}

fn parameter(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, PARAMETER);
    let tag = a.int(TAG.meaning)?;
    if interp.host.builder.parameters.contains_key(&tag) {
        return Err(a.exists(things::PARAMETER, tag));
    }
    let mut new = Parameter::default();
    if let Some(value) = a.optional_number(&PARAMETER_VALUE)? {
        new.value = value;
    } else if a.left() > 0 {
        new.places = places(interp, &mut a)?;
        new.value = new.places.first().and_then(|p| read(interp, p)).unwrap_or(0.0);
    }
    finish(interp, &a)?;
    interp.host.builder.parameters.insert(tag, new);
    Ok(Value::from(i64::from(tag)))
}

/// Tag of a parameter that is there.
fn known(interp: &Tcl, a: &mut Args<'_>) -> Result<Tag, Exception> {
    let tag = a.tag(things::PARAMETER, TAG.meaning)?;
    if interp.host.builder.parameters.contains_key(&tag) {
        return Ok(tag);
    }
    let tags: Vec<String> = interp.host.builder.parameters.keys().map(ToString::to_string).collect();
    let there = if tags.is_empty() { "none has been defined".to_owned() } else { tags.join(" ") };
    Err(a.absent(things::PARAMETER, tag, format!("defined: {there}")))
}

fn add_to_parameter(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, ADD);
    let tag = known(interp, &mut a)?;
    let places = places(interp, &mut a)?;
    finish(interp, &a)?;
    let value = places.first().and_then(|p| read(interp, p));
    if let Some(p) = interp.host.builder.parameters.get_mut(&tag) {
        p.places.extend(places);
        p.value = value.unwrap_or(p.value);
    }
    Ok(Value::from(i64::from(tag)))
}

/// Refuse a value that a number of the model cannot have.
fn refuse_meaningless(
    interp: &mut Tcl,
    a: &Args<'_>,
    span: Option<Span>,
    value: f64,
    places: &[Place],
) -> Result<(), Exception> {
    for place in places {
        if let Some(why) = refusal(interp, place, NewValue::Is(value)) {
            return Err(a.refuse_at(span, why, "expected a value that the law takes").by(&checks::words::OUT_OF_RANGE));
        }
        match place {
            Place::Mass { .. } if value < 0.0 => {
                return Err(a.refuse_at(span, format!("the mass is {value}"), "expected a mass not less than 0"));
            }
            Place::Element { element, words } => {
                let domain = domain_of(interp, *element, words).filter(|domain| !domain.holds(value));
                let Some(domain) = domain else { continue };
                let message = format!("{} is {value}", words.join(" "));
                let label = format!("expected {}", domain.expected());
                if !domain.is_usual() {
                    return Err(a.refuse_at(span, message, label).by(&checks::words::OUT_OF_RANGE));
                }
                a.doubt_at(interp, span, message, label)?;
            }
            _ => {}
        }
    }
    Ok(())
}

fn update_parameter(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, UPDATE);
    let tag = known(interp, &mut a)?;
    let value = a.number(&PARAMETER_VALUE)?;
    let span = a.last_span();
    finish(interp, &a)?;
    let places = interp.host.builder.parameters.get(&tag).map(|p| p.places.clone()).unwrap_or_default();
    refuse_meaningless(interp, &a, span, value, &places)?;
    places.iter().for_each(|p| write(interp, p, NewValue::Is(value)));
    if let Some(p) = interp.host.builder.parameters.get_mut(&tag) {
        p.value = value;
    }
    // An element that has been removed is no news; one that a script has put in its place may have other parameters.
    let there = |interp: &Tcl, element: Tag| interp.host.engine.model().element(element).is_some();
    let lost = places.iter().find_map(|place| match place {
        Place::Element { element, words } if there(interp, *element) && read(interp, place).is_none() => {
            Some((*element, words))
        }
        _ => None,
    });
    if let Some((element, words)) = lost {
        let message = format!("element {element} has no parameter \"{}\" any more: it stays as it is", words.join(" "));
        warn(
            interp,
            Diagnostic::warning(&checks::model::NO_SUCH_PARAMETER, message).at(call.span(0), "changes nothing there"),
        )?;
    }
    Ok(Value::EMPTY)
}

fn value_of(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, "getParamValue $tag");
    let tag = known(interp, &mut a)?;
    finish(interp, &a)?;
    let Some(p) = interp.host.builder.parameters.get(&tag).cloned() else { return Ok(Value::EMPTY) };
    // Results are read anew; what a script has set is as it was set.
    let result = p.places.iter().find(|p| matches!(p, Place::Disp { .. } | Place::Factor { .. }));
    Ok(Value::from(result.and_then(|place| read(interp, place)).unwrap_or(p.value)))
}

fn tags(interp: &mut Tcl, _: &Call<'_>) -> Outcome {
    Ok(Value::list(interp.host.builder.parameters.keys().map(|t| Value::from(i64::from(*t)))))
}

fn set_parameter(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, SET);
    if !a.flag("-val") {
        a.word("option -val")?;
        return Err(a.refuse("setParameter begins with the value", "expected -val"));
    }
    let value = a.number(&PARAMETER_VALUE)?;
    let span = a.last_span();
    let model = interp.host.engine.model();
    let elements: Option<Vec<Tag>> = match a.peek().as_deref() {
        Some("-ele" | "-eles" | "-element") => {
            a.word("option")?;
            let tags: Vec<Tag> = a.tags(things::ELEMENT).into_iter().map(|(tag, _)| tag).collect();
            if let Some(missing) = tags.iter().find(|t| model.element(**t).is_none()) {
                return Err(a.absent(things::ELEMENT, missing, "expected tags of elements"));
            }
            Some(tags)
        }
        Some("-eleRange") => {
            a.word("option")?;
            let (first, last) = (a.int("first tag of the range")?, a.int("last tag of the range")?);
            let range = first.min(last)..=first.max(last);
            Some(model.element_tags().filter(|t| range.contains(t)).collect())
        }
        Some("-node" | "-nodes") => None,
        // OpenSees takes the name for an option, and does nothing.
        _ => {
            a.word("option -ele, -eleRange or -node")?;
            return Err(a.unknown_name("option of setParameter", ["-ele", "-eleRange", "-node"]));
        }
    };
    if let Some(elements) = elements {
        let places = of_elements(interp, &mut a, &elements)?;
        refuse_meaningless(interp, &a, span, value, &places)?;
        places.iter().for_each(|p| write(interp, p, NewValue::Is(value)));
        return Ok(Value::EMPTY);
    }
    a.word("option -node")?;
    let mut nodes = vec![];
    while a.at_number() {
        nodes.push(node_tag(interp, &mut a)?);
    }
    if !matches!(a.word("property of the nodes")?.as_ref(), "mass" | "-mass") {
        return Err(a.unknown_name("property of a node", ["mass"]));
    }
    let model = interp.host.engine.model();
    let ndf = nodes.iter().map(|(id, _)| model.nodes[id.0].ndf).min().unwrap_or(0);
    let dofs = mass_dofs(&mut a, ndf)?;
    finish(interp, &a)?;
    let places: Vec<Place> = nodes.iter().map(|(_, n)| Place::Mass { node: *n, dofs: dofs.clone() }).collect();
    refuse_meaningless(interp, &a, span, value, &places)?;
    places.iter().for_each(|p| write(interp, p, NewValue::Is(value)));
    Ok(Value::EMPTY)
}
