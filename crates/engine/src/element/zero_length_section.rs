//! A section between two nodes at one location: `zeroLengthSection`.

use super::zero_length::direction_row;
use super::{Class, Element, ElementInput, ElementOutput, ElementResult, ElementTraits, Histories, Snapshot, dot};
use crate::element::roles::{ElementParameters, ForceLabels, Roles};
use crate::parameter::{Changed, NewValue};
use crate::probe::Probe;
use crate::section::{MAX_ORDER, Resultant, SectionSlot, SharedSection};
use nalgebra::Matrix3;
use std::sync::Arc;

/// A section with the relative displacements of two nodes as its deformations.
#[derive(Clone, Debug)]
pub struct ZeroLengthSection {
    slot: SectionSlot,
    axes: Matrix3<f64>,
    /// Derivatives of the deformation by the displacements, for each resultant.
    rows: Vec<Vec<f64>>,
    dofs: usize,
    rayleigh: bool,
}

impl ZeroLengthSection {
    /// Makes the element of a section and its tag. Nodes have `per_node` degrees of freedom in `ndm` dimensions; `axes`
    /// has the local axes as rows. A resultant without a degree of freedom has no deformation.
    pub fn new(
        (section, tag): (SharedSection, i32),
        (ndm, per_node): (usize, usize),
        axes: Matrix3<f64>,
        rayleigh: bool,
    ) -> Self {
        let direction = |r: &Resultant| match r {
            Resultant::P => 1,
            Resultant::Vy => 2,
            Resultant::Vz => 3,
            Resultant::T => 4,
            Resultant::My => 5,
            Resultant::Mz => 6,
        };
        let row = |r: &Resultant| {
            let half = direction_row(direction(r), ndm, per_node, &axes).unwrap_or_else(|| vec![0.0; per_node]);
            half.iter().map(|c| -c).chain(half.iter().copied()).collect()
        };
        let rows = section.resultants().iter().map(row).collect();
        Self { slot: SectionSlot::new(section, tag, 0), axes, rows, dofs: 2 * per_node, rayleigh }
    }

    /// Adds Aᵀ k A for the section stiffness k by rows.
    fn add_stiffness(&self, stiffness: &[f64], out: &mut [f64]) {
        for (a, k) in self.rows.iter().zip(stiffness.chunks_exact(self.rows.len().max(1))) {
            for (b, k) in self.rows.iter().zip(k) {
                for (row, a) in out.chunks_exact_mut(self.dofs).zip(a) {
                    row.iter_mut().zip(b).for_each(|(o, b)| *o += a * k * b);
                }
            }
        }
    }
}

const FORCE: u32 = 2;
const DEFORMATION: u32 = 3;
const STIFFNESS: u32 = 13;
const X_AXIS: u32 = 20;
const Z_AXIS: u32 = 22;
const SECTION: u32 = 30;

crate::watches_columns!(ZeroLengthSection => |s| in [&s.slot]);

impl Element for ZeroLengthSection {
    fn class(&self) -> Class {
        Class::new("ZeroLengthSection", 20)
    }
    fn dofs(&self) -> usize {
        self.dofs
    }
    fn state_len(&self) -> usize {
        self.slot.len()
    }
    fn init(&self, state: &mut [f64]) {
        self.slot.init(state);
    }
    fn traits(&self) -> ElementTraits {
        let section = &self.slot.section;
        ElementTraits {
            linear: section.is_linear(),
            symmetric: true,
            viscous: false,
            elapses: section.depends_on_time(),
            rayleigh: self.rayleigh,
        }
    }

    fn respond(&self, motion: &ElementInput<'_>, h: &mut Histories<'_>, output: ElementOutput<'_>) -> ElementResult {
        let mut e = [0.0; MAX_ORDER];
        e.iter_mut().zip(&self.rows).for_each(|(e, row)| *e = dot(row, motion.disp));
        self.slot.update(h.committed, &e, motion.dt, h.trial)?;
        for (s, row) in self.slot.resultant(h.trial).iter().zip(&self.rows) {
            output.force.iter_mut().zip(row).for_each(|(f, a)| *f += s * a);
        }
        if let Some(tangent) = output.tangent {
            self.add_stiffness(self.slot.stiffness(h.trial), tangent);
        }
        Ok(())
    }

    fn initial_tangent(&self, tangent: &mut [f64]) {
        let n = self.rows.len();
        let mut k = [0.0; MAX_ORDER * MAX_ORDER];
        self.slot.section.initial_stiffness(&mut k[..n * n]);
        self.add_stiffness(&k[..n * n], tangent);
    }

    fn roles(&self) -> Roles<'_> {
        Roles { parameters: Some(self), force_labels: ForceLabels::Numbered, ..Roles::default() }
    }

    fn probe(&self, words: &[&str]) -> Option<Probe> {
        let n = self.rows.len();
        let numbered = |stem: &'static str| (1..=n).map(move |i| format!("{stem}{i}"));
        Some(match *words.first()? {
            "basicForce" | "basicForces" | "localForce" | "localForces" => Probe::new(FORCE, numbered("P")),
            "defo" | "deformation" | "deformations" | "basicDeformation" => Probe::new(DEFORMATION, numbered("e")),
            "basicStiffness" => Probe::new(STIFFNESS, (1..=n * n).map(|i| format!("k{i}"))),
            "xaxis" => Probe::new(X_AXIS, ["x", "y", "z"]),
            "yaxis" => Probe::new(X_AXIS + 1, ["x", "y", "z"]),
            "zaxis" => Probe::new(Z_AXIS, ["x", "y", "z"]),
            "section" => {
                // Accept `section force` and `section 1 force`.
                let rest = &words[1..];
                let rest = rest.strip_prefix(&["1"]).unwrap_or(rest);
                return Some(self.slot.probe(rest)?.inside(&[SECTION]));
            }
            _ => return None,
        })
    }

    fn probe_names(&self) -> Vec<&'static str> {
        vec!["basicForce", "localForce", "deformation", "basicDeformation", "basicStiffness", "section"]
    }

    fn read(&self, path: &[u32], s: &Snapshot<'_>, out: &mut [f64]) {
        match path[0] {
            FORCE => out.copy_from_slice(self.slot.resultant(s.state)),
            DEFORMATION => out.copy_from_slice(self.slot.deformation(s.state)),
            STIFFNESS => out.copy_from_slice(self.slot.stiffness(s.state)),
            id @ X_AXIS..=Z_AXIS => {
                out.iter_mut().zip(self.axes.row((id - X_AXIS) as usize).iter()).for_each(|(o, a)| *o = *a);
            }
            _ => self.slot.read(&path[1..], s.state, out),
        }
    }
}

impl ElementParameters for ZeroLengthSection {
    fn with_parameter(&self, words: &[&str], value: NewValue) -> Changed<Arc<dyn Element>> {
        let mut new = self.clone();
        let words = words.strip_prefix(&["section"]).unwrap_or(words);
        let old = new.slot.set_parameter(words, value)?;
        Ok((Arc::new(new), old))
    }
}
