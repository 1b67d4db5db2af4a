//! Uniaxial materials that count how often they are asked, in the place of those that a script defines.

use hysteron::material::roles::{LastTrial, LawParameters, PointLayout, UniaxialRoles};
use hysteron::material::{
    Material, MaterialResult, SharedUniaxial, Strain, Strains, Stress, Stresses, Uniaxial, UniaxialTraits,
};
use hysteron::opensees::Tcl;
use hysteron::parameter::{Changed, NewValue};
use hysteron::run::Run;
use hysteron::tcl::{Call, Exception, Value};
use std::cell::Cell;
use std::sync::Arc;

thread_local! {
    /// Trial strains that laws of this thread were asked for.
    static CALLS: Cell<u64> = const { Cell::new(0) };
}

/// Calls of laws by this thread since the last time, one for each point of a bundle.
pub fn take_calls() -> u64 {
    CALLS.take()
}

fn count(calls: usize) {
    CALLS.set(CALLS.get() + calls as u64);
}

/// Let every `uniaxialMaterial` of a script count its calls.
pub fn count_laws(run: &mut Run) {
    run.interp.register("countCallsOf", count_calls_of);
    let prelude = "rename uniaxialMaterial uncountedMaterial\n\
                   proc uniaxialMaterial {args} {uplevel 1 uncountedMaterial $args; countCallsOf [lindex $args 1]}";
    run.interp.eval_str("prelude.tcl", prelude).unwrap();
}

fn count_calls_of(interp: &mut Tcl, call: &Call<'_>) -> Result<Value, Exception> {
    let tag: i32 = call.arg(1).as_str().parse().unwrap();
    let materials = &mut interp.host.builder.definitions.materials;
    let material = materials.remove(tag).unwrap();
    assert!(materials.add(tag, Material::new(Counted(material))));
    Ok(Value::from(""))
}

/// A material that counts its calls; all else is that of the material inside.
#[derive(Debug)]
struct Counted(Material);

#[deny(clippy::missing_trait_methods)]
impl Uniaxial for Counted {
    fn update(&self, committed: &[f64], strain: Strain, next: &mut [f64]) -> MaterialResult<Stress> {
        count(1);
        self.0.update(committed, strain, next)
    }
    fn update_all(
        &self,
        committed: &[f64],
        strains: &Strains<'_>,
        next: &mut [f64],
        stresses: &mut Stresses<'_>,
    ) -> MaterialResult {
        count(strains.value.len());
        self.0.update_all(committed, strains, next, stresses)
    }
    fn name(&self) -> &'static str {
        self.0.name()
    }
    fn state_len(&self) -> usize {
        self.0.state_len()
    }
    fn init(&self, state: &mut [f64]) {
        self.0.init(state);
    }
    fn traits(&self) -> UniaxialTraits {
        self.0.traits()
    }
    fn initial_tangent(&self) -> f64 {
        self.0.initial_tangent()
    }
    fn roles(&self) -> UniaxialRoles<'_> {
        let UniaxialRoles {
            layout,
            commit,
            last_trial,
            trace,
            virgin,
            shown_strain,
            parameters: _,
            responses,
            columns,
            shifted: _,
            law: _,
        } = self.0.roles();
        UniaxialRoles {
            layout: layout.map(|_| self as &dyn PointLayout),
            commit,
            last_trial: last_trial.map(|_| self as &dyn LastTrial),
            trace,
            virgin,
            shown_strain,
            parameters: Some(self),
            responses,
            columns,
            shifted: None,
            law: None,
        }
    }
}

/// Points are neither padded nor joined with those of other materials, so that each counts once.
impl PointLayout for Counted {
    fn init_all(&self, n: usize, state: &mut [f64]) {
        self.0.init_all(n, state);
    }
    fn block_len(&self) -> usize {
        1
    }
    fn copy_history(&self, from: (&[f64], usize, usize), to: (&mut [f64], usize, usize)) {
        self.0.copy_history(from, to);
    }
}

impl LastTrial for Counted {
    fn update_all_on(
        &self,
        committed: &[f64],
        before: &[f64],
        strains: &Strains<'_>,
        next: &mut [f64],
        stresses: &mut Stresses<'_>,
    ) -> MaterialResult {
        count(strains.value.len());
        match self.0.roles().last_trial {
            Some(law) => law.update_all_on(committed, before, strains, next, stresses),
            None => self.0.update_all(committed, strains, next, stresses),
        }
    }
}

impl LawParameters for Counted {
    fn with_parameter(&self, words: &[&str], value: NewValue) -> Changed<SharedUniaxial> {
        let (material, old) = self.0.with_parameter(words, value)?;
        Ok((Arc::new(Self(material)), old))
    }
}
