//! Bouc-Wen hysteresis with pinching (Baber and Noori, 1986).

use crate::material::{MaterialError, MaterialResult, Strain, Stress, UniaxialLaw};

/// z at the beginning of Newton's method, as in OpenSees: it decides which of several roots is found.
const START: f64 = 0.01;

/// σ = α k₀ ε + (1-α) k₀ z with ż = h [A - |z|ⁿ (γ + β sign(ε̇ z))] ε̇.
///
/// The pinching function is h = 1 - ζ₁ exp(-(z sign ε̇ - q z_u)² / ζ₂²), with z_u = (β + γ)^(-1/n),
/// ζ₁ = ζ_s (1 - exp(-p e)), ζ₂ = (ψ + δ_ψ e) (λ + ζ₁) and the dissipated energy e = ∫ (1-α) k₀ z dε. The step is
/// integrated by backward Euler.
#[derive(Clone, Debug, PartialEq)]
pub struct Bwbn {
    /// Ratio of post-yield to elastic stiffness α.
    pub alpha: f64,
    /// Elastic stiffness k₀.
    pub ko: f64,
    /// Sharpness of the transition n.
    pub n: f64,
    /// Loop shape γ.
    pub gamma: f64,
    /// Loop shape β.
    pub beta: f64,
    /// A.
    pub ao: f64,
    /// Share q of z_u at which the pinching is strongest.
    pub q: f64,
    /// Total slip ζ_s.
    pub zetas: f64,
    /// Rate p of the pinching.
    pub p: f64,
    /// Spread ψ of the pinching.
    pub shi: f64,
    /// Growth δ_ψ of the spread per energy.
    pub delta_shi: f64,
    /// λ.
    pub lambda: f64,
    /// Tolerance of z.
    pub tolerance: f64,
    /// Greatest number of iterations.
    pub iterations: usize,
}

crate::state_struct! {
    /// History of [`Bwbn`].
    pub struct History {
        /// Strain.
        strain: f64,
        /// Hysteretic displacement z.
        z: f64,
        /// Dissipated energy e.
        e: f64,
        /// Tangent minus the initial tangent.
        softening: f64,
    }
}

/// Sign of a direction; that of 0 is negative, as in OpenSees.
fn sign(x: f64) -> f64 {
    if x > 0.0 { 1.0 } else { -1.0 }
}

/// ż / ε̇ and its derivatives with respect to z and e.
struct Rate {
    value: f64,
    by_z: f64,
    by_e: f64,
}

impl Bwbn {
    fn rate(&self, z: f64, e: f64, way: f64) -> Rate {
        let decay = (-self.p * e).exp();
        let (zeta1, zeta1_e) = (self.zetas * (1.0 - decay), self.zetas * self.p * decay);
        let zeta2 = (self.shi + self.delta_shi * e) * (self.lambda + zeta1);
        let zeta2_e = self.delta_shi * (self.lambda + zeta1) + (self.shi + self.delta_shi * e) * zeta1_e;
        let u = z * way - self.q * (self.beta + self.gamma).powf(-1.0 / self.n);
        let bell = (-(u * u) / (zeta2 * zeta2)).exp();
        let h = 1.0 - zeta1 * bell;
        let h_z = zeta1 * bell * 2.0 * u * way / (zeta2 * zeta2);
        let h_e = -bell * (zeta1_e + zeta1 * 2.0 * u * u * zeta2_e / zeta2.powi(3));
        let psi = self.gamma + self.beta * sign(way * z);
        let phi = self.ao - z.abs().powf(self.n) * psi;
        let phi_z = if z == 0.0 { 0.0 } else { -self.n * z.abs().powf(self.n - 1.0) * z.signum() * psi };
        Rate { value: phi * h, by_z: phi_z * h + phi * h_z, by_e: phi * h_e }
    }
}

impl UniaxialLaw for Bwbn {
    type State = History;
    const NAME: &'static str = "BWBN";

    fn update(&self, c: &History, strain: Strain) -> MaterialResult<(Stress, History)> {
        let d = strain.value - c.strain;
        let (k, initial) = ((1.0 - self.alpha) * self.ko, UniaxialLaw::initial_tangent(self));
        let elastic = self.alpha * self.ko;
        if d == 0.0 {
            let value = elastic * strain.value + k * c.z;
            return Ok((Stress { value, tangent: initial + c.softening, damping: 0.0 }, *c));
        }
        let way = sign(d);
        let mut z = START;
        for _ in 0..self.iterations {
            let rate = self.rate(z, c.e + k * d * z, way);
            let residual = z - c.z - rate.value * d;
            let step = residual / (1.0 - (rate.by_z + rate.by_e * k * d) * d);
            z -= step;
            if step.abs() <= self.tolerance {
                break;
            }
        }
        let e = c.e + k * d * z;
        let rate = self.rate(z, e, way);
        // Implicit derivative of the backward Euler equation.
        let slope = (rate.value + rate.by_e * k * z * d) / (1.0 - (rate.by_z + rate.by_e * k * d) * d);
        let (value, tangent) = (elastic * strain.value + k * z, elastic + k * slope);
        if !(value.is_finite() && tangent.is_finite()) {
            return Err(MaterialError(format!(
                "BWBN found no hysteretic displacement for a strain increment of {d:.6e}"
            )));
        }
        Ok((
            Stress { value, tangent, damping: 0.0 },
            History { strain: strain.value, z, e, softening: tangent - initial },
        ))
    }

    fn initial_tangent(&self) -> f64 {
        self.alpha * self.ko + (1.0 - self.alpha) * self.ko * self.ao
    }
}
