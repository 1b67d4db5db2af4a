//! Materials one behind the other.

use super::{Material, MaterialError, Slot, Strain, Stress, Uniaxial};
use crate::probe::Probe;

/// Materials with the same stress; their strains add up.
#[derive(Clone, Debug)]
pub struct Series {
    parts: Vec<Slot>,
    state_len: usize,
    iteration: Iteration,
}

/// How the stress that all parts share is sought.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Iteration {
    /// Until the parts have the same stress, to round-off.
    Converged,
    /// As in OpenSees: at most so many rounds, or until the energy of the residual is less than the tolerance; what is
    /// left over is carried into the next step.
    Rounds(usize, f64),
}

/// State variables before the parts.
const HEADER: usize = 3;
/// Stress of the whole; the parts' stresses differ from it by what is left over.
const STRESS: usize = 0;
/// Tangent, less the initial one.
const SOFTENING: usize = 1;
/// Strain of the whole.
const STRAIN: usize = 2;

/// Difference of the parts' stresses, as a fraction of the largest, that counts as none.
const CLOSE: f64 = 1e-12;
/// Change of the flexibility, as a fraction, that counts as none.
const SAME: f64 = 1e-9;
/// Difference of the parts' stresses that counts as round-off of a law whose own numbers are larger than its stress, as a
/// fraction of the stress that the parts round by.
const ROUGH: f64 = 1e-4;
/// Corrections by an unchanged flexibility that must have failed before.
const IDLE: u32 = 3;
/// Iterations of Newton's method.
const LIMIT: usize = 30;
const STRAINS: u32 = 1;
const PART: u32 = 2;

/// Difference of the stresses of the parts after a correction.
#[derive(Clone, Copy)]
struct Gap {
    value: f64,
    /// The correction has not changed the flexibility: in exact numbers nothing would be left.
    linear: bool,
}

/// Watches for differences that are round-off. Where the common stress goes to zero, the parts still round by the stresses
/// that they come from.
struct Rounding {
    /// Smallest difference so far.
    least: f64,
    /// Corrections by an unchanged flexibility that have not made it smaller.
    idle: u32,
}

impl Rounding {
    /// Returns true if a difference is round-off, for parts that round by a stress.
    fn explains(&mut self, gap: Gap, rounded: f64) -> bool {
        let stagnates = gap.value >= 0.5 * self.least;
        self.idle = if gap.value >= self.least && gap.linear { self.idle + 1 } else { 0 };
        self.least = self.least.min(gap.value);
        stagnates && gap.value <= CLOSE * rounded || self.idle >= IDLE && gap.value <= ROUGH * rounded
    }
}

impl Series {
    /// From materials with their tags.
    pub fn new(materials: Vec<(Material, i32)>, iteration: Iteration) -> Self {
        let (parts, state_len) = Slot::pack(materials, HEADER);
        Self { parts, state_len, iteration }
    }

    /// Set the strain of a part; its stress and flexibility.
    fn set(&self, i: usize, committed: &[f64], value: f64, dt: f64, next: &mut [f64]) -> Result<Part, MaterialError> {
        // The rate is that of the whole: that of the parts is not known.
        let s = self.parts[i].update(committed, Strain { value, rate: 0.0, dt }, next)?;
        Ok(Part { stress: s.value, flexibility: flexibility(s.tangent) })
    }

    /// The rounds of OpenSees: the parts are given the strain that would bring them to the stress of the whole.
    fn rounds(
        &self,
        committed: &[f64],
        strain: Strain,
        next: &mut [f64],
        (limit, tolerance): (usize, f64),
    ) -> Result<Stress, MaterialError> {
        let mut tangent = self.initial_tangent() + committed[SOFTENING];
        let mut dq = tangent * (strain.value - committed[STRAIN]);
        let mut stress = committed[STRESS] + dq;
        next.copy_from_slice(&committed[..next.len()]);
        let virgin = committed[STRAIN] == 0.0 && committed[STRESS] == 0.0 && committed[SOFTENING] == 0.0;
        for round in 0..limit {
            let (mut f, mut total) = (0.0, 0.0);
            for (i, part) in self.parts.iter().enumerate() {
                let start = if virgin && round == 0 { 0.0 } else { flexibility(part.tangent(next)) };
                let own = part.strain(next) + start * (stress - part.stress(next));
                let p = self.set(i, committed, own, strain.dt, next)?;
                f += p.flexibility;
                total += own + p.flexibility * (stress - p.stress);
            }
            tangent = flexibility(f);
            dq = tangent * (strain.value - total);
            if (dq * (strain.value - total)).abs() < tolerance || round + 1 == limit {
                break;
            }
        }
        stress += dq;
        Ok(Stress { value: stress, tangent, damping: 0.0 })
    }

    /// Newton's method for the stress that all parts share. Where a large step makes it go round in circles between the
    /// kinks of the parts, it goes to the strain by and by; every stress is that of one step from the committed state.
    fn converge(&self, committed: &[f64], strain: Strain, next: &mut [f64]) -> Result<Stress, MaterialError> {
        for pieces in [1, 4, 16, 64, 256] {
            next.copy_from_slice(&committed[..next.len()]);
            let start = committed[STRAIN];
            let mut found = Some(Stress { value: committed[STRESS], ..Stress::default() });
            for k in 1..=pieces {
                let part = f64::from(k) / f64::from(pieces);
                let value = if k == pieces { strain.value } else { start + part * (strain.value - start) };
                let Some(before) = found else { break };
                found = self.newton(committed, Strain { value, ..strain }, before.value, next)?;
            }
            if let Some(stress) = found {
                return Ok(stress);
            }
        }
        let message = format!("Series found no common stress of its materials at a strain of {:.6e}", strain.value);
        Err(MaterialError(message))
    }

    /// Largest stress that the parts round by: those of the committed state, and stiffness times strain.
    fn rounded_stress(&self, committed: &[f64], next: &[f64]) -> f64 {
        let of_part = |part: &Slot| {
            let stiffness = part.material.initial_tangent().abs().max(part.tangent(next).abs());
            let strain = part.strain(committed).abs().max(part.strain(next).abs());
            part.stress(committed).abs().max(stiffness * strain)
        };
        self.parts.iter().map(of_part).fold(0.0, f64::max)
    }

    /// Newton's method from the parts as they are in `next`, and a stress.
    fn newton(
        &self,
        committed: &[f64],
        strain: Strain,
        mut stress: f64,
        next: &mut [f64],
    ) -> Result<Option<Stress>, MaterialError> {
        let mut scale = self.initial_tangent().abs() * strain.value.abs();
        let mut rounding = Rounding { least: f64::INFINITY, idle: 0 };
        for _ in 0..LIMIT {
            // Stress for which the linearised parts have the strain of the whole.
            let (mut f, mut total) = (0.0, 0.0);
            for part in &self.parts {
                let own = flexibility(part.tangent(next));
                f += own;
                total += part.strain(next) + own * (stress - part.stress(next));
            }
            stress += (strain.value - total) / f;
            let (mut rest, mut softest, mut largest) = (strain.value, 0, 0.0);
            for (i, part) in self.parts.iter().enumerate() {
                let own = flexibility(part.tangent(next));
                let value = part.strain(next) + own * (stress - part.stress(next));
                rest -= value;
                if own.abs() > largest {
                    (softest, largest) = (i, own.abs());
                }
                self.set(i, committed, value, strain.dt, next)?;
            }
            // What round-off leaves over goes to the softest part, whose stress feels it least.
            let value = self.parts[softest].strain(next) + rest;
            self.set(softest, committed, value, strain.dt, next)?;
            let stresses = || self.parts.iter().map(|p| p.stress(next));
            let (low, high) = stresses().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), s| (l.min(s), h.max(s)));
            scale = scale.max(low.abs()).max(high.abs());
            let after: f64 = self.parts.iter().map(|p| flexibility(p.tangent(next))).sum();
            let gap = Gap { value: high - low, linear: (after - f).abs() <= SAME * f.abs() };
            if gap.value <= CLOSE * scale || rounding.explains(gap, self.rounded_stress(committed, next)) {
                let value = self.parts[0].stress(next);
                return Ok(Some(Stress { value, tangent: flexibility(after), damping: 0.0 }));
            }
        }
        Ok(None)
    }
}

struct Part {
    stress: f64,
    flexibility: f64,
}

/// 1/k, bounded where k vanishes.
fn flexibility(k: f64) -> f64 {
    if k.abs() > 1e-12 { 1.0 / k } else { 1e12_f64.copysign(k) }
}

impl Uniaxial for Series {
    fn name(&self) -> &'static str {
        "Series"
    }
    fn state_len(&self) -> usize {
        self.state_len
    }
    fn init(&self, state: &mut [f64]) {
        state[..HEADER].fill(0.0);
        self.parts.iter().for_each(|slot| slot.init(state));
    }
    fn update(&self, committed: &[f64], strain: Strain, next: &mut [f64]) -> Result<Stress, MaterialError> {
        let initial = self.initial_tangent();
        if (strain.value - committed[STRAIN]).abs() < f64::EPSILON && !self.depends_on_time() {
            next.copy_from_slice(&committed[..next.len()]);
            let tangent = initial + committed[SOFTENING];
            return Ok(Stress { value: committed[STRESS], tangent, damping: 0.0 });
        }
        let s = match self.iteration {
            Iteration::Converged => self.converge(committed, strain, next)?,
            Iteration::Rounds(limit, tolerance) => self.rounds(committed, strain, next, (limit, tolerance))?,
        };
        next[..HEADER].copy_from_slice(&[s.value, s.tangent - initial, strain.value]);
        Ok(s)
    }
    fn initial_tangent(&self) -> f64 {
        let k = self.parts.iter().map(|slot| slot.material.initial_tangent());
        k.reduce(|a, b| if a + b == 0.0 { 0.0 } else { a * b / (a + b) }).unwrap_or(0.0)
    }
    fn is_viscous(&self) -> bool {
        false
    }
    fn depends_on_time(&self) -> bool {
        self.parts.iter().any(|slot| slot.material.depends_on_time())
    }
    fn is_linear(&self) -> bool {
        self.iteration == Iteration::Converged && self.parts.iter().all(|slot| slot.material.is_linear())
    }
    fn probe(&self, words: &[&str]) -> Option<Probe> {
        match *words.first()? {
            "strains" => Some(Probe::new(STRAINS, self.parts.iter().map(|_| "eps11"))),
            "material" | "component" => {
                let i = words.get(1)?.parse::<usize>().ok()?.checked_sub(1)?;
                Some(self.parts.get(i)?.probe(&words[2..])?.inside(&[PART, i as u32]))
            }
            _ => None,
        }
    }
    fn read(&self, path: &[u32], state: &[f64], out: &mut [f64]) {
        match path[0] {
            STRAINS => out.iter_mut().zip(&self.parts).for_each(|(o, slot)| *o = slot.strain(state)),
            _ => self.parts[path[1] as usize].read(&path[2..], state, out),
        }
    }
}
