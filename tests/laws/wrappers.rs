//! What is around a law forwards all that the law is asked: its responses, its parameters and the columns that it watches.

use super::every_kind::MATERIALS;
use super::parts::{PARTS, parts};
use super::script::Script;
use hysteron::material::{
    Fatigue, FatigueParameters, InitialState, InitialStrain, Iteration, LimitCurve, Material, MinMax, Mullins,
    Multiaxial, ObservedColumns, PLANE, Parallel, ParallelSolids, PathIndependent, SOLID, Series, SeriesSolids,
    SeriesTolerance, SharedMultiaxial, Slot, Softening, WatchesColumns, WeightedLaws,
};
use hysteron::model::Definitions;
use hysteron::parameter::NewValue;
use hysteron::section::plate::{LayeredPlate, PlateFromPlaneStress, PlateRebar};
use hysteron::section::{
    Aggregator, Axial, Fiber, FiberBending, FiberSection, ParallelSections, Resultant, SectionSlot,
};
use std::collections::BTreeSet;
use std::path::Path;
use std::sync::Arc;

/// A spring of a column that fails.
const WATCHING: &str = "limitCurve ThreePoint 1 1 0. 9.5 1. 9.5 2. 9.5 -500. 4. 2 0 1 3 1 2
uniaxialMaterial LimitState 70 5 0.005 10 0.01 20 0.02 -5 -0.005 -10 -0.01 -20 -0.02 1 1 0 0 0 1 2\n";

/// Words in quotation marks in the sources of a folder: among them are the names of all responses and parameters.
fn quoted(folder: &str) -> BTreeSet<String> {
    fn collect(folder: &Path, words: &mut BTreeSet<String>) {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                collect(&path, words);
            } else {
                let text = std::fs::read_to_string(&path).unwrap();
                let quoted = text.split('"').skip(1).step_by(2);
                let is_name = |w: &&str| !w.is_empty() && w.chars().all(|c| c.is_alphanumeric() || c == '_');
                words.extend(quoted.filter(is_name).map(str::to_owned));
            }
        }
    }
    let mut words = BTreeSet::new();
    collect(&Path::new(env!("CARGO_MANIFEST_DIR")).join(folder), &mut words);
    words
}

fn definitions(host: Script, script: &str) -> Definitions {
    host.run(&format!("model basic -ndm 2 -ndf 3\n{script}")).done().interp.host.builder.definitions.clone()
}

/// Every kind of the table of materials, and a law that watches a column.
pub fn materials(host: Script) -> Vec<(String, Material)> {
    let mut script = format!("{PARTS}{WATCHING}");
    let mut made = vec![];
    for (i, (words, _)) in MATERIALS.iter().enumerate() {
        let tag = 1000 + i as i32;
        script += &format!("uniaxialMaterial {}\n", words.replacen('@', &tag.to_string(), 1));
        made.push((words.to_string(), tag));
    }
    made.push(("LimitState with a curve".to_owned(), 70));
    let definitions = definitions(host, &script);
    let law = |tag| Material::clone(definitions.materials.get(tag).unwrap());
    made.into_iter().map(|(words, tag)| (words, law(tag))).collect()
}

fn softening() -> Softening {
    Softening { excess: 0.0, strain: 1.0, power: None, healed: 0.0, time: 1.0, preload: 0.0 }
}

/// A law or a section in the state of an element.
trait Owned {
    /// Value of a response in the virgin state.
    fn response(&self, words: &[&str]) -> Option<(Vec<String>, Vec<f64>)>;
    /// The value of a parameter before it is set.
    fn parameter(&self, words: &[&str]) -> Option<f64>;
    fn curves(&self) -> Vec<LimitCurve>;
    /// Returns true if the state changes when its column has failed.
    fn takes_notice(&self) -> bool;
}

/// Sees every column far beyond its limit.
fn notices(of: &dyn WatchesColumns, mut state: Vec<f64>) -> bool {
    let before = state.clone();
    let curves: Vec<LimitCurve> = of.limit_curves().into_iter().cloned().collect();
    let seen = hysteron::material::ColumnResponse { deformation: 0.5, per_height: 1.0, force: [1e3; 3] };
    let responses = vec![Some(seen); curves.len()];
    of.observe(&mut state, &ObservedColumns { curves: &curves, responses: &responses });
    state != before
}

impl Owned for Slot {
    fn response(&self, words: &[&str]) -> Option<(Vec<String>, Vec<f64>)> {
        let (probe, mut state) = (self.probe(words)?, vec![0.0; self.len()]);
        self.init(&mut state);
        let mut out = vec![0.0; probe.len()];
        self.read(&probe.path, &state, &mut out);
        Some((probe.labels, out))
    }
    fn parameter(&self, words: &[&str]) -> Option<f64> {
        self.clone().set_parameter(words, NewValue::Present).ok()
    }
    fn curves(&self) -> Vec<LimitCurve> {
        self.limit_curves().into_iter().cloned().collect()
    }
    fn takes_notice(&self) -> bool {
        if self.limit_curves().is_empty() {
            return false;
        }
        let mut state = vec![0.0; self.len()];
        self.init(&mut state);
        // At a strain where the spring carries a force above the limit.
        let mut next = state.clone();
        let strain = hysteron::material::Strain { value: 0.015, ..Default::default() };
        self.update(&state, strain, &mut next).unwrap();
        notices(self, next)
    }
}

impl Owned for SectionSlot {
    fn response(&self, words: &[&str]) -> Option<(Vec<String>, Vec<f64>)> {
        let (probe, mut state) = (self.probe(words)?, vec![0.0; self.len()]);
        self.init(&mut state);
        let mut out = vec![0.0; probe.len()];
        self.read(&probe.path, &state, &mut out);
        Some((probe.labels, out))
    }
    fn parameter(&self, words: &[&str]) -> Option<f64> {
        self.clone().set_parameter(words, NewValue::Present).ok()
    }
    fn curves(&self) -> Vec<LimitCurve> {
        self.limit_curves().into_iter().cloned().collect()
    }
    fn takes_notice(&self) -> bool {
        if self.limit_curves().is_empty() {
            return false;
        }
        let mut state = vec![0.0; self.len()];
        self.init(&mut state);
        let mut next = state.clone();
        let mut e = vec![0.0; self.order()];
        e[0] = 0.015;
        self.update(&state, &e, 0.0, &mut next).unwrap();
        notices(self, next)
    }
}

/// Returns true for the same numbers, and for responses that are none in both.
fn same(a: &[f64], b: &[f64]) -> bool {
    a.iter().zip(b).all(|(a, b)| a == b || a.is_nan() && b.is_nan())
}

/// Compares what `bare` and `around` answer: words stand in front of those of `bare`. A law that has `moved` has not the values
/// of the virgin one.
fn compare(
    name: &str,
    words: &BTreeSet<String>,
    (bare, around): (&dyn Owned, &dyn Owned),
    (responses, parameters, moved): (&[&str], &[&str], bool),
    lost: &mut Vec<String>,
) -> usize {
    let mut compared = 0;
    for word in words {
        if let Some(own) = bare.response(&[word.as_str()]) {
            compared += 1;
            let asked: Vec<&str> = responses.iter().copied().chain([word.as_str()]).collect();
            match around.response(&asked) {
                Some(found) if found.0 == own.0 && (moved || same(&found.1, &own.1)) => {}
                found => lost.push(format!("{name}: response {word} is {found:?}, not {own:?}")),
            }
        }
        if let Some(own) = bare.parameter(&[word.as_str()]) {
            compared += 1;
            let asked: Vec<&str> = parameters.iter().copied().chain([word.as_str()]).collect();
            if around.parameter(&asked) != Some(own) {
                lost.push(format!("{name}: parameter {word}"));
            }
        }
    }
    if bare.curves() != around.curves() || bare.takes_notice() != around.takes_notice() {
        lost.push(format!("{name}: watched column"));
    }
    compared
}

/// Wrappers of one law, with the words in front of those of the law inside: of responses and of parameters.
pub fn wrappers(law: &Material) -> Vec<(&'static str, Material, &'static [&'static str])> {
    let one = || (Material::clone(law), 1);
    let life = FatigueParameters { d_max: 1.0, e0: 1e9, m: -0.5, limits: (-1e9, 1e9) };
    let fiber = Fiber { y: 0.0, z: 0.0, area: 1.0, material: one() };
    let section = FiberSection::new(vec![fiber], FiberBending::Plane, true);
    let mut all: Vec<(&'static str, Material, &'static [&'static str])> = vec![
        ("MinMax", Material::new(MinMax::new(one(), -1e9, 1e9, false)), &["material"]),
        ("Fatigue", Material::new(Fatigue::new(one(), life)), &["material"]),
        ("Mullins", Material::new(Mullins::new(one(), softening())), &["material"]),
        ("Parallel", Material::new(Parallel::new(vec![one()], vec![1.0])), &["material", "1"]),
        ("Series", Material::new(Series::new(vec![one()], Iteration::Converged)), &["material", "1"]),
        ("Axial", Material::new(Axial::new(Arc::new(section), 1).unwrap()), &["fiber", "0"]),
    ];
    // A law without its history does not fail at a limit.
    if law.limit_curves().is_empty() {
        all.push(("PathIndependent", Material::new(PathIndependent::new(one())), &["material"]));
    }
    if let Ok(shifted) = InitialState::strain(one(), 0.0) {
        all.push(("InitStrainMaterial", Material::new(shifted), &["material"]));
    }
    all
}

#[test]
fn every_law_is_whole_inside_wrappers_and_as_a_fiber() {
    let words = quoted("crates/engine/src/material");
    let (mut lost, mut compared) = (vec![], 0);
    for (name, law) in &materials(Script::default()) {
        let bare = Slot::new(law.clone(), 1, 0);
        for (kind, wrapped, path) in wrappers(law) {
            let twice = Slot::new(Material::new(MinMax::new((wrapped.clone(), 2), -1e9, 1e9, false)), 1, 0);
            let around = Slot::new(wrapped, 1, 0);
            // A fiber is named in responses alone.
            let moved = kind == "InitStrainMaterial";
            let none: &[&str] = &[];
            let parameters = if kind == "Axial" { none } else { path };
            compared +=
                compare(&format!("{kind} {name}"), &words, (&bare, &around), (path, parameters, moved), &mut lost);
            let inside: Vec<&str> = ["material"].iter().chain(path).copied().collect();
            let of_inside: Vec<&str> = ["material"].iter().chain(parameters).copied().collect();
            compare(&format!("MinMax {kind} {name}"), &words, (&bare, &twice), (&inside, &of_inside, moved), &mut lost);
        }
    }
    assert!(lost.is_empty(), "{} lost\n{}", lost.len(), lost.join("\n"));
    // Responses that every law has, and those of its own.
    assert!(compared > 6 * 8 * MATERIALS.len(), "only {compared} compared");
}

#[test]
fn every_section_is_whole_inside_another() {
    let words = quoted("crates/engine/src/section");
    let watching = "section Fiber 71 { fiber 0. 0. 1. 70\nfiber 0.1 0. 1. 11 }
        section Aggregator 72 13 Vy -section 71\nsection Uniaxial 73 70 P\nsection Elastic 74 200. 0.1 0.2\n";
    let definitions = definitions(Script::default(), &format!("{}{WATCHING}{watching}", parts(2)));
    let addition = || (Material::clone(definitions.materials.get(13).unwrap()), 13, Resultant::T);
    let mut lost = vec![];
    for tag in [21, 22, 23, 61, 63, 71, 72, 73, 74] {
        let base = definitions.sections.get(tag).unwrap();
        let aggregated = Aggregator::new(Some(base.clone()), vec![addition()]).unwrap();
        let (bare, around) = (SectionSlot::new(base.clone(), tag, 0), SectionSlot::new(Arc::new(aggregated), 9, 0));
        let own: BTreeSet<String> = words.iter().filter(|w| base.probe(&[w.as_str()]).is_some()).cloned().collect();
        compare(&format!("section {tag}"), &own, (&bare, &around), (&[], &[], false), &mut lost);
        let beside = ParallelSections::new(vec![(base.clone(), tag)]);
        let beside = SectionSlot::new(Arc::new(beside), 9, 0);
        compare(&format!("parallel {tag}"), &own, (&bare, &beside), (&["section", "1"], &[], false), &mut lost);
        for words in [["fiber", "0", "strain"], ["fiber", "0.1", "0"], ["addition", "Vy", "stress"]] {
            if base.probe(&words).is_some() && Owned::response(&bare, &words) != Owned::response(&around, &words) {
                lost.push(format!("section {tag}: {words:?}"));
            }
        }
        for parameter in
            [["E", "", ""], ["Fy", "", ""], ["alpha", "", ""], ["material", "13", "E"], ["material", "11", "Fy"]]
        {
            let words: Vec<&str> = parameter.into_iter().filter(|w| !w.is_empty()).collect();
            // The addition has parameters of the same names.
            if let Ok(own) = base.with_parameter(&words, NewValue::Present).map(|made| made.1)
                && !aggregated_has(&around, &words, own)
            {
                lost.push(format!("section {tag}: parameter {words:?}"));
            }
        }
    }
    assert!(lost.is_empty(), "{}", lost.join("\n"));
}

fn aggregated_has(around: &SectionSlot, words: &[&str], own: f64) -> bool {
    around.parameter(words) == Some(own)
}

/// Returns true if what a law of several stresses says of itself is the same, `words` standing in front of its own.
fn compare_solids<const M: usize, const N: usize>(
    name: &str,
    names: &BTreeSet<String>,
    (bare, around): (&SharedMultiaxial<M>, &dyn Multiaxial<N>),
    path: &[&str],
    lost: &mut Vec<String>,
) {
    let virgin = |len: usize, init: &dyn Fn(&mut [f64])| {
        let mut state = vec![0.0; len];
        init(&mut state);
        state
    };
    let own_state = virgin(bare.state_len(), &|s| bare.init(s));
    let state = virgin(around.state_len(), &|s| around.init(s));
    for word in names {
        let Some(own) = bare.probe(&[word.as_str()]) else { continue };
        let asked: Vec<&str> = path.iter().copied().chain([word.as_str()]).collect();
        let Some(found) = around.probe(&asked) else {
            lost.push(format!("{name}: response {word}"));
            continue;
        };
        let (mut inner, mut outer) = (vec![0.0; own.len()], vec![0.0; found.len()]);
        bare.read(&own.path, &own_state, &mut inner);
        around.read(&found.path, &state, &mut outer);
        if inner != outer || own.labels != found.labels {
            lost.push(format!("{name}: response {word} is {outer:?}, not {inner:?}"));
        }
    }
    let says = [
        ("linear", bare.is_linear() && !around.is_linear()),
        ("symmetric", !bare.is_symmetric() && around.is_symmetric()),
        ("time", bare.depends_on_time() != around.depends_on_time()),
        ("size", bare.of_length(1.0).is_some() != around.of_length(1.0).is_some()),
        ("bars", bare.reinforcement() != around.reinforcement()),
        ("columns", bare.limit_curves() != around.limit_curves()),
    ];
    lost.extend(says.iter().filter(|(_, wrong)| *wrong).map(|(what, _)| format!("{name}: {what}")));
}

#[test]
fn every_continuum_is_whole_inside_wrappers() {
    let names = quoted("crates/engine/src/material");
    let more = "uniaxialMaterial ASDConcrete1D 75 200. -fc 3. -tangent -autoRegularization 1.
        nDMaterial FSAM 76 0. 70 11 14 0.05 0.04 0.5 0.01
        nDMaterial ASDConcrete3D 77 30000. 0.2 -Te 0. 9e-5 1.5e-4 5e-3 -Ts 0. 2.7 3. 0.6 -Td 0. 0. 0. 0.96 \\
            -Ce 0. 5e-4 1e-3 2e-3 1.8e-1 -Cs 0. 15. 25. 30. 3. -Cd 0. 0. 0. 0. 0.99 -autoRegularization 100. -eta 0.1
        nDMaterial J2Plasticity 78 166.7 76.9 2. 3. 12. 3. 0.5\n";
    let definitions = definitions(Script::default(), &format!("{}{WATCHING}{more}", parts(2)));
    let mut lost = vec![];
    let family = |tag: i32| definitions.nd_materials.get(tag).unwrap().clone();
    for tag in [31, 36, 37, 40, 39, 51, 52, 77, 78] {
        let family = family(tag);
        let law = family.solid.clone().unwrap();
        let mut check = |kind: &str, around: &dyn Multiaxial<SOLID>, path: &[&str]| {
            compare_solids(&format!("{kind} {tag}"), &names, (&law, around), path, &mut lost);
        };
        let laws = || WeightedLaws(vec![(law.clone(), 1.0)]);
        let tolerance = SeriesTolerance { iterations: 10, relative: 1e-8, absolute: 1e-8 };
        let shifted = InitialStrain { law: law.clone(), strain: [0.0; SOLID] };
        // An initial strain makes no law linear.
        check("InitialStrain", &shifted, &[]);
        check("Parallel3D", &ParallelSolids { laws: laws() }, &["material", "1"]);
        check("Series3D", &SeriesSolids { laws: laws(), tolerance }, &["material", "1"]);
        for (kind, plane) in [("PlaneStrain", &family.plane_strain), ("PlaneStress", &family.plane_stress)] {
            if let Some(plane) = plane {
                compare_solids(&format!("{kind} {tag}"), &names, (&law, &**plane), &[], &mut lost);
            }
        }
        for (kind, layer) in [("layer", &family.layer)] {
            if let Some(layer) = layer {
                compare_solids(&format!("{kind} {tag}"), &names, (&law, &**layer), &[], &mut lost);
            }
        }
    }
    for tag in [35, 76] {
        let panel: SharedMultiaxial<PLANE> = family(tag).plane_stress.unwrap();
        let strip = hysteron::material::multiaxial::WallStrip::new(panel.clone(), true);
        compare_solids(&format!("WallStrip {tag}"), &names, (&panel, &strip), &[], &mut lost);
        let layer = PlateFromPlaneStress { membrane: panel.clone(), shear: 1.0 };
        compare_solids(&format!("PlateFromPlaneStress {tag}"), &names, (&panel, &layer), &[], &mut lost);
    }
    lost.retain(|l| !(l.starts_with("InitialStrain") && l.ends_with("linear")));
    assert!(lost.is_empty(), "{}", lost.join("\n"));
}

/// A bar of a layer is the bar in responses, time and watched columns, through a plate of layers too.
#[test]
fn bars_of_plates_are_whole() {
    for (name, law) in &materials(Script::default()) {
        let bar = PlateRebar::new(law.clone(), 1, 0.0);
        assert_eq!(bar.limit_curves().len(), law.limit_curves().len(), "{name}");
        assert_eq!(bar.depends_on_time(), law.depends_on_time(), "{name}");
        assert!(bar.probe(&["stress"]).is_some(), "{name}");
        let plate = LayeredPlate::stacked([(Arc::new(bar) as SharedMultiaxial<5>, 0.1)]);
        assert_eq!(plate.limit_curves().len(), law.limit_curves().len(), "{name}");
        assert_eq!(hysteron::section::plate::PlateSection::depends_on_time(&plate), law.depends_on_time(), "{name}");
    }
}
