//! Softening of virgin rubber (Mullins effect): inside a law, around a law, and around any bearing
//! (`crate::element::amendment`).

use crate::material::wrapper::wrapper::{Wrapped, Wrapper};
use crate::material::{Material, MaterialResult, Slot, Strain, Stress, UniaxialTraits};
use crate::numeric::Dual;
use crate::probe::Probe;

/// Decrease of the stress of rubber with the largest strain so far, and its recovery with time.
///
/// The stress is F(γₘ) times that of the softened rubber, with F = 1 + R exp(-γₘ/γ₀) and γₘ the largest strain so
/// far. Such damage follows Simo (1987, Computer Methods in Applied Mechanics and Engineering 60, 153-173) and Miehe
/// (1995, European Journal of Mechanics A 14, 697-720). The first excursion to a strain is stiffer than the next one,
/// which joins it there. F only decreases under load, so softening dissipates -F' ψ ≥ 0 for every law with energy ψ.
///
/// With an exponent p the return to the virgin path is gradual (pseudo-elastic softening; Ogden and Roxburgh, 1999,
/// Proc. R. Soc. A 455, 2861-2877, in terms of the strain). Below γₘ the factor is
///
/// F = 1 + R (1 - (1 - exp(-γₘ/γ₀)) (1 - (|γ|/γₘ)ᵖ)),
///
/// and 1 + R on the virgin path. Without p the return is the jump of the limit p → ∞, and the virgin path softens.
///
/// A fraction of the softening heals. With a time constant γₘ decays to (1 - fraction) times the all-time largest
/// strain, but never below the present strain. Healing is the only source of energy in the model.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Softening {
    /// Excess stress R of virgin rubber relative to softened rubber.
    pub excess: f64,
    /// Strain γ₀ of the exponential decay.
    pub strain: f64,
    /// Exponent p of the return to the virgin path; `None` if softened rubber stays soft up to the virgin path.
    pub power: Option<f64>,
    /// Fraction of the largest strain that heals, 0 to 1.
    pub healed: f64,
    /// Time constant of healing.
    pub time: f64,
    /// Largest strain before the analysis.
    pub preload: f64,
}

/// History of the softening: the present γₘ and the all-time largest strain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Peak {
    /// γₘ after healing.
    pub now: Dual,
    /// All-time largest strain.
    pub ever: f64,
}

impl Softening {
    /// History before the analysis.
    pub fn virgin(&self) -> Peak {
        Peak { now: Dual::constant(self.preload), ever: self.preload }
    }

    /// Factor F on the stress of the softened rubber at rest.
    pub(in crate::material) fn factor(&self, peak: Dual) -> Dual {
        Dual::constant(1.0) + self.excess * ((-1.0 / self.strain) * peak).exp()
    }

    /// Factor F at an absolute strain `size`, at most γₘ.
    pub fn factor_at(&self, peak: Dual, size: Dual) -> Dual {
        let one = Dual::constant(1.0);
        match self.power {
            None => self.factor(peak),
            Some(_) if size.value >= peak.value => Dual::constant(1.0 + self.excess),
            Some(p) => {
                let decay = ((-1.0 / self.strain) * peak).exp();
                one + self.excess * (decay + (one - decay) * (size / peak).powf(Dual::constant(p)))
            }
        }
    }

    /// History after `time`, at the end of which the strain (or its norm) is `strain`.
    pub fn advance(&self, old: Peak, strain: Dual, time: f64) -> Peak {
        let floor = (1.0 - self.healed) * old.ever;
        let above = old.now.value - floor;
        let healed =
            if self.healed > 0.0 && above > 0.0 { floor + above * (-time / self.time).exp() } else { old.now.value };
        let size = strain.abs();
        let now = if size.value > healed { size } else { Dual::constant(healed) };
        Peak { now, ever: old.ever.max(size.value) }
    }
}

/// A law multiplied by the softening factor of the largest strain.
pub type Mullins = Wrapped<SofteningFactor>;

/// Factor of [`Mullins`] on the law inside.
#[derive(Clone, Debug)]
pub struct SofteningFactor {
    softening: Softening,
}

/// State variables before those of the inner law: γₘ, the all-time largest strain, the factor.
const PEAK: usize = 0;
const EVER: usize = 1;
const FACTOR: usize = 2;
const INNER: usize = 3;

impl Mullins {
    /// Wraps a material, given with its tag.
    pub fn new(material: (Material, i32), softening: Softening) -> Self {
        Self::around(SofteningFactor { softening }, [material])
    }
}

impl SofteningFactor {
    /// Factor before the analysis.
    fn virgin_factor(&self) -> f64 {
        self.softening.factor_at(self.softening.virgin().now, Dual::constant(0.0)).value
    }
}

impl Wrapper for SofteningFactor {
    const NAME: &'static str = "Mullins";
    const HEADER: usize = INNER;
    const NUMBERED: bool = false;

    fn init(&self, own: &mut [f64], _: &[Slot]) {
        let Peak { now, ever } = self.softening.virgin();
        (own[PEAK], own[EVER], own[FACTOR]) = (now.value, ever, self.virgin_factor());
    }
    fn update(&self, inner: &[Slot], committed: &[f64], strain: Strain, next: &mut [f64]) -> MaterialResult<Stress> {
        let old = Peak { now: Dual::constant(committed[PEAK]), ever: committed[EVER] };
        let trial = Dual { value: strain.value, slope: 1.0 };
        let peak = self.softening.advance(old, trial, strain.dt.abs());
        let factor = self.softening.factor_at(peak.now, trial.abs());
        (next[PEAK], next[EVER], next[FACTOR]) = (peak.now.value, peak.ever, factor.value);
        let s = inner[0].update(committed, strain, next)?;
        let whole = factor * Dual { value: s.value, slope: s.tangent };
        Ok(Stress { value: whole.value, tangent: whole.slope, damping: factor.value * s.damping })
    }
    fn initial_tangent(&self, inner: &[Slot]) -> f64 {
        self.virgin_factor() * inner[0].material.initial_tangent()
    }
    fn traits(&self, inner: UniaxialTraits) -> UniaxialTraits {
        UniaxialTraits { linear: false, elapses: inner.elapses || self.softening.healed > 0.0, ..inner }
    }
    fn has_failed(&self, _: &[f64]) -> bool {
        false
    }
    fn shown_strain(&self, inner: &[Slot], strain: f64, state: &[f64]) -> f64 {
        inner[0].shown(strain, state)
    }
    fn probe(&self, _: &[Slot], word: &str) -> Option<Probe> {
        (word == "factor").then(|| Probe::new(0, ["factor"]))
    }
    fn read(&self, _: &[Slot], _: u32, state: &[f64], out: &mut [f64]) {
        out[0] = state[FACTOR];
    }
}
