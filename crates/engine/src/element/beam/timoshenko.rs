//! The elastic Timoshenko beam: `ElasticTimoshenkoBeam`.

use super::elastic::{basic_stiffness, lumped_mass};
use super::{Bending, Release};
use crate::element::roles::{ElementLoads, ElementParameters, ForceLabels, Inertia, Roles};
use crate::element::transform::{Frame, Reactions, axis_probe};
use crate::element::{
    Class, Element, ElementInput, ElementLoad, ElementOutput, ElementResult, ElementTraits, Histories, Mass,
    OpenSeesTraits, Snapshot, dot,
};
use crate::numeric::axpy;
use crate::parameter::{Changed, NewValue, exchange, existing, first};
use crate::probe::Probe;
use crate::section::ElasticSection;
use std::sync::Arc;

/// An elastic beam with shear deformation for small displacements, with `N` degrees of freedom and `B` basic
/// deformations. Stiffness, consistent mass and geometric stiffness use the interpolation of the Timoshenko beam under
/// end forces (Friedman and Kosmatka, 1993).
#[derive(Debug)]
pub struct TimoshenkoBeam<const N: usize, const B: usize> {
    frame: Frame<N, B>,
    section: ElasticSection,
    options: TimoshenkoOptions,
    bending: [Bending; 2],
    /// Basic stiffness.
    kb: [[f64; B]; B],
    /// Global stiffness, N x N by rows.
    stiffness: Vec<f64>,
    geometric: Option<Box<Geometric<N>>>,
    mass: Mass,
}

/// Geometric stiffness per unit of axial force.
#[derive(Debug)]
struct Geometric<const N: usize> {
    local: [[f64; N]; N],
    global: Vec<f64>,
}

/// Properties of a Timoshenko beam besides its stiffness.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct TimoshenkoOptions {
    /// Mass per length.
    pub rho: f64,
    /// Consistent mass matrix with the rotary inertia of the section, in place of a lumped one.
    pub consistent: bool,
    /// Geometric stiffness of the axial force.
    pub geometric: bool,
}

/// Entries of a symmetric local matrix in a plane of bending.
///
/// The first two are deflection with itself and with that of the other end, the next two the same for the rotation.
/// Then follows deflection at i with the rotations at i and j. At j the last two have the opposite sign.
struct PlaneTerms {
    vv: [f64; 2],
    rr: [f64; 2],
    vr: [f64; 2],
}

impl<const N: usize, const B: usize> TimoshenkoBeam<N, B> {
    /// Makes the beam from its geometry, its section and its options.
    pub fn new(frame: Frame<N, B>, section: ElasticSection, options: TimoshenkoOptions) -> Self {
        let bending = Bending::of(&section, (Release::None, Release::None));
        let kb = basic_stiffness(&section, &bending, frame.length);
        let mut stiffness = vec![0.0; N * N];
        frame.add_basic_stiffness(&kb, &mut stiffness);
        let geometric = options.geometric.then(|| {
            let local = geometric_stiffness(frame.length, &bending);
            Box::new(Geometric { local, global: frame.global_of_local(&local) })
        });
        let mass = if options.rho == 0.0 {
            Mass::None
        } else if options.consistent {
            Mass::Consistent(frame.global_of_local(&consistent_mass(frame.length, &bending, &section, options.rho)))
        } else {
            Mass::Lumped(lumped_mass::<N>(options.rho * frame.length))
        };
        Self { frame, section, options, bending, kb, stiffness, geometric, mass }
    }

    fn basic_force(&self, disp: &[f64]) -> [f64; B] {
        let v = self.frame.deformation(disp);
        self.kb.each_ref().map(|row| dot(row, &v))
    }
}

/// Deflection, rotation, the sign of their coupling, and the bending they belong to.
fn planes<const N: usize>(bending: &[Bending; 2]) -> impl Iterator<Item = (usize, usize, f64, &Bending)> {
    let in_plane = [(1, 2, 1.0, &bending[0])];
    let in_space = [(1, 5, 1.0, &bending[0]), (2, 4, -1.0, &bending[1])];
    let (n, all) = if N == 6 { (1, [in_plane[0], in_plane[0]]) } else { (2, in_space) };
    all.into_iter().take(n)
}

fn add_plane<const N: usize>(out: &mut [[f64; N]; N], (v, r, sign): (usize, usize, f64), t: &PlaneTerms) {
    let (v2, r2) = (v + N / 2, r + N / 2);
    let mut pair = |i: usize, j: usize, x: f64| {
        out[i][j] += x;
        if i != j {
            out[j][i] += x;
        }
    };
    for (i, x) in [(v, t.vv[0]), (v2, t.vv[0]), (r, t.rr[0]), (r2, t.rr[0])] {
        pair(i, i, x);
    }
    pair(v, v2, t.vv[1]);
    pair(r, r2, t.rr[1]);
    pair(v, r, sign * t.vr[0]);
    pair(v2, r2, -sign * t.vr[0]);
    pair(v, r2, sign * t.vr[1]);
    pair(v2, r, -sign * t.vr[1]);
}

/// Local geometric stiffness for a unit tension.
fn geometric_stiffness<const N: usize>(l: f64, bending: &[Bending; 2]) -> [[f64; N]; N] {
    let mut out = [[0.0; N]; N];
    for (v, r, sign, b) in planes::<N>(bending) {
        let p = b.phi(l);
        let c = 1.0 / (30.0 * l * (1.0 + p).powi(2));
        let vv = c * (30.0 * p * p + 60.0 * p + 36.0);
        let rr = |x: f64| c * l * l * (2.5 * p * p + 5.0 * p + x);
        let terms = PlaneTerms { vv: [vv, -vv], rr: [rr(4.0), -rr(1.0)], vr: [3.0 * c * l; 2] };
        add_plane(&mut out, (v, r, sign), &terms);
    }
    out
}

/// Local consistent mass of translation and rotation of the section.
fn consistent_mass<const N: usize>(l: f64, bending: &[Bending; 2], s: &ElasticSection, rho: f64) -> [[f64; N]; N] {
    let mut out = [[0.0; N]; N];
    let half = N / 2;
    let along = [(0, 1.0), (3, s.j / s.area)];
    for &(at, factor) in &along[..if N == 6 { 1 } else { 2 }] {
        let m = factor * rho * l / 6.0;
        out[at][at] = 2.0 * m;
        out[at + half][at + half] = 2.0 * m;
        out[at][at + half] = m;
        out[at + half][at] = m;
    }
    for ((v, r, sign, b), inertia) in planes::<N>(bending).zip([s.iz, s.iy]) {
        let p = b.phi(l);
        let poly = |a: f64, b: f64, c: f64| a * p * p + b * p + c;
        let c = rho * l / 210.0 / (1.0 + p).powi(2);
        let translation = PlaneTerms {
            vv: [c * poly(70.0, 147.0, 78.0), c * poly(35.0, 63.0, 27.0)],
            rr: [c * l * l / 4.0 * poly(7.0, 14.0, 8.0), -c * l * l / 4.0 * poly(7.0, 14.0, 6.0)],
            vr: [c * l / 4.0 * poly(35.0, 77.0, 44.0), -c * l / 4.0 * poly(35.0, 63.0, 26.0)],
        };
        let c = rho * inertia / s.area / (30.0 * l * (1.0 + p).powi(2));
        let rotation = PlaneTerms {
            vv: [36.0 * c, -36.0 * c],
            rr: [c * l * l * poly(10.0, 5.0, 4.0), c * l * l * poly(5.0, -5.0, -1.0)],
            vr: [-c * l * (15.0 * p - 3.0); 2],
        };
        add_plane(&mut out, (v, r, sign), &translation);
        add_plane(&mut out, (v, r, sign), &rotation);
    }
    out
}

const LOCAL_FORCE: u32 = 3;

crate::watches_columns!([const N: usize, const B: usize] TimoshenkoBeam<N, B> => nothing);

impl<const N: usize, const B: usize> Element for TimoshenkoBeam<N, B> {
    fn class(&self) -> Class {
        if N == 6 { Class::new("ElasticTimoshenkoBeam2d", 145) } else { Class::new("ElasticTimoshenkoBeam3d", 146) }
    }
    fn dofs(&self) -> usize {
        N
    }
    fn state_len(&self) -> usize {
        0
    }
    fn init(&self, _: &mut [f64]) {}
    fn traits(&self) -> ElementTraits {
        ElementTraits {
            linear: self.geometric.is_none(),
            symmetric: true,
            viscous: false,
            elapses: false,
            rayleigh: true,
        }
    }

    /// The tangent omits the derivative of the axial force by the displacements, as with P-Delta.
    fn respond(&self, m: &ElementInput<'_>, _: &mut Histories<'_>, output: ElementOutput<'_>) -> ElementResult {
        let q = self.basic_force(m.disp);
        self.frame.add_basic_force(&q, output.force);
        for (row, load) in self.frame.local.iter().zip(m.load) {
            if *load != 0.0 {
                axpy(*load, row, output.force);
            }
        }
        if let Some(g) = &self.geometric {
            for (f, row) in output.force.iter_mut().zip(g.global.chunks_exact(N)) {
                *f += q[0] * dot(row, m.disp);
            }
        }
        if let Some(tangent) = output.tangent {
            axpy(1.0, &self.stiffness, tangent);
            if let Some(g) = &self.geometric {
                axpy(q[0], &g.global, tangent);
            }
        }
        Ok(())
    }

    fn initial_tangent(&self, tangent: &mut [f64]) {
        axpy(1.0, &self.stiffness, tangent);
    }

    fn roles(&self) -> Roles<'_> {
        Roles {
            mass: Some(self),
            parameters: Some(self),
            loads: Some(self),
            opensees: OpenSeesTraits {
                ground_inertia: (self.mass != Mass::None).then_some(2.0),
                ..OpenSeesTraits::default()
            },
            force_labels: ForceLabels::Frame,
            ..Roles::default()
        }
    }

    fn probe(&self, words: &[&str]) -> Option<Probe> {
        let names: &[&str] = if N == 6 { &["N", "V", "M"] } else { &["N", "Vy", "Vz", "T", "My", "Mz"] };
        match *words.first()? {
            "localForce" | "localForces" => {
                Some(Probe::new(LOCAL_FORCE, (1..=2).flat_map(|e| names.iter().map(move |n| format!("{n}_{e}")))))
            }
            word => axis_probe(word),
        }
    }

    fn probe_names(&self) -> Vec<&'static str> {
        vec!["localForce"]
    }

    fn read(&self, path: &[u32], s: &Snapshot<'_>, out: &mut [f64]) {
        if self.frame.read_axis(path, out) {
            return;
        }
        let q = self.basic_force(s.disp);
        self.frame.local_force(&q, &[0.0; 5], out);
        axpy(1.0, s.load, out);
        if let Some(g) = &self.geometric {
            let local = self.frame.local.each_ref().map(|row| dot(row, s.disp));
            out.iter_mut().zip(&g.local).for_each(|(o, row)| *o += q[0] * dot(row, &local));
        }
    }
}

impl<const N: usize, const B: usize> Inertia for TimoshenkoBeam<N, B> {
    fn mass(&self) -> Mass {
        self.mass.clone()
    }
}

impl<const N: usize, const B: usize> ElementParameters for TimoshenkoBeam<N, B> {
    fn with_parameter(&self, words: &[&str], value: NewValue) -> Changed<Arc<dyn Element>> {
        let mut section = self.section;
        let old = exchange(existing(section.parameter(first(words)?))?, value);
        Ok((Arc::new(Self::new(self.frame.clone(), section, self.options)), old))
    }
}

impl<const N: usize, const B: usize> ElementLoads for TimoshenkoBeam<N, B> {
    /// Load sums: local end forces of the clamped beam.
    fn load_len(&self) -> usize {
        N
    }
    fn add_load(&self, load: &ElementLoad, factor: f64, sums: &mut [f64]) -> ElementResult {
        load.refuse_moment(self.class().name)?;
        let length = self.frame.length;
        let (y, z, (axial, axial_j)) = load.end_actions(length);
        let mut q = [0.0; B];
        let mut p0: Reactions = [-axial, 0.0, 0.0, 0.0, 0.0];
        q[0] = -axial_j;
        // A load along z bends about y, with the opposite sign.
        let planes = [(&y, &self.bending[0], 1, 1.0), (&z, &self.bending[1], 3, -1.0)];
        for (actions, bending, at, sign) in planes.into_iter().take(B / 3) {
            let (i, j) = bending.end_moments(actions, length);
            q[at] = sign * i;
            q[at + 1] = sign * j;
            p0[at] = -actions.shear.0;
            p0[at + 1] = -actions.shear.1;
        }
        let mut local = [0.0; N];
        self.frame.local_force(&q, &p0, &mut local);
        axpy(factor, &local, sums);
        Ok(())
    }
}
