//! Rayleigh damping and regions.

use crate::args::Args;
use crate::checks;
use crate::element::damping::of_tag;
use crate::output::recorders::absent_of;
use crate::session::Region;
use crate::text::{Arg, Domain};
use crate::things;
use crate::{Command, Outcome, Tcl, finish, ignore_unknown, warn};
use hysteron_engine::element::damping::{Damped, ElementDamping};
use hysteron_engine::model::{ElementId, NodeId, Rayleigh};
use hysteron_engine::record::Missing;
use hysteron_engine::shared::Shared;
use hysteron_tcl::diagnostic::Diagnostic;
use hysteron_tcl::{Call, Exception, Value};
use std::sync::Arc;

const ALPHA_M: Arg = Arg::number("alphaM", "factor of the mass alphaM");
const BETA_K: Arg = Arg::number("betaK", "factor of the current stiffness betaK");
const BETA_K0: Arg = Arg::number("betaK0", "factor of the initial stiffness betaK0");
const BETA_KC: Arg = Arg::number("betaKc", "factor of the committed stiffness betaKc");
const TAG: Arg = Arg::whole("tag", "tag of the region");
const SET_ELEMENT_RAYLEIGH_DAMPING_FACTORS_ELEMENT: Arg = Arg::whole("element", "tag of the element");

pub(crate) const COMMANDS: &[Command] = &[
    Command::new("rayleigh", RAYLEIGH, rayleigh)
        .about(
            "Sets Rayleigh damping of the model: $C = \\alpha_M M + \\beta_K K + \\beta_{K0} K_0 + \\beta_{Kc} K_c$ \
             with the current, initial and committed stiffness.",
        )
        .arguments(&[
            ALPHA_M,
            BETA_K,
            BETA_K0,
            BETA_KC,
            Arg::of("-ele", "tag", "tags of elements that get the damping of their stiffness and mass"),
            Arg::of("-node", "tag", "tags of nodes that get the damping of their mass"),
        ]),
    Command::new("region", REGION, region)
        .about("Names nodes and elements together, for recorders, parameters or Rayleigh damping of their own.")
        .arguments(&[
            TAG,
            Arg::of("-rayleigh", "alphaM", "factor of the mass alphaM").within(Domain::Number),
            Arg::of("-rayleigh", "betaK", "factor of the current stiffness betaK").within(Domain::Number),
            Arg::of("-rayleigh", "betaK0", "factor of the initial stiffness betaK0").within(Domain::Number),
            Arg::of("-rayleigh", "betaKc", "factor of the committed stiffness betaKc").within(Domain::Number),
            Arg::of("-ele", "tag", "tags of elements; their nodes belong to the region too"),
            Arg::of("-eleOnly", "tag", "tags of elements, without their nodes"),
            Arg::flag("-eleOnlyRange", "first and last tag of elements, without their nodes"),
            Arg::of("-node", "tag", "tags of nodes; elements between them belong to the region too"),
            Arg::flag("-nodeOnlyRange", "first and last tag of nodes, without elements"),
            Arg::of("-eleRange", "first", "first and last tag of elements").within(Domain::Whole),
            Arg::of("-nodeRange", "first", "first and last tag of nodes").within(Domain::Whole),
            Arg::flag("-nodeOnly", "tags of nodes, without elements"),
        ])
        .defining(&[things::REGION], 1),
    Command::new("setElementRayleighDampingFactors", FACTORS, element_factors)
        .arguments(&[SET_ELEMENT_RAYLEIGH_DAMPING_FACTORS_ELEMENT, ALPHA_M, BETA_K, BETA_K0, BETA_KC])
        .about("Sets Rayleigh damping of one element."),
    Command::new("setElementRayleighFactors", FACTORS, element_factors).about("Sets Rayleigh damping of one element."),
];

const RAYLEIGH: &str = "rayleigh $alphaM $betaK $betaK0 $betaKc <-ele $tag ...> <-node $tag ...>";
const REGION: &str = "region $tag <-ele $tag ...> <-eleOnly $tag ...> <-eleRange $first $last> <-eleOnlyRange ...> \
                      <-node $tag ...> <-nodeOnly ...> <-nodeRange $first $last> <-nodeOnlyRange ...> \
                      <-rayleigh $alphaM $betaK $betaK0 $betaKc> <-damp $damping>";
const FACTORS: &str = "setElementRayleighDampingFactors $element $alphaM $betaK $betaK0 $betaKc";

fn factors(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Rayleigh, Exception> {
    let r = Rayleigh {
        alpha_m: a.number(&ALPHA_M)?,
        beta_k: a.number(&BETA_K)?,
        beta_k0: a.number(&BETA_K0)?,
        beta_kc: a.number(&BETA_KC)?,
    };
    let stiffness = r.beta_k + r.beta_k0 + r.beta_kc;
    if r.alpha_m < 0.0 || stiffness < 0.0 {
        let what = if r.alpha_m < 0.0 { "mass" } else { "stiffness" };
        let d = Diagnostic::warning(
            &checks::analysis::NEGATIVE_DAMPING,
            format!("the Rayleigh damping by {what} is negative: it feeds the motion"),
        );
        warn(interp, d.at(a.last_span(), "expected factors not less than 0"))?;
    }
    Ok(r)
}

/// Nodes and elements that are there now: those that come later have no damping, as in OpenSees. With `-ele` or `-node` the
/// damping is given to these alone; all others keep theirs.
fn rayleigh(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, RAYLEIGH);
    let r = factors(interp, &mut a)?;
    if !a.at_option() {
        damp_model(interp, r);
        finish(interp, &a)?;
        return Ok(Value::EMPTY);
    }
    let (mut elements, mut nodes): (Vec<ElementId>, Vec<NodeId>) = (vec![], vec![]);
    while a.at_option() {
        a.option();
        let option = a.last_word().into_owned();
        let tags = match option.as_str() {
            "-node" => a.tags(things::NODE),
            "-ele" | "-element" => a.tags(things::ELEMENT),
            _ => return Err(a.unknown_name("choice of what is damped", ["-ele", "-node"])),
        };
        if tags.is_empty() {
            return Err(a.refuse(format!("there are no tags after {option}"), "expected at least one"));
        }
        let model = interp.host.engine.model();
        for (tag, span) in tags {
            let found = if option == "-node" {
                model.node(tag).map(|id| nodes.push(id))
            } else {
                model.element(tag).map(|id| elements.push(id))
            };
            let what = if option == "-node" { "node" } else { "element" };
            found.ok_or_else(|| a.absent_at(span, what, tag, "expected a tag of the model"))?;
        }
    }
    finish(interp, &a)?;
    interp.host.engine.change_model(|m| {
        elements.iter().for_each(|e| m.elements[e.0].rayleigh = r);
        nodes.iter().for_each(|n| m.nodes[n.0].alpha_m = r.alpha_m);
    });
    Ok(Value::EMPTY)
}

/// Take the four factors and give them to the whole model.
pub(crate) fn set_rayleigh(interp: &mut Tcl, a: &mut Args<'_>) -> Result<(), Exception> {
    let r = factors(interp, a)?;
    damp_model(interp, r);
    Ok(())
}

fn damp_model(interp: &mut Tcl, r: Rayleigh) {
    interp.host.engine.change_model(|m| {
        m.elements.iter_mut().for_each(|e| e.rayleigh = r);
        m.nodes.iter_mut().for_each(|n| n.alpha_m = r.alpha_m);
    });
}

fn element_factors(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, FACTORS);
    let tag = a.tag(things::ELEMENT, SET_ELEMENT_RAYLEIGH_DAMPING_FACTORS_ELEMENT.meaning)?;
    let Some(id) = interp.host.engine.model().element(tag) else {
        return Err(a.absent(things::ELEMENT, tag, "expected the tag of an element"));
    };
    let r = factors(interp, &mut a)?;
    finish(interp, &a)?;
    interp.host.engine.change_model(|m| m.elements[id.0].rayleigh = r);
    Ok(Value::EMPTY)
}

/// Tags as a list, or as the first and the last of a range.
fn chosen(
    a: &mut Args<'_>,
    kind: &'static str,
    range: bool,
    there: impl Iterator<Item = i32>,
) -> Result<Vec<i32>, Exception> {
    if range {
        let (first, last) = (a.int("first tag")?, a.int("last tag")?);
        // Scripts write 1 to some billions for all.
        let mut found: Vec<i32> = there.filter(|tag| (first.min(last)..=first.max(last)).contains(tag)).collect();
        found.sort_unstable();
        return Ok(found);
    }
    Ok(a.tags(kind).into_iter().map(|(tag, _)| tag).collect())
}

/// Give a damping to the elements of a region; those that take none stay as they are, as in OpenSees.
fn damp(interp: &mut Tcl, a: &Args<'_>, region: &Region, damping: &Arc<ElementDamping>) -> Result<(), Exception> {
    let (mut undamped, mut damped) = (vec![], vec![]);
    for id in &region.elements {
        let entry = &interp.host.engine.model().elements[id.0];
        match Damped::new(entry.element.clone(), damping.clone()) {
            Ok(made) => {
                undamped.extend(entry.element.undamped().map(|element| (*id, element)));
                damped.push((*id, made.shared()));
            }
            Err(e) => {
                let d = Diagnostic::warning(&checks::elements::DAMPING_LEFT_OUT, format!("element {}: {e}", entry.tag));
                warn(interp, d.at(a.last_span(), "left without this damping"))?;
            }
        }
    }
    // Without the elements in between the history of a former damping would remain.
    for elements in [undamped, damped].into_iter().filter(|e| !e.is_empty()) {
        interp.host.engine.replace_elements(elements);
    }
    Ok(())
}

fn region(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, REGION);
    let tag = a.int(TAG.meaning)?;
    let mut region = Region::default();
    let (mut damping, mut own) = (None, None);
    let mut absent: Vec<Missing> = vec![];
    while let Some(option) = a.option() {
        let option = option.as_ref();
        let is_range = option.ends_with("Range");
        match option {
            "-ele" | "-eleOnly" | "-element" | "-eleRange" | "-eleOnlyRange" => {
                let model = interp.host.engine.model();
                let tags = chosen(&mut a, things::ELEMENT, is_range, model.element_tags())?;
                let ids: Vec<ElementId> = tags.iter().filter_map(|t| model.element(*t)).collect();
                absent.extend(tags.iter().filter(|t| model.element(**t).is_none()).map(|t| Missing::Element(*t)));
                if !option.starts_with("-eleOnly") {
                    region.nodes.extend(ids.iter().flat_map(|id| model.elements[id.0].nodes.iter().copied()));
                }
                region.elements.extend(ids);
            }
            "-node" | "-nodeOnly" | "-nodeRange" | "-nodeOnlyRange" => {
                let model = interp.host.engine.model();
                let tags = chosen(&mut a, things::NODE, is_range, model.node_tags())?;
                let ids: Vec<NodeId> = tags.iter().filter_map(|t| model.node(*t)).collect();
                absent.extend(tags.iter().filter(|t| model.node(**t).is_none()).map(|t| Missing::Node(*t)));
                if !option.starts_with("-nodeOnly") {
                    // Elements all of whose nodes are in the region.
                    let inside = |e: &&hysteron_engine::model::ElementEntry| e.nodes.iter().all(|n| ids.contains(n));
                    let found = model.elements.iter().filter(inside).filter_map(|e| model.element(e.tag));
                    region.elements.extend(found);
                }
                region.nodes.extend(ids);
            }
            "-rayleigh" => damping = Some(factors(interp, &mut a)?),
            "-damp" => own = Some(of_tag(interp, &mut a)?),
            _ => ignore_unknown(interp, &mut a)?,
        }
    }
    let check = &mut interp.host.check;
    absent.retain(|m| absent_of(m).is_none_or(|thing| !check.holds_back(&thing)));
    if !absent.is_empty() {
        let message = format!("region {tag}: the model has no {}", Missing::list(&absent));
        warn(
            interp,
            Diagnostic::warning(&checks::output::NOT_IN_MODEL, message).at(call.whole_span(), "left out of the region"),
        )?;
    }
    // In the order in which they are met, as recorders show them.
    let mut seen = std::collections::BTreeSet::new();
    region.nodes.retain(|n| seen.insert(*n));
    if let Some(r) = damping {
        interp.host.engine.change_model(|m| {
            region.elements.iter().for_each(|e| m.elements[e.0].rayleigh = r);
            region.nodes.iter().for_each(|n| m.nodes[n.0].alpha_m = r.alpha_m);
        });
    }
    if let Some(damping) = own {
        damp(interp, &a, &region, &damping)?;
    }
    interp.host.builder.regions.insert(tag, region);
    Ok(Value::EMPTY)
}
