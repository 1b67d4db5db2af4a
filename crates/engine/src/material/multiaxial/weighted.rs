//! A row of laws in space with a weight for each.

use super::{SOLID, SharedMultiaxial};
use std::ops::Deref;
use std::sync::Arc;

/// Laws with their weights. Their states follow each other.
#[derive(Clone, Debug)]
pub struct WeightedLaws(pub Vec<(SharedMultiaxial<SOLID>, f64)>);

impl Deref for WeightedLaws {
    type Target = [(SharedMultiaxial<SOLID>, f64)];
    fn deref(&self) -> &Self::Target {
        &self.0
    }
}

impl WeightedLaws {
    /// Length of the states of all laws.
    pub(super) fn state_len(&self) -> usize {
        self.iter().map(|(law, _)| law.state_len()).sum()
    }

    /// Write the virgin states.
    pub(super) fn init(&self, mut state: &mut [f64]) {
        for (law, _) in self.iter() {
            let (own, rest) = state.split_at_mut(law.state_len());
            law.init(own);
            state = rest;
        }
    }

    /// Returns true if all are linear.
    pub(super) fn is_linear(&self) -> bool {
        self.iter().all(|(law, _)| law.is_linear())
    }

    /// Returns true if all have symmetric tangents.
    pub(super) fn is_symmetric(&self) -> bool {
        self.iter().all(|(law, _)| law.is_symmetric())
    }

    /// Returns true if one depends on time.
    pub(super) fn depends_on_time(&self) -> bool {
        self.iter().any(|(law, _)| law.depends_on_time())
    }

    /// Weighted density.
    pub(super) fn density(&self) -> f64 {
        self.iter().map(|(law, weight)| weight * law.density()).sum()
    }

    /// The laws for elements of a length; none where no law depends on it.
    pub(super) fn of_length(&self, length: f64) -> Option<Self> {
        let scaled: Vec<_> = self.iter().map(|(law, weight)| (law.of_length(length), law, *weight)).collect();
        scaled.iter().any(|(scaled, ..)| scaled.is_some()).then(|| {
            let kept =
                scaled.into_iter().map(|(scaled, law, weight)| (scaled.unwrap_or_else(|| Arc::clone(law)), weight));
            Self(kept.collect())
        })
    }
}
