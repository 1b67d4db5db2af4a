//! Parts that a cause declares beside its proposals: quantities with published ranges, and what to measure.

/// A measurement that shows a cause. `{place}` stands for the place of the effect.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Measurement {
    /// At a building or bridge, whose earthquakes cannot be chosen.
    pub(crate) building: &'static str,
    /// In a test rig, whose motion can.
    pub(crate) rig: &'static str,
    /// Quantities recorded at a building and in a rig; none where it asks for more than a recording.
    pub(crate) records: [Option<Recordable>; 2],
    /// The rest to be done in a rig where every run has that already.
    pub(crate) left_in_rig: Option<&'static str>,
}

impl Measurement {
    /// Measurement at a building, and in a rig.
    pub(super) const fn new(building: &'static str, rig: &'static str) -> Self {
        Self { building, rig, records: [None; 2], left_in_rig: None }
    }

    /// The same of a condition that the runs may have already; then `rig` is left to do.
    pub(super) const fn unless(self, what: Recordable, rig: Option<&'static str>) -> Self {
        Self { records: [Some(what); 2], left_in_rig: rig, ..self }
    }

    /// The same of a quantity that the runs of a building may have already.
    pub(super) const fn unless_at_building(self, what: Recordable) -> Self {
        Self { records: [Some(what), self.records[1]], ..self }
    }

    /// The same of a quantity that the runs of a rig may have already.
    pub(super) const fn unless_in_rig(self, what: Recordable) -> Self {
        Self { records: [self.records[0], Some(what)], ..self }
    }
}

/// A quantity or a condition of the runs that may be recorded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Recordable {
    /// Temperature of a device.
    Temperature,
    /// Axial force of a device.
    AxialForce,
    /// The displacement of a node at the place, or the deformation of its elements.
    Deformation,
    /// The same along the vertical axis.
    VerticalDeformation,
    /// An acceleration of a node at the place.
    Acceleration,
    /// Two accelerations of one direction at different nodes of one level.
    EdgesOfFloor,
    /// Channels along two horizontal axes.
    BothHorizontal,
}

/// A parameter of a cause.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Quantity {
    /// Name of the parameter without its prefix.
    pub(crate) parameter: &'static str,
    /// The quantity, in words.
    pub(crate) words: &'static str,
    /// Its dimension.
    pub(crate) dimension: Dimension,
    /// Range in which published values lie; none where none is known, or where it depends on the unit.
    pub(crate) published: Option<PublishedRange>,
}

impl Quantity {
    /// A quantity without a published range.
    pub(super) const fn new(parameter: &'static str, words: &'static str, dimension: Dimension) -> Self {
        Self { parameter, words, dimension, published: None }
    }

    /// The same with a published range: the quantity with its unit in a sentence, the ends, and the range in words with its
    /// source.
    pub(super) const fn within(self, subject: &'static str, [lower, upper]: [f64; 2], words: &'static str) -> Self {
        Self { published: Some(PublishedRange { subject, lower, upper, words }), ..self }
    }
}

/// Range in which published values of a parameter lie.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PublishedRange {
    /// The quantity with its unit, as the subject of a sentence.
    pub(crate) subject: &'static str,
    /// Least value.
    pub(crate) lower: f64,
    /// Largest value.
    pub(crate) upper: f64,
    /// The range in words, with its source.
    pub(crate) words: &'static str,
}

/// Dimension of a parameter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Dimension {
    /// Length.
    Length,
    /// Length per time.
    Speed,
    /// Force.
    Force,
    /// Force per length.
    Stiffness,
    /// Force per speed.
    Dashpot,
    /// Force times length.
    Moment,
    /// Work.
    Energy,
    /// Moment per angle.
    RotationalStiffness,
    /// Moment per angular speed.
    RotationalDashpot,
    /// Time, s.
    Time,
    /// Reciprocal of a time, 1/s.
    Rate,
    /// Share per degree of temperature.
    PerDegree,
    /// A number without unit.
    Ratio,
    /// A unit that depends on the law.
    Unnamed,
}

impl Dimension {
    /// Returns true if a quantity of parts side by side adds up.
    pub(crate) fn adds_up(self) -> bool {
        matches!(self, Self::Force | Self::Stiffness | Self::Dashpot | Self::Energy)
    }
}

/// Quantities that have one name in several causes. Those of the cause itself come first.
pub(super) const SHARED_QUANTITIES: &[Quantity] = &[
    Quantity::new("hardening", "hardening ratio", Dimension::Ratio),
    Quantity::new("area", "area of the rubber", Dimension::Unnamed),
    Quantity::new("height", "height of the rubber", Dimension::Length),
    Quantity::new("k", "elastic stiffness", Dimension::Stiffness),
    Quantity::new("elastic", "factor of the elastic part", Dimension::Ratio),
    Quantity::new("power", "exponent", Dimension::Ratio),
];

#[cfg(test)]
mod tests {
    use super::SHARED_QUANTITIES;
    use crate::hypothesis::{ALL, quantity};

    #[test]
    fn a_parameter_has_one_quantity_and_ranges_have_their_order() {
        for h in ALL {
            for (i, q) in h.quantities.iter().enumerate() {
                assert!(h.quantities[..i].iter().all(|p| p.parameter != q.parameter), "{} {}", h.cause, q.parameter);
                assert!(q.published.is_none_or(|r| r.lower < r.upper && !r.words.is_empty()), "{}", q.parameter);
            }
            assert!([h.shows, h.parted_by, h.place, h.forms].iter().all(|text| !text.is_empty()), "{}", h.cause);
        }
        // That of the cause comes before the shared one.
        assert_eq!(quantity("pinching", "strength").map(|q| q.words), Some("yield force"));
        assert_eq!(quantity("friction", "power").map(|q| q.words), SHARED_QUANTITIES.last().map(|q| q.words));
        assert!(quantity("friction", "gap").is_none());
    }
}
