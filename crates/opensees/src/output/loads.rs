//! Queries that programs which draw models make: numbers of classes, and the loads of patterns.

use crate::args::Args;
use crate::text::Arg;
use crate::things;
use crate::{Command, Outcome, Tcl, finish};
use hysteron_engine::element::ElementLoad;
use hysteron_engine::model::Pattern;
use hysteron_tcl::{Call, Exception, Value};

const PATTERN: &[Arg] = &[Arg::new("pattern", "tag of a load pattern")];

pub(crate) const COMMANDS: &[Command] = &[
    Command::asking("getEleClassTags", "getEleClassTags <$element>", class_tags)
        .about("Returns OpenSees' numbers of the classes of all elements, or of one.")
        .arguments(&[Arg::new("element", "tag of an element")]),
    Command::asking("classType", CLASS_TYPE, class_type)
        .arguments(&[Arg::thing("tag", things::SECTION)])
        .about("Returns the name of the class of a section or an element."),
    Command::asking("getCrdTransfTags", "getCrdTransfTags", |i, _| {
        Ok(Value::list(i.host.builder.definitions.transforms.tags().map(|t| Value::from(i64::from(t)))))
    })
    .about("Returns the tags of all geometric transformations."),
    Command::asking("getEleLoadTags", "getEleLoadTags <$pattern>", |i, c| {
        element_loads(i, c, |tag, _, _, out| out.push(Value::from(i64::from(tag))))
    })
    .about("Returns the element of each element load, of all patterns or of one.")
    .arguments(PATTERN),
    Command::asking("getEleLoadClassTags", "getEleLoadClassTags <$pattern>", |i, c| {
        element_loads(i, c, |_, load, space, out| out.push(Value::from(described(load, space).0)))
    })
    .about("Returns OpenSees' number of the class of each element load.")
    .arguments(PATTERN),
    Command::asking("getEleLoadData", "getEleLoadData <$pattern>", |i, c| {
        element_loads(i, c, |_, load, space, out| out.extend(described(load, space).1.into_iter().map(Value::from)))
    })
    .about("Returns the numbers of all element loads, in OpenSees' order.")
    .arguments(PATTERN),
    Command::asking("getNodeLoadTags", "getNodeLoadTags <$pattern>", node_load_tags)
        .about("Returns the node of each nodal load, of all patterns or of one.")
        .arguments(PATTERN),
    Command::asking("getNodeLoadData", "getNodeLoadData <$pattern>", node_load_data)
        .about("Returns the forces of all nodal loads.")
        .arguments(PATTERN),
];

fn class_tags(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, "getEleClassTags <$element>");
    let model = interp.host.engine.model();
    let mut ids: Vec<_> = model.elements_by_tag().collect();
    if a.left() > 0 {
        let tag = a.tag(things::ELEMENT, "tag of the element")?;
        let id = model.element(tag);
        ids = vec![id.ok_or_else(|| a.absent(things::ELEMENT, tag, "expected the tag of an element"))?];
    }
    let tags = ids.iter().map(|id| Value::from(model.elements[id.0].element.class().tag));
    let tags = Value::list(tags);
    finish(interp, &a)?;
    Ok(tags)
}

const CLASS_TYPE: &str = "classType section|element $tag";

/// Name of the class of a section or an element.
fn class_type(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, CLASS_TYPE);
    let session = &interp.host;
    let class = match a.word("kind of thing")?.as_ref() {
        "section" => a.of(&session.builder.definitions.sections)?.0.class(),
        "element" => {
            let tag = a.tag(things::ELEMENT, "tag of the element")?;
            let model = session.engine.model();
            let id = model.element(tag);
            let missing = || a.absent(things::ELEMENT, tag, "expected the tag of an element");
            model.elements[id.ok_or_else(missing)?.0].element.class().name
        }
        _ => return Err(a.unknown_name("kind of thing with a class", ["section", "element"])),
    };
    finish(interp, &a)?;
    Ok(Value::from(class))
}

/// The pattern that the call names, or all of them.
fn patterns<'a>(interp: &'a Tcl, call: &Call<'_>) -> Result<Vec<&'a Pattern>, Exception> {
    let mut a = Args::new(call, "getEleLoadTags <$pattern>");
    let all = &interp.host.engine.model().patterns;
    if a.left() == 0 {
        return Ok(all.values().collect());
    }
    let tag = a.tag(things::PATTERN, "tag of the pattern")?;
    let pattern = all.get(&tag);
    pattern.map(|p| vec![p]).ok_or_else(|| a.absent(things::PATTERN, tag, "expected the tag of a pattern"))
}

/// A list with the values that `put` gives for each element load, from the tag of the element, the load, and true in space.
fn element_loads(interp: &mut Tcl, call: &Call<'_>, put: fn(i32, &ElementLoad, bool, &mut Vec<Value>)) -> Outcome {
    let mut out = vec![];
    for pattern in patterns(interp, call)? {
        for (id, load) in &pattern.element_loads {
            let model = interp.host.engine.model();
            let element = &model.elements[id.0];
            let space = element.nodes.first().is_some_and(|n| model.nodes[n.0].ndm() == 3);
            put(element.tag, load, space, &mut out);
        }
    }
    Ok(Value::list(out))
}

/// Number of the class of a load, and its numbers in OpenSees' order.
fn described(load: &ElementLoad, space: bool) -> (i64, Vec<f64>) {
    match *load {
        ElementLoad::Distributed { span, y, z, x } if span == (0.0, 1.0) && y.0 == y.1 && z.0 == z.1 && x.0 == x.1 => {
            if space {
                (5, vec![y.0, z.0, x.0])
            } else {
                (3, vec![y.0, x.0])
            }
        }
        ElementLoad::Distributed { span, y, z, x } => {
            if space {
                (121, vec![y.0, z.0, x.0, span.0, span.1, y.1, z.1, x.1])
            } else {
                (12, vec![y.0, y.1, x.0, x.1, span.0, span.1])
            }
        }
        ElementLoad::Point { at, y, z, x } => {
            if space {
                (6, vec![y, z, x, at])
            } else {
                (4, vec![y, x, at])
            }
        }
        ElementLoad::Moment { z } => (60, vec![0.0, 0.0, z]),
    }
}

fn node_load_tags(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let nodes = &interp.host.engine.model().nodes;
    let loads = patterns(interp, call)?.into_iter().flat_map(|p| &p.nodal_loads);
    Ok(Value::list(loads.map(|l| Value::from(i64::from(nodes[l.node.0].tag)))))
}

fn node_load_data(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let loads = patterns(interp, call)?.into_iter().flat_map(|p| &p.nodal_loads);
    Ok(Value::list(loads.flat_map(|l| l.values.iter().map(|x| Value::from(*x)))))
}
