//! Low-cycle fatigue around another material.

use crate::material::wrapper::wrapper::{Wrapped, Wrapper};
use crate::material::{Material, MaterialResult, Slot, Strain, Stress, UniaxialTraits};
use crate::probe::{Probe, Response};
use crate::state_struct::StateStruct;

/// Parameters of [`Fatigue`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FatigueParameters {
    /// Damage at which the material fails, 0 to 1.
    pub d_max: f64,
    /// Strain range at which one cycle causes failure.
    pub e0: f64,
    /// Slope of the Coffin-Manson curve in logarithmic scales, negative.
    pub m: f64,
    /// Smallest and largest strain; the material fails if it reaches either.
    pub limits: (f64, f64),
}

/// A material that fails by low-cycle fatigue (Uriz and Mahin, 2008). A rainflow count over four reversals finds the
/// strain ranges. Their damage is summed by Miner's rule with the Coffin-Manson life. The count is updated at the end
/// of a step, so that failure acts from the next step on. A failed material keeps 1e-8 of its stress.
pub type Fatigue = Wrapped<FatigueCount>;

/// Rainflow count and life of [`Fatigue`].
#[derive(Clone, Debug)]
pub struct FatigueCount {
    p: FatigueParameters,
}

crate::state_struct! {
    /// State of the rainflow count.
    struct Cycles {
        /// 1 once the material has failed.
        failed: f64,
        /// Damage of the closed ranges.
        damage: f64,
        /// First to fourth reversal that are not yet part of a closed range; zero if there is none.
        reversals: [f64; 4],
        /// Strain range before the current one.
        range: f64,
        /// 1 if the third and the fourth reversal are not counted yet.
        pending: f64,
        /// 1 after the second reversal.
        has_second_reversal: f64,
        /// 0 before the first strain, 1 after it.
        started: f64,
        /// Last nonzero strain increment.
        slope: f64,
        /// Last strain.
        last: f64,
        /// Pairs of cycles and range: counted in this step, and two that would be counted if the strain reversed now.
        counted: [[f64; 2]; 3],
    }
}

/// Stress and stiffness of a failed material divided by those of the intact one, as in OpenSees.
const RESIDUAL_STRENGTH_RATIO: f64 = 1.0e-8;
/// Strain ranges below this value cause no damage.
const MIN_STRAIN_RANGE: f64 = 1.0e-10;

impl Fatigue {
    /// Wraps a material, given with its tag.
    pub fn new(material: (Material, i32), p: FatigueParameters) -> Self {
        Self::around(FatigueCount { p }, [material])
    }
}

impl FatigueCount {
    /// Damage of a number of cycles of one range by the Coffin-Manson life.
    fn damage(&self, cycles: f64, range: f64) -> f64 {
        cycles / (range / self.p.e0).powf(1.0 / self.p.m).abs()
    }

    /// Counts a reversal at the last strain.
    fn count_reversal(&self, c: &mut Cycles) {
        let [a, b, third, _] = c.reversals;
        let peak = c.last;
        if c.has_second_reversal == 0.0 {
            c.reversals[1] = peak;
            c.range = (peak - a).abs();
            c.has_second_reversal = 1.0;
            return;
        }
        let waits = c.pending != 0.0;
        let range = (peak - if waits { third } else { b }).abs();
        c.reversals[if waits { 3 } else { 2 }] = peak;
        let count = |c: &mut Cycles, cycles: f64, range: f64| {
            c.damage += self.damage(cycles, range);
            c.counted[0] = [cycles, range];
        };
        match (range < c.range, waits) {
            (true, false) => {
                c.pending = 1.0;
                c.range = range;
            }
            (true, true) => {
                count(c, 1.0, range);
                c.reversals = [a, b, 0.0, 0.0];
                c.range = (b - a).abs();
                c.pending = 0.0;
            }
            (false, true) => {
                let inner = c.range;
                count(c, 1.0, inner);
                c.reversals = [a, peak, 0.0, 0.0];
                c.range = (peak - a).abs();
                c.pending = 0.0;
            }
            (false, false) => {
                let before = c.range;
                count(c, 0.5, before);
                c.reversals = [b, peak, 0.0, 0.0];
                c.range = range;
            }
        }
    }

    /// Total damage if the strain reversed now.
    fn damage_if_reversed(&self, c: &mut Cycles, strain: f64) -> f64 {
        let [a, b, third, fourth] = c.reversals;
        let open = match (b != 0.0, third != 0.0, fourth != 0.0) {
            (false, false, false) => [(0.5, (strain - a).abs()), (0.0, 0.0)],
            (true, false, false) => [(0.5, (strain - b).abs()), (0.5, c.range)],
            (true, true, false) if (a - strain).abs() > (a - b).abs() => [(0.5, (strain - a).abs()), (1.0, c.range)],
            (true, true, false) => [(0.5, (a - b).abs()), (1.0, (third - strain).abs())],
            // Zero marks a missing reversal, so a reversal at zero strain is treated as missing.
            _ => return c.damage,
        };
        let mut damage = c.damage;
        for ((cycles, range), counted) in open.into_iter().zip(&mut c.counted[1..]) {
            *counted = if range < MIN_STRAIN_RANGE { [0.0; 2] } else { [cycles, range] };
            if range >= MIN_STRAIN_RANGE {
                damage += self.damage(cycles, range);
            }
        }
        damage
    }

    /// State of the count at the end of a step.
    fn advance(&self, old: &Cycles, strain: f64, stress: f64) -> Cycles {
        let mut c = *old;
        c.counted[0] = [0.0; 2];
        if strain <= self.p.limits.0 || strain >= self.p.limits.1 {
            c.failed = 1.0;
            c.damage = self.p.d_max;
            return c;
        }
        if c.started == 0.0 {
            (c.started, c.reversals, c.last, c.pending) = (1.0, [strain, 0.0, 0.0, 0.0], strain, 0.0);
        }
        let slope = if strain == c.last { c.slope } else { strain - c.last };
        let sign = |x: f64| if x == 0.0 { 0.0 } else { x.signum() };
        if c.slope != 0.0 && sign(c.slope) != sign(slope) {
            self.count_reversal(&mut c);
            if c.damage >= self.p.d_max {
                c.failed = 1.0;
            }
        }
        if c.failed == 0.0 {
            let damage = self.damage_if_reversed(&mut c, strain);
            // A cracked section still carries compression, so failure needs a tensile stress.
            if damage > self.p.d_max && stress > 0.0 {
                (c.damage, c.failed) = (damage, 1.0);
            }
        }
        (c.slope, c.last) = (slope, strain);
        c
    }
}

impl Wrapper for FatigueCount {
    const NAME: &'static str = "Fatigue";
    const HEADER: usize = Cycles::LEN;
    const NUMBERED: bool = false;

    fn init(&self, own: &mut [f64], _: &[Slot]) {
        Cycles::default().write(own);
    }
    fn update(&self, inner: &[Slot], committed: &[f64], strain: Strain, next: &mut [f64]) -> MaterialResult<Stress> {
        let old = Cycles::read(committed);
        let s = inner[0].update(committed, strain, next)?;
        let failed = old.failed != 0.0;
        let new = if failed {
            Cycles { counted: [[0.0; 2], old.counted[1], old.counted[2]], ..old }
        } else {
            self.advance(&old, strain.value, s.value)
        };
        if new.failed != 0.0 {
            // The history of a failed material is frozen.
            next[Cycles::LEN..].copy_from_slice(&committed[Cycles::LEN..Cycles::LEN + inner[0].len()]);
        }
        new.write(next);
        Ok(if failed {
            Stress {
                value: RESIDUAL_STRENGTH_RATIO * s.value,
                tangent: RESIDUAL_STRENGTH_RATIO * self.initial_tangent(inner),
                damping: 0.0,
            }
        } else {
            s
        })
    }
    fn initial_tangent(&self, inner: &[Slot]) -> f64 {
        inner[0].material.initial_tangent()
    }
    fn traits(&self, inner: UniaxialTraits) -> UniaxialTraits {
        UniaxialTraits { linear: false, ..inner }
    }
    fn has_failed(&self, state: &[f64]) -> bool {
        Cycles::read(state).failed != 0.0
    }
    fn shown_strain(&self, inner: &[Slot], strain: f64, state: &[f64]) -> f64 {
        inner[0].shown(strain, state)
    }
    fn probe(&self, _: &[Slot], word: &str) -> Option<Probe> {
        Response::find(&RESPONSES, word)
    }
    fn read(&self, _: &[Slot], id: u32, state: &[f64], out: &mut [f64]) {
        Response::read(&RESPONSES, id, self, &Cycles::read(state), out);
    }
}

const RESPONSES: [Response<FatigueCount, Cycles>; 3] = [
    Response::new(&["damage"], &["DI"], |_, c, out| out[0] = c.damage),
    Response::new(&["cyclesAndRange"], &CYCLES_AND_RANGE, |_, c, out| out.copy_from_slice(c.counted.as_flattened())),
    Response::new(&["failure"], &["failure"], |_, c, out| out[0] = c.failed),
];
const CYCLES_AND_RANGE: [&str; 6] =
    ["cyclesAndRange1", "cyclesAndRange2", "cyclesAndRange3", "cyclesAndRange4", "cyclesAndRange5", "cyclesAndRange6"];
