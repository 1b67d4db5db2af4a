//! State variables of the basic system of a beam.

/// Forces and stiffness of the basic system.
#[derive(Clone, Copy, Debug)]
pub struct Basic<const B: usize> {
    /// Forces.
    pub q: [f64; B],
    /// Stiffness.
    pub k: [[f64; B]; B],
}

impl<const B: usize> Basic<B> {
    pub(super) const LEN: usize = B + B * B;

    pub(super) fn read(state: &[f64]) -> Self {
        let mut basic = Self { q: [0.0; B], k: [[0.0; B]; B] };
        basic.q.copy_from_slice(&state[..B]);
        basic.k.as_flattened_mut().copy_from_slice(&state[B..Self::LEN]);
        basic
    }

    pub(super) fn write(&self, state: &mut [f64]) {
        state[..B].copy_from_slice(&self.q);
        state[B..Self::LEN].copy_from_slice(self.k.as_flattened());
    }
}
