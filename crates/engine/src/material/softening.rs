//! Softening of virgin rubber (Mullins): in a law that has it, around one that has not, and around any bearing
//! (`crate::element::amendment`).

use super::{Material, MaterialError, Slot, Strain, Stress, Uniaxial};
use crate::numeric::Dual;
use crate::probe::Probe;
use std::sync::Arc;

/// How the stress of rubber falls with the largest strain that it has had, and comes back with time.
///
/// The stress is F(γₘ) times that of the softened rubber, F = 1 + R exp(-γₘ/γ₀), γₘ the largest strain so far: damage that
/// depends on the largest strain (Simo, 1987, Computer Methods in Applied Mechanics and Engineering 60, 153-173; Miehe,
/// 1995, European Journal of Mechanics A 14, 697-720). The first excursion to a strain is stiffer than the next, which
/// joins it there. F only falls under load, so softening dissipates -F' ψ ≥ 0 whatever the law with its energy ψ.
///
/// With a power p the way back to the virgin path is gradual (pseudo-elastic softening; Ogden and Roxburgh, 1999, Proc. R.
/// Soc. A 455, 2861-2877, in terms of the strain): below γₘ the factor is
///
/// F = 1 + R (1 - (1 - exp(-γₘ/γ₀)) (1 - (|γ|/γₘ)ᵖ)),
///
/// and 1 + R on the virgin path at all strains. Without one the step back is the limit p → ∞, and the virgin path softens.
///
/// A fraction of the softening heals: γₘ goes back to 1 less that fraction of the largest strain ever with a time constant,
/// never below the present strain. Healing is the only way by which energy comes back.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Softening {
    /// What virgin rubber is stiffer by, R.
    pub excess: f64,
    /// Strain γ₀ over which that goes.
    pub strain: f64,
    /// Exponent p of the way back to the virgin path; none where softened rubber stays so up to it.
    pub power: Option<f64>,
    /// Fraction of the largest strain that heals, 0 to 1.
    pub healed: f64,
    /// Time constant of healing.
    pub time: f64,
    /// Strain that the rubber has had before the analysis.
    pub preload: f64,
}

/// What softening remembers: γₘ as it is, and the largest strain ever.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Peak {
    /// γₘ, less what has healed.
    pub now: Dual,
    /// The largest strain ever.
    pub ever: f64,
}

impl Softening {
    /// Before the analysis.
    pub fn virgin(&self) -> Peak {
        Peak { now: Dual::constant(self.preload), ever: self.preload }
    }

    /// Factor F on the stress of the softened rubber at rest.
    pub(super) fn factor(&self, peak: Dual) -> Dual {
        Dual::constant(1.0) + self.excess * ((-1.0 / self.strain) * peak).exp()
    }

    /// The factor at a strain of size `size`, at most γₘ.
    pub fn factor_at(&self, peak: Dual, size: Dual) -> Dual {
        let one = Dual::constant(1.0);
        match self.power {
            None => self.factor(peak),
            Some(_) if size.value >= peak.value => Dual::constant(1.0 + self.excess),
            Some(p) => {
                let left = ((-1.0 / self.strain) * peak).exp();
                one + self.excess * (left + (one - left) * (size / peak).powf(Dual::constant(p)))
            }
        }
    }

    /// After a time that ends at a strain, or at the size of one.
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

/// Any law, softened by the largest strain.
#[derive(Clone, Debug)]
pub struct Mullins {
    inner: Slot,
    softening: Softening,
}

/// State variables of history before those of the law inside: γₘ, the largest strain ever, the factor.
const PEAK: usize = 0;
const EVER: usize = 1;
const FACTOR: usize = 2;
const INNER: usize = 3;

impl Mullins {
    /// From a material with its tag.
    pub fn new((material, tag): (Material, i32), softening: Softening) -> Self {
        Self { inner: Slot::new(material, tag, INNER), softening }
    }

    /// Factor before the analysis.
    fn virgin_factor(&self) -> f64 {
        self.softening.factor_at(self.softening.virgin().now, Dual::constant(0.0)).value
    }
}

impl Uniaxial for Mullins {
    fn name(&self) -> &'static str {
        "Mullins"
    }
    fn state_len(&self) -> usize {
        INNER + self.inner.len()
    }
    fn init(&self, state: &mut [f64]) {
        let Peak { now, ever } = self.softening.virgin();
        (state[PEAK], state[EVER], state[FACTOR]) = (now.value, ever, self.virgin_factor());
        self.inner.init(state);
    }
    fn update(&self, committed: &[f64], strain: Strain, next: &mut [f64]) -> Result<Stress, MaterialError> {
        let old = Peak { now: Dual::constant(committed[PEAK]), ever: committed[EVER] };
        let trial = Dual { value: strain.value, slope: 1.0 };
        let peak = self.softening.advance(old, trial, strain.dt.abs());
        let factor = self.softening.factor_at(peak.now, trial.abs());
        (next[PEAK], next[EVER], next[FACTOR]) = (peak.now.value, peak.ever, factor.value);
        let s = self.inner.update(committed, strain, next)?;
        let whole = factor * Dual { value: s.value, slope: s.tangent };
        Ok(Stress { value: whole.value, tangent: whole.slope, damping: factor.value * s.damping })
    }
    fn initial_tangent(&self) -> f64 {
        self.virgin_factor() * self.inner.material.initial_tangent()
    }
    fn is_viscous(&self) -> bool {
        self.inner.material.is_viscous()
    }
    fn depends_on_time(&self) -> bool {
        self.softening.healed > 0.0 || self.inner.material.depends_on_time()
    }
    fn is_linear(&self) -> bool {
        false
    }
    fn shown_strain(&self, strain: f64, state: &[f64]) -> f64 {
        self.inner.shown(strain, state)
    }
    fn with_parameter(&self, words: &[&str], value: f64) -> Option<(Material, f64)> {
        let mut new = self.clone();
        let old = new.inner.set_parameter(words, value)?;
        Some((Arc::new(new), old))
    }
    fn probe(&self, words: &[&str]) -> Option<Probe> {
        match *words.first()? {
            "factor" => Some(Probe::new(0, ["factor"])),
            "material" => Some(self.inner.probe(&words[1..])?.inside(&[1])),
            _ => self.inner.material.probe(words).map(|p| p.inside(&[2])),
        }
    }
    fn read(&self, path: &[u32], state: &[f64], out: &mut [f64]) {
        match path[0] {
            0 => out[0] = state[FACTOR],
            1 => self.inner.read(&path[1..], state, out),
            _ => self.inner.read_own(&path[1..], state, out),
        }
    }
}
