//! Contact of two nodes with friction and a bilinear hysteretic stiffness: `zeroLengthImpact3D` (Zaghi and Cashany, 2012;
//! the normal law is that of Muthukumar and DesRoches, 2006, Earthquake Engineering and Structural Dynamics 35, 811-828).

use super::{Element, ElementError, ElementInput, ElementOutput, ElementTraits, Snapshot, add_outer, dot};
use crate::numeric::axpy;
use crate::probe::Probe;
use crate::state_struct::StateStruct;
use nalgebra::Vector3;

const DOFS: usize = 6;

/// Direction of a contact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ContactDirection {
    /// Around the axis z through the origin, the secondary node inside of the primary one.
    Circular,
    /// Along an axis, 0 to 2: the normal of the primary surface points along it.
    Axis(usize),
}

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

/// Penetration, and derivatives of the normal and two tangential displacements.
struct Kinematics {
    penetration: f64,
    rows: [[f64; DOFS]; 3],
}

impl Impact {
    /// Makes a contact of the secondary and the primary node at their places.
    pub fn new(options: ImpactOptions, places: [Vector3<f64>; 2]) -> Self {
        Self { options, places }
    }

    fn kinematics(&self, u: &[f64]) -> Kinematics {
        let moved = [0, 1].map(|i| self.places[i] + Vector3::from_column_slice(&u[3 * i..3 * i + 3]));
        let pair = |v: Vector3<f64>| [v.x, v.y, v.z, -v.x, -v.y, -v.z];
        let (gap, directions) = match self.options.direction {
            ContactDirection::Axis(axis) => {
                let unit = |i: usize| Vector3::from_fn(|row, _| f64::from(u8::from(row == i % 3)));
                (moved[1][axis] - moved[0][axis], [axis, axis + 1, axis + 2].map(unit))
            }
            ContactDirection::Circular => {
                let radius = |v: &Vector3<f64>| v.x.hypot(v.y);
                let r = radius(&moved[1]);
                let radial = Vector3::new(moved[1].x / r, moved[1].y / r, 0.0);
                let round = Vector3::new(-radial.y, radial.x, 0.0);
                (radius(&moved[0]) - r, [-radial, Vector3::z(), round])
            }
        };
        Kinematics { penetration: gap - self.options.gap, rows: directions.map(pair) }
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
        let Kinematics { penetration, rows: [n, t1, t2] } = self.kinematics(u);
        // Without contact the last one stays in memory.
        if penetration.is_nan() || penetration < 0.0 {
            return *old;
        }
        let (pressure, stiffness) = self.pressure(penetration, old);
        let slid = [dot(&t1, u), dot(&t2, u)];
        let trial = [0, 1].map(|i| self.options.tangential * (slid[i] - old.stick[i]));
        let (size, limit) = (trial[0].hypot(trial[1]), self.options.friction * pressure + self.options.cohesion);
        let slides = size > limit;
        let share = if slides { limit / size } else { 1.0 };
        axpy(-pressure, &n, force);
        axpy(share * trial[0], &t1, force);
        axpy(share * trial[1], &t2, force);
        if let Some(k) = tangent {
            add_outer(k, &n, stiffness);
            let along = share * self.options.tangential;
            add_outer(k, &t1, along);
            add_outer(k, &t2, along);
            if slides {
                let mut direction = [0.0; DOFS];
                axpy(trial[0] / size, &t1, &mut direction);
                axpy(trial[1] / size, &t2, &mut direction);
                add_outer(k, &direction, -along);
                for (row, d) in k.chunks_exact_mut(DOFS).zip(&direction) {
                    axpy(-self.options.friction * stiffness * d, &n, row);
                }
            }
        }
        ContactState { penetration, pressure, stick: if slides { slid } else { old.stick } }
    }
}

impl Element for Impact {
    fn class(&self) -> &'static str {
        "ZeroLengthImpact3D"
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

    fn respond(
        &self,
        m: &ElementInput<'_>,
        committed: &[f64],
        trial: &mut [f64],
        output: ElementOutput<'_>,
    ) -> Result<(), ElementError> {
        output.force.fill(0.0);
        self.contact(m.disp, &ContactState::read(committed), output.force, output.tangent).write(trial);
        Ok(())
    }

    fn initial_tangent(&self, tangent: &mut [f64]) {
        self.contact(&[0.0; DOFS], &ContactState::default(), &mut [0.0; DOFS], Some(tangent));
    }
    fn probe(&self, _: &[&str]) -> Option<Probe> {
        None
    }
    fn probe_names(&self) -> &'static [&'static str] {
        &[]
    }
    fn read(&self, _: &[u32], _: &Snapshot<'_>, _: &mut [f64]) {}
}
