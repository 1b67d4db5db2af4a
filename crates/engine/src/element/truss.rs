//! Axial bar: `truss`.

use super::bar::{Bar, BarOptions};
use super::{
    BasicRow, Class, Element, ElementError, ElementInput, ElementOutput, ElementResult, ElementTraits, Histories, Mass,
    OpenSeesTraits, Snapshot, add_outer, dot, one_by_one,
};
use crate::element::roles::{BasicDeformations, ElementParameters, Inertia, Roles};
use crate::material::{Material, Slot, Strain, of_length};
use crate::parameter::{Changed, NewValue};
use crate::probe::Probe;
use std::sync::Arc;

/// An axial bar with linear kinematics.
#[derive(Clone, Debug)]
pub struct Truss {
    bar: Bar,
    /// Derivatives of the strain by the displacements, 1/length.
    row: Vec<f64>,
    /// Strain of the nodal displacements when the bar was created, which is subtracted.
    initial: f64,
}

impl Truss {
    /// A bar along `line`, from node i to node j. Nodes have `per_node` degrees of freedom, the first `line.len()` of
    /// which are translations. `initial` is the displacement of j less that of i, which `line` includes.
    ///
    /// # Errors
    /// No length.
    pub fn new(
        material: Material,
        tag: i32,
        line: &[f64],
        per_node: usize,
        initial: &[f64],
        options: BarOptions,
    ) -> ElementResult<Self> {
        let length = dot(line, line).sqrt();
        if length == 0.0 {
            return Err(ElementError("the truss has no length".into()));
        }
        let mut row = vec![0.0; 2 * per_node];
        for (i, x) in line.iter().enumerate() {
            // Direction cosine over length.
            row[i] = -x / (length * length);
            row[per_node + i] = x / (length * length);
        }
        let initial = dot(&row[per_node..per_node + line.len()], &initial[..line.len()]);
        let bar =
            Bar { slot: Slot::new(of_length(material, length), tag, 0), options, length, ndm: line.len(), per_node };
        Ok(Self { bar, row, initial })
    }

    /// Volume A L; end forces are volume x stress x `row`.
    fn volume(&self) -> f64 {
        self.bar.options.area * self.bar.length
    }
}

crate::watches_columns!(Truss => |s| in [&s.bar.slot]);

impl Element for Truss {
    fn class(&self) -> Class {
        self.bar.class(Class::new("Truss", 12), Class::new("TrussSection", 13))
    }
    fn dofs(&self) -> usize {
        self.row.len()
    }
    fn state_len(&self) -> usize {
        self.bar.slot.len()
    }
    fn init(&self, state: &mut [f64]) {
        self.bar.slot.init(state);
    }
    fn traits(&self) -> ElementTraits {
        self.bar.traits()
    }

    fn respond(&self, motion: &ElementInput<'_>, h: &mut Histories<'_>, output: ElementOutput<'_>) -> ElementResult {
        let strain = Strain {
            value: dot(&self.row, motion.disp) - self.initial,
            rate: dot(&self.row, motion.vel),
            dt: motion.dt,
        };
        let s = self.bar.slot.update(h.committed, strain, h.trial)?;
        let volume = self.volume();
        for (f, r) in output.force.iter_mut().zip(&self.row) {
            *f += volume * s.value * r;
        }
        if let Some(k) = output.tangent {
            add_outer(k, &self.row, volume * s.tangent);
        }
        if let Some(c) = output.damping {
            add_outer(c, &self.row, volume * s.damping);
        }
        Ok(())
    }

    fn initial_tangent(&self, tangent: &mut [f64]) {
        add_outer(tangent, &self.row, self.volume() * self.bar.slot.material.initial_tangent());
    }

    fn roles(&self) -> Roles<'_> {
        Roles {
            mass: Some(self),
            parameters: Some(self),
            basic_rows: Some(self),
            lockstep: Some(one_by_one::<Self>),
            opensees: OpenSeesTraits::of_mass(self.bar.options.rho != 0.0),
            ..Roles::default()
        }
    }

    fn probe(&self, words: &[&str]) -> Option<Probe> {
        self.bar.probe(words)
    }

    fn probe_names(&self) -> Vec<&'static str> {
        self.bar.probe_names()
    }

    fn read(&self, path: &[u32], s: &Snapshot<'_>, out: &mut [f64]) {
        self.bar.read(path, s, out);
    }
}

impl Inertia for Truss {
    fn mass(&self) -> Mass {
        self.bar.mass()
    }
}

impl ElementParameters for Truss {
    fn with_parameter(&self, words: &[&str], value: NewValue) -> Changed<Arc<dyn Element>> {
        let mut new = self.clone();
        let old = new.bar.set_parameter(words, value)?;
        Ok((Arc::new(new), old))
    }
}

impl BasicDeformations for Truss {
    fn basic_rows(&self) -> Vec<BasicRow> {
        let length = self.bar.length;
        let row: Vec<f64> = self.row.iter().map(|r| r * length).collect();
        let row = BasicRow::new(1, 0, &row, (self.bar.ndm, self.bar.per_node)).from_initial(self.initial * length);
        vec![row.of_material(1, self.bar.options.area, length)]
    }
}
