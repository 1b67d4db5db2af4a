//! Springs between two nodes at one place: `zeroLength`.

use super::{Answer, BasicRow, Element, ElementError, Motion, Nature, Snapshot, add_outer, dot};
use crate::material::{Material, Slot, Strain};
use crate::probe::Probe;
use nalgebra::Matrix3;

/// What damping a `zeroLength` takes besides that of its materials.
#[derive(Clone, Debug)]
pub enum RayleighDamping {
    /// None: the default.
    None,
    /// The Rayleigh damping of the model (`-doRayleigh 1`).
    Model,
    /// A material for each spring, driven by the rate of deformation (`-dampMats`).
    Materials(Vec<(Material, i32)>),
}

/// Uniaxial springs between two nodes, each along or about an axis of the element.
#[derive(Clone, Debug)]
pub struct ZeroLength {
    springs: Vec<Spring>,
    ndm: usize,
    dofs: usize,
    axes: Matrix3<f64>,
    /// Relative displacement of the nodes when the element was made: it measures from there.
    initial: Vec<f64>,
    rayleigh: bool,
    linear: bool,
    viscous: bool,
    elapses: bool,
    state_len: usize,
}

/// One material in one direction.
#[derive(Clone, Debug)]
struct Spring {
    slot: Slot,
    /// Damper driven by the rate, if any.
    damper: Option<Slot>,
    /// Direction, 1 to 6.
    direction: usize,
    /// Deformation from the displacements of all degrees of freedom.
    row: Vec<f64>,
}

impl Spring {
    /// The material, and the damper if there is one.
    fn slots(&self) -> impl Iterator<Item = &Slot> {
        std::iter::once(&self.slot).chain(&self.damper)
    }
}

impl ZeroLength {
    /// Springs (material, its tag, direction 1 to 6) between two nodes with `per_node` degrees of freedom each in a
    /// model of `ndm` dimensions; `axes` has the local axes as rows, `initial` the displacement of node j less that
    /// of node i, length `per_node`.
    ///
    /// # Errors
    /// A direction that the nodes have no degree of freedom for.
    pub fn new(
        springs: Vec<(Material, i32, usize)>,
        ndm: usize,
        per_node: usize,
        axes: Matrix3<f64>,
        initial: Vec<f64>,
        damping: RayleighDamping,
    ) -> Result<Self, ElementError> {
        let mut at = 0;
        let mut place = |m: Material, tag: i32| {
            let slot = Slot::new(m, tag, at);
            at += slot.len();
            slot
        };
        let mut made = Vec::with_capacity(springs.len());
        for (k, (material, tag, direction)) in springs.into_iter().enumerate() {
            let half = direction_row(direction, ndm, per_node, &axes)
                .ok_or_else(|| ElementError(no_direction(direction, ndm, per_node)))?;
            let row = half.iter().map(|c| -c).chain(half.iter().copied()).collect();
            let slot = place(material, tag);
            let damper = match &damping {
                RayleighDamping::Materials(m) => m.get(k).map(|(m, tag)| place(m.clone(), *tag)),
                _ => None,
            };
            made.push(Spring { slot, damper, direction, row });
        }
        let linear = made.iter().all(|s| s.slot.material.is_linear() && s.damper.is_none());
        let viscous = made.iter().any(|s| s.slot.material.is_viscous() || s.damper.is_some());
        let elapses = made.iter().any(|s| s.slots().any(|slot| slot.material.depends_on_time()));
        Ok(Self {
            springs: made,
            ndm,
            dofs: 2 * per_node,
            axes,
            initial,
            rayleigh: matches!(damping, RayleighDamping::Model),
            linear,
            viscous,
            elapses,
            state_len: at,
        })
    }

    /// Deformation of a spring, from the full displacements.
    #[inline]
    fn deformation(&self, spring: &Spring, disp: &[f64]) -> f64 {
        dot(&spring.row, disp) - dot(&spring.row[self.initial.len()..], &self.initial)
    }
}

fn no_direction(direction: usize, ndm: usize, per_node: usize) -> String {
    format!("direction {direction} has no degree of freedom at nodes with {per_node} in {ndm} dimensions")
}

/// Share of each degree of freedom of a node in a direction.
fn direction_row(direction: usize, ndm: usize, per_node: usize, axes: &Matrix3<f64>) -> Option<Vec<f64>> {
    let mut row = vec![0.0; per_node];
    let axis = axes.row((direction - 1) % 3);
    let rotation = direction > 3;
    match (ndm, per_node, rotation) {
        (1, 1, false) => row[0] = axis[0],
        (2, 2 | 3, false) => row[..2].copy_from_slice(&[axis[0], axis[1]]),
        (2, 3, true) => row[2] = axis[2],
        (3, 3 | 6, false) => row[..3].copy_from_slice(&[axis[0], axis[1], axis[2]]),
        (3, 6, true) => row[3..].copy_from_slice(&[axis[0], axis[1], axis[2]]),
        _ => return None,
    }
    row.iter().any(|&c| c != 0.0).then_some(row)
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

impl Element for ZeroLength {
    fn class(&self) -> &'static str {
        "ZeroLength"
    }
    fn dofs(&self) -> usize {
        self.dofs
    }
    fn state_len(&self) -> usize {
        self.state_len
    }
    fn init(&self, state: &mut [f64]) {
        self.springs.iter().flat_map(Spring::slots).for_each(|slot| slot.init(state));
    }
    fn nature(&self) -> Nature {
        Nature {
            linear: self.linear,
            symmetric: true,
            viscous: self.viscous,
            elapses: self.elapses,
            rayleigh: self.rayleigh,
        }
    }

    fn respond(
        &self,
        motion: &Motion<'_>,
        committed: &[f64],
        trial: &mut [f64],
        mut answer: Answer<'_>,
    ) -> Result<(), ElementError> {
        for s in &self.springs {
            let rate = dot(&s.row, motion.vel);
            let strain = Strain { value: self.deformation(s, motion.disp), rate, dt: motion.dt };
            let stress = s.slot.update(committed, strain, trial)?;
            let (mut force, mut damping) = (stress.value, stress.damping);
            if let Some(d) = &s.damper {
                // A damper's "strain" is the rate of deformation, so its tangent is the damping.
                let c = d.update(committed, Strain { value: rate, rate: 0.0, dt: motion.dt }, trial)?;
                force += c.value;
                damping += c.tangent;
            }
            for (f, r) in answer.force.iter_mut().zip(&s.row) {
                *f += force * r;
            }
            if let Some(k) = answer.tangent.as_deref_mut() {
                add_outer(k, &s.row, stress.tangent);
            }
            if let Some(c) = answer.damping.as_deref_mut() {
                add_outer(c, &s.row, damping);
            }
        }
        Ok(())
    }

    fn initial_tangent(&self, tangent: &mut [f64]) {
        for s in &self.springs {
            add_outer(tangent, &s.row, s.slot.material.initial_tangent());
        }
    }

    fn basic_rows(&self) -> Vec<BasicRow> {
        let per_node = self.initial.len();
        let mut rows: Vec<BasicRow> = vec![];
        for (column, s) in self.springs.iter().enumerate() {
            if rows.iter().all(|r| r.direction != s.direction) {
                let row = BasicRow::new(s.direction, column, &s.row, (self.ndm, per_node));
                rows.push(row.from_initial(dot(&s.row[per_node..], &self.initial)));
            }
        }
        rows
    }

    fn probe(&self, words: &[&str]) -> Option<Probe> {
        let n = self.springs.len();
        let numbered = |stem: &'static str| (1..=n).map(move |i| format!("{stem}{i}"));
        Some(match *words.first()? {
            "basicForce" | "basicForces" | "localForce" | "localForces" => Probe::new(BASIC_FORCE, numbered("P")),
            "defo" | "deformation" | "deformations" | "basicDeformation" => Probe::new(DEFORMATION, numbered("e")),
            "defoANDforce" | "deformationANDforces" | "deformationsANDforces" => {
                Probe::new(BOTH, numbered("e").chain(numbered("P")))
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

    fn probe_names(&self) -> &'static [&'static str] {
        &["basicForce", "localForce", "deformation", "basicDeformation", "defoANDforce", "basicStiffness", "material"]
    }

    fn read(&self, path: &[u32], s: &Snapshot<'_>, out: &mut [f64]) {
        let n = self.springs.len();
        for (i, spring) in self.springs.iter().enumerate() {
            match path[0] {
                BASIC_FORCE => out[i] = spring.slot.stress(s.state),
                DEFORMATION => out[i] = spring.slot.strain(s.state),
                BOTH => {
                    out[i] = spring.slot.strain(s.state);
                    out[n + i] = spring.slot.stress(s.state);
                }
                STIFFNESS => out[i * n + i] = spring.slot.tangent(s.state),
                MATERIALS => out[i] = f64::from(spring.slot.tag),
                DIRECTIONS => out[i] = spring.direction as f64,
                _ => {}
            }
        }
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
            _ => {}
        }
    }
}
