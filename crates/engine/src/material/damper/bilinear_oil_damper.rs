//! Oil damper with a relief valve and the stiffness of its brace.

use crate::material::damper::viscous_damper::{History, dormand_prince, update};
use crate::material::{MaterialError, MaterialResult, Strain, Stress, UniaxialLaw};
use crate::numeric::Dual;

/// Spring and bilinear dashpot in series: dF/dt = K (v - g(F)), where g is F/C up to the relief force Fr and
/// (F - (1 - p) Fr sign F) / (p C) beyond it. Each step is divided in halves until the error estimate is within the
/// tolerances (Akcelyan, Lignos and Hikino, 2018).
#[derive(Clone, Debug, PartialEq)]
pub struct BilinearOilDamper {
    /// Stiffness K.
    pub k: f64,
    /// Damping coefficient C.
    pub c: f64,
    /// Relief force Fr.
    pub relief: f64,
    /// Ratio p of the damping coefficients beyond and before the relief force.
    pub ratio: f64,
    /// Length of the gap that opens at every change of sign of the force.
    pub gap: f64,
    /// Finite differences in place of Runge-Kutta.
    pub differences: bool,
    /// Relative error tolerance.
    pub relative: f64,
    /// Absolute error tolerance, force.
    pub absolute: f64,
    /// Maximum number of halvings of a step.
    pub max_halvings: i32,
    /// As in OpenSees, a rate of exactly zero is replaced by the rate of the previous step, and the damping tangent is
    /// zero.
    pub compat: bool,
}

impl BilinearOilDamper {
    /// dF/dt at a rate and a force.
    fn force_rate(&self, rate: Dual, force: Dual) -> Dual {
        let flow = if force.value.abs() < self.relief || self.ratio == 0.0 {
            (1.0 / self.c) * force
        } else {
            let shift = 1f64.copysign(force.value) * (self.ratio - 1.0) * self.relief;
            (1.0 / (self.ratio * self.c)) * (force + Dual { value: shift, slope: 0.0 })
        };
        self.k * (rate - flow)
    }

    /// Largest halvings of a step as a part of it.
    fn smallest(&self) -> f64 {
        0.5f64.powi(self.max_halvings)
    }

    fn is_accurate(&self, error: f64, relative: f64, part: f64) -> bool {
        relative <= self.relative || error.abs() <= self.absolute || part <= self.smallest()
    }

    /// Force after a step in which the rate goes from `start` to `end`, by Runge-Kutta.
    fn runge_kutta(&self, start: f64, end: f64, mut force: Dual, dt: f64) -> Dual {
        let (mut part, mut done) = (1.0, 0.0);
        let at = |x: f64| Dual { value: start + (end - start) * x, slope: x };
        // The substeps are powers of one half, so that they sum to exactly one.
        while done < 1.0 {
            let rates = [at(done), at(done + part)];
            let (y, error, relative) = dormand_prince(|v, y| self.force_rate(v, y), rates, force, part * dt);
            if self.is_accurate(error, relative, part) {
                force = y;
                done += part;
            } else {
                part *= 0.5;
            }
        }
        if self.ratio == 0.0 && force.value.abs() > self.relief {
            return Dual { value: self.relief.copysign(force.value), slope: 0.0 };
        }
        force
    }

    /// The same with implicit finite differences of length `h`.
    fn differences(&self, start: f64, end: f64, mut force: Dual, dt: f64, h: f64) -> Dual {
        let (k, c, p, relief) = (self.k, self.c, self.ratio, self.relief);
        let mut j = 1.0;
        let mut rate = Dual { value: start, slope: 0.0 };
        while j < dt / h + 1.0 {
            rate = rate + Dual { value: (end - start) / dt * h, slope: h / dt };
            let pushed = k * h * rate + force;
            let mut next = (1.0 / (1.0 + k * h / c)) * pushed;
            if next.value.abs() > relief {
                let s = next.value.signum();
                next = if p == 0.0 {
                    Dual { value: s * relief, slope: 0.0 }
                } else {
                    let shift = s * relief * (1.0 - p) * k * h / (p * c);
                    (1.0 / (1.0 + k * h / (p * c))) * (pushed + Dual { value: shift, slope: 0.0 })
                };
            }
            force = next;
            j += 1.0;
        }
        force
    }

    /// Force at the end of a step, with its derivative with respect to the final rate.
    fn integrate(&self, c: &History, end: f64, dt: f64) -> Dual {
        let force = Dual { value: c.stress, slope: 0.0 };
        if dt <= 0.0 {
            return force;
        }
        if !self.differences {
            return self.runge_kutta(c.rate, end, force, dt);
        }
        let mut part = 1.0;
        loop {
            let coarse = self.differences(c.rate, end, force, dt, part * dt);
            let fine = self.differences(c.rate, end, force, dt, part / (part + 1.0) * dt);
            let error = fine.value - coarse.value;
            if self.is_accurate(error, (error / fine.value).abs(), part) {
                return fine;
            }
            part *= 0.5;
        }
    }
}

impl UniaxialLaw for BilinearOilDamper {
    type State = History;
    const NAME: &'static str = "BilinearOilDamper";

    fn update(&self, c: &History, strain: Strain) -> MaterialResult<(Stress, History)> {
        update(self.compat, self.gap, c, strain, |end| {
            let force = self.integrate(c, end, strain.dt);
            let failed = || MaterialError(format!("BilinearOilDamper found no force at a rate of {end:.6e}"));
            if force.value.is_finite() { Ok(force) } else { Err(failed()) }
        })
    }

    fn initial_tangent(&self) -> f64 {
        0.0
    }

    fn is_viscous(&self) -> bool {
        true
    }

    fn depends_on_time(&self) -> bool {
        true
    }
}
