//! Shear law of `ElastomericX` and `LeadRubberX`.

mod opensees;

use crate::element::Class;
use crate::element::bearing::laws::axial::{Axial, AxialStep};
use crate::element::bearing::laws::lead::LeadCore;
use crate::element::bearing::laws::rubber_shear::{OWN, RubberShear, ShearInput, ShearStep};
use crate::element::bearing::laws::shear::{Shear, at_rest};
use crate::probe::Probe;
use crate::rules::Consistent;
use std::fmt;

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
pub struct RubberBoucWen<R = Consistent> {
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
    /// Rules of the heating, of the rubber under axial force and of the tangent.
    pub rules: R,
}

/// Force and tangent of a step on their way.
#[derive(Clone, Copy, Debug)]
pub struct Trial {
    /// Force.
    q: [f64; 2],
    /// Stiffness by rows.
    k: [[f64; 2]; 2],
    /// ∂q by the axial displacement.
    k_axial: [f64; 2],
    /// ∂q by the rate.
    damping: f64,
}

/// Rules of [`RubberBoucWen`] that differ in OpenSees.
pub trait Rules: Copy + fmt::Debug + Send + Sync {
    /// Rise of temperature at the end of a step. `z` is that of the committed state and of the trial state, `qy` the yield force.
    fn warm(core: &LeadCore, m: &Warmth, [_, z]: [[f64; 2]; 2], at: &ShearInput<'_>) -> f64 {
        core.warm(m.rise, m.qy * length(z), length(at.rate), at.time, at.dt)
    }

    /// ∂z/∂d for an increment `d` over the yield displacement; `exact` is the derivative of the step.
    fn hysteretic_tangent(_z: [f64; 2], _d: [f64; 2], exact: [[f64; 2]; 2]) -> [[f64; 2]; 2] {
        exact
    }

    /// Stiffness of the rubber in a step: that of its axial force, or the one that was kept from the step before.
    fn rubber(_kept: f64, now: f64) -> f64 {
        now
    }

    /// Stiffness of the rubber that is kept for the next step.
    fn keep(_law: &RubberBoucWen<Self>, _axial: &AxialStep, now: f64) -> f64 {
        now
    }

    /// Complete the force and the tangent of a step from the committed state `c`, with the ratio N/P_cr and the derivative by it of the
    /// part of the stiffness that is left.
    fn complete(
        law: &RubberBoucWen<Self>,
        _moved: bool,
        _c: &Shear<2>,
        at: &ShearInput<'_>,
        (ratio, d_left): (f64, f64),
        t: &mut Trial,
    ) {
        if d_left == 0.0 {
            return;
        }
        let axial = at.axial;
        let slope = law.rubber * d_left / axial.critical;
        t.k_axial = at.u.map(|u| u * slope * axial.k);
        if at.size > 0.0 {
            let by_size = slope * (axial.k_shear - ratio * axial.d_critical);
            for i in 0..2 {
                for j in 0..2 {
                    t.k[i][j] += at.u[i] * by_size * at.u[j] / at.size;
                }
            }
        }
    }
}

impl Rules for Consistent {}

fn length(v: [f64; 2]) -> f64 {
    (v[0] * v[0] + v[1] * v[1]).sqrt()
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

impl<R> RubberBoucWen<R> {
    /// The same law with other rules.
    pub fn with<T>(self, rules: T) -> RubberBoucWen<T> {
        let Self { qy, k0, rubber, cd, varies, leaded, core, heats, .. } = self;
        RubberBoucWen { qy, k0, rubber, cd, varies, leaded, core, heats, rules }
    }
}

impl<R: Rules> RubberBoucWen<R> {
    /// Ratio of the rubber stiffness to that without axial force, and its derivative by N/P_cr.
    #[inline]
    fn left(&self, ratio: f64) -> (f64, f64) {
        if self.varies { (1.0 - ratio * ratio, -2.0 * ratio) } else { (1.0, 0.0) }
    }

    /// Temperature rise and yield force for the next step.
    fn warm(&self, c: &Shear<2>, m: &Warmth, z: [f64; 2], at: &ShearInput<'_>) -> (f64, f64) {
        let Some(core) = &self.core else { return (m.rise, m.qy) };
        let rise = R::warm(core, m, [c.internal, z], at);
        (rise, if self.heats { self.qy * LeadCore::strength(rise) } else { self.qy })
    }
}

impl<R: Rules> RubberShear for RubberBoucWen<R> {
    type Memory = Warmth;

    fn class(&self) -> Class {
        if self.leaded { Class::new("LeadRubberX", 153) } else { Class::new("ElastomericX", 152) }
    }
    fn is_viscous(&self) -> bool {
        self.cd > 0.0 || self.core.is_some()
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
            dz = R::hysteretic_tangent(z, d, dz).map(|row| row.map(|x| x * scale));
        }
        let axial = at.axial;
        let ratio = axial.next.force / axial.critical;
        let (left, d_left) = self.left(ratio);
        let ke = R::rubber(m.ke, self.rubber * left);
        let k: [[f64; 2]; 2] =
            std::array::from_fn(|i| std::array::from_fn(|j| qy * dz[i][j] + if i == j { ke } else { 0.0 }));
        let q = std::array::from_fn(|i| self.cd * at.rate[i] + qy * z[i] + ke * u[i]);
        let mut t = Trial { q, k, k_axial: [0.0; 2], damping: self.cd };
        R::complete(self, moved, c, at, (ratio, d_left), &mut t);
        let Trial { q, k, k_axial, damping } = t;
        let (rise, next_qy) = self.warm(c, m, z, at);
        let next_ke = R::keep(self, axial, ke);
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
