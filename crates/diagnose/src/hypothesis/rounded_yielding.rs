//! A transition from elastic to yielding that is rounder than that of the law. `own_options` has its forms.

use super::declaration::{Dimension, Measurement, Quantity, Recordable};
use super::{Hypothesis, ProposalContext};
use crate::memory::family::Family;

pub(super) const HYPOTHESIS: Hypothesis = Hypothesis {
    cause: "rounded_yielding",
    statement: "the device yields gradually, with rounder corners of its loops than the law of the model",
    refuted_by: "the corners of a slow loop are as sharp as those of the model",
    look_alikes: &["friction", "rate_dependence"],
    shows: "an error at the corners of the loops alone, the same in slow and in fast cycles",
    parted_by: "`friction` changes the height of small loops, `rate_dependence` that of slow ones",
    place: "devices with `Steel01` or `elastomericBearingPlasticity`",
    forms: "`BoucWen` and `elastomericBearingBoucWen` with the numbers of the law; their exponent is fitted",
    needs_clock: false,
    memory: &[Family::Shape],
    materials: &[],
    measurement: Measurement::new(
        "record the displacement across {place}: its loops must have rounded corners",
        "drive a slow cycle beyond yielding: the stiffness must fall gradually",
    )
    .unless_at_building(Recordable::Deformation),
    quantities: &[
        Quantity::new("exponent", "exponent of the transition", Dimension::Ratio),
        Quantity::new("unloading", "stiffness lost in loading", Dimension::Ratio),
    ],
    propose: |_: &ProposalContext<'_>| vec![],
};
