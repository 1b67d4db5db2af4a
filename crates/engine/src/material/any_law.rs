//! Every [`UniaxialLaw`] as a [`Uniaxial`] material: its history lies in the state of an element.

use super::roles::{LawParameters, LawResponses, PointLayout, ShownStrain, UniaxialRoles};
use super::{
    LimitCurve, MaterialResult, ObservedColumns, SharedUniaxial, Strain, Strains, Stress, Stresses, Uniaxial,
    UniaxialLaw, UniaxialTraits, WatchesColumns,
};
use crate::numeric::lanes::BLOCK;
use crate::parameter::{Changed, NewValue, existing, first};
use crate::probe::Probe;
use crate::state_struct::StateStruct;
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
    fn name(&self) -> &'static str {
        L::NAME
    }
    fn state_len(&self) -> usize {
        L::State::LEN
    }
    fn init(&self, state: &mut [f64]) {
        L::State::default().write(state);
    }
    fn traits(&self) -> UniaxialTraits {
        UniaxialTraits { linear: self.is_linear(), viscous: self.is_viscous(), elapses: self.depends_on_time() }
    }
    fn initial_tangent(&self) -> f64 {
        UniaxialLaw::initial_tangent(self)
    }
    #[inline]
    fn update(&self, committed: &[f64], strain: Strain, next: &mut [f64]) -> MaterialResult<Stress> {
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
    ) -> MaterialResult {
        self.update_points(committed, strains, next, stresses)
    }
    fn roles(&self) -> UniaxialRoles<'_> {
        UniaxialRoles {
            layout: L::BY_QUANTITY.then_some(self as &dyn PointLayout),
            shown_strain: Some(self),
            parameters: Some(self),
            responses: Some(self),
            columns: self.limit_curve().map(|_| self as &dyn WatchesColumns),
            law: Some(self),
            ..UniaxialRoles::default()
        }
    }
}

/// The layout of a law with [`UniaxialLaw::BY_QUANTITY`].
impl<L: UniaxialLaw> PointLayout for L {
    fn init_all(&self, n: usize, state: &mut [f64]) {
        let mut one = vec![0.0; L::State::LEN];
        L::State::default().write(&mut one);
        state.chunks_exact_mut(n.max(1)).zip(one).for_each(|(quantity, value)| quantity.fill(value));
    }
    fn block_len(&self) -> usize {
        BLOCK
    }
    fn copy_history(&self, (from, i, n): (&[f64], usize, usize), (to, j, m): (&mut [f64], usize, usize)) {
        (0..L::State::LEN).for_each(|q| to[q * m + j] = from[q * n + i]);
    }
}

impl<L: UniaxialLaw> ShownStrain for L {
    fn shown_strain(&self, strain: f64, _: &[f64]) -> f64 {
        UniaxialLaw::shown_strain(self, strain)
    }
}

impl<L: UniaxialLaw> LawParameters for L {
    fn with_parameter(&self, words: &[&str], value: NewValue) -> Changed<SharedUniaxial> {
        let mut new = self.clone();
        let name = first(words)?;
        // The law tells the value before; what it has put in its place is dropped.
        let before = existing(self.clone().set_parameter(name, 1.0))?;
        if let Some(value) = value.instead_of(before) {
            existing(new.set_parameter(name, value))?;
        }
        Ok((Arc::new(new), before))
    }
}

impl<L: UniaxialLaw> LawResponses for L {
    fn probe(&self, words: &[&str]) -> Option<Probe> {
        UniaxialLaw::probe(self, words)
    }
    fn read(&self, path: &[u32], state: &[f64], out: &mut [f64]) {
        UniaxialLaw::read(self, path, &L::State::read(state), out);
    }
}
