//! Tangents at the start of a step, for another try if it fails.

use super::ElementMatrices;

/// Matrices of the elements at the start of a step, and what they were worth.
#[derive(Debug, Default)]
pub(super) struct StepTangents {
    tangent: Vec<f64>,
    damping: Vec<f64>,
    axial: Vec<f64>,
    is_current: bool,
    has_stepped: bool,
}

impl ElementMatrices {
    /// Keep the tangents at the start of a step.
    pub(in crate::analysis) fn keep_start(&mut self) {
        let start = &mut self.at_start;
        (start.is_current, start.has_stepped) = (self.is_current, self.has_stepped);
        if start.is_current {
            start.tangent.clone_from(&self.tangent);
            start.damping.clone_from(&self.damping);
            start.axial.clone_from(&self.axial);
        }
    }

    /// Take back the tangents at the start of a step that has failed. A law has none of its own for a committed state: that of
    /// no increment may be the elastic one, and those of the step are of states that were given up.
    pub(in crate::analysis) fn revert_to_start(&mut self) {
        let start = &self.at_start;
        (self.is_current, self.has_stepped) = (start.is_current, start.has_stepped);
        if start.is_current {
            self.tangent.clone_from(&start.tangent);
            self.damping.clone_from(&start.damping);
            self.axial.clone_from(&start.axial);
        }
    }
}
