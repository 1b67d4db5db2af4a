//! Concrete with plasticity and damage in tension and compression, for one stress (Petracca, 2023, OpenSees documentation
//! of `ASDConcrete1D`, after Petracca and others, 2017).

use crate::material::multiaxial::{CONCRETE_RESPONSES, Extrapolation, HardeningCurve, ReachedPoints};
use crate::material::{CHARACTERISTIC_LENGTH, MaterialError, MaterialResult, Strain, Stress, UniaxialLaw, finite};
use crate::probe::{Probe, Response};

/// Parameters of the concrete.
#[derive(Clone, Debug, PartialEq)]
pub struct AsdConcrete1d {
    /// Modulus of elasticity.
    pub e: f64,
    /// Viscosity, time.
    pub eta: f64,
    /// Curves in tension and in compression.
    pub curves: [HardeningCurve; 2],
    /// Extrapolation; `None` for the implicit solution.
    pub extrapolation: Option<Extrapolation>,
    /// The tangent is the consistent one; else the secant.
    pub tangent: bool,
    /// Length for which the curves hold, if their energy depends on the length of the element.
    pub reference_length: Option<f64>,
}

crate::state_struct! {
    /// History of [`AsdConcrete1d`].
    pub struct History {
        /// Strain.
        strain: f64,
        /// Effective stress.
        effective: f64,
        /// Equivalent strains in tension and compression.
        equivalent: [f64; 2],
        /// Equivalent strains of the step before.
        before: [f64; 2],
        /// Time of the last step, and of the first one.
        steps: [f64; 2],
        /// 1 after a step.
        begun: f64,
        /// Share of tension, less 0.5.
        sign: f64,
        /// Nominal stress.
        stress: f64,
        /// Damage in tension and compression.
        damage: [f64; 2],
    }
}

impl AsdConcrete1d {
    /// State at the end of a step, and the rates of the equivalent strains with the strain. `explicit` extrapolates the
    /// equivalent strains.
    fn solve(&self, c: &History, e: f64, dt: f64, explicit: Option<Extrapolation>) -> (History, f64) {
        let mut t = History { strain: e, before: c.equivalent, begun: 1.0, ..*c };
        t.steps = if c.begun == 0.0 { [dt, dt] } else { [dt, c.steps[1]] };
        let trial = c.effective + self.e * (e - c.strain);
        t.sign = match explicit {
            Some(_) => c.sign,
            None if trial > 0.0 => 0.5,
            None if trial < 0.0 => -0.5,
            None => 0.0,
        };
        let shares = [0.5 + t.sign, 0.5 - t.sign];
        let [kept, new] =
            if dt > 0.0 && self.eta > 0.0 { [self.eta, dt].map(|x| x / (self.eta + dt)) } else { [0.0, 1.0] };
        let (mut stress, mut effective, mut tangent) = (0.0, 0.0, 0.0);
        for (i, direction) in [1.0, -1.0].into_iter().enumerate() {
            let curve = &self.curves[i];
            let part = shares[i] * trial;
            let old = curve.at(c.equivalent[i]);
            let plastic = old.plastic(self.e);
            let mut rate = 0.0;
            let x = match explicit {
                Some(extrapolation) => {
                    let last = if c.begun == 0.0 { dt } else { c.steps[0] };
                    let factor = if last > 0.0 { dt / last * extrapolation.factor } else { 1.0 };
                    c.equivalent[i] + factor * (c.equivalent[i] - c.before[i])
                }
                None => {
                    let wanted = direction * part / self.e + plastic;
                    if wanted > old.strain {
                        rate = new * direction * shares[i];
                        kept * old.strain + new * wanted
                    } else {
                        old.strain
                    }
                }
            };
            let point = curve.at(x);
            t.equivalent[i] = x;
            let elastic = (x - plastic) * self.e;
            // The stress is the part of the trial stress times the ratio of the curve to the elastic stress.
            let ratio = |value: f64| if elastic > 0.0 { value / elastic } else { value / point.effective };
            let nominal = ratio(point.stress);
            t.damage[i] = 1.0 - nominal;
            stress += nominal * part;
            effective += ratio(point.effective) * part;
            tangent += nominal * self.e * shares[i];
            if rate != 0.0 && self.tangent {
                let steeper = (curve.slope(x) - nominal * self.e) / elastic;
                tangent += steeper * rate * part;
            }
        }
        (t.stress, t.effective) = (stress, effective);
        (t, tangent)
    }
}

impl UniaxialLaw for AsdConcrete1d {
    type State = History;
    const NAME: &'static str = "ASDConcrete1D";

    fn update(&self, c: &History, strain: Strain) -> MaterialResult<(Stress, History)> {
        let (implicit, tangent) = self.solve(c, strain.value, strain.dt, None);
        let Some(extrapolation) = self.extrapolation else {
            return finite(Self::NAME, strain.value, implicit.stress, tangent, implicit);
        };
        let (explicit, tangent) = self.solve(c, strain.value, strain.dt, Some(extrapolation));
        if let Some([tolerance, least]) = extrapolation.control {
            let error = (0..2).map(|i| (explicit.damage[i] - implicit.damage[i]).abs()).fold(0.0, f64::max);
            if error > tolerance && strain.dt >= least * implicit.steps[1] {
                return Err(MaterialError(format!(
                    "the extrapolated damage of ASDConcrete1D has an error of {error:.3}"
                )));
            }
        }
        finite(Self::NAME, strain.value, explicit.stress, tangent, implicit)
    }

    fn initial_tangent(&self) -> f64 {
        self.e
    }

    fn depends_on_time(&self) -> bool {
        self.eta > 0.0 || self.extrapolation.is_some()
    }

    /// The length of localisation scales the energy of the curves, once.
    fn set_parameter(&mut self, name: &str, value: f64) -> Option<f64> {
        if name != CHARACTERISTIC_LENGTH {
            return None;
        }
        let reference = self.reference_length.take()?;
        if value > 0.0 {
            self.curves = self.curves.each_ref().map(|curve| curve.scaled(reference / value));
        }
        Some(reference)
    }

    fn probe(&self, words: &[&str]) -> Option<Probe> {
        Response::find(&CONCRETE_RESPONSES, &words.first()?.to_lowercase())
    }

    fn read(&self, path: &[u32], s: &History, out: &mut [f64]) {
        let points = [self.curves[0].at(s.equivalent[0]), self.curves[1].at(s.equivalent[1])];
        Response::read(
            &CONCRETE_RESPONSES,
            path[0],
            &ReachedPoints { e: self.e, equivalent: s.equivalent, points },
            &(),
            out,
        );
    }
}

/// Fracture energies of tension (MC 2010) and compression per area, in MPa and mm.
fn fracture_energies(fc: f64, ft: f64) -> [f64; 2] {
    let tension = 0.073 * fc.powf(0.18);
    [tension, 2.0 * tension * (fc * fc) / (ft * ft)]
}

/// Damages of points (strain, stress) with plastic strains.
fn damages(e: f64, strains: &[f64], stresses: &[f64], plastic: &[f64]) -> Vec<f64> {
    let points = strains.iter().zip(stresses).zip(plastic);
    points.map(|((x, y), p)| if *p == 0.0 { 0.0 } else { 1.0 - y / ((x - p.min(x - y / e)) * e) }).collect()
}

/// A point of Bézier's parabola through three points (strain, stress).
fn parabola(x: f64, from: [f64; 2], mut by: [f64; 2], to: [f64; 2]) -> f64 {
    let bend = |by: f64| from[0] - 2.0 * by + to[0];
    if bend(by[0]).abs() < 1e-12 {
        by[0] += 1e-6 * (to[0] - from[0]);
    }
    let (a, b) = (bend(by[0]), 2.0 * (by[0] - from[0]));
    if a == 0.0 {
        return 0.0;
    }
    let t = ((b * b - 4.0 * a * (from[0] - x)).sqrt() - b) / (2.0 * a);
    (from[1] - 2.0 * by[1] + to[1]) * t * t + 2.0 * (by[1] - from[1]) * t + from[1]
}

/// Points of the rise in compression from half of the strength on.
const RISE: usize = 9;

impl AsdConcrete1d {
    /// Curves of concrete by its strengths in compression and tension, in MPa and mm, for a length of localisation. Without a
    /// length, that where neither curve snaps back at a hundredth of its energy.
    ///
    /// `None` if the numbers make no curve.
    pub fn curves_of_strength(e: f64, fc: f64, ft: f64, length: Option<f64>) -> Option<[HardeningCurve; 2]> {
        let [gt, gc] = fracture_energies(fc, ft);
        let (ec, ec1) = (2.0 * fc / e, fc / e);
        let first = 0.5 * fc * (ec - ((ec - ec1) * 0.4 + ec1));
        let length = length.unwrap_or_else(|| (0.01 * gc / first).min(0.01 * gt / (0.5 * ft * (ft / e))));
        // Tension: softening in two parts.
        let (e1, width) = (1.5 * ft / e, gt / length / ft);
        let permanent = e1 - ft / e;
        let [f2, f3] = [0.2 * ft, 1e-3 * ft];
        let after = |x: f64, last: f64| if x <= last { 1.001 * last } else { x };
        let e2 = after(width + f2 / e + permanent, e1);
        let e3 = after(5.0 * width + f3 / e + permanent, e2);
        let strains = [0.0, 0.9 * ft / e, e1, e2, e3, 10.0 * e3];
        let stresses = [0.0, 0.9 * ft, ft, f2, f3, f3];
        let plastic = [0.0, 0.0, permanent, 0.9 * e2, 0.8 * e3, 0.8 * e3];
        let tension = HardeningCurve::new(e, &strains, &stresses, &damages(e, &strains, &stresses, &plastic))?;
        // Compression: a parabola to the strength, then a straight line.
        let (half, ec0, rest) = (0.5 * fc, 0.5 * fc / e, 0.1 * fc);
        let (mut strains, mut stresses, mut plastic) = (vec![0.0, ec0], vec![0.0, half], vec![0.0, 0.0]);
        for i in 1..=RISE {
            let x = ec0 + i as f64 * ((ec - ec0) / RISE as f64);
            strains.push(x);
            stresses.push(parabola(x, [ec0, half], [ec1, fc], [ec, fc]));
            plastic.push(plastic[i] + 0.7 * (x - plastic[i]));
        }
        let end = ec + 2.0 * (0.01 * first).max(gc / length - first) / (fc + rest);
        let last = plastic[RISE + 1];
        let last = last + 0.7 * (end - last);
        strains.extend([end, end + ec0]);
        stresses.extend([rest, rest]);
        plastic.extend([last, last]);
        let compression = HardeningCurve::new(e, &strains, &stresses, &damages(e, &strains, &stresses, &plastic))?;
        Some([tension, compression])
    }
}
