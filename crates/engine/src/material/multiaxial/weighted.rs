//! A row of laws in space with a weight for each.

use super::{SOLID, SharedMultiaxial};
use crate::probe::Probe;
use std::ops::{Deref, Range};
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

crate::watches_columns!(WeightedLaws => |s| at s.placed());

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

    /// Weighted area of the bars along axis 1.
    pub(super) fn reinforcement(&self) -> f64 {
        self.iter().map(|(law, weight)| weight * law.reinforcement()).sum()
    }

    /// Response of a law by its number, from 1, and the words of the law.
    pub(super) fn probe(&self, words: &[&str]) -> Option<Probe> {
        let ["material", number, rest @ ..] = words else { return None };
        let i = number.parse::<usize>().ok()?.checked_sub(1)?;
        Some(self.get(i)?.0.probe(rest)?.inside(&[i as u32]))
    }

    /// Value of such a response.
    pub(super) fn read(&self, path: &[u32], state: &[f64], out: &mut [f64]) {
        if let Some((range, law)) = self.placed().nth(path[0] as usize) {
            law.read(&path[1..], &state[range], out);
        }
    }

    /// Laws with the ranges of their states.
    fn placed(&self) -> impl Iterator<Item = (Range<usize>, &SharedMultiaxial<SOLID>)> {
        let mut end = 0;
        self.iter().map(move |(law, _)| {
            let start = end;
            end += law.state_len();
            (start..end, law)
        })
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
