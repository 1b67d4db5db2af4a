//! Common part of axial bars: material, mass and responses.

use super::{Class, ElementTraits, Mass, Snapshot};
use crate::material::Slot;
use crate::parameter::{NewValue, ParameterError, exchange, first};
use crate::probe::Probe;
use crate::section::Axial;

/// Data of an axial bar with any kinematics.
#[derive(Clone, Debug)]
pub(super) struct Bar {
    pub(super) slot: Slot,
    pub(super) options: BarOptions,
    /// Undeformed length.
    pub(super) length: f64,
    /// Number of translations of a node.
    pub(super) ndm: usize,
    /// Number of degrees of freedom of a node.
    pub(super) per_node: usize,
}

/// Properties of a bar.
#[derive(Clone, Debug)]
pub struct BarOptions {
    /// Cross-sectional area.
    pub area: f64,
    /// Mass per length.
    pub rho: f64,
    /// Consistent mass in place of lumped mass.
    pub consistent: bool,
    /// Rayleigh damping of the model applies.
    pub rayleigh: bool,
}

const AXIAL_FORCE: u32 = 2;
const DEFORMATION: u32 = 3;
const STIFFNESS: u32 = 4;
const MATERIAL: u32 = 5;
const LOCAL_FORCE: u32 = 6;
const ENERGY: u32 = 7;

impl Bar {
    pub(super) fn dofs(&self) -> usize {
        2 * self.per_node
    }

    pub(super) fn traits(&self) -> ElementTraits {
        ElementTraits { rayleigh: self.options.rayleigh, ..ElementTraits::of(std::iter::once(&self.slot)) }
    }

    pub(super) fn mass(&self) -> Mass {
        let (n, total) = (self.dofs(), self.options.rho * self.length);
        if total == 0.0 {
            return Mass::None;
        }
        let ends = (0..self.ndm).map(|i| (i, self.per_node + i));
        if !self.options.consistent {
            let mut m = vec![0.0; n];
            for i in ends.flat_map(|(i, j)| [i, j]) {
                m[i] = 0.5 * total;
            }
            return Mass::Lumped(m);
        }
        let mut m = vec![0.0; n * n];
        for (i, j) in ends {
            m[i * n + i] = total / 3.0;
            m[j * n + j] = total / 3.0;
            m[i * n + j] = total / 6.0;
            m[j * n + i] = total / 6.0;
        }
        Mass::Consistent(m)
    }

    /// Returns true if a section stands for a material and an area.
    fn has_section(&self) -> bool {
        self.slot.material.name() == Axial::NAME
    }

    /// The name of the class with a material, or that with a section.
    pub(super) fn class(&self, with_material: Class, with_section: Class) -> Class {
        if self.has_section() { with_section } else { with_material }
    }

    fn force(&self, state: &[f64]) -> f64 {
        self.options.area * self.slot.stress(state)
    }

    /// Sets a parameter of the bar or of its material; returns the previous value.
    pub(super) fn set_parameter(&mut self, words: &[&str], value: NewValue) -> Result<f64, ParameterError> {
        let place = match first(words)? {
            "A" => &mut self.options.area,
            "rho" => &mut self.options.rho,
            "material" => return self.slot.set_parameter(&words[1..], value),
            _ => return self.slot.set_parameter(words, value),
        };
        Ok(exchange(place, value))
    }

    pub(super) fn probe(&self, words: &[&str]) -> Option<Probe> {
        Some(match *words.first()? {
            "axialForce" | "basicForce" | "basicForces" => Probe::new(AXIAL_FORCE, ["N"]),
            "localForce" | "localForces" => Probe::new(LOCAL_FORCE, (1..=self.dofs()).map(|i| format!("P{i}"))),
            "defo" | "deformation" | "deformations" | "basicDefo" | "basicDeformation" | "basicDeformations" => {
                Probe::new(DEFORMATION, ["U"])
            }
            "basicStiffness" => Probe::new(STIFFNESS, ["K"]),
            "energy" | "Energy" => Probe::new(ENERGY, ["energy"]),
            "section" | "-section" if self.has_section() => {
                let number = words.get(1).is_some_and(|w| w.parse::<i32>().is_ok());
                let rest = &words[if number { 2 } else { 1 }..];
                return Some(self.slot.probe(&[&["section"], rest].concat())?.inside(&[MATERIAL]));
            }
            "material" | "-material" => {
                // Accept `material stress` and `material 1 stress`.
                let rest = &words[1..];
                let rest = if rest.first().is_some_and(|w| w.parse::<i32>().is_ok()) { &rest[1..] } else { rest };
                return Some(self.slot.probe(rest)?.inside(&[MATERIAL]));
            }
            // The force of the bar, not the resultants of its section.
            "force" | "forces" if self.has_section() => return None,
            _ => return self.slot.probe(words).map(|p| p.inside(&[MATERIAL])),
        })
    }

    pub(super) fn probe_names(&self) -> Vec<&'static str> {
        vec!["axialForce", "basicForce", "localForce", "deformation", "basicDeformation", "material"]
    }

    pub(super) fn read(&self, path: &[u32], s: &Snapshot<'_>, out: &mut [f64]) {
        match path[0] {
            AXIAL_FORCE => out[0] = self.force(s.state),
            LOCAL_FORCE => {
                out[0] = -self.force(s.state);
                out[self.per_node] = self.force(s.state);
            }
            DEFORMATION => out[0] = self.length * self.slot.shown_strain(s.state),
            ENERGY => out[0] = self.options.area * self.length * self.slot.energy(s.state),
            STIFFNESS => out[0] = self.options.area / self.length * self.slot.tangent(s.state),
            _ => self.slot.read(&path[1..], s.state, out),
        }
    }
}
