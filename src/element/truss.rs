//! Axial bar: `truss`.

use super::{Answer, Element, ElementError, Mass, Motion, Nature, Snapshot, add_outer, dot};
use crate::material::{Material, Slot, Strain};
use crate::probe::Probe;

/// An axial bar with linear kinematics.
#[derive(Clone, Debug)]
pub struct Truss {
    slot: Slot,
    options: TrussOptions,
    length: f64,
    /// Strain from the displacements of all degrees of freedom, 1/length.
    row: Vec<f64>,
    /// Strain of the displacements that the nodes had when the bar was made: it measures from there.
    initial: f64,
    ndm: usize,
}

/// Constants of a [`Truss`].
#[derive(Clone, Debug)]
pub struct TrussOptions {
    /// Cross-sectional area.
    pub area: f64,
    /// Mass per length.
    pub rho: f64,
    /// Consistent instead of lumped mass.
    pub consistent: bool,
    /// Take part in the Rayleigh damping of the model.
    pub rayleigh: bool,
}

impl TrussOptions {
    /// Mass of a bar of a length between nodes with `per_node` degrees of freedom, translations in `ndm` directions.
    pub(super) fn mass(&self, length: f64, ndm: usize, per_node: usize) -> Mass {
        let (n, total) = (2 * per_node, self.rho * length);
        if total == 0.0 {
            return Mass::None;
        }
        if !self.consistent {
            let mut m = vec![0.0; n];
            for i in (0..ndm).flat_map(|i| [i, per_node + i]) {
                m[i] = 0.5 * total;
            }
            return Mass::Lumped(m);
        }
        let mut m = vec![0.0; n * n];
        for i in 0..ndm {
            let j = per_node + i;
            m[i * n + i] = total / 3.0;
            m[j * n + j] = total / 3.0;
            m[i * n + j] = total / 6.0;
            m[j * n + i] = total / 6.0;
        }
        Mass::Consistent(m)
    }
}

impl Truss {
    /// A bar along `line`, from node i to node j, between nodes with `per_node` degrees of freedom, of which the
    /// first `line.len()` are translations; `initial` is the displacement of j less that of i, which `line` includes.
    ///
    /// # Errors
    /// No length.
    pub fn new(
        material: Material,
        tag: i32,
        line: &[f64],
        per_node: usize,
        initial: &[f64],
        options: &TrussOptions,
    ) -> Result<Self, ElementError> {
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
        let slot = Slot::new(material, tag, 0);
        Ok(Self { slot, options: options.clone(), length, row, initial, ndm: line.len() })
    }

    fn force(&self, state: &[f64]) -> f64 {
        self.options.area * self.slot.stress(state)
    }
}

const AXIAL_FORCE: u32 = 2;
const DEFORMATION: u32 = 3;
const STIFFNESS: u32 = 4;
const MATERIAL: u32 = 5;
const LOCAL_FORCE: u32 = 6;

impl Element for Truss {
    fn class(&self) -> &'static str {
        "Truss"
    }
    fn dofs(&self) -> usize {
        self.row.len()
    }
    fn state_len(&self) -> usize {
        self.slot.len()
    }
    fn init(&self, state: &mut [f64]) {
        self.slot.init(state);
    }
    fn nature(&self) -> Nature {
        Nature {
            linear: self.slot.material.is_linear(),
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
        let strain = Strain {
            value: dot(&self.row, motion.disp) - self.initial,
            rate: dot(&self.row, motion.vel),
            dt: motion.dt,
        };
        let s = self.slot.update(committed, strain, trial)?;
        let volume = self.options.area * self.length;
        for (f, r) in answer.force.iter_mut().zip(&self.row) {
            *f += volume * s.value * r;
        }
        if let Some(k) = answer.tangent {
            add_outer(k, &self.row, volume * s.tangent);
        }
        if let Some(c) = answer.damping {
            add_outer(c, &self.row, volume * s.damping);
        }
        Ok(())
    }

    fn initial_tangent(&self, tangent: &mut [f64]) {
        add_outer(tangent, &self.row, self.options.area * self.length * self.slot.material.initial_tangent());
    }

    fn ground_inertia_slip(&self) -> Option<f64> {
        (self.options.rho != 0.0).then_some(1.0)
    }

    fn mass(&self) -> Mass {
        self.options.mass(self.length, self.ndm, self.dofs() / 2)
    }

    fn probe(&self, words: &[&str]) -> Option<Probe> {
        Some(match *words.first()? {
            "axialForce" | "basicForce" | "basicForces" => Probe::new(AXIAL_FORCE, ["N"]),
            "localForce" | "localForces" => Probe::new(LOCAL_FORCE, (1..=self.dofs()).map(|i| format!("P{i}"))),
            "defo" | "deformation" | "deformations" | "basicDefo" | "basicDeformation" | "basicDeformations" => {
                Probe::new(DEFORMATION, ["U"])
            }
            "basicStiffness" => Probe::new(STIFFNESS, ["K"]),
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
        &["axialForce", "basicForce", "localForce", "deformation", "basicDeformation", "material"]
    }

    fn read(&self, path: &[u32], s: &Snapshot<'_>, out: &mut [f64]) {
        match path[0] {
            AXIAL_FORCE => out[0] = self.force(s.state),
            LOCAL_FORCE => {
                out[0] = -self.force(s.state);
                out[self.dofs() / 2] = self.force(s.state);
            }
            DEFORMATION => out[0] = self.length * self.slot.strain(s.state),
            STIFFNESS => out[0] = self.options.area / self.length * self.slot.tangent(s.state),
            _ => self.slot.read(&path[1..], s.state, out),
        }
    }
}
