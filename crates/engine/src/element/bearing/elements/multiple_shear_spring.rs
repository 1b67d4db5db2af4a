//! Shear springs between two nodes: `multipleShearSpring`.

use crate::element::bearing::elements::shear_bearing::end_masses;
use crate::element::bearing::kinematics::link::Link;
use crate::element::bearing::kinematics::responses::{NAMES, Response};
use crate::element::bearing::laws::shear_springs::{Bundle, Factors, ShearSprings};
use crate::element::{
    BasicRow, Element, ElementError, ElementInput, ElementOutput, ElementTraits, Mass, OpenSeesTraits, Snapshot,
    frame_force_labels,
};
use crate::probe::Probe;
use crate::state_struct;
use crate::state_struct::StateStruct;

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
pub struct MultipleShearSpring {
    springs: ShearSprings,
    link: Link<12, 6>,
    mass: f64,
    initial: [[f64; 2]; 2],
    /// OpenSees' stiffness: multiplied by a factor of its own instead of the derivative of the force.
    compat: bool,
}

impl MultipleShearSpring {
    /// Number of state variables before those of the springs.
    pub const HEADER: usize = Forces::LEN;

    /// Makes the element of springs with state variables from [`Self::HEADER`] on, and the kinematics.
    ///
    /// # Errors
    /// Springs without a force at their limit.
    pub fn new(springs: ShearSprings, link: Link<12, 6>, mass: f64, compat: bool) -> Result<Self, ElementError> {
        let mut state = vec![0.0; Self::HEADER + springs.state_len()];
        springs.init(&mut state);
        let factors = springs.factors(0.0, &state.clone(), &mut state)?;
        let scale = if compat { factors.stiffness } else { factors.force };
        let initial = springs.initial_stiffness().map(|row| row.map(|k| scale * k));
        Ok(Self { springs, link, mass, initial, compat })
    }

    /// Stiffness of the bundle with its factors, at a displacement `u` of length `size`.
    fn stiffness(&self, bundle: &Bundle, factors: &Factors, u: [f64; 2], size: f64) -> [[f64; 2]; 2] {
        let scale = if self.compat { factors.stiffness } else { factors.force };
        let mut k = bundle.stiffness.map(|row| row.map(|k| scale * k));
        if !self.compat && factors.slope != 0.0 {
            for (row, f) in k.iter_mut().zip(bundle.force) {
                for (k, u) in row.iter_mut().zip(u) {
                    *k += f * factors.slope * u / size;
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

impl Element for MultipleShearSpring {
    fn class(&self) -> &'static str {
        "MultipleShearSpring"
    }
    fn dofs(&self) -> usize {
        12
    }
    fn state_len(&self) -> usize {
        Self::HEADER + self.springs.state_len()
    }
    fn init(&self, state: &mut [f64]) {
        Forces::default().write(state);
        self.springs.init(state);
    }
    fn traits(&self) -> ElementTraits {
        let any = |is: fn(&crate::material::Material) -> bool| self.springs.materials().any(is);
        ElementTraits {
            linear: false,
            symmetric: self.compat || !self.springs.is_limited(),
            viscous: any(|m| m.is_viscous()),
            elapses: any(|m| m.depends_on_time()),
            rayleigh: true,
        }
    }

    fn respond(
        &self,
        motion: &ElementInput<'_>,
        committed: &[f64],
        trial: &mut [f64],
        answer: ElementOutput<'_>,
    ) -> Result<(), ElementError> {
        let [u, rate] = [motion.disp, motion.vel].map(|x| {
            let basic = self.link.deformation(x);
            [basic[1], basic[2]]
        });
        let size = u[0].hypot(u[1]);
        let bundle = self.springs.respond(committed, u, rate, motion.dt, trial)?;
        let factors = self.springs.factors(size, committed, trial)?;
        let force = bundle.force.map(|f| factors.force * f);
        Forces { force }.write(trial);
        self.link.add_basic_force(&basic(force), answer.force);
        if let Some(tangent) = answer.tangent {
            self.link.add_basic(&spread(self.stiffness(&bundle, &factors, u, size)), tangent);
        }
        if let Some(c) = answer.damping {
            self.link.add_basic(&spread(bundle.damping.map(|row| row.map(|c| factors.force * c))), c);
        }
        Ok(())
    }

    fn initial_tangent(&self, tangent: &mut [f64]) {
        self.link.add_basic(&spread(self.initial), tangent);
    }
    fn mass(&self) -> Mass {
        end_masses(self.mass, 6, 3)
    }
    fn opensees(&self) -> OpenSeesTraits<'_> {
        let ground_inertia = (self.mass != 0.0).then_some(1.0);
        OpenSeesTraits { keeps_first_damping: true, ground_inertia, ..OpenSeesTraits::default() }
    }
    fn basic_rows(&self) -> Vec<BasicRow> {
        self.link.basic_rows()
    }
    fn probe(&self, words: &[&str]) -> Option<Probe> {
        Response::probe(words)
    }
    fn probe_names(&self) -> &'static [&'static str] {
        NAMES
    }
    fn force_labels(&self) -> Vec<String> {
        frame_force_labels(12)
    }
    fn read(&self, path: &[u32], s: &Snapshot<'_>, out: &mut [f64]) {
        let forces = |out: &mut [f64]| out.copy_from_slice(&basic(Forces::read(s.state).force));
        Response::of(path).read(&self.link, s, out, forces);
    }
}
