//! The displacement-based beam: `dispBeamColumn`.

use super::basic::Basic;
use super::elastic::{Bending, Release, add_clamped_load};
use super::member::{Formulation, Lacking, LoadSums, Member, bending_at, set};
use super::per_section::PerSection;
use crate::element::load::ElementLoad;
use crate::element::transform::Reactions;
use crate::element::{Class, ElementInput, ElementResult, Histories};
use crate::numeric::{axpy, invert, product};
use crate::section::{MAX_ORDER, Resultant};

/// A beam with cubic deflections and linear axial displacements: curvatures are linear, axial strain is constant.
#[derive(Clone, Copy, Debug)]
pub struct DisplacementBased;

/// Derivatives of the section deformation at `x` (fraction of the length) that is conjugate to a resultant, by the
/// basic deformations. There is no shear deformation.
pub(super) fn row<const B: usize>(resultant: Resultant, x: f64, length: f64) -> [f64; B] {
    let mut row = [0.0; B];
    match resultant {
        Resultant::P => row[0] = 1.0 / length,
        Resultant::T => set(&mut row, 5, 1.0 / length),
        Resultant::Mz | Resultant::My => {
            let at = bending_at(resultant).unwrap_or(1);
            set(&mut row, at, (6.0 * x - 4.0) / length);
            set(&mut row, at + 1, (6.0 * x - 2.0) / length);
        }
        Resultant::Vy | Resultant::Vz => {}
    }
    row
}

/// Interpolation of a section. `M` bounds the number of resultants, so that the sizes of all loops are known; the rows
/// beyond the resultants of the section are zero.
struct Interpolation<const B: usize, const M: usize> {
    rows: [[f64; B]; M],
}

impl<const B: usize, const M: usize> Interpolation<B, M> {
    fn new(resultants: &[Resultant], x: f64, length: f64) -> Self {
        let mut rows = [[0.0; B]; M];
        rows.iter_mut().zip(resultants).for_each(|(a, r)| *a = row(*r, x, length));
        Self { rows }
    }

    /// Adds wᵢ L aᵀ k a for the stiffness k of a section with `n` resultants, by rows.
    fn add_stiffness(&self, n: usize, k: &[f64], weight: f64, kb: &mut [[f64; B]; B]) {
        for (a, k) in self.rows.iter().zip(k.chunks_exact(n.max(1))) {
            // Resultant for each basic deformation.
            let mut per_deformation = [0.0; B];
            for (k, b) in k.iter().zip(&self.rows) {
                axpy(weight * k, b, &mut per_deformation);
            }
            kb.iter_mut().zip(a).for_each(|(row, a)| axpy(*a, &per_deformation, row));
        }
    }
}

impl DisplacementBased {
    /// [`Formulation::respond`] for sections of at most `M` resultants.
    fn respond_of_order<const N: usize, const B: usize, const M: usize>(
        member: &Member<N, B>,
        v: &[f64; B],
        motion: &ElementInput<'_>,
        h: &mut Histories<'_>,
    ) -> ElementResult<Basic<B>> {
        let mut basic = Basic { q: [0.0; B], k: [[0.0; B]; B] };
        basic.q.copy_from_slice(&motion.load[..B]);
        let interpolations: PerSection<Interpolation<B, M>> = member
            .along()
            .map(|(section, x, _)| Interpolation::new(section.resultants(), x, member.length()))
            .collect();
        let e = (&interpolations).into_iter().map(|of_section| product(&of_section.rows, v)).collect();
        member.update_sections(h, &e, motion.dt)?;
        for ((section, _, weight), interpolation) in member.along().zip(&interpolations) {
            for (row, s) in interpolation.rows.iter().zip(section.resultant(h.trial)) {
                axpy(weight * s, row, &mut basic.q);
            }
            interpolation.add_stiffness(section.order(), section.stiffness(h.trial), weight, &mut basic.k);
        }
        Ok(basic)
    }
}

impl<const N: usize, const B: usize> LoadSums<N, B> for DisplacementBased {
    fn load_len(_: usize) -> usize {
        B + 5
    }

    fn add_load(member: &Member<N, B>, load: &ElementLoad, factor: f64, sums: &mut [f64]) {
        let rigid = Bending { ei: 1.0, gav: None, release: Release::None };
        add_clamped_load::<B>(load, factor, &[rigid; 2], member.length(), sums);
    }

    fn reactions(load: &[f64]) -> Reactions {
        std::array::from_fn(|i| load[B + i])
    }
}

impl<const N: usize, const B: usize> Formulation<N, B> for DisplacementBased {
    type Loads = Self;
    const CLASS: [Class; 2] = [Class::new("DispBeamColumn2d", 62), Class::new("DispBeamColumn3d", 64)];
    const LACKING: Lacking = Lacking::Free;
    const DAMPABLE: bool = true;

    fn respond(
        &self,
        member: &Member<N, B>,
        v: &[f64; B],
        motion: &ElementInput<'_>,
        h: &mut Histories<'_>,
    ) -> ElementResult<Basic<B>> {
        match member.order() {
            ..=2 => Self::respond_of_order::<N, B, 2>(member, v, motion, h),
            3 => Self::respond_of_order::<N, B, 3>(member, v, motion, h),
            4 => Self::respond_of_order::<N, B, 4>(member, v, motion, h),
            _ => Self::respond_of_order::<N, B, MAX_ORDER>(member, v, motion, h),
        }
    }

    fn initial_stiffness(member: &Member<N, B>) -> [[f64; B]; B] {
        let mut kb = [[0.0; B]; B];
        for (section, x, weight) in member.along() {
            let n = section.resultants().len();
            let mut k = [0.0; MAX_ORDER * MAX_ORDER];
            section.section.initial_stiffness(&mut k[..n * n]);
            let interpolation = Interpolation::<B, MAX_ORDER>::new(section.resultants(), x, member.length());
            interpolation.add_stiffness(n, &k[..n * n], weight, &mut kb);
        }
        kb
    }

    fn elastic_deformation(member: &Member<N, B>, q: &[f64; B], _: &[f64]) -> [f64; B] {
        let mut f = <Self as Formulation<N, B>>::initial_stiffness(member);
        if !invert(f.as_flattened_mut(), B) {
            return [0.0; B];
        }
        product(&f, q)
    }
}
