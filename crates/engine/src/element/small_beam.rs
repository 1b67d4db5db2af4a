//! Matrices of an elastic beam with small displacements.

/// A beam with `N` degrees of freedom and `B` basic deformations whose forces are the same linear functions of the
/// displacements at all times, but for P-Delta. Matrices are by rows.
#[derive(Clone, Debug)]
pub struct SmallBeam<'a> {
    /// Length between the joint faces.
    pub length: f64,
    /// Derivatives of the basic deformations by the displacements, B x N.
    pub basic: &'a [f64],
    /// Displacements of the nodes when the beam was created, N.
    pub initial: &'a [f64],
    /// Basic stiffness, B x B. It couples elongation, twist and the bending of a plane with nothing else.
    pub stiffness: &'a [f64],
    /// Derivatives of the local end displacements by the global ones that the reactions of
    /// [`Reactions`](super::transform::Reactions) do work on, N each.
    pub reactions: Vec<&'a [f64]>,
    /// P-Delta effect.
    pub p_delta: Option<PDeltaParts<'a>>,
}

/// Parts of a beam with the P-Delta effect of its axial force.
#[derive(Clone, Debug)]
pub struct PDeltaParts<'a> {
    /// Derivatives of the relative displacements across the beam: of one row of N in the plane, two in space.
    pub across: Vec<Vec<f64>>,
    /// Stiffness without axial force, N x N.
    pub stiffness: &'a [f64],
    /// Geometric stiffness per unit of axial force, N x N.
    pub geometric: &'a [f64],
}
