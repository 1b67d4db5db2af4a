//! Responses of elements, materials and sections that recorders take, from a thing of each kind.

use super::probe::{self, MODELS, Said, Walk};
use super::usage::{self, MatrixMask};
use hysteron::record::ElementResponse;

/// Responses of materials and sections; of each kind those that it knows are told.
const MATERIAL: &[&str] = &[
    "stress",
    "strain",
    "tangent",
    "stressStrain",
    "stressStrainTangent",
    "plasticStrain",
    "strainRate",
    "energy",
    "stresses",
    "strains",
    "material",
    "failed",
    "damage",
    "cyclesAndRange",
    "failure",
    "factor",
    "cumPlasticStrain",
    "dissipatedEnergy",
    "temperature",
    "temperatures",
    "equilibrium",
    "overstress",
    "heat",
    "stored",
    "heatStored",
    "heatLost",
    "dashpotStrain",
];
const SECTION: &[&str] = &[
    "force",
    "deformation",
    "forceAndDeformation",
    "stiffness",
    "flexibility",
    "code",
    "fiber",
    "fiberData",
    "centroid",
    "torsion",
    "energy",
    "addition",
];

/// Responses by the usage of a kind, `None` for a command whose kinds have none. Empty if no thing of the kind could be made.
///
/// `example` has words that make a thing of the kind; empty where the usage leads to some.
pub fn of(command: &str, usage: &str, example: &str) -> Option<Vec<&'static str>> {
    let (around, known): (&[&str], &[&str]) = match command {
        "element" => (&[""], &[]),
        "uniaxialMaterial" => (&["\nelement zeroLength 77 1 2 -mat @ -dir 1"], MATERIAL),
        // A section of beams, or one of plates.
        "section" => (&["\nelement zeroLengthSection 77 1 2 @", "\nelement ShellDKGT 77 1 3 4 @"], SECTION),
        _ => return None,
    };
    for (model, around) in MODELS.iter().flat_map(|model| around.iter().map(move |around| (*model, *around))) {
        for words in examples(model, usage, example) {
            let around = around.replace('@', words.get(2).map_or("", String::as_str));
            let full = [words.join(" "), around].concat();
            let ran = probe::run(model, &[full]);
            let engine = &ran.interp.host.engine;
            let made = engine.model().element_tags().last().and_then(|tag| engine.model().element(tag));
            if probe::ended_with_error(&ran) || engine.model().elements.len() < 2 {
                continue;
            }
            let Some(id) = made else { continue };
            let is_known = |words: &[&str]| ElementResponse::is_known(engine, id, words);
            let names: Vec<&'static str> = match command {
                "element" => ElementResponse::names(engine, id)
                    .filter(|n| !matches!(*n, "forces" | "globalForce" | "globalForces"))
                    .collect(),
                "section" => {
                    let of_point = |n: &str| is_known(&["section", n, "1", "stress"]) || is_known(&["section", "1", n]);
                    known.iter().copied().filter(|n| of_point(n)).collect()
                }
                _ => {
                    let of_part = |n: &str| is_known(&["material", "1", n, "1", "stress"]);
                    known.iter().copied().filter(|n| is_known(&["material", "1", n]) || of_part(n)).collect()
                }
            };
            return Some(names);
        }
    }
    Some(vec![])
}

/// Words of a command that make a thing of a kind: those of the example, or those that the usage asks for.
fn examples(model: &str, usage: &str, example: &str) -> Vec<Vec<String>> {
    let head: Vec<&str> = usage.split(' ').take(2).collect();
    if !example.is_empty() {
        return vec![example.split(' ').map(str::to_owned).collect()];
    }
    let parts = usage::parse(usage);
    let forms = parts.split(|p| *p == MatrixMask::Either);
    let made = forms.filter_map(|form| {
        let required: Vec<MatrixMask> =
            form.iter().filter(|p| !matches!(p, MatrixMask::Optional(_))).cloned().collect();
        let mut walk = Walk::new(model, vec![head[0].to_owned()]);
        walk.take(&required);
        // A tag is found to be taken only when the thing is made.
        if head[0] != "element" && walk.words.len() > 2 {
            walk.words[2] = "77".to_owned();
        }
        (probe::say(model, &walk.words) == Said::Taken).then_some(walk.words)
    });
    made.collect()
}
