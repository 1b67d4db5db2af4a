//! Responses of elements, materials and sections that recorders take, from a thing of each kind.

use super::script::Script;
use hysteron::record::ElementResponse;
use hysteron::run::End;

/// Things that nearly every kind needs, under tags from 1 on.
const PARTS: &str = "
uniaxialMaterial Elastic 1 1.; uniaxialMaterial Elastic 2 1.; uniaxialMaterial Elastic 3 1.; uniaxialMaterial Elastic 4 1.
frictionModel Coulomb 1 0.1; frictionModel Coulomb 2 0.1; frictionModel Coulomb 3 0.1
nDMaterial ElasticIsotropic 1 1. 0.2
timeSeries Linear 1; timeSeries Linear 2; pattern Plain 1 1 {}
parameter 1";

const SPACE: &str = "model basic -ndm 3 -ndf 6
node 1 0 0 0; node 2 0 0 1; node 3 1 0 0; node 4 1 0 1; fix 1 1 1 1 1 1 1
geomTransf Linear 1 1 0 0; section Elastic 1 1. 1. 1. 1. 1. 1.; section ElasticMembranePlateSection 1 1. 0.2 1.
uniaxialMaterial Elastic 9 1.; element zeroLength 1 1 2 -mat 9 9 9 9 9 9 -dir 1 2 3 4 5 6; mass 2 1 1 1 1 1 1";

const PLANE: &str = "model basic -ndm 2 -ndf 3
node 1 0 0; node 2 0 1; node 3 1 0; node 4 1 1; fix 1 1 1 1
geomTransf Linear 1; section Elastic 1 1. 1. 1.
uniaxialMaterial Elastic 9 1.; element zeroLength 1 1 2 -mat 9 9 9 -dir 1 2 3; mass 2 1 1 1";

const FLAT: &str = "model basic -ndm 2 -ndf 2
node 1 0 0; node 2 1 0; node 3 1 1; node 4 0 1; node 5 0.5 0; node 6 1 0.5; node 7 0.5 1; node 8 0 0.5; node 9 0.5 0.5; fix 1 1 1
section Elastic 1 1. 1. 1.; uniaxialMaterial Elastic 9 1.; element zeroLength 1 1 2 -mat 9 9 -dir 1 2; mass 2 1 1";

const SOLID: &str = "model basic -ndm 3 -ndf 3
node 1 0 0 0; node 2 1 0 0; node 3 1 1 0; node 4 0 1 0; node 5 0 0 1; node 6 1 0 1; node 7 1 1 1; node 8 0 1 1; fix 1 1 1 1
node 11 0.5 0 0; node 12 0.5 0.5 0; node 13 0 0.5 0; node 14 0 0 0.5; node 15 0 0.5 0.5; node 16 0.5 0 0.5
section Elastic 1 1. 1. 1. 1. 1. 1.; uniaxialMaterial Elastic 9 1.; element zeroLength 1 1 2 -mat 9 9 -dir 1 2; mass 2 1 1 1";

/// The models in which a kind is made.
const MODELS: [&str; 4] = [SPACE, PLANE, FLAT, SOLID];

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

/// Responses of the kind that an example makes, `None` for a command whose kinds have none. Empty if the example makes none.
pub fn of(command: &str, example: &str) -> Option<Vec<&'static str>> {
    let (around, known): (&[&str], &[&str]) = match command {
        "element" => (&[""], &[]),
        "uniaxialMaterial" => (&["\nelement zeroLength 77 1 2 -mat @ -dir 1"], MATERIAL),
        // A section of beams, or one of plates.
        "section" => (&["\nelement zeroLengthSection 77 1 2 @", "\nelement ShellDKGT 77 1 3 4 @"], SECTION),
        _ => return None,
    };
    for (model, around) in MODELS.iter().flat_map(|model| around.iter().map(move |around| (*model, *around))) {
        // What the kind needs is made before it.
        let made = example.rsplit("; ").find(|part| part.starts_with(command));
        let tag = made.and_then(|words| words.split(' ').nth(2)).unwrap_or_default();
        let around = around.replace('@', tag);
        let ran = Script::default().run(&format!("{model}\n{PARTS}\n{example}{around}\n"));
        let engine = &ran.interp.host.engine;
        let made = engine.model().element_tags().last().and_then(|tag| engine.model().element(tag));
        if matches!(ran.end, End::Rejected(_) | End::Raised(_)) || engine.model().elements.len() < 2 {
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
    Some(vec![])
}
