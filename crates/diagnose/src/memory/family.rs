//! Kinds of memory that a device may have.

/// A kind of memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Family {
    /// No memory but that of a spring with slip: another shape of the same law.
    Shape,
    /// Elapsed time.
    Clock,
    /// Work done so far.
    Work,
    /// Work done recently, which leaks away.
    Heat,
    /// Largest deformation so far.
    Largest,
    /// Deformation near zero, within the largest so far.
    Pinching,
    /// Rate of deformation.
    Rate,
    /// Time at rest, worn off by slip.
    Rest,
    /// Sense of the deformation.
    Side,
    /// Place of the stroke.
    Place,
    /// Middle of the motion so far, to which the origin moves.
    Set,
    /// A recorded temperature.
    Temperature,
    /// A recorded or imposed axial force.
    AxialForce,
    /// Another recorded channel.
    Channel,
}

impl Family {
    /// Families without a channel of their own.
    pub(crate) const OF_MOTION: [Self; 11] = [
        Self::Shape,
        Self::Clock,
        Self::Work,
        Self::Heat,
        Self::Largest,
        Self::Pinching,
        Self::Rate,
        Self::Rest,
        Self::Side,
        Self::Place,
        Self::Set,
    ];

    /// Its name in `diagnosis.json`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Shape => "shape",
            Self::Clock => "clock",
            Self::Work => "work",
            Self::Heat => "heat",
            Self::Largest => "largest_deformation",
            Self::Pinching => "pinching",
            Self::Rate => "rate",
            Self::Rest => "rest",
            Self::Side => "side",
            Self::Place => "place",
            Self::Set => "set",
            Self::Temperature => "temperature",
            Self::AxialForce => "axial_force",
            Self::Channel => "channel",
        }
    }

    /// The family of a name.
    pub(crate) fn of_name(name: &str) -> Option<Self> {
        let channels = [Self::Temperature, Self::AxialForce, Self::Channel];
        Self::OF_MOTION.into_iter().chain(channels).find(|f| f.name() == name)
    }

    /// The family of a recorded column by its name.
    pub(crate) fn of_column(name: &str) -> Self {
        let name = name.to_lowercase();
        if name.starts_with("temp") {
            Self::Temperature
        } else if name.starts_with("axial") {
            Self::AxialForce
        } else {
            Self::Channel
        }
    }

    /// Its phenomenon as a clause.
    pub fn statement(self) -> &'static str {
        match self {
            Self::Shape => "the device has another shape of its loop, without a further memory",
            Self::Clock => "the force changes with elapsed time",
            Self::Work => "the force changes with the work done so far",
            Self::Heat => "the force changes with recent work, and comes back with time",
            Self::Largest => "the force changes with the largest deformation so far",
            Self::Pinching => "the force near zero deformation differs from that of the model",
            Self::Rate => "the force depends on the rate of deformation",
            Self::Rest => "the strength changes with the time at rest",
            Self::Side => "the force differs between the two senses of the deformation",
            Self::Place => "the strength differs along the stroke",
            Self::Set => "the origin of the deformation moves with the motion so far",
            Self::Temperature => "the force follows the recorded temperature",
            Self::AxialForce => "the force follows the axial force",
            Self::Channel => "the force follows a recorded channel",
        }
    }

    /// Returns true if it needs times of a clock.
    pub(crate) fn needs_clock(self) -> bool {
        matches!(self, Self::Clock | Self::Heat | Self::Rate | Self::Rest)
    }

    /// Returns true if its variables change within a cycle. They act on the strength alone, or the law could make energy.
    pub(super) fn is_fast(self) -> bool {
        matches!(self, Self::Pinching | Self::Rate | Self::Rest | Self::Side | Self::Place)
    }
}
