//! The verdict for readers without statistics: one template of the terminal, the report and the result file.

use super::advice::{measurement, shorter_step, unrecorded};
use super::condition_in_words::FittedCondition;
use super::explanation::unsteady_in_words;
use super::fault_in_words::{cause_of, fault_in_words, unit_of};
use super::gain::gain;
use super::place::{Place, places};
use super::plausibility::{beyond_fitted_amplitude, contradictions, parameters_that_leave_bounds};
use super::quantity::{EffectSize, Units, digits, effect_size};
use super::recorded_quantities::RecordedQuantities;
use super::residual_force::ResidualForce;
use super::result_file::{Baseline, Candidate, Mismatch, RepairedModel};
use crate::candidate::variant::Variant;
use crate::fit::step_error::StepError;
use crate::hypothesis;
use crate::hypothesis::changed_condition;
use crate::inspect::inventory::ModelInventory;
use crate::inspect::response::ResponseRange;
use hysteron_identify::calibrate::{NoiseComparison, Uncertainty};
use hysteron_identify::study::Study;
use serde::Serialize;
use std::fmt::Write as _;

/// The verdict in words, part by part. A part that does not apply is empty.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Summary {
    /// The missing effect in plain words, with the name of its cause in parentheses.
    pub what: String,
    /// Place of the effect, and the time at which the recordings show it.
    #[serde(rename = "where")]
    pub location: String,
    /// Sizes of the effect, with units and 95 % intervals where they are known.
    pub how_big: String,
    /// Probability, and its meaning.
    pub how_sure: String,
    /// Other causes with their probabilities.
    pub what_else: String,
    /// Errors before and after the repair.
    pub gain: String,
    /// Balances and published ranges that contradict the repair, and parameters of the user that leave their bounds by it.
    pub checks: Vec<String>,
    /// Next steps, the most useful first.
    pub what_next: Vec<String>,
    /// Places of the effects.
    pub places: Vec<Place>,
    /// Sizes of the effects.
    pub sizes: Vec<EffectSize>,
}

/// Basis of a summary.
pub(super) struct SummaryContext<'a> {
    pub(super) study: &'a Study,
    pub(super) script: &'a str,
    pub(super) inventory: &'a ModelInventory,
    /// The verdict, its probability, and the other causes.
    pub(super) verdict: (&'a str, f64),
    /// Causes of further effects: of a second one, and of parts of a law in the place of the user's.
    pub(super) also: &'a [String],
    pub(super) also_possible: &'a [Candidate],
    /// Variant of the repair, its values, and their uncertainty.
    pub(super) variant: &'a Variant,
    pub(super) values: &'a [f64],
    pub(super) uncertainty: Option<&'a Uncertainty>,
    pub(super) baseline: &'a Baseline,
    pub(super) corrected: &'a RepairedModel,
    pub(super) mismatch: &'a [Mismatch],
    /// Numbers of forms and causes that were tried.
    pub(super) tried: (usize, usize),
    /// Structure of the rest, in words; empty for none.
    pub(super) structure: &'a str,
    /// Kind of memory of the device, in words; none where none stands out.
    pub(super) memory: Option<String>,
    /// Effect that takes most of the error away without being likely, in words; none where none does, or it is the repair.
    pub(super) nearest: Option<String>,
    /// Channels with unsteady noise.
    pub(super) unsteady_channels: &'a [String],
    /// Forces that the user's model lacks, the largest first; empty unless the cause is unknown.
    pub(super) residual_forces: &'a [ResidualForce],
    /// Names of the observed columns by run.
    pub(super) columns: &'a [Vec<String>],
    pub(super) step_error: &'a StepError,
    /// Number of steps that the script makes in the first run, if it was counted.
    pub(super) script_steps: Option<usize>,
    /// Range of the device that does the most work, over all fitted runs; none without devices.
    pub(super) largest_work: Option<ResponseRange>,
    /// Recommended test or recording, in words; empty for none.
    pub(super) test: &'a str,
}

impl SummaryContext<'_> {
    /// True if earthquakes excite the structure, and no rig could repeat them.
    fn is_building(&self) -> bool {
        self.inventory.base_excited && self.study.rig.is_none()
    }

    fn recorded_quantities(&self) -> RecordedQuantities<'_> {
        RecordedQuantities { study: self.study, inventory: self.inventory, columns: self.columns }
    }
}

/// The summary of a verdict.
pub(super) fn summary(c: &SummaryContext<'_>) -> Summary {
    match c.verdict.0 {
        "none" => of_none(c),
        "unknown" => of_unknown(c),
        _ => of_cause(c),
    }
}

fn of_none(c: &SummaryContext<'_>) -> Summary {
    let after =
        c.baseline.holdout_nmse.map_or_else(String::new, |h| format!(", and {} of the runs held out", variance(h)));
    // The judgement of a calibration holds here as well: it decides whether the fit explains the recordings.
    let judgement = c.uncertainty.map(|u| &u.judgement);
    let is_explained = judgement.is_none_or(|j| j.explained);
    let what = if is_explained {
        "Your model explains the recordings (none)."
    } else {
        "No effect of the library improves your model (none). That it is complete is not shown."
    };
    let noise = judgement.and_then(|j| j.noise).map_or_else(String::new, |n| noise_in_words(c.baseline.fit_nmse, &n));
    let reasons = match judgement.filter(|_| !is_explained) {
        Some(j) => j.reasons().join("; "),
        None => "the remaining error looks like noise".into(),
    };
    let unsteady = (!c.unsteady_channels.is_empty()).then(|| unsteady_in_words(c.unsteady_channels));
    let checks = unsteady.iter().map(|s| s.trim_end_matches('.').to_owned()).collect();
    Summary {
        what: what.into(),
        checks,
        how_sure: format!("{}: {reasons}.", percent(c.verdict.1)),
        what_else: others(c),
        gain: format!("The fitted model misses {} of the fitted runs{after}.{noise}", variance(c.baseline.fit_nmse)),
        ..Summary::default()
    }
}

/// The noise of the recordings after an error. An estimate above the error is no more than a limit of the noise.
fn noise_in_words(error: f64, noise: &NoiseComparison) -> String {
    if noise.noise > error {
        return " The noise of the recordings is no larger than that.".into();
    }
    let of_held_out = |h| format!(", and {} of the runs held out", variance(h));
    let held_out = noise.holdout_noise.map_or_else(String::new, of_held_out);
    format!(" The noise of the recordings is {} of the fitted runs{held_out}.", variance(noise.noise))
}

fn of_unknown(c: &SummaryContext<'_>) -> Summary {
    let what = match &c.memory {
        Some(memory) => {
            format!("Something is missing that no effect of the library explains (unknown). Most likely {memory}.")
        }
        None if c.structure.is_empty() => {
            "The recordings do not decide between noise and a missing effect (unknown).".into()
        }
        None => "Something is missing that no effect of the library explains (unknown).".into(),
    };
    let mut location = where_it_shows(c);
    if !c.structure.is_empty() {
        let _ = write!(location, " Structure of the rest: {}.", c.structure);
    }
    for sentence in c.residual_forces.first().iter().flat_map(|f| &f.text) {
        let _ = write!(location, " {sentence}");
    }
    let (forms, causes) = c.tried;
    let mut tried = format!("{forms} forms of {causes} causes were tried.");
    if let Some(h) = hypothesis::of(c.variant.cause()) {
        let share = c.corrected.fit_nmse / c.baseline.fit_nmse.max(f64::MIN_POSITIVE);
        let place = c.variant.proposal.as_ref().map_or("", |p| p.location.as_str());
        let _ = write!(tried, " The nearest, {} at {place}, leaves {} of the squared error.", h.cause, percent(share));
    }
    if let Some(nearest) = &c.nearest {
        let _ = write!(tried, " {nearest}.");
    }
    let channel = c.mismatch.first().map_or_else(|| "the channel with the largest error".to_owned(), channel_in_words);
    let repetition = if c.is_building() {
        format!(
            "see whether another recording at hand has the same error, and put a second instrument beside {channel}"
        )
    } else {
        "repeat a run unchanged: what repeats is missing in the model, what does not is noise".into()
    };
    let mut next = vec![repetition];
    next.extend(unrecorded(&c.recorded_quantities()));
    next.extend(steps(c));
    Summary {
        what,
        location,
        how_big: format!("The fitted model misses {} of the fitted runs. {tried}", variance(c.baseline.fit_nmse)),
        how_sure: format!("{}: {}", percent(c.verdict.1), meaning(c.verdict.1)),
        what_else: others(c),
        gain: String::new(),
        what_next: next,
        ..Summary::default()
    }
}

fn of_cause(c: &SummaryContext<'_>) -> Summary {
    let units = Units::of(c.study, c.script);
    let mut places = places(c.variant, c.inventory);
    let condition = FittedCondition::of(c.variant, c.values);
    let is_second = usize::from(c.variant.cause() != changed_condition::CAUSE);
    if let Some((_, place)) = places.get_mut(is_second) {
        place.span = condition.as_ref().and_then(FittedCondition::span);
    }
    let described: Vec<String> = places.iter().map(|(location, p)| p.description(location, c.study, &units)).collect();
    let sizes = sizes(c, &units, &places);
    // What the recordings hardly determine is left to the list of sizes.
    let named = |determined: bool| sizes.iter().filter(move |s| s.determined || !determined).map(|s| s.text.clone());
    let mut in_words: Vec<String> = named(true).collect();
    if in_words.is_empty() {
        in_words = named(false).collect();
    }
    let nowhere = (String::new(), Place::default());
    let (location, place) = places.first().unwrap_or(&nowhere);
    let mut next = vec![];
    if !c.test.is_empty() {
        next.push(c.test.to_owned());
    }
    next.extend(measurement(c.verdict.0, location, place, c.is_building(), &c.recorded_quantities()));
    next.extend(condition.as_ref().map(FittedCondition::needed));
    // A shorter step is for the script; what tells causes apart comes first.
    next.extend(steps(c));
    Summary {
        what: what(c),
        location: format!("{}. {}", capitalised(&described.join("; and ")), where_it_shows(c)),
        how_big: in_words.join(", "),
        how_sure: format!("{}: {}", percent(c.verdict.1), meaning(c.verdict.1)),
        what_else: others(c),
        gain: gain(c),
        checks: contradictions(c)
            .into_iter()
            .chain(parameters_that_leave_bounds(c))
            .chain(beyond_fitted_amplitude(c.study))
            .collect(),
        what_next: next,
        places: places.into_iter().map(|(_, place)| place).collect(),
        sizes,
    }
}

/// The effect in words with the names of its causes, and the form of its model.
fn what(c: &SummaryContext<'_>) -> String {
    let causes = std::iter::once(c.verdict.0).chain(c.also.iter().map(String::as_str));
    let sentences: Vec<String> = causes
        .map(|cause| {
            let faults: Vec<String> = c
                .corrected
                .channels
                .iter()
                .filter(|f| cause_of(f) == Some(cause))
                .take(2)
                .map(|f| fault_in_words(f, unit_of(c.study, &f.channel)))
                .collect();
            let statement = hypothesis::of(cause).map_or(cause, |h| h.statement);
            let condition = FittedCondition::of(c.variant, c.values).filter(|_| cause == changed_condition::CAUSE);
            let words = match condition {
                Some(condition) => format!("{statement}: {}", condition.description()),
                None if faults.is_empty() => statement.to_owned(),
                None => faults.join("; "),
            };
            format!("{words} ({cause})")
        })
        .collect();
    let form = c.variant.proposal.as_ref().filter(|_| c.variant.edits_script()).map(|p| p.form.as_str());
    let form = form.map_or_else(String::new, |f| format!(" It is modelled as: {f}."));
    format!("{}.{form}", capitalised(&sentences.join(". Also: ")))
}

/// Sizes of the added parameters, of the first effect and then of the second.
fn sizes(c: &SummaryContext<'_>, units: &Units, places: &[(String, Place)]) -> Vec<EffectSize> {
    let Some(p) = &c.variant.proposal else { return vec![] };
    let added = c.variant.split(c.values).1;
    let size = |(a, value): (&crate::candidate::proposal::AddedParameter, &f64)| {
        let is_second = a.name.starts_with("hy2_");
        let cause = if is_second { p.second_cause.unwrap_or(p.cause) } else { p.cause };
        let parts = places.get(usize::from(is_second)).map_or(1, |(_, place)| place.parallel_parts);
        let interval = c.uncertainty.and_then(|u| u.intervals.iter().find(|i| i.name == a.name));
        effect_size(cause, &a.name, *value, interval, units, parts)
    };
    p.parameters.iter().zip(added).filter_map(size).collect()
}

/// Steps that come before any measurement: a shorter time step.
fn steps(c: &SummaryContext<'_>) -> Vec<String> {
    shorter_step(c.step_error, c.study, c.script_steps).into_iter().collect()
}

fn channel_in_words(m: &Mismatch) -> String {
    if m.at.is_empty() { m.channel.clone() } else { format!("{} ({})", m.channel, m.at) }
}

/// Windows that a sentence lists, at most.
pub(super) const MAX_WINDOWS: usize = 2;

/// The longest windows of time in their order, in words; empty without any.
pub(super) fn longest_windows(windows: &[[f64; 2]]) -> String {
    let length = |w: &&[f64; 2]| w[1] - w[0];
    let mut longest: Vec<&[f64; 2]> = windows.iter().collect();
    longest.sort_by(|a, b| length(b).total_cmp(&length(a)));
    longest.truncate(MAX_WINDOWS);
    longest.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let words = |w: &&[f64; 2]| format!("{} to {} s", digits(w[0], 3), digits(w[1], 3));
    longest.iter().map(words).collect::<Vec<_>>().join(" and ")
}

/// Channel, run and time with the largest error of the user's model.
fn where_it_shows(c: &SummaryContext<'_>) -> String {
    let Some(m) = c.mismatch.first() else { return String::new() };
    let windows = longest_windows(&m.windows);
    let at = if windows.is_empty() { String::new() } else { format!(" at {windows}") };
    format!("It shows most in {} of run {}{at}, {}.", channel_in_words(m), m.run, m.regime)
}

/// A share in per cent for readers: whole numbers, with more digits below one per cent.
pub(super) fn percent(share: f64) -> String {
    let p = 100.0 * share;
    match p {
        p if p > 99.0 && p < 100.0 => "more than 99 %".into(),
        p if p >= 1.0 => format!("{p:.0} %"),
        p => format!("{} %", digits(p, 2)),
    }
}

/// An NMSE as a share of the recorded variance.
pub(super) fn variance(nmse: f64) -> String {
    let p = 100.0 * nmse;
    format!("{} % of the variance", if p >= 10.0 { format!("{p:.0}") } else { digits(p, 2) })
}

/// Meaning of a probability. A verdict that is written as 95 % counts as nearly certain.
fn meaning(p: f64) -> &'static str {
    if p >= 0.945 {
        "nearly certain among the causes that the library knows."
    } else if p >= 0.8 {
        "well supported; one in five to twenty of such verdicts may be wrong."
    } else if p >= 0.5 {
        "the best guess; another cause remains possible."
    } else {
        "a weak guess; do not rely on it without a further recording."
    }
}

/// Other causes that are listed, at most.
const MAX_OTHERS: usize = 3;
/// Least probability of another cause that is listed.
const MIN_LISTED: f64 = 0.01;

/// Other possible causes with their probabilities and the beginning of their statements; empty for none.
fn others(c: &SummaryContext<'_>) -> String {
    let words = |cause: &str| match cause {
        "none" => "nothing is missing".to_owned(),
        "unknown" => "something outside the library".to_owned(),
        cause => {
            let statement = hypothesis::of(cause).map_or("", |h| h.statement);
            statement.split([':', '(', ';', ',']).next().unwrap_or_default().trim().to_owned()
        }
    };
    // What is named beside the first effect is no other answer.
    let is_other = |o: &&Candidate| o.confidence >= MIN_LISTED && !c.also.contains(&o.cause);
    let listed = c.also_possible.iter().filter(is_other).take(MAX_OTHERS);
    let listed: Vec<String> =
        listed.map(|o| format!("{} {} ({})", o.cause, percent(o.confidence), words(&o.cause))).collect();
    if listed.is_empty() { String::new() } else { format!("{}.", listed.join(", ")) }
}

fn capitalised(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

impl Summary {
    /// Parts that apply, each with its heading, after [`Summary::what`].
    pub fn parts(&self) -> Vec<(&'static str, String)> {
        let next = match &self.what_next[..] {
            [one] => format!("{}.", capitalised(one)),
            several => {
                let numbered = several.iter().enumerate().map(|(i, s)| format!("({}) {}.", i + 1, capitalised(s)));
                numbered.collect::<Vec<_>>().join(" ")
            }
        };
        let big = if self.how_big.ends_with('.') || self.how_big.is_empty() {
            self.how_big.clone()
        } else {
            format!("{}.", capitalised(&self.how_big))
        };
        let checks: Vec<String> = self.checks.iter().map(|s| format!("{}.", capitalised(s))).collect();
        let all = [
            ("Where", self.location.clone()),
            ("How big", big),
            ("Check", checks.join(" ")),
            ("How sure", self.how_sure.clone()),
            ("Or else", self.what_else.clone()),
            (if self.what_next.is_empty() { "Error" } else { "Gain" }, self.gain.clone()),
            ("Next", next),
        ];
        all.into_iter().filter(|(_, text)| !text.is_empty()).collect()
    }

    /// The whole template as lines of at most `width` letters.
    pub fn text(&self, width: usize) -> String {
        let mut out = wrapped(&self.what, width, 0);
        out.push('\n');
        for (heading, text) in self.parts() {
            let lines = wrapped(&text, width, HEADING_WIDTH);
            let _ = write!(out, "{heading:<HEADING_WIDTH$}{}", lines.trim_start());
        }
        out
    }
}

/// Width of the column of headings.
const HEADING_WIDTH: usize = 10;

/// A text in lines of at most `width` letters that begin with `indent` spaces. A number keeps its unit on its line.
fn wrapped(text: &str, width: usize, indent: usize) -> String {
    let (mut out, mut line) = (String::new(), String::new());
    let words: Vec<&str> = text.split(' ').filter(|w| !w.is_empty()).collect();
    let binds = |a: &str, b: &str| {
        a.ends_with(|c: char| c.is_ascii_digit()) && b.chars().next().is_some_and(|c| "%±".contains(c)) || a == "±"
    };
    let mut begin = 0;
    while begin < words.len() {
        let mut end = begin + 1;
        while end < words.len() && binds(words[end - 1], words[end]) {
            end += 1;
        }
        let word = words[begin..end].join(" ");
        if !line.is_empty() && indent + line.chars().count() + 1 + word.chars().count() > width {
            let _ = writeln!(out, "{:indent$}{line}", "");
            line.clear();
        }
        if !line.is_empty() {
            line.push(' ');
        }
        line += &word;
        begin = end;
    }
    let _ = writeln!(out, "{:indent$}{line}", "");
    out
}

#[cfg(test)]
mod tests {
    use super::{NoiseComparison, Summary, noise_in_words, wrapped};
    use hysteron_identify::noise::NoiseEvidence;

    #[test]
    fn an_estimate_of_the_noise_above_the_error_is_a_limit() {
        let of = |noise| {
            let evidence = NoiseEvidence::Innovations;
            noise_in_words(0.002, &NoiseComparison { nmse: 0.002, noise, holdout_noise: Some(0.001), evidence })
        };
        assert_eq!(of(0.003), " The noise of the recordings is no larger than that.");
        assert!(of(0.0015).contains("0.15 %") && of(0.0015).contains("runs held out"), "{}", of(0.0015));
    }

    #[test]
    fn lines_are_no_longer_than_the_width() {
        let text = wrapped("gap 130 mm ± 2, stiffness of the wall 54 MN/m ± 3", 24, 4);
        assert_eq!(text, "    gap 130 mm ± 2,\n    stiffness of the\n    wall 54 MN/m ± 3\n");
        assert!(text.lines().all(|l| l.chars().count() <= 24));
    }

    #[test]
    fn parts_that_do_not_apply_are_left_out() {
        let s = Summary { what: "A.".into(), how_sure: "90 %: b.".into(), gain: "c.".into(), ..Summary::default() };
        assert_eq!(s.text(80), "A.\n\nHow sure  90 %: b.\nError     c.\n");
        let s = Summary { what_next: vec!["look".into(), "measure".into()], ..s };
        assert!(s.text(80).ends_with("Gain      c.\nNext      (1) Look. (2) Measure.\n"), "{}", s.text(80));
    }
}
