//! A bearing between two nodes: a sliding surface with uniaxial materials for the other directions.

use super::heat::{self, Heat};
use super::rules::Rules;
use super::surface::{Pose, Surface};
use crate::element::bearing::Link;
use crate::element::bearing::elements::shear_bearing::{
    BASIC_FORCE, DEFORMATION, FRICTION, LOCAL_DISP, LOCAL_FORCE, MATERIAL, end_masses, probe, with_materials,
};
use crate::element::friction::Contact;
use crate::element::roles::{BasicDeformations, Bearing, ForceLabels, Inertia, Roles};
use crate::element::{
    BasicRow, Class, Element, ElementInput, ElementOutput, ElementResult, ElementTraits, Histories, Mass, Snapshot,
};
use crate::material::{Material, Slot, Strain};
use crate::numeric::{axpy, dot};
use crate::probe::Probe;
use crate::rules::Consistent;
use crate::state_struct::StateStruct;

/// Kind of a sliding bearing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// `flatSliderBearing`: a flat surface at node i.
    Flat,
    /// `singleFPBearing`: a spherical surface at node i.
    Pendulum,
    /// `FPBearingPTV`: a spherical surface at node i with frictional heating.
    Heated,
    /// `RJWatsonEqsBearing`: a flat surface at node j with shear springs in parallel.
    Springs,
}

impl Kind {
    /// OpenSees' class names in the plane and in space.
    fn class(self) -> [Class; 2] {
        match self {
            Self::Flat => [Class::new("FlatSliderSimple2d", 92), Class::new("FlatSliderSimple3d", 93)],
            Self::Pendulum => [Class::new("SingleFPSimple2d", 96), Class::new("SingleFPSimple3d", 97)],
            Self::Heated => [Class::new("FPBearingPTV", 166); 2],
            Self::Springs => [Class::new("RJWatsonEQS2d", 149), Class::new("RJWatsonEQS3d", 150)],
        }
    }
}

/// First response of a surface with frictional heating.
const HEAT: u32 = 20;

/// Properties of a sliding bearing besides its surface and materials.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Setting<R = Consistent> {
    /// Kind.
    pub kind: Kind,
    /// Mass, half at each end.
    pub mass: f64,
    /// Rayleigh damping applies to it.
    pub rayleigh: bool,
    /// Share of the initial stiffness that remains in uplift, so that the tangent is regular.
    pub uplift: f64,
    /// Rules of the iterations, of the tangent and of trial states.
    pub rules: R,
}

impl<R> Setting<R> {
    /// The same properties with other rules.
    pub fn with<T>(self, rules: T) -> Setting<T> {
        Setting { kind: self.kind, mass: self.mass, rayleigh: self.rayleigh, uplift: self.uplift, rules }
    }
}

/// A bearing with a sliding surface in `S` directions and uniaxial materials. It has `N` degrees of freedom and `B`
/// basic directions (axial, shear, torsion, rotations). In tension the surface carries no force. P-Delta moments of the
/// axial force and the torsion of the shear force act at the node of the surface.
#[derive(Clone, Debug)]
pub struct SlidingBearing<const N: usize, const B: usize, const S: usize, R = Consistent> {
    pub(super) surface: Surface,
    pub(super) link: Link<N, B>,
    /// Basic directions with their materials.
    pub(super) springs: Vec<(usize, Slot)>,
    pub(super) setting: Setting<R>,
    /// Rows of the rotation of the surface about its two axes, by the displacements.
    pub(super) tilt: [[f64; N]; S],
    levers: Vec<Lever<N>>,
    /// Frictional heating, and the index of its state variables.
    heat: Option<Heat>,
    pub(super) own: usize,
    state_len: usize,
}

/// A sliding bearing in the plane.
pub type PlaneSlider<R = Consistent> = SlidingBearing<6, 3, 1, R>;
/// A sliding bearing in space.
pub type SpaceSlider<R = Consistent> = SlidingBearing<12, 6, 2, R>;

/// A moment on a node: the sum of basic forces times displacements.
#[derive(Clone, Debug)]
struct Lever<const N: usize> {
    /// Row of the conjugate local rotation.
    row: [f64; N],
    /// Basic force, and derivatives of its lever arm by the displacements.
    arms: Vec<(usize, [f64; N])>,
}

/// State variables of a sliding bearing.
#[derive(Clone, Copy, Debug)]
pub struct History<const B: usize, const S: usize> {
    /// Plastic displacement of the surface.
    pub(super) plastic: [f64; S],
    /// Force of the surface.
    pub(super) shear: [f64; S],
    pub(super) contact: Contact,
    /// Basic forces.
    pub(super) q: [f64; B],
}

impl<const B: usize, const S: usize> Default for History<B, S> {
    fn default() -> Self {
        Self { plastic: [0.0; S], shear: [0.0; S], contact: Contact::default(), q: [0.0; B] }
    }
}

impl<const B: usize, const S: usize> StateStruct for History<B, S> {
    const LEN: usize = 2 * S + Contact::LEN + B;

    fn read(words: &[f64]) -> Self {
        let (shears, rest) = words.split_at(2 * S);
        let (contact, q) = rest.split_at(Contact::LEN);
        Self {
            plastic: std::array::from_fn(|i| shears[i]),
            shear: std::array::from_fn(|i| shears[S + i]),
            contact: Contact::read(contact),
            q: std::array::from_fn(|i| q[i]),
        }
    }

    fn write(&self, words: &mut [f64]) {
        let (shears, rest) = words.split_at_mut(2 * S);
        let (contact, q) = rest.split_at_mut(Contact::LEN);
        shears[..S].copy_from_slice(&self.plastic);
        shears[S..].copy_from_slice(&self.shear);
        self.contact.write(contact);
        q[..B].copy_from_slice(&self.q);
    }
}

/// Basic forces with their derivatives by displacements and velocities of all degrees of freedom.
pub struct Basic<const N: usize, const B: usize> {
    pub(super) q: [f64; B],
    pub(super) by_disp: [[f64; N]; B],
    pub(super) by_vel: [[f64; N]; B],
}

impl<const N: usize, const B: usize, const S: usize, R: Rules> SlidingBearing<N, B, S, R> {
    /// Makes the bearing of its surface, its kinematics and its materials with tags. The kinematics have the length and
    /// the position of the shear force (0 for node i, 1 for node j). Materials are in the order of the basic
    /// directions: axial, shear (for [`Kind::Springs`]), torsion in space, rotations.
    pub fn new(
        surface: Surface,
        (link, length, shear_dist): (Link<N, B>, f64, f64),
        materials: Vec<(Material, i32)>,
        setting: Setting<R>,
    ) -> Self {
        let springs = setting.kind == Kind::Springs;
        let directions = (0..B).filter(|d| springs || !(1..=S).contains(d));
        let (slots, own) = Slot::pack(materials, History::<B, S>::LEN);
        let (foot, head) = if springs { (N / 2, 0) } else { (0, N / 2) };
        let arm = if springs { shear_dist * length } else { (1.0 - shear_dist) * length };
        let tilt = std::array::from_fn(|i| match (S, i) {
            (1, _) => link.local[foot + 2],
            (_, 0) => link.local[foot + 5],
            _ => link.local[foot + 4].map(|r| -r),
        });
        let levers = levers::<N, S>(&link.local, foot, head, arm);
        let springs = directions.zip(slots).collect();
        Self { surface, springs, setting, tilt, levers, heat: None, own, state_len: own, link }
    }

    /// Adds frictional heating of the surface.
    pub fn warming(mut self, heat: Heat) -> Self {
        self.heat = Some(heat);
        self.state_len = self.own + Heat::LEN;
        self
    }

    /// Rise of the slider in a dish: rise, its rate, its derivatives by the shear displacement.
    fn rise(&self, u: &[f64; B], rate: &[f64; B]) -> ElementResult<(f64, f64, [f64; S])> {
        let Some(dish) = self.surface.dish.filter(|d| d.rises) else { return Ok((0.0, 0.0, [0.0; S])) };
        let (rise, slope) = dish.rise::<S>(std::array::from_fn(|i| u[1 + i]))?;
        Ok(R::rise(rise, slope, &rate[1..=S]))
    }

    /// Basic forces at a trial state. Materials are evaluated in uplift too, except by OpenSees.
    fn basic(&self, motion: &ElementInput<'_>, h: &mut Histories<'_>) -> ElementResult<Basic<N, B>> {
        let (u, rate) = (self.link.deformation(motion.disp), self.link.deformation(motion.vel));
        if let Some(heat) = R::heat_first(self.heat.as_ref()) {
            return self.with_early_friction(heat, motion, h);
        }
        let (rise, rise_rate, slope) = self.rise(&u, &rate)?;
        let mut out = Basic { q: [0.0; B], by_disp: [[0.0; N]; B], by_vel: [[0.0; N]; B] };
        for (d, slot) in &self.springs {
            if R::leaves_out::<S>(*d, out.q[0]) {
                continue;
            }
            let last = slot.strain(h.trial);
            let (less, less_rate) = if *d == 0 { (rise, rise_rate) } else { (0.0, 0.0) };
            let strain = Strain { value: u[*d] - less, rate: rate[*d] - less_rate, dt: motion.dt };
            let s = slot.update(h.committed, strain, h.trial)?;
            if R::puts_back::<S>(self.setting.kind, *d, s.value) {
                slot.update(h.committed, Strain { value: last, rate: 0.0, dt: motion.dt }, h.trial)?;
            }
            out.q[*d] = s.value;
            axpy(s.tangent, &self.link.basic[*d], &mut out.by_disp[*d]);
            axpy(s.damping, &self.link.basic[*d], &mut out.by_vel[*d]);
            if *d == 0 {
                for (slope, basic) in slope.iter().zip(&self.link.basic[1..=S]) {
                    axpy(-s.tangent * slope, basic, &mut out.by_disp[0]);
                    axpy(-s.damping * slope, basic, &mut out.by_vel[0]);
                }
            }
        }
        let (old, last) = (History::<B, S>::read(h.committed), History::<B, S>::read(h.trial));
        let mut next = if out.q[0] < 0.0 {
            let pose = Pose {
                u: std::array::from_fn(|i| u[1 + i]),
                rate: std::array::from_fn(|i| rate[1 + i]),
                tilt: self.tilt.each_ref().map(|row| dot(row, motion.disp)),
                pressure: -out.q[0],
                plastic: old.plastic,
                warmth: self.heat.as_ref().map_or(1.0, |heat| heat.share(&h.committed[self.own..])),
            };
            self.press(&pose, &last, &mut out)?
        } else {
            let left = self.left(u[0] - rise, h.committed);
            R::lift(self, (&u, &rate, left), &last, &mut out)
        };
        next.q = out.q;
        next.write(h.trial);
        if let Some(heat) = &self.heat {
            heat.warm(&next.contact, &u[1..=S], motion.dt, &mut h.part(self.own..self.state_len));
        }
        Ok(out)
    }

    /// Adds the forces of the surface in contact.
    fn press(&self, pose: &Pose<S>, last: &History<B, S>, out: &mut Basic<N, B>) -> ElementResult<History<B, S>> {
        let slide = self.setting.rules.slide(&self.surface, pose, last.shear)?;
        let kept = R::stuck(pose.plastic, last.plastic);
        for i in 0..S {
            out.q[1 + i] += slide.q[i];
            R::add_derivatives(self, &slide, i, out);
        }
        let plastic = slide.plastic.unwrap_or(kept);
        Ok(History { plastic, shear: slide.q, contact: slide.contact, q: [0.0; B] })
    }

    /// Share of the initial stiffness that remains without compression, so that the tangent is regular. It is 1 at zero
    /// gap. Beyond, it leads back to the compression of the committed state.
    fn left(&self, gap: f64, committed: &[f64]) -> f64 {
        let Some((_, axial)) = self.springs.first() else { unreachable!("there is an axial material") };
        let closing = axial.material.initial_tangent() * (gap - axial.strain(committed));
        if gap <= 0.0 { 1.0 } else { (-axial.stress(committed) / closing.abs()).max(self.setting.uplift).min(1.0) }
    }

    /// Adds a share of the initial stiffness of the surface.
    pub(super) fn add_initial_shear(&self, left: f64, out: &mut Basic<N, B>) {
        for (row, basic) in out.by_disp[1..=S].iter_mut().zip(&self.link.basic[1..=S]) {
            axpy(left * self.surface.k_init, basic, row);
        }
    }
}

/// Moments at the node offsets `foot`, which has the surface, and `head`, at a distance `arm` from the shear force.
/// They are the axial force times the displacement of the slider, and the torsion of the shear force. The surface moves
/// with its node, so all of them act there.
fn levers<const N: usize, const S: usize>(local: &[[f64; N]; N], foot: usize, head: usize, arm: f64) -> Vec<Lever<N>> {
    let apart = |i: usize| -> [f64; N] { std::array::from_fn(|k| local[N / 2 + i][k] - local[i][k]) };
    let turned = |i: usize, factor: f64| local[head + i].map(|r| factor * r);
    let sum = |a: [f64; N], b: [f64; N]| -> [f64; N] { std::array::from_fn(|k| a[k] + b[k]) };
    // Planes of bending: shear direction, rotation, and the sign of the displacement in the moment.
    let planes: &[(usize, usize, f64)] = if S == 1 { &[(1, 2, 1.0)] } else { &[(1, 5, 1.0), (2, 4, -1.0)] };
    let mut all = vec![];
    for &(v, r, sign) in planes {
        let at_foot = sum(apart(v).map(|x| sign * x), turned(r, -arm));
        all.push(Lever { row: local[foot + r], arms: vec![(0, at_foot)] });
        all.push(Lever { row: local[head + r], arms: vec![(0, turned(r, arm))] });
    }
    if S == 2 {
        let y = sum(apart(2), turned(4, arm));
        let z = sum(apart(1).map(|x| -x), turned(5, arm));
        all.push(Lever { row: local[foot + 3], arms: vec![(1, y), (2, z)] });
        all.push(Lever { row: local[head + 3], arms: vec![(1, turned(4, -arm)), (2, turned(5, -arm))] });
    }
    all
}

crate::watches_columns!([const N: usize, const B: usize, const S: usize, R: Rules] SlidingBearing<N, B, S, R> => |s| in s.springs.iter().map(|(_, slot)| slot));

impl<const N: usize, const B: usize, const S: usize, R: Rules> Element for SlidingBearing<N, B, S, R> {
    fn class(&self) -> Class {
        self.setting.kind.class()[S - 1]
    }
    fn dofs(&self) -> usize {
        N
    }
    fn state_len(&self) -> usize {
        self.state_len
    }
    fn init(&self, state: &mut [f64]) {
        let contact = Contact { mu: self.surface.coefficient(0.0, 0.0).mu, ..Contact::default() };
        History::<B, S> { contact, ..History::default() }.write(state);
        self.springs.iter().for_each(|(_, m)| m.init(state));
        if let Some(heat) = &self.heat {
            heat.init(&mut state[self.own..self.state_len]);
        }
    }
    fn traits(&self) -> ElementTraits {
        let any = |is: fn(&Slot) -> bool| self.springs.iter().any(|(_, slot)| is(slot));
        ElementTraits {
            linear: false,
            symmetric: false,
            viscous: self.surface.friction.depends_on_speed() || any(|s| s.material.is_viscous()),
            elapses: self.heat.is_some() || any(|s| s.material.depends_on_time()),
            rayleigh: self.setting.rayleigh,
        }
    }

    fn respond(&self, motion: &ElementInput<'_>, h: &mut Histories<'_>, output: ElementOutput<'_>) -> ElementResult {
        let Basic { q, by_disp, by_vel } = self.basic(motion, h)?;
        for (row, &q) in self.link.basic.iter().zip(&q) {
            axpy(q, row, output.force);
        }
        let (mut tangent, mut damping) = (output.tangent, output.damping);
        for (row, (by_disp, by_vel)) in self.link.basic.iter().zip(by_disp.iter().zip(&by_vel)) {
            add_product(&mut tangent, row, by_disp);
            add_product(&mut damping, row, by_vel);
        }
        for lever in &self.levers {
            let (mut moment, mut by_u, mut by_v) = (0.0, [0.0; N], [0.0; N]);
            for (basic, arm) in &lever.arms {
                let length = dot(arm, motion.disp);
                moment += q[*basic] * length;
                axpy(q[*basic], arm, &mut by_u);
                if R::MOMENTS_FOLLOW_FORCES {
                    axpy(length, &by_disp[*basic], &mut by_u);
                    axpy(length, &by_vel[*basic], &mut by_v);
                }
            }
            axpy(moment, &lever.row, output.force);
            add_product(&mut tangent, &lever.row, &by_u);
            add_product(&mut damping, &lever.row, &by_v);
        }
        Ok(())
    }

    fn initial_tangent(&self, tangent: &mut [f64]) {
        let mut k = [[0.0; B]; B];
        self.springs.iter().for_each(|(d, slot)| k[*d][*d] = slot.material.initial_tangent());
        (1..=S).for_each(|d| k[d][d] += self.surface.k_init);
        self.link.add_basic(&k, tangent);
    }

    fn roles(&self) -> Roles<'_> {
        Roles {
            bearing: Some(Bearing::Sliding),
            mass: Some(self),
            basic_rows: Some(self),
            force_labels: ForceLabels::Frame,
            ..Roles::default()
        }
    }

    fn probe(&self, words: &[&str]) -> Option<Probe> {
        match words {
            ["material", n, rest @ ..] => {
                let i = n.parse::<usize>().ok().filter(|i| (1..=self.springs.len()).contains(i))? - 1;
                Some(self.springs[i].1.probe(rest)?.inside(&[MATERIAL, i as u32]))
            }
            ["frictionModel" | "frnMdl" | "frictionMdl" | "frnModel", rest @ ..] => {
                Some(Contact::probe(rest)?.inside(&[FRICTION]))
            }
            _ => {
                let known = [LOCAL_FORCE, BASIC_FORCE, LOCAL_DISP, DEFORMATION];
                let own = probe::<S>(words).filter(|p| known.contains(&p.path[0]));
                let warmth = || self.heat.and(heat::probe(words.first().filter(|_| words.len() == 1)?));
                own.or_else(|| warmth().map(|(id, names)| Probe::new(id, names.iter().copied()).inside(&[HEAT])))
            }
        }
    }

    fn probe_names(&self) -> Vec<&'static str> {
        [
            "localForce",
            "basicForce",
            "localDisplacement",
            "deformation",
            "basicDeformation",
            "material",
            "frictionModel",
            "temperature",
            "MuFactors",
            "MuAdjusted",
            "HeatFlux",
        ][..if self.heat.is_some() { 11 } else { 7 }]
            .to_vec()
    }

    fn read(&self, path: &[u32], s: &Snapshot<'_>, out: &mut [f64]) {
        let history = History::<B, S>::read(s.state);
        match path[0] {
            LOCAL_FORCE => self.link.local_force(s.force, out),
            LOCAL_DISP => self.link.local_force(s.disp, out),
            DEFORMATION => out.copy_from_slice(&self.link.deformation(s.disp)),
            BASIC_FORCE => out.copy_from_slice(&history.q),
            HEAT => heat::read(path[1], &s.state[self.own..], out),
            FRICTION => out[0] = history.contact.value(path[1]),
            _ => self.springs[path[1] as usize].1.read(&path[2..], s.state, out),
        }
    }
}

impl<const N: usize, const B: usize, const S: usize, R: Rules> Inertia for SlidingBearing<N, B, S, R> {
    fn mass(&self) -> Mass {
        end_masses(self.setting.mass, N / 2, S + 1)
    }
}

impl<const N: usize, const B: usize, const S: usize, R: Rules> BasicDeformations for SlidingBearing<N, B, S, R> {
    fn basic_rows(&self) -> Vec<BasicRow> {
        let mut rows = with_materials(self.link.basic_rows(), self.springs.iter().map(|(column, _)| *column));
        // The surface carries a part of the shear forces.
        rows[1..=S].iter_mut().for_each(|row| row.material = None);
        rows
    }
}

/// `matrix += a bᵀ`, if there is a matrix.
fn add_product<const N: usize>(matrix: &mut Option<&mut [f64]>, a: &[f64; N], b: &[f64; N]) {
    if let Some(m) = matrix {
        for (row, a) in m.chunks_exact_mut(N).zip(a).filter(|(_, a)| **a != 0.0) {
            axpy(*a, b, row);
        }
    }
}
