//! Shear springs between two nodes: `multipleShearSpring`.

mod opensees;

use crate::element::bearing::elements::shear_bearing::end_masses;
use crate::element::bearing::kinematics::link::Link;
use crate::element::bearing::kinematics::responses::{NAMES, Response};
use crate::element::bearing::laws::shear_springs::{Bundle, Factors, ShearSprings};
use crate::element::roles::{BasicDeformations, Bearing, ForceLabels, Inertia, Roles};
use crate::element::{
    BasicRow, Class, Element, ElementInput, ElementOutput, ElementResult, ElementTraits, Histories, Mass,
    OpenSeesTraits, Snapshot,
};
use crate::probe::Probe;
use crate::rules::{Consistent, OpenSees};
use crate::state_struct;
use crate::state_struct::StateStruct;
use std::fmt;
use std::marker::PhantomData;

state_struct! {
    /// Recorded shear forces.
    struct Forces {
        /// Shear along y and z.
        force: [f64; 2],
    }
}

/// Shear springs in all directions normal to the line between two nodes, at its middle. There is no axial force,
/// torsion or bending (Wada and Hirose, 1989).
#[derive(Clone, Debug)]
pub struct MultipleShearSpring<R = Consistent> {
    springs: ShearSprings,
    link: Link<12, 6>,
    mass: f64,
    initial: [[f64; 2]; 2],
    rules: PhantomData<R>,
}

/// Rules of [`MultipleShearSpring`] that differ in OpenSees.
pub trait Rules: Clone + fmt::Debug + Send + Sync + 'static {
    /// Factor of the stiffness.
    fn scale(factors: &Factors) -> f64 {
        factors.force
    }

    /// Derivative of the factor of the forces by the size of the displacement, which the stiffness follows.
    fn slope(factors: &Factors) -> f64 {
        factors.slope
    }

    /// The tangent is symmetric; springs may have a limit.
    fn symmetric(limited: bool) -> bool {
        !limited
    }
}

impl Rules for Consistent {}

impl MultipleShearSpring {
    /// Number of state variables before those of the springs.
    pub const HEADER: usize = Forces::LEN;

    /// Makes the element of springs with state variables from [`Self::HEADER`] on, and the kinematics.
    ///
    /// # Errors
    /// Springs without a force at their limit.
    pub fn new(springs: ShearSprings, link: Link<12, 6>, mass: f64) -> ElementResult<Self> {
        Self::of(springs, link, mass)
    }
}

impl MultipleShearSpring<OpenSees> {
    /// As `new`, by the rules of OpenSees.
    ///
    /// # Errors
    /// Springs without a force at their limit.
    pub fn as_opensees(springs: ShearSprings, link: Link<12, 6>, mass: f64) -> ElementResult<Self> {
        Self::of(springs, link, mass)
    }
}

impl<R: Rules> MultipleShearSpring<R> {
    fn of(springs: ShearSprings, link: Link<12, 6>, mass: f64) -> ElementResult<Self> {
        let mut state = vec![0.0; MultipleShearSpring::HEADER + springs.state_len()];
        springs.init(&mut state);
        let factors = springs.factors(0.0, &mut Histories { committed: &state.clone(), trial: &mut state })?;
        let scale = R::scale(&factors);
        let initial = springs.initial_stiffness().map(|row| row.map(|k| scale * k));
        Ok(Self { springs, link, mass, initial, rules: PhantomData })
    }

    /// Stiffness of the bundle with its factors, at a displacement `u` of length `size`.
    fn stiffness(&self, bundle: &Bundle, factors: &Factors, u: [f64; 2], size: f64) -> [[f64; 2]; 2] {
        let (scale, slope) = (R::scale(factors), R::slope(factors));
        let mut k = bundle.stiffness.map(|row| row.map(|k| scale * k));
        if slope != 0.0 {
            for (row, f) in k.iter_mut().zip(bundle.force) {
                for (k, u) in row.iter_mut().zip(u) {
                    *k += f * slope * u / size;
                }
            }
        }
        k
    }
}

/// Stiffness in all basic directions from that of the two shears.
fn spread(shear: [[f64; 2]; 2]) -> [[f64; 6]; 6] {
    let mut k = [[0.0; 6]; 6];
    for (row, shear) in k[1..3].iter_mut().zip(shear) {
        row[1..3].copy_from_slice(&shear);
    }
    k
}

/// Basic forces from the two shears.
fn basic([y, z]: [f64; 2]) -> [f64; 6] {
    [0.0, y, z, 0.0, 0.0, 0.0]
}

crate::watches_columns!([R: Rules] MultipleShearSpring<R> => |s| in [&s.springs]);

impl<R: Rules> Element for MultipleShearSpring<R> {
    fn class(&self) -> Class {
        Class::new("MultipleShearSpring", 158)
    }
    fn dofs(&self) -> usize {
        12
    }
    fn state_len(&self) -> usize {
        MultipleShearSpring::HEADER + self.springs.state_len()
    }
    fn init(&self, state: &mut [f64]) {
        Forces::default().write(state);
        self.springs.init(state);
    }
    fn traits(&self) -> ElementTraits {
        let any = |is: fn(&crate::material::Material) -> bool| self.springs.materials().any(is);
        ElementTraits {
            linear: false,
            symmetric: R::symmetric(self.springs.is_limited()),
            viscous: any(|m| m.is_viscous()),
            elapses: any(|m| m.depends_on_time()),
            rayleigh: true,
        }
    }

    fn respond(&self, motion: &ElementInput<'_>, h: &mut Histories<'_>, output: ElementOutput<'_>) -> ElementResult {
        let [u, rate] = [motion.disp, motion.vel].map(|x| {
            let basic = self.link.deformation(x);
            [basic[1], basic[2]]
        });
        let size = u[0].hypot(u[1]);
        let bundle = self.springs.respond(h, u, rate, motion.dt)?;
        let factors = self.springs.factors(size, h)?;
        let force = bundle.force.map(|f| factors.force * f);
        Forces { force }.write(h.trial);
        self.link.add_basic_force(&basic(force), output.force);
        if let Some(tangent) = output.tangent {
            self.link.add_basic(&spread(self.stiffness(&bundle, &factors, u, size)), tangent);
        }
        if let Some(c) = output.damping {
            self.link.add_basic(&spread(bundle.damping.map(|row| row.map(|c| factors.force * c))), c);
        }
        Ok(())
    }

    fn initial_tangent(&self, tangent: &mut [f64]) {
        self.link.add_basic(&spread(self.initial), tangent);
    }
    fn roles(&self) -> Roles<'_> {
        Roles {
            bearing: Some(Bearing::Rubber),
            mass: Some(self),
            basic_rows: Some(self),
            opensees: OpenSeesTraits { keeps_first_damping: true, ..OpenSeesTraits::of_mass(self.mass != 0.0) },
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
        let forces = |out: &mut [f64]| out.copy_from_slice(&basic(Forces::read(s.state).force));
        Response::of(path).read(&self.link, s, out, forces);
    }
}

impl<R: Rules> Inertia for MultipleShearSpring<R> {
    fn mass(&self) -> Mass {
        end_masses(self.mass, 6, 3)
    }
}

impl<R: Rules> BasicDeformations for MultipleShearSpring<R> {
    fn basic_rows(&self) -> Vec<BasicRow> {
        self.link.basic_rows()
    }
}
