//! Stand-ins for what a command names and nothing defines.
//!
//! A command that misses a material, a friction model or a time series is run again with a stand-in. Its other mistakes are then
//! told as well, and what it defines is there for the commands behind it. Nodes have no stand-in: their place matters.

use super::tell;
use crate::{Command, Tcl, commands, things};
use hysteron_engine::element::friction::Coulomb;
use hysteron_engine::material::Elastic;
use hysteron_engine::model::Tag;
use hysteron_engine::series::Linear;
use hysteron_engine::shared::Shared as _;
use hysteron_tcl::diagnostic::Absent;
use hysteron_tcl::{Call, Exception, Value};
use std::sync::Arc;

/// Stand-ins of one command.
const MAX_STAND_INS: usize = 16;
/// Coefficient of the stand-in for a friction model.
const FRICTION: f64 = 0.1;

/// Run a command again that was rejected for what it misses, and report its further mistakes. Returns true if it was done.
/// The stand-ins go afterwards: another command that names the same is told so.
pub(super) fn run_with(interp: &mut Tcl, command: &Command, call: &Call<'_>, first: Absent) -> bool {
    let (mut absent, mut made) = (Some(first), vec![]);
    let mut done = false;
    interp.is_repeat = true;
    while let Some(thing) = absent.take().filter(|_| made.len() < MAX_STAND_INS) {
        let Some(tag) = define(interp, &thing) else { break };
        made.push((thing.kind, tag));
        match (command.run)(interp, call) {
            Err(Exception::Error(e)) => {
                absent = e.diagnostic.absent.clone();
                tell(interp, e.diagnostic, call);
            }
            result => done = result.is_ok(),
        }
    }
    interp.is_repeat = false;
    made.into_iter().for_each(|(kind, tag)| remove(interp, kind, tag));
    done
}

/// Define a stand-in. Returns its tag; `None` for a kind that has none.
fn define(interp: &mut Tcl, absent: &Absent) -> Option<Tag> {
    let tag = absent.name.parse().ok()?;
    let known = &mut interp.host.builder.definitions;
    let is_new = match absent.kind {
        things::MATERIAL => known.materials.add(tag, Elastic { e_pos: 1.0, eta: 0.0, e_neg: 1.0 }.shared()),
        things::FRICTION => known.frictions.add(tag, Arc::new(Coulomb { mu: FRICTION })),
        things::SERIES => known.series.add(tag, Arc::new(Linear { factor: 1.0 })),
        _ => false,
    };
    is_new.then_some(tag)
}

/// Define a stand-in for any kind that can have one, where the model is not known: also nodes, in places of their own, and what
/// elements take beside materials.
pub(crate) fn define_any(interp: &mut Tcl, absent: &Absent) -> bool {
    let tag = absent.name.as_str();
    let (ndm, ndf) = (interp.host.builder.ndm, interp.host.builder.ndf);
    let number: f64 = tag.parse().unwrap_or(0.0);
    let coordinates = [number, (0.7 * number).sin(), (1.3 * number).cos()].map(|x| x.to_string());
    let mut words = match absent.kind {
        things::NODE => vec!["node", tag],
        things::ND_MATERIAL => vec!["nDMaterial", "ElasticIsotropic", tag, "1.0", "0.2"],
        things::SECTION if ndm == 3 => vec!["section", "Elastic", tag, "1.0", "1.0", "1.0", "1.0", "1.0", "1.0"],
        things::SECTION => vec!["section", "Elastic", tag, "1.0", "1.0", "1.0"],
        things::TRANSFORM if ndm == 3 => vec!["geomTransf", "Linear", tag, "0.3", "0.5", "0.8"],
        things::TRANSFORM => vec!["geomTransf", "Linear", tag],
        _ => return define(interp, absent).is_some(),
    };
    if absent.kind == things::NODE {
        words.extend(coordinates.iter().take(ndm).map(String::as_str));
    }
    let is_possible = ndm > 0 && ndf > 0 && number != 0.0;
    let values: Vec<Value> = words.iter().map(|w| Value::from(*w)).collect();
    let command = commands().find(|c| c.name == words[0]).filter(|_| is_possible);
    command.is_some_and(|c| (c.run)(interp, &Call::of(&values)).is_ok())
}

fn remove(interp: &mut Tcl, kind: &str, tag: Tag) {
    let known = &mut interp.host.builder.definitions;
    match kind {
        things::MATERIAL => drop(known.materials.remove(tag)),
        things::FRICTION => drop(known.frictions.remove(tag)),
        _ => drop(known.series.remove(tag)),
    }
}
