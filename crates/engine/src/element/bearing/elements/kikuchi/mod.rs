//! Kikuchi's bearing: shear springs at mid-height between two sections of normal springs, with P-Delta and tilt.
//!
//! Kikuchi, Nakamura and Aiken (2010), "Three-dimensional analysis for square seismic isolation bearings under large
//! shear deformations and high axial loads", Earthquake Engineering and Structural Dynamics 39, 1513-1531; as
//! OpenSees' `KikuchiBearing` by K. Ishii. Two rigid links of half the height each carry the shear springs in their
//! midst; at their outer ends stand the sections, each as long as half of the rubber. The axial force runs along the
//! tilted links: so the bearing softens with the shear displacement, and buckles.

mod condensation;
mod equilibrium;
mod kinematics;
mod opensees;

use self::condensation::{Condensed, Inner};
use self::equilibrium::{HEADER, Memory};
use self::kinematics::{Geometry, Kinematics, OUTER, Springs, Stiff};
use self::opensees::HEADER as OPENSEES_HEADER;
use crate::element::bearing::elements::shear_bearing::end_masses;
use crate::element::bearing::kinematics::link::Link;
use crate::element::bearing::kinematics::responses::{NAMES, Response};
use crate::element::bearing::laws::normal_layout::{Layout, Shape};
use crate::element::bearing::laws::normal_springs::NormalSprings;
use crate::element::bearing::laws::shear_springs::{Factors, ShearSprings};
use crate::element::roles::{BasicDeformations, Bearing, CriticalLoad, ForceLabels, Inertia, Roles};
use crate::element::{
    BasicRow, CallDependent, Class, Element, ElementInput, ElementOutput, ElementResult, ElementTraits, Histories,
    Mass, OpenSeesTraits, Overload, Rows, Snapshot,
};
use crate::material::{Material, MaterialError, WatchesColumns};
use crate::numeric::SparseMatrix;
use crate::probe::Probe;
use crate::state_struct::StateStruct;
use nalgebra::Matrix3;
use std::f64::consts::PI;

/// Parameters of a [`KikuchiBearing`].
#[derive(Clone, Debug)]
pub struct KikuchiParameters {
    /// Outline of the section.
    pub shape: Shape,
    /// Its diameter or edge.
    pub size: f64,
    /// Total thickness of the rubber.
    pub rubber: f64,
    /// Height of the bearing, end plates included.
    pub height: f64,
    /// Material of the shear springs: force over displacement.
    pub shear: Material,
    /// Number of shear springs.
    pub shear_springs: usize,
    /// Displacement from which on the forces of the shear springs are scaled to those of a single one; `None` for no
    /// scaling.
    pub limit: Option<f64>,
    /// Material of the normal springs: stress over strain.
    pub normal: Material,
    /// Normal springs of each section.
    pub layout: Layout,
    /// The links tilt with the inner nodes.
    pub tilt: bool,
    /// The axial force has moments about the displaced mid-height.
    pub p_delta: bool,
    /// Shares of the P-Delta moment that are taken off the moments at i and at j.
    pub shares: [f64; 2],
    /// Mass, half at each end.
    pub mass: f64,
}

/// Scheme for the equilibrium of the inner nodes.
#[derive(Clone, Debug)]
pub enum Scheme {
    /// To round-off at every trial state.
    Converged,
    /// As in OpenSees: one Newton step from the springs of the last trial state.
    OpenSees(Balance),
}

/// OpenSees' `-doBalance`: correction of the inner nodes when a step is committed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Balance {
    /// Largest force that may be left at the inner nodes.
    pub tolerance: f64,
    /// Largest number of corrections; 0 for none.
    pub rounds: u32,
}

/// Kikuchi's bearing between two nodes in space.
#[derive(Clone, Debug)]
pub struct KikuchiBearing {
    shear: ShearSprings,
    lower: NormalSprings,
    upper: NormalSprings,
    kinematics: Kinematics,
    /// Moments over this length count as forces, where forces and moments are compared.
    arm: f64,
    /// E A, where forces are compared with none.
    axial_rigidity: f64,
    /// Shares of the P-Delta moment that are taken off the end moments; `None` without P-Delta.
    shares: Option<[f64; 2]>,
    link: Link<12, 6>,
    /// Local displacements of the ends from global ones, row by row.
    turn: SparseMatrix<OUTER, OUTER>,
    /// Rows in local axes that each row in global ones is made of.
    locals: [Rows; OUTER],
    /// Displacements of the ends in local axes at which the springs are at rest.
    start: [f64; OUTER],
    mass: f64,
    /// Factors of the virgin shear springs at rest.
    virgin_factors: Factors,
    /// Virgin stiffness of a section at each inner node.
    hold: Inner,
    scheme: Scheme,
}

/// Stiffness of the springs that stand for rigid joints at mid-height, over that of the section.
const RIGID: f64 = 1e4;

impl KikuchiBearing {
    /// Bundles of springs.
    fn bundles(&self) -> [&dyn WatchesColumns; 3] {
        [&self.shear, &self.lower, &self.upper]
    }

    /// With local axes as rows, from the displacements that the nodes (global, i then j) have already.
    ///
    /// # Errors
    /// Shear springs that cannot be scaled.
    pub fn new(p: KikuchiParameters, axes: &Matrix3<f64>, disp: &[f64], scheme: Scheme) -> ElementResult<Self> {
        let (area, inertia) = match p.shape {
            Shape::Round => (PI * p.size.powi(2) / 4.0, PI * p.size.powi(4) / 64.0),
            Shape::Square => (p.size.powi(2), p.size.powi(4) / 12.0),
        };
        let (e, k) = (p.normal.initial_tangent(), p.shear.initial_tangent());
        let stiff = Stiff {
            axial: RIGID * e * area / p.rubber,
            bending: RIGID * e * inertia / p.rubber,
            torsion: RIGID * k * 2.0 * inertia / p.rubber,
        };
        let (header, geometry) = match &scheme {
            Scheme::Converged => (HEADER, Geometry::MeanTilt),
            Scheme::OpenSees(_) => (OPENSEES_HEADER, Geometry::EachLink),
        };
        let shear = ShearSprings::new(p.shear, p.shear_springs, p.limit, header);
        let at = header + shear.state_len();
        let mut virgin = vec![0.0; at];
        shear.init(&mut virgin);
        let virgin_factors = shear.factors(0.0, &mut Histories { committed: &virgin.clone(), trial: &mut virgin })?;
        let mut lower = NormalSprings::new(p.normal, &p.layout, 0.5 * p.rubber, at);
        if matches!(scheme, Scheme::OpenSees(_)) {
            lower = lower.counting_calls();
        }
        let upper = lower.clone().at(at + lower.state_len());
        let section = lower.initial_stiffness();
        let hold = std::array::from_fn(|i| section[i % 3][i % 3].abs());
        // The basic deformations are plain differences.
        let link = Link::new(axes, 0.0, 0.5);
        let mut start = [0.0; OUTER];
        link.local_force(disp, &mut start);
        Ok(Self {
            shear,
            lower,
            upper,
            kinematics: Kinematics::new(0.5 * p.height, stiff, p.tilt, p.p_delta, geometry),
            arm: 0.25 * p.size,
            axial_rigidity: e.abs() * area,
            shares: p.p_delta.then_some(p.shares),
            turn: SparseMatrix::new(&link.local),
            locals: std::array::from_fn(|global| Rows::of((0..OUTER).map(|i| link.local[i][global] != 0.0))),
            link,
            start,
            mass: p.mass,
            virgin_factors,
            hold,
            scheme,
        })
    }

    /// Number of state variables before those of the springs.
    fn header(&self) -> usize {
        match self.scheme {
            Scheme::Converged => HEADER,
            Scheme::OpenSees(_) => OPENSEES_HEADER,
        }
    }

    /// Displacements of the ends in local axes, from where the springs are at rest.
    fn outer(&self, disp: &[f64]) -> [f64; OUTER] {
        let local = self.turn.times(disp);
        std::array::from_fn(|i| local[i] - self.start[i])
    }

    /// Displacement of j over i, in shear.
    fn offset(&self, outer: &[f64; OUTER]) -> [f64; 2] {
        [1, 2].map(|k| outer[k + 6] - outer[k] + self.start[k + 6] - self.start[k])
    }

    /// Forces and stiffnesses of all springs but the axial one at mid-height, at displacements, into `springs`.
    fn evaluate_springs(
        &self,
        h: &mut Histories<'_>,
        q: &kinematics::Motion,
        factors: Factors,
        dt: f64,
        springs: &mut Springs,
    ) -> Result<(), MaterialError> {
        const REST: [f64; 3] = [0.0; 3];
        let (lower, upper, shear) = self.kinematics.deformations(q);
        let lower = self.lower.respond(h, lower, REST, dt)?;
        (springs.lower, springs.lower_stiffness) = (lower.force, flat(&lower.stiffness));
        let upper = self.upper.respond(h, upper, REST, dt)?;
        (springs.upper, springs.upper_stiffness) = (upper.force, flat(&upper.stiffness));
        let shear = self.shear.respond(h, shear, [0.0; 2], dt)?;
        springs.shear = shear.force.map(|f| f * factors.force);
        springs.shear_stiffness = flat(&shear.stiffness).map(|k| k * factors.stiffness);
        Ok(())
    }

    /// The same with the axial deformation at mid-height.
    fn springs(
        &self,
        h: &mut Histories<'_>,
        q: &kinematics::Motion,
        factors: Factors,
        axial: f64,
        dt: f64,
    ) -> Result<Springs, MaterialError> {
        let mut springs = Springs { axial, ..Springs::default() };
        self.evaluate_springs(h, q, factors, dt, &mut springs)?;
        Ok(springs)
    }

    /// Virgin springs at rest; the stiffness of the shear springs times a factor.
    fn virgin_springs(&self, factor: f64) -> Springs {
        let section = flat(&self.lower.initial_stiffness());
        Springs {
            lower_stiffness: section,
            upper_stiffness: section,
            shear_stiffness: flat(&self.shear.initial_stiffness()).map(|k| k * factor),
            ..Springs::default()
        }
    }

    /// Critical load of the virgin bearing without shear, P² + P P_s - P_s P_e = 0 with P_s = K H and P_e = 2 K_θ / H
    /// (Koh and Kelly, 1988): that of its own springs. None without P-Delta.
    fn critical_load(&self) -> Option<f64> {
        let height = 2.0 * self.kinematics.half;
        let bending = self.hold[1].min(self.hold[2]);
        let shear = self.virgin_factors.force * self.shear.initial_stiffness()[0][0] * height;
        let euler = 2.0 * bending / height;
        self.shares.map(|_| 0.5 * (-shear + (shear * shear + 4.0 * shear * euler).sqrt()))
    }

    /// Add a local stiffness by rows to a global one, of which these rows are wanted.
    fn add_global(&self, local: &[[f64; OUTER]; OUTER], global: &mut [f64], rows: Rows) {
        for (i, k) in local.iter().enumerate() {
            let wanted = || self.turn.row(i).iter().filter(|e| rows.has(e.column));
            if wanted().next().is_none() {
                continue;
            }
            let mut turned = [0.0; OUTER];
            self.turn.add_transposed(k, &mut turned);
            for e in wanted() {
                let to = &mut global[e.column * OUTER..(e.column + 1) * OUTER];
                to.iter_mut().zip(&turned).for_each(|(k, turned)| *k += e.value * turned);
            }
        }
    }

    /// Rows in local axes that rows in global ones are made of.
    fn local_rows(&self, rows: Rows) -> Rows {
        rows.among(OUTER).fold(Rows::NONE, |all, i| all.or(self.locals[i]))
    }

    /// Global forces of local ones.
    fn add_force(&self, local: &[f64; OUTER], global: &mut [f64]) {
        self.turn.add_transposed(local, global);
    }
}

/// A square matrix by rows.
fn flat<const N: usize, const M: usize>(m: &[[f64; N]; N]) -> [f64; M] {
    std::array::from_fn(|k| m[k / N][k % N])
}

crate::watches_columns!(KikuchiBearing => |s| in s.bundles());

impl Element for KikuchiBearing {
    fn class(&self) -> Class {
        Class::new("KikuchiBearing", 160)
    }
    fn dofs(&self) -> usize {
        OUTER
    }
    fn state_len(&self) -> usize {
        self.header() + self.shear.state_len() + 2 * self.lower.state_len()
    }
    fn init(&self, state: &mut [f64]) {
        match self.scheme {
            Scheme::Converged => self.write_virgin_memory(state),
            Scheme::OpenSees(_) => self.write_virgin_trace(state),
        }
        self.shear.init(state);
        self.lower.init(state);
        self.upper.init(state);
    }
    fn traits(&self) -> ElementTraits {
        // OpenSees gives the springs no rates, so that viscous materials have no force.
        let mut materials = self.shear.materials().chain([self.lower.material()]);
        ElementTraits {
            linear: false,
            symmetric: false,
            viscous: false,
            elapses: materials.any(|m| m.depends_on_time()),
            rayleigh: true,
        }
    }

    fn respond(&self, motion: &ElementInput<'_>, h: &mut Histories<'_>, answer: ElementOutput<'_>) -> ElementResult {
        let outer = self.outer(motion.disp);
        let mut local = Condensed::default();
        match &self.scheme {
            Scheme::Converged => {
                let rows = if answer.tangent.is_some() { self.local_rows(answer.part.rows) } else { Rows::NONE };
                self.converge(outer, h, motion.dt, rows, &mut local)?;
            }
            Scheme::OpenSees(balance) => {
                (local.force, local.stiffness) =
                    self.follow_opensees(outer, h, motion.dt, (*balance, motion.opensees))?;
            }
        }
        self.add_force(&local.force, answer.force);
        if let Some(k) = answer.tangent {
            self.add_global(&local.stiffness, k, answer.part.rows);
        }
        Ok(())
    }

    fn commit(&self, trial: &[f64], committed: &mut [f64]) {
        let header = self.header();
        committed[..header].copy_from_slice(&trial[..header]);
        self.shear.commit(trial, committed);
        self.lower.commit(trial, committed);
        self.upper.commit(trial, committed);
    }
    fn initial_tangent(&self, tangent: &mut [f64]) {
        self.add_global(&self.virgin_tangent(), tangent, Rows::ALL);
    }
    fn roles(&self) -> Roles<'_> {
        Roles {
            bearing: Some(Bearing::Rubber),
            mass: Some(self),
            basic_rows: Some(self),
            overload: Some(self),
            opensees: {
                let follows = matches!(self.scheme, Scheme::OpenSees(_));
                OpenSeesTraits {
                    calls: follows.then_some(self as &dyn CallDependent),
                    initial_is_current: follows,
                    keeps_first_damping: true,
                    ..OpenSeesTraits::of_mass(self.mass != 0.0)
                }
            },
            force_labels: ForceLabels::Frame,
            ..Roles::default()
        }
    }

    fn probe(&self, words: &[&str]) -> Option<Probe> {
        Response::probe(words)
    }
    fn probe_names(&self) -> Vec<&'static str> {
        NAMES.to_vec()
    }
    fn read(&self, path: &[u32], s: &Snapshot<'_>, out: &mut [f64]) {
        // Half of the difference of the end forces.
        let basic = |out: &mut [f64]| {
            let mut local = [0.0; OUTER];
            self.link.local_force(s.force, &mut local);
            out.iter_mut().enumerate().for_each(|(k, q)| *q = 0.5 * (local[k + 6] - local[k]));
        };
        Response::of(path).read(&self.link, s, out, basic);
    }
}

impl Inertia for KikuchiBearing {
    fn mass(&self) -> Mass {
        end_masses(self.mass, 6, 3)
    }
}

impl BasicDeformations for KikuchiBearing {
    fn basic_rows(&self) -> Vec<BasicRow> {
        self.link.basic_rows()
    }
}

impl CriticalLoad for KikuchiBearing {
    fn overload(&self, history: &[f64]) -> Option<Overload> {
        let axial = match self.scheme {
            Scheme::Converged => Memory::read(history).axial,
            Scheme::OpenSees(_) => opensees::axial_deformation(history),
        };
        let (load, critical) = (-self.kinematics.stiff.axial * axial, self.critical_load()?);
        (load > critical).then_some(Overload { load, critical })
    }
}
