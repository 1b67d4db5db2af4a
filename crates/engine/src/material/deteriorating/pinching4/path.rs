//! Four points of a path from one side of `Pinching4` to the other.

use super::{Pinching4Side, Rules};

/// Slope, and difference of stress shares, that counts as none.
pub(super) const FLAT: f64 = 1e-8;
/// Factor that puts the reloading point beyond the end of unloading.
const BEYOND: f64 = 1.0 + 1e-6;

/// Strain and stress at both ends, with the signs of the side that the path goes to.
pub(super) struct Ends {
    pub(super) start: [f64; 2],
    pub(super) target: [f64; 2],
}

/// The side that a path goes to.
pub(super) struct Target<'a> {
    /// The positive side.
    pub(super) positive: bool,
    /// Its parameters.
    pub(super) rule: &'a Pinching4Side,
    /// The largest strain is beyond the third point of the envelope.
    pub(super) beyond: bool,
    /// Damaged stresses of the third and fourth point.
    pub(super) strength: [f64; 2],
    /// Damaged stiffness of the side.
    pub(super) loading: f64,
    /// Damaged stiffness of the side where the path starts.
    pub(super) unloading: f64,
}

/// The points of a path: start, end of unloading, begin of reloading, target.
pub struct Path {
    pub(super) strain: [f64; 4],
    pub(super) stress: [f64; 4],
}

impl Path {
    /// The path between two ends.
    pub(super) fn between<R: Rules>(ends: &Ends, to: &Target<'_>) -> Self {
        let mut path = Self::straight(ends);
        if path.strain[0] * path.strain[3] < 0.0 {
            path.pinch::<R>(ends, to);
        }
        path.check::<R>(ends, to.positive);
        path
    }

    fn straight(ends: &Ends) -> Self {
        let ([x0, y0], [x3, y3]) = (ends.start, ends.target);
        let at = |a: f64, b: f64| [a, a + 0.33 * (b - a), a + 0.67 * (b - a), b];
        Self { strain: at(x0, x3), stress: at(y0, y3) }
    }

    /// Stress at which reloading begins.
    fn reloading_stress<R: Rules>(to: &Target<'_>, target: f64) -> f64 {
        let rule = to.rule;
        let no_unloading = rule.unloading_stress == 0.0 && R::reloads_at_its_share(to.positive);
        if no_unloading || rule.reloading_stress - rule.unloading_stress > FLAT {
            return target * rule.reloading_stress;
        }
        let strength = if to.beyond { target } else { to.strength[0] };
        (strength * rule.unloading_stress * BEYOND).max(to.strength[1] * BEYOND)
    }

    /// Moves the two inner points to where unloading ends and reloading begins.
    fn pinch<R: Rules>(&mut self, ends: &Ends, to: &Target<'_>) {
        let ([x0, y0], [x3, y3]) = (ends.start, ends.target);
        let y2 = Self::reloading_stress::<R>(to, y3);
        let mut x2 = x3 * to.rule.reloading_strain;
        if (y3 - y2) / (x3 - x2) > to.loading {
            x2 = x3 - (y3 - y2) / to.loading;
        }
        if x2 < x0 {
            return;
        }
        let y1 = to.rule.unloading_stress * to.strength[usize::from(to.beyond)];
        let x1 = x0 + (y1 - y0) / to.unloading;
        let slope = (y2 - y1) / (x2 - x1);
        if x1 >= x0 && slope > to.unloading.max(to.loading) {
            return;
        }
        (self.strain[1], self.strain[2]) = (x1, x2);
        (self.stress[1], self.stress[2]) = (y1, y2);
        if x1 < x0 {
            self.halve(1);
        } else if x2 < x1 || slope < 0.0 {
            if x1 > 0.0 {
                self.halve(1);
            } else if x2 < 0.0 {
                self.halve(2);
            } else {
                self.level();
            }
        }
    }

    /// Moves an inner point to the middle of its neighbours.
    fn halve(&mut self, i: usize) {
        for values in [&mut self.strain, &mut self.stress] {
            values[i] = values[i - 1] + 0.5 * (values[i + 1] - values[i - 1]);
        }
    }

    /// Gives the inner points nearly the same stress, on the lines of unloading and reloading.
    fn level(&mut self) {
        let mean = 0.5 * (self.stress[2] + self.stress[1]);
        let (first, last) = (self.slope(0), self.slope(2));
        (self.stress[1], self.stress[2]) = (mean - mean.abs() / 100.0, mean + mean.abs() / 100.0);
        self.strain[1] = self.strain[0] + (self.stress[1] - self.stress[0]) / first;
        self.strain[2] = self.strain[3] - (self.stress[3] - self.stress[2]) / last;
    }

    /// A path that goes back is replaced by a straight one.
    fn check<R: Rules>(&mut self, ends: &Ends, positive: bool) {
        let back = |v: &[f64; 4]| (0..3).any(|i| v[i + 1] - v[i] < 0.0);
        if back(&self.strain) || back(&self.stress) {
            *self = Self::straight(ends);
            let slope = (self.stress[3] - self.stress[0]) / (self.strain[3] - self.strain[0]);
            R::through_zero(self, slope, positive);
        }
    }

    /// Takes the path through zero at an inner point, and through half of the end beyond the other.
    pub(super) fn bend(&mut self, zero: usize) {
        let (other, end) = if zero == 1 { (2, 3) } else { (1, 0) };
        for values in [&mut self.strain, &mut self.stress] {
            values[zero] = 0.0;
            values[other] = values[end] / 2.0;
        }
    }

    pub(super) fn slope(&self, i: usize) -> f64 {
        (self.stress[i + 1] - self.stress[i]) / (self.strain[i + 1] - self.strain[i])
    }

    /// Stress and slope on the line of segment `i`.
    pub(super) fn on_segment(&self, i: usize, x: f64) -> (f64, f64) {
        let k = self.slope(i);
        (self.stress[i] + (x - self.strain[i]) * k, k)
    }
}
