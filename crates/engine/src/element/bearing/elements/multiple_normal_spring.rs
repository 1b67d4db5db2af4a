//! Normal springs between two nodes: `multipleNormalSpring`.

use crate::element::bearing::elements::shear_bearing::end_masses;
use crate::element::bearing::kinematics::link::Link;
use crate::element::bearing::kinematics::responses::{NAMES, Response};
use crate::element::bearing::laws::normal_springs::{NormalSprings, Section};
use crate::element::roles::{BasicDeformations, ForceLabels, Inertia, Roles};
use crate::element::{
    BasicRow, CallDependent, Class, Element, ElementInput, ElementOutput, ElementResult, ElementTraits, Histories,
    Mass, MatrixMask, OpenSeesTraits, SharedState, Snapshot,
};
use crate::probe::Probe;
use crate::state_struct;
use crate::state_struct::StateStruct;

state_struct! {
    /// Recorded section forces.
    struct Forces {
        /// Axial force, moment about y, moment about z.
        force: [f64; 3],
        /// Stiffness of the section.
        stiffness: [[f64; 3]; 3],
    }
}

/// Springs along the line between two nodes, distributed over a section: axial force and bending, no shear or torsion.
#[derive(Clone, Debug)]
pub struct MultipleNormalSpring {
    springs: NormalSprings,
    link: Link<12, 6>,
    mass: f64,
    /// OpenSees' scheme, in which springs may depend on every call.
    counts_calls: bool,
}

/// Basic directions of the section: axial, about y, about z.
const DIRECTIONS: [usize; 3] = [0, 4, 5];

impl MultipleNormalSpring {
    /// Number of state variables before those of the springs.
    pub const HEADER: usize = Forces::LEN;

    /// Makes the element of springs with state variables from [`Self::HEADER`] on, and the kinematics. `compat` follows
    /// OpenSees, which commits only n of its n x n springs.
    pub fn new(springs: NormalSprings, link: Link<12, 6>, mass: f64, compat: bool) -> Self {
        let n = springs.len().isqrt();
        let springs = if compat { springs.committing_first(n) } else { springs };
        let counts_calls = compat && !springs.material().is_linear();
        Self { springs, link, mass, counts_calls }
    }

    fn stiffness(section: [[f64; 3]; 3]) -> [[f64; 6]; 6] {
        let mut k = [[0.0; 6]; 6];
        for (row, i) in section.iter().zip(DIRECTIONS) {
            for (value, j) in row.iter().zip(DIRECTIONS) {
                k[i][j] = *value;
            }
        }
        k
    }

    fn spread(force: [f64; 3]) -> [f64; 6] {
        let mut q = [0.0; 6];
        DIRECTIONS.iter().zip(force).for_each(|(&i, f)| q[i] = f);
        q
    }
}

crate::watches_columns!(MultipleNormalSpring => |s| in [&s.springs]);

impl Element for MultipleNormalSpring {
    fn class(&self) -> Class {
        Class::new("MultipleNormalSpring", 159)
    }
    fn dofs(&self) -> usize {
        12
    }
    fn state_len(&self) -> usize {
        Self::HEADER + self.springs.state_len()
    }
    fn init(&self, state: &mut [f64]) {
        Forces { force: [0.0; 3], stiffness: self.springs.initial_stiffness() }.write(state);
        self.springs.init(state);
    }
    fn traits(&self) -> ElementTraits {
        let material = self.springs.material();
        ElementTraits {
            linear: material.is_linear(),
            symmetric: true,
            viscous: material.is_viscous(),
            elapses: material.depends_on_time(),
            rayleigh: true,
        }
    }

    fn respond(&self, motion: &ElementInput<'_>, h: &mut Histories<'_>, output: ElementOutput<'_>) -> ElementResult {
        let [u, rate] = [motion.disp, motion.vel].map(|x| {
            let basic = self.link.deformation(x);
            DIRECTIONS.map(|i| basic[i])
        });
        let Section { force, stiffness, damping } = self.springs.respond(h, u, rate, motion.dt)?;
        Forces { force, stiffness }.write(h.trial);
        self.link.add_basic_force(&Self::spread(force), output.force);
        if let Some(tangent) = output.tangent {
            self.link.add_basic(&Self::stiffness(stiffness), tangent);
        }
        if let Some(c) = output.damping {
            self.link.add_basic(&Self::stiffness(damping), c);
        }
        Ok(())
    }

    fn initial_tangent(&self, tangent: &mut [f64]) {
        self.link.add_basic(&Self::stiffness(self.springs.initial_stiffness()), tangent);
    }
    fn roles(&self) -> Roles<'_> {
        Roles {
            mass: Some(self),
            basic_rows: Some(self),
            opensees: OpenSeesTraits {
                calls: self.counts_calls.then_some(self as &dyn CallDependent),
                keeps_first_damping: true,
                ..OpenSeesTraits::of_mass(self.mass != 0.0)
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
        let basic = |out: &mut [f64]| out.copy_from_slice(&Self::spread(Forces::read(s.state).force));
        Response::of(path).read(&self.link, s, out, basic);
    }
}

impl Inertia for MultipleNormalSpring {
    fn mass(&self) -> Mass {
        end_masses(self.mass, 6, 3)
    }
}

impl BasicDeformations for MultipleNormalSpring {
    fn basic_rows(&self) -> Vec<BasicRow> {
        self.link.basic_rows()
    }
}

impl CallDependent for MultipleNormalSpring {
    fn last_tangent(&self, history: &[f64], _: &SharedState, tangent: &mut [f64], part: MatrixMask) {
        self.link.add_basic_part(&Self::stiffness(Forces::read(history).stiffness), tangent, part);
    }
}
