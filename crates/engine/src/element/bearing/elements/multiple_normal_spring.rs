//! Normal springs between two nodes: `multipleNormalSpring`.

use crate::element::bearing::elements::shear_bearing::end_masses;
use crate::element::bearing::kinematics::link::Link;
use crate::element::bearing::kinematics::responses::{NAMES, Response};
use crate::element::bearing::laws::normal_springs::{NormalSprings, Section};
use crate::element::{
    BasicRow, Element, ElementError, ElementInput, ElementOutput, ElementTraits, Mass, MatrixMask, Snapshot,
    frame_force_labels,
};
use crate::probe::Probe;
use crate::state_struct;
use crate::state_struct::StateStruct;

state_struct! {
    /// What recorders read.
    struct Forces {
        /// Axial force and moments about y and z.
        force: [f64; 3],
        /// Stiffness of the section.
        stiffness: [[f64; 3]; 3],
    }
}

/// Springs along the line between two nodes, spread over a section: axial force and bending, no shear and no torsion.
#[derive(Clone, Debug)]
pub struct MultipleNormalSpring {
    springs: NormalSprings,
    link: Link<12, 6>,
    mass: f64,
    /// OpenSees is followed, whose springs may go on with every call.
    counts_calls: bool,
}

/// Basic directions of the section: axial, about y, about z.
const DIRECTIONS: [usize; 3] = [0, 4, 5];

impl MultipleNormalSpring {
    /// State variables of state before those of the springs.
    pub const HEADER: usize = Forces::LEN;

    /// From springs whose histories begin at word [`Self::HEADER`], and the kinematics. `compat` follows OpenSees, which
    /// commits only n of its n x n springs.
    pub fn new(springs: NormalSprings, link: Link<12, 6>, mass: f64, compat: bool) -> Self {
        let n = springs.len().isqrt();
        let springs = if compat { springs.remembering(n) } else { springs };
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

impl Element for MultipleNormalSpring {
    fn class(&self) -> &'static str {
        "MultipleNormalSpring"
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

    fn respond(
        &self,
        motion: &ElementInput<'_>,
        committed: &[f64],
        trial: &mut [f64],
        answer: ElementOutput<'_>,
    ) -> Result<(), ElementError> {
        let [u, rate] = [motion.disp, motion.vel].map(|x| {
            let basic = self.link.deformation(x);
            DIRECTIONS.map(|i| basic[i])
        });
        let Section { force, stiffness, damping } = self.springs.respond(committed, u, rate, motion.dt, trial)?;
        Forces { force, stiffness }.write(trial);
        self.link.add_basic_force(&Self::spread(force), answer.force);
        if let Some(tangent) = answer.tangent {
            self.link.add_basic(&Self::stiffness(stiffness), tangent);
        }
        if let Some(c) = answer.damping {
            self.link.add_basic(&Self::stiffness(damping), c);
        }
        Ok(())
    }

    fn counts_calls(&self) -> bool {
        self.counts_calls
    }
    fn last_tangent(&self, history: &[f64], tangent: &mut [f64], part: MatrixMask) {
        self.link.add_basic_part(&Self::stiffness(Forces::read(history).stiffness), tangent, part);
    }
    fn initial_tangent(&self, tangent: &mut [f64]) {
        self.link.add_basic(&Self::stiffness(self.springs.initial_stiffness()), tangent);
    }
    fn mass(&self) -> Mass {
        end_masses(self.mass, 6, 3)
    }
    fn renews_damping(&self) -> bool {
        false
    }
    fn ground_inertia_slip(&self) -> Option<f64> {
        (self.mass != 0.0).then_some(1.0)
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
        let basic = |out: &mut [f64]| out.copy_from_slice(&Self::spread(Forces::read(s.state).force));
        Response::of(path).read(&self.link, s, out, basic);
    }
}
