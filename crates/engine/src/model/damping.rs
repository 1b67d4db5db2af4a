//! Rayleigh damping.

/// C = αM M + βK K + βK0 K₀ + βKc K_c, with the current, the initial and the last committed tangent.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rayleigh {
    /// On the mass, 1/time.
    pub alpha_m: f64,
    /// On the current tangent, time.
    pub beta_k: f64,
    /// On the initial tangent, time.
    pub beta_k0: f64,
    /// On the last committed tangent, time.
    pub beta_kc: f64,
}

impl Rayleigh {
    /// With the factor on the initial tangent on the current one.
    pub(crate) fn with_current_for_initial(self) -> Self {
        Self { beta_k: self.beta_k + self.beta_k0, beta_k0: 0.0, ..self }
    }

    /// Returns true if there is no damping.
    pub fn is_zero(&self) -> bool {
        *self == Self::default()
    }
}
