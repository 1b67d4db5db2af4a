//! Shear of high damping rubber bearings: softening by largest strain and by cycles, stiffening, and temporary hardening.
//!
//! Equations: J. A. Gallardo, J. C. de la Llera, J. I. Restrepo, M. Chen (2023), A numerical model for non-linear shear
//! behavior of high damping rubber bearings, Engineering Structures 289, 116234, as their published programs step them.

use crate::material::{MaterialError, MaterialResult, Strain, Stress, UniaxialLaw, finite};
use crate::numeric::bracketed_root;

/// Speed at which the softening follows an outward increment of the strain.
const OUTWARD: f64 = 0.5;
/// The same of an inward increment.
const INWARD: f64 = 4.0;
/// Iterations for z in a step. Where z crosses zero its rate has a kink, and the bracket is halved.
const ITERATIONS: u32 = 200;

/// exp(-f xᵖ): a stiffness that falls with a measure of the history.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Decay {
    /// f, at least 0.
    pub factor: f64,
    /// p, greater than 0.
    pub power: f64,
}

impl Decay {
    /// Value, and its derivative over the value, for a measure and the derivative of the measure.
    fn at(self, x: f64, slope: f64) -> (f64, f64) {
        let log = self.factor * x.powf(self.power);
        ((-log).exp(), if x > 0.0 { -self.power * log / x * slope } else { 0.0 })
    }
}

/// F = k₁ k_m a₁ γ + k₁ k₂ a₂ γ³ + k₁ k₃ a₃ γ⁵ + f_y z, with the shear strain γ = u / h.
///
/// k₁, k₂ and k₃ fall with γ_s, which follows the largest strain of its side: by a half of outward increments and by four
/// times inward ones. k_m falls with the sum of inward increments. Each side has its own.
///
/// dz = (k_y / f_y) dγ [1 - |z|^η (β sgn(z dγ) + 1 - β - φ sgn dγ (sgn z + sgn dγ))], by the midpoint rule. When z changes
/// its sign, φ = φ_max (1 - exp(-P_φ |γ_r - u_y| / u_y)), where γ_r is the strain of the last reversal and u_y = f_y / k_y.
#[derive(Clone, Debug, PartialEq)]
pub struct GallardoShear {
    /// a₁, a₂, a₃, force.
    pub a: [f64; 3],
    /// Softening by γ_s of the three: k₁, k₂, k₃.
    pub softening: [Decay; 3],
    /// Softening k_m by cycles.
    pub cycling: Decay,
    /// Stiffness k_y of the hysteretic part, force per strain.
    pub ky: f64,
    /// Its strength f_y, force.
    pub fy: f64,
    /// Loop shape β, from 0.5 to 1.
    pub beta: f64,
    /// Sharpness η of the transition.
    pub eta: f64,
    /// Largest temporary hardening φ_max, less than 0.5.
    pub phi_max: f64,
    /// Rate P_φ of the temporary hardening.
    pub phi_rate: f64,
    /// Thickness h of the rubber.
    pub height: f64,
}

crate::state_struct! {
    /// History of [`GallardoShear`]; the first of a pair is that of positive strains.
    pub struct History {
        /// Shear strain γ.
        strain: f64,
        /// Sign of the last increment.
        direction: f64,
        /// γ_s.
        followed: [f64; 2],
        /// Largest strain.
        largest: [f64; 2],
        /// Sum of inward increments.
        returned: [f64; 2],
        /// z.
        z: f64,
        /// |γ_r - u_y|.
        reach: f64,
        /// φ.
        phi: f64,
    }
}

/// Sign, zero for zero.
fn sign(x: f64) -> f64 {
    if x == 0.0 { 0.0 } else { x.signum() }
}

impl GallardoShear {
    /// Elastic force and its derivative with respect to the strain; the histories of a side are stepped.
    fn elastic(&self, c: &History, next: &mut History, d: f64) -> (f64, f64) {
        let x = next.strain;
        let (i, side) = if x >= 0.0 { (0, 1.0) } else { (1, -1.0) };
        let outward = side * d;
        let grows = outward >= 0.0 && x.abs() > c.largest[i];
        next.largest[i] = if grows { x.abs() } else { c.largest[i] };
        let speed = if outward >= 0.0 { OUTWARD } else { -INWARD };
        let followed = c.followed[i] + speed * outward;
        let slope = if followed < next.largest[i] { speed * side } else { f64::from(grows) * side };
        next.followed[i] = followed.min(next.largest[i]);
        next.returned[i] = c.returned[i] + (-outward).max(0.0);
        let returning = if outward < 0.0 { -side } else { 0.0 };

        let [k1, k2, k3] = self.softening.map(|s| s.at(next.followed[i], slope));
        let km = self.cycling.at(next.returned[i], returning);
        let terms = [(1, km), (3, k2), (5, k3)].into_iter().zip(self.a);
        terms.fold((0.0, 0.0), |(force, tangent), ((power, own), a)| {
            let k = k1.0 * own.0 * a;
            let slope = k * f64::from(power) * x.powi(power - 1);
            let term = k * x.powi(power);
            (force + term, tangent + slope + term * (k1.1 + own.1))
        })
    }

    /// z after an increment, and dz/dγ; `None` if the iteration does not end.
    fn hysteretic(&self, z: f64, phi: f64, d: f64) -> Option<(f64, f64)> {
        let rate = self.ky / self.fy;
        // In the direction of the increment.
        let (old, reach, direction) = (sign(d) * z, rate * d.abs(), sign(d));
        let shape = |y: f64| {
            let middle = 0.5 * (old + y);
            let c = if middle > 0.0 { 1.0 - 2.0 * phi } else { 1.0 - 2.0 * self.beta };
            let bent = c * middle.abs().powf(self.eta);
            let steep = if middle == 0.0 { 0.0 } else { 0.5 * self.eta * bent / middle };
            (1.0 - bent, steep)
        };
        let equation = |y: f64| {
            let (free, steep) = shape(y);
            (y - old - reach * free, 1.0 + reach * steep)
        };
        // The middle of the step lies between its beginning and the limit of z.
        let limit = (1.0 / (1.0 - 2.0 * phi)).powf(1.0 / self.eta);
        let other = 2.0 * limit - old;
        let bracket = if old < other { (old, other) } else { (other, old) };
        let y = bracketed_root(equation, bracket, old.clamp(bracket.0, bracket.1), limit, ITERATIONS)?;
        let (free, steep) = shape(y);
        Some((direction * y, rate * free / (1.0 + reach * steep)))
    }
}

impl UniaxialLaw for GallardoShear {
    type State = History;
    const NAME: &'static str = "HDR_mat";

    fn update(&self, c: &History, strain: Strain) -> MaterialResult<(Stress, History)> {
        let x = strain.value / self.height;
        let d = x - c.strain;
        let mut next = History { strain: x, ..*c };
        let (elastic, slope) = self.elastic(c, &mut next, d);
        let none =
            || MaterialError(format!("HDR_mat found no hysteretic force at a displacement of {:.6e}", strain.value));
        let (z, by_strain) = if d == 0.0 {
            let direction = if c.direction == 0.0 { 1.0 } else { c.direction };
            (c.z, self.hysteretic(c.z, c.phi, direction * f64::MIN_POSITIVE).ok_or_else(none)?.1)
        } else {
            next.direction = sign(d);
            self.hysteretic(c.z, c.phi, d).ok_or_else(none)?
        };
        next.z = z;
        let yielded = self.fy / self.ky;
        if next.direction * c.direction < 0.0 {
            next.reach = (c.strain - yielded).abs();
        }
        if sign(z) != sign(c.z) {
            next.phi = self.phi_max * (1.0 - (-self.phi_rate * next.reach / yielded).exp());
        }
        let tangent = (slope + self.fy * by_strain) / self.height;
        finite(Self::NAME, strain.value, elastic + self.fy * z, tangent, next)
    }

    fn initial_tangent(&self) -> f64 {
        (self.a[0] + self.ky) / self.height
    }
}
