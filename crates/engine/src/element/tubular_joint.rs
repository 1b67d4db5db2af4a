//! Flexibility of the joint of a brace and a chord of an offshore platform: `ElasticTubularJoint`.

use super::{
    Class, Element, ElementError, ElementInput, ElementOutput, ElementResult, ElementTraits, Histories, Snapshot,
    add_outer, dot,
};
use crate::element::roles::{ForceLabels, Roles};
use crate::probe::Probe;
use std::f64::consts::FRAC_PI_2;

const DOFS: usize = 6;

/// A brace at a chord of tubes in the plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TubularJointOptions {
    /// Diameter of the brace, length.
    pub brace_diameter: f64,
    /// Angle between brace and chord, degrees.
    pub brace_angle: f64,
    /// Modulus of elasticity.
    pub e: f64,
    /// Diameter of the chord, length.
    pub chord_diameter: f64,
    /// Wall of the chord, length.
    pub chord_thickness: f64,
    /// Angle between the chord and the axis x, degrees.
    pub chord_angle: f64,
}

/// Elastic flexibility of the wall of a chord, across it and in bending in the plane, by the formulas of Fessler, Mockford and
/// Webster (Proceedings of the Institution of Civil Engineers 81 (1986) 675). Along the chord the joint is stiff: by
/// 1.6e16, the tangent of a right angle in double precision, as in OpenSees.
#[derive(Clone, Debug)]
pub struct TubularJoint {
    /// Deformations per displacement: along the chord, across it, rotation.
    rows: [[f64; DOFS]; 3],
    stiffness: [f64; 3],
}

impl TubularJoint {
    /// Makes the joint between the axis of the chord and its wall, at `[dx, dy]` from it.
    ///
    /// # Errors
    /// The nodes are at one place, or the dimensions give no flexibility.
    pub fn new(o: &TubularJointOptions, [dx, dy]: [f64; 2]) -> ElementResult<Self> {
        if dx.hypot(dy) == 0.0 {
            return Err(ElementError("ElasticTubularJoint: its nodes are at one place".into()));
        }
        let (gamma, beta) = (o.chord_diameter / (2.0 * o.chord_thickness), o.brace_diameter / o.chord_diameter);
        let sine = o.brace_angle.to_radians().sin();
        let across = 1.95 * gamma.powf(2.15) * (1.0 - beta).powf(1.3) * sine.powf(0.19) / (o.e * o.chord_diameter);
        let bending =
            134.0 * gamma.powf(1.73) * (-4.52 * beta).exp() * sine.powf(1.22) / (o.e * o.chord_diameter.powi(3));
        let stiffness = [FRAC_PI_2.tan(), across.recip(), bending.recip()];
        if stiffness.iter().any(|k| !k.is_finite() || *k <= 0.0) {
            return Err(ElementError("ElasticTubularJoint: its dimensions give no flexibility".into()));
        }
        let (s, c) = (90.0 - o.chord_angle).to_radians().sin_cos();
        // The end of an arm that turns with the first node meets the second node.
        let row = |x: f64, y: f64| [-x, -y, x * dy - y * dx, x, y, 0.0];
        Ok(Self { rows: [row(s, c), row(c, -s), [0.0, 0.0, -1.0, 0.0, 0.0, 1.0]], stiffness })
    }
}

crate::watches_columns!(TubularJoint => nothing);

impl Element for TubularJoint {
    fn class(&self) -> Class {
        // The number stands in its own file of OpenSees.
        Class::new("ElasticTubularJoint", 2519)
    }
    fn dofs(&self) -> usize {
        DOFS
    }
    fn state_len(&self) -> usize {
        0
    }
    fn init(&self, _: &mut [f64]) {}
    fn traits(&self) -> ElementTraits {
        ElementTraits { linear: true, symmetric: true, viscous: false, elapses: false, rayleigh: true }
    }

    fn respond(&self, motion: &ElementInput<'_>, _: &mut Histories<'_>, output: ElementOutput<'_>) -> ElementResult {
        for (row, k) in self.rows.iter().zip(self.stiffness) {
            let force = k * dot(row, motion.disp);
            output.force.iter_mut().zip(row).for_each(|(f, r)| *f += force * r);
        }
        if let Some(k) = output.tangent {
            self.initial_tangent(k);
        }
        Ok(())
    }

    fn initial_tangent(&self, tangent: &mut [f64]) {
        self.rows.iter().zip(self.stiffness).for_each(|(row, k)| add_outer(tangent, row, k));
    }

    fn roles(&self) -> Roles<'_> {
        Roles { force_labels: ForceLabels::Frame, ..Roles::default() }
    }

    fn probe(&self, _: &[&str]) -> Option<Probe> {
        None
    }
    fn probe_names(&self) -> Vec<&'static str> {
        vec![]
    }
    fn read(&self, _: &[u32], _: &Snapshot<'_>, _: &mut [f64]) {}
}
