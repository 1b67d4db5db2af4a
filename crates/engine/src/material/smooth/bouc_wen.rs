//! Bouc-Wen hysteresis with degradation (Baber and Noori, 1985; Haukaas and Der Kiureghian, 2004).

use crate::material::{MaterialError, MaterialResult, Strain, Stress, UniaxialLaw};
use crate::numeric::{bracketed_root, sign};

/// Maximum number of iterations for z; bisection alone needs fewer.
const MAX_ITERATIONS: u32 = 120;

/// σ = α k₀ ε + (1-α) k₀ z with ż = [A - |z|ⁿ (γ + β sign(ε̇ z)) ν] ε̇ / η. A, ν and η are linear in the dissipated
/// energy e = ∫ (1-α) k₀ z dε. The step is integrated by backward Euler, solved to round-off.
#[derive(Clone, Debug, PartialEq)]
pub struct BoucWen {
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
    /// Initial A.
    pub ao: f64,
    /// Loss of A per energy.
    pub delta_a: f64,
    /// Growth of ν per energy.
    pub delta_nu: f64,
    /// Growth of η per energy.
    pub delta_eta: f64,
}

crate::state_struct! {
    /// History of [`BoucWen`].
    pub struct History {
        /// Strain.
        strain: f64,
        /// Hysteretic displacement z.
        z: f64,
        /// Dissipated energy e.
        e: f64,
        /// Tangent minus the initial tangent, so that the virgin state is zero.
        softening: f64,
    }
}

impl BoucWen {
    /// Returns |z|ⁿ and n |z|ⁿ⁻¹ sign z, without `powf` for n = 1 and n = 2.
    #[inline]
    fn power(&self, z: f64) -> (f64, f64) {
        let a = z.abs();
        if self.n == 1.0 {
            (a, if z == 0.0 { 0.0 } else { z.signum() })
        } else if self.n == 2.0 {
            (a * a, 2.0 * z)
        } else if a == 0.0 {
            (0.0, 0.0)
        } else {
            let p = a.powf(self.n - 1.0);
            (p * a, self.n * p * z.signum())
        }
    }

    /// A, ν, η at energy e.
    #[inline]
    fn degrade(&self, e: f64) -> (f64, f64, f64) {
        (self.ao - self.delta_a * e, 1.0 + self.delta_nu * e, 1.0 + self.delta_eta * e)
    }

    /// Residual of the backward Euler step and its derivative with respect to z.
    #[inline]
    fn residual(&self, c: &History, d: f64, z: f64) -> (f64, f64) {
        let k = (1.0 - self.alpha) * self.ko;
        let (a, nu, eta) = self.degrade(c.e + k * d * z);
        let (pow, dpow) = self.power(z);
        let psi = self.gamma + self.beta * sign(d * z);
        let phi = a - pow * psi * nu;
        let de = k * d;
        let dphi = -self.delta_a * de - dpow * psi * nu - pow * psi * self.delta_nu * de;
        (z - c.z - phi / eta * d, 1.0 - (dphi * eta - phi * self.delta_eta * de) / (eta * eta) * d)
    }

    /// z at the end of the step: the root that continues the committed z as the step grows from zero.
    ///
    /// In the direction of the step (y = z sign d) it is the last root. Other roots may lie behind y_c if the law
    /// unloads steeply (γ > β). Newton's method from z_c would converge to one of them after a large step.
    fn solve(&self, c: &History, d: f64) -> MaterialResult<f64> {
        let s = d.signum();
        let along = |y: f64| {
            let (value, slope) = self.residual(c, d, s * y);
            (s * value, slope)
        };
        let (mut start, mut bracket) = (s * c.z, (f64::NEG_INFINITY, f64::INFINITY));
        if start < 0.0 {
            // The residual rises from y_c to its root unless it is positive at y_c; the root is then approached from
            // zero.
            if along(start).0 > 0.0 { start = 0.0 } else { bracket.0 = start }
        }
        let root = bracketed_root(along, bracket, start, c.z.abs().max(d.abs()), MAX_ITERATIONS);
        root.map(|y| s * y).ok_or_else(|| {
            MaterialError(format!("BoucWen found no hysteretic displacement for a strain increment of {d:.6e}"))
        })
    }
}

impl UniaxialLaw for BoucWen {
    type State = History;
    const NAME: &'static str = "BoucWen";

    fn update(&self, c: &History, strain: Strain) -> MaterialResult<(Stress, History)> {
        let d = strain.value - c.strain;
        let initial = UniaxialLaw::initial_tangent(self);
        if d == 0.0 {
            // The direction of the next step is unknown at rest, so the tangent of the last step is kept.
            let value = self.alpha * self.ko * strain.value + (1.0 - self.alpha) * self.ko * c.z;
            return Ok((Stress { value, tangent: initial + c.softening, damping: 0.0 }, *c));
        }
        let z = self.solve(c, d)?;
        let k = (1.0 - self.alpha) * self.ko;
        let e = c.e + k * d * z;
        let (a, nu, eta) = self.degrade(e);
        let (pow, dpow) = self.power(z);
        let psi = self.gamma + self.beta * sign(d * z);
        let phi = a - pow * psi * nu;
        // Implicit derivative of the backward Euler equation.
        let loss = self.delta_a + pow * psi * self.delta_nu + phi / eta * self.delta_eta;
        let b4 = (phi - d * k * z * loss) / eta;
        let b5 = 1.0 + d / eta * (dpow * psi * nu + k * d * loss);
        let tangent = self.alpha * self.ko + k * b4 / b5;
        let stress = Stress { value: self.alpha * self.ko * strain.value + k * z, tangent, damping: 0.0 };
        Ok((stress, History { strain: strain.value, z, e, softening: tangent - initial }))
    }

    fn initial_tangent(&self) -> f64 {
        self.alpha * self.ko + (1.0 - self.alpha) * self.ko * self.ao
    }
}
