//! Nodes.

use super::Tag;
use nalgebra::Vector3;
use std::ops::Range;

/// A point with degrees of freedom.
#[derive(Clone, Debug, PartialEq)]
pub struct Node {
    /// Tag in the script.
    pub tag: Tag,
    /// Coordinates, as many as the model has dimensions.
    pub coords: Vec<f64>,
    /// Number of degrees of freedom.
    pub ndf: usize,
    /// Global number of the first of them.
    pub offset: usize,
    /// Lumped mass of each degree of freedom.
    pub mass: Vec<f64>,
    /// Mass-proportional damping of the lumped mass.
    pub alpha_m: f64,
}

impl Node {
    /// A node without mass.
    pub fn new(tag: Tag, coords: &[f64], ndf: usize, offset: usize) -> Self {
        Self { tag, coords: coords.to_vec(), ndf, offset, mass: vec![0.0; ndf], alpha_m: 0.0 }
    }

    /// Number of dimensions.
    pub fn ndm(&self) -> usize {
        self.coords.len()
    }

    /// Place in space; missing coordinates are zero.
    pub fn place(&self) -> Vector3<f64> {
        let x = |i: usize| self.coords.get(i).copied().unwrap_or(0.0);
        Vector3::new(x(0), x(1), x(2))
    }

    /// Global numbers of its degrees of freedom.
    pub fn dofs(&self) -> Range<usize> {
        self.offset..self.offset + self.ndf
    }

    /// Displacement of the node per unit rigid motion of the ground in direction `direction` (from 0: translations,
    /// then rotations about the origin), by degree of freedom.
    pub fn influence(&self, direction: usize) -> Vec<f64> {
        let mut r = vec![0.0; self.ndf];
        let x = self.place();
        let moves: &[(usize, f64)] = match (self.ndm(), direction) {
            (1, 0) | (2 | 3, 0) => &[(0, 1.0)],
            (2 | 3, 1) => &[(1, 1.0)],
            (3, 2) => &[(2, 1.0)],
            (2, 2) => &[(0, -x.y), (1, x.x), (2, 1.0)],
            (3, 3) => &[(1, -x.z), (2, x.y), (3, 1.0)],
            (3, 4) => &[(0, x.z), (2, -x.x), (4, 1.0)],
            (3, 5) => &[(0, -x.y), (1, x.x), (5, 1.0)],
            _ => &[],
        };
        for &(i, value) in moves {
            if let Some(r) = r.get_mut(i) {
                *r = value;
            }
        }
        r
    }
}
