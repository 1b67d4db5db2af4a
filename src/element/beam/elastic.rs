//! `elasticBeamColumn` in the plane and in space: Euler-Bernoulli or, with shear areas, Timoshenko.

use crate::element::load::{ElementLoad, EndActions};
use crate::element::transform::{Frame, Reactions, Transform};
use crate::element::{Answer, Element, ElementError, Mass, Motion, Nature, Snapshot, dot, frame_force_labels};
use crate::numeric::axpy;
use crate::probe::Probe;

/// Moment hinges at the ends of a beam.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Release {
    /// None.
    #[default]
    None,
    /// At node i.
    I,
    /// At node j.
    J,
    /// At both.
    Both,
}

/// An elastic cross-section; what the plane has no use for is zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ElasticSection {
    /// Elastic modulus.
    pub e: f64,
    /// Area.
    pub area: f64,
    /// Second moment of area about z.
    pub iz: f64,
    /// Second moment of area about y.
    pub iy: f64,
    /// Shear modulus.
    pub g: f64,
    /// Torsion constant.
    pub j: f64,
    /// Shear areas along y and z; `None` for a section rigid in shear.
    pub shear: (Option<f64>, Option<f64>),
}

/// Bending about one axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bending {
    /// Flexural rigidity E I.
    pub ei: f64,
    /// Shear rigidity G A_v; `None` for a beam rigid in shear.
    pub gav: Option<f64>,
    /// Hinges.
    pub release: Release,
}

impl Bending {
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

    /// Moments at the clamped or hinged ends under a load across the beam, positive like the end rotations for a load
    /// along the positive axis and rotations that go with it (i, then j).
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

/// An elastic beam-column with `N` degrees of freedom and `B` basic deformations.
#[derive(Debug)]
pub struct ElasticBeam<const N: usize, const B: usize> {
    transform: Box<dyn Transform<N, B>>,
    /// Basic stiffness.
    kb: [[f64; B]; B],
    /// Bending about z and, in space, about y.
    bending: [Bending; 2],
    /// Mass per length.
    rho: f64,
    /// Polar radius of gyration squared J/A, for a consistent mass; `None` for a lumped one.
    consistent: Option<f64>,
    class: &'static str,
    /// Global matrices, where they do not change with the displacements.
    constant: Option<Box<Constant<N>>>,
}

/// What is constant about an elastic beam under small displacements: worth keeping, since most elements of a building
/// are such beams.
#[derive(Debug)]
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
}

impl ElasticBeam<6, 3> {
    /// In the plane: axial rigidity E A, bending, mass per length, lumped or consistent.
    pub fn plane(transform: Box<dyn Transform<6, 3>>, ea: f64, z: Bending, rho: f64, consistent: bool) -> Self {
        let length = transform.length();
        let k = z.stiffness(length);
        let kb = [[ea / length, 0.0, 0.0], [0.0, k[0][0], k[0][1]], [0.0, k[1][0], k[1][1]]];
        Self::new("ElasticBeam2d", transform, kb, [z, z], rho, consistent.then_some(0.0))
    }

    /// In the plane, with the factors K11, K33 and K44 of E I/L for the stiffness of the end rotations i, j and of one
    /// with the other, in place of 4, 4 and 2 (Zareian and Medina, 2010). Member loads act as on an unmodified beam.
    pub fn modified(
        transform: Box<dyn Transform<6, 3>>,
        (ea, ei): (f64, f64),
        [k11, k33, k44]: [f64; 3],
        rho: f64,
        consistent: bool,
    ) -> Self {
        let k = ei / transform.length();
        let kb = [[ea / transform.length(), 0.0, 0.0], [0.0, k11 * k, k44 * k], [0.0, k44 * k, k33 * k]];
        let z = Bending { ei, gav: None, release: Release::None };
        Self::new("ModElasticBeam2d", transform, kb, [z, z], rho, consistent.then_some(0.0))
    }
}

impl ElasticBeam<12, 6> {
    /// In space: axial rigidity E A, torsional rigidity G J, bending about z and y, mass per length; `consistent` has
    /// J/A for a consistent mass.
    pub fn space(
        transform: Box<dyn Transform<12, 6>>,
        (ea, gj): (f64, f64),
        (z, y): (Bending, Bending),
        rho: f64,
        consistent: Option<f64>,
    ) -> Self {
        let length = transform.length();
        let mut kb = [[0.0; 6]; 6];
        kb[0][0] = ea / length;
        kb[5][5] = gj / length;
        for (at, bending) in [(1, z), (3, y)] {
            let k = bending.stiffness(length);
            for (row, k) in kb[at..at + 2].iter_mut().zip(k) {
                row[at..at + 2].copy_from_slice(&k);
            }
        }
        Self::new("ElasticBeam3d", transform, kb, [z, y], rho, consistent)
    }
}

impl<const N: usize, const B: usize> ElasticBeam<N, B> {
    fn new(
        class: &'static str,
        transform: Box<dyn Transform<N, B>>,
        kb: [[f64; B]; B],
        bending: [Bending; 2],
        rho: f64,
        consistent: Option<f64>,
    ) -> Self {
        let constant = Constant::of(transform.as_ref(), &kb);
        Self { transform, kb, bending, rho, consistent, class, constant }
    }

    /// Force and tangent from the constant matrices.
    fn respond_small(&self, c: &Constant<N>, m: &Motion<'_>, answer: Answer<'_>) {
        let frame = self.frame();
        let u = frame.since_made(m.disp);
        // The matrices are symmetric: rows serve as columns.
        for (row, u) in c.stiffness.iter().zip(&u) {
            axpy(*u, row, answer.force);
        }
        if m.load.iter().any(|l| *l != 0.0) {
            let mut q = [0.0; B];
            q.copy_from_slice(&m.load[..B]);
            frame.add_basic_force(&q, answer.force);
            frame.add_reactions(&Self::reactions(m.load), answer.force);
        }
        let axial = m.load[0] + self.kb[0][0] * dot(&frame.basic[0], &u);
        if let Some(g) = &c.geometric {
            for (row, u) in g.iter().zip(&u) {
                axpy(axial * u, row, answer.force);
            }
        }
        if let Some(tangent) = answer.tangent {
            for (t, k) in tangent.iter_mut().zip(c.stiffness.iter().flatten()) {
                *t += k;
            }
            if let Some(g) = &c.geometric {
                for (t, g) in tangent.iter_mut().zip(g.iter().flatten()) {
                    *t += axial * g;
                }
            }
        }
    }

    fn frame(&self) -> &Frame<N, B> {
        self.transform.frame()
    }

    /// Basic forces: stiffness times deformations, and the fixed-end forces of member loads.
    #[inline]
    fn basic_force(&self, disp: &[f64], state: &[f64], load: &[f64]) -> [f64; B] {
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

    /// Local consistent mass matrix (Przemieniecki, 1968, section 11.4, rigid in shear).
    fn consistent_mass(&self, gyration: f64) -> [[f64; N]; N] {
        let l = self.transform.length();
        let m = self.rho * l / 420.0;
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
        // Deflection, rotation, and the sign with which they go together.
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
}

const LOCAL_FORCE: u32 = 3;
const BASIC_FORCE: u32 = 4;
const DEFORMATION: u32 = 5;
const STIFFNESS: u32 = 19;

impl<const N: usize, const B: usize> Element for ElasticBeam<N, B> {
    fn class(&self) -> &'static str {
        self.class
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
    fn nature(&self) -> Nature {
        Nature { linear: self.transform.is_linear(), symmetric: true, viscous: false, elapses: false, rayleigh: true }
    }

    fn respond(
        &self,
        m: &Motion<'_>,
        committed: &[f64],
        trial: &mut [f64],
        answer: Answer<'_>,
    ) -> Result<(), ElementError> {
        if let Some(c) = &self.constant {
            self.respond_small(c, m, answer);
            return Ok(());
        }
        self.transform.advance(m.disp, committed, trial)?;
        let q = self.basic_force(m.disp, trial, m.load);
        self.transform.add_force(m.disp, trial, &q, &Self::reactions(m.load), answer.force);
        if let Some(tangent) = answer.tangent {
            self.transform.add_tangent(m.disp, trial, &self.kb, &q, tangent);
        }
        Ok(())
    }

    fn initial_tangent(&self, tangent: &mut [f64]) {
        self.frame().add_basic_stiffness(&self.kb, tangent);
    }

    fn ground_inertia_slip(&self) -> Option<f64> {
        (self.rho != 0.0).then_some(if N == 6 { 2.0 } else { 1.0 })
    }

    fn mass(&self) -> Mass {
        if self.rho == 0.0 {
            return Mass::None;
        }
        if let Some(gyration) = self.consistent {
            return Mass::Consistent(self.frame().global_of_local(&self.consistent_mass(gyration)));
        }
        let mut m = vec![0.0; N];
        let half = N / 2;
        for node in 0..2 {
            m[node * half..node * half + if N == 6 { 2 } else { 3 }].fill(0.5 * self.rho * self.transform.length());
        }
        Mass::Lumped(m)
    }

    fn load_len(&self) -> usize {
        B + 5
    }

    fn add_load(&self, load: &ElementLoad, factor: f64, words: &mut [f64]) -> Result<(), ElementError> {
        let length = self.transform.length();
        let (y, z, (axial, axial_j)) = load.end_actions(length);
        let (q0, p0) = words.split_at_mut(B);
        q0[0] -= factor * axial_j;
        p0[0] -= factor * axial;
        // A load along z bends about y, with the opposite sign.
        let planes = [(&y, &self.bending[0], 1, 1.0), (&z, &self.bending[1], 3, -1.0)];
        for (actions, bending, at, sign) in planes.into_iter().take(if N == 6 { 1 } else { 2 }) {
            let (i, j) = bending.end_moments(actions, length);
            q0[at] += sign * factor * i;
            q0[at + 1] += sign * factor * j;
            p0[at] -= factor * actions.shear.0;
            p0[at + 1] -= factor * actions.shear.1;
        }
        Ok(())
    }

    fn probe(&self, words: &[&str]) -> Option<Probe> {
        let plane = N == 6;
        Some(match *words.first()? {
            "localForce" | "localForces" => {
                let names: &[&str] = if plane { &["N", "V", "M"] } else { &["N", "Vy", "Vz", "T", "My", "Mz"] };
                Probe::new(LOCAL_FORCE, (1..=2).flat_map(|e| names.iter().map(move |n| format!("{n}_{e}"))))
            }
            "basicForce" | "basicForces" => Probe::new(
                BASIC_FORCE,
                if plane { &["N", "M_1", "M_2"][..] } else { &BASIC_FORCES[..] }.iter().copied(),
            ),
            "deformatons" | "deformations" | "basicDeformation" | "basicDeformations" | "chordRotation"
            | "chordDeformation" => {
                let names = if plane { &["eps", "theta1", "theta2"][..] } else { &BASIC_DEFORMATIONS[..] };
                Probe::new(DEFORMATION, names.iter().copied())
            }
            "basicStiffness" => Probe::new(STIFFNESS, (1..=B * B).map(|i| format!("k{i}"))),
            _ => return None,
        })
    }

    fn probe_names(&self) -> &'static [&'static str] {
        &["localForce", "basicForce", "deformations", "basicDeformation", "chordRotation", "basicStiffness"]
    }

    fn force_labels(&self) -> Vec<String> {
        frame_force_labels(N)
    }

    fn read(&self, path: &[u32], s: &Snapshot<'_>, out: &mut [f64]) {
        match path[0] {
            LOCAL_FORCE => {
                self.frame().local_force(&self.basic_force(s.disp, s.state, s.load), &Self::reactions(s.load), out);
            }
            BASIC_FORCE => out.copy_from_slice(&self.basic_force(s.disp, s.state, s.load)),
            DEFORMATION => out.copy_from_slice(&self.transform.deformation(s.disp, s.state)),
            _ => out.iter_mut().zip(self.kb.iter().flatten()).for_each(|(o, k)| *o = *k),
        }
    }
}

const BASIC_FORCES: [&str; 6] = ["N", "Mz_1", "Mz_2", "My_1", "My_2", "T"];
const BASIC_DEFORMATIONS: [&str; 6] = ["eps", "thetaZ_1", "thetaZ_2", "thetaY_1", "thetaY_2", "thetaX"];
