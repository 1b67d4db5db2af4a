//! The element of the triple friction pendulum: vertical force, moments, responses.

use super::chain::{Chain, ChainState, rows, square};
use super::heated::{Heated, PARAMETER_NAMES, PARAMETERS, Step, ThermalState};
use super::rules::{Rules, Vertical};
use crate::element::bearing::elements::shear_bearing::{
    BASIC_FORCE, DEFORMATION, FRICTION, LOCAL_DISP, LOCAL_FORCE, MATERIAL, probe, with_materials,
};
use crate::element::friction::{Coefficient, Contact, Friction};
use crate::element::roles::{BasicDeformations, Bearing, ForceLabels, Roles};
use crate::element::{
    BasicRow, CallDependent, Class, Element, ElementInput, ElementOutput, ElementResult, ElementTraits, Histories,
    MatrixMask, OpenSeesTraits, SharedState, Snapshot,
};
use crate::material::{Material, Slot, Strain, Stress};
use crate::probe::Probe;
use crate::rules::Consistent;
use crate::state_struct;
use crate::state_struct::StateStruct;
use nalgebra::{Matrix2, Vector2};

/// Properties of a triple friction pendulum besides its chain and materials.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TripleSetting<R = Consistent> {
    /// Weight for the initial coefficients of friction.
    pub weight: f64,
    /// Vertical stiffness in tension.
    pub k_tension: f64,
    /// Normal force of the friction in uplift.
    pub least_normal: f64,
    /// Height of node j above node i.
    pub height: f64,
    /// Rules of the iterations, of tension, of the moments and of records.
    pub rules: R,
}

impl<R> TripleSetting<R> {
    /// The same properties with other rules.
    pub fn with<T>(self, rules: T) -> TripleSetting<T> {
        let Self { weight, k_tension, least_normal, height, .. } = self;
        TripleSetting { weight, k_tension, least_normal, height, rules }
    }
}

/// A triple friction pendulum between two nodes, with its axis along the global Z. The shear force of a chain of
/// sliding segments is proportional to the normal force. Uniaxial materials act in the vertical direction and for the
/// rotations about Z, X and Y.
#[derive(Clone, Debug)]
pub struct TriplePendulum<R = Consistent> {
    pub(super) chain: Chain,
    surfaces: Surfaces,
    pub(super) materials: [Slot; 4],
    pub(super) setting: TripleSetting<R>,
    state_len: usize,
}

/// Friction of the surfaces.
#[derive(Clone, Debug)]
enum Surfaces {
    /// Friction models of the segments.
    Models([Friction; 3]),
    /// Friction that depends on pressure, speed and temperature.
    Heated(Box<Heated>),
}

state_struct! {
    /// State variables besides those of chain and surfaces.
    pub struct Load {
        /// Normal force, positive in compression.
        normal: f64,
        /// Mean normal force of the step, for the friction.
        mean: f64,
        /// Speed of the surfaces for the coefficients of friction.
        speed: [f64; 3],
        /// Coefficients of friction at that speed.
        mu: [f64; 3],
        /// Shear stiffness, 2 x 2 by rows.
        across: [f64; 4],
        /// Tangents of the materials.
        along: [f64; 4],
    }
}

/// Degree of freedom of each material: vertical, about Z, X, Y.
const DIRECTIONS: [usize; 4] = [2, 5, 3, 4];
/// Global degree of freedom of each local one: the local x axis is the global Z.
const LOCAL: [usize; 6] = [2, 0, 1, 5, 3, 4];

/// Forces at node j, and their derivatives by the relative displacement.
struct Top {
    force: [f64; 6],
    by_apart: [[f64; 6]; 6],
    damping: [f64; 6],
}

impl<R: Rules> TriplePendulum<R> {
    /// Makes the bearing of its chain, the friction models of its segments, and its materials with tags: vertical,
    /// rotations about Z, X and Y.
    pub fn new(
        chain: Chain,
        frictions: [Friction; 3],
        materials: [(Material, i32); 4],
        setting: TripleSetting<R>,
    ) -> Self {
        Self::of(chain, Surfaces::Models(frictions), materials, setting)
    }

    /// Makes the bearing with frictional heating.
    pub fn heated(chain: Chain, heated: Heated, materials: [(Material, i32); 4], setting: TripleSetting<R>) -> Self {
        Self::of(chain, Surfaces::Heated(Box::new(heated)), materials, setting)
    }

    fn of(chain: Chain, surfaces: Surfaces, materials: [(Material, i32); 4], setting: TripleSetting<R>) -> Self {
        let mut state_len = HEAT + if matches!(surfaces, Surfaces::Heated(_)) { Heated::LEN } else { 0 };
        let materials = materials.map(|(m, tag)| {
            let slot = Slot::new(m, tag, state_len);
            state_len += slot.len();
            slot
        });
        Self { chain, surfaces, materials, setting, state_len }
    }

    fn virgin(&self) -> (ChainState, Load) {
        let weight = self.setting.weight;
        // OpenSees starts without friction; the coefficients grow to their values within the first step.
        let chain = self.chain.virgin();
        let mu = match &self.surfaces {
            Surfaces::Models(f) => [0, 1, 2].map(|i| coefficient(f, i, weight, 0.0).mu),
            Surfaces::Heated(heated) => heated.at_rest(),
        };
        let mut load = Load { normal: weight, mean: weight, mu, ..Load::default() };
        // OpenSees' state before the first step: in uplift.
        load.across = chain.whole.map(|k| self.setting.least_normal * k);
        load.along = self.materials.each_ref().map(|slot| slot.material.initial_tangent());
        (chain, load)
    }

    /// Vertical force, and normal force of the friction.
    fn vertical(&self, (apart, rate, dt): (f64, f64, f64), h: &mut Histories<'_>) -> ElementResult<(Stress, f64)> {
        let slot = &self.materials[0];
        let last = slot.strain(h.trial);
        let s = slot.update(h.committed, Strain { value: apart, rate, dt }, h.trial)?;
        if s.value < 0.0 {
            return Ok((s, -s.value));
        }
        let normal = self.setting.least_normal;
        let at = Vertical { apart, dt, last };
        Ok((self.setting.rules.lifted(self, at, s, h)?, normal))
    }

    fn top(&self, motion: &ElementInput<'_>, h: &mut Histories<'_>) -> ElementResult<Top> {
        let apart: [f64; 6] = std::array::from_fn(|i| motion.disp[6 + i] - motion.disp[i]);
        let rate: [f64; 6] = std::array::from_fn(|i| motion.vel[6 + i] - motion.vel[i]);
        let mut top = Top { force: [0.0; 6], by_apart: [[0.0; 6]; 6], damping: [0.0; 6] };
        let (v, normal) = self.vertical((apart[2], rate[2], motion.dt), h)?;
        let (c, last) = (ChainState::read(h.committed), ChainState::read(h.trial));
        let before = Load::read(&h.committed[ChainState::LEN..]);
        let mut load = Load { normal, mean: 0.5 * (before.normal + normal), ..Load::default() };
        let u = Vector2::new(apart[0], apart[1]);
        let t = match &self.surfaces {
            Surfaces::Models(f) => self.setting.rules.shear(self, (u, motion.dt), (&c, &last), &mut load, f)?,
            Surfaces::Heated(heated) => {
                let step = Step { time: motion.time, dt: motion.dt };
                self.setting.rules.heated_shear((self, heated), (u, step), (&before, &mut load), h)?
            }
        };
        let f = Vector2::from(t.state.f);
        t.state.write(h.trial);

        let shear = normal * f;
        let stiffness: Matrix2<f64> = normal * t.k;
        (load.across, load.along[0]) = (rows(&stiffness), v.tangent);
        let by_z = R::by_vertical(&v, &f, normal, &t.by_normal);
        for i in 0..2 {
            top.force[i] = shear[i];
            top.by_apart[i][..3].copy_from_slice(&[stiffness[(i, 0)], stiffness[(i, 1)], by_z[i]]);
        }
        top.force[2] = v.value;
        top.by_apart[2][2] = v.tangent;
        top.damping[2] = v.damping;
        for ((slot, d), k) in self.materials.iter().zip(DIRECTIONS).zip(&mut load.along).skip(1) {
            let s = slot.update(h.committed, Strain { value: apart[d], rate: rate[d], dt: motion.dt }, h.trial)?;
            (top.force[d], top.by_apart[d][d], top.damping[d]) = (s.value, s.tangent, s.damping);
            *k = s.tangent;
        }
        load.write(&mut h.trial[ChainState::LEN..]);
        Ok(top)
    }

    /// Moments with derivatives: shear force times height plus vertical force times displacement, half at each node.
    fn moments(&self, top: &Top, apart: &[f64; 3]) -> ([f64; 3], [[f64; 3]; 3]) {
        let [dx, dy, _] = *apart;
        let (q, h) = (&top.force, self.setting.height);
        let m = [-q[2] * dy + q[1] * h, q[2] * dx - q[0] * h, q[0] * dy - q[1] * dx];
        let k = &top.by_apart;
        let mut by = [[0.0; 3]; 3];
        for j in 0..3 {
            by[0][j] = -k[2][j] * dy + k[1][j] * h;
            by[1][j] = k[2][j] * dx - k[0][j] * h;
            by[2][j] = k[0][j] * dy - k[1][j] * dx;
        }
        by[0][1] -= q[2];
        by[1][0] += q[2];
        by[2][1] += q[0];
        by[2][0] -= q[1];
        (m, by)
    }
}

pub(super) fn coefficient(frictions: &[Friction; 3], i: usize, normal: f64, speed: f64) -> Coefficient {
    if normal > 0.0 { frictions[i].coefficient(normal, speed) } else { Coefficient::default() }
}

/// Adds an entry of a matrix by the relative displacement; `sign` is that of the force on node i.
fn add_apart(matrix: &mut [f64], row: usize, col: usize, value: f64, sign: f64) {
    for (r, f) in [(row, sign), (row + 6, 1.0)] {
        matrix[r * 12 + col] -= f * value;
        matrix[r * 12 + col + 6] += f * value;
    }
}

crate::watches_columns!([R: Rules] TriplePendulum<R> => |s| in &s.materials);

impl<R: Rules> Element for TriplePendulum<R> {
    fn class(&self) -> Class {
        match self.surfaces {
            Surfaces::Models(_) => Class::new("TripleFrictionPendulum", 132),
            Surfaces::Heated(_) => Class::new("TripleFrictionPendulumX", 258),
        }
    }
    fn dofs(&self) -> usize {
        12
    }
    fn state_len(&self) -> usize {
        self.state_len
    }
    fn init(&self, state: &mut [f64]) {
        let (chain, load) = self.virgin();
        chain.write(state);
        load.write(&mut state[ChainState::LEN..]);
        if let Surfaces::Heated(heated) = &self.surfaces {
            heated.init(&mut state[HEAT..]);
        }
        self.materials.iter().for_each(|m| m.init(state));
    }
    fn traits(&self) -> ElementTraits {
        ElementTraits {
            linear: false,
            symmetric: false,
            viscous: self.materials.iter().any(|m| m.material.is_viscous()),
            elapses: match &self.surfaces {
                Surfaces::Models(f) => f.iter().any(|f| f.depends_on_speed()),
                Surfaces::Heated(_) => true,
            } || self.materials.iter().any(|m| m.material.depends_on_time()),
            // The command has no option against Rayleigh damping.
            rayleigh: true,
        }
    }

    fn respond(&self, motion: &ElementInput<'_>, h: &mut Histories<'_>, output: ElementOutput<'_>) -> ElementResult {
        let top = self.top(motion, h)?;
        let apart = std::array::from_fn(|i| motion.disp[6 + i] - motion.disp[i]);
        let (m, by) = self.moments(&top, &apart);
        for (i, m) in m.iter().enumerate() {
            (output.force[i], output.force[6 + i]) = (-top.force[i], top.force[i]);
            output.force[3 + i] = R::MOMENT_AT_I * top.force[3 + i] + 0.5 * m;
            output.force[9 + i] = top.force[3 + i] + 0.5 * m;
        }
        if let Some(k) = output.tangent {
            for i in 0..6 {
                for j in 0..6 {
                    add_apart(k, i, j, top.by_apart[i][j], -1.0);
                }
            }
            for (i, row) in by.iter().enumerate().filter(|_| R::MOMENTS_IN_TANGENT) {
                for (j, x) in row.iter().enumerate() {
                    add_apart(k, 3 + i, j, 0.5 * x, 1.0);
                }
            }
        }
        if let Some(c) = output.damping {
            top.damping.iter().enumerate().for_each(|(i, x)| add_apart(c, i, i, *x, -1.0));
        }
        Ok(())
    }

    fn initial_tangent(&self, tangent: &mut [f64]) {
        let k = self.setting.weight * square(&self.virgin().0.whole, 0);
        for i in 0..2 {
            add_apart(tangent, i, i, k[(i, i)], -1.0);
        }
        for (slot, d) in self.materials.iter().zip(DIRECTIONS) {
            add_apart(tangent, d, d, slot.material.initial_tangent(), -1.0);
        }
    }

    fn roles(&self) -> Roles<'_> {
        Roles {
            bearing: Some(Bearing::Sliding),
            basic_rows: Some(self),
            opensees: OpenSeesTraits {
                calls: R::CALL_DEPENDENT.then_some(self as &dyn CallDependent),
                damps_in_forces_only: R::DAMPS_IN_FORCES_ONLY,
                ..OpenSeesTraits::default()
            },
            force_labels: ForceLabels::Frame,
            ..Roles::default()
        }
    }

    fn probe(&self, words: &[&str]) -> Option<Probe> {
        let number = |n: &str, limit: usize| n.parse::<usize>().ok().filter(|i| (1..=limit).contains(i)).map(|i| i - 1);
        let heated = matches!(self.surfaces, Surfaces::Heated(_));
        match words {
            ["material", n, rest @ ..] => {
                let i = number(n, 4)?;
                Some(self.materials[i].probe(rest)?.inside(&[MATERIAL, i as u32]))
            }
            ["param" | "Param" | "parameters" | "Parameters", ..] => {
                heated.then(|| Probe::new(HEATING, PARAMETER_NAMES))
            }
            ["frictionModel" | "frnMdl" | "frictionMdl" | "frnModel", n, rest @ ..] if !heated => {
                Some(Contact::probe(rest)?.inside(&[FRICTION, number(n, 3)? as u32]))
            }
            ["compDeformation" | "compDeformations" | "compDisplacement" | "compDisplacements", ..] => {
                Some(if heated {
                    Probe::new(SEGMENTS, HEATED_SEGMENTS)
                } else {
                    Probe::new(SEGMENTS, ["d1x", "d1y", "d3x", "d3y", "d5x", "d5y"])
                })
            }
            _ => probe::<2>(words).filter(|p| [LOCAL_FORCE, BASIC_FORCE, LOCAL_DISP, DEFORMATION].contains(&p.path[0])),
        }
    }

    fn probe_names(&self) -> Vec<&'static str> {
        match self.surfaces {
            Surfaces::Models(_) => NAMES[..8].to_vec(),
            Surfaces::Heated(_) => NAMES[1..].to_vec(),
        }
    }

    fn read(&self, path: &[u32], s: &Snapshot<'_>, out: &mut [f64]) {
        let local = |from: &[f64], out: &mut [f64]| {
            for (o, g) in out.chunks_exact_mut(6).zip(from.chunks_exact(6)) {
                o.iter_mut().zip(LOCAL).for_each(|(o, i)| *o = g[i]);
            }
        };
        let chain = ChainState::read(s.state);
        let load = Load::read(&s.state[ChainState::LEN..]);
        match path[0] {
            LOCAL_FORCE => local(s.force, out),
            BASIC_FORCE => local(&s.force[6..], out),
            LOCAL_DISP if !R::SHOWS_DISPLACEMENTS => out.fill(0.0),
            LOCAL_DISP => local(s.disp, out),
            DEFORMATION => {
                let apart: [f64; 6] = std::array::from_fn(|i| s.disp[6 + i] - s.disp[i]);
                local(&apart, out);
                if !R::SHOWS_DISPLACEMENTS {
                    out[3..].fill(0.0);
                }
            }
            SEGMENTS => match self.surfaces {
                Surfaces::Models(_) => out.copy_from_slice(&chain.d),
                Surfaces::Heated(_) => {
                    let w = ThermalState::read(&s.state[HEAT..]);
                    let words = w.slide.iter().chain(&w.speed);
                    out.iter_mut().zip(words).for_each(|(o, x)| *o = *x);
                }
            },
            HEATING => out.copy_from_slice(&s.state[HEAT + ThermalState::LEN - PARAMETERS..HEAT + ThermalState::LEN]),
            FRICTION => {
                let i = path[1] as usize;
                out[0] = Contact { normal: load.mean, speed: load.speed[i], mu: load.mu[i] }.value(path[2]);
            }
            _ => self.materials[path[1] as usize].read(&path[2..], s.state, out),
        }
    }
}

impl<R: Rules> BasicDeformations for TriplePendulum<R> {
    fn basic_rows(&self) -> Vec<BasicRow> {
        let apart = |dof: usize| {
            let mut row = [0.0; 12];
            (row[dof], row[6 + dof]) = (-1.0, 1.0);
            row
        };
        let rows = LOCAL.into_iter().enumerate().map(|(k, dof)| BasicRow::new(k + 1, k, &apart(dof), (3, 6)));
        let columns = DIRECTIONS.into_iter().filter_map(|d| LOCAL.iter().position(|dof| *dof == d));
        with_materials(rows.collect(), columns)
    }
}

/// OpenSees' friction starts from the speeds of the last call, its vertical material from its restored state.
impl<R: Rules> CallDependent for TriplePendulum<R> {
    fn last_tangent(&self, history: &[f64], _: &SharedState, tangent: &mut [f64], _: MatrixMask) {
        let load = Load::read(&history[ChainState::LEN..]);
        for (i, k) in load.across.iter().enumerate() {
            add_apart(tangent, i / 2, i % 2, *k, -1.0);
        }
        for (d, k) in DIRECTIONS.iter().zip(load.along) {
            add_apart(tangent, *d, *d, k, -1.0);
        }
    }
}

const SEGMENTS: u32 = 20;
const HEATING: u32 = 21;
/// Index of the state variables of the surfaces.
pub(super) const HEAT: usize = ChainState::LEN + Load::LEN;
const HEATED_SEGMENTS: [&str; 12] =
    ["d1x", "d3x", "d5x", "d1y", "d3y", "d5y", "v1x", "v3x", "v5x", "v1y", "v3y", "v5y"];
/// Responses: the first exists with friction models alone, the last with heating alone.
const NAMES: [&str; 9] = [
    "frictionModel",
    "localForce",
    "basicForce",
    "localDisplacement",
    "deformation",
    "basicDeformation",
    "compDisplacement",
    "material",
    "Parameters",
];
