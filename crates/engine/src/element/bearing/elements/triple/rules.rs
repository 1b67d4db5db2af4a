//! Rules of a triple friction pendulum that differ in OpenSees.

use super::bearing::{HEAT, Load, TriplePendulum, coefficient};
use super::chain::{ChainForce, ChainState};
use super::heated::{Heated, Step, ThermalState};
use crate::element::friction::{Coefficient, Friction};
use crate::element::{ElementResult, Histories};
use crate::material::Stress;
use crate::rules::Consistent;
use crate::state_struct::StateStruct;
use nalgebra::Vector2;
use std::fmt;

/// Vertical displacement of node j minus that of node i, time step, and last strain of the material.
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
    /// The tangent includes the moments.
    const MOMENTS_IN_TANGENT: bool = true;
    /// Recorders give local displacements and basic rotations; else zero.
    const SHOWS_DISPLACEMENTS: bool = true;
    /// The response depends on the number of calls.
    const CALL_DEPENDENT: bool = false;
    /// Rayleigh damping acts on the forces, not on the tangent.
    const DAMPS_IN_FORCES_ONLY: bool = false;

    /// Vertical force in uplift, for a material with the stress `s`.
    ///
    /// # Errors
    /// A material without a stress at this strain.
    fn lifted(
        self,
        bearing: &TriplePendulum<Self>,
        at: Vertical,
        s: Stress,
        _h: &mut Histories<'_>,
    ) -> ElementResult<Stress> {
        let k = if at.apart > 0.0 { bearing.setting.k_tension } else { s.tangent };
        Ok(Stress { value: k * at.apart.max(0.0), tangent: k, damping: 0.0 })
    }

    /// Shear force of the chain at a mean normal force.
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
    ) -> ElementResult<ChainForce> {
        let mean = load.mean;
        let t = bearing.chain.stretch(c, u, dt, |i, speed| coefficient(frictions, i, mean, speed))?;
        (load.speed, load.mu) = (t.friction.map(|f| f.0), t.friction.map(|f| f.1));
        Ok(t)
    }

    /// Shear force of the chain at a mean normal force, with frictional heating.
    ///
    /// # Errors
    /// A chain without a force at this displacement.
    fn heated_shear(
        self,
        (bearing, heated): (&TriplePendulum<Self>, &Heated),
        (u, step): (Vector2<f64>, Step),
        (_before, load): (&Load, &mut Load),
        h: &mut Histories<'_>,
    ) -> ElementResult<ChainForce> {
        let c = ChainState::read(h.committed);
        let (warm, mean) = (ThermalState::read(&h.committed[HEAT..]), load.mean);
        let friction = |i, speed| match mean > 0.0 {
            true => heated.coefficient(&warm, i, mean, speed),
            false => Coefficient::default(),
        };
        let t = bearing.chain.stretch(&c, u, step.dt, friction)?;
        (load.speed, load.mu) = (t.friction.map(|f| f.0), t.friction.map(|f| f.1));
        heated.warm(&t.state, mean, step, &mut h.part(HEAT..));
        Ok(t)
    }

    /// Derivative of the shear force by the vertical displacement, for the vertical force `v` and the shear force
    /// `normal` times `f`.
    fn by_vertical(v: &Stress, f: &Vector2<f64>, normal: f64, by_normal: &Vector2<f64>) -> Vector2<f64> {
        if v.value < 0.0 { -v.tangent * (f + 0.5 * normal * by_normal) } else { Vector2::zeros() }
    }
}

impl Rules for Consistent {}
