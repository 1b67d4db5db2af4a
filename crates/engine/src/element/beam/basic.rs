//! State variables of the basic system of a beam.

/// Names of the basic deformations of a beam in space.
pub(super) const BASIC_DEFORMATIONS: [&str; 6] = ["eps", "thetaZ_1", "thetaZ_2", "thetaY_1", "thetaY_2", "thetaX"];

/// Names of the basic forces of a beam.
pub(super) fn basic_force_names(plane: bool) -> &'static [&'static str] {
    if plane { &["N", "M_1", "M_2"] } else { &["N", "Mz_1", "Mz_2", "My_1", "My_2", "T"] }
}

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
