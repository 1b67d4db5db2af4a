//! The rheology in two shear directions.
//!
//! Every part is isotropic in the plane. Springs act along their strain, the sliders have circular yield surfaces,
//! and the dashpot flows along its stress. On a straight path the law equals the uniaxial one to the tolerance of the
//! integration. A fan of uniaxial laws, as in a multiple shear spring, would be a different law with its own
//! identification. It would also depend on the spring directions.

use super::{HdrRheology, MAX_ITERATIONS, Thermal};
use crate::numeric::Dual;
use nalgebra::{Matrix2, Vector2};

crate::state_struct! {
    /// History of the rheology in the plane.
    pub struct PlaneHistory {
        /// Shear strain γ.
        strain: [f64; 2],
        /// Strain of the equilibrium slider.
        slip_eq: [f64; 2],
        /// Strain of the elasto-plastic part of the overstress branch.
        gamma_b: [f64; 2],
        /// Strain of the overstress slider.
        slip_oe: [f64; 2],
        /// Mean temperature of the rubber above the surroundings.
        rise: f64,
        /// Elastic energy per volume.
        stored: f64,
        /// Generated heat per volume.
        heat: f64,
        /// Strain γₘ of the softening.
        peak: f64,
        /// All-time largest strain.
        ever: f64,
        /// Equilibrium stress.
        equilibrium: [f64; 2],
        /// Overstress.
        overstress: [f64; 2],
    }
}

/// Response of the law in the plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlaneStep {
    /// The next history.
    pub next: PlaneHistory,
    /// Stress.
    pub stress: [f64; 2],
    /// Derivative of the stress with respect to the strain, at the temperature of the step.
    pub tangent: [[f64; 2]; 2],
}

type V = Vector2<f64>;
type M = Matrix2<f64>;

/// A vector with its derivative with respect to the strain at the end of the step.
#[derive(Clone, Copy)]
struct VectorWithDerivative {
    value: V,
    slope: M,
}

impl VectorWithDerivative {
    fn constant(value: [f64; 2]) -> Self {
        Self { value: V::from(value), slope: M::zeros() }
    }
}

/// Spring and slider with a circular yield surface in series: stress c (b - s), at most `limit`.
#[derive(Clone, Copy)]
struct ElastoPlastic {
    c: f64,
    limit: f64,
}

impl ElastoPlastic {
    /// Stress for a strain `b` and a previous slip `s`, and its derivative with respect to b. The derivative with
    /// respect to s is the negative.
    fn stress(&self, b: V, s: V) -> (V, M) {
        let trial = self.c * (b - s);
        let size = trial.norm();
        if size <= self.limit {
            return (trial, self.c * M::identity());
        }
        let n = trial / size;
        let along = M::identity() - n * n.transpose();
        (self.limit * n, self.c * self.limit / size * along)
    }

    /// Slip after the return to the yield surface, and its dissipated work.
    fn slip(&self, b: VectorWithDerivative, s: VectorWithDerivative) -> (VectorWithDerivative, f64) {
        if self.c <= 0.0 {
            return (b, 0.0);
        }
        let (stress, k) = self.stress(b.value, s.value);
        let value = b.value - stress / self.c;
        let slope = b.slope - k * (b.slope - s.slope) / self.c;
        (VectorWithDerivative { value, slope }, stress.dot(&(value - s.value)))
    }
}

/// The overstress branch at one temperature.
struct Branch {
    part: ElastoPlastic,
    c2: f64,
    a: f64,
    p: f64,
}

/// Strains of the branch, and its dissipated work.
#[derive(Clone, Copy)]
struct Flow {
    b: VectorWithDerivative,
    s: VectorWithDerivative,
    heat: f64,
}

/// Accepted difference between a substep and its two halves, relative to the stress. Their extrapolation is more
/// accurate by the ratio of substep to relaxation time.
const TOLERANCE: f64 = 1e-5;
/// Smallest reference stress of the error, divided by a.
const STRESS_FLOOR_RATIO: f64 = 1e-2;
/// Maximum number of substeps; exceeded only by invalid numbers.
const MAX_SUBSTEPS: usize = 20_000;
/// Tolerance of the temperature in the iterations, degrees.
const TEMPERATURE_TOLERANCE: f64 = 1e-9;
/// Maximum number of Newton iterations of a substep.
const MAX_NEWTON_ITERATIONS: usize = 60;

impl Branch {
    fn stress(&self, b: V, s: V) -> (V, M) {
        let (stress, k) = self.part.stress(b, s);
        (stress + self.c2 * b, k + self.c2 * M::identity())
    }

    /// Strain rate of the dashpot, and its derivative with respect to the stress.
    fn rate(&self, x: V) -> (V, M) {
        let size = x.norm();
        if size == 0.0 {
            let slope = if self.p == 1.0 { 1.0 / self.a } else { 0.0 };
            return (V::zeros(), slope * M::identity());
        }
        let n = x / size;
        let f = (size / self.a).powf(self.p);
        (f * n, f / size * (M::identity() + (self.p - 1.0) * n * n.transpose()))
    }

    /// A substep of backward Euler; `None` if Newton's method does not converge.
    fn euler(&self, from: Flow, r: &VectorWithDerivative, h: f64) -> Option<Flow> {
        let known = from.b.value + h * r.value;
        let residual = |b: V| {
            let (x, k) = self.stress(b, from.s.value);
            let (g, gx) = self.rate(x);
            (b - known + h * g, h * gx * k, x, g, gx)
        };
        let scale = known.norm().max(from.b.value.norm()).max(1e-12);
        let mut b = from.b.value;
        let mut now = residual(b);
        for _ in 0..MAX_NEWTON_ITERATIONS {
            let inverse = (M::identity() + now.1).try_inverse()?;
            let step = inverse * now.0;
            let size = now.0.norm();
            let mut share = 1.0;
            loop {
                let next = b - share * step;
                let then = residual(next);
                if then.0.norm() <= (1.0 - 1e-4 * share) * size || size <= 1e-14 * scale || share < 1e-6 {
                    (b, now) = (next, then);
                    break;
                }
                // Armijo's rule of sufficient decrease guards the kink of the yield surface.
                share *= 0.5;
            }
            if now.0.norm() <= 1e-13 * scale {
                let (_, k) = self.part.stress(b, from.s.value);
                let gx = now.4;
                let inverse = (M::identity() + h * gx * (k + self.c2 * M::identity())).try_inverse()?;
                let slope = inverse * (from.b.slope + h * r.slope + h * gx * k * from.s.slope);
                let b = VectorWithDerivative { value: b, slope };
                let (s, slid) = self.part.slip(b, from.s);
                return Some(Flow { b, s, heat: from.heat + slid + h * now.2.dot(&now.3) });
            }
        }
        None
    }

    /// Response of the branch to a strain increment at constant rate over `time`.
    fn flow(&self, b: [f64; 2], s: [f64; 2], increment: V, time: f64) -> Flow {
        let mut at = Flow { b: VectorWithDerivative::constant(b), s: VectorWithDerivative::constant(s), heat: 0.0 };
        let slipped = |f: &mut Flow| {
            let (s, heat) = self.part.slip(f.b, f.s);
            (f.s, f.heat) = (s, f.heat + heat);
        };
        slipped(&mut at);
        if time <= 0.0 {
            at.b = VectorWithDerivative { value: at.b.value + increment, slope: M::identity() };
            slipped(&mut at);
            return at;
        }
        let r = VectorWithDerivative { value: increment / time, slope: M::identity() / time };
        let stiffness = self.part.c + self.c2;
        let (mut remaining, mut h) = (time, time);
        for _ in 0..MAX_SUBSTEPS {
            h = h.min(remaining);
            let halves = self.euler(at, &r, 0.5 * h).and_then(|half| self.euler(half, &r, 0.5 * h));
            let (Some(fine), Some(coarse)) = (halves, self.euler(at, &r, h)) else {
                h *= 0.25;
                continue;
            };
            let size = self.stress(fine.b.value, fine.s.value).0.norm();
            let error = stiffness * (fine.b.value - coarse.b.value).norm();
            let ratio = error / (TOLERANCE * (size + STRESS_FLOOR_RATIO * self.a));
            if ratio > 1.0 && h > 1e-12 * time {
                h *= (0.9 / ratio.sqrt()).clamp(0.1, 0.8);
                continue;
            }
            let twice = |f: VectorWithDerivative, c: VectorWithDerivative| VectorWithDerivative {
                value: 2.0 * f.value - c.value,
                slope: 2.0 * f.slope - c.slope,
            };
            let heat = (2.0 * fine.heat - coarse.heat).max(at.heat);
            at = Flow { b: twice(fine.b, coarse.b), s: twice(fine.s, coarse.s), heat };
            slipped(&mut at);
            remaining -= h;
            if remaining <= 1e-14 * time {
                break;
            }
            h *= if ratio > 0.0 { (0.9 / ratio.sqrt()).clamp(0.3, 4.0) } else { 4.0 };
        }
        at
    }
}

/// The law at one temperature.
struct Law {
    part: ElastoPlastic,
    c2: f64,
    c3: f64,
    m: f64,
    branch: Branch,
}

impl Law {
    fn new([c1, c2, c3, tau_cr, m, c1_oe, c2_oe, tau_cr_oe, a, n]: [Dual; 10]) -> Self {
        let part = |c: Dual, limit: Dual| ElastoPlastic {
            c: if limit.value > 0.0 { c.value } else { 0.0 },
            limit: limit.value,
        };
        let branch = Branch { part: part(c1_oe, tau_cr_oe), c2: c2_oe.value, a: a.value, p: 1.0 / n.value };
        Self { part: part(c1, tau_cr), c2: c2.value, c3: c3.value, m: m.value, branch }
    }

    /// Stress of the nonlinear spring, and its derivative.
    fn spring(&self, g: V) -> (V, M) {
        let size = g.norm();
        let secant = self.c2 + self.c3 * size.powf(self.m - 1.0);
        let mut tangent = secant * M::identity();
        if size > 0.0 {
            let n = g / size;
            tangent += self.c3 * (self.m - 1.0) * size.powf(self.m - 1.0) * n * n.transpose();
        }
        (secant * g, tangent)
    }

    /// Elastic energy per volume.
    fn stored(&self, h: &PlaneHistory) -> f64 {
        let [g, s, b, t] = [h.strain, h.slip_eq, h.gamma_b, h.slip_oe].map(V::from);
        let size = g.norm();
        0.5 * (self.c2 * size * size + self.part.c * (g - s).norm_squared())
            + self.c3 * size.powf(self.m + 1.0) / (self.m + 1.0)
            + 0.5 * (self.branch.part.c * (b - t).norm_squared() + self.branch.c2 * b.norm_squared())
    }

    /// A step. Returns history, equilibrium stress and overstress with their derivatives, and the heat.
    fn step(
        &self,
        c: &PlaneHistory,
        strain: V,
        time: f64,
    ) -> (PlaneHistory, VectorWithDerivative, VectorWithDerivative, f64) {
        let released = c.stored - self.stored(c);
        let here = VectorWithDerivative { value: strain, slope: M::identity() };
        let (tau_ep, k_ep) = self.part.stress(strain, V::from(c.slip_eq));
        let (slip_eq, slid) = self.part.slip(here, VectorWithDerivative::constant(c.slip_eq));
        let (tau_ee, k_ee) = self.spring(strain);
        let flow = self.branch.flow(c.gamma_b, c.slip_oe, strain - V::from(c.strain), time);
        let (x, k) = self.branch.part.stress(flow.b.value, flow.s.value);
        let slope = k * (flow.b.slope - flow.s.slope) + self.branch.c2 * flow.b.slope;
        let overstress = VectorWithDerivative { value: x + self.branch.c2 * flow.b.value, slope };
        let equilibrium = VectorWithDerivative { value: tau_ep + tau_ee, slope: k_ep + k_ee };
        let mut next = PlaneHistory {
            strain: strain.into(),
            slip_eq: slip_eq.value.into(),
            gamma_b: flow.b.value.into(),
            slip_oe: flow.s.value.into(),
            ..*c
        };
        next.stored = self.stored(&next);
        (next, equilibrium, overstress, released + slid + flow.heat)
    }
}

impl HdrRheology {
    /// The virgin history in the plane.
    pub fn plane_virgin(&self) -> PlaneHistory {
        let peak = self.softening.map_or(0.0, |s| s.preload);
        PlaneHistory { peak, ever: peak, ..PlaneHistory::default() }
    }

    /// Tangent of the virgin law, equal in all directions.
    pub fn plane_stiffness(&self) -> f64 {
        super::Uniaxial::initial_tangent(self) * self.height / self.area
    }

    /// Number of modal amplitudes of heat flow.
    pub fn heat_len(&self) -> usize {
        self.thermal.as_ref().map_or(0, Thermal::len)
    }

    /// Advances the modal amplitudes by `time`, with the heat generated between the histories `c` and `next`.
    pub fn plane_flow(&self, c: &PlaneHistory, next: &PlaneHistory, time: f64, amplitudes: &mut [f64]) {
        if let Some(thermal) = &self.thermal {
            thermal.advance(amplitudes, next.heat - c.heat, 0.5 * time.abs(), time.abs());
        }
    }

    /// Stress for a strain in the plane after `time`, from the committed history and modal amplitudes. The heat is
    /// generated uniformly over the step. Parameters are constant beyond the table of the compound.
    pub fn plane_step(&self, c: &PlaneHistory, amplitudes: &[f64], strain: [f64; 2], time: f64) -> PlaneStep {
        let (g, time) = (V::from(strain), time.abs());
        let before = super::Peak { now: Dual::constant(c.peak), ever: c.ever };
        let size = g.norm();
        let peak = self.softening.map_or(before, |s| s.advance(before, Dual { value: size, slope: 1.0 }, time));
        let (old_factor, factor) = (self.factor(before).value, self.factor(peak));
        let mut rise = c.rise;
        let mut iterations = 0;
        let (mut next, equilibrium, overstress) = loop {
            let temperature = Dual::constant(self.ambient + 0.5 * (c.rise + rise));
            let law = Law::new(self.compound.held(temperature));
            let (next, equilibrium, overstress, work) = law.step(c, g, time);
            let softened = (old_factor - factor.value).max(0.0) * 0.5 * (c.stored + next.stored);
            let heat = 0.5 * (old_factor + factor.value) * work + softened;
            let found = self.thermal.as_ref().map_or(c.rise, |t| t.after(amplitudes, heat, 0.5 * time, time).0);
            iterations += 1;
            if (found - rise).abs() <= TEMPERATURE_TOLERANCE || iterations == MAX_ITERATIONS {
                break (PlaneHistory { rise: found, heat: c.heat + heat, ..next }, equilibrium, overstress);
            }
            rise = found;
        };
        (next.peak, next.ever) = (peak.now.value, peak.ever);
        next.equilibrium = (factor.value * equilibrium.value).into();
        next.overstress = (factor.value * overstress.value).into();
        let soft = equilibrium.value + overstress.value;
        let mut tangent = factor.value * (equilibrium.slope + overstress.slope);
        if factor.slope != 0.0 {
            tangent += factor.slope / size * soft * g.transpose();
        }
        let tangent = [[tangent[(0, 0)], tangent[(0, 1)]], [tangent[(1, 0)], tangent[(1, 1)]]];
        PlaneStep { next, stress: (factor.value * soft).into(), tangent }
    }
}
