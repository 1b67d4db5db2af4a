//! Elastic beams with small displacements, evaluated side by side by vector instructions.
//!
//! They are most of the elements of an isolated building, whose storeys stay elastic. Each force has the bits that the
//! element itself gives, but for P-Delta beams with member loads, whose terms are summed in another order.

// Loops over indices become vector instructions; closures would not be compiled for them.
#![allow(clippy::needless_range_loop)]

use super::state::State;
use crate::assembly::Plan;
use crate::element::SmallBeam;
use crate::model::Model;
use crate::numeric::lanes::{BLOCK, LANES, Lanes, in_lanes, in_turn};
use std::collections::HashSet;

/// Up to `W` beams of one number of degrees of freedom `N` and basic deformations `B`, the numbers of each side by side.
/// Places without a beam have those of the first.
#[derive(Debug)]
struct Block<const N: usize, const B: usize, const W: usize> {
    /// Number of beams.
    count: usize,
    dofs: [[u32; W]; N],
    /// Place of the forces of each beam among those of all elements.
    force: [usize; W],
    /// Place of its load variables.
    load: [usize; W],
    /// Displacements of the nodes when the beam was created.
    initial: [[f64; W]; N],
    /// Derivatives of the basic deformations by the displacements.
    basic: [[[f64; W]; N]; B],
    /// Basic stiffness.
    stiffness: [[[f64; W]; B]; B],
    /// P-Delta: derivatives of the displacements across the beam, and its length.
    across: Option<Across<N, W>>,
    /// Load variables count.
    loaded: bool,
}

/// Derivatives of the displacements across beams by those of the nodes, and the lengths.
type Across<const N: usize, const W: usize> = (Vec<[[f64; W]; N]>, [f64; W]);

/// A block as wide as its beams need: one that is mostly empty takes as long as a full one.
#[derive(Debug)]
enum Beams<const N: usize, const B: usize> {
    Whole(Box<Block<N, B, BLOCK>>),
    Half(Box<Block<N, B, LANES>>),
    Single(Box<Block<N, B, 1>>),
}

/// The tangent of a P-Delta beam.
#[derive(Debug)]
pub(super) struct PDeltaTangent {
    pub(super) element: usize,
    /// Place among those of all elements.
    at: usize,
    /// Stiffness without axial force.
    pub(super) stiffness: Vec<f64>,
    /// Geometric stiffness per unit of axial force.
    geometric: Vec<f64>,
    /// Its entries that are not zero: place in the matrix of the equations, and value.
    entries: Vec<(u32, f64)>,
}

impl PDeltaTangent {
    /// Adds the geometric stiffness of an axial force to the values of the system matrix.
    pub(super) fn add_geometric(&self, force: f64, values: &mut [f64]) {
        for &(to, g) in &self.entries {
            values[to as usize] += force * g;
        }
    }
}

/// Forces of the reactions to member loads.
#[derive(Debug)]
struct Reactions {
    force: usize,
    /// Place of the reactions among the load variables.
    load: usize,
    /// Forces of each reaction.
    rows: Vec<Vec<f64>>,
}

#[derive(Debug)]
struct Blocks<const N: usize, const B: usize> {
    blocks: Vec<Beams<N, B>>,
    /// Tangents of the P-Delta beams, block after block.
    tangents: Vec<PDeltaTangent>,
}

/// The elastic beams of a model with small displacements.
#[derive(Debug)]
pub(super) struct SmallBeams {
    plane: Blocks<6, 3>,
    space: Blocks<12, 6>,
    reactions: Vec<Reactions>,
    /// Elements that are none of them.
    pub(super) others: Vec<usize>,
    /// Number of beams.
    pub(super) count: u64,
}

/// A beam with its place in the model.
struct Member<'a> {
    beam: SmallBeam<'a>,
    dofs: &'a [u32],
    force: usize,
    load: usize,
    loaded: bool,
    element: usize,
    tangent: usize,
}

impl SmallBeams {
    /// The beams of a model; `tangent_of` gives the place of the tangent of an element.
    pub(super) fn new(model: &Model, plan: &Plan, tangent_of: impl Fn(usize) -> usize) -> Self {
        let loaded: HashSet<usize> =
            model.patterns.values().flat_map(|p| p.element_loads.iter().map(|(id, _)| id.0)).collect();
        let (mut others, mut reactions) = (vec![], vec![]);
        // Alike beams share a block: in the plane and in space, each with and without P-Delta and member loads.
        let mut kinds: [Vec<Member<'_>>; 8] = Default::default();
        for (i, e) in model.elements.iter().enumerate() {
            let Some(beam) = e.element.small_beam() else {
                others.push(i);
                continue;
            };
            let loaded = loaded.contains(&i);
            if loaded {
                let load = e.load.start + beam.basic.len() / e.dofs.len();
                let rows = beam.reactions.iter().map(|row| row.to_vec()).collect();
                reactions.push(Reactions { force: e.force.start, load, rows });
            }
            let kind =
                usize::from(e.dofs.len() == 12) * 4 + usize::from(beam.p_delta.is_some()) * 2 + usize::from(loaded);
            let (force, load, tangent) = (e.force.start, e.load.start, tangent_of(i));
            kinds[kind].push(Member { beam, dofs: &e.dofs, force, load, loaded, element: i, tangent });
        }
        let count = kinds.iter().map(Vec::len).sum::<usize>() as u64;
        let (plane, space) = kinds.split_at(4);
        Self { plane: Blocks::new(plane, plan), space: Blocks::new(space, plan), reactions, others, count }
    }

    /// Tangents of the P-Delta beams.
    pub(super) fn p_delta(&self) -> impl Iterator<Item = &PDeltaTangent> {
        self.plane.tangents.iter().chain(&self.space.tangents)
    }

    /// Forces of the beams for a trial motion; with the tangents of all elements and the axial forces of the P-Delta beams,
    /// if they are given, these too.
    pub(super) fn respond(&self, state: &mut State, mut tangents: Option<(&mut [f64], &mut [f64])>) {
        let plane = self.plane.tangents.len();
        self.plane.respond(state, tangents.as_mut().map(|(all, axial)| (&mut **all, &mut axial[..plane])));
        self.space.respond(state, tangents.map(|(all, axial)| (all, &mut axial[plane..])));
        for r in &self.reactions {
            let words = &state.element_load[r.load..r.load + r.rows.len()];
            for (row, p) in r.rows.iter().zip(words).filter(|(_, p)| **p != 0.0) {
                state.force[r.force..].iter_mut().zip(row).for_each(|(f, r)| *f += p * r);
            }
        }
    }
}

impl<const N: usize, const B: usize> Blocks<N, B> {
    fn new(kinds: &[Vec<Member<'_>>], plan: &Plan) -> Self {
        let blocks = kinds.iter().flat_map(|members| members.chunks(BLOCK).flat_map(Beams::of)).collect();
        let tangents = kinds.iter().flatten().filter_map(|m| {
            let p = m.beam.p_delta.as_ref()?;
            let entries = plan.entries(m.element).map(|(from, to, c)| (to, c * p.geometric[from as usize]));
            Some(PDeltaTangent {
                element: m.element,
                at: m.tangent,
                stiffness: p.stiffness.to_vec(),
                geometric: p.geometric.to_vec(),
                entries: entries.filter(|(_, g)| *g != 0.0).collect(),
            })
        });
        Self { blocks, tangents: tangents.collect() }
    }

    fn respond(&self, state: &mut State, tangents: Option<(&mut [f64], &mut [f64])>) {
        if !self.blocks.is_empty() {
            in_lanes(&mut Responding { blocks: self, state, tangents });
        }
    }
}

/// An evaluation by the widest vector instructions.
struct Responding<'a, const N: usize, const B: usize> {
    blocks: &'a Blocks<N, B>,
    state: &'a mut State,
    /// Tangents of all elements, and axial forces of the P-Delta beams.
    tangents: Option<(&'a mut [f64], &'a mut [f64])>,
}

impl<const N: usize, const B: usize> Lanes for Responding<'_, N, B> {
    #[inline(always)]
    fn evaluate(&mut self) {
        let mut next = 0;
        for beams in &self.blocks.blocks {
            let (count, mut axial) = (beams.count(), [0.0; BLOCK]);
            match beams {
                Beams::Whole(block) => axial = block.respond(self.state),
                Beams::Half(block) => axial[..LANES].copy_from_slice(&block.respond(self.state)),
                Beams::Single(block) => axial[..1].copy_from_slice(&block.respond(self.state)),
            }
            if !beams.is_p_delta() {
                continue;
            }
            let own = next..next + count;
            next = own.end;
            let Some((tangents, axial_forces)) = &mut self.tangents else { continue };
            axial_forces[own.clone()].copy_from_slice(&axial[..count]);
            for (t, axial) in self.blocks.tangents[own].iter().zip(axial) {
                let tangent = &mut tangents[t.at..t.at + N * N];
                for ((k, s), g) in tangent.iter_mut().zip(&t.stiffness).zip(&t.geometric) {
                    *k = s + axial * g;
                }
            }
        }
    }
}

impl<const N: usize, const B: usize> Beams<N, B> {
    /// Blocks for at most as many beams as a whole one has.
    fn of(members: &[Member<'_>]) -> Vec<Self> {
        match members.len() {
            0..=2 => members.chunks(1).map(|m| Self::Single(Box::new(Block::new(m)))).collect(),
            3..=LANES => vec![Self::Half(Box::new(Block::new(members)))],
            _ => vec![Self::Whole(Box::new(Block::new(members)))],
        }
    }

    #[inline(always)]
    fn count(&self) -> usize {
        match self {
            Self::Whole(block) => block.count,
            Self::Half(block) => block.count,
            Self::Single(_) => 1,
        }
    }

    #[inline(always)]
    fn is_p_delta(&self) -> bool {
        match self {
            Self::Whole(block) => block.across.is_some(),
            Self::Half(block) => block.across.is_some(),
            Self::Single(block) => block.across.is_some(),
        }
    }
}

impl<const N: usize, const B: usize, const W: usize> Block<N, B, W> {
    fn new(members: &[Member<'_>]) -> Self {
        let of = |i: usize| members.get(i).unwrap_or(&members[0]);
        let lane = |value: &dyn Fn(&Member<'_>) -> f64| std::array::from_fn(|i| value(of(i)));
        let first = of(0);
        let across = first.beam.p_delta.as_ref().map(|p| {
            let row = |r: usize, j: usize| lane(&|m| m.beam.p_delta.as_ref().map_or(0.0, |p| p.across[r][j]));
            let rows = (0..p.across.len()).map(|r| std::array::from_fn(|j| row(r, j))).collect();
            (rows, lane(&|m| m.beam.length))
        });
        Self {
            count: members.len(),
            dofs: std::array::from_fn(|j| std::array::from_fn(|i| of(i).dofs[j])),
            force: std::array::from_fn(|i| of(i).force),
            load: std::array::from_fn(|i| of(i).load),
            initial: std::array::from_fn(|j| lane(&|m| m.beam.initial[j])),
            basic: std::array::from_fn(|b| std::array::from_fn(|j| lane(&|m| m.beam.basic[b * N + j]))),
            stiffness: std::array::from_fn(|b| std::array::from_fn(|c| lane(&|m| m.beam.stiffness[b * B + c]))),
            across,
            loaded: first.loaded,
        }
    }

    /// Writes the forces; returns the axial forces.
    #[inline(always)]
    fn respond(&self, state: &mut State) -> [f64; W] {
        let mut u = [[0.0; W]; N];
        for j in 0..N {
            for i in 0..W {
                u[j][i] = state.disp[self.dofs[j][i] as usize];
            }
            for i in 0..W {
                u[j][i] -= self.initial[j][i];
            }
        }
        let mut v = [[0.0; W]; B];
        for b in 0..B {
            v[b] = in_turn(dot(&self.basic[b], &u));
        }
        let mut q = [[0.0; W]; B];
        for b in 0..B {
            for c in coupled(b) {
                for i in 0..W {
                    q[b][i] += self.stiffness[b][c][i] * v[c][i];
                }
            }
        }
        if self.loaded {
            for b in 0..B {
                for i in 0..W {
                    q[b][i] += state.element_load[self.load[i] + b];
                }
            }
        }
        let (mut shear, mut rows): ([[f64; W]; 2], &[[[f64; W]; N]]) = ([[0.0; W]; 2], &[]);
        if let Some((across, length)) = &self.across {
            rows = across;
            for (row, shear) in across.iter().zip(&mut shear) {
                let drift = dot(row, &u);
                for i in 0..W {
                    shear[i] = q[0][i] / length[i] * drift[i];
                }
            }
        }
        let mut f = [[0.0; W]; N];
        for j in 0..N {
            let mut sum = [0.0; W];
            for b in 0..B {
                for i in 0..W {
                    sum[i] += q[b][i] * self.basic[b][j][i];
                }
            }
            for (row, shear) in rows.iter().zip(&shear) {
                for i in 0..W {
                    sum[i] += shear[i] * row[j][i];
                }
            }
            f[j] = sum;
        }
        for i in 0..self.count {
            let Some(force) = state.force[self.force[i]..].first_chunk_mut::<N>() else { break };
            for j in 0..N {
                force[j] = f[j][i];
            }
        }
        q[0]
    }
}

/// Deformations that a basic force depends on: bending of one plane couples the ends of the beam.
#[inline(always)]
fn coupled(b: usize) -> std::ops::Range<usize> {
    match b {
        1 | 2 => 1..3,
        3 | 4 => 3..5,
        b => b..b + 1,
    }
}

/// Scalar products, summed in the order of [`crate::numeric::dot`].
#[inline(always)]
fn dot<const N: usize, const W: usize>(row: &[[f64; W]; N], u: &[[f64; W]; N]) -> [f64; W] {
    let mut sums = [[0.0; W]; 4];
    for j in 0..N / 4 * 4 {
        for i in 0..W {
            sums[j % 4][i] += row[j][i] * u[j][i];
        }
    }
    let mut rest = [0.0; W];
    for j in N / 4 * 4..N {
        for i in 0..W {
            rest[i] += row[j][i] * u[j][i];
        }
    }
    let mut sum = [0.0; W];
    for i in 0..W {
        sum[i] = (sums[0][i] + sums[1][i]) + (sums[2][i] + sums[3][i]) + rest[i];
    }
    sum
}
