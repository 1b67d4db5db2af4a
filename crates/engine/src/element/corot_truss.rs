//! Axial bar with large displacements: `corotTruss`.

use super::bar::{Bar, BarOptions};
use super::{
    Class, Element, ElementError, ElementInput, ElementOutput, ElementResult, ElementTraits, Histories, Mass, Snapshot,
    one_by_one,
};
use crate::element::roles::{ElementParameters, Inertia, Roles};
use crate::material::{Material, Slot, Strain, of_length};
use crate::parameter::{Changed, NewValue};
use crate::probe::Probe;
use std::sync::Arc;

/// A corotational axial bar. The engineering strain is (Lₙ - L)/L with the current length Lₙ (Crisfield, 1991, section
/// 3.3).
#[derive(Clone, Debug)]
pub struct CorotTruss {
    bar: Bar,
    /// Undeformed vector from node i to node j.
    line: [f64; 3],
}

/// Current geometry of the bar.
struct Chord {
    length: f64,
    /// Unit vector from i to j.
    direction: [f64; 3],
}

impl CorotTruss {
    /// A bar along `line`, from node i to node j. Nodes have `per_node` degrees of freedom, the first `line.len()` of
    /// which are translations.
    ///
    /// # Errors
    /// No length.
    pub fn new(
        material: Material,
        tag: i32,
        line: &[f64],
        per_node: usize,
        options: BarOptions,
    ) -> ElementResult<Self> {
        let mut full = [0.0; 3];
        full[..line.len()].copy_from_slice(line);
        let length = norm(&full);
        if length == 0.0 {
            return Err(ElementError("the truss has no length".into()));
        }
        let bar =
            Bar { slot: Slot::new(of_length(material, length), tag, 0), options, length, ndm: line.len(), per_node };
        Ok(Self { bar, line: full })
    }

    /// Difference of a nodal field between j and i.
    fn relative(&self, field: &[f64]) -> [f64; 3] {
        std::array::from_fn(|i| if i < self.bar.ndm { field[self.bar.per_node + i] - field[i] } else { 0.0 })
    }

    fn chord(&self, disp: &[f64]) -> ElementResult<Chord> {
        let u = self.relative(disp);
        let d: [f64; 3] = std::array::from_fn(|i| self.line[i] + u[i]);
        let length = norm(&d);
        if length == 0.0 {
            return Err(ElementError("the ends of the truss have met: it has no direction any more".into()));
        }
        Ok(Chord { length, direction: d.map(|x| x / length) })
    }

    /// Adds `axial` n nᵀ + `across` (1 - n nᵀ), with opposite signs between the nodes.
    fn add_stiffness(&self, n: &[f64; 3], axial: f64, across: f64, k: &mut [f64]) {
        let size = self.dofs();
        for a in 0..self.bar.ndm {
            for b in 0..self.bar.ndm {
                let nn = n[a] * n[b];
                let x = axial * nn + across * (f64::from(u8::from(a == b)) - nn);
                let (i, j) = (self.bar.per_node + a, self.bar.per_node + b);
                k[a * size + b] += x;
                k[i * size + j] += x;
                k[a * size + j] -= x;
                k[i * size + b] -= x;
            }
        }
    }
}

fn norm(v: &[f64; 3]) -> f64 {
    v.iter().map(|x| x * x).sum::<f64>().sqrt()
}

crate::watches_columns!(CorotTruss => |s| in [&s.bar.slot]);

impl Element for CorotTruss {
    fn class(&self) -> Class {
        self.bar.class(Class::new("CorotTruss", 14), Class::new("CorotTrussSection", 15))
    }
    fn dofs(&self) -> usize {
        self.bar.dofs()
    }
    fn state_len(&self) -> usize {
        self.bar.slot.len()
    }
    fn init(&self, state: &mut [f64]) {
        self.bar.slot.init(state);
    }
    fn traits(&self) -> ElementTraits {
        ElementTraits { linear: false, ..self.bar.traits() }
    }

    fn respond(&self, motion: &ElementInput<'_>, h: &mut Histories<'_>, output: ElementOutput<'_>) -> ElementResult {
        let chord = self.chord(motion.disp)?;
        let n = &chord.direction;
        let v = self.relative(motion.vel);
        let strain = Strain {
            value: (chord.length - self.bar.length) / self.bar.length,
            rate: n.iter().zip(&v).map(|(n, v)| n * v).sum::<f64>() / self.bar.length,
            dt: motion.dt,
        };
        let s = self.bar.slot.update(h.committed, strain, h.trial)?;
        let area = self.bar.options.area;
        let axial = area * s.value;
        for (i, n) in n.iter().enumerate().take(self.bar.ndm) {
            output.force[i] -= axial * n;
            output.force[self.bar.per_node + i] += axial * n;
        }
        if let Some(k) = output.tangent {
            self.add_stiffness(n, area * s.tangent / self.bar.length, axial / chord.length, k);
        }
        if let Some(c) = output.damping {
            self.add_stiffness(n, area * s.damping / self.bar.length, 0.0, c);
        }
        Ok(())
    }

    fn initial_tangent(&self, tangent: &mut [f64]) {
        let n = self.line.map(|x| x / self.bar.length);
        let stiffness = self.bar.options.area * self.bar.slot.material.initial_tangent() / self.bar.length;
        self.add_stiffness(&n, stiffness, 0.0, tangent);
    }

    fn roles(&self) -> Roles<'_> {
        Roles { mass: Some(self), parameters: Some(self), lockstep: Some(one_by_one::<Self>), ..Roles::default() }
    }

    fn probe(&self, words: &[&str]) -> Option<Probe> {
        match *words.first()? {
            // OpenSees reports the axial force alone.
            "localForce" | "localForces" => self.bar.probe(&["axialForce"]),
            _ => self.bar.probe(words),
        }
    }

    fn probe_names(&self) -> Vec<&'static str> {
        self.bar.probe_names()
    }

    fn read(&self, path: &[u32], s: &Snapshot<'_>, out: &mut [f64]) {
        self.bar.read(path, s, out);
    }
}

impl Inertia for CorotTruss {
    fn mass(&self) -> Mass {
        self.bar.mass()
    }
}

impl ElementParameters for CorotTruss {
    fn with_parameter(&self, words: &[&str], value: NewValue) -> Changed<Arc<dyn Element>> {
        let mut new = self.clone();
        let old = new.bar.set_parameter(words, value)?;
        Ok((Arc::new(new), old))
    }
}
