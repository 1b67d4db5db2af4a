//! Multiple-vertical-line element of walls: `MVLEM`.

use super::{Element, ElementError, ElementInput, ElementOutput, ElementTraits, Mass, Snapshot, dot};
use crate::material::{Material, Slot, Strain};
use crate::numeric::axpy;
use crate::probe::Probe;

const DOFS: usize = 6;

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
struct Line {
    slot: Slot,
    row: [f64; DOFS],
    weight: f64,
}

/// Vertical uniaxial fibres between two rigid beams, and a spring for the shear at a height `c h` (Vulcano, Bertero and
/// Colotti, 1988; Orakcal, Wallace and Conte, 2004). Node i is below node j.
#[derive(Clone, Debug)]
pub struct WallLines {
    /// Concrete of each fibre, steel of each fibre, and the shear spring.
    lines: Vec<Line>,
    fibres: usize,
    state_len: usize,
    /// Mass at each node.
    mass: f64,
}

impl WallLines {
    /// Makes a wall of the height `height` with fibres from the left to the right. `shear` relates the shear force to
    /// the shear deformation, at `centre` times the height. `density` is a mass per volume.
    pub fn new(fibres: Vec<WallFibre>, shear: (Material, i32), height: f64, centre: f64, density: f64) -> Self {
        let length: f64 = fibres.iter().map(|f| f.width).sum();
        let area: f64 = fibres.iter().map(|f| f.width * f.thickness).sum();
        let mut made = Self { lines: vec![], fibres: fibres.len(), state_len: 0, mass: 0.5 * density * area * height };
        let mut left = -0.5 * length;
        let (mut concrete, mut steel) = (vec![], vec![]);
        for f in fibres {
            let x = left + 0.5 * f.width;
            left += f.width;
            let row = [0.0, -1.0, -x, 0.0, 1.0, x].map(|r| r / height);
            let gross = f.width * f.thickness;
            let bars = gross * f.ratio;
            concrete.push((f.concrete, row, (gross - bars) * height));
            steel.push((f.steel, row, bars * height));
        }
        let shear_row = [1.0, 0.0, -centre * height, -1.0, 0.0, -(1.0 - centre) * height];
        for ((material, tag), row, weight) in concrete.into_iter().chain(steel).chain([(shear, shear_row, 1.0)]) {
            let slot = Slot::new(material, tag, made.state_len);
            made.state_len += slot.len();
            made.lines.push(Line { slot, row, weight });
        }
        made
    }

    fn slots(&self) -> impl Iterator<Item = &Slot> + Clone {
        self.lines.iter().map(|l| &l.slot)
    }
}

/// Adds `stiffness row^T row` to a matrix.
fn add_stiffness(matrix: &mut [f64], row: &[f64; DOFS], stiffness: f64) {
    for (out, r) in matrix.chunks_exact_mut(DOFS).zip(row) {
        axpy(stiffness * r, row, out);
    }
}

impl Element for WallLines {
    fn class(&self) -> &'static str {
        "MVLEM"
    }
    fn dofs(&self) -> usize {
        DOFS
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

    fn respond(
        &self,
        motion: &ElementInput<'_>,
        committed: &[f64],
        trial: &mut [f64],
        mut output: ElementOutput<'_>,
    ) -> Result<(), ElementError> {
        for line in &self.lines {
            let strain = Strain { value: dot(&line.row, motion.disp), rate: dot(&line.row, motion.vel), dt: motion.dt };
            let stress = line.slot.update(committed, strain, trial)?;
            axpy(line.weight * stress.value, &line.row, output.force);
            if let Some(k) = output.tangent.as_deref_mut() {
                add_stiffness(k, &line.row, line.weight * stress.tangent);
            }
            if let Some(c) = output.damping.as_deref_mut() {
                add_stiffness(c, &line.row, line.weight * stress.damping);
            }
        }
        Ok(())
    }

    fn initial_tangent(&self, tangent: &mut [f64]) {
        for line in &self.lines {
            add_stiffness(tangent, &line.row, line.weight * line.slot.material.initial_tangent());
        }
    }

    fn mass(&self) -> Mass {
        if self.mass == 0.0 {
            return Mass::None;
        }
        Mass::Lumped(vec![self.mass, self.mass, 0.0, self.mass, self.mass, 0.0])
    }

    fn probe(&self, words: &[&str]) -> Option<Probe> {
        let numbered = |stem: &str| (1..=self.fibres).map(|i| format!("{stem}{i}")).collect::<Vec<_>>();
        Some(match *words.first()? {
            "curvature" | "Curvature" => Probe::new(CURVATURE, ["fi"]),
            "fiber_strain" | "Fiber_Strain" => Probe::new(STRAIN, numbered("ey")),
            "fiber_stress_concrete" | "Fiber_Stress_Concrete" => Probe::new(CONCRETE, numbered("syc")),
            "fiber_stress_steel" | "Fiber_Stress_Steel" => Probe::new(STEEL, numbered("sys")),
            "shear_force_deformation" | "Shear_Force_Deformation" => Probe::new(SHEAR, ["shD", "shF"]),
            _ => return None,
        })
    }

    fn probe_names(&self) -> &'static [&'static str] {
        &["curvature", "fiber_strain", "fiber_stress_concrete", "fiber_stress_steel", "shear_force_deformation"]
    }

    fn read(&self, path: &[u32], s: &Snapshot<'_>, out: &mut [f64]) {
        let n = self.fibres;
        let strain = |line: &Line| dot(&line.row, s.disp);
        let stresses = |lines: &[Line], out: &mut [f64]| {
            lines.iter().zip(out).for_each(|(l, out)| *out = l.slot.stress(s.state));
        };
        match path[0] {
            CURVATURE => {
                // The coefficient of the vertical displacement of j is the inverse height.
                out[0] = (s.disp[5] - s.disp[2]) * self.lines[0].row[4];
            }
            STRAIN => self.lines[..n].iter().zip(out).for_each(|(l, out)| *out = strain(l)),
            CONCRETE => stresses(&self.lines[..n], out),
            STEEL => stresses(&self.lines[n..2 * n], out),
            _ => {
                out[0] = self.lines[2 * n].slot.strain(s.state);
                out[1] = self.lines[2 * n].slot.stress(s.state);
            }
        }
    }
}

const CURVATURE: u32 = 2;
const STRAIN: u32 = 3;
const CONCRETE: u32 = 4;
const STEEL: u32 = 5;
const SHEAR: u32 = 6;
