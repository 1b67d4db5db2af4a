//! Nonlinear viscous damper with the stiffness of its brace.

use crate::material::{MaterialError, MaterialResult, Strain, Stress, UniaxialLaw};
use crate::numeric::Dual;

/// Spring and nonlinear dashpot in series: dF/dt = K (v - |F/C|^(1/α) sign F). Each step is divided in halves until
/// the error estimate is within the tolerances (Akcelyan, Lignos and Hikino, 2018).
#[derive(Clone, Debug, PartialEq)]
pub struct ViscousDamper {
    /// Stiffness K.
    pub k: f64,
    /// Damping coefficient C.
    pub c: f64,
    /// Velocity exponent α.
    pub alpha: f64,
    /// Length of the gap that opens at every change of sign of the force.
    pub gap: f64,
    /// Integration method.
    pub method: IntegrationMethod,
    /// Relative error tolerance.
    pub relative: f64,
    /// Absolute error tolerance, force.
    pub absolute: f64,
    /// Maximum number of halvings of a step.
    pub max_halvings: i32,
    /// As in OpenSees, a rate of exactly zero is replaced by the rate of the previous step, and the damping tangent
    /// is zero.
    pub compat: bool,
}

/// Integration method for the differential equation of a [`ViscousDamper`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum IntegrationMethod {
    /// Runge-Kutta of order 5 (Dormand and Prince, 1980).
    DormandPrince,
    /// Predictor and corrector of order 6 (Adams, Bashforth and Moulton).
    AdamsBashforthMoulton,
    /// Rosenbrock's method for stiff equations, of order 2 (Shampine and Reichelt, 1997).
    Rosenbrock,
}

crate::state_struct! {
    /// History of [`ViscousDamper`].
    pub struct History {
        /// Strain.
        strain: f64,
        /// Force.
        stress: f64,
        /// Rate.
        rate: f64,
        /// Strain at which the gap began, in tension and in compression; zero if there is none.
        gap: [f64; 2],
    }
}

/// Smallest |F/C| in the derivative of the dashpot rate, which is infinite at zero force for α > 1.
const MIN_FORCE_RATIO: f64 = 1e-12;

/// Weighted sum.
fn weighted(weights: &[f64], k: &[Dual]) -> Dual {
    weights.iter().zip(k).fold(Dual::default(), |sum, (w, k)| sum + *w * *k)
}

/// Abscissae and weights of the stages of Dormand and Prince.
const DP_PLACE: [f64; 6] = [0.0, 0.2, 0.3, 0.8, 8.0 / 9.0, 1.0];
const DP: [&[f64]; 6] = [
    &[],
    &[1.0 / 5.0],
    &[3.0 / 40.0, 9.0 / 40.0],
    &[44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0],
    &[19372.0 / 6561.0, -25360.0 / 2187.0, 64448.0 / 6561.0, -212.0 / 729.0],
    &[9017.0 / 3168.0, -355.0 / 33.0, 46732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18656.0],
];
const DP_END: [f64; 6] = [35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0];
const DP_ERROR: [f64; 7] =
    [71.0 / 57600.0, 0.0, -71.0 / 16695.0, 71.0 / 1920.0, -17253.0 / 339200.0, 22.0 / 525.0, -1.0 / 40.0];

/// Weights of the Adams-Bashforth predictors and the Adams-Moulton correctors, the latest value first.
const PREDICT: [&[f64]; 6] = [
    &[1.0],
    &[1.5, -0.5],
    &[23.0 / 12.0, -16.0 / 12.0, 5.0 / 12.0],
    &[55.0 / 24.0, -59.0 / 24.0, 37.0 / 24.0, -9.0 / 24.0],
    &[1901.0 / 720.0, -2774.0 / 720.0, 2616.0 / 720.0, -1274.0 / 720.0, 251.0 / 720.0],
    &[4277.0 / 1440.0, -7923.0 / 1440.0, 9982.0 / 1440.0, -7298.0 / 1440.0, 2877.0 / 1440.0, -475.0 / 1440.0],
];
const CORRECT: [&[f64]; 6] = [
    &[1.0],
    &[0.5, 0.5],
    &[5.0 / 12.0, 8.0 / 12.0, -1.0 / 12.0],
    &[9.0 / 24.0, 19.0 / 24.0, -5.0 / 24.0, 1.0 / 24.0],
    &[251.0 / 720.0, 646.0 / 720.0, -264.0 / 720.0, 106.0 / 720.0, -19.0 / 720.0],
    &[475.0 / 1440.0, 1427.0 / 1440.0, -798.0 / 1440.0, 482.0 / 1440.0, -173.0 / 1440.0, 27.0 / 1440.0],
];

/// A step of Dormand and Prince's method for dF/dt = f(v, F), in which the rate v goes from `v0` to `v1`: force, absolute
/// and relative error estimate.
pub(super) fn dormand_prince(
    f: impl Fn(Dual, Dual) -> Dual,
    [v0, v1]: [Dual; 2],
    y0: Dual,
    h: f64,
) -> (Dual, f64, f64) {
    let mut k = [Dual::default(); 7];
    for i in 0..6 {
        k[i] = h * f(DP_PLACE[i] * (v1 - v0) + v0, y0 + weighted(DP[i], &k));
    }
    let y = y0 + weighted(&DP_END, &k);
    k[6] = h * f(v1, y);
    let error = weighted(&DP_ERROR, &k).value;
    (y, error, (error / y.value).abs())
}

impl ViscousDamper {
    /// dF/dt at a rate and a force.
    fn force_rate(&self, rate: Dual, force: Dual) -> Dual {
        let p = 1.0 / self.alpha;
        let size = force.value.abs() / self.c;
        let power = size.powf(p);
        let flow = power.copysign(force.value);
        let lower = match size {
            // The derivative is infinite at zero force for α > 1, so it is bounded.
            _ if p < 1.0 && size < MIN_FORCE_RATIO => MIN_FORCE_RATIO.powf(p - 1.0),
            0.0 => size.powf(p - 1.0),
            _ => power / size,
        };
        let slope = p * lower / self.c * force.slope;
        self.k * Dual { value: rate.value - flow, slope: rate.slope - slope }
    }

    /// Force after a time `h` in which the rate goes from `v0` to `v1`, with the absolute and the relative error
    /// estimate.
    fn step(&self, v0: Dual, v1: Dual, y0: Dual, h: f64) -> (Dual, f64, f64) {
        let rate = |place: f64| place * (v1 - v0) + v0;
        match self.method {
            IntegrationMethod::DormandPrince => dormand_prince(|v, y| self.force_rate(v, y), [v0, v1], y0, h),
            IntegrationMethod::AdamsBashforthMoulton => {
                let h = h / 6.0;
                // Force rates, the latest first.
                let mut f = [Dual::default(); 7];
                f[0] = self.force_rate(v0, y0);
                let (mut y, mut error) = (y0, 0.0);
                for i in 0..6 {
                    let predicted = y + h * weighted(PREDICT[i], &f);
                    f.rotate_right(1);
                    f[0] = self.force_rate(rate((i + 1) as f64 / 6.0), predicted);
                    y = y + h * weighted(CORRECT[i], &f);
                    error = predicted.value - y.value;
                }
                (y, error, (error / y.value).abs())
            }
            IntegrationMethod::Rosenbrock => {
                let jacobian = -self.k / (self.alpha * self.c);
                let d = 1.0 / (2.0 + std::f64::consts::SQRT_2);
                let e32 = 6.0 + std::f64::consts::SQRT_2;
                let w = 1.0 / (1.0 - h * d * jacobian);
                let shift = Dual { value: h * d * self.k, slope: 0.0 };
                let f0 = self.force_rate(v0, y0);
                let k1 = w * (f0 + shift);
                let f1 = self.force_rate(rate(0.5), y0 + 0.5 * h * k1);
                let k2 = w * (f1 - k1) + k1;
                let y = y0 + h * k2;
                let f2 = self.force_rate(v1, y);
                let k3 = w * (f2 - e32 * (k2 - f1) - 2.0 * (k1 - f0) + shift);
                let error = h / 6.0 * (k1 - 2.0 * k2 + k3).value;
                (y, error, (error / (y.value + error)).abs())
            }
        }
    }

    /// Force at the end of the step, with its derivative with respect to the final rate.
    fn integrate(&self, c: &History, end: f64, dt: f64) -> MaterialResult<Dual> {
        let start = Dual { value: c.rate, slope: 0.0 };
        let mut force = Dual { value: c.stress, slope: 0.0 };
        if dt <= 0.0 {
            return Ok(force);
        }
        let smallest = 0.5f64.powi(self.max_halvings);
        let (mut part, mut done) = (1.0, 0.0);
        let at = |x: f64| Dual { value: start.value + (end - start.value) * x, slope: x };
        // The substeps are powers of one half, so that they sum to exactly one.
        while done < 1.0 {
            let (y, error, relative) = self.step(at(done), at(done + part), force, part * dt);
            if relative <= self.relative || error.abs() <= self.absolute || part <= smallest {
                if !y.value.is_finite() {
                    let message = format!("ViscousDamper found no force at a rate of {end:.6e}");
                    return Err(MaterialError(message));
                }
                force = y;
                done += part;
            } else {
                part *= 0.5;
            }
        }
        Ok(force)
    }
}

/// Response of a damper with a gap, from its force for a rate at the end of the step. OpenSees holds the rate where it is 0,
/// and has no derivative.
pub(super) fn update(
    compat: bool,
    gap: f64,
    c: &History,
    strain: Strain,
    integrate: impl FnOnce(f64) -> MaterialResult<Dual>,
) -> MaterialResult<(Stress, History)> {
    let end = if compat && strain.rate == 0.0 { c.rate } else { strain.rate };
    let force = integrate(end)?;
    let mut t = History { strain: strain.value, rate: strain.rate, ..*c };
    let in_gap = gap > 0.0 && is_in_gap(gap, c, &mut t, force.value);
    let force = if in_gap { Dual::default() } else { force };
    t.stress = force.value;
    let damping = if compat || !force.slope.is_finite() { 0.0 } else { force.slope };
    Ok((Stress { value: force.value, tangent: 0.0, damping }, t))
}

/// Returns true if the force vanishes in the gap that opens when the force changes sign.
fn is_in_gap(length: f64, c: &History, t: &mut History, force: f64) -> bool {
    let change = (t.strain - c.strain) * force.abs() / (force - c.stress).abs();
    if force > 0.0 && c.stress < 0.0 {
        t.gap = [c.strain + change, 0.0];
        (t.strain - t.gap[0]).abs() < length
    } else if force < 0.0 && c.stress > 0.0 {
        t.gap = [0.0, c.strain + change];
        (t.strain - t.gap[1]).abs() < length
    } else if c.stress == 0.0 {
        let inside = |begin: f64, s: f64| begin != 0.0 && (0.0..length).contains(&(s * (t.strain - begin)));
        inside(t.gap[0], 1.0) && t.strain != t.gap[0] || inside(t.gap[1], -1.0) && t.strain != t.gap[1]
    } else {
        false
    }
}

impl UniaxialLaw for ViscousDamper {
    type State = History;
    const NAME: &'static str = "ViscousDamper";

    fn update(&self, c: &History, strain: Strain) -> MaterialResult<(Stress, History)> {
        update(self.compat, self.gap, c, strain, |end| self.integrate(c, end, strain.dt))
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
