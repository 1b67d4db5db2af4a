//! Measures of one hysteresis loop.

use std::f64::consts::TAU;

/// Work up to each sample, W = ∫ F du, by the trapezoidal rule. It is zero at the first sample.
pub fn work(u: &[f64], f: &[f64]) -> Vec<f64> {
    let mut sum = 0.0;
    let steps = u.windows(2).zip(f.windows(2)).map(|(u, f)| {
        sum += 0.5 * (f[0] + f[1]) * (u[1] - u[0]);
        sum
    });
    u.first().map(|_| 0.0).into_iter().chain(steps).collect()
}

/// Extremes and dissipated energy of one loop of force over displacement.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Loop {
    /// Largest displacement.
    pub u_max: f64,
    /// Smallest displacement.
    pub u_min: f64,
    /// Largest force.
    pub f_max: f64,
    /// Smallest force.
    pub f_min: f64,
    /// Displacement at the largest force.
    pub u_at_f_max: f64,
    /// Displacement at the smallest force.
    pub u_at_f_min: f64,
    /// Dissipated energy E: the enclosed area. A straight line closes an open loop.
    pub energy: f64,
}

impl Loop {
    /// The loop of the samples of one cycle; all zeros without samples.
    pub fn of(u: &[f64], f: &[f64]) -> Self {
        let n = u.len().min(f.len());
        let (Some((&u0, &f0)), Some((&u1, &f1))) = (u.first().zip(f.first()), u[..n].last().zip(f[..n].last())) else {
            return Self::default();
        };
        let mut l = Self { u_max: u0, u_min: u0, f_max: f0, f_min: f0, u_at_f_max: u0, u_at_f_min: u0, energy: 0.0 };
        for (&u, &f) in u.iter().zip(f) {
            l.u_max = l.u_max.max(u);
            l.u_min = l.u_min.min(u);
            if f > l.f_max {
                (l.f_max, l.u_at_f_max) = (f, u);
            }
            if f < l.f_min {
                (l.f_min, l.u_at_f_min) = (f, u);
            }
        }
        let path = work(&u[..n], &f[..n]).last().copied().unwrap_or(0.0);
        l.energy = path + 0.5 * (f0 + f1) * (u0 - u1);
        l
    }

    /// Amplitude u: half of the displacement range.
    pub fn amplitude(&self) -> f64 {
        0.5 * (self.u_max - self.u_min)
    }

    /// Secant stiffness K = (F_max - F_min)/(u_max - u_min), the effective lateral stiffness of Table 10 of the paper. It is
    /// zero without a displacement.
    pub fn stiffness(&self) -> f64 {
        ratio(self.f_max - self.f_min, self.u_max - self.u_min)
    }

    /// Equivalent viscous damping ξ = E/(2π K u²) (Table 10 of the paper). It is zero without a displacement.
    pub fn damping(&self) -> f64 {
        ratio(self.energy, TAU * self.stiffness() * self.amplitude().powi(2))
    }
}

/// A rubber specimen in shear.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Specimen {
    /// Area A.
    pub area: f64,
    /// Total thickness of the rubber layers T_r.
    pub thickness: f64,
}

/// Measures of one loop of shear stress over shear strain.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ShearLoop {
    /// Amplitude of the shear strain γ.
    pub strain: f64,
    /// Energy loss per cycle and volume D = ∮ τ dγ.
    pub loss: f64,
    /// Equivalent shear modulus G_eq = (τ_max - τ_min)/(γ_max - γ_min), with the strains at the extreme stresses (Eq 4.2 of
    /// the thesis).
    pub modulus: f64,
    /// Equivalent damping ratio h_eq = D/(2π W) (Eq 4.1 of the thesis), with W = G_eq γ², which is twice the elastic energy.
    pub damping: f64,
}

impl Specimen {
    /// Measures in stresses and strains of a loop in forces and displacements.
    pub fn shear(&self, l: &Loop) -> ShearLoop {
        let strain = l.amplitude() / self.thickness;
        let loss = l.energy / (self.area * self.thickness);
        let modulus = ratio(l.f_max - l.f_min, l.u_at_f_max - l.u_at_f_min) * self.thickness / self.area;
        ShearLoop { strain, loss, modulus, damping: ratio(loss, TAU * modulus * strain.powi(2)) }
    }
}

/// a/b, or zero for b = 0.
pub(super) fn ratio(a: f64, b: f64) -> f64 {
    if b == 0.0 { 0.0 } else { a / b }
}

#[cfg(test)]
mod tests {
    use super::{Loop, Specimen, work};
    use std::f64::consts::{PI, TAU};

    #[test]
    fn measures_of_bilinear_loop() {
        // Elastic 10 up to 1, then 2: ±3 gives a parallelogram of area 4 q (u - u_y) with q = 0.8.
        let u = [-3.0, -2.8, 3.0, 2.8, -3.0];
        let q = 0.8;
        let f = [-6.0 - q, -5.6 + q, 6.0 + q, 5.6 - q, -6.0 - q];
        let l = Loop::of(&u, &f);
        let area = 4.0 * q * 2.9;
        assert!((l.energy - area).abs() < 1e-12);
        assert!((l.stiffness() - 6.8 / 3.0).abs() < 1e-12 && (l.amplitude() - 3.0).abs() < 1e-12);
        assert!((l.damping() - area / (TAU * 6.8 / 3.0 * 9.0)).abs() < 1e-12);
        assert!((work(&u, &f)[4] - area).abs() < 1e-12 && work(&u, &f)[0] == 0.0);
    }

    #[test]
    fn shear_measures_of_ellipse() {
        // F = k u + c u̇ on a specimen: D = π c u² / volume. The damping in stresses differs from that in forces by the
        // strain at the greatest stress.
        let n = 4000;
        let phase: Vec<f64> = (0..=n).map(|i| TAU * f64::from(i) / f64::from(n)).collect();
        let u: Vec<f64> = phase.iter().map(|p| 0.05 * p.sin()).collect();
        let f: Vec<f64> = phase.iter().map(|p| 1000.0 * (p.sin() + 0.2 * p.cos())).collect();
        let l = Loop::of(&u, &f);
        let s = Specimen { area: 0.04, thickness: 0.1 }.shear(&l);
        assert!((s.strain - 0.5).abs() < 1e-12);
        assert!((s.loss - PI * 0.05 * 200.0 / (0.04 * 0.1)).abs() < 1e-2);
        let (tau, gamma) = (1000.0 * 1.0f64.hypot(0.2) / 0.04, 0.5 / 1.0f64.hypot(0.2));
        assert!((s.modulus / (tau / gamma) - 1.0).abs() < 1e-3);
        assert!((s.damping - s.loss / (TAU * s.modulus * 0.25)).abs() < 1e-12);
    }

    #[test]
    fn measures_without_samples_or_motion_are_zero() {
        assert_eq!(Loop::of(&[], &[]), Loop::default());
        let still = Loop::of(&[1.0; 3], &[2.0; 3]);
        assert_eq!((still.stiffness(), still.damping()), (0.0, 0.0));
        assert!(work(&[], &[]).is_empty());
    }
}
