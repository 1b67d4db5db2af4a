//! Springs between two nodes at one location: `zeroLength`.

use super::springs::Springs;
use super::{
    BasicRow, Class, Element, ElementError, ElementInput, ElementOutput, ElementResult, ElementTraits, Histories,
    LockstepElement, Snapshot, alike, dot, one_by_one,
};
use crate::element::roles::{BasicDeformations, ElementParameters, Roles};
use crate::material::{Material, Slot};
use crate::numeric::wide::WIDTH;
use crate::parameter::{Changed, NewValue};
use crate::probe::Probe;
use nalgebra::Matrix3;
use std::sync::Arc;

/// Damping of a `zeroLength` besides that of its materials.
#[derive(Clone, Debug)]
pub enum RayleighDamping {
    /// No damping: the default.
    None,
    /// The Rayleigh damping of the model (`-doRayleigh 1`).
    Model,
    /// A damper for each spring, with the rate of deformation as its strain (`-dampMats`).
    Materials(Vec<(Material, i32)>),
}

/// Uniaxial springs between two nodes, each along or about an axis of the element.
#[derive(Clone, Debug)]
pub struct ZeroLength {
    springs: Springs,
    ndm: usize,
    dofs: usize,
    rayleigh: bool,
}

impl ZeroLength {
    /// Makes springs (material, tag, direction 1 to 6) between two nodes with `per_node` degrees of freedom in `ndm`
    /// dimensions. `axes` has the local axes as rows. `initial` is the displacement of node j less that of node i,
    /// length `per_node`.
    ///
    /// # Errors
    /// A direction without a degree of freedom.
    pub fn new(
        springs: Vec<(Material, i32, usize)>,
        ndm: usize,
        per_node: usize,
        axes: Matrix3<f64>,
        initial: &[f64],
        damping: RayleighDamping,
    ) -> ElementResult<Self> {
        let mut made = Springs::new(axes);
        for (k, (material, tag, direction)) in springs.into_iter().enumerate() {
            let half = direction_row(direction, ndm, per_node, &axes)
                .ok_or_else(|| ElementError(no_direction(direction, ndm, per_node).into()))?;
            let row = half.iter().map(|c| -c).chain(half.iter().copied()).collect();
            let damper = match &damping {
                RayleighDamping::Materials(m) => m.get(k).cloned(),
                _ => None,
            };
            made.add((material, tag), direction, (row, dot(&half, initial)), damper);
        }
        let rayleigh = matches!(damping, RayleighDamping::Model);
        Ok(Self { springs: made, ndm, dofs: 2 * per_node, rayleigh })
    }
}

fn no_direction(direction: usize, ndm: usize, per_node: usize) -> String {
    format!("direction {direction} has no degree of freedom at nodes with {per_node} in {ndm} dimensions")
}

/// Direction cosines of a direction for the degrees of freedom of a node; `None` without a degree of freedom for it.
pub(super) fn direction_row(direction: usize, ndm: usize, per_node: usize, axes: &Matrix3<f64>) -> Option<Vec<f64>> {
    let mut row = vec![0.0; per_node];
    let axis = axes.row((direction - 1) % 3);
    let rotation = direction > 3;
    match (ndm, per_node, rotation) {
        (1, 1, false) => row[0] = axis[0],
        (2, 2 | 3, false) => row[..2].copy_from_slice(&[axis[0], axis[1]]),
        (2, 3, true) => row[2] = axis[2],
        (3, 3 | 6, false) => row[..3].copy_from_slice(&[axis[0], axis[1], axis[2]]),
        (3, 6, true) => row[3..].copy_from_slice(&[axis[0], axis[1], axis[2]]),
        _ => return None,
    }
    row.iter().any(|&c| c != 0.0).then_some(row)
}

crate::watches_columns!(ZeroLength => |s| in s.springs.slots());

/// The springs side by side where their deformations are the same; else the elements one after the other.
fn lockstep(all: &[&Arc<dyn Element>; WIDTH]) -> Option<Box<dyn LockstepElement>> {
    let own = alike::<ZeroLength>(all)?;
    let springs = || Springs::side_by_side(&own.map(|e| &e.springs), own[0].dofs);
    let same = own.iter().all(|e| e.dofs == own[0].dofs);
    same.then(springs).flatten().or_else(|| one_by_one::<ZeroLength>(all))
}

impl Element for ZeroLength {
    fn class(&self) -> Class {
        Class::new("ZeroLength", 19)
    }
    fn dofs(&self) -> usize {
        self.dofs
    }
    fn state_len(&self) -> usize {
        self.springs.state_len()
    }
    fn init(&self, state: &mut [f64]) {
        self.springs.init(state);
    }
    fn traits(&self) -> ElementTraits {
        ElementTraits { rayleigh: self.rayleigh, ..self.springs.traits() }
    }

    fn respond(&self, motion: &ElementInput<'_>, h: &mut Histories<'_>, mut out: ElementOutput<'_>) -> ElementResult {
        self.springs.respond(motion, h, &mut out)
    }

    fn initial_tangent(&self, tangent: &mut [f64]) {
        self.springs.initial_tangent(tangent);
    }

    fn roles(&self) -> Roles<'_> {
        Roles {
            parameters: Some(self),
            basic_rows: Some(self),
            lockstep: Some(lockstep),
            basic_forces: Some(&self.springs),
            ..Roles::default()
        }
    }

    fn probe(&self, words: &[&str]) -> Option<Probe> {
        match *words.first()? {
            "localForce" | "localForces" => self.springs.probe(&["basicForce"], "P", "e"),
            _ => self.springs.probe(words, "P", "e"),
        }
    }

    fn probe_names(&self) -> Vec<&'static str> {
        vec![
            "basicForce",
            "localForce",
            "deformation",
            "basicDeformation",
            "defoANDforce",
            "basicStiffness",
            "material",
        ]
    }

    fn read(&self, path: &[u32], s: &Snapshot<'_>, out: &mut [f64]) {
        // As in OpenSees, the recorded deformation is the material's strain, initial strain included.
        self.springs.read(path, s, Slot::shown_strain, out);
    }
}

impl ElementParameters for ZeroLength {
    fn with_parameter(&self, words: &[&str], value: NewValue) -> Changed<Arc<dyn Element>> {
        let mut new = self.clone();
        let old = new.springs.set_parameter(words, value)?;
        Ok((Arc::new(new), old))
    }
}

impl BasicDeformations for ZeroLength {
    fn basic_rows(&self) -> Vec<BasicRow> {
        self.springs.basic_rows(|d| d, (self.ndm, self.dofs / 2))
    }
}
