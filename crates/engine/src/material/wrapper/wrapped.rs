//! Materials that wrap another one: strain limits, and an initial state.

use crate::material::roles::{LawParameters, LawResponses, PointLayout, ShownStrain, TrialTrace, UniaxialRoles};
use crate::material::wrapper::wrapper::{Wrapped, Wrapper};
use crate::material::{
    Material, MaterialError, MaterialResult, SharedUniaxial, Shift, Slot, Strain, Strains, Stress, Stresses, Uniaxial,
    UniaxialTraits,
};
use crate::parameter::{Changed, NewValue, exchange};
use crate::probe::Probe;
use std::sync::Arc;

/// A material that fails permanently if its strain reaches a limit.
pub type MinMax = Wrapped<StrainLimits>;

/// Strain limits of [`MinMax`].
#[derive(Clone, Debug)]
pub struct StrainLimits {
    min: f64,
    max: f64,
    /// As in OpenSees, recorders keep reporting the strain before the failure.
    compat: bool,
}

/// 1 if the material has failed; its own variables follow.
const FAILED: usize = 0;
/// Tangent of a failed material divided by the initial tangent; a positive value keeps the stiffness matrix regular.
const FAILED_TANGENT_RATIO: f64 = 1.0e-8;
/// Tolerance of the initial stress, relative to the stress, or absolute for a stress of zero.
const STRESS_TOLERANCE: f64 = 1e-12;
/// Maximum number of Newton iterations for the initial strain.
const MAX_ITERATIONS: usize = 100;

impl MinMax {
    /// From a material, given with its tag, and its strain limits.
    pub fn new(material: (Material, i32), min: f64, max: f64, compat: bool) -> Self {
        Self::around(StrainLimits { min, max, compat }, [material])
    }
}

impl Wrapper for StrainLimits {
    const NAME: &'static str = "MinMax";
    const HEADER: usize = 1;
    const NUMBERED: bool = false;

    fn init(&self, own: &mut [f64], _: &[Slot]) {
        own[FAILED] = 0.0;
    }
    fn update(&self, inner: &[Slot], committed: &[f64], strain: Strain, next: &mut [f64]) -> MaterialResult<Stress> {
        if committed[FAILED] != 0.0 || strain.value >= self.max || strain.value <= self.min {
            next.copy_from_slice(&committed[..next.len()]);
            next[FAILED] = 1.0;
            let tangent = FAILED_TANGENT_RATIO * self.initial_tangent(inner);
            return Ok(Stress { value: 0.0, tangent, damping: 0.0 });
        }
        next[FAILED] = 0.0;
        inner[0].update(committed, strain, next)
    }
    fn initial_tangent(&self, inner: &[Slot]) -> f64 {
        inner[0].material.initial_tangent()
    }
    fn traits(&self, inner: UniaxialTraits) -> UniaxialTraits {
        UniaxialTraits { linear: false, ..inner }
    }
    fn has_failed(&self, state: &[f64]) -> bool {
        state[FAILED] != 0.0
    }
    fn shown_strain(&self, inner: &[Slot], strain: f64, state: &[f64]) -> f64 {
        let held = self.compat && self.has_failed(state);
        inner[0].shown(if held { inner[0].strain(state) } else { strain }, state)
    }
    fn probe(&self, _: &[Slot], word: &str) -> Option<Probe> {
        (word == "failed").then(|| Probe::new(0, ["failed"]))
    }
    fn read(&self, _: &[Slot], _: u32, state: &[f64], out: &mut [f64]) {
        out[0] = state[FAILED];
    }
}

/// A material with an initial strain at zero total strain.
#[derive(Clone, Debug)]
pub struct InitialState {
    name: &'static str,
    inner: Slot,
    strain: f64,
}

impl InitialState {
    /// `InitStrainMaterial`: a given initial strain.
    ///
    /// # Errors
    /// The material has no stress at this strain.
    pub fn strain((material, tag): (Material, i32), strain: f64) -> MaterialResult<Self> {
        let law = Self { name: "InitStrainMaterial", inner: Slot::new(material, tag, 0), strain };
        law.begin(strain).map(|_| law)
    }

    /// `InitStressMaterial`: a given initial stress, whose strain is found by Newton's method.
    ///
    /// # Errors
    /// No strain has this stress.
    pub fn stress((material, tag): (Material, i32), stress: f64) -> MaterialResult<Self> {
        let tangent = material.initial_tangent();
        let mut law = Self { name: "InitStressMaterial", inner: Slot::new(material, tag, 0), strain: 0.0 };
        let tolerance = if stress == 0.0 { STRESS_TOLERANCE } else { STRESS_TOLERANCE * stress.abs() };
        let (mut missing, mut slope) = (stress, tangent);
        for _ in 0..MAX_ITERATIONS {
            law.strain += missing / slope;
            if !law.strain.is_finite() {
                break;
            }
            let s = law.begin(law.strain)?.1;
            (missing, slope) = (stress - s.value, s.tangent);
            if missing.abs() <= tolerance {
                return Ok(law);
            }
        }
        Err(MaterialError(format!("the material has no strain with a stress of {stress}")))
    }

    /// State and stress of the material after one step from rest to a strain.
    fn begin(&self, value: f64) -> MaterialResult<(Vec<f64>, Stress)> {
        let mut rest = vec![0.0; self.inner.len()];
        self.inner.init(&mut rest);
        let mut state = rest.clone();
        let stress = self.inner.update(&rest, Strain { value, ..Strain::default() }, &mut state)?;
        Ok((state, stress))
    }
}

crate::watches_columns!(InitialState => |s| in [&s.inner]);

#[deny(clippy::missing_trait_methods)]
impl Uniaxial for InitialState {
    fn name(&self) -> &'static str {
        self.name
    }
    fn state_len(&self) -> usize {
        self.inner.len()
    }
    fn init(&self, state: &mut [f64]) {
        self.inner.init(state);
        // The constructor has evaluated the same step successfully.
        if let Ok((initial, _)) = self.begin(self.strain) {
            state[..initial.len()].copy_from_slice(&initial);
        }
    }
    fn update(&self, committed: &[f64], strain: Strain, next: &mut [f64]) -> MaterialResult<Stress> {
        self.inner.update(committed, Strain { value: strain.value + self.strain, ..strain }, next)
    }
    fn update_all(
        &self,
        committed: &[f64],
        strains: &Strains<'_>,
        next: &mut [f64],
        stresses: &mut Stresses<'_>,
    ) -> MaterialResult {
        self.inner.update_all(committed, &Shift::All(self.strain), strains, next, stresses)
    }
    fn initial_tangent(&self) -> f64 {
        self.inner.material.initial_tangent()
    }
    fn traits(&self) -> UniaxialTraits {
        let inner = self.inner.material.traits();
        UniaxialTraits { linear: self.strain == 0.0 && inner.linear, ..inner }
    }
    fn roles(&self) -> UniaxialRoles<'_> {
        let shifted = Some((&self.inner, self.strain));
        UniaxialRoles { layout: Some(self), shifted, ..UniaxialRoles::around(self, [&self.inner]) }
    }
}

impl PointLayout for InitialState {
    fn init_all(&self, n: usize, state: &mut [f64]) {
        let mut one = vec![0.0; self.state_len()];
        self.init(&mut one);
        (0..n).for_each(|j| self.copy_history((&one, 0, 1), (&mut *state, j, n)));
    }
    fn block_len(&self) -> usize {
        self.inner.material.block_len()
    }
    fn copy_history(&self, from: (&[f64], usize, usize), to: (&mut [f64], usize, usize)) {
        self.inner.copy_history(from, to);
    }
}

impl TrialTrace for InitialState {
    fn leave_trace(&self, tried: &[f64], committed: &mut [f64]) {
        self.inner.leave_trace(tried, committed);
    }
}

impl ShownStrain for InitialState {
    fn shown_strain(&self, strain: f64, state: &[f64]) -> f64 {
        self.inner.shown(strain + self.strain, state)
    }
}

impl LawParameters for InitialState {
    fn with_parameter(&self, words: &[&str], value: NewValue) -> Changed<SharedUniaxial> {
        let mut new = self.clone();
        let old = match words {
            ["epsInit"] => exchange(&mut new.strain, value),
            ["material", rest @ ..] => new.inner.set_parameter(rest, value)?,
            _ => new.inner.set_parameter(words, value)?,
        };
        Ok((Arc::new(new), old))
    }
}

impl LawResponses for InitialState {
    fn probe(&self, words: &[&str]) -> Option<Probe> {
        let words = if words.first() == Some(&"material") { &words[1..] } else { words };
        self.inner.probe(words)
    }
    fn read(&self, path: &[u32], state: &[f64], out: &mut [f64]) {
        self.inner.read(path, state, out);
    }
}
