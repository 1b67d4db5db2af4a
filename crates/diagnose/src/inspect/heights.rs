//! Heights of nodes, and which of them count as one.

use hysteron_engine::model::Model;

/// Difference of heights that counts as none, in parts of the height of the model. Floors of a building of 50 storeys are further
/// apart. A choice.
const EQUAL_HEIGHT: f64 = 0.01;

/// The rule by which heights of a model are equal.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct HeightRule {
    /// Least and greatest height.
    pub(crate) range: (f64, f64),
}

impl HeightRule {
    /// The rule for all heights of a model.
    pub(crate) fn of(heights: impl Iterator<Item = f64>) -> Self {
        Self { range: heights.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(x), b.max(x))) }
    }

    /// The rule for the last axis of a model.
    pub(crate) fn of_model(model: &Model) -> Self {
        Self::of(model.nodes.iter().filter(|n| n.ndm() > 1).map(|n| n.place()[n.ndm() - 1]))
    }

    /// Returns true if two heights count as one.
    pub(crate) fn are_equal(&self, a: f64, b: f64) -> bool {
        let (low, high) = self.range;
        (a - b).abs() <= EQUAL_HEIGHT * (high - low).max(f64::MIN_POSITIVE)
    }
}

#[cfg(test)]
mod tests {
    use super::HeightRule;

    #[test]
    fn heights_count_as_one_within_a_hundredth_of_the_model() {
        let rule = HeightRule::of([0.0, 3.0, 30.0].into_iter());
        assert!(rule.are_equal(3.0, 3.2) && !rule.are_equal(3.0, 3.4));
        assert!(HeightRule::of([2.0].into_iter()).are_equal(2.0, 2.0));
    }
}
