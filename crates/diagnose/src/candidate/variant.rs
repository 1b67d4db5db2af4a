//! A study with a proposal in it: the edited script, all parameters, and the faults of its channels.

use super::channel_fault::ChannelFault;
use super::proposal::Proposal;
use super::repaired_script::edited_script;
use crate::inspect::auxiliary_channels::auxiliary_log_odds;
use crate::inspect::insertion::InsertionPoint;
use crate::prior::{CHANGE_POINT_PARAMETERS, VISIBLE_FAULT_LOG_ODDS};
use hysteron_identify::study::{
    Parameter, ParameterKind, ParameterSpace, Role, ScriptSimulator, SimulationError, Simulator, SimulatorFactory,
    Study,
};
use std::sync::Arc;

/// A study changed by a proposal, or the study as it is.
#[derive(Clone, Debug)]
pub(crate) struct Variant {
    /// The study; its parameters are the user's own followed by those of the proposal.
    pub(crate) study: Arc<Study>,
    /// Text of the script.
    pub(crate) text: Arc<str>,
    /// The proposal; none for the baseline.
    pub(crate) proposal: Option<Proposal>,
    /// Number of the user's own parameters.
    own_parameters: usize,
    /// Log odds that auxiliary channels give to the proposal, nats.
    auxiliary_log_odds: f64,
}

impl Variant {
    /// The study as it is.
    pub(crate) fn baseline(study: &Arc<Study>, text: &str) -> Self {
        let own_parameters = study.space.parameters.len();
        Self { study: study.clone(), text: text.into(), proposal: None, own_parameters, auxiliary_log_odds: 0.0 }
    }

    /// The study with a proposal. `None` if a parameter of the study has the name of an added one, or if its edits do not
    /// go together.
    pub(crate) fn with_proposal(&self, point: &InsertionPoint, proposal: &Proposal) -> Option<Self> {
        if !proposal.is_consistent(point) {
            return None;
        }
        let mut parameters = self.study.space.parameters[..self.own_parameters].to_vec();
        for a in &proposal.parameters {
            parameters.push(Parameter { name: a.name.clone(), kind: ParameterKind::Free(a.range) });
        }
        let values: Vec<f64> = proposal.parameters.iter().map(|a| a.start).collect();
        let text: Arc<str> = if proposal.edits_script() {
            edited_script(&self.text, point, Some(proposal), &values, vec![]).into()
        } else {
            self.text.clone()
        };
        let mut study = (*self.study).clone();
        study.space = ParameterSpace::new(parameters).ok()?;
        let causes = std::iter::once(proposal.cause).chain(proposal.second_cause);
        let auxiliary_log_odds = causes.map(|cause| auxiliary_log_odds(&study, cause)).sum();
        Some(Self {
            study: Arc::new(study),
            text,
            proposal: Some(proposal.clone()),
            own_parameters: self.own_parameters,
            auxiliary_log_odds,
        })
    }

    /// The same change of another study.
    pub(crate) fn with_study(&self, study: Study) -> Self {
        Self { study: Arc::new(study), ..self.clone() }
    }

    /// Values of the user's own parameters, and of those of the proposal.
    pub(crate) fn split<'a>(&self, values: &'a [f64]) -> (&'a [f64], &'a [f64]) {
        values.split_at(self.own_parameters)
    }

    /// Faults of channels at values of all parameters.
    pub(crate) fn channel_faults(&self, values: &[f64]) -> Vec<ChannelFault> {
        let faults = self.proposal.as_ref().and_then(|p| p.fault_model.as_ref());
        faults.map_or_else(Vec::new, |f| f(self.split(values).1))
    }

    /// Mechanism of the effect: the name of its first parameter; empty without one.
    pub(crate) fn mechanism(&self) -> &str {
        let parameters = self.proposal.as_ref().map_or(&[][..], |p| &p.parameters);
        parameters.first().map_or("", |p| &p.name)
    }

    /// Returns true if the proposal changes the script, not only its channels.
    pub(crate) fn edits_script(&self) -> bool {
        self.proposal.as_ref().is_some_and(Proposal::edits_script)
    }

    /// Returns true if the proposal changes the script in other runs than one that was fitted. Other values of the user's
    /// parameters in that run are those of no other, unless a second effect comes with them.
    pub(crate) fn edits_further_runs(&self) -> bool {
        self.edits_script() && !self.is_condition_of_one_run()
    }

    /// Returns true if all that the proposal edits in the script are the user's parameters in one of several runs.
    pub(crate) fn is_condition_of_one_run(&self) -> bool {
        let Some(p) = &self.proposal else { return false };
        let alone = p.second_cause.is_none() || p.fault_model.is_some();
        alone && p.condition.as_ref().is_some_and(|c| c.run.is_some() && c.also_in.is_empty())
    }

    /// Number of free parameters.
    pub(crate) fn dimension(&self) -> usize {
        self.study.space.dimension()
    }

    /// Number of free parameters that the model depends on: those of the fit without the unread ones. A time that has been
    /// sought among many places counts as several.
    pub(crate) fn counted_parameters(&self) -> usize {
        let change_points = self.proposal.as_ref().map_or(0, Proposal::change_points);
        self.dimension() - self.unread_coordinates().len() + (CHANGE_POINT_PARAMETERS - 1) * change_points
    }

    /// Coordinates of the times at which a parameter of the user's changes.
    pub(crate) fn change_point_coordinates(&self) -> Vec<usize> {
        let Some(p) = &self.proposal else { return vec![] };
        let Some(condition) = &p.condition else { return vec![] };
        let times = [&condition.from, &condition.to];
        let own = self.dimension() - p.parameters.len();
        let place = |name: &String| Some(own + p.parameters.iter().position(|a| a.name == *name)?);
        times.into_iter().flatten().filter_map(place).collect()
    }

    /// Coordinates of the user's parameters that the model does not depend on, because their law is replaced.
    pub(crate) fn unread_coordinates(&self) -> Vec<usize> {
        let unread = self.proposal.as_ref().map_or(&[][..], |p| &p.unread);
        let coordinates = self.study.space.free().enumerate();
        coordinates.filter(|(_, (index, _))| unread.contains(index)).map(|(coordinate, _)| coordinate).collect()
    }

    /// Names of the user's parameters that the model no longer depends on.
    pub(crate) fn unread_names(&self) -> Vec<String> {
        let unread = self.proposal.as_ref().map_or(&[][..], |p| &p.unread);
        unread.iter().map(|i| self.study.space.parameters[*i].name.clone()).collect()
    }

    /// Start of a search in the unit cube: the first parameters at the given values, the others at their proposed start.
    pub(crate) fn start(&self, given: &[f64]) -> Vec<f64> {
        self.study.space.unit_point(&self.start_values(given))
    }

    fn start_values(&self, given: &[f64]) -> Vec<f64> {
        let added = self.proposal.iter().flat_map(|p| &p.parameters).map(|a| a.start);
        let all = std::iter::repeat_n(f64::NAN, self.own_parameters).chain(added);
        all.enumerate().map(|(i, start)| given.get(i).copied().unwrap_or(start)).collect()
    }

    /// Points that differ from [`Variant::start`] in one added parameter, at each of its further starts.
    pub(crate) fn further_starts(&self, given: &[f64]) -> Vec<Vec<f64>> {
        let start = self.start_values(given);
        let added = self.proposal.iter().flat_map(|p| &p.parameters).enumerate();
        let others = added.flat_map(|(i, a)| a.further_starts.iter().map(move |x| (self.own_parameters + i, *x)));
        let at = |(i, x): (usize, f64)| {
            let mut values = start.clone();
            values[i] = x;
            self.study.space.unit_point(&values)
        };
        others.map(at).collect()
    }

    /// Cause of the proposal; `none` for the baseline.
    pub(crate) fn cause(&self) -> &'static str {
        self.proposal.as_ref().map_or("none", |p| p.cause)
    }

    /// Cause of the second of two effects.
    pub(crate) fn second_cause(&self) -> Option<&'static str> {
        self.proposal.as_ref()?.second_cause
    }

    /// Cause and location of the proposal.
    pub(crate) fn cause_and_location(&self) -> Option<(&'static str, &str)> {
        self.proposal.as_ref().map(|p| (p.cause, p.location.as_str()))
    }

    /// Returns true if both have one cause and differ in form alone or in location alone.
    pub(crate) fn differs_in_form_or_location(&self, other: &Self) -> bool {
        let both = self.proposal.as_ref().zip(other.proposal.as_ref());
        both.is_some_and(|(a, b)| a.cause == b.cause && (a.form == b.form) != (a.location == b.location))
    }

    /// Returns true if both have one cause and one form.
    pub(crate) fn has_form_of(&self, other: &Self) -> bool {
        let form = |v: &Self| v.proposal.as_ref().map(|p| (p.cause, p.form.clone()));
        form(self) == form(other)
    }

    /// Returns true if this form has the cause, the location and the parameters of a simpler one, and further parameters.
    pub(crate) fn extends(&self, simpler: &Self) -> bool {
        let Some((a, b)) = self.proposal.as_ref().zip(simpler.proposal.as_ref()) else { return false };
        let single = self.edits_script() && a.second_cause.is_none() && b.second_cause.is_none();
        let same = a.parameters.iter().zip(&b.parameters).all(|(a, b)| a.name == b.name && a.range == b.range);
        single && (a.cause, &a.location) == (b.cause, &b.location) && a.parameters.len() > b.parameters.len() && same
    }

    /// Returns true if the law of a device is replaced.
    pub(crate) fn is_whole_law(&self) -> bool {
        self.proposal.as_ref().is_some_and(|p| p.whole_law.is_some())
    }

    /// Returns true if a channel is at fault, not the model.
    pub(crate) fn is_channel_fault(&self) -> bool {
        self.proposal.is_some() && !self.edits_script()
    }

    /// Returns true if the range of a channel is wrong in one of several fitted runs. Single runs do have clock and zero
    /// faults of their own, so that these do not count.
    pub(crate) fn has_range_fault_in_one_run(&self) -> bool {
        let middle: Vec<f64> = vec![0.5; self.study.space.parameters.len()];
        let range = |c: &ChannelFault| c.run.is_some() && (c.gain != 1.0 || c.clip.is_some());
        self.study.runs_of(Role::Fit).count() > 1 && self.channel_faults(&middle).iter().any(range)
    }

    /// Log odds from the recordings themselves and from auxiliary channels, nats.
    pub(crate) fn direct_log_odds(&self) -> f64 {
        self.visible_log_odds() + self.auxiliary_log_odds
    }

    /// Log odds of an effect that the recordings show by themselves, nats; 0 for others.
    pub(crate) fn visible_log_odds(&self) -> f64 {
        if self.proposal.as_ref().is_some_and(|p| p.visible_in_recording) { VISIBLE_FAULT_LOG_ODDS } else { 0.0 }
    }

    /// Coordinates of the user's own parameters at a point of the unit cube.
    pub(crate) fn own_coordinates<'a>(&self, point: &'a [f64]) -> &'a [f64] {
        &point[..self.dimension() - self.proposal.as_ref().map_or(0, |p| p.parameters.len())]
    }

    /// A simulator of the variant.
    pub(crate) fn simulator(self: &Arc<Self>, factory: &SimulatorFactory) -> VariantSimulator {
        let script = factory.simulator_of_script(self.study.clone(), &self.text);
        VariantSimulator { variant: self.clone(), script, last: vec![None; self.study.runs.len()] }
    }

    /// Values of the parameters that the response depends on.
    fn script_values(&self, values: &[f64]) -> Vec<f64> {
        let proposal = self.proposal.as_ref();
        let own = (0..self.own_parameters).map(|i| proposal.is_some_and(|p| p.unread.contains(&i)));
        let added = proposal.into_iter().flat_map(|p| &p.parameters).map(|a| a.of_channel_fault);
        values.iter().zip(own.chain(added)).filter(|(_, left_out)| !left_out).map(|(v, _)| *v).collect()
    }
}

/// Last response of a run: the values that it depends on, and its channels.
type LastResponse = Option<(Vec<f64>, Vec<Vec<f64>>)>;

/// Simulates the recorded channels of a variant.
pub(crate) struct VariantSimulator {
    variant: Arc<Variant>,
    script: ScriptSimulator,
    /// By run. Another channel fault needs no further analysis.
    last: Vec<LastResponse>,
}

impl Simulator for VariantSimulator {
    fn simulate(&mut self, run: usize, values: &[f64]) -> Result<Vec<Vec<f64>>, SimulationError> {
        let script_values = self.variant.script_values(values);
        let mut channels = match &self.last[run] {
            Some((at, channels)) if *at == script_values => channels.clone(),
            _ => {
                let channels = self.script.simulate(run, values)?;
                self.last[run] = Some((script_values, channels.clone()));
                channels
            }
        };
        let faults = self.variant.channel_faults(values);
        let spec = &self.variant.study.runs[run];
        for (o, y) in spec.observe.iter().zip(&mut channels) {
            for c in faults.iter().filter(|c| c.affects(&spec.name, &o.channel)) {
                c.apply(&spec.recording.times, y);
            }
        }
        Ok(channels)
    }
}
