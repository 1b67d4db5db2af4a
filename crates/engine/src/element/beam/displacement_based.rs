//! The displacement-based beam: `dispBeamColumn`.

use super::elastic::{Bending, Release, add_clamped_load};
use super::member::{Basic, Formulation, Member, bending_at, set};
use crate::element::load::ElementLoad;
use crate::element::transform::Reactions;
use crate::element::{ElementError, ElementInput};
use crate::numeric::{dot, invert};
use crate::section::{MAX_ORDER, Resultant};

/// A beam with cubic deflections and linear axial displacements: curvatures are linear, axial strain is constant.
#[derive(Clone, Copy, Debug)]
pub struct DisplacementBased;

/// Derivatives of the section deformation at `x` (fraction of the length) that is conjugate to a resultant, by the
/// basic deformations. There is no shear deformation.
fn row<const B: usize>(resultant: Resultant, x: f64, length: f64) -> [f64; B] {
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

/// Adds wᵢ L aᵀ k a for the section stiffness k by rows.
fn add_section<const B: usize>(rows: &[[f64; B]], k: &[f64], weight: f64, kb: &mut [[f64; B]; B]) {
    for (a, k) in rows.iter().zip(k.chunks_exact(rows.len().max(1))) {
        for (b, k) in rows.iter().zip(k) {
            for (row, a) in kb.iter_mut().zip(a) {
                row.iter_mut().zip(b).for_each(|(kb, b)| *kb += weight * a * k * b);
            }
        }
    }
}

impl<const N: usize, const B: usize> Formulation<N, B> for DisplacementBased {
    const CLASS: [&'static str; 2] = ["DispBeamColumn2d", "DispBeamColumn3d"];

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

    fn respond(
        &self,
        member: &Member<N, B>,
        v: &[f64; B],
        motion: &ElementInput<'_>,
        committed: &[f64],
        trial: &mut [f64],
    ) -> Result<Basic<B>, ElementError> {
        let mut basic = Basic { q: [0.0; B], k: [[0.0; B]; B] };
        basic.q.copy_from_slice(&motion.load[..B]);
        for (section, x, weight) in member.along() {
            let (mut rows, mut e) = ([[0.0; B]; MAX_ORDER], [0.0; MAX_ORDER]);
            for ((row_, e), r) in rows.iter_mut().zip(&mut e).zip(section.resultants()) {
                *row_ = row(*r, x, member.length());
                *e = dot(row_, v);
            }
            section.update(committed, &e, motion.dt, trial)?;
            let rows = &rows[..section.resultants().len()];
            for (row, s) in rows.iter().zip(section.resultant(trial)) {
                basic.q.iter_mut().zip(row).for_each(|(q, a)| *q += weight * a * s);
            }
            add_section(rows, section.stiffness(trial), weight, &mut basic.k);
        }
        Ok(basic)
    }

    fn initial_stiffness(member: &Member<N, B>) -> [[f64; B]; B] {
        let mut kb = [[0.0; B]; B];
        for (section, x, weight) in member.along() {
            let n = section.resultants().len();
            let (mut rows, mut k) = ([[0.0; B]; MAX_ORDER], [0.0; MAX_ORDER * MAX_ORDER]);
            rows.iter_mut().zip(section.resultants()).for_each(|(a, r)| *a = row(*r, x, member.length()));
            section.section.initial_stiffness(&mut k[..n * n]);
            add_section(&rows[..n], &k[..n * n], weight, &mut kb);
        }
        kb
    }

    fn elastic_deformation(member: &Member<N, B>, q: &[f64; B], _: &[f64]) -> [f64; B] {
        let mut f = <Self as Formulation<N, B>>::initial_stiffness(member);
        if !invert(f.as_flattened_mut(), B) {
            return [0.0; B];
        }
        f.map(|row| dot(&row, q))
    }
}
