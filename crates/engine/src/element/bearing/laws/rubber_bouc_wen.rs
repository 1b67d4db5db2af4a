//! Shear law of `ElastomericX` and `LeadRubberX`.

use crate::element::bearing::laws::axial::Axial;
use crate::element::bearing::laws::lead::LeadCore;
use crate::element::bearing::laws::rubber_shear::{OWN, RubberShear, ShearInput, ShearStep};
use crate::element::bearing::laws::shear::{Shear, at_rest};
use crate::probe::Probe;

/// Loop shape parameters of ż = (k₀/q_y) [u̇ - z (z₁u̇₁ (β + γ sign(z₁u̇₁)) + z₂u̇₂ (β + γ sign(z₂u̇₂)))].
const BETA: f64 = 0.1;
const GAMMA: f64 = 0.9;

/// Rubber in parallel with a hysteretic part: q = k_e u + q_y z + c_d u̇ with Bouc-Wen's z.
///
/// Source: S. Nagarajaiah, A. M. Reinhorn and M. C. Constantinou, "Nonlinear dynamic analysis of 3-D base-isolated
/// structures", Journal of Structural Engineering 117 (1991) 2035-2054, as used by Kumar, Whittaker and Constantinou
/// (2014). The rubber stiffness decreases with the axial force, k_e = (G A / T_r) (1 - (N/P_cr)²), and the yield force
/// with the temperature of a lead core. Backward Euler; the yield force is that at the committed temperature.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RubberBoucWen {
    /// Yield force at zero temperature rise.
    pub qy: f64,
    /// Initial stiffness of the hysteretic part k₀ = (1/α - 1) G A / T_r.
    pub k0: f64,
    /// Stiffness of the rubber without axial force G A / T_r.
    pub rubber: f64,
    /// Viscous damping c_d.
    pub cd: f64,
    /// The rubber stiffness depends on the axial force.
    pub varies: bool,
    /// True for `LeadRubberX`.
    pub leaded: bool,
    /// Lead core, if any.
    pub core: Option<LeadCore>,
    /// Heating of the core lowers the yield force.
    pub heats: bool,
    /// OpenSees' scheme and tangent.
    pub compat: bool,
}

crate::state_struct! {
    /// State variables besides [`Shear`].
    pub struct Warmth {
        /// ∂z/∂u by rows.
        dz: [f64; 4],
        /// Stiffness of the rubber.
        ke: f64,
        /// Yield force.
        qy: f64,
        /// Temperature rise.
        rise: f64,
        /// Domain time.
        time: f64,
    }
}

/// z du (β + γ sign(z du)), and its derivative by the product z du.
#[inline]
fn share(product: f64) -> (f64, f64) {
    let slope = BETA + GAMMA * crate::numeric::sign(product);
    (product * slope, slope)
}

/// Backward Euler for an increment `d` of displacement over yield displacement: z and ∂z/∂d.
///
/// z = z_c + d - z τ with τ = Σ z_i d_i (β + γ sign(z_i d_i)), so z is parallel to w = z_c + d. With z = t w it is t +
/// s t² = 1, where s = Σ w_i d_i (β + γ sign(w_i d_i)) ≥ 0 since γ > β.
#[inline]
fn hysteresis(zc: [f64; 2], d: [f64; 2]) -> ([f64; 2], [[f64; 2]; 2]) {
    let w = [zc[0] + d[0], zc[1] + d[1]];
    let parts = [share(w[0] * d[0]), share(w[1] * d[1])];
    let s = parts[0].0 + parts[1].0;
    let root = (1.0 + 4.0 * s).sqrt();
    let t = 2.0 / (1.0 + root);
    // The square root also equals 1 + 2 s t.
    let dt: [f64; 2] = std::array::from_fn(|j| -t * t / root * parts[j].1 * (w[j] + d[j]));
    let dz = std::array::from_fn(|i| std::array::from_fn(|j| w[i] * dt[j] + if i == j { t } else { 0.0 }));
    (w.map(|w| t * w), dz)
}

/// OpenSees' ∂z/∂d: along the increment, with a constant ratio of its components.
fn rate_tangent(z: [f64; 2], d: [f64; 2]) -> [[f64; 2]; 2] {
    let slope = [share(z[0] * d[0]).1, share(z[1] * d[1]).1];
    let (r12, r21) = if d[0] * d[1] == 0.0 { (0.0, 0.0) } else { (d[0] / d[1], d[1] / d[0]) };
    let first = z[0] * slope[0] + z[1] * slope[1] * r21;
    let second = z[0] * slope[0] * r12 + z[1] * slope[1];
    [[1.0 - z[0] * first, r12 - z[0] * second], [r21 - z[1] * first, 1.0 - z[1] * second]]
}

impl RubberBoucWen {
    /// Ratio of the rubber stiffness to that without axial force, and its derivative by N/P_cr.
    #[inline]
    fn left(&self, ratio: f64) -> (f64, f64) {
        if self.varies { (1.0 - ratio * ratio, -2.0 * ratio) } else { (1.0, 0.0) }
    }

    /// Temperature rise and yield force for the next step.
    fn warm(&self, c: &Shear<2>, m: &Warmth, z: [f64; 2], at: &ShearInput<'_>) -> (f64, f64) {
        let Some(core) = &self.core else { return (m.rise, m.qy) };
        let length = |v: [f64; 2]| (v[0] * v[0] + v[1] * v[1]).sqrt();
        let speed = length(at.rate);
        let rise = if self.compat {
            // Without a time step OpenSees counts from the last time, or from 0 after the domain time was set back.
            let since = if at.time < m.time { 0.0 } else { m.time };
            let passed = if at.dt > 0.0 { at.dt } else { at.time - since };
            core.warm_as_opensees(m.rise, m.qy * length(c.internal), speed, at.time, passed)
        } else {
            core.warm(m.rise, m.qy * length(z), speed, at.time, at.dt)
        };
        (rise, if self.heats { self.qy * LeadCore::strength(rise) } else { self.qy })
    }
}

impl RubberShear for RubberBoucWen {
    type Memory = Warmth;

    fn class(&self) -> &'static str {
        if self.leaded { "LeadRubberX" } else { "ElastomericX" }
    }
    fn is_viscous(&self) -> bool {
        self.cd > 0.0
    }
    fn depends_on_time(&self) -> bool {
        self.core.is_some()
    }

    fn virgin(&self) -> (Shear<2>, Warmth) {
        let (k, z) = (self.k0 + self.rubber, self.k0 / self.qy);
        let memory = Warmth { dz: [z, 0.0, 0.0, z], ke: self.rubber, qy: self.qy, rise: 0.0, time: 0.0 };
        (Shear { k: [[k, 0.0], [0.0, k]], ..Shear::default() }, memory)
    }

    fn step(&self, c: &Shear<2>, m: &Warmth, _: &Warmth, at: &ShearInput<'_>) -> ShearStep<Warmth> {
        let (u, qy, scale) = (at.u, m.qy, self.k0 / m.qy);
        let step = [u[0] - c.u[0], u[1] - c.u[1]];
        let moved = !at_rest(&u, &c.u);
        let (mut z, mut dz) = (c.internal, [[m.dz[0], m.dz[1]], [m.dz[2], m.dz[3]]]);
        if moved {
            let d = step.map(|s| s * scale);
            (z, dz) = hysteresis(c.internal, d);
            if self.compat {
                dz = rate_tangent(z, d);
            }
            dz = dz.map(|row| row.map(|x| x * scale));
        }
        // Like its axial law, OpenSees uses the axial force of the last step.
        let axial = at.axial;
        let ratio = axial.next.force / axial.critical;
        let (left, d_left) = self.left(ratio);
        let ke = if self.compat { m.ke } else { self.rubber * left };
        let mut k: [[f64; 2]; 2] =
            std::array::from_fn(|i| std::array::from_fn(|j| qy * dz[i][j] + if i == j { ke } else { 0.0 }));
        let mut q = std::array::from_fn(|i| self.cd * at.rate[i] + qy * z[i] + ke * u[i]);
        let mut k_axial = [0.0; 2];
        let mut damping = self.cd;
        if self.compat {
            damping = 0.0;
            if !moved {
                // OpenSees keeps force and tangent for a bitwise equal displacement.
                (q, k) = (c.q, c.k);
            } else if self.cd > 0.0 && at.dt > 0.0 {
                (0..2).for_each(|i| k[i][i] += self.cd / at.dt);
            }
        } else if d_left != 0.0 {
            let slope = self.rubber * d_left / axial.critical;
            k_axial = u.map(|u| u * slope * axial.k);
            if at.size > 0.0 {
                let by_size = slope * (axial.k_shear - ratio * axial.d_critical);
                for i in 0..2 {
                    for j in 0..2 {
                        k[i][j] += u[i] * by_size * u[j] / at.size;
                    }
                }
            }
        }
        let (rise, next_qy) = self.warm(c, m, z, at);
        let next_ke = if self.compat { self.rubber * self.left(axial.next.force / axial.next.fcrn).0 } else { ke };
        let memory =
            Warmth { dz: [dz[0][0], dz[0][1], dz[1][0], dz[1][1]], ke: next_ke, qy: next_qy, rise, time: at.time };
        ShearStep { shear: Shear { u, internal: z, q, k }, memory, k_axial, damping }
    }

    fn probe(&self, words: &[&str]) -> Option<Probe> {
        Some(match *words.first()? {
            "hystereticParameter" | "hystParameter" | "hystereticParam" | "hystParam" | "z" => {
                Probe::new(OWN, ["z1", "z2"])
            }
            "dzdu" => Probe::new(OWN + 1, ["dz1du1", "dz1du2", "dz2du1", "dz2du2"]),
            "param" | "Param" | "parameters" | "Parameters" if self.leaded => {
                Probe::new(OWN + 2, ["Fcn", "Fcrn", "Kv", "ke", "DeltaT", "qYield"])
            }
            "param" | "Param" | "parameters" | "Parameters" => Probe::new(OWN + 2, ["Fcn", "Fcrn", "Kv", "ke"]),
            _ => return None,
        })
    }

    fn probe_names(&self) -> &'static [&'static str] {
        &[
            "hystereticParameter",
            "dzdu",
            "parameters",
            "localForce",
            "basicForce",
            "localDisplacement",
            "deformation",
            "basicDeformation",
            "basicStiffness",
        ]
    }

    fn read(&self, id: u32, shear: &Shear<2>, m: &Warmth, _: &[f64], axial: &Axial, out: &mut [f64]) {
        let all = [axial.fcn, axial.fcrn, axial.kv, m.ke, m.rise, m.qy];
        let from: &[f64] = match id {
            OWN => &shear.internal,
            OWN_DZ => &m.dz,
            _ => &all,
        };
        out.copy_from_slice(&from[..out.len()]);
    }
}

const OWN_DZ: u32 = OWN + 1;
