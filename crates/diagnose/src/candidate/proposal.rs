//! A proposal: an edit of the script or a fault of a channel, with its parameters.

use super::channel_fault::ChannelFault;
use crate::inspect::insertion::InsertionPoint;
use hysteron_identify::study::{ParameterRange, Scale};
use std::fmt;
use std::sync::Arc;

/// A parameter that a proposal adds to the study.
#[derive(Clone, Debug)]
pub(crate) struct AddedParameter {
    /// Name in the script.
    pub(crate) name: String,
    /// Range of the search.
    pub(crate) range: ParameterRange,
    /// Start of the search.
    pub(crate) start: f64,
    /// Further values that are tried while the other parameters stay at their start, because evenly spread points would
    /// miss narrow minima.
    pub(crate) further_starts: Vec<f64>,
    /// True if the parameter belongs to a channel fault, which the script does not contain.
    pub(crate) of_channel_fault: bool,
}

impl AddedParameter {
    /// A parameter on a linear scale.
    pub(crate) fn linear(name: &str, lower: f64, upper: f64, start: f64) -> Self {
        Self::new(name, ParameterRange { lower, upper, scale: Scale::Linear }, start)
    }

    /// A parameter on a logarithmic scale.
    pub(crate) fn log(name: &str, lower: f64, upper: f64, start: f64) -> Self {
        Self::new(name, ParameterRange { lower, upper, scale: Scale::Log }, start)
    }

    fn new(name: &str, range: ParameterRange, start: f64) -> Self {
        Self { name: format!("hy_{name}"), range, start, further_starts: vec![], of_channel_fault: false }
    }
}

/// Channel faults as a function of the values of the added parameters.
pub(crate) type FaultModel = Arc<dyn Fn(&[f64]) -> Vec<ChannelFault> + Send + Sync>;

/// Replacement of a byte range of the user's script.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct TextEdit {
    /// First byte.
    pub(crate) start: usize,
    /// Byte after the last.
    pub(crate) end: usize,
    /// New text.
    pub(crate) text: String,
}

/// A phenomenon of a whole law, and the values of parameters at which it is absent.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Switch {
    /// The phenomenon, in words.
    pub(crate) phenomenon: &'static str,
    /// Cause that it is an effect of; none where the library has no name for it.
    pub(crate) cause: Option<&'static str>,
    /// Names of parameters with the values that switch it off.
    pub(crate) neutral: Vec<(String, f64)>,
}

/// A law in the place of that of a device.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct WholeLawParts {
    /// Phenomena that can be switched off.
    pub(crate) switches: Vec<Switch>,
    /// Behaviour that is left without them, in words.
    pub(crate) basis: &'static str,
}

/// Course of another value of a parameter in time.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Course {
    /// It holds between the times.
    #[default]
    Step,
    /// It is reached on a ramp between the times, and holds.
    Ramp,
    /// It is there at the first time, and back at the usual one on a ramp up to the second.
    Recovery,
}

/// Other values of the user's parameters, by the names of the added parameters.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct ChangedCondition {
    /// The run; none if there is one alone.
    pub(crate) run: Option<String>,
    /// Runs held out that follow the other values too.
    pub(crate) also_in: Vec<String>,
    /// The user's parameters with the factors on them.
    pub(crate) factors: Vec<(String, String)>,
    /// Time from which they hold, or at which a ramp begins; none for the beginning.
    pub(crate) from: Option<String>,
    /// Time up to which they hold, or at which a ramp ends; none for the end.
    pub(crate) to: Option<String>,
    pub(crate) course: Course,
}

/// An edit of the script, or a fault of a channel.
#[derive(Clone)]
pub(crate) struct Proposal {
    /// Cause of the effect.
    pub(crate) cause: &'static str,
    /// Cause of a second effect.
    pub(crate) second_cause: Option<&'static str>,
    /// Form of the effect, in words.
    pub(crate) form: String,
    /// Part of the model or channel that it changes, in words.
    pub(crate) location: String,
    /// The same of a second effect; empty without one.
    pub(crate) second_location: String,
    /// Commands, without the declarations of the parameters.
    pub(crate) commands: Vec<String>,
    /// Edits of the commands of devices.
    pub(crate) option_edits: Vec<TextEdit>,
    /// First byte of the command in front of which parameters are declared; none if the added commands declare them.
    pub(crate) declared_at: Option<usize>,
    /// Added parameters. The first one names the mechanism: forms of a cause with another first parameter are searched apart.
    pub(crate) parameters: Vec<AddedParameter>,
    /// Faults of channels.
    pub(crate) fault_model: Option<FaultModel>,
    /// Parts of the law that replaces that of a device; none for other effects.
    pub(crate) whole_law: Option<WholeLawParts>,
    /// Other values of the user's parameters; none for other effects.
    pub(crate) condition: Option<ChangedCondition>,
    /// The user's parameters that the replaced law alone has read, by their index in the study.
    pub(crate) unread: Vec<usize>,
    /// True if the effect follows from geometry, not from a form of law. Its residual must not recur along the stroke.
    pub(crate) geometric: bool,
    /// True if the effect is a part of the structure, without which the model moves quite differently. Fits from the user's values
    /// miss it.
    pub(crate) is_missing_part: bool,
    /// Cause of which a form at the same place is the same model: what is seen above it does not tell them apart.
    pub(crate) same_model: Option<&'static str>,
    /// True if the recording shows the effect by itself, whatever the model.
    pub(crate) visible_in_recording: bool,
}

impl fmt::Debug for Proposal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} ({}) at {}: {:?} {:?}", self.cause, self.form, self.location, self.commands, self.parameters)
    }
}

impl ChangedCondition {
    /// Returns true if the values hold in a whole run.
    pub(crate) fn is_of_whole_run(&self) -> bool {
        self.run.is_some() && self.from.is_none() && self.to.is_none() && self.course == Course::Step
    }

    /// The same with other names of the added parameters.
    fn renamed(&self, rename: impl Fn(&str) -> String) -> Self {
        Self {
            run: self.run.clone(),
            also_in: self.also_in.clone(),
            factors: self.factors.iter().map(|(own, added)| (own.clone(), rename(added))).collect(),
            from: self.from.as_deref().map(&rename),
            to: self.to.as_deref().map(&rename),
            course: self.course,
        }
    }
}

impl Proposal {
    /// An edit of the script.
    pub(crate) fn script_edit(
        cause: &'static str,
        form: &str,
        location: String,
        commands: Vec<String>,
        parameters: Vec<AddedParameter>,
    ) -> Self {
        Self {
            cause,
            second_cause: None,
            form: form.into(),
            location,
            second_location: String::new(),
            commands,
            option_edits: vec![],
            declared_at: None,
            parameters,
            fault_model: None,
            whole_law: None,
            condition: None,
            unread: vec![],
            geometric: false,
            is_missing_part: false,
            same_model: None,
            visible_in_recording: false,
        }
    }

    /// Both effects together. Parameters of the second get the prefix `hy2_`.
    pub(crate) fn combined_with(&self, second: &Self) -> Self {
        let renamed = |text: &str| text.replace("hy_", "hy2_");
        let mut both = self.clone();
        both.geometric &= second.geometric;
        both.visible_in_recording |= second.visible_in_recording;
        both.second_cause = Some(second.cause);
        both.second_location.clone_from(&second.location);
        both.form = format!("{}; {}", self.form, second.form);
        both.commands.extend(second.commands.iter().map(|l| renamed(l)));
        let edits = second.option_edits.iter();
        both.option_edits.extend(edits.map(|e| TextEdit { text: renamed(&e.text), ..e.clone() }));
        both.unread.extend(second.unread.iter().filter(|i| !self.unread.contains(i)));
        both.whole_law = match (self.whole_law.clone(), second.whole_law.clone()) {
            (None, Some(mut parts)) => {
                let names = parts.switches.iter_mut().flat_map(|s| &mut s.neutral);
                names.for_each(|(name, _)| *name = renamed(name));
                Some(parts)
            }
            (first, _) => first,
        };
        both.condition = self.condition.clone().or_else(|| second.condition.as_ref().map(|c| c.renamed(renamed)));
        both.declared_at = self.declared_at.into_iter().chain(second.declared_at).min();
        let parameters = second.parameters.iter();
        both.parameters.extend(parameters.map(|a| AddedParameter { name: renamed(&a.name), ..a.clone() }));
        let n = self.parameters.len();
        both.fault_model = match (self.fault_model.clone(), second.fault_model.clone()) {
            (None, None) => None,
            (first, second) => Some(Arc::new(move |values: &[f64]| {
                let (a, b) = values.split_at(n);
                let faults = |f: &Option<FaultModel>, v: &[f64]| f.as_ref().map_or_else(Vec::new, |f| f(v));
                let mut all = faults(&first, a);
                all.extend(faults(&second, b));
                all
            })),
        };
        both
    }

    /// The proposal without a phenomenon: its parameters have their neutral values and are none of the fit.
    pub(crate) fn without(&self, switch: &Switch) -> Self {
        let mut out = self.clone();
        for (name, value) in &switch.neutral {
            let value = format!("{value:?}");
            let texts = out.option_edits.iter_mut().map(|e| &mut e.text).chain(&mut out.commands);
            texts.for_each(|t| *t = with_constant(t, name, &value));
        }
        out.parameters.retain(|a| switch.neutral.iter().all(|(name, _)| *name != a.name));
        out
    }

    /// Number of times at which a parameter of the user's changes.
    pub(crate) fn change_points(&self) -> usize {
        let condition = self.condition.as_ref();
        condition.map_or(0, |c| usize::from(c.from.is_some()) + usize::from(c.to.is_some()))
    }

    /// Returns true if the proposal changes the script, not only its channels.
    pub(crate) fn edits_script(&self) -> bool {
        !self.commands.is_empty() || !self.option_edits.is_empty()
    }

    /// Returns false if two edits change the same words, or if commands inside a procedure need parameters from outside.
    pub(crate) fn is_consistent(&self, point: &InsertionPoint) -> bool {
        let mut edits: Vec<&TextEdit> = self.option_edits.iter().collect();
        edits.sort_by_key(|e| (e.start, e.end));
        let apart = edits.windows(2).all(|w| w[0].end <= w[1].start);
        let deferred = *point == InsertionPoint::FirstAnalyze;
        apart && (self.declared_at.is_none() || self.commands.is_empty() || !deferred)
    }

    /// Declarations of the parameters at `values`.
    pub(crate) fn declarations(&self, values: &[f64]) -> Vec<String> {
        let of_the_model = self.parameters.iter().zip(values).filter(|(a, _)| !a.of_channel_fault);
        of_the_model.map(|(a, v)| format!("pset {} {v:?}", a.name)).collect()
    }

    /// The commands, preceded by declarations unless these stand before the command of a device.
    pub(crate) fn inserted_commands(&self, values: &[f64]) -> Vec<String> {
        let declarations = if self.declared_at.is_some() { vec![] } else { self.declarations(values) };
        declarations.into_iter().chain(self.commands.iter().cloned()).collect()
    }
}

/// A text in which a number stands in the place of a global variable.
fn with_constant(text: &str, name: &str, value: &str) -> String {
    let mut out = String::new();
    let mut rest = text;
    let variable = format!("$::{name}");
    while let Some(at) = rest.find(&variable) {
        let (before, after) = (&rest[..at], &rest[at + variable.len()..]);
        let whole = !after.starts_with(|c: char| c.is_alphanumeric() || c == '_');
        out += before;
        out += if whole { value } else { &variable };
        rest = after;
    }
    out + rest
}

#[cfg(test)]
mod tests {
    use super::{Switch, with_constant};
    use crate::test_support::script_edit;

    #[test]
    fn a_constant_replaces_a_variable_of_this_name_alone() {
        let text = "Law 1 $::hy_a [expr {2*$::hy_a}] $::hy_ab $::hy_b";
        assert_eq!(with_constant(text, "hy_a", "0.5"), "Law 1 0.5 [expr {2*0.5}] $::hy_ab $::hy_b");
    }

    #[test]
    fn a_phenomenon_that_is_switched_off_has_no_parameters() {
        let switch = Switch { phenomenon: "one", cause: None, neutral: vec![("hy_one".into(), 0.0)] };
        let without = script_edit("friction", &["one", "two"]).without(&switch);
        let names: Vec<&str> = without.parameters.iter().map(|a| a.name.as_str()).collect();
        assert_eq!(names, ["hy_two"]);
    }
}
