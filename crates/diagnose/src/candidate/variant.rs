//! A study with a proposal in it: the script with the block, the parameters of both, the faults of its channels.

use crate::candidate::sensor_fault::Correction;
use crate::evidence::likelihood::SEEN;
use crate::hypothesis::Proposal;
use crate::inspect::auxiliary_channels::speak_for;
use crate::inspect::insertion::{Place, insert};
use hysteron_identify::study::{Blueprint, Mishap, Parameter, Role, ScriptSimulator, Simulator, Source, Space, Study};
use std::sync::Arc;

/// A study that a proposal has changed, or the baseline.
#[derive(Clone, Debug)]
pub struct Variant {
    /// The study, its parameters followed by those of the proposal.
    pub study: Arc<Study>,
    /// The script.
    pub text: Arc<str>,
    /// What was proposed; nothing for the baseline.
    pub proposal: Option<Proposal>,
    /// Number of parameters that are the user's own.
    own: usize,
    /// Log odds by which instruments beside the channels speak for it.
    instruments: f64,
}

impl Variant {
    /// The study as it is.
    pub fn baseline(study: &Arc<Study>, text: &str) -> Self {
        let own = study.space.parameters.len();
        Self { study: study.clone(), text: text.into(), proposal: None, own, instruments: 0.0 }
    }

    /// With a proposal; the parameters that it adds are declared in the block. `None` where a parameter of the study
    /// has the name of one of them.
    pub fn with(&self, place: &Place, proposal: &Proposal) -> Option<Self> {
        let mut parameters = self.study.space.parameters[..self.own].to_vec();
        for a in &proposal.added {
            parameters.push(Parameter { name: a.name.clone(), source: Source::Free(a.range) });
        }
        let values: Vec<f64> = proposal.added.iter().map(|a| a.start).collect();
        let text: Arc<str> = if proposal.block.is_empty() {
            self.text.clone()
        } else {
            insert(&self.text, place, &declared(proposal, &values)).into()
        };
        let mut study = (*self.study).clone();
        study.space = Space::new(parameters).ok()?;
        let causes = std::iter::once(proposal.cause).chain(proposal.second);
        let instruments = causes.map(|cause| speak_for(&study, cause)).sum();
        Some(Self { study: Arc::new(study), text, proposal: Some(proposal.clone()), own: self.own, instruments })
    }

    /// The same with other runs.
    pub fn of_study(&self, study: Study) -> Self {
        Self { study: Arc::new(study), ..self.clone() }
    }

    /// The user's own parameters and those of the proposal.
    pub fn split<'a>(&self, values: &'a [f64]) -> (&'a [f64], &'a [f64]) {
        values.split_at(self.own)
    }

    /// Faults of channels at values of all parameters.
    pub fn corrections(&self, values: &[f64]) -> Vec<Correction> {
        let faults = self.proposal.as_ref().and_then(|p| p.faults.as_ref());
        faults.map_or_else(Vec::new, |f| f(self.split(values).1))
    }

    /// Whether it changes the script, and not only what channels show of it.
    pub fn edits(&self) -> bool {
        self.proposal.as_ref().is_some_and(|p| !p.block.is_empty())
    }

    /// Number of parameters to be found.
    pub fn dimension(&self) -> usize {
        self.study.space.dimension()
    }

    /// Where the search starts, in the unit cube: the first parameters as given, the others where they are proposed to
    /// start.
    pub fn start(&self, given: &[f64]) -> Vec<f64> {
        self.study.space.point(&self.start_values(given))
    }

    fn start_values(&self, given: &[f64]) -> Vec<f64> {
        let added = self.proposal.iter().flat_map(|p| &p.added).map(|a| a.start);
        let all = std::iter::repeat_n(f64::NAN, self.own).chain(added);
        all.enumerate().map(|(i, start)| given.get(i).copied().unwrap_or(start)).collect()
    }

    /// Further points like [`Variant::start`], each with another value of one of the parameters of the proposal.
    pub fn further_starts(&self, given: &[f64]) -> Vec<Vec<f64>> {
        let start = self.start_values(given);
        let added = self.proposal.iter().flat_map(|p| &p.added).enumerate();
        let others = added.flat_map(|(i, a)| a.also.iter().map(move |x| (self.own + i, *x)));
        let at = |(i, x): (usize, f64)| {
            let mut values = start.clone();
            values[i] = x;
            self.study.space.point(&values)
        };
        others.map(at).collect()
    }

    /// The cause of what was proposed; `none` of the baseline.
    pub fn cause(&self) -> &'static str {
        self.proposal.as_ref().map_or("none", |p| p.cause)
    }

    /// The second of two effects.
    pub(crate) fn second(&self) -> Option<&'static str> {
        self.proposal.as_ref()?.second
    }

    /// Its cause and where it stands.
    pub(crate) fn place(&self) -> Option<(&'static str, &str)> {
        self.proposal.as_ref().map(|p| (p.cause, p.at.as_str()))
    }

    /// Whether another variant has the same form elsewhere or another form at the same place.
    pub(crate) fn differs_in_one(&self, other: &Self) -> bool {
        let both = self.proposal.as_ref().zip(other.proposal.as_ref());
        both.is_some_and(|(a, b)| a.cause == b.cause && (a.form == b.form) != (a.at == b.at))
    }

    /// Whether another variant has the same form.
    pub(crate) fn same_form(&self, other: &Self) -> bool {
        let form = |v: &Self| v.proposal.as_ref().map(|p| (p.cause, p.form.clone()));
        form(self) == form(other)
    }

    /// Whether it has the parameters of another variant, of its cause and place, and more behind them.
    pub(crate) fn contains(&self, simpler: &Self) -> bool {
        let Some((a, b)) = self.proposal.as_ref().zip(simpler.proposal.as_ref()) else { return false };
        let alone = self.edits() && a.second.is_none() && b.second.is_none();
        let same = a.added.iter().zip(&b.added).all(|(a, b)| a.name == b.name && a.range == b.range);
        alone && (a.cause, &a.at) == (b.cause, &b.at) && a.added.len() > b.added.len() && same
    }

    /// A channel is at fault, not the model.
    pub fn of_a_channel(&self) -> bool {
        self.proposal.is_some() && !self.edits()
    }

    /// The range of a channel is wrong in a single run, of several that are fitted. (Clocks and zeros do go wrong in
    /// single runs.)
    pub fn of_one_run(&self) -> bool {
        let middle: Vec<f64> = vec![0.5; self.study.space.parameters.len()];
        let range = |c: &Correction| c.run.is_some() && (c.gain != 1.0 || c.clip.is_some());
        self.study.runs_of(Role::Fit).count() > 1 && self.corrections(&middle).iter().any(range)
    }

    /// Log odds for what the recordings show of it by themselves, and instruments beside the channels.
    pub(crate) fn known(&self) -> f64 {
        self.seen() + self.instruments
    }

    /// Log odds for what the recordings show of it by themselves.
    pub(crate) fn seen(&self) -> f64 {
        if self.proposal.as_ref().is_some_and(|p| p.seen) { SEEN } else { 0.0 }
    }

    /// Coordinates of the user's own parameters at a point.
    pub(crate) fn own<'a>(&self, point: &'a [f64]) -> &'a [f64] {
        &point[..self.dimension() - self.proposal.as_ref().map_or(0, |p| p.added.len())]
    }

    /// A simulator of it.
    pub fn simulator(self: &Arc<Self>, blueprint: &Blueprint) -> VariantSimulator {
        let script = blueprint.simulator_of(self.study.clone(), &self.text);
        VariantSimulator { variant: self.clone(), script, last: vec![None; self.study.runs.len()] }
    }

    /// Values that the model knows: all but those of faults of channels.
    fn of_the_model(&self, values: &[f64]) -> Vec<f64> {
        let added = self.proposal.iter().flat_map(|p| &p.added).map(|a| a.rig);
        let rig = std::iter::repeat_n(false, self.own).chain(added);
        values.iter().zip(rig).filter(|(_, rig)| !rig).map(|(v, _)| *v).collect()
    }
}

/// The block of a proposal with its parameters declared at some values.
pub fn declared(proposal: &Proposal, values: &[f64]) -> Vec<String> {
    let of_the_model = proposal.added.iter().zip(values).filter(|(a, _)| !a.rig);
    let declare = of_the_model.map(|(a, v)| format!("pset {} {v:?}", a.name));
    declare.chain(proposal.block.iter().cloned()).collect()
}

/// What a run showed last, and at which values of the model.
type Last = Option<(Vec<f64>, Vec<Vec<f64>>)>;

/// Simulates what the channels of a variant show.
pub struct VariantSimulator {
    variant: Arc<Variant>,
    script: ScriptSimulator,
    /// By run: a fault of a channel needs no new analysis.
    last: Vec<Last>,
}

impl Simulator for VariantSimulator {
    fn simulate(&mut self, run: usize, values: &[f64]) -> Result<Vec<Vec<f64>>, Mishap> {
        let known = self.variant.of_the_model(values);
        let mut channels = match &self.last[run] {
            Some((at, channels)) if *at == known => channels.clone(),
            _ => {
                let channels = self.script.simulate(run, values)?;
                self.last[run] = Some((known, channels.clone()));
                channels
            }
        };
        let corrections = self.variant.corrections(values);
        let spec = &self.variant.study.runs[run];
        for (o, y) in spec.observe.iter().zip(&mut channels) {
            for c in corrections.iter().filter(|c| c.concerns(&spec.name, &o.channel)) {
                c.apply(&spec.recording.times, y);
            }
        }
        Ok(channels)
    }
}
