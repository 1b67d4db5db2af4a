//! Elastomeric bearing of two springs and a rigid column between them: shear with yielding, and buckling under the axial
//! load (Ryan, Kelly and Chopra, 2005).

use super::plain_methods::plain_methods;
use super::{Resultant, Section, SectionStep};
use crate::material::{MaterialError, MaterialResult};
use crate::state_struct::StateStruct;
use nalgebra::{SMatrix, SVector};

/// Largest number of iterations.
const MAX_ITERATIONS: usize = 20;
/// Largest residual that is accepted where the tolerance is not reached, as a part of the forces.
const ACCEPTED: f64 = 1e-6;
/// Axial load below which the strength does not depend on it.
const MIN_REFERENCE: f64 = 1e-10;

const RESULTANTS: [Resultant; 3] = [Resultant::P, Resultant::Vy, Resultant::Mz];

type Vector5 = SVector<f64, 5>;

/// A bearing whose first deformation is that in shear, and whose second is that along its axis.
#[derive(Clone, Debug, PartialEq)]
pub struct TwoSpringIsolator {
    /// Tolerance of the residual.
    pub tolerance: f64,
    /// Initial stiffness in shear.
    pub k1: f64,
    /// Strength in shear.
    pub strength: f64,
    /// Stiffness in shear after yielding.
    pub k2: f64,
    /// Vertical stiffness.
    pub kv: f64,
    /// Height.
    pub height: f64,
    /// Euler load.
    pub euler: f64,
    /// Axial load that the strength grows with; 0 for a constant strength.
    pub reference: f64,
}

crate::state_struct! {
    /// History of [`TwoSpringIsolator`].
    struct History {
        /// Shear force, axial force, shear deformation, rotation and axial deformation of the springs.
        springs: [f64; 5],
        /// Plastic deformation.
        plastic: f64,
        /// Back force.
        back: f64,
    }
}

/// Response of the shear spring.
struct ShearSpring {
    force: f64,
    tangent: f64,
    plastic: f64,
    back: f64,
}

impl TwoSpringIsolator {
    fn shear(&self, c: &History, s: f64, axial: f64) -> ShearSpring {
        let strength = if self.reference < MIN_REFERENCE {
            self.strength
        } else {
            self.strength * (1.0 - (-(axial / self.reference).max(0.0)).exp())
        };
        let hardening = self.k1 * self.k2 / (self.k1 - self.k2);
        let trial = self.k1 * (s - c.plastic);
        let xi = trial - c.back;
        let excess = xi.abs() - strength;
        if excess <= 0.0 {
            return ShearSpring { force: trial, tangent: self.k1, plastic: c.plastic, back: c.back };
        }
        let flow = excess / (self.k1 + hardening) * if xi < 0.0 { -1.0 } else { 1.0 };
        let (plastic, back) = (c.plastic + flow, c.back + flow * hardening);
        ShearSpring { force: trial - flow * self.k1, tangent: self.k2, plastic, back }
    }

    /// Residual of equilibrium and kinematics.
    fn residual(&self, x: &Vector5, u: [f64; 2], shear: f64) -> Vector5 {
        let [f, p, s, rotation, axial] = [x[0], x[1], x[2], x[3], x[4]];
        let h = self.height;
        Vector5::new(
            f - shear + p * rotation,
            f * h - self.euler * h * rotation + p * (s + h * rotation),
            p - self.kv * axial,
            u[0] - s - h * rotation,
            -u[1] - s * rotation - h / 2.0 * rotation * rotation - axial,
        )
    }

    fn jacobian(&self, x: &Vector5, tangent: f64) -> SMatrix<f64, 5, 5> {
        let [p, s, rotation] = [x[1], x[2], x[3]];
        let h = self.height;
        let arm = s + h * rotation;
        #[rustfmt::skip]
        let rows = [
            1.0, rotation, -tangent, p, 0.0,
            h, arm, p, (p - self.euler) * h, 0.0,
            0.0, 1.0, 0.0, 0.0, -self.kv,
            0.0, 0.0, -1.0, -h, 0.0,
            0.0, 0.0, -rotation, -arm, -1.0,
        ];
        SMatrix::from_row_slice(&rows)
    }
}

fn no_equilibrium(u: [f64; 2]) -> MaterialError {
    MaterialError(format!("Isolator2spring finds no equilibrium at {:.6e}, {:.6e}: it buckles", u[0], u[1]))
}

crate::watches_columns!(TwoSpringIsolator => nothing);

impl Section for TwoSpringIsolator {
    plain_methods! { init is_linear depends_on_time elastic joined with_parameter probe }
    fn class(&self) -> &'static str {
        "Isolator2spring"
    }
    fn resultants(&self) -> &[Resultant] {
        &RESULTANTS
    }
    fn state_len(&self) -> usize {
        History::LEN
    }

    fn update(&self, step: SectionStep<'_>) -> MaterialResult {
        let SectionStep { committed, e, next, s, k, .. } = step;
        let c = History::read(committed);
        let (u, h) = ([e[0], e[1]], self.height);
        let mut x = Vector5::from(c.springs);
        let mut spring = self.shear(&c, x[2], x[1]);
        let mut residual = self.residual(&x, u, spring.force);
        let mut iterations = 0;
        while residual.norm() > self.tolerance && iterations < MAX_ITERATIONS {
            iterations += 1;
            let inverse = self.jacobian(&x, spring.tangent).try_inverse().ok_or_else(|| no_equilibrium(u))?;
            x -= inverse * residual;
            spring = self.shear(&c, x[2], x[1]);
            residual = self.residual(&x, u, spring.force);
        }
        let (shear, p, arm, rotation) = (x[0], x[1], x[2] + h * x[3], x[3]);
        let scale = self.tolerance + ACCEPTED * (shear.abs() + p.abs()) * (1.0 + h);
        if !residual.norm().is_finite() || residual.norm() > scale {
            return Err(no_equilibrium(u));
        }
        // Flexibility of the springs, then of their deformations with the height of the column.
        let tangent = spring.tangent;
        let d = h * tangent * (self.euler - p) - p * p;
        let [a, b, g] = [(self.euler - p) * h / d, p / d, tangent / d];
        let f00 = a + 2.0 * h * b + h * h * g;
        let f01 = -rotation * (a + h * b) - arm * (b + h * g);
        let f11 = rotation * rotation * a + 2.0 * rotation * arm * b + arm * arm * g + 1.0 / self.kv;
        let det = f00 * f11 - f01 * f01;
        k.fill(0.0);
        (k[0], k[1], k[3], k[4]) = (f11 / det, -f01 / det, -f01 / det, f00 / det);
        s.copy_from_slice(&[shear, -p, (p * u[0] + shear * h) / 2.0]);
        let springs = std::array::from_fn(|i| x[i]);
        History { springs, plastic: spring.plastic, back: spring.back }.write(next);
        Ok(())
    }

    fn initial_stiffness(&self, k: &mut [f64]) {
        k.fill(0.0);
        (k[0], k[4]) = (self.k1, self.kv);
    }
}
