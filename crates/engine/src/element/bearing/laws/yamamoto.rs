//! Shear law of `YamamotoBiaxialHDR`.

mod opensees;

use crate::element::bearing::elements::shear_bearing::end_masses;
use crate::element::bearing::laws::shear::{Shear, ShearLaw};
use crate::element::{Class, ElementResult, Mass};
use crate::rules::{Consistent, OpenSees};
use std::f64::consts::PI;
use std::fmt;

/// Exponent n of the evolution of Q.
const EXPONENT: f64 = 0.7;
/// Ratio of the displacement α of the evolution of Q to the rubber thickness.
const ALPHA: f64 = 0.25;
/// Pa per MPa: stresses are in MPa, forces in N for lengths in m.
const MEGA: f64 = 1e6;
/// Largest step of the integration of Q, in α.
const STEP: f64 = 0.05;

/// Bidirectional shear of a high damping rubber bearing: F = A [τ_r(γ) u/|u| + τ_s(γ) Q] with the shear strain γ = |u|
/// / H_r. Q evolves as dQ/dl = (t - |Q|ⁿ Q/|Q|) / α along a path of length l and direction t.
///
/// Source: Yamamoto, Minewaki, Yoneda and Higashino (2012), <https://doi.org/10.1002/eqe.1161>, with the coefficients
/// of Bridgestone's X0.6R in OpenSees.
#[derive(Clone, Debug, PartialEq)]
pub struct YamamotoShear<R = Consistent> {
    /// Area A of the rubber, m² for forces in N.
    pub area: f64,
    /// Total thickness H_r of the rubber.
    pub height: f64,
    /// Factor c_r of τ_r.
    pub cr: f64,
    /// Factor c_s of τ_s.
    pub cs: f64,
    rules: R,
}

/// Rules of [`YamamotoShear`] that differ in OpenSees.
pub trait Rules: Clone + fmt::Debug + Send + Sync {
    /// Q after an increment of displacement, of `length` over α, from `start` with its rate.
    fn integrate(start: Evolution, length: f64, rate: impl Fn(Evolution) -> Evolution) -> Evolution {
        runge_kutta(start, length, rate)
    }

    /// Returns true if the stiffness is always the initial one.
    fn keeps_stiffness() -> bool {
        false
    }

    /// Masses of the ends.
    fn masses(masses: Mass) -> Mass {
        masses
    }
}

impl Rules for Consistent {}

/// Q and its derivatives by the increment of displacement, by rows.
pub(super) type Evolution = ([f64; 2], [[f64; 2]; 2]);

impl YamamotoShear {
    /// Makes the law of a rubber ring with outer and inner diameter.
    pub fn new(diameters: [f64; 2], height: f64, factors: [f64; 2]) -> Self {
        Self::of(diameters, height, factors, Consistent)
    }
}

impl YamamotoShear<OpenSees> {
    /// As `new`, by the rules of OpenSees.
    pub fn as_opensees(diameters: [f64; 2], height: f64, factors: [f64; 2]) -> Self {
        Self::of(diameters, height, factors, OpenSees)
    }
}

impl<R: Rules> YamamotoShear<R> {
    fn of([outer, inner]: [f64; 2], height: f64, [cr, cs]: [f64; 2], rules: R) -> Self {
        Self { area: PI / 4.0 * (outer * outer - inner * inner), height, cr, cs, rules }
    }

    /// |Q|ⁿ Q/|Q| and its derivatives.
    fn recovery(q: [f64; 2]) -> Evolution {
        let size = q[0].hypot(q[1]);
        if size < f64::EPSILON {
            return Default::default();
        }
        let power = size.powf(EXPONENT - 1.0);
        let n = q.map(|q| q / size);
        let slope = |i: usize, j: usize| power * ((EXPONENT - 1.0) * n[i] * n[j] + f64::from(u8::from(i == j)));
        (q.map(|q| power * q), [[slope(0, 0), slope(0, 1)], [slope(1, 0), slope(1, 1)]])
    }

    /// Q after an increment `d` of displacement over α.
    fn evolve(q: [f64; 2], d: [f64; 2]) -> Evolution {
        let length = d[0].hypot(d[1]);
        if length < f64::EPSILON {
            return (q, [[1.0, 0.0], [0.0, 1.0]]);
        }
        let t = d.map(|d| d / length);
        // Derivatives by the path, scaled to a unit interval.
        let rate = |(q, dq): Evolution| -> Evolution {
            let (r, dr) = Self::recovery(q);
            let value = std::array::from_fn(|i| d[i] - length * r[i]);
            let slope = std::array::from_fn(|i| {
                std::array::from_fn(|j| {
                    let carried = dr[i][0] * dq[0][j] + dr[i][1] * dq[1][j];
                    f64::from(u8::from(i == j)) - t[j] * r[i] - length * carried
                })
            });
            (value, slope)
        };
        R::integrate((q, [[0.0; 2]; 2]), length, rate)
    }

    /// A τ_r and A τ_s, each with its derivative by γ.
    fn skeleton(&self, gamma: f64) -> [(f64, f64); 2] {
        let over = (gamma - 1.8).max(0.0);
        let r = MEGA * self.area * self.cr;
        let s = MEGA * self.area * self.cs;
        [
            (r * (0.22 * gamma + 0.20 * over * over), r * (0.22 + 0.40 * over)),
            (s * (0.25 + 0.02 * gamma + 0.016 * gamma.powi(3)), s * (0.02 + 0.048 * gamma * gamma)),
        ]
    }

    /// Initial stiffness.
    fn initial(&self) -> f64 {
        (0.22 * self.cr + 1.0 * self.cs) * MEGA * self.area / self.height
    }
}

/// Runge-Kutta method in short steps.
fn runge_kutta(start: Evolution, length: f64, rate: impl Fn(Evolution) -> Evolution) -> Evolution {
    let steps = (length / STEP).ceil();
    let h = 1.0 / steps;
    let mut at = start;
    for _ in 0..steps as usize {
        let k1 = rate(at);
        let k2 = rate(along(at, k1, 0.5 * h));
        let k3 = rate(along(at, k2, 0.5 * h));
        let k4 = rate(along(at, k3, h));
        for (k, weight) in [(k1, 1.0), (k2, 2.0), (k3, 2.0), (k4, 1.0)] {
            at = along(at, k, weight * h / 6.0);
        }
    }
    at
}

/// A step of size `h` from a state of Q at a rate.
fn along((q, dq): Evolution, (rate, slope): Evolution, h: f64) -> Evolution {
    let value = std::array::from_fn(|i| q[i] + h * rate[i]);
    (value, std::array::from_fn(|i| std::array::from_fn(|j| dq[i][j] + h * slope[i][j])))
}

impl<R: Rules> ShearLaw<2> for YamamotoShear<R> {
    const CLASS: [Class; 2] = [Class::new("YamamotoBiaxialHDR", 161); 2];
    const HYSTERETIC: bool = false;
    const REPORTS_INERTIA: bool = true;
    const RENEWS_DAMPING: bool = false;

    fn virgin(&self) -> Shear<2> {
        let k = self.initial();
        Shear { k: [[k, 0.0], [0.0, k]], ..Shear::default() }
    }

    fn step(&self, c: &Shear<2>, u: [f64; 2]) -> ElementResult<Shear<2>> {
        if u == c.u {
            return Ok(*c);
        }
        let alpha = ALPHA * self.height;
        let (internal, dq) = Self::evolve(c.internal, std::array::from_fn(|i| (u[i] - c.u[i]) / alpha));
        let size = u[0].hypot(u[1]);
        let gamma = size / self.height;
        let [(fr, kr), (fs, ks)] = self.skeleton(gamma);
        let n = if size > 0.0 { u.map(|u| u / size) } else { [0.0; 2] };
        let q = std::array::from_fn(|i| fr * n[i] + fs * internal[i]);
        if R::keeps_stiffness() {
            return Ok(Shear { u, internal, q, k: self.virgin().k });
        }
        // F_r / |u|, which is constant at small strains.
        let secant = if size > 0.0 { fr / size } else { kr / self.height };
        let k = std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                let round = if i == j { secant } else { 0.0 };
                let radial = (kr / self.height - secant) * n[i] * n[j] + ks / self.height * internal[i] * n[j];
                round + radial + fs / alpha * dq[i][j]
            })
        });
        Ok(Shear { u, internal, q, k })
    }

    fn masses(&self, mass: f64) -> Mass {
        R::masses(end_masses(mass, 6, 3))
    }
}
