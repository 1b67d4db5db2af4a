//! Contact of two nodes with friction and a bilinear hysteretic stiffness: `zeroLengthImpact3D` (Zaghi and Cashany, 2012;
//! the normal law is that of Muthukumar and DesRoches, 2006, Earthquake Engineering and Structural Dynamics 35, 811-828).

use super::contact::{CONTACT_DOFS as DOFS, ContactDirection, ContactFriction, in_space};
use super::{Class, Element, ElementInput, ElementOutput, ElementResult, ElementTraits, Histories, Snapshot};
use crate::element::roles::Roles;
use crate::probe::Probe;
use crate::state_struct::StateStruct;
use nalgebra::Vector3;

/// Properties of a contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ImpactOptions {
    /// Direction.
    pub direction: ContactDirection,
    /// Gap, length.
    pub gap: f64,
    /// Coefficient of friction.
    pub friction: f64,
    /// Tangential stiffness, force/length.
    pub tangential: f64,
    /// Normal stiffness before and after the yield penetration.
    pub normal: [f64; 2],
    /// Yield penetration, length.
    pub yield_penetration: f64,
    /// Cohesion, force.
    pub cohesion: f64,
}

/// A contact of a secondary and a primary node at one place.
#[derive(Clone, Debug)]
pub struct Impact {
    options: ImpactOptions,
    places: [Vector3<f64>; 2],
}

crate::state_struct! {
    /// State variables: penetration and pressure of the last contact, and the tangential displacements from which the
    /// friction counts.
    struct ContactState {
        penetration: f64,
        pressure: f64,
        stick: [f64; 2],
    }
}

impl Impact {
    /// Makes a contact of the secondary and the primary node at their places.
    pub fn new(options: ImpactOptions, places: [Vector3<f64>; 2]) -> Self {
        Self { options, places }
    }

    fn friction(&self) -> ContactFriction {
        let ImpactOptions { tangential, friction, cohesion, .. } = self.options;
        ContactFriction { tangential, friction, cohesion }
    }

    /// Pressure and its derivative by the penetration.
    fn pressure(&self, penetration: f64, old: &ContactState) -> (f64, f64) {
        let [k1, k2] = self.options.normal;
        let change = penetration - old.penetration;
        let elastic = old.pressure + k1 * change;
        let upper = k1 * self.options.yield_penetration + k2 * (penetration - self.options.yield_penetration);
        let lower = k2 * penetration;
        match () {
            () if penetration <= 0.0 => (0.0, 0.0),
            () if change > 0.0 && elastic > upper => (upper, k2),
            () if change < 0.0 && elastic < lower => (lower, k2),
            () => (elastic, k1),
        }
    }

    /// Force, tangent on demand, and the next state.
    fn contact(&self, u: &[f64], old: &ContactState, force: &mut [f64], tangent: Option<&mut [f64]>) -> ContactState {
        let moved = [0, 1].map(|i| self.places[i] + Vector3::from_column_slice(&u[3 * i..3 * i + 3]));
        let (gap, rows) = in_space(self.options.direction, moved);
        let penetration = gap - self.options.gap;
        // Without contact the last one stays in memory.
        if penetration.is_nan() || penetration < 0.0 {
            return *old;
        }
        let (pressure, stiffness) = self.pressure(penetration, old);
        let stick = self.friction().add(&rows, u, (pressure, stiffness), old.stick, force, tangent);
        ContactState { penetration, pressure, stick }
    }
}

crate::watches_columns!(Impact => nothing);

impl Element for Impact {
    fn class(&self) -> Class {
        // OpenSees gives it the number of the contact in space.
        Class::new("ZeroLengthImpact3D", 23)
    }
    fn dofs(&self) -> usize {
        DOFS
    }
    fn state_len(&self) -> usize {
        ContactState::LEN
    }
    fn init(&self, state: &mut [f64]) {
        state.fill(0.0);
    }
    fn traits(&self) -> ElementTraits {
        ElementTraits { linear: false, symmetric: false, viscous: false, elapses: false, rayleigh: false }
    }

    fn respond(&self, m: &ElementInput<'_>, h: &mut Histories<'_>, output: ElementOutput<'_>) -> ElementResult {
        output.force.fill(0.0);
        self.contact(m.disp, &ContactState::read(h.committed), output.force, output.tangent).write(h.trial);
        Ok(())
    }

    fn initial_tangent(&self, tangent: &mut [f64]) {
        self.contact(&[0.0; DOFS], &ContactState::default(), &mut [0.0; DOFS], Some(tangent));
    }
    fn roles(&self) -> Roles<'_> {
        Roles { renews_tangent: true, ..Roles::default() }
    }

    fn probe(&self, _: &[&str]) -> Option<Probe> {
        None
    }
    fn probe_names(&self) -> Vec<&'static str> {
        vec![]
    }
    fn read(&self, _: &[u32], _: &Snapshot<'_>, _: &mut [f64]) {}
}
