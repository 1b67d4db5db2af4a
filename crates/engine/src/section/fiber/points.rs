//! Points of a fiber section: strains from the deformations of the section, and sums over stresses and tangents.

use crate::numeric::lanes::{BLOCK, LANES, Lanes, copy_back, in_lanes, load};

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

    /// Repeats the last point without an area so often that `n` become a multiple of `block`; returns the new number of
    /// points.
    pub(super) fn pad(&mut self, n: usize, block: usize) -> usize {
        for _ in n..n.next_multiple_of(block) {
            let gradient = std::array::from_fn(|i| self.gradients[i].last().copied().unwrap_or(0.0));
            self.push(gradient, 0.0);
        }
        self.len()
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

    /// Strain of a point for deformations.
    pub(super) fn strain(&self, i: usize, e: &[f64]) -> f64 {
        e[0] + self.gradients.iter().zip(&e[1..]).map(|(g, e)| g[i] * e).sum::<f64>()
    }

    /// Sums for stresses and tangents; writes the energies of the points.
    pub(super) fn integrate<const M: usize>(&self, tangent: &[f64], work: Work<'_>) -> Sums<M> {
        let mut summation = Summation::<M> { points: self, tangent, work, sums: [[0.0; BLOCK]; QUANTITIES] };
        in_lanes(&mut summation);
        let total = |q: usize| {
            let half: [f64; LANES] = std::array::from_fn(|i| summation.sums[q][i] + summation.sums[q][i + LANES]);
            (half[0] + half[1]) + (half[2] + half[3])
        };
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
    sums: [[f64; BLOCK]; QUANTITIES],
}

impl<const M: usize> Lanes for Summation<'_, M> {
    #[inline(always)]
    fn evaluate(&mut self) {
        let n = self.points.len();
        let [all_y, all_z] = &self.points.gradients;
        // On the stack, where the sums stay in registers.
        let mut sums = [[0.0; BLOCK]; QUANTITIES];
        for start in (0..n).step_by(BLOCK) {
            // No closures: they would be compiled without the instructions of the processor.
            let e0: [f64; BLOCK] = load(&self.work.strains[0][start..]);
            let e1: [f64; BLOCK] = load(&self.work.strains[1][start..]);
            let s0: [f64; BLOCK] = load(&self.work.stresses[0][start..]);
            let s1: [f64; BLOCK] = load(&self.work.stresses[1][start..]);
            let (area, tangent, y): ([f64; BLOCK], [f64; BLOCK], [f64; BLOCK]) =
                (load(&self.points.areas[start..]), load(&self.tangent[start..]), load(&all_y[start..]));
            let mut energy = load::<BLOCK>(&self.work.energies.0[start..]);
            for i in 0..BLOCK {
                energy[i] += 0.5 * (s0[i] + s1[i]) * (e1[i] - e0[i]);
            }
            copy_back(&energy, &mut self.work.energies.1[start..n]);
            // Each sum is a loop of its own, which is sure to become vector instructions.
            let (mut force, mut stiffness, mut by_y) = ([0.0; BLOCK], [0.0; BLOCK], [0.0; BLOCK]);
            for i in 0..BLOCK {
                force[i] = s1[i] * area[i];
                stiffness[i] = tangent[i] * area[i];
                by_y[i] = stiffness[i] * y[i];
            }
            add(&mut sums[0], &force);
            add_products(&mut sums[1], &force, &y);
            add(&mut sums[M], &stiffness);
            add(&mut sums[M + 1], &by_y);
            add_products(&mut sums[M + 2], &by_y, &y);
            if M == 3 {
                let z: [f64; BLOCK] = load(&all_z[start..]);
                let mut by_z = [0.0; BLOCK];
                for i in 0..BLOCK {
                    by_z[i] = stiffness[i] * z[i];
                }
                add_products(&mut sums[2], &force, &z);
                add(&mut sums[M + 3], &by_z);
                add_products(&mut sums[M + 4], &by_z, &y);
                add_products(&mut sums[M + 5], &by_z, &z);
            }
        }
        self.sums = sums;
    }
}

#[inline(always)]
fn add(sums: &mut [f64; BLOCK], x: &[f64; BLOCK]) {
    for i in 0..BLOCK {
        sums[i] += x[i];
    }
}

#[inline(always)]
fn add_products(sums: &mut [f64; BLOCK], x: &[f64; BLOCK], y: &[f64; BLOCK]) {
    for i in 0..BLOCK {
        sums[i] += x[i] * y[i];
    }
}
