//! The repaired script in OpenSees' standard commands, where they can say the same.
//!
//! [`TRANSLATIONS`] has one row for each kind of amendment with a standard form, [`UNTRANSLATED`] the reason for each of
//! the others. A form is materials beside those of the amended element. `script` puts them into the script. The
//! translated script is run, and kept only if its channels agree with those of the repaired model ([`MAX_ERROR_SHARE`]).

mod amendment;
mod constant_factor;
mod contact;
mod dashpot;
mod elastic_curve;
mod friction;
mod script;
mod yielding;

use crate::inspect::insertion::{InsertionPoint, inserted_block};
use crate::inspect::inventory::{Device, ModelInventory, TagPurpose};
use crate::inspect::response::{ResponseHistory, ResponseRanges};
use amendment::Amendment;
use hysteron_identify::study::{ScoredRun, ScriptSimulator, Simulator};
use hysteron_opensees::{own_commands, own_kinds};
use hysteron_tcl::top_level;
use script::{ModelParts, Placement, command_places, place, with_plain_parameters};
use std::collections::BTreeMap;

/// A kind of amendment with a standard form.
pub(crate) struct Translation {
    /// Kind of the amendment.
    kind: &'static str,
    /// Standard form, in words, as the manual has it.
    #[cfg_attr(not(test), allow(dead_code))]
    form: &'static str,
    /// True if the form depends on the stiffness of the element.
    per_element: bool,
    /// Standard forms, any of which may agree; a reason if there is none.
    make: fn(&FormInput<'_>) -> Result<Vec<StandardForm>, String>,
}

/// Kinds with a standard form.
const TRANSLATIONS: &[Translation] = &[
    contact::GAP,
    friction::FRICTION,
    friction::BRISTLES,
    dashpot::DAMPING,
    dashpot::OVERSTRESS,
    elastic_curve::STIFFENING,
    yielding::YIELDING,
    constant_factor::TEMPERATURE,
    constant_factor::AXIAL,
];

/// Kinds without one, and the effect that has no standard command.
const UNTRANSLATED: &[(&str, &str)] = &[
    ("heating", "self-heating"),
    ("degradation", "a loss of force with the energy taken in"),
    ("mullins", "softening after the first excursion"),
    ("pinching", "slack that depends on the largest deformation"),
    ("pressure", "a strength that follows the axial force"),
    ("sliding", "friction smoothed over speed"),
    ("creep", "a deformation that follows the element's own force late"),
    ("relaxation", "an overstress that relaxes with the element's own force"),
    ("slip", "slip in series with a part of the force"),
    ("cavitation", "cavitation with damage"),
    ("coupling", "one law in two directions in place of an element's own"),
    ("peakOriented", "reloading towards the largest deformation of an elastic element"),
    ("learned", "a law with memory in place of an element's own"),
    ("hinges", "a hinge within a beam"),
    ("ends", "a command that moves an element to another node"),
];

/// The same for a parameter that has another value for a time.
const CHANGED_IN_TIME: &str =
    "OpenSees changes few numbers of its laws in an analysis, and makes no law anew with its state";

/// The same for a support that a uniform excitation reaches later.
const LATE_SUPPORT: &str = "OpenSees' uniform excitation reaches all supports at one time";

/// Share of the squared error of the repaired model that the difference of the translated script may have, and the
/// difference that is accepted in any case, over the standard deviation of the recorded channel. Choices.
const MAX_ERROR_SHARE: f64 = 0.02;
const MAX_DEVIATION: f64 = 1e-3;

/// Number of tags that one amendment may use.
const TAGS_PER_AMENDMENT: i32 = 10;

/// Basis of a form: an amendment, and the elements that it amends.
pub(super) struct FormInput<'a> {
    amendment: &'a Amendment,
    inventory: &'a ModelInventory,
    responses: &'a ResponseRanges,
    first_material: i32,
}

impl FormInput<'_> {
    /// Free tag of the next material of a form.
    fn next_material(&self, form: &StandardForm) -> i32 {
        self.first_material + form.commands.len() as i32
    }

    /// Initial stiffness of the elements in a direction; `None` if there is not one for all.
    fn stiffness(&self, direction: usize) -> Option<f64> {
        let devices = self.inventory.devices.iter().filter(|d| self.amendment.tags.contains(&d.tag));
        let of = |d: &Device| d.directions.iter().find(|x| x.number == direction).map(|x| x.stiffness);
        let all: Vec<f64> = devices.map(of).collect::<Option<_>>()?;
        let first = *all.first()?;
        all.iter().all(|k| *k == first).then_some(first)
    }

    /// Histories of the amended elements in a direction.
    fn histories(&self, direction: usize) -> impl Iterator<Item = &ResponseHistory> {
        let of_elements = self.responses.histories.iter();
        let of_elements =
            of_elements.filter(move |((_, tag, d), _)| *d == direction && self.amendment.tags.contains(tag));
        of_elements.map(|(_, h)| h)
    }

    /// Largest deformation of the elements in the model as it was; 1 if none is known.
    fn deformation(&self, direction: usize) -> f64 {
        let most = self.histories(direction).map(|h| h.range().deformation).fold(0.0, f64::max);
        if most > 0.0 { most } else { 1.0 }
    }

    /// Largest speed in which the model as it was passes a deformation `sign` times `at` outwards.
    fn approach_speed(&self, direction: usize, sign: f64, at: f64) -> f64 {
        let mut speed = 0.0f64;
        for h in self.histories(direction) {
            for (t, e) in h.times.windows(2).zip(h.deformation.windows(2)) {
                if sign * e[0] < at && sign * e[1] >= at && t[1] > t[0] {
                    speed = speed.max((e[1] - e[0]).abs() / (t[1] - t[0]));
                }
            }
        }
        speed
    }
}

/// Materials that stand for an amendment.
#[derive(Clone, Debug, Default)]
pub(super) struct StandardForm {
    /// Commands that make them.
    commands: Vec<String>,
    /// Materials in parallel with those of the element.
    beside: Vec<Beside>,
    /// Tcl word of a factor on the element's own materials.
    factor: Option<String>,
}

/// A material in parallel with an element.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Beside {
    direction: usize,
    material: i32,
    /// Place of the material.
    between: Between,
}

/// Place of a material in parallel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Between {
    /// Among the materials of the element, or between its nodes.
    Any,
    /// In an element of its own between the nodes.
    Nodes,
    /// The same with the nodes in the other order.
    MirroredNodes,
}

impl StandardForm {
    fn add(&mut self, direction: usize, material: i32) {
        self.beside.push(Beside { direction, material, between: Between::Any });
    }

    fn add_between_nodes(&mut self, direction: usize, material: i32) {
        self.beside.push(Beside { direction, material, between: Between::Nodes });
    }

    fn add_mirrored(&mut self, direction: usize, material: i32) {
        self.beside.push(Beside { direction, material, between: Between::MirroredNodes });
    }
}

/// The repaired script as it was fitted, and what is known about its model.
pub(crate) struct RepairedModelScript<'a> {
    pub(crate) simulator: &'a ScriptSimulator,
    /// The user's script, and the place of insertion in it.
    pub(crate) text: &'a str,
    pub(crate) point: &'a InsertionPoint,
    /// The repaired script.
    pub(crate) repaired: &'a str,
    /// Fitted values of the study's own parameters.
    pub(crate) values: &'a [f64],
    /// Responses of the model as it was.
    pub(crate) responses: &'a ResponseRanges,
    /// Channels of the repaired model, by run.
    pub(crate) fits: &'a [Option<ScoredRun>],
}

/// The repaired script in standard commands, whose channels agree with those of the repaired model; or the reason why
/// there is none.
pub(crate) fn opensees_script(r: &RepairedModelScript<'_>) -> Result<String, String> {
    let model = r.model_parts();
    let mut best: Option<(f64, String)> = None;
    let mut reason = "its analysis has no result".to_owned();
    for choice in 0.. {
        let Some(text) = translated(r.repaired, &model, r.responses, choice)? else { break };
        let text = with_plain_parameters(&text);
        if let Some(word) = own_word(&text, r.simulator) {
            return Err(format!("{word} is no command of OpenSees"));
        }
        match r.difference(&text) {
            Ok(Difference { ratio, place }) => {
                if best.as_ref().is_none_or(|(b, _)| ratio < *b) {
                    reason = place;
                    best = Some((ratio, text));
                }
            }
            Err(e) => reason = format!("in its standard form it does not run: {e}"),
        }
    }
    match best {
        Some((ratio, text)) if ratio <= 1.0 => Ok(text),
        _ => Err(reason),
    }
}

/// Largest difference between the channels of two scripts.
struct Difference {
    /// Mean squared difference over the accepted one.
    ratio: f64,
    /// Run and channel with it, in words.
    place: String,
}

impl RepairedModelScript<'_> {
    /// Parts of the user's model at the insertion, at the fitted values.
    fn model_parts(&self) -> ModelParts {
        let end = match self.point {
            InsertionPoint::At(byte) => *byte,
            InsertionPoint::FirstAnalyze => self.text.len(),
        };
        let study = self.simulator.study().clone();
        let before = self.simulator.factory().simulator_of_script(study, &self.text[..end]);
        before.inspect_model(0, self.values, ModelParts::from_engine)
    }

    /// Difference of the observed channels of a script from those of the repaired one, in all runs.
    fn difference(&self, translated: &str) -> Result<Difference, String> {
        let study = self.simulator.study();
        let factory = self.simulator.factory();
        let mut scripts = [self.repaired, translated].map(|text| factory.simulator_of_script(study.clone(), text));
        let mut most = Difference { ratio: 0.0, place: String::new() };
        for (number, run) in study.runs.iter().enumerate() {
            let [repaired, translated] = &mut scripts;
            let Ok(expected) = repaired.simulate(number, self.values) else { continue };
            let found = translated.simulate(number, self.values).map_err(|e| e.to_string())?;
            for (k, o) in run.observe.iter().enumerate() {
                let squares = expected[k].iter().zip(&found[k]).zip(&o.values);
                let squares = squares.filter(|((a, _), v)| v.is_finite() && a.is_finite());
                let (sum, n) = squares.fold((0.0, 0.0), |(s, n), ((a, b), _)| (s + (a - b) * (a - b), n + 1.0));
                let relative = sum / (f64::max(n, 1.0) * o.variance);
                let error = self.fits[number].as_ref().map_or(0.0, |f| f.scores[k].nmse);
                let ratio = relative / (MAX_ERROR_SHARE * error).max(MAX_DEVIATION * MAX_DEVIATION);
                // A response that is not finite compares with nothing.
                if ratio.is_nan() || ratio >= most.ratio {
                    let percent = 100.0 * relative.sqrt();
                    let place = format!(
                        "{} of the run {} differs from the repaired model by {percent:.2} % of its standard deviation",
                        o.channel, run.name
                    );
                    most = Difference { ratio: if ratio.is_nan() { f64::INFINITY } else { ratio }, place };
                }
            }
        }
        Ok(most)
    }
}

/// The repaired script with the forms of one choice; `None` if no amendment has so many forms.
fn translated(
    repaired: &str,
    model: &ModelParts,
    responses: &ResponseRanges,
    choice: usize,
) -> Result<Option<String>, String> {
    let Some(block) = inserted_block(repaired) else {
        return Ok((choice == 0).then(|| repaired.to_owned()));
    };
    let body = &repaired[block.body.0..block.body.1];
    let mut values = BTreeMap::new();
    let mut placement = Placement { block, declarations: vec![], forms: vec![], rest: vec![] };
    let mut more_forms = choice == 0;
    for command in top_level(body) {
        let words: Vec<&str> = command.words.iter().map(|(a, b)| &body[*a..*b]).collect();
        let text = &body[command.start..command.end];
        match words[..] {
            ["pset", name, value] => {
                values.extend(value.parse().ok().map(|v: f64| (name.to_owned(), v)));
                placement.declarations.push(format!("set {name} {value}"));
            }
            ["amend", "node", node, "dampedAs", other] => {
                let tag = model.inventory.first_tag(TagPurpose::StandardForms) + placement.rest.len() as i32;
                let factor = other.parse::<i32>().ok().and_then(|n| model.mass_damping.get(&n)).copied().unwrap_or(0.0);
                placement.rest.push(format!("region {tag} -node {node} -rayleigh {factor:?} 0.0 0.0 0.0"));
            }
            ["amend", "node", ..] => return Err(LATE_SUPPORT.to_owned()),
            ["amend", "parameter", ..] => return Err(CHANGED_IN_TIME.to_owned()),
            ["if", ..] if text.contains("{amend parameter ") => return Err(CHANGED_IN_TIME.to_owned()),
            ["amend", ..] => {
                let amendment = Amendment::parse(&words, &values).ok_or_else(|| format!("{text} names no elements"))?;
                for (amendment, forms) in standard_forms(&amendment, model, responses, placement.forms.len())? {
                    more_forms |= choice < forms.len();
                    let form = forms.get(choice).or(forms.last()).ok_or("there is no standard form")?;
                    placement.forms.push((amendment, form.clone()));
                }
            }
            // Forms depend on the variables that these set.
            ["set" | "switch", ..] => placement.declarations.push(text.to_owned()),
            _ => placement.rest.push(text.to_owned()),
        }
    }
    if !more_forms {
        return Ok(None);
    }
    place(repaired, &placement, model).map(Some)
}

/// Standard forms of an amendment, of each of its elements alone where they depend on it.
fn standard_forms(
    amendment: &Amendment,
    model: &ModelParts,
    responses: &ResponseRanges,
    before: usize,
) -> Result<Vec<(Amendment, Vec<StandardForm>)>, String> {
    if let Some((_, effect)) = UNTRANSLATED.iter().find(|(kind, _)| *kind == amendment.kind) {
        return Err(format!("{effect} has no standard command in OpenSees"));
    }
    let translation = TRANSLATIONS.iter().find(|t| t.kind == amendment.kind);
    let translation = translation.ok_or_else(|| format!("{} has no standard command in OpenSees", amendment.kind))?;
    let parts: Vec<Amendment> = match translation.per_element {
        true => amendment.tags.iter().map(|tag| amendment.of_element(*tag)).collect(),
        false => vec![amendment.clone()],
    };
    let first = model.inventory.first_tag(TagPurpose::StandardForms);
    let of = |(i, part): (usize, Amendment)| {
        let first_material = first + TAGS_PER_AMENDMENT * (before + i) as i32;
        let input = FormInput { amendment: &part, inventory: &model.inventory, responses, first_material };
        let forms = (translation.make)(&input)?;
        Ok((part, forms))
    };
    parts.into_iter().enumerate().map(of).collect()
}

/// The first command or kind of hysteron's own in a script and in those that it reads.
fn own_word(text: &str, simulator: &ScriptSimulator) -> Option<&'static str> {
    let study = simulator.study();
    let model = study.absolute(&study.model);
    let read = simulator.files_read().into_iter().filter(|(path, _)| path.ends_with(".tcl") && *path != model);
    let texts: Vec<String> = std::iter::once(text.to_owned()).chain(read.map(|(_, text)| text)).collect();
    let lines = || texts.iter().flat_map(|text| text.lines()).filter(|line| !line.trim_start().starts_with('#'));
    let command = |word: &&str| lines().any(|line| command_places(line, word).next().is_some());
    let kind = |word: &&str| lines().any(|line| line.split_whitespace().any(|w| w == *word));
    own_commands().find(command).or_else(|| own_kinds().find(kind))
}

#[cfg(test)]
mod tests;
