//! Points of a fiber section: strains from the deformations of the section, and sums over stresses and tangents.

use crate::numeric::lanes::{BLOCK, LANES, Lanes, in_lanes};

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
        let e = std::array::from_fn(|i| e[i]);
        in_lanes(&mut PlaneStrains::<M> { points: self, e, out });
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

/// Strains of a plane section.
struct PlaneStrains<'a, const M: usize> {
    points: &'a Points,
    e: [f64; M],
    out: &'a mut [f64],
}

impl<const M: usize> Lanes for PlaneStrains<'_, M> {
    #[inline(always)]
    fn evaluate(&mut self) {
        let ((out, _), e, [all_y, all_z]) = (self.out.as_chunks_mut::<BLOCK>(), self.e, &self.points.gradients);
        let ((y, _), (z, _)) = (all_y.as_chunks::<BLOCK>(), all_z.as_chunks::<BLOCK>());
        for ((out, y), z) in out.iter_mut().zip(y).zip(z) {
            let (y, z) = (*y, *z);
            let mut own = [0.0; BLOCK];
            for i in 0..BLOCK {
                own[i] = e[0] + y[i] * e[1];
            }
            if M == 3 {
                for i in 0..BLOCK {
                    own[i] += z[i] * e[M - 1];
                }
            }
            *out = own;
        }
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
        self.add_work();
        if M == 3 {
            // The sums of half a block stay in the registers of every processor.
            self.add_up::<LANES>(0);
            self.add_up::<LANES>(LANES);
        } else {
            self.add_up::<BLOCK>(0);
        }
    }
}

impl<const M: usize> Summation<'_, M> {
    /// Writes the energies after the step.
    #[inline(always)]
    fn add_work(&mut self) {
        let ([e0, e1], [s0, s1]) = (self.work.strains, self.work.stresses);
        let ((e0, _), (e1, _)) = (e0.as_chunks::<BLOCK>(), e1.as_chunks::<BLOCK>());
        let ((s0, _), (s1, _)) = (s0.as_chunks::<BLOCK>(), s1.as_chunks::<BLOCK>());
        let ((before, _), (after, _)) =
            (self.work.energies.0.as_chunks::<BLOCK>(), self.work.energies.1.as_chunks_mut::<BLOCK>());
        for (((((after, before), e0), e1), s0), s1) in after.iter_mut().zip(before).zip(e0).zip(e1).zip(s0).zip(s1) {
            let (mut energy, e0, e1, s0, s1) = (*before, *e0, *e1, *s0, *s1);
            for i in 0..BLOCK {
                energy[i] += 0.5 * (s0[i] + s1[i]) * (e1[i] - e0[i]);
            }
            *after = energy;
        }
    }

    /// Adds up `W` numbers of each block from `first` on. The points fill whole blocks.
    #[inline(always)]
    fn add_up<const W: usize>(&mut self, first: usize) {
        let blocks = self.points.len() / BLOCK;
        let [all_y, all_z] = &self.points.gradients;
        let (s1, _) = self.work.stresses[1].as_chunks::<BLOCK>();
        let (tangent, _) = self.tangent.as_chunks::<BLOCK>();
        let (area, _) = self.points.areas.as_chunks::<BLOCK>();
        let ((y, _), (z, _)) = (all_y.as_chunks::<BLOCK>(), all_z.as_chunks::<BLOCK>());
        let (s1, tangent, area, y, z) =
            (&s1[..blocks], &tangent[..blocks], &area[..blocks], &y[..blocks], &z[..blocks]);
        // On the stack, where the sums stay in registers.
        let mut sums = [[0.0; W]; QUANTITIES];
        for block in 0..blocks {
            let (s1, tangent) = (part::<W>(&s1[block], first), part::<W>(&tangent[block], first));
            let (area, y) = (part::<W>(&area[block], first), part::<W>(&y[block], first));
            // Each sum is a loop of its own, which is sure to become vector instructions.
            let (mut force, mut stiffness, mut by_y) = ([0.0; W], [0.0; W], [0.0; W]);
            for i in 0..W {
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
                let z = part::<W>(&z[block], first);
                let mut by_z = [0.0; W];
                for i in 0..W {
                    by_z[i] = stiffness[i] * z[i];
                }
                add_products(&mut sums[2], &force, &z);
                add(&mut sums[M + 3], &by_z);
                add_products(&mut sums[M + 4], &by_z, &y);
                add_products(&mut sums[M + 5], &by_z, &z);
            }
        }
        for (all, own) in self.sums.iter_mut().zip(&sums) {
            all[first..first + W].copy_from_slice(own);
        }
    }
}

/// `W` numbers of a block.
#[inline(always)]
fn part<const W: usize>(block: &[f64; BLOCK], first: usize) -> [f64; W] {
    let mut out = [0.0; W];
    out.copy_from_slice(&block[first..first + W]);
    out
}

#[inline(always)]
fn add<const W: usize>(sums: &mut [f64; W], x: &[f64; W]) {
    for i in 0..W {
        sums[i] += x[i];
    }
}

#[inline(always)]
fn add_products<const W: usize>(sums: &mut [f64; W], x: &[f64; W], y: &[f64; W]) {
    for i in 0..W {
        sums[i] += x[i] * y[i];
    }
}
