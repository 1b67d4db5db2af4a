//! Oscillator of unit mass on a nonlinear spring, by the average acceleration (Newmark, 1959).

use crate::element::Histories;
use crate::material::{Slot, Strain};
use std::f64::consts::TAU;

/// Steps of a period, at least.
const STEPS_PER_PERIOD: f64 = 100.0;
/// Iterations of a step at most, and the part of the largest force so far that may be left over.
const ITERATIONS: usize = 60;
const TOLERANCE: f64 = 1e-10;

/// An oscillator of unit mass. Its damping is viscous and constant: 2 ζ ω of the elastic one.
#[derive(Clone, Debug)]
pub struct InelasticOscillator {
    /// Elastic period in s, more than 0.
    pub period: f64,
    /// Damping as a share of the critical one of the elastic oscillator.
    pub damping: f64,
    /// Law of the spring: force over mass in m/s² of a displacement in m.
    pub law: Slot,
}

/// State of an oscillator at the end of a step.
#[derive(Clone, Copy, Default)]
struct Motion {
    disp: f64,
    vel: f64,
    accel: f64,
}

impl InelasticOscillator {
    /// Largest relative displacement in m under ground accelerations in m/s² at equal steps, which are linear in between, and
    /// in one period of rest after them.
    ///
    /// # Errors
    /// The law has no force, or a step finds no balance.
    pub fn largest_displacement(&self, dt: f64, ground: &[f64]) -> Result<f64, String> {
        let parts = (dt * STEPS_PER_PERIOD / self.period).ceil().max(1.0);
        let h = dt / parts;
        let c = 2.0 * self.damping * TAU / self.period;
        let mut committed = vec![0.0; self.law.len()];
        self.law.init(&mut committed);
        let mut trial = committed.clone();
        let (mut motion, mut largest, mut force) = (Motion::default(), 0.0f64, 0.0f64);
        let rest = (self.period / dt).ceil() as usize + 1;
        let mut last = ground.first().copied().unwrap_or(0.0);
        motion.accel = -last;
        for next in ground.iter().copied().skip(1).chain(std::iter::repeat_n(0.0, rest)) {
            for part in 1..=parts as usize {
                let a = last + (next - last) * part as f64 / parts;
                let history = &mut Histories { committed: &committed, trial: &mut trial };
                motion = self.step(h, c, a, motion, history, &mut force)?;
                std::mem::swap(&mut committed, &mut trial);
                largest = largest.max(motion.disp.abs());
            }
            last = next;
        }
        Ok(largest)
    }

    /// A step to a ground acceleration: Newton's method, and halves of the interval where it leaves it.
    fn step(
        &self,
        h: f64,
        c: f64,
        ground: f64,
        from: Motion,
        history: &mut Histories<'_>,
        scale: &mut f64,
    ) -> Result<Motion, String> {
        let (inertia, slope) = (4.0 / (h * h), 2.0 / h);
        let at = |disp: f64| {
            let step = disp - from.disp;
            Motion { disp, vel: slope * step - from.vel, accel: inertia * step - 2.0 * slope * from.vel - from.accel }
        };
        // The displacements between which the unbalance changes its sign.
        let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
        let mut disp = from.disp;
        for _ in 0..ITERATIONS {
            let now = at(disp);
            let stress = self
                .law
                .update(history.committed, Strain { value: disp, rate: now.vel, dt: h }, history.trial)
                .map_err(|e| e.to_string())?;
            let unbalance = -ground - now.accel - c * now.vel - stress.value;
            *scale = scale.max(stress.value.abs()).max(ground.abs());
            if unbalance.abs() <= TOLERANCE * *scale {
                return Ok(now);
            }
            if unbalance > 0.0 {
                low = disp;
            } else {
                high = disp;
            }
            let next = disp + unbalance / (inertia + c * slope + stress.tangent + slope * stress.damping);
            let inside = next > low && next < high;
            let halved = if low.is_finite() && high.is_finite() { 0.5 * (low + high) } else { next };
            let new = if inside { next } else { halved };
            if new == disp || !new.is_finite() {
                return if new.is_finite() { Ok(now) } else { Err("its displacement is not finite".into()) };
            }
            disp = new;
        }
        Err(format!("a step finds no balance in {ITERATIONS} iterations"))
    }
}
