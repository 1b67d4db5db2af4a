//! `print -JSON`: the model in the format of OpenSees, for the programs that draw it.
//!
//! As in OpenSees, nodes and elements have numbers for names, and definitions have texts. Parameters of laws are left out.

use hysteron_engine::element::transform::{TransformKind, TransformSpec};
use hysteron_engine::model::{Definitions, ElementEntry, Fix, Model, MultiPoint, Node, Pattern, PatternKind, Tag};
use serde_json::{Map, Value, json};
use std::collections::BTreeMap;

/// Definitions that each element was made of: kind and tag, in the order of its words.
pub(crate) type Components = BTreeMap<Tag, Vec<(&'static str, Tag)>>;

/// The whole document.
pub(super) fn model_file(model: &Model, definitions: &Definitions, components: &Components) -> String {
    let dimensions = model.nodes.first().map_or(3, Node::ndm);
    let nodes: Vec<Value> = model.nodes_by_tag().map(|id| node(&model.nodes[id.0])).collect();
    let of_element = |e: &ElementEntry| element(model, e, components.get(&e.tag), definitions);
    let elements: Vec<Value> = model.elements_by_tag().map(|id| of_element(&model.elements[id.0])).collect();
    let fixes = model.fixes.iter().map(|f| fix(model, f));
    let constraints: Vec<Value> = model.multi_points.iter().map(|m| multi_point(model, m)).chain(fixes).collect();
    let named = |tag: Tag, kind: &str| json!({ "name": tag.to_string(), "type": kind });
    let d = definitions;
    let materials = d.materials.tags().filter_map(|t| Some(named(t, uniaxial_class(d.materials.get(t)?.name()))));
    let nd_materials = d.nd_materials.tags().filter_map(|t| Some(named(t, d.nd_materials.get(t)?.class)));
    let sections = d.sections.tags().filter_map(|t| Some(named(t, d.sections.get(t)?.class())));
    let transforms = d.transforms.tags().filter_map(|t| Some(transform(t, d.transforms.get(t)?, dimensions)));
    let units = json!({ "force": "", "length": "", "time": "", "temperature": "" });
    let document = json!({ "StructuralAnalysisModel": {
        "BIM": "unknown", "description": "", "engineer": "", "units": units,
        "properties": {
            "uniaxialMaterials": materials.collect::<Vec<_>>(),
            "ndMaterials": nd_materials.collect::<Vec<_>>(),
            "sections": sections.collect::<Vec<_>>(),
            "crdTransformations": transforms.collect::<Vec<_>>(),
            "patterns": model.patterns.iter().map(|(tag, p)| pattern(model, *tag, p)).collect::<Vec<_>>(),
        },
        "geometry": { "nodes": nodes, "elements": elements, "constraints": constraints },
    } });
    // Nothing in it can fail to be written: keys are texts, and numbers that are not finite become null.
    serde_json::to_string_pretty(&document).unwrap_or_default() + "\n"
}

fn node(n: &Node) -> Value {
    let mut out = json!({ "name": n.tag, "ndf": n.ndf, "crd": n.coords });
    if n.mass.iter().any(|m| *m != 0.0) {
        out["mass"] = json!(n.mass);
    }
    out
}

fn element(
    model: &Model,
    e: &ElementEntry,
    components: Option<&Vec<(&'static str, Tag)>>,
    definitions: &Definitions,
) -> Value {
    let nodes: Vec<Tag> = e.nodes.iter().map(|n| model.nodes[n.0].tag).collect();
    let mut out = Map::new();
    out.insert("name".into(), json!(e.tag));
    out.insert("type".into(), json!(e.element.class().name));
    out.insert("nodes".into(), json!(nodes));
    let d = definitions;
    let taken: &[(&str, Tag)] = components.map_or(&[], Vec::as_slice);
    let of = |kind: &'static str| taken.iter().filter(move |(k, _)| *k == kind).map(|(_, tag)| *tag);
    let texts = |tags: Vec<Tag>| json!(tags.iter().map(Tag::to_string).collect::<Vec<_>>());
    let in_rules = of(d.integrations.kind).filter_map(|t| d.integrations.get(t)).flat_map(|i| &i.sections);
    let sections: Vec<Tag> =
        of(d.sections.kind).chain(of(d.plates.kind)).chain(in_rules.map(|(_, tag)| *tag)).collect();
    let materials: Vec<Tag> = of(d.materials.kind).chain(of(d.nd_materials.kind)).collect();
    if !materials.is_empty() {
        out.insert("materials".into(), texts(materials));
    }
    if !sections.is_empty() {
        out.insert("sections".into(), texts(sections));
    }
    if let Some(tag) = of(d.transforms.kind).next() {
        out.insert("crdTransformation".into(), json!(tag.to_string()));
    }
    Value::Object(out)
}

fn fix(model: &Model, f: &Fix) -> Value {
    json!({ "name": f.tag, "node": model.nodes[f.node.0].tag, "dof": f.dof + 1, "ref_value": 0 })
}

fn multi_point(model: &Model, m: &MultiPoint) -> Value {
    let tag = |id: hysteron_engine::model::NodeId| model.nodes[id.0].tag;
    let from_one = |dofs: &[usize]| dofs.iter().map(|d| d + 1).collect::<Vec<_>>();
    let rows: Vec<&[f64]> = m.matrix.chunks(m.retained_dofs.len().max(1)).collect();
    json!({
        "name": m.tag.to_string(), "node": tag(m.constrained), "ref_node": tag(m.retained),
        "dofs": from_one(&m.constrained_dofs), "ref_dof": from_one(&m.retained_dofs), "matrix": rows,
    })
}

fn transform(tag: Tag, t: &TransformSpec, dimensions: usize) -> Value {
    let kind = match t.kind {
        TransformKind::Linear => "Linear",
        TransformKind::PDelta => "PDelta",
        TransformKind::Corotational => "Corot",
    };
    let mut out = json!({ "name": tag.to_string(), "type": format!("{kind}CrdTransf{dimensions}d") });
    let of = |v: nalgebra::Vector3<f64>| json!(v.as_slice()[..dimensions.clamp(1, 3)].to_vec());
    if dimensions == 3 {
        out["vecInLocXZPlane"] = of(t.xz);
    }
    for (name, offset) in [("iOffset", t.offsets.0), ("jOffset", t.offsets.1)] {
        if offset != nalgebra::Vector3::zeros() {
            out[name] = of(offset);
        }
    }
    out
}

fn pattern(model: &Model, tag: Tag, p: &Pattern) -> Value {
    let load = |l: &hysteron_engine::model::NodalLoad| json!({ "node": model.nodes[l.node.0].tag, "value": l.values });
    match &p.kind {
        PatternKind::Plain { factor, .. } => {
            let nodes: Vec<Value> = p.nodal_loads.iter().map(load).collect();
            json!({ "name": tag.to_string(), "type": "Static", "scale": factor, "nodes": nodes })
        }
        PatternKind::Uniform(e) => {
            json!({ "name": tag.to_string(), "type": "UniformExcitation", "dof": e.direction + 1 })
        }
        PatternKind::MultipleSupport(_) => json!({ "name": tag.to_string(), "type": "MultiSupport" }),
    }
}

/// Class of a uniaxial material in OpenSees, by the name in its command.
fn uniaxial_class(name: &str) -> &str {
    match name {
        "Elastic" => "ElasticMaterial",
        "ElasticPP" => "ElasticPPMaterial",
        "ElasticPPGap" => "EPPGap",
        "ENT" => "ENTMaterial",
        "Hysteretic" => "HystereticMaterial",
        "Viscous" => "ViscousMaterial",
        "Parallel" => "ParallelMaterial",
        "Series" => "SeriesMaterial",
        "MinMax" => "MinMaxMaterial",
        "Fatigue" => "FatigueMaterial",
        other => other,
    }
}
