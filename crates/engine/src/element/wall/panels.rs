//! Walls of panels in plane stress: `SFI_MVLEM`, `E_SFI`, `SFI_MVLEM_3D` and `E_SFI_MVLEM_3D`.

use super::{LOCAL_FORCE, PLANE_WALL, WallShape};
use crate::element::roles::{ForceLabels, Inertia, Roles};
use crate::element::{
    Class, Element, ElementInput, ElementOutput, ElementResult, ElementTraits, Histories, Mass, Snapshot, dot,
};
use crate::material::multiaxial::{Condensed, STRIP, WallStrip};
use crate::material::{PLANE, SharedMultiaxial};
use crate::numeric::axpy;
use crate::probe::Probe;
use std::ops::Range;
use std::sync::Arc;

/// Source of the horizontal strain of a panel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PanelLaw {
    /// The horizontal stress is zero.
    NoStress,
    /// A function of the shear strain (Massone, Lopez and Kolozvari, 2021).
    FromShear,
    /// The same, less with more horizontal bars.
    FromShearAndBars,
}

/// A panel of a wall, from the left to the right.
#[derive(Clone, Debug)]
pub struct WallPanel {
    /// Thickness of the wall.
    pub thickness: f64,
    /// Width of the strip.
    pub width: f64,
    /// Law in plane stress.
    pub law: SharedMultiaxial<PLANE>,
}

#[derive(Clone, Debug)]
struct Strip<const D: usize> {
    law: SharedMultiaxial<STRIP>,
    /// Vertical and shear strain by the displacements.
    rows: [[f64; D]; STRIP],
    volume: f64,
    at: usize,
}

/// Panels with a vertical strain and a common shear strain (Kolozvari, Orakcal and Wallace, 2015).
#[derive(Clone, Debug)]
pub struct WallPanels<const D: usize> {
    class: Class,
    strips: Vec<Strip<D>>,
    state_len: usize,
    shape: WallShape<D>,
}

impl<const D: usize> WallPanels<D> {
    /// Makes a wall of panels.
    pub fn new(panels: Vec<WallPanel>, kind: PanelLaw, shape: WallShape<D>) -> Self {
        let mut left = -0.5 * panels.iter().map(|p| p.width).sum::<f64>();
        let shear = shape.shear().map(|r| -r / shape.height);
        let (mut strips, mut at) = (vec![], 0);
        for panel in panels {
            let x = left + 0.5 * panel.width;
            left += panel.width;
            let law: SharedMultiaxial<STRIP> = match kind {
                PanelLaw::NoStress => Condensed::strip(&panel.law),
                PanelLaw::FromShear => Arc::new(WallStrip::new(panel.law, false)),
                PanelLaw::FromShearAndBars => Arc::new(WallStrip::new(panel.law, true)),
            };
            let rows = [shape.vertical_strain(x), shear];
            let volume = panel.thickness * panel.width * shape.height;
            strips.push(Strip { rows, volume, at, law: Arc::clone(&law) });
            at += law.state_len();
        }
        let class = match (kind, D == PLANE_WALL) {
            (PanelLaw::NoStress, true) => Class::new("SFI_MVLEM", 163),
            (PanelLaw::NoStress, false) => Class::new("SFI_MVLEM_3D", 213),
            (_, true) => Class::new("E_SFI", 257),
            (_, false) => Class::new("E_SFI_MVLEM_3D", 259_259),
        };
        Self { class, strips, state_len: at, shape }
    }

    /// Laws of the strips with the ranges of their states.
    fn laws(&self) -> impl Iterator<Item = (Range<usize>, &SharedMultiaxial<STRIP>)> {
        self.strips.iter().map(|strip| (strip.at..strip.at + strip.law.state_len(), &strip.law))
    }

    fn add_tangent(&self, strip: &Strip<D>, tangent: &[[f64; STRIP]; STRIP], matrix: &mut [f64]) {
        for (a, tangent) in strip.rows.iter().zip(tangent) {
            let mut by_disp = [0.0; D];
            strip.rows.iter().zip(tangent).for_each(|(b, k)| axpy(strip.volume * k, b, &mut by_disp));
            for (a, out) in a.iter().zip(matrix.chunks_exact_mut(D)).filter(|(a, _)| **a != 0.0) {
                axpy(*a, &by_disp, out);
            }
        }
    }
}

const SHEAR: u32 = 2;
const CURVATURE: u32 = 3;
const PANEL: u32 = 4;

crate::watches_columns!([const D: usize] WallPanels<D> => |s| at s.laws());

impl<const D: usize> Element for WallPanels<D> {
    fn class(&self) -> Class {
        self.class
    }
    fn dofs(&self) -> usize {
        D
    }
    fn state_len(&self) -> usize {
        self.state_len
    }
    fn init(&self, state: &mut [f64]) {
        for strip in &self.strips {
            strip.law.init(&mut state[strip.at..strip.at + strip.law.state_len()]);
        }
    }
    fn traits(&self) -> ElementTraits {
        ElementTraits {
            linear: self.strips.iter().all(|s| s.law.is_linear()),
            symmetric: self.strips.iter().all(|s| s.law.is_symmetric()),
            viscous: false,
            elapses: self.strips.iter().any(|s| s.law.depends_on_time()),
            rayleigh: true,
        }
    }

    fn respond(&self, m: &ElementInput<'_>, h: &mut Histories<'_>, mut output: ElementOutput<'_>) -> ElementResult {
        for strip in &self.strips {
            let strain = strip.rows.each_ref().map(|row| dot(row, m.disp));
            let own = strip.at..strip.at + strip.law.state_len();
            let (stress, tangent) = strip.law.update(&h.committed[own.clone()], &strain, m.dt, &mut h.trial[own])?;
            for (row, stress) in strip.rows.iter().zip(stress) {
                axpy(strip.volume * stress, row, output.force);
            }
            if let Some(k) = output.tangent.as_deref_mut() {
                self.add_tangent(strip, &tangent, k);
            }
        }
        for (force, row) in output.force.iter_mut().zip(self.shape.stiffness.chunks_exact(D)) {
            *force += dot(row, m.disp);
        }
        if let Some(k) = output.tangent.filter(|_| !self.shape.stiffness.is_empty()) {
            axpy(1.0, &self.shape.stiffness, k);
        }
        Ok(())
    }

    fn initial_tangent(&self, tangent: &mut [f64]) {
        for strip in &self.strips {
            self.add_tangent(strip, &strip.law.initial_tangent(), tangent);
        }
        if !self.shape.stiffness.is_empty() {
            axpy(1.0, &self.shape.stiffness, tangent);
        }
    }

    fn roles(&self) -> Roles<'_> {
        Roles { mass: Some(self), force_labels: ForceLabels::Wall, ..Roles::default() }
    }

    fn probe(&self, words: &[&str]) -> Option<Probe> {
        Some(match words {
            ["ShearDef" | "sheardef", ..] => Probe::new(SHEAR, ["Dsh"]),
            ["Curvature" | "curvature", ..] => Probe::new(CURVATURE, ["fi"]),
            ["RCpanel" | "RCPanel" | "RC_panel" | "RC_Panel" | "material", panel, rest @ ..] => {
                let panel = panel.parse::<usize>().ok().filter(|p| (1..=self.strips.len()).contains(p))? - 1;
                self.strips[panel].law.probe(rest)?.inside(&[PANEL, panel as u32])
            }
            _ => return self.shape.local_force_probe(words),
        })
    }

    fn probe_names(&self) -> Vec<&'static str> {
        let plane = ["ShearDef", "Curvature", "RCPanel"];
        plane.into_iter().chain(self.shape.axes.is_some().then_some("localForce")).collect()
    }

    fn read(&self, path: &[u32], s: &Snapshot<'_>, out: &mut [f64]) {
        match path[0] {
            SHEAR => out[0] = -dot(&self.shape.shear(), s.disp),
            CURVATURE => out[0] = dot(&self.shape.curvature(), s.disp),
            LOCAL_FORCE => self.shape.local_force(s.force, out),
            _ => {
                let strip = &self.strips[path[1] as usize];
                strip.law.read(&path[2..], &s.state[strip.at..strip.at + strip.law.state_len()], out);
            }
        }
    }
}

impl<const D: usize> Inertia for WallPanels<D> {
    fn mass(&self) -> Mass {
        self.shape.mass.clone()
    }
}
