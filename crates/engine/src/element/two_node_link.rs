//! Springs between two nodes at a distance: `twoNodeLink`.

use super::springs::Springs;
use super::{
    BasicRow, Class, Element, ElementError, ElementInput, ElementOutput, ElementResult, ElementTraits, Histories,
    LockstepElement, Mass, Snapshot, alike, dot, one_by_one,
};
use crate::element::roles::{BasicDeformations, ElementParameters, ForceLabels, Inertia, Roles};
use crate::material::{Material, Slot};
use crate::numeric::wide::WIDTH;
use crate::parameter::{Changed, NewValue};
use crate::probe::Probe;
use nalgebra::Matrix3;
use std::sync::Arc;

/// Uniaxial springs between two nodes, along or about local axes. The shear springs act at a given position along the
/// line. The axial force has optional P-Delta effects (Schellenberg, 2008).
#[derive(Clone, Debug)]
pub struct TwoNodeLink {
    springs: Springs,
    ndm: usize,
    per_node: usize,
    /// Transformation from global to local displacements, n x n by rows.
    local: Vec<f64>,
    /// Global forces per unit of axial force and displacement, n x n by rows; empty without P-Delta.
    p_delta: Vec<f64>,
    mass: f64,
    rayleigh: bool,
}

/// Properties of a [`TwoNodeLink`] besides its springs.
#[derive(Clone, Debug)]
pub struct LinkOptions {
    /// Shares of the P-Delta moments that act as end moments: about y at i and j, about z at i and j. The rest acts as
    /// a couple of shear forces. `None` without P-Delta.
    pub p_delta: Option<[f64; 4]>,
    /// Position of the shear springs along y and z, as a fraction of the length from node i.
    pub shear_dist: [f64; 2],
    /// Mass, half at each end.
    pub mass: f64,
    /// Rayleigh damping of the model applies.
    pub rayleigh: bool,
}

impl TwoNodeLink {
    /// Makes a link of springs (material, tag, direction from 1). Its two nodes are at a distance `length` and have
    /// `per_node` degrees of freedom in `ndm` dimensions; `axes` has the local axes as rows. Directions are the degrees
    /// of freedom of a node: 3 is the rotation in the plane, and along z in space.
    ///
    /// # Errors
    /// A direction without a degree of freedom; P-Delta shear forces at zero length.
    pub fn new(
        springs: Vec<(Material, i32, usize)>,
        (ndm, per_node): (usize, usize),
        axes: Matrix3<f64>,
        length: f64,
        options: &LinkOptions,
    ) -> ElementResult<Self> {
        let local = local_axes(&axes, ndm, per_node);
        let mut made = Springs::new(axes);
        for (material, tag, direction) in springs {
            if direction == 0 || direction > per_node {
                let message = format!("twoNodeLink: direction {direction} at nodes with {per_node} degrees of freedom");
                return Err(ElementError(message.into()));
            }
            let row = basic_row(direction - 1, per_node, ndm, length, options.shear_dist);
            made.add((material, tag), direction, (pull_back(&row, &local), 0.0), None);
        }
        let p_delta = match options.p_delta {
            None => vec![],
            Some(ratios) => {
                global_matrix(&p_delta_forces(&made.directions(), ratios, (ndm, per_node), length)?, &local)
            }
        };
        let LinkOptions { mass, rayleigh, .. } = *options;
        Ok(Self { springs: made, ndm, per_node, local, p_delta, mass, rayleigh })
    }

    fn add_p_delta(&self, axial: f64, disp: &[f64], force: &mut [f64]) {
        for (f, row) in force.iter_mut().zip(self.p_delta.chunks_exact(disp.len())) {
            *f += axial * dot(row, disp);
        }
    }

    fn to_local(&self, global: &[f64], out: &mut [f64]) {
        for (o, row) in out.iter_mut().zip(self.local.chunks_exact(global.len())) {
            *o = dot(row, global);
        }
    }
}

/// Transformation of both nodes' displacements from global to local axes, by rows.
pub(super) fn local_axes(axes: &Matrix3<f64>, ndm: usize, per_node: usize) -> Vec<f64> {
    let n = 2 * per_node;
    let mut local = vec![0.0; n * n];
    for node in [0, per_node] {
        for a in 0..per_node {
            for b in 0..per_node {
                // The first `ndm` are translations; in the plane the rotation is about z.
                let part = match (a / ndm, b / ndm) {
                    (0, 0) => axes[(a, b)],
                    (1, 1) if ndm == 2 => axes[(2, 2)],
                    (1, 1) => axes[(a - 3, b - 3)],
                    _ => 0.0,
                };
                local[(node + a) * n + node + b] = part;
            }
        }
    }
    local
}

/// Row of a spring's deformation for local displacements. A shear spring includes the end rotations times their
/// distances to it.
fn basic_row(direction: usize, per_node: usize, ndm: usize, length: f64, shear_dist: [f64; 2]) -> Vec<f64> {
    let mut row = vec![0.0; 2 * per_node];
    row[direction] = -1.0;
    row[direction + per_node] = 1.0;
    let (rotation, sign, dist) = match (ndm, per_node, direction) {
        (2, 3, 1) => (2, -1.0, shear_dist[0]),
        (3, 6, 1) => (5, -1.0, shear_dist[0]),
        (3, 6, 2) => (4, 1.0, shear_dist[1]),
        _ => return row,
    };
    row[rotation] = sign * dist * length;
    row[rotation + per_node] = sign * (1.0 - dist) * length;
    row
}

/// Local P-Delta forces per unit of axial force and local displacement, by rows. Only directions with a spring transfer
/// forces.
pub(super) fn p_delta_forces(
    directions: &[usize],
    ratios: [f64; 4],
    (ndm, per_node): (usize, usize),
    length: f64,
) -> ElementResult<Vec<f64>> {
    let n = 2 * per_node;
    let mut g = vec![0.0; n * n];
    let has = |d: usize| directions.contains(&(d + 1));
    // Shear direction, rotation of the moments (if the nodes have it), sign of the moment, shares at i and j.
    let mut planes = vec![];
    if ndm > 1 && has(1) {
        let rotation = if ndm == 2 { 2 } else { 5 };
        planes.push((1, rotation, 1.0, [ratios[2], ratios[3]]));
    }
    if ndm == 3 && has(2) {
        planes.push((2, 4, -1.0, [ratios[0], ratios[1]]));
    }
    for (shear, rotation, sign, shares) in planes {
        let (i, j) = (shear, shear + per_node);
        let rest = 1.0 - shares[0] - shares[1];
        if rest.abs() > 1e-12 {
            if length == 0.0 {
                let message = "P-Delta forces need a length, unless all of the moment goes to the ends";
                return Err(ElementError(message.into()));
            }
            for (row, s) in [(i, -1.0), (j, 1.0)] {
                g[row * n + j] += s * rest / length;
                g[row * n + i] -= s * rest / length;
            }
        }
        if rotation < per_node && has(rotation) {
            for (row, share) in [(rotation, shares[0]), (rotation + per_node, shares[1])] {
                g[row * n + j] += sign * share;
                g[row * n + i] -= sign * share;
            }
        }
    }
    Ok(g)
}

/// aᵀ T for a local row `a`.
pub(super) fn pull_back(a: &[f64], t: &[f64]) -> Vec<f64> {
    let n = a.len();
    let mut out = vec![0.0; n];
    for (a, row) in a.iter().zip(t.chunks_exact(n)) {
        out.iter_mut().zip(row).for_each(|(o, r)| *o += a * r);
    }
    out
}

/// Tᵀ g T.
pub(super) fn global_matrix(g: &[f64], t: &[f64]) -> Vec<f64> {
    let n = t.len().isqrt();
    let mut out = vec![0.0; n * n];
    for (g_row, t_row) in g.chunks_exact(n).zip(t.chunks_exact(n)) {
        let gt = pull_back(g_row, t);
        for (row, t) in out.chunks_exact_mut(n).zip(t_row) {
            row.iter_mut().zip(&gt).for_each(|(o, x)| *o += t * x);
        }
    }
    out
}

const LOCAL_FORCE: u32 = 100;
const LOCAL_DISP: u32 = 101;

crate::watches_columns!(TwoNodeLink => |s| in s.springs.slots());

/// The springs side by side where nothing else acts; else the elements one after the other.
fn lockstep(all: &[&Arc<dyn Element>; WIDTH]) -> Option<Box<dyn LockstepElement>> {
    let own = alike::<TwoNodeLink>(all)?;
    let springs_alone = own.iter().all(|link| link.p_delta.is_empty() && link.per_node == own[0].per_node);
    let springs = || Springs::side_by_side(&own.map(|link| &link.springs), 2 * own[0].per_node);
    springs_alone.then(springs).flatten().or_else(|| one_by_one::<TwoNodeLink>(all))
}

impl Element for TwoNodeLink {
    fn class(&self) -> Class {
        Class::new("TwoNodeLink", 86)
    }
    fn dofs(&self) -> usize {
        2 * self.per_node
    }
    fn state_len(&self) -> usize {
        self.springs.state_len()
    }
    fn init(&self, state: &mut [f64]) {
        self.springs.init(state);
    }
    fn traits(&self) -> ElementTraits {
        let traits = ElementTraits { rayleigh: self.rayleigh, ..self.springs.traits() };
        let p_delta = !self.p_delta.is_empty();
        ElementTraits { linear: traits.linear && !p_delta, symmetric: !p_delta, ..traits }
    }

    fn respond(&self, motion: &ElementInput<'_>, h: &mut Histories<'_>, mut out: ElementOutput<'_>) -> ElementResult {
        self.springs.respond(motion, h, &mut out)?;
        if !self.p_delta.is_empty() {
            let axial = self.springs.force_in(1, h.trial);
            self.add_p_delta(axial, motion.disp, out.force);
            // The derivative of the axial force is omitted: with Rayleigh damping from the tangent it would act as
            // damping.
            if let Some(k) = out.tangent {
                k.iter_mut().zip(&self.p_delta).for_each(|(k, g)| *k += axial * g);
            }
        }
        Ok(())
    }

    fn initial_tangent(&self, tangent: &mut [f64]) {
        self.springs.initial_tangent(tangent);
    }

    fn roles(&self) -> Roles<'_> {
        Roles {
            mass: Some(self),
            parameters: Some(self),
            basic_rows: Some(self),
            lockstep: Some(lockstep),
            force_labels: ForceLabels::Numbered,
            ..Roles::default()
        }
    }

    fn probe(&self, words: &[&str]) -> Option<Probe> {
        let numbered = |stem: &'static str| (1..=self.dofs()).map(move |i| format!("{stem}{i}"));
        match *words.first()? {
            "localForce" | "localForces" => Some(Probe::new(LOCAL_FORCE, numbered("p"))),
            "localDisplacement" | "localDisplacements" => Some(Probe::new(LOCAL_DISP, numbered("dl"))),
            _ => self.springs.probe(words, "q", "db"),
        }
    }

    fn probe_names(&self) -> Vec<&'static str> {
        vec![
            "localForce",
            "basicForce",
            "localDisplacement",
            "deformation",
            "basicDeformation",
            "defoANDforce",
            "material",
        ]
    }

    fn read(&self, path: &[u32], s: &Snapshot<'_>, out: &mut [f64]) {
        match path[0] {
            LOCAL_FORCE => self.to_local(s.force, out),
            LOCAL_DISP => self.to_local(s.disp, out),
            _ => self.springs.read(path, s, Slot::strain, out),
        }
    }
}

impl Inertia for TwoNodeLink {
    fn mass(&self) -> Mass {
        Mass::halved(self.mass, self.per_node, self.ndm)
    }
}

impl ElementParameters for TwoNodeLink {
    fn with_parameter(&self, words: &[&str], value: NewValue) -> Changed<Arc<dyn Element>> {
        let mut new = self.clone();
        let old = new.springs.set_parameter(words, value)?;
        Ok((Arc::new(new), old))
    }
}

impl BasicDeformations for TwoNodeLink {
    fn basic_rows(&self) -> Vec<BasicRow> {
        // In the plane the rotation is about z.
        let direction = |d| if self.ndm == 2 && d == 3 { 6 } else { d };
        self.springs.basic_rows(direction, (self.ndm, self.per_node))
    }
}
