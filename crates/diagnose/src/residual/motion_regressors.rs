//! Functions of the motion of devices that may describe a residual.

use crate::inspect::response::{ResponseHistory, ResponseRanges};
use crate::prior::{DEFORMATION_BUMPS, REGRESSION_DEVICES};

/// A series divided by its largest absolute value; samples that are not finite are 0.
fn normalised(v: Vec<f64>) -> Vec<f64> {
    let top = v.iter().filter(|x| x.is_finite()).fold(0.0f64, |m, x| m.max(x.abs())).max(f64::MIN_POSITIVE);
    v.into_iter().map(|x| if x.is_finite() { x / top } else { 0.0 }).collect()
}

/// Rate of deformation at each sample, by backward differences.
fn speeds(h: &ResponseHistory) -> Vec<f64> {
    let at = |i: usize| {
        if i == 0 { 0.0 } else { (h.deformation[i] - h.deformation[i - 1]) / (h.times[i] - h.times[i - 1]) }
    };
    (0..h.times.len()).map(at).collect()
}

/// Functions of a device's motion in two directions.
///
/// The first two are the components of the direction of the velocity, which friction and yielding follow. The others are the
/// force in each direction times the deformation in the other.
fn biaxial_regressors(one: &ResponseHistory, two: &ResponseHistory) -> [Vec<f64>; 4] {
    let (a, b) = (speeds(one), speeds(two));
    let along = |v: &[f64]| {
        let cosine = |((a, b), v): ((&f64, &f64), &f64)| if a.hypot(*b) > 0.0 { v / a.hypot(*b) } else { 0.0 };
        normalised(a.iter().zip(&b).zip(v).map(cosine).collect())
    };
    let force_at = |q: &ResponseHistory, e: &ResponseHistory| {
        normalised(q.force.iter().zip(&e.deformation).map(|(q, e)| q * e.abs()).collect())
    };
    [along(&a), along(&b), force_at(one, two), force_at(two, one)]
}

/// Polynomials of deformation e, force q, speed v, time t and largest past deformation m, the simplest first.
fn polynomials(e: &[f64], q: &[f64], v: &[f64]) -> Vec<Vec<f64>> {
    let n = e.len();
    let t: Vec<f64> = (0..n).map(|i| i as f64 / n as f64).collect();
    let largest_past = |largest: &mut f64, x: &f64| {
        *largest = largest.max(x.abs());
        Some(*largest)
    };
    let m: Vec<f64> = e.iter().scan(0.0f64, largest_past).collect();
    let each = |f: &dyn Fn(usize) -> f64| (0..n).map(f).collect::<Vec<f64>>();
    vec![
        e.to_vec(),
        q.to_vec(),
        v.to_vec(),
        each(&|i| e[i].powi(3)),
        each(&|i| q[i] * q[i].abs()),
        each(&|i| v[i].signum() * v[i].abs().sqrt()),
        each(&|i| e[i] * t[i]),
        each(&|i| q[i] * t[i]),
        each(&|i| e[i] * m[i]),
        each(&|i| q[i] * m[i]),
        each(&|i| e[i] * v[i].abs()),
        each(&|i| e[i] * e[i]),
        // Even in the motion.
        each(&|i| q[i] * e[i]),
        // A force that grows with the deformation in either sense.
        each(&|i| q[i] * e[i].abs()),
    ]
}

/// Gaussian bumps along a deformation, which describe any smooth function of it.
fn deformation_bumps(e: &[f64]) -> impl Iterator<Item = Vec<f64>> {
    let [low, high] = e.iter().fold([0.0f64; 2], |[a, b], x| [a.min(*x), b.max(*x)]);
    let width = (high - low) / DEFORMATION_BUMPS as f64;
    (0..DEFORMATION_BUMPS).map(move |b| {
        let at = low + (b as f64 + 0.5) * width;
        e.iter().map(|e| (-((e - at) / width).powi(2)).exp()).collect()
    })
}

/// Regressors of a run, each as long as its recording and at most one in size.
pub(super) fn motion_regressors(responses: &ResponseRanges, run: usize) -> Vec<Vec<f64>> {
    let (mut out, mut bumps): (Vec<Vec<f64>>, Vec<Vec<f64>>) = (vec![], vec![]);
    let of_run = responses.histories.iter().filter(|((r, _, _), _)| *r == run);
    let moving: Vec<_> = of_run.take(REGRESSION_DEVICES).collect();
    for (_, h) in &moving {
        let e = normalised(h.deformation.clone());
        out.extend(polynomials(&e, &normalised(h.force.clone()), &normalised(speeds(h))));
        bumps.extend(deformation_bumps(&e));
    }
    if let [((_, tag, _), one), ((_, other, _), two)] = moving[..]
        && tag == other
    {
        out.extend(biaxial_regressors(one, two));
    }
    out.extend(bumps);
    out
}

#[cfg(test)]
mod tests {
    use super::{motion_regressors, speeds};
    use crate::inspect::response::{ResponseHistory, ResponseRanges};
    use crate::residual::regression::explained_share;

    /// Friction in the plane acts against the velocity: its part along one axis depends on the other.
    #[test]
    fn a_device_in_the_plane_has_biaxial_regressors() {
        let times: Vec<f64> = (0..1200).map(|i| 0.01 * f64::from(i)).collect();
        let moving = |f: &dyn Fn(f64) -> f64| {
            let e: Vec<f64> = times.iter().map(|t| f(*t)).collect();
            ResponseHistory { times: times.clone(), force: e.clone(), deformation: e }
        };
        let (x, y) = (moving(&|t| (1.0 + 0.1 * t) * (3.0 * t).sin()), moving(&|t| 2.0 * (1.7 * t).sin()));
        let of = |other| {
            let histories = [((0, 1, 1), x.clone()), ((0, other, 2), y.clone())].into_iter().collect();
            motion_regressors(&ResponseRanges { histories, ..ResponseRanges::default() }, 0)
        };
        let (a, b) = (speeds(&x), speeds(&y));
        let friction: Vec<f64> = a.iter().zip(&b).map(|(a, b)| a / a.hypot(*b).max(f64::MIN_POSITIVE)).collect();
        assert_eq!(of(1).len(), of(2).len() + 4);
        let simple = |columns: Vec<Vec<f64>>| columns.into_iter().take(32).collect::<Vec<_>>();
        assert!(explained_share(&friction, &simple(of(1)), 6) > 0.99);
    }
}
