//! Beams with sections along their length: common part of the formulations.

use crate::element::damping::BasicForces;
use crate::element::load::ElementLoad;
use crate::element::roles::{ElementLoads, ElementParameters, EulerLoad, ForceLabels, Inertia, Roles, SectionCapacity};
use crate::element::transform::{Reactions, Transform, axis_probe};
use crate::element::{
    CallDependent, Class, Element, ElementInput, ElementOutput, ElementResult, ElementTraits, Histories, Mass,
    MatrixMask, OpenSeesTraits, SharedState, Snapshot,
};
use crate::numeric::norm;
use crate::parameter::{Changed, NewValue, exchange, existing, index, last_of};
use crate::probe::Probe;
use crate::section::{MAX_ORDER, Resultant, SectionSlot, SharedSection, of_length};
use std::fmt;
use std::sync::Arc;

use super::basic::{BASIC_DEFORMATIONS, Basic, basic_force_names};
use super::deflection;
use super::elastic::{consistent_mass, euler_load, lumped_mass, rigidities};
use super::per_section::PerSection;
use super::shortfall::exhausted;

/// Effect of an axial force, a moment or a torque that a section of a beam does not have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lacking {
    /// Each section needs it.
    Refused,
    /// The section adds no flexibility: it is rigid.
    Rigid,
    /// The section adds no stiffness.
    Free,
}

/// Loads along a beam, as sums that its elements keep.
pub trait LoadSums<const N: usize, const B: usize> {
    /// Number of load sums for `points` sections.
    fn load_len(points: usize) -> usize;
    /// Adds a load times a factor to the load sums.
    fn add_load(member: &Member<N, B>, load: &ElementLoad, factor: f64, sums: &mut [f64]);
    /// End reactions of the simple beam under the loads.
    fn reactions(load: &[f64]) -> Reactions;
}

/// Relation between the sections of a beam and its basic system of `B` deformations.
pub trait Formulation<const N: usize, const B: usize>: Clone + fmt::Debug + Send + Sync + 'static {
    /// Sums of its loads.
    type Loads: LoadSums<N, B>;
    /// OpenSees' class names in the plane and in space.
    const CLASS: [Class; 2];
    /// The stiffness of the basic system is symmetric.
    const SYMMETRIC: bool = true;
    /// Sections depend on the deflection of the beam between its ends: forces are not proportional to deformations.
    const DEFLECTS: bool = false;
    /// Softening localises in one section.
    const LOCALISES: bool = false;
    /// Effect of a resultant that a section lacks.
    const LACKING: Lacking;
    /// Responses are displacements between the ends, from the section curvatures.
    const SHOWS_DEFLECTION: bool = false;
    /// OpenSees' element takes a damping of its own.
    const DAMPABLE: bool = false;
    /// Number of state variables of the formulation, after those of the sections.
    const STATE_LEN: usize = 0;

    /// Returns true if the tangent is the complete derivative of the forces, symmetric or not.
    fn whole_tangent(&self) -> bool {
        false
    }

    /// Returns true for OpenSees' scheme, which continues from the last trial state. The state variables of the
    /// formulation are then `Trace`, and the element counts its calls.
    fn continues_from_last_trial(&self) -> bool {
        false
    }

    /// Forces and stiffness of the basic system for its deformations `v`; writes the state variables of the sections.
    ///
    /// # Errors
    /// Errors of the sections; no convergence.
    fn respond(
        &self,
        member: &Member<N, B>,
        v: &[f64; B],
        motion: &ElementInput<'_>,
        h: &mut Histories<'_>,
    ) -> ElementResult<Basic<B>>;

    /// Evaluates the virgin beam once, as OpenSees does when it is made.
    fn settle(&self, _member: &Member<N, B>, _state: &mut [f64]) {}

    /// Stiffness of the basic system of the virgin beam.
    fn initial_stiffness(member: &Member<N, B>) -> [[f64; B]; B];
    /// Basic deformations of the virgin beam for basic forces and loads.
    fn elastic_deformation(member: &Member<N, B>, q: &[f64; B], load: &[f64]) -> [f64; B];
}

/// State variables of a beam that continues from its last trial state.
#[derive(Clone, Copy, Debug)]
pub struct Trace<const N: usize, const B: usize> {
    /// Basic deformations of that state.
    pub v: [f64; B],
    /// Increment of the basic deformations that led to it.
    pub dv: [f64; B],
    /// Displacements of that state.
    pub disp: [f64; N],
}

impl<const N: usize, const B: usize> Trace<N, B> {
    pub(super) const LEN: usize = 2 * B + N;

    pub(super) fn read(state: &[f64]) -> Self {
        let mut trace = Self { v: [0.0; B], dv: [0.0; B], disp: [0.0; N] };
        trace.v.copy_from_slice(&state[..B]);
        trace.dv.copy_from_slice(&state[B..2 * B]);
        trace.disp.copy_from_slice(&state[2 * B..Self::LEN]);
        trace
    }

    /// The trace of a trial state with the basic deformations `v`, from the last trial state in `trial`.
    pub(super) fn next(member: &Member<N, B>, v: &[f64; B], motion: &ElementInput<'_>, trial: &[f64]) -> Self {
        let last = Self::read(&trial[member.own_words()..]);
        let mut next = Self { v: *v, dv: std::array::from_fn(|i| v[i] - last.v[i]), disp: [0.0; N] };
        // In a repeated call the nodes still have the increment of the call before.
        if motion.opensees.is_some_and(|c| c.repeated) && member.is_small() {
            next.dv = last.dv;
        }
        next.disp.copy_from_slice(motion.disp);
        next
    }

    /// Returns true if OpenSees skips the state determination: no increment, and no element loads.
    pub(super) fn is_at_rest(&self, motion: &ElementInput<'_>) -> bool {
        norm(&self.dv) <= f64::EPSILON && motion.load.iter().all(|p| *p == 0.0)
    }

    pub(super) fn write(&self, state: &mut [f64]) {
        state[..B].copy_from_slice(&self.v);
        state[B..2 * B].copy_from_slice(&self.dv);
        state[2 * B..Self::LEN].copy_from_slice(&self.disp);
    }
}

/// Largest number of deformations, resultants and tangents of a section.
const MAX_RESPONSE: usize = MAX_ORDER * (2 + MAX_ORDER);

/// Geometry, sections and mass of a beam. State variables are those of the transformation, basic forces and stiffness,
/// those of the sections, and those of the formulation.
#[derive(Clone, Debug)]
pub struct Member<const N: usize, const B: usize> {
    pub(super) transform: Arc<dyn Transform<N, B>>,
    /// Sections along the beam.
    pub(super) sections: Vec<SectionSlot>,
    /// Positions and weights of the sections, as fractions of the length.
    pub(super) points: (Vec<f64>, Vec<f64>),
    rho: f64,
    consistent: bool,
    own: usize,
    state_len: usize,
}

impl<const N: usize, const B: usize> Member<N, B> {
    pub(super) fn length(&self) -> f64 {
        self.transform.length()
    }

    /// Returns true for a transformation with small displacements.
    pub(super) fn is_small(&self) -> bool {
        self.transform.is_small()
    }

    /// Index of basic forces and stiffness, after the state variables of the transformation.
    pub(super) fn head(&self) -> usize {
        self.transform.state_len()
    }

    /// Index of the first state variable of the sections.
    pub(super) fn body(&self) -> usize {
        self.head() + Basic::<B>::LEN
    }

    /// Index of the first state variable of the formulation.
    pub(super) fn own_words(&self) -> usize {
        self.own
    }

    /// Deformations, resultants and tangents of the sections in a state.
    pub(super) fn responses(&self, state: &[f64]) -> PerSection<[f64; MAX_RESPONSE]> {
        let padded = |section: &SectionSlot| {
            let (response, mut all) = (section.response(state), [0.0; MAX_RESPONSE]);
            all[..response.len()].copy_from_slice(response);
            all
        };
        self.sections.iter().map(padded).collect()
    }

    /// Restores them without a change of the other state variables.
    pub(super) fn set_responses(&self, responses: &PerSection<[f64; MAX_RESPONSE]>, state: &mut [f64]) {
        for (section, saved) in self.sections.iter().zip(responses) {
            let response = section.response_mut(state);
            response.copy_from_slice(&saved[..response.len()]);
        }
    }

    /// Sections with their position as a fraction and their weight as a length.
    pub(super) fn along(&self) -> impl Iterator<Item = (&SectionSlot, f64, f64)> {
        let length = self.length();
        let places = self.points.0.iter().zip(&self.points.1);
        self.sections.iter().zip(places).map(move |(s, (x, w))| (s, *x, w * length))
    }
}

/// A beam with `N` degrees of freedom and `B` basic deformations that integrates its sections.
#[derive(Clone, Debug)]
pub struct FiberBeam<F, const N: usize, const B: usize> {
    pub(super) member: Member<N, B>,
    pub(super) formulation: F,
}

impl<F: Formulation<N, B>, const N: usize, const B: usize> FiberBeam<F, N, B> {
    /// Makes the beam from its geometry; sections with tags, positions and weights as fractions of the length; mass per
    /// length, lumped or consistent.
    pub fn new(
        formulation: F,
        transform: Arc<dyn Transform<N, B>>,
        sections: Vec<(SharedSection, i32)>,
        points: (Vec<f64>, Vec<f64>),
        (rho, consistent): (f64, bool),
    ) -> Self {
        let mut at = transform.state_len() + Basic::<B>::LEN;
        let length = transform.length();
        let place = |((section, tag), weight): ((SharedSection, i32), &f64)| {
            let size = if F::LOCALISES { weight * length } else { length };
            let slot = SectionSlot::new(of_length(section, size), tag, at);
            at += slot.len();
            slot
        };
        let sections = sections.into_iter().zip(&points.1).map(place).collect();
        let state_len = at + F::STATE_LEN;
        Self { member: Member { transform, sections, points, rho, consistent, own: at, state_len }, formulation }
    }
}

/// Names of the responses of every formulation.
const NAMES: [&str; 7] =
    ["localForce", "basicForce", "basicDeformation", "chordRotation", "plasticRotation", "section", "basicStiffness"];

const LOCAL_FORCE: u32 = 3;
const BASIC_FORCE: u32 = 4;
const DEFORMATION: u32 = 5;
const PLASTIC: u32 = 6;
const PLACES: u32 = 10;
const WEIGHTS: u32 = 11;
const TAGS: u32 = 12;
const ENERGY: u32 = 13;
const STIFFNESS: u32 = 19;
pub(super) const SECTION: u32 = 30;
pub(super) const ALL_SECTIONS: u32 = 31;

impl<F: Formulation<N, B>, const N: usize, const B: usize> CallDependent for FiberBeam<F, N, B> {
    fn last_tangent(&self, history: &[f64], _: &SharedState, tangent: &mut [f64], _: MatrixMask) {
        let m = &self.member;
        let disp = Trace::<N, B>::read(&history[m.own..]).disp;
        let basic = Basic::read(&history[m.head()..]);
        m.transform.add_tangent(&disp, &history[..m.head()], &basic.k, &basic.q, tangent);
    }
    /// The reactions follow the loads at once, the basic forces with the next call.
    fn last_force(&self, history: &[f64], load: &[f64], force: &mut [f64]) {
        let m = &self.member;
        let disp = Trace::<N, B>::read(&history[m.own..]).disp;
        let basic = Basic::<B>::read(&history[m.head()..]);
        force.fill(0.0);
        m.transform.add_force(&disp, &history[..m.head()], &basic.q, &F::Loads::reactions(load), force);
    }
}

crate::watches_columns!([F: fmt::Debug, const N: usize, const B: usize] FiberBeam<F, N, B> => |s| in &s.member.sections);

impl<F: Formulation<N, B>, const N: usize, const B: usize> Element for FiberBeam<F, N, B> {
    fn class(&self) -> Class {
        F::CLASS[usize::from(N == 12)]
    }
    fn dofs(&self) -> usize {
        N
    }
    fn state_len(&self) -> usize {
        self.member.state_len
    }
    fn init(&self, state: &mut [f64]) {
        let m = &self.member;
        m.transform.init(&mut state[..m.head()]);
        m.sections.iter().for_each(|s| s.init(state));
        Basic { q: [0.0; B], k: F::initial_stiffness(m) }.write(&mut state[m.head()..]);
        self.formulation.settle(m, state);
    }
    fn traits(&self) -> ElementTraits {
        let sections = || self.member.sections.iter().map(|s| &s.section);
        ElementTraits {
            linear: !F::DEFLECTS && self.member.transform.is_linear() && sections().all(|s| s.is_linear()),
            symmetric: F::SYMMETRIC && self.member.transform.is_symmetric(),
            viscous: false,
            elapses: sections().any(|s| s.depends_on_time()),
            rayleigh: true,
        }
    }

    fn respond(&self, motion: &ElementInput<'_>, h: &mut Histories<'_>, output: ElementOutput<'_>) -> ElementResult {
        let m = &self.member;
        let head = m.head();
        m.transform.advance(motion.disp, &mut h.part(..head))?;
        let v = m.transform.deformation(motion.disp, &h.trial[..head]);
        let basic = self.formulation.respond(m, &v, motion, h)?;
        basic.write(&mut h.trial[head..]);
        let p0 = F::Loads::reactions(motion.load);
        m.transform.add_force(motion.disp, &h.trial[..head], &basic.q, &p0, output.force);
        if let Some(tangent) = output.tangent {
            self.add_tangent(motion.disp, &h.trial[..head], &basic, tangent);
        }
        Ok(())
    }

    fn initial_tangent(&self, tangent: &mut [f64]) {
        self.member.transform.frame().add_basic_stiffness(&F::initial_stiffness(&self.member), tangent);
    }

    fn roles(&self) -> Roles<'_> {
        Roles {
            mass: Some(self),
            parameters: Some(self),
            loads: Some(self),
            exhausted: Some(self),
            euler_load: Some(self),
            kept_tangent: Some(self),
            opensees: {
                let depends = self.formulation.continues_from_last_trial();
                OpenSeesTraits {
                    calls: depends.then_some(self as &dyn CallDependent),
                    ground_inertia: (self.member.rho != 0.0).then_some(1.0),
                    ..OpenSeesTraits::default()
                }
            },
            basic_forces: F::DAMPABLE.then_some(self as &dyn BasicForces),
            force_labels: ForceLabels::Frame,
            ..Roles::default()
        }
    }

    fn probe(&self, words: &[&str]) -> Option<Probe> {
        let plane = N == 6;
        let n = self.member.sections.len();
        let numbered = |stem: &'static str| (1..=n).map(move |i| format!("{stem}{i}"));
        Some(match *words.first()? {
            "localForce" | "localForces" => {
                let names: &[&str] = if plane { &["N", "V", "M"] } else { &["N", "Vy", "Vz", "T", "My", "Mz"] };
                Probe::new(LOCAL_FORCE, (1..=2).flat_map(|e| names.iter().map(move |n| format!("{n}_{e}"))))
            }
            "basicForce" | "basicForces" => Probe::new(BASIC_FORCE, basic_force_names(plane).iter().copied()),
            "chordRotation" | "chordDeformation" | "basicDeformation" | "basicDeformations" | "deformations" => {
                let names = if plane { &["eps", "theta_1", "theta_2"][..] } else { &BASIC_DEFORMATIONS[..] };
                Probe::new(DEFORMATION, names.iter().copied())
            }
            "plasticRotation" | "plasticDeformation" => {
                let plane_names = ["epsP", "thetaP_1", "thetaP_2"];
                let space_names = ["epsP", "thetaZP_1", "thetaZP_2", "thetaYP_1", "thetaYP_2", "thetaXP"];
                Probe::new(PLASTIC, if plane { &plane_names[..] } else { &space_names[..] }.iter().copied())
            }
            "basicStiffness" => Probe::new(STIFFNESS, (1..=B * B).map(|i| format!("k{i}"))),
            "integrationPoints" => Probe::new(PLACES, numbered("x")),
            "integrationWeights" => Probe::new(WEIGHTS, numbered("w")),
            "energy" | "Energy" if self.member.has_energy() => Probe::new(ENERGY, ["energy"]),
            "sectionTags" => Probe::new(TAGS, numbered("tag")),
            "section" | "-section" => return self.member.section_probe(&words[1..]),
            "sectionX" => {
                let x = words.get(1)?.parse::<f64>().ok()? / self.member.length();
                let distance = |i: &usize| (self.member.points.0[*i] - x).abs();
                let i = (0..n).min_by(|i, j| distance(i).total_cmp(&distance(j)))?;
                let probe = self.member.sections[i].probe(&words[2..])?;
                return Some(probe.inside(&[SECTION, i as u32]));
            }
            word => {
                return axis_probe(word)
                    .or_else(|| self.member.deflection_probe(words).filter(|_| F::SHOWS_DEFLECTION));
            }
        })
    }

    fn probe_names(&self) -> Vec<&'static str> {
        let deflection = if F::SHOWS_DEFLECTION { &deflection::NAMES[..] } else { &[] };
        [&NAMES[..], deflection].concat()
    }

    fn read(&self, path: &[u32], s: &Snapshot<'_>, out: &mut [f64]) {
        let m = &self.member;
        let basic = Basic::<B>::read(&s.state[m.head()..]);
        let deformation = || m.transform.deformation(s.disp, &s.state[..m.head()]);
        let length = m.length();
        match path[0] {
            _ if m.transform.frame().read_axis(path, out) => {}
            LOCAL_FORCE => m.transform.frame().local_force(&basic.q, &F::Loads::reactions(s.load), out),
            BASIC_FORCE => out.copy_from_slice(&basic.q),
            DEFORMATION => out.copy_from_slice(&deformation()),
            PLASTIC => {
                let elastic = F::elastic_deformation(m, &basic.q, s.load);
                out.iter_mut().zip(deformation()).zip(elastic).for_each(|((o, v), e)| *o = v - e);
            }
            STIFFNESS => out.copy_from_slice(basic.k.as_flattened()),
            PLACES => out.iter_mut().zip(&m.points.0).for_each(|(o, x)| *o = x * length),
            WEIGHTS => out.iter_mut().zip(&m.points.1).for_each(|(o, w)| *o = w * length),
            ENERGY => out[0] = m.energy(s.state),
            TAGS => out.iter_mut().zip(&m.sections).for_each(|(o, s)| *o = f64::from(s.tag)),
            id if deflection::PATHS.contains(&id) => m.read_deflection(path, &basic.q, s, out),
            SECTION => m.sections[path[1] as usize].read(&path[2..], s.state, out),
            _ => m.read_all_sections(&path[1..], s.state, out),
        }
    }
}

impl<F: Formulation<N, B>, const N: usize, const B: usize> Inertia for FiberBeam<F, N, B> {
    fn mass(&self) -> Mass {
        let Member { transform, rho, consistent, .. } = &self.member;
        match (*rho, consistent) {
            (0.0, _) => Mass::None,
            (rho, false) => Mass::Lumped(lumped_mass::<N>(rho * transform.length())),
            // As in OpenSees, without rotary inertia about the axis.
            (rho, true) => {
                let length = transform.length();
                Mass::Consistent(transform.frame().global_of_local(&consistent_mass::<N>(length, rho, 0.0)))
            }
        }
    }
}

impl<F: Formulation<N, B>, const N: usize, const B: usize> ElementParameters for FiberBeam<F, N, B> {
    fn with_parameter(&self, words: &[&str], value: NewValue) -> Changed<Arc<dyn Element>> {
        let mut new = self.clone();
        let old = match words {
            ["rho"] => exchange(&mut new.member.rho, value),
            ["section", n, rest @ ..] => {
                existing(new.member.sections.get_mut(index(n)?))?.set_parameter(rest, value)?
            }
            _ => last_of(new.member.sections.iter_mut().map(|s| s.set_parameter(words, value)))?,
        };
        Ok((Arc::new(new), old))
    }
}

impl<F: Formulation<N, B>, const N: usize, const B: usize> ElementLoads for FiberBeam<F, N, B> {
    fn load_len(&self) -> usize {
        F::Loads::load_len(self.member.sections.len())
    }
    fn add_load(&self, load: &ElementLoad, factor: f64, sums: &mut [f64]) -> ElementResult {
        if N == 12 {
            load.refuse_moment(self.class().name)?;
        }
        F::Loads::add_load(&self.member, load, factor, sums);
        Ok(())
    }
}

impl<F: Formulation<N, B>, const N: usize, const B: usize> SectionCapacity for FiberBeam<F, N, B> {
    fn exhausted(&self, history: &[f64]) -> Option<String> {
        exhausted(&self.member, history)
    }
}

impl<F: Formulation<N, B>, const N: usize, const B: usize> EulerLoad for FiberBeam<F, N, B> {
    fn euler_load(&self) -> Option<f64> {
        let m = &self.member;
        let loads = m.sections.iter().map(|s| euler_load(&rigidities(&s.section), m.length()));
        m.transform.is_small().then(|| loads.fold(f64::INFINITY, f64::min))
    }
}

/// Sets the coefficient of a basic quantity, if the basic system has it.
pub(super) fn set<const B: usize>(row: &mut [f64; B], at: usize, value: f64) {
    if let Some(x) = row.get_mut(at) {
        *x = value;
    }
}

/// Index of the basic pair of bending about z, shear along y, bending about y, or shear along z.
pub(super) fn bending_at(resultant: Resultant) -> Option<usize> {
    match resultant {
        Resultant::Mz | Resultant::Vy => Some(1),
        Resultant::My | Resultant::Vz => Some(3),
        _ => None,
    }
}
