//! The models whose queries the Python package compares with openseespy: one for each row of the tables of kinds.

use super::every_bearing;
use super::every_kind::{ELEMENTS, MATERIALS, spring_words};
use super::parts::{PARTS, parts};
use super::shapes::{Shape, element_words, node_words, nodes};
use hysteron::opensees::kinds;
use serde_json::{Value, json};
use std::fmt::Write as _;
use std::path::Path;

/// Number of dimensions and degrees of freedom, and words of a section with tag 1.
const SECTIONS: &[(usize, usize, &str)] = &[
    (2, 3, "Elastic 1 200. 0.02 0.3"),
    (2, 3, "Elastic 1 200. 0.02 0.3 80. 0.8"),
    (3, 6, "Elastic 1 200. 0.02 0.3 0.4 80. 0.5"),
    (3, 6, "Elastic 1 200. 0.02 0.3 0.4 80. 0.5 0.8 0.7"),
    (3, 6, "ElasticFrame 1 200. 0.02 0.3 0.4 80. 0.5"),
    (2, 3, "Fiber 1 { patch rect 11 4 1 -0.15 -0.1 0.15 0.1\nfiber 0.1 0. 0.01 13 }"),
    (
        3,
        6,
        "Fiber 1 -GJ 50. { patch circ 11 6 2 0. 0. 0.05 0.2 0. 360.\nlayer straight 13 3 0.001 -0.1 0.1 -0.1 -0.1 }",
    ),
    (2, 3, "Aggregator 1 11 P 13 Mz 13 Vy"),
    (2, 3, "Aggregator 1 13 Vy -section 22"),
    (2, 3, "Parallel 1 22 23"),
    (2, 3, "Uniaxial 1 11 Mz"),
    (2, 3, "NDFiber 1 { patch rect 56 6 1 -0.15 -0.1 0.15 0.1 }"),
    (3, 6, "NDFiber 1 { patch rect 56 4 3 -0.15 -0.1 0.15 0.1 }"),
    (3, 6, "Bidirectional 1 200. 2. 3. 4."),
    (3, 6, "Elliptical 1 200. 180. 2. 3. 1. 4. 5."),
    (3, 6, "Isolator2spring 1 1e-8 200. 2. 20. 2000. 0.3 100. 5."),
    (2, 3, "WFSection2d 1 11 0.4 0.01 0.2 0.02 6 2"),
    (2, 3, "RCSection2d 1 13 13 11 0.5 0.3 0.05 0.001 0.001 0.0005 8 2 6"),
    (3, 6, "RCCircularSection 1 13 13 11 0.5 0.05 0.001 3 2 8 8 -GJ 50."),
    (3, 6, "ElasticMembranePlateSection 1 200. 0.3 0.2 0.01"),
    (3, 6, "PlateFiber 1 32 0.2"),
    (3, 6, "LayeredShell 1 4 32 0.1 33 0.01 34 0.1 33 0.02"),
];

/// Kinds of sections that only shells take.
const PLATES: [&str; 3] = ["ElasticMembranePlateSection", "PlateFiber", "LayeredShell"];

fn case(name: &str, parts: &str, nodes: &str, commands: &str) -> Value {
    json!({"name": name, "parts": parts, "nodes": nodes.trim_end(), "commands": commands.trim_end()})
}

/// Beams whose sections Python's commands take from a `beamIntegration`, with the rule that they have in scripts.
const BEAMS: [(&str, &str); 6] = [
    ("dispBeamColumn", "Legendre"),
    ("AxEqDispBeamColumn2d", "Legendre"),
    ("forceBeamColumn", "Lobatto"),
    ("forceBeamColumnCBDI", "Lobatto"),
    ("forceBeamColumnCSBDI", "Lobatto"),
    ("mixedBeamColumn", "Lobatto"),
];

/// The commands that make an element in Python: those of a script, but for the sections of beams.
fn in_python(words: &str, count: usize) -> String {
    let split: Vec<&str> = words.split(' ').collect();
    let rule = BEAMS.iter().find(|(kind, _)| *kind == split[0]);
    match (rule, &split[..]) {
        (Some((kind, rule)), [_, at, number, section, transformation, rest @ ..]) => {
            let row = [&[*kind, at, transformation, "9"], rest].concat().join(" ");
            format!("beamIntegration {rule} 9 {section} {number}\n{}", element_words(&row, count))
        }
        _ => element_words(words, count),
    }
}

fn cases() -> Vec<Value> {
    let mut out: Vec<Value> = vec![];
    for &(ndm, ndf, shape, words) in ELEMENTS {
        let places = nodes(ndm, shape);
        let made = in_python(words, places.len());
        out.push(case(&format!("element {ndm}D {words}"), &ndm.to_string(), &node_words(ndm, ndf, &places), &made));
    }
    for (name, nodes, command) in every_bearing::turned_words() {
        out.push(case(&format!("bearing {name}"), "bearings", &nodes, &command));
    }
    for (words, _) in MATERIALS {
        let (nodes, commands) = spring_words(words);
        out.push(case(&format!("material {words}"), "1", &nodes, &commands));
    }
    for &(ndm, ndf, words) in SECTIONS {
        let is_plate = PLATES.iter().any(|p| words.starts_with(p));
        let shape = if is_plate { Shape::Corners } else { Shape::MaterialPoint };
        let element = if is_plate { "ShellMITC4 1 1 2 3 4 1" } else { "zeroLengthSection 1 1 2 1" };
        let places = node_words(ndm, ndf, &nodes(ndm, shape));
        let commands = format!("section {words}\nelement {element}\n");
        out.push(case(&format!("section {ndm}D {words}"), &ndm.to_string(), &places, &commands));
    }
    out
}

#[test]
fn every_kind_of_section_is_in_the_table() {
    for kind in kinds("section") {
        let is_there = SECTIONS.iter().any(|(_, _, words)| words.split(' ').next() == Some(kind.names[0]));
        assert!(is_there, "no row for {}", kind.usage);
    }
}

/// The Python package has no build of these tables: it reads them from a file.
#[test]
fn the_models_of_the_python_package_are_those_of_the_tables() {
    let parts = json!({"1": PARTS, "2": parts(2), "3": parts(3), "bearings": every_bearing::PARTS});
    let mut text = format!("{{\n\"parts\": {parts},\n\"cases\": [\n");
    let cases = cases();
    for (i, case) in cases.iter().enumerate() {
        let _ = writeln!(text, "{case}{}", if i + 1 < cases.len() { "," } else { "" });
    }
    text.push_str("]\n}\n");
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("bindings/python/tests/queries/cases.json");
    if std::env::var_os("HYSTERON_WRITE").is_some() {
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(&path, text).unwrap();
        return;
    }
    let written = std::fs::read_to_string(&path).unwrap_or_default();
    assert!(written == text, "HYSTERON_WRITE=1 cargo test --release --test laws writes {} anew", path.display());
}
