//! `HDR`, `ElastomericX`, `LeadRubberX`: a shear law with the axial law of layered rubber bearings.

use crate::element::bearing::elements::rubber_bearings::RubberBearings;
use crate::element::bearing::elements::shear_bearing::{
    BASIC_FORCE, BASIC_STIFFNESS, DEFORMATION, HYSTERETIC, LOCAL_DISP, LOCAL_FORCE, end_masses, probe,
};
use crate::element::bearing::elements::shear_bearings::Kept;
use crate::element::bearing::kinematics::link::Link;
use crate::element::bearing::laws::axial::{Axial, AxialLaw, AxialLockstep};
use crate::element::bearing::laws::rubber_shear::{RubberShear, ShearInput, shear_of_rubber};
use crate::element::bearing::laws::shear::Shear;
use crate::element::roles::{BasicDeformations, Bearing, CriticalLoad, ForceLabels, Inertia, LawSize, Roles};
use crate::element::{
    BasicRow, Class, Element, ElementInput, ElementOutput, ElementResult, ElementTraits, Histories, LockstepElement,
    Mass, Overload, Snapshot, Stretch, alike, one_by_one,
};
use crate::numeric::wide::{WIDTH, Wide};
use crate::probe::Probe;
use crate::state_struct::StateStruct;
use std::sync::Arc;

/// A layered rubber bearing in space: axial force, shear in two directions, linear torsion and rotations.
#[derive(Clone, Debug)]
pub struct RubberBearing<L> {
    axial: AxialLaw,
    shear: L,
    link: Link<12, 6>,
    mass: f64,
}

pub(super) const SHEAR_AT: usize = Axial::LEN;
pub(super) const MEMORY_AT: usize = SHEAR_AT + Shear::<2>::LEN;

impl<L: RubberShear> RubberBearing<L> {
    /// Index of the state variables after the memory of the shear law.
    const TAIL_AT: usize = MEMORY_AT + L::Memory::LEN;

    /// Makes the bearing of its laws, its kinematics and its mass.
    pub fn new(axial: AxialLaw, shear: L, link: Link<12, 6>, mass: f64) -> Self {
        Self { axial, shear, link, mass }
    }

    /// Stiffnesses of torsion, rotation about y and rotation about z.
    fn rotations(&self) -> [f64; 3] {
        [self.axial.rubber.torsion, self.axial.rubber.rotation, self.axial.rubber.rotation]
    }
}

crate::watches_columns!([L: std::fmt::Debug] RubberBearing<L> => nothing);

impl<L: RubberShear + 'static> Element for RubberBearing<L> {
    fn class(&self) -> Class {
        self.shear.class()
    }
    fn dofs(&self) -> usize {
        12
    }
    fn state_len(&self) -> usize {
        Self::TAIL_AT + self.shear.tail_len()
    }
    fn init(&self, state: &mut [f64]) {
        let (shear, memory) = self.shear.virgin();
        self.axial.virgin().write(state);
        shear.write(&mut state[SHEAR_AT..]);
        memory.write(&mut state[MEMORY_AT..]);
        state[Self::TAIL_AT..].fill(0.0);
    }
    fn traits(&self) -> ElementTraits {
        ElementTraits {
            linear: false,
            symmetric: false,
            viscous: self.shear.is_viscous(),
            elapses: self.shear.depends_on_time(),
            rayleigh: false,
        }
    }

    fn respond(&self, motion: &ElementInput<'_>, h: &mut Histories<'_>, output: ElementOutput<'_>) -> ElementResult {
        let local = self.link.local_motion(motion.disp);
        let u = self.link.deformation_of(&local);
        let lateral = [u[1], u[2]];
        let rate = if self.shear.is_viscous() {
            let rate = self.link.deformation(motion.vel);
            [rate[1], rate[2]]
        } else {
            [0.0; 2]
        };
        let size = (u[1] * u[1] + u[2] * u[2]).sqrt();
        let axial = self.axial.step(&Axial::read(h.committed), u[0], size);
        let tail = &h.committed[Self::TAIL_AT..];
        let at = ShearInput { u: lateral, size, rate, dt: motion.dt, time: motion.time, axial: &axial, tail };
        let (c, m) = (Shear::read(&h.committed[SHEAR_AT..]), L::Memory::read(&h.committed[MEMORY_AT..]));
        let s = self.shear.step(&c, &m, &L::Memory::read(&h.trial[MEMORY_AT..]), &at);
        axial.next.write(h.trial);
        s.shear.write(&mut h.trial[SHEAR_AT..]);
        s.memory.write(&mut h.trial[MEMORY_AT..]);
        h.trial[Self::TAIL_AT..].copy_from_slice(tail);
        self.shear.advance(&m, &s.memory, motion.dt, &mut h.trial[Self::TAIL_AT..]);

        let mut q = [axial.next.force, s.shear.q[0], s.shear.q[1], 0.0, 0.0, 0.0];
        let rotations = self.rotations();
        for i in 0..3 {
            q[3 + i] = rotations[i] * u[3 + i];
        }
        self.link.add_force(&q, &local, output.force);
        if let Some(tangent) = output.tangent {
            let mut k = [[0.0; 6]; 6];
            k[0][0] = axial.k;
            for i in 0..2 {
                if size > 0.0 {
                    k[0][1 + i] = axial.k_shear * lateral[i] / size;
                }
                k[1 + i][0] = s.k_axial[i];
                k[1 + i][1..3].copy_from_slice(&s.shear.k[i]);
            }
            for i in 0..3 {
                k[3 + i][3 + i] = rotations[i];
            }
            self.link.add_tangent(&k, &q, motion.disp, tangent, output.part);
        }
        if let Some(damping) = output.damping.filter(|_| s.damping != 0.0) {
            let mut c = [[0.0; 6]; 6];
            (c[1][1], c[2][2]) = (s.damping, s.damping);
            self.link.add_basic_part(&c, damping, output.part);
        }
        Ok(())
    }

    fn initial_tangent(&self, tangent: &mut [f64]) {
        let mut k = [[0.0; 6]; 6];
        k[0][0] = self.axial.rubber.axial;
        let shear = self.shear.virgin().0.k;
        let rotations = self.rotations();
        for i in 0..2 {
            k[1 + i][1..3].copy_from_slice(&shear[i]);
        }
        for i in 0..3 {
            k[3 + i][3 + i] = rotations[i];
        }
        self.link.add_basic(&k, tangent);
    }

    fn roles(&self) -> Roles<'_> {
        Roles {
            bearing: Some(Bearing::Rubber),
            mass: Some(self),
            basic_rows: Some(self),
            overload: Some(self),
            stretch: Some(self),
            lockstep: Some(lockstep::<L>),
            force_labels: ForceLabels::Frame,
            ..Roles::default()
        }
    }

    fn probe(&self, words: &[&str]) -> Option<Probe> {
        self.shear.probe(words).or_else(|| probe::<2>(words).filter(|p| p.path != [HYSTERETIC]))
    }

    fn probe_names(&self) -> Vec<&'static str> {
        self.shear.probe_names().to_vec()
    }

    fn read(&self, path: &[u32], s: &Snapshot<'_>, out: &mut [f64]) {
        let axial = Axial::read(s.state);
        let shear = Shear::<2>::read(&s.state[SHEAR_AT..]);
        match path[0] {
            LOCAL_FORCE => self.link.local_force(s.force, out),
            LOCAL_DISP => self.link.local_force(s.disp, out),
            DEFORMATION => out.copy_from_slice(&self.link.deformation(s.disp)),
            BASIC_FORCE => {
                let u = self.link.deformation(s.disp);
                out[..3].copy_from_slice(&[axial.force, shear.q[0], shear.q[1]]);
                for (i, k) in self.rotations().into_iter().enumerate() {
                    out[3 + i] = k * u[3 + i];
                }
            }
            BASIC_STIFFNESS => out.copy_from_slice(shear.k.as_flattened()),
            id => {
                let memory = L::Memory::read(&s.state[MEMORY_AT..]);
                self.shear.read(id, &shear, &memory, &s.state[Self::TAIL_AT..], &axial, out);
            }
        }
    }
}

impl<L: RubberShear + 'static> Inertia for RubberBearing<L> {
    fn mass(&self) -> Mass {
        end_masses(self.mass, 6, 3)
    }
}

impl<L: RubberShear + 'static> BasicDeformations for RubberBearing<L> {
    fn basic_rows(&self) -> Vec<BasicRow> {
        self.link.basic_rows()
    }
}

impl<L: RubberShear + 'static> CriticalLoad for RubberBearing<L> {
    fn overload(&self, history: &[f64]) -> Option<Overload> {
        let Axial { force, fcrn, .. } = Axial::read(history);
        (self.axial.buckles && force < fcrn).then_some(Overload { load: -force, critical: -fcrn })
    }
}

impl<L: RubberShear + 'static> LawSize for RubberBearing<L> {
    fn stretch(&self, disp: &[f64]) -> Stretch {
        let u = self.link.deformation(disp);
        shear_of_rubber(u[1].hypot(u[2]), self.axial.rubber.thickness)
    }
}

/// The bearings side by side, where their laws depend on deformations alone; else one after the other.
fn lockstep<L: RubberShear + 'static>(all: &[&Arc<dyn Element>; WIDTH]) -> Option<Box<dyn LockstepElement>> {
    let own = alike::<RubberBearing<L>>(all)?;
    let timeless = own.iter().all(|b| !b.shear.is_viscous() && !b.shear.depends_on_time() && b.shear.tail_len() == 0);
    let same = own.iter().all(|b| b.link == own[0].link) && timeless;
    let axial = AxialLockstep::new(own.map(|b| b.axial)).filter(|_| same);
    match (axial, L::lockstep(&own.map(|b| &b.shear))) {
        (Some(axial), Some(shear)) => {
            let rotations = own.map(|b| b.rotations());
            let rotations = std::array::from_fn(|i| Wide(rotations.map(|k| k[i])));
            let (link, stiffness) = (own[0].link.clone(), Kept::default());
            Some(Box::new(RubberBearings { axial, shear, link, rotations, stiffness }))
        }
        _ => one_by_one::<RubberBearing<L>>(all),
    }
}
