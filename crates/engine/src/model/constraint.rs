//! Constraints of the domain.

use super::{NodeId, Tag};

/// A degree of freedom held where it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Fix {
    /// Node.
    pub node: NodeId,
    /// Local degree of freedom, from 0.
    pub dof: usize,
    /// Number by which OpenSees' `remove sp` knows it.
    pub tag: Tag,
}

/// Degrees of freedom of one node as linear functions of those of another: u_c = C u_r.
#[derive(Clone, Debug, PartialEq)]
pub struct MultiPoint {
    /// The node whose motion follows.
    pub constrained: NodeId,
    /// The node that leads.
    pub retained: NodeId,
    /// Local degrees of freedom of the constrained node, from 0.
    pub constrained_dofs: Vec<usize>,
    /// Local degrees of freedom of the retained node, from 0.
    pub retained_dofs: Vec<usize>,
    /// C by rows: as many rows as constrained, as many columns as retained degrees of freedom.
    pub matrix: Vec<f64>,
    /// Number by which OpenSees' `remove mp` knows it.
    pub tag: Tag,
}

impl MultiPoint {
    /// Row of a constrained degree of freedom: (retained local degree of freedom, coefficient).
    pub fn row(&self, i: usize) -> impl Iterator<Item = (usize, f64)> + '_ {
        let n = self.retained_dofs.len();
        self.retained_dofs.iter().copied().zip(self.matrix[i * n..(i + 1) * n].iter().copied())
    }

    /// Returns true if every constrained degree of freedom is equal to one retained degree of freedom.
    pub fn is_identity(&self) -> bool {
        (0..self.constrained_dofs.len()).all(|i| {
            let mut nonzero = self.row(i).filter(|(_, c)| *c != 0.0);
            matches!((nonzero.next(), nonzero.next()), (Some((_, 1.0)), None))
        })
    }
}
