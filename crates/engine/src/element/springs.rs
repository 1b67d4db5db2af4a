//! Uniaxial springs side by side: what `zeroLength` and `twoNodeLink` have in common.

use super::{BasicRow, ElementError, ElementInput, ElementOutput, ElementTraits, Snapshot};
use crate::material::{Material, Slot, Strain, Stress};
use crate::probe::Probe;
use nalgebra::Matrix3;

/// Springs of an element, each with its deformation.
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
    /// Damper driven by the rate, if any.
    damper: Option<Slot>,
    /// Direction, from 1.
    direction: usize,
    /// Deformation from the displacements of all degrees of freedom.
    row: Vec<f64>,
    /// The same without zeros: places and coefficients.
    terms: Vec<(usize, f64)>,
    /// Deformation that it measures from.
    initial: f64,
    /// The next spring has the same deformation: its answer is added before the sum goes to the nodes.
    shared: bool,
}

impl Spring {
    /// Its deformation, or the rate of it, from the motion of all degrees of freedom.
    #[inline]
    fn measure(&self, motion: &[f64]) -> f64 {
        self.terms.iter().map(|&(i, r)| r * motion[i]).sum()
    }

    /// Add its stiffness to a matrix of `n` degrees of freedom.
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

    /// Add a spring (material, its tag) in a direction from 1 with its deformation from the displacements of all degrees
    /// of freedom, less `initial`; and a damper driven by the rate of the deformation.
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

    pub(super) fn state_len(&self) -> usize {
        self.state_len
    }

    fn slots(&self) -> impl Iterator<Item = &Slot> + Clone {
        self.springs.iter().flat_map(Spring::slots)
    }

    pub(super) fn init(&self, state: &mut [f64]) {
        self.slots().for_each(|slot| slot.init(state));
    }

    /// Directions that have a spring, rising.
    pub(super) fn directions(&self) -> Vec<usize> {
        let mut directions: Vec<usize> = self.springs.iter().map(|s| s.direction).collect();
        directions.sort_unstable();
        directions.dedup();
        directions
    }

    /// The deformations, once for each direction, which `direction` counts from 1 to 6, of nodes with so many dimensions and
    /// degrees of freedom.
    pub(super) fn basic_rows(&self, direction: impl Fn(usize) -> usize, nodes: (usize, usize)) -> Vec<BasicRow> {
        let mut rows: Vec<BasicRow> = vec![];
        for (column, s) in self.springs.iter().enumerate() {
            let direction = direction(s.direction);
            if rows.iter().all(|r| r.direction != direction) {
                rows.push(BasicRow::new(direction, column, &s.row, nodes).from_initial(s.initial));
            }
        }
        rows
    }

    /// Sum of the forces of the springs in a direction.
    pub(super) fn force_in(&self, direction: usize, state: &[f64]) -> f64 {
        self.springs.iter().filter(|s| s.direction == direction).map(|s| s.slot.stress(state)).sum()
    }

    pub(super) fn traits(&self) -> ElementTraits {
        let nature = ElementTraits::of(self.slots());
        let dampers = self.springs.iter().any(|s| s.damper.is_some());
        ElementTraits { linear: nature.linear && !dampers, viscous: nature.viscous || dampers, ..nature }
    }

    /// Add the springs' forces and tangents to `answer`.
    pub(super) fn respond(
        &self,
        motion: &ElementInput<'_>,
        committed: &[f64],
        trial: &mut [f64],
        answer: &mut ElementOutput<'_>,
    ) -> Result<(), ElementError> {
        // Of springs with one deformation.
        let (mut strain, mut sum) = (None, Stress::default());
        for s in &self.springs {
            let at = *strain.get_or_insert_with(|| {
                let value = s.measure(motion.disp) - s.initial;
                Strain { value, rate: s.measure(motion.vel), dt: motion.dt }
            });
            let stress = s.slot.update(committed, at, trial)?;
            sum.value += stress.value;
            sum.tangent += stress.tangent;
            sum.damping += stress.damping;
            if let Some(d) = &s.damper {
                // A damper's "strain" is the rate of deformation, so its tangent is the damping.
                let c = d.update(committed, Strain { value: at.rate, rate: 0.0, dt: motion.dt }, trial)?;
                sum.value += c.value;
                sum.damping += c.tangent;
            }
            if s.shared {
                continue;
            }
            s.terms.iter().for_each(|&(i, r)| answer.force[i] += sum.value * r);
            if let Some(k) = answer.tangent.as_deref_mut() {
                s.add_stiffness(k, s.row.len(), sum.tangent);
            }
            if let Some(c) = answer.damping.as_deref_mut() {
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

    /// Give a parameter of one material, or of all that have it, another value; the one it had.
    pub(super) fn set_parameter(&mut self, words: &[&str], value: f64) -> Option<f64> {
        if let ["material", i, rest @ ..] = words {
            let i = i.parse::<usize>().ok()?.checked_sub(1)?;
            return self.springs.get_mut(i)?.slot.set_parameter(rest, value);
        }
        self.springs.iter_mut().filter_map(|s| s.slot.set_parameter(words, value)).last()
    }

    /// A response by the words of a recorder command; `force` and `deformation` begin the names of its columns.
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

    /// Value of a probe; `strain` says what of a material is the deformation of a spring.
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
