//! Uniaxial materials: stress, tangent and next state for a trial strain, as pure functions of the committed state.
//!
//! A law is a struct of constant parameters that implements [`UniaxialLaw`]; its history is a plain struct declared
//! with [`state_struct!`](crate::state_struct!). Whoever uses a law (a spring, a fiber) keeps the history through a [`Slot`].
//! Stress and strain may as well be force and displacement: a law knows no units.

mod axial_spring;
mod bilin;
mod bouc_wen;
mod concrete01;
mod concrete02;
mod elastic;
mod elastic_multi_linear;
mod elastic_pp;
mod elastic_pp_gap;
mod fatigue;
mod hardening;
pub mod hdr;
mod hertz_damp;
mod hysteretic;
mod hysteretic_asym;
mod hysteretic_poly;
mod hysteretic_smooth;
mod impact;
mod jankowski_impact;
mod kikuchi_aiken;
mod kikuchi_aiken_hdr;
mod kikuchi_aiken_lrb;
mod maxwell;
mod multi_linear;
mod no_tension;
mod parallel;
mod saws;
mod self_centering;
mod series;
mod slot;
mod softening;
mod soil_spring;
mod steel01;
mod steel02;
mod steel_brb;
mod viscous;
mod viscous_damper;
mod wrapped;

use crate::probe::Probe;
use crate::state_struct::StateStruct;
use std::fmt;
use std::sync::Arc;

pub use axial_spring::{AxialParameters, AxialSp, AxialSpHD, AxialSpring};
pub use bilin::{Bilin, BilinSide, Deterioration};
pub use bouc_wen::BoucWen;
pub use concrete01::Concrete01;
pub use concrete02::Concrete02;
pub use elastic::Elastic;
pub use elastic_multi_linear::{ElasticBilin, ElasticMultiLinear};
pub use elastic_pp::ElasticPP;
pub use elastic_pp_gap::ElasticPPGap;
pub use fatigue::{Fatigue, FatigueParameters};
pub use hardening::Hardening;
pub use hdr::HdrRheology;
pub use hertz_damp::HertzDamp;
pub use hysteretic::{Envelope, Hysteretic};
pub use hysteretic_asym::HystereticAsym;
pub use hysteretic_poly::HystereticPoly;
pub use hysteretic_smooth::HystereticSmooth;
pub use impact::Impact;
pub use jankowski_impact::JankowskiImpact;
pub use kikuchi_aiken::{Device, KikuchiAiken, Shape};
pub use kikuchi_aiken_hdr::{COMPOUNDS, Compound, HighDampingRubber};
pub use kikuchi_aiken_lrb::{LeadRubber, LeadRubberParameters};
pub use maxwell::Maxwell;
pub use multi_linear::MultiLinear;
pub use no_tension::NoTension;
pub use parallel::Parallel;
pub use saws::{Saws, Wall};
pub use self_centering::SelfCentering;
pub use series::{Iteration, Series};
pub use slot::Slot;
pub use softening::{Mullins, Peak, Softening};
pub use soil_spring::{PyBackbone, PySimple1, QzBackbone, QzSimple1, Soil, SoilSpring, TzBackbone, TzSimple1};
pub use steel_brb::{BrbBranch, SteelBrb};
pub use steel01::Steel01;
pub use steel02::Steel02;
pub use viscous::Viscous;
pub use viscous_damper::{Method, ViscousDamper};
pub use wrapped::{InitialState, MinMax};

/// A trial strain with what rate-dependent laws need to know.
#[derive(Clone, Copy, Debug, Default)]
pub struct Strain {
    /// Total strain.
    pub value: f64,
    /// Strain rate from the nodal velocities, in 1/time: zero in static analyses, as in OpenSees.
    pub rate: f64,
    /// Domain time since the committed state; zero where no time has passed (a state determined anew).
    pub dt: f64,
}

/// What a law answers to a trial strain.
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

/// What many points of one material answer, a number for each.
#[derive(Debug)]
pub struct Stresses<'a> {
    /// Stresses.
    pub value: &'a mut [f64],
    /// Consistent tangents.
    pub tangent: &'a mut [f64],
    /// d stress / d rate.
    pub damping: &'a mut [f64],
}

/// Why a law could not answer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MaterialError(pub String);

impl fmt::Display for MaterialError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for MaterialError {}

/// A uniaxial law with a fixed number of history variables.
pub trait UniaxialLaw: fmt::Debug + Send + Sync + Clone + 'static {
    /// History of one point; `default()` must be the virgin state.
    type State: StateStruct;

    /// Name in the `uniaxialMaterial` command.
    const NAME: &'static str;

    /// Stress and next state for a trial strain, from the committed state.
    fn update(&self, committed: &Self::State, strain: Strain) -> Result<(Stress, Self::State), MaterialError>;

    /// The same where OpenSees is followed: `last` is what the place of the next state holds, mostly the last trial state of the
    /// step, of which some laws of OpenSees keep what a trial does not set.
    fn update_on(
        &self,
        committed: &Self::State,
        _last: &Self::State,
        strain: Strain,
    ) -> Result<(Stress, Self::State), MaterialError> {
        self.update(committed, strain)
    }

    /// Tangent of the virgin material.
    fn initial_tangent(&self) -> f64;

    /// Whether the stress depends on the rate of the nodal velocities, that is, whether `Stress::damping` is ever used.
    fn is_viscous(&self) -> bool {
        false
    }

    /// Whether the stress depends on the time that passes (`Strain::dt`).
    fn depends_on_time(&self) -> bool {
        false
    }

    /// Whether the stress is proportional to the strain, whatever the history.
    fn is_linear(&self) -> bool {
        false
    }

    /// Strain that recorders show for a strain of the material: a law that begins with a stress counts its strain in.
    fn shown_strain(&self, strain: f64) -> f64 {
        strain
    }

    /// Give a parameter, by the name that scripts have for it, another value; the one it had. `None` where the law has
    /// none of that name.
    fn set_parameter(&mut self, _name: &str, _value: f64) -> Option<f64> {
        None
    }

    /// A response of the law's own, beyond those that every material has.
    fn probe(&self, _words: &[&str]) -> Option<Probe> {
        None
    }

    /// Value of a probe from the state.
    fn read(&self, _path: &[u32], _state: &Self::State, _out: &mut [f64]) {}
}

/// A uniaxial material of any kind.
pub trait Uniaxial: fmt::Debug + Send + Sync {
    /// Name in the `uniaxialMaterial` command.
    fn name(&self) -> &'static str;
    /// Number of words of history.
    fn state_len(&self) -> usize;
    /// Write the virgin state.
    fn init(&self, state: &mut [f64]);
    /// Write the virgin state of `n` points that are always updated together. They take `n` times as many words as one,
    /// and need not lie one after the other.
    fn init_all(&self, _n: usize, state: &mut [f64]) {
        state.chunks_exact_mut(self.state_len().max(1)).for_each(|point| self.init(point));
    }
    /// Stress for a trial strain from the committed history; writes every word of `next`.
    fn update(&self, committed: &[f64], strain: Strain, next: &mut [f64]) -> Result<Stress, MaterialError>;

    /// The same for many points whose histories [`Uniaxial::init_all`] has laid out: one dynamic call for a whole bundle of
    /// springs, in which the law is called statically.
    fn update_all(
        &self,
        committed: &[f64],
        strains: &Strains<'_>,
        next: &mut [f64],
        stresses: &mut Stresses<'_>,
    ) -> Result<(), MaterialError> {
        let n = self.state_len();
        for (i, (&value, &rate)) in strains.value.iter().zip(strains.rate).enumerate() {
            let words = i * n..(i + 1) * n;
            let strain = Strain { value, rate, dt: strains.dt };
            let s = self.update(&committed[words.clone()], strain, &mut next[words])?;
            (stresses.value[i], stresses.tangent[i], stresses.damping[i]) = (s.value, s.tangent, s.damping);
        }
        Ok(())
    }

    /// The same for points asked by an element that counts its calls: `next` holds what the last call of this step left,
    /// `before` the committed strains.
    fn update_all_on(
        &self,
        committed: &[f64],
        _before: &[f64],
        strains: &Strains<'_>,
        next: &mut [f64],
        stresses: &mut Stresses<'_>,
    ) -> Result<(), MaterialError> {
        self.update_all(committed, strains, next, stresses)
    }

    /// Take over the trial histories of points. A law with many words may leave out those that nobody reads.
    fn commit_all(&self, trial: &[f64], committed: &mut [f64]) {
        committed.copy_from_slice(trial);
    }

    /// Copy the history of a point among `n` that [`Uniaxial::init_all`] has laid out to another place: words, number of the
    /// point, `n`.
    fn copy_history(&self, (from, i, _): (&[f64], usize, usize), (to, j, _): (&mut [f64], usize, usize)) {
        let n = self.state_len();
        to[j * n..(j + 1) * n].copy_from_slice(&from[i * n..(i + 1) * n]);
    }

    /// Tangent of virgin points whose strains are in a range, where all of them answer with stresses in proportion to their
    /// strains and stay virgin; `None` where they do not, or where the law does not know.
    fn virgin_tangent(&self, _range: [f64; 2]) -> Option<f64> {
        None
    }

    /// Whether these histories of points, as [`Uniaxial::update_all`] has written them, are as good as virgin: a law that
    /// always says no is asked for each point.
    fn are_virgin(&self, _state: &[f64]) -> bool {
        false
    }

    /// Where OpenSees is followed: take over from a trial state into the committed one what a trial leaves behind there
    /// although it is not committed. For springs that are only ever tried.
    fn leave_trace(&self, _tried: &[f64], _committed: &mut [f64]) {}

    /// Tangent of the virgin material.
    fn initial_tangent(&self) -> f64;
    /// Whether `Stress::damping` is ever used.
    fn is_viscous(&self) -> bool;
    /// Whether the stress depends on the time that passes.
    fn depends_on_time(&self) -> bool;
    /// Whether the stress is proportional to the strain, whatever the history.
    fn is_linear(&self) -> bool;
    /// Strain that recorders show for a strain of the material: a law that begins with a strain counts it in.
    fn shown_strain(&self, strain: f64, _state: &[f64]) -> f64 {
        strain
    }
    /// The material with another value of a parameter, by the words of a `parameter` command, and the value it had;
    /// `None` where it has none of that name. The history has the same words.
    fn with_parameter(&self, _words: &[&str], _value: f64) -> Option<(Material, f64)> {
        None
    }
    /// A response of the material's own, by the words of a recorder command.
    fn probe(&self, words: &[&str]) -> Option<Probe>;
    /// Value of a probe from the state.
    fn read(&self, path: &[u32], state: &[f64], out: &mut [f64]);
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
    #[inline]
    fn update(&self, committed: &[f64], strain: Strain, next: &mut [f64]) -> Result<Stress, MaterialError> {
        let (stress, state) = self.update_on(&L::State::read(committed), &L::State::read(next), strain)?;
        state.write(next);
        Ok(stress)
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
    fn with_parameter(&self, words: &[&str], value: f64) -> Option<(Material, f64)> {
        let mut new = self.clone();
        let old = new.set_parameter(words.first()?, value)?;
        Some((Arc::new(new), old))
    }
    fn probe(&self, words: &[&str]) -> Option<Probe> {
        UniaxialLaw::probe(self, words)
    }
    fn read(&self, path: &[u32], state: &[f64], out: &mut [f64]) {
        UniaxialLaw::read(self, path, &L::State::read(state), out);
    }
}

/// A material as elements hold it: the parameters are shared, the state lies elsewhere.
pub type Material = Arc<dyn Uniaxial>;
