//! Materials of devices, as far as laws depend on them.

/// Material of the devices of a study.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DeviceMaterial {
    /// Rubber, with or without steel plates.
    Rubber,
    /// Rubber with a core of lead.
    LeadRubber,
    /// A sliding surface.
    Sliding,
    /// Steel.
    Steel,
    /// Reinforced concrete or masonry.
    Concrete,
    /// Timber and its joints.
    Timber,
}

impl DeviceMaterial {
    /// All materials.
    pub const ALL: [Self; 6] =
        [Self::Rubber, Self::LeadRubber, Self::Sliding, Self::Steel, Self::Concrete, Self::Timber];

    /// Its word in `study.toml`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Rubber => "rubber",
            Self::LeadRubber => "lead-rubber",
            Self::Sliding => "sliding",
            Self::Steel => "steel",
            Self::Concrete => "concrete",
            Self::Timber => "timber",
        }
    }
}
