//! A bearing between two nodes: a shear law with uniaxial materials for the other directions.

use crate::element::bearing::elements::shear_bearings::{Kept, ShearBearings};
use crate::element::bearing::kinematics::link::Link;
use crate::element::bearing::laws::shear::{Shear, ShearLaw};
use crate::element::roles::{Backbone, BasicDeformations, Bearing, ForceLabels, Inertia, Roles};
use crate::element::{
    BasicRow, Class, Element, ElementInput, ElementOutput, ElementResult, ElementTraits, Histories, LockstepElement,
    Mass, OpenSeesTraits, RowMaterial, Snapshot, Softening, alike, one_by_one,
};
use crate::material::{Material, Slot, Strain};
use crate::numeric::wide::{WIDTH, Wide};
use crate::probe::Probe;
use crate::state_struct::StateStruct;
use std::sync::Arc;

/// A bearing with a law for its `S` shear directions and `M` uniaxial materials for the other basic directions. In the
/// plane (`N` = 6 degrees of freedom, `B` = 3 basic directions, `M` = 2, `S` = 1) these are axial force and moment. In
/// space (12, 6, 4, 2) they are axial force, torsion and the moments about y and z.
#[derive(Clone, Debug)]
pub struct ShearBearing<L, const N: usize, const B: usize, const M: usize, const S: usize> {
    law: L,
    link: Link<N, B>,
    materials: [Slot; M],
    mass: f64,
    rayleigh: bool,
    state_len: usize,
}

/// A bearing in the plane.
pub type PlaneBearing<L> = ShearBearing<L, 6, 3, 2, 1>;
/// A bearing in space.
pub type SpaceBearing<L> = ShearBearing<L, 12, 6, 4, 2>;

impl<L: ShearLaw<S>, const N: usize, const B: usize, const M: usize, const S: usize> ShearBearing<L, N, B, M, S> {
    /// Makes the bearing of its law, its kinematics, and its materials with tags in the order of the basic directions.
    pub fn new(law: L, link: Link<N, B>, materials: [(Material, i32); M], mass: f64, rayleigh: bool) -> Self {
        let mut state_len = Shear::<S>::LEN;
        let materials = materials.map(|(m, tag)| {
            let slot = Slot::new(m, tag, state_len);
            state_len += slot.len();
            slot
        });
        Self { law, link, materials, mass, rayleigh, state_len }
    }

    /// Materials with their basic directions.
    fn springs(&self) -> impl Iterator<Item = (usize, &Slot)> {
        self.materials.iter().enumerate().map(|(i, m)| (if i == 0 { 0 } else { i + S }, m))
    }

    /// Stiffnesses of the materials of several bearings, where all are linear.
    fn lockstep_springs(&self, all: &[&Self; WIDTH]) -> Option<[Wide; M]> {
        let mut springs = [Wide::all(0.0); M];
        for (i, spring) in springs.iter_mut().enumerate() {
            for (own, bearing) in spring.0.iter_mut().zip(all) {
                *own = bearing.materials[i].stiffness()?;
            }
        }
        Some(springs)
    }

    /// Basic stiffness from those of the materials and of the shear law.
    fn basic_stiffness(materials: [f64; B], shear: &Shear<S>) -> [[f64; B]; B] {
        let mut k = diagonal(materials);
        for (row, k) in k[1..=S].iter_mut().zip(&shear.k) {
            row[1..=S].copy_from_slice(k);
        }
        k
    }
}

crate::watches_columns!([L: std::fmt::Debug, const N: usize, const B: usize, const M: usize, const S: usize] ShearBearing<L, N, B, M, S> => |s| in &s.materials);

impl<L: ShearLaw<S> + 'static, const N: usize, const B: usize, const M: usize, const S: usize> Element
    for ShearBearing<L, N, B, M, S>
{
    fn class(&self) -> Class {
        L::CLASS[S - 1]
    }
    fn dofs(&self) -> usize {
        N
    }
    fn state_len(&self) -> usize {
        self.state_len
    }
    fn init(&self, state: &mut [f64]) {
        self.law.virgin().write(state);
        self.materials.iter().for_each(|m| m.init(state));
    }
    fn traits(&self) -> ElementTraits {
        let materials = ElementTraits::of(self.materials.iter());
        let viscous = materials.viscous || self.law.dashpot() != 0.0;
        ElementTraits { linear: false, symmetric: false, viscous, rayleigh: self.rayleigh, ..materials }
    }

    fn respond(&self, motion: &ElementInput<'_>, h: &mut Histories<'_>, output: ElementOutput<'_>) -> ElementResult {
        let local = self.link.local_motion(motion.disp);
        let u = self.link.deformation_of(&local);
        let rate = if motion.still { [0.0; B] } else { self.link.deformation(motion.vel) };
        // Axial and rotational entries from the materials, shear entries between them.
        let (mut q, mut stiffness, mut viscosity) = ([0.0; B], [0.0; B], [0.0; B]);
        for (i, slot) in self.springs() {
            let s = slot.update(h.committed, Strain { value: u[i], rate: rate[i], dt: motion.dt }, h.trial)?;
            (q[i], stiffness[i], viscosity[i]) = (s.value, s.tangent, s.damping);
        }
        let old = Shear::read(h.committed);
        let mut shear = self.law.step(&old, std::array::from_fn(|i| u[1 + i]))?;
        self.law.leave_trace(&old, &Shear::read(h.trial), &mut shear);
        let dashpot = self.law.dashpot();
        for i in 0..S {
            shear.q[i] += dashpot * rate[1 + i];
            viscosity[1 + i] = dashpot;
        }
        shear.write(h.trial);
        q[1..=S].copy_from_slice(&shear.q);
        self.link.add_force(&q, &local, output.force);
        if let Some(tangent) = output.tangent {
            let k = Self::basic_stiffness(stiffness, &shear);
            self.link.add_tangent(&k, &q, motion.disp, tangent, output.part);
        }
        if let Some(damping) = output.damping {
            let c = diagonal(viscosity);
            self.link.add_basic_part(&c, damping, output.part);
        }
        Ok(())
    }

    fn initial_tangent(&self, tangent: &mut [f64]) {
        let mut stiffness = [0.0; B];
        for (i, slot) in self.springs() {
            stiffness[i] = slot.material.initial_tangent();
        }
        self.link.add_basic(&Self::basic_stiffness(stiffness, &self.law.virgin()), tangent);
    }

    fn roles(&self) -> Roles<'_> {
        Roles {
            bearing: Some(Bearing::Rubber),
            mass: Some(self),
            basic_rows: Some(self),
            softening: Some(self),
            lockstep: Some(lockstep::<L, N, B, M, S>),
            opensees: {
                let ground_inertia = (L::REPORTS_INERTIA && self.mass != 0.0).then_some(1.0);
                OpenSeesTraits { keeps_first_damping: !L::RENEWS_DAMPING, ground_inertia, ..OpenSeesTraits::default() }
            },
            force_labels: ForceLabels::Frame,
            ..Roles::default()
        }
    }

    fn probe(&self, words: &[&str]) -> Option<Probe> {
        if let ["material", n, rest @ ..] = words {
            let i = n.parse::<usize>().ok().filter(|i| (1..=M).contains(i))? - 1;
            return Some(self.materials[i].probe(rest)?.inside(&[MATERIAL, i as u32]));
        }
        probe::<S>(words).filter(|p| L::HYSTERETIC || p.path != [HYSTERETIC])
    }

    fn probe_names(&self) -> Vec<&'static str> {
        PROBES[usize::from(!L::HYSTERETIC)..].to_vec()
    }

    fn read(&self, path: &[u32], s: &Snapshot<'_>, out: &mut [f64]) {
        let shear = Shear::<S>::read(s.state);
        match path[0] {
            LOCAL_FORCE => self.link.local_force(s.force, out),
            LOCAL_DISP => self.link.local_force(s.disp, out),
            DEFORMATION => out.copy_from_slice(&self.link.deformation(s.disp)),
            BASIC_FORCE => {
                self.springs().for_each(|(i, slot)| out[i] = slot.stress(s.state));
                out[1..=S].copy_from_slice(&shear.q);
            }
            HYSTERETIC => out.copy_from_slice(&shear.internal),
            BASIC_STIFFNESS => out.copy_from_slice(shear.k.as_flattened()),
            _ => self.materials[path[1] as usize].read(&path[2..], s.state, out),
        }
    }
}

impl<L: ShearLaw<S> + 'static, const N: usize, const B: usize, const M: usize, const S: usize> Inertia
    for ShearBearing<L, N, B, M, S>
{
    fn mass(&self) -> Mass {
        self.law.masses(self.mass)
    }
}

impl<L: ShearLaw<S> + 'static, const N: usize, const B: usize, const M: usize, const S: usize> BasicDeformations
    for ShearBearing<L, N, B, M, S>
{
    fn basic_rows(&self) -> Vec<BasicRow> {
        with_materials(self.link.basic_rows(), self.springs().map(|(column, _)| column))
    }
}

impl<L: ShearLaw<S> + 'static, const N: usize, const B: usize, const M: usize, const S: usize> Backbone
    for ShearBearing<L, N, B, M, S>
{
    fn softening(&self, history: &[f64]) -> Option<Softening> {
        let (stiffness_end, force_end) = self.law.backbone_ends()?;
        let deformation = Shear::<S>::read(history).u.iter().fold(0.0f64, |m, u| m.max(u.abs()));
        Some(Softening { deformation, stiffness_end, force_end })
    }
}

/// Basic rows with the materials that alone carry a force; `columns` has one for each material.
pub(in crate::element::bearing) fn with_materials(
    rows: Vec<BasicRow>,
    columns: impl Iterator<Item = usize>,
) -> Vec<BasicRow> {
    let mut rows = rows;
    for (i, column) in columns.enumerate() {
        rows[column].material = Some(RowMaterial { number: i + 1, area: 1.0, length: 1.0 });
    }
    rows
}

fn diagonal<const B: usize>(values: [f64; B]) -> [[f64; B]; B] {
    let mut matrix = [[0.0; B]; B];
    (0..B).for_each(|i| matrix[i][i] = values[i]);
    matrix
}

/// Lumped mass: half at each end, translations only.
pub(in crate::element::bearing) fn end_masses(mass: f64, per_node: usize, translations: usize) -> Mass {
    if mass == 0.0 {
        return Mass::None;
    }
    let mut m = vec![0.0; 2 * per_node];
    for node in 0..2 {
        m[node * per_node..node * per_node + translations].fill(0.5 * mass);
    }
    Mass::Lumped(m)
}

pub(in crate::element::bearing) const LOCAL_FORCE: u32 = 2;
pub(in crate::element::bearing) const BASIC_FORCE: u32 = 3;
pub(in crate::element::bearing) const LOCAL_DISP: u32 = 4;
pub(in crate::element::bearing) const DEFORMATION: u32 = 5;
pub(in crate::element::bearing) const HYSTERETIC: u32 = 6;
pub(in crate::element::bearing) const BASIC_STIFFNESS: u32 = 8;
pub(in crate::element::bearing) const MATERIAL: u32 = 9;
/// First response of the friction model, in sliding bearings.
pub(in crate::element::bearing) const FRICTION: u32 = 10;

/// Names of the responses; the first exists only for laws with a hysteretic parameter.
const PROBES: &[&str] = &[
    "hystereticParameter",
    "localForce",
    "basicForce",
    "localDisplacement",
    "deformation",
    "basicDeformation",
    "basicStiffness",
    "material",
];

/// The response for the arguments of a recorder.
pub(in crate::element::bearing) fn probe<const S: usize>(words: &[&str]) -> Option<Probe> {
    let plane = S == 1;
    let basic = if plane { 3 } else { 6 };
    let numbered = |stem: &str, n: usize| (1..=n).map(|i| format!("{stem}{i}")).collect::<Vec<_>>();
    let ends = |names: &[&str]| (1..=2).flat_map(|e| names.iter().map(move |n| format!("{n}_{e}"))).collect::<Vec<_>>();
    Some(match *words.first()? {
        "localForce" | "localForces" => {
            Probe::new(LOCAL_FORCE, ends(if plane { &["N", "V", "M"] } else { &["N", "Vy", "Vz", "T", "My", "Mz"] }))
        }
        "basicForce" | "basicForces" => Probe::new(BASIC_FORCE, numbered("qb", basic)),
        "localDisplacement" | "localDisplacements" => Probe::new(
            LOCAL_DISP,
            ends(if plane { &["ux", "uy", "rz"] } else { &["ux", "uy", "uz", "rx", "ry", "rz"] }),
        ),
        "deformation" | "deformations" | "basicDeformation" | "basicDeformations" | "basicDisplacement"
        | "basicDisplacements" => Probe::new(DEFORMATION, numbered("ub", basic)),
        "hystereticParameter" | "hystParameter" | "hystereticParam" | "hystParam" | "z" => {
            Probe::new(HYSTERETIC, if plane { vec!["z".to_owned()] } else { numbered("z", 2) })
        }
        "kb" | "basicStiff" | "basicStiffness" => {
            Probe::new(BASIC_STIFFNESS, if plane { vec!["kb22"] } else { vec!["kb22", "kb23", "kb32", "kb33"] })
        }
        _ => return None,
    })
}

/// The bearings side by side, where their springs are linear and their laws of one kind; else one after the other.
fn lockstep<L, const N: usize, const B: usize, const M: usize, const S: usize>(
    all: &[&Arc<dyn Element>; WIDTH],
) -> Option<Box<dyn LockstepElement>>
where
    L: ShearLaw<S> + 'static,
{
    let own = alike::<ShearBearing<L, N, B, M, S>>(all)?;
    let same = own.iter().all(|b| b.link == own[0].link) && own[0].law.dashpot() == 0.0;
    let springs = own[0].lockstep_springs(&own).filter(|_| same);
    match (springs, L::lockstep(&own.map(|b| &b.law))) {
        (Some(springs), Some(law)) => {
            let (link, stiffness) = (own[0].link.clone(), Kept::default());
            Some(Box::new(ShearBearings { law, link, springs, stiffness }))
        }
        _ => one_by_one::<ShearBearing<L, N, B, M, S>>(all),
    }
}
