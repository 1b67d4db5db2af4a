//! Bilinear steel with kinematic and optional isotropic hardening.

use super::{MaterialError, Strain, Stress, UniaxialLaw};

/// Uniaxial bilinear steel with kinematic hardening. Isotropic hardening shifts the yield envelopes with the strain
/// range: a1, a2 in compression, a3, a4 in tension (after Filippou, Popov and Bertero, 1983).
#[derive(Clone, Debug, PartialEq)]
pub struct Steel01 {
    /// Yield strength.
    pub fy: f64,
    /// Initial modulus.
    pub e0: f64,
    /// Hardening ratio.
    pub b: f64,
    /// Isotropic hardening a1 to a4; a1 = a3 = 0 for none.
    pub a: [f64; 4],
}

impl Steel01 {
    /// OpenSees' defaults of a1 to a4: no isotropic hardening.
    pub const NO_ISOTROPIC: [f64; 4] = [0.0, 55.0, 0.0, 55.0];
}

crate::state_struct! {
    /// History of [`Steel01`].
    pub struct History {
        /// Smallest strain at a reversal.
        min: f64,
        /// Largest strain at a reversal.
        max: f64,
        /// Shift of the tension envelope minus one, so that the virgin state is zero.
        shift_p: f64,
        /// Shift of the compression envelope minus one.
        shift_n: f64,
        /// 1 loading, -1 unloading, 0 virgin.
        loading: f64,
        /// Strain.
        strain: f64,
        /// Stress.
        stress: f64,
        /// Tangent; zero stands for the initial one.
        tangent: f64,
    }
}

impl UniaxialLaw for Steel01 {
    type State = History;
    const NAME: &'static str = "Steel01";

    fn update(&self, c: &History, strain: Strain) -> Result<(Stress, History), MaterialError> {
        let d = strain.value - c.strain;
        let mut t = *c;
        if d.abs() > f64::EPSILON {
            t.strain = strain.value;
            self.advance(c, d, &mut t);
        }
        let tangent = if t.tangent == 0.0 && c.loading == 0.0 && t.loading == 0.0 { self.e0 } else { t.tangent };
        Ok((Stress { value: t.stress, tangent, damping: 0.0 }, t))
    }

    fn set_parameter(&mut self, name: &str, value: f64) -> Option<f64> {
        let place = match name {
            "sigmaY" | "fy" | "Fy" => &mut self.fy,
            "E" => &mut self.e0,
            "b" => &mut self.b,
            "a1" => &mut self.a[0],
            "a2" => &mut self.a[1],
            "a3" => &mut self.a[2],
            "a4" => &mut self.a[3],
            _ => return None,
        };
        Some(std::mem::replace(place, value))
    }

    fn initial_tangent(&self) -> f64 {
        self.e0
    }
}

impl Steel01 {
    fn advance(&self, c: &History, d: f64, t: &mut History) {
        let [a1, a2, a3, a4] = self.a;
        let fy_1b = self.fy * (1.0 - self.b);
        let esh = self.b * self.e0;
        let eps_y = self.fy / self.e0;
        let elastic = c.stress + self.e0 * d;
        let hardening = esh * t.strain;
        let upper = hardening + (1.0 + c.shift_p) * fy_1b;
        let lower = hardening - (1.0 + c.shift_n) * fy_1b;
        t.stress = elastic.min(upper).max(lower);
        t.tangent = if (t.stress - elastic).abs() < f64::EPSILON { self.e0 } else { esh };

        if c.loading == 0.0 {
            t.loading = d.signum();
        }
        if t.loading == 1.0 && d < 0.0 {
            t.loading = -1.0;
            t.max = t.max.max(c.strain);
            t.shift_n = a1 * ((t.max - t.min) / (2.0 * a2 * eps_y)).powf(0.8);
        } else if t.loading == -1.0 && d > 0.0 {
            t.loading = 1.0;
            t.min = t.min.min(c.strain);
            t.shift_p = a3 * ((t.max - t.min) / (2.0 * a4 * eps_y)).powf(0.8);
        }
    }
}
