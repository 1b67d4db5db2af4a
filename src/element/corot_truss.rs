//! Axial bar with large displacements: `corotTruss`.

use super::{Answer, Element, ElementError, Mass, Motion, Nature, Snapshot, TrussOptions};
use crate::material::{Material, Slot, Strain};
use crate::probe::Probe;

/// An axial bar that turns with its nodes; engineering strain (Lₙ - L)/L of the bar as it stands (Crisfield, 1991,
/// section 3.3).
#[derive(Clone, Debug)]
pub struct CorotTruss {
    slot: Slot,
    options: TrussOptions,
    /// From node i to node j, undeformed.
    line: [f64; 3],
    length: f64,
    ndm: usize,
    per_node: usize,
}

/// The bar as it stands.
struct Chord {
    length: f64,
    /// Unit vector from i to j.
    direction: [f64; 3],
}

impl CorotTruss {
    /// A bar along `line`, from node i to node j, between nodes with `per_node` degrees of freedom, of which the first
    /// `line.len()` are translations.
    ///
    /// # Errors
    /// No length.
    pub fn new(
        material: Material,
        tag: i32,
        line: &[f64],
        per_node: usize,
        options: TrussOptions,
    ) -> Result<Self, ElementError> {
        let mut full = [0.0; 3];
        full[..line.len()].copy_from_slice(line);
        let length = norm(&full);
        if length == 0.0 {
            return Err(ElementError("the truss has no length".into()));
        }
        Ok(Self { slot: Slot::new(material, tag, 0), options, line: full, length, ndm: line.len(), per_node })
    }

    /// Difference of a nodal field between j and i.
    fn relative(&self, field: &[f64]) -> [f64; 3] {
        std::array::from_fn(|i| if i < self.ndm { field[self.per_node + i] - field[i] } else { 0.0 })
    }

    fn chord(&self, disp: &[f64]) -> Result<Chord, ElementError> {
        let u = self.relative(disp);
        let d: [f64; 3] = std::array::from_fn(|i| self.line[i] + u[i]);
        let length = norm(&d);
        if length == 0.0 {
            return Err(ElementError("the ends of the truss have met: it has no direction any more".into()));
        }
        Ok(Chord { length, direction: d.map(|x| x / length) })
    }

    /// Add `axial` n nᵀ + `across` (1 - n nᵀ), with opposite signs between the nodes.
    fn add_stiffness(&self, n: &[f64; 3], axial: f64, across: f64, k: &mut [f64]) {
        let size = self.dofs();
        for a in 0..self.ndm {
            for b in 0..self.ndm {
                let nn = n[a] * n[b];
                let x = axial * nn + across * (f64::from(u8::from(a == b)) - nn);
                let (i, j) = (self.per_node + a, self.per_node + b);
                k[a * size + b] += x;
                k[i * size + j] += x;
                k[a * size + j] -= x;
                k[i * size + b] -= x;
            }
        }
    }

    fn force(&self, state: &[f64]) -> f64 {
        self.options.area * self.slot.stress(state)
    }
}

fn norm(v: &[f64; 3]) -> f64 {
    v.iter().map(|x| x * x).sum::<f64>().sqrt()
}

const AXIAL_FORCE: u32 = 2;
const DEFORMATION: u32 = 3;
const MATERIAL: u32 = 5;

impl Element for CorotTruss {
    fn class(&self) -> &'static str {
        "CorotTruss"
    }
    fn dofs(&self) -> usize {
        2 * self.per_node
    }
    fn state_len(&self) -> usize {
        self.slot.len()
    }
    fn init(&self, state: &mut [f64]) {
        self.slot.init(state);
    }
    fn nature(&self) -> Nature {
        Nature {
            linear: false,
            symmetric: true,
            viscous: self.slot.material.is_viscous(),
            elapses: self.slot.material.depends_on_time(),
            rayleigh: self.options.rayleigh,
        }
    }

    fn respond(
        &self,
        motion: &Motion<'_>,
        committed: &[f64],
        trial: &mut [f64],
        answer: Answer<'_>,
    ) -> Result<(), ElementError> {
        let chord = self.chord(motion.disp)?;
        let n = &chord.direction;
        let v = self.relative(motion.vel);
        let strain = Strain {
            value: (chord.length - self.length) / self.length,
            rate: n.iter().zip(&v).map(|(n, v)| n * v).sum::<f64>() / self.length,
            dt: motion.dt,
        };
        let s = self.slot.update(committed, strain, trial)?;
        let area = self.options.area;
        let axial = area * s.value;
        for (i, n) in n.iter().enumerate().take(self.ndm) {
            answer.force[i] -= axial * n;
            answer.force[self.per_node + i] += axial * n;
        }
        if let Some(k) = answer.tangent {
            self.add_stiffness(n, area * s.tangent / self.length, axial / chord.length, k);
        }
        if let Some(c) = answer.damping {
            self.add_stiffness(n, area * s.damping / self.length, 0.0, c);
        }
        Ok(())
    }

    fn initial_tangent(&self, tangent: &mut [f64]) {
        let n = self.line.map(|x| x / self.length);
        let stiffness = self.options.area * self.slot.material.initial_tangent() / self.length;
        self.add_stiffness(&n, stiffness, 0.0, tangent);
    }

    fn mass(&self) -> Mass {
        self.options.mass(self.length, self.ndm, self.per_node)
    }

    fn probe(&self, words: &[&str]) -> Option<Probe> {
        Some(match *words.first()? {
            "axialForce" | "basicForce" | "basicForces" | "localForce" | "localForces" => {
                Probe::new(AXIAL_FORCE, ["N"])
            }
            "defo" | "deformation" | "deformations" | "basicDefo" | "basicDeformation" | "basicDeformations" => {
                Probe::new(DEFORMATION, ["U"])
            }
            "material" | "-material" => {
                // `material stress` as well as `material 1 stress`.
                let rest = &words[1..];
                let rest = if rest.first().is_some_and(|w| w.parse::<i32>().is_ok()) { &rest[1..] } else { rest };
                return Some(self.slot.probe(rest)?.inside(&[MATERIAL]));
            }
            _ => return self.slot.probe(words).map(|p| p.inside(&[MATERIAL])),
        })
    }

    fn probe_names(&self) -> &'static [&'static str] {
        &["axialForce", "basicForce", "deformation", "basicDeformation", "material"]
    }

    fn read(&self, path: &[u32], s: &Snapshot<'_>, out: &mut [f64]) {
        match path[0] {
            AXIAL_FORCE => out[0] = self.force(s.state),
            DEFORMATION => out[0] = self.length * self.slot.strain(s.state),
            _ => self.slot.read(&path[1..], s.state, out),
        }
    }
}
