//! Updated Voce-Chaboche plasticity of structural steel (Hartloper, de Castro e Sousa and Lignos, 2021,
//! <https://doi.org/10.1061/(ASCE)ST.1943-541X.0002964>).

use crate::material::{MaterialResult, Strain, Stress, UniaxialLaw};
use crate::rules::{Consistent, OpenSees};
use std::fmt;

/// Largest number of backstresses.
pub const MAX_BACKSTRESSES: usize = 8;
/// Square of a stress beyond that of yield which counts as plastic.
const YIELD_TOLERANCE: f64 = 1e-9;
/// Largest number of iterations of the return mapping.
const MAX_ITERATIONS: usize = 100;

/// By OpenSees' rules: largest change of the plastic strain in an iteration, divided by the elastic strain.
const LARGEST_CHANGE: f64 = 0.95;
/// Largest number of iterations by OpenSees' rules.
const MAX_STEPS: usize = 1000;

/// Plasticity with exponential isotropic hardening, initial softening and nonlinear kinematic hardening:
/// σy = fy + Q∞ (1 - exp(-b p)) - D∞ (1 - exp(-a p)), dα = C dεp - γ α dp.
#[derive(Clone, Debug, PartialEq)]
pub struct UvcUniaxial<R = Consistent> {
    /// Elastic modulus.
    pub e: f64,
    /// Initial yield stress.
    pub fy: f64,
    /// Growth of the yield stress at saturation Q∞.
    pub q_inf: f64,
    /// Rate of its saturation.
    pub b: f64,
    /// Decrease of the yield stress D∞.
    pub d_inf: f64,
    /// Rate of the decrease.
    pub a: f64,
    /// Moduli C and rates γ of the backstresses.
    pub backstresses: Vec<[f64; 2]>,
    /// Rules of the return mapping.
    pub rules: R,
}

crate::state_struct! {
    /// History of [`UvcUniaxial`].
    pub struct History {
        /// Strain.
        strain: f64,
        /// Stress.
        stress: f64,
        /// Accumulated plastic strain.
        plastic: f64,
        /// Backstresses.
        back: [f64; MAX_BACKSTRESSES],
    }
}

/// Rules of [`UvcUniaxial`] that differ in OpenSees.
pub trait Rules: Clone + fmt::Debug + Send + Sync + Sized + 'static {
    /// Maps an elastic stress beyond yield back. Returns the history and the direction of the flow.
    fn return_mapping(law: &UvcUniaxial<Self>, c: &History, trial: f64) -> (History, f64) {
        law.return_mapping(c, trial)
    }
}

impl Rules for Consistent {}

/// An iteration changes the plastic strain by at most 0.95 of the elastic strain of its stress. A step across zero stress therefore ends
/// there, if the backstress is beyond the yield stress.
impl Rules for OpenSees {
    fn return_mapping(law: &UvcUniaxial<Self>, c: &History, trial: f64) -> (History, f64) {
        let mut t = History { stress: trial, ..*c };
        let mut relative = trial - c.back.iter().sum::<f64>();
        let (mut limit, mut isotropic) = law.yield_stress(c.plastic);
        let mut excess = relative * relative - limit * limit;
        let mut flow = 0.0;
        for _ in 0..MAX_STEPS {
            let s = if relative < 0.0 { -1.0 } else { 1.0 };
            let kinematic: f64 = law
                .backstresses
                .iter()
                .zip(&t.back)
                .map(|(&[modulus, gamma], alpha)| modulus - s * gamma * alpha)
                .sum();
            let slope = 2.0 * relative * (law.e + kinematic) + s * 2.0 * limit * isotropic;
            let elastic = (t.stress / law.e).abs();
            let mut change = excess / slope;
            if change.abs() > elastic {
                change = change.signum() * LARGEST_CHANGE * elastic;
            }
            flow += change;
            t.plastic = c.plastic + f64::abs(flow);
            t.stress -= law.e * change;
            (limit, isotropic) = law.yield_stress(t.plastic);
            let (back, sum, _) = law.back(&c.back, s, t.plastic - c.plastic);
            t.back = back;
            relative = t.stress - sum;
            excess = relative * relative - limit * limit;
            if excess.abs() < YIELD_TOLERANCE {
                break;
            }
        }
        (t, if relative < 0.0 { -1.0 } else { 1.0 })
    }
}

impl<R: Rules> UvcUniaxial<R> {
    /// Yield stress and its derivative with respect to the accumulated plastic strain.
    fn yield_stress(&self, plastic: f64) -> (f64, f64) {
        let (grown, lost) = ((-self.b * plastic).exp(), (-self.a * plastic).exp());
        let stress = self.fy + self.q_inf * (1.0 - grown) - self.d_inf * (1.0 - lost);
        (stress, self.q_inf * self.b * grown - self.d_inf * self.a * lost)
    }

    /// Backstresses after a plastic strain `p` in the direction `s`, their sum, and its derivative times `s`.
    fn back(&self, from: &[f64; MAX_BACKSTRESSES], s: f64, p: f64) -> ([f64; MAX_BACKSTRESSES], f64, f64) {
        let (mut back, mut sum, mut slope) = (*from, 0.0, 0.0);
        for (alpha, &[c, gamma]) in back.iter_mut().zip(&self.backstresses) {
            *alpha = if gamma == 0.0 {
                *alpha + s * c * p
            } else {
                s * c / gamma - (s * c / gamma - *alpha) * (-gamma * p).exp()
            };
            sum += *alpha;
            slope += c - s * gamma * *alpha;
        }
        (back, sum, slope)
    }

    /// Maps an elastic stress beyond yield back, by Newton's method within bounds.
    fn return_mapping(&self, c: &History, trial: f64) -> (History, f64) {
        let relative = trial - c.back.iter().sum::<f64>();
        let s = if relative < 0.0 { -1.0 } else { 1.0 };
        // Bounds of the plastic strain; a Newton step beyond them is replaced by bisection.
        let (mut low, mut high) = (0.0, s * relative / self.e);
        let mut p = 0.0;
        for _ in 0..MAX_ITERATIONS {
            let (_, sum, kinematic) = self.back(&c.back, s, p);
            let (limit, isotropic) = self.yield_stress(c.plastic + p);
            let excess = s * (trial - sum) - self.e * p - limit;
            if excess > 0.0 {
                low = p;
            } else {
                high = p;
            }
            let newton = p + excess / (self.e + kinematic + isotropic);
            let next = if (low..=high).contains(&newton) { newton } else { 0.5 * (low + high) };
            let settled = (next - p).abs() <= f64::EPSILON * next.abs();
            p = next;
            if settled {
                break;
            }
        }
        let (back, ..) = self.back(&c.back, s, p);
        (History { strain: c.strain, stress: trial - s * self.e * p, plastic: c.plastic + p, back }, s)
    }
}

impl<R: Rules> UniaxialLaw for UvcUniaxial<R> {
    type State = History;
    const NAME: &'static str = "UVCuniaxial";

    fn update(&self, c: &History, strain: Strain) -> MaterialResult<(Stress, History)> {
        let trial = c.stress + self.e * (strain.value - c.strain);
        let relative = trial - c.back.iter().sum::<f64>();
        let (limit, _) = self.yield_stress(c.plastic);
        if relative * relative - limit * limit <= YIELD_TOLERANCE {
            let t = History { strain: strain.value, stress: trial, ..*c };
            return Ok((Stress { value: trial, tangent: self.e, damping: 0.0 }, t));
        }
        let (t, s) = R::return_mapping(self, c, trial);
        let kinematic: f64 =
            self.backstresses.iter().zip(&t.back).map(|(&[modulus, gamma], alpha)| modulus - s * gamma * alpha).sum();
        let hardening = kinematic + self.yield_stress(t.plastic).1;
        let tangent = self.e * hardening / (self.e + hardening);
        Ok((Stress { value: t.stress, tangent, damping: 0.0 }, History { strain: strain.value, ..t }))
    }

    fn initial_tangent(&self) -> f64 {
        self.e
    }
}
