//! Steel of Giuffrè, Menegotto and Pinto with isotropic hardening.

use super::{MaterialError, Strain, Stress, UniaxialLaw};
use crate::numeric::sign;

/// Curved transitions between the elastic and the hardening asymptote (Menegotto and Pinto, 1973). Isotropic
/// hardening shifts the hardening asymptote (Filippou, Popov and Bertero, 1983).
#[derive(Clone, Debug, PartialEq)]
pub struct Steel02 {
    /// Yield strength.
    pub fy: f64,
    /// Initial modulus.
    pub e0: f64,
    /// Hardening ratio.
    pub b: f64,
    /// Sharpness of the transition R₀.
    pub r0: f64,
    /// Loss of sharpness with the plastic strain: cR₁ and cR₂.
    pub c_r: [f64; 2],
    /// Isotropic hardening: a1, a2 in compression, a3, a4 in tension; a1 = a3 = 0 for none.
    pub a: [f64; 4],
    /// Stress at zero strain.
    pub sig_init: f64,
}

impl Steel02 {
    /// OpenSees' defaults of R₀, cR₁ and cR₂.
    pub const TRANSITION: [f64; 3] = [15.0, 0.925, 0.15];
    /// OpenSees' defaults of a1 to a4: no isotropic hardening.
    pub const NO_ISOTROPIC: [f64; 4] = [0.0, 1.0, 0.0, 1.0];
}

crate::state_struct! {
    /// History of [`Steel02`].
    pub struct History {
        /// 1 loading, -1 unloading, 0 virgin.
        loading: f64,
        /// Strain.
        strain: f64,
        /// Stress minus the initial stress.
        stress: f64,
        /// Largest strain at a reversal.
        max: f64,
        /// Smallest strain at a reversal.
        min: f64,
        /// Reference strain of the branch's curvature.
        plastic: f64,
        /// Strain at the intersection of the asymptotes.
        strain_0: f64,
        /// Stress at the intersection of the asymptotes.
        stress_0: f64,
        /// Strain at the last reversal.
        strain_r: f64,
        /// Stress at the last reversal.
        stress_r: f64,
    }
}

impl Steel02 {
    /// Begins a branch towards tension (`s` = 1) or compression (`s` = -1) at the committed point.
    fn reverse(&self, c: &History, eps: f64, t: &mut History, s: f64) {
        let eps_y = self.fy / self.e0;
        let esh = self.b * self.e0;
        (t.strain_r, t.stress_r) = (eps, c.stress + self.sig_init);
        if s > 0.0 {
            t.min = t.min.min(eps)
        } else {
            t.max = t.max.max(eps)
        }
        let [growth, scale] = if s > 0.0 { [self.a[2], self.a[3]] } else { [self.a[0], self.a[1]] };
        let shift = match growth {
            0.0 => 1.0,
            _ => 1.0 + growth * ((t.max - t.min) / (2.0 * scale * eps_y)).powf(0.8),
        };
        let intercept = s * (self.fy * shift - esh * eps_y * shift);
        t.strain_0 = (intercept - t.stress_r + self.e0 * t.strain_r) / (self.e0 - esh);
        t.stress_0 = s * self.fy * shift + esh * (t.strain_0 - s * eps_y * shift);
        t.plastic = if s > 0.0 { t.max } else { t.min };
        t.loading = s;
    }
}

impl UniaxialLaw for Steel02 {
    type State = History;
    const NAME: &'static str = "Steel02";

    fn update(&self, c: &History, strain: Strain) -> Result<(Stress, History), MaterialError> {
        let eps_y = self.fy / self.e0;
        let initial = self.sig_init / self.e0;
        let (eps, before) = (strain.value + initial, c.strain + initial);
        let d = eps - before;
        let mut t = *c;
        t.strain = strain.value;
        if c.loading == 0.0 {
            if d.abs() < 10.0 * f64::EPSILON {
                let stress = Stress { value: self.sig_init, tangent: self.e0, damping: 0.0 };
                return Ok((stress, *c));
            }
            let s = sign(d);
            t = History { loading: s, strain: strain.value, max: eps_y, min: -eps_y, ..*c };
            (t.strain_0, t.stress_0, t.plastic) = (s * eps_y, s * self.fy, s * eps_y);
        } else if c.loading * d < 0.0 {
            self.reverse(c, before, &mut t, sign(d));
        }
        let xi = ((t.plastic - t.strain_0) / eps_y).abs();
        let r = self.r0 * (1.0 - self.c_r[0] * xi / (self.c_r[1] + xi));
        let ratio = (eps - t.strain_r) / (t.strain_0 - t.strain_r);
        let sum = 1.0 + ratio.abs().powf(r);
        let root = sum.powf(1.0 / r);
        let rise = t.stress_0 - t.stress_r;
        let value = t.stress_r + rise * (self.b * ratio + (1.0 - self.b) * ratio / root);
        let tangent = rise / (t.strain_0 - t.strain_r) * (self.b + (1.0 - self.b) / (sum * root));
        if !(value.is_finite() && tangent.is_finite()) {
            return Err(MaterialError(format!("Steel02 has no stress at a strain of {:.6e}", strain.value)));
        }
        t.stress = value - self.sig_init;
        Ok((Stress { value, tangent, damping: 0.0 }, t))
    }

    fn set_parameter(&mut self, name: &str, value: f64) -> Option<f64> {
        let place = match name {
            "sigmaY" | "fy" | "Fy" => &mut self.fy,
            "E" => &mut self.e0,
            "b" => &mut self.b,
            "R0" => &mut self.r0,
            "cR1" => &mut self.c_r[0],
            "cR2" => &mut self.c_r[1],
            "sig0" => &mut self.sig_init,
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

    fn shown_strain(&self, strain: f64) -> f64 {
        strain + self.sig_init / self.e0
    }
}
