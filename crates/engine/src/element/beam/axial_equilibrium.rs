//! The displacement-based beam with one axial force: `AxEqDispBeamColumn2d`.

use super::basic::Basic;
use super::displacement_based::{DisplacementBased, row};
use super::member::{Formulation, Lacking, Member};
use super::per_section::PerSection;
use crate::element::{Class, ElementError, ElementInput, ElementResult, Histories};
use crate::numeric::{axpy, dot, invert, product};
use crate::section::{MAX_ORDER, Resultant, SectionSlot};

/// A beam with cubic deflections whose axial strains are such that all sections have one axial force (Tarquini, Almeida and
/// Beyer, Earthquake Engineering and Structural Dynamics 46 (2017) 2461). Their mean is the elongation over the length.
#[derive(Clone, Copy, Debug)]
pub struct AxialEquilibrium {
    /// Sum of the differences of the axial forces of adjacent sections that counts as none.
    pub tolerance: f64,
    /// Largest number of iterations.
    pub iterations: usize,
}

/// Place of the axial force among the resultants of a section.
fn axial(section: &SectionSlot) -> usize {
    section.resultants().iter().position(|r| *r == Resultant::P).unwrap_or(0)
}

/// Stiffness of a beam whose sections have tangents: by the sections, n x n by rows.
fn stiffness<'a, const N: usize, const B: usize>(
    member: &Member<N, B>,
    tangents: impl Iterator<Item = &'a [f64]>,
) -> Option<[[f64; B]; B]> {
    let length = member.length();
    let mut out = [[0.0; B]; B];
    // Change of the axial force per basic deformation, and of the basic forces per axial force, both times the flexibility.
    let (mut by_deformation, mut of_force, mut flexibility) = ([0.0; B], [0.0; B], 0.0);
    (by_deformation[0], of_force[0]) = (1.0 / length, 1.0 / length);
    for ((section, x, weight), k) in member.along().zip(tangents) {
        let (n, p, share) = (section.order(), axial(section), weight / length);
        let stiff = k[p * n + p];
        if stiff == 0.0 {
            return None;
        }
        flexibility += share / stiff;
        let mut rows = [[0.0; B]; MAX_ORDER];
        rows.iter_mut().zip(section.resultants()).for_each(|(out, r)| *out = row(*r, x, length));
        for i in (0..n).filter(|i| *i != p) {
            axpy(share * k[p * n + i] / stiff, &rows[i], &mut by_deformation);
            axpy(share * k[i * n + p] / stiff, &rows[i], &mut of_force);
            for j in (0..n).filter(|j| *j != p) {
                let condensed = k[i * n + j] - k[i * n + p] * k[p * n + j] / stiff;
                out.iter_mut().zip(&rows[i]).for_each(|(out, a)| axpy(weight * condensed * a, &rows[j], out));
            }
        }
    }
    out.iter_mut().zip(of_force).for_each(|(out, f)| axpy(length * f / flexibility, &by_deformation, out));
    flexibility.is_finite().then_some(out)
}

impl<const N: usize, const B: usize> Formulation<N, B> for AxialEquilibrium {
    type Loads = DisplacementBased;
    const CLASS: [Class; 2] = [Class::new("AxEqDispBeamColumn2d", 178), Class::own("AxEqDispBeamColumn3d")];
    const LACKING: Lacking = Lacking::Refused;

    fn respond(
        &self,
        member: &Member<N, B>,
        v: &[f64; B],
        motion: &ElementInput<'_>,
        h: &mut Histories<'_>,
    ) -> ElementResult<Basic<B>> {
        let length = member.length();
        let mean = |strains: &PerSection<f64>| -> f64 {
            member.along().zip(strains).map(|((_, _, weight), e)| weight / length * e).sum()
        };
        let mut strains: PerSection<f64> =
            member.along().map(|(section, ..)| section.deformation(h.committed)[axial(section)]).collect();
        let more = v[0] / length - mean(&strains);
        (&mut strains).into_iter().for_each(|e| *e += more);
        let mut iteration = 0;
        loop {
            for ((section, x, _), axial_strain) in member.along().zip(&strains) {
                let mut e = [0.0; MAX_ORDER];
                for (e, r) in e.iter_mut().zip(section.resultants()) {
                    *e = if *r == Resultant::P { *axial_strain } else { dot(&row::<B>(*r, x, length), v) };
                }
                section.update(h.committed, &e, motion.dt, h.trial)?;
            }
            let forces: PerSection<f64> = member.along().map(|(s, ..)| s.resultant(h.trial)[axial(s)]).collect();
            let pairs = (&forces).into_iter().zip((&forces).into_iter().skip(1));
            let unbalance: f64 = pairs.map(|(force, next)| (next - force).abs()).sum();
            if unbalance < self.tolerance {
                break;
            }
            if iteration == self.iterations || !unbalance.is_finite() {
                return Err(ElementError("the sections of the beam find no common axial force".into()));
            }
            iteration += 1;
            let stiff = |s: &SectionSlot| s.stiffness(h.trial)[axial(s) * (s.order() + 1)];
            let (mut flexibility, mut sum) = (0.0, v[0] / length - mean(&strains));
            for ((section, _, weight), force) in member.along().zip(&forces) {
                flexibility += weight / length / stiff(section);
                sum += weight / length * force / stiff(section);
            }
            for (((section, ..), force), strain) in member.along().zip(&forces).zip(&mut strains) {
                *strain += (sum / flexibility - force) / stiff(section);
            }
        }
        let mut q = [0.0; B];
        q.copy_from_slice(&motion.load[..B]);
        for (section, x, weight) in member.along() {
            for (r, s) in section.resultants().iter().zip(section.resultant(h.trial)) {
                axpy(weight * s, &row::<B>(*r, x, length), &mut q);
            }
        }
        let k = stiffness(member, member.along().map(|(s, ..)| s.stiffness(h.trial)))
            .ok_or_else(|| ElementError("a section of the beam has no axial stiffness".into()))?;
        Ok(Basic { q, k })
    }

    fn initial_stiffness(member: &Member<N, B>) -> [[f64; B]; B] {
        let tangents: Vec<Vec<f64>> = member
            .along()
            .map(|(section, ..)| {
                let mut k = vec![0.0; section.order() * section.order()];
                section.section.initial_stiffness(&mut k);
                k
            })
            .collect();
        stiffness(member, tangents.iter().map(Vec::as_slice)).unwrap_or([[0.0; B]; B])
    }

    fn elastic_deformation(member: &Member<N, B>, q: &[f64; B], _: &[f64]) -> [f64; B] {
        let mut f = <Self as Formulation<N, B>>::initial_stiffness(member);
        if !invert(f.as_flattened_mut(), B) {
            return [0.0; B];
        }
        product(&f, q)
    }
}
