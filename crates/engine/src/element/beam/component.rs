//! An elastic beam between two rotational springs: `componentElement2d`.

use super::elastic::{Bending, Release, add_clamped_load, consistent_mass, lumped_mass};
use crate::element::roles::{ElementLoads, ForceLabels, Inertia, Roles};
use crate::element::transform::{Reactions, Transform, axis_probe};
use crate::element::{
    Class, Element, ElementInput, ElementLoad, ElementOutput, ElementResult, ElementTraits, Histories, Mass, Snapshot,
};
use crate::material::{Slot, Strain};
use crate::probe::Probe;
use std::sync::Arc;

/// Properties of a component beam.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ComponentOptions {
    /// Axial rigidity E A, force.
    pub ea: f64,
    /// Flexural rigidity E I, force x length².
    pub ei: f64,
    /// Mass per length.
    pub rho: f64,
    /// Consistent mass in place of lumped mass.
    pub consistent: bool,
}

/// An elastic beam in the plane with a rotational spring between each node and the beam's end. The rotations of the
/// beam's ends are internal unknowns, from equilibrium of springs and beam. An end without a spring is a hinge.
#[derive(Clone, Debug)]
pub struct ComponentBeam {
    transform: Arc<dyn Transform<6, 3>>,
    options: ComponentOptions,
    springs: [Option<Slot>; 2],
    len: usize,
}

/// Number of state variables for the rotations of the beam's ends.
const INNER_ROTATIONS: usize = 2;
/// Largest number of iterations for the internal rotations.
const MAX_ITERATIONS: usize = 50;
/// Tolerance of a step of the internal rotations, as a part of the largest rotation: round-off.
const RELATIVE_TOLERANCE: f64 = 1e-15;

/// Signs of the spring deformations: the end of the beam less the node at i, the opposite at j.
const SIGN: [f64; 2] = [1.0, -1.0];

/// Response of the springs with the beam between them.
#[derive(Clone, Copy, Debug, Default)]
struct Ends {
    /// Moments at the nodes.
    moment: [f64; 2],
    stiffness: [[f64; 2]; 2],
}

impl ComponentBeam {
    /// Makes the beam from its geometry, its properties and the springs at i and j with their tags.
    pub fn new(
        transform: Arc<dyn Transform<6, 3>>,
        options: ComponentOptions,
        springs: [Option<(crate::material::Material, i32)>; 2],
    ) -> Self {
        let mut at = INNER_ROTATIONS;
        let springs = springs.map(|s| {
            s.map(|(material, tag)| {
                let slot = Slot::new(material, tag, at);
                at += slot.len();
                slot
            })
        });
        Self { transform, options, springs, len: at }
    }

    fn bending(&self) -> [Bending; 2] {
        [Bending { ei: self.options.ei, gav: None, release: Release::None }; 2]
    }

    /// 2 E I/L; the end moments of the beam are this times 2 θi + θj and θi + 2 θj.
    fn twice_ei_over_l(&self) -> f64 {
        2.0 * self.options.ei / self.transform.length()
    }

    /// Internal rotations that balance the moments `residual`, with spring stiffnesses `k`.
    fn balancing_rotations(&self, k: [f64; 2], residual: [f64; 2]) -> [f64; 2] {
        let beam = self.twice_ei_over_l();
        let (a, b) = (k[0] + 2.0 * beam, k[1] + 2.0 * beam);
        let determinant = a * b - beam * beam;
        [(b * residual[0] - beam * residual[1]) / determinant, (a * residual[1] - beam * residual[0]) / determinant]
    }

    /// Internal residual moments of the springs, the beam and the clamped-end moments of loads.
    fn residual(&self, spring: [f64; 2], inner: [f64; 2], clamped: [f64; 2]) -> [f64; 2] {
        let beam = self.twice_ei_over_l();
        [
            spring[0] + beam * (2.0 * inner[0] + inner[1]) + clamped[0],
            spring[1] + beam * (inner[0] + 2.0 * inner[1]) + clamped[1],
        ]
    }

    /// Condenses the internal rotations out of stiffnesses and moments of the springs. The residual moments go to the
    /// nodes.
    fn condense(&self, k: [f64; 2], spring: [f64; 2], residual: [f64; 2]) -> Ends {
        let inner = self.balancing_rotations(k, residual);
        let [of_i, of_j] = [self.balancing_rotations(k, [k[0], 0.0]), self.balancing_rotations(k, [0.0, k[1]])];
        Ends {
            moment: [0, 1].map(|i| k[i] * inner[i] - spring[i]),
            stiffness: [[k[0] * (1.0 - of_i[0]), -k[0] * of_j[0]], [-k[1] * of_i[1], k[1] * (1.0 - of_j[1])]],
        }
    }

    /// A value of each spring in a state; 0 without a spring.
    fn springs(&self, get: fn(&Slot, &[f64]) -> f64, state: &[f64]) -> [f64; 2] {
        self.springs.each_ref().map(|s| s.as_ref().map_or(0.0, |s| get(s, state)))
    }

    /// Moments of the springs in a state, positive as the rotations of the beam's ends.
    fn moments(&self, state: &[f64]) -> [f64; 2] {
        let stress = self.springs(Slot::stress, state);
        [0, 1].map(|i| SIGN[i] * stress[i])
    }

    /// Moments and stiffness at the nodes for their rotations and the clamped-end moments of loads.
    ///
    /// Newton's method for the internal rotations starts from a prediction with the committed stiffnesses. A step is
    /// halved while the residual grows.
    ///
    /// # Errors
    /// Errors of the materials.
    fn solve(&self, rotation: [f64; 2], clamped: [f64; 2], dt: f64, h: &mut Histories<'_>) -> ElementResult<Ends> {
        let start = [h.committed[0], h.committed[1]];
        let (k, strain) = (self.springs(Slot::tangent, h.committed), self.springs(Slot::strain, h.committed));
        let mut residual = self.residual(self.moments(h.committed), start, clamped);
        for i in [0, 1] {
            residual[i] -= k[i] * (rotation[i] - start[i] + SIGN[i] * strain[i]);
        }
        let step = self.balancing_rotations(k, residual);
        let (mut inner, mut step) = ([start[0] - step[0], start[1] - step[1]], step);
        let (mut ends, mut min_norm) = (Ends::default(), f64::INFINITY);
        let size = rotation[0].abs().max(rotation[1].abs()).max(start[0].abs()).max(start[1].abs());
        for _ in 0..MAX_ITERATIONS {
            for (i, spring) in self.springs.iter().enumerate() {
                if let Some(slot) = spring {
                    let value = SIGN[i] * (inner[i] - rotation[i]);
                    slot.update(h.committed, Strain { value, rate: 0.0, dt }, h.trial)?;
                }
            }
            h.trial[..INNER_ROTATIONS].copy_from_slice(&inner);
            let k = self.springs(Slot::tangent, h.trial);
            let spring = self.moments(h.trial);
            let residual = self.residual(spring, inner, clamped);
            ends = self.condense(k, spring, residual);
            let norm = residual[0].hypot(residual[1]);
            if norm > min_norm {
                step = step.map(|x| 0.5 * x);
                inner = [inner[0] + step[0], inner[1] + step[1]];
            } else {
                min_norm = norm;
                step = self.balancing_rotations(k, residual);
                inner = [inner[0] - step[0], inner[1] - step[1]];
            }
            if step[0].abs().max(step[1].abs()) <= RELATIVE_TOLERANCE * size {
                break;
            }
        }
        Ok(ends)
    }

    fn basic_stiffness(&self, ends: &Ends) -> [[f64; 3]; 3] {
        let [[ii, ij], [ji, jj]] = ends.stiffness;
        [[self.options.ea / self.transform.length(), 0.0, 0.0], [0.0, ii, ij], [0.0, ji, jj]]
    }

    /// Moments at the nodes and stiffness in a converged state.
    fn ends(&self, state: &[f64], load: &[f64]) -> Ends {
        let spring = self.moments(state);
        let residual = self.residual(spring, [state[0], state[1]], [load[1], load[2]]);
        self.condense(self.springs(Slot::tangent, state), spring, residual)
    }

    fn basic_force(&self, s: &Snapshot<'_>) -> [f64; 3] {
        let v = self.transform.deformation(s.disp, s.state);
        let m = self.ends(s.state, s.load).moment;
        [self.options.ea / self.transform.length() * v[0] + s.load[0], m[0], m[1]]
    }

    fn reactions(load: &[f64]) -> Reactions {
        std::array::from_fn(|i| load[3 + i])
    }
}

const LOCAL_FORCE: u32 = 3;
const BASIC_FORCE: u32 = 4;
const HINGES: u32 = 5;
const HINGE_TANGENTS: u32 = 6;
const DEFORMATION: u32 = 8;
const STIFFNESS: u32 = 19;

crate::watches_columns!(ComponentBeam => |s| in s.springs.iter().flatten());

impl Element for ComponentBeam {
    fn class(&self) -> Class {
        Class::new("ComponentElement2d", 195)
    }
    fn dofs(&self) -> usize {
        6
    }
    fn state_len(&self) -> usize {
        self.len
    }
    fn init(&self, state: &mut [f64]) {
        state[..INNER_ROTATIONS].fill(0.0);
        self.springs.iter().flatten().for_each(|s| s.init(state));
    }
    fn traits(&self) -> ElementTraits {
        ElementTraits {
            linear: self.transform.is_linear() && self.springs.iter().flatten().all(|s| s.material.is_linear()),
            symmetric: self.transform.is_symmetric(),
            viscous: false,
            elapses: self.springs.iter().flatten().any(|s| s.material.depends_on_time()),
            rayleigh: true,
        }
    }

    fn respond(&self, m: &ElementInput<'_>, h: &mut Histories<'_>, output: ElementOutput<'_>) -> ElementResult {
        self.transform.advance(m.disp, h)?;
        let v = self.transform.deformation(m.disp, h.trial);
        let ends = self.solve([v[1], v[2]], [m.load[1], m.load[2]], m.dt, h)?;
        let axial = self.options.ea / self.transform.length() * v[0] + m.load[0];
        let q = [axial, ends.moment[0], ends.moment[1]];
        self.transform.add_force(m.disp, h.trial, &q, &Self::reactions(m.load), output.force);
        if let Some(k) = output.tangent {
            self.transform.add_tangent(m.disp, h.trial, &self.basic_stiffness(&ends), &q, k);
        }
        Ok(())
    }

    fn initial_tangent(&self, tangent: &mut [f64]) {
        let k = self.springs.each_ref().map(|s| s.as_ref().map_or(0.0, |s| s.material.initial_tangent()));
        let kb = self.basic_stiffness(&self.condense(k, [0.0; 2], [0.0; 2]));
        self.transform.frame().add_basic_stiffness(&kb, tangent);
    }

    fn roles(&self) -> Roles<'_> {
        Roles { mass: Some(self), loads: Some(self), force_labels: ForceLabels::Frame, ..Roles::default() }
    }

    fn probe(&self, words: &[&str]) -> Option<Probe> {
        Some(match *words.first()? {
            "localForce" | "localForces" => Probe::new(LOCAL_FORCE, ["N_1", "V_1", "M_1", "N_2", "V_2", "M_2"]),
            "basicForce" | "basicForces" => Probe::new(BASIC_FORCE, ["N", "M_1", "M_2"]),
            "basicDeformation" => Probe::new(DEFORMATION, ["N", "M_1", "M_2"]),
            "basicStiffness" => Probe::new(STIFFNESS, (1..=9).map(|i| format!("k{i}"))),
            "hingeDefoAndForce" => Probe::new(HINGES, ["end1_Defo", "end1_Force", "end2_Defo", "end2_Force"]),
            "hingeTangent" => Probe::new(HINGE_TANGENTS, ["end1_Tangent", "end1_Tangent"]),
            word => return axis_probe(word),
        })
    }

    fn probe_names(&self) -> Vec<&'static str> {
        vec!["localForce", "basicForce", "basicDeformation", "basicStiffness", "hingeDefoAndForce", "hingeTangent"]
    }

    fn read(&self, path: &[u32], s: &Snapshot<'_>, out: &mut [f64]) {
        match path[0] {
            _ if self.transform.frame().read_axis(path, out) => {}
            LOCAL_FORCE => {
                self.transform.frame().local_force(&self.basic_force(s), &Self::reactions(s.load), out);
            }
            BASIC_FORCE => out.copy_from_slice(&self.basic_force(s)),
            DEFORMATION => out.copy_from_slice(&self.transform.deformation(s.disp, s.state)),
            STIFFNESS => {
                let kb = self.basic_stiffness(&self.ends(s.state, s.load));
                out.copy_from_slice(kb.as_flattened());
            }
            HINGES => {
                for (o, spring) in out.chunks_exact_mut(2).zip(&self.springs) {
                    let pair = spring.as_ref().map_or([0.0; 2], |h| [h.strain(s.state), h.stress(s.state)]);
                    o.copy_from_slice(&pair);
                }
            }
            _ => {
                for (o, spring) in out.iter_mut().zip(&self.springs) {
                    *o = spring.as_ref().map_or(0.0, |h| h.tangent(s.state));
                }
            }
        }
    }
}

impl Inertia for ComponentBeam {
    fn mass(&self) -> Mass {
        let (rho, length) = (self.options.rho, self.transform.length());
        if rho == 0.0 {
            Mass::None
        } else if self.options.consistent {
            Mass::Consistent(self.transform.frame().global_of_local(&consistent_mass::<6>(length, rho, 0.0)))
        } else {
            Mass::Lumped(lumped_mass::<6>(rho * length))
        }
    }
}

impl ElementLoads for ComponentBeam {
    fn load_len(&self) -> usize {
        3 + 5
    }
    fn add_load(&self, load: &ElementLoad, factor: f64, sums: &mut [f64]) -> ElementResult {
        load.refuse_moment(self.class().name)?;
        add_clamped_load::<3>(load, factor, &self.bending(), self.transform.length(), sums);
        Ok(())
    }
}
