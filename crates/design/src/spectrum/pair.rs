//! Spectra of pairs of horizontal components over all directions.
//!
//! RotD: Boore (2010), Orientation-independent, nongeometric-mean measures of seismic intensity from two horizontal
//! components of motion, Bulletin of the Seismological Society of America 100(4). GMRotI50: Boore, Watson-Lamprey and
//! Abrahamson (2006), 96(4A).

use super::{Oscillator, pseudo_acceleration};
use crate::motion::Pair;

/// Directions in 180 degrees.
const DIRECTIONS: usize = 180;

/// Combination of two components to one spectrum.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Combination {
    /// Median over the directions.
    RotD50,
    /// Largest over the directions.
    RotD100,
    /// Square root of the sum of the squares of the components' spectra.
    Srss,
    /// Geometric mean of the components' spectra.
    GeometricMean,
    /// The larger of the components' spectra at each period.
    Larger,
}

impl Combination {
    /// All of them with their names.
    pub const ALL: [(&'static str, Self); 5] = [
        ("rotd50", Self::RotD50),
        ("rotd100", Self::RotD100),
        ("srss", Self::Srss),
        ("geomean", Self::GeometricMean),
        ("larger", Self::Larger),
    ];
}

/// Pseudo-accelerations in m/s² of a pair.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PairSpectrum {
    /// Periods in s.
    pub periods: Vec<f64>,
    /// Spectra of the components.
    pub components: [Vec<f64>; 2],
    /// Median over all directions.
    pub rot_d50: Vec<f64>,
    /// Largest over all directions.
    pub rot_d100: Vec<f64>,
    /// Direction of the largest in degrees from the first component towards the second, from 0 to 179.
    pub direction: Vec<f64>,
}

/// Corners of the convex hull of points (Andrew's monotone chain): they alone decide the largest value in a direction.
fn hull(mut points: Vec<(f64, f64)>) -> Vec<(f64, f64)> {
    points.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
    points.dedup();
    let turn = |o: (f64, f64), a: (f64, f64), b: (f64, f64)| (a.0 - o.0) * (b.1 - o.1) - (a.1 - o.1) * (b.0 - o.0);
    let chain = |points: &mut dyn Iterator<Item = (f64, f64)>| {
        let mut out: Vec<(f64, f64)> = vec![];
        for p in points {
            while out.len() > 1 && turn(out[out.len() - 2], out[out.len() - 1], p) <= 0.0 {
                out.pop();
            }
            out.push(p);
        }
        out
    };
    let mut all = chain(&mut points.iter().copied());
    all.extend(chain(&mut points.iter().rev().copied()));
    all
}

/// Largest displacements in each of the directions from 0 to 179 degrees.
fn over_directions(pair: &Pair, oscillator: Oscillator) -> Vec<f64> {
    let [x, y] = pair.components.each_ref().map(|m| oscillator.displacements(m.dt, &m.acceleration));
    let corners = hull(x.into_iter().zip(y).collect());
    let largest = |k: usize| {
        let (s, c) = (k as f64).to_radians().sin_cos();
        corners.iter().fold(0.0f64, |m, p| m.max((c * p.0 + s * p.1).abs()))
    };
    (0..DIRECTIONS).map(largest).collect()
}

/// Median of values.
pub(crate) fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    let n = values.len();
    if n == 0 { f64::NAN } else { 0.5 * (values[(n - 1) / 2] + values[n / 2]) }
}

impl PairSpectrum {
    /// The spectra of a pair for a share of critical damping from 0 to less than 1, from steps of 1/100 of each period.
    pub fn new(pair: &Pair, periods: &[f64], damping: f64) -> Self {
        let mut out = Self { periods: periods.to_vec(), ..Self::default() };
        for &period in periods {
            let all = over_directions(pair, Oscillator { period, damping });
            let acceleration = |u: f64| pseudo_acceleration(period, u);
            out.components[0].push(acceleration(all[0]));
            out.components[1].push(acceleration(all[90]));
            let (direction, top) =
                all.iter().enumerate().fold((0, 0.0), |m, (k, u)| if *u > m.1 { (k, *u) } else { m });
            out.rot_d100.push(acceleration(top));
            out.direction.push(direction as f64);
            out.rot_d50.push(acceleration(median(all)));
        }
        out
    }

    /// The spectrum of a combination of the components.
    pub fn combined(&self, how: Combination) -> Vec<f64> {
        let both = |f: &dyn Fn(f64, f64) -> f64| {
            self.components[0].iter().zip(&self.components[1]).map(|(x, y)| f(*x, *y)).collect()
        };
        match how {
            Combination::RotD50 => self.rot_d50.clone(),
            Combination::RotD100 => self.rot_d100.clone(),
            Combination::Srss => both(&f64::hypot),
            Combination::GeometricMean => both(&|x, y| (x * y).sqrt()),
            Combination::Larger => both(&f64::max),
        }
    }
}

/// GMRotI50: geometric means at the one angle in degrees from 0 to 89 that is nearest to the median over all angles at all
/// periods, and that angle.
pub fn gm_rot_i(pair: &Pair, periods: &[f64], damping: f64) -> (Vec<f64>, f64) {
    let means: Vec<Vec<f64>> = periods
        .iter()
        .map(|&period| {
            let all = over_directions(pair, Oscillator { period, damping });
            let mean = |k: usize| pseudo_acceleration(period, (all[k] * all[k + 90]).sqrt());
            (0..90).map(mean).collect()
        })
        .collect();
    let medians: Vec<f64> = means.iter().map(|m| median(m.clone())).collect();
    let penalty = |k: usize| -> f64 {
        means.iter().zip(&medians).filter(|(_, d)| **d > 0.0).map(|(m, d)| (m[k] / d - 1.0).powi(2)).sum()
    };
    let best = (0..90).min_by(|a, b| penalty(*a).total_cmp(&penalty(*b))).unwrap_or(0);
    (means.iter().map(|m| m[best]).collect(), best as f64)
}

#[cfg(test)]
mod tests {
    use super::{Combination, PairSpectrum, gm_rot_i, median};
    use crate::motion::{Motion, Pair};
    use crate::spectrum::Oscillator;

    fn noise(seed: f64, n: usize) -> Vec<f64> {
        let value = |i: usize| ((i as f64 * 12.9898 + seed).sin() * 43758.5453).fract();
        (0..n).map(|i| value(i) * (-((i as f64 - 150.0) / 80.0).powi(2)).exp()).collect()
    }

    fn pair() -> Pair {
        let motion =
            |acceleration| Motion { name: "m".into(), title: String::new(), azimuth: None, dt: 0.02, acceleration };
        Pair::new(motion(noise(1.0, 400)), motion(noise(2.5, 380))).expect("a pair")
    }

    /// Every direction by turning the motion first.
    #[test]
    fn directions_are_those_of_turned_motions() {
        let (pair, periods) = (pair(), [0.05, 0.31, 1.7]);
        let s = PairSpectrum::new(&pair, &periods, 0.05);
        for (i, &period) in periods.iter().enumerate() {
            let o = Oscillator { period, damping: 0.05 };
            let all: Vec<f64> = (0..180)
                .map(|k| {
                    let turned = pair.at_angle(f64::from(k));
                    let u = o.displacements(turned.dt, &turned.acceleration);
                    o.omega().powi(2) * u.iter().fold(0.0f64, |m, u| m.max(u.abs()))
                })
                .collect();
            let top = all.iter().copied().fold(0.0, f64::max);
            assert!((s.rot_d100[i] / top - 1.0).abs() < 1e-9);
            assert!((all[s.direction[i] as usize] / top - 1.0).abs() < 1e-9);
            assert!((s.rot_d50[i] / median(all.clone()) - 1.0).abs() < 1e-9);
            assert!((s.components[1][i] / all[90] - 1.0).abs() < 1e-9);
            let means: Vec<f64> = (0..90).map(|k| (all[k] * all[k + 90]).sqrt()).collect();
            let (gm, angle) = gm_rot_i(&pair, &[period], 0.05);
            assert!((gm[0] / means[angle as usize] - 1.0).abs() < 1e-9);
            let near = means.iter().map(|m| (m - median(means.clone())).abs()).fold(f64::INFINITY, f64::min);
            assert!((gm[0] - median(means.clone())).abs() <= near + 1e-12);
        }
        let srss = s.combined(Combination::Srss);
        assert!(srss.iter().zip(&s.rot_d100).all(|(a, b)| a >= b));
    }

    #[test]
    fn one_component_alone_is_polarised() {
        let mut p = pair();
        p.components[1].acceleration.iter_mut().for_each(|a| *a = 0.0);
        let s = PairSpectrum::new(&p, &[0.5], 0.05);
        assert_eq!(s.direction[0], 0.0);
        // The median of |cos| is cos 45°, between the directions 44.5 and 45.5 that bound it.
        assert!((s.rot_d50[0] / s.rot_d100[0] - 45f64.to_radians().cos()).abs() < 0.01);
    }
}
