//! Hypotheses about what a model lacks, one cause a file.
//!
//! A hypothesis inspects the model and proposes edits of the script, with parameters of their own, or faults of channels.
//! The proposals of a cause are different forms of it; the best of them represents the cause.
//!
//! A new hypothesis is a file with a declaration and a function, and a line in [`ALL`]. The declaration has all that is said of
//! the cause: the tables of `docs/reference/causes.md`, quantities, ranges and advice follow from it. `context` holds what proposals are made from.
//! `own_options` has the forms that switch on what a law has itself, `whole_law` those that replace a law by another.

pub(crate) mod ambient_temperature;
mod axial_shear_interaction;
mod bidirectional_coupling;
mod cavitation;
pub(crate) mod changed_condition;
mod changed_mass;
pub(crate) mod context;
mod cyclic_degradation;
mod damping;
pub(crate) mod declaration;
mod device_commands;
mod foundation_flexibility;
mod free_masses;
mod friction;
mod gap_impact;
pub(crate) mod isolation_layer;
mod late_support;
mod materials;
mod mullins_softening;
mod own_options;
mod pinching;
mod rate_dependence;
mod rounded_yielding;
mod self_heating;
pub(crate) mod sensor;
mod strain_stiffening;
mod superstructure_yielding;
mod support_springs;
mod torsion;
mod varying_axial_load;
mod whole_law;
mod yielding_joint;

use crate::candidate::proposal::{AddedParameter, Proposal};
use crate::memory::family::Family;
use context::{MovingGroup, ProposalContext, element_names, element_tags};
use declaration::{Measurement, Quantity};
use hysteron_identify::study::{DeviceMaterial, Study};

/// A cause, with the function that proposes its forms.
pub struct Hypothesis {
    /// Name of the cause.
    pub cause: &'static str,
    /// Missing effect, in words.
    pub statement: &'static str,
    /// Observation that would refute the cause.
    pub refuted_by: &'static str,
    /// Causes that look the same unless a test separates them.
    pub look_alikes: &'static [&'static str],
    /// The sign of it in the recordings, in words.
    pub shows: &'static str,
    /// The difference from its look-alikes, in words.
    pub parted_by: &'static str,
    /// Parts of the model or channels that it is proposed for, in words.
    pub place: &'static str,
    /// Forms in which it is proposed, in words.
    pub forms: &'static str,
    /// True if the effect depends on elapsed time. Recordings that only count samples cannot show it.
    pub needs_clock: bool,
    /// Kinds of memory that a device shows under the effect; empty where the effect is none of a device's law.
    pub(crate) memory: &'static [Family],
    /// Materials whose devices can have the effect; empty where it knows no material.
    pub(crate) materials: &'static [DeviceMaterial],
    /// The measurement that shows it.
    pub(crate) measurement: Measurement,
    /// Parameters of its forms.
    pub(crate) quantities: &'static [Quantity],
    propose: fn(&ProposalContext<'_>) -> Vec<Proposal>,
}

/// All hypotheses.
pub const ALL: &[Hypothesis] = &[
    rate_dependence::HYPOTHESIS,
    self_heating::HYPOTHESIS,
    ambient_temperature::HYPOTHESIS,
    mullins_softening::HYPOTHESIS,
    cyclic_degradation::HYPOTHESIS,
    strain_stiffening::HYPOTHESIS,
    axial_shear_interaction::HYPOTHESIS,
    varying_axial_load::HYPOTHESIS,
    cavitation::HYPOTHESIS,
    bidirectional_coupling::HYPOTHESIS,
    friction::HYPOTHESIS,
    gap_impact::HYPOTHESIS,
    foundation_flexibility::HYPOTHESIS,
    isolation_layer::HYPOTHESIS,
    late_support::HYPOTHESIS,
    superstructure_yielding::HYPOTHESIS,
    rounded_yielding::HYPOTHESIS,
    changed_mass::HYPOTHESIS,
    damping::HYPOTHESIS,
    torsion::HYPOTHESIS,
    pinching::HYPOTHESIS,
    changed_condition::HYPOTHESIS,
    sensor::GAIN,
    sensor::LAG,
    sensor::DRIFT,
    sensor::CLIPPING,
];

impl Hypothesis {
    /// Returns true if devices of the material of a study can have the effect.
    pub(crate) fn suits_material(&self, study: &Study) -> bool {
        study.material.is_none_or(|m| self.suits(m))
    }

    /// Returns true if devices of a material can have the effect.
    pub(crate) fn suits(&self, material: DeviceMaterial) -> bool {
        self.materials.is_empty() || self.materials.contains(&material)
    }

    /// The proposals for a study.
    pub(crate) fn proposals(&self, context: &ProposalContext<'_>) -> Vec<Proposal> {
        let mut out = (self.propose)(context);
        out.extend(own_options::proposals(self.cause, context));
        out
    }

    /// Proposals that replace the law of a device by another. The responses are best those of the fitted baseline.
    pub(crate) fn whole_laws(&self, context: &ProposalContext<'_>) -> Vec<Proposal> {
        whole_law::proposals(self.cause, context)
    }
}

/// Returns true if the cause is a fault of a channel, not of the model.
pub(crate) fn is_sensor_fault(cause: &str) -> bool {
    cause.starts_with("sensor_")
}

/// The hypothesis of a cause.
pub fn of(cause: &str) -> Option<&'static Hypothesis> {
    ALL.iter().find(|h| h.cause == cause)
}

/// Quantity of a parameter of a cause, by its name without the prefix; `None` for a name that is nobody's.
pub(crate) fn quantity(cause: &str, parameter: &str) -> Option<&'static Quantity> {
    let own = of(cause).map_or(&[][..], |h| h.quantities);
    own.iter().chain(declaration::SHARED_QUANTITIES).find(|q| q.parameter == parameter)
}

/// Returns true if either cause lists the other as a look-alike.
pub(crate) fn look_alike(a: &str, b: &str) -> bool {
    let lists = |a: &str, b: &str| of(a).is_some_and(|h| h.look_alikes.contains(&b));
    lists(a, b) || lists(b, a)
}
