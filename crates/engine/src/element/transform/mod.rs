//! Coordinate transformations of beams (`geomTransf`): from nodal displacements to basic deformations, and from basic
//! forces and stiffness to nodal ones.
//!
//! Basic deformations in the plane are the elongation and two end rotations. In space they are the elongation, the end
//! rotations about z (i, j) and about y (i, j), and the twist.

mod corotational_2d;
mod corotational_3d;
mod frame;
mod linear;

use crate::element::axes::AxesError;
use crate::element::{ElementResult, Histories};
use nalgebra::Vector3;
use std::fmt;
use std::sync::Arc;

pub use corotational_2d::Corotational2d;
pub use corotational_3d::Corotational3d;
pub use frame::{Frame, axis_probe};
pub use linear::{Linear, PDelta};

/// End reactions of a simple beam to member loads in local axes: axial at i, y at i and j, z at i and j.
pub type Reactions = [f64; 5];

/// A transformation for beams with `N` degrees of freedom and `B` basic deformations.
pub trait Transform<const N: usize, const B: usize>: fmt::Debug + Send + Sync {
    /// Undeformed length between the joint faces.
    fn length(&self) -> f64;
    /// Returns true if force and stiffness are independent of the displacements.
    fn is_linear(&self) -> bool;
    /// Returns true for small displacements: deformations are linear in them, and the geometric stiffness is
    /// proportional to the axial force.
    fn is_small(&self) -> bool {
        true
    }
    /// Returns true if the stiffness is symmetric. With large rotations and moments in space it is not.
    fn is_symmetric(&self) -> bool {
        true
    }
    /// Number of state variables; 0 except for large rotations in space.
    fn state_len(&self) -> usize {
        0
    }
    /// Writes the virgin state variables.
    fn init(&self, _state: &mut [f64]) {}
    /// Writes the state variables for trial displacements. The other methods use them, so it must be called first.
    ///
    /// # Errors
    /// The ends coincide.
    fn advance(&self, _disp: &[f64], _: &mut Histories<'_>) -> ElementResult {
        Ok(())
    }
    /// Basic deformations for global displacements, which include those at the creation of the element.
    fn deformation(&self, disp: &[f64], state: &[f64]) -> [f64; B];
    /// Adds the global forces of the basic forces `q` and the reactions `p0`.
    fn add_force(&self, disp: &[f64], state: &[f64], q: &[f64; B], p0: &Reactions, force: &mut [f64]);
    /// Adds the global stiffness of the basic stiffness `kb`, with the geometric stiffness.
    fn add_tangent(&self, disp: &[f64], state: &[f64], kb: &[[f64; B]; B], q: &[f64; B], tangent: &mut [f64]);
    /// Adds the unsymmetric terms that [`Transform::add_tangent`] omits from the derivative of the forces, if any.
    fn add_unsymmetric_tangent(&self, _disp: &[f64], _kb: &[[f64; B]; B], _tangent: &mut [f64]) {}
    /// Undeformed geometry, for masses and local forces.
    fn frame(&self) -> &Frame<N, B>;
}

/// Kind of a transformation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TransformKind {
    /// Small displacements.
    Linear,
    /// Small displacements with the P-Delta effect of the axial force.
    PDelta,
    /// Large displacements, small deformations.
    Corotational,
}

/// Definition of a transformation by `geomTransf`, from which an element makes its own.
#[derive(Clone, Debug, PartialEq)]
pub struct TransformSpec {
    /// Kind.
    pub kind: TransformKind,
    /// A vector in the local x-z plane; used in space only.
    pub xz: Vector3<f64>,
    /// Rigid joint offsets at node i and node j, in global axes.
    pub offsets: (Vector3<f64>, Vector3<f64>),
    /// As in OpenSees, large rotations in space are summed over trial states instead of steps.
    pub by_trials: bool,
}

/// Ends of a beam: coordinates of its nodes, and their displacements when it is created, which are subtracted.
#[derive(Clone, Copy, Debug)]
pub struct Ends<'a> {
    /// Coordinates of i and j.
    pub place: (Vector3<f64>, Vector3<f64>),
    /// Displacements of all degrees of freedom of i, then of j.
    pub disp: &'a [f64],
}

impl TransformSpec {
    /// Makes the transformation of a beam in the plane.
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

    /// Makes the transformation of a beam in space.
    ///
    /// # Errors
    /// No length between the ends, or `xz` parallel to the beam.
    pub fn space(&self, ends: &Ends<'_>) -> Result<Arc<dyn Transform<12, 6>>, AxesError> {
        let frame = Frame::space(ends, &self.offsets, self.xz)?;
        Ok(match self.kind {
            TransformKind::Linear => Arc::new(Linear(frame)),
            TransformKind::PDelta => Arc::new(PDelta(frame)),
            TransformKind::Corotational => Arc::new(Corotational3d::new(frame, self.offsets, self.by_trials)),
        })
    }
}
