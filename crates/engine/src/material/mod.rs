//! Uniaxial materials: stress, tangent and next state for a trial strain, as pure functions of the committed state.
//!
//! A law is a struct of constant parameters that implements [`UniaxialLaw`]. Its history is a plain struct declared
//! with [`state_struct!`](crate::state_struct!). The owner of a law (a spring, a fiber) stores the history through a
//! [`Slot`]. A law has no units: stress and strain may be force and displacement.

mod any_law;
mod column_watch;
mod concrete;
mod damper;
mod deteriorating;
mod elastic;
mod gap;
mod lanes;
#[allow(clippy::module_inception)]
mod material;
pub mod multiaxial;
pub mod roles;
mod rubber;
mod shared;
mod slot;
mod smooth;
mod soil;
mod steel;
mod wrapper;

use crate::probe::Probe;
use crate::state_struct::StateStruct;
use std::fmt;

pub(crate) use column_watch::observe_points;
pub use column_watch::{ObservedColumns, WatchesColumns};
pub use concrete::*;
pub use damper::*;
pub use deteriorating::*;
pub use elastic::*;
pub use gap::*;
pub use material::{Material, Recipe, SharedUniaxial, of_length};
pub use multiaxial::{
    AsdConcrete, BEAM_FIBRE, BeamJ2, Condensed, Elastic as ElasticContinuum, Extrapolation, Fsam, FsamParameters,
    HardeningCurve, InitialStrain, Isotropic, J2Plasticity, LAYER, Multiaxial, MultiaxialResult, NdMaterial,
    Orthotropic, PLANE, PLANE_BEAM_FIBRE, ParallelSolids, Plane, SOLID, SeriesSolids, SeriesTolerance,
    SharedMultiaxial, SimplifiedJ2, THICK_PLANE, Tangent, WeightedLaws, strain_of_stress,
};
pub use roles::UniaxialRoles;
pub use rubber::*;
pub(crate) use slot::write_linear;
pub use slot::{Shift, Slot};
pub use smooth::*;
pub use soil::*;
pub use steel::*;
pub use wrapper::*;

/// A trial strain, with the rate and the time that rate-dependent laws need.
#[derive(Clone, Copy, Debug, Default)]
pub struct Strain {
    /// Total strain.
    pub value: f64,
    /// Strain rate from the nodal velocities, 1/time; zero in static analyses, as in OpenSees.
    pub rate: f64,
    /// Domain time since the committed state; zero if the state is recomputed without a step.
    pub dt: f64,
}

/// Response of a law to a trial strain.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Stress {
    /// Stress, viscous part included.
    pub value: f64,
    /// Consistent tangent, d stress / d strain at constant rate.
    pub tangent: f64,
    /// d stress / d rate.
    pub damping: f64,
}

/// Trial strains of many points of one material.
#[derive(Clone, Copy, Debug)]
pub struct Strains<'a> {
    /// Total strain of each.
    pub value: &'a [f64],
    /// Strain rate of each.
    pub rate: &'a [f64],
    /// Domain time since the committed state.
    pub dt: f64,
}

/// Response of many points of one material, one number for each.
#[derive(Debug)]
pub struct Stresses<'a> {
    /// Stresses.
    pub value: &'a mut [f64],
    /// Consistent tangents.
    pub tangent: &'a mut [f64],
    /// d stress / d rate.
    pub damping: &'a mut [f64],
}

/// Answer of a law that may have none.
pub type MaterialResult<T = ()> = Result<T, MaterialError>;

/// Reason why a law has no response.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MaterialError(pub String);

impl fmt::Display for MaterialError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for MaterialError {}

/// Response and next state of a law without viscosity. Parameters far from any material may leave it without a number.
fn finite<S>(name: &str, strain: f64, value: f64, tangent: f64, next: S) -> MaterialResult<(Stress, S)> {
    if value.is_finite() && tangent.is_finite() {
        return Ok((Stress { value, tangent, damping: 0.0 }, next));
    }
    Err(MaterialError(format!("{name} has no stress at a strain of {strain:.6e}: its parameters are out of range")))
}

/// A uniaxial law with a fixed number of state variables.
pub trait UniaxialLaw: fmt::Debug + Send + Sync + Clone + 'static {
    /// History of one point; `default()` is the virgin state.
    type State: StateStruct;

    /// Name in the `uniaxialMaterial` command.
    const NAME: &'static str;

    /// The histories of many points stand one quantity after the other, for [`UniaxialLaw::update_points`], and not one
    /// point after the other.
    const BY_QUANTITY: bool = false;

    /// Returns the stress and the next state for a trial strain, from the committed state.
    ///
    /// # Errors
    /// The law has no response at this strain.
    fn update(&self, committed: &Self::State, strain: Strain) -> MaterialResult<(Stress, Self::State)>;

    /// [`Uniaxial::update_all`] of this law. A law overrides it that evaluates many points by vector instructions.
    ///
    /// # Errors
    /// The law has no response at one of the strains.
    fn update_points(
        &self,
        committed: &[f64],
        strains: &Strains<'_>,
        next: &mut [f64],
        stresses: &mut Stresses<'_>,
    ) -> MaterialResult {
        update_each(self, committed, strains, next, stresses)
    }

    /// As [`UniaxialLaw::update`], with the last trial state of the step in `last`. Some laws of OpenSees keep from
    /// it the variables that a trial does not set.
    fn update_on(
        &self,
        committed: &Self::State,
        _last: &Self::State,
        strain: Strain,
    ) -> MaterialResult<(Stress, Self::State)> {
        self.update(committed, strain)
    }

    /// Tangent of the virgin material.
    fn initial_tangent(&self) -> f64;

    /// Returns true if the stress depends on the rate of the nodal velocities, so that `Stress::damping` is used.
    fn is_viscous(&self) -> bool {
        false
    }

    /// Returns true if the stress depends on the elapsed time (`Strain::dt`).
    fn depends_on_time(&self) -> bool {
        false
    }

    /// Returns true if the stress is proportional to the strain for every history.
    fn is_linear(&self) -> bool {
        false
    }

    /// Strain in recorders for a strain of the material. A law with an initial stress adds the strain of that stress.
    fn shown_strain(&self, strain: f64) -> f64 {
        strain
    }

    /// Sets a parameter that is no number of the law's command, by its name in scripts, and returns the previous value;
    /// `None` if the law has no such parameter. The numbers of the command are those of its [`Recipe`].
    fn set_parameter(&mut self, _name: &str, _value: f64) -> Option<f64> {
        None
    }

    /// Limit surface of a column whose committed response the law needs.
    fn limit_curve(&self) -> Option<&LimitCurve> {
        None
    }

    /// Changes the committed state by the response of the column that [`UniaxialLaw::limit_curve`] names.
    fn observe(&self, _committed: &mut Self::State, _seen: &ColumnResponse) {}

    /// Response specific to this law, in addition to those of every material.
    fn probe(&self, _words: &[&str]) -> Option<Probe> {
        None
    }

    /// Value of a probe from the state.
    fn read(&self, _path: &[u32], _state: &Self::State, _out: &mut [f64]) {}
}

/// Evaluates points one after the other.
pub(crate) fn update_each<U: Uniaxial + ?Sized>(
    material: &U,
    committed: &[f64],
    strains: &Strains<'_>,
    next: &mut [f64],
    stresses: &mut Stresses<'_>,
) -> MaterialResult {
    let n = material.state_len();
    for (i, (&value, &rate)) in strains.value.iter().zip(strains.rate).enumerate() {
        let words = i * n..(i + 1) * n;
        let strain = Strain { value, rate, dt: strains.dt };
        let s = material.update(&committed[words.clone()], strain, &mut next[words])?;
        (stresses.value[i], stresses.tangent[i], stresses.damping[i]) = (s.value, s.tangent, s.damping);
    }
    Ok(())
}

/// Writes [`Uniaxial::update_all`] of a law that evaluates one point after the other.
macro_rules! updates_each_point {
    () => {
        fn update_all(
            &self,
            committed: &[f64],
            strains: &$crate::material::Strains<'_>,
            next: &mut [f64],
            stresses: &mut $crate::material::Stresses<'_>,
        ) -> $crate::material::MaterialResult {
            $crate::material::update_each(self, committed, strains, next, stresses)
        }
    };
}
pub(crate) use updates_each_point;

/// Constant properties of a material, by which its owner saves work.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct UniaxialTraits {
    /// The stress is proportional to the strain for every history.
    pub linear: bool,
    /// `Stress::damping` is used.
    pub viscous: bool,
    /// The stress depends on the elapsed time (`Strain::dt`).
    pub elapses: bool,
}

impl UniaxialTraits {
    /// Of several materials in parallel.
    pub(crate) fn of<'a>(materials: impl IntoIterator<Item = &'a Slot>) -> Self {
        materials.into_iter().fold(Self { linear: true, ..Self::default() }, |all, slot| {
            let Self { linear, viscous, elapses } = slot.material.traits();
            Self { linear: all.linear && linear, viscous: all.viscous || viscous, elapses: all.elapses || elapses }
        })
    }
}

/// A uniaxial material of any kind. No method has a default: a law around others decides on every one of them.
///
/// `roles` names what else it does, each a trait of [`roles`]: a layout of many points, parameters, responses, watched
/// columns. A material without any has `UniaxialRoles::default()`.
pub trait Uniaxial: fmt::Debug + Send + Sync {
    /// Name in the `uniaxialMaterial` command.
    fn name(&self) -> &'static str;
    /// Number of state variables.
    fn state_len(&self) -> usize;
    /// Writes the virgin state.
    fn init(&self, state: &mut [f64]);
    /// Its constant properties.
    fn traits(&self) -> UniaxialTraits;
    /// Tangent of the virgin material.
    fn initial_tangent(&self) -> f64;

    /// Returns the stress for a trial strain from the committed history, and writes every variable of `next`.
    ///
    /// # Errors
    /// The law has no response at this strain.
    fn update(&self, committed: &[f64], strain: Strain, next: &mut [f64]) -> MaterialResult<Stress>;

    /// As [`Uniaxial::update`], for many points in the layout of the material. One dynamic call serves a whole bundle of
    /// springs, and the law is called statically inside it.
    ///
    /// # Errors
    /// The law has no response at one of the strains.
    fn update_all(
        &self,
        committed: &[f64],
        strains: &Strains<'_>,
        next: &mut [f64],
        stresses: &mut Stresses<'_>,
    ) -> MaterialResult;

    /// Its special tasks. A law around others has the roles of `UniaxialRoles::around`.
    fn roles(&self) -> UniaxialRoles<'_>;
}

/// Parameter of laws whose softening depends on the length in which it localises.
pub const CHARACTERISTIC_LENGTH: &str = "characteristicLength";
