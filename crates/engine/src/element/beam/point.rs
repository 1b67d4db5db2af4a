//! A section of a force-based beam in an iteration.

use super::force_based::{of_load, row};
use super::member::Member;
use super::per_section::PerSection;
use crate::material::MaterialError;
use crate::numeric::{axpy, dot};
use crate::section::{MAX_ORDER, SectionSlot};

/// Section stiffness whose inverse is the flexibility.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Stiffness {
    /// That of the state.
    Current,
    /// That of the virgin section.
    Virgin,
    /// That of the state and a share of the virgin one: regular where the section is fully plastic.
    Supported,
}

/// Share of the virgin stiffness in [`Stiffness::Supported`]. It changes the speed of the iteration, not its result.
pub(super) const SUPPORT: f64 = 1e-8;

/// Interpolation, flexibility, deformations and resultants of a section. `M` bounds the number of resultants, so that
/// the sizes of all loops are known; what is beyond the resultants of the section is zero.
pub(super) struct Point<const B: usize, const M: usize> {
    /// Number of resultants.
    order: usize,
    rows: [[f64; B]; M],
    flexibility: [[f64; M]; M],
    e: [f64; M],
    s: [f64; M],
    /// Resultants of the loads in the simple beam.
    of_load: [f64; M],
}

impl<const B: usize, const M: usize> Point<B, M> {
    /// A section at a fraction `x` of a length, without a state. `internal` are the internal forces of the simple beam
    /// at the section.
    pub(super) fn at(section: &SectionSlot, (x, length): (f64, f64), internal: &[f64]) -> Self {
        let resultants = section.resultants();
        let mut p = Self {
            order: resultants.len(),
            rows: [[0.0; B]; M],
            flexibility: [[0.0; M]; M],
            e: [0.0; M],
            s: [0.0; M],
            of_load: [0.0; M],
        };
        for ((rows, of_load_), r) in p.rows.iter_mut().zip(&mut p.of_load).zip(resultants) {
            *rows = row(*r, x, length);
            *of_load_ = if internal.is_empty() { 0.0 } else { of_load(*r, internal) };
        }
        p
    }

    /// Reads a section from a state.
    ///
    /// # Errors
    /// The stiffness is singular.
    pub(super) fn new(
        section: &SectionSlot,
        (place, internal): ((f64, f64), &[f64]),
        trial: &[f64],
        stiffness: Stiffness,
    ) -> Result<Self, MaterialError> {
        let mut p = Self::at(section, place, internal);
        p.read(section, trial, stiffness)?;
        Ok(p)
    }

    /// Reads flexibility, deformations and resultants anew.
    ///
    /// # Errors
    /// The stiffness is singular.
    #[inline]
    pub(super) fn read(
        &mut self,
        section: &SectionSlot,
        trial: &[f64],
        stiffness: Stiffness,
    ) -> Result<(), MaterialError> {
        let (e, s, k) = section.parts(trial);
        match stiffness {
            Stiffness::Current => self.invert(section, k)?,
            Stiffness::Virgin => self.make_virgin(section)?,
            Stiffness::Supported => {
                let mut sum = [0.0; MAX_ORDER * MAX_ORDER];
                let sum = &mut sum[..self.order * self.order];
                section.section.initial_stiffness(sum);
                sum.iter_mut().zip(k).for_each(|(sum, k)| *sum = k + SUPPORT * *sum);
                self.invert(section, sum)?;
            }
        }
        self.e.iter_mut().zip(e).for_each(|(own, e)| *own = *e);
        self.s.iter_mut().zip(s).for_each(|(own, s)| *own = *s);
        Ok(())
    }

    /// Sets the flexibility to that of the virgin section.
    ///
    /// # Errors
    /// The stiffness is singular.
    pub(super) fn make_virgin(&mut self, section: &SectionSlot) -> Result<(), MaterialError> {
        let mut k = [0.0; MAX_ORDER * MAX_ORDER];
        let k = &mut k[..self.order * self.order];
        section.section.initial_stiffness(k);
        self.invert(section, k)
    }

    /// Sets the flexibility to the inverse of a stiffness.
    #[inline]
    fn invert(&mut self, section: &SectionSlot, stiffness: &[f64]) -> Result<(), MaterialError> {
        if self.order == M {
            return section.flexibility(stiffness, self.flexibility.as_flattened_mut());
        }
        let mut all = [0.0; MAX_ORDER * MAX_ORDER];
        section.flexibility(stiffness, &mut all)?;
        for (own, row) in self.flexibility.iter_mut().zip(all.chunks_exact(self.order.max(1))).take(self.order) {
            own[..self.order].copy_from_slice(row);
        }
        Ok(())
    }

    /// Deformations for the basic forces `q`, linear from the state.
    #[inline]
    pub(super) fn deformations(&self, q: &[f64; B]) -> [f64; M] {
        let (mut residual, mut e) = ([0.0; M], self.e);
        for (i, residual) in residual.iter_mut().enumerate() {
            *residual = dot(&self.rows[i], q) + self.of_load[i] - self.s[i];
        }
        e.iter_mut().zip(&self.flexibility).for_each(|(e, row)| *e += dot(row, &residual));
        e
    }

    /// Work of the unbalanced resultants on the deformations that they would still cause, and of the resultants on the
    /// deformations.
    pub(super) fn work(&self, q: &[f64; B]) -> (f64, f64) {
        let e = self.deformations(q);
        let (mut unbalanced, mut whole) = (0.0, 0.0);
        for (i, e) in e.iter().enumerate() {
            unbalanced += ((e - self.e[i]) * (self.asked(i, q) - self.s[i])).abs();
            whole += (self.e[i] * self.s[i]).abs();
        }
        (unbalanced, whole)
    }

    /// A resultant in equilibrium with the basic forces `q` and the loads.
    fn asked(&self, i: usize, q: &[f64; B]) -> f64 {
        dot(&self.rows[i], q) + self.of_load[i]
    }

    /// Index of the resultant with the largest work of its imbalance, that work, the resultant of the section, and that in
    /// equilibrium with the basic forces `q`.
    pub(super) fn worst(&self, q: &[f64; B]) -> (usize, f64, [f64; 2]) {
        let e = self.deformations(q);
        let work = |i: usize| ((e[i] - self.e[i]) * (self.asked(i, q) - self.s[i])).abs();
        let at = (0..self.order).max_by(|i, j| work(*i).total_cmp(&work(*j))).unwrap_or(0);
        (at, work(at), [self.s[at], self.asked(at, q)])
    }

    /// Sets the deformations to those of the loads alone.
    pub(super) fn load_alone(&mut self) {
        self.e = self.flexibility.map(|row| dot(&row, &self.of_load));
    }

    /// Deformations of the state.
    pub(super) fn e(&self) -> [f64; M] {
        self.e
    }

    /// Adds weight x aᵀ f a to the flexibility and weight x aᵀ e to the basic deformations.
    #[inline]
    pub(super) fn add(&self, weight: f64, e: &[f64; M], f: &mut [[f64; B]; B], v: &mut [f64; B]) {
        self.add_deformations(weight, e, v);
        for (a, flexibility) in self.rows.iter().zip(&self.flexibility) {
            // Deformations of a resultant for each basic force.
            let mut per_force = [0.0; B];
            for (c, b) in flexibility.iter().zip(&self.rows) {
                axpy(weight * c, b, &mut per_force);
            }
            f.iter_mut().zip(a).for_each(|(row, a)| axpy(*a, &per_force, row));
        }
    }

    /// Adds weight x aᵀ e to the basic deformations.
    #[inline]
    pub(super) fn add_deformations(&self, weight: f64, e: &[f64; M], v: &mut [f64; B]) {
        self.rows.iter().zip(e).for_each(|(a, e)| axpy(weight * e, a, v));
    }
}

/// Reads flexibilities, deformations and resultants of all sections anew.
///
/// # Errors
/// A stiffness is singular.
pub(super) fn read_all<const N: usize, const B: usize, const M: usize>(
    member: &Member<N, B>,
    points: &mut PerSection<Point<B, M>>,
    trial: &[f64],
    stiffness: Stiffness,
) -> Result<(), MaterialError> {
    let mut places = member.sections.iter().zip(points);
    places.try_for_each(|(section, point)| point.read(section, trial, stiffness))
}

impl<const N: usize, const B: usize> Member<N, B> {
    /// Largest number of resultants of a section.
    pub(super) fn order(&self) -> usize {
        self.sections.iter().map(SectionSlot::order).max().unwrap_or(0)
    }
}
