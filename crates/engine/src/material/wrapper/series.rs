//! Materials in series.

use crate::material::wrapper::wrapper::{Wrapped, Wrapper};
use crate::material::{Material, MaterialError, MaterialResult, Slot, Strain, Stress, UniaxialTraits};
use crate::probe::Probe;

/// Materials with the same stress. The strain is the sum of their strains.
pub type Series = Wrapped<CommonStress>;

/// Common stress of the materials of [`Series`].
#[derive(Clone, Debug)]
pub struct CommonStress {
    iteration: Iteration,
}

/// The common stress with the materials that have it.
struct Components<'a> {
    slots: &'a [Slot],
    iteration: Iteration,
}

/// Solution method for the common stress of the components.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Iteration {
    /// Newton's method until the component stresses agree to round-off.
    Converged,
    /// As in OpenSees: a maximum number of iterations, or until the energy of the residual is less than the
    /// tolerance. The residual is carried into the next step.
    FixedIterations(usize, f64),
}

/// State variables before those of the components.
const HEADER: usize = 3;
/// Stress of the series; the component stresses differ from it by the residual.
const STRESS: usize = 0;
/// Tangent minus the initial tangent.
const SOFTENING: usize = 1;
/// Strain of the series.
const STRAIN: usize = 2;

/// Tolerance of the component stresses' spread, relative to the largest stress: a few thousand times the machine
/// precision.
const STRESS_TOLERANCE: f64 = 1e-12;
/// Relative change of the flexibility below which a correction is linear.
const FLEXIBILITY_TOLERANCE: f64 = 1e-9;
/// Tolerance of a stagnating spread, relative to the stress that round-off scales with. It covers laws whose internal
/// numbers exceed their stress.
const ROUNDOFF_TOLERANCE: f64 = 1e-4;
/// Number of linear corrections without improvement before a spread counts as round-off.
const MIN_STAGNANT_ITERATIONS: u32 = 3;
/// Maximum number of Newton iterations.
const MAX_ITERATIONS: usize = 30;
/// Numbers of strain increments, tried in turn until the step converges.
const INCREMENTS: [i32; 5] = [1, 4, 16, 64, 256];
/// Stiffness below which the flexibility is bounded by its inverse, as in OpenSees.
const MIN_STIFFNESS: f64 = 1e-12;

/// Spread of the component stresses after a correction.
#[derive(Clone, Copy)]
struct StressSpread {
    value: f64,
    /// True if the correction did not change the flexibility: in exact arithmetic the spread would be zero.
    linear: bool,
}

/// Detects spreads that are round-off. If the common stress goes to zero, the component stresses keep the round-off
/// of their larger committed values.
struct Rounding {
    /// Smallest spread so far.
    smallest: f64,
    /// Number of successive linear corrections without improvement.
    stagnant: u32,
}

impl Rounding {
    /// Returns true if a spread is round-off relative to the stress `rounded`.
    fn is_roundoff(&mut self, spread: StressSpread, rounded: f64) -> bool {
        let stagnates = spread.value >= 0.5 * self.smallest;
        self.stagnant = if spread.value >= self.smallest && spread.linear { self.stagnant + 1 } else { 0 };
        self.smallest = self.smallest.min(spread.value);
        stagnates && spread.value <= STRESS_TOLERANCE * rounded
            || self.stagnant >= MIN_STAGNANT_ITERATIONS && spread.value <= ROUNDOFF_TOLERANCE * rounded
    }
}

impl Series {
    /// From materials, each with its tag.
    pub fn new(materials: Vec<(Material, i32)>, iteration: Iteration) -> Self {
        Self::around(CommonStress { iteration }, materials)
    }
}

impl Components<'_> {
    fn initial_tangent(&self) -> f64 {
        let k = self.slots.iter().map(|slot| slot.material.initial_tangent());
        k.reduce(|a, b| if a + b == 0.0 { 0.0 } else { a * b / (a + b) }).unwrap_or(0.0)
    }

    fn depends_on_time(&self) -> bool {
        self.slots.iter().any(|slot| slot.material.depends_on_time())
    }

    fn update(&self, committed: &[f64], strain: Strain, next: &mut [f64]) -> MaterialResult<Stress> {
        let initial = self.initial_tangent();
        if (strain.value - committed[STRAIN]).abs() < f64::EPSILON && !self.depends_on_time() {
            next.copy_from_slice(&committed[..next.len()]);
            let tangent = initial + committed[SOFTENING];
            return Ok(Stress { value: committed[STRESS], tangent, damping: 0.0 });
        }
        let s = match self.iteration {
            Iteration::Converged => self.converge(committed, strain, next)?,
            Iteration::FixedIterations(limit, tolerance) => {
                self.fixed_iterations(committed, strain, next, (limit, tolerance))?
            }
        };
        next[..HEADER].copy_from_slice(&[s.value, s.tangent - initial, strain.value]);
        Ok(s)
    }

    /// Evaluates a component at a strain; returns its stress and flexibility.
    fn set(
        &self,
        i: usize,
        committed: &[f64],
        value: f64,
        dt: f64,
        next: &mut [f64],
    ) -> MaterialResult<ComponentResponse> {
        // The components' rates are unknown, since only the total rate is given.
        let s = self.slots[i].update(committed, Strain { value, rate: 0.0, dt }, next)?;
        Ok(ComponentResponse { stress: s.value, flexibility: flexibility(s.tangent) })
    }

    /// The iterations of OpenSees. Each component gets the strain that would give it the stress of the series.
    fn fixed_iterations(
        &self,
        committed: &[f64],
        strain: Strain,
        next: &mut [f64],
        (limit, tolerance): (usize, f64),
    ) -> MaterialResult<Stress> {
        let mut tangent = self.initial_tangent() + committed[SOFTENING];
        let mut dq = tangent * (strain.value - committed[STRAIN]);
        let mut stress = committed[STRESS] + dq;
        next.copy_from_slice(&committed[..next.len()]);
        let virgin = committed[STRAIN] == 0.0 && committed[STRESS] == 0.0 && committed[SOFTENING] == 0.0;
        for round in 0..limit {
            let (mut f, mut total) = (0.0, 0.0);
            for (i, component) in self.slots.iter().enumerate() {
                let start = if virgin && round == 0 { 0.0 } else { flexibility(component.tangent(next)) };
                let own = component.strain(next) + start * (stress - component.stress(next));
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

    /// Newton's method for the common stress. If a large step cycles between the kinks of the components, the strain
    /// is applied in increments. Every component stress is still that of one step from the committed state.
    fn converge(&self, committed: &[f64], strain: Strain, next: &mut [f64]) -> MaterialResult<Stress> {
        for increments in INCREMENTS {
            next.copy_from_slice(&committed[..next.len()]);
            let start = committed[STRAIN];
            let mut found = Some(Stress { value: committed[STRESS], ..Stress::default() });
            for k in 1..=increments {
                let fraction = f64::from(k) / f64::from(increments);
                let value = if k == increments { strain.value } else { start + fraction * (strain.value - start) };
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

    /// Largest stress that round-off scales with: the committed stresses, and stiffness times strain.
    fn rounded_stress(&self, committed: &[f64], next: &[f64]) -> f64 {
        let of_component = |component: &Slot| {
            let stiffness = component.material.initial_tangent().abs().max(component.tangent(next).abs());
            let strain = component.strain(committed).abs().max(component.strain(next).abs());
            component.stress(committed).abs().max(stiffness * strain)
        };
        self.slots.iter().map(of_component).fold(0.0, f64::max)
    }

    /// Newton's method from the component states in `next` and a stress. `None` if it does not converge.
    fn newton(
        &self,
        committed: &[f64],
        strain: Strain,
        mut stress: f64,
        next: &mut [f64],
    ) -> MaterialResult<Option<Stress>> {
        let mut scale = self.initial_tangent().abs() * strain.value.abs();
        let mut rounding = Rounding { smallest: f64::INFINITY, stagnant: 0 };
        for _ in 0..MAX_ITERATIONS {
            // Stress for which the linearised components have the total strain.
            let (mut f, mut total) = (0.0, 0.0);
            for component in self.slots {
                let own = flexibility(component.tangent(next));
                f += own;
                total += component.strain(next) + own * (stress - component.stress(next));
            }
            stress += (strain.value - total) / f;
            let (mut rest, mut softest, mut largest) = (strain.value, 0, 0.0);
            for (i, component) in self.slots.iter().enumerate() {
                let own = flexibility(component.tangent(next));
                let value = component.strain(next) + own * (stress - component.stress(next));
                rest -= value;
                if own.abs() > largest {
                    (softest, largest) = (i, own.abs());
                }
                self.set(i, committed, value, strain.dt, next)?;
            }
            // The softest component takes the remaining strain, because its stress changes least.
            let value = self.slots[softest].strain(next) + rest;
            self.set(softest, committed, value, strain.dt, next)?;
            let stresses = || self.slots.iter().map(|p| p.stress(next));
            let (low, high) = stresses().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), s| (l.min(s), h.max(s)));
            scale = scale.max(low.abs()).max(high.abs());
            let after: f64 = self.slots.iter().map(|p| flexibility(p.tangent(next))).sum();
            let spread =
                StressSpread { value: high - low, linear: (after - f).abs() <= FLEXIBILITY_TOLERANCE * f.abs() };
            if spread.value <= STRESS_TOLERANCE * scale
                || rounding.is_roundoff(spread, self.rounded_stress(committed, next))
            {
                let value = self.slots[0].stress(next);
                return Ok(Some(Stress { value, tangent: flexibility(after), damping: 0.0 }));
            }
        }
        Ok(None)
    }
}

struct ComponentResponse {
    stress: f64,
    flexibility: f64,
}

/// 1/k, bounded if k vanishes.
fn flexibility(k: f64) -> f64 {
    if k.abs() > MIN_STIFFNESS { 1.0 / k } else { 1e12_f64.copysign(k) }
}

impl CommonStress {
    fn of<'a>(&self, slots: &'a [Slot]) -> Components<'a> {
        Components { slots, iteration: self.iteration }
    }
}

impl Wrapper for CommonStress {
    const NAME: &'static str = "Series";
    const HEADER: usize = HEADER;
    const NUMBERED: bool = true;

    fn init(&self, own: &mut [f64], _: &[Slot]) {
        own.fill(0.0);
    }
    fn update(&self, inner: &[Slot], committed: &[f64], strain: Strain, next: &mut [f64]) -> MaterialResult<Stress> {
        self.of(inner).update(committed, strain, next)
    }
    fn initial_tangent(&self, inner: &[Slot]) -> f64 {
        self.of(inner).initial_tangent()
    }
    /// The components' rates are unknown.
    fn traits(&self, inner: UniaxialTraits) -> UniaxialTraits {
        let linear = self.iteration == Iteration::Converged && inner.linear;
        UniaxialTraits { linear, viscous: false, ..inner }
    }
    fn has_failed(&self, _: &[f64]) -> bool {
        false
    }
    fn shown_strain(&self, _: &[Slot], strain: f64, _: &[f64]) -> f64 {
        strain
    }
    fn probe(&self, inner: &[Slot], word: &str) -> Option<Probe> {
        (word == "strains").then(|| Probe::new(0, inner.iter().map(|_| "eps11")))
    }
    fn read(&self, inner: &[Slot], _: u32, state: &[f64], out: &mut [f64]) {
        out.iter_mut().zip(inner).for_each(|(o, slot)| *o = slot.strain(state));
    }
}
