//! Every [`UniaxialLaw`] as a [`Uniaxial`] material: its history lies in the state of an element.

use super::plain_methods::plain_methods;
use super::{
    LimitCurve, MaterialError, ObservedColumns, SharedUniaxial, Strain, Strains, Stress, Stresses, Uniaxial,
    UniaxialLaw, WatchesColumns,
};
use crate::numeric::lanes::BLOCK;
use crate::parameter::{Changed, existing, first};
use crate::probe::Probe;
use crate::state_struct::StateStruct;
use std::any::Any;
use std::sync::Arc;

impl<L: UniaxialLaw> WatchesColumns for L {
    fn limit_curves(&self) -> Vec<&LimitCurve> {
        self.limit_curve().into_iter().collect()
    }
    fn observe(&self, committed: &mut [f64], columns: &ObservedColumns<'_>) {
        if let Some(seen) = self.limit_curve().and_then(|curve| columns.of(curve)) {
            let mut state = L::State::read(committed);
            UniaxialLaw::observe(self, &mut state, &seen);
            state.write(committed);
        }
    }
}

impl<L: UniaxialLaw> Uniaxial for L {
    plain_methods! { update_all_on shifted commit_all virgin_tangent are_virgin leave_trace }
    fn name(&self) -> &'static str {
        L::NAME
    }
    fn state_len(&self) -> usize {
        L::State::LEN
    }
    fn init(&self, state: &mut [f64]) {
        L::State::default().write(state);
    }
    fn init_all(&self, n: usize, state: &mut [f64]) {
        let len = L::State::LEN;
        if !L::BY_QUANTITY {
            state.chunks_exact_mut(len.max(1)).for_each(|point| L::State::default().write(point));
            return;
        }
        let mut one = vec![0.0; len];
        L::State::default().write(&mut one);
        state.chunks_exact_mut(n.max(1)).zip(one).for_each(|(quantity, value)| quantity.fill(value));
    }
    fn block_len(&self) -> usize {
        if L::BY_QUANTITY { BLOCK } else { 1 }
    }
    fn copy_history(&self, (from, i, n): (&[f64], usize, usize), (to, j, m): (&mut [f64], usize, usize)) {
        let len = L::State::LEN;
        if L::BY_QUANTITY {
            (0..len).for_each(|q| to[q * m + j] = from[q * n + i]);
        } else {
            to[j * len..(j + 1) * len].copy_from_slice(&from[i * len..(i + 1) * len]);
        }
    }
    #[inline]
    fn update(&self, committed: &[f64], strain: Strain, next: &mut [f64]) -> Result<Stress, MaterialError> {
        let (stress, state) = self.update_on(&L::State::read(committed), &L::State::read(next), strain)?;
        state.write(next);
        Ok(stress)
    }
    fn update_all(
        &self,
        committed: &[f64],
        strains: &Strains<'_>,
        next: &mut [f64],
        stresses: &mut Stresses<'_>,
    ) -> Result<(), MaterialError> {
        self.update_points(committed, strains, next, stresses)
    }
    fn initial_tangent(&self) -> f64 {
        UniaxialLaw::initial_tangent(self)
    }
    fn is_viscous(&self) -> bool {
        UniaxialLaw::is_viscous(self)
    }
    fn depends_on_time(&self) -> bool {
        UniaxialLaw::depends_on_time(self)
    }
    fn is_linear(&self) -> bool {
        UniaxialLaw::is_linear(self)
    }
    fn shown_strain(&self, strain: f64, _: &[f64]) -> f64 {
        UniaxialLaw::shown_strain(self, strain)
    }
    fn with_parameter(&self, words: &[&str], value: Option<f64>) -> Changed<SharedUniaxial> {
        let mut new = self.clone();
        let name = first(words)?;
        let old = match value {
            Some(value) => new.set_parameter(name, value),
            // The law tells the value before; what it has put in its place is dropped.
            None => self.clone().set_parameter(name, 1.0),
        };
        let old = existing(old)?;
        Ok((Arc::new(new), old))
    }
    fn as_any(&self) -> Option<&dyn Any> {
        Some(self)
    }
    fn probe(&self, words: &[&str]) -> Option<Probe> {
        UniaxialLaw::probe(self, words)
    }
    fn read(&self, path: &[u32], state: &[f64], out: &mut [f64]) {
        UniaxialLaw::read(self, path, &L::State::read(state), out);
    }
}
