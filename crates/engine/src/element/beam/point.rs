//! A section of a force-based beam in an iteration.

use super::force_based::{of_load, row};
use super::member::Member;
use crate::material::MaterialError;
use crate::numeric::{axpy, dot};
use crate::section::{MAX_ORDER, SectionSlot};

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

    /// Reads a section from a state. The flexibility is that of the virgin section if `initial`.
    ///
    /// # Errors
    /// The stiffness is singular.
    pub(super) fn new(
        section: &SectionSlot,
        (place, internal): ((f64, f64), &[f64]),
        trial: &[f64],
        initial: bool,
    ) -> Result<Self, MaterialError> {
        let mut p = Self::at(section, place, internal);
        p.read(section, trial, initial)?;
        Ok(p)
    }

    /// Reads flexibility, deformations and resultants anew.
    ///
    /// # Errors
    /// The stiffness is singular.
    #[inline]
    pub(super) fn read(&mut self, section: &SectionSlot, trial: &[f64], initial: bool) -> Result<(), MaterialError> {
        let (e, s, k) = section.parts(trial);
        if initial {
            self.make_virgin(section)?;
        } else {
            self.invert(section, k)?;
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
        for ((a, e), flexibility) in self.rows.iter().zip(e).zip(&self.flexibility) {
            axpy(weight * e, a, v);
            // Deformations of a resultant for each basic force.
            let mut per_force = [0.0; B];
            for (c, b) in flexibility.iter().zip(&self.rows) {
                axpy(weight * c, b, &mut per_force);
            }
            f.iter_mut().zip(a).for_each(|(row, a)| axpy(*a, &per_force, row));
        }
    }
}

impl<const N: usize, const B: usize> Member<N, B> {
    /// Largest number of resultants of a section.
    pub(super) fn order(&self) -> usize {
        self.sections.iter().map(SectionSlot::order).max().unwrap_or(0)
    }
}
