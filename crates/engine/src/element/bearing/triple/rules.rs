//! The places where a triple friction pendulum has other rules in OpenSees.

use super::bearing::{HEAT, Load, TriplePendulum, coefficient};
use super::chain::{ChainState, Tension};
use super::heated::{Heated, Step, Warm};
use crate::element::ElementError;
use crate::element::friction::{Coefficient, Friction};
use crate::material::Stress;
use crate::rules::Consistent;
use crate::state_struct::StateStruct;
use nalgebra::Vector2;
use std::fmt;

/// Vertical motion of node j less that of node i: displacement, rate, time of the step, and the last strain of the material.
#[derive(Clone, Copy, Debug)]
pub struct Vertical {
    pub(super) apart: f64,
    pub(super) dt: f64,
    pub(super) last: f64,
}

/// Rules of [`TriplePendulum`] that differ in OpenSees.
pub trait Rules: Copy + fmt::Debug + PartialEq + Send + Sync + 'static {
    /// Sign of the moments of the rotational materials at node i.
    const MOMENT_AT_I: f64 = -1.0;
    /// The moments are part of the tangent.
    const MOMENTS_IN_TANGENT: bool = true;
    /// Recorders show the local displacements, and rotations of the basic ones.
    const SHOWS_DISPLACEMENTS: bool = true;
    /// The element depends on the number of calls.
    const COUNTS_CALLS: bool = false;
    /// Rayleigh damping is part of the forces, not of the tangent.
    const DAMPS_IN_FORCES_ONLY: bool = false;

    /// Vertical force of a bearing that is lifted, where the material has the stress `s`.
    ///
    /// # Errors
    /// A material without a stress at this strain.
    fn lifted(
        self,
        bearing: &TriplePendulum<Self>,
        at: Vertical,
        s: Stress,
        _committed: &[f64],
        _trial: &mut [f64],
    ) -> Result<Stress, ElementError> {
        let k = if at.apart > 0.0 { bearing.setting.k_tension } else { s.tangent };
        Ok(Stress { value: k * at.apart.max(0.0), tangent: k, damping: 0.0 })
    }

    /// The chain under a mean normal force.
    ///
    /// # Errors
    /// A chain without a force at this displacement.
    fn shear(
        self,
        bearing: &TriplePendulum<Self>,
        (u, dt): (Vector2<f64>, f64),
        (c, _last): (&ChainState, &ChainState),
        load: &mut Load,
        frictions: &[Friction; 3],
    ) -> Result<Tension, ElementError> {
        let mean = load.mean;
        let t = bearing.chain.stretch(c, u, dt, |i, speed| coefficient(frictions, i, mean, speed))?;
        (load.speed, load.mu) = (t.friction.map(|f| f.0), t.friction.map(|f| f.1));
        Ok(t)
    }

    /// The chain under a mean normal force, with surfaces that warm.
    ///
    /// # Errors
    /// A chain without a force at this displacement.
    fn heated_shear(
        self,
        (bearing, heated): (&TriplePendulum<Self>, &Heated),
        (u, step): (Vector2<f64>, Step),
        (_before, load): (&Load, &mut Load),
        committed: &[f64],
        trial: &mut [f64],
    ) -> Result<Tension, ElementError> {
        let c = ChainState::read(committed);
        let (committed, trial) = (&committed[HEAT..], &mut trial[HEAT..]);
        let (warm, mean) = (Warm::read(committed), load.mean);
        let friction = |i, speed| match mean > 0.0 {
            true => heated.coefficient(&warm, i, mean, speed),
            false => Coefficient::default(),
        };
        let t = bearing.chain.stretch(&c, u, step.dt, friction)?;
        (load.speed, load.mu) = (t.friction.map(|f| f.0), t.friction.map(|f| f.1));
        heated.warm(&t.state, mean, step, committed, trial);
        Ok(t)
    }

    /// Derivative of the shear by the vertical displacement, where the vertical force is `v` and the shear `normal` times `f`.
    fn by_vertical(v: &Stress, f: &Vector2<f64>, normal: f64, by_normal: &Vector2<f64>) -> Vector2<f64> {
        if v.value < 0.0 { -v.tangent * (f + 0.5 * normal * by_normal) } else { Vector2::zeros() }
    }
}

impl Rules for Consistent {}
