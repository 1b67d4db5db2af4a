//! Laws of the damping of an element: the damping force of its basic forces.

use super::fit::Filters;
use crate::element::Histories;
use crate::series::Series;

/// Damping forces as a function of the history of the basic forces of an element.
#[derive(Clone, Debug)]
pub struct ElementDamping {
    /// Law.
    pub law: DampingLaw,
    /// Times after which it begins, and at which it ends.
    pub window: [f64; 2],
    /// Factor of the damping forces over time.
    pub factor: Option<Series>,
}

/// A law of damping.
#[derive(Clone, Debug, PartialEq)]
pub enum DampingLaw {
    /// Low-pass filters of the basic forces, times a factor (Tian, Huang, Qu, Fei and Lu, 2022,
    /// <https://doi.org/10.1080/13632469.2022.2124557>).
    Filters {
        /// Coefficients and cut-off frequencies.
        filters: Filters,
        /// Loss factor that the coefficients are multiplied by; none if they include it.
        loss: Option<f64>,
    },
    /// In proportion to the rate of the basic forces: β times their increment over the time step.
    SecantStiffness {
        /// Coefficient β, time.
        beta: f64,
    },
}

/// Time of a trial state.
#[derive(Clone, Copy, Debug)]
pub struct DampingTime {
    /// Domain time.
    pub time: f64,
    /// Time since the committed state.
    pub dt: f64,
    /// Time passes: the analysis is not static.
    pub dynamic: bool,
}

impl ElementDamping {
    /// Number of state variables for `n` basic forces: the forces, their damping, and the output of each filter.
    pub fn state_len(&self, n: usize) -> usize {
        match &self.law {
            DampingLaw::Filters { filters, .. } => (2 + filters.cutoff.len()) * n,
            DampingLaw::SecantStiffness { .. } => 2 * n,
        }
    }

    /// Damping forces in a state of `n` basic forces.
    pub fn forces<'a>(&self, n: usize, state: &'a [f64]) -> &'a [f64] {
        &state[n..2 * n]
    }

    fn factor(&self, time: f64) -> f64 {
        self.factor.as_ref().map_or(1.0, |f| f.factor(time))
    }

    fn acts(&self, at: DampingTime) -> bool {
        at.time > self.window[0] && at.time < self.window[1]
    }

    /// Writes the trial state for the basic forces `q`. Returns the tangent of the damping forces, as a multiple of that
    /// of the basic forces.
    pub fn update(&self, q: &[f64], at: DampingTime, h: &mut Histories<'_>) -> f64 {
        let n = q.len();
        h.trial.copy_from_slice(h.committed);
        if at.dynamic && at.dt <= 0.0 {
            return 0.0;
        }
        match &self.law {
            DampingLaw::SecantStiffness { beta } => {
                // As in OpenSees, the forces of a static analysis leave no trace.
                h.trial[n..2 * n].fill(0.0);
                if !at.dynamic {
                    return 0.0;
                }
                h.trial[..n].copy_from_slice(q);
                if !self.acts(at) {
                    return 0.0;
                }
                let rate = beta / at.dt;
                let factor = self.factor(at.time);
                for (i, q) in q.iter().enumerate() {
                    h.trial[n + i] = rate * (q - h.committed[i]) * factor;
                }
                rate
            }
            DampingLaw::Filters { filters, loss } => self.filter(filters, loss.unwrap_or(1.0), q, at, h),
        }
    }

    fn filter(&self, filters: &Filters, loss: f64, q: &[f64], at: DampingTime, h: &mut Histories<'_>) -> f64 {
        let n = q.len();
        h.trial[..n].copy_from_slice(q);
        h.trial[n..2 * n].fill(0.0);
        if !at.dynamic || at.time <= self.window[0] && at.time < self.window[1] {
            h.trial[2 * n..].chunks_exact_mut(n).for_each(|low| low.copy_from_slice(q));
            return 0.0;
        }
        if at.time >= self.window[1] {
            return 0.0;
        }
        let (old, low) = h.committed.split_at(2 * n);
        let mut stiffness = 0.0;
        for (k, (cutoff, coefficient)) in filters.cutoff.iter().zip(&filters.coefficient).enumerate() {
            let step = at.dt * cutoff;
            let gain = 4.0 * coefficient * loss / (2.0 + step);
            stiffness += gain;
            let (passed, kept) = (step / (2.0 + step), (2.0 - step) / (2.0 + step));
            for i in 0..n {
                let (both, low) = (old[i] + q[i], low[k * n + i]);
                h.trial[n + i] += gain * (both - 2.0 * low);
                h.trial[(2 + k) * n + i] = passed * both + kept * low;
            }
        }
        let factor = self.factor(at.time);
        for i in 0..n {
            h.trial[n + i] = (h.trial[n + i] - old[n + i]) * factor;
        }
        stiffness * factor
    }
}
