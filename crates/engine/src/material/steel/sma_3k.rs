//! Shape-memory alloy with three stiffnesses (Aceto, Camata and Petracca, ASDEA Software Technology).

use crate::material::{MaterialResult, Strain, Stress, UniaxialLaw, finite};

/// A flag whose way back from the upper plateau is softer than the elastic stiffness.
#[derive(Clone, Debug, PartialEq)]
pub struct Sma3k {
    /// Elastic stiffness.
    pub k1: f64,
    /// Stiffness of the plateaus.
    pub k2: f64,
    /// Stiffness of unloading from the upper plateau.
    pub k3: f64,
    /// Force at which the upper plateau begins.
    pub force: f64,
    /// Height of the flag over that force.
    pub beta: f64,
}

crate::state_struct! {
    /// History of [`Sma3k`]; strains and stresses of the negative side have their signs changed.
    pub struct History {
        /// Strain.
        strain: f64,
        /// Stress.
        stress: f64,
        /// Elastic stiffness minus the tangent.
        softening: f64,
        /// 1 after the first strain: the places below are set.
        begun: f64,
        /// Strain of zero stress of the present line, positive and negative side.
        origin: [f64; 2],
        /// Strain and stress at which the upper plateau is met.
        upper: [[f64; 2]; 2],
        /// Strain and stress at which the lower plateau is met.
        lower: [[f64; 2]; 2],
        /// 1 where the way back meets the elastic line before the lower plateau.
        short: [f64; 2],
        /// 1 after the upper plateau.
        activated: [f64; 2],
    }
}

impl Sma3k {
    /// Strain of activation.
    fn first(&self) -> f64 {
        self.force / self.k1
    }

    /// Place on the upper plateau on the elastic line through a place.
    fn plateau(&self, [x, f]: [f64; 2]) -> [f64; 2] {
        let e = (self.k1 * x - f - self.k2 * self.first() + self.force) / (self.k1 - self.k2);
        [e, self.k2 * e - self.k2 * self.first() + self.force]
    }

    /// Response on a side, with strain and stress positive there.
    fn side(&self, c: &History, t: &mut History, i: usize, x: f64, d: f64) -> (f64, f64) {
        let (k1, k2, k3) = (self.k1, self.k2, self.k3);
        let s = if i == 0 { 1.0 } else { -1.0 };
        let before = s * c.stress;
        t.upper[1 - i] = [self.first(), self.force];
        let (upper, lower) = (c.upper[i], c.lower[i]);
        if x > upper[0] {
            t.activated[i] = 1.0;
            let f = upper[1] + (x - upper[0]) * k2;
            t.upper[i] = [x, f];
            let meet = (f - k3 * x) / (k1 - k3);
            let start = self.force * (1.0 - self.beta) * (1.0 - k2 / k1);
            let low = (f - x * k3 - start) / (k2 - k3);
            t.short[i] = f64::from(low < meet);
            t.lower[i] = if low < meet { [meet, k1 * meet] } else { [low, k2 * low + start] };
            t.origin[i] = x - f / k3;
            return (f, k2);
        }
        if x >= lower[0] {
            if d < 0.0 {
                if c.activated[i] == 0.0 {
                    return ((before + d * k1).min(x * k1), k1);
                }
                let f = before + d * k3;
                t.upper[i] = self.plateau([x, f]);
                return (f, k3);
            }
            t.short[i] = 0.0;
            if c.activated[i] == 0.0 {
                return (((x - c.origin[i]) * k1).min(x * k1), k1);
            }
            let f = (before + d * k1).min(x * k1);
            t.upper[i] = self.plateau([x, f]);
            return (f, k1);
        }
        if k1 * x <= lower[1] && c.short[i] != 0.0 {
            let f = ((x - c.origin[i]) * k1).min(x * k1);
            t.upper[i] = [self.first(), self.force];
            t.origin[i] = x - f / k1;
            return (f, k1);
        }
        let f = lower[1] + (x - lower[0]) * k2;
        t.lower[i] = [x, f];
        t.upper[i] = [x + self.beta * self.force / k1, f + self.beta * self.force];
        t.origin[i] = x - f / k1;
        (f, k2)
    }
}

impl UniaxialLaw for Sma3k {
    type State = History;
    const NAME: &'static str = "ASD_SMA_3K";

    fn update(&self, c: &History, strain: Strain) -> MaterialResult<(Stress, History)> {
        let mut begun = *c;
        if c.begun == 0.0 {
            let share = 1.0 - self.beta;
            begun.begun = 1.0;
            begun.upper = [[self.first(), self.force]; 2];
            begun.lower = [[share * self.first(), share * self.force]; 2];
        }
        let (c, e) = (&begun, strain.value);
        let d = e - c.strain;
        if d.abs() < f64::EPSILON {
            return Ok((Stress { value: c.stress, tangent: self.k1 - c.softening, damping: 0.0 }, *c));
        }
        let mut t = History { strain: e, ..*c };
        let (value, tangent) = if e.abs() <= (1.0 - self.beta) * self.force / self.k1 {
            t.upper = [[self.first(), self.force]; 2];
            t.activated = [0.0; 2];
            (self.k1 * e, self.k1)
        } else if e >= 0.0 {
            self.side(c, &mut t, 0, e, d)
        } else {
            let (f, k) = self.side(c, &mut t, 1, -e, -d);
            (-f, k)
        };
        (t.stress, t.softening) = (value, self.k1 - tangent);
        finite(Self::NAME, e, value, tangent, t)
    }

    fn initial_tangent(&self) -> f64 {
        self.k1
    }
}
