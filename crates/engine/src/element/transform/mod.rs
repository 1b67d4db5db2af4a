//! Coordinate transformations of beams: from the displacements of the nodes to the deformations of the basic system,
//! and from basic forces and stiffness back (`geomTransf`).
//!
//! The basic system of a beam in the plane has an elongation and two end rotations; in space an elongation, the end
//! rotations about z (i, j), those about y (i, j), and the twist.

mod corotational_2d;
mod corotational_3d;
mod frame;
mod linear;

use crate::element::ElementError;
use crate::element::axes::AxesError;
use nalgebra::Vector3;
use std::fmt;
use std::sync::Arc;

pub use corotational_2d::Corotational2d;
pub use corotational_3d::Corotational3d;
pub use frame::Frame;
pub use linear::{Linear, PDelta};

/// End reactions of a simple beam under member loads, in local axes: axial at i, y at i and j, z at i and j.
pub type Reactions = [f64; 5];

/// A transformation for beams with `N` degrees of freedom and `B` basic deformations.
pub trait Transform<const N: usize, const B: usize>: fmt::Debug + Send + Sync {
    /// Undeformed length between the joints' faces.
    fn length(&self) -> f64;
    /// Whether force and stiffness do not depend on the displacements.
    fn is_linear(&self) -> bool;
    /// Whether displacements are small: deformations are linear in them, and the stiffness of the geometry is
    /// proportional to the axial force.
    fn is_small(&self) -> bool {
        true
    }
    /// Whether the stiffness is symmetric: where large rotations in space meet moments it is not.
    fn is_symmetric(&self) -> bool {
        true
    }
    /// Number of words of history: that of large rotations in space.
    fn state_len(&self) -> usize {
        0
    }
    /// Write the virgin state.
    fn init(&self, _state: &mut [f64]) {}
    /// Write the history at trial displacements, which the other methods are given; must come first.
    ///
    /// # Errors
    /// The ends have met.
    fn advance(&self, _disp: &[f64], _committed: &[f64], _trial: &mut [f64]) -> Result<(), ElementError> {
        Ok(())
    }
    /// Basic deformations of global displacements (those at the making of the element included).
    fn deformation(&self, disp: &[f64], state: &[f64]) -> [f64; B];
    /// Add the global forces of the basic forces `q` and the reactions `p0`.
    fn add_force(&self, disp: &[f64], state: &[f64], q: &[f64; B], p0: &Reactions, force: &mut [f64]);
    /// Add the global stiffness of the basic stiffness `kb`, that of the geometry included.
    fn add_tangent(&self, disp: &[f64], state: &[f64], kb: &[[f64; B]; B], q: &[f64; B], tangent: &mut [f64]);
    /// Add what [`Transform::add_tangent`] leaves out of the derivative of the forces to keep it symmetric: nothing, where
    /// it is the whole derivative.
    fn add_unsymmetric_tangent(&self, _disp: &[f64], _kb: &[[f64; B]; B], _tangent: &mut [f64]) {}
    /// Undeformed geometry, for masses and local forces.
    fn frame(&self) -> &Frame<N, B>;
}

/// Which transformation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TransformKind {
    /// Small displacements.
    Linear,
    /// Small displacements with the P-Delta effect of the axial force.
    PDelta,
    /// Large displacements, small deformations.
    Corotational,
}

/// A transformation as `geomTransf` defines it: what an element needs to make its own.
#[derive(Clone, Debug, PartialEq)]
pub struct TransformSpec {
    /// Which one.
    pub kind: TransformKind,
    /// A vector in the local x-z plane; only in space.
    pub xz: Vector3<f64>,
    /// Rigid joint offsets from node i and from node j, in global axes.
    pub offsets: (Vector3<f64>, Vector3<f64>),
    /// As in OpenSees, large rotations in space are the sum of those of all trial states instead of those of all steps.
    pub by_trials: bool,
}

/// Where a beam stands: coordinates of its nodes, and their displacements when it is made (it measures from there).
#[derive(Clone, Copy, Debug)]
pub struct Ends<'a> {
    /// Coordinates of i and j.
    pub place: (Vector3<f64>, Vector3<f64>),
    /// Displacements of all degrees of freedom of i, then of j.
    pub disp: &'a [f64],
}

impl TransformSpec {
    /// For a beam in the plane.
    ///
    /// # Errors
    /// No length between the ends.
    pub fn plane(&self, ends: &Ends<'_>) -> Result<Arc<dyn Transform<6, 3>>, AxesError> {
        let frame = Frame::plane(ends, &self.offsets)?;
        Ok(match self.kind {
            TransformKind::Linear => Arc::new(Linear(frame)),
            TransformKind::PDelta => Arc::new(PDelta(frame)),
            TransformKind::Corotational => Arc::new(Corotational2d(frame)),
        })
    }

    /// For a beam in space.
    ///
    /// # Errors
    /// No length between the ends, or a vector `xz` along the beam.
    pub fn space(&self, ends: &Ends<'_>) -> Result<Arc<dyn Transform<12, 6>>, AxesError> {
        let frame = Frame::space(ends, &self.offsets, self.xz)?;
        Ok(match self.kind {
            TransformKind::Linear => Arc::new(Linear(frame)),
            TransformKind::PDelta => Arc::new(PDelta(frame)),
            TransformKind::Corotational => Arc::new(Corotational3d::new(frame, self.offsets, self.by_trials)),
        })
    }
}
