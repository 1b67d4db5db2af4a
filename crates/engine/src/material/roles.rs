//! Roles of uniaxial materials: what some of them do besides giving stress and tangent.
//!
//! A material says by [`Uniaxial::roles`] which roles it has. A role is a trait of its own, which the owner of points, a
//! recorder or the user asks; materials without the role need not know it. The methods of `dyn Uniaxial` here put the
//! questions of several askers, and have the answer of a material without the role.

use super::{MaterialResult, SharedUniaxial, Slot, Strains, Stresses, Uniaxial, WatchesColumns};
use crate::parameter::{Changed, NewValue, ParameterError};
use crate::probe::Probe;
use std::any::Any;
use std::fmt;

/// The roles of a material; the default is a material without any.
///
/// `UniaxialRoles::around` takes this apart field by field, so that laws around others decide on a new role.
#[derive(Clone, Copy, Debug, Default)]
pub struct UniaxialRoles<'a> {
    /// The histories of many points have a layout of their own.
    pub layout: Option<&'a dyn PointLayout>,
    /// Some variables of a trial state need no commit.
    pub commit: Option<&'a dyn PartialCommit>,
    /// The response depends on the last trial, where an element follows the calls of OpenSees.
    pub last_trial: Option<&'a dyn LastTrial>,
    /// A trial without a commit changes the history, where an element follows the calls of OpenSees.
    pub trace: Option<&'a dyn TrialTrace>,
    /// Virgin points need not be evaluated.
    pub virgin: Option<&'a dyn VirginPoints>,
    /// Recorders show another strain than that of the material.
    pub shown_strain: Option<&'a dyn ShownStrain>,
    /// It has parameters.
    pub parameters: Option<&'a dyn LawParameters>,
    /// It has responses of its own.
    pub responses: Option<&'a dyn LawResponses>,
    /// It watches columns.
    pub columns: Option<&'a dyn WatchesColumns>,
    /// The material inside one that only shifts its strains, with its slot, and the shift. Points of such materials around
    /// one law are evaluated together.
    pub shifted: Option<(&'a Slot, f64)>,
    /// The law itself, for a material that needs the parameters of one kind. `None` for a material around others.
    pub law: Option<&'a dyn Any>,
}

/// A layout of the histories of many points that are always updated together.
pub trait PointLayout: fmt::Debug {
    /// Writes the virgin state of `n` points. They take `n` times the variables of one point.
    fn init_all(&self, n: usize, state: &mut [f64]);

    /// Number of points that [`Uniaxial::update_all`] evaluates at once. A multiple of it takes least time.
    fn block_len(&self) -> usize;

    /// Copies the history of one point to another array. Each triple is the array, the index of the point, and the
    /// number of points.
    fn copy_history(&self, from: (&[f64], usize, usize), to: (&mut [f64], usize, usize));
}

/// Histories with variables that are never read.
pub trait PartialCommit: fmt::Debug {
    /// Copies trial histories to committed ones, without the variables that are never read.
    fn commit_all(&self, trial: &[f64], committed: &mut [f64]);
}

/// A response that depends on the last trial.
pub trait LastTrial: fmt::Debug {
    /// As [`Uniaxial::update_all`], for an element that follows the calls of OpenSees. `next` holds the last trial
    /// state of the step, `before` the committed strains.
    ///
    /// # Errors
    /// The law has no response at one of the strains.
    fn update_all_on(
        &self,
        committed: &[f64],
        before: &[f64],
        strains: &Strains<'_>,
        next: &mut [f64],
        stresses: &mut Stresses<'_>,
    ) -> MaterialResult;
}

/// Variables that a trial of OpenSees changes without a commit.
pub trait TrialTrace: fmt::Debug {
    /// Copies these variables to the committed state. Used for springs that are evaluated and never committed.
    fn leave_trace(&self, tried: &[f64], committed: &mut [f64]);
}

/// Virgin points whose stresses are proportional to their strains.
pub trait VirginPoints: fmt::Debug {
    /// Tangent of virgin points with strains in a range, if their stresses are proportional to their strains and they
    /// stay virgin. `None` if they do not, or if the law cannot tell.
    fn virgin_tangent(&self, range: [f64; 2]) -> Option<f64>;

    /// Returns true if all of these histories, as [`Uniaxial::update_all`] writes them, equal the virgin one.
    fn are_virgin(&self, state: &[f64]) -> bool;
}

/// A strain for recorders.
pub trait ShownStrain: fmt::Debug {
    /// Strain in recorders for a strain of the material. A law with an initial strain adds it.
    fn shown_strain(&self, strain: f64, state: &[f64]) -> f64;
}

/// Numbers of a law that a script may change.
pub trait LawParameters: fmt::Debug {
    /// The material with a new value of a parameter, named by the words of a `parameter` command, and the previous
    /// value. The layout of the history does not change.
    ///
    /// # Errors
    /// The law itself has no such parameter, or refuses the value. [`Material::with_parameter`] knows more names.
    ///
    /// [`Material::with_parameter`]: super::Material::with_parameter
    fn with_parameter(&self, words: &[&str], value: NewValue) -> Changed<SharedUniaxial>;
}

/// Responses in addition to those of every material.
pub trait LawResponses: fmt::Debug {
    /// Response specific to this material, by the words of a recorder command.
    fn probe(&self, words: &[&str]) -> Option<Probe>;

    /// Value of a probe from the state.
    fn read(&self, path: &[u32], state: &[f64], out: &mut [f64]);
}

impl<'a> UniaxialRoles<'a> {
    /// The roles of a law around others. It leaves a trace and watches columns where a law inside does. Its parameters
    /// include those by which a law inside is made again, which no role of that law tells.
    ///
    /// Not forwarded are roles that would go past the law around: its states, its response and its kind are its own.
    pub(super) fn around(
        law: &'a (impl TrialTrace + ShownStrain + LawParameters + LawResponses + WatchesColumns),
        inner: impl IntoIterator<Item = &'a Slot>,
    ) -> Self {
        let own = Self { shown_strain: Some(law), parameters: Some(law), responses: Some(law), ..Self::default() };
        inner.into_iter().fold(own, |roles, slot| {
            let Self {
                layout: _,
                commit: _,
                last_trial: _,
                trace,
                virgin: _,
                shown_strain: _,
                parameters: _,
                responses: _,
                columns,
                shifted: _,
                law: _,
            } = slot.material.roles();
            Self {
                trace: roles.trace.or(trace.map(|_| law as &dyn TrialTrace)),
                columns: roles.columns.or(columns.map(|_| law as &dyn WatchesColumns)),
                ..roles
            }
        })
    }
}

/// Questions to any material about its properties and its roles.
impl dyn Uniaxial + '_ {
    /// Returns true if `Stress::damping` is used.
    pub fn is_viscous(&self) -> bool {
        self.traits().viscous
    }

    /// Returns true if the stress depends on the elapsed time (`Strain::dt`).
    pub fn depends_on_time(&self) -> bool {
        self.traits().elapses
    }

    /// Returns true if the stress is proportional to the strain for every history.
    pub fn is_linear(&self) -> bool {
        self.traits().linear
    }

    /// Writes the virgin state of `n` points that are always updated together.
    pub fn init_all(&self, n: usize, state: &mut [f64]) {
        match self.roles().layout {
            Some(layout) => layout.init_all(n, state),
            None => state.chunks_exact_mut(self.state_len().max(1)).for_each(|point| self.init(point)),
        }
    }

    /// Number of points that are evaluated at once.
    pub fn block_len(&self) -> usize {
        self.roles().layout.map_or(1, PointLayout::block_len)
    }

    /// Copies the history of one point to another array. Each triple is the array in the layout of `init_all`, the index
    /// of the point, and the number of points.
    pub fn copy_history(&self, from: (&[f64], usize, usize), to: (&mut [f64], usize, usize)) {
        if let Some(layout) = self.roles().layout {
            return layout.copy_history(from, to);
        }
        let ((from, i, _), (to, j, _), n) = (from, to, self.state_len());
        to[j * n..(j + 1) * n].copy_from_slice(&from[i * n..(i + 1) * n]);
    }

    /// Strain in recorders for a strain of the material.
    pub fn shown_strain(&self, strain: f64, state: &[f64]) -> f64 {
        self.roles().shown_strain.map_or(strain, |law| law.shown_strain(strain, state))
    }

    /// The material with a new value of a parameter of the law itself, and the previous value.
    ///
    /// # Errors
    /// The law itself has no such parameter, or refuses the value.
    pub fn with_parameter(&self, words: &[&str], value: NewValue) -> Changed<SharedUniaxial> {
        self.roles().parameters.map_or(Err(ParameterError::Unknown), |law| law.with_parameter(words, value))
    }

    /// Response specific to this material, by the words of a recorder command.
    pub fn probe(&self, words: &[&str]) -> Option<Probe> {
        self.roles().responses?.probe(words)
    }

    /// Value of such a response from the state.
    pub fn read(&self, path: &[u32], state: &[f64], out: &mut [f64]) {
        if let Some(law) = self.roles().responses {
            law.read(path, state, out);
        }
    }
}
