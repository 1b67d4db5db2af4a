//! One spring for two directions: `CoupledZeroLength`.

use super::{Class, Element, ElementInput, ElementOutput, ElementResult, ElementTraits, Histories, Snapshot};
use crate::element::roles::{ElementParameters, Roles};
use crate::material::{Material, Slot, Strain};
use crate::parameter::{Changed, NewValue};
use crate::probe::Probe;
use std::sync::Arc;

/// A uniaxial material between two nodes at one location. Its deformation is the length of the relative displacement in
/// a plane of two directions; the force is along that vector. The deformation is negative if the components sum to less
/// than 0.
#[derive(Clone, Debug)]
pub struct CoupledZeroLength {
    slot: Slot,
    /// Degrees of freedom of a node that span the plane.
    directions: [usize; 2],
    per_node: usize,
    /// Relative displacement when the element was created, the zero of the deformation.
    initial: [f64; 2],
    rayleigh: bool,
    /// OpenSees' tangent: that of the spring in both directions.
    compat: bool,
}

impl CoupledZeroLength {
    /// Makes the element of a material and its tag. `directions` are degrees of freedom from 0 of nodes with
    /// `per_node`. `initial` is the displacement of j less that of i. `compat` selects OpenSees' tangent, that of the
    /// spring in both directions.
    pub fn new(
        (material, tag): (Material, i32),
        directions: [usize; 2],
        per_node: usize,
        initial: &[f64],
        rayleigh: bool,
        compat: bool,
    ) -> Self {
        // The first two state variables are the direction of the last force.
        let slot = Slot::new(material, tag, 2);
        Self { slot, directions, per_node, initial: directions.map(|d| initial[d]), rayleigh, compat }
    }

    fn offset(&self, field: &[f64]) -> [f64; 2] {
        self.directions.map(|d| field[self.per_node + d] - field[d])
    }

    /// Adds a stiffness in both directions.
    fn add_stiffness(&self, stiffness: f64, out: &mut [f64]) {
        self.add_block([[stiffness, 0.0], [0.0, stiffness]], out);
    }

    /// Adds a stiffness matrix of the plane.
    fn add_block(&self, block: [[f64; 2]; 2], out: &mut [f64]) {
        let n = 2 * self.per_node;
        for (&d, row) in self.directions.iter().zip(block) {
            for (&e, k) in self.directions.iter().zip(row) {
                for (i, j, sign) in [(0, 0, 1.0), (1, 1, 1.0), (0, 1, -1.0), (1, 0, -1.0)] {
                    out[(i * self.per_node + d) * n + j * self.per_node + e] += sign * k;
                }
            }
        }
    }
}

crate::watches_columns!(CoupledZeroLength => |s| in [&s.slot]);

impl Element for CoupledZeroLength {
    fn class(&self) -> Class {
        Class::new("CoupledZeroLength", 26)
    }
    fn dofs(&self) -> usize {
        2 * self.per_node
    }
    fn state_len(&self) -> usize {
        2 + self.slot.len()
    }
    fn init(&self, state: &mut [f64]) {
        state[..2].fill(0.0);
        self.slot.init(state);
    }
    fn traits(&self) -> ElementTraits {
        ElementTraits { linear: false, rayleigh: self.rayleigh, ..ElementTraits::of(std::iter::once(&self.slot)) }
    }

    fn respond(&self, motion: &ElementInput<'_>, h: &mut Histories<'_>, output: ElementOutput<'_>) -> ElementResult {
        let rate = self.offset(motion.vel);
        let mut d = self.offset(motion.disp);
        d.iter_mut().zip(&self.initial).for_each(|(d, initial)| *d -= initial);
        let size = d[0].hypot(d[1]);
        let value = if d[0] + d[1] < 0.0 { -size } else { size };
        let strain = Strain { value, rate: rate[0].hypot(rate[1]), dt: motion.dt };
        let s = self.slot.update(h.committed, strain, h.trial)?;
        let last = [h.committed[0], h.committed[1]];
        // At zero deformation the force keeps its last direction.
        let direction = if value != 0.0 { d.map(|d| d / value) } else { last };
        let turns = value != 0.0 && s.value != 0.0;
        let unit = direction.map(|x| x * s.value.signum());
        h.trial[..2].copy_from_slice(&if turns { unit } else { last });
        for (at, share) in self.directions.iter().zip(direction) {
            output.force[*at] -= share * s.value;
            output.force[self.per_node + at] += share * s.value;
        }
        if let Some(k) = output.tangent {
            if self.compat || value == 0.0 {
                self.add_stiffness(s.tangent, k);
            } else {
                // Second term: rotation of the force with the relative displacement.
                let (along, across) = (s.tangent, s.value / value);
                let [x, y] = direction;
                let mixed = (along - across) * x * y;
                self.add_block([[along * x * x + across * y * y, mixed], [mixed, along * y * y + across * x * x]], k);
            }
        }
        if let Some(c) = output.damping {
            self.add_stiffness(s.damping, c);
        }
        Ok(())
    }

    fn initial_tangent(&self, tangent: &mut [f64]) {
        self.add_stiffness(self.slot.material.initial_tangent(), tangent);
    }

    fn roles(&self) -> Roles<'_> {
        Roles { parameters: Some(self), ..Roles::default() }
    }

    fn probe(&self, words: &[&str]) -> Option<Probe> {
        self.slot.probe(words.strip_prefix(&["material"])?)
    }

    fn probe_names(&self) -> Vec<&'static str> {
        vec!["material"]
    }

    fn read(&self, path: &[u32], s: &Snapshot<'_>, out: &mut [f64]) {
        self.slot.read(path, s.state, out);
    }
}

impl ElementParameters for CoupledZeroLength {
    fn with_parameter(&self, words: &[&str], value: NewValue) -> Changed<Arc<dyn Element>> {
        let mut new = self.clone();
        let words = words.strip_prefix(&["material"]).unwrap_or(words);
        let old = new.slot.set_parameter(words, value)?;
        Ok((Arc::new(new), old))
    }
}
