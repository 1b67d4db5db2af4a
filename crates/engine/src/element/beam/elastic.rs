//! `elasticBeamColumn` in the plane and in space: Euler-Bernoulli or, with shear areas, Timoshenko.

use super::basic::{BASIC_DEFORMATIONS, basic_force_names};
use crate::element::load::{ElementLoad, EndActions};
use crate::element::roles::{ElementLoads, ElementParameters, EulerLoad, ForceLabels, Inertia, LinearBeam, Roles};
use crate::element::transform::{Frame, Reactions, Transform, axis_probe};
use crate::element::{
    Class, Element, ElementInput, ElementOutput, ElementResult, ElementTraits, Histories, Mass, OpenSeesTraits,
    PDeltaParts, SmallBeam, Snapshot,
};
use crate::numeric::axpy;
use crate::parameter::{Changed, NewValue, exchange, existing, first};
use crate::probe::Probe;
use crate::section::{ElasticSection, Resultant, SharedSection};
use std::sync::Arc;

/// Moment releases at the ends of a beam.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Release {
    /// No release.
    #[default]
    None,
    /// At node i.
    I,
    /// At node j.
    J,
    /// At both ends.
    Both,
}

/// Bending about one axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bending {
    /// Flexural rigidity E I, force x length².
    pub ei: f64,
    /// Shear rigidity G A_v, force; `None` for a beam without shear deformation.
    pub gav: Option<f64>,
    /// Moment releases.
    pub release: Release,
}

impl Bending {
    /// Bending about z and about y.
    pub(super) fn of(section: &ElasticSection, release: (Release, Release)) -> [Self; 2] {
        let (y, z) = section.shear_rigidity();
        [
            Self { ei: section.e * section.iz, gav: y, release: release.0 },
            Self { ei: section.e * section.iy, gav: z, release: release.1 },
        ]
    }

    /// Ratio of bending to shear stiffness φ = 12 EI / (G A_v L²) (Przemieniecki, 1968, section 5.6).
    pub(super) fn phi(&self, length: f64) -> f64 {
        self.gav.map_or(0.0, |g| 12.0 * self.ei / (g * length * length))
    }

    /// Stiffness of the end rotations: [[k_ii, k_ij], [k_ij, k_jj]].
    pub(super) fn stiffness(&self, length: f64) -> [[f64; 2]; 2] {
        let phi = self.phi(length);
        let k = self.ei / length / (1.0 + phi);
        let hinged = 3.0 * self.ei / length / (1.0 + 0.25 * phi);
        match self.release {
            Release::None => [[(4.0 + phi) * k, (2.0 - phi) * k], [(2.0 - phi) * k, (4.0 + phi) * k]],
            Release::I => [[0.0, 0.0], [0.0, hinged]],
            Release::J => [[hinged, 0.0], [0.0, 0.0]],
            Release::Both => [[0.0; 2]; 2],
        }
    }

    /// Moments at the clamped or released ends i and j under a transverse load. They have the sign of the end
    /// rotations, for a load along the positive axis and rotations of positive slope.
    pub(super) fn end_moments(&self, actions: &EndActions, length: f64) -> (f64, f64) {
        let phi = self.phi(length);
        let (mi, mj) = (-actions.moment.0, actions.moment.1);
        let i = (mi + 0.5 * phi * (mi - mj)) / (1.0 + phi);
        let j = (mj + 0.5 * phi * (mj - mi)) / (1.0 + phi);
        let carry = (2.0 - phi) / (4.0 + phi);
        match self.release {
            Release::None => (i, j),
            Release::I => (0.0, j - carry * i),
            Release::J => (i - carry * j, 0.0),
            Release::Both => (0.0, 0.0),
        }
    }
}

/// Stiffness of the basic system with `B` deformations for a beam of the given length.
pub(super) fn basic_stiffness<const B: usize>(
    section: &ElasticSection,
    bending: &[Bending; 2],
    length: f64,
) -> [[f64; B]; B] {
    let mut kb = [[0.0; B]; B];
    kb[0][0] = section.e * section.area / length;
    for (at, bending) in [1, 3].into_iter().zip(bending).take(B / 3) {
        for (row, k) in kb[at..at + 2].iter_mut().zip(bending.stiffness(length)) {
            row[at..at + 2].copy_from_slice(&k);
        }
    }
    if let Some(twist) = kb.get_mut(5) {
        twist[5] = section.g * section.j / length;
    }
    kb
}

/// A rigidity below this part of the other one is none: the model does not bend in that plane.
const MIN_RIGIDITY_RATIO: f64 = 1e-3;

/// Euler load of a beam with pinned ends: the smaller π² E I / L² of its flexural rigidities.
pub(super) fn euler_load(rigidities: &[f64], length: f64) -> f64 {
    let largest = rigidities.iter().fold(0.0f64, |m, ei| m.max(*ei));
    let counting = rigidities.iter().filter(|ei| **ei > MIN_RIGIDITY_RATIO * largest);
    let least = counting.fold(f64::INFINITY, |m, ei| m.min(*ei));
    std::f64::consts::PI.powi(2) * least / (length * length)
}

/// The flexural rigidities of a virgin section, force x length².
pub(super) fn rigidities(section: &SharedSection) -> Vec<f64> {
    let resultants = section.resultants();
    let n = resultants.len();
    let mut k = vec![0.0; n * n];
    section.initial_stiffness(&mut k);
    let bends = |r: &Resultant| matches!(r, Resultant::Mz | Resultant::My);
    let rigidity = |(i, r): (usize, &Resultant)| bends(r).then(|| k[i * n + i]);
    resultants.iter().enumerate().filter_map(rigidity).collect()
}

/// Properties of an elastic beam besides section and geometry.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ElasticOptions {
    /// Releases about z and about y.
    pub release: (Release, Release),
    /// Mass per length.
    pub rho: f64,
    /// Consistent mass in place of lumped mass.
    pub consistent: bool,
}

/// An elastic beam-column with `N` degrees of freedom and `B` basic deformations.
#[derive(Clone, Debug)]
pub struct ElasticBeam<const N: usize, const B: usize> {
    pub(super) transform: Arc<dyn Transform<N, B>>,
    section: ElasticSection,
    options: ElasticOptions,
    /// Factors K11, K33, K44 of E I/L of a modified beam: about z and, in space, about y.
    modified: Option<[[f64; 3]; 2]>,
    /// Basic stiffness.
    pub(super) kb: [[f64; B]; B],
    /// Bending about z and, in space, about y.
    bending: [Bending; 2],
    /// Global matrices of the tangent, if they are independent of the displacements.
    constant: Option<Box<Constant<N>>>,
}

/// Parts of the tangent of an elastic beam for small displacements.
#[derive(Clone, Debug)]
struct Constant<const N: usize> {
    stiffness: [[f64; N]; N],
    /// Geometric stiffness per unit of axial force; none without P-Delta.
    geometric: Option<[[f64; N]; N]>,
}

impl<const N: usize> Constant<N> {
    fn of<const B: usize>(transform: &dyn Transform<N, B>, kb: &[[f64; B]; B]) -> Option<Box<Self>> {
        if !transform.is_small() {
            return None;
        }
        let rest = vec![0.0; N];
        let matrix = |kb: &[[f64; B]; B], q: &[f64; B]| {
            let mut k = vec![0.0; N * N];
            transform.add_tangent(&rest, &[], kb, q, &mut k);
            std::array::from_fn(|i| std::array::from_fn(|j| k[i * N + j]))
        };
        let stiffness = matrix(kb, &[0.0; B]);
        let mut pull = [0.0; B];
        pull[0] = 1.0;
        let geometric = (!transform.is_linear()).then(|| matrix(&[[0.0; B]; B], &pull));
        Some(Box::new(Self { stiffness, geometric }))
    }

    /// Adds the tangent for an axial force.
    fn add_tangent(&self, axial: f64, tangent: &mut [f64]) {
        axpy(1.0, self.stiffness.as_flattened(), tangent);
        if let Some(g) = &self.geometric {
            axpy(axial, g.as_flattened(), tangent);
        }
    }
}

impl<const N: usize, const B: usize> ElasticBeam<N, B> {
    /// Replaces the factors 4, 4 and 2 of E I/L in the end rotation stiffness by K11, K33 and K44 (Zareian and Medina,
    /// 2010), about z and, in space, about y. They belong to i, to j and to their coupling. Member loads act as on an
    /// unmodified beam.
    pub fn modified(
        transform: Arc<dyn Transform<N, B>>,
        section: ElasticSection,
        factors: [[f64; 3]; 2],
        options: ElasticOptions,
    ) -> Self {
        Self { modified: Some(factors), ..Self::new(transform, section, options) }.rebuilt()
    }
}

impl<const N: usize, const B: usize> ElasticBeam<N, B> {
    /// Makes the beam from its geometry, its section and its options.
    pub fn new(transform: Arc<dyn Transform<N, B>>, section: ElasticSection, options: ElasticOptions) -> Self {
        let bending = Bending::of(&section, options.release);
        Self { transform, section, options, modified: None, kb: [[0.0; B]; B], bending, constant: None }.rebuilt()
    }

    /// Computes the matrices for the current properties.
    fn rebuilt(mut self) -> Self {
        let length = self.transform.length();
        self.bending = Bending::of(&self.section, self.options.release);
        self.kb = basic_stiffness(&self.section, &self.bending, length);
        if let Some(factors) = self.modified {
            for (at, ([k11, k33, k44], bending)) in
                [1, 3].into_iter().zip(factors.iter().zip(&self.bending)).take(B / 3)
            {
                let k = bending.ei / length;
                self.kb[at][at..at + 2].copy_from_slice(&[k11 * k, k44 * k]);
                self.kb[at + 1][at..at + 2].copy_from_slice(&[k44 * k, k33 * k]);
            }
        }
        self.constant = Constant::of(self.transform.as_ref(), &self.kb);
        self
    }

    fn frame(&self) -> &Frame<N, B> {
        self.transform.frame()
    }

    /// Basic forces: stiffness times deformations plus fixed-end forces of member loads.
    #[inline]
    pub(super) fn basic_force(&self, disp: &[f64], state: &[f64], load: &[f64]) -> [f64; B] {
        let v = self.transform.deformation(disp, state);
        let mut q = self.kb.each_ref().map(|row| row.iter().zip(&v).map(|(k, v)| k * v).sum());
        q.iter_mut().zip(load).for_each(|(q, l)| *q += l);
        q
    }

    fn reactions(load: &[f64]) -> Reactions {
        let mut p0 = [0.0; 5];
        p0.copy_from_slice(&load[B..]);
        p0
    }
}

/// Local consistent mass matrix without shear deformation (Przemieniecki, 1968, section 11.4). `rho` is mass per
/// length, `gyration` the square of the polar radius of gyration.
pub(super) fn consistent_mass<const N: usize>(l: f64, rho: f64, gyration: f64) -> [[f64; N]; N] {
    let m = rho * l / 420.0;
    let mut out = [[0.0; N]; N];
    let mut pair = |i: usize, j: usize, x: f64| {
        out[i][j] = m * x;
        out[j][i] = m * x;
    };
    let half = N / 2;
    for (at, factor) in [(0, 1.0), (3, gyration)] {
        // Axial, and in space torsion.
        if at == 0 || N == 12 {
            pair(at, at, 140.0 * factor);
            pair(at + half, at + half, 140.0 * factor);
            pair(at, at + half, 70.0 * factor);
        }
    }
    // Deflection, rotation, and the sign of their coupling.
    let planes: &[(usize, usize, f64)] = if N == 6 { &[(1, 2, 1.0)] } else { &[(1, 5, 1.0), (2, 4, -1.0)] };
    for &(v, r, s) in planes {
        let (v2, r2) = (v + half, r + half);
        pair(v, v, 156.0);
        pair(v2, v2, 156.0);
        pair(v, v2, 54.0);
        pair(r, r, 4.0 * l * l);
        pair(r2, r2, 4.0 * l * l);
        pair(r, r2, -3.0 * l * l);
        pair(v, r, s * 22.0 * l);
        pair(v2, r2, -s * 22.0 * l);
        pair(v, r2, -s * 13.0 * l);
        pair(v2, r, s * 13.0 * l);
    }
    out
}

/// Diagonal of the lumped mass: half at each end, translations only.
pub(super) fn lumped_mass<const N: usize>(total: f64) -> Vec<f64> {
    let mut m = vec![0.0; N];
    for node in m.chunks_exact_mut(N / 2) {
        node[..if N == 6 { 2 } else { 3 }].fill(0.5 * total);
    }
    m
}

/// Adds a load times a factor to the load sums of a clamped beam: its basic forces, then the reactions of the simple
/// beam.
pub(super) fn add_clamped_load<const B: usize>(
    load: &ElementLoad,
    factor: f64,
    bending: &[Bending; 2],
    length: f64,
    sums: &mut [f64],
) {
    let (y, z, (axial, axial_j)) = load.end_actions(length);
    let (q0, p0) = sums.split_at_mut(B);
    q0[0] -= factor * axial_j;
    p0[0] -= factor * axial;
    // A load along z bends about y, with the opposite sign.
    let planes = [(&y, &bending[0], 1, 1.0), (&z, &bending[1], 3, -1.0)];
    for (actions, bending, at, sign) in planes.into_iter().take(B / 3) {
        let (i, j) = bending.end_moments(actions, length);
        q0[at] += sign * factor * i;
        q0[at + 1] += sign * factor * j;
        p0[at] -= factor * actions.shear.0;
        p0[at + 1] -= factor * actions.shear.1;
    }
}

const LOCAL_FORCE: u32 = 3;
const BASIC_FORCE: u32 = 4;
const DEFORMATION: u32 = 5;
const STIFFNESS: u32 = 19;

crate::watches_columns!([const N: usize, const B: usize] ElasticBeam<N, B> => nothing);

impl<const N: usize, const B: usize> Element for ElasticBeam<N, B> {
    fn class(&self) -> Class {
        match (N, self.modified) {
            (6, None) => Class::new("ElasticBeam2d", 3),
            (6, _) => Class::new("ModElasticBeam2d", 4),
            (_, None) => Class::new("ElasticBeam3d", 5),
            _ => Class::new("ModElasticBeam3d", 41234),
        }
    }
    fn dofs(&self) -> usize {
        N
    }
    fn state_len(&self) -> usize {
        self.transform.state_len()
    }
    fn init(&self, state: &mut [f64]) {
        self.transform.init(state);
    }
    fn traits(&self) -> ElementTraits {
        let symmetric = self.transform.is_symmetric();
        ElementTraits { linear: self.transform.is_linear(), symmetric, viscous: false, elapses: false, rayleigh: true }
    }

    fn respond(&self, m: &ElementInput<'_>, h: &mut Histories<'_>, output: ElementOutput<'_>) -> ElementResult {
        self.transform.advance(m.disp, h)?;
        // Forces from deformations: the round-off of stiffness times displacements is not in equilibrium. A stiff beam
        // that moves with a soft structure would load it.
        let q = self.basic_force(m.disp, h.trial, m.load);
        self.transform.add_force(m.disp, h.trial, &q, &Self::reactions(m.load), output.force);
        match (output.tangent, &self.constant) {
            (Some(tangent), Some(c)) => c.add_tangent(q[0], tangent),
            (Some(tangent), None) => self.transform.add_tangent(m.disp, h.trial, &self.kb, &q, tangent),
            (None, _) => {}
        }
        Ok(())
    }

    fn initial_tangent(&self, tangent: &mut [f64]) {
        self.frame().add_basic_stiffness(&self.kb, tangent);
    }

    fn roles(&self) -> Roles<'_> {
        Roles {
            mass: Some(self),
            parameters: Some(self),
            loads: Some(self),
            euler_load: Some(self),
            small_beam: Some(self),
            opensees: {
                let ground_inertia = (self.options.rho != 0.0).then_some(if N == 6 { 2.0 } else { 1.0 });
                OpenSeesTraits { ground_inertia, ..OpenSeesTraits::default() }
            },
            basic_forces: Some(self),
            force_labels: ForceLabels::Frame,
            ..Roles::default()
        }
    }

    fn probe(&self, words: &[&str]) -> Option<Probe> {
        let plane = N == 6;
        Some(match *words.first()? {
            "localForce" | "localForces" => {
                let names: &[&str] = if plane { &["N", "V", "M"] } else { &["N", "Vy", "Vz", "T", "My", "Mz"] };
                Probe::new(LOCAL_FORCE, (1..=2).flat_map(|e| names.iter().map(move |n| format!("{n}_{e}"))))
            }
            "basicForce" | "basicForces" => Probe::new(BASIC_FORCE, basic_force_names(plane).iter().copied()),
            "deformatons" | "deformations" | "basicDeformation" | "basicDeformations" | "chordRotation"
            | "chordDeformation" => {
                let names = if plane { &["eps", "theta1", "theta2"][..] } else { &BASIC_DEFORMATIONS[..] };
                Probe::new(DEFORMATION, names.iter().copied())
            }
            "basicStiffness" => Probe::new(STIFFNESS, (1..=B * B).map(|i| format!("k{i}"))),
            word => return axis_probe(word),
        })
    }

    fn probe_names(&self) -> Vec<&'static str> {
        vec!["localForce", "basicForce", "deformations", "basicDeformation", "chordRotation", "basicStiffness"]
    }

    fn read(&self, path: &[u32], s: &Snapshot<'_>, out: &mut [f64]) {
        match path[0] {
            _ if self.frame().read_axis(path, out) => {}
            LOCAL_FORCE => {
                self.frame().local_force(&self.basic_force(s.disp, s.state, s.load), &Self::reactions(s.load), out);
            }
            BASIC_FORCE => out.copy_from_slice(&self.basic_force(s.disp, s.state, s.load)),
            DEFORMATION => out.copy_from_slice(&self.transform.deformation(s.disp, s.state)),
            _ => out.iter_mut().zip(self.kb.iter().flatten()).for_each(|(o, k)| *o = *k),
        }
    }
}

impl<const N: usize, const B: usize> Inertia for ElasticBeam<N, B> {
    fn mass(&self) -> Mass {
        if self.options.rho == 0.0 {
            return Mass::None;
        }
        let length = self.transform.length();
        if self.options.consistent {
            let gyration = self.section.j / self.section.area;
            let local = consistent_mass::<N>(length, self.options.rho, gyration);
            return Mass::Consistent(self.frame().global_of_local(&local));
        }
        Mass::Lumped(lumped_mass::<N>(self.options.rho * length))
    }
}

impl<const N: usize, const B: usize> ElementParameters for ElasticBeam<N, B> {
    fn with_parameter(&self, words: &[&str], value: NewValue) -> Changed<Arc<dyn Element>> {
        let mut new = self.clone();
        let place = match (first(words)?, &mut new.modified) {
            ("rho", _) => &mut new.options.rho,
            ("K11" | "K11z", Some(k)) => &mut k[0][0],
            ("K33" | "K33z", Some(k)) => &mut k[0][1],
            ("K44" | "K44z", Some(k)) => &mut k[0][2],
            ("K11y", Some(k)) => &mut k[1][0],
            ("K33y", Some(k)) => &mut k[1][1],
            ("K44y", Some(k)) => &mut k[1][2],
            (name, _) => existing(new.section.parameter(name))?,
        };
        let old = exchange(place, value);
        Ok((Arc::new(new.rebuilt()), old))
    }
}

impl<const N: usize, const B: usize> ElementLoads for ElasticBeam<N, B> {
    fn load_len(&self) -> usize {
        B + 5
    }
    fn add_load(&self, load: &ElementLoad, factor: f64, sums: &mut [f64]) -> ElementResult {
        if N == 12 {
            load.refuse_moment(self.class().name)?;
        }
        add_clamped_load::<B>(load, factor, &self.bending, self.transform.length(), sums);
        Ok(())
    }
}

impl<const N: usize, const B: usize> EulerLoad for ElasticBeam<N, B> {
    fn euler_load(&self) -> Option<f64> {
        let s = &self.section;
        let rigidities = [s.e * s.iz, s.e * s.iy];
        self.transform.is_small().then(|| euler_load(&rigidities[..B / 3], self.transform.length()))
    }
}

impl<const N: usize, const B: usize> LinearBeam for ElasticBeam<N, B> {
    fn small_beam(&self) -> Option<SmallBeam<'_>> {
        let constant = self.constant.as_ref()?;
        let frame = self.frame();
        let p_delta = constant.geometric.as_ref().map(|geometric| PDeltaParts {
            across: frame.across().map(|row| row.to_vec()).collect(),
            stiffness: constant.stiffness.as_flattened(),
            geometric: geometric.as_flattened(),
        });
        Some(SmallBeam {
            length: frame.length,
            basic: frame.basic.as_flattened(),
            initial: &frame.initial,
            stiffness: self.kb.as_flattened(),
            reactions: frame.reaction_rows(),
            p_delta,
        })
    }
}
