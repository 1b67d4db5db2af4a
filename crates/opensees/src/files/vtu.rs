//! Files of the Visualization Toolkit: an unstructured grid with its data (VTU), and a list of them in time (PVD).
//!
//! The format is that of "VTK File Formats", Kitware: XML with arrays in base64, each behind its length in bytes.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use hysteron_engine::analysis::Engine;
use hysteron_engine::model::{ElementEntry, ElementId, Model, Node};
use std::borrow::Cow;
use std::fmt::Write as _;

/// A field of the nodes: a value for each degree of freedom of the model.
#[derive(Clone, Debug, PartialEq)]
pub struct PointField<'a> {
    /// Name of the array.
    pub name: Cow<'static, str>,
    /// Values, laid out as the displacements of the state.
    pub values: Cow<'a, [f64]>,
}

impl<'a> PointField<'a> {
    /// Displacements of the committed state.
    pub fn displacement(engine: &'a Engine) -> Self {
        Self { name: "Displacement".into(), values: engine.state().disp.as_slice().into() }
    }

    /// Velocities of the committed state.
    pub fn velocity(engine: &'a Engine) -> Self {
        Self { name: "Velocity".into(), values: engine.state().vel.as_slice().into() }
    }

    /// Accelerations of the committed state.
    pub fn acceleration(engine: &'a Engine) -> Self {
        Self { name: "Acceleration".into(), values: engine.state().accel.as_slice().into() }
    }

    /// A mode shape of the last `eigen`, from 0; `None` for one that has not been found.
    pub fn mode(engine: &'a Engine, number: usize) -> Option<Self> {
        let shape = engine.modes()?.shapes.get(number)?;
        Some(Self { name: format!("Mode{}", number + 1).into(), values: shape.as_slice().into() })
    }
}

/// A field of the elements.
#[derive(Clone, Debug, PartialEq)]
pub struct CellField {
    /// Name of the array.
    pub name: String,
    /// Values of each element, by rising tag; shorter ones are filled with zeros.
    pub values: Vec<Vec<f64>>,
}

/// The committed state of a model as a file VTU. The points are the nodes at rest, by rising tag. Each field is an array of
/// three translations, and one of three rotations where nodes have any ("...Rotation"). Of the elements, which are lines,
/// polygons and hexahedra by rising tag, the file has tags and the given fields.
pub fn grid(engine: &Engine, fields: &[PointField<'_>], cells: &[CellField]) -> String {
    let model = engine.model();
    let nodes: Vec<&Node> = model.nodes_by_tag().map(|id| &model.nodes[id.0]).collect();
    let mut rank = vec![0; model.nodes.len()];
    model.nodes_by_tag().enumerate().for_each(|(i, id)| rank[id.0] = i as i64);
    let ids: Vec<ElementId> = model.elements_by_tag().collect();
    let elements: Vec<&ElementEntry> = ids.iter().map(|id| &model.elements[id.0]).collect();
    let mut out = String::from(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n",
    );
    let _ = writeln!(
        out,
        "<UnstructuredGrid>\n<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n<PointData>",
        nodes.len(),
        elements.len()
    );
    integers(&mut out, "Tag", nodes.iter().map(|n| i64::from(n.tag)));
    for field in fields {
        let values = &field.values;
        let triples = |part: fn(&Node) -> (usize, usize, usize)| {
            nodes.iter().flat_map(move |n| {
                let (from, count, at) = part(n);
                (0..3).map(move |k| if (at..at + count).contains(&k) { values[n.offset + from + k - at] } else { 0.0 })
            })
        };
        numbers(&mut out, &field.name, 3, triples(|n| (0, n.ndf.min(n.ndm()).min(3), 0)));
        if nodes.iter().any(|n| rotations(n).1 > 0) {
            numbers(&mut out, &format!("{}Rotation", field.name), 3, triples(rotations));
        }
    }
    out.push_str("</PointData>\n<CellData>\n");
    integers(&mut out, "Tag", elements.iter().map(|e| i64::from(e.tag)));
    for field in cells {
        let width = field.values.iter().map(Vec::len).max().unwrap_or(0);
        let filled =
            field.values.iter().flat_map(|v| v.iter().copied().chain(std::iter::repeat_n(0.0, width - v.len())));
        if width > 0 {
            numbers(&mut out, &field.name, width, filled);
        }
    }
    out.push_str("</CellData>\n<Points>\n");
    numbers(&mut out, "Points", 3, nodes.iter().flat_map(|n| <[f64; 3]>::from(n.place())));
    out.push_str("</Points>\n<Cells>\n");
    integers(&mut out, "connectivity", elements.iter().flat_map(|e| e.nodes.iter().map(|n| rank[n.0])));
    integers(
        &mut out,
        "offsets",
        elements.iter().scan(0, |end, e| {
            *end += e.nodes.len() as i64;
            Some(*end)
        }),
    );
    integers(&mut out, "types", elements.iter().map(|e| cell_type(e.nodes.len())));
    out.push_str("</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n");
    out
}

/// Rotations of a node: the first of its degrees of freedom, their number, and the axis of the first.
fn rotations(n: &Node) -> (usize, usize, usize) {
    match (n.ndm(), n.ndf) {
        (2, 3) => (2, 1, 2),
        (3, 6) => (3, 3, 0),
        _ => (0, 0, 0),
    }
}

/// Number of a cell in VTK by its nodes.
fn cell_type(nodes: usize) -> i64 {
    match nodes {
        1 => 1,
        2 => 3,
        3 => 5,
        4 => 9,
        8 => 12,
        _ => 2,
    }
}

/// Global forces and moments on the first and the second node of each element.
pub fn end_forces(engine: &Engine) -> Vec<CellField> {
    let model = engine.model();
    let mut all = vec![];
    for id in model.elements_by_tag() {
        let mut force = vec![];
        engine.element_force(id, &mut force);
        all.push((id, force));
    }
    let mut out = vec![];
    for end in 0..2 {
        for (name, moments) in [("Force", false), ("Moment", true)] {
            let values = all.iter().map(|(id, f)| triple(model, &model.elements[id.0], f, end, moments).to_vec());
            out.push(CellField { name: format!("{name}{}", end + 1), values: values.collect() });
        }
    }
    out
}

/// Forces or moments of an element on one of its nodes in global axes.
fn triple(model: &Model, e: &ElementEntry, force: &[f64], end: usize, moments: bool) -> [f64; 3] {
    let Some(node) = e.nodes.get(end).map(|n| &model.nodes[n.0]) else { return [0.0; 3] };
    let before: usize = e.nodes[..end].iter().map(|n| model.nodes[n.0].ndf).sum();
    let (from, count, at) = if moments { rotations(node) } else { (0, node.ndf.min(node.ndm()).min(3), 0) };
    let mut out = [0.0; 3];
    (0..count).for_each(|k| out[at + k] = force.get(before + from + k).copied().unwrap_or(0.0));
    out
}

fn numbers(out: &mut String, name: &str, components: usize, values: impl Iterator<Item = f64>) {
    let bytes: Vec<u8> = values.flat_map(f64::to_le_bytes).collect();
    array(out, "Float64", name, components, &bytes);
}

fn integers(out: &mut String, name: &str, values: impl Iterator<Item = i64>) {
    let bytes: Vec<u8> = values.flat_map(i64::to_le_bytes).collect();
    array(out, "Int64", name, 1, &bytes);
}

fn array(out: &mut String, kind: &str, name: &str, components: usize, bytes: &[u8]) {
    let _ = write!(
        out,
        "<DataArray type=\"{kind}\" Name=\"{name}\" NumberOfComponents=\"{components}\" format=\"binary\">"
    );
    let mut block = (bytes.len() as u64).to_le_bytes().to_vec();
    block.extend_from_slice(bytes);
    STANDARD.encode_string(&block, out);
    out.push_str("</DataArray>\n");
}

/// A list of files in time (PVD). Where time goes back, their numbers stand for the times.
pub fn collection(files: &[(f64, String)]) -> String {
    let rises = files.windows(2).all(|w| w[1].0 > w[0].0);
    let mut out = String::from(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n<Collection>\n",
    );
    for (i, (time, file)) in files.iter().enumerate() {
        let time = if rises { *time } else { i as f64 };
        let name = file.replace('&', "&amp;").replace('<', "&lt;").replace('"', "&quot;");
        let _ = writeln!(out, "<DataSet timestep=\"{time}\" group=\"\" part=\"0\" file=\"{name}\"/>");
    }
    out.push_str("</Collection>\n</VTKFile>\n");
    out
}
