//! Joint of beams and columns with bar slip and interface shear: `beamColumnJoint`.

use super::{
    Class, Element, ElementError, ElementInput, ElementOutput, ElementResult, ElementTraits, Histories, OpenSeesTraits,
    Snapshot,
};
use crate::element::roles::{ForceLabels, Roles};
use crate::material::{Material, MaterialError, Slot, Strain};
use crate::probe::Probe;
use nalgebra::{Matrix4, SMatrix, SVector, Vector4};

/// Springs: two of bar slip and one of interface shear at each node, and the shear panel.
pub const JOINT_SPRINGS: usize = 13;
/// Displacements of the nodes in the plane of the joint, two translations and a rotation each.
const OUTER: usize = 12;
/// Displacements of the edges of the panel.
const INNER: usize = 4;
/// Largest number of Newton iterations of one try.
const MAX_ITERATIONS: usize = 40;
/// Largest number of halvings of a correction.
const MAX_HALVINGS: usize = 8;
/// Numbers of parts in which a step is tried.
const PARTS: [usize; 4] = [1, 4, 32, 256];
/// Unbalance of the panel, as a part of its largest force, that counts as none.
const TOLERANCE: f64 = 1e-13;

type Outer = SVector<f64, OUTER>;
type Forces = [f64; JOINT_SPRINGS];

/// A state of equilibrium of the panel: displacements of its edges, forces and tangents of the springs.
#[derive(Clone, Copy)]
struct Balance {
    inner: Vector4<f64>,
    force: Forces,
    tangent: Forces,
}

/// A joint of four nodes at the middles of the edges of a panel: below, right, above, left (Lowes and Altoontash, Journal
/// of Structural Engineering 129 (2003) 1686; Mitra and Lowes, same journal 133 (2007) 105). Four displacements of the
/// edges are condensed by Newton's method.
///
/// State variables: the displacements of the edges, those of the nodes in the plane of the joint, then the materials'.
#[derive(Clone, Debug)]
pub struct BeamColumnJoint {
    springs: Vec<Slot>,
    state_len: usize,
    /// Displacements in the plane of the joint per global displacement, 12 x 24 by rows; empty in the plane.
    to_plane: Vec<f64>,
    outer: SMatrix<f64, JOINT_SPRINGS, OUTER>,
    inner: SMatrix<f64, JOINT_SPRINGS, INNER>,
    /// Height and width between the bars.
    arms: [f64; 2],
}

/// Geometry of a [`BeamColumnJoint`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JointGeometry {
    /// Distance of the nodes above and below.
    pub height: f64,
    /// Distance of the nodes left and right.
    pub width: f64,
    /// Distance of the bars of a beam, as a part of the height.
    pub height_factor: f64,
    /// Distance of the bars of a column, as a part of the width.
    pub width_factor: f64,
    /// Unit vectors to the right and up of a joint in space; `None` for one in the plane along the global axes.
    pub axes: Option<[[f64; 3]; 2]>,
}

impl BeamColumnJoint {
    /// Makes a joint of its materials: for the nodes from below against the clock bar slip left (below), bar slip right
    /// (above) and interface shear; then the panel.
    pub fn new(materials: [(Material, i32); JOINT_SPRINGS], geometry: &JointGeometry) -> Self {
        let (springs, state_len) = Slot::pack(materials, INNER + OUTER);
        let (outer, inner) = deformations(geometry);
        let arms = [geometry.height_factor * geometry.height, geometry.width_factor * geometry.width];
        let to_plane = geometry.axes.as_ref().map_or(vec![], plane_of);
        Self { springs, state_len, to_plane, outer, inner, arms }
    }

    fn plane_displacements(&self, disp: &[f64]) -> Outer {
        if self.to_plane.is_empty() {
            return Outer::from_iterator(disp.iter().copied());
        }
        Outer::from_iterator(self.to_plane.chunks_exact(disp.len()).map(|row| super::dot(row, disp)))
    }

    /// Forces and tangents of the springs, and the unbalance of the panel, at trial displacements.
    fn evaluate(
        &self,
        (outer, inner): (&Outer, &Vector4<f64>),
        dt: f64,
        h: &mut Histories<'_>,
    ) -> Result<(Forces, Forces, Vector4<f64>), MaterialError> {
        let strain = self.outer * outer + self.inner * inner;
        let (mut force, mut tangent) = ([0.0; JOINT_SPRINGS], [0.0; JOINT_SPRINGS]);
        for (i, spring) in self.springs.iter().enumerate() {
            let s = spring.update(h.committed, Strain { value: strain[i], rate: 0.0, dt }, h.trial)?;
            (force[i], tangent[i]) = (s.value, s.tangent);
        }
        let unbalance = self.inner.transpose() * SVector::from(force);
        Ok((force, tangent, unbalance))
    }

    fn inner_stiffness(&self, tangent: &Forces) -> Matrix4<f64> {
        let scaled = SMatrix::<f64, JOINT_SPRINGS, INNER>::from_fn(|i, j| tangent[i] * self.inner[(i, j)]);
        self.inner.transpose() * scaled
    }

    /// Equilibrium with displacements of the nodes; `None` if Newton's method does not converge.
    fn solve(
        &self,
        outer: &Outer,
        start: &Vector4<f64>,
        dt: f64,
        h: &mut Histories<'_>,
    ) -> Result<Option<Balance>, MaterialError> {
        let mut inner = *start;
        let (mut force, mut tangent, mut unbalance) = self.evaluate((outer, &inner), dt, h)?;
        for _ in 0..MAX_ITERATIONS {
            let size = self.largest(&force);
            let step = self.inner_stiffness(&tangent).lu().solve(&-unbalance);
            let Some(step) = step.filter(|s| s.iter().all(|x| x.is_finite())) else { return Ok(None) };
            let round_off = f64::EPSILON * inner.amax().max(outer.amax());
            if unbalance.amax() <= TOLERANCE * size || step.amax() <= round_off {
                return Ok(Some(Balance { inner, force, tangent }));
            }
            let before = unbalance.norm();
            let mut part = 1.0;
            for halving in 0..=MAX_HALVINGS {
                let next = inner + part * step;
                (force, tangent, unbalance) = self.evaluate((outer, &next), dt, h)?;
                if unbalance.norm() < before || halving == MAX_HALVINGS {
                    inner = next;
                    break;
                }
                part *= 0.5;
            }
        }
        Ok(None)
    }

    /// Largest force of a spring on the panel.
    fn largest(&self, force: &Forces) -> f64 {
        let on_panel = |(i, f): (usize, &f64)| f.abs() * self.inner.row(i).amax();
        force.iter().enumerate().map(on_panel).fold(0.0, f64::max)
    }

    /// The same in one part or in several, from the committed state.
    fn condense(&self, outer: &Outer, dt: f64, h: &mut Histories<'_>) -> ElementResult<Balance> {
        let start = Vector4::from_column_slice(&h.committed[..INNER]);
        let before = Outer::from_column_slice(&h.committed[INNER..INNER + OUTER]);
        'parts: for parts in PARTS {
            let mut at = start;
            for k in 1..parts {
                let share = k as f64 / parts as f64;
                match self.solve(&(before + share * (outer - before)), &at, dt, h)? {
                    Some(found) => at = found.inner,
                    None => continue 'parts,
                }
            }
            if let Some(found) = self.solve(outer, &at, dt, h)? {
                return Ok(found);
            }
        }
        Err(ElementError("its panel finds no equilibrium in this step".into()))
    }

    /// Tangent of the nodes for tangents of the springs, added to a matrix n x n by rows.
    fn add_tangent(&self, tangent: &Forces, out: &mut [f64]) -> ElementResult {
        let by_outer = SMatrix::<f64, JOINT_SPRINGS, OUTER>::from_fn(|i, j| tangent[i] * self.outer[(i, j)]);
        let mixed = self.inner.transpose() * by_outer;
        let Some(follows) = self.inner_stiffness(tangent).lu().solve(&mixed) else {
            return Err(ElementError("its panel has no stiffness".into()));
        };
        let condensed = self.outer.transpose() * by_outer - mixed.transpose() * follows;
        let n = self.dofs();
        if self.to_plane.is_empty() {
            for (row, out) in condensed.row_iter().zip(out.chunks_exact_mut(n)) {
                out.iter_mut().zip(row.iter()).for_each(|(o, k)| *o += k);
            }
            return Ok(());
        }
        for (a, row_a) in self.to_plane.chunks_exact(n).enumerate() {
            for (b, row_b) in self.to_plane.chunks_exact(n).enumerate() {
                for (out, ta) in out.chunks_exact_mut(n).zip(row_a).filter(|(_, t)| **t != 0.0) {
                    out.iter_mut().zip(row_b).for_each(|(o, tb)| *o += ta * condensed[(a, b)] * tb);
                }
            }
        }
        Ok(())
    }

    /// Shares of bar slip, interface shear and panel in the shear deformation of the joint, and their sum.
    fn shear_deformation(&self, state: &[f64]) -> [f64; 4] {
        let d: Vec<f64> = self.springs.iter().map(|s| s.strain(state)).collect();
        let [height, width] = self.arms;
        let slip =
            ((d[0] - d[1]).abs() + (d[7] - d[6]).abs()) / width + ((d[4] - d[3]).abs() + (d[10] - d[9]).abs()) / height;
        let shear = (d[2] + d[8]) / height + (d[5] + d[11]) / width;
        [slip, shear, d[12], slip + shear + d[12]]
    }
}

/// Deformations of the springs per displacement of the nodes and of the edges.
fn deformations(g: &JointGeometry) -> (SMatrix<f64, JOINT_SPRINGS, OUTER>, SMatrix<f64, JOINT_SPRINGS, INNER>) {
    let (mut outer, mut inner) = (SMatrix::zeros(), SMatrix::zeros());
    let [height, width] = [0.5 * g.height_factor * g.height, 0.5 * g.width_factor * g.width];
    for (node, sign) in [(0, -1.0), (1, 1.0), (2, 1.0), (3, -1.0)] {
        // Below and above the bars are vertical, and slip along y; at the sides they slip along x.
        let (upright, first) = (node % 2 == 0, 3 * node);
        let (along, across) = if upright { (first + 1, first) } else { (first, first + 1) };
        let (arm, factor) = if upright { (width, g.width_factor) } else { (height, g.height_factor) };
        // Edges that move along the bars: left and right sides, or lower and upper edge.
        let edges = if upright { [3, 1] } else { [0, 2] };
        for (side, lever) in [(0, -1.0), (1, 1.0)] {
            let spring = first + side;
            outer[(spring, along)] = sign;
            outer[(spring, first + 2)] = sign * arm * if upright { lever } else { -lever };
            inner[(spring, edges[side])] = -sign * 0.5 * (1.0 + factor);
            inner[(spring, edges[1 - side])] = -sign * 0.5 * (1.0 - factor);
        }
        let shear = first + 2;
        outer[(shear, across)] = 1.0;
        inner[(shear, node)] = -1.0;
    }
    for (edge, value) in [(0, -1.0 / g.height), (1, 1.0 / g.width), (2, 1.0 / g.height), (3, -1.0 / g.width)] {
        inner[(JOINT_SPRINGS - 1, edge)] = value;
    }
    (outer, inner)
}

/// Displacements in the plane of two axes per global displacement of four nodes in space, 12 x 24 by rows.
fn plane_of([right, up]: &[[f64; 3]; 2]) -> Vec<f64> {
    let (x, y) = (nalgebra::Vector3::from(*right), nalgebra::Vector3::from(*up));
    let normal = x.cross(&y);
    let mut out = vec![0.0; OUTER * 24];
    for node in 0..4 {
        let mut row = |i: usize, at: usize, axis: &[f64]| {
            let from = (3 * node + i) * 24 + 6 * node + at;
            out[from..from + 3].copy_from_slice(axis);
        };
        row(0, 0, right);
        row(1, 0, up);
        row(2, 3, normal.as_slice());
    }
    out
}

crate::watches_columns!(BeamColumnJoint => |s| in &s.springs);

impl Element for BeamColumnJoint {
    fn class(&self) -> Class {
        if self.to_plane.is_empty() { Class::new("BeamColumnJoint2d", 71) } else { Class::new("BeamColumnJoint3d", 72) }
    }
    fn dofs(&self) -> usize {
        if self.to_plane.is_empty() { OUTER } else { 2 * OUTER }
    }
    fn state_len(&self) -> usize {
        self.state_len
    }
    fn init(&self, state: &mut [f64]) {
        state[..INNER + OUTER].fill(0.0);
        self.springs.iter().for_each(|s| s.init(state));
    }
    fn traits(&self) -> ElementTraits {
        ElementTraits { linear: false, viscous: false, ..ElementTraits::of(self.springs.iter()) }
    }

    fn respond(&self, motion: &ElementInput<'_>, h: &mut Histories<'_>, output: ElementOutput<'_>) -> ElementResult {
        let outer = self.plane_displacements(motion.disp);
        let Balance { inner, force, tangent } = self.condense(&outer, motion.dt, h)?;
        h.trial[..INNER].copy_from_slice(inner.as_slice());
        h.trial[INNER..INNER + OUTER].copy_from_slice(outer.as_slice());
        let nodes = self.outer.transpose() * SVector::from(force);
        if self.to_plane.is_empty() {
            output.force.iter_mut().zip(nodes.iter()).for_each(|(o, f)| *o += f);
        } else {
            for (row, f) in self.to_plane.chunks_exact(motion.disp.len()).zip(nodes.iter()) {
                output.force.iter_mut().zip(row).for_each(|(o, t)| *o += t * f);
            }
        }
        match output.tangent {
            Some(k) => self.add_tangent(&tangent, k),
            None => Ok(()),
        }
    }

    fn initial_tangent(&self, tangent: &mut [f64]) {
        let mut springs = [0.0; JOINT_SPRINGS];
        springs.iter_mut().zip(&self.springs).for_each(|(k, s)| *k = s.material.initial_tangent());
        // A panel without stiffness is refused in the first step.
        let _ = self.add_tangent(&springs, tangent);
    }

    fn roles(&self) -> Roles<'_> {
        Roles {
            opensees: OpenSeesTraits { initial_is_current: true, stiffness_as_mass: true, ..OpenSeesTraits::default() },
            force_labels: ForceLabels::NodeAndDirection(4),
            ..Roles::default()
        }
    }

    fn probe(&self, words: &[&str]) -> Option<Probe> {
        let (name, rest) = words.split_first()?;
        let lower = name.to_lowercase();
        if let Some(i) = SPRING_NAMES.iter().position(|n| n.to_lowercase() == lower) {
            return Some(self.springs[i].probe(rest)?.inside(&[SPRING, i as u32]));
        }
        let numbered = |stem: &str, n: usize| (1..=n).map(|i| format!("{stem}{i}")).collect::<Vec<_>>();
        Some(match lower.as_str() {
            "externaldisplacement" => Probe::new(EXTERNAL, numbered("u", self.dofs())),
            "internaldisplacement" => Probe::new(INTERNAL, numbered("v", INNER)),
            "deformation" => Probe::new(DEFORMATION, ["barSlip", "interfaceShear", "panelShear", "total"]),
            _ => return None,
        })
    }

    fn probe_names(&self) -> Vec<&'static str> {
        SPRING_AND_OTHER_NAMES.to_vec()
    }

    fn read(&self, path: &[u32], s: &Snapshot<'_>, out: &mut [f64]) {
        match *path {
            [EXTERNAL] => out.copy_from_slice(s.disp),
            [INTERNAL] => out.copy_from_slice(&s.state[..INNER]),
            [DEFORMATION] => out.copy_from_slice(&self.shear_deformation(s.state)),
            [SPRING, i, ref rest @ ..] => self.springs[i as usize].read(rest, s.state, out),
            _ => {}
        }
    }
}

const EXTERNAL: u32 = 1;
const INTERNAL: u32 = 2;
const DEFORMATION: u32 = 3;
const SPRING: u32 = 4;

const SPRING_NAMES: [&str; JOINT_SPRINGS] = [
    "node1BarSlipL",
    "node1BarSlipR",
    "node1InterfaceShear",
    "node2BarSlipB",
    "node2BarSlipT",
    "node2InterfaceShear",
    "node3BarSlipL",
    "node3BarSlipR",
    "node3InterfaceShear",
    "node4BarSlipB",
    "node4BarSlipT",
    "node4InterfaceShear",
    "shearPanel",
];

const SPRING_AND_OTHER_NAMES: [&str; JOINT_SPRINGS + 3] = {
    let mut names = ["externalDisplacement"; JOINT_SPRINGS + 3];
    let mut i = 0;
    while i < JOINT_SPRINGS {
        names[i] = SPRING_NAMES[i];
        i += 1;
    }
    names[JOINT_SPRINGS] = "internalDisplacement";
    names[JOINT_SPRINGS + 1] = "deformation";
    names
};
