//! `remove`.

use crate::args::Args;
use crate::checks;
use crate::model::nodes::node_of;
use crate::text::Arg;
use crate::things;
use crate::{Command, Outcome, Tcl, finish, warn};
use hysteron_engine::model::Tag;
use hysteron_tcl::diagnostic::Diagnostic;
use hysteron_tcl::{Call, Exception, Value};

const LOAD_PATTERN_NODE: Arg = Arg::new("node", "tag of the node");

pub(crate) const COMMANDS: &[Command] =
    &[Command::new("remove", USAGE, remove).about("Removes something from the model.").arguments(&[
        LOAD_PATTERN_NODE,
        Arg::new("dof", "degree of freedom"),
        Arg::new("pattern", "tag of the pattern"),
        Arg::whole("tag", "tag of what is removed; for `mp` also that of its constrained node"),
    ])];

const USAGE: &str = "remove loadPattern $tag | recorders | recorder $tag | element $tag | node $tag | \
                     sp $tag | sp $node $dof <$pattern> | mp $tag | material $tag | timeSeries $tag | parameter $tag";

/// Warns that there is nothing to remove. OpenSees passes it over, and scripts remove in case there is something.
fn nothing(interp: &mut Tcl, a: &Args<'_>, message: String) -> Result<(), Exception> {
    warn(
        interp,
        Diagnostic::warning(&checks::model::NOTHING_TO_REMOVE, message).at(a.last_span(), "nothing is removed"),
    )
}

/// The same of a thing by its tag.
fn absent(interp: &mut Tcl, a: &Args<'_>, kind: &'static str, tag: Tag) -> Result<(), Exception> {
    nothing(interp, a, format!("there is no {kind} {tag}"))
}

fn remove(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, USAGE);
    match a.word("kind of thing to remove")?.as_ref() {
        "loadPattern" | "pattern" => {
            let tag = a.tag(things::PATTERN, "tag of the pattern")?;
            if interp.host.engine.change_model(|m| m.patterns.remove(&tag)).is_none() {
                absent(interp, &a, things::PATTERN, tag)?;
            }
        }
        "recorders" => {
            let finished = interp.host.output.recorders.finish();
            finished.map_err(|e| a.refuse(e.to_string(), ""))?;
        }
        "recorder" => {
            let tag = a.tag(things::RECORDER, "tag of the recorder")?;
            match interp.host.output.recorders.by_tag.remove(&tag) {
                Some(mut r) => r.recorder.finish().map_err(|e| a.refuse(e.to_string(), ""))?,
                None => absent(interp, &a, things::RECORDER, tag)?,
            }
        }
        "element" | "ele" => {
            let tag = a.tag(things::ELEMENT, "tag of the element")?;
            match interp.host.engine.model().element(tag) {
                Some(id) => {
                    interp.host.engine.remove_element(id);
                    interp.host.forget_element(id);
                }
                None => absent(interp, &a, things::ELEMENT, tag)?,
            }
        }
        "node" => {
            let tag = a.tag(things::NODE, LOAD_PATTERN_NODE.meaning)?;
            match interp.host.engine.model().node(tag) {
                Some(node) => {
                    if let Err(element) = interp.host.engine.remove_node(node) {
                        let message = format!("the node belongs to element {element}");
                        return Err(a.refuse(message, "expected a node without elements"));
                    }
                    interp.host.forget_node(node);
                }
                None => absent(interp, &a, things::NODE, tag)?,
            }
        }
        "sp" | "SPconstraint" | "SPConstraint" => return remove_sp(interp, &mut a),
        "mp" | "MPconstraint" => {
            let tag = a.int("tag of the constraint, or of the constrained node")?;
            let node = interp.host.engine.model().node(tag);
            let removed = interp.host.engine.change_model(|m| {
                let before = m.multi_points.len();
                m.multi_points.retain(|mp| Some(mp.constrained) != node);
                if m.multi_points.len() == before {
                    m.multi_points.retain(|mp| mp.tag != tag);
                }
                before - m.multi_points.len()
            });
            if removed == 0 {
                let message = format!("there is no multi-point constraint of node {tag}, nor one with this number");
                nothing(interp, &a, message)?;
            }
        }
        "material" | "uniaxialMaterial" => {
            let tag = a.tag(things::MATERIAL, "tag of the material")?;
            interp.host.builder.definitions.materials.remove(tag);
        }
        "parameter" => {
            let tag = a.tag(things::PARAMETER, "tag of the parameter")?;
            if interp.host.builder.parameters.remove(&tag).is_none() {
                absent(interp, &a, things::PARAMETER, tag)?;
            }
        }
        "timeSeries" => {
            let tag = a.tag(things::SERIES, "tag of the time series")?;
            interp.host.builder.definitions.series.remove(tag);
        }
        _ => {
            let known = [
                "loadPattern",
                "recorders",
                "recorder",
                "element",
                "node",
                "sp",
                "mp",
                "material",
                "timeSeries",
                "parameter",
            ];
            return Err(a.unknown_name("thing to remove", known));
        }
    }
    finish(interp, &a)?;
    Ok(Value::EMPTY)
}

/// `remove sp $tag`, or `remove sp $node $dof <$pattern>`.
fn remove_sp(interp: &mut Tcl, a: &mut Args<'_>) -> Outcome {
    let removed = if a.left() == 1 {
        let tag = a.int("tag of the constraint")?;
        interp.host.engine.change_model(|m| {
            let before = m.fixes.len() + m.patterns.values().map(|p| p.motions.len()).sum::<usize>();
            m.fixes.retain(|f| f.tag != tag);
            m.patterns.values_mut().for_each(|p| p.motions.retain(|s| s.tag != tag));
            before - m.fixes.len() - m.patterns.values().map(|p| p.motions.len()).sum::<usize>()
        })
    } else {
        let node = node_of(interp, a, LOAD_PATTERN_NODE.meaning)?;
        let ndf = interp.host.engine.model().nodes[node.0].ndf;
        let dof = a.dof("degree of freedom", ndf)?;
        let pattern = a.optional_int("tag of the pattern")?.filter(|t| *t != -1);
        interp.host.engine.change_model(|m| match pattern.and_then(|t| m.patterns.get_mut(&t)) {
            Some(p) => {
                let before = p.motions.len();
                p.motions.retain(|s| s.node != node || s.dof != dof);
                before - p.motions.len()
            }
            None => {
                let before = m.fixes.len();
                m.fixes.retain(|f| f.node != node || f.dof != dof);
                before - m.fixes.len()
            }
        })
    };
    if removed == 0 {
        nothing(interp, a, "there is no such constraint".into())?;
    }
    finish(interp, a)?;
    Ok(Value::EMPTY)
}
