//! Concrete with plasticity and damage in tension and compression (Petracca, Pelà, Rossi, Zaghi, Camata and Spacone, 2017,
//! Engineering Structures 138, 330-345, and 2022, OpenSees documentation): `ASDConcrete3D` without crack planes.

mod curve;

use super::simplified_j2::isotropic_stiffness;
use super::{Multiaxial, SOLID, SharedMultiaxial, Tangent, linear};
use crate::material::multiaxial::plain_methods::plain_methods;
use crate::material::{MaterialError, MaterialResult, MultiaxialResult};
use crate::numeric::axpy;
use crate::probe::{Probe, Response};
use crate::state_struct;
use crate::state_struct::StateStruct;
use curve::CurvePoint;
pub(in crate::material) use curve::{RESPONSES, ReachedPoints};
use nalgebra::{Matrix3, SymmetricEigen};
use std::sync::Arc;

pub use curve::HardeningCurve;

/// Explicit extrapolation of the equivalent strains (Oliver, Huespe and Cante, 2008).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extrapolation {
    /// Factor of the extrapolation.
    pub factor: f64,
    /// Largest error of the damage, and the shortest step over the first one for which it counts; `None` without a check.
    pub control: Option<[f64; 2]>,
}

/// Parameters of the concrete.
#[derive(Clone, Debug, PartialEq)]
pub struct AsdConcrete {
    /// Modulus of elasticity, stress.
    pub e: f64,
    /// Poisson's ratio.
    pub nu: f64,
    /// Mass per volume.
    pub rho: f64,
    /// Viscosity, time.
    pub eta: f64,
    /// Shape of the surface of failure in the deviatoric plane (Lubliner, Oliver, Oller and Oñate, 1989).
    pub kc: f64,
    /// Share of damage in tension that counts in compression.
    pub cross_damage: f64,
    /// Curve in tension.
    pub tension: HardeningCurve,
    /// Curve in compression.
    pub compression: HardeningCurve,
    /// Extrapolation; `None` for the implicit solution.
    pub extrapolation: Option<Extrapolation>,
    /// The tangent is that of differences; else the secant.
    pub tangent: bool,
    /// Length for which the curves hold, if their energy depends on the size of the element.
    pub reference_length: Option<f64>,
}

state_struct! {
    /// History of a point.
    pub(super) struct ConcreteState {
        /// Strain.
        strain: [f64; SOLID],
        /// Effective stress.
        effective: [f64; SOLID],
        /// Equivalent strains in tension and compression.
        equivalent: [f64; 2],
        /// Equivalent strains of the step before.
        before: [f64; 2],
        /// Time of the last step, and of the first one; both 0 before it.
        steps: [f64; 2],
        /// 1 after a step.
        begun: f64,
        /// Share of tension in the damage of compression, and the projection of stresses on tension.
        ratio: f64,
        projection: [[f64; SOLID]; SOLID],
        /// Nominal stress.
        stress: [f64; SOLID],
        /// Damage in tension and compression.
        damage: [f64; 2],
    }
}

/// Ratio of the biaxial to the uniaxial strength in compression.
const BIAXIAL: f64 = 1.16;
/// Largest number of iterations for principal stresses.
const MAX_ITERATIONS: usize = 1000;
/// Least ratio of the strengths in compression and tension.
const LEAST_RATIO: f64 = 5.0;

/// Principal stresses from the largest down, the projection on tension, and the parts of a stress.
struct Split {
    principal: [f64; 3],
    projection: Tangent<SOLID>,
    parts: [[f64; SOLID]; 2],
    ratio: f64,
}

impl AsdConcrete {
    fn elasticity(&self) -> Tangent<SOLID> {
        isotropic_stiffness(self.e / 3.0 / (1.0 - 2.0 * self.nu), 0.5 * self.e / (1.0 + self.nu))
    }

    /// Strength in compression over that in tension.
    fn strength_ratio(&self) -> f64 {
        LEAST_RATIO.max(self.compression.strength() / self.tension.strength())
    }

    /// Uniaxial stress that is equivalent to principal stresses.
    fn equivalent(&self, [s1, s2, s3]: [f64; 3]) -> f64 {
        let gamma = 3.0 * (1.0 - self.kc) / (2.0 * self.kc - 1.0);
        let alpha = (BIAXIAL - 1.0) / (2.0 * BIAXIAL - 1.0);
        let sum = s1 + s2 + s3;
        let p = sum / 3.0;
        let second = 0.5 * ((s1 - p).powi(2) + (s2 - p).powi(2) + (s3 - p).powi(2));
        let beta = self.strength_ratio() * (1.0 - alpha) - (1.0 + alpha);
        (alpha * sum + (3.0 * second).sqrt() + beta * s1.max(0.0) - gamma * (-s1).max(0.0)) / (1.0 - alpha)
    }

    fn split(&self, stress: &[f64; SOLID]) -> MaterialResult<Split> {
        let [s11, s22, s33, s12, s23, s31] = *stress;
        let matrix = Matrix3::new(s11, s12, s31, s12, s22, s23, s31, s23, s33);
        let eigen = SymmetricEigen::try_new(matrix, f64::EPSILON, MAX_ITERATIONS)
            .ok_or_else(|| MaterialError("ASDConcrete3D has no stress at these strains".into()))?;
        let mut order = [0, 1, 2];
        order.sort_by(|a, b| eigen.eigenvalues[*b].total_cmp(&eigen.eigenvalues[*a]));
        let principal = order.map(|i| eigen.eigenvalues[i]);
        // Projections on tension and compression; what is neither belongs to both by half.
        let mut projection = [[0.0; SOLID]; SOLID];
        (0..SOLID).for_each(|i| projection[i][i] = 0.5);
        for (i, s) in order.into_iter().zip(principal) {
            let v = eigen.eigenvectors.column(i);
            let dyad = [v[0] * v[0], v[1] * v[1], v[2] * v[2], v[0] * v[1], v[1] * v[2], v[0] * v[2]];
            let sign = if s > 0.0 {
                1.0
            } else if s < 0.0 {
                -1.0
            } else {
                0.0
            };
            for (row, a) in projection.iter_mut().zip(dyad) {
                for (j, (out, b)) in row.iter_mut().zip(dyad).enumerate() {
                    *out += 0.5 * sign * a * b * if j < 3 { 1.0 } else { 2.0 };
                }
            }
        }
        let weighted = principal.map(|s| if s > 0.0 { s * self.cross_damage } else { s });
        let sum: f64 = weighted.iter().map(|s| s.abs()).sum();
        let tension: f64 = weighted.iter().map(|s| s.max(0.0)).sum();
        let parts = Self::parts(&projection, stress);
        Ok(Split { principal, projection, parts, ratio: if sum > 0.0 { tension / sum } else { 0.0 } })
    }

    fn parts(projection: &Tangent<SOLID>, stress: &[f64; SOLID]) -> [[f64; SOLID]; 2] {
        let tension = linear(projection, stress);
        [tension, std::array::from_fn(|i| stress[i] - tension[i])]
    }

    /// New points on the curves, from committed ones and principal effective stresses.
    fn hardened(&self, mut points: [CurvePoint; 2], principal: [f64; 3], dt: f64) -> [CurvePoint; 2] {
        let ratio = self.strength_ratio();
        let tension =
            if principal[0] < self.tension.stress_tolerance() { 0.0 } else { self.equivalent(principal) / ratio };
        let compression = self.equivalent(principal.map(|s| s.min(0.0)));
        let [kept, new] =
            if dt > 0.0 && self.eta > 0.0 { [self.eta, dt].map(|t| t / (self.eta + dt)) } else { [0.0, 1.0] };
        let curves = [&self.tension, &self.compression];
        for ((point, curve), stress) in points.iter_mut().zip(curves).zip([tension, compression]) {
            let trial = stress / self.e + point.plastic(self.e);
            if trial > point.strain {
                *point = curve.at(kept * point.strain + new * trial);
            }
        }
        points
    }

    /// Stress and state for a strain. `explicit` extrapolates the equivalent strains.
    fn solve(&self, c: &ConcreteState, e: &[f64; SOLID], dt: f64, explicit: bool) -> MaterialResult<ConcreteState> {
        let mut next = ConcreteState { strain: *e, before: c.equivalent, begun: 1.0, ..*c };
        next.steps = if c.begun == 0.0 { [dt, dt] } else { [dt, c.steps[1]] };
        let step: [f64; SOLID] = std::array::from_fn(|i| e[i] - c.strain[i]);
        let elastic = linear(&self.elasticity(), &step);
        let effective: [f64; SOLID] = std::array::from_fn(|i| c.effective[i] + elastic[i]);
        let old = [self.tension.at(c.equivalent[0]), self.compression.at(c.equivalent[1])];
        let plastic = old.map(|p| p.plastic(self.e));
        let (mut points, split);
        if let Some(x) = self.extrapolation.filter(|_| explicit) {
            let last = if c.begun == 0.0 { dt } else { c.steps[0] };
            let factor = if last > 0.0 { dt / last * x.factor } else { 1.0 };
            let ahead = |i: usize| c.equivalent[i] + factor * (c.equivalent[i] - c.before[i]);
            points = [self.tension.at(ahead(0)), self.compression.at(ahead(1))];
            let parts = Self::parts(&c.projection, &effective);
            split = Split { principal: [0.0; 3], projection: c.projection, parts, ratio: c.ratio };
        } else {
            split = self.split(&effective)?;
            points = self.hardened(old, split.principal, dt);
        }
        next.equivalent = points.map(|p| p.strain);
        // Plastic correction of the effective stress.
        let corrected = |p: &CurvePoint, plastic: f64| {
            let trial = (p.strain - plastic) * self.e;
            if trial > 0.0 { 1.0 - p.effective / trial } else { 0.0 }
        };
        let mut lost = [corrected(&points[0], plastic[0]), corrected(&points[1], plastic[1])];
        let mixed = |tension: f64, compression: f64| 1.0 - (1.0 - compression) * (1.0 - split.ratio * tension);
        let across = self.compression.at(points[0].strain * self.strength_ratio());
        lost[1] = mixed(corrected(&across, across.plastic(self.e)), lost[1]);
        points[1].damage = mixed(across.damage, points[1].damage);
        next.damage = [0, 1].map(|i| points[i].damage + lost[i] - points[i].damage * lost[i]);
        let sum = |lost: [f64; 2]| {
            let mut out = [0.0; SOLID];
            split.parts.iter().zip(lost).for_each(|(part, lost)| axpy(1.0 - lost, part, &mut out));
            out
        };
        (next.effective, next.stress) = (sum(lost), sum(next.damage));
        (next.projection, next.ratio) = (split.projection, split.ratio);
        Ok(next)
    }

    /// Derivatives of the stresses with the damage of a state.
    fn secant(&self, s: &ConcreteState) -> Tangent<SOLID> {
        let elastic = self.elasticity();
        std::array::from_fn(|i| {
            let mut row = [0.0; SOLID];
            for (j, stiffness) in elastic.iter().enumerate() {
                let whole = if i == j { 1.0 - s.damage[1] } else { 0.0 };
                axpy(whole - (s.damage[0] - s.damage[1]) * s.projection[i][j], stiffness, &mut row);
            }
            row
        })
    }

    fn numerical(
        &self,
        c: &ConcreteState,
        e: &[f64; SOLID],
        dt: f64,
        stress: &[f64; SOLID],
    ) -> MaterialResult<Tangent<SOLID>> {
        let step = self.tension.perturbation(&self.compression);
        let mut tangent = [[0.0; SOLID]; SOLID];
        for j in 0..SOLID {
            let mut moved = *e;
            moved[j] += step;
            let there = self.solve(c, &moved, dt, false)?.stress;
            (0..SOLID).for_each(|i| tangent[i][j] = (there[i] - stress[i]) / step);
        }
        Ok(tangent)
    }
}

crate::watches_columns!(AsdConcrete => nothing);

impl Multiaxial<SOLID> for AsdConcrete {
    plain_methods! { SOLID: reinforcement }
    fn state_len(&self) -> usize {
        ConcreteState::LEN
    }
    fn init(&self, state: &mut [f64]) {
        let mut virgin = ConcreteState::default();
        (0..SOLID).for_each(|i| virgin.projection[i][i] = 0.5);
        virgin.write(state);
    }
    fn is_linear(&self) -> bool {
        false
    }
    fn is_symmetric(&self) -> bool {
        false
    }
    fn depends_on_time(&self) -> bool {
        self.eta > 0.0 || self.extrapolation.is_some()
    }
    fn density(&self) -> f64 {
        self.rho
    }

    fn update(&self, committed: &[f64], e: &[f64; SOLID], dt: f64, next: &mut [f64]) -> MultiaxialResult<SOLID> {
        let c = ConcreteState::read(committed);
        let implicit = self.solve(&c, e, dt, false)?;
        implicit.write(next);
        let Some(x) = self.extrapolation else {
            let tangent =
                if self.tangent { self.numerical(&c, e, dt, &implicit.stress)? } else { self.secant(&implicit) };
            return Ok((implicit.stress, tangent));
        };
        let explicit = self.solve(&c, e, dt, true)?;
        if let Some([tolerance, least]) = x.control {
            let error = (0..2).map(|i| (explicit.damage[i] - implicit.damage[i]).abs()).fold(0.0, f64::max);
            if error > tolerance && dt >= least * implicit.steps[1] {
                return Err(MaterialError(format!(
                    "the extrapolated damage of ASDConcrete3D has an error of {error:.3}"
                )));
            }
        }
        Ok((explicit.stress, self.secant(&explicit)))
    }

    fn initial_tangent(&self) -> Tangent<SOLID> {
        self.elasticity()
    }

    fn shown_stress(&self, next: &[f64], _: [f64; SOLID]) -> [f64; SOLID] {
        ConcreteState::read(next).stress
    }

    fn of_length(&self, length: f64) -> Option<SharedMultiaxial<SOLID>> {
        let scale = self.reference_length? / length;
        let (tension, compression) = (self.tension.scaled(scale), self.compression.scaled(scale));
        Some(Arc::new(Self { tension, compression, reference_length: None, ..self.clone() }))
    }

    fn probe(&self, words: &[&str]) -> Option<Probe> {
        Response::find(&RESPONSES, &words.first()?.to_lowercase())
    }

    fn read(&self, path: &[u32], state: &[f64], out: &mut [f64]) {
        let [x, y] = ConcreteState::read(state).equivalent;
        let points = [self.tension.at(x), self.compression.at(y)];
        Response::read(&RESPONSES, path[0], &ReachedPoints { e: self.e, equivalent: [x, y], points }, &(), out);
    }
}
