//! Points of a fiber section: strains from the deformations of the section, and sums over stresses and tangents.

use crate::numeric::lanes::{LANES, Lanes, in_lanes};

/// Coordinates and areas of the points, one quantity after the other.
#[derive(Clone, Debug, Default)]
pub(super) struct Points {
    /// Derivatives of the strain with respect to the curvatures κ_z and κ_y.
    gradients: [Vec<f64>; 2],
    areas: Vec<f64>,
}

/// Quantities of the points before and after a step, from which their work follows.
pub(super) struct Work<'a> {
    pub(super) strains: [&'a [f64]; 2],
    pub(super) stresses: [&'a [f64]; 2],
    /// Energies before and after.
    pub(super) energies: (&'a [f64], &'a mut [f64]),
}

/// Sums over the points of the stress times the area, and of the tangent times the area, with the derivatives of the
/// strain.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sums<const M: usize> {
    force: [f64; M],
    stiffness: [[f64; M]; M],
}

impl<const M: usize> Sums<M> {
    /// Writes the resultants and the tangent of a section with `n` resultants.
    pub(super) fn write(&self, n: usize, s: &mut [f64], k: &mut [f64]) {
        s[..M].copy_from_slice(&self.force);
        self.stiffness.iter().zip(k.chunks_exact_mut(n)).for_each(|(row, k)| k[..M].copy_from_slice(row));
    }
}

impl Points {
    pub(super) fn len(&self) -> usize {
        self.areas.len()
    }

    /// Adds a point; returns the new number of points.
    pub(super) fn push(&mut self, gradient: [f64; 2], area: f64) -> usize {
        self.gradients.iter_mut().zip(gradient).for_each(|(all, own)| all.push(own));
        self.areas.push(area);
        self.areas.len()
    }

    /// Adds an area to the last point.
    pub(super) fn enlarge(&mut self, area: f64) {
        self.areas.iter_mut().last().into_iter().for_each(|a| *a += area);
    }

    /// Strains for `M` deformations.
    pub(super) fn strains<const M: usize>(&self, e: &[f64], out: &mut [f64]) {
        let axial = e[0];
        let [y, z] = &self.gradients;
        let out = &mut out[..self.len()];
        if M == 2 {
            out.iter_mut().zip(y).for_each(|(out, y)| *out = axial + y * e[1]);
        } else {
            out.iter_mut().zip(y).zip(z).for_each(|((out, y), z)| *out = axial + y * e[1] + z * e[2]);
        }
    }

    /// Sums for stresses and tangents; writes the energies of the points.
    pub(super) fn integrate<const M: usize>(&self, tangent: &[f64], work: Work<'_>) -> Sums<M> {
        let mut summation = Summation::<M> { points: self, tangent, work, sums: [[0.0; LANES]; QUANTITIES] };
        in_lanes(&mut summation);
        let total = |q: usize| summation.sums[q].iter().sum::<f64>();
        let mut sums = Sums { force: [0.0; M], stiffness: [[0.0; M]; M] };
        let mut q = M;
        for i in 0..M {
            sums.force[i] = total(i);
            for j in 0..=i {
                (sums.stiffness[i][j], sums.stiffness[j][i]) = (total(q), total(q));
                q += 1;
            }
        }
        sums
    }
}

/// Sums in space: three resultants and six stiffnesses.
const QUANTITIES: usize = 9;

struct Summation<'a, const M: usize> {
    points: &'a Points,
    tangent: &'a [f64],
    work: Work<'a>,
    sums: [[f64; LANES]; QUANTITIES],
}

/// The next numbers of a slice, zeros after its end.
#[inline(always)]
fn next(slice: &[f64], start: usize) -> [f64; LANES] {
    match slice[start..].first_chunk::<LANES>() {
        Some(chunk) => *chunk,
        None => std::array::from_fn(|lane| slice.get(start + lane).copied().unwrap_or(0.0)),
    }
}

impl<const M: usize> Lanes for Summation<'_, M> {
    #[inline(always)]
    fn evaluate(&mut self) {
        let n = self.points.len();
        let [y, z] = &self.points.gradients;
        let mut sums = self.sums;
        for start in (0..n).step_by(LANES) {
            let [e0, e1] = self.work.strains.map(|s| next(s, start));
            let [s0, s1] = self.work.stresses.map(|s| next(s, start));
            let (area, tangent) = (next(&self.points.areas, start), next(self.tangent, start));
            let (y, z) = (next(y, start), if M == 3 { next(z, start) } else { [0.0; LANES] });
            let mut energy = next(self.work.energies.0, start);
            for lane in 0..LANES {
                energy[lane] += 0.5 * (s0[lane] + s1[lane]) * (e1[lane] - e0[lane]);
                let (force, stiffness) = (s1[lane] * area[lane], tangent[lane] * area[lane]);
                let (by_y, by_z) = (stiffness * y[lane], stiffness * z[lane]);
                sums[0][lane] += force;
                sums[1][lane] += force * y[lane];
                if M == 2 {
                    sums[2][lane] += stiffness;
                    sums[3][lane] += by_y;
                    sums[4][lane] += by_y * y[lane];
                } else {
                    sums[2][lane] += force * z[lane];
                    sums[3][lane] += stiffness;
                    sums[4][lane] += by_y;
                    sums[5][lane] += by_y * y[lane];
                    sums[6][lane] += by_z;
                    sums[7][lane] += by_z * y[lane];
                    sums[8][lane] += by_z * z[lane];
                }
            }
            let out = &mut self.work.energies.1[start..n];
            match out.first_chunk_mut::<LANES>() {
                Some(chunk) => *chunk = energy,
                None => out.iter_mut().zip(energy).for_each(|(out, energy)| *out = energy),
            }
        }
        self.sums = sums;
    }
}
