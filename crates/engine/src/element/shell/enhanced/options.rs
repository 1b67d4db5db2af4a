//! Choices of a shell with internal modes or drilling rotations.

/// Stiffness against drilling.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Drilling {
    /// Elastic; the fully integrated share of the penalty is 0 to 1 (quadrilaterals).
    Elastic(f64),
    /// Elastic less the damage of the section.
    Damaged,
}

/// Properties of a shell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EnhancedShellOptions {
    /// The axes follow the nodes.
    pub corotational: bool,
    /// The membrane of a quadrilateral has internal modes.
    pub internal: bool,
    /// A triangle has one point and a drilling penalty instead of three points without one.
    pub reduced: bool,
    /// Drilling stiffness.
    pub drilling: Drilling,
    /// Direction of axis 1 of the section, to be projected onto the shell.
    pub axis: Option<[f64; 3]>,
    /// As in OpenSees 3.7, axis 1 of the section is square to the side from node 1 to node 2 where none is given, and the
    /// transverse shear strains turn the other way round.
    pub opensees_axes: bool,
    /// Increments of rotation start from the last trial state, and the tangent is that of fixed axes, as in OpenSees.
    pub by_trials: bool,
}
