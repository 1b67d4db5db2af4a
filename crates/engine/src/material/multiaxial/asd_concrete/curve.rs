//! Hardening curves of concrete: stress, damage and effective stress for a total strain.

use crate::probe::Response;

/// A point of a curve.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(in crate::material) struct CurvePoint {
    /// Total strain.
    pub(in crate::material) strain: f64,
    /// Stress.
    pub(in crate::material) stress: f64,
    /// Damage, from 0 to 1.
    pub(in crate::material) damage: f64,
    /// Effective stress: stress / (1 - damage).
    pub(in crate::material) effective: f64,
}

impl CurvePoint {
    /// Plastic strain for a modulus of elasticity.
    pub(in crate::material) fn plastic(&self, e: f64) -> f64 {
        self.strain - self.effective / e
    }
}

/// Points of the curves of tension and compression that a point of concrete has reached, and its modulus of elasticity.
pub(in crate::material) struct ReachedPoints {
    pub(in crate::material) e: f64,
    pub(in crate::material) equivalent: [f64; 2],
    pub(in crate::material) points: [CurvePoint; 2],
}

/// Responses of concrete, by their names in small letters.
pub(in crate::material) const RESPONSES: [Response<ReachedPoints, ()>; 3] = [
    Response::new(&["damage"], &["d+", "d-"], |r, (), out| out.copy_from_slice(&r.points.map(|p| p.damage))),
    Response::new(&["equivalentplasticstrain"], &["PLE+", "PLE-"], |r, (), out| {
        out.copy_from_slice(&r.points.map(|p| p.plastic(r.e)));
    }),
    Response::new(&["equivalenttotalstrain"], &["TE+", "TE-"], |r, (), out| out.copy_from_slice(&r.equivalent)),
];

/// Stress and damage by the total strain, straight between points. The first part is elastic.
#[derive(Clone, Debug, PartialEq)]
pub struct HardeningCurve {
    points: Vec<CurvePoint>,
    tolerances: [f64; 2],
}

/// Tolerances over the smallest differences of strains and stresses.
const TOLERANCE: f64 = 1e-6;
/// Relative error of the energy of a scaled curve.
const ENERGY_TOLERANCE: f64 = 1e-3;
/// Least energy over that of the triangle up to the strength.
const LEAST_ENERGY: f64 = 1.01;
const MAX_ITERATIONS: usize = 10;

impl HardeningCurve {
    /// A curve of strains, stresses and damages, all without sign, for a modulus of elasticity. Points are moved where they
    /// contradict it. `None` if all strains or all stresses are zero.
    pub fn new(e: f64, strains: &[f64], stresses: &[f64], damages: &[f64]) -> Option<Self> {
        let mut points: Vec<CurvePoint> = strains
            .iter()
            .zip(stresses)
            .zip(damages)
            .map(|((x, y), d)| CurvePoint {
                strain: x.abs(),
                stress: y.abs(),
                damage: d.clamp(0.0, 1.0),
                effective: 0.0,
            })
            .collect();
        let most = |f: fn(&CurvePoint) -> f64| points.iter().map(f).fold(0.0, f64::max);
        let (x_max, y_max) = (most(|p| p.strain), most(|p| p.stress));
        if !(x_max > 0.0 && y_max > 0.0) {
            return None;
        }
        match points[0] {
            CurvePoint { strain: 0.0, .. } => points[0].stress = 0.0,
            CurvePoint { stress: 0.0, strain, .. } => points[0].stress = e * strain,
            _ => points.insert(0, CurvePoint::default()),
        }
        points[0].damage = 0.0;
        points.get_mut(1)?.stress = e * points.get(1)?.strain;
        let least = |most: f64, f: fn(&CurvePoint) -> f64| {
            let steps = points.windows(2).map(|p| (f(&p[1]) - f(&p[0])).abs()).filter(|d| *d > 0.0);
            steps.fold(most, f64::min)
        };
        let tolerances = [TOLERANCE * least(x_max, |p| p.strain), TOLERANCE * least(y_max, |p| p.stress)];
        let mut made = Self { points, tolerances };
        made.adjust();
        Some(made)
    }

    /// Mean of the smallest strain differences of two curves, for numerical derivatives.
    pub(super) fn perturbation(&self, other: &Self) -> f64 {
        0.5 * (self.tolerances[0] + other.tolerances[0])
    }

    /// Stress below which there is none.
    pub(super) fn stress_tolerance(&self) -> f64 {
        self.tolerances[1]
    }

    /// Largest stress.
    pub(super) fn strength(&self) -> f64 {
        self.points.iter().map(|p| p.stress).fold(0.0, f64::max)
    }

    fn modulus(&self) -> f64 {
        self.points[1].stress / self.points[1].strain
    }

    /// Makes strains rise, keeps slopes below the modulus, and keeps damage and plastic strain from falling.
    fn adjust(&mut self) {
        let (e, [x_tolerance, y_tolerance]) = (self.modulus(), self.tolerances);
        for i in 1..self.points.len() {
            let (old, p) = (self.points[i - 1], self.points[i]);
            let (mut x, mut y, mut d) = (p.strain, p.stress, p.damage);
            if x <= old.strain {
                x += x_tolerance;
            }
            y = y.max(y_tolerance);
            if (y - old.stress) / (x - old.strain) > e {
                y = old.stress + (x - old.strain) * e;
            }
            let plastic_old =
                if old.damage < 1.0 { old.strain - old.stress / ((1.0 - old.damage) * e) } else { old.strain };
            let plastic = if d < 1.0 { x - y / ((1.0 - d) * e) } else { -1.0 };
            if plastic < plastic_old {
                d = (1.0 - y / e / (x - plastic_old)).clamp(0.0, 1.0);
            }
            d = d.max(old.damage);
            let unloading = (1.0 - d) * e;
            if (y - old.stress) / (x - old.strain) > unloading {
                y = unloading * (x - plastic_old);
            }
            self.points[i] = CurvePoint { strain: x, stress: y, damage: d, effective: y / (1.0 - d) };
        }
    }

    /// Energy per volume of the softening, with the index of the point where it begins. `None` without softening.
    fn energy(&self) -> Option<(f64, usize)> {
        let slope = |i: usize| {
            let (p, q) = (self.points[i], self.points[i + 1]);
            (q.stress - p.stress) / (q.strain - p.strain)
        };
        let last = self.points.len() - 1;
        let begin = (0..last).find(|i| slope(*i) < 0.0)?;
        let end = (begin..last).find(|i| slope(*i) >= 0.0);
        let beyond = match (end, self.points[last]) {
            (None, p) if p.stress > 0.0 => 0.5 * p.stress * (-p.stress / slope(last - 1)),
            _ => 0.0,
        };
        let peak = self.points[begin];
        let elastic = 0.5 * peak.stress * peak.stress / ((1.0 - peak.damage) * self.modulus());
        let areas = self.points[begin..=end.unwrap_or(last)].windows(2);
        let area = areas.map(|p| 0.5 * (p[1].strain - p[0].strain) * (p[0].stress + p[1].stress)).sum::<f64>();
        Some((elastic + area + beyond, begin))
    }

    /// The curve whose softening has `scale` times its energy.
    pub(in crate::material) fn scaled(&self, scale: f64) -> Self {
        let Some((energy, begin)) = self.energy().filter(|_| scale > 0.0 && scale != 1.0) else { return self.clone() };
        let mut made = self.clone();
        let peak = self.points[begin];
        let wanted = (energy * scale).max(0.5 * LEAST_ENERGY * peak.stress * peak.strain);
        let (mut stretch, e) = (wanted / energy, self.modulus());
        for _ in 0..MAX_ITERATIONS {
            for p in &mut made.points[begin + 1..] {
                let inelastic = (p.strain - p.stress / e).max(0.0);
                let share = if inelastic > 0.0 { p.plastic(e) / inelastic } else { 0.0 };
                p.strain = peak.strain + (p.strain - peak.strain) * stretch;
                let inelastic = (p.strain - p.stress / e).max(0.0);
                p.effective = e * (p.strain - inelastic * share);
                if p.effective > 0.0 {
                    p.damage = 1.0 - p.stress / p.effective;
                }
            }
            made.adjust();
            let Some((energy, _)) = made.energy() else { break };
            if (energy - wanted).abs() < ENERGY_TOLERANCE * wanted {
                break;
            }
            stretch = wanted / energy;
        }
        made.adjust();
        made
    }

    /// The points on both sides of a total strain. Beyond the curve its last rise goes on.
    fn around(&self, x: f64) -> [CurvePoint; 2] {
        match self.points.windows(2).find(|p| x <= p[1].strain + self.tolerances[0]) {
            Some(pair) => [pair[0], pair[1]],
            None => {
                let last = self.points.len() - 1;
                let (before, p) = (self.points[last - 1], self.points[last]);
                let span = p.strain - before.strain;
                let beyond = |y: f64, old: f64| y + ((y - old) / span).max(0.0) * (x - p.strain);
                let stress = beyond(p.stress, before.stress);
                [p, CurvePoint { strain: x, stress, damage: 0.0, effective: beyond(p.effective, before.effective) }]
            }
        }
    }

    /// The point at a total strain.
    pub(in crate::material) fn at(&self, x: f64) -> CurvePoint {
        let ([p, q], least) = (self.around(x), self.tolerances[1]);
        let span = q.strain - p.strain;
        let share = if span > 0.0 { (x - p.strain) / span } else { 0.0 };
        let stress = (p.stress + (q.stress - p.stress) * share).max(least);
        let effective = (p.effective + (q.effective - p.effective) * share).max(least);
        CurvePoint { strain: x, stress, damage: 1.0 - stress / effective, effective }
    }

    /// Slope of the stress at a total strain.
    pub(in crate::material) fn slope(&self, x: f64) -> f64 {
        let [p, q] = self.around(x);
        let span = q.strain - p.strain;
        if span > 0.0 && self.at(x).stress > self.tolerances[1] { (q.stress - p.stress) / span } else { 0.0 }
    }
}
