//! Reinforcing bars with yield plateau, strain hardening, buckling and low-cycle fatigue (Chang and Mander, 1994,
//! NCEER-94-0006; Kunnath, Heo and Mohle, 2009, Journal of Structural Engineering 135(4), 335-343).

mod branches;
mod buckling;
mod curve;

use crate::material::{MaterialError, MaterialResult, Strain, Stress, UniaxialLaw};
use branches::Path;
pub use buckling::Buckling;
use curve::{Backbone, Curve};

/// Number of levels of reversals that are remembered.
const LEVELS: usize = 11;

/// A bar, by its engineering stresses and strains in tension.
#[derive(Clone, Debug, PartialEq)]
pub struct ReinforcingSteel {
    /// Yield strength.
    pub fy: f64,
    /// Ultimate strength.
    pub fu: f64,
    /// Elastic modulus.
    pub es: f64,
    /// Tangent at the begin of strain hardening.
    pub esh: f64,
    /// Strain at the begin of strain hardening.
    pub eps_sh: f64,
    /// Strain at the ultimate strength.
    pub eps_ult: f64,
    /// Buckling.
    pub buckling: Buckling,
    /// Fatigue and loss of strength, if they are considered.
    pub fatigue: Option<BarFatigue>,
    /// Curves after reversals: R1, R2, R3.
    pub curve: [f64; 3],
    /// Shortening of the yield plateau per plastic strain, and its least share.
    pub hardening: [f64; 2],
}

/// Low-cycle fatigue after Coffin and Manson, with a loss of strength.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BarFatigue {
    /// Ductility constant Cf.
    pub cf: f64,
    /// Exponent.
    pub alpha: f64,
    /// Strength reduction constant Cd; 0 for none.
    pub cd: f64,
}

crate::state_struct! {
    /// History of [`ReinforcingSteel`], in natural strain and stress. Of each pair the first is towards tension, the second
    /// towards compression, and both are positive there.
    pub struct History {
        /// Strain.
        strain: f64,
        /// Stress.
        stress: f64,
        /// Tangent minus the initial one.
        softening: f64,
        /// Branch: 0 virgin, 1 and 2 the envelopes, then odd ones after a turn from the envelope in tension.
        branch: f64,
        /// 1 after the bar has failed.
        failed: f64,
        /// Origins of the envelopes.
        origin: [f64; 2],
        /// Largest strains from the origins.
        largest: [f64; 2],
        /// Largest strains.
        farthest: [f64; 2],
        /// Stresses at the last turns from the envelopes.
        turned: [f64; 2],
        /// Plastic half cycles of the levels.
        plastic: [f64; 11],
        /// Sum of the plastic half cycles.
        accumulated: f64,
        /// Loss of the length of the yield plateau, as a share.
        shortened: f64,
        /// Fatigue damage.
        damage: f64,
        /// Strain to which second transitions return.
        target: f64,
        /// Stress on the unbuckled return curve where buckling began.
        back_stress: f64,
        /// Curves of the levels.
        curves: [Curve; 11],
    }
}

impl History {
    /// The same with tension and compression exchanged.
    fn mirrored(mut self) -> Self {
        for x in [&mut self.strain, &mut self.stress, &mut self.target, &mut self.back_stress] {
            *x = -*x;
        }
        for pair in [&mut self.origin, &mut self.largest, &mut self.farthest, &mut self.turned] {
            pair.swap(0, 1);
        }
        self.plastic.swap(0, 1);
        self.curves.iter_mut().for_each(|c| *c = c.mirrored());
        if self.branch > 0.0 {
            self.branch += if self.branch % 2.0 == 0.0 { -1.0 } else { 1.0 };
        }
        self
    }
}

impl ReinforcingSteel {
    /// Natural strain and stress of the yield point, and the modulus between them.
    fn yields(&self) -> (f64, f64, f64) {
        let strain = self.fy / self.es;
        let (e, f) = (strain.ln_1p(), self.fy * (1.0 + strain));
        (e, f, f / e)
    }

    /// Fatigue damage of a plastic half cycle.
    fn damage(&self, plastic: f64) -> f64 {
        self.fatigue.map_or(0.0, |f| (plastic / f.cf).powf(1.0 / f.alpha))
    }

    /// Derivative of the damage by the plastic half cycle.
    fn damage_slope(&self, plastic: f64) -> f64 {
        self.fatigue.map_or(0.0, |f| (plastic / f.cf).powf(1.0 / f.alpha) / (f.alpha * plastic))
    }

    /// Share of the strength that is left at a fatigue damage, negative for a failed bar; its derivative.
    fn strength(&self, damage: f64) -> (f64, f64) {
        /// Damage beyond that of failure over which the strength is lost.
        const FAILURE: f64 = 0.04;
        let Some(f) = self.fatigue else { return (1.0, 0.0) };
        let slope = if f.cd == 0.0 { 0.0 } else { (f.cf / f.cd).powf(1.0 / f.alpha) };
        let over = damage - 1.0;
        (1.0 - slope * damage - over.max(0.0) / FAILURE, -slope - if over > 0.0 { 1.0 / FAILURE } else { 0.0 })
    }
}

impl UniaxialLaw for ReinforcingSteel {
    type State = History;
    const NAME: &'static str = "ReinforcingSteel";

    fn update(&self, c: &History, strain: Strain) -> MaterialResult<(Stress, History)> {
        /// Strain beyond which the natural strain is not sought.
        const LEAST: f64 = -0.95;
        if strain.value < LEAST {
            return Err(MaterialError(format!("ReinforcingSteel: the strain {} is less than {LEAST}", strain.value)));
        }
        let (e, initial) = (strain.value.ln_1p(), self.yields().2);
        let mut t = *c;
        let failed = c.failed != 0.0;
        let mut damage_slope = 0.0;
        if e != c.strain && !failed {
            if c.branch == 0.0 && e != 0.0 {
                t.branch = if e > 0.0 { 1.0 } else { 2.0 };
            }
            let mut path = Path::new(self, c, t, e);
            path.follow();
            (t, damage_slope) = path.finish();
        }
        t.strain = e;
        let (strength, by_damage) = self.strength(t.damage);
        if failed || strength < 0.0 {
            (t.failed, t.branch) = (1.0, -1.0);
            return Ok((Stress { value: 0.0, tangent: 0.0, damping: 0.0 }, t));
        }
        let backbone = Backbone::new(self, t.shortened);
        let unbuckled = initial + t.softening;
        let (value, tangent) = self.buckling.apply(&backbone, &mut t, unbuckled);
        let engineering = Stress {
            value: value * strength / e.exp(),
            tangent: ((tangent - value) * strength + value * by_damage * damage_slope) / (2.0 * e).exp(),
            damping: 0.0,
        };
        Ok((engineering, t))
    }

    fn initial_tangent(&self) -> f64 {
        self.yields().2
    }
}
