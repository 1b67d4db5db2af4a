//! Steel of a buckling-restrained brace.

use crate::material::{MaterialError, MaterialResult, Strain, Stress, UniaxialLaw};
use crate::numeric::bracketed_root;
use crate::probe::{Probe, Response};

/// Maximum number of iterations for the plastic strain; bisection alone needs fewer.
const MAX_ITERATIONS: u32 = 200;

/// Hardening of [`SteelBrb`] in one loading direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BrbBranch {
    /// Final yield stress after full isotropic hardening.
    pub yield_stress: f64,
    /// Exponent α of the transition from elastic to plastic.
    pub alpha: f64,
    /// Kinematic hardening modulus divided by the elastic modulus, β.
    pub beta: f64,
    /// Cumulative plastic strain δ that scales isotropic hardening.
    pub delta: f64,
}

/// Steel of a buckling-restrained brace, with different hardening in tension and compression (Zona and Dall'Asta,
/// 2012). The plastic share of a strain increment is |(σ - β E εp) / σy|^α. The yield stress σy goes from σy0 to its
/// final value with the cumulative plastic strain.
#[derive(Clone, Debug, PartialEq)]
pub struct SteelBrb {
    /// Elastic modulus, stress.
    pub e: f64,
    /// Initial yield stress σy0.
    pub yield_stress: f64,
    /// Hardening in tension.
    pub tension: BrbBranch,
    /// Hardening in compression.
    pub compression: BrbBranch,
    /// As in OpenSees, the tension branch is used for the first increment from zero stress, in either direction.
    pub compat: bool,
}

crate::state_struct! {
    /// History of [`SteelBrb`].
    pub struct History {
        /// Strain.
        strain: f64,
        /// Stress.
        stress: f64,
        /// Plastic strain.
        plastic: f64,
        /// Cumulative absolute plastic strain.
        cumulative: f64,
        /// Energy dissipated.
        dissipated: f64,
    }
}

impl SteelBrb {
    /// Plastic share of an increment `de` that begins at `stress`, for a plastic increment `dp`. Returns the share
    /// and its derivatives with respect to `dp` and `de`.
    fn share(&self, b: &BrbBranch, old: &History, stress: f64, de: f64, dp: f64) -> (f64, f64, f64) {
        let above = stress + self.e * (de - dp) - b.beta * self.e * (old.plastic + dp);
        let decay = (-(old.cumulative + dp.abs()) / b.delta).exp();
        let growth = b.yield_stress - self.yield_stress;
        let strength = self.yield_stress + growth * (1.0 - decay);
        let strength_slope = growth / b.delta * decay * if dp >= 0.0 { 1.0 } else { -1.0 };
        let ratio = above / strength;
        let slope = b.alpha * ratio.abs().powf(b.alpha - 2.0) * ratio;
        let slope = if ratio == 0.0 { 0.0 } else { slope };
        let by_plastic = slope * (-self.e * (1.0 + b.beta) - ratio * strength_slope) / strength;
        (ratio.abs().powf(b.alpha), by_plastic, slope * self.e / strength)
    }

    /// Loads from zero stress, or from a stress with the sign of the increment. Returns the plastic increment and the
    /// tangent.
    fn load(&self, b: &BrbBranch, old: &History, stress: f64, de: f64) -> MaterialResult<(f64, f64)> {
        // The residual x - share |de| increases with the plastic strain x along the increment.
        let sign = de.signum();
        let residual = |x: f64| {
            let (share, by_plastic, _) = self.share(b, old, stress, de, sign * x);
            (x - share * de.abs(), 1.0 - by_plastic * de)
        };
        // The root is at most |de|, unless a falling yield stress has left the stress above it.
        let upper = if residual(de.abs()).0 >= 0.0 { de.abs() } else { f64::INFINITY };
        let dp = bracketed_root(residual, (0.0, upper), 0.0, de.abs(), MAX_ITERATIONS).ok_or_else(|| {
            MaterialError(format!("SteelBRB: no plastic strain found for the increment {de} of strain"))
        })?;
        let dp = sign * dp;
        let (share, by_plastic, by_strain) = self.share(b, old, stress, de, dp);
        let plastic_slope = (share + by_strain * de) / (1.0 - by_plastic * de);
        Ok((dp, self.e * (1.0 - plastic_slope)))
    }
}

impl UniaxialLaw for SteelBrb {
    type State = History;
    const NAME: &'static str = "SteelBRB";

    fn update(&self, old: &History, strain: Strain) -> MaterialResult<(Stress, History)> {
        let de = strain.value - old.strain;
        let elastic = old.stress + self.e * de;
        let unloads = old.stress * de < 0.0;
        if de == 0.0 || (unloads && elastic * old.stress >= 0.0) {
            let new = History { strain: strain.value, stress: elastic, ..*old };
            return Ok((Stress { value: elastic, tangent: self.e, damping: 0.0 }, new));
        }
        // An increment through zero stress counts from the point of zero stress.
        let (start, de) = if unloads { (0.0, de + old.stress / self.e) } else { (old.stress, de) };
        let tension = de > 0.0 || (self.compat && !unloads && start == 0.0);
        let branch = if tension { &self.tension } else { &self.compression };
        let (dp, tangent) = self.load(branch, old, start, de)?;
        let stress = start + self.e * (de - dp);
        let plastic = old.plastic + dp;
        let kinematic = branch.beta * self.e * (old.plastic + plastic);
        let new = History {
            strain: strain.value,
            stress,
            plastic,
            cumulative: old.cumulative + dp.abs(),
            dissipated: old.dissipated + 0.5 * (stress + start - kinematic) * dp,
        };
        Ok((Stress { value: stress, tangent, damping: 0.0 }, new))
    }

    fn initial_tangent(&self) -> f64 {
        self.e
    }

    fn probe(&self, words: &[&str]) -> Option<Probe> {
        Response::find(&RESPONSES, words.first()?)
    }

    fn read(&self, path: &[u32], state: &History, out: &mut [f64]) {
        Response::read(&RESPONSES, path[0], self, state, out);
    }
}

const RESPONSES: [Response<SteelBrb, History>; 2] = [
    Response::new(&["cumPlasticStrain"], &["cumPlasticStrain"], |_, s, out| out[0] = s.cumulative),
    Response::new(&["dissipatedEnergy"], &["dissipatedEnergy"], |_, s, out| out[0] = s.dissipated),
];
