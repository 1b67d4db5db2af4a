//! Common part of `zeroLength` and `twoNodeLink`: uniaxial springs in parallel.

mod side_by_side;

use super::damping::BasicForces;
use super::{BasicRow, ElementInput, ElementOutput, ElementResult, ElementTraits, Histories, Snapshot};
use crate::material::{Material, Slot, Strain, Stress};
use crate::parameter::{NewValue, ParameterError, existing, index, last_of};
use crate::probe::Probe;
use nalgebra::Matrix3;

/// Springs of an element, each with its own deformation.
#[derive(Clone, Debug)]
pub(super) struct Springs {
    springs: Vec<Spring>,
    /// Local axes of the element as rows.
    axes: Matrix3<f64>,
    state_len: usize,
}

/// One material in one direction.
#[derive(Clone, Debug)]
struct Spring {
    slot: Slot,
    /// Damper with the rate of deformation as its strain.
    damper: Option<Slot>,
    /// Direction, 1 to 6.
    direction: usize,
    /// Derivatives of the deformation by the displacements.
    row: Vec<f64>,
    /// Nonzero entries of `row`: index and value.
    terms: Vec<(usize, f64)>,
    /// Deformation that is subtracted.
    initial: f64,
    /// The next spring has the same deformation: forces are summed before they go to the nodes.
    shared: bool,
}

impl Spring {
    /// Deformation from displacements, or its rate from velocities.
    #[inline]
    fn measure(&self, motion: &[f64]) -> f64 {
        self.terms.iter().map(|&(i, r)| r * motion[i]).sum()
    }

    /// Adds its stiffness to a matrix of `n` degrees of freedom.
    #[inline]
    fn add_stiffness(&self, matrix: &mut [f64], n: usize, stiffness: f64) {
        for &(i, ri) in &self.terms {
            for &(j, rj) in &self.terms {
                matrix[i * n + j] += stiffness * ri * rj;
            }
        }
    }

    /// The material, and the damper if there is one.
    fn slots(&self) -> impl Iterator<Item = &Slot> + Clone {
        std::iter::once(&self.slot).chain(&self.damper)
    }
}

impl Springs {
    pub(super) fn new(axes: Matrix3<f64>) -> Self {
        Self { springs: vec![], axes, state_len: 0 }
    }

    /// Adds a spring of a material and its tag. `row` times the displacements, less `initial`, is its deformation.
    /// `damper` has the rate of deformation as its strain.
    pub(super) fn add(
        &mut self,
        (material, tag): (Material, i32),
        direction: usize,
        (row, initial): (Vec<f64>, f64),
        damper: Option<(Material, i32)>,
    ) {
        let mut place = |(m, tag): (Material, i32)| {
            let slot = Slot::new(m, tag, self.state_len);
            self.state_len += slot.len();
            slot
        };
        let slot = place((material, tag));
        let damper = damper.map(place);
        let terms = row.iter().copied().enumerate().filter(|(_, r)| *r != 0.0).collect();
        if let Some(last) = self.springs.last_mut() {
            last.shared = last.row == row && last.initial == initial;
        }
        self.springs.push(Spring { slot, damper, direction, row, terms, initial, shared: false });
    }

    /// The material of a spring.
    pub(super) fn slot(&self, spring: usize) -> &Slot {
        &self.springs[spring].slot
    }

    pub(super) fn state_len(&self) -> usize {
        self.state_len
    }

    /// Materials and dampers.
    pub(super) fn slots(&self) -> impl Iterator<Item = &Slot> + Clone {
        self.springs.iter().flat_map(Spring::slots)
    }

    pub(super) fn init(&self, state: &mut [f64]) {
        self.slots().for_each(|slot| slot.init(state));
    }

    /// Directions with a spring, increasing.
    pub(super) fn directions(&self) -> Vec<usize> {
        let mut directions: Vec<usize> = self.springs.iter().map(|s| s.direction).collect();
        directions.sort_unstable();
        directions.dedup();
        directions
    }

    /// Basic deformations, one for each direction; `direction` maps a direction to 1 to 6. `nodes` are the numbers of
    /// dimensions and of degrees of freedom per node.
    pub(super) fn basic_rows(&self, direction: impl Fn(usize) -> usize, nodes: (usize, usize)) -> Vec<BasicRow> {
        let mut rows: Vec<BasicRow> = vec![];
        for (column, s) in self.springs.iter().enumerate() {
            let direction = direction(s.direction);
            if let Some(row) = rows.iter_mut().find(|r| r.direction == direction) {
                row.further_columns.push(column);
                continue;
            }
            let row = BasicRow::new(direction, column, &s.row, nodes).from_initial(s.initial);
            rows.push(row.of_material(column + 1, 1.0, 1.0));
        }
        rows
    }

    /// Sum of the forces of the springs in a direction.
    pub(super) fn force_in(&self, direction: usize, state: &[f64]) -> f64 {
        self.springs.iter().filter(|s| s.direction == direction).map(|s| s.slot.stress(state)).sum()
    }

    pub(super) fn traits(&self) -> ElementTraits {
        let traits = ElementTraits::of(self.slots());
        let dampers = self.springs.iter().any(|s| s.damper.is_some());
        ElementTraits { linear: traits.linear && !dampers, viscous: traits.viscous || dampers, ..traits }
    }

    /// Adds the forces and tangents of the springs to `output`.
    pub(super) fn respond(
        &self,
        motion: &ElementInput<'_>,
        h: &mut Histories<'_>,
        output: &mut ElementOutput<'_>,
    ) -> ElementResult {
        // Sum over springs with the same deformation.
        let (mut strain, mut sum) = (None, Stress::default());
        for s in &self.springs {
            let at = *strain.get_or_insert_with(|| {
                let value = s.measure(motion.disp) - s.initial;
                Strain { value, rate: s.measure(motion.vel), dt: motion.dt }
            });
            let stress = s.slot.update(h.committed, at, h.trial)?;
            sum.value += stress.value;
            sum.tangent += stress.tangent;
            sum.damping += stress.damping;
            if let Some(d) = &s.damper {
                // The strain of a damper is a rate, so its tangent is the damping.
                let c = d.update(h.committed, Strain { value: at.rate, rate: 0.0, dt: motion.dt }, h.trial)?;
                sum.value += c.value;
                sum.damping += c.tangent;
            }
            if s.shared {
                continue;
            }
            s.terms.iter().for_each(|&(i, r)| output.force[i] += sum.value * r);
            if let Some(k) = output.tangent.as_deref_mut() {
                s.add_stiffness(k, s.row.len(), sum.tangent);
            }
            if let Some(c) = output.damping.as_deref_mut() {
                s.add_stiffness(c, s.row.len(), sum.damping);
            }
            (strain, sum) = (None, Stress::default());
        }
        Ok(())
    }

    pub(super) fn initial_tangent(&self, tangent: &mut [f64]) {
        for s in &self.springs {
            s.add_stiffness(tangent, s.row.len(), s.slot.material.initial_tangent());
        }
    }

    /// Sets a parameter of one material, or of all materials that have it; returns the previous value.
    pub(super) fn set_parameter(&mut self, words: &[&str], value: NewValue) -> Result<f64, ParameterError> {
        if let ["material", i, rest @ ..] = words {
            let spring = existing(self.springs.get_mut(index(i)?))?;
            return spring.slot.set_parameter(rest, value);
        }
        last_of(self.springs.iter_mut().map(|s| s.slot.set_parameter(words, value)))
    }

    /// The response for the arguments of a recorder; column names begin with `force` and `deformation`.
    pub(super) fn probe(&self, words: &[&str], force: &str, deformation: &str) -> Option<Probe> {
        let n = self.springs.len();
        let numbered = |stem: &str| (1..=n).map(|i| format!("{stem}{i}")).collect::<Vec<_>>();
        Some(match *words.first()? {
            "basicForce" | "basicForces" => Probe::new(BASIC_FORCE, numbered(force)),
            "defo" | "deformation" | "deformations" | "basicDeformation" | "basicDeformations"
            | "basicDisplacement" | "basicDisplacements" => Probe::new(DEFORMATION, numbered(deformation)),
            "defoANDforce" | "deformationANDforce" | "deformationANDforces" | "deformationsANDforces" => {
                Probe::new(BOTH, numbered(deformation).into_iter().chain(numbered(force)))
            }
            "basicStiffness" => Probe::new(STIFFNESS, (1..=n * n).map(|i| format!("k{i}"))),
            "xaxis" => Probe::new(X_AXIS, ["x", "y", "z"]),
            "yaxis" => Probe::new(X_AXIS + 1, ["x", "y", "z"]),
            "zaxis" => Probe::new(Z_AXIS, ["x", "y", "z"]),
            "materials" => Probe::new(MATERIALS, numbered("material")),
            "directions" => Probe::new(DIRECTIONS, numbered("direction")),
            "material" => {
                let i = words.get(1)?.parse::<usize>().ok()?.checked_sub(1)?;
                let (slot, id, k) = match self.springs.get(i) {
                    Some(s) => (&s.slot, MATERIAL, i),
                    None => (self.springs.get(i.checked_sub(n)?)?.damper.as_ref()?, DAMPER, i - n),
                };
                return Some(slot.probe(&words[2..])?.inside(&[id, k as u32]));
            }
            _ => return None,
        })
    }

    /// Value of a response; `strain` gives the deformation of a spring from its material.
    pub(super) fn read(&self, path: &[u32], s: &Snapshot<'_>, strain: impl Fn(&Slot, &[f64]) -> f64, out: &mut [f64]) {
        let n = self.springs.len();
        match path[0] {
            id @ X_AXIS..=Z_AXIS => {
                out.iter_mut().zip(self.axes.row((id - X_AXIS) as usize).iter()).for_each(|(o, a)| *o = *a);
            }
            MATERIAL => self.springs[path[1] as usize].slot.read(&path[2..], s.state, out),
            DAMPER => {
                if let Some(d) = &self.springs[path[1] as usize].damper {
                    d.read(&path[2..], s.state, out);
                }
            }
            id => {
                for (i, spring) in self.springs.iter().enumerate() {
                    match id {
                        BASIC_FORCE => out[i] = spring.slot.stress(s.state),
                        DEFORMATION => out[i] = strain(&spring.slot, s.state),
                        BOTH => {
                            out[i] = strain(&spring.slot, s.state);
                            out[n + i] = spring.slot.stress(s.state);
                        }
                        STIFFNESS => out[i * n + i] = spring.slot.tangent(s.state),
                        MATERIALS => out[i] = f64::from(spring.slot.tag),
                        _ => out[i] = spring.direction as f64,
                    }
                }
            }
        }
    }
}

impl BasicForces for Springs {
    fn len(&self) -> usize {
        self.springs.len()
    }
    fn basic_forces(&self, _: &[f64], state: &[f64], _: &[f64], out: &mut [f64]) {
        out.iter_mut().zip(&self.springs).for_each(|(q, s)| *q = s.slot.stress(state));
    }
    fn add_global(&self, _: &[f64], _: &[f64], q: &[f64], force: &mut [f64]) {
        for (spring, q) in self.springs.iter().zip(q) {
            spring.terms.iter().for_each(|&(i, r)| force[i] += q * r);
        }
    }
    fn scale_stiffness(&self, _: &[f64], state: &[f64], factor: f64, tangent: &mut [f64]) {
        for s in &self.springs {
            s.add_stiffness(tangent, s.row.len(), factor * s.slot.tangent(state));
        }
    }
}

const BASIC_FORCE: u32 = 2;
const DEFORMATION: u32 = 3;
const BOTH: u32 = 4;
const STIFFNESS: u32 = 13;
const X_AXIS: u32 = 20;
const Z_AXIS: u32 = 22;
const MATERIALS: u32 = 23;
const DIRECTIONS: u32 = 24;
const MATERIAL: u32 = 30;
const DAMPER: u32 = 31;
