//! Multiple-vertical-line elements of walls: `MVLEM` and `MVLEM_3D`.

use super::{LOCAL_FORCE, PLANE_WALL, WallShape, add_stiffness};
use crate::element::roles::{ForceLabels, Inertia, Roles};
use crate::element::{
    Class, Element, ElementInput, ElementOutput, ElementResult, ElementTraits, Histories, Mass, Snapshot, dot,
};
use crate::material::{Material, Slot, Strain};
use crate::numeric::axpy;
use crate::probe::Probe;

/// One vertical strip of a wall: two materials with one strain.
#[derive(Clone, Debug)]
pub struct WallFibre {
    /// Thickness of the wall.
    pub thickness: f64,
    /// Width of the strip.
    pub width: f64,
    /// Area of the reinforcement as a share of the area of the strip.
    pub ratio: f64,
    /// Concrete and its tag.
    pub concrete: (Material, i32),
    /// Reinforcement and its tag.
    pub steel: (Material, i32),
}

/// A material of a row of the element: its strain is `row` times the displacements, its force `weight` times the stress.
#[derive(Clone, Debug)]
struct Line<const D: usize> {
    slot: Slot,
    row: [f64; D],
    weight: f64,
}

/// Vertical uniaxial fibres between two rigid beams, and a spring for the shear at a height `c h` (Vulcano, Bertero and
/// Colotti, 1988; Orakcal, Wallace and Conte, 2004). Node i is below node j.
#[derive(Clone, Debug)]
pub struct WallLines<const D: usize> {
    /// Concrete of each fibre, steel of each fibre, and the shear spring.
    lines: Vec<Line<D>>,
    fibres: usize,
    state_len: usize,
    shape: WallShape<D>,
}

impl<const D: usize> WallLines<D> {
    /// Makes a wall with fibres from the left to the right. `shear` relates the shear force to the shear deformation at the
    /// centre of rotation.
    pub fn new(fibres: Vec<WallFibre>, shear: (Material, i32), shape: WallShape<D>) -> Self {
        let count = fibres.len();
        let mut left = -0.5 * fibres.iter().map(|f| f.width).sum::<f64>();
        let (mut concrete, mut steel) = (vec![], vec![]);
        for f in fibres {
            let x = left + 0.5 * f.width;
            left += f.width;
            let row = shape.vertical_strain(x);
            let gross = f.width * f.thickness;
            let bars = gross * f.ratio;
            concrete.push((f.concrete, row, (gross - bars) * shape.height));
            steel.push((f.steel, row, bars * shape.height));
        }
        let shear = (shear, shape.shear(), 1.0);
        let (mut lines, mut state_len) = (vec![], 0);
        for ((material, tag), row, weight) in concrete.into_iter().chain(steel).chain([shear]) {
            let slot = Slot::new(material, tag, state_len);
            state_len += slot.len();
            lines.push(Line { slot, row, weight });
        }
        Self { lines, fibres: count, state_len, shape }
    }

    fn slots(&self) -> impl Iterator<Item = &Slot> + Clone {
        self.lines.iter().map(|l| &l.slot)
    }
}

crate::watches_columns!([const D: usize] WallLines<D> => |s| in s.slots());

impl<const D: usize> Element for WallLines<D> {
    fn class(&self) -> Class {
        if D == PLANE_WALL { Class::new("MVLEM", 162) } else { Class::new("MVLEM_3D", 212) }
    }
    fn dofs(&self) -> usize {
        D
    }
    fn state_len(&self) -> usize {
        self.state_len
    }
    fn init(&self, state: &mut [f64]) {
        self.slots().for_each(|slot| slot.init(state));
    }
    fn traits(&self) -> ElementTraits {
        ElementTraits { rayleigh: true, ..ElementTraits::of(self.slots()) }
    }

    fn respond(&self, motion: &ElementInput<'_>, h: &mut Histories<'_>, mut out: ElementOutput<'_>) -> ElementResult {
        for line in &self.lines {
            let strain = Strain { value: dot(&line.row, motion.disp), rate: dot(&line.row, motion.vel), dt: motion.dt };
            let stress = line.slot.update(h.committed, strain, h.trial)?;
            axpy(line.weight * stress.value, &line.row, out.force);
            if let Some(k) = out.tangent.as_deref_mut() {
                add_stiffness(k, &line.row, line.weight * stress.tangent);
            }
            if let Some(c) = out.damping.as_deref_mut() {
                add_stiffness(c, &line.row, line.weight * stress.damping);
            }
        }
        for (force, row) in out.force.iter_mut().zip(self.shape.stiffness.chunks_exact(D)) {
            *force += dot(row, motion.disp);
        }
        if let Some(k) = out.tangent.filter(|_| !self.shape.stiffness.is_empty()) {
            axpy(1.0, &self.shape.stiffness, k);
        }
        Ok(())
    }

    fn initial_tangent(&self, tangent: &mut [f64]) {
        for line in &self.lines {
            add_stiffness(tangent, &line.row, line.weight * line.slot.material.initial_tangent());
        }
        if !self.shape.stiffness.is_empty() {
            axpy(1.0, &self.shape.stiffness, tangent);
        }
    }

    fn roles(&self) -> Roles<'_> {
        Roles { mass: Some(self), force_labels: ForceLabels::Wall, ..Roles::default() }
    }

    fn probe(&self, words: &[&str]) -> Option<Probe> {
        let numbered = |stem: &str| (1..=self.fibres).map(|i| format!("{stem}{i}")).collect::<Vec<_>>();
        Some(match *words.first()? {
            "curvature" | "Curvature" => Probe::new(CURVATURE, ["fi"]),
            "fiber_strain" | "Fiber_Strain" => Probe::new(STRAIN, numbered("ey")),
            "fiber_stress_concrete" | "Fiber_Stress_Concrete" => Probe::new(CONCRETE, numbered("syc")),
            "fiber_stress_steel" | "Fiber_Stress_Steel" => Probe::new(STEEL, numbered("sys")),
            "shear_force_deformation" | "Shear_Force_Deformation" => Probe::new(SHEAR, ["shD", "shF"]),
            _ => return self.shape.local_force_probe(words),
        })
    }

    fn probe_names(&self) -> Vec<&'static str> {
        let plane =
            ["curvature", "fiber_strain", "fiber_stress_concrete", "fiber_stress_steel", "shear_force_deformation"];
        plane.into_iter().chain(self.shape.axes.is_some().then_some("localForce")).collect()
    }

    fn read(&self, path: &[u32], s: &Snapshot<'_>, out: &mut [f64]) {
        let n = self.fibres;
        let strain = |line: &Line<D>| dot(&line.row, s.disp);
        let stresses = |lines: &[Line<D>], out: &mut [f64]| {
            lines.iter().zip(out).for_each(|(l, out)| *out = l.slot.stress(s.state));
        };
        match path[0] {
            CURVATURE => out[0] = dot(&self.shape.curvature(), s.disp),
            STRAIN => self.lines[..n].iter().zip(out).for_each(|(l, out)| *out = strain(l)),
            CONCRETE => stresses(&self.lines[..n], out),
            STEEL => stresses(&self.lines[n..2 * n], out),
            LOCAL_FORCE => self.shape.local_force(s.force, out),
            _ => {
                out[0] = self.lines[2 * n].slot.strain(s.state);
                out[1] = self.lines[2 * n].slot.stress(s.state);
            }
        }
    }
}

impl<const D: usize> Inertia for WallLines<D> {
    fn mass(&self) -> Mass {
        self.shape.mass.clone()
    }
}

const CURVATURE: u32 = 2;
const STRAIN: u32 = 3;
const CONCRETE: u32 = 4;
const STEEL: u32 = 5;
const SHEAR: u32 = 6;
